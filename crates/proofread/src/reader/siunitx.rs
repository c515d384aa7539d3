//! Numbers and units of the LaTeX package siunitx.

use super::definitions::Macros;
use super::words::{span_of_chars, tokenise_words};
use crate::token::{SourceChar, Token, TokenKind};
use crate::unit::takes_prefix;

/// A number with its exponent behind `e`.
pub(crate) fn number(signs: &[SourceChar], out: &mut Vec<Token>) {
    let exponent = signs.iter().position(|sign| matches!(sign.c, 'e' | 'E' | 'd' | 'D'));
    let (mantissa, exponent) = signs.split_at(exponent.unwrap_or(signs.len()));
    // Groups of digits may be parted by spaces or braces, and the uncertainty of the last digits stands in brackets.
    let uncertain = mantissa.iter().skip(1).position(|sign| sign.c == '(').map_or(mantissa.len(), |at| at + 1);
    let closes = mantissa.last().is_some_and(|sign| sign.c == ')');
    let mantissa = if closes { &mantissa[..uncertain] } else { mantissa };
    let mantissa: Vec<SourceChar> =
        mantissa.iter().filter(|sign| !sign.c.is_whitespace() && !"{}~_".contains(sign.c)).copied().collect();
    // A comma is the sign of decimals in this package, too.
    let comma = mantissa.iter().filter(|sign| sign.c == ',').count() == 1 && mantissa.iter().all(|sign| sign.c != '.');
    let point = |sign: SourceChar| if comma && sign.c == ',' { SourceChar { c: '.', ..sign } } else { sign };
    let mantissa: Vec<SourceChar> = mantissa.into_iter().map(point).collect();
    tokenise_words(&mantissa, out);
    let [e, power @ ..] = exponent else { return };
    let span = e.span;
    if !mantissa.is_empty() {
        out.push(Token::new(TokenKind::Operator('×'), span));
    }
    out.push(Token::new(TokenKind::Number("10".to_owned()), span));
    let mut raised = Vec::new();
    tokenise_words(power, &mut raised);
    out.push(Token::new(TokenKind::Scripts(Vec::new(), Vec::new(), raised), span_of_chars(power)));
}

/// Units with those that the document names itself written out, a few times over if they name each other.
pub(crate) fn expand_named_units(mut signs: Vec<SourceChar>, macros: &Macros<'_>) -> Vec<SourceChar> {
    /// Most signs of a unit that is written out; the names of one may be as long as those of any macro.
    const MOST: usize = 1000;
    for _ in 0..4 {
        let (mut out, mut at) = (Vec::new(), 0);
        while let Some(sign) = signs.get(at) {
            if out.len() > MOST {
                return vec![SourceChar { c: '?', span: sign.span }];
            }
            let (name, end) = name_at(&signs, at);
            let named = macros.in_quantity(&name).filter(|of| of.arguments == 0 && !is_known(&name));
            let body = named.map(|of| of.body.trim()).filter(|body| !body.contains("circ"));
            // Beside a prefix, a power or a stroke one unit is meant, and several in its place would be another thing.
            let alone = at == 0 && end == signs.len();
            match body {
                Some(body) if alone || body.strip_prefix('\\').is_some_and(is_letters) => write(body, sign, &mut out),
                // Several units in the place of one.
                Some(body) if unit_letters(body).is_none() => write("?", sign, &mut out),
                _ => out.extend(&signs[at..end]),
            }
            at = end;
        }
        signs = out;
    }
    signs
}

/// The name of the command at a place, empty if there is none, and the place behind it.
fn name_at(signs: &[SourceChar], at: usize) -> (String, usize) {
    let name: String = match signs[at].c {
        '\\' => signs[at + 1..].iter().map(|sign| sign.c).take_while(char::is_ascii_alphabetic).collect(),
        _ => String::new(),
    };
    let end = at + 1 + name.len();
    (name, end)
}

fn is_letters(text: &str) -> bool {
    text.bytes().all(|c| c.is_ascii_alphabetic())
}

/// Whether a name is a word of siunitx, whatever else a document does with it.
fn is_known(name: &str) -> bool {
    const WORDS: [&str; 8] = ["per", "square", "cubic", "squared", "cubed", "tothe", "raiseto", "of"];
    WORDS.contains(&name) || prefix_of(name).is_some() || !sign_of(name).is_empty()
}

