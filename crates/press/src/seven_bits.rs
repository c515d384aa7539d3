//! Bytes as text in a script, seven bits a byte of the file: an eighth longer than the bytes, where base64 is a third longer.
//!
//! As in base-122 (Kevin Albertson, 2016): a group of seven bits is the character of that number. Seven characters cannot stand in a string
//! of a script, or not safely; such a group and the next one are a character of two bytes, which has room for both.

/// Groups that are no characters of their own: zero, the ends of lines, the quote, the escape, and what ends or begins a tag.
const FORBIDDEN: [u8; 7] = [0, b'\n', b'\r', b'\'', b'\\', b'<', b'>'];

/// What stands for a forbidden group that has none behind it.
const ALONE: u32 = FORBIDDEN.len() as u32;

/// Bytes as text. The last group has zeros behind the bits that are left.
pub(crate) fn seven_bits(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len() / 7 * 8 + 8);
    let mut groups = (0..(bytes.len() * 8).div_ceil(7)).map(|group| {
        let (at, shift) = (group * 7 / 8, group * 7 % 8);
        let two = u16::from(bytes[at]) << 8 | u16::from(bytes.get(at + 1).copied().unwrap_or(0));
        (two >> (9 - shift) & 127) as u8
    });
    while let Some(group) = groups.next() {
        text.push(match FORBIDDEN.iter().position(|of| *of == group) {
            None => char::from(group),
            // At most 128 + 7 · 128 + 127, which is two bytes in UTF-8. As an eighth kind, the last group stands alone.
            Some(which) => {
                let both = match groups.next() {
                    Some(next) => which as u32 * 128 + u32::from(next),
                    None => ALONE * 128 + which as u32,
                };
                char::from_u32(128 + both).unwrap_or('\0')
            }
        });
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What `thread.js` does: the bits that are left over at the end are none of a byte.
    fn bytes(text: &str) -> Vec<u8> {
        let (mut bytes, mut bits, mut held) = (Vec::new(), 0, 0_u32);
        let mut push = |group: u32| {
            held = held << 7 | group;
            bits += 7;
            if bits >= 8 {
                bits -= 8;
                bytes.push((held >> bits) as u8);
                held &= (1 << bits) - 1;
            }
        };
        for of in text.chars().map(u32::from) {
            match of.checked_sub(128) {
                None => push(of),
                Some(both) if both >> 7 == ALONE => push(FORBIDDEN[(both & 127) as usize].into()),
                Some(both) => [u32::from(FORBIDDEN[(both >> 7) as usize]), both & 127].into_iter().for_each(&mut push),
            }
        }
        bytes
    }

    #[test]
    fn groups_are_characters_and_forbidden_ones_are_joined_to_the_next() {
        // Groups: 1010101 | 0000000, which is forbidden and the last.
        assert_eq!(seven_bits(&[0b1010_1010]), "U\u{400}");
        // 1010101 | 1100110 | 0000000 with 0111000 | 0000000.
        assert_eq!(seven_bits(&[0b1010_1011, 0b1001_1000, 0b0000_0011, 0b1000_0000]), "Uf\u{b8}\u{400}");
        assert_eq!(seven_bits(&[]), "");
    }

    #[test]
    fn any_bytes_come_back_and_no_string_of_a_script_ends_early() {
        let mut digits = 1_u32;
        let all: Vec<u8> = (0..40_000)
            .map(|_| {
                digits = digits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (digits >> 24) as u8
            })
            .collect();
        for length in (0..70).chain([all.len()]) {
            let text = seven_bits(&all[..length]);
            assert_eq!(bytes(&text), all[..length]);
            assert!(!text.bytes().any(|of| FORBIDDEN.contains(&of)));
            assert!(text.len() <= (length * 8).div_ceil(7) + 1);
        }
        for byte in 0..=255 {
            for length in 1..9 {
                assert_eq!(bytes(&seven_bits(&vec![byte; length])), vec![byte; length]);
            }
        }
    }
}
