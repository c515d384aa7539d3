//! What chance is expected to explain is the mean of what it explains.

use crate::tables::tables;
use geneva_case1973::chance::{ShuffleScope, expected_cells, shuffles_of_cells};
use geneva_case1973::rise_times::{groups, shuffles_of_definitions, try_definitions};
use geneva_case1973::witness::sampling;
use geneva_case1973::{Column, Hypothesis, Score, Trend, pairs_by_torque};
use geneva_kinematics::Mechanism;

/// Asserts that the mean of some counts is what is expected, but for chance: 4.5 standard errors.
#[track_caller]
fn assert_mean(counts: &[usize], expected: f64) {
    let number = counts.len() as f64;
    let mean = counts.iter().sum::<usize>() as f64 / number;
    let square = |count: &usize| (*count as f64 - mean) * (*count as f64 - mean);
    let standard_error = (counts.iter().map(square).sum::<f64>() / number).sqrt() / number.sqrt();
    assert!((mean - expected).abs() <= 4.5 * standard_error + 1e-9, "{mean} ± {standard_error}, expected {expected}");
}

#[test]
fn counting_pairs_and_sampling_expect_as_much_of_chance() {
    let score = Score::new(Hypothesis::WITHOUT_LAG, tables());
    for mechanism in Mechanism::ALL {
        let expected = expected_cells(&score, &[mechanism]).expect("runs");
        assert!(expected > 0.0 && expected < score.within_one_of(&[mechanism]) as f64);
        assert_mean(&shuffles_of_cells(&score, &[mechanism], 4000).expect("runs"), expected);
        assert_mean(&sampling::cells(&score, &[mechanism], 4000).expect("runs"), expected);
    }
}

#[test]
fn counting_pairs_and_sampling_expect_as_much_of_each_definition_and_the_best_of_all_explains_more() {
    let tried = try_definitions(tables(), 0.01);
    for of in tried.iter().flat_map(|tried| [&tried.as_run, &tried.ideal]) {
        assert_mean(&sampling::rises(tables(), &[&of.times], false, 1000), of.by_chance);
    }
    let mean = |counts: &[usize]| counts.iter().sum::<usize>() as f64 / counts.len() as f64;
    let times: Vec<&[f64]> = tried.iter().flat_map(|tried| [&tried.as_run.times[..], &tried.ideal.times]).collect();
    let [anywhere, alike] = [ShuffleScope::InTables, ShuffleScope::AmongEqualTorques].map(|of| {
        let found = mean(&shuffles_of_definitions(tables(), &tried, of, 1000));
        let again = mean(&sampling::rises(tables(), &times, of == ShuffleScope::AmongEqualTorques, 1000));
        assert!((found - again).abs() < 0.4, "{of:?}: {found} {again}");
        found
    });
    let one = tried.iter().map(|tried| tried.as_run.by_chance).fold(0.0, f64::max);
    assert!(one < anywhere && anywhere < alike, "{one} {anywhere} {alike}");
    // The tables have the first minimum for their rise time.
    let best = tried.iter().max_by_key(|tried| tried.as_run.rows()).expect("a definition");
    assert_eq!(best.name, "the first minimum");
    assert!(best.as_run.rows() + 1 >= tables().len(), "{:?}", best.as_run);
}

#[test]
fn a_time_of_the_motion_alone_falls_with_the_torque_as_its_root() {
    assert_eq!(groups(tables()).iter().filter(|group| group.possible).count(), 6);
    let torque = Trend::count(Column::Rise, pairs_by_torque(tables()));
    assert_eq!((torque.pairs, torque.up), (18, 0));
}
