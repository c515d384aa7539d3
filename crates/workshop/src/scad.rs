//! Models for OpenSCAD, of external and internal wheels.
//!
//! The file begins with the choices as variables and works all else out from them as [`Sizes`] does, the crescent too: stations,
//! crank, pin and plays can be changed there. Sizes that don't fit are refused by an assertion that says what to change. Holes
//! for mounting are lists of numbers; the file asserts that each is still within its part.

use crate::geometry::Point;
use crate::parts::{
    Fastener, Hole, HolePurpose, Layer, Mounting, MountingError, Part, PinMount, ScrewHole, ShaftFit, axial_play,
    internal_parts, parts,
};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::wheel::{Edge, Loop, Sizes};
use std::f64::consts::PI;
use std::fmt::Write;

/// The model of both parts in place, moving with OpenSCAD's `$t`; lengths in millimetres.
///
/// OpenSCAD's circles are polygons: solid ones have their corners on the circle and hollow ones their sides, so that chords
/// take nothing of the play. Their number comes from the tolerance, the greatest distance of a chord from its arc. Holes are drawn wider
/// by the allowance, in millimetres, as by [`Part::with_wider_holes`]; the file has it as the variable `hole_allowance`.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Mounting, scad};
///
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
/// let text = scad(&sizes, 5.0, 0.01, &Mounting::default(), 0.0).expect("a model");
/// assert!(text.contains("crank_radius = 50;"));
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// As for [`parts()`], and [`MountingError::Kinematics`] for a tolerance that is not positive and finite.
pub fn scad(
    sizes: &Sizes,
    thickness: f64,
    tolerance: f64,
    mounting: &Mounting,
    hole_allowance: f64,
) -> Result<String, MountingError> {
    let list = parts(sizes, thickness, mounting)?.parts;
    validate(&list, tolerance)?;
    let of = |layer: Layer| list.iter().find(|part| part.layer == layer);
    let (wheel, plate, base) = (of(Layer::Wheel), of(Layer::Plate), of(Layer::BasePlate));
    let pin = PinHole::new(&list, sizes.pin_diameter, mounting, !mounting.disc_is_apart());
    let shoulder = mounting.base.and_then(|base| base.shoulder).unwrap_or([0.0, 0.0]);
    let base_screw = mounting.base.and_then(|base| base.screws);
    let mut text = String::from(
        "// Geneva wheel and driver; lengths in millimetres, angles in degrees. All else follows from these numbers.\n",
    );
    let sections: [(&str, &[Variable]); 4] = [
        (
            "Wheel and driver",
            &[
                ("stations", f64::from(sizes.wheel.stations()), "slots of the wheel, from 3 on"),
                ("pins", f64::from(sizes.wheel.pins()), "pins of the driver"),
                ("crank_radius", sizes.crank_radius, "driver's axis to a pin's centre"),
                ("pin_diameter", sizes.pin_diameter, "of a pin, or of the bush on its screw"),
                ("horn_thickness", sizes.horn_thickness, "least thickness between a slot and a locking arc"),
                ("bottom_clearance", sizes.bottom_clearance, "how much deeper the slots are than the pins need"),
                ("thickness", thickness, "of wheel, locking disc and plate"),
            ],
        ),
        (
            "Play",
            &[
                ("slot_play", sizes.play.slot, "width of a slot less the pin's diameter"),
                ("locking_play", sizes.play.locking, "diameter of the locking arcs less that of the disc"),
                ("axial_play", axial_play(sizes.play.slot, mounting), "between wheel and plate"),
                ("tolerance", tolerance, "greatest distance of a chord from its arc"),
            ],
        ),
        (
            "Shafts and pins",
            &[
                ("wheel_bore", sizes.wheel_bore(), "diameter; 0 for none"),
                ("driver_bore", sizes.driver_bore(), "diameter in the locking disc; 0 for none"),
                ("plate_bore", sizes.plate_bore(), "diameter in the plate; 0 for none"),
                allowance(hole_allowance),
                pin.of_plate(),
                pin.of_bush(),
                pin.nut_width(),
                pin.nut_depth(),
            ],
        ),
        (
            "Base plate",
            &[
                ("base_thickness", base.map_or(0.0, |base| base.thickness), "0 for none"),
                ("base_hole", base_screw.map_or(0.0, |screw| screw.clearance_hole()), "for screws; 0 for none"),
                ("base_margin", base.map_or(0.0, margin), "from its screws to its edge"),
                ("shoulder_diameter", shoulder[0], "wider hole from above at each axis; 0 for none"),
                ("shoulder_depth", shoulder[1], "of that hole"),
            ],
        ),
    ];
    write_variables(&mut text, &sections);
    let between = 180.0 / f64::from(sizes.wheel.pins());
    let holes = [("wheel_holes", wheel), ("plate_holes", plate), ("disc_holes", of(Layer::LockingDisc))];
    let half_pitch = sizes.wheel.half_pitch_angle() * 180.0 / PI;
    let bores = [("wheel", wheel, mounting.wheel_fit, half_pitch), ("driver", plate, mounting.driver_fit, between)];
    write_holes(&mut text, &holes, &bores);
    let _ = writeln!(
        text,
        "// One side of a slot's mouth, from its wall to the rim: along the slot from wheel_radius, and from the wall; none for \
         a sharp one.\nmouth = [{}];",
        mouth(sizes, tolerance)?
    );
    Ok(text + DERIVED + SHAPES + MODEL)
}

