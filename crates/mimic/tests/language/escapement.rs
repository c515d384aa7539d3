//! Compares the escapement's deck with its formulas in Rust, to the last bit.

use super::native::{Escapement, parameters};
use super::own;
use geneva_mimic::integrate;
use geneva_mimic::language::RunOptions;
use nalgebra::Vector2;
use std::cell::Cell;
use std::rc::Rc;

#[test]
fn the_deck_is_its_formulas_to_the_last_bit() {
    for (slots, start) in [(4.0, -0.785), (6.0, -1.047), (3.0, -0.523)] {
        for mu in [0.0, 0.3] {
            let data = [slots, start, mu, 0.125, 6e-5, 2e-5];
            let (program, set) = own("escapement", &data);
            let printed = program.run(&set, &RunOptions::default()).unwrap_or_else(|trouble| panic!("{trouble}"));
            let kept: Rc<Cell<[f64; 2]>> = Rc::default();
            let mut system = Escapement::new(data, Rc::clone(&kept));
            let mut rows = Vec::new();
            let outcome = integrate(&mut system, Vector2::zeros(), &parameters(), |point| {
                let [acceleration, follower] = kept.get();
                rows.push([point.time, point.state[1], point.state[0], acceleration, follower].map(f64::to_bits));
            });
            assert_eq!(outcome.expect("a run").work, printed.work);
            let bits: Vec<_> = printed.rows.iter().map(|row| [0, 1, 2, 3, 4].map(|at| row[at].to_bits())).collect();
            assert_eq!(bits, rows, "{data:?}");
        }
    }
}
