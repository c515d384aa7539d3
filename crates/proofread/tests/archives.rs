//! Texts of LibreOffice, e-books, folders with documents, and archives that are hostile or broken.

use crate::command::run;
use crate::office::{archive, document, docx, file, found, paragraph, text};

const MANIFEST: &str = "<manifest:manifest/>";

fn odt(body: &str, objects: &[(&str, &str)]) -> Vec<u8> {
    let styles = "<office:automatic-styles>\
        <style:style style:name=\"T1\"><style:text-properties style:text-position=\"super 58%\"/></style:style>\
        <style:style style:name=\"T2\"><style:text-properties style:text-line-through-style=\"solid\"/></style:style>\
        </office:automatic-styles>";
    let content = format!(
        "<office:document-content>{styles}<office:body><office:text>{body}</office:text></office:body></office:document-content>"
    );
    let mut entries = vec![
        ("mimetype", "application/vnd.oasis.opendocument.text"),
        ("META-INF/manifest.xml", MANIFEST),
        ("content.xml", &content),
    ];
    entries.extend(objects);
    archive(&entries)
}

/// A text whose paragraph is a formula.
fn formula(inside: &str) -> Vec<u8> {
    let frame = "<text:h text:outline-level=\"1\">Results</text:h><text:p><draw:frame><draw:object xlink:href=\"./Object 1\"/></draw:frame></text:p>";
    odt(frame, &[("Object 1/content.xml", &format!("<math xmlns=\"m\"><mrow>{inside}</mrow></math>"))])
}

#[test]
fn signs_among_the_letters_of_libreoffice_are_signs() {
    let chain = |sign: &str, last: &str| format!("<mn>12</mn><mi>{sign}</mi><mn>3</mn><mo>=</mo><mn>{last}</mn>");
    for (sign, right, recomputed) in
        [("⋅", "36", "36"), ("×", "36", "36"), ("·", "36", "36"), ("+", "15", "15"), ("−", "9", "9"), ("÷", "4", "4")]
    {
        let (findings, all) = found("a.odt", &formula(&chain(sign, right)));
        assert!(findings.is_empty() && all.contains("Checked 1 chain of 1 chain"), "{sign}: {all}");
        let (findings, all) = found("a.odt", &formula(&chain(sign, "38")));
        let said = findings.first().map(String::as_str).unwrap_or_default();
        assert!(said.starts_with(&format!("printed 38, recomputed {recomputed}")), "{sign}: {all}");
        assert!(all.contains("a.odt, under ‘Results’, paragraph 2\n"), "{all}");
    }
    // Relations are signs as well, and letters stay letters.
    let (findings, all) = found("a.odt", &formula("<mn>12</mn><mo>+</mo><mn>3</mn><mi>≈</mi><mn>38</mn>"));
    assert_eq!(findings.len(), 1, "{all}");
    for letter in ["∞", "∂", "ℏ", "x", "′"] {
        let (findings, all) = found("a.odt", &formula(&chain(letter, "38")));
        assert!(findings.is_empty() && !all.contains("Checked 1 chain of"), "{letter}: {all}");
    }
}

#[test]
fn decimal_commas_of_libreoffice_are_recognised() {
    let square = |number: &str| format!("<mi>π</mi><mi>⋅</mi><msup>{number}<mn>2</mn></msup><mo>=</mo>");
    let whole = |last: &str| formula(&(square("<mn>2,5</mn>") + &format!("<mn>{last}</mn>")));
    assert_eq!(found("a.odt", &whole("19,63")).0, [""; 0]);
    assert_eq!(found("a.odt", &whole("19,36")).0, ["printed 19.36, recomputed 19.63"]);
}

