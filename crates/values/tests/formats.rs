//! Every format of texts: what is read, what is left out, and where it is in the file.

use crate::Project;

const VALUES: &str = r#"{"period": 2.00641, "share": 0.12345, "size": 1234.4, "small": 0.00123}"#;

/// Records and checks a text whose numbers are the four values, with a changed digit for each that must be found in its place.
#[track_caller]
fn assert_read(name: &'static str, source: &str, printed: [&str; 4]) {
    let project = Project::new(name, source, VALUES);
    let report = project.record();
    assert_eq!(report.ties.get("value"), Some(&4), "{}", project.read("numbers.toml"));
    assert_eq!(project.differing(), Vec::<String>::new(), "{}", project.read("numbers.toml"));
    for digits in printed {
        assert_eq!(source.matches(digits).count(), 1, "{digits}");
        // The last digit of what is written between any marks of the format.
        let last = digits.rfind(|c: char| c.is_ascii_digit()).expect("a digit");
        let next = char::from(b'0' + (digits.as_bytes()[last] - b'0' + 3) % 10);
        let changed = format!("{}{next}{}", &digits[..last], &digits[last + 1..]);
        project.write(name, &source.replace(digits, &changed));
        let check = project.check();
        let found: Vec<_> = check.findings.iter().filter(|finding| !finding.kind.is_right()).collect();
        assert_eq!(found.len(), 1, "{digits}: {found:?}");
        let at = source.find(digits).expect("there");
        let line = source[..at].matches('\n').count() + 1;
        let column = source[..at].rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        let place = found[0].at.map(|[start, _]| (start.line, start.column));
        assert_eq!(place, Some((line, column)), "{digits}");
    }
}

#[test]
fn plain_text() {
    let text = "The period is 2.006 s.\nThe share is 12.3 per cent of\n1,234 parts; the rest is 1.23e-3.\n";
    assert_read("a.txt", text, ["2.006", "12.3", "1,234", "1.23"]);
}

#[test]
fn markdown() {
    let text = "---\ndate: 7.77\n---\n# Results\n\nThe period is **2.006 s**, see [the page 9](http://x.org/8.88).\n\n\
        ```\ncode 5.55\n```\n<!-- 4.44 -->\n| share | size |\n|---|---|\n| $12.3\\,\\%$ | 1,234 |\n\nA `x = 6.66` and \
        $1.23\\times10^{-3}$.\n";
    assert_read("a.md", text, ["2.006", "12.3", "1,234", "1.23"]);
    let project = Project::new("a.md", text, VALUES);
    project.record();
    let left_out = project.check().left_out;
    assert_eq!(left_out.values().copied().collect::<Vec<_>>(), [2, 1, 1, 1], "{left_out:?}");
}

#[test]
fn latex() {
    let text = "\\documentclass[11pt]{article}\n\\newcommand{\\x}{9.99}\n\\begin{document}\nThe period is \
        \\SI{2.006}{\\second}. % not 2.007 s\nThe share is $12.3\\,\\%$ of 1{,}234~parts, \\label{eq:7.7}\n\\[ x = \
        1.23\\times 10^{-3} \\]\n\\begin{verbatim}\n8.88\n\\end{verbatim}\n\\vspace{1.5cm}\n\\end{document}\n";
    assert_read(
        "a.tex",
        text,
        ["2.006", "12.3", "234", "1.23"].map(|digits| if digits == "234" { "1{,}234" } else { digits }),
    );
}

#[test]
fn html() {
    let text = "<html><head><title>3.33</title><style>p { width: 4.44em }</style></head><body><p class=\"c5.5\">The \
        period is <b>2.006</b>&nbsp;s.</p>\n<p>The share is 12.3&#37; of 1,234 parts.</p>\n<!-- 6.66 --><p>It is \
        1.23&times;10<sup>&minus;3</sup> <code>7.77</code>.</p></body></html>\n";
    assert_read("a.html", text, ["2.006", "12.3", "1,234", "1.23"]);
}

#[test]
fn notebook() {
    let text = "{\"cells\": [{\"cell_type\": \"markdown\", \"source\": [\"The period is\\n\", \"2.006 s, the share \
        12.3 %.\"]},\n{\"cell_type\": \"code\", \"source\": [\"x = 9.99\"]},\n{\"cell_type\": \"markdown\", \"source\": \
        \"Of 1,234 parts \\u00e0 $1.23\\\\times 10^{-3}$.\"}]}";
    assert_read("a.ipynb", text, ["2.006", "12.3", "1,234", "1.23"]);
}

#[test]
fn xml() {
    let text = "<doc><para id=\"p1\">The period is <m:math><m:mn>2.006</m:mn></m:math> s.</para>\n<para>The share is \
        12.3 % of 1,234 parts, or 1.23e-3.</para></doc>";
    assert_read("a.xml", text, ["2.006", "12.3", "1,234", "1.23"]);
}

#[test]
fn what_a_program_fills_in_is_left_out() {
    let text = "# Sizes {#sec-2}\n\nIn {{ site.year2 }} the period is 2.006 s {{#include b3.rs}}, the share $12.3\\,\\%$, and of\n\
        1,234 parts, {{note 7 (a)}} it is $\\frac{{1.23e-3}}{2}$, that{{is:1}} 1.23e-3.\n";
    let project = Project::new("a.md", text, VALUES);
    assert_eq!(project.record().ties.get("value"), Some(&5), "{}", project.read("numbers.toml"));
    assert_eq!(project.check().left_out.values().sum::<usize>(), 5);
}

#[test]
fn numbers_among_letters_of_a_formula_are_given() {
    let text = "With $k^2 - 2k + 1 = 0$ and $r = 30 - \\cos\\theta$ we get $n = 30$, $$m = 4 \\cdot 12$$ and 7 of a kind, $x = 2.5 y$.\n";
    let project = Project::new("a.md", text, VALUES);
    project.record();
    let given = geneva_values::Record::parse(&project.read("numbers.toml")).expect("a record").entries;
    let given = given.iter().filter(|entry| entry.tie == geneva_values::Tie::None("given".to_owned()));
    assert_eq!(given.map(|entry| &*entry.printed).collect::<Vec<_>>(), ["2k", "1", "30"]);
}

#[test]
fn a_table_of_values_is_no_text() {
    let project = Project::new("a.md", "The width is 4.57 mm.\n", r#"{"height": "7.12 mm"}"#);
    project.write("values.csv", "name,value,unit\nwidth,4.5678,mm\n");
    project.write("more.csv", "name,value,unit\nlength,9.5678,mm\n");
    let report = project.record();
    assert_eq!(report.numbers, 1, "{}", project.read("numbers.toml"));
    assert_eq!(report.ties.get("value"), Some(&1), "{}", project.read("numbers.toml"));
}
