//! Are the results of a run the same bits every time and everywhere? Right-hand sides of plain arithmetic.

use geneva_mimic::{Kept, Parameters, integrate};
use nalgebra::Vector2;

/// Every printed number of a run of the spring, x'' = −x, as bits.
fn spring(kept: Kept) -> Vec<u64> {
    let mut bits = Vec::new();
    let mut rate = |_: f64, state: &Vector2<f64>| Vector2::new(state[1], -state[0]);
    let parameters = Parameters { kept, ..Parameters::new(0.1, 6.0) };
    integrate(&mut rate, Vector2::new(1.0, 0.0), &parameters, |point| {
        let numbers = [point.time, point.state[0], point.state[1], point.derivative[0], point.derivative[1]];
        bits.extend(numbers.map(f64::to_bits));
    })
    .expect("a smooth problem");
    bits
}

/// A 64-bit FNV-1a hash, eight bytes at a time.
fn hash(bits: &[u64]) -> u64 {
    bits.iter()
        .flat_map(|word| word.to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

#[test]
fn two_runs_give_the_same_bits() {
    for kept in [Kept::FullStep, Kept::TwoHalfSteps, Kept::Extrapolated] {
        assert_eq!(spring(kept), spring(kept));
    }
}

#[test]
fn the_bits_are_these() {
    let expected = [
        (Kept::FullStep, 0xff48_1289_5461_97e5),
        (Kept::TwoHalfSteps, 0xa671_c66e_093c_5b3d),
        (Kept::Extrapolated, 0x92c7_0e4d_c85c_9269),
    ];
    for (kept, expected) in expected {
        let bits = spring(kept);
        assert_eq!(hash(&bits), expected, "{kept:?}: {:#018x}", hash(&bits));
    }
}
