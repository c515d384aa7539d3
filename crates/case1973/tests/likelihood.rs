//! Do the chances add up to one, and is the spread of the errors found?

use geneva_case1973::likelihood::Law;

/// The chance that an error of zero mean rounds to a number so many units away.
fn chance(law: Law, off: f64, spread: f64) -> f64 {
    libm::exp(law.log_likelihood(&[off], spread))
}

#[test]
fn the_chances_of_all_numbers_add_to_one() {
    for (law, spread) in [(Law::Normal, 0.2), (Law::Normal, 7.0), (Law::Exponential, 0.2), (Law::Exponential, 3.0)] {
        let sum: f64 = (-80..=80).map(|off| chance(law, (f64::from(off) + 0.3).abs(), spread)).sum();
        assert!((sum - 1.0).abs() < 1e-9, "{law:?} {sum}");
    }
}

/// The chance of an error above a number of units, for a spread of 3.
fn beyond(law: Law, units: f64) -> f64 {
    match law {
        Law::Normal => libm::erfc(units / (3.0 * std::f64::consts::SQRT_2)) / 2.0,
        Law::Exponential => libm::exp(-units / 3.0) / 2.0,
    }
}

/// A thousand errors as the law with a spread of 3 has them, found by bisection.
fn errors(law: Law) -> Vec<f64> {
    let quantile = |part: f64| {
        let (mut low, mut high) = (0.0, 200.0);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            *(if 1.0 - 2.0 * beyond(law, middle) < part { &mut low } else { &mut high }) = middle;
        }
        low
    };
    (0..1000).map(|k| quantile((f64::from(k) + 0.5) / 1000.0)).collect()
}

#[test]
fn the_spread_found_is_that_of_the_errors_and_their_own_law_is_the_likelier() {
    for (law, other) in [(Law::Normal, Law::Exponential), (Law::Exponential, Law::Normal)] {
        let errors = errors(law);
        let found = law.maximum_likelihood(&errors);
        assert!((found.spread - 3.0).abs() < 0.15, "{law:?} {}", found.spread);
        assert!(found.log < 0.0 && found.log > other.maximum_likelihood(&errors).log, "{law:?}");
    }
}

#[test]
fn certain_cells_cost_nothing_and_distant_ones_much() {
    for law in Law::ALL {
        // Not quite certain: no spread that is tried is zero.
        assert!(law.maximum_likelihood(&[0.0; 9]).log > -1e-5, "{law:?}");
        assert!(law.maximum_likelihood(&[1e4; 9]).log < -50.0, "{law:?}");
    }
}
