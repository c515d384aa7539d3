//! Misprints, made by a rule: each piece of a formula, changed in every way that a slip might change it.

use super::factors::GREEK;
use super::pieces::pieces;

/// A formula with one misprint.
#[derive(Clone, Debug)]
pub struct Mutant {
    pub pieces: Vec<String>,
    /// What was changed, in words.
    pub change: String,
}

/// All misprints of a formula.
pub fn mutants(tex: &str) -> Vec<Mutant> {
    let whole = pieces(tex);
    // The number of a display is not part of what it says.
    let end = whole.iter().position(|piece| piece == r"\tag").unwrap_or(whole.len());
    let mut letters: Vec<&String> = whole[..end].iter().filter(|piece| is_letter(piece)).collect();
    letters.sort();
    letters.dedup();
    let mut found = Vec::new();
    for at in 0..end {
        let piece = whole[at].as_str();
        let before = if at == 0 { "" } else { whole[at - 1].as_str() };
        let mut change = |with: &[&str], until: usize, what: String| {
            let mut pieces = whole[..at].to_vec();
            pieces.extend(with.iter().map(|piece| (*piece).to_owned()));
            pieces.extend_from_slice(&whole[until..]);
            found.push(Mutant { pieces, change: format!("piece {at}: {what}") });
        };
        let mut replace = |with: &str| change(&[with], at + 1, format!("{piece} becomes {with}"));
        match piece {
            "+" => replace("-"),
            "-" => replace("+"),
            r"\sin" => replace(r"\cos"),
            r"\cos" => replace(r"\sin"),
            r"\tan" => replace(r"\sin"),
            r"\dot" => replace(r"\ddot"),
            r"\ddot" => replace(r"\dot"),
            number if number.chars().all(|c| c.is_ascii_digit()) => {
                let number: u64 = number.parse().unwrap_or_default();
                replace(&(number + 1).to_string());
                if number > 0 {
                    replace(&(number - 1).to_string());
                }
            }
            letter if is_letter(letter) => {
                for other in letters.iter().filter(|other| other.as_str() != letter) {
                    replace(other);
                }
                if before != "_" && before != "{" {
                    change(&[], at + 1, format!("{piece} is lost"));
                }
            }
            r"\sqrt" => change(&[], at + 1, "the root is lost".into()),
            "^" => change(&[], group_end(&whole, at + 1), "what is raised is lost".into()),
            "_" => change(&[], group_end(&whole, at + 1), "the index is lost".into()),
            r"\frac" if whole.get(at + 1).is_some_and(|piece| piece == "{") => {
                let (middle, last) = (group_end(&whole, at + 1), group_end(&whole, group_end(&whole, at + 1)));
                let mut turned = vec![piece];
                turned.extend(whole[middle..last].iter().map(String::as_str));
                turned.extend(whole[at + 1..middle].iter().map(String::as_str));
                change(&turned, last, "the fraction is turned over".into());
            }
            _ => {}
        }
    }
    // A pair of bars is lost as a whole, and brackets take its place.
    let bar = |piece: &String| piece == r"\left|" || piece == r"\right|";
    if whole.iter().any(bar) {
        let brackets = |piece: &String| match piece.as_str() {
            r"\left|" => "(".to_owned(),
            r"\right|" => ")".to_owned(),
            piece => piece.to_owned(),
        };
        found.push(Mutant { pieces: whole.iter().map(brackets).collect(), change: "bars become brackets".into() });
    }
    found
}

fn is_letter(piece: &str) -> bool {
    GREEK.contains(&piece) || (piece.chars().count() == 1 && piece.chars().all(char::is_alphabetic))
}

/// Where the argument that starts at a piece ends.
fn group_end(pieces: &[String], start: usize) -> usize {
    let mut depth = 0;
    for (at, piece) in pieces.iter().enumerate().skip(start) {
        depth += i32::from(piece == "{") - i32::from(piece == "}");
        if depth == 0 && ![r"\mathrm", r"\text", r"\dot", r"\ddot"].contains(&piece.as_str()) {
            return at + 1;
        }
    }
    pieces.len()
}
