//! A wheel that exists, by its measured sizes: which right wheel is nearest, which size contradicts the others, does it turn, and what
//! to change first.

use super::check_arguments::{CHECK_ARGUMENTS, measured_error};
use super::check_certainty::{ShallowSlot, TooCoarse, is_chance, shallow_slots, too_coarse};
use super::typed_question::length;
use crate::number_format::{as_typed, count, number, to_digits};
use crate::{DataRow, Error, FieldValue, Item, MechanismReport, ReportField, Rounding, pairs};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{
    AsBuiltWheel, BuiltBlow, BuiltContact, BuiltError, BuiltTurn, Culprit, Jam, KnownMistake, MeasuredSize,
    MeasuredWheel, NearestWheel, SizeChange, StationTurn,
};
use geneva_kinematics::wheel::{SizesError, Wheel};
use geneva_workshop::{Drawing, DrawingError, LayerNames};
use std::f64::consts::PI;

/// What is asked of a wheel that exists.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckQuestion {
    /// The measured sizes.
    pub measured: MeasuredWheel,
    /// Speed of the driver in turns per minute; with it, blows are told in mm/s.
    pub rpm: Option<f64>,
    /// Diameter, in millimetres, of the holes of screws that a drawing has in place of the pins.
    pub screw_hole: Option<f64>,
    /// Whether a drawing has chamfered, rounded or widened mouths.
    pub has_mouths: bool,
}

/// The standard uncertainty of a size without one, in millimetres: that of a calliper, our choice.
pub const UNCERTAINTY: f64 = 0.05;

