//! The wheel in 240-bit arithmetic, from its plain formulas, and how far an `f64` is from it.

use dashu_float::{FBig, round::mode::HalfEven};
use geneva_kinematics::indexing::{Indexing, WheelMotion};
use geneva_kinematics::wheel::{self, Wheel};

type Wide = FBig<HalfEven, 2>;

const BITS: usize = 240;

/// Names of what [`Oracle::motion_errors`] gives.
pub(crate) const MOTION: [&str; 4] = ["angle", "velocity ratio", "acceleration ratio", "jerk ratio"];

/// A wheel's α and centre distance to 240 bits.
pub(crate) struct Oracle {
    stations: u32,
    half_pitch_angle: Wide,
    ratio: Wide,
}

fn wide(x: f64) -> Wide {
    Wide::try_from(x).expect("finite").with_precision(BITS).value()
}

/// Distance of `computed` from `exact` in units in the last place of `exact`; infinite if only one of them is zero.
pub(crate) fn ulps(computed: f64, exact: &Wide) -> f64 {
    let near = exact.to_f64().value();
    if near == 0.0 || computed == 0.0 {
        return if near == computed { 0.0 } else { f64::INFINITY };
    }
    let unit = f64::from_bits(near.abs().to_bits() & (0x7ff << 52)) * f64::EPSILON;
    ((wide(computed) - exact) / wide(unit)).to_f64().value().abs()
}

impl Oracle {
    /// For a wheel of so many stations.
    pub(crate) fn new(stations: u32) -> Self {
        let half_pitch_angle = Wide::pi(BITS) / wide(f64::from(stations));
        let ratio = wide(1.0) / half_pitch_angle.sin();
        Self { stations, half_pitch_angle, ratio }
    }

    /// Errors of the motion at a crank angle, less so many parts of a whole turn in so many.
    pub(crate) fn motion_errors(&self, motion: &WheelMotion, crank: f64, (part, parts): (i32, u32)) -> [f64; 4] {
        let turn = wide(2.0) * Wide::pi(BITS) * wide(f64::from(part)) / wide(f64::from(parts));
        let (sin, cos) = (wide(crank) - turn).sin_cos();
        let (one, k) = (wide(1.0), &self.ratio);
        let square = &one + k * k - wide(2.0) * k * &cos;
        let shape = k * (k * k - &one) / (&square * &square);
        let velocity = (k * &cos - &one) / &square;
        let bracket = (&square * &cos - wide(4.0) * k * &sin * &sin) / &square;
        let angle = (&sin / (k - cos)).atan();
        [
            ulps(motion.angle, &angle),
            ulps(motion.velocity, &velocity),
            ulps(motion.acceleration, &-(&shape * sin)),
            ulps(motion.jerk, &-(shape * bracket)),
        ]
    }

    /// Errors of what a wheel is asked without an angle, with their names.
    pub(crate) fn size_errors(&self, wheel: &Wheel) -> Vec<(&'static str, f64)> {
        let (one, two) = (wide(1.0), wide(2.0));
        let (m, cos) = self.half_pitch_angle.sin_cos();
        let gamma = (&one + &m * &m) / (&two * &m);
        let peak_cos = ((&gamma * &gamma + wide(8.0)).sqrt() - &gamma) / &two;
        let peak_sin = (&one - &peak_cos * &peak_cos).sqrt();
        let square = &one + &m * &m - &two * &m * &peak_cos;
        let peak = acceleration(&m, &cos, &peak_sin, &square);
        let (stations, pins) = (wide(f64::from(self.stations)), wide(f64::from(wheel.pins())));
        let motion = &pins * (&stations - &two) / (&two * &stations);
        let entry = Wide::pi(BITS) / &two - &self.half_pitch_angle;
        let found = wheel.acceleration_peak();
        vec![
            ("half station", ulps(wheel.half_pitch_angle(), &self.half_pitch_angle)),
            ("engagement half-angle", ulps(wheel.engagement_half_angle(), &entry)),
            ("centre distance", ulps(wheel.centre_distance_ratio(), &self.ratio)),
            ("wheel radius", ulps(wheel.wheel_radius_ratio(), &(&cos / &m))),
            ("slot length", ulps(wheel.slot_length_ratio(), &((&cos + &m - &one) / &m))),
            ("motion fraction", ulps(wheel.motion_fraction(), &motion)),
            ("dwell fraction", ulps(wheel.dwell_fraction(), &(&one - &motion))),
            ("peak velocity", ulps(wheel.peak_velocity(), &(&m / (&one - &m)))),
            ("entry acceleration", ulps(wheel.entry_acceleration(), &(&m / &cos))),
            ("gamma", ulps(wheel::gamma(wheel), &gamma)),
            ("peak acceleration", ulps(found.ratio, &peak)),
            ("angle of that peak", ulps(found.angle, &(peak_sin / peak_cos).atan())),
        ]
    }
}

/// Size of the acceleration, with the sine of α and its cosine.
fn acceleration(m: &Wide, cos: &Wide, sin: &Wide, square: &Wide) -> Wide {
    m * cos * cos * sin / (square * square)
}
