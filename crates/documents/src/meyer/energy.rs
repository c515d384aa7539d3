//! The kinetic energy and its derivatives: Eq. (1-16), and the displays before Eq. (1-17).

use super::instants::{self, holds, instants, joined_hold, miscopied};
use super::letters::{mechanism, proven_of};
use super::reading::decide;
use super::slips::{DRIVER_INDEX, PHI_AS_THETA};
use super::*;

/// The derivative by θ, with what is differentiated.
const POSITION_RATE_SET_UP: &str = concat!(
    r"\frac{\partial T}{\partial \theta} = \frac{\partial}{\partial \theta} ",
    r"\left[\frac{1}{2} \left\{ I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos ",
    r"\theta)^2} I_f \right\} \dot{\theta}^2 \right]"
);

const BY_ANGLE: &str = r"\frac{\partial}{\partial \theta}";

// Displays that are cut into lines.
const QUOTIENT: [&str; 3] = [
    "meyer.momentum-rate.quotient.first-line",
    "meyer.momentum-rate.quotient.second-line",
    "meyer.momentum-rate.quotient.third-line",
];
const CANCELLED: [&str; 2] = ["meyer.momentum-rate.cancelled.first-line", "meyer.momentum-rate.cancelled.second-line"];
const FACTORED: [&str; 2] = ["meyer.momentum-rate.factored.first-line", "meyer.momentum-rate.factored.second-line"];

/// The first line of the three displays in which the rate of ∂T/∂θ' is worked out, as printed in each, and put right.
const FIRST_LINE: &str = concat!(
    r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_b + ",
    r"\frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}"
);
const FIRST_LINE_RIGHT: &str = concat!(
    r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_D + ",
    r"\frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \ddot{\theta}"
);

pub(super) fn claims() -> Vec<Claim> {
    [energy(), set_up(), by_quotient(), by_speed(), by_angle()].concat()
}

