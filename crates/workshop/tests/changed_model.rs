//! Does a model whose variables are changed either refuse itself or still run? OpenSCAD itself runs it, and says what wheel and
//! driver have in common at moments of a turn. Without OpenSCAD on the path these tests say that they are skipped.

use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::{Choices, Edge, Face, Mouth, Scale, Sizes, Wheel};
use geneva_workshop::{
    Drawing, Fastener, HolePurpose, Layer, Mounting, Part, PartLayout, Pattern, PinMount, ScrewHole, ShaftFit, Thread,
    dxf, internal_parts, internal_scad, meshes, parts, scad,
};
use nalgebra::Vector2;
use std::path::PathBuf;
use std::process::Command;

/// What OpenSCAD says of a model.
#[derive(Debug, PartialEq)]
enum Said {
    /// An assertion refused it, with these words.
    Refused(String),
    /// Wheel and driver have nothing in common at any moment.
    Runs,
    /// They have this in common, as a file of the format SVG.
    Overlaps(String),
}

fn has_openscad() -> bool {
    let is_there = Command::new("openscad").arg("--version").output().is_ok_and(|output| output.status.success());
    if !is_there {
        assert!(std::env::var_os("OPENSCAD_REQUIRED").is_none(), "OpenSCAD is required, and not on the path");
        println!("skipped: there is no openscad on the path");
    }
    is_there
}

fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("writable");
    folder
}

/// Runs a model with some variables changed.
fn run(name: &str, text: &str, changed: &[(&str, f64)], show: &str, output: &str) -> (bool, String, Option<String>) {
    let folder = folder(name);
    let (model, result) = (folder.join("model.scad"), folder.join(output));
    std::fs::write(&model, text).expect("writable");
    let _ = std::fs::remove_file(&result);
    let mut command = Command::new("openscad");
    command.arg("-o").arg(&result).arg("-D").arg(format!("part=\"{show}\""));
    for (name, value) in changed {
        command.arg("-D").arg(format!("{name}={value}"));
    }
    let run = command.arg(&model).output().expect("it runs");
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    (run.status.success(), said, std::fs::read_to_string(result).ok())
}

/// A square beside the parts, so that a result without it is none.
const BESIDE: &str = "\nif (part == \"overlap\") translate([1e5, 0]) square(1);\n";

fn overlap(name: &str, text: &str, changed: &[(&str, f64)]) -> Said {
    let (is_done, said, result) = run(name, &format!("{text}{BESIDE}"), changed, "overlap", "overlap.svg");
    if let Some(at) = said.find("ERROR: Assertion") {
        return Said::Refused(said[at..].lines().next().unwrap_or_default().to_owned());
    }
    let result = result.unwrap_or_default();
    assert!(is_done && result.contains("100001,-1"), "{said}");
    // Each closed line begins with this letter.
    if result.matches("M ").count() == 1 { Said::Runs } else { Said::Overlaps(result) }
}

fn sizes(stations: u32, pins: u32, choices: &Choices) -> Sizes {
    Sizes::new(Wheel::with_pins(stations, pins).expect("possible"), Scale::CrankRadius(60.0), choices)
        .expect("possible")
}

/// With shafts for key and flat.
fn shafts() -> Choices {
    Choices { wheel_shaft: Some(6.0), plate_shaft: Some(8.0), ..Choices::default() }
}

fn mounting(sizes: &Sizes) -> Mounting {
    let fastener = Fastener::Screw(Thread::M3, ScrewHole::NutTrap);
    Mounting {
        wheel_fit: ShaftFit::Key,
        driver_fit: ShaftFit::Flat { across: 7.0 },
        wheel_hub: Some(Pattern { count: 3, circle: 1.3 * (sizes.slot_end - sizes.slot_width / 2.0), fastener }),
        pins: PinMount::Screw(Thread::M3, ScrewHole::Clearance),
        ..Mounting::default()
    }
}

fn variables(text: &str) -> Vec<(String, f64)> {
    let before = text.split("/* [Hidden] */").next().expect("possible");
    let lines = before.lines().filter_map(|line| line.split_once(" = "));
    lines.filter_map(|(name, rest)| Some((name.to_owned(), rest.split(';').next()?.parse().ok()?))).collect()
}

