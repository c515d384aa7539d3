//! The report as a page: whole, closed to what a hostile text brings, and each place can be named.

use crate::command::run;
use crate::office::{docx, paragraph, text as words_of};
use std::fs;

fn page(name: &str, text: &str, options: &[&str]) -> (u8, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join(name);
    fs::write(&file, text).expect("written");
    let file = file.to_string_lossy().into_owned();
    let arguments: Vec<&str> = ["--format", "html"].iter().chain(options).copied().chain([file.as_str()]).collect();
    let (code, out, _) = run(&arguments);
    (code, out)
}

#[test]
fn a_page_shows_the_place_the_values_and_what_was_not_checked() {
    let text = "First.\n\nIt is $\\tan 31.0^\\circ = 0.609$ here.\nThen $\\foo{7} = 36$, and $1 = 0.08$.\n\n~~~python\nx = 1\n~~~\n";
    let (code, page) = page("a.md", text, &["--doubts", "--unchecked"]);
    assert_eq!(code, 1);
    for part in [
        "<p class=\"result wrong\">2 findings: 1 on a number, 1 in doubt.</p>",
        "<li>Checked 2 chains of 3 chains that arithmetic can check",
        "1 fence of <code>python</code>.</li>",
        "It is $\\tan 31.0^\\circ = <mark>0.609</mark>$ here.",
        "<dt>Recomputed</dt><dd>0.601</dd>",
        "<dt>Hint</dt><dd><code>0.601</code> for <code>0.609</code> would agree</dd>",
        "<dt>Set aside</dt>",
        "<li>Line 4, not checked, <code>\\foo</code> is not known: <code>\\foo{7} = 36</code></li>",
        "<span class=\"place\">line 4, column ",
    ] {
        assert!(page.contains(part), "{part}\nis not in\n{page}");
    }
    let text = "It is $2 + 2 = 5$, $|3| = 4$, $3 + 3 = 7$.";
    let [certain, less] = [&[][..], &["--less-certain"]].map(|options| self::page("a.md", text, options).1);
    for part in [
        " class=\"other-list less-certain\"",
        "<dt>Less certain</dt><dd>neither side computes anything",
        "<input type=\"checkbox\" id=\"certain-only\">",
    ] {
        assert!(less.contains(part) && !certain.contains(part), "{part}\n{less}");
    }
    for page in [&certain, &less] {
        assert!(page.contains("<summary>At 1 more place of the same shape</summary>"), "{page}");
        assert!(page.contains("<li>Line 1, column 40: <span class=\"chain\">3 + 3 = 7</span></li>"), "{page}");
        assert!(page.contains("<dt>Note</dt><dd>3 of 3 pairs of this document differ"), "{page}");
    }
    assert!(certain.contains("<li>1 less certain difference.</li>"), "{certain}");
    let (code, page) = self::page("a.md", "It is $2 + 2 = 4$.", &[]);
    assert!(code == 0 && page.contains("<p class=\"result right\">Nothing found.</p>") && !page.contains("<article"));
}

#[test]
fn a_page_is_whole_and_its_links_lead_to_places_in_it() {
    let text = "A $2 + 2 = 5$ and $3 + 3 = 7$.\n\nB $4 + 4 = 9$.".repeat(3);
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["a.md", "b.md", "c.md"] {
        fs::write(folder.path().join(name), &text).expect("written");
    }
    let (_, page, _) = run(&["--format", "html", folder.path().to_str().expect("UTF-8")]);
    let ids: Vec<&str> = page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let links: Vec<&str> = page.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert!(ids.len() >= 9 && links.len() == 3, "{ids:?} {links:?}");
    let links_to_findings: Vec<&&str> = links.iter().filter(|link| link.contains('-')).collect();
    let mut once = ids.clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!(once.len(), ids.len(), "an id stands twice");
    for link in &links {
        assert!(link.strip_prefix('#').is_some_and(|id| ids.contains(&id)), "{link}");
    }
    // A finding that links to itself leads nowhere.
    assert!(links_to_findings.is_empty(), "{links_to_findings:?}");
    for outside in ["http:", "https:", "src=", "url(", "@import", "<script", "<link"] {
        assert!(!page.contains(outside), "{outside}");
    }
    for element in [
        "html", "head", "body", "main", "header", "section", "article", "dl", "dd", "dt", "pre", "span", "mark", "ul",
        "li",
    ] {
        let opened = page.matches(&format!("<{element}>")).count() + page.matches(&format!("<{element} ")).count();
        assert_eq!(opened, page.matches(&format!("</{element}>")).count(), "{element}");
    }
}

