//! Is every thin wall of wheel, locking disc and plate among those that get a warning?
//!
//! The least thickness is looked for point by point: between any two edges of a face that do not meet, with material midway.

use super::assembly::{Point, is_inside, points, sized};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Choices, Edge, Face, Play, Sizes, Warning};

/// Two edges that have an end in common, or are one.
fn meet(one: &Edge, other: &Edge) -> bool {
    let ends = |edge: &Edge| [edge.start_point(), edge.end_point()];
    ends(one).iter().any(|a| ends(other).iter().any(|b| (a - b).norm() < 1e-9))
}

/// The least thickness of a face, seen from the edges of one station or of one pin.
fn least(face: &Face, repeats: usize) -> f64 {
    let loops: Vec<Vec<Point>> = face.loops().map(|of| of.corners(1e-3).unwrap()).collect();
    let is_material = |p: &Point| loops.iter().filter(|corners| is_inside(corners, p)).count() == 1;
    let edges: Vec<&Edge> = face.loops().flat_map(|of| &of.edges).collect();
    let seen: Vec<Vec<Point>> = edges.iter().map(|edge| points(&[**edge])).collect();
    let outer = face.outer.edges.len();
    let mut least = f64::INFINITY;
    for (i, edge) in edges.iter().enumerate().filter(|(i, _)| *i < outer / repeats || *i >= outer) {
        for (_, there) in edges.iter().zip(&seen).filter(|(other, _)| !meet(edge, other)) {
            for (a, b) in seen[i].iter().flat_map(|a| there.iter().map(move |b| (a, b))) {
                let distance = (a - b).norm();
                if distance < least && is_material(&((a + b) / 2.0)) {
                    least = distance;
                }
            }
        }
    }
    least
}

/// The least thickness of wheel, disc and plate as it is seen; the plate has a hole for each pin.
fn seen(sizes: &Sizes) -> [Option<f64>; 3] {
    let outline = sizes.outline();
    let (stations, pins) = (sizes.wheel.stations() as usize, sizes.wheel.pins() as usize);
    let mut plate = outline.plate;
    plate.holes.extend(outline.pins);
    let disc = outline.disc.map(|disc| least(&disc, pins));
    [Some(least(&outline.wheel, stations)), disc.filter(|least| least.is_finite()), Some(least(&plate, 1))]
}

fn pin(diameter: f64) -> Choices {
    Choices { pin_diameter: Some(diameter), play: Some(Play::from_slot(0.06)), ..Choices::default() }
}

#[test]
fn the_least_thickness_of_each_part_is_that_of_a_wall_which_is_checked() {
    // Axes 100 mm apart: a wheel with each wall as the thin one, and wheels without a thin wall.
    for (stations, pins, choices, thin) in [
        (6, 1, Choices { horn_thickness: Some(2.0), ..pin(15.0) }, Some("the horn")),
        (
            4,
            1,
            Choices { bottom_clearance: Some(13.0), wheel_shaft: Some(1.0), ..pin(20.0) },
            Some("the web between two slots"),
        ),
        (
            6,
            1,
            Choices { bottom_clearance: Some(3.0), wheel_shaft: Some(83.0), ..pin(8.0) },
            Some("the web at the bore"),
        ),
        (8, 1, Choices { driver_shaft: Some(9.5), ..pin(12.0) }, Some("the locking disc between crescent and bore")),
        (5, 3, Choices { horn_thickness: Some(25.0), ..pin(24.0) }, Some("the locking disc between two crescents")),
        (24, 2, pin(3.3), Some("the locking disc between two crescents")),
        (3, 1, Choices { bottom_clearance: Some(0.1), ..pin(15.2) }, Some("the plate outside the pin")),
        (6, 1, Choices { plate_shaft: Some(88.0), ..pin(10.0) }, Some("the plate between pin and bore")),
        (6, 1, Choices::default(), None),
        (6, 2, Choices::default(), None),
        (4, 3, Choices::default(), None),
        (3, 5, Choices::default(), None),
        (12, 1, Choices::default(), None),
    ] {
        let sizes = sized(stations, pins, &choices);
        let name = format!("{stations} stations, {pins} pins");
        let [wheel, disc, plate] = seen(&sizes);
        let of_disc = [sizes.disc_web(), sizes.crescent_web()].into_iter().flatten().reduce(f64::min);
        let of_bore = if sizes.wheel_bore() > 0.0 { sizes.bore_web() } else { f64::INFINITY };
        let of_wheel = sizes.horn_thickness.min(sizes.web).min(of_bore);
        let is_seen = |seen: f64, said: f64| seen > said - 1e-9 && seen < 1.03 * said.hypot(0.25);
        assert!(is_seen(wheel.unwrap(), of_wheel), "{name}: {wheel:?} seen, {of_wheel} said");
        assert_eq!(disc.is_some(), of_disc.is_some(), "{name}");
        assert!(disc.zip(of_disc).is_none_or(|(seen, said)| is_seen(seen, said)), "{name}: {disc:?}, {of_disc:?}");
        let of_plate = sizes.plate_web().map_or(sizes.plate_rim(), |web| web.min(sizes.plate_rim()));
        assert!(plate.unwrap() > of_plate - 1e-9, "{name}: {plate:?}, {of_plate} said");
        let walls: Vec<&str> = sizes
            .warnings()
            .iter()
            .filter_map(|of| if let Warning::ThinWall { wall, .. } = of { Some(*wall) } else { None })
            .collect();
        assert_eq!(walls, thin.into_iter().collect::<Vec<_>>(), "{name}");
        let all = [wheel, disc, plate].into_iter().flatten().fold(f64::INFINITY, f64::min);
        assert!(thin.is_some() || all > sizes.pin_diameter / 5.0, "{name}: {all} without a warning");
    }
}
