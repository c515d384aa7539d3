//! A wheel that is made exactly as drawn has the play, the blow and the limits of the drawn one, which other code finds.

use super::super::assembly::sized;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{AsBuiltWheel, BuiltContact};
use geneva_kinematics::wheel::{Choices, Mouth, Play, Sizes};

fn wheels() -> Vec<Sizes> {
    let counts = [(3, 1), (4, 1), (6, 1), (12, 1), (24, 1), (4, 2), (5, 2), (6, 2), (8, 2), (12, 2), (4, 3), (3, 5)];
    let mut all: Vec<_> = counts.map(|(stations, pins)| sized(stations, pins, &Choices::default())).into();
    for (stations, pin, play) in [(6, 4.0, 0.8), (4, 10.0, 1.0), (8, 9.0, 0.02), (12, 2.0, 0.5)] {
        let choices = Choices { pin_diameter: Some(pin), play: Some(Play::from_slot(play)), ..Choices::default() };
        all.push(sized(stations, 1, &choices));
    }
    let mouths = [
        Mouth::Chamfer { width: 3.0, angle: 0.4 },
        Mouth::Chamfer { width: 1.0, angle: 0.9 },
        Mouth::Round { radius: 2.0 },
        Mouth::LeadIn { length: 8.0, flare: 0.8 },
    ];
    for (k, mouth) in mouths.into_iter().enumerate() {
        for (stations, pins) in [(4, 1), (6, 1), (5, 2), (8, 1)] {
            let play = Some(Play::from_slot([0.1, 0.4][k % 2]));
            all.push(sized(stations, pins, &Choices { mouth, play, ..Choices::default() }));
        }
    }
    all.push(sized(4, 4, &Choices::default()));
    all.push(sized(6, 3, &Choices::default()));
    all
}

/// The wheel made as it is drawn, its mouths included.
fn made(sizes: &Sizes) -> AsBuiltWheel {
    let mut built = AsBuiltWheel::from(sizes);
    built.mouth = sizes.mouth;
    built
}

#[test]
fn a_wheel_made_as_drawn_turns_with_the_play_and_the_blow_of_the_drawn_one() {
    for sizes in wheels() {
        let built = made(&sizes);
        let turn = built.turn().unwrap();
        let (stations, pins) = (sizes.wheel.stations(), sizes.wheel.pins());
        let name = format!("{stations} stations, {pins} pins, {:?}: {:?}", sizes.mouth, turn.jam);
        assert!(turn.jam.is_none(), "{name}");
        assert_eq!(turn.jam.is_none(), built.turns().unwrap());
        let backlash = sizes.index_backlash(0.0).unwrap();
        for station in &turn.stations {
            assert!((station.index_backlash - 2.0 * backlash).abs() < 1e-12, "{name}");
            assert!(station.station_error.abs() < 1e-12, "{name}");
            let Some(play) = sizes.dwell_play() else { continue };
            assert!((station.dwell_backlash - 2.0 * play.middle).abs() < 1e-9, "{name} {station:?} {play:?}");
            assert_eq!(station.can_miss, play.can_miss, "{name}");
            let (knock, entry) = (sizes.knock().unwrap(), station.entry.unwrap());
            assert!((entry.centred - knock.centred).abs() < 1e-9, "{name} {entry:?} {knock:?}");
            assert!((entry.greatest - knock.drifted).abs() < 0.01 * knock.drifted, "{name} {entry:?} {knock:?}");
            let late = sizes.entry(0.0).unwrap().crank_angle + sizes.wheel.engagement_half_angle();
            assert!((entry.lost_motion - late).abs() < 1e-9, "{name} {entry:?} {late}");
            assert_ne!(entry.contact, BuiltContact::PinAtMouth, "{name}");
            assert!(entry.contact == BuiltContact::PinOnWall || sizes.mouth != Mouth::Sharp, "{name}");
        }
    }
}

#[test]
fn the_play_of_each_side_in_the_dwell_is_that_of_the_drawn_wheel() {
    for sizes in wheels() {
        let Some(whole) = sizes.dwell_angle() else { continue };
        let built = made(&sizes);
        let (half_pitch, engaged) = (sizes.wheel.half_pitch_angle(), sizes.wheel.engagement_half_angle());
        let mut greatest: f64 = 0.0;
        for k in 1..2000 {
            // Dense at both ends, where the play is greatest.
            let until = whole * (1.0 - (std::f64::consts::PI * f64::from(k) / 2000.0).cos()) / 2.0;
            let [forwards, backwards] = sizes.dwell_play_at(until).unwrap();
            // The event that comes, when it is nearer than the one that went.
            let (event, theta, middle) = if until < whole / 2.0 {
                (1, -engaged - until, -half_pitch)
            } else {
                (0, engaged + whole - until, half_pitch)
            };
            let free = built.free_angles(event, theta).unwrap();
            greatest = greatest.max(free.width());
            let found = [free.forward.angle - middle, middle - free.backward.angle];
            let name = format!("{} stations, {} pins, {until}", sizes.wheel.stations(), sizes.wheel.pins());
            assert!((found[0] - forwards).abs() < 1e-9, "{name}: {found:?} {forwards} {backwards} {free:?}");
            assert!((found[1] - backwards).abs() < 1e-9, "{name}: {found:?} {forwards} {backwards} {free:?}");
        }
        let told = built.turn().unwrap().greatest_dwell_backlash();
        assert!(told >= greatest * (1.0 - 1e-9), "{told} {greatest}");
        assert!(told < greatest * 1.02, "{told} {greatest}");
    }
}

#[test]
fn the_axes_may_be_as_wrong_as_the_drawn_wheel_allows() {
    for sizes in wheels().into_iter().filter(|sizes| sizes.locking_disc.is_some()) {
        let limit = sizes.centre_tolerance();
        let built = |error: f64| {
            let mut built = made(&sizes);
            built.centre_distance += error;
            built.turn().unwrap()
        };
        // The drawn wheel's limits are for a wheel in the middle of its play; one that may give way turns with these errors too.
        for error in [-limit.nearer, limit.farther] {
            let turn = built(0.98 * error);
            assert!(turn.jam.is_none(), "{} stations: {error} {:?}", sizes.wheel.stations(), turn.jam);
        }
        let gap = sizes.locking_gap().unwrap();
        assert!(built(-1.02 * gap.min(sizes.bottom_gap())).jam.is_some());
    }
}
