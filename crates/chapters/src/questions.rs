//! Questions that the chapters ask of mechanisms, each stated once, and numbers of the answers as a sentence says them.

use crate::lookup::{claim, unknown};
use anyhow::Context;
use geneva_ask::escapement;
use geneva_ask::number_format::no_greater;
use geneva_ask::wheel::{WheelDesign, WheelQuestion};
use geneva_ask::{Error, MechanismReport, ReportField, Rounding};
use geneva_press::numbers::{fixed, significant};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

/// The worked design of *Make a wheel*, without what other questions ask otherwise.
macro_rules! worked {
    ($radius:literal, $rpm:literal, $more:literal) => {
        concat!(
            "wheel --stations 6 --crank-radius ",
            $radius,
            " --rpm ",
            $rpm,
            " --inertia 0.002 --friction-torque 0.1 --thickness 10 --density 8860 ",
            $more
        )
    };
}

/// The quick-return mechanism of the examination problem at a lever angle in degrees.
macro_rules! lever {
    ($angle:literal) => {
        concat!(
            "quick-return --ground {quick-return.ground} --crank {quick-return.crank} --rpm {quick-return.driver-speed} ",
            "--lever-angle ",
            $angle
        )
    };
}

/// Names and questions, as they are typed at the command line. In braces is the claim whose printed characters are typed.
const QUESTIONS: &[(&str, &str)] = &[
    ("example", "wheel --stations {jazar.ex.stations} --centre-distance 100 --rpm {jazar.ex.rpm} --inertia 0.002"),
    ("worked", worked!("25", "60", "--pin-material steel --wheel-material phosphor-bronze")),
    // The tasks at the beginning of the chapter: the commands as they are typed there.
    ("table", "wheel --stations 6 --index-time 0.4 --table-mass 2 --table-diameter 300 --process mill --out my-wheel"),
    (
        "printed",
        "wheel --stations 4 --crank-radius 25 --process fdm --pin-screw M3 --wheel-hub-circle 20 \
         --hub-holes 4 --hub-screw M3 --out printed",
    ),
    (
        "checked",
        "wheel check --stations 6 --centre-distance 50.45 --crank-radius 25 --outside-diameter 86.95 --pin-diameter 7.5 --slot-width 7.6 \
         --locking-disc-radius 13.65 --locking-arc-radius 13.72",
    ),
    (
        "replaced",
        "wheel --stations 6 --outside-diameter 86.9 --locking-arc-radius 13.72 --pin-diameter 7.5 --out new-wheel",
    ),
    // With other mouths of the slots.
    ("worked-rounded", worked!("25", "60", "--mouth-radius 2")),
    ("worked-chamfer", worked!("25", "60", "--mouth-chamfer 2")),
    ("worked-flat-chamfer", worked!("25", "60", "--mouth-chamfer 2 --mouth-angle 15")),
    ("worked-lead-in", worked!("25", "60", "--lead-in 4")),
    // With a pin that rubs, and with the axes a little too far apart and so far that the pin meets a corner.
    ("worked-rubbing", worked!("25", "60", "--pin-friction 0.15")),
    ("worked-little-apart", worked!("25", "60", "--centre-error 0.02")),
    ("worked-apart", worked!("25", "60", "--centre-error 0.1")),
    // So many degrees of the crank before a pin enters.
    ("worked-thirty-before", worked!("25", "60", "--before-entry 30")),
    ("worked-ten-before", worked!("25", "60", "--before-entry 10")),
    ("worked-twice-as-fast", worked!("25", "120", "")),
    ("worked-best", worked!("36", "60", "")),
    ("worked-large", worked!("100", "60", "")),
    (
        "worked-three",
        "wheel --stations 3 --crank-radius 25 --rpm 60 --inertia 0.002 --friction-torque 0.1 --thickness 10 --density 8860",
    ),
    ("worked-two-pins", "wheel --stations 6 --pins 2 --crank-radius 25"),
    ("instant", "wheel --stations 6 --rpm 200 --at -20"),
    ("eight", "wheel --stations 8 --rpm 25"),
    // Without friction, and of no size.
    ("free-four", "wheel --stations 4 --rpm 60 --inertia 1"),
    ("free-six", "wheel --stations 6 --rpm 60 --inertia 1"),
    ("free-eight", "wheel --stations 8 --rpm 60 --inertia 1"),
    ("lever", lever!("{quick-return.lever-angle}")),
    ("lever-at-ten", lever!("10")),
    ("lever-near", lever!("{quick-return.lever-angle} --branch near")),
    // Where the brake has been touching for a tenth of the speed.
    ("governor", "governor --beyond 1.1"),
];

