//! One row of the ledger.

use crate::by_id::in_display;
use crate::slugs::slugs;
use crate::tex::{Exact, decide, decide_joined, holds};
use crate::{
    Check, Choice, Decision, Erratum, Evidence, Finding, Number, Reading, Route, Slip, Stated, Verdict, Vocabulary,
    Work,
};
use std::marker::PhantomData;
use std::panic::Location;
use std::sync::Arc;

/// What a source says in one place, how it is checked, and the verdict on record.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Stable id: the work's slug, then words joined by hyphens and points.
    pub id: &'static str,
    /// The source.
    pub work: Work,
    /// Where in the source, in the manner of a printed errata list.
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
    /// Sizes of a mechanism that is built as an example. The source does not say that they are right. They come from a
    /// formula or a choice, so they are counted apart from what it says.
    Example,
}

/// A place in a source, at which its claims are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    work: Work,
    locator: &'static str,
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

impl Place {
    /// A place in the source, in the manner of a printed errata list.
    pub const fn new(work: Work, locator: &'static str) -> Self {
        Self { work, locator }
    }

    /// The locator that the place gives its claims.
    pub const fn locator(self) -> &'static str {
        self.locator
    }

    /// A printed number with its unit.
    #[track_caller]
    pub fn value(
        self,
        id: &'static str,
        printed: &'static str,
        unit: &'static str,
        meaning: &'static str,
    ) -> Unchecked<Number> {
        let unchecked = self.claim(Kind::Value, id, printed, meaning);
        Unchecked { claim: Claim { unit, ..unchecked.claim }, ..unchecked }
    }

    /// An equation or a formula.
    #[track_caller]
    pub fn equation(self, id: &'static str, printed: &'static str, meaning: &'static str) -> Unchecked<Decision> {
        self.claim(Kind::Equation, id, printed, meaning)
    }

    /// A figure, or what a text says of one.
    #[track_caller]
    pub fn figure(self, id: &'static str, printed: &'static str, meaning: &'static str) -> Unchecked<Choice> {
        self.claim(Kind::Figure, id, printed, meaning)
    }

    /// A sentence that can be checked.
    #[track_caller]
    pub fn statement(self, id: &'static str, printed: &'static str, meaning: &'static str) -> Unchecked<Choice> {
        self.claim(Kind::Statement, id, printed, meaning)
    }

    /// Sizes of a mechanism that is built as an example, of which the claim is that it works.
    #[track_caller]
    pub fn example(self, id: &'static str, printed: &'static str, meaning: &'static str) -> Unchecked<Choice> {
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
            work: self.work,
            locator: self.locator,
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

    fn first(self, evidence: Evidence, run: Arc<R>) -> Unwitnessed<R> {
        Unwitnessed { claim: self.claim, first: Route { evidence, run } }
    }
}

impl Unchecked<Number> {
    /// What the source says it did gives this number, in the printed unit.
    pub fn by(self, evidence: Evidence, run: impl Fn() -> f64 + Send + Sync + 'static) -> Unwitnessed<Number> {
        self.first(evidence, Arc::new(run))
    }
}

impl Unwitnessed<Number> {
    /// A route to the same number that shares no code with the first.
    pub fn by(self, evidence: Evidence, run: impl Fn() -> f64 + Send + Sync + 'static) -> Claim {
        let witness = Route { evidence, run: Arc::new(run) as Arc<Number> };
        let check = Check::Number { computed: self.first, witness, from_rounded: None, resolution: None, right: None };
        Claim { check, ..self.claim }
    }
}

impl Unchecked<Decision> {
    /// Both routes read the printed characters: the proof with the exact meaning of the letters, the witness with their
    /// numbers.
    pub fn in_letters(self, vocabulary: Vocabulary) -> Claim {
        let Vocabulary { exact, evidence, numbers } = vocabulary;
        self.proven_by(exact).read(evidence, move |tex| holds(tex, numbers()))
    }

    /// Reads an equation whose characters leave something out, as [`Unchecked::in_letters`] does. `whole` says the characters
    /// in full.
    pub fn rewritten_and_proven(
        self,
        vocabulary: Vocabulary,
        whole: impl Fn(&str) -> String + Clone + Send + Sync + 'static,
    ) -> Claim {
        let Vocabulary { exact, evidence, numbers } = vocabulary;
        let again = whole.clone();
        self.decided(move |tex| decide(&whole(tex), exact)).read(evidence, move |tex| holds(&again(tex), numbers()))
    }

    /// The printed characters are proven with these letters. If they are corrected, they are refuted, and the corrected
    /// ones are proven.
    pub fn proven_by(self, letters: Exact) -> Unwitnessed<Decision> {
        self.decided(move |tex| decide(tex, letters))
    }

