//! Do sentences of the chapters hold as far as they say, and no farther?

use geneva_chapters::questions;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::quick_return::{Drive, LeverMotion, QuickReturn};
use geneva_kinematics::wheel::{Choices, ContactPair, Scale, Sizes, Wheel};

/// A number of the answer to a question.
fn number(question: &str, key: &str) -> f64 {
    questions::value(question, key).unwrap_or_else(|error| panic!("{question}: {error}"))
}

#[test]
fn the_play_is_a_thousandth_of_the_centre_distance_or_less_if_the_parts_are_small() {
    let share = |stations: u32| {
        let question = format!("wheel --stations {stations} --crank-radius 25");
        number(&question, "play_mm") / number(&question, "centre_distance_mm")
    };
    for stations in [3, 4, 6, 12] {
        assert!((share(stations) - 1e-3).abs() < 1e-9, "{stations} stations: {}", share(stations));
    }
    for stations in [23, 30, 60] {
        assert!(share(stations) < 0.95e-3, "{stations} stations: {}", share(stations));
    }
}

#[test]
fn twice_the_play_allows_nearly_twice_the_error_up_to_thirty_stations() {
    let times = |stations: u32| {
        let [once, twice] = ["0.05", "0.1"].map(|play| {
            let question = format!("wheel --stations {stations} --crank-radius 25 --play {play}");
            number(&question, "centres_farther_mm")
        });
        twice / once
    };
    for stations in [3, 4, 6, 8, 12, 20, 30] {
        assert!((1.9..2.01).contains(&times(stations)), "{stations} stations: {}", times(stations));
    }
    assert!(times(60) < 1.85, "{}", times(60));
}

#[test]
fn axes_too_close_together_bring_the_discs_rim_to_the_arc_just_after_entry() {
    let question = "wheel --stations 6 --crank-radius 25";
    let sizes =
        Sizes::new(Wheel::new(6).expect("a wheel"), Scale::CrankRadius(25.0), &Choices::default()).expect("sizes");
    // On the side of the arc, half a pitch from the slot, the pin in the middle of its slot leaves so much.
    let limit = sizes.slot_gap() * sizes.wheel.half_pitch_angle().cos();
    assert!((number(question, "centres_nearer_mm") / limit - 1.0).abs() < 0.01);
    let nearest = sizes.clearance_at(sizes.centre_distance - 1.02 * limit).expect("possible").closest_approach();
    let before_entry = sizes.wheel.engagement_half_angle() - nearest.crank_angle.abs();
    assert!(nearest.distance < 0.0 && nearest.contact == ContactPair::Crescent, "{nearest:?}");
    assert!((0.0..0.1).contains(&before_entry), "{} rad past entry", before_entry);
}

/// The tangential acceleration of the lever's point by the chapter's formula for a pin that slides inwards while the
/// lever turns with the crank, and the sliding acceleration; none elsewhere. The crank makes one radian a second.
fn by_the_formula(ground: f64, crank: f64, degrees: f64) -> Option<[f64; 2]> {
    let linkage = QuickReturn::new(ground, crank).ok()?;
    let position = linkage.position_at_crank_degrees(degrees).ok()?;
    let motion = LeverMotion::new(&ground, &crank, &position.crank, &Drive::steady(1.0))?;
    let along = motion.velocities.sliding_velocity.dot(&position.lever.direction());
    let (turning, terms) = (motion.velocities.follower_speed, &motion.accelerations);
    if along >= -1e-9 || turning <= 1e-9 {
        return None;
    }
    let (sine, cosine) = position.angle_at_pin().sin_cos();
    let normal = motion.pin_normal.norm();
    Some([normal * sine.abs() - terms.coriolis.norm(), normal * cosine - terms.follower_normal.norm()])
}

#[test]
fn the_lengths_of_the_acceleration_diagram_are_lengths_if_the_crank_is_shorter_than_the_ground() {
    let mut tried = 0;
    for crank in [0.05, 0.2, 0.3, 0.44] {
        for degrees in (-360..360).map(|half| f64::from(half) / 2.0) {
            if let Some(lengths) = by_the_formula(0.45, crank, degrees) {
                assert!(lengths.iter().all(|length| *length >= -1e-12), "{crank} m, {degrees}°: {lengths:?}");
                tried += 1;
            }
        }
    }
    assert!(tried > 500, "only {tried} positions");
    // With a longer crank, the formula can give less than nothing.
    assert!(by_the_formula(0.2, 0.45, 60.0).is_some_and(|[tangential, _]| tangential < 0.0));
}

#[test]
fn the_acceleration_jumps_by_twice_as_much_if_no_dwell_is_left() {
    let wheel = Wheel::with_pins(4, 4).expect("possible");
    assert!(wheel.dwell_fraction() < 1e-12 && Wheel::new(4).expect("possible").dwell_fraction() > 0.1);
    let end = wheel.engagement_half_angle();
    let [enters, leaves] = [-end, end].map(|crank| wheel.engaged(crank).expect("in the slot").acceleration);
    let tangent = wheel.half_pitch_angle().tan();
    assert!((enters - tangent).abs() < 1e-9 && (enters - leaves - 2.0 * tangent).abs() < 1e-9);
}