/// The model of an internal wheel and its driver, as [`scad()`] of an external one.
///
/// ```
/// use geneva_kinematics::internal_sizes::InternalSizes;
/// use geneva_kinematics::internal_wheel::InternalWheel;
/// use geneva_kinematics::wheel::Choices;
/// use geneva_workshop::{Mounting, internal_scad};
///
/// let sizes = InternalSizes::new(InternalWheel::new(6)?, 50.0, &Choices::default())?; // mm
/// let text = internal_scad(&sizes, 5.0, 0.01, &Mounting::default(), 0.0).expect("a model");
/// assert!(text.contains("crank_radius = 50;") && text.contains("ring_outline"));
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// As for [`internal_parts()`], and [`MountingError::Kinematics`] for a tolerance that is not positive and finite.
pub fn internal_scad(
    sizes: &InternalSizes,
    thickness: f64,
    tolerance: f64,
    mounting: &Mounting,
    hole_allowance: f64,
) -> Result<String, MountingError> {
    let list = internal_parts(sizes, thickness, mounting)?.parts;
    validate(&list, tolerance)?;
    let of = |layer: Layer| list.iter().find(|part| part.layer == layer);
    let pin = PinHole::new(&list, sizes.pin_diameter, mounting, !mounting.is_stacked);
    let mut text = String::from(
        "// Internal Geneva wheel and driver; lengths in millimetres, angles in degrees. All else follows from these numbers.\n",
    );
    let sections: [(&str, &[Variable]); 3] = [
        (
            "Ring and driver",
            &[
                ("stations", f64::from(sizes.wheel.stations()), "slots of the ring, from 3 on"),
                ("crank_radius", sizes.crank_radius, "driver's axis to the pin's centre"),
                ("pin_diameter", sizes.pin_diameter, "of the pin, or of the screw that is the pin"),
                ("horn_thickness", sizes.horn_thickness, "least thickness between a slot and a locking arc"),
                (
                    "bottom_clearance",
                    sizes.slot_end - sizes.centre_distance - sizes.crank_radius,
                    "how much deeper the slots are than the pin needs",
                ),
                ("thickness", thickness, "of ring, ring plate, locking segment and plate"),
            ],
        ),
        (
            "Play",
            &[
                ("slot_play", sizes.play.slot, "width of a slot less the pin's diameter"),
                ("locking_play", sizes.play.locking, "diameter of the locking arcs less that of the segment"),
                ("axial_play", axial_play(sizes.play.slot, mounting), "between ring and plate"),
                ("tolerance", tolerance, "greatest distance of a chord from its arc"),
            ],
        ),
        (
            "Shafts and pin",
            &[
                ("wheel_bore", sizes.bore(sizes.wheel_shaft), "diameter in the ring plate; 0 for none"),
                ("plate_bore", sizes.bore(sizes.plate_shaft), "diameter in the plate; 0 for none"),
                allowance(hole_allowance),
                pin.of_plate(),
                pin.nut_width(),
                pin.nut_depth(),
            ],
        ),
    ];
    write_variables(&mut text, &sections);
    let (closing, plate) = (of(Layer::RingPlate), of(Layer::Plate));
    let holes = [("ring_holes", of(Layer::Wheel)), ("ring_plate_holes", closing), ("plate_holes", plate)];
    let half_pitch = sizes.wheel.half_pitch_angle() * 180.0 / PI;
    let bores = [("wheel", closing, mounting.wheel_fit, half_pitch), ("driver", plate, mounting.driver_fit, 180.0)];
    write_holes(&mut text, &holes, &bores);
    Ok(text + INTERNAL_DERIVED + SHAPES + INTERNAL_MODEL)
}

