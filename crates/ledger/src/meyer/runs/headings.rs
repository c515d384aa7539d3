//! The moments of inertia above the tables and on the axes of Figs. 10 and 11.
//!
//! Inertias are data. What can be asked is whether the printed results belong to them: among the printed pair, the pair
//! the other way round, and both with a member of half or twice the size, which one makes the results come out best?

use super::cells::leaked;
use super::*;
use crate::Evidence::{Quadrature, RungeKutta};
use crate::meyer::slips::{RESET_ANGLE, SWAPPED_INERTIAS};
use geneva_dynamics::steady::Engagement;
use std::sync::OnceLock;

const UNIT: &str = "× 10^-6 in lb sec²";

/// The members, in the order of the headings.
const MEMBERS: [&str; 2] = ["driver", "follower"];

/// The claims of a table's heading.
pub fn claims(mechanism: Mechanism) -> Vec<Claim> {
    let numbers = match mechanism {
        Mechanism::SIX_PIN => ["10", "6"],
        Mechanism::FOUR_PIN => ["3", "50"],
        _ => ["3", "40"],
    };
    let place = at(leaked(format!("Appendix E, heading of the {}-pin mechanism", mechanism.pins())));
    let of =
        |member: usize| inertia(place, leaked(motion::heading(mechanism, MEMBERS[member])), numbers, mechanism, member);
    let [driver, follower] = [0, 1].map(of);
    match mechanism {
        Mechanism::SIX_PIN => {
            vec![driver.corrected(numbers[1], SWAPPED_INERTIAS), follower.corrected(numbers[0], SWAPPED_INERTIAS)]
        }
        _ => vec![driver, follower],
    }
}

/// The inertia of a member, of the pair that fits best: by the peaks, and by the minima.
fn inertia(place: Place, id: &'static str, numbers: [&'static str; 2], mechanism: Mechanism, member: usize) -> Claim {
    let meaning = leaked(format!("moment of inertia of the {} in the runs, a datum", MEMBERS[member]));
    place
        .value(id, numbers[member], UNIT, meaning)
        .by(Quadrature, move || fitting(mechanism, Column::Peak)[member])
        .by(RungeKutta, move || fitting(mechanism, Column::Minimum)[member])
}

/// What the headings say the tables are of.
pub fn of_headings() -> Claim {
    at("Appendix E, headings of the six-pin and the three-pin mechanism")
        .statement(
            "meyer.app-e.mechanisms",
            "Six Pin Mechanism",
            "the tables for six and three pins are of the mechanisms named above them",
        )
        .by(Quadrature, |stated| {
            counted(&stated.pick(Hypothesis::WITHOUT_LAG, Hypothesis::IDEAL), "minima", 1.0, |of, row| {
                Some(of.engagement(row)?.steady_state().ok()?.minimum.speed - row.number(Column::Minimum))
            })
        })
        .by(RungeKutta, |stated| {
            counted(&stated.pick(Hypothesis::WITHOUT_LAG, Hypothesis::IDEAL), "periods", 1e-3, |of, row| {
                let [_, time, _] = of.cycle_by_steps(row)?;
                Some(time / motion::unit_of_speed(of, row) - row.number(Column::Period))
            })
        })
        .read_as(
            "The runs summed up below a heading, this one and that of three pins, are of the mechanism that it names.",
        )
        .corrected(
            "Six Pin Mechanism, with the driver's angle reset after 90° (and so the Three Pin Mechanism)",
            RESET_ANGLE,
        )
}

/// Whether all rows with six and three pins come out to one unit.
fn counted(of: &Hypothesis, what: &str, unit: f64, off: fn(&Hypothesis, &Row) -> Option<f64>) -> Finding {
    let others = || rows().iter().filter(|row| row.mechanism != Mechanism::FOUR_PIN);
    let near = others().filter(|row| off(of, row).is_some_and(|off| off.abs() <= unit * (1.0 + 1e-9))).count();
    Finding::new(near == others().count(), format!("{near} of {} {what} come out to one unit", others().count()))
}

/// The claims of the axes of Figs. 10 and 11.
pub fn of_figures() -> Vec<Claim> {
    let figures = [("10", ["3", "50"], Mechanism::FOUR_PIN), ("11", ["6", "10"], Mechanism::SIX_PIN)];
    let of = |(figure, numbers, mechanism): (&str, _, _)| {
        let place = at(leaked(format!("Fig. {figure}, upper plot")));
        let ids = MEMBERS.map(|member| leaked(format!("meyer.fig-{figure}.{member}")));
        [0, 1].map(|member| inertia(place, ids[member], numbers, mechanism, member))
    };
    figures.into_iter().flat_map(of).collect()
}

/// The pair of inertias, of those that come into question, that fits a column of a table best, in millionths.
fn fitting(mechanism: Mechanism, column: Column) -> [f64; 2] {
    static KNOWN: [[OnceLock<[f64; 2]>; 2]; 3] = [const { [const { OnceLock::new() }; 2] }; 3];
    *KNOWN[mechanism.index()][usize::from(column == Column::Minimum)].get_or_init(|| best_of(mechanism, column))
}

/// The printed pair, the other way round, and both with a member of half or twice the size.
fn best_of(mechanism: Mechanism, column: Column) -> [f64; 2] {
    let [driver, follower] = MEMBERS.map(|member| printed(&motion::heading(mechanism, member)));
    let around = |[a, b]: [f64; 2]| [[a, b], [a / 2.0, b], [2.0 * a, b], [a, b / 2.0], [a, 2.0 * b]];
    let candidates = [around([driver, follower]), around([follower, driver])].concat();
    let fits = candidates.into_iter().map(|pair| (misfit(mechanism, column, pair), pair));
    fits.min_by(|(a, _), (b, _)| a.total_cmp(b)).map_or([f64::NAN; 2], |(_, pair)| pair)
}

/// Sum of the squares of the relative misfits of a column: of the peaks by the solution over the angle, of the minima
/// in steps. Infinite for inertias with which the equation has no solution.
fn misfit(mechanism: Mechanism, column: Column, pair: [f64; 2]) -> f64 {
    let reset = Hypothesis::WITHOUT_LAG.angle(mechanism);
    let found = |row: &Row| {
        let parameters = motion::parameters_with(row, pair.map(|inertia| inertia * motion::MILLIONTH))?;
        if column == Column::Peak {
            let engagement = Engagement::reset_after(&parameters, reset, 1e-6).ok()?;
            return Some(engagement.steady_state().ok()?.peak.speed);
        }
        let [least, ..] = steps::cycle(&parameters, reset, STEPS)?;
        Some(least * parameters.drive().sqrt())
    };
    let own = rows().iter().filter(|row| row.mechanism == mechanism);
    let off = |row: &Row| found(row).map_or(f64::INFINITY, |found| found / row.number(column) - 1.0);
    own.map(off).map(|off| off * off).sum()
}

/// Steps of an engagement: enough to tell pairs apart of which one has half or twice the other's inertia.
const STEPS: u32 = 150;
