//! Of what is said elsewhere: how many pages and programs, how many statements are right and wrong, how many examples that
//! are built, and by how much a formula is wrong.

use super::kinds::OUTLINES;
use super::second_routes::outline::Cut;
use super::{least, most};
use crate::{figures, lookup};
use anyhow::Context;
use geneva_documents::{WILD, wild};
use geneva_evidence::OwnNumber;
use geneva_evidence::{Evidence, Judged, Kind, Truth};
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// The numbers of the chapter.
pub(super) fn numbers() -> Vec<OwnNumber> {
    vec![
        OwnNumber::count("wild.addresses", || Ok(addresses(|_| true))),
        OwnNumber::count("wild.addresses-whole", || Ok(addresses(is_of_a_page_taken_whole))),
        OwnNumber::count("wild.addresses-wrong", || Ok(addresses(|judged| is_statement(judged) && is_wrong(judged)))),
        OwnNumber::count("wild.statements", || Ok(count(is_statement))),
        OwnNumber::count("wild.right", || Ok(count(|judged| is_statement(judged) && judged.truth() == Truth::Right))),
        OwnNumber::count("wild.wrong", || Ok(count(|judged| is_statement(judged) && is_wrong(judged)))),
        OwnNumber::count("wild.copy", || Ok(count(|judged| is_statement(judged) && judged.is_miscopied()))),
        OwnNumber::count("wild.examples", || Ok(count(|judged| !is_statement(judged)))),
        OwnNumber::count("wild.examples-wrong", || Ok(count(|judged| !is_statement(judged) && is_wrong(judged)))),
        bite("wild.bite.least", least),
        bite("wild.bite.most", most),
        error_factor("wild.move.six", "{.0}", "wild.firgelli-time.index", 6, move_quotient),
        error_factor("wild.move.eight", "{.0}", "wild.firgelli-time.index", 8, move_quotient),
        error_factor("wild.centres.six", "{.1}", "wild.firgelli-time.centres", 6, centres_quotient),
    ]
}

fn claims_elsewhere() -> impl Iterator<Item = &'static Judged> {
    lookup::of_work(&WILD)
}

/// Whether it is stated, and not only built as an example.
fn is_statement(judged: &Judged) -> bool {
    judged.claim.kind != Kind::Example
}

/// Whether the page is wrong, and not only the copy that we read.
fn is_wrong(judged: &Judged) -> bool {
    judged.truth() == Truth::Wrong && !judged.is_miscopied()
}

/// Whether it is on a page of which every formula was taken.
fn is_of_a_page_taken_whole(judged: &Judged) -> bool {
    wild::read(judged.claim.locator).is_some_and(|(address, _)| wild::is_taken_whole(address))
}

/// How many pages and programs have such a statement or example.
fn addresses(such: impl Fn(&Judged) -> bool) -> usize {
    let read = claims_elsewhere().filter(|judged| such(judged)).filter_map(|judged| wild::read(judged.claim.locator));
    read.map(|(address, _)| address).collect::<BTreeSet<_>>().len()
}

fn count(such: impl Fn(&Judged) -> bool) -> usize {
    claims_elsewhere().filter(|judged| such(judged)).count()
}

/// How deep the horns come into the disc in the figure of the cuts, with a cut of the wheel's radius, in hundredths of the centre
/// distance: the least or the greatest depth over its numbers of slots. With the other cut they must stay clear.
fn bite(id: &'static str, end: fn(&[f64]) -> f64) -> OwnNumber {
    OwnNumber::new(id, "{.1}", OUTLINES, move || {
        let rows = figures::by_name("locking-cuts")?.series.rows;
        if !rows.iter().all(|row| row[1] < 0.0 && row[2] > 0.0) {
            return Err("the first cut bites and the second one does not".into());
        }
        Ok(end(&rows.iter().map(|row| -row[1]).collect::<Vec<_>>()))
    })
    .with_second_route("a cut of the wheel's radius bites", OUTLINES, move || {
        let slots = figures::by_name("locking-cuts")?.series.rows.into_iter().map(|row| row[0]);
        Ok(end(&slots.map(depth_by_places).collect::<Vec<_>>()))
    })
}

/// Radius of the figure's disc in crank radii.
const DISC: f64 = 0.7;

/// How deep a horn comes into a disc with a cut of the wheel's radius about its axis, for a slot and a pin without thickness.
fn depth_by_places(slots: f64) -> f64 {
    let (sine, cosine) = (PI / slots).sin_cos();
    let (centre_distance, rim) = (1.0 / sine, cosine / sine);
    let cut = Cut {
        slots,
        centre_distance,
        crank_radius: 1.0,
        rim,
        arc: DISC,
        disc: DISC,
        centre: centre_distance,
        radius: rim,
    };
    -100.0 * cut.least_gap() / centre_distance
}

/// What a wrong formula gives over what is right, or the other way round if that is less than one: by reading both formulas, and by
/// a quotient of our own.
fn error_factor(
    id: &'static str,
    form: &'static str,
    formula: &'static str,
    slots: u32,
    quotient: fn(f64) -> f64,
) -> OwnNumber {
    let size = |ratio: f64| ratio.max(1.0 / ratio);
    OwnNumber::new(id, form, Evidence::CLOSED_FORM, move || {
        Ok(size(wild::ratio(formula, slots).with_context(|| format!("`{formula}` gives no ratio"))?))
    })
    .with_second_route("the formula is so far off", Evidence::CLOSED_FORM, move || Ok(size(quotient(f64::from(slots)))))
}

/// A turn of the wheel over a move, 1/n, over that of the driver, (n − 2)/(2 n).
fn move_quotient(slots: f64) -> f64 {
    2.0 / (slots - 2.0)
}

/// The centre distance for a wheel radius with the sine of half the angle between two slots for the cosine, over the right one.
fn centres_quotient(slots: f64) -> f64 {
    1.0 / (PI / slots).tan()
}
