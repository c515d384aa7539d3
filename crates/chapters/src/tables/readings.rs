//! The claims that hostile readings have overturned: each reading with the claims whose answer it changed.

use geneva_evidence::Kind;
use geneva_press::table::{Cells, Table};

/// A reading of the ledger and of the book by someone who set out to refute them.
pub struct HostileReading {
    /// Its day and what was read.
    pub what: &'static str,
    /// Claims on record then, those on pages elsewhere among them.
    pub claims: usize,
    /// The claims of which the answer to "is it right?" changed because of it, with their kinds.
    pub overturned: &'static [(&'static str, Kind)],
    /// Statements and figures that it went through one by one; none if they were not counted.
    pub gone_through: Option<usize>,
    /// Sentences of the book that it found false or saying too much; none if they were not counted.
    pub sentences: Option<usize>,
}

/// All readings so far, in their order. A claim that is no longer in the ledger is still listed here.
pub const READINGS: &[HostileReading] = &[
    HostileReading {
        what: "First, 22 November 2026: all four sources, in two rounds",
        claims: 662,
        overturned: &[
            ("quick-return.acceleration-in-a-frame", Kind::Equation),
            ("quick-return.coriolis-direction", Kind::Statement),
            ("jazar.fig-5.30", Kind::Figure),
            ("jazar.ex-c.division", Kind::Value),
            ("jazar.ex-e.preceding", Kind::Statement),
            ("jazar.ex-e.maximum", Kind::Statement),
            ("jazar.ex-e.signs", Kind::Statement),
            ("meyer.along-the-slot", Kind::Statement),
            ("meyer.friction-opposes", Kind::Statement),
            ("meyer.friction-opposes-again", Kind::Statement),
            ("meyer.singularity.conclusion", Kind::Statement),
            ("meyer.parameter.entry-angle", Kind::Statement),
            ("meyer.like-discs", Kind::Statement),
            ("meyer.letter-m", Kind::Statement),
            ("meyer.disc.inertia", Kind::Value),
            ("meyer.fig-10.rise-axis", Kind::Statement),
            ("meyer.less-friction", Kind::Statement),
            ("meyer.almost-linear", Kind::Statement),
            ("meyer.conclusion.three", Kind::Statement),
            ("meyer.app-b.method.one-value", Kind::Statement),
            ("meyer.app-b.method.constant", Kind::Statement),
            ("meyer.app-b.method.subinterval", Kind::Statement),
            ("meyer.app-b.cannot-be-solved", Kind::Statement),
            ("meyer.app-b.simultaneous", Kind::Statement),
            ("meyer.app-d.order", Kind::Statement),
            ("meyer.app-e.torque-unit", Kind::Statement),
        ],
        gone_through: None,
        sentences: None,
    },
    HostileReading {
        what: "Second, 22 November 2026: the three small sources, Chapter II and Appendices B and D of the thesis",
        claims: 783,
        overturned: &[
            ("pin.letter-v", Kind::Statement),
            ("pin.letter-f", Kind::Statement),
            ("pin.pin-speed-equation", Kind::Equation),
            ("pin.mark-d", Kind::Statement),
            ("pin.follower-speed-equation", Kind::Equation),
            ("jazar.fig-5.30", Kind::Figure),
            ("jazar.wheel-radius-ratio", Kind::Statement),
            ("jazar.ex-c.division", Kind::Value),
            ("jazar.generalises", Kind::Statement),
            ("meyer.along-the-slot", Kind::Statement),
            ("meyer.shape", Kind::Statement),
            ("meyer.first-minimum", Kind::Statement),
            ("meyer.less-friction", Kind::Statement),
        ],
        gone_through: None,
        sentences: None,
    },
    HostileReading {
        what: "Third, 23 November 2026: Appendices B and D of the thesis",
        claims: 892,
        overturned: &[("meyer.app-d.needed", Kind::Statement)],
        gone_through: None,
        sentences: None,
    },
    HostileReading {
        what: "Fourth, 23 November 2026: the thesis's statements, the three small sources, the pages elsewhere, and more than \
               300 numbers of the book",
        claims: 901,
        overturned: &[
            ("pin.follower-sense", Kind::Statement),
            ("jazar.most-stations", Kind::Statement),
            ("jazar.wheel-radius-ratio", Kind::Statement),
            ("jazar.ex-c.division", Kind::Value),
            ("meyer.abstract.consequently", Kind::Statement),
            ("meyer.contents", Kind::Statement),
            ("meyer.list-of-figures", Kind::Figure),
            ("meyer.always-engaged", Kind::Statement),
            ("meyer.along-the-slot", Kind::Statement),
            ("meyer.vector-sum", Kind::Statement),
            ("meyer.possible-flaw", Kind::Statement),
            ("meyer.parameter.spring", Kind::Statement),
            ("meyer.disc.inertia", Kind::Value),
            ("meyer.shape", Kind::Statement),
            ("meyer.first-minimum", Kind::Statement),
            ("meyer.leaves-as-entered", Kind::Statement),
            ("meyer.fig-11.abscissa", Kind::Statement),
            ("meyer.less-friction", Kind::Statement),
            ("meyer.small-variations", Kind::Statement),
            ("meyer.better-average", Kind::Statement),
            ("meyer.app-b.method.subinterval", Kind::Statement),
            ("meyer.app-b.cannot-be-solved", Kind::Statement),
            ("meyer.app-b.spring-constant", Kind::Statement),
            ("meyer.app-b.simultaneous", Kind::Statement),
            ("meyer.app-e.4-pin.mu-0.35.k-0.09.rise", Kind::Value),
            ("meyer.app-e.4-pin.mu-0.35.k-0.10.rise", Kind::Value),
            ("meyer.app-e.4-pin.mu-0.35.k-0.11.rise", Kind::Value),
            ("meyer.app-e.4-pin.mu-0.35.k-0.12.rise", Kind::Value),
            ("meyer.app-e.4-pin.mu-0.35.k-0.20.rise", Kind::Value),
            ("wild.mecha-external.gears", Kind::Equation),
            ("wild.mecha-internal.gears", Kind::Equation),
        ],
        gone_through: Some(218),
        sentences: Some(47),
    },
    HostileReading {
        what: "Fifth, 23 November 2026: 150 claims drawn at random, and the sentences of five chapters",
        claims: 901,
        overturned: &[],
        gone_through: Some(26),
        sentences: Some(18),
    },
    HostileReading {
        what: "Sixth, 24 November 2026: the statements and figures of all sources and the pages elsewhere, claim by \
               claim, and what the fifth had left undecided",
        claims: 955,
        overturned: &[
            ("jazar.fig-5.28-sense", Kind::Figure),
            ("meyer.fig-3", Kind::Figure),
            ("meyer.less-friction", Kind::Statement),
            ("meyer.app-b.delay", Kind::Statement),
            ("meyer.app-e.4-pin.mu-0.30.k-0.10.max", Kind::Value),
            ("meyer.app-e.4-pin.mu-0.35.k-0.20.max", Kind::Value),
            ("wild.mechanics.speed", Kind::Equation),
            ("wild.freecad.slot-width", Kind::Statement),
        ],
        gone_through: Some(217),
        sentences: None,
    },
    HostileReading {
        what: "Seventh, 28 November 2026: claims of the thesis drawn at random, all claims of the three small sources, a sample of \
               the pages elsewhere, and nearly 800 numbers",
        claims: 959,
        overturned: &[
            ("jazar.fig-5.28-sense", Kind::Figure),
            ("meyer.disc.inertia", Kind::Value),
            ("meyer.more-torque", Kind::Statement),
            ("meyer.page-of-definition", Kind::Statement),
        ],
        gone_through: None,
        sentences: Some(32),
    },
    HostileReading {
        what: "Eighth, 28 November 2026: 120 claims and 150 sentences drawn at random, derived anew without our programs, and five \
               pages of the book, line by line",
        claims: 987,
        overturned: &[],
        gone_through: None,
        sentences: Some(41),
    },
];

