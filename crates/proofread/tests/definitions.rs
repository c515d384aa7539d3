//! Definitions from other LaTeX texts: what they change, what they leave alone, and what comes before them.

use proofread::{CheckOptions, CheckReport, Definitions, TextFormat, proofread};

/// What is found in a text that is read with the definitions of another one.
fn with(elsewhere: &str, text: &str) -> CheckReport {
    let definitions = Definitions::from_latex(elsewhere);
    let options = CheckOptions { definitions: Some(&definitions), agreeing: true, ..CheckOptions::default() };
    proofread(text, TextFormat::Latex, options).expect("it can be read")
}

/// The verdicts of the pairs in a text.
fn verdicts(elsewhere: &str, text: &str) -> Vec<&'static str> {
    with(elsewhere, text).findings.iter().map(|of| of.verdict.name()).collect()
}

#[test]
fn each_kind_of_definition_is_known() {
    for (elsewhere, right, wrong) in [
        (r"\newcommand{\half}{\frac12}", r"$3\half = 1.5$", r"$3\half = 1.6$"),
        (r"\newcommand*\half{\frac12}", r"$3\half = 1.5$", r"$3\half = 1.6$"),
        (r"\def\of#1#2{\frac{#1}{#2}}", r"$\of{3}{2} = 1.5$", r"$\of{3}{2} = 1.6$"),
        (r"\providecommand{\pow}[2][2]{#2^{#1}}", r"$\pow{3} + \pow[3]{2} = 17$", r"$\pow{3} + \pow[3]{2} = 18$"),
        (r"\NewDocumentCommand{\of}{m m}{\frac{#1}{#2}}", r"$\of{3}{2} = 1.5$", r"$\of{3}{2} = 1.6$"),
        (r"\NewDocumentCommand\pow{O{2} m}{#2^{#1}}", r"$\pow{3} = 9$", r"$\pow[3]{3} = 9$"),
        (r"\DeclareRobustCommand{\half}{\frac12}", r"$3\half = 1.5$", r"$3\half = 1.6$"),
        (r"\DeclareMathOperator{\tg}{tan}", r"$\tg 45^\circ = 1$", r"$\tg 45^\circ = 2$"),
        (
            r"\DeclareSIUnit{\kmh}{\kilo\metre\per\hour}",
            r"$\SI{36}{\kmh} = \SI{10}{m/s}$",
            r"$\SI{36}{\kmh} = \SI{11}{m/s}$",
        ),
        (
            r"\DeclareSIUnit\pounds{\textsc{lb}}",
            r"$2\cdot\SI{3}{\pounds} = \SI{6}{lb}$",
            r"$2\cdot\SI{3}{\pounds} = \SI{7}{lb}$",
        ),
        (
            r"\DeclareSIUnit[number-unit-product={}]\yr{yr}",
            r"$\SI{2.00}{\yr} = \SI{730}{d}$",
            r"$\SI{2.00}{\yr} = \SI{900}{d}$",
        ),
        (
            r"\DeclareSIUnit{\molar}{M}",
            r"$\SI{2}{\milli\molar} = \SI{0.002}{\molar}$",
            r"$\SI{2}{\milli\molar} = \SI{0.005}{\molar}$",
        ),
        (
            r"\DeclareSIUnit{\yr}{\text{yr}}",
            r"$\SI{365}{\per\yr} = \SI{1.00}{\per\day}$",
            r"$\SI{365}{\per\yr} = \SI{1.20}{\per\day}$",
        ),
        (
            r"\newcommand{\kmh}{\kilo\metre\per\hour}",
            r"$\SI{36}{\kmh} = \SI{10}{m/s}$",
            r"$\SI{36}{\kmh} = \SI{11}{m/s}$",
        ),
    ] {
        assert_eq!(verdicts(elsewhere, right), ["consistent"], "{elsewhere} {right}");
        let wrong = verdicts(elsewhere, wrong);
        assert!(matches!(wrong.as_slice(), ["inconsistent" | "last-digit"]), "{elsewhere} {wrong:?}");
    }
}

