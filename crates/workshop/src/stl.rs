//! All parts as meshes for a printer, in the format STL.
//!
//! In its form of text, whose numbers have as many digits as are needed.

use crate::mesh::{Mesh, meshes};
use crate::parts::{MountingError, Part};
use nalgebra::Vector3;
use std::fmt::Write;

/// All solids side by side on the printer's bed, in millimetres; chords leave their arcs by the tolerance at most.
///
/// # Errors
///
/// As for [`meshes`].
pub fn stl(parts: &[Part], tolerance: f64) -> Result<String, MountingError> {
    let mut text = String::new();
    meshes(parts, tolerance)?.iter().for_each(|(name, mesh)| write(&mut text, name, mesh));
    Ok(text)
}

fn write(text: &mut String, name: &str, mesh: &Mesh) {
    let numbers = |v: &Vector3<f64>| {
        // Readers keep single precision; no zero has a sign.
        let [x, y, z] = [v.x, v.y, v.z].map(|x| x as f32 + 0.0);
        format!("{x} {y} {z}")
    };
    // Writing to a string cannot fail.
    let _ = writeln!(text, "solid {name}");
    for [a, b, c] in &mesh.triangles {
        let normal = (b - a).cross(&(c - a)).normalize();
        let _ = writeln!(text, "facet normal {}\nouter loop", numbers(&normal));
        for corner in [a, b, c] {
            let _ = writeln!(text, "vertex {}", numbers(corner));
        }
        let _ = writeln!(text, "endloop\nendfacet");
    }
    let _ = writeln!(text, "endsolid {name}");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::{Mounting, parts};
    use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    use std::collections::HashMap;

    /// A triangle as text and as numbers, and its normal.
    type Read = ([String; 3], [Vector3<f64>; 3], Vector3<f64>);

    /// The triangles of each solid of a file.
    fn read(text: &str) -> Vec<Vec<Read>> {
        let mut solids = Vec::new();
        let numbers = |text: &str| {
            let of: Vec<f64> = text.split(' ').map(|number| number.parse().unwrap()).collect();
            Vector3::new(of[0], of[1], of[2])
        };
        let (mut normal, mut corners) = (Vector3::zeros(), Vec::new());
        for line in text.lines() {
            if line.starts_with("solid ") {
                solids.push(Vec::new());
            } else if let Some(of) = line.strip_prefix("facet normal ") {
                normal = numbers(of);
            } else if let Some(of) = line.strip_prefix("vertex ") {
                corners.push(of.to_owned());
            } else if line == "endfacet" {
                let texts: [String; 3] = std::mem::take(&mut corners).try_into().unwrap();
                let points = [0, 1, 2].map(|k: usize| numbers(&texts[k]));
                solids.last_mut().unwrap().push((texts, points, normal));
            }
        }
        solids
    }

    #[test]
    fn what_is_read_back_is_closed_and_turned_outwards() {
        let counts = (3..=9).flat_map(|stations| (1..=6).map(move |pins| (stations, pins))).chain([(12, 2), (60, 1)]);
        for (stations, pins) in counts {
            let Ok(wheel) = Wheel::with_pins(stations, pins) else { continue };
            // With this crank a wheel of five stations and three pins has three corners in one line.
            let sizes = Sizes::new(wheel, Scale::CrankRadius(40.0), &Choices::default()).unwrap();
            let parts = parts(&sizes, 8.0, &Mounting::default()).unwrap().parts;
            let tolerance = 0.1 * sizes.play.slot;
            let solids = read(&stl(&parts, tolerance).unwrap());
            assert_eq!(solids.len(), 2);
            for (triangles, (_, mesh)) in solids.iter().zip(meshes(&parts, tolerance).unwrap()) {
                assert_eq!(triangles.len(), mesh.triangles.len());
                let mut edges: HashMap<(&str, &str), i32> = HashMap::new();
                let mut volume = 0.0;
                for ([a, b, c], [p, q, r], normal) in triangles {
                    for (from, to) in [(a, b), (b, c), (c, a)] {
                        assert_ne!(from, to);
                        *edges.entry((from, to)).or_default() += 1;
                    }
                    volume += p.dot(&q.cross(r)) / 6.0;
                    assert!((normal.norm() - 1.0).abs() < 1e-6);
                }
                for ((from, to), count) in &edges {
                    assert_eq!((*count, edges.get(&(*to, *from))), (1, Some(&1)), "{stations} stations, {pins} pins");
                }
                approx::assert_relative_eq!(volume, mesh.volume(), max_relative = 1e-4);
            }
        }
    }
}
