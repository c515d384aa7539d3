//! The base plate that carries both axes.

use super::error::MountingError;
use super::holes::{Hole, HolePurpose, Widening};
use super::mounting::{BasePlate, Fastener, ScrewHole};
use super::part::{Layer, Part, Place};
use crate::geometry::Point;
use geneva_kinematics::wheel::{Edge, Loop, Sizes};
use std::f64::consts::FRAC_PI_2;

/// From a fixing hole's middle to the base plate's edge, over the screw's diameter: room for head and washer, our choice.
const TO_EDGE: f64 = 1.5;

/// The base plate below the driver's plate: a rectangle with rounded corners about what turns over it.
///
/// The screws stand outside of wheel and driver, at the corners of the rectangle about both.
pub(super) fn base_plate(sizes: &Sizes, base: BasePlate, thickness: f64, top: f64) -> Result<Part, MountingError> {
    let part = Layer::BasePlate.words();
    let thickness = base.thickness.unwrap_or(thickness);
    if !(thickness > 0.0 && thickness.is_finite()) {
        return Err(MountingError::Thickness { part, asked: thickness });
    }
    let (rim, plate, axes) = (sizes.tip_radius, sizes.plate_radius, [0.0, sizes.centre_distance]);
    let margin = TO_EDGE * base.screws.map_or(sizes.pin_diameter, |screw| screw.diameter());
    let (left, right, half) = (-rim, axes[1] + plate, rim.max(plate));
    let mut holes = Vec::new();
    for (axis, bore) in axes.into_iter().zip([sizes.wheel_bore(), sizes.plate_bore()]) {
        let centre = Point::new(axis, 0.0);
        if bore <= 0.0 {
            if base.shoulder.is_some() {
                return Err(MountingError::NoShaft { part, what: "a shoulder" });
            }
            continue;
        }
        let mut hole = Hole::round(HolePurpose::Bore, centre, bore);
        if let Some([diameter, depth]) = base.shoulder {
            let range = "more than the shaft's bore and finite";
            let asked = |what, asked| Err(MountingError::Pattern { what, asked, range });
            if !(diameter > bore && diameter.is_finite()) {
                return asked("diameter of the shoulder in mm", diameter);
            }
            if !(depth > 0.0 && depth.is_finite()) {
                let range = "above zero and finite";
                return Err(MountingError::Pattern { what: "depth of the shoulder in mm", asked: depth, range });
            }
            let outline = Loop::circle(centre, diameter / 2.0, true);
            hole.widening = Some(Widening { outline, depth, is_from_below: false });
        }
        holes.push(hole);
    }
    if let Some(screw) = base.screws {
        let fastener = Fastener::Screw(screw, ScrewHole::Clearance);
        let corners = [(left, -half), (right, -half), (right, half), (left, half)];
        let fixing = |(x, y)| Hole::fastened(HolePurpose::Fixing, Point::new(x, y), fastener, 0.0);
        holes.extend(corners.map(fixing));
    }
    Ok(Part {
        layer: Layer::BasePlate,
        outer: rounded([left, right], half, margin),
        holes,
        marks: axes.map(|axis| Point::new(axis, 0.0)).to_vec(),
        thickness,
        places: vec![Place { turn: 0.0, at: Point::zeros(), bottom: top - thickness }],
        engraved: Vec::new(),
        is_joined: false,
        hole_allowance: 0.0,
    })
}

/// The rectangle from left to right and as far up as down, wider by a margin, with which its corners are rounded.
fn rounded([left, right]: [f64; 2], half: f64, margin: f64) -> Loop {
    let corners = [(right, half), (left, half), (left, -half), (right, -half)].map(|(x, y)| Point::new(x, y));
    let mut edges = Vec::new();
    for (k, centre) in corners.into_iter().enumerate() {
        let start = FRAC_PI_2 * k as f64;
        let arc = Edge::Arc { centre, radius: margin, start, sweep: FRAC_PI_2 };
        let next = corners[(k + 1) % 4];
        let to = Edge::Arc { centre: next, radius: margin, start: start + FRAC_PI_2, sweep: FRAC_PI_2 }.start_point();
        edges.extend([arc, Edge::Line { from: arc.end_point(), to }]);
    }
    Loop { edges }
}
