//! The parts of an internal wheel in millimetres, as they are reported: under the keys of an external wheel where they mean the same.

use super::design::WheelDesign;
use super::looseness::PLAY_ON_FLAT;
use crate::{Error, Needs, ReportField, Rounding};
use geneva_kinematics::internal_sizes::InternalSizes;
use geneva_kinematics::wheel::SharedTolerance;
use geneva_workshop::{Mounting, ShaftFit};

fn mm(key: &'static str, length: f64) -> ReportField {
    ReportField::in_unit(key, length, "mm").needing(Needs::SIZE)
}

/// The fields, each in the place of one with the same key, or else behind the one before it.
pub(super) fn merged(mut fields: Vec<ReportField>, ring: Vec<ReportField>) -> Vec<ReportField> {
    let mut last = 0;
    for field in ring {
        match fields.iter().position(|other| other.key == field.key) {
            Some(at) => {
                fields[at] = field;
                last = at;
            }
            None => {
                last = (last + 1).min(fields.len());
                fields.insert(last, field);
            }
        }
    }
    fields
}

/// The fields of the parts; none of a wheel of another kind, without a size, and where the parts that the program chose don't fit.
///
/// # Errors
///
/// Choices that fit no such wheel.
pub(super) fn parts(design: &WheelDesign) -> Result<Vec<ReportField>, Error> {
    let Some(sizes) = design.reported_internal_sizes()? else { return Ok(Vec::new()) };
    let InternalSizes { play, segment_radii: [outer, inner], .. } = sizes;
    let shaft = |key, diameter: f64| ReportField::in_unit(key, Some(diameter).filter(|shaft| *shaft > 0.0), "mm");
    let of_wheel = Needs::SIZE.union(Needs::WHEEL_SHAFT);
    let of_driver = Needs::SIZE.union(Needs::DRIVER_SHAFT);
    let mut fields = vec![
        mm("pin_diameter_mm", sizes.pin_diameter).line("pin diameter", "of the driver's pin"),
        mm("play_mm", play.slot).line("play", "how much wider a slot is than the pin"),
        mm("locking_play_mm", play.locking).line(
            "locking play",
            "how much wider a locking arc is than the locking segment, as a difference of diameters",
        ),
        mm("bore_play_mm", play.bore).line("bore play", "how much wider bores are than the shafts that run in them"),
        mm("axial_play_mm", design.axial_play_of_internal(&sizes))
            .line("axial play", "gap between ring and plate along the axes"),
        mm("slot_width_mm", sizes.slot_width).line("slot width", "pin diameter plus play"),
        mm("slot_end_mm", sizes.slot_end).line("slot end", "wheel's axis to the centre of the round end"),
        mm("slot_depth_mm", sizes.slot_end + sizes.slot_width / 2.0 - sizes.wheel_radius)
            .line("slot depth", "from the wheel radius to the bottom of its round end"),
        mm("bottom_clearance_mm", sizes.slot_end - sizes.centre_distance - sizes.crank_radius)
            .line("bottom clearance", "how much deeper the slot is than pin and play need"),
        mm("tip_radius_mm", sizes.mouth_radius)
            .line("inner radius", "wheel's axis to the corners of the slots: inside the ring"),
        mm("outside_diameter_mm", 2.0 * sizes.outside_radius).line("outside diameter", "of ring and ring plate"),
        mm("horn_thickness_mm", sizes.horn_thickness)
            .line("horn thickness", "least thickness between a slot and a locking arc"),
        mm("locking_arc_radius_mm", sizes.locking_arc_radius)
            .line("locking arc radius", "its centre is at the centre distance, half a pitch from a slot"),
        mm("locking_radius_mm", outer)
            .line("locking segment", "outer radius: that of the locking arc, less the play on one side"),
        mm("segment_inner_radius_mm", inner).line("", "inner radius, which the horns pass"),
        ReportField::in_unit("segment_angle_deg", 2.0 * sizes.segment_half_angle().to_degrees(), "°")
            .line("", "from end to end, seen from the driver's axis")
            .needing(Needs::SIZE),
        mm("plate_radius_mm", sizes.plate_radius).line("plate radius", "of the driver, behind the ring"),
        shaft("wheel_shaft_mm", sizes.wheel_shaft).needing(of_wheel).line("wheel shaft", "diameter, in the ring plate"),
        shaft("wheel_bore_mm", sizes.bore(sizes.wheel_shaft))
            .needing(of_wheel)
            .line("wheel bore", "diameter: shaft plus bore play"),
        shaft("plate_shaft_mm", sizes.plate_shaft)
            .needing(of_driver)
            .line("plate shaft", "driver's shaft in the plate, diameter"),
        shaft("plate_bore_mm", sizes.bore(sizes.plate_shaft))
            .needing(of_driver)
            .line("plate bore", "diameter: shaft plus bore play"),
    ];
    if let Some(thickness) = design.question.thickness {
        fields.push(mm("thickness_mm", thickness).line("thickness", "of ring, ring plate, locking segment and plate"));
    }
    Ok(fields)
}

