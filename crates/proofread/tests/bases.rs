//! Numbers in other bases and bits: right chains that must not be listed, beside wrong ones that must.

use crate::unusual::{listed, unlisted};
use crate::{assert_told_apart, on_numbers, pretext};
use proofread::TextFormat;

#[test]
fn a_subscript_may_be_a_base() {
    unlisted(
        TextFormat::Markdown,
        &[r"$1101_2 = 13_{10}$", r"$327_8 = 3\times 8^2 + 2 \times 8 + 7$", r"$101_{\text{two}} = 5$"],
    );
    listed(
        TextFormat::Markdown,
        &[r"$1101_2 = 14_{10}$", r"$327_8 = 3\times 8^2 + 2 \times 8 + 8$", r"$101_{\text{two}} = 6$"],
    );
}

#[test]
fn digits_in_another_base_may_stand_in_groups() {
    let chain = "<m>75_{10} = 100 1011_2 = 2210_3 = 300_5</m>";
    let long = "<m>2012_{10} = 111 1101 1100_2 = 220 2112_3 = 3 1022_5 = 7D\\text{C}_{16}</m>";
    unlisted(TextFormat::Xml, &[&pretext(chain), &pretext(long), &pretext("<m>64_{10} = 100 0000_2 = 40_{16}</m>")]);
    listed(
        TextFormat::Xml,
        &[
            &pretext(&chain.replace("1011", "1010")),
            &pretext(&long.replace("2112", "2111")),
            &pretext("<m>64_{10} = 100 0000_2 = 41_{16}</m>"),
        ],
    );
}

#[test]
fn numbers_of_computing_are_powers_of_two() {
    unlisted(
        TextFormat::Markdown,
        &[
            "In binary we write 0.10 + 0.10 = 1.00 for two halves.",
            "$1.0110*2^0=1.375$",
            "For the 5-bit twos complement numbers $x = -7 = 11001_2$ we have",
            "$1011_2=(10)(11)=(2)(3)=23_4$",
            "So 2^14 = 16K and 2^44 = 16T.",
            "There are 2^16 - 1 = 64K - 1 of them.",
        ],
    );
    listed(TextFormat::Markdown, &["$1.0110*2^0=1.475$", "So 2^14 = 17K.", "0.10 + 0.10 = 1.10"]);
}

#[test]
fn a_sentence_may_name_the_base_of_its_numbers() {
    let thirds = r"\[ \frac13 = 0.1 = 0.0\overline{2} \]";
    let with = |words: &str| format!("Numbers are written {words}: {thirds}");
    assert_told_apart(&with("with respect to basis $3$"), &with("as usual"), TextFormat::Latex);
    assert_ne!(on_numbers(&with("in a basis of the space"), TextFormat::Latex), 0);
}

#[test]
fn bits_have_an_exclusive_or() {
    let text = |words: &str| format!("Mit {words} wird umgeschaltet: für r=1 gilt 1^1=0 und sonst 0^1=1.");
    assert_told_apart(&text("XOR"), &text("Potenzen"), TextFormat::Markdown);
    assert_told_apart("- boolesch: $1+1=1$", "- hier: $1+1=1$", TextFormat::Markdown);
}

#[test]
fn bits_have_their_own_sums_and_signs() {
    let field = |sign: &str| format!("Die Nullstellen in {sign}: $1^2+1+1 = 1 + 0$.");
    assert_told_apart(&field("𝔽_2"), &field("𝔽_3"), TextFormat::Latex);
    let element = "<msub><mi>𝔽</mi><mn>2</mn></msub>";
    assert_told_apart(&field(element), &field(&element.replace('2', "3")), TextFormat::Latex);
    let item = |words: &str| format!("- 10 - 11 = 1 {words}: When subtracting");
    assert_told_apart(&item("with a borrow"), &item("in all"), TextFormat::Markdown);
    assert_told_apart("$1000_2 = -8_{10}$", "$1000_2 = -7_{10}$", TextFormat::Markdown);
}

