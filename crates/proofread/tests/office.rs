//! Documents of Word and LibreOffice and e-books, which the tests make themselves.

use crate::command::{git, run};
use std::io::Write;
use tempfile::TempDir;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// An archive with these entries.
pub(crate) fn archive(entries: &[(&str, &str)]) -> Vec<u8> {
    let mut out = ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, text) in entries {
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
        out.start_file(*name, options).expect("an entry");
        out.write_all(text.as_bytes()).expect("written");
    }
    out.finish().expect("an archive").into_inner()
}

/// A file with this name and content in a folder of its own.
pub(crate) fn file(name: &str, bytes: &[u8]) -> (TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).expect("written");
    let path = path.to_str().expect("UTF-8").to_owned();
    (folder, path)
}

pub(crate) fn document(body: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?><w:document xmlns:w=\"w\" xmlns:m=\"m\"><w:body>{body}<w:sectPr/></w:body></w:document>"
    )
}

pub(crate) fn docx(body: &str) -> Vec<u8> {
    archive(&[("[Content_Types].xml", "<Types/>"), ("word/document.xml", &document(body))])
}

/// A paragraph of runs.
pub(crate) fn paragraph(runs: &str) -> String {
    format!("<w:p><w:pPr><w:rPr><w:vertAlign w:val=\"superscript\"/></w:rPr></w:pPr>{runs}</w:p>")
}

pub(crate) fn text(text: &str) -> String {
    format!("<w:r><w:t xml:space=\"preserve\">{text}</w:t></w:r>")
}

fn printed(text: &str, properties: &str) -> String {
    format!("<w:r><w:rPr>{properties}</w:rPr><w:t xml:space=\"preserve\">{text}</w:t></w:r>")
}

/// A run of a formula.
fn r(text: &str) -> String {
    format!("<m:r><w:rPr><w:rFonts w:ascii=\"Cambria Math\"/></w:rPr><m:t xml:space=\"preserve\">{text}</m:t></m:r>")
}

/// An upright run of a formula.
fn unit(text: &str) -> String {
    format!("<m:r><m:rPr><m:sty m:val=\"p\"/></m:rPr><m:t xml:space=\"preserve\">{text}</m:t></m:r>")
}

fn e(inside: &str) -> String {
    format!("<m:e>{inside}</m:e>")
}

fn formula(inside: &str) -> String {
    paragraph(&format!("<m:oMathPara><m:oMath>{inside}</m:oMath></m:oMathPara>"))
}

/// What is said to have been printed and recomputed.
pub(crate) fn said(out: &str) -> Vec<String> {
    let mark = |line: &str| line.find("printed ").or(line.find("recomputed ")).map(|at| line[at..].to_owned());
    let says = |line: &&str| line.contains("recomputed ") || line.contains("^ printed ");
    out.lines().filter(says).filter_map(mark).collect()
}

/// What is printed and recomputed in the findings of a file, and the command's whole output.
pub(crate) fn found(name: &str, bytes: &[u8]) -> (Vec<String>, String) {
    let (_folder, path) = file(name, bytes);
    let (code, out, told) = run(&["--less-certain", &path]);
    let all = out + &told;
    let findings = said(&all);
    assert_eq!(code, u8::from(!findings.is_empty()), "{all}");
    (findings, all)
}

/// Asserts that a right body has a checked chain and nothing wrong, and a wrong one has this finding alone.
#[track_caller]
fn right_and_wrong(right: &str, wrong: &str, said: &str) {
    let (findings, all) = found("right.docx", &docx(right));
    assert!(findings.is_empty() && all.contains("Checked 1 chain of 1 chain"), "{right}\n{all}");
    let (findings, all) = found("wrong.docx", &docx(wrong));
    // Behind the values stands in which way they differ.
    let values: Vec<&str> = findings.iter().filter_map(|found| found.split(" (a factor").next()).collect();
    assert_eq!(values, [said], "{wrong}\n{all}");
}

/// Right and wrong bodies that differ in the last number of one formula.
#[track_caller]
fn results(start: &str, right: &str, wrong: &str, said: &str) {
    right_and_wrong(&formula(&format!("{start}{}", r(right))), &formula(&format!("{start}{}", r(wrong))), said);
}

