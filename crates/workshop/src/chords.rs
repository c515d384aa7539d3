//! Polygons in place of arcs, which take nothing of any play: the material of the polygon is all within that of the part.
//!
//! Around a boss, the corners are on the circle, and the sides within it. Around a hole, the sides touch the circle, and the corners are
//! beyond it. The models for OpenSCAD have the same rule.

use crate::geometry::{Point, direction};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::{Edge, Loop};
use std::f64::consts::PI;

/// The longest chord as an angle, in radians: twelve around a circle, however coarse the tolerance.
const MOST_CHORD: f64 = PI / 6.0;

/// A corner at which the line turns by less than this angle, in radians, is none.
const STRAIGHT: f64 = 1e-9;

/// The corners of a polygon within the material, which is on the loop's left; it leaves the loop by this tolerance at most, in
/// millimetres, but for circles of so few corners that twelve leave it by more.
///
/// # Errors
///
/// [`KinematicsError::Size`] for a tolerance that is not positive and finite.
pub(crate) fn inner_polygon(of: &Loop, tolerance: f64) -> Result<Vec<Point>, KinematicsError> {
    let mut corners = Loop { edges: Vec::new() }.corners(tolerance)?;
    for edge in &of.edges {
        match *edge {
            Edge::Arc { centre, radius, start, sweep } if sweep < 0.0 => {
                // The sides between touch the circle, so a corner in the middle of the chord x is r / cos(x/2) from the centre.
                let half = libm::atan((tolerance * (2.0 * radius + tolerance)).sqrt() / radius);
                let count = libm::ceil(-sweep / (2.0 * half).min(MOST_CHORD)).clamp(1.0, 1e5);
                let step = sweep / count;
                let far = radius / libm::cos(step / 2.0);
                let at = |k: u32| centre + direction(start + step * (f64::from(k) + 0.5)) * far;
                corners.push(edge.start_point());
                corners.extend((0..count as u32).map(at));
            }
            Edge::Arc { centre, radius, start, sweep } => {
                // A chord of the angle x leaves its arc by r (1 − cos(x/2)).
                let chord = 4.0 * libm::asin((tolerance / (2.0 * radius)).sqrt().min(1.0));
                let count = libm::ceil(sweep / chord.min(MOST_CHORD)).clamp(1.0, 1e5);
                let at = |k: u32| centre + direction(start + sweep / count * f64::from(k)) * radius;
                corners.extend((0..count as u32).map(at));
            }
            Edge::Line { from, .. } => corners.push(from),
        }
    }
    let turns = |k: usize| {
        let at = |k: usize| corners[k % corners.len()];
        let (before, after) = (at(k) - at(k + corners.len() - 1), at(k + 1) - at(k));
        libm::atan2(before.perp(&after), before.dot(&after)).abs() > STRAIGHT
    };
    Ok((0..corners.len()).filter(|k| turns(*k)).map(|k| corners[k]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{distance, encloses, point_along};
    use crate::mesh::meshes;
    use crate::parts::{
        BasePlate, Fastener, Mounting, Part, Pattern, PinMount, ScrewHole, ShaftFit, Thread, internal_parts, parts,
        test_piece,
    };
    use geneva_kinematics::internal_sizes::InternalSizes;
    use geneva_kinematics::internal_wheel::InternalWheel;
    use geneva_kinematics::wheel::{Choices, Mouth, Scale, Sizes, Wheel};
    use std::collections::BTreeMap;

    /// Parts with holes of all kinds: bores with keyway and flat, dowels, screws with nuts, a bush, a shoulder, slots.
    fn all_parts() -> Vec<Part> {
        let nut = Fastener::Screw(Thread::M3, ScrewHole::NutTrap);
        let mounting = Mounting {
            wheel_fit: ShaftFit::Key,
            driver_fit: ShaftFit::Flat { across: 7.0 },
            wheel_hub: Some(Pattern { count: 3, circle: 40.0, fastener: nut }),
            driver_hub: Some(Pattern { count: 3, circle: 22.0, fastener: nut }),
            pins: PinMount::Screw(Thread::M6, ScrewHole::NutTrap),
            disc_dowels: None,
            is_stacked: true,
            base: Some(BasePlate { thickness: Some(9.0), shoulder: Some([30.0, 4.0]), screws: Some(Thread::M5) }),
            axial_play: None,
        };
        let mouth = Mouth::Round { radius: 2.0 };
        let choices = Choices { wheel_shaft: Some(20.0), driver_shaft: Some(8.0), mouth, ..Choices::default() };
        let sizes = Sizes::new(Wheel::new(6).unwrap(), Scale::CrankRadius(60.0), &choices).unwrap();
        let internal = InternalSizes::new(InternalWheel::new(5).unwrap(), 60.0, &Choices::default()).unwrap();
        let dowelled = Mounting {
            disc_dowels: Some(Pattern { count: 5, circle: 2.0 * internal.slot_end, fastener: Fastener::Dowel(4.0) }),
            pins: PinMount::Dowel,
            is_stacked: true,
            ..Mounting::default()
        };
        let mut all = parts(&sizes, 8.0, &mounting).unwrap().parts;
        all.extend(internal_parts(&internal, 8.0, &dowelled).unwrap().parts);
        all.extend(test_piece(6.0, 8.0).unwrap());
        all
    }

    /// The sides of the outlines in a mesh, those below walls, by their height in micrometres.
    fn sides(part: &Part, tolerance: f64) -> BTreeMap<i64, Vec<[Point; 2]>> {
        let mut sides: BTreeMap<i64, Vec<[Point; 2]>> = BTreeMap::new();
        for (_, mesh) in meshes(std::slice::from_ref(part), tolerance).unwrap().into_iter().take(1) {
            for [a, b, c] in mesh.triangles {
                let is_wall = (b - a).cross(&(c - a)).normalize().z.abs() < 0.5;
                for (from, to) in [(a, b), (b, c), (c, a)] {
                    if is_wall && from.z == to.z {
                        sides.entry((from.z * 1000.0).round() as i64).or_default().push([from.xy(), to.xy()]);
                    }
                }
            }
        }
        sides
    }

    /// Whether a point is in the material of a part just above a height, or on its lines but for rounding.
    fn is_material(part: &Part, height: f64, p: Point) -> bool {
        let is_on = |of: &Loop| of.edges.iter().any(|edge| distance(edge, p) < 1e-9);
        let is_open = |hole: &crate::parts::Hole| {
            let wide = hole.widening.as_ref().filter(|wide| {
                if wide.is_from_below { height < wide.depth } else { height >= part.thickness - wide.depth }
            });
            let line = wide.map_or(&hole.outline, |wide| &wide.outline);
            encloses(line, p) && !is_on(line)
        };
        (encloses(&part.outer, p) || is_on(&part.outer)) && !part.holes.iter().any(is_open)
    }

    #[test]
    fn meshes_take_material_and_never_add_some_at_holes_of_all_kinds_and_at_bosses() {
        let tolerance = 0.05;
        let (mut looked_at, mut beyond) = (0, 0.0_f64);
        for part in all_parts().iter().map(|part| Part { is_joined: false, ..part.clone() }) {
            // Where it lies side by side with others, it is moved.
            for (height, sides) in sides(&part, tolerance) {
                // Walls end at a height from below or from above.
                for [a, b] in sides {
                    for share in [0.0, 0.25, 0.5, 0.75] {
                        let p = a + (b - a) * share;
                        let height = height as f64 / 1000.0;
                        let is_in = |at: f64| is_material(&part, at, p);
                        assert!(is_in(height) || is_in(height - 1e-6), "{:?} at {height}: {p:?}", part.layer);
                        let pockets = part.holes.iter().filter_map(|hole| Some(&hole.widening.as_ref()?.outline));
                        let face = part.face();
                        let far = face.loops().chain(pockets).flat_map(|of| &of.edges).map(|edge| distance(edge, p));
                        let far = far.fold(f64::INFINITY, f64::min);
                        assert!(far < tolerance * (1.0 + 1e-6), "{:?}: {far}", part.layer);
                        (looked_at, beyond) = (looked_at + 1, beyond.max(far));
                    }
                }
            }
        }
        assert!(looked_at > 5000 && beyond > 0.9 * tolerance, "{looked_at} {beyond}");
    }

    #[test]
    fn holes_of_all_kinds_become_wider_on_all_sides_and_slots_do_not() {
        let (mut straight, mut pockets, mut slots) = (0, 0, 0);
        for part in all_parts() {
            let wider = part.clone().with_wider_holes(0.2);
            for (hole, other) in part.holes.iter().zip(&wider.holes) {
                let is_slot =
                    matches!(hole.purpose, crate::parts::HolePurpose::Inside | crate::parts::HolePurpose::TestSlot);
                if is_slot {
                    assert_eq!(hole, other);
                    slots += 1;
                    continue;
                }
                let pocket = |of: &crate::parts::Hole| of.widening.as_ref().map(|wide| wide.outline.clone());
                let lines = [Some((hole.outline.clone(), other.outline.clone())), pocket(hole).zip(pocket(other))];
                for (line, other) in lines.into_iter().flatten() {
                    for edge in &other.edges {
                        for k in 0..8 {
                            let p = point_along(edge, f64::from(k) / 8.0);
                            let far = line.edges.iter().map(|of| distance(of, p)).fold(f64::INFINITY, f64::min);
                            assert!((far - 0.1).abs() < 1e-9 && !encloses(&line, p), "{:?}: {far}", hole.purpose);
                        }
                    }
                    assert!(crate::geometry::area(&other) < crate::geometry::area(&line), "a hole runs clockwise");
                    let lines = line.edges.iter().filter(|edge| matches!(edge, Edge::Line { .. })).count();
                    straight += usize::from(lines > 0);
                }
                pockets += usize::from(hole.widening.is_some());
            }
        }
        assert!(straight > 5 && pockets > 5 && slots > 10, "{straight} {pockets} {slots}");
    }
}
