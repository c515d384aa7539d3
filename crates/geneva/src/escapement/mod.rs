//! One escapement: whether it runs, its steady state, its rise from rest, the run itself, or a drawing.

mod run;

use crate::arguments::{Format, Output, formats, name_of};
use crate::fields::{self, Field, Report, angle, number};
use crate::output::count;
use crate::typed::{self, as_typed, rounded_up};
use anyhow::{anyhow, bail, ensure};
use clap::{Args, ValueEnum};
use geneva_dynamics::existence::{critical_friction, least_margin};
use geneva_dynamics::steady::{Engagement, MOST_CYCLES, SteadyState, TOLERANCE};
use geneva_dynamics::{Error, Inertias, Parameters};
use geneva_figures::Figure;
use geneva_figures::escapement::{mechanism, normal_force};
use geneva_figures::runs::speeds;
use geneva_kinematics::Mechanism;

/// Options of `geneva escapement`.
#[derive(Args, Debug)]
pub struct EscapementArguments {
    /// Number of slots of the follower: 3, 4 or 6; the driver then has 6, 4 or 3 pins
    #[arg(long, value_name = "N", value_parser = typed::slots, allow_negative_numbers = true)]
    pub slots: u32,
    /// Coefficient of friction between pin and slot, above zero; --format csv allows zero
    #[arg(long, value_name = "MU", value_parser = typed::zero_or_more, allow_hyphen_values = true)]
    pub friction: f64,
    /// Torque of the spring on the driver, constant, above zero
    #[arg(long, value_name = "K", value_parser = typed::positive, allow_hyphen_values = true)]
    pub torque: f64,
    /// Moment of inertia of the driver about its axis, above zero
    #[arg(long, value_name = "I", value_parser = typed::positive, allow_hyphen_values = true)]
    pub driver_inertia: f64,
    /// Moment of inertia of the follower about its axis, above zero
    #[arg(long, value_name = "I", value_parser = typed::positive, allow_hyphen_values = true)]
    pub follower_inertia: f64,
    /// Units of torque and inertias, to report them in SI units too
    #[arg(long, value_enum)]
    pub units: Option<Units>,
    /// Turn of the driver, in degrees, after which its angle is reset to where a pin enters. A mechanism does what the
    /// default does; another value does what a program does that resets the angle at a fixed value
    /// [default: 360 over the number of pins]
    #[arg(long, alias = "modulus-deg", value_name = "D", value_parser = typed::degrees, allow_hyphen_values = true)]
    pub reset_deg: Option<f64>,
    /// How long the run from rest lasts; only with --format csv
    /// [default: the rise plus three periods, or a hundred engagements if that is shorter; ten without friction]
    #[arg(long, value_name = "T", value_parser = typed::positive, allow_hyphen_values = true)]
    pub duration: Option<f64>,
    /// Time between the lines of the run; only with --format csv
    /// [default: the round number that puts 100 to 250 lines in the last engagement; longer for a long --duration]
    #[arg(long, value_name = "T", value_parser = typed::positive, allow_hyphen_values = true)]
    pub interval: Option<f64>,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (Format::Text, "A readable sheet, which says where everything is measured from"),
        (Format::Json, "An object with all digits: the steady state and the rise from rest"),
        (Format::Csv, "The run from rest, one row per time"),
        (Format::Svg, "A drawing as a standalone file; --figure chooses which"),
    ]))]
    pub format: Format,
    /// Which drawing to make; only with --format svg [default: mechanism]
    #[arg(long, value_enum)]
    pub figure: Option<FigureName>,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// Coherent systems of units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Units {
    /// Inch, pound-force and second: torque in in lb, inertias in in lb s²
    InLbS,
    /// Metre, kilogram and second: torque in N m, inertias in kg m²
    Si,
}

impl Units {
    /// The unit of torque in N m, which is that of inertia in kg m², for the unit of time is the second.
    ///
    /// A pound is the weight of 0.45359237 kg where gravity is standard, 9.80665 m/s², and an inch is 0.0254 m, all by
    /// definition.
    fn torque_n_m(self) -> f64 {
        match self {
            Self::InLbS => 0.0254 * 0.453_592_37 * 9.806_65,
            Self::Si => 1.0,
        }
    }
}

/// The drawings of an escapement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum FigureName {
    /// The mechanism, to scale
    #[default]
    Mechanism,
    /// Normal force and friction torque over one engagement of the steady state
    NormalForce,
    /// Speeds of driver and follower over the first engagements from rest, in rad/s and ms; for torques and inertias
    /// whose unit of time is the second
    Run,
}

