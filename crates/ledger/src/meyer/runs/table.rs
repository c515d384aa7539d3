//! The printed tables of Appendix E: one string for each, a line for each run, with the verdicts on record of its
//! columns.

use crate::Verdict;
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

/// The columns of a table, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Column {
    /// Coefficient of friction.
    Friction,
    /// Torque of the spring, in in lb.
    Torque,
    /// Greatest speed of the driver, in rad/s.
    Peak,
    /// Least speed of the driver, in rad/s.
    Minimum,
    /// Rise time, in s.
    Rise,
    /// Period, in s.
    Period,
}

impl Column {
    /// The unit of the last printed place: 1 rad/s, or 1 ms in s.
    pub fn unit(self) -> f64 {
        if matches!(self, Self::Period | Self::Rise) { 1e-3 } else { 1.0 }
    }

    /// Whether a computed number of this column is no more than a unit of the last printed place from the printed
    /// number.
    pub fn is_within_one(self, printed: f64, computed: f64) -> bool {
        (printed - computed).abs() <= self.unit() * (1.0 + 1e-9)
    }
}

/// A mechanism as it appears in ids; the thesis names mechanisms by the pins.
pub fn slug(mechanism: Mechanism) -> String {
    format!("{}-pin", mechanism.pins())
}

/// One printed row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The table that contains the row.
    pub mechanism: Mechanism,
    /// The printed characters, in the order of the columns.
    cells: [&'static str; 6],
    /// Marks of the verdicts on record of the columns.
    marks: &'static str,
}

impl Row {
    /// The printed characters of a column.
    pub fn printed(&self, column: Column) -> &'static str {
        self.cells[column as usize]
    }

    /// The printed number of a column; not a number if it cannot be read.
    pub fn number(&self, column: Column) -> f64 {
        self.printed(column).parse().unwrap_or(f64::NAN)
    }

    /// The verdict on record of a column, as it is marked after the row.
    pub fn expected(&self, column: Column) -> Option<Verdict> {
        let mark = self.marks.chars().nth(column as usize)?;
        MARKS.iter().find(|(of, _)| *of == mark).map(|(_, verdict)| *verdict)
    }

    /// The friction.
    pub fn friction(&self) -> f64 {
        self.number(Column::Friction)
    }

    /// The torque, in in lb.
    pub fn torque(&self) -> f64 {
        self.number(Column::Torque)
    }

    /// The row's name in ids: mechanism, friction and torque.
    pub fn slug(&self) -> String {
        let [friction, torque, ..] = self.cells;
        format!("{}.mu-0{friction}.k-0{torque}", slug(self.mechanism))
    }
}

/// All rows, in the order of the source.
pub fn rows() -> &'static [Row] {
    static ROWS: OnceLock<Vec<Row>> = OnceLock::new();
    ROWS.get_or_init(|| TABLES.iter().flat_map(|(mechanism, table)| read(*mechanism, table)).collect())
}

/// The rows of one mechanism and one friction, by rising torque; nothing else changes among them.
pub fn series() -> impl Iterator<Item = &'static [Row]> {
    let alike = |one: &Row, other: &Row| {
        one.mechanism == other.mechanism && one.printed(Column::Friction) == other.printed(Column::Friction)
    };
    rows().chunk_by(alike)
}

fn read(mechanism: Mechanism, table: &'static str) -> impl Iterator<Item = Row> {
    table.lines().map(move |text| {
        let mut words = text.split_whitespace();
        let mut word = || words.next().unwrap_or_default();
        Row { mechanism, cells: std::array::from_fn(|_| word()), marks: word() }
    })
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

    const COLUMNS: [Column; 6] =
        [Column::Friction, Column::Torque, Column::Peak, Column::Minimum, Column::Rise, Column::Period];

    impl Row {
        /// The row with other characters in a column.
        pub fn printing(mut self, column: Column, text: &'static str) -> Self {
            self.cells[column as usize] = text;
            self
        }
    }

    #[test]
    fn every_row_is_complete_and_every_column_has_a_verdict_on_record() {
        for row in rows() {
            assert!(row.cells.iter().all(|cell| cell.parse::<f64>().is_ok()), "{row:?}");
            assert_eq!(row.marks.chars().count(), COLUMNS.len(), "{row:?}");
            for column in COLUMNS {
                assert!(row.expected(column).is_some(), "{row:?}: {column:?} has none of the marks {MARKS:?}");
            }
        }
    }
}
