//! How a claim is written down: its place, what it prints, and one route after the other.

use crate::tex::{Exact, decide, decide_joined, holds};
use crate::{
    Check, ChoiceFn, Claim, DecisionFn, Document, Erratum, Evidence, Finding, Kind, NumberFn, ReadingFn, Route, Slip,
    Stated, Verdict, Vocabulary,
};
use std::marker::PhantomData;
use std::panic::Location;
use std::sync::Arc;

/// A place in a source, at which its claims are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Locator {
    document: &'static Document,
    text: &'static str,
}

/// A text that lives as long as the program, for the id, the place or the meaning of a claim that is made from a table. A claim is made
/// once, so nothing is kept twice.
///
/// ```
/// let ids = ["friction", "torque"].map(|name| geneva_evidence::intern(format!("leaflet.run-1.{name}")));
/// assert_eq!(ids, ["leaflet.run-1.friction", "leaflet.run-1.torque"]);
/// ```
pub fn intern(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

/// A claim whose check is not yet given. Two routes complete it.
pub struct Unchecked<R: ?Sized> {
    claim: Claim,
    routes: PhantomData<Arc<R>>,
}

/// A claim that has one route and needs a witness.
pub struct Unwitnessed<R: ?Sized> {
    claim: Claim,
    first: Route<R>,
}

impl Locator {
    /// A place in the source, in the manner of a printed errata list.
    pub const fn new(document: &'static Document, text: &'static str) -> Self {
        Self { document, text }
    }

    /// The words that say where, as its claims bear them.
    pub const fn text(self) -> &'static str {
        self.text
    }

    /// A printed number with its unit.
    #[track_caller]
    pub fn value(
        self,
        id: &'static str,
        printed: &'static str,
        unit: &'static str,
        meaning: &'static str,
    ) -> Unchecked<NumberFn> {
        let unchecked = self.claim(Kind::Value, id, printed, meaning);
        Unchecked { claim: Claim { unit, ..unchecked.claim }, ..unchecked }
    }

    /// An equation or a formula.
    #[track_caller]
    pub fn equation(self, id: &'static str, printed: &'static str, meaning: &'static str) -> Unchecked<DecisionFn> {
        self.claim(Kind::Equation, id, printed, meaning)
    }

    /// A figure, or what a text says of one.
    #[track_caller]
    pub fn figure(self, id: &'static str, printed: &'static str, meaning: &'static str) -> Unchecked<ChoiceFn> {
        self.claim(Kind::Figure, id, printed, meaning)
    }

    /// A sentence that can be checked.
    #[track_caller]
    pub fn statement(self, id: &'static str, printed: &'static str, meaning: &'static str) -> Unchecked<ChoiceFn> {
        self.claim(Kind::Statement, id, printed, meaning)
    }

    /// Sizes of something that is built as an example, of which the claim is that it works.
    #[track_caller]
    pub fn example(self, id: &'static str, printed: &'static str, meaning: &'static str) -> Unchecked<ChoiceFn> {
        self.claim(Kind::Example, id, printed, meaning)
    }

    /// A drawing that the source refers to and the copy lacks. What the text says of it is in claims of its own.
    #[track_caller]
    pub fn lost_drawing(self, id: &'static str, printed: &'static str, meaning: &'static str) -> Claim {
        self.figure(id, printed, meaning).missing(
            "The copy we had does not contain the drawing. What the text reads off the drawing is covered by other claims",
        )
    }

    #[track_caller]
    fn claim<R: ?Sized>(
        self,
        kind: Kind,
        id: &'static str,
        printed: &'static str,
        meaning: &'static str,
    ) -> Unchecked<R> {
        let claim = Claim {
            id,
            document: self.document,
            locator: self.text,
            kind,
            meaning,
            printed,
            unit: "",
            check: Check::Missing { reason: "" },
            expected: Verdict::Reproduced,
            reading: None,
            erratum: None,
            stated_at: Location::caller(),
        };
        Unchecked { claim, routes: PhantomData }
    }
}

impl<R: ?Sized> Unchecked<R> {
    /// Records that the claim cannot be checked, because a value is missing from the source.
    pub fn missing(self, reason: &'static str) -> Claim {
        Claim { check: Check::Missing { reason }, expected: Verdict::NotReproducible, ..self.claim }
    }

    #[track_caller]
    fn first(self, evidence: &'static Evidence, run: Arc<R>) -> Unwitnessed<R> {
        Unwitnessed { claim: self.claim, first: Route::new(evidence, run) }
    }
}

impl Unchecked<NumberFn> {
    /// What the source says it did gives this number, in the printed unit.
    #[track_caller]
    pub fn first_route(
        self,
        evidence: &'static Evidence,
        run: impl Fn() -> f64 + Send + Sync + 'static,
    ) -> Unwitnessed<NumberFn> {
        self.first(evidence, Arc::new(run))
    }
}

