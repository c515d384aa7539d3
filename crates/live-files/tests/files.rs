//! Files of the designer's settings, and what is refused.

use geneva_live::{LiveArguments, by_name};
use geneva_live_files::{answer, file};
use serde_json::Value;

const FIGURE: &str = "design";

#[test]
fn the_numbers_of_a_setting_can_be_taken_away() {
    let settings = LiveArguments::parse("stations=8&crank-radius=80&wheel-shaft=30").expect("one");
    let numbers = String::from_utf8(file(FIGURE, "numbers.csv", &settings).expect("a file")).expect("text");
    assert_eq!(numbers.lines().next(), Some("key,name,value,unit,meaning"));
    let value = |key: &str| {
        let line = numbers.lines().find(|line| line.starts_with(&format!("{key},"))).expect(key);
        line.split(',').nth(2).and_then(|value| value.parse::<f64>().ok()).expect("a number")
    };
    assert_eq!([value("stations"), value("crank_radius_mm"), value("wheel_shaft_mm")], [8.0, 80.0, 30.0]);
    let live = by_name(FIGURE).expect("a figure");
    let shown = live.answer(&settings).expect("an answer").numbers;
    let rms = shown.iter().find(|number| number.name == "rms").expect("loaded");
    assert_eq!(value("rms_crank_torque_nm"), rms.value);
}

#[test]
fn each_file_of_the_figure_and_no_other_is_made() {
    for live in geneva_live::LIVE {
        for of in live.files {
            let read: Value = serde_json::from_str(&answer(&format!("{}.{}?", live.name, of.name))).expect("JSON");
            let made = ["file", "base64"].iter().filter_map(|kind| read[kind].as_str());
            assert_eq!(made.filter(|text| !text.is_empty()).count(), 1, "{}: {}", of.name, read["error"]);
        }
    }
    for (question, why) in [
        ("design.wheel.exe?", "numbers.csv"),
        ("design?", "wheel.step"),
        ("pin.wheel.dxf?", "`design`"),
        ("design.wheel.dxf?stations=x", "give 3 to"),
        ("design.wheel.dxf?size=1", "there are stations"),
        ("design.wheel.dxf?pin-diameter=90", "mm"),
    ] {
        let read: Value = serde_json::from_str(&answer(question)).expect("JSON");
        assert!(read["error"].as_str().is_some_and(|error| error.contains(why)), "{question}: {read}");
    }
}
