//! The runs of 1973 with the program set otherwise: printed numbers against computed ones.

use crate::answer::{Answer, Number, Progress};
use crate::arguments::number;
use crate::control::{Control, Live, Preset, Quantity, Settings};
use geneva_dynamics::likelihood::Law;
use geneva_dynamics::program::{Contact, Program, Readings};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_figures::runs::{Cell, Compared, one_agreement};
use geneva_kinematics::Mechanism;
use geneva_mimic::AtSmallestStep;
use std::cell::RefCell;

/// Relative error of the motion.
const TOLERANCE: f64 = 1e-10;
/// Runs of the program on its integrator that are made at one asking.
const AT_ONCE: usize = 2;

pub const LIVE: Live = Live {
    name: "mistake",
    figure: "live-mistake",
    hint: "Move the reset angle away from 90°: the dots leave the line, three pins to one side, six to the other. Only at \
           90° do nearly all dots of four pins stay on it. Then let the program choose the sign of friction late, as it did.",
    controls: &[
        Control::slider("reset", "angle after which the program starts again", "°", [60.0, 120.0], 0.5, 90.0)
            .typed([30.0, 170.0])
            .playing(6.0),
        Control::choice("own", "for", &["all three mechanisms", "none: each its own angle"], 0),
        Control::choice("six", "inertias with six pins", &["as in the table", "as in Fig. 11"], 1),
        Control::slider("interval", "print interval", "ms", [0.1, 3.0], 0.1, 0.5).typed([0.01, 200.0]),
        Control::slider("phase", "first line after", "intervals", [0.0, 0.95], 0.05, 0.0).typed([0.0, 0.999]),
        Control::choice("late", "sign of friction", &["at once, as in the mechanism", "late, as in the program"], 0),
    ],
    presets: &[
        Preset { name: "the mechanisms as they are", arguments: "own=1&late=0&phase=0" },
        Preset { name: "reset after 90°", arguments: "reset=90&own=0&six=1&late=0&phase=0" },
        Preset { name: "the program as listed", arguments: "reset=90&own=0&six=1&late=1&phase=0" },
    ],
    given: &["rows", "inertias", "headed", "units", "duration", "delay", "pi"],
    quantities: &[
        Quantity { name: "agree", label: "numbers within one unit of the printed ones" },
        Quantity { name: "six-pins", label: "of six pins" },
        Quantity { name: "four-pins", label: "of four pins" },
        Quantity { name: "three-pins", label: "of three pins" },
        Quantity { name: "normal", label: "ln L, normal errors" },
        Quantity { name: "exponential", label: "ln L, exponential errors" },
    ],
    others: &[],
    drag: None,
    files: &[],
    draw,
};

/// A row of the tables: the escapement of a run, and its printed peak, minimum and period, each in units of its last place.
struct Row {
    parameters: Parameters,
    printed: [f64; 3],
}

/// How the runs are made.
struct Setting {
    /// The reset angle in radians; none for each mechanism's own.
    reset: Option<f64>,
    /// Print interval, time of the first line, and duration, in s.
    grid: [f64; 3],
    /// By how much the sign is late, in s, and the π of the program.
    late: Option<(f64, f64)>,
}