/// The names of all questions; each is asked in some chapter.
pub fn names() -> impl Iterator<Item = &'static str> {
    QUESTIONS.iter().map(|(name, _)| *name)
}

/// The question of this name, as it is typed behind `geneva`.
pub fn question(name: &str) -> anyhow::Result<String> {
    let found = QUESTIONS.iter().find(|(known, _)| *known == name);
    let (_, question) = found.ok_or_else(|| unknown("question", name, names()))?;
    let words = question.split(' ').map(|word| match word.strip_prefix('{').and_then(|id| id.strip_suffix('}')) {
        Some(id) => Ok(claim(id)?.printed),
        None => Ok(word),
    });
    Ok(words.collect::<anyhow::Result<Vec<_>>>()?.join(" "))
}

/// The wheel of the question of this name.
pub fn design(name: &str) -> anyhow::Result<WheelDesign> {
    let question = question(name)?;
    let arguments = question.strip_prefix("wheel ").with_context(|| format!("`{question}` asks no wheel"))?;
    Ok(WheelDesign::new(WheelQuestion::parse(arguments)?)?)
}

/// The field with this key of the answer to a question as it is typed behind `geneva`, or of its further fields. Each question is
/// asked once.
pub fn field(question: &str, key: &str) -> anyhow::Result<ReportField> {
    field_of(question, key, || geneva_ask::answer(question), || geneva_ask::further(question))
}

/// A number of the answer about an escapement, or of its further fields. Each question is asked once.
pub fn escapement_value(question: &escapement::EscapementQuestion, key: &str) -> anyhow::Result<f64> {
    let (asked, design) = (format!("{question:?}"), || escapement::EscapementDesign::new(*question));
    let field = field_of(&asked, key, || design()?.answer(), || design()?.further())?;
    number_of(&field, &asked)
}

/// The field with this key of an answer or of further fields, for a question that is known by its characters.
fn field_of(
    question: &str,
    key: &str,
    answer: impl FnOnce() -> Result<MechanismReport, Error>,
    further: impl FnOnce() -> Result<Vec<ReportField>, Error>,
) -> anyhow::Result<ReportField> {
    static ANSWERS: Asked<MechanismReport> = Asked::new(BTreeMap::new());
    static FURTHER: Asked<Vec<ReportField>> = Asked::new(BTreeMap::new());
    let answer = once(&ANSWERS, question, answer)?;
    if let Some(field) = answer.field(key) {
        return Ok(field.clone());
    }
    let further = once(&FURTHER, question, further)?;
    let known = || answer.fields().chain(further.iter());
    known().find(|field| field.key == key).cloned().ok_or_else(|| unknown("key", key, known().map(|field| field.key)))
}

/// What was asked, by the questions.
type Asked<T> = Mutex<BTreeMap<String, Arc<T>>>;

/// What a question gives, found at the first time.
fn once<T>(asked: &Asked<T>, question: &str, ask: impl FnOnce() -> Result<T, Error>) -> anyhow::Result<Arc<T>> {
    let known = || asked.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(found) = known().get(question) {
        return Ok(Arc::clone(found));
    }
    let found = Arc::new(ask().with_context(|| format!("`{question}`"))?);
    known().insert(question.to_owned(), Arc::clone(&found));
    Ok(found)
}

/// A number of the answer to a question as it is typed behind `geneva`.
pub fn value(question: &str, key: &str) -> anyhow::Result<f64> {
    number_of(&field(question, key)?, question)
}

fn number_of(field: &ReportField, question: &str) -> anyhow::Result<f64> {
    field.number().with_context(|| format!("`{}` has no number: `{question}` gives too little", field.key))
}

