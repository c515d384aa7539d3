//! What is told of the parts of an external wheel in millimetres.

use super::cycle::degrees_told;
use super::made::Made;
use crate::fields::Field;
use geneva_kinematics::wheel::{Contact, Nearest, Sizes};

/// Between which parts a least distance is, and where.
fn nearest_told(made: &Made, nearest: &Nearest) -> String {
    let parts = match nearest.contact {
        Contact::PinInSlot => "pin and slot",
        Contact::PinOutside => "pin and wheel, while it is in no slot",
        Contact::LockingDisc => "locking disc and locking arc",
        Contact::Crescent => "locking disc and wheel, while it turns",
    };
    let place = made.wheel.kind().place(nearest.crank_angle.to_degrees(), &degrees_told(nearest.crank_angle));
    format!("over a whole turn: {parts}, {place}")
}

/// The fields of the parts; without numbers where no size was given, or of another kind of wheel.
pub fn fields(made: &Made) -> Vec<Field> {
    let sizes = made.sizes.as_ref();
    let of = |length: fn(&Sizes) -> f64| sizes.map(length);
    // A shaft that there is not has no diameter.
    let shaft = |length: fn(&Sizes) -> f64| of(length).filter(|diameter| *diameter > 0.0);
    let disc = sizes.and_then(|sizes| sizes.locking_disc);
    let least = sizes.map(|sizes| sizes.clearance().least());
    let told = least.map_or_else(String::new, |least| nearest_told(made, &least));
    let backlash = sizes.and_then(Sizes::dwell_backlash).map(f64::to_degrees);
    let tolerance = sizes.map(Sizes::centre_tolerance);
    let mm = |key, length: Option<f64>| Field::in_unit(key, length, "mm");
    vec![
        mm("pin_diameter_mm", of(|sizes| sizes.pin_diameter)).line("pin diameter", ""),
        mm("play_mm", of(|sizes| sizes.play.slot)).line("play", "of slot and locking arc: how much wider they are"),
        mm("bore_play_mm", of(|sizes| sizes.play.bore)).line("bore play", "how much wider bores are than their shafts"),
        mm("slot_width_mm", of(|sizes| sizes.slot_width)).line("slot width", "pin diameter and play"),
        mm("slot_depth_mm", of(|sizes| sizes.slot_depth))
            .line("slot depth", "from the wheel radius to the bottom of its round end"),
        mm("slot_end_mm", of(|sizes| sizes.slot_end)).line("slot end", "wheel's axis to the centre of the round end"),
        mm("tip_radius_mm", of(|sizes| sizes.tip_radius))
            .line("tip radius", "wheel's axis to the corners of the slots: the blank"),
        mm("horn_thickness_mm", of(|sizes| sizes.horn_thickness))
            .line("horn thickness", "least between a slot and a locking arc"),
        mm("slot_web_mm", of(|sizes| sizes.web)).line("web between slots", "least, between the ends of two"),
        mm("bore_web_mm", of(Sizes::bore_web)).line("web at the bore", "least, between a slot's end and the bore"),
        mm("locking_arc_radius_mm", of(|sizes| sizes.locking_arc_radius))
            .line("locking arc radius", "its centre is at the centre distance, half a pitch from a slot"),
        mm("locking_radius_mm", disc.map(|disc| disc.radius))
            .line("locking disc radius", "that of the locking arcs less the play on one side"),
        mm("crescent_radius_mm", disc.map(|disc| disc.crescent.radius))
            .line("crescent radius", "of the cut in the disc"),
        mm("crescent_centre_mm", disc.map(|disc| disc.crescent.centre))
            .line("crescent centre", "driver's axis to the cut's centre, towards the pin"),
        mm("plate_radius_mm", of(|sizes| sizes.plate_radius)).line("plate radius", "of the driver, behind the wheel"),
        mm("wheel_shaft_mm", shaft(|sizes| sizes.wheel_shaft)).line("wheel shaft", "diameter"),
        mm("wheel_shaft_limit_mm", of(|sizes| sizes.wheel_shaft_limit)).line("wheel shaft limit", "it must be thinner"),
        mm("wheel_bore_mm", shaft(Sizes::wheel_bore)).line("wheel bore", "diameter: shaft and bore play"),
        mm("driver_shaft_mm", shaft(|sizes| sizes.driver_shaft))
            .line("driver shaft", "diameter in the plane of the wheel"),
        mm("driver_shaft_limit_mm", of(|sizes| sizes.driver_shaft_limit))
            .line("driver shaft limit", "it must be thinner"),
        mm("driver_bore_mm", shaft(Sizes::driver_bore)).line("driver bore", "diameter: shaft and bore play"),
        mm("least_clearance_mm", least.map(|least| least.distance)).line("least clearance", told),
        Field::new("least_clearance_at_deg", least.map(|least| least.crank_angle.to_degrees())),
        mm("centres_nearer_mm", tolerance.map(|tolerance| tolerance.nearer))
            .line("axes nearer", "at most, or parts touch; loose shafts bring them nearer by the bore play"),
        mm("centres_farther_mm", tolerance.map(|tolerance| tolerance.farther))
            .line("axes farther", "at most, or the pin meets a corner of its slot or parts touch"),
        Field::in_unit("dwell_backlash_deg", backlash, "°").line("backlash at rest", "of the wheel, to either side"),
    ]
}
