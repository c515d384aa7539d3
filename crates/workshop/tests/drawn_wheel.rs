//! Wheels read back from drawings: are the sizes those that were drawn, and is the one wrong size of an outline named?

#![allow(clippy::unwrap_used, reason = "clippy knows the functions of a test program as tests only by #[test]")]

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::as_built::{AsBuiltWheel, MeasuredSize, Process, ProcessNumbers, SplitMix64};
use geneva_kinematics::wheel::{Choices, Edge, Loop, Play, Scale, Sizes, Wheel};
use geneva_workshop::{
    Drawing, DrawingError, Fastener, LayerNames, Mounting, PartLayout, Pattern, PinMount, ScrewHole, Thread, dxf,
    internal_parts, parts,
};
use nalgebra::Vector2;
use std::f64::consts::PI;
use std::fmt::Write;

fn sizes(stations: u32, pins: u32, play: f64) -> Sizes {
    let choices = Choices { play: Some(Play::from_slot(play)), ..Choices::default() };
    Sizes::new(Wheel::with_pins(stations, pins).unwrap(), Scale::CentreDistance(100.0), &choices).unwrap()
}

#[test]
fn a_drawing_of_an_internal_wheel_is_refused_as_such() {
    let sizes = InternalSizes::new(InternalWheel::new(5).unwrap(), 40.0, &Choices::default()).unwrap();
    let list = internal_parts(&sizes, 6.0, &Mounting::default()).unwrap();
    let drawing = Drawing::read(&dxf(&list.parts, PartLayout::Apart)).unwrap();
    let refused = drawing.measure(&LayerNames::default(), 0.01).unwrap_err();
    assert!(refused.to_string().contains("only external wheels can be checked"), "{refused}");
}

#[test]
fn our_own_drawings_give_back_the_sizes() {
    for (stations, pins) in [(3, 1), (4, 1), (6, 2), (8, 1), (12, 1)] {
        let dowels = Pattern { count: 4, circle: 0.0, fastener: Fastener::Dowel(1.0) };
        for (layout, is_mounted) in [PartLayout::Apart, PartLayout::Assembled].into_iter().zip([false, true]) {
            let sizes = sizes(stations, pins, 0.2);
            // Holes for mounting are no slots.
            let hub = Pattern { circle: 0.8 * sizes.wheel_shaft_limit, ..dowels };
            let mounting = Mounting { wheel_hub: is_mounted.then_some(hub), ..Mounting::default() };
            let list = parts(&sizes, 5.0, &mounting).unwrap();
            let drawing = Drawing::read(&dxf(&list.parts, layout)).unwrap();
            let drawn = drawing.measure(&LayerNames::default(), 0.01).unwrap();
            assert!(!drawn.has_mouths && drawn.screw_hole.is_none(), "{stations} {pins} {layout:?}");
            let measured = drawn.measured;
            let disc = sizes.locking_disc.unwrap();
            let right = |size| match size {
                MeasuredSize::CentreDistance | MeasuredSize::ArcCentre(_) => sizes.centre_distance,
                MeasuredSize::CrankRadius => sizes.crank_radius,
                MeasuredSize::PinDiameter | MeasuredSize::NewPinDiameter => sizes.pin_diameter,
                MeasuredSize::TipRadius => sizes.tip_radius,
                MeasuredSize::SlotWidth(_) | MeasuredSize::NewSlotWidth => sizes.slot_width,
                MeasuredSize::SlotEnd(_) => sizes.slot_end,
                MeasuredSize::SlotDirection(_) => 0.0,
                MeasuredSize::ArcRadius(_) | MeasuredSize::NewArcRadius => sizes.locking_arc_radius,
                MeasuredSize::DiscRadius | MeasuredSize::NewDiscRadius => disc.radius,
                MeasuredSize::CrescentCentre => disc.crescent.centre,
                MeasuredSize::CrescentRadius => disc.crescent.radius,
            };
            for of in measured.sizes() {
                assert!((of.value - right(of.size)).abs() < 1e-9, "{stations} {pins} {layout:?} {of:?}");
            }
            // Five of each slot and arc, six of the driver; the axes only where the driver is in its place.
            let axes = usize::from(layout == PartLayout::Assembled);
            assert_eq!(measured.sizes().len(), 5 * stations as usize + 6 + axes);
            assert_eq!(measured.wheel().pins(), pins);
            assert!(measured.nearest().unwrap().culprit.is_none());
        }
    }
}

