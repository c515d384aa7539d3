//! The parts of an external wheel in millimetres, as they are reported.

use super::design::WheelDesign;
use super::{looseness, mouth_rows};
use crate::number_format::degrees as degrees_told;
use crate::{Error, FieldValue, Needs, ReportField, Rounding};
use geneva_kinematics::wheel::{ClosestApproach, ContactPair, SharedTolerance, Sizes};

/// Between which parts a least distance is, and where.
fn nearest_words(design: &WheelDesign, nearest: &ClosestApproach) -> String {
    let parts = match nearest.contact {
        ContactPair::PinInSlot => "pin and slot",
        ContactPair::PinOutside => "pin and wheel, while it is in no slot",
        ContactPair::LockingDisc => "locking disc and locking arc",
        ContactPair::Crescent => "locking disc and wheel, while it turns",
    };
    let place = design.wheel.kind().place(nearest.crank_angle.to_degrees(), &degrees_told(nearest.crank_angle));
    format!("over a whole turn: {parts}, {place}")
}

/// Limits as a sheet has them. One that is sought over a turn is known to about a hundredth of the lesser gap.
const LIMIT: Rounding = Rounding::Limit(4);
const SOUGHT: Rounding = Rounding::Limit(2);

fn mm(key: &'static str, length: Option<f64>) -> ReportField {
    ReportField::in_unit(key, length, "mm").needing(Needs::SIZE)
}

/// The fields of the parts; without numbers where no size was given, or of another kind of wheel.
pub(super) fn parts(design: &WheelDesign) -> Vec<ReportField> {
    let sizes = design.sizes.as_ref();
    let of = |length: fn(&Sizes) -> f64| sizes.map(length);
    // A shaft that there is not has no diameter.
    let shaft = |length: fn(&Sizes) -> f64| of(length).filter(|diameter| *diameter > 0.0);
    let disc = sizes.and_then(|sizes| sizes.locking_disc);
    let (of_wheel, of_driver) = (Needs::SIZE.union(Needs::WHEEL_SHAFT), Needs::SIZE.union(Needs::DRIVER_SHAFT));
    let mut fields = vec![
        mm("pin_diameter_mm", of(|sizes| sizes.pin_diameter)).line("pin diameter", ""),
        mm("play_mm", of(|sizes| sizes.play.slot)).line("play", "how much wider a slot is than the pin"),
        mm("locking_play_mm", of(|sizes| sizes.play.locking))
            .line("locking play", "how much wider a locking arc is than the disc, as a difference of diameters"),
        mm("bore_play_mm", of(|sizes| sizes.play.bore))
            .line("bore play", "how much wider bores are than the shafts that run in them"),
        mm("axial_play_mm", design.axial_play()).line("axial play", "gap between wheel and plate along the axes"),
        mm("slot_width_mm", of(|sizes| sizes.slot_width)).line("slot width", "pin diameter plus play"),
        mm("slot_depth_mm", of(|sizes| sizes.slot_depth))
            .line("slot depth", "from the wheel radius to the bottom of its round end"),
        mm("bottom_clearance_mm", of(|sizes| sizes.bottom_clearance))
            .line("bottom clearance", "how much deeper the slot is than pin and play need"),
        mm("slot_end_mm", of(|sizes| sizes.slot_end)).line("slot end", "wheel's axis to the centre of the round end"),
        mm("tip_radius_mm", of(|sizes| sizes.tip_radius))
            .line("tip radius", "wheel's axis to the corners of the slots: the blank"),
        mm("outside_diameter_mm", of(|sizes| 2.0 * sizes.tip_radius)).line("outside diameter", "of the blank"),
        mm("thickness_mm", design.thickness).line("thickness", "of wheel, locking disc and plate"),
        mm("horn_thickness_mm", of(|sizes| sizes.horn_thickness))
            .line("horn thickness", "least thickness between a slot and a locking arc"),
        mm("slot_web_mm", of(|sizes| sizes.web))
            .line("web between slots", "least thickness between the ends of two slots"),
        mm("bore_web_mm", design.bore_web())
            .needing(of_wheel)
            .line("web at the bore", "least thickness of the wheel around the bore, its keyway or flat"),
        mm("locking_arc_radius_mm", of(|sizes| sizes.locking_arc_radius))
            .line("locking arc radius", "its centre is at the centre distance, half a pitch from a slot"),
        mm("locking_radius_mm", disc.map(|disc| disc.radius))
            .line("locking disc radius", "that of the locking arc, less the play on one side"),
        mm("crescent_radius_mm", disc.map(|disc| disc.crescent.radius))
            .line("crescent radius", "of the cut in the disc"),
        mm("crescent_centre_mm", disc.map(|disc| disc.crescent.centre))
            .line("crescent centre", "driver's axis to the cut's centre, towards the pin"),
        mm("plate_radius_mm", of(|sizes| sizes.plate_radius)).line("plate radius", "of the driver, behind the wheel"),
        mm("wheel_shaft_mm", shaft(|sizes| sizes.wheel_shaft)).needing(of_wheel).line("wheel shaft", "diameter"),
        mm("wheel_shaft_limit_mm", of(|sizes| sizes.wheel_shaft_limit))
            .line("wheel shaft limit", "the shaft must be thinner")
            .rounded(LIMIT),
        mm("wheel_bore_mm", shaft(Sizes::wheel_bore))
            .needing(of_wheel)
            .line("wheel bore", "diameter: shaft plus bore play"),
        mm("driver_shaft_mm", shaft(|sizes| sizes.driver_shaft))
            .needing(of_driver)
            .line("driver shaft", "diameter in the plane of the wheel"),
        mm("driver_shaft_limit_mm", of(|sizes| sizes.driver_shaft_limit))
            .line("driver shaft limit", "the shaft must be thinner")
            .rounded(LIMIT),
        mm("driver_bore_mm", shaft(Sizes::driver_bore))
            .needing(of_driver)
            .line("driver bore", "diameter: shaft plus bore play"),
        mm("plate_shaft_mm", shaft(|sizes| sizes.plate_shaft))
            .needing(of_driver)
            .line("plate shaft", "driver's shaft in the plate, diameter"),
        mm("plate_shaft_limit_mm", of(|sizes| sizes.plate_shaft_limit))
            .line("plate shaft limit", "the shaft must be thinner")
            .rounded(LIMIT),
        mm("plate_bore_mm", shaft(Sizes::plate_bore))
            .needing(of_driver)
            .line("plate bore", "diameter: shaft plus bore play"),
        mm("disc_web_mm", sizes.and_then(Sizes::disc_web))
            .needing(of_driver)
            .line("web of the disc", "least thickness between crescent and bore"),
        mm("plate_web_mm", sizes.and_then(Sizes::plate_web))
            .needing(of_driver)
            .line("web of the plate", "least thickness between pin and bore"),
        mm("crescent_web_mm", sizes.and_then(Sizes::crescent_web))
            .line("web between crescents", "least thickness of the disc between two of them")
            .needing(Needs::SIZE.union(Needs::SECOND_PIN)),
        mm("plate_rim_mm", of(Sizes::plate_rim)).line("rim of the plate", "thickness outside a pin"),
    ];
    fields.extend(mouth_rows::mouth(design));
    fields
}

