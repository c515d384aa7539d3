//! The lecture handout: the N-station Geneva wheel, its kinematics and a worked example.
//!
//! The claims follow the order of the source: the four-station wheel and its equations, the general wheel, the example.
//! The wheel of the example is [`example`].

mod counts;
mod curves;
mod duration;
mod dwell;
mod example;
mod extreme;
mod four;
mod general;
mod letters;
mod locking;
mod peak;
mod spherical;
mod symbols;
mod text;

pub use locking::LockingArcs;
pub use symbols::SYMBOLS;

use crate::duals::halved;
use geneva_evidence::agreement::{agrees, same, vanishes};
use geneva_evidence::tex::{by_name, value};
use geneva_evidence::{
    Cache, Claim, Consequence, Document, Evidence, Finding, InventoryFile, Locator, Origin, Slip, Stated,
};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::pin_slot::pin_from_pivot;
use geneva_kinematics::wheel::{STATIONS, Wheel};
use geneva_kinematics::{Jet, Turn, angular_velocity};
use num_dual::DualNum;
use std::f64::consts::PI;
use std::sync::OnceLock;

/// A lecture handout of 2003: the N-station Geneva wheel.
pub static JAZAR: Document = Document {
    slug: "jazar",
    title: "handout",
    citation: "G. Nakhaie Jazar, lecture handout on the Geneva mechanism, ME341 Mechanics of Machinery, North Dakota \
        State University, Fargo, fall 2003. Equations (5.25) to (5.34), figures 5.28 to 5.31 (captions only).",
    inventory: Some(InventoryFile {
        path: "crates/documents/sources/jazar.inventory",
        text: include_str!("../../sources/jazar.inventory"),
    }),
    claims,
    answers: ANSWERS,
    given: Vec::new,
    conclusions: &[],
    symbols: SYMBOLS,
    units: &[
        ("speed of the driver", "rpm"),
        ("angular velocity", "rad/s"),
        ("angular acceleration", "rad/s²"),
        ("angle", "°"),
        ("half the angle", "°"),
        ("duration", "s"),
        ("advances per second", "per second"),
        ("number of stations", "stations"),
        ("dwelling part of the cycle", ""),
        ("crank angle at which the wheel is fastest", ""),
        ("sin α", ""),
        ("γ of the", ""),
        ("magnitude of the acceleration of the six-station wheel, divided by", ""),
    ],
    test: "cargo test -p geneva-documents --test verdicts jazar_stands",
    cache: Cache::new(),
};

/// A place in this source.
const fn at(locator: &'static str) -> Locator {
    Locator::new(&JAZAR, locator)
}

/// All claims of the handout, in the order of the source.
pub fn claims() -> Vec<Claim> {
    [
        text::claims(),
        counts::of_the_caption(),
        four::claims(),
        curves::claims(),
        duration::claims(),
        general::claims(),
        spherical::claims(),
        counts::of_the_example(),
        example::claims(),
        peak::claims(),
    ]
    .concat()
}

/// What parts (a) to (e) of the example ask for.
pub const ANSWERS: &[&str] = &[
    "jazar.ex-a.advances",
    "jazar.ex-b.advance",
    "jazar.ex-c.dwell",
    "jazar.ex-c.dwell-seconds",
    "jazar.ex-d.peak",
    "jazar.ex-e.peak",
];

/// The wheel of the example, from the printed number of stations.
pub fn example() -> Result<Wheel, KinematicsError> {
    Wheel::new(JAZAR.printed_number("jazar.ex.stations") as u32)
}

/// The angular speed of the example's driver in rad/s, from the printed revolutions per minute.
pub fn example_speed() -> f64 {
    JAZAR.printed_number("jazar.ex.rpm") / 60.0 * 2.0 * PI
}

/// The wheel of the equations (5.25) to (5.29) and of the figures 5.28 to 5.30.
pub fn four_stations() -> Result<Wheel, KinematicsError> {
    Wheel::new(4)
}

/// A quantity of the example's wheel.
fn six(quantity: impl Fn(&Wheel) -> f64) -> f64 {
    example().map_or(f64::NAN, |wheel| quantity(&wheel))
}

/// A quantity of a wheel of so many stations.
fn of(stations: u32, quantity: impl Fn(&Wheel) -> f64) -> f64 {
    Wheel::new(stations).map_or(f64::NAN, |wheel| quantity(&wheel))
}

