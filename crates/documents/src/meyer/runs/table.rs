//! What is printed of the runs: the tables of Appendix E, one string for each and a line for each run, with the verdicts on
//! record of its columns; and the inertias of the headings and figures.

use crate::meyer::listed::{self, parts_of};
use geneva_case1973::{Column, Given, Listing, Row, slug};
use geneva_evidence::Verdict;
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

/// All rows, in the order of the source.
pub fn rows() -> &'static [Row] {
    static ROWS: OnceLock<Vec<Row>> = OnceLock::new();
    // The tests read every row.
    let row = |(mechanism, text, _): (Mechanism, &str, &str)| Row::read(mechanism, text, given(mechanism)).ok();
    ROWS.get_or_init(|| lines().filter_map(row).collect())
}

/// The place of a row in the tables; none if it is of no table.
pub fn position(row: &Row) -> Option<usize> {
    // One of the tables' own is found by where it is, a copy of one by what it says.
    let rows = rows();
    rows.iter().position(|other| std::ptr::eq(other, row)).or_else(|| rows.iter().position(|other| other == row))
}

/// The verdict on record of a column of a row, as it is marked after the row.
pub fn expected(row: &Row, column: Column) -> Option<Verdict> {
    let (_, _, marks) = lines().nth(position(row)?)?;
    let mark = marks.chars().nth(column as usize)?;
    MARKS.iter().find(|(of, _)| *of == mark).map(|(_, verdict)| *verdict)
}

/// The lines of all tables: mechanism, cells and marks.
fn lines() -> impl Iterator<Item = (Mechanism, &'static str, &'static str)> {
    TABLES.iter().flat_map(|(mechanism, table)| {
        table.lines().filter_map(|line| line.rsplit_once(' ').map(|(cells, marks)| (*mechanism, cells, marks)))
    })
}

/// What is given for the runs of a mechanism besides its table.
fn given(mechanism: Mechanism) -> Given {
    let inertias = |printed: [&str; 2]| printed.map(|number| parsed(number) / units_in_one(UNIT));
    let headed = inertias(headed(mechanism));
    Given { headed, drawn: drawn(mechanism).map_or(headed, |(_, printed)| inertias(printed)), listing: listing() }
}

/// What the listing of the program fixes for all runs.
pub fn listing() -> Listing {
    let interval = parsed(listed::PRINT_INTERVAL);
    Listing {
        reset: parsed(listed::QUARTER_TURN),
        pi: parsed(listed::PI),
        first_line: 0.0,
        interval,
        duration: parsed(listed::RUN_LENGTH),
        delay: interval / parts_of(listed::DELAY).unwrap_or(f64::NAN),
    }
}

fn parsed(printed: &str) -> f64 {
    printed.parse().unwrap_or(f64::NAN)
}

/// How many of a unit with a power of ten before it make one unit without it.
pub fn units_in_one(unit: &str) -> f64 {
    let power = unit.split_once("10^").and_then(|(_, behind)| behind.split(' ').next()?.parse::<i32>().ok());
    power.map_or(f64::NAN, |power| match libm::pow(10.0, f64::from(power.abs())) {
        size if power < 0 => size,
        size => 1.0 / size,
    })
}

/// The unit of the printed inertias.
pub const UNIT: &str = "× 10^-6 in lb sec²";

/// The inertias of driver and follower above a mechanism's table.
pub fn headed(mechanism: Mechanism) -> [&'static str; 2] {
    match mechanism {
        Mechanism::SIX_PIN => ["10", "6"],
        Mechanism::FOUR_PIN => ["3", "50"],
        _ => ["3", "40"],
    }
}

/// The figure on whose axes a mechanism's inertias are printed, and these; none if it has no such figure.
pub fn drawn(mechanism: Mechanism) -> Option<(&'static str, [&'static str; 2])> {
    match mechanism {
        Mechanism::SIX_PIN => Some(("11", ["6", "10"])),
        Mechanism::FOUR_PIN => Some(("10", ["3", "50"])),
        _ => None,
    }
}

/// The id of an inertia in the heading of a table.
pub fn heading_id(mechanism: Mechanism, member: &str) -> String {
    format!("meyer.app-e.{}.{member}", slug(mechanism))
}

/// How verdicts on record are marked behind a row.
const MARKS: [(char, Verdict); 6] = [
    ('=', Verdict::Reproduced),
    ('~', Verdict::ReadOff),
    ('!', Verdict::ReproducedInError),
    ('/', Verdict::Corrected),
    ('?', Verdict::NotReproduced),
    ('-', Verdict::NotReproducible),
];

