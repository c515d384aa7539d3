//! Formulas as they are printed: read character by character, and evaluated.
//!
//! [`Display::read`] makes a tree of the characters between two dollar signs; [`Moment`] says what its names stand for.
//! The tree is evaluated on real or complex numbers and vectors, or, for a proof, as an expression over any field.
//! Nothing is taken from the formula crates' own identities, so what is found here is found about the characters.
//! [`misprints`] makes slips by rule, to see that each would be noticed.

mod apart;
mod changed;
mod exact;
mod misprints;
mod moment;
mod number;
mod pieces;
mod places;
mod reader;
mod tree;
mod value;

pub use changed::changed_part;
pub use exact::{Exact, decide, decide_joined, decide_multiple};
pub use geneva_exact::Expression;
pub use misprints::{Class, Misprint, misprints};
pub use moment::{Letters, Moment, by_name};
pub use number::Number;
pub use pieces::{GREEK, Piece, pieces};
pub use places::places_changed;
pub use tree::By;
pub use value::Value;

use crate::Finding;
use crate::tolerance::{DIFFERENCES, ROUTES};
use reader::Brackets;
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::rc::Rc;
use tree::{Function, Node};

/// What of a formula has no meaning here.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the formula cannot be evaluated: {0}")]
pub struct Illegible(String);

/// The one spelling of a name that TeX may write in several ways: without braces, type faces and backslashes, its dots
/// behind the letter as `theta'`, `theta''_0`.
///
/// # Errors
///
/// If it is not one name.
pub fn name(tex: &str) -> Result<String, Illegible> {
    reader::name(tex)
}

/// The name of what something is at an instant that a formula names.
pub fn name_at(name: &str, instant: &str) -> String {
    format!("{name} at {instant}")
}

/// A display: its number, if it has one, and its chains of equal things, of one alone if it equates nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Display {
    /// The number at its side.
    pub tag: Option<String>,
    chains: Vec<Vec<Node>>,
}

impl Display {
    /// Reads a display.
    ///
    /// # Errors
    ///
    /// If something in it has no meaning here.
    pub fn read(tex: &str) -> Result<Self, Illegible> {
        reader::read(tex, Brackets::Matched)
    }

    /// Reads a display in which any kind of bracket closes any other, as lines of a source do that are printed apart.
    ///
    /// # Errors
    ///
    /// If something in it has no meaning here.
    pub fn read_joined(tex: &str) -> Result<Self, Illegible> {
        reader::read(tex, Brackets::OfAnyKind)
    }

    /// Reads what may be a part of a longer display: brackets that are left open at the end of a side are closed there,
    /// those closed too often are passed over, and any kind closes any other.
    ///
    /// # Errors
    ///
    /// If something in it has no meaning here.
    pub fn read_part(tex: &str) -> Result<Self, Illegible> {
        reader::read(tex, Brackets::Cut)
    }

    /// Whether all its chains hold at all of these instants; where a double sign stands, for one of the signs, and each sign
    /// must be needed at one of the instants.
    ///
    /// # Errors
    ///
    /// If it equates nothing, or if a name stands for nothing.
    pub fn holds<'a, N: Number>(&self, moments: impl IntoIterator<Item = &'a Moment<N>>) -> Result<bool, Illegible> {
        self.equates()?;
        let any = |is: fn(&Node) -> bool| self.chains.iter().flatten().any(|side| side.contains(is));
        let differs = any(|node| matches!(node, Node::Of(Function::Rate(_), _)));
        let allowed = if differs { DIFFERENCES } else { ROUTES }.relative;
        let is_double = self.has_double_sign();
        let signs = if is_double { &[1, -1][..] } else { &[1] };
        // Of each sign, whether it is the only one at an instant.
        let mut needed = [false; 2];
        for moment in moments {
            for chain in &self.chains {
                let agrees = |sign: &i64| Ok(moment.misfit(chain, *sign)? <= allowed);
                match signs.iter().map(agrees).collect::<Result<Vec<bool>, Illegible>>()?[..] {
                    [true, false] => needed[0] = true,
                    [false, true] => needed[1] = true,
                    [true] | [true, true] => {}
                    _ => return Ok(false),
                }
            }
        }
        Ok(!is_double || needed == [true; 2])
    }

    /// Whether a double sign is in it.
    fn has_double_sign(&self) -> bool {
        let is_double = |node: &Node| matches!(node, Node::Of(Function::PlusMinus, _));
        self.chains.iter().flatten().any(|side| side.contains(is_double))
    }

    /// The display, if no number is at its side: that of a claim's equation is in its locator.
    fn without_number(self) -> Result<Self, Illegible> {
        match self.tag {
            Some(tag) => Err(Illegible(format!("the number {tag} in an equation, which belongs to its locator"))),
            None => Ok(self),
        }
    }

    /// Makes sure that it says something: that each of its chains has two sides, and none is equated with itself.
    fn equates(&self) -> Result<(), Illegible> {
        if self.chains.is_empty() || self.chains.iter().any(|chain| chain.len() < 2) {
            return Err(Illegible("it equates nothing".to_owned()));
        }
        if self.chains.iter().flat_map(|chain| chain.windows(2)).any(|pair| pair[0] == pair[1]) {
            return Err(Illegible("it equates something with itself".to_owned()));
        }
        Ok(())
    }

    /// Each side of an equation minus the next, with this sign for those that stand for both.
    fn differences<N: Number>(&self, moment: &Moment<N>, sign: i64) -> Result<Vec<N>, Illegible> {
        self.equates()?;
        let pairs = self.chains.iter().flat_map(|chain| chain.windows(2));
        let apart = pairs.map(|pair| moment.apart([&pair[0], &pair[1]], sign));
        Ok(apart.collect::<Result<Vec<_>, _>>()?.concat())
    }

    /// What stands alone in a display that equates nothing.
    fn alone(&self) -> Option<&Node> {
        match &self.chains[..] {
            [chain] if chain.len() == 1 => chain.first(),
            _ => None,
        }
    }
}

