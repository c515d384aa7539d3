//! The steps of the solution, with the numbers of the question filled in.
//!
//! Signs: along the lever outwards is positive, across it counter-clockwise, as for the lever's angular velocity and
//! acceleration. β is the angle from the lever to the crank, counter-clockwise.

use super::instant::LeverInstant;
use super::{LinkageAngle, QuickReturnDesign};
use crate::Error;
use crate::number_format::as_typed;
use crate::worked::{AngleOrigin, LengthUnit, WorkedStep, factor, in_degrees, shown, without_rounding};
use geneva_figures::with_minus_sign;
use geneva_kinematics::quick_return::{Branch, LeverMotion};

/// The numbers of the steps as they are written, lengths in the unit that is wanted.
struct Written {
    ground: String,
    crank: String,
    distance: String,
    speed: String,
    lever: String,
    turned: String,
    beta: String,
}

impl QuickReturnDesign {
    /// The solution step by step, for a design whose lengths are in `unit`, with the crank's angle as a problem with this origin
    /// gives it.
    ///
    /// Each number is computed with all digits and written with four; so a chain of equal sides holds to the digits that are
    /// written.
    ///
    /// # Errors
    ///
    /// Lengths, angles or speeds that are too large or too small to compute with.
    pub fn steps(&self, unit: LengthUnit, origin: AngleOrigin) -> Result<Vec<WorkedStep>, Error> {
        let Self { linkage, position, drive, speed, .. } = self;
        let beyond = || refused!("{}", super::report::BEYOND);
        let motion =
            LeverMotion::new(&linkage.ground(), &linkage.crank(), &position.crank, drive).ok_or_else(beyond)?;
        let instant = LeverInstant::new(linkage, position);
        let (lever, crank) = (position.lever.degrees(), position.crank.degrees());
        let turned = crank - lever;
        let beta = without_rounding(turned - 360.0 * (turned / 360.0).round(), 180.0);
        let written = Written {
            ground: shown(linkage.ground()),
            crank: shown(linkage.crank()),
            distance: shown(position.pin_distance),
            speed: factor(drive.speed),
            lever: in_degrees(without_rounding(lever, 180.0)),
            turned: in_degrees(without_rounding(crank, 180.0)),
            beta: in_degrees(beta),
        };
        let Written { crank, distance, beta, .. } = &written;
        let (rate, acceleration) = (unit.speed(), unit.acceleration());

        let pin_speed = linkage.crank() * drive.speed;
        let along = position.lever.direction();
        let size = pin_speed.abs();
        let across = if instant.lever_at_rest { 0.0 } else { motion.velocities.follower_speed * position.pin_distance };
        let across = without_rounding(across, size);
        let sliding = motion.velocities.sliding_velocity.dot(&along);
        let sliding = if instant.on_centre_line { 0.0 } else { without_rounding(sliding, size) };
        let turning = across / position.pin_distance;
        let [pin_normal, lever_normal] = [pin_speed * drive.speed, turning * across];
        let coriolis = 2.0 * turning * sliding;
        let greatest = [pin_normal, lever_normal, coriolis].into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let out = without_rounding(motion.accelerations.sliding_tangential.dot(&along), greatest);
        let tangential = motion.accelerations.follower_acceleration * position.pin_distance;
        let tangential = if instant.steady_lever() { 0.0 } else { without_rounding(tangential, greatest) };
        let angular = tangential / position.pin_distance;
        let numbers =
            [pin_speed, across, sliding, turning, pin_normal, lever_normal, coriolis, out, tangential, angular];
        if numbers.iter().any(|value| !value.is_finite()) {
            return Err(beyond());
        }
        let [pin_speed, across, sliding, pin_normal, lever_normal, coriolis, out, tangential] =
            [pin_speed, across, sliding, pin_normal, lever_normal, coriolis, out, tangential]
                .map(|value| without_rounding(value, 0.0));

        let mut place = vec![speed.line()];
        place.extend(self.place(&written, origin, unit));
        Ok(vec![
            WorkedStep::new("Where the pin is", place),
            WorkedStep::new(
                "The velocity diagram",
                [
                    format!("{{v:2}} = {{R}} {{θ̇}} = {crank} · {} = {} {rate}", written.speed, shown(pin_speed)),
                    format!(
                        "{{v:4}} = {{v:2}} cos {{β}} = {} · cos {} = {} {rate}",
                        shown(pin_speed),
                        bracketed(beta),
                        shown(across)
                    ),
                    format!(
                        "{{v:rel}} = −{{v:2}} sin {{β}} = −{} · sin {} = {} {rate}",
                        factor(pin_speed),
                        bracketed(beta),
                        shown(sliding)
                    ),
                    way(sliding, "The pin slides outwards.", "The pin slides inwards.", "The pin does not slide."),
                ],
            ),
            WorkedStep::new(
                "The lever’s angular velocity",
                [
                    format!("{{φ̇}} = {{v:4}} / {{r}} = {} / {distance} = {} rad/s", shown(across), shown(turning)),
                    way(turning, "Counter-clockwise.", "Clockwise.", "The lever is at the end of its swing."),
                ],
            ),
            WorkedStep::new(
                "The accelerations that follow from the velocities",
                [
                    format!(
                        "{{a:2:n}} = {{R}} {{θ̇}}² = {crank} · {}² = {} {acceleration}, towards {{O:2}}",
                        written.speed,
                        shown(pin_normal)
                    ),
                    format!(
                        "{{a:4:n}} = {{r}} {{φ̇}}² = {distance} · {}² = {} {acceleration}, towards {{O:4}}",
                        factor(turning),
                        shown(lever_normal)
                    ),
                ],
            ),
            WorkedStep::new(
                "The Coriolis acceleration",
                [
                    format!(
                        "{{a:Cor}} = 2 {{φ̇}} {{v:rel}} = 2 · {} · {} = {} {acceleration}",
                        factor(turning),
                        factor(sliding),
                        shown(coriolis)
                    ),
                    way(
                        coriolis,
                        "Across the lever, counter-clockwise.",
                        "Across the lever, clockwise.",
                        "There is none: the lever or the sliding is at rest.",
                    ),
                ],
            ),
            WorkedStep::new(
                "Close the acceleration diagram",
                [
                    format!(
                        "{{a:rel:t}} = {{a:4:n}} − {{a:2:n}} cos {{β}} = {} − {} · cos {} = {} {acceleration}, outwards positive",
                        shown(lever_normal),
                        shown(pin_normal),
                        bracketed(beta),
                        shown(out)
                    ),
                    format!(
                        "{{a:4:t}} = −{{a:2:n}} sin {{β}} − {{a:Cor}} = −{} · sin {} − {} = {} {acceleration}, counter-clockwise positive",
                        shown(pin_normal),
                        bracketed(beta),
                        factor(coriolis),
                        shown(tangential)
                    ),
                    format!(
                        "{{φ̈}} = {{a:4:t}} / {{r}} = {} / {distance} = {} rad/s²",
                        shown(tangential),
                        shown(angular)
                    ),
                    way(angular, "Counter-clockwise.", "Clockwise.", "The lever neither speeds up nor slows down."),
                ],
            ),
        ])
    }

