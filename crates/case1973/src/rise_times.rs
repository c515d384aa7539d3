//! Which definition of a rise time the tables could use, and how the tables agree with the thesis's own words.

use crate::chance::{ShuffleScope, expected_rises, shuffles_of_rises};
use crate::{Column, Hypothesis, Row, series};
use geneva_dynamics::steady::{Engagement, Extreme, PrintedLine, Rise, RiseCycle};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

/// A time that a start from rest has, if a velocity may be so far from the one that it comes to.
pub struct Definition {
    /// The definition in words.
    pub name: &'static str,
    /// The time, in s.
    time: fn(&Start, RiseTolerance) -> Option<f64>,
    /// Whether the steady value in question is the average terminal velocity itself, of which a part is the same as of this.
    is_of_the_average: bool,
    /// Whether the tables print the value that this velocity comes to.
    is_printed: bool,
}

/// What the difference is a part of that may be missing at the end of a rise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whole {
    /// The steady value of the quantity in question.
    Itself,
    /// The average terminal velocity: the mean of peak and minimum of the steady motion.
    TerminalVelocity,
    /// A hundred units of the tables' speeds, so that one per cent is one unit.
    Units,
}

/// Where the value comes from that a velocity comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// The computed steady motion.
    Computed,
    /// Peak and minimum as the tables print them.
    Printed,
}

/// How far a velocity may still be from the one that it comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RiseTolerance {
    /// The part that may be missing, dimensionless.
    pub part: f64,
    /// Of what.
    pub whole: Whole,
    /// What it comes to.
    pub target: Target,
}

impl RiseTolerance {
    /// All ways to be near with a part: in the order of the kinds of whole, to the computed and then to the printed values.
    const WAYS: [(Target, Whole); 6] = [
        (Target::Computed, Whole::Itself),
        (Target::Computed, Whole::TerminalVelocity),
        (Target::Computed, Whole::Units),
        (Target::Printed, Whole::Itself),
        (Target::Printed, Whole::TerminalVelocity),
        (Target::Printed, Whole::Units),
    ];

    /// Whether the part is this one of the velocity in question, or of the average terminal velocity.
    pub fn is_part_of_a_velocity(&self, part: f64) -> bool {
        self.part == part && self.whole != Whole::Units
    }
}

/// A row's start from rest.
struct Start {
    engagement: Engagement,
    rise: Rise,
    first_minimum: Option<Extreme>,
    lines: Vec<PrintedLine>,
    /// Peak and minimum as printed.
    printed: [f64; 2],
    /// A unit of the tables' speeds.
    unit: f64,
    /// The part of the velocity that may be missing by the source's own words.
    missing: f64,
}

impl Start {
    fn new(hypothesis: &Hypothesis, row: &Row, missing: f64) -> Option<Self> {
        let engagement = hypothesis.engagement(row)?;
        let listing = &row.given.listing;
        let lines = engagement.run(listing.interval, listing.duration).ok()?;
        let first_minimum = engagement.first_minimum().ok()?;
        let printed = [Column::Peak, Column::Minimum].map(|column| row.number(column));
        let (rise, unit) = (hypothesis.rise(row)?, Column::Peak.unit());
        Some(Self { rise, first_minimum, lines, printed, unit, missing, engagement })
    }

    /// The peak and the minimum that the motion comes to.
    fn extremes(&self, target: Target) -> [f64; 2] {
        let steady = &self.rise.steady;
        match target {
            Target::Computed => [steady.peak.speed, steady.minimum.speed],
            Target::Printed => self.printed,
        }
    }

    /// The average terminal velocity.
    fn terminal(&self, target: Target) -> f64 {
        let [peak, minimum] = self.extremes(target);
        f64::midpoint(peak, minimum)
    }

    /// How far a quantity may be from this value.
    fn allowed(&self, near: RiseTolerance, value: f64) -> f64 {
        let whole = match near.whole {
            Whole::Itself => value,
            Whole::TerminalVelocity => self.terminal(near.target),
            Whole::Units => 100.0 * self.unit,
        };
        near.part * whole
    }

    /// The first engagement of which a quantity is near a value.
    fn first(&self, near: RiseTolerance, value: f64, quantity: fn(&RiseCycle) -> f64) -> Option<&RiseCycle> {
        let allowed = self.allowed(near, value);
        self.rise.cycles.iter().find(|cycle| (quantity(cycle) - value).abs() <= allowed)
    }

    fn until_profile(&self, near: RiseTolerance) -> Option<f64> {
        match near.whole {
            Whole::Itself => self.engagement.until_profile(near.part).ok(),
            Whole::TerminalVelocity | Whole::Units => {
                self.engagement.until_profile_within(self.allowed(near, self.terminal(near.target))).ok()
            }
        }
    }

