//! The programs behind a chapter, which are written at its end: a reader finds them there in one fold.

/// The heading at the end of a chapter under which its programs are, and nothing else.
const HEADING: &str = "## The tests behind this chapter";

/// Folds the programs of a chapter under the words of their heading, whose anchor the fold has.
pub(crate) fn fold_programs(content: &mut String) {
    let Some(at) = content.find(&format!("\n{HEADING}\n")).map(|at| at + 1) else { return };
    let programs = content[at + HEADING.len()..].trim();
    let title = HEADING.trim_start_matches(['#', ' ']);
    let anchor = title.to_lowercase().replace(' ', "-");
    let fold = format!(
        "<details class=\"solution\" id=\"{anchor}\">\n<summary>{title}</summary>\n\n{programs}\n\n</details>\n"
    );
    content.replace_range(at.., &fold);
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEST: &str = "```rust\n// One is one.\nassert_eq!(1, 1);\n```";

    #[test]
    fn all_programs_of_a_chapter_are_in_one_fold_at_its_end_and_keep_their_address() {
        let mut chapter = format!("# A\n\nText.\n\n{HEADING}\n\n{TEST}\n\n{TEST}\n");
        fold_programs(&mut chapter);
        let opening = "<details class=\"solution\" id=\"the-tests-behind-this-chapter\">\n<summary>The tests behind this chapter</summary>";
        assert_eq!(chapter, format!("# A\n\nText.\n\n{opening}\n\n{TEST}\n\n{TEST}\n\n</details>\n"));
    }

    #[test]
    fn a_chapter_without_programs_at_its_end_stays() {
        let mut other = "# B\n\nThe tests behind this chapter.\n".to_owned();
        fold_programs(&mut other);
        assert_eq!(other, "# B\n\nThe tests behind this chapter.\n");
    }
}
