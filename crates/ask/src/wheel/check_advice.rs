//! Which part to make new or to work over, in words, and the command that designs it.
//!
//! Work takes material away and brings none back: a narrow slot can be made wider, but a worn one needs a new wheel, or a thicker pin.

use super::check_words::{named, with_unit};
use super::design::WheelDesign;
use super::question::WheelQuestion;
use crate::number_format::{as_typed, number};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{MeasuredSize, MeasuredWheel, NearestWheel, SizeChange};

/// What to do so that a part has a size, in words. The value in millimetres or radians has so many significant digits; `measured` is what
/// the part has now, in the same unit.
pub(super) fn part_words(size: MeasuredSize, measured: f64, value: f64, digits: usize) -> String {
    use MeasuredSize as Size;
    let is_smaller = measured > value;
    let told = with_unit(size, value, digits);
    let across = format!("{} mm", crate::number_format::to_digits(2.0 * value, digits));
    let which = |all: &str, one: &str| match size.number() {
        Some(number) => format!("{one} {}", number + 1),
        None => all.to_owned(),
    };
    match size {
        Size::CentreDistance => format!("put the axes {told} apart, in a new plate if they can't be moved"),
        Size::CrankRadius => format!("make a new driver with the pin {told} from its axis"),
        Size::PinDiameter | Size::NewPinDiameter => format!("make a new pin with a diameter of {told}"),
        Size::TipRadius if is_smaller => format!("turn the wheel down to an outside diameter of {across}"),
        Size::TipRadius => format!("make a new wheel with an outside diameter of {across}"),
        Size::SlotWidth(_) if !is_smaller => format!("widen {} to {told}", which("the slots", "slot")),
        Size::SlotWidth(_) | Size::NewSlotWidth => {
            format!("make a new wheel with slots of {told}, because {}", which("slots get no narrower", "slot"))
                + if size.number().is_some() { " gets no narrower" } else { "" }
        }
        Size::SlotEnd(_) if is_smaller => {
            format!(
                "make {} deeper until the round end's centre is {told} from the wheel's axis",
                which("the slots", "slot")
            )
        }
        Size::SlotEnd(_) => format!("make a new wheel with the slots' round ends {told} from its axis"),
        Size::SlotDirection(_) => {
            format!("make a new wheel with {} in its right direction", which("each slot", "slot"))
        }
        Size::ArcRadius(_) if !is_smaller => {
            format!("open {} to a radius of {told}", which("the locking arcs", "locking arc"))
        }
        Size::ArcRadius(_) | Size::NewArcRadius => format!("make a new wheel with locking arcs of a radius of {told}"),
        Size::ArcCentre(_) => format!("make a new wheel with the locking arcs' centres {told} from its axis"),
        Size::DiscRadius if is_smaller => format!("turn the locking disc down to a radius of {told}"),
        Size::DiscRadius | Size::NewDiscRadius => {
            format!("make a new driver with a locking disc of a radius of {told}")
        }
        Size::CrescentCentre => format!("make a new driver with the centre of its cut {told} from its axis"),
        Size::CrescentRadius if !is_smaller => format!("widen the cut in the disc to a radius of {told}"),
        Size::CrescentRadius => format!("make a new driver with a cut of a radius of {told}"),
    }
}

/// What to do for a change of one size, in words.
pub(super) fn change_words(change: SizeChange) -> String {
    use MeasuredSize as Size;
    let by = number(change.by.abs());
    let work = match (change.size, change.by > 0.0) {
        (Size::CentreDistance, true) => format!("put the axes {by} mm farther apart"),
        (Size::CentreDistance, false) => format!("put the axes {by} mm nearer to each other"),
        (Size::PinDiameter, false) => format!("make a new pin, {by} mm thinner"),
        (Size::SlotWidth(_), true) => format!("make the slots {by} mm wider"),
        (Size::SlotEnd(_), false) => format!("make the slots {by} mm deeper"),
        (Size::ArcRadius(_), true) => format!("make the radius of the locking arcs {by} mm larger"),
        (Size::DiscRadius, false) => format!("turn {by} mm off the locking disc's radius"),
        (Size::CrescentRadius, true) => format!("make the radius of the cut in the disc {by} mm larger"),
        (Size::TipRadius, false) => format!("turn {by} mm off the radius of the rim"),
        (size, is_larger) => {
            format!("make the {} {by} mm {}", named(size), if is_larger { "larger" } else { "smaller" })
        }
    };
    format!("{work}, and a little more for play")
}

