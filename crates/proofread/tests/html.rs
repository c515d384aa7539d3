//! The report as a page: whole, closed to what a hostile text brings, and each place can be named.

use crate::command::run;
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
        "<a href=\"#f1-2\">line 4, column ",
    ] {
        assert!(page.contains(part), "{part}\nis not in\n{page}");
    }
    let (code, page) = self::page("a.md", "It is $2 + 2 = 4$.", &[]);
    assert!(code == 0 && page.contains("<p class=\"result right\">Nothing found.</p>") && !page.contains("<article"));
}

#[test]
fn a_page_is_whole_and_its_links_lead_to_places_in_it() {
    let text = "A $2 + 2 = 5$ and $3 + 3 = 7$.\n\nB $4 + 4 = 9$.".repeat(3);
    let (_, page) = page("a.md", &text, &[]);
    let ids: Vec<&str> = page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let links: Vec<&str> = page.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert!(ids.len() >= 9 && links.len() >= 9, "{ids:?} {links:?}");
    let mut once = ids.clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!(once.len(), ids.len(), "an id stands twice");
    for link in links {
        assert!(link.strip_prefix('#').is_some_and(|id| ids.contains(&id)), "{link}");
    }
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