    fn until_average(&self, near: RiseTolerance) -> Option<f64> {
        let value = self.terminal(near.target);
        let allowed = self.allowed(near, value);
        let is_near = |cycle: &&RiseCycle| {
            // The start at rest is no minimum.
            let first = self.first_minimum.filter(|first| cycle.start == 0.0 && first.time < cycle.end);
            let minimum = first.map_or(cycle.minimum.speed, |first| first.speed);
            (f64::midpoint(cycle.peak.speed, minimum) - value).abs() <= allowed
        };
        self.rise.cycles.iter().find(is_near).map(|cycle| cycle.end)
    }

    fn until_entry_speed(&self, near: RiseTolerance) -> Option<f64> {
        self.first(near, self.rise.steady.entry_speed, |cycle| cycle.entry_speed).map(|cycle| cycle.start)
    }

    fn until_peak(&self, near: RiseTolerance) -> Option<f64> {
        let [peak, _] = self.extremes(near.target);
        self.first(near, peak, |cycle| cycle.peak.speed).map(|cycle| cycle.peak.time)
    }

    fn until_minimum(&self, near: RiseTolerance) -> Option<f64> {
        let [_, minimum] = self.extremes(near.target);
        self.first(near, minimum, |cycle| cycle.minimum.speed).map(|cycle| cycle.minimum.time)
    }

    /// The first minimum, the first peak or a later minimum that is near the one it comes to, whichever comes first.
    fn until_extreme(&self, near: RiseTolerance) -> Option<f64> {
        let [_, minimum] = self.extremes(near.target);
        let allowed = self.allowed(near, minimum);
        let first = self.first_minimum.filter(|first| (first.speed - minimum).abs() <= allowed);
        let times = [first.map(|first| first.time), self.until_peak(near), self.until_minimum(near)];
        times.into_iter().flatten().min_by(f64::total_cmp)
    }

    /// When the speed is first as great as the average terminal velocity, but for the part that may be missing.
    fn until_average_is_passed(&self, near: RiseTolerance) -> Option<f64> {
        let average = self.terminal(near.target);
        let enough = average - self.allowed(near, average);
        self.lines.iter().find(|line| line.speed >= enough).map(|line| line.time)
    }

    fn until_mean_speed(&self, near: RiseTolerance) -> Option<&RiseCycle> {
        self.first(near, self.rise.steady.mean_speed, |cycle| cycle.mean_speed)
    }

    /// The first printed line whose speed is near the largest printed one.
    fn printed_near_largest(&self) -> Option<f64> {
        let largest = self.lines.iter().map(|line| line.speed).fold(0.0, f64::max);
        self.lines.iter().find(|line| line.speed >= (1.0 - self.missing) * largest).map(|line| line.time)
    }

