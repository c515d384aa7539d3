//! What is said of a wheel that was checked: whether it turns, where it is tight, and how the pin comes in.

use super::check_certainty::{ShallowSlot, TooCoarse};
use super::check_needs::{UnmeasuredSize, to_measure};
use crate::number_format::{count, number, to_digits};
use geneva_kinematics::wheel::as_built::{
    AsBuiltWheel, BuiltBlow, BuiltContact, BuiltTurn, Jam, MeasuredSize, StationTurn,
};

/// A size with its number, in words.
pub(super) fn named(size: MeasuredSize) -> String {
    size.number().map_or_else(|| size.name().to_owned(), |number| format!("{} {}", size.name(), number + 1))
}

/// A value in millimetres, or of a direction in degrees, with its unit and so many significant digits.
pub(super) fn with_unit(size: MeasuredSize, value: f64, digits: usize) -> String {
    let (value, unit) = typed(size, value);
    format!("{} {unit}", to_digits(value, digits))
}

pub(super) fn typed(size: MeasuredSize, value: f64) -> (f64, &'static str) {
    if matches!(size, MeasuredSize::SlotDirection(_)) { (value.to_degrees(), "°") } else { (value, "mm") }
}

fn contact(contact: BuiltContact) -> &'static str {
    match contact {
        BuiltContact::PinOnWall => "the pin on a wall of slot",
        BuiltContact::PinAtMouth => "the pin at the mouth of slot",
        BuiltContact::PinOnFace => "the pin on the face of the mouth of slot",
        BuiltContact::PinAtBottom => "the pin at the end of slot",
        BuiltContact::DiscInArc => "the disc in arc",
        BuiltContact::OpeningEdge => "an edge of the crescent in arc",
        BuiltContact::Crescent => "the crescent at a horn of arc",
        BuiltContact::Nothing => "nothing at slot",
    }
}

/// Between which parts a place is tight.
pub(super) fn place(tightest: &Jam) -> String {
    let [one, other] = [tightest.free.backward, tightest.free.forward]
        .map(|limit| format!("{} {}", contact(limit.contact), limit.part + 1));
    if one == other { one } else { format!("{one} and {other}") }
}

/// The stations at which the pin comes in on the corner of a mouth.
pub(super) fn corners(turn: &BuiltTurn) -> impl Iterator<Item = (&StationTurn, BuiltBlow)> {
    let entries = turn.stations.iter().filter_map(|station| Some((station, station.entry?)));
    entries.filter(|(_, entry)| entry.contact == BuiltContact::PinAtMouth)
}

