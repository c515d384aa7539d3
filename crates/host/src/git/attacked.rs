//! Repositories that try to run a program, to lead git elsewhere, or to hide a file behind its name.

use super::Repository;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// Settings of a repository that name a program, each of which would leave a file `RAN`.
fn hostile(ran: &Path) -> String {
    let touch = format!("touch '{}'", ran.display());
    format!(
        "[core]\n\trepositoryformatversion = 1\n\tbare = false\n\tfsmonitor = \"{touch}\"\n\tpager = \"{touch}\"\n\
         \teditor = \"{touch}\"\n\tsshCommand = \"{touch}\"\n\taskPass = \"{touch}\"\n\tgitProxy = \"{touch}\"\n\
         \talternateRefsCommand = \"{touch}\"\n\
         [extensions]\n\tpartialClone = evil\n\
         [remote \"evil\"]\n\turl = \"ext::sh -c {touch}\"\n\tpromisor = true\n\
         [remote \"other\"]\n\turl = \"{}\"\n\tpromisor = true\n\tuploadpack = \"{touch}\"\n\
         [protocol]\n\tallow = always\n\
         [alias]\n\trev-parse = \"!{touch}\"\n\tls-tree = \"!{touch}\"\n\tcat-file = \"!{touch}\"\n\
         [filter \"evil\"]\n\tclean = \"{touch}\"\n\tsmudge = \"{touch}\"\n\tprocess = \"{touch}\"\n\trequired = true\n\
         [diff]\n\texternal = \"{touch}\"\n\
         [diff \"evil\"]\n\ttextconv = \"{touch}\"\n\tcommand = \"{touch}\"\n\
         [merge \"evil\"]\n\tdriver = \"{touch}\"\n\
         [pager]\n\tls-tree = \"{touch}\"\n\tlog = \"{touch}\"\n\
         [credential]\n\thelper = \"!{touch}\"\n\
         [gpg]\n\tprogram = \"{touch}\"\n\
         [log]\n\tshowSignature = true\n",
        ran.with_file_name(".git").display()
    )
}

fn git(folder: &Path, arguments: &[&str]) {
    let identity = ["-c", "user.name=T", "-c", "user.email=t@example.org", "-c", "commit.gpgsign=false"];
    let output = Command::new("git").arg("-C").arg(folder).args(identity).args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// A repository with one commit of a file `a`; none where there is no git.
fn repository() -> Option<TempDir> {
    if Command::new("git").arg("--version").output().is_err() {
        println!("skipped: there is no git here");
        return None;
    }
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("a"), "first").unwrap();
    git(folder.path(), &["init", "-q"]);
    git(folder.path(), &["add", "."]);
    git(folder.path(), &["commit", "-q", "-m", "The first text"]);
    Some(folder)
}

fn around(path: &Path) -> Repository {
    Repository::containing(path).expect("a repository")
}

#[test]
fn a_folder_that_looks_like_a_repository_is_none() {
    let Some(folder) = repository() else { return };
    let (ran, evil) = (folder.path().join("RAN"), folder.path().join("evil"));
    for inside in ["objects/info", "refs/heads"] {
        fs::create_dir_all(evil.join(inside)).unwrap();
    }
    fs::write(evil.join("HEAD"), "ref: refs/heads/main\n").unwrap();
    fs::write(evil.join("config"), hostile(&ran)).unwrap();
    fs::write(evil.join("text"), "text").unwrap();
    let top = folder.path().canonicalize().unwrap();
    for path in [&evil, &evil.join("text"), folder.path()] {
        assert_eq!(around(path).top(), top);
    }
    // Nor does git take it for one if it is asked there.
    let there = Repository { top: evil };
    assert!(there.ask(["rev-parse", "--git-dir"]).is_err());
    assert!(there.ask(["status"]).is_err());
    assert!(!ran.exists());
}