#[test]
fn each_structure_of_a_formula_in_word_is_read() {
    let f = |above: &str, below: &str| format!("<m:f><m:fPr/><m:num>{above}</m:num><m:den>{below}</m:den></m:f>");
    let sup = |base: &str, sup: &str| format!("<m:sSup>{}<m:sup>{}</m:sup></m:sSup>", e(&r(base)), r(sup));
    let d = |properties: &str, inside: &str| format!("<m:d><m:dPr>{properties}</m:dPr>{}</m:d>", e(inside));
    let root = |properties: &str, degree: &str, inside: &str| {
        format!("<m:rad><m:radPr>{properties}</m:radPr><m:deg>{degree}</m:deg>{}</m:rad>", e(&r(inside)))
    };
    let said = |printed: &str, recomputed: &str| format!("printed {printed}, recomputed {recomputed}");
    let fraction = f(&r("43.4-29.8"), &r("2"));
    results(&format!("{fraction}{}", r("=")), "6.8", "7.9", &said("7.9", "6.8"));
    let linear = "<m:f><m:fPr><m:type m:val=\"lin\"/></m:fPr><m:num><m:r><m:t>9</m:t></m:r></m:num><m:den><m:r><m:t>4</m:t></m:r></m:den></m:f>";
    results(&format!("{linear}{}", r("=")), "2.25", "2.35", &said("2.35", "2.25"));
    results(&format!("{}{}", root("<m:degHide m:val=\"1\"/>", "", "625"), r("=")), "25", "35", &said("35", "25"));
    results(&format!("{}{}", root("", &r("3"), "2744"), r("=")), "14", "24", &said("24", "14"));
    // The exponent belongs to the last sign before it, as it is printed.
    results(&format!("{}{}", sup("3.2×10", "3"), r("·2=")), "6400", "7400", &said("7400", "6400"));
    let both = format!("<m:sSubSup>{}<m:sub>{}</m:sub><m:sup>{}</m:sup></m:sSubSup>", e(&r("x")), r("0"), r("2"));
    let bracket = d("", &r("1.5+2.5"));
    let squared = format!("<m:sSup>{}<m:sup>{}</m:sup></m:sSup>", e(&bracket), r("2"));
    results(&format!("{both}{}{squared}{}", r("="), r("=")), "16", "18", &said("18", "16"));
    let absolute = d("<m:begChr m:val=\"|\"/><m:endChr m:val=\"|\"/>", &r("3-15"));
    results(&format!("{absolute}{}", r("=")), "12", "13", &said("13", "12"));
    let floor = d("<m:begChr m:val=\"⌊\"/><m:endChr m:val=\"⌋\"/>", &f(&r("77"), &r("2")));
    results(&format!("{floor}{}", r("=")), "38", "39", &said("39", "38"));
    let sum = format!(
        "<m:nary><m:naryPr><m:chr m:val=\"∑\"/></m:naryPr><m:sub>{}</m:sub><m:sup>{}</m:sup>{}</m:nary>",
        r("k=1"),
        r("4"),
        e(&format!("<m:sSup>{}<m:sup>{}</m:sup></m:sSup>", e(&r("k")), r("2")))
    );
    results(&format!("{sum}{}", r("=")), "30", "31", &said("31", "30"));
    let sine = format!("<m:func><m:fName>{}</m:fName>{}</m:func>", unit("sin"), e(&r("30°")));
    results(&format!("{}{sine}{}", r("7.0·"), r("=")), "3.5", "3.7", &said("3.7", "3.5"));
    let binomial = d(
        "",
        "<m:f><m:fPr><m:type m:val=\"noBar\"/></m:fPr><m:num><m:r><m:t>7</m:t></m:r></m:num><m:den><m:r><m:t>3</m:t></m:r></m:den></m:f>",
    );
    results(&format!("{binomial}{}", r("=")), "35", "21", &said("21", "35"));
    let period = format!("<m:bar><m:barPr><m:pos m:val=\"top\"/></m:barPr>{}</m:bar>", e(&r("6")));
    results(
        &format!("{}{period}{}", r("0.1"), r("=")),
        "1/6",
        "1/7",
        "printed 0.166666666666666, recomputed 0.142857142857143",
    );
    let row = |cells: [&str; 2]| format!("<m:mr>{}{}</m:mr>", e(&r(cells[0])), e(&r(cells[1])));
    let determinant = d(
        "<m:begChr m:val=\"|\"/><m:endChr m:val=\"|\"/>",
        &format!("<m:m>{}{}</m:m>", row(["12", "7"]), row(["5", "4"])),
    );
    results(&format!("{determinant}{}", r("=")), "13", "23", &said("23", "13"));
    let boxed = format!("<m:borderBox>{}</m:borderBox>", e(&r("40+2")));
    results(&format!("{boxed}{}", r("=")), "42", "44", &said("44", "42"));
    let choices = format!(
        "<m:sPre><m:sub>{}</m:sub><m:sup/>{}</m:sPre>",
        r("7"),
        e(&format!("<m:sSub>{}<m:sub>{}</m:sub></m:sSub>", e(&unit("C")), r("3")))
    );
    results(&format!("{choices}{}", r("=")), "35", "45", &said("45", "35"));
    // Units are upright, and a run may be text.
    let speed = format!("{}{}", r("48 "), unit("m"));
    let quotient = format!("{}{}", f(&speed, &format!("{}{}", r("4.0 "), unit("s"))), r("="));
    let result =
        |number: &str| formula(&format!("{quotient}{}<m:r><m:rPr><m:nor/></m:rPr><m:t> m/s</m:t></m:r>", r(number)));
    right_and_wrong(&result("12"), &result("14"), &said("14 m/s", "12 m/s"));
    let least = format!("<m:func><m:fName>{}</m:fName>{}</m:func>", unit("min"), e(&d("", &r("7,12"))));
    results(&format!("{least}{}", r("+30=")), "37", "42", &said("42", "37"));
    // A unit may be in several runs, a letter in each.
    let minutes = |hours: &str| {
        let unit = ["m", "i", "n"].map(unit).concat();
        formula(&format!("{}{unit}{}{}", r("90 "), r(&format!("={hours} ")), self::unit("h")))
    };
    right_and_wrong(&minutes("1.5"), &minutes("1.8"), &said("1.8 h", "1.5 h"));
    // Rows of equations, with the number of an equation behind the last one.
    let rows = |last: &str| {
        formula(&format!(
            "<m:eqArr><m:eqArrPr/>{}{}</m:eqArr>",
            e(&r("x&amp;=43.4-29.8")),
            e(&r(&format!("&amp;={last}#(3)")))
        ))
    };
    right_and_wrong(&rows("13.6"), &rows("13.8"), &said("13.8", "13.6"));
}