#[test]
fn what_is_set_to_nothing_is_not_read() {
    let text = r"\hint{$1 + 1 = 3$} $2 + 2 = 5$";
    assert_eq!(verdicts(r"\newcommand{\hint}[1]{}", text).len(), 1);
    assert_eq!(verdicts(r"\newcommand{\hint}[1]{#1}", text).len(), 2);
    assert_eq!(verdicts("", text).len(), 2);
    // One version of the document has it.
    let both = r"\ifhints \newcommand{\hint}[1]{#1} \else \newcommand{\hint}[1]{} \fi";
    assert_eq!(verdicts(both, text).len(), 2);
}

#[test]
fn the_own_definition_counts_first() {
    let elsewhere = r"\newcommand{\q}{3}";
    assert_eq!(verdicts(elsewhere, r"$1 + \q = 4$"), ["consistent"]);
    assert_eq!(verdicts(elsewhere, r"\newcommand{\q}{4} $1 + \q = 5$"), ["consistent"]);
    assert_eq!(verdicts(elsewhere, r"\newcommand{\q}{4} $1 + \q = 4$"), ["inconsistent"]);
}

#[test]
fn later_definitions_count_and_comments_do_not() {
    let mut all = Definitions::from_latex(r"\newcommand{\q}{3} \newcommand{\p}{1}");
    all.add(&Definitions::from_latex("\\renewcommand{\\q}{4}\n% \\renewcommand{\\p}{2}\n50\\% \\newcommand{\\r}{5}"));
    assert_eq!(all, Definitions::from_latex(r"\def\q{4} \def\p{1} \def\r{5}"));
}

#[test]
fn places_are_those_of_the_text() {
    let text = r"Here $3\half = 1.6$.";
    let report = with(r"\newcommand{\half}{\frac{1}{2}} $1 + 1 = 3$ and a long text before it", text);
    assert_eq!(report.findings.len(), 1);
    assert_eq!(&text[report.findings[0].at.range()], "1.6");
    assert_eq!(report.tally.bytes, text.len());
}

#[test]
fn definitions_that_name_each_other_end() {
    assert_eq!(verdicts(r"\newcommand{\a}{\b} \newcommand{\b}{\a}", r"$\a = 2$ and $1 + 1 = 2$"), ["consistent"]);
    assert_eq!(verdicts(r"\newcommand{\a}{\b}", r"\newcommand{\b}{\a} $\a = 2$ and $1 + 1 = 2$"), ["consistent"]);
    assert_eq!(
        verdicts(r"\DeclareSIUnit{\a}{\b} \DeclareSIUnit{\b}{\a}", r"$\SI{2}{\a} + 1 = 3$ and $1 + 1 = 2$").len(),
        1
    );
}

#[test]
fn a_unit_of_siunitx_is_none_in_a_formula() {
    let elsewhere = r"\DeclareSIUnit\bar{\textsc{bar}} \DeclareSIUnit\frac{fr}";
    assert_eq!(verdicts(elsewhere, r"$\frac{6}{4} = 1.5$"), ["consistent"]);
    // A stroke before several units divides by one of them, so it isn't known what is meant.
    let several = r"\DeclareSIUnit{\conc}{\mole\per\litre}";
    assert_eq!(verdicts(several, r"$\SI{2}{\joule\per\conc} = \SI{3}{\joule\litre\per\mole}$"), [""; 0]);
}

#[test]
fn texts_in_markdown_are_read_with_them_and_plain_ones_without() {
    let definitions = Definitions::from_latex(r"\newcommand{\half}{\frac12}");
    let options = CheckOptions { definitions: Some(&definitions), ..CheckOptions::default() };
    let read = |format| proofread(r"$3\half = 1.6$", format, options).expect("it can be read").tally.checked;
    assert_eq!([TextFormat::Markdown, TextFormat::Latex, TextFormat::Plain].map(read), [1, 1, 0]);
}

