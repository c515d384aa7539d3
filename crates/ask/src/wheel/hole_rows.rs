//! The holes of all parts, as the drawings have them: sizes with limits, and what goes through them.

use super::design::WheelDesign;
use crate::{FieldValue, Needs, ReportField};
use geneva_workshop::{
    Fastener, HolePurpose, Layer, Measured, Mounting, PinMount, PrintedDimension, ScrewHole, Thread,
};

/// The field of the holes of all parts: a text for each part that has some; missing without a size, and of a wheel without parts.
pub(super) fn holes(design: &WheelDesign) -> ReportField {
    let found = holes_of_parts(design);
    let words = found.as_ref().map(|parts| parts.join("; ")).filter(|words| !words.is_empty());
    let texts = found.map(|parts| parts.into_iter().map(FieldValue::Text).collect::<Vec<_>>());
    let field = ReportField::new("holes", texts).needing(Needs::SIZE);
    match words {
        Some(words) => field.words("holes", words),
        None => field,
    }
}

fn holes_of_parts(design: &WheelDesign) -> Option<Vec<String>> {
    let list = design.makeable_parts().ok()??;
    let mut holes = list.parts.iter().flat_map(|part| &part.holes);
    // Drawings take a while; a pin's own hole and the inside of a ring are among the sizes above.
    if holes.all(|hole| matches!(hole.purpose, HolePurpose::Pin | HolePurpose::Inside)) {
        return Some(Vec::new());
    }
    let mounting = design.mounting().ok()?;
    let Ok(sheets) = design.drawings() else { return Some(Vec::new()) };
    let of_part = |layer: Layer, dimensions: &[PrintedDimension]| {
        let holes: Vec<String> =
            dimensions.iter().filter_map(|dimension| hole_words(dimension, layer, &mounting)).collect();
        let part = list.parts.iter().find(|part| part.layer == layer).map_or(layer.words(), |part| part.words());
        (!holes.is_empty()).then(|| format!("{part}: {}", holes.join(", ")))
    };
    Some(sheets.iter().filter_map(|sheet| of_part(sheet.layer?, &sheet.dimensions)).collect())
}

/// A dimension of a hole in words; none of anything else.
fn hole_words(dimension: &PrintedDimension, layer: Layer, mounting: &Mounting) -> Option<String> {
    let hub = if matches!(layer, Layer::Wheel | Layer::RingPlate) { mounting.wheel_hub } else { mounting.driver_hub };
    let (before, behind) = match dimension.measured {
        Measured::Bore => ("bore", String::new()),
        // Its text says what it is.
        Measured::KeywayWidth => ("", String::new()),
        Measured::AcrossBore => ("to the opposite side", String::new()),
        Measured::HubHole => ("hub", hub.map_or_else(String::new, |hub| fastener_words(hub.fastener))),
        Measured::DowelHole => ("dowels", String::new()),
        Measured::PinHole if layer == Layer::Pins => ("hole", screw_words(mounting.pins, true)),
        Measured::PinHole => ("pin", screw_words(mounting.pins, false)),
        Measured::NutWidth => ("nut's pocket", String::new()),
        Measured::PocketDepth => ("deep", String::new()),
        Measured::Shoulder => ("shoulder", String::new()),
        Measured::FixingHole => {
            let screw = mounting.base.and_then(|base| base.screws);
            ("fixing", screw.map_or_else(String::new, |screw| through_words(screw, ScrewHole::Clearance)))
        }
        _ => return None,
    };
    let limits = dimension.limit_text().map_or_else(String::new, |limits| format!(" ({limits})"));
    Some(format!("{before} {}{limits}{behind}", dimension.text).trim_start().to_owned())
}

fn fastener_words(fastener: Fastener) -> String {
    match fastener {
        Fastener::Dowel(_) => " for dowels".to_owned(),
        Fastener::Screw(thread, hole) => through_words(thread, hole),
    }
}

