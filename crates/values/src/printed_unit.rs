//! The unit behind a number: as it is written in running text, in TeX and in the package siunitx.

use proofread::unit_named;

/// Skips the space that may part a number from its unit, and the end of a formula: never a blank line.
pub(crate) fn skip_space(text: &str, mut at: usize) -> usize {
    const SPACES: [&str; 12] =
        ["\\,", "\\;", "\\:", "\\!", "\\ ", "\\)", "~", "\u{a0}", "\u{2009}", "\u{202f}", " ", "$"];
    let mut ends_line = false;
    loop {
        let rest = &text[at..];
        if let Some(space) = SPACES.iter().find(|space| rest.starts_with(**space)) {
            at += space.len();
        } else if rest.starts_with('\n') && !ends_line {
            at += 1;
            ends_line = true;
        } else {
            return at;
        }
    }
}

/// The unit in one spelling and the byte behind it; none if what follows is no unit.
pub(crate) fn unit_behind(text: &str, at: usize) -> Option<(String, usize)> {
    // Behind the number of `\SI{…}{…}` or `\qty{…}{…}`.
    if let Some(rest) = text[at..].strip_prefix("}{") {
        let end = rest.bytes().take(200).position(|byte| byte == b'}')?;
        let unit = named_in_macros(rest.get(..end)?)?;
        return Some((unit, at + 2 + end + 1));
    }
    let start = skip_space(text, at);
    let rest = &text[start..];
    for wrapper in ["\\mathrm{", "\\text{", "\\textrm{", "\\unit{", "\\si{", "\\mathsf{", "\\operatorname{", "{\\rm "] {
        if let Some(inner) = rest.strip_prefix(wrapper) {
            let (unit, end) = wrapped(inner)?;
            return Some((unit, start + wrapper.len() + end));
        }
    }
    bare(text, start, at)
}

/// A unit in braces, which may contain others for its powers.
fn wrapped(inner: &str) -> Option<(String, usize)> {
    let mut depth = 1usize;
    let end = inner.bytes().take(200).position(|byte| {
        depth += usize::from(byte == b'{');
        depth -= usize::from(byte == b'}');
        depth == 0
    })?;
    let source = &inner[..end];
    let unit = if source.contains('\\') { named_in_macros(source) } else { None };
    let unit = unit.or_else(|| known(&spelled(source)))?;
    Some((unit, end + 1))
}

/// A unit in running text.
fn bare(text: &str, start: usize, number_end: usize) -> Option<(String, usize)> {
    let rest = &text[start..];
    const SIGNS: [(&str, &str); 12] = [
        ("\\%", "%"),
        ("%", "%"),
        ("per cent", "%"),
        ("percent", "%"),
        ("^\\circ\\mathrm{C}", "°C"),
        ("^{\\circ}", "°"),
        ("^\\circ", "°"),
        ("\\degree", "°"),
        ("°C", "°C"),
        ("°F", "°F"),
        ("°", "°"),
        ("º", "°"),
    ];
    let letter = |c: char| c.is_alphabetic();
    for (sign, unit) in SIGNS {
        if rest.starts_with(sign) && !(sign.ends_with(letter) && rest[sign.len()..].starts_with(letter)) {
            return Some((unit.to_owned(), start + sign.len()));
        }
    }
    let (mut end, mut kept) = (start, None);
    // Product after product, as long as it is a unit.
    while let Some(next) = word_end(text, end) {
        let source = &text[start..next];
        let Some(unit) = known(&spelled(source)) else { break };
        let is_first = kept.is_none();
        if is_first && is_prose(text, source, next, start == number_end) {
            break;
        }
        kept = Some((unit, next));
        let behind = &text[next..];
        let joint = ["/", "·", "⋅", "\\cdot ", "\\,"].iter().find(|joint| behind.starts_with(**joint));
        let joint = match joint {
            Some(joint) => joint.len(),
            // Words go on behind a space only with a power: `kg m^2`.
            None if behind.starts_with(' ') && has_power(text, next + 1) => 1,
            None => break,
        };
        end = next + joint;
    }
    kept
}

/// The byte behind one unit and its power.
fn word_end(text: &str, at: usize) -> Option<usize> {
    let is_of_name = |c: char| c.is_alphabetic() || matches!(c, '°' | 'ℓ' | '⊙');
    let rest = &text[at..];
    let name = rest.find(|c| !is_of_name(c)).unwrap_or(rest.len());
    if name == 0 || name > 20 {
        return None;
    }
    let behind = &rest[name..];
    let power = if let Some(raised) = behind.strip_prefix('^') {
        let closes = raised.starts_with(['{', '(']);
        let length = raised.bytes().skip(usize::from(closes)).take_while(|b| b.is_ascii_digit() || *b == b'-').count();
        1 + length + 2 * usize::from(closes)
    } else {
        behind.chars().take_while(|c| "⁻¹²³⁴".contains(*c)).map(char::len_utf8).sum()
    };
    let end = at + name + power;
    text.is_char_boundary(end).then_some(end)
}

fn has_power(text: &str, at: usize) -> bool {
    let rest = &text[at..];
    let name = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
    (1..=5).contains(&name) && rest[name..].starts_with(['^', '⁻', '²', '³'])
}

