//! The tables of contents and of figures, and the figures of the introduction.

use super::hand_over::Drawn;
use super::*;
use geneva_evidence::number_in_word;

const CONTENTS: Locator = at("Table of contents");
const FIGURES: Locator = at("List of figures");

/// Page of each part, without its name.
const PAGES_OF_PARTS: &str = concat!(
    r"1 \ldots 4 \ldots 15 \ldots 22 \ldots 23 \ldots 24 \ldots 28 \ldots 33 \ldots 34 ",
    r"\ldots 35 \ldots 38 \ldots 39"
);
/// Number and page of each figure, without its name; with dots between them where the name says the number of pins.
const FIGURES_AND_PAGES: &str = concat!(
    r"1, 2 \ldots 2, 3 \ldots 3, 4 \ldots 4, 5 \ldots 5, 6 \ldots 6, 9 \ldots 7, 10 ",
    r"\ldots 8 \ldots 16 \ldots 9 \ldots 18 \ldots 10 \ldots 19 \ldots 11 \ldots 20 \ldots 12 \ldots 25 ",
    r"\ldots 13 \ldots 26 \ldots 14 \ldots 27 \ldots 15, 33"
);
pub(super) fn claims() -> Vec<Claim> {
    [tables(), mechanisms(), drawings()].concat()
}

fn tables() -> Vec<Claim> {
    vec![
        CONTENTS
            .statement("meyer.contents", PAGES_OF_PARTS, "page numbers of the twelve parts, in order")
            .missing(WITHOUT_PAGES),
        FIGURES
            .figure("meyer.list-of-figures", FIGURES_AND_PAGES, "numbers and pages of the fifteen figures")
            .missing(WITHOUT_PAGES),
    ]
}

/// Why the two lists of pages are open.
const WITHOUT_PAGES: &str = "The copy we had has no page numbers to compare the list with. The listed page numbers \
                             rise, and each figure's page is in the part that the figure belongs to. But both \
                             statements would still hold if many of the page numbers were one higher";

/// The names of figures 12 to 14 in the list, each with its claim and its place.
const DRAWN: [(&str, &str, &str, &str); 3] = [
    ("meyer.list.fig-12", "List of figures, Fig. 12", "the mechanism of figure 12", "FOUR PIN / FOUR SLOT"),
    ("meyer.list.fig-13", "List of figures, Fig. 13", "the mechanism of figure 13", "SIX PIN / THREE SLOT"),
    ("meyer.list.fig-14", "List of figures, Fig. 14", "the mechanism of figure 14", "THREE PIN / SIX SLOT"),
];

fn mechanisms() -> Vec<Claim> {
    let of = |which: usize| {
        let (id, locator, meaning, printed) = DRAWN[which];
        at(locator)
            .figure(id, printed, meaning)
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, move |stated| has_its_angles(stated, which))
            .second_route(Evidence::VECTORS, move |stated| has_its_distance(stated, which))
            .but_not("the mechanism of the next of the three drawings")
            .interpreted_as(
                "In an order of its own, Appendix A computes the sizes for the drawings, which come after it. We take \
                 its first computation for the first drawing.",
            )
    };
    (0..DRAWN.len()).map(of).collect()
}

fn drawings() -> Vec<Claim> {
    vec![
        at("Fig. 1")
            .figure("meyer.fig-1", "RUNAWAY ESCAPEMENT", "the escapement that is to be replaced")
            .missing("The copy we had does not contain the drawing, and nothing is computed from it"),
        at("Fig. 2")
            .figure("meyer.fig-2", "SCALE: 2 1/2 to 1", "scale of the drawing of the four-pin mechanism")
            .missing("The copy we had does not contain the drawing, so there is no length to measure"),
    ]
}

/// The claim on the page where the average terminal velocity is defined.
pub(super) fn page_of_definition() -> Claim {
    at("Recommendation 7")
        .statement("meyer.page-of-definition", "page 17", "page of the definition of the average terminal velocity")
        .missing(
            "The copy we had has no page numbers. By the lists of the thesis, whose page numbers we cannot compare with \
             anything either, the definition is between the figures of pages 16 and 18, so the page given agrees with \
             them",
        )
}

