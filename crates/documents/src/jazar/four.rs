//! The equations of the wheel of four stations, (5.25) to (5.29), and Fig. 5.29.

use super::letters::{FOUR, LOOP, STEADY_FOUR};
use super::*;
use geneva_kinematics::indexing::Indexing;

const CLOSURE: Locator = at("Eq. (5.25)");

/// Eq. (5.29) without its sign.
pub(super) const LOST_SIGN: Slip = Slip {
    id: "jazar.eq-5.29",
    reason: "The display before this equation has a minus sign in front of this term, but here the sign is lost, so \
             the wheel would first slow down and then speed up. Where the text makes the equation general, the sign \
             is there, and nothing that the copy shows is computed without it. So we put the loss down to the copy. \
             We cannot tell whether the handout has the sign. If it does not, the curve of Fig. 5.30, which is not in \
             the copy, may be upside down.",
    witness: "Eq. (5.32) of the same source has the sign, and it gives the corrected form for four stations.",
    origin: Origin::Copy,
    consequence: Consequence::Copy,
    changes: "",
};

pub(super) fn claims() -> Vec<Claim> {
    [loop_closure(), angle_and_velocity(), accelerations()].concat()
}

fn loop_closure() -> Vec<Claim> {
    vec![
        CLOSURE
            .equation("jazar.eq-5.25-across", r"r \sin \theta = x \sin \phi", "loop closure across the line of centres")
            .in_letters(LOOP),
        CLOSURE
            .equation(
                "jazar.eq-5.25-along",
                r"r \cos \theta + x \cos \phi = \sqrt{2}r",
                "loop closure along the line of centres",
            )
            .in_letters(LOOP),
        at("Display after Eq. (5.25)")
            .equation(
                "jazar.slot-eliminated",
                r"\cos \theta + \frac{\sin \theta}{\tan \phi} = \sqrt{2}",
                "loop closure with the pin's distance eliminated",
            )
            .in_letters(LOOP),
        at("Eq. (5.26)")
            .equation(
                "jazar.eq-5.26",
                r"\tan \phi = \frac{\sin \theta}{\sqrt{2} - \cos \theta}",
                "tangent of the wheel angle",
            )
            .in_letters(STEADY_FOUR),
        at("Eq. (5.27)")
            .equation(
                "jazar.eq-5.27",
                r"\phi = \tan^{-1} \left(\frac{\sin \theta}{\sqrt{2} - \cos \theta} \right)",
                "wheel angle",
            )
            .in_letters(STEADY_FOUR),
        at("Fig. 5.29, caption")
            .figure("jazar.fig-5.29", "line of centers", "θ and φ are angles of rotation from the line of centres")
            .first_route(Evidence::VECTORS, |stated| {
                at_instants(|wheel, t| {
                    // The pin's place and angle where the driver is t from the line of centres.
                    let theta = t + stated.pick(0.0, wheel.engagement_half_angle());
                    let pin = pin_from_pivot(&wheel.centre_distance_ratio(), &Turn::from_radians(t));
                    (libm::cos(theta) + pin.norm() * libm::cos(by_series(wheel, t)[0]), 2f64.sqrt())
                })
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                // Law of sines: the sines of θ and φ are as the sides opposite, the pin's distance and the crank.
                at_instants(|wheel, t| {
                    let theta = t + stated.pick(0.0, wheel.engagement_half_angle());
                    let (distance, _) = by_cosines(wheel.centre_distance_ratio(), t);
                    let angle = wheel.engaged(t).map_or(f64::NAN, |motion| motion.angle);
                    (libm::sin(theta), distance * libm::sin(angle))
                })
            })
            .but_not("θ is the angle of rotation since the pin entered"),
        at("Fig. 5.29, caption").lost_drawing(
            "jazar.fig-5.29-drawing",
            "Figure 5.29",
            "the drawing of the model of the mechanism",
        ),
    ]
}

