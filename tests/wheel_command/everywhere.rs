//! Each quantity of a wheel is stated in one file. Does it appear wherever a wheel is reported?

use crate::{number, object, stdout};
use geneva_ask::wheel::{WheelDesign, WheelQuestion};
use geneva_ask::{FieldValue, MechanismReport, Rounding, SheetNumber};
use geneva_live::LiveArguments;

const ASKED: &str = "--stations 6 --crank-radius 25 --rpm 60 --inertia 0.002 --friction-torque 0.1 --at -20";
const MATERIALS: &str = " --thickness 10 --density 8860 --pin-material steel --wheel-material phosphor-bronze";

fn answer() -> MechanismReport {
    let question = WheelQuestion::parse(&format!("{ASKED}{MATERIALS}")).expect("arguments");
    WheelDesign::new(question).and_then(|design| design.answer()).expect("an answer")
}

/// What the program is told, with more behind the question.
fn typed(more: &'static str) -> Vec<&'static str> {
    ["wheel"].into_iter().chain(ASKED.split_whitespace()).chain(more.split_whitespace()).collect()
}

#[test]
fn every_field_has_a_row_in_the_table() {
    let asked = [ASKED.trim_end_matches(" --at -20"), MATERIALS, " --format fields"].concat();
    let table = stdout(&["wheel"].into_iter().chain(asked.split_whitespace()).collect::<Vec<_>>(), 0);
    let rows = csv::Reader::from_reader(table.as_bytes()).into_records().map(|row| row.expect("CSV"));
    let rows: Vec<Vec<String>> = rows.map(|row| row.iter().map(str::to_owned).collect()).collect();
    assert_eq!(table.lines().next(), Some("key,name,value,unit,meaning"));
    let answer = answer();
    assert_eq!(rows.len(), answer.fields().count());
    for (row, field) in rows.iter().zip(answer.fields()) {
        let value = row[2].parse().ok();
        assert_eq!((&*row[0], &*row[3]), (field.key, field.unit), "{row:?}");
        assert!(field.number() == value || field.number().is_none(), "{row:?}");
        let Some(line) = &field.line else { continue };
        // The name that a sheet leaves out under a line of the same name is there.
        assert!(!row[1].is_empty() && (line.name.is_empty() || line.name == row[1]), "{row:?}");
        assert!(line.meaning.is_empty() || line.meaning == row[4], "{row:?}");
    }
}

#[test]
fn every_field_is_in_the_object_and_on_the_sheet() {
    let (answer, found) = (answer(), object(&typed(MATERIALS)));
    let sheet = stdout(&typed(MATERIALS), 0);
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>().join(" ");
    let sheet = words(&sheet);
    for field in answer.fields() {
        assert_eq!(field.value == FieldValue::Missing, found[field.key].is_null(), "{}", field.key);
        if let Some(value) = field.number() {
            assert_eq!(value, number(&found, field.key), "{}", field.key);
        }
        if let Some(line) = &field.line {
            let unit = if line.shows == SheetNumber::Words { "" } else { field.unit };
            let line = words(&format!("{} {} {} {}", line.name, field.on_a_sheet(), unit, line.meaning));
            assert!(sheet.contains(&line), "{}: no line {line:?}", field.key);
        }
    }
    assert_eq!(found.len(), answer.fields().count() + 1, "an object with other keys than fields and `at`");
}

#[test]
fn every_number_of_an_instant_is_in_the_series_and_in_the_object() {
    let series = stdout(&typed("--format csv"), 0);
    let header: Vec<&str> = series.lines().next().expect("a header").split(',').collect();
    let answer = answer();
    let row = answer.rows().next().expect("an instant");
    let keys: Vec<&str> = row.0.iter().map(|(key, _)| *key).collect();
    assert_eq!(header, keys);
    let found = object(&typed(""));
    assert!(found["at"][0].as_object().expect("an instant").keys().all(|key| keys.contains(&&**key)));
}

#[test]
fn the_figure_that_a_reader_moves_and_its_file_say_the_numbers_of_the_answer() {
    let live = geneva_live::by_name("design").expect("a figure");
    let none = LiveArguments::default();
    let (moved, file) = (live.answer(&none), geneva_live_files::file(live.name, "numbers.csv", &none));
    let file = String::from_utf8(file.expect("a file")).expect("text");
    let (moved, answer) = (moved.expect("an answer"), answer());
    // A quantity of a list in one file is there under its own name.
    assert!(!moved.further.is_empty(), "no quantity is listed for pages");
    for of in &moved.further {
        let line = answer.field(of.name).and_then(|field| field.line.as_ref()).expect(of.name);
        assert_eq!((of.key, of.label), (Some(of.name), line.name));
    }
    let rows: Vec<_> = csv::Reader::from_reader(file.as_bytes()).into_records().map(|row| row.expect("CSV")).collect();
    let in_file = |key: &str| rows.iter().find(|row| &row[0] == key).and_then(|row| row[2].parse::<f64>().ok());
    let mut all = 0;
    for of in live.quantities.iter().chain(live.others).chain(&moved.further) {
        let Some(key) = of.key else { continue };
        let field = answer.field(key).expect(key);
        let Some(number) = moved.numbers.iter().find(|number| number.name == of.name) else {
            // There is no bore without a shaft, for one.
            assert_eq!(field.number(), None, "{key} is not shown");
            continue;
        };
        let part = if matches!(field.rounding, Rounding::Percent(_)) { 100.0 } else { 1.0 };
        assert_eq!(Some(number.value), field.number().map(|value| part * value), "{key}");
        assert_eq!(in_file(key), field.number(), "{key}: {file}");
        all += 1;
    }
    assert!(all > 30, "only {all} of its numbers are fields");
    let clearance = moved.numbers.iter().find(|number| number.name == "clearance").map(|number| number.value);
    assert_eq!(clearance, answer.field("least_clearance_mm").expect("a field").number());
}

#[test]
fn a_centre_distance_in_the_figure_is_that_of_the_command() {
    let live = geneva_live::by_name("design").expect("a figure");
    let asked = LiveArguments::parse("stations=8&centre-distance=120&play=0.06").expect("arguments");
    let moved = live.answer(&asked).expect("an answer");
    let found = object(&["wheel", "--stations", "8", "--centre-distance", "120", "--play", "0.06"]);
    let shown = |name: &str| moved.numbers.iter().find(|number| number.name == name).expect(name).value;
    for (name, key) in
        [("centres", "centre_distance_mm"), ("crank-radius", "crank_radius_mm"), ("disc", "locking_radius_mm")]
    {
        assert_eq!(shown(name), number(&found, key), "{key}");
    }
}
