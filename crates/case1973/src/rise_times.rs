//! Which definition of a rise time the tables could use, and how the tables agree with the thesis's own words.

use crate::chance::expected_rises;
use crate::{Column, Hypothesis, Row, series};
use geneva_dynamics::steady::{Engagement, Extreme, Printed, Rise};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

/// A time that a start from rest has, if so large a part of a velocity may be missing.
pub struct Definition {
    /// The definition in words.
    pub name: &'static str,
    /// The time, in s.
    time: fn(&Start, f64) -> Option<f64>,
}

/// A row's start from rest.
struct Start {
    engagement: Engagement,
    rise: Rise,
    first_minimum: Option<Extreme>,
    lines: Vec<Printed>,
    /// The part of the velocity that may be missing by the source's own words.
    missing: f64,
}

impl Start {
    fn new(hypothesis: &Hypothesis, row: &Row, missing: f64) -> Option<Self> {
        let engagement = hypothesis.engagement(row)?;
        let listing = &row.given.listing;
        let lines = engagement.run(listing.interval, listing.duration).ok()?;
        let first_minimum = engagement.first_minimum().ok()?;
        Some(Self { rise: hypothesis.rise(row)?, first_minimum, lines, missing, engagement })
    }

    /// The first minimum, the first peak or a later minimum that is near the steady one, whichever comes first.
    fn until_extreme(&self, part: f64) -> Option<f64> {
        let steady = self.rise.steady.minimum.speed;
        let first = self.first_minimum.filter(|first| (first.speed / steady - 1.0).abs() <= part);
        let times = [first.map(|first| first.time), self.rise.until_peak(part), self.rise.until_minimum(part)];
        times.into_iter().flatten().min_by(f64::total_cmp)
    }

    /// The first printed line whose speed is near the largest printed one.
    fn printed_near_largest(&self) -> Option<f64> {
        let largest = self.lines.iter().map(|line| line.speed).fold(0.0, f64::max);
        self.lines.iter().find(|line| line.speed >= (1.0 - self.missing) * largest).map(|line| line.time)
    }

    /// The first printed line that is slower than its neighbours and near the steady minimum.
    fn printed_minimum(&self) -> Option<f64> {
        let steady = self.rise.steady.minimum.speed;
        let is_it = |w: &&[Printed]| {
            let [before, here, after] = [w[0].speed, w[1].speed, w[2].speed];
            here < before && here <= after && (here / steady - 1.0).abs() <= self.missing
        };
        self.lines.windows(3).find(is_it).map(|w| w[1].time)
    }
}

/// The parts that we try, dimensionless, if the source's own words let this part be missing: half of it, this part, twice
/// and five times as much.
pub fn parts(missing: f64) -> [f64; 4] {
    [0.5, 1.0, 2.0, 5.0].map(|times| times * missing)
}

/// The definitions nearest to the thesis's, with each of the parts: the time until some velocity of the motion is that
/// near to the steady one.
pub const OF_A_PART: [Definition; 8] = [
    Definition {
        name: "the velocity at every angle from then on",
        time: |start, part| start.engagement.until_profile(part).ok(),
    },
    Definition {
        name: "the average of peak and minimum of an engagement, to its end",
        time: |start, part| start.rise.until_mean_of_extremes(part),
    },
    Definition { name: "the entry speed", time: |start, part| start.rise.until_entry_speed(part) },
    Definition { name: "a peak", time: |start, part| start.rise.until_peak(part) },
    Definition { name: "a minimum", time: |start, part| start.rise.until_minimum(part) },
    Definition { name: "a peak or a minimum, whichever is first", time: Start::until_extreme },
    Definition {
        name: "the mean speed of an engagement, to its end",
        time: |start, part| start.rise.until_mean_speed(part),
    },
    Definition {
        name: "the mean speed of an engagement, to its start",
        time: |start, part| start.rise.until_mean_speed_begins(part),
    },
];