/// A number of an answer, `QUESTION.KEY` or `QUESTION.KEY:DIGITS`.
///
/// The digits are those that count, or with a point before them those after it; `size` before them drops the sign, `limit` rounds
/// down to three decimals, and `limit4` to four. Without digits a number is rounded as its answer says, and a length has no zeros at its end.
pub fn number(asked: &str) -> anyhow::Result<String> {
    let (path, digits) = asked.split_once(':').unwrap_or((asked, ""));
    let (name, key) = path.split_once('.').with_context(|| format!("`{asked}`: give QUESTION.KEY"))?;
    let question = question(name)?;
    let field = field(&question, key)?;
    let value = number_of(&field, &question)?;
    rounded(value, digits, &field).with_context(|| format!("`{asked}`"))
}

/// A number of a field, rounded as these digits say.
fn rounded(value: f64, digits: &str, field: &ReportField) -> anyhow::Result<String> {
    let unsized_digits = digits.strip_prefix("size");
    let (value, digits) =
        (if unsized_digits.is_some() { value.abs() } else { value }, unsized_digits.unwrap_or(digits));
    if digits == "limit" {
        return Ok(as_drawn((value * 1000.0).floor() / 1000.0, field));
    }
    if digits == "limit4" {
        return Ok(fixed((value * 1e4).floor() / 1e4, 4) + &unit(field));
    }
    let wrong =
        || format!("`{digits}` is no rounding: give digits such as 3 or .3, `size` before them, `limit` or `limit4`");
    let count = |text: &str| text.parse::<usize>().with_context(wrong);
    let rounding = match (digits.strip_prefix('.'), digits) {
        (None, "") => field.rounding,
        (Some(decimals), _) => Rounding::Decimals(count(decimals)?),
        (None, significant) => Rounding::Significant(count(significant)?),
    };
    Ok(match rounding {
        Rounding::Percent(decimals) => fixed(100.0 * value, decimals) + "&nbsp;%",
        Rounding::Decimals(_) if digits.is_empty() => as_drawn(value, field),
        Rounding::Decimals(decimals) => fixed(value, decimals) + &unit(field),
        Rounding::Significant(digits) => significant(value, digits) + &unit(field),
        Rounding::Limit(digits) => significant(no_greater(value, digits), digits) + &unit(field),
    })
}

/// A number with up to three decimals, as a drawing has it.
fn as_drawn(value: f64, field: &ReportField) -> String {
    fixed(value, 3).trim_end_matches('0').trim_end_matches('.').to_owned() + &unit(field)
}