impl CheckQuestion {
    /// Reads arguments as they are typed: `--stations 6 --centre-distance 50 --crank-radius 25+-0.02 --slot-width 1:6.1,2:6.0`.
    ///
    /// ```
    /// use geneva_ask::wheel::CheckQuestion;
    ///
    /// let question = CheckQuestion::parse("--stations 6 --centre-distance 50.4 --crank-radius 25 --outside-diameter 87.1")?;
    /// let report = question.answer()?;
    /// assert_eq!(report.field("culprit").map(|field| &field.value), Some(&"centre distance".into()));
    /// # Ok::<(), geneva_ask::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// An argument that there is not, one that is missing, and a value that it can't have.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let given: Vec<(&str, &str)> = pairs(text).collect::<Result<_, _>>()?;
        let value = |name: &str| given.iter().rev().find(|(of, _)| *of == name).map(|(_, value)| *value);
        let whole = |name: &str| value(name).map(|text| crate::number::<u32>(name, text)).transpose();
        let stations = whole("stations")?
            .ok_or_else(|| refused!("--stations is missing; count the slots of the wheel and give their number"))?;
        let mut question = Self::new(stations, whole("pins")?.unwrap_or(1))?;
        let uncertainty = value("uncertainty").map(|text| length("uncertainty", text)).transpose()?;
        for (name, text) in &given {
            if !["stations", "pins", "uncertainty", "rpm"].contains(name) {
                question.add(name, text, uncertainty.unwrap_or(UNCERTAINTY))?;
            }
        }
        let rpm = value("rpm").map(|text| crate::number::<f64>("rpm", text)).transpose()?;
        if let Some(rpm) = rpm.filter(|rpm| !(*rpm > 0.0 && rpm.is_finite())) {
            return Err(refused!("--rpm {}: the driver must turn; give a speed above zero", as_typed(rpm)));
        }
        Ok(Self { rpm, ..question })
    }

    /// A wheel of which nothing is measured yet.
    ///
    /// # Errors
    ///
    /// Numbers of stations and pins that no wheel has.
    pub fn new(stations: u32, pins: u32) -> Result<Self, Error> {
        let measured = MeasuredWheel::new(Wheel::with_pins(stations, pins)?);
        Ok(Self { measured, rpm: None, screw_hole: None, has_mouths: false })
    }

    /// A wheel of which a drawing in DXF has the sizes, each with this standard uncertainty in millimetres.
    ///
    /// # Errors
    ///
    /// A text that is no drawing, and one without the layers or the shapes of a wheel.
    pub fn of_drawing(text: &str, layers: &LayerNames, uncertainty: f64) -> Result<Self, Error> {
        let in_words = |error: DrawingError| Error::Argument(error.to_string());
        let drawing = Drawing::read(text).map_err(in_words)?;
        let drawn = drawing.measure(layers, uncertainty).map_err(in_words)?;
        Ok(Self { measured: drawn.measured, rpm: None, screw_hole: drawn.screw_hole, has_mouths: drawn.has_mouths })
    }

    /// Adds a size as it is typed, `6.1`, `6.1+-0.02`, `1/4in` or `1:6.1,2:6.0`; one without an uncertainty has this one, in millimetres.
    ///
    /// # Errors
    ///
    /// A size that is not measured, and a value that it can't have.
    pub fn add(&mut self, name: &str, text: &str, uncertainty: f64) -> Result<(), Error> {
        let Some(argument) = CHECK_ARGUMENTS.iter().find(|argument| argument.name == name) else {
            let all: Vec<String> = CHECK_ARGUMENTS.iter().map(|argument| format!("--{}", argument.name)).collect();
            return Err(refused!("--{name}: not a size that is measured; give {}", all.join(", ")));
        };
        argument.add(&mut self.measured, text, uncertainty)
    }

    /// The answer.
    ///
    /// # Errors
    ///
    /// Sizes that don't tell how large the wheel is, or that no wheel has.
    pub fn answer(&self) -> Result<MechanismReport, Error> {
        let nearest = self.measured.nearest().map_err(measured_error)?;
        let built = self.measured.as_built(&nearest);
        let turn = built.turn().map_err(built_error)?;
        let coarse = turn.jam.as_ref().and_then(|jam| too_coarse(&self.measured, jam));
        // What may be chance is nothing to mend.
        let changes = if coarse.is_none() { built.least_changes().map_err(built_error)? } else { Vec::new() };
        let shallow = shallow_slots(&self.measured, &built);
        let mistakes = self.measured.known_mistakes();
        let wheel = self.measured.wheel();
        let items = nearest.residuals.iter().map(item).collect();
        let report = MechanismReport {
            title: format!(
                "A Geneva wheel as it was made: {}, driver with {}",
                count(wheel.stations() as usize, "station"),
                count(wheel.pins() as usize, "pin")
            ),
            introduction: "What was not measured is taken from the nearest right wheel. Slots and arcs are numbered counter-clockwise from 1.",
            sections: vec![
                ("Verdict", self.verdict(&turn, &nearest, &mistakes, &changes, coarse, &shallow)),
                (right_heading(&nearest), right_sizes(&nearest)),
                ("As it was made", self.as_made(&built, &turn)),
            ],
            list: Some(("measurements", items)),
            note: note(self, &nearest),
        };
        match report.not_finite() {
            None => Ok(report),
            Some(key) => Err(super::design::too_large(key)),
        }
    }

    /// A remark on pin and slots that are taken from the nearest right wheel; empty if they were measured.
    fn unmeasured(&self, nearest: &NearestWheel) -> String {
        let is_slot = |size| matches!(size, MeasuredSize::SlotWidth(_));
        let has_slot = self.measured.sizes().iter().any(|of| is_slot(of.size));
        let [pin, slot] = [nearest.pin_diameter, nearest.slot_width].map(number);
        match (self.is_pin_measured(), has_slot) {
            (true, true) => String::new(),
            (false, true) => format!("; this is with a pin of {pin} mm, which was not measured"),
            (true, false) => format!("; this is with slots of {slot} mm, which were not measured"),
            (false, false) => {
                format!("; this is with a pin of {pin} mm and slots of {slot} mm, which were not measured")
            }
        }
    }

    fn is_pin_measured(&self) -> bool {
        self.measured.sizes().iter().any(|of| of.size == MeasuredSize::PinDiameter)
    }

    /// Play, errors and blows of the wheel as it was made.
    fn as_made(&self, built: &AsBuiltWheel, turn: &BuiltTurn) -> Vec<ReportField> {
        let most = |of: fn(&StationTurn) -> f64| turn.stations.iter().map(of).fold(0.0, f64::max);
        let lost = turn.stations.iter().filter_map(|station| station.entry).map(|entry| entry.lost_motion);
        let lost = lost.fold(0.0, |one: f64, other| if other.abs() > one.abs() { other } else { one });
        let degrees = |key, value: f64| ReportField::in_unit(key, value.to_degrees(), "°");
        let crank = built.pins().iter().map(|pin| pin.crank_radius).fold(0.0, f64::max);
        let speed = self.rpm.map(|rpm| rpm * 2.0 * PI / 60.0 * crank);
        let centred = most(|station| station.entry.map_or(0.0, |entry| entry.centred));
        let tightest = turn.tightest;
        vec![
            ReportField::in_unit("tightest_room_mm", tightest.free.room(), "mm")
                .line("tightest place", format!("room of the wheel there; {}", place(&tightest))),
            degrees("tightest_crank_angle_deg", tightest.crank_angle)
                .line("", "crank angle from the line of centres there"),
            degrees("index_backlash_deg", most(|station| station.index_backlash))
                .line("backlash", "at mid-index from end to end, of the loosest station"),
            degrees("dwell_backlash_deg", most(|station| station.dwell_backlash))
                .line("", "in the middle of the dwell"),
            degrees("greatest_dwell_backlash_deg", turn.greatest_dwell_backlash())
                .line("", "the greatest in the dwell"),
            degrees("station_error_deg", most(|station| station.station_error.abs()))
                .line("station error", "how far the worst station rests from its right place"),
            degrees("lost_motion_deg", lost).line(
                "lost motion",
                "of the crank, from where a right pin enters to where the slot is met; below zero too early",
            ),
            ReportField::new("blow_ratio", centred)
                .line("blow", "over the pin's speed, with the wheel in the middle of its backlash"),
            ReportField::new("greatest_blow_ratio", turn.greatest_blow())
                .line("", "the greatest, wherever the wheel rests"),
            ReportField::in_unit("blow_mm_s", speed.map(|speed| speed * centred), "mm/s").in_other_unit(),
            ReportField::in_unit("greatest_blow_mm_s", speed.map(|speed| speed * turn.greatest_blow()), "mm/s")
                .in_other_unit(),
            ReportField::new("can_miss", turn.can_miss()),
        ]
    }
}

