//! Which edition of the book this is: at the foot of every page.

use crate::html::escape;
use std::path::Path;
use std::process::Command;

/// Version, and commit with its date where the book is made from a repository.
pub fn footer(book: &Path) -> String {
    let commit = commit(book).map_or_else(String::new, |commit| format!(", {}", escape(&commit)));
    format!(
        "\n<footer class=\"edition\">Geneva, verified, version {}{commit}. <a href=\"about.html\">Sources, data, how to \
         cite</a>.</footer>\n",
        env!("CARGO_PKG_VERSION")
    )
}

/// The commit that the book is made from, and its date.
fn commit(book: &Path) -> Option<String> {
    let git = Command::new("git").arg("-C").arg(book).args(["log", "-1", "--format=commit %h of %cs"]).output().ok()?;
    let said = String::from_utf8(git.stdout).ok()?;
    Some(said.trim().to_owned()).filter(|said| git.status.success() && !said.is_empty())
}
