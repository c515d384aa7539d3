//! Tests of the sheets: dimensions against outlines, room, limits at their worst.

use super::drawn_sizes::DrawnSizes;
use super::length::mm;
use super::limits::Chain;
use super::part_views::crescent_shift;
use super::title::frame;
use super::*;
use crate::geometry::{Point, direction};
use crate::parts::{
    BasePlate, Fastener, HolePurpose, Layer, Mounting, Part, Pattern, PinMount, ScrewHole, ShaftFit, Thread, parts,
};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{Process, ProcessNumbers};
use geneva_kinematics::wheel::{Choices, Loop, Mouth, Play, Scale, SharedTolerance, Sizes, Wheel};
use roxmltree::Document;
use std::f64::consts::PI;

pub(super) const TEXT: SheetText<'static> = SheetText {
    project: "Geneva wheel of many stations with a crank radius of 40 mm",
    wheel_material: SheetMaterial { name: "stainless-steel", hardness: Some("58 HRC") },
    driver_material: SheetMaterial { name: "stainless-steel", hardness: Some("58 HRC") },
    pin_material: SheetMaterial { name: "acetal", hardness: None },
};

/// Sizes of many kinds: from 3 to 24 stations, one pin and as many as leave a dwell, small and large, bare and with everything.
fn designs() -> Vec<(Sizes, Mounting)> {
    let mut all = Vec::new();
    for stations in 3..=24 {
        for pins in 1..=4 {
            let Ok(wheel) = Wheel::with_pins(stations, pins) else { continue };
            // Each number of stations has another size; all have each kind of mounting.
            for (crank, play) in [[(40.0, None), (5.0, Some(0.1)), (150.0, Some(0.4))][(stations + pins) as usize % 3]]
            {
                let choices = Choices { play: play.map(Play::from_slot), ..Choices::default() };
                let Ok(bare) = Sizes::new(wheel, Scale::CrankRadius(crank), &choices) else { continue };
                all.push((bare, Mounting::default()));
                // A third of the room for each shaft.
                let [of_wheel, of_driver] = [bare.wheel_shaft_limit, bare.driver_shaft_limit].map(|most| most / 3.0);
                let choices = Choices { wheel_shaft: Some(of_wheel), driver_shaft: Some(of_driver), ..choices };
                let Ok(sizes) = Sizes::new(wheel, Scale::CrankRadius(crank), &choices) else { continue };
                let is_keyed = (6.0..40.0).contains(&of_wheel);
                let hole = Fastener::Dowel(0.08 * of_wheel);
                let mounting = Mounting {
                    wheel_fit: if is_keyed { ShaftFit::Key } else { ShaftFit::Round },
                    driver_fit: ShaftFit::Flat { across: 0.9 * of_driver },
                    wheel_hub: Some(Pattern { count: 3, circle: 1.5 * of_wheel, fastener: hole }),
                    base: Some(BasePlate {
                        shoulder: Some([1.2 * of_wheel.max(of_driver), 0.5]),
                        screws: Some(Thread::M4),
                        thickness: Some(9.0),
                    }),
                    ..Mounting::default()
                };
                let simple = Mounting { wheel_hub: None, wheel_fit: ShaftFit::Round, ..mounting };
                let bare = Mounting { base: None, ..simple };
                let fits = |mounting: &Mounting| parts(&sizes, 8.0, mounting).is_ok();
                all.extend([mounting, simple, bare].into_iter().find(fits).map(|mounting| (sizes, mounting)));
            }
        }
    }
    for mouth in [
        Mouth::Round { radius: 1.0 },
        Mouth::Chamfer { width: 2.0, angle: 0.5 },
        Mouth::LeadIn { length: 4.0, flare: 0.4 },
    ] {
        let choices = Choices { mouth, ..Choices::default() };
        all.push((
            Sizes::new(Wheel::new(6).unwrap(), Scale::CrankRadius(40.0), &choices).unwrap(),
            Mounting::default(),
        ));
    }
    let wheel = Wheel::new(4).unwrap();
    let choices = Choices { wheel_shaft: Some(10.0), driver_shaft: Some(8.0), ..Choices::default() };
    let screw = |hole| Fastener::Screw(Thread::M3, hole);
    let mounting = Mounting {
        driver_hub: Some(Pattern { count: 3, circle: 20.0, fastener: screw(ScrewHole::NutTrap) }),
        disc_dowels: Some(Pattern { count: 2, circle: 32.0, fastener: Fastener::Dowel(3.0) }),
        pins: PinMount::Screw(Thread::M4, ScrewHole::Tapped),
        ..Mounting::default()
    };
    all.push((Sizes::new(wheel, Scale::CrankRadius(40.0), &choices).unwrap(), mounting));
    all
}

