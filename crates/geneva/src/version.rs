//! The answer to `geneva --version`: what the program is, and what the project around the current directory is.

use crate::workspace;
use geneva_chapters::BOOK;
use geneva_press::edition::Edition;
use std::path::Path;

/// Version and commit of the program, and the commit of the project's folder if the current directory is in one.
pub(crate) fn page() -> String {
    let project = workspace::root().ok();
    let folder = project.as_deref().map(|root| (root, Edition::detect(&root.join("book"), &BOOK.imprint)));
    page_of(&Edition::compiled(&BOOK.imprint), folder.as_ref().map(|(root, edition)| (*root, edition)))
}

/// The first line is about the program alone. A program that doesn't know its commit says so, and takes it from no folder.
fn page_of(program: &Edition, folder: Option<(&Path, &Edition)>) -> String {
    let words = program.words();
    let mut page = format!("geneva {}\n", words.strip_prefix("version ").unwrap_or(&words));
    if program.commit.is_none() {
        page += "The commit that it was compiled from is not recorded in it.\n";
    }
    if let Some((root, edition)) = folder {
        let commit = edition.commit_in_words().unwrap_or_else(|| "no commit".to_owned());
        page += &format!("The project in {} has {commit}.\n", root.display());
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: Edition = Edition::without_commit(env!("CARGO_PKG_VERSION"));

    #[test]
    fn the_commit_of_a_folder_is_not_taken_for_that_of_the_program() {
        let edition = |commit: &str, is_changed: bool| Edition {
            commit: Some(commit.repeat(40)),
            date: Some("2026-11-26".to_owned()),
            is_changed,
            ..NONE
        };
        let version = NONE.version;
        let unknown = "The commit that it was compiled from is not recorded in it.\n";
        let known = format!("geneva {version}, commit aaaaaaa of 2026-11-26\n");
        let root = Path::new("project");
        assert_eq!(page_of(&NONE, None), format!("geneva {version}\n{unknown}"));
        assert_eq!(page_of(&edition("a", false), None), known);
        assert_eq!(
            page_of(&NONE, Some((root, &edition("b", true)))),
            format!("geneva {version}\n{unknown}The project in project has commit bbbbbbb of 2026-11-26, changed.\n")
        );
        assert_eq!(
            page_of(&edition("a", false), Some((root, &NONE))),
            format!("{known}The project in project has no commit.\n")
        );
    }
}
