//! Tests of what the sheets say besides sizes: what a process holds, one story with the solids, the list of parts.

use super::*;
use crate::body::bodies;
use crate::dxf_reader::Drawing;
use crate::parts::{
    BasePlate, Fastener, Layer, Mounting, MountingError, Part, Pattern, PinMount, ScrewHole, Thread, parts,
};
use crate::{LayerNames, PartLayout, dxf};
use geneva_kinematics::wheel::as_built::{MeasuredSize, Process, ProcessNumbers};
use geneva_kinematics::wheel::{Choices, Edge, Play, Scale, Sizes, Wheel};
use std::f64::consts::PI;

const STEEL: SheetMaterial<'static> = SheetMaterial { name: "steel", hardness: Some("58 HRC") };
const PLA: SheetMaterial<'static> = SheetMaterial { name: "pla", hardness: None };

fn sizes(stations: u32, pins: u32, pin: Option<f64>, play: Option<Play>) -> Sizes {
    let choices =
        Choices { pin_diameter: pin, play, wheel_shaft: Some(5.0), driver_shaft: Some(5.0), ..Choices::default() };
    Sizes::new(Wheel::with_pins(stations, pins).unwrap(), Scale::CrankRadius(40.0), &choices).unwrap()
}

fn drawn(sizes: &Sizes, mounting: &Mounting, limits: &SheetLimits, material: SheetMaterial<'static>) -> Vec<Sheet> {
    let text =
        SheetText { project: "Turret", wheel_material: material, driver_material: material, pin_material: material };
    sheets(sizes, 6.0, mounting, limits, &text).unwrap()
}

/// A wheel with the plays of a process, as it is drawn for that.
fn made_by(process: Process, stations: u32) -> (Vec<Sheet>, ProcessNumbers) {
    let numbers = ProcessNumbers::new(process, sizes(stations, 1, None, None).centre_distance).unwrap();
    let sizes = sizes(stations, 1, None, Some(numbers.play()));
    let limits = SheetLimits { shared: sizes.shared_tolerance(), process: Some(numbers), yield_share: Some(0.98765) };
    let stacked = Mounting {
        is_stacked: process == Process::Laser,
        base: Some(BasePlate { screws: Some(Thread::M4), ..BasePlate::default() }),
        ..Mounting::default()
    };
    (drawn(&sizes, &stacked, &limits, PLA), numbers)
}

fn texts(sheet: &Sheet) -> impl Iterator<Item = &str> {
    sheet.ink.texts.iter().map(|text| text.text.as_str())
}

/// All texts of a sheet in one, as notes go on in the next line.
fn all_text(sheet: &Sheet) -> String {
    texts(sheet).collect::<Vec<_>>().join(" ")
}

#[test]
fn no_limit_on_a_sheet_is_less_than_the_process_holds() {
    let mut beyond = 0;
    for process in Process::ALL {
        for stations in [4, 6, 9] {
            let (sheets, numbers) = made_by(process, stations);
            let error = numbers.error.value;
            for size in sheets.iter().flat_map(|sheet| &sheet.dimensions) {
                let Some([lower, upper]) = size.limits else { continue };
                let is_radius = matches!(size.measured, Measured::LockingArc | Measured::Crescent);
                let least = if is_radius { error } else { 2.0 * error };
                assert!(upper - lower > least - 1e-9, "{process:?} {stations}: {size:?}, but the error is {error}");
                assert!(lower <= 0.0 || size.measured == Measured::Crescent, "{size:?}");
                beyond += usize::from(size.origin == LimitOrigin::ProcessBeyondChain);
            }
            for sheet in &sheets {
                let text = all_text(sheet);
                let is_metal = matches!(process, Process::Ground | Process::Mill);
                let may_be_rough = sheet.layer.is_none() || sheet.layer == Some(Layer::BasePlate);
                assert!(may_be_rough || text.contains("Ra ") == is_metal, "{process:?}: {text}");
                assert!(!text.contains("fit the parts together"), "{text}");
                // What is marked is explained, and only that.
                let marks = texts(sheet).filter(|text| *text == "‡").count();
                assert_eq!(text.contains("expect 98.7 % of assemblies to turn"), marks > 0, "{process:?}: {text}");
                assert!(text.contains(&format!("Process {}: it holds ±", process.name())), "{text}");
                assert!(!text.contains("Hardness"), "{text}");
            }
        }
    }
    assert!(beyond > 50, "{beyond}");
}

