//! Cards: which lines are comments, and where the fields of the others are.

use super::control::{STEPS, WORDS};
use super::diagnostic::{Problem, is_unprintable, nearest_to};
use super::expression::{Problems, mismatch};
use super::function::function_named;
use super::token::{CardToken, PlacedToken, tokens};
use super::tree::Word;
use core::ops::Range;

/// Most characters of a card. The machine's had eighty.
pub(super) const LONGEST: usize = 1000;

/// Layout of a card: where its logical control variable, result and expression are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CardLayout {
    /// In columns, as in the deck of the encyclopedia: control before column 10, result from 10 to 16 with a sign = in
    /// 17 that may be left out, expression from 19 on.
    Columns,
    /// With blanks between them, as the copy of the thesis has them, whose columns are lost.
    Free,
}

/// Where the result begins, and where the expression.
const RESULT: usize = 9;
const EXPRESSION: usize = 18;

impl CardLayout {
    /// The layout of a deck: columns, if every card keeps to them.
    pub fn detect(text: &str) -> Self {
        let mut any = false;
        for line in text.lines() {
            let card: Vec<char> = line.trim_end().chars().collect();
            if card.is_empty() || matches!(card[0], '*' | '/' | 'C' | 'c') {
                continue;
            }
            any = true;
            if !keeps_to_columns(&card) {
                return Self::Free;
            }
            if card[EXPRESSION..].iter().collect::<String>().eq_ignore_ascii_case("END") {
                break;
            }
        }
        if any { Self::Columns } else { Self::Free }
    }
}

fn keeps_to_columns(card: &[char]) -> bool {
    let begins = card.get(EXPRESSION).is_some_and(|sign| !sign.is_whitespace()) && card[EXPRESSION - 1] == ' ';
    let word = |columns: Range<usize>| {
        let text: String = card[columns].iter().collect();
        text.split_whitespace().count() <= 1 && !text.contains('\t')
    };
    begins && word(0..RESULT) && word(RESULT..EXPRESSION - 2) && matches!(card[EXPRESSION - 2], ' ' | '=')
}

/// Whether a line is a comment.
pub(super) fn is_comment(card: &[char], layout: CardLayout) -> bool {
    match card.first() {
        Some('*' | '/') => true,
        // CON(A) and C=2. may begin in column 1 where columns do not count.
        Some('C' | 'c') => layout == CardLayout::Columns || card.get(1).is_none_or(|next| next.is_whitespace()),
        _ => false,
    }
}

/// The fields of a card.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Fields {
    /// A result and its expression, perhaps under a control variable.
    Statement { control: Option<Word>, result: Word, expression: Vec<PlacedToken> },
    /// A control card: its word, and the tokens behind its opening parenthesis.
    Control { word: Word, rest: Vec<PlacedToken> },
}

/// The fields of a card that is no comment.
pub(super) fn fields(card: &[char], layout: CardLayout) -> Result<Fields, Problems> {
    let all = 0..card.len();
    if card.len() > LONGEST {
        return Err(vec![(LONGEST..card.len(), Problem::TooLong { length: card.len(), most: LONGEST })]);
    }
    let (found, problems) = tokens(card, all);
    // A heading may have any signs that can be printed.
    let is_heading = found.first().and_then(PlacedToken::name) == Some("HDR");
    let unprintable = || card.iter().enumerate().filter(|(_, sign)| is_unprintable(**sign));
    if is_heading {
        let problems: Vec<_> = unprintable().map(|(at, sign)| (at..at + 1, Problem::Sign(*sign))).collect();
        if !problems.is_empty() {
            return Err(problems);
        }
    } else if !problems.is_empty() {
        return Err(problems);
    }
    if let Some(control) = control_card(&found) {
        return control;
    }
    match layout {
        CardLayout::Columns => in_columns(found, card.len()),
        CardLayout::Free => free(found, card.len()),
    }
}

/// A control card, if its first word is one, or if it can be nothing else.
fn control_card(found: &[PlacedToken]) -> Option<Result<Fields, Problems>> {
    let word = Word { name: found.first()?.name()?.to_owned(), at: found[0].at.clone() };
    let opens = found.get(1).is_some_and(|next| next.is('('));
    if WORDS.contains(&word.name.as_str()) {
        if word.name == "END" {
            let rest = found.get(1).map(|more| vec![(more.at.clone(), mismatch("the end of the card", Some(more)))]);
            return Some(rest.map_or(Ok(Fields::Control { word, rest: Vec::new() }), Err));
        }
        if !opens {
            let at = found.get(1).map_or(word.at.end..word.at.end + 1, |next| next.at.clone());
            return Some(Err(vec![(at, mismatch("an opening parenthesis", found.get(1)))]));
        }
        return Some(Ok(Fields::Control { word, rest: found[2..].to_vec() }));
    }
    let adjoins = opens && found[1].at.start == word.at.end;
    if adjoins && !STEPS.contains(&word.name.as_str()) {
        if function_named(&word.name).is_some() {
            return Some(Err(vec![(word.at, mismatch("the name of a result before the function", found.first()))]));
        }
        let nearest = nearest_to(&word.name, WORDS);
        return Some(Err(vec![(word.at, Problem::UnknownCard { name: word.name, nearest })]));
    }
    None
}

