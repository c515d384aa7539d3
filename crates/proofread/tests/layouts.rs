//! Where equations stand side by side, in columns or in rows, and which of them belong together: right ones that must not be listed, beside
//! wrong ones that must.

use crate::unusual::{listed, unlisted};
use crate::{assert_told_apart, cnxml, on_numbers, pretext, report};
use proofread::{ReportSection, TextFormat};

/// A table in MathML, its rows from cells between `|`: numbers, signs, and words in quotes.
pub(crate) fn table(rows: &[&str]) -> String {
    let cell = |cell: &str| {
        let parts = cell.split_whitespace().map(|part| match part {
            "=" | "−" | "+" | "≠" | "(" | ")" | "·" => format!("<m:mo>{part}</m:mo>"),
            part if part.starts_with('\'') => format!("<m:mtext>{}</m:mtext>", part.trim_matches('\'')),
            part => match part.split_once('/') {
                Some((above, below)) => format!("<m:mfrac><m:mn>{above}</m:mn><m:mn>{below}</m:mn></m:mfrac>"),
                None => format!("<m:mn>{part}</m:mn>"),
            },
        });
        format!("<m:mtd>{}</m:mtd>", parts.collect::<String>())
    };
    let row = |row: &&str| format!("<m:mtr>{}</m:mtr>", row.split('|').map(cell).collect::<String>());
    let rows: String = rows.iter().map(row).collect();
    cnxml(&format!("<m:math><m:mtable>{rows}</m:mtable></m:math>"))
}

#[test]
fn cells_with_an_equation_of_their_own_stand_apart() {
    for right in [
        table(&["0.2|=|1/5|||0.2 'is' 'one' 'fifth'"]),
        table(&["7 ( −2 )|=|−14|||( −7 ) ( −2 )|=|14"]),
        table(&["3 · 3|=|9 − 1/3|5 · 5|=|25 − 1/5", "8|=|9 − 1|24|=|25 − 1", "|=|16/2||=|48/2"]),
        table(&["3 + 4|=|7|'so'|7 + 1|=|8"]),
        table(&["2|·|3|=|6|+|0"]),
        table(&["3 · 6 = 18||3 ( −6 ) = −18", "− 3 ( 6 ) = −18||( −3 ) ( −6 ) = 18"]),
    ] {
        // The third one says other things in its first row, so only what goes on below counts.
        let listed: Vec<String> = { report(&right, TextFormat::Xml).findings.into_iter() }
            .filter(|of| of.section == ReportSection::Numbers)
            .map(|of| format!("{} | {}", of.left, of.right))
            .filter(|of| !of.starts_with("3·3") && !of.starts_with("5·5"))
            .collect();
        assert_eq!(listed, [""; 0], "{right}");
    }
    listed(
        TextFormat::Xml,
        &[
            &table(&["3 · 6 = 18||3 ( −6 ) = −18", "− 3 ( 6 ) = −19||( −3 ) ( −6 ) = 18"]),
            &table(&["3 · 6 = 18||3 ( −6 ) = −18", "− 3 ( 6 ) = −18||( −3 ) ( −6 ) = 19"]),
            &table(&["3 · 3|=|8|||5 · 5|=|25"]),
            &table(&["3 · 3|=|9|||5 · 5|=|24"]),
            &table(&["3|·|4|=|13"]),
        ],
    );
    unlisted(
        TextFormat::Markdown,
        &[
            "$$\n\\begin{array}{c|c|c}\n3 & \\frac{3.5-3}{2}=\\frac{1}{4} & (1-\\frac{1}{4})(1)=\\frac{3}{4} \\\\\n\\end{array}\n$$",
            r"$\begin{aligned} 3\cdot 4 = 12 & 5\cdot 6 = 30\end{aligned}$",
            "12 = 5 + 7\t\t30 = 13 + 17\t\t50 = 19 + 31",
            "Group | Log | Value\n:---: | :---: | ---\nHigh | 2.512 | exp(2.512) = 12.33\nLow | 2.512 + 0.021 = 2.533 | exp(2.533) = 12.59",
        ],
    );
    listed(
        TextFormat::Markdown,
        &[
            "$$\n\\begin{array}{c|c|c}\n3 & \\frac{3.5-3}{2}=\\frac{1}{3} & (1-\\frac{1}{4})(1)=\\frac{3}{4} \\\\\n\\end{array}\n$$",
            r"$\begin{aligned} 3\cdot 4 & = 13\end{aligned}$",
            r"$\begin{aligned} 3\cdot 4 = 12 & + 5 \cdot 6 = 42 + 1\end{aligned}$",
            "112 = 100 + 12\t\t130 = 30 + 101\t\t50 = 19 + 31",
            "Group | Log | Value\n:---: | :---: | ---\nLow | 2.512 + 0.021 = 2.633 | exp(2.533) = 12.59",
        ],
    );
}

