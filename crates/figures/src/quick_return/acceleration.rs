//! The acceleration diagram, step by step.

use super::instant::{
    LeverState, a, coriolis, format_with_unit, lever_acceleration, rate_of, row, turning, turning_label, v,
};
use super::order::{Laid, Order};
use super::steps::{Diagram, DiagramArrow, DiagramStep};
use crate::number::degrees;
use crate::svg::{DrawingKind, Label};
use crate::theme::{CORIOLIS, DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::quick_return::{Drive, LeverMotion, Position, QuickReturn};
use nalgebra::Vector2;

/// The acceleration diagram in five numbered steps, the last one larger.
///
/// aⁿ_2 + aᵗ_2 = aⁿ_4 + aᵗ_4 + aᵗ_rel + 2 φ′ × v_rel; aⁿ_rel is zero, for the slot is straight. `drive` is in
/// radians per second and its square; `length_unit` the unit of the linkage's lengths. An acceleration of fewer than
/// one pixel is not drawn but named. Series, a row for each term in the order that the first column's name gives: its
/// components, along O4 → O2 and across it, its magnitude and its direction, which is zero for a vector of no length;
/// the last row is the gap by which the two sides of the equation miss each other.
pub fn acceleration_diagram(
    linkage: &QuickReturn,
    position: &Position,
    drive: &Drive<f64>,
    length_unit: &str,
) -> Figure {
    let instant = LeverState::new(linkage, position, drive);
    let (unit, ascii) = (format!("{length_unit}/s²"), format!("{length_unit}/s^2"));
    let alpha_4 = instant.lever_acceleration(drive);
    let laid = Laid::new(&instant.motion);
    let directions = laid.directions(&instant.motion, instant.along);
    let arrows = arrows(&instant.motion, &laid);
    let mut diagram = Diagram { arrows, directions, steps: Vec::new(), closing: closing(alpha_4), unit };
    diagram.steps = steps(&diagram, laid.order, drive.acceleration == 0.0);

    let terms = &instant.motion.accelerations;
    let (normal, tangential) = (instant.motion.pin_normal, instant.motion.pin_tangential);
    let vectors = [
        normal,
        tangential,
        terms.follower_normal,
        terms.follower_tangential,
        terms.sliding_normal,
        terms.sliding_tangential,
        terms.coriolis,
        instant.motion.acceleration_gap(),
    ];
    let scale = vectors.iter().map(|vector| vector.norm()).fold(0.0, f64::max);
    let rows = vectors.iter().enumerate().map(|(k, vector)| row(k + 1, vector, scale));
    let columns = [
        ("1 an_2; 2 at_2; 3 an_4; 4 at_4; 5 an_rel; 6 at_rel; 7 Coriolis; 8 gap", "1"),
        ("x", ascii.as_str()),
        ("y", ascii.as_str()),
        ("magnitude", ascii.as_str()),
        ("direction", "deg"),
    ];
    let value = |name: &str| diagram.value_of(name);
    let [normal, turned] = [
        format!("the normal acceleration of the lever's point P4, {}", value("a-lever-normal")),
        format!("the Coriolis acceleration, {}", value("a-coriolis")),
    ];
    let [second, third] = if laid.order == Order::First { [turned, normal] } else { [normal, turned] };
    let words = Words::new(
        "quick-return-acceleration",
        format!(
            "Acceleration diagram of the quick-return mechanism at a lever angle of {}",
            degrees(instant.lever_angle)
        ),
        format!(
            "Five steps, to scale. 1: from the pole, the pin's normal acceleration, {}, and its tangential one, {}. 2: \
             {}. 3: {}. 4: two \
             dashed lines of known direction, one across the lever, one along it. 5: they meet and close the polygon \
             with the tangential acceleration of P4, {}, and the tangential acceleration of P2 relative to P4, {}; the \
             normal acceleration of P2 relative to P4 is zero. The lever's angular acceleration is {}{}.",
            value("a-pin-normal"),
            value("a-pin-tangential"),
            second,
            third,
            value("a-lever-tangential"),
            value("a-sliding"),
            format_with_unit(alpha_4.abs(), "rad/s²"),
            turning(alpha_4)
        ),
        format!(
            "The acceleration diagram at φ = {}, in five steps. The normal and the Coriolis terms follow from the velocities. \
             Of the last two terms we know only the directions, but two directions are enough to close the polygon. The pole o \
             is where the vectors start.",
            degrees(instant.lever_angle)
        ),
    );
    words.figure(diagram.draw(), DrawingKind::Diagram, Series::new(columns, rows))
}

/// The vectors: from the pole the pin's, then the lever's side in its order; what is known comes first.
fn arrows(motion: &LeverMotion<f64>, laid: &Laid) -> Vec<DiagramArrow> {
    let (terms, zero) = (&motion.accelerations, Vector2::zeros());
    let arrow =
        |name, symbol, tail, vector, colour, if_zero| DiagramArrow { name, symbol, tail, vector, colour, if_zero };
    let normal = arrow(
        "a-lever-normal",
        a("n", "4"),
        laid.lever_normal,
        terms.follower_normal,
        FOLLOWER,
        "the lever stands still",
    );
    let turned = arrow("a-coriolis", coriolis(), laid.coriolis, terms.coriolis, CORIOLIS, "no turning or no sliding");
    let known = if laid.order == Order::First { [turned, normal] } else { [normal, turned] };
    let pin = [
        arrow("a-pin-normal", a("n", "2"), zero, motion.pin_normal, DRIVER, "the crank stands still"),
        arrow(
            "a-pin-tangential",
            a("t", "2"),
            motion.pin_normal,
            motion.pin_tangential,
            DRIVER,
            "the crank turns steadily",
        ),
    ];
    let found = [
        arrow(
            "a-lever-tangential",
            a("t", "4"),
            laid.lever_tangential,
            terms.follower_tangential,
            FOLLOWER,
            "the lever turns steadily",
        ),
        arrow("a-sliding", a("t", "rel"), laid.sliding, terms.sliding_tangential, RELATIVE, "the pin slides steadily"),
    ];
    pin.into_iter().chain(known).chain(found).collect()
}

/// What is said and drawn in the four small steps.
fn steps(diagram: &Diagram, order: Order, steady: bool) -> Vec<DiagramStep> {
    let line = Label::words;
    let value = |name: &str| line(&format!(" = {}", diagram.value_of(name)));
    let pivot = |link: &str| line("O").sub(link);
    let square = |angle: &str, length: &str| line(" = ").and_label(&rate_of(angle)).and("²\u{2009}").and_symbol(length);
    let tangential = if steady { line(" = 0: steady") } else { value("a-pin-tangential") };
    let pin = vec![
        line("Known: the pin. From ").and_symbol("o"),
        a("n", "2").and_label(&square("θ", "R")),
        value("a-pin-normal").and(" to ").and_label(&pivot("2")),
        a("t", "2").and_label(&tangential),
    ];
    let lever = |begin: Label| {
        vec![
            begin.and("the lever:"),
            a("n", "4").and_label(&square("φ", "r")),
            value("a-lever-normal").and(" to ").and_label(&pivot("4")),
        ]
    };
    let twice = coriolis().and(" = 2\u{2009}|").and_label(&rate_of("φ")).and("|\u{2009}").and_label(&v("rel"));
    let turned = |first: Label| vec![first, twice.clone(), line("").and_label(&value("a-coriolis")).and(", ⊥ lever")];
    let (from_pole, then) = (line("From ").and_symbol("o").and(", "), line("Then "));
    let (second, third) = match order {
        Order::Last => (lever(from_pole), turned(line("Coriolis, up to the tip:"))),
        Order::First => (turned(from_pole.and("Coriolis:")), lever(then)),
        Order::Second => (lever(from_pole), turned(then.and("Coriolis:"))),
    };
    let (goes_on, comes_in) = match order {
        Order::Second => (a("t", "rel").and(" lies along,"), a("t", "4").and(" across the lever;")),
        _ => (a("t", "4").and(" lies across,"), a("t", "rel").and(" along the lever;")),
    };
    let end = if order == Order::Last { "then comes Coriolis" } else { "it ends at the tip" };
    let unknown = vec![goes_on, comes_in, line(end)];
    vec![
        DiagramStep { words: pin, arrows: 2, directions: false },
        DiagramStep { words: second, arrows: 3, directions: false },
        DiagramStep { words: third, arrows: 4, directions: false },
        DiagramStep { words: unknown, arrows: 4, directions: true },
    ]
}

/// The words of the last step.
fn closing(alpha_4: f64) -> Vec<Label> {
    vec![
        Label::words("Where they meet the polygon closes."),
        Label::words("|")
            .and_label(&lever_acceleration())
            .and("| = ")
            .and_label(&a("t", "4"))
            .and(" / ")
            .and_symbol("r")
            .and(&format!(" = {}{}", format_with_unit(alpha_4.abs(), "rad/s²"), turning_label(alpha_4))),
        a("n", "rel").and(" = 0: the slot is straight"),
    ]
}
