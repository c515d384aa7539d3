//! Which edition of the book this is: at the foot of every page.

use crate::html::escape;
use std::path::Path;
use std::process::Command;

/// Version, and commit with its date where the book is made from a repository.
pub fn footer(book: &Path) -> String {
    let commit = commit(book).map_or_else(String::new, |commit| format!(", {}", escape(&commit)));
    format!(
        "\n<footer class=\"edition\">Geneva, verified, version {}{commit}. <a href=\"about.html\">Sources, data, how to \
         cite</a>.</footer>\n",
        env!("CARGO_PKG_VERSION")
    )
}

/// The commit that the book is made from, and its date. The reader's own settings of git do not change what it says.
fn commit(book: &Path) -> Option<String> {
    let mut git = Command::new("git");
    git.args(["--no-pager", "-c", "core.abbrev=7", "-c", "log.showSignature=false", "-c", "color.ui=false", "-C"]);
    git.arg(book).args(["log", "-1", "--abbrev=7", "--no-show-signature", "--no-color", "--no-patch"]);
    let git = git.arg("--format=commit %h of %cs").output().ok()?;
    let said = String::from_utf8(git.stdout).ok()?;
    Some(said.trim().to_owned()).filter(|said| git.status.success() && !said.is_empty())
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
        assert_eq!(commit(folder), None);

        // A commit with a signature, and a program that has something to say about it.
        let tree = git(folder, &["hash-object", "-t", "tree", "-w", "--stdin"], "");
        let who = "A <a@example.org> 1700000000 +0000";
        let text = format!(
            "tree {tree}\nauthor {who}\ncommitter {who}\ngpgsig -----BEGIN PGP SIGNATURE-----\n \n AAAA\n \
             -----END PGP SIGNATURE-----\n\nText\n"
        );
        let id = git(folder, &["hash-object", "-t", "commit", "-w", "--stdin"], &text);
        git(folder, &["update-ref", "HEAD", &id], "");
        let expected = Some(format!("commit {} of 2023-11-14", &id[..7]));
        assert_eq!(commit(folder), expected);

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
            assert_eq!(commit(folder), expected, "{setting} {value}");
        }
    }
}
