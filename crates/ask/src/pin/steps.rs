//! The steps of the solution, with the numbers of the question filled in.

use super::{AxisDistance, PinDesign, PinQuestion};
use crate::number_format::as_typed;
use crate::worked::{AngleOrigin, WorkedStep, carried, in_degrees, shown, without_rounding};
use geneva_figures::with_minus_sign;

impl PinDesign {
    /// The solution step by step: the six steps of the problem, and a seventh for the wheel's angular acceleration.
    ///
    /// Six digits are carried: each number is computed from those before it as they are written, so every chain of equal sides
    /// holds to the digits that are written.
    pub fn steps(&self) -> Vec<WorkedStep> {
        let PinQuestion { unit, speed, .. } = self.question;
        let triangle = &self.triangle;
        // Each number follows from those before it as they are written; where one is known to be zero, it is.
        let (radius, centres) = (self.mechanism.crank_radius(), carried(self.mechanism.centre_distance()));
        let driver = carried(speed.radians_per_second());
        let (angle, turned) = (self.theta.abs(), self.theta.abs().to_radians());
        let squared = carried(radius * radius + centres * centres - 2.0 * radius * centres * libm::cos(turned));
        let distance = carried(squared.sqrt());
        let sine = carried(radius * libm::sin(turned) / distance);
        let slot = carried(libm::asin(sine.min(1.0)).to_degrees());
        let is_at_the_end = without_rounding(triangle.velocity_angle, 1.0) == 0.0;
        let gamma = if is_at_the_end { 0.0 } else { carried(90.0 - slot - angle) };
        let pin = carried(radius * driver);
        let across = carried(pin * libm::sin(gamma.to_radians()));
        let sliding = if self.theta == 0.0 { 0.0 } else { carried(pin * libm::cos(gamma.to_radians())) };
        let wheel = carried(across / distance);
        let (k, q) = (carried(centres / radius), carried(squared / (radius * radius)));
        let acceleration =
            carried(-k * (k * k - 1.0) * libm::sin(self.theta.to_radians()) * driver * driver / (q * q)) + 0.0;
        let [theta, size, slot, gamma] = [self.theta, angle, slot, gamma].map(in_degrees);
        let [radius, centres, driver, squared, distance, sine, pin, across, sliding, wheel, k, q, acceleration] =
            [radius, centres, driver, squared, distance, sine, pin, across, sliding, wheel, k, q, acceleration]
                .map(shown);
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
                    format!("sin|{{φ}}| = {{R}} sin|{{θ}}| / {{r}} = {radius} · sin {size} / {distance} = {sine}"),
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
                    format!("{{φ̇}} = {{v:P′}} / {{r}} = {across} / {distance} = {wheel} rad/s"),
                    capitalised(self.turning_in_words()),
                ],
            ),
            WorkedStep::new(
                "The next question: the wheel’s angular acceleration",
                [
                    format!("{{k}} = {{l}} / {{R}} = {centres} / {radius} = {k}"),
                    format!("{{q}} = {{r}}² / {{R}}² = {squared} / {radius}² = {q}"),
                    format!(
                        "{{φ̈}} = −{{k}} ({{k}}² − 1) sin {{θ}} · {{θ̇}}² / {{q}}² = −{k} · ({k}² − 1) · sin({theta}) · {driver}² / {q}² = \
                         {acceleration} rad/s²"
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
        let [radius, centres] = [self.mechanism.crank_radius(), carried(self.mechanism.centre_distance())].map(shown);
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