#[test]
fn digits_may_be_bits_where_the_section_speaks_of_them() {
    let rule =
        |sum: &str| format!("Addition works similarly in binary. With the rules being:\n* $0+1=1$\n* $1+1= {sum}$");
    assert_told_apart(&rule("10"), &rule("11"), TextFormat::Markdown);
    let sum =
        |words: &str, sum: &str| format!("{words}. So $0.11 \\cdot 2^1 + 1.101 \\cdot 2^1 = {sum} \\cdot 2^1$ is it.");
    assert_told_apart(
        &sum("The mantissa has four bits", "10.011"),
        &sum("The mantissa has four bits", "10.111"),
        TextFormat::Latex,
    );
    assert_ne!(on_numbers(&sum("Two numbers are added", "10.011"), TextFormat::Latex), 0);
    let half = |digits: &str| format!("# Binary fractions\n\nHalf is 0.5 = 2^(-1) = {digits}\n");
    assert_told_apart(&half("0.1"), &half("0.01"), TextFormat::Markdown);
    // More bits than are printed are lost.
    let borrowed = |result: &str| format!("These are binary digits. We go on. Now $10 - 11 = {result}$.");
    assert_told_apart(&borrowed("11"), &borrowed("10"), TextFormat::Markdown);
}

#[test]
fn what_overflows_differs_by_a_power_of_two() {
    let item = |sum: &str| format!("- **Two's complement, four bits**: ${sum}$.");
    assert_told_apart(&item("7 + 3 = -6"), &item("7 + 3 = -5"), TextFormat::Markdown);
    assert_told_apart(&item("4 - 16 = -12"), &item("4 - 16 = -10"), TextFormat::Markdown);
    assert_eq!(on_numbers(&item("1010 + 1 = 1011 = 0110"), TextFormat::Markdown), 0);
}

#[test]
fn words_of_a_code_are_added_bit_by_bit() {
    let column = |bits: [u8; 3]| {
        let [a, b, c] = bits;
        format!(r"\begin{{pmatrix}} {a} \\ {b} \\ {c} \end{{pmatrix}}")
    };
    let sum = |words: &str, result: [u8; 3]| {
        format!("{words}:\n$${} + {} = {}$$", column([1, 0, 1]), column([1, 1, 0]), column(result))
    };
    let code = "The distance of this linear code is";
    assert_told_apart(&sum(code, [0, 1, 1]), &sum(code, [0, 0, 1]), TextFormat::Markdown);
    assert_ne!(on_numbers(&sum("The sum of the forces is", [0, 1, 1]), TextFormat::Markdown), 0);
}

#[test]
fn truth_values_add_to_one() {
    let axiom = |words: &str, sum: &str| format!("{words}. They follow here. One is this. $1 + 1 = {sum}$ is another.");
    let of_boole = "Axioms of Boolean algebra";
    assert_told_apart(&axiom(of_boole, "1"), &axiom(of_boole, "3"), TextFormat::Latex);
    assert_ne!(on_numbers(&axiom("Axioms of numbers", "1"), TextFormat::Latex), 0);
    let sum = |words: &str| format!("We use {words}. The answer is below. It is this. \\[ 0+1+0+1+0+1+0 = 1 \\]");
    assert_told_apart(&sum("arithmetic mod 2"), &sum("arithmetic"), TextFormat::Latex);
}

#[test]
fn a_shift_of_bits_is_no_order_of_magnitude() {
    unlisted(TextFormat::Latex, &[r"Here $14 \ll 3 + 3 = 115$ and $9 \ll 2 + 1 = 37$.", r"Here $40 \gg 3 = 5$."]);
    listed(TextFormat::Latex, &[r"Here $14 \ll 3 + 3 = 116$.", r"Here $14 < 3 + 3 = 115$."]);
    assert_told_apart("Here 14 << 3 + 3 = 115 it is.", "Here 14 << 3 + 3 = 113 it is.", TextFormat::Markdown);
}