#[test]
fn an_empty_dot_git_leads_to_the_repository_above() {
    let Some(folder) = repository() else { return };
    fs::create_dir_all(folder.path().join("inside/.git")).unwrap();
    let top = folder.path().canonicalize().unwrap();
    assert_eq!(around(&folder.path().join("inside")).top(), top);
    // And if it is no repository after all, none above it is taken in its place.
    for inside in ["objects", "refs"] {
        fs::create_dir(folder.path().join("inside/.git").join(inside)).unwrap();
    }
    fs::write(folder.path().join("inside/.git/HEAD"), "nonsense").unwrap();
    let told = around(&folder.path().join("inside")).commit("HEAD").unwrap_err();
    assert!(told.contains("inside: ") && told.contains("not a git repository"), "{told}");
}

#[test]
fn nothing_that_the_settings_of_a_repository_name_is_run() {
    let Some(folder) = repository() else { return };
    let ran = folder.path().join("RAN");
    let hook = folder.path().join(".git/hooks/post-index-change");
    fs::create_dir_all(folder.path().join(".git/hooks")).unwrap();
    fs::write(&hook, format!("#!/bin/sh\ntouch '{}'\n", ran.display())).unwrap();
    #[cfg(unix)]
    fs::set_permissions(&hook, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
    fs::write(folder.path().join(".gitattributes"), "* filter=evil diff=evil merge=evil\n").unwrap();
    fs::write(folder.path().join(".git/config"), hostile(&ran)).unwrap();
    let repository = around(folder.path());
    let commit = repository.commit("HEAD").unwrap().expect("a commit");
    assert_eq!(repository.commit(":/first").unwrap().as_deref(), Some(commit.as_str()));
    let files = repository.files(&commit).unwrap();
    let [(name, blob)] = files.as_slice() else { panic!("{files:?}") };
    assert_eq!((name.as_path(), repository.content(blob).unwrap().as_slice()), (Path::new("a"), b"first".as_slice()));
    assert_eq!(repository.staged_changes(Some(&commit)), Ok(Vec::new()));
    assert_eq!(repository.conflicts(), Ok(Vec::new()));
    // What is missing is not fetched.
    let missing = super::Blob { id: "1".repeat(40) };
    assert!(repository.content(&missing).is_err());
    // These look at the work tree.
    fs::write(folder.path().join("a"), "second").unwrap();
    repository.ask(["status", "--porcelain"]).unwrap_or_default();
    assert!(!ran.exists());
}

#[test]
fn a_revision_is_resolved_to_one_commit() {
    let Some(folder) = repository() else { return };
    git(folder.path(), &["tag", "v1"]);
    let repository = around(&folder.path().join("a"));
    let commit = repository.commit("HEAD").unwrap().expect("a commit");
    for revision in ["v1", ":/The first", "HEAD~0", "HEAD^{commit}", &commit[..10]] {
        assert_eq!(repository.commit(revision).unwrap().as_ref(), Some(&commit), "{revision}");
    }
    for revision in [
        "",
        "^HEAD",
        "HEAD..HEAD",
        "-x",
        "--all",
        "--git-dir",
        "nowhere",
        "HEAD:a",
        "HEAD^{tree}",
        ":/nowhere",
        "a\0",
        "\n",
    ] {
        assert_eq!(repository.commit(revision), Ok(None), "{revision:?}");
    }
    for name in ["HEAD", "--help", "", "xyz"] {
        assert!(repository.files(name).is_err_and(|told| told.contains("no full name of an object")), "{name}");
    }
}

#[cfg(unix)]
#[test]
fn names_in_any_bytes_are_kept() {
    use std::os::unix::ffi::OsStrExt;
    let Some(folder) = repository() else { return };
    let names = [&b"caf\xe9"[..], b"b ", b"c\n", b" d", b"\"e\"", b"-f", b"g\t", b":(top)h"];
    let path = |name: &[u8]| folder.path().join(std::ffi::OsStr::from_bytes(name));
    names.iter().for_each(|name| fs::write(path(name), name).unwrap());
    std::os::unix::fs::symlink("a", path(b"link")).unwrap();
    git(folder.path(), &["add", "."]);
    git(folder.path(), &["commit", "-q", "-m", "Names"]);
    let repository = around(folder.path());
    let files = repository.files(&repository.commit("HEAD").unwrap().expect("a commit")).unwrap();
    assert_eq!(files.len(), names.len() + 1);
    for (name, blob) in files.iter().filter(|(name, _)| name != Path::new("a")) {
        assert_eq!(repository.content(blob).unwrap(), name.as_os_str().as_bytes());
    }
    // The folder may end in what looks like the end of a line.
    let other = folder.path().with_extension("moved \n");
    fs::rename(folder.path(), &other).unwrap();
    let moved = around(&other);
    assert_eq!(moved.top(), other.canonicalize().unwrap());
    assert!(moved.commit("HEAD").unwrap().is_some());
    fs::rename(&other, folder.path()).unwrap();
}

#[test]
fn a_file_that_was_moved_is_compared_with_what_it_was() {
    let Some(folder) = repository() else { return };
    let long = "A line.\n".repeat(20);
    fs::write(folder.path().join("b\tb"), &long).unwrap();
    git(folder.path(), &["add", "."]);
    git(folder.path(), &["commit", "-q", "-m", "Two files"]);
    let repository = around(folder.path());
    let commit = repository.commit("HEAD").unwrap().expect("a commit");
    assert_eq!(repository.staged_changes(Some(&commit)), Ok(Vec::new()));
    assert_eq!(repository.staged_changes(None).unwrap().len(), 2);
    git(folder.path(), &["mv", "b\tb", "c"]);
    fs::write(folder.path().join("c"), format!("{long}Another.\n")).unwrap();
    git(folder.path(), &["add", "c"]);
    git(folder.path(), &["rm", "-q", "a"]);
    // What is only on the disk is not staged.
    fs::write(folder.path().join("d"), "on the disk").unwrap();
    let mut changes = repository.staged_changes(Some(&commit)).unwrap();
    changes.sort_by(|one, other| one.path.cmp(&other.path));
    let has = |change: &super::StagedChange| {
        [&change.earlier, &change.staged].map(|blob| blob.as_ref().map(|blob| repository.content(blob).unwrap().len()))
    };
    let found: Vec<_> = changes.iter().map(|change| (change.path.to_str().unwrap(), has(change))).collect();
    let (before, after) = (Some(long.len()), Some(long.len() + 9));
    assert_eq!(found, [("a", [Some(5), None]), ("b\tb", [before, None]), ("c", [before, after])]);
    assert!(repository.staged_changes(Some("HEAD")).is_err_and(|told| told.contains("no full name of an object")));
}

#[test]
fn a_second_work_tree_is_a_repository() {
    let Some(folder) = repository() else { return };
    let other = TempDir::new().unwrap();
    let tree = other.path().join("tree");
    git(folder.path(), &["worktree", "add", "-q", tree.to_str().unwrap()]);
    let (first, second) = (around(folder.path()), around(&tree.join("a")));
    assert_eq!(second.top(), tree.canonicalize().unwrap());
    assert_eq!(first.commit("HEAD").unwrap(), second.commit("HEAD").unwrap());
}

#[test]
fn no_variable_leads_elsewhere() {
    const TOLD: &str = "GENEVA_TEST_MISLED";
    if std::env::var_os(TOLD).is_none() {
        let mut own = Command::new(std::env::current_exe().unwrap());
        own.args(["--exact", "git::attacked::no_variable_leads_elsewhere", "--test-threads=1"]).env(TOLD, "1");
        // The files of another repository, or of none.
        let nowhere = TempDir::new().unwrap();
        for name in super::MISLEADING {
            own.env(name, nowhere.path());
        }
        let output = own.output().unwrap();
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success() && said.contains("1 passed"), "{said}");
        return;
    }
    let folder = TempDir::new().unwrap();
    let mut plain = Command::new("git");
    for name in super::MISLEADING {
        plain.env_remove(name);
    }
    let Ok(output) = plain.arg("init").arg("-q").arg(folder.path()).output() else { return };
    assert!(output.status.success());
    let inside = around(folder.path()).ask(["rev-parse", "--absolute-git-dir"]).unwrap();
    let inside = String::from_utf8(inside).unwrap();
    assert_eq!(Path::new(inside.trim_end()), folder.path().canonicalize().unwrap().join(".git"));
}