#[test]
fn texts_of_libreoffice_are_read() {
    let line =
        |body: &str, last: &str| format!("<text:h>A title</text:h><text:p>{}</text:p>", body.replace("RESULT", last));
    let object = |last: &str| {
        format!(
            "<math xmlns=\"m\"><semantics><mrow><mfrac><mrow><mn>43.4</mn><mo>−</mo><mn>29.8</mn></mrow><mn>2</mn></mfrac>\
        <mo>=</mo><mroot><mn>{last}</mn><mn>3</mn></mroot></mrow><annotation encoding=\"StarMath 5.0\">{{43.4 - 29.8}} over 2 = 5</annotation></semantics></math>"
        )
    };
    let frame = "<draw:frame><draw:object xlink:href=\"./Object 1\"/><draw:image xlink:href=\"./ObjectReplacements/Object 1\"/><svg:desc>formula 2 = 3</svg:desc></draw:frame>";
    for (body, right, wrong, said) in [
        (
            "The sum<text:s text:c=\"2\"/>12 + <text:span text:style-name=\"T9\">13</text:span> = RESULT.",
            "25",
            "26",
            "printed 26, recomputed 25",
        ),
        (
            "3.0 · 10<text:span text:style-name=\"T1\">5</text:span> · 2 = RESULT · 10<text:span text:style-name=\"T1\">5</text:span>",
            "6.0",
            "6.2",
            "printed 6.2 · 10^5, recomputed 6.0 × 10^5",
        ),
        (
            "<text:span text:style-name=\"T2\">2 + 2 = 5</text:span> No: 12 + 13 = RESULT<office:annotation><text:p>or 1 = 2?</text:p></office:annotation>",
            "25",
            "26",
            "printed 26, recomputed 25",
        ),
        (
            "A note<text:note text:note-class=\"footnote\"><text:note-citation>1</text:note-citation><text:note-body><text:p>It is 12 + 13 = RESULT.</text:p></text:note-body></text:note>",
            "25",
            "26",
            "printed 26, recomputed 25",
        ),
    ] {
        let (findings, all) = found("a.odt", &odt(&line(body, right), &[]));
        assert!(findings.is_empty() && all.contains("Checked 1 chain of 1 chain"), "{all}");
        assert_eq!(found("a.odt", &odt(&line(body, wrong), &[])).0, [said]);
    }
    let body = format!("<text:p>Half is {frame}, so.</text:p>");
    let with = |last: &str| odt(&body, &[("Object 1/content.xml", &object(last))]);
    let (findings, all) = found("a.odt", &with("314.432"));
    assert!(findings.is_empty() && all.contains("Checked 1 chain of 1 chain"), "{all}");
    let (findings, all) = found("a.odt", &with("414.432"));
    assert_eq!(findings, ["recomputed 6.800 against 7.456"], "{all}");
    assert!(all.contains("| Half is (43.4−29.8)/2=3√414.432, so.\n"), "{all}");
    // Headers of pages are counted.
    let pages = "<office:master-styles><style:header><text:p>T = 5</text:p></style:header><style:footer/></office:master-styles>";
    let (_, all) = found("a.odt", &odt("<text:p>None.</text:p>", &[("styles.xml", pages)]));
    assert!(all.contains("Not read, with an equals sign and a digit: 1 element `header`."), "{all}");
    // A chart is no formula, and neither is what is missing.
    let (_, all) = found("a.odt", &odt(&body, &[("Object 1/content.xml", "<chart/>")]));
    assert!(all.contains("Not read: 1 object of `embedded object`."), "{all}");
    let row = |cells: [&str; 2]| {
        format!(
            "<table:table-row>{}</table:table-row>",
            cells.map(|of| format!("<table:table-cell><text:p>{of}</text:p></table:table-cell>")).concat()
        )
    };
    let table = |total: &str| {
        odt(
            &format!(
                "<table:table>{}</table:table>",
                [["Item", "Cost"], ["Screws", "1,234"], ["Nails", "2,345"], ["Boards", "3,456"], ["Total", total]]
                    .map(row)
                    .concat()
            ),
            &[],
        )
    };
    assert_eq!(found("a.odt", &table("7,035")).0, [""; 0]);
    let (findings, all) = found("a.odt", &table("7,135"));
    assert!(findings == ["printed 7,135, recomputed 7035"] && all.contains(", table 1, row 5, cell 2"), "{all}");
    let changes = "<text:tracked-changes><text:changed-region><text:deletion><text:p>1 + 1 = 3</text:p></text:deletion></text:changed-region></text:tracked-changes><text:p>So 12 + 13 = 25.</text:p>";
    let (findings, all) = found("a.odt", &odt(changes, &[]));
    assert!(findings.is_empty() && all.contains("with an equals sign and a digit: 1 comment."), "{all}");
}

