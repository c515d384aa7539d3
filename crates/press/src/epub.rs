//! The whole book as an ebook, in EPUB 3.3: the chapters that are printed, a file of XHTML each, with their formulas in MathML and
//! their drawings in SVG.
//!
//! It has no script and no font, and loads nothing. Whoever packs the same edition twice gets the same bytes.

use crate::address::Address;
use crate::book::Book;
use crate::changelog;
use crate::edition::Edition;
use crate::imprint::Imprint;
use crate::print::{self, StillChapter};
use crate::still::Medium;
use crate::xhtml::{escape, file_name};
use anyhow::Context;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::fs;
use std::io::{Cursor, Write};
use std::path::Path;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// The style sheet.
const STYLE: &str = include_str!("../theme/epub.css");
/// What a file of this kind begins with.
const KIND: &str = "application/epub+zip";
/// The folder of everything but the kind and the container.
const FOLDER: &str = "EPUB";
/// The files of the contents, the title page and the style sheet.
const CONTENTS: &str = "nav.xhtml";
const TITLE_PAGE: &str = "title.xhtml";
const STYLE_SHEET: &str = "style.css";
/// When the book was changed, where neither a commit nor the environment nor a release says so: the day from which an archive counts.
const NO_DATE: &str = "1980-01-01";
/// Of ten levels, the one that packs text well without taking long.
const LEVEL: i64 = 6;

/// The ebook's file in the book.
pub fn file(book: &Book) -> String {
    format!("{}.epub", book.imprint.key)
}

/// Writes the ebook of a book into the folder in which its pages are built. Where none of its pages is there, there is none.
pub fn write(book: &Book, folder: &Path, edition: &Edition, address: Option<&Address>) -> anyhow::Result<()> {
    let mut chapters = print::chapters(book, folder, Medium::Ebook, address)?;
    if chapters.is_empty() {
        return Ok(());
    }
    lead_to_what_is_there(&mut chapters);
    let path = folder.join(file(book));
    let packed = packed(&files(book, &chapters, edition, address)).context("cannot pack the ebook")?;
    fs::write(&path, packed).with_context(|| format!("cannot write {}", path.display()))
}

/// Has each link to a place that was left out lead to the chapter around it.
fn lead_to_what_is_there(chapters: &mut [StillChapter]) {
    const BEFORE: &str = " href=\"";
    let ids: BTreeMap<_, BTreeSet<_>> = chapters
        .iter()
        .map(|chapter| (file_name(chapter.name), chapter.page.ids.iter().map(|id| escape(id)).collect()))
        .collect();
    for chapter in chapters {
        let mut pieces = chapter.page.html.split(BEFORE);
        let mut out = pieces.next().unwrap_or_default().to_owned();
        for piece in pieces {
            out.push_str(BEFORE);
            let (link, rest) = piece.split_at(piece.find('"').unwrap_or(piece.len()));
            let (file, id) = link.split_once('#').unwrap_or((link, ""));
            let is_there = ids.get(file).is_none_or(|ids| ids.contains(id));
            out.push_str(if is_there { link } else { file });
            out.push_str(rest);
        }
        chapter.page.html = out;
    }
}

/// All files: their paths and texts, in the order of the archive.
fn files(
    book: &Book,
    chapters: &[StillChapter],
    edition: &Edition,
    address: Option<&Address>,
) -> Vec<(String, String)> {
    let inside = |name: &str| format!("{FOLDER}/{name}");
    let container = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<container version=\"1.0\" \
         xmlns=\"urn:oasis:names:tc:opendocument:xmlns:container\">\n<rootfiles>\n<rootfile full-path=\"{}\" \
         media-type=\"application/oebps-package+xml\"/>\n</rootfiles>\n</container>\n",
        inside("package.opf")
    );
    let mut files = vec![
        ("META-INF/container.xml".to_owned(), container),
        (inside("package.opf"), package(book, chapters, edition, address)),
        (inside(CONTENTS), contents(&book.imprint, chapters)),
        (inside(STYLE_SHEET), STYLE.to_owned()),
        (inside(TITLE_PAGE), title_page(&book.imprint, edition, address)),
    ];
    for chapter in chapters {
        let text = document(&chapter.heading(), &chapter.page.html);
        files.push((inside(&file_name(chapter.name)), text));
    }
    files
}

