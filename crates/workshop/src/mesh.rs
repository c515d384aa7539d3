//! Closed surfaces of triangles around the parts.
//!
//! Arcs become chords, within the material everywhere: a mesh has bosses that are a little thinner than the part's and holes that
//! are a little wider, by the tolerance at most. So chords take nothing of the play.

use crate::body::{Body, bodies_of_chords};
use crate::crossings::{BoundPiece, PieceKey};
use crate::parts::{MountingError, Part};
use earcut::Earcut;
use geneva_kinematics::wheel::{Edge, Loop};
use nalgebra::{Vector2, Vector3};

/// A closed surface; lengths in millimetres.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Its triangles, each with its corners counter-clockwise as seen from outside.
    pub triangles: Vec<[Vector3<f64>; 3]>,
}

impl Mesh {
    /// The volume inside, in cubic millimetres.
    pub fn volume(&self) -> f64 {
        self.triangles.iter().map(|[a, b, c]| a.dot(&b.cross(c))).sum::<f64>() / 6.0
    }

    /// The surface moved along the first axis, in millimetres.
    pub(crate) fn translate(mut self, x: f64) -> Self {
        self.triangles.iter_mut().flatten().for_each(|corner| corner.x += x);
        self
    }

    /// A flat face at a height, seen from above or from below.
    fn face(&mut self, loops: &[&Polygon], height: f64, from_above: bool) {
        let mut corners: Vec<[f64; 2]> = Vec::new();
        let mut holes: Vec<u32> = Vec::new();
        for polygon in loops {
            if !corners.is_empty() {
                holes.push(corners.len() as u32);
            }
            corners.extend(polygon.iter().map(|p| [p.x, p.y]));
        }
        let mut found: Vec<u32> = Vec::new();
        Earcut::new().earcut(corners.iter().copied(), &holes, &mut found);
        let mut triangles: Vec<[u32; 3]> = found.chunks_exact(3).map(|of| [of[0], of[1], of[2]]).collect();
        // All triangles have one sense: it is that of all of them together, and rounding cannot turn a single one.
        let sum: f64 = triangles.iter().map(|of| twice_area(&corners, of)).sum();
        if (sum > 0.0) != from_above {
            triangles.iter_mut().for_each(|of| of.swap(1, 2));
        }
        flip_slivers(&corners, &mut triangles);
        let at = |k: u32| corners.get(k as usize).map(|[x, y]| Vector3::new(*x, *y, height));
        let solid = |of: [u32; 3]| match of.map(at) {
            [Some(a), Some(b), Some(c)] => Some([a, b, c]),
            _ => None,
        };
        self.triangles.extend(triangles.into_iter().filter_map(solid));
    }

    /// The wall over a straight line with the material on its left, between its corners below and those above.
    fn wall(&mut self, [below, above]: [&[Vector2<f64>]; 2], bottom: f64, top: f64) {
        let at = |p: &Vector2<f64>, height| Vector3::new(p.x, p.y, height);
        let (Some(first), Some(last)) = (below.first(), above.last()) else { return };
        let low = below.windows(2).map(|pair| [at(&pair[0], bottom), at(&pair[1], bottom), at(last, top)]);
        self.triangles.extend(low);
        let high = above.windows(2).map(|pair| [at(first, bottom), at(&pair[1], top), at(&pair[0], top)]);
        self.triangles.extend(high);
    }
}

type Polygon = Vec<Vector2<f64>>;

/// A triangle whose height is this part of its longest side or less has no area but for rounding.
const SLIVER: f64 = 1e-9;

/// Twice the area of a triangle of these corners, positive if it runs counter-clockwise; zero for one without corners.
fn twice_area(corners: &[[f64; 2]], triangle: &[u32; 3]) -> f64 {
    match triangle.map(|k| corners.get(k as usize)) {
        [Some([ax, ay]), Some([bx, by]), Some([cx, cy])] => (bx - ax) * (cy - ay) - (by - ay) * (cx - ax),
        _ => 0.0,
    }
}