impl Unwitnessed<NumberFn> {
    /// A route to the same number that shares no code with the first.
    #[track_caller]
    pub fn second_route(self, evidence: &'static Evidence, run: impl Fn() -> f64 + Send + Sync + 'static) -> Claim {
        let witness = Route::new(evidence, Arc::new(run) as Arc<NumberFn>);
        let check = Check::Number { computed: self.first, witness, from_rounded: None, resolution: None, right: None };
        Claim { check, ..self.claim }
    }
}

impl Unchecked<DecisionFn> {
    /// Both routes read the printed characters: the proof with the exact meaning of the letters, the witness with their
    /// numbers.
    pub fn in_letters(self, vocabulary: Vocabulary) -> Claim {
        let Vocabulary { exact, evidence, numbers, stated_at } = vocabulary;
        self.proven_by(exact).read(evidence, move |tex| holds(tex, numbers())).with_letters_at(stated_at)
    }

    /// Reads an equation whose characters leave something out, as [`Unchecked::in_letters`] does. `whole` says the characters
    /// in full.
    pub fn rewritten_and_proven(
        self,
        vocabulary: Vocabulary,
        whole: impl Fn(&str) -> String + Clone + Send + Sync + 'static,
    ) -> Claim {
        let Vocabulary { exact, evidence, numbers, stated_at } = vocabulary;
        let again = whole.clone();
        let claim = self
            .decided(move |tex| decide(&whole(tex), exact))
            .read(evidence, move |tex| holds(&again(tex), numbers()));
        claim.with_letters_at(stated_at)
    }

    /// The printed characters are proven with these letters. If they are corrected, they are refuted, and the corrected
    /// ones are proven.
    #[track_caller]
    pub fn proven_by(self, letters: Exact) -> Unwitnessed<DecisionFn> {
        self.decided(move |tex| decide(tex, letters))
    }

    /// Proves the characters in a display that is cut into lines, each a claim of its own. The other lines have their
    /// right characters.
    #[track_caller]
    pub fn proven_in(self, lines: &'static [&'static str], letters: Exact) -> Unwitnessed<DecisionFn> {
        let (document, own) = (self.claim.document, self.claim.id);
        self.decided(move |tex| decide_joined(&document.display(lines, own, tex), letters))
    }

    /// Decides on the equation by a function that proves or refutes characters in the place of the printed ones.
    #[track_caller]
    pub fn decided(self, decide: impl Fn(&str) -> Finding + Send + Sync + 'static) -> Unwitnessed<DecisionFn> {
        self.evaluated(Evidence::EXACT_IDENTITY, decide)
    }

    /// Decides on the equation by a function that evaluates the characters.
    #[track_caller]
    pub fn evaluated(
        self,
        evidence: &'static Evidence,
        decide: impl Fn(&str) -> Finding + Send + Sync + 'static,
    ) -> Unwitnessed<DecisionFn> {
        self.first(evidence, Arc::new(decide))
    }
}

impl Unwitnessed<DecisionFn> {
    /// The right characters hold wherever they are read and evaluated, and the printed ones do not if they are corrected.
    #[track_caller]
    pub fn read(
        self,
        evidence: &'static Evidence,
        holds: impl Fn(&str) -> Option<bool> + Send + Sync + 'static,
    ) -> Claim {
        let witness = Route::new(evidence, Arc::new(holds) as Arc<ReadingFn>);
        let check = Check::Equation { first: self.first, witness, said: None, also: None };
        Claim { check, ..self.claim }
    }

    /// Reads the characters in a display that is cut into lines, each a claim of its own. The other lines have their
    /// right characters.
    #[track_caller]
    pub fn read_in(
        self,
        evidence: &'static Evidence,
        lines: &'static [&'static str],
        holds: impl Fn(&str) -> Option<bool> + Send + Sync + 'static,
    ) -> Claim {
        let (document, own) = (self.claim.document, self.claim.id);
        self.read(evidence, move |tex| holds(&document.display(lines, own, tex)))
    }
}

impl Unchecked<ChoiceFn> {
    /// Whether the right statement holds, and its neighbour.
    #[track_caller]
    pub fn first_route(
        self,
        evidence: &'static Evidence,
        run: impl Fn(Stated<'_>) -> Finding + Send + Sync + 'static,
    ) -> Unwitnessed<ChoiceFn> {
        self.first(evidence, Arc::new(run))
    }
}

impl Unwitnessed<ChoiceFn> {
    /// Adds the witness, a route that shares no code with the first. Until [`Claim::but_not`] names another neighbour,
    /// the wrong statement is the printed one.
    #[track_caller]
    pub fn second_route(
        self,
        evidence: &'static Evidence,
        run: impl Fn(Stated<'_>) -> Finding + Send + Sync + 'static,
    ) -> Claim {
        let witness = Route::new(evidence, Arc::new(run) as Arc<ChoiceFn>);
        Claim { check: Check::Statement { first: self.first, witness, neighbour: None }, ..self.claim }
    }
}

impl Claim {
    /// What the source's own rounded intermediate results give.
    #[must_use]
    pub fn rounded(mut self, run: impl Fn() -> f64 + Send + Sync + 'static) -> Self {
        let Check::Number { from_rounded, .. } = &mut self.check else { self.has_no("the source's rounded results") };
        *from_rounded = Some(Arc::new(run));
        self
    }

