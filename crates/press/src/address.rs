//! Where the book can be read and where its source is, if that is settled.
//!
//! The place for both is the book's imprint, which takes them from `homepage` and `repository` in a `Cargo.toml`. While they
//! are empty, a book that a workflow of GitHub builds takes them from the name of its repository. Everything reads well
//! without them, too.

use crate::imprint::Imprint;
use std::env;

/// The addresses of a published book.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Address {
    /// The folder of the pages, with a slash at the end.
    pub book: String,
    /// The repository, without a slash at the end. Empty if only the book's is known.
    pub source: String,
}

/// The addresses in the imprint. README and CITATION.cff have these only, so that they are alike wherever they are made.
pub fn settled(imprint: &Imprint) -> Option<Address> {
    Address::from_manifest(imprint.homepage, imprint.repository)
}

/// The addresses in the imprint, or else those that follow from `GITHUB_REPOSITORY`, which a workflow of GitHub sets.
pub fn known(imprint: &Imprint) -> Option<Address> {
    settled(imprint).or_else(|| Address::of_github(&env::var("GITHUB_REPOSITORY").unwrap_or_default()))
}

impl Address {
    /// The addresses as a manifest has them. An empty one is none, and so is one that is no web address.
    pub fn from_manifest(homepage: &str, repository: &str) -> Option<Self> {
        let is_web =
            |text: &&str| text.starts_with("https://") && text.bytes().all(|byte| is_plain(byte) || byte == b':');
        let book = Some(homepage).filter(is_web)?;
        let source = Some(repository).filter(is_web).unwrap_or_default();
        Some(Self { book: format!("{}/", book.trim_end_matches('/')), source: source.trim_end_matches('/').to_owned() })
    }

    /// The addresses of a repository `owner/name` at GitHub, and of the pages that its workflow publishes.
    pub fn of_github(repository: &str) -> Option<Self> {
        let (owner, name) = repository.split_once('/')?;
        let is_name = |text: &str| !text.is_empty() && text.bytes().all(|byte| is_plain(byte) && byte != b'/');
        if !is_name(owner) || !is_name(name) {
            return None;
        }
        let host = format!("{}.github.io", owner.to_lowercase());
        // The pages of a repository with this name are at the root.
        let folder = if name.to_lowercase() == host { String::new() } else { format!("{name}/") };
        Some(Self { book: format!("https://{host}/{folder}"), source: format!("https://github.com/{owner}/{name}") })
    }

    /// The address of a page, with what comes behind its name.
    pub fn page(&self, name: &str) -> String {
        format!("{}{name}", self.book)
    }
}

/// Whether it is a letter, a digit or a sign that needs no care in an address, HTML, BibTeX or YAML.
fn is_plain(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_' | b'.' | b'/')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_or_strange_address_is_none() {
        for (homepage, repository) in
            [("", ""), ("", "https://github.com/a/b"), ("ftp://a", ""), ("https://a/\"><script>", ""), ("a", "b")]
        {
            assert_eq!(Address::from_manifest(homepage, repository), None, "{homepage} {repository}");
        }
        for name in ["", "a", "a/", "/b", "a/b/c", "a/b c", "a/<b>"] {
            assert_eq!(Address::of_github(name), None, "{name}");
        }
    }

    #[test]
    fn a_repository_at_github_has_its_pages_beside_those_of_its_owner() {
        let of = Address::of_github("Some-One/geneva").expect("an address");
        assert_eq!(of.book, "https://some-one.github.io/geneva/");
        assert_eq!(of.source, "https://github.com/Some-One/geneva");
        assert_eq!(of.page("pin.html"), "https://some-one.github.io/geneva/pin.html");
        assert_eq!(Address::of_github("Me/me.github.io").expect("an address").book, "https://me.github.io/");
    }

    #[test]
    fn a_manifest_may_have_the_book_alone() {
        let of = Address::from_manifest("https://example.org/geneva", "").expect("an address");
        assert_eq!((of.book.as_str(), of.source.as_str()), ("https://example.org/geneva/", ""));
        assert_eq!(Address::from_manifest("https://example.org/geneva/", "").expect("an address"), of);
    }
}
