//! The loads of a wheel, as they are reported.

use super::design::WheelDesign;
use crate::number_format::degrees;
use crate::{Error, Needs, ReportField, Rounding};
use geneva_dynamics::wheel_loads::{Peak, Peaks};
use geneva_kinematics::indexing::Indexing;

/// What a force on the pin needs.
const FORCE: Needs = Needs::SPEED.union(Needs::INERTIA).union(Needs::SIZE);

/// The fields of the loads; without numbers where speed, inertia or size are missing.
pub(super) fn fields(design: &WheelDesign, wheel: &(impl Indexing + ?Sized)) -> Result<Vec<ReportField>, Error> {
    let loads = design.loads(wheel)?;
    let kind = design.wheel.kind();
    let [torque, moment, crank] = match &loads {
        Some(loads) => [loads.wheel_torque(), loads.pin_moment(), loads.crank_torque()].map(Some),
        None => [None; 3],
    };
    let at_entry = loads.as_ref().map(|loads| loads.load(-wheel.engagement_half_angle())).transpose()?;
    let force = |peak: Peak| design.force(peak.value);
    let driving = |peaks: Option<Peaks>| peaks.map(|peaks| peaks.driving);
    let braking = |peaks: Option<Peaks>| peaks.and_then(|peaks| peaks.braking);
    let place = |peak: Option<Peak>| {
        peak.map_or_else(String::new, |peak| kind.place(peak.angle.to_degrees(), &degrees(peak.angle)))
    };
    let at = |peak: Option<Peak>| peak.map(|peak| peak.angle.to_degrees());
    let reversal = loads.as_ref().and_then(|loads| loads.reversal());
    let holds = match reversal {
        Some((from, until)) => {
            let [from, until] = [from, until].map(degrees);
            format!("the pin holds the wheel back from {from}° to {until}° past {}", kind.middle())
        }
        None => "nowhere: friction alone slows the wheel down enough".to_owned(),
    };
    let greatest = moment.and_then(|moment| design.force(moment.greatest()));
    let pressure = greatest.map(|force| design.pressure(force)).transpose()?.flatten();
    let question = &design.question;
    let of_others =
        [question.pin_friction, question.disc_friction, question.bearing_friction, question.driver_friction];
    let friction_torque = if of_others.iter().all(Option::is_none) {
        "on the wheel; no other friction is included"
    } else {
        "on the wheel"
    };
    let mean_torque = loads.as_ref().map(|loads| loads.mean_crank_torque());
    let mean = if mean_torque.is_some_and(|mean| mean > 0.0) {
        "over a turn of the driver; this is what friction takes"
    } else {
        "frictionless: no friction is given"
    };
    let from = ReportField::in_unit("braking_from_deg", reversal.map(|(from, _)| from.to_degrees()), "°");
    let from = if loads.is_some() { from.words("braking", holds) } else { from };
    let is_without_wheel = design.wheel_inertia.is_none() && design.question.total_inertia.is_none();
    let of_what = if is_without_wheel && design.inertia.is_some() {
        "of what turns with the wheel, as given; the wheel's own is not in it"
    } else {
        "of the wheel and everything that turns with it"
    };
    let fields = vec![
        ReportField::in_unit("inertia_kgm2", design.inertia, "kg m²")
            .line("moment of inertia", of_what)
            .needing(Needs::INERTIA),
        ReportField::in_unit("wheel_inertia_kgm2", design.wheel_inertia, "kg m²")
            .line("", "part of the wheel itself, from its outline and holes, thickness and density")
            .needing(Needs::SIZE),
        ReportField::in_unit("table_inertia_kgm2", design.table_inertia, "kg m²")
            .line("", "part of the table and all else that turns with the wheel, as given")
            .needing(Needs::TABLE_INERTIA),
        ReportField::in_unit("table_mass_kg", design.question.table_mass, "kg").needing(Needs::TABLE),
        ReportField::in_unit("table_diameter_mm", design.question.table_diameter, "mm").needing(Needs::TABLE),
        ReportField::in_unit("friction_torque_nm", design.question.friction_torque, "N m")
            .line("friction torque", friction_torque)
            .needing(Needs::FRICTION_TORQUE),
        ReportField::new("pin_friction", question.pin_friction)
            .line("pin friction", "coefficient in the slot")
            .needing(Needs::PIN_FRICTION),
        ReportField::new("disc_friction", question.disc_friction)
            .line("disc friction", "coefficient of the locking disc in its arc")
            .needing(Needs::DISC_FRICTION),
        ReportField::new("bearing_friction", question.bearing_friction)
            .line("bearing friction", "coefficient of the bearings of wheel and driver")
            .needing(Needs::BEARING_FRICTION),
        ReportField::in_unit("driver_friction_nm", question.driver_friction, "N m")
            .line("driver friction", "constant torque on the driver")
            .needing(Needs::DRIVER_FRICTION),
        ReportField::in_unit("entry_wheel_torque_nm", at_entry.map(|load| load.wheel_torque), "N m")
            .line("entry wheel torque", "as a pin enters: it comes all at once")
            .visible_in_live_figure(),
        ReportField::in_unit("peak_wheel_torque_nm", driving(torque).map(|peak| peak.value), "N m")
            .line("peak wheel torque", place(driving(torque))),
        ReportField::in_unit("peak_wheel_torque_at_deg", at(driving(torque)), "°"),
        ReportField::in_unit("peak_pin_force_n", driving(moment).and_then(force), "N")
            .line("peak pin force", place(driving(moment)))
            .needing(FORCE),
        ReportField::in_unit(
            "peak_pin_force_at_deg",
            at(driving(moment).filter(|_| design.crank_radius.is_some())),
            "°",
        )
        .needing(FORCE),
        ReportField::in_unit("peak_contact_pressure_mpa", pressure, "MPa")
            .line(
                "peak contact pressure",
                "between pin and slot at the greatest force, driving or braking, along their whole length (Hertz)",
            )
            .needing(Needs::SPEED.union(Needs::INERTIA).union(Needs::SIZE))
            .rounded(Rounding::Significant(3)),
        ReportField::in_unit("peak_crank_torque_nm", driving(crank).map(|peak| peak.value), "N m")
            .line("peak crank torque", place(driving(crank))),
        ReportField::in_unit("peak_crank_torque_at_deg", at(driving(crank)), "°"),
        ReportField::in_unit(
            "peak_power_w",
            driving(crank).zip(design.speed()).map(|(peak, speed)| peak.value * speed),
            "W",
        )
        .line("peak power", "at the same angle")
        .rounded(Rounding::Significant(3)),
        ReportField::in_unit("rms_crank_torque_nm", loads.as_ref().map(|loads| loads.rms_crank_torque()), "N m")
            .line("RMS crank torque", "over a turn of the driver; this heats a motor"),
        ReportField::in_unit("mean_crank_torque_nm", mean_torque, "N m")
            .line("mean crank torque", mean)
            .rounded(Rounding::Significant(3)),
        ReportField::in_unit("braking_wheel_torque_nm", braking(torque).map(|peak| peak.value), "N m")
            .line("braking wheel torque", place(braking(torque))),
        ReportField::in_unit("braking_pin_force_n", braking(moment).and_then(force), "N")
            .line("braking pin force", format!("on the other side of the slot; {}", place(braking(moment))))
            .needing(FORCE),
        ReportField::in_unit("braking_crank_torque_nm", braking(crank).map(|peak| peak.value), "N m")
            .line("braking crank torque", place(braking(crank))),
        from,
        ReportField::in_unit("braking_until_deg", reversal.map(|(_, until)| until.to_degrees()), "°"),
    ];
    Ok(ReportField::all_needing(fields, Needs::SPEED.union(Needs::INERTIA)))
}
