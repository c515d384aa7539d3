//! Things and money that a chain counts are no obstacle to its numbers.

use crate::{report, wrong};
use proofread::{CheckOptions, TextFormat, proofread};

/// How many chains were compared, and how many of them are listed.
fn compared_and_listed(text: &str, format: TextFormat) -> (usize, usize) {
    let found = proofread(text, format, CheckOptions::default()).expect("it can be read");
    (found.tally.checked, found.findings.len())
}

#[test]
fn a_noun_behind_the_result_is_left_away() {
    for (right, wrong) in [
        ("We need 12 × 3.5 = 42 lamps.", "We need 12 × 3.5 = 43 lamps."),
        ("It takes 15+45+43 = 103 bytes in all.", "It takes 15+45+42 = 103 bytes in all."),
        (r"So $44-2 = 42 \text{ months}$.", r"So $44-2 = 43 \text{ months}$."),
        (r"So $5+4=9\text{ points}$.", r"So $5+3=9\text{ points}$."),
        (r"\[ 12 \times 3 \times 2 = 72\ \text{choices}. \]", r"\[ 12 \times 3 \times 2 = 73\ \text{choices}. \]"),
        (r"$6 \cdot 6 = 36\text{ different combinations}$", r"$6 \cdot 6 = 35\text{ different combinations}$"),
        ("Then 35 + 48 = 83 customers came.", "Then 35 + 48 = 93 customers came."),
        ("So (16*4+8) bytes = 72 bytes.", "So (16*4+8) bytes = 132 bytes."),
        (
            r"$3\text{ apples} + 4\text{ apples} = 7\text{ apples}$",
            r"$3\text{ apples} + 4\text{ apples} = 8\text{ apples}$",
        ),
        (r"$\frac{60\text{ eggs}}{4} = 15\text{ eggs}$", r"$\frac{60\text{ eggs}}{4} = 18\text{ eggs}$"),
    ] {
        assert_eq!(compared_and_listed(right, TextFormat::Markdown), (1, 0), "{right}");
        assert_eq!(compared_and_listed(wrong, TextFormat::Markdown), (1, 1), "{wrong}");
    }
}

#[test]
fn a_rate_a_remark_and_a_quantity_behind_the_result_are_left_away() {
    for (right, wrong) in [
        (r"Then $-40 + 25 = -15\text{ dBV}$.", r"Then $-40 + 25 = -19\text{ dBV}$."),
        (
            r"\[Q = \sqrt{S^2 - P^2} = \sqrt{50^2 - 30^2} = 40\text{ VAR}\]",
            r"\[Q = \sqrt{S^2 - P^2} = \sqrt{50^2 - 30^2} = 30\text{ VAR}\]",
        ),
        (
            r"$$\text{Bits of one frame} = 1 + 7 + 1 + 2 = 11\text{ bits}$$",
            r"$$\text{Bits of one frame} = 1 + 7 + 3 + 2 = 11\text{ bits}$$",
        ),
        (
            r"$\frac{4.1-5.3}{0.8} = -1.5\text{ standard deviations}$",
            r"$\frac{7.1-5.3}{0.8} = -1.5\text{ standard deviations}$",
        ),
        (r"$\$800.40(0.005) = \$4.00\text{ (rounded)}$", r"$\$800.40(0.205) = \$4.00\text{ (rounded)}$"),
        (r"$\frac{\$600}{8} = \$75\text{/member}$", r"$\frac{\$600}{8} = \$85\text{/member}$"),
        (r"$$\$\,900 - \$\,350 = \$\,550\text{ per year}$$", r"$$\$\,900 - \$\,350 = \$\,650\text{ per year}$$"),
    ] {
        assert_eq!(compared_and_listed(right, TextFormat::Markdown), (1, 0), "{right}");
        assert_eq!(compared_and_listed(wrong, TextFormat::Markdown), (1, 1), "{wrong}");
    }
    // Per month it is another number, and so it is of members out of many.
    for text in [
        r"$\frac{\$1200}{2} = \$50\text{ per month}$",
        r"$\$300 \cdot 12 = \$300\text{ per month}$",
        r"$20\% \cdot 50 = 12\text{ (rounded)}$",
    ] {
        assert_eq!(compared_and_listed(text, TextFormat::Markdown).1, 0, "{text}");
    }
}

