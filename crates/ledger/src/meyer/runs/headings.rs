//! The moments of inertia above the tables and on the axes of Figs. 10 and 11.
//!
//! Inertias are data. What can be asked is whether the printed results belong to them: among the printed pair, the pair
//! the other way round, and both with a member of half or twice the size, which one makes the results come out best?

use super::cells::leaked;
use super::*;
use crate::Evidence::{Integration, Steps};
use crate::meyer::slips::{RESET_ANGLE, SWAPPED_INERTIAS};
use crate::{Entry, Line};
use geneva_dynamics::steady::Engagement;
use std::sync::OnceLock;

const UNIT: &str = "× 10^-6 in lb sec²";

/// The members, in the order of the headings.
const MEMBERS: [&str; 2] = ["driver", "follower"];

/// Both members' checks for a mechanism: the pair that fits, by the peaks and by the minima.
macro_rules! fits {
    ($mechanism:expr) => {
        [
            Check::number(
                (Evidence::Integration, || fitting($mechanism, Column::Peak)[0]),
                (Evidence::Steps, || fitting($mechanism, Column::Minimum)[0]),
            ),
            Check::number(
                (Evidence::Integration, || fitting($mechanism, Column::Peak)[1]),
                (Evidence::Steps, || fitting($mechanism, Column::Minimum)[1]),
            ),
        ]
    };
}

