//! Commands of TeX that change how their arguments look, or stand for something that is not part of the formula.

use crate::decimal::parse_decimal;
use crate::token::{NamedOperation, Token, TokenKind, span_of};
use std::sync::LazyLock;

/// What a command does with what stands behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FormattingCommand {
    /// Whether arguments in square brackets belong to it.
    pub optional: bool,
    /// How many arguments are not part of the formula.
    pub dropped: usize,
    /// Whether the argument behind them is.
    pub kept: bool,
}

const fn command(optional: bool, dropped: usize, kept: bool) -> FormattingCommand {
    FormattingCommand { optional, dropped, kept }
}

const KNOWN: [(&str, FormattingCommand); 10] = [
    (
        "mathbf boldsymbol mathit mathcal bm mathbb mathscr mathfrak pmb boxed underline ensuremath fbox \
         mathnormal mathrel mathbin mathop mathord mathopen mathclose mathpunct mathinner Aboxed uline uuline dotuline dashuline \
         hl textsl emph sout tcbhighmath mathbfit symbf symbfit symit vcenter",
        command(false, 0, true),
    ),
    ("framebox makebox smash bbox", command(true, 0, true)),
    ("textcolor mathcolor colorbox rotatebox raisebox scalebox parbox", command(true, 1, true)),
    (
        "class cssId style href htmlClass htmlId htmlStyle htmlData foreignlanguage underset overset stackrel",
        command(false, 1, true),
    ),
    ("fcolorbox resizebox", command(true, 2, true)),
    ("tag label ref eqref vspace vphantom require pageref autoref cref Cref index", command(false, 1, false)),
    (
        "color cite citep citet parencite textcite footcite footnote footnotetext todo marginpar hyperref",
        command(true, 1, false),
    ),
    ("rule addtolength setlength setcounter addtocounter fontsize", command(true, 2, false)),
    ("footnotemark", command(true, 0, false)),
    (
        "it bf big Big bigg Bigg bigl bigr Bigl Bigr biggl biggr Biggl Biggr bigm Bigm biggm Biggm displaystyle textstyle limits \
         nolimits scriptstyle scriptscriptstyle nonumber notag noindent hline par allowbreak break nobreak relax middle strut mathstrut null \
         protect centering raggedright large Large LARGE huge Huge small normalsize footnotesize scriptsize tiny bfseries \
         itshape slshape boldmath unboldmath sf tt sl em sc cal mit normalfont selectfont left right mleft mright xspace",
        command(false, 0, false),
    ),
];

/// Each command of the list by its name, in the order of the alphabet: every command of every formula is looked up.
static BY_NAME: LazyLock<Vec<(&str, FormattingCommand)>> = LazyLock::new(|| {
    let mut out: Vec<(&str, FormattingCommand)> = Vec::new();
    for (names, command) in KNOWN {
        for name in names.split_ascii_whitespace() {
            let at = out.partition_point(|(before, _)| *before < name);
            out.insert(at, (name, command));
        }
    }
    out
});

/// What a command does that is no part of the formula itself, if it is known.
pub(crate) fn formatting_command(name: &str) -> Option<FormattingCommand> {
    let at = BY_NAME.binary_search_by(|(known, _)| (*known).cmp(name)).ok()?;
    Some(BY_NAME[at].1)
}

/// The width of `\hspace{2cm}` in tenths of an em, as far as it matters: whether it parts what stands on its sides.
pub(crate) fn space_width(length: &str) -> u8 {
    let length = length.trim();
    let end = length.find(|c: char| c.is_ascii_alphabetic() || c == '\\').unwrap_or(length.len());
    let size = parse_decimal(length[..end].trim()).unwrap_or(1.0);
    let ems = match length[end..].trim() {
        "em" => 1.0,
        "ex" => 0.43,
        "pt" | "bp" => 0.1,
        "mm" => 0.28,
        "cm" => 2.8,
        "in" => 7.2,
        "mu" => 1.0 / 18.0,
        _ => 2.0,
    };
    // Eight tenths are the end of a row that goes on.
    let tenths = (10.0 * size * ems).clamp(0.0, 20.0) as u8;
    if tenths == 8 { 7 } else { tenths }
}

/// The sign that a long arrow or equals sign stands for, whose argument is written above it.
pub(crate) fn long_arrow_sign(name: &str) -> Option<char> {
    Some(match name {
        "xlongequal" => '=',
        name if name.starts_with('x') && (name.ends_with("Rightarrow") || name.ends_with("Leftrightarrow")) => '⇒',
        name if name.starts_with('x')
            && (name.ends_with("arrow") || name.ends_with("harpoons") || name == "xmapsto") =>
        {
            '→'
        }
        _ => return None,
    })
}

/// Fractions and binomial coefficients of what stands before and behind `\over` and `\choose` in a group or cell.
pub(super) fn with_over_fractions(tokens: Vec<Token>) -> Vec<Token> {
    let is_choose = |token: &Token| matches!(&token.kind, TokenKind::Unknown(name) if name == "\\choose");
    let is_over =
        |token: &Token| is_choose(token) || matches!(&token.kind, TokenKind::Unknown(name) if name == "\\over");
    if !tokens.iter().any(is_over) {
        return tokens;
    }
    let ends = |token: &Token| matches!(token.kind, TokenKind::Cell | TokenKind::Line);
    let mut out = Vec::with_capacity(tokens.len());
    for part in tokens.split_inclusive(ends) {
        let (end, part) = match part.split_last() {
            Some((end, rest)) if ends(end) => (Some(end), rest),
            _ => (None, part),
        };
        match part.iter().position(is_over) {
            Some(at) if !part.iter().any(|token| token.is_one_of("=≈")) && !part[at + 1..].iter().any(is_over) => {
                let (above, below) = (part[..at].to_vec(), part[at + 1..].to_vec());
                let kind = if is_choose(&part[at]) {
                    TokenKind::Call(NamedOperation::Binomial, vec![above, below])
                } else {
                    TokenKind::Fraction(above, below)
                };
                out.push(Token::new(kind, span_of(part)));
            }
            _ => out.extend(part.iter().cloned()),
        }
        out.extend(end.cloned());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_space_is_told_from_narrow_space() {
        for (length, wide) in
            [("2cm", true), ("1em", true), ("0.5mm", false), ("2pt", false), ("3mu", false), ("", true)]
        {
            assert_eq!(space_width(length) >= 9, wide, "{length}");
        }
    }

    #[test]
    fn a_command_is_in_one_list_only() {
        let mut names: Vec<&str> = KNOWN.iter().flat_map(|(names, _)| names.split_whitespace()).collect();
        let all = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), all);
    }
}
