//! The steps of the solution, with the numbers of the question filled in.

use super::{AxisDistance, PinDesign, PinQuestion};
use crate::number_format::{as_typed, to_digits};
use crate::worked::{AngleOrigin, WorkedStep, in_degrees, shown, without_rounding};
use geneva_figures::with_minus_sign;

impl PinDesign {
    /// The solution step by step: the six steps of the problem, and a seventh for the wheel's angular acceleration.
    ///
    /// Each number is computed with all digits and written with four; so a chain of equal sides holds to the digits that are
    /// written.
    pub fn steps(&self) -> Vec<WorkedStep> {
        let PinQuestion { unit, speed, .. } = self.question;
        let [radius, centres] = [self.mechanism.crank_radius(), self.mechanism.centre_distance()].map(shown);
        let driver = shown(speed.radians_per_second());
        let triangle = &self.triangle;
        let [squared, distance] = [triangle.slot_radius * triangle.slot_radius, triangle.slot_radius].map(shown);
        let theta = in_degrees(self.theta);
        let size = in_degrees(self.theta.abs());
        let slot = in_degrees(triangle.angle_at_pivot.to_degrees());
        let gamma = in_degrees(without_rounding(triangle.velocity_angle, 1.0).to_degrees());
        let pin = shown(triangle.pin_speed);
        let across = shown(without_rounding(triangle.slot_point_speed, triangle.pin_speed));
        let sliding = shown(self.sliding_speed().abs());
        let [k, q] = [self.mechanism.ratio(), triangle.radius_squared_ratio].map(|ratio| to_digits(ratio, 6));
        let (length, rate) = (unit.name(), unit.speed());

        let mut data = vec![self.crank_angle()];
        data.extend(self.axes());
        data.push(speed.line());
        vec![
            WorkedStep::new("The angle from the line of centres, and the data", data),
            WorkedStep::new(
                "How far the pin is from the wheel’s axis",
                [
                    format!(
                        "{{r}}² = {{R}}² + {{l}}² − 2 {{R}} {{l}} cos|{{θ}}| = {radius}² + {centres}² − 2 · {radius} · {centres} · \
                         cos {size} = {squared} {}",
                        unit.area()
                    ),
                    format!("{{r}} = √({squared} {}) = {distance} {length}", unit.area()),
                ],
            ),
            WorkedStep::new(
                "Where the slot points",
                [
                    format!(
                        "sin|{{φ}}| = {{R}} sin|{{θ}}| / {{r}} = {radius} · sin {size} / {distance} = {}",
                        shown(triangle.sine_at_pivot)
                    ),
                    format!("|{{φ}}| = {slot}, the acute angle"),
                ],
            ),
            WorkedStep::new(
                "How fast the pin is",
                [format!("{{v:P}} = {{R}} {{θ̇}} = {radius} · {driver} = {pin} {rate}")],
            ),
            WorkedStep::new(
                "Split the velocity across the slot and along it",
                [
                    format!("{{γ}} = 90° − |{{φ}}| − |{{θ}}| = 90° − {slot} − {size} = {gamma}"),
                    format!("{{v:P′}} = {{v:P}} sin {{γ}} = {pin} · sin {gamma} = {across} {rate}"),
                    format!("{{v:P/S}} = {{v:P}} cos {{γ}} = {pin} · cos {gamma} = {sliding} {rate}"),
                    capitalised(self.sliding_in_words()),
                ],
            ),
            WorkedStep::new(
                "How fast the wheel is",
                [
                    format!("{{φ̇}} = {{v:P′}} / {{r}} = {across} / {distance} = {} rad/s", shown(self.wheel_speed())),
                    capitalised(self.turning_in_words()),
                ],
            ),
            WorkedStep::new(
                "The next question: the wheel’s angular acceleration",
                [
                    format!(
                        "{{k}} = {{l}} / {{R}} = {k}, and {{q}} = {{r}}²/{{R}}² = {q}, both to six digits because powers follow"
                    ),
                    format!(
                        "{{φ̈}} = −{{k}} ({{k}}² − 1) sin {{θ}} · {{θ̇}}² / {{q}}² = −{k} · ({k}² − 1) · sin({theta}) · {driver}² / {q}² = \
                         {} rad/s²",
                        shown(self.wheel_acceleration())
                    ),
                    capitalised(self.acceleration_in_words()),
                ],
            ),
        ]
    }

    /// θ from the angle that was given.
    fn crank_angle(&self) -> String {
        let (given, theta) = (as_typed(self.question.angle), in_degrees(self.theta));
        let size = in_degrees(self.theta.abs());
        let given = with_minus_sign(&given);
        match self.question.origin {
            AngleOrigin::LineOfCentres => format!("{{θ}} = {given}° is given, so |{{θ}}| = {size}"),
            AngleOrigin::Extension => format!("{{θ}} = {given}° − 180° = {theta}, so |{{θ}}| = {size}"),
        }
    }

    /// The centre distance from the number of slots, if that was given.
    fn axes(&self) -> Option<String> {
        let AxisDistance::Stations(slots) = self.question.axes else { return None };
        let half = in_degrees(180.0 / f64::from(slots));
        let [radius, centres] = [self.mechanism.crank_radius(), self.mechanism.centre_distance()].map(shown);
        Some(format!(
            "{{l}} = {{R}} / sin(180°/{slots}) = {radius} / sin {half} = {centres} {}",
            self.question.unit.name()
        ))
    }
}

/// Words as a sentence of their own.
fn capitalised(words: &str) -> String {
    let mut rest = words.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect::<String>() + ".")
}