/// The claims of a table's heading.
pub fn claims(mechanism: Mechanism) -> Vec<Claim> {
    let (numbers, checks): ([&'static str; 2], [Check; 2]) = match mechanism {
        Mechanism::SixPin => (["10", "6"], fits!(Mechanism::SixPin)),
        Mechanism::FourPin => (["3", "50"], fits!(Mechanism::FourPin)),
        Mechanism::ThreePin => (["3", "40"], fits!(Mechanism::ThreePin)),
    };
    let place = leaked(format!("Appendix E, heading of the {}-pin mechanism", mechanism.pins()));
    MEMBERS
        .into_iter()
        .zip(numbers.into_iter().zip(checks))
        .map(|(member, (number, check))| {
            let id = leaked(motion::heading(mechanism, member));
            let meaning = leaked(format!("moment of inertia of the {member} in the runs, a datum"));
            let claim = Claim::value(WORK, id, place, meaning, (number, UNIT), check);
            match (mechanism, member) {
                (Mechanism::SixPin, "driver") => swapped(claim, "6"),
                (Mechanism::SixPin, _) => swapped(claim, "10"),
                _ => claim,
            }
        })
        .collect()
}

/// What the headings say the tables are of.
pub fn of_headings() -> Claim {
    let check = Check::corrected_statement(
        (Integration, |stated| {
            counted(&stated.pick(Hypothesis::BEST, Hypothesis::TRUE), "minima", 1.0, |of, row| {
                Some(of.engagement(row)?.steady_state().ok()?.minimum.speed - row.number(Column::Minimum))
            })
        }),
        (Steps, |stated| {
            counted(&stated.pick(Hypothesis::BEST, Hypothesis::TRUE), "periods", 1e-3, |of, row| {
                let [_, time, _] = of.cycle_by_steps(row)?;
                Some(time / motion::unit_of_speed(of, row) - row.number(Column::Period))
            })
        }),
    );
    Claim::statement(
        WORK,
        "meyer.app-e.mechanisms",
        "Appendix E, headings of the six-pin and the three-pin mechanism",
        "the tables for six and three pins are of the mechanisms named above them",
        "Six Pin Mechanism",
        check,
    )
    .read_as("The runs summed up below a heading, this one and that of three pins, are of the mechanism that it names.")
    .expecting(Verdict::Corrected)
    .with_erratum(Erratum {
        corrected: "Six Pin Mechanism, with the driver put back after 90° (and so the Three Pin Mechanism)",
        slip: RESET_ANGLE,
    })
}

/// Whether all rows with six and three pins come out to one unit.
fn counted(of: &Hypothesis, what: &str, unit: f64, off: fn(&Hypothesis, &Row) -> Option<f64>) -> Finding {
    let others = || rows().iter().filter(|row| row.mechanism != Mechanism::FourPin);
    let near = others().filter(|row| off(of, row).is_some_and(|off| off.abs() <= unit * (1.0 + 1e-9))).count();
    Finding::new(near == others().count(), format!("{near} of {} {what} come out to one unit", others().count()))
}

/// The claims of the axes of Figs. 10 and 11.
pub fn of_figures() -> Vec<Claim> {
    let figures = [("10", ["3", "50"], fits!(Mechanism::FourPin)), ("11", ["6", "10"], fits!(Mechanism::SixPin))];
    figures
        .into_iter()
        .flat_map(|(figure, numbers, checks)| {
            MEMBERS.into_iter().zip(numbers.into_iter().zip(checks)).map(move |(member, (number, check))| {
                let id = leaked(format!("meyer.fig-{figure}.{member}"));
                let place = leaked(format!("Fig. {figure}, upper plot"));
                let meaning = leaked(format!("moment of inertia of the {member} in the runs, a datum"));
                Claim::value(WORK, id, place, meaning, (number, UNIT), check)
            })
        })
        .collect()
}

/// The line of the first heading.
const NAMED: u32 = 780;

/// The lines of the headings.
pub fn lines() -> Vec<Line> {
    let claim = |id: &str| Entry::Claim(leaked(id.to_owned()));
    let again = |id: &str| Entry::Again(leaked(id.to_owned()));
    let line = |number: u32, fingerprint, entry: Entry| {
        let unit = Entry::Exception {
            id: leaked(format!("meyer.fig.unit-{number}")),
            numbers: "10 6",
            reason: "the unit of the number before it, printed once more",
        };
        let entries = match (number, entry) {
            (NAMED, entry) => vec![claim("meyer.app-e.mechanisms"), entry],
            (_, Entry::Again(_)) => vec![entry, unit],
            _ => vec![entry],
        };
        Line { number, fingerprint, entries: entries.leak() }
    };
    vec![
        line(476, 0x808d_4231_d03c_1901, claim("meyer.fig-10.driver")),
        line(477, 0x9795_8101_b175_9687, claim("meyer.fig-10.follower")),
        line(495, 0xc084_6427_101c_d2c8, claim("meyer.fig-11.driver")),
        line(496, 0x7fd1_dea1_3259_cc9b, claim("meyer.fig-11.follower")),
        line(NAMED, 0x7fd1_dea1_3259_cc9b, claim("meyer.app-e.6-pin.driver")),
        line(781, 0xc084_6427_101c_d2c8, claim("meyer.app-e.6-pin.follower")),
        line(801, 0x808d_4231_d03c_1901, claim("meyer.app-e.4-pin.driver")),
        line(802, 0x9795_8101_b175_9687, claim("meyer.app-e.4-pin.follower")),
        line(824, 0x808d_4231_d03c_1901, claim("meyer.app-e.3-pin.driver")),
        line(825, 0xaee5_a2d9_145d_df88, claim("meyer.app-e.3-pin.follower")),
        line(485, 0x808d_4231_d03c_1901, again("meyer.fig-10.driver")),
        line(486, 0x9795_8101_b175_9687, again("meyer.fig-10.follower")),
        line(505, 0xc084_6427_101c_d2c8, again("meyer.fig-11.driver")),
        line(506, 0x7fd1_dea1_3259_cc9b, again("meyer.fig-11.follower")),
    ]
}

fn swapped(claim: Claim, corrected: &'static str) -> Claim {
    claim.expecting(Verdict::Corrected).with_erratum(Erratum { corrected, slip: SWAPPED_INERTIAS })
}

/// The pair of inertias, of those that come into question, that fits a column of a table best, in millionths.
fn fitting(mechanism: Mechanism, column: Column) -> [f64; 2] {
    static KNOWN: [[OnceLock<[f64; 2]>; 2]; 3] = [const { [const { OnceLock::new() }; 2] }; 3];
    *KNOWN[mechanism as usize][usize::from(column == Column::Minimum)].get_or_init(|| best_of(mechanism, column))
}

/// The printed pair, the other way round, and both with a member of half or twice the size.
fn best_of(mechanism: Mechanism, column: Column) -> [f64; 2] {
    let [driver, follower] = MEMBERS.map(|member| printed(&motion::heading(mechanism, member)));
    let around = |[a, b]: [f64; 2]| [[a, b], [a / 2.0, b], [2.0 * a, b], [a, b / 2.0], [a, 2.0 * b]];
    let candidates = [around([driver, follower]), around([follower, driver])].concat();
    let fits = candidates.into_iter().map(|pair| (misfit(mechanism, column, pair), pair));
    fits.min_by(|(a, _), (b, _)| a.total_cmp(b)).map_or([f64::NAN; 2], |(_, pair)| pair)
}

/// Sum of the squares of the relative misfits of a column: of the peaks by the solution over the angle, of the minima in
/// steps. Infinite for inertias with which the equation has no solution.
fn misfit(mechanism: Mechanism, column: Column, pair: [f64; 2]) -> f64 {
    let fold = Hypothesis::BEST.angle(mechanism);
    let found = |row: &Row| {
        let parameters = motion::parameters_with(row, pair.map(|inertia| inertia * motion::MILLIONTH))?;
        if column == Column::Peak {
            let engagement = Engagement::folded(&parameters, fold, 1e-6).ok()?;
            return Some(engagement.steady_state().ok()?.peak.speed);
        }
        let [least, ..] = steps::cycle(&parameters, fold, STEPS)?;
        Some(least * parameters.drive().sqrt())
    };
    let own = rows().iter().filter(|row| row.mechanism == mechanism);
    let off = |row: &Row| found(row).map_or(f64::INFINITY, |found| found / row.number(column) - 1.0);
    own.map(off).map(|off| off * off).sum()
}

/// Steps of an engagement: enough to tell pairs apart of which one has half or twice the other's inertia.
const STEPS: u32 = 150;
