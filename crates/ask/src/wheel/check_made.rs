//! Play, errors and blows of a wheel as it was made, as far as the sizes on which they rest were measured.

use super::check::CheckQuestion;
use super::check_needs::{ENTRY, INDEX, UnmeasuredSize, dwell, is_measured, options, unmeasured, unmeasured_to_turn};
use super::check_words::place;
use crate::ReportField;
use geneva_kinematics::wheel::as_built::{AsBuiltWheel, BuiltTurn, MeasuredSize, StationTurn};
use std::f64::consts::PI;

/// A field that is told only if nothing is missing for it; otherwise its line says what to measure.
fn known(
    field: ReportField,
    name: &'static str,
    meaning: &'static str,
    missing: &[UnmeasuredSize],
    of_what: &str,
) -> ReportField {
    if missing.is_empty() {
        field.line(name, meaning)
    } else {
        field.words(name, format!("not known {of_what}; it needs {}", options(missing)))
    }
}

impl CheckQuestion {
    /// The play of the loosest measured slot in mid-index, in radians from end to end. What was not measured leaves the pin free: neither the
    /// ends of the slots nor a cut that the disc was filled in with take play away. Zero where
    /// the pin is too thick.
    fn slot_play(&self, built: &AsBuiltWheel, turn: &BuiltTurn) -> f64 {
        let has = |size: MeasuredSize| self.measured.sizes().iter().any(|of| of.size.name() == size.name());
        let mut measured = built.clone();
        if !has(MeasuredSize::CrescentCentre) || !has(MeasuredSize::CrescentRadius) {
            measured.disc_radius = None;
        }
        if !has(MeasuredSize::SlotEnd(None)) {
            let crank = measured.pins().iter().map(|pin| pin.crank_radius).fold(0.0, f64::max);
            let deep = (measured.centre_distance - crank) / 2.0;
            measured.slots_mut().iter_mut().for_each(|slot| slot.end = slot.end.min(deep));
        }
        let has_slot = |slot: usize| is_measured(&self.measured, MeasuredSize::SlotWidth(None), Some(slot));
        // Events come in the order of the stations.
        let events = turn.stations.iter().zip(0_i64..).filter(|(station, _)| has_slot(station.slot));
        let plays = events.filter_map(|(_, event)| Some(measured.free_angles(event, 0.0).ok()?.width()));
        plays.fold(0.0, f64::max)
    }

    /// Play, errors and blows of the wheel as it was made.
    pub(super) fn as_made(&self, built: &AsBuiltWheel, turn: &BuiltTurn) -> Vec<ReportField> {
        let measured = &self.measured;
        let degrees = |key, value: Option<f64>| ReportField::in_unit(key, value.map(f64::to_degrees), "°");
        // Of stations whose slot or arc was not measured nothing is told.
        let has_slot = |of: &&StationTurn| is_measured(measured, MeasuredSize::SlotWidth(None), Some(of.slot));
        let has_arc = |of: &&StationTurn| {
            built.disc_radius.is_none() || is_measured(measured, MeasuredSize::ArcRadius(None), Some(of.arc))
        };
        let most_of_arcs =
            |of: fn(&StationTurn) -> f64| turn.stations.iter().filter(has_arc).map(of).fold(0.0, f64::max);
        let needed = |sizes: &[MeasuredSize]| {
            let mut missing = unmeasured(measured, sizes);
            // Some slots or arcs are enough to speak of these.
            missing.retain(UnmeasuredSize::is_of_all);
            missing
        };
        let (no_index, no_dwell, no_entry) = (needed(INDEX), needed(dwell(built)), needed(ENTRY));
        let not_all = unmeasured_to_turn(measured, built);
        let slot_play = self.slot_play(built, turn);
        let or_none = |missing: &[UnmeasuredSize], value: f64| missing.is_empty().then_some(value);

        let of_entries = || turn.stations.iter().filter(has_slot).filter_map(|station| station.entry);
        let lost = of_entries().map(|entry| entry.lost_motion);
        let lost = lost.fold(0.0, |one: f64, other| if other.abs() > one.abs() { other } else { one });
        let centred = or_none(&no_entry, of_entries().map(|entry| entry.centred).fold(0.0, f64::max));
        let greatest = or_none(&not_all, turn.greatest_blow());
        let crank = built.pins().iter().map(|pin| pin.crank_radius).fold(0.0, f64::max);
        let speed = self.rpm.map(|rpm| rpm * 2.0 * PI / 60.0 * crank);
        let tightest = or_none(&not_all, turn.tightest.free.room());
        let greatest_words = "the greatest, wherever the wheel rests";
        // Arcs or slots that are all alike have no errors of their own, which is no measurement of them.
        let has_disc = built.disc_radius.is_some();
        let is_of_one = |size: MeasuredSize| match size {
            MeasuredSize::ArcRadius(Some(_)) | MeasuredSize::ArcCentre(Some(_)) => has_disc,
            MeasuredSize::SlotWidth(Some(_)) | MeasuredSize::SlotDirection(_) => !has_disc,
            _ => false,
        };
        let has_single_parts = measured.sizes().iter().any(|of| is_of_one(of.size));
        let station_error = most_of_arcs(|station| station.station_error.abs());
        let station_error = Some(station_error).filter(|_| has_single_parts && no_dwell.is_empty());
        let error = degrees("station_error_deg", station_error);
        let error = match station_error {
            Some(_) => error.line("station error", "how far the worst station rests from its right place"),
            None if has_disc => error.words(
                "station error",
                "not known; it needs --locking-disc-radius, and each arc by itself as in --locking-arc-radius 1:15.1,2:15.2",
            ),
            None => error.words("station error", "not known; it needs each slot by itself, as in --slot-width 1:6.1,2:6.0"),
        };
        vec![
            ReportField::in_unit("tightest_room_mm", tightest, "mm")
                .line("tightest place", format!("room of the wheel there; {}", place(&turn.tightest))),
            degrees("tightest_crank_angle_deg", or_none(&not_all, turn.tightest.crank_angle))
                .line("", "crank angle from the line of centres there"),
            known(
                degrees("index_backlash_deg", or_none(&no_index, slot_play)),
                "backlash",
                "at mid-index from end to end, of the loosest station that was measured",
                &no_index,
                "at mid-index",
            ),
            known(
                degrees("dwell_backlash_deg", or_none(&no_dwell, most_of_arcs(|station| station.dwell_backlash))),
                "",
                "in the middle of the dwell",
                &no_dwell,
                "in the dwell",
            ),
            degrees("greatest_dwell_backlash_deg", or_none(&not_all, turn.greatest_dwell_backlash()))
                .line("", "the greatest in the dwell, near its ends, where the pin is beside its slot"),
            error,
            degrees("lost_motion_deg", or_none(&no_entry, lost)).line(
                "lost motion",
                "of the crank, from where a right pin enters to where the slot is met; below zero too early",
            ),
            ReportField::new("blow_ratio", centred)
                .line("blow", "over the pin's speed, with the wheel in the middle of its backlash"),
            ReportField::new("greatest_blow_ratio", greatest).line("", greatest_words),
            ReportField::in_unit("blow_mm_s", speed.zip(centred).map(|(speed, centred)| speed * centred), "mm/s")
                .in_other_unit(),
            ReportField::in_unit(
                "greatest_blow_mm_s",
                speed.zip(greatest).map(|(speed, greatest)| speed * greatest),
                "mm/s",
            )
            .in_other_unit(),
            ReportField::new("can_miss", not_all.is_empty().then_some(turn.can_miss())),
        ]
    }
}
