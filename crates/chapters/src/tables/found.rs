//! What proofreading found: the misprints in each textbook, and how often the program was right.

use crate::computed::found::{briefly, faults};
use crate::proofreading_record::{Misprint, MisprintKind, books, misprints, rates};
use geneva_press::chain::{chain, words};
use geneva_press::html::escape;
use geneva_press::table::{Cells, Table};

/// The textbooks, each with its chains and its misprints.
pub(super) fn textbooks() -> anyhow::Result<Table> {
    let misprints = misprints()?;
    let of = |book: &str, kind: MisprintKind| {
        faults(&misprints).iter().filter(|fault| fault.book == book && fault.kind == kind).count()
    };
    Table::with_rows(Cells::NamedNumbers, books()?)
        .column("Book", |book| escape(&book.book))
        .column("Revision", |book| format!("<code>{}</code>", escape(book.revision.get(..7).unwrap_or(&book.revision))))
        .column("Chains", |book| book.checked)
        .column("Numbers", |book| of(&book.book, MisprintKind::Number))
        .column("Statistics", |book| of(&book.book, MisprintKind::Statistics))
        .column("Units", |book| of(&book.book, MisprintKind::Unit))
        .finish()
}

/// The misprints in a textbook, one row for each fault.
fn of_book(name: &str, kinds: &[MisprintKind]) -> anyhow::Result<Table> {
    let or_none = |text: &str| if text.is_empty() { Ok("–".to_owned()) } else { words(text) };
    let misprints = misprints()?;
    let those: Vec<Misprint> =
        faults(&misprints).into_iter().filter(|of| of.book == name && kinds.contains(&of.kind)).cloned().collect();
    anyhow::ensure!(!those.is_empty(), "there is no misprint of `{name}` on record");
    Table::with_rows(Cells::Wide, those)
        .column("Place", place)
        .column("Printed", |misprint| chain(&misprint.printed))
        .column("Recomputed", |misprint| or_none(&misprint.recomputed))
        .column("Our reading", |misprint| words(&misprint.should))
        .finish()
}

/// All kinds of misprints.
const ALL: &[MisprintKind] = &[MisprintKind::Number, MisprintKind::Statistics, MisprintKind::Unit];

/// The file, the line and the element of a misprint. A line breaks behind the marks in a name, and a long name or a heading is left out.
fn place(misprint: &Misprint) -> String {
    const LONGEST: usize = 24;
    let file = misprint.file.strip_suffix("/index.cnxml").unwrap_or(&misprint.file);
    let file = file.rsplit('/').next().unwrap_or(file);
    let breakable = |name: &str| escape(name).replace('_', "_<wbr>").replace('-', "-<wbr>");
    let is_name = misprint.element.len() <= LONGEST && !misprint.element.contains([' ', '$']);
    let element = if is_name { format!(" <small>{}</small>", breakable(&misprint.element)) } else { String::new() };
    format!("<code>{}</code>, line {}{element}", breakable(file), misprint.line)
}

/// How often the program was right at first contact, by what was measured and the kind of text.
pub(super) fn measured() -> anyhow::Result<Table> {
    let meaning = |measure: &str| match measure {
        "flags" => "Flags on numbers that are real",
        "faults" => "The same, each fault counted once",
        "five" => "Flags on numbers that are real, last five measurements",
        "apart" => "Less certain flags, set apart, that are real",
        "statistics" => "Flags on statistics that are real",
        "hints" => "Hints that name what should be printed",
        "reported" => "Reported errors that are found",
        "planted" => "Planted digits that are noticed",
        _ => "Displayed equalities that are looked at",
    };
    Table::with_rows(Cells::NamedNumbers, rates()?)
        .column("Measured", |rate| meaning(&rate.measure))
        .column("Texts", |rate| escape(&rate.subject))
        .column("Good", |rate| rate.good)
        .column("Of", |rate| rate.tried)
        .column("Share", |rate| briefly(rate.good as usize, rate.tried as usize))
        .finish()
}

macro_rules! books {
    ($($function:ident: $name:literal $kinds:expr,)*) => {
        $(
            #[doc = concat!("The misprints in *", $name, "*.")]
            pub(super) fn $function() -> anyhow::Result<Table> {
                of_book($name, $kinds)
            }
        )*

        #[cfg(test)]
        const WITH_TABLE: &[&str] = &[$($name,)*];
    };
}

books! {
    university_physics: "University Physics" &[MisprintKind::Number, MisprintKind::Statistics],
    university_physics_units: "University Physics" &[MisprintKind::Unit],
    college_physics: "College Physics" ALL,
    introductory_statistics: "Introductory Statistics" ALL,
    calculus: "Calculus" ALL,
    prealgebra: "Prealgebra" ALL,
    finance: "Principles of Finance" ALL,
    chemistry: "Chemistry" ALL,
    openintro: "OpenIntro Statistics" ALL,
    orcca: "ORCCA" ALL,
    apex: "APEX Calculus" ALL,
    biostatistics: "OpenIntro Biostatistics" ALL,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_book_with_a_misprint_has_a_table() {
        for misprint in misprints().expect("read") {
            assert!(WITH_TABLE.contains(&misprint.book.as_str()), "{}", misprint.book);
        }
    }
}