#[test]
fn what_stands_in_a_formula_and_is_not_known_is_told_by_its_name() {
    let strange = format!("<m:warp>{}</m:warp>{}", e(&r("7")), r("+2=10"));
    let (findings, all) = found("a.docx", &docx(&formula(&strange)));
    assert_eq!(findings, [""; 0], "{all}");
    assert!(all.contains("1 chain with `warp`"), "{all}");
    let group = format!("<m:groupChr>{}</m:groupChr>{}", e(&r("7+1")), r("+2=11"));
    assert_eq!(found("a.docx", &docx(&formula(&group))).0, [""; 0]);
}

#[test]
fn running_text_of_word_is_read_as_it_is_printed() {
    let line = |result: &str| paragraph(&(text("The speed is 43.4 − ") + &text("29.8 = ") + &text(result)));
    right_and_wrong(&line("13.6 km/s."), &line("13.8 km/s."), "printed 13.8 km/s, recomputed 13.6 km/s");
    let raised = |last: &str| {
        paragraph(
            &(text("3.0 · 10")
                + &printed("5", "<w:vertAlign w:val=\"superscript\"/>")
                + &text(&format!(" · 2 = {last} · 10"))
                + &printed("5", "<w:vertAlign w:val=\"superscript\"/>")),
        )
    };
    right_and_wrong(&raised("6.0"), &raised("6.2"), "printed 6.2 · 10^5, recomputed 6.0 × 10^5");
    // What is written with the signs of the linear format.
    let linear = |last: &str| paragraph(&format!("<m:oMath>{}</m:oMath>", r(&format!("12^2 + 1 = {last}"))));
    right_and_wrong(&linear("145"), &linear("146"), "printed 146, recomputed 145");
    // A sign of the font of symbols, a line that ends in a paragraph, and a tab.
    let sign = |last: &str| {
        paragraph(
            &(text("Area:")
                + "<w:r><w:tab/></w:r>"
                + &text("12 ")
                + "<w:r><w:sym w:font=\"Symbol\" w:char=\"F0B4\"/></w:r>"
                + &text(&format!(" 4 = {last}"))
                + "<w:r><w:br/></w:r>"
                + &text("and more")),
        )
    };
    right_and_wrong(&sign("48"), &sign("49"), "printed 49, recomputed 48");
}