/// Gives each triangle without area to its neighbour behind its longest side: the middle corner is on that side, so the
/// two triangles become two others of the same outline, each with area. The senses of all sides stay as they are.
fn flip_slivers(corners: &[[f64; 2]], triangles: &mut [[u32; 3]]) {
    let length = |from: u32, to: u32| match (corners.get(from as usize), corners.get(to as usize)) {
        (Some(a), Some(b)) => libm::hypot(b[0] - a[0], b[1] - a[1]),
        _ => 0.0,
    };
    for _ in 0..triangles.len() {
        let longest = |of: &[u32; 3]| (0..3).map(|k| length(of[k], of[(k + 1) % 3])).fold(0.0, f64::max);
        let is_sliver = |of: &[u32; 3]| twice_area(corners, of).abs() <= SLIVER * longest(of) * longest(of);
        let Some(at) = triangles.iter().position(is_sliver) else { return };
        let of = triangles[at];
        // Turned so that its longest side runs from the last corner to the first.
        let Some(last) = (0..3).max_by(|j, k| {
            let side = |k: usize| length(of[k], of[(k + 1) % 3]);
            side(*j).total_cmp(&side(*k))
        }) else {
            return;
        };
        let [a, b, c] = [of[(last + 1) % 3], of[(last + 2) % 3], of[last]];
        let behind = |other: &[u32; 3]| (0..3).find(|k| other[*k] == a && other[(k + 1) % 3] == c);
        let found = triangles.iter().enumerate().find_map(|(k, other)| Some((k, other[(behind(other)? + 2) % 3])));
        let Some((neighbour, d)) = found else { return };
        triangles[at] = [a, b, d];
        triangles[neighbour] = [b, c, d];
    }
}

impl Body {
    /// The surface of a solid whose lines are all straight.
    ///
    /// Where lines meet at a height, their walls have a corner there at that height only: elsewhere it would be none of its face.
    pub(crate) fn mesh(&self) -> Mesh {
        let mut mesh = Mesh::default();
        for cap in &self.caps {
            let loops: Vec<Polygon> = cap.bounds.iter().map(|bound| self.corners(bound, cap.height)).collect();
            mesh.face(&loops.iter().collect::<Vec<_>>(), cap.height, cap.is_up);
        }
        for wall in &self.walls {
            let Some(of) = self.lines.get(wall.line) else { continue };
            let [below, above] = [wall.bottom, wall.top].map(|height| self.straight_sides(wall.line, of, height));
            for (below, above) in below.iter().zip(&above) {
                mesh.wall([below, above], wall.bottom, wall.top);
            }
        }
        mesh
    }

    /// Whether a piece begins at a corner of its line at a height.
    fn is_corner(&self, piece: PieceKey, height: f64) -> bool {
        !self.cut.is_inner(piece) || self.crossed.contains(&height)
    }

    /// The straight sides of a line as it was, each from corner to corner, with the corners in between that it has at a height.
    fn straight_sides(&self, line: usize, of: &Loop, height: f64) -> Vec<Polygon> {
        let mut sides: Vec<Polygon> = Vec::new();
        for (piece, edge) in of.edges.iter().enumerate() {
            if !self.cut.is_inner((line, piece)) {
                let start = edge.start_point();
                sides.last_mut().into_iter().for_each(|side| side.push(start));
                sides.push(vec![start]);
            } else if let Some(side) = sides.last_mut().filter(|_| self.is_corner((line, piece), height)) {
                side.push(edge.start_point());
            }
        }
        let start = of.edges.first().map(Edge::start_point);
        sides.last_mut().into_iter().for_each(|side| side.extend(start));
        sides
    }

    /// The corners of a bound at a height; those of a whole line in the line's own order.
    fn corners(&self, bound: &[BoundPiece], height: f64) -> Polygon {
        let edge = |side: &&BoundPiece| Some((**side, *self.lines.get(side.piece.0)?.edges.get(side.piece.1)?));
        if bound.iter().all(|side| !side.is_forward) {
            let has_corner = |side: &&BoundPiece| self.is_corner(side.piece, height);
            return bound
                .iter()
                .rev()
                .filter(has_corner)
                .filter_map(|side| edge(&side))
                .map(|of| of.1.start_point())
                .collect();
        }
        let start = |(side, of): (BoundPiece, Edge)| if side.is_forward { of.start_point() } else { of.end_point() };
        let is_whole = bound.iter().all(|side| side.is_forward);
        let has_corner = |side: &&BoundPiece| !is_whole || self.is_corner(side.piece, height);
        bound.iter().filter(has_corner).filter_map(|side| edge(&side)).map(start).collect()
    }
}

