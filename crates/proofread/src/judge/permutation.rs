//! Permutations, in cycles and in two rows, and whether two sides are the same one.

use crate::judge::sides::Sides;
use crate::judge::substitution::without_space;
use crate::token::{Span, Token, TokenKind, trim_space};

/// Most letters of a permutation.
const MOST_LETTERS: usize = 20;
/// Highest power of a cycle.
const HIGHEST_POWER: u32 = 24;

/// The image of each letter from 1 on, at its place.
type Images = [usize; MOST_LETTERS + 1];

/// Both sides as one number that is the same, if they are products of cycles that agree, or such a product at a letter and its image: `(142)^2 = (124)`,
/// `(124)2 = 4`. Products are taken in either order.
pub(super) fn as_permutations(left: &[Token], right: &[Token]) -> Option<Sides> {
    let agree = |from_right: bool| {
        let [one, other] = [left, right].map(|side| product(side, from_right));
        match (one?, other?) {
            (Side::Permutation(one), Side::Permutation(other)) => Some(one == other),
            (Side::Letter(one), Side::Letter(other)) => Some(one == other),
            _ => None,
        }
    };
    // A letter alone on both sides is no permutation.
    let has_cycle = [left, right].into_iter().any(|side| side.iter().any(|token| token.is_sign('(')));
    let fits = has_cycle && [true, false].into_iter().any(|from_right| agree(from_right) == Some(true));
    let one = || vec![Token::new(TokenKind::Number("1".to_owned()), Span::default())];
    fits.then(|| [one(), one()])
}

/// What a side with cycles is.
enum Side {
    Permutation(Images),
    /// A letter, or the image of one.
    Letter(usize),
}

fn identity() -> Images {
    std::array::from_fn(|at| at)
}

/// The product of the cycles in a side, of which the last or the first acts first.
fn product(side: &[Token], from_right: bool) -> Option<Side> {
    let solid = without_space(side);
    let mut cycles: Vec<(Images, u32)> = Vec::new();
    let mut rest = solid.as_slice();
    while let [open, behind @ ..] = rest
        && open.is_sign('(')
    {
        let end = behind.iter().position(|token| token.is_sign(')'))?;
        cycles.push((cycle(&behind[..end])?, 1));
        rest = &behind[end + 1..];
        if let [power, behind @ ..] = rest
            && let TokenKind::Power(exponent) = &power.kind
        {
            let [exponent] = exponent.as_slice() else { return None };
            let power = exponent.number()?.parse().ok().filter(|power| *power <= HIGHEST_POWER)?;
            if let Some(last) = cycles.last_mut() {
                last.1 = power;
            }
            rest = behind;
        }
        if let [sign, behind @ ..] = rest
            && (sign.is_one_of("·×*∘") || sign.word() == Some("°"))
        {
            rest = behind;
        }
    }
    let images = if from_right { composed(cycles.iter().rev()) } else { composed(cycles.iter()) };
    match rest {
        [] if !cycles.is_empty() => Some(Side::Permutation(images)),
        // The images in their order, without brackets.
        [images] if cycles.is_empty() && images.number().is_some_and(|digits| digits.len() > 2) => {
            in_one_line(images.number()?).map(Side::Permutation)
        }
        [letter] => {
            let letter: usize = letter.number()?.parse().ok()?;
            images.get(letter).filter(|_| letter > 0).map(|image| Side::Letter(*image))
        }
        _ => None,
    }
}

/// The permutation whose images are the digits of a number; none if they are not all the letters from 1 on.
fn in_one_line(digits: &str) -> Option<Images> {
    let letters: Vec<usize> = digits.chars().filter_map(|c| c.to_digit(10)).map(|digit| digit as usize).collect();
    let mut images = identity();
    for (at, letter) in letters.iter().enumerate() {
        *images.get_mut(at + 1)? = *letter;
    }
    (digits.len() == letters.len() && (1..=letters.len()).all(|letter| letters.contains(&letter))).then_some(images)
}

/// What becomes of each letter if these cycles act in their order.
fn composed<'c>(cycles: impl Iterator<Item = &'c (Images, u32)>) -> Images {
    let mut images = identity();
    for (cycle, power) in cycles {
        for _ in 0..*power {
            images = images.map(|letter| cycle[letter]);
        }
    }
    images
}

/// The cycle of the letters in a pair of brackets, as digits or as a list; without any or with one letter it is the identity.
fn cycle(inner: &[&Token]) -> Option<Images> {
    let mut letters: Vec<usize> = Vec::new();
    let is_list = inner.iter().any(|token| token.is_sign(','));
    for token in inner {
        match token.number() {
            Some(digits) if is_list && digits.bytes().all(|digit| digit.is_ascii_digit()) => {
                letters.push(digits.parse().ok()?);
            }
            // A list of two letters may have been taken for decimals, and one of three digits for thousands.
            Some(digits) => {
                let digits = digits.chars().filter(|c| !".,".contains(*c));
                letters.extend(digits.filter_map(|c| c.to_digit(10)).map(|digit| digit as usize));
            }
            None if token.is_sign(',') => {}
            None => return None,
        }
    }
    of_cycle(&letters)
}

/// The images of the letters of a cycle; none if one of them is too large or stands twice.
fn of_cycle(letters: &[usize]) -> Option<Images> {
    let mut images = identity();
    for (at, letter) in letters.iter().enumerate() {
        let is_letter = (1..=MOST_LETTERS).contains(letter) && !letters[..at].contains(letter);
        if !is_letter {
            return None;
        }
        images[*letter] = letters[(at + 1) % letters.len()];
    }
    Some(images)
}

/// Whether two tables are the same permutation: of two rows, in which the letters stand above their images, or of one, which is a cycle of three
/// letters or more.
pub(crate) fn are_same_in_rows(left: &[Vec<Token>], right: &[Vec<Token>]) -> bool {
    let images = [left, right].map(images_in_rows);
    left.len() == right.len() && images[0].is_some() && images[0] == images[1]
}

/// The images of the letters of a table of one or two rows; of two, none if the rows don't have the same letters from 1 on.
fn images_in_rows(rows: &[Vec<Token>]) -> Option<Images> {
    let letters = |row: &Vec<Token>| -> Option<Vec<usize>> {
        let cells = row.split(|token| token.kind == TokenKind::Cell);
        let letter = |cell: &[Token]| match trim_space(cell) {
            [letter] => letter.number()?.parse().ok(),
            _ => None,
        };
        cells.map(letter).collect()
    };
    match rows {
        [row] => {
            of_cycle(&letters(row)?).filter(|_| row.iter().filter(|token| token.kind == TokenKind::Cell).count() > 1)
        }
        [above, below] => {
            let (above, below) = (letters(above)?, letters(below)?);
            let count = above.len();
            let has_all = |row: &[usize]| row.len() == count && (1..=count).all(|letter| row.contains(&letter));
            if !(2..=MOST_LETTERS).contains(&count) || !has_all(&above) || !has_all(&below) {
                return None;
            }
            let mut images = identity();
            for (letter, image) in above.into_iter().zip(below) {
                images[letter] = image;
            }
            Some(images)
        }
        _ => None,
    }
}
