//! What a clockmaker asks of an escapement: what changes its rate, how hard its members are driven, how fast it settles, how
//! hard a pin strikes that has play, and what thick pins and journals do.
//!
//! Neither the command's sheet nor its data have these fields. Chapters and figures that a reader moves show them.

use super::{EscapementDesign, EscapementQuestion, unsteady};
use crate::{Error, ReportField, Rounding};
use geneva_dynamics::existence::critical_inertia_ratio;
use geneva_dynamics::joints::{self, Joints};
use geneva_dynamics::timer::{self, Accelerations, Crossing, EntryBlow, Sensitivities, Settling, SignedPeak};
use geneva_dynamics::{DynamicsError as Motion, Parameters};

/// Seconds and hours of a day.
const DAY: f64 = 86_400.0;
const HOURS: f64 = 24.0;
/// One per cent: by so much more of a quantity the rate is asked, and to this part of itself a small difference settles.
const PER_CENT: f64 = 0.01;

/// What one per cent more of each quantity makes in a day, and the power behind the friction's rate. A minus is a loss.
///
/// # Errors
///
/// Without friction there is no steady state.
pub fn rates(parameters: &Parameters) -> Result<Vec<ReportField>, Motion> {
    let powers = Sensitivities::new(parameters)?;
    let rate = |key, power, name| {
        let field = ReportField::in_unit(key, PER_CENT * DAY * power, "s a day").rounded(Rounding::Decimals(0));
        field.line(name, "what the timer gains with one per cent more of it, to first order")
    };
    Ok(vec![
        rate("friction_rate_s_a_day", powers.friction, "friction"),
        rate("torque_rate_s_a_day", powers.torque, "torque"),
        rate("driver_inertia_rate_s_a_day", powers.driver_inertia, "driver's inertia"),
        rate("follower_inertia_rate_s_a_day", powers.follower_inertia, "follower's inertia"),
        ReportField::new("friction_power", powers.friction)
            .line("power of the friction", "the mean speed is proportional to this power of the friction"),
    ])
}

impl EscapementDesign {
    /// The further fields of its answer.
    ///
    /// # Errors
    ///
    /// Why there is no steady state, a further argument that is impossible, and a reset angle, for no mechanism has another than its
    /// own.
    pub fn further(&self) -> Result<Vec<ReportField>, Error> {
        if self.question.reset_deg.is_some() {
            return Err(refused!("--reset-deg: further fields are of a real mechanism; leave it out"));
        }
        let mut fields = rates(&self.parameters).map_err(|error| unsteady(&self.question, error))?;
        fields.push(
            ReportField::new("half_friction_gain", self.speed_change(self.parameters.friction() / 2.0)?)
                .line("half the friction", "how much faster the timer runs with it")
                .rounded(Rounding::Percent(0)),
        );
        fields.extend(self.strongest()?);
        fields.extend(self.settling()?);
        if let Some(set) = self.question.further.set_friction {
            fields.push(self.set_right(set)?);
        }
        if let Some(play) = self.question.further.play {
            fields.extend(self.blows(play)?);
        }
        if let Some(joints) = &self.question.further.joints {
            fields.extend(self.with_joints(joints)?);
        }
        Ok(fields)
    }

    /// By what part of itself the mean speed is greater with another friction.
    fn speed_change(&self, friction: f64) -> Result<f64, Error> {
        timer::speed_change(&self.parameters, friction).map_err(|error| unsteady(&self.question, error))
    }

    /// What the timer gains with its friction, if it was set right with another.
    fn set_right(&self, set: f64) -> Result<ReportField, Error> {
        let set = Self::new(EscapementQuestion { friction: set, ..self.question })?;
        Ok(ReportField::in_unit("gain_h_a_day", HOURS * set.speed_change(self.parameters.friction())?, "h a day")
            .line("gain", "set right with another friction"))
    }