/// The fields of what play and wrong sizes do; without numbers as of the parts, and without speeds where none was given.
pub(super) fn tolerances(design: &WheelDesign) -> Result<Vec<ReportField>, Error> {
    let sizes = design.sizes.as_ref();
    let is_tight = sizes.is_some_and(|sizes| sizes.play.slot == 0.0 || sizes.locking_gap() == Some(0.0));
    // With the axes apart the backlash is another, and so is the knock.
    let is_moved = design.centre_error() != 0.0;
    let in_place = sizes.filter(|_| !is_moved);
    // What is less than the tolerance is not known to be more than none; without play it is none.
    let found = design.clearance()?.filter(|(least, tolerance)| least.distance > *tolerance || is_tight || is_moved);
    let least = found.map(|(least, _)| least);
    let tolerance = design.centre_tolerance()?;
    let not_found = |field: ReportField, name, is_found: bool| {
        if sizes.is_some() && !is_found {
            field.words(
                name,
                "not found: the play is so small compared with the parts that the search would take too long",
            )
        } else {
            field
        }
    };
    let nearest = mm("least_clearance_mm", least.map(|least| least.distance))
        .line("least clearance", least.map_or_else(String::new, |least| nearest_words(design, &least)));
    let nearer = mm("centres_nearer_mm", tolerance.map(|tolerance| tolerance.nearer))
        .line("axes nearer", "at most, or parts touch; loose shafts bring the axes nearer by the bore play")
        .rounded(SOUGHT);
    let farther = mm("centres_farther_mm", tolerance.map(|tolerance| tolerance.farther))
        .line("axes farther", "at most, or the pin meets a corner of its slot or parts touch")
        .rounded(SOUGHT);
    let play = in_place.and_then(Sizes::dwell_play);
    let degrees =
        |key, radians: Option<f64>| ReportField::in_unit(key, radians.map(f64::to_degrees), "°").needing(Needs::SIZE);
    let at_greatest = play.map_or_else(String::new, |play| {
        let until = degrees_told(play.until_entry.abs());
        if play.until_entry < 0.0 {
            format!("to one side: forwards {until}° of crank angle after a pin enters, in the mouth, backwards as far before it leaves")
        } else {
            format!(
                "to one side: forwards {until}° of crank angle before a pin enters, backwards as far past where it leaves"
            )
        }
    });
    let mut fields = vec![
        not_found(nearest, "least clearance", least.is_some()),
        degrees("least_clearance_at_deg", least.map(|least| least.crank_angle)),
        not_found(nearer, "axes nearer", tolerance.is_some()),
        not_found(farther, "axes farther", tolerance.is_some()),
        mm("bottom_gap_mm", sizes.map(Sizes::bottom_gap))
            .line(
                "gap at the bottom",
                "the slot end may be this much too far out, with crank radius and centres as drawn",
            )
            .rounded(LIMIT),
        mm("crank_radius_tolerance_mm", sizes.and_then(Sizes::crank_radius_tolerance))
            .line("longer crank", "at most, or the pin sticks at entry or on the slot's bottom")
            .rounded(LIMIT),
        mm("locking_gap_mm", sizes.and_then(Sizes::locking_gap))
            .line(
                "gap of the disc",
                "the disc radius may be this much too long, or arc radius and centre distance together too short",
            )
            .rounded(LIMIT),
        degrees("slot_direction_tolerance_deg", sizes.and_then(Sizes::slot_direction_tolerance))
            .line("slot direction", "a slot may be this far out of place between the locking arcs, to either side")
            .rounded(LIMIT),
        degrees("dwell_backlash_deg", play.map(|play| play.middle))
            .line("backlash in the dwell", "of the wheel, to either side, in the middle of the dwell"),
        ReportField::in_unit("dwell_backlash_held_fraction", play.map(|play| play.held), "× dwell")
            .line("", "part of the dwell, about its middle, in which it is no greater")
            .needing(Needs::SIZE)
            .rounded(Rounding::Percent(0)),
        degrees("greatest_dwell_backlash_deg", play.map(|play| play.greatest)).line("greatest backlash", at_greatest),
        degrees("greatest_dwell_backlash_until_entry_deg", play.map(|play| play.until_entry))
            .rounded(Rounding::Decimals(1)),
    ];
    fields.extend(looseness::fields(design, in_place));
    fields.extend(mouth_rows::knock(design, in_place));
    Ok(fields)
}

