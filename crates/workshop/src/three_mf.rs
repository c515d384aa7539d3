//! All parts as meshes for a printer, in the format 3MF: an archive of XML, with names, units and places.
//!
//! 3MF Core Specification 1.2: a relationship leads to the model, in which each object is a mesh of vertices and triangles, and
//! the build says where each stands on the printer's bed.

use crate::mesh::{Mesh, meshes};
use crate::parts::{MountingError, Part, allowance_words};
use std::collections::HashMap;
use std::fmt::Write as _;
use std::io::{Cursor, Write as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

const TYPES: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"#;

const RELATIONSHIPS: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="model" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"#;

/// All solids side by side on the printer's bed, in millimetres; chords leave their arcs by the tolerance at most.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Mounting, parts, three_mf};
///
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
/// let list = parts(&sizes, 5.0, &Mounting::default()).expect("bare parts");
/// let file = three_mf(&list.parts, 0.01).expect("a file");
/// assert!(file.starts_with(b"PK")); // an archive
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
///
/// # Errors
///
/// As for [`meshes`], and [`MountingError::Archive`] for more than an archive can hold.
pub fn three_mf(parts: &[Part], tolerance: f64) -> Result<Vec<u8>, MountingError> {
    let model = model(&meshes(parts, tolerance)?, allowance_words(parts).as_deref());
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    // Without a date, so that the same parts give the same file.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default());
    for (name, text) in [("[Content_Types].xml", TYPES), ("_rels/.rels", RELATIONSHIPS), ("3D/3dmodel.model", &model)] {
        archive.start_file(name, options).map_err(|error| MountingError::Archive(error.to_string()))?;
        archive.write_all(text.as_bytes()).map_err(|error| MountingError::Archive(error.to_string()))?;
    }
    let file = archive.finish().map_err(|error| MountingError::Archive(error.to_string()))?;
    Ok(file.into_inner())
}

/// The model: what is said of it, an object for each solid, and where it is built.
fn model(solids: &[(&'static str, Mesh)], description: Option<&str>) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-GB\" \
         xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n",
    );
    if let Some(words) = description {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "<metadata name=\"Description\">{words}</metadata>");
    }
    text += "<resources>\n";
    for (id, (name, mesh)) in (1..).zip(solids) {
        object(&mut text, id, name, mesh);
    }
    text += "</resources>\n<build>\n";
    for (id, _) in (1..).zip(solids) {
        let _ = writeln!(text, "<item objectid=\"{id}\"/>");
    }
    text + "</build>\n</model>\n"
}

fn object(text: &mut String, id: u32, name: &str, mesh: &Mesh) {
    let _ = writeln!(text, "<object id=\"{id}\" type=\"model\" name=\"{name}\"><mesh>\n<vertices>");
    // Readers keep single precision; corners of several triangles are written once.
    let mut numbers: HashMap<[u32; 3], usize> = HashMap::new();
    let mut triangles = String::new();
    for triangle in &mesh.triangles {
        let corners = [&triangle[0], &triangle[1], &triangle[2]].map(|corner| {
            let at = [corner.x, corner.y, corner.z].map(|x| x as f32 + 0.0);
            let next = numbers.len();
            *numbers.entry(at.map(f32::to_bits)).or_insert_with(|| {
                let _ = writeln!(text, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>", at[0], at[1], at[2]);
                next
            })
        });
        let [a, b, c] = corners;
        let _ = writeln!(triangles, "<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\"/>");
    }
    let _ = writeln!(text, "</vertices>\n<triangles>\n{triangles}</triangles>\n</mesh></object>");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parts::{Mounting, parts};
    use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    use nalgebra::Vector3;
    use roxmltree::{Document, Node};
    use std::io::Read;
    use zip::ZipArchive;

    /// The texts of the archive's files.
    fn files(archive: Vec<u8>) -> HashMap<String, String> {
        let mut archive = ZipArchive::new(Cursor::new(archive)).unwrap();
        let names: Vec<String> = archive.file_names().map(str::to_owned).collect();
        let mut text = |name: &str| {
            let mut text = String::new();
            archive.by_name(name).unwrap().read_to_string(&mut text).unwrap();
            text
        };
        names.into_iter().map(|name| (name.clone(), text(&name))).collect()
    }

    fn named<'t>(node: Node<'t, 't>, name: &'static str) -> impl Iterator<Item = Node<'t, 't>> {
        node.descendants().filter(move |node| node.has_tag_name(name))
    }

    #[test]
    fn what_is_read_back_is_closed_and_as_large_as_the_meshes() {
        for (stations, pins, is_stacked) in [(3, 1, false), (4, 4, false), (6, 2, true), (24, 1, false)] {
            let wheel = Wheel::with_pins(stations, pins).unwrap();
            let sizes = Sizes::new(wheel, Scale::CrankRadius(40.0), &Choices::default()).unwrap();
            let list = parts(&sizes, 8.0, &Mounting { is_stacked, ..Mounting::default() }).unwrap().parts;
            let files = files(three_mf(&list, 0.005).unwrap());
            assert_eq!(files.len(), 3);
            let relations = Document::parse(&files["_rels/.rels"]).unwrap();
            let target = named(relations.root(), "Relationship").next().unwrap().attribute("Target").unwrap();
            let path = target.strip_prefix('/').unwrap();
            let types = Document::parse(&files["[Content_Types].xml"]).unwrap();
            let known = named(types.root(), "Default").filter_map(|of| of.attribute("Extension"));
            assert!(known.into_iter().any(|extension| path.ends_with(extension)));

            let model = Document::parse(&files[path]).unwrap();
            let root = model.root_element();
            assert_eq!((root.tag_name().name(), root.attribute("unit")), ("model", Some("millimeter")));
            let expected = meshes(&list, 0.005).unwrap();
            let objects: Vec<Node> = named(root, "object").collect();
            let built: Vec<_> = named(root, "item").filter_map(|item| item.attribute("objectid")).collect();
            assert_eq!(built, objects.iter().filter_map(|of| of.attribute("id")).collect::<Vec<_>>());
            assert_eq!(objects.len(), expected.len());
            for (object, (name, mesh)) in objects.into_iter().zip(&expected) {
                assert_eq!(object.attribute("name"), Some(*name));
                let number = |node: Node, name| node.attribute(name).unwrap().parse::<f64>().unwrap();
                let corners: Vec<_> = named(object, "vertex")
                    .map(|of| Vector3::new(number(of, "x"), number(of, "y"), number(of, "z")))
                    .collect();
                let mut edges: HashMap<(usize, usize), i32> = HashMap::new();
                let mut volume = 0.0;
                for triangle in named(object, "triangle") {
                    let [a, b, c] = ["v1", "v2", "v3"].map(|name| number(triangle, name) as usize);
                    for edge in [(a, b), (b, c), (c, a)] {
                        assert_ne!(edge.0, edge.1);
                        *edges.entry(edge).or_default() += 1;
                    }
                    volume += corners[a].dot(&corners[b].cross(&corners[c])) / 6.0;
                }
                for ((from, to), count) in &edges {
                    assert_eq!((*count, edges.get(&(*to, *from))), (1, Some(&1)), "{name}");
                }
                approx::assert_relative_eq!(volume, mesh.volume(), max_relative = 1e-5);
            }
        }
    }

    #[test]
    fn the_same_parts_give_the_same_file() {
        let sizes = Sizes::new(Wheel::new(5).unwrap(), Scale::CrankRadius(40.0), &Choices::default()).unwrap();
        let list = parts(&sizes, 8.0, &Mounting::default()).unwrap().parts;
        assert_eq!(three_mf(&list, 0.01).unwrap(), three_mf(&list, 0.01).unwrap());
    }
}
