//! Statistics and totals: p-values beside their tests, confidence intervals, shares in per cent, and sums in tables.
//!
//! These are no chains of equal sides, so they are read by themselves, from the text as its readers see it.

mod characters;
mod confidence;
mod distribution;
mod scanner;
mod share;
mod significance;
mod table;
mod table_rows;
mod test_statistic;
mod totals;

use crate::check::CheckReport;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::doubt::Doubt;
use crate::judge::section::ReportSection;
use crate::reader::{TextFormat, UnreadableText, shown_text};
use crate::tell::finding::ChainFinding;
use crate::tell::statistics_tally::StatisticsTally;
use crate::token::Span;
use characters::PlainCharacters;
use std::ops::Range;

/// What was found in the statistics and tables of a text, and how much was compared.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StatisticsReport {
    /// What does not agree, in the order of the text; doubts are marked as such.
    pub findings: Vec<ChainFinding>,
    /// How much was compared.
    pub tally: StatisticsTally,
    /// Where the p-values are that were compared, each with its test statistic.
    pub compared: Vec<Span>,
}

impl StatisticsReport {
    /// Adds what was found to a report on the chains of the same text; what is listed there already is left out. A statistic or
    /// p-value that was compared is no unchecked chain any more, if the report lists these.
    ///
    /// ```
    /// use proofread::{CheckOptions, ReportSection, TextFormat, find_statistics, proofread};
    ///
    /// let text = "It is $2 + 2 = 5$, and $t(28) = 2.20$, $p = .36$.";
    /// let mut report = proofread(text, TextFormat::Markdown, CheckOptions::default())?;
    /// find_statistics(text, TextFormat::Markdown)?.add_to(&mut report);
    /// let sections = report.findings.iter().map(|finding| finding.section);
    /// assert!(sections.eq([ReportSection::Numbers, ReportSection::Statistics]));
    /// assert_eq!(report.tally.statistics.tests, 1);
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn add_to(self, report: &mut CheckReport) {
        let listed = |at: Span| {
            let before = report.findings.partition_point(|finding| finding.at.start < at.start);
            let near = report.findings[before.saturating_sub(1)..].iter().take(2);
            { near }.any(|finding| {
                finding.section != ReportSection::Agreeing && finding.at.start < at.end && at.start < finding.at.end
            })
        };
        let new: Vec<ChainFinding> = self.findings.into_iter().filter(|finding| !listed(finding.at)).collect();
        #[cfg(feature = "cli")]
        self.compared.iter().for_each(|span| report.remove_unchecked_within(*span));
        report.tally.doubts += new.iter().filter(|finding| finding.doubt.is_some()).count();
        report.tally.statistics.add(&self.tally);
        report.findings.extend(new);
        report.findings.sort_by_key(|finding| finding.span);
    }
}

/// How two printed numbers compare that do not agree.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Outcome {
    Difference,
    Doubt(Doubt),
}

/// A difference in running text, by its places in the characters.
struct Judged {
    left: Range<usize>,
    right: Range<usize>,
    whole: Range<usize>,
    recomputed: String,
    why: Option<String>,
    outcome: Outcome,
}

/// Most findings that are kept of one text.
const MOST_FINDINGS: usize = 1000;

/// Compares the statistics and the totals of tables that a text prints with what they follow from.
///
/// # Errors
///
/// If the text is too long, or is no notebook where it should be one.
///
/// ```
/// use proofread::{TextFormat, find_statistics};
///
/// let text = "It made a difference, *t*(28) = 2.20, *p* = .36, in 12 of 48 cases (25 %).";
/// let report = find_statistics(text, TextFormat::Markdown)?;
/// assert_eq!(report.tally.count(), 2);
/// assert_eq!(report.findings[0].chain, "t(28) = 2.20, p = .36");
/// assert_eq!(report.findings[0].recomputed.as_deref(), Some("p = 0.036 (two-sided)"));
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
pub fn find_statistics(text: &str, format: TextFormat) -> Result<StatisticsReport, UnreadableText> {
    let shown = shown_text(text, format)?;
    let mut tally = StatisticsTally::default();
    let mut findings: Vec<ChainFinding> = Vec::new();
    let mut compared = Vec::new();
    for piece in if format == TextFormat::Csv { Vec::new() } else { pieces(shown.text()) } {
        let plain = PlainCharacters::new(&shown.text()[piece.clone()], format);
        let mut judged = Vec::new();
        let tests = significance::check(&plain, &mut judged);
        tally.tests += tests.len();
        tally.intervals += confidence::check(&plain, &mut judged);
        tally.shares += share::check(&plain, &mut judged);
        let place = |range: Range<usize>| {
            let span = plain.span(range).range();
            shown.span_in_file(Span::new(piece.start + span.start, piece.start + span.end))
        };
        compared.extend(tests.into_iter().map(&place));
        judged.truncate(MOST_FINDINGS.saturating_sub(findings.len()));
        findings.extend(judged.into_iter().map(|of| finding(of, &plain, &place)));
    }
    let tables = table_rows::tables(text, shown.text(), format, &|span| shown.span_in_file(span));
    for table in &tables {
        tally.totals += totals::check(table, &mut findings);
    }
    findings.truncate(MOST_FINDINGS);
    findings.sort_by_key(|finding| finding.at);
    Ok(StatisticsReport { findings, tally, compared })
}

