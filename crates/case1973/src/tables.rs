//! The printed tables: a row for each run, which rows stand for others, and what the source gives besides its tables. All of it
//! comes in as arguments: no number of the source is written here.

use geneva_kinematics::pin_slot::velocity_ratio;
use geneva_kinematics::{Mechanism, Turn};
use geneva_mimic::MinStepPolicy;

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
    /// All columns.
    pub const ALL: [Self; 6] = [Self::Friction, Self::Torque, Self::Peak, Self::Minimum, Self::Rise, Self::Period];

    /// The unit of the last printed place: 1 rad/s, or 1 ms in s.
    pub fn unit(self) -> f64 {
        if matches!(self, Self::Period | Self::Rise) { 1e-3 } else { 1.0 }
    }

    /// Whether a computed number of this column is no more than a unit of the last printed place from the printed
    /// number, both in the column's own unit.
    pub fn is_within_one(self, printed: f64, computed: f64) -> bool {
        (printed - computed).abs() <= self.unit() * (1.0 + 1e-9)
    }
}

/// The columns that a hypothesis is to explain, and from which a table's data are found.
pub const EXPLAINED: [Column; 3] = [Column::Peak, Column::Minimum, Column::Period];

/// What the listing of the program fixes for all runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Listing {
    /// Angle in radians after which the program resets the driver's angle, whatever the mechanism.
    pub reset: f64,
    /// The program's π, dimensionless, from which it computes the centre distance.
    pub pi: f64,
    /// Time of the first printed line, in s.
    pub first_line: f64,
    /// Time from one printed line to the next, in s.
    pub interval: f64,
    /// Length of a run, in s.
    pub duration: f64,
    /// How late the acceleration is that chooses the sign of friction, in s.
    pub delay: f64,
}

impl Listing {
    /// The follower's speed over the driver's where the program resets the angle, dimensionless; positive in the sense in which a
    /// pin drives the follower.
    pub fn velocity_ratio_at_reset(&self, mechanism: Mechanism) -> f64 {
        let angle = self.reset - mechanism.engagement_half_angle();
        velocity_ratio(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle))
    }

    /// The integrator as far as the listing tells, with the defaults for the rest.
    ///
    /// A step may be longer than the delay; the old acceleration is then the acceleration of the step before.
    pub fn integrator(&self) -> geneva_mimic::SolverParameters {
        geneva_mimic::SolverParameters {
            at_smallest_step: MinStepPolicy::Continue,
            ..geneva_mimic::SolverParameters::new(self.interval, self.duration)
        }
    }
}

/// What a source gives for the runs of a mechanism besides the rows of its table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Given {
    /// Inertias of driver and follower in the heading of the table, in in lb s².
    pub headed: [f64; 2],
    /// Inertias of driver and follower on the axes of the mechanism's figure, in in lb s²; the headed ones if it has
    /// none.
    pub drawn: [f64; 2],
    /// The listing of the program.
    pub listing: Listing,
}

/// A row that cannot be read, and what is wrong with it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the row `{row}`: give friction, torque, peak, minimum, rise time and period, {wrong}")]
pub struct UnreadableRow {
    row: String,
    wrong: &'static str,
}

/// One printed row.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The mechanism whose table contains the row.
    pub mechanism: Mechanism,
    /// What else is given for its runs.
    pub given: Given,
    /// The printed characters, in the order of the columns.
    cells: [String; 6],
    numbers: [f64; 6],
}

impl Row {
    /// Reads a row: six numbers in the order of [`Column::ALL`], with spaces or commas between them.
    ///
    /// # Errors
    ///
    /// More or fewer than six numbers, or a cell that is no finite number.
    pub fn read(mechanism: Mechanism, text: &str, given: Given) -> Result<Self, UnreadableRow> {
        let unreadable = |wrong| UnreadableRow { row: text.chars().take(80).collect(), wrong };
        let is_between = |sign: char| sign == ',' || sign.is_whitespace();
        let cells: Vec<String> = text.split(is_between).filter(|cell| !cell.is_empty()).map(str::to_owned).collect();
        let cells: [String; 6] = cells.try_into().map_err(|_| unreadable("six numbers in all"))?;
        let numbers = cells.each_ref().map(|cell| cell.parse().unwrap_or(f64::NAN));
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(unreadable("each a finite number"));
        }
        Ok(Self { mechanism, given, cells, numbers })
    }

    /// The printed characters of a column.
    pub fn printed(&self, column: Column) -> &str {
        &self.cells[column as usize]
    }

    /// The printed number of a column, in the column's own unit.
    pub fn number(&self, column: Column) -> f64 {
        self.numbers[column as usize]
    }

    /// By how many units of its last printed place a computed number of a column is greater than the printed one.
    pub fn misfit(&self, column: Column, computed: f64) -> f64 {
        (computed - self.number(column)) / column.unit()
    }

    /// How many of these numbers of the columns of [`EXPLAINED`] are within a unit of the last printed place.
    pub fn explained_by(&self, results: &[f64; 3]) -> usize {
        let cells = EXPLAINED.iter().zip(results);
        cells.filter(|(column, computed)| column.is_within_one(self.number(**column), **computed)).count()
    }

    /// The friction, dimensionless.
    pub fn friction(&self) -> f64 {
        self.number(Column::Friction)
    }

    /// The torque, in in lb.
    pub fn torque(&self) -> f64 {
        self.number(Column::Torque)
    }

    /// The row's name: mechanism, friction and torque.
    pub fn slug(&self) -> String {
        let [friction, torque, ..] = &self.cells;
        format!("{}.mu-0{friction}.k-0{torque}", slug(self.mechanism))
    }
}

