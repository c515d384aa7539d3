//! The steps of the solution, with the numbers of the question filled in.
//!
//! Signs: along the lever outwards is positive, across it counter-clockwise, as for the lever's angular velocity and
//! acceleration. β is the angle from the lever to the crank, counter-clockwise.

use super::instant::LeverInstant;
use super::{LinkageAngle, QuickReturnDesign};
use crate::Error;
use crate::number_format::as_typed;
use crate::worked::{
    AngleOrigin, LengthUnit, WorkedStep, bracketed, carried, factor, in_degrees, shown, without_rounding,
};
use geneva_figures::with_minus_sign;
use geneva_kinematics::quick_return::{Branch, LeverMotion};

/// The numbers of the steps as they are written, lengths in the unit that is wanted.
struct Written {
    ground: String,
    crank: String,
    distance: String,
    speed: String,
    lever: String,
    beta: String,
}

/// The triangle of the two axes and the pin: angles in degrees.
struct Triangle {
    /// θ; zero where the lever's angle is given.
    theta: f64,
    /// sin β; zero where the crank's angle is given.
    sine: f64,
    /// The pin from the lever's pivot, along the line of centres and across it; zero where the lever's angle is given.
    sides: [f64; 2],
    /// r.
    distance: f64,
    /// φ.
    lever: f64,
    /// β.
    beta: f64,
}

impl QuickReturnDesign {
    /// The solution step by step, for a design whose lengths are in `unit`, with the crank's angle as a problem with this origin
    /// gives it.
    ///
    /// Six digits are carried: each number is computed from those before it as they are written, so every chain of equal sides
    /// holds to the digits that are written.
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
        // Each number follows from those before it as they are written; where one is known to be zero, it is.
        let (ground, crank, driver) = (linkage.ground(), linkage.crank(), carried(drive.speed));
        let triangle = self.triangle(origin);
        let Triangle { distance, beta, .. } = triangle;
        let [sine, cosine] = [libm::sin(beta.to_radians()), libm::cos(beta.to_radians())];
        let pin_speed = carried(crank * driver);
        let across = if instant.lever_at_rest { 0.0 } else { carried(pin_speed * cosine) };
        let sliding = if instant.on_centre_line { 0.0 } else { carried(-pin_speed * sine) };
        let turning = carried(across / distance);
        let [pin_normal, lever_normal] = [crank * driver * driver, distance * turning * turning].map(carried);
        let coriolis = carried(2.0 * turning * sliding);
        let greatest = [pin_normal, lever_normal, coriolis].into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let exact = motion.accelerations.sliding_tangential.dot(&position.lever.direction());
        let is_steady = without_rounding(exact, greatest) == 0.0;
        let out = if is_steady { 0.0 } else { carried(lever_normal - pin_normal * cosine) };
        let tangential = if instant.steady_lever() { 0.0 } else { carried(-pin_normal * sine - coriolis) };
        let angular = carried(tangential / distance);
        let numbers =
            [pin_speed, across, sliding, turning, pin_normal, lever_normal, coriolis, out, tangential, angular];
        if numbers.iter().any(|value| !value.is_finite()) {
            return Err(beyond());
        }
        let [pin_speed, across, sliding, turning, pin_normal, lever_normal, coriolis, out, tangential, angular] =
            numbers.map(|value| without_rounding(value, 0.0));
        let written = Written {
            ground: shown(ground),
            crank: shown(crank),
            distance: shown(distance),
            speed: factor(driver),
            lever: in_degrees(triangle.lever),
            beta: in_degrees(beta),
        };
        let Written { crank, distance, beta, .. } = &written;
        let (rate, acceleration) = (unit.speed(), unit.acceleration());

        let mut place = vec![speed.line()];
        place.extend(self.place(&written, &triangle, origin, unit));
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

