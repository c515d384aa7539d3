//! The equation of motion put together, and its five factors: Eqs. (1-17) to (1-19).

use super::instants::{self, display, display_read_by, holds_in_display, miscopied, reads, slip, slip_read_by};
use super::slips::{ARC, LOST_BARS, MISSING_SQUARE};
use super::*;
use geneva_dynamics::Sign;
use geneva_dynamics::derivation::{
    Coefficient, CoefficientPrinted, EquationOfMotion, Form, LeftSide, LeftSideLine, MotionLine,
};
use std::sync::OnceLock;

// Displays that are cut into lines.
const PARTS_PUT_IN: [&str; 2] = ["meyer.parts-put-in.first-line", "meyer.parts-put-in.second-line"];
const EQUATION_OF_MOTION: [&str; 2] = ["meyer.eq-1-18.first-line", "meyer.eq-1-18.second-line"];

pub fn claims() -> Vec<Claim> {
    [left_side(), together(), factors()].concat()
}

fn left_side() -> Vec<Claim> {
    vec![
        display(
            "meyer.left-side",
            "Eq. (1-17), 1st and 2nd line",
            "one derivative of the kinetic energy less the other",
            r"\begin{aligned} \frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) - \frac{\partial T}{\partial \theta} &= \left[I_D + \frac{(a \cos \theta - 1)^2 I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] \ddot{\theta} - 2I_f \dot{\theta}^2 \left\{ \frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^3} \right\} \\ &\quad - \left[-I_f \dot{\theta}^2 \left\{ \frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^3} \right\} \right] \end{aligned}",
            || prove(&LeftSide(LeftSideLine::Minus)).into(),
            || reads("meyer.left-side"),
        ),
        slip(
            "meyer.eq-1-17",
            "Eq. (1-17), 3rd and 4th line",
            "the same collected",
            r"\begin{aligned} \frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) - \frac{\partial T}{\partial \theta} &= \left[I_D + \frac{(a \cos \theta - 1) I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] \ddot{\theta} \\ &\quad - I_f \dot{\theta}^2 \left[\frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^3} \right] \end{aligned}",
            [
                || prove(&LeftSide(LeftSideLine::Closed(Form::Printed))).into(),
                || prove(&LeftSide(LeftSideLine::Closed(Form::Corrected))).into(),
            ],
            || reads("meyer.eq-1-17"),
            Erratum {
                corrected: r"\begin{aligned} \frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) - \frac{\partial T}{\partial \theta} &= \left[I_D + \frac{(a \cos \theta - 1)^2 I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] \ddot{\theta} \\ &\quad - I_f \dot{\theta}^2 \left[\frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^3} \right] \end{aligned}",
                slip: MISSING_SQUARE,
            },
        ),
    ]
}

fn together() -> Vec<Claim> {
    vec![
        slip_read_by(
            |tex| holds_in_display(&PARTS_PUT_IN, PARTS_PUT_IN[0], tex),
            (PARTS_PUT_IN[0], "Display before Eq. (1-18), 1st line"),
            "left side of the equation of motion",
            r"\left[I_D + \frac{(a \cos \theta - 1) I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] \ddot{\theta} - \left[\frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^3} \right] I_f \dot{\theta}^2",
            [|| motion(MotionLine::Substituted { square: Form::Printed, bars: Form::Corrected }), parts_put_in],
            || reads("meyer.parts-put-in.first-line"),
            Erratum {
                corrected: r"\left[I_D + \frac{(a \cos \theta - 1)^2 I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] \ddot{\theta} - \left[\frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^3} \right] I_f \dot{\theta}^2",
                slip: MISSING_SQUARE,
            },
        ),
        slip_read_by(
            |tex| holds_in_display(&PARTS_PUT_IN, PARTS_PUT_IN[1], tex),
            (PARTS_PUT_IN[1], "Display before Eq. (1-18), 2nd line"),
            "right side of the equation of motion",
            r"= K - a \mu I_f \left[\frac{a \sin^2 \theta (1 - a^2) \dot{\theta}^2}{(1 + a^2 - 2a \cos \theta)^3} + \frac{\sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^2} \ddot{\theta} \right]",
            [|| motion(MotionLine::Substituted { square: Form::Corrected, bars: Form::Printed }), parts_put_in],
            || reads("meyer.parts-put-in.second-line"),
            Erratum {
                corrected: r"= K - a \mu I_f \left| \frac{a \sin^2 \theta (1 - a^2) \dot{\theta}^2}{(1 + a^2 - 2a \cos \theta)^3} + \frac{\sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^2} \ddot{\theta} \right|",
                slip: LOST_BARS,
            },
        ),
        display_read_by(
            |tex| holds_in_display(&EQUATION_OF_MOTION, EQUATION_OF_MOTION[0], tex),
            (EQUATION_OF_MOTION[0], "Eq. (1-18), 1st line"),
            "equation of motion over the follower's inertia, without friction",
            r"\left[\frac{I_D}{I_f} + \frac{(a \cos \theta - 1)^2}{(1 + a^2 - 2a \cos \theta)^2} \right] \ddot{\theta} + \left[\frac{a(1 - a^2) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^3} \right] \dot{\theta}^2",
            divided,
            || reads("meyer.eq-1-18.first-line"),
        ),
        slip_read_by(
            |tex| holds_in_display(&EQUATION_OF_MOTION, EQUATION_OF_MOTION[1], tex),
            (EQUATION_OF_MOTION[1], "Eq. (1-18), 2nd line"),
            "its friction, and the drive",
            r"+ a \mu \left[\frac{a \sin^2 \theta (1 - a^2)}{(1 + a^2 - 2a \cos \theta)^3} \dot{\theta}^2 + \frac{\sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^2} \ddot{\theta} \right] = \frac{K}{I_f}",
            [|| motion(MotionLine::Divided { bars: Form::Printed }), divided],
            || reads("meyer.eq-1-18.second-line"),
            Erratum {
                corrected: r"+ a \mu \left| \frac{a \sin^2 \theta (1 - a^2)}{(1 + a^2 - 2a \cos \theta)^3} \dot{\theta}^2 + \frac{\sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^2} \ddot{\theta} \right| = \frac{K}{I_f}",
                slip: LOST_BARS,
            },
        ),
    ]
}

