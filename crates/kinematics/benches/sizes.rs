//! What a wheel's sizes in millimetres, and their clearance over a whole turn, cost.

use divan::{Bencher, black_box};
use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};

/// Stations and pins.
const WHEELS: [(u32, u32); 8] = [(3, 1), (3, 5), (4, 1), (4, 3), (6, 1), (6, 2), (12, 2), (60, 2)];

fn main() {
    divan::main();
}

fn sized(wheel: Wheel) -> Sizes {
    Sizes::new(wheel, Scale::CentreDistance(100.0), &Choices::default()).expect("the defaults fit")
}

#[divan::bench(args = WHEELS)]
fn sizes(bencher: Bencher, (stations, pins): (u32, u32)) {
    let wheel = Wheel::with_pins(stations, pins).expect("a wheel has so many");
    bencher.bench_local(|| sized(black_box(wheel)));
}

#[divan::bench(args = WHEELS, sample_count = 20)]
fn clearance(bencher: Bencher, (stations, pins): (u32, u32)) {
    let sizes = sized(Wheel::with_pins(stations, pins).expect("a wheel has so many"));
    bencher.bench_local(|| black_box(&sizes).clearance());
}

#[divan::bench(args = WHEELS)]
fn outline(bencher: Bencher, (stations, pins): (u32, u32)) {
    let sizes = sized(Wheel::with_pins(stations, pins).expect("a wheel has so many"));
    bencher.bench_local(|| black_box(&sizes).outline());
}
