//! The runs of 1973 with the program set otherwise: printed numbers against computed ones.

use crate::answer::{LiveNumber, LiveQuantity, LiveReply, Progress};
use crate::arguments::number;
use crate::control::{Control, Live, Preset, Settings};
use geneva_case1973::{Constants, Given, Hypothesis, Lag, Listing, PeakReading, Reset, Row, Score, SixPin};
use geneva_dynamics::{Inertias, Parameters};
use geneva_figures::runs::{ComparedCells, one_agreement};
use geneva_kinematics::Mechanism;
use std::cell::RefCell;

/// Runs of the program on its integrator that are made at one asking.
const AT_ONCE: usize = 2;

pub const LIVE: Live = Live {
    name: "mistake",
    module: "live",
    figure: "live-mistake",
    hint: "Move the reset angle away from 90°: the marks for three pins leave the line to one side, and the marks for \
           six pins to the other. Only at 90° do nearly all marks for four pins stay on the line. Back at 90°, set \
           the sign of friction to “at once, as in the mechanism”: slightly fewer numbers agree.",
    controls: &[
        Control::slider("reset", "reset angle", "°", [60.0, 120.0], 0.5, 90.0)
            .with_typed_range([30.0, 170.0])
            .playing(6.0),
        Control::choice("own", "for", &["all three mechanisms", "none: each its own angle"], 0),
        Control::choice("six", "inertias with six pins", &["as in the table", "as in Fig. 11"], 1),
        Control::slider("interval", "print interval", "ms", [0.1, 3.0], 0.1, 0.5).with_typed_range([0.01, 200.0]),
        Control::slider("phase", "first line after", "intervals", [0.0, 0.95], 0.05, 0.0)
            .with_typed_range([0.0, 0.999]),
        Control::choice("late", "sign of friction", &["at once, as in the mechanism", "late, as in the program"], 1),
    ],
    presets: &[
        Preset::new("the mechanisms as they are", "own=1&six=1&late=0&phase=0"),
        Preset::new("reset after 90°", "reset=90&own=0&six=1&late=0&phase=0"),
        Preset::new("the program as listed", "reset=90&own=0&six=1&interval=0.5&late=1&phase=0"),
    ],
    given: &["rows", "inertias", "headed", "duration", "delay", "pi"],
    quantities: &[
        LiveQuantity::new("agree", "numbers within one unit of the printed ones"),
        LiveQuantity::new("six-pins", "with six pins"),
        LiveQuantity::new("four-pins", "with four pins"),
        LiveQuantity::new("three-pins", "with three pins"),
        LiveQuantity::new("normal", "ln L, normal errors"),
        LiveQuantity::new("exponential", "ln L, exponential errors"),
    ],
    others: &[],
    drag: None,
    files: &[],
    turned: None,
    tolerances: None,
    beat: None,
    draw,
};

fn draw(settings: &Settings) -> Result<LiveReply, String> {
    let rows = rows(settings)?;
    let hypothesis = hypothesis(settings)?;
    let (results, done) = match hypothesis.lag {
        Lag::None => (results(&rows, &hypothesis), rows.len()),
        _ => by_program(&settings.arguments().to_query(), &rows, &hypothesis),
    };
    let angle = match hypothesis.reset {
        Reset::After(angle) => format!("reset after {}°", plain(angle.to_degrees())),
        _ => "own reset angles".to_owned(),
    };
    let name = if hypothesis.lag == Lag::None { angle } else { format!("{angle}, sign late") };
    let score = Score::from_results(hypothesis, &rows, results);
    let figure = one_agreement(LIVE.figure, &ComparedCells::new(name, &score), "1 rad/s or 1 ms");
    let counted = |name, mechanisms: &[Mechanism]| {
        let count = score.within_one_of(mechanisms);
        let all = score.cells().filter(|cell| mechanisms.contains(&cell.mechanism)).count();
        LiveNumber { name, value: count as f64, text: format!("{count} of {all}") }
    };
    let mut numbers = vec![
        counted("agree", &Mechanism::ALL),
        counted("six-pins", &[Mechanism::SIX_PIN]),
        counted("four-pins", &[Mechanism::FOUR_PIN]),
        counted("three-pins", &[Mechanism::THREE_PIN]),
    ];
    let progress = (done < rows.len()).then_some(Progress { parts: "runs", done, all: rows.len() });
    if progress.is_none() {
        for (name, log) in ["normal", "exponential"].into_iter().zip(score.likelihoods()) {
            let number = LiveNumber::new(name, log, 1, "");
            let text = if log.is_finite() { number.text } else { "impossible".to_owned() };
            numbers.push(LiveNumber { text, ..number });
        }
    }
    Ok(LiveReply { progress, ..LiveReply::new(figure, numbers) })
}

/// A number without needless zeros.
fn plain(value: f64) -> String {
    format!("{}", (value * 1000.0).round() / 1000.0)
}

