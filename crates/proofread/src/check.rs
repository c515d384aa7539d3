//! A document, formula by formula: what was checked, and what was found.

use crate::certainty::WeighedFindings;
use crate::effort::{self, CheckEffort};
use crate::evaluate::binding::{KnownNames, NamePolicy, assignment, single_name};
use crate::evaluate::value::{Literal, Obstacle, SideValue};
use crate::join::chain::{Chain, ChainSide, ROW_END, Relation, split_chains};
use crate::join::matrix_sides::{self, MatrixProduct};
use crate::judge::cancelled_words::without_words;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::doubt::{Doubt, PlacedPair};
use crate::judge::explanation::{DifferingPair, agrees};
use crate::judge::letter_units::units_in_letters;
use crate::judge::money::has_several_currencies;
use crate::judge::number_columns;
use crate::judge::other_meanings::loses_all_digits;
use crate::judge::permutation;
use crate::judge::running_calculation::runs_on;
use crate::judge::section::ReportSection;
use crate::judge::shared_factor::Factors;
use crate::judge::surroundings;
use crate::judge::unchecked::{ChainOutcome, UncheckedKind, is_numeric, is_unread};
use crate::judge::unrounded::EarlierResults;
use crate::judge::verdict::{PairJudgement, evaluate_freely, judge};
use crate::judge::{denial, question};
use crate::named_counts::NamedCounts;
use crate::order::sort_by_place;
use crate::reader::{
    self, Definitions, Formula, FormulaStyle, SpanSource, TextFormat, UnreadParts, UnreadableText, without_shortcodes,
};
use crate::tell::finding::ChainFinding;
use crate::tell::hint::{self, HintSearch};
use crate::tell::tally::CheckTally;
#[cfg(feature = "cli")]
use crate::tell::unchecked_chain::UncheckedChain;
use crate::token::{Span, Token, TokenKind, any, has_number};

/// What to look for.
///
/// ```
/// use proofread::{CheckOptions, NamePolicy, ReportSection, TextFormat, proofread};
///
/// let text = "Let $m = 2.0$. Then $3.0 m = 6.5$ and $1.5 + 1.5 = 3.0$.";
/// let sections = |options| {
///     let report = proofread(text, TextFormat::Markdown, options).expect("a short text");
///     report.findings.iter().map(|finding| finding.section).collect::<Vec<_>>()
/// };
/// let once = CheckOptions { name_policy: NamePolicy::Once, ..CheckOptions::default() };
/// assert_eq!(sections(once), [ReportSection::Bindings]);
/// assert_eq!(sections(CheckOptions::default()), []);
/// let all = CheckOptions { agreeing: true, ..once };
/// assert_eq!(sections(all), [ReportSection::Bindings, ReportSection::Agreeing]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CheckOptions<'d> {
    /// Which values of names are put into formulas.
    pub name_policy: NamePolicy,
    /// Whether pairs that agree are kept, too.
    pub agreeing: bool,
    /// Whether the chains that were not checked are kept, each with its reason; the report counts them in any case.
    #[cfg(feature = "cli")]
    pub unchecked: bool,
    /// Most findings for which a hint is searched, the first ones: the search takes longer than the rest.
    pub hints: usize,
    /// Most tokens that are evaluated in the search for hints: what is not searched for is not offered.
    pub hint_effort: usize,
    /// What other LaTeX texts define for this one: its preamble, packages or classes, or the macros of a book in PreTeXt. A
    /// definition of its own counts before them. Plain texts are read without.
    pub definitions: Option<&'d Definitions>,
}

impl Default for CheckOptions<'_> {
    fn default() -> Self {
        Self {
            name_policy: NamePolicy::default(),
            agreeing: false,
            #[cfg(feature = "cli")]
            unchecked: false,
            hints: MOST_HINTS,
            hint_effort: hint::MOST_FOR_ALL,
            definitions: None,
        }
    }
}

