//! Lengths as they are typed and as they are told: units, decimal commas, inches beside millimetres.

use crate::{number, object, refused, stdout};

#[test]
fn a_length_may_have_its_unit() {
    let of = |length| number(&object(&["wheel", "--stations", "6", "--crank-radius", length]), "crank_radius_mm");
    for length in ["50.8", "50.8mm", "5.08cm", "0.0508m", "2in", "2inch", "2\"", "2 inches"] {
        assert!((of(length) - 50.8).abs() < 1e-12, "{length}");
    }
    for (option, value, said) in [
        ("--crank-radius", "5lb", "lb is not a unit of length that is read here; give a number in mm, cm, m or in"),
        ("--crank-radius", "87,1", "give 87.1, with a decimal point, not a comma"),
        ("--crank-radius", "1,250", "give 1.250, with a decimal point, or 1250, without a comma"),
        ("--crank-radius", "1/8", "only inches have fractions; give 1/8in"),
        ("--rpm", "60,5", "give 60.5, with a decimal point, not a comma"),
        ("--table-mass", "5lb", "give 5, without lb: the option has its own unit"),
        ("--hub-holes", "3,5", "give an integer from 2 to 12"),
    ] {
        let error = refused(&["wheel", "--stations", "6", option, value]);
        assert!(error.contains(said), "{option} {value}: {error}");
    }
}

#[test]
fn commas_in_measured_sizes_are_between_slots_only() {
    let check = |option, value| refused(&["wheel", "check", "--stations", "6", "--crank-radius", "25", option, value]);
    for (option, value, said) in [
        ("--outside-diameter", "87,1", "--outside-diameter 87,1: give 87.1, with a decimal point"),
        ("--slot-width", "1:6,1:7", "--slot-width 1:6,1:7: number 1 is given twice"),
        ("--slot-width", "6,1", "give 6.1, with a decimal point"),
        ("--centre-distance", "5lb", "--centre-distance 5lb: lb is not a unit of length"),
    ] {
        let error = check(option, value);
        assert!(error.contains(said), "{option} {value}: {error}");
    }
}

#[test]
fn a_sheet_in_inches_has_each_length_in_both_units_and_data_keep_millimetres() {
    let asked = ["wheel", "--stations", "6", "--crank-radius", "25.4"];
    let plain = stdout(&asked, 0);
    let both = stdout(&[&asked[..], &["--unit", "in"]].concat(), 0);
    let millimetres = plain.lines().filter(|line| line.contains(" mm  ")).count();
    let inches: Vec<&str> = both.lines().filter(|line| line.contains(" mm  ") && line.contains(" in  ")).collect();
    assert!(millimetres > 20 && inches.len() == millimetres, "{} of {millimetres}", inches.len());
    for line in inches {
        let before = |unit: &str| -> f64 {
            let words: Vec<&str> = line.split(unit).next().expect("a number").split_whitespace().collect();
            words.last().expect("a number").replace('−', "-").parse().expect(line)
        };
        // A limit of few digits is rounded downwards.
        let (mm, inches) = (before(" mm "), before(" in  "));
        assert!((mm / 25.4 - inches).abs() <= 1.1e-3_f64.max(5e-4 * inches.abs()), "{line}");
    }
    let note = both.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(note.contains("the millimetres count, and all files are in millimetres"));
    for format in ["json", "csv", "fields", "svg", "dxf"] {
        let error = refused(&[&asked[..], &["--unit", "in", "--format", format]].concat());
        assert!(error.contains(&format!("--unit in has no effect on --format {format}")), "{error}");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("wheel");
    stdout(&[&asked[..], &["--unit", "in", "--out", out.to_str().expect("UTF-8")]].concat(), 0);
    let file = |name: &str| std::fs::read_to_string(out.join(name)).expect(name);
    assert!(file("sheet.txt").contains("2.000 in") && !file("numbers.csv").contains(" in,"));
    let check =
        ["wheel", "check", "--stations", "6", "--crank-radius", "1in", "--centre-distance", "2in", "--unit", "in"];
    assert!(stdout(&check, 0).contains("2.000 in"));
}

#[test]
fn an_internal_wheel_without_a_thickness_has_the_files_that_need_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("ring");
    let asked = [
        "wheel",
        "--stations",
        "6",
        "--type",
        "internal",
        "--crank-radius",
        "25",
        "--out",
        out.to_str().expect("UTF-8"),
    ];
    let text = stdout(&asked, 0);
    assert!(text.contains("Not written, because") && text.contains("add --thickness MM"), "{text}");
    assert!(out.join("sheet.txt").exists() && !out.join("wheel.dxf").exists());
    stdout(&[&asked[..], &["--thickness", "6"]].concat(), 0);
    assert!(out.join("wheel.dxf").exists());
}

#[test]
fn what_is_refused_is_told_in_the_units_that_were_typed() {
    let wheel = ["wheel", "--stations", "6"];
    for (options, said) in [
        (&["--crank-radius", "1in", "--pin-diameter", "1-1/2in"][..], "--pin-diameter 1-1/2in"),
        (&["--crank-radius", "1in", "--play", "40000in"], "--play 40000in: that is too large to make sense"),
        (&["--crank-radius", "25.4", "--pin-diameter", "38", "--unit", "in"], "--pin-diameter 38: "),
        (&["--crank-radius", "2cm", "--centre-error", "-5in"], "--centre-error -5in: the axes would be "),
        (&["--crank-radius", "-2in"], "-2in is not above zero; give a length above zero, such as 2in or 0.5in"),
        (&["--pin-diameter", "1/4in"], "--pin-diameter 1/4in has no effect without a size"),
    ] {
        let told = refused(&[&wheel[..], options].concat());
        assert!(told.contains(said), "{told}");
    }
    // What is said to be given is in inches, and fits.
    let asked = [&wheel[..], &["--crank-radius", "1in", "--pin-diameter", "1-1/2in"]].concat();
    let told = refused(&asked);
    let (_, given) = told.split_once("give --pin-diameter up to ").expect(&told);
    let most = given.split_whitespace().next().expect("a limit");
    assert!(most.ends_with("in") && !told.contains(" mm"), "{told}");
    stdout(&[&asked[..5], &["--pin-diameter", most]].concat(), 0);
    let check = ["wheel", "check", "--stations", "6", "--crank-radius", "3in", "--centre-distance", "2in"];
    let said = refused(&check);
    assert!(said.contains("crank radius 3.000 in: it must be at most"), "{said}");
}