fn drawn(sizes: &Sizes, mounting: &Mounting, shared: Option<SharedTolerance>) -> Vec<Sheet> {
    let limits = SheetLimits { shared, ..SheetLimits::default() };
    sheets(sizes, 8.0, mounting, &limits, &TEXT).expect("sheets")
}

/// What is drawn of parts made by a process.
fn drawn_for(sizes: &Sizes, mounting: &Mounting, process: Process, shared: Option<SharedTolerance>) -> Vec<Sheet> {
    let numbers = ProcessNumbers::new(process, sizes.centre_distance).expect("a length");
    let limits = SheetLimits { shared, process: Some(numbers), yield_share: Some(0.9876) };
    sheets(sizes, 8.0, mounting, &limits, &TEXT).expect("sheets")
}

/// A polygon that leaves a line by a hundred thousandth of a millimetre at most.
pub(super) fn polygon(of: &Loop) -> Vec<Point> {
    of.corners(1e-5).unwrap()
}

/// The nearest place at which a ray at an angle meets a polygon, from a distance on.
pub(super) fn hit(of: &[Point], angle: f64, from: f64) -> Point {
    let u = direction(angle);
    let next = of.iter().cycle().skip(1);
    let crossing = |(a, b): (&Point, &Point)| {
        let (p, q) = (u.perp(a), u.perp(b));
        let part = p / (p - q);
        ((p > 0.0) != (q > 0.0)).then(|| (a + (b - a) * part).dot(&u)).filter(|far| *far > from)
    };
    u * of.iter().zip(next).filter_map(crossing).fold(f64::INFINITY, f64::min)
}

/// The corner of a polygon, which is on the outline's arc, that is nearest to where a ray meets it first.
pub(super) fn corner(of: &[Point], angle: f64) -> Point {
    let at = hit(of, angle, 0.0);
    of.iter().copied().min_by(|a, b| (a - at).norm().total_cmp(&(b - at).norm())).unwrap()
}

/// Middle and radius of the circle through three points.
pub(super) fn circle([a, b, c]: [Point; 3]) -> (Point, f64) {
    let (p, q) = (b - a, c - a);
    let twice = 2.0 * p.perp(&q);
    let middle = a + Point::new(
        q.y * p.norm_squared() - p.y * q.norm_squared(),
        p.x * q.norm_squared() - q.x * p.norm_squared(),
    ) / twice;
    (middle, (middle - a).norm())
}

/// Extent of points in a direction.
pub(super) fn across(of: &[Point], angle: f64) -> f64 {
    let along = of.iter().map(|p| p.dot(&direction(angle)));
    along.clone().fold(f64::NEG_INFINITY, f64::max) - along.fold(f64::INFINITY, f64::min)
}

pub(super) fn farthest(of: &[Point]) -> f64 {
    of.iter().map(|p| p.norm()).fold(0.0, f64::max)
}

/// The middle of the box about points.
pub(super) fn middle(of: &[Point]) -> Point {
    let corner = |pick: fn(&Point, &Point) -> Point| of.iter().copied().reduce(|a, b| pick(&a, &b)).unwrap();
    (corner(|a, b| a.inf(b)) + corner(|a, b| a.sup(b))) / 2.0
}

/// The least extent of points over all directions in quarters of a degree, one of which is that of each flat here.
pub(super) fn narrowest(of: &[Point]) -> f64 {
    (0..720).map(|k| across(of, PI * f64::from(k) / 720.0)).fold(f64::INFINITY, f64::min)
}

