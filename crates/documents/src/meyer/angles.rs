//! From figure 5 to tan φ: the displays of Eqs. (1-4) to (1-6).

use super::letters::TRIANGLE;
use super::*;

pub(super) fn claims() -> Vec<Claim> {
    [lengths(), angles()].concat()
}

fn lengths() -> Vec<Claim> {
    vec![
        at("Fig. 5").lost_drawing(
            "meyer.fig-5",
            "Figure 5",
            "the angles of driver and follower between entry and exit",
        ),
        at("Fig. 5 and 1st display before Eq. (1-4)")
            .equation(
                "meyer.projection",
                r"r \cos \theta + R \cos \phi = c",
                "crank and slot projected on the line of centres",
            )
            .in_letters(TRIANGLE),
        at("2nd display before Eq. (1-4)")
            .equation("meyer.cosine", r"\cos \phi = \frac{1}{R} (c - r \cos \theta)", "cosine of the follower's angle")
            .in_letters(TRIANGLE),
        at("Eq. (1-4)")
            .equation(
                "meyer.eq-1-4",
                r"\cos \phi = \frac{1}{R} (ar - r \cos \theta)",
                "cosine of the follower's angle with c = a r",
            )
            .in_letters(TRIANGLE),
        at("Fig. 5 and 1st display before Eq. (1-5)")
            .equation("meyer.law-of-sines", r"\frac{R}{\sin \theta} = \frac{r}{\sin \phi}", "law of sines")
            .in_letters(TRIANGLE),
        at("Eq. (1-5)")
            .equation(
                "meyer.eq-1-5",
                r"R = \frac{r \sin \theta}{\sin \phi}",
                "distance of the pin from the follower's axis",
            )
            .in_letters(TRIANGLE),
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
            .in_letters(TRIANGLE)
            .corrected(r"\cos \phi = \frac{r \sin \phi}{r \sin \theta} (a - \cos \theta)", slips::PHI_AS_THETA),
        at("Display before Eq. (1-6)")
            .equation(
                "meyer.cotangent",
                r"\frac{\cos \phi}{\sin \phi} = \frac{a - \cos \theta}{\sin \theta} = \frac{1}{\tan \phi}",
                "cotangent of the follower's angle",
            )
            .in_letters(TRIANGLE),
        at("Eq. (1-6)")
            .equation(
                "meyer.eq-1-6",
                r"\tan \phi = \frac{\sin \theta}{a - \cos \theta}",
                "tangent of the follower's angle",
            )
            .in_letters(TRIANGLE),
    ]
}
