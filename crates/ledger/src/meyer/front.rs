//! The tables of contents and of figures, and the figures of the introduction.

use super::*;

const CONTENTS: &str = "Table of contents";
const FIGURES: &str = "List of figures";

/// Page of each part, without its name.
const PAGES_OF_PARTS: &str =
    r"1 \ldots 4 \ldots 15 \ldots 22 \ldots 23 \ldots 24 \ldots 28 \ldots 33 \ldots 34 \ldots 35 \ldots 38 \ldots 39";
/// Number and page of each figure, without its name.
const FIGURES_AND_PAGES: &str = r"1, 2 \ldots 2, 3 \ldots 3, 4 \ldots 4, 5 \ldots 5, 6 \ldots 6, 9 \ldots 7, 10 \ldots 8, 16 \ldots 9, 18 \ldots 10, 19 \ldots 11, 20 \ldots 12, 25 \ldots 13, 26 \ldots 14, 27 \ldots 15, 33";
/// The name of figure 8 on its own page.
const FIGURE_8: &str = "DRIVER AND FOLLOWER ANGULAR VELOCITIES";
/// The name of figure 2 on its own page.
const FIGURE_2: &str = "FOUR PIN MECHANISM";

pub fn claims() -> Vec<Claim> {
    [tables(), names(), mechanisms(), drawings()].concat()
}

fn tables() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "meyer.contents",
            CONTENTS,
            "pages of the twelve parts, from the introduction to the author's life",
            PAGES_OF_PARTS,
            Check::equation(
                (LimitCase, || {
                    let pages = numbers("meyer.contents");
                    Finding::new(
                        pages.len() == 12 && pages.is_sorted_by(|a, b| a < b),
                        "each part begins on a later page than the one before",
                    )
                }),
                (OtherPlaceInSource, figures_stand_in_their_parts),
            ),
        ),
        Claim::figure(
            WORK,
            "meyer.list-of-figures",
            FIGURES,
            "numbers and pages of the fifteen figures",
            FIGURES_AND_PAGES,
            Check::equation(
                (LimitCase, || {
                    let figures = figures_and_pages();
                    let counted = figures.iter().map(|(figure, _)| *figure).eq(1..=15);
                    Finding::new(
                        counted && figures.is_sorted_by(|a, b| a.1 < b.1),
                        "figures are counted without a gap, each on a later page",
                    )
                }),
                (OtherPlaceInSource, figures_stand_in_their_parts),
            ),
        ),
    ]
}