/// How far each size may be wrong if all are, with shafts as loose as their bores allow; without numbers as of the parts.
pub(super) fn together(design: &WheelDesign) -> Result<Vec<ReportField>, Error> {
    let found = design.shared_tolerance()?;
    let (limits, radius) = (found.flatten(), design.sizes.map(|sizes| sizes.wheel_radius));
    let of = |length: fn(&SharedTolerance) -> f64| limits.as_ref().map(length);
    let sought = |key, length: Option<f64>| mm(key, length).rounded(SOUGHT);
    let locking = sought("all_locking_mm", of(|limit| limit.locking));
    let has_disc = design.sizes.is_some_and(|sizes| sizes.locking_disc.is_some());
    let locking = match found {
        None => locking.words("disc and arc", "not found: the play is so small that the search would take too long"),
        Some(None) if has_disc => {
            locking.words("disc and arc", "in the worst case no room is known for errors in all sizes at once")
        }
        Some(_) => locking.line("disc and arc", "disc radius larger, arc radius smaller, each at most"),
    };
    let at_rim = limits.zip(radius).map(|(limit, radius)| limit.direction * radius);
    Ok(vec![
        locking,
        sought("all_nearer_mm", of(|limit| limit.nearer)).line("axes nearer", "at most, besides the bore play"),
        sought("all_farther_mm", of(|limit| limit.farther)).line("axes farther", "at most, besides the bore play"),
        sought("all_crank_radius_mm", of(|limit| limit.crank)).line("crank radius", "longer or shorter at most"),
        sought("all_width_mm", of(|limit| limit.width))
            .line("pin and slot", "pin thicker, slot narrower, each at most"),
        sought("all_slot_direction_at_rim_mm", at_rim)
            .line("slot direction", "at the wheel radius, to either side at most"),
        sought("all_slot_end_mm", of(|limit| limit.slot_end)).line("slot end", "farther out at most"),
    ])
}

/// What a maker should know about sizes that do fit.
///
/// # Errors
///
/// A distance of the axes at which the parts can't work together, and what can't be made.
pub(super) fn warnings(design: &WheelDesign) -> Result<Vec<ReportField>, Error> {
    let found = design.warnings_with_cause(design.yield_cause()?)?;
    let said = found.join("; ");
    let texts: Vec<FieldValue> = found.into_iter().map(FieldValue::Text).collect();
    let field = ReportField::new("warnings", texts);
    Ok(vec![if said.is_empty() { field } else { field.words("before you make it", said) }])
}