    /// The greatest accelerations and the greatest force of a pin in the steady motion.
    fn strongest(&self) -> Result<Vec<ReportField>, Error> {
        let found = Accelerations::new(&self.parameters).map_err(|error| unsteady(&self.question, error))?;
        let acceleration = |key, of: SignedPeak, name| {
            ReportField::new(key, of.value).line(name, "greatest angular acceleration by size")
        };
        let angle = |key, of: SignedPeak| ReportField::in_unit(key, of.angle.to_degrees(), "°");
        let moment = found.normal_moment.value;
        let torque_n_m = self.question.units.map(|units| units.torque_n_m());
        let newtons = torque_n_m.zip(self.question.further.crank_radius);
        Ok(vec![
            acceleration("driver_acceleration", found.driver, "driver"),
            angle("driver_acceleration_angle_deg", found.driver),
            acceleration("follower_acceleration", found.follower, "follower"),
            angle("follower_acceleration_angle_deg", found.follower),
            ReportField::new("follower_acceleration_jump", found.jump)
                .line("follower's jump", "of its acceleration, as the next pin takes over"),
            ReportField::in_unit("pin_force_ratio", moment / self.parameters.torque(), "× spring's force")
                .line("pin force", "greatest by size, over the force of the spring at the crank radius"),
            ReportField::in_unit(
                "pin_force_n",
                newtons.map(|(unit, radius)| moment.abs() * unit / (radius / 1000.0)),
                "N",
            )
            .line("", "in SI units"),
        ])
    }

    /// How fast a small difference of speeds dies away, and what the inertias and the steady motion have besides.
    fn settling(&self) -> Result<Vec<ReportField>, Error> {
        let state = self.steady_state()?;
        let settling = Settling { multiplier: state.multiplier, period: state.period };
        let least = critical_inertia_ratio(self.parameters.mechanism(), self.parameters.friction())?;
        Ok(vec![
            ReportField::new("small_difference_engagements", settling.engagements(PER_CENT))
                .line("settling", "engagements until a small difference of speeds squared is down to one per cent"),
            ReportField::new("small_difference_rise_time", settling.time(PER_CENT)).line("", "time until then"),
            ReportField::new("hand_over_rate", 1.0 / state.period).line("hand-overs", "in a unit of time"),
            ReportField::in_unit("reversal_angle_deg", state.reversal_angle.map(f64::to_degrees), "°")
                .line("reversal", "where the contact changes to the trailing flank"),
            ReportField::new("critical_inertia_ratio", least).line(
                "least inertia ratio",
                "which the driver's inertia over the follower's must exceed at this friction",
            ),
        ])
    }

    /// How hard a pin with play strikes, where the contact changes and as it enters.
    fn blows(&self, play: f64) -> Result<Vec<ReportField>, Error> {
        let crossing = Crossing::new(&self.parameters, play)?;
        let entry = EntryBlow::new(&self.parameters, play)?;
        let radius = self.question.units.and(self.question.further.crank_radius).map(|radius| radius / 1000.0);
        let speed = radius.zip(crossing).map(|(radius, blow)| radius * blow.closing_speed);
        let share = |key, share: Option<f64>, meaning| {
            ReportField::new(key, share).line("energy of a blow", meaning).rounded(Rounding::Percent(1))
        };
        Ok(vec![
            share("crossing_share", crossing.map(|blow| blow.share), "where the contact changes, of a beat's work"),
            ReportField::new("crossing_energy", crossing.map(|blow| blow.energy)).line("", "in the unit of the torque"),
            ReportField::in_unit("crossing_speed_m_s", speed, "m/s").line("", "speed with which pin and flank meet"),
            share("entry_share", Some(entry.share), "as a pin enters, of a beat's work"),
        ])
    }

    /// What a thick pin and journals with friction do to the steady motion.
    fn with_joints(&self, joints: &Joints) -> Result<Vec<ReportField>, Error> {
        let effects = joints::effects(&self.parameters, [(joints.pin_radius, *joints)])?;
        let effect = effects.first();
        let change = effect.map(|effect| effect.mean_speed - 1.0);
        // A faster timer looks like one with less friction.
        let faster = effect.map(|effect| effect.mean_speed).filter(|ratio| *ratio > 1.0);
        let apparent = faster.map(|ratio| timer::apparent_friction(&self.parameters, ratio)).transpose()?;
        Ok(vec![
            ReportField::new("joints_speed_change", change)
                .line("mean speed", "change by the joints")
                .rounded(Rounding::Percent(1)),
            ReportField::new("joints_multiplier", effect.map(|effect| effect.multiplier))
                .line("multiplier", "with these joints"),
            ReportField::new("largest_pin_radius", joints::largest_pin_radius(self.parameters.mechanism()))
                .line("largest pin", "radius in crank radii from which the slots run into one another"),
            ReportField::new("apparent_friction", apparent)
                .line("apparent friction", "found from the mean speed, if the joints are taken as ideal"),
        ])
    }
}

