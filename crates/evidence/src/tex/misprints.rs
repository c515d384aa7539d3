//! Misprints of equations, made by a rule: each piece of a formula, changed in every way that a slip might change it.
//!
//! An equation that is right must not be right any more with a misprint in it; else nobody has looked at the place. The
//! sources' own slips are of these kinds: a lost dot, a lost sign, another letter, another power.

use super::pieces::{Piece, pieces};
use std::collections::BTreeSet;

/// A formula with one misprint.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misprint {
    /// The formula.
    pub tex: String,
    /// What was changed.
    pub class: Class,
    /// The change in words, with the number of the piece.
    pub change: String,
}

/// The kinds of misprints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Class {
    /// Plus for minus, minus for plus, both for one of them, or a minus before a side that has no sign.
    Sign,
    /// One function for another.
    Function,
    /// A dot lost or added.
    Dot,
    /// A number one more or one less, so that a factor 2 is lost; half a power more or less by one.
    Number,
    /// Another letter of the same formula, or none.
    Letter,
    /// An exponent lost.
    Exponent,
    /// An index lost.
    Index,
    /// A root lost.
    Root,
    /// A fraction turned over.
    Fraction,
    /// Bars that become brackets.
    Bars,
    /// Greater for less.
    Relation,
}

impl Class {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Sign,
        Self::Function,
        Self::Dot,
        Self::Number,
        Self::Letter,
        Self::Exponent,
        Self::Index,
        Self::Root,
        Self::Fraction,
        Self::Bars,
        Self::Relation,
    ];
}

/// All misprints of a formula.
pub fn misprints(tex: &str) -> Vec<Misprint> {
    let mut whole = with_words(pieces(tex));
    // The number of a display is not part of what it says.
    whole.truncate(whole.iter().position(|piece| piece.text == r"\tag").unwrap_or(whole.len()));
    let mut made = Made { tex, pieces: &whole, found: Vec::new() };
    for at in 0..whole.len() {
        made.of_signs(at);
        made.of_marks(at);
        made.of_letters(at);
        made.of_fractions(at);
    }
    made.of_bars();
    made.found
}

/// The pieces with a word for one of them.
fn with_words(pieces: Vec<Piece>) -> Vec<Piece> {
    let mut with_words: Vec<Piece> = Vec::new();
    let mut open = false;
    for piece in pieces {
        match with_words.last_mut() {
            Some(word) if open => {
                word.text += &piece.text;
                word.end = piece.end;
                open = piece.text != "}";
            }
            _ => {
                open = piece.text == r"\text";
                with_words.push(piece);
            }
        }
    }
    with_words
}

/// The misprints made so far.
struct Made<'a> {
    tex: &'a str,
    pieces: &'a [Piece],
    found: Vec<Misprint>,
}

