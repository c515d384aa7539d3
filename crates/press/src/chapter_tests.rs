//! The programs behind the chapters: each is written at the end of its chapter, and a reader finds all on a page of their own.

use crate::html::escape;
use crate::numbers::{in_words, sentence_start};

/// The heading at the end of a chapter under which its programs are, and nothing else.
const HEADING: &str = "## The tests behind this chapter";
/// What stands in the source of the page that shows the programs of all chapters, where they go.
const PLACE: &str = "{{tests}}";
/// Takes the programs out of a chapter, by its name and title, and leaves a link to the page with all of them. What is taken is
/// their section of that page.
pub(crate) fn take_programs(page: &str, name: &str, title: &str, content: &mut String) -> String {
    let Some(at) = content.find(&format!("\n{HEADING}\n")) else { return String::new() };
    let behind = at + 1 + HEADING.len();
    let tests = content[behind..].trim();
    let link = format!("({page}.md#{name})");
    let led = match tests.matches("```rust\n").count() {
        1 => format!("A [short program]{link} checks a statement in this chapter."),
        count => {
            format!("[{} short programs]{link} check statements in this chapter.", sentence_start(&in_words(count)))
        }
    };
    let section = format!("## {} {{#{name}}}\n\n[To the chapter]({name}.md)\n\n{tests}\n\n", escape(title));
    content.replace_range(behind.., &format!("\n\n{led}\n"));
    section
}

/// Puts the sections where they belong on the page of the programs.
pub(crate) fn insert_programs(sections: &str, content: &mut String) {
    *content = content.replace(PLACE, sections.trim_end());
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEST: &str = "```rust\n// One is one.\nassert_eq!(1, 1);\n```";

    #[test]
    fn a_chapter_keeps_a_link_and_the_page_gets_the_program() {
        let mut chapter = format!("# A\n\nText.\n\n{HEADING}\n\n{TEST}\n");
        let section = take_programs("tests", "a", "A", &mut chapter);
        let link = "A [short program](tests.md#a) checks a statement in this chapter.";
        assert_eq!(chapter, format!("# A\n\nText.\n\n{HEADING}\n\n{link}\n"));

        let mut page = format!("# Tests\n\n{PLACE}\n");
        insert_programs(&section, &mut page);
        assert_eq!(page, format!("# Tests\n\n## A {{#a}}\n\n[To the chapter](a.md)\n\n{TEST}\n"));
        assert!(!chapter.contains(TEST));
    }

    #[test]
    fn several_programs_are_counted_and_a_chapter_without_any_stays() {
        let mut chapter = format!("# A\n\n{HEADING}\n\n{TEST}\n\n{TEST}\n");
        take_programs("tests", "a", "A", &mut chapter);
        assert!(chapter.ends_with("[Two short programs](tests.md#a) check statements in this chapter.\n"));
        let mut other = "# B\n\nNo tests.\n".to_owned();
        assert_eq!((take_programs("tests", "b", "B", &mut other), &*other), (String::new(), "# B\n\nNo tests.\n"));
    }
}