fn built_error(error: BuiltError) -> Error {
    Error::Argument(error.to_string())
}

/// A size with its number, in words.
fn named(size: MeasuredSize) -> String {
    size.number().map_or_else(|| size.name().to_owned(), |number| format!("{} {}", size.name(), number + 1))
}

/// A value in millimetres, or of a direction in degrees, with its unit.
fn with_unit(size: MeasuredSize, value: f64) -> String {
    let (value, unit) = typed(size, value);
    format!("{} {unit}", number(value))
}

fn typed(size: MeasuredSize, value: f64) -> (f64, &'static str) {
    if matches!(size, MeasuredSize::SlotDirection(_)) { (value.to_degrees(), "°") } else { (value, "mm") }
}

fn contact(contact: BuiltContact) -> &'static str {
    match contact {
        BuiltContact::PinOnWall => "the pin on a wall of slot",
        BuiltContact::PinAtMouth => "the pin at the mouth of slot",
        BuiltContact::PinAtBottom => "the pin at the end of slot",
        BuiltContact::DiscInArc => "the disc in arc",
        BuiltContact::OpeningEdge => "an edge of the crescent in arc",
        BuiltContact::Crescent => "the crescent at a horn of arc",
        BuiltContact::Nothing => "nothing at slot",
    }
}

/// Between which parts a place is tight.
fn place(tightest: &Jam) -> String {
    let [one, other] = [tightest.free.backward, tightest.free.forward]
        .map(|limit| format!("{} {}", contact(limit.contact), limit.part + 1));
    if one == other { one } else { format!("{one} and {other}") }
}

/// The stations at which the pin comes in on the corner of a mouth.
fn corners(turn: &BuiltTurn) -> impl Iterator<Item = (&StationTurn, BuiltBlow)> {
    let entries = turn.stations.iter().filter_map(|station| Some((station, station.entry?)));
    entries.filter(|(_, entry)| entry.contact == BuiltContact::PinAtMouth)
}

