//! What a steady state costs: one, a table of forty-nine with and without the extremes, and its parts.

mod rows;

use divan::{Bencher, black_box};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;
use rows::escapements;

const TOLERANCES: [f64; 4] = [1e-6, 1e-8, 1e-10, 1e-12];

fn main() {
    divan::main();
}

#[divan::bench(args = TOLERANCES)]
fn forty_nine(bencher: Bencher, tolerance: f64) {
    let escapements = escapements();
    bencher.bench_local(|| {
        let solve = |escapement| Engagement::with_tolerance(black_box(escapement), tolerance)?.steady_state();
        escapements.iter().filter_map(|escapement| solve(escapement).ok()).map(|steady| steady.period).sum::<f64>()
    });
}

#[divan::bench(args = TOLERANCES)]
fn forty_nine_without_extremes(bencher: Bencher, tolerance: f64) {
    let escapements = escapements();
    bencher.bench_local(|| {
        let solve = |escapement| Engagement::with_tolerance(black_box(escapement), tolerance)?.entry_speed_and_period();
        escapements.iter().filter_map(|escapement| solve(escapement).ok()).map(|(_, period)| period).sum::<f64>()
    });
}

#[divan::bench(args = TOLERANCES)]
fn one_engagement(bencher: Bencher, tolerance: f64) {
    let escapements = escapements();
    bencher.bench_local(|| Engagement::with_tolerance(black_box(&escapements[1]), tolerance));
}

#[divan::bench(args = TOLERANCES)]
fn one_passage(bencher: Bencher, tolerance: f64) {
    let engagement = Engagement::with_tolerance(&escapements()[1], tolerance).ok();
    bencher.bench_local(|| engagement.as_ref().and_then(|engagement| engagement.return_map(black_box(2.0)).ok()));
}

#[divan::bench]
fn parameters(bencher: Bencher) {
    let inertias = Inertias::new(0.07, 1.0).ok();
    bencher.bench_local(|| {
        inertias.and_then(|inertias| Parameters::new(Mechanism::FOUR_PIN, inertias, 1.0, black_box(0.3)).ok())
    });
}