/// Other events of a start. Two of them are looked for in the lines of the print-out, which have a time of their own.
pub const EVENTS: [Definition; 5] = [
    Definition { name: "the first minimum", time: |start, _| start.first_minimum.map(|minimum| minimum.time) },
    Definition { name: "the first minimum after a hand-over", time: |start, _| start.rise.until_first_minimum() },
    Definition {
        name: "the greatest speed of the first engagement",
        time: |start, _| start.rise.cycles.first().map(|cycle| cycle.peak.time),
    },
    Definition {
        name: "a printed speed within 1% of the largest printed one",
        time: |start, _| start.printed_near_largest(),
    },
    Definition { name: "a printed minimum within 1%", time: |start, _| start.printed_minimum() },
];

/// The result of trying a definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Tried {
    /// The definition in words.
    pub name: &'static str,
    /// The part of the velocity that may be missing, dimensionless; none for an event.
    pub part: Option<f64>,
    /// For the runs as they were.
    pub as_run: Explained,
    /// For the mechanisms as they are.
    pub ideal: Explained,
}

/// How a definition does on the printed rise times.
#[derive(Clone, Debug, PartialEq)]
pub struct Explained {
    /// The computed time of each row, in s; not a number if there is none.
    pub times: Vec<f64>,
    /// Rows within one unit of the last place: with six, four and three pins.
    pub within_one: [usize; 3],
    /// How many would be, were the computed times of each table dealt out to its rows at random: the
    /// expectation, dimensionless.
    pub by_chance: f64,
    /// Least and greatest quotient of printed and computed time, dimensionless.
    pub range: [f64; 2],
}

impl Explained {
    fn new(rows: &[Row], times: Vec<f64>) -> Self {
        let by_chance = expected_rises(rows, &times);
        let mut found = Self { times, within_one: [0; 3], by_chance, range: [f64::INFINITY, 0.0] };
        for (row, time) in rows.iter().zip(&found.times) {
            let printed = row.number(Column::Rise);
            found.within_one[row.mechanism.index()] += usize::from(Column::Rise.is_within_one(printed, *time));
            found.range = [found.range[0].min(printed / time), found.range[1].max(printed / time)];
        }
        found
    }

    /// Rows within one unit of the last place.
    pub fn rows(&self) -> usize {
        self.within_one.iter().sum()
    }
}

/// Each definition with each part, then the events, in the order of [`OF_A_PART`], [`parts`] and [`EVENTS`].
///
/// `missing` is the part of a velocity that may be missing by the source's own words.
pub fn explained(rows: &[Row], missing: f64) -> Vec<Tried> {
    let starts = [Hypothesis::WITHOUT_LAG, Hypothesis::IDEAL]
        .map(|of| rows.iter().map(|row| Start::new(&of, row, missing)).collect::<Vec<_>>());
    let tried = |definition: &Definition, part: Option<f64>| {
        let [as_run, ideal] = starts.each_ref().map(|starts| {
            let time = |start: &Option<Start>| (definition.time)(start.as_ref()?, part.unwrap_or(missing));
            Explained::new(rows, starts.iter().map(|start| time(start).unwrap_or(f64::NAN)).collect())
        });
        Tried { name: definition.name, part, as_run, ideal }
    };
    let of_parts = OF_A_PART.iter().flat_map(|definition| parts(missing).map(|part| tried(definition, Some(part))));
    of_parts.chain(EVENTS.iter().map(|definition| tried(definition, None))).collect()
}

