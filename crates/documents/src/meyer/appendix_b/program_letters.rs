//! What the names of the program stand for: exactly, from the pin's place and from chapter I's equation of motion; and by
//! numbers, from the mechanism by coordinates and Newton's laws for its two members.

use super::*;
use crate::duals::halved;
use crate::meyer::hand_over_letters::RATIO as FOOT;
use crate::meyer::letters::{factors, mechanism, start_of_program};
use crate::meyer::reading::{self, Letters, Moment};
use crate::triangle::angle;
use geneva_evidence::Vocabulary;
use geneva_kinematics::{Expression, Jet, Turn, angular_velocity, pin_slot};
use std::array::from_fn;
use std::sync::OnceLock;

/// The ratio and the number of slots.
pub(super) const RATIO: Vocabulary = Vocabulary::new(ratio, Evidence::VECTORS, ratios);
/// Where the pin is and how it moves.
pub(super) const PLACES: Vocabulary = Vocabulary::new(places, Evidence::VECTORS, lines);
/// The factors of the equation of motion.
pub(super) const FACTORS: Vocabulary = Vocabulary::new(of_mechanism, Evidence::VECTORS, lines);
/// The equation of motion, solved for the acceleration.
pub(super) const SOLVED: Vocabulary = Vocabulary::new(solved, Evidence::VECTORS, lines);
/// Where the pin is at the start, which may be at any angle: most of it vanishes at the start itself.
pub(super) const PLACES_AT_START: Vocabulary = Vocabulary::new(places, Evidence::VECTORS, rests);
/// The factors at the start.
pub(super) const FACTORS_AT_START: Vocabulary = Vocabulary::new(of_mechanism, Evidence::VECTORS, rests);
/// The equation of motion at the start, solved for the acceleration.
pub(super) const START: Vocabulary = Vocabulary::new(start_of_program, Evidence::VECTORS, rests);

/// Variables as in [`FOOT`].
fn ratio(bars: i64) -> Moment<Expression> {
    let foot = (FOOT.exact)(bars);
    let ratio = foot.letters()["a"];
    foot.with([("G", ratio)])
}

fn ratios() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    let called = |moment: &Moment| moment.clone().called([("G", "a"), ("N", "n")]);
    FOUND.get_or_init(|| (FOOT.numbers)().iter().map(called).collect())
}

/// The pin by its coordinates. Variables: a, tangent of θ/2, θ'.
fn places(_: i64) -> Moment<Expression> {
    let [ratio, half, speed] = from_fn(Expression::variable);
    let crank = Turn::from_half_tangent(&half);
    let path = |rate: Expression| pin_slot::pin_path(&ratio, &crank.moving::<2>(rate));
    let of = |jet: Jet<Expression, 2>| [jet.value(), jet.rate()];
    let pin = path(Expression::ONE);
    let [square, growth] = of(pin.x * pin.x + pin.y * pin.y);
    let ([x, along], [y, across]) = (of(pin.x), of(pin.y));
    let moment_of_velocity = x * across - y * along;
    // The power of the follower's axis in the circle of the pins: near and far point, on either side of the driver's axis.
    let [near, far] = [Expression::ONE, -Expression::ONE]
        .map(|cos| pin_slot::pin_from_pivot(&ratio, &Turn { cos, sin: Expression::ZERO }).x);
    let turning = angular_velocity(&path(speed)).expect("the pin is off the follower's axis");
    Moment::default()
        .with([("G", ratio), ("H", moment_of_velocity), ("I", growth / 2), ("J", -(near * far)), ("L", square)])
        .with([("Q", moment_of_velocity), ("P", square)])
        .with([(r"\text{1DX}", speed), (r"\text{PHIDOT}", turning.value())])
        .with_angles([("X", angle(&crank)), (r"\text{X0}", angle(&crank))])
}

