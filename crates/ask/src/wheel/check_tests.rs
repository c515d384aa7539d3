//! Tests of what is said of a wheel by its measured sizes.

use super::{CheckQuestion, told_culprits};
use crate::wheel::check_certainty::shallow_slots;
use crate::wheel::check_needs::unmeasured_of_verdict;
use crate::wheel::check_remedies::{WheelRemedy, remedies};
use crate::{FieldValue, MechanismReport, ReportField};
use geneva_kinematics::wheel::as_built::AsBuiltWheel;

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
    assert!(text(&report, "change_first").starts_with("widen slot 2 to 4.2"));
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
    assert_eq!(
        text(&report, "change_first"),
        "put the axes 50.15 mm apart, in a new plate if they can't be moved, then make a new wheel with slots of 6.100 mm, because slot 4 gets no narrower; or, \
         leave the axes 50.40 mm apart and make a new wheel with an outside diameter of 87.51 mm and a new driver with the pin 25.20 mm from its \
         axis"
    );
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
    assert!(words(&of_three, "turns").starts_with("not known; measure the pin diameter (--pin-diameter), "));
    let taken =
        "yes, every station; the ends of the slots and the cut in the disc were not measured and count as right";
    assert_eq!(words(&report(RIGHT), "turns"), taken);
    let with_all = format!("{RIGHT} --slot-end 24.8 --crescent-centre 42 --crescent-radius 36.92");
    assert_eq!(words(&report(&with_all), "turns"), "yes, every station");
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
        text(&all, "change_first").starts_with("make the slots 0.4000 mm deeper"),
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

/// The remedies of a question, and the wheel as it was made.
fn remedies_of(question: &str) -> (Vec<WheelRemedy>, AsBuiltWheel) {
    let measured = CheckQuestion::parse(question).expect("sizes").measured;
    let nearest = measured.nearest().expect("a wheel");
    let built = measured.as_built(&nearest);
    let shallow = shallow_slots(&measured, &built);
    let open = unmeasured_of_verdict(&measured, &built, &built.turn().expect("a turn"));
    let culprits = told_culprits(&nearest, &measured.undecided_culprits(&nearest));
    (remedies(&measured, &nearest, &culprits, &built, &shallow, open.is_empty()).expect("remedies"), built)
}

#[test]
fn with_each_remedy_carried_out_the_wheel_turns() {
    // Of right wheels, each size in turn too large and too small.
    let right = [
        (
            3,
            "--centre-distance 28.8675 --crank-radius 25 --outside-diameter 28.9843 --pin-diameter 2.3 --slot-width 2.36 \
             --locking-disc-radius 20.3 --locking-arc-radius 20.33",
        ),
        (6, RIGHT.split_once("6 ").expect("sizes").1),
        (
            8,
            "--centre-distance 83.62 --crank-radius 32 --outside-diameter 154.813 --pin-diameter 9.6 --slot-width 9.68 --slot-end 51 \
             --locking-disc-radius 17.5 --locking-arc-radius 17.54",
        ),
    ];
    let mut carried_out = 0;
    for (stations, sizes) in right {
        let words: Vec<&str> = sizes.split_whitespace().collect();
        for k in (1..words.len()).step_by(2) {
            for by in [-1.1, -0.3, 0.3, 1.1] {
                let mut changed: Vec<String> = words.iter().map(|word| (*word).to_owned()).collect();
                if words[k - 1] == "--uncertainty" {
                    continue;
                }
                changed[k] = format!("{}", words[k].parse::<f64>().expect("a number") + by);
                let question = format!("--stations {stations} {}", changed.join(" "));
                let (remedies, built) = remedies_of(&question);
                for remedy in remedies {
                    // Of a change, "a little more for play".
                    let turn = remedy.carried_out(&built, 0.05).turn().expect("a turn");
                    assert!(turn.is_driven(), "{question}: {remedy:?} {:?}", turn.jam);
                    carried_out += 1;
                }
            }
        }
    }
    assert!(carried_out > 40, "{carried_out}");
}

#[test]
fn a_pin_that_passes_outside_the_rim_turns_nothing() {
    let far = report("--stations 6 --crank-radius 25 --centre-distance 80");
    assert_eq!(far.field("turns").map(|field| &field.value), Some(&FieldValue::Flag(false)));
    assert!(
        words(&far, "turns").starts_with("no: the pin never meets the wheel: it passes"),
        "{}",
        words(&far, "turns")
    );
    let unheld = report(&RIGHT.replace("--centre-distance 50 ", "--centre-distance 63 "));
    assert_eq!(unheld.field("turns").map(|field| &field.value), Some(&FieldValue::Flag(false)));
    assert!(words(&unheld, "turns").contains("nothing holds the wheel"), "{}", words(&unheld, "turns"));
    assert_eq!(
        text(&far, "change_first"),
        "measure the outside diameter (--outside-diameter) or the locking arc's centre (--locking-arc-centre)"
    );
}

