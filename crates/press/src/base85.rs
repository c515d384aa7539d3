//! Bytes as text of 85 characters (ZeroMQ RFC 32): a sixteenth shorter than base64.

/// Characters of the digits. None of them ends a string of JavaScript.
const DIGITS: &[u8; 85] = b"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.-:+=^!/*?&<>()[]{}@%$#";

/// Bytes as text, five characters for four bytes. Of one to three bytes at the end, as if zeros came behind them, the text has
/// one character more than they are.
pub(crate) fn base85(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(4) * 5);
    for four in bytes.chunks(4) {
        let value = (0..4).fold(0_usize, |value, k| value << 8 | usize::from(four.get(k).copied().unwrap_or(0)));
        let digits = [85_usize.pow(4), 85_usize.pow(3), 85 * 85, 85, 1].map(|place| DIGITS[value / place % 85]);
        text.extend(digits.iter().take(four.len() + 1).map(|digit| char::from(*digit)));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What `thread.js` does: missing digits are the greatest.
    fn bytes(text: &str) -> Vec<u8> {
        let mut bytes = Vec::new();
        for five in text.as_bytes().chunks(5) {
            let digit = |k: usize| five.get(k).and_then(|of| DIGITS.iter().position(|digit| digit == of)).unwrap_or(84);
            let value = (0..5).fold(0_u64, |value, k| 85 * value + digit(k) as u64) as u32;
            bytes.extend(&value.to_be_bytes()[..five.len() - 1]);
        }
        bytes
    }

    #[test]
    fn bytes_are_written_as_the_standard_has_it() {
        // ZeroMQ RFC 32, test case.
        assert_eq!(base85(&[0x86, 0x4f, 0xd2, 0x6f, 0xb5, 0x59, 0xf7, 0x5b]), "HelloWorld");
    }

    #[test]
    fn any_number_of_bytes_comes_back() {
        for length in 0..40_u8 {
            for last in [0, 1, 84, 85, 254, 255] {
                let written: Vec<u8> = (0..length).map(|k| k.wrapping_mul(101)).chain([last]).collect();
                assert_eq!(bytes(&base85(&written)), written);
            }
        }
        assert_eq!(base85(&[]), "");
    }
}