/// The rows that came with the page, with what the page and the settings give for their runs.
///
/// A row is `slots,friction,torque,peak,minimum,rise,period`, as printed, in in lb, rad/s and s; rows have `;` between them.
/// The inertias of driver and follower stand by slots, `3,1e-6,2e-5;…`, and `headed` has the other pair of the six pins.
fn rows(settings: &Settings) -> Result<Vec<Row>, String> {
    let given = settings.arguments();
    let inertias = |name: &'static str| -> Result<Vec<Vec<f64>>, String> {
        let line = |line: &str| line.split(',').map(|text| number(name, text)).collect();
        given.required(name)?.split(';').map(line).collect()
    };
    let (drawn, headed) = (inertias("inertias")?, inertias("headed")?);
    let listing = listing(settings)?;
    let row = |line: &str| -> Result<Row, String> {
        let (slots, cells) = line.split_once(',').unwrap_or((line, ""));
        let slots = number("rows", slots)?;
        let mechanism = Mechanism::new(slots as u32).map_err(|error| error.to_string())?;
        let of = |pairs: &[Vec<f64>]| match pairs.iter().find(|own| own.first() == Some(&slots)).map(Vec::as_slice) {
            Some([_, driver, follower]) => Some([*driver, *follower]),
            _ => None,
        };
        let drawn = of(&drawn).ok_or_else(|| format!("inertias: none for {slots} slots"))?;
        let given = Given { headed: of(&headed).unwrap_or(drawn), drawn, listing };
        let row = Row::read(mechanism, cells, given).map_err(|error| error.to_string())?;
        let words = |error: geneva_dynamics::DynamicsError| error.to_string();
        for [driver, follower] in [given.headed, given.drawn] {
            let inertias = Inertias::new(driver, follower).map_err(words)?;
            Parameters::new(mechanism, inertias, row.torque(), row.friction()).map_err(words)?;
        }
        Ok(row)
    };
    given.required("rows")?.split(';').map(row).collect()
}

/// What is set of the program, and what the page gives of it.
fn listing(settings: &Settings) -> Result<Listing, String> {
    let given = settings.arguments();
    let (interval, phase) = (settings.value("interval")? / 1000.0, settings.value("phase")?);
    let duration = given.required_number("duration")?;
    if !(interval >= 1e-5 && interval <= duration) {
        return Err(format!("interval {} ms: give 0.01 to {} ms", 1000.0 * interval, 1000.0 * duration));
    }
    if !(0.0..1.0).contains(&phase) {
        return Err(format!("phase {phase}: give a part of the print interval, from 0 to below 1"));
    }
    if phase != 0.0 && settings.choice("late")? == 1 {
        return Err(
            "the program prints from the start on: set the first line to 0, or the sign of friction to “at once”"
                .to_owned(),
        );
    }
    let reset = settings.value("reset")?.to_radians();
    let (pi, delay) = (given.required_number("pi")?, given.required_number("delay")?);
    Ok(Listing { reset, pi, first_line: phase * interval, interval, duration, delay })
}

fn hypothesis(settings: &Settings) -> Result<Hypothesis, String> {
    let reset = settings.value("reset")?;
    if !(30.0..=170.0).contains(&reset) {
        return Err(format!("reset {reset}°: give an angle from 30° to 170°"));
    }
    // A mechanism has its true peak; a print-out has the largest line.
    let (reset, reading) = match settings.choice("own")? {
        0 => (Reset::After(reset.to_radians()), PeakReading::OnTheGrid),
        _ => (Reset::OfTheMechanism, PeakReading::True),
    };
    let six_pin = if settings.choice("six")? == 0 { SixPin::AsHeaded } else { SixPin::AsDrawn };
    let (constants, lag) = match settings.choice("late")? {
        0 => (Constants::Exact, Lag::None),
        _ => (Constants::AsListed, Lag::AsListed),
    };
    Ok(Hypothesis { reset, six_pin, reading, constants, lag })
}

/// What a run gives, or none if it does not recur: peak, minimum and period.
type Results = Vec<Option<[f64; 3]>>;

fn results(rows: &[Row], hypothesis: &Hypothesis) -> Results {
    rows.iter().map(|row| hypothesis.results(row)).collect()
}

/// Of the last setting that was asked for: its results, and how many of them are by the program.
type Made = (String, Results, usize);

thread_local! {
    static MADE: RefCell<Made> = const { RefCell::new((String::new(), Vec::new(), 0)) };
}

/// What is read off the print-outs of the program, and for how many rows: at each asking some more. Until a row is run by
/// the program, it has the result with the sign at once, which is almost the same and takes no time.
fn by_program(key: &str, rows: &[Row], hypothesis: &Hypothesis) -> (Results, usize) {
    MADE.with_borrow_mut(|(of, made, done)| {
        if of != key {
            let at_once = Hypothesis { constants: Constants::Exact, lag: Lag::None, ..*hypothesis };
            (*of, *made, *done) = (key.to_owned(), results(rows, &at_once), 0);
        }
        for (row, result) in rows.iter().zip(made.iter_mut()).skip(*done).take(AT_ONCE) {
            *result = hypothesis.results(row);
            *done += 1;
        }
        (made.clone(), *done)
    })
}
