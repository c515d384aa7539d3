//! Does every public number of the formulas and of the solver say its unit?

/// What tells a unit, as whole words.
const UNITS: [&str; 24] = [
    "dimensionless",
    "rad",
    "radians",
    "rad/s",
    "rad/s²",
    "degrees",
    "seconds",
    "crank radii",
    "in s",
    // Of the thesis: inches and pounds of force, as in "in in lb s²".
    "in lb",
    "in metres",
    "millimetres",
    "in N",
    "in N m",
    "kg m²",
    "kg/m³",
    "in Pa",
    "in W",
    // Where any consistent units will do.
    "unit of",
    "units of",
    "same unit",
    "own unit",
    "caller's unit",
    "any unit",
];

/// Whether a type is `f64` or the formulas' scalar `S`, alone, in a row, or in one of std's types around it.
fn is_number(kind: &str) -> bool {
    let mut around = Vec::new();
    let mut word = String::new();
    for sign in kind.chars().chain([' ']) {
        if sign.is_alphanumeric() || sign == '_' {
            word.push(sign);
            continue;
        }
        let seen_through = |of: &String| ["Option", "Result", "Vec", "Box"].contains(&of.as_str());
        if ["f64", "S"].contains(&word.as_str()) && around.iter().all(seen_through) {
            return true;
        }
        match sign {
            '<' => around.push(word.clone()),
            '>' => drop(around.pop()),
            _ => {}
        }
        word.clear();
    }
    false
}

/// The name and the type of the public field, constant or function (the type that it returns) that begins `code`. In a
/// trait or an enum that is public, what is declared is `public` without saying so.
fn declared(code: &[&str], public: bool) -> Option<(String, String)> {
    let first = code.first()?.trim();
    let first = first.strip_prefix("pub ").or(public.then_some(first))?;
    let first = first.strip_prefix("const ").unwrap_or(first);
    let (declaration, kind) = if let Some(function) = first.strip_prefix("fn ") {
        let end = code.iter().position(|line| line.ends_with(['{', ';', '}']))?;
        let signature = code[..=end].iter().map(|line| line.trim()).collect::<Vec<_>>().join(" ");
        let (_, returned) = signature.split(" where ").next()?.rsplit_once("-> ")?;
        (function, returned.split(" {").next()?.to_owned())
    } else {
        let (name, kind) = first.split_once(": ")?;
        if name.contains(' ') {
            return None;
        }
        (name, kind.split(" =").next()?.to_owned())
    };
    let name = declaration.split(|of: char| !of.is_alphanumeric() && of != '_').next()?;
    Some((name.to_owned(), kind))
}

/// Whether a text has a phrase that begins and ends as words do.
fn says(text: &str, phrase: &str) -> bool {
    let ends = |beside: Option<char>| beside.is_none_or(|of| !of.is_alphanumeric() && !"/²".contains(of));
    text.match_indices(phrase)
        .any(|(at, _)| ends(text[..at].chars().next_back()) && ends(text[at + phrase.len()..].chars().next()))
}

/// The public numbers of a file that do not say their unit, each with its line.
fn without_a_unit(text: &str) -> Vec<String> {
    let code: Vec<&str> = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default().lines().collect();
    let (mut found, mut comment, mut public, mut example) = (Vec::new(), String::new(), false, false);
    for (at, line) in code.iter().enumerate() {
        if !line.starts_with([' ', '}', '/', '#']) && !line.is_empty() {
            public = ["pub trait ", "pub enum "].iter().any(|start| line.starts_with(start));
        }
        let trimmed = line.trim();
        if let Some(said) = trimmed.strip_prefix("///") {
            // What an example says of its own numbers is no unit of the item.
            let fence = said.trim().starts_with("```");
            example ^= fence;
            if !example && !fence {
                comment += said;
            }
        } else if !trimmed.starts_with("#[") {
            let number = declared(&code[at..], public).filter(|(_, kind)| is_number(kind));
            // What has no comment in a trait or an enum is a parameter: of the rest the compiler asks for one.
            let parameter = public && comment.is_empty();
            if let Some((name, kind)) = number
                && !parameter
                && !UNITS.iter().any(|unit| says(&comment, unit))
            {
                found.push(format!("{}: {name}: {kind}", at + 1));
            }
            comment.clear();
        }
    }
    found
}

#[test]
fn every_public_number_says_its_unit() {
    let mut found = Vec::new();
    for package in ["exact", "kinematics", "dynamics", "mimic", "case1973", "proofread"] {
        for (path, text) in crate::files(&format!("crates/{package}/src"), &[".rs"]) {
            if !path.iter().any(|part| part == "tests") && !path.ends_with("tests.rs") {
                found.extend(without_a_unit(&text).into_iter().map(|number| format!("{}:{number}", path.display())));
            }
        }
    }
    assert!(found.is_empty(), "{} numbers say no unit nor that they have none:\n{}", found.len(), found.join("\n"));
}

#[test]
fn a_unit_is_asked_of_public_numbers_alone() {
    let told = |text: &str| without_a_unit(text).len();
    assert_eq!(told("/// The radius.\npub radius: f64,"), 1);
    assert_eq!(told("/// The radius, in crank radii.\npub radius: Option<S>,"), 0);
    assert_eq!(told("/// The radius.\n/// ```\n/// 2.0 // crank radii\n/// ```\npub radius: f64,"), 1);
    assert_eq!(told("/// The radius.\nradius: f64,"), 0);
    assert_eq!(told("/// The radius.\npub fn radius(\n    at: f64,\n) -> Result<[f64; 2], Error> {"), 1);
    assert_eq!(told("/// The direction.\npub fn direction() -> Turn<S> {"), 0);
    assert_eq!(told("pub enum Error {\n    /// The radius.\n    radius: f64,\n}"), 1);
}
