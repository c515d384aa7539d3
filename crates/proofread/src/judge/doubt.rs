//! Whether a difference may be the program's own misreading: it counts as an error only if the formula was read up to its edges.
//!
//! A program that takes a part of something for a number finds sides that end where no author would end them, numbers inside an
//! argument, and single digits that equal something else. None of these signs knows what was misread.

use crate::evaluate::expression::Evaluator;
use crate::evaluate::printed::Mode;
use crate::evaluate::reading::ReadingChoices;
use crate::evaluate::value::{Literal, SideValue};
use crate::join::chain::{Chain, ChainSeparation, ChainSide, Relation};
use crate::judge::arrows;
use crate::judge::bits;
use crate::judge::bracket_symbols;
use crate::judge::chain_verdict::ChainVerdict;
use crate::judge::equals_conventions;
use crate::judge::flattened;
use crate::judge::joining_words;
use crate::judge::local_notation;
use crate::judge::money::starts_with_money;
use crate::judge::notation;
use crate::judge::number_marks;
use crate::judge::other_answers;
use crate::judge::other_arithmetic;
use crate::judge::point_coordinates;
use crate::judge::ranges;
use crate::judge::shifts;
use crate::judge::substitution::{self, without_space};
use crate::judge::surroundings;
use crate::judge::term_notation;
use crate::judge::two_equations;
use crate::judge::verdict::PairJudgement;
use crate::reader::{Formula, FormulaStyle};
use crate::token::{NamedOperation, Span, Token, TokenKind, any};
use crate::unit::unit;

/// How far two bare numbers are apart, relative to the larger one, if no digit explains it.
const FAR: f64 = 0.7;

/// How far a quantity may be from its size in rounder digits, relative to it.
const ROUGH: f64 = 0.05;

/// Tokens of the longest formula that is looked at as a whole.
const LONGEST: usize = 1000;

/// Why a difference is set aside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Doubt {
    /// A side begins or ends in the middle of something, or a unit that is not known may stand behind it.
    Cut,
    /// The sides stand in an argument of something, beside what is not known, or in a line that is no formula, or `g` may not be
    /// grams.
    Unknown,
    /// A number of one or two digits on the left, two bare numbers with nothing to compute, or a quantity beside
    /// a bare number or its own size.
    Fragment,
    /// The result is truncated where it should have been rounded, or a statistic was rounded twice.
    Truncated,
    /// Other digits of the terms of a small difference would give the result, or digits that are not printed a result of many digits.
    Inputs,
    /// What stands behind ≈ is exact, so it may be an approximation of another kind than by digits.
    Approximation,
    /// The sides of several formulas of the document differ by this factor.
    Habit,
    /// A p-value may be of another test: a one-sided or an exact one, or adjusted for several tests.
    OtherTest,
    /// A total or a share may be of something else than the numbers beside it.
    OtherParts,
}

impl Doubt {
    /// The reason, to follow "set aside, since".
    ///
    /// ```
    /// use proofread::{CheckOptions, Doubt, TextFormat, proofread};
    ///
    /// let report = proofread("$1/18 = 0.0555$", TextFormat::Markdown, CheckOptions::default())?;
    /// assert_eq!(report.findings[0].doubt, Some(Doubt::Truncated));
    /// assert_eq!(Doubt::Truncated.reason(), "a result that is cut off or rounded twice is seldom meant otherwise");
    /// # Ok::<(), proofread::UnreadableText>(())
    /// ```
    pub fn reason(self) -> &'static str {
        match self {
            Self::Cut => "a side may begin or end elsewhere",
            Self::Unknown => "something next to the numbers is not understood",
            Self::Fragment => "a number may be part of something else",
            Self::Truncated => "a result that is cut off or rounded twice is seldom meant otherwise",
            Self::Inputs => "other digits of the terms would give the result",
            Self::Approximation => "what stands behind ≈ is exact, and may be a coarse approximation",
            Self::Habit => "other formulas of the document differ by the same factor",
            Self::OtherTest => "it may be of another test, such as a one-sided or an adjusted one",
            Self::OtherParts => "it may be the total or the share of something else",
        }
    }
}

