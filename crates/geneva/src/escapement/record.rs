//! An escapement as data: what the library says of it.

use super::assembly::Assembly;
use super::units::InSi;
use geneva_dynamics::existence::{critical_friction, least_margin};
use geneva_dynamics::steady::{Engagement, MOST_CYCLES, SteadyError, SteadyState};
use serde::Serialize;

/// How near to the steady speed the rise from rest must come.
pub const SETTLED: f64 = 0.01;

/// What the rise time is.
pub const RISE_TIME: &str = "\
time from rest, with a pin at its entry, until an engagement begins with at least 99 % of the entry speed of the steady \
state";

/// All that is known of an escapement: the keys of the JSON object.
///
/// Times are in the unit of time of torque and inertias, speeds in radians per unit of time.
#[derive(Debug, Serialize)]
pub struct EscapementRecord {
    pub slots: u32,
    pub pins: u32,
    pub friction: f64,
    pub torque: f64,
    pub driver_inertia: f64,
    pub follower_inertia: f64,
    pub inertia_ratio: f64,
    /// Torque and inertias in SI units, if their own were told.
    #[serde(flatten)]
    pub in_si: Option<InSi>,
    pub modulus_deg: f64,
    /// Where the pin leaves its slot.
    pub engagement_half_angle_deg: f64,
    pub critical_friction: f64,
    /// To either side of the line of centres.
    pub critical_angle_deg: f64,
    pub least_margin: f64,
    /// To either side of the line of centres.
    pub least_margin_angle_deg: f64,
    pub entry_speed: f64,
    pub peak_speed: f64,
    pub peak_angle_deg: f64,
    pub minimum_speed: f64,
    pub minimum_angle_deg: f64,
    pub mean_speed: f64,
    pub mean_of_extremes: f64,
    pub period: f64,
    pub contraction: f64,
    /// Where the friction changes its sign within the modulus; at the hand-over it may do so besides.
    pub switch_angles_deg: Vec<f64>,
    /// Missing if it takes more engagements than the library counts.
    pub rise_time: Option<f64>,
    pub rise_time_definition: &'static str,
    /// Until then.
    pub engagements_to_settle: Option<usize>,
}

impl EscapementRecord {
    /// What there is to say, if the escapement has a steady state.
    pub fn new(assembly: &Assembly) -> Result<Self, SteadyError> {
        let Assembly { parameters, modulus_deg, engagement, .. } = assembly;
        let (mechanism, inertias) = (parameters.mechanism(), parameters.inertias());
        let steady = engagement.steady_state()?;
        let rise = rise(engagement, &steady)?;
        // Both have been asked for when the parameters were checked: they have an answer.
        let (critical, critical_angle) = critical_friction(mechanism, inertias.ratio())
            .map_or((f64::INFINITY, f64::NAN), |critical| (critical.friction, critical.angle));
        let (margin, margin_angle) = least_margin(mechanism, inertias.ratio(), parameters.friction())
            .map_or((f64::NAN, f64::NAN), |least| (least.margin, least.angle));
        Ok(Self {
            slots: mechanism.slots(),
            pins: mechanism.pins(),
            friction: parameters.friction(),
            torque: parameters.torque(),
            driver_inertia: inertias.driver(),
            follower_inertia: inertias.follower(),
            inertia_ratio: inertias.ratio(),
            in_si: assembly.units.map(|units| InSi::new(parameters, units)),
            modulus_deg: *modulus_deg,
            engagement_half_angle_deg: mechanism.engagement_half_angle().to_degrees(),
            critical_friction: critical,
            critical_angle_deg: critical_angle.to_degrees(),
            least_margin: margin,
            least_margin_angle_deg: margin_angle.to_degrees(),
            entry_speed: steady.entry_speed,
            peak_speed: steady.peak.speed,
            peak_angle_deg: steady.peak.angle.to_degrees(),
            minimum_speed: steady.minimum.speed,
            minimum_angle_deg: steady.minimum.angle.to_degrees(),
            mean_speed: steady.mean_speed,
            mean_of_extremes: steady.mean_of_extremes(),
            period: steady.period,
            contraction: steady.contraction,
            switch_angles_deg: switch_angles_deg(&steady, engagement.fold() > mechanism.engagement_half_angle()),
            rise_time: rise.map(|(_, time)| time),
            rise_time_definition: RISE_TIME,
            engagements_to_settle: rise.map(|(engagements, _)| engagements),
        })
    }

    /// Whether every number is one.
    pub fn is_finite(&self) -> bool {
        let numbers = [self.entry_speed, self.peak_speed, self.minimum_speed, self.mean_speed, self.period];
        let places = [self.peak_angle_deg, self.minimum_angle_deg, self.critical_friction, self.least_margin];
        numbers.into_iter().chain(places).chain(self.rise_time).all(f64::is_finite)
    }
}

/// Engagements and time of the rise from rest; none if it takes more engagements than the library counts.
///
/// The more the speed, the nearer to the line of centres is the switch, and the more an engagement contracts: below the
/// steady speed it contracts by no more than there. So the contraction of the steady state tells how many engagements
/// are needed at least, and a rise that is too long for certain is not tried.
pub fn rise(engagement: &Engagement, steady: &SteadyState) -> Result<Option<(usize, f64)>, SteadyError> {
    let enough = (1.0 - SETTLED) * (1.0 - SETTLED);
    let least = libm::log(1.0 - enough) / libm::log(steady.contraction);
    // A little is left to rounding.
    if least > 1.001 * MOST_CYCLES as f64 {
        return Ok(None);
    }
    match engagement.engagements_to_settle(SETTLED) {
        Err(SteadyError::TooMany { .. }) => Ok(None),
        result => result.map(Some),
    }
}

/// On the line of centres, if the engagement gets there, and past it, if the engagement gets there too.
fn switch_angles_deg(steady: &SteadyState, passes_centres: bool) -> Vec<f64> {
    passes_centres.then_some(0.0).into_iter().chain(steady.switch_angle.map(f64::to_degrees)).collect()
}
