//! Numbers of designs as another program computed them from the sizes that the sheet tells: outlines as polygons, loads by finite
//! differences of the pin's place, and meshes measured.

use super::masses_tests::{middle_of, of_mesh};
use super::{WheelDesign, WheelQuestion, looseness, ring_rows};
use crate::{MechanismReport, ReportField, answer};
use approx::assert_relative_eq;
use geneva_workshop::meshes;

fn report(question: &str) -> MechanismReport {
    answer(&format!("wheel {question}")).expect(question)
}

fn design(question: &str) -> WheelDesign {
    let asked = WheelQuestion::parse(question).expect(question);
    WheelDesign::new(asked).expect(question)
}

#[track_caller]
fn number(report: &MechanismReport, key: &str) -> f64 {
    report.field(key).and_then(ReportField::number).expect(key)
}

#[test]
fn a_pin_of_an_internal_wheel_rubs_at_its_surface() {
    let found = report(
        "--stations 4 --type internal --crank-radius 30 --thickness 5 --process fdm --wheel-shaft 6 --wheel-flat 5.5 --rpm 30 \
         --inertia 0.002 --pin-friction 0.2",
    );
    for (key, other) in [
        ("peak_pin_force_n", 0.887_890_54),
        ("braking_pin_force_n", -0.864_525),
        ("peak_crank_torque_nm", 0.005_148_725_5),
        ("braking_crank_torque_nm", -0.001_162_373_4),
        ("mean_crank_torque_nm", 0.000_449_277_19),
        ("peak_bearing_load_n", 0.905_474_24),
    ] {
        // The inertia of the wheel alone is another one by less than this, since its bore has a flat.
        assert_relative_eq!(number(&found, key), other, max_relative = 1e-4);
    }
    assert_relative_eq!(number(&found, "peak_crank_torque_at_deg"), -131.642_36, max_relative = 1e-5);
}

#[test]
fn the_web_at_the_bore_is_the_least_around_keyway_and_flat() {
    let web = |question: &str| design(question).bore_web().expect("a bore");
    for (question, other) in [
        ("--stations 5 --crank-radius 30 --process router --wheel-shaft 12 --wheel-bore-shape key", 9.083_563_7),
        ("--stations 24 --crank-radius 20 --process ground --wheel-shaft 30 --wheel-bore-shape key", 112.345_67),
        ("--stations 16 --crank-radius 30 --process mill --wheel-shaft 40 --wheel-bore-shape key", 95.296_996),
    ] {
        assert_relative_eq!(web(question), other, max_relative = 1e-7);
    }
    // A flat between two slots is nearest to none of three, and a bore without keyway or flat has the web of its circle.
    let round = "--stations 3 --crank-radius 60 --process mill --wheel-shaft 10";
    assert_relative_eq!(web(&format!("{round} --wheel-flat 8")), web(round), max_relative = 1e-12);
    let sheet = report("--stations 5 --crank-radius 30 --wheel-shaft 12 --wheel-bore-shape key");
    let keyed = web("--stations 5 --crank-radius 30 --wheel-shaft 12 --wheel-bore-shape key");
    assert_relative_eq!(number(&sheet, "bore_web_mm"), keyed, max_relative = 1e-12);
}