/// The solids of these parts as they lie side by side on a printer's bed, each with a name: wheel, driver and what else there
/// is. Chords leave their arcs by the tolerance at most, in millimetres.
///
/// Locking disc and pins that are in one piece with the plate stand on it.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Mounting, meshes, parts};
///
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
/// let list = parts(&sizes, 5.0, &Mounting::default()).expect("bare parts");
/// let meshes = meshes(&list.parts, 0.01).expect("meshes");
/// assert_eq!(meshes.iter().map(|(name, _)| *name).collect::<Vec<_>>(), ["wheel", "driver"]);
/// let volume = list.parts[0].volume(); // mm³
/// assert!((meshes[0].1.volume() / volume - 1.0).abs() < 1e-3); // chords are not arcs
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// [`MountingError::TooDeep`] for a pocket that leaves nothing below it, [`MountingError::Floating`] for a disc that touches its
/// plate nowhere, and [`MountingError::Kinematics`] for a tolerance that is not positive and finite.
pub fn meshes(parts: &[Part], tolerance: f64) -> Result<Vec<(&'static str, Mesh)>, MountingError> {
    let mut right: Option<f64> = None;
    let mut all = Vec::new();
    for body in bodies_of_chords(parts, tolerance)? {
        let [from, to] = body.extent;
        let mesh = body.mesh();
        for _ in &body.places {
            let at = right.map_or(0.0, |right| right + SPACE - from);
            right = Some(at + to);
            all.push((body.name, mesh.clone().translate(at)));
        }
    }
    Ok(all)
}

/// Space between parts that lie side by side, in millimetres: our choice.
const SPACE: f64 = 5.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::{Mounting, parts};
    use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    use std::collections::HashMap;

    /// Each edge is shared by two triangles, which run along it in opposite senses; none is degenerate.
    #[track_caller]
    fn is_closed(mesh: &Mesh, name: &str) {
        let key = |p: &Vector3<f64>| [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits());
        let mut edges: HashMap<_, i32> = HashMap::new();
        for triangle in &mesh.triangles {
            let [a, b, c] = triangle;
            assert!((b - a).cross(&(c - a)).norm() > 0.0, "{name}: {triangle:?}");
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges.entry((key(from), key(to))).or_default() += 1;
            }
        }
        for ((from, to), count) in &edges {
            assert_eq!((*count, edges.get(&(*to, *from))), (1, Some(&1)), "{name}");
        }
    }

    #[test]
    fn meshes_are_closed_and_as_large_as_the_parts() {
        let counts = (3..=7).flat_map(|stations| (1..=6).map(move |pins| (stations, pins))).chain([(12, 1), (60, 2)]);
        for (stations, pins) in counts {
            let Ok(wheel) = Wheel::with_pins(stations, pins) else { continue };
            let sizes = Sizes::new(wheel, Scale::CentreDistance(100.0), &Choices::default()).unwrap();
            for is_stacked in [false, true] {
                let mounting = Mounting { is_stacked, ..Mounting::default() };
                let list = parts(&sizes, 5.0, &mounting).unwrap().parts;
                let all = meshes(&list, 0.002).unwrap();
                let volume: f64 = all.iter().map(|(_, mesh)| mesh.volume()).sum();
                let mut drawn: f64 = list.iter().map(|part| part.volume() * part.quantity() as f64).sum();
                if !is_stacked {
                    // The pins fill their holes.
                    drawn += std::f64::consts::PI * sizes.pin_radius().powi(2) * 5.0 * f64::from(pins);
                }
                let name = format!("{stations} stations, {pins} pins, {is_stacked}");
                all.iter().for_each(|(of, mesh)| is_closed(mesh, &format!("{name}: {of}")));
                approx::assert_relative_eq!(volume, drawn, max_relative = 2e-3);
            }
        }
    }

    /// A plate of a square, with a corner in the middle of the diagonal on which two triangles meet.
    #[test]
    fn a_triangle_without_area_goes_to_its_neighbour() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]];
        let mut triangles = [[0, 1, 4], [1, 2, 4], [0, 4, 2], [0, 2, 3]];
        assert_eq!(twice_area(&corners, &triangles[2]), 0.0);
        flip_slivers(&corners, &mut triangles);
        assert_eq!(triangles, [[0, 1, 4], [1, 2, 4], [0, 4, 3], [4, 2, 3]]);
        assert!(triangles.iter().all(|of| twice_area(&corners, of) > 0.0));
    }

    #[test]
    fn a_mesh_without_thickness_or_tolerance_is_refused() {
        let sizes = Sizes::new(Wheel::new(6).unwrap(), Scale::CrankRadius(50.0), &Choices::default()).unwrap();
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let refused = parts(&sizes, wrong, &Mounting::default());
            assert!(matches!(refused, Err(MountingError::Thickness { .. })));
            let list = parts(&sizes, 1.0, &Mounting::default()).unwrap().parts;
            assert!(matches!(meshes(&list, wrong), Err(MountingError::Kinematics(_))));
        }
    }
}
