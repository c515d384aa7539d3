//! The report on a wheel, as a sheet and as an object.
//!
//! Ratios of length are to the crank radius; those of velocity, acceleration and jerk to the driver's angular speed, its
//! square and its cube; fractions are of the driver's turn. What needs something that was not given is missing.

use super::design::{WheelDesign, too_large};
use super::instant::item;
use super::kind::WheelKind;
use super::reasons::with_reasons;
use super::{drive, hole_rows, loads, masses, parts, pin_load, process, ring_rows};
use crate::number_format::{as_typed, count, degrees, number};
use crate::worked::DriverSpeed;
use crate::{Error, MechanismReport, Needs, ReportField};
use geneva_kinematics::indexing::Indexing;

impl WheelDesign {
    /// The answer, with the motion at the angles of the question.
    ///
    /// # Errors
    ///
    /// What the files from which it is made refuse; speeds, inertias and angles that no wheel has; and numbers that are too large or too
    /// small to compute with.
    pub fn answer(&self) -> Result<MechanismReport, Error> {
        // What no file can be made of is refused before anything is computed that takes long.
        self.makeable_parts()?;
        let wheel = self.wheel.indexing();
        let sections = vec![
            ("Given", given(self)),
            ("Geometry", geometry(self, wheel)),
            ("Parts", {
                let mut fields = ring_rows::merged(parts::parts(self), ring_rows::parts(self)?);
                fields.push(hole_rows::holes(self));
                fields
            }),
            (
                "Play and tolerances of the parts",
                ring_rows::merged(parts::tolerances(self)?, ring_rows::looseness(self)?),
            ),
            (
                "Limits if all sizes are wrong at once",
                ring_rows::merged(parts::together(self)?, ring_rows::together(self)?),
            ),
            ("Process", process::fields(self)?),
            ("Warnings", parts::warnings(self)?),
            ("Cycle", cycle(self, wheel)?),
            ("Speed and acceleration of the wheel", motion(self)),
            ("Masses and speed limits", masses::fields(self)),
            ("Loads", loads::fields(self, wheel)?),
            ("Strength of the pin", pin_load::fields(self, wheel)?),
            ("Motor", drive::fields(self, wheel)?),
        ];
        let sections = with_reasons(self, sections)?;
        let at = self.angles()?.into_iter().map(|degrees| item(self, degrees)).collect::<Result<_, _>>()?;
        let (title, introduction) = (title(self), self.wheel.kind().introduction());
        let answer = MechanismReport { title, introduction, sections, list: Some(("at", at)), note: missing(self) };
        match answer.not_finite() {
            None => Ok(answer),
            Some(key) => Err(too_large(key)),
        }
    }

    /// The fields of the answer that pages show of a wheel of known kind: sizes, play, times, loads, and the factors of the pin. What no
    /// page shows is not computed, since a page asks again with each move of a slider.
    ///
    /// The design's wheel is an argument so that a page for wheels of one kind loads no code for the others.
    ///
    /// # Errors
    ///
    /// What the files from which it is made refuse, as the whole answer does; speeds and inertias that no wheel has.
    pub fn live_fields(&self, wheel: &(impl Indexing + ?Sized)) -> Result<Vec<ReportField>, Error> {
        self.makeable_parts()?;
        let mut fields = given(self);
        fields.extend(geometry(self, wheel));
        fields.extend(parts::parts(self));
        fields.extend(parts::tolerances(self)?);
        fields.extend(cycle(self, wheel)?);
        let loads = loads::fields(self, wheel)?;
        let force = loads.iter().find(|field| field.key == "peak_pin_force_n").and_then(ReportField::number);
        fields.extend(loads);
        fields.extend(pin_load::live_fields(self, force)?);
        Ok(fields)
    }

    /// The fields of how far sizes may be wrong: each alone, and all at once.
    ///
    /// # Errors
    ///
    /// A distance of the axes at which the parts can't work together.
    pub fn tolerance_fields(&self) -> Result<Vec<ReportField>, Error> {
        let mut fields = parts::tolerances(self)?;
        fields.extend(parts::together(self)?);
        Ok(fields)
    }
}