/// What a dimension measures, from the outlines and not from the numbers that it was made of.
fn measure(sheet: &Sheet, sizes: &Sizes, list: &[Part], what: Measured) -> Option<f64> {
    let outline = sizes.outline();
    let wheel = || polygon(&outline.wheel.outer);
    let disc = || polygon(&outline.disc.as_ref().unwrap().outer);
    let Some(layer) = sheet.layer else {
        let axis = |layer| list.iter().find(|part| part.layer == layer).unwrap().places[0].at;
        return (what == Measured::AxisDistance).then(|| axis(Layer::Plate).x - axis(Layer::Wheel).x);
    };
    let part = list.iter().find(|part| part.layer == layer).unwrap();
    let holes = |purpose| part.holes.iter().filter(move |hole| hole.purpose == purpose);
    let first = |purpose| polygon(&holes(purpose).next().unwrap().outline);
    let widened = || part.holes.iter().find_map(|hole| hole.widening.as_ref()).unwrap();
    // Across the slot on the first axis, half way down.
    let width = || {
        let (outer, x) = (wheel(), (sizes.slot_end + sizes.wheel_radius) / 2.0);
        let next = outer.iter().cycle().skip(1);
        let at = outer.iter().zip(next).filter(|(a, b)| (a.x > x) != (b.x > x));
        let at = at.map(|(a, b)| a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
        let above = at.clone().filter(|y| *y > 0.0).fold(f64::INFINITY, f64::min);
        above - at.filter(|y| *y < 0.0).fold(f64::NEG_INFINITY, f64::max)
    };
    let around = |of: &[Point], angle: f64, by: f64| [-by, 0.0, by].map(|turn| corner(of, angle + turn));
    let arc = || circle(around(&wheel(), sizes.wheel.half_pitch_angle(), 0.1 * sizes.wheel.half_pitch_angle()));
    let crescent = || circle(around(&disc(), 0.0, 0.3 * sizes.locking_disc.unwrap().crescent.half_angle));
    let bore_radius = |bore: &[Point]| {
        let is_flat = part.layer != Layer::Wheel && part.layer != Layer::BasePlate;
        if is_flat { farthest(bore) } else { bore.iter().map(|p| p.norm()).fold(f64::INFINITY, f64::min) }
    };
    let key = |bore: &[Point]| {
        libm::atan2(
            bore.iter().map(|p| p.y * (p.norm() - bore_radius(bore)).max(0.0)).sum(),
            bore.iter().map(|p| p.x * (p.norm() - bore_radius(bore)).max(0.0)).sum(),
        )
    };
    Some(match what {
        Measured::SlotWidth => width(),
        Measured::SlotEnd => hit(&wheel(), 0.0, 0.0).x + width() / 2.0,
        Measured::SlotEndRadius => circle(around(&wheel(), 0.0, 0.2 * width() / sizes.slot_end)).1,
        Measured::MouthLength => {
            // The wall's end is the outermost place that is as far from the slot's middle as the wall.
            let half = width() / 2.0;
            let on_wall = wheel().into_iter().filter(|p| (p.y - half).abs() < 1e-9 && p.x > sizes.slot_end);
            sizes.wheel_radius - on_wall.map(|p| p.x).fold(0.0, f64::max)
        }
        Measured::MouthRadius => {
            let half = width() / 2.0;
            let rim = farthest(&wheel());
            let on_arc: Vec<Point> = wheel()
                .into_iter()
                .filter(|p| p.y > half - 1e-9 && p.y < 3.0 * half && p.x > sizes.slot_end && p.norm() < rim - 1e-9)
                .filter(|p| p.x > rim - 2.0 * half && p.y > half + 1e-6)
                .collect();
            let last = on_arc.len() - 1;
            circle([on_arc[0], on_arc[last / 2], on_arc[last]]).1
        }
        Measured::Rim => 2.0 * farthest(&wheel()),
        Measured::LockingArc => arc().1,
        Measured::LockingArcCentres => 2.0 * arc().0.norm(),
        Measured::Disc => 2.0 * farthest(&disc()),
        Measured::Crescent => crescent().1,
        Measured::CrescentCentre => crescent().0.norm(),
        Measured::Opening => {
            // Where rays from the axis come to the rim, on either side of the pin.
            let (disc, rim) = (disc(), farthest(&disc()));
            let on_rim = disc.iter().filter(|p| p.norm() > rim - 2e-5 && p.y > 0.0);
            2.0 * on_rim.max_by(|a, b| (a.x / a.norm()).total_cmp(&(b.x / b.norm())))?.y
        }
        Measured::Plate => 2.0 * farthest(&polygon(&outline.plate.outer)),
        Measured::CrankRadius => middle(&polygon(&outline.pins[0])).norm(),
        Measured::Pin => across(&polygon(&outline.pins[0]), 0.0),
        Measured::PinHole if holes(HolePurpose::PinScrew).count() > 0 => across(&first(HolePurpose::PinScrew), 0.0),
        Measured::PinHole => across(&first(HolePurpose::Pin), 0.0),
        Measured::PinLength => list.iter().find(|part| part.layer == Layer::Pins).unwrap().thickness,
        Measured::Thickness => part.thickness,
        Measured::HubHole => across(&first(HolePurpose::Hub), 0.0),
        Measured::HubCircle => 2.0 * middle(&first(HolePurpose::Hub)).norm(),
        Measured::DowelHole => across(&first(HolePurpose::DiscDowel), 0.0),
        Measured::DowelCircle => 2.0 * middle(&first(HolePurpose::DiscDowel)).norm(),
        Measured::NutWidth => narrowest(&polygon(&widened().outline)),
        Measured::PocketDepth => widened().depth,
        Measured::Bore if part.layer == Layer::BasePlate => return None,
        Measured::Bore => 2.0 * bore_radius(&first(HolePurpose::Bore)),
        Measured::KeywayWidth => {
            let bore = first(HolePurpose::Bore);
            let beyond: Vec<Point> = bore.iter().copied().filter(|p| p.norm() > 1.02 * bore_radius(&bore)).collect();
            across(&beyond, key(&bore) + PI / 2.0)
        }
        Measured::AcrossBore if part.layer == Layer::Wheel => {
            let bore = first(HolePurpose::Bore);
            across(&bore, key(&bore))
        }
        Measured::AcrossBore => narrowest(&first(HolePurpose::Bore)),
        Measured::RingInside | Measured::SegmentOuter | Measured::SegmentInner | Measured::SegmentChord => {
            panic!("{what:?} is of internal wheels")
        }
        Measured::AxisDistance => {
            let middles: Vec<f64> = part.marks.iter().map(|mark| mark.x).collect();
            middles[1] - middles[0]
        }
        Measured::AxisPlace => -polygon(&part.outer).iter().map(|p| p.x).fold(0.0, f64::min),
        Measured::BaseLength => across(&polygon(&part.outer), 0.0),
        Measured::BaseWidth => across(&polygon(&part.outer), PI / 2.0),
        Measured::BaseCorner => {
            let outer = polygon(&part.outer);
            let far = outer.iter().map(|p| p.x).fold(0.0, f64::max);
            far - holes(HolePurpose::Fixing).map(|hole| middle(&polygon(&hole.outline)).x).fold(0.0, f64::max)
        }
        Measured::Shoulder => across(&polygon(&widened().outline), 0.0),
        Measured::FixingHole => across(&first(HolePurpose::Fixing), 0.0),
        Measured::FixingLength | Measured::FixingWidth => {
            let middles: Vec<Point> = holes(HolePurpose::Fixing).map(|hole| middle(&polygon(&hole.outline))).collect();
            across(&middles, if what == Measured::FixingLength { 0.0 } else { PI / 2.0 })
        }
    })
}

#[test]
fn every_printed_dimension_is_measured_on_the_outlines() {
    let mut kinds = std::collections::BTreeSet::new();
    for (k, (sizes, mounting)) in designs().into_iter().enumerate() {
        // Polygons of many corners take long.
        if k % 5 != 0 && mounting.driver_hub.is_none() && sizes.mouth == Mouth::Sharp {
            continue;
        }
        let mounting = Mounting { is_stacked: k % 2 == 0, ..mounting };
        let list = parts(&sizes, 8.0, &mounting).unwrap().parts;
        for sheet in drawn(&sizes, &mounting, None) {
            for size in &sheet.dimensions {
                let Some(measured) = measure(&sheet, &sizes, &list, size.measured) else { continue };
                let number: String =
                    size.text.chars().filter(|c| c.is_ascii_digit() || *c == '.' || *c == ' ' || *c == 'R').collect();
                assert!(number.contains(&mm(size.nominal)), "{size:?}");
                let loose = 1e-4 * size.nominal.max(1.0);
                assert!((measured - size.nominal).abs() < loose, "{k}: {size:?}, but {measured}");
                assert!(sheet.ink.texts.iter().any(|text| text.text == size.text), "{size:?} is not on the sheet");
                kinds.insert(format!("{:?}", size.measured));
            }
        }
    }
    assert!(kinds.len() >= 30, "{}: {kinds:?}", kinds.len());
}

/// Tolerances of some size, which the layout of a sheet does not depend on: finding the right ones takes long.
fn some_tolerance(sizes: &Sizes) -> SharedTolerance {
    let size = 0.05 * sizes.play.slot;
    SharedTolerance {
        locking: size,
        nearer: size,
        farther: 1.3 * size,
        crank: size,
        width: 2.0 * size,
        direction: size / sizes.wheel_radius,
        slot_end: size,
    }
}

/// Whether a line crosses a box, in steps where it comes near.
fn crosses([a, b]: [Point; 2], [least, greatest]: [Point; 2]) -> bool {
    if a.x.min(b.x) >= greatest.x || a.x.max(b.x) <= least.x || a.y.min(b.y) >= greatest.y || a.y.max(b.y) <= least.y {
        return false;
    }
    (0..=64).any(|k| {
        let p = a + (b - a) * (f64::from(k) / 64.0);
        p.x > least.x && p.x < greatest.x && p.y > least.y && p.y < greatest.y
    })
}

/// Asserts that texts overlap nothing and all is inside the frame.
#[track_caller]
pub(super) fn assert_is_legible(sheet: &Sheet, name: &str) {
    assert!(sheet.has_room, "{name}");
    let ([least, greatest], _) = frame(sheet.paper);
    let inside = |p: &Point| {
        p.x >= least.x - 1e-9 && p.y >= least.y - 1e-9 && p.x <= greatest.x + 1e-9 && p.y <= greatest.y + 1e-9
    };
    for (at, text) in sheet.ink.texts.iter().enumerate() {
        assert!(text.corners.iter().all(inside), "{name}: {text:?}");
        for other in &sheet.ink.texts[..at] {
            let [[a, b], [c, d]] = [text.corners, other.corners];
            let is_apart = a.x >= d.x || c.x >= b.x || a.y >= d.y || c.y >= b.y;
            assert!(is_apart, "{name}: {text:?} and {other:?}");
        }
        for line in &sheet.ink.segments {
            assert!(!crosses(*line, text.corners), "{name}: {text:?} and {line:?}");
        }
    }
    assert!(sheet.ink.segments.iter().flatten().all(inside), "{name}");
}

#[test]
fn texts_overlap_nothing_and_all_is_inside_the_frame() {
    let mut papers = Vec::new();
    for (k, (sizes, mounting)) in designs().into_iter().enumerate() {
        let some = Some(some_tolerance(&sizes));
        let stacked = Mounting { is_stacked: true, ..mounting };
        // Half of the designs by each way, since all texts are held against all lines.
        let two = if k % 2 == 0 {
            [drawn(&sizes, &stacked, None), drawn_for(&sizes, &mounting, Process::Fdm, some)]
        } else {
            [drawn(&sizes, &mounting, some), drawn_for(&sizes, &stacked, Process::Laser, None)]
        };
        for drawn in two {
            for sheet in drawn {
                let name = format!("{k}: {:?} {} {}", sheet.layer, sizes.wheel.stations(), sizes.wheel.pins());
                assert_is_legible(&sheet, &name);
                papers.push((sheet.paper.name(), sheet.scale.to_string()));
            }
        }
    }
    papers.sort();
    papers.dedup();
    assert!(papers.len() > 6, "{papers:?}");
}

#[test]
fn with_all_limits_at_their_worst_nothing_touches() {
    let (mut tried, mut narrowed) = (0, 0);
    for (k, [stations, pins, crank, play]) in
        [[3, 1, 60, 4], [4, 1, 40, 3], [6, 2, 50, 4], [8, 1, 30, 2], [12, 1, 40, 3]].into_iter().enumerate()
    {
        // Play in tenths of a millimetre; the bores have much less.
        let slot = f64::from(play) / 10.0;
        let play = Play { slot, locking: slot, bore: 0.1 * slot, pin: 0.0 };
        let shaft = Some(2.0);
        let choices = Choices { play: Some(play), wheel_shaft: shaft, driver_shaft: shaft, ..Choices::default() };
        let wheel = Wheel::with_pins(stations, pins).unwrap();
        let Ok(sizes) = Sizes::new(wheel, Scale::CrankRadius(f64::from(crank)), &choices) else { panic!("{k}") };
        let mounting = Mounting { base: Some(BasePlate::default()), is_stacked: true, ..Mounting::default() };
        let shared = sizes.shared_tolerance().expect("room for errors");
        let chain = Chain::new(DrawnSizes::External(&sizes), Some(shared), false);
        assert!(chain.is_known, "{k}");
        let sheets = drawn(&sizes, &mounting, Some(shared));
        let limits = |layer, what: Measured| -> [f64; 2] {
            let of = sheets.iter().filter(|sheet| sheet.layer == Some(layer)).flat_map(|sheet| &sheet.dimensions);
            of.filter(|size| size.measured == what).find_map(|size| size.limits).expect("limits")
        };
        narrowed +=
            sheets.iter().flat_map(|sheet| &sheet.dimensions).filter(|size| size.origin == LimitOrigin::Chain).count();
        let bores = [Layer::Wheel, Layer::LockingDisc].map(|layer| limits(layer, Measured::Bore)[1]);
        // Each shaft is thinner by as much as its bore is wider; either moves its axis by half.
        let loose = sizes.play.bore + bores[0] + bores[1];
        let axes = limits(Layer::BasePlate, Measured::AxisDistance);
        let crank = limits(Layer::Plate, Measured::CrankRadius);
        // A slot that is off its place is narrower for the pin by as much on both sides.
        let off = sizes.wheel_radius * (chain.arc_zone / 2.0 / sizes.centre_distance) + chain.slot_zone / 2.0;
        let mut wrong = sizes;
        wrong.slot_width += limits(Layer::Wheel, Measured::SlotWidth)[0];
        wrong.pin_diameter += limits(Layer::Pins, Measured::Pin)[1];
        wrong.slot_end += limits(Layer::Wheel, Measured::SlotEnd)[1];
        wrong.locking_arc_radius += limits(Layer::Wheel, Measured::LockingArc)[0] - chain.arc_zone / 2.0;
        wrong.play.slot = wrong.slot_width - wrong.pin_diameter;
        wrong.tip_radius = libm::hypot(wrong.wheel_radius, wrong.slot_width / 2.0);
        let mut disc = wrong.locking_disc.unwrap();
        disc.radius += limits(Layer::LockingDisc, Measured::Disc)[1] / 2.0;
        let shift = crescent_shift(&disc);
        let radius = disc.crescent.radius + limits(Layer::LockingDisc, Measured::Crescent)[0];
        for (out, error) in [(1.0, -loose + axes[0]), (1.0, loose + axes[1]), (-1.0, -loose + axes[0])] {
            for by in crank {
                let centre = disc.crescent.centre + 2.0 * out * shift;
                // Where the circle of the cut meets the disc's rim.
                let cosine =
                    (disc.radius * disc.radius + centre * centre - radius * radius) / (2.0 * disc.radius * centre);
                let mut cut = disc;
                (cut.crescent.centre, cut.crescent.radius) = (centre, radius);
                cut.crescent.half_angle = libm::acos(cosine);
                let mut made = wrong;
                made.locking_disc = Some(cut);
                made.crank_radius += by;
                let found = made.clearance_at(sizes.centre_distance + error).unwrap().closest_approach();
                assert!(found.distance >= 0.0, "{k}: {} stations, {found:?} {error}", sizes.wheel.stations());
                // The direction takes a part of the gap at entry that the clearance of one slot doesn't know.
                assert!(2.0 * off < wrong.play.slot, "{k}");
                tried += 1;
            }
        }
    }
    assert!(tried == 30 && narrowed >= 15, "{tried} {narrowed}");
}

#[test]
fn limits_are_of_a_class_or_narrower_by_a_chain() {
    for (sizes, mounting) in designs() {
        let shared = Some(some_tolerance(&sizes));
        for size in drawn(&sizes, &mounting, shared).iter().flat_map(|sheet| &sheet.dimensions) {
            if let Some(class) = size.class {
                assert!(size.text.ends_with(&class.name()) && size.origin == LimitOrigin::Standard, "{size:?}");
                assert_eq!(size.limits, class.limits(size.nominal), "{size:?}");
            }
            if let Some([lower, upper]) = size.limits {
                assert!(lower <= upper, "{size:?}");
            }
        }
    }
}

#[test]
fn files_are_xml_true_to_scale_with_a_sheet_for_each_part() {
    let wheel = Wheel::with_pins(6, 2).unwrap();
    let sizes = Sizes::new(wheel, Scale::CrankRadius(40.0), &Choices::default()).unwrap();
    let text = SheetText { project: "A & <B>", ..TEXT };
    let limits = SheetLimits { shared: sizes.shared_tolerance(), ..SheetLimits::default() };
    let stacked = Mounting { is_stacked: true, ..Mounting::default() };
    let sheets = sheets(&sizes, 8.0, &stacked, &limits, &text).unwrap();
    let layers: Vec<Option<Layer>> = sheets.iter().map(|sheet| sheet.layer).collect();
    let parts = [Layer::Wheel, Layer::LockingDisc, Layer::Plate, Layer::Pins].map(Some);
    assert_eq!(layers, [&[None], &parts[..]].concat());
    for (text, count) in [(sheets[0].svg(), 1.0), (sheets_svg(&sheets), 5.0)] {
        let document = Document::parse(&text).unwrap();
        let root = document.root_element();
        let [width, height] = sheets[0].paper.size();
        assert_eq!(root.attribute("viewBox"), Some(format!("0 0 {width} {}", count * height).as_str()));
        assert_eq!(root.attribute("width"), Some(format!("{width}mm").as_str()));
        assert_eq!(root.attribute("height"), Some(format!("{}mm", count * height).as_str()));
    }
    let page = sheets_html(&sheets, text.project);
    assert_eq!(page.matches("<svg ").count(), 5);
    assert!(
        page.contains("A &amp; &lt;B>") && page.contains("@page { size: 420mm 297mm; margin: 0 }"),
        "{:?}",
        sheets[0].paper
    );
    // The rim is drawn as large as the scale says: the arcs of its radius.
    let radius = format!("A{:.6}", sizes.tip_radius * sheets[1].scale.factor());
    assert!(sheets[1].svg().contains(&radius), "{radius}");
}

#[test]
fn the_scale_is_the_largest_of_the_standard_that_fits() {
    for (paper, part, expected) in
        [(100.0, 100.0, "1:1"), (100.0, 100.1, "1:2"), (100.0, 1.0, "50:1"), (100.0, 9.9, "10:1")]
    {
        assert_eq!(DrawingScale::largest(paper, part).unwrap().to_string(), expected);
    }
    for wrong in [1e7, f64::NAN] {
        assert_eq!(DrawingScale::largest(100.0, wrong), None);
    }
}