    /// How finely the number could be read, in the printed unit.
    #[must_use]
    pub fn with_resolution(mut self, unit: impl Fn() -> f64 + Send + Sync + 'static) -> Self {
        let Check::Number { resolution, .. } = &mut self.check else { self.has_no("a resolution") };
        *resolution = Some(Arc::new(unit));
        self
    }

    /// The right number by two routes, if the routes to the printed one follow a slip of the source.
    #[must_use]
    #[track_caller]
    pub fn right(
        mut self,
        evidence: &'static Evidence,
        run: impl Fn() -> f64 + Send + Sync + 'static,
        other: &'static Evidence,
        again: impl Fn() -> f64 + Send + Sync + 'static,
    ) -> Self {
        let Check::Number { right, .. } = &mut self.check else { self.has_no("a right number") };
        *right = Some([Route::new(evidence, Arc::new(run)), Route::new(other, Arc::new(again))]);
        self
    }

    /// Adds something else that shows which equation is right, beside the witness that reads the characters.
    #[must_use]
    #[track_caller]
    pub fn with_second_witness(
        mut self,
        evidence: &'static Evidence,
        run: impl Fn() -> Finding + Send + Sync + 'static,
    ) -> Self {
        let Check::Equation { also, .. } = &mut self.check else { self.has_no("another witness") };
        *also = Some(Route::new(evidence, Arc::new(run)));
        self
    }

    /// Says where the letters are that both routes to an equation read.
    fn with_letters_at(mut self, place: &'static Location<'static>) -> Self {
        if let Check::Equation { first, witness, .. } = &mut self.check {
            (first.stated_at, witness.stated_at) = (place, place);
        }
        self
    }

    /// What characters that are not ours to print say, in the letters of mathematics; both are read.
    #[must_use]
    pub fn in_other_letters(mut self, what: &'static str) -> Self {
        let Check::Equation { said, .. } = &mut self.check else { self.has_no("what is read") };
        *said = Some(what);
        self
    }

    /// The neighbour of a statement that is right as printed: what both routes must refuse.
    #[must_use]
    pub fn but_not(mut self, wrong: &'static str) -> Self {
        let Check::Statement { neighbour, .. } = &mut self.check else { self.has_no("a neighbour") };
        *neighbour = Some(wrong);
        self
    }

    /// Says how a vague sentence is read.
    #[must_use]
    pub fn interpreted_as(self, reading: &'static str) -> Self {
        Self { reading: Some(reading), ..self }
    }

    /// Records another verdict than `reproduced`.
    #[must_use]
    pub fn expecting(self, expected: Verdict) -> Self {
        Self { expected, ..self }
    }

    /// Records that what is printed is wrong, and what it should be.
    #[must_use]
    pub fn corrected(self, corrected: &'static str, slip: Slip) -> Self {
        self.expecting(Verdict::Corrected).with_erratum(Erratum { corrected, places: 1, slip })
    }

    /// In how many places a correction of an equation changes its characters, if not in one.
    #[must_use]
    pub fn in_places(mut self, places: usize) -> Self {
        let Some(erratum) = &mut self.erratum else { self.has_no("a count of places, as nothing is corrected") };
        erratum.places = places;
        self
    }

    /// Records that the printed digits are what a slip of the source gives.
    #[must_use]
    pub fn in_error(self, slip: Slip) -> Self {
        self.expecting(Verdict::ReproducedInError).affected_by(slip)
    }

    /// Records an error as [`Claim::in_error`] does, with the right digits written down, because they need another last
    /// place than the printed ones.
    #[must_use]
    pub fn in_error_for(self, corrected: &'static str, slip: Slip) -> Self {
        self.expecting(Verdict::ReproducedInError).with_erratum(Erratum { corrected, places: 1, slip })
    }

    /// Records that a slip reaches this claim, where the right number tells whether it changes anything.
    #[must_use]
    pub fn affected_by(self, slip: Slip) -> Self {
        self.with_erratum(Erratum { corrected: "", places: 1, slip })
    }

    /// A claim is written down once, in the source text; a part that its check does not have is a mistake there.
    fn has_no(&self, part: &str) -> ! {
        panic!("{}: its check has no place for {part}", self.id)
    }

    /// Records an erratum. A slip without an id is one of this place and gets the claim's.
    #[must_use]
    fn with_erratum(self, erratum: Erratum) -> Self {
        let slip = if erratum.slip.id.is_empty() { Slip { id: self.id, ..erratum.slip } } else { erratum.slip };
        Self { erratum: Some(Erratum { slip, ..erratum }), ..self }
    }
}
