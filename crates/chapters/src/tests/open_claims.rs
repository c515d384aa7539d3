//! The open claims of this book, by what they lack.

use crate::BOOK;
use crate::open_groups::OPEN_GROUPS;
use geneva_evidence::Truth;
use geneva_press::ledger_pages::open::{fits, has, open_count, open_list};

const PAGE: &str = include_str!("../../../../book/src/open.md");

#[test]
fn every_open_claim_is_in_one_group_and_every_name_of_a_group_is_open() {
    for judged in BOOK.ledger.verdicts().iter().filter(|judged| judged.truth() == Truth::Open) {
        let groups = OPEN_GROUPS.iter().filter(|group| has(group, judged.claim.id)).count();
        assert_eq!(groups, 1, "{} lacks something: say in which group it is", judged.claim.id);
    }
    for group in OPEN_GROUPS {
        for pattern in group.ids {
            let mut named = BOOK.ledger.verdicts().iter().filter(|judged| fits(pattern, judged.claim.id)).peekable();
            assert!(named.peek().is_some(), "no claim is {pattern}");
            assert!(named.all(|judged| judged.truth() == Truth::Open), "{pattern} is not open");
        }
    }
}

#[test]
fn the_page_has_a_section_for_each_group_which_counts_and_lists_it() {
    for group in OPEN_GROUPS {
        let heading = format!("## {} {{#{}}}\n", group.title, group.name);
        let section = PAGE.split_once(&heading).map(|(_, rest)| rest.split("\n## ").next().unwrap_or_default());
        let section = section.unwrap_or_else(|| panic!("the page has no `{heading}`"));
        for part in ["{{open:", "{{open-count:", "**Tried so far.**", "**Still needed.**"] {
            assert!(section.contains(part), "{}: {part}", group.title);
        }
        assert!(section.contains(&format!("{{{{open:{}}}}}", group.name)), "{}", group.title);
    }
    assert_eq!(PAGE.matches("\n## ").count(), OPEN_GROUPS.len());
}

#[test]
fn the_preface_names_what_each_group_lacks() {
    let preface = include_str!("../../../../book/src/preface.md").split_whitespace().collect::<Vec<_>>().join(" ");
    let (_, rest) = preface.split_once("rise times. For the others, ").expect("the sentence");
    let sentence = rest.split_once(" is missing.").map_or("", |(sentence, _)| sentence);
    for group in &OPEN_GROUPS[1..] {
        let word = match group.name {
            "drawings" => "drawing",
            "mimic-of-1973" => "manual",
            "words" => "the meaning of a word",
            "pages-and-sizes" => "value",
            other => panic!("say in the preface what the claims of `{other}` lack"),
        };
        assert!(sentence.contains(word), "{}: {sentence}", group.name);
    }
}

#[test]
fn claims_that_lack_the_same_are_listed_together() {
    let count = |name: &str| open_count(&BOOK, name).expect("claims").parse::<usize>().expect("a number");
    let rises = open_list(&BOOK, "rise-times").expect("a list");
    assert!(rises.contains("<details>") && rises.matches("<li>").count() <= OPEN_GROUPS[0].ids.len(), "{rises}");
    let all: usize = OPEN_GROUPS.iter().map(|group| count(group.name)).sum();
    assert_eq!(all, BOOK.ledger.verdicts().iter().filter(|judged| judged.truth() == Truth::Open).count());
    assert!(open_list(&BOOK, "rises").is_err());
}
