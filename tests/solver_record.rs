//! Does the record of the integrators say what the document on the solver says of it?

use csv::{Reader, ReaderBuilder, StringRecord};

/// The record, without the lines that say how it was made.
fn record() -> Reader<std::fs::File> {
    let path = crate::path("book/records/integrators.csv");
    ReaderBuilder::new().comment(Some(b'#')).from_path(path).expect("the record")
}

/// One contestant at one tolerance, by the columns' names; what a contestant does not have is not a number.
struct Measurement(StringRecord, StringRecord);

impl Measurement {
    fn text(&self, column: &str) -> &str {
        let at = self.0.iter().position(|name| name == column).unwrap_or_else(|| panic!("no column {column}"));
        &self.1[at]
    }

    fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or(f64::NAN)
    }
}

fn measurements() -> Vec<Measurement> {
    let mut record = record();
    let names = record.headers().expect("names").clone();
    record.records().map(|row| Measurement(names.clone(), row.expect("a row"))).collect()
}

/// The methods of the library, with the switches in the right-hand side.
const METHODS: [&str; 2] = ["dopri5", "dop853"];

fn least(numbers: &[f64]) -> f64 {
    numbers.iter().copied().fold(f64::INFINITY, f64::min)
}

fn most(numbers: &[f64]) -> f64 {
    numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// A number to two digits.
fn to_two_digits(number: f64) -> f64 {
    format!("{number:.1e}").parse().expect("a number")
}

#[test]
fn the_record_is_whole() {
    let all = measurements();
    for contestant in ["angle-steady", "angle-run", "dopri5", "dop853", "dopri5-located", "dop853-located", "mimic"] {
        let own: Vec<_> = all.iter().filter(|one| one.text("contestant") == contestant).collect();
        assert!(own.len() > 3 && own.iter().all(|one| one.text("runs") == "49"), "{contestant}");
        assert!(
            own.iter().all(|one| one.number("milliseconds") > 0.0 && one.number("true_error") > 0.0),
            "{contestant}"
        );
    }
    assert!(all.iter().any(|one| one.text("contestant") == "map" && one.number("points") > 500_000.0));
    let text = std::fs::read_to_string(crate::path("book/records/integrators.csv")).expect("the record");
    for condition in ["processor", "cores", "compiler", "date"] {
        assert!(text.lines().any(|line| line.starts_with(&format!("# {condition}: "))), "{condition}");
    }
}

#[test]
fn what_the_document_on_the_solver_says_of_the_record_is_so() {
    let all = measurements();
    let of = |contestant: &str, column: &str| -> Vec<f64> {
        let own = all.iter().filter(|one| one.text("contestant") == contestant);
        own.map(|one| one.number(column)).collect()
    };
    let times = |contestant| of(contestant, "milliseconds");
    let own = times("angle-run");
    let others = ["dopri5", "dop853", "dopri5-located", "dop853-located", "mimic"];
    assert!(others.iter().all(|other| most(&own) < least(&times(other))), "finest faster than coarsest");
    assert!(most(&own) < 1.5 * least(&own), "more precision costs it little");
    // The least time for an error that is small enough.
    let time = |contestant: &str, error: f64| {
        let fine = all.iter().filter(|one| one.text("contestant") == contestant && one.number("true_error") < error);
        least(&fine.map(|one| one.number("milliseconds")).collect::<Vec<_>>())
    };
    assert!(others[..4].iter().all(|method| time(method, 1e-7) < time("mimic", 1e-7)), "slowest at high precision");
    let coarse: Vec<f64> = others[..4].iter().map(|method| time(method, 1e-3)).collect();
    let slower = coarse.iter().filter(|other| time("mimic", 1e-3) < **other).count();
    assert!(slower >= 3, "not bad at the precision of the thesis: {coarse:?}");
    let each = |tolerance: &str| -> Vec<f64> {
        let maps = all.iter().filter(|one| one.text("contestant") == "map" && one.text("tolerance") == tolerance);
        maps.map(|one| one.number("milliseconds") / one.number("points")).collect()
    };
    for tolerance in ["1e-8", "1e-10"] {
        let each = each(tolerance);
        assert!(each.len() == 3 && most(&each) < 1.15 * least(&each), "{tolerance}: {each:?}");
    }

    let steady = all.iter().find(|one| one.text("contestant") == "angle-steady" && one.text("tolerance") == "1e-10");
    let steady = steady.expect("a measurement");
    assert!(steady.number("true_error") < 1e-14, "nearly all digits");
    let missed: Vec<f64> = METHODS
        .iter()
        .flat_map(|method| of(method, "true_error").into_iter().zip(of(method, "tolerance")))
        .map(|(error, tolerance)| error / tolerance)
        .collect();
    // At the same tolerances, in the same order.
    let ratios = |column: &str| -> Vec<f64> {
        let ratio = |method: &&str| {
            let located = format!("{method}-located");
            assert_eq!(of(method, "tolerance"), of(&located, "tolerance"));
            of(method, column).into_iter().zip(of(&located, column)).map(|(without, with)| without / with).collect()
        };
        METHODS.iter().flat_map(|method| -> Vec<f64> { ratio(method) }).collect()
    };
    let (errors, works) = (ratios("true_error"), ratios("evaluations"));
    let text = std::fs::read_to_string(crate::path("docs/solver.md")).expect("the document");
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for phrase in [
        format!("on {} escapements", steady.text("runs")),
        format!("takes {:.0} µs", 1e3 * steady.number("milliseconds") / steady.number("runs")),
        format!("by a factor of {} or more", to_two_digits(least(&missed))),
        format!("error {} to {} times smaller", to_two_digits(least(&errors)), to_two_digits(most(&errors))),
        format!("costs {:.1} to {:.1} times the work", 1.0 / most(&works), 1.0 / least(&works)),
    ] {
        assert!(text.contains(&phrase), "{phrase}");
    }
}
