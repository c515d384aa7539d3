//! A document, formula by formula: what was checked, and what was found.

use crate::binding::{Follow, Known, assignment, single_name};
use crate::chain::{Chain, Relation, Side, chains};
use crate::doubt::{Doubt, Factors, Place};
use crate::effort::{self, Effort};
use crate::explanation::{DifferingPair, agrees};
use crate::finding::{Finding, List};
use crate::hint;
use crate::join::has_letters;
use crate::reader::{self, Definitions, Format, Formula, From, Running, Unreadable, Written};
use crate::surroundings;
use crate::token::{Kind, Span, any, has_number};
use crate::unrounded::Results;
use crate::value::{Evaluated, Literal, Obstacle, Value};
use crate::verdict::{Judgement, Verdict, evaluated, judge};

/// What to look for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options<'d> {
    /// Which values of names are put into formulas.
    pub follow: Follow,
    /// Whether pairs that agree are kept, too.
    pub agreeing: bool,
    /// Most findings for which a hint is searched, the first ones: the search takes longer than the rest.
    pub hints: usize,
    /// Most tokens that are evaluated in the search for hints: what is not searched for is not offered.
    pub hint_effort: usize,
    /// What other LaTeX texts define for this one: its preamble, packages or classes. A definition of its own counts before them.
    /// Texts in other formats are read without.
    pub definitions: Option<&'d Definitions>,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self {
            follow: Follow::default(),
            agreeing: false,
            hints: MOST_HINTS,
            hint_effort: hint::MOST_FOR_ALL,
            definitions: None,
        }
    }
}

/// How much of a document was checked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Bytes of the document.
    pub bytes: usize,
    /// Formulas, and lines that may be one.
    pub formulas: usize,
    /// Formulas and lines that are not read to their end, since they are too long, nest too deeply, or have macros that never end.
    pub unread: usize,
    /// Chains of equal sides with a number in them.
    pub chains: usize,
    /// Chains with two sides that are numbers and have no letters: what arithmetic can check.
    pub checkable: usize,
    /// Chains of which at least one pair of sides was compared.
    pub checked: usize,
    /// Pairs of neighbouring sides that were compared.
    pub pairs: usize,
    /// Pairs with each verdict, in the order of [`Verdict::ALL`].
    pub verdicts: [usize; 10],
    /// Differences that are set aside as doubts, of those that are kept.
    pub doubts: usize,
}

impl Tally {
    /// Pairs with a verdict.
    pub fn with(&self, verdict: Verdict) -> usize {
        self.verdicts[verdict as usize]
    }

    /// Adds the counts of another document.
    pub fn add(&mut self, other: &Self) {
        self.bytes += other.bytes;
        self.formulas += other.formulas;
        self.unread += other.unread;
        self.chains += other.chains;
        self.checkable += other.checkable;
        self.checked += other.checked;
        self.pairs += other.pairs;
        self.doubts += other.doubts;
        for (mine, its) in self.verdicts.iter_mut().zip(other.verdicts) {
            *mine += its;
        }
    }
}

/// What proofreading a document found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// What does not agree, in the order of the text, in all lists.
    pub findings: Vec<Finding>,
    /// How much was checked.
    pub tally: Tally,
    /// What it took.
    pub effort: Effort,
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
pub fn proofread(text: &str, format: Format, options: Options<'_>) -> Result<Report, Unreadable> {
    let steps = effort::steps();
    let lines = Running::of(text, format);
    let mut check = Check {
        text,
        options,
        report: Report::default(),
        known: Known::default(),
        before: None,
        results: Results::default(),
        factors: Factors::default(),
        budget: options.hint_effort,
    };
    if options.follow == Follow::Once && text.len() <= ONE_PROBLEM {
        let known = &mut check.known;
        let mut count = |formula: Formula| chains(&formula.tokens).iter().for_each(|chain| known.count(chain));
        reader::read_with(text, format, options.definitions, &lines, &mut |formula, _| count(formula))?;
    } else if options.follow == Follow::Once {
        check.options.follow = Follow::Never;
    }
    let mut in_lines = None;
    reader::read_with(text, format, options.definitions, &lines, &mut |formula, from| {
        if from == From::Lines && in_lines.is_none() {
            in_lines = Some(check.report.findings.len());
            (check.text, check.before) = (&lines.text, None);
        }
        check.formula(&formula);
    })?;
    for at in check.factors.habits() {
        set_aside(&mut check.report.findings[at], Doubt::Habit);
    }
    if let Some(at) = in_lines {
        let findings = &mut check.report.findings;
        findings[at..].iter_mut().for_each(|finding| finding.place(&|span| lines.place(span)));
        findings.sort_by_key(|finding| finding.span);
    }
    let hints = options.hint_effort - check.budget;
    check.report.effort = Effort { steps: effort::steps().saturating_sub(steps), hints };
    check.report.tally.bytes = text.len();
    check.report.tally.doubts = check.report.findings.iter().filter(|of| of.list == List::Doubts).count();
    Ok(check.report)
}