fn energy() -> Vec<Claim> {
    vec![
        at("1st display of T before Eq. (1-16)")
            .equation(
                "meyer.kinetic-energy",
                r"T = \frac{1}{2} I_D \dot{\theta}^2 + \frac{1}{2} I_f \dot{\theta}^2",
                "kinetic energy of driver and follower",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds)
            .corrected(r"T = \frac{1}{2} I_D \dot{\theta}^2 + \frac{1}{2} I_f \dot{\phi}^2", PHI_AS_THETA),
        at("Line before Eq. (1-16)")
            .statement("meyer.kinetic-energy.replaced", r"\dot{\theta}", "the rate that Eq. (1-7) replaces")
            .first_route(Evidence::CLOSED_FORM, |stated| reads_in_place_of(stated.pick("phi'", "theta'")))
            .second_route(Evidence::EXACT_IDENTITY, |stated| {
                let energy = MEYER.lookup("meyer.kinetic-energy");
                decide(stated.pick(energy.right_characters(), energy.printed), mechanism)
            })
            .corrected(r"\dot{\phi}", PHI_AS_THETA),
        at("2nd display of T before Eq. (1-16)")
            .equation(
                "meyer.kinetic-energy.substituted",
                concat!(
                    r"T = \frac{1}{2} I_D \dot{\theta}^2 + \frac{1}{2} I_f \frac{(a \cos \theta - ",
                    r"1)^2}{(1+a^2-2a \cos \theta)^2} \dot{\theta}^2"
                ),
                "kinetic energy with Eq. (1-7) substituted",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
        at("Eq. (1-16)")
            .equation(
                "meyer.eq-1-16",
                concat!(
                    r"T = \frac{1}{2} \left[I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} ",
                    r"I_f \right] \dot{\theta}^2"
                ),
                "kinetic energy in terms of the driver's speed alone",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
    ]
}

fn set_up() -> Vec<Claim> {
    vec![
        at("1st display after Eq. (1-16)")
            .equation(
                "meyer.position-rate.set-up",
                POSITION_RATE_SET_UP,
                "derivative of the kinetic energy with respect to θ, still to be worked out",
            )
            .decided(proven_of_the_energy)
            .read(Evidence::CLOSED_FORM, of_the_energy),
        at("2nd display after Eq. (1-16)")
            .equation(
                "meyer.momentum",
                concat!(
                    r"\frac{\partial T}{\partial \dot{\theta}} = \left[I_D + \frac{(a \cos \theta - ",
                    r"1)^2}{(1+a^2-2a \cos \theta)^2} I_f \right] \dot{\theta}"
                ),
                "derivative of the kinetic energy with respect to the speed",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
        at("3rd display after Eq. (1-16)")
            .equation(
                "meyer.momentum-rate.set-up",
                concat!(
                    r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \frac{d}{dt} ",
                    r"\left[\left\{ I_D + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos \theta)^2} I_f ",
                    r"\right\} \dot{\theta} \right]"
                ),
                "rate of the derivative of the kinetic energy with respect to the driver's speed, still to be worked \
                 out",
            )
            .decided(|tex| proven_of(tex, r"\frac{d}{dt}", r"\frac{\partial T}{\partial \dot{\theta}}", mechanism))
            .read(Evidence::CLOSED_FORM, |tex| {
                instants::holds_of(tex, r"\frac{d}{dt}", r"\frac{\partial T}{\partial \dot{\theta}}")
            }),
    ]
}

fn by_quotient() -> Vec<Claim> {
    vec![
        letter_b(&QUOTIENT, "4th display after Eq. (1-16), 1st line", FIRST_LINE, FIRST_LINE_RIGHT),
        at("4th display after Eq. (1-16), 2nd line")
            .equation(
                QUOTIENT[1],
                concat!(
                    r"+ \dot{\theta} \left[0 + I_f \left\{ \frac{((1+a^2-2a \cos \theta)^2 [2(a \cos ",
                    r"\theta - 1)(-a \sin \theta \dot{\theta})])}{(1+a^2-2a \cos \theta)^4} \right. ",
                    r"\right."
                ),
                "the numerator of the fraction differentiated",
            )
            .proven_in(&QUOTIENT, mechanism)
            .read_in(Evidence::CLOSED_FORM, &QUOTIENT, joined_hold),
        at("4th display after Eq. (1-16), 3rd line")
            .equation(
                QUOTIENT[2],
                concat!(
                    r"\left. \left. + \frac{(-a \cos \theta - 1)^2 (2)(1+a^2-2a \cos \theta)(2a \sin ",
                    r"\theta \dot{\theta})}{(1+a^2-2a \cos \theta)^4} \right] \right]"
                ),
                "the denominator of the fraction differentiated",
            )
            .proven_in(&QUOTIENT, mechanism)
            .read_in(Evidence::CLOSED_FORM, &QUOTIENT, joined_hold)
            .corrected(
                concat!(
                    r"\left. \left. - \frac{(a \cos \theta - 1)^2 (2)(1+a^2-2a \cos \theta)(2a \sin ",
                    r"\theta \dot{\theta})}{(1+a^2-2a \cos \theta)^4} \right\} \right]"
                ),
                miscopied(
                    "By the quotient rule, the term is subtracted. The minus sign has moved into the bracket, but the \
                     next display has it in the right place. The brackets of the line do not match either.",
                ),
            )
            .in_places(3),
    ]
}

fn by_speed() -> Vec<Claim> {
    vec![
        letter_b(&CANCELLED, "5th display after Eq. (1-16), 1st line", FIRST_LINE, FIRST_LINE_RIGHT),
        at("5th display after Eq. (1-16), 2nd line")
            .equation(
                CANCELLED[1],
                concat!(
                    r"+ I_f \dot{\theta} \left[\frac{-2(a \cos \theta - 1)(a \sin \theta ",
                    r"\dot{\theta})}{(1+a^2-2a \cos \theta)^2} - \frac{(a \cos \theta - 1)^2 (2)(2a \sin ",
                    r"\theta \dot{\theta})}{(1+a^2-2a \cos \theta)^3} \right]"
                ),
                "the part that comes from the change of the velocity ratio, with common factors cancelled",
            )
            .proven_in(&CANCELLED, mechanism)
            .read_in(Evidence::CLOSED_FORM, &CANCELLED, joined_hold),
        letter_b(&FACTORED, "6th display after Eq. (1-16), 1st line", FIRST_LINE, FIRST_LINE_RIGHT),
        at("6th display after Eq. (1-16), 2nd line")
            .equation(
                FACTORED[1],
                concat!(
                    r"- 2I_f \dot{\theta}^2 \left[\frac{a \sin \theta (a \cos \theta - 1)}{(1+a^2-2a ",
                    r"\cos \theta)^2} \left\{ 1 + \frac{2(a \cos \theta - 1)}{(1+a^2-2a \cos \theta)} ",
                    r"\right\} \right]"
                ),
                "the part that comes from the change of the velocity ratio, with its factors outside the braces",
            )
            .proven_in(&FACTORED, mechanism)
            .read_in(Evidence::CLOSED_FORM, &FACTORED, joined_hold),
        letter_b(
            &["meyer.momentum-rate"],
            "7th display after Eq. (1-16)",
            concat!(
                r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_b + ",
                r"\frac{(a \cos \theta - 1)^2 I_f}{(1+a^2-2a \cos \theta)^2} \right] \ddot{\theta} - ",
                r"2I_f \dot{\theta}^2 \left[\frac{a(a^2-1) \sin \theta (a \cos \theta - ",
                r"1)}{(1+a^2-2a \cos \theta)^3} \right]"
            ),
            concat!(
                r"\frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} \right) = \left[I_D + ",
                r"\frac{(a \cos \theta - 1)^2 I_f}{(1+a^2-2a \cos \theta)^2} \right] \ddot{\theta} - ",
                r"2I_f \dot{\theta}^2 \left[\frac{a(a^2-1) \sin \theta (a \cos \theta - ",
                r"1)}{(1+a^2-2a \cos \theta)^3} \right]"
            ),
        ),
    ]
}

fn by_angle() -> Vec<Claim> {
    vec![
        at("8th display after Eq. (1-16)")
            .equation(
                "meyer.position-rate.taken-up",
                concat!(
                    r"\frac{\partial T}{\partial \theta} = \frac{\partial}{\partial \theta} ",
                    r"\left[\frac{1}{2} \left\{ I_b + \frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos ",
                    r"\theta)^2} I_f \right\} \dot{\theta}^2 \right]"
                ),
                "the derivative with respect to θ, taken up again. The derivative does not depend on the letter I_b, \
                 but with this letter the expression in the brackets is not the kinetic energy",
            )
            .decided(proven_of_the_energy)
            .read(Evidence::CLOSED_FORM, of_the_energy)
            .corrected(POSITION_RATE_SET_UP, DRIVER_INDEX),
        by_theta(
            "meyer.position-rate.outside",
            "9th display after Eq. (1-16)",
            concat!(
                r"\frac{\partial T}{\partial \theta} = 0 + \frac{1}{2} I_f \dot{\theta}^2 ",
                r"\frac{\partial}{\partial \theta} \left[\frac{(a \cos \theta - 1)^2}{(1+a^2-2a \cos ",
                r"\theta)^2} \right]"
            ),
        ),
        by_theta(
            "meyer.position-rate.quotient",
            "10th display after Eq. (1-16)",
            concat!(
                r"\begin{aligned} \frac{\partial T}{\partial \theta} &= \frac{1}{2} I_f ",
                r"\dot{\theta}^2 \left[\frac{(1+a^2-2a \cos \theta)^2 (2)(a \cos \theta - 1)(-a \sin ",
                r"\theta)}{(1+a^2-2a \cos \theta)^4} \right. \\ &\left. - \frac{(a \cos \theta - ",
                r"1)^2 (2)(1+a^2-2a \cos \theta)(2a \sin \theta)}{(1+a^2-2a \cos \theta)^4} \right] ",
                r"\end{aligned}"
            ),
        ),
        by_theta(
            "meyer.position-rate.cancelled",
            "11th display after Eq. (1-16)",
            concat!(
                r"\frac{\partial T}{\partial \theta} = \frac{1}{2} I_f \dot{\theta}^2 ",
                r"\left[\frac{-2(a \cos \theta - 1)(a \sin \theta)}{(1+a^2-2a \cos \theta)^2} + ",
                r"\frac{-2(a \cos \theta - 1)^2 (2a \sin \theta)}{(1+a^2-2a \cos \theta)^3} \right]"
            ),
        ),
        by_theta(
            "meyer.position-rate.factored",
            "12th display after Eq. (1-16)",
            concat!(
                r"\frac{\partial T}{\partial \theta} = -I_f \dot{\theta}^2 \left[\frac{(a \cos ",
                r"\theta - 1)(a \sin \theta)}{(1+a^2-2a \cos \theta)^2} \left\{ 1 + \frac{(a \cos ",
                r"\theta - 1)(2)}{(1+a^2-2a \cos \theta)} \right\} \right]"
            ),
        ),
        by_theta(
            "meyer.position-rate",
            "13th display after Eq. (1-16)",
            concat!(
                r"\frac{\partial T}{\partial \theta} = -I_f \dot{\theta}^2 \left[\frac{a(a^2-1) \sin ",
                r"\theta (a \cos \theta - 1)}{(1+a^2-2a \cos \theta)^3} \right]"
            ),
        ),
    ]
}

/// A step of the derivative by θ.
fn by_theta(id: &'static str, locator: &'static str, printed: &'static str) -> Claim {
    at(locator)
        .equation(id, printed, "derivative of the kinetic energy with respect to θ, one step further")
        .proven_by(mechanism)
        .read(Evidence::CLOSED_FORM, holds)
}

/// The first line of a display, which has I_b for I_D.
fn letter_b(
    lines: &'static [&'static str],
    locator: &'static str,
    printed: &'static str,
    corrected: &'static str,
) -> Claim {
    at(locator)
        .equation(
            lines[0],
            printed,
            "contribution of the driver's acceleration to the rate of the derivative with respect to the speed",
        )
        .proven_in(lines, mechanism)
        .read_in(Evidence::CLOSED_FORM, lines, joined_hold)
        .corrected(corrected, DRIVER_INDEX)
}

/// Whether a display of ∂T/∂θ holds, and what it differentiates is the kinetic energy.
fn of_the_energy(tex: &str) -> Option<bool> {
    instants::holds_of(tex, BY_ANGLE, "T")
}

/// Whether a display of ∂T/∂θ is proven, and what it differentiates is the kinetic energy.
fn proven_of_the_energy(tex: &str) -> Finding {
    proven_of(tex, BY_ANGLE, "T", mechanism)
}

/// Whether Eq. (1-7) says what this rate is.
fn reads_in_place_of(rate: &str) -> Finding {
    let holds = instants().all(|letters| {
        let letter = |name: &str| letters.get(name).copied().unwrap_or(f64::NAN);
        let ratio = MEYER.printed_text("meyer.eq-1-7").rsplit_once('=');
        ratio.is_some_and(|(_, ratio)| agrees(reading::value(ratio, letters), letter(rate)))
    });
    Finding::new(
        holds,
        if holds { "Eq. (1-7), read and evaluated, gives this rate" } else { "Eq. (1-7) gives another rate" },
    )
}
