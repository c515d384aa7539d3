//! The motion of a row, by the solution over the angle and by the program of the thesis on its integrator.

use super::*;
use crate::meyer::appendix_b::delay_parts;
use geneva_dynamics::program::{Contact, Printout, Program, Readings};
use geneva_dynamics::steady::{Engagement, Rise};
use geneva_mimic::AtSmallestStep;
use std::collections::HashMap;
use std::sync::{Mutex, OnceLock};

/// After which angle the driver's angle is reset to the start of an engagement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reset {
    /// After the angle between two pins.
    OfTheMechanism,
    /// After the angle that the program prints, for all three mechanisms.
    QuarterTurn,
}

/// Which of the two pairs of inertias the runs with six pins had.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SixPin {
    /// The inertias in the heading of the table.
    AsHeaded,
    /// The inertias on the axes of Fig. 11.
    AsDrawn,
}

/// Which speed is the greatest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reading {
    /// The greatest in the steady cycle.
    True,
    /// The greatest of the printed ones.
    OnTheGrid,
}

/// How exact the constants of the program are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Constants {
    /// As good as the machine has them.
    Exact,
    /// As the listing prints them: π to five digits, by which it computes the centre distance.
    AsListed,
}

/// What the runs might have been.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hypothesis {
    /// The reset angle.
    pub reset: Reset,
    /// The inertias of the six-pin runs.
    pub six_pin: SixPin,
    /// The reading of the peaks.
    pub reading: Reading,
    /// The constants.
    pub constants: Constants,
    /// Delay of the acceleration that chooses the sign of friction, in s; none if the sign is exact.
    pub delay: Option<f64>,
}

/// What a run gives: speeds in rad/s, times in s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// Greatest speed of the driver.
    pub peak: f64,
    /// Least speed of the driver in the steady cycle.
    pub minimum: f64,
    /// Time from one engagement to the next in the steady cycle.
    pub period: f64,
    /// Time of the first minimum of the driver's speed: the rise time, as the text has it.
    pub first_minimum: f64,
}

impl From<Readings> for Run {
    fn from(Readings { peak, minimum, period, first_minimum }: Readings) -> Self {
        Self { peak, minimum, period, first_minimum }
    }
}

impl Run {
    /// The number of a column; not a number for a column that a run does not give.
    pub fn number(&self, column: Column) -> f64 {
        match column {
            Column::Peak => self.peak,
            Column::Minimum => self.minimum,
            Column::Period => self.period,
            Column::Rise => self.first_minimum,
            _ => f64::NAN,
        }
    }
}

impl Hypothesis {
    /// The hypothesis that explains the tables: one reset angle for all, the inertias of Fig. 11, peaks as printed.
    ///
    /// With the sign exact it has a solution over the angle; see [`as_run`](Self::as_run) for what the program adds.
    pub const WITHOUT_LAG: Self = Self {
        reset: Reset::QuarterTurn,
        six_pin: SixPin::AsDrawn,
        reading: Reading::OnTheGrid,
        constants: Constants::Exact,
        delay: None,
    };

    /// The mechanism as it is.
    pub const IDEAL: Self = Self { reset: Reset::OfTheMechanism, reading: Reading::True, ..Self::WITHOUT_LAG };

    /// The hypothesis of what was run: [`WITHOUT_LAG`](Self::WITHOUT_LAG) with the listing's constants and lagged sign.
    ///
    /// Every cell is judged by it.
    pub fn as_run() -> Self {
        Self { constants: Constants::AsListed, delay: Some(delay()), ..Self::WITHOUT_LAG }
    }

    /// The parameters of a row.
    pub fn parameters(&self, row: &Row) -> Option<Parameters> {
        parameters_with(row, self.inertias(row.mechanism))
    }

    /// Inertias of driver and follower, in in lb s².
    pub fn inertias(&self, mechanism: Mechanism) -> [f64; 2] {
        let six_drawn = mechanism == Mechanism::SIX_PIN && self.six_pin == SixPin::AsDrawn;
        ["driver", "follower"].map(|member| {
            let id = if six_drawn { format!("meyer.fig-11.{member}") } else { heading(mechanism, member) };
            printed(&id) / units_in_one(named(&id).unit)
        })
    }

