//! Calls of git that run nothing which a folder brings along.
//!
//! A folder may be by somebody else. git obeys the configuration of the repository that it takes a folder for, and much
//! of a configuration names programs: a monitor of the file system, filters, a signature's checker. A folder that only
//! looks like a bare repository can even be committed to an honest one and comes along with its clone. So every call of
//! git is made by [`Repository::ask`], for a repository that was found by its `.git`. What is asked here reads the objects of the
//! repository and the list of what is staged: never the work tree, on which filters and drivers run.

use crate::printable::{escape_and_shorten, in_words, shown_path};
use std::ffi::OsStr;
use std::io::{self, Read};
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

/// Variables that would lead git to another repository, or to other objects, than those that are asked for.
const MISLEADING: [&str; 13] = [
    "GIT_DIR",
    "GIT_WORK_TREE",
    "GIT_COMMON_DIR",
    "GIT_INDEX_FILE",
    "GIT_NAMESPACE",
    "GIT_PREFIX",
    "GIT_OBJECT_DIRECTORY",
    "GIT_ALTERNATE_OBJECT_DIRECTORIES",
    "GIT_GRAFT_FILE",
    "GIT_SHALLOW_FILE",
    "GIT_ATTR_SOURCE",
    "GIT_EXTERNAL_DIFF",
    "GIT_DISCOVERY_ACROSS_FILESYSTEM",
];

/// Most bytes of an answer.
const MOST_ANSWERED: u64 = 256 << 20;
/// Most bytes that are kept of what git says of a failure.
const MOST_SAID: u64 = 4096;

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

/// How the next commit differs from another one at a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StagedChange {
    /// The path below the top, in bytes as git keeps them.
    pub path: PathBuf,
    /// What is staged there; none if the file is gone, is no regular file any more, or is in a conflict.
    pub staged: Option<Blob>,
    /// What the other commit has there, or where the file was before it was moved; none if that is no regular file.
    pub earlier: Option<Blob>,
}

impl Repository {
    /// The repository that a file or folder belongs to: the nearest folder above it, or itself, that has a `.git`.
    /// None if there is no such folder or the path leads nowhere.
    pub fn containing(path: &Path) -> Option<Self> {
        let path = std::fs::canonicalize(path).ok()?;
        let top = path.ancestors().find(|folder| is_repository(&folder.join(".git")))?;
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
        self.ask_with_index(None, arguments)
    }

    /// What git answers if this file is its index, or its usual one.
    fn ask_with_index<A: AsRef<OsStr>>(
        &self,
        index: Option<&Path>,
        arguments: impl IntoIterator<Item = A>,
    ) -> Result<Vec<u8>, String> {
        let mut git = Command::new("git");
        git.arg("--no-pager").arg("--no-replace-objects").arg("--literal-pathspecs");
        for setting in SETTINGS {
            git.args(["-c", setting]);
        }
        for name in MISLEADING {
            git.env_remove(name);
        }
        if let Some(index) = index {
            git.env("GIT_INDEX_FILE", index);
        }
        // Neither a lock nor a visit to another machine, and the words of git as everybody knows them.
        git.env("GIT_OPTIONAL_LOCKS", "0").env("GIT_NO_LAZY_FETCH", "1").env("GIT_ALLOW_PROTOCOL", "none");
        git.env("GIT_TERMINAL_PROMPT", "0").env("LC_ALL", "C");
        // If what is at the top is no repository after all, git must not take one above it.
        git.env("GIT_CEILING_DIRECTORIES", self.top.parent().unwrap_or(&self.top));
        git.arg("-C").arg(&self.top).args(arguments);
        let told = |why: &dyn std::fmt::Display| format!("git in {}: {why}", shown_path(&self.top));
        match answer(git) {
            Err(why) => Err(format!("git cannot be started: {}", in_words(&why))),
            Ok(Answer { whole: false, .. }) => {
                Err(told(&format!("its answer is longer than {} MiB, the most that is read", MOST_ANSWERED >> 20)))
            }
            Ok(Answer { succeeded: true, said, .. }) => Ok(said),
            Ok(Answer { complaint, .. }) => {
                let complaint = String::from_utf8_lossy(&complaint);
                let first = complaint.lines().find(|line| !line.trim().is_empty());
                Err(told(&first.unwrap_or("it failed without a word")))
            }
        }
    }