/// The fields of how loosely parts are held; none as of the parts.
///
/// # Errors
///
/// Choices that fit no such wheel.
pub(super) fn looseness(design: &WheelDesign) -> Result<Vec<ReportField>, Error> {
    let Some(sizes) = design.reported_internal_sizes()? else { return Ok(Vec::new()) };
    let mounting = design.mounting().ok();
    let angle = |fit: fn(&Mounting) -> ShaftFit, shaft: f64| {
        mounting.as_ref().and_then(|mounting| fit(mounting).turning_play(shaft, sizes.play.bore))
    };
    let is_on_wheel = angle(|mounting| mounting.wheel_fit, sizes.wheel_shaft).is_some();
    let turning = |key, fit: fn(&Mounting) -> ShaftFit, shaft: f64| {
        let angle = angle(fit, shaft);
        ReportField::in_unit(key, angle.map(f64::to_degrees), "°")
    };
    let (of_wheel, of_driver) =
        (Needs::WHEEL_SHAFT.union(Needs::WHEEL_FLAT), Needs::DRIVER_SHAFT.union(Needs::DRIVER_FLAT));
    let shift = design.question.mounting.pin_screw.map(|_| sizes.play.pin);
    Ok(vec![
        turning("wheel_flat_play_deg", |mounting| mounting.wheel_fit, sizes.wheel_shaft)
            .line(PLAY_ON_FLAT, "of the wheel on its shaft, to either side, in a bore with that play")
            .needing(Needs::SIZE.union(of_wheel)),
        turning("driver_flat_play_deg", |mounting| mounting.driver_fit, sizes.plate_shaft)
            .line(if is_on_wheel { "" } else { PLAY_ON_FLAT }, "of the driver on its shaft, to either side")
            .needing(Needs::SIZE.union(of_driver)),
        ReportField::in_unit("pin_shift_mm", shift, "mm")
            .line(
                "place of the pin",
                "off by so much in any direction, as the hole of its screw lets it; limits and yield count it",
            )
            .needing(Needs::SIZE.union(Needs::PIN_SCREW)),
    ])
}

/// The fields of how far each size may be wrong if all are; none as of the parts.
///
/// # Errors
///
/// Choices that fit no such wheel.
pub(super) fn together(design: &WheelDesign) -> Result<Vec<ReportField>, Error> {
    let Some(sizes) = design.reported_internal_sizes()? else { return Ok(Vec::new()) };
    let found = sizes.shared_tolerance_within(design.question.effort.tolerance);
    let limits = found.as_ref().ok().copied().flatten();
    let sought = |key, of: fn(&SharedTolerance) -> f64| {
        ReportField::in_unit(key, limits.as_ref().map(of), "mm").needing(Needs::SIZE).rounded(Rounding::Limit(2))
    };
    let locking = sought("all_locking_mm", |limit| limit.locking);
    let locking = match (&found, limits) {
        (Err(_), _) => {
            locking.words("segment and arc", "not found: the play is so small that the search would take too long")
        }
        (Ok(_), None) => {
            locking.words("segment and arc", "in the worst case no room is known for errors in all sizes at once")
        }
        (Ok(_), Some(_)) => {
            locking.line("segment and arc", "outer radius of the segment larger, arc radius smaller, each at most")
        }
    };
    let at_rim = limits.map(|limit| limit.direction * sizes.wheel_radius);
    Ok(vec![
        locking,
        sought("all_nearer_mm", |limit| limit.nearer).line("axes nearer", "at most, besides the bore play"),
        sought("all_farther_mm", |limit| limit.farther).line("axes farther", "at most, besides the bore play"),
        sought("all_crank_radius_mm", |limit| limit.crank).line("crank radius", "longer or shorter at most"),
        sought("all_width_mm", |limit| limit.width).line("pin and slot", "pin thicker, slot narrower, each at most"),
        ReportField::in_unit("all_slot_direction_at_rim_mm", at_rim, "mm")
            .needing(Needs::SIZE)
            .rounded(Rounding::Limit(2))
            .line("slot direction", "at the wheel radius, to either side at most"),
        sought("all_slot_end_mm", |limit| limit.slot_end).line("slot end", "nearer to the wheel's axis at most"),
    ])
}

