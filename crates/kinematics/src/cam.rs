//! A cam that indexes by the modified-sine law, to compare a Geneva wheel with.
//!
//! The acceleration is a sine of the period 1/2 of the rise's time in its first and last eighth, and of 3/2 between.

use std::f64::consts::PI;

/// The greatest acceleration of a rise by the modified-sine law, 4 π²/(4 + π) times the rise over the square of its time.
///
/// `rise` and `time` are in your own units, an angle and the driver's turn in radians, for example: the result is in that of the
/// rise over the square of that of the time. `time` is not zero.
///
/// ```
/// use geneva_kinematics::cam::modified_sine_peak;
///
/// // Speeds grow in the first half of the rise: of the acceleration C sin(4 π t) for 1/8 and C sin((π + 4 π t)/3) until 1/2.
/// // Integrated twice, twice as much is the whole rise.
/// let peak = modified_sine_peak(1.0, 1.0);
/// let steps = 100_000;
/// let (mut speed, mut rise) = (0.0, 0.0);
/// for step in 0..steps {
///     use std::f64::consts::PI;
///     let time = (f64::from(step) + 0.5) / f64::from(2 * steps);
///     let sine = if time < 0.125 { (4.0 * PI * time).sin() } else { ((PI + 4.0 * PI * time) / 3.0).sin() };
///     speed += peak * sine / f64::from(2 * steps);
///     rise += speed / f64::from(2 * steps);
/// }
/// assert!((2.0 * rise - 1.0).abs() < 1e-4);
/// ```
pub fn modified_sine_peak(rise: f64, time: f64) -> f64 {
    4.0 * PI * PI / (4.0 + PI) * rise / (time * time)
}
