//! What the runs might have been, and what a run gives then.
//!
//! This is the one place where a row is run: by the solution over the angle, or by the program if it is to have its own
//! faults. Every score, table, figure and page asks here.

use crate::program::{Printout, Program1973, SignRule};
use crate::{Row, Run};
use geneva_dynamics::steady::{Engagement, Rise};
use geneva_dynamics::{Inertias, Parameters};

/// After which angle the driver's angle is reset to the start of an engagement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reset {
    /// After the angle between two pins.
    OfTheMechanism,
    /// After the angle in the listing of the program, a quarter of a turn, for all mechanisms.
    QuarterTurn,
    /// After this angle in radians, for all mechanisms.
    After(f64),
}

/// Which of the two pairs of inertias the runs with six pins had.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SixPin {
    /// The inertias in the heading of the table.
    AsHeaded,
    /// The inertias on the axes of Fig. 11.
    AsDrawn,
}

/// Which speed is the greatest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PeakReading {
    /// The greatest in the steady cycle.
    True,
    /// The greatest of the printed ones.
    OnTheGrid,
}

/// How exact the constants of the program are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constants {
    /// As good as the machine has them.
    Exact,
    /// As in the listing: its π, by which it computes the centre distance.
    AsListed,
}

/// How late the acceleration is that chooses the sign of friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lag {
    /// Not at all: the sign is exact.
    None,
    /// As late as in the listing.
    AsListed,
    /// As late as this, in s.
    Of(f64),
}

/// What the runs might have been.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hypothesis {
    /// The reset angle.
    pub reset: Reset,
    /// The inertias of the six-pin runs.
    pub six_pin: SixPin,
    /// The reading of the peaks.
    pub reading: PeakReading,
    /// The constants.
    pub constants: Constants,
    /// The lag of the sign.
    pub lag: Lag,
}

impl Hypothesis {
    /// Relative error of the solution over the angle, dimensionless.
    pub const TOLERANCE: f64 = 1e-10;

    /// How near to its steady state a rise is followed, relative to it, dimensionless: far below any part of a velocity that a
    /// definition of the rise time lets be missing.
    pub const RISE_TOLERANCE: f64 = 1e-6;

    /// The hypothesis that explains the tables: one reset angle for all, the inertias of Fig. 11, peaks as printed.
    ///
    /// With the sign exact it has a solution over the angle; see [`AS_RUN`](Self::AS_RUN) for what the program adds.
    pub const WITHOUT_LAG: Self = Self {
        reset: Reset::QuarterTurn,
        six_pin: SixPin::AsDrawn,
        reading: PeakReading::OnTheGrid,
        constants: Constants::Exact,
        lag: Lag::None,
    };

    /// The mechanism as it is.
    pub const IDEAL: Self = Self { reset: Reset::OfTheMechanism, reading: PeakReading::True, ..Self::WITHOUT_LAG };

    /// The hypothesis of what was run: [`WITHOUT_LAG`](Self::WITHOUT_LAG) with the listing's constants and lagged sign.
    pub const AS_RUN: Self = Self { constants: Constants::AsListed, lag: Lag::AsListed, ..Self::WITHOUT_LAG };

    /// Inertias of driver and follower, in in lb s².
    pub fn inertias(&self, row: &Row) -> [f64; 2] {
        match self.six_pin {
            SixPin::AsHeaded => row.given.headed,
            SixPin::AsDrawn => row.given.drawn,
        }
    }

    /// The reset angle in radians.
    pub fn angle(&self, row: &Row) -> f64 {
        match self.reset {
            Reset::OfTheMechanism => 2.0 * row.mechanism.engagement_half_angle(),
            Reset::QuarterTurn => row.given.listing.reset,
            Reset::After(angle) => angle,
        }
    }

    /// The parameters of a row; none if they make no escapement.
    pub fn parameters(&self, row: &Row) -> Option<Parameters> {
        let [driver, follower] = self.inertias(row);
        let inertias = Inertias::new(driver, follower).ok()?;
        Parameters::new(row.mechanism, inertias, row.torque(), row.friction()).ok()
    }

    /// The engagement of a row, solved over the angle.
    pub fn engagement(&self, row: &Row) -> Option<Engagement> {
        Engagement::reset_after(&self.parameters(row)?, self.angle(row), Self::TOLERANCE).ok()
    }

    /// The start of a row's run from rest.
    pub fn rise(&self, row: &Row) -> Option<Rise> {
        self.engagement(row)?.rise(Self::RISE_TOLERANCE).ok()
    }

    /// What the run of a row gives: solved over the angle, or by the program if it is to have its faults. None if there
    /// is no such motion.
    pub fn run(&self, row: &Row) -> Option<Run> {
        if self.has_faults() {
            return self.run_by_program(row, &row.given.listing.integrator());
        }
        let [peak, minimum, period] = self.results(row)?;
        let first_minimum = self.engagement(row)?.first_minimum().ok()?.map_or(f64::NAN, |minimum| minimum.time);
        Some(Run { peak, minimum, period, first_minimum })
    }

