//! Closed surfaces of triangles around the parts.
//!
//! Arcs become chords; the corners are on the arcs. So a mesh is inside its part at outer arcs and outside at hollow
//! ones, by the tolerance at most: keep that well below the play.

use earcut::Earcut;
use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::{Face, Loop, Outline, Sizes};
use nalgebra::{Vector2, Vector3};

/// Thickness and accuracy of a solid made from a part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// Thickness of the wheel, of the locking disc and of the plate, in millimetres.
    pub thickness: f64,
    /// Greatest distance of a chord from its arc, in millimetres.
    pub tolerance: f64,
}

impl Solid {
    /// The solid, if its lengths are positive and finite.
    pub(crate) fn validate(self) -> Result<Self, KinematicsError> {
        for (name, asked) in [("thickness", self.thickness), ("chord tolerance", self.tolerance)] {
            if !(asked > 0.0 && asked.is_finite()) {
                return Err(KinematicsError::Length { name, asked });
            }
        }
        Ok(self)
    }
}

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

    /// The wall over a loop with the material on its left, from one height to another.
    fn wall(&mut self, polygon: &Polygon, bottom: f64, top: f64) {
        for (from, to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
            let at = |p: &Vector2<f64>, height| Vector3::new(p.x, p.y, height);
            let [a, b, c, d] = [at(from, bottom), at(to, bottom), at(to, top), at(from, top)];
            self.triangles.extend([[a, b, c], [a, c, d]]);
        }
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

/// The wheel as a plate on the plane z = 0.
///
/// # Errors
///
/// [`KinematicsError::Length`] for a thickness or a tolerance that is not positive and finite.
pub fn wheel_mesh(sizes: &Sizes, solid: Solid) -> Result<Mesh, KinematicsError> {
    let Solid { thickness, tolerance } = solid.validate()?;
    let loops = corners(&sizes.outline().wheel, tolerance)?;
    let mut mesh = Mesh::default();
    let all: Vec<_> = loops.iter().collect();
    mesh.face(&all, 0.0, false);
    mesh.face(&all, thickness, true);
    loops.iter().for_each(|of| mesh.wall(of, 0.0, thickness));
    Ok(mesh)
}

/// The driver in one piece: the plate on the plane z = 0, locking disc and pins on it.
///
/// Disc and pins stand above the plate by the wheel's thickness and the play of the slots, so that the wheel runs between
/// plate and tops.
///
/// # Errors
///
/// As for [`wheel_mesh`].
pub fn driver_mesh(sizes: &Sizes, solid: Solid) -> Result<Mesh, KinematicsError> {
    let Solid { thickness, tolerance } = solid.validate()?;
    let Outline { disc, plate, pins, .. } = sizes.outline();
    let (middle, top) = (thickness, 2.0 * thickness + sizes.play.slot);
    let plate = corners(&plate, tolerance)?;
    let disc = disc.map(|disc| corners(&disc, tolerance)).transpose()?;
    let pins = pins.iter().map(|pin| pin.corners(tolerance)).collect::<Result<Vec<_>, _>>()?;

    let mut mesh = Mesh::default();
    mesh.face(&plate.iter().collect::<Vec<_>>(), 0.0, false);
    let Some((rim, bores)) = plate.split_first() else { return Ok(mesh) };
    mesh.wall(rim, 0.0, middle);
    // The bore goes through plate and disc.
    bores.iter().for_each(|bore| mesh.wall(bore, 0.0, if disc.is_some() { top } else { middle }));
    // What stands on the plate is a hole of its upper face.
    let stands = disc.iter().flat_map(|disc| disc.first()).chain(&pins);
    let on_plate = if disc.is_some() { &[] } else { bores };
    mesh.face(&[rim].into_iter().chain(stands.clone()).chain(on_plate).collect::<Vec<_>>(), middle, true);
    stands.for_each(|of| mesh.wall(of, middle, top));
    if let Some(disc) = &disc {
        mesh.face(&disc.iter().collect::<Vec<_>>(), top, true);
    }
    pins.iter().for_each(|pin| mesh.face(&[pin], top, true));
    Ok(mesh)
}

fn corners(face: &Face, tolerance: f64) -> Result<Vec<Polygon>, KinematicsError> {
    face.loops().map(|of: &Loop| of.corners(tolerance)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_kinematics::wheel::{Choices, Scale, Wheel};
    use std::collections::HashMap;
    use std::f64::consts::PI;

    fn sizes(stations: u32, pins: u32) -> Sizes {
        let wheel = Wheel::with_pins(stations, pins).unwrap();
        Sizes::new(wheel, Scale::CentreDistance(100.0), &Choices::default()).unwrap()
    }

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
    fn meshes_are_closed_and_as_large_as_the_outlines() {
        let counts = (3..=7).flat_map(|stations| (1..=6).map(move |pins| (stations, pins))).chain([(12, 1), (60, 2)]);
        for (stations, pins) in counts {
            if Wheel::with_pins(stations, pins).is_err() {
                continue;
            }
            let sizes = sizes(stations, pins);
            let outline = sizes.outline();
            let solid = Solid { thickness: 5.0, tolerance: 0.005 };
            let (wheel, driver) = (wheel_mesh(&sizes, solid).unwrap(), driver_mesh(&sizes, solid).unwrap());
            let name = format!("{stations} stations, {pins} pins");
            is_closed(&wheel, &name);
            is_closed(&driver, &name);
            // A chord takes from or adds to the area less than its length times the tolerance.
            let length = |face: &Face| -> f64 {
                let around = |of: &Loop| {
                    let corners = of.corners(1e-3).unwrap();
                    let next = corners.iter().cycle().skip(1);
                    corners.iter().zip(next).map(|(a, b)| (b - a).norm()).sum::<f64>()
                };
                face.loops().map(around).sum()
            };
            let room = |face: &Face| length(face) * solid.tolerance * solid.thickness;
            let volume = outline.wheel.area() * solid.thickness;
            assert!((wheel.volume() - volume).abs() < room(&outline.wheel), "{name}: {} {volume}", wheel.volume());
            let pin = PI * sizes.pin_radius() * sizes.pin_radius() * f64::from(pins);
            let above = outline.disc.as_ref().map_or(0.0, Face::area) + pin;
            let volume = outline.plate.area() * solid.thickness + above * (solid.thickness + sizes.play.slot);
            let rooms = 3.0 * room(&outline.plate) + 3.0 * outline.disc.as_ref().map_or(0.0, room);
            assert!((driver.volume() - volume).abs() < rooms, "{name}: {} {volume}", driver.volume());
            // With finer chords the volume comes to that of the arcs.
            let fine = wheel_mesh(&sizes, Solid { tolerance: 1e-4, ..solid }).unwrap().volume();
            approx::assert_relative_eq!(fine, outline.wheel.area() * solid.thickness, max_relative = 1e-5);
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
    fn a_mesh_without_thickness_is_refused() {
        for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let of = |thickness, tolerance| wheel_mesh(&sizes(6, 1), Solid { thickness, tolerance });
            assert!(matches!(of(wrong, 0.1), Err(KinematicsError::Length { name: "thickness", .. })));
            assert!(matches!(of(1.0, wrong), Err(KinematicsError::Length { name: "chord tolerance", .. })));
        }
    }
}