/// Mechanism and rows: friction, torque, peak, minimum, rise time, period, and the marks of all six.
const TABLES: [(Mechanism, &str); 3] = [
    (
        Mechanism::SIX_PIN,
        "\
.20 .03  83 10 .101 .046  ~=!~-!
.20 .05 107 13 .078 .036  ~=!!-!
.20 .07 127 15 .074 .030  ==!!-!
.20 .09 144 17 .051 .027  ~=!!-!
.25 .03  76 9 .092 .050  ==!~-!
.25 .05  98 12 .084 .039  ==!!-!
.25 .07 116 14 .061 .033  ==!!-!
.25 .09 130 16 .047 .029  ==!!-!
.30 .03  71 8 .073 .054  ~=!=-!
.30 .05  91 11 .057 .043  ~=!!-!
.30 .07 108 13 .036 .036  ==!!-!
.30 .09 123 14 .034 .031  ~=!~-!
.35 .03  67 8 .070 .058  ~=!~-!
.35 .05  86 10 .046 .046  ~=!~-!
.35 .07 102 12 .047 .039  ~=!!-!
.35 .09 116 14 .044 .034  ==!!-!",
    ),
    (
        Mechanism::FOUR_PIN,
        "\
.20 .08 155 19 .056 .040  ~===-~
.20 .10 174 21 .050 .035  ==~=-=
.20 .12 191 23 .046 .032  ==~=-=
.20 .14 206 25 .034 .030  ====-=
.25 .08 134 17 .037 .043  ====-=
.25 .10 150 19 .033 .039  ~===-=
.25 .12 164 21 .030 .035  ====-=
.25 .14 178 23 .027 .033  ~=~=-=
.30 .08 118 17 .037 .047  ~===-~
.30 .10 128 18 .030 .042  ~=/=-~
.30 .12 144 20 .029 .038  ====-=
.30 .14 154 22 .027 .035  ==!=-=
.35 .09 111 17 .028 .046  ~===-=
.35 .10 117 18 .026 .044  ====-=
.35 .11 123 19 .024 .042  ====-=
.35 .12 129 20 .023 .040  ~=~=-=
.35 .20 163 25 .028 .031  ==/=-=",
    ),
    (
        Mechanism::THREE_PIN,
        "\
.20 .08 144 61 .044 .018  ~=!!-!
.20 .10 161 68 .039 .017  ==!!-!
.20 .12 176 74 .036 .015  ==!!-!
.20 .14 191 80 .030 .014  ==!!-!
.25 .08 140 58 .036 .020  ~=!!-!
.25 .10 156 65 .036 .018  ~=!!-!
.25 .12 171 71 .029 .015  ==!!-~
.25 .14 184 77 .028 .015  ==!!-!
.30 .08 136 56 .037 .020  ==!!-=
.30 .10 152 63 .033 .018  ==!!-=
.30 .12 167 69 .030 .016  ~=!!-~
.30 .14 180 74 .028 .015  ~=!!-=
.35 .08 133 54 .038 .021  ~=!!-~
.35 .10 148 61 .038 .018  ~=!!-!
.35 .12 163 67 .031 .017  ~=!!-~
.35 .14 176 72 .028 .015  ==!!-!",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_is_read_and_every_column_has_a_verdict_on_record() {
        assert_eq!(rows().len(), TABLES.iter().map(|(_, table)| table.lines().count()).sum::<usize>());
        for ((_, cells, marks), row) in lines().zip(rows()) {
            assert_eq!(cells.split_whitespace().next(), Some(row.printed(Column::Friction)));
            assert_eq!(marks.chars().count(), Column::ALL.len(), "{row:?}");
            for column in Column::ALL {
                assert!(expected(row, column).is_some(), "{row:?}: {column:?} has none of the marks {MARKS:?}");
            }
        }
    }

    #[test]
    fn what_is_given_for_the_runs_are_finite_numbers() {
        for row in rows() {
            let Given { headed, drawn, listing } = row.given;
            let Listing { reset, pi, first_line, interval, duration, delay } = listing;
            let all = [&headed[..], &drawn, &[reset, pi, first_line, interval, duration, delay]].concat();
            assert!(all.iter().all(|number| number.is_finite()), "{all:?}");
        }
    }
}