#[test]
fn changes_are_read_as_accepted_and_comments_are_counted() {
    let deleted = "<w:del w:id=\"1\"><w:r><w:delText>2.0 + 2.0 = 5.0</w:delText></w:r></w:del>";
    let moved = "<w:moveFrom w:id=\"2\"><w:r><w:t>4 + 4 = 9</w:t></w:r></w:moveFrom>";
    let inserted = |last: &str| {
        paragraph(&format!("{deleted}{moved}<w:ins w:id=\"3\">{}</w:ins>", text(&format!("So 12 + 13 = {last}."))))
    };
    right_and_wrong(&inserted("25"), &inserted("26"), "printed 26, recomputed 25");
    // How a run looked before is no matter.
    let before = "<w:rPrChange><w:rPr><w:vertAlign w:val=\"superscript\"/></w:rPr></w:rPrChange>";
    let changed = |last: &str| paragraph(&printed(&format!("So 12 + 13 = {last}."), before));
    right_and_wrong(&changed("25"), &changed("26"), "printed 26, recomputed 25");
    let struck = paragraph(&printed("2 + 2 = 5", "<w:strike/>"));
    let entries = [
        ("word/document.xml", document(&(inserted("25") + &struck))),
        (
            "word/comments.xml",
            "<w:comments><w:comment><w:p><w:r><w:t>or 2 + 2 = 7?</w:t></w:r></w:p></w:comment></w:comments>".to_owned(),
        ),
        ("word/header1.xml", "<w:hdr><w:p><w:r><w:t>T = 5</w:t></w:r></w:p></w:hdr>".to_owned()),
        (
            "word/footnotes.xml",
            "<w:footnotes><w:footnote w:type=\"separator\"><w:p><w:r><w:t>1 + 1 = 4</w:t></w:r></w:p></w:footnote>\
            <w:footnote w:id=\"2\"><w:p><w:r><w:t>As 30 + 12 = 43.</w:t></w:r></w:p></w:footnote></w:footnotes>"
                .to_owned(),
        ),
    ];
    let entries: Vec<(&str, &str)> = entries.iter().map(|(name, text)| (*name, text.as_str())).collect();
    let (findings, all) = found("a.docx", &archive(&entries));
    assert_eq!(findings, ["printed 43, recomputed 42"], "{all}");
    assert!(all.contains(".docx, footnote 1\n"), "{all}");
    assert!(all.contains("Not read, with an equals sign and a digit: 3 comments, 1 element `header`."), "{all}");
}

#[test]
fn objects_of_other_programs_are_counted_by_their_name() {
    let object = |program: &str| {
        format!("<w:r><w:object><v:shape/><o:OLEObject Type=\"Embed\" ProgID=\"{program}\"/></w:object></w:r>")
    };
    let body = paragraph(&(text("So ") + &object("Equation.3")))
        + &paragraph(&(text("3 + ") + &object("Equation.DSMT4") + &text(" = 5")))
        + &paragraph(&object("Equation.3"));
    let (findings, all) = found("a.docx", &docx(&body));
    assert_eq!(findings, [""; 0], "{all}");
    assert!(all.contains("Not read: 2 objects of `Equation.3`, 1 object of `Equation.DSMT4`."), "{all}");
}

fn row(cells: &[&str]) -> String {
    let cell =
        |text_of: &&str| format!("<w:tc><w:tcPr><w:tcW w:w=\"1\"/></w:tcPr>{}</w:tc>", paragraph(&text(text_of)));
    format!("<w:tr>{}</w:tr>", cells.iter().map(cell).collect::<String>())
}

