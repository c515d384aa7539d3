//! Tests of masses, of the driver's own inertia, and of what its material does elsewhere: on drawings, to pins, to the speed of its rim.

use super::{WheelDesign, WheelQuestion};
use crate::{FieldValue, MechanismReport, ReportField, answer};
use approx::assert_relative_eq;
use geneva_workshop::{Mesh, meshes};
use std::f64::consts::PI;

fn report(question: &str) -> MechanismReport {
    answer(&format!("wheel {question}")).expect(question)
}

#[track_caller]
fn number(report: &MechanismReport, key: &str) -> f64 {
    report.field(key).and_then(ReportField::number).expect(key)
}

/// The middle of a mesh along x.
pub(super) fn middle_of(mesh: &Mesh) -> f64 {
    let xs = || mesh.triangles.iter().flatten().map(|p| p.x);
    f64::midpoint(xs().fold(f64::MAX, f64::min), xs().fold(f64::MIN, f64::max))
}

/// Volume in mm³ and second moment in mm⁵ of a mesh about an axis along z at this x, from its triangles.
pub(super) fn of_mesh(mesh: &Mesh, axis: f64) -> [f64; 2] {
    let (mut volume, mut moment) = (0.0, 0.0);
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|mut p| {
            p.x -= axis;
            p
        });
        // ∫ (x² + y²) dV of the tetrahedron with the origin.
        let of = |k: usize| {
            let (x, y, z) = (a[k], b[k], c[k]);
            x * x + y * y + z * z + x * y + y * z + z * x
        };
        volume += a.dot(&b.cross(&c)) / 6.0;
        moment += a.dot(&b.cross(&c)) * (of(0) + of(1)) / 60.0;
    }
    [volume, moment]
}

#[test]
fn masses_and_the_drivers_inertia_are_those_of_the_meshes() {
    let steel_driver = "--wheel-material aluminium --driver-material steel";
    for question in [
        "--stations 4 --crank-radius 25 --thickness 5",
        "--stations 6 --pins 2 --crank-radius 40 --thickness 8 --driver-shaft 10",
        "--stations 6 --crank-radius 40 --thickness 8 --driver-shaft 12 --driver-bore-shape key",
        "--stations 6 --crank-radius 40 --thickness 8 --driver-hub-circle 24 --hub-screw M3",
        "--stations 6 --type internal --crank-radius 40 --thickness 6 --plate-shaft 12 --wheel-shaft 10",
    ] {
        let asked = format!("{question} {steel_driver}");
        let design = WheelDesign::new(WheelQuestion::parse(&asked).expect(question)).expect(question);
        let list = design.part_list().expect(question).expect("a size").parts;
        let all = meshes(&list, 2e-3).expect(question);
        let (mut wheel, mut driver, mut moment) = (0.0, 0.0, 0.0);
        for (name, mesh) in &all {
            let [volume, second] = of_mesh(mesh, middle_of(mesh));
            match *name {
                "driver" => (driver, moment) = (driver + volume, moment + second),
                _ => wheel += volume,
            }
        }
        let found = report(&asked);
        assert_relative_eq!(number(&found, "wheel_mass_kg"), wheel * 2710.0 * 1e-9, max_relative = 1e-3);
        assert_relative_eq!(number(&found, "driver_mass_kg"), driver * 7800.0 * 1e-9, max_relative = 1e-3);
        assert_relative_eq!(number(&found, "driver_own_inertia_kgm2"), moment * 7800.0 * 1e-15, max_relative = 1e-3);
        // Of the wheel's material it would be a third of that.
        let plain = report(&format!("{question} --wheel-material aluminium --pin-material aluminium"));
        let share = number(&plain, "driver_mass_kg") / number(&found, "driver_mass_kg");
        assert_relative_eq!(share, 2710.0 / 7800.0, max_relative = 1e-9);
    }
}

#[test]
fn dowels_for_pins_have_a_density_of_their_own() {
    let asked = "--stations 6 --crank-radius 40 --thickness 8 --pin-diameter 8 --pin-mount dowel --pins 2";
    let (plain, heavy) = (report(asked), report(&format!("{asked} --pin-density 15600")));
    let more = number(&heavy, "driver_mass_kg") - number(&plain, "driver_mass_kg");
    let inertia = number(&heavy, "driver_own_inertia_kgm2") - number(&plain, "driver_own_inertia_kgm2");
    // Two cylinders on the crank circle, each with its own spin about its axis.
    assert_relative_eq!(inertia / more, (0.04 * 0.04) + 0.004 * 0.004 / 2.0, max_relative = 1e-9);
    let length = more / 2.0 / (7800.0 * PI * 0.004 * 0.004);
    assert!((0.016..0.018).contains(&length), "{length}");
}

