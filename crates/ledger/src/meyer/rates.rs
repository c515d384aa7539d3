//! From tan φ to velocity and acceleration of the follower: the displays of Eqs. (1-7) and (1-8).
//!
//! The second route knows no derivative: it reads the follower's rates off the pin's velocity and acceleration across
//! the slot, which are those of a point on a circle.

use super::*;
use geneva_kinematics::escapement::Form;
use geneva_kinematics::escapement::rate_proofs::{AccelerationStep, VelocityStep};

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

pub fn claims() -> Vec<Claim> {
    [velocity(), acceleration()].concat()
}

fn velocity() -> Vec<Claim> {
    let step = |id, locator, meaning, printed, proof: fn() -> Finding, witness: fn() -> Finding| {
        at(locator).equation(id, printed, meaning).by(ExactIdentity, proof).by(Vectors, witness)
    };
    vec![
        step(
            "meyer.quotient-rule",
            "1st display after Eq. (1-6)",
            "Eq. (1-6) differentiated by the rule for quotients",
            QUOTIENT_RULE,
            || prove(&VelocityStep::QuotientRule).into(),
            || at_instants(|at| (tangent_rate(at), tangent_rate_by_quotient(at))),
        ),
        step(
            "meyer.secant-squared",
            "2nd display after Eq. (1-6)",
            "both sides differentiated",
            SECANT_SQUARED,
            || prove(&VelocityStep::SecantSquared).into(),
            || at_instants(|at| (tangent_rate(at), tangent_rate_by_quotient(at))),
        ),
        step(
            "meyer.one-and-tangent-squared",
            "3rd display after Eq. (1-6)",
            "derivatives of both sides, with the square of the tangent",
            concat!(r"(1 + \tan^2 \phi) \dot{\phi} = \frac{a \cos \theta - 1}{(a - \cos \theta)^2} ", r"\dot{\theta}"),
            || prove(&VelocityStep::OneAndTangentSquared).into(),
            || {
                at_instants(|at| {
                    let tangent = libm::tan(at.angle());
                    ((1.0 + tangent * tangent) * at.turning(), lead(at) / square(rest(at)) * DRIVER.0)
                })
            },
        ),
        step(
            "meyer.tangent-substituted",
            "4th display after Eq. (1-6)",
            "derivatives of both sides, with the tangent of Eq. (1-6)",
            TANGENT_SUBSTITUTED,
            || prove(&VelocityStep::TangentSubstituted).into(),
            || {
                at_instants(|at| {
                    let tangent_squared = square(at.crank.sin) / square(rest(at));
                    ((1.0 + tangent_squared) * at.turning(), lead(at) / square(rest(at)) * DRIVER.0)
                })
            },
        ),
        step(
            "meyer.eq-1-7",
            "Eq. (1-7)",
            "angular velocity of the follower",
            concat!(r"\dot{\phi} = \left(\frac{a \cos \theta - 1}{1 + a^2 - 2a \cos \theta}\right) ", r"\dot{\theta}"),
            || prove(&VelocityStep::Velocity).into(),
            || at_instants(|at| (at.turning(), lead(at) / under(at) * DRIVER.0)),
        ),
    ]
}

fn acceleration() -> Vec<Claim> {
    vec![
        at("1st display after Eq. (1-7)")
            .equation(
                "meyer.acceleration-by-quotient",
                ACCELERATION_BY_QUOTIENT,
                "Eq. (1-7) differentiated by the rule for quotients, where the dots are the break between two lines",
            )
            .proven(AccelerationStep::QuotientRule)
            .by(Vectors, || at_instants(|at| (at.turning_rate(), acceleration_by_quotient(at)))),
        at("2nd display after Eq. (1-7)")
            .equation("meyer.acceleration-differentiated", DIFFERENTIATED, "the derivatives carried out")
            .proven(AccelerationStep::Differentiated(Form::Printed))
            .corrected_form(|| prove(&AccelerationStep::Differentiated(Form::Corrected)).into())
            .by(Vectors, || at_instants(|at| (at.turning_rate(), acceleration_by_quotient(at))))
            .corrected(DIFFERENTIATED_CORRECTED, slips::PHI_AS_THETA),
        at("Eq. (1-8)")
            .equation("meyer.eq-1-8", ACCELERATION, "angular acceleration of the follower")
            .proven(AccelerationStep::Acceleration(Form::Printed))
            .corrected_form(|| prove(&AccelerationStep::Acceleration(Form::Corrected)).into())
            .by(Vectors, || {
                at_instants(|at| {
                    let shape = at.ratio * at.crank.sin * (1.0 - square(at.ratio)) / square(under(at));
                    (at.turning_rate(), shape * square(DRIVER.0) + lead(at) / under(at) * DRIVER.1)
                })
            })
            .corrected(ACCELERATION_CORRECTED, slips::PHI_AS_THETA),
    ]
}

fn square(x: f64) -> f64 {
    x * x
}

/// a − cos θ.
fn rest(at: &PinKinematics) -> f64 {
    at.ratio - at.crank.cos
}

/// a cos θ − 1.
fn lead(at: &PinKinematics) -> f64 {
    at.ratio * at.crank.cos - 1.0
}

/// 1 + a² − 2 a cos θ.
fn under(at: &PinKinematics) -> f64 {
    1.0 + square(at.ratio) - 2.0 * at.ratio * at.crank.cos
}

/// The rate of tan φ from the follower's measured angle and rate.
fn tangent_rate(at: &PinKinematics) -> f64 {
    at.turning() / square(libm::cos(at.angle()))
}

/// The rate of tan φ as printed, with the derivatives of sine and cosine put in.
fn tangent_rate_by_quotient(at: &PinKinematics) -> f64 {
    let above = rest(at) * at.crank.cos * DRIVER.0 - at.crank.sin * at.crank.sin * DRIVER.0;
    above / square(rest(at))
}

/// φ̈ as printed, with the derivatives of the cosine put in.
fn acceleration_by_quotient(at: &PinKinematics) -> f64 {
    let product = at.ratio * at.crank.sin * DRIVER.0;
    let above = under(at) * -product - lead(at) * 2.0 * product;
    above / square(under(at)) * DRIVER.0 + lead(at) / under(at) * DRIVER.1
}
