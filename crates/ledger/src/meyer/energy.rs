//! The kinetic energy and its derivatives: Eq. (1-16), and the displays before Eq. (1-17).

use super::instants::{display, miscopied, reads, reads_as, slip};
use super::*;
use geneva_dynamics::derivation::{
    EnergyLine, Form, KineticEnergy, Momentum, MomentumLine, MomentumRate, PositionLine, PositionRate,
};
use std::sync::OnceLock;

const I_B: &str = "The inertia of the driver is I_D, here as in Eq. (1-16). No I_b is known to the source.";

pub fn claims() -> Vec<Claim> {
    [energy(), set_up(), by_quotient(), by_speed(), by_angle()].concat()
}

fn energy() -> Vec<Claim> {
    vec![
        slip(
            "meyer.kinetic-energy",
            "1st display of T before Eq. (1-16)",
            "kinetic energy of driver and follower",
            r"T = \frac{1}{2} I_D \dot{\theta}^2 + \frac{1}{2} I_f \dot{\theta}^2",
            [|| members(Form::Printed), || members(Form::Corrected)],
            || reads("meyer.kinetic-energy"),
            miscopied(
                r"T = \frac{1}{2} I_D \dot{\theta}^2 + \frac{1}{2} I_f \dot{\phi}^2",
                "The follower turns at the rate of φ. The next display is right.",
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.kinetic-energy.replaced",
            "Line before Eq. (1-16)",
            "the rate that Eq. (1-7) is put in for",
            r"\dot{\theta}",
            Check::corrected_equation(
                (ClosedForm, || reads_in_place_of("theta'")),
                || reads_in_place_of("phi'"),
                (ExactIdentity, || prove(&KineticEnergy(EnergyLine::Substituted)).into()),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"\dot{\phi}",
            slip: Slip {
                id: "",
                reason: "Eq. (1-7) gives the rate of φ, and that is what goes out of the next display.",
                witness: "The next display has the rate of θ still, and the factor of Eq. (1-7) \
                    in its follower's part only.",
                origin: Origin::Copy,
                consequence: Consequence::Copy,
                changes: "",
            },
        }),
        display(
            "meyer.kinetic-energy.substituted",
            "2nd display of T before Eq. (1-16)",
            "kinetic energy with Eq. (1-7) put in",
            r"T = \frac{1}{2} I_D \dot{\theta}^2 + \frac{1}{2} I_f \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} \dot{\theta}^2",
            || prove(&KineticEnergy(EnergyLine::Substituted)).into(),
            || reads("meyer.kinetic-energy.substituted"),
        ),
        display(
            "meyer.eq-1-16",
            "Eq. (1-16)",
            "kinetic energy by the speed of the driver alone",
            r"T = \frac{1}{2} \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \dot{\theta}^2",
            || prove(&KineticEnergy(EnergyLine::Bracketed)).into(),
            || reads("meyer.eq-1-16"),
        ),
    ]
}

fn set_up() -> Vec<Claim> {
    vec![
        display(
            "meyer.position-rate.set-up",
            "1st display after Eq. (1-16)",
            "derivative of the kinetic energy by θ, to be worked out",
            r"\frac{\partial T}{\partial \theta} = \frac{\partial}{\partial \theta} \left[\frac{1}{2} \left\{ I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right\} \dot{\theta}^2 \right]",
            || prove(&PositionRate::of(PositionLine::Undone)).into(),
            || reads_as("meyer.position-rate.set-up", r"\frac{\partial}{\partial \theta}", "T"),
        ),
        display(
            "meyer.momentum",
            "2nd display after Eq. (1-16)",
            "derivative of the kinetic energy by the speed",
            r"\frac{\partial T}{\partial \dot{\theta}} = \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \dot{\theta}",
            || prove(&Momentum).into(),
            || reads("meyer.momentum"),
        ),
        display(
            "meyer.momentum-rate.set-up",
            "3rd display after Eq. (1-16)",
            "its rate, to be worked out",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \frac{d}{dt} \left[\left\{ I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right\} \dot{\theta} \right]",
            || prove(&MomentumRate::of(MomentumLine::Undone, Form::Printed)).into(),
            || reads_as("meyer.momentum-rate.set-up", r"\frac{d}{dt}", "Y"),
        ),
    ]
}

fn by_quotient() -> Vec<Claim> {
    vec![
        letter_b(
            "meyer.momentum-rate.quotient.first-line",
            "4th display after Eq. (1-16), 1st line",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_b + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
            [|| letter(MomentumLine::Quotient, Form::Printed), quotient],
            || reads_as("meyer.momentum-rate.quotient.first-line", "=", "inertia-term"),
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
        ),
        display(
            "meyer.momentum-rate.quotient.second-line",
            "4th display after Eq. (1-16), 2nd line",
            "the numerator of the fraction differentiated",
            r"+ \dot{\theta} \left[0 + I_f \left\{ \frac{((1+a^2-2a \cos \theta)^2 [2(a \cos \theta - 1)(-a \sin \theta \dot{\theta})])}{(1+a^2-2a \cos \theta)^4} \right. \right.",
            quotient,
            || reads_as("meyer.momentum-rate.quotient.second-line", "", "quotient-lead"),
        ),
        slip(
            "meyer.momentum-rate.quotient.third-line",
            "4th display after Eq. (1-16), 3rd line",
            "the denominator of the fraction differentiated",
            r"\left. \left. + \frac{(-a \cos \theta - 1)^2 (2)(1+a^2-2a \cos \theta)(2a \sin \theta \dot{\theta})}{(1+a^2-2a \cos \theta)^4} \right] \right]",
            [
                || {
                    let (line, letter, quotient) = (MomentumLine::Quotient, Form::Corrected, Form::Printed);
                    prove(&MomentumRate { line, letter, quotient }).into()
                },
                quotient,
            ],
            || reads_as("meyer.momentum-rate.quotient.third-line", "", "quotient-square"),
            miscopied(
                r"\left. \left. - \frac{(a \cos \theta - 1)^2 (2)(1+a^2-2a \cos \theta)(2a \sin \theta \dot{\theta})}{(1+a^2-2a \cos \theta)^4} \right\} \right]",
                "By the rule for quotients the term is subtracted. The minus sign has \
                        moved into the bracket; the next display has it in its place. The \
                        brackets of the line do not match either.",
            ),
        ),
    ]
}

fn by_speed() -> Vec<Claim> {
    vec![
        letter_b(
            "meyer.momentum-rate.cancelled.first-line",
            "5th display after Eq. (1-16), 1st line",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_b + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
            [|| letter(MomentumLine::Cancelled, Form::Printed), cancelled],
            || reads_as("meyer.momentum-rate.cancelled.first-line", "=", "inertia-term"),
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
        ),
        display(
            "meyer.momentum-rate.cancelled.second-line",
            "5th display after Eq. (1-16), 2nd line",
            "what the turning of the follower's place adds, with common factors cancelled",
            r"+ I_f \dot{\theta} \left[\frac{-2(a \cos \theta - 1)(a \sin \theta \dot{\theta})}{(1+a^2-2a \cos \theta)^2} - \frac{(a \cos \theta - 1)^2 (2)(2a \sin \theta \dot{\theta})}{(1+a^2-2a \cos \theta)^3} \right]",
            cancelled,
            || reads_as("meyer.momentum-rate.cancelled.second-line", "", "speed-term"),
        ),
        letter_b(
            "meyer.momentum-rate.factored.first-line",
            "6th display after Eq. (1-16), 1st line",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_b + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
            [|| letter(MomentumLine::Factored, Form::Printed), factored],
            || reads_as("meyer.momentum-rate.factored.first-line", "=", "inertia-term"),
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
        ),
        display(
            "meyer.momentum-rate.factored.second-line",
            "6th display after Eq. (1-16), 2nd line",
            "the same with its factors outside the braces",
            r"- 2I_f \dot{\theta}^2 \left[\frac{a \sin \theta (a \cos \theta - 1)}{(1+a^2-2a \cos \theta)^2} \left\{ 1 + \frac{2(a \cos \theta - 1)}{(1+a^2-2a \cos \theta)} \right\} \right]",
            factored,
            || reads_as("meyer.momentum-rate.factored.second-line", "", "speed-term"),
        ),
        letter_b(
            "meyer.momentum-rate",
            "7th display after Eq. (1-16)",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_b + \frac{(a \cos \theta - 1)^2 I_f}{(1+a^2-2a \cos \theta)^2} \right] \ddot{\theta} - 2I_f \dot{\theta}^2 \left[\frac{a(a^2-1) \sin \theta (a \cos \theta - 1)}{(1+a^2-2a \cos \theta)^3} \right]",
            [|| letter(MomentumLine::Closed, Form::Printed), || letter(MomentumLine::Closed, Form::Corrected)],
            || reads("meyer.momentum-rate"),
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_D + \frac{(a \cos \theta - 1)^2 I_f}{(1+a^2-2a \cos \theta)^2} \right] \ddot{\theta} - 2I_f \dot{\theta}^2 \left[\frac{a(a^2-1) \sin \theta (a \cos \theta - 1)}{(1+a^2-2a \cos \theta)^3} \right]",
        ),
    ]
}