/// A drawing by another program: each loop a polyline with bulges, in place, turned and moved, in a unit of its own.
fn polylines(built: &AsBuiltWheel, layers: &LayerNames, turn: f64, inches: bool) -> String {
    let scale = if inches { 1.0 / 25.4 } else { 1.0 };
    let mut text = format!("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{}\n0\nENDSEC\n", if inches { 1 } else { 4 });
    text += "0\nSECTION\n2\nENTITIES\n";
    let outline = built.outline();
    let axis = Vector2::new(built.centre_distance, 0.0);
    let moved = Vector2::new(17.0, -41.0);
    let mut add = |layer: &str, of: &Loop, own: f64, by: Vector2<f64>| {
        let of = of.transform(own, by).transform(turn, moved);
        if let [Edge::Arc { centre, radius, .. }] = of.edges[..] {
            let [x, y, r] = [centre.x, centre.y, radius].map(|of| of * scale);
            write!(text, "0\nCIRCLE\n8\n{layer}\n10\n{x}\n20\n{y}\n40\n{r}\n").unwrap();
            return;
        }
        write!(text, "0\nLWPOLYLINE\n8\n{layer}\n90\n{}\n70\n1\n", of.edges.len()).unwrap();
        for edge in &of.edges {
            let [x, y] = [edge.start_point().x, edge.start_point().y].map(|of| of * scale);
            write!(text, "10\n{x}\n20\n{y}\n").unwrap();
            if let Edge::Arc { sweep, .. } = edge {
                writeln!(text, "42\n{}", (sweep / 4.0).tan()).unwrap();
            }
        }
    };
    add(&layers.wheel, &outline.wheel.outer, built.wheel().half_pitch_angle(), Vector2::zeros());
    add(&layers.disc, &outline.disc.unwrap().outer, PI, axis);
    add(&layers.plate, &outline.plate.outer, PI, axis);
    outline.pins.iter().for_each(|pin| add(&layers.pins, pin, PI, axis));
    text + "0\nENDSEC\n0\nEOF\n"
}

#[test]
fn the_wrong_size_of_an_outline_is_named_and_the_jam_is_that_of_the_outline() {
    let mut random = SplitMix64::new(77);
    let layers = LayerNames { wheel: "Star".into(), disc: "Disc".into(), plate: "Crank".into(), pins: "Pin".into() };
    let counts = [(4, 1), (6, 1), (5, 1), (8, 1), (6, 2), (12, 1), (3, 1)];
    let (mut named, mut jams, mut missed) = (0, 0, Vec::new());
    for k in 0..100_usize {
        let (stations, pins) = counts[k % counts.len()];
        let play = 0.15 + 0.3 * random.next_unit();
        let sizes = sizes(stations, pins, play);
        let mut built = AsBuiltWheel::from(&sizes);
        let number = random.next_u64() as usize % stations as usize;
        let by = (0.1 + 0.5 * random.next_unit()) * if random.next_unit() < 0.5 { 1.0 } else { -1.0 };
        let wrong = match k % 9 {
            0 => {
                built.centre_distance += by;
                MeasuredSize::CentreDistance
            }
            1 => {
                built.slots_mut()[number].width += by;
                MeasuredSize::SlotWidth(Some(number))
            }
            2 => {
                built.slots_mut()[number].end += by;
                MeasuredSize::SlotEnd(Some(number))
            }
            3 => {
                built.slots_mut()[number].direction_error += by / sizes.wheel_radius;
                MeasuredSize::SlotDirection(number)
            }
            4 => {
                built.arcs_mut()[number].radius += by;
                MeasuredSize::ArcRadius(Some(number))
            }
            5 => {
                built.pins_mut().iter_mut().for_each(|pin| pin.diameter += play + by.abs());
                MeasuredSize::PinDiameter
            }
            6 => {
                built.disc_radius = built.disc_radius.map(|disc| disc + play + by.abs());
                MeasuredSize::DiscRadius
            }
            7 => {
                built.slots_mut().iter_mut().for_each(|slot| slot.tip_radius += by);
                MeasuredSize::TipRadius
            }
            _ => {
                built.pins_mut().iter_mut().for_each(|pin| pin.crank_radius += by);
                MeasuredSize::CrankRadius
            }
        };
        let text = polylines(&built, &layers, 6.0 * random.next_unit(), k % 3 == 0);
        let measured = Drawing::read(&text).unwrap().measure(&layers, 0.01).unwrap().measured;
        let nearest = measured.nearest().unwrap();
        let (told, drawn) = (measured.as_built(&nearest).turn().unwrap(), built.turn().unwrap());
        // Slots have other numbers in a drawing that is turned; a jam has none of its own.
        assert_eq!(
            told.jam.is_some(),
            drawn.jam.is_some(),
            "{k}: {wrong:?} {by} {:?} {:?}",
            told.tightest,
            drawn.tightest
        );
        jams += usize::from(told.jam.is_some());
        match nearest.culprit {
            Some(culprit) if culprit.size.name() == wrong.name() && culprit.rest_agrees => named += 1,
            other => missed.push((k, stations, wrong, by, other, nearest.suspects)),
        }
    }
    assert!(named >= 95, "{named} named; {missed:#?}");
    assert!((30..=90).contains(&jams), "{jams} jam");
}

