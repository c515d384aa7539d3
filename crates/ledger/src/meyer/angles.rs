//! From figure 5 to tan φ: the displays of Eqs. (1-4) to (1-6).

use super::*;
use geneva_kinematics::escapement::Form;
use geneva_kinematics::escapement::angle_proofs::AngleStep;

pub fn claims() -> Vec<Claim> {
    [lengths(), angles()].concat()
}

fn lengths() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "meyer.projection",
            "Fig. 5 and 1st display before Eq. (1-4)",
            "crank and slot projected on the line of centres",
            r"r \cos \theta + R \cos \phi = c",
            Check::equation(
                (ExactIdentity, || prove(&AngleStep::Projection).into()),
                (Vectors, || at_instants(|at| (at.crank.cos + at.radius() * libm::cos(at.angle()), at.ratio))),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.cosine",
            "2nd display before Eq. (1-4)",
            "cosine of the follower's angle",
            r"\cos \phi = \frac{1}{R} (c - r \cos \theta)",
            Check::equation(
                (ExactIdentity, || prove(&AngleStep::Cosine).into()),
                (Vectors, || at_instants(|at| (libm::cos(at.angle()), (at.ratio - at.crank.cos) / at.radius()))),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.eq-1-4",
            "Eq. (1-4)",
            "the same with c = a r",
            r"\cos \phi = \frac{1}{R} (ar - r \cos \theta)",
            Check::equation(
                (ExactIdentity, || prove(&AngleStep::CosineByRatio).into()),
                (Vectors, || at_instants(|at| (at.radius() * libm::cos(at.angle()), at.ratio - at.crank.cos))),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.law-of-sines",
            "Fig. 5 and 1st display before Eq. (1-5)",
            "law of sines",
            r"\frac{R}{\sin \theta} = \frac{r}{\sin \phi}",
            Check::equation(
                (ExactIdentity, || prove(&AngleStep::LawOfSines).into()),
                (Vectors, || at_instants(|at| (at.radius() / at.crank.sin, 1.0 / libm::sin(at.angle())))),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.eq-1-5",
            "Eq. (1-5)",
            "distance of the pin from the follower's axis",
            r"R = \frac{r \sin \theta}{\sin \phi}",
            Check::equation(
                (ExactIdentity, || prove(&AngleStep::SlotRadius).into()),
                (Vectors, || at_instants(|at| (at.radius(), at.crank.sin / libm::sin(at.angle())))),
            ),
        ),
    ]
}

fn angles() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "meyer.cosine-substituted",
            "Display after Eq. (1-5)",
            "the cosine without the pin's distance",
            r"\cos \phi = \frac{r \sin \theta}{r \sin \theta} (a - \cos \theta)",
            Check::corrected_equation(
                (ExactIdentity, || prove(&AngleStep::CosineSubstituted(Form::Printed)).into()),
                || prove(&AngleStep::CosineSubstituted(Form::Corrected)).into(),
                (Vectors, || {
                    at_instants(|at| {
                        let sine = libm::sin(at.angle());
                        (libm::cos(at.angle()), sine / at.crank.sin * (at.ratio - at.crank.cos))
                    })
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: r"\cos \phi = \frac{r \sin \phi}{r \sin \theta} (a - \cos \theta)",
            slip: slips::PHI_AS_THETA,
        }),
        Claim::equation(
            WORK,
            "meyer.cotangent",
            "Display before Eq. (1-6)",
            "cotangent of the follower's angle",
            r"\frac{\cos \phi}{\sin \phi} = \frac{a - \cos \theta}{\sin \theta} = \frac{1}{\tan \phi}",
            Check::equation(
                (ExactIdentity, || all_proven(&[AngleStep::Cotangent, AngleStep::InverseTangent])),
                (Vectors, || at_instants(|at| (1.0 / libm::tan(at.angle()), (at.ratio - at.crank.cos) / at.crank.sin))),
            ),
        ),
        Claim::equation(
            WORK,
            "meyer.eq-1-6",
            "Eq. (1-6)",
            "tangent of the follower's angle",
            r"\tan \phi = \frac{\sin \theta}{a - \cos \theta}",
            Check::equation(
                (ExactIdentity, || prove(&AngleStep::Tangent).into()),
                (Vectors, || at_instants(|at| (libm::tan(at.angle()), at.crank.sin / (at.ratio - at.crank.cos)))),
            ),
        ),
    ]
}
