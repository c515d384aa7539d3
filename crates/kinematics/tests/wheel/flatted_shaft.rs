//! How far does a part turn on a shaft with a flat, by trying places of the shaft in the bore?

use geneva_kinematics::wheel::FlattedShaft;
use std::f64::consts::PI;

/// Whether the shaft, turned by an angle in radians, has room in its bore with its axis anywhere within the play.
fn has_room(shaft: FlattedShaft, turn: f64) -> bool {
    let (radius, flat) = (shaft.diameter / 2.0, shaft.across - shaft.diameter / 2.0);
    let (bore, wall) = (radius + shaft.play / 2.0, flat + shaft.play / 2.0);
    let half = (flat / radius).acos();
    // The round part and both corners of the flat; between them it is straight.
    let outline: Vec<f64> = (0..=720).map(|k| half + (2.0 * PI - 2.0 * half) * f64::from(k) / 720.0 + turn).collect();
    let steps = 40;
    (0..=steps).any(|i| {
        let far = shaft.play / 2.0 * f64::from(i) / f64::from(steps);
        (0..120).any(|k| {
            let (sin, cos) = (2.0 * PI * f64::from(k) / 120.0).sin_cos();
            let (x, y) = (far * cos, far * sin);
            outline.iter().all(|angle| {
                let p = (x + radius * angle.cos(), y + radius * angle.sin());
                p.0.hypot(p.1) <= bore + 1e-9 && p.0 <= wall + 1e-9
            })
        })
    })
}

#[test]
fn a_part_turns_as_far_as_its_shaft_has_room() {
    for (diameter, across) in [(5.0, 4.5), (6.0, 5.0), (8.0, 7.5), (12.0, 9.0)] {
        for share in [0.05, 0.3, 0.7] {
            let shaft = FlattedShaft { diameter, across, play: share * (diameter - across) };
            let turn = shaft.turning_play().expect("the flat holds");
            assert!(has_room(shaft, 0.999 * turn), "{shaft:?}: {turn}");
            assert!(!has_room(shaft, 1.001 * turn + 1e-6), "{shaft:?}: {turn}");
        }
        assert_eq!(FlattedShaft { diameter, across, play: 0.0 }.turning_play(), Some(0.0));
        for play in [diameter - across, diameter, -0.1, f64::NAN] {
            assert_eq!(FlattedShaft { diameter, across, play }.turning_play(), None, "{play}");
        }
    }
    for across in [0.0, 2.5, 5.0, f64::NAN] {
        assert_eq!(FlattedShaft { diameter: 5.0, across, play: 0.01 }.turning_play(), None, "{across}");
    }
}