#[test]
fn what_is_no_drawing_of_a_wheel_is_refused_in_words() {
    assert!(matches!(Drawing::read("AutoCAD Binary DXF\nxyz\n"), Err(DrawingError::NotACode { line: 1, .. })));
    let broken = "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nWHEEL\n10\nabc\n20\n0\n40\n1\n0\nENDSEC\n";
    assert!(matches!(Drawing::read(broken), Err(DrawingError::NotANumber { line: 10, .. })));
    let empty = Drawing::read("0\nSECTION\n2\nENTITIES\n0\nTEXT\n8\nWHEEL\n0\nENDSEC\n0\nEOF\n").unwrap();
    assert_eq!(empty.passed_over, 1);
    let error = empty.measure(&LayerNames::default(), 0.01).unwrap_err();
    assert_eq!(error.to_string(), "layer WHEEL: there is no arc; draw it there, or say which layer has it");
}

#[test]
fn a_slot_whose_walls_are_not_straight_from_end_to_mouth_is_refused_with_its_place() {
    let sizes = sizes(6, 1, 0.2);
    let list = parts(&sizes, 5.0, &Mounting::default()).unwrap();
    let right = Drawing::read(&dxf(&list.parts, PartLayout::Apart)).unwrap();
    let said = |change: &dyn Fn(&mut Drawing, usize)| {
        let mut drawing = right.clone();
        let wall = |edge: &Edge| matches!(edge, Edge::Line { .. });
        let at = drawing.edges.iter().position(|drawn| drawn.layer == "WHEEL" && wall(&drawn.edge)).unwrap();
        change(&mut drawing, at);
        drawing.measure(&LayerNames::default(), 0.01).map_err(|error| error.to_string())
    };
    let by = |across: [f64; 2]| {
        move |drawing: &mut Drawing, at: usize| {
            let Edge::Line { from, to } = &mut drawing.edges[at].edge else { panic!("a line") };
            let along = (*to - *from).normalize();
            let side = Vector2::new(-along.y, along.x);
            (*from, *to) = (*from + side * across[0], *to + side * across[1]);
        }
    };
    assert!(said(&by([0.0, 0.0])).is_ok());
    // Within three times the uncertainty.
    assert!(said(&by([0.02, 0.0])).is_ok() && said(&by([0.0, 0.02])).is_ok());
    for (spoilt, words) in [
        (said(&by([0.5, 0.0])), "a wall is 0.500 mm nearer to or farther from the slot's line"),
        (said(&by([0.5, 0.5])), "no wall goes on outwards from the end of its arc at"),
        (said(&|drawing, at| drop(drawing.edges.remove(at))), "no wall goes on outwards"),
    ] {
        let error = spoilt.unwrap_err();
        assert!(error.contains(words) && error.contains("of the slot at "), "{error}");
    }
    // The slots of a ring open inwards.
    let ring = InternalSizes::new(InternalWheel::new(6).unwrap(), 50.0, &Choices::default()).unwrap();
    let list = internal_parts(&ring, 5.0, &Mounting::default()).unwrap();
    let mut drawing = Drawing::read(&dxf(&list.parts, PartLayout::Assembled)).unwrap();
    // As another program draws it, on the layer of a wheel alone.
    drawing.edges.retain(|drawn| drawn.layer == LayerNames::default().wheel);
    let error = drawing.measure(&LayerNames::default(), 0.01).unwrap_err().to_string();
    assert!(error.contains("no wall goes on outwards"), "{error}");
}

