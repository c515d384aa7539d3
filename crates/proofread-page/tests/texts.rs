//! Whatever is pasted, the answer is JSON, its places are in the text, and its work is bounded.

use geneva_proofread_page::{MOST_BYTES, answer};
use serde_json::{Value, json};

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
    let places = |of: &Value| (of["others"].as_array().map(Vec::len), of["more"].as_u64());
    // Those with a hint have one shape, and those without have another.
    assert_eq!(findings.iter().map(places).collect::<Vec<_>>(), [(Some(20), Some(39)), (Some(20), Some(919))]);
    assert!(findings[0]["facts"].to_string().contains("\"hint\""), "{}", findings[0]);
    let said = answer["summary"].to_string();
    for words in ["2 findings at 1,000 places: 2 on a number.", "Hints were searched for at most the first 60."] {
        assert!(said.contains(words), "{said}");
    }
    // A sum for each number below a thousand, whose digits in base two are its signs.
    let sign = |n: usize, bit: usize| if n >> bit & 1 == 1 { " + 1.25" } else { " - 1.25" };
    let sum = |n| format!("$98.75{} = 1234.5$\n\n", (0..10).map(|bit| sign(n, bit)).collect::<String>());
    let answer = answered(&format!("\n{}", (0..1000).map(sum).collect::<String>()));
    let findings = answer["findings"].as_array().expect("findings");
    assert_eq!(
        (findings.len(), &findings[0]["list"], &findings[1]["list"]),
        (200, &json!("numbers"), &json!("less-certain"))
    );
    assert_eq!(answer["less_certain"], "999 less certain differences");
    let said = answer["summary"].to_string();
    for words in ["1 finding: 1 on a number.", "999 less certain differences.", "The first 200 are shown."] {
        assert!(said.contains(words), "{said}");
    }
}

#[test]
fn what_is_less_certain_is_behind_the_others() {
    let answer = answered(
        "\n$|3| = 4$ and $2 + 2 = 5$, $3 + 3 = 7$ $14 + 3 = 17$, $15 + 3 = 18$, $16 + 3 = 19$, $17 + 3 = 20$, $18 + 3 = 21$",
    );
    let findings = answer["findings"].as_array().expect("findings");
    let told: Vec<_> = findings.iter().map(|of| (&of["list"], &of["chain"][0], &of["others"])).collect();
    let other = json!([{ "line": 1, "column": 37, "from": 36, "to": 37 }]);
    let (sum, apart) = (json!("2 + 2 = "), json!("|3| = "));
    assert_eq!(told, [(&json!("numbers"), &sum, &other), (&json!("less-certain"), &apart, &json!([]))]);
    assert!(answer["text"].as_str().is_some_and(|text| text.contains("    also: line 1, column 37\n")), "{answer}");
}

#[test]
fn a_long_chain_is_shown_around_its_places() {
    let text = |sides: usize| format!("\n${}$", vec!["7.0"; sides].join(" = 8.0 = "));
    let answer = answered(&text(20_000));
    let said = answer["summary"].to_string();
    assert!(said.contains("1 formula or line was not read to its end: it is too long"), "{said}");
    let answer = answered(&text(1500));
    let findings = answer["findings"].as_array().expect("findings");
    let chains: Vec<String> = findings.iter().map(|of| of["chain"].to_string()).collect();
    assert!(
        chains.iter().all(|chain| chain.len() < 400) && chains.iter().any(|chain| chain.contains('…')),
        "{chains:?}"
    );
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