    /// Proves the characters in a display that is cut into lines, each a claim of its own. The other lines have their
    /// right characters.
    pub fn proven_in(self, lines: &'static [&'static str], letters: Exact) -> Unwitnessed<Decision> {
        let own = self.claim.id;
        self.decided(move |tex| decide_joined(&in_display(lines, own, tex), letters))
    }

    /// Decides on the equation by a function that proves or refutes characters in the place of the printed ones.
    pub fn decided(self, decide: impl Fn(&str) -> Finding + Send + Sync + 'static) -> Unwitnessed<Decision> {
        self.evaluated(Evidence::ExactIdentity, decide)
    }

    /// Decides on the equation by a function that evaluates the characters.
    pub fn evaluated(
        self,
        evidence: Evidence,
        decide: impl Fn(&str) -> Finding + Send + Sync + 'static,
    ) -> Unwitnessed<Decision> {
        self.first(evidence, Arc::new(decide))
    }
}

impl Unwitnessed<Decision> {
    /// The right characters hold wherever they are read and evaluated, and the printed ones do not if they are corrected.
    pub fn read(self, evidence: Evidence, holds: impl Fn(&str) -> Option<bool> + Send + Sync + 'static) -> Claim {
        let witness = Route { evidence, run: Arc::new(holds) as Arc<Reading> };
        let check = Check::Equation { first: self.first, witness, said: None, also: None };
        Claim { check, ..self.claim }
    }

    /// Reads the characters in a display that is cut into lines, each a claim of its own. The other lines have their
    /// right characters.
    pub fn read_in(
        self,
        evidence: Evidence,
        lines: &'static [&'static str],
        holds: impl Fn(&str) -> Option<bool> + Send + Sync + 'static,
    ) -> Claim {
        let own = self.claim.id;
        self.read(evidence, move |tex| holds(&in_display(lines, own, tex)))
    }
}

impl Unchecked<Choice> {
    /// Whether the right statement holds, and its neighbour.
    pub fn by(
        self,
        evidence: Evidence,
        run: impl Fn(Stated) -> Finding + Send + Sync + 'static,
    ) -> Unwitnessed<Choice> {
        self.first(evidence, Arc::new(run))
    }
}

impl Unwitnessed<Choice> {
    /// Adds the witness, a route that shares no code with the first. Until [`Claim::but_not`] names another neighbour,
    /// the wrong statement is the printed one.
    pub fn by(self, evidence: Evidence, run: impl Fn(Stated) -> Finding + Send + Sync + 'static) -> Claim {
        let witness = Route { evidence, run: Arc::new(run) as Arc<Choice> };
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
    pub fn read_to(mut self, unit: impl Fn() -> f64 + Send + Sync + 'static) -> Self {
        let Check::Number { resolution, .. } = &mut self.check else { self.has_no("a resolution") };
        *resolution = Some(Arc::new(unit));
        self
    }

    /// The right number by two routes, if the routes to the printed one follow a slip of the source.
    #[must_use]
    pub fn right(
        mut self,
        evidence: Evidence,
        run: impl Fn() -> f64 + Send + Sync + 'static,
        other: Evidence,
        again: impl Fn() -> f64 + Send + Sync + 'static,
    ) -> Self {
        let Check::Number { right, .. } = &mut self.check else { self.has_no("a right number") };
        let first = Route { evidence, run: Arc::new(run) as Arc<Number> };
        *right = Some([first, Route { evidence: other, run: Arc::new(again) }]);
        self
    }

    /// Adds something else that shows which equation is right, beside the witness that reads the characters.
    #[must_use]
    pub fn also_by(mut self, evidence: Evidence, run: impl Fn() -> Finding + Send + Sync + 'static) -> Self {
        let Check::Equation { also, .. } = &mut self.check else { self.has_no("another witness") };
        *also = Some(Route { evidence, run: Arc::new(run) });
        self
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
        let Check::Equation { witness, said, also, .. } = &self.check else {
            return Finding::not_evaluated("the claim is no equation");
        };
        let holds = &witness.run;
        let read = match (holds(self.right_characters()), &self.erratum) {
            (Some(true), None) if said.is_some() => Finding::of_reading(holds(self.printed)),
            (found @ None, _) | (found, None) => Finding::of_reading(found),
            (Some(right), Some(_)) => Finding::new(
                right && holds(self.printed) != Some(true),
                "values that must satisfy the equation satisfy only its corrected form",
            ),
        };
        match also {
            Some(also) => read.and((also.run)()),
            None => read,
        }
    }

    /// What characters that are not ours to print say, in the letters of mathematics; both are read.
    #[must_use]
    pub fn saying(mut self, what: &'static str) -> Self {
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
    pub fn read_as(self, reading: &'static str) -> Self {
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

    /// The characters that are right: those of the correction, if there is one; what they say, if they are not printed.
    pub fn right_characters(&self) -> &'static str {
        match (&self.check, &self.erratum) {
            (Check::Equation { said: Some(said), .. }, _) => said,
            (_, Some(erratum)) => erratum.corrected,
            (_, None) => self.printed,
        }
    }
}

slugs!(Kind {
    Value = "value",
    Equation = "equation",
    Figure = "figure",
    Statement = "statement",
    Example = "example",
});
