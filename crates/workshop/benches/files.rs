//! What the files of a wheel cost.

use divan::{Bencher, black_box};
use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
use geneva_workshop::{PartLayout, Solid, dxf, stl};

const STATIONS: [u32; 4] = [3, 6, 12, 60];

fn main() {
    divan::main();
}

fn sizes(stations: u32) -> Sizes {
    let wheel = Wheel::new(stations).expect("a wheel has this many stations");
    Sizes::new(wheel, Scale::CentreDistance(100.0), &Choices::default()).expect("the defaults fit")
}

#[divan::bench(args = STATIONS)]
fn drawing(bencher: Bencher, stations: u32) {
    let sizes = sizes(stations);
    bencher.bench_local(|| dxf(black_box(&sizes), PartLayout::Apart));
}

#[divan::bench(args = STATIONS)]
fn mesh(bencher: Bencher, stations: u32) {
    let sizes = sizes(stations);
    bencher.bench_local(|| stl(black_box(&sizes), Solid { thickness: 5.0, tolerance: 0.01 }));
}
