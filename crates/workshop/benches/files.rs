//! What the files of a wheel cost.

use divan::{Bencher, black_box};
use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
use geneva_workshop::{Mounting, Part, PartLayout, dxf, parts, scad, step, stl, svg_parts, three_mf};

const STATIONS: [u32; 5] = [3, 6, 12, 24, 60];

fn main() {
    divan::main();
}

fn sizes(stations: u32) -> Sizes {
    let wheel = Wheel::new(stations).expect("a wheel has this many stations");
    Sizes::new(wheel, Scale::CentreDistance(100.0), &Choices::default()).expect("the defaults fit")
}

fn list(sizes: &Sizes) -> Vec<Part> {
    parts(sizes, 5.0, &Mounting::default()).expect("bare parts").parts
}

#[divan::bench(args = STATIONS)]
fn drawing(bencher: Bencher, stations: u32) {
    let list = list(&sizes(stations));
    bencher.bench_local(|| dxf(black_box(&list), PartLayout::Apart));
}

#[divan::bench(args = STATIONS)]
fn mesh(bencher: Bencher, stations: u32) {
    let list = list(&sizes(stations));
    bencher.bench_local(|| stl(black_box(&list), 0.01));
}

/// All files of one wheel, from its sizes on.
#[divan::bench(args = STATIONS)]
fn all(bencher: Bencher, stations: u32) {
    let sizes = sizes(stations);
    bencher.bench_local(|| {
        let list = list(black_box(&sizes));
        let tolerance = 0.1 * sizes.play.slot;
        let flat = (dxf(&list, PartLayout::Apart), svg_parts(&list, 0.1));
        let solid = (stl(&list, tolerance), three_mf(&list, tolerance), step(&list));
        (flat, solid, scad(&sizes, 5.0, tolerance, &Mounting::default(), 0.0))
    });
}
