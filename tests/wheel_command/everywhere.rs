//! Does each quantity of a wheel, which one file states, appear wherever a wheel is reported?

use crate::{number, object, stdout};
use geneva_ask::wheel::{Design, Question};
use geneva_ask::{Answer, Value};
use geneva_live::Arguments;

const ASKED: &str = "--stations 6 --crank-radius 25 --rpm 60 --inertia 0.002 --friction-torque 0.1 --at -20";
const MATERIALS: &str = " --thickness 10 --pin-material steel --wheel-material phosphor-bronze";

fn answer() -> Answer {
    let question = Question::parse(&format!("{ASKED}{MATERIALS}")).expect("arguments");
    Design::new(question).and_then(|design| design.answer()).expect("an answer")
}

/// What the program is told, with more behind the question.
fn typed(more: &'static str) -> Vec<&'static str> {
    ["wheel"].into_iter().chain(ASKED.split_whitespace()).chain(more.split_whitespace()).collect()
}

#[test]
fn every_field_is_in_the_object_and_on_the_sheet() {
    let (answer, found) = (answer(), object(&typed(MATERIALS)));
    let sheet = stdout(&typed(MATERIALS), 0);
    let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>().join(" ");
    let sheet = words(&sheet);
    for field in answer.fields() {
        assert_eq!(field.value == Value::Missing, found[field.key].is_null(), "{}", field.key);
        if let Some(value) = field.number() {
            assert_eq!(value, number(&found, field.key), "{}", field.key);
        }
        if let Some(line) = &field.line {
            let line = words(&format!("{} {} {} {}", line.name, line.number, line.unit, line.meaning));
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
fn a_quantity_for_pages_is_in_the_figure_that_a_reader_moves_and_in_its_file() {
    let live = geneva_live::by_name("design").expect("a figure");
    let (moved, file) = (live.answer(&Arguments::default()), live.file("csv", &Arguments::default()));
    let (moved, file) = (moved.expect("an answer"), file.expect("a file"));
    let (answer, mut count) = (answer(), 0);
    for field in answer.fields().filter(|field| field.is_on_pages) {
        let value = moved.numbers.iter().find(|number| number.name == field.key).expect(field.key).value;
        assert_eq!(Some(value), field.number(), "{}", field.key);
        let label = field.line.as_ref().expect("a line").name;
        assert!(moved.further.iter().any(|of| of.name == field.key && of.label == label), "{}", field.key);
        assert!(file.contains(&format!("\"{label}\",{value:?},")), "{label}: {file}");
        count += 1;
    }
    assert_eq!(moved.further.len(), count);
    assert!(count > 0, "no quantity is for pages");
}
