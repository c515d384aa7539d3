//! What must hold of the drawings of the steady motion.

use super::contact::at_instants;
use super::{accelerations, contact, phase, return_map};
use crate::FigureError;
use crate::checks::{ParsedDrawing, assert_sound, columns};
use geneva_dynamics::joints::{Escapement, Joints};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::timer::Accelerations;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

fn parameters(mechanism: Mechanism, friction: f64) -> Parameters {
    Parameters::new(mechanism, Inertias::new(3.0, 40.0).expect("sound"), 7.0, friction).expect("sound")
}

#[test]
fn the_curve_crosses_the_diagonal_at_the_steady_motion_only() {
    for mechanism in Mechanism::ALL {
        let one = parameters(mechanism, 0.125);
        let figure = return_map(&one).expect("drawn");
        assert_sound(&figure);
        let steady = Engagement::new(&one).and_then(|of| of.steady_state()).expect("steady");
        let fixed = steady.entry_speed * steady.entry_speed / one.drive();
        // Without friction the gain is the work of the torque: 2 × 2π/m over the driver's inertia.
        let gain = 4.0 * mechanism.engagement_half_angle() / one.inertias().ratio();
        for [entry, exit, free] in columns(&figure.series, ["u entry", "u exit", "without friction"]) {
            assert_eq!(exit > entry, entry < fixed, "{entry} {exit}");
            assert!((free - entry - gain).abs() < 1e-9 * gain);
        }
        // The fixed point is on the diagonal through the corner, where the staircase begins.
        let drawing = ParsedDrawing::parse(&figure);
        let diagonal = drawing.path("diagonal", 0);
        let (point, along) = (drawing.centre("fixed-point") - diagonal[0], diagonal[1] - diagonal[0]);
        assert!(along.perp(&point).abs() < 0.2 * along.norm() && point.norm() > 1.0, "{point}");
        assert_eq!(drawing.path("stairs", 0)[0], diagonal[0]);
    }
    assert!(matches!(return_map(&parameters(Mechanism::FOUR_PIN, 0.0)), Err(FigureError::Dynamics(_))));
}

#[test]
fn engagements_from_rest_and_from_above_enclose_the_steady_cycle() {
    for mechanism in Mechanism::ALL {
        let one = parameters(mechanism, 0.125);
        let figure = phase(&one).expect("drawn");
        assert_sound(&figure);
        let steady = Engagement::new(&one).and_then(|of| of.steady_state()).expect("steady");
        let names = ["rest 1", "rest 2", "rest 3", "steady", "above 3", "above 2", "above 1"];
        let rows = columns(&figure.series, names);
        // The steady cycle ends with the speed at which it begins.
        let entry = steady.entry_speed / one.drive().sqrt();
        let [first, last] = [rows[0], rows[rows.len() - 1]].map(|[_, _, _, steady, ..]| steady);
        assert!((first - entry).abs() < 1e-12 && (last - entry).abs() < 1e-6 * first);
        for row in &rows {
            let [_, _, _, steady, ..] = row;
            assert!(row.is_sorted_by(|slower, faster| *slower <= faster + 1e-6 * steady), "{row:?}");
        }
        let drawing = ParsedDrawing::parse(&figure);
        assert_eq!(["from-rest", "from-above", "cycle"].map(|class| drawing.count(class)), [3, 3, 1]);
        assert_eq!(drawing.count("marks"), 3);
    }
    assert!(phase(&parameters(Mechanism::FOUR_PIN, 0.0)).is_err());
}

#[test]
fn the_accelerations_are_drawn_up_to_their_strongest() {
    for mechanism in Mechanism::ALL {
        let one = parameters(mechanism, 0.125);
        let figure = accelerations(&one, "an example").expect("drawn");
        assert_sound(&figure);
        let strongest = Accelerations::new(&one).expect("steady");
        for (name, value) in [
            ("theta''", strongest.driver.value / 1000.0),
            ("phi''", strongest.follower.value / 1000.0),
            ("F R/K", strongest.normal_moment.value / one.torque()),
        ] {
            let drawn = columns(&figure.series, [name]).into_iter().flatten();
            let drawn = drawn.max_by(|a, b| a.abs().total_cmp(&b.abs())).expect("rows");
            assert!((drawn / value - 1.0).abs() < 0.04, "{name}: {drawn} and {value}");
        }
        let rows = columns(&figure.series, ["theta'", "phi'", "phi''"]);
        let ([driver, follower, acceleration], [end_driver, _, end_acceleration]) = (rows[0], rows[rows.len() - 1]);
        approx::assert_relative_eq!(acceleration - end_acceleration, strongest.jump / 1000.0, max_relative = 1e-9);
        assert!((driver / end_driver - 1.0).abs() < 1e-9 && follower == 0.0);
        let drawing = ParsedDrawing::parse(&figure);
        assert_eq!((drawing.count("force"), drawing.count("curve")), (1, 4));
    }
    assert!(accelerations(&parameters(Mechanism::FOUR_PIN, 0.0), "none").is_err());
}

#[test]
fn the_surface_of_a_pin_slides_more_slowly_than_its_centre_moves() {
    for mechanism in [Mechanism::THREE_PIN, Mechanism::FOUR_PIN] {
        let half = mechanism.engagement_half_angle();
        for pin_radius in [0.05, 0.1] {
            let joints = Joints { pin_radius, ..Joints::IDEAL };
            let one = Escapement::new(&parameters(mechanism, 0.125), joints).expect("it runs");
            let steady = one.steady_state(contact::TOLERANCE).expect("steady").state;
            let instants = [(-0.7 * half, steady.entry_speed), (steady.peak.angle, steady.peak.speed)];
            let figure = at_instants(&one, instants).expect("drawn");
            assert_sound(&figure);
            let drawing = ParsedDrawing::parse(&figure);
            assert_eq!(["wall", "bearing-flank", "enlarged-pin"].map(|class| drawing.count(class)), [4, 2, 2]);
            let rows = &figure.series.rows;
            assert_eq!(columns(&figure.series, ["side"]), [[1.0], [-1.0]]);
            for [centre, turning, surface] in columns(&figure.series, ["dr/dtheta", "s rho (1+q)", "w/theta'"]) {
                assert!(surface.abs() < centre.abs() && surface * centre > 0.0, "{centre} {surface}");
                assert!((centre + turning - surface).abs() < 1e-12);
            }
            // The steady motion itself: only the first instant is nearer to the line of centres.
            let itself = contact(&parameters(mechanism, 0.125), pin_radius).expect("drawn").series.rows;
            assert!(itself[0][0] > rows[0][0] && itself[1] == rows[1]);
        }
        let one = Escapement::new(&parameters(mechanism, 0.125), Joints::IDEAL).expect("it runs");
        assert!(at_instants(&one, [(-half, 1.0), (1.1 * half, 1.0)]).is_err());
    }
}
