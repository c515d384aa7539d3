//! Are the chapters written as chapters should be? Looks at the Markdown, before anything is drawn in.

use geneva_chapters::{BOOK, computed, figures, questions, readme};
use geneva_documents::LEDGER;
use geneva_evidence::{Consequence, Decimal, TracedSlip, Verdict, numeric_tokens};
use geneva_press::codecheck::codecheck;
use geneva_press::pages::{Page, chapters_to_test};
use geneva_press::ro_crate::data_files;
use geneva_press::{address, fences, works};
use pulldown_cmark::{CodeBlockKind, Event, Parser, Tag};

/// The pages by file name, with their Markdown.
pub(crate) fn chapters() -> Vec<(String, String)> {
    let read = |page: &Page| {
        let file = format!("{}.md", page.name);
        let text = std::fs::read_to_string(crate::path("book/src").join(&file)).expect("a page of the list");
        (file, text)
    };
    BOOK.pages.iter().map(read).collect()
}

/// The pages, and the documents beside the book, by file name.
pub(crate) fn texts() -> impl Iterator<Item = (String, String)> {
    let name = |(path, text): (std::path::PathBuf, String)| {
        (path.file_name().expect("a name").to_string_lossy().into_owned(), text)
    };
    chapters().into_iter().chain(crate::documents().into_iter().map(name))
}

/// Writes a file anew if it stands otherwise, and says whether it stood so.
pub(crate) fn stood_written(file: &str, text: &str) -> bool {
    let path = crate::path(file);
    let stood = std::fs::read_to_string(&path).is_ok_and(|standing| standing == text);
    if !stood {
        std::fs::write(&path, text).expect("written");
    }
    stood
}

#[test]
fn what_the_list_of_pages_writes_is_written() {
    let mut files = geneva_chapters::generate_files().expect("written");
    let library = std::fs::read_to_string(crate::path("book/lib.rs")).expect("the chapters' library");
    let (before, _) = library.split_once("\nchapters! {\n").expect("the list of chapters");
    files.push(("book/lib.rs".to_owned(), format!("{before}\nchapters! {{\n{}}}\n", chapters_to_test(BOOK.pages))));
    let readme = std::fs::read_to_string(crate::path("README.md")).expect("the README");
    let readme =
        readme::generate_readme(&BOOK, &readme, address::settled(&BOOK.imprint).as_ref()).expect("the README anew");
    files.push(("README.md".to_owned(), readme));
    let data = data_files(crate::book_pages::book()).expect("the data of the book");
    files.push(("codecheck.yml".to_owned(), codecheck(&BOOK.imprint, "target/book/data", &data)));
    files.retain(|(file, text)| !stood_written(file, text));
    let changed: Vec<_> = files.iter().map(|(file, _)| file.as_str()).collect();
    assert!(
        changed.is_empty(),
        "{} did not stand as the list of pages has it, and stands so now: look at the difference and test again",
        changed.join(", ")
    );
}

#[test]
fn no_page_is_left_out_of_the_list_and_what_it_is_to_list_is_shown() {
    let listed: Vec<_> = chapters().into_iter().map(|(file, _)| file).collect();
    for (path, _) in crate::files("book/src", &[".md"]) {
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        assert!(name == "SUMMARY.md" || listed.contains(&name), "{name} is in no list");
    }
    for (page, (file, text)) in BOOK.pages.iter().zip(chapters()) {
        let shows = text.contains(&format!("{{{{records:{}}}}}", page.name));
        assert_eq!(shows, page.role.is_listing(), "{file} and the list of pages differ");
    }
}

#[test]
fn every_block_of_code_names_its_language_and_runs_if_it_is_rust() {
    for (file, text) in texts() {
        let untagged = fences::untagged(&text);
        assert!(untagged.is_empty(), "{file}: blocks without a language: {untagged:?}");
        for event in Parser::new(&text) {
            let Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(tags))) = event else { continue };
            for tag in ["ignore", "no_run", "compile_fail", "should_panic"] {
                assert!(!tags.contains(tag), "{file}: a block marked {tags}; every example runs");
            }
        }
    }
}

