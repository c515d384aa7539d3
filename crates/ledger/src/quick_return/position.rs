//! The position: a triangle of ground, crank and lever.

use super::*;
use geneva_kinematics::prove;
use geneva_kinematics::quick_return::proofs::{LawOfSinesAtThePin, LeverAsProjections};

const SINES: &str = "Solution, position, 1st line";
const PROJECTIONS: &str = "Solution, position, 2nd line";
const SPEED: &str = "Solution, position, 3rd line";
const ANGLES: &str = "Solution, position, 4th line";
const CRANK: &str = "Solution, position, 5th line";

pub fn claims() -> Vec<Claim> {
    vec![
        Claim::value(
            WORK,
            "quick-return.ground",
            SINES,
            "distance of the two axes, a datum of the lost drawing; the printed \
                    angles and lengths give it back",
            ("0.45", "m"),
            Check::number(
                (OtherPlaceInSource, || {
                    printed("quick-return.crank") * sine(printed("quick-return.angle-at-pin"))
                        / sine(printed("quick-return.lever-angle"))
                }),
                (OtherPlaceInSource, || {
                    let along = printed("quick-return.crank") * cosine(printed("quick-return.angle-at-pin"));
                    (printed("quick-return.lever-length") - along) / cosine(printed("quick-return.lever-angle"))
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.lever-angle",
            SINES,
            "angle of the lever from the line of centres, a datum of the lost drawing",
            ("20", "°"),
            Check::number(
                (OtherPlaceInSource, || {
                    180.0 - printed("quick-return.angle-at-axis") - printed("quick-return.angle-at-pin")
                }),
                (OtherPlaceInSource, || {
                    arcsine(
                        printed("quick-return.crank") * sine(printed("quick-return.angle-at-pin"))
                            / printed("quick-return.ground"),
                    )
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.crank",
            SINES,
            "radius of the crank, a datum of the lost drawing",
            ("0.20", "m"),
            Check::number(
                (OtherPlaceInSource, || printed("quick-return.pin-speed") / printed("quick-return.driver-rate")),
                (OtherPlaceInSource, || {
                    printed("quick-return.ground") * sine(printed("quick-return.lever-angle"))
                        / sine(printed("quick-return.angle-at-pin"))
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.law-of-sines",
            SINES,
            "law of sines at the lever's pivot and at the pin",
            r"\ldots \sin \ldots^\circ = \ldots \sin \beta",
            Check::equation(
                (ExactIdentity, || prove(&LawOfSinesAtThePin).into()),
                (Vectors, || {
                    let height = diagram(|motion| motion.velocities.position.y * motion.velocities.position.norm());
                    let area = diagram(|motion| motion.velocities.position.perp(&motion.crank));
                    same(
                        printed("quick-return.ground") * height,
                        area * diagram(|motion| motion.velocities.position.norm()),
                    )
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.angle-at-pin",
            SINES,
            "β, the angle at the pin between lever and crank",
            ("50.31", "°"),
            Check::number(
                (Vectors, || position_of(|position| position.angle_at_pin().to_degrees())),
                (ClosedForm, || {
                    arcsine(
                        printed("quick-return.ground") * sine(printed("quick-return.lever-angle"))
                            / printed("quick-return.crank"),
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "quick-return.branch",
            SINES,
            "of the two angles with this sine the acute one is meant: the pin is at \
                    the far point of its circle",
            "beta",
            Check::equation(
                (OtherPlaceInSource, || {
                    let [far, near] = both(|position| position.pin_distance);
                    let holds = rounds("quick-return.lever-length", far) && !rounds("quick-return.lever-length", near);
                    Finding::new(
                        holds,
                        format!("the lever would be {near:.3} m long on the other branch, not {far:.3} m"),
                    )
                }),
                (Vectors, || {
                    let speed = Instant::on(Branch::Near).ok().and_then(|instant| instant.by_diagrams());
                    let speed = speed.map_or(f64::NAN, |motion| motion.velocities.follower_speed);
                    Finding::new(speed < 0.0, format!("and would turn into the page there, at {speed:.3} rad/s"))
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.projections",
            PROJECTIONS,
            "length of the lever as the projections of ground and crank on it",
            r"r = \ldots \cos \ldots^\circ + \ldots \cos \beta",
            Check::equation(
                (ExactIdentity, || prove(&LeverAsProjections).into()),
                (Vectors, || {
                    let projected = diagram(|motion| {
                        let along = motion.velocities.position.normalize();
                        (motion.velocities.position - motion.crank).dot(&along) + motion.crank.dot(&along)
                    });
                    same(projected, position_of(|position| position.pin_distance))
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.lever-length",
            PROJECTIONS,
            "distance of the pin from the lever's pivot; later called l with the index 4",
            ("0.55", ""),
            Check::number((ClosedForm, || position_of(|position| position.pin_distance)), (Series, || series(radius))),
        ),
        Claim::equation(
            WORK,
            "quick-return.rate-conversion",
            SPEED,
            "revolutions per minute to radians per second",
            r"\frac{\text{rev}}{\text{min}} \cdot \frac{2\pi \text{ rad}}{1 \text{ rev}} \cdot \frac{\text{min}}{60 \text{ s}}",
            Check::equation(
                (ClosedForm, || {
                    let drive = Instant::printed().map_or(f64::NAN, |instant| instant.drive.speed);
                    same(drive, printed("quick-return.driver-speed") * 2.0 * PI / 60.0)
                }),
                (LimitCase, || {
                    let revolution = Instant::printed().map_or(f64::NAN, |instant| 2.0 * PI / instant.drive.speed);
                    same(revolution * printed("quick-return.driver-speed"), 60.0)
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.driver-rate",
            SPEED,
            "angular velocity of the crank",
            ("5.24", "rad/s"),
            Check::number(
                (ClosedForm, || Instant::printed().map_or(f64::NAN, |instant| instant.drive.speed)),
                (Vectors, || diagram(|motion| motion.velocities.pin_velocity.norm() / motion.crank.norm())),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.angle-sum",
            ANGLES,
            "the third angle of the triangle",
            r"\gamma = 180^\circ - \ldots^\circ - \beta",
            Check::equation(
                (Vectors, || same(position_of(|position| interior(position).iter().sum()), 180.0)),
                (OtherPlaceInSource, || {
                    let left = 180.0 - printed("quick-return.lever-angle") - printed("quick-return.angle-at-pin");
                    Finding::new(
                        rounds("quick-return.angle-at-axis", left),
                        format!("the printed angles leave {left:.2}°"),
                    )
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.angle-at-axis",
            ANGLES,
            "γ, the angle at the crank's axis between crank and ground",
            ("109.69", "°"),
            Check::number(
                (Vectors, || 180.0 - position_of(|position| position.crank.degrees())),
                (ClosedForm, || {
                    let sine_at_pin = printed("quick-return.ground") * sine(printed("quick-return.lever-angle"))
                        / printed("quick-return.crank");
                    180.0 - printed("quick-return.lever-angle") - arcsine(sine_at_pin)
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "quick-return.supplement",
            CRANK,
            "what is left of γ to the half turn is the angle of the crank from the line of centres",
            r"180^\circ - \gamma",
            Check::equation(
                (Vectors, || {
                    same(
                        position_of(|position| 180.0 - interior(position)[2]),
                        diagram(|motion| Turn { cos: motion.crank.x, sin: motion.crank.y }.degrees()),
                    )
                }),
                (OtherPlaceInSource, || {
                    let left = 180.0 - printed("quick-return.angle-at-axis");
                    Finding::new(rounds("quick-return.crank-angle", left), format!("the printed γ leaves {left:.2}°"))
                }),
            ),
        ),
        Claim::value(
            WORK,
            "quick-return.crank-angle",
            CRANK,
            "the crank's angle from the line of centres, produced beyond its axis",
            ("70.31", "°"),
            Check::number(
                (Vectors, || position_of(|position| position.crank.degrees())),
                (ClosedForm, || {
                    let sine_at_pin = printed("quick-return.ground") * sine(printed("quick-return.lever-angle"))
                        / printed("quick-return.crank");
                    printed("quick-return.lever-angle") + arcsine(sine_at_pin)
                }),
            ),
        ),
    ]
}

/// A quantity of the position on the far branch and on the near one.
fn both(quantity: fn(&Position) -> f64) -> [f64; 2] {
    [Branch::Far, Branch::Near].map(|branch| Instant::on(branch).map_or(f64::NAN, |at| quantity(&at.position)))
}

/// The three angles of the triangle in degrees: at the lever's pivot, at the pin, at the crank's axis.
fn interior(position: &Position) -> [f64; 3] {
    [position.lever.degrees(), position.angle_at_pin().to_degrees(), position.crank.supplement().degrees()]
}
