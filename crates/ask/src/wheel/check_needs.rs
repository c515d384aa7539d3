//! Which sizes a statement on a wheel that exists rests on, and which of these were not measured.
//!
//! What is not measured is filled in, so that the wheel can be followed round its turn. But a number that rests on a size that is
//! filled in says nothing of this wheel. So it isn't told: the measurements that would tell it are named instead.

use super::check_arguments::CHECK_ARGUMENTS;
use geneva_fields::joined_with_and;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{AsBuiltWheel, BuiltContact, BuiltTurn, Jam, MeasuredSize, MeasuredWheel};

/// What the play in mid-index rests on.
pub(super) const INDEX: &[MeasuredSize] = &[MeasuredSize::PinDiameter, MeasuredSize::SlotWidth(None)];

/// What the play in the dwell rests on.
pub(super) const DWELL: &[MeasuredSize] = &[MeasuredSize::DiscRadius, MeasuredSize::ArcRadius(None)];

/// What the pin's entry rests on: where and with which blow it meets the slot.
pub(super) const ENTRY: &[MeasuredSize] = &[
    MeasuredSize::CentreDistance,
    MeasuredSize::CrankRadius,
    MeasuredSize::TipRadius,
    MeasuredSize::PinDiameter,
    MeasuredSize::SlotWidth(None),
];

/// What the depth of the slots rests on.
pub(super) const DEPTH: &[MeasuredSize] = &[
    MeasuredSize::SlotEnd(None),
    MeasuredSize::CentreDistance,
    MeasuredSize::CrankRadius,
    MeasuredSize::PinDiameter,
    MeasuredSize::SlotWidth(None),
];

/// A size that was not measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct UnmeasuredSize {
    /// Which size.
    size: MeasuredSize,
    /// Of which slots or arcs, from 0; of all if there are none.
    numbers: Vec<usize>,
}

impl UnmeasuredSize {
    /// The option with which it is given, without hyphens.
    pub(super) fn option(&self) -> &'static str {
        // Of two for one size, as for the rim, the first is what a calliper measures.
        CHECK_ARGUMENTS.iter().find(|argument| argument.size_of_all() == self.size).map_or("", |argument| argument.name)
    }

    /// Whether it was measured of no slot or arc at all.
    pub(super) fn is_of_all(&self) -> bool {
        self.numbers.is_empty()
    }

    /// A size that was measured of no slot or arc.
    pub(super) fn of_all(size: MeasuredSize) -> Self {
        Self { size, numbers: Vec::new() }
    }

    /// Its name and its option: `pin diameter (--pin-diameter)`.
    pub(super) fn words(&self) -> String {
        // It is measured across.
        let name = if self.size == MeasuredSize::TipRadius { "outside diameter" } else { self.size.name() };
        let numbers: Vec<String> = self.numbers.iter().map(|number| (number + 1).to_string()).collect();
        let of = if numbers.is_empty() { String::new() } else { format!(" of number {}", joined_with_and(&numbers)) };
        format!("{name}{of} (--{})", self.option())
    }
}

/// The measurements to make, in words: `the pin diameter (--pin-diameter) and the slot width (--slot-width)`.
pub(super) fn to_measure(missing: &[UnmeasuredSize]) -> String {
    joined_with_and(&missing.iter().map(|of| format!("the {}", of.words())).collect::<Vec<_>>())
}

/// The options of the measurements to make, in words: `--pin-diameter and --slot-width`.
pub(super) fn options(missing: &[UnmeasuredSize]) -> String {
    joined_with_and(&missing.iter().map(|of| format!("--{}", of.option())).collect::<Vec<_>>())
}

/// Whether a measured size is what is needed: a number counts for itself only.
fn is_it(needed: MeasuredSize, size: MeasuredSize, number: Option<usize>) -> bool {
    use MeasuredSize as Size;
    let is_same = needed.name() == size.name() && (size.number().is_none() || size.number() == number);
    // Arcs are about the driver's axis, so their centres say where it belongs.
    is_same || (needed == Size::CentreDistance && matches!(size, Size::ArcCentre(_)))
}

/// Whether a size was measured, of the slot or arc with this number.
pub(super) fn is_measured(measured: &MeasuredWheel, needed: MeasuredSize, number: Option<usize>) -> bool {
    measured.sizes().iter().any(|of| is_it(needed, of.size, number))
}

/// Which of these sizes were not measured, in their order.
pub(super) fn unmeasured(measured: &MeasuredWheel, needed: &[MeasuredSize]) -> Vec<UnmeasuredSize> {
    use MeasuredSize as Size;
    let missing = needed.iter().filter_map(|size| {
        if !matches!(size, Size::SlotWidth(_) | Size::SlotEnd(_) | Size::ArcRadius(_)) {
            return (!is_measured(measured, *size, None)).then(|| UnmeasuredSize { size: *size, numbers: Vec::new() });
        }
        let count = measured.wheel().stations() as usize;
        let numbers: Vec<usize> = (0..count).filter(|number| !is_measured(measured, *size, Some(*number))).collect();
        let of_all = if numbers.len() == count { Vec::new() } else { numbers.clone() };
        (!numbers.is_empty()).then_some(UnmeasuredSize { size: *size, numbers: of_all })
    });
    missing.collect()
}

