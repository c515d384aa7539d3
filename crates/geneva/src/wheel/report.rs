//! The report on a wheel, as a sheet and as an object.
//!
//! Ratios of length are to the crank radius; those of velocity, acceleration and jerk to the driver's angular speed, its
//! square and its cube; fractions are of the driver's turn. What needs something that was not given is missing.

use super::cycle::{self, Instant, degrees_told};
use super::kind::Kind;
use super::made::Made;
use super::{loads, sizes};
use crate::fields::{Field, Report, Value};
use crate::output::count;
use crate::typed::as_typed;

/// All of it, with the motion at these crank angles in degrees: as lines of a sheet, or as rows of an object.
pub fn report(made: &Made, at: &[f64], as_lines: bool) -> anyhow::Result<Report> {
    let mut sections = vec![("Given", given(made)), ("Geometry", geometry(made))];
    sections.push(("Parts", sizes::parts(made)));
    sections.push(("Play and tolerances of the parts", sizes::tolerances(made)?));
    sections.push(("Warnings", sizes::warnings(made)));
    sections.push(("Cycle", cycle_fields(made)?));
    sections.push(("Speed and acceleration of the wheel", motion(made)));
    sections.push(("Loads", loads::fields(made)?));
    if as_lines {
        for degrees in at {
            sections.push(("At a crank angle", Instant::new(made, *degrees)?.lines(made)));
        }
    } else {
        let rows: Vec<Value> = cycle::rows(made, at)?.into_iter().map(Value::Object).collect();
        sections.push(("", vec![Field::new("at", rows)]));
    }
    let introduction = made.wheel.kind().introduction();
    Ok(Report { title: title(made), introduction, sections, note: missing(made) })
}

fn given(made: &Made) -> Vec<Field> {
    let wheel = made.wheel.indexing();
    vec![
        Field::new("type", made.wheel.kind().name()),
        Field::new("stations", wheel.stations()),
        Field::new("pins", wheel.pins()),
        Field::new("rpm", made.rpm),
        Field::new("crank_radius_mm", made.crank_radius),
    ]
}

fn geometry(made: &Made) -> Vec<Field> {
    let wheel = &made.wheel;
    // Of an external wheel the length that was given comes back as it was given.
    let of_parts = made.sizes.map(|sizes| [sizes.centre_distance, sizes.wheel_radius]);
    let lengths = |ratio: f64| made.crank_radius.map(|radius| radius * ratio);
    let centres = of_parts.map(|[centres, _]| centres).or(wheel.centre_distance_ratio().and_then(lengths));
    let radius = of_parts.map(|[_, radius]| radius).or(lengths(wheel.wheel_radius_ratio()));
    let slot = match wheel.kind() {
        Kind::External => "from there to where the pin is deepest",
        Kind::Internal => "from there outwards to the pin's centre at its deepest",
        Kind::Spherical => "from there along the meridian to the pin's centre at its deepest",
    };
    vec![
        Field::in_unit("engagement_half_angle_deg", wheel.indexing().engagement_half_angle().to_degrees(), "°")
            .line("engagement half-angle", "crank angle where a pin enters and leaves"),
        Field::in_unit("centre_distance_ratio", wheel.centre_distance_ratio(), "× crank radius")
            .line("centre distance", "wheel's axis to driver's axis"),
        Field::in_unit("centre_distance_mm", centres, "mm").also(),
        Field::in_unit("wheel_radius_ratio", wheel.wheel_radius_ratio(), "× crank radius")
            .line("wheel radius", "wheel's axis to a pin's centre as it enters"),
        Field::in_unit("wheel_radius_mm", radius, "mm").also(),
        Field::in_unit("slot_length_ratio", wheel.slot_length_ratio(), "× crank radius")
            .line("least slot length", slot),
        Field::in_unit("slot_length_mm", lengths(wheel.slot_length_ratio()), "mm").also(),
    ]
}