    /// The triangle of the two axes and the pin, each number from those before it as they are written.
    fn triangle(&self, origin: AngleOrigin) -> Triangle {
        let Self { linkage, position, place, .. } = self;
        let (ground, crank) = (linkage.ground(), linkage.crank());
        match *place {
            LinkageAngle::Lever(degrees, branch) => {
                let sine = carried(ground * libm::sin(degrees.to_radians()) / crank);
                let acute = libm::asin(sine.clamp(-1.0, 1.0)).to_degrees();
                let beta = match branch {
                    Branch::Far => acute,
                    Branch::Near => 180.0_f64.copysign(acute) - acute,
                };
                let beta = carried(beta);
                let distance = ground * libm::cos(degrees.to_radians()) + crank * libm::cos(beta.to_radians());
                Triangle { theta: 0.0, sine, sides: [0.0; 2], distance: carried(distance), lever: degrees, beta }
            }
            LinkageAngle::Crank(degrees) => {
                let theta = AngleOrigin::Extension.from_line_of_centres(degrees);
                let theta = if origin == AngleOrigin::LineOfCentres { carried(theta) } else { theta };
                let way = position.lever.direction() * position.pin_distance;
                let sides = [ground - crank * libm::cos(theta.to_radians()), -crank * libm::sin(theta.to_radians())];
                let is_zero = [way.x, way.y].map(|side| without_rounding(side, ground) == 0.0);
                let [x, y] = [0, 1].map(|of| if is_zero[of] { 0.0 } else { carried(sides[of]) });
                let lever = carried(libm::atan2(y, x).to_degrees());
                let beta = 180.0 + theta - lever;
                let beta = carried(without_rounding(beta - 360.0 * (beta / 360.0).round(), 180.0));
                Triangle { theta, sine: 0.0, sides: [x, y], distance: carried(libm::hypot(x, y)), lever, beta }
            }
        }
    }

    /// The lines of the triangle, from the angle that was given.
    fn place(&self, written: &Written, triangle: &Triangle, origin: AngleOrigin, unit: LengthUnit) -> Vec<String> {
        let length = unit.name();
        let Written { ground, crank, distance, lever, beta, .. } = written;
        let given = |degrees: f64| with_minus_sign(&as_typed(degrees));
        match self.place {
            LinkageAngle::Lever(degrees, branch) => {
                let (which, place) = match branch {
                    Branch::Far => ("not obtuse", "the far point"),
                    Branch::Near => ("not acute", "the near point"),
                };
                vec![
                    format!("{{φ}} = {}° is given, with the pin at {place}", given(degrees)),
                    format!(
                        "sin {{β}} = {{l}} sin {{φ}} / {{R}} = {ground} · sin {} / {crank} = {}",
                        bracketed(lever),
                        shown(triangle.sine)
                    ),
                    format!("{{β}} = {beta}, which is {which}"),
                    format!(
                        "{{r}} = {{l}} cos {{φ}} + {{R}} cos {{β}} = {ground} · cos {} + {crank} · cos {} = {distance} {length}",
                        bracketed(lever),
                        bracketed(beta)
                    ),
                ]
            }
            LinkageAngle::Crank(degrees) => {
                let theta = in_degrees(triangle.theta);
                let first = match origin {
                    AngleOrigin::LineOfCentres => format!("{{θ}} = {theta} is given"),
                    AngleOrigin::Extension => {
                        format!("{{θ}} = {}° − 180° = {theta}, the angle from the line of centres", given(degrees))
                    }
                };
                let theta = bracketed(&theta);
                let [x, y] = triangle.sides;
                vec![
                    first,
                    format!(
                        "{{x}} = {{l}} − {{R}} cos {{θ}} = {ground} − {crank} · cos {theta} = {} {length}",
                        shown(x)
                    ),
                    format!("{{y}} = −{{R}} sin {{θ}} = −{crank} · sin {theta} = {} {length}", shown(y)),
                    format!("{{r}} = √({{x}}² + {{y}}²) = √({}² + {}²) = {distance} {length}", factor(x), factor(y)),
                    format!("{{φ}} = {lever}, the direction of ({{x}}, {{y}})"),
                    format!("{{β}} = 180° + {{θ}} − {{φ}} = {beta}"),
                ]
            }
        }
    }
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
