//! Texts with a decimal comma, and with thousands separated by spaces.

use crate::{assert_told_apart, report, wrong};
use proofread::{ReportSection, TextFormat};

/// How many pairs were compared, and what is wrong.
fn compared(text: &str, format: TextFormat) -> (usize, Vec<String>) {
    let report = report(text, format);
    let numbers = report.findings.iter().filter(|of| of.section == ReportSection::Numbers);
    (report.tally.pairs, numbers.map(|of| format!("{} | {}", of.left, of.right)).collect())
}

#[test]
fn a_text_with_decimal_commas_is_read_as_one() {
    for (text, pairs) in [
        (r"$12,75\text{ kg} + 7,25\text{ kg} = 20,0\text{ kg}$", 1),
        (r"$40{\times}-1,5{\times}{10}^{-6}\text{C} = -6,0\ensuremath{\times}{10}^{-5}\text{C}$", 1),
        (r"$\frac{0,9\text{ km}}{0,24\text{ h}} = 3,75 \text{ km} \cdot \text{h}^{-1}$", 1),
        (r"$90\text{km} \cdot \text{h}^{-1} \div 3,6 = 25 \text{m}\cdot \text{s}^{-1}$", 1),
        (r"$5,1\times10^3\times4,2\times10^4 = 21,42\times10^7 = 2,142\times10^8$", 2),
        (r"$0{,}25 + 0{,}5 = 0{,}75$, $1\,000 - 0{,}5 = 999{,}5$", 2),
        (r"$1~250 + 0,5 = 1~250,5$", 1),
        (r"$0,5 + 0,5 = 1,0$, $1,5 + 1,5 = 3,0$, $1.250 + 0,5 = 1.250,5$", 3),
    ] {
        for format in [TextFormat::Latex, TextFormat::Markdown] {
            let (found, wrong) = compared(text, format);
            assert_eq!(wrong, [""; 0], "{text}");
            assert!(found >= pairs, "{text}: {found} of {pairs} pairs");
        }
    }
    assert_eq!(wrong("$12,75 + 7,25 = 21,0$", TextFormat::Latex), ["12.75 + 7.25 | 21.0"]);
    assert_eq!(wrong("U = 2,5 V + 1,5 V = 4,5 V", TextFormat::Plain), ["2.5 V + 1.5 V | 4.5 V"]);
    let html = "<p><math><mn>2,5</mn><mo>+</mo><mn>1,5</mn><mo>=</mo><mn>4,5</mn></math></p>";
    assert_eq!(wrong(html, TextFormat::Html), ["2.5 + 1.5 | 4.5"]);
}

#[test]
fn a_decimal_comma_may_stand_before_an_exponent_or_a_degree_sign() {
    let commas = r"$0,5 + 0,5 = 1,0$, $1,5 + 1,5 = 3,0$";
    for tex in [r"\sin^{-1}(\frac{1}{1,25}) = 53,1^{\circ}", r"1,5^2 = 2,25", r"\sqrt{1,5^2 + 2^2} = 2,5"] {
        assert_eq!(compared(&format!("{commas}, ${tex}$"), TextFormat::Latex), (3, Vec::new()), "{tex}");
    }
    let other = r"\sin^{-1}(\frac{1}{1,25}) = 54,1^{\circ}";
    assert_eq!(compared(&format!("{commas}, ${other}$"), TextFormat::Latex).1.len(), 1);
}

#[test]
fn points_beside_decimal_commas_part_thousands_or_decimals() {
    let commas = "$0,5 + 0,5 = 1,0$, $1,5 + 1,5 = 3,0$, $2,5 + 2,5 = 5,0$, $3,5 + 3,5 = 7,0$, $4,5 + 4,5 = 9,0$";
    for (text, pairs) in [
        // Points of decimals show themselves elsewhere in the text, or as the factor of a power of ten.
        (r"$\sqrt{4.242^2 + 4^2} = 5.83$", 1),
        (r"$2 \times 3.125 = 6.25$", 1),
        (r"$\frac{1}{32} = 3.125\times10^{-2}$", 1),
        (r"$\frac{1}{32} = 3.125 \times 10^{-2}$", 1),
        // Without such a point they are thousands, and a decimal comma behind one leaves no doubt.
        (r"$1.250 + 0,5 = 1.250,5$", 1),
        (r"$1.250 + 1.250 = 2500$", 1),
        (r"$1.250 + 0,5 = 1.250,5$ in section $2.3$", 1),
    ] {
        assert_eq!(compared(&format!("{commas}, {text}"), TextFormat::Latex), (5 + pairs, Vec::new()), "{text}");
    }
    let changed = r"$\sqrt{4.242^2 + 4^2} = 5.93$";
    assert_eq!(compared(&format!("{commas}, {changed}"), TextFormat::Latex).1.len(), 1);
}

