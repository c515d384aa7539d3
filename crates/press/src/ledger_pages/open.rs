//! The open claims, by what they lack.

use super::findings::how;
use super::inline::{linked_id, place};
use crate::html::escape;
use crate::lookup::{named, of_documents};
use crate::pages::OPEN;
use geneva_evidence::{Judged, Truth};

/// Claims that the same thing would settle.
#[derive(Clone, Copy)]
pub struct Group {
    /// The anchor of its section on the page of open questions.
    name: &'static str,
    /// The heading of the section.
    title: &'static str,
    /// The ids of its claims; a star stands for any characters.
    ids: &'static [&'static str],
}

/// All groups. The page of open questions says of each what we tried and what would settle it.
const GROUPS: [Group; 5] = [
    Group {
        name: "rise-times",
        title: "What is a rise time?",
        ids: &[
            "meyer.app-e.*.rise",
            "meyer.fig-8.rise",
            "meyer.fig-10.rise-axis",
            "meyer.more-torque",
            "meyer.less-friction",
        ],
    },
    Group {
        name: "drawings",
        title: "Drawings that are not in our copies",
        ids: &[
            "pin.problem-figure",
            "pin.triangle-drawings",
            "quick-return.figure",
            "quick-return.sense-of-sliding",
            "quick-return.lever-acceleration-sense",
            "jazar.fig-5.28-drawing",
            "jazar.fig-5.29-drawing",
            "jazar.fig-5.30",
            "jazar.fig-5.31-drawing",
            "meyer.fig-1",
            "meyer.fig-2",
            "meyer.fig-3",
            "meyer.fig-4",
            "meyer.fig-5",
            "meyer.triangle-drawing",
            "meyer.fig-6",
            "meyer.fig-7",
            "meyer.fig-8",
            "meyer.fig-9",
            "meyer.fig-10",
            "meyer.fig-11",
            "meyer.fig-12",
            "meyer.fig-13",
            "meyer.fig-14",
            "meyer.fig-15",
        ],
    },
    Group {
        name: "mimic-of-1973",
        title: "What the MIMIC of 1973 could do",
        ids: &[
            "meyer.app-b.must-be-solved",
            "meyer.app-b.simultaneous",
            "meyer.app-b.first-seven-cards",
            "meyer.app-b.delay",
            "meyer.listing.delay-third",
            "meyer.app-d.needed",
        ],
    },
    Group {
        name: "words",
        title: "Words without a measure",
        ids: &["jazar.most-stations", "jazar.spherical-locking", "meyer.always-engaged", "meyer.small-variations"],
    },
    Group {
        name: "pages-and-sizes",
        title: "Page numbers and sizes that are not given",
        ids: &["meyer.contents", "meyer.list-of-figures", "meyer.page-of-definition", "meyer.app-c.turns"],
    },
];

impl Group {
    /// A link to its section.
    pub fn link(self) -> String {
        format!("<a href=\"{OPEN}.html#{}\">{}</a>", self.name, escape(self.title))
    }

    fn has(self, id: &str) -> bool {
        self.ids.iter().any(|pattern| fits(pattern, id))
    }
}

fn fits(pattern: &str, id: &str) -> bool {
    match pattern.split_once('*') {
        Some((start, end)) => id.starts_with(start) && id.ends_with(end),
        None => pattern == id,
    }
}

/// The group of an open claim.
pub fn group_of(judged: &Judged) -> Option<Group> {
    let open = judged.truth() == Truth::Open;
    GROUPS.iter().copied().find(|group| open && group.has(judged.claim.id))
}

/// The open claims of the group with this name.
fn claims(name: &str) -> anyhow::Result<Vec<&'static Judged>> {
    let groups = GROUPS.map(|group| (group.name, group));
    let group = named("group of open claims", name, &groups)?;
    Ok(of_documents().filter(|judged| group_of(judged).is_some_and(|of| of.name == group.name)).collect())
}

/// How many open claims the group with this name has.
pub fn count(name: &str) -> anyhow::Result<String> {
    Ok(claims(name)?.len().to_string())
}

