//! What the wheel's velocity ratio costs beside one `libm::sincos` of the same angles.
//!
//! After divan's table of each come the ratios of the two, timed in turns: the clock of a machine changes its rate, and
//! neighbours in time share it.

use divan::{Bencher, black_box};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use std::time::{Duration, Instant};

const STATIONS: [u32; 5] = [3, 4, 6, 12, 60];
const TURNS: usize = 2001;

fn main() {
    divan::main();
    println!("velocity ratio over sincos, of the fastest and of the median turn:");
    for stations in STATIONS {
        let (wheel, angles) = wheel_and_angles(stations);
        let mut turns = [(); TURNS].map(|()| (time(|| sincos(&angles)), time(|| velocity_ratios(&wheel, &angles))));
        let fastest = |of: fn(&(Duration, Duration)) -> Duration| turns.iter().map(of).min().unwrap_or_default();
        let at_best = fastest(|turn| turn.1).as_secs_f64() / fastest(|turn| turn.0).as_secs_f64();
        let ratio = |turn: &(Duration, Duration)| turn.1.as_secs_f64() / turn.0.as_secs_f64();
        turns.sort_by(|a, b| ratio(a).total_cmp(&ratio(b)));
        println!("{stations:>3} stations {at_best:>6.2} {:>6.2}", ratio(&turns[TURNS / 2]));
    }
}

/// A wheel, and a thousand angles evenly spaced over its engagement.
fn wheel_and_angles(stations: u32) -> (Wheel, Vec<f64>) {
    let wheel = Wheel::new(stations).expect("a wheel has this many stations");
    let most = wheel.engagement_half_angle();
    (wheel, (0..=1000).map(|step| most * (f64::from(step) / 500.0 - 1.0)).collect())
}

fn time(work: impl Fn()) -> Duration {
    let start = Instant::now();
    work();
    start.elapsed()
}

fn sincos(angles: &[f64]) {
    for angle in angles {
        black_box(libm::sincos(black_box(*angle)));
    }
}

fn velocity_ratios(wheel: &Wheel, angles: &[f64]) {
    for angle in angles {
        let _ = black_box(wheel.velocity_ratio(black_box(*angle)));
    }
}

#[divan::bench(args = STATIONS, sample_count = 1000)]
fn libm_sincos(bencher: Bencher, stations: u32) {
    let (_, angles) = wheel_and_angles(stations);
    bencher.bench_local(|| sincos(&angles));
}

#[divan::bench(args = STATIONS, sample_count = 1000)]
fn velocity_ratio(bencher: Bencher, stations: u32) {
    let (wheel, angles) = wheel_and_angles(stations);
    bencher.bench_local(|| velocity_ratios(&wheel, &angles));
}
