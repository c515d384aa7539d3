//! Why a row of the sheet has no number, although the question gives all that it needs.

use super::design::WheelDesign;
use super::kind::WheelKind;
use crate::{Error, FieldValue, ReportField};

/// A key, the name of its row, and why it has no number.
type EmptyRow = (&'static str, &'static str, &'static str);

const NOT_BY_ITSELF: &str =
    "not worked out for an internal wheel by itself; within the limits of all sizes at once, below, nothing jams";
const NOT_OF_INTERNAL: &str = "not worked out for an internal wheel";
const NO_DISC: &str = "no locking disc: with as many pins as fit, the wheel has no dwell";
const MOVED: &str = "known only with the axes in their place: leave --centre-error out";
const ON_RIM: &str = "none about the wheel's axis: the pin can hit the rim, or comes into no slot";
const NO_FORCE: &str = "none: nothing presses on the pin";

const OF_INTERNAL: &[EmptyRow] = &[
    ("least_clearance_mm", "least clearance", NOT_BY_ITSELF),
    ("centres_nearer_mm", "axes nearer", NOT_BY_ITSELF),
    ("centres_farther_mm", "axes farther", NOT_BY_ITSELF),
    ("dwell_backlash_deg", "backlash in the dwell", NOT_OF_INTERNAL),
];
const OF_INTERNAL_THAT_RUNS: &[EmptyRow] = &[("knock_mm_s", "knock at entry", NOT_OF_INTERNAL)];
const OF_LOADED_INTERNAL: &[EmptyRow] = &[
    ("peak_contact_pressure_mpa", "peak contact pressure", NOT_OF_INTERNAL),
    ("pressure_factor", "pressure factor", NOT_OF_INTERNAL),
    ("pin_factor", "strength factor", NOT_OF_INTERNAL),
    ("blow_energy_mj", "energy of the blow", NOT_OF_INTERNAL),
];
const OF_SPHERICAL: &[EmptyRow] = &[(
    "pin_diameter_mm",
    "pin diameter",
    "no sizes of parts, plays, clearances, pressures and files are worked out for a spherical wheel",
)];
const WITHOUT_DISC: &[EmptyRow] = &[
    ("locking_radius_mm", "locking disc radius", NO_DISC),
    ("crank_radius_tolerance_mm", "longer crank", NO_DISC),
    ("locking_gap_mm", "gap of the disc", NO_DISC),
    ("slot_direction_tolerance_deg", "slot direction", NO_DISC),
    ("dwell_backlash_deg", "backlash in the dwell", NO_DISC),
    ("all_locking_mm", "disc and arc", NO_DISC),
];
const WITH_AXES_MOVED: &[EmptyRow] = &[("dwell_backlash_deg", "backlash in the dwell", MOVED)];
const OF_LOADED: &[EmptyRow] = &[
    ("blow_energy_mj", "energy of the blow", ON_RIM),
    ("drifted_blow_energy_mj", "blow after drift", ON_RIM),
    ("pressure_factor", "pressure factor", NO_FORCE),
    ("pin_factor", "strength factor", NO_FORCE),
];

/// The rows that say why they are empty, the first of each key.
fn empty_rows(design: &WheelDesign) -> Result<impl Iterator<Item = &'static EmptyRow>, Error> {
    let runs = design.speed().is_some();
    let is_loaded = runs && design.inertia.is_some();
    let rows: Vec<&[EmptyRow]> = match (design.wheel.kind(), &design.sizes, design.crank_radius) {
        (WheelKind::External, Some(sizes), _) => {
            let of = |applies: bool, rows: &'static [EmptyRow]| if applies { rows } else { &[] };
            vec![
                of(sizes.locking_disc.is_none(), WITHOUT_DISC),
                of(design.centre_error() != 0.0, WITH_AXES_MOVED),
                of(is_loaded, OF_LOADED),
            ]
        }
        (WheelKind::Internal, _, Some(_)) if design.reported_internal_sizes()?.is_none() => Vec::new(),
        (WheelKind::Internal, _, Some(_)) => {
            let mut rows = vec![OF_INTERNAL];
            rows.extend(runs.then_some(OF_INTERNAL_THAT_RUNS));
            rows.extend(is_loaded.then_some(OF_LOADED_INTERNAL));
            rows
        }
        (WheelKind::Spherical, _, Some(_)) => vec![OF_SPHERICAL],
        _ => Vec::new(),
    };
    Ok(rows.into_iter().flatten())
}

