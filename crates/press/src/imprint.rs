//! What a book says of itself: title, authors, version, licences, and where it can be read.

/// Title, authors, version and licences of a book, and the program that builds it.
#[derive(Debug)]
pub struct Imprint {
    /// The title.
    pub title: &'static str,
    /// What is below the title.
    pub subtitle: &'static str,
    /// Who answers for it.
    pub authors: &'static str,
    /// The key of its entry in BibTeX.
    pub key: &'static str,
    /// What it is about, in the lines of `CITATION.cff`.
    pub summary: &'static [&'static str],
    /// What `CITATION.cff` asks of its reader, in lines.
    pub request: &'static [&'static str],
    /// Words by which it is found.
    pub keywords: &'static [&'static str],
    /// The version of the project.
    pub version: &'static str,
    /// The licence of the book's text, figures and data, as SPDX names it.
    pub licence: &'static str,
    /// That licence, as a sentence names it.
    pub licence_words: &'static str,
    /// Where its text is.
    pub licence_address: &'static str,
    /// The licences of the programs, any of which may be chosen, which is what a list means in a CFF file.
    pub program_licences: &'static [&'static str],
    /// The address of the pages; empty until it is settled.
    pub homepage: &'static str,
    /// The address of the source; empty until it is settled.
    pub repository: &'static str,
    /// The program that builds the book, by whose name `book.toml` calls it.
    pub program: &'static str,
    /// The commit that this program is compiled from and its date, as `git log -1 --format='%H %cs'` prints them, if whoever
    /// compiles it says so.
    pub compiled_from: Option<&'static str>,
}

impl Imprint {
    /// A book under CC BY 4.0 whose program, of this name and version, is under MIT or Apache 2.0. It has no subtitle and no address,
    /// and its key in BibTeX is the program's name.
    pub const fn new(title: &'static str, authors: &'static str, program: &'static str, version: &'static str) -> Self {
        Self {
            title,
            subtitle: "",
            authors,
            key: program,
            summary: &[],
            request: &["Please cite it by its title."],
            keywords: &[],
            version,
            licence: "CC-BY-4.0",
            licence_words: "CC BY 4.0",
            licence_address: "https://creativecommons.org/licenses/by/4.0/",
            program_licences: &["MIT", "Apache-2.0"],
            homepage: "",
            repository: "",
            program,
            compiled_from: None,
        }
    }
}
