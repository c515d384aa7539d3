//! The first claims of a text, one of each kind if it has one: an offer to whoever goes on from there, and no judgement of the text.

use super::SourceText;
use super::sentences::{Sentence, sentences};
use geneva_evidence::{Decimal, number_tokens, tex};
use proofread::reader::read;
use std::ops::Range;

/// What sort of claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FirstKind {
    Value,
    Equation,
    Statement,
    Figure,
}

/// A claim as the text makes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct FirstClaim {
    pub kind: FirstKind,
    /// The line of the file, from 0.
    pub line: usize,
    /// Where it begins in what the line shows, in bytes.
    pub at: usize,
    /// The printed characters.
    pub printed: String,
    /// The printed unit; empty for none.
    pub unit: String,
}

impl FirstKind {
    /// All kinds, in the order in which they are looked for: a sentence must not have the numbers of another claim.
    const ALL: [Self; 4] = [Self::Value, Self::Equation, Self::Figure, Self::Statement];

    /// The end of the ids of such claims.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Value => "first-number",
            Self::Equation => "first-equation",
            Self::Statement => "first-statement",
            Self::Figure => "first-figure",
        }
    }
}

impl FirstClaim {
    fn new(kind: FirstKind, line: usize, at: usize, printed: &str) -> Self {
        Self { kind, line, at, printed: printed.to_owned(), unit: String::new() }
    }

    /// The numbers that it accounts for.
    pub(super) fn numbers(&self) -> Vec<String> {
        let unit =
            number_tokens(&self.unit).into_iter().filter(|token| token.starts_with(|c: char| c.is_ascii_digit()));
        number_tokens(&self.printed).into_iter().chain(unit).collect()
    }
}

/// At most one claim of each kind, in the order of the text. Their numbers are in their lines, in this order.
pub(super) fn first_claims(source: &SourceText) -> Vec<FirstClaim> {
    let sentences = sentences(&source.shown);
    let mut found: Vec<FirstClaim> = Vec::new();
    for kind in FirstKind::ALL {
        let candidates: Vec<FirstClaim> = match kind {
            FirstKind::Value => values(&source.shown),
            FirstKind::Equation => equations(source),
            FirstKind::Figure => as_claims(kind, sentences.iter().filter(|sentence| sentence.names_a_figure())),
            FirstKind::Statement => {
                let (digits, words): (Vec<_>, Vec<_>) = sentences
                    .iter()
                    .filter(|sentence| sentence.has_numbers())
                    .partition(|sentence| sentence.has_digits());
                as_claims(kind, digits.into_iter().chain(words))
            }
        };
        let fitting = candidates.into_iter().find(|candidate| {
            let mut with = found.clone();
            with.push(candidate.clone());
            with.sort_by_key(|claim| (claim.line, claim.at));
            fits(&source.shown, &with)
        });
        found.extend(fitting);
    }
    found.sort_by_key(|claim| (claim.line, claim.at));
    found
}

/// Whether claims in their order print numbers of their lines in this order, none of them twice.
fn fits(shown: &[String], claims: &[FirstClaim]) -> bool {
    let mut ahead: (usize, Vec<String>) = (usize::MAX, Vec::new());
    claims.iter().all(|claim| {
        if ahead.0 != claim.line {
            ahead = (claim.line, shown.get(claim.line).map_or_else(Vec::new, |line| number_tokens(line)));
        }
        let (numbers, line) = (claim.numbers(), &ahead.1);
        let place = (0..=line.len().saturating_sub(numbers.len())).find(|at| line[*at..].starts_with(&numbers));
        match place {
            Some(at) => {
                ahead.1 = line[at + numbers.len()..].to_vec();
                true
            }
            None => false,
        }
    })
}

fn as_claims<'a>(kind: FirstKind, sentences: impl Iterator<Item = &'a Sentence>) -> Vec<FirstClaim> {
    sentences.map(|sentence| FirstClaim::new(kind, sentence.line, sentence.at, &sentence.text)).collect()
}

/// Words before a number that is a label or a version, and no quantity.
const BEFORE_LABELS: [&str; 21] = [
    "fig",
    "figs",
    "figure",
    "figures",
    "eq",
    "eqs",
    "equation",
    "equations",
    "section",
    "sec",
    "chapter",
    "ch",
    "table",
    "version",
    "by",
    "by-sa",
    "example",
    "problem",
    "exercise",
    "theorem",
    "appendix",
];

/// The numbers with a decimal point that are no labels, each with its unit if that is known.
fn values(shown: &[String]) -> Vec<FirstClaim> {
    let mut found = Vec::new();
    for (number, line) in shown.iter().enumerate() {
        let is_heading =
            line.trim_start().starts_with(['#', '[']) || line.contains("section{") || line.contains("chapter{");
        for place in if is_heading { Vec::new() } else { decimals(line) } {
            let before = line[..place.start].trim_end_matches([' ', '~', '(', '.', '§']);
            let word = before.rsplit(|c: char| !c.is_alphanumeric() && c != '-').next().unwrap_or_default();
            // What opens a line is the number of a heading more often than a quantity.
            let opens = before.trim().is_empty() && line[place.end..].trim_start().starts_with(char::is_uppercase);
            let is_label = BEFORE_LABELS.contains(&word.to_lowercase().as_str()) || line[..place.start].ends_with('§');
            if opens || is_label {
                continue;
            }
            let claim = FirstClaim::new(FirstKind::Value, number, place.start, &line[place.clone()]);
            if let Some(unit) = unit_behind(&line[place.end..]) {
                found.push(FirstClaim { unit, ..claim.clone() });
            }
            found.push(claim);
        }
    }
    found
}

