//! Do driver and wheel keep clear of each other with all sizes at their limits together?

use super::assembly::{marched_to_drifted, sized};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::AsBuiltWheel;
use geneva_kinematics::wheel::{Choices, Crescent, EntryContact, LockingDisc, Play, Scale, Sizes, Wheel};

/// The sizes with all errors together: disc too large, arc too small, pin too thick, slot too narrow, the slot's end too far
/// out, and the crank too long or too short, each by this part of its limit (the slot's end by all of it). The cut in the disc is
/// where it was.
fn wrong(sizes: &Sizes, part: f64, crank_sense: f64) -> Sizes {
    let limit = sizes.shared_tolerance().expect("a disc, and bores that leave something");
    let disc = sizes.locking_disc.expect("a disc");
    let (radius, cut) = (disc.radius + part * limit.locking, disc.crescent);
    let cosine = (cut.centre * cut.centre + radius * radius - cut.radius * cut.radius) / (2.0 * cut.centre * radius);
    let mut wrong = *sizes;
    wrong.locking_disc = Some(LockingDisc { radius, crescent: Crescent { half_angle: cosine.acos(), ..cut } });
    wrong.locking_arc_radius -= part * limit.locking;
    wrong.crank_radius += crank_sense * part * limit.crank;
    wrong.pin_diameter += part * limit.width;
    wrong.slot_width -= part * limit.width;
    wrong.play.slot -= 2.0 * part * limit.width;
    wrong.slot_end += limit.slot_end;
    wrong.tip_radius = sizes.wheel_radius.hypot(wrong.slot_width / 2.0);
    wrong
}

/// Errors of the centre distance with the shafts as loose as their bores allow, in millimetres.
fn centre_errors(sizes: &Sizes, part: f64) -> [f64; 2] {
    let limit = sizes.shared_tolerance().expect("a disc");
    [-sizes.play.bore - part * limit.nearer, sizes.play.bore + part * limit.farther]
}

/// The least clearance over a whole turn with all errors at this part of their limits, in millimetres, the worst of the senses.
fn clear(sizes: &Sizes, part: f64) -> f64 {
    let mut least = f64::INFINITY;
    for error in centre_errors(sizes, part) {
        for sense in [-1.0, 1.0] {
            let all = wrong(sizes, part, sense).clearance_at(sizes.centre_distance + error).expect("possible");
            least = least.min(all.closest_approach().distance - all.tolerance);
        }
    }
    least
}

/// Whether the pin comes in between the walls of a slot that is turned between its arcs, whatever the senses of the errors.
fn comes_in(sizes: &Sizes, part: f64) -> bool {
    let limit = sizes.shared_tolerance().expect("a disc");
    centre_errors(sizes, part).into_iter().all(|error| {
        [-1.0, 1.0].into_iter().all(|crank| {
            [-1.0, 1.0].into_iter().all(|turned| {
                let sizes = wrong(sizes, part, crank);
                let (theta, _) = marched_to_drifted(&sizes, error, turned * part * limit.direction).expect("met");
                let axis = sizes.centre_distance + error;
                let (x, y) = (axis - sizes.crank_radius * theta.cos(), sizes.crank_radius * theta.sin());
                // It meets a wall within the slot, and not a corner on its way in.
                x.hypot(y) < sizes.wheel_radius
            })
        })
    })
}

#[test]
fn nothing_touches_with_all_errors_at_their_limits_together() {
    for stations in [3, 4, 5, 6, 7, 8, 10, 12, 16, 24] {
        for (radius, play) in [(25.0, None), (80.0, None), (80.0, Some(0.08)), (10.0, Some(0.04))] {
            let choices = Choices { play: play.map(Play::from_slot), ..Choices::default() };
            let sizes = Sizes::new(Wheel::new(stations).unwrap(), Scale::CrankRadius(radius), &choices).unwrap();
            let limit = sizes.shared_tolerance().unwrap();
            assert!(clear(&sizes, 1.0) > 0.0, "{stations}, {radius} mm, {play:?}: {} {limit:?}", clear(&sizes, 1.0));
        }
        let sizes = sized(stations, 1, &Choices::default());
        assert!(comes_in(&sizes, 1.0), "{stations}: {:?}", sizes.shared_tolerance());
    }
}

