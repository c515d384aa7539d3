//! The kinetic energy and its derivatives: Eq. (1-16), and the displays before Eq. (1-17).

use super::instants::{
    self, display, display_read_by, holds_in_display, instants, miscopied, reads, slip, slip_read_by,
};
use super::slips::{DRIVER_INDEX, PHI_AS_THETA};
use super::*;
use geneva_dynamics::derivation::{
    EnergyLine, Form, KineticEnergy, Momentum, MomentumLine, MomentumRate, PositionLine, PositionRate,
};
use std::sync::OnceLock;

/// The derivative by θ, with what is differentiated.
const POSITION_RATE_SET_UP: &str = r"\frac{\partial T}{\partial \theta} = \frac{\partial}{\partial \theta} \left[\frac{1}{2} \left\{ I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right\} \dot{\theta}^2 \right]";

// Displays that are cut into lines.
const QUOTIENT: [&str; 3] = [
    "meyer.momentum-rate.quotient.first-line",
    "meyer.momentum-rate.quotient.second-line",
    "meyer.momentum-rate.quotient.third-line",
];
const CANCELLED: [&str; 2] = ["meyer.momentum-rate.cancelled.first-line", "meyer.momentum-rate.cancelled.second-line"];
const FACTORED: [&str; 2] = ["meyer.momentum-rate.factored.first-line", "meyer.momentum-rate.factored.second-line"];

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
            Erratum {
                corrected: r"T = \frac{1}{2} I_D \dot{\theta}^2 + \frac{1}{2} I_f \dot{\phi}^2",
                slip: PHI_AS_THETA,
            },
        ),
        Claim::statement(
            WORK,
            "meyer.kinetic-energy.replaced",
            "Line before Eq. (1-16)",
            "the rate that Eq. (1-7) is put in for",
            r"\dot{\theta}",
            Check::corrected_statement(
                (ClosedForm, |stated| reads_in_place_of(stated.pick("phi'", "theta'"))),
                (ExactIdentity, |stated| members(stated.pick(Form::Corrected, Form::Printed))),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected: r"\dot{\phi}", slip: PHI_AS_THETA }),
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
        display_read_by(
            of_the_energy,
            ("meyer.position-rate.set-up", "1st display after Eq. (1-16)"),
            "derivative of the kinetic energy by θ, to be worked out",
            POSITION_RATE_SET_UP,
            || prove(&PositionRate::of(PositionLine::Undone)).into(),
            || reads("meyer.position-rate.set-up"),
        ),
        display(
            "meyer.momentum",
            "2nd display after Eq. (1-16)",
            "derivative of the kinetic energy by the speed",
            r"\frac{\partial T}{\partial \dot{\theta}} = \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \dot{\theta}",
            || prove(&Momentum).into(),
            || reads("meyer.momentum"),
        ),
        display_read_by(
            |tex| instants::holds_of(tex, r"\frac{d}{dt}", r"\frac{\partial T}{\partial \dot{\theta}}"),
            ("meyer.momentum-rate.set-up", "3rd display after Eq. (1-16)"),
            "its rate, to be worked out",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \frac{d}{dt} \left[\left\{ I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right\} \dot{\theta} \right]",
            || prove(&MomentumRate::of(MomentumLine::Undone, Form::Printed)).into(),
            || reads("meyer.momentum-rate.set-up"),
        ),
    ]
}

