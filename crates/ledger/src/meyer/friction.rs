//! The torque of friction and the normal force that makes it, up to the spring: Eqs. (1-11) to (1-15).

use super::instants::{display, equal, miscopied, reads, reads_as, slip, statement};
use super::lagrange::{friction, opposing};
use super::*;
use crate::Dimension as Exponents;
use geneva_dynamics::Sign;
use geneva_dynamics::derivation::{
    ForceFromMoment, ForceSubstituted, Form, FrictionLine, FrictionOfMotion, FrictionSubstituted, FrictionTorque,
    MomentEquation, NormalForce, SineOfFollower, SlotRadius, SlotRadiusBySines,
};

pub fn claims() -> Vec<Claim> {
    [torque(), normal_force(), substituted(), spring()].concat()
}

fn torque() -> Vec<Claim> {
    vec![
        lost_drawing("meyer.fig-6", "Fig. 6", "the moment arm of the friction about the driver's axis", "Figure 6"),
        display(
            "meyer.friction-torque",
            "1st display after Fig. 6",
            "size of the torque of friction: its moment arm c sin φ is how far the pin slides per radian",
            r"\tau_2 = h\mu N = c \sin \phi \mu N",
            || prove(&FrictionTorque { line: FrictionLine::Arm, contact: Sign::Plus }).into(),
            || reads_as("meyer.friction-torque", "=", "friction"),
        ),
        opposing(
            "meyer.friction-opposes-again",
            "Sentence after τ_2 = hμN",
            "the torque of friction is against the driving torque",
            "must always oppose the driving torque",
        ),
        display(
            "meyer.friction-torque.opposing",
            "2nd display after Fig. 6",
            "the same with its sign",
            r"\tau_2 = -|c \sin \phi \mu N| = -\mu c |N \sin \phi|",
            || both(&friction(FrictionLine::Opposing), friction(FrictionLine::Outside)),
            || reads("meyer.friction-torque.opposing"),
        ),
        display(
            "meyer.friction-torque.by-ratio",
            "3rd display after Fig. 6",
            "the same with c = a r",
            r"\tau_2 = -ar\mu |N \sin \phi|",
            || friction(FrictionLine::CrankRadii),
            || reads("meyer.friction-torque.by-ratio"),
        ),
        display(
            "meyer.eq-1-11",
            "Eq. (1-11)",
            "sine of the follower's angle",
            r"\sin \phi = \frac{\sin \theta}{(1 + a^2 - 2a \cos \theta)^{1/2}}",
            || prove(&SineOfFollower).into(),
            || reads("meyer.eq-1-11"),
        ),
        display(
            "meyer.eq-1-12",
            "Eq. (1-12)",
            "torque of friction with the driver's angle alone",
            r"\tau_2 = -ar\mu \left| \frac{N \sin \theta}{(1 + a^2 - 2a \cos \theta)^{1/2}} \right|",
            || friction(FrictionLine::Root),
            || reads("meyer.eq-1-12"),
        ),
    ]
}