#[test]
fn a_noun_that_may_count_something_else_stays() {
    for text in [
        "So 90 minutes = 1.5 movies.",
        "Here 5 = 5 apples and 3 = 4 apples.",
        "So 12 = 1 dozen and 8 + 4 = 1 dozen.",
        "So 4 × 64 = 32 bytes.",
        "Then 3 × 1000 = 3 kilobytes.",
        "So 7 + 7 = 2 pounds.",
        "We need 50/12 = 5 boxes.",
        "So 1/4 = 13 cards.",
        "Each gets 17 / 5 = 3 sweets.",
        r"$3 \times 8\text{ bits} = 3\text{ bytes}$",
        r"$20\% \cdot 50 = 12\text{ visitors}$",
        r"$1010 + 1 = 1012\text{ binary}$",
        r"$3\text{ boxes} + 4 = 8\text{ apples}$",
        r"$5\text{ apples} + 3 = 9$",
    ] {
        assert_eq!(compared_and_listed(text, TextFormat::Markdown).1, 0, "{text}");
    }
}

#[test]
fn sums_of_money_are_compared() {
    for (right, wrong) in [
        ("So 540 € + 756 € = 1296 €.", "So 540 € + 756 € = 1298 €."),
        ("So £540 + £756 = £1296.", "So £540 + £756 = £1298."),
        ("So 540 EUR + 756 EUR = 1296 EUR.", "So 540 EUR + 756 EUR = 1298 EUR."),
        ("So EUR 540 + EUR 756 = EUR 1296.", "So EUR 540 + EUR 756 = EUR 1298."),
        ("So 540 + 756 = 1,296 dollars.", "So 540 + 756 = 1,298 dollars."),
        ("So 3 × 12.50 = 37.50 euros.", "So 3 × 12.50 = 38.50 euros."),
        (r"$540\,\text{€} + 756\,\text{€} = 1296\,\text{€}$", r"$540\,\text{€} + 756\,\text{€} = 1298\,\text{€}$"),
        (r"$540\,€ + 756\,€ = 1296\,€$", r"$540\,€ + 756\,€ = 1298\,€$"),
        (r"$540\,\euro + 756\,\euro = 1296\,\euro$", r"$540\,\euro + 756\,\euro = 1298\,\euro$"),
        (r"$\pounds 540 + \pounds 756 = \pounds 1296$", r"$\pounds 540 + \pounds 756 = \pounds 1298$"),
    ] {
        assert_eq!(compared_and_listed(right, TextFormat::Markdown), (1, 0), "{right}");
        assert_eq!(compared_and_listed(wrong, TextFormat::Markdown), (1, 1), "{wrong}");
    }
    let text = "So $540 + $756 = $1,298 in text, and then $540 + $756 = $1,296.";
    assert_eq!(wrong(text, TextFormat::Plain).len(), 1);
}

#[test]
fn nothing_is_compared_across_currencies() {
    for text in ["So 50 € + 50 € = $110.", "Here £100 = 120 €.", r"$100\,\text{USD} = 92\,\text{EUR}$"] {
        let found = report(text, TextFormat::Markdown);
        assert_eq!((found.tally.checked, found.findings.len()), (0, 0), "{text}");
    }
}

#[test]
fn an_abbreviation_behind_the_result_is_left_away() {
    assert_eq!(compared_and_listed(r"So $4.5 - 0.9 = 3.6 \text{ LPA}$ is paid.", TextFormat::Markdown), (1, 0));
    assert_eq!(compared_and_listed(r"So $4.5 - 0.9 = 3.7 \text{ LPA}$ is paid.", TextFormat::Markdown), (1, 1));
    // A size of memory is a unit of another size.
    assert_eq!(compared_and_listed(r"So $4 \times 300 = 1.2 \text{ KIB}$ is used.", TextFormat::Markdown), (0, 0));
}
