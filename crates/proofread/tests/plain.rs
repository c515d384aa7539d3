//! Lines of plain text, in which a word may be a unit or prose.

use crate::{report, wrong};
use proofread::TextFormat;

#[test]
fn units_that_are_words_of_prose_are_read_behind_numbers() {
    for line in [
        "9.00 V − (1.250 A)(0.200 Ω) = 8.85 V",
        "(18 V − 12 V)/(50.0 Ω) = 0.13 A",
        "(3.0 A)^2(2000 Ω) = 17.000 W",
        "(6.0 × 10^−1 A)/(2.0 × 10^−8 A) = 3.5 × 10^7",
        "221.052157 u − 221.046526 u = 0.0005631 u",
        "240 s = 4.2 min",
        "(2.4 × 10^19 e)/(6.242 × 10^18 e/C) = 4.0 C",
        "5.0 in + 1.0 in = 7.0 in",
        "([(96 − 24)î + (7 − 3)ĵ] m)/(2.0 s) = 39î m/s + 2.0ĵ m/s",
        "2.5e^(−1.2) = 0.85",
    ] {
        assert_eq!(wrong(line, TextFormat::Plain).len(), 1, "{line}");
    }
    for line in [
        "9.00 V − (1.250 A)(0.200 Ω) = 8.75 V",
        "240 s = 4.0 min later",
        "([(96 − 24)î + (7 − 3)ĵ] m)/(2.0 s) = 36î m/s + 2.0ĵ m/s",
        "2.5e^(−1.2) = 0.75",
    ] {
        assert_eq!(wrong(line, TextFormat::Plain), [""; 0], "{line}");
        assert_eq!(report(line, TextFormat::Plain).tally.checked, 1, "{line}");
    }
}

#[test]
fn prose_stays_prose() {
    for line in [
        "Take x = 5 A block of 3 kg slides down.",
        "2 A = 10 so A = 5",
        "3 t = 12, therefore t = 4",
        "It fell 5 in May = 3 more than in 2",
        "In example 3 a mass of 2 kg = 2000 g is used",
    ] {
        assert_eq!(wrong(line, TextFormat::Plain), [""; 0], "{line}");
    }
}
