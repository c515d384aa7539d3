//! The single edit that makes two sides agree, if one is much likelier than all others.

use crate::join::chain::{ChainSide, Relation};
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::verdict::{PairJudgement, is_agreed};
use crate::tell::edit::{Edit, EditKind, variants, whole_side};
use crate::token::{Span, Token, TokenKind, trim_space};
use std::ops::ControlFlow;

/// An edit of one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Hint {
    /// What to change, in words.
    pub words: String,
    /// Where.
    pub at: Span,
    /// The kind of slip that the edit takes back.
    pub(crate) kind: EditKind,
}

impl Hint {
    /// Whether the text has at the place already what the hint offers, so that the text was misread.
    pub(crate) fn stands_in(&self, text: &str) -> bool {
        let plain = |text: &str| text.chars().filter(|c| !c.is_whitespace() && !"{}".contains(*c)).collect::<String>();
        let printed = text.get(self.at.range()).map(plain);
        offered(&self.words).is_some_and(|offered| printed.is_some_and(|printed| printed == plain(offered)))
    }
}

/// What the words of a hint offer, if it is something to be put in.
fn offered(words: &str) -> Option<&str> {
    Some(words.strip_prefix('`')?.split_once('`')?.0)
}

/// Two sides that do not agree, with what is known about them.
pub(crate) struct HintSearch<'s> {
    pub left: &'s ChainSide,
    pub right: &'s ChainSide,
    pub relation: Relation,
    pub judgement: &'s PairJudgement,
    /// The sides of the chain before the left one and behind the right one, if they are equal to these.
    pub neighbours: [Option<&'s ChainSide>; 2],
    /// The text around the chain, without the chain.
    pub around: [&'s str; 2],
}

/// Most edits of a side that are tried.
const MOST: usize = 2500;

/// Longest sides for which an edit is searched, in tokens: of more than these, one is hardly ever the only one.
const LONGEST: usize = 200;

/// How much a search may cost, in tokens that are evaluated: a few tenths of a second for one finding, and a few seconds for a
/// document.
const MOST_FOR_ONE: usize = 200_000;
/// The budget of a document.
pub(crate) const MOST_FOR_ALL: usize = 600_000;

/// How likely it is, before one looks at the edits, that no single edit was the slip; for a result of one digit, beside the weights of
/// [`weight`].
const NO_EDIT: f64 = 0.3;

/// How much of all that may have happened the offered edit must be.
const LEAST_SHARE: f64 = 0.75;

/// How much likelier an edit is if it offers a number that the text prints elsewhere.
const PRINTED_ELSEWHERE: f64 = 20.0;

/// How much less likely an edit of an operand is if the text prints the operand elsewhere as it is.
const PRINTED_TWICE: f64 = 3.0;

/// How many tokens there are, with those inside others.
fn size(tokens: &[Token]) -> usize {
    tokens.iter().map(|token| 1 + token.inner().map(size).sum::<usize>()).sum()
}

/// How many places of each kind both sides have at which a slip may be.
#[derive(Default)]
struct Places {
    numbers: f64,
    digits: f64,
    powers: f64,
    words: f64,
}

impl Places {
    fn count(&mut self, tokens: &[Token]) {
        for token in tokens {
            match &token.kind {
                // The ten of a power of ten is no place for a slip of a digit.
                TokenKind::Number(text) if text != "10" => {
                    self.numbers += 1.0;
                    self.digits += text.bytes().filter(u8::is_ascii_digit).count() as f64;
                }
                TokenKind::Power(_) => self.powers += 1.0,
                TokenKind::Word(_) => self.words += 1.0,
                _ => {}
            }
            if !matches!(token.kind, TokenKind::Power(_)) {
                token.inner().for_each(|inner| self.count(inner));
            }
        }
    }

    /// How likely an edit is among all slips, before one looks whether the sides agree with it. The weights of the kinds are about
    /// those of the misprints in the folder `judged`.
    fn weight(&self, kind: EditKind) -> f64 {
        let digits = self.digits.max(1.0);
        match kind {
            EditKind::Comma(true) | EditKind::Caret => 0.5,
            EditKind::Comma(false) => 0.05,
            EditKind::Sign => 0.15,
            EditKind::Factor => 0.05,
            EditKind::ExponentSign => 0.08 / self.powers.max(1.0),
            EditKind::Exponent(1) => 0.06 / self.powers.max(1.0),
            EditKind::Exponent(_) => 0.02 / self.powers.max(1.0),
            EditKind::OtherExponent => 0.0008 / self.powers.max(1.0),
            EditKind::UnitPower => 0.0005 / self.words.max(1.0),
            EditKind::Square => 0.02 / self.numbers.max(1.0),
            EditKind::OutsideBracket => 0.1,
            EditKind::Shift(1) => 0.08 / self.numbers.max(1.0),
            EditKind::Shift(_) => 0.03 / self.numbers.max(1.0),
            EditKind::Prefix => 0.03 / self.words.max(1.0),
            EditKind::Digit => 0.25 / (9.0 * digits),
            EditKind::Swap => 0.1 / digits,
            EditKind::Lost => 0.02 / (3.0 * digits),
            EditKind::LostAny => 0.01 / (8.0 * digits),
            EditKind::Extra => 0.03 / digits,
            EditKind::ExtraAny => 0.005 / (9.0 * digits),
            EditKind::PlusMinus => 0.003,
        }
    }
}

/// The significant digits that a side prints, without most of the zeros at the end of integers and without powers of ten.
fn printed_digits(tokens: &[Token]) -> usize {
    let of = |(at, token): (usize, &Token)| match &token.kind {
        TokenKind::Number(text) => {
            let is_raised = tokens.get(at + 1).is_some_and(|next| matches!(next.kind, TokenKind::Power(_)));
            let digits: String = text.chars().filter(char::is_ascii_digit).collect();
            let digits = digits.trim_start_matches('0');
            // Half of the zeros at the end of an integer may count.
            let sure = digits.trim_end_matches('0').len();
            match text.contains('.') {
                _ if is_raised && text == "10" => 0,
                true => digits.len(),
                false => sure + (digits.len() - sure) / 2,
            }
        }
        TokenKind::Power(_) => 0,
        _ => token.inner().map(printed_digits).sum(),
    };
    tokens.iter().enumerate().map(of).sum()
}

/// Whether the right side is one number, and the left one adds to this very number, so that it was copied and not computed.
fn copies_operand(left: &[Token], right: &[Token]) -> bool {
    let [number] = trim_space(right) else { return false };
    let is_copy = |token: &Token| token.number().is_some() && token.number() == number.number();
    left.iter().any(is_copy) && left.iter().any(|token| token.is_one_of("+-"))
}

/// Whether a place is in a sum under a root: where the whole sum differs, a digit of one of its terms is no likely slip.
fn is_in_sum_under_root(side: &[Token], at: Span) -> bool {
    let is_sum = |of: &[Token]| of.iter().any(|token| token.is_one_of("+-"));
    side.iter().any(|token| {
        matches!(&token.kind, TokenKind::Root(of, _) if is_sum(of) && has_place(of, at))
            || token.inner().any(|inner| is_in_sum_under_root(inner, at))
    })
}

/// Whether a token, or one inside it, is at a place.
fn has_place(tokens: &[Token], at: Span) -> bool {
    let covers = |token: &Token| token.span.start <= at.start && at.end <= token.span.end;
    tokens.iter().any(|token| covers(token) || token.inner().any(|inner| has_place(inner, at)))
}

/// An edit that fits, and how likely it is.
struct Fit {
    hint: Hint,
    /// The side that is edited: 0 for the left and 1 for the right one.
    side: usize,
    weight: f64,
    /// How likely it is that it fits by accident.
    accident: f64,
}

impl HintSearch<'_> {
    /// The one edit that most likely was the slip; what the search costs is taken from `budget`.
    ///
    /// Each edit that makes the sides agree is as likely as its kind, over the number of places where it could have happened. Against them
    /// stands that something else happened, and that the edit fits by accident: with a result of few digits, that is likely.
    /// If only the last digit differs, it must be one of the printed result: of a digit as far behind in an operand, this is no
    /// evidence.
    pub(crate) fn hint(&self, budget: &mut usize) -> Option<Hint> {
        let values = self.judgement.values.as_ref();
        let is_literal = values.map_or([false, true], |(left, right)| [left.is_literal(), right.is_literal()]);
        let printed = if is_literal[1] || !is_literal[0] { 1 } else { 0 };
        let only =
            matches!(self.judgement.verdict, ChainVerdict::LastDigit | ChainVerdict::Truncated).then_some(printed);
        let sides = [self.left, self.right];
        let sizes = sides.map(|side| size(&side.tokens));
        if sizes.into_iter().any(|size| size > LONGEST) {
            return None;
        }
        let each = sizes[0] + sizes[1];
        let mut places = Places::default();
        sides.into_iter().for_each(|side| places.count(&side.tokens));
        let digits = sides.map(|side| printed_digits(&side.tokens));
        let held = self.held_neighbours();
        let mut spent = 0;
        let mut is_spent = false;
        let mut found: Vec<Fit> = Vec::new();
        for (which, side) in sides.into_iter().enumerate() {
            let mut tried = 0;
            let mut tries = |edit: Edit| {
                tried += 1;
                spent += each;
                *budget = budget.saturating_sub(each);
                // Without having tried all edits, none is known to be the likeliest.
                is_spent = spent > MOST_FOR_ONE || *budget == 0 || tried > MOST;
                if is_spent {
                    return ControlFlow::Break(());
                }
                if self.fits(which, &edit.tokens, &held) {
                    let is_result = is_literal[which] && which == printed;
                    let of_side = match edit.kind {
                        // A result that is a thousand times too small has other causes more often.
                        EditKind::Comma(_) if is_result => 0.1,
                        EditKind::Prefix | EditKind::UnitPower => 1.0,
                        _ if is_result => 2.0,
                        _ => 1.0,
                    };
                    let weight = places.weight(edit.kind) * of_side;
                    let weight = weight * self.evidence_around(&edit.words, is_result);
                    let known = match is_literal {
                        [false, false] => digits[0].min(digits[1]),
                        _ if is_result => printed_digits(&edit.tokens),
                        _ => digits[printed],
                    };
                    // Where a power of ten agrees that did not, that is as good as a digit.
                    let known = known + usize::from(edit.kind.is_of_size());
                    let accident = NO_EDIT * libm::pow(10.0, -(known.clamp(1, 8) as f64));
                    let hint = Hint { words: edit.words, at: edit.at, kind: edit.kind };
                    found.push(Fit { hint, side: which, weight, accident });
                }
                ControlFlow::Continue(())
            };
            let all = variants(&side.tokens, is_literal[which], &mut tries);
            // On one side is as good as on the other.
            if all.is_continue() && which == 0 {
                let _ = whole_side(side, &mut tries);
            }
            if is_spent {
                return None;
            }
        }
        let all: f64 = found.iter().map(|fit| fit.weight).sum();
        let best = found.into_iter().reduce(|best, fit| if fit.weight > best.weight { fit } else { best })?;
        let is_copied = best.side == 0 && copies_operand(&self.left.tokens, &self.right.tokens);
        if is_copied || is_in_sum_under_root(&sides[best.side].tokens, best.hint.at) {
            return None;
        }
        let is_likely = best.weight >= LEAST_SHARE * (all + best.accident) && only.is_none_or(|only| only == best.side);
        is_likely.then_some(best.hint)
    }

    /// Which of the neighbours agree with the sides as they are.
    fn held_neighbours(&self) -> [Option<&ChainSide>; 2] {
        let [before, behind] = self.neighbours;
        [
            before.filter(|before| is_agreed(&before.tokens, &self.left.tokens, Relation::Equal)),
            behind.filter(|behind| is_agreed(&self.right.tokens, &behind.tokens, Relation::Equal)),
        ]
    }

    /// Whether the sides agree with an edit in one of them, and a neighbour with the edited one if it did before.
    fn fits(&self, which: usize, edited: &[Token], held: &[Option<&ChainSide>; 2]) -> bool {
        let sides = if which == 0 { [edited, &self.right.tokens] } else { [&self.left.tokens, edited] };
        is_agreed(sides[0], sides[1], self.relation)
            && held[which].is_none_or(|other| match which {
                0 => is_agreed(&other.tokens, edited, Relation::Equal),
                _ => is_agreed(edited, &other.tokens, Relation::Equal),
            })
    }

    /// How much likelier an edit is by what the text prints around the chain: the number that it offers, or the one that it
    /// replaces.
    fn evidence_around(&self, words: &str, is_result: bool) -> f64 {
        let offers = offered(words).is_some_and(|offered| self.is_printed_elsewhere(offered));
        let replaced = words.split('`').nth(3).filter(|_| !is_result);
        match (offers, replaced.is_some_and(|replaced| self.is_printed_elsewhere(replaced))) {
            (true, false) => PRINTED_ELSEWHERE,
            (false, true) => 1.0 / PRINTED_TWICE,
            _ => 1.0,
        }
    }

    /// Whether a number of three digits or more stands in the text near the chain.
    fn is_printed_elsewhere(&self, number: &str) -> bool {
        let is_long = number.bytes().filter(u8::is_ascii_digit).count() >= 3;
        let is_of_number = |c: char| c.is_ascii_digit() || c == '.';
        is_long
            && number.chars().all(is_of_number)
            && self.around.iter().any(|text| {
                text.match_indices(number).any(|(at, _)| {
                    let (before, behind) = (&text[..at], &text[at + number.len()..]);
                    let goes_on = behind.trim_start_matches('.').starts_with(|c: char| c.is_ascii_digit());
                    !before.ends_with(is_of_number) && !goes_on
                })
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::join::chain::split_chains;
    use crate::judge::verdict::judge;
    use crate::reader::{self, TextFormat};

    fn hinted(tex: &str) -> Option<String> {
        let mut found = None;
        reader::read(&format!("${tex}$"), TextFormat::Markdown, &mut |formula| {
            let chain = &split_chains(&formula.tokens)[0];
            let [left, right] = [&chain.sides[0], &chain.sides[1]];
            let judgement = judge(&left.tokens, &right.tokens, Relation::Equal, None);
            let relation = Relation::Equal;
            let search =
                HintSearch { left, right, relation, judgement: &judgement, neighbours: [None; 2], around: [""; 2] };
            found = search.hint(&mut MOST_FOR_ALL.clone());
        })
        .expect("it is read");
        found.map(|hint| hint.words)
    }

    #[test]
    fn the_one_edit_that_fits_is_named() {
        for (tex, words) in [
            (r"(46.6\ \mathrm{W})(86.400\ \mathrm{s}) = 4.03\times10^6\ \mathrm{J}", "`86,400` for `86.400`"),
            (r"2.40\ \mathrm{m/s^2}\,(12.0\ \mathrm{s})^2 = 172.80\ \mathrm{m}", "a factor 2 on one of the two sides"),
            (
                r"\frac{1000\ \mathrm{MeV}}{8.62\times10^{11}\ \mathrm{MeV/K}} = 1.16\times10^{13}\ \mathrm{K}",
                "`10^−11` for `10^11`",
            ),
            (r"\tan 31.0^\circ = 0.609", "`0.601` for `0.609`"),
            (r"239.052157 - 239.046526 = 0.0005631", "`0.005631` for `0.0005631`"),
            (r"3.0\cdot 20 = -60.0", "the opposite sign on one of the two sides"),
        ] {
            assert_eq!(hinted(tex).as_deref(), Some(words), "{tex}");
        }
    }

    #[test]
    fn a_lacking_caret_is_named() {
        assert_eq!(hinted(r"2 \times 3.1 \times 10^{-5} = 6.2 \times 10{-5}").as_deref(), Some("`10^−5` for `10−5`"));
        assert_eq!(hinted(r"2 \times 3.1 = 6.3 \times 10 - 5"), None);
    }

    #[test]
    fn what_the_text_has_already_is_not_offered() {
        let hint = Hint { words: "`6.928` for `6928`".to_owned(), at: Span::new(2, 7), kind: EditKind::Shift(3) };
        assert!(hint.stands_in("= 6.928") && !hint.stands_in("= 6928.") && !hint.stands_in("="));
    }

    #[test]
    fn of_several_edits_none_is_named() {
        assert_eq!(hinted("43.4 - 29.8 = 13.8"), None);
        // Another digit of an operand, or of a one, would do, but is not likely.
        assert_eq!(hinted("9.00 - (1.188)(0.100) = 8.90"), None);
        assert_eq!(hinted("1/4.000 = 0.750").as_deref(), Some("`0.250` for `0.750`"));
    }
}
