//! Chains: sides with relations between them.

use crate::join::equation_columns::EQUATION_END;
use crate::join::token_joining::join_tokens;
use crate::token::{Span, Token, TokenKind, has_number, span_of, trim_space};
use crate::unit::{currency, is_percent, joins_share, unit};

/// How a side relates to the one before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Relation {
    /// `=`
    Equal,
    /// `≈` and its relatives.
    Approximate,
    /// Any other relation; nothing is compared across it.
    Other,
}

/// A side of a chain.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ChainSide {
    /// The relation before it; none for the first side.
    pub relation: Option<Relation>,
    /// Its tokens, joined.
    pub tokens: Vec<Token>,
    /// Where it is in the text.
    pub span: Span,
}

/// How a chain is parted from what stands before it in its row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum ChainSeparation {
    /// Not at all, or by words.
    #[default]
    Not,
    /// By a comma or a point.
    ByMark,
    /// By such a mark, an arrow or the word *of* behind numbers that are in no chain: `1, 2, 3 = 6`.
    FromNumbers,
}

/// Sides with relations between them; at least two.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Chain {
    /// The sides in their order.
    pub sides: Vec<ChainSide>,
    /// Whether a question mark follows: whether it holds is asked, not said.
    pub asked: bool,
    /// Whether it begins a row of its formula.
    pub starts_row: bool,
    /// What parts it from what stands before it in its row.
    pub parted: ChainSeparation,
}

/// The width of the space that stands for the end of a row within a side.
pub(crate) const ROW_END: u8 = 8;

fn relation(token: &Token) -> Option<Relation> {
    match token.kind {
        TokenKind::Operator('=') => Some(Relation::Equal),
        TokenKind::Operator('≈' | '≅' | '≃' | '≒' | '≐') => Some(Relation::Approximate),
        TokenKind::Operator(
            '<' | '>' | '≤' | '≥' | '≠' | '∝' | '≡' | '∼' | '~' | '≫' | '≪' | '≮' | '⇔' | '↔' | '∈' | '∉',
        ) => Some(Relation::Other),
        _ => None,
    }
}

fn ends_row(token: &Token) -> bool {
    matches!(token.kind, TokenKind::Line | TokenKind::Space(9..))
}

fn ends_equation(token: &Token) -> bool {
    matches!(token.kind, TokenKind::Line | TokenKind::Space(EQUATION_END))
}

fn separates(token: &Token) -> bool {
    const WORDS: &str = " and or so where with if for when at but thus since from hence therefore then while Thus Then Hence \
        Therefore So because which gives give yields is as to by of the Solving we that on after before along toward up down \
        below above From For Given Noting Since are not für wenn falls bei pour si quand para cuando när und oder et ou och og en mit avec où also donc dus и или von van de di av af \
        Yes Now We Write Multiply Divide Replace Simplify Substitute Convert Combine Distribute Subtract Both The This Let It Notice Check \
        Using Wir Sei Seien Nun Dann Damit Daher Somit Man Donc Alors Soit Entonces Luego ";
    match &token.kind {
        TokenKind::Operator(c) => ",;⇒→∴↔.:?⟹!↑↓⊥∥".contains(*c),
        TokenKind::Word(word) => word.len() > 1 && WORDS.split_ascii_whitespace().any(|known| known == word),
        _ => false,
    }
}

#[derive(Default)]
struct Splitter {
    chains: Vec<Chain>,
    sides: Vec<ChainSide>,
    side: Vec<Token>,
    relation: Option<Relation>,
    at_row: bool,
    /// What parts the chain at hand from what stands before it in its row.
    parted: ChainSeparation,
    /// Whether a comma stands before the piece at hand.
    listed: bool,
}

impl Splitter {
    fn end_side(&mut self) {
        let tokens = trim_space(without_digits_remark(trim_space(&self.side))).to_vec();
        let span = span_of(&tokens);
        self.sides.push(ChainSide { relation: self.relation, tokens, span });
        self.side.clear();
    }

    fn end_chain(&mut self, asked: bool, row_follows: bool) {
        self.end_side();
        let sides = std::mem::take(&mut self.sides);
        if sides.len() > 1 {
            self.chains.push(Chain { sides, asked, starts_row: self.at_row, parted: self.parted });
        }
        self.relation = None;
        self.parted = ChainSeparation::Not;
        self.at_row = row_follows;
    }

    /// Whether the piece at hand is a number at the end of a list: `i = 0, 1`.
    fn ends_list(&self) -> bool {
        let mut tokens = self.side.iter().filter(|token| !token.is_space());
        let is_number = tokens.next().is_some_and(|token| token.number().is_some()) && tokens.next().is_none();
        self.listed && self.sides.is_empty() && is_number
    }

