//! A model for OpenSCAD.
//!
//! The file begins with the sizes as variables and builds both parts from circles and squares, so that a size can be
//! changed there: pin, slot, shafts, thickness. What follows from the numbers of stations and pins and from the crank
//! radius is written as formulas; the crescent is not, because it comes from the motion.

use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Sizes;

use crate::mesh::Solid;

/// The model of both parts in place, moving with OpenSCAD's `$t`.
///
/// OpenSCAD's circles are polygons whose corners are on the circle; their number comes from the tolerance.
///
/// # Errors
///
/// [`KinematicsError::Length`] for a thickness or a tolerance that is not positive and finite.
pub fn scad(sizes: &Sizes, solid: Solid) -> Result<String, KinematicsError> {
    let Solid { thickness, tolerance } = solid.checked()?;
    let (disc, cut) = sizes
        .locking_disc
        .map_or((0.0, [0.0, 0.0]), |disc| (disc.radius, [disc.crescent.centre, disc.crescent.radius]));
    let variables = [
        ("stations", f64::from(sizes.wheel.stations()), "slots of the wheel"),
        ("pins", f64::from(sizes.wheel.pins()), "pins of the driver"),
        ("crank_radius", sizes.crank_radius, "driver's axis to a pin's centre"),
        ("pin_diameter", sizes.pin_diameter, "diameter of a pin"),
        ("slot_width", sizes.slot_width, "pin diameter plus play"),
        ("bottom_clearance", sizes.bottom_clearance, "how much deeper the slots are than the pins need"),
        ("locking_arc_radius", sizes.locking_arc_radius, "of the hollows in the wheel"),
        ("locking_disc_radius", disc, "0: there is no dwell"),
        ("crescent_centre", cut[0], "driver's axis to the centre of the cut"),
        ("crescent_radius", cut[1], "follows from the motion, so it depends on all sizes above"),
        ("plate_radius", sizes.plate_radius, "plate behind the wheel"),
        ("wheel_bore", sizes.wheel_bore(), "diameter; 0 for none"),
        ("driver_bore", sizes.driver_bore(), "diameter; 0 for none"),
        ("thickness", thickness, "wheel, locking disc and plate"),
        ("axial_play", sizes.play.slot, "between wheel and plate"),
        ("tolerance", tolerance, "greatest distance of a chord from its arc"),
    ];
    let mut text = String::from("// Geneva wheel and driver; lengths in millimetres, angles in degrees.\n");
    for (name, value, meaning) in variables {
        text += &format!("{name} = {}; // {meaning}\n", value + 0.0);
    }
    Ok(text + MODEL)
}

const MODEL: &str = r#"
part = "assembly"; // "assembly", "wheel" or "driver"

half_pitch = 180 / stations;
centre_distance = crank_radius / sin(half_pitch);
wheel_radius = crank_radius / tan(half_pitch);
tip_radius = sqrt(pow(wheel_radius, 2) + pow(slot_width / 2, 2));
slot_end = centre_distance - crank_radius - bottom_clearance;
engagement = 90 - half_pitch;

// Crank angle from the line of centres, and the wheel's angle with it.
theta = 360 / pins * ($t - floor($t + 0.5));
phi = abs(theta) < engagement
  ? atan2(crank_radius * sin(theta), centre_distance - crank_radius * cos(theta))
  : sign(theta) * half_pitch;

// A circle with as many corners as the tolerance asks for.
module round(r) {
  circle(r = r, $fn = r > tolerance ? max(12, ceil(180 / acos(1 - tolerance / r))) : 12);
}

module wheel() {
  linear_extrude(height = thickness) difference() {
    round(tip_radius);
    for (k = [0 : stations - 1]) rotate(2 * half_pitch * k) {
      translate([slot_end, 0]) round(slot_width / 2);
      translate([slot_end, -slot_width / 2]) square([tip_radius, slot_width]);
      rotate(half_pitch) translate([centre_distance, 0]) round(locking_arc_radius);
    }
    if (wheel_bore > 0) round(wheel_bore / 2);
  }
}