/// Whether letters behind a number are rather a word: things that are counted, or the preposition `in`.
fn is_prose(text: &str, word: &str, end: usize, touches: bool) -> bool {
    const ANGLES: [&str; 4] = ["rad", "sr", "ppm", "dB"];
    let rest = &text[end..];
    let goes_on = rest.strip_prefix([' ', '\n']).is_some_and(|next| next.starts_with(|c: char| c.is_alphabetic()));
    let is_counted = unit_named(word).is_some_and(|unit| {
        unit.factor == 1.0 && unit.dimension == proofread::UnitDimension::NONE && !ANGLES.contains(&word)
    });
    let is_cut = rest.starts_with(|c: char| c.is_alphanumeric() || c == '_');
    let is_symbol = touches && word == "x";
    is_counted || is_cut || is_symbol || (matches!(word, "in" | "a" | "e" | "d" | "b" | "u" | "y") && goes_on)
}

/// One spelling for the signs of a unit.
fn spelled(source: &str) -> String {
    let mut out = String::with_capacity(source.len());
    let source = source.replace("\\,", "·").replace("\\cdot", "·").replace('~', "·");
    for c in source.trim().chars() {
        match c {
            'µ' => out.push('μ'),
            '²' => out.push_str("^2"),
            '³' => out.push_str("^3"),
            '⁻' => out.push_str("^-"),
            '¹' => out.push('1'),
            '⋅' | ' ' => out.push('·'),
            '−' => out.push('-'),
            '{' | '}' | '(' | ')' => {}
            c => out.push(c),
        }
    }
    // A raised minus comes before its digit, which is raised as well.
    out.replace("^-^", "^-").replace("··", "·")
}

fn known(unit: &str) -> Option<String> {
    let unit = unit.replace("\\%", "%").replace("^\\circ", "°");
    unit_named(&unit.replace('·', " ")).map(|_| unit)
}

/// A unit in one spelling, as a file of values gives it; none if it isn't known.
pub(crate) fn unit_in_one_spelling(unit: &str) -> Option<String> {
    known(&spelled(unit))
}

/// A unit in the words of siunitx, or as letters.
fn named_in_macros(source: &str) -> Option<String> {
    const NAMES: [(&str, &str); 31] = [
        ("metre", "m"),
        ("meter", "m"),
        ("gram", "g"),
        ("kilogram", "kg"),
        ("second", "s"),
        ("ampere", "A"),
        ("kelvin", "K"),
        ("mole", "mol"),
        ("newton", "N"),
        ("joule", "J"),
        ("watt", "W"),
        ("pascal", "Pa"),
        ("hertz", "Hz"),
        ("coulomb", "C"),
        ("volt", "V"),
        ("ohm", "Ω"),
        ("farad", "F"),
        ("tesla", "T"),
        ("henry", "H"),
        ("litre", "L"),
        ("liter", "L"),
        ("bar", "bar"),
        ("electronvolt", "eV"),
        ("minute", "min"),
        ("hour", "h"),
        ("day", "d"),
        ("degree", "°"),
        ("degreeCelsius", "°C"),
        ("celsius", "°C"),
        ("percent", "%"),
        ("radian", "rad"),
    ];
    const PREFIXES: [(&str, &str); 10] = [
        ("kilo", "k"),
        ("mega", "M"),
        ("giga", "G"),
        ("centi", "c"),
        ("deci", "d"),
        ("milli", "m"),
        ("micro", "μ"),
        ("nano", "n"),
        ("pico", "p"),
        ("hecto", "h"),
    ];
    if !source.contains('\\') {
        return known(&spelled(source));
    }
    let (mut out, mut prefix) = (String::new(), "");
    let mut divides = false;
    for name in source.split('\\').map(str::trim).filter(|name| !name.is_empty()) {
        if let Some((_, sign)) = PREFIXES.iter().find(|(known, _)| *known == name) {
            prefix = sign;
        } else if name == "per" {
            divides = true;
        } else if let Some(power) = ["squared", "cubed"].iter().position(|known| *known == name) {
            out += ["^2", "^3"][power];
        } else {
            let (_, sign) = NAMES.iter().find(|(known, _)| *known == name)?;
            if !out.is_empty() {
                out += if divides { "/" } else { "·" };
            }
            out += prefix;
            out += sign;
            (prefix, divides) = ("", false);
        }
    }
    known(&out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read_in_every_notation() {
        let read = |text: &str| unit_behind(text, 0).map(|(unit, _)| unit).unwrap_or_default();
        for (text, unit) in [
            (" s at", "s"),
            ("\\,\\mathrm{s}$", "s"),
            ("$ m/s\u{b2}.", "m/s^2"),
            (" m/s^2,", "m/s^2"),
            ("\\,\\mathrm{m\\,s^{-2}}", "m·s^-2"),
            ("}{\\milli\\second}", "ms"),
            ("}{\\metre\\per\\second\\squared}", "m/s^2"),
            ("\\% of", "%"),
            (" per cent", "%"),
            ("°, so", "°"),
            ("^\\circ$", "°"),
            (" kg m^2 and", "kg·m^2"),
            ("\u{2009}µm", "μm"),
            (" in the", ""),
            (" in.", "in"),
            (" people", ""),
            (" mother", ""),
            ("\n\ns", ""),
        ] {
            assert_eq!(read(text), unit, "{text:?}");
        }
    }
}
