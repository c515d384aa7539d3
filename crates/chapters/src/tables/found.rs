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
fn of_book(name: &str) -> anyhow::Result<Table> {
    let or_none = |text: &str| if text.is_empty() { Ok("–".to_owned()) } else { words(text) };
    let misprints = misprints()?;
    let those: Vec<Misprint> =
        faults(&misprints).into_iter().filter(|misprint| misprint.book == name).cloned().collect();
    anyhow::ensure!(!those.is_empty(), "there is no misprint of `{name}` on record");
    Table::with_rows(Cells::Wide, those)
        .column("Place", place)
        .column("Printed", |misprint| chain(&misprint.printed))
        .column("Recomputed", |misprint| or_none(&misprint.recomputed))
        .column("Our reading", |misprint| words(&misprint.should))
        .finish()
}

/// The file, the line and the element or section of a misprint.
fn place(misprint: &Misprint) -> String {
    let file = misprint.file.strip_suffix("/index.cnxml").unwrap_or(&misprint.file);
    let file = file.rsplit('/').next().unwrap_or(file);
    format!("<code>{}</code>, line {} <small>{}</small>", escape(file), misprint.line, escape(&misprint.element))
}

/// How often the program was right at first contact, by what was measured and the kind of text.
pub(super) fn measured() -> anyhow::Result<Table> {
    let meaning = |measure: &str| match measure {
        "flags" => "Flags on numbers that are real",
        "faults" => "The same, each fault counted once",
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
    ($($function:ident: $name:literal,)*) => {
        $(
            #[doc = concat!("The misprints in *", $name, "*.")]
            pub(super) fn $function() -> anyhow::Result<Table> {
                of_book($name)
            }
        )*

        #[cfg(test)]
        const WITH_TABLE: &[&str] = &[$($name,)*];
    };
}

books! {
    university_physics: "University Physics",
    college_physics: "College Physics",
    introductory_statistics: "Introductory Statistics",
    calculus: "Calculus",
    prealgebra: "Prealgebra",
    finance: "Principles of Finance",
    chemistry: "Chemistry",
    openintro: "OpenIntro Statistics",
    orcca: "ORCCA",
    apex: "APEX Calculus",
    biostatistics: "OpenIntro Biostatistics",
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