fn normal_force() -> Vec<Claim> {
    vec![
        lost_drawing("meyer.fig-7", "Fig. 7", "the forces on the follower", "Figure 7"),
        slip(
            "meyer.moments",
            "Display after Fig. 7",
            "moments on the follower about its axis; friction along the slot has none",
            r"NR = I_P \ddot{\theta}",
            [|| prove(&MomentEquation(Form::Printed)).into(), || prove(&MomentEquation(Form::Corrected)).into()],
            || reads("meyer.moments"),
            miscopied(
                r"NR = I_f \ddot{\phi}",
                "The follower has the inertia I_f and the acceleration of φ. An index P \
                            is not known to the source, and the next step puts the follower's \
                            acceleration, Eq. (1-8), in its place.",
            ),
        ),
        display(
            "meyer.slot-radius.by-sines",
            "1st display of R after Fig. 7",
            "distance of the pin from the follower's axis, by the law of sines",
            r"R = \frac{r \sin \theta}{\sin \phi} = \frac{r \sin \theta}{(\sin \theta) / (1 + a^2 - 2a \cos \theta)^{1/2}}",
            || prove(&SlotRadiusBySines).into(),
            || reads("meyer.slot-radius.by-sines"),
        ),
        display(
            "meyer.slot-radius",
            "2nd display of R after Fig. 7",
            "the same, which holds on the line of centres too",
            r"R = r(1 + a^2 - 2a \cos \theta)^{1/2}",
            || prove(&SlotRadius).into(),
            || reads("meyer.slot-radius"),
        ),
        slip(
            "meyer.normal-force",
            "1st display of N before Eq. (1-13)",
            "normal force from the moments on the follower",
            r"N = \frac{I_P \ddot{\theta}}{R}",
            [|| prove(&ForceFromMoment(Form::Printed)).into(), || prove(&ForceFromMoment(Form::Corrected)).into()],
            || reads("meyer.normal-force"),
            miscopied(
                r"N = \frac{I_f \ddot{\phi}}{R}",
                "The same two letters as in the equation of moments; the next display \
                        has I_f and the acceleration of φ.",
            ),
        ),
        slip(
            "meyer.normal-force.substituted",
            "2nd display of N before Eq. (1-13)",
            "the same with Eq. (1-8) and R put in",
            r"N = \frac{I_f \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^2} \dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)} \ddot{\theta} \right]}{r(1+a^2-2a \cos \theta)^{3/2}}",
            [
                || prove(&ForceSubstituted::of(Form::Printed)).into(),
                || prove(&ForceSubstituted::of(Form::Corrected)).into(),
            ],
            || reads("meyer.normal-force.substituted"),
            miscopied(
                r"N = \frac{I_f \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^2} \dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)} \ddot{\theta} \right]}{r(1+a^2-2a \cos \theta)^{1/2}}",
                "The denominator is R, which stands two displays before with the \
                        exponent 1/2. The copy has 3/2 for each half power of this page.",
            ),
        ),
        slip(
            "meyer.eq-1-13",
            "Eq. (1-13)",
            "the same with R drawn into the brackets",
            r"N = \frac{I_f}{r} \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^{3/2}} \dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)^{3/2}} \ddot{\theta} \right]",
            [|| prove(&NormalForce::of(Form::Printed)).into(), || prove(&NormalForce::of(Form::Corrected)).into()],
            || reads("meyer.eq-1-13"),
            miscopied(
                r"N = \frac{I_f}{r} \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^{5/2}} \dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)^{3/2}} \ddot{\theta} \right]",
                "Two whole powers and a half are 5/2. Eq. (1-14), which follows from \
                        this, has the third power there and is right.",
            ),
        ),
    ]
}

