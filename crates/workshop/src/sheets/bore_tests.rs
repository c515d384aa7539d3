//! Is a bore ever narrower than its shaft?

use super::*;
use crate::parts::{BasePlate, Mounting, ShaftFit};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{Process, ProcessNumbers};
use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, ToleranceClass, ToleranceLetter, Wheel};

const STEEL: SheetMaterial<'static> = SheetMaterial { name: "steel", hardness: None };
/// The shaft of the sheets.
const SHAFT: ToleranceClass = ToleranceClass { letter: ToleranceLetter::LowerH, grade: 6 };

/// Sheets of a wheel with shafts so thick, with the plays of a process or with this play of the bores.
fn drawn(shaft: f64, fit: ShaftFit, process: Option<Process>, play: Option<f64>) -> Vec<Sheet> {
    let wheel = Wheel::new(8).unwrap();
    let radius = 2.0 * shaft + 30.0;
    let numbers =
        process.map(|process| ProcessNumbers::new(process, radius / libm::sin(wheel.half_pitch_angle())).unwrap());
    let usual = numbers.map_or(Play::from_slot(0.1), |numbers| numbers.play());
    let play = Play { bore: play.unwrap_or(usual.bore), ..usual };
    let choices =
        Choices { play: Some(play), wheel_shaft: Some(shaft), plate_shaft: Some(shaft), ..Choices::default() };
    let sizes = Sizes::new(wheel, Scale::CrankRadius(radius), &choices).unwrap();
    let limits = SheetLimits { process: numbers, ..SheetLimits::default() };
    let text = SheetText { project: "", wheel_material: STEEL, driver_material: STEEL, pin_material: STEEL };
    let base = (fit == ShaftFit::Round).then(|| BasePlate { thickness: Some(10.0), ..BasePlate::default() });
    sheets(&sizes, 8.0, &Mounting { wheel_fit: fit, base, ..Mounting::default() }, &limits, &text).unwrap()
}

/// The least bore on sheets, and the least width from a flat to the opposite side; as printed, in millimetres.
fn least(sheets: &[Sheet], measured: Measured) -> f64 {
    let of = sheets.iter().flat_map(|sheet| &sheet.dimensions).filter(|size| size.measured == measured);
    of.fold(f64::INFINITY, |least, size| {
        let printed = (size.nominal * 1000.0).round() / 1000.0;
        least.min(printed + size.limits.expect("limits")[0])
    })
}

#[test]
fn no_bore_is_narrower_than_its_shaft_whatever_makes_it() {
    let processes = std::iter::once(None).chain(Process::ALL.map(Some));
    let mut below = 0;
    for process in processes {
        // All whole diameters that a key is for, and some that are not whole.
        let whole = (6..=230).step_by(if matches!(process, None | Some(Process::Mill)) { 1 } else { 7 }).map(f64::from);
        for shaft in whole.chain([6.35, 9.525, 12.7, 25.4, 31.623_456, 99.999_6]) {
            for play in [None, Some(0.0), Some(0.003_4)] {
                let sheets = drawn(shaft, ShaftFit::Key, process, play);
                let [_, thickest] = SHAFT.limits(shaft).expect("a class");
                let bore = least(&sheets, Measured::Bore);
                assert!(bore >= shaft + thickest - 1e-9, "{process:?} {shaft} {play:?}: {bore}");
                below += u32::from(bore < shaft + 1e-3);
            }
        }
    }
    // Many are as narrow as that, so a micrometre less would be noticed.
    assert!(below > 200, "{below}");
}

#[test]
fn no_bore_with_a_flat_and_none_of_a_base_plate_is_narrower_than_its_shaft() {
    for process in std::iter::once(None).chain(Process::ALL.map(Some)) {
        for shaft in [3.0, 5.0, 6.35, 8.0, 10.0, 16.0, 25.0, 40.0] {
            let round = least(&drawn(shaft, ShaftFit::Round, process, None), Measured::Bore);
            assert!(round >= shaft - 1e-9, "{process:?} {shaft}: {round}");
            let across = 0.7 * shaft;
            let flat = least(&drawn(shaft, ShaftFit::Flat { across }, process, None), Measured::AcrossBore);
            assert!(flat >= across - 1e-9, "{process:?} {shaft}: {flat}");
        }
    }
}

#[test]
fn the_sheet_names_the_shaft_and_the_fit_of_a_key() {
    let all = |sheets: &[Sheet]| {
        sheets.iter().flat_map(|sheet| &sheet.ink.texts).map(|text| text.text.clone()).collect::<Vec<_>>().join(" ")
    };
    let metal = all(&drawn(20.0, ShaftFit::Key, None, None));
    assert!(metal.contains("for a shaft Ø20 h6") && metal.contains("Key h9, fitted without play"), "{metal}");
    let printed = all(&drawn(20.0, ShaftFit::Round, Some(Process::Fdm), None));
    assert!(printed.contains("for a shaft Ø20, not thicker") && !printed.contains("Key h9"), "{printed}");
}
