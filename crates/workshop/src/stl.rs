//! Both parts as a mesh for a printer, in the format STL.
//!
//! In its form of text, whose numbers have as many digits as are needed.

use crate::mesh::{Mesh, Solid, driver_mesh, wheel_mesh};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::Sizes;
use nalgebra::Vector3;
use std::fmt::Write;

/// Both parts side by side on the printer's bed, as two solids.
///
/// # Errors
///
/// [`KinematicsError::Length`] for a thickness or a tolerance that is not positive and finite.
pub fn stl(sizes: &Sizes, solid: Solid) -> Result<String, KinematicsError> {
    let beside = sizes.tip_radius + sizes.pin_diameter + sizes.plate_radius;
    let mut text = String::new();
    write(&mut text, "wheel", &wheel_mesh(sizes, solid)?);
    write(&mut text, "driver", &driver_mesh(sizes, solid)?.translate(beside));
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
    use geneva_kinematics::wheel::{Choices, Scale, Wheel};
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
            let solid = Solid { thickness: 8.0, tolerance: 0.1 * sizes.play.slot };
            let text = stl(&sizes, solid).unwrap();
            let solids = read(&text);
            assert_eq!(solids.len(), 2);
            let meshes = [wheel_mesh(&sizes, solid).unwrap(), driver_mesh(&sizes, solid).unwrap()];
            for (triangles, mesh) in solids.iter().zip(meshes) {
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
                approx::assert_relative_eq!(volume, mesh.volume(), max_relative = 1e-5);
            }
        }
    }
}
