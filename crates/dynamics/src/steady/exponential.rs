//! The exponential function of sixteen numbers at once.
//!
//! With no table, no branch and no call the compiler can work on several numbers in one instruction. Only sums, products
//! and the bits of a whole number are used, so that the result is the same everywhere.

use super::rule::Row;
use std::f64::consts::{LN_2, LOG2_E};

/// Adding it rounds to a whole number, which is then in the lowest bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// ln 2 to as many bits as leave its product with an exponent exact.
const LN_2_HIGH: f64 = 0.693_147_180_369_123_8;

/// What is missing.
const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;

/// 1/k! from k = 13 down.
const TAYLOR: [f64; 14] = {
    let mut terms = [1.0; 14];
    let mut order = 1;
    while order < 14 {
        let mut factor = 1.0;
        let mut k = 1;
        while k <= order {
            factor *= k as f64;
            k += 1;
        }
        terms[13 - order] = 1.0 / factor;
        order += 1;
    }
    terms
};

/// e to each power. Beyond ±700 it stays at its value there.
#[inline]
pub(super) fn exponentials(powers: &Row) -> Row {
    powers.map(|power| {
        let power = power.clamp(-700.0, 700.0);
        let shifted = power * LOG2_E + ROUND;
        let whole = shifted - ROUND;
        let rest = (power - whole * LN_2_HIGH) - whole * LN_2_LOW;
        let mut sum = TAYLOR[0];
        for term in &TAYLOR[1..] {
            sum = sum * rest + term;
        }
        // The whole number's bits, moved to the place of the exponent.
        sum * f64::from_bits((shifted.to_bits() << 52).wrapping_add(1.0_f64.to_bits()))
    })
}

const _: () = assert!(LN_2_HIGH < LN_2 && LN_2 - LN_2_HIGH < 2e-10);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_exponential_to_the_last_places() {
        for step in -7_000..7_000 {
            let powers: Row = std::array::from_fn(|index| f64::from(step) / 10.0 + index as f64 * 0.006_1);
            for (power, value) in powers.iter().zip(exponentials(&powers)) {
                let exact = libm::exp(power.clamp(-700.0, 700.0));
                assert!((value / exact - 1.0).abs() < 5e-16, "{power}: {value} for {exact}");
            }
        }
        assert_eq!(exponentials(&[0.0; _]), [1.0; _]);
        let ends = exponentials(&std::array::from_fn(|index| if index < 8 { -1e300 } else { f64::INFINITY }));
        assert!(ends.iter().all(|value| value.is_finite() && *value > 0.0), "{ends:?}");
    }
}