    fn last(&self) -> Option<&Token> {
        self.side.iter().rev().find(|token| !token.is_space())
    }
}

/// A side without the remark in brackets behind it that says to how many digits it is given: `16.1 (to 3 s.f.)`.
fn without_digits_remark(side: &[Token]) -> &[Token] {
    /// Words that say what is counted, and those that may stand beside them.
    const KINDS: &str = "sf f fig figs figures digits dp p places place dec";
    const OTHERS: &str = "s sig significant d decimal to correct rounded given S D";
    let is_of = |words: &str, token: &Token| match &token.kind {
        TokenKind::Word(word) | TokenKind::Name(word) => words.split(' ').any(|known| known == word),
        _ => false,
    };
    let Some((_, rest)) = side.split_last().filter(|(last, _)| last.is_sign(')')) else { return side };
    let Some(open) = rest.iter().rposition(|token| token.is_sign('(')) else { return side };
    let inner = &rest[open + 1..];
    let is_part = |token: &Token| match &token.kind {
        TokenKind::Number(digits) => digits.len() == 1,
        _ => token.is_space() || token.is_sign('.') || is_of(KINDS, token) || is_of(OTHERS, token),
    };
    let names_digits = inner.iter().any(|token| is_of(KINDS, token));
    let is_remark = names_digits && has_number(inner) && inner.iter().all(is_part);
    if is_remark && open > 0 { &rest[..open] } else { side }
}

/// Whether a number in brackets that no sign joins to the number behind it begins at a place.
fn is_item(tokens: &[Token], at: usize) -> bool {
    let [open, number, close, space, rest @ ..] = &tokens[at..] else { return false };
    let next = rest.iter().find(|token| !token.is_space());
    let short = number.number().is_some_and(|digits| digits.len() < 3 && digits.chars().all(|c| c.is_ascii_digit()));
    let starts = next
        .is_some_and(|next| matches!(next.kind, TokenKind::Number(_) | TokenKind::Function(_)) || next.is_sign('√'));
    open.is_one_of("([") && close.is_one_of(")]") && short && space.is_space() && starts
}

/// The brackets that hold whole equations, and no argument: for each bracket that opens, where it closes. What stands before one is the
/// start, a mark, or a number or a word of running text, and it is no name of a function.
fn brackets_of_equations(tokens: &[Token]) -> Vec<(usize, usize)> {
    // The brackets that are open: where they opened, and whether a relation stands in them with something before it.
    let mut open: Vec<(usize, bool)> = Vec::new();
    let mut out = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        if token.is_one_of("([{") {
            open.push((at, false));
        } else if token.is_sign('=') {
            open.last_mut().into_iter().for_each(|(from, relates)| *relates |= *from + 1 < at);
        } else if token.is_one_of(")]}")
            && let Some((from, relates)) = open.pop()
            && relates
            && open.is_empty()
            && tokens[from].is_sign('(')
            && token.is_sign(')')
            && has_number(&tokens[from..at])
        {
            let before = tokens[..from].iter().rev().find(|token| !token.is_space());
            let touches = from > 0 && !tokens[from - 1].is_space();
            let free = before.is_none_or(|before| match &before.kind {
                TokenKind::Operator(c) => ",;:.⇒→∴⟹".contains(*c),
                TokenKind::Number(_) => true,
                TokenKind::Word(_) => !touches,
                TokenKind::Line => true,
                _ => false,
            });
            let behind = tokens[at + 1..].iter().find(|token| !token.is_space());
            let goes_on = behind.is_some_and(|behind| {
                matches!(behind.kind, TokenKind::Power(_) | TokenKind::Limits(..)) || behind.is_one_of("=≈+-·×/(∧∨")
            });
            if free && !goes_on {
                out.push((from, at));
            }
        }
    }
    out
}

/// Whether there are several rows, and each of them ends with its only equals sign, so that its right side is to be filled in.
fn are_all_open(tokens: &[Token]) -> bool {
    let rows = tokens.split(ends_row).filter(|row| !trim_space(row).is_empty());
    let is_open = |row: &[Token]| {
        let signs = row.iter().filter(|token| token.is_sign('=')).count();
        signs == 1 && trim_space(row).last().is_some_and(|last| last.is_sign('=')) && trim_space(row).len() > 1
    };
    rows.clone().count() > 1 && rows.into_iter().all(is_open)
}

/// Whether a colon between two tokens is a division, as schools of many countries write it, and ends no number of an item.
fn divides(last: Option<&Token>, next: Option<&Token>, has_space: bool) -> bool {
    let (Some(last), Some(next)) = (last, next) else { return false };
    let is_value = |of: &Token| matches!(of.kind, TokenKind::Number(_) | TokenKind::Fraction(..));
    let is_stacked = [last, next].into_iter().any(|of| matches!(of.kind, TokenKind::Fraction(..)));
    (is_value(last) || matches!(last.kind, TokenKind::Power(_)) || last.is_sign(')'))
        && (is_value(next) || next.is_sign('('))
        && (has_space || is_stacked)
}