const CONTAINER: &str = "<container><rootfiles><rootfile full-path=\"OEBPS/book.opf\"/></rootfiles></container>";

fn epub(chapters: [&str; 2], more: &[(&str, &str)]) -> Vec<u8> {
    let package = "<package><manifest><item id=\"b\" href=\"ch%202.xhtml\" media-type=\"application/xhtml+xml\"/>\
        <item id=\"a\" href=\"ch1.xhtml\" media-type=\"application/xhtml+xml\"/><item id=\"c\" href=\"c.css\" media-type=\"text/css\"/></manifest>\
        <spine><itemref idref=\"a\"/><itemref idref=\"b\"/></spine></package>";
    let mut entries = vec![
        ("mimetype", "application/epub+zip"),
        ("META-INF/container.xml", CONTAINER),
        ("OEBPS/book.opf", package),
        ("OEBPS/ch 2.xhtml", chapters[1]),
        ("OEBPS/ch1.xhtml", chapters[0]),
    ];
    entries.extend(more);
    archive(&entries)
}

#[test]
fn the_chapters_of_a_book_are_read_in_their_order() {
    let chapter = |last: &str| {
        format!("<html>\n<p>It is <math><mn>12</mn><mo>+</mo><mn>13</mn><mo>=</mo><mn>{last}</mn></math>.</p></html>")
    };
    let (findings, all) = found("book.epub", &epub([&chapter("25"), &chapter("25")], &[]));
    assert!(
        findings.is_empty()
            && all.contains(
                "Checked 2 chains of 2 chains that arithmetic can check, in 2 formulas or lines and 2 documents."
            ),
        "{all}"
    );
    let (findings, all) = found("book.epub", &epub([&chapter("26"), &chapter("27")], &[]));
    assert_eq!(findings, ["printed 26, recomputed 25", "printed 27, recomputed 25"], "{all}");
    let places = ["book.epub/OEBPS/ch1.xhtml:2:", "book.epub/OEBPS/ch 2.xhtml:2:"].map(|place| all.find(place));
    assert!(places[0].is_some() && places[0] < places[1], "{all}");
    let (_folder, path) = file("book.epub", &epub([&chapter("26"), &chapter("25")], &[]));
    let (_, out, _) = run(&["--format", "sarif", &path]);
    assert!(out.contains("\"name\": \"OEBPS/ch1.xhtml\"") && out.contains("In OEBPS/ch1.xhtml: "), "{out}");
}