/// Pins and slots in a text that names mechanisms by them, in the order of the text.
pub(super) fn pins_and_slots(text: &str) -> Vec<(u32, u32)> {
    let words: Vec<_> = text.split_whitespace().map(str::to_uppercase).collect();
    let count = |word: &str| number_in_word(word).map(|number| number as u32);
    let of = |pair: &[String]| match pair {
        [pins, pin, slash, slots, slot] if pin == "PIN" && slash == "/" && slot == "SLOT" => {
            Some((count(pins)?, count(slots)?))
        }
        _ => None,
    };
    words.windows(5).filter_map(of).collect()
}

/// The mechanism that the list of figures says of one of the drawings, or wrongly of the next of them.
fn named(stated: Stated, which: usize) -> Option<(u32, u32)> {
    let text = stated.pick(stated.characters(), DRAWN[(which + 1) % DRAWN.len()].3);
    pins_and_slots(text).first().copied()
}

/// What Appendix A computes for its mechanisms, in its order: half the angle between two pins and between two slots, in
/// degrees, and the distance of the axes.
pub(super) fn computed_sizes() -> Vec<[f64; 3]> {
    let lines = MEYER.lines().unwrap_or_default();
    let claimed = lines.iter().flat_map(|line| &line.entries).filter_map(geneva_evidence::Entry::claimed);
    let own = claimed.filter_map(|id| id.strip_prefix("meyer.app-a.")?.strip_suffix(".theta"));
    let number = |id: String| MEYER.printed_number(&id);
    own.map(|own| ["theta", "phi", "centre"].map(|size| number(format!("meyer.app-a.{own}.{size}")))).collect()
}

/// Whether it has the angles that Appendix A computes for this drawing.
fn has_its_angles(stated: Stated, which: usize) -> Finding {
    let (Some((pins, slots)), Some([theta, phi, _])) = (named(stated, which), computed_sizes().get(which).copied())
    else {
        return Finding::not_evaluated("the name or the sizes cannot be read");
    };
    Finding::new(
        agrees(theta * f64::from(pins), 180.0) && agrees(phi * f64::from(slots), 180.0),
        format!(
            "the figure has {pins} pins and {slots} slots, and the angles of computation {} are {theta}° and {phi}°",
            which + 1
        ),
    )
}

/// Whether its pin leaves in the direction of a slot with the axes as far apart as Appendix A has them for this drawing.
fn has_its_distance(stated: Stated, which: usize) -> Finding {
    // The distances have three decimals, of which one set is wrong in the last: that turns the direction by 0.1°.
    const NEAR: f64 = 0.5;
    let (Some((pins, slots)), Some([_, _, axis])) = (named(stated, which), computed_sizes().get(which).copied()) else {
        return Finding::not_evaluated("the name or the sizes cannot be read");
    };
    let drawn = Drawn { pins, slots, axis };
    let [direction, slot] = [drawn.direction(drawn.half()).to_degrees(), 180.0 / f64::from(slots)];
    Finding::new(
        (direction - slot).abs() < NEAR,
        format!("the pin leaves at {direction:.1}° from the follower's axis, where the slot is at {slot:.1}°"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The figures of the list, each with its page.
    fn figures_and_pages() -> Vec<(u32, u32)> {
        MEYER.printed_integers("meyer.list-of-figures").chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
    }

    /// The lines of the source that make these claims.
    fn lines_of<const N: usize>(ids: [&str; N]) -> [u32; N] {
        let lines = MEYER.lines().expect("an inventory");
        ids.map(|id| {
            let makes = |line: &&geneva_evidence::Line| line.entries.iter().any(|entry| entry.claimed() == Some(id));
            lines.iter().find(makes).expect("a line").number
        })
    }

    #[test]
    fn the_page_of_the_definition_agrees_with_the_list_of_figures() {
        let page = |figure: u32| figures_and_pages().iter().find(|row| row.0 == figure).expect("a figure").1;
        let said = MEYER.printed_integers("meyer.page-of-definition");
        assert_eq!((page(8), page(9), &said[..]), (16, 18, &[17][..]));
        let [before, definition, after] = lines_of(["meyer.fig-8", "meyer.fig-8.rise", "meyer.fig-9"]);
        assert!(before < definition && definition < after);
    }

    #[test]
    fn the_pages_of_both_lists_rise_and_agree_as_far_as_they_can_be_compared() {
        let (pages, figures) = (MEYER.printed_integers("meyer.contents"), figures_and_pages());
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
