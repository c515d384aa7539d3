//! A document and its claims, as values, and what a claim of it prints, looked up by the claim's id.

use crate::slugs::slugs;
use crate::{
    Check, Decimal, Erratum, Finding, InventoryFile, Line, Malformed, Symbol, Verdict, inventory_file, nearest_name,
    numeric_tokens,
};
use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::fmt;
use std::hash::{Hash, Hasher};
use std::panic::Location;
use std::sync::OnceLock;

/// A document of which claims are made. It is a `static` beside its claims, which refer to it.
pub struct Document {
    /// Short name, as it starts the ids of its claims.
    pub slug: &'static str,
    /// What it is in a word or two, for a list of documents.
    pub title: &'static str,
    /// What the document is, in a line.
    pub citation: &'static str,
    /// The inventory of a document that is mirrored line by line; none for statements that are in no one document.
    pub inventory: Option<InventoryFile>,
    /// Makes the claims, in the order of the document. It may not look up a claim of the document while it does so, and stops if it
    /// does; the routes of the claims may.
    pub claims: fn() -> Vec<Claim>,
    /// The claims that print the answers to what a problem asks for; none if the document asks for no numbers.
    pub answers: &'static [&'static str],
    /// The claims that print what the document takes as given and computes with: both routes of its other numbers may use them.
    pub given: fn() -> Vec<String>,
    /// What the document concludes and a slip may make false: the claim, and what shows that it is a conclusion and no
    /// remark, its place or the words before it.
    pub conclusions: &'static [(&'static str, &'static str)],
    /// The document's letters and ours.
    pub symbols: &'static [Symbol],
    /// The units in which it prints its quantities.
    pub units: &'static [QuantityUnit],
    /// The command that tests its claims, for those who have the code. Empty if there is none.
    pub test: &'static str,
    /// What is made when it is first asked for.
    pub cache: Cache,
}

/// Words for a quantity, as the meaning of a claim has them, and the unit in which the document prints it; empty for none.
///
/// The words that come first in a claim's meaning count, and the longer ones of two that begin in the same place.
pub type QuantityUnit = (&'static str, &'static str);

/// What is made of a document when it is first asked for.
#[derive(Default)]
pub struct Cache {
    claims: OnceLock<Vec<Claim>>,
    positions: OnceLock<HashMap<&'static str, usize>>,
    lines: OnceLock<Result<Vec<Line>, Malformed>>,
}

/// What a document says in one place, how it is checked, and the verdict on record.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Stable id: the document's slug, then words joined by hyphens and points.
    pub id: &'static str,
    /// The document.
    pub document: &'static Document,
    /// Where in the document, in the manner of a printed errata list.
    pub locator: &'static str,
    /// What sort of claim.
    pub kind: Kind,
    /// What it says, in our words.
    pub meaning: &'static str,
    /// The printed characters.
    pub printed: &'static str,
    /// The unit of the printed number, as printed; empty for none.
    pub unit: &'static str,
    /// How it is checked.
    pub check: Check,
    /// The verdict on record, which the derived one must equal.
    pub expected: Verdict,
    /// Which reading of a vague sentence is checked: the kindest that its words bear.
    pub reading: Option<&'static str>,
    /// What is wrong, if something is.
    pub erratum: Option<Erratum>,
    /// The line of our code that states the claim.
    pub stated_at: &'static Location<'static>,
}

/// The sort of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A printed number.
    Value,
    /// An equation or a formula.
    Equation,
    /// A figure, or what a text says of one.
    Figure,
    /// A sentence that can be checked.
    Statement,
    /// Sizes of something that is built as an example. The source does not say that they are right. They come from a formula
    /// or a choice, so they are counted apart from what it says.
    Example,
}

slugs!(Kind {
    Value = "value",
    Equation = "equation",
    Figure = "figure",
    Statement = "statement",
    Example = "example",
});

thread_local! {
    /// The claims that this thread has looked up.
    static LOOKED_UP: RefCell<BTreeSet<&'static str>> = const { RefCell::new(BTreeSet::new()) };
}

thread_local! {
    /// The documents whose claims this thread is making.
    static MAKING: RefCell<Vec<&'static str>> = const { RefCell::new(Vec::new()) };
}

/// While it lives, this thread is making the claims of a document.
struct Making;

impl Making {
    fn begin(slug: &'static str) -> Self {
        MAKING.with_borrow_mut(|making| making.push(slug));
        Self
    }
}

impl Drop for Making {
    fn drop(&mut self) {
        MAKING.with_borrow_mut(Vec::pop);
    }
}

/// Runs a route of a claim. Returns its result with the ids of the claims that it looks up by id on the way, so that a test can
/// tell what the route rests on. What an earlier run has kept for later, or looks up on another thread, is not among them.
pub fn looked_up_by<T>(route: impl FnOnce() -> T) -> (T, BTreeSet<&'static str>) {
    let before = LOOKED_UP.take();
    let result = route();
    (result, LOOKED_UP.replace(before))
}

