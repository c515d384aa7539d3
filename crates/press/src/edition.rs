//! Which edition of the book this is: at the foot of every page, in the data and where the book is cited.

use crate::imprint::Imprint;
use geneva_host::git::Repository;
use std::path::Path;

/// What stands for an edition in what every edition has: no author writes this sign, to which Unicode gives no meaning.
pub(crate) const SIGN: &str = "\u{f8ff}";

/// The version of a book and the commit that it is made from, with its date, and whether the sources are as the commit has
/// them. A book that is not made from a repository of its own has no commit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edition {
    /// The version of the project.
    pub version: &'static str,
    /// The commit's whole name, in hexadecimal digits.
    pub commit: Option<String>,
    /// The commit's date, as in 2026-11-26.
    pub date: Option<String>,
    /// Whether the book is made from something else: a file of the project that is not as the commit has it, or not in it,
    /// or a program that was compiled from another commit.
    pub is_changed: bool,
}

impl Edition {
    /// The edition of a book that is not made from a repository.
    pub const fn without_commit(version: &'static str) -> Self {
        Self { version, commit: None, date: None, is_changed: false }
    }

    /// The edition of the book in this folder. The reader's own settings of git do not change what it says.
    pub fn detect(book: &Path, imprint: &Imprint) -> Self {
        let edition = Self::committed(book, imprint.version);
        edition.unwrap_or(Self::without_commit(imprint.version)).made_by(&Self::compiled(imprint))
    }

    /// The edition that this program was compiled from. Without a commit, none was recorded when it was compiled.
    pub fn compiled(imprint: &Imprint) -> Self {
        let (commit, date) = imprint.compiled_from.and_then(|said| said.trim().split_once(' ')).unzip();
        let [commit, date] = [commit, date].map(|of| of.map(str::to_owned));
        Self { commit, date, ..Self::without_commit(imprint.version) }
    }

    /// The edition of a book that a program of this edition makes: the verdicts come from the program.
    fn made_by(mut self, program: &Self) -> Self {
        self.is_changed |= self.commit.is_some() && program.commit.is_some() && program.commit != self.commit;
        self
    }

    /// The edition that a repository has, if the settings of the book are among its files. They are not where the project
    /// was unpacked inside the repository of another one.
    fn committed(book: &Path, version: &'static str) -> Option<Self> {
        let repository = Repository::containing(book)?;
        let settings = std::fs::canonicalize(book).ok()?.join("book.toml");
        let settings = settings.strip_prefix(repository.top()).ok()?;
        repository.ask([Path::new("ls-files"), Path::new("--error-unmatch"), Path::new("--"), settings]).ok()?;
        let said = repository.ask(["log", "-1", "--no-show-signature", "--no-patch", "--format=%H %cs"]).ok()?;
        let said = String::from_utf8(said).ok()?;
        let (commit, date) = said.trim().split_once(' ')?;
        let project = settings.parent()?.parent().filter(|folder| !folder.as_os_str().is_empty());
        let status = ["status", "--porcelain", "--no-renames", "--untracked-files=normal", "--"].map(Path::new);
        // A file that git doesn't know can be part of a book as well, and git that gives no answer clears nobody.
        let changes = repository.ask(status.into_iter().chain([project.unwrap_or(Path::new("."))]));
        let is_changed = changes.map_or(true, |changes| !changes.is_empty());
        Some(Self { version, commit: Some(commit.to_owned()), date: Some(date.to_owned()), is_changed })
    }

    /// Version, and commit with its date if there is one.
    pub fn words(&self) -> String {
        let commit = self.commit_in_words().map_or_else(String::new, |commit| format!(", {commit}"));
        format!("version {}{commit}", self.version)
    }

    /// Commit and date, and whether the sources are as it has them.
    pub fn commit_in_words(&self) -> Option<String> {
        let (commit, date) = (self.short_commit()?, self.date.as_deref()?);
        Some(format!("{commit} of {date}{}", self.mark()))
    }

    /// The commit by seven digits, behind its noun.
    fn short_commit(&self) -> Option<String> {
        let commit = self.commit.as_deref()?;
        Some(format!("commit {}", commit.get(..7).unwrap_or(commit)))
    }