#[test]
fn commas_of_lists_pairs_and_thousands_stay() {
    for text in [
        "$x = 3, y = 4$ and $3 + 4 = 7$",
        "$x = 1,2,3$ and $0.5 + 0.5 = 1.0$",
        "$(1,2)$ and $(3,4)$ with $2 + 3 = 5$",
        r"$500 + 700 = 1,200$ and $0.5 + 1.0 = 1.5$ and $a_{1,2} = 3$",
        r"$500 + 700 = 1{,}200$",
        r"$\{1,2\}$, $500 + 700 = 1,200$",
    ] {
        assert_eq!(wrong(text, TextFormat::Markdown), [""; 0], "{text}");
    }
    assert!(
        report("$500 + 700 = 1,300$", TextFormat::Markdown)
            .findings
            .iter()
            .any(|of| of.section == ReportSection::Numbers)
    );
}

#[test]
fn thousands_are_parted_by_narrow_space() {
    for text in
        ["$2~512 + 500 = 3~012$", r"$2\,512 + 500 = 3\,012$", "$2 512 + 500 = 3 012$", r"$2\ 512.5 - 0.5 = 2\;512.0$"]
    {
        assert_eq!(compared(text, TextFormat::Markdown), (1, Vec::new()), "{text}");
        let changed = text.replacen("512", "612", 1);
        assert_eq!(wrong(&changed, TextFormat::Markdown).len(), 1, "{changed}");
    }
    // In running text, two numbers side by side are two numbers.
    assert_eq!(wrong("In task 12 100 + 5 = 105.", TextFormat::Plain), [""; 0]);
}

/// MathML with each number, comma and sign of a line as an element of its own, as programs make it out of TeX.
fn leaf_by_leaf(line: &str) -> String {
    let mut out = String::from("<math>");
    let mut digits = String::new();
    for c in line.chars().chain([' ']) {
        if c.is_ascii_digit() || c == '.' {
            digits.push(c);
            continue;
        }
        if !digits.is_empty() {
            out += &format!("<mn>{}</mn>\n ", std::mem::take(&mut digits));
        }
        match c {
            ' ' => {}
            c if c.is_alphabetic() => out += &format!("<mi>{c}</mi>"),
            c => out += &format!("<mo separator=\"true\">{c}</mo>"),
        }
    }
    out + "</math>"
}

#[test]
fn a_comma_among_tags_parts_decimals_if_the_text_says_so() {
    let evidence = [
        leaf_by_leaf("1,05+0,95=2,00"),
        leaf_by_leaf("230·0,45=103,5"),
        leaf_by_leaf("1−0,786=0,214"),
        "<math><mfrac><mrow><mn>7</mn><mo>,</mo><mn>5</mn></mrow><mn>3</mn></mfrac><mo>=</mo><mn>2</mn><mo>,</mo><mn>5</mn></math>".to_owned(),
        "<math><mn>2,5</mn><mo>+</mo><mn>2,5</mn><mo>=</mo><mn>5,0</mn></math>".to_owned(),
        "2,5 · 2 = 5,0".to_owned(),
    ];
    let right = leaf_by_leaf("3,14·6,25=19,63");
    for said in &evidence {
        let text = format!("<p>{said}</p><p>{right}</p>");
        assert_eq!(compared(&text, TextFormat::Html), (2, Vec::new()), "{text}");
        let text = text.replace(">63<", ">36<");
        assert_eq!(compared(&text, TextFormat::Html).1, ["3.14·6.25 | 19.36"], "{text}");
    }
    // The exponent of a number with a comma belongs to all of it.
    let power = "<math><mn>3</mn><mo>,</mo><mn>14</mn><mo>·</mo><mn>2</mn><mo>,</mo><msup><mn>5</mn><mn>2</mn></msup><mo>=</mo><mn>19</mn>\
        <mo>,</mo><mn>63</mn></math>";
    assert_eq!(compared(&format!("<p>{}</p><p>{power}</p>", evidence[0]), TextFormat::Html), (2, Vec::new()));
}

