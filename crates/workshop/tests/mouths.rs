//! Do the files have the mouths of the slots? Edges of the DXF are followed around, the mesh is measured by its triangles, and
//! OpenSCAD, if it is there, makes a solid of its own.

use geneva_kinematics::wheel::{Choices, Mouth, Scale, Sizes, Wheel};
use geneva_workshop::{Mounting, Part, PartLayout, dxf, meshes, parts, scad};
use std::collections::BTreeMap;
use std::process::Command;

const MOUTHS: [Mouth; 4] = [
    Mouth::Sharp,
    Mouth::Chamfer { width: 2.0, angle: 0.4 },
    Mouth::Round { radius: 1.5 },
    Mouth::LeadIn { length: 5.0, flare: 0.6 },
];

const THICKNESS: f64 = 6.0;
const TOLERANCE: f64 = 0.005;

fn list(sizes: &Sizes) -> Vec<Part> {
    parts(sizes, THICKNESS, &Mounting::default()).expect("bare parts").parts
}

fn sizes(mouth: Mouth) -> Sizes {
    let choices = Choices { mouth, ..Choices::default() };
    Sizes::new(Wheel::new(6).expect("possible"), Scale::CrankRadius(25.0), &choices).expect("fits")
}

/// The entities of a layer, each with its numbers by their group codes.
fn entities(file: &str, layer: &str) -> Vec<(String, BTreeMap<u16, f64>)> {
    let lines: Vec<&str> = file.lines().map(str::trim).collect();
    let mut all: Vec<(String, String, BTreeMap<u16, f64>)> = Vec::new();
    for pair in lines.chunks(2) {
        let (code, value) = (pair[0].parse::<u16>().expect("a code"), pair[1]);
        match (code, all.last_mut()) {
            (0, _) => all.push((value.to_owned(), String::new(), BTreeMap::new())),
            (8, Some(of)) => of.1 = value.to_owned(),
            (10..=51, Some(of)) => {
                of.2.insert(code, value.parse().expect("a number"));
            }
            _ => {}
        }
    }
    let is_drawn = |kind: &str| ["LINE", "ARC"].contains(&kind);
    all.into_iter().filter(|(kind, on, _)| is_drawn(kind) && on == layer).map(|(kind, _, of)| (kind, of)).collect()
}

#[test]
fn the_edges_of_the_wheel_in_a_drawing_close() {
    for (mouth, lines, arcs) in MOUTHS.iter().zip([(2, 4), (4, 4), (2, 6), (2, 6)]).map(|(of, (l, a))| (*of, l, a)) {
        let drawn = entities(&dxf(&list(&sizes(mouth)), PartLayout::Assembled), "WHEEL");
        let count = |name: &str| drawn.iter().filter(|(kind, _)| kind == name).count();
        assert_eq!([count("LINE"), count("ARC")], [6 * lines, 6 * arcs], "{mouth:?}");
        let ends: Vec<[f64; 2]> = drawn
            .iter()
            .flat_map(|(kind, of)| {
                let [x, y] = [of[&10], of[&20]];
                if kind == "LINE" {
                    return [[x, y], [of[&11], of[&21]]];
                }
                [50, 51].map(|end| {
                    let (sin, cos) = of[&end].to_radians().sin_cos();
                    [x + of[&40] * cos, y + of[&40] * sin]
                })
            })
            .collect();
        for [x, y] in &ends {
            let here = ends.iter().filter(|[u, v]| (u - x).hypot(v - y) < 1e-9).count();
            assert_eq!(here, 2, "{mouth:?}: {here} edges end at {x} {y}");
        }
    }
}

/// Volume of a text of triangles, in cubic millimetres.
fn volume(stl: &str) -> f64 {
    let corner = |line: &str| -> Option<Vec<f64>> {
        let numbers = line.trim().strip_prefix("vertex ")?;
        Some(numbers.split_whitespace().map(|number| number.parse().expect("a number")).collect())
    };
    let corners: Vec<Vec<f64>> = stl.lines().filter_map(corner).collect();
    let of = |t: &[Vec<f64>]| {
        let [a, b, c] = [&t[0], &t[1], &t[2]];
        let across = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
        (a[0] * across[0] + a[1] * across[1] + a[2] * across[2]) / 6.0
    };
    corners.chunks_exact(3).map(of).sum()
}

#[test]
fn meshes_and_models_have_the_volume_of_the_outline() {
    let mut is_missing = false;
    for mouth in MOUTHS {
        let sizes = sizes(mouth);
        let right = sizes.outline().wheel.area() * THICKNESS;
        let mesh = meshes(&list(&sizes), TOLERANCE).expect("meshes")[0].1.volume();
        approx::assert_relative_eq!(mesh, right, max_relative = 2e-4);
        let folder = std::env::temp_dir().join(format!("geneva-mouth-{}-{right:.3}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let [model, solid] = ["wheel.scad", "wheel.stl"].map(|name| folder.join(name));
        std::fs::write(&model, scad(&sizes, THICKNESS, TOLERANCE, &Mounting::default(), 0.0).expect("a model"))
            .expect("written");
        let run = Command::new("openscad").arg("-o").arg(&solid).args(["-D", "part=\"wheel\""]).arg(&model).output();
        match run {
            Ok(run) => {
                let said = String::from_utf8_lossy(&run.stderr);
                assert!(run.status.success() && !said.contains("WARNING"), "{mouth:?}: {said}");
                let made = volume(&std::fs::read_to_string(&solid).expect("a solid"));
                approx::assert_relative_eq!(made, right, max_relative = 2e-4);
            }
            Err(_) => is_missing = true,
        }
        std::fs::remove_dir_all(&folder).expect("removed");
    }
    if is_missing {
        println!("skipped: openscad is not on the PATH, so no model was made into a solid");
    }
}
