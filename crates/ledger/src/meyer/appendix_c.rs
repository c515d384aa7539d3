//! Appendix C: the spring that drives the escapement, figure 15.

use super::*;

pub fn claims() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "meyer.app-c.turns",
            "Appendix C, last sentence but one",
            "the greatest number of turns that the spring motor gives",
            "as many as fifty turns",
            Check::Missing {
                reason: "Length and thickness of the strip and the radii of its spools are not \
                    given",
            },
        )
        .expecting(Verdict::NotReproducible),
        Claim::figure(
            WORK,
            "meyer.fig-15",
            "Fig. 15, caption",
            "a schematic drawing of the spring motor",
            "Neg'ator B Motor",
            Check::Missing { reason: "The drawing is not in the copy, and the text gives no size of the motor" },
        )
        .expecting(Verdict::NotReproducible),
    ]
}
