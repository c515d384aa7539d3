//! Documents with the verdicts on all their claims.

use crate::traced_slip::trace;
use crate::{
    ARITHMETIC, CLOSURE, Claim, Consequence, DIFFERENCES, Decimal, Document, Evidence, Judged, ROUTES, Slip, Tolerance,
    TracedSlip, judge,
};
use std::collections::{BTreeMap, HashMap};
use std::panic::resume_unwind;
use std::sync::OnceLock;
use std::thread::{available_parallelism, scope};

/// Documents, their claims and the verdicts, each derived when it is first asked for and kept. It is a `static`.
pub struct Ledger {
    documents: &'static [&'static Document],
    evidence: &'static [&'static Evidence],
    mirrored: OnceLock<Vec<&'static Document>>,
    claims: OnceLock<Vec<&'static Claim>>,
    positions: OnceLock<HashMap<&'static str, usize>>,
    judged: OnceLock<Vec<OnceLock<Judged>>>,
    verdicts: OnceLock<Vec<&'static Judged>>,
    slips: OnceLock<Vec<TracedSlip>>,
    slip: OnceLock<BTreeMap<&'static str, OnceLock<Option<TracedSlip>>>>,
}

impl Ledger {
    /// A ledger of these documents and of the kinds of evidence that their claims use, each in the order in which readers
    /// see them.
    pub const fn new(documents: &'static [&'static Document], evidence: &'static [&'static Evidence]) -> Self {
        Self {
            documents,
            evidence,
            mirrored: OnceLock::new(),
            claims: OnceLock::new(),
            positions: OnceLock::new(),
            judged: OnceLock::new(),
            verdicts: OnceLock::new(),
            slips: OnceLock::new(),
            slip: OnceLock::new(),
        }
    }

    /// The documents, in the order of the ledger.
    pub fn documents(&self) -> &'static [&'static Document] {
        self.documents
    }

    /// The documents that are mirrored line by line. Totals are counted over these.
    pub fn mirrored(&'static self) -> &'static [&'static Document] {
        let mirrored = || self.documents.iter().copied().filter(|document| document.is_mirrored()).collect();
        self.mirrored.get_or_init(mirrored)
    }

    /// The document with this slug.
    pub fn document(&self, slug: &str) -> Option<&'static Document> {
        self.documents.iter().copied().find(|document| document.slug == slug)
    }

    /// The kinds of evidence.
    pub fn evidence(&self) -> &'static [&'static Evidence] {
        self.evidence
    }

    /// All tolerances by which its numbers are compared: those of the engine, then those of its kinds of evidence.
    pub fn tolerances(&self) -> Vec<&'static Tolerance> {
        let mut tolerances = vec![&ARITHMETIC, &ROUTES, &DIFFERENCES, &CLOSURE];
        for tolerance in self.evidence.iter().filter_map(|kind| kind.tolerance()) {
            if !tolerances.contains(&tolerance) {
                tolerances.push(tolerance);
            }
        }
        tolerances
    }

    /// All claims, by document and in the order of the document.
    pub fn claims(&'static self) -> &'static [&'static Claim] {
        self.claims.get_or_init(|| self.documents.iter().flat_map(|document| document.claims()).collect())
    }

    /// The claim with this id.
    pub fn claim(&'static self, id: &str) -> Option<&'static Claim> {
        Some(self.claims()[self.claim_position(id)?])
    }

    /// The position of the claim with this id among [`Ledger::claims`].
    fn claim_position(&'static self, id: &str) -> Option<usize> {
        // Of two claims with one id the first counts.
        let positions =
            || self.claims().iter().enumerate().rev().map(|(position, claim)| (claim.id, position)).collect();
        self.positions.get_or_init(positions).get(id).copied()
    }

    /// All verdicts, in the order of [`Ledger::claims`]. They are shared out among the machine's processors.
    pub fn verdicts(&'static self) -> &'static [&'static Judged] {
        self.verdicts.get_or_init(|| self.verdicts_where(|_| true))
    }

    /// The verdicts on the claims of a document, in their order: the others are not derived for it.
    pub fn verdicts_of(&'static self, document: &Document) -> Vec<&'static Judged> {
        self.verdicts_where(|claim| claim.document == document)
    }

    /// The verdicts on some claims, in their order: the others are not derived for it.
    pub fn verdicts_where(&'static self, wanted: impl Fn(&Claim) -> bool) -> Vec<&'static Judged> {
        let wanted = self.claims().iter().enumerate().filter(|(_, claim)| wanted(claim));
        self.derive(&wanted.map(|(position, _)| position).collect::<Vec<_>>())
    }

    /// The derived verdict of the claim with this id.
    pub fn verdict(&'static self, id: &str) -> Option<&'static Judged> {
        Some(self.judged(self.claim_position(id)?))
    }

    /// The verdicts that have been asked for until now, in the order of [`Ledger::claims`].
    pub fn judged_until_now(&'static self) -> impl Iterator<Item = &'static Judged> {
        self.verdict_places().iter().filter_map(OnceLock::get)
    }

    /// The verdict on the claim at this position, derived when it is first asked for.
    fn judged(&'static self, position: usize) -> &'static Judged {
        self.verdict_places()[position].get_or_init(|| judge(self.claims()[position]))
    }

    /// A place for the verdict on each claim.
    fn verdict_places(&'static self) -> &'static [OnceLock<Judged>] {
        self.judged.get_or_init(|| self.claims().iter().map(|_| OnceLock::new()).collect())
    }

    /// The verdicts on the claims at these positions, shared out among the machine's processors.
    fn derive(&'static self, positions: &[usize]) -> Vec<&'static Judged> {
        let workers = available_parallelism().map_or(1, usize::from);
        scope(|scope| {
            // Each takes every n-th claim: neighbours are often equally hard.
            let share = |worker| {
                move || {
                    positions.iter().skip(worker).step_by(workers).for_each(|position| {
                        self.judged(*position);
                    })
                }
            };
            let running: Vec<_> = (0..workers).map(|worker| scope.spawn(share(worker))).collect();
            for worker in running {
                worker.join().unwrap_or_else(|panic| resume_unwind(panic));
            }
        });
        positions.iter().map(|position| self.judged(*position)).collect()
    }

    /// The number that the claim with this id prints, in the printed unit; none if there is no such claim or if it prints no
    /// number.
    pub fn printed_value(&'static self, id: &str) -> Option<f64> {
        Some(self.claim(id)?.printed.parse::<Decimal>().ok()?.to_f64())
    }

    /// All slips, the most serious consequence first, then by how much they change printed numbers (the sum of their
    /// relative changes), then in the order of the documents.
    pub fn slips(&'static self) -> &'static [TracedSlip] {
        self.slips.get_or_init(|| self.slips_where(|_| true))
    }

    /// The slips that are made in this document, in the order of [`Ledger::slips`]: the verdicts on other claims than theirs
    /// are not derived for it.
    pub fn slips_in(&'static self, document: &Document) -> Vec<TracedSlip> {
        self.slips_where(|slip| self.claim(slip.id).is_some_and(|claim| claim.document == document))
    }

    /// The slips of the mirrored documents with this consequence.
    pub fn slips_of(&'static self, consequence: Consequence) -> impl Iterator<Item = &'static TracedSlip> {
        self.slips().iter().filter(move |traced| traced.is_mirrored() && traced.slip.consequence == consequence)
    }

    /// The slip of this id with its places: the verdicts on no other claims are derived for it.
    pub fn slip(&'static self, id: &str) -> Option<&'static TracedSlip> {
        let all = || self.claims().iter().filter_map(|claim| Some((claim.erratum?.slip.id, OnceLock::new()))).collect();
        let place = self.slip.get_or_init(all).get(id)?;
        place.get_or_init(|| self.slips_where(|slip| slip.id == id).pop()).as_ref()
    }

    /// The slips that are wanted, with their places.
    fn slips_where(&'static self, wanted: impl Fn(&Slip) -> bool) -> Vec<TracedSlip> {
        let reached = |claim: &Claim| claim.erratum.as_ref().is_some_and(|erratum| wanted(&erratum.slip));
        trace(self.verdicts_where(reached))
    }
}
