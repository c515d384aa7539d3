//! Heads of tables that are only a formula get a name in words, such as “phi dot”: programs that read a page aloud take a cell
//! with MathML alone for an empty one.

use crate::html::{escape, plain};

/// A page whose heads of tables have names.
pub(crate) fn with_named_heads(page: &str) -> String {
    const HEAD: &str = "<th";
    let mut parts = page.split(HEAD);
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        out.push_str(HEAD);
        let cell = part.find("</th>").map(|end| &part[..end]);
        let inner = cell.filter(|cell| cell.starts_with([' ', '>'])).and_then(|cell| cell.split_once('>'));
        if let Some((attributes, inner)) = inner
            && !attributes.contains("aria-label=")
            && let Some(name) = name(inner)
        {
            out.push_str(&format!(" aria-label=\"{}\"", escape(&name)));
        }
        out.push_str(part);
    }
    out
}

/// The name of a cell that holds formulas and no words.
fn name(cell: &str) -> Option<String> {
    let (mut rest, mut words, mut outside) = (cell, String::new(), String::new());
    while let Some((before, behind)) = rest.split_once("<math") {
        let (formula, after) = behind.split_once("</math>")?;
        outside.push_str(before);
        words.push_str(&plain(before));
        words.push_str(&format!(" {} ", speak(formula.split_once('>')?.1)));
        rest = after;
    }
    outside.push_str(rest);
    words.push_str(&plain(rest));
    let has_formula = outside.len() < cell.len();
    let words = words.split_whitespace().collect::<Vec<_>>().join(" ").replace(" ,", ",");
    (has_formula && !plain(&outside).contains(char::is_alphanumeric) && !words.is_empty()).then_some(words)
}

/// What is inside a `math` element, in words.
fn speak(inner: &str) -> String {
    let parts = elements(&mut { inner }).into_iter();
    parts.filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" ")
}

/// The elements up to the end of the one around them, each in words. What is read is taken off the text.
fn elements(rest: &mut &str) -> Vec<String> {
    let mut found = Vec::new();
    while let Some((text, (tag, behind))) =
        rest.split_once('<').and_then(|(text, tag)| Some((text, tag.split_once('>')?)))
    {
        *rest = behind;
        let name = tag.split([' ', '/']).next().unwrap_or_default();
        if tag.starts_with('/') {
            if found.is_empty() {
                found.push(sign(&plain(text)));
            }
            return found;
        }
        let parts = if tag.ends_with('/') { Vec::new() } else { elements(rest) };
        found.push(element(name, &parts));
    }
    found
}

/// An element, whose parts are in words.
fn element(name: &str, parts: &[String]) -> String {
    match (name, parts) {
        ("msub" | "munder", [of, index]) => format!("{of} sub {index}"),
        ("msup", [of, power]) => speak_power(of, power),
        ("msubsup" | "munderover", [of, index, power]) => speak_power(&format!("{of} sub {index}"), power),
        ("mover", [of, over]) => match over.as_str() {
            "→" | "⃗" => format!("vector {of}"),
            "˙" | "." => format!("{of} dot"),
            "¨" => format!("{of} double dot"),
            "¯" | "‾" | "―" => format!("{of} bar"),
            "^" | "ˆ" => format!("{of} hat"),
            over => format!("{of} {over}"),
        },
        ("mfrac", [over, under]) => format!("{over} over {under}"),
        ("msqrt", parts) => format!("root of {}", parts.join(" ")),
        _ => parts.iter().filter(|part| !part.is_empty()).cloned().collect::<Vec<_>>().join(" "),
    }
}

fn speak_power(of: &str, power: &str) -> String {
    match power {
        "2" => format!("{of} squared"),
        "∘" => format!("{of} degrees"),
        "prime" => format!("{of} prime"),
        // A letter above may be an exponent or, as that of a normal acceleration, a name.
        power => format!("{of} superscript {power}"),
    }
}

/// A letter or an operator in words. Letters of the Latin alphabet and numbers are themselves.
fn sign(text: &str) -> String {
    const GREEK: [&str; 25] = [
        "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu",
        "xi", "omicron", "pi", "rho", "sigma", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega",
    ];
    const SIGNS: [(&str, &str); 23] = [
        ("=", "equals"),
        ("+", "plus"),
        ("−", "minus"),
        ("±", "plus or minus"),
        ("·", "times"),
        ("×", "times"),
        ("/", "over"),
        ("<", "less than"),
        (">", "greater than"),
        ("≤", "at most"),
        ("≥", "at least"),
        ("′", "prime"),
        ("∞", "infinity"),
        ("↻", "clockwise arrow"),
        ("↙", "arrow down to the left"),
        ("↘", "arrow down to the right"),
        ("ϑ", "theta"),
        ("ϕ", "phi"),
        ("ϵ", "epsilon"),
        ("(", ""),
        (")", ""),
        ("|", ""),
        ("\u{2062}", ""),
    ];
    if let Some((_, word)) = SIGNS.iter().find(|(sign, _)| *sign == text) {
        return (*word).to_owned();
    }
    let mut characters = text.chars();
    let greek = |c: char, first: char| {
        u32::from(c).checked_sub(u32::from(first)).and_then(|at| GREEK.get(at as usize)).map(|name| (*name).to_owned())
    };
    match (characters.next(), characters.next()) {
        (Some(c), None) => greek(c, 'α').or_else(|| greek(c, 'Α').map(|name| format!("capital {name}"))),
        _ => None,
    }
    .unwrap_or_else(|| text.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::formula;

    #[test]
    fn a_formula_is_said_in_words() {
        let said = |tex: &str| name(&formula(tex, false).expect("a formula")).expect("a name");
        let cases = [
            ("R", "R"),
            (r"\mu", "mu"),
            (r"\Omega", "capital omega"),
            (r"\dot\varphi", "phi dot"),
            (r"\ddot\varphi", "phi double dot"),
            (r"v_\mathrm{rel}", "v sub rel"),
            (r"\vec{a}_2", "vector a sub 2"),
            (r"\omega_2^2", "omega sub 2 squared"),
            (r"a_2^\mathrm{n}", "a sub 2 superscript n"),
            ("P'", "P prime"),
            (r"\frac{I_D}{I_f}", "I sub D over I sub f"),
            (r"\sqrt{2} R", "root of 2 R"),
            (r"N = 6", "N equals 6"),
        ];
        for (tex, words) in cases {
            assert_eq!(said(tex), words, "{tex}");
        }
    }

    #[test]
    fn only_a_head_without_words_gets_a_name() {
        let math = formula(r"\mu", false).expect("a formula");
        let page = format!(
            "<thead><tr><th scope=\"col\">a</th></tr></thead><tr><th scope=\"row\">{math}</th><th>{math}, {math}</th><th>{math} in \
             mm</th><th></th><td>{math}</td></tr>"
        );
        let named = with_named_heads(&page);
        assert_eq!(named.matches("aria-label").count(), 2, "{named}");
        assert!(named.contains("<th aria-label=\"mu\" scope=\"row\">") && named.contains("<th aria-label=\"mu, mu\">"));
        assert_eq!(named.replace(" aria-label=\"mu\"", "").replace(" aria-label=\"mu, mu\"", ""), page);
        assert_eq!(with_named_heads(&named), named);
    }
}
