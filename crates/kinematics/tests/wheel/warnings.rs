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
    let with =
        |pin: f64, play: f64| Choices { pin_diameter: Some(pin), play: Some(Play::of(play)), ..Choices::default() };
    assert_eq!(warnings(6, &with(7.5, 0.0)), [Warning::NoPlay]);
    for (stations, pin, play) in [(6, 1.0, 0.2), (8, 1.0, 0.2), (12, 1.0, 0.2), (4, 1.0, 0.4), (6, 0.5, 0.1)] {
        let found = warnings(stations, &with(pin, play));
        assert!(matches!(found[..], [Warning::CanMiss { .. }]), "{stations} {pin} {play}: {found:?}");
    }
    assert_eq!(warnings(6, &with(7.5, 0.8)), []);
    let horn = Choices { horn_thickness: Some(0.4), ..Choices::default() };
    let found = warnings(6, &horn);
    assert_eq!(found, [Warning::ThinWall { wall: "the horn", thickness: 0.4 }]);
    assert!(found[0].to_string().contains("0.400 mm"));
}