/// What the pin meets as it comes in, the wheel in the middle of its play.
fn entry_words(turn: &BuiltTurn) -> String {
    // Of blows that differ by rounding the first is taken.
    fn harder<'a>(
        one: (&'a StationTurn, BuiltBlow),
        other: (&'a StationTurn, BuiltBlow),
    ) -> (&'a StationTurn, BuiltBlow) {
        if other.1.centred > one.1.centred + 1e-9 { other } else { one }
    }
    let all = || turn.stations.iter().filter_map(|station| Some((station, station.entry?)));
    let Some((station, entry)) = corners(turn).reduce(harder).or_else(|| all().reduce(harder)) else {
        return "the pin meets nothing".to_owned();
    };
    let met = match entry.contact {
        BuiltContact::PinAtMouth => {
            let further = corners(turn).count() - 1;
            let also =
                if further == 0 { String::new() } else { format!(", and so at {}", count(further, "further slot")) };
            format!("the pin lands on the corner of the mouth of slot {}{also}", station.slot + 1)
        }
        BuiltContact::PinAtBottom => format!("the pin meets the end of slot {}", station.slot + 1),
        _ => format!("the pin meets a wall inside slot {}", station.slot + 1),
    };
    let late = entry.lost_motion.to_degrees();
    let sense = if late < 0.0 { "before" } else { "after" };
    format!(
        "{met}, {}° of the crank {sense} a right pin would enter, with {} of its speed",
        to_digits(late.abs(), 2),
        to_digits(entry.centred, 2)
    )
}

/// Whether the wheel turns, in words.
fn turning_words(turn: &BuiltTurn, coarse: Option<TooCoarse>) -> String {
    let lands = corners(turn).next().is_some();
    match (&turn.jam, coarse) {
        (Some(_), Some(coarse)) => format!(
            "the measurements are too coarse for this wheel: {} mm seem to be missing, but with these uncertainties chance alone can \
             take {} mm; measure again, with uncertainties of {} of these or less",
            number(coarse.missing),
            number(coarse.by_chance),
            to_digits(coarse.finer, 2)
        ),
        (Some(jam), None) => format!(
            "no: {} mm are missing at a crank angle of {}°, pin {} and slot {}: {}",
            number(-jam.free.room()),
            number(jam.crank_angle.to_degrees()),
            jam.pin + 1,
            jam.slot + 1,
            place(jam)
        ),
        (None, _) if turn.can_miss() => {
            "yes, but the wheel can stand so in the dwell that a pin meets its rim beside the slot".to_owned()
        }
        (None, _) if lands => "yes, but the pin doesn't enter freely: it pushes the corner of a mouth aside".to_owned(),
        (None, _) => "yes, every station".to_owned(),
    }
}

/// Which slots are too shallow, and by how much.
fn shallow_words(shallow: &[ShallowSlot], slots: usize) -> String {
    let most = shallow.iter().map(|slot| slot.missing).fold(0.0, f64::max);
    let least = shallow.iter().map(|slot| slot.missing).fold(f64::INFINITY, f64::min);
    if shallow.is_empty() {
        return "none too shallow for the pin that is known of".to_owned();
    }
    if shallow.len() == slots && most - least < ALIKE {
        return format!("all slots are {} mm too shallow for the pin", number(most));
    }
    let each: Vec<String> = shallow
        .iter()
        .map(|of| format!("slot {} is {} mm too shallow for the pin", of.slot + 1, number(of.missing)))
        .collect();
    each.join(", ")
}

/// Depths that differ by less than this, in millimetres, are alike.
const ALIKE: f64 = 1e-9;

impl CheckQuestion {
    fn verdict(
        &self,
        turn: &BuiltTurn,
        nearest: &NearestWheel,
        mistakes: &[KnownMistake],
        changes: &[SizeChange],
        coarse: Option<TooCoarse>,
        shallow: &[ShallowSlot],
    ) -> Vec<ReportField> {
        let turns = turning_words(turn, coarse) + &self.unmeasured(nearest);
        // What the other sizes ask for instead.
        let expected = nearest.culprit.map(|culprit| typed(culprit.size, culprit.expected));
        let culprits: Vec<String> = culprits(nearest).map(culprit_words).collect();
        let without = match &nearest.refusal {
            Some(SizesError::DoesNotFit { by, .. }) if is_chance(&self.measured, *by) => {
                "none: within their uncertainties, all measured sizes fit one right wheel".to_owned()
            }
            Some(error) => format!("no wheel has exactly these sizes, so one of them is wrong: {}", error.reason()),
            None => "none: all measured sizes fit one right wheel".to_owned(),
        };
        let names: Vec<FieldValue> = mistakes.iter().map(|mistake| mistake.name().into()).collect();
        let explained: Vec<&str> = mistakes.iter().map(|mistake| mistake.explanation()).collect();
        let first = first_change(nearest, changes, shallow);
        let missing = shallow.iter().map(|of| of.missing).reduce(f64::max);
        let numbers = shallow.iter().map(|of| FieldValue::from(of.slot + 1)).collect();
        vec![
            ReportField::new("turns", coarse.is_none().then_some(turn.jam.is_none())).words("turns", turns),
            ReportField::new("lands_on_corner", corners(turn).next().is_some()).words("entry", entry_words(turn)),
            ReportField::new("shallow_slots", FieldValue::List(numbers))
                .words("slots", shallow_words(shallow, self.measured.wheel().stations() as usize)),
            ReportField::in_unit("missing_depth_mm", missing, "mm"),
            ReportField::new("culprit", nearest.culprit.map(|culprit| named(culprit.size))).words(
                "contradiction",
                if culprits.is_empty() { without } else { culprits.join(". Besides, ") + &rest_words(nearest) },
            ),
            ReportField::in_unit(
                "culprit_expected",
                expected.map(|(value, _)| value),
                expected.map_or("", |(_, unit)| unit),
            ),
            ReportField::in_unit(
                "culprit_expected_uncertainty",
                nearest.culprit.and_then(|culprit| Some(typed(culprit.size, culprit.expected_uncertainty?).0)),
                expected.map_or("", |(_, unit)| unit),
            ),
            ReportField::new("wrong_formulas", FieldValue::List(names)).words(
                "wrong formula",
                if explained.is_empty() { "none that we know".to_owned() } else { explained.join("; ") },
            ),
            ReportField::new("change_first", first.clone())
                .words("change first", first.unwrap_or_else(|| "nothing".to_owned())),
        ]
    }
}

/// All sizes that contradict the others, the worst first.
fn culprits(nearest: &NearestWheel) -> impl Iterator<Item = &Culprit> {
    nearest.culprit.iter().chain(&nearest.further_culprits)
}

fn culprit_words(culprit: &Culprit) -> String {
    let (expected, unit) = typed(culprit.size, culprit.expected);
    let uncertainty = culprit
        .expected_uncertainty
        .map_or_else(String::new, |uncertainty| format!(" ± {}", to_digits(typed(culprit.size, uncertainty).0, 1)));
    format!(
        "{} {}: the others ask for {}{uncertainty} {unit}, {} of its uncertainties away",
        named(culprit.size),
        with_unit(culprit.size, culprit.measured),
        number(expected),
        to_digits(culprit.uncertainties.abs(), 2)
    )
}

/// What is said of the sizes that don't contradict.
fn rest_words(nearest: &NearestWheel) -> String {
    let agrees = nearest.culprit.is_some_and(|culprit| culprit.rest_agrees);
    let rest = if agrees { "; all others agree" } else { "; and the others contradict each other, too" };
    let suspects: Vec<String> = nearest.suspects.iter().map(|size| named(*size)).collect();
    let first = nearest.culprit.map_or_else(String::new, |culprit| named(culprit.size));
    if suspects.is_empty() {
        rest.to_owned()
    } else {
        format!("{rest}. Instead of the {first} it could be the {}", suspects.join(" or the "))
    }
}

/// What to change first: the size that contradicts the others, or else the least change with which the wheel turns.
fn first_change(nearest: &NearestWheel, changes: &[SizeChange], shallow: &[ShallowSlot]) -> Option<String> {
    let right: Vec<String> = culprits(nearest)
        .map(|culprit| format!("{} {}", named(culprit.size), with_unit(culprit.size, culprit.expected)))
        .collect();
    let by_culprit = (!right.is_empty()).then(|| format!("make {}", right.join(", then ")));
    let is_deeper = |change: &&SizeChange| matches!(change.size, MeasuredSize::SlotEnd(_)) && !shallow.is_empty();
    let by_change = changes.iter().find(is_deeper).or(changes.first()).map(|change| {
        let sense = if change.by > 0.0 { "larger" } else { "smaller" };
        format!("make {} {} mm {sense}, and a little more for play", named(change.size), number(change.by.abs()))
    });
    match (by_culprit, by_change) {
        (Some(culprit), Some(change)) => Some(format!("{culprit}; or, to make it turn at all, {change}")),
        (one, other) => one.or(other),
    }
}

/// Which right wheel is shown.
fn right_heading(nearest: &NearestWheel) -> &'static str {
    if nearest.culprit.is_some() {
        "Nearest right wheel, without the sizes that contradict it"
    } else {
        "Nearest right wheel"
    }
}

