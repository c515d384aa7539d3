//! Every format gives the same chains, at exact places.

use crate::{report, wrong};
use proofread::{CheckOptions, NamePolicy, ReportSection, TextFormat, proofread};

/// The text at which a format's only finding points.
#[track_caller]
fn pointed(text: &str, format: TextFormat) -> String {
    let findings = report(text, format).findings;
    let found: Vec<_> = findings.iter().filter(|of| of.section != ReportSection::Agreeing).collect();
    let [one] = found.as_slice() else { panic!("{found:#?}") };
    text[one.at.range()].to_owned()
}

#[test]
fn the_place_is_the_printed_result() {
    for (text, format, at) in [
        ("It is $2 + 2 = 5$.", TextFormat::Markdown, "5"),
        ("é $$2 + 2 = 5.0\\ \\mathrm{m}$$", TextFormat::Markdown, r"5.0\ \mathrm{m"),
        ("mdBook: \\\\( 2.0 + 2.0 = 5.1 \\\\)", TextFormat::Markdown, "5.1"),
        ("```math\n2 + 2 = 5\n```\n", TextFormat::Markdown, "5"),
        ("```{math}\n2 + 2 = 5\n```\n", TextFormat::Markdown, "5"),
        ("The sum 2 + 2 = 5 is wrong.", TextFormat::Markdown, "5"),
        (r"\begin{align} a &= 2 + 2 \\ &= 5 \end{align}", TextFormat::Latex, "5"),
        (r"\newcommand{\x}[1]{#1 + 2} $\x{2} = 5$", TextFormat::Latex, "5"),
        (r"$\SI{2}{\metre} + \SI{2}{\metre} = \SI{5}{\metre}$", TextFormat::Latex, "5"),
        (
            "<m:math><m:mn>2</m:mn><m:mo>+</m:mo><m:mn>2</m:mn><m:mo>=</m:mo><m:mn>5</m:mn></m:math>",
            TextFormat::Xml,
            "5",
        ),
        ("<p>A &lt; B <math><mn>2</mn><mo>+</mo><mn>2<mo>=</mo><mn>5</mn></p>", TextFormat::Html, "5"),
        (r"<p>With MathJax: \(2 + 2 = 5\)</p>", TextFormat::Html, "5"),
        (r#"{"cells":[{"cell_type":"markdown","source":["é\n","$2 + 2 = 5$"]}]}"#, TextFormat::Notebook, "5"),
        ("<p>It is <m>2 + 2 = 5</m> here.</p>", TextFormat::Xml, "5"),
        ("<md><mrow>x &amp;= 2 + 2</mrow><intertext>so</intertext><mrow>\\amp= 5</mrow></md>", TextFormat::Xml, "5"),
        ("<macros>\\newcommand{\\kN}{\\,\\mathrm{kN}}</macros><me>2\\kN + 2\\kN = 5\\kN</me>", TextFormat::Xml, "5"),
        (
            r#"{"worksheets":[{"cells":[{"cell_type":"markdown","source":["$2 + 2 = 5$"]}]}],"nbformat":3}"#,
            TextFormat::Notebook,
            "5",
        ),
        ("2 + 2 = 5\n", TextFormat::Plain, "5"),
        ("E = 1.5e-3 * 2.00 = 4.1e-3", TextFormat::Plain, "4.1e-3"),
    ] {
        assert!(pointed(text, format).starts_with(at), "{text}: {}", pointed(text, format));
    }
}

#[test]
fn code_and_comments_are_no_formulas() {
    for (text, format) in [
        ("```rust\nlet x = 2 + 2 = 5;\n```\n", TextFormat::Markdown),
        ("`$2 + 2 = 5$`", TextFormat::Markdown),
        ("    $2 + 2 = 5$\n", TextFormat::Markdown),
        ("% $2 + 2 = 5$\n", TextFormat::Latex),
        (r"\verb|$2 + 2 = 5$|", TextFormat::Latex),
        (r"\begin{verbatim} $2 + 2 = 5$ \end{verbatim}", TextFormat::Latex),
        ("<!-- <math><mn>2</mn><mo>=</mo><mn>5</mn></math> -->", TextFormat::Html),
        ("<pre>\\(2 + 2 = 5\\)</pre>", TextFormat::Html),
        ("<md><mrow>2 + 2</mrow><intertext>= 5</intertext></md>", TextFormat::Xml),
        ("<p><m>2 + 2 = 5 and no end", TextFormat::Xml),
        ("<p><m>2 + <fillin/> = 5</m></p>", TextFormat::Xml),
        (r#"{"worksheets":[{"cells":[{"cell_type":"code","input":"$2 + 2 = 5$"}]}]}"#, TextFormat::Notebook),
        (r#"{"cells":[{"cell_type":"code","source":"$2 + 2 = 5$"}]}"#, TextFormat::Notebook),
    ] {
        assert_eq!(wrong(text, format), [""; 0], "{text}");
    }
}

#[test]
fn what_is_meant_to_be_false_is_left_alone() {
    for text in [
        "Is $7/9 = 54/72$ a proportion?",
        "But $3 = 7$ is false, so there is no solution.",
        "We get $3 + 1 = 7$, a contradiction.",
        "$2 + 2 \\neq 5$",
    ] {
        assert_eq!(wrong(text, TextFormat::Markdown), [""; 0], "{text}");
    }
    assert_eq!(wrong("The share is $7/9 = 54/72$ here.", TextFormat::Markdown).len(), 1);
}

#[test]
fn formulas_that_go_on_outside_are_not_judged_by_half() {
    let number = |text: &str| format!("<math><mn>{text}</mn></math>");
    let equals = "<math><mn>2</mn><mo>=</mo><mn>6</mn></math>";
    assert_eq!(wrong(&format!("<p>{}×{equals}</p>", number("3")), TextFormat::Html), [""; 0]);
    assert_eq!(wrong(&format!("<p>3 times {equals}</p>"), TextFormat::Html), [""; 0]);
    assert_eq!(wrong(&format!("<p>We see {equals}</p>"), TextFormat::Html).len(), 1);
}

#[test]
fn equations_side_by_side_are_told_apart() {
    let text = r"\begin{align} a &= 1 + 1 = 2 & b &= 2 + 2 = 5 \end{align}";
    assert_eq!(wrong(text, TextFormat::Latex), ["2 + 2 | 5"]);
    // Each column goes on in the row below.
    let text = r"\begin{align} a &= 1 + 2 & b &= 2 + 4 \\ &= 3 & &= 6 \\ &= 2 + 1 & &= 2 \cdot 4 \end{align}";
    assert_eq!(wrong(text, TextFormat::Latex), ["6 | 2·4"]);
    let text = r"\begin{eqnarray} a & = & 1 + 2 \\ & = & 3 \\ & = & 5 \end{eqnarray}";
    assert_eq!(wrong(text, TextFormat::Latex), ["3 | 5"]);
}

#[test]
fn values_of_names_are_used_where_that_is_safe() {
    let text = "Let $m = 2.0\\ \\text{kg}$ and $a = 3.0\\ \\text{m/s}^2$. Then $F = m a = 7.0\\ \\text{N}$.";
    let lists = |name_policy| {
        let options = CheckOptions { name_policy, ..CheckOptions::default() };
        let findings = proofread(text, TextFormat::Markdown, options).expect("it is read").findings;
        findings.iter().map(|of| of.section).collect::<Vec<_>>()
    };
    assert_eq!(lists(NamePolicy::Never), []);
    assert_eq!(lists(NamePolicy::Once), [ReportSection::Bindings]);
    assert_eq!(lists(NamePolicy::Always), [ReportSection::Bindings]);
    let again = format!("Let $m = 4.0\\ \\text{{kg}}$ first. {text}");
    let options = CheckOptions::default();
    assert_eq!(proofread(&again, TextFormat::Markdown, options).expect("it is read").findings, []);
}