const INTRODUCTION: &str = "Times are in the unit of time of the torque and the inertias, and speeds in radians per \
                            unit of time. With lb, in and s, or with N, m and kg, these are s and rad/s. Crank angles \
                            are measured at the driver's axis from the line of centres, negative before it.";

/// How near to the steady speed the rise from rest must come.
const SETTLED: f64 = 0.01;

/// What the rise time is.
const RISE_TIME: &str = "time from rest, with a pin at its entry, until an engagement begins with at least 99 % of the \
                         entry speed of the steady state";

/// The escapement that is wanted, in the format that is wanted.
pub fn page(wanted: &EscapementArguments) -> anyhow::Result<String> {
    Format::Csv.only_with(wanted.format, "--duration", wanted.duration.map(as_typed), "a run")?;
    Format::Csv.only_with(wanted.format, "--interval", wanted.interval.map(as_typed), "a run")?;
    Format::Svg.only_with(wanted.format, "--figure", wanted.figure.and_then(name_of), "a drawing")?;
    let parameters = parameters(wanted)?;
    let reset_deg = wanted.reset_deg.unwrap_or(own_reset(parameters.mechanism()));
    let engagement = engagement(&parameters, reset_deg).map_err(|error| unsteady(wanted, error))?;
    match wanted.format {
        Format::Csv => run::csv(&engagement, wanted.duration, wanted.interval),
        Format::Svg => Ok(drawing(wanted, &parameters, &engagement)?.standalone()),
        _ => {
            let report = report(&parameters, reset_deg, &engagement, wanted.units);
            let report = report.map_err(|error| unsteady(wanted, error))?;
            ensure!(
                report.is_finite(),
                "--reset-deg {} is too small to compute with; give a larger angle, or leave it out",
                as_typed(reset_deg)
            );
            if wanted.format == Format::Json { fields::json(&report) } else { Ok(report.sheet()) }
        }
    }
}

/// The parameters that were typed, if there is such an escapement; too much friction is refused in terms of the option and
/// in degrees.
fn parameters(wanted: &EscapementArguments) -> anyhow::Result<Parameters> {
    let mechanism = Mechanism::new(wanted.slots)?;
    let inertias = Inertias::new(wanted.driver_inertia, wanted.follower_inertia)?;
    match Parameters::new(mechanism, inertias, wanted.torque, wanted.friction) {
        Err(Error::TooMuchFriction { asked, limit, angle }) => bail!(
            "--friction {} is too high for this mechanism: from {} on it may jam, because the motion is not determined \
             {:.2}° to either side of the line of centres; give less friction, or a driver with more inertia",
            as_typed(asked),
            rounded_up(limit),
            angle.to_degrees()
        ),
        other => Ok(other?),
    }
}

/// The reset angle of a mechanism in degrees: 360 over the number of pins, an integer.
pub fn own_reset(mechanism: Mechanism) -> f64 {
    360.0 / f64::from(mechanism.pins())
}

/// The engagement that ends after so many degrees.
pub fn engagement(parameters: &Parameters, reset_deg: f64) -> Result<Engagement, Error> {
    if reset_deg == own_reset(parameters.mechanism()) {
        Engagement::new(parameters)
    } else {
        Engagement::reset_after(parameters, reset_deg.to_radians(), TOLERANCE)
    }
}

/// The library's refusal of a steady motion, in terms of the options.
fn unsteady(wanted: &EscapementArguments, error: Error) -> anyhow::Error {
    let friction = as_typed(wanted.friction);
    match error {
        Error::Reset { asked, limit } => no_reset(wanted.reset_deg.unwrap_or(asked.to_degrees()), limit),
        Error::NoTerminalSpeed { .. } => anyhow!(
            "--friction {friction}: there is no terminal speed, because nothing brakes the driver and it gains speed \
             without end; give a friction above zero, or --format csv for the run from rest"
        ),
        Error::TooSharp { angle, margin } => anyhow!(
            "--friction {friction}, --driver-inertia {}, --follower-inertia {}: the motion changes too quickly to be \
             computed at {:.2}° from the line of centres, where A − |D| is {margin:.1e}; give less friction, or \
             inertias that differ less",
            as_typed(wanted.driver_inertia),
            as_typed(wanted.follower_inertia),
            angle.to_degrees()
        ),
        other => other.into(),
    }
}

/// A reset angle that is out of range, and the range. The limit is in radians.
pub fn no_reset(asked_deg: f64, limit: f64) -> anyhow::Error {
    anyhow!(
        "--reset-deg {}: the driver's angle must be reset after more than 0° and less than {}°, where the pin is \
         farthest from the follower; give an angle in this range, or leave it out for a real mechanism",
        as_typed(asked_deg),
        limit.to_degrees().round()
    )
}