/// The sizes that decide where a wheel jams so, not counting the places of the axes.
fn deciding(contact: BuiltContact) -> &'static [MeasuredSize] {
    use MeasuredSize as Size;
    match contact {
        BuiltContact::PinOnWall => INDEX,
        BuiltContact::PinAtMouth | BuiltContact::PinOnFace => ENTRY,
        BuiltContact::PinAtBottom => DEPTH,
        BuiltContact::DiscInArc => DWELL,
        BuiltContact::OpeningEdge => {
            &[Size::DiscRadius, Size::ArcRadius(None), Size::CrescentCentre, Size::CrescentRadius]
        }
        BuiltContact::Crescent => &[Size::CrescentCentre, Size::CrescentRadius, Size::TipRadius, Size::ArcRadius(None)],
        BuiltContact::Nothing => &[],
    }
}

/// The sizes on which it rests that a wheel jams at a place, and that were not measured: none if the jam is certain.
pub(super) fn unmeasured_at(measured: &MeasuredWheel, jam: &Jam) -> Vec<UnmeasuredSize> {
    let mut missing: Vec<UnmeasuredSize> = Vec::new();
    let limits = [jam.free.backward, jam.free.forward];
    // A pin between the walls of one slot is too thick wherever the axes are; all else jams only with the axes where they are.
    let is_of_axes = limits.iter().any(|limit| limit.contact != BuiltContact::PinOnWall);
    let axes: &[MeasuredSize] =
        if is_of_axes { &[MeasuredSize::CentreDistance, MeasuredSize::CrankRadius] } else { &[] };
    for limit in limits {
        for size in axes.iter().chain(deciding(limit.contact)) {
            let number = numbered(*size).then_some(limit.part);
            let is_known = is_measured(measured, *size, number) || missing.iter().any(|of| of.size == *size);
            if !is_known {
                let numbers = number.filter(|_| unmeasured(measured, &[*size]).iter().any(|of| !of.numbers.is_empty()));
                missing.push(UnmeasuredSize { size: *size, numbers: numbers.into_iter().collect() });
            }
        }
    }
    missing
}

/// The sizes without which it is open whether a wheel turns, as far as they were not measured: none if it is known.
pub(super) fn unmeasured_of_verdict(
    measured: &MeasuredWheel,
    built: &AsBuiltWheel,
    turn: &BuiltTurn,
) -> Vec<UnmeasuredSize> {
    let are_measured = |sizes: &[MeasuredSize]| unmeasured(measured, sizes).is_empty();
    let axes = [MeasuredSize::CentreDistance, MeasuredSize::CrankRadius];
    let all = unmeasured_to_turn(measured, built);
    match &turn.jam {
        Some(jam) => {
            let mut at_jam = unmeasured_at(measured, jam);
            if !at_jam.is_empty() {
                let others = all.into_iter().filter(|of| at_jam.iter().all(|known| known.size != of.size));
                at_jam = others.chain(at_jam.clone()).collect();
            }
            at_jam
        }
        None if turn.misses() && are_measured(&axes) => Vec::new(),
        None if !turn.is_held() && are_measured(&[&axes[..1], DWELL].concat()) => Vec::new(),
        None => all,
    }
}

fn numbered(size: MeasuredSize) -> bool {
    matches!(size, MeasuredSize::SlotWidth(_) | MeasuredSize::SlotEnd(_) | MeasuredSize::ArcRadius(_))
}

/// The sizes without which nobody can say that a wheel turns, and that were not measured.
pub(super) fn unmeasured_to_turn(measured: &MeasuredWheel, built: &AsBuiltWheel) -> Vec<UnmeasuredSize> {
    unmeasured(measured, ENTRY).into_iter().chain(of_disc(measured, built)).collect()
}

/// What was not measured of disc and arcs; nothing of a wheel without a disc.
fn of_disc(measured: &MeasuredWheel, built: &AsBuiltWheel) -> Vec<UnmeasuredSize> {
    if built.disc_radius.is_some() { unmeasured(measured, DWELL) } else { Vec::new() }
}

/// What the play between two indexes rests on: disc and arc, or pin and slot where one pin enters as another leaves.
pub(super) fn dwell(built: &AsBuiltWheel) -> &'static [MeasuredSize] {
    if built.disc_radius.is_some() { DWELL } else { INDEX }
}

/// All sizes that a wheel is filled in with where they are not measured.
pub(super) fn all_sizes(built: &AsBuiltWheel) -> Vec<MeasuredSize> {
    use MeasuredSize as Size;
    let of_disc: &[&[Size]] = &[DWELL, &[Size::CrescentCentre, Size::CrescentRadius]];
    let of_disc = if built.disc_radius.is_some() { of_disc.concat() } else { Vec::new() };
    [ENTRY, &[Size::SlotEnd(None)], &of_disc].concat()
}

/// The sizes that count as right because they were not measured, in words: they can make a wheel jam, but seldom do. None if all were.
pub(super) fn taken_as_right(measured: &MeasuredWheel, built: &AsBuiltWheel) -> Option<String> {
    use MeasuredSize as Size;
    let is_missing = |sizes: &[Size]| !unmeasured(measured, sizes).is_empty();
    // Where only the centres of the arcs were, they stand for it.
    let is_of_arcs = !measured.sizes().iter().any(|of| of.size == Size::CentreDistance);
    let all = [
        ("the centre distance", is_of_arcs),
        ("the ends of the slots", is_missing(&[Size::SlotEnd(None)])),
        (
            "the cut in the disc",
            built.disc_radius.is_some() && is_missing(&[Size::CrescentCentre, Size::CrescentRadius]),
        ),
    ];
    let named: Vec<String> = all.into_iter().filter(|(_, is)| *is).map(|(name, _)| name.to_owned()).collect();
    let is_one = named.len() == 1 && !named[0].starts_with("the ends");
    let (verb, counts) = if is_one { ("was", "counts") } else { ("were", "count") };
    (!named.is_empty()).then(|| format!("{} {verb} not measured and {counts} as right", joined_with_and(&named)))
}