#[test]
fn a_model_that_is_not_changed_runs_and_has_the_crescent_of_the_sizes() {
    if !has_openscad() {
        return;
    }
    for (stations, pins) in [(3, 1), (4, 1), (4, 4), (5, 2), (6, 1), (8, 2), (12, 1), (24, 1), (60, 1)] {
        let sizes = sizes(stations, pins, &Choices::default());
        let bare = scad(&sizes, 6.0, 0.1 * sizes.play.slot, &Mounting::default(), 0.0).unwrap();
        let text =
            bare.clone() + "\necho(cut = [crescent_centre, crescent_radius, locking_disc_radius, plate_radius]);\n";
        assert_eq!(overlap("unchanged", &bare, &[]), Said::Runs, "{stations} stations, {pins} pins");
        let (_, said, _) = run("unchanged", &text, &[], "overlap", "overlap.svg");
        let cut = said.split("cut = [").nth(1).and_then(|rest| rest.split(']').next()).expect("what it echoes");
        let cut: Vec<f64> = cut.split(", ").map(|number| number.parse().expect("a number")).collect();
        let disc =
            sizes.locking_disc.map_or([0.0; 3], |disc| [disc.crescent.centre, disc.crescent.radius, disc.radius]);
        for (theirs, ours) in cut.iter().zip(disc.into_iter().chain([sizes.plate_radius])) {
            // OpenSCAD echoes six digits.
            assert!((theirs - ours).abs() <= 2e-5 * ours.max(1.0), "{stations} stations: {cut:?} {disc:?}");
        }
    }
}

#[test]
fn a_model_with_mouths_runs_too() {
    if !has_openscad() {
        return;
    }
    for mouth in [Mouth::Chamfer { width: 2.0, angle: 0.4 }, Mouth::Round { radius: 2.0 }] {
        let sizes = sizes(6, 1, &Choices { mouth, ..Choices::default() });
        let text = scad(&sizes, 6.0, 0.1 * sizes.play.slot, &Mounting::default(), 0.0).unwrap();
        assert_eq!(overlap("mouths", &text, &[]), Said::Runs, "{mouth:?}");
        let (is_done, said, result) = run("mouths", &text, &[], "wheel", "part.stl");
        assert!(is_done, "{said}");
        let area = sizes.outline().wheel.area();
        approx::assert_relative_eq!(volume(&result.unwrap()), 6.0 * area, max_relative = 1e-3);
    }
}

/// Changes each variable of a model, the numbers of stations and pins to other whole numbers and the others by a fifth, and counts
/// how often it runs and refuses itself.
fn change_each(name: &str, text: &str) -> [u32; 2] {
    let (mut runs, mut refuses) = (0, 0);
    for (variable, value) in variables(text) {
        let others = match variable.as_str() {
            "stations" => vec![3.0, 5.0, 8.0, 12.0],
            "pins" => vec![1.0, 2.0, 3.0, 4.0],
            _ if value == 0.0 => continue,
            _ => vec![0.8 * value, 1.2 * value],
        };
        for other in others.into_iter().filter(|other| *other != value) {
            match overlap(name, text, &[(&variable, other)]) {
                Said::Runs => runs += 1,
                Said::Refused(why) => {
                    assert!(why.contains("make ") || why.contains("must be") || why.contains("change "), "{why}");
                    refuses += 1;
                }
                Said::Overlaps(what) => panic!("{name}, {variable} = {other}: {what}"),
            }
        }
    }
    println!("{name}: {runs} run, {refuses} refuse themselves");
    [runs, refuses]
}

#[test]
fn a_model_with_a_changed_variable_refuses_itself_or_runs() {
    if !has_openscad() {
        return;
    }
    let counts = [(4, 1), (6, 2)].map(|(stations, pins)| {
        let sizes = sizes(stations, pins, &shafts());
        change_each("changed", &scad(&sizes, 6.0, 0.1 * sizes.play.slot, &mounting(&sizes), 0.0).unwrap())
    });
    let [runs, refuses] = [0, 1].map(|k| counts[0][k] + counts[1][k]);
    assert!(runs > 40 && refuses > 0, "{runs} run, {refuses} refuse themselves");
}

fn internal(stations: u32, choices: &Choices) -> InternalSizes {
    InternalSizes::new(InternalWheel::new(stations).expect("possible"), 60.0, choices).expect("possible")
}