fn right_sizes(nearest: &NearestWheel) -> Vec<ReportField> {
    let mm = |key, value: f64, name, meaning: &'static str| ReportField::in_unit(key, value, "mm").line(name, meaning);
    vec![
        mm("crank_radius_mm", nearest.crank_radius, "crank radius", "driver's axis to a pin's centre"),
        mm("centre_distance_mm", nearest.centre_distance, "centre distance", "wheel's axis to driver's axis"),
        mm("tip_radius_mm", nearest.tip_radius, "rim", "radius, half of the outside diameter"),
        mm("pin_diameter_mm", nearest.pin_diameter, "pin", "diameter"),
        mm("slot_width_mm", nearest.slot_width, "slot", "width"),
        mm("slot_end_mm", nearest.slot_end, "", "wheel's axis to the centre of its round end"),
        mm("locking_arc_radius_mm", nearest.arc_radius, "locking arc", "radius"),
        mm("locking_disc_radius_mm", nearest.disc_radius, "locking disc", "radius"),
        mm("crescent_centre_mm", nearest.crescent_centre, "crescent", "driver's axis to its centre"),
        mm("crescent_radius_mm", nearest.crescent_radius, "", "radius"),
    ]
}

fn item(residual: &geneva_kinematics::wheel::as_built::Residual) -> Item {
    let of = residual.measured;
    let ((value, unit), (right, _)) = (typed(of.size, of.value), typed(of.size, residual.right));
    let (uncertainty, _) = typed(of.size, of.uncertainty);
    // Of an uncertainty two digits count, and of a difference what is more than rounding.
    let shown: f64 = format!("{uncertainty:.1e}").parse().unwrap_or(uncertainty);
    let difference = if residual.normalized.abs() < LEAST_DIFFERENCE { 0.0 } else { residual.normalized };
    let heading = of.size.name();
    let numbered = of.size.number().map(|number| number + 1);
    let which = numbered.map_or_else(String::new, |number| format!(", number {number}"));
    Item {
        heading,
        fields: vec![
            ReportField::in_unit("measured", value, unit).line("measured", format!("± {}{which}", as_typed(shown))),
            ReportField::in_unit("right", right, unit).line("right", "in the nearest right wheel"),
            ReportField::new("residual", difference)
                .line("difference", "in uncertainties")
                .rounded(Rounding::Significant(2)),
        ],
        row: DataRow(vec![
            ("size", heading.into()),
            ("number", numbered.map_or(FieldValue::Missing, FieldValue::from)),
            ("unit", unit.into()),
            ("measured", value.into()),
            ("uncertainty", uncertainty.into()),
            ("right", right.into()),
            ("residual", difference.into()),
        ]),
    }
}

