//! E-books (EPUB 2 and 3): the chapters of the spine, in its order.

use super::super::tags::next_tag;
use super::ArchivedText;
use super::archive::Archive;
use super::nodes::decoded;
use std::collections::{BTreeSet, HashMap};

/// What an e-book is called in errors.
const CALLED: &str = ".epub";
/// Most chapters.
const MOST_CHAPTERS: usize = 2000;

/// Reads the chapters of the book in an archive.
pub(super) fn read(mut archive: Archive<'_>) -> Result<Vec<ArchivedText>, String> {
    let container = archive.needed("META-INF/container.xml", CALLED)?;
    let package_name = attribute_of(&container, "rootfile", "full-path")
        .ok_or("this is no .epub: `META-INF/container.xml` names no package; make the book anew")?;
    let package = archive.needed(&package_name, CALLED)?;
    let encrypted = encrypted(&archive.text("META-INF/encryption.xml")?.unwrap_or_default());
    let folder = package_name.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut out = Vec::new();
    for name in spine(&package).into_iter().take(MOST_CHAPTERS) {
        let name = resolved(folder, &name);
        if encrypted.contains(&name) {
            return Err(format!("the chapter `{name}` is encrypted; give a book without protection against copying"));
        }
        let page = archive.needed(&name, CALLED)?;
        out.push(ArchivedText::Page { name, page });
    }
    if out.is_empty() {
        return Err("the book has no chapters: its spine names none; make the book anew".to_owned());
    }
    Ok(out)
}

fn attribute_of(xml: &str, element: &str, name: &str) -> Option<String> {
    let mut at = 0;
    while let Some(tag) = next_tag(xml, at) {
        if tag.name == element && !tag.closes {
            return tag.attribute(name).map(decoded);
        }
        at = tag.end;
    }
    None
}

/// The addresses of the chapters, in the order of the spine.
fn spine(package: &str) -> Vec<String> {
    let (mut items, mut order, mut at) = (HashMap::new(), Vec::new(), 0);
    while let Some(tag) = next_tag(package, at) {
        at = tag.end;
        match tag.name.as_str() {
            "item" if !tag.closes => {
                let is_page = tag.attribute("media-type").is_some_and(|kind| kind.contains("html"));
                if let (Some(id), Some(address), true) = (tag.attribute("id"), tag.attribute("href"), is_page) {
                    items.insert(decoded(id), decoded(address));
                }
            }
            "itemref" if !tag.closes => order.extend(tag.attribute("idref").map(decoded)),
            _ => {}
        }
    }
    // An item that is named twice is read once.
    order.iter().filter_map(|id| items.remove(id)).collect()
}

/// The names of the entries that are encrypted; of fonts, only the first bytes are changed.
fn encrypted(xml: &str) -> BTreeSet<String> {
    let (mut out, mut at) = (BTreeSet::new(), 0);
    while let Some(tag) = next_tag(xml, at) {
        at = tag.end;
        if tag.name == "cipherreference" {
            out.extend(tag.attribute("URI").map(|address| resolved("", &decoded(address))));
        }
    }
    out
}

/// The name of the entry that an address leads to from a folder.
fn resolved(folder: &str, address: &str) -> String {
    let address = address.split(['#', '?']).next().unwrap_or_default();
    let mut bytes = Vec::new();
    let mut rest = address.as_bytes();
    while let [byte, behind @ ..] = rest {
        let code = behind.get(..2).and_then(|code| u8::from_str_radix(std::str::from_utf8(code).ok()?, 16).ok());
        match code.filter(|_| *byte == b'%') {
            Some(code) => {
                bytes.push(code);
                rest = &behind[2..];
            }
            None => {
                bytes.push(*byte);
                rest = behind;
            }
        }
    }
    let address = String::from_utf8_lossy(&bytes).into_owned();
    let start = if address.starts_with('/') { "" } else { folder };
    let mut parts: Vec<&str> = Vec::new();
    for part in start.split('/').chain(address.split('/')) {
        match part {
            "" | "." => {}
            // Above the archive there is nothing.
            ".." => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_address_leads_out_of_the_archive() {
        assert_eq!(resolved("OEBPS", "text/ch%201.xhtml#top"), "OEBPS/text/ch 1.xhtml");
        assert_eq!(resolved("OEBPS", "../../../etc/passwd"), "etc/passwd");
        assert_eq!(resolved("OEBPS", "/a.xhtml"), "a.xhtml");
    }
}
