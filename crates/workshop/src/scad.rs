//! A model for OpenSCAD.
//!
//! The file begins with the sizes as variables and builds both parts from circles and squares, so that a size can be
//! changed there: a thinner pin, a wider slot, shafts, thickness. The crescent comes from the motion and is no formula, so
//! with other stations or a longer crank the parts would jam. The file refuses that: beside the sizes it asserts that no
//! part has more material anywhere than in the design of which it was made. Parts that run still run with less.

use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Edge, Loop, Sizes};
use nalgebra::Vector2;

use crate::mesh::Solid;

/// The model of both parts in place, moving with OpenSCAD's `$t`.
///
/// OpenSCAD's circles are polygons whose corners are on the circle; their number comes from the tolerance.
///
/// # Errors
///
/// [`KinematicsError::Length`] for a thickness or a tolerance that is not positive and finite.
pub fn scad(sizes: &Sizes, solid: Solid) -> Result<String, KinematicsError> {
    let Solid { thickness, tolerance } = solid.validate()?;
    let (disc, cut) = sizes
        .locking_disc
        .map_or((0.0, [0.0, 0.0]), |disc| (disc.radius, [disc.crescent.centre, disc.crescent.radius]));
    let variables = [
        ("stations", f64::from(sizes.wheel.stations()), May::Stay, "slots of the wheel"),
        ("pins", f64::from(sizes.wheel.pins()), May::Stay, "pins of the driver"),
        ("crank_radius", sizes.crank_radius, May::Stay, "driver's axis to a pin's centre"),
        ("pin_diameter", sizes.pin_diameter, May::Shrink, "diameter of a pin"),
        ("slot_width", sizes.slot_width, May::Grow, "pin diameter plus play"),
        ("bottom_clearance", sizes.bottom_clearance, May::Grow, "how much deeper the slots are than the pins need"),
        ("tip_radius", sizes.tip_radius, May::Shrink, "wheel's axis to the corners of the slots"),
        ("locking_arc_radius", sizes.locking_arc_radius, May::Grow, "of the hollows in the wheel"),
        ("locking_disc_radius", disc, May::Shrink, "0: there is no dwell"),
        ("crescent_centre", cut[0], May::Stay, "driver's axis to the centre of the cut"),
        ("crescent_radius", cut[1], May::Grow, "comes from the motion with all sizes above"),
        ("plate_radius", sizes.plate_radius, May::Change, "plate behind the wheel"),
        ("wheel_bore", sizes.wheel_bore(), May::Change, "diameter; 0 for none"),
        ("driver_bore", sizes.driver_bore(), May::Change, "diameter; 0 for none"),
        ("thickness", thickness, May::Change, "wheel, locking disc and plate"),
        ("axial_play", sizes.play.slot, May::Change, "between wheel and plate"),
        ("tolerance", tolerance, May::Shrink, "greatest distance of a chord from its arc"),
    ];
    let mut text = String::from("// Geneva wheel and driver; lengths in millimetres, angles in degrees.\n");
    for (name, value, _, meaning) in variables {
        text += &format!("{name} = {}; // {meaning}\n", value + 0.0);
    }
    text += "\n// The crescent was found for these numbers. With less material the parts still run; with more they may jam.\n";
    for (name, value, may, _) in variables {
        if let Some((sign, words)) = may.limit() {
            let value = value + 0.0;
            text += &format!(
                "assert({name} {sign} {value}, \"{name} must {words} {value}, or the parts may jam: make a new file\");\n"
            );
        }
    }
    Ok(text + WHOLE + &MODEL.replace("MOUTH", &mouth(sizes, tolerance)?))
}

