//! The numbers of pages in the contents of the printed book.
//!
//! No browser fills them in: Chromium reads `target-counter` of CSS, but does not know it. However, the PDF that Chromium prints
//! says on which page each target of a link is. So the document is printed twice, the second time with these numbers.

use anyhow::{Context, ensure};
use std::collections::BTreeMap;

/// On which page of a printed document each target of a link is, counted from 1.
pub type PageNumbers = BTreeMap<String, usize>;

/// Reads the places out of a PDF as Chromium writes it: its objects are not packed, only what is drawn is.
pub fn places(pdf: &[u8]) -> anyhow::Result<PageNumbers> {
    let pdf = Pdf::new(pdf);
    let catalog = pdf.objects.values().find(|object| object.contains("/Type /Catalog"));
    let catalog = catalog.context("the PDF has no catalogue")?;
    let mut order = Vec::new();
    pdf.pages(reference(catalog, "/Pages ").context("the PDF has no pages")?, 0, &mut order)?;
    let targets = pdf.object(reference(catalog, "/Dests ").context("the PDF has no targets of links")?)?;
    let mut places = PageNumbers::new();
    // Each target is a name and in brackets its page and where on it: `/chapter--answer [12 0 R /XYZ 0 828 0]`.
    for target in targets.split(']') {
        let Some((name, place)) = target.split_once('[') else { continue };
        let name = name.rsplit('/').next().unwrap_or_default().trim();
        let page: Option<usize> = place.split_whitespace().next().and_then(|number| number.parse().ok());
        let page = page.with_context(|| format!("the target `{name}` is on no page"))?;
        let at = order.iter().position(|of| *of == page).with_context(|| format!("no page {page} for `{name}`"))?;
        places.insert(unescaped(name), at + 1);
    }
    Ok(places)
}

/// How many pages a PDF has.
pub fn pages(pdf: &[u8]) -> anyhow::Result<usize> {
    let pdf = Pdf::new(pdf);
    let catalog = pdf.objects.values().find(|object| object.contains("/Type /Catalog"));
    let mut order = Vec::new();
    pdf.pages(catalog.and_then(|of| reference(of, "/Pages ")).context("the PDF has no pages")?, 0, &mut order)?;
    Ok(order.len())
}

/// Before the name of the place to which a line of the contents leads.
const BEFORE: &str = "data-page-of=\"";

/// Whether a document has contents for these numbers.
pub fn has_contents(document: &str) -> bool {
    document.contains(BEFORE)
}

/// The document with the number of its page at the end of each line of the contents.
pub fn numbered(document: &str, places: &PageNumbers) -> anyhow::Result<String> {
    let mut pieces = document.split(BEFORE);
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (id, rest) = piece.split_once('"').context("a line of the contents has no end")?;
        let (_, rest) = rest.split_once("</span>").context("a line of the contents has no end")?;
        let page = places.get(id).with_context(|| format!("the printed document has no `{id}`"))?;
        out.push_str(&format!("{BEFORE}{id}\">{page}</span>{rest}"));
    }
    ensure!(has_contents(&out), "the document has no contents");
    Ok(out)
}

/// How many branches the tree of pages may have above one another. Chromium's has eight pages or branches at each.
const DEEPEST: usize = 16;

/// The objects of a PDF by their numbers, as text.
struct Pdf {
    objects: BTreeMap<usize, String>,
}

impl Pdf {
    fn new(bytes: &[u8]) -> Self {
        // One character for one byte, so that what is drawn does no harm.
        let text: String = bytes.iter().map(|byte| char::from(*byte)).collect();
        let mut objects = BTreeMap::new();
        for object in text.split("endobj") {
            let Some((head, body)) = object.split_once(" 0 obj") else { continue };
            let body = body.split("stream").next().unwrap_or_default();
            if let Some(number) = head.rsplit(char::is_whitespace).next().and_then(|number| number.parse().ok()) {
                objects.insert(number, body.to_owned());
            }
        }
        Self { objects }
    }