/// What a claim says, as a sentence begins.
fn sentence(judged: &Judged) -> String {
    let mut rest = judged.claim.meaning.chars();
    let first = rest.next().into_iter().flat_map(char::to_uppercase);
    escape(&first.chain(rest.clone()).collect::<String>())
}

/// The open claims of a group, those that lack the same thing together.
pub fn list(name: &str) -> anyhow::Result<String> {
    /// Most claims that are named one by one.
    const FEW: usize = 3;
    let mut by_reason: Vec<(String, Vec<&Judged>)> = Vec::new();
    for judged in claims(name)? {
        let reason = how(judged);
        match by_reason.iter_mut().find(|(known, _)| *known == reason) {
            Some((_, all)) => all.push(judged),
            None => by_reason.push((reason, vec![judged])),
        }
    }
    let items = by_reason.iter().map(|(reason, all)| {
        let ids = all.iter().map(|judged| linked_id(judged.claim.id)).collect::<Vec<_>>().join(", ");
        let what = all
            .iter()
            .take(FEW)
            .map(|judged| format!("<strong>{}</strong> ({})", sentence(judged), place(judged.claim)));
        let names = if all.len() > FEW {
            format!("<strong>{}</strong>, in {} places", sentence(all[0]), all.len())
        } else {
            what.collect::<Vec<_>>().join("; ")
        };
        let ids = if all.len() > FEW {
            format!("<details><summary>All {} claims</summary>{ids}</details>", all.len())
        } else {
            format!(" <small>{ids}</small>")
        };
        format!("<li>{names}. {reason}{ids}</li>\n")
    });
    Ok(format!("<ul class=\"open-claims\">\n{}</ul>", items.collect::<String>()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_documents::LEDGER;

    const PAGE: &str = include_str!("../../../../book/src/open.md");

    #[test]
    fn every_open_claim_is_in_one_group_and_every_name_of_a_group_is_open() {
        for judged in LEDGER.verdicts().iter().filter(|judged| judged.truth() == Truth::Open) {
            let groups = GROUPS.iter().filter(|group| group.has(judged.claim.id)).count();
            assert_eq!(groups, 1, "{} lacks something: say in which group it is", judged.claim.id);
        }
        for group in GROUPS {
            for pattern in group.ids {
                let mut named = LEDGER.verdicts().iter().filter(|judged| fits(pattern, judged.claim.id)).peekable();
                assert!(named.peek().is_some(), "no claim is {pattern}");
                assert!(named.all(|judged| judged.truth() == Truth::Open), "{pattern} is not open");
            }
        }
    }

    #[test]
    fn the_page_has_a_section_for_each_group_which_counts_and_lists_it() {
        for group in GROUPS {
            let heading = format!("## {} {{#{}}}\n", group.title, group.name);
            let section = PAGE.split_once(&heading).map(|(_, rest)| rest.split("\n## ").next().unwrap_or_default());
            let section = section.unwrap_or_else(|| panic!("the page has no `{heading}`"));
            for part in ["{{open:", "{{open-count:", "**Tried so far.**", "**Still needed.**"] {
                assert!(section.contains(part), "{}: {part}", group.title);
            }
            assert!(section.contains(&format!("{{{{open:{}}}}}", group.name)), "{}", group.title);
        }
        assert_eq!(PAGE.matches("\n## ").count(), GROUPS.len());
    }

    #[test]
    fn the_preface_names_what_each_group_lacks() {
        let preface = include_str!("../../../../book/src/preface.md").split_whitespace().collect::<Vec<_>>().join(" ");
        let (_, rest) = preface.split_once("claims are rise times. For the others, ").expect("the sentence");
        let sentence = rest.split_once(" is missing.").map_or("", |(sentence, _)| sentence);
        for group in &GROUPS[1..] {
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
        let rises = list("rise-times").expect("a list");
        assert!(rises.contains("<details>") && rises.matches("<li>").count() <= GROUPS[0].ids.len(), "{rises}");
        let all: usize = GROUPS.iter().map(|group| claims(group.name).expect("claims").len()).sum();
        assert_eq!(all, LEDGER.verdicts().iter().filter(|judged| judged.truth() == Truth::Open).count());
        assert!(list("rises").is_err());
    }
}