/// The sections of a report with words in each row that would be missing, although all that it needs is given.
///
/// # Errors
///
/// Choices that fit no internal wheel.
pub(super) fn with_reasons(
    design: &WheelDesign,
    mut sections: Vec<(&'static str, Vec<ReportField>)>,
) -> Result<Vec<(&'static str, Vec<ReportField>)>, Error> {
    let rows: Vec<&EmptyRow> = empty_rows(design)?.collect();
    for field in sections.iter_mut().flat_map(|(_, fields)| fields) {
        let is_empty = field.value == FieldValue::Missing && field.line.is_none();
        if let Some((_, name, why)) = rows.iter().find(|(key, ..)| is_empty && *key == field.key) {
            *field = field.clone().words(name, *why);
        }
    }
    Ok(sections)
}

#[cfg(test)]
mod tests {
    use crate::{MechanismReport, ReportField, answer};

    /// What a row says that has no number; none of a row that has one or is not there.
    fn reason<'a>(report: &'a MechanismReport, key: &str) -> Option<&'a str> {
        let field = report.field(key).filter(|field| field.number().is_none())?;
        Some(&field.line.as_ref()?.meaning)
    }

    #[test]
    fn a_row_without_a_number_says_why() {
        let internal = "wheel --stations 6 --type internal --crank-radius 40 --thickness 6 --rpm 60 --inertia 0.002";
        let no_disc = "wheel --stations 4 --pins 4 --crank-radius 25";
        for (question, keys, why) in [
            (
                internal,
                &["least_clearance_mm", "centres_nearer_mm", "centres_farther_mm"][..],
                "all sizes at once, below",
            ),
            (internal, &["dwell_backlash_deg", "knock_mm_s", "peak_contact_pressure_mpa"], "for an internal wheel"),
            (internal, &["pressure_factor", "pin_factor", "blow_energy_mj"], "for an internal wheel"),
            ("wheel --stations 6 --type spherical --crank-radius 40", &["pin_diameter_mm"], "for a spherical wheel"),
            (no_disc, &["locking_gap_mm", "dwell_backlash_deg", "slot_direction_tolerance_deg"], "no locking disc"),
            ("wheel --stations 6 --crank-radius 25 --centre-error 0.01", &["dwell_backlash_deg"], "--centre-error out"),
            (
                "wheel --stations 6 --crank-radius 25 --centre-error 11 --rpm 60 --inertia .001",
                &["drifted_blow_energy_mj"],
                "rim",
            ),
            (
                "wheel --stations 6 --crank-radius 25 --rpm 60 --total-inertia 0",
                &["pressure_factor", "pin_factor"],
                "nothing presses",
            ),
        ] {
            let report = answer(question).expect(question);
            for key in keys {
                let said = reason(&report, key);
                assert!(said.is_some_and(|said| said.contains(why)), "{question}: {key}: {said:?}");
            }
            assert!(report.plain_sheet().split_whitespace().collect::<Vec<_>>().join(" ").contains(why), "{question}");
        }
        // What has a number says nothing else.
        let sound = answer("wheel --stations 6 --crank-radius 25 --rpm 60 --inertia .001").expect("an answer");
        for key in ["dwell_backlash_deg", "least_clearance_mm", "blow_energy_mj", "pin_factor"] {
            assert!(sound.field(key).and_then(ReportField::number).is_some(), "{key}");
        }
    }
}