/// One side of the mouth of a slot as the file's list of points, from the wall's end to the rim: along the slot from the wheel
/// radius, and from the wall. Empty for a sharp mouth. Corners of chords are on their arc, which leaves less material.
fn mouth(sizes: &Sizes, tolerance: f64) -> Result<String, KinematicsError> {
    let face = Loop { edges: sizes.mouth_face().into_iter().collect() };
    let ends = face.edges.iter().map(Edge::end_point);
    let point = |p: Vector2<f64>| format!("[{}, {}]", p.x - sizes.wheel_radius, p.y - sizes.slot_width / 2.0);
    Ok(face.corners(tolerance)?.into_iter().chain(ends).map(point).collect::<Vec<_>>().join(", "))
}

/// How a variable may be changed without more material anywhere.
#[derive(Clone, Copy)]
enum May {
    Stay,
    Shrink,
    Grow,
    /// It bounds nothing that moves past another part in the plane of the wheel.
    Change,
}

impl May {
    /// The sign between the variable and its number, and the words for it.
    fn limit(self) -> Option<(&'static str, &'static str)> {
        match self {
            Self::Stay => Some(("==", "be")),
            Self::Shrink => Some(("<=", "be at most")),
            Self::Grow => Some((">=", "be at least")),
            Self::Change => None,
        }
    }
}

/// What keeps each part in one piece, and the plate off the wheel and its shaft.
const WHOLE: &str = r#"
half_pitch = 180 / stations;
centre_distance = crank_radius / sin(half_pitch);
slot_end = centre_distance - crank_radius - bottom_clearance;
assert(pin_diameter > 0, "pin_diameter must be above 0");
assert(thickness > 0, "thickness must be above 0");
assert(tolerance > 0, "tolerance must be above 0");
assert(axial_play >= 0, "axial_play must be 0 or more, or the plate is in the wheel");
assert(wheel_bore >= 0, "wheel_bore must be 0 or more");
assert(driver_bore >= 0, "driver_bore must be 0 or more");
assert(slot_end > slot_width / 2 + wheel_bore / 2, "the slots meet the bore of the wheel: make wheel_bore smaller");
assert(2 * slot_end * sin(half_pitch) > slot_width, "the slots meet one another: make slot_width or bottom_clearance smaller");
assert(crank_radius > slot_width / 2 + locking_arc_radius, "no horn is left between slots and locking arcs: make them smaller");
assert(plate_radius >= crank_radius + pin_diameter / 2, "plate_radius must be crank_radius + pin_diameter / 2 or more, to carry the pins");
assert(plate_radius + wheel_bore / 2 < centre_distance, "the plate meets the wheel's shaft: make plate_radius or wheel_bore smaller");
assert(tip_radius + driver_bore / 2 < centre_distance, "the wheel meets the driver's shaft: make driver_bore smaller");
assert(crank_radius > pin_diameter / 2 + driver_bore / 2, "the driver's bore cuts the pins: make driver_bore smaller");
assert(locking_disc_radius == 0 || driver_bore == 0 || crescent_centre > crescent_radius + driver_bore / 2,
  "the crescent meets the driver's bore: make driver_bore smaller");
"#;

const MODEL: &str = r#"
part = "assembly"; // "assembly", "wheel" or "driver"

engagement = 90 - half_pitch;
wheel_radius = crank_radius / tan(half_pitch);

// One side of a slot's mouth, from its wall to the rim: along the slot from wheel_radius, and from the wall.
mouth = [MOUTH];

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
      for (side = [1, -1]) if (len(mouth) > 0) polygon(concat(
        [for (p = mouth) [wheel_radius + p[0], side * (slot_width / 2 + p[1])]],
        [[2 * tip_radius, side * (slot_width / 2 + mouth[len(mouth) - 1][1])], [2 * tip_radius, 0], [slot_end, 0]]
      ));
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
            assert_eq!(value("tip_radius"), sizes.tip_radius);
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
            "floor",
            "abs",
            "atan2",
            "sign",
            "max",
            "ceil",
            "acos",
            "module",
            "assert",
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
            "p",
            "side",
            "tan",
            "len",
            "concat",
            "polygon",
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