/// All that is told of play, entry and blows.
const MADE: [&str; 10] = [
    "tightest_room_mm",
    "index_backlash_deg",
    "dwell_backlash_deg",
    "greatest_dwell_backlash_deg",
    "station_error_deg",
    "lost_motion_deg",
    "blow_ratio",
    "greatest_blow_ratio",
    "can_miss",
    "lands_on_corner",
];

/// Which of these are told.
fn told(report: &MechanismReport) -> Vec<&'static str> {
    let is_told = |key: &&str| report.field(key).is_some_and(|field| field.value != FieldValue::Missing);
    MADE.into_iter().filter(|key| is_told(key)).collect()
}

#[test]
fn what_rests_on_a_size_that_was_not_measured_is_not_told() {
    let few = report("--stations 6 --outside-diameter 87.1 --pin-diameter 6 --rpm 60");
    assert_eq!(told(&few), [""; 0]);
    assert_eq!((text(&few, "turns"), text(&few, "blow_mm_s")), ("Missing".to_owned(), "Missing".to_owned()));
    for (key, option) in [
        ("turns", "--locking-arc-radius"),
        ("lands_on_corner", "--centre-distance"),
        ("shallow_slots", "--slot-end"),
        ("index_backlash_deg", "--slot-width"),
        ("dwell_backlash_deg", "--locking-disc-radius"),
        ("station_error_deg", "--locking-arc-radius 1:15.1,2:15.2"),
        ("change_first", "nothing that was measured"),
    ] {
        assert!(words(&few, key).contains(option), "{key}: {}", words(&few, key));
    }
    // Each kind of play needs its own two sizes.
    let index = report("--stations 6 --outside-diameter 87.1 --pin-diameter 6 --slot-width 6.1");
    assert_eq!(told(&index), ["index_backlash_deg"]);
    let dwell = report("--stations 6 --outside-diameter 87.1 --locking-disc-radius 15 --locking-arc-radius 15.1");
    assert_eq!(told(&dwell), ["dwell_backlash_deg"]);
    // Where one pin enters as another leaves, there is no disc, and all play is of pins and slots.
    let without_disc = "--stations 3 --pins 6 --crank-radius 25 --pin-diameter 2";
    assert_eq!(told(&report(without_disc)), [""; 0]);
    let with_slots = format!("{without_disc} --slot-width 2.1");
    assert_eq!(told(&report(&with_slots)), ["index_backlash_deg", "dwell_backlash_deg"]);
    // Of single slots, those that were measured: the play of the widest is 0.2 mm at 25 mm from the axis.
    let single = report(
        "--stations 6 --centre-distance 50 --crank-radius 25 --pin-diameter 6 --slot-width 2:6.1+-0.5,5:6.2+-0.5 --outside-diameter 86.8",
    );
    let play = single.field("index_backlash_deg").and_then(ReportField::number).expect("a play");
    assert!((play - (2.0 * libm::asin(0.1 / 25.0)).to_degrees()).abs() < 1e-9, "{play}");
    assert!(words(&single, "turns").contains("slot width of number 1, 3, 4 and 6 (--slot-width)"));
}

#[test]
fn what_is_named_tells_what_was_not_known() {
    let few = "--stations 6 --outside-diameter 86.72 --pin-diameter 4";
    let report_of_few = report(few);
    let FieldValue::List(options) = &report_of_few.field("unmeasured").expect("options").value else {
        panic!("a list")
    };
    let value = |option: &str| match option {
        "centre-distance" => "50",
        "crank-radius" => "25",
        "slot-width" => "4.2",
        "slot-end" => "24.8",
        "locking-disc-radius" => "18.8",
        "locking-arc-radius" => "1:18.9,2:18.9,3:18.9,4:18.9,5:18.9,6:18.9",
        "crescent-centre" => "42",
        "crescent-radius" => "36.92",
        other => panic!("{other}"),
    };
    let mut question = few.to_owned();
    for option in options {
        let FieldValue::Text(option) = option else { panic!("a name") };
        question += &format!(" --{option} {}", value(option));
    }
    let all = report(&question);
    assert_eq!(told(&all), MADE);
    assert_eq!(all.field("unmeasured").map(|field| &field.value), Some(&FieldValue::List(Vec::new())));
    assert_eq!(words(&all, "turns"), "yes, every station");
    assert!(!all.plain_sheet().contains("not known") && !all.plain_sheet().contains("not measured;"));
}

