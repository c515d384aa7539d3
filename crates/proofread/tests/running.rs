//! The running text of pages in HTML: what is shown as one formula is read as one, and what is cut out of a line is no part of it.

use crate::{on_numbers, report, unusual, wrong};
use proofread::{CheckOptions, LineIndex, ReportSection, TextFormat, proofread};

/// How many chains of a page are compared.
fn checked(page: &str) -> usize {
    report(page, TextFormat::Html).tally.checked
}

#[test]
fn what_is_shown_as_a_formula_is_read_as_one() {
    for (right, is, instead) in [
        ("<p>R = V/I = 9.0 V / 3.0 A = 3.0 &Omega;</p>", "3.0 &", "4.0 &"),
        ("<li>E = 5 &times; 10<sup>3</sup> J + 10<sup>3</sup> J = 6 &times; 10<sup>3</sup> J", "6 &", "7 &"),
        ("<td>U<sub>rms</sub> = 2.0 V + 2.0&nbsp;V = <b>4.0</b> V<td>", "4.0", "5.0"),
        ("<h2>v = 5 m s<sup>&minus;1</sup> &#215; 2 = 10 m s<sup>-1</sup></h2>", "= 10", "= 12"),
        ("<dd>cos 60<sup>o</sup> = 0.50", "0.50", "0.60"),
        ("<p>m =<br>2 kg + 2 kg = 4 kg<br/>n = 3</p>", "4 kg", "5 kg"),
        ("<p>It is 20\n  + <span>2</span>0 =\n4<i>0</i>, as <!-- 1 = 2 --> we see.</p>", "4<", "5<"),
        ("<p>For a &lt; b it is 2 + 2 = 4.<sup>[3]</sup></p>", "4.", "5."),
        ("<P>x<SCRIPT>if (a<b) y = '2 + 2 = 7'</SCRIPT><P>2 + 2 = 4", "= 4", "= 5"),
        ("<p>\\(a\\) is &pi; &middot; 2.00 cm = 6.28 cm", "6.28", "6.38"),
    ] {
        let false_one = right.replace(is, instead);
        assert_ne!(right, false_one);
        assert_eq!(wrong(right, TextFormat::Html), [""; 0], "{right}");
        assert_eq!(checked(right), 1, "{right}");
        assert_eq!(wrong(&false_one, TextFormat::Html).len(), 1, "{false_one}");
        assert_eq!(checked(&right.replace("<p>", "<para>")), 1, "blocks of any name");
        assert_eq!(wrong(&false_one, TextFormat::Xml).len(), 1, "in other languages of XML, too: {false_one}");
    }
}

#[test]
fn what_is_cut_out_or_apart_is_no_side() {
    for (page, shown) in [
        ("<pre>2 + 2 = 5</pre>", "<div>2 + 2 = 5</div>"),
        ("<nav>2 + 2 = 5</nav>", "<th>2 + 2 = 5</th>"),
        ("<title>2 + 2 = 5</title>", "<h1>2 + 2 = 5</h1>"),
        ("<p><code>2 + 2 = 5</code>", "<p><tt>2 + 2 = 5</tt>"),
        ("<p><s>2 <span>+</span> 2 = 5</s>", "<p><ins>2 <span>+</span> 2 = 5</ins>"),
        ("<p>3 + <code>x</code> 2 = 2", "<p>3 + <em></em> 2 = 2"),
        ("<p>3 + <img src=x.png> 2 = 2", "<p>3 + <wbr> 2 = 2"),
        ("<p>2 + 2 = 5<input>", "<p>2 + 2 = 5<wbr>"),
        ("<p>x <math><mn>3</mn></math> + 4 + 2 = 3", "<p>x = 4 + 2 = 3"),
        ("<p>\\(3\\) + 4 + 2 = 3", "<p>4 + 2 = 3"),
        ("<p>Here $2 + 2 = 5$ is TeX", "<p>Here 2 + 2 = 5 is none"),
        ("<tr><td>2 + 2<td>= 5</tr>", "<tr><td>2 + 2 = 5</tr>"),
        ("<p>2 + 2</p><p>= 5</p>", "<p>2 + 2<wbr> = 5</p>"),
        ("<p>1010<sub>2</sub> = 5 + 6", "<p>1010 = 5 + 6"),
        ("<p>3<sup>1</sup>/<sub>2</sub> = 7.00", "<p>3<sup>1</sup>/2 = 7.00"),
        ("<p>R = 2 <font face=Symbol>W</font> + 2 W = 5 W", "<p>R = 2 <font face=Arial>W</font> + 2 W = 5 W"),
        ("<p>R = <u>9 V</u> <br>2 A = 4.4 W", "<p>R = <u>9 V</u>, so<br>2 A = 4.4 W"),
        ("<p>2 + 2 = 4<sup><a href=#n>3</a></sup>", "<p>2 + 2 = 4<sup>3</sup>"),
        ("<p>It is 2 + 2 = 5<sup>th</sup>", "<p>It is 2 + 2 = 5<sup>1</sup>"),
        (
            "<p><span class=katex><span>10</span><span>3</span> + 1 = 1001</span>",
            "<p><span>10<span>3</span> + 1 = 1001</span>",
        ),
        ("<p><b aria-hidden=true>2 + <b>2</b> = 5</b>", "<p><b aria-hidden=false>2 + <b>2</b> = 5</b>"),
        (
            "<p>y = <span class=\"x frac\"><i>9</i><i>3</i></span> + 1 = 4",
            "<p>y = <span class=x><i>9</i><i>3</i></span> + 1 = 4",
        ),
        (
            "<p>c = √<span style='text-decoration: overline'>3² + 4²</span> = √<i>26</i>",
            "<p>c = √<span style='color: red'>(3² + 4²)</span> = √<i>26</i>",
        ),
        ("<p>3 + 4 = 5 × 2</p><p>/ 7 = 2", "<p>3 + 4 = 5 × 2</p><p>7 = 2"),
    ] {
        assert_eq!(listed(page), 0, "{page}");
        assert_eq!(listed(shown), 1, "{shown}");
    }
}

