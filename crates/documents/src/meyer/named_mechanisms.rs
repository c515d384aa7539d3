//! The mechanisms that figures and tables are named after: in the list of figures, on the figures' own pages and above the
//! second table of Appendix E.

use super::front::computed_sizes;
use super::peaks::PEAKS;
use super::runs::data;
use super::runs::table::{UNIT, rows, units_in_one};
use super::*;
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use geneva_case1973::witness::steps::cycle_of_row;
use geneva_case1973::{Column, Hypothesis, Row};
use geneva_evidence::numbers_in;
use geneva_kinematics::escapement::pins_needed;

pub(super) fn claims() -> Vec<Claim> {
    [figure_of_speeds(), figures_of_rise_times(), drawings(), vec![table_of_four_pins()]].concat()
}

/// The escapement with so many pins.
fn with_pins(pins: u32) -> Option<Mechanism> {
    Mechanism::ALL.into_iter().find(|at| at.pins() == pins)
}

/// The first number in the characters of the claim with this id.
fn first_number(id: &str) -> f64 {
    numbers_in(MEYER.printed_text(id)).first().map_or(f64::NAN, |(_, number)| *number)
}

fn figure_of_speeds() -> Vec<Claim> {
    vec![
        at("List of figures, Fig. 8")
            .figure("meyer.list.fig-8", "FOUR PIN", "the mechanism of figure 8 has four pins")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                same(360.0 / stated.pick(stated.number(), 6.0), MEYER.printed_number("meyer.fig-8.quarter"))
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                let pins = pins_needed(first_number("meyer.fig-8.slots") as u32);
                same(stated.pick(stated.number(), 6.0), pins.map_or(f64::NAN, |pins| pins.approximate()))
            })
            .but_not("it has six pins"),
        PEAKS
            .statement(
                "meyer.fig-8.slots",
                "four slot",
                "the printed angle between two peaks belongs to the mechanism with four slots",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let letters = reading::by_name([("n", stated.pick(stated.number(), 6.0))]);
                let pins = reading::value(MEYER.right_side("meyer.eq-1-3"), &letters);
                same(360.0 / pins, MEYER.printed_number("meyer.fig-8.quarter"))
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                let slots = stated.pick(stated.count(), 6);
                let at = Mechanism::ALL.into_iter().find(|at| at.slots() == slots);
                let between = at.map_or(f64::NAN, |at| 2.0 * at.engagement_half_angle().to_degrees());
                let holds = MEYER.prints_rounding_of("meyer.fig-8.quarter", between);
                Finding::new(holds, format!("between two pins there are {between:.0}°"))
            })
            .but_not("it belongs to six slots"),
    ]
}

/// Figures 10 and 11 by the inertias that are printed in them. Nothing of figure 9 is in the copy.
fn figures_of_rise_times() -> Vec<Claim> {
    let of = |id, locator, printed, meaning, figure: [&'static str; 2], other: u32| {
        at(locator)
            .figure(id, printed, meaning)
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, move |stated| {
                let mut drawn = figure.map(|id| MEYER.printed_text(id));
                let how = format!(
                    "the figure gives the inertias {} of the driver and {} of the follower",
                    drawn[0], drawn[1]
                );
                let at = with_pins(stated.pick(stated.count(), other));
                let headed = at.map(|at| {
                    let mut headed = ["driver", "follower"]
                        .map(|member| MEYER.printed_text(&format!("meyer.app-e.{}-pin.{member}", at.pins())));
                    headed.sort_unstable();
                    headed
                });
                drawn.sort_unstable();
                Finding::new(headed == Some(drawn), format!("{how}, which we compared with the table's heading"))
            })
            .second_route(QUADRATURE, move |stated| {
                let found = with_pins(stated.pick(stated.count(), other)).map(data::inertias);
                let found = found.unwrap_or([f64::NAN; 2]).map(|inertia| inertia * units_in_one(UNIT));
                Finding::new(
                    figure.iter().zip(found).all(|(id, inertia)| MEYER.prints_rounding_of(id, inertia)),
                    format!("the table is best reproduced with the inertias {:.1} and {:.1}", found[0], found[1]),
                )
            })
            .but_not("it is the other of the two mechanisms")
            .interpreted_as("The inertias above a table may be swapped, so the first route takes them in either order.")
    };
    vec![
        of(
            "meyer.list.fig-10",
            "List of figures, Fig. 10",
            "FOUR PIN",
            "the mechanism of figure 10 has four pins",
            ["meyer.fig-10.driver", "meyer.fig-10.follower"],
            6,
        ),
        of(
            "meyer.list.fig-11",
            "List of figures, Fig. 11",
            "SIX PIN",
            "the mechanism of figure 11 has six pins",
            ["meyer.fig-11.driver", "meyer.fig-11.follower"],
            4,
        ),
    ]
}

