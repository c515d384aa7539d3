//! Which differences of a document are listed, and which are told apart from them as less certain.

use crate::evaluate::value::SideValue;
use crate::judge::caveat::{Caveat, DifferenceEvidence, SLIGHT};
use crate::judge::section::ReportSection;
use crate::tell::finding::ChainFinding;
use crate::tell::finding_group::ShapeKey;
use crate::tell::tally::CheckTally;

/// A difference on the list of numbers.
struct WeighedFinding {
    /// Where it is among the findings of the report.
    at: usize,
    has_hint: bool,
    is_slight: bool,
}

/// The differences on the list of numbers, each with what speaks for and against it.
#[derive(Default)]
pub(crate) struct WeighedFindings(Vec<WeighedFinding>);

impl WeighedFindings {
    pub(crate) fn record(&mut self, at: usize, values: Option<&(SideValue, SideValue)>, has_hint: bool) {
        let is_slight = values.is_some_and(|(left, right)| left.difference(right) < SLIGHT);
        self.0.push(WeighedFinding { at, has_hint, is_slight });
    }

    /// Moves what is less certain to a list of its own.
    ///
    /// A document in which much is wrong must not look as if it were right, so [`list_first_by_share`] lists one all the same. If none is
    /// less certain by the share alone and nothing else stays, the first of all is listed.
    pub(crate) fn set_apart(self, findings: &mut [ChainFinding], tally: &CheckTally) {
        let (pairs, differing) = (tally.pairs, tally.differing_pairs());
        let (mut share, mut stay, mut first) = (None, false, None);
        for WeighedFinding { at, has_hint, is_slight } in self.0 {
            let finding = &mut findings[at];
            if finding.doubt.is_some() {
                continue;
            }
            let evidence = DifferenceEvidence { chain: &finding.chain, has_hint, is_slight, pairs, differing };
            share = evidence.share_caveat();
            let caveat = evidence.caveat();
            stay |= caveat.is_none() || caveat == share;
            if caveat.is_some() {
                (finding.caveat, finding.section) = (caveat, ReportSection::LessCertain);
            }
            first = first.min(Some((finding.span, at))).or(Some((finding.span, at)));
        }
        if let Some((_, first)) = first.filter(|_| share.is_some() && !stay) {
            let (shape, caveat) = (ShapeKey::new(&findings[first]), findings[first].caveat);
            let alike = findings.iter_mut().filter(|of| of.caveat == caveat && ShapeKey::new(of) == shape);
            alike.for_each(|of| of.caveat = share);
        }
        list_first_by_share(findings);
    }
}

fn is_by_share(of: &ChainFinding) -> bool {
    matches!(of.caveat, Some(Caveat::Share { .. }))
}

/// Lists the first difference of a document that is less certain by the share of those that differ alone, with all of its shape, unless
/// one is listed already.
pub(crate) fn list_first_by_share(findings: &mut [ChainFinding]) {
    if findings.iter().any(|of| of.section == ReportSection::Numbers && is_by_share(of)) {
        return;
    }
    let is_apart = |of: &ChainFinding| of.section == ReportSection::LessCertain && is_by_share(of);
    let first = findings.iter().filter(|of| is_apart(of)).min_by_key(|of| of.span);
    let Some(shape) = first.map(ShapeKey::new) else { return };
    let alike = findings.iter_mut().filter(|of| is_apart(of) && ShapeKey::new(of) == shape);
    alike.for_each(|of| of.section = ReportSection::Numbers);
}