#[test]
fn words_for_an_operation_belong_to_the_number_behind_them() {
    let root = "<p>The square root of (100 &middot; 300) = 173 is meant.</p>";
    assert_eq!(listed(root), 0);
    assert_eq!(listed(&root.replace("square root", "number")), 1);
}

/// How many differences of a page are listed, and not set aside.
fn listed(page: &str) -> usize {
    let findings = report(page, TextFormat::Html).findings;
    findings.iter().filter(|of| !matches!(of.section, ReportSection::Agreeing | ReportSection::Doubts)).count()
}

#[test]
fn what_is_found_is_where_the_page_has_it() {
    let page = "<p>Ω &amp; so\non</p>\n<p>é <b>R</b><sub>1</sub> = 9.0&nbsp;V&thinsp;/\n  3.0 A = <i>4.0</i> &Omega;, and <math><mn>1</mn><mo>+</mo>\
                <mn>1</mn><mo>=</mo><mn>3</mn></math>, 2 &times; 10<sup>3</sup> + 1 = 7</p>";
    let findings = proofread(page, TextFormat::Html, CheckOptions::default()).expect("it is read").findings;
    let found: Vec<_> = findings.iter().map(|of| &page[of.at.range()]).collect();
    assert_eq!(found, ["4.0</i> &Omega;", "3", "7"]);
    let Some(first) = findings.first() else { panic!("nothing is found") };
    let [start, end] = LineIndex::new(page).line_columns(first.at);
    assert_eq!([start.line, start.column, end.line, end.column], [4, 14, 4, 29]);
    assert_eq!(&page[first.left_span.range()], "9.0&nbsp;V&thinsp;/\n  3.0 A");
    assert_eq!(first.hint.as_ref().map(|hint| &page[hint.at.range()]), Some("4.0"));
    assert_eq!(&page[findings[2].left_span.range()], "2 &times; 10<sup>3</sup> + 1");
}

#[test]
fn running_text_is_read_as_it_is_shown() {
    unusual::unlisted(
        TextFormat::Markdown,
        &[
            "Here 2 atm = 202.65 kPa = 1520 mm Hg.",
            "The scale: 1 unit = 20 <b>÷</b> 80 = 0.25 µm.",
            "The probability is 2/5 &times; 7/24 = 7/60. The area is 0.6 &times; 0.3 = 0.18.",
            "There are 9<sup>4</sup> = 6,561.",
        ],
    );
    unusual::listed(
        TextFormat::Markdown,
        &[
            "Here 2 atm = 202.65 kPa = 1620 mm Hg.",
            "The scale: 1 unit = 20 <b>÷</b> 80 = 0.35 µm.",
            "The probability is 2/5 &times; 7/24 = 7/61.",
            "There are 9<sup>4</sup> = 262,144.",
            "The rest is 19 (70 - 52 = 19). Next.",
        ],
    );
    let cell = r#"{"cells": [{"cell_type": "markdown", "metadata": {}, "source": ["It is 2/5 &times; 7/24 = 7/60.\n"]}], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}"#;
    unusual::unlisted(TextFormat::Notebook, &[cell]);
    unusual::listed(TextFormat::Notebook, &[&cell.replace("7/60", "7/61")]);
    unusual::unlisted(
        TextFormat::Plain,
        &[
            "The rest is 18 (70 - 52 = 18).",
            "So P (X = 2) = 0.3 and f(x = 3) = 9.",
            "Codes (1 = yes, 2 = no) and 3 (= 1 + 2).",
        ],
    );
    unusual::listed(TextFormat::Plain, &["The rest (70 - 52 = 19) is here."]);
    unusual::listed(TextFormat::Html, &["<p>The rest (70 - 52 = 19) is here.</p>"]);
    unusual::listed(
        TextFormat::Latex,
        &["The rest (70 - 52 = 19) is here.", r"so the point $(x=\log_2 2^3=3, y=3\cdot 4 = 13)$ is"],
    );
}

#[test]
fn running_text_is_read_in_any_language_of_xml() {
    for text in ["<para>We need 252×16 = 4042 of them.</para>", "<p>So 2*3=7 joules <me>x</me></p>"] {
        assert_ne!(on_numbers(text, TextFormat::Xml), 0, "{text}");
    }
    for text in
        ["<para>We need 252×16 = 4032 of them.</para>", "<p><m>x</m> and <c>2*3=7</c> <program>2*3=7</program></p>"]
    {
        assert_eq!(on_numbers(text, TextFormat::Xml), 0, "{text}");
    }
}