#[test]
fn rows_of_reasons_are_no_part_of_the_chain() {
    let row = |with: &str| format!("\\begin{{align}} Q &= 9 - 4 {with} \\\\ &= 5 \\end{{align}}");
    assert_eq!(verdicts("", &row(r"\\ &\because A = 3,\; B = 2")), [""; 0]);
    assert_eq!(verdicts("", &row("")), ["consistent"]);
    assert_eq!(verdicts("", &row(r"\\ &= 6, \because A = 3")), ["inconsistent"]);
}

#[test]
fn an_upright_e_may_be_the_base_of_the_logarithms() {
    for right in [r"$\mathrm{e}^7 = 1096.6$", r"$2\mathrm{e}^{-1} = 0.736$"] {
        assert_eq!(verdicts("", right), ["consistent"], "{right}");
    }
    assert_eq!(verdicts("", r"$\mathrm{e}^7 = 1099.6$"), ["inconsistent"]);
    assert_eq!(verdicts("", r"$1/\mathrm{e} = 0.3679$"), [""; 0]);
    assert_eq!(verdicts("", r"$2\,\mathrm{e} = 3.2\times10^{-19}\,\mathrm{C}$"), ["consistent"]);
}

/// The verdicts of the pairs in a text of some format with macros of its own.
fn verdicts_in(text: &str, format: TextFormat) -> Vec<&'static str> {
    let options = CheckOptions { agreeing: true, ..CheckOptions::default() };
    let report = proofread(text, format, options).expect("it can be read");
    report.findings.iter().map(|of| of.verdict.name()).collect()
}

#[test]
fn macros_of_a_text_in_markdown_hold_wherever_they_are_defined() {
    let chains = r"It is $3 \ee{2} = 300$, and $3 \ee{2} = 340$.";
    for defined in [
        "---\ntitle: a text\nheader-includes:\n  - \\newcommand{\\ee}[1]{\\cdot 10^{#1}}\n---\n\n{}",
        "\\newcommand{\\ee}[1]{\\cdot 10^{#1}}\n\n{}",
        "$$\\newcommand{\\ee}[1]{\\cdot 10^{#1}}$$\n\n{}",
        "{}\n\n$\\def\\ee#1{\\cdot 10^{#1}}$",
    ] {
        let text = defined.replace("{}", chains);
        assert_eq!(verdicts_in(&text, TextFormat::Markdown), ["consistent", "inconsistent"], "{text}");
        let quoted = |text: &str| serde_json::to_string(text).expect("a string");
        let cells: Vec<String> = text
            .split("\n\n")
            .map(|cell| format!("{{\"cell_type\": \"markdown\", \"source\": [{}]}}", quoted(cell)))
            .collect();
        let notebook = format!("{{\"cells\": [{}], \"nbformat\": 4}}", cells.join(", "));
        assert_eq!(verdicts_in(&notebook, TextFormat::Notebook), ["consistent", "inconsistent"], "{notebook}");
    }
    assert_eq!(verdicts_in(chains, TextFormat::Markdown), [""; 0]);
    let page = |macros: &str| {
        format!("<p style=\"width: 100%\">\\({macros}\\)</p><p>\\(3 \\ee{{2}} = 300\\) and \\(3 \\ee{{2}} = 340\\)</p>")
    };
    let macros = "\\newcommand{\\ee}[1]{\\cdot 10^{#1}}";
    assert_eq!(verdicts_in(&page(macros), TextFormat::Html), ["consistent", "inconsistent"]);
    assert_eq!(verdicts_in(&page(""), TextFormat::Html), [""; 0]);
}

#[test]
fn a_definition_in_a_formula_shows_nothing() {
    for definition in [r"\newcommand{\five}{5}", r"\def\five{5}", r"\newcommand\five{5} "] {
        for format in [TextFormat::Markdown, TextFormat::Latex] {
            let text = |sum: u8| format!("$${definition}\\five + 1 = {sum}$$");
            assert_eq!(verdicts_in(&text(6), format), ["consistent"], "{definition}");
            assert_eq!(verdicts_in(&text(7), format), ["inconsistent"], "{definition}");
        }
    }
    // What is no whole definition is not skipped.
    assert_eq!(verdicts_in(r"$\newcommand + 1 = 7$", TextFormat::Markdown), [""; 0]);
}