/// The report on an escapement, if it has a steady state.
///
/// Times are in the unit of time of torque and inertias, speeds in radians per unit of time.
fn report(
    parameters: &Parameters,
    reset_deg: f64,
    engagement: &Engagement,
    units: Option<Units>,
) -> Result<Report, Error> {
    let (mechanism, inertias) = (parameters.mechanism(), parameters.inertias());
    let state = engagement.steady_state()?;
    Ok(Report {
        title: format!(
            "Geneva escapement: {}, {}, friction {}, torque {}, inertias: driver {}, follower {}",
            count(mechanism.slots() as usize, "slot"),
            count(mechanism.pins() as usize, "pin"),
            as_typed(parameters.friction()),
            as_typed(parameters.torque()),
            as_typed(inertias.driver()),
            as_typed(inertias.follower())
        ),
        introduction: INTRODUCTION,
        sections: vec![
            ("Mechanism", mechanism_fields(parameters, reset_deg, units)),
            ("Existence", existence_fields(parameters)),
            ("Steady state", steady_fields(&state, engagement.reset() > mechanism.engagement_half_angle())),
            ("Rise from rest", rise_fields(rise(engagement, &state)?)),
        ],
        note: String::new(),
    })
}

fn mechanism_fields(parameters: &Parameters, reset_deg: f64, units: Option<Units>) -> Vec<Field> {
    let (mechanism, inertias, torque) = (parameters.mechanism(), parameters.inertias(), parameters.torque());
    let own = own_reset(mechanism);
    let reset_angle = if reset_deg == own {
        "turn of the driver from one pin's entry to the next".to_owned()
    } else {
        format!(
            "turn of the driver after which its angle is reset; what follows is only a calculation, because in a \
             mechanism the next pin enters after {own}°"
        )
    };
    let mut fields = vec![
        Field::new("slots", mechanism.slots()),
        Field::new("pins", mechanism.pins()),
        Field::new("friction", parameters.friction()),
        Field::new("torque", torque),
        Field::new("driver_inertia", inertias.driver()),
        Field::new("follower_inertia", inertias.follower()),
        Field::new("inertia_ratio", inertias.ratio()).line("inertia ratio", "the driver's inertia over the follower's"),
        Field::in_unit("engagement_half_angle_deg", mechanism.engagement_half_angle().to_degrees(), "°")
            .line("half-angle", "crank angle where a pin leaves its slot; it enters as far before the line of centres"),
        Field::in_unit("reset_deg", reset_deg, "°").line("reset angle", reset_angle),
    ];
    if let Some(unit) = units.map(Units::torque_n_m) {
        fields.extend([
            Field::in_unit("torque_n_m", torque * unit, "N m").line("torque", "of the spring, in SI units"),
            Field::in_unit("driver_inertia_kg_m2", inertias.driver() * unit, "kg m²").line("driver inertia", ""),
            Field::in_unit("follower_inertia_kg_m2", inertias.follower() * unit, "kg m²").line("follower inertia", ""),
        ]);
    }
    fields
}

fn existence_fields(parameters: &Parameters) -> Vec<Field> {
    let (mechanism, ratio) = (parameters.mechanism(), parameters.inertias().ratio());
    let friction = parameters.friction();
    // Both have been asked for when the parameters were checked: they have an answer.
    let (critical, critical_angle) = critical_friction(mechanism, ratio)
        .map_or((f64::INFINITY, f64::NAN), |critical| (critical.friction, critical.angle.to_degrees()));
    let (margin, margin_angle) = least_margin(mechanism, ratio, friction)
        .map_or((f64::NAN, f64::NAN), |least| (least.margin, least.angle.to_degrees()));
    let jams = format!(
        "from here on it may jam, {}° to either side of the line of centres; the friction given is {} % of this",
        number(critical_angle),
        number(100.0 * friction / critical)
    );
    let least = format!(
        "least A − |D|, which is above zero where the motion is determined; {}° to either side of the line of centres",
        number(margin_angle)
    );
    vec![
        Field::new("critical_friction", critical).line("critical friction", jams),
        Field::new("critical_angle_deg", critical_angle),
        Field::new("least_margin", margin).line("margin", least),
        Field::new("least_margin_angle_deg", margin_angle),
    ]
}

