//! How long a record and a check of a large text take: one megabyte with 5,000 numbers, and as many values.

use divan::{Bencher, black_box};
use geneva_values::RecordRequest;
use std::fs;
use tempfile::TempDir;

fn main() {
    divan::main();
}

/// A folder with the text and its values.
fn project() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let mut rng = fastrand::Rng::with_seed(1);
    let (mut text, mut values) = (String::new(), Vec::new());
    for at in 0..5000 {
        let number = 10.0 + f64::from(at) / 7.0;
        let words: String = (0..36).map(|_| ["time ", "rod ", "long ", "mass "][rng.usize(..4)]).collect();
        text += &format!("The number {words}is {number:.5} in this place. ");
        text += if at % 5 == 0 { "\n\n" } else { "\n" };
        values.push(format!("\"k{at}\": {number:.9}"));
    }
    assert!(text.len() > 1_000_000, "{}", text.len());
    fs::write(folder.path().join("text.md"), text).expect("written");
    fs::write(folder.path().join("values.json"), format!("{{{}}}", values.join(","))).expect("written");
    folder
}

#[divan::bench(sample_count = 10)]
fn record(bencher: Bencher<'_, '_>) {
    bencher.with_inputs(project).bench_values(|folder| {
        let request = RecordRequest { named: vec![folder.path().to_owned()], ..RecordRequest::default() };
        let report = geneva_values::record(&request).expect("a record");
        assert_eq!(report.added, 5000);
        (black_box(report), folder)
    });
}

#[divan::bench(sample_count = 10)]
fn check(bencher: Bencher<'_, '_>) {
    let folder = project();
    let request = RecordRequest { named: vec![folder.path().to_owned()], ..RecordRequest::default() };
    geneva_values::record(&request).expect("a record");
    bencher.bench_local(|| {
        let report = geneva_values::check(folder.path(), false).expect("a check");
        assert!(report.is_right());
        black_box(report)
    });
}
