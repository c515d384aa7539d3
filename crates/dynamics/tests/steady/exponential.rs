//! Are exponentials of many numbers at once right to the last places?

/// The function, compiled here by itself because the crate keeps it private.
#[allow(dead_code, unreachable_pub, reason = "a file of the library, of which the tests use a part")]
#[path = "../../src/steady/exponential.rs"]
mod source;

use source::exponentials;

/// Powers as the nodes of a subinterval have them.
type Powers = [f64; 16];

#[test]
fn it_is_the_exponential_to_the_last_places() {
    for step in -7_000..7_000 {
        let powers: Powers = std::array::from_fn(|index| f64::from(step) / 10.0 + index as f64 * 0.006_1);
        for (power, value) in powers.iter().zip(exponentials(&powers)) {
            let exact = libm::exp(power.clamp(-700.0, 700.0));
            assert!((value / exact - 1.0).abs() < 5e-16, "{power}: {value} for {exact}");
            assert_eq!(exponentials(&[*power]), [value]);
        }
    }
    assert_eq!(exponentials(&[0.0; 3]), [1.0; 3]);
    let ends: Powers = exponentials(&std::array::from_fn(|index| if index < 8 { -1e300 } else { f64::INFINITY }));
    assert!(ends.iter().all(|value| value.is_finite() && *value > 0.0), "{ends:?}");
}
