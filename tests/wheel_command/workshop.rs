//! Does `geneva wheel` write the same files as the workshop, and does it say what they need?

use crate::{assert_is_drawn, object, refused, stdout};
use geneva_figures::stations::dimensions;
use geneva_kinematics::wheel::as_built::{Process, ProcessNumbers};
use geneva_kinematics::wheel::{Choices, Mouth, Play, Scale, Sizes, Wheel};
use geneva_workshop::{Mounting, Part, PartLayout, dxf, parts, scad, stl};

const WHEEL: [&str; 9] =
    ["wheel", "--stations", "5", "--centre-distance", "80", "--pin-diameter", "6", "--play", "0.1"];

/// With shafts and a horn of one's own too.
fn chosen() -> Sizes {
    let choices = Choices {
        pin_diameter: Some(6.0),
        play: Some(Play::from_slot(0.1)),
        bottom_clearance: Some(0.2),
        horn_thickness: Some(7.5),
        locking_arc_radius: None,
        mouth: Mouth::Sharp,
        wheel_shaft: Some(12.0),
        driver_shaft: Some(5.0),
        plate_shaft: None,
    };
    Sizes::new(Wheel::new(5).expect("possible"), Scale::CentreDistance(80.0), &choices).expect("it fits")
}

fn sizes() -> Sizes {
    let choices = Choices { pin_diameter: Some(6.0), play: Some(Play::from_slot(0.1)), ..Choices::default() };
    Sizes::new(Wheel::new(5).expect("possible"), Scale::CentreDistance(80.0), &choices).expect("it fits")
}

fn bare(sizes: &Sizes) -> Vec<Part> {
    parts(sizes, 4.0, &Mounting::default()).expect("bare parts").parts
}

#[test]
fn the_files_are_those_of_the_workshop() {
    let file = |options: &[&str]| stdout(&[&WHEEL[..], options].concat(), 0);
    assert_eq!(file(&["--format", "dxf"]), dxf(&bare(&sizes()), PartLayout::Apart));
    let own = ["--horn", "7.5", "--wheel-shaft", "12", "--driver-shaft", "5", "--bottom-clearance", "0.2"];
    assert_eq!(file(&[&own[..], &["--format", "dxf"]].concat()), dxf(&bare(&chosen()), PartLayout::Apart));
    // A tenth of the play is what a chord may leave its arc by.
    let tolerance = 0.1 * 0.1;
    let model = scad(&sizes(), 4.0, tolerance, &Mounting::default(), 0.0).expect("a model");
    assert_eq!(file(&["--format", "scad", "--thickness", "4"]), model);
    assert_eq!(file(&["--format", "stl", "--thickness", "4"]), stl(&bare(&sizes()), tolerance).expect("solids"));
    let tight = [&WHEEL[..7], &["--play", "0", "--format", "stl", "--thickness", "4"]].concat();
    assert!(stdout(&tight, 0).len() > 1000);
}

/// The names after a line of the output that begins so, up to the next line that is not indented.
fn listed(text: &str, after: &str) -> Vec<String> {
    let lines = text.lines().skip_while(|line| !line.starts_with(after)).skip(1);
    lines.take_while(|line| line.starts_with("  ")).map(|line| line.trim().to_owned()).collect()
}

#[test]
fn an_internal_wheel_gets_every_file_of_an_external_one_and_what_is_lacking_of_others_is_said() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = |name: &str, options: &[&str]| {
        let path = folder.path().join(name);
        let asked = path.to_str().expect("UTF-8");
        let text = stdout(&[&["wheel", "--stations", "6", "--out", asked][..], options].concat(), 0);
        let mut found: Vec<String> = std::fs::read_dir(&path)
            .expect("a folder")
            .map(|file| file.expect("a file").file_name().to_string_lossy().into_owned())
            .collect();
        let mut told = listed(&text, "Written to");
        found.sort_unstable();
        told.sort_unstable();
        assert_eq!(found, told, "{name}");
        (found, listed(&text, "Not written"), text)
    };
    let sized = ["--crank-radius", "40", "--thickness", "6"];
    let (external, none, _) = out("external", &sized);
    assert!(none.is_empty());
    let internal = [&sized[..], &["--type", "internal", "--process", "mill", "--locking-play", "0.3"]].concat();
    let (all, none, _) = out("internal", &internal);
    assert!(none.is_empty());
    assert_eq!(all, external);
    let read = |name: &str| std::fs::read_to_string(folder.path().join("internal").join(name)).expect("a text");
    let sheets = read("drawings.html");
    for words in ["Internal Geneva wheel, 6 stations", ">Ring plate<", "Process mill: it holds", "Locking segment"] {
        assert!(sheets.contains(words), "{words}");
    }
    // The plays that were asked for and those of the process are in the files.
    let model = read("wheel.scad");
    let numbers = ProcessNumbers::new(Process::Mill, 80.0).expect("a length");
    for line in ["locking_play = 0.3;".to_owned(), format!("axial_play = {};", numbers.axial_play.value)] {
        assert!(model.contains(&line), "{line}: {model}");
    }
    for (name, options, why) in [
        (
            "spherical",
            &["--type", "spherical", "--crank-radius", "40"][..],
            "parts of a spherical wheel are not worked out",
        ),
        ("unsized", &["--type", "internal"], "--crank-radius MM and --thickness MM"),
        ("flat", &["--type", "internal", "--crank-radius", "40"], "the thickness of the wheel: add --thickness MM"),
    ] {
        let (_, missing, text) = out(name, options);
        assert!(text.contains(why), "{text}");
        assert_eq!(missing.len(), 10, "{missing:?}");
        assert!(missing.iter().all(|file| external.contains(file)), "{missing:?}");
    }
}

