//! What texts of each structure take: time, and the most memory at once.

#[path = "../tests/structures.rs"]
mod structures;

use divan::{AllocProfiler, Bencher, black_box};
use proofread::{CheckOptions, proofread};

#[global_allocator]
static MEMORY: AllocProfiler = AllocProfiler::system();

/// Bytes of a text.
const SIZES: [usize; 3] = [10_000, 100_000, 1_000_000];

fn main() {
    divan::main();
}

fn names() -> Vec<String> {
    let size = |name: String| SIZES.map(|size| format!("{name}, {size} bytes"));
    let all = structures::all().into_iter().map(|(name, format, _)| format!("{}: {name}", format.name()));
    all.flat_map(size).collect()
}

/// To see one of them, give a part of its name.
#[divan::bench(args = names(), sample_count = 1)]
fn text(bencher: Bencher, name: &str) {
    let (text, format) = structures::all()
        .into_iter()
        .flat_map(|(of, format, grown)| {
            let known = SIZES.map(|size| (format!("{}: {of}, {size} bytes", format.name()), size));
            let size = known.into_iter().find(|(known, _)| known == name).map(|(_, size)| size);
            size.map(|size| (grown(size), format))
        })
        .next()
        .expect("a structure");
    bencher.bench_local(|| proofread(black_box(&text), format, CheckOptions::default()));
}
