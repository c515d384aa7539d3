//! What other programs show as text is read as text: directives, chunks with any options, formulas with space inside their marks.

use crate::{assert_told_apart, report, wrong};
use proofread::TextFormat::{Latex, Markdown};

#[test]
fn directives_are_read_however_they_nest() {
    let text = |sum: &str| {
        format!(
            "````{{admonition}} Answer to $1 + 2 = 3$\n:class: tip\n\nIt is $2 + 3 = {sum}$.\n\n```{{math}}\n:label: eq-1\n4 + 5 = 9\n```\n````\n"
        )
    };
    assert_eq!(report(&text("5"), Markdown).tally.checked, 3);
    assert_eq!(wrong(&text("5"), Markdown), [""; 0]);
    assert_eq!(wrong(&text("6"), Markdown), ["2 + 3 | 6"]);
    for fence in [
        "```{solution-start} ex:1",
        "~~~{note}",
        "```{prf:example} Sums",
        "- a\n\n  ```{tip}",
        "```{block2, type='note'}",
    ] {
        let end = &fence.trim_start_matches("- a\n\n  ")[..3];
        let text = format!("{fence}\n$$\n2 + 3 = 6\n$$\n{end}\n\nThen $2 + 2 = 5$.");
        assert_eq!(wrong(&text, Markdown), ["2 + 3 | 6", "2 + 2 | 5"], "{fence}");
    }
}

#[test]
fn what_is_shown_as_code_is_not_read() {
    for fence in ["```{code-block} python", "```{r, echo=FALSE}", "```{python}", "```", "````{code-cell} ipython3"] {
        let end = &fence[..fence.find('{').unwrap_or(3)];
        let text = format!("{fence}\ny = 2 + 3 = 6\n{end}\n\nThen $2 + 2 = 5$.");
        assert_eq!(wrong(&text, Markdown), ["2 + 2 | 5"], "{fence}");
    }
    // A directive that is only shown.
    assert_eq!(wrong("````md\n```{note}\n$2 + 3 = 6$\n```\n````\n", Markdown), [""; 0]);
}

#[test]
fn options_of_a_chunk_may_have_backticks() {
    let chunk = "```{r fig, fig.cap=\"The `x` values.\"}\ny <- 2 + 3 = 6\n```\n";
    assert_eq!(wrong(&format!("{chunk}\nSum: $2 + 2 = 4$.\n\n{chunk}"), Markdown), [""; 0]);
    assert_eq!(wrong(&format!("{chunk}\nSum: $2 + 2 = 5$.\n\n{chunk}"), Markdown), ["2 + 2 | 5"]);
}

#[test]
fn space_inside_the_marks_of_a_formula_hides_nothing() {
    assert_eq!(wrong("So $2 - 4 = -2 $ and $ 3 - 4 = -1$ and $ \\frac12 = 0.5 $.", Markdown), [""; 0]);
    assert_eq!(wrong("So $2 - 4 = -3 $ and $ 3 - 4 = -3$.", Markdown), ["2 − 4 | −3", "3 − 4 | −3"]);
}

#[test]
fn the_place_of_a_block_is_no_factor() {
    assert_eq!(wrong(r"$$\begin{aligned}[t] 2+3 &= 5 \\ &= 5.0 \end{aligned}$$", Markdown), [""; 0]);
    for block in ["aligned", "gathered", "alignedat"] {
        let count = if block == "alignedat" { "{2}" } else { "" };
        let tex = format!("$$\\begin{{{block}}}[t]{count} 2+3 &= 6 \\end{{{block}}}$$");
        assert_eq!(wrong(&tex, Markdown), ["2 + 3 | 6"], "{block}");
        assert_eq!(wrong(&tex, Latex), ["2 + 3 | 6"], "{block}");
    }
}

#[test]
fn running_text_of_latex_is_read() {
    let page = |text: &str| {
        format!("\\documentclass[a=1+1=3]{{x}}\n\\begin{{document}}\n{text}\n\\end{{document}}\n1 + 1 = 3")
    };
    let right =
        "The sum is 1.2 + 0.5 = 1.7, \\emph{and} 20\\% of 50 = 10.\n\n\\textbf{2~+~3~=~5}. Pages 3--5 = 3 pages.";
    assert_eq!(wrong(&page(right), Latex), [""; 0]);
    assert!(report(&page(right), Latex).tally.checked > 2);
    for (text, found) in [
        ("The sum is 1.2 + 0.5 = 1.25.", "1.2 + 0.5 | 1.25"),
        ("Here \\textbf{20\\% of 50 = 11}.", "20% × 50 | 11"),
        ("\\begin{tabular}{l}Sum & 3 + 4 = 8 \\\\ \\end{tabular}", "3 + 4 | 8"),
        ("\\item 3 + 4 = 8", "3 + 4 | 8"),
        ("The sum is 1.2 +\n0.5 % so\n  = 1.8.", "1.2 + 0.5 | 1.8"),
    ] {
        assert_eq!(wrong(&page(text), Latex), [found], "{text}");
    }
    for text in [
        "% 1 + 1 = 3",
        "\\verb|1 + 1 = 3|",
        "\\begin{verbatim}\n1 + 1 = 3\n\\end{verbatim}",
        "\\begin{axis}[a=1 + 1 = 3]\n1 + 1 = 3\n\\end{axis}",
        "\\label{1 + 1 = 3}",
        "\\newcommand{\\a}{1 + 1 = 3}",
        "\\includegraphics[width=1 + 1 = 3]{a}",
        "$x$ + 1 = 3",
        "\\half + 1 = 3",
        "The range is 26.\n86 - 23.13 = 3.73",
    ] {
        assert_eq!(wrong(&page(text), Latex), [""; 0], "{text}");
    }
}

