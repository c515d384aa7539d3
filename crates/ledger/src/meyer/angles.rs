//! From figure 5 to tan φ: the displays of Eqs. (1-4) to (1-6).

use super::*;
use geneva_kinematics::escapement::Form;
use geneva_kinematics::escapement::angle_proofs::AngleStep;

pub fn claims() -> Vec<Claim> {
    [lengths(), angles()].concat()
}

fn lengths() -> Vec<Claim> {
    vec![
        at("Fig. 5 and 1st display before Eq. (1-4)")
            .equation(
                "meyer.projection",
                r"r \cos \theta + R \cos \phi = c",
                "crank and slot projected on the line of centres",
            )
            .proven(AngleStep::Projection)
            .by(Vectors, || at_instants(|at| (at.crank.cos + at.radius() * libm::cos(at.angle()), at.ratio))),
        at("2nd display before Eq. (1-4)")
            .equation("meyer.cosine", r"\cos \phi = \frac{1}{R} (c - r \cos \theta)", "cosine of the follower's angle")
            .proven(AngleStep::Cosine)
            .by(Vectors, || at_instants(|at| (libm::cos(at.angle()), (at.ratio - at.crank.cos) / at.radius()))),
        at("Eq. (1-4)")
            .equation(
                "meyer.eq-1-4",
                r"\cos \phi = \frac{1}{R} (ar - r \cos \theta)",
                "cosine of the follower's angle with c = a r",
            )
            .proven(AngleStep::CosineByRatio)
            .by(Vectors, || at_instants(|at| (at.radius() * libm::cos(at.angle()), at.ratio - at.crank.cos))),
        at("Fig. 5 and 1st display before Eq. (1-5)")
            .equation("meyer.law-of-sines", r"\frac{R}{\sin \theta} = \frac{r}{\sin \phi}", "law of sines")
            .proven(AngleStep::LawOfSines)
            .by(Vectors, || at_instants(|at| (at.radius() / at.crank.sin, 1.0 / libm::sin(at.angle())))),
        at("Eq. (1-5)")
            .equation(
                "meyer.eq-1-5",
                r"R = \frac{r \sin \theta}{\sin \phi}",
                "distance of the pin from the follower's axis",
            )
            .proven(AngleStep::SlotRadius)
            .by(Vectors, || at_instants(|at| (at.radius(), at.crank.sin / libm::sin(at.angle())))),
    ]
}

fn angles() -> Vec<Claim> {
    vec![
        at("Display after Eq. (1-5)")
            .equation(
                "meyer.cosine-substituted",
                r"\cos \phi = \frac{r \sin \theta}{r \sin \theta} (a - \cos \theta)",
                "the cosine without the pin's distance",
            )
            .proven(AngleStep::CosineSubstituted(Form::Printed))
            .corrected_form(|| prove(&AngleStep::CosineSubstituted(Form::Corrected)).into())
            .by(Vectors, || {
                at_instants(|at| {
                    let sine = libm::sin(at.angle());
                    (libm::cos(at.angle()), sine / at.crank.sin * (at.ratio - at.crank.cos))
                })
            })
            .corrected(r"\cos \phi = \frac{r \sin \phi}{r \sin \theta} (a - \cos \theta)", slips::PHI_AS_THETA),
        at("Display before Eq. (1-6)")
            .equation(
                "meyer.cotangent",
                r"\frac{\cos \phi}{\sin \phi} = \frac{a - \cos \theta}{\sin \theta} = \frac{1}{\tan \phi}",
                "cotangent of the follower's angle",
            )
            .by(ExactIdentity, || all_proven(&[AngleStep::Cotangent, AngleStep::InverseTangent]))
            .by(Vectors, || at_instants(|at| (1.0 / libm::tan(at.angle()), (at.ratio - at.crank.cos) / at.crank.sin))),
        at("Eq. (1-6)")
            .equation(
                "meyer.eq-1-6",
                r"\tan \phi = \frac{\sin \theta}{a - \cos \theta}",
                "tangent of the follower's angle",
            )
            .proven(AngleStep::Tangent)
            .by(Vectors, || at_instants(|at| (libm::tan(at.angle()), at.crank.sin / (at.ratio - at.crank.cos)))),
    ]
}