/// What proofreading a document found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CheckReport {
    /// What does not agree, in the order of the text, in all lists.
    pub findings: Vec<ChainFinding>,
    /// How much was checked.
    pub tally: CheckTally,
    /// The chains that were not checked, by their reason and by the name of what stands in them.
    pub not_checked: NamedCounts<UncheckedKind>,
    /// These chains, with those that were checked in part, in the order in which they were read; none unless they are asked for.
    #[cfg(feature = "cli")]
    pub unchecked: Vec<UncheckedChain>,
    /// The parts of the text that were not read although a chain may be in them.
    pub not_read: UnreadParts,
    /// What it took.
    pub effort: CheckEffort,
}

#[cfg(feature = "cli")]
impl CheckReport {
    /// Takes the chains that were not checked at all in a stretch of the text from the list of these and from their counts.
    pub(crate) fn remove_unchecked_within(&mut self, stretch: Span) {
        let not_checked = &mut self.not_checked;
        self.unchecked.retain(|chain| {
            let is_within = !chain.partly && stretch.start <= chain.span.start && chain.span.end <= stretch.end;
            let is_counted = !matches!(chain.kind, UncheckedKind::Unread | UncheckedKind::Doubt | UncheckedKind::Fence);
            if is_within && is_counted {
                not_checked.discount(chain.kind, if chain.kind.has_names() { &chain.name } else { "" });
            }
            !(is_within && is_counted)
        });
    }
}

/// Most findings that are kept of one document; the tally counts all.
const MOST_FINDINGS: usize = 10_000;

/// Most findings of one document for which a hint is searched, unless the caller says otherwise.
const MOST_HINTS: usize = 300;

/// Recomputes every chain of numbers that a text prints.
///
/// # Errors
///
/// If the text is longer than [`reader::LONGEST`], or is no notebook where it should be one.
///
/// ```
/// use proofread::{CheckOptions, ReportSection, TextFormat, proofread};
///
/// let report = proofread("$10/4 = 2.5$ and $43.4 - 29.8 = 13.8$", TextFormat::Markdown, CheckOptions::default())?;
/// let finding = &report.findings[0];
/// assert_eq!((finding.left.as_str(), finding.right.as_str()), ("43.4 − 29.8", "13.8"));
/// assert_eq!((finding.section, finding.verdict.name()), (ReportSection::Numbers, "last-digit"));
/// assert_eq!(report.tally.pairs, 2);
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
pub fn proofread(text: &str, format: TextFormat, options: CheckOptions<'_>) -> Result<CheckReport, UnreadableText> {
    let steps = effort::steps();
    let shown = if format == TextFormat::Markdown { without_shortcodes(text) } else { None };
    let text = shown.as_deref().unwrap_or(text);
    let lines = reader::running_text(text, format, options.definitions);
    let mut check = DocumentCheck {
        text,
        options,
        report: CheckReport::default(),
        known: KnownNames::default(),
        before: None,
        results: EarlierResults::default(),
        factors: Factors::default(),
        weighed: WeighedFindings::default(),
        open_pairs: 0,
        budget: options.hint_effort,
        is_plain_text: format == TextFormat::Plain,
        #[cfg(feature = "cli")]
        unchecked_before: None,
        #[cfg(feature = "cli")]
        shows_source: !matches!(format, TextFormat::Xml | TextFormat::Html | TextFormat::Notebook),
    };
    if options.name_policy == NamePolicy::Once && text.len() <= ONE_PROBLEM {
        let known = &mut check.known;
        let mut count =
            |formula: Formula| split_chains(&formula.tokens).iter().for_each(|chain| known.count_assignment(chain));
        reader::read_with(text, format, options.definitions, &lines, &mut |formula, _| count(formula))?;
    } else if options.name_policy == NamePolicy::Once {
        check.options.name_policy = NamePolicy::Never;
    }
    let mut in_lines = None;
    let not_read = reader::read_with(text, format, options.definitions, &lines, &mut |formula, from| {
        if from == SpanSource::Lines && in_lines.is_none() {
            in_lines = Some(check.report.findings.len());
            #[cfg(feature = "cli")]
            check.unchecked_before.replace(check.report.unchecked.len());
            (check.text, check.before) = (&lines.text, None);
        }
        check.check_formula(&formula);
    })?;
    for at in check.factors.habits() {
        demote_to_doubt(&mut check.report.findings[at], Doubt::Habit);
    }
    check.report.not_read = not_read;
    let findings = &mut check.report.findings;
    if let Some(at) = in_lines {
        findings[at..].iter_mut().for_each(|finding| finding.map_spans(&|span| lines.span_in_page(span)));
    }
    check.weighed.set_apart(findings, &check.report.tally);
    if in_lines.is_some() {
        sort_by_place(findings, |finding| finding.span);
    }
    #[cfg(feature = "cli")]
    if let Some(at) = check.unchecked_before {
        let unchecked = &mut check.report.unchecked[at..];
        unchecked.iter_mut().for_each(|chain| chain.span = lines.span_in_page(chain.span));
    }
    let hints = options.hint_effort - check.budget;
    check.report.effort = CheckEffort { steps: effort::steps().saturating_sub(steps), hints };
    check.report.tally.bytes = text.len();
    let count = |section| check.report.findings.iter().filter(|of| of.section == section).count();
    let [doubts, less_certain] = [ReportSection::Doubts, ReportSection::LessCertain].map(count);
    (check.report.tally.doubts, check.report.tally.less_certain) = (doubts, less_certain);
    Ok(check.report)
}