#[test]
fn tables_have_their_totals_compared_and_their_cells_read() {
    let table = |total: &str| {
        let rows = [
            row(&["Item", "Cost"]),
            row(&["Screws", "1,234"]),
            row(&["Nails", "2,345"]),
            row(&["Boards", "3,456"]),
            row(&["Total", total]),
        ];
        paragraph(&text("Costs:")) + "<w:tbl><w:tblPr/>" + &rows.concat() + "</w:tbl>" + &paragraph("")
    };
    assert_eq!(found("a.docx", &docx(&table("7,035"))).0, [""; 0]);
    let (findings, all) = found("a.docx", &docx(&table("7,135")));
    assert_eq!(findings, ["printed 7,135, recomputed 7035"], "{all}");
    assert!(all.contains(".docx, table 1, row 5, cell 2\n"), "{all}");
    let formulas = |last: &str| {
        let cell = format!("<w:tc>{}</w:tc>", formula(&r(&format!("43.4-29.8={last}"))));
        format!(
            "<w:tbl><w:tr><w:tc>{}</w:tc>{cell}<w:tc>{}</w:tc></w:tr></w:tbl>",
            paragraph(""),
            paragraph(&text("(7)"))
        )
    };
    right_and_wrong(&formulas("13.6"), &formulas("13.8"), "printed 13.8, recomputed 13.6");
    // A table in a table, and a box of text.
    let nested = |last: &str| {
        format!(
            "<w:tbl><w:tr><w:tc>{}{}</w:tc></w:tr></w:tbl>{}",
            paragraph(&text("A")),
            formulas("13.6"),
            paragraph(&format!(
                "<w:r><w:pict><v:textbox><w:txbxContent>{}</w:txbxContent></v:textbox></w:pict></w:r>",
                paragraph(&text(&format!("12 + 13 = {last}")))
            ))
        )
    };
    let (findings, all) = found("a.docx", &docx(&nested("26")));
    assert_eq!(findings, ["printed 26, recomputed 25"], "{all}");
    assert!(all.contains(".docx, text box 1\n") && all.contains("Checked 2 chains"), "{all}");
}

#[test]
fn a_finding_tells_the_paragraph_and_its_words() {
    let body = paragraph(&text("A title"))
        + &paragraph("")
        + &paragraph(
            &(text("We see ")
                + "<m:oMath>"
                + &format!("<m:rad><m:radPr/><m:deg>{}</m:deg>{}</m:rad>", r("3"), e(&r("2744")))
                + &r("=24")
                + "</m:oMath>"
                + &text(", as &lt;expected&gt;.")),
        );
    let (_folder, path) = file("report.docx", &docx(&body));
    let (code, out, _) = run(&[&path]);
    assert_eq!(code, 1);
    let place = format!(
        "inconsistent: the two sides differ\n --> {path}, paragraph 2\n  |\n  | We see 3√2744=24, as <expected>.\n  |               ^^ printed 24, recomputed 14 (a factor of 1.71)\n"
    );
    assert!(out.contains(&place), "{out}");
    let (_, out, _) = run(&["--format", "json", "--unchecked", "--agreeing", &path]);
    let whole: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    crate::command::fits_schema(&whole);
    let first = &whole["documents"][0];
    assert_eq!((first["format"].as_str(), first["findings"][0]["place"].as_str()), (Some("docx"), Some("paragraph 2")));
    assert_eq!(first["findings"][0]["at"]["start"], serde_json::json!({ "line": 2, "column": 15 }));
    let (_, out, _) = run(&["--format", "sarif", &path]);
    let whole: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    let location = &whole["runs"][0]["results"][0]["locations"][0];
    assert_eq!(location["logicalLocations"][0]["name"], "paragraph 2", "{location}");
    let unknown = formula(&r("2x+1=5")) + &formula(&r("x=y"));
    let (_folder, path) = file("b.docx", &docx(&unknown));
    let (_, out, _) = run(&["--unchecked", &path]);
    assert!(out.contains(&format!("not checked: the letter x has no value\n --> {path}, paragraph 1\n")), "{out}");
}

#[test]
fn accepted_cases_and_changes_hold_for_documents_of_word() {
    let body = |more: &str| paragraph(&text("So 12 + 13 = 26.")) + more;
    let (folder, path) = file("a.docx", &docx(&body("")));
    let cases = folder.path().join("accepted.jsonl");
    let cases = cases.to_str().expect("UTF-8");
    assert_eq!(run(&["--accept", cases, &path]).0, 0);
    assert_eq!(run(&["--baseline", cases, &path]).0, 0);
    std::fs::write(&path, docx(&(paragraph(&text("Moved.")) + &body("")))).expect("written");
    assert_eq!(run(&["--baseline", cases, &path]).0, 0);
    let name = folder.path().to_str().expect("UTF-8");
    if !git(folder.path(), &["init", "-q"]) {
        return println!("skipped: there is no git here");
    }
    assert!(git(folder.path(), &["add", "."]) && git(folder.path(), &["commit", "-q", "-m", "first"]));
    assert_eq!(run(&["--since", "HEAD", name]).0, 0);
    std::fs::write(&path, docx(&body(&paragraph(&text("And 30 + 12 = 43."))))).expect("written");
    let (code, out, told) = run(&["--since", "HEAD", name]);
    assert!(code == 1 && out.contains("1 finding:") && out.contains("paragraph 2"), "{out}{told}");
}