/// A mechanism's name; the thesis names mechanisms by the pins.
pub fn slug(mechanism: Mechanism) -> String {
    format!("{}-pin", mechanism.pins())
}

/// Whether the printed numbers of a column go as this power of the torque, 1/2 or −1/2, each to one unit of its last place.
pub fn obeys(rows: &[Row], column: Column, power: f64) -> bool {
    let [low, high] = rows.iter().fold([f64::NEG_INFINITY, f64::INFINITY], |[low, high], row| {
        let scale = if power > 0.0 { 1.0 / row.torque().sqrt() } else { row.torque().sqrt() };
        let [least, most] = [-1.0, 1.0].map(|off| (row.number(column) + off * column.unit()) * scale);
        [low.max(least), high.min(most)]
    });
    low <= high
}

/// The table of a mechanism: its rows, which stand together among the rows of all tables. Empty if there is none.
pub fn rows_of(rows: &[Row], mechanism: Mechanism) -> &[Row] {
    let mut tables = rows.chunk_by(|one, other| one.mechanism == other.mechanism);
    tables.find(|table| table[0].mechanism == mechanism).unwrap_or_default()
}

/// The rows of one mechanism and one friction, by rising torque, of rows in the order of their tables; nothing else
/// changes among them.
pub fn series(rows: &[Row]) -> impl Iterator<Item = &[Row]> {
    rows.chunk_by(|one, other| {
        one.mechanism == other.mechanism && one.printed(Column::Friction) == other.printed(Column::Friction)
    })
}

/// For each mechanism and friction the row with the weakest spring.
pub fn weakest(rows: &[Row]) -> impl Iterator<Item = &Row> {
    series(rows).filter_map(<[Row]>::first)
}

/// For each mechanism and friction the row with the strongest spring.
pub fn strongest(rows: &[Row]) -> impl Iterator<Item = &Row> {
    series(rows).filter_map(<[Row]>::last)
}

/// The rows of a mechanism with the least friction, by rising torque; their engagements differ longest.
pub fn rows_with_least_friction(rows: &[Row], mechanism: Mechanism) -> Option<&[Row]> {
    let own = series(rows).filter(|own| own[0].mechanism == mechanism);
    own.min_by(|a, b| a[0].friction().total_cmp(&b[0].friction()))
}

/// The rows of a mechanism with a friction, as printed, that the others were run with too, by rising torque.
pub fn rows_with_friction<'a>(rows: &'a [Row], mechanism: Mechanism, friction: &str) -> Option<&'a [Row]> {
    series(rows).find(|own| own[0].mechanism == mechanism && own[0].printed(Column::Friction) == friction)
}

/// Pairs of rows with the same mechanism and friction: a row, and the row with the next torque of the table.
pub fn pairs_by_torque(rows: &[Row]) -> impl Iterator<Item = [&Row; 2]> {
    series(rows).flat_map(|own| own.windows(2)).map(|pair| [&pair[0], &pair[1]])
}

/// Pairs of rows with the same mechanism and torque: a row, and the row with the next friction of the table with which there is
/// such a row.
pub fn pairs_by_friction<'a>(rows: &'a [Row]) -> impl Iterator<Item = [&'a Row; 2]> {
    let next = move |row: &'a Row| {
        let alike = |other: &&Row| {
            other.mechanism == row.mechanism
                && other.printed(Column::Torque) == row.printed(Column::Torque)
                && other.friction() > row.friction()
        };
        let next = rows.iter().filter(alike).min_by(|a, b| a.friction().total_cmp(&b.friction()))?;
        Some([row, next])
    };
    rows.iter().filter_map(next)
}

/// In how many pairs of rows a printed number goes up from the first to the second.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Trend {
    /// How many pairs there are.
    pub pairs: usize,
    /// In how many the number goes up.
    pub up: usize,
    /// In how many it stays the same.
    pub equal: usize,
}

impl Trend {
    /// The trend of a column.
    pub fn count<'a>(column: Column, pairs: impl Iterator<Item = [&'a Row; 2]>) -> Self {
        pairs.fold(Self::default(), |all, pair| {
            let [before, after] = pair.map(|row| row.number(column));
            let (up, equal) = (usize::from(after > before), usize::from(after == before));
            Self { pairs: all.pairs + 1, up: all.up + up, equal: all.equal + equal }
        })
    }
}
