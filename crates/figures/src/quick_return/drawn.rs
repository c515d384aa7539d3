//! What must hold of the drawings as they are written, read back from the SVG.

use super::{acceleration_diagram, bead_on_a_lever, mechanism, over_a_turn, velocity_diagram};
use crate::Figure;
use crate::checks::{PIXELS, ParsedDrawing, assert_drawn, assert_sound, columns, number};
use geneva_kinematics::Turn;
use geneva_kinematics::quick_return::{Branch, Drive, Position, QuickReturn};
use nalgebra::Vector2;

const STEADY: Drive<f64> = Drive { speed: 4.0, acceleration: 0.0 };

fn linkage(ground: f64, crank: f64) -> QuickReturn {
    QuickReturn::new(ground, crank).expect("possible")
}

fn all_four(linkage: &QuickReturn, position: &Position, drive: &Drive<f64>) -> [Figure; 4] {
    [
        mechanism(linkage, position, drive, "m"),
        velocity_diagram(linkage, position, drive, "m"),
        acceleration_diagram(linkage, position, drive, "m"),
        over_a_turn(linkage, position, drive),
    ]
}

/// A position in general, as a reader is shown it.
fn usual() -> [Figure; 4] {
    let linkage = linkage(0.5, 0.24);
    all_four(&linkage, &linkage.position_at_lever_degrees(21.0, Branch::Far).expect("reached"), &STEADY)
}

/// Levers that swing and turn, all around and at the ends of the swing, the crank steady or not, turning either way.
fn each_case(mut check: impl FnMut(&QuickReturn, &Position, &Drive<f64>)) {
    for (ground, crank) in [(5.0, 0.5), (0.5, 0.22), (1.01, 1.0), (1.0, 1.0), (0.3, 0.7)] {
        let linkage = linkage(ground, crank);
        let end = 180.0 - linkage.strokes().fast.to_degrees() / 2.0;
        let drives = [Drive { speed: 3.0, acceleration: 0.0 }, Drive { speed: -3.0, acceleration: 4.0 }];
        for (k, degrees) in [0.0, 71.0, end, 151.0, 180.0, 200.0, 264.0, -end, 333.0].into_iter().enumerate() {
            // With equal lengths the pin would be on the lever's pivot at a half turn.
            if let Ok(position) = linkage.position_at_crank_degrees(degrees) {
                check(&linkage, &position, &drives[k % 2]);
            }
        }
    }
}

#[test]
fn every_case_is_drawn_and_a_usual_one_is_sound() {
    usual().iter().for_each(assert_sound);
    each_case(|linkage, position, drive| {
        assert_drawn(&mechanism(linkage, position, drive, "m"));
        assert_drawn(&velocity_diagram(linkage, position, drive, "m"));
        assert_drawn(&acceleration_diagram(linkage, position, drive, "m"));
        // The curves of a linkage are the same but for the marked instant.
        if position.crank.sin >= 0.0 && drive.speed > 0.0 {
            assert_drawn(&over_a_turn(linkage, position, drive));
        }
    });
}

#[test]
fn a_crank_at_rest_and_sizes_far_apart_are_drawn_too() {
    let rest = Drive { speed: 0.0, acceleration: 0.0 };
    for (ground, crank) in [(0.5, 0.22), (1e-9, 1e3), (1e6, 1e-3), (3e-160, 1e-160)] {
        let linkage = linkage(ground, crank);
        for drive in [rest.clone(), STEADY] {
            let position = linkage.position_at_crank_degrees(100.0).expect("off the pivot");
            all_four(&linkage, &position, &drive).iter().for_each(assert_drawn);
        }
    }
}

#[test]
fn both_sides_of_both_equations_meet() {
    each_case(|linkage, position, drive| {
        let velocity = velocity_diagram(linkage, position, drive, "m");
        let acceleration = acceleration_diagram(linkage, position, drive, "m");
        for (figure, ours) in [(velocity, 1), (acceleration, 2)] {
            let rows = columns(&figure.series, ["x", "y", "magnitude", "direction"]);
            let vector = |[x, y, ..]: &[f64; 4]| Vector2::new(*x, *y);
            let greatest = rows.iter().map(|[_, _, magnitude, _]| *magnitude).fold(0.0, f64::max);
            let [summands @ .., last_gap] = &rows[..] else { panic!("no rows") };
            let sum = |side: &[[f64; 4]]| side.iter().map(vector).sum::<Vector2<f64>>();
            let gap = sum(&summands[..ours]) - sum(&summands[ours..]);
            assert!(gap.norm() < 1e-12 * greatest, "{}: {gap}", figure.id);
            assert!(last_gap[2] < 1e-12 * greatest, "{}", figure.id);
            for row @ [_, _, magnitude, direction] in &rows {
                let back = Turn::from_degrees(*direction).direction() * *magnitude;
                assert!((back - vector(row)).norm() < 1e-6 * greatest, "{}", figure.id);
            }
        }
    });
}