#[test]
fn a_document_that_libreoffice_saved_for_word_is_read() {
    let path = format!("{}/tests/texts/saved-by-libreoffice.docx", env!("CARGO_MANIFEST_DIR"));
    let (code, out, told) = run(&["--less-certain", &path]);
    assert_eq!((code, told.as_str()), (1, ""));
    for (place, said) in [
        ("paragraph 2", "printed 13.8, recomputed 13.6"),
        ("paragraph 3", "printed 6.2 · 10^5, recomputed 6.0 × 10^5"),
        ("paragraph 5", "printed 6, recomputed 5"),
        ("paragraph 7", "printed 31, recomputed 30"),
        ("paragraph 9", "printed 14 m/s, recomputed 12 m/s"),
        ("paragraph 11", "printed 23, recomputed 13"),
        ("table 1, row 5, cell 2", "printed 7,135, recomputed 7035"),
        ("footnote 1", "printed 26, recomputed 25"),
    ] {
        let finding = out.split("\n\n").find(|finding| finding.contains(&format!(", {place}\n")));
        assert!(finding.is_some_and(|finding| finding.contains(said)), "{place}: {said}\n{out}");
    }
    assert!(out.contains("9 findings: 3 on a number, 1 on a statistic or a total, 5 less certain.\n"), "{out}");
}

/// A document of Word with a heading of a style by its German name, a finding below it, one in a cell, and one in a note.
fn with_headings() -> Vec<u8> {
    let styled =
        |style: &str, words: &str| format!("<w:p><w:pPr><w:pStyle w:val=\"{style}\"/></w:pPr>{}</w:p>", text(words));
    let body = styled("Titel", "A report")
        + &paragraph(&text("Before: 1 + 1 = 3."))
        + &styled("berschrift1", "Calculation with 2 + 2 = 5")
        + &paragraph(&text("Then 12 + 13 = 26."))
        + &format!("<w:tbl><w:tr><w:tc>{}</w:tc></w:tr></w:tbl>", styled("berschrift1", "30 + 12 = 43"))
        + &styled("berschrift1", &"Long ".repeat(30))
        + &paragraph(&text("And 7 + 8 = 16."));
    let styles = "<w:styles><w:style w:styleId=\"berschrift1\"><w:name w:val=\"heading 1\"/></w:style>\
        <w:style w:styleId=\"Titel\"><w:name w:val=\"Title\"/></w:style></w:styles>";
    let notes = "<w:footnotes><w:footnote w:id=\"2\"><w:p><w:r><w:t>As 5 + 5 = 11.</w:t></w:r></w:p></w:footnote></w:footnotes>";
    archive(&[("word/document.xml", &document(&body)), ("word/styles.xml", styles), ("word/footnotes.xml", notes)])
}