/// The names on the pages of figures 13 and 14, by the list of figures and by the computations of Appendix A.
fn drawings() -> Vec<Claim> {
    let of = |id, locator, printed, meaning, listed: &'static str, computation: usize| {
        at(locator)
            .figure(id, printed, meaning)
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, move |stated| {
                same(stated.pick(stated.number(), 4.0), first_number(listed))
            })
            .second_route(Evidence::CLOSED_FORM, move |stated| {
                let half = computed_sizes().get(computation).map_or(f64::NAN, |sizes| sizes[0]);
                same(180.0 / stated.pick(stated.number(), 4.0), half)
            })
            .but_not("it has four pins")
            .interpreted_as(
                "We take the computations of Appendix A in their order for the drawings that come after them.",
            )
    };
    vec![
        of(
            "meyer.fig-13.pins",
            "Fig. 13",
            "SIX PIN",
            "the mechanism drawn in figure 13 has six pins",
            "meyer.list.fig-13",
            1,
        ),
        of(
            "meyer.fig-14.pins",
            "Fig. 14",
            "THREE PIN",
            "the mechanism drawn in figure 14 has three pins",
            "meyer.list.fig-14",
            2,
        ),
    ]
}

fn table_of_four_pins() -> Claim {
    at("Appendix E, heading of the four-pin mechanism")
        .statement(
            "meyer.app-e.four-pins",
            "Four Pin Mechanism",
            "the runs in the second table are runs of the mechanism with four pins",
        )
        .first_route(QUADRATURE, |stated| {
            as_runs_with(stated.pick(stated.count(), 6), "minima", 1.0, |row| {
                let minimum = Hypothesis::IDEAL.engagement(row)?.steady_state().ok()?.minimum.speed;
                Some(minimum - row.number(Column::Minimum))
            })
        })
        .second_route(RUNGE_KUTTA, |stated| {
            as_runs_with(stated.pick(stated.count(), 6), "periods", 1e-3, |row| {
                let [_, time, _] = cycle_of_row(&Hypothesis::IDEAL, row)?;
                Some(time - row.number(Column::Period))
            })
        })
        .but_not("they are runs of the mechanism with six pins")
}

/// Whether the rows of the second table, taken as runs with so many pins, are right to one unit.
fn as_runs_with(pins: u32, what: &str, unit: f64, off: fn(&Row) -> Option<f64>) -> Finding {
    let taken = |row: &Row| {
        let cells = Column::ALL.map(|column| row.printed(column)).join(" ");
        Row::read(with_pins(pins)?, &cells, row.given).ok()
    };
    Finding::for_all(
        rows().iter().filter(|row| row.mechanism == Mechanism::FOUR_PIN),
        |row| taken(row).and_then(|row| off(&row)).is_some_and(|off| off.abs() <= unit * (1.0 + 1e-9)),
        |near, all| format!("as runs with {pins} pins, {near} of {all} {what} agree to one unit"),
    )
}
