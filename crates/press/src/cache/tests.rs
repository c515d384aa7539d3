//! Is what a shelf gives always what would be made, whatever has happened to its file?

use super::*;
use std::cell::Cell;
use tempfile::TempDir;

const PROGRAM: Key = [7; DIGEST];
const OTHER: Key = [8; DIGEST];

fn shelf(target: &TempDir, program: Key) -> Shelf {
    Shelf::at(Some((folder(target.path(), &program).join("shelf"), program)))
}

/// Asks a shelf for the length of a text, and whether it had to be made.
fn length(shelf: &Shelf, text: &str) -> (String, bool) {
    let is_made = Cell::new(false);
    let made = shelf.text("length", &[text], || {
        is_made.set(true);
        Ok(text.len().to_string())
    });
    (made.expect("a length"), is_made.get())
}

/// A target directory in which these texts are kept.
fn kept(texts: &[&str]) -> (TempDir, PathBuf) {
    let target = TempDir::new().expect("a folder");
    let first = shelf(&target, PROGRAM);
    texts.iter().for_each(|text| assert!(length(&first, text).1, "{text}"));
    first.complete();
    drop(first);
    let file = folder(target.path(), &PROGRAM).join("shelf");
    assert!(file.is_file());
    (target, file)
}

#[test]
fn what_was_made_is_kept_for_the_same_parts_of_the_same_program_alone() {
    let (target, _) = kept(&["four"]);
    let again = shelf(&target, PROGRAM);
    assert_eq!(length(&again, "four"), ("4".to_owned(), false));
    assert_eq!(length(&again, "fives"), ("5".to_owned(), true));
    assert_eq!(length(&again, "fives"), ("5".to_owned(), false));
    let pair = |what: &str, parts: &[&str]| again.text(what, parts, || Ok("made".to_owned())).expect("made");
    assert_eq!(pair("other", &["four"]), "made");
    assert_eq!(pair("length", &["fo", "ur"]), "made");
    assert_eq!(pair("length", &["four", ""]), "made");
    assert_eq!(length(&shelf(&target, OTHER), "four"), ("4".to_owned(), true));
}

#[test]
fn a_file_that_is_damaged_cut_short_or_foreign_is_made_anew() {
    let (target, file) = kept(&["four", "longer"]);
    let whole = fs::read(&file).expect("a file");
    let flipped = (0..whole.len()).step_by(3).map(|at| {
        let mut bytes = whole.clone();
        bytes[at] ^= 1;
        bytes
    });
    let cut = (0..whole.len()).step_by(5).map(|end| whole[..end].to_vec());
    let longer = [whole.iter().copied().chain([0]).collect(), b"{\"foreign\": true}".to_vec(), vec![0xff; 200]];
    for bytes in flipped.chain(cut).chain(longer) {
        fs::write(&file, &bytes).expect("written");
        assert_eq!(length(&shelf(&target, PROGRAM), "four"), ("4".to_owned(), true), "{bytes:?}");
    }
    let own = folder(target.path(), &PROGRAM);
    fs::write(own.join("shelf"), &whole).expect("written");
    fs::rename(&own, folder(target.path(), &OTHER)).expect("moved");
    assert!(length(&shelf(&target, OTHER), "four").1, "a file of another program");
}

#[test]
fn a_place_that_cannot_be_read_or_written_does_no_harm() {
    let target = TempDir::new().expect("a folder");
    fs::write(target.path().join(FOLDER), "a file where the folder would be").expect("written");
    for _ in 0..2 {
        assert_eq!(length(&shelf(&target, PROGRAM), "four"), ("4".to_owned(), true));
    }
    let (target, file) = kept(&["four"]);
    fs::remove_file(&file).expect("removed");
    fs::create_dir(&file).expect("a folder where the file would be");
    for _ in 0..2 {
        assert_eq!(length(&shelf(&target, PROGRAM), "four"), ("4".to_owned(), true));
    }
    let nowhere = Shelf::open(&target.path().join("no-target"), &crate::samples::BOOK, "shelf");
    assert!(length(&nowhere, "four").1 && !target.path().join("no-target").exists());
}

