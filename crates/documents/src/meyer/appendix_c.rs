//! Appendix C: the spring that drives the escapement, figure 15.

use super::*;

pub(super) fn claims() -> Vec<Claim> {
    vec![
        at("Appendix C, last sentence but one")
            .statement(
                "meyer.app-c.turns",
                "as many as fifty turns",
                "the greatest number of turns that the spring motor gives",
            )
            .missing("The thesis does not give the length and thickness of the strip or the radii of its spools"),
        at("Fig. 15, caption")
            .figure("meyer.fig-15", "Neg'ator B Motor", "a schematic drawing of the spring motor")
            .missing("The copy we had does not contain the drawing, and the text gives no size of the motor"),
    ]
}
