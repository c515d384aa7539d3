//! TeX cut to pieces: commands, letters, numbers, signs. Blanks and spacing are dropped.

/// The pieces of a formula, in order.
pub fn pieces(tex: &str) -> Vec<String> {
    let mut pieces: Vec<String> = Vec::new();
    let characters: Vec<char> = tex.chars().collect();
    let mut at = 0;
    while at < characters.len() {
        let run =
            |start: usize, is: fn(&char) -> bool| start + characters[start..].iter().take_while(|c| is(c)).count();
        let start = at;
        at = match characters[at] {
            // An environment's name belongs to its beginning and its end.
            '\\' if starts(&characters[at..], r"\begin{") || starts(&characters[at..], r"\end{") => {
                (run(at, |c| *c != '}') + 1).min(characters.len())
            }
            '\\' => run(at + 1, char::is_ascii_alphabetic).max(at + 2).min(characters.len()),
            // A single figure is an argument of its own, so `\frac12` is a half.
            c if c.is_ascii_digit() && is_bare_argument(&pieces) => at + 1,
            c if c.is_ascii_digit() => run(at, |c| c.is_ascii_digit() || *c == '.'),
            _ => at + 1,
        };
        let piece: String = characters[start..at].iter().collect();
        match piece.as_str() {
            r"\," | r"\;" | r"\:" | r"\!" | r"\ " | "~" | r"\left" | r"\right" => {}
            piece if piece.trim().is_empty() => {}
            r"\lvert" => pieces.push(r"\left|".into()),
            r"\rvert" => pieces.push(r"\right|".into()),
            "|" if before(&characters, start, r"\left") => pieces.push(r"\left|".into()),
            "|" if before(&characters, start, r"\right") => pieces.push(r"\right|".into()),
            piece => pieces.push(piece.to_owned()),
        }
    }
    pieces
}

/// Whether a command has an argument still to come that has no braces.
fn is_bare_argument(pieces: &[String]) -> bool {
    let Some(last) = pieces.last() else { return false };
    let is_fraction = |back: usize| {
        let piece = pieces.len().checked_sub(back).map(|at| pieces[at].as_str());
        piece == Some(r"\frac") || piece == Some(r"\tfrac")
    };
    last == "^" || last == "_" || is_fraction(1) || (is_fraction(2) && last.chars().all(|c| c.is_ascii_digit()))
}

fn starts(characters: &[char], with: &str) -> bool {
    with.chars().enumerate().all(|(at, c)| characters.get(at) == Some(&c))
}

fn before(characters: &[char], at: usize, command: &str) -> bool {
    let behind: String = characters[..at].iter().collect();
    behind.trim_end().ends_with(command)
}