#[test]
fn builds_at_the_same_time_do_not_disturb_one_another() {
    let (target, _) = kept(&["four"]);
    std::thread::scope(|scope| {
        for number in 0..8_usize {
            let target = &target;
            scope.spawn(move || {
                for round in 0..20 {
                    let text = "x".repeat(number + round);
                    let own = shelf(target, PROGRAM);
                    assert_eq!(length(&own, &text).0, text.len().to_string());
                    assert_eq!(length(&own, "four").0, "4");
                }
            });
        }
    });
    assert_eq!(length(&shelf(&target, PROGRAM), "four").0, "4");
    let names: Vec<_> = fs::read_dir(folder(target.path(), &PROGRAM)).expect("a folder").collect();
    assert_eq!(names.len(), 1, "{names:?}");
}

#[test]
fn what_a_whole_build_has_not_asked_for_is_dropped_and_what_belongs_to_an_entry_stays_with_it() {
    let (target, _) = kept(&["four", "fives"]);
    let page = |shelf: &Shelf| shelf.text("page", &["p"], || Ok(length(shelf, "inside").0)).expect("made");
    let second = shelf(&target, PROGRAM);
    assert!(!length(&second, "four").1 && page(&second) == "6");
    second.complete();
    drop(second);
    let third = shelf(&target, PROGRAM);
    // The page comes whole from the shelf, and what was made for it is still known when the page changes.
    assert!(page(&third) == "6" && length(&third, "new").1);
    third.complete();
    drop(third);
    let fourth = shelf(&target, PROGRAM);
    assert!(!length(&fourth, "inside").1 && !length(&fourth, "new").1);
    assert!(length(&fourth, "fives").1 && length(&fourth, "four").1);
}

#[test]
fn a_build_that_fails_keeps_what_was_known_and_no_error() {
    let (target, _) = kept(&["four"]);
    let second = shelf(&target, PROGRAM);
    assert!(second.text("page", &["p"], || anyhow::bail!("no such claim")).is_err());
    assert!(length(&second, "fives").1);
    drop(second);
    let third = shelf(&target, PROGRAM);
    assert!(!length(&third, "four").1 && !length(&third, "fives").1);
    assert_eq!(third.text("page", &["p"], || Ok("right".to_owned())).expect("made"), "right");
}

#[test]
fn programs_that_are_gone_leave_nothing_behind() {
    let target = TempDir::new().expect("a folder");
    let foreign = target.path().join(FOLDER).join("notes");
    fs::create_dir_all(&foreign).expect("a folder");
    for number in 0..12 {
        assert!(length(&shelf(&target, [number; DIGEST]), "four").1);
        let all = fs::read_dir(target.path().join(FOLDER)).expect("a folder").count();
        assert!(all <= PROGRAMS + 1, "{all}");
        assert!(!length(&shelf(&target, [number; DIGEST]), "four").1, "its own is kept");
    }
    assert!(foreign.is_dir(), "what no build has written stays");
    // A build that was interrupted long ago has left a file on its way.
    let own = folder(target.path(), &[11; DIGEST]);
    let left = own.join(".tmpAbCdEf");
    let file = File::create(&left).expect("a file");
    file.set_modified(SystemTime::now() - 2 * LONG).expect("a time");
    assert!(length(&shelf(&target, [11; DIGEST]), "fives").1);
    assert!(!left.exists() && own.join("shelf").is_file());
}

#[test]
fn the_running_program_has_one_name() {
    let name = program().expect("a program that can be read");
    assert_eq!(Some(name), program());
    let own = fs::read(std::env::current_exe().expect("a path")).expect("a program");
    assert_eq!(hexadecimal(&name), digest(&own));
}

#[test]
fn what_a_branch_has_made_is_kept_if_it_is_taken_in() {
    let (target, _) = kept(&["four", "longer"]);
    let all = shelf(&target, PROGRAM);
    let [taken, lost] = [all.branch(), all.branch()];
    assert_eq!(length(&taken, "four"), ("4".to_owned(), false));
    assert!(length(&taken, "fives").1 && length(&lost, "sixsix").1 && length(&all, "seventh").1);
    drop(lost);
    all.take_in(taken);
    assert_eq!(length(&all, "fives"), ("5".to_owned(), false));
    all.complete();
    drop(all);
    let again = shelf(&target, PROGRAM);
    let is_made = |text: &str| length(&again, text).1;
    assert_eq!(["four", "fives", "seventh"].map(is_made), [false; 3]);
    // Nobody has taken in the one, or asked for the other.
    assert_eq!(["sixsix", "longer"].map(is_made), [true; 2]);
}
