//! A wheel that exists, by its measured sizes: which right wheel is nearest, which size contradicts the others, does it turn, and what
//! to change first.

use super::check_advice::design_remark;
use super::check_arguments::{CHECK_ARGUMENTS, measured_error};
use super::check_certainty::{ShallowSlot, TooCoarse, is_chance, shallow_slots, too_coarse};
use super::check_doubts::{doubt_words, measuring_words, stations_words, untold_words};
use super::check_mouth::TypedMouth;
use super::check_needs::{
    DEPTH, ENTRY, UnmeasuredSize, all_sizes, options, taken_as_right, unmeasured, unmeasured_of_verdict,
};
use super::check_remedies::{WheelRemedy, first_change, remedies};
use super::check_words::{corners, entry_words, named, shallow_words, turning_words, typed, with_unit};
use super::mouth::mouth_arguments;
use crate::number_format::{as_typed, count, number, to_digits};
use crate::typed_number::length;
use crate::{DataRow, Error, FieldValue, Item, MechanismReport, ReportField, Rounding, pairs};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{
    AsBuiltWheel, BuiltError, BuiltTurn, Culprit, DoubtReason, KnownMistake, MeasuredSize, MeasuredWheel, NearestWheel,
    UncertainWear, UndecidedCulprit, UntoldWear,
};
use geneva_kinematics::wheel::{SizesError, Wheel};
use geneva_workshop::{Drawing, DrawingError, LayerNames};

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
    /// What is said of the mouths.
    mouth: TypedMouth,
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
        Ok(Self { measured, rpm: None, screw_hole: None, has_mouths: false, mouth: TypedMouth::default() })
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
        Ok(Self {
            measured: drawn.measured,
            rpm: None,
            screw_hole: drawn.screw_hole,
            has_mouths: drawn.has_mouths,
            mouth: TypedMouth::default(),
        })
    }

    /// Adds a size as it is typed, `6.1`, `6.1+-0.02`, `1/4in` or `1:6.1,2:6.0`; one without an uncertainty has this one, in millimetres.
    /// A size of the mouths, of which there is one shape for all, has none.
    ///
    /// # Errors
    ///
    /// A size that is not measured, and a value that it can't have.
    pub fn add(&mut self, name: &str, text: &str, uncertainty: f64) -> Result<(), Error> {
        if self.mouth.set(name, text)? {
            return Ok(());
        }
        let Some(argument) = CHECK_ARGUMENTS.iter().find(|argument| argument.name == name) else {
            let names = CHECK_ARGUMENTS.iter().map(|argument| argument.name);
            let names = names.chain(mouth_arguments().map(|argument| argument.name));
            let all: Vec<String> = names.map(|name| format!("--{name}")).collect();
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
        let mut built = self.measured.as_built(&nearest);
        built.mouth = self.mouth.shape()?;
        let in_words = |error: BuiltError| Error::Argument(error.to_string());
        let turn = built.turn().map_err(in_words)?;
        let shallow = shallow_slots(&self.measured, &built);
        let open = unmeasured_of_verdict(&self.measured, &built, &turn);
        // A jam of sizes that are filled in is none of this wheel.
        let jam = turn.jam.as_ref().filter(|_| open.is_empty());
        let mut doubts = self.measured.undecided_culprits(&nearest);
        doubts.retain(|doubt| doubt.doubt != DoubtReason::NoDesign || !self.is_refused_by_chance(&nearest));
        let culprits = told_culprits(&nearest, &doubts);
        let checked = CheckedWheel {
            coarse: jam.and_then(|jam| too_coarse(&self.measured, jam)),
            remedies: remedies(&self.measured, &nearest, &culprits, &built, &shallow, open.is_empty())
                .map_err(in_words)?,
            mistakes: self.measured.known_mistakes(&nearest, jam.map(|_| &turn)),
            fitting_stations: self.measured.fitting_stations(&nearest),
            untold_wear: self.measured.untold_wear(&nearest),
            uncertain_wear: self.measured.uncertain_wear(&nearest),
            culprits,
            doubts,
            open,
            nearest: &nearest,
            built: &built,
            turn: &turn,
            shallow: &shallow,
        };
        let wheel = self.measured.wheel();
        let items = nearest.residuals.iter().map(item).collect();
        let report = MechanismReport {
            title: format!(
                "A Geneva wheel as it was made: {}, driver with {}",
                count(wheel.stations() as usize, "station"),
                count(wheel.pins() as usize, "pin")
            ),
            introduction: "What was not measured is as the command geneva wheel takes it by default for the sizes that were, unless the measured \
                           cut in the disc tells more; a pin then has the usual play in its slot. What rests on it is not told. Slots and arcs are \
                           numbered counter-clockwise from 1; in a drawing, slot 1 is the one nearest to the right, and arc 1 is between \
                           the slots 1 and 2.",
            sections: vec![
                ("Verdict", self.verdict(&checked)),
                (right_heading(&nearest), right_sizes(&self.measured, &nearest)),
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

    /// Whether the sizes seem to be those of no wheel by less than chance.
    fn is_refused_by_chance(&self, nearest: &NearestWheel) -> bool {
        matches!(&nearest.refusal, Some(SizesError::DoesNotFit { by, .. }) if is_chance(&self.measured, *by))
    }

    fn is_pin_measured(&self) -> bool {
        self.measured.sizes().iter().any(|of| of.size == MeasuredSize::PinDiameter)
    }
}

impl CheckQuestion {
    fn verdict(&self, checked: &CheckedWheel<'_>) -> Vec<ReportField> {
        let CheckedWheel { built, turn, mistakes, remedies, coarse, shallow, open, .. } = checked;
        let first_culprit = checked.culprits.first();
        let (turn, coarse) = (*turn, *coarse);
        let is_known = coarse.is_none() && open.is_empty();
        let turns = turning_words(built, turn, coarse, open);
        let turns = match taken_as_right(&self.measured, built).filter(|_| is_known && turn.is_driven()) {
            Some(taken) => format!("{turns}; {taken}"),
            None => turns,
        };
        let no_entry = unmeasured(&self.measured, ENTRY);
        let entry = if no_entry.is_empty() {
            entry_words(turn)
        } else {
            format!("not known where and with which blow the pin comes in; it needs {}", options(&no_entry))
        };
        let no_depth = unmeasured(&self.measured, DEPTH);
        let depth = if no_depth.is_empty() || !shallow.is_empty() {
            shallow_words(shallow, self.measured.wheel().stations() as usize)
        } else {
            format!("not known whether they are deep enough; it needs {}", options(&no_depth))
        };
        let filled_in = unmeasured(&self.measured, &all_sizes(built));
        // What the other sizes ask for instead.
        let expected = first_culprit.map(|culprit| typed(culprit.size, culprit.expected));
        let names: Vec<FieldValue> = mistakes.iter().map(|mistake| mistake.name().into()).collect();
        let explained: Vec<&str> = mistakes.iter().map(|mistake| mistake.explanation()).collect();
        let is_enough = !is_known || turn.is_driven();
        let first = self.first_change(checked, is_enough);
        let nothing = if open.is_empty() { "nothing" } else { "nothing that was measured" };
        let missing = shallow.iter().map(|of| of.missing).reduce(f64::max);
        let numbers = shallow.iter().map(|of| FieldValue::from(of.slot + 1)).collect();
        vec![
            ReportField::new("turns", is_known.then_some(turn.is_driven())).words("turns", turns),
            ReportField::new("unmeasured", FieldValue::List(filled_in.iter().map(|of| of.option().into()).collect())),
            ReportField::new("lands_on_corner", no_entry.is_empty().then(|| corners(turn).next().is_some()))
                .words("entry", entry),
            ReportField::new("shallow_slots", FieldValue::List(numbers)).words("slots", depth),
            ReportField::in_unit("missing_depth_mm", missing, "mm"),
            ReportField::new("culprit", first_culprit.map(|culprit| named(culprit.size)))
                .words("contradiction", self.contradiction_words(checked)),
            ReportField::new("in_doubt", in_doubt(&checked.doubts)),
            untold_wear_field(&checked.untold_wear, &checked.uncertain_wear),
            ReportField::new(
                "fitting_stations",
                FieldValue::List(checked.fitting_stations.iter().map(|of| FieldValue::from(*of as usize)).collect()),
            ),
            ReportField::in_unit(
                "culprit_expected",
                expected.map(|(value, _)| value),
                expected.map_or("", |(_, unit)| unit),
            ),
            ReportField::in_unit(
                "culprit_expected_uncertainty",
                first_culprit.and_then(|culprit| Some(typed(culprit.size, culprit.expected_uncertainty?).0)),
                expected.map_or("", |(_, unit)| unit),
            ),
            ReportField::new("wrong_formulas", FieldValue::List(names)).words(
                "wrong formula",
                if explained.is_empty() { "none that we know".to_owned() } else { explained.join("; ") },
            ),
            ReportField::new("change_first", first.clone())
                .words("change first", first.unwrap_or_else(|| nothing.to_owned())),
            design_field(remedies, &self.measured, &self.mouth),
        ]
    }

    /// What is wrong of the sizes, in words: those that contradict the others, and those of which one is wrong.
    fn contradiction_words(&self, checked: &CheckedWheel<'_>) -> String {
        let nearest = checked.nearest;
        let mut words: Vec<String> = checked.doubts.iter().map(|doubt| doubt_words(doubt, nearest)).collect();
        let culprits: Vec<String> = checked.culprits.iter().take(MOST_IN_WORDS).map(culprit_words).collect();
        let further = checked.culprits.len().saturating_sub(MOST_IN_WORDS);
        if !culprits.is_empty() {
            let others = if further == 0 { String::new() } else { format!(", and so are {further} more") };
            words.insert(0, culprits.join(". Besides, ") + &others + rest_words(nearest));
        }
        let stations = stations_words(&checked.fitting_stations, self.measured.wheel().stations());
        match (words.join(". Besides, "), stations) {
            (said, Some(stations)) if !said.is_empty() => format!("{stations}, {said}"),
            (said, _) if !said.is_empty() => said,
            _ if nearest.refusal.is_some() => {
                "none: within their uncertainties, all measured sizes fit one right wheel".to_owned()
            }
            _ => "none: all measured sizes fit one right wheel".to_owned(),
        }
    }

    /// What to do first, in words; none if nothing.
    fn first_change(&self, checked: &CheckedWheel<'_>, is_enough: bool) -> Option<String> {
        let measuring = checked.doubts.iter().filter(|doubt| doubt.sizes.len() != 1).map(measuring_words);
        let measuring = (!checked.doubts.is_empty()).then(|| measuring.collect::<Vec<_>>().join(", and "));
        let change = first_change(&checked.remedies);
        let words: Vec<String> = measuring.filter(|words| !words.is_empty()).into_iter().chain(change).collect();
        let words =
            if words.is_empty() { (!is_enough).then(|| NO_REMEDY.to_owned()) } else { Some(words.join("; then ")) };
        let count = checked
            .fitting_stations
            .first()
            .map(|stations| format!("count the slots again: with --stations {stations} nothing is wrong"));
        match (count, words) {
            (Some(count), Some(words)) => {
                Some(format!("{count}. If there are {}, {words}", self.measured.wheel().stations()))
            }
            (count, words) => count.or(words),
        }
    }
}

/// The sizes of which it is certain that they contradict the others, the worst first.
fn told_culprits(nearest: &NearestWheel, doubts: &[UndecidedCulprit]) -> Vec<Culprit> {
    let is_open = doubts.iter().any(|doubt| doubt.doubt == DoubtReason::Contradiction);
    let all = nearest.culprit.iter().chain(&nearest.further_culprits);
    // The doubt is about the first one, and about what goes with it.
    let is_in_doubt = |(k, culprit): &(usize, &Culprit)| is_open && (*k == 0 || culprit.size.number().is_none());
    all.enumerate().filter(|of| !is_in_doubt(of)).map(|(_, culprit)| *culprit).collect()
}

/// The sizes of which one is wrong, or worn.
fn in_doubt(doubts: &[UndecidedCulprit]) -> FieldValue {
    FieldValue::List(doubts.iter().flat_map(|doubt| &doubt.sizes).map(|size| named(*size).into()).collect())
}

/// The wear that these sizes can't tell from an ordinary play or from chance, and what to give so that they do; missing where they tell
/// all wear.
fn untold_wear_field(untold: &[UntoldWear], uncertain: &[UncertainWear]) -> ReportField {
    let all = untold.iter().map(|wear| wear.below).chain(uncertain.iter().map(|wear| wear.certain_from));
    let most = all.reduce(f64::max);
    let field = ReportField::in_unit("untold_wear_mm", most, "mm");
    if most.is_none() { field } else { field.line("wear", untold_words(untold, uncertain)) }
}

/// The commands that design new parts, in the order of the remedies.
fn design_field(remedies: &[WheelRemedy], measured: &MeasuredWheel, mouth: &TypedMouth) -> ReportField {
    let mut commands: Vec<String> = Vec::new();
    for arguments in remedies.iter().filter_map(|remedy| remedy.design.as_ref()) {
        let command = format!("geneva wheel {}", mouth.beside(arguments));
        if !commands.contains(&command) {
            commands.push(command);
        }
    }
    let filled_in = design_remark(measured).map_or_else(String::new, |remark| format!(" ({remark})"));
    let words = if commands.is_empty() { String::new() } else { commands.join("; or ") + &filled_in };
    let field =
        ReportField::new("design_commands", FieldValue::List(commands.into_iter().map(FieldValue::from).collect()));
    if words.is_empty() { field } else { field.words("design them", words) }
}

fn culprit_words(culprit: &Culprit) -> String {
    let (expected, unit) = typed(culprit.size, culprit.expected);
    let uncertainty = culprit
        .expected_uncertainty
        .map_or_else(String::new, |uncertainty| format!(" ± {}", to_digits(typed(culprit.size, uncertainty).0, 1)));
    format!(
        "{} {}: the others ask for {}{uncertainty} {unit}, {} of its uncertainties away",
        named(culprit.size),
        with_unit(culprit.size, culprit.measured, 4),
        number(expected),
        to_digits(culprit.uncertainties.abs(), 2)
    )
}

/// What is said of the sizes that don't contradict.
fn rest_words(nearest: &NearestWheel) -> &'static str {
    let agrees = nearest.culprit.is_some_and(|culprit| culprit.rest_agrees);
    if agrees { "; all others agree" } else { "; and the others contradict each other, too" }
}

/// Culprits that are told in words at most; each of worn slots or arcs that were measured one by one is one.
const MOST_IN_WORDS: usize = 3;

/// What is said where nothing that is tried makes a wheel turn.
const NO_REMEDY: &str = "no change of one size by up to 0.4 of the pin's diameter makes it turn; make new parts";

/// What was found of a wheel.
struct CheckedWheel<'a> {
    nearest: &'a NearestWheel,
    built: &'a AsBuiltWheel,
    turn: &'a BuiltTurn,
    mistakes: Vec<KnownMistake>,
    remedies: Vec<WheelRemedy>,
    coarse: Option<TooCoarse>,
    shallow: &'a [ShallowSlot],
    /// What was not measured and decides whether the wheel turns; empty if that is known.
    open: Vec<UnmeasuredSize>,
    /// The sizes that contradict the others for certain, the worst first.
    culprits: Vec<Culprit>,
    /// Sizes of which one is wrong, or worn.
    doubts: Vec<UndecidedCulprit>,
    /// Wear that can't be told from play.
    untold_wear: Vec<UntoldWear>,
    /// Wear that may be chance.
    uncertain_wear: Vec<UncertainWear>,
    /// Other numbers of stations with which nothing is wrong.
    fitting_stations: Vec<u32>,
}

/// Which right wheel is shown.
fn right_heading(nearest: &NearestWheel) -> &'static str {
    if nearest.culprit.is_some() {
        "Nearest right wheel, without the sizes that contradict it"
    } else {
        "Nearest right wheel"
    }
}

