//! The tables of contents and of figures, and the figures of the introduction.

use super::hand_over::Drawn;
use super::*;
use crate::stated::in_words;

const CONTENTS: Place = at("Table of contents");
const FIGURES: Place = at("List of figures");

/// Page of each part, without its name.
const PAGES_OF_PARTS: &str = concat!(
    r"1 \ldots 4 \ldots 15 \ldots 22 \ldots 23 \ldots 24 \ldots 28 \ldots 33 \ldots 34 ",
    r"\ldots 35 \ldots 38 \ldots 39"
);
/// Number and page of each figure, without its name.
const FIGURES_AND_PAGES: &str = concat!(
    r"1, 2 \ldots 2, 3 \ldots 3, 4 \ldots 4, 5 \ldots 5, 6 \ldots 6, 9 \ldots 7, 10 ",
    r"\ldots 8, 16 \ldots 9, 18 \ldots 10, 19 \ldots 11, 20 \ldots 12, 25 \ldots 13, 26 ",
    r"\ldots 14, 27 \ldots 15, 33"
);
pub fn claims() -> Vec<Claim> {
    [tables(), mechanisms(), drawings()].concat()
}

fn tables() -> Vec<Claim> {
    vec![
        CONTENTS
            .statement(
                "meyer.contents",
                PAGES_OF_PARTS,
                "pages of the twelve parts, from the introduction to the author's life, in order",
            )
            .missing(WITHOUT_PAGES),
        FIGURES
            .figure("meyer.list-of-figures", FIGURES_AND_PAGES, "numbers and pages of the fifteen figures")
            .missing(WITHOUT_PAGES),
    ]
}

/// Why the two lists of pages are open.
const WITHOUT_PAGES: &str = "The copy has no page numbers to hold the list against. The pages rise, and each figure's page is \
                             in the part that the figure belongs to; with many a next page they would do so too";

fn mechanisms() -> Vec<Claim> {
    let combination =
        |id, locator, meaning, printed, neighbour, table: fn(Stated) -> Finding, drawn: fn(Stated) -> _| {
            at(locator).figure(id, printed, meaning).by(OtherPlaceInSource, table).by(Vectors, drawn).but_not(neighbour)
        };
    vec![
        combination(
            "meyer.list.fig-12",
            "List of figures, Fig. 12",
            "the mechanism of figure 12",
            "FOUR PIN / FOUR SLOT",
            "four pins and five slots",
            in_the_table,
            right_at_the_pin,
        ),
        combination(
            "meyer.list.fig-13",
            "List of figures, Fig. 13",
            "the mechanism of figure 13, which its page names by the pins alone",
            "SIX PIN / THREE SLOT",
            "six pins and four slots",
            in_the_table,
            right_at_the_pin,
        ),
        combination(
            "meyer.list.fig-14",
            "List of figures, Fig. 14",
            "the mechanism of figure 14, which its page names by the pins alone",
            "THREE PIN / SIX SLOT",
            "three pins and seven slots",
            in_the_table,
            right_at_the_pin,
        ),
    ]
}

fn drawings() -> Vec<Claim> {
    vec![
        at("Fig. 1")
            .figure("meyer.fig-1", "RUNAWAY ESCAPEMENT", "the escapement that is to be replaced")
            .missing("The drawing is not in the copy, and nothing is computed from it"),
        at("Fig. 2")
            .figure("meyer.fig-2", "SCALE: 2 1/2 to 1", "scale of the drawing of the four-pin mechanism")
            .missing("The drawing is not in the copy, so that there is no length to hold a rule against"),
    ]
}

/// The figures of the list, each with its page.
fn figures_and_pages() -> Vec<(u32, u32)> {
    numbers("meyer.list-of-figures").chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
}

/// The claim on the page where the average terminal velocity is defined. The figures before and after it fill a page
/// each.
pub fn page_of_definition() -> Claim {
    at("Recommendation 7")
        .statement("meyer.page-of-definition", "page 17", "page of the definition of the average terminal velocity")
        .by(OtherPlaceInSource, |stated| {
            let page = |figure: u32| figures_and_pages().iter().find(|row| row.0 == figure).map(|row| row.1);
            let [before, after] = [page(8), page(9)].map(Option::unwrap_or_default);
            let said = said_page(stated);
            Finding::new(
                (before + 1..after).contains(&said),
                format!("Fig. 8 is on page {before}, Fig. 9 on page {after}; said is {said}"),
            )
        })
        .by(LimitCase, |stated| {
            let (pages, before) = (pages_of_text(), figures_before("meyer.fig-8.rise").unwrap_or(usize::MAX));
            Finding::new(
                pages.get(before) == Some(&said_page(stated)),
                format!("text is on the pages {pages:?} of chapter II; figures before the definition: {before}"),
            )
        })
        .but_not("the page after")
}

