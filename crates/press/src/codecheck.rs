//! The configuration with which somebody else checks that a book's data come out again: `codecheck.yml`, in the form of
//! CODECHECK 2.0.

use crate::imprint::Imprint;
use crate::ro_crate::DataFile;

/// The `codecheck.yml` of a book: what it is, by whom, and which files its build makes in a folder, from the root of the
/// project. Who has checked it, and with what result, is for the one who does to add.
///
/// The files are those behind figures and tables, and the claims.
pub fn codecheck(imprint: &Imprint, folder: &str, files: &[DataFile]) -> String {
    let mut out = format!(
        "---\nversion: https://codecheck.org.uk/spec/config/2.0/\npaper:\n  title: {}\n  authors:\n    - name: {}\nmanifest:\n",
        quoted(&format!("{}. {}", imprint.title, imprint.subtitle)),
        quoted(imprint.authors),
    );
    for file in files {
        let comment = match (file.name.as_str(), file.title()) {
            ("claims.json", _) => "Every claim with its verdict",
            (_, "") => continue,
            (_, title) => title,
        };
        out.push_str(&format!(
            "  - file: {}\n    comment: {}\n",
            quoted(&format!("{folder}/{}", file.name)),
            quoted(comment)
        ));
    }
    out
}

/// A text between double quotes, as YAML reads it: what JSON writes.
fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
