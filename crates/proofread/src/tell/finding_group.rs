//! Findings of a document with one shape, which are told once with all their places.

use crate::judge::caveat::Caveat;
use crate::judge::chain_shape::chain_shape;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::doubt::Doubt;
use crate::judge::section::ReportSection;
use crate::tell::edit::EditKind;
use crate::tell::finding::ChainFinding;
use std::collections::HashMap;
use std::mem::{Discriminant, discriminant};

/// What findings share that are told together: how the sides compare, their shapes, and the kind of the hint.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(crate) struct ShapeKey {
    verdict: ChainVerdict,
    shapes: [String; 3],
    hint: Option<Discriminant<EditKind>>,
}

impl ShapeKey {
    pub(crate) fn new(of: &ChainFinding) -> Self {
        Self {
            verdict: of.verdict,
            shapes: [&of.chain, &of.left, &of.right].map(|text| chain_shape(text)),
            hint: of.hint.as_ref().map(|hint| discriminant(&hint.kind)),
        }
    }
}

/// Findings of one document with one shape, on one list.
#[derive(Clone, Debug, PartialEq)]
pub struct FindingGroup {
    /// The first one in the text.
    pub finding: ChainFinding,
    /// The others, in the order of the text.
    pub others: Vec<ChainFinding>,
}

impl FindingGroup {
    /// How many places of the text it stands for, at least one.
    ///
    /// ```
    /// use proofread::{CheckOptions, TextFormat, group_findings, proofread};
    ///
    /// let text = r"$2 + 2 = 5$, $3 + 3 = 7$, and $2.0 \cdot 3.0 = 7.0$";
    /// let groups = group_findings(proofread(text, TextFormat::Markdown, CheckOptions::default())?.findings);
    /// assert_eq!(groups.iter().map(|group| group.place_count()).collect::<Vec<_>>(), [2, 1]);
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn place_count(&self) -> usize {
        1 + self.others.len()
    }

    /// All findings of the group, in the order of the text.
    pub fn places(&self) -> impl Iterator<Item = &ChainFinding> {
        std::iter::once(&self.finding).chain(&self.others)
    }
}

/// Puts findings of one document together that have one shape, in the order of their first ones.
///
/// Two have one shape if they are on the same list for the same reason, compare in the same way, have hints of the same kind or none,
/// and differ only in their numbers and words. Statistics and pairs that agree each stand alone.
pub fn group_findings(findings: Vec<ChainFinding>) -> Vec<FindingGroup> {
    type GroupKey = (ReportSection, Option<Doubt>, Option<Discriminant<Caveat>>, ShapeKey);
    let mut groups: Vec<FindingGroup> = Vec::new();
    let mut known: HashMap<GroupKey, usize> = HashMap::new();
    for finding in findings {
        let alone = matches!(finding.section, ReportSection::Statistics | ReportSection::Agreeing);
        if !alone {
            let caveat = finding.caveat.as_ref().map(discriminant);
            let key = (finding.section, finding.doubt, caveat, ShapeKey::new(&finding));
            let next = groups.len();
            let at = *known.entry(key).or_insert(next);
            if let Some(group) = groups.get_mut(at) {
                group.others.push(finding);
                continue;
            }
        }
        groups.push(FindingGroup { finding, others: Vec::new() });
    }
    groups
}
