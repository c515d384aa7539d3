//! Names of Typst's math mode, and the elements of MathML that they stand for.

use crate::token::MathFunction;

/// Names of signs.
const SIGNS: [(&str, char); 52] = [
    ("times", '×'),
    ("dot", '·'),
    ("dot.op", '·'),
    ("dot.c", '·'),
    ("ast", '*'),
    ("ast.op", '*'),
    ("div", '÷'),
    ("slash", '/'),
    ("plus", '+'),
    ("minus", '−'),
    ("plus.minus", '±'),
    ("minus.plus", '∓'),
    ("eq", '='),
    ("eq.not", '≠'),
    ("equiv", '≡'),
    ("approx", '≈'),
    ("approx.eq", '≈'),
    ("tilde.op", '∼'),
    ("tilde.eq", '≃'),
    ("lt", '<'),
    ("gt", '>'),
    ("lt.eq", '≤'),
    ("gt.eq", '≥'),
    ("prop", '∝'),
    ("infinity", '∞'),
    ("oo", '∞'),
    ("sum", '∑'),
    ("product", '∏'),
    ("integral", '∫'),
    ("arrow.r", '→'),
    ("arrow", '→'),
    ("arrow.r.double", '⇒'),
    ("arrow.l.r.double", '⇔'),
    ("implies", '⇒'),
    ("iff", '⇔'),
    ("therefore", '∴'),
    ("colon", ':'),
    ("comma", ','),
    ("semi", ';'),
    ("excl", '!'),
    ("bar.v", '|'),
    ("paren.l", '('),
    ("paren.r", ')'),
    ("prime", '′'),
    ("dots", '…'),
    ("dots.h", '…'),
    ("in", '∈'),
    ("partial", '∂'),
    ("nabla", '∇'),
    ("bracket.l", '['),
    ("bracket.r", ']'),
    ("union", '∪'),
];

/// Names of letters that are quantities.
const LETTERS: [(&str, char); 54] = [
    ("CC", 'ℂ'),
    ("FF", '𝔽'),
    ("NN", 'ℕ'),
    ("QQ", 'ℚ'),
    ("RR", 'ℝ'),
    ("ZZ", 'ℤ'),
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("epsilon.alt", 'ϵ'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("theta.alt", 'ϑ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("omicron", 'ο'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("rho.alt", 'ϱ'),
    ("sigma", 'σ'),
    ("sigma.alt", 'ς'),
    ("tau", 'τ'),
    ("upsilon", 'υ'),
    ("phi", 'φ'),
    ("phi.alt", 'ϕ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Alpha", 'Α'),
    ("Beta", 'Β'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Xi", 'Ξ'),
    ("Pi", 'Π'),
    ("Sigma", 'Σ'),
    ("Upsilon", 'Υ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
    ("ell", 'ℓ'),
    ("planck", 'ℎ'),
    ("planck.reduce", 'ℏ'),
    ("hbar", 'ℏ'),
    ("dif", 'd'),
    ("diff", '∂'),
];

/// Names of units and marks.
const UNITS: [(&str, &str); 9] = [
    ("degree", "°"),
    ("degree.c", "°C"),
    ("degree.f", "°F"),
    ("percent", "%"),
    ("permille", "‰"),
    ("angstrom", "Å"),
    ("ohm", "Ω"),
    ("micro", "µ"),
    ("dollar", "$"),
];

/// Names of space, and its width in em.
const SPACES: [(&str, &str); 8] = [
    ("space", "0.25"),
    ("thin", "0.17"),
    ("med", "0.22"),
    ("thick", "0.28"),
    ("quad", "1"),
    ("wide", "2"),
    ("zwj", "0"),
    ("wj", "0"),
];

/// Operators that are printed by their name, beside the functions of a calculator.
const OPERATORS: [&str; 14] =
    ["det", "dim", "lim", "mod", "sup", "inf", "arg", "deg", "ker", "hom", "Pr", "sech", "csch", "coth"];

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Named {
    /// A sign or letter in this element of MathML.
    Sign(&'static str, char),
    /// A unit.
    Unit(&'static str),
    /// Space so wide, in em.
    Space(&'static str),
    /// A function or an operator that is printed by its name.
    Operator,
}

/// What a name stands for; none if it is not known.
pub(super) fn named(name: &str) -> Option<Named> {
    fn find<T: Copy>(of: &[(&str, T)], name: &str) -> Option<T> {
        of.iter().find(|(known, _)| *known == name).map(|(_, of)| *of)
    }
    find(&SIGNS, name)
        .map(|sign| Named::Sign("mo", sign))
        .or_else(|| find(&LETTERS, name).map(|letter| Named::Sign("mi", letter)))
        .or_else(|| find(&UNITS, name).map(Named::Unit))
        .or_else(|| find(&SPACES, name).map(Named::Space))
        .or_else(|| {
            let is_printed = MathFunction::from_name(name).is_some() || OPERATORS.contains(&name);
            is_printed.then_some(Named::Operator)
        })
}

/// The sign, letter or unit of a name, for running text; none for another name, or for a sign that begins or ends a tag.
pub(super) fn sign_named(name: &str) -> Option<String> {
    match named(name)? {
        Named::Sign(_, '<' | '>') => None,
        Named::Sign(_, sign) => Some(sign.to_string()),
        Named::Unit(unit) => Some(unit.to_owned()),
        Named::Space(_) | Named::Operator => None,
    }
}
