//! What the letters of the leaflet's equations stand for, by numbers from two places that share no formula.

use geneva_evidence::Finding;
use geneva_evidence::tex::{Moment, holds};
use std::f64::consts::TAU;
use std::sync::OnceLock;

/// Whether the characters hold for a body that falls with its mean speed, and for the bob of a conical pendulum.
pub(crate) fn hold_by_means(tex: &str) -> Finding {
    Finding::of_reading(holds(tex, &[means([9.81, 1.3, 2.0]), means([1.62, 2.7, 0.7])]))
}

/// Whether the characters hold for a body and a pendulum that are moved in small steps of time.
pub(crate) fn hold_in_steps(tex: &str) -> Option<bool> {
    static MOMENTS: OnceLock<[Moment; 2]> = OnceLock::new();
    holds(tex, MOMENTS.get_or_init(|| [steps([3.7, 2.1, 1.9]), steps([8.9, 0.6, 0.8])]))
}

/// Letters from the gravity, the time of the fall and the angular speed of a conical pendulum, whose bob goes around on a
/// small circle: there, the pull to the middle over the radius is the square of the angular speed, and gravity over length.
fn means([gravity, time, angular_speed]: [f64; 3]) -> Moment {
    let speed = gravity * time;
    let height = speed / 2.0 * time;
    let length = gravity / angular_speed / angular_speed;
    letters([gravity, time, speed, height, length, TAU / angular_speed])
}

/// Letters from the gravity, the time of the fall and the length of the pendulum.
fn steps([gravity, time, length]: [f64; 3]) -> Moment {
    let [height, speed] = crate::steps::fall(gravity, time);
    letters([gravity, time, speed, height, length, crate::steps::small_period(gravity, length)])
}

fn letters([gravity, time, speed, height, length, period]: [f64; 6]) -> Moment {
    let named = [("g", gravity), ("t", time), ("v", speed), ("h", height), ("l", length), ("T", period), ("m", 2.3)];
    Moment::default().with(named)
}