#[test]
fn the_drivers_material_is_that_of_pins_in_one_piece_with_it_and_of_its_drawings() {
    let of =
        |more: &str| report(&format!("--stations 6 --crank-radius 40 --rpm 50 --inertia 0.02 --thickness 8 {more}"));
    let pressure = |more: &str| number(&of(more), "peak_contact_pressure_mpa");
    let acetal = pressure("--driver-material acetal");
    assert_relative_eq!(acetal, pressure("--driver-material acetal --pin-material acetal"), max_relative = 1e-12);
    assert!(acetal < 0.3 * pressure(""));
    // A dowel is of steel, and what is named is of that.
    assert_relative_eq!(pressure("--driver-material acetal --pin-mount dowel"), pressure(""), max_relative = 1e-12);
    assert!(pressure("--driver-material acetal --pin-material steel") > 2.0 * acetal);
    assert!(number(&of("--driver-material acetal"), "pin_factor") < 0.5 * number(&of(""), "pin_factor"));
    let asked = "--stations 6 --crank-radius 40 --thickness 8 --wheel-material phosphor-bronze --driver-material stainless-steel \
                 --pin-material hardened-steel --pin-mount dowel";
    let design = WheelDesign::new(WheelQuestion::parse(asked).expect("a question")).expect("a wheel");
    let text = design.drawings_svg().expect("drawings");
    for (material, least) in [("phosphor bronze", 2), ("stainless steel", 2), ("hardened steel", 2)] {
        assert!(text.matches(material).count() >= least, "{material}: {}", text.matches(material).count());
    }
}

#[test]
fn a_rim_bears_a_speed_by_its_own_strength_and_density() {
    let asked = "--stations 6 --crank-radius 400 --thickness 20 --wheel-material steel --driver-material acetal";
    let found = report(asked);
    let limit = |strength: f64, density: f64, reach: f64| (strength / density).sqrt() / reach * 30.0 / PI;
    // Of six stations the wheel is as fast as its driver in mid-index.
    let rim = number(&found, "tip_radius_mm") / 1e3;
    assert_relative_eq!(number(&found, "wheel_rim_limit_rpm"), limit(210e6, 7800.0, rim), max_relative = 1e-12);
    let plate = number(&found, "plate_radius_mm") / 1e3;
    assert_relative_eq!(number(&found, "driver_rim_limit_rpm"), limit(60e6, 1420.0, plate), max_relative = 1e-12);
    let own = report(&format!("{asked} --driver-strength 15 --driver-density 5680"));
    let quarter = number(&found, "driver_rim_limit_rpm") / 4.0;
    assert_relative_eq!(number(&own, "driver_rim_limit_rpm"), quarter, max_relative = 1e-12);
    let warned = |speed: f64| {
        let report = report(&format!("{asked} --driver-strength 15 --driver-density 5680 --rpm {speed}"));
        let line = report.field("warnings").and_then(|field| field.line.clone());
        line.map_or_else(String::new, |line| line.meaning.into_owned())
    };
    let said = warned(1.01 * quarter);
    assert!(said.contains("rim of the driver's plate") && said.contains("acetal bears"), "{said}");
    assert!(!warned(0.99 * quarter).contains("the rim of"));
}

#[test]
fn a_drivers_inertia_below_its_own_is_refused_with_what_it_has() {
    let asked = "wheel --stations 6 --crank-radius 40 --rpm 50 --inertia 0.02 --thickness 8";
    let own = number(&answer(asked).expect("an answer"), "driver_own_inertia_kgm2");
    let said = answer(&format!("{asked} --driver-inertia {}", 0.9 * own)).expect_err("too little").to_string();
    assert!(said.contains("--driver-inertia 0.000") && said.contains("lighter --driver-material"), "{said}");
    assert!(answer(&format!("{asked} --driver-inertia {}", 1.001 * own)).is_ok());
    assert!(answer(&format!("{asked} --driver-inertia {} --driver-density 1000", 0.9 * own)).is_ok());
}

/// R. C. Hibbeler, *Engineering Mechanics: Dynamics*, problem 16-49, as the tests of the loads in `geneva-dynamics` have it.
#[test]
fn the_sheet_has_the_speed_of_hibbelers_wheel() {
    let asked = "wheel --stations 4 --crank-radius 100 --rad-s 2 --total-inertia 0 --friction-torque 1.5 --at -30";
    let report = answer(asked).expect("an answer");
    let (_, items) = report.list.as_ref().expect("instants");
    let row = |key: &str| {
        let value = items[0].row.0.iter().find(|(name, _)| *name == key).map(|(_, value)| value);
        match value {
            Some(FieldValue::Number(number)) => *number,
            other => panic!("{key}: {other:?}"),
        }
    };
    let speed = row("wheel_speed_rad_s");
    assert_relative_eq!(speed, 0.816, max_relative = 1e-3);
    // By virtual work, and with the arm s of the book: √2 r along, r cos 30° less, r sin 30° across.
    assert_relative_eq!(row("crank_torque_nm"), 1.5 * speed / 2.0, max_relative = 1e-12);
    let arm = (2_f64.sqrt() - 30_f64.to_radians().cos()).hypot(0.5) * 0.1;
    assert_relative_eq!(row("pin_force_n"), 1.5 / arm, max_relative = 1e-12);
}