impl Made<'_> {
    fn text(&self, at: usize) -> &str {
        self.pieces.get(at).map_or("", |piece| piece.text.as_str())
    }

    /// Puts other characters in the place of the pieces from one up to another.
    fn put(&mut self, class: Class, (from, until): (usize, usize), with: &str, change: &str) {
        let start = self.pieces.get(from).map_or(self.tex.len(), |piece| piece.start);
        let end = if until > from { self.pieces[until - 1].end } else { start };
        let rest = &self.tex[end..];
        // A command ends where no letter follows.
        let command = with.starts_with('\\') && with.ends_with(|c: char| c.is_ascii_alphabetic());
        let letter = |tex: &str| tex.starts_with(|c: char| c.is_ascii_alphabetic());
        let gap = if command && letter(rest) { " " } else { "" };
        let before = &self.tex[..start];
        let open = before.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let follows = open.ends_with('\\') && open.len() < before.len();
        let parted = if follows && letter(if with.is_empty() { rest } else { with }) { " " } else { "" };
        let tex = format!("{before}{parted}{with}{gap}{rest}");
        self.found.push(Misprint { tex, class, change: format!("piece {from}: {change}") });
    }

    fn replace(&mut self, class: Class, at: usize, with: &str) {
        let change = format!("{} becomes {with}", self.text(at));
        self.put(class, (at, at + 1), with, &change);
    }

    fn of_signs(&mut self, at: usize) {
        match self.text(at) {
            sign @ ("+" | "-") => {
                self.replace(Class::Sign, at, if sign == "+" { "-" } else { "+" });
                self.replace(Class::Sign, at, r"\pm");
            }
            "<" => self.replace(Class::Relation, at, ">"),
            ">" => self.replace(Class::Relation, at, "<"),
            r"\leq" => self.replace(Class::Relation, at, r"\geq"),
            r"\geq" => self.replace(Class::Relation, at, r"\leq"),
            _ => {}
        }
        // A minus before a whole side that is not zero.
        let opens = at == 0 || self.text(at - 1) == "=";
        let signed = ["+", "-", r"\pm", "="].contains(&self.text(at)) || self.text(at).starts_with(r"\begin");
        let zero = self.text(at).trim_end_matches('.') == "0";
        if opens && !signed && !zero {
            self.put(Class::Sign, (at, at), "-", "a minus is put before it");
        }
    }

    /// Functions, dots, roots, exponents, indices, numbers.
    fn of_marks(&mut self, at: usize) {
        match self.text(at) {
            r"\sin" => self.replace(Class::Function, at, r"\cos"),
            r"\cos" => self.replace(Class::Function, at, r"\sin"),
            r"\tan" => self.replace(Class::Function, at, r"\sin"),
            r"\dot" => {
                self.replace(Class::Dot, at, r"\ddot");
                self.put(Class::Dot, (at, at + 1), "", "the dot is lost");
            }
            r"\ddot" => self.replace(Class::Dot, at, r"\dot"),
            r"\sqrt" => self.put(Class::Root, (at, at + 1), "", "the root is lost"),
            "^" => self.put(Class::Exponent, (at, self.group_end(at + 1)), "", "what is raised is lost"),
            "_" => self.put(Class::Index, (at, self.group_end(at + 1)), "", "the index is lost"),
            _ => {}
        }
        let Some(piece) = self.pieces.get(at).filter(|piece| piece.is_whole_number()) else { return };
        let Ok(number) = piece.text.parse::<u32>() else { return };
        // Half powers go by one too.
        let half = self.text(at + 1) == "/" && self.text(at + 2) == "2" && at > 1 && self.text(at - 2) == "^";
        for step in if half { vec![1, 2] } else { vec![1] } {
            self.replace(Class::Number, at, &(number + step).to_string());
            if let Some(less) = number.checked_sub(step) {
                self.replace(Class::Number, at, &less.to_string());
            }
        }
    }

    /// Whether there is a letter: of a formula, not the d of a derivative.
    fn is_letter(&self, at: usize) -> bool {
        let operator = |start: usize| {
            let found: Vec<&str> = (0..8).map(|piece| self.text(start + piece)).collect();
            found == [r"\frac", "{", "d", "}", "{", "d", "t", "}"]
        };
        let piece = &self.pieces[at];
        let inside = [2, 5, 6].iter().any(|place| at.checked_sub(*place).is_some_and(operator));
        (piece.is_letter() || piece.text.starts_with(r"\text{")) && !inside
    }

    /// Whether the letter is an index, below or raised.
    fn is_index(&self, at: usize) -> bool {
        let before = |back: usize| at.checked_sub(back).map_or("", |at| self.text(at));
        let marks = ["_", "^"];
        marks.contains(&before(1)) || (before(1) == "{" && marks.contains(&before(2)))
    }

    /// A letter with what hangs on it, as it stands: its index, and a raised letter.
    fn name(&self, at: usize) -> (usize, &str) {
        let mut end = if self.text(at + 1) == "_" { self.group_end(at + 2) } else { at + 1 };
        let raised = if self.text(end + 1) == "{" { end + 2 } else { end + 1 };
        if self.text(end) == "^" && self.pieces.get(raised).is_some_and(Piece::is_letter) {
            end = self.group_end(end + 1);
        }
        (end, &self.tex[self.pieces[at].start..self.pieces[end - 1].end])
    }

    fn of_letters(&mut self, at: usize) {
        // What is differentiated is kept.
        let differentiated = at > 2 && self.text(at - 1) == r"\partial" && self.text(at - 3) == r"\frac";
        if !self.is_letter(at) || differentiated {
            return;
        }
        // An index becomes another index, a letter with its index another one with its own.
        let index = self.is_index(at);
        let named = |at: usize| if index { (at + 1, self.text(at)) } else { self.name(at) };
        let alike = |other: &usize| self.is_letter(*other) && self.is_index(*other) == index;
        let names: BTreeSet<String> = (0..self.pieces.len()).filter(alike).map(|at| named(at).1.to_owned()).collect();
        let (end, name) = (named(at).0, named(at).1.to_owned());
        // Blanks in a word say nothing.
        let plain = |name: &str| name.replace(' ', "");
        for other in names.iter().filter(|other| plain(other) != plain(&name)) {
            self.put(Class::Letter, (at, end), other, &format!("{name} becomes {other}"));
        }
        if index {
            return;
        }
        let before = if at == 0 { String::new() } else { self.text(at - 1).to_owned() };
        let over = if before == "{" && at > 1 { self.text(at - 2) } else { &before };
        if over == r"\dot" || over == r"\ddot" {
            return;
        }
        let letter = self.text(at).to_owned();
        self.put(Class::Dot, (at, at + 1), &format!(r"\dot{{{letter}}}"), &format!("{letter} gets a dot"));
        // A factor is lost with its power; something must be left where it stood.
        let end = if self.text(end) == "^" { self.group_end(end + 1) } else { end };
        let opening = ["", "+", "-", "=", "(", "[", "{", "|", r"\left|", r"\{", "/", "^", "_"];
        let closing = ["", "+", "-", "=", ")", "]", "}", "|", r"\right|", r"\}", "/", r"\leq", "&", ",", ";"];
        let alone = opening.contains(&before.as_str()) && closing.contains(&self.text(end));
        let argument = [r"\sin", r"\cos", r"\tan", r"\sec", r"\partial"].contains(&before.as_str());
        if !alone && !argument {
            self.put(Class::Letter, (at, end), "", &format!("{name} is lost"));
        }
    }

    fn of_fractions(&mut self, at: usize) {
        let operator = self.text(at + 2) == r"\partial" || (self.text(at + 2) == "d" && self.text(at + 3) == "}");
        if self.text(at) == r"\frac" && self.text(at + 1) == "{" && !operator {
            let (middle, last) = (self.group_end(at + 1), self.group_end(self.group_end(at + 1)));
            let span =
                |from: usize, until: usize| self.tex[self.pieces[from].start..self.pieces[until - 1].end].to_owned();
            let turned = format!(r"\frac{}{}", span(middle, last), span(at + 1, middle));
            self.put(Class::Fraction, (at, last), &turned, "the fraction is turned over");
        }
        // One letter or number over another, without a line between.
        let plain =
            |at: usize| self.pieces.get(at).is_some_and(|p| p.is_letter() || p.is_whole_number() || p.text == r"\pi");
        let marked = |at: Option<usize>| at.is_some_and(|at| ["_", "^"].contains(&self.text(at)));
        let whole = !marked(at.checked_sub(2)) && !marked(Some(at + 2));
        if self.text(at) == "/" && at > 0 && plain(at - 1) && plain(at + 1) && whole {
            let turned = format!("{} / {} ", self.text(at + 1), self.text(at - 1));
            self.put(Class::Fraction, (at - 1, at + 2), &turned, "the quotient is turned over");
        }
    }

    /// A pair of bars is lost as a whole, and brackets take its place.
    fn of_bars(&mut self) {
        let at: Vec<usize> = (0..self.pieces.len()).filter(|at| self.text(*at).ends_with('|')).collect();
        for (number, pair) in at.chunks_exact(2).enumerate() {
            let mut tex = self.tex.to_owned();
            for (at, bracket) in [(pair[1], ")"), (pair[0], "(")] {
                let Piece { text, start, end } = &self.pieces[at];
                let named = if tex[*start..*end].starts_with('\\') { text.trim_end_matches('|') } else { "" };
                tex.replace_range(*start..*end, &format!("{named}{bracket}"));
            }
            let change = format!("pair {number} of bars becomes brackets");
            self.found.push(Misprint { tex, class: Class::Bars, change });
        }
    }

    /// Where the argument that starts at a piece ends.
    fn group_end(&self, start: usize) -> usize {
        let mut depth = 0;
        for at in start..self.pieces.len() {
            depth += i32::from(self.text(at) == "{") - i32::from(self.text(at) == "}");
            if depth == 0 && ![r"\mathrm", r"\text", r"\dot", r"\ddot"].contains(&self.text(at)) {
                return at + 1;
            }
        }
        self.pieces.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn makes(tex: &str, class: Class, expected: &[&str]) {
        let found: Vec<_> = misprints(tex).into_iter().filter(|m| m.class == class).map(|m| m.tex).collect();
        for one in expected {
            assert!(found.iter().any(|tex| tex == one), "{tex} does not give {one}, but {found:#?}");
        }
    }

    #[test]
    fn every_class_is_made_and_what_is_not_changed_stays_as_it_is() {
        makes("a = b - c", Class::Sign, &["-a = b - c", "a = -b - c", "a = b + c", r"a = b \pm c"]);
        makes(r"\sin x + \tan y", Class::Function, &[r"\cos x + \tan y", r"\sin x + \sin y"]);
        makes(r"\dot{x} + \ddot\theta a", Class::Dot, &[r"{x} + \ddot\theta a", r"\ddot{x} + \ddot\theta a"]);
        makes(r"\dot{x} + \ddot\theta a", Class::Dot, &[r"\dot{x} + \dot\theta a", r"\dot{x} + \ddot\theta \dot{a}"]);
        makes("x^{3/2} 2", Class::Number, &["x^{5/2} 2", "x^{1/2} 2", "x^{4/2} 2", "x^{3/2} 1"]);
        makes(r"I_fa\theta_D", Class::Letter, &[r"I_Da\theta_D", r"I_f\theta_D\theta_D", r"I_f\theta_D", r"I_faI_f"]);
        makes(r"\frac{d}{dt} x\text{IC}", Class::Letter, &[r"\frac{d}{dt} \text{IC}\text{IC}", r"\frac{d}{dt} xx"]);
        makes("x^{1/2} y^2", Class::Exponent, &["x y^2", "x^{1/2} y"]);
        makes(r"\tau_1 + I_\theta", Class::Index, &[r"\tau + I_\theta", r"\tau_1 + I"]);
        makes(r"\sqrt{2}", Class::Root, &["{2}"]);
        makes(r"\frac{a}{b} n/m", Class::Fraction, &[r"\frac{b}{a} n/m", r"\frac{a}{b} m / n "]);
        makes(r"|a| + \left| b \right|", Class::Bars, &[r"(a) + \left| b \right|", r"|a| + \left( b \right)"]);
        makes(r"a \leq b", Class::Relation, &[r"a \geq b"]);
        makes(r"a = \cos\theta", Class::Letter, &[r"a = \cos a"]);
    }
}