#[cfg(test)]
mod tests {
    use crate::{ReportField, answer, further};

    const FOUR: &str = "escapement --slots 4 --friction 0.2 --torque 2 --driver-inertia 4e-6 --follower-inertia 4e-5";

    #[track_caller]
    fn number(more: &str, key: &str) -> f64 {
        let all = further(&format!("{FOUR} {more}")).expect("further fields");
        all.iter().find(|field| field.key == key).and_then(ReportField::number).expect(key)
    }

    #[track_caller]
    fn near(value: f64, expected: f64) {
        approx::assert_relative_eq!(value, expected, max_relative = 1e-6);
    }

    #[test]
    fn a_gain_is_the_quotient_of_two_mean_speeds() {
        let speed = |friction: f64| {
            let answer = answer(&format!("{FOUR} --friction {friction}")).expect("it runs");
            answer.field("mean_speed").and_then(ReportField::number).expect("a speed")
        };
        near(number("--set-friction 0.15", "gain_h_a_day"), 24.0 * (speed(0.2) / speed(0.15) - 1.0));
        near(number("", "half_friction_gain"), speed(0.1) / speed(0.2) - 1.0);
        // To first order, one per cent.
        let rate = number("", "friction_rate_s_a_day");
        near(rate, 864.0 * number("", "friction_power"));
        assert!((rate / (86_400.0 * (speed(0.202) / speed(0.2) - 1.0)) - 1.0).abs() < 0.02, "{rate}");
    }

    #[test]
    fn a_moment_becomes_a_force_where_the_units_and_the_radius_are_given() {
        let moment = 2.0 * number("", "pin_force_ratio").abs();
        near(number("--units si --crank-radius 5", "pin_force_n"), moment / 0.005);
        let all = further(&format!("{FOUR} --crank-radius 5 --play 0.01")).expect("further fields");
        for key in ["pin_force_n", "crossing_speed_m_s"] {
            assert!(all.iter().any(|field| field.key == key && field.number().is_none()), "{key}");
        }
    }

    #[test]
    fn ideal_joints_change_nothing_and_a_thick_pin_looks_like_less_friction() {
        assert_eq!(number("--pin-radius 0", "joints_speed_change"), 0.0);
        let ideal =
            answer(FOUR).expect("it runs").field("multiplier").and_then(ReportField::number).expect("a multiplier");
        near(number("--pin-radius 0", "joints_multiplier"), ideal);
        let apparent = number("--pin-radius 0.1", "apparent_friction");
        assert!(apparent < 0.2);
        let change = number("--pin-radius 0.1", "joints_speed_change");
        near(number(&format!("--friction {apparent} --set-friction 0.2"), "gain_h_a_day"), 24.0 * change);
        // Journals brake: no less friction has their speed.
        let all = further(&format!("{FOUR} --driver-journal 0.1 --bearing-friction 0.2")).expect("it runs");
        assert!(all.iter().any(|field| field.key == "apparent_friction" && field.number().is_none()));
    }

    #[test]
    fn a_pin_that_leaves_its_slot_before_it_has_crossed_has_no_blow_there() {
        let all = further(&format!("{FOUR} --play 0.9")).expect("it runs");
        let share = |key| all.iter().find(|field| field.key == key).expect(key).number();
        assert!(share("crossing_share").is_none() && share("entry_share").is_some());
        assert!(number("--play 0.01", "crossing_share") > 0.0);
        for (more, words) in
            [("--play 2", "play"), ("--reset-deg 80", "leave it out"), ("--set-friction 0", "no terminal")]
        {
            let error = further(&format!("{FOUR} {more}")).expect_err(more).to_string();
            assert!(error.contains(words), "{error}");
        }
    }
}