#[test]
fn a_polyline_of_release_12_is_read_with_its_bulges() {
    // A half disc: a line, and a half circle whose bulge is 1.
    let text = "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n8\nA\n66\n1\n70\n1\n0\nVERTEX\n8\nA\n10\n-2.0\n20\n0.0\n\
                0\nVERTEX\n8\nA\n10\n2.0\n20\n0.0\n42\n1.0\n0\nSEQEND\n0\nENDSEC\n0\nEOF\n";
    let drawing = Drawing::read(text).unwrap();
    let [line, arc] = &drawing.edges[..] else { panic!("{drawing:?}") };
    assert!(matches!(line.edge, Edge::Line { from, to } if from.x == -2.0 && to.x == 2.0));
    let Edge::Arc { centre, radius, sweep, .. } = arc.edge else { panic!("{arc:?}") };
    assert!(centre.norm() < 1e-12 && (radius - 2.0).abs() < 1e-12 && (sweep - PI).abs() < 1e-12);
    assert!((arc.edge.end_point() - Vector2::new(-2.0, 0.0)).norm() < 1e-12);
}

#[test]
fn mouths_and_square_ends_are_read_too() {
    use geneva_kinematics::wheel::Mouth;
    let mouths = [
        Mouth::Chamfer { width: 1.0, angle: PI / 4.0 },
        Mouth::Round { radius: 0.8 },
        Mouth::LeadIn { length: 6.0, flare: 0.4 },
    ];
    for mouth in mouths {
        let choices = Choices { mouth, play: Some(Play::from_slot(0.2)), ..Choices::default() };
        let sizes = Sizes::new(Wheel::new(6).unwrap(), Scale::CentreDistance(100.0), &choices).unwrap();
        let list = parts(&sizes, 5.0, &Mounting::default()).unwrap();
        let drawing = Drawing::read(&dxf(&list.parts, PartLayout::Assembled)).unwrap();
        let drawn = drawing.measure(&LayerNames::default(), 0.01).unwrap();
        assert!(drawn.has_mouths, "{mouth:?}");
        let (measured, nearest) = (&drawn.measured, drawn.measured.nearest().unwrap());
        assert!(nearest.culprit.is_none() && measured.wheel().stations() == 6, "{mouth:?} {nearest:?}");
        assert_eq!(measured.sizes().len(), 5 * 6 + 7, "{mouth:?}");
    }
    // Square ends: each round end of our own drawing becomes three lines.
    let sizes = sizes(5, 1, 0.2);
    let mut built = sizes.outline();
    let round = built.wheel.outer.edges.clone();
    let square = |edge: &Edge| match *edge {
        Edge::Arc { radius, sweep, .. } if (sweep.abs() - PI).abs() < 1e-9 => {
            let (from, to) = (edge.start_point(), edge.end_point());
            let chord = to - from;
            let inwards = Vector2::new(chord.y, -chord.x) / chord.norm() * radius;
            let towards = if (from + inwards).norm() < from.norm() { inwards } else { -inwards };
            vec![
                Edge::Line { from, to: from + towards },
                Edge::Line { from: from + towards, to: to + towards },
                Edge::Line { from: to + towards, to },
            ]
        }
        _ => vec![*edge],
    };
    built.wheel.outer.edges = round.iter().flat_map(square).collect();
    let mut text = "0\nSECTION\n2\nENTITIES\n".to_owned();
    for edge in &built.wheel.outer.edges {
        match *edge {
            Edge::Line { from, to } => {
                write!(text, "0\nLINE\n8\nWHEEL\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", from.x, from.y, to.x, to.y)
                    .unwrap();
            }
            Edge::Arc { centre, radius, start, sweep } => {
                let (first, last) = if sweep < 0.0 { (start + sweep, start) } else { (start, start + sweep) };
                let [first, last] = [first, last].map(f64::to_degrees);
                let (x, y) = (centre.x, centre.y);
                write!(text, "0\nARC\n8\nWHEEL\n10\n{x}\n20\n{y}\n40\n{radius}\n50\n{first}\n51\n{last}\n").unwrap();
            }
        }
    }
    text += "0\nENDSEC\n0\nEOF\n";
    let measured = Drawing::read(&text).unwrap().measure(&LayerNames::default(), 0.01).unwrap().measured;
    let nearest = measured.nearest().unwrap();
    assert_eq!(measured.wheel().stations(), 5);
    assert!((nearest.slot_width - sizes.slot_width).abs() < 1e-6 && (nearest.slot_end - sizes.slot_end).abs() < 1e-6);
    assert!(nearest.culprit.is_none(), "{nearest:?}");
}

