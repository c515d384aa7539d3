//! What a document is written in, and where it is.

use crate::reader::TextFormat;
use std::path::PathBuf;

/// Other names of formats than their own, as editors have them.
const LANGUAGES: [(&str, TextFormat); 17] = [
    ("tex", TextFormat::Latex),
    ("plaintex", TextFormat::Latex),
    ("context", TextFormat::Latex),
    ("quarto", TextFormat::Markdown),
    ("rmd", TextFormat::Markdown),
    ("rmarkdown", TextFormat::Markdown),
    ("pandoc", TextFormat::Markdown),
    ("gfm", TextFormat::Markdown),
    ("xhtml", TextFormat::Html),
    ("nxml", TextFormat::Xml),
    ("docbk", TextFormat::Xml),
    ("pretext", TextFormat::Xml),
    ("plaintext", TextFormat::Plain),
    ("text", TextFormat::Plain),
    ("txt", TextFormat::Plain),
    ("ipynb", TextFormat::Notebook),
    ("tsv", TextFormat::Csv),
];

/// What a document is written in, by the name of its language and by its address; none if neither tells a format.
///
/// The ending of a file says more than that its text is plain, which an editor says if it knows no better.
pub(super) fn format_of(language: &str, address: &str) -> Option<TextFormat> {
    let language = language.to_ascii_lowercase();
    let other_name = || LANGUAGES.iter().find(|(name, _)| *name == language).map(|(_, format)| *format);
    let named = TextFormat::from_name(&language).or_else(other_name);
    let ending = || {
        let file = address.rsplit(['/', '\\']).next()?.split(['?', '#']).next()?;
        TextFormat::from_extension(file.rsplit_once('.')?.1)
    };
    match named {
        None => ending(),
        Some(TextFormat::Plain) => ending().or(named),
        Some(_) => named,
    }
}

/// The file of an address; none if it is that of no file.
pub(super) fn file_of(address: &str) -> Option<PathBuf> {
    let scheme = address.get(..7)?;
    let rest = address.get(7..).filter(|_| scheme.eq_ignore_ascii_case("file://"))?;
    let path = &rest[rest.find('/')?..];
    let mut bytes = Vec::with_capacity(path.len());
    let mut left = path.as_bytes();
    while let [first, rest @ ..] = left {
        let escaped = rest.get(..2).filter(|digits| *first == b'%' && digits.iter().all(u8::is_ascii_hexdigit));
        let value = escaped.and_then(|digits| u8::from_str_radix(std::str::from_utf8(digits).ok()?, 16).ok());
        bytes.push(value.unwrap_or(*first));
        left = if value.is_some() { &rest[2..] } else { rest };
    }
    let path = String::from_utf8(bytes).ok()?;
    // On Windows there is a slash before the letter of the drive.
    let path = if cfg!(windows) { path.trim_start_matches('/') } else { &path };
    Some(PathBuf::from(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_recipes_name_languages_that_the_server_knows() {
        let recipes = include_str!("../../../README.md");
        let lists: Vec<&str> = recipes
            .lines()
            .filter(|line| ["filetypes = {", "pattern = {"].iter().any(|of| line.contains(of)))
            .collect();
        assert_eq!(lists.len(), 3, "{lists:?}");
        for list in lists {
            let languages: Vec<&str> = list.split('\'').skip(1).step_by(2).collect();
            assert!(["tex", "plaintex", "rmd"].iter().all(|of| languages.contains(of)), "{list}");
            assert!(languages.iter().all(|of| format_of(of, "").is_some()), "{list}");
        }
    }

    #[test]
    fn the_language_decides_and_else_the_ending() {
        for (language, address, format) in [
            ("latex", "untitled:1", Some(TextFormat::Latex)),
            ("quarto", "file:///a.txt", Some(TextFormat::Markdown)),
            ("LaTeX", "file:///a.md", Some(TextFormat::Latex)),
            ("plaintex", "file:///a", Some(TextFormat::Latex)),
            ("nxml", "file:///a", Some(TextFormat::Xml)),
            ("docbk", "file:///a", Some(TextFormat::Xml)),
            ("plaintext", "file:///a.tex", Some(TextFormat::Latex)),
            ("plaintext", "file:///a.d/notes", Some(TextFormat::Plain)),
            ("json", "file:///a.ipynb", Some(TextFormat::Notebook)),
            ("", "file:///a.HTML?x#y.tex", Some(TextFormat::Html)),
            ("python", "file:///a.py", None),
            ("", "file:///md", None),
            ("", "", None),
        ] {
            assert_eq!(format_of(language, address), format, "{language} {address}");
        }
        let names: std::collections::BTreeSet<_> = LANGUAGES.iter().map(|(name, _)| *name).collect();
        assert_eq!(names.len(), LANGUAGES.len());
        assert!(names.iter().all(|name| TextFormat::from_name(name).is_none()));
    }

    #[cfg(not(windows))]
    #[test]
    fn an_address_of_a_file_is_its_path() {
        for (address, path) in [
            ("file:///home/a%20b/%CE%94.md", Some("/home/a b/Δ.md")),
            ("file://localhost/a+b%", Some("/a+b%")),
            ("FILE:///a%2", Some("/a%2")),
            ("file:///a%zz%+1", Some("/a%zz%+1")),
            ("untitled:Untitled-1", None),
            ("file://", None),
            ("file:///%ff", None),
            ("Δ", None),
        ] {
            assert_eq!(file_of(address), path.map(PathBuf::from), "{address}");
        }
    }
}
