//! What must hold of the drawings as they are written, read back from the SVG.

use super::forces::forces;
use super::{angles, existence, hand_over, mechanism, normal_force, order, ratios};
use crate::checks::{PIXELS, ParsedDrawing, assert_drawn, assert_sound, columns, number};
use crate::{Figure, FigureError};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;
use geneva_kinematics::indexing::Indexing;
use nalgebra::Vector2;

fn parameters(mechanism: Mechanism, friction: f64) -> Parameters {
    Parameters::new(mechanism, Inertias::new(3.0, 40.0).expect("sound"), 7.0, friction).expect("sound")
}

#[test]
fn the_figures_as_a_reader_is_shown_them_are_sound() {
    [ratios(&Mechanism::ALL), existence(&existence::tests::designs()), order()].iter().for_each(assert_sound);
    for one in Mechanism::ALL {
        let (state, half) = (parameters(one, 0.125), one.engagement_half_angle());
        assert_sound(&mechanism(&one, -0.4 * half).expect("engaged"));
        assert_sound(&hand_over(&one));
        for share in [-0.6, 0.6] {
            assert_sound(&angles(&one, share * half).expect("engaged"));
            assert_sound(&forces(&state, share * half, 0.5).expect("engaged"));
        }
        assert_sound(&normal_force(&state, 0.5).expect("followed"));
    }
}

#[test]
fn every_position_and_state_is_drawn_in_true_numbers() {
    for one in Mechanism::ALL {
        let half = one.engagement_half_angle();
        for share in [-1.0, -0.97, -0.5, -1e-3, -1e-14, 0.0, 0.3, 1.0] {
            assert_drawn(&mechanism(&one, share * half).expect("engaged"));
            assert_drawn(&angles(&one, share * half).expect("engaged"));
            for (friction, speed) in [(0.0, 0.0), (0.125, 0.0), (0.125, 2.0), (0.0, 90.0)] {
                assert_drawn(&forces(&parameters(one, friction), share * half, speed).expect("engaged"));
            }
        }
    }
    // Nothing, one and one twice are drawn too.
    let four = Mechanism::FOUR_PIN;
    [vec![], vec![four], vec![four, four]].iter().for_each(|some| assert_drawn(&ratios(some)));
}

#[test]
fn what_cannot_be_drawn_is_an_error() {
    let (one, state) = (Mechanism::FOUR_PIN, parameters(Mechanism::FOUR_PIN, 0.0));
    for angle in [0.8, f64::NAN, f64::NEG_INFINITY] {
        assert!(matches!(mechanism(&one, angle), Err(FigureError::Escapement(_))));
        assert!(matches!(angles(&one, angle), Err(FigureError::Escapement(_))));
        assert!(matches!(forces(&state, angle, 1.0), Err(FigureError::Escapement(_))));
    }
    for speed in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(forces(&state, 0.0, speed), Err(FigureError::Dynamics(_))));
        assert!(matches!(normal_force(&state, speed), Err(FigureError::Dynamics(_))));
    }
    assert!(matches!(normal_force(&state, 1e200), Err(FigureError::Dynamics(_))));
}

#[test]
fn the_triangles_close_to_nine_places() {
    for one in Mechanism::ALL {
        let half = one.engagement_half_angle();
        let mut drawn: Vec<(Figure, f64)> = vec![(hand_over(&one), half)];
        for share in [-1.0, -0.7, -0.1, 0.4, 1.0] {
            drawn.push((angles(&one, share * half).expect("engaged"), share * half));
        }
        for (figure, theta) in drawn {
            let drawing = ParsedDrawing::parse(&figure);
            let [c, r, distance] = ["side-l", "side-R", "side-r"].map(|name| drawing.path(name, 0));
            assert_eq!([c[0], c[1], r[1]], [r[0], distance[0], distance[1]], "{}", figure.id);
            let vector = |ends: Vec<Vector2<f64>>| ends[1] - ends[0];
            let [c, r, distance] = [c, r, distance].map(vector);
            let ratio = one.centre_distance_ratio();
            assert!((c.norm() / r.norm() - ratio).abs() < 1e-9);
            // The page's y points down: the angle as seen.
            let seen = libm::atan2(c.y * r.x - c.x * r.y, c.dot(&r));
            assert!((seen - theta).abs() < 1e-9, "{}: {seen} for {theta}", figure.id);
            let phi = libm::atan2(distance.perp(&c), -c.dot(&distance));
            let expected = one.wheel().engaged(theta).expect("engaged").angle;
            assert!((phi.abs() - expected.abs()).abs() < 1e-9, "{}: {phi} for {expected}", figure.id);
            // Law of sines; at the hand-over a right angle.
            let sines = distance.norm() * libm::sin(expected) - r.norm() * libm::sin(theta);
            assert!(sines.abs() < 1e-9 * c.norm(), "{}: {sines}", figure.id);
            let at_pin = r.dot(&distance) / (r.norm() * distance.norm());
            assert!(theta.abs() < half * (1.0 - 1e-12) || at_pin.abs() < 1e-9, "{}: {at_pin}", figure.id);
        }
    }
}