#[test]
fn the_centres_of_the_arcs_stand_for_the_axes() {
    let of_arcs = report(&RIGHT.replace("--centre-distance", "--locking-arc-centre"));
    let said = words(&of_arcs, "turns");
    assert!(said.starts_with("yes, every station; the centre distance, the ends of the slots and"), "{said}");
    let with_ends = report(&format!("{RIGHT} --slot-end 24.8"));
    assert_eq!(
        words(&with_ends, "turns"),
        "yes, every station; the cut in the disc was not measured and counts as right"
    );
}

#[test]
fn a_jam_counts_only_if_the_sizes_that_meet_were_measured() {
    // The disc would be deep in its arc if both were as designed.
    let open = report("--stations 6 --crank-radius 25 --centre-distance 49");
    assert_eq!(text(&open, "turns"), "Missing");
    assert!(
        words(&open, "turns").contains("As in the nearest right wheel, they would leave"),
        "{}",
        words(&open, "turns")
    );
    assert!(
        text(&open, "change_first").starts_with("measure the outside diameter (--outside-diameter)"),
        "{}",
        text(&open, "change_first")
    );
    // A pin that is thicker than its slot jams wherever the axes are.
    let thick = report("--stations 6 --outside-diameter 87.1 --pin-diameter 6+-0.02 --slot-width 5.8+-0.02");
    assert_eq!(thick.field("turns").map(|field| &field.value), Some(&FieldValue::Flag(false)));
}

#[test]
fn a_worn_slot_widens_the_play_in_mid_index_only() {
    let of = |width: &str| {
        let report = report(&format!(
            "--stations 6 --centre-distance 50 --crank-radius 25 --outside-diameter 86.8 --pin-diameter 6 --slot-width {width} \
             --locking-disc-radius 15.3 --locking-arc-radius 15.4"
        ));
        ["index_backlash_deg", "dwell_backlash_deg"]
            .map(|key| report.field(key).and_then(ReportField::number).expect("a play"))
    };
    let new = of("6.06");
    for width in ["6.4", "7", "1:6.06,2:6.06,3:7,4:6.06,5:6.06,6:6.06"] {
        let worn = of(width);
        assert!(worn[0] > 1.5 * new[0], "{width}: {worn:?}");
        assert!((worn[1] - new[1]).abs() < 1e-9, "{width}: {worn:?} {new:?}");
    }
}

#[test]
fn a_comma_in_a_number_is_refused_with_what_to_write() {
    let refused = |sizes: &str| CheckQuestion::parse(&format!("--stations 6 {sizes}")).expect_err(sizes).to_string();
    for (sizes, said) in [
        ("--outside-diameter 87,1", "give 87.1, with a decimal point, not a comma"),
        ("--outside-diameter 87,1+-0,05", "give 87.1+-0.05, with a decimal point, not a comma"),
        ("--slot-width 6,1", "give 6.1, with a decimal point, not a comma; commas are between slots"),
        ("--slot-width 1:6,1,2:6,05", "give 1:6.1,2:6.05, with a decimal point, not a comma; commas are between slots"),
        ("--slot-width 6.1,6.0,6.2", "give each slot or arc with its number, as in 1:6.1,2:6.0"),
        ("--crank-radius 25,25.1,25.2", "there is one only"),
        ("--slot-width 1:6,1:7", "number 1 is given twice; give each number once"),
        ("--slot-direction 1:0.1,1:0.2", "number 1 is given twice"),
        ("--uncertainty 0,05", "give 0.05, with a decimal point"),
        ("--rpm 60,5", "give 60.5, with a decimal point"),
        ("--crank-radius 5lb", "lb is not a unit of length that is read here; give a number in mm, cm, m or in"),
    ] {
        let error = refused(sizes);
        assert!(error.starts_with(sizes) && error.contains(said), "{sizes}: {error}");
    }
}

const WORN: &str = "--stations 6 --centre-distance 50 --crank-radius 25 --outside-diameter 86.82 --locking-disc-radius 15.3 \
                    --locking-arc-radius 15.35 --pin-diameter 6 --slot-width 7.2";

/// The commands that a report gives, without the program's name.
fn commands(report: &MechanismReport) -> Vec<String> {
    let FieldValue::List(commands) = &report.field("design_commands").expect("commands").value else {
        panic!("a list")
    };
    let arguments = |command: &FieldValue| match command {
        FieldValue::Text(text) => text.strip_prefix("geneva wheel ").expect("the program's name").to_owned(),
        other => panic!("{other:?}"),
    };
    commands.iter().map(arguments).collect()
}

