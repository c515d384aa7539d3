//! Tables that are from no source: their rows are runs of the program, rounded as a source would print them.

use geneva_case1973::{Column, Given, Hypothesis, Listing, Row, Trend, pairs_by_friction, pairs_by_torque, series};
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

/// A listing of no source.
pub(crate) const LISTING: Listing =
    Listing { reset: 1.57, pi: 3.145, first_line: 0.0, interval: 0.0007, duration: 0.3, delay: 0.00007 };

/// What is given for the runs of a mechanism; the heading of the six pins has the two inertias swapped.
pub(crate) fn given(mechanism: Mechanism) -> Given {
    let drawn = match mechanism {
        Mechanism::SIX_PIN => [7e-6, 11e-6],
        Mechanism::FOUR_PIN => [4e-6, 46e-6],
        _ => [4e-6, 37e-6],
    };
    let headed = if mechanism == Mechanism::SIX_PIN { [drawn[1], drawn[0]] } else { drawn };
    Given { headed, drawn, listing: LISTING }
}

/// A row with these results of a run, rounded.
pub(crate) fn printed(
    mechanism: Mechanism,
    friction: &str,
    torque: &str,
    [peak, minimum, rise, period]: [f64; 4],
) -> Row {
    let text = format!("{friction} {torque} {peak:.0} {minimum:.0} {rise:.3} {period:.3}");
    Row::read(mechanism, &text, given(mechanism)).expect("a row")
}

/// The tables as they were run.
pub(crate) fn tables() -> &'static [Row] {
    static TABLES: OnceLock<Vec<Row>> = OnceLock::new();
    TABLES.get_or_init(|| {
        let mut rows = Vec::new();
        for mechanism in Mechanism::ALL {
            for friction in [".22", ".31"] {
                for torque in [".04", ".07", ".10", ".13"] {
                    let run = Hypothesis::AS_RUN.run(&printed(mechanism, friction, torque, [0.0; 4])).expect("a run");
                    let results = [run.peak, run.minimum, run.first_minimum, run.period];
                    rows.push(printed(mechanism, friction, torque, results));
                }
            }
        }
        rows
    })
}

#[test]
fn a_row_is_read_with_spaces_or_commas_and_keeps_its_characters() {
    let mechanism = Mechanism::FOUR_PIN;
    let spaces = Row::read(mechanism, " .22 .04  151 17 .031 .040 ", given(mechanism)).expect("a row");
    let commas = Row::read(mechanism, ".22,.04,151,17,.031,.040", given(mechanism)).expect("a row");
    assert_eq!(spaces, commas);
    assert_eq!(Column::ALL.map(|column| spaces.printed(column)), [".22", ".04", "151", "17", ".031", ".040"]);
    assert_eq!(Column::ALL.map(|column| spaces.number(column)), [0.22, 0.04, 151.0, 17.0, 0.031, 0.04]);
    assert_eq!(spaces.slug(), "4-pin.mu-0.22.k-0.04");
    approx::assert_relative_eq!(spaces.misfit(Column::Period, 0.0425), 2.5, max_relative = 1e-9);
}

#[test]
fn a_row_that_is_none_is_refused_with_what_it_should_have() {
    for (text, wrong) in [
        ("", "six numbers in all"),
        (".22 .04 151 17 .031", "six numbers in all"),
        (".22 .04 151 17 .031 .040 1", "six numbers in all"),
        (".22 .04 151 17 .031 x", "each a finite number"),
        (".22 .04 151 17 inf .040", "each a finite number"),
    ] {
        let refused = Row::read(Mechanism::FOUR_PIN, text, given(Mechanism::FOUR_PIN)).expect_err(text).to_string();
        assert!(refused.contains(wrong) && refused.contains(text), "{refused}");
    }
}

#[test]
fn a_series_has_one_mechanism_and_one_friction() {
    assert_eq!(series(tables()).count(), 6);
    for own in series(tables()) {
        assert!(own.iter().all(|row| row.mechanism == own[0].mechanism && row.friction() == own[0].friction()));
        assert!(own.windows(2).all(|pair| pair[0].torque() < pair[1].torque()));
    }
}

#[test]
fn a_pair_differs_in_one_value_and_the_next_row_has_more_of_it() {
    let alike = |[one, other]: &[&Row; 2], column| one.printed(column) == other.printed(column);
    let (by_torque, by_friction) = (|| pairs_by_torque(tables()), || pairs_by_friction(tables()));
    assert_eq!((by_torque().count(), by_friction().count()), (18, 12));
    assert!(by_torque().all(|pair| alike(&pair, Column::Friction) && pair[0].torque() < pair[1].torque()));
    assert!(by_friction().all(|pair| alike(&pair, Column::Torque) && pair[0].friction() < pair[1].friction()));
    // More friction, less speed; and a stronger spring, more.
    assert_eq!(Trend::count(Column::Minimum, by_friction()), Trend { pairs: 12, up: 0, equal: 0 });
    assert_eq!(Trend::count(Column::Minimum, by_torque()), Trend { pairs: 18, up: 18, equal: 0 });
    assert_eq!(Trend::count(Column::Friction, by_torque()), Trend { pairs: 18, up: 0, equal: 18 });
}