    /// The reset angle in radians.
    pub fn angle(&self, mechanism: Mechanism) -> f64 {
        match self.reset {
            Reset::OfTheMechanism => 2.0 * PI / f64::from(mechanism.pins()),
            Reset::QuarterTurn => printed("meyer.listing.quarter-turn"),
        }
    }

    /// The engagement of a row, solved over the angle.
    pub fn engagement(&self, row: &Row) -> Option<Engagement> {
        Engagement::reset_after(&self.parameters(row)?, self.angle(row.mechanism), 1e-10).ok()
    }

    /// What the run of a row gives: solved over the angle, or by the program if it is to have its faults.
    pub fn run(&self, row: &Row) -> Option<Run> {
        if self.delay.is_some() || self.constants == Constants::AsListed {
            return self.by_usual_program(row);
        }
        let engagement = self.engagement(row)?;
        let steady = engagement.steady_state().ok()?;
        let peak = match self.reading {
            Reading::True => steady.peak.speed,
            Reading::OnTheGrid => engagement.largest_printed(interval(), 0.0, duration()).ok()?,
        };
        let first_minimum = engagement.first_minimum().ok()?.map_or(f64::NAN, |minimum| minimum.time);
        Some(Run { peak, minimum: steady.minimum.speed, period: steady.period, first_minimum })
    }

    /// By the program as it usually runs; a run is made once.
    fn by_usual_program(&self, row: &Row) -> Option<Run> {
        let own = || rows().iter().position(|other| other == row);
        if let Some(own) = own().filter(|_| Self { reading: Self::as_run().reading, ..*self } == Self::as_run()) {
            let printout = printouts()[own].as_ref()?;
            return Some(Readings::of(printout, self.angle(row.mechanism))?.into());
        }
        type Known = Mutex<HashMap<(usize, Reset, SixPin, Constants, Option<u64>), Option<Run>>>;
        static KNOWN: OnceLock<Known> = OnceLock::new();
        let of = || self.by_program(row, &usual());
        let Some(own) = own() else { return of() };
        let key = (own, self.reset, self.six_pin, self.constants, self.delay.map(f64::to_bits));
        let known = KNOWN.get_or_init(Known::default);
        if let Some(found) = known.lock().ok()?.get(&key) {
            return *found;
        }
        let found = of();
        known.lock().ok()?.insert(key, found);
        found
    }

    /// The numbers of a row's run in the order of the program's parameters: slots, crank angle at the start in radians,
    /// friction, torque in in lb, and the inertias of follower and driver in in lb s².
    pub fn data_card(&self, row: &Row) -> [f64; 6] {
        let [driver, follower] = self.inertias(row.mechanism);
        let start = -row.mechanism.engagement_half_angle();
        [f64::from(row.mechanism.slots()), start, row.friction(), row.torque(), follower, driver]
    }

    /// The run, read off the lines that the program prints; the true peak is not among them.
    pub fn by_program(&self, row: &Row, integrator: &geneva_mimic::Parameters) -> Option<Run> {
        let program = self.program(row)?;
        Some(Readings::of(&program.run(integrator).ok()?, program.reset)?.into())
    }

    /// The start of a row's run from rest.
    pub fn rise(&self, row: &Row) -> Option<Rise> {
        self.engagement(row)?.rise(1e-6).ok()
    }

    /// The program of the thesis with a row's cards.
    pub fn program(&self, row: &Row) -> Option<Program> {
        let exact = Program::of(&self.parameters(row)?);
        let ratio = match self.constants {
            Constants::Exact => exact.ratio,
            Constants::AsListed => 1.0 / libm::sin(printed("meyer.listing.pi") / f64::from(row.mechanism.slots())),
        };
        let contact = self.delay.map_or(Contact::Exact, Contact::Delayed);
        Some(Program { reset: self.angle(row.mechanism), ratio, contact, ..exact })
    }

    /// The least speed, the period and the greatest speed of the steady cycle by the second route, for a torque and a
    /// follower of one: by equal steps of θ.
    pub fn cycle_by_steps(&self, row: &Row) -> Option<[f64; 3]> {
        type Known = Mutex<HashMap<(Mechanism, String, Reset, SixPin), Option<[f64; 3]>>>;
        static KNOWN: OnceLock<Known> = OnceLock::new();
        let key = (row.mechanism, row.printed(Column::Friction).to_owned(), self.reset, self.six_pin);
        let known = KNOWN.get_or_init(Known::default);
        if let Some(found) = known.lock().ok()?.get(&key) {
            return *found;
        }
        let found = self.parameters(row).and_then(|of| steps::cycle(&of, self.angle(row.mechanism), STEPS));
        known.lock().ok()?.insert(key, found);
        found
    }
}