    /// The first printed line that is slower than its neighbours and near the steady minimum.
    fn printed_minimum(&self) -> Option<f64> {
        let steady = self.rise.steady.minimum.speed;
        let is_it = |w: &&[PrintedLine]| {
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

impl Definition {
    /// A definition by a quantity whose steady value the tables do not print.
    const fn new(name: &'static str, time: fn(&Start, RiseTolerance) -> Option<f64>) -> Self {
        Self { name, time, is_of_the_average: false, is_printed: false }
    }

    /// A definition by a quantity whose steady value the tables print.
    const fn with_printed_value(name: &'static str, time: fn(&Start, RiseTolerance) -> Option<f64>) -> Self {
        Self { is_printed: true, ..Self::new(name, time) }
    }

    /// A definition by the average terminal velocity.
    const fn with_average(name: &'static str, time: fn(&Start, RiseTolerance) -> Option<f64>) -> Self {
        Self { is_of_the_average: true, ..Self::with_printed_value(name, time) }
    }

    /// The ways to be near that differ for this quantity.
    fn ways(&self) -> impl Iterator<Item = (Target, Whole)> {
        let (average, printed) = (self.is_of_the_average, self.is_printed);
        RiseTolerance::WAYS.into_iter().filter(move |(target, whole)| {
            (printed || *target == Target::Computed) && !(average && *whole == Whole::TerminalVelocity)
        })
    }
}

/// The definitions nearest to the thesis's, with each of the parts: the time until some velocity of the motion is that
/// near to the steady one.
pub const OF_A_PART: [Definition; 9] = [
    Definition::new("the velocity at every angle from then on", Start::until_profile),
    Definition::with_average("the average of peak and minimum of an engagement, to its end", Start::until_average),
    Definition::new("the entry speed", Start::until_entry_speed),
    Definition::with_printed_value("a peak", Start::until_peak),
    Definition::with_printed_value("a minimum", Start::until_minimum),
    Definition::with_printed_value("a peak or a minimum, whichever is first", Start::until_extreme),
    Definition::new("the mean speed of an engagement, to its end", |start, near| {
        start.until_mean_speed(near).map(|cycle| cycle.end)
    }),
    Definition::new("the mean speed of an engagement, to its start", |start, near| {
        start.until_mean_speed(near).map(|cycle| cycle.start)
    }),
    Definition::with_average(
        "the velocity, when it first comes up to the average of the steady peak and minimum",
        Start::until_average_is_passed,
    ),
];

/// Other events of a start. Two of them are looked for in the lines of the print-out, which have a time of their own.
pub const EVENTS: [Definition; 5] = [
    Definition::new("the first minimum", |start, _| start.first_minimum.map(|minimum| minimum.time)),
    Definition::new("the first minimum after a hand-over", |start, _| start.rise.until_first_minimum()),
    Definition::new("the greatest speed of the first engagement", |start, _| {
        start.rise.cycles.first().map(|cycle| cycle.peak.time)
    }),
    Definition::new("a printed speed within 1% of the largest printed one", |start, _| start.printed_near_largest()),
    Definition::new("a printed minimum within 1%", |start, _| start.printed_minimum()),
];

/// The result of trying a definition.
#[derive(Clone, Debug, PartialEq)]
pub struct DefinitionTrial {
    /// The definition in words.
    pub name: &'static str,
    /// How near the velocity must be; none for an event.
    pub near: Option<RiseTolerance>,
    /// For the runs as they were.
    pub as_run: RiseFit,
    /// For the mechanisms as they are.
    pub ideal: RiseFit,
}

impl DefinitionTrial {
    /// Whether the definition lets so large a part be missing of the quantity itself, with its computed steady value.
    pub fn is_to_a_part_of_itself(&self, part: f64) -> bool {
        self.near == Some(RiseTolerance { part, whole: Whole::Itself, target: Target::Computed })
    }
}

/// How a definition does on the printed rise times.
#[derive(Clone, Debug, PartialEq)]
pub struct RiseFit {
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

impl RiseFit {
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

/// Each definition with each way to be near, and each of these with each part; then the events. In the order of
/// [`OF_A_PART`], [`parts`] and [`EVENTS`].
///
/// `missing` is the part of a velocity that may be missing by the source's own words.
pub fn try_definitions(rows: &[Row], missing: f64) -> Vec<DefinitionTrial> {
    let starts = [Hypothesis::WITHOUT_LAG, Hypothesis::IDEAL]
        .map(|of| rows.iter().map(|row| Start::new(&of, row, missing)).collect::<Vec<_>>());
    let tried = |definition: &Definition, near: Option<RiseTolerance>| {
        let own = near.unwrap_or(RiseTolerance { part: missing, whole: Whole::Itself, target: Target::Computed });
        let [as_run, ideal] = starts.each_ref().map(|starts| {
            let time = |start: &Option<Start>| (definition.time)(start.as_ref()?, own);
            RiseFit::new(rows, starts.iter().map(|start| time(start).unwrap_or(f64::NAN)).collect())
        });
        DefinitionTrial { name: definition.name, near, as_run, ideal }
    };
    let of_parts = OF_A_PART.iter().flat_map(|definition| {
        let near = |(target, whole)| parts(missing).map(|part| RiseTolerance { part, whole, target });
        definition.ways().flat_map(near).map(|near| tried(definition, Some(near))).collect::<Vec<_>>()
    });
    of_parts.chain(EVENTS.iter().map(|definition| tried(definition, None))).collect()
}

/// How many printed rise times the best of all definitions explains, of the runs or of the mechanisms, in each of some
/// shuffles of the printed times.
pub fn shuffles_of_definitions(
    rows: &[Row],
    tried: &[DefinitionTrial],
    shuffled: ShuffleScope,
    shuffles: usize,
) -> Vec<usize> {
    let times = tried.iter().flat_map(|tried| [&*tried.as_run.times, &*tried.ideal.times]);
    shuffles_of_rises(rows, times, shuffled, shuffles)
}

/// The greatest relative change, dimensionless and without its sign, of the time until the velocity is the steady one at every angle, but for a
/// part `missing`, if the friction or one of the inertias of a row as a mechanism is greater or less by the dimensionless `part` of itself,
/// above zero and below one. None if there is no such motion.
pub fn change(row: &Row, missing: f64, part: f64) -> Option<f64> {
    let own = Hypothesis::IDEAL.parameters(row)?;
    let until = |friction: f64, driver: f64, follower: f64| {
        let inertias = Inertias::new(own.inertias().driver() * driver, own.inertias().follower() * follower).ok()?;
        let of = Parameters::new(own.mechanism(), inertias, own.torque(), own.friction() * friction).ok()?;
        Engagement::new(&of).ok()?.until_profile(missing).ok()
    };
    let before = until(1.0, 1.0, 1.0)?;
    let mut most = 0.0;
    for times in [1.0 + part, 1.0 - part] {
        for after in [until(times, 1.0, 1.0)?, until(1.0, times, 1.0)?, until(1.0, 1.0, times)?] {
            most = f64::max(most, (after / before - 1.0).abs());
        }
    }
    Some(most)
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
pub struct TorqueGroup<'a> {
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
pub fn groups<'a>(rows: &'a [Row]) -> Vec<TorqueGroup<'a>> {
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
        Some(TorqueGroup { mechanism, friction, scaled, possible, misread })
    };
    series(rows).filter_map(group).collect()
}
