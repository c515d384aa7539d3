//! Documents in Typst: their formulas, text, tables and code.

use crate::command::run;
use crate::office::{file, said};

/// What is said of each finding, and the command's whole output.
fn found(text: &str) -> (Vec<String>, String) {
    let (_folder, path) = file("a.typ", text.as_bytes());
    let (code, out, told) = run(&["--less-certain", &path]);
    let findings = said(&out);
    assert_eq!(code, u8::from(!findings.is_empty()), "{out}{told}");
    (findings, out)
}

#[test]
fn each_notation_of_a_formula_is_read_right_and_wrong() {
    for (text, right, wrong, said) in [
        ("It is $ 43.4 - 29.8 = RESULT $ here.", "13.6", "13.8", "printed 13.8, recomputed 13.6"),
        ("So $43.4 - 29.8 = RESULT$.", "13.6", "13.8", "printed 13.8, recomputed 13.6"),
        ("$frac(43.4 - 29.8, 2) = RESULT$", "6.8", "7.9", "printed 7.9, recomputed 6.8"),
        ("$(43.4 - 29.8)/2 = RESULT$", "6.8", "7.9", "printed 7.9, recomputed 6.8"),
        ("$48/6/4 = RESULT$", "2", "32", "printed 32, recomputed 2"),
        ("$sqrt(625) = RESULT$", "25", "35", "printed 35, recomputed 25"),
        ("$root(3, 2744) = RESULT$", "14", "24", "printed 24, recomputed 14"),
        ("$binom(7, 3) = RESULT$", "35", "21", "printed 21, recomputed 35"),
        ("$3.2 times 10^3 dot 2 = RESULT$", "6400", "7400", "printed 7400, recomputed 6400"),
        ("$3.2 dot.c 10^(-3) dot 2000 = RESULT$", "6.4", "7.4", "printed 7.4, recomputed 6.4"),
        ("$x_0^2 = (1.5 + 2.5)^2 = RESULT$", "16", "18", "printed 18, recomputed 16"),
        ("$ x &= 12 dot 13 \\ &= RESULT $", "156", "165", "printed 165, recomputed 156"),
        ("$floor(77/2) = RESULT$", "38", "39", "printed 39, recomputed 38"),
        ("$ceil(77/2) = RESULT$", "39", "38", "printed 38, recomputed 39"),
        ("$abs(3 - 15) = RESULT$", "12", "13", "printed 13, recomputed 12"),
        ("$|3 - 15| = RESULT$", "12", "13", "printed 13, recomputed 12"),
        ("$tan 31.0 degree = RESULT$", "0.601", "0.609", "printed 0.609, recomputed 0.601"),
        ("$2 sin(30 degree) = RESULT$", "1.00", "1.20", "printed 1.20, recomputed 1.00"),
        ("$log_(10) (2) approx RESULT$", "0.301", "0.331", "printed 0.331, recomputed 0.301"),
        ("$12 dot 11! = RESULT!$", "12", "13", ""),
        ("$5^1 / 3! dot 6 + 6! / 4! = RESULT$", "35", "53", "printed 53, recomputed 35"),
        ("$sum_(k=1)^4 k^2 = RESULT$", "30", "31", "printed 31, recomputed 30"),
        ("$max(2, 5) + 1 = RESULT$", "6", "8", "printed 8, recomputed 6"),
        ("$2 pi approx RESULT$", "6.283", "6.823", "printed 6.823, recomputed 6.283"),
        (
            "E = 1.20 - 0.06/2 #math.times log(10#super[-4]) = *RESULT V*",
            "1.32",
            "1.22",
            "printed 1.22 V, recomputed 1.32 V",
        ),
        ("$12\\,500 + 500 = RESULT$", "13\\,000", "14\\,000", "printed 14,000, recomputed 13,000"),
        ("$48 upright(\"m\") / (4.0 \"s\") = RESULT \"m\"/\"s\"$", "12", "14", "printed 14 m/s, recomputed 12 m/s"),
        (
            "$2.0 thin upright(\"kg\") dot 3.0 thin \"m/s\"^2 = RESULT \"N\"$",
            "6.0",
            "8.0",
            "printed 8.0 N, recomputed 6.0 N",
        ),
        ("$0.25 = RESULT percent$", "25", "35", "printed 35 %, recomputed 25 %"),
        ("$mat(delim: \"|\", 12, 7; 5, 4) = RESULT$", "13", "23", "printed 23, recomputed 13"),
        ("$mat(1, 2; 3, 4) + mat(1, 1; 1, 1) = mat(2, 3; 4, RESULT)$", "5", "6", "printed 6, recomputed 5"),
        ("$vec(1, 2) + vec(3, 4) = vec(4, RESULT)$", "6", "7", "printed (4; 7), recomputed (4, 6)"),
        ("$5 plus.minus 2 = (3, RESULT)$", "7", "8", ""),
        ("$12 + 13 /* so */ = RESULT // yes\n$", "25", "26", "printed 26, recomputed 25"),
        ("The sum 12 + 13 = RESULT is *here*.", "25", "26", "printed 26, recomputed 25"),
        ("#let speed = 13.6\nSo $speed + 2.0 = RESULT$.", "15.6", "15.8", "printed 15.8, recomputed 15.6"),
        ("#let sum = $12 + 13$\nSo $2 dot (sum) = RESULT$.", "50", "60", "printed 60, recomputed 50"),
        ("#let v = 13.6\nSo $#v + 2.0 = RESULT$.", "15.6", "15.8", "printed 15.8, recomputed 15.6"),
        ("#let speed = 13.6\nSo #speed + 2.0 = RESULT in all.", "15.6", "15.8", "printed 15.8, recomputed 15.6"),
        ("#figure(image(\"a.png\"), caption: [As $12 + 13 = RESULT$.])", "25", "26", "printed 26, recomputed 25"),
        ("#let f(x) = 5\n#block[It is 12 + 13 = RESULT.]", "25", "26", "printed 26, recomputed 25"),
    ] {
        let (findings, all) = found(&text.replace("RESULT", right));
        assert!(findings.is_empty() && all.contains("Checked 1 chain of 1 chain"), "{text}\n{all}");
        let (findings, all) = found(&text.replace("RESULT", wrong));
        // Behind the values stands in which way they differ.
        let values: Vec<&str> = findings.iter().filter_map(|found| found.split(" (a factor").next()).collect();
        assert!(values.len() == 1 && (said.is_empty() || values == [said]), "{text}: {said}\n{all}");
    }
}