/// What the pin meets as it comes in, the wheel in the middle of its play.
pub(super) fn entry_words(turn: &BuiltTurn) -> String {
    // Of blows that differ by rounding the first is taken.
    fn harder<'a>(
        one: (&'a StationTurn, BuiltBlow),
        other: (&'a StationTurn, BuiltBlow),
    ) -> (&'a StationTurn, BuiltBlow) {
        if other.1.centred > one.1.centred + 1e-9 { other } else { one }
    }
    let all = || turn.stations.iter().filter_map(|station| Some((station, station.entry?)));
    let Some((station, entry)) = corners(turn).reduce(harder).or_else(|| all().reduce(harder)) else {
        return "the pin meets nothing".to_owned();
    };
    let met = match entry.contact {
        BuiltContact::PinAtMouth => {
            let further = corners(turn).count() - 1;
            let also =
                if further == 0 { String::new() } else { format!(", and so at {}", count(further, "further slot")) };
            format!("the pin lands on the corner of the mouth of slot {}{also}", station.slot + 1)
        }
        BuiltContact::PinOnFace => format!("the pin lands on the face of the mouth of slot {}", station.slot + 1),
        BuiltContact::PinAtBottom => format!("the pin meets the end of slot {}", station.slot + 1),
        _ => format!("the pin meets a wall inside slot {}", station.slot + 1),
    };
    let late = entry.lost_motion.to_degrees();
    let sense = if late < 0.0 { "before" } else { "after" };
    format!(
        "{met}, {}° of the crank {sense} a right pin would enter, with {} of its speed",
        to_digits(late.abs(), 2),
        to_digits(entry.centred, 2)
    )
}

/// Whether the wheel turns, in words; it is open where sizes were not measured that decide it.
pub(super) fn turning_words(
    built: &AsBuiltWheel,
    turn: &BuiltTurn,
    coarse: Option<TooCoarse>,
    open: &[UnmeasuredSize],
) -> String {
    let lands = corners(turn).next().is_some();
    if !open.is_empty() {
        let filled_in = match &turn.jam {
            Some(jam) => format!(
                "As in the nearest right wheel, they would leave {} mm too little at a crank angle of {}°: {}",
                number(-jam.free.room()),
                number(jam.crank_angle.to_degrees()),
                place(jam)
            ),
            None if turn.misses() => "As in the nearest right wheel, they would never meet".to_owned(),
            None => "Nothing that was measured stops the wheel".to_owned(),
        };
        return format!("not known; measure {}. {filled_in}", to_measure(open));
    }
    match (&turn.jam, coarse) {
        (Some(_), Some(coarse)) => format!(
            "the measurements are too coarse for this wheel: {} mm seem to be missing, but with these uncertainties chance alone can \
             take {} mm; measure again, with uncertainties of {} of these or less",
            number(coarse.missing),
            number(coarse.by_chance),
            to_digits(coarse.finer, 2)
        ),
        (Some(jam), None) => format!(
            "no: {} mm are missing at a crank angle of {}°, pin {} and slot {}: {}",
            number(-jam.free.room()),
            number(jam.crank_angle.to_degrees()),
            jam.pin + 1,
            jam.slot + 1,
            place(jam)
        ),
        (None, _) if turn.misses() => format!("no: the pin never meets the wheel{}", beside_rim(built)),
        (None, _) if !turn.is_held() => {
            "no: nothing holds the wheel between two indexes, because the disc doesn't reach into the arcs, so a pin can meet its rim \
             beside a slot"
                .to_owned()
        }
        (None, _) if turn.can_miss() => {
            "yes, but the wheel can stand so in the dwell that a pin meets its rim beside the slot".to_owned()
        }
        (None, _) if lands => "yes, but the pin doesn't enter freely: it pushes the corner of a mouth aside".to_owned(),
        (None, _) => "yes, every station".to_owned(),
    }
}

/// How far a pin passes the wheel's rim, in words; empty where it doesn't pass outside.
fn beside_rim(built: &AsBuiltWheel) -> String {
    let reach = built.pins().iter().map(|pin| pin.crank_radius + pin.diameter / 2.0).fold(0.0, f64::max);
    let rim = built.slots().iter().map(|slot| slot.tip_radius).fold(0.0, f64::max);
    let gap = built.centre_distance - reach - rim;
    if gap > 0.0 { format!(": it passes {} mm outside the rim", number(gap)) } else { String::new() }
}

/// Which slots are too shallow, and by how much.
pub(super) fn shallow_words(shallow: &[ShallowSlot], slots: usize) -> String {
    let most = shallow.iter().map(|slot| slot.missing).fold(0.0, f64::max);
    let least = shallow.iter().map(|slot| slot.missing).fold(f64::INFINITY, f64::min);
    if shallow.is_empty() {
        return "deep enough for the pin".to_owned();
    }
    if shallow.len() == slots && most - least < ALIKE {
        return format!("all slots are {} mm too shallow for the pin", number(most));
    }
    let each: Vec<String> = shallow
        .iter()
        .map(|of| format!("slot {} is {} mm too shallow for the pin", of.slot + 1, number(of.missing)))
        .collect();
    each.join(", ")
}

/// Depths that differ by less than this, in millimetres, are alike.
const ALIKE: f64 = 1e-9;