#[test]
fn a_gap_may_part_two_equations() {
    let gap = |left: &str, right: &str| {
        cnxml(&format!(
            "<m:math><m:mn>12</m:mn><m:mo>/</m:mo><m:mn>24</m:mn><m:mo>=</m:mo>{left}<m:mspace width=\"0.5em\"/><m:mn>9</m:mn>\
             <m:mo>/</m:mo><m:mn>12</m:mn><m:mo>=</m:mo>{right}</m:math>"
        ))
    };
    let fraction = |above: u8, below: u8| format!("<m:mfrac><m:mn>{above}</m:mn><m:mn>{below}</m:mn></m:mfrac>");
    unlisted(TextFormat::Xml, &[&gap(&fraction(1, 2), &fraction(3, 4))]);
    listed(TextFormat::Xml, &[&gap(&fraction(1, 2), &fraction(2, 4)), &gap(&fraction(1, 3), &fraction(3, 4))]);
    let entries = |value: &str| {
        format!(
            "<document><table><row><entry>Solve.</entry>\n<entry><math><mi>y</mi><mo>=</mo><mo>−</mo><mfrac><mn>7</mn><mn>2</mn></mfrac>\
             </math></entry>\n<entry><math><mi>y</mi><mo>=</mo><mn>{value}</mn></math></entry></row></table></document>"
        )
    };
    unlisted(TextFormat::Xml, &[&entries("4")]);
}

#[test]
fn columns_of_alignat_belong_to_their_rows() {
    unlisted(
        TextFormat::Latex,
        &[
            "\\begin{alignat*}{7}\n\\cos(0)&=1 &&\\implies &\\sec(0)&=1\n\\\\\n\\sin(0)&=0 &&\\implies &\\tan(0)&=0\n\\end{alignat*}",
            "\\begin{alignat*}{3}\ng(x)&\\approx g(a) &\n &&&=2\\\\\ng(x)&\\approx g(a)+g'(a)(x-a) &\n &=2+3\\tfrac{\\pi}{100} &\n &=2.094248\n\\end{alignat*}",
        ],
    );
    listed(TextFormat::Latex, &["\\begin{alignat*}{7}\n3\\cdot 4&=13 &&\\implies &5\\cdot 6&=30\n\\end{alignat*}"]);
}

#[test]
fn relations_may_have_columns_of_their_own() {
    let rows = r"$$\begin{array}{cccccc} (0.9)^{2} &=& 0.81 &(1.1)^{2} &=& 1.21\\ (0.9)^{3} &=& 0.729 &(1.1)^{3} &=& 1.331 \end{array}$$";
    unlisted(TextFormat::Markdown, &[rows]);
    listed(TextFormat::Markdown, &[&rows.replace("1.331", "1.332"), &rows.replace("0.81", "0.91")]);
    unlisted(TextFormat::Markdown, &[r"\begin{eqnarray*} x &=& 3\cdot4\\ &=& 12 \end{eqnarray*}"]);
    listed(TextFormat::Markdown, &[r"$$\begin{array}{rcl} x &=& 3\cdot4\\ &=& 13 \end{array}$$"]);
}