/// A document with this title and body.
fn document(title: &str, body: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" \
         xmlns:epub=\"http://www.idpf.org/2007/ops\" lang=\"en\" xml:lang=\"en\">\n<head>\n<meta charset=\"UTF-8\"/>\n<title>{}</title>\n\
         <link rel=\"stylesheet\" href=\"{STYLE_SHEET}\"/>\n</head>\n<body>\n{body}\n</body>\n</html>\n",
        escape(title)
    )
}

fn title_page(imprint: &Imprint, edition: &Edition, address: Option<&Address>) -> String {
    let read = address.map_or_else(String::new, |at| format!("\n<p><a href=\"{0}\">{0}</a></p>", escape(&at.book)));
    let body = format!(
        "<section class=\"title-page\" epub:type=\"titlepage\">\n<h1>{}</h1>\n<p>{}</p>\n<p>{}</p>\n<p>{}</p>{read}\n<p class=\"notice\">{} Text \
         and figures: <a href=\"{}\">{}</a>.</p>\n</section>",
        escape(imprint.title),
        escape(imprint.subtitle),
        escape(imprint.authors),
        escape(&edition.words()),
        escape(
            "This is the whole book as an ebook. The marks ✓ ≈ ✗ ? say that we checked what is before them: right, right as \
                finely as we could read it off, wrong, open. The ledger of all claims, the coverage of the sources and the data are \
                left out, figures stand still, and of an example in Rust you see only the line that says what it shows."
        ),
        escape(imprint.licence_address),
        escape(imprint.licence_words),
    );
    document(imprint.title, &body)
}

/// The contents: parts, chapters and their sections.
fn contents(imprint: &Imprint, chapters: &[StillChapter]) -> String {
    let mut out = format!("<li><a href=\"{TITLE_PAGE}\">{}</a></li>\n", escape(imprint.title));
    let mut is_in_part = false;
    for chapter in chapters {
        if let Some(part) = chapter.part {
            out.push_str(if std::mem::replace(&mut is_in_part, true) { "</ol></li>\n" } else { "" });
            out.push_str(&format!("<li><span>{}</span>\n<ol>\n", escape(part)));
        }
        let file = file_name(chapter.name);
        out.push_str(&format!("<li><a href=\"{file}\">{}</a>", escape(&chapter.heading())));
        let sections = &chapter.page.sections;
        if !sections.is_empty() {
            let line = |(id, title): &(String, String)| {
                format!("<li><a href=\"{file}#{}\">{}</a></li>\n", escape(id), escape(title.trim()))
            };
            out.push_str(&format!("\n<ol>\n{}</ol>", sections.iter().map(line).collect::<String>()));
        }
        out.push_str("</li>\n");
    }
    out.push_str(if is_in_part { "</ol></li>\n" } else { "" });
    let body = format!("<nav epub:type=\"toc\" id=\"toc\">\n<h1>Contents</h1>\n<ol>\n{out}</ol>\n</nav>");
    document("Contents", &body)
}