/// The sides of a chain before the left and behind the right one of two neighbours, if they are equal to them.
fn neighbours<'c>(chain: &'c Chain, left: &ChainSide, right: &ChainSide) -> [Option<&'c ChainSide>; 2] {
    let at = |wanted: &ChainSide| chain.sides.iter().position(|side| std::ptr::eq(side, wanted));
    let (Some(left), Some(right)) = (at(left), at(right)) else { return [None; 2] };
    let is_equal = |side: &ChainSide| side.relation == Some(Relation::Equal);
    let before = left.checked_sub(1).filter(|_| is_equal(&chain.sides[left])).map(|at| &chain.sides[at]);
    [before, chain.sides.get(right + 1).filter(|behind| is_equal(behind))]
}

/// How far around a formula a number is looked for that a hint may offer, in bytes.
const AROUND: usize = 2000;

/// The text before and behind a formula.
fn text_around(text: &str, span: Span) -> [&str; 2] {
    let (start, end) = (span.start as usize, span.end as usize);
    let from = (start.saturating_sub(AROUND)..=start).find(|at| text.is_char_boundary(*at)).unwrap_or(start);
    let to = (end..=(end + AROUND).min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(end);
    [text.get(from..start).unwrap_or_default(), text.get(end..to).unwrap_or_default()]
}

/// What is said of a chain of which it stays open whether two sides agree.
const MAY_AGREE: &str = "sides that may agree in another reading";

/// The last place in a formula where its source has a cross behind a row.
fn place_of_cross(text: &str, span: Span) -> Option<u32> {
    const CROSSES: [&str; 7] = ["\\ding{53}", "\\ding{54}", "\\ding{55}", "\\ding{56}", "\\xmark", "✗", "✘"];
    let source = text.get(span.range()).unwrap_or_default();
    CROSSES.iter().filter_map(|cross| source.rfind(cross)).max().map(|at| span.start + at as u32)
}

/// The last place in a formula where a sign or a word says that a row is false; none if it says so nowhere.
fn place_of_denial(tokens: &[Token]) -> Option<u32> {
    let says = |token: &Token| match &token.kind {
        TokenKind::Operator(c) => "≠✗✘".contains(*c),
        TokenKind::Word(word) => matches!(word.as_str(), "false" | "False" | "untrue" | "extraneous" | "Contradiction"),
        _ => false,
    };
    let inner = |token: &Token| token.inner().filter_map(place_of_denial).max();
    tokens.iter().filter_map(|token| if says(token) { Some(token.span.start) } else { inner(token) }).max()
}

/// Whether a chain has two sides, or equations of two sides each in rows of their own, which begin with a sign.
fn are_rows_of_two(chain: &Chain) -> bool {
    let is_joint = |side: &ChainSide| side.tokens.iter().any(|token| token.kind == TokenKind::Space(ROW_END));
    match chain.sides.as_slice() {
        [_, inner @ .., _] => inner.iter().all(is_joint),
        _ => false,
    }
}

fn demote_to_doubt(finding: &mut ChainFinding, doubt: Doubt) {
    finding.section = ReportSection::Doubts;
    finding.doubt = Some(doubt);
    finding.hint = None;
}

/// Documents up to this many bytes are taken for one problem whose names keep their meaning.
const ONE_PROBLEM: usize = 20_000;

/// The last side of a chain that assigned a computed value to a name.
struct AssignedSide {
    name: String,
    side: ChainSide,
    span: Span,
}

struct DocumentCheck<'t> {
    text: &'t str,
    options: CheckOptions<'t>,
    report: CheckReport,
    known: KnownNames,
    before: Option<AssignedSide>,
    /// The results of the example or section so far.
    results: EarlierResults,
    /// The factors between the sides that differ.
    factors: Factors,
    /// The findings on numbers, each with what speaks for and against it.
    weighed: WeighedFindings,
    /// How many pairs were compared of which it stays open whether they agree.
    open_pairs: usize,
    /// What the search for hints may still cost.
    budget: usize,
    /// Whether the text is one of plain lines.
    is_plain_text: bool,
    /// How many chains that were not checked are in the formulas, before those of running text.
    #[cfg(feature = "cli")]
    unchecked_before: Option<usize>,
    /// Whether a formula can be read as it is written, and not only by programs.
    #[cfg(feature = "cli")]
    shows_source: bool,
}

