//! What single commands of TeX stand for, and how scripts and upright letters join what is before them.

use crate::token::{MathFunction, Span, Token, TokenKind};

/// Commands that make one sign of a unit, without their backslash.
const UNIT_SIGNS: [(&str, char); 13] = [
    ("Omega", 'Ω'),
    ("ohm", 'Ω'),
    ("Ohm", 'Ω'),
    ("textohm", 'Ω'),
    ("mu", 'μ'),
    ("micro", 'μ'),
    ("textmu", 'μ'),
    ("upmu", 'μ'),
    ("AA", 'Å'),
    ("angstrom", 'Å'),
    ("degree", '°'),
    ("textdegree", '°'),
    ("%", '%'),
];

/// The sign of a unit that a command of this name makes.
pub(crate) fn unit_sign(name: &str) -> Option<char> {
    UNIT_SIGNS.iter().find(|(known, _)| *known == name).map(|(_, sign)| *sign)
}

/// A command without arguments.
pub(crate) fn symbol(name: &str) -> TokenKind {
    const GREEK: &str = "alpha α beta β gamma γ delta δ epsilon ε varepsilon ε zeta ζ eta η theta θ vartheta θ iota ι kappa κ \
        lambda λ nu ν xi ξ pi π rho ρ varrho ρ sigma σ tau τ upsilon υ phi φ varphi φ chi χ psi ψ omega ω Gamma Γ Delta Δ \
        Theta Θ Lambda Λ Xi Ξ Pi Π Sigma Σ Phi Φ Psi Ψ uppi π uplambda λ uprho ρ upalpha α upbeta β upgamma γ hbar ℏ ell ℓ infty ∞";
    let mut greek = GREEK.split_ascii_whitespace();
    while let (Some(known), Some(letter)) = (greek.next(), greek.next()) {
        if known == name {
            return TokenKind::Name(letter.to_owned());
        }
    }
    if let Some(sign) = unit_sign(name) {
        // The Greek letters may be quantities, too.
        let letter = matches!(name, "Omega" | "mu" | "micro" | "textmu" | "upmu");
        return if letter { TokenKind::Name(sign.to_string()) } else { TokenKind::Word(sign.to_string()) };
    }
    if let Some(function) = MathFunction::from_name(name) {
        return TokenKind::Function(function);
    }
    TokenKind::Operator(match name {
        "times" => '×',
        "cdot" | "cdotp" | "bullet" | "ast" => '·',
        "div" | "slash" => '/',
        "pm" => '±',
        "mp" => '∓',
        "approx" | "cong" | "simeq" | "thickapprox" | "doteq" | "approxeq" | "fallingdotseq" => '≈',
        "Rightarrow" | "implies" | "therefore" | "Longrightarrow" | "Leftrightarrow" | "iff" => '⇒',
        // Short names that texts give to arrows, and define somewhere else.
        "Ra" | "RA" | "Rarr" | "rArr" | "Lra" | "LRa" | "LRA" | "imp" | "impl" | "Implies" | "folgt" => '⇒',
        "to" | "rightarrow" | "longrightarrow" | "mapsto" | "ra" | "rarr" | "lra" | "longto" => '→',
        "ne" | "neq" => '≠',
        "in" | "isin" => '∈',
        "notin" => '∉',
        "sim" => '∼',
        "equiv" => '≡',
        "le" | "leq" | "leqslant" | "lt" | "ll" | "lesssim" => '<',
        "ge" | "geq" | "geqslant" | "gt" | "gg" | "gtrsim" | "propto" | "mid" | "leftrightarrow" => '>',
        "lvert" | "rvert" | "vert" => '|',
        "lparen" => '(',
        "rparen" => ')',
        "surd" => '√',
        "lfloor" | "llbracket" => '⌊',
        "rfloor" | "rrbracket" => '⌋',
        "lceil" => '⌈',
        "rceil" => '⌉',
        "lbrace" => '{',
        "rbrace" => '}',
        "lbrack" => '[',
        "rbrack" => ']',
        "prime" => '′',
        "odot" | "sun" | "astrosun" => '⊙',
        "sum" => '∑',
        "prod" => '∏',
        "int" | "oint" | "iint" => '∫',
        "colon" => ':',
        "because" => '∵',
        "forall" => '∀',
        "dots" | "ldots" | "cdots" | "vdots" | "ddots" => return TokenKind::Unknown("…".to_owned()),
        "textdollar" => return TokenKind::Word("$".to_owned()),
        "euro" | "texteuro" => return TokenKind::Word("€".to_owned()),
        "pounds" | "textsterling" => return TokenKind::Word("£".to_owned()),
        _ => return TokenKind::Unknown(format!("\\{name}")),
    })
}