fn factors() -> Vec<Claim> {
    vec![
        slip(
            "meyer.factor-a",
            "1st substitution before Eq. (1-19)",
            "A, the factor of the driver's acceleration",
            r"A = \left[ \frac{I_f}{I_f} + \frac{(\text{acos}\theta-1)^2}{(1+a^2-2\text{acos}\theta)^2} \right]",
            [|| factor(Coefficient::A(Form::Printed)), || factor(Coefficient::A(Form::Corrected))],
            || reads("meyer.factor-a"),
            miscopied(
                r"A = \left[ \frac{I_D}{I_f} + \frac{(a\cos\theta-1)^2}{(1+a^2-2a\cos\theta)^2} \right]",
                "Eq. (1-18), from which the display is taken, has the inertia of the driver above the line, and so has \
                 the program. The letters of a and cos run together here as in the next three displays.",
            ),
        ),
        arc(
            "meyer.factor-b",
            "2nd substitution before Eq. (1-19)",
            "B, the factor of the square of the speed",
            r"B = \left[ \frac{a(1-a^2)\sin\theta(\text{acos}\theta-1)}{(1+a^2-2\text{acos}\theta)^3} \right]",
            [|| reads_printed("meyer.factor-b"), || factor(Coefficient::B)],
            || reads("meyer.factor-b"),
            r"B = \left[ \frac{a(1-a^2)\sin\theta(a\cos\theta-1)}{(1+a^2-2a\cos\theta)^3} \right]",
        ),
        arc(
            "meyer.factor-c",
            "3rd substitution before Eq. (1-19)",
            "C, the factor of the square of the speed between the bars",
            r"C = \left[ \mu \frac{a^2 \sin^2 \theta (1-a^2)}{(1+a^2-2\text{acos}\theta)^3} \right]",
            [|| reads_printed("meyer.factor-c"), || factor(Coefficient::C)],
            || reads("meyer.factor-c"),
            r"C = \left[ \mu \frac{a^2 \sin^2 \theta (1-a^2)}{(1+a^2-2a\cos\theta)^3} \right]",
        ),
        arc(
            "meyer.factor-d",
            "4th substitution before Eq. (1-19)",
            "D, the factor of the acceleration between the bars",
            r"D = \left[ \mu \frac{a \sin \theta (\text{acos}\theta-1)}{(1+a^2-2\text{acos}\theta)^2} \right]",
            [|| reads_printed("meyer.factor-d"), || factor(Coefficient::D)],
            || reads("meyer.factor-d"),
            r"D = \left[ \mu \frac{a \sin \theta (a\cos\theta-1)}{(1+a^2-2a\cos\theta)^2} \right]",
        ),
        display(
            "meyer.factor-e",
            "5th substitution before Eq. (1-19)",
            "E, what drives",
            r"E = \frac{K}{I_f}",
            || factor(Coefficient::E),
            || reads("meyer.factor-e"),
        ),
        display(
            "meyer.eq-1-19",
            "Eq. (1-19)",
            "equation of motion with the five factors",
            r"A\ddot{\theta} + B\dot{\theta}^2 + |C\dot{\theta}^2 + D\ddot{\theta}| = E",
            || motion(MotionLine::Short),
            || reads("meyer.eq-1-19"),
        ),
    ]
}

/// A factor in which nothing is wrong but the inverse cosine.
fn arc(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    [as_printed, put_right]: [fn() -> Finding; 2],
    read: fn() -> Finding,
    corrected: &'static str,
) -> Claim {
    let check =
        Check::corrected_equation((ClosedForm, as_printed), put_right, (ClosedForm, read)).read_by(instants::holds);
    Claim::equation(WORK, id, locator, meaning, printed, check)
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum { corrected, slip: ARC })
}

/// Whether the printed characters hold, of a display whose slip no identity can express.
fn reads_printed(id: &str) -> Finding {
    let holds = claim(id).is_some_and(|claim| instants::holds(claim.printed) == Some(true));
    Finding::new(holds, "with an inverse cosine, read and evaluated")
}

/// The display before Eq. (1-18), put right: one proof for its two lines.
fn parts_put_in() -> Finding {
    static PROOF: OnceLock<Finding> = OnceLock::new();
    PROOF.get_or_init(|| motion(MotionLine::Substituted { square: Form::Corrected, bars: Form::Corrected })).clone()
}

/// Eq. (1-18) put right, in the same way.
fn divided() -> Finding {
    static PROOF: OnceLock<Finding> = OnceLock::new();
    PROOF.get_or_init(|| motion(MotionLine::Divided { bars: Form::Corrected })).clone()
}

/// A display of the whole equation, for both signs of what stands between the bars.
fn motion(line: MotionLine) -> Finding {
    all_proven(&Sign::BOTH.map(|contact| EquationOfMotion { line, contact }))
}

fn factor(factor: Coefficient) -> Finding {
    prove(&CoefficientPrinted(factor)).into()
}