fn names() -> Vec<Claim> {
    vec![
        Claim::figure(
            WORK,
            "meyer.list.fig-2",
            "List of figures, Fig. 2",
            "name of figure 2, which has another on its page",
            "GENEVA MECHANISM",
            Check::corrected_equation(
                (OtherPlaceInSource, || on_its_page(printed_characters("meyer.list.fig-2"), FIGURE_2)),
                || on_its_page(FIGURE_2, FIGURE_2),
                (OtherPlaceInSource, || {
                    let scales = ["meyer.fig-2", "meyer.fig-12"].map(numbers);
                    Finding::new(
                        scales[0] == scales[1] && !scales[0].is_empty(),
                        "figure 12, of four pins and four slots, is drawn to the same scale",
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: FIGURE_2,
            slip: Slip {
                id: "",
                reason: "The page names the mechanism by its pins. All figures of mechanisms \
                    show a Geneva mechanism, so that the name in the list tells nothing.",
                witness: "The scale is that of figure 12, which is of four pins.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        Claim::figure(
            WORK,
            "meyer.list.fig-8",
            "List of figures, Fig. 8",
            "quantity in figure 8; a word of the name on its page is missing",
            "DRIVER AND FOLLOWER VELOCITIES",
            Check::corrected_equation(
                (OtherPlaceInSource, || on_its_page(printed_characters("meyer.list.fig-8"), FIGURE_8)),
                || on_its_page(FIGURE_8, FIGURE_8),
                (OtherPlaceInSource, || {
                    let rates = printed_characters("meyer.eq-1-7");
                    Finding::new(
                        rates.starts_with(r"\dot{\phi}") && rates.ends_with(r"\dot{\theta}"),
                        "Eq. (1-7) relates the rates of two angles",
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: FIGURE_8,
            slip: Slip {
                id: "",
                reason: "The list leaves out that the velocities are angular; the page has the word.",
                witness: "The velocities of driver and follower that Eq. (1-7) relates are rates of angles.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
    ]
}

fn mechanisms() -> Vec<Claim> {
    let combination = |id, locator, meaning, printed, listed: fn() -> Finding, counted: fn() -> Finding| {
        Claim::figure(
            WORK,
            id,
            locator,
            meaning,
            printed,
            Check::equation((OtherPlaceInSource, listed), (LimitCase, counted)),
        )
    };
    vec![
        combination(
            "meyer.list.fig-12",
            "List of figures, Fig. 12",
            "the mechanism of figure 12",
            "FOUR PIN / FOUR SLOT",
            || in_the_table("meyer.list.fig-12"),
            || fill_a_quarter("meyer.list.fig-12"),
        ),
        combination(
            "meyer.list.fig-13",
            "List of figures, Fig. 13",
            "the mechanism of figure 13, which its page names by the pins alone",
            "SIX PIN / THREE SLOT",
            || in_the_table("meyer.list.fig-13"),
            || fill_a_quarter("meyer.list.fig-13"),
        ),
        combination(
            "meyer.list.fig-14",
            "List of figures, Fig. 14",
            "the mechanism of figure 14, which its page names by the pins alone",
            "THREE PIN / SIX SLOT",
            || in_the_table("meyer.list.fig-14"),
            || fill_a_quarter("meyer.list.fig-14"),
        ),
    ]
}

fn drawings() -> Vec<Claim> {
    vec![
        Claim::figure(
            WORK,
            "meyer.fig-1",
            "Fig. 1",
            "the escapement that is to be replaced",
            "RUNAWAY ESCAPEMENT",
            Check::Missing { reason: "The drawing is not in the copy, and nothing is computed from it" },
        )
        .expecting(Verdict::NotReproducible),
        Claim::figure(
            WORK,
            "meyer.fig-2",
            "Fig. 2",
            "scale of the drawing of the four-pin mechanism",
            "SCALE: 2 1/2 to 1",
            Check::Missing {
                reason: "The drawing is not in the copy, so that there is no length to hold a rule against",
            },
        )
        .expecting(Verdict::NotReproducible),
    ]
}

/// The figures of the list, each with its page.
fn figures_and_pages() -> Vec<(u32, u32)> {
    numbers("meyer.list-of-figures").chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
}

/// Whether each figure's page is in the part of the source that the figure belongs to.
fn figures_stand_in_their_parts() -> Finding {
    // Introduction, chapters I and II, appendices A and C: which row of the contents, and its first and last figure.
    let parts = [(0, 1, 2), (1, 3, 7), (2, 8, 11), (5, 12, 14), (7, 15, 15)];
    let (pages, figures) = (numbers("meyer.contents"), figures_and_pages());
    let stands = |(figure, page): &(u32, u32)| {
        parts.iter().any(|&(row, first, last)| {
            let part = pages.get(row).zip(pages.get(row + 1));
            // A figure may stand on the page on which the next part begins.
            (first..=last).contains(figure) && part.is_some_and(|(begin, next)| (begin..=next).contains(&page))
        })
    };
    let holds = !figures.is_empty() && figures.iter().all(stands);
    Finding::new(holds, "each figure's page is in the part that the figure belongs to")
}

fn printed_characters(id: &str) -> &'static str {
    claim(id).map_or("", |claim| claim.printed)
}

/// Whether the list's name for a figure is the one on the figure's page.
fn on_its_page(list: &str, page: &str) -> Finding {
    Finding::new(list == page, format!("the page has “{page}”"))
}

/// Pins and slots as a name in the list of figures says them.
fn pins_and_slots(id: &str) -> Option<(u32, u32)> {
    let count = |word: &str| match word {
        "THREE" => Some(3),
        "FOUR" => Some(4),
        "SIX" => Some(6),
        _ => None,
    };
    let (pins, slots) = printed_characters(id).split_once(" PIN / ")?;
    Some((count(pins)?, count(slots.strip_suffix(" SLOT")?)?))
}

/// Whether the table of the possible combinations has it.
fn in_the_table(id: &str) -> Finding {
    let rows = combinations::TABLE.map(|(slots, pins)| (printed(pins) as u32, printed(slots) as u32));
    let asked = pins_and_slots(id);
    Finding::new(asked.is_some_and(|pair| rows.contains(&pair)), "the table after Eq. (1-3) has this combination")
}

/// Whether the angles π/m and π/n make a quarter turn.
fn fill_a_quarter(id: &str) -> Finding {
    let holds = pins_and_slots(id).is_some_and(|(pins, slots)| 2 * (pins + slots) == pins * slots);
    Finding::new(holds, "π/m and π/n make a quarter turn")
}