#[test]
fn the_arrows_close_and_are_to_scale() {
    let [_, velocity, acceleration, _] = usual();
    let row = |figure: &Figure, k: usize| Vector2::new(figure.series.rows[k][1], -figure.series.rows[k][2]);
    let names: [&[(&str, usize)]; 2] = [
        &[("v-pin", 0), ("v-lever", 1), ("v-sliding", 2)],
        &[("a-pin-normal", 0), ("a-lever-normal", 2), ("a-lever-tangential", 3), ("a-sliding", 5), ("a-coriolis", 6)],
    ];
    for (figure, names) in [velocity, acceleration].iter().zip(names) {
        let drawing = ParsedDrawing::parse(figure);
        let [tail, tip] = drawing.arrow(names[0].0).expect("an arrow");
        let scale = (tip - tail).norm() / row(figure, 0).norm();
        let mut tips = vec![tip];
        let mut tails = vec![tail];
        for (name, k) in &names[1..] {
            let [tail, tip] = drawing.arrow(name).expect("an arrow");
            assert!((tip - tail - row(figure, *k) * scale).norm() < PIXELS, "{name}");
            tails.push(tail);
            tips.push(tip);
        }
        // Every arrow but those at the pole begins where another ends, to the digit.
        let loose = tails.iter().filter(|at| !tips.contains(at)).count();
        assert_eq!(loose, 2, "{}: two begin at the pole", figure.id);
        // The first scale bar is that of the small steps, the second that of the last one, whose arrows are named.
        let bars = drawing.elements("scale-bar");
        let said = drawing.texts().into_iter().filter(|text| text.contains(" in step"));
        let said: Vec<f64> =
            said.map(|text| text.split(' ').next().and_then(|of| of.parse().ok()).expect("said")).collect();
        for (bar, said, smaller) in [(&bars[0], said[0], 1.5), (&bars[1], said[1], 1.0)] {
            let value = (number(bar, "x2") - number(bar, "x1")) / scale * smaller;
            assert!((value - said).abs() * scale < 2.0 * PIXELS, "{value} for {said}");
        }
    }
}

#[test]
fn the_steps_are_numbered() {
    for (figure, count) in usual()[1..3].iter().zip([3, 5]) {
        let drawing = ParsedDrawing::parse(figure);
        let texts = drawing.texts();
        for number in 1..=count {
            assert!(texts.contains(&number.to_string()), "{}: {number}", figure.id);
        }
    }
}

#[test]
fn the_mechanism_is_to_scale_and_shows_the_other_branch_only_where_there_is_one() {
    each_case(|linkage, position, drive| {
        let figure = mechanism(linkage, position, drive, "m");
        let drawing = ParsedDrawing::parse(&figure);
        let radius = drawing.number("pin-circle", "r");
        let from_axis = drawing.centre("pin") - drawing.centre("pin-circle");
        let direction = Vector2::new(position.crank.cos, -position.crank.sin);
        assert!((from_axis - direction * radius).norm() < PIXELS);
        let swings = linkage.strokes().swing_limit.is_some();
        assert_eq!(drawing.count("swing-end"), if swings { 2 } else { 0 });
        assert!(drawing.count("other-branch") == 0 || linkage.ratio() > 1.0);
    });
    let document = usual().map(|figure| figure.svg).concat();
    assert_eq!(document.matches("other point").count(), 1);
}

#[test]
fn the_curves_go_all_around_and_reverse_with_the_lever() {
    for (ground, crank) in [(0.5, 0.22), (0.5, 0.8)] {
        let linkage = linkage(ground, crank);
        let position = linkage.position_at_crank_degrees(64.0).expect("off the pivot");
        let figure = over_a_turn(&linkage, &position, &STEADY);
        let (rows, strokes) = (columns(&figure.series, ["theta", "phi", "phi'", "phi''"]), linkage.strokes());
        assert_eq!(rows.len(), 361);
        assert!(rows.is_sorted_by(|[_, before, ..], [_, phi, ..]| (phi - before).abs() < 15.0), "φ has no jump");
        let [[_, first, ..], [_, last, ..]] = [rows[0], rows[360]];
        assert_eq!(last - first, if strokes.swing_limit.is_some() { 0.0 } else { 360.0 });
        // Differences of the angle are the angular velocity, differences of that the angular acceleration.
        for triple in rows.windows(3) {
            let step = (1.0_f64 / STEADY.speed).to_radians();
            let [[_, phi_before, speed_before, _], [theta, _, speed, rate], [_, phi_after, speed_after, _]] = triple
            else {
                panic!("three rows")
            };
            let of_angle = (phi_after - phi_before).to_radians() / (2.0 * step);
            assert!((of_angle - speed).abs() < 1e-2 * STEADY.speed, "at {theta}");
            let of_speed = (speed_after - speed_before) / (2.0 * step);
            assert!((of_speed - rate).abs() < 1e-2 * STEADY.speed * STEADY.speed, "at {theta}");
        }
        if strokes.swing_limit.is_some() {
            let end = (strokes.fast / 2.0).to_degrees();
            let before = rows.iter().filter(|[theta, ..]| *theta < -end).all(|[_, _, speed, _]| *speed > 0.0);
            let after = rows.iter().filter(|[theta, ..]| theta.abs() < end).all(|[_, _, speed, _]| *speed < 0.0);
            assert!(before && after);
        }
        let drawing = ParsedDrawing::parse(&figure);
        for (class, count) in [("fast", 3), ("reversal", 6), ("instant", 3), ("now", 3)] {
            assert_eq!(drawing.count(class), count, "{class}");
        }
    }
}

#[test]
fn the_two_strips_of_the_bead_are_equal_and_end_where_the_bead_does() {
    let figure = bead_on_a_lever();
    assert_sound(&figure);
    let drawing = ParsedDrawing::parse(&figure);
    let farther = drawing.path("farther", 0);
    let length: f64 = farther.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    let turned = drawing.length("turned");
    assert!((turned - length).abs() < 0.01 * length, "{turned} and {length}");
    let beads = drawing.elements("bead");
    let last = Vector2::new(number(&beads[2], "cx"), number(&beads[2], "cy"));
    assert!((farther[farther.len() - 1] - last).norm() < PIXELS);
    // The slide as it would be had the lever not turned, and the one that is, begin at the bead.
    let middle = Vector2::new(number(&beads[1], "cx"), number(&beads[1], "cy"));
    assert!((drawing.line("unturned")[0] - middle).norm() < PIXELS);
    assert!((drawing.path("slide", 2)[0] - middle).norm() < PIXELS);
}
