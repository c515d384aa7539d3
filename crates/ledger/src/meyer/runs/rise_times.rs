//! Which definition of a rise time could be that of the tables.

use super::*;
use geneva_dynamics::steady::{Extreme, Printed, Rise};

/// A time that a start from rest has.
pub struct Definition {
    /// In words.
    pub name: &'static str,
    /// The time, in s.
    pub time: fn(&Start) -> Option<f64>,
}

/// A row's start from rest.
pub struct Start {
    rise: Rise,
    first_minimum: Option<Extreme>,
    lines: Vec<Printed>,
}

impl Start {
    /// Of a row, as a hypothesis has it.
    pub fn of(hypothesis: &Hypothesis, row: &Row) -> Option<Self> {
        let engagement = hypothesis.engagement(row)?;
        let lines = engagement.run(interval(), duration()).ok()?;
        Some(Self { rise: hypothesis.rise(row)?, first_minimum: engagement.first_minimum().ok()?, lines })
    }

    /// The first printed line whose speed is near the largest printed one.
    fn printed_near_largest(&self) -> Option<f64> {
        let largest = self.lines.iter().map(|line| line.speed).fold(0.0, f64::max);
        self.lines.iter().find(|line| line.speed >= (1.0 - PART) * largest).map(|line| line.time)
    }

    /// The first printed line that is slower than its neighbours and near the steady minimum.
    fn printed_minimum(&self) -> Option<f64> {
        let steady = self.rise.steady.minimum.speed;
        let is_it = |w: &&[Printed]| {
            let [before, here, after] = [w[0].speed, w[1].speed, w[2].speed];
            here < before && here <= after && (here / steady - 1.0).abs() <= PART
        };
        self.lines.windows(3).find(is_it).map(|w| w[1].time)
    }
}

/// Until the speed is that near to the terminal one: 99 per cent, says the axis of the thesis's plots.
const PART: f64 = 0.01;

/// The definitions that are tried. The thesis has two that disagree: the first minimum, and 99 per cent of a speed. The
/// last two read the print-out, whose lines have a time of their own; the others read the motion.
pub const DEFINITIONS: [Definition; 11] = [
    Definition { name: "the first minimum", time: |start| start.first_minimum.map(|minimum| minimum.time) },
    Definition { name: "the first minimum after a hand-over", time: |start| start.rise.until_first_minimum() },
    Definition {
        name: "the greatest speed of the first engagement",
        time: |start| start.rise.cycles.first().map(|cycle| cycle.peak.time),
    },
    Definition { name: "the entry speed within 1%", time: |start| start.rise.until_entry_speed(PART) },
    Definition { name: "a peak within 1%", time: |start| start.rise.until_peak(PART) },
    Definition { name: "a minimum within 1%", time: |start| start.rise.until_minimum(PART) },
    Definition { name: "a mean speed within 1%, to its end", time: |start| start.rise.until_mean_speed(PART) },
    Definition { name: "a mean speed within 1%, to its start", time: |start| start.rise.until_mean_speed_begins(PART) },
    Definition { name: "a mean of peak and minimum within 1%", time: |start| start.rise.until_mean_of_extremes(PART) },
    Definition { name: "a printed speed within 1% of the largest printed one", time: Start::printed_near_largest },
    Definition { name: "a printed minimum within 1%", time: Start::printed_minimum },
];

/// How a definition does on the printed rise times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Explained {
    /// Rows within one unit of the last place: with six, four and three pins.
    pub within_one: [usize; 3],
    /// Mean of printed over computed time, less one.
    pub mean: f64,
    /// Least and greatest quotient of printed and computed time.
    pub range: [f64; 2],
}

/// Each definition, for the runs as they were and for the mechanism as it is.
pub fn explained() -> Vec<(&'static Definition, [Explained; 2])> {
    let starts = [Hypothesis::WITHOUT_LAG, Hypothesis::IDEAL]
        .map(|of| rows().iter().map(|row| (row, Start::of(&of, row))).collect::<Vec<_>>());
    DEFINITIONS.iter().map(|definition| (definition, [0, 1].map(|at| tried(definition, &starts[at])))).collect()
}

fn tried(definition: &Definition, starts: &[(&Row, Option<Start>)]) -> Explained {
    let mut found = Explained { within_one: [0; 3], mean: 0.0, range: [f64::INFINITY, 0.0] };
    for (row, start) in starts {
        let time = start.as_ref().and_then(definition.time).unwrap_or(f64::NAN);
        let printed = row.number(Column::Rise);
        found.within_one[row.mechanism.index()] += usize::from(near(time, printed));
        found.mean += (printed / time - 1.0) / starts.len() as f64;
        found.range = [found.range[0].min(printed / time), found.range[1].max(printed / time)];
    }
    found
}

fn near(time: f64, printed: f64) -> bool {
    Column::Rise.is_within_one(printed, time)
}

/// The rows of a mechanism that a definition explains as they were run, to one unit of the last place.
pub fn explained_rows(mechanism: Mechanism, name: &str) -> Vec<&'static Row> {
    let definition = DEFINITIONS.iter().find(|definition| definition.name == name);
    let explains = |row: &&Row| {
        let start = Start::of(&Hypothesis::WITHOUT_LAG, row);
        let time = definition.zip(start).and_then(|(definition, start)| (definition.time)(&start));
        time.is_some_and(|time| near(time, row.number(Column::Rise)))
    };
    rows().iter().filter(|row| row.mechanism == mechanism).filter(explains).collect()
}

/// Rows of one mechanism and one friction: only the torque changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// The printed friction.
    pub friction: &'static str,
    /// Printed rise time times √K, in s √(in lb): one number for all rows, were the time without a scale of its own.
    pub scaled: Vec<f64>,
    /// Whether some number fits all rows to within a unit of the last place and a print interval either way.
    pub possible: bool,
    /// The rows of which one must be misread, any of them, for some number to fit all others. Empty if not even that
    /// helps, or if nothing needs to be misread.
    pub misread: Vec<Misread>,
}

/// A row that may be misread: the others say between which times its own must lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Misread {
    /// The printed torque of the row.
    pub torque: &'static str,
    /// Least and greatest time that goes with the other rows, in s.
    pub between: [f64; 2],
}

/// All groups. By the law of similarity a time that only the motion defines goes as 1/√K within each.
pub fn groups() -> Vec<Group> {
    let slack = Column::Rise.unit() + interval();
    // The times √K that all of these rows allow.
    let allowed = |rows: &[&Row]| {
        rows.iter().fold([0.0_f64, f64::INFINITY], |[low, high], row| {
            let (time, root) = (row.number(Column::Rise), row.torque().sqrt());
            [low.max((time - slack) * root), high.min((time + slack) * root)]
        })
    };
    let group = |own: &'static [Row]| {
        let (mechanism, friction) = own.first().map(|row| (row.mechanism, row.printed(Column::Friction)))?;
        let scaled = own.iter().map(|row| row.number(Column::Rise) * row.torque().sqrt()).collect();
        let [low, high] = allowed(&own.iter().collect::<Vec<_>>());
        let possible = low <= high;
        let without = |left_out: &'static Row| {
            let [low, high] = allowed(&own.iter().filter(|row| *row != left_out).collect::<Vec<_>>());
            let between = [low, high].map(|scaled| scaled / left_out.torque().sqrt());
            (low <= high).then(|| Misread { torque: left_out.printed(Column::Torque), between })
        };
        let misread = if possible { Vec::new() } else { own.iter().filter_map(without).collect() };
        Some(Group { mechanism, friction, scaled, possible, misread })
    };
    series().filter_map(group).collect()
}