/// The sizes of the nearest right wheel, with a remark on those of which nothing was measured.
fn right_sizes(measured: &MeasuredWheel, nearest: &NearestWheel) -> Vec<ReportField> {
    use MeasuredSize as Size;
    let mm = |key, value: f64, name, meaning: &'static str, size: Size| {
        let is_measured = measured.sizes().iter().any(|of| of.size.name() == size.name());
        let remark = if is_measured { "" } else { "; not measured" };
        ReportField::in_unit(key, value, "mm").line(name, format!("{meaning}{remark}"))
    };
    let of = nearest;
    vec![
        mm("crank_radius_mm", of.crank_radius, "crank radius", "driver's axis to a pin's centre", Size::CrankRadius),
        mm(
            "centre_distance_mm",
            of.centre_distance,
            "centre distance",
            "wheel's axis to driver's axis",
            Size::CentreDistance,
        ),
        mm("tip_radius_mm", of.tip_radius, "rim", "radius, half of the outside diameter", Size::TipRadius),
        mm("pin_diameter_mm", of.pin_diameter, "pin", "diameter", Size::PinDiameter),
        mm("slot_width_mm", of.slot_width, "slot", "width", Size::SlotWidth(None)),
        mm("slot_end_mm", of.slot_end, "", "wheel's axis to the centre of its round end", Size::SlotEnd(None)),
        mm("locking_arc_radius_mm", of.arc_radius, "locking arc", "radius", Size::ArcRadius(None)),
        mm("locking_disc_radius_mm", of.disc_radius, "locking disc", "radius", Size::DiscRadius),
        mm("crescent_centre_mm", of.crescent_centre, "crescent", "driver's axis to its centre", Size::CrescentCentre),
        mm("crescent_radius_mm", of.crescent_radius, "", "radius", Size::CrescentRadius),
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
    let mouths = match (question.has_mouths, question.mouth.is_given()) {
        (_, true) => "All slots count as having the mouths that are given.",
        (true, false) => {
            "The drawing has slots with chamfered, rounded or widened mouths, but their corners count as sharp here; for their blows, give \
             --mouth-chamfer, --mouth-radius or --lead-in. A mouth only takes material away, so a wheel that turns still turns with it, and \
             the blows are softer."
        }
        (false, false) => {
            "The corners of the slots count as sharp; if they aren't, give --mouth-chamfer, --mouth-radius or --lead-in. A mouth only takes \
             material away, so a wheel that turns still turns with it, and the blows are softer."
        }
    };
    let model = "The bores count as without play; play there moves the axes as an error of the centre distance does.";
    let speed = question.rpm.is_none().then_some("For blows in mm/s, add --rpm R.");
    let fixed = few.into_iter().chain([mouths, model]).chain(speed);
    hole.into_iter().chain(fixed.map(str::to_owned)).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
#[path = "check_tests.rs"]
mod tests;