/// The greatest relative change, dimensionless and without its sign, of the time until the velocity is the steady one at every angle, but for a
/// part `missing`, by so many times the friction or one of the inertias of a row as a mechanism. None if there is no such motion.
pub fn change(row: &Row, missing: f64, times: f64) -> Option<f64> {
    let own = Hypothesis::IDEAL.parameters(row)?;
    let until = |friction: f64, driver: f64, follower: f64| {
        let inertias = Inertias::new(own.inertias().driver() * driver, own.inertias().follower() * follower).ok()?;
        let of = Parameters::new(own.mechanism(), inertias, own.torque(), own.friction() * friction).ok()?;
        Engagement::new(&of).ok()?.until_profile(missing).ok()
    };
    let before = until(1.0, 1.0, 1.0)?;
    let changed = [until(times, 1.0, 1.0)?, until(1.0, times, 1.0)?, until(1.0, 1.0, times)?];
    changed.map(|after| (after / before - 1.0).abs()).into_iter().reduce(f64::max)
}

/// Whether a row's first minimum as a mechanism, its first peak and all later extremes and entry speeds are within a unit of the
/// last place of the steady ones. None if there is no such motion.
pub fn is_steady_from_the_first_minimum(row: &Row) -> Option<bool> {
    let (rise, first) = (Hypothesis::IDEAL.rise(row)?, Hypothesis::IDEAL.engagement(row)?.first_minimum().ok()??);
    let steady = &rise.steady;
    let later = rise.cycles.iter().skip(1).flat_map(|cycle| {
        let entry = cycle.entry_speed - steady.entry_speed;
        [cycle.minimum.speed - steady.minimum.speed, entry, cycle.peak.speed - steady.peak.speed]
    });
    let peak = rise.cycles.first()?.peak.speed - steady.peak.speed;
    let mut off = [first.speed - steady.minimum.speed, peak].into_iter().chain(later);
    Some(off.all(|off| off.abs() < Column::Minimum.unit()))
}

/// Rows of one mechanism and one friction: only the torque changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Group<'a> {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// The printed friction.
    pub friction: &'a str,
    /// Printed rise time times √K, in s √(in lb): one number for all rows, were the time without a scale of its own.
    pub scaled: Vec<f64>,
    /// Whether some number fits all rows to within a unit of the last place and a print interval either way.
    pub possible: bool,
    /// The rows of which one must be misread, any of them, for some number to fit all others. Empty if not even that
    /// helps, or if nothing needs to be misread.
    pub misread: Vec<Misread<'a>>,
}

/// A row that may be misread: the others say between which times its own must lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Misread<'a> {
    /// The printed torque of the row.
    pub torque: &'a str,
    /// Least and greatest time that goes with the other rows, in s.
    pub between: [f64; 2],
}

/// All groups. By the law of similarity a time that only the motion defines goes as 1/√K within each.
pub fn groups<'a>(rows: &'a [Row]) -> Vec<Group<'a>> {
    let slack = |row: &Row| Column::Rise.unit() + row.given.listing.interval;
    // The times √K that all of these rows allow.
    let allowed = |rows: &[&Row]| {
        rows.iter().fold([0.0_f64, f64::INFINITY], |[low, high], row| {
            let (time, root, slack) = (row.number(Column::Rise), row.torque().sqrt(), slack(row));
            [low.max((time - slack) * root), high.min((time + slack) * root)]
        })
    };
    let group = |own: &'a [Row]| {
        let (mechanism, friction) = own.first().map(|row| (row.mechanism, row.printed(Column::Friction)))?;
        let scaled = own.iter().map(|row| row.number(Column::Rise) * row.torque().sqrt()).collect();
        let [low, high] = allowed(&own.iter().collect::<Vec<_>>());
        let possible = low <= high;
        let without = |left_out: &'a Row| {
            let [low, high] = allowed(&own.iter().filter(|row| *row != left_out).collect::<Vec<_>>());
            let between = [low, high].map(|scaled| scaled / left_out.torque().sqrt());
            (low <= high).then(|| Misread { torque: left_out.printed(Column::Torque), between })
        };
        let misread = if possible { Vec::new() } else { own.iter().filter_map(without).collect() };
        Some(Group { mechanism, friction, scaled, possible, misread })
    };
    series(rows).filter_map(group).collect()
}