/// An internal wheel with shafts and holes of all kinds.
fn mounted_internal() -> (InternalSizes, Mounting) {
    let sizes = internal(6, &Choices { wheel_shaft: Some(10.0), plate_shaft: Some(12.0), ..Choices::default() });
    let fastener = Fastener::Screw(Thread::M3, ScrewHole::NutTrap);
    let mounting = Mounting {
        wheel_fit: ShaftFit::Key,
        driver_fit: ShaftFit::Flat { across: 11.0 },
        wheel_hub: Some(Pattern { count: 3, circle: 30.0, fastener }),
        disc_dowels: Some(Pattern { count: 6, circle: 2.0 * sizes.slot_end, fastener: Fastener::Dowel(4.0) }),
        pins: PinMount::Dowel,
        ..Mounting::default()
    };
    (sizes, mounting)
}

#[test]
fn an_internal_model_runs_and_with_a_changed_variable_it_refuses_itself_or_runs_too() {
    if !has_openscad() {
        return;
    }
    for stations in [3, 4, 5, 8, 24] {
        let sizes = internal(stations, &Choices::default());
        let text = internal_scad(&sizes, 6.0, 0.1 * sizes.play.slot, &Mounting::default(), 0.0).unwrap();
        assert_eq!(overlap("internal", &text, &[]), Said::Runs, "{stations} stations");
        // A segment a little too thick is found.
        let wrong = text.replace("solid(segment_outer)", "solid(segment_outer + locking_play)");
        assert_ne!(wrong, text);
        assert!(matches!(overlap("internal-wrong", &wrong, &[]), Said::Overlaps(_)), "{stations} stations");
    }
    let bare = internal(4, &Choices::default());
    let bare = internal_scad(&bare, 6.0, 0.1 * bare.play.slot, &Mounting::default(), 0.0).unwrap();
    let (sizes, mounting) = mounted_internal();
    let mounted = internal_scad(&sizes, 6.0, 0.1 * sizes.play.slot, &mounting, 0.0).unwrap();
    let counts = [change_each("internal-bare", &bare), change_each("internal-mounted", &mounted)];
    let [runs, refuses] = [0, 1].map(|k| counts[0][k] + counts[1][k]);
    assert!(runs > 30 && refuses > 0, "{runs} run, {refuses} refuse themselves");
}

/// The model without what it shows, so that a line can show something else.
fn shown_nothing(text: &str) -> &str {
    text.split("\nif (part == \"ring\")").next().expect("a model")
}