#[test]
fn the_follower_and_the_pins_are_to_scale() {
    for one in Mechanism::ALL {
        for share in [-1.0, 0.0, 0.7] {
            let figure = mechanism(&one, share * one.engagement_half_angle()).expect("engaged");
            let drawing = ParsedDrawing::parse(&figure);
            let (axis, crank) = (drawing.centre("pin-circle"), drawing.number("pin-circle", "r"));
            let pins = drawing.elements("pin");
            assert_eq!(pins.len() as u32, one.pins());
            for pin in &pins {
                let at = Vector2::new(number(pin, "cx"), number(pin, "cy"));
                assert!(((at - axis).norm() - crank).abs() < PIXELS);
            }
            let pivot = axis + Vector2::new(one.centre_distance_ratio() * crank, 0.0);
            let reach = drawing.path("follower", 0).iter().map(|at| (at - pivot).norm()).fold(0.0, f64::max);
            assert!((reach - one.rim_radius() * crank).abs() < 0.1, "{reach}");
            assert_eq!(drawing.count("half-angle"), 4);
        }
    }
}

#[test]
fn at_the_hand_over_both_pins_move_along_their_slots() {
    for one in Mechanism::ALL {
        let figure = hand_over(&one);
        let drawing = ParsedDrawing::parse(&figure);
        let (r, pivot) = (drawing.path("side-R", 0), drawing.path("side-r", 0)[0]);
        let (axis, leaving) = (r[0], r[1]);
        for (name, outward) in [("v-leaving", 1.0), ("v-entering", -1.0)] {
            let [tail, tip] = drawing.arrow(name).expect("an arrow");
            let (v, arm) = (tip - tail, tail - axis);
            assert!(v.dot(&arm).abs() < 0.01 * v.norm() * arm.norm(), "at right angles to the crank");
            // Counter-clockwise as seen, with y downwards.
            assert!(arm.perp(&v) < 0.0);
            let along = v.dot(&(tail - pivot).normalize());
            assert!((along * outward - v.norm()).abs() < 0.01 * v.norm(), "{name}");
        }
        assert!((drawing.arrow("v-leaving").expect("an arrow")[0] - leaving).norm() < PIXELS);
        let row = &figure.series.rows[0];
        assert_eq!(row[8..], [1.0, 0.0, -1.0, 0.0]);
    }
}

