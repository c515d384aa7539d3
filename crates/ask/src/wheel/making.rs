//! What a maker asks of a wheel besides: contact and rubbing of the pin, backlash elsewhere, and a cam for comparison.
//!
//! Neither the command's sheet nor its data have these fields. Chapters show them.

use super::design::WheelDesign;
use crate::{Error, Needs, ReportField, Rounding};
use geneva_dynamics::line_contact::{contact_modulus, pressure_at_yield};
use geneva_kinematics::cam::modified_sine_peak;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Sizes;
use std::f64::consts::TAU;

/// Poisson's ratio for which the pressure at yielding is told.
const POISSON: f64 = 0.3;
const MICROMETRES: f64 = 1e6;
const GIGAPASCAL: f64 = 1e9;

impl WheelDesign {
    /// The further fields of its answer. What the question gives too little for is missing.
    ///
    /// # Errors
    ///
    /// Loads that no wheel has.
    pub(crate) fn further(&self) -> Result<Vec<ReportField>, Error> {
        let mut fields = self.drive();
        fields.extend(self.pin()?);
        fields.extend(self.loads_compared()?);
        if let Some(sizes) = &self.sizes {
            fields.extend(self.play(sizes)?);
        }
        Ok(fields)
    }

    fn drive(&self) -> Vec<ReportField> {
        let fourth = |radius: f64| libm::pow(radius / 1000.0, 4.0);
        let own = self.wheel_inertia.zip(self.crank_radius).map(|(own, radius)| own / fourth(radius));
        let share = self.wheel_inertia.zip(self.table_inertia).map(|(own, table)| own / table);
        vec![
            ReportField::in_unit("driver_speed_rad_s", self.speed(), "rad/s")
                .line("driver", "speed")
                .needing(Needs::SPEED),
            ReportField::in_unit("turn_s", self.driver_speed.map(|speed| 60.0 / speed.rpm()), "s")
                .line("", "time of a turn")
                .needing(Needs::SPEED),
            ReportField::in_unit("pin_speed_mm_s", self.pin_speed(), "mm/s")
                .line("pin", "speed on the crank circle")
                .needing(Needs::SIZE.union(Needs::SPEED)),
            ReportField::in_unit("wheel_inertia_factor_kg_m2", own, "kg/m²")
                .line("wheel's inertia", "over the fourth power of the crank radius")
                .needing(Needs::SIZE),
            ReportField::new("wheel_inertia_share", share)
                .line("", "over the table's inertia")
                .needing(Needs::SIZE.union(Needs::TABLE_INERTIA))
                .rounded(Rounding::Percent(0)),
        ]
    }

    /// The pin on the wall of its slot, and what its rubbing costs.
    fn pin(&self) -> Result<Vec<ReportField>, Error> {
        let wheel = self.wheel.indexing();
        let loads = self.loads(wheel)?;
        let question = &self.question;
        let modulus = self.contact.map(|_| contact_modulus(&self.materials.pin, &self.materials.wheel));
        let force = loads.as_ref().and_then(|loads| self.force(loads.pin_moment().driving.value));
        let width = self.contact.zip(force).map(|(contact, force)| contact.width(force)).transpose()?;
        let rubbing = loads.filter(|_| question.pin_friction.is_some());
        let peak = rubbing.as_ref().map(|loads| loads.crank_torque().driving.value);
        let mean = rubbing.as_ref().map(|loads| loads.mean_crank_torque());
        Ok(vec![
            ReportField::in_unit("contact_modulus_gpa", modulus.map(|modulus| modulus / GIGAPASCAL), "GPa")
                .line("modulus of the contact", "E* of pin and wall")
                .needing(Needs::SIZE),
            ReportField::in_unit("contact_width_um", width.map(|width| width * MICROMETRES), "µm")
                .line("width of the contact", "at the peak pin force")
                .needing(Needs::SPEED.union(Needs::INERTIA).union(Needs::SIZE)),
            ReportField::in_unit("pressure_at_yield", pressure_at_yield(POISSON), "× yield stress")
                .line("pressure at yield", "greatest pressure at which a wall begins to yield below its surface"),
            ReportField::in_unit("rubbing_peak_crank_torque_nm", peak, "N m")
                .line("peak crank torque", "with the pin's friction in the slot")
                .needing(Needs::SPEED.union(Needs::INERTIA).union(Needs::PIN_FRICTION)),
            ReportField::in_unit("rubbing_mean_crank_torque_nm", mean, "N m")
                .line("mean crank torque", "with the pin's friction in the slot")
                .needing(Needs::SPEED.union(Needs::INERTIA).union(Needs::PIN_FRICTION)),
        ])
    }

    /// The motor's torque, and a cam's acceleration for the same index in the same time.
    fn loads_compared(&self) -> Result<Vec<ReportField>, Error> {
        let wheel = self.wheel.indexing();
        let share = self.loads(wheel)?.map(|loads| loads.rms_crank_torque() / loads.crank_torque().driving.value);
        // Turns of the driver and of the wheel in an index.
        let (turn, step) = (2.0 * wheel.engagement_half_angle(), TAU / f64::from(wheel.stations()));
        let cam = modified_sine_peak(step, turn) / wheel.acceleration_peak().ratio;
        Ok(vec![
            ReportField::in_unit("rms_crank_torque_share", share, "× peak crank torque")
                .line("RMS crank torque", "over a turn of the driver")
                .needing(Needs::SPEED.union(Needs::INERTIA)),
            ReportField::in_unit("cam_acceleration_share", cam, "× peak acceleration")
                .line("cam", "greatest acceleration by the modified-sine law, for the same index in the same time"),
        ])
    }