/// Distance of a point from an edge.
fn from_edge(edge: &Edge, p: Vector2<f64>) -> f64 {
    match *edge {
        Edge::Line { from, to } => {
            let along = to - from;
            let share = ((p - from).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
            (p - from - along * share).norm()
        }
        Edge::Arc { centre, radius, start, sweep } => {
            let from = p - centre;
            let (begin, length) = if sweep < 0.0 { (start + sweep, -sweep) } else { (start, sweep) };
            if (from.y.atan2(from.x) - begin).rem_euclid(std::f64::consts::TAU) <= length {
                (from.norm() - radius).abs()
            } else {
                (p - edge.start_point()).norm().min((p - edge.end_point()).norm())
            }
        }
    }
}

/// The corners of all closed lines in an SVG of OpenSCAD, whose second axis points down, the area between them and their length.
fn corners_and_area(svg: &str) -> (Vec<Vector2<f64>>, f64, f64) {
    let path = svg.split(" d=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("a path");
    let (mut all, mut twice, mut length) = (Vec::new(), 0.0, 0.0);
    for line in path.split('M').skip(1) {
        let corners: Vec<Vector2<f64>> = line
            .split(|c: char| c == 'L' || c == 'z' || c.is_whitespace())
            .filter(|word| !word.is_empty())
            .map(|word| word.split_once(',').expect("two numbers"))
            .map(|(x, y)| Vector2::new(x.parse().expect("a number"), -y.parse::<f64>().expect("a number")))
            .collect();
        for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            twice += a.perp(b);
            length += (b - a).norm();
        }
        all.extend(corners);
    }
    (all, twice.abs() / 2.0, length)
}

#[test]
fn the_outlines_of_an_internal_model_are_those_of_the_dxf() {
    if !has_openscad() {
        return;
    }
    for (stations, mounting) in [(3, Mounting::default()), (6, mounted_internal().1), (12, Mounting::default())] {
        let sizes = if stations == 6 { mounted_internal().0 } else { internal(stations, &Choices::default()) };
        let list = internal_parts(&sizes, 6.0, &mounting).unwrap().parts;
        let drawing = Drawing::read(&dxf(&list, PartLayout::Assembled)).unwrap();
        let text = internal_scad(&sizes, 6.0, 0.002, &mounting, 0.0).unwrap();
        let at_driver = "translate([centre_distance, 0]) rotate(180)";
        for (layer, line) in [
            (Layer::Wheel, "rotate(turn(180)) ring_outline();".to_owned()),
            (Layer::LockingSegment, format!("{at_driver} segment_outline();")),
        ] {
            let model = format!("{}\n{line}\n", shown_nothing(&text));
            let (is_done, said, result) = run("internal-outline", &model, &[], "none", "outline.svg");
            assert!(is_done, "{said}");
            let (corners, area, length) = corners_and_area(&result.unwrap());
            let on: Vec<&Edge> =
                drawing.edges.iter().filter(|drawn| drawn.layer == layer.name()).map(|drawn| &drawn.edge).collect();
            for corner in &corners {
                let far = on.iter().map(|edge| from_edge(edge, *corner)).fold(f64::INFINITY, f64::min);
                assert!(
                    far < 0.004,
                    "{stations} stations, {layer:?}: {corner} is {far} mm from each edge of the drawing"
                );
            }
            // And back: no edge of the drawing is missing.
            for edge in on {
                let far =
                    corners.iter().map(|corner| (edge.start_point() - corner).norm()).fold(f64::INFINITY, f64::min);
                assert!(far < 2.0, "{stations} stations, {layer:?}: {edge:?} has no corner near its start");
            }
            let part = list.iter().find(|part| part.layer == layer).unwrap();
            // A chord leaves its arc by 0.002 mm at most.
            assert!((area - part.face().area()).abs() < 0.002 * length, "{stations} stations, {layer:?}: {area}");
        }
    }
}

#[test]
fn the_solids_of_an_internal_model_are_as_large_as_the_parts() {
    if !has_openscad() {
        return;
    }
    let (sizes, mounting) = mounted_internal();
    for (sizes, mounting) in [(sizes, mounting), (internal(4, &Choices::default()), Mounting::default())] {
        let text = internal_scad(&sizes, 6.0, 0.002, &mounting, 0.0).unwrap();
        let list = internal_parts(&sizes, 6.0, &mounting).unwrap().parts;
        let volume_of = |layer| list.iter().find(|part| part.layer == layer).unwrap().volume();
        let pin = volume_of(Layer::Pins);
        let is_solid = mounting.pins == PinMount::Solid;
        // In one piece the pin fills its hole in the plate.
        let filled = if is_solid { pin + std::f64::consts::PI * sizes.pin_radius().powi(2) * 6.0 } else { 0.0 };
        let driver = volume_of(Layer::Plate) + volume_of(Layer::LockingSegment) + filled;
        for (show, ours) in
            [("ring", volume_of(Layer::Wheel)), ("ring_plate", volume_of(Layer::RingPlate)), ("driver", driver)]
        {
            let (is_done, said, result) = run("internal-solids", &text, &[], show, "part.stl");
            assert!(is_done, "{said}");
            approx::assert_relative_eq!(volume(&result.unwrap()), ours, max_relative = 1e-3);
        }
    }
}

/// The volume of the solid of this name in the mesh of a list of parts, in mm³.
fn mesh_volume(list: &[Part], name: &str, tolerance: f64) -> f64 {
    let all = meshes(list, tolerance).expect("meshes");
    all.iter().find(|(of, _)| *of == name).unwrap_or_else(|| panic!("no {name}")).1.volume()
}

/// A bore of the plate that crosses the disc's outline or the disc's own bore, keyways, and internal wheels.
#[test]
fn solids_of_models_with_bores_that_cross_and_with_keyways_are_those_of_the_meshes() {
    if !has_openscad() {
        return;
    }
    const COARSE: f64 = 0.05;
    let key = Mounting { driver_fit: ShaftFit::Key, ..Mounting::default() };
    let given = |shaft: f64| Some(shaft).filter(|shaft| *shaft > 0.0);
    let compare = |name: &str, text: &str, solids: &[(&str, f64)]| {
        for (show, ours) in solids {
            let (is_done, said, result) = run("crossing", text, &[], show, "part.stl");
            assert!(is_done && !said.contains("WARNING"), "{name}: {said}");
            approx::assert_relative_eq!(volume(&result.unwrap()), *ours, max_relative = 2e-3);
        }
    };
    for (stations, driver, plate, mounting) in [
        (6, 0.0, 27.0, &Mounting::default()),
        (6, 15.0, 30.0, &Mounting::default()),
        (3, 0.0, 66.0, &Mounting::default()),
        (6, 12.0, 16.0, &key),
    ] {
        let choices = Choices {
            driver_shaft: given(driver),
            plate_shaft: given(plate),
            wheel_shaft: Some(5.0),
            ..Choices::default()
        };
        let sizes = sizes(stations, 1, &choices);
        let list = parts(&sizes, 6.0, mounting).unwrap().parts;
        let text = scad(&sizes, 6.0, COARSE, mounting, 0.0).unwrap();
        let solids = ["wheel", "driver"].map(|name| (name, mesh_volume(&list, name, COARSE)));
        compare(&format!("{stations} stations, {driver} and {plate}"), &text, &solids);
    }
    for (plate, mounting) in [(90.0, &Mounting::default()), (20.0, &key)] {
        let sizes = internal(6, &Choices { plate_shaft: Some(plate), wheel_shaft: Some(5.0), ..Choices::default() });
        let list = internal_parts(&sizes, 6.0, mounting).unwrap().parts;
        let text = internal_scad(&sizes, 6.0, COARSE, mounting, 0.0).unwrap();
        let solids = [("ring", "wheel"), ("driver", "driver")];
        let solids = solids.map(|(show, name)| (show, mesh_volume(&list, name, COARSE)));
        compare(&format!("internal, {plate}"), &text, &solids);
    }
}

#[test]
fn an_overlap_would_be_found() {
    if !has_openscad() {
        return;
    }
    let sizes = sizes(8, 1, &Choices::default());
    let text = scad(&sizes, 6.0, 0.1 * sizes.play.slot, &Mounting::default(), 0.0).unwrap();
    // A crescent a little too shallow.
    let wrong = text.replace("crescent_centre = has_dwell ? ", "crescent_centre = has_dwell ? 1.2 * ");
    assert_ne!(wrong, text);
    let said = overlap("wrong", &wrong, &[]);
    assert!(matches!(&said, Said::Overlaps(_)), "{said:?}");
}

/// The volume inside a file of the format STL, as text.
fn volume(text: &str) -> f64 {
    let numbers = text.lines().filter_map(|line| line.trim().strip_prefix("vertex "));
    let corners: Vec<[f64; 3]> = numbers
        .map(|line| {
            let of: Vec<f64> = line.split(' ').map(|number| number.parse().expect("a number")).collect();
            [of[0], of[1], of[2]]
        })
        .collect();
    let six = corners.chunks(3).map(|t| {
        let [a, b, c] = [t[0], t[1], t[2]];
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
    });
    six.sum::<f64>() / 6.0
}

#[test]
fn the_solids_of_openscad_are_as_large_as_the_parts() {
    if !has_openscad() {
        return;
    }
    for (stations, pins) in [(4, 1), (6, 2)] {
        let sizes = sizes(stations, pins, &shafts());
        let mounting = mounting(&sizes);
        let text = scad(&sizes, 6.0, 0.002, &mounting, 0.0).unwrap();
        let list = parts(&sizes, 6.0, &mounting).unwrap().parts;
        let (bushes, driver): (Vec<_>, Vec<_>) = list[1..].iter().partition(|part| part.is_bush());
        let driver: f64 = driver.iter().map(|part| part.volume()).sum();
        let bush = bushes[0];
        let pins = bush.volume() * bush.quantity() as f64;
        for (show, ours) in [("wheel", list[0].volume()), ("driver", driver), ("pin", pins)] {
            let (is_done, said, result) = run("solids", &text, &[], show, "part.stl");
            assert!(is_done, "{said}");
            approx::assert_relative_eq!(volume(&result.unwrap()), ours, max_relative = 1e-3);
        }
    }
}

/// A bore with a keyway, a flat, or neither, and the hole and the pocket of a nut are as the parts have them, with and without an allowance
/// for a machine that makes holes too narrow.
#[test]
fn the_holes_of_a_model_are_as_large_as_those_of_the_parts_with_and_without_an_allowance() {
    if !has_openscad() {
        return;
    }
    let sizes = sizes(6, 2, &shafts());
    let mounting = mounting(&sizes);
    let list = parts(&sizes, 6.0, &mounting).unwrap().parts;
    let text = scad(&sizes, 6.0, 0.0005, &mounting, 0.2).unwrap();
    assert!(text.contains("\nhole_allowance = 0.2; // "));
    let hole_of = |layer: Layer, purpose: HolePurpose, by: f64| {
        let part = list.iter().find(|part| part.layer == layer).unwrap().clone().with_wider_holes(by);
        part.holes.into_iter().find(|hole| hole.purpose == purpose).unwrap()
    };
    for (layer, purpose, line) in [
        (Layer::Wheel, HolePurpose::Bore, "bore(wheel_bore, wheel_key, wheel_flat, wheel_key_direction);"),
        (Layer::Plate, HolePurpose::Bore, "bore(plate_bore, driver_key, driver_flat, driver_key_direction);"),
        (Layer::Wheel, HolePurpose::Hub, "hole(wheel_holes[0][2]);"),
        (Layer::Wheel, HolePurpose::Hub, "projection() nut_pocket(wheel_holes[0][3], 1);"),
        (Layer::Plate, HolePurpose::PinScrew, "hole(pin_hole);"),
    ] {
        for by in [0.0, 0.2] {
            let hole = hole_of(layer, purpose, by);
            let outline = hole.widening.filter(|_| line.contains("pocket")).map_or(hole.outline, |wide| wide.outline);
            let face = Face { outer: outline, holes: Vec::new() };
            let modules = text.split("\nif (part == ").next().unwrap();
            let model = format!("{modules}\n{line}\n");
            let (is_done, said, result) = run("holes", &model, &[("hole_allowance", by)], "none", "outline.svg");
            assert!(is_done, "{said}");
            let (_, area, length) = corners_and_area(&result.unwrap());
            assert!((area - face.area().abs()).abs() < 0.001 * length, "{line} {by}: {area} and {}", face.area());
        }
    }
}

/// The mouth of the text, point by point, is the face of the outline.
#[test]
fn a_model_has_the_mouths_of_the_outline() {
    for mouth in [
        Mouth::Chamfer { width: 2.0, angle: 0.4 },
        Mouth::Round { radius: 1.5 },
        Mouth::LeadIn { length: 5.0, flare: 0.6 },
    ] {
        let wheel = Wheel::new(6).expect("possible");
        let sizes =
            Sizes::new(wheel, Scale::CrankRadius(25.0), &Choices { mouth, ..Choices::default() }).expect("fits");
        let text = scad(&sizes, 6.0, 0.001, &Mounting::default(), 0.0).expect("a model");
        let list = text.lines().find_map(|line| line.strip_prefix("mouth = [")?.strip_suffix("];")).expect("a mouth");
        let points: Vec<[f64; 2]> = list
            .trim_matches(['[', ']'])
            .split("], [")
            .map(|point| point.split_once(", ").expect("two numbers"))
            .map(|(x, y)| [x.parse::<f64>().expect("a number"), y.parse::<f64>().expect("a number")])
            .collect();
        let half = sizes.slot_width / 2.0;
        let placed: Vec<[f64; 2]> = points.iter().map(|[x, y]| [x + sizes.wheel_radius, y + half]).collect();
        // It begins on the wall and ends on the rim; between, it is on the face.
        assert!(points[0][1].abs() < 1e-12, "{mouth:?}: {points:?}");
        let end = placed.last().expect("points");
        approx::assert_relative_eq!(end[0].hypot(end[1]), sizes.tip_radius, max_relative = 1e-12);
        let outline = sizes.outline().wheel.outer.corners(0.001).expect("corners");
        for [x, y] in &placed {
            let nearest = outline.iter().map(|p| (p.x - x).hypot(p.y - y)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-9, "{mouth:?}: {x} {y} is {nearest} mm from a corner of the outline");
        }
    }
    let sharp = sizes(6, 1, &Choices::default());
    assert!(scad(&sharp, 6.0, 0.01, &Mounting::default(), 0.0).expect("a model").contains("\nmouth = [];\n"));
}
