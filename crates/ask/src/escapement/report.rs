//! The answer about an escapement, if it has a steady state.
//!
//! Times are in the unit of time of torque and inertias, speeds in radians per unit of time.

use super::{EscapementDesign, SETTLED, UnitSystem, engagements_until_steady, own_reset, unsteady};
use crate::number_format::{angle, as_typed, count, number};
use crate::{Error, MechanismReport, ReportField};
use geneva_dynamics::Parameters;
use geneva_dynamics::existence::{critical_friction, least_margin};
use geneva_dynamics::steady::{Engagement, MOST_CYCLES, RiseMeasure, SteadyState};

const INTRODUCTION: &str = "Times are in the unit of time of the torque and the inertias, and speeds in radians per \
                            unit of time. With lb, in and s, or with N, m and kg, these are s and rad/s. Crank angles \
                            are measured at the driver's axis from the line of centres, negative before it.";

/// Most engagements from rest of which profile and average are looked at.
const MOST_COMPARED: usize = 10_000;

impl EscapementDesign {
    /// The answer.
    ///
    /// # Errors
    ///
    /// Why there is no steady state.
    pub fn answer(&self) -> Result<MechanismReport, Error> {
        let (parameters, engagement, reset_deg) = (&self.parameters, &self.engagement, self.reset_deg);
        let (mechanism, inertias) = (parameters.mechanism(), parameters.inertias());
        let state = self.steady_state()?;
        let rise = engagements_until_steady(engagement, &state).map_err(|error| unsteady(&self.question, error))?;
        let answer = MechanismReport {
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
                ("Mechanism", mechanism_fields(parameters, reset_deg, self.question.units)),
                ("Existence", existence_fields(parameters)),
                ("Steady state", steady_fields(&state, engagement.reset() > mechanism.engagement_half_angle())),
                ("Rise from rest", rise_fields(engagement, rise)),
            ],
            list: None,
            note: String::new(),
        };
        if answer.is_finite() {
            Ok(answer)
        } else {
            Err(refused!(
                "--reset-deg {} is too small to compute with; give a larger angle, or leave it out",
                as_typed(reset_deg)
            ))
        }
    }
}

fn mechanism_fields(parameters: &Parameters, reset_deg: f64, units: Option<UnitSystem>) -> Vec<ReportField> {
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
        ReportField::new("slots", mechanism.slots()),
        ReportField::new("pins", mechanism.pins()),
        ReportField::new("friction", parameters.friction()),
        ReportField::new("torque", torque),
        ReportField::new("driver_inertia", inertias.driver()),
        ReportField::new("follower_inertia", inertias.follower()),
        ReportField::new("inertia_ratio", inertias.ratio())
            .line("inertia ratio", "the driver's inertia over the follower's"),
        ReportField::in_unit("engagement_half_angle_deg", mechanism.engagement_half_angle().to_degrees(), "°")
            .line("half-angle", "crank angle where a pin leaves its slot; it enters as far before the line of centres"),
        ReportField::in_unit("reset_deg", reset_deg, "°").line("reset angle", reset_angle),
    ];
    if let Some(unit) = units.map(UnitSystem::torque_n_m) {
        fields.extend([
            ReportField::in_unit("torque_n_m", torque * unit, "N m").line("torque", "of the spring, in SI units"),
            ReportField::in_unit("driver_inertia_kg_m2", inertias.driver() * unit, "kg m²").line("driver inertia", ""),
            ReportField::in_unit("follower_inertia_kg_m2", inertias.follower() * unit, "kg m²")
                .line("follower inertia", ""),
        ]);
    }
    fields
}

fn existence_fields(parameters: &Parameters) -> Vec<ReportField> {
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
        ReportField::new("critical_friction", critical).line("critical friction", jams),
        ReportField::new("critical_angle_deg", critical_angle),
        ReportField::new("least_margin", margin).line("margin", least),
        ReportField::new("least_margin_angle_deg", margin_angle),
    ]
}

fn steady_fields(state: &SteadyState, passes_centres: bool) -> Vec<ReportField> {
    let (peak, minimum) = (state.peak.angle.to_degrees(), state.minimum.angle.to_degrees());
    // On the line of centres, if the engagement gets there, and past it, if the engagement gets there too.
    let switches: Vec<_> =
        passes_centres.then_some(0.0).into_iter().chain(state.reversal_angle.map(f64::to_degrees)).collect();
    let told: Vec<_> = switches.iter().map(|degrees| format!("{}°", angle(*degrees))).collect();
    let told = if told.is_empty() {
        "none within the reset angle".to_owned()
    } else {
        format!("at {}", told.join(" and at "))
    };
    vec![
        ReportField::new("entry_speed", state.entry_speed)
            .line("entry speed", "of the driver, as a pin enters: the terminal speed"),
        ReportField::new("peak_speed", state.peak.speed).line("peak speed", format!("at {}°", angle(peak))),
        ReportField::new("peak_angle_deg", peak),
        ReportField::new("minimum_speed", state.minimum.speed).line("minimum speed", format!("at {}°", angle(minimum))),
        ReportField::new("minimum_angle_deg", minimum),
        ReportField::new("mean_speed", state.mean_speed).line("mean speed", "reset angle over period"),
        ReportField::new("mean_of_extremes", state.mean_of_extremes())
            .line("mean of extremes", "of peak and minimum speed"),
        ReportField::new("period", state.period).line("period", "from one engagement to the next"),
        ReportField::new("multiplier", state.multiplier)
            .line("multiplier", "part of a small difference of speeds that one engagement leaves"),
        ReportField::new("switch_angles_deg", switches).words("sign changes", format!("of the friction term: {told}")),
    ]
}

/// The times of a start from rest by three of the measures: the fourth is of no start, and only chapters ask for it.
fn rise_fields(engagement: &Engagement, rise: Option<(usize, f64)>) -> Vec<ReportField> {
    let (engagements, time) = rise.unzip();
    let field = |key, name, measure: RiseMeasure, time: Option<f64>, most: usize| {
        let meaning = measure.meaning();
        match time {
            Some(_) => ReportField::new(key, time).line(name, meaning),
            None => {
                ReportField::new(key, time).words(name, format!("longer than {most} engagements; it is the {meaning}"))
            }
        }
    };
    let compared = engagements.is_some_and(|count| count <= MOST_COMPARED);
    let [profile, average] = [Engagement::until_profile_in, Engagement::until_average_in]
        .map(|until| if compared { until(engagement, SETTLED, MOST_COMPARED).ok() } else { None });
    vec![
        field("profile_rise_time", "rise, profile", RiseMeasure::Profile, profile, MOST_COMPARED),
        field("average_rise_time", "rise, average", RiseMeasure::Average, average, MOST_COMPARED),
        field("entry_speed_rise_time", "rise, entry speed", RiseMeasure::EntrySpeed, time, MOST_CYCLES),
        ReportField::new("entry_speed_rise_engagements", engagements)
            .line("engagements", "until an engagement begins with at least 99 % of the entry speed"),
    ]
}