/// The letters of a unit that are all of a definition, such as `\textsc{atm}`.
fn unit_letters(body: &str) -> Option<&str> {
    let inner = ["\\mathrm{", "\\text{", "\\textsc{"].iter().find_map(|command| body.strip_prefix(command));
    let letters = inner.map_or(body, |inner| inner.trim_end_matches('}'));
    is_letters(letters).then_some(letters)
}

/// Units in words with backslashes, such as `\kilo\metre\per\second\squared`, as plain TeX.
pub(crate) fn unit(signs: &[SourceChar], macros: &Macros<'_>) -> Vec<SourceChar> {
    unit_within(signs, macros, MOST_QUOTIENTS)
}

/// Most quotients of units inside each other.
const MOST_QUOTIENTS: u8 = 2;

fn unit_within(signs: &[SourceChar], macros: &Macros<'_>, quotients: u8) -> Vec<SourceChar> {
    let mut out: Vec<SourceChar> = Vec::new();
    let mut at = 0;
    let mut below = false;
    let mut prefix = "";
    let mut power = String::new();
    while let Some(sign) = signs.get(at) {
        if sign.c != '\\' {
            // A point or a tilde is a product; the rest is as in any formula.
            let c = if matches!(sign.c, '.' | '~') { ' ' } else { sign.c };
            if !prefix.is_empty() && !c.is_whitespace() {
                write(std::mem::take(&mut prefix), sign, &mut out);
            }
            if c == ' ' {
                write("\\,", sign, &mut out);
            } else {
                out.push(SourceChar { c, ..*sign });
            }
            at += 1;
            continue;
        }
        let (name, end) = name_at(signs, at);
        at = end.max(at + 2);
        match name.as_str() {
            "per" => below = true,
            "square" => power = "^2".to_owned(),
            "cubic" => power = "^3".to_owned(),
            "squared" => raise("2", sign, &mut out),
            "cubed" => raise("3", sign, &mut out),
            "tothe" | "raiseto" => {
                let (digits, end) = group_digits(signs, at);
                at = end;
                match name.as_str() {
                    "tothe" => raise(&digits, sign, &mut out),
                    _ => power = format!("^{digits}"),
                }
            }
            "of" => at = group_digits(signs, at).1,
            // A quotient of units is written as one, whatever the units in it are called.
            "frac" | "dfrac" | "tfrac" | "nicefrac" | "sfrac" if quotients > 0 => {
                write("\\frac", sign, &mut out);
                for _ in 0..2 {
                    let (inner, end) = group_at(signs, at);
                    at = end;
                    write("{", sign, &mut out);
                    out.append(&mut unit_within(inner, macros, quotients - 1));
                    write("}", sign, &mut out);
                }
            }
            "text" | "mathrm" | "textrm" | "textsc" | "textup" | "textnormal" | "mbox" | "ensuremath" => {}
            name => {
                if let Some(known) = prefix_of(name) {
                    prefix = known;
                    continue;
                }
                // Behind the command of one letter, the sign has a prefix: \m\Omega. So it has behind one that is no unit: k\Omega.
                if name == "Omega"
                    && let [letter] = out.as_slice()
                    && ("kGμ".contains(letter.c) || (at_command(signs, letter) && "Mmn".contains(letter.c)))
                {
                    write("Ω", sign, &mut out);
                    continue;
                }
                // Behind letters that are no command, it may be a product: m\Omega.
                let known = if name == "Omega" && !out.is_empty() { "" } else { sign_of(name) };
                let letters = || macros.in_quantity(name).and_then(|of| unit_letters(of.body.trim()));
                let known = if known.is_empty() { letters().unwrap_or_default() } else { known };
                let known = if known.is_empty() { abbreviated(name) } else { known.to_owned() };
                if !out.is_empty() {
                    write("\\,", sign, &mut out);
                }
                write(prefix, sign, &mut out);
                write(&known, sign, &mut out);
                match (below, power.as_str()) {
                    (false, power) => write(power, sign, &mut out),
                    (true, "") => write("^{-1}", sign, &mut out),
                    (true, power) => write(&format!("^{{-{}}}", power.trim_start_matches('^')), sign, &mut out),
                }
                (below, prefix, power) = (false, "", String::new());
            }
        }
    }
    out
}

