//! Which edition of the book this is: at the foot of every page.

use crate::address::Address;
use crate::citing::{TITLE, VERSION};
use crate::html::escape;
use std::path::Path;
use std::process::Command;

/// The commit that a book is made from, and its date. A book that is not made from a repository has neither.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Edition {
    /// Seven digits of the commit's name.
    pub commit: Option<String>,
    /// The commit's date, as in 2026-11-26.
    pub date: Option<String>,
}

impl Edition {
    /// The edition of a book that is not made from a repository.
    pub const NONE: Self = Self { commit: None, date: None };

    /// The edition of the book in this folder. The reader's own settings of git do not change what it says.
    pub fn of(book: &Path) -> Self {
        let mut git = Command::new("git");
        git.args(["--no-pager", "-c", "core.abbrev=7", "-c", "log.showSignature=false", "-c", "color.ui=false", "-C"]);
        git.arg(book).args(["log", "-1", "--abbrev=7", "--no-show-signature", "--no-color", "--no-patch"]);
        let answered = git.arg("--format=%h %cs").output().ok().filter(|git| git.status.success());
        let words = answered.and_then(|git| String::from_utf8(git.stdout).ok()).unwrap_or_default();
        let (commit, date) = words.trim().split_once(' ').unzip();
        Self { commit: commit.map(str::to_owned), date: date.map(str::to_owned) }
    }

    /// Version, and commit with its date if there is one.
    pub fn words(&self) -> String {
        let mut words = format!("version {VERSION}");
        if let (Some(commit), Some(date)) = (&self.commit, &self.date) {
            words.push_str(&format!(", commit {commit} of {date}"));
        }
        words
    }

    /// The foot of every page.
    pub fn footer(&self, address: Option<&Address>) -> String {
        let read = address
            .map_or_else(String::new, |address| format!(" Read it at <a href=\"{0}\">{0}</a>.", escape(&address.book)));
        format!(
            "\n<footer class=\"edition\">{}, {}.{read} <a href=\"about.html\">Sources, data, how to cite</a>.</footer>\n",
            escape(TITLE),
            escape(&self.words())
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::io::Write;
    use std::process::Stdio;
    use tempfile::TempDir;

    /// Runs git with this input and gives its answer.
    fn git(repository: &Path, arguments: &[&str], input: &str) -> String {
        let mut git = Command::new("git");
        git.arg("-C").arg(repository).args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = git.spawn().expect("git runs");
        child.stdin.take().expect("a pipe").write_all(input.as_bytes()).expect("it reads");
        let output = child.wait_with_output().expect("it ends");
        assert!(output.status.success(), "{arguments:?}");
        String::from_utf8(output.stdout).expect("UTF-8").trim().to_owned()
    }

    #[test]
    fn the_commit_does_not_depend_on_the_settings_of_git() {
        if Command::new("git").arg("--version").output().is_err() {
            return; // Without git no page names a commit.
        }
        let repository = TempDir::new().unwrap();
        let folder = repository.path();
        git(folder, &["init", "--quiet"], "");
        assert_eq!(Edition::of(folder), Edition::default());

        // A commit with a signature, and a program that has something to say about it.
        let tree = git(folder, &["hash-object", "-t", "tree", "-w", "--stdin"], "");
        let who = "A <a@example.org> 1700000000 +0000";
        let text = format!(
            "tree {tree}\nauthor {who}\ncommitter {who}\ngpgsig -----BEGIN PGP SIGNATURE-----\n \n AAAA\n \
             -----END PGP SIGNATURE-----\n\nText\n"
        );
        let id = git(folder, &["hash-object", "-t", "commit", "-w", "--stdin"], &text);
        git(folder, &["update-ref", "HEAD", &id], "");
        let expected = Edition { commit: Some(id[..7].to_owned()), date: Some("2023-11-14".to_owned()) };
        assert_eq!(Edition::of(folder), expected);
        assert_eq!(expected.words(), format!("version {VERSION}, commit {} of 2023-11-14", &id[..7]));

        let checker = folder.join("checker");
        fs::write(&checker, "#!/bin/sh\necho 'no such key' >&2\nexit 1\n").unwrap();
        #[cfg(unix)]
        fs::set_permissions(&checker, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
        for (setting, value) in [
            ("core.abbrev", "12"),
            ("log.showSignature", "true"),
            ("gpg.program", &*checker.to_string_lossy()),
            ("color.ui", "always"),
            ("log.decorate", "full"),
            ("log.date", "raw"),
            ("format.pretty", "fuller"),
        ] {
            git(folder, &["config", setting, value], "");
            assert_eq!(Edition::of(folder), expected, "{setting} {value}");
        }
    }

    #[test]
    fn the_foot_of_a_page_names_an_address_only_if_there_is_one() {
        let address = Address::of("https://example.org/geneva/", "").expect("an address");
        let edition = Edition { commit: Some("abcdef0".to_owned()), date: Some("2026-11-26".to_owned()) };
        let (without, with) = (edition.footer(None), edition.footer(Some(&address)));
        assert!(with.contains(" Read it at <a href=\"https://example.org/geneva/\">https://example.org/geneva/</a>."));
        assert!(!without.contains("http") && !without.contains("Read it"), "{without}");
        for footer in [without, with] {
            assert!(footer.contains(&format!("version {VERSION}, commit abcdef0 of 2026-11-26.")), "{footer}");
        }
    }
}