#[test]
fn a_comma_among_tags_that_nothing_decides_is_not_taken_for_anything() {
    // A product of areas and the end of a list look the same.
    for line in ["A=3·6,25=19,63", "A=3·6,25=18,75", "7=3+4,8=3+5"] {
        let text = format!("<p>{}</p>", leaf_by_leaf(line));
        let report = report(&text, TextFormat::Html);
        assert_eq!((report.tally.pairs, report.findings.len()), (0, 0), "{line}");
        let reasons: Vec<&str> = report.not_checked.iter().map(|(_, name, _)| name).collect();
        assert_eq!(reasons, ["numbers with a comma, which may be decimal commas"], "{line}");
        let words = proofread::summary::describe_unchecked_chains(&report.not_checked);
        let words = words.expect("a chain");
        assert_eq!(words, "Not checked: 1 chain with numbers with a comma, which may be decimal commas.");
        // With decimal points elsewhere it is a list, as it always was.
        let text = format!("{text}<p>{}</p>", leaf_by_leaf("1.5+1.5=3.0"));
        assert!(self::report(&text, TextFormat::Html).tally.pairs > 1, "{line}");
    }
    // What no comma stands in is checked, and so is what a list in brackets or space tells.
    for line in ["2+2=5", "(2+1,4)=(3,5)"] {
        let text = format!("<p>{}</p><p>{}</p>", leaf_by_leaf("A=3·6,25=18,75"), leaf_by_leaf(line));
        assert_eq!(compared(&text, TextFormat::Html).1.len(), 1, "{line}");
    }
    let spaced = "<p><math><mn>2</mn><mo>+</mo><mn>2</mn><mo>=</mo><mn>5</mn><mo>,</mo><mspace width=\"1em\"/><mn>3</mn><mo>=</mo><mn>3</mn></math></p>";
    assert_eq!(compared(spaced, TextFormat::Html).1, ["2 + 2 | 5"]);
}

#[test]
fn thousands_among_tags_are_no_decimals() {
    // A number with a comma and a point has its decimals behind the point.
    let money = "<math><mfrac><mrow><mn>2,200.50</mn></mrow><mn>2</mn></mfrac><mo>=</mo><mn>1,100.25</mn></math>";
    for line in ["1,600+2,000=3,600", "1,050+1,050=2,100", "12,600+400=13,000"] {
        let alone = format!("<p>{}</p>", leaf_by_leaf(line));
        for text in [alone.clone(), format!("{alone}<p>{money}</p>")] {
            assert_eq!(compared(&text, TextFormat::Html).1, [""; 0], "{text}");
            assert_eq!(report(&text, TextFormat::Html).not_checked.iter().count(), 0, "{text}");
        }
        let wrong = leaf_by_leaf(&line.replace("=", "=9"));
        assert_eq!(compared(&format!("<p>{wrong}</p><p>{money}</p>"), TextFormat::Html).1.len(), 1, "{line}");
    }
}

#[test]
fn a_comma_before_three_digits_may_part_decimals() {
    for [right, wrong] in [
        ["Der Quarz schwingt mit 500 MHz / 9 = 55,556 MHz.", "Der Quarz schwingt mit 500 MHz / 9 = 54,556 MHz."],
        [r"$\sqrt{62} \approx 7,874$", r"$\sqrt{62} \approx 7,884$"],
        [
            r"$\qty{150}{\mega\hertz} + \qty{1,350}{\giga\hertz} = \qty{1,5}{\giga\hertz}$",
            r"$\qty{150}{\mega\hertz} + \qty{1,350}{\giga\hertz} = \qty{1,6}{\giga\hertz}$",
        ],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
    // In siunitx it does in any case, so that the sum is checked.
    let sum = r"$\qty{150}{\mega\hertz} + \qty{1,350}{\giga\hertz} = \qty{1,5}{\giga\hertz}$";
    assert_eq!(report(sum, TextFormat::Markdown).findings[0].section, ReportSection::Agreeing);
}

#[test]
fn a_decimal_comma_leaves_points_to_thousands() {
    let chain = |comma: &str| format!(r"$f = \frac{{300}}{{0{comma}03}} = \frac{{300 \cdot 100}}{{3}} = 10.000$");
    assert_told_apart(&chain(","), &chain(".").replace("10.000", "20.000"), TextFormat::Markdown);
}