#[test]
fn no_decimal_of_the_ledger_is_typed_in_a_chapter() {
    for (file, text) in texts() {
        for (at, line) in text.lines().enumerate() {
            for token in numeric_tokens(line) {
                let computed = |typed: &Decimal| {
                    LEDGER
                        .verdicts()
                        .iter()
                        .find(|judged| judged.computed.is_some_and(|number| typed.is_rounding_of(number)))
                };
                let typed = token.parse().ok().filter(|_| crate::is_telling(&token));
                let owner = crate::owner(&token).or_else(|| typed.as_ref().and_then(computed).map(|j| j.claim.id));
                assert!(owner.is_none(), "{file}, line {}: {token} belongs to {owner:?}", at + 1);
            }
        }
    }
}

#[test]
fn an_example_uses_only_crates_that_the_test_of_the_book_links() {
    let mut used = 0;
    for (file, text) in texts() {
        for (at, _) in text.match_indices("geneva_") {
            let rest = &text[at..];
            let name = &rest[..rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len())];
            if rest[name.len()..].starts_with("::") {
                used += 1;
                assert!(
                    geneva_chapters::EXAMPLES.crates.contains(&name),
                    "{file}: add {name} to the crates of the examples"
                );
            }
        }
    }
    assert!(used > 50, "only {used} uses of our crates were found");
}

/// Computed numbers that stand in prose with more digits than the source prints: page, claim, and why.
const MORE_DIGITS: [(&str, &str, &str); 2] = [
    ("pin.md", "pin.follower-speed", "it is what the printed number is compared with"),
    ("quick-return.md", "quick-return.lever-length", "the sentence says that it has more digits"),
];

#[test]
fn no_number_in_prose_has_more_digits_than_its_source_but_for_a_reason() {
    let mut found = Vec::new();
    for (file, text) in chapters() {
        for rest in text.split("{{computed:").skip(1) {
            let id = rest.split("}}").next().expect("its end").to_owned();
            // What is no claim is a number of our own, which no source prints.
            if LEDGER.claim(&id).is_some() {
                found.push((file.clone(), id));
            }
        }
    }
    let allowed = MORE_DIGITS.map(|(file, id, _)| (file.to_owned(), id.to_owned()));
    assert_eq!(found, allowed, "take {{{{printed:…}}}}, or {{{{right:…}}}} where the printed number is not right");
}

#[test]
fn every_figure_is_shown_in_some_chapter() {
    let all: String = chapters().into_iter().map(|(_, text)| text).collect();
    for (name, _) in figures::FIGURES {
        let moved = geneva_live::LIVE.iter().find(|live| live.figure == *name).map_or("none", |live| live.name);
        let ways = [("figure", *name), ("picture", *name), ("live", moved)];
        let shown = ways.iter().any(|(key, name)| all.contains(&format!("{{{{{key}:{name}}}}}")));
        assert!(shown, "{name} is drawn and not shown");
    }
}

#[test]
fn every_number_of_the_lists_is_said_in_some_chapter() {
    let all: String = chapters().into_iter().map(|(_, text)| text).collect();
    for name in computed::names() {
        assert!(all.contains(&format!("{{{{computed:{name}}}}}")), "{name} is computed and not said");
    }
}

#[test]
fn every_question_is_asked_in_some_chapter_and_typed_as_it_is_asked() {
    let all: String = chapters().into_iter().map(|(_, text)| text).collect();
    for name in questions::names() {
        let asks = [format!("{{{{ask:{name}."), format!("{{{{question:{name}}}}}")];
        assert!(asks.iter().any(|placeholder| all.contains(placeholder)), "{name} is stated and not asked");
    }
    let worked = questions::question("worked").expect("a question");
    let words = |text: &str| text.replace('\\', "").split_whitespace().map(str::to_owned).collect::<Vec<_>>().join(" ");
    assert!(words(&all).contains(&words(&worked)), "no chapter has the command {worked}");
}

/// Questions to which every further field has a number.
const ASKED_FOR_ALL: [&str; 2] = [
    "wheel --stations 6 --crank-radius 25 --rpm 60 --inertia 0.002 --friction-torque 0.1 --thickness 10 --density 7800 \
     --pin-material steel --wheel-material steel --pin-friction 0.15 --before-entry 20",
    "escapement --slots 4 --friction 0.2 --torque 2 --driver-inertia 4e-6 --follower-inertia 4e-5 --units in-lb-s \
     --crank-radius 5 --play 0.01 --set-friction 0.3 --pin-radius 0.1",
];