/// Two sides that differ, and where they stand.
pub(crate) struct PlacedPair<'t> {
    pub text: &'t str,
    pub formula: &'t Formula,
    pub chain: &'t Chain,
    pub left: &'t ChainSide,
    pub right: &'t ChainSide,
}

impl PlacedPair<'_> {
    /// The first reason to set the difference aside.
    pub(crate) fn doubt(&self, judgement: &PairJudgement) -> Option<Doubt> {
        if self.is_cut(judgement) {
            return Some(Doubt::Cut);
        }
        if self.is_other_notation(judgement) {
            return Some(Doubt::Unknown);
        }
        if self.is_fragment(judgement) || self.leaves_sign_out(judgement) || self.is_change_to_percent() {
            return Some(Doubt::Fragment);
        }
        if self.is_coarse_approximation(judgement)
            || other_answers::is_linear_approximation(self.text, self.left, self.right, judgement)
        {
            return Some(Doubt::Approximation);
        }
        if self.lacks_unit_behind(judgement) {
            return Some(Doubt::Cut);
        }
        if judgement.verdict == ChainVerdict::Dimensions && self.is_free_fall() {
            return Some(Doubt::Unknown);
        }
        // Each pair looks at the whole formula, which takes too long if both are many.
        let short = self.formula.tokens.len() <= LONGEST;
        let unknown = short && (self.is_in_argument() || self.is_beside_unknown());
        if unknown || self.is_no_formula() || [self.left, self.right].into_iter().any(number_marks::has_uncertainty) {
            return Some(Doubt::Unknown);
        }
        if judgement.is_ill_conditioned
            || self.may_have_more_digits(judgement)
            || self.may_be_of_rounded_numbers(judgement)
        {
            return Some(Doubt::Inputs);
        }
        (judgement.verdict == ChainVerdict::Truncated).then_some(Doubt::Truncated)
    }

    fn begins_chain(&self) -> bool {
        self.chain.sides.first().is_some_and(|side| side.span == self.left.span)
    }

    fn ends_chain(&self) -> bool {
        self.chain.sides.last().is_some_and(|side| side.span == self.right.span)
    }

    /// Whether what stands just before the left side or behind the right one may belong to them.
    fn is_cut(&self, judgement: &PairJudgement) -> bool {
        let bytes = self.text.as_bytes();
        let at = |at: Option<usize>| at.and_then(|at| bytes.get(at)).copied().unwrap_or(b' ');
        let mark = |c: u8| b",;.:!?".contains(&c);
        let literal = judgement.values.as_ref().is_some_and(|(left, _)| left.is_literal());
        // The tip of an arrow, and no inequality: valE <- 40 + 8 = 48.
        if self.left.relation == Some(Relation::Other) && surroundings::is_behind_tip(self.text, self.left) {
            return true;
        }
        if self.begins_chain() {
            let start = self.left.span.start as usize;
            let (before, far) = (at(start.checked_sub(1)), at(start.checked_sub(2)));
            let function = self.left.tokens.first().is_some_and(|first| matches!(first.kind, TokenKind::Function(_)));
            let joined_on =
                mark(before) && (far.is_ascii_digit() || b")]}".contains(&far)) || (before == b'.' && function);
            let opening = self.formula.span.start as usize;
            let outside = at(opening.checked_sub(1));
            // Between tags there is often no space in running text, but a bracket may be a factor.
            let in_tex = matches!(at(Some(opening)), b'$' | b'\\');
            let glued = (in_tex && (outside.is_ascii_alphanumeric() || b"]}$".contains(&outside))) || outside == b')';
            // So does a sum that goes on from the formula before.
            let sums_on = self.left.tokens.first().is_some_and(|token| token.is_sign('+'))
                && surroundings::follows_formula(self.text, self.formula.span);
            // A display may go on from the one before it.
            let display = ["$$", "\\[", "\\begin"]
                .iter()
                .any(|mark| self.text.get(opening..).is_some_and(|rest| rest.starts_with(mark)));
            // So may a line of text that doesn't begin with the sign.
            let before_it = self.text.get(opening..start).unwrap_or_default();
            let plain = self.formula.style == FormulaStyle::Plain;
            let inside = plain && !before_it.trim().is_empty();
            let styled = before_it.contains("\\displaystyle");
            let opens = display && surroundings::opens_display(self.text, self.formula.span, self.left.span);
            let signs = if opens && !inside && !styled { "+" } else { "+-" };
            let signed =
                (display || inside || styled) && self.left.tokens.first().is_some_and(|token| token.is_one_of(signs));
            let parted = match self.chain.parted {
                ChainSeparation::Not => false,
                ChainSeparation::ByMark => literal || surroundings::ends_in_list(self.text, self.right.span),
                ChainSeparation::FromNumbers => true,
            };
            let by_word = joining_words::is_joined_by_word(self.text, self.left.span)
                || plain && surroundings::is_joined_by_sign(self.text, self.left.span);
            // What is named, with a number in its name: the interest on 8000 = 8820 − 8000.
            let result = judgement.values.as_ref().is_some_and(|(_, right)| right.is_literal());
            // So does what bears a number: No. 200 = 75 μm.
            let size = judgement.values.as_ref().is_some_and(|(left, right)| !left.has_unit && right.has_unit);
            // So is what stands before a function: mg cos 30°.
            // A quantity in brackets belongs to the words before it: 80 % of the current (2.00 A).
            let may_be_named =
                (literal && (!result || size)) || function || bracket_symbols::is_bracketed_quantity(&self.left.tokens);
            let named = plain
                && (may_be_named && surroundings::follows_name(self.text, self.left.span)
                    || surroundings::follows_label(self.text, self.left.span));
            let called = surroundings::follows_function(self.text, self.formula.span)
                || (plain && surroundings::is_torn_off(self.text, self.left));
            // A unit that is added to has its number elsewhere, as does an amount behind one in a larger unit: 7 shillings and 85 cents.
            let lacks_number = matches!(&*without_space(&self.left.tokens), [unit, sign, ..] if unit.word().is_some() && sign.is_one_of("+-"))
                || literal && surroundings::is_second_amount(self.text, self.left.span);
            if joined_on || glued || signed || sums_on || parted || by_word || named || called || lacks_number {
                return true;
            }
        }
        // A bracket closes in the left side that none in it opens.
        if bracket_symbols::closes_unopened(&self.left.tokens) {
            return true;
        }
        let end = self.right.span.end as usize;
        let (behind, far) = (at(Some(end)), at(Some(end + 1)));
        let goes_on = mark(behind) && (far.is_ascii_digit() || b"([{".contains(&far));
        let wraps =
            self.formula.style == FormulaStyle::Plain && surroundings::goes_on_below(self.text, self.right.span);
        let thousands = surroundings::goes_on_in_thousands(self.text, self.right.span);
        self.ends_chain()
            && (goes_on || wraps || thousands || surroundings::goes_on_in_words(self.text, self.right.span))
            || arrows::goes_on_with_arrow(self.text, self.right.span)
    }

    /// Whether the sides may be written in a way in which their numbers mean something else.
    fn is_other_notation(&self, judgement: &PairJudgement) -> bool {
        let sides = [self.left, self.right];
        let [left, right] = sides.map(|side| side.tokens.as_slice());
        let bare = judgement.values.as_ref().is_none_or(|(left, right)| !left.has_unit && !right.has_unit);
        let plain = self.formula.style == FormulaStyle::Plain;
        let both = self.left.span.join(self.right.span);
        let around = if plain { both } else { surroundings::part_near(self.text, self.formula.span, both) };
        substitution::substitutes(left, right)
            || (plain && (substitution::is_formula(left) || substitution::is_formula(right)))
            || (notation::is_bracketed_number(right) && right[0].is_sign('['))
            || (plain && (flattened::has_lost_exponents(left) || flattened::has_lost_exponents(right)))
            || bracket_symbols::may_name_pi(left, right, judgement.values.as_ref())
            || bracket_symbols::may_be_residue_symbols(left, right)
            || bracket_symbols::may_be_cycles(left, right)
            || (self.begins_chain() && bracket_symbols::may_be_indexed_letter(left))
            || bracket_symbols::may_be_places(left)
            || bracket_symbols::may_be_places(right)
            || ([left, right].into_iter().any(bracket_symbols::is_all_bracketed) && self.has_other_base())
            || bracket_symbols::may_be_classes(left, right)
            || sides.into_iter().any(|side| bracket_symbols::has_pairs_as_decimals(self.text, side))
            || ([left, right].into_iter().any(bracket_symbols::has_bracketed_decimals)
                && surroundings::speaks_of_integer_parts(self.text, around))
            || (bracket_symbols::may_be_order(left, right) && surroundings::speaks_of_groups(self.text, around))
            || (point_coordinates::are_proportional(left, right)
                && surroundings::speaks_of_homogeneous_coordinates(self.text, around))
            || self.has_other_meaning(judgement)
            || notation::has_phasor(right)
            || self.is_minor()
            || other_arithmetic::has_own_operation(self.text, self.left.span)
            || other_arithmetic::are_codewords(self.text, [left, right], &bare_differences(judgement), self.left.span)
            || other_arithmetic::is_exclusive_or(self.text, left, right, self.left.span)
            || number_marks::is_mark(right)
            || notation::is_bracketed_number(left)
            || ((plain || notation::is_bracketed_number(right)) && notation::are_references(left))
            || (judgement.verdict == ChainVerdict::Dimensions
                && [left, right].into_iter().any(notation::has_two_meanings))
            || other_arithmetic::is_proverbial(left, right, || surroundings::speaks_of_truth(self.text, around))
            || judgement
                .values
                .as_ref()
                .and_then(|(left, _)| left.number().ok())
                .is_some_and(|of| equals_conventions::is_size(of.point, right))
            || self.is_one_of_two()
            || [self.left, self.right].into_iter().any(|side| surroundings::calls_function(self.text, side.span))
            || (plain && ranges::is_range(self.text, left))
            || (plain && ranges::are_ranges(left, right))
            || (plain && ranges::is_network(self.text, left, around))
            || (bare
                && self.ends_chain()
                && ranges::has_remainder_behind(self.text, self.right.span.end, judgement.values.as_ref()))
            || shifts::is_shifted(self.text, self.chain, self.left, self.right)
            || (bare && bits::agree(self.text, left, right, around))
            || (bare && other_arithmetic::is_inverse(self.text, left, right, self.left.span))
            || (plain && !self.begins_chain() && two_equations::ends_with_name(self.text, left))
            || term_notation::begins_with_unit(left)
            || (bare && sides.into_iter().all(|side| bracket_symbols::has_comma_as_point(self.text, side)))
            || other_answers::leads_to_logarithm(left, right)
            || other_answers::is_one_of_choices(self.text, self.left, self.right)
            || (plain && self.begins_chain() && self.is_station())
            || local_notation::is_label(left, plain, judgement.values.as_ref())
            || (plain && flattened::is_doubled(self.text, around))
            || local_notation::agree_with_decimal_commas(self.left, self.right, Relation::Equal)
            || local_notation::lacks_percent_sign(self.text, around, judgement.values.as_ref())
            || (bare && (number_marks::has_bits(left) || number_marks::has_bits(right)))
            || (bare
                && surroundings::named_base(self.text, around).is_none()
                && !computes_remainder(left)
                && !computes_remainder(right)
                && (other_arithmetic::may_explain(self.text, around, &bare_differences(judgement))
                    || other_arithmetic::may_be_remainder(self.text, left, judgement.values.as_ref(), self.left.span)))
    }

    /// Whether a number of the chain names its base.
    fn has_other_base(&self) -> bool {
        let names = |kind: &TokenKind| matches!(kind, TokenKind::Call(NamedOperation::InBase, _));
        self.chain.sides.iter().any(|side| any(&side.tokens, &names))
    }

    /// Whether a sign in one of the sides parts two equations.
    fn is_one_of_two(&self) -> bool {
        let at = self.chain.sides.iter().position(|side| side.span == self.right.span).unwrap_or(0);
        let three = |from: usize| match self.chain.sides.get(from..from + 3) {
            Some([one, two, three]) => two_equations::are_two_equations([&one.tokens, &two.tokens, &three.tokens]),
            _ => false,
        };
        at > 0 && (three(at - 1) || (at > 1 && three(at - 2)))
    }

    /// Whether the left side is a place on a line that is surveyed: Sta. 12+50.
    fn is_station(&self) -> bool {
        let before =
            self.text.get(..self.left.span.start as usize).unwrap_or_default().trim_end_matches([' ', '.', ':']);
        number_marks::is_mark(&self.left.tokens) && before.ends_with(|c: char| c.is_alphabetic())
    }

    /// Whether a quantity equals a bare number at the end of the formula, behind which a unit may stand that is not known.
    fn lacks_unit_behind(&self, judgement: &PairJudgement) -> bool {
        let Some((left, right)) = &judgement.values else { return false };
        let bare = right.literal == Literal::Number && !right.has_unit && right.angle.is_none();
        let between = self.text.get(self.right.span.end as usize..self.formula.span.end as usize);
        let ends = between.is_some_and(|between| between.trim_matches(['$', ' ', '\\', ')']).is_empty());
        let quantity = left.has_unit || left.angle.is_some();
        // In a line of text, a word that touches the number.
        let behind = self.text.get(self.right.span.end as usize..).unwrap_or_default();
        if quantity
            && bare
            && self.formula.style == FormulaStyle::Plain
            && (behind.starts_with(char::is_alphabetic) || begins_with_rate(behind))
        {
            return true;
        }
        let written = self.formula.style == FormulaStyle::Formula;
        quantity && bare && ends && written && surroundings::may_be_unit_behind(self.text, self.formula.span)
    }

    /// Whether the dimensions agree if `g` is the acceleration of free fall, and not grams.
    fn is_free_fall(&self) -> bool {
        let has_g = |side: &ChainSide| any(&side.tokens, &|kind| matches!(kind, TokenKind::Word(word) if word == "g"));
        let sides = [(self.left, self.right), (self.right, self.left)];
        let (Some(metre), Some(second), Some(gram)) = (unit("m"), unit("s"), unit("g")) else { return false };
        let fall = metre.dimension.with_factor(second.dimension, -2.0).with_factor(gram.dimension, -1.0);
        // In 10/3 m/s² the unit is that of the quotient.
        sides.into_iter().filter(|(side, _)| has_g(side)).any(|(side, other)| {
            [ReadingChoices::USUAL, ReadingChoices::QUOTIENT].into_iter().any(|reading| {
                let value = |side: &ChainSide| Evaluator::new(Mode::Point, reading, None).evaluate_side(&side.tokens);
                let dimensions = value(side).ok().zip(value(other).ok());
                dimensions.is_some_and(|(side, other)| side.dimension.with_factor(fall, 1.0) == other.dimension)
            })
        })
    }

    fn is_fragment(&self, judgement: &PairJudgement) -> bool {
        let Some((left, right)) = &judgement.values else { return false };
        let bare = |of: &SideValue| of.literal == Literal::Number && !of.has_unit && of.angle.is_none();
        let mut tokens = self.left.tokens.iter().filter(|token| !token.is_space() && !token.is_sign('-'));
        let digits = tokens.next().and_then(Token::number).filter(|_| tokens.next().is_none());
        let is_small = digits.is_some_and(|digits| digits.len() <= 2 && !digits.contains('.'));
        let apart = left.difference(right) > FAR;
        // What the text names in words has its unit there, or the working leaves it out.
        // A number near what per cent are lacks nothing.
        let is_share = right.number().is_ok_and(|of| number_marks::is_near_percent(&self.left.tokens, of.point));
        let lacks_unit =
            left.literal == Literal::Number && left.has_unit && !right.has_unit && right.angle.is_none() && !is_share;
        // The dollar is also a unit of other things.
        let is_sum = starts_with_money(self.right);
        let costs = is_sum && left.literal == Literal::Number && !left.has_unit;
        // A quantity and its size, whose direction is said in words.
        let both = left.literal == Literal::Number && right.literal == Literal::Number;
        // Twice what a letter stands for: 2M = 18.0 g/mol.
        let times_letter = matches!(&self.left.tokens[..], [digit, letter] if digit.number().is_some_and(|of| of.len() == 1) && letter.word().is_some_and(|word| word.chars().count() == 1));
        if times_letter && judgement.verdict == ChainVerdict::Dimensions {
            return true;
        }
        // e⁻¹ = 1 sets a letter, be it what it may.
        let letter = matches!(&self.left.tokens[..], [base, Token { kind: TokenKind::Power(_), .. }] if base.kind == TokenKind::Name("e".to_owned()));
        let sets = letter
            && bare(right)
            && self.right.relation == Some(Relation::Equal)
            && right.number().is_ok_and(|of| of.point.fract() == 0.0);
        // What a code stands for: 107 = 7 days.
        let coded = both
            && bare(left)
            && is_integer(left)
            && right.has_unit
            && apart
            && !is_sum
            && self.begins_chain()
            && self.formula.style == FormulaStyle::Plain;
        let opposite = both && left.dimension == right.dimension && left.clone().negate().meets(right, ROUGH);
        // So is the deviation in per cent of what was measured.
        let deviates = self.right.tokens.last().and_then(Token::word) == Some("%")
            && right.is_literal()
            && left.clone().negate().meets(right, ROUGH);
        // In mathematics a whole formula begins with a result: 8 = 2³.
        let is_zero = digits == Some("0");
        let is_small =
            is_small && self.begins_chain() && (is_zero || bare(right) || !is_integer(right) || !self.is_whole());
        let computes = |side: &ChainSide| side.tokens.iter().any(|token| !token.is_space() && token.number().is_none());
        let alone = self.begins_chain() || !self.chain.sides.iter().any(computes);
        // A power is no label: 10^3 = 3, 10000 = 10^9, 120 = 3.2 × 10².
        let is_power = |side: &ChainSide| side.tokens.iter().any(|token| matches!(token.kind, TokenKind::Power(_)));
        let is_raised = (is_power(self.left) || is_power(self.right))
            && (!self.begins_chain() || self.is_whole() || self.is_line());
        let pair =
            both && bare(left) && bare(right) && alone && !is_raised && [left, right].into_iter().all(is_integer);
        // What an inequality compares belongs to its left side: P(X > 1.25) = 0.535.
        let is_bound = both
            && bare(left)
            && bare(right)
            && self.left.relation == Some(Relation::Other)
            && ![left, right].into_iter().all(is_integer);
        lacks_unit
            || is_bound
            || opposite
            || costs
            || deviates
            || sets
            || coded
            || pair
            || (bare(left) && (is_small || (bare(right) && apart && !is_raised)))
    }

    /// Whether the two sides are all of a formula whose marks show where it begins and ends.
    fn is_whole(&self) -> bool {
        let marks = |text: &str| text.trim_matches(['$', ' ', '\\', '(', ')', '[', ']', '.', ',', '\n']).is_empty();
        let (start, end) = (self.left.span.start as usize, self.right.span.end as usize);
        let formula = self.formula.span.range();
        self.formula.style == FormulaStyle::Formula
            && self.chain.sides.len() == 2
            && self.text.get(formula.start..start).is_some_and(marks)
            && self.text.get(end..formula.end).is_some_and(marks)
    }

    /// Whether the two sides are all of a line of running text that has blank lines around it.
    fn is_line(&self) -> bool {
        let (start, end) = (self.left.span.start as usize, self.right.span.end as usize);
        let [before, behind] = [self.text.get(..start), self.text.get(end..)].map(Option::unwrap_or_default);
        let behind = behind.trim_start_matches(['.', ',', ' ']);
        self.formula.style == FormulaStyle::Plain
            && self.chain.sides.len() == 2
            && before.trim_end_matches(' ').ends_with("\n\n")
            && (behind.is_empty() || behind.starts_with("\n\n"))
    }

    /// Whether the sides are inside an argument of what is not known, or of a sign, and not in a row of the formula itself.
    fn is_in_argument(&self) -> bool {
        // A side of the formula before is compared with one of this formula.
        let is_elsewhere = self.left.span.start < self.formula.span.start;
        !is_elsewhere && !is_among(&self.formula.tokens, self.left.span.start)
    }

    /// Whether an environment or dots that are not evaluated stand in the same row.
    fn is_beside_unknown(&self) -> bool {
        let mut rows = self.formula.tokens.split(|token| token.kind == TokenKind::Line);
        let within = |span: Span| span.start <= self.left.span.start && self.left.span.start < span.end;
        let Some(row) = rows.find(|row| row.iter().any(|token| within(token.span))) else { return false };
        row.iter().any(|token| match &token.kind {
            // It was read as the modulus of a congruence.
            TokenKind::Unknown(name) if name == "pmod" && computes_remainder(&self.right.tokens) => false,
            // In another side of the chain, it cuts neither of these.
            TokenKind::Unknown(_) if self.is_in_other_side(token.span) => false,
            // So were dots for terms of a sum: both sides have values.
            TokenKind::Unknown(name)
                if name == "…"
                    && [self.left, self.right].into_iter().any(|side| side.span.join(token.span) == side.span) =>
            {
                false
            }
            // Dots behind decimals were read.
            TokenKind::Unknown(_)
                if [self.left, self.right].into_iter().any(|side| has_number_at(side, token.span)) =>
            {
                false
            }
            TokenKind::Unknown(name) => {
                let source = self.text.get(token.span.range()).unwrap_or_default();
                !name.starts_with('\\') && source.starts_with('\\')
            }
            _ => false,
        })
    }

    /// Whether a place is inside a side of the chain that is none of these two.
    fn is_in_other_side(&self, place: Span) -> bool {
        let others = self.chain.sides.iter().filter(|side| side.span != self.left.span && side.span != self.right.span);
        { others }.any(|side| side.span.start <= place.start && place.end <= side.span.end)
    }

    /// Whether marks of TeX are left in a line that was taken for a formula.
    fn is_no_formula(&self) -> bool {
        let sides = self.left.span.join(self.right.span);
        let marks = |text: &str| text.contains(['\\', '{', '}', '$']);
        self.formula.style == FormulaStyle::Plain && self.text.get(sides.range()).is_some_and(marks)
    }
}