/// The names of the program for chapter I's letters. Variables as in [`mechanism`].
fn of_mechanism(bars: i64) -> Moment<Expression> {
    let chapter = mechanism(bars);
    let letter = |name: &str| chapter.letters()[name];
    let [ratio, radius, distance] = ["a", "r", "R"].map(letter);
    let square = distance * distance / (radius * radius);
    let lead = letter("phi'") / letter("theta'") * square;
    let growth = letter("h") * distance / (radius * radius);
    let between = -bars * letter("tau_2") / letter("I_f");
    let same = ["A", "B", "C", "D", "E", "K"].map(|name| (name, letter(name)));
    Moment::default()
        .with(same)
        .with([("G", ratio), ("H", lead), ("I", growth), ("J", 1 - ratio * ratio), ("L", square)])
        .with([("Q", lead), ("P", square), ("R", letter("A")), ("V", bars * letter("D")), ("F", between)])
        .with([("U", letter("mu")), (r"\text{IC}", letter("I_D")), (r"\text{IW}", letter("I_f"))])
        .with([(r"\text{1DX}", letter("theta'"))])
        .with([r"\text{2DX}", r"\text{OLD2DX}"].map(|name| (name, letter("theta''"))))
        .giving(r"\sin \text{X0}", growth / ratio)
        .opening_bars(bars * Expression::ONE)
}

/// Variables as in [`factors`].
fn solved(bars: i64) -> Moment<Expression> {
    let chapter = factors(bars);
    let motion =
        [(r"\text{1DX}", "theta'"), (r"\text{2DX}", "theta''")].map(|(name, of)| (name, chapter.letters()[of]));
    chapter.with(motion)
}

/// The program's letters at an instant of chapter I: what its lines must compute, by coordinates and Newton's laws.
fn letters(moment: &Moment) -> Letters {
    let letter = letters_of(moment);
    let square = letter("square");
    let lead = letter("phi'") / letter("theta'") * square;
    let mut letters = reading::by_name([
        ("N", PI / libm::asin(letter("r") / letter("c"))),
        ("G", letter("c") / letter("r")),
        ("X", letter("theta")),
        ("X0", letter("theta")),
        ("H", lead),
        ("Q", lead),
        ("I", letter("h") * letter("R") / (letter("r") * letter("r"))),
        // The law of cosines.
        ("J", -(square + 2.0 * lead)),
        ("L", square),
        ("P", square),
        ("R", letter("A")),
        ("V", letter("D").abs()),
        ("U", letter("mu")),
        ("IC", letter("I_D")),
        ("IW", letter("I_f")),
        ("1DX", letter("theta'")),
        ("2DX", letter("theta''")),
        ("OLD2DX", letter("theta''")),
        ("PHIDOT", letter("phi'")),
    ]);
    letters.extend(["A", "B", "C", "D", "E", "F", "S", "K"].map(|name| (name.to_owned(), letter(name))));
    letters
}

/// The program's letters at all instants.
pub(super) fn lines() -> &'static [Moment] {
    static LINES: OnceLock<Vec<Moment>> = OnceLock::new();
    LINES.get_or_init(|| moments().iter().map(|moment| Moment::of(letters(moment))).collect())
}

/// Whether a line of the program holds at all instants.
pub(super) fn holds(line: &str) -> Option<bool> {
    reading::holds(line, lines())
}

/// The letters at the start, at all instants: the acceleration is the one from rest, where both members and the friction
/// between them require the torque.
fn rests() -> &'static [Moment] {
    static RESTS: OnceLock<Vec<Moment>> = OnceLock::new();
    RESTS.get_or_init(|| {
        let rest = |moment: &Moment| {
            let mut letters = moment.letters().clone();
            let asked = |angular_acceleration: f64| {
                letters["A"] * angular_acceleration + (letters["D"] * angular_acceleration).abs()
            };
            let mut high = 1.0;
            while asked(high) < letters["E"] {
                high *= 2.0;
            }
            let [low, _] = halved([0.0, high], |value| asked(value) < letters["E"]);
            letters.insert("2DX".to_owned(), low);
            Moment::of(letters)
        };
        // A torque that drives backwards has no start.
        lines().iter().filter(|moment| moment.letters()["E"] > 0.0).map(rest).collect()
    })
}

/// Whether a line of the start holds at all instants.
pub(crate) fn holds_from_rest(line: &str) -> Option<bool> {
    reading::holds(line, rests())
}