fn by_angle() -> Vec<Claim> {
    vec![
        slip(
            "meyer.position-rate.taken-up",
            "8th display after Eq. (1-16)",
            "the derivative by θ, taken up again",
            r"\frac{\partial T}{\partial \theta} = \frac{\partial}{\partial \theta} \left[\frac{1}{2} \left\{ I_b + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right\} \dot{\theta}^2 \right]",
            [
                || prove(&PositionRate::energy(Form::Printed)).into(),
                || prove(&PositionRate::energy(Form::Corrected)).into(),
            ],
            || reads_as("meyer.position-rate.taken-up", r"\frac{\partial}{\partial \theta}", "T"),
            miscopied(
                r"\frac{\partial T}{\partial \theta} = \frac{\partial}{\partial \theta} \left[\frac{1}{2} \left\{ I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right\} \dot{\theta}^2 \right]",
                "The inertia of the driver is I_D, as in the same display after Eq. \
                        (1-16). The derivative does not depend on it, but what stands in the \
                        brackets is not the kinetic energy.",
            ),
        ),
        by_theta(
            "meyer.position-rate.outside",
            "9th display after Eq. (1-16)",
            r"\frac{\partial T}{\partial \theta} = 0 + \frac{1}{2} I_f \dot{\theta}^2 \frac{\partial}{\partial \theta} \left[\frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} \right]",
            || prove(&PositionRate::of(PositionLine::Outside)).into(),
            || reads_as("meyer.position-rate.outside", r"\frac{\partial}{\partial \theta}", "ratio-squared"),
        ),
        by_theta(
            "meyer.position-rate.quotient",
            "10th display after Eq. (1-16)",
            r"\begin{aligned} \frac{\partial T}{\partial \theta} &= \frac{1}{2} I_f \dot{\theta}^2 \left[\frac{(1+a^2-2a \cos \theta)^2 (2)(a \cos \theta - 1)(-a \sin \theta)}{(1+a^2-2a \cos \theta)^4} \right. \\ &\left. - \frac{(a \cos \theta - 1)^2 (2)(1+a^2-2a \cos \theta)(2a \sin \theta)}{(1+a^2-2a \cos \theta)^4} \right] \end{aligned}",
            || prove(&PositionRate::of(PositionLine::Quotient)).into(),
            || reads("meyer.position-rate.quotient"),
        ),
        by_theta(
            "meyer.position-rate.cancelled",
            "11th display after Eq. (1-16)",
            r"\frac{\partial T}{\partial \theta} = \frac{1}{2} I_f \dot{\theta}^2 \left[\frac{-2(a \cos \theta - 1)(a \sin \theta)}{(1+a^2-2a \cos \theta)^2} + \frac{-2(a \cos \theta - 1)^2 (2a \sin \theta)}{(1+a^2-2a \cos \theta)^3} \right]",
            || prove(&PositionRate::of(PositionLine::Cancelled)).into(),
            || reads("meyer.position-rate.cancelled"),
        ),
        by_theta(
            "meyer.position-rate.factored",
            "12th display after Eq. (1-16)",
            r"\frac{\partial T}{\partial \theta} = -I_f \dot{\theta}^2 \left[\frac{(a \cos \theta - 1)(a \sin \theta)}{(1+a^2-2a \cos \theta)^2} \left\{ 1 + \frac{(a \cos \theta - 1)(2)}{(1+a^2-2a \cos \theta)} \right\} \right]",
            || prove(&PositionRate::of(PositionLine::Factored)).into(),
            || reads("meyer.position-rate.factored"),
        ),
        by_theta(
            "meyer.position-rate",
            "13th display after Eq. (1-16)",
            r"\frac{\partial T}{\partial \theta} = -I_f \dot{\theta}^2 \left[\frac{a(a^2-1) \sin \theta (a \cos \theta - 1)}{(1+a^2-2a \cos \theta)^3} \right]",
            || prove(&PositionRate::of(PositionLine::Closed)).into(),
            || reads("meyer.position-rate"),
        ),
    ]
}

