//! The files of a new crate, from its templates.

use super::engine::Engine;
use super::first_claims::{FirstClaim, FirstKind, first_claims};
use super::{MadeFile, SourceText, names};
use anyhow::ensure;
use geneva_evidence::{Cache, Document, InventoryFile, intern, number_tokens};
use proofread::TextFormat;

/// The files with holes: where each is to be, and its text.
const FILES: [(&str, &str); 15] = [
    ("Cargo.toml", include_str!("../../new/Cargo.toml.in")),
    ("README.md", include_str!("../../new/README.md.in")),
    (".gitignore", include_str!("../../new/gitignore.in")),
    ("src/main.rs", include_str!("../../new/main.rs.in")),
    ("src/lib.rs", include_str!("../../new/lib.rs.in")),
    ("src/document.rs", include_str!("../../new/document.rs.in")),
    ("src/claims.rs", include_str!("../../new/claims.rs.in")),
    ("src/kinds.rs", include_str!("../../new/kinds.rs.in")),
    ("src/book.rs", include_str!("../../new/book.rs.in")),
    ("tests/ledger.rs", include_str!("../../new/ledger-test.rs.in")),
    ("book/book.toml", include_str!("../../new/book.toml.in")),
    ("book/src/SUMMARY.md", include_str!("../../new/SUMMARY.md.in")),
    ("book/src/document.md", include_str!("../../new/document.md.in")),
    ("book/src/errata.md", include_str!("../../new/errata.md.in")),
    ("book/src/ledger.md", include_str!("../../new/ledger.md.in")),
];
const COVERAGE: (&str, &str) = ("book/src/coverage.md", include_str!("../../new/coverage.md.in"));
/// The least that a book of the builder needs: the sheet of the example with the smallest book.
const STYLE: (&str, &str) = ("book/theme/style.css", include_str!("../../../../examples/bodies/book/theme/bodies.css"));
const HEAD: &str = include_str!("../../new/inventory.in");

/// The kinds of claims, each as it is written and as it is shown if the text has none.
const KINDS: [(FirstKind, &str, &str); 4] = [
    (FirstKind::Value, include_str!("../../new/value.in"), include_str!("../../new/no-value.in")),
    (FirstKind::Equation, include_str!("../../new/equation.in"), include_str!("../../new/no-equation.in")),
    (FirstKind::Statement, include_str!("../../new/statement.in"), include_str!("../../new/no-statement.in")),
    (FirstKind::Figure, include_str!("../../new/figure.in"), include_str!("../../new/no-figure.in")),
];

/// All files of the crate of this package.
pub(super) fn files(source: &SourceText, engine: &Engine, package: &str) -> anyhow::Result<Vec<MadeFile>> {
    let slug = names::slug(&source.name);
    let claims = first_claims(source);
    let text_path = format!("text/{}", source.name);
    let stem = source.name.rsplit_once('.').map_or(&*source.name, |(stem, _)| stem);
    let inventory = inventory(source, &slug, &text_path, &claims);
    let lines_to_do = inventory.lines_to_do.to_string();
    let unit = claims.iter().find(|claim| claim.kind == FirstKind::Value).map(|claim| claim.unit.as_str());
    let units = unit.map_or_else(String::new, |unit| format!("(\"first number\", {unit:?})"));
    let library = package.replace('-', "_");
    let path = |inside: &str| serde_json::to_string(&format!("{}/{inside}", engine.folder));
    let (evidence, press, proofread) = (path("crates/evidence")?, path("crates/press")?, path("crates/proofread")?);
    let first_claim = match claims.first() {
        Some(claim) => {
            format!("The first claim is what line {} of the text prints, `{}`.", claim.line + 1, claim.printed)
        }
        None => "None was found in the text, so the comments there show how each kind is written.".to_owned(),
    };
    let (title, book_title) = (format!("{stem:?}"), format!("{stem}, checked"));
    let book_title_literal = serde_json::to_string(&book_title)?;
    let package_literal = format!("{package:?}");
    let holes: [(&str, &str); 20] = [
        ("@package@", package),
        ("@package-literal@", &package_literal),
        ("@library@", &library),
        ("@engine:crates/evidence@", &evidence),
        ("@engine:crates/press@", &press),
        ("@engine:crates/proofread@", &proofread),
        ("@title@", &title),
        ("@book-title@", &book_title),
        ("@book-title-literal@", &book_title_literal),
        ("@units@", &units),
        ("@claims@", &written_claims(&slug, &claims)),
        ("@mentions@", &mentions(&slug, &claims)),
        ("@lines-to-do@", &lines_to_do),
        ("@text-path@", &text_path),
        ("@text-path-literal@", &format!("{text_path:?}")),
        ("@format@", &format!("{:?}", source.format)),
        ("@first-claim@", &first_claim),
        ("@what-is-read@", what_is_read(source.format)),
        ("@slug@", &slug),
        ("@slug-literal@", &format!("{slug:?}")),
    ];
    let mut made: Vec<MadeFile> = Vec::new();
    for (place, template) in FILES.into_iter().chain([COVERAGE]) {
        made.push((place.to_owned(), filled(template, &holes)?.into_bytes()));
    }
    made.push((STYLE.0.to_owned(), STYLE.1.as_bytes().to_vec()));
    made.push(("document.inventory".to_owned(), inventory.text.into_bytes()));
    made.push((text_path, source.text.clone().into_bytes()));
    made.push(("Cargo.lock".to_owned(), engine.lock.clone()));
    Ok(made)
}