fn by_quotient() -> Vec<Claim> {
    vec![
        letter_b(
            |tex| holds_in_display(&QUOTIENT, QUOTIENT[0], tex),
            QUOTIENT[0],
            "4th display after Eq. (1-16), 1st line",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_b + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
            [|| letter(MomentumLine::Quotient, Form::Printed), quotient],
            || reads("meyer.momentum-rate.quotient.first-line"),
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
        ),
        display_read_by(
            |tex| holds_in_display(&QUOTIENT, QUOTIENT[1], tex),
            (QUOTIENT[1], "4th display after Eq. (1-16), 2nd line"),
            "the numerator of the fraction differentiated",
            r"+ \dot{\theta} \left[0 + I_f \left\{ \frac{((1+a^2-2a \cos \theta)^2 [2(a \cos \theta - 1)(-a \sin \theta \dot{\theta})])}{(1+a^2-2a \cos \theta)^4} \right. \right.",
            quotient,
            || reads("meyer.momentum-rate.quotient.second-line"),
        ),
        slip_read_by(
            |tex| holds_in_display(&QUOTIENT, QUOTIENT[2], tex),
            (QUOTIENT[2], "4th display after Eq. (1-16), 3rd line"),
            "the denominator of the fraction differentiated",
            r"\left. \left. + \frac{(-a \cos \theta - 1)^2 (2)(1+a^2-2a \cos \theta)(2a \sin \theta \dot{\theta})}{(1+a^2-2a \cos \theta)^4} \right] \right]",
            [
                || {
                    let (line, letter, quotient) = (MomentumLine::Quotient, Form::Corrected, Form::Printed);
                    prove(&MomentumRate { line, letter, quotient }).into()
                },
                quotient,
            ],
            || reads("meyer.momentum-rate.quotient.third-line"),
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
            |tex| holds_in_display(&CANCELLED, CANCELLED[0], tex),
            CANCELLED[0],
            "5th display after Eq. (1-16), 1st line",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_b + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
            [|| letter(MomentumLine::Cancelled, Form::Printed), cancelled],
            || reads("meyer.momentum-rate.cancelled.first-line"),
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
        ),
        display_read_by(
            |tex| holds_in_display(&CANCELLED, CANCELLED[1], tex),
            (CANCELLED[1], "5th display after Eq. (1-16), 2nd line"),
            "what the turning of the follower's place adds, with common factors cancelled",
            r"+ I_f \dot{\theta} \left[\frac{-2(a \cos \theta - 1)(a \sin \theta \dot{\theta})}{(1+a^2-2a \cos \theta)^2} - \frac{(a \cos \theta - 1)^2 (2)(2a \sin \theta \dot{\theta})}{(1+a^2-2a \cos \theta)^3} \right]",
            cancelled,
            || reads("meyer.momentum-rate.cancelled.second-line"),
        ),
        letter_b(
            |tex| holds_in_display(&FACTORED, FACTORED[0], tex),
            FACTORED[0],
            "6th display after Eq. (1-16), 1st line",
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_b + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
            [|| letter(MomentumLine::Factored, Form::Printed), factored],
            || reads("meyer.momentum-rate.factored.first-line"),
            r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}",
        ),
        display_read_by(
            |tex| holds_in_display(&FACTORED, FACTORED[1], tex),
            (FACTORED[1], "6th display after Eq. (1-16), 2nd line"),
            "the same with its factors outside the braces",
            r"- 2I_f \dot{\theta}^2 \left[\frac{a \sin \theta (a \cos \theta - 1)}{(1+a^2-2a \cos \theta)^2} \left\{ 1 + \frac{2(a \cos \theta - 1)}{(1+a^2-2a \cos \theta)} \right\} \right]",
            factored,
            || reads("meyer.momentum-rate.factored.second-line"),
        ),
        letter_b(
            instants::holds,
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
        slip_read_by(
            of_the_energy,
            ("meyer.position-rate.taken-up", "8th display after Eq. (1-16)"),
            "the derivative by θ, taken up again; it does not depend on the letter, but what stands in the brackets is \
             not the kinetic energy",
            r"\frac{\partial T}{\partial \theta} = \frac{\partial}{\partial \theta} \left[\frac{1}{2} \left\{ I_b + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right\} \dot{\theta}^2 \right]",
            [
                || prove(&PositionRate::energy(Form::Printed)).into(),
                || prove(&PositionRate::energy(Form::Corrected)).into(),
            ],
            || reads("meyer.position-rate.taken-up"),
            Erratum { corrected: POSITION_RATE_SET_UP, slip: DRIVER_INDEX },
        ),
        by_theta(
            "meyer.position-rate.outside",
            "9th display after Eq. (1-16)",
            r"\frac{\partial T}{\partial \theta} = 0 + \frac{1}{2} I_f \dot{\theta}^2 \frac{\partial}{\partial \theta} \left[\frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} \right]",
            || prove(&PositionRate::of(PositionLine::Outside)).into(),
            || reads("meyer.position-rate.outside"),
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
    holds: fn(&str) -> Option<bool>,
    id: &'static str,
    locator: &'static str,
    printed: &'static str,
    proofs: [fn() -> Finding; 2],
    read: fn() -> Finding,
    corrected: &'static str,
) -> Claim {
    let meaning = "rate of the derivative by the speed: what the driver's acceleration adds";
    slip_read_by(holds, (id, locator), meaning, printed, proofs, read, Erratum { corrected, slip: DRIVER_INDEX })
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

/// Whether a display of ∂T/∂θ holds, and what it differentiates is the kinetic energy.
fn of_the_energy(tex: &str) -> Option<bool> {
    instants::holds_of(tex, r"\frac{\partial}{\partial \theta}", "T")
}

/// Whether Eq. (1-7) says what this rate is.
fn reads_in_place_of(rate: &str) -> Finding {
    let holds = instants().all(|letters| {
        let letter = |name: &str| letters.get(name).copied().unwrap_or(f64::NAN);
        let ratio = claim("meyer.eq-1-7").and_then(|claim| claim.printed.rsplit_once('='));
        ratio.is_some_and(|(_, ratio)| agrees(reading::value(ratio, letters), letter(rate)))
    });
    Finding::new(holds, if holds { "Eq. (1-7), read and evaluated, is this rate" } else { "Eq. (1-7) is another rate" })
}
