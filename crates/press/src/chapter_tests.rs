//! The programs behind the chapters: each is written at the end of its chapter, and a reader finds all on a page of their own.

use crate::html::escape;

/// The heading at the end of a chapter under which its programs are, and nothing else.
const HEADING: &str = "## The tests behind this chapter";
/// The page that shows the programs of all chapters, and what stands in its source where they go.
const PAGE: &str = "tests";
const PLACE: &str = "{{tests}}";
/// How a sentence that begins with a number says it.
const IN_WORDS: [&str; 10] = ["No", "One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine"];

/// Takes the programs out of a chapter, by its name and title, and leaves a link. What is taken is their section of the page.
pub fn take(name: &str, title: &str, content: &mut String) -> String {
    let Some(at) = content.find(&format!("\n{HEADING}\n")) else { return String::new() };
    let behind = at + 1 + HEADING.len();
    let tests = content[behind..].trim();
    let link = format!("({PAGE}.md#{name})");
    let led = match tests.matches("```rust\n").count() {
        1 => format!("A [short program]{link} checks a statement in this chapter."),
        count => {
            let many = IN_WORDS.get(count).map_or_else(|| count.to_string(), |word| (*word).to_owned());
            format!("[{many} short programs]{link} check statements in this chapter.")
        }
    };
    let section = format!("## {} {{#{name}}}\n\n[To the chapter]({name}.md)\n\n{tests}\n\n", escape(title));
    content.replace_range(behind.., &format!("\n\n{led}\n"));
    section
}

/// Puts the sections where they belong, if this is the page of the programs.
pub fn put(name: &str, sections: &str, content: &mut String) {
    if name == PAGE {
        *content = content.replace(PLACE, sections.trim_end());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEST: &str = "```rust\n// One is one.\nassert_eq!(1, 1);\n```";

    #[test]
    fn a_chapter_keeps_a_link_and_the_page_gets_the_program() {
        let mut chapter = format!("# A\n\nText.\n\n{HEADING}\n\n{TEST}\n");
        let section = take("a", "A", &mut chapter);
        let link = "A [short program](tests.md#a) checks a statement in this chapter.";
        assert_eq!(chapter, format!("# A\n\nText.\n\n{HEADING}\n\n{link}\n"));

        let mut page = format!("# Tests\n\n{PLACE}\n");
        put("tests", &section, &mut page);
        assert_eq!(page, format!("# Tests\n\n## A {{#a}}\n\n[To the chapter](a.md)\n\n{TEST}\n"));
        put("b", &section, &mut chapter);
        assert!(!chapter.contains(TEST));
    }

    #[test]
    fn several_programs_are_counted_and_a_chapter_without_any_stays() {
        let mut chapter = format!("# A\n\n{HEADING}\n\n{TEST}\n\n{TEST}\n");
        take("a", "A", &mut chapter);
        assert!(chapter.ends_with("[Two short programs](tests.md#a) check statements in this chapter.\n"));
        let mut other = "# B\n\nNo tests.\n".to_owned();
        assert_eq!((take("b", "B", &mut other), &*other), (String::new(), "# B\n\nNo tests.\n"));
    }
}