impl Cache {
    /// Nothing made yet.
    pub const fn new() -> Self {
        Self { claims: OnceLock::new(), positions: OnceLock::new(), lines: OnceLock::new() }
    }
}

impl Document {
    /// Whether it is mirrored line by line, so that its claims account for every number that it prints.
    pub fn is_mirrored(&self) -> bool {
        self.inventory.is_some()
    }

    /// Its claims, in their order.
    ///
    /// # Panics
    /// If it is called by the function that makes them, which would wait for itself for ever.
    pub fn claims(&'static self) -> &'static [Claim] {
        if let Some(claims) = self.cache.claims.get() {
            return claims;
        }
        let makes_them = MAKING.with_borrow(|making| making.contains(&self.slug));
        assert!(!makes_them, "{self}: a claim is looked up while the claims are being made; look it up in a route");
        self.cache.claims.get_or_init(|| {
            let _making = Making::begin(self.slug);
            (self.claims)()
        })
    }

    /// The claim with this id; none if there is no such claim.
    pub fn claim(&'static self, id: &str) -> Option<&'static Claim> {
        // Of two claims with one id the first counts.
        let positions =
            || self.claims().iter().enumerate().rev().map(|(position, claim)| (claim.id, position)).collect();
        self.cache.positions.get_or_init(positions).get(id).map(|position| &self.claims()[*position])
    }

    /// The document line by line: which claim or exception each printed number belongs to; empty if it is not mirrored. An
    /// error if its inventory file cannot be read.
    pub fn lines(&'static self) -> Result<&'static [Line], &'static Malformed> {
        let read = || self.inventory.map_or(Ok(Vec::new()), |file| inventory_file::parse(self.slug, file));
        self.cache.lines.get_or_init(read).as_ref().map(Vec::as_slice)
    }

    /// The inventory file that a copy of the document asks for: a line for each line with numbers; what the file says of
    /// a line is kept if its numbers have not changed.
    pub fn inventory_for(&self, copy: &str) -> String {
        inventory_file::updated(self.inventory.map_or("", |file| file.text), copy)
    }
}

/// What a claim prints, for the checks of other claims. The ids are written in the document's own text, so an id that no claim
/// has is a mistake there, which must not pass for a number or a verdict.
impl Document {
    /// The claim with this id.
    ///
    /// # Panics
    /// If no claim has the id; the message names the nearest that one has. The panic ends only the claim that asks: see
    /// [`judge`](crate::judge).
    pub fn lookup(&'static self, id: &str) -> &'static Claim {
        let claim = self.claim(id).unwrap_or_else(|| {
            let nearest = nearest_name(id, self.claims().iter().map(|claim| claim.id));
            panic!(
                "no claim has the id {id}; the nearest is {}",
                nearest.unwrap_or("that of no claim, as there is none")
            )
        });
        LOOKED_UP.with_borrow_mut(|ids| ids.insert(claim.id));
        claim
    }

    /// The characters printed in the claim with this id.
    ///
    /// # Panics
    /// As [`Document::lookup`].
    pub fn printed_text(&'static self, id: &str) -> &'static str {
        self.lookup(id).printed
    }

    /// The characters on the right of the first equals sign in the claim with this id.
    ///
    /// # Panics
    /// As [`Document::lookup`], and if there is no equals sign.
    pub fn right_side(&'static self, id: &str) -> &'static str {
        let text = self.printed_text(id);
        text.split_once('=').unwrap_or_else(|| panic!("{id} prints `{text}`, which has no equals sign")).1
    }

    /// The number printed in the claim with this id, with its digits.
    ///
    /// # Panics
    /// As [`Document::lookup`], and if the characters make no number.
    pub fn printed_decimal(&'static self, id: &str) -> Decimal {
        self.printed_text(id).parse().unwrap_or_else(|unreadable| panic!("{id}: {unreadable}"))
    }

    /// The number printed in the claim with this id, in the printed unit.
    ///
    /// # Panics
    /// As [`Document::printed_decimal`].
    pub fn printed_number(&'static self, id: &str) -> f64 {
        self.printed_decimal(id).to_f64()
    }

    /// Whether the number printed in the claim with this id is a rounding of `number`.
    ///
    /// # Panics
    /// As [`Document::printed_decimal`].
    pub fn prints_rounding_of(&'static self, id: &str, number: f64) -> bool {
        self.printed_decimal(id).is_rounding_of(number)
    }

    /// All integers in the characters printed in the claim with this id, in their order.
    ///
    /// # Panics
    /// As [`Document::lookup`].
    pub fn printed_integers(&'static self, id: &str) -> Vec<u32> {
        numeric_tokens(self.printed_text(id)).iter().filter_map(|token| token.parse().ok()).collect()
    }

    /// The interval that the digits printed in the claim with this id leave open: half a unit of the last place either way.
    ///
    /// # Panics
    /// As [`Document::printed_decimal`].
    pub fn printed_interval(&'static self, id: &str) -> [f64; 2] {
        self.printed_decimal(id).interval()
    }

    /// The characters of a display that is cut into lines, each a claim of its own: the right ones, but these for the line
    /// with the id `own`.
    pub(crate) fn display(&'static self, lines: &[&str], own: &str, tex: &str) -> String {
        let line = |id: &&str| if *id == own { tex } else { self.lookup(id).right_characters() };
        lines.iter().map(line).collect::<Vec<_>>().join(" ")
    }
}

impl PartialEq for Document {
    fn eq(&self, other: &Self) -> bool {
        self.slug == other.slug
    }
}

impl Eq for Document {}

impl Hash for Document {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.slug.hash(state);
    }
}

impl fmt::Debug for Document {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Document").field(&self.slug).finish()
    }
}

impl fmt::Display for Document {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.slug)
    }
}

impl Claim {
    /// The characters that are right: those of the correction, if there is one; what they say, if they are not printed.
    pub fn right_characters(&self) -> &'static str {
        self.right_for(self.printed)
    }

