//! TeX cut to pieces: commands, letters, numbers, signs.

/// A piece of a formula, and where in the formula it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Its characters. Bars behind `\left` and `\right` are told apart from plain ones.
    pub text: String,
    /// The byte at which it starts, with the command for its size if it is a bracket.
    pub start: usize,
    /// The byte behind it.
    pub end: usize,
}

/// The pieces of a formula, in order. Blanks, spacing and the sizes of brackets are dropped.
pub fn pieces(tex: &str) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let (mut at, mut sized) = (0, None);
    while let Some(c) = tex[at..].chars().next() {
        let start = at;
        let run = |from: usize, is: fn(char) -> bool| from + tex[from..].find(|c| !is(c)).unwrap_or(tex.len() - from);
        at = match c {
            // An environment's name belongs to its beginning and its end.
            '\\' if tex[at..].starts_with(r"\begin{") || tex[at..].starts_with(r"\end{") => run(at, |c| c != '}') + 1,
            // A full stop is the bracket that is not there.
            '\\' if tex[at..].starts_with(r"\left.") => at + r"\left.".len(),
            '\\' if tex[at..].starts_with(r"\right.") => at + r"\right.".len(),
            '\\' => {
                let next = tex[at + 1..].chars().next().map_or(0, char::len_utf8);
                run(at + 1, |c| c.is_ascii_alphabetic()).max(at + 1 + next)
            }
            // A single figure is an argument of its own, so `\frac12` is a half.
            c if c.is_ascii_digit() && is_bare_argument(&pieces) => at + 1,
            c if c.is_ascii_digit() => run(at, |c| c.is_ascii_digit() || c == '.'),
            c => at + c.len_utf8(),
        };
        at = at.min(tex.len());
        match &tex[start..at] {
            r"\," | r"\;" | r"\:" | r"\!" | r"\ " | "~" | r"\left." | r"\right." => {}
            size @ (r"\left" | r"\right") => sized = Some((start, size)),
            piece if piece.trim().is_empty() => {}
            piece => {
                // A bracket starts where its size is said.
                let (start, size) = sized.take().unwrap_or((start, ""));
                let text = match (size, piece) {
                    (_, r"\lvert") => r"\left|".to_owned(),
                    (_, r"\rvert") => r"\right|".to_owned(),
                    (size, "|") => format!("{size}|"),
                    _ => piece.to_owned(),
                };
                pieces.push(Piece { text, start, end: at });
            }
        }
    }
    pieces
}

/// Whether a command has an argument still to come that has no braces.
fn is_bare_argument(pieces: &[Piece]) -> bool {
    let Some(last) = pieces.last() else { return false };
    let is_fraction = |back: usize| {
        let piece = pieces.len().checked_sub(back).map(|at| pieces[at].text.as_str());
        piece == Some(r"\frac") || piece == Some(r"\tfrac")
    };
    ["^", "_"].contains(&last.text.as_str())
        || is_fraction(1)
        || (is_fraction(2) && last.text.chars().all(|c| c.is_ascii_digit()))
}

/// The commands that stand for letters.
pub const GREEK: &[&str] = &[
    r"\alpha", r"\beta", r"\gamma", r"\delta", r"\theta", r"\lambda", r"\mu", r"\nu", r"\rho", r"\tau", r"\phi",
    r"\varphi", r"\psi", r"\omega", r"\ldots", r"\sigma", r"\kappa",
];

impl Piece {
    /// Whether it is a letter of either alphabet.
    pub fn is_letter(&self) -> bool {
        let mut characters = self.text.chars();
        let single = characters.next().is_some_and(char::is_alphabetic) && characters.next().is_none();
        single || GREEK.contains(&self.text.as_str())
    }

    /// Whether it is a whole number.
    pub fn is_whole_number(&self) -> bool {
        self.text.chars().all(|c| c.is_ascii_digit())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(tex: &str) -> Vec<String> {
        pieces(tex).into_iter().map(|piece| piece.text).collect()
    }

    #[test]
    fn formulas_are_cut_where_their_pieces_end() {
        assert_eq!(cut(r"\frac12a\,x_n"), [r"\frac", "1", "2", "a", "x", "_", "n"]);
        assert_eq!(cut(r"\left| -12.5 \right|"), [r"\left|", "-", "12.5", r"\right|"]);
        assert_eq!(cut(r"\left. \left\{ x^23"), [r"\{", "x", "^", "2", "3"]);
        assert_eq!(cut(r"\begin{aligned} a &= |b| \\ \end{aligned}").len(), 9);
        assert_eq!(cut("2DX = µ"), ["2", "D", "X", "=", "µ"]);
    }

    #[test]
    fn a_piece_knows_where_it_stands() {
        let tex = r"\left[\frac{I_f}{2} \right] \theta";
        for piece in pieces(tex) {
            let whole = &tex[piece.start..piece.end];
            assert!(whole == piece.text || [r"\left[", r"\right]"].contains(&whole), "{whole} for {}", piece.text);
        }
    }
}
