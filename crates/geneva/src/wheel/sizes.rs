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
    let disc = sizes.and_then(|sizes| sizes.locking_disc);
    let least = sizes.map(|sizes| sizes.clearance().least());
    let told = least.map_or_else(String::new, |least| nearest_told(made, &least));
    let backlash = sizes.and_then(Sizes::dwell_backlash).map(f64::to_degrees);
    vec![
        Field::in_unit("pin_diameter_mm", of(|sizes| sizes.pin_diameter), "mm").line("pin diameter", ""),
        Field::in_unit("play_mm", of(|sizes| sizes.play.slot), "mm")
            .line("play", "of slot, locking arc and bores: how much wider they are"),
        Field::in_unit("slot_width_mm", of(|sizes| sizes.slot_width), "mm").line("slot width", "pin diameter and play"),
        Field::in_unit("slot_depth_mm", of(|sizes| sizes.slot_depth), "mm")
            .line("slot depth", "from the wheel radius to the bottom of its round end"),
        Field::in_unit("rim_radius_mm", of(|sizes| sizes.tip_radius), "mm")
            .line("rim radius", "wheel's axis to the corners of the slots: the blank"),
        Field::in_unit("horn_thickness_mm", of(|sizes| sizes.horn_thickness), "mm")
            .line("horn thickness", "least between a slot and a locking arc"),
        Field::in_unit("locking_radius_mm", disc.map(|disc| disc.radius), "mm")
            .line("locking disc radius", "that of the locking arcs less the play on one side"),
        Field::in_unit("wheel_shaft_limit_mm", of(|sizes| sizes.wheel_shaft_limit), "mm")
            .line("wheel shaft", "greatest diameter"),
        Field::in_unit("driver_shaft_limit_mm", of(|sizes| sizes.driver_shaft_limit), "mm")
            .line("driver shaft", "greatest diameter in the plane of the wheel"),
        Field::in_unit("least_clearance_mm", least.map(|least| least.distance), "mm").line("least clearance", told),
        Field::new("least_clearance_at_deg", least.map(|least| least.crank_angle.to_degrees())),
        Field::in_unit("dwell_backlash_deg", backlash, "°").line("backlash at rest", "of the wheel, to either side"),
    ]
}