fn substituted() -> Vec<Claim> {
    vec![
        slip(
            "meyer.friction-torque.substituted",
            "Display before Eq. (1-14)",
            "torque of friction with the normal force put in",
            r"\tau_2 = -ar\mu \left| \frac{\sin \theta}{(1+a^2-2a \cos \theta)^{3/2}} \frac{I_f}{r} \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^{3/2}} \dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)^{3/2}} \ddot{\theta} \right] \right|",
            [|| friction_substituted(Form::Printed), || friction_substituted(Form::Corrected)],
            || reads("meyer.friction-torque.substituted"),
            miscopied(
                r"\tau_2 = -ar\mu \left| \frac{\sin \theta}{(1+a^2-2a \cos \theta)^{1/2}} \frac{I_f}{r} \left[\frac{a \sin \theta (1-a^2)}{(1+a^2-2a \cos \theta)^{5/2}} \dot{\theta}^2 + \frac{a \cos \theta - 1}{(1+a^2-2a \cos \theta)^{3/2}} \ddot{\theta} \right] \right|",
                "Two of the three half powers are wrong: 1/2 under sin θ, as in Eq. \
                        (1-12), and 5/2 under the square of the speed. Their errors cancel in \
                        the term with the speed, not in the one with the acceleration.",
            ),
        ),
        display(
            "meyer.eq-1-14",
            "Eq. (1-14)",
            "torque of friction from the motion of the driver alone",
            r"\tau_2 = -a\mu I_f \left| \frac{a \sin^2 \theta (1-a^2)}{(1+a^2-2a \cos \theta)^3} \dot{\theta}^2 + \frac{\sin \theta (a \cos \theta - 1)}{(1+a^2-2a \cos \theta)^2} \ddot{\theta} \right|",
            || all_proven(&Sign::BOTH.map(|contact| FrictionOfMotion { contact })),
            || reads("meyer.eq-1-14"),
        ),
        statement(
            "meyer.outside-the-bars",
            "Line after Eq. (1-14)",
            "r and the follower's inertia are positive and may stand outside the bars",
            "always positive",
            (ExactIdentity, || all_proven(&Sign::BOTH.map(|contact| FrictionOfMotion { contact }))),
            (ClosedForm, || {
                equal(
                    |letter| {
                        let signed = letter("friction") / (letter("r") * letter("I_f"));
                        (letter("friction").abs(), letter("r") * letter("I_f") * signed.abs())
                    },
                    "bars around all, and around what is left of them",
                )
            }),
        ),
    ]
}

fn spring() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "meyer.eq-1-15",
            "Eq. (1-15)",
            "the driving torque is constant",
            r"\tau_1 = K",
            Check::equation(
                (Dimension, || {
                    // The unit that chapter II prints with an inertia, times an angular acceleration.
                    let inertia = Exponents::FORCE * Exponents::LENGTH * Exponents::TIME * Exponents::TIME;
                    let found = inertia * Exponents::ANGULAR_ACCELERATION;
                    Finding::new(found == Exponents::FORCE * Exponents::LENGTH, format!("K must be a {found}"))
                }),
                (Vectors, || reads("meyer.eq-1-15")),
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.spring-rate",
            "Line after Eq. (1-15)",
            "K is a rate of the spring, per radian, and constant",
            "torsional spring rate in inch-pounds per radian",
            Check::corrected_equation(
                (ClosedForm, || {
                    // With a rate K the torque after two radians is twice that after one.
                    let torque = |rate: f64, angle: f64| rate * angle;
                    let holds = torque(1.0, 1.0) == torque(1.0, 2.0);
                    Finding::new(
                        holds,
                        "the torque of a spring with a rate grows with its angle; this one is \
                            constant",
                    )
                }),
                || equal(|letter| (letter("K"), letter("Q_theta") - letter("tau_2")), "K is what balances the torques"),
                (OtherPlaceInSource, || {
                    let said =
                        claim("meyer.app-d.always-positive").is_some_and(|claim| claim.printed.contains("torque K"));
                    Finding::new(said, "Appendix D calls K a torque")
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "torque in inch-pounds",
            slip: Slip {
                id: "",
                reason: "The torque of the spring is K itself, Eq. (1-15). A rate per radian \
                    would have to be multiplied by an angle, and the torque would not be \
                    constant.",
                witness: "Appendix D speaks of the torque K.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
    ]
}

/// A drawing of which the copy has the caption only.
fn lost_drawing(id: &'static str, locator: &'static str, meaning: &'static str, printed: &'static str) -> Claim {
    let reason = "The drawing is not in the copy. What the text reads off it are claims of their own";
    Claim::figure(WORK, id, locator, meaning, printed, Check::Missing { reason }).expecting(Verdict::NotReproducible)
}

fn friction_substituted(form: Form) -> Finding {
    all_proven(&Sign::BOTH.map(|contact| FrictionSubstituted::of(form, contact)))
}

/// Whether two things hold, and how.
fn both(first: &Finding, second: Finding) -> Finding {
    Finding::new(first.holds && second.holds, format!("{}; {}", first.how, second.how))
}
