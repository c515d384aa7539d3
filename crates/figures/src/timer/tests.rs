//! What must hold of the drawings of the timer.

use super::{Tested, friction, sensitivity, settling, strongest, torque};
use crate::FigureError;
use crate::checks::{ParsedDrawing, assert_drawn, assert_sound, columns};
use geneva_dynamics::existence::critical_friction;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::timer::{Accelerations, Sensitivities};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

fn tested() -> Vec<Tested> {
    let of = |mechanism| {
        let parameters = Parameters::new(mechanism, Inertias::new(3.0, 40.0).expect("sound"), 7.0, 0.2).expect("sound");
        Tested { parameters, frictions: vec![0.1, 0.15, 0.2] }
    };
    Mechanism::ALL.map(of).to_vec()
}

#[test]
fn half_the_torque_loses_the_hours_of_the_root() {
    let figure = torque();
    assert_sound(&figure);
    let rows = columns(&figure.series, ["torque", "gain^1/2", "gain^1/3", "gain^1"]);
    let [torque, root, ..] = rows[0];
    assert!((root - 24.0 * (0.5_f64.sqrt() - 1.0)).abs() < 1e-12 && torque == 50.0);
    assert!(rows.contains(&[100.0, 0.0, 0.0, 0.0]), "no gain at the torque at which it was set");
    // The root lies between the powers of a verge with a drag, on both sides.
    assert!(rows.iter().all(|[_, root, cube_root, first]| (root - cube_root) * (root - first) <= 0.0));
    // The name of the verge is in its area, below the root.
    let (named, height) = torque::NAMED;
    for torque in [named.start, named.end] {
        let row @ [_, root, _, first] = rows.iter().find(|row| (row[0] - torque).abs() < 0.51).expect("a row near it");
        assert!(*first < height && height < *root, "{row:?}");
    }
    let drawing = ParsedDrawing::parse(&figure);
    assert_eq!(["root", "verge", "own-period"].map(|class| drawing.count(class)), [2, 2, 2]);
}

#[test]
fn the_rate_falls_with_the_friction_through_the_one_at_which_it_was_set() {
    let pairs = [(0.09, "some oil"), (0.22, "dry")];
    let figure = friction(&tested(), 0.15, &pairs).expect("drawn");
    assert_sound(&figure);
    let rows = columns(&figure.series, ["pins", "mu", "gain"]);
    for curve in rows.chunk_by(|[one, ..], [other, ..]| one == other) {
        assert!(curve.is_sorted_by(|[_, mu, gain], [_, more, less]| more > mu && less < gain), "{curve:?}");
    }
    for [_, mu, gain] in &rows {
        assert!((mu - 0.15) * gain <= 0.0, "{mu} {gain}");
    }
    let drawing = ParsedDrawing::parse(&figure);
    assert_eq!(["rate", "marks", "pair"].map(|class| drawing.count(class)), [3, 3, 2]);
    let one = tested()[0].clone();
    let speed = |mu: f64| {
        Engagement::new(&one.with_friction(mu).expect("sound"))
            .and_then(|of| of.steady_state())
            .expect("steady")
            .mean_speed
    };
    let own = f64::from(one.parameters.mechanism().pins());
    let [_, mu, gain] = rows.iter().rfind(|[pins, ..]| *pins == own).expect("a row");
    assert!((gain - 24.0 * (speed(*mu) / speed(0.15) - 1.0)).abs() < 1e-9);
}

#[test]
fn a_curve_ends_before_the_escapement_jams() {
    let all = tested();
    let figure = friction(&all, 0.15, &[(3.0, "too much")]).expect("drawn");
    assert_drawn(&figure);
    for one in &all {
        let (pins, ratio) = (one.parameters.mechanism().pins(), one.parameters.inertias().ratio());
        let limit = critical_friction(one.parameters.mechanism(), ratio).expect("a limit").friction;
        let last = figure.series.rows.iter().rfind(|row| row[0] == f64::from(pins)).expect("a row")[1];
        assert!(last < limit && last > 0.99 * limit, "{last} {limit}");
    }
}

