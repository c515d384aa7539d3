//! The equation of motion put together, and its five factors: Eqs. (1-17) to (1-19).

use super::instants::{holds, joined_hold, miscopied};
use super::letters::mechanism;
use super::slips::{ARC, LOST_BARS, MISSING_SQUARE};
use super::*;

// Displays that are cut into lines.
const PARTS_PUT_IN: [&str; 2] = ["meyer.parts-put-in.first-line", "meyer.parts-put-in.second-line"];
const EQUATION_OF_MOTION: [&str; 2] = ["meyer.eq-1-18.first-line", "meyer.eq-1-18.second-line"];

pub(super) fn claims() -> Vec<Claim> {
    [left_side(), together(), factors()].concat()
}

fn left_side() -> Vec<Claim> {
    vec![
        at("Eq. (1-17), 1st and 2nd line")
            .equation(
                "meyer.left-side",
                concat!(
                    r"\begin{aligned} \frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} ",
                    r"\right) - \frac{\partial T}{\partial \theta} &= \left[I_D + \frac{(a \cos \theta - ",
                    r"1)^2 I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] \ddot{\theta} - 2I_f ",
                    r"\dot{\theta}^2 \left\{ \frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 ",
                    r"- 2a \cos \theta)^3} \right\} \\ &\quad - \left[-I_f \dot{\theta}^2 \left\{ ",
                    r"\frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos \theta)^3} ",
                    r"\right\} \right] \end{aligned}"
                ),
                "one derivative of the kinetic energy minus the other",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
        at("Eq. (1-17), 3rd and 4th line")
            .equation(
                "meyer.eq-1-17",
                concat!(
                    r"\begin{aligned} \frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} ",
                    r"\right) - \frac{\partial T}{\partial \theta} &= \left[I_D + \frac{(a \cos \theta - ",
                    r"1) I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] \ddot{\theta} \\ &\quad - I_f ",
                    r"\dot{\theta}^2 \left[\frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - ",
                    r"2a \cos \theta)^3} \right] \end{aligned}"
                ),
                "the difference of the two derivatives, with its terms collected",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds)
            .corrected(
                concat!(
                    r"\begin{aligned} \frac{d}{dt} \left(\frac{\partial T}{\partial \dot{\theta}} ",
                    r"\right) - \frac{\partial T}{\partial \theta} &= \left[I_D + \frac{(a \cos \theta - ",
                    r"1)^2 I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] \ddot{\theta} \\ &\quad - I_f ",
                    r"\dot{\theta}^2 \left[\frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - ",
                    r"2a \cos \theta)^3} \right] \end{aligned}"
                ),
                MISSING_SQUARE,
            ),
    ]
}

fn together() -> Vec<Claim> {
    vec![
        at("Display before Eq. (1-18), 1st line")
            .equation(
                PARTS_PUT_IN[0],
                concat!(
                    r"\left[I_D + \frac{(a \cos \theta - 1) I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] ",
                    r"\ddot{\theta} - \left[\frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - ",
                    r"2a \cos \theta)^3} \right] I_f \dot{\theta}^2"
                ),
                "left side of the equation of motion",
            )
            .proven_in(&PARTS_PUT_IN, mechanism)
            .read_in(Evidence::CLOSED_FORM, &PARTS_PUT_IN, joined_hold)
            .corrected(
                concat!(
                    r"\left[I_D + \frac{(a \cos \theta - 1)^2 I_f}{(1 + a^2 - 2a \cos \theta)^2} \right] ",
                    r"\ddot{\theta} - \left[\frac{a(a^2 - 1) \sin \theta (a \cos \theta - 1)}{(1 + a^2 - ",
                    r"2a \cos \theta)^3} \right] I_f \dot{\theta}^2"
                ),
                MISSING_SQUARE,
            ),
        at("Display before Eq. (1-18), 2nd line")
            .equation(
                PARTS_PUT_IN[1],
                concat!(
                    r"= K - a \mu I_f \left[\frac{a \sin^2 \theta (1 - a^2) \dot{\theta}^2}{(1 + a^2 - ",
                    r"2a \cos \theta)^3} + \frac{\sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos ",
                    r"\theta)^2} \ddot{\theta} \right]"
                ),
                "right side of the equation of motion",
            )
            .proven_in(&PARTS_PUT_IN, mechanism)
            .read_in(Evidence::CLOSED_FORM, &PARTS_PUT_IN, joined_hold)
            .corrected(
                concat!(
                    r"= K - a \mu I_f \left| \frac{a \sin^2 \theta (1 - a^2) \dot{\theta}^2}{(1 + a^2 - ",
                    r"2a \cos \theta)^3} + \frac{\sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos ",
                    r"\theta)^2} \ddot{\theta} \right|"
                ),
                LOST_BARS,
            )
            .in_places(2),
        at("Eq. (1-18), 1st line")
            .equation(
                EQUATION_OF_MOTION[0],
                concat!(
                    r"\left[\frac{I_D}{I_f} + \frac{(a \cos \theta - 1)^2}{(1 + a^2 - 2a \cos \theta)^2} ",
                    r"\right] \ddot{\theta} + \left[\frac{a(1 - a^2) \sin \theta (a \cos \theta - 1)}{(1 ",
                    r"+ a^2 - 2a \cos \theta)^3} \right] \dot{\theta}^2"
                ),
                "equation of motion divided by the follower's inertia, without friction",
            )
            .proven_in(&EQUATION_OF_MOTION, mechanism)
            .read_in(Evidence::CLOSED_FORM, &EQUATION_OF_MOTION, joined_hold),
        at("Eq. (1-18), 2nd line")
            .equation(
                EQUATION_OF_MOTION[1],
                concat!(
                    r"+ a \mu \left[\frac{a \sin^2 \theta (1 - a^2)}{(1 + a^2 - 2a \cos \theta)^3} ",
                    r"\dot{\theta}^2 + \frac{\sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos ",
                    r"\theta)^2} \ddot{\theta} \right] = \frac{K}{I_f}"
                ),
                "the friction and the drive in the equation of motion",
            )
            .proven_in(&EQUATION_OF_MOTION, mechanism)
            .read_in(Evidence::CLOSED_FORM, &EQUATION_OF_MOTION, joined_hold)
            .corrected(
                concat!(
                    r"+ a \mu \left| \frac{a \sin^2 \theta (1 - a^2)}{(1 + a^2 - 2a \cos \theta)^3} ",
                    r"\dot{\theta}^2 + \frac{\sin \theta (a \cos \theta - 1)}{(1 + a^2 - 2a \cos ",
                    r"\theta)^2} \ddot{\theta} \right| = \frac{K}{I_f}"
                ),
                LOST_BARS,
            )
            .in_places(2),
    ]
}

fn factors() -> Vec<Claim> {
    vec![
        at("1st substitution before Eq. (1-19)")
            .equation(
                "meyer.factor-a",
                concat!(
                    r"A = \left[ \frac{I_f}{I_f} + ",
                    r"\frac{(\text{acos}\theta-1)^2}{(1+a^2-2\text{acos}\theta)^2} \right]"
                ),
                "A, the factor of the driver's acceleration",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds)
            .corrected(
                r"A = \left[ \frac{I_D}{I_f} + \frac{(a\cos\theta-1)^2}{(1+a^2-2a\cos\theta)^2} \right]",
                miscopied(
                    "Eq. (1-18), from which the display is taken, has the inertia of the driver above the line, and \
                     so does the program. The letters of a and cos run together here, as they do in the next three \
                     displays.",
                ),
            )
            .in_places(5),
        arc(
            "meyer.factor-b",
            "2nd substitution before Eq. (1-19)",
            "B, the factor of the square of the speed",
            concat!(
                r"B = \left[ ",
                r"\frac{a(1-a^2)\sin\theta(\text{acos}\theta-1)}{(1+a^2-2\text{acos}\theta)^3} ",
                r"\right]"
            ),
            r"B = \left[ \frac{a(1-a^2)\sin\theta(a\cos\theta-1)}{(1+a^2-2a\cos\theta)^3} \right]",
        )
        .in_places(4),
        arc(
            "meyer.factor-c",
            "3rd substitution before Eq. (1-19)",
            "C, the factor of the square of the speed between the bars",
            r"C = \left[ \mu \frac{a^2 \sin^2 \theta (1-a^2)}{(1+a^2-2\text{acos}\theta)^3} \right]",
            r"C = \left[ \mu \frac{a^2 \sin^2 \theta (1-a^2)}{(1+a^2-2a\cos\theta)^3} \right]",
        )
        .in_places(2),
        arc(
            "meyer.factor-d",
            "4th substitution before Eq. (1-19)",
            "D, the factor of the acceleration between the bars",
            concat!(
                r"D = \left[ \mu \frac{a \sin \theta ",
                r"(\text{acos}\theta-1)}{(1+a^2-2\text{acos}\theta)^2} \right]"
            ),
            r"D = \left[ \mu \frac{a \sin \theta (a\cos\theta-1)}{(1+a^2-2a\cos\theta)^2} \right]",
        )
        .in_places(4),
        at("5th substitution before Eq. (1-19)")
            .equation("meyer.factor-e", r"E = \frac{K}{I_f}", "E, the driving term")
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
        at("Eq. (1-19)")
            .equation(
                "meyer.eq-1-19",
                r"A\ddot{\theta} + B\dot{\theta}^2 + |C\dot{\theta}^2 + D\ddot{\theta}| = E",
                "equation of motion with the five factors",
            )
            .proven_by(mechanism)
            .read(Evidence::CLOSED_FORM, holds),
    ]
}

/// A factor in which nothing is wrong but the inverse cosine.
fn arc(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    corrected: &'static str,
) -> Claim {
    at(locator)
        .equation(id, printed, meaning)
        .proven_by(mechanism)
        .read(Evidence::CLOSED_FORM, holds)
        .corrected(corrected, ARC)
}