/// Whether a character was written for a command: its place is that of the backslash.
fn at_command(signs: &[SourceChar], letter: &SourceChar) -> bool {
    signs.iter().any(|sign| sign.c == '\\' && sign.span == letter.span)
}

/// What the group that begins at `at` has inside it, or the character there, and the place behind it.
fn group_at(signs: &[SourceChar], at: usize) -> (&[SourceChar], usize) {
    let rest = signs.get(at..).unwrap_or_default();
    let space = rest.iter().take_while(|sign| sign.c.is_whitespace()).count();
    let from = at + space;
    let Some(first) = signs.get(from) else { return (&[], signs.len()) };
    if first.c != '{' {
        return (&signs[from..=from], from + 1);
    }
    let mut depth = 0usize;
    for (length, sign) in signs[from..].iter().enumerate() {
        match sign.c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return (&signs[from + 1..from + length], from + length + 1);
        }
    }
    (&signs[from + 1..], signs.len())
}

/// The digits in the group that begins at `at`, and the place behind it.
fn group_digits(signs: &[SourceChar], at: usize) -> (String, usize) {
    let open = signs[at..].iter().take_while(|sign| sign.c.is_whitespace() || sign.c == '{').count();
    let inner: String = signs[at + open..].iter().map(|sign| sign.c).take_while(|c| *c != '}').collect();
    let end = at + open + inner.chars().count() + 1;
    (inner, end.min(signs.len()))
}

/// The unit that an abbreviation such as `\uF` or `\kohm` stands for: itself, with `u` for micro.
fn abbreviated(name: &str) -> String {
    let whole = name.strip_suffix("ohm").map_or(name.to_owned(), |prefix| format!("{prefix}Ω"));
    match whole.strip_prefix('u') {
        Some(rest) if takes_prefix(rest) => format!("μ{rest}"),
        _ => whole,
    }
}

fn write(text: &str, at: &SourceChar, out: &mut Vec<SourceChar>) {
    out.extend(text.chars().map(|c| SourceChar { c, span: at.span }));
}

/// Makes `^{-1}` at the end `^{-2}`, or adds an exponent.
fn raise(power: &str, at: &SourceChar, out: &mut Vec<SourceChar>) {
    let tail: String = out.iter().rev().take(5).map(|sign| sign.c).collect();
    if tail == "}1-{^" {
        out.truncate(out.len() - 5);
        write(&format!("^{{-{power}}}"), at, out);
    } else {
        write(&format!("^{power}"), at, out);
    }
}

fn prefix_of(name: &str) -> Option<&'static str> {
    Some(match name {
        "kilo" => "k",
        "mega" => "M",
        "giga" => "G",
        "tera" => "T",
        "centi" => "c",
        "deci" => "d",
        "hecto" => "h",
        "milli" => "m",
        "micro" => "μ",
        "nano" => "n",
        "pico" => "p",
        "femto" => "f",
        "atto" => "a",
        "peta" => "P",
        "exa" => "E",
        _ => return None,
    })
}

fn sign_of(name: &str) -> &'static str {
    match name {
        "metre" | "meter" => "m",
        "gram" => "g",
        "kilogram" => "kg",
        "second" => "s",
        "ampere" => "A",
        "kelvin" => "K",
        "mole" => "mol",
        "candela" => "cd",
        "newton" => "N",
        "joule" => "J",
        "watt" => "W",
        "pascal" => "Pa",
        "hertz" => "Hz",
        "coulomb" => "C",
        "volt" => "V",
        "ohm" | "Omega" => "Ω",
        "farad" => "F",
        "tesla" => "T",
        "henry" => "H",
        "weber" => "Wb",
        "siemens" => "S",
        "electronvolt" => "eV",
        "litre" | "liter" => "L",
        "degree" => "°",
        "degreeCelsius" | "celsius" => "°C",
        "percent" => "\\%",
        "radian" => "rad",
        "steradian" => "sr",
        "minute" => "min",
        "hour" => "h",
        "day" => "d",
        "becquerel" => "Bq",
        "gray" => "Gy",
        "sievert" => "Sv",
        "tonne" => "t",
        "bar" => "bar",
        "angstrom" => "Å",
        "lumen" => "lm",
        "lux" => "lx",
        "decibel" => "dB",
        "arcsecond" => "arcsec",
        "dalton" | "atomicmassunit" => "u",
        "astronomicalunit" => "au",
        _ => "",
    }
}