fn given(design: &WheelDesign) -> Vec<ReportField> {
    let wheel = design.wheel.indexing();
    vec![
        ReportField::new("type", design.wheel.kind().name()),
        ReportField::new("stations", wheel.stations()),
        ReportField::new("pins", wheel.pins()),
        ReportField::new("rpm", design.driver_speed.map(DriverSpeed::rpm)).needing(Needs::SPEED),
        ReportField::in_unit("crank_radius_mm", design.crank_radius, "mm").needing(Needs::SIZE),
    ]
}

fn geometry(design: &WheelDesign, indexing: &(impl Indexing + ?Sized)) -> Vec<ReportField> {
    let wheel = &design.wheel;
    // Of an external wheel the length that was given comes back as it was given.
    let of_parts = design.sizes.map(|sizes| [sizes.centre_distance, sizes.wheel_radius]);
    let lengths = |ratio: f64| design.crank_radius.map(|radius| radius * ratio);
    let centres = of_parts.map(|[centres, _]| centres).or(wheel.centre_distance_ratio().and_then(lengths));
    let radius = of_parts.map(|[_, radius]| radius).or(lengths(wheel.wheel_radius_ratio()));
    let slot = match wheel.kind() {
        WheelKind::External => "from there to where the pin is deepest",
        WheelKind::Internal => "from there outwards to the pin's centre at its deepest",
        WheelKind::Spherical => "from there along the meridian to the pin's centre at its deepest",
    };
    vec![
        ReportField::in_unit("engagement_half_angle_deg", indexing.engagement_half_angle().to_degrees(), "°")
            .line("engagement half-angle", "crank angle where a pin enters and leaves"),
        ReportField::in_unit("centre_distance_ratio", wheel.centre_distance_ratio(), "× crank radius")
            .line("centre distance", "wheel's axis to driver's axis"),
        ReportField::in_unit("centre_distance_mm", centres, "mm").in_other_unit().needing(Needs::SIZE),
        ReportField::in_unit("wheel_radius_ratio", wheel.wheel_radius_ratio(), "× crank radius")
            .line("wheel radius", "wheel's axis to a pin's centre as it enters"),
        ReportField::in_unit("wheel_radius_mm", radius, "mm").in_other_unit().needing(Needs::SIZE),
        ReportField::in_unit("slot_length_ratio", wheel.slot_length_ratio(), "× crank radius")
            .line("least slot length", slot),
        ReportField::in_unit("slot_length_mm", lengths(wheel.slot_length_ratio()), "mm")
            .in_other_unit()
            .needing(Needs::SIZE),
    ]
}

fn cycle(design: &WheelDesign, wheel: &(impl Indexing + ?Sized)) -> Result<Vec<ReportField>, Error> {
    let times = design.times(wheel)?;
    Ok(vec![
        ReportField::in_unit("motion_fraction", wheel.motion_fraction(), "× driver turn")
            .line("motion fraction", "while a pin is in a slot"),
        ReportField::in_unit("dwell_fraction", wheel.dwell_fraction(), "× driver turn")
            .line("dwell fraction", "while the wheel is locked"),
        ReportField::in_unit("indexing_time_s", times.map(|[index, _]| index), "s")
            .line("indexing time", "from when a pin enters to when it leaves")
            .needing(Needs::SPEED),
        ReportField::in_unit("dwell_time_s", times.map(|[_, dwell]| dwell), "s")
            .line("dwell time", "from when it leaves to when the next pin enters")
            .needing(Needs::SPEED),
    ])
}