/// A unit behind its number. The sentence says of what a ratio is.
fn unit(field: &ReportField) -> String {
    match field.unit {
        "" | "°" => field.unit.to_owned(),
        ratio if ratio.starts_with('×') => String::new(),
        unit => format!("&nbsp;{}", unit.replace(' ', "&nbsp;")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_documents::quick_return::LeverProblem;
    use geneva_kinematics::quick_return::{Branch, LeverMotion};

    #[test]
    fn a_number_is_said_with_its_unit_and_the_digits_that_are_asked_for() {
        for (asked, said) in [
            ("worked.crank_radius_mm", "25&nbsp;mm"),
            ("worked.crank_radius_mm:.2", "25.00&nbsp;mm"),
            ("worked.friction_torque_nm:2", "0.10&nbsp;N&nbsp;m"),
            ("worked.engagement_half_angle_deg:.1", "60.0°"),
            ("worked.centre_distance_ratio:.2", "2.00"),
            ("instant.crank_angle_deg:.0", "−20°"),
            ("instant.crank_angle_deg:size.0", "20°"),
            ("worked.wheel_radius_mm:limit", "43.301&nbsp;mm"),
            ("worked.rpm:3", "60.0"),
        ] {
            assert_eq!(number(asked).expect(asked), said, "{asked}");
        }
    }

    #[test]
    fn each_rounding_is_tried_on_both_sides_of_its_step() {
        let length = ReportField::in_unit("length_mm", 0.0, "mm");
        let factor = ReportField::new("factor", 0.0);
        let share = ReportField::new("share", 0.0).rounded(Rounding::Percent(1));
        let most = ReportField::in_unit("most", 0.0, "mm").rounded(Rounding::Limit(3));
        for (field, digits, [(below, under), (above, over)]) in [
            // A limit is rounded to the side on which it is kept.
            (&most, "", [(0.424_999, "0.424&nbsp;mm"), (0.425_001, "0.425&nbsp;mm")]),
            (&length, "limit", [(0.424_999, "0.424&nbsp;mm"), (0.425_001, "0.425&nbsp;mm")]),
            (&length, "limit", [(0.424_001, "0.424&nbsp;mm"), (0.423_999, "0.423&nbsp;mm")]),
            (&length, "limit", [(-0.424_001, "−0.425&nbsp;mm"), (-0.423_999, "−0.424&nbsp;mm")]),
            (&length, "limit4", [(0.424_999, "0.4249&nbsp;mm"), (0.425_001, "0.4250&nbsp;mm")]),
            (&length, "limit4", [(-0.424_001, "−0.4241&nbsp;mm"), (-0.423_999, "−0.4240&nbsp;mm")]),
            // All else is rounded to the nearest.
            (&length, "", [(0.424_499, "0.424&nbsp;mm"), (0.424_501, "0.425&nbsp;mm")]),
            (&length, "", [(24.999_4, "24.999&nbsp;mm"), (24.999_6, "25&nbsp;mm")]),
            (&length, ".1", [(0.449, "0.4&nbsp;mm"), (0.451, "0.5&nbsp;mm")]),
            (&length, "2", [(0.424_9, "0.42&nbsp;mm"), (0.425_1, "0.43&nbsp;mm")]),
            (&length, "size.1", [(-0.449, "0.4&nbsp;mm"), (-0.451, "0.5&nbsp;mm")]),
            (&length, "size2", [(-0.424_9, "0.42&nbsp;mm"), (-0.425_1, "0.43&nbsp;mm")]),
            (&factor, "", [(1.234_49, "1.234"), (1.234_51, "1.235")]),
            (&share, "", [(0.123_49, "12.3&nbsp;%"), (0.123_51, "12.4&nbsp;%")]),
            (&share, "", [(0.999_49, "99.9&nbsp;%"), (0.999_51, "100.0&nbsp;%")]),
        ] {
            for (value, said) in [(below, under), (above, over)] {
                assert_eq!(rounded(value, digits, field).expect("digits"), said, "{value}:{digits}");
            }
        }
    }

    #[test]
    fn what_is_not_known_is_answered_with_the_nearest_or_with_what_to_give() {
        for (asked, words) in [
            ("wroked.pin_diameter_mm", "`wroked`; the nearest is `worked`"),
            ("worked.pin_diametre_mm", "`pin_diametre_mm`; the nearest is `pin_diameter_mm`"),
            ("worked", "give QUESTION.KEY"),
            ("worked.pin_diameter_mm:x", "give digits such as 3 or .3"),
            ("free-six.pin_diameter_mm", "gives too little"),
            ("worked.type", "`type` has no number"),
        ] {
            let error = format!("{:#}", number(asked).expect_err(asked));
            assert!(error.contains(words), "{asked}: {error}");
        }
    }

    #[test]
    fn the_senses_that_the_solutions_tell_are_those_of_the_motion() {
        let motion = |instant: LeverProblem| instant.by_diagrams().expect("off the pivot");
        let mut ten = LeverProblem::printed().expect("a mechanism");
        ten.position = ten.linkage.position_at_lever_degrees(10.0, Branch::Far).expect("reached");
        let (ten, near) = (motion(ten), motion(LeverProblem::on(Branch::Near).expect("a mechanism")));
        // Of the lever's angular velocity and acceleration, of the sliding velocity: counter-clockwise, outwards.
        let senses = |of: &LeverMotion<f64>| {
            let outwards = of.velocities.sliding_velocity.dot(&of.velocities.position);
            [of.velocities.follower_speed, of.accelerations.follower_acceleration, outwards].map(f64::signum)
        };
        assert_eq!(senses(&ten), [1.0, -1.0, -1.0]);
        assert_eq!(senses(&near), [-1.0, -1.0, -1.0]);
        let along = |of: &LeverMotion<f64>| of.accelerations.sliding_tangential.dot(&of.velocities.position).signum();
        let across = |of: &LeverMotion<f64>| of.velocities.position.perp(&of.accelerations.coriolis).signum();
        assert_eq!([along(&ten), across(&ten)], [-1.0, -1.0]);
        assert_eq!([along(&near), across(&near)], [1.0, 1.0]);
    }
}