#[test]
fn a_place_is_that_of_the_source() {
    let (_, all) = found("= Title\n\nThe speed is $43.4 - 29.8 = 13.8 \"km\"/\"s\"$, so.\n");
    let place = "a.typ:3:29\n  |\n3 | The speed is $43.4 - 29.8 = 13.8 \"km\"/\"s\"$, so.\n  |                             ^^^^^^^^^^^^ printed 13.8 km/s";
    assert!(all.contains(place), "{all}");
    // Of a name, it is where the name is used.
    let (_, all) = found("#let speed = 13.8\nSo $43.4 - 29.8 = speed$.\n");
    assert!(all.contains("a.typ:2:19\n"), "{all}");
}

#[test]
fn code_raw_text_and_comments_are_counted_and_not_read() {
    for (text, told) in [
        ("`1 + 1 = 3`", "1 piece of code in a line"),
        ("```py\nx = 1 + 1 = 3\n```", "1 fence of `py`"),
        ("// 1 + 1 = 3\n", "1 comment"),
        ("/* 1 + 1 = 3 /* 2 = 3 */ */", "1 comment"),
        ("#{ let x = 1 + 1 == 3 }", "1 piece of code in a line"),
        ("#set text(size: if 1 == 2 { 3pt })\n", "1 piece of code in a line"),
    ] {
        let (findings, all) = found(text);
        assert_eq!(findings, [""; 0], "{text}\n{all}");
        assert!(all.contains(&format!("Not read, with an equals sign and a digit: {told}.")), "{text}\n{all}");
    }
    for text in
        ["https://a.example/1+1=3", "Costs \\$5 = \\$6 each", "@eq:1 = 5", "$foo(7) = 36$", "#let a = $a$\n$a = 5$"]
    {
        assert_eq!(found(text).0, [""; 0], "{text}");
    }
    let (_, all) = found("#let unit(x) = x\nSo $unit(7) + 1 = 9$, $qty + 1 = 9$.");
    assert!(all.contains("Not checked: 1 chain with `qty`, 1 with `unit`."), "{all}");
}

#[test]
fn totals_of_tables_are_compared() {
    let table = |total: &str| {
        format!(
            "#figure(table(columns: (auto, 1fr), table.header([Item], [Cost]), [Screws], [1,234], [Nails], [2,345], [Boards], [3,456], [Total], [{total}]))"
        )
    };
    assert_eq!(found(&table("7,035")).0, [""; 0]);
    assert_eq!(found(&table("7,135")).0, ["printed 7,135, recomputed 7035"]);
}

#[test]
fn nothing_that_is_written_ends_the_program() {
    for text in [
        "$",
        "$(",
        "$((((",
        "$frac(",
        "$frac(1,",
        "$\"",
        "#",
        "#let",
        "#let x",
        "#let x =",
        "#(",
        "[",
        "`",
        "```",
        "/*",
        "$ x_ $",
        "$ / $",
        "$ ^ $",
        "$a/$",
        "\\",
        "$\\",
        "#table(",
        "#table(columns: 0, [1])",
        "<a",
        "@",
        "#x.",
        "$#$",
        "$#x($",
        "é$é$é",
        "$)$",
        "$(]$",
        "#[",
        "#\"",
    ] {
        found(text);
        found(&text.repeat(300));
    }
    for text in ["$x_1", "(", "[", "#[", "a/", "1/", "#let a = $a a$\n", "frac(1,", "x^2_", "sqrt("] {
        found(&format!("${}$", text.repeat(2000)));
        found(&text.repeat(2000));
    }
    let doubling: String = (1..30)
        .map(|at| format!("#let n{}x = $n{}x n{}x$\n", "a".repeat(at), "a".repeat(at - 1), "a".repeat(at - 1)))
        .collect();
    found(&format!("#let nx = 1\n{doubling}$n{}x = 5$", "a".repeat(29)));
}

#[test]
fn a_line_of_json_may_hold_typst_and_no_archive() {
    let line = |format: &str| format!("{{\"id\": \"a\", \"format\": \"{format}\", \"text\": \"$ 7/2 = 3.6 $\"}}\n");
    for format in ["typst", "typ"] {
        let (_folder, path) = file("all.jsonl", line(format).as_bytes());
        let (code, out, told) = run(&[&path]);
        assert_eq!((code, told.as_str()), (1, ""), "{out}");
        assert!(out.contains(" --> a:1:9\n") && out.contains("printed 3.6, recomputed 3.5"), "{out}");
    }
    for (format, remedy) in [
        ("docx", "csv, typst, and a document in another one is no text: give its file to the command"),
        ("odt", "give its file to the command"),
        (
            "rst",
            "the format `rst` is not known; it is one of markdown, latex, xml, html, notebook, plain, csv, typst\n",
        ),
    ] {
        let (_folder, path) = file("all.jsonl", line(format).as_bytes());
        let (code, _, told) = run(&[&path]);
        assert!(code == 2 && told.contains(remedy), "{format}: {told}");
    }
}
