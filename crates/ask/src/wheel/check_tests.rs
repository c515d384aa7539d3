//! Tests of what is said of a wheel by its measured sizes.

use super::CheckQuestion;
use crate::{FieldValue, MechanismReport, ReportField};

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
    let report = report(&RIGHT.replace("--slot-width 4.2", "--slot-width 1:4.2,2:3.9+-0.02,3:4.2,4:4.2,5:4.2,6:4.2"));
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
    let words = words(&report, "culprit");
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
    let refused =
        |question: &str| CheckQuestion::parse(question).and_then(|of| of.answer()).expect_err("refused").to_string();
    assert!(refused("--crank-radius 25").contains("--stations is missing"));
    assert!(refused("--stations 6 --slot-width 7:6.1 --crank-radius 25").contains("numbers 1 to 6"));
    assert!(refused("--stations 6 --slot-width 0:6.1 --crank-radius 25").contains("numbered from 1"));
    assert!(refused("--stations 6 --crank-radius 1:25").contains("one only"));
    assert!(refused("--stations 6 --pin-diameter 4").contains("how large the wheel is"));
    assert!(refused("--stations 6 --crank-radius -25").contains("above zero"));
    assert!(refused("--stations 6 --radius 25").contains("--outside-diameter"));
    assert!(refused("--stations 6 --crank-radius 25 --rpm 0").contains("above zero"));
}

fn words(report: &MechanismReport, key: &str) -> String {
    report.field(key).and_then(|field| field.line.as_ref()).expect("a line").meaning.to_string()
}

#[test]
fn every_wrong_size_is_named_the_worst_first_with_the_numbers_of_the_right_wheel() {
    let measured = "--stations 6 --centre-distance 50.4 --crank-radius 25.0 --outside-diameter 87.1 --pin-diameter 6.0 \
                    --slot-width 1:6.1,2:6.1,3:6.1,4:6.3,5:6.1,6:6.1 --locking-disc-radius 15.2 --locking-arc-radius 15.4";
    let report = report(measured);
    let contradiction = words(&report, "culprit");
    assert_eq!(
        contradiction,
        "centre distance 50.40 mm: the others ask for 50.15 ± 0.03 mm, 5.0 of its uncertainties away. Besides, slot width 4 6.300 \
         mm: the others ask for 6.100 ± 0.02 mm, 4.0 of its uncertainties away; all others agree"
    );
    assert_eq!(text(&report, "change_first"), "make centre distance 50.15 mm, then slot width 4 6.100 mm");
    let shown = report.field("centre_distance_mm").and_then(ReportField::number).expect("a size");
    assert_eq!(report.field("culprit_expected").and_then(ReportField::number), Some(shown));
    assert!(report.sections[1].0.contains("without the sizes that contradict"));
    // Too far apart, the pin comes in on a corner.
    assert_eq!(report.field("lands_on_corner").map(|field| &field.value), Some(&FieldValue::Flag(true)));
    assert!(words(&report, "turns").contains("corner"), "{}", words(&report, "turns"));
    let entry = words(&report, "lands_on_corner");
    assert!(entry.contains("lands on the corner") && entry.contains("before a right pin would enter"), "{entry}");
}

#[test]
fn what_is_not_measured_or_not_counted_is_said() {
    let of_three = report("--stations 6 --centre-distance 50 --crank-radius 25 --outside-diameter 86.72");
    assert!(words(&of_three, "turns").contains("were not measured"), "{}", words(&of_three, "turns"));
    assert!(!words(&report(RIGHT), "turns").contains("not measured"));
    assert!(of_three.note.contains("corners of the slots count as sharp") && of_three.note.contains("bores"));
    let question = CheckQuestion::parse(RIGHT).expect("sizes");
    let mut with_hole = CheckQuestion { screw_hole: Some(3.4), has_mouths: true, ..question };
    assert!(!with_hole.answer().expect("an answer").note.contains("screw"), "the pin was typed");
    with_hole.measured = CheckQuestion::parse("--stations 6 --crank-radius 25").expect("sizes").measured;
    let note = with_hole.answer().expect("an answer").note;
    assert!(note.contains("3.400 mm") && note.contains("--pin-diameter") && note.contains("chamfered"), "{note}");
}