/// Refuses a chord tolerance that is none, and parts that can't be made as in all files of solids.
fn validate(list: &[Part], tolerance: f64) -> Result<(), MountingError> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(KinematicsError::Size { name: "chord tolerance in mm", asked: tolerance }.into());
    }
    crate::body::validate_solids(list)
}

/// How much wider holes are drawn than they should become, in millimetres.
fn allowance(hole_allowance: f64) -> Variable {
    (
        "hole_allowance",
        hole_allowance,
        "added to the width of every hole but the slots, since the machine makes holes narrower by so much; 0 for true sizes",
    )
}

/// What is in the plate at a pin, in millimetres; zero for what there is not.
struct PinHole {
    plate: f64,
    bush: f64,
    nut: [f64; 2],
}

impl PinHole {
    /// For pins of a diameter in millimetres; without a hole where they may be one piece with the plate.
    fn new(list: &[Part], pin_diameter: f64, mounting: &Mounting, is_one_piece: bool) -> Self {
        let nut = match mounting.pins {
            PinMount::Screw(thread, ScrewHole::NutTrap) => [thread.nut_width(), thread.nut_height()],
            _ => [0.0, 0.0],
        };
        let plate = match mounting.pins {
            PinMount::Solid if is_one_piece => 0.0,
            PinMount::Solid | PinMount::Dowel => pin_diameter,
            PinMount::Screw(thread, hole) => Fastener::Screw(thread, hole).hole(),
        };
        let bush = list.iter().find(|part| part.is_bush());
        let bush = bush.and_then(|bush| bush.holes.first()?.diameter()).unwrap_or(0.0);
        Self { plate, bush, nut }
    }

    fn of_plate(&self) -> Variable {
        ("pin_hole", self.plate, "diameter of the holes for pins; 0: pins are in one piece with the plate")
    }

    fn of_bush(&self) -> Variable {
        ("bush_hole", self.bush, "diameter of the hole in a bush that is the pin; 0 for none")
    }

    fn nut_width(&self) -> Variable {
        ("nut_width", self.nut[0], "across the flats of a nut below each pin; 0 for none")
    }

    fn nut_depth(&self) -> Variable {
        ("nut_depth", self.nut[1], "of the nut's pocket")
    }
}

/// Writes the variables, by section.
fn write_variables(text: &mut String, sections: &[(&str, &[Variable])]) {
    for (title, variables) in sections {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "\n/* [{title}] */");
        for (name, value, meaning) in *variables {
            let _ = writeln!(text, "{name} = {}; // {meaning}", value + 0.0);
        }
    }
    let _ = writeln!(
        text,
        "\n/* [Holes] */\n// Each as [x, y, diameter, width of a nut's pocket from below, its depth, direction of a corner]."
    );
}