#[test]
fn with_half_as_much_again_or_a_third_of_the_gap_for_each_something_touches() {
    for stations in [3, 4, 6, 8, 12] {
        let sizes = sized(stations, 1, &Choices::default());
        assert!(clear(&sizes, 1.5) < 0.0, "{stations}: {}", clear(&sizes, 1.5));
        assert!(!comes_in(&sizes, 7.0), "{stations}");
        // A third of the disc's gap for each of three sizes leaves nothing for loose shafts.
        let gap = sizes.locking_gap().unwrap();
        let disc = sizes.locking_disc.unwrap();
        let mut thirds = sizes;
        thirds.locking_arc_radius -= gap / 3.0;
        thirds.locking_disc = Some(LockingDisc { radius: disc.radius + gap / 3.0, ..disc });
        let at = sizes.centre_distance - gap / 3.0 - sizes.play.bore;
        assert!(thirds.clearance_at(at).unwrap().closest_approach().distance < 0.0, "{stations}");
    }
}

#[test]
fn a_crank_that_is_shorter_by_the_gap_brings_the_pin_to_the_slots_corner() {
    for stations in [3, 4, 6, 8, 12] {
        let sizes = sized(stations, 1, &Choices::default());
        for (part, is_clear) in [(0.98, true), (1.02, false)] {
            let mut short = sizes;
            short.crank_radius -= part * sizes.slot_gap();
            let pin = short.clearance_at(sizes.centre_distance).unwrap().pin_outside.unwrap();
            assert_eq!(pin.distance > 0.0, is_clear, "{stations}, {part}: {pin:?}");
        }
    }
}

#[test]
fn axes_too_far_apart_meet_the_corner_a_little_before_the_gap_over_the_sine() {
    for stations in [3, 4, 6, 8, 12] {
        let sizes = sized(stations, 1, &Choices::default());
        let (sine, cosine) = sizes.wheel.half_pitch_angle().sin_cos();
        let (a, gap) = (sizes.crank_radius, sizes.slot_gap());
        // e sin α + (e cos α)² / (2 a) = g.
        let square = cosine * cosine / (2.0 * a);
        let limit = 2.0 * gap / (sine + (sine * sine + 4.0 * square * gap).sqrt());
        let meets = |part: f64| sizes.entry(part * limit).expect("met").contact;
        assert_eq!([meets(0.9999), meets(1.0001)], [EntryContact::DrivingWall, EntryContact::Mouth], "{stations}");
        let farther = sizes.centre_tolerance().farther;
        assert!(farther < 1.0001 * limit && farther > 0.985 * limit, "{stations}: {farther}, {limit}");
        assert!(limit < gap / sine);
    }
}

#[test]
fn a_pin_off_its_place_leaves_less_to_all_sizes_and_the_wheel_turns_then_too() {
    for stations in [4, 6, 8, 12] {
        let pin = 0.02;
        let choices =
            Choices { play: Some(Play { pin, ..Play::from_slot(0.2) }), pin_diameter: Some(6.0), ..Choices::default() };
        let sizes = Sizes::new(Wheel::new(stations).unwrap(), Scale::CrankRadius(50.0), &choices).unwrap();
        let exact = Choices { play: Some(Play::from_slot(0.2)), ..choices };
        let exact = Sizes::new(Wheel::new(stations).unwrap(), Scale::CrankRadius(50.0), &exact).unwrap();
        let [limit, other] = [sizes, exact].map(|sizes| sizes.shared_tolerance().expect("room"));
        assert!(limit.crank < other.crank - 0.1 * pin, "{stations}: {limit:?}");
        let turns = |shift: f64, direction: i32, error: f64, sense: f64| {
            let mut built = AsBuiltWheel::from(&sizes);
            let (sine, cosine) = (std::f64::consts::PI * f64::from(direction) / 6.0).sin_cos();
            built.centre_distance += error;
            built.disc_radius = built.disc_radius.map(|disc| disc + limit.locking);
            built.arcs_mut().iter_mut().for_each(|arc| arc.radius -= limit.locking);
            for slot in built.slots_mut() {
                slot.width -= limit.width;
                slot.end += limit.slot_end;
            }
            for made in built.pins_mut() {
                let along = made.crank_radius + sense * limit.crank + shift * cosine;
                made.crank_radius = along.hypot(shift * sine);
                made.direction_error = (shift * sine).atan2(along);
                made.diameter += limit.width;
            }
            built.turns().unwrap()
        };
        for error in [-sizes.play.bore - limit.nearer, sizes.play.bore + limit.farther] {
            for sense in [-1.0, 1.0] {
                assert!((0..12).all(|direction| turns(pin, direction, error, sense)), "{stations}: {error} {sense}");
                assert!(!(0..12).all(|direction| turns(0.4, direction, error, sense)), "{stations}: {error} {sense}");
            }
        }
    }
}
