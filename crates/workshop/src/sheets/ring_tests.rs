//! Tests of the sheets of internal wheels: dimensions against outlines, room, limits at their worst.

use super::length::mm;
use super::tests::{TEXT, across, assert_is_legible, circle, corner, farthest, hit, middle, narrowest, polygon};
use super::*;
use crate::geometry::Point;
use crate::parts::{
    Fastener, Hole, HolePurpose, Layer, Mounting, Part, Pattern, PinMount, ScrewHole, ShaftFit, Thread, internal_parts,
};
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::as_built::{Process, ProcessNumbers};
use geneva_kinematics::wheel::{Choices, Play};
use std::f64::consts::PI;

fn sizes(stations: u32, crank: f64, choices: &Choices) -> InternalSizes {
    InternalSizes::new(InternalWheel::new(stations).unwrap(), crank, choices).unwrap()
}

/// Sizes of many kinds, bare and with everything.
fn designs() -> Vec<(InternalSizes, Mounting)> {
    let mut all = Vec::new();
    for stations in [3, 4, 5, 6, 8, 12, 24] {
        for crank in [12.0, 40.0, 150.0] {
            let bare = sizes(stations, crank, &Choices::default());
            all.push((bare, Mounting::default()));
            let shaft = Some(0.4 * crank);
            let fitted =
                sizes(stations, crank, &Choices { wheel_shaft: shaft, plate_shaft: shaft, ..Choices::default() });
            let key = if crank == 40.0 { ShaftFit::Key } else { ShaftFit::Round };
            let dowel = Fastener::Dowel(0.05 * crank);
            // Between two slots, where the ring is widest.
            let circle = 2.0 * fitted.slot_end;
            let mounting = Mounting {
                wheel_fit: key,
                driver_fit: ShaftFit::Flat { across: 0.36 * crank },
                wheel_hub: Some(Pattern { count: 3, circle: crank, fastener: dowel }),
                disc_dowels: Some(Pattern { count: stations.min(12), circle, fastener: dowel }),
                pins: PinMount::Dowel,
                is_stacked: true,
                ..Mounting::default()
            };
            let few = Mounting { disc_dowels: None, ..mounting };
            let fits = |mounting: &Mounting| internal_parts(&fitted, 8.0, mounting).is_ok();
            all.extend([mounting, few].into_iter().find(fits).map(|mounting| (fitted, mounting)));
        }
    }
    let nut = Pattern { count: 3, circle: 40.0, fastener: Fastener::Screw(Thread::M3, ScrewHole::NutTrap) };
    let pins = PinMount::Screw(Thread::M6, ScrewHole::Tapped);
    all.push((
        sizes(6, 60.0, &Choices { pin_diameter: Some(6.0), ..Choices::default() }),
        Mounting { driver_hub: Some(nut), pins, ..Mounting::default() },
    ));
    all
}

fn drawn(sizes: &InternalSizes, mounting: &Mounting, limits: &SheetLimits) -> Vec<Sheet> {
    internal_sheets(sizes, 8.0, mounting, limits, &TEXT).expect("sheets")
}