/// Where numbers with digits on both sides of one point are in a line.
fn decimals(line: &str) -> Vec<Range<usize>> {
    let is_numeral = |c: char| c.is_ascii_digit() || ".,".contains(c);
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = line[at..].find(|c: char| c.is_ascii_digit()).map(|next| at + next) {
        let run = line[start..].find(|c: char| !is_numeral(c)).map_or(line.len(), |end| start + end);
        let end = start + line[start..run].trim_end_matches(['.', ',']).len();
        let numeral = &line[start..end];
        let is_whole = !line[..start].ends_with(|c: char| c.is_alphanumeric() || "._^-{".contains(c));
        // A digit in braces behind a letter is an index.
        let goes_on =
            line[end..].starts_with(|c: char| c.is_alphabetic() && !c.is_ascii_lowercase() || "}-_".contains(c));
        let is_decimal = numeral.split_once('.').is_some_and(|(whole, part)| !whole.is_empty() && !part.contains('.'));
        if is_decimal && is_whole && !goes_on && numeral.parse::<Decimal>().is_ok() {
            found.push(start..end);
        }
        at = run;
    }
    found
}

/// Units that are words of English more often.
const WORDS: [&str; 8] = ["a", "in", "at", "as", "are", "am", "d", "h"];

/// The unit behind a number, if it is one that the proofreader knows.
fn unit_behind(rest: &str) -> Option<String> {
    let rest = rest.trim_start_matches([' ', '~', '\u{a0}', '\u{202f}']);
    let rest =
        ["\\,", "\\;", "\\ ", "\\:"].iter().find_map(|space| rest.strip_prefix(space)).unwrap_or(rest).trim_start();
    // In a page, an exponent is raised.
    let raised = [("^(2)", "²"), ("^(3)", "³"), ("^(-1)", "⁻¹"), ("^(−1)", "⁻¹")];
    let rest = &raised.iter().fold(rest.to_owned(), |rest, (shown, sign)| rest.replace(shown, sign));
    let in_braces = ["\\mathrm{", "\\text{", "\\textrm{", "{\\rm "].iter().find_map(|opens| rest.strip_prefix(opens));
    let word = match in_braces {
        Some(inside) => inside.split('}').next()?.trim(),
        None => rest.split(|c: char| c.is_whitespace() || ",;:()$\\{}=<>|".contains(c)).next()?.trim_end_matches('.'),
    };
    let is_unit = !word.is_empty() && !WORDS.contains(&word) && proofread::unit_named(word).is_some();
    is_unit.then(|| word.to_owned())
}

/// The equations in TeX that stand in one line: displays first, and those that the engine's reader of formulas reads.
fn equations(source: &SourceText) -> Vec<FirstClaim> {
    let mut spans = Vec::new();
    // What can be shown line by line can be read.
    let _ = read(&source.text, source.format, &mut |formula| spans.push(formula.span.range()));
    spans.sort_by_key(|span| span.start);
    let mut ranked: Vec<(bool, bool, FirstClaim)> = Vec::new();
    for span in spans {
        let Some((is_inline, printed, offset)) = source.text.get(span.clone()).and_then(equation_of) else { continue };
        let line = source.text[..span.start + offset].matches('\n').count();
        let Some(at) = source.shown.get(line).and_then(|shown| shown.find(printed)) else { continue };
        if geneva_press::formula::formula(printed, false).is_ok() {
            let is_unread = tex::Display::read(printed).is_err();
            ranked.push((is_unread, is_inline, FirstClaim::new(FirstKind::Equation, line, at, printed)));
        }
    }
    ranked.sort_by_key(|(is_unread, is_inline, _)| (*is_unread, *is_inline));
    ranked.into_iter().map(|(_, _, claim)| claim).collect()
}

/// An equation without its marks: whether it is within a line of text, its characters, and where they begin.
fn equation_of(formula: &str) -> Option<(bool, &str, usize)> {
    let marks = [("$$", "$$", false), ("\\[", "\\]", false), ("$", "$", true), ("\\(", "\\)", true)];
    let marked = marks
        .iter()
        .find_map(|(open, close, is_inline)| Some((*is_inline, formula.strip_prefix(open)?.strip_suffix(close)?)));
    let (is_inline, inside) = marked.or_else(|| {
        let (_, inside) = formula.strip_prefix("\\begin{equation")?.split_once('}')?;
        Some((false, inside.rsplit_once("\\end{")?.0))
    })?;
    let labelled = inside.trim();
    let unlabelled = match labelled.strip_prefix("\\label{") {
        Some(rest) => rest.split_once('}')?.1,
        None => labelled.split("\\label{").next()?,
    };
    let printed = unlabelled.trim().trim_end_matches(['.', ',', ';']).trim_end();
    let (left, right) = printed.split_once('=')?;
    let is_letter = |c: char| c.is_alphabetic();
    let is_law = left.contains(is_letter) && right.contains(is_letter) && !printed.contains(['\n', '&', '#', '%']);
    let has_words = ["\\\\", "\\text", "\\mathrm", "\\rm", "\\SI", "\\si", "\\qty", "\\num", "\\tag", "\\quad"];
    let is_one = is_law && !has_words.iter().any(|word| printed.contains(word));
    is_one.then_some((is_inline, printed, formula.find(printed)?))
}
