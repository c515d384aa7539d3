//! The claims of a book and their verdicts, as a value.

use geneva_ledger::{
    Claim, Consequence, Evidence, Judged, Places, TOLERANCES, Tolerance, Work, claim, claims, judged_until_now,
    printed_value, slip, slips, slips_in, slips_of, verdict, verdicts, verdicts_of,
};

/// A source of claims.
pub type Document = Work;

/// The sources of a book, their claims and the verdicts, each derived once and kept.
#[derive(Debug)]
pub struct Ledger(());

/// The ledger of this book.
pub static LEDGER: Ledger = Ledger(());

impl Ledger {
    /// The sources, in the order of the book.
    pub fn documents(&'static self) -> &'static [Document] {
        Work::ALL
    }

    /// The source with this slug.
    pub fn document(&'static self, slug: &str) -> Option<Document> {
        Work::ALL.iter().copied().find(|work| work.slug() == slug)
    }

    /// All claims, by source and in the order of the source.
    pub fn claims(&'static self) -> &'static [Claim] {
        claims()
    }

    /// The claim with this id.
    pub fn claim(&'static self, id: &str) -> Option<&'static Claim> {
        claim(id)
    }

    /// The number that the claim with this id prints.
    pub fn printed_value(&'static self, id: &str) -> Option<f64> {
        printed_value(id)
    }

    /// All verdicts, in the order of the claims.
    pub fn verdicts(&'static self) -> &'static [Judged] {
        verdicts()
    }

    /// The verdicts on the claims of a source, in their order.
    pub fn verdicts_of(&'static self, document: Document) -> Vec<&'static Judged> {
        verdicts_of(document)
    }

    /// The verdict on the claim with this id.
    pub fn verdict(&'static self, id: &str) -> Option<&'static Judged> {
        verdict(id)
    }

    /// The verdicts that somebody has asked for until now.
    pub fn judged_until_now(&'static self) -> impl Iterator<Item = &'static Judged> {
        judged_until_now()
    }

    /// All slips with the claims that each reaches.
    pub fn slips(&'static self) -> &'static [Places] {
        slips()
    }

    /// The slips made in a source.
    pub fn slips_in(&'static self, document: Document) -> Vec<Places> {
        slips_in(document)
    }

    /// The slips of the mirrored sources with this consequence.
    pub fn slips_of(&'static self, consequence: Consequence) -> impl Iterator<Item = &'static Places> {
        slips_of(consequence)
    }

    /// The slip with this id.
    pub fn slip(&'static self, id: &str) -> Option<&'static Places> {
        slip(id)
    }

    /// The kinds of evidence, in their order.
    pub fn evidence(&'static self) -> &'static [Evidence] {
        Evidence::ALL
    }

    /// The tolerances that are not printed digits.
    pub fn tolerances(&'static self) -> &'static [Tolerance] {
        TOLERANCES
    }
}
