//! The torque of friction and the normal force that makes it, up to the spring: Eqs. (1-11) to (1-15).

use super::instants::{equal, holds, letters_of, moments};
use super::lagrange::{agrees_in_steps, energy_gained, frictionless, opposing};
use super::letters::{mechanism, size, triangle};
use super::slips::{HALF_POWERS, PHI_AS_THETA};
use super::spring::no_rate;
use super::*;
use geneva_dynamics::Parameters;
use std::sync::OnceLock;

// Displays too long for a line.
const SUBSTITUTED: &str = concat!(
    r"N = \frac{I_f \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^2} ",
    r"\dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)} \ddot{\theta} ",
    r"\right]}{r(1+a^2-2a \cos \theta)^{3/2}}"
);
const SUBSTITUTED_CORRECTED: &str = concat!(
    r"N = \frac{I_f \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^2} ",
    r"\dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)} \ddot{\theta} ",
    r"\right]}{r(1+a^2-2a \cos \theta)^{1/2}}"
);
const NORMAL_FORCE: &str = concat!(
    r"N = \frac{I_f}{r} \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^{3/2}} ",
    r"\dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)^{3/2}} ",
    r"\ddot{\theta} \right]"
);
const NORMAL_FORCE_CORRECTED: &str = concat!(
    r"N = \frac{I_f}{r} \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^{5/2}} ",
    r"\dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)^{3/2}} ",
    r"\ddot{\theta} \right]"
);
const FRICTION_SUBSTITUTED: &str = concat!(
    r"\tau_2 = -ar\mu \left| \frac{\sin \theta}{(1+a^2-2a \cos \theta)^{3/2}} ",
    r"\frac{I_f}{r} \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^{3/2}} ",
    r"\dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)^{3/2}} ",
    r"\ddot{\theta} \right] \right|"
);
const FRICTION_SUBSTITUTED_CORRECTED: &str = concat!(
    r"\tau_2 = -ar\mu \left| \frac{\sin \theta}{(1+a^2-2a \cos \theta)^{1/2}} ",
    r"\frac{I_f}{r} \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^{5/2}} ",
    r"\dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)^{3/2}} ",
    r"\ddot{\theta} \right] \right|"
);
const FRICTION_OF_MOTION: &str = concat!(
    r"\tau_2 = -a\mu I_f \left| \frac{a \sin^2 \theta (1-a^2)}{(1+a^2-2a \cos \theta)^3} ",
    r"\dot{\theta}^2 + \frac{\sin \theta (a \cos \theta - 1)}{(1+a^2-2a \cos \theta)^2} ",
    r"\ddot{\theta} \right|"
);

pub(super) fn claims() -> Vec<Claim> {
    [torque(), normal_force(), substituted(), spring()].concat()
}

fn torque() -> Vec<Claim> {
    vec![
        at("Fig. 6").lost_drawing("meyer.fig-6", "Figure 6", "the moment arm of the friction about the driver's axis"),
        at("1st display after Fig. 6")
            .equation(
                "meyer.friction-torque",
                r"\tau_2 = h\mu N = c \sin \phi \mu N",
                "size of the friction torque, whose moment arm c sin φ is the distance that the pin slides per radian",
            )
            .proven_by(size)
            .read(Evidence::CLOSED_FORM, as_size),
        opposing("meyer.friction-opposes-again", "Sentence after τ_2 = hμN", "must always oppose the driving torque"),
        at("2nd display after Fig. 6")
            .equation(
                "meyer.friction-torque.opposing",
                r"\tau_2 = -|c \sin \phi \mu N| = -\mu c |N \sin \phi|",
                "friction torque with its sign",
            )
            .proven_by(triangle)
            .read(Evidence::CLOSED_FORM, holds),
        at("3rd display after Fig. 6")
            .equation(
                "meyer.friction-torque.by-ratio",
                r"\tau_2 = -ar\mu |N \sin \phi|",
                "friction torque with its sign and c = a r",
            )
            .proven_by(triangle)
            .read(Evidence::CLOSED_FORM, holds),
        at("Sentence before Eq. (1-11)").lost_drawing(
            "meyer.triangle-drawing",
            "the following triangle can be drawn",
            "the triangle from which sin φ is read off",
        ),
        at("Eq. (1-11)")
            .equation(
                "meyer.eq-1-11",
                r"\sin \phi = \frac{\sin \theta}{(1 + a^2 - 2a \cos \theta)^{1/2}}",
                "sine of the follower's angle",
            )
            .proven_by(triangle)
            .read(Evidence::CLOSED_FORM, holds),
        at("Eq. (1-12)")
            .equation(
                "meyer.eq-1-12",
                r"\tau_2 = -ar\mu \left| \frac{N \sin \theta}{(1 + a^2 - 2a \cos \theta)^{1/2}} \right|",
                "torque of friction with the driver's angle alone",
            )
            .proven_by(triangle)
            .read(Evidence::CLOSED_FORM, holds),
    ]
}

