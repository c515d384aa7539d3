//! A hypothesis in words.

use super::*;

impl Hypothesis {
    /// At the head of a table's row.
    pub fn words(&self) -> String {
        self.parts(|[words, _]| words).join("; ")
    }

    /// In one short line of a figure.
    pub fn brief_words(&self) -> String {
        self.parts(|[_, brief]| brief).join(", ")
    }

    /// Reset angle, inertias and reading, then what differs from the usual: each in words, and briefly.
    fn parts(&self, which: fn([&'static str; 2]) -> &'static str) -> Vec<&'static str> {
        let reset = match self.reset {
            Reset::OfTheMechanism => ["angle reset after 360°/m", "reset after 360°/m"],
            Reset::QuarterTurn => ["after 90° for all", "reset after 90°"],
        };
        let inertias = match self.six_pin {
            SixPin::AsHeaded => ["six-pin inertias as headed", "inertias as headed"],
            SixPin::AsDrawn => ["as in Fig. 11", "as in Fig. 11"],
        };
        let reading = match self.reading {
            Reading::True => ["true peaks", "true peaks"],
            Reading::OnTheGrid => ["largest printed speed", "printed peaks"],
        };
        let constants = (self.constants == Constants::AsListed).then_some(["constants as listed", "listed π"]);
        let sign = self.delay.map(|_| ["lagged sign of the contact force", "lagged sign"]);
        [reset, inertias, reading].into_iter().chain(constants).chain(sign).map(which).collect()
    }
}