#[test]
fn lines_with_empty_right_sides_are_to_be_filled_in() {
    let sheet = r"<me>\begin{aligned} 12 + 31 \amp = \\ 45 - 18 \amp = \\ -7 + 22 \amp = \end{aligned}</me>";
    unlisted(TextFormat::Xml, &[&pretext(sheet)]);
    let chain = r"$$\begin{aligned} 3(4+5) = \\ 3\cdot9 = \\ 27 \end{aligned}$$";
    unlisted(TextFormat::Markdown, &[chain]);
    listed(TextFormat::Markdown, &[&chain.replace("27", "28"), &chain.replace("9", "8")]);
}

#[test]
fn a_comma_with_space_before_a_further_equation_parts_a_list() {
    let list = r"$390 = 6^2 + 354, 52 = 7^2 + 3, 124=11^2 + 3$";
    unlisted(TextFormat::Latex, &[list]);
    listed(TextFormat::Latex, &[&list.replace("390", "391")]);
}

#[test]
fn a_sum_may_go_on_over_several_formulas() {
    let sum = "<m>12+15+18</m></p><p><m>+20+25</m></p><p><m>+30+10 = 130</m>";
    unlisted(TextFormat::Xml, &[&pretext(sum)]);
    listed(TextFormat::Xml, &[&pretext("The sum is <m>+30+10 = 130</m>.")]);
}

#[test]
fn the_first_part_of_a_line_may_be_outside_the_formula() {
    unlisted(TextFormat::Latex, &[r"slope is tan $45^\circ = 1$"]);
    listed(TextFormat::Latex, &[r"slope is $\tan 45^\circ = 2$"]);
    unlisted(TextFormat::Plain, &["About 80% of the rated current (2.00 A) = 1.6 A"]);
}