    fn object(&self, number: usize) -> anyhow::Result<&str> {
        self.objects.get(&number).map(String::as_str).with_context(|| format!("the PDF has no object {number}"))
    }

    /// The pages below a branch of the tree of pages, in their order.
    fn pages(&self, number: usize, depth: usize, order: &mut Vec<usize>) -> anyhow::Result<()> {
        let object = self.object(number)?;
        let Some((_, kids)) = object.split_once("/Kids [") else {
            order.push(number);
            return Ok(());
        };
        ensure!(depth < DEEPEST, "the pages of the PDF go in a circle");
        let kids = kids.split(']').next().unwrap_or_default();
        for kid in kids.split(" 0 R").filter_map(|kid| kid.trim().parse().ok()) {
            self.pages(kid, depth + 1, order)?;
        }
        Ok(())
    }
}

/// The number of the object to which a key refers.
fn reference(object: &str, key: &str) -> Option<usize> {
    object.split_once(key)?.1.split(' ').next()?.parse().ok()
}

/// A name of a PDF, in which `#` and two digits stand for a sign.
fn unescaped(name: &str) -> String {
    let mut pieces = name.split('#');
    let mut out: Vec<u8> = pieces.next().unwrap_or_default().bytes().collect();
    for piece in pieces {
        match piece.get(..2).and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                out.push(byte);
                out.extend(&piece.as_bytes()[2..]);
            }
            None => out.extend(format!("#{piece}").bytes()),
        }
    }
    String::from_utf8_lossy(&out).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PDF: &str = "%PDF-1.4\n1 0 obj\n<</Type /Catalog\n/Pages 2 0 R\n/Dests 7 0 R>>\nendobj\n2 0 obj\n<</Type /Pages\n/Kids [3 0 R 4 0 \
                       R]>>\nendobj\n3 0 obj\n<</Type /Pages\n/Kids [6 0 R 5 0 R]>>\nendobj\n4 0 obj\n<</Type /Page>>\nendobj\n5 0 \
                       obj\n<</Type /Page>>\nendobj\n6 0 obj\n<</Type /Page>>\nendobj\n7 0 obj\n<</pin [6 0 R /XYZ 0 828 0]\n/pin--a#2eb [4 0 \
                       R /XYZ 0 20.5 0]\n/jazar [5 0 R /XYZ 0 0 0]>>\nendobj\n8 0 obj\n<</Length 3>> stream\n/Type /Catalog\nendstream\nendobj\n";

    #[test]
    fn the_places_of_targets_are_read_in_the_order_of_the_pages() {
        let found = places(PDF.as_bytes()).expect("places");
        let expected = [("jazar", 2), ("pin", 1), ("pin--a.b", 3)].map(|(name, page)| (name.to_owned(), page));
        assert_eq!(found, PageNumbers::from(expected));
        assert_eq!(pages(PDF.as_bytes()).expect("a count"), 3);
        for broken in [&PDF[..60], &PDF.replace("5 0 obj", "9 0 obj"), &PDF.replace("[4 0 R", "[8 0 R"), "", "no PDF"] {
            assert!(places(broken.as_bytes()).is_err(), "{broken}");
        }
        assert!(places(PDF.replace("[6 0 R 5", "[3 0 R 5").as_bytes()).is_err());
    }

    #[test]
    fn the_contents_get_the_numbers() {
        let document =
            "<a>One</a> <span class=\"at\" data-page-of=\"pin\"></span><p><span data-page-of=\"jazar\">9</span>";
        let numbers = places(PDF.as_bytes()).expect("places");
        let once = numbered(document, &numbers).expect("numbers");
        assert_eq!(
            once,
            "<a>One</a> <span class=\"at\" data-page-of=\"pin\">1</span><p><span data-page-of=\"jazar\">2</span>"
        );
        assert_eq!(numbered(&once, &numbers).expect("numbers"), once);
        assert!(numbered(document, &PageNumbers::new()).is_err() && numbered("", &numbers).is_err());
    }
}
