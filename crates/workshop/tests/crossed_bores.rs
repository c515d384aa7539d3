//! Are solids closed, in one piece and as large as their parts, whatever bores they have? A bore of the plate may cross the outline
//! of the disc that stands on it, or the bore of that disc.

use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::as_built::SplitMix64;
use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
use geneva_workshop::{
    Layer, Mesh, Mounting, MountingError, Part, ShaftFit, internal_parts, meshes, parts, stl, validate_solids,
};
use std::collections::{BTreeMap, HashMap};
use std::f64::consts::PI;

const THICKNESS: f64 = 6.0;

/// How many pieces a surface has, by corners that are the same in a file's single precision. Each edge is in two triangles, which run
/// along it in opposite senses.
#[track_caller]
fn pieces(mesh: &Mesh, name: &str) -> usize {
    let mut numbers: HashMap<[u32; 3], usize> = HashMap::new();
    let mut parents: Vec<usize> = Vec::new();
    let mut edges: HashMap<(usize, usize), u32> = HashMap::new();
    let root = |parents: &mut Vec<usize>, mut at: usize| {
        while parents[at] != at {
            parents[at] = parents[parents[at]];
            at = parents[at];
        }
        at
    };
    for triangle in &mesh.triangles {
        let corners = triangle.map(|p| {
            let next = numbers.len();
            let number = *numbers.entry([p.x, p.y, p.z].map(|x| (x as f32 + 0.0).to_bits())).or_insert(next);
            if number == parents.len() {
                parents.push(number);
            }
            number
        });
        for k in 0..3 {
            let (from, to) = (corners[k], corners[(k + 1) % 3]);
            assert_ne!(from, to, "{name}");
            *edges.entry((from, to)).or_default() += 1;
            let (a, b) = (root(&mut parents, from), root(&mut parents, to));
            parents[a] = b;
        }
    }
    for ((from, to), count) in &edges {
        assert_eq!((*count, edges.get(&(*to, *from))), (1, Some(&1)), "{name}");
    }
    (0..parents.len()).filter(|at| parents[*at] == *at).count()
}

/// Wheel and driver are each one closed piece, and as large as their parts, of which pins in one piece with the plate fill their holes.
#[track_caller]
fn check(list: &[Part], pin_radius: f64, name: &str) {
    let all = meshes(list, 0.02).expect(name);
    let mut volume = 0.0;
    for (of, mesh) in &all {
        assert_eq!(pieces(mesh, &format!("{name}: {of}")), 1, "{name}: {of}");
        volume += mesh.volume();
    }
    let pins =
        list.iter().filter(|part| part.layer == Layer::Pins && part.is_joined).map(Part::quantity).sum::<usize>();
    let drawn: f64 = list.iter().map(|part| part.volume() * part.quantity() as f64).sum();
    let drawn = drawn + PI * pin_radius * pin_radius * THICKNESS * pins as f64;
    approx::assert_relative_eq!(volume, drawn, max_relative = 4e-3);
    assert!(stl(list, 0.02).is_ok());
}

fn external(
    stations: u32,
    pins: u32,
    crank: f64,
    [wheel, driver, plate]: [f64; 3],
    mounting: &Mounting,
) -> Option<(Vec<Part>, f64)> {
    let given = |shaft: f64| Some(shaft).filter(|shaft| *shaft > 0.0);
    let choices = Choices {
        wheel_shaft: given(wheel),
        driver_shaft: given(driver),
        plate_shaft: given(plate),
        ..Choices::default()
    };
    let sizes = Sizes::new(Wheel::with_pins(stations, pins).ok()?, Scale::CrankRadius(crank), &choices).ok()?;
    Some((parts(&sizes, THICKNESS, mounting).ok()?.parts, sizes.pin_radius()))
}

fn internal(stations: u32, crank: f64, plate: f64, mounting: &Mounting) -> Option<(Vec<Part>, f64)> {
    let choices = Choices { plate_shaft: Some(plate), wheel_shaft: Some(8.0), ..Choices::default() };
    let sizes = InternalSizes::new(InternalWheel::new(stations).ok()?, crank, &choices).ok()?;
    Some((internal_parts(&sizes, THICKNESS, mounting).ok()?.parts, sizes.pin_radius()))
}

#[test]
fn a_plate_whose_bore_crosses_the_crescent_is_one_closed_solid_with_its_disc() {
    let bare = Mounting::default();
    for (stations, pins, shafts) in [
        (6, 1, [0.0, 0.0, 16.7]),
        (6, 1, [0.0, 0.0, 16.8]),
        (6, 1, [0.0, 0.0, 20.0]),
        (12, 1, [0.0, 0.0, 10.0]),
        (6, 1, [0.0, 10.0, 20.0]),
        (4, 2, [0.0, 0.0, 30.0]),
        (3, 1, [0.0, 0.0, 45.0]),
    ] {
        let (list, pin) = external(stations, pins, 40.0, shafts, &bare).expect("possible");
        check(&list, pin, &format!("{stations} stations, {pins} pins, {shafts:?}"));
    }
    // A wall of the disc that is thinner than the chords leave their arcs.
    let thin = Mounting { driver_fit: ShaftFit::Flat { across: 13.287_84 }, ..bare };
    let (list, pin) = external(7, 1, 40.0, [8.0, 14.288, 14.478_316_16], &thin).expect("possible");
    check(&list, pin, "a thin wall");
    let (list, pin) = internal(6, 40.0, 60.0, &bare).expect("possible");
    check(&list, pin, "internal");
}

#[test]
fn bores_of_all_kinds_leave_closed_solids_in_one_piece_or_are_refused() {
    let mut random = SplitMix64::new(11);
    let mut part = |of: f64| (random.next_u64() % 1000) as f64 / 1000.0 * of;
    let mut found: BTreeMap<&str, u32> = BTreeMap::new();
    for _ in 0..100 {
        let (stations, pins) = (3 + part(12.0) as u32, 1 + part(2.5) as u32);
        let kind = part(4.0) as u32;
        let plate = 4.0 + part(64.0);
        let driver = if kind == 0 { 0.0 } else { part(plate.min(16.0)) };
        let fit = match kind {
            1 => ShaftFit::Key,
            2 => ShaftFit::Flat { across: 0.93 * driver.max(8.0) },
            _ => ShaftFit::Round,
        };
        // A flat has its size from the opposite side on both shafts.
        let plate = if kind == 2 { driver.max(8.0) * (1.0 + part(0.06)) } else { plate };
        let driver = if kind == 2 { driver.max(8.0) } else { driver };
        let mounting = Mounting { driver_fit: fit, ..Mounting::default() };
        let name = format!("{stations} stations, {pins} pins, {fit:?}, {driver} and {plate}");
        let is_internal = part(5.0) < 1.0;
        let made = if is_internal {
            internal(stations, 40.0, plate, &mounting)
        } else {
            external(stations, pins, 40.0, [8.0, driver, plate], &mounting)
        };
        let Some((list, pin)) = made else { continue };
        match validate_solids(&list) {
            Ok(()) => check(&list, pin, &name),
            Err(MountingError::Floating { width, .. }) => {
                assert!(plate > 0.98 * width, "{name}: {width}");
                *found.entry("floating").or_default() += 1;
            }
            Err(other) => panic!("{name}: {other}"),
        }
        *found
            .entry(if is_internal { "internal" } else { ["without", "key", "flat", "round"][kind as usize] })
            .or_default() += 1;
    }
    assert!(found.len() == 6 && found.values().all(|count| *count > 1), "{found:?}");
}
