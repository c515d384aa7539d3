//! One notation for the triangle of the two axes and the pin: in every chapter a letter stands for the same thing and counts the
//! same way, and the letters that it replaced are gone.

use super::mechanisms::{When, pin, quick_return, wheel};
use super::{escapement, joints};
use geneva_chapters::figures::FIGURES;
use geneva_documents::LEDGER;
use geneva_documents::WILD;
use geneva_evidence::Kind;
use geneva_evidence::tex::{Display, Moment, letters_in};
use geneva_figures::notation::NOTATION;
use std::collections::BTreeMap;

/// What holds of the letters of a chapter: which chapter, in which states, which relations.
type Relations = (&'static str, Vec<Moment>, &'static [&'static str]);

const TRIANGLE: &str = r"r^2 = R^2 + l^2 - 2 R l \cos\theta";
const RATIO: &str = r"l = k R";
const RATES: &str = r"r^2 \dot\varphi = (R l \cos\theta - R^2) \dot\theta";

fn relations() -> Vec<Relations> {
    let many = |state: fn(usize) -> Moment| (0..40).map(state).collect();
    const SENSES: &str = r"R \sin\theta = r \sin\varphi";
    vec![
        ("pin", many(|number| pin(number, None, None)), &[TRIANGLE, RATIO, SENSES, RATES]),
        (
            "jazar",
            many(|number| wheel(number, None, When::Steady)),
            &[TRIANGLE, RATIO, SENSES, RATES, r"\alpha = \pi/N"],
        ),
        // The lever's angle counts in the crank's sense, the wheel's against it.
        (
            "quick-return",
            many(|number| quick_return(number, 0.0)),
            &[TRIANGLE, r"R \sin\theta = -r \sin\varphi", r"r^2 \dot\varphi = -(R l \cos\theta - R^2) \dot\theta"],
        ),
        (
            "escapement",
            escapement::states(),
            &[TRIANGLE, RATIO, SENSES, RATES, r"F r = I_f \ddot\varphi", r"k \sin(\pi/N) = 1", r"\theta_0 = \pi/m"],
        ),
        // Lengths in crank radii.
        (
            "joints",
            joints::states(),
            &[r"r^2 = 1 + k^2 - 2 k \cos\theta", r"r^2 \dot\varphi = (k \cos\theta - 1) \dot\theta"],
        ),
    ]
}

#[test]
fn a_letter_stands_for_the_same_thing_in_every_chapter() {
    for (chapter, states, relations) in relations() {
        for relation in relations {
            let holds = Display::read(relation).and_then(|display| display.holds(&states));
            assert!(matches!(holds, Ok(true)), "{chapter}: {relation}: {holds:?}");
        }
    }
}

/// Letters that the book no longer uses for a part of the triangle: the letter, the pages (all, if none is named), and the
/// book's letter. One that ends with an underscore is meant with an index.
const RETIRED: &[(&str, &[&str], &str)] = &[
    (r"\psi", &[], r"\varphi, the lever's angle"),
    (r"\omega_", &[], r"\dot\theta or \dot\varphi, an angular velocity"),
    (r"\alpha_", &[], r"\ddot\varphi, an angular acceleration"),
    (r"\beta", &["pin", "terminal-speed"], r"\varphi, the wheel's angle; u_0"),
    (r"\alpha", &["terminal-speed"], r"\lambda, the slope of the return map"),
    ("c", &[], "l, the centre distance"),
    ("n", &[], "N, the number of slots"),
    ("P", &["making"], "m, the number of pins"),
    // On the page of the lever it is an acceleration.
    (
        "a",
        &["pin", "jazar", "making", "escapement", "program", "terminal-speed", "timer", "joints", "wild"],
        "k, the ratio",
    ),
    ("N", &["timer", "joints"], "F, the force of the pin"),
    ("R", &["joints"], "r, the distance of the pin in crank radii"),
];

/// Pieces of formulas in which a letter that is still in use would stand for what another letter stands for now.
const MISTAKEN: &[(&str, &str)] = &[
    (r"\mu N", r"\mu F, the friction"),
    ("|N", "|F|, the size of the force"),
    ("N R", "F r, the moment of the force"),
    (r"\dot R", r"\dot r, for the crank radius is constant"),
    ("dR", "dr, for the crank radius is constant"),
];

/// The tokens of TeX: commands, and single characters.
fn tokens(tex: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    for c in tex.chars() {
        let is_open = |token: &String| {
            token == "\\" || (token.starts_with('\\') && token[1..].chars().all(|c| c.is_ascii_alphabetic()))
        };
        match tokens.last_mut() {
            Some(last) if is_open(last) && (c.is_ascii_alphabetic() || last == "\\") => last.push(c),
            _ => tokens.push(c.to_string()),
        }
    }
    tokens
}

/// Where what begins at a token ends: a group in braces, a command with the group behind it, or the token alone.
fn end_of(tokens: &[String], at: usize) -> usize {
    match tokens.get(at).map(String::as_str) {
        Some("{") => at + 1 + tokens[at..].iter().position(|token| token == "}").unwrap_or(tokens.len() - at - 1),
        Some(command) if command.len() > 1 && tokens.get(at + 1).is_some_and(|token| token == "{") => {
            end_of(tokens, at + 1)
        }
        _ => at + 1,
    }
}

/// The letters of a formula, each with an underscore behind it if it has an index; what stands in an index, or upright, is left
/// out.
fn letters(tex: &str) -> Vec<String> {
    const UPRIGHT: [&str; 5] = [r"\text", r"\mathrm", r"\tag", r"\begin", r"\end"];
    let tokens = tokens(tex);
    let (mut found, mut at): (Vec<String>, usize) = (Vec::new(), 0);
    while let Some(token) = tokens.get(at) {
        if UPRIGHT.contains(&token.as_str()) {
            at = end_of(&tokens, at);
        } else if token == "_" {
            if let Some(last) = found.last_mut() {
                last.push('_');
            }
            at = end_of(&tokens, at + 1);
        } else {
            if token.starts_with(|c: char| c == '\\' || c.is_ascii_alphabetic()) {
                found.push(token.clone());
            }
            at += 1;
        }
    }
    found
}

/// The formulas of a chapter, in the lines and displayed, without its programs.
fn formulas(text: &str) -> Vec<String> {
    let prose: String = text.split("```").step_by(2).collect();
    prose.replace("$$", "$").split('$').skip(1).step_by(2).map(str::to_owned).collect()
}

/// What is retired of a formula of a page.
fn retired(page: &str, tex: &str) -> Vec<String> {
    let letters = letters(tex);
    let mistaken = MISTAKEN.iter().filter(|(piece, _)| tex.contains(piece));
    let mistaken = mistaken.map(|(piece, ours)| format!("{piece} for {ours}"));
    let on_page = RETIRED.iter().filter(|(_, pages, _)| pages.is_empty() || pages.contains(&page));
    on_page
        .filter(|(letter, ..)| letters.iter().any(|of| of == letter))
        .map(|(letter, _, ours)| format!("{letter} for {ours}"))
        .chain(mistaken)
        .collect()
}

#[test]
fn no_formula_of_a_chapter_uses_a_letter_that_was_given_up() {
    let (mut wrong, mut read) = (Vec::new(), 0);
    for (path, text) in crate::texts() {
        let page = path.file_stem().expect("a name").to_string_lossy().into_owned();
        for tex in formulas(&text) {
            read += 1;
            wrong.extend(retired(&page, &tex).into_iter().map(|what| format!("{page}: `{}`: {what}", tex.trim())));
        }
    }
    assert!(read > 700, "only {read} formulas are read");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // Each would be noticed.
    for (page, tex) in [
        ("pin", r"\sin\beta"),
        ("quick-return", r"\dot\psi"),
        ("escapement", r"c = a\,r"),
        ("escapement", r"\frac{\pi}{n}"),
        ("quick-return", r"\omega_4 v_\mathrm{rel}"),
        ("joints", r"\mu|N|"),
        ("joints", r"\dot R"),
        ("escapement", r"N R = I_f \ddot\varphi"),
    ] {
        assert!(!retired(page, tex).is_empty(), "{page}: {tex}");
    }
    for (page, tex) in [("program", r"y_n"), ("quick-return", r"a_\mathrm{Cor}"), ("escapement", r"\text{a n c}")] {
        assert!(retired(page, tex).is_empty(), "{page}: {tex}");
    }
}

#[test]
fn no_drawing_names_a_part_by_a_letter_that_was_given_up() {
    for (name, figure) in FIGURES {
        let svg = figure().expect("a figure").svg;
        for letter in ["ψ", "c", "n"] {
            assert!(!svg.contains(&format!("font-style=\"italic\">{letter}</tspan>")), "{name}: {letter}");
        }
        // What lights up has a label that says so, or stands in a triangle whose letters are those of the notation.
        for part in svg.split("data-letter=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
            let is_letter = NOTATION.iter().any(|letter| letter.part == part);
            assert!(is_letter || svg.contains(&format!("data-letter=\"{part}\">")), "{name}: {part} is named nowhere");
        }
    }
}

/// What is read as a name in a source's equations and is no letter: units and words.
const NO_LETTERS: [&str; 12] = ["min", "rad", "rev", "s", "in", "lb", "sec", "constant", "since", "by", "if", "ldots"];

/// The letter of a name, without its dots, its marks and its indices, as Unicode.
fn base(name: &str) -> String {
    let name = name
        .trim_start_matches("upright ")
        .trim_start_matches("delta ")
        .trim_start_matches('δ')
        .trim_start_matches('\\');
    let end = name.find(|c: char| !c.is_alphabetic()).unwrap_or(name.len());
    match GREEK.iter().find(|(greek, _)| *greek == &name[..end]) {
        Some((_, letter)) => (*letter).to_owned(),
        // An index may be set without its mark.
        None => name.chars().take(1).collect(),
    }
}

/// The Greek letters of the sources.
const GREEK: [(&str, &str); 11] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("theta", "θ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("omega", "ω"),
    ("pi", "π"),
];

#[test]
fn every_letter_of_a_source_has_a_line_in_the_table_of_its_chapter() {
    for work in LEDGER.documents().iter().filter(|work| **work != &WILD) {
        let table: Vec<String> = work
            .symbols
            .iter()
            .flat_map(|symbol| symbol.printed.split(", "))
            .map(|printed| base(printed).replace('ϕ', "φ"))
            .collect();
        let mut missing = BTreeMap::new();
        let mut read = 0;
        for claim in LEDGER.claims().iter().filter(|claim| claim.document == *work && claim.kind == Kind::Equation) {
            // These are lines of programs. What each of their names is, the claim of its line says.
            if ["meyer.listing.", "meyer.app-b.example."].iter().any(|cards| claim.id.starts_with(cards)) {
                continue;
            }
            for name in claim.right_characters().split(['=', '<', '>', '&']).flat_map(letters_in) {
                read += 1;
                let derivative = name.contains('/') && name.starts_with('d');
                if !derivative
                    && !NO_LETTERS.contains(&name.trim_start_matches("upright "))
                    && !table.contains(&base(&name))
                {
                    missing.entry(name).or_insert(claim.id);
                }
            }
        }
        assert!(read > 10, "{work}: only {read} letters are read");
        assert!(missing.is_empty(), "{work}: the table has no line for {missing:?}");
    }
}
