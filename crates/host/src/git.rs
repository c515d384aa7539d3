//! Calls of git that run nothing which a folder brings along.
//!
//! A folder may be by somebody else. git obeys the configuration of the repository that it takes a folder for, and much
//! of a configuration names programs: a monitor of the file system, filters, a signature's checker. A folder that only
//! looks like a bare repository can even be committed to an honest one and comes along with its clone. So every call of
//! git is made by [`Repository::ask`], for a repository that was found by its `.git`.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Settings for every call; they go before those of any file. The first lets git take only a `.git` for a repository.
const SETTINGS: [&str; 7] = [
    "safe.bareRepository=explicit",
    "core.fsmonitor=false",
    "core.hooksPath=/dev/null",
    "log.showSignature=false",
    "color.ui=false",
    "core.quotePath=false",
    "submodule.recurse=false",
];

/// Variables that would lead git to another repository than the one that is asked.
const MISLEADING: [&str; 7] = [
    "GIT_DIR",
    "GIT_WORK_TREE",
    "GIT_COMMON_DIR",
    "GIT_INDEX_FILE",
    "GIT_NAMESPACE",
    "GIT_EXTERNAL_DIFF",
    "GIT_CEILING_DIRECTORIES",
];

/// A repository of git with a work tree.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Repository {
    top: PathBuf,
}

/// What a tree of git has at a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Blob {
    /// The name that git gives the content, in hexadecimal digits.
    pub id: String,
}

impl Repository {
    /// The repository that a file or folder belongs to: the nearest folder above it, or itself, that has a `.git`.
    /// None if there is no such folder or the path leads nowhere.
    pub fn around(path: &Path) -> Option<Self> {
        let path = std::fs::canonicalize(path).ok()?;
        let top = path.ancestors().find(|folder| std::fs::symlink_metadata(folder.join(".git")).is_ok())?;
        Some(Self { top: top.to_owned() })
    }

    /// The folder that has the `.git`, as the system names it (without links).
    pub fn top(&self) -> &Path {
        &self.top
    }

    /// What git answers on standard output.
    ///
    /// # Errors
    ///
    /// git cannot be started, or fails: its own first words.
    pub fn ask<A: AsRef<OsStr>>(&self, arguments: impl IntoIterator<Item = A>) -> Result<Vec<u8>, String> {
        let mut git = Command::new("git");
        git.arg("--no-pager").arg("--no-replace-objects").arg("--literal-pathspecs");
        for setting in SETTINGS {
            git.args(["-c", setting]);
        }
        for name in MISLEADING {
            git.env_remove(name);
        }
        // Neither a lock nor a visit to another machine, and the words of git as everybody knows them.
        git.env("GIT_OPTIONAL_LOCKS", "0").env("GIT_NO_LAZY_FETCH", "1").env("GIT_ALLOW_PROTOCOL", "none");
        git.env("GIT_TERMINAL_PROMPT", "0").env("LC_ALL", "C");
        git.arg("-C").arg(&self.top).args(arguments).stdin(Stdio::null());
        let output = git.output().map_err(|why| format!("git cannot be started: {why}"))?;
        if output.status.success() {
            return Ok(output.stdout);
        }
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let first = said.lines().find(|line| !line.trim().is_empty()).unwrap_or("it failed without a word");
        Err(format!("git in {}: {first}", self.top.display()))
    }

    /// The full name of the commit that a revision stands for, in any form that git knows; none if git knows no such commit.
    ///
    /// # Errors
    ///
    /// git cannot be started.
    pub fn commit(&self, revision: &str) -> Result<Option<String>, String> {
        self.ask(["--version"])?;
        let resolved = |revision: &str| {
            let answer = self.ask(["rev-parse", "--verify", "--quiet", "--end-of-options", revision]).ok()?;
            let name = String::from_utf8(answer).ok()?.trim_end().to_owned();
            // A negated revision (`^HEAD`) is a range, not a commit.
            (!name.is_empty() && name.bytes().all(|digit| digit.is_ascii_hexdigit())).then_some(name)
        };
        Ok(resolved(revision).and_then(|object| resolved(&format!("{object}^{{commit}}"))))
    }

    /// The regular files of a commit (its full name) with their paths below the top, in bytes as git keeps them.
    ///
    /// # Errors
    ///
    /// git cannot be started or fails.
    pub fn files(&self, commit: &str) -> Result<Vec<(PathBuf, Blob)>, String> {
        let listed = self.ask(["ls-tree", "-r", "-z", "--full-tree", "--end-of-options", commit])?;
        let entry = |line: &[u8]| {
            let tab = line.iter().position(|byte| *byte == b'\t')?;
            let (about, name) = line.split_at(tab);
            let about = std::str::from_utf8(about).ok()?;
            let mut words = about.split(' ');
            // A link (120000) or another repository (160000) has no text of its own.
            let is_file = words.next()?.starts_with("100") && words.next()? == "blob";
            let id = words.next()?.to_owned();
            is_file.then(|| (path_of(&name[1..]), Blob { id }))
        };
        Ok(listed.split(|byte| *byte == 0).filter_map(entry).collect())
    }

    /// The bytes of a file as a commit has it, without any filter.
    ///
    /// # Errors
    ///
    /// git cannot be started or fails.
    pub fn content(&self, blob: &Blob) -> Result<Vec<u8>, String> {
        self.ask(["cat-file", "blob", &blob.id])
    }
}

/// A path out of the bytes that git has for it.
fn path_of(bytes: &[u8]) -> PathBuf {
    #[cfg(unix)]
    {
        use std::os::unix::ffi::OsStrExt;
        OsStr::from_bytes(bytes).into()
    }
    #[cfg(not(unix))]
    {
        std::ffi::OsString::from(String::from_utf8_lossy(bytes).into_owned()).into()
    }
}