module driver() {
  height = thickness + axial_play;
  difference() {
    union() {
      translate([0, 0, -height]) linear_extrude(height = thickness) round(plate_radius);
      translate([0, 0, -height]) linear_extrude(height = height + thickness) {
        if (locking_disc_radius > 0) difference() {
          round(locking_disc_radius);
          for (k = [0 : pins - 1]) rotate(360 / pins * k) translate([crescent_centre, 0]) round(crescent_radius);
        }
        for (k = [0 : pins - 1]) rotate(360 / pins * k) translate([crank_radius, 0]) round(pin_diameter / 2);
      }
    }
    if (driver_bore > 0)
      translate([0, 0, -2 * height]) linear_extrude(height = 4 * height) round(driver_bore / 2);
  }
}

if (part == "wheel") wheel();
else if (part == "driver") driver();
else {
  color("steelblue") rotate(phi) wheel();
  color("goldenrod") translate([centre_distance, 0, 0]) rotate(180 - theta) driver();
}
"#;

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_kinematics::wheel::{Choices, Scale, Wheel};

    fn model(stations: u32, pins: u32) -> (Sizes, String) {
        let wheel = Wheel::with_pins(stations, pins).unwrap();
        let sizes = Sizes::new(wheel, Scale::CrankRadius(50.0), &Choices::default()).unwrap();
        (sizes, scad(&sizes, Solid { thickness: 6.0, tolerance: 0.02 }).unwrap())
    }

    #[test]
    fn the_variables_are_the_sizes() {
        for (stations, pins) in [(3, 1), (4, 4), (6, 2), (60, 1)] {
            let (sizes, text) = model(stations, pins);
            let value = |name: &str| -> f64 {
                let line = text.lines().find_map(|line| line.strip_prefix(&format!("{name} = "))).unwrap();
                line.split_once(';').unwrap().0.parse().unwrap()
            };
            assert_eq!(value("stations"), f64::from(stations));
            assert_eq!(value("crank_radius"), sizes.crank_radius);
            assert_eq!(value("slot_width"), sizes.slot_width);
            assert_eq!(value("bottom_clearance"), sizes.bottom_clearance);
            assert_eq!(value("locking_disc_radius") > 0.0, sizes.locking_disc.is_some());
            if let Some(disc) = sizes.locking_disc {
                assert_eq!(value("crescent_centre"), disc.crescent.centre);
                assert_eq!(value("crescent_radius"), disc.crescent.radius);
            }
        }
    }

    #[test]
    fn every_name_is_defined_and_every_bracket_closed() {
        let (_, text) = model(6, 1);
        let code: String =
            text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n");
        let mut open = Vec::new();
        for sign in code.chars() {
            match sign {
                '(' | '[' | '{' => open.push(sign),
                ')' => assert_eq!(open.pop(), Some('(')),
                ']' => assert_eq!(open.pop(), Some('[')),
                '}' => assert_eq!(open.pop(), Some('{')),
                _ => {}
            }
        }
        assert!(open.is_empty());
        let known = [
            "sin",
            "cos",
            "tan",
            "sqrt",
            "pow",
            "floor",
            "abs",
            "atan2",
            "sign",
            "max",
            "ceil",
            "acos",
            "module",
            "circle",
            "linear_extrude",
            "height",
            "difference",
            "for",
            "rotate",
            "translate",
            "square",
            "if",
            "else",
            "union",
            "color",
            "r",
            "k",
            "$t",
            "$fn",
        ];
        let is_part = |sign: char| sign.is_alphanumeric() || sign == '_' || sign == '$';
        let without_text: String = code.split('"').step_by(2).collect::<Vec<_>>().join(" ");
        for name in without_text
            .split(|sign| !is_part(sign))
            .filter(|word| word.starts_with(|c: char| c.is_alphabetic() || c == '$'))
        {
            let is_defined =
                without_text.contains(&format!("{name} =")) || without_text.contains(&format!("module {name}("));
            assert!(known.contains(&name) || is_defined, "{name}");
        }
    }
}