/// Parts to design: sizes in millimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PartSizes {
    pub centre_distance: f64,
    pub pin_diameter: f64,
    pub slot_width: f64,
    pub slot_end: f64,
    pub arc_radius: f64,
    pub disc_radius: f64,
    pub crank_radius: f64,
}

impl From<&NearestWheel> for PartSizes {
    fn from(nearest: &NearestWheel) -> Self {
        Self {
            centre_distance: nearest.centre_distance,
            pin_diameter: nearest.pin_diameter,
            slot_width: nearest.slot_width,
            slot_end: nearest.slot_end,
            arc_radius: nearest.arc_radius,
            disc_radius: nearest.disc_radius,
            crank_radius: nearest.crank_radius,
        }
    }
}

/// The arguments of `geneva wheel` that design parts of these sizes, as far as they were measured; none if no wheel can be designed so.
pub(super) fn design_arguments(measured: &MeasuredWheel, sizes: &PartSizes) -> Option<String> {
    use MeasuredSize as Size;
    let [has_pin, has_slot, has_arc, has_disc] = measured_of_fit(measured);
    let wheel = measured.wheel();
    let pins = if wheel.pins() > 1 { format!(" --pins {}", wheel.pins()) } else { String::new() };
    let mut options =
        vec![format!("--stations {}{pins} --centre-distance {}", wheel.stations(), typed(sizes.centre_distance))];
    if has_pin || has_slot {
        options.push(format!("--pin-diameter {}", typed(sizes.pin_diameter)));
    }
    if has_slot && sizes.slot_width > sizes.pin_diameter {
        options.push(format!("--slot-width {}", typed(sizes.slot_width)));
    }
    if has_arc || has_disc {
        options.push(format!("--locking-arc-radius {}", typed(sizes.arc_radius)));
    }
    if has_arc && has_disc && sizes.arc_radius > sizes.disc_radius {
        options.push(format!("--locking-play {}", typed(2.0 * (sizes.arc_radius - sizes.disc_radius))));
    }
    let clearance = sizes.centre_distance - sizes.crank_radius - sizes.slot_end;
    if measured.sizes().iter().any(|of| matches!(of.size, Size::SlotEnd(_))) && clearance > 0.0 {
        options.push(format!("--bottom-clearance {}", typed(clearance)));
    }
    // What can't be designed with all of them may be with fewer, the first of which count most.
    (1..=options.len())
        .rev()
        .map(|count| options[..count].join(" "))
        .find(|arguments| WheelQuestion::parse(arguments).and_then(WheelDesign::new).is_ok())
}

/// Whether pin, slots, locking arcs and disc were measured, as they are or when they were new.
fn measured_of_fit(measured: &MeasuredWheel) -> [bool; 4] {
    use MeasuredSize as Size;
    let has = |is_it: fn(Size) -> bool| measured.sizes().iter().any(|of| is_it(of.size));
    [
        has(|size| matches!(size, Size::PinDiameter | Size::NewPinDiameter)),
        has(|size| matches!(size, Size::SlotWidth(_) | Size::NewSlotWidth)),
        has(|size| matches!(size, Size::ArcRadius(_) | Size::NewArcRadius)),
        has(|size| matches!(size, Size::DiscRadius | Size::NewDiscRadius)),
    ]
}

/// Which size of a design command nobody measured, and whence it comes; none if all were measured.
pub(super) fn design_remark(measured: &MeasuredWheel) -> Option<String> {
    let [has_pin, has_slot, has_arc, has_disc] = measured_of_fit(measured);
    let pin = (has_slot && !has_pin).then_some("the pin, which was not measured, is given the usual play in the slots");
    let arc = (has_disc && !has_arc)
        .then_some("the locking arcs, which were not measured, are given the usual play on the disc");
    let all: Vec<&str> = pin.into_iter().chain(arc).collect();
    (!all.is_empty()).then(|| all.join("; "))
}

/// A length in millimetres to a thousandth, as it is typed.
fn typed(length: f64) -> String {
    as_typed((1e3 * length).round() / 1e3)
}