#[test]
fn every_mark_on_a_sheet_is_explained_on_it() {
    let mut marked = 0;
    for process in [None].into_iter().chain(Process::ALL.map(Some)) {
        for (stations, is_known) in [(4, true), (6, true), (6, false), (9, false)] {
            let sizes = sizes(stations, 1, None, None);
            let numbers = process.map(|process| ProcessNumbers::new(process, sizes.centre_distance).unwrap());
            let shared = if is_known { sizes.shared_tolerance() } else { None };
            let limits = SheetLimits { shared, process: numbers, yield_share: Some(0.987) };
            let mounting = Mounting { base: Some(BasePlate::default()), is_stacked: true, ..Mounting::default() };
            for sheet in drawn(&sizes, &mounting, &limits, STEEL) {
                for mark in ["†", "‡"] {
                    let is_used = texts(&sheet).any(|text| text == mark);
                    let is_explained = texts(&sheet).any(|text| text.contains(mark) && text != mark);
                    assert_eq!(is_used, is_explained, "{process:?} {stations} {is_known} {mark}: {}", all_text(&sheet));
                    marked += usize::from(is_used);
                }
            }
        }
    }
    assert!(marked > 20, "{marked}");
}

#[test]
fn hardness_is_asked_of_metals() {
    let sheets = drawn(&sizes(6, 1, None, None), &Mounting::default(), &SheetLimits::default(), STEEL);
    assert!(sheets[1..].iter().all(|sheet| all_text(sheet).contains("Hardness 58 HRC")));
}

#[test]
fn the_sheets_have_the_pieces_that_the_solids_have() {
    let sizes = sizes(6, 2, None, None);
    let dowels = Some(Pattern { count: 2, circle: 22.0, fastener: Fastener::Dowel(2.0) });
    for (mounting, pieces) in [
        (Mounting::default(), 2),
        (Mounting { pins: PinMount::Dowel, ..Mounting::default() }, 3),
        (Mounting { pins: PinMount::Screw(Thread::M3, ScrewHole::Tapped), ..Mounting::default() }, 3),
        (Mounting { is_stacked: true, ..Mounting::default() }, 4),
        (Mounting { disc_dowels: dowels, base: Some(BasePlate::default()), ..Mounting::default() }, 5),
    ] {
        let list = parts(&sizes, 6.0, &mounting).unwrap().parts;
        let solids = bodies(&list).unwrap();
        assert_eq!(solids.len(), pieces);
        let sheets = drawn(&sizes, &mounting, &SheetLimits::default(), STEEL);
        // The list on the first sheet numbers just the solids.
        let numbers: Vec<String> = (1..=pieces + 1).map(|k| format!("{k}  ")).collect();
        let is_listed = |number: &String| texts(&sheets[0]).any(|text| text.starts_with(number.as_str()));
        assert!(numbers[..pieces].iter().all(is_listed) && !is_listed(&numbers[pieces]));
        let of = |layer| sheets.iter().find(|sheet| sheet.layer == Some(layer));
        let length = |layer, what| {
            let mut found = of(layer).unwrap().dimensions.iter().filter(|size| size.measured == what);
            found.next().map(|size| size.nominal)
        };
        let is_one_piece = !mounting.disc_is_apart();
        for layer in [Layer::Plate, Layer::LockingDisc] {
            assert_eq!(all_text(of(layer).unwrap()).contains("in one piece with"), is_one_piece);
        }
        if !is_one_piece {
            continue;
        }
        let driver = solids.iter().find(|solid| solid.name == "driver").unwrap();
        let heights = driver.caps.iter().map(|cap| cap.height);
        let tall = heights.clone().fold(0.0, f64::max);
        let sheet = [Layer::Plate, Layer::LockingDisc].map(|layer| length(layer, Measured::Thickness).unwrap());
        approx::assert_relative_eq!(sheet[0] + sheet[1], tall, max_relative = 1e-12);
        let is_solid = mounting.pins == PinMount::Solid;
        assert_eq!(of(Layer::Pins).is_none(), is_solid);
        assert!(!all_text(of(Layer::Plate).unwrap()).contains("P7"), "no pressed pin of what is one piece");
        if is_solid {
            assert_eq!(length(Layer::Plate, Measured::PinHole), None);
            let above = length(Layer::Plate, Measured::PinLength).unwrap();
            approx::assert_relative_eq!(sheet[0] + above, tall, max_relative = 1e-12);
        }
    }
}