/// What the ebook is made of and what it says of itself.
fn package(book: &Book, chapters: &[StillChapter], edition: &Edition, address: Option<&Address>) -> String {
    let imprint = &book.imprint;
    let source = address.map_or_else(String::new, |at| format!("<dc:source>{}</dc:source>\n", escape(&at.book)));
    let mut manifest = format!(
        "<item id=\"contents\" href=\"{CONTENTS}\" media-type=\"application/xhtml+xml\" properties=\"nav\"/>\n<item id=\"style\" \
         href=\"{STYLE_SHEET}\" media-type=\"text/css\"/>\n<item id=\"title\" href=\"{TITLE_PAGE}\" \
         media-type=\"application/xhtml+xml\"/>\n"
    );
    let mut spine = "<itemref idref=\"title\"/>\n<itemref idref=\"contents\"/>\n".to_owned();
    for chapter in chapters {
        let has = |start: &str| chapter.page.html.contains(start);
        let properties: Vec<_> = [("<math ", "mathml"), ("<svg ", "svg")]
            .into_iter()
            .filter(|(start, _)| has(start))
            .map(|of| of.1)
            .collect();
        let properties = match properties.join(" ") {
            none if none.is_empty() => none,
            some => format!(" properties=\"{some}\""),
        };
        manifest.push_str(&format!(
            "<item id=\"chapter-{0}\" href=\"{1}\" media-type=\"application/xhtml+xml\"{properties}/>\n",
            chapter.name,
            file_name(chapter.name)
        ));
        spine.push_str(&format!("<itemref idref=\"chapter-{}\"/>\n", chapter.name));
    }
    let date = modified(book, edition);
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<package xmlns=\"http://www.idpf.org/2007/opf\" version=\"3.0\" xml:lang=\"en\" \
         unique-identifier=\"id\">\n<metadata xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n<dc:identifier \
         id=\"id\">{id}</dc:identifier>\n<dc:title>{title}</dc:title>\n<dc:creator>{authors}</dc:creator>\n<dc:language>en</dc:language>\n\
         <dc:description>{subtitle}</dc:description>\n<dc:rights>{licence}, {licence_address}</dc:rights>\n{source}<meta \
         property=\"dcterms:modified\">{date}</meta>\n<meta property=\"schema:accessMode\">textual</meta>\n<meta \
         property=\"schema:accessMode\">visual</meta>\n<meta property=\"schema:accessModeSufficient\">textual</meta>\n<meta \
         property=\"schema:accessibilityFeature\">MathML</meta>\n<meta \
         property=\"schema:accessibilityFeature\">alternativeText</meta>\n<meta \
         property=\"schema:accessibilityFeature\">tableOfContents</meta>\n<meta \
         property=\"schema:accessibilityHazard\">none</meta>\n</metadata>\n<manifest>\n{manifest}</manifest>\n<spine>\n{spine}</spine>\n\
         </package>\n",
        id = identifier(&format!("{}, {}", imprint.title, edition.version)),
        title = escape(imprint.title),
        authors = escape(imprint.authors),
        subtitle = escape(imprint.subtitle),
        licence = escape(imprint.licence_words),
        licence_address = escape(imprint.licence_address),
    )
}

/// A name for what these words say, the same wherever it is made: a UUID of version 8, from their hash.
pub(crate) fn identifier(words: &str) -> String {
    let mut bytes = [0; 16];
    bytes.iter_mut().zip(Sha256::digest(words)).for_each(|(byte, of)| *byte = of);
    bytes[6] = bytes[6] & 0x0f | 0x80;
    bytes[8] = bytes[8] & 0x3f | 0x80;
    let digits: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
    format!("urn:uuid:{}-{}-{}-{}-{}", &digits[..8], &digits[8..12], &digits[12..16], &digits[16..20], &digits[20..])
}

/// The day and time of the edition: of its commit, else of the environment's `SOURCE_DATE_EPOCH`, else of the release.
fn modified(book: &Book, edition: &Edition) -> String {
    let of_environment = || env::var("SOURCE_DATE_EPOCH").ok()?.parse().ok().and_then(instant);
    let released = || changelog::release_date(book.changelog, edition.version);
    let committed = edition.date.as_deref().map(changelog::midnight);
    committed.or_else(of_environment).unwrap_or_else(|| changelog::midnight(released().unwrap_or(NO_DATE)))
}