/// The page that is said, or the next.
fn said_page(stated: Stated) -> u32 {
    stated.count() + stated.pick(0, 1)
}

/// The pages of chapter II that have no figure.
fn pages_of_text() -> Vec<u32> {
    let [begin, end] = [2, 3].map(|row| numbers("meyer.contents").get(row).copied().unwrap_or_default());
    let figures: Vec<_> = figures_and_pages().iter().map(|row| row.1).collect();
    (begin..end).filter(|page| !figures.contains(page)).collect()
}

/// How many figures of chapter II stand before a claim: so many stretches of text end before it.
fn figures_before(id: &str) -> Option<usize> {
    let lines = Work::Meyer1973.inventory().ok()?;
    let line = |id: &str| {
        let makes = |line: &&crate::Line| line.entries.iter().any(|entry| entry.claimed() == Some(id));
        lines.iter().find(makes).map(|line| line.number)
    };
    let of = line(id)?;
    let figures = ["meyer.fig-8", "meyer.fig-9", "meyer.fig-10", "meyer.fig-11"].map(line);
    figures.iter().all(Option::is_some).then(|| figures.iter().flatten().filter(|figure| **figure < of).count())
}

/// Pins and slots in a text that names mechanisms by them, in the order of the text.
pub fn pins_and_slots(text: &str) -> Vec<(u32, u32)> {
    let words: Vec<_> = text.split_whitespace().map(str::to_uppercase).collect();
    let count = |word: &str| in_words(word).map(|number| number as u32);
    let of = |pair: &[String]| match pair {
        [pins, pin, slash, slots, slot] if pin == "PIN" && slash == "/" && slot == "SLOT" => {
            Some((count(pins)?, count(slots)?))
        }
        _ => None,
    };
    words.windows(5).filter_map(of).collect()
}

/// The one mechanism that a name in the list of figures says, or that with a slot more.
fn named(stated: Stated) -> Option<(u32, u32)> {
    pins_and_slots(stated.characters()).first().map(|(pins, slots)| (*pins, slots + stated.pick(0, 1)))
}

/// Whether the table of the possible combinations has it.
fn in_the_table(stated: Stated) -> Finding {
    let rows = combinations::TABLE.map(|(slots, pins)| (printed(pins) as u32, printed(slots) as u32));
    let Some(asked) = named(stated) else { return Finding::new(false, "the name cannot be read") };
    Finding::new(
        rows.contains(&asked),
        format!("{} pins and {} slots; the table after Eq. (1-3) has {rows:?}", asked.0, asked.1),
    )
}

/// Whether crank and slot are at right angles at the hand-over, as the drawings are said to show.
fn right_at_the_pin(stated: Stated) -> Finding {
    let across = named(stated).map_or(f64::NAN, |(pins, slots)| {
        let drawn = Drawn::new(pins, slots);
        drawn.place(drawn.half()).normalize().perp(&Drawn::velocity(drawn.half()))
    });
    Finding::new(vanishes(across), format!("across the slot the leaving pin moves at {across:.3} of its speed"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pages_of_both_lists_rise_and_agree_as_far_as_they_can_be_compared() {
        let (pages, figures) = (numbers("meyer.contents"), figures_and_pages());
        assert!(pages.len() == 12 && pages.is_sorted_by(|a, b| a < b), "{pages:?}");
        assert!(figures.iter().map(|(figure, _)| *figure).eq(1..=15), "{figures:?}");
        assert!(figures.is_sorted_by(|a, b| a.1 < b.1), "{figures:?}");
        // Introduction, chapters I and II, appendices A and C: which row of the contents, and its first and last figure.
        let parts = [(0, 1, 2), (1, 3, 7), (2, 8, 11), (5, 12, 14), (7, 15, 15)];
        for (figure, page) in figures {
            // A figure may stand on the page on which the next part begins.
            let stands = |&(row, first, last): &(usize, u32, u32)| {
                (first..=last).contains(&figure) && (pages[row]..=pages[row + 1]).contains(&page)
            };
            assert!(parts.iter().any(stands), "{figure} on {page}");
        }
    }
}
