//! What a text denies, asks or calls false is no assertion of it; without such words it is listed.

use crate::layouts::table;
use crate::unusual::{listed, unlisted};
use crate::{assert_told_apart, pretext};
use proofread::TextFormat;

#[test]
fn a_row_that_is_denied_denies_those_above() {
    let check = |last: &str| {
        format!(
            "<section><md><mrow>\\sqrt{{9+7}} \\amp = -4</mrow><mrow>\\sqrt{{16}} \\amp = -4</mrow><mrow>4 \\amp = -4{last}</mrow></md></section>"
        )
    };
    unlisted(TextFormat::Xml, &[&check(r" \qquad \text{which is false}")]);
    listed(TextFormat::Xml, &[&check("")]);
    unlisted(TextFormat::Xml, &[&table(&["3 · 4|=|5 − 7", "12|≠|−2"])]);
    listed(TextFormat::Xml, &[&table(&["3 · 4|=|5 − 7", "12|=|−2"])]);
    unlisted(
        TextFormat::Markdown,
        &[
            r"$9 \cancel{=} 81^2$, so $(81, 9) \notin R$",
            "Use parentheses to make the following statements true.\n\n1. $4 + 3^2 \\cdot 5 = 65$",
        ],
    );
    listed(TextFormat::Markdown, &["Here are sums.\n\n1. $4 + 3^2 \\cdot 5 = 65$"]);
}

#[test]
fn statements_with_their_answer_behind_are_not_asserted() {
    let item = r"(c) $540^\circ = 2\pi\textsf{ rad}$  Answer: `r torf(FALSE)`.";
    unlisted(
        TextFormat::Markdown,
        &[item, r#"(d) $6-2=3$. Answer: `r mcq(c(answer ="proposition", "none"))`."#, "(e) $6-2=3$. Answer: false."],
    );
    listed(TextFormat::Markdown, &[&item.replace("FALSE", "TRUE"), "(e) $6-2=3$. The answer follows."]);
    let implication = "If <m>1+4=9</m>, then <m>1+6=11</m>.";
    unlisted(TextFormat::Xml, &[&pretext(implication), &pretext("Check the presentation for errors. <me>1+4=9</me>")]);
    listed(TextFormat::Xml, &[&pretext("If we add, then <m>1+6=11</m>."), &pretext("Check: <me>1+4=9</me>")]);
}

#[test]
fn a_contradiction_is_of_what_stands_beside_it() {
    unlisted(
        TextFormat::Latex,
        &["Hence $5 + 1 = 7$, a contradiction.", "We get $5 + 1 = 7$, which is a contradiction."],
    );
    listed(
        TextFormat::Latex,
        &[
            "Hence the group has at least $1210 + 1344 = 2544$ elements, a contradiction.",
            r"But $1210 + 1344 = 2544 > 2000$, a contradiction.",
        ],
    );
}

#[test]
fn empty_brackets_ask_whether_a_formula_holds() {
    let item = |mark: &str| format!("\\item {mark} $13^7 \\cdot 13^9 = 13^8$");
    for mark in ["( )", "(\\quad)"] {
        assert_told_apart(&item(mark), &item("(a)"), TextFormat::Latex);
    }
}

#[test]
fn a_cross_denies_rows_that_begin_with_a_sign() {
    let row = |left: &str, right: &str| format!("<mtr><mtd>{left}</mtd><mtd><mo>=</mo></mtd><mtd>{right}</mtd></mtr>");
    let first = row("<mn>0</mn><mo>−</mo><mn>11</mn>", "<mn>12</mn>");
    let rows = |mark: &str| {
        let second = row("<mo>−</mo><mn>11</mn>", &format!("<mn>12</mn><mtext> {mark}</mtext>"));
        format!("<p><math><mtable>{first}{second}</mtable></math></p>")
    };
    assert_told_apart(&rows("✗"), &rows(""), TextFormat::Html);
}

#[test]
fn a_text_calls_a_formula_false() {
    for [right, wrong, format] in [
        ["we obtain the false statement <q><m>2^2 - 3 = 0</m>.</q>", "we obtain <q><m>2^2 - 3 = 0</m>.</q>", "xml"],
        ["<p>since <m>3 + 7 = 11</m> is a not a true equation.</p>", "<p>since <m>3 + 7 = 11</m> is one.</p>", "xml"],
        ["<p>Plug in: <m>1 + 0 = 0 + 4</m>, impossible.</p>", "<p>Plug in: <m>1 + 0 = 0 + 4</m>, possible.</p>", "xml"],
        [
            "<p>Which of the following are statements?</p> <m>3 + 4 = 8</m>.",
            "<p>Which of the following are sums?</p> <m>3 + 4 = 8</m>.",
            "xml",
        ],
        ["What is wrong with the following? \\item $3 + 5 = 9$", "Reckon the following. \\item $3 + 5 = 9$", "tex"],
        ["c) $3*6 = 6*(-3)$ (falsch) &", "c) $3*6 = 6*(-3)$ (wahr) &", "tex"],
        ["It is $3 + 4 = 8$ ✗", "It is $3 + 4 = 8$ ✓", "md"],
        ["It is $3 + 4 = 8$ Wrong!", "It is $3 + 4 = 8$ Wrong signs are often made.", "md"],
    ] {
        let format = TextFormat::from_extension(format).expect("a format");
        assert_told_apart(right, wrong, format);
    }
}

#[test]
fn a_display_below_may_say_that_a_root_is_none() {
    let check = |words: &str| {
        format!("-   For x=0:\n    $$ \\sqrt{{0+1}} = 0-1 $$\n    $$ 1 = -1 \\quad \\text{{({words})}} $$\n")
    };
    assert_told_apart(&check("False"), &check("Checked"), TextFormat::Markdown);
}