/// All wheels of the formula crate, one for each number of stations.
fn wheels() -> &'static [Wheel] {
    static WHEELS: OnceLock<Vec<Wheel>> = OnceLock::new();
    WHEELS.get_or_init(|| STATIONS.filter_map(|stations| Wheel::new(stations).ok()).collect())
}

/// Of which numbers of stations these are.
fn numbers_of_stations() -> String {
    format!("every number of stations from {} to {}", STATIONS.start(), STATIONS.end())
}

/// Whether a property holds for each number of stations that a wheel can have.
///
/// The greatest number is that of the formula crate. With many stations the angles at the wheel are small: what is taken
/// from their cosines, or from differences of squares of lengths, is lost in rounding there, so the routes avoid both.
fn for_all_stations(holds: impl Fn(&Wheel) -> bool, how: &str) -> Finding {
    let failing: Vec<u32> = wheels().iter().filter(|wheel| !holds(wheel)).map(Wheel::stations).collect();
    let how = match failing[..] {
        [] => format!("with {}, {how}", numbers_of_stations()),
        [first] => format!("with {first} stations it is not true that {how}"),
        [first, .., last] if failing.len() == wheels().len() => {
            format!("for no number of stations from {first} to {last} is it true that {how}")
        }
        [first, .., last] => {
            format!("for {} numbers of stations, from {first} to {last}, it is not true that {how}", failing.len())
        }
    };
    Finding::new(failing.is_empty(), how)
}

/// A finding about the wheel of four.
fn about_four(holds: impl Fn(&Wheel) -> Finding) -> Finding {
    four_stations().map_or_else(|error| Finding::new(false, error.to_string()), |wheel| holds(&wheel))
}

/// Whether both sides of an equation for four stations agree at instants all over the advance.
fn at_instants(sides: impl Fn(&Wheel, f64) -> (f64, f64)) -> Finding {
    about_four(|wheel| {
        let apart = |(a, b): (f64, f64)| (a - b).abs() / a.abs().max(b.abs()).max(1.0);
        let worst = greatest(instants(wheel).map(|t| apart(sides(wheel, t))));
        let holds = worst <= geneva_evidence::ROUTES.relative;
        Finding::new(holds, format!("the two sides differ by at most {worst:.0e} at 90 instants"))
    })
}

/// Ninety crank angles all over the advance, none of them zero and none at its ends.
fn instants(wheel: &Wheel) -> impl Iterator<Item = f64> {
    let end = wheel.engagement_half_angle();
    (-45..45).map(move |step| end * (f64::from(step) + 0.5) / 45.5)
}

/// Crank angles from minus to plus this one, the ends left out, the middle among them.
fn within(reach: f64) -> impl Iterator<Item = f64> {
    (-10..=10).map(move |step| reach * f64::from(step) / 11.0)
}

/// Wheel angle and its first three derivatives by the crank angle, from the pin's place as a power series.
fn by_series(wheel: &Wheel, crank: f64) -> [f64; 4] {
    at_speed(wheel, crank, 1.0)
}

/// Wheel angle and its first three derivatives by time, for a driver of this speed.
fn at_speed(wheel: &Wheel, crank: f64, speed: f64) -> [f64; 4] {
    let turn = Turn::from_radians(crank).moving::<4>(speed);
    let place = pin_from_pivot(&Jet::constant(wheel.centre_distance_ratio()), &turn);
    let angle = libm::atan2(place.y.value(), place.x.value());
    let series = angular_velocity(&place);
    let derivative = |order| series.as_ref().and_then(|series| series.derivative(order)).unwrap_or(f64::NAN);
    [angle, derivative(0), derivative(1), derivative(2)]
}

/// Angle of a wheel with its axes `ratio` crank radii apart and its first three derivatives by time, for a driver of this
/// angle, speed and angular acceleration, by another library's dual numbers: it differentiates Eq. (5.30) and shares no code
/// with [`by_series`]. Its sines are the platform's, so nothing of it is printed.
fn rates(ratio: f64, crank: f64, [speed, angular_acceleration]: [f64; 2]) -> [f64; 4] {
    let rates = num_dual::third_derivative(
        |time| {
            let (s, c) = (time * speed + time * time * (angular_acceleration / 2.0) + crank).sin_cos();
            (s / (-c + ratio)).atan()
        },
        0.0,
    );
    rates.into()
}

