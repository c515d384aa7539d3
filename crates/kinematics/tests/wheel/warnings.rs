//! Does the program warn of dangerous sizes, and only of these?

use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Warning, Wheel};

fn warnings(stations: u32, choices: &Choices) -> Vec<Warning> {
    let wheel = Wheel::new(stations).unwrap();
    Sizes::new(wheel, Scale::CrankRadius(25.0), choices).unwrap().warnings()
}

#[test]
fn the_programs_own_sizes_need_no_warning_and_dangerous_ones_get_theirs() {
    for stations in (3..=60).chain([100, 300, 1000]) {
        assert_eq!(warnings(stations, &Choices::default()), [], "{stations}");
    }
    let with = |pin: f64, play: f64| Choices {
        pin_diameter: Some(pin),
        play: Some(Play::from_slot(play)),
        ..Choices::default()
    };
    assert_eq!(warnings(6, &with(7.5, 0.0)), [Warning::NoPlay]);
    for (stations, pin, play) in [(6, 1.0, 0.2), (8, 1.0, 0.2), (12, 1.0, 0.2), (4, 1.0, 0.4), (6, 0.5, 0.1)] {
        let found = warnings(stations, &with(pin, play));
        assert!(matches!(found[..], [Warning::CanMiss { .. }]), "{stations} {pin} {play}: {found:?}");
    }
    assert_eq!(warnings(6, &with(7.5, 0.2)), []);
    let [Warning::LargePlay { play, pin }, Warning::LargeBacklash { at_rim, .. }] = warnings(6, &with(7.5, 0.8))[..]
    else {
        panic!("{:?}", warnings(6, &with(7.5, 0.8)))
    };
    assert_eq!((play, pin), (0.8, 7.5));
    // By the play of the wheel near the ends of its dwell.
    let sizes = Sizes::new(Wheel::new(6).unwrap(), Scale::CrankRadius(25.0), &with(7.5, 0.8)).unwrap();
    assert_eq!(at_rim, sizes.dwell_play().unwrap().greatest * sizes.tip_radius);
    let horn = Choices { horn_thickness: Some(0.4), ..Choices::default() };
    let found = warnings(6, &horn);
    assert_eq!(found, [Warning::ThinWall { wall: "the horn", thickness: 0.4 }]);
    assert!(found[0].to_string().contains("0.400 mm"));
}

#[test]
fn each_warning_begins_at_its_threshold() {
    // A fifth of the pin of 7.5 mm.
    let horn = |thickness| warnings(6, &Choices { horn_thickness: Some(thickness), ..Choices::default() });
    assert_eq!(horn(1.499), [Warning::ThinWall { wall: "the horn", thickness: 1.499 }]);
    assert_eq!(horn(1.501), []);
    let play = |play| warnings(6, &Choices { play: Some(Play::from_slot(play)), ..Choices::default() });
    assert_eq!((play(0.0), play(1e-6)), (vec![Warning::NoPlay], vec![]));
    let is_large = |of: &Warning| matches!(of, Warning::LargePlay { .. });
    assert!(!play(0.749).iter().any(is_large) && play(0.751).iter().any(is_large));
    // For a pin of 7.5 mm, the loosest H8/e8 has 25 + 22 + 22 micrometres.
    let sizes = |play| {
        let choices = Choices { play: Some(Play::from_slot(play)), ..Choices::default() };
        Sizes::new(Wheel::new(6).unwrap(), Scale::CrankRadius(25.0), &choices).unwrap()
    };
    assert_eq!(sizes(0.068_999).looser_than_fit(), None);
    assert!(sizes(0.069_001).looser_than_fit().is_some());
}