#[test]
fn the_minutes_are_those_of_the_powers() {
    let figure = sensitivity(&tested()).expect("drawn");
    assert_sound(&figure);
    let one = &tested()[0];
    let own = f64::from(one.parameters.mechanism().pins());
    let rows = columns(&figure.series, ["pins", "mu", "gain K", "gain mu", "gain I_D", "gain I_f"]);
    let [_, mu, gains @ ..] = rows.iter().find(|[pins, ..]| *pins == own).expect("a row");
    let found = Sensitivities::new(&one.with_friction(*mu).expect("sound")).expect("steady");
    for (minutes, power) in
        gains.iter().zip([found.torque, found.friction, found.driver_inertia, found.follower_inertia])
    {
        assert!((minutes - 14.4 * power).abs() < 1e-9);
    }
    let drawing = ParsedDrawing::parse(&figure);
    assert_eq!(["gain", "of-torque", "marks"].map(|class| drawing.count(class)), [9, 1, 9]);
}

#[test]
fn the_greatest_values_hold_for_every_torque() {
    let figure = strongest(&tested()).expect("drawn");
    assert_sound(&figure);
    let mut stronger = tested();
    for one in &mut stronger {
        let of = &one.parameters;
        one.parameters =
            Parameters::new(of.mechanism(), of.inertias(), 3.0 * of.torque(), of.friction()).expect("sound");
    }
    let other = strongest(&stronger).expect("drawn");
    for (row, same) in figure.series.rows.iter().zip(&other.series.rows) {
        assert!(row.iter().zip(same).all(|(a, b)| (a - b).abs() < 1e-6 * a.abs()), "{row:?} {same:?}");
    }
    let one = &tested()[1];
    let own = f64::from(one.parameters.mechanism().pins());
    let rows = columns(&figure.series, ["pins", "mu", "F R/K"]);
    let [_, mu, force] = rows.iter().find(|[pins, ..]| *pins == own).expect("a row");
    let found = Accelerations::new(&one.with_friction(*mu).expect("sound")).expect("steady");
    assert!((force - found.normal_moment.value.abs() / one.parameters.torque()).abs() < 1e-9);
    assert_eq!(ParsedDrawing::parse(&figure).count("greatest"), 12);
}

#[test]
fn the_key_shows_the_dashes_of_the_curves() {
    let all = tested();
    for (figure, class) in
        [(friction(&all, 0.15, &[]), "rate"), (sensitivity(&all), "gain"), (strongest(&all), "greatest")]
    {
        let figure = figure.expect("drawn");
        let drawing = ParsedDrawing::parse(&figure);
        let looks = |class: &str| {
            let of = |node: &roxmltree::Node<'_, '_>| {
                ["stroke", "stroke-dasharray"].map(|name| node.attribute(name).map(str::to_owned))
            };
            let lines =
                drawing.elements(class).into_iter().filter(|node| ["line", "path"].contains(&node.tag_name().name()));
            lines
                .map(|node| of(&node))
                .filter(|[stroke, _]| stroke.is_some())
                .collect::<std::collections::BTreeSet<_>>()
        };
        let (key, curves) = (looks("sample"), looks(class));
        assert_eq!(curves.len(), all.len(), "{}: {curves:?}", figure.id);
        assert!(curves.is_subset(&key), "{}: {curves:?} in {key:?}", figure.id);
    }
}

#[test]
fn what_has_no_runs_is_refused_and_settling_is_drawn() {
    for figure in [friction(&[], 0.2, &[]), sensitivity(&[]), strongest(&[])] {
        assert_eq!(figure, Err(FigureError::Nothing));
    }
    let own = tested()[0].parameters;
    let figure = settling(&own, &[1.0, 2.0, 4.0], "an example").expect("drawn");
    assert_sound(&figure);
    let multiplier = Engagement::new(&own).and_then(|of| of.steady_state()).expect("steady").multiplier;
    let [part, engagements, period, time] = [0, 1, 2, 3].map(|column| figure.series.rows[0][column]);
    assert!(part == 1.0 && (libm::pow(multiplier, engagements) / 0.01 - 1.0).abs() < 1e-9);
    assert!((time / (period * engagements) - 1.0).abs() < 1e-12);
    assert_eq!(ParsedDrawing::parse(&figure).count("marks"), 3);
    assert_eq!(settling(&own, &[], "nothing"), Err(FigureError::Nothing));
}