fn normal_force() -> Vec<Claim> {
    vec![
        at("Fig. 7").lost_drawing("meyer.fig-7", "Figure 7", "the forces on the follower"),
        at("Display after Fig. 7")
            .equation(
                "meyer.moments",
                r"NR = I_P \ddot{\theta}",
                "moments on the follower about its axis, to which friction along the slot contributes nothing",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds)
            .corrected(r"NR = I_f \ddot{\phi}", PHI_AS_THETA)
            .in_places(2),
        at("1st display of R after Fig. 7")
            .equation(
                "meyer.slot-radius.by-sines",
                concat!(
                    r"R = \frac{r \sin \theta}{\sin \phi} = \frac{r \sin \theta}{(\sin \theta) / (1 + ",
                    r"a^2 - 2a \cos \theta)^{1/2}}"
                ),
                "distance of the pin from the follower's axis, by the law of sines",
            )
            .proven_by(triangle)
            .read(Evidence::CLOSED_FORM, holds),
        at("2nd display of R after Fig. 7")
            .equation(
                "meyer.slot-radius",
                r"R = r(1 + a^2 - 2a \cos \theta)^{1/2}",
                "distance of the pin from the follower's axis, in a form that holds on the line of centres too",
            )
            .proven_by(triangle)
            .read(Evidence::CLOSED_FORM, holds),
        at("1st display of N before Eq. (1-13)")
            .equation(
                "meyer.normal-force",
                r"N = \frac{I_P \ddot{\theta}}{R}",
                "normal force from the moments on the follower",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds)
            .corrected(r"N = \frac{I_f \ddot{\phi}}{R}", PHI_AS_THETA)
            .in_places(2),
        at("2nd display of N before Eq. (1-13)")
            .equation("meyer.normal-force.substituted", SUBSTITUTED, "normal force with Eq. (1-8) and R substituted")
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds)
            .corrected(SUBSTITUTED_CORRECTED, HALF_POWERS),
        at("Eq. (1-13)")
            .equation("meyer.eq-1-13", NORMAL_FORCE, "normal force with R multiplied into the brackets")
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds)
            .corrected(NORMAL_FORCE_CORRECTED, HALF_POWERS),
    ]
}

fn substituted() -> Vec<Claim> {
    vec![
        at("Display before Eq. (1-14)")
            .equation(
                "meyer.friction-torque.substituted",
                FRICTION_SUBSTITUTED,
                "friction torque with the normal force substituted",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds)
            .corrected(FRICTION_SUBSTITUTED_CORRECTED, HALF_POWERS).in_places(2),
        at("Eq. (1-14)")
            .equation("meyer.eq-1-14", FRICTION_OF_MOTION, "friction torque from the motion of the driver alone")
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
        at("Line after Eq. (1-14)")
            .statement(
                "meyer.outside-the-bars",
                "always positive",
                "r and the follower's inertia are positive, so they can be moved outside the bars",
            )
            .first_route(Evidence::VECTORS, |stated| {
                equal(
                    |letter| {
                        let factor = letter("r") * letter("I_f") * stated.pick(1.0, letter("N"));
                        (letter("friction").abs(), factor * (letter("friction") / factor).abs())
                    },
                    "the expression with bars around all of it and the expression with fewer factors between the bars",
                )
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                // Follower inertia, and the normal force by the equation of motion.
                let sizes = |parameters: Parameters, angle: f64, speed: f64| {
                    let angular_acceleration =
                        parameters.acceleration(angle, speed).map_or(f64::NAN, |found| found.value);
                    let inertia = parameters.inertias().follower();
                    let force = inertia * parameters.pose(angle).follower_acceleration(&speed, &angular_acceleration);
                    let between =
                        inertia * parameters.coefficients(angle).between_the_bars(&speed, &angular_acceleration);
                    let factor = stated.pick(inertia, force);
                    (between.abs(), factor * (between / factor).abs())
                };
                let holds = rubbing().all(|parameters| {
                    (-9..=9).filter(|k| *k != 0).all(|k| {
                        let angle = parameters.mechanism().engagement_half_angle() * f64::from(k) / 10.0;
                        [0.25, 1.0, 4.0].iter().all(|speed| {
                            let (around_all, outside) = sizes(parameters, angle, *speed);
                            vanishes((around_all - outside) / around_all.max(1.0))
                        })
                    })
                });
                Finding::new(
                    holds,
                    "we evaluated the expression between the bars by the equation of motion, at 18 angles and three speeds",
                )
            })
            .but_not("the normal force is always positive too, so it can be moved outside them"),
    ]
}

fn spring() -> Vec<Claim> {
    vec![
        at("Eq. (1-15)")
            .equation("meyer.eq-1-15", r"\tau_1 = K", "the driving torque is constant")
            .proven_by(mechanism)
            .read(Evidence::VECTORS, holds)
            .with_second_witness(crate::evidence::QUADRATURE, || {
                let holds =
                    frictionless().all(|(of, advance)| agrees_in_steps(energy_gained(&of), of.drive() * advance));
                Finding::new(holds, "the energy gained over an engagement without friction is K times its angle")
            }),
        no_rate(
            "meyer.spring-rate",
            at("Line after Eq. (1-15)"),
            "what K is called",
            "torsional spring rate in inch-pounds per radian",
            "torque of the spring in inch-pounds per radian",
        ),
    ]
}

/// Escapements with friction.
fn rubbing() -> impl Iterator<Item = Parameters> {
    frictionless().filter_map(|(of, _)| Parameters::new(of.mechanism(), of.inertias(), of.torque(), 0.25).ok())
}

/// Whether a display of the torque's size holds where the friction has a positive sign: it stands without bars there.
fn as_size(tex: &str) -> Option<bool> {
    static WITH_SIZE: OnceLock<Vec<reading::Moment>> = OnceLock::new();
    let with_size = WITH_SIZE.get_or_init(|| {
        let pressing = moments().iter().filter(|moment| letters_of(moment)("friction") > 0.0);
        let with_size = |moment: &reading::Moment| {
            let mut letters = moment.letters().clone();
            letters.insert("tau_2".to_owned(), letters_of(moment)("friction"));
            reading::Moment::of(letters)
        };
        pressing.map(with_size).collect()
    });
    reading::holds(tex, with_size)
}