    /// What play and wrong axes do.
    fn play(&self, sizes: &Sizes) -> Result<Vec<ReportField>, Error> {
        let question = &self.question;
        let mm = |key, length: Option<f64>| ReportField::in_unit(key, length, "mm");
        let degrees = |key, radians: Option<f64>| ReportField::in_unit(key, radians.map(f64::to_degrees), "°");
        let play = sizes.dwell_play();
        let held = play.zip(sizes.dwell_angle()).map(|(play, dwell)| play.held * dwell);
        let before = question.before_entry.and_then(|degrees| sizes.dwell_play_at(degrees.to_radians()));
        let entry = sizes.entry(self.centre_error());
        let late = entry.map(|entry| entry.crank_angle + sizes.wheel.engagement_half_angle());
        let direction = sizes.slot_direction_tolerance().map(|angle| angle * sizes.wheel_radius);
        let tolerance = self.clearance()?.map(|(_, tolerance)| tolerance);
        let fields = vec![
            mm("slot_gap_mm", Some(sizes.slot_gap())).line("slot gap", "to either side of the pin"),
            mm("clearance_tolerance_mm", tolerance).line("least clearance", "known to this tolerance"),
            mm("deepest_pin_mm", Some(sizes.deepest())).line("deepest pin", "from the wheel's axis, at mid-index"),
            mm("unhindered_pin_mm", Some(sizes.unhindered_pin())).line("thick pin", "if everything left it room"),
            mm("slot_direction_at_rim_mm", direction)
                .line("slot direction", "a slot's end may be this far out of place"),
            degrees("index_backlash_deg", Some(sizes.index_backlash(0.0)?)).line("backlash", "at mid-index"),
            degrees("dwell_backlash_held_deg", held).line("", "of crank angle, in which that of mid-dwell holds"),
            degrees("backlash_before_entry_deg", before.map(|[forwards, _]| forwards))
                .line("", "forwards, so far before a pin enters")
                .needing(Needs::SIZE.union(Needs::BEFORE_ENTRY)),
            mm("greatest_dwell_backlash_at_rim_mm", play.map(|play| play.greatest * sizes.wheel_radius))
                .line("greatest backlash", "at the wheel radius"),
            ReportField::in_unit(
                "greatest_dwell_backlash_ratio",
                play.map(|play| play.greatest / play.middle),
                "× mid-dwell's",
            )
            .line("", ""),
            mm("centre_error_mm", Some(self.centre_error())).line("axes", "too far apart by"),
            mm("locking_overlap_mm", sizes.locking_gap().map(|gap| self.centre_error() - gap))
                .line("disc", "deeper in the arc than it fits, with the axes nearer by as much"),
            degrees("late_entry_deg", late).line("entry", "of the pin, late by"),
            self.blow_at_entry(),
        ];
        Ok(ReportField::all_needing(fields, Needs::SIZE))
    }

    /// The knock of a pin as it enters, with the axes as far apart as the question says. Missing where it meets no slot.
    pub(super) fn blow_at_entry(&self) -> ReportField {
        let entry = self.sizes.as_ref().and_then(|sizes| sizes.entry(self.centre_error())).zip(self.pin_speed());
        ReportField::in_unit("entry_knock_mm_s", entry.map(|(entry, speed)| entry.closing_speed * speed), "mm/s")
            .line("knock at entry", "if the wheel is in the middle of its backlash")
            .needing(Needs::SIZE.union(Needs::SPEED))
            .rounded(Rounding::Significant(3))
    }
}

#[cfg(test)]
mod tests {
    use crate::{ReportField, answer, further};

    const SIX: &str = "wheel --stations 6 --crank-radius 25 --rpm 60 --inertia 0.002 --friction-torque 0.1 --thickness 10 \
                       --density 7800 --pin-material steel --wheel-material steel --pin-friction 0.15 --before-entry 20";

    fn number(question: &str, key: &str) -> Option<f64> {
        let all = further(question).expect("further fields");
        all.iter().find(|field| field.key == key).expect(key).number()
    }

    #[test]
    fn with_all_that_is_asked_for_every_number_is_there_and_under_a_key_of_its_own() {
        let (answer, further) = (answer(SIX).expect("an answer"), further(SIX).expect("further fields"));
        let mut keys: Vec<_> = answer.fields().chain(&further).map(|field| field.key).collect();
        for field in &further {
            assert!(field.number().is_some_and(f64::is_finite), "{}", field.key);
            assert!(field.line.is_some(), "{} has no name", field.key);
        }
        keys.sort_unstable();
        let all = keys.len();
        keys.dedup();
        assert_eq!(keys.len(), all, "two fields have one key");
    }

    #[test]
    fn a_blow_with_the_axes_in_place_is_the_knock_of_the_answer_and_apart_it_is_less() {
        let knock = answer(SIX).expect("an answer").field("knock_mm_s").and_then(ReportField::number).expect("a knock");
        let blow = |error: &str| number(&format!("{SIX} --centre-error {error}"), "entry_knock_mm_s").expect("met");
        approx::assert_relative_eq!(blow("0"), knock, max_relative = 1e-12);
        assert!(blow("0.02") < knock);
    }

    #[test]
    fn what_the_question_gives_too_little_for_is_missing() {
        for key in ["pin_speed_mm_s", "contact_width_um", "rubbing_peak_crank_torque_nm", "rms_crank_torque_share"] {
            assert_eq!(number("wheel --stations 6", key), None, "{key}");
        }
    }
}