/// Differences in uncertainties that are rounding.
const LEAST_DIFFERENCE: f64 = 1e-9;

fn note(question: &CheckQuestion, nearest: &NearestWheel) -> String {
    let few = (nearest.residuals.len() < 3).then_some(
        "With so few sizes little can contradict; measure crank radius, centre distance and outside diameter.",
    );
    let hole = question.screw_hole.filter(|_| !question.is_pin_measured()).map(|hole| {
        format!(
            "The circle of {} mm in the pin's place is much smaller than the slots are wide, so it counts as the hole of a screw, and \
             the pin is not measured. Give --pin-diameter.",
            number(hole)
        )
    });
    let mouths = if question.has_mouths {
        "The drawing has slots with chamfered, rounded or widened mouths, but their corners count as sharp here."
    } else {
        "The corners of the slots count as sharp."
    };
    let model = "A chamfer, a radius or a lead-in only takes material away, so a wheel that turns still turns with it, and the blows are \
                 softer. The bores count as without play; play there moves the axes as an error of the centre distance does.";
    let speed = question.rpm.is_none().then_some("For blows in mm/s, add --rpm R.");
    let fixed = few.into_iter().chain([mouths, model]).chain(speed);
    hole.into_iter().chain(fixed.map(str::to_owned)).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
#[path = "check_tests.rs"]
mod tests;