/// How long a piece is at least, in bytes: each character of a piece takes some thirty while it is looked at.
const PIECE: usize = 1 << 20;

/// Cuts before a paragraph, or in one that never ends behind a line or a word.
fn pieces(text: &str) -> Vec<Range<usize>> {
    let boundary = |at: usize| (at..text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(text.len());
    let (mut out, mut start) = (Vec::new(), 0);
    while text.len() - start > PIECE {
        let from = boundary(start + PIECE);
        let next = &text[from..boundary(from + PIECE)];
        let behind = |mark: &str| next.find(mark).map(|at| at + mark.len());
        let end = from + behind("\n\n").or_else(|| behind("\n")).or_else(|| behind(" ")).unwrap_or(next.len());
        out.push(start..end);
        start = end;
    }
    out.push(start..text.len());
    out
}

fn finding(of: Judged, plain: &PlainCharacters, place: &dyn Fn(Range<usize>) -> Span) -> ChainFinding {
    /// Longest line that is shown, in characters.
    const LONGEST: usize = 200;
    let (left, right) = (plain.line(of.left.clone()), plain.line(of.right.clone()));
    let chain = match of.whole.len() <= LONGEST {
        true => plain.line(of.whole.clone()),
        false => format!("{left} … {right}"),
    };
    let marked = chain.rfind(&right).map_or(0..0, |at| at..at + right.len());
    let spans = [of.left, of.right, of.whole].map(place);
    statistic_finding(StatisticDifference {
        chain,
        marked,
        left,
        right,
        spans,
        recomputed: of.recomputed,
        why: of.why,
        outcome: of.outcome,
    })
}

/// A difference with its words and its places in the file.
struct StatisticDifference {
    chain: String,
    marked: Range<usize>,
    left: String,
    right: String,
    /// Of the left side, of the right side, and of all.
    spans: [Span; 3],
    recomputed: String,
    why: Option<String>,
    outcome: Outcome,
}

fn statistic_finding(of: StatisticDifference) -> ChainFinding {
    let doubt = match of.outcome {
        Outcome::Difference => None,
        Outcome::Doubt(doubt) => Some(doubt),
    };
    let [left_span, right_span, span] = of.spans;
    ChainFinding {
        verdict: ChainVerdict::Inconsistent,
        section: if doubt.is_some() { ReportSection::Doubts } else { ReportSection::Statistics },
        doubt,
        caveat: None,
        chain: of.chain,
        marked: of.marked,
        span,
        left: of.left,
        left_span,
        printed: of.right.clone(),
        right: of.right,
        right_span,
        at: right_span,
        recomputed: Some(of.recomputed),
        factor: None,
        difference: None,
        explanation: None,
        why: of.why,
        hint: None,
        reading: Vec::new(),
        names: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_text_is_cut_between_paragraphs_if_it_has_any() {
        let cut = |unit: &str, behind: &str| {
            let text = unit.repeat(3 * PIECE / unit.len());
            let pieces = pieces(&text);
            assert!(pieces.len() > 1 && pieces.windows(2).all(|two| two[0].end == two[1].start), "{unit:?}");
            assert_eq!((pieces[0].start, pieces[pieces.len() - 1].end), (0, text.len()));
            assert!(pieces.iter().all(|piece| piece.len() <= 2 * PIECE + 4), "{unit:?}");
            assert!(pieces[1..].iter().all(|piece| text[..piece.start].ends_with(behind)), "{unit:?}");
        };
        cut("A line,\nand one more.\n\n", "\n\n");
        cut("Lines for ever\n", "\n");
        cut("words for ever ", " ");
        cut("ä", "ä");
        assert_eq!(pieces("a"), std::iter::once(0..1).collect::<Vec<_>>());
    }

    #[test]
    fn what_is_found_far_behind_has_its_place_in_the_whole_text() {
        let test = "*t*(28) = 2.20, *p* = .36";
        let text = format!("{}{test}.\n", "It made a difference.\n\n".repeat(2 * PIECE / 22));
        let report = find_statistics(&text, TextFormat::Markdown).expect("it can be read");
        let found: Vec<&str> = report.findings.iter().map(|finding| &text[finding.at.range()]).collect();
        assert_eq!((report.tally.count(), found), (1, vec!["p* = .36"]));
    }
}