    /// The full name of the commit that a revision stands for, in any form that git knows; none if git knows no such commit.
    ///
    /// # Errors
    ///
    /// git cannot be started, or refuses the repository.
    pub fn commit(&self, revision: &str) -> Result<Option<String>, String> {
        self.ask(["rev-parse", "--git-dir"])?;
        // An option is no revision. Not every git knows the words that say so here (`--end-of-options`).
        let is_option = revision.starts_with('-');
        let resolved = |revision: &str| {
            let answer = self.ask(["rev-parse", "--verify", "--quiet", revision]).ok()?;
            let name = String::from_utf8(answer).ok()?;
            // A negated revision (`^HEAD`) is a range, not a commit.
            name.strip_suffix('\n').filter(|name| is_name(name)).map(str::to_owned)
        };
        let object = if is_option { None } else { resolved(revision) };
        // In two steps, since whatever stands behind `:/` is text that is looked for.
        Ok(object.and_then(|object| resolved(&format!("{object}^{{commit}}"))))
    }

    /// The regular files of a commit (its full name) with their paths below the top, in bytes as git keeps them.
    ///
    /// # Errors
    ///
    /// git cannot be started or fails.
    pub fn files(&self, commit: &str) -> Result<Vec<(PathBuf, Blob)>, String> {
        let listed = self.ask(["ls-tree", "-r", "-z", "--full-tree", named(commit)?])?;
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

    /// The index that git hands a hook of this repository (`GIT_INDEX_FILE`): with `git commit -a` it isn't the usual one. One outside
    /// the repository's own folder of git doesn't count.
    fn index_of_hook(&self) -> Option<PathBuf> {
        let index = std::fs::canonicalize(self.top.join(std::env::var_os("GIT_INDEX_FILE")?)).ok()?;
        let own = String::from_utf8(self.ask(["rev-parse", "--absolute-git-dir"]).ok()?).ok()?;
        index.starts_with(std::fs::canonicalize(own.trim_end_matches('\n')).ok()?).then_some(index)
    }

    /// The regular files that are staged for the next commit, with their paths below the top; in a hook, those of the commit that is
    /// being made. Git reads only the list of them, and no filter or driver of the work tree runs.
    ///
    /// # Errors
    ///
    /// git cannot be started or fails.
    pub fn staged_files(&self) -> Result<Vec<(PathBuf, Blob)>, String> {
        let listed = self.ask_with_index(self.index_of_hook().as_deref(), ["ls-files", "--stage", "-z"])?;
        let entry = |line: &[u8]| {
            let tab = line.iter().position(|byte| *byte == b'\t')?;
            let (about, name) = line.split_at(tab);
            let mut words = std::str::from_utf8(about).ok()?.split(' ');
            let is_file = words.next()?.starts_with("100");
            let id = words.next()?.to_owned();
            // Another number than 0 is one side of a conflict.
            (is_file && words.next()? == "0").then(|| (path_of(&name[1..]), Blob { id }))
        };
        Ok(listed.split(|byte| *byte == 0).filter_map(entry).collect())
    }

    /// The regular files whose staged content differs from that of a commit (its full name), or all staged files if there is none,
    /// by their paths below the top; in a hook, those of the commit that is being made. A file that was moved is compared with
    /// the one that it was. What is in a conflict has no staged content.
    ///
    /// # Errors
    ///
    /// git cannot be started or fails.
    pub fn staged_changes(&self, commit: Option<&str>) -> Result<Vec<StagedChange>, String> {
        let Some(commit) = commit else {
            let files = self.staged_files()?.into_iter();
            return Ok(files
                .map(|(path, staged)| StagedChange { path, staged: Some(staged), earlier: None })
                .collect());
        };
        let (commit, index) = (named(commit)?, self.index_of_hook());
        let listed = |renames| {
            let options = ["diff-index", "--cached", "--raw", "--no-abbrev", "--ignore-submodules=all", "-z", renames];
            self.ask_with_index(index.as_deref(), options.into_iter().chain(["-l1000", commit]))
        };
        // To find what was moved, git reads contents, of which a repository may have only a part.
        let listed = listed("--find-renames").or_else(|_| listed("--no-renames"))?;
        let mut parts = listed.split(|byte| *byte == 0);
        let mut changes = Vec::new();
        while let Some(about) = parts.next().and_then(|about| about.strip_prefix(b":")) {
            let words: Vec<&str> = std::str::from_utf8(about).unwrap_or_default().split(' ').collect();
            let (&[before, after, earlier, staged, kind], Some(first)) = (words.as_slice(), parts.next()) else {
                break;
            };
            let blob = |mode: &str, id: &str| mode.starts_with("100").then(|| Blob { id: id.to_owned() });
            let (earlier, staged) = (blob(before, earlier), blob(after, staged));
            let second = if kind.starts_with(['R', 'C']) { parts.next() } else { None };
            if kind.starts_with('R') {
                changes.push(StagedChange { path: path_of(first), staged: None, earlier: earlier.clone() });
            }
            let staged = staged.filter(|_| !kind.starts_with('U'));
            if staged.is_some() || earlier.is_some() {
                changes.push(StagedChange { path: path_of(second.unwrap_or(first)), staged, earlier });
            }
        }
        Ok(changes)
    }

    /// The paths below the top that a merge has left in conflict, each once.
    ///
    /// # Errors
    ///
    /// git cannot be started or fails.
    pub fn conflicts(&self) -> Result<Vec<PathBuf>, String> {
        let listed = self.ask_with_index(self.index_of_hook().as_deref(), ["ls-files", "--unmerged", "-z"])?;
        let name = |line: &[u8]| line.iter().position(|byte| *byte == b'\t').map(|tab| path_of(&line[tab + 1..]));
        let mut paths: Vec<PathBuf> = listed.split(|byte| *byte == 0).filter_map(name).collect();
        paths.dedup();
        Ok(paths)
    }

    /// The bytes of a file as a commit has it, without any filter.
    ///
    /// # Errors
    ///
    /// git cannot be started or fails.
    pub fn content(&self, blob: &Blob) -> Result<Vec<u8>, String> {
        self.ask(["cat-file", "blob", named(&blob.id)?])
    }
}

/// Whether git takes this `.git` for a repository, or refuses it; it looks further above if it is neither.
fn is_repository(git: &Path) -> bool {
    let has = |name: &str| git.join(name).exists();
    match std::fs::metadata(git) {
        Ok(there) if there.is_dir() => has("HEAD") && ((has("objects") && has("refs")) || has("commondir")),
        Ok(there) => there.is_file(),
        Err(_) => false,
    }
}

/// Whether this is the full name of an object.
fn is_name(name: &str) -> bool {
    matches!(name.len(), 40 | 64) && name.bytes().all(|digit| digit.is_ascii_hexdigit())
}

fn named(name: &str) -> Result<&str, String> {
    if is_name(name) {
        Ok(name)
    } else {
        Err(format!("`{}` is no full name of an object of git", escape_and_shorten(name)))
    }
}

/// What git answered.
struct Answer {
    succeeded: bool,
    /// Whether the answer is shorter than the bound.
    whole: bool,
    said: Vec<u8>,
    complaint: Vec<u8>,
}

/// Runs git, and reads no more than the bounds.
fn answer(mut git: Command) -> io::Result<Answer> {
    let mut child = git.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
    let (out, errors) = (child.stdout.take(), child.stderr.take());
    let complain = move || -> io::Result<Vec<u8>> {
        let mut kept = Vec::new();
        if let Some(mut errors) = errors {
            errors.by_ref().take(MOST_SAID).read_to_end(&mut kept)?;
            io::copy(&mut errors, &mut io::sink())?;
        }
        Ok(kept)
    };
    // What is said on the one stream must not wait for the other to be read.
    let complaints = std::thread::spawn(complain);
    let mut said = Vec::new();
    let read = out.map_or(Ok(0), |out| out.take(MOST_ANSWERED + 1).read_to_end(&mut said));
    let whole = said.len() as u64 <= MOST_ANSWERED;
    if !whole || read.is_err() {
        // It may have ended by itself.
        let _ = child.kill();
    }
    let ended = child.wait()?;
    let complaint = complaints.join().unwrap_or_else(|_| Ok(Vec::new()));
    read?;
    Ok(Answer { succeeded: ended.success(), whole, said, complaint: complaint? })
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

#[cfg(test)]
mod attacked;