#[test]
fn of_worn_slots_and_pins_the_part_to_make_new_is_named_with_a_command_that_designs_it() {
    let open = report(WORN);
    assert_eq!(text(&open, "culprit"), "Missing");
    assert_eq!(
        text(&open, "change_first"),
        "measure the slot width when new (--new-slot-width) or the pin diameter when new (--new-pin-diameter)"
    );
    assert!(words(&open, "culprit").contains("1.200 mm of play, and a new one at most 0.9000 mm"));
    for (more, said, pins) in [
        (
            " --new-slot-width 6.1",
            "make a new wheel with slots of 6.100 mm, because slots get no narrower; or, make a new pin with a \
          diameter of 7.100 mm",
            vec![6.0, 7.1],
        ),
        (" --new-pin-diameter 7.1", "make a new pin with a diameter of 7.100 mm", vec![7.1]),
    ] {
        let told = report(&format!("{WORN}{more}"));
        assert_eq!(text(&told, "change_first"), said, "{more}");
        let commands = commands(&told);
        let designed: Vec<f64> = commands
            .iter()
            .map(|command| {
                let report = crate::answer(&format!("wheel {command}")).or_else(|_| crate::answer(command));
                let report = report.expect("a design");
                report.field("pin_diameter_mm").and_then(ReportField::number).expect("a pin")
            })
            .collect();
        assert_eq!(designed.len(), pins.len(), "{commands:?}");
        assert!(designed.iter().zip(&pins).all(|(one, other)| (one - other).abs() < 2e-3), "{commands:?} {designed:?}");
    }
    // Slots that were measured one by one are of one wheel.
    let single =
        WORN.replace("--slot-width 7.2", "--slot-width 1:6.6,2:6.7,3:6.6,4:6.7,5:6.6,6:6.6 --new-slot-width 6.1");
    assert_eq!(
        text(&report(&single), "change_first"),
        "make a new wheel with slots of 6.100 mm, because slots get no narrower; or, make a new pin with a diameter of 6.500 mm"
    );
}

#[test]
fn a_number_of_stations_that_fits_better_is_named() {
    let said = report(&WORN.replace("--stations 6", "--stations 5").replace("7.2", "6.1"));
    assert_eq!(said.field("fitting_stations").map(|field| &field.value), Some(&FieldValue::List(vec![6_usize.into()])));
    assert!(
        words(&said, "culprit").contains("count the slots again and try --stations 6"),
        "{}",
        words(&said, "culprit")
    );
    assert_eq!(text(&said, "culprit"), "Missing");
    assert!(text(&said, "change_first").starts_with("count the slots again: with --stations 6 nothing is wrong"));
}

#[test]
fn the_play_of_a_thin_pin_in_mid_index_is_that_between_the_walls_seen_by_points() {
    // The cut in the disc is not measured, and what it was filled in with met the horns: the play was told to be zero.
    let of = |question: &str| {
        let report = report(question);
        report.field("index_backlash_deg").and_then(ReportField::number).expect("a play")
    };
    let sizes = "--crank-radius 25 --outside-diameter 86.82 --locking-disc-radius 15.3 --locking-arc-radius 15.35";
    for pin in [2.5, 4.0, 6.0] {
        let play = of(&format!("--stations 5 --centre-distance 50 {sizes} --slot-width 6.1 --pin-diameter {pin}"));
        // Points on the pin, 50 mm − 25 mm from the wheel's axis, turned back by the wheel's angle: inside the walls?
        let is_free = |angle: f64| {
            (0..2000).all(|k| {
                let around = std::f64::consts::TAU * f64::from(k) / 2000.0;
                let [x, y] = [25.0 + pin / 2.0 * libm::cos(around), pin / 2.0 * libm::sin(around)];
                (y * libm::cos(angle) - x * libm::sin(angle)).abs() <= 6.1 / 2.0
            })
        };
        let [mut inside, mut outside] = [0.0, 0.5];
        for _ in 0..30 {
            let middle = f64::midpoint(inside, outside);
            if is_free(middle) { inside = middle } else { outside = middle }
        }
        assert!((play - 2.0 * inside.to_degrees()).abs() < 1e-4, "{pin}: {play} {}", 2.0 * inside.to_degrees());
    }
}

#[test]
fn what_takes_material_away_is_work_and_what_would_bring_it_back_is_a_new_part() {
    use crate::wheel::check_advice::part_words;
    use geneva_kinematics::wheel::as_built::MeasuredSize as Size;
    for (size, removes_if_larger) in [
        (Size::SlotWidth(None), true),
        (Size::SlotWidth(Some(1)), true),
        (Size::SlotEnd(None), false),
        (Size::ArcRadius(None), true),
        (Size::TipRadius, false),
        (Size::DiscRadius, false),
        (Size::CrescentRadius, true),
    ] {
        for (measured, value) in [(10.0, 9.0), (10.0, 11.0)] {
            let words = part_words(size, measured, value, 4);
            assert_eq!(words.starts_with("make a new "), (value > measured) != removes_if_larger, "{size:?} {words}");
        }
    }
}