    /// What follows the commit in words if the sources are no longer as it has them.
    fn mark(&self) -> &'static str {
        if self.is_changed { ", changed" } else { "" }
    }

    /// Version and commit for a reference.
    pub fn reference(&self) -> String {
        let commit = self.short_commit().map_or_else(String::new, |commit| format!(", {commit}{}", self.mark()));
        format!("Version {}{commit}", self.version)
    }

    /// The name of the sources at Software Heritage, the archive of source code, which follows from the commit. Sources
    /// that were changed since have none.
    pub fn swhid(&self) -> Option<String> {
        let commit = self.commit.as_deref().filter(|commit| !self.is_changed && commit.len() == 40)?;
        Some(format!("swh:1:rev:{commit}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::IMPRINT;
    use std::fs;
    use std::io::Write;
    use std::process::{Command, Stdio};
    use tempfile::TempDir;

    const NONE: Edition = Edition::without_commit(IMPRINT.version);

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

    /// A repository with a project in a folder of it, committed on 14 November 2023; none without git.
    fn committed(project: &str) -> Option<(TempDir, String)> {
        Command::new("git").arg("--version").output().ok()?;
        let repository = TempDir::new().unwrap();
        let folder = repository.path();
        git(folder, &["init", "--quiet"], "");
        let book = folder.join(project).join("book");
        fs::create_dir_all(book.join("src")).unwrap();
        fs::write(book.join("book.toml"), "").unwrap();
        fs::write(book.join("src/only.md"), "Text.\n").unwrap();
        fs::write(folder.join(".gitignore"), "target\n").unwrap();
        assert_eq!(Edition::detect(&book, &IMPRINT), NONE, "no commit yet");
        git(folder, &["add", "."], "");
        assert_eq!(Edition::detect(&book, &IMPRINT), NONE, "no commit yet");
        // A commit with a signature, for a program that has something to say about it.
        let tree = git(folder, &["write-tree"], "");
        let who = "A <a@example.org> 1700000000 +0000";
        let text = format!(
            "tree {tree}\nauthor {who}\ncommitter {who}\ngpgsig -----BEGIN PGP SIGNATURE-----\n \n AAAA\n \
             -----END PGP SIGNATURE-----\n\nText\n"
        );
        let id = git(folder, &["hash-object", "-t", "commit", "-w", "--stdin"], &text);
        git(folder, &["update-ref", "HEAD", &id], "");
        Some((repository, id))
    }

    #[test]
    fn the_commit_does_not_depend_on_the_settings_of_git() {
        let Some((repository, id)) = committed("") else { return }; // Without git no page names a commit.
        let (folder, book) = (repository.path(), repository.path().join("book"));
        let date = Some("2023-11-14".to_owned());
        let expected = Edition { commit: Some(id.clone()), date, ..NONE };
        assert_eq!(Edition::detect(&book, &IMPRINT), expected);
        assert_eq!(expected.words(), format!("version {}, commit {} of 2023-11-14", IMPRINT.version, &id[..7]));

        let checker = repository.path().join("target");
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
            ("status.branch", "true"),
            ("status.short", "true"),
        ] {
            git(folder, &["config", setting, value], "");
            assert_eq!(Edition::detect(&book, &IMPRINT), expected, "{setting} {value}");
        }
        git(folder, &["config", "status.showUntrackedFiles", "no"], "");
        fs::write(book.join("src/new.md"), "").unwrap();
        assert!(Edition::detect(&book, &IMPRINT).is_changed);
    }

    #[test]
    fn sources_that_are_not_as_committed_are_called_changed() {
        for project in ["", "deep/project"] {
            let Some((repository, id)) = committed(project) else { return };
            let book = repository.path().join(project).join("book");
            let page = book.join("src/only.md");
            let named = |is_changed: bool| {
                let edition = Edition::detect(&book, &IMPRINT);
                assert_eq!((edition.commit.as_deref(), edition.is_changed), (Some(&*id), is_changed), "{project}");
                assert_eq!(edition.words().ends_with(" of 2023-11-14, changed"), is_changed, "{}", edition.words());
                assert_eq!(edition.reference().ends_with(", changed"), is_changed);
                assert_eq!(edition.swhid(), (!is_changed).then(|| format!("swh:1:rev:{id}")));
            };
            named(false);
            fs::write(&page, "Another text.\n").unwrap();
            named(true);
            fs::write(&page, "Text.\n").unwrap();
            named(false);
            let beside = book.with_file_name("crates.rs");
            fs::write(&beside, "").unwrap();
            named(true);
            git(repository.path(), &["add", "."], "");
            named(true);
            git(repository.path(), &["rm", "--quiet", "--cached", "-r", "."], "");
            assert_eq!(Edition::detect(&book, &IMPRINT), NONE, "no longer among the files of the repository");
        }
    }

    #[test]
    fn a_book_of_a_program_from_another_commit_is_called_changed() {
        let edition = |commit: &str| Edition { commit: Some(commit.to_owned()), ..NONE };
        assert!(edition("a").made_by(&edition("b")).is_changed);
        assert!(!edition("a").made_by(&edition("a")).is_changed && !edition("a").made_by(&NONE).is_changed);
        assert_eq!(NONE.made_by(&edition("b")), NONE);
    }

    #[test]
    fn a_project_inside_the_repository_of_another_one_has_no_commit() {
        let Some((repository, _)) = committed("other") else { return };
        for place in ["archive", "other/archive", "target"] {
            let book = repository.path().join(place).join("book");
            fs::create_dir_all(&book).unwrap();
            fs::write(book.join("book.toml"), "").unwrap();
            assert_eq!(Edition::detect(&book, &IMPRINT), NONE, "{place}");
        }
        assert_eq!(Edition::detect(&repository.path().join("nowhere"), &IMPRINT), NONE);
    }
}