/// A step of the derivative by θ.
fn by_theta(
    id: &'static str,
    locator: &'static str,
    printed: &'static str,
    proof: fn() -> Finding,
    read: fn() -> Finding,
) -> Claim {
    display(id, locator, "derivative of the kinetic energy by θ, a step further", printed, proof, read)
}

/// A line that has I_b for I_D.
fn letter_b(
    id: &'static str,
    locator: &'static str,
    printed: &'static str,
    proofs: [fn() -> Finding; 2],
    read: fn() -> Finding,
    corrected: &'static str,
) -> Claim {
    let meaning = "rate of the derivative by the speed: what the driver's acceleration adds";
    slip(id, locator, meaning, printed, proofs, read, miscopied(corrected, I_B))
}

/// The rule for quotients put right: one proof for the three lines of the display. The next two are like it.
fn quotient() -> Finding {
    static PROOF: OnceLock<Finding> = OnceLock::new();
    PROOF.get_or_init(|| letter(MomentumLine::Quotient, Form::Corrected)).clone()
}

fn cancelled() -> Finding {
    static PROOF: OnceLock<Finding> = OnceLock::new();
    PROOF.get_or_init(|| letter(MomentumLine::Cancelled, Form::Corrected)).clone()
}

fn factored() -> Finding {
    static PROOF: OnceLock<Finding> = OnceLock::new();
    PROOF.get_or_init(|| letter(MomentumLine::Factored, Form::Corrected)).clone()
}

fn letter(line: MomentumLine, letter: Form) -> Finding {
    prove(&MomentumRate { line, letter, quotient: Form::Corrected }).into()
}

fn members(form: Form) -> Finding {
    prove(&KineticEnergy(EnergyLine::Members(form))).into()
}

/// Whether Eq. (1-7) says what this rate is.
fn reads_in_place_of(rate: &str) -> Finding {
    let holds = instants::instants().iter().all(|letters| {
        let letter = |name: &str| letters.get(name).copied().unwrap_or(f64::NAN);
        let ratio = claim("meyer.eq-1-7").and_then(|claim| claim.printed.rsplit_once('='));
        ratio.is_some_and(|(_, ratio)| agrees(reading::value(ratio, letters), letter(rate)))
    });
    Finding::new(holds, if holds { "Eq. (1-7), read and evaluated, is this rate" } else { "Eq. (1-7) is another rate" })
}