/// Wheel angle and its first three derivatives by the crank angle, by dual numbers.
fn by_duals(wheel: &Wheel, crank: f64) -> [f64; 4] {
    rates(libm::sin(wheel.half_pitch_angle()).recip(), crank, [1.0, 0.0])
}

/// Angular acceleration of the wheel and its rate of change by dual numbers, for a driver of this speed and angular
/// acceleration.
fn unsteady_by_duals(wheel: &Wheel, crank: f64, speed: f64, angular_acceleration: f64) -> [f64; 2] {
    let ratio = libm::sin(wheel.half_pitch_angle()).recip();
    let [_, _, acceleration, rate] = rates(ratio, crank, [speed, angular_acceleration]);
    [acceleration, rate]
}

/// What the display with this id gives as it is printed, for a wheel at a crank angle whose driver has this speed and
/// acceleration.
fn by_display(id: &str, wheel: &Wheel, theta: f64, [speed, acceleration]: [f64; 2]) -> f64 {
    let alpha = wheel.half_pitch_angle();
    let letters = [("alpha", alpha), ("theta", theta), ("theta'", speed), ("theta''", acceleration)];
    value(JAZAR.right_side(id), &by_name(letters))
}

/// What the display with this id gives as it is printed, for a driver of speed one.
fn steady_display(id: &str, wheel: &Wheel, theta: f64) -> f64 {
    by_display(id, wheel, theta, [1.0, 0.0])
}

/// Distance of the pin from the wheel's axis in crank radii, and the wheel's angle, by the law of cosines alone.
///
/// The angle by the tangent of its half, the root of (s − l)(s − x) / (s (s − 1)) with half the sum of the sides for s and
/// the pin's distance for x: 4 (s − l)(s − x) is 1 − (x − l)², and that times 4 s (s − 1) is 4 l² sin² θ.
fn by_cosines(ratio: f64, crank: f64) -> (f64, f64) {
    let distance = (1.0 + ratio * ratio - 2.0 * ratio * libm::cos(crank)).sqrt();
    let sum = ratio + distance;
    (distance, 2.0 * libm::atan(2.0 * ratio * libm::sin(crank) / (sum * sum - 1.0)))
}

/// The greatest of numbers that are not negative; not a number if one of them is not.
fn greatest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, |most, number| if most >= number || most.is_nan() { most } else { number })
}

/// The pin's place as it enters, from the wheel's axis.
fn entry(wheel: &Wheel) -> nalgebra::Vector2<f64> {
    pin_from_pivot(&wheel.centre_distance_ratio(), &Turn::from_radians(-wheel.engagement_half_angle()))
}

/// The pin's place from the wheel's axis, with the driver's axis to the right of it and the driver turned clockwise by
/// this angle from the line of centres.
fn turned_clockwise(wheel: &Wheel, angle: f64) -> nalgebra::Vector2<f64> {
    nalgebra::Vector2::new(wheel.centre_distance_ratio() + libm::cos(PI - angle), libm::sin(PI - angle))
}

/// What is found once for each number of stations.
type OfWheels<T> = [OnceLock<T>; *STATIONS.end() as usize + 1];

/// Crank angle between entry and exit, from where the wheel of the power series is at rest.
fn entry_crank(wheel: &Wheel) -> f64 {
    static FOUND: OfWheels<f64> = [const { OnceLock::new() }; _];
    let find = || 2.0 * halved([0.0, PI / 2.0], |t| by_series(wheel, t)[1] > 0.0)[0];
    *FOUND[wheel.stations() as usize].get_or_init(find)
}

/// Angle and size of the greatest acceleration, by halving the interval in which the third derivative changes sign.
fn peak_by_series(wheel: &Wheel) -> (f64, f64) {
    static FOUND: OfWheels<(f64, f64)> = [const { OnceLock::new() }; _];
    *FOUND[wheel.stations() as usize].get_or_init(|| {
        let [angle, _] = halved([0.0, wheel.engagement_half_angle()], |t| by_series(wheel, t)[3] < 0.0);
        (angle, by_series(wheel, angle)[2].abs())
    })
}