/// Writes the lists of holes, and keyways and flats of bores: of what, of which part, with which shaft, and in which direction.
fn write_holes(text: &mut String, lists: &[(&str, Option<&Part>)], bores: &[(&str, Option<&Part>, ShaftFit, f64)]) {
    for (name, part) in lists {
        let holes = part.iter().flat_map(|part| &part.holes);
        let drawn: Vec<String> =
            holes.filter(|hole| matches!(hole.purpose, HolePurpose::Hub | HolePurpose::DiscDowel)).map(row).collect();
        let _ = writeln!(text, "{name} = [{}];", drawn.join(", "));
    }
    let _ = writeln!(text, "// Keyway of a bore as [width, axis to its bottom], or axis to the flat; 0 for none.");
    for (name, part, fit, towards) in bores {
        let (key, flat) = straight(*part, *fit);
        let _ = writeln!(text, "{name}_key = [{}, {}];", key[0], key[1]);
        let _ = writeln!(text, "{name}_flat = {flat};");
        let _ = writeln!(text, "{name}_key_direction = {towards};");
    }
}

/// One side of the mouth of a slot as the file's list of points, from the wall's end to the rim: along the slot from the wheel
/// radius, and from the wall. Empty for a sharp mouth. Corners of chords are on their arc, which leaves less material.
fn mouth(sizes: &Sizes, tolerance: f64) -> Result<String, KinematicsError> {
    let face = Loop { edges: sizes.mouth_face().into_iter().collect() };
    let ends = face.edges.iter().map(Edge::end_point);
    let point = |p: Point| format!("[{}, {}]", p.x - sizes.wheel_radius, p.y - sizes.slot_width / 2.0);
    Ok(face.corners(tolerance)?.into_iter().chain(ends).map(point).collect::<Vec<_>>().join(", "))
}

/// A variable: its name, its number, and what it means.
type Variable = (&'static str, f64, &'static str);

/// From the fixing holes of the base plate to its edge, in millimetres.
fn margin(base: &Part) -> f64 {
    let radius = |edge: &Edge| match edge {
        Edge::Arc { radius, .. } => Some(*radius),
        Edge::Line { .. } => None,
    };
    base.outer.edges.iter().find_map(radius).unwrap_or_default()
}

/// A hole as a list of numbers.
fn row(hole: &Hole) -> String {
    let [x, y] = [hole.centre.x, hole.centre.y].map(|x| x + 0.0);
    let diameter = hole.diameter().unwrap_or_default();
    let pocket = hole.widening.as_ref().and_then(|wide| {
        let corner = wide.outline.edges.first()?.start_point() - hole.centre;
        let across = corner.norm() * libm::sqrt(3.0);
        Some([across, wide.depth, libm::atan2(corner.y, corner.x).to_degrees()])
    });
    let [width, depth, direction] = pocket.unwrap_or([0.0; 3]);
    format!("[{x}, {y}, {diameter}, {width}, {depth}, {direction}]")
}

/// Width and bottom of a bore's keyway, and where its flat is; zero for none.
fn straight(part: Option<&Part>, fit: ShaftFit) -> ([f64; 2], f64) {
    let bore = part.and_then(|part| part.holes.iter().find(|hole| hole.purpose == HolePurpose::Bore));
    let lines = bore.into_iter().flat_map(|hole| &hole.outline.edges);
    // The line across is the one whose middle is farthest along; its distance from the axis, and its length.
    let across = lines.filter_map(|edge| match edge {
        Edge::Line { from, to } => Some([(to - from).norm(), (from + to).norm() / 2.0]),
        Edge::Arc { .. } => None,
    });
    let Some(line) = across.max_by(|a, b| a[1].total_cmp(&b[1])) else { return ([0.0; 2], 0.0) };
    match fit {
        ShaftFit::Round => ([0.0; 2], 0.0),
        ShaftFit::Key => (line, 0.0),
        ShaftFit::Flat { .. } => ([0.0; 2], line[1]),
    }
}

/// All other sizes, as they follow, and what must hold of them.
const DERIVED: &str = include_str!("scad/derived.scad");

/// The parts, and which of them is shown.
const MODEL: &str = include_str!("scad/model.scad");

/// All other sizes of an internal wheel, and what must hold of them.
const INTERNAL_DERIVED: &str = include_str!("scad/internal_derived.scad");

/// The parts of an internal wheel.
const INTERNAL_MODEL: &str = include_str!("scad/internal_model.scad");

/// Circles, bores and holes of both kinds of wheel.
const SHAPES: &str = include_str!("scad/shapes.scad");