fn angle_and_velocity() -> Vec<Claim> {
    vec![
        at("Display before Eq. (5.28)")
            .equation(
                "jazar.tangent-differentiated",
                concat!(
                    r"\dot{\phi}(1 + \tan^2 \phi) = \dot{\theta} \frac{(\sqrt{2}\cos\theta - ",
                    r"1)}{(\sqrt{2} - \cos\theta)^2}"
                ),
                "Eq. (5.26) differentiated",
            )
            .in_letters(FOUR),
        at("Eq. (5.28)")
            .equation(
                "jazar.eq-5.28",
                concat!(
                    r"\dot{\phi} = \dot{\theta} \left(\frac{\sqrt{2} \cos \theta - 1}{3 - 2\sqrt{2} \cos ",
                    r"\theta} \right)"
                ),
                "angular velocity of the four-station wheel",
            )
            .in_letters(FOUR),
    ]
}

fn accelerations() -> Vec<Claim> {
    vec![
        at("Display before Eq. (5.29)")
            .equation(
                "jazar.unsteady-acceleration",
                concat!(
                    r"\ddot{\phi} = \ddot{\theta} \left(\frac{\sqrt{2} \cos \theta - 1}{3 - 2\sqrt{2} ",
                    r"\cos \theta} \right)",
                    r" - \dot{\theta}^2 \frac{\sqrt{2} \sin \theta}{(3 - 2\sqrt{2} \cos \theta)^2}",
                ),
                "angular acceleration of the four-station wheel while the driver speeds up",
            )
            .in_letters(FOUR),
        at("Sentence before Eq. (5.29)")
            .statement("jazar.steady-driver", "first term disappears", "with a steady driver the first term vanishes")
            .first_route(Evidence::JET, |stated| {
                // What is left is the acceleration of a steady driver's wheel.
                let gone = stated.pick(stated.count(), 2);
                at_instants(|wheel, t| {
                    let terms = unsteady_terms(wheel, 0.0, t);
                    (by_series(wheel, t)[2], terms.iter().sum::<f64>() - term(terms, gone))
                })
            })
            .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
                // What has vanished is the difference that the driver's acceleration makes.
                let gone = stated.pick(stated.count(), 2);
                at_instants(|wheel, t| {
                    let [unsteady, steady] = [0.75, 0.0]
                        .map(|angular_acceleration| unsteady_by_duals(wheel, t, 1.0, angular_acceleration)[0]);
                    (unsteady - steady, term(unsteady_terms(wheel, 0.75, t), gone))
                })
            })
            .but_not("the second term vanishes"),
        at("Eq. (5.29)")
            .equation(
                "jazar.eq-5.29",
                r"\ddot{\phi} = \dot{\theta}^2 \frac{\sqrt{2} \sin \theta}{(3 - 2\sqrt{2} \cos \theta)^2}",
                "angular acceleration of the four-station wheel with a steady driver",
            )
            .in_letters(STEADY_FOUR)
            .with_second_witness(
                Evidence::OTHER_PLACE_IN_SOURCE, // (5.32), whose sign is right, for four stations.
                || {
                    at_instants(|wheel, t| {
                        (steady_display("jazar.eq-5.32", wheel, t), -steady_display("jazar.eq-5.29", wheel, t))
                    })
                },
            )
            .corrected(
                r"\ddot{\phi} = -\dot{\theta}^2 \frac{\sqrt{2} \sin \theta}{(3 - 2\sqrt{2} \cos \theta)^2}",
                LOST_SIGN,
            ),
    ]
}

/// The two terms of the wheel's acceleration as they are printed, for a driver of speed one with this acceleration: without
/// the speed, the first is left, and without the acceleration the second.
fn unsteady_terms(wheel: &Wheel, angular_acceleration: f64, theta: f64) -> [f64; 2] {
    [[0.0, angular_acceleration], [1.0, 0.0]]
        .map(|driver| by_display("jazar.unsteady-acceleration", wheel, theta, driver))
}

/// The first, the second of two terms; not a number if there is no such one.
fn term(terms: [f64; 2], number: u32) -> f64 {
    (1..).zip(terms).find(|(at, _)| *at == number).map_or(f64::NAN, |(_, term)| term)
}