/// Whether a text begins with a unit or a word in another one, behind a space: ` GB/day`.
fn begins_with_rate(text: &str) -> bool {
    let is_letter = |c: char| c.is_alphabetic();
    let rest = text.strip_prefix(' ').unwrap_or_default();
    let rate = rest.trim_start_matches(is_letter).strip_prefix('/');
    rest.starts_with(is_letter) && rate.is_some_and(|rate| rate.starts_with(is_letter))
}

/// Whether a value is a whole number.
fn is_integer(value: &SideValue) -> bool {
    value.number().is_ok_and(|of| of.point.fract() == 0.0)
}

/// Whether a place is inside a number of a side.
fn has_number_at(side: &ChainSide, place: Span) -> bool {
    let covers = |token: &Token| token.span.start <= place.start && place.end <= token.span.end;
    side.tokens.iter().any(|token| token.number().is_some() && covers(token))
}

/// Whether a remainder is computed in a side.
fn computes_remainder(side: &[Token]) -> bool {
    any(side, &|kind| matches!(kind, TokenKind::Word(word) if word == "mod"))
}

/// The differences of the components of two sides, one if they are numbers.
fn bare_differences(judgement: &PairJudgement) -> Vec<f64> {
    let Some((left, right)) = judgement.values.as_ref() else { return Vec::new() };
    // The inverse of an integer is the number that gives one with it: 7⁻¹ = 16, since 7 · 16 = 111 + 1.
    if let (Ok(left), Ok(right)) = (left.number(), right.number())
        && left.point.fract() != 0.0
        && (1.0 / left.point - libm::round(1.0 / left.point)).abs() < 1e-9
    {
        return vec![right.point * libm::round(1.0 / left.point) - 1.0];
    }
    left.parts.pairs(&right.parts).map(|(one, other)| one.point - other.point).collect()
}

/// Whether the token at a place is one of these, or in braces that are no argument of what is not known.
fn is_among(tokens: &[Token], place: u32) -> bool {
    let mut behind_unknown = false;
    tokens.iter().any(|token| {
        let found = match &token.kind {
            TokenKind::Group(inner) => !behind_unknown && is_among(inner, place),
            _ => token.span.start <= place && place < token.span.end,
        };
        behind_unknown = match &token.kind {
            TokenKind::Group(_) => behind_unknown,
            TokenKind::Unknown(name) => name.starts_with('\\'),
            _ => false,
        };
        found
    })
}
