//! A wheel that exists, by its measured sizes: which right wheel is nearest, which size contradicts the others, does it turn, and what
//! to change first.

use crate::number_format::{as_typed, count, number};
use crate::{DataRow, Error, FieldValue, Item, MechanismReport, ReportField, Rounding, pairs};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;
use geneva_kinematics::wheel::as_built::{
    AsBuiltWheel, BuiltContact, BuiltError, BuiltTurn, Culprit, Jam, KnownMistake, MeasuredError, MeasuredSize,
    MeasuredWheel, NearestWheel, SizeChange,
};
use geneva_workshop::{Drawing, DrawingError, LayerNames};
use std::f64::consts::PI;

/// An argument of the question that is a measured size: its name, its unit, what it is, and by what a typed number is multiplied.
#[derive(Clone, Copy, Debug)]
pub struct CheckArgument {
    /// Its name as it is typed, without hyphens before it.
    pub name: &'static str,
    /// What its value is called, and its unit.
    pub value: &'static str,
    /// What it is.
    pub help: &'static str,
    /// Which size it is, of all slots or arcs; with a number, of one of them.
    size: fn(Option<usize>) -> MeasuredSize,
    scale: f64,
}

/// The arguments that are measured sizes. Each value may carry its uncertainty, `6.1+-0.05`; those of slots and arcs may be of single
/// ones, `1:6.1,2:6.0`.
pub const CHECK_ARGUMENTS: [CheckArgument; 13] = [
    argument("centre-distance", "MM", "Distance between the two axes", |_| MeasuredSize::CentreDistance, 1.0),
    argument(
        "crank-radius",
        "MM",
        "Distance from the driver's axis to the pin's centre",
        |_| MeasuredSize::CrankRadius,
        1.0,
    ),
    argument("pin-diameter", "MM", "Diameter of the pins", |_| MeasuredSize::PinDiameter, 1.0),
    argument("outside-diameter", "MM", "Outside diameter of the wheel", |_| MeasuredSize::TipRadius, 0.5),
    argument(
        "tip-radius",
        "MM",
        "Radius of the wheel's rim: half the outside diameter",
        |_| MeasuredSize::TipRadius,
        1.0,
    ),
    argument("slot-width", "MM", "Width of the slots, or of single slots", MeasuredSize::SlotWidth, 1.0),
    argument(
        "slot-end",
        "MM",
        "Distance from the wheel's axis to the centre of the slots' round ends",
        MeasuredSize::SlotEnd,
        1.0,
    ),
    argument(
        "slot-direction",
        "DEG",
        "How far single slots are counter-clockwise of their right direction",
        |number| MeasuredSize::SlotDirection(number.unwrap_or_default()),
        PI / 180.0,
    ),
    argument("locking-arc-radius", "MM", "Radius of the locking arcs", MeasuredSize::ArcRadius, 1.0),
    argument(
        "locking-arc-centre",
        "MM",
        "Distance from the wheel's axis to the centres of the locking arcs",
        MeasuredSize::ArcCentre,
        1.0,
    ),
    argument("locking-disc-radius", "MM", "Radius of the locking disc", |_| MeasuredSize::DiscRadius, 1.0),
    argument(
        "crescent-centre",
        "MM",
        "Distance from the driver's axis to the centre of the cut in the disc",
        |_| MeasuredSize::CrescentCentre,
        1.0,
    ),
    argument("crescent-radius", "MM", "Radius of the cut in the disc", |_| MeasuredSize::CrescentRadius, 1.0),
];

const fn argument(
    name: &'static str,
    value: &'static str,
    help: &'static str,
    size: fn(Option<usize>) -> MeasuredSize,
    scale: f64,
) -> CheckArgument {
    CheckArgument { name, value, help, size, scale }
}