#[test]
fn the_hole_of_a_screw_is_no_pin_and_of_two_circles_about_one_centre_the_larger_is() {
    let choices = Choices { pin_diameter: Some(6.0), play: Some(Play::from_slot(0.8)), ..Choices::default() };
    let sizes = Sizes::new(Wheel::new(4).unwrap(), Scale::CrankRadius(25.0), &choices).unwrap();
    let layers = LayerNames { pins: "Bushes".into(), ..LayerNames::default() };
    let drawn = polylines(&AsBuiltWheel::from(&sizes), &LayerNames::default(), 0.0, false);
    let circle = |diameter: f64| {
        let (x, y) = (17.0 + sizes.centre_distance - sizes.crank_radius, -41.0);
        format!("0\nCIRCLE\n8\nBushes\n10\n{x}\n20\n{y}\n40\n{}\n", diameter / 2.0)
    };
    let pin_of = |circles: &str| {
        let text = drawn.replace("0\nENDSEC\n0\nEOF", &format!("{circles}0\nENDSEC\n0\nEOF"));
        let drawn = Drawing::read(&text).unwrap().measure(&layers, 0.01).unwrap();
        let size = |size| drawn.measured.sizes().iter().find(|of| of.size == size).map(|of| of.value);
        let nearest = drawn.measured.nearest().unwrap();
        assert!(nearest.culprit.is_none(), "{nearest:?}");
        assert!(size(MeasuredSize::CrankRadius).is_none_or(|radius| (radius - 25.0).abs() < 1e-9));
        (size(MeasuredSize::PinDiameter), drawn.screw_hole, nearest.pin_diameter)
    };
    // A hole of 3.4 mm where slots are 6.8 mm wide.
    let (pin, hole, assumed) = pin_of(&circle(3.4));
    assert!(pin.is_none() && (hole.unwrap() - 3.4).abs() < 1e-12 && (5.8..6.8).contains(&assumed), "{assumed}");
    for circles in [circle(3.4) + &circle(6.0), circle(6.0) + &circle(3.4), circle(6.0)] {
        let (pin, hole, _) = pin_of(&circles);
        assert!((pin.unwrap() - 6.0).abs() < 1e-12 && hole.is_none(), "{pin:?} {hole:?}");
    }
    let (pin, hole, assumed) = pin_of("");
    assert!(pin.is_none() && hole.is_none() && (5.8..6.8).contains(&assumed), "{assumed}");
}

#[test]
fn a_pin_on_a_screw_in_our_own_drawing_is_not_its_hole() {
    let choices = Choices { pin_diameter: Some(6.0), play: Some(Play::from_slot(0.8)), ..Choices::default() };
    let sizes = Sizes::new(Wheel::new(4).unwrap(), Scale::CrankRadius(25.0), &choices).unwrap();
    for hole in [ScrewHole::Clearance, ScrewHole::Tapped, ScrewHole::NutTrap] {
        let mounting = Mounting { pins: PinMount::Screw(Thread::M3, hole), ..Mounting::default() };
        let list = parts(&sizes, 5.0, &mounting).unwrap();
        for layout in [PartLayout::Apart, PartLayout::Assembled] {
            let drawing = Drawing::read(&dxf(&list.parts, layout)).unwrap();
            let measured = drawing.measure(&LayerNames::default(), 0.01).unwrap().measured;
            let pins = measured.sizes().iter().filter(|of| of.size == MeasuredSize::PinDiameter);
            assert!(pins.clone().all(|of| (of.value - 6.0).abs() < 1e-9), "{hole:?} {:?}", pins.collect::<Vec<_>>());
            assert!(measured.nearest().unwrap().culprit.is_none(), "{hole:?} {layout:?}");
        }
    }
}