#[test]
fn a_place_is_told_under_the_heading_above_it() {
    let (_folder, path) = file("a.docx", &with_headings());
    let (_, out, _) = run(&["--format", "json", &path]);
    let whole: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    let [finding] = whole["documents"][0]["findings"].as_array().expect("findings").as_slice() else { panic!("{out}") };
    let places = finding["places"].as_array().expect("places");
    let long = format!("under ‘{}…’, paragraph 6", "Long ".repeat(12));
    for (place, said) in [
        ("paragraph 2", "printed 3, recomputed 2"),
        // A heading stands under none.
        ("paragraph 3", "printed 5, recomputed 4"),
        ("under ‘Calculation with 2 + 2 = 5’, paragraph 4", "printed 26, recomputed 25"),
        // What looks like a heading in a cell is none.
        ("under ‘Calculation with 2 + 2 = 5’, table 1, row 1, cell 1", "printed 43, recomputed 42"),
        (&long, "printed 16, recomputed 15"),
        ("footnote 1", "printed 11, recomputed 10"),
    ] {
        let told = |of: &serde_json::Value| {
            format!("printed {}, recomputed {}", of["printed"], of["recomputed"]).replace('"', "")
        };
        let found = places.iter().find(|of| of["place"] == *place);
        assert_eq!(found.map(told).as_deref(), Some(said), "{place}\n{out}");
    }
    let (_, out, _) = run(&[&path]);
    let out = out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(out.contains("= also: at 5 more places of the same shape: paragraph 3; under ‘Calculation"), "{out}");
    // A heading can bring nothing that changes a terminal.
    let hostile =
        "<w:p><w:pPr><w:outlineLvl w:val=\"0\"/></w:pPr><w:r><w:t>A\u{202e}\u{1b}[31mB&#x9b;C</w:t></w:r></w:p>";
    let (_, out) = found("b.docx", &docx(&(hostile.to_owned() + &paragraph(&text("12 + 13 = 26")))));
    assert!(out.contains(", under ‘A") && !out.contains(['\u{202e}', '\u{1b}', '\u{9b}']), "{out:?}");
    let (_, out, _) = run(&["--format", "json", &path]);
    let whole: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    crate::command::fits_schema(&whole);
    let place = &whole["documents"][0]["findings"][0]["places"][2]["place"];
    assert_eq!(place, "under ‘Calculation with 2 + 2 = 5’, paragraph 4");
    let (_, out, _) = run(&["--format", "sarif", &path]);
    let whole: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    let results = &whole["runs"][0]["results"];
    let message = |at: usize| results[at]["message"]["text"].as_str().unwrap_or_default().to_owned();
    assert!(message(0).starts_with("In paragraph 2: "), "{results}");
    assert_eq!(&results[0]["relatedLocations"][1]["logicalLocations"][0]["name"], place);
    let heading = "<w:p><w:pPr><w:outlineLvl w:val=\"0\"/></w:pPr><w:r><w:t>Sums</w:t></w:r></w:p>";
    let (_folder, path) = file("c.docx", &docx(&(heading.to_owned() + &paragraph(&text("12 + 13 = 26")))));
    let (_, out, _) = run(&["--format", "sarif", &path]);
    let whole: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    let result = &whole["runs"][0]["results"][0];
    let message = result["message"]["text"].as_str().unwrap_or_default();
    assert!(message.starts_with("Under ‘Sums’, paragraph 2: 12 + 13"), "{result}");
    assert_eq!(result["locations"][0]["logicalLocations"][0]["name"], "under ‘Sums’, paragraph 2");
}

#[test]
fn decimal_commas_of_word_are_recognised_in_one_run_and_in_several() {
    let square = |base: &str| format!("<m:sSup>{}<m:sup>{}</m:sup></m:sSup>", e(&r(base)), r("2"));
    let area = |last: &str| formula(&format!("{}{}{}", r("A=π∙"), square("2,5"), r(&format!("={last}"))));
    right_and_wrong(&area("19,63"), &area("19,36"), "printed 19.36, recomputed 19.63");
    right_and_wrong(&formula(&r("A=π∙2,5²=19,63")), &formula(&r("A=π∙2,5²=19,36")), "printed 19.36, recomputed 19.63");
    // Each sign in a run of its own, as pandoc writes it: nothing decides here, and a nought does there.
    let runs = |text: &str| formula(&text.split(' ').map(r).collect::<String>());
    let open = "A = 3 ∙ 6 , 25 = 19 , 63";
    let (findings, all) = found("a.docx", &docx(&runs(open)));
    assert!(findings.is_empty(), "{all}");
    assert!(all.contains("Not checked: 1 chain with numbers with a comma, which may be decimal commas."), "{all}");
    let (findings, all) = found("a.docx", &docx(&(runs("1 , 05 + 0 , 95 = 2 , 00") + &runs(open))));
    assert_eq!(findings, ["printed 19.63, recomputed 18.75"], "{all}");
    // A list with space is one.
    let listed = |last: &str| docx(&formula(&r(&format!("x=1, 2+2={last}, 3"))));
    assert_eq!(found("a.docx", &listed("4")).0, [""; 0]);
    assert_eq!(found("a.docx", &listed("5")).0, ["printed 5, recomputed 4"]);
}
