//! What a steady state costs: one, a table of forty-nine, and a map of friction and inertia ratio.
//!
//! After divan's table comes the map, shared by two threads, each point solved for itself.

use divan::{Bencher, black_box};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters, Slots, existence};
use std::time::Instant;

const TOLERANCES: [f64; 3] = [1e-8, 1e-10, 1e-12];

/// Points of the map along each axis, for each mechanism.
const SIDE: u32 = 512;

fn main() {
    divan::main();
    for tolerance in TOLERANCES {
        let start = Instant::now();
        let (found, sum) = std::thread::scope(|scope| {
            let half =
                |odd: u32| move || Slots::ALL.map(|slots| map(slots, tolerance, odd)).into_iter().fold((0, 0.0), add);
            let threads = [0, 1].map(|odd| scope.spawn(half(odd)));
            threads.into_iter().filter_map(|thread| thread.join().ok()).fold((0, 0.0), add)
        });
        println!("map to {tolerance:e}: {found} of {} in {:?} (sum {sum:.6})", 3 * SIDE * SIDE, start.elapsed());
    }
}

fn add(one: (u32, f64), other: (u32, f64)) -> (u32, f64) {
    (one.0 + other.0, one.1 + other.1)
}

/// Mean speeds over one half of the lines: friction from a twentieth of the critical one up, inertia ratio from 1/32 to 2.
fn map(slots: Slots, tolerance: f64, odd: u32) -> (u32, f64) {
    let mut all = (0, 0.0);
    for line in (odd..SIDE).step_by(2) {
        let inertia = libm::exp2(-5.0 + 6.0 * f64::from(line) / f64::from(SIDE));
        let Ok(critical) = existence::critical_friction(slots, inertia) else { continue };
        for column in 0..SIDE {
            let friction = critical.friction * (0.05 + 0.9 * f64::from(column) / f64::from(SIDE));
            let steady = Inertias::new(inertia, 1.0)
                .and_then(|inertias| Parameters::new(slots, inertias, 1.0, friction))
                .ok()
                .and_then(|escapement| Engagement::with_tolerance(&escapement, tolerance).ok())
                .and_then(|engagement| engagement.steady_state().ok());
            all = add(all, steady.map_or((0, 0.0), |steady| (1, steady.mean_speed)));
        }
    }
    all
}

fn escapements() -> Vec<Parameters> {
    let ratios = [(Slots::Three, 0.7), (Slots::Four, 0.07), (Slots::Six, 0.07)];
    let all = (0..49_u32).filter_map(|number| {
        let (slots, ratio) = ratios[number as usize % 3];
        let (friction, torque) = (0.17 + 0.05 * f64::from(number / 3 % 4), 1.0 + f64::from(number / 12));
        Parameters::new(slots, Inertias::new(ratio, 1.0).ok()?, torque, friction).ok()
    });
    all.collect()
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
fn one_engagement(bencher: Bencher, tolerance: f64) {
    let escapements = escapements();
    bencher.bench_local(|| Engagement::with_tolerance(black_box(&escapements[1]), tolerance));
}

#[divan::bench(args = TOLERANCES)]
fn one_passage(bencher: Bencher, tolerance: f64) {
    let engagement = Engagement::with_tolerance(&escapements()[1], tolerance).ok();
    bencher.bench_local(|| engagement.as_ref().and_then(|engagement| engagement.hand_over(black_box(2.0)).ok()));
}