/// The chains of a formula.
pub(crate) fn split_chains(formula: &[Token]) -> Vec<Chain> {
    let tokens = join_tokens(formula);
    let mut splitter = Splitter { at_row: true, ..Splitter::default() };
    let mut depth = 0usize;
    // The next token that is neither space nor the end of a row, for each place.
    let mut following: Vec<usize> = vec![tokens.len(); tokens.len() + 1];
    for at in (0..tokens.len()).rev() {
        let is_gap = tokens[at].is_space() || tokens[at].kind == TokenKind::Line;
        following[at] = if is_gap { following[at + 1] } else { at };
    }
    let brackets = brackets_of_equations(&tokens);
    let is_sheet = are_all_open(&tokens);
    let mut previous_is_line = false;
    let (mut in_remark, mut in_row, mut in_result) = (false, false, false);
    let mut marked = 0;
    for (at, token) in tokens.iter().enumerate() {
        if at < marked {
            continue;
        }
        let next = tokens.get(following[at + 1]);
        // The number of an equation in a list: (1) 5 + 1 = 6 (2) 5 + 2 = 7.
        if depth == 0 && is_item(&tokens, at) {
            let starts = splitter.last().is_none() && splitter.sides.is_empty();
            let ends = splitter.relation.is_some() && splitter.side.last().is_some_and(Token::is_space);
            if starts || ends {
                splitter.end_chain(false, false);
                marked = at + 3;
                continue;
            }
        }
        // Behind the signs of because and for all, the row says why or where it holds.
        let for_all = token.is_sign('∀') && next.is_some_and(|next| !matches!(next.kind, TokenKind::Operator(_)));
        // So does a whole row behind which the chain goes on.
        let rest = tokens[at..].iter().skip_while(|token| token.kind != TokenKind::Line).skip(1);
        let goes_on = || rest.clone().find(|token| !token.is_space()).is_some_and(|next| next.is_sign('='));
        in_remark =
            (in_remark || (!in_row && token.is_sign('∵') && goes_on()) || (in_row && (token.is_sign('∵') || for_all)))
                && !ends_equation(token);
        in_row = (in_row || !token.is_space()) && !ends_equation(token);
        if in_remark {
            continue;
        }
        // What an expression gives, behind it in brackets: 2^11 (= 2048).
        if depth == 0 && token.is_sign('(') && next.is_some_and(|next| next.is_sign('=')) {
            in_result = true;
            continue;
        }
        if in_result && depth == 0 && token.is_sign(')') {
            in_result = false;
            splitter.end_chain(false, false);
            continue;
        }
        // A bracket around whole equations holds them apart.
        if depth == 0 && brackets.iter().any(|(open, close)| *open == at || *close == at) {
            splitter.end_chain(false, false);
            continue;
        }
        if token.is_one_of("([{⌊⌈") {
            depth += 1;
        } else if token.is_one_of(")]}⌋⌉") {
            depth = depth.saturating_sub(1);
        }
        let line = token.kind == TokenKind::Line;
        let wide = matches!(token.kind, TokenKind::Space(width) if width >= 9);
        if wide && previous_is_line {
            continue;
        }
        if !token.is_space() {
            previous_is_line = line;
        }
        if line || wide {
            // A right side to be filled in, as in all rows.
            if is_sheet && splitter.last().is_none() && splitter.relation.is_some() {
                splitter.end_chain(false, true);
                continue;
            }
            let continues = next.is_some_and(|next| next.is_one_of("=≈≅≃") || (line && next.is_one_of("+-×·")));
            if continues && line && splitter.ends_list() {
                splitter.side.push(Token::new(TokenKind::Unknown("the end of a list".to_owned()), token.span));
            }
            if continues {
                splitter.side.push(Token::new(TokenKind::Space(if line { ROW_END } else { 2 }), token.span));
                continue;
            }
            let last = splitter.last();
            if (last.is_none() && splitter.relation.is_some()) || last.is_some_and(|last| last.is_one_of("+-×·/")) {
                continue;
            }
            if depth > 0 && wide {
                splitter.side.push(Token::new(TokenKind::Space(2), token.span));
                continue;
            }
            let weak = line && !splitter.sides.is_empty();
            depth = 0;
            splitter.end_chain(false, true);
            let row = tokens[at + 1..].iter().skip_while(|token| ends_row(token)).take_while(|token| !ends_row(token));
            // Behind a whole equation, a number begins another one.
            let begins =
                next.is_some_and(|next| next.number().is_some()) && row.clone().any(|token| token.is_sign('='));
            let may_continue = !begins
                && next.is_some_and(|next| {
                    next.is_sign('(')
                        || matches!(next.kind, TokenKind::Function(_) | TokenKind::Fraction(..) | TokenKind::Number(_))
                });
            if weak && may_continue {
                splitter.side.push(Token::new(TokenKind::Unknown("the rest of the row before".to_owned()), token.span));
            }
            continue;
        }
        if depth == 0 {
            if let Some(relation) = relation(token) {
                splitter.end_side();
                splitter.relation = Some(relation);
                continue;
            }
            if separates(token) {
                let is = |token: Option<&Token>| token.is_some_and(|token| token.number().is_some());
                if token.is_sign('.') && is(next) && is(splitter.last()) {
                    splitter
                        .side
                        .push(Token::new(TokenKind::Unknown("a point between numbers".to_owned()), token.span));
                    continue;
                }
                // A time of day, a ratio or a place in a text.
                let between = at > 0 && is(tokens.get(at - 1)) && is(tokens.get(at + 1));
                let has_space = at > 0 && tokens[at - 1].is_space();
                let is_divided = || !splitter.sides.is_empty() && divides(splitter.last(), next, has_space);
                if token.is_sign(':') && (between || is_divided()) {
                    splitter
                        .side
                        .push(Token::new(TokenKind::Unknown("a colon between numbers".to_owned()), token.span));
                    continue;
                }
                // Resistances side by side.
                if token.is_sign('∥') && splitter.side.last().is_some() && is(next) && has_number(&splitter.side) {
                    splitter.side.push(Token::new(TokenKind::Unknown("a parallel".to_owned()), token.span));
                    continue;
                }
                // A factorial, not the end of a sentence.
                let ends = following[at + 1] >= tokens.len();
                if token.is_sign('!') && splitter.last().is_some() && !ends {
                    splitter.side.push(token.clone());
                    continue;
                }
                let is_of = token.word() == Some("of");
                let percent = splitter.last().and_then(Token::word).is_some_and(is_percent);
                let is_price = next.and_then(Token::word).is_some_and(|sign| currency(sign).is_some());
                if token.word().is_some_and(joins_share) && percent && (is(next) || is_price) {
                    splitter.side.push(Token::new(TokenKind::Operator('×'), token.span));
                    continue;
                }
                // A change of state, or a part of what follows.
                let named = |token: &Token| match &token.kind {
                    TokenKind::Name(_) => true,
                    TokenKind::Word(word) => unit(word).is_none(),
                    _ => false,
                };
                let joins = (token.is_one_of("→↔") || is_of)
                    && next.is_some_and(|next| !matches!(next.kind, TokenKind::Name(_) | TokenKind::Word(_)))
                    && splitter.sides.is_empty()
                    && has_number(&splitter.side)
                    && !splitter.side.iter().any(named);
                // A quotient with a colon, but no number of an item.
                let tail = splitter.side.iter().rposition(named).map_or(0, |at| at + 1);
                let tail = &splitter.side[tail..];
                let quotient = token.is_sign(':')
                    && next.is_some_and(|next| {
                        matches!(next.kind, TokenKind::Number(_) | TokenKind::Fraction(..)) || next.is_sign('(')
                    })
                    && splitter.sides.is_empty()
                    && has_number(tail)
                    && (trim_space(tail).len() > 1
                        || splitter.side.last().is_some_and(Token::is_space)
                        || next.is_none_or(|next| next.number().is_none()));
                let words =
                    splitter.side.iter().any(|token| matches!(token.kind, TokenKind::Word(_) | TokenKind::Name(_)));
                let numbers = splitter.sides.is_empty() && !words && has_number(&splitter.side);
                splitter.end_chain(token.is_sign('?'), false);
                splitter.listed = token.is_sign(',');
                if joins || quotient {
                    splitter.parted = ChainSeparation::FromNumbers;
                } else if token.is_one_of(",.") {
                    splitter.parted = if numbers { ChainSeparation::FromNumbers } else { ChainSeparation::ByMark };
                }
                // A sum that goes on in the next row behind a comma: its terms are not all here.
                let row_ends = tokens[at + 1..following[at + 1]].iter().any(ends_row);
                if token.is_sign(',') && row_ends && next.is_some_and(|next| next.is_one_of("+-")) {
                    splitter
                        .side
                        .push(Token::new(TokenKind::Unknown("the rest of the row before".to_owned()), token.span));
                }
                continue;
            }
        }
        splitter.side.push(token.clone());
    }
    splitter.end_chain(false, false);
    splitter.chains
}