fn draw(settings: &Settings) -> Result<Answer, String> {
    let (rows, units) = rows(settings)?;
    let setting = setting(settings)?;
    let key = settings.arguments().to_query();
    let (computed, done) = match setting.late {
        None => (rows.iter().map(|row| exactly(row, &setting)).collect(), rows.len()),
        Some(late) => by_program(&key, &rows, &setting, late),
    };
    let mut cells = Vec::new();
    for (row, computed) in rows.iter().zip(&computed) {
        for (k, printed) in row.printed.iter().enumerate() {
            let computed = computed.map_or(f64::NAN, |of: [f64; 3]| of[k] / units[k]);
            cells.push(Cell { mechanism: row.parameters.mechanism(), printed: *printed, computed });
        }
    }
    let angle = match setting.reset {
        Some(reset) => format!("reset after {}°", plain(reset.to_degrees())),
        None => "own reset angles".to_owned(),
    };
    let name = if setting.late.is_some() { format!("{angle}, sign late") } else { angle };
    let figure = one_agreement(&Compared { name, cells: cells.clone() }, "1 rad/s or 1 ms");
    let count =
        |of: &dyn Fn(&Cell) -> bool| cells.iter().filter(|cell| of(cell) && cell.is_within_one()).count() as f64;
    let of_pins = |mechanism: Mechanism| count(&|cell: &Cell| cell.mechanism == mechanism);
    let all_of = |mechanism| cells.iter().filter(|cell| cell.mechanism == mechanism).count();
    let counted = |name, number: f64, all: usize| Number { name, value: number, text: format!("{number} of {all}") };
    let likelihood = |law: Law| -> f64 {
        let column = |k: usize| {
            let off: Vec<f64> =
                cells.iter().skip(k).step_by(3).map(|cell| (cell.computed - cell.printed).abs()).collect();
            if off.iter().all(|off| off.is_finite()) { law.of(&off).log } else { f64::NEG_INFINITY }
        };
        (0..3).map(column).sum()
    };
    let mut numbers = vec![counted("agree", count(&|_| true), cells.len())];
    for (name, mechanism) in
        [("six-pins", Mechanism::SIX_PIN), ("four-pins", Mechanism::FOUR_PIN), ("three-pins", Mechanism::THREE_PIN)]
    {
        numbers.push(counted(name, of_pins(mechanism), all_of(mechanism)));
    }
    let progress = (done < rows.len()).then_some(Progress { done, all: rows.len() });
    if progress.is_none() {
        for (name, law) in [("normal", Law::Normal), ("exponential", Law::Exponential)] {
            let log = likelihood(law);
            let text = if log.is_finite() { None } else { Some("impossible".to_owned()) };
            let number = Number::new(name, log, 1, "");
            numbers.push(Number { text: text.unwrap_or(number.text.clone()), ..number });
        }
    }
    Ok(Answer { progress, ..Answer::new(figure, numbers) })
}

/// A number without needless zeros.
fn plain(value: f64) -> String {
    format!("{}", (value * 1000.0).round() / 1000.0)
}

/// The rows that came with the page, and the units of the three columns.
///
/// A row is `slots,friction,torque,peak,minimum,period`, as printed, in in lb, rad/s and s; rows have `;` between them. The
/// inertias of driver and follower stand by slots, `3,1e-6,2e-5;…`; `headed` has the other pair of the six pins, and `units`
/// the units of the last printed places of peak, minimum and period.
fn rows(settings: &Settings) -> Result<(Vec<Row>, [f64; 3]), String> {
    let given = settings.arguments();
    let six_as_headed = settings.choice("six")? == 0;
    let list = |name: &'static str| -> Result<Vec<Vec<f64>>, String> {
        let line = |line: &str| line.split(',').map(|text| number(name, text)).collect();
        given.given(name)?.split(';').map(line).collect()
    };
    let mut inertias = list("inertias")?;
    if six_as_headed {
        inertias.splice(0..0, list("headed")?);
    }
    let [units] = &list("units")?[..] else { return Err("units: give one of each column".to_owned()) };
    let units: [f64; 3] = units[..].try_into().map_err(|_| "units: give one of each column".to_owned())?;
    let row = |cells: &Vec<f64>| -> Result<Row, String> {
        let [slots, friction, torque, peak, minimum, period] = cells[..] else {
            return Err("rows: each has slots, friction, torque, peak, minimum and period".to_owned());
        };
        let mechanism = Mechanism::new(slots as u32).map_err(|error| error.to_string())?;
        let own = inertias.iter().find(|own| own.first() == Some(&slots));
        let Some([_, driver, follower]) = own.map(Vec::as_slice) else {
            return Err(format!("inertias: none for {slots} slots"));
        };
        let words = |error: geneva_dynamics::Error| error.to_string();
        let inertias = Inertias::new(*driver, *follower).map_err(words)?;
        let parameters = Parameters::new(mechanism, inertias, torque, friction).map_err(words)?;
        Ok(Row { parameters, printed: [peak / units[0], minimum / units[1], period / units[2]] })
    };
    Ok((list("rows")?.iter().map(row).collect::<Result<_, _>>()?, units))
}