#[test]
fn slots_of_a_drawing_are_numbered_from_the_right_however_a_slot_is_out_of_its_place() {
    for stations in [4_u32, 5, 6, 9] {
        let sizes = sizes(stations, 1, 0.2);
        let (count, pitch) = (stations as usize, 2.0 * PI / f64::from(stations));
        for turned in 0..8 {
            let turn = pitch * f64::from(turned) / 4.0 - PI;
            // Where the slots should be, and the one nearest to the right.
            let direction = |k: usize| {
                let angle = pitch * (k as f64 + 0.5) + turn;
                (angle + PI).rem_euclid(2.0 * PI) - PI
            };
            let key = |k: &usize| if direction(*k) < -1e-9 { direction(*k).abs() + 1e-6 } else { direction(*k) };
            let first = (0..count).min_by(|one, other| key(one).total_cmp(&key(other))).unwrap();
            for wide in 0..count {
                for degrees in [-0.3_f64, -0.05, 0.05, 0.3] {
                    let mut built = AsBuiltWheel::from(&sizes);
                    built.slots_mut()[wide].width += 0.5;
                    built.arcs_mut()[wide].radius -= 0.5;
                    for slot in built.slots_mut().iter_mut().step_by(3) {
                        slot.direction_error = degrees.to_radians();
                    }
                    let text = polylines(&built, &LayerNames::default(), turn, false);
                    let drawn = Drawing::read(&text).unwrap().measure(&LayerNames::default(), 0.01).unwrap().measured;
                    let number = (wide + count - first) % count;
                    for of in drawn.sizes() {
                        let is_wide = match of.size {
                            MeasuredSize::SlotWidth(_) => of.value > sizes.slot_width + 0.25,
                            MeasuredSize::ArcRadius(_) => of.value < sizes.locking_arc_radius - 0.25,
                            _ => continue,
                        };
                        assert_eq!(
                            is_wide,
                            of.size.number() == Some(number),
                            "{stations} {turned} {wide} {degrees} {of:?}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn none_of_two_hundred_of_our_own_drawings_is_accused_and_no_wrong_formula_is_named() {
    let mut random = SplitMix64::new(79);
    let (mut accused, mut read) = (Vec::new(), 0);
    while read < 200 {
        let stations = [3, 4, 5, 6, 8, 12][(random.next_u64() % 6) as usize];
        let crank = [12.0, 15.0, 20.0, 25.0, 30.0, 40.0, 60.0][(random.next_u64() % 7) as usize];
        let wheel = Wheel::new(stations).unwrap();
        let process = Process::ALL[(random.next_u64() % 6) as usize];
        let play = ProcessNumbers::new(process, crank * wheel.centre_distance_ratio()).unwrap().play();
        let pin_diameter = (read % 2 == 0).then(|| (crank * (0.08 + 0.15 * random.next_unit()) * 10.0).round() / 10.0);
        let choices = Choices { play: Some(play), pin_diameter, ..Choices::default() };
        let Ok(sizes) = Sizes::new(wheel, Scale::CrankRadius(crank), &choices) else { continue };
        let Ok(list) = parts(&sizes, 5.0, &Mounting::default()) else { continue };
        let layout = if read % 3 == 0 { PartLayout::Assembled } else { PartLayout::Apart };
        let drawing = Drawing::read(&dxf(&list.parts, layout)).unwrap();
        let measured = drawing.measure(&LayerNames::default(), 0.01).unwrap().measured;
        let nearest = measured.nearest().unwrap();
        let turn = measured.as_built(&nearest).turn().unwrap();
        let formulas = measured.known_mistakes(&nearest, Some(&turn));
        if nearest.culprit.is_some() || !turn.is_driven() || !formulas.is_empty() {
            let tightest = turn.tightest.free.room();
            accused.push(format!(
                "{stations} {crank} {process:?} {pin_diameter:?}: {:?} {tightest} {formulas:?}",
                nearest.culprit
            ));
        }
        read += 1;
    }
    assert!(accused.is_empty(), "{} of 200: {accused:#?}", accused.len());
}