/// The only name in a field, if there is something in it.
fn only(field: &[PlacedToken], what: &'static str) -> Result<Option<Word>, Problems> {
    match field {
        [] => Ok(None),
        [one] => match one.name() {
            Some(name) => Ok(Some(Word { name: name.to_owned(), at: one.at.clone() })),
            None => Err(vec![(one.at.clone(), mismatch(what, Some(one)))]),
        },
        [_, more, ..] => Err(vec![(more.at.clone(), mismatch("one name in the field", Some(more)))]),
    }
}

fn in_columns(mut found: Vec<PlacedToken>, end: usize) -> Result<Fields, Problems> {
    if let Some(across) =
        found.iter().find(|of| [RESULT, EXPRESSION].iter().any(|edge| of.at.start < *edge && of.at.end > *edge))
    {
        let problem = Problem::Column("a result begins in column 10 and an expression in column 19");
        return Err(vec![(across.at.clone(), problem)]);
    }
    let expression = found.split_off(found.partition_point(|of| of.at.start < EXPRESSION));
    let mut result = found.split_off(found.partition_point(|of| of.at.start < RESULT));
    if result.last().is_some_and(|last| last.is('=')) {
        result.pop();
    }
    let control = only(&found, "the name of a control variable")?;
    let Some(result) = only(&result, "the name of a result")? else {
        let at = expression.first().map_or(end..end + 1, |first| first.at.clone());
        return Err(vec![(at, mismatch("a result in columns 10 to 16, or a control card", expression.first()))]);
    };
    Ok(Fields::Statement { control, result, expression })
}

/// The fields of a card without columns: what is the result is told by what stands behind it.
fn free(mut found: Vec<PlacedToken>, end: usize) -> Result<Fields, Problems> {
    let result_at = match found.iter().position(|of| of.is('=')) {
        Some(equals) if equals <= 2 => {
            let expression = found.split_off(equals + 1);
            found.pop();
            return statement(found, expression, end);
        }
        Some(equals) => {
            let found = &found[equals];
            return Err(vec![(found.at.clone(), mismatch("an arithmetic sign", Some(found)))]);
        }
        None => fields_before_expression(&found, end)?,
    };
    let expression = found.split_off(result_at);
    statement(found, expression, end)
}

fn statement(mut before: Vec<PlacedToken>, expression: Vec<PlacedToken>, end: usize) -> Result<Fields, Problems> {
    let result = before.pop();
    let result = only(result.as_slice(), "the name of a result")?;
    let control = only(&before, "the name of a control variable")?;
    let Some(result) = result else {
        let at = expression.first().map_or(end..end + 1, |first| first.at.clone());
        return Err(vec![(at, mismatch("the name of a result", expression.first()))]);
    };
    Ok(Fields::Statement { control, result, expression })
}

/// How many of the first tokens are control and result.
fn fields_before_expression(found: &[PlacedToken], end: usize) -> Result<usize, Problems> {
    let Some(first) = found.first() else { return Ok(0) };
    let Some(first_name) = first.name() else {
        return Err(vec![(first.at.clone(), mismatch("the name of a result, or a control card", Some(first)))]);
    };
    let Some(second) = found.get(1) else {
        return Err(vec![(end..end + 1, mismatch("an expression after the name", None))]);
    };
    let Some(second_name) = second.name() else {
        let gap_before = second.at.start > first.at.end;
        let gap_after = found.get(2).is_some_and(|third| third.at.start > second.at.end);
        let begins = match second.token {
            CardToken::Number(_) => true,
            _ => second.is('(') || (second.is_one_of(&['-', '+']) && gap_before && !gap_after),
        };
        return if begins { Ok(1) } else { Err(vec![(second.at.clone(), mismatch("an expression", Some(second)))]) };
    };
    let Some(third) = found.get(2) else { return Ok(1) };
    let gap_before = third.at.start > second.at.end;
    let gap_after = found.get(3).is_some_and(|fourth| fourth.at.start > third.at.end);
    match third.token {
        CardToken::Name(_) | CardToken::Number(_) => Ok(2),
        CardToken::Sign('(') if gap_before && function_named(second_name).is_none() => Ok(2),
        CardToken::Sign(sign @ ('-' | '+')) if gap_before && !gap_after => {
            let (first, second) = (first_name.to_owned(), second_name.to_owned());
            Err(vec![(third.at.clone(), Problem::Ambiguous { first, second, sign })])
        }
        CardToken::Sign(_) => Ok(1),
    }
}
