//! Are the processes' plays large enough for their errors, and is the test piece what it says?

use geneva_kinematics::wheel::as_built::{Assemblies, ErrorShape, Process, ProcessNumbers, TestPiece};
use geneva_kinematics::wheel::{Choices, Edge, Scale, Sizes, Wheel};
use std::f64::consts::PI;

#[test]
fn with_the_play_of_its_process_nearly_every_assembly_turns() {
    for process in Process::ALL {
        for stations in [4, 6, 8] {
            let numbers = ProcessNumbers::new(process, 70.0).unwrap();
            let choices = Choices { play: Some(numbers.play()), ..Choices::default() };
            let sizes = Sizes::new(Wheel::new(stations).unwrap(), Scale::CentreDistance(70.0), &choices).unwrap();
            let tight = Assemblies::new(&sizes, numbers.errors(), ErrorShape::Normal, 5);
            let loose = tight.clone().with_bore_play(numbers.bore_play.value);
            let [tight, loose] = [tight, loose].map(|assemblies| assemblies.count(0..400).unwrap());
            assert!(
                tight.share() > 0.95 && loose.share() > 0.9,
                "{process:?}, {stations} stations: {tight:?} {loose:?}"
            );
        }
    }
}

#[test]
fn tolerances_of_metal_are_half_of_the_standards_grades() {
    // ISO 286-1, table 1: for 50 to 80 mm IT6 is 19 µm and IT8 is 46 µm; the geometric mean is 63.2 mm.
    let at = |process| 2000.0 * ProcessNumbers::new(process, (50.0_f64 * 80.0).sqrt()).unwrap().error.value;
    assert_eq!(at(Process::Ground).round(), 19.0);
    assert_eq!(at(Process::Mill).round(), 46.0);
}

#[test]
fn every_number_of_a_process_has_a_source() {
    for process in Process::ALL {
        let of = ProcessNumbers::new(process, 50.0).unwrap();
        let all = [
            of.error,
            of.slot_play,
            of.locking_play,
            of.bore_play,
            of.axial_play,
            of.corner_radius,
            of.hole_growth,
            of.kerf,
        ];
        assert!(all.iter().all(|number| !number.source.is_empty() && number.value.is_finite()));
    }
    assert!(ProcessNumbers::new(Process::Mill, 0.0).is_err());
    assert!(ProcessNumbers::new(Process::Mill, 50.0).unwrap().with_measured_play(-0.1).is_err());
}

#[test]
fn the_slots_of_the_test_piece_are_as_wide_as_told_and_apart() {
    let pin = 6.0;
    let piece = TestPiece::new(pin).unwrap();
    assert!(piece.plays.iter().zip(1..).all(|(play, k)| (play - 0.05 * f64::from(k)).abs() < 1e-12));
    let mut right_of_last = 0.0;
    for (hole, play) in piece.plate.holes.iter().zip(&piece.plays) {
        let radii: Vec<f64> = hole
            .edges
            .iter()
            .filter_map(|edge| if let Edge::Arc { radius, .. } = edge { Some(*radius) } else { None })
            .collect();
        assert!(radii.iter().all(|radius| (2.0 * radius - pin - play).abs() < 1e-12) && radii.len() == 2);
        for (one, next) in hole.edges.iter().zip(hole.edges.iter().cycle().skip(1)) {
            assert!((one.end_point() - next.start_point()).norm() < 1e-12);
        }
        let xs = || hole.edges.iter().map(|edge| edge.start_point().x);
        let (left, right) = (xs().fold(f64::INFINITY, f64::min), xs().fold(0.0, f64::max));
        assert!(left > right_of_last + 0.4 * pin);
        right_of_last = right;
    }
    let slots: f64 = piece
        .plays
        .iter()
        .map(|play| {
            let width = pin + play;
            PI * width * width / 4.0 + width * 2.0 * pin
        })
        .sum();
    let corner = piece.plate.outer.edges[1].end_point();
    assert!((piece.plate.area() - (corner.x * corner.y - slots)).abs() < 1e-9);
    assert!(piece.pins.iter().all(|face| (face.area() - PI * pin * pin / 4.0).abs() < 1e-9));
    // 05 has six strokes of a zero and five of a five, all on the plate and below the slots.
    assert!(
        piece.strokes.len() > 12 * 4
            && piece.strokes.iter().flatten().all(|p| p.y > 0.0 && p.y < 2.0 * pin && p.x < corner.x)
    );
    assert!(TestPiece::new(f64::NAN).is_err());
}