fn cycle_fields(made: &Made) -> anyhow::Result<Vec<Field>> {
    let (wheel, speed) = (made.wheel.indexing(), made.speed());
    Ok(vec![
        Field::in_unit("motion_fraction", wheel.motion_fraction(), "× driver turn")
            .line("motion fraction", "while a pin is in a slot"),
        Field::in_unit("dwell_fraction", wheel.dwell_fraction(), "× driver turn")
            .line("dwell fraction", "while the wheel is locked"),
        Field::in_unit("indexing_time_s", speed.map(|speed| wheel.indexing_time(speed)).transpose()?, "s")
            .line("indexing time", "from when a pin enters to when it leaves"),
        Field::in_unit("dwell_time_s", speed.map(|speed| wheel.dwell_time(speed)).transpose()?, "s")
            .line("dwell time", "from when it leaves to when the next pin enters"),
    ])
}

fn motion(made: &Made) -> Vec<Field> {
    let (wheel, speed, kind) = (made.wheel.indexing(), made.speed(), made.wheel.kind());
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
        if angle == at_end {
            "as a pin enters".to_owned()
        } else {
            kind.place(-angle.to_degrees(), &degrees_told(angle))
        }
    };
    let jerk_at = place(jerk.angle);
    vec![
        Field::in_unit("peak_velocity_ratio", velocity, "× driver speed").line("peak velocity", place(0.0)),
        Field::in_unit("peak_speed_rad_s", speed.map(|speed| speed * velocity), "rad/s").also(),
        Field::in_unit("entry_acceleration_ratio", entry, "× driver speed²").line("entry acceleration", at_entry),
        Field::in_unit("entry_acceleration_rad_s2", speed.map(|speed| speed * speed * entry), "rad/s²").also(),
        Field::in_unit("peak_acceleration_ratio", acceleration.ratio, "× driver speed²")
            .line("peak acceleration", place(acceleration.angle)),
        Field::in_unit("peak_acceleration_rad_s2", speed.map(|speed| speed * speed * acceleration.ratio), "rad/s²")
            .also(),
        // Of the peak of deceleration; that of acceleration is as far before the middle.
        Field::new("peak_acceleration_angle_deg", acceleration.angle.to_degrees()),
        Field::in_unit("peak_jerk_ratio", jerk.ratio, "× driver speed³")
            .line("peak jerk", format!("{jerk_at}; not counting the jumps at the ends")),
        Field::in_unit("peak_jerk_rad_s3", speed.map(|speed| speed * speed * speed * jerk.ratio), "rad/s³").also(),
    ]
}

fn title(made: &Made) -> String {
    let wheel = made.wheel.indexing();
    let name = match made.wheel.kind() {
        Kind::External => "External",
        Kind::Internal => "Internal",
        Kind::Spherical => "Spherical",
    };
    let (stations, pins) = (count(wheel.stations() as usize, "station"), count(wheel.pins() as usize, "pin"));
    let radius = made.crank_radius.map_or_else(String::new, |radius| format!(", crank radius {} mm", told(radius)));
    let rpm = made.rpm.map_or_else(String::new, |rpm| format!(", {} rpm", as_typed(rpm)));
    format!("{name} Geneva wheel: {stations}, driver with {pins}{radius}{rpm}")
}

/// A length that was typed, or one that follows from another, to as many digits as a reader wants.
fn told(length: f64) -> String {
    let typed = as_typed(length);
    if typed.len() <= 8 { typed } else { crate::fields::number(length) }
}

/// Which options would add to the report.
fn missing(made: &Made) -> String {
    let sizes = if made.wheel.kind() == Kind::Spherical {
        "--crank-radius MM or --wheel-radius MM"
    } else {
        "--crank-radius MM, --centre-distance MM or --wheel-radius MM"
    };
    let lengths = made.crank_radius.is_none().then(|| format!("For sizes in mm, add {sizes}."));
    let rates = made.rpm.is_none().then(|| "For s, rad/s and rad/s², add --rpm R.".to_owned());
    let loads = made.inertia.is_none().then(|| {
        let also = if made.rpm.is_none() { "also " } else { "" };
        format!("For torques, {also}add --inertia KGM2.")
    });
    let without = made.rpm.and(made.inertia).map(|_| {
        let parts = "the pin, the locking disc, the driver's bearings and the gear";
        format!("The loads leave out the friction of {parts}, so the motor needs more.")
    });
    lengths.into_iter().chain(rates).chain(loads).chain(without).collect::<Vec<_>>().join(" ")
}