#[test]
fn forces_point_as_the_equation_of_motion_says() {
    for one in Mechanism::ALL {
        let (sound, half) = (parameters(one, 0.125), one.engagement_half_angle());
        let mut seen = [0; 2];
        for share in [-0.9, -0.5, -0.2, 0.2, 0.5, 0.9] {
            for speed in [0.0, 0.5, 5.0] {
                let figure = forces(&sound, share * half, speed).expect("engaged");
                let drawing = ParsedDrawing::parse(&figure);
                let (axis, crank) = (drawing.centre("pin-circle"), drawing.number("pin-circle", "r"));
                let pivot = axis + Vector2::new(one.centre_distance_ratio() * crank, 0.0);
                // Counter-clockwise as seen is positive, in pixels.
                let moment = |about: Vector2<f64>, [tail, tip]: [Vector2<f64>; 2]| -(tail - about).perp(&(tip - tail));
                let names = ["F R/K", "mu", "-tau_2/K", "arm/R", "r/R", "phi'' I_f/K"];
                let [normal, mu, friction_torque, friction_arm, radius, acceleration] =
                    columns(&figure.series, names)[0];
                seen[usize::from(normal > 0.0)] += 1;
                let reaction = moment(axis, drawing.arrow("normal-on-pin").expect("an arrow"));
                assert!(reaction * normal < 0.0, "{}", figure.id);
                let [tail, tip] = drawing.arrow("friction-on-pin").expect("an arrow");
                let friction = moment(axis, [tail, tip]);
                assert!(friction < 0.0, "against the driver");
                let arm = -friction / (tip - tail).norm();
                assert!((arm - friction_arm * crank).abs() < 0.1, "{arm} for {}", friction_arm * crank);
                assert!(moment(pivot, [tail, tip]).abs() < 0.1 * (tip - tail).norm(), "along the slot");
                // The follower turns clockwise for a positive force.
                let [tail, tip] = drawing.arrow("normal-on-follower").expect("an arrow");
                let free = drawing.line("arm-r")[0];
                assert!(moment(free, [tail, tip]) * acceleration < 0.0 && normal * acceleration > 0.0);
                assert_eq!(figure.title.contains("leading"), normal > 0.0);
                assert_eq!(drawing.count("bearing-flank"), 1);
                // F r = I_f φ'' and the torque of friction is −μ |F| l |sin φ|.
                assert!((normal * radius - acceleration).abs() < 1e-12 * (1.0 + normal.abs()));
                let expected = mu * normal.abs() * friction_arm;
                assert!((friction_torque - expected).abs() < 1e-12 * (1.0 + normal.abs()));
            }
        }
        assert!(seen[0] > 0 && seen[1] > 0, "{seen:?}");
    }
}

#[test]
fn over_an_engagement_the_torque_goes_into_motion_and_friction() {
    for one in Mechanism::ALL {
        for (friction, speed) in [(0.0, 0.0), (0.125, 0.0), (0.125, 0.75)] {
            let sound = parameters(one, friction);
            let figure = normal_force(&sound, speed).expect("followed");
            let motion = columns(&figure.series, ["theta", "theta'"]);
            let ([entry, entry_speed], [exit, exit_speed]) = (motion[0], motion[motion.len() - 1]);
            assert_eq!((entry_speed, entry), (speed, -exit));
            let width = (motion[1][0] - entry).to_radians();
            let losses = columns(&figure.series, ["-tau_2/K"]);
            let lost: f64 = losses.windows(2).map(|pair| width * (pair[0][0] + pair[1][0]) / 2.0).sum();
            // As the pin enters and leaves, the follower stands still.
            let gained = 0.5 * sound.inertias().driver() * (exit_speed * exit_speed - speed * speed) / sound.torque();
            let work = 2.0 * one.engagement_half_angle();
            assert!((gained + lost - work).abs() < 1e-3 * work, "{one:?}: {gained} and {lost} for {work}");
            assert!((friction > 0.0) == (lost > 0.0));
            for [theta, force, loss, bars] in columns(&figure.series, ["theta", "F R/K", "-tau_2/K", "bars/E"]) {
                assert!(
                    (loss - bars.abs()).abs() < 1e-12 * (1.0 + loss),
                    "the friction's torque is what stands between the bars"
                );
                assert!(loss >= 0.0);
                assert!(
                    friction == 0.0 || force * theta * bars >= 0.0,
                    "the expression between the bars has the sign of F sin θ"
                );
            }
            let drawing = ParsedDrawing::parse(&figure);
            let strips = ["switch", "positive", "negative"].map(|class| drawing.count(class));
            // The curve is above zero, so its name has the minus of a torque that is below.
            assert!(drawing.texts().iter().any(|text| text.contains("−τ2")), "{:?}", drawing.texts());
            assert_eq!(strips, if friction > 0.0 { [1, 2, 3] } else { [1, 1, 1] }, "{}", figure.id);
        }
    }
}

#[test]
fn the_curves_of_the_ratios_have_their_means() {
    let figure = ratios(&Mechanism::ALL);
    let rows = &figure.series.rows;
    let steps = (rows.len() - 1) as f64;
    for (k, one) in Mechanism::ALL.iter().enumerate() {
        let column = 1 + 2 * k;
        let mean = rows.iter().map(|row| row[column]).sum::<f64>() / steps;
        let expected = f64::from(one.pins()) / f64::from(one.slots());
        assert!((mean - expected).abs() < 1e-3 * expected, "{mean} for {expected}");
        for (row, mirror) in rows.iter().zip(rows.iter().rev()) {
            assert_eq!((row[column], row[0]), (mirror[column], -mirror[0]));
            assert_eq!(row[column] * row[column], row[column + 1]);
        }
    }
}