/// A template with its holes filled. What is put in is not looked at again.
fn filled(template: &str, holes: &[(&str, &str)]) -> anyhow::Result<String> {
    let (mut written, mut rest) = (String::new(), template);
    while let Some(at) = rest.find('@') {
        let hole = rest[at + 1..].find('@').map(|end| &rest[at..at + end + 2]);
        let with = hole.and_then(|hole| holes.iter().find(|(name, _)| *name == hole));
        ensure!(with.is_some(), "a template has a hole that nothing fills: {hole:?}");
        written += &rest[..at];
        let (name, value) = with.copied().unwrap_or_default();
        written += value;
        rest = &rest[at + name.len()..];
    }
    Ok(written + rest)
}

fn written_claims(slug: &str, claims: &[FirstClaim]) -> String {
    let mut written = String::new();
    let order = |kind: FirstKind| claims.iter().position(|claim| claim.kind == kind).unwrap_or(usize::MAX);
    let mut kinds = KINDS;
    kinds.sort_by_key(|(kind, ..)| order(*kind));
    for (kind, there, absent) in kinds {
        let claim = claims.iter().find(|claim| claim.kind == kind);
        let text = claim.map_or_else(
            || absent.replace("@slug@", slug),
            |claim| {
                let id = format!("{slug}.{}", kind.word());
                let holes = [
                    ("@line@", (claim.line + 1).to_string()),
                    ("@call@", arguments(&id, claim)),
                    ("@slug@", slug.to_owned()),
                ];
                let holes = holes.each_ref().map(|(name, value)| (*name, value.as_str()));
                // The templates have no other holes, as a test sees to.
                filled(there, &holes).unwrap_or_default()
            },
        );
        // A blank line before each claim but the first.
        written += if written.is_empty() || claim.is_none() { "" } else { "\n" };
        written += &text;
    }
    written
}

/// What a claim is made with, in one line or in one for each, as `rustfmt` has it.
fn arguments(id: &str, claim: &FirstClaim) -> String {
    let mut all = vec![format!("{id:?}"), rust_literal(&claim.printed)];
    if claim.kind == FirstKind::Value {
        all.push(format!("{:?}", claim.unit));
    }
    all.push(format!("{:?}", claim.kind.word().replace('-', " ")));
    let line = all.join(", ");
    if line.chars().count() <= 60 {
        return line;
    }
    let indented: String = all.iter().map(|argument| format!("                {argument},\n")).collect();
    format!("\n{indented}            ")
}

/// A string in Rust; one with backslashes is easier to read as it is.
fn rust_literal(text: &str) -> String {
    let is_raw = text.contains('\\') && !text.contains(['"', '#']) && !text.contains(char::is_control);
    if is_raw { format!("r\"{text}\"") } else { format!("{text:?}") }
}

/// A sentence of the book for each claim.
fn mentions(slug: &str, claims: &[FirstClaim]) -> String {
    let mention = |claim: &FirstClaim| {
        let id = format!("{slug}.{}", claim.kind.word());
        match claim.kind {
            FirstKind::Value => format!("Line {} prints {{{{claim:{id}}}}}.\n", claim.line + 1),
            FirstKind::Equation => format!("Line {} has the equation {{{{claim:{id}}}}}.\n", claim.line + 1),
            FirstKind::Statement => format!("Line {} says: \"{{{{claim:{id}}}}}\"\n", claim.line + 1),
            FirstKind::Figure => format!("Line {} says of a figure: \"{{{{claim:{id}}}}}\"\n", claim.line + 1),
        }
    };
    claims.iter().map(mention).collect()
}

struct Inventory {
    text: String,
    lines_to_do: usize,
}

/// The inventory of the text with the first claims in it.
fn inventory(source: &SourceText, slug: &str, text_path: &str, claims: &[FirstClaim]) -> Inventory {
    let mut begun = HEAD.replace("@text-path@", text_path) + "\n";
    let (mut last, mut lines_to_do) = (None, 0);
    for (number, shown) in source.shown.iter().enumerate() {
        let numbers = number_tokens(shown);
        let own: Vec<&FirstClaim> = claims.iter().filter(|claim| claim.line == number).collect();
        lines_to_do += usize::from(numbers.len() > own.iter().map(|claim| claim.numbers().len()).sum());
        for claim in own {
            if last != Some(number) {
                let colon = if numbers.is_empty() { "" } else { ": " };
                begun += &format!("line {}{colon}{}\n", number + 1, numbers.join(" "));
                last = Some(number);
            }
            begun += &format!("  claim {slug}.{}\n", claim.kind.word());
        }
    }
    // Written as the engine writes it when the text has changed.
    let document = Document {
        slug: "",
        title: "",
        citation: "",
        inventory: Some(InventoryFile { path: "", text: intern(begun) }),
        claims: Vec::new,
        answers: &[],
        given: Vec::new,
        conclusions: &[],
        symbols: &[],
        units: &[],
        test: "",
        cache: Cache::new(),
    };
    Inventory { text: document.inventory_for(&source.shown.join("\n")), lines_to_do }
}

/// What the inventory leaves out of texts of this format, beside what it leaves out of all.
fn what_is_read(format: TextFormat) -> &'static str {
    match format {
        TextFormat::Markdown => "The numbers that Markdown gives the items of a list are left out, too.",
        TextFormat::Latex => "Formulas are read as they are written in TeX: `\\frac{1}{2}` prints 1 and 2.",
        TextFormat::Notebook => {
            "Of a notebook these are the cells in Markdown, by the lines of the file; what the code prints is left out."
        }
        TextFormat::Xml | TextFormat::Html => "A raised number is a number of its own: 10² prints 10 and 2.",
        TextFormat::Plain | TextFormat::Csv => "In plain lines that is all there is.",
    }
}