impl HostileReading {
    /// How many claims of some kinds it overturned.
    pub fn count(&self, kinds: &[Kind]) -> usize {
        self.overturned.iter().filter(|(_, kind)| kinds.contains(kind)).count()
    }
}

/// The kinds of claim in the columns of the table.
pub const SENTENCES: [Kind; 2] = [Kind::Statement, Kind::Figure];

/// Each reading, and how many claims of each kind it overturned.
pub fn readings() -> anyhow::Result<Table> {
    Table::with_rows(Cells::Words, READINGS)
        .column("Reading", |reading| reading.what)
        .column("Claims in the ledger at the time", |reading| reading.claims)
        .column("Numbers overturned", |reading| reading.count(&[Kind::Value]))
        .column("Equations", |reading| reading.count(&[Kind::Equation]))
        .column("Statements and figures", |reading| reading.count(&SENTENCES))
        .column("Sentences of the book that had to change", |reading| {
            reading.sentences.map_or_else(|| "not counted".to_owned(), |count| count.to_string())
        })
        .finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lookup::judged;
    use geneva_documents::LEDGER;
    use geneva_evidence::Truth;
    use std::collections::BTreeSet;

    #[test]
    fn a_reading_lists_claims_of_the_ledger_once_and_with_their_kinds() {
        for reading in READINGS {
            let ids: BTreeSet<_> = reading.overturned.iter().map(|(id, _)| id).collect();
            assert_eq!(ids.len(), reading.overturned.len(), "{}", reading.what);
            for (id, kind) in reading.overturned {
                // A claim may have gone since.
                assert!(LEDGER.claim(id).is_none_or(|claim| claim.kind == *kind), "{id}: {kind}");
            }
            let known = reading.overturned.iter().filter(|(id, _)| LEDGER.claim(id).is_some()).count();
            assert!(10 * known >= 8 * reading.overturned.len(), "{}: {known} claims are known", reading.what);
        }
    }

    #[test]
    fn what_the_last_readings_overturned_of_the_documents_statements_is_as_the_page_says() {
        let [.., sixth, seventh, eighth] = READINGS else { panic!("three readings") };
        assert_eq!(eighth.overturned, []);
        let own = |reading: &HostileReading| -> Vec<&str> {
            let here = |(id, kind): &&(&str, Kind)| SENTENCES.contains(kind) && !id.starts_with("wild.");
            reading.overturned.iter().filter(here).map(|(id, _)| *id).collect()
        };
        let (before, now) = (own(sixth), own(seventh));
        let (again, open): (Vec<&str>, Vec<&str>) = now.iter().partition(|id| before.contains(id));
        assert_eq!((again.len(), open.len()), (1, 2));
        for id in before.iter().filter(|id| !again.contains(id)).chain(&open) {
            assert_eq!(judged(id).expect("a claim").truth(), Truth::Open, "{id}");
        }
        assert_eq!(judged(again[0]).expect("a claim").truth(), Truth::Right);
    }

    #[test]
    fn the_kinds_add_up_and_the_ledger_has_grown() {
        for reading in READINGS {
            let kinds = [&[Kind::Value][..], &[Kind::Equation], &SENTENCES];
            let sum: usize = kinds.iter().map(|kinds| reading.count(kinds)).sum();
            assert_eq!(sum, reading.overturned.len(), "{}", reading.what);
            assert!(reading.overturned.len() < reading.claims);
            assert!(reading.gone_through.is_none_or(|all| reading.count(&SENTENCES) <= all && all < reading.claims));
        }
        assert!(READINGS.windows(2).all(|pair| pair[0].claims <= pair[1].claims));
        let csv = readings().expect("a table").csv().expect("data");
        assert_eq!(csv.lines().count(), READINGS.len() + 1);
    }
}