#[test]
fn a_bush_is_a_part_of_every_file() {
    for (hole, in_plate) in [(ScrewHole::Clearance, 3.4), (ScrewHole::Tapped, 2.5), (ScrewHole::NutTrap, 3.4)] {
        let sizes = sizes(4, 1, Some(6.0), None);
        let mounting =
            Mounting { pins: PinMount::Screw(Thread::M3, hole), axial_play: Some(0.3), ..Mounting::default() };
        let list = parts(&sizes, 6.0, &mounting).unwrap().parts;
        let bush = list.iter().find(|part| part.is_bush()).unwrap();
        // From the plate to as far above the wheel: 6 mm and twice the play.
        approx::assert_relative_eq!(bush.volume(), PI / 4.0 * (6.0 * 6.0 - 3.4 * 3.4) * 6.6, max_relative = 1e-12);
        assert_eq!((bush.places[0].bottom, bush.quantity(), bush.words()), (-0.3, 1, "bush"));
        assert!(bodies(&list).unwrap().iter().any(|solid| solid.name == "bush"));
        let sheets = drawn(&sizes, &mounting, &SheetLimits::default(), STEEL);
        let sheet = sheets.iter().find(|sheet| sheet.layer == Some(Layer::Pins)).unwrap();
        let of = |what| sheet.dimensions.iter().find(|size| size.measured == what).unwrap();
        assert_eq!(
            [Measured::Pin, Measured::PinHole, Measured::PinLength].map(|what| of(what).nominal),
            [6.0, 3.4, 6.6]
        );
        assert!(of(Measured::PinLength).limits.unwrap()[0] >= 0.0, "the head must not hold the wheel");
        for layout in [PartLayout::Apart, PartLayout::Assembled] {
            let drawing = Drawing::read(&dxf(&list, layout)).unwrap();
            let circles = |layer: Layer| -> Vec<f64> {
                let on = drawing.edges.iter().filter(|drawn| drawn.layer == layer.name());
                let circle = on.filter_map(|drawn| match drawn.edge {
                    Edge::Arc { radius, sweep, .. } if sweep.abs() > 1.999 * PI => Some(2.0 * radius),
                    _ => None,
                });
                circle.collect()
            };
            assert_eq!(circles(Layer::Pins), [6.0], "{layout:?}");
            assert!(circles(Layer::Plate).contains(&in_plate), "{layout:?}");
            let measured = drawing.measure(&LayerNames::default(), 0.01).unwrap().measured;
            let pin = measured.sizes().iter().find(|found| found.size == MeasuredSize::PinDiameter).unwrap();
            approx::assert_relative_eq!(pin.value, 6.0, max_relative = 1e-9);
        }
    }
}

#[test]
fn a_screw_is_the_pin_itself_or_leaves_a_wall_to_its_bush() {
    let mounting = Mounting { pins: PinMount::Screw(Thread::M4, ScrewHole::Clearance), ..Mounting::default() };
    let list = |pin: f64| parts(&sizes(6, 1, Some(pin), None), 6.0, &mounting).map(|list| list.parts);
    let has_pin = |list: &[Part]| list.iter().any(|part| part.layer == Layer::Pins);
    assert!(!has_pin(&list(4.0).unwrap()), "a screw is bought");
    assert!(has_pin(&list(6.5).unwrap()));
    for pin in [4.1, 6.4] {
        assert_eq!(list(pin), Err(MountingError::ThinBush { screw: "M4", pin, least: 6.5 }));
    }
    assert_eq!(list(3.9), Err(MountingError::ThickScrew { screw: "M4", pin: 3.9 }));
}

#[test]
fn the_first_sheet_lists_the_parts_and_has_the_distance_of_the_axes() {
    let sizes = sizes(6, 2, None, None);
    let base = Some(BasePlate { thickness: Some(9.0), ..BasePlate::default() });
    let mounting = Mounting { base, is_stacked: true, axial_play: Some(0.25), ..Mounting::default() };
    let limits = SheetLimits { shared: sizes.shared_tolerance(), ..SheetLimits::default() };
    let sheets = drawn(&sizes, &mounting, &limits, STEEL);
    let axes = |sheet: &Sheet| sheet.dimensions.iter().find(|size| size.measured == Measured::AxisDistance).cloned();
    let first = axes(&sheets[0]).unwrap();
    approx::assert_relative_eq!(first.nominal, sizes.crank_radius * 2.0, max_relative = 1e-12); // six stations: c = r / sin 30°
    assert_eq!(Some(first), axes(sheets.last().unwrap()), "as on the base plate");
    let text = all_text(&sheets[0]);
    let words = [
        "1  Wheel 1 piece, steel t = 6",
        "Driver plate 1 piece",
        "Pin 2 pieces, steel length 12.25",
        "Base plate 1 piece, steel t = 9",
    ];
    for words in words.into_iter().chain(["Axial play between wheel and plate: 0.25.", "Assembly"]) {
        assert!(text.contains(words), "{words}: {text}");
    }
}

#[test]
fn thicknesses_have_general_tolerances_or_are_those_of_the_sheet() {
    // ISO 2768-1, class m: 0.5 to 6 mm ±0.1, to 30 mm ±0.2.
    for (thickness, by) in [(3.0, 0.1), (6.0, 0.1), (6.5, 0.2), (30.0, 0.2)] {
        let text = SheetText { project: "", wheel_material: STEEL, driver_material: STEEL, pin_material: STEEL };
        let stacked = Mounting { is_stacked: true, ..Mounting::default() };
        let all = sheets(&sizes(6, 1, None, None), thickness, &stacked, &SheetLimits::default(), &text).unwrap();
        let found = all.iter().flat_map(|sheet| &sheet.dimensions).filter(|size| size.measured == Measured::Thickness);
        let limits: Vec<_> = found.map(|size| size.limits).collect();
        assert_eq!(limits, [Some([-by, by]); 3]);
    }
    let (sheets, _) = made_by(Process::Laser, 6);
    assert!(sheets[1..4].iter().all(|sheet| texts(sheet).any(|text| text == "t = 6, that of the sheet")));
}
