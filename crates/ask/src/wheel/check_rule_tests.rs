//! Tests of what a check fills in, designs and names: by rules that no uncertainty of another size moves.

use super::check::CheckQuestion;
use super::{WheelDesign, WheelQuestion};
use crate::{FieldValue, MechanismReport, ReportField};

fn report(question: &str) -> MechanismReport {
    CheckQuestion::parse(question).and_then(|question| question.answer()).expect(question)
}

fn number(report: &MechanismReport, key: &str) -> f64 {
    report.field(key).and_then(ReportField::number).expect(key)
}

fn words(report: &MechanismReport, key: &str) -> String {
    report.field(key).and_then(|field| field.line.as_ref()).expect(key).meaning.to_string()
}

fn list(report: &MechanismReport, key: &str) -> Vec<String> {
    let FieldValue::List(all) = &report.field(key).expect(key).value else { return Vec::new() };
    let text = |value: &FieldValue| match value {
        FieldValue::Text(text) => text.clone(),
        other => format!("{other:?}"),
    };
    all.iter().map(text).collect()
}

/// The sizes of the design that a command asks for.
fn designed(command: &str) -> geneva_kinematics::wheel::Sizes {
    let question = WheelQuestion::parse(command.trim_start_matches("geneva wheel ")).expect(command);
    WheelDesign::new(question).expect(command).sizes.expect(command)
}

const AXES: &str = "--stations 6 --outside-diameter 86.6+-0.1 --centre-distance 50.3+-0.1 --crank-radius 24.8+-0.1";

#[test]
fn a_pin_that_was_not_measured_has_the_usual_play_whatever_the_uncertainty_of_a_size() {
    let slot = format!("{AXES} --locking-arc-radius 19+-0.05 --slot-width");
    for uncertainty in ["0.01", "0.05", "0.1", "0.2", "0.4"] {
        let report = report(&format!("{slot} 8.1+-{uncertainty}"));
        // A thousandth of the centre distance, and the disc as much in its arcs.
        let usual = number(&report, "centre_distance_mm") / 1000.0;
        let plays = [
            number(&report, "slot_width_mm") - number(&report, "pin_diameter_mm"),
            2.0 * (number(&report, "locking_arc_radius_mm") - number(&report, "locking_disc_radius_mm")),
        ];
        for play in plays {
            assert!((play - usual).abs() < 1e-3, "{uncertainty}: {plays:?}");
        }
        assert!((number(&report, "slot_width_mm") - 8.1).abs() < 1e-3, "{uncertainty}");
        let commands = list(&report, "design_commands");
        assert!(!commands.is_empty(), "{uncertainty}");
        for command in commands {
            let play = designed(&command).play.slot;
            assert!((play - usual).abs() < 2e-3, "{command}: {play}");
        }
        assert!(words(&report, "design_commands").contains("the pin, which was not measured"), "{uncertainty}");
    }
    // A pin that was measured stays, and without a slot nothing of either is designed.
    let both = report(&format!("{slot} 8.1+-0.05 --pin-diameter 7.9+-0.05"));
    assert!((number(&both, "pin_diameter_mm") - 7.9).abs() < 1e-3);
    assert!(!words(&both, "design_commands").contains("not measured"));
    let neither = list(&report(AXES), "design_commands");
    assert!(neither.iter().all(|command| !command.contains("--pin-diameter")), "{neither:?}");
}

#[test]
fn wear_within_the_uncertainties_is_told_with_those_that_would_tell_it_and_a_new_wheel_has_the_new_size() {
    let of = |now: &str, new: &str| {
        report(&format!("{AXES} --locking-arc-radius 19+-0.05 --slot-width 8.1+-{now} --new-slot-width 8.0+-{new}"))
    };
    let coarse = of("0.05", "0.05");
    let said = words(&coarse, "untold_wear_mm");
    assert!(said.contains("slot width: 0.1000 mm off") && said.contains("certain only from"), "{said}");
    assert!(!words(&coarse, "culprit").contains("slot width"), "{}", words(&coarse, "culprit"));
    for command in list(&coarse, "design_commands") {
        assert!((designed(&command).slot_width - 8.0).abs() < 1e-3, "{command}");
    }
    // With the uncertainty that it asks for, it is told.
    let (_, needed) = said.split_once("uncertainty of ").expect(&said);
    let (needed, _) = needed.split_once(" mm").expect(&said);
    let fine = of(needed, needed);
    assert!(words(&fine, "culprit").contains("slot width"), "{needed}: {}", words(&fine, "culprit"));
    assert_eq!(fine.field("untold_wear_mm").and_then(ReportField::number), None);
    let slightly: f64 = needed.parse().expect("a number");
    let coarser = format!("{:.4}", 1.3 * slightly);
    assert!(!words(&of(&coarser, &coarser), "culprit").contains("slot width"), "{coarser}");
}

#[test]
fn a_wrong_formula_does_not_come_and_go_with_the_uncertainty_of_another_size() {
    let of = |arc: &str| {
        list(&report(&format!("{AXES} --slot-width 8.1+-0.1 --locking-arc-radius 19+-{arc}")), "wrong_formulas")
    };
    let first = of("0.05");
    assert!(!first.is_empty());
    for arc in ["0.1", "0.2", "0.4"] {
        assert_eq!(of(arc), first, "{arc}");
    }
}

#[test]
fn axes_that_are_wrong_have_two_remedies_each_with_its_command() {
    let report = report(
        "--stations 6 --centre-distance 50.45 --crank-radius 25 --outside-diameter 86.95 --pin-diameter 7.5 --slot-width 7.6 \
         --locking-disc-radius 13.65 --locking-arc-radius 13.72",
    );
    let change = words(&report, "change_first");
    assert!(change.contains("put the axes 50.0") && change.contains("leave the axes 50.45 mm apart"), "{change}");
    let commands = list(&report, "design_commands");
    assert_eq!(commands.len(), 2, "{commands:?}");
    let [moved, kept] = [0, 1].map(|k| designed(&commands[k]));
    assert!((kept.centre_distance - 50.45).abs() < 1e-9 && (moved.centre_distance - 50.45).abs() > 0.3);
    // R = C sin(180°/N).
    assert!((kept.crank_radius - 50.45 / 2.0).abs() < 1e-9);
    for told in [kept.crank_radius, 2.0 * kept.tip_radius] {
        let told = crate::number_format::number(told);
        assert!(change.contains(&told), "{told}: {change}");
    }
    assert!((kept.slot_width - 7.6).abs() < 2e-3 && (kept.pin_diameter - 7.5).abs() < 2e-3);
}
