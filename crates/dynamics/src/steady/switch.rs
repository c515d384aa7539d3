//! Where the friction changes its sign.
//!
//! The sign is that of A C u + D (E − B u) = μ k (i ρ' u + ρ E). Before the line of centres k < 0 < ρ', so it is minus
//! all the way. From the line of centres on k > 0 > ρ', and it is plus while u < Q with Q = ρ/(i k (1 + 2 ρ)), u over E.
//! Q falls from +∞ to zero at the exit ([`SwitchFalls`](super::proofs::SwitchFalls)). Where u = Q the follower turns
//! without force, φ'' = 0, so that ρ θ' is level there and u grows as ρ falls. So there is exactly one switch, and past
//! the exit, where ρ < 0, the sign stays minus.

use super::engagement::Engagement;
use super::rule::Row;

/// A step of Newton's method, over the stretch, from which on u is taken on points of its own.
pub(super) const COARSE: f64 = 1e-6;

/// A step after which no other is needed.
pub(super) const FINE: f64 = 1e-6;

/// Most steps, halvings included.
pub(super) const STEPS: u32 = 100;

/// Where the sign of the friction goes from plus to minus.
#[derive(Clone, Copy, Debug)]
pub(super) struct Switch {
    /// Number of the stretch.
    pub panel: usize,
    /// w.
    pub at: f64,
    /// u there.
    pub square: f64,
}

impl Engagement {
    /// ρ − i k (1 + 2 ρ) u, positive before the switch.
    pub(super) fn excess(&self, w: f64, square: f64) -> f64 {
        let place = self.circle.place(w);
        place.lead - self.inertia * place.slide * place.turning() * square
    }

    /// The switch in a stretch, with u there from what the stretch's points count, and better from w.
    ///
    /// Both must have the slope of the equation of motion at the switch; they need not have it elsewhere.
    pub(super) fn switch_within(
        &self,
        panel: usize,
        coarse: impl Fn(&Row) -> f64,
        fine: impl Fn(f64) -> f64,
    ) -> Switch {
        let points = &self.panels[panel].points;
        let (mut low, mut high) = (points.low, points.high);
        let width = high - low;
        // Newton's method, kept between the ends: a step that leaves them is replaced by a halving.
        let (mut w, mut refining) = (low + width / 2.0, false);
        for _ in 0..STEPS {
            let square = if refining { fine(w) } else { coarse(&points.shares(self.rule, w)) };
            let (excess, slope, growth) = self.excess_with_slopes(w, square);
            let next = w - excess / slope;
            let moved = next - w;
            if refining && libm::fabs(moved) <= FINE * width {
                // What is left is of the order of the square of this step.
                return Switch { panel, at: next.clamp(points.low, points.high), square: square + growth * moved };
            }
            if !refining {
                *(if excess > 0.0 { &mut low } else { &mut high }) = w;
            }
            let inside = next >= low && next <= high;
            refining |= inside && libm::fabs(moved) <= COARSE * width;
            w = if inside || refining { next.clamp(points.low, points.high) } else { low + (high - low) / 2.0 };
        }
        Switch { panel, at: w, square: fine(w) }
    }

    /// The excess, its slope by w, and that of u, which is du/dw at the switch.
    fn excess_with_slopes(&self, w: f64, square: f64) -> (f64, f64, f64) {
        let place = self.circle.place(w);
        let (lead, slide, turning) = (place.lead, place.slide, place.turning());
        // Where the bars have the plus sign; at the switch either sign gives the same.
        let both = lead + self.friction * slide;
        let growth = (2.0 / turning + 2.0 * both * slide * square) / (self.inertia + lead * both);
        let change = ((lead - self.circle.centre) * turning - 2.0 * slide * slide) * square + slide * turning * growth;
        let excess = lead - self.inertia * slide * turning * square;
        (excess, (-slide - self.inertia * change) * place.stretch, growth * place.stretch)
    }
}
