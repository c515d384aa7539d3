//! What the language costs: reading and sorting a deck, and forty-nine runs of it against the same equations in Rust.

#[path = "../tests/language/native.rs"]
mod native;

use divan::{Bencher, black_box};
use geneva_mimic::integrate;
use geneva_mimic::language::{CardLayout, DataSet, Deck, Program, RunOptions, deck_named};
use nalgebra::Vector2;
use native::{Escapement, parameters};
use std::rc::Rc;

fn main() {
    divan::main();
}

fn text() -> &'static str {
    deck_named("escapement").unwrap_or_default()
}

fn program() -> Program {
    let deck = Deck::read(text(), CardLayout::Columns).expect("a deck");
    Program::new(&deck).expect("a program")
}

/// Forty-nine data cards: seven frictions and seven torques.
fn data() -> Vec<[f64; 6]> {
    let card = |at: u32| {
        let (mu, torque) = (0.05 * f64::from(at % 7), 0.02 * f64::from(at / 7 + 2));
        [4.0, -0.785, mu, torque, 5e-5, 1e-5]
    };
    (0..49).map(card).collect()
}

#[divan::bench]
fn layout_read_and_sort() -> Program {
    let text = black_box(text());
    let deck = Deck::read(text, CardLayout::detect(text)).expect("a deck");
    Program::new(&deck).expect("a program")
}

#[divan::bench(sample_count = 20)]
fn forty_nine_runs_of_the_deck(bencher: Bencher) {
    let program = program();
    let names = ["SLOTS", "START", "MU", "TORQUE", "IFOL", "IDRV"].map(str::to_owned);
    let sets: Vec<_> =
        data().into_iter().map(|numbers| DataSet(names.iter().cloned().zip(numbers).collect())).collect();
    bencher.bench_local(|| program.runs(black_box(&sets), &RunOptions::default()).expect("some runs").len());
}

#[divan::bench(sample_count = 20)]
fn forty_nine_runs_in_rust(bencher: Bencher) {
    let data = data();
    bencher.bench_local(|| {
        let mut rows = 0;
        for numbers in black_box(&data) {
            let kept = Rc::default();
            let mut system = Escapement::new(*numbers, Rc::clone(&kept));
            let mut printed = Vec::new();
            let end = integrate(&mut system, Vector2::zeros(), &parameters(), |point| {
                let [acceleration, follower] = kept.get();
                printed.push(vec![point.time, point.state[1], point.state[0], acceleration, follower]);
            });
            assert!(end.is_ok());
            rows += printed.len();
        }
        rows
    });
}