#[test]
fn a_finding_in_running_text_of_latex_has_its_place() {
    let text = "Für \\emph{den} Fall: $x$; so \\textbf{1.2 + 0.5 = 1.25}.";
    let finding = &report(text, Latex).findings[0];
    assert_eq!((&text[finding.at.range()], &text[finding.left_span.range()]), ("1.25", "1.2 + 0.5"));
}

#[test]
fn chunks_of_bookdown_with_text_are_read() {
    for name in ["example", "exercise", "theorem", "lemma", "definition", "block2"] {
        for options in ["", ", label=\"x\"", " ex1, name=\"Sums\""] {
            let chunk = |sum: &str| format!("```{{{name}{options}}}\nTake $2 + 3 = {sum}$.\n```\n");
            assert_eq!(wrong(&chunk("5"), Markdown), [""; 0]);
            assert_eq!(wrong(&chunk("6"), Markdown), ["2 + 3 | 6"], "{name}{options}");
        }
    }
}

#[test]
fn admonitions_and_tabs_of_mkdocs_are_read() {
    for mark in ["!!! note", "??? example \"Größe\"", "???+ tip", "=== \"Überblick\""] {
        let text = |sum: &str| {
            format!("{mark}\n\n    Take $2 + 2 = 4$.\n\n    And\n\n    $$2 + 3 = {sum}$$\n\nThen $1 + 1 = 2$.\n")
        };
        for before in ["", "Text\n\n"] {
            assert_eq!(wrong(&(before.to_owned() + &text("5")), Markdown), [""; 0]);
            assert_eq!(wrong(&(before.to_owned() + &text("6")), Markdown), ["2 + 3 | 6"], "{before}{mark}");
        }
        let nested = format!(
            "!!! note\n\n    {mark}\n\n        Take $2 + 2 = 4$.\n\n        So $2 + 3 = 6$.\n\n    Also $3 + 3 = 7$.\n"
        );
        assert_eq!(wrong(&nested, Markdown), ["2 + 3 | 6", "3 + 3 | 7"], "{mark}");
    }
    // What is indented elsewhere is code.
    for code in [
        "Text\n\n    !!! note\n\n        $2 + 3 = 6$\n",
        "!!!\n\n    $2 + 3 = 6$\n",
        "!!! note\n\nText\n\n    $2 + 3 = 6$\n",
    ] {
        assert_eq!(wrong(code, Markdown), [""; 0], "{code}");
    }
}

#[test]
fn code_in_an_environment_of_its_own_is_not_read() {
    let code = |name: &str| format!("\\begin{{{name}}}\n2 + 2 = 5\n\\end{{{name}}}\n");
    assert_told_apart(&code("pythoncode"), &code("remark"), Latex);
}

#[test]
fn a_chunk_ends_with_its_line_of_marks_in_html_and_in_lists_too() {
    for before in [
        "<center>\n```{r}\n\nx <- 1\n```\n</center>\n\n",
        "1. Item.\n\n    ```{r}\nx <- 1\n```\n\n1. ",
        "<div>\n\n```{r}\ny <- 2\n```\n\n</div>\n\n",
    ] {
        let text = |result: &str| format!("{before}So $0.9\\cdot 0.9 = {result}$.\n");
        assert_told_apart(&text("0.81"), &text("0.85"), Markdown);
        let code = before.replace(" 1\n```", " 1\n2 + 2 = 5\n```").replace(" 2\n```", " 2\n2 + 2 = 5\n```");
        let report = report(&code, Markdown);
        assert!(report.findings.is_empty(), "{code}");
        assert_eq!(report.not_read.total(), 1, "{code}");
    }
}

#[test]
fn admonitions_in_lists_are_text() {
    for (item, mark) in [("1. ", "??? answer \"x\""), ("- ", "!!! note"), ("10) ", "=== \"tab\"")] {
        let text =
            |sum: &str| format!("{item}How many are there?\n\n    {mark}\n\n        ${sum}$\n\n{item}And now?\n");
        assert_told_apart(&text("2^{12} = 4096"), &text("2^{12} = 4095"), Markdown);
    }
    // Without a mark, what is indented so far is code.
    assert_eq!(wrong("1. How many?\n\n        $2^{12} = 4095$\n", Markdown), [""; 0]);
    assert_eq!(wrong("Text.\n\n    ??? answer \"x\"\n\n        $2^{12} = 4095$\n", Markdown), [""; 0]);
}