/// What a dimension measures, from the outlines and places of the parts and not from the numbers that it was made of.
fn measure(sheet: &Sheet, list: &[Part], what: Measured) -> f64 {
    let of = |layer| list.iter().find(|part| part.layer == layer).unwrap();
    let Some(layer) = sheet.layer else {
        assert_eq!(what, Measured::AxisDistance);
        return of(Layer::Plate).places[0].at.x - of(Layer::Wheel).places[0].at.x;
    };
    let part = of(layer);
    let outer = || polygon(&part.outer);
    let hole = |is: &dyn Fn(HolePurpose) -> bool| -> &Hole { part.holes.iter().find(|hole| is(hole.purpose)).unwrap() };
    let line = |wanted: HolePurpose| polygon(&hole(&|purpose| purpose == wanted).outline);
    let pin_hole = || polygon(&hole(&|purpose| matches!(purpose, HolePurpose::Pin | HolePurpose::PinScrew)).outline);
    let inside = || line(HolePurpose::Inside);
    let nearest = |of: &[Point]| of.iter().map(|p| p.norm()).fold(f64::INFINITY, f64::min);
    let width = || {
        // Across the slot on the first axis, half way out.
        let inside = inside();
        let x = (nearest(&inside) + hit(&inside, 0.0, 0.0).x) / 2.0;
        let next = inside.iter().cycle().skip(1);
        let at = inside.iter().zip(next).filter(|(a, b)| (a.x > x) != (b.x > x));
        let at = at.map(|(a, b)| a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
        let above = at.clone().filter(|y| *y > 0.0).fold(f64::INFINITY, f64::min);
        above - at.filter(|y| *y < 0.0).fold(f64::NEG_INFINITY, f64::max)
    };
    let around = |angle: f64, by: f64| {
        let inside = inside();
        circle([-by, 0.0, by].map(|turn| corner(&inside, angle + turn)))
    };
    let half_pitch = of(Layer::Wheel).places[0].turn;
    let bore = || line(HolePurpose::Bore);
    let widened = || part.holes.iter().find_map(|hole| hole.widening.as_ref()).unwrap();
    match what {
        Measured::SlotWidth => width(),
        Measured::SlotEnd => hit(&inside(), 0.0, 0.0).x - width() / 2.0,
        Measured::SlotEndRadius => around(0.0, 0.1 * width() / hit(&inside(), 0.0, 0.0).x).1,
        Measured::LockingArc => around(half_pitch, 0.1 * half_pitch).1,
        Measured::LockingArcCentres => 2.0 * around(half_pitch, 0.1 * half_pitch).0.norm(),
        Measured::RingInside => 2.0 * nearest(&inside()),
        Measured::Rim | Measured::Plate => 2.0 * farthest(&outer()),
        Measured::SegmentOuter => farthest(&outer()),
        Measured::SegmentInner => nearest(&outer()),
        Measured::SegmentChord => {
            let (outer, far) = (outer(), farthest(&outer()));
            let on_rim: Vec<Point> = outer.into_iter().filter(|p| p.norm() > far - 1e-9).collect();
            across(&on_rim, PI / 2.0)
        }
        Measured::Bore if layer == Layer::Plate => 2.0 * farthest(&bore()),
        Measured::Bore => 2.0 * nearest(&bore()),
        Measured::KeywayWidth => {
            let (bore, least) = (bore(), nearest(&bore()));
            let beyond: Vec<Point> = bore.into_iter().filter(|p| p.norm() > 1.02 * least).collect();
            across(&beyond, half_pitch + PI / 2.0)
        }
        Measured::AcrossBore if layer == Layer::Plate => across(&bore(), 0.0),
        Measured::AcrossBore => across(&bore(), half_pitch),
        Measured::CrankRadius => middle(&pin_hole()).norm(),
        Measured::PinHole => across(&pin_hole(), 0.0),
        Measured::Pin if layer == Layer::Plate => across(&polygon(&of(Layer::Pins).outer), 0.0),
        Measured::Pin => across(&outer(), 0.0),
        Measured::PinLength if layer == Layer::Plate => {
            let pin = of(Layer::Pins);
            pin.places[0].bottom + pin.thickness - part.places[0].bottom - part.thickness
        }
        Measured::PinLength | Measured::Thickness => part.thickness,
        Measured::HubHole => across(&line(HolePurpose::Hub), 0.0),
        Measured::HubCircle => 2.0 * middle(&line(HolePurpose::Hub)).norm(),
        Measured::DowelHole => across(&line(HolePurpose::DiscDowel), 0.0),
        Measured::DowelCircle => 2.0 * middle(&line(HolePurpose::DiscDowel)).norm(),
        Measured::NutWidth => narrowest(&polygon(&widened().outline)),
        Measured::PocketDepth => widened().depth,
        other => panic!("{other:?} is not of internal wheels"),
    }
}

#[test]
fn every_printed_dimension_of_an_internal_wheel_is_measured_on_its_outlines() {
    let mut kinds = std::collections::BTreeSet::new();
    for (k, (sizes, mounting)) in designs().into_iter().enumerate() {
        // Polygons of many corners take long.
        if k % 4 != 1 && mounting.driver_hub.is_none() {
            continue;
        }
        let list = internal_parts(&sizes, 8.0, &mounting).unwrap().parts;
        for sheet in drawn(&sizes, &mounting, &SheetLimits::default()) {
            for size in &sheet.dimensions {
                let measured = measure(&sheet, &list, size.measured);
                let loose = 1e-4 * size.nominal.max(1.0);
                assert!((measured - size.nominal).abs() < loose, "{k}: {size:?}, but {measured}");
                assert!(size.text.contains(&mm(size.nominal)), "{size:?}");
                assert!(sheet.ink.texts.iter().any(|text| text.text == size.text), "{size:?} is not on the sheet");
                kinds.insert(format!("{:?}", size.measured));
            }
        }
    }
    assert!(kinds.len() >= 24, "{}: {kinds:?}", kinds.len());
}

#[test]
fn sheets_of_internal_wheels_are_legible_with_and_without_a_process() {
    for (k, (sizes, mounting)) in designs().into_iter().enumerate() {
        let numbers = ProcessNumbers::new(Process::Fdm, sizes.centre_distance).expect("a length");
        let limits = SheetLimits { process: Some(numbers), yield_share: Some(0.9876), ..SheetLimits::default() };
        for limits in [SheetLimits::default(), limits] {
            for sheet in drawn(&sizes, &mounting, &limits) {
                assert_is_legible(&sheet, &format!("{k}: {:?} {}", sheet.layer, sizes.outside_radius));
            }
        }
    }
}

#[test]
fn an_internal_wheel_with_all_printed_limits_at_their_worst_touches_nowhere() {
    let mut narrowed = 0;
    for (stations, crank) in [(3, 60.0), (4, 40.0), (6, 50.0), (8, 30.0)] {
        let play = Some(Play { bore: 0.04, ..Play::from_slot(0.4) });
        let shaft = Some(2.0);
        let sizes =
            sizes(stations, crank, &Choices { play, wheel_shaft: shaft, plate_shaft: shaft, ..Choices::default() });
        let shared = sizes.shared_tolerance().expect("room for errors");
        let mounting = Mounting { is_stacked: true, ..Mounting::default() };
        let sheets = drawn(&sizes, &mounting, &SheetLimits { shared: Some(shared), ..SheetLimits::default() });
        let of = |layer| {
            sheets.iter().filter(move |sheet: &&Sheet| sheet.layer == layer).flat_map(|sheet| &sheet.dimensions)
        };
        let limits = |layer, what: Measured| -> [f64; 2] {
            of(layer).filter(|size| size.measured == what).find_map(|size| size.limits).expect("limits")
        };
        let on = |layer, what| limits(Some(layer), what);
        narrowed +=
            sheets.iter().flat_map(|sheet| &sheet.dimensions).filter(|size| size.origin == LimitOrigin::Chain).count();
        let loose = sizes.play.bore + on(Layer::RingPlate, Measured::Bore)[1] + on(Layer::Plate, Measured::Bore)[1];
        let axes = limits(None, Measured::AxisDistance);
        let mut wrong = sizes;
        wrong.slot_width += on(Layer::Wheel, Measured::SlotWidth)[0];
        wrong.pin_diameter += on(Layer::Pins, Measured::Pin)[1];
        wrong.slot_end += on(Layer::Wheel, Measured::SlotEnd)[0];
        wrong.mouth_radius = libm::hypot(wrong.wheel_radius, wrong.slot_width / 2.0);
        wrong.locking_arc_radius += on(Layer::Wheel, Measured::LockingArc)[0];
        wrong.segment_radii[0] += on(Layer::LockingSegment, Measured::SegmentOuter)[1];
        for error in [axes[0] - loose, axes[1] + loose] {
            for by in on(Layer::Plate, Measured::CrankRadius) {
                let mut made = wrong;
                made.crank_radius += by;
                let found = made.least_clearance_at(sizes.centre_distance + error).unwrap();
                assert!(found.distance >= 0.0, "{stations} stations: {found:?} {error}");
            }
        }
    }
    assert!(narrowed >= 12, "{narrowed}");
}

#[test]
fn the_first_sheet_of_an_internal_wheel_lists_its_pieces() {
    let sizes = sizes(6, 40.0, &Choices::default());
    let text = |mounting: &Mounting| -> String {
        let sheets = drawn(&sizes, mounting, &SheetLimits::default());
        sheets[0].ink.texts.iter().map(|text| text.text.as_str()).collect::<Vec<_>>().join(" ")
    };
    let one = text(&Mounting::default());
    for words in
        ["1  Ring ", "2  Ring plate, not drawn", "3  Driver ", "plate, locking segment, pin in one piece", "t = 8 + 8"]
    {
        assert!(one.contains(words), "{words}: {one}");
    }
    assert!(!one.contains("4  "), "{one}");
    let many = text(&Mounting { is_stacked: true, ..Mounting::default() });
    for words in ["3  Locking segment", "4  Driver plate", "5  Pin "] {
        assert!(many.contains(words), "{words}: {many}");
    }
}