fn screw_words(pins: PinMount, is_bush: bool) -> String {
    match pins {
        PinMount::Solid => String::new(),
        PinMount::Dowel => " for a dowel".to_owned(),
        PinMount::Screw(thread, _) if is_bush => through_words(thread, ScrewHole::Clearance),
        PinMount::Screw(thread, hole) => through_words(thread, hole),
    }
}

fn through_words(thread: Thread, hole: ScrewHole) -> String {
    match hole {
        ScrewHole::Clearance => format!(" clearance for {}", thread.name()),
        ScrewHole::Tapped => format!(" to be tapped {}", thread.name()),
        ScrewHole::NutTrap => format!(" clearance for {}, with a nut's pocket", thread.name()),
    }
}

#[cfg(test)]
mod tests {
    use crate::wheel::{WheelDesign, WheelQuestion};
    use crate::{FieldValue, answer};
    use geneva_kinematics::wheel::as_built::SplitMix64;
    use geneva_workshop::{HolePurpose, Part};
    use std::collections::BTreeMap;

    /// Holes of a part by what they are for and their diameter in hundredths of a millimetre; of a hole that isn't round, 0.
    fn drawn(part: &Part) -> BTreeMap<(&'static str, i64), usize> {
        let mut holes = BTreeMap::new();
        for hole in part.holes.iter().filter(|hole| hole.purpose != HolePurpose::Inside) {
            let name = match hole.purpose {
                HolePurpose::Bore => "bore ",
                HolePurpose::Pin => "pin ",
                HolePurpose::PinScrew if part.layer == geneva_workshop::Layer::Pins => "hole ",
                HolePurpose::PinScrew => "pin ",
                HolePurpose::Hub => "hub ",
                HolePurpose::DiscDowel => "dowels ",
                _ => "fixing ",
            };
            let diameter = hole.diameter().map_or(0, |diameter| libm::round(100.0 * diameter) as i64);
            *holes.entry((name, diameter)).or_default() += 1;
        }
        holes
    }

    /// Whether an entry of the list is of so many holes of this diameter.
    fn is_listed(entries: &[&str], (name, hundredths): (&str, i64), count: usize) -> bool {
        entries.iter().filter_map(|entry| entry.strip_prefix(name)).any(|rest| {
            let (number, size) = rest.split_once("× ").unwrap_or(("1", rest));
            let diameter =
                size.trim_start_matches('Ø').split([' ', '°']).next().and_then(|text| text.parse::<f64>().ok());
            let is_it =
                diameter.is_some_and(|found| hundredths == 0 || (100.0 * found - hundredths as f64).abs() < 5.1);
            is_it && number.parse() == Ok(count)
        })
    }