/// Whether an equation holds at all of these instants; none if it cannot be read.
pub fn holds<'a, N: Number>(tex: &str, moments: impl IntoIterator<Item = &'a Moment<N>>) -> Option<bool> {
    Display::read(tex).and_then(Display::without_number).and_then(|display| display.holds(moments)).ok()
}

/// What is found when an equation is read and evaluated at all of these instants: whether it holds, or what in it cannot be read.
///
/// ```
/// use geneva_evidence::tex::{Moment, equation_finding};
///
/// let moment = Moment::default().with([("v", 19.62), ("g", 9.81)]);
/// let found = equation_finding("v = g t", &[moment.clone()]);
/// assert_eq!(found.how, "the formula cannot be evaluated: the name t stands for nothing");
/// assert!(equation_finding("v = g t", &[moment.with([("t", 2.0)])]).holds);
/// ```
pub fn equation_finding<'a, N: Number>(tex: &str, moments: impl IntoIterator<Item = &'a Moment<N>>) -> Finding {
    match Display::read(tex).and_then(Display::without_number).and_then(|display| display.holds(moments)) {
        Ok(holds) => Finding::of_reading(Some(holds)),
        Err(illegible) => Finding::not_evaluated(illegible.to_string()),
    }
}

/// Whether an equation of joined lines holds at all of these instants; none if it cannot be read.
pub fn joined_holds<'a, N: Number>(tex: &str, moments: impl IntoIterator<Item = &'a Moment<N>>) -> Option<bool> {
    Display::read_joined(tex).and_then(Display::without_number).and_then(|display| display.holds(moments)).ok()
}

/// The value of a formula without an equals sign; not a number if it cannot be read or a letter has no value.
pub fn value(formula: &str, letters: &Letters) -> f64 {
    value_at(formula, &Moment::of(letters.clone()))
}

/// The value of a formula without an equals sign at an instant; not a number if it cannot be read or a letter has no value.
pub fn value_at(formula: &str, moment: &Moment) -> f64 {
    read_again(formula).and_then(|display| moment.number(display.alone()?).ok()).unwrap_or(f64::NAN)
}

thread_local! {
    /// The formula without an equals sign that this thread has read last.
    static LAST_READ: RefCell<(String, Option<Rc<Display>>)> = const { RefCell::new((String::new(), None)) };
}

/// A formula as it is read, none if it cannot be; one that is evaluated at many places is read once.
fn read_again(formula: &str) -> Option<Rc<Display>> {
    LAST_READ.with_borrow_mut(|(last, display)| {
        if last != formula {
            *display = Display::read(formula).and_then(Display::without_number).ok().map(Rc::new);
            formula.clone_into(last);
        }
        display.clone()
    })
}

/// The letters that a formula needs; none if it cannot be read.
pub fn letters_in(formula: &str) -> BTreeSet<String> {
    let mut letters = BTreeSet::new();
    if let Ok(display) = Display::read_part(formula) {
        for side in display.chains.iter().flatten() {
            side.visit(&mut |node| {
                if let Node::Name(name) = node {
                    letters.insert(name.clone());
                }
            });
        }
    }
    letters.remove("pi");
    letters
}

#[cfg(test)]
mod tests;