impl DocumentCheck<'_> {
    fn check_formula(&mut self, formula: &Formula) {
        self.report.tally.formulas += 1;
        if any(&formula.tokens, &TokenKind::is_unread) {
            self.report.tally.unread += 1;
            #[cfg(feature = "cli")]
            self.keep_unchecked(|text| UncheckedChain::unread(text, formula));
        }
        let chains = split_chains(&formula.tokens);
        let numeric = |chain: &&Chain| {
            let compared = chain.sides.iter().skip(1).any(|side| side.relation != Some(Relation::Other));
            compared && chain.sides.iter().any(|side| has_number(&side.tokens))
        };
        let last = chains.len().saturating_sub(1);
        let false_from = place_of_denial(&formula.tokens).max(place_of_cross(self.text, formula.span));
        for (at, chain) in chains.iter().enumerate() {
            let with_units = units_in_letters(chain, &formula.tokens).or_else(|| without_words(chain));
            let chain = with_units.as_ref().unwrap_or(chain);
            if !numeric(&chain) {
                self.before = None;
                continue;
            }
            let trusted = chain.sides.len();
            // In running text, what comes before a sign of a sum or a product was not read.
            let lacks_its_start = formula.style == FormulaStyle::Plain
                && chain.sides[0].tokens.first().is_some_and(|first| first.is_one_of("+×·/"));
            // A digit close before a formula is a factor that was left outside.
            let glued = formula.style == FormulaStyle::Formula
                && self
                    .text
                    .get(..formula.span.start as usize)
                    .is_some_and(|before| before.ends_with(|c: char| c.is_ascii_digit()));
            let from = usize::from((at == 0 && (formula.continues || glued)) || lacks_its_start);
            let to = trusted - usize::from(at == last && formula.goes_on);
            // A row below says that this one is false.
            let is_denied = are_rows_of_two(chain)
                && chain.starts_row
                && false_from.is_some_and(|place| chain.sides[1].span.end <= place)
                || denial::is_derived_from_false(self.text, &chains, at);
            self.check_chain(chain, formula, from..to, (at == last, is_denied));
        }
    }

    /// Compares the sides of a chain, of which is said whether it is the last one of its formula, and whether the formula itself denies it.
    fn check_chain(
        &mut self,
        chain: &Chain,
        formula: &Formula,
        trusted: std::ops::Range<usize>,
        (last, is_denied): (bool, bool),
    ) {
        self.report.tally.chains += 1;
        let before = self.report.tally.pairs;
        let denied = chain.asked || is_denied || question::is_meant_false(self.text, formula.span);
        if denied {
            self.count_unchecked(Some((UncheckedKind::Denied, String::new())), chain, false);
        } else {
            let obstacles: Vec<Option<Obstacle>> =
                chain.sides.iter().map(|side| evaluate_freely(&side.tokens, None).err()).collect();
            let known = |at: usize| matches!(obstacles[at], None | Some(Obstacle::NoValue(_)));
            let mut compared = vec![false; chain.sides.len()];
            let mut between = None;
            let open = self.open_pairs;
            for at in 1..chain.sides.len() {
                if trusted.contains(&(at - 1)) && trusted.contains(&at) {
                    let ends = last && at + 1 == chain.sides.len();
                    let pairs = self.report.tally.pairs;
                    let obstacle = self.compare_pair(chain, formula, at, known(at - 1) && known(at), ends);
                    // Of matrices, some entries may be compared and others not.
                    let whole = obstacle.is_none();
                    between = between.or(obstacle);
                    if self.report.tally.pairs > pairs && whole {
                        compared[at - 1..=at].fill(true);
                    }
                }
            }
            self.compare_with_row_before(chain, formula);
            let checked = self.report.tally.pairs > before;
            if (!checked || between.is_some() || compared.contains(&true)) && !is_unread(chain) {
                let outcome = ChainOutcome { text: self.text, chain, compared, obstacles, between };
                let open = self.open_pairs > open;
                let may_agree = open.then(|| (UncheckedKind::Notation, MAY_AGREE.to_owned()));
                self.count_unchecked(outcome.reason().or(may_agree), chain, checked);
            }
        }
        let checked = self.report.tally.pairs > before;
        self.report.tally.checked += usize::from(checked);
        let are_numbers = || chain.sides.iter().filter(|side| is_numeric(side)).count() >= 2;
        self.report.tally.checkable += usize::from(checked || are_numbers());
        self.known.learn(chain, formula.scope, self.options.name_policy);
    }

    /// Counts a chain that was not checked, or not all of it, if there is a reason.
    fn count_unchecked(&mut self, reason: Option<(UncheckedKind, String)>, chain: &Chain, partly: bool) {
        let Some((kind, name)) = reason else { return };
        if partly {
            self.report.tally.partly += 1;
        } else {
            self.report.not_checked.count(kind, if kind.has_names() { &name } else { "" }, 1);
        }
        #[cfg(feature = "cli")]
        {
            let source = if self.shows_source { self.text } else { "" };
            self.keep_unchecked(|_| UncheckedChain::new((kind, name), chain, source, partly));
        }
        #[cfg(not(feature = "cli"))]
        let _ = chain;
    }

    #[cfg(feature = "cli")]
    fn keep_unchecked(&mut self, chain: impl FnOnce(&str) -> UncheckedChain) {
        if self.options.unchecked && self.report.unchecked.len() < MOST_FINDINGS {
            self.report.unchecked.push(chain(self.text));
        }
    }

    /// Compares two neighbouring sides; what keeps them from being compared, if anything in them does.
    fn compare_pair(
        &mut self,
        chain: &Chain,
        formula: &Formula,
        at: usize,
        free: bool,
        ends: bool,
    ) -> Option<Obstacle> {
        let (left, right) = (&chain.sides[at - 1], &chain.sides[at]);
        let relation = right.relation.filter(|relation| *relation != Relation::Other)?;
        if left.tokens.is_empty() || right.tokens.is_empty() {
            return None;
        }
        let columns = number_columns::as_columns([left, right]);
        let are_matrices = !free && matrix_sides::has_matrix(left) && matrix_sides::has_matrix(right);
        let entries = columns.as_ref().map(|[left, right]| [left, right]).or(are_matrices.then_some([left, right]));
        if let Some(sides) = entries {
            return self.compare_matrices(chain, formula, sides, relation);
        }
        if has_several_currencies([left, right]) {
            return Some(Obstacle::Unclear("several currencies"));
        }
        if [left, right].into_iter().any(|side| loses_all_digits(&side.tokens)) {
            return Some(Obstacle::Unclear("more digits than are computed with"));
        }
        let bindings = if free { None } else { self.known.in_scope(formula.scope) };
        if !free {
            let bound = |side: &ChainSide| evaluate_freely(&side.tokens, bindings).is_ok();
            if bindings.is_none() || single_name(&left.tokens).is_some() || !bound(left) || !bound(right) {
                return None;
            }
        }
        let judgement = judge(&left.tokens, &right.tokens, relation, bindings);
        let has_result = |(_, right): &&(SideValue, SideValue)| free && right.is_literal();
        let values = judgement.values.as_ref().filter(has_result).cloned();
        let judgement = if agrees(&judgement) || judgement.verdict == ChainVerdict::CannotEvaluate {
            judgement
        } else {
            let pair = DifferingPair {
                text: self.text,
                formula,
                before: &chain.sides[..at - 1],
                left,
                right,
                relation,
                bindings,
                results: &self.results,
                is_free: free,
                ends_formula: ends,
                is_plain_text: self.is_plain_text,
                judgement,
            };
            pair.explain()
        };
        if let Some(values) = values {
            self.results.record(formula.scope, left, right, &values);
        }
        let obstacle = judgement.obstacle.clone();
        self.open_pairs += usize::from(judgement.verdict == ChainVerdict::Doubtful);
        self.record(formula, chain, [left, right], judgement, relation);
        obstacle
    }

    /// Compares each entry of a matrix with that of another one; what keeps them from being compared, if anything does.
    fn compare_matrices(
        &mut self,
        chain: &Chain,
        formula: &Formula,
        [left, right]: [&ChainSide; 2],
        relation: Relation,
    ) -> Option<Obstacle> {
        if let (Some(one), Some(other)) = (matrix_sides::only_matrix(left), matrix_sides::only_matrix(right))
            && permutation::are_same_in_rows(one, other)
        {
            return None;
        }
        let pairs = |multiply| matrix_sides::paired_entries(left, right, multiply).unwrap_or_default().into_iter();
        let loses_digits = |entry: &[ChainSide; 2]| entry.iter().any(|side| loses_all_digits(&side.tokens));
        let are_values = |entry: &[ChainSide; 2]| entry.iter().all(|of| evaluate_freely(&of.tokens, None).is_ok());
        let judged = |multiply: MatrixProduct| -> Vec<([ChainSide; 2], PairJudgement)> {
            let judge = |[one, other]: &[ChainSide; 2]| judge(&one.tokens, &other.tokens, relation, None);
            let entries = pairs(multiply).filter(|entry| !loses_digits(entry) && are_values(entry));
            entries.map(|entry| (entry.clone(), judge(&entry))).collect()
        };
        let mut entries = judged(MatrixProduct::RowsByColumns);
        if !entries.iter().all(|(_, judgement)| agrees(judgement)) {
            // Where all entries are zeros and ones, any number of ones may add to one.
            let is_boolean = matrix_sides::has_bits_alone(left) && matrix_sides::has_bits_alone(right);
            let may_be_or = |judgement: &PairJudgement| {
                let values = judgement.values.as_ref();
                let values = values.and_then(|(one, other)| one.number().ok().zip(other.number().ok()));
                is_boolean && values.is_some_and(|(one, other)| one.point > 1.0 && other.point == 1.0)
            };
            let signed = [left, right].into_iter().any(|side| side.tokens.iter().any(|token| token.is_one_of("×·*∘")));
            let by_entry = if signed { judged(MatrixProduct::EntryByEntry) } else { Vec::new() };
            if entries.iter().all(|(_, judgement)| agrees(judgement) || may_be_or(judgement)) {
                entries.retain(|(_, judgement)| agrees(judgement));
            } else if by_entry.len() == entries.len() && by_entry.iter().all(|(_, judgement)| agrees(judgement)) {
                entries = by_entry;
            }
        }
        // An equals sign between augmented matrices may stand for row operations.
        if [left, right].into_iter().all(matrix_sides::is_augmented) && !entries.iter().all(|(_, of)| agrees(of)) {
            return Some(Obstacle::Unclear("augmented matrices that differ"));
        }
        for ([left, right], judgement) in entries {
            self.record(formula, chain, [&left, &right], judgement, relation);
        }
        let too_long = pairs(MatrixProduct::RowsByColumns).any(|entry| loses_digits(&entry));
        too_long.then_some(Obstacle::Unclear("more digits than are computed with"))
    }

    /// Compares `v = 151.2` with `v = 500 sin 17.6°` in the row before.
    fn compare_with_row_before(&mut self, chain: &Chain, formula: &Formula) {
        let before = self.before.take();
        let Some((name, Some(value))) = assignment(chain) else { return };
        let (name, Some(last)) = (name.to_owned(), chain.sides.last()) else { return };
        if let Some(before) = before
            && before.name == name
            && chain.sides.len() == 2
            && value.literal == Literal::Number
            && chain.starts_row
            && surroundings::are_adjacent(self.text, before.span, last.span)
        {
            let judgement = judge(&before.side.tokens, &last.tokens, Relation::Equal, None);
            self.record(formula, chain, [&before.side, last], judgement, Relation::Equal);
            return;
        }
        if !value.is_literal() {
            self.before = Some(AssignedSide { name, side: last.clone(), span: last.span });
        }
    }

    fn record(
        &mut self,
        formula: &Formula,
        chain: &Chain,
        [left, right]: [&ChainSide; 2],
        judgement: PairJudgement,
        relation: Relation,
    ) {
        let tally = &mut self.report.tally;
        tally.verdicts[judgement.verdict as usize] += 1;
        if judgement.verdict == ChainVerdict::CannotEvaluate {
            return;
        }
        tally.pairs += 1;
        let list = ReportSection::for_verdict(judgement.verdict, !judgement.used.is_empty());
        if list == ReportSection::Agreeing && !self.options.agreeing {
            return;
        }
        if self.report.findings.len() >= MOST_FINDINGS {
            return;
        }
        let place = PlacedPair { text: self.text, formula, chain, left, right };
        let doubt = (list == ReportSection::Numbers).then(|| {
            let runs_on = || runs_on(chain, right, &judgement).then_some(Doubt::Cut);
            place.doubt(&judgement).or_else(runs_on)
        });
        let doubt = doubt.flatten();
        let wanted =
            list == ReportSection::Numbers && doubt.is_none() && self.report.findings.len() < self.options.hints;
        let hint = wanted.then(|| {
            let neighbours = neighbours(chain, left, right);
            let around = text_around(self.text, formula.span);
            let judgement = &judgement;
            HintSearch { left, right, relation, judgement, neighbours, around }.hint(&mut self.budget)
        });
        let hint = hint.flatten().filter(|hint| !hint.stands_in(self.text));
        let mut finding = ChainFinding::new(chain, left, right, &judgement, list, hint);
        match doubt {
            Some(doubt) => demote_to_doubt(&mut finding, doubt),
            None if list == ReportSection::Numbers => {
                let at = self.report.findings.len();
                self.factors.record(at, formula.span, &judgement, [&finding.left, &finding.right]);
                let has_hint = self.options.hints == 0 || finding.hint.is_some();
                self.weighed.record(at, judgement.values.as_ref(), has_hint);
            }
            None => {}
        }
        self.report.findings.push(finding);
    }
}