/// Steps of an engagement.
const STEPS: u32 = 750;

/// The parameters of a row with these inertias of driver and follower, in in lb s².
pub fn parameters_with(row: &Row, [driver, follower]: [f64; 2]) -> Option<Parameters> {
    Parameters::new(row.mechanism, Inertias::new(driver, follower).ok()?, row.torque(), row.friction()).ok()
}

/// How many of a unit with a power of ten before it make one unit without it.
pub fn units_in_one(unit: &str) -> f64 {
    let power = unit.split_once("10^").and_then(|(_, behind)| behind.split(' ').next()?.parse::<i32>().ok());
    power.map_or(f64::NAN, |power| match libm::pow(10.0, f64::from(power.abs())) {
        size if power < 0 => size,
        size => 1.0 / size,
    })
}

/// The id of an inertia in the heading of a table.
pub fn heading(mechanism: Mechanism, member: &str) -> String {
    format!("meyer.app-e.{}.{member}", slug(mechanism))
}

/// The interval of the printed lines, in s.
pub fn interval() -> f64 {
    printed("meyer.listing.print-interval")
}

/// The interval that reproduces the peaks of all rows best, of half the printed interval, the interval itself and twice
/// as much.
///
/// The motion is solved over the angle, or by the steps of the program.
pub fn fitting_interval(by_steps: bool) -> f64 {
    static FITTING: [OnceLock<f64>; 2] = [const { OnceLock::new() }; 2];
    let misfit = |interval: f64| {
        let of = |row: &Row| {
            let largest = if by_steps {
                let integrator = geneva_mimic::Parameters {
                    print_interval: interval,
                    largest_step: interval,
                    initial_step: interval,
                    ..usual()
                };
                Hypothesis::WITHOUT_LAG.program(row)?.run(&integrator).ok()?.largest()
            } else {
                Hypothesis::WITHOUT_LAG.engagement(row)?.largest_printed(interval, 0.0, duration()).ok()?
            };
            Some((largest / row.number(Column::Peak) - 1.0).abs())
        };
        rows().iter().map(|row| of(row).unwrap_or(f64::INFINITY)).sum::<f64>()
    };
    let candidates = [interval() / 2.0, interval(), 2.0 * interval()];
    let best = || {
        let misfits = candidates.map(|interval| (interval, misfit(interval)));
        misfits.into_iter().min_by(|a, b| a.1.total_cmp(&b.1)).map_or(f64::NAN, |(interval, _)| interval)
    };
    *FITTING[usize::from(by_steps)].get_or_init(best)
}

/// By how much the old acceleration is late, in s: a part of the print interval.
pub fn delay() -> f64 {
    interval() / delay_parts()
}

/// The length of a run, in s.
pub fn duration() -> f64 {
    printed("meyer.listing.run-length")
}

/// The integrator as far as the thesis tells, with the defaults for the rest.
///
/// A step may be longer than the delay; the old acceleration is then the acceleration of the step before.
pub fn usual() -> geneva_mimic::Parameters {
    geneva_mimic::Parameters {
        at_smallest_step: AtSmallestStep::Continue,
        ..geneva_mimic::Parameters::new(interval(), duration())
    }
}

/// What the program printed for each row as it ran: one run for all that is asked of its lines.
pub fn printouts() -> &'static [Option<Printout>] {
    static PRINTED: OnceLock<Vec<Option<Printout>>> = OnceLock::new();
    let run = |row: &Row| Hypothesis::as_run().program(row)?.run(&usual()).ok();
    PRINTED.get_or_init(|| rows().iter().map(run).collect())
}

/// The scale of speeds of a row: √(K / I_f), in rad/s.
pub fn unit_of_speed(hypothesis: &Hypothesis, row: &Row) -> f64 {
    hypothesis.parameters(row).map_or(f64::NAN, |parameters| parameters.drive().sqrt())
}