/// A time in seconds since 1970, as in 2026-11-28T10:20:30Z, if its year has four digits.
fn instant(seconds: u64) -> Option<String> {
    const DAY: u64 = 24 * 60 * 60;
    let is_leap = |year: u64| year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let (mut days, of_day) = (seconds / DAY, seconds % DAY);
    let mut year = 1970;
    while days >= 365 + u64::from(is_leap(year)) {
        days -= 365 + u64::from(is_leap(year));
        year += 1;
        if year > 9999 {
            return None;
        }
    }
    let lengths = [31, 28 + u64::from(is_leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 0;
    while days >= lengths[month] {
        days -= lengths[month];
        month += 1;
    }
    let (hour, minute, second) = (of_day / 3600, of_day / 60 % 60, of_day % 60);
    Some(format!("{year}-{:02}-{:02}T{hour:02}:{minute:02}:{second:02}Z", month + 1, days + 1))
}

/// The archive of these files: first its kind, which is not packed, and everything of the same day.
fn packed(files: &[(String, String)]) -> anyhow::Result<Vec<u8>> {
    let options = SimpleFileOptions::default().last_modified_time(DateTime::default()).unix_permissions(0o644);
    let stored = options.compression_method(CompressionMethod::Stored);
    let deflated = options.compression_method(CompressionMethod::Deflated).compression_level(Some(LEVEL));
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    archive.start_file("mimetype", stored)?;
    archive.write_all(KIND.as_bytes())?;
    for (path, text) in files {
        archive.start_file(path.as_str(), deflated)?;
        archive.write_all(text.as_bytes())?;
    }
    Ok(archive.finish()?.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::{BOOK, IMPRINT};
    use std::io::Read;
    use zip::ZipArchive;

    const NONE: Edition = Edition::without_commit(IMPRINT.version);

    /// The ebook of a book with these pages, if it has any.
    fn ebook(pages: &[(&str, &str)]) -> Option<Vec<u8>> {
        let folder = tempfile::tempdir().unwrap();
        for (name, main) in pages {
            let page = format!("<html><head></head><body><main>{main}</main></body></html>");
            fs::write(folder.path().join(name).with_extension("html"), page).unwrap();
        }
        write(&BOOK, folder.path(), &NONE, None).expect("written");
        fs::read(folder.path().join("sample.epub")).ok()
    }

    const PAGES: [(&str, &str); 2] = [
        (
            "pin",
            "<h1 id=\"a\">A</h1>\n<h2 id=\"b\">B &amp; <em>C</em></h2>\n<p>1<br>2 <a href=\"jazar.html#gone\">3</a> <a \
             href=\"jazar.html#c\">4</a> <a href=\"ledger.html#x\">5</a></p>",
        ),
        ("jazar", "<h1 id=\"c\">D</h1>\n<math><mi>x</mi></math><svg viewbox=\"0 0 1 1\"><title>E</title></svg>"),
    ];

    #[test]
    fn the_kind_comes_first_as_it_is_and_two_ebooks_are_alike() {
        let bytes = ebook(&PAGES).expect("an ebook");
        assert_eq!(&bytes[30..58], b"mimetypeapplication/epub+zip");
        let mut archive = ZipArchive::new(Cursor::new(&bytes)).expect("an archive");
        let kind = archive.by_index(0).expect("a file");
        assert_eq!((kind.name(), kind.compression()), ("mimetype", CompressionMethod::Stored));
        drop(kind);
        assert!(bytes == ebook(&PAGES).expect("an ebook"), "two ebooks of one book");
        assert!(ebook(&[]).is_none(), "an ebook without pages");
    }

    #[test]
    fn its_documents_are_well_formed_and_its_links_lead_to_what_is_there() {
        let bytes = ebook(&PAGES).expect("an ebook");
        let mut archive = ZipArchive::new(Cursor::new(&bytes)).expect("an archive");
        let mut read = |name: &str| {
            let mut text = String::new();
            archive.by_name(name).expect(name).read_to_string(&mut text).expect("text");
            if !name.ends_with(".css") {
                let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
                roxmltree::Document::parse_with_options(&text, options).expect(name);
            }
            text
        };
        let chapter = read("EPUB/pin.xhtml");
        assert!(
            chapter.contains("<a href=\"jazar.xhtml\">3</a> <a href=\"jazar.xhtml#c\">4</a> <span>5</span>"),
            "{chapter}"
        );
        assert!(read("EPUB/nav.xhtml").contains("<a href=\"pin.xhtml#b\">B &amp; C</a>"));
        let package = read("EPUB/package.opf");
        assert!(
            package.contains("href=\"jazar.xhtml\" media-type=\"application/xhtml+xml\" properties=\"mathml svg\"/>")
        );
        assert!(package.contains("href=\"pin.xhtml\" media-type=\"application/xhtml+xml\"/>"), "{package}");
        for name in ["EPUB/title.xhtml", "EPUB/jazar.xhtml", "EPUB/style.css", "META-INF/container.xml"] {
            read(name);
        }
    }

    #[test]
    fn an_instant_has_its_day_and_a_name_its_form() {
        for (seconds, expected) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (1_700_000_000, "2023-11-14T22:13:20Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(instant(seconds).as_deref(), Some(expected));
        }
        assert_eq!(instant(u64::MAX), None);
        let name = identifier("A, 1");
        assert_eq!((name.len(), name.as_bytes()[23]), (45, b'8'), "{name}");
        assert!(name == identifier("A, 1") && name != identifier("A, 2"));
        let dated = Edition { date: Some("2026-11-26".to_owned()), ..NONE };
        assert_eq!(modified(&BOOK, &dated), "2026-11-26T00:00:00Z");
    }
}