    /// Characters in the place of the printed ones, or a number beside them, with the claim's unit.
    pub fn with_unit(&self, characters: &str) -> String {
        let space = if self.unit.is_empty() || self.unit.starts_with('°') { "" } else { " " };
        format!("{characters}{space}{}", self.unit)
    }

    /// The characters that are right if these are printed.
    pub(crate) fn right_for<'a>(&self, printed: &'a str) -> &'a str {
        match (&self.check, &self.erratum) {
            (Check::Equation { said: Some(said), .. }, _) => said,
            (_, Some(erratum)) => erratum.corrected,
            (_, None) => printed,
        }
    }

    /// Whether characters would hold in the place of the right ones of an equation, by the first route and by the witness;
    /// none of what a route cannot read. None at all if it is no equation.
    pub fn read_with(&self, tex: &str) -> Option<[Option<bool>; 2]> {
        let Check::Equation { first, witness, .. } = &self.check else { return None };
        let found = (first.run)(tex);
        Some([found.evaluated.then_some(found.holds), (witness.run)(tex)])
    }

    /// Whether the claim of an equation would stand with other characters in the place of the right ones, by both routes.
    /// None if a route cannot read them and none refuses them.
    pub fn stands_with(&self, tex: &str) -> Option<bool> {
        match self.read_with(tex)? {
            [Some(false), _] | [_, Some(false)] => Some(false),
            [first, witness] => first.and(witness),
        }
    }

    /// What the witness of an equation finds: the right characters hold, read and evaluated, and the printed ones do not,
    /// if they are corrected. Characters that are said in the letters of mathematics hold as they are printed too.
    pub fn witnessed(&self) -> Finding {
        self.witnessed_as(self.printed)
    }

    /// What the witness of an equation finds if these characters are printed.
    pub(crate) fn witnessed_as(&self, printed: &str) -> Finding {
        let Check::Equation { witness, said, also, .. } = &self.check else {
            return Finding::not_evaluated("the claim is no equation");
        };
        let holds = &witness.run;
        let read = match (holds(self.right_for(printed)), &self.erratum) {
            (Some(true), None) if said.is_some() => Finding::of_reading(holds(printed)),
            (found @ None, _) | (found, None) => Finding::of_reading(found),
            (Some(right), Some(_)) => Finding::new(
                right && holds(printed) != Some(true),
                "values that must satisfy the equation satisfy only its corrected form",
            ),
        };
        match also {
            Some(also) => read.and((also.run)()),
            None => read,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Locator;

    /// A document that looks up a number of its own while its claims are being made.
    static HASTY: Document = Document {
        slug: "hasty",
        title: "hasty",
        citation: "A document that is made up",
        inventory: None,
        claims: || {
            let number = HASTY.printed_number("hasty.number");
            vec![
                Locator::new(&HASTY, "line 1")
                    .value("hasty.number", "1", "", "a number")
                    .missing(crate::intern(number.to_string())),
            ]
        },
        answers: &[],
        given: Vec::new,
        conclusions: &[],
        symbols: &[],
        units: &[],
        test: "",
        cache: Cache::new(),
    };

    #[test]
    fn a_claim_that_is_looked_up_while_the_claims_are_made_stops_and_does_not_wait_for_itself() {
        // A second time, too: nothing half-made is left.
        for _ in 0..2 {
            let stopped = std::panic::catch_unwind(|| HASTY.claims().len()).expect_err("it looks up what is not there");
            let message = stopped.downcast_ref::<String>().expect("a message");
            assert_eq!(message, "hasty: a claim is looked up while the claims are being made; look it up in a route");
        }
    }
}
