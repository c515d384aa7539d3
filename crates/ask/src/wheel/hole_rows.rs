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
        Measured::KeywayWidth => ("keyway", String::new()),
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
    Some(format!("{before} {}{limits}{behind}", dimension.text))
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
    use crate::{FieldValue, answer};

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
        assert!(of("--type internal --wheel-shaft 8 --process fdm").contains("ring plate: bore Ø8.4 (±0.2)"));
    }
}
