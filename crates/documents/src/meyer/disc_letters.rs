//! What the letters stand for in the estimate of the inertias: exactly, from a disc made of rings; and by numbers, from a disc
//! made of strips.

use super::disc_data::{Data, data_of_the_sentences};
use super::reading::Moment;
use super::*;
use geneva_evidence::{Decimal, Vocabulary};
use geneva_kinematics::Expression;
use std::array::from_fn;
use std::sync::OnceLock;

/// A disc: its moment of inertia by rings, exactly, and by strips.
pub(super) const DISC: Vocabulary = Vocabulary::new(disc_of_rings, Evidence::CLOSED_FORM, discs_of_strips);
/// The disc of the sentences around the estimate, in units of any size.
pub(super) const ESTIMATE: Vocabulary = Vocabulary::new(estimate_by_rings, Evidence::CLOSED_FORM, estimate_by_strips);

/// Variables: π, density, radius, thickness.
fn disc_of_rings(_: i64) -> Moment<Expression> {
    let [pi, density, radius, thickness] = from_fn(Expression::variable);
    Moment::default()
        .with([(r"\pi", pi), ("m", density), ("r", radius), ("t", thickness)])
        .with([("I", of_rings(pi, [density, radius, thickness]))])
}

/// Variables: π, and the inch, the pound and the second in other units.
fn estimate_by_rings(_: i64) -> Moment<Expression> {
    let [pi, inch, pound, second] = from_fn(Expression::variable);
    let units = [(r"\pi", pi), (r"\text{in}", inch), (r"\text{lb}", pound), (r"\text{sec}", second)];
    let exactly = Data::in_sentences().and_then(|data| data.map(exactly));
    let inertia = exactly.map(|Data { density, gravity, diameter, thickness }| {
        of_rings(pi, [density / gravity, diameter / 2, thickness]) * pound * second * second * inch
    });
    Moment::default().with(units).with(inertia.map(|inertia| ("I", inertia)))
}

/// Moment of inertia of a disc with this density, radius and thickness: the mass of its rings times the square of their
/// radius, by Simpson's rule, which is exact for cubes.
fn of_rings(pi: Expression, [density, radius, thickness]: [Expression; 3]) -> Expression {
    let ring = |at: Expression| 2 * pi * at * density * thickness * at * at;
    radius / 6 * (ring(Expression::ZERO) + 4 * ring(radius / 2) + ring(radius))
}

fn discs_of_strips() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    let disc = |[density, radius, thickness]: [f64; 3]| {
        let inertia = of_strips(density, radius, thickness);
        Moment::default().with([("m", density), ("r", radius), ("t", thickness), ("I", inertia)])
    };
    FOUND.get_or_init(|| [[1.5, 0.75, 0.25], [0.5, 1.25, 2.0]].map(disc).into())
}

fn estimate_by_strips() -> &'static [Moment] {
    static FOUND: OnceLock<Vec<Moment>> = OnceLock::new();
    FOUND.get_or_init(|| {
        let Some(Data { density, gravity, diameter, thickness }) = data_of_the_sentences() else { return Vec::new() };
        let (inch, pound, second) = (2.0, 3.0, 5.0);
        // By discs of so many inches, in pounds, seconds and inches.
        let inertia = of_strips(density / gravity, diameter / 2.0, thickness) * pound * second * second * inch;
        let units = [(r"\text{in}", inch), (r"\text{lb}", pound), (r"\text{sec}", second)];
        vec![Moment::default().with(units).with([("I", inertia)])]
    })
}

/// Moment of inertia of a disc: twice the moment about a diameter, of strips along it, by the rule of Gauss and Chebyshev for
/// chords, which is exact here.
fn of_strips(density: f64, radius: f64, thickness: f64) -> f64 {
    const STRIPS: u32 = 4;
    let strip = |k: u32| {
        let angle = PI * f64::from(k) / f64::from(STRIPS + 1);
        let (sine, cosine) = libm::sincos(angle);
        let (away, half_chord_by_width) = (radius * cosine, sine * sine * PI / f64::from(STRIPS + 1));
        2.0 * radius * radius * half_chord_by_width * away * away
    };
    2.0 * density * thickness * (1..=STRIPS).map(strip).sum::<f64>()
}

/// A printed decimal, exactly.
fn exactly(number: &str) -> Option<Expression> {
    let exact = number.parse::<Decimal>().ok()?.exact();
    let [above, below] = [exact.numerator().clone(), exact.denominator().clone().into()].map(i64::try_from);
    Some(Expression::integer(above.ok()?) / Expression::integer(below.ok()?))
}
