//! Sites of builds that end well, early, or by force.

use super::*;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use tempfile::TempDir;

/// A folder around the output `out`.
fn around() -> (TempDir, PathBuf) {
    let around = TempDir::new().unwrap();
    let out = around.path().canonicalize().unwrap().join("out");
    (around, out)
}

/// Makes a book of one page, with its list.
fn book(folder: &Path, page: &str) {
    fs::create_dir_all(folder).unwrap();
    fs::write(folder.join("index.html"), page).unwrap();
    list::write(folder).unwrap();
}

fn page(folder: &Path) -> String {
    fs::read_to_string(folder.join("index.html")).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_book_is_put_in_place_and_nothing_is_left_over() {
    let (around, out) = around();
    for text in ["first", "second"] {
        let site = Site::open(&out).unwrap();
        book(&site.new_book(), text);
        assert_eq!(names(around.path())[0], ".out.geneva-build");
        assert!(site.finish().unwrap().is_empty());
        assert_eq!(page(&out), text);
        assert_eq!(names(around.path()), ["out"]);
    }
}

#[test]
fn a_build_that_ends_early_leaves_the_old_book_alone() {
    let (around, out) = around();
    book(&out, "old");
    let site = Site::open(&out).unwrap();
    book(&site.new_book(), "new");
    drop(site);
    assert_eq!(page(&out), "old");
    assert_eq!(names(around.path()), ["out"]);
}

#[test]
fn a_second_build_is_refused_while_the_first_one_lasts() {
    let (around, out) = around();
    let first = Site::open(&out).unwrap();
    book(&first.new_book(), "first");
    let said = Site::open(&out).err().unwrap().to_string();
    assert!(said.contains("another build into") && said.contains("wait for it, or choose another"), "{said}");
    Site::open(&around.path().join("other")).unwrap();
    first.finish().unwrap();
    assert_eq!(page(&out), "first");
    Site::open(&out).unwrap();
}

#[test]
fn builds_at_once_end_one_by_one_or_are_refused() {
    let (around, out) = around();
    let build = |number: usize| match Site::open(&out) {
        Ok(site) => {
            book(&site.new_book(), &number.to_string());
            site.finish().unwrap();
        }
        Err(error) => assert!(error.to_string().contains("another build"), "{error:#}"),
    };
    std::thread::scope(|scope| {
        for number in 0..8 {
            scope.spawn(move || (0..20).for_each(|round| build(20 * number + round)));
        }
    });
    assert_eq!(names(around.path()), ["out"]);
    list::refuse_foreign(&out).unwrap();
}

#[test]
fn a_lock_counts_only_while_it_is_in_its_place() {
    let (around, _) = around();
    let path = around.path().join("lock");
    let lock = File::create(&path).unwrap();
    assert!(is_at(&lock, &path));
    fs::rename(&path, around.path().join("other")).unwrap();
    assert!(!is_at(&lock, &path));
    File::create(&path).unwrap();
    #[cfg(unix)]
    assert!(!is_at(&lock, &path));
}

#[test]
fn what_a_killed_build_left_is_cleared() {
    let (around, out) = around();
    book(&out, "old");
    let paths = Paths::of(&out).unwrap();
    // A half-made book, and an old one that was being removed.
    fs::create_dir_all(paths.new_book().join("css")).unwrap();
    fs::write(paths.new_book().join("index.html"), "half").unwrap();
    fs::write(paths.folder.join("lock"), "").unwrap();
    book(&paths.old_book(), "older");
    let site = Site::open(&out).unwrap();
    assert_eq!(names(&paths.folder), ["lock"]);
    assert_eq!(page(&out), "old");
    drop(site);
    assert_eq!(names(around.path()), ["out"]);
}

#[test]
fn a_build_that_was_killed_between_the_two_steps_is_repaired() {
    let (around, out) = around();
    book(&out, "old");
    let paths = Paths::of(&out).unwrap();
    book(&paths.new_book(), "new");
    fs::rename(&out, paths.old_book()).unwrap();
    let site = Site::open(&out).unwrap();
    assert_eq!(page(&out), "old");
    assert!(!is_there(&paths.old_book()) && !is_there(&paths.new_book()));
    drop(site);
    assert_eq!(names(around.path()), ["out"]);
}

#[test]
fn an_old_book_comes_back_even_if_the_build_is_refused() {
    let (_around, out) = around();
    let paths = Paths::of(&out).unwrap();
    book(&paths.old_book(), "old");
    fs::write(paths.old_book().join("CNAME"), "").unwrap();
    let said = Site::open(&out).err().unwrap().to_string();
    assert!(said.contains("`CNAME`"), "{said}");
    assert_eq!(page(&out), "old");
    assert!(!is_there(&paths.folder));
}

#[test]
fn what_comes_into_the_output_during_the_build_stays_there() {
    let (_around, out) = around();
    book(&out, "old");
    let site = Site::open(&out).unwrap();
    book(&site.new_book(), "new");
    fs::write(out.join("notes.txt"), "mine").unwrap();
    let said = site.finish().unwrap_err().to_string();
    assert!(said.contains("`notes.txt`"), "{said}");
    assert_eq!(page(&out), "old");
    assert!(out.join("notes.txt").is_file());
}

#[test]
fn what_comes_at_the_last_moment_is_kept() {
    let (around, out) = around();
    for kept in ["out.kept", "out.kept-2"] {
        book(&out, "old");
        let mut site = Site::open(&out).unwrap();
        book(&site.new_book(), "new");
        site.paths.check().unwrap();
        fs::create_dir(out.join("photos")).unwrap();
        fs::write(out.join("photos/one.jpg"), "mine").unwrap();
        site.paths.put().unwrap();
        site.kept.extend(site.paths.settle().unwrap());
        assert_eq!(site.kept, [out.with_file_name(kept)]);
        drop(site);
        assert_eq!(page(&out), "new");
        assert_eq!(names(&out.with_file_name(kept)), ["photos"]);
    }
    assert_eq!(names(around.path()), ["out", "out.kept", "out.kept-2"]);
}

#[test]
fn an_output_that_becomes_something_else_is_left_alone() {
    let (_around, out) = around();
    let site = Site::open(&out).unwrap();
    book(&site.new_book(), "new");
    fs::write(&out, "mine").unwrap();
    assert!(site.finish().unwrap_err().to_string().contains("is not a folder"));
    assert_eq!(fs::read_to_string(&out).unwrap(), "mine");
}

#[test]
fn a_build_that_is_stopped_can_write_no_more() {
    let (around, out) = around();
    book(&out, "old");
    let site = Site::open(&out).unwrap();
    let new = site.new_book();
    let is_over = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let write = || fs::create_dir_all(new.join("css")).and_then(|()| fs::write(new.join("css/a"), ""));
            while write().is_ok() && !is_over.load(Relaxed) {}
        });
        site.paths.stop();
        is_over.store(true, Relaxed);
    });
    assert!(fs::create_dir_all(new.join("css")).is_err());
    drop(site);
    assert_eq!(page(&out), "old");
    assert_eq!(names(around.path()), ["out"]);
}

#[test]
fn what_is_in_the_way_of_the_hidden_folder_is_named() {
    let (_around, out) = around();
    let paths = Paths::of(&out).unwrap();
    fs::write(&paths.folder, "mine").unwrap();
    let said = Site::open(&out).err().unwrap().to_string();
    assert!(said.contains(".out.geneva-build is not a folder"), "{said}");
    assert!(paths.folder.is_file());
}

#[test]
fn what_somebody_puts_into_the_hidden_folder_stays() {
    let (_around, out) = around();
    let site = Site::open(&out).unwrap();
    let mine = site.paths.folder.join("mine");
    fs::write(&mine, "").unwrap();
    drop(site);
    assert!(mine.is_file());
}