fn steady_fields(state: &SteadyState, passes_centres: bool) -> Vec<Field> {
    let (peak, minimum) = (state.peak.angle.to_degrees(), state.minimum.angle.to_degrees());
    // On the line of centres, if the engagement gets there, and past it, if the engagement gets there too.
    let switches: Vec<_> =
        passes_centres.then_some(0.0).into_iter().chain(state.switch_angle.map(f64::to_degrees)).collect();
    let told: Vec<_> = switches.iter().map(|degrees| format!("{}°", angle(*degrees))).collect();
    let told = if told.is_empty() {
        "none within the reset angle".to_owned()
    } else {
        format!("at {}", told.join(" and at "))
    };
    vec![
        Field::new("entry_speed", state.entry_speed)
            .line("entry speed", "of the driver, as a pin enters: the terminal speed"),
        Field::new("peak_speed", state.peak.speed).line("peak speed", format!("at {}°", angle(peak))),
        Field::new("peak_angle_deg", peak),
        Field::new("minimum_speed", state.minimum.speed).line("minimum speed", format!("at {}°", angle(minimum))),
        Field::new("minimum_angle_deg", minimum),
        Field::new("mean_speed", state.mean_speed).line("mean speed", "reset angle over period"),
        Field::new("mean_of_extremes", state.mean_of_extremes()).line("mean of extremes", "of peak and minimum speed"),
        Field::new("period", state.period).line("period", "from one engagement to the next"),
        Field::new("multiplier", state.multiplier)
            .line("multiplier", "part of a small difference of speeds that one engagement leaves"),
        Field::new("switch_angles_deg", switches).words("sign changes", format!("of the friction term: {told}")),
    ]
}

fn rise_fields(rise: Option<(usize, f64)>) -> Vec<Field> {
    let (engagements, time) = rise.unzip();
    let mut duration = Field::new("rise_time", time).line("rise time", RISE_TIME);
    if time.is_none() {
        duration = duration.words("rise time", format!("longer than {MOST_CYCLES} engagements; it is the {RISE_TIME}"));
    }
    vec![
        duration,
        Field::new("rise_time_definition", RISE_TIME),
        Field::new("engagements_to_settle", engagements).line("engagements", "until then"),
    ]
}

/// Engagements and time of the rise from rest; none if it takes more engagements than the library counts.
///
/// The more the speed, the nearer to the line of centres is the switch, and the more an engagement contracts: below the
/// steady speed it contracts by no more than there. So the multiplier of the steady state tells how many engagements
/// are needed at least, and a rise that is too long for certain is not tried.
pub fn rise(engagement: &Engagement, steady: &SteadyState) -> Result<Option<(usize, f64)>, Error> {
    let enough = (1.0 - SETTLED) * (1.0 - SETTLED);
    let least = libm::log(1.0 - enough) / libm::log(steady.multiplier);
    // A little is left to rounding.
    if least > 1.001 * MOST_CYCLES as f64 {
        return Ok(None);
    }
    match engagement.engagements_to_settle(SETTLED) {
        Err(Error::TooMany { .. }) => Ok(None),
        result => result.map(Some),
    }
}

/// The drawing that is wanted.
fn drawing(wanted: &EscapementArguments, parameters: &Parameters, engagement: &Engagement) -> anyhow::Result<Figure> {
    let steady = || engagement.steady_state().map_err(|error| unsteady(wanted, error));
    Ok(match wanted.figure.unwrap_or_default() {
        FigureName::Mechanism => {
            let escapement = parameters.mechanism();
            mechanism(&escapement, -escapement.engagement_half_angle() / 3.0)?
        }
        FigureName::NormalForce => {
            if let Some(reset_angle) = wanted.reset_deg {
                ensure!(
                    reset_angle == own_reset(parameters.mechanism()),
                    "--reset-deg {}: --figure normal-force shows an engagement of a real mechanism; leave --reset-deg out",
                    as_typed(reset_angle)
                );
            }
            normal_force(parameters, steady()?.entry_speed)?
        }
        FigureName::Run => {
            steady()?;
            speeds(engagement, "")?
        }
    })
}

#[cfg(test)]
mod tests {
    use super::Units;

    #[test]
    fn a_pound_is_a_mass_of_a_pound_under_standard_gravity() {
        // 1 in = 254/1e4 m, 1 lb = 45359237/1e8 kg and 980665/1e5 m/s²: their product is a fraction of integers.
        let fraction = (254_u64 * 45_359_237 * 980_665) as f64 / 1e17;
        approx::assert_relative_eq!(Units::InLbS.torque_n_m(), fraction, max_relative = 1e-15);
        // The inverse, as tables give it: a newton metre is 8.850746 inch pounds.
        approx::assert_relative_eq!(1.0 / Units::InLbS.torque_n_m(), 8.850_746, max_relative = 1e-7);
        assert_eq!(Units::Si.torque_n_m(), 1.0);
    }
}
