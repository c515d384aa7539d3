//! The parts of the test piece that measures the play of a machine.

use super::holes::{Hole, HolePurpose};
use super::part::{Layer, Part, Place};
use crate::geometry::Point;
use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::as_built::TestPiece;
use geneva_kinematics::wheel::{Edge, Face};

/// The plate of a test piece with its ladder of slots, and its pins, so thick and for pins of this diameter, in millimetres.
///
/// The narrowest slot is at the left; files with lines have the play of each below it, in hundredths of a millimetre. A pin is as
/// long as the plate is thick, three times over, to be held.
///
/// ```
/// use geneva_workshop::{Layer, test_piece};
///
/// let parts = test_piece(6.0, 5.0)?; // mm
/// assert_eq!((parts[0].layer, parts[0].holes.len()), (Layer::TestPiece, 12));
/// assert_eq!((parts[1].layer, parts[1].quantity()), (Layer::Pins, 3));
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
///
/// # Errors
///
/// [`KinematicsError::Length`] for a diameter or a thickness that is not positive and finite.
pub fn test_piece(pin_diameter: f64, thickness: f64) -> Result<Vec<Part>, KinematicsError> {
    if !(thickness > 0.0 && thickness.is_finite()) {
        return Err(KinematicsError::Length { name: "thickness of the test piece", asked: thickness });
    }
    let TestPiece { plate: Face { outer, holes }, pins, strokes, .. } = TestPiece::new(pin_diameter)?;
    let slot = |outline| Hole { purpose: HolePurpose::TestSlot, centre: Point::zeros(), outline, widening: None };
    let still = Place { turn: 0.0, at: Point::zeros(), bottom: 0.0 };
    let plate = Part {
        layer: Layer::TestPiece,
        outer,
        holes: holes.into_iter().map(slot).collect(),
        marks: Vec::new(),
        engraved: strokes.into_iter().map(|[from, to]| Edge::Line { from, to }).collect(),
        thickness,
        places: vec![still],
        is_joined: false,
        hole_allowance: 0.0,
    };
    // All pins are alike: the first one, about its own axis, at the places of all.
    let middles: Vec<Point> = pins.iter().filter_map(|pin| Some(middle(pin.outer.edges.first()?))).collect();
    let Some(first) = middles.first().copied() else { return Ok(vec![plate]) };
    let pin = Part {
        layer: Layer::Pins,
        outer: pins.into_iter().next().map(|pin| pin.outer.transform(0.0, -first)).unwrap_or(plate.outer.clone()),
        holes: Vec::new(),
        marks: Vec::new(),
        engraved: Vec::new(),
        thickness: LENGTH * thickness,
        places: middles.into_iter().map(|at| Place { at, ..still }).collect(),
        is_joined: false,
        hole_allowance: 0.0,
    };
    Ok(vec![plate, pin])
}

/// Length of a pin of the test piece over the plate's thickness: our choice.
const LENGTH: f64 = 3.0;

fn middle(edge: &Edge) -> Point {
    match *edge {
        Edge::Arc { centre, .. } => centre,
        Edge::Line { from, to } => (from + to) / 2.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PartLayout, dxf, meshes, svg_parts};

    #[test]
    fn each_slot_is_wider_than_the_pin_by_its_rung_in_every_file() {
        let parts = test_piece(6.0, 5.0).unwrap();
        let widths: Vec<f64> = parts[0].holes.iter().map(|hole| 2.0 * arc_radius(hole)).collect();
        for (k, width) in widths.iter().enumerate() {
            assert!((width - 6.0 - 0.05 * (k + 1) as f64).abs() < 1e-12, "{k}: {width}");
        }
        let volume: f64 = meshes(&parts[..1], 0.001).unwrap().iter().map(|mesh| mesh.1.volume()).sum();
        approx::assert_relative_eq!(volume, parts[0].face().area() * 5.0, max_relative = 1e-4);
        assert_eq!(dxf(&parts, PartLayout::Apart).matches("TEST_PIECE").count(), 1 + 4 + 4 * 12);
        // Twelve slots, a rim and the strokes of 24 digits; a pin.
        let svg = svg_parts(&parts[..1], 0.0).unwrap();
        assert!(svg.matches("#ff0000").count() == 13 && svg.matches("#0000ff").count() > 24 * 2, "{svg}");
    }

    fn arc_radius(hole: &Hole) -> f64 {
        hole.outline
            .edges
            .iter()
            .find_map(|edge| match edge {
                Edge::Arc { radius, .. } => Some(*radius),
                Edge::Line { .. } => None,
            })
            .unwrap()
    }

    #[test]
    fn a_thickness_that_is_none_is_refused() {
        for thickness in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(test_piece(6.0, thickness).is_err(), "{thickness}");
        }
    }
}