#[test]
fn the_wheels_own_inertia_is_that_of_its_mesh_with_all_holes() {
    for (question, pieces) in [
        (
            "--stations 4 --crank-radius 25 --process fdm --pin-screw M3 --wheel-hub-circle 20 --hub-holes 4 --hub-screw M3",
            1,
        ),
        ("--stations 5 --crank-radius 30 --process router --wheel-shaft 12 --wheel-bore-shape key", 1),
        ("--stations 6 --crank-radius 25 --wheel-shaft 24 --wheel-flat 16", 1),
        (
            "--stations 6 --crank-radius 40 --thickness 8 --wheel-hub-circle 40 --hub-screw M5 --hub-screw-hole nut-trap --hub-holes 6",
            1,
        ),
        (
            "--stations 6 --type internal --crank-radius 40 --thickness 6 --wheel-shaft 12 --wheel-bore-shape key --disc-dowel 4 \
             --disc-dowel-circle 180",
            2,
        ),
    ] {
        let design = design(question);
        let list = design.part_list().expect(question).expect("a size").parts;
        let mut moment = 0.0;
        for (_, mesh) in meshes(&list, 2e-3).expect(question).into_iter().take(pieces) {
            // Round, or of a polygon that has a corner at either end.
            let axis = if pieces == 1 { 0.0 } else { middle_of(&mesh) };
            moment += of_mesh(&mesh, axis)[1];
        }
        let own = design.wheel_inertia.expect("a size");
        assert_relative_eq!(own, moment * design.materials.wheel.density * 1e-15, max_relative = 3e-4);
        // All that turns has it.
        assert_relative_eq!(design.inertia.expect("an inertia"), own, max_relative = 1e-12);
    }
    let other = report(
        "--stations 16 --crank-radius 30 --process mill --wheel-shaft 40 --wheel-bore-shape key --wheel-hub-circle 70 --hub-screw M6 \
         --hub-screw-hole tapped --hub-holes 8",
    );
    assert_relative_eq!(number(&other, "wheel_inertia_kgm2"), 0.038_024_797, max_relative = 1e-5);
}

#[test]
fn a_wall_beside_a_flat_is_compared_with_the_bore_and_no_keyway_is_named() {
    let warned = |question: &str| {
        let line = report(question).field("warnings").and_then(|field| field.line.clone());
        line.map_or_else(String::new, |line| line.meaning.into_owned())
    };
    let of_flat = warned(
        "--stations 7 --centre-distance 100 --process mill --pin-diameter 8 --play 0.08 --locking-play 0.1 --bore-play 0.03 \
         --wheel-shaft 16 --wheel-flat 14 --driver-shaft 12 --driver-flat 10.5",
    );
    assert!(of_flat.contains("less than 5.265 mm, half of the hole's width: choose a thinner shaft"), "{of_flat}");
    assert!(!of_flat.contains("keyway"), "{of_flat}");
    let of_key = warned("--stations 5 --crank-radius 40 --driver-shaft 20 --driver-bore-shape key");
    assert!(of_key.contains("half of the keyway's width: choose a thinner shaft, or one without keyway"), "{of_key}");
    let hub = |circle: &str| {
        warned(&format!("--stations 6 --crank-radius 40 --wheel-shaft 12 --hub-screw M3 --wheel-hub-circle {circle}"))
    };
    assert!(hub("18").contains("choose a larger circle for the hub"), "{}", hub("18"));
    assert!(!hub("26").contains("circle for the hub"), "{}", hub("26"));
}

#[test]
fn the_first_row_of_the_play_on_a_flat_has_its_name() {
    let names = |question: &str| {
        let design = design(question);
        let mut rows = looseness::fields(&design, None);
        let of_ring = ring_rows::looseness(&design).expect(question);
        if !of_ring.is_empty() {
            rows = of_ring;
        }
        ["wheel_flat_play_deg", "driver_flat_play_deg"].map(|key| {
            let row = rows.iter().find(|row| row.key == key && row.number().is_some())?;
            Some(row.line.clone()?.name.to_owned())
        })
    };
    let first = Some("play on the flat".to_owned());
    let (wheel, driver) = ("--wheel-shaft 6 --wheel-flat 5", "--driver-shaft 6 --driver-flat 5");
    let external = "--stations 6 --crank-radius 40 --process fdm";
    assert_eq!(names(&format!("{external} {driver}")), [None, first.clone()]);
    assert_eq!(names(&format!("{external} {wheel} {driver}")), [first.clone(), Some(String::new())]);
    let internal = "--stations 6 --type internal --crank-radius 40 --thickness 6 --process fdm";
    let driver = "--plate-shaft 6 --driver-flat 5";
    assert_eq!(names(&format!("{internal} {driver}")), [None, first.clone()]);
    assert_eq!(names(&format!("{internal} {wheel} {driver}")), [first, Some(String::new())]);
}