#[test]
fn every_further_field_is_said_in_some_chapter_or_by_some_table_or_figure() {
    let sources = ["crates/chapters/src", "crates/live/src"].map(|folder| crate::files(folder, &[".rs"]));
    let sources: String = sources.into_iter().flatten().map(|(_, text)| text).collect();
    let chapters: String = chapters().into_iter().map(|(_, text)| text).collect();
    for question in ASKED_FOR_ALL {
        for field in geneva_ask::further(question).expect("further fields") {
            let key = field.key;
            assert!(field.number().is_some(), "`{key}` has no number: ask more");
            let is_asked = chapters.contains(&format!(".{key}:")) || chapters.contains(&format!(".{key}}}}}"));
            assert!(is_asked || sources.contains(&format!("\"{key}\"")), "nothing says `{key}`");
        }
    }
}

#[test]
fn every_work_on_the_list_is_cited_and_every_citation_is_on_it() {
    let chapters = chapters();
    let cited = works::check(BOOK.works, chapters.iter().map(|(_, text)| text.as_str()));
    assert!(cited.is_ok(), "{cited:?}");
}

#[test]
fn every_example_says_first_what_it_shows() {
    for (file, text) in texts() {
        let blocks = text.split("\n```rust").skip(1).map(|rest| format!("```rust{rest}"));
        for block in blocks {
            let first = fences::headed(&block).map(|(first, _)| first);
            assert!(
                first.is_some_and(|first| first.ends_with('.')),
                "{file}: {}",
                block.lines().nth(1).unwrap_or_default()
            );
        }
    }
}

#[test]
fn every_slip_is_told_in_some_chapter() {
    // The page of errata draws the grave ones; a chapter must at least speak of one place of each that is not the copy's.
    let all: String = chapters().into_iter().map(|(_, text)| text).collect();
    let told =
        |id: &str| ["erratum", "verdict", "claim"].iter().any(|key| all.contains(&format!("{{{{{key}:{id}}}}}")));
    // A number whose last digits come from rounded steps is told by the table that shows both.
    let tables = || all.split("{{compare:").skip(1).filter_map(|rest| rest.split("}}").next());
    let shown = |id: &str| tables().flat_map(str::split_whitespace).any(|shown| shown == id);
    // What is said elsewhere is told by one placeholder, whole.
    assert!(all.contains("{{elsewhere}}"));
    let of_documents = |places: &&TracedSlip| places.is_mirrored() && places.slip.consequence != Consequence::Copy;
    for places in LEDGER.slips().iter().filter(of_documents) {
        let is_told = |judged: &&geneva_evidence::Judged| {
            told(judged.claim.id) || judged.verdict == Verdict::FromRounded && shown(judged.claim.id)
        };
        assert!(places.claims.iter().any(is_told), "{} is not told", places.slip.id);
        // Without a box on the page of errata, a chapter says what is printed, what is right and why.
        let fold = format!("{{{{erratum:{}}}}}", places.slip.id);
        assert!(BOOK.is_boxed(&places.slip) || all.contains(&fold), "no chapter has {fold}");
    }
}

#[test]
fn every_conclusion_of_the_thesis_is_in_the_table_of_its_conclusions() {
    let (_, chapter) = chapters().into_iter().find(|(file, _)| file == "never-printed.md").expect("the chapter");
    let lines = || chapter.lines().filter(|line| line.starts_with("| "));
    let of_thesis = |judged: &&geneva_evidence::Judged| *judged.claim.document == geneva_documents::MEYER;
    let concluded = geneva_documents::MEYER.conclusions;
    // How many there are is no conclusion.
    let is_count = |id: &str| id == "meyer.three-conclusions";
    let is_conclusion = |judged: &&geneva_evidence::Judged| {
        let id = judged.claim.id;
        judged.claim.locator.starts_with("Conclusion") && !is_count(id) || concluded.iter().any(|(of, _)| *of == id)
    };
    let mut count = 0;
    for judged in LEDGER.verdicts().iter().copied().filter(of_thesis).filter(is_conclusion) {
        let mark = format!("{{{{verdict:{}}}}}", judged.claim.id);
        assert_eq!(lines().filter(|line| line.contains(&mark)).count(), 1, "{}", judged.claim.id);
        count += 1;
    }
    assert!(count >= 6, "{count} conclusions");
    // The recommendations are counted in words, each in a row of its own.
    for number in ["First", "Second", "Third", "Fourth", "Fifth", "Sixth", "Seventh"] {
        assert_eq!(lines().filter(|line| line.starts_with(&format!("| {number}: "))).count(), 1, "{number}");
    }
}
