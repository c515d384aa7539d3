//! From tan φ to velocity and acceleration of the follower: the displays of Eqs. (1-7) and (1-8).
//!
//! The proof differentiates the pin's place as a power series. The second route takes the follower's rates from the pin's
//! velocity and acceleration across the slot, which are those of a point on a circle.

use super::letters::RATES;
use super::*;

// Displays too long for a line.
const QUOTIENT_RULE: &str = concat!(
    r"\frac{d}{dt}(\tan \phi) = \frac{(a - \cos \theta) \frac{d}{dt}(\sin \theta) - \sin ",
    r"\theta \frac{d}{dt}(a - \cos \theta)}{(a - \cos \theta)^2}"
);
const SECANT_SQUARED: &str = concat!(
    r"(\sec^2 \phi) \dot{\phi} = \frac{(a - \cos \theta)(\cos \theta) \dot{\theta} - ",
    r"\sin \theta (\sin \theta) \dot{\theta}}{(a - \cos \theta)^2}"
);
const TANGENT_SUBSTITUTED: &str = concat!(
    r"\left(1 + \frac{\sin^2 \theta}{(a - \cos \theta)^2}\right) \dot{\phi} = \frac{a ",
    r"\cos \theta - 1}{(a - \cos \theta)^2} \dot{\theta}"
);
const ACCELERATION_BY_QUOTIENT: &str = concat!(
    r"\ddot{\phi} = \left[\frac{(1 + a^2 - 2a \cos \theta) \frac{d}{dt}(a \cos \theta - ",
    r"1) - (a \cos \theta - 1) \frac{d}{dt}(1 + a^2 - 2a \cos \theta)}{(1 + a^2 - 2a ",
    r"\cos \theta)^2} \right] \dot{\theta} \ldots + \left(\frac{a \cos \theta - 1}{1 + ",
    r"a^2 - 2a \cos \theta}\right) \ddot{\theta}"
);
const DIFFERENTIATED: &str = concat!(
    r"\ddot{\theta} = \left[\frac{(1+a^2 - 2a\cos\theta)(-a\sin\theta)\dot{\theta} - ",
    r"(a\cos\theta - 1)(2a\sin\theta)\dot{\theta}}{(1+a^2 - 2a\cos\theta)^2} \right] ",
    r"\dot{\theta} + \frac{a\cos\theta - 1}{(1+a^2 - 2a\cos\theta)} \ddot{\theta}"
);
const DIFFERENTIATED_CORRECTED: &str = concat!(
    r"\ddot{\phi} = \left[\frac{(1+a^2 - 2a\cos\theta)(-a\sin\theta)\dot{\theta} - ",
    r"(a\cos\theta - 1)(2a\sin\theta)\dot{\theta}}{(1+a^2 - 2a\cos\theta)^2} \right] ",
    r"\dot{\theta} + \frac{a\cos\theta - 1}{(1+a^2 - 2a\cos\theta)} \ddot{\theta}"
);
const ACCELERATION: &str = concat!(
    r"\ddot{\theta} = \frac{a\sin\theta(1-a^2)}{(1+a^2 - 2a\cos\theta)^2} \dot{\theta}^2 ",
    r"+ \frac{a\cos\theta - 1}{(1+a^2 - 2a\cos\theta)} \ddot{\theta}"
);
const ACCELERATION_CORRECTED: &str = concat!(
    r"\ddot{\phi} = \frac{a\sin\theta(1-a^2)}{(1+a^2 - 2a\cos\theta)^2} \dot{\theta}^2 + ",
    r"\frac{a\cos\theta - 1}{(1+a^2 - 2a\cos\theta)} \ddot{\theta}"
);

pub(super) fn claims() -> Vec<Claim> {
    [velocity(), acceleration()].concat()
}

fn velocity() -> Vec<Claim> {
    vec![
        step(
            "meyer.quotient-rule",
            "1st display after Eq. (1-6)",
            "Eq. (1-6) differentiated by the rule for quotients",
            QUOTIENT_RULE,
        ),
        step("meyer.secant-squared", "2nd display after Eq. (1-6)", "both sides differentiated", SECANT_SQUARED),
        step(
            "meyer.one-and-tangent-squared",
            "3rd display after Eq. (1-6)",
            "derivatives of both sides, with the square of the tangent",
            concat!(r"(1 + \tan^2 \phi) \dot{\phi} = \frac{a \cos \theta - 1}{(a - \cos \theta)^2} ", r"\dot{\theta}"),
        ),
        step(
            "meyer.tangent-substituted",
            "4th display after Eq. (1-6)",
            "derivatives of both sides, with the tangent of Eq. (1-6)",
            TANGENT_SUBSTITUTED,
        ),
        step(
            "meyer.eq-1-7",
            "Eq. (1-7)",
            "angular velocity of the follower",
            concat!(r"\dot{\phi} = \left(\frac{a \cos \theta - 1}{1 + a^2 - 2a \cos \theta}\right) ", r"\dot{\theta}"),
        ),
    ]
}

fn acceleration() -> Vec<Claim> {
    vec![
        step(
            "meyer.acceleration-by-quotient",
            "1st display after Eq. (1-7)",
            "Eq. (1-7) differentiated by the rule for quotients, where the dots are the break between two lines",
            ACCELERATION_BY_QUOTIENT,
        ),
        step(
            "meyer.acceleration-differentiated",
            "2nd display after Eq. (1-7)",
            "the derivatives carried out",
            DIFFERENTIATED,
        )
        .corrected(DIFFERENTIATED_CORRECTED, slips::PHI_AS_THETA),
        step("meyer.eq-1-8", "Eq. (1-8)", "angular acceleration of the follower", ACCELERATION)
            .corrected(ACCELERATION_CORRECTED, slips::PHI_AS_THETA),
    ]
}

/// A line of the derivation: its characters, with the break between two lines for a space.
fn step(id: &'static str, locator: &'static str, meaning: &'static str, printed: &'static str) -> Claim {
    at(locator).equation(id, printed, meaning).rewritten_and_proven(RATES, |tex| tex.replace(r"\ldots", " "))
}