#[cfg(test)]
mod tests {
    use crate::{FieldValue, ReportField, answer};

    const RING: &str =
        "wheel --stations 6 --type internal --crank-radius 40 --process fdm --wheel-shaft 8 --plate-shaft 10";

    fn number(question: &str, key: &str) -> Option<f64> {
        answer(question).expect(question).field(key).and_then(ReportField::number)
    }

    #[test]
    fn an_internal_wheel_with_a_size_has_sizes_of_parts_limits_and_a_yield() {
        let of = |key| number(RING, key).unwrap_or_else(|| panic!("{key} is missing"));
        // Of the crank, half a slot and a horn are left for the locking arc.
        let [slot, horn, arc] = ["slot_width_mm", "horn_thickness_mm", "locking_arc_radius_mm"].map(of);
        assert!((40.0 - slot / 2.0 - horn - arc).abs() < 1e-9);
        assert!((of("slot_end_mm") - of("bottom_clearance_mm") - 80.0 - 40.0).abs() < 1e-9);
        assert!((of("wheel_bore_mm") - 8.4).abs() < 1e-9 && (of("plate_bore_mm") - 10.4).abs() < 1e-9);
        assert!(of("segment_inner_radius_mm") < of("locking_radius_mm"));
        assert_eq!((of("segment_angle_deg").round(), of("process_error_mm")), (120.0, 0.2));
        let (share, low) = (of("yield"), of("yield_low"));
        assert!(share > 0.5 && low < share, "{share} {low}");
        let tight = number(&RING.replace("--process fdm", "--process fdm --play 0.2"), "yield").expect("a yield");
        assert!(tight < share - 0.3, "{tight} {share}");
        // A screw M6 in its hole of 6.6 mm, and a flat that is 1 mm deep, on a bore with 0.4 mm of play.
        let held = format!("{RING} --pin-diameter 6 --pin-screw M6 --wheel-flat 7");
        assert!((number(&held, "pin_shift_mm").expect("a screw") - 0.3).abs() < 1e-9);
        let turn = ((3.0_f64 / 4.0).acos() - (3.4_f64 / 4.0).acos()).to_degrees();
        assert!((number(&held, "wheel_flat_play_deg").expect("a flat") - turn).abs() < 1e-9);
        let limits = number("wheel --stations 6 --type internal --crank-radius 40 --play 0.4", "all_crank_radius_mm");
        assert!(limits.is_some_and(|limit| limit > 0.0 && limit < 0.04));
    }

    #[test]
    fn what_is_usual_and_does_not_fit_is_left_out_and_what_is_chosen_is_refused() {
        let mut left_out = 0;
        for stations in [3, 4, 12, 100, 300, 1000] {
            let bare = format!("wheel --stations {stations} --type internal --crank-radius 40");
            let report = answer(&bare).expect(&bare);
            let value = &report.field("pin_diameter_mm").expect("a field").value;
            left_out += usize::from(*value == FieldValue::Missing);
            let thick = answer(&format!("{bare} --pin-diameter 60")).expect_err("too thick").to_string();
            assert!(thick.contains("; give --pin-diameter up to ") || left_out > 0, "{thick}");
        }
        assert!(left_out < 6);
    }
}