#[test]
fn an_internal_wheels_own_inertia_is_that_of_its_drawn_parts_and_a_wheel_without_parts_says_that_it_is_missing() {
    let asked = ["wheel", "--stations", "6", "--type", "internal", "--inertia", "0.002", "--rpm", "60"];
    let sized = object(&[&asked[..], &["--crank-radius", "40", "--thickness", "6"]].concat());
    let own = sized["wheel_inertia_kgm2"].as_f64().expect("a number");
    // The plate is whole, and the ring is without what is inside its inner line.
    let wheel = geneva_kinematics::internal_wheel::InternalWheel::new(6).expect("a wheel");
    let sizes = geneva_kinematics::internal_sizes::InternalSizes::new(wheel, 40.0, &Default::default()).expect("sizes");
    let plate = std::f64::consts::PI * sizes.outside_radius.powi(4) / 2.0;
    let ring = plate - second_moment_of_the_hollow(&sizes);
    approx::assert_relative_eq!(own, (plate + ring) * 6.0 * 7800.0 * 1e-15, max_relative = 1e-4);
    approx::assert_relative_eq!(sized["inertia_kgm2"].as_f64().expect("a number"), own + 0.002, max_relative = 1e-12);
    for without in
        [&asked[..], &["wheel", "--stations", "6", "--type", "spherical", "--inertia", "0.002", "--rpm", "60"]]
    {
        assert!(stdout(without, 0).contains("own is not in it"), "{without:?}");
    }
}

/// The polar second moment of what is missing of the ring, from points of its inner line.
fn second_moment_of_the_hollow(sizes: &geneva_kinematics::internal_sizes::InternalSizes) -> f64 {
    let points = sizes.outline().ring.holes[0].corners(1e-4).expect("a tolerance");
    let triangles = points.iter().zip(points.iter().cycle().skip(1));
    triangles.map(|(p, q)| (p.x * q.y - q.x * p.y) * (p.dot(p) + p.dot(q) + q.dot(q)) / 12.0).sum::<f64>().abs()
}

#[test]
fn a_sized_wheel_is_drawn_in_true_size_with_dimensions() {
    assert_is_drawn(&WHEEL, &dimensions(&sizes()));
    let svg = stdout(&[&WHEEL[..], &["--format", "svg"]].concat(), 0);
    let drawn = roxmltree::Document::parse(&svg).expect("XML");
    assert!(drawn.root_element().attribute("width").is_some_and(|width| width.ends_with("mm")), "{drawn:?}");
}

#[test]
fn a_file_goes_where_it_is_asked_for() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("wheel.dxf");
    let asked = path.to_str().expect("UTF-8");
    assert_eq!(stdout(&[&WHEEL[..], &["--format", "dxf", "--output", asked]].concat(), 0), "");
    assert_eq!(std::fs::read_to_string(path).expect("written"), dxf(&bare(&sizes()), PartLayout::Apart));
}

#[test]
fn what_a_file_needs_is_said() {
    let sized = ["--crank-radius", "50"];
    for (options, said) in [
        (&["--format", "dxf"][..], "--crank-radius MM"),
        (&["--format", "stl", "--thickness", "5"], "--crank-radius MM"),
        (&["--format", "dxf", "--type", "internal"], "--crank-radius MM"),
        (&["--format", "scad", "--type", "internal"], "--crank-radius MM"),
        (&["--format", "scad", "--type", "internal", "--crank-radius", "50"], "--thickness MM"),
        (&["--format", "scad", "--type", "spherical"], "spherical wheels"),
        (&[&["--format", "dxf", "--type", "spherical", "--rpm", "6"][..], &sized].concat(), "spherical wheels"),
    ] {
        let told = refused(&[&["wheel", "--stations", "6"], options].concat());
        assert!(told.starts_with("error: ") && told.contains(said), "{options:?}: {told}");
    }
}