    /// Peak, minimum and period of a run, each in its own unit: what a hypothesis is to explain. None if there is no such
    /// motion.
    pub fn results(&self, row: &Row) -> Option<[f64; 3]> {
        let listing = &row.given.listing;
        if self.has_faults() {
            return Some(self.run_by_program(row, &listing.integrator())?.results());
        }
        let engagement = self.engagement(row)?;
        let steady = engagement.steady_state().ok()?;
        let peak = match self.reading {
            PeakReading::True => steady.peak.speed,
            PeakReading::OnTheGrid => {
                engagement.largest_printed(listing.interval, listing.first_line, listing.duration).ok()?
            }
        };
        Some([peak, steady.minimum.speed, steady.period])
    }

    /// Whether only the program has such runs.
    fn has_faults(&self) -> bool {
        self.lag != Lag::None || self.constants == Constants::AsListed
    }

    /// The run, read off the lines that the program prints; the true peak is not among them.
    pub fn run_by_program(&self, row: &Row, integrator: &geneva_mimic::SolverParameters) -> Option<Run> {
        let program = self.program(row)?;
        Run::read_off(&program.run(integrator).ok()?, program.reset)
    }

    /// What the program prints for a row, on the integrator of the listing.
    pub fn printout(&self, row: &Row) -> Option<Printout> {
        self.program(row)?.run(&row.given.listing.integrator()).ok()
    }

    /// The program of the thesis with a row's cards.
    pub fn program(&self, row: &Row) -> Option<Program1973> {
        let exact = Program1973::ideal(&self.parameters(row)?);
        let ratio = match self.constants {
            Constants::Exact => exact.ratio,
            Constants::AsListed => 1.0 / libm::sin(row.given.listing.pi / f64::from(row.mechanism.slots())),
        };
        let sign_rule = match self.lag {
            Lag::None => SignRule::Exact,
            Lag::AsListed => SignRule::Delayed(row.given.listing.delay),
            Lag::Of(delay) => SignRule::Delayed(delay),
        };
        Some(Program1973 { reset: self.angle(row), ratio, sign_rule, ..exact })
    }

    /// The numbers of a row's run in the order of the program's parameters: slots, crank angle at the start in radians,
    /// friction, torque in in lb, and the inertias of follower and driver in in lb s².
    pub fn data_card(&self, row: &Row) -> [f64; 6] {
        let [driver, follower] = self.inertias(row);
        let start = -row.mechanism.engagement_half_angle();
        [f64::from(row.mechanism.slots()), start, row.friction(), row.torque(), follower, driver]
    }

    /// The hypothesis in one short line of a figure: reset angle, inertias and reading, then what differs from the
    /// usual.
    pub fn brief_words(&self) -> String {
        let reset = match self.reset {
            Reset::OfTheMechanism => "reset after 360°/m".to_owned(),
            Reset::QuarterTurn => "reset after 90°".to_owned(),
            Reset::After(angle) => format!("reset after {}°", angle.to_degrees()),
        };
        let inertias = match self.six_pin {
            SixPin::AsHeaded => "inertias as headed",
            SixPin::AsDrawn => "as in Fig. 11",
        };
        let reading = match self.reading {
            PeakReading::True => "true peaks",
            PeakReading::OnTheGrid => "printed peaks",
        };
        let constants = (self.constants == Constants::AsListed).then_some("listed π");
        let sign = (self.lag != Lag::None).then_some("lagged sign");
        let parts: Vec<_> = [&*reset, inertias, reading].into_iter().chain(constants).chain(sign).collect();
        parts.join(", ")
    }
}

/// The interval between printed lines, in s, that reproduces the peaks of some rows best: of half the listed interval,
/// the interval itself and twice as much. The motion is solved over the angle, or by the steps of the program.
pub fn fitting_interval(rows: &[Row], by_steps: bool) -> f64 {
    let misfit = |times: f64| {
        let of = |row: &Row| {
            let listing = row.given.listing;
            let interval = times * listing.interval;
            let largest = if by_steps {
                let integrator = geneva_mimic::SolverParameters {
                    print_interval: interval,
                    largest_step: interval,
                    initial_step: interval,
                    ..listing.integrator()
                };
                Hypothesis::WITHOUT_LAG.program(row)?.run(&integrator).ok()?.largest()
            } else {
                Hypothesis::WITHOUT_LAG.engagement(row)?.largest_printed(interval, 0.0, listing.duration).ok()?
            };
            Some((largest / row.number(crate::Column::Peak) - 1.0).abs())
        };
        rows.iter().map(|row| of(row).unwrap_or(f64::INFINITY)).sum::<f64>()
    };
    let misfits = [0.5, 1.0, 2.0].map(|times| (times, misfit(times)));
    let best = misfits.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
    let listed = rows.first().map_or(f64::NAN, |row| row.given.listing.interval);
    best.map_or(f64::NAN, |(times, _)| times * listed)
}
