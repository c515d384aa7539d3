//! The velocity diagram, step by step.

use super::instant::{LeverState, format_with_unit, rate_of, row, turning, turning_label, v};
use super::steps::{Diagram, DiagramArrow, DiagramStep, Direction};
use crate::number::degrees;
use crate::svg::{DrawingKind, Label};
use crate::theme::{DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::pin_vectors::quarter_turn;
use geneva_kinematics::quick_return::{Drive, Position, QuickReturn};
use nalgebra::Vector2;

/// The velocity diagram in three numbered steps, the last one larger: v_2 = v_4 + v_rel.
///
/// `drive` is in radians per second and its square; `length_unit` the unit of the linkage's lengths. A velocity of
/// fewer than one pixel is not drawn but named. Series, a row for each vector in the order that the first column's
/// name gives: its components, along O4 → O2 and across it, its magnitude and its direction, which is zero for a
/// vector of no length; the last row is the gap by which the drawn vectors miss each other.
pub fn velocity_diagram(linkage: &QuickReturn, position: &Position, drive: &Drive<f64>, length_unit: &str) -> Figure {
    let instant = LeverState::new(linkage, position, drive);
    let unit = format!("{length_unit}/s");
    let velocities = &instant.motion.velocities;
    let (pin, slot, sliding) = (velocities.pin_velocity, velocities.slot_point_velocity, velocities.sliding_velocity);
    let arrow = |name, point, tail, vector, colour, if_zero| DiagramArrow {
        name,
        symbol: v(point),
        tail,
        vector,
        colour,
        if_zero,
    };
    let zero = Vector2::zeros();
    let arrows = vec![
        arrow("v-pin", "2", zero, pin, DRIVER, "the crank stands still"),
        arrow("v-lever", "4", zero, slot, FOLLOWER, "the lever stands still"),
        arrow("v-sliding", "rel", slot, sliding, RELATIVE, "the pin does not slide"),
    ];
    let across = quarter_turn(&instant.along);
    let direction = |name, words, from, along, colour| Direction { name, words, from, along, meeting: slot, colour };
    let directions = [
        direction("across", "⊥ lever", zero, across, FOLLOWER),
        direction("along", "∥ lever", pin, instant.along, RELATIVE),
    ];
    let omega_4 = instant.lever_speed(drive);
    let line = Label::words;
    let known = vec![
        line("Known: the pin. From ").and_symbol("o"),
        v("2").and(" = ").and_label(&rate_of("θ")).and("\u{2009}").and_symbol("R"),
        line(&format!("= {}, ⊥ crank", format_with_unit(pin.norm(), &unit))),
    ];
    let unknown = vec![
        v("4").and(" is across the lever"),
        line("from ").and_symbol("o").and("; ").and_label(&v("rel")).and(" is along"),
        line("it and ends at the tip"),
    ];
    let closing = vec![
        line("Where they meet the triangle closes: ").and_label(&sum()),
        Label::words("|")
            .and_label(&rate_of("φ"))
            .and("| = ")
            .and_label(&v("4"))
            .and(" / ")
            .and_symbol("r")
            .and(&format!(" = {}{}", format_with_unit(omega_4.abs(), "rad/s"), turning_label(omega_4))),
    ];
    let diagram = Diagram {
        arrows,
        directions,
        steps: vec![
            DiagramStep { words: known, arrows: 1, directions: false },
            DiagramStep { words: unknown, arrows: 1, directions: true },
        ],
        closing,
        unit: unit.clone(),
    };

    let scale = pin.norm();
    let gap = pin - slot - sliding;
    let rows = [pin, slot, sliding, gap].into_iter().enumerate().map(|(k, vector)| row(k + 1, &vector, scale));
    let columns = [
        ("1 v_2; 2 v_4; 3 v_rel; 4 gap", "1"),
        ("x", unit.as_str()),
        ("y", unit.as_str()),
        ("magnitude", unit.as_str()),
        ("direction", "deg"),
    ];
    let [pin, slot, sliding] = ["v-pin", "v-lever", "v-sliding"].map(|name| diagram.value_of(name));
    let phi = degrees(instant.lever_angle);
    let words = Words::new(
        "quick-return-velocity",
        format!("Velocity diagram of the quick-return mechanism at a lever angle of {phi}"),
        format!(
            "Three steps, to scale. 1: from the pole, the velocity of the pin P2, {pin}. 2: two dashed lines of known \
             direction, across the lever from the pole and along the lever through the tip. 3: they meet and close a \
             right-angled triangle: the velocity of the lever's point P4, {slot}, and the velocity of P2 relative to P4, \
             {sliding}, add up to the velocity of P2. The lever's angular velocity is {}{}.",
            format_with_unit(omega_4.abs(), "rad/s"),
            turning(omega_4)
        ),
        format!(
            "The velocity diagram at φ = {phi}, in three steps. We know one vector completely and only the directions of the \
             other two, but two directions are enough to close the triangle. The pole o is where the vectors start."
        ),
    );
    words.figure(diagram.draw(), DrawingKind::Diagram, Series::new(columns, rows))
}

/// v_2 = v_4 + v_rel.
fn sum() -> Label {
    v("2").and(" = ").and_label(&v("4")).and(" + ").and_label(&v("rel"))
}