fn set_aside(finding: &mut Finding, doubt: Doubt) {
    finding.list = List::Doubts;
    finding.doubt = Some(doubt);
    finding.hint = None;
}

/// Whether it is known what a side is worth, or that it has no value.
fn is_known(evaluated: &Evaluated<Value>) -> bool {
    matches!(evaluated, Ok(_) | Err(Obstacle::NoValue(_)))
}

/// Documents up to this many bytes are taken for one problem whose names keep their meaning.
const ONE_PROBLEM: usize = 20_000;

/// A chain that gave a computed value to a name.
struct Assigned {
    name: String,
    side: Side,
    span: Span,
}

struct Check<'t> {
    text: &'t str,
    options: Options<'t>,
    report: Report,
    known: Known,
    before: Option<Assigned>,
    /// The results of the example or section so far.
    results: Results,
    /// The factors between the sides that differ.
    factors: Factors,
    /// What the search for hints may still cost.
    budget: usize,
}

impl Check<'_> {
    fn formula(&mut self, formula: &Formula) {
        self.report.tally.formulas += 1;
        self.report.tally.unread += usize::from(any(&formula.tokens, &Kind::is_unread));
        let chains = chains(&formula.tokens);
        let numeric = |chain: &&Chain| {
            let compared = chain.sides.iter().skip(1).any(|side| side.relation != Some(Relation::Other));
            compared && chain.sides.iter().any(|side| has_number(&side.tokens))
        };
        let last = chains.len().saturating_sub(1);
        for (at, chain) in chains.iter().enumerate() {
            if !numeric(&chain) {
                self.before = None;
                continue;
            }
            let trusted = chain.sides.len();
            // In running text, what comes before a sign of a sum or a product was not read.
            let lacks_its_start = formula.written == Written::Plain
                && chain.sides[0].tokens.first().is_some_and(|first| first.is_one_of("+×·/"));
            // A digit close before a formula is a factor that was left outside.
            let glued = formula.written == Written::Formula
                && self
                    .text
                    .get(..formula.span.start as usize)
                    .is_some_and(|before| before.ends_with(|c: char| c.is_ascii_digit()));
            let from = usize::from((at == 0 && (formula.continues || glued)) || lacks_its_start);
            let to = trusted - usize::from(at == last && formula.goes_on);
            self.chain(chain, formula, from..to, at == last);
        }
    }

    /// Compares the sides of a chain; `last` says that it is the last one of its formula.
    fn chain(&mut self, chain: &Chain, formula: &Formula, trusted: std::ops::Range<usize>, last: bool) {
        self.report.tally.chains += 1;
        let numbers = |side: &&Side| has_number(&side.tokens) && !has_letters(&side.tokens);
        self.report.tally.checkable += usize::from(chain.sides.iter().filter(numbers).count() >= 2);
        let compared = self.report.tally.pairs;
        if !chain.asked && !surroundings::meant_false(self.text, formula.span) {
            let free: Vec<bool> = chain.sides.iter().map(|side| is_known(&evaluated(&side.tokens, None))).collect();
            for at in 1..chain.sides.len() {
                if trusted.contains(&(at - 1)) && trusted.contains(&at) {
                    let ends = last && at + 1 == chain.sides.len();
                    self.pair(chain, formula, at, free[at - 1] && free[at], ends);
                }
            }
            self.repeated(chain, formula);
        }
        self.report.tally.checked += usize::from(self.report.tally.pairs > compared);
        self.known.learn(chain, formula.scope, self.options.follow);
    }

    fn pair(&mut self, chain: &Chain, formula: &Formula, at: usize, free: bool, ends: bool) {
        let (left, right) = (&chain.sides[at - 1], &chain.sides[at]);
        let Some(relation) = right.relation.filter(|relation| *relation != Relation::Other) else { return };
        if left.tokens.is_empty() || right.tokens.is_empty() {
            return;
        }
        let bindings = if free { None } else { self.known.in_scope(formula.scope) };
        if !free {
            let bound = |side: &Side| evaluated(&side.tokens, bindings).is_ok();
            if bindings.is_none() || single_name(&left.tokens).is_some() || !bound(left) || !bound(right) {
                return;
            }
        }
        let judgement = judge(&left.tokens, &right.tokens, relation, bindings);
        let has_result = |(_, right): &&(Value, Value)| free && right.is_literal();
        let values = judgement.values.as_ref().filter(has_result).cloned();
        let judgement = if agrees(&judgement) || judgement.verdict == Verdict::CannotEvaluate {
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
                judgement,
            };
            pair.explained()
        };
        if let Some(values) = values {
            self.results.note(formula.scope, left, right, &values);
        }
        self.note(formula, chain, [left, right], judgement, relation);
    }

    /// Compares `v = 151.2` with `v = 500 sin 17.6°` in the row before.
    fn repeated(&mut self, chain: &Chain, formula: &Formula) {
        let before = self.before.take();
        let Some((name, Some(value))) = assignment(chain) else { return };
        let (name, Some(last)) = (name.to_owned(), chain.sides.last()) else { return };
        if let Some(before) = before
            && before.name == name
            && chain.sides.len() == 2
            && value.literal == Literal::Number
            && chain.starts_row
            && surroundings::adjoin(self.text, before.span, last.span)
        {
            let judgement = judge(&before.side.tokens, &last.tokens, Relation::Equal, None);
            self.note(formula, chain, [&before.side, last], judgement, Relation::Equal);
            return;
        }
        if !value.is_literal() {
            self.before = Some(Assigned { name, side: last.clone(), span: last.span });
        }
    }

    fn note(
        &mut self,
        formula: &Formula,
        chain: &Chain,
        [left, right]: [&Side; 2],
        judgement: Judgement,
        relation: Relation,
    ) {
        let tally = &mut self.report.tally;
        tally.verdicts[judgement.verdict as usize] += 1;
        if judgement.verdict == Verdict::CannotEvaluate {
            return;
        }
        tally.pairs += 1;
        let list = List::of(judgement.verdict, !judgement.used.is_empty());
        if list == List::Agreeing && !self.options.agreeing {
            return;
        }
        if self.report.findings.len() >= MOST_FINDINGS {
            return;
        }
        let place = Place { text: self.text, formula, chain, left, right };
        let doubt = (list == List::Numbers).then(|| place.doubt(&judgement)).flatten();
        let wanted = list == List::Numbers && doubt.is_none() && self.report.findings.len() < self.options.hints;
        let hint = wanted.then(|| hint::hint(left, right, relation, &judgement, &mut self.budget)).flatten();
        let hint = hint.filter(|hint| !hint.stands_in(self.text));
        let mut finding = Finding::new(chain, left, right, &judgement, list, hint);
        match doubt {
            Some(doubt) => set_aside(&mut finding, doubt),
            None if list == List::Numbers => {
                let at = self.report.findings.len();
                self.factors.note(at, formula.span, &judgement, [&finding.left, &finding.right]);
            }
            None => {}
        }
        self.report.findings.push(finding);
    }
}
