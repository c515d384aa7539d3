//! A hypothesis in words.

use super::*;

impl Hypothesis {
    /// The hypothesis in one short line of a figure: reset angle, inertias and reading, then what differs from the
    /// usual.
    pub fn brief_words(&self) -> String {
        let reset = match self.reset {
            Reset::OfTheMechanism => "reset after 360°/m",
            Reset::QuarterTurn => "reset after 90°",
        };
        let inertias = match self.six_pin {
            SixPin::AsHeaded => "inertias as headed",
            SixPin::AsDrawn => "as in Fig. 11",
        };
        let reading = match self.reading {
            Reading::True => "true peaks",
            Reading::OnTheGrid => "printed peaks",
        };
        let constants = (self.constants == Constants::AsListed).then_some("listed π");
        let sign = self.delay.map(|_| "lagged sign");
        let parts: Vec<_> = [reset, inertias, reading].into_iter().chain(constants).chain(sign).collect();
        parts.join(", ")
    }
}
