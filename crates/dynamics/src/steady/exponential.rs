//! The exponential function of many numbers at once.
//!
//! With no table, no solution and no call the compiler can work on several numbers in one instruction. Only sums, products
//! and the bits of an integer are used, so that the result is the same everywhere.

use std::f64::consts::{LN_2, LOG2_E};

/// Adding it rounds to an integer, which is then in the lowest bits.
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

/// Beyond, the result has no place among normal numbers.
const LIMIT: f64 = 700.0;

/// e to each power. Beyond ±700 it stays at its value there.
#[inline]
pub(super) fn exponentials<const N: usize>(powers: &[f64; N]) -> [f64; N] {
    let (mut shifted, mut rest, mut squares) = ([0.0; N], [0.0; N], [0.0; N]);
    for index in 0..N {
        let power = if powers[index] > LIMIT { LIMIT } else { powers[index] };
        let power = if power < -LIMIT { -LIMIT } else { power };
        shifted[index] = power * LOG2_E + ROUND;
        let whole = shifted[index] - ROUND;
        rest[index] = (power - whole * LN_2_HIGH) - whole * LN_2_LOW;
        squares[index] = rest[index] * rest[index];
    }
    // The odd and the even terms apart, so that they need not wait for one another.
    let (mut odd, mut even) = ([TAYLOR[0]; N], [TAYLOR[1]; N]);
    for pair in TAYLOR[2..].chunks_exact(2) {
        for index in 0..N {
            odd[index] = odd[index] * squares[index] + pair[0];
            even[index] = even[index] * squares[index] + pair[1];
        }
    }
    let mut values = [0.0; N];
    for index in 0..N {
        // The integer's bits, moved to the place of the exponent.
        let power_of_two = f64::from_bits((shifted[index].to_bits() << 52).wrapping_add(1.0_f64.to_bits()));
        values[index] = (even[index] + odd[index] * rest[index]) * power_of_two;
    }
    values
}

const _: () = assert!(LN_2_HIGH < LN_2 && LN_2 - LN_2_HIGH < 2e-10);