    #[test]
    fn every_hole_of_the_files_is_listed_with_its_limits() {
        let mut random = SplitMix64::new(3);
        let mut one_of = |all: &[&'static str]| all[(random.next_u64() % all.len() as u64) as usize];
        let (mut tried, mut holes) = (0, BTreeMap::<&str, u32>::new());
        while tried < 20 {
            let kind = one_of(&["", "", "--type internal"]);
            let words = [
                one_of(&["--stations 4", "--stations 6", "--stations 8"]),
                kind,
                one_of(&[
                    "",
                    "--wheel-shaft 12",
                    "--wheel-shaft 12 --wheel-bore-shape key",
                    "--wheel-shaft 12 --wheel-flat 11",
                ]),
                one_of(&["", "--plate-shaft 10", "--plate-shaft 10 --driver-bore-shape key"]),
                one_of(&["", "--wheel-hub-circle 26", "--wheel-hub-circle 30 --driver-hub-circle 24"]),
                one_of(&[
                    "",
                    "--hub-screw M3",
                    "--hub-screw M4 --hub-screw-hole tapped",
                    "--hub-screw M3 --hub-screw-hole nut-trap",
                    "--hub-dowel 3 --hub-holes 4",
                ]),
                one_of(&[
                    "",
                    "--pin-mount dowel",
                    "--pin-diameter 8 --pin-screw M4",
                    "--pin-diameter 5 --pin-screw M5 --pin-screw-hole nut-trap",
                    "--pin-diameter 4 --pin-screw M4 --pin-screw-hole tapped",
                ]),
                one_of(&[
                    "",
                    "--disc-dowel 2 --disc-dowel-circle 16",
                    "--disc-dowel 3 --disc-dowel-circle 40 --disc-dowels 3",
                    "--disc-dowel 3 --disc-dowel-circle 250 --disc-dowels 6",
                ]),
                one_of(&[
                    "",
                    "--base-thickness 8 --base-screw M4",
                    "--base-thickness 8 --shoulder-diameter 16 --shoulder-depth 3",
                ]),
                one_of(&["", "--process laser", "--driver-pieces two-pieces"]),
            ];
            let text = format!("{} --crank-radius 60 --thickness 10", words.join(" "));
            let made = WheelQuestion::parse(&text).and_then(WheelDesign::new);
            let Some(design) = made.ok().filter(|design| design.makeable_parts().is_ok()) else { continue };
            let Ok(Some(list)) = design.part_list() else { continue };
            let purposes = list.parts.iter().flat_map(|part| &part.holes).map(|hole| hole.purpose);
            if purposes.clone().all(|of| matches!(of, HolePurpose::Pin | HolePurpose::Inside)) {
                continue;
            }
            tried += 1;
            let listed = super::holes_of_parts(&design).expect("a list");
            // Pins in one piece with the plate fill their holes.
            let fills = |part: &Part| part.layer == geneva_workshop::Layer::Pins && part.is_joined;
            let is_filled = list.parts.iter().any(fills);
            for part in &list.parts {
                let start = format!("{}: ", part.words());
                let entries = listed.iter().find_map(|row| row.strip_prefix(&start)).unwrap_or_default();
                let entries: Vec<&str> = entries.split(", ").collect();
                for (hole, count) in drawn(part).into_iter().filter(|(hole, _)| hole.0 != "pin " || !is_filled) {
                    assert!(
                        is_listed(&entries, hole, count),
                        "{text}: {count} {hole:?} of the {}: {listed:?}",
                        part.words()
                    );
                    *holes.entry(hole.0).or_default() += 1;
                }
            }
        }
        assert!(holes.len() == 6 && holes.values().all(|count| *count > 2), "{holes:?}");
    }

    #[test]
    fn the_sheet_has_the_holes_with_their_limits_and_what_goes_through_them() {
        let of = |more: &str| {
            let question = format!("wheel --stations 6 --crank-radius 40 --thickness 6 {more}");
            let report = answer(&question).expect(&question);
            let field = report.field("holes").expect("a field");
            match &field.value {
                FieldValue::List(_) => field.line.as_ref().map_or_else(String::new, |line| line.meaning.to_string()),
                other => panic!("{other:?}"),
            }
        };
        assert_eq!(of(""), "");
        let all = of(
            "--wheel-shaft 8 --wheel-bore-shape key --driver-shaft 6 --driver-flat 5 --pin-diameter 8 --pin-screw M5 \
                      --wheel-hub-circle 26 --hub-screw M3 --hub-screw-hole tapped --base-thickness 8 --base-screw M4",
        );
        for words in [
            "wheel: bore Ø8.0",
            "keyway 2",
            "to be tapped M3",
            "Ø5.5",
            "clearance for M5",
            "fixing 4× Ø4.5 clearance for M4",
        ] {
            assert!(all.contains(words), "{words}: {all}");
        }
        assert!(!all.contains("keyway keyway"), "{all}");
        assert!(of("--type internal --wheel-shaft 8 --process fdm").contains("ring plate: bore Ø8.4 (±0.2)"));
    }
}
