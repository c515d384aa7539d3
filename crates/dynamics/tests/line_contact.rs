//! Does the pressure carry the force, and do the surfaces fit?

use approx::assert_relative_eq;
use geneva_dynamics::line_contact::pressure_at_yield;
use geneva_dynamics::line_contact::{LineContact, MATERIALS, Material, contact_modulus};
use std::f64::consts::PI;

const STEEL: Material = MATERIALS[0];

#[test]
fn the_pressure_over_the_contact_carries_the_force() {
    for wall in &MATERIALS {
        let (length, force) = (8e-3, 250.0);
        let contact = LineContact::new(4e-3, length, &STEEL, wall).expect("possible");
        let (peak, width) = (contact.pressure(force).expect("pressed"), contact.width(force).expect("pressed"));
        // The pressure is half an ellipse over the width: π/4 of peak times width.
        assert_relative_eq!(PI / 4.0 * peak * width * length, force, max_relative = 1e-14);
        assert!(width < 0.4 * 4e-3, "{}: {width}", wall.name);
    }
}

/// The surface takes the shape of the pin: within the contact its curvature is 1/R. The half ellipse of pressure bends
/// a half plane to the curvature 2 p / (E* a), with a half the width (K. L. Johnson, *Contact Mechanics*, section 4.2).
#[test]
fn the_surfaces_fit() {
    let contact = LineContact::new(3e-3, 5e-3, &STEEL, &MATERIALS[4]).expect("possible");
    let (peak, width) = (contact.pressure(90.0).expect("pressed"), contact.width(90.0).expect("pressed"));
    let curvature = 2.0 * peak / (contact_modulus(&STEEL, &MATERIALS[4]) * (width / 2.0));
    assert_relative_eq!(curvature, 1.0 / 3e-3, max_relative = 1e-14);
}

#[test]
fn a_softer_wall_is_pressed_less_and_a_thinner_pin_presses_more() {
    let pressure = |radius: f64, wall: &Material| {
        LineContact::new(radius, 5e-3, &STEEL, wall).expect("possible").pressure(100.0).expect("pressed")
    };
    assert!(pressure(3e-3, &MATERIALS[4]) < 0.2 * pressure(3e-3, &STEEL));
    assert_relative_eq!(pressure(1e-3, &STEEL), 2.0 * pressure(4e-3, &STEEL), max_relative = 1e-14);
    // A rigid body leaves the other's compliance alone.
    let rigid = Material { name: "rigid", modulus: f64::INFINITY, poisson: 0.0, density: 1.0, strength: 1.0 };
    assert_relative_eq!(2.0 * contact_modulus(&STEEL, &STEEL), contact_modulus(&STEEL, &rigid), max_relative = 1e-14);
}

/// K. L. Johnson, *Contact Mechanics*, section 6.1: by Tresca's criterion 1.67 times the yield stress, by that of von Mises
/// 1.79 times. The greatest shear stress is 0.30 times the pressure.
#[test]
fn yielding_begins_where_the_book_has_it() {
    assert_relative_eq!(pressure_at_yield(0.3), 1.79, max_relative = 3e-3);
    // Another way to the same stresses: every line load of the half ellipse bends the half plane by Flamant's solution.
    let depth = 0.7;
    let parts = 20_000;
    let mut stress = [0.0_f64; 2];
    for part in 0..parts {
        let x = (f64::from(part) + 0.5) / f64::from(parts) * 2.0 - 1.0;
        let load = (1.0 - x * x).sqrt() * 2.0 / f64::from(parts);
        let square = (x * x + depth * depth) * (x * x + depth * depth);
        stress[0] -= 2.0 / PI * load * depth * depth * depth / square;
        stress[1] -= 2.0 / PI * load * depth * x * x / square;
    }
    let root = (1.0 + depth * depth).sqrt();
    assert_relative_eq!(stress[0], -1.0 / root, max_relative = 1e-5);
    assert_relative_eq!(stress[1], 2.0 * depth - (1.0 + 2.0 * depth * depth) / root, max_relative = 1e-4);
}

#[test]
fn what_is_no_contact_is_refused() {
    assert!(LineContact::new(0.0, 1.0, &STEEL, &STEEL).is_err());
    assert!(LineContact::new(1.0, f64::NAN, &STEEL, &STEEL).is_err());
    let none = Material { name: "none", modulus: 0.0, poisson: 0.0, density: 1.0, strength: 1.0 };
    assert!(LineContact::new(1.0, 1.0, &STEEL, &none).is_err());
    let contact = LineContact::new(1.0, 1.0, &STEEL, &STEEL).expect("possible");
    assert!(contact.pressure(-1.0).is_err() && contact.width(f64::NAN).is_err());
    assert_eq!(contact.pressure(0.0), Ok(0.0));
}
