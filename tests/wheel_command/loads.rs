//! Does `geneva wheel` report the same loads as the dynamics, in the units that it states?

use super::kinds;
use crate::{assert_is_plain, number, object, on_sheet, pin, refused, stdout};
use geneva_dynamics::line_contact::{LineContact, MATERIALS};
use geneva_dynamics::wheel_loads::WheelLoads;
use std::f64::consts::PI;

#[test]
fn the_loads_are_those_of_the_dynamics() {
    for (kind, wheel) in kinds(6) {
        let found = object(&[
            "wheel",
            "--stations",
            "6",
            "--type",
            kind,
            "--rpm",
            "300",
            "--total-inertia",
            "0.002",
            "--friction-torque",
            "0.25",
            "--crank-radius",
            "40",
        ]);
        let loads = WheelLoads::new(&*wheel, 0.002, 0.25, 10.0 * PI).expect("possible");
        let [torque, moment, crank] = [loads.wheel_torque(), loads.pin_moment(), loads.crank_torque()];
        let (from, until) = loads.reversal().expect("it brakes");
        let braking = |peaks: geneva_dynamics::wheel_loads::Peaks| peaks.braking.expect("it brakes").value;
        for (key, right) in [
            ("peak_wheel_torque_nm", torque.driving.value),
            ("peak_wheel_torque_at_deg", torque.driving.angle.to_degrees()),
            ("peak_pin_force_n", moment.driving.value / 0.04),
            ("peak_pin_force_at_deg", moment.driving.angle.to_degrees()),
            ("peak_crank_torque_nm", crank.driving.value),
            ("peak_crank_torque_at_deg", crank.driving.angle.to_degrees()),
            ("peak_power_w", crank.driving.value * 10.0 * PI),
            ("rms_crank_torque_nm", loads.rms_crank_torque()),
            ("mean_crank_torque_nm", 0.25 / 6.0),
            ("braking_wheel_torque_nm", braking(torque)),
            ("braking_pin_force_n", braking(moment) / 0.04),
            ("braking_crank_torque_nm", braking(crank)),
            ("braking_from_deg", from.to_degrees()),
            ("braking_until_deg", until.to_degrees()),
            ("inertia_kgm2", 0.002),
            ("friction_torque_nm", 0.25),
        ] {
            approx::assert_relative_eq!(number(&found, key), right, max_relative = 1e-12);
        }
    }
}

#[test]
fn the_greatest_of_the_cycle_is_the_peak() {
    let wheel = ["wheel", "--stations", "5", "--rpm", "120", "--inertia", "0.01", "--crank-radius", "30"];
    let found = object(&wheel);
    let cycle = stdout(&[&wheel[..], &["--format", "csv"]].concat(), 0);
    let header: Vec<_> = cycle.lines().next().expect("a header").split(',').collect();
    for (column, key) in [
        ("wheel_torque_nm", "peak_wheel_torque_nm"),
        ("pin_force_n", "peak_pin_force_n"),
        ("crank_torque_nm", "peak_crank_torque_nm"),
        ("power_w", "peak_power_w"),
    ] {
        let at = header.iter().position(|name| *name == column).expect(column);
        let values = cycle.lines().skip(1).filter_map(|line| line.split(',').nth(at)?.parse::<f64>().ok());
        let most = values.fold(f64::NEG_INFINITY, f64::max);
        let peak = number(&found, key);
        assert!(most <= peak * (1.0 + 1e-12) && most > 0.995 * peak, "{column}: {most} of {peak}");
    }
}

#[test]
fn a_plate_has_the_inertia_of_its_drawing() {
    let plate = ["wheel", "--stations", "6", "--crank-radius", "50", "--thickness", "8", "--density", "7850"];
    let found = object(&plate);
    let inertia = number(&found, "inertia_kgm2");
    // A solid disc of the same rim has more; one of the radius to the slots' ends and half of the rest has less.
    let rim = number(&found, "tip_radius_mm") / 1000.0;
    let disc = 0.5 * PI * rim.powi(4) * 0.008 * 7850.0;
    assert!(inertia < disc && inertia > 0.2 * disc, "{inertia} of {disc}");
    let twice = object(&[&plate[..6], &["16", "--density", "7850"]].concat());
    approx::assert_relative_eq!(number(&twice, "inertia_kgm2"), 2.0 * inertia, max_relative = 1e-14);
    let loaded = object(&[&plate[..], &["--rpm", "300"]].concat());
    let by_hand = object(&[
        "wheel",
        "--stations",
        "6",
        "--crank-radius",
        "50",
        "--rpm",
        "300",
        "--total-inertia",
        &inertia.to_string(),
    ]);
    approx::assert_relative_eq!(
        number(&loaded, "peak_crank_torque_nm"),
        number(&by_hand, "peak_crank_torque_nm"),
        max_relative = 1e-12
    );
}

