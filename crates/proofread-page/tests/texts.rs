//! Whatever is pasted, the answer is JSON, its places are in the text, and its work is bounded.

use geneva_proofread_page::{MOST_BYTES, answer};
use serde_json::Value;

fn given(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

#[track_caller]
fn answered(question: &str) -> Value {
    let answer: Value = serde_json::from_str(&answer(question)).expect("JSON");
    let (_, text) = question.split_once('\n').unwrap_or((question, ""));
    let units = text.encode_utf16().count() as u64;
    for finding in answer["findings"].as_array().into_iter().flatten() {
        let [from, to] = ["from", "to"].map(|end| finding[end].as_u64().expect("a place"));
        assert!(from <= to && to <= units, "{question:?}: {finding}");
        let line = finding["line"].as_u64().expect("a line");
        assert!((1..=text.lines().count().max(1) as u64).contains(&line), "{question:?}: {finding}");
    }
    assert!(answer["error"].is_string() != answer["summary"].is_array(), "{question:?}: {answer}");
    answer
}

#[test]
fn findings_and_hints_of_a_text_full_of_mistakes_are_bounded_and_it_is_said() {
    let text = format!("\n{}", "$239.052157 - 239.046526 = 0.0005631$\n\n".repeat(1000));
    let answer = answered(&text);
    let findings = answer["findings"].as_array().expect("findings");
    let hinted = |of: &&Value| of["facts"].to_string().contains("\"hint\"");
    assert_eq!((findings.len(), findings.iter().filter(hinted).count()), (200, 60));
    let said = answer["summary"].to_string();
    for words in [
        "1,000 findings: 1,000 on a number.",
        "The first 200 are shown.",
        "Hints were searched for at most the first 60.",
    ] {
        assert!(said.contains(words), "{said}");
    }
}

#[test]
fn a_long_chain_is_shown_around_its_places() {
    let text = |sides: usize| format!("\n${}$", vec!["7.0"; sides].join(" = 8.0 = "));
    let answer = answered(&text(20_000));
    let said = answer["summary"].to_string();
    assert!(said.contains("1 formula or line was not read to its end: it is too long"), "{said}");
    let answer = answered(&text(1500));
    let chain = answer["findings"][100]["chain"].to_string();
    assert!(chain.len() < 400 && chain.contains('…'), "{chain}");
}

#[test]
fn fuzz() {
    const PIECES: [&str; 40] = [
        "$",
        "$$",
        "\\frac{",
        "}",
        "{",
        "=",
        " = ",
        "2",
        "2.0",
        "7.31",
        "10^{3}",
        "\\mathrm{m}",
        " m",
        "\\\\",
        "&",
        "\n",
        "\r\n",
        "<math>",
        "<mn>2</mn>",
        "<mo>=</mo>",
        "</math>",
        "<p>",
        "<?xml?>",
        "\\begin{align}",
        "\\end{align}",
        "🔥",
        "ä",
        "\u{202e}",
        "\0",
        "{\"cells\":[",
        "\"source\":",
        "]",
        "(",
        ")",
        "+",
        "-",
        "sin ",
        "°",
        "≈",
        "\u{feff}",
    ];
    const OPTIONS: [&str; 8] = [
        "",
        "format=latex",
        "format=html",
        "format=notebook",
        "extension=md",
        "units=yes bindings=always",
        "format=x",
        "hints=no",
    ];
    let mut random = fastrand::Rng::with_seed(given("GENEVA_FUZZ_SEED", 37));
    for _ in 0..given("GENEVA_FUZZ", 3000) {
        let mut question = format!("{}\n", OPTIONS[random.usize(..OPTIONS.len())]);
        for _ in 0..random.usize(..40) {
            question += PIECES[random.usize(..PIECES.len())];
        }
        answered(&question);
    }
    assert!(answered(&format!("\n{}", "x".repeat(MOST_BYTES + 1)))["error"].is_string());
}