fn setting(settings: &Settings) -> Result<Setting, String> {
    let given = settings.arguments();
    let reset = settings.value("reset")?;
    if !(30.0..=170.0).contains(&reset) {
        return Err(format!("reset {reset}°: give an angle from 30° to 170°"));
    }
    let (interval, phase) = (settings.value("interval")? / 1000.0, settings.value("phase")?);
    let duration = given.given_number("duration")?;
    if !(interval >= 1e-5 && interval <= duration) {
        return Err(format!("interval {} ms: give 0.01 to {} ms", 1000.0 * interval, 1000.0 * duration));
    }
    if !(0.0..1.0).contains(&phase) {
        return Err(format!("phase {phase}: give a part of the print interval, from 0 to below 1"));
    }
    let late = settings.choice("late")? == 1;
    if late && phase != 0.0 {
        return Err("the program prints from the start on: set the first line to 0".to_owned());
    }
    let late = if late { Some((given.given_number("delay")?, given.given_number("pi")?)) } else { None };
    let reset = (settings.choice("own")? == 0).then_some(reset.to_radians());
    Ok(Setting { reset, grid: [interval, phase * interval, duration], late })
}

/// Peak as printed, minimum and period of the steady motion; nothing where there is none.
fn exactly(row: &Row, setting: &Setting) -> Option<[f64; 3]> {
    let own = 2.0 * row.parameters.mechanism().engagement_half_angle();
    let engagement = Engagement::reset_after(&row.parameters, setting.reset.unwrap_or(own), TOLERANCE).ok()?;
    let steady = engagement.steady_state().ok()?;
    let [interval, first, duration] = setting.grid;
    // A mechanism has its true peak; a print-out has the largest line.
    let peak = match setting.reset {
        None => steady.peak.speed,
        Some(_) => engagement.largest_printed(interval, first, duration).ok()?,
    };
    Some([peak, steady.minimum.speed, steady.period])
}

/// The runs that have been made, of the last setting that was asked for.
type Made = (String, Vec<Option<[f64; 3]>>);

thread_local! {
    static MADE: RefCell<Made> = const { RefCell::new((String::new(), Vec::new())) };
}

/// What is read off the print-outs of the program, as far as they have been made: at each asking some more.
fn by_program(key: &str, rows: &[Row], setting: &Setting, late: (f64, f64)) -> (Vec<Option<[f64; 3]>>, usize) {
    MADE.with_borrow_mut(|(of, made)| {
        if of != key {
            (*of, *made) = (key.to_owned(), Vec::new());
        }
        for row in rows.iter().skip(made.len()).take(AT_ONCE) {
            made.push(run(row, setting, late));
        }
        let mut computed = made.clone();
        computed.resize(rows.len(), None);
        (computed, made.len())
    })
}

/// One run of the program as it is listed, but for the reset angle and the print interval.
fn run(row: &Row, setting: &Setting, (delay, pi): (f64, f64)) -> Option<[f64; 3]> {
    let exact = Program::of(&row.parameters);
    let slots = row.parameters.mechanism().slots();
    let program = Program {
        reset: setting.reset.unwrap_or(exact.reset),
        ratio: 1.0 / libm::sin(pi / f64::from(slots)),
        contact: Contact::Delayed(delay),
        ..exact
    };
    let [interval, _, duration] = setting.grid;
    let integrator = geneva_mimic::Parameters {
        at_smallest_step: AtSmallestStep::Continue,
        ..geneva_mimic::Parameters::new(interval, duration)
    };
    let Readings { peak, minimum, period, .. } = Readings::of(&program.run(&integrator).ok()?, program.reset)?;
    Some([peak, minimum, period])
}