#[test]
fn a_hostile_text_is_only_shown() {
    let hostile = "</pre><script>alert(1)</script><img src=x onerror='alert(2)'> \"&quot; \u{202e}txet \u{1b}[31m";
    let text = format!("{hostile}\nIt is $2 + 2 = 5$ {hostile} $\\text{{<b>}} 1 + 1 = 3$ `{hostile}`\n{hostile}");
    let (code, page) = page("a<img src=x>.md", &text, &["--doubts", "--unchecked", "--units"]);
    assert_eq!(code, 1);
    for part in ["<script", "<img", "<b>", "\u{202e}", "\u{1b}"] {
        assert!(!page.contains(part), "{part:?} is in\n{page}");
    }
    assert!(page.contains("&lt;/pre&gt;&lt;script&gt;alert(1)&lt;/script&gt;"), "{page}");
    assert!(page.contains("a&lt;img src=x&gt;.md"), "{page}");
}

#[test]
fn a_long_line_is_cut_around_the_place() {
    let text = format!("{} $2 + 2 = 5$ {}", "é".repeat(30_000), "ß".repeat(30_000));
    let (_, page) = page("a.md", &text, &[]);
    assert!(page.len() < 12_000 && page.contains("<mark>5</mark>"), "{} bytes", page.len());
}

#[test]
fn a_page_of_a_document_of_word_names_its_places_and_raises_exponents() {
    let heading =
        "<w:p><w:pPr><w:pStyle w:val=\"Heading1\"/></w:pPr><w:r><w:t>Power &amp; <![CDATA[<b>]]></w:t></w:r></w:p>";
    let cell = |words: &str| format!("<w:tc>{}</w:tc>", paragraph(&words_of(words)));
    let body = heading.to_owned()
        + &paragraph(&words_of("So 3.0·10^−3·2.0 = 6.2·10^−3 holds."))
        + &format!("<w:tbl><w:tr>{}{}</w:tr></w:tbl>", cell("A"), cell("x + 12 + 13 = 26 and 2 + 2 = 5"));
    let (_folder, path) = crate::office::file("a.docx", &docx(&body));
    let (code, page, _) = run(&["--format", "html", "--unchecked", "--doubts", "--less-certain", &path]);
    assert_eq!(code, 1);
    for part in [
        "<span class=\"place\">under ‘Power &amp; ",
        "’, paragraph 2</span>",
        "’, table 1, row 1, cell 2</span>",
        "10<sup>−3</sup>",
        "<mark>6.2·10<sup>−3</sup></mark> holds.",
        "<span class=\"number\" aria-hidden=\"true\"></span>",
        "<li>Under ‘Power",
    ] {
        assert!(page.contains(part), "{part}\nis not in\n{page}");
    }
    for part in ["line 2", "Line ", ", column", "10^", "<b>", "--unchecked", "--doubts"] {
        assert!(!page.contains(part), "{part}\nis in\n{page}");
    }
}

#[test]
fn a_page_tells_of_no_options() {
    let text = "So $2 + 2 = 5$, $\\foo{7} = 36$, $1 = 0.08$, $4.9\\,\\mathrm{m/s} \\cdot 2.0\\,\\mathrm{s} = 9.8\\,\\mathrm{m/s}$.";
    let (_, page) = page("a.md", text, &[]);
    assert!(page.contains("Not checked: 1 chain with <code>\\foo</code>.</li>"), "{page}");
    assert!(page.contains("1 place agrees in its numbers but not in its units.</li>"), "{page}");
    for option in ["--units", "--doubts", "--unchecked"] {
        assert!(!page.contains(option), "{option} is in\n{page}");
    }
}