    /// The triangle of the two axes and the pin, from the angle that was given.
    fn place(&self, written: &Written, origin: AngleOrigin, unit: LengthUnit) -> Vec<String> {
        let length = unit.name();
        let Written { ground, crank, distance, lever, turned, beta, .. } = written;
        let given = |degrees: f64| with_minus_sign(&as_typed(degrees));
        match self.place {
            LinkageAngle::Lever(degrees, branch) => {
                let sine = shown(self.linkage.ratio() * libm::sin(degrees.to_radians()));
                let (which, place) = match branch {
                    Branch::Far => ("not obtuse", "the far point"),
                    Branch::Near => ("not acute", "the near point"),
                };
                vec![
                    format!("{{φ}} = {}° is given, with the pin at {place}", given(degrees)),
                    format!(
                        "sin {{β}} = {{l}} sin {{φ}} / {{R}} = {ground} · sin {} / {crank} = {sine}",
                        bracketed(lever)
                    ),
                    format!("{{β}} = {beta}, the angle with this sine that is {which}"),
                    format!(
                        "{{r}} = {{l}} cos {{φ}} + {{R}} cos {{β}} = {ground} · cos {} + {crank} · cos {} = {distance} {length}",
                        bracketed(lever),
                        bracketed(beta)
                    ),
                ]
            }
            LinkageAngle::Crank(degrees) => {
                let theta = AngleOrigin::Extension.from_line_of_centres(degrees);
                let first = match origin {
                    AngleOrigin::LineOfCentres => format!("{{θ}} = {} is given", in_degrees(theta)),
                    AngleOrigin::Extension => {
                        format!(
                            "{{θ}} = {}° − 180° = {}, the angle from the line of centres",
                            given(degrees),
                            in_degrees(theta)
                        )
                    }
                };
                let lever_way = self.position.lever.direction() * self.position.pin_distance;
                let [x, y] = [lever_way.x, lever_way.y].map(|side| without_rounding(side, self.linkage.ground()));
                let theta = in_degrees(theta);
                let theta = bracketed(&theta);
                vec![
                    first,
                    format!(
                        "{{x}} = {{l}} − {{R}} cos {{θ}} = {ground} − {crank} · cos {theta} = {} {length}",
                        shown(x)
                    ),
                    format!("{{y}} = −{{R}} sin {{θ}} = −{crank} · sin {theta} = {} {length}", shown(y)),
                    format!("{{r}} = √({{x}}² + {{y}}²) = √({}² + {}²) = {distance} {length}", factor(x), factor(y)),
                    format!("{{φ}} = {lever}, the direction of ({{x}}, {{y}})"),
                    format!("{{β}} = 180° + {{θ}} − {{φ}} = {turned} − {} = {beta}", bracketed(lever)),
                ]
            }
        }
    }
}

/// A negative angle in brackets, as it stands behind a function or a minus sign.
fn bracketed(angle: &str) -> String {
    if angle.starts_with('−') { format!("({angle})") } else { angle.to_owned() }
}

/// The sentence for a value above zero, for one below zero, and for zero.
fn way(value: f64, above: &str, below: &str, zero: &str) -> String {
    let words = if value > 0.0 {
        above
    } else if value < 0.0 {
        below
    } else {
        zero
    };
    words.to_owned()
}