#[test]
fn the_wheels_own_inertia_is_added_to_that_of_the_table() {
    let plate = ["wheel", "--stations", "6", "--crank-radius", "50", "--thickness", "8", "--density", "7850"];
    let own = number(&object(&plate), "inertia_kgm2");
    let both = object(&[&plate[..], &["--inertia", "0.003", "--rpm", "60"]].concat());
    approx::assert_relative_eq!(number(&both, "inertia_kgm2"), own + 0.003, max_relative = 1e-14);
    assert_eq!(number(&both, "wheel_inertia_kgm2"), own);
    let wheel = geneva_kinematics::wheel::Wheel::new(6).expect("possible");
    let loads = WheelLoads::new(&wheel, own + 0.003, 0.0, 2.0 * PI).expect("possible");
    approx::assert_relative_eq!(
        number(&both, "peak_pin_force_n"),
        loads.pin_moment().driving.value / 0.05,
        max_relative = 1e-12
    );
}

#[test]
fn an_inertia_that_is_less_than_the_wheels_own_is_refused() {
    let plate = ["wheel", "--stations", "6", "--crank-radius", "40", "--thickness", "12", "--rpm", "60"];
    let own = number(&object(&plate), "wheel_inertia_kgm2");
    let with = |inertia: f64| refused(&[&plate[..], &["--total-inertia", &inertia.to_string()]].concat());
    let why = with(0.001);
    for words in ["--total-inertia 0.001", "the wheel alone has 0.0020", "with --inertia"] {
        assert!(why.contains(words), "{why}");
    }
    assert!(with(own * 0.999_999).contains("--total-inertia"));
    let found = object(&[&plate[..], &["--total-inertia", &own.to_string()]].concat());
    assert_eq!(number(&found, "inertia_kgm2"), own);
}

/// A disc of 2 kg and 300 mm has half its mass times the square of its radius.
#[test]
fn a_round_table_is_as_good_as_its_inertia() {
    let wheel = ["wheel", "--stations", "6", "--index-time", "0.4", "--crank-radius", "40"];
    let table = object(&[&wheel[..], &["--table-mass", "2", "--table-diameter", "300"]].concat());
    let inertia = object(&[&wheel[..], &["--inertia", "0.0225"]].concat());
    for key in ["table_inertia_kgm2", "inertia_kgm2", "peak_pin_force_n", "peak_crank_torque_nm"] {
        approx::assert_relative_eq!(number(&table, key), number(&inertia, key), max_relative = 1e-15);
    }
    approx::assert_relative_eq!(number(&table, "rpm"), 50.0, max_relative = 1e-14);
}

#[test]
fn the_pressure_is_that_of_the_line_contact() {
    let wheel = ["wheel", "--stations", "6", "--rpm", "300", "--total-inertia", "0.02", "--crank-radius", "50"];
    let pressed = |thickness: &str, wall: &str| {
        let with =
            ["--pin-diameter", "8", "--thickness", thickness, "--pin-material", "steel", "--wheel-material", wall];
        let found = object(&[&wheel[..], &with].concat());
        (number(&found, "peak_pin_force_n"), number(&found, "peak_contact_pressure_mpa"))
    };
    for wall in &MATERIALS {
        let (force, pressure) = pressed("6", wall.name);
        let contact = LineContact::new(0.004, 0.006, &MATERIALS[0], wall).expect("possible");
        assert_eq!(pressure, contact.pressure(force).expect("pressed") / 1e6, "{}", wall.name);
    }
    let ((_, thick), (_, thin)) = (pressed("8", "acetal"), pressed("2", "acetal"));
    approx::assert_relative_eq!(thin, 2.0 * thick, max_relative = 1e-14);
}

#[test]
fn the_sheet_says_what_the_object_says() {
    let wheel = [
        "wheel",
        "--stations",
        "6",
        "--rpm",
        "360",
        "--crank-radius",
        "50",
        "--inertia",
        "0.002",
        "--friction-torque",
        "0.3",
    ];
    let (sheet, found) = (stdout(&wheel, 0), object(&wheel));
    assert_is_plain(&sheet);
    for (name, key) in [
        ("peak wheel torque", "peak_wheel_torque_nm"),
        ("peak pin force", "peak_pin_force_n"),
        ("peak crank torque", "peak_crank_torque_nm"),
        ("peak power", "peak_power_w"),
        ("RMS crank torque", "rms_crank_torque_nm"),
        ("mean crank torque", "mean_crank_torque_nm"),
        ("braking pin force", "braking_pin_force_n"),
    ] {
        let line = sheet.lines().find_map(|line| line.strip_prefix("  ")?.strip_prefix(name)).expect(name);
        assert!((on_sheet(line) / number(&found, key) - 1.0).abs() < 6e-4, "{key}: {line}");
    }
    assert!(sheet.contains("leave out the friction of the pin"), "{sheet}");
    pin("wheel-of-six-with-loads", &wheel);
    let heavy_friction = [&wheel[..10], &["30"]].concat();
    assert!(stdout(&heavy_friction, 0).contains("friction alone slows the wheel down"));
    assert!(object(&heavy_friction)["braking_from_deg"].is_null());
}
