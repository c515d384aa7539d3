//! The shape of a chain: what is left of its line if each number stands for any number, and each word for any word.

use crate::unit::unit;

/// The line of a chain with `N` for each number and `x` for each word, without blanks.
///
/// Differences with one shape in one document mostly have one cause: a notation that is not known here, or a slip that was copied.
///
/// ```
/// use proofread::chain_shape;
///
/// assert_eq!(chain_shape("F_x = 2.5 kg · 1,000 m/s^2 = 7 N"), "x=Nx·Nx/x^N=Nx");
/// assert_eq!(chain_shape("12 + 7 = 20"), chain_shape("3.5 + 1.25 = 5"));
/// ```
pub fn chain_shape(chain: &str) -> String {
    let mut shape = String::new();
    let mut rest = chain;
    while let Some(first) = rest.chars().next() {
        let length = if first.is_ascii_digit() {
            shape.push('N');
            number_length(rest)
        } else if first.is_alphabetic() {
            shape.push('x');
            rest.find(|c: char| !c.is_alphabetic() && !"_¯′".contains(c)).unwrap_or(rest.len())
        } else {
            if !first.is_whitespace() {
                shape.push(first);
            }
            first.len_utf8()
        };
        rest = rest.get(length..).unwrap_or_default();
    }
    shape
}

/// How many bytes the number at the start takes, with its points and commas.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let is_digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    (0..bytes.len())
        .find(|at| !(is_digit(*at) || b".,".contains(&bytes[*at]) && is_digit(at + 1)))
        .unwrap_or(bytes.len())
}

/// The words of functions that are the same in all texts.
const FUNCTIONS: [&str; 16] = [
    "sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "arcsin", "arccos", "arctan", "ln", "log", "lg",
    "exp",
];

/// The words of other functions and operations.
const OTHER_OPERATIONS: [&str; 8] = ["lb", "arcsec", "det", "min", "max", "gcd", "lcm", "mod"];

/// Whether a word stands for something that is computed.
fn is_operation(word: &str) -> bool {
    FUNCTIONS.contains(&word) || OTHER_OPERATIONS.contains(&word)
}

/// Whether a side of a chain computes something: a sign of an operation stands between two of its parts, or a function before one.
pub(crate) fn chain_computes(chain: &str) -> bool {
    let mut before = None;
    let mut word = String::new();
    for c in chain.chars() {
        if c.is_alphabetic() {
            word.push(c);
        } else {
            if is_operation(&word) || c == '(' && !word.is_empty() {
                return true;
            }
            word.clear();
        }
        let is_sign = match c {
            '·' | '×' | '*' | '/' | '÷' | '^' | '√' | '∑' | '∏' | '∫' | '!' | 'π' => true,
            // At the start of a side or of a bracket it is the sign of a number.
            '+' | '−' | '-' => before.is_some_and(|before: char| !"=≈(±".contains(before)),
            '(' => before.is_some_and(|before: char| before == ')' || before.is_ascii_digit()),
            c if c.is_ascii_digit() => before == Some(')'),
            _ => false,
        };
        if is_sign {
            return true;
        }
        if !c.is_whitespace() {
            before = Some(c);
        }
    }
    is_operation(&word)
}

/// Whether a side is one name with its index and marks, as in `v_2 = 5`.
pub(crate) fn is_single_name(side: &str) -> bool {
    let side = side.trim();
    side.starts_with(char::is_alphabetic) && side.chars().all(|c| c.is_alphanumeric() || "_¯′".contains(c))
}

/// Whether a side is the name of what the chain is about, as in `x = 2 + 2 = 5`.
pub(crate) fn is_name(side: &str) -> bool {
    let side = side.trim_start();
    let word = side.find(|c: char| !c.is_alphabetic()).unwrap_or(side.len());
    side.starts_with('\\') || word > 0 && !is_operation(&side[..word])
}

/// Whether a side has anything beside numbers, signs of plain arithmetic, brackets, roots, known functions, and units behind a number.
pub(crate) fn has_other_signs(side: &str) -> bool {
    let mut rest = side.trim_start();
    let mut is_first = true;
    while let Some(c) = rest.chars().next() {
        let length = if c.is_alphabetic() {
            let length = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
            let word = &rest[..length];
            if FUNCTIONS.contains(&word) {
                // The base of a logarithm stands behind a stroke below.
                length + usize::from(rest[length..].starts_with('_'))
            } else if is_first || unit(word).is_none() {
                return true;
            } else {
                length
            }
        } else {
            if !c.is_ascii_digit() && !c.is_whitespace() && !"+−-±·×*/÷^().,√%°$€£".contains(c) {
                return true;
            }
            c.len_utf8()
        };
        is_first = false;
        rest = rest.get(length..).unwrap_or_default();
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_leaves_out_what_the_numbers_and_words_are() {
        for (chain, shape) in [
            ("x̄ = 1.5", "x̄=N"),
            ("α_1 = 3, 4 = 1,5.", "xN=N,N=N."),
            ("…", "…"),
            ("2.", "N."),
            ("", ""),
            ("−3·(4 − 1) ≈ 10", "−N·(N−N)≈N"),
        ] {
            assert_eq!(chain_shape(chain), shape, "{chain}");
        }
    }

    #[test]
    fn a_sign_of_a_number_is_no_operation() {
        for chain in
            ["−3 = 4", "4 μs = 10 mm", "x = −5 = +7", "|3| = 4", "(1.65 A) = 1.5 A", "[5][11] = 61", "a = ±2 = ±3", ""]
        {
            assert!(!chain_computes(chain), "{chain}");
        }
        for chain in [
            "3 − 2 = 2",
            "2 (3) = 7",
            "(2)(3) = 7",
            "lg 14.67 = 1.6",
            "(27) mod7 = 3",
            "f(2) = 7",
            "4π = 39",
            "3! = 5",
            "√9 = 4",
            "2 = ln",
        ] {
            assert!(chain_computes(chain), "{chain}");
        }
    }

    #[test]
    fn units_behind_a_number_belong_to_plain_arithmetic() {
        for side in ["2 + 2", "(12 m)/(1 s)", "√(4 − 1)·3 kg", "5 %", "20°", "−3.5", "2 m/s^2", "7 cos (0)", "log_2 8"]
        {
            assert!(!has_other_signs(side), "{side}");
        }
        for side in ["π(2)", "arcsec(2)", "3!", "|3|", "m 2", "2 … 3", "C(4; 2)"] {
            assert!(has_other_signs(side), "{side}");
        }
    }
}
