//! Do both routes find the data with which the tables were made?

use crate::tables::tables;
use geneva_case1973::fitted::{self, InertiaFit, Motions, most_within_one, ratios};
use geneva_case1973::witness::gauss_newton;
use geneva_case1973::{EXPLAINED, Hypothesis, Reset, rows_of};
use geneva_kinematics::Mechanism;

#[test]
fn both_routes_find_the_inertias_friction_and_torque_of_the_runs() {
    for mechanism in Mechanism::ALL {
        let table = rows_of(tables(), mechanism);
        let reset = Hypothesis::WITHOUT_LAG.angle(&table[0]);
        let found = fitted::inertias(table, reset, 1.0).expect("inertias");
        let (in_steps, misfits) = gauss_newton::inertias(table, reset).expect("inertias");
        let known_to = gauss_newton::uncertainties(table, in_steps).expect("a table with slopes");
        assert_eq!(misfits.len(), EXPLAINED.len() * table.len());
        for (at, given) in table[0].given.drawn.into_iter().enumerate() {
            assert!((found[at] / in_steps[at] - 1.0).abs() < 1e-3, "{mechanism:?}: {found:?} {in_steps:?}");
            // The printed peak may miss the true one by more than a unit.
            assert!((found[at] - given).abs() < 4.0 * known_to[at], "{mechanism:?}: {found:?} ± {known_to:?}");
        }
        let row = &table[1];
        let pairs = [
            (fitted::friction(row), gauss_newton::friction(row), row.friction()),
            (fitted::torque(row), gauss_newton::torque(row), row.torque()),
        ];
        for (by_sections, by_tangents, given) in pairs {
            let (by_sections, by_tangents) = (by_sections.expect("found"), by_tangents.expect("found"));
            assert!((by_sections / by_tangents.value - 1.0).abs() < 1e-4, "{by_sections}");
            assert!((by_sections - given).abs() < 2.0 * by_tangents.reach, "{by_sections} ± {}", by_tangents.reach);
        }
    }
}

#[test]
fn no_inertias_make_up_for_the_wrong_reset() {
    for mechanism in [Mechanism::SIX_PIN, Mechanism::THREE_PIN] {
        let table = rows_of(tables(), mechanism);
        let of = |reset| InertiaFit::new(table, reset).expect("a motion");
        let [own, program] = [Reset::OfTheMechanism, Reset::QuarterTurn].map(of);
        assert!(own.within_one() < program.within_one() && own.mean_misfit() > 4.0 * program.mean_misfit());
        let most = |reset| most_within_one(table, reset).expect("a motion");
        assert!(most(Reset::OfTheMechanism) >= own.within_one() && most(Reset::QuarterTurn) >= program.within_one());
        assert!(most(Reset::OfTheMechanism) < most(Reset::QuarterTurn));
    }
    assert_eq!(InertiaFit::new(&[], Reset::QuarterTurn), None);
}

#[test]
fn trying_followers_one_by_one_brings_nearly_as_many_results_near_and_never_more() {
    let table = rows_of(tables(), Mechanism::SIX_PIN);
    let angle = 2.0 * Mechanism::SIX_PIN.engagement_half_angle();
    let most = most_within_one(table, Reset::OfTheMechanism).expect("a motion");
    let [least, greatest] = ratios(table, 1.0).expect("a motion").map(libm::log);
    let of = |step: u32| {
        let ratio = libm::exp(least + (greatest - least) * f64::from(step) / 100.0);
        let motions = Motions::new(table, angle, 1.0, ratio)?;
        let near = |follower: f64| motions.misfits(follower).iter().filter(|off| off.abs() <= 1.0 + 1e-9).count();
        (0..400).map(|step| near(1e-6 * libm::pow(1.015, f64::from(step)))).max()
    };
    let found = (0..=100).filter_map(of).max().expect("a motion");
    assert!((most - 3..=most).contains(&found), "{found} {most}");
}
