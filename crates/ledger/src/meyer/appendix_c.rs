//! Appendix C: the spring that drives the escapement, figure 15.

use super::*;

pub fn claims() -> Vec<Claim> {
    vec![
        at("Appendix C, last sentence but one")
            .statement(
                "meyer.app-c.turns",
                "as many as fifty turns",
                "the greatest number of turns that the spring motor gives",
            )
            .missing("Length and thickness of the strip and the radii of its spools are not given"),
        at("Fig. 15, caption")
            .figure("meyer.fig-15", "Neg'ator B Motor", "a schematic drawing of the spring motor")
            .missing("The drawing is not in the copy, and the text gives no size of the motor"),
    ]
}