/// The sign with a number in the package pifont, of which only the two crosses are known.
pub(crate) fn pifont_sign(number: &str) -> TokenKind {
    match number {
        "55" | "56" => TokenKind::Operator('✗'),
        _ => TokenKind::Unknown("\\ding".to_owned()),
    }
}

/// Upright letters, each read by itself, as words.
pub(crate) fn merge_letters(tokens: Vec<Token>, out: &mut Vec<Token>) {
    let mut joined = false;
    for mut next in tokens {
        if let TokenKind::Scripts(base, sub, sup) = &mut next.kind
            && sub.is_empty()
        {
            let mut words = Vec::new();
            merge_letters(std::mem::take(base), &mut words);
            // The last letter of a word has the exponent.
            if joined
                && let (
                    [Token { kind: TokenKind::Word(letter), .. }],
                    Some(Token { kind: TokenKind::Word(before), span, .. }),
                ) = (words.as_slice(), out.last_mut())
                && letter.chars().all(char::is_alphabetic)
            {
                before.push_str(letter);
                *span = span.join(next.span);
                let sup = std::mem::take(sup);
                out.push(Token::new(TokenKind::Scripts(Vec::new(), Vec::new(), sup), next.span));
                joined = false;
                continue;
            }
            *base = words;
            out.push(next);
            joined = false;
            continue;
        }
        match next.kind {
            TokenKind::Name(letter) if letter.chars().all(|c| c.is_alphabetic()) => {
                if joined && let Some(Token { kind: TokenKind::Word(before), span, .. }) = out.last_mut() {
                    before.push_str(&letter);
                    *span = span.join(next.span);
                    continue;
                }
                out.push(Token::new(TokenKind::Word(letter), next.span));
                joined = true;
            }
            TokenKind::Group(inner) => {
                merge_letters(inner, out);
                joined = false;
            }
            TokenKind::Fraction(a, b) => {
                let (mut above, mut below) = (Vec::new(), Vec::new());
                merge_letters(a, &mut above);
                merge_letters(b, &mut below);
                out.push(Token::new(TokenKind::Fraction(above, below), next.span));
                joined = false;
            }
            kind => {
                joined = false;
                out.push(Token::new(kind, next.span));
            }
        }
    }
}

/// Gives a script to the last token that is no space.
pub(crate) fn attach_script(out: &mut Vec<Token>, above: bool, script: Vec<Token>, span: Span) {
    while out.last().is_some_and(Token::is_space) {
        out.pop();
    }
    let script_span = script.iter().fold(span, |sum, token| sum.join(token.span));
    let Some(last) = out.pop() else {
        let (sub, sup) = if above { (Vec::new(), script) } else { (script, Vec::new()) };
        out.push(Token::new(TokenKind::Scripts(Vec::new(), sub, sup), script_span));
        return;
    };
    let whole = last.span.join(script_span);
    let kind = match last.kind {
        TokenKind::Scripts(base, sub, sup) if above && sup.is_empty() => TokenKind::Scripts(base, sub, script),
        TokenKind::Scripts(base, sub, sup) if !above && sub.is_empty() => TokenKind::Scripts(base, script, sup),
        TokenKind::Group(inner) if above => {
            TokenKind::Scripts(vec![Token::new(TokenKind::Group(inner), last.span)], Vec::new(), script)
        }
        TokenKind::Group(inner) => TokenKind::Scripts(inner, script, Vec::new()),
        kind if above => TokenKind::Scripts(vec![Token::new(kind, last.span)], Vec::new(), script),
        kind => TokenKind::Scripts(vec![Token::new(kind, last.span)], script, Vec::new()),
    };
    out.push(Token::new(kind, whole));
}