/// What is asked of a wheel that exists.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckQuestion {
    /// The measured sizes.
    pub measured: MeasuredWheel,
    /// Speed of the driver in turns per minute; with it, blows are told in mm/s.
    pub rpm: Option<f64>,
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
        let uncertainty = value("uncertainty").map(|text| crate::number("uncertainty", text)).transpose()?;
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
        Ok(Self { measured: MeasuredWheel::new(Wheel::with_pins(stations, pins)?), rpm: None })
    }

    /// A wheel of which a drawing in DXF has the sizes, each with this standard uncertainty in millimetres.
    ///
    /// # Errors
    ///
    /// A text that is no drawing, and one without the layers or the shapes of a wheel.
    pub fn of_drawing(text: &str, layers: &LayerNames, uncertainty: f64) -> Result<Self, Error> {
        let in_words = |error: DrawingError| Error::Argument(error.to_string());
        let drawing = Drawing::read(text).map_err(in_words)?;
        Ok(Self { measured: drawing.measure(layers, uncertainty).map_err(in_words)?, rpm: None })
    }

    /// Adds a size as it is typed, `6.1`, `6.1+-0.02` or `1:6.1,2:6.0`; one without an uncertainty has this one, in millimetres.
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
        let changes = built.least_changes().map_err(built_error)?;
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
                ("Verdict", verdict(&turn, &nearest, &mistakes, &changes)),
                ("Nearest right wheel", right_sizes(&nearest)),
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

    /// Play, errors and blows of the wheel as it was made.
    fn as_made(&self, built: &AsBuiltWheel, turn: &BuiltTurn) -> Vec<ReportField> {
        let most = |of: fn(&geneva_kinematics::wheel::as_built::StationTurn) -> f64| {
            turn.stations.iter().map(of).fold(0.0, f64::max)
        };
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
            degrees("lost_motion_deg", most(|station| station.entry.map_or(0.0, |entry| entry.lost_motion)))
                .line("lost motion", "of the crank, from where a right pin enters to where the slot is met"),
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

impl CheckArgument {
    /// Adds the measurements of a typed value.
    fn add(&self, measured: &mut MeasuredWheel, text: &str, default: f64) -> Result<(), Error> {
        for one in text.split(',') {
            let (place, value) = one.split_once(':').map_or((None, one), |(place, value)| (Some(place), value));
            let place = place.map(|place| crate::number::<usize>(self.name, place)).transpose()?;
            let is_of_one = matches!((self.size)(None), MeasuredSize::SlotDirection(_));
            let is_of_many = (self.size)(Some(0)).number().is_some();
            if place == Some(0) || (place.is_some() && !is_of_many) || (place.is_none() && is_of_one) {
                return Err(refused!(
                    "--{} {text}: {}",
                    self.name,
                    if is_of_many {
                        "slots and arcs are numbered from 1; give such as 1:6.1,2:6.0"
                    } else {
                        "there is one only; give a number"
                    }
                ));
            }
            let (value, uncertainty) = value
                .split_once("+-")
                .or_else(|| value.split_once('±'))
                .map_or((value, None), |(value, uncertainty)| (value, Some(uncertainty)));
            let value: f64 = crate::number(self.name, value.trim())?;
            let uncertainty = uncertainty.map(|text| crate::number(self.name, text.trim())).transpose()?;
            // An angle without an uncertainty of its own has that of a length at half the size of the unit circle: a degree's tenth.
            let default = if is_of_one { DIRECTION_UNCERTAINTY } else { default };
            let size = (self.size)(place.map(|place| place - 1));
            let uncertainty = self.scale * uncertainty.unwrap_or(default);
            measured.add(size, self.scale * value, uncertainty).map_err(measured_error)?;
        }
        Ok(())
    }
}

/// The standard uncertainty of a direction without one, in degrees: our choice.
const DIRECTION_UNCERTAINTY: f64 = 0.1;

fn measured_error(error: MeasuredError) -> Error {
    Error::Argument(error.to_string())
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

fn verdict(
    turn: &BuiltTurn,
    nearest: &NearestWheel,
    mistakes: &[KnownMistake],
    changes: &[SizeChange],
) -> Vec<ReportField> {
    let turns = match &turn.jam {
        Some(jam) => format!(
            "no: {} mm are missing at a crank angle of {}°, pin {} and slot {}: {}",
            number(-jam.free.room()),
            number(jam.crank_angle.to_degrees()),
            jam.pin + 1,
            jam.slot + 1,
            place(jam)
        ),
        None if turn.can_miss() => {
            "yes, but the wheel can stand so in the dwell that a pin meets its rim beside the slot".to_owned()
        }
        None => "yes, every station".to_owned(),
    };
    // What the other sizes ask for instead.
    let expected = nearest.culprit.map(|culprit| typed(culprit.size, culprit.expected));
    let first = nearest.culprit.iter().map(|culprit| culprit_words(culprit, &nearest.suspects));
    let further = nearest.further_culprits.iter().map(|culprit| culprit_words(culprit, &[]));
    let culprits: Vec<String> = first.chain(further).collect();
    let without = match &nearest.refusal {
        Some(error) => format!("no wheel has exactly these sizes, so one of them is wrong: {error}"),
        None => "none: all measured sizes fit one right wheel".to_owned(),
    };
    let names: Vec<FieldValue> = mistakes.iter().map(|mistake| mistake.name().into()).collect();
    let explained: Vec<&str> = mistakes.iter().map(|mistake| mistake.explanation()).collect();
    let first = first_change(nearest, changes);
    vec![
        ReportField::new("turns", turn.jam.is_none()).words("turns", turns),
        ReportField::new("culprit", nearest.culprit.map(|culprit| named(culprit.size)))
            .words("contradiction", if culprits.is_empty() { without } else { culprits.join(". Besides, ") }),
        ReportField::in_unit(
            "culprit_expected",
            expected.map(|(value, _)| value),
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

fn culprit_words(culprit: &Culprit, suspects: &[MeasuredSize]) -> String {
    let rest = if culprit.rest_agrees { "all others agree" } else { "but these contradict each other, too" };
    let others: Vec<String> = suspects.iter().map(|size| named(*size)).collect();
    let or = if others.is_empty() { String::new() } else { format!("; it could also be {}", others.join(", ")) };
    format!(
        "{} {}: the others ask for {}, {} of its uncertainties away; {rest}{or}",
        named(culprit.size),
        with_unit(culprit.size, culprit.measured),
        with_unit(culprit.size, culprit.expected),
        number(culprit.uncertainties.abs())
    )
}

/// What to change first: the size that contradicts the others, or else the least change with which the wheel turns.
fn first_change(nearest: &NearestWheel, changes: &[SizeChange]) -> Option<String> {
    let by_culprit = nearest
        .culprit
        .map(|culprit| format!("make {} {}", named(culprit.size), with_unit(culprit.size, culprit.expected)));
    let by_change = changes.first().map(|change| {
        let sense = if change.by > 0.0 { "larger" } else { "smaller" };
        format!("make {} {} mm {sense}, and a little more for play", named(change.size), number(change.by.abs()))
    });
    match (by_culprit, by_change) {
        (Some(culprit), Some(change)) => Some(format!("{culprit}; or, to make it turn at all, {change}")),
        (one, other) => one.or(other),
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
    let heading = of.size.name();
    let numbered = of.size.number().map(|number| number + 1);
    let which = numbered.map_or_else(String::new, |number| format!(", number {number}"));
    Item {
        heading,
        fields: vec![
            ReportField::in_unit("measured", value, unit)
                .line("measured", format!("± {}{which}", as_typed(uncertainty))),
            ReportField::in_unit("right", right, unit).line("right", "in the nearest right wheel"),
            ReportField::new("residual", residual.normalized)
                .line("difference", "in uncertainties")
                .rounded(Rounding::Significant(3)),
        ],
        row: DataRow(vec![
            ("size", heading.into()),
            ("number", numbered.map_or(FieldValue::Missing, FieldValue::from)),
            ("unit", unit.into()),
            ("measured", value.into()),
            ("uncertainty", uncertainty.into()),
            ("right", right.into()),
            ("residual", residual.normalized.into()),
        ]),
    }
}

fn note(question: &CheckQuestion, nearest: &NearestWheel) -> String {
    let few = (nearest.residuals.len() < 3).then_some(
        "With so few sizes little can contradict; measure crank radius, centre distance and outside diameter.",
    );
    let speed = question.rpm.is_none().then_some("For blows in mm/s, add --rpm R.");
    few.into_iter().chain(speed).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::CheckQuestion;
    use crate::{FieldValue, MechanismReport};

    fn report(question: &str) -> MechanismReport {
        CheckQuestion::parse(question).and_then(|question| question.answer()).expect("an answer")
    }

    fn text(report: &MechanismReport, key: &str) -> String {
        match &report.field(key).expect("a field").value {
            FieldValue::Text(text) => text.clone(),
            other => format!("{other:?}"),
        }
    }

    const RIGHT: &str = "--stations 6 --centre-distance 50 --crank-radius 25 --outside-diameter 86.72 --pin-diameter 4 \
                         --slot-width 4.2 --locking-disc-radius 18.8 --locking-arc-radius 18.9 --uncertainty 0.02";

    #[test]
    fn a_right_wheel_turns_and_nothing_is_to_be_changed() {
        let report = report(RIGHT);
        assert_eq!(report.field("turns").map(|field| &field.value), Some(&FieldValue::Flag(true)));
        assert_eq!(text(&report, "culprit"), "Missing");
        assert_eq!(text(&report, "change_first"), "Missing");
        assert_eq!(report.rows().count(), 7);
    }

    #[test]
    fn a_narrow_slot_is_named_with_its_number() {
        let report =
            report(&RIGHT.replace("--slot-width 4.2", "--slot-width 1:4.2,2:3.9+-0.02,3:4.2,4:4.2,5:4.2,6:4.2"));
        assert_eq!(text(&report, "culprit"), "slot width 2");
        assert_eq!(report.field("turns").map(|field| &field.value), Some(&FieldValue::Flag(false)));
        assert!(text(&report, "change_first").starts_with("make slot width 2 4.2"));
    }

    #[test]
    fn two_wrong_sizes_are_both_named() {
        let report = report(
            "--stations 4 --crank-radius 25 --centre-distance 34.9 --outside-diameter 50.5 --pin-diameter 6 \
             --slot-width 1:6.3,2:6.3,3:5.7,4:6.3",
        );
        let words = &report.sections[0].1[1].line.as_ref().expect("a line").meaning;
        assert!(words.contains("centre distance 34.90 mm") && words.contains("slot width 3 5.700 mm"), "{words}");
    }

    #[test]
    fn a_wrong_formula_is_named() {
        // Six slots of the sine for the cosine: 43.3 mm / sin 30°.
        let report =
            report("--stations 6 --centre-distance 86.6 --crank-radius 25 --outside-diameter 86.6 --uncertainty 0.05");
        assert_eq!(
            report.field("wrong_formulas").map(|field| field.value.clone()),
            Some(FieldValue::List(vec!["sine for cosine".into()]))
        );
    }

    #[test]
    fn what_cannot_be_read_is_refused_with_what_to_give() {
        let refused = |question: &str| {
            CheckQuestion::parse(question).and_then(|of| of.answer()).expect_err("refused").to_string()
        };
        assert!(refused("--crank-radius 25").contains("--stations is missing"));
        assert!(refused("--stations 6 --slot-width 7:6.1 --crank-radius 25").contains("numbers 1 to 6"));
        assert!(refused("--stations 6 --slot-width 0:6.1 --crank-radius 25").contains("numbered from 1"));
        assert!(refused("--stations 6 --crank-radius 1:25").contains("one only"));
        assert!(refused("--stations 6 --pin-diameter 4").contains("how large the wheel is"));
        assert!(refused("--stations 6 --crank-radius -25").contains("above zero"));
        assert!(refused("--stations 6 --radius 25").contains("--outside-diameter"));
        assert!(refused("--stations 6 --crank-radius 25 --rpm 0").contains("above zero"));
    }
}