/// Exit code and message for a file that is refused.
fn refused(name: &str, bytes: &[u8]) -> String {
    let (_folder, path) = file(name, bytes);
    let (code, out, told) = run(&[&path]);
    assert_eq!((code, out.as_str()), (2, ""), "{told}");
    assert!(told.starts_with(&format!("error: {path}: ")), "{told}");
    told.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn hostile_and_broken_archives_are_refused_with_what_to_do() {
    let whole = docx(&paragraph(&text("12 + 13 = 26")));
    for length in [0, 1, 30, whole.len() / 2, whole.len() - 1] {
        let told = refused("a.docx", &whole[..length]);
        assert!(told.contains("this is no whole .docx") || told.contains("save it anew"), "{told}");
    }
    assert!(refused("a.docx", b"no archive").contains("open it in its program, and save it anew"));
    assert!(refused("a.docx", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1").contains("save it without a password, as .docx"));
    assert!(refused("a.docx", &archive(&[("a", "b")])).contains("no `word/document.xml`"));
    assert!(refused("a.odt", &whole).contains("no `content.xml`"));
    assert!(refused("a.epub", &whole).contains("no `META-INF/container.xml`"));
    let encrypted = archive(&[("META-INF/manifest.xml", "<a><manifest:encryption-data/></a>"), ("content.xml", "x")]);
    assert!(refused("a.odt", &encrypted).contains("the file is encrypted; save it without a password"));
    let protected = "<e><enc:CipherReference URI=\"OEBPS/ch1.xhtml\"/></e>";
    assert!(
        refused("a.epub", &epub(["<p/>", "<p/>"], &[("META-INF/encryption.xml", protected)]))
            .contains("`OEBPS/ch1.xhtml` is encrypted")
    );
    let font = "<e><enc:CipherReference URI=\"OEBPS/font.otf\"/></e>";
    assert_eq!(found("a.epub", &epub(["<p/>", "<p/>"], &[("META-INF/encryption.xml", font)])).0, [""; 0]);
    // Far longer unpacked than packed, and too many entries.
    let long = document(&paragraph(&text(&" ".repeat(8 << 20))));
    assert!(refused("a.docx", &archive(&[("word/document.xml", &long)])).contains("200 times its packed length"));
    let names: Vec<String> = (0..10_001).map(|at| at.to_string()).collect();
    let many: Vec<(&str, &str)> = names.iter().map(|name| (name.as_str(), "")).collect();
    assert!(refused("a.docx", &archive(&many)).contains("10001 entries"));
    // A broken stream, and a text in another encoding.
    let mut torn = whole.clone();
    let body = whole.windows(17).position(|window| window == b"word/document.xml").expect("an entry") + 17;
    torn[body..body + 20].iter_mut().for_each(|byte| *byte ^= 0x55);
    let told = refused("a.docx", &torn);
    assert!(told.contains("`word/document.xml` in the archive is broken") && told.contains("save it anew"), "{told}");
}

#[test]
fn entities_are_not_expanded_and_nesting_has_an_end() {
    let entities = format!(
        "<!DOCTYPE a [<!ENTITY a \"12 + 13 = 26\"><!ENTITY b \"&a;&a;\">]>{}",
        document(&paragraph(&text("&b; &unknown;")))
    );
    assert_eq!(found("a.docx", &archive(&[("word/document.xml", &entities)])).0, [""; 0]);
    for (open, close) in [
        ("<w:tbl><w:tr><w:tc>", "</w:tc></w:tr></w:tbl>"),
        ("<w:p><w:r><w:txbxContent>", "</w:txbxContent></w:r></w:p>"),
        ("<m:oMath><m:f><m:num>", "</m:num></m:f></m:oMath>"),
        ("<m:oMath><m:e><m:d>", ""),
        ("<w:p>", ""),
        ("<w:pPr>", ""),
        ("<w:del>", ""),
    ] {
        let body = format!("{}{}{}", open.repeat(3000), paragraph(&text("12 + 13 = 26")), close.repeat(3000));
        let (_folder, path) = file("a.docx", &docx(&paragraph(&body)));
        let (code, _, told) = run(&[&path]);
        assert!(code < 2, "{open}: {told}");
    }
}

#[test]
fn folders_are_searched_for_documents() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).expect("written");
    write("A.DOCX", &docx(&paragraph(&text("12 + 13 = 26"))));
    write("b.odt", &odt("<text:p>12 + 13 = 27</text:p>", &[]));
    write("~$A.docx", b"who has it open");
    write("old.doc", b"");
    let (code, out, told) = run(&[folder.path().to_str().expect("UTF-8")]);
    assert!(code == 1 && told.is_empty() && out.contains("2 findings"), "{out}{told}");
    assert!(out.contains("Not read: 1 file of `.doc`."), "{out}");
}