#[test]
fn what_stands_before_a_line_shows_that_it_is_torn_off() {
    unlisted(
        TextFormat::Markdown,
        &[
            "| Execute | valE <- 40 + 8 = 48 |",
            "The index (1990–92 = 100) was 87.3 in May.",
            "The index (1982-84 = 100) was 87.3 in May.",
            "Ex: A = -0.0305 (column 2) Exp(-0.0305) = 0.970",
            "The value (P(Chi-squared) > 1.25 = 0.535) is large.",
            "if REGA.6=1",
        ],
    );
    unlisted(TextFormat::Html, &[r#"<div data-type="equation">(1/3) \times (1/3) = 1/9</div>"#]);
    listed(TextFormat::Markdown, &["It is 40 + 8 = 49.", "1990 - 92 = 1998"]);
}

#[test]
fn solutions_side_by_side_are_read_down() {
    let rows = |last: &str| {
        let starts = r"<mrow>\amp 6 + 8 \div 2 \times 2 \amp \amp 6 + 8 + 2 \times 2</mrow>";
        let steps = r"<mrow>\amp = 6 + 4 \times 2 \amp \amp = 6 + 8 + 4</mrow>";
        format!(r"<p><md>{starts}{steps}<mrow>\amp = 14 \amp \amp = {last}</mrow></md></p>")
    };
    assert_told_apart(&rows("18"), &rows("17"), TextFormat::Xml);
}

#[test]
fn spaces_part_equations_of_a_row() {
    let row = |third: &str| {
        format!(
            r"$\binom{{4}}{{0}} = 1 \;\; \binom{{4}}{{1}} = 4 \;\; \binom{{4}}{{2}} = {third} \;\; \binom{{4}}{{3}} = 4$"
        )
    };
    assert_told_apart(&row("6"), &row("7"), TextFormat::Latex);
}

#[test]
fn a_word_for_and_parts_equations() {
    for and in ["und", "et", "och", "и"] {
        let pair = |first: &str| format!(r"$2+2={first} \text{{ {and} }} v=3$");
        assert_told_apart(&pair("4"), &pair("5"), TextFormat::Latex);
    }
}

#[test]
fn a_time_may_begin_in_the_formula_before() {
    let time = |and: &str| format!(r"$2\,min$ {and} $15\,sec=135\,s$");
    for and in ["and", "et", "und"] {
        assert_told_apart(&time(and), r"It is $15\,sec=135\,s$", TextFormat::Markdown);
    }
}

#[test]
fn conditions_and_sets_end_a_statement() {
    for behind in [
        r"\text{ für } n = 3",
        r"\text{ falls } n = 3",
        r"\text{ pour } n = 3",
        r"\text{ para } n = 3",
        r"\in \mathbb{N}",
        r"\in \{1, 6\}",
        r"\notin \{1, 5\}",
    ] {
        let text = |product: &str| format!(r"$2 \cdot 3 = {product} {behind}$");
        assert_told_apart(&text("6"), &text("7"), TextFormat::Latex);
    }
}

#[test]
fn a_column_of_words_parts_equations_side_by_side() {
    let rows = |last: &str| {
        format!(
            r"$$\begin{{align*}} x &= 6 \cdot 2.5 && \text{{and}} & y &= 6 \cdot (-3)\\ &= 15.0 &&&& = {last} \end{{align*}}$$"
        )
    };
    for format in [TextFormat::Latex, TextFormat::Markdown] {
        assert_told_apart(&rows("-18"), &rows("-17"), format);
        let without = |last: &str| rows(last).replace(r"\text{and} &", "").replace("&&&&", "&&&");
        assert_told_apart(&without("-18"), &without("-17"), format);
    }
}

#[test]
fn cells_that_begin_with_an_approximation_are_apart() {
    let row = |sign: &str| {
        format!(
            r"\[ \begin{{array}}{{ccc}} f & {sign} 1.98 & {sign} 2.71 \\ g & {sign} 3.98 & {sign} 4.71 \end{{array}} \]"
        )
    };
    assert_eq!(on_numbers(&row(r"\approx"), TextFormat::Latex), 0);
    assert_ne!(
        on_numbers(r"\[ \begin{array}{cc} f & \approx 1.98 + 1 \\ & \approx 4.71 \end{array} \]", TextFormat::Latex),
        0
    );
}

#[test]
fn a_row_below_two_solutions_is_another_one() {
    let rows = |or: &str| format!("$$\\begin{{aligned}} x &= 2 + 3 {or} x = 2 - 3 \\\\ &= 5 \\quad \\end{{aligned}}$$");
    assert_eq!(on_numbers(&rows("\\quad \\text{or} \\quad"), TextFormat::Markdown), 0);
    assert_ne!(on_numbers("$$\\begin{aligned} x &= 2 - 3 \\\\ &= 5 \\end{aligned}$$", TextFormat::Markdown), 0);
}

#[test]
fn columns_of_equations_may_end_with_other_signs() {
    let check = |sum: &str| {
        pretext(&format!(
            "<md><mrow>(2 + 3)(2 - 4) \\amp= {sum} \\amp (6 + 3)(6 - 4) \\amp= 18</mrow><mrow>5(-2) \\amp\\lt 2 \\amp (9)(2) \\amp\\gt 2</mrow></md>"
        ))
    };
    assert_told_apart(&check("-10"), &check("-12"), TextFormat::Xml);
}

#[test]
fn blanks_part_equations_in_a_line() {
    let rows = |last: &str| format!("- 2  = 2¹ × 5⁰\n- 4  = 2² × 5⁰     5 = 2⁰ × 5¹\n- 6 + 2 = 8    10 - 3 = {last}\n");
    assert_told_apart(&rows("7"), &rows("8"), TextFormat::Markdown);
}

#[test]
fn items_of_a_list_are_solutions_of_their_own() {
    let list =
        |between: &str| pretext(&format!("<ul><li><p><m>x = 2 + 3</m></p>{between}<p><m>x = 6</m></p></li></ul>"));
    assert_told_apart(&list("</li><li>"), &pretext("<m>x = 2 + 3</m>, thus <m>x = 6</m>"), TextFormat::Xml);
}

#[test]
fn a_comment_in_a_formula_is_none_of_it() {
    let sum = |sum: &str| pretext(&format!("<me>2 + 3 <!-- = five --> = {sum}</me>"));
    assert_told_apart(&sum("5"), &sum("6"), TextFormat::Xml);
}

#[test]
fn a_line_of_its_own_is_a_whole_formula() {
    let line = |power: &str| format!("We count them:\n\n30,000 = 3 × 10^{power}\n\nThat is a lot.");
    assert_told_apart(&line("4"), &line("3"), TextFormat::Markdown);
}