#[test]
fn sizes_can_be_in_inches() {
    let inches = CheckQuestion::parse(
        "--stations 6 --centre-distance 2in --crank-radius 1in+-0.001in --slot-width 1:17/64in,2:1/4\" --uncertainty 0.002in",
    );
    let millimetres = CheckQuestion::parse(
        "--stations 6 --centre-distance 50.8 --crank-radius 25.4+-0.0254 --slot-width 1:6.746875,2:6.35 --uncertainty 0.0508",
    );
    let [inches, millimetres] = [inches, millimetres].map(|question| question.expect("sizes").measured);
    for (one, other) in inches.sizes().iter().zip(millimetres.sizes()) {
        assert_eq!(one.size, other.size);
        assert!((one.value - other.value).abs() < 1e-12 && (one.uncertainty - other.uncertainty).abs() < 1e-12);
    }
    assert_eq!(inches.sizes().len(), 4);
}

#[test]
fn slots_that_are_too_shallow_are_named_with_what_is_missing() {
    // The pin reaches 23 mm from the wheel's axis: 50 − 25 − 2; the slot's bottom is at 25.5 − 2.1.
    let all = report(&format!("{RIGHT} --slot-end 25.5"));
    assert!(
        words(&all, "shallow_slots").contains("all slots are 0.4000 mm too shallow"),
        "{}",
        words(&all, "shallow_slots")
    );
    let missing = all.field("missing_depth_mm").and_then(ReportField::number).expect("missing");
    assert!((missing - 0.4).abs() < 1e-9, "{missing}");
    assert!(
        text(&all, "change_first").starts_with("make slot end 0.4000 mm smaller"),
        "{}",
        text(&all, "change_first")
    );
    let one = report(&format!("{RIGHT} --slot-end 1:24.8,2:24.8,3:25.5,4:24.8,5:24.8,6:24.8"));
    let said = words(&one, "shallow_slots");
    assert!(said.contains("slot 3 is 0.4000 mm too shallow") && !said.contains("slot 2"), "{said}");
    assert_eq!(one.field("shallow_slots").map(|field| &field.value), Some(&FieldValue::List(vec![3_usize.into()])));
    let none = report(&format!("{RIGHT} --slot-end 24.8"));
    assert_eq!(text(&none, "missing_depth_mm"), "Missing");
}

#[test]
fn a_right_wheel_of_many_stations_is_not_accused_by_coarse_measurements() {
    // 48 slots with errors as large as the play of 0.1 mm: a third of the slots seem too narrow.
    let errors = [0.04, -0.11, 0.02, 0.08, -0.09, -0.01];
    let slots = (0..48).map(|k| format!("{}:{:.2}", k + 1, 3.1 + errors[k % 6])).collect::<Vec<_>>().join(",");
    let of = |uncertainty: &str| {
        report(&format!(
            "--stations 48 --centre-distance 300 --crank-radius 19.62 --outside-diameter 598.72 --pin-diameter 3 --slot-width \
             {slots} --uncertainty {uncertainty}"
        ))
    };
    let coarse = of("0.1");
    let said = words(&coarse, "turns");
    assert!(said.contains("too coarse for this wheel") && said.contains("measure again"), "{said}");
    assert_eq!((text(&coarse, "turns"), text(&coarse, "culprit")), ("Missing".to_owned(), "Missing".to_owned()));
    assert_eq!(text(&coarse, "change_first"), "Missing");
    // With the uncertainty that it asks for, what is missing is more than chance.
    let finer: f64 = said
        .rsplit("uncertainties of ")
        .next()
        .and_then(|rest| rest.split(' ').next())
        .expect("a part")
        .parse()
        .expect("a number");
    let fine = of(&format!("{}", 0.1 * 0.99 * finer));
    assert_eq!(fine.field("turns").map(|field| &field.value), Some(&FieldValue::Flag(false)));
}