fn motion(design: &WheelDesign) -> Vec<ReportField> {
    let (wheel, speed, kind) = (design.wheel.indexing(), design.speed(), design.wheel.kind());
    let (velocity, entry) = (wheel.peak_velocity(), wheel.entry_acceleration());
    let (acceleration, jerk) = (wheel.acceleration_peak(), wheel.jerk_peak());
    // With as many pins as fit and no dwell, one pin enters as another leaves.
    let at_entry = if wheel.dwell_fraction() > 0.0 {
        "as a pin enters: a jump from zero"
    } else {
        "as a pin enters: a jump from an equal deceleration"
    };
    let at_end = wheel.engagement_half_angle();
    let place = |angle: f64| {
        if angle == at_end { "as a pin enters".to_owned() } else { kind.place(-angle.to_degrees(), &degrees(angle)) }
    };
    let jerk_at = place(jerk.angle);
    vec![
        ReportField::in_unit("peak_velocity_ratio", velocity, "× driver speed").line("peak velocity", place(0.0)),
        ReportField::in_unit("peak_speed_rad_s", speed.map(|speed| speed * velocity), "rad/s")
            .in_other_unit()
            .needing(Needs::SPEED),
        ReportField::in_unit("entry_acceleration_ratio", entry, "× driver speed²").line("entry acceleration", at_entry),
        ReportField::in_unit("entry_acceleration_rad_s2", speed.map(|speed| speed * speed * entry), "rad/s²")
            .in_other_unit()
            .needing(Needs::SPEED),
        ReportField::in_unit("peak_acceleration_ratio", acceleration.ratio, "× driver speed²")
            .line("peak acceleration", place(acceleration.angle)),
        ReportField::in_unit(
            "peak_acceleration_rad_s2",
            speed.map(|speed| speed * speed * acceleration.ratio),
            "rad/s²",
        )
        .in_other_unit()
        .needing(Needs::SPEED),
        // Of the peak of deceleration; that of acceleration is as far before the middle.
        ReportField::in_unit("peak_acceleration_angle_deg", acceleration.angle.to_degrees(), "°"),
        ReportField::in_unit("peak_jerk_ratio", jerk.ratio, "× driver speed³")
            .line("peak jerk", format!("{jerk_at}; not counting the jumps at the ends")),
        ReportField::in_unit("peak_jerk_rad_s3", speed.map(|speed| speed * speed * speed * jerk.ratio), "rad/s³")
            .in_other_unit()
            .needing(Needs::SPEED),
    ]
}

fn title(design: &WheelDesign) -> String {
    let wheel = design.wheel.indexing();
    let name = match design.wheel.kind() {
        WheelKind::External => "External",
        WheelKind::Internal => "Internal",
        WheelKind::Spherical => "Spherical",
    };
    let (stations, pins) = (count(wheel.stations() as usize, "station"), count(wheel.pins() as usize, "pin"));
    let radius =
        design.crank_radius.map_or_else(String::new, |radius| format!(", crank radius {} mm", short_length(radius)));
    let speed = |speed: DriverSpeed| format!(", {} {}", as_typed(speed.value()), speed.unit());
    let rpm = design.driver_speed.map_or_else(String::new, speed);
    format!("{name} Geneva wheel: {stations}, driver with {pins}{radius}{rpm}")
}

/// A length that was typed, or one that follows from another, to as many digits as a reader wants.
fn short_length(length: f64) -> String {
    let typed = as_typed(length);
    if typed.len() <= 8 { typed } else { number(length) }
}

/// Which options would add to the report.
fn missing(design: &WheelDesign) -> String {
    let sizes = if design.wheel.kind() == WheelKind::Spherical {
        "--crank-radius MM or --wheel-radius MM"
    } else {
        "--crank-radius MM, --centre-distance MM or --wheel-radius MM"
    };
    let lengths = design.crank_radius.is_none().then(|| format!("For sizes in mm, add {sizes}."));
    let rates = design.driver_speed.is_none().then(|| "For s, rad/s and rad/s², add --rpm R or --rad-s W.".to_owned());
    let loads = design.inertia.is_none().then(|| {
        let also = if design.driver_speed.is_none() { "also " } else { "" };
        format!("For torques, {also}add --inertia KGM2.")
    });
    let without = design.driver_speed.and(design.inertia).map(|_| {
        let question = &design.question;
        let parts = [
            ("the pin", question.pin_friction),
            ("the locking disc", question.disc_friction),
            ("the driver's bearings", question.bearing_friction.or(question.driver_friction)),
        ];
        let parts: Vec<_> = parts.into_iter().filter(|(_, of)| of.is_none()).map(|(part, _)| part).collect();
        let gear = if parts.is_empty() { "the gear".to_owned() } else { format!("{} and the gear", parts.join(", ")) };
        format!(
            "The loads leave out the friction of {gear}, so the motor needs more. Not sized: shafts, keys, bearings, screws, the \
             driver's plate, fatigue and wear."
        )
    });
    let bores = design.sizes.filter(|sizes| sizes.wheel_shaft == 0.0 && sizes.plate_shaft == 0.0).map(|_| {
        "For bores, add --wheel-shaft MM and --driver-shaft MM; without them the files have centre marks.".to_owned()
    });
    lengths.into_iter().chain(bores).chain(rates).chain(loads).chain(without).collect::<Vec<_>>().join(" ")
}
