//! Compares the decks of this project with the same equations in Rust, to the last bit, and with other integrators.

use super::own;
use geneva_mimic::language::{CardLayout, DECKS, Deck, DeckRun, Program, RunOptions};
use geneva_mimic::{Extrapolation, Interpolation, MinStepPolicy, SolverParameters, System, integrate};
use nalgebra::{SVector, Vector1, Vector2};
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dopri5, System as OtherSystem};

/// The integrator as the language uses it.
fn like(print_interval: f64, run_length: f64) -> SolverParameters {
    SolverParameters { at_smallest_step: MinStepPolicy::Continue, ..SolverParameters::new(print_interval, run_length) }
}

#[track_caller]
fn run(name: &str, numbers: &[f64]) -> DeckRun {
    let (program, set) = own(name, numbers);
    program.run(&set, &RunOptions::default()).unwrap_or_else(|trouble| panic!("{trouble}"))
}

/// That printed columns are those of a native run, to the last bit.
#[track_caller]
fn same<const D: usize, S: System<D>>(
    printed: &DeckRun,
    mut system: S,
    start: SVector<f64, D>,
    parameters: &SolverParameters,
    columns: impl Fn(&SVector<f64, D>) -> Vec<f64>,
) {
    let mut rows = Vec::new();
    let outcome = integrate(&mut system, start, parameters, |point| {
        rows.push([vec![point.time], columns(&point.state)].concat());
    });
    let work = outcome.unwrap_or_else(|_| panic!("a native run")).work;
    assert_eq!(printed.work, work);
    let bits = |rows: &[Vec<f64>]| -> Vec<Vec<u64>> {
        rows.iter().map(|row| row.iter().map(|value| value.to_bits()).collect()).collect()
    };
    assert_eq!(bits(&printed.rows), bits(&rows));
}

#[test]
fn the_oscillator_is_that_of_rust_to_the_last_bit_and_the_closed_form() {
    let [m, c, k, v0, x0] = [2.0, 0.4, 8.0, 0.25, 1.0];
    let printed = run("oscillator", &[m, c, k, v0, x0]);
    let rate = |_: f64, state: &Vector2<f64>| Vector2::new(-(c * state[0] + k * state[1]) / m, state[0]);
    same(&printed, rate, Vector2::new(v0, x0), &like(0.1, 10.0), |state| vec![state[1], state[0]]);
    let (decay, frequency) = (c / (2.0 * m), (k / m - c * c / (4.0 * m * m)).sqrt());
    for row in &printed.rows {
        let swing = x0 * libm::cos(frequency * row[0]) + (v0 + decay * x0) / frequency * libm::sin(frequency * row[0]);
        assert!((row[1] - libm::exp(-decay * row[0]) * swing).abs() < 2e-5, "{row:?}");
    }
}

#[test]
fn the_misprinted_oscillator_is_of_first_order_and_only_decays() {
    let printed = run("misprinted", &[2.0, 0.4, 8.0, 1.0]);
    let rate = |_: f64, state: &Vector1<f64>| Vector1::new(-8.0 * state[0] / (2.0 + 0.4));
    same(&printed, rate, Vector1::new(1.0), &like(0.1, 10.0), |state| vec![state[0], -8.0 * state[0] / (2.0 + 0.4)]);
    assert!(printed.rows.windows(2).all(|pair| pair[1][1] < pair[0][1]));
}

#[test]
fn what_decays_has_halved_as_often_as_half_lives_have_passed() {
    let printed = run("decay", &[1000.0, 3.0]);
    assert_eq!(printed.rows.last().map(|row| row[0]), Some(15.0));
    for row in &printed.rows {
        assert!((row[2] - row[0] / 3.0).abs() < 1e-5, "{row:?}");
        assert!((row[1] / (1000.0 * libm::exp2(-row[0] / 3.0)) - 1.0).abs() < 1e-5, "{row:?}");
    }
}

#[test]
fn predators_and_prey_conserve_what_they_must() {
    let printed = run("predators", &[0.5, 2.0, 1.0]);
    let rate =
        |_: f64, state: &Vector2<f64>| Vector2::new(state[0] * (1.0 - state[1]), 0.5 * state[1] * (state[0] - 1.0));
    same(&printed, rate, Vector2::new(2.0, 1.0), &like(0.1, 15.0), |state| {
        let conserved = 0.5 * (state[0] - libm::log(state[0])) + state[1] - libm::log(state[1]);
        vec![state[0], state[1], conserved]
    });
    let first = printed.rows[0][3];
    assert!(printed.rows.iter().all(|row| (row[3] - first).abs() < 1e-5));
    agrees(&printed, Vector2::new(2.0, 1.0), 15.0, rate, [1, 2]);
}

#[test]
fn van_der_pol_s_oscillator_is_that_of_another_integrator() {
    for mu in [0.2, 5.0] {
        let printed = run("vanderpol", &[mu]);
        let rate = move |_: f64, state: &Vector2<f64>| {
            Vector2::new(mu * (1.0 - state[1] * state[1]) * state[0] - state[1], state[0])
        };
        same(&printed, rate, Vector2::new(0.0, 0.5), &like(0.1, 30.0), |state| vec![state[1], state[0]]);
        agrees(&printed, Vector2::new(0.0, 0.5), 30.0, rate, [2, 1]);
    }
}

/// A right-hand side that does not use the time.
struct Other<F>(F);

impl<F: Fn(f64, &Vector2<f64>) -> Vector2<f64>> OtherSystem<f64, Vector2<f64>> for Other<F> {
    fn system(&self, time: f64, state: &Vector2<f64>, rate: &mut Vector2<f64>) {
        *rate = self.0(time, state);
    }
}

/// That the last printed row agrees with a Dormand-Prince method at a sharper tolerance.
#[track_caller]
fn agrees(
    printed: &DeckRun,
    start: Vector2<f64>,
    end: f64,
    rate: impl Fn(f64, &Vector2<f64>) -> Vector2<f64>,
    columns: [usize; 2],
) {
    let mut other = Dopri5::from_param(
        Other(rate),
        0.0,
        end,
        end,
        start,
        1e-11,
        1e-11,
        0.9,
        0.04,
        0.2,
        10.0,
        end,
        0.0,
        1_000_000,
        1000,
        OutputType::Sparse,
    );
    other.integrate().expect("a smooth problem");
    let last = other.y_out().last().expect("an end");
    let row = printed.rows.last().expect("a row");
    for (component, column) in columns.into_iter().enumerate() {
        assert!((row[column] - last[component]).abs() < 1e-3, "{row:?} {last}");
    }
}

/// x″ = −x(t − late), with x = 1 before.
struct Delayed {
    line: geneva_mimic::DelayLine<16_384>,
}

impl System<2> for Delayed {
    type Fault = geneva_mimic::DelayError;

    fn derivative(&mut self, time: f64, state: &Vector2<f64>) -> Result<Vector2<f64>, Self::Fault> {
        Ok(Vector2::new(-(self.line.value(time)? + 1.0), state[0]))
    }

    fn accepted(&mut self, time: f64, state: &Vector2<f64>, _: &Vector2<f64>) -> Result<(), Self::Fault> {
        self.line.record(time, state[1] - 1.0)
    }
}

#[test]
fn the_delayed_oscillator_is_that_of_rust_and_its_swing_grows_as_it_must() {
    for late in [0.05, 0.1] {
        let printed = run("delayed", &[late]);
        let line = geneva_mimic::DelayLine::new(late, 0.0, Interpolation::Linear, Extrapolation::Hold);
        let system = Delayed { line: line.expect("a line") };
        let parameters = SolverParameters { largest_step: 0.01, initial_step: 0.01, ..like(0.1, 20.0) };
        same(&printed, system, Vector2::new(0.0, 1.0), &parameters, |state| vec![state[1], state[0]]);
        // s² = −e^(−s late) by Newton's steps from i: the real part is the growth.
        let [mut re, mut im] = [0.0_f64, 1.0_f64];
        for _ in 0..50 {
            let size = libm::exp(-re * late);
            let [er, ei] = [size * libm::cos(im * late), -size * libm::sin(im * late)];
            let [fr, fi] = [re * re - im * im + er, 2.0 * re * im + ei];
            let [dr, di] = [2.0 * re - late * er, 2.0 * im - late * ei];
            let norm = dr * dr + di * di;
            (re, im) = (re - (fr * dr + fi * di) / norm, im - (fi * dr - fr * di) / norm);
        }
        // The swing's square, half a turn apart in time, where the slower parts have died away.
        let swing = |row: &Vec<f64>| row[1] * row[1] + row[2] * row[2];
        let most = |range: std::ops::Range<usize>| printed.rows[range].iter().map(swing).fold(0.0, f64::max);
        let turn = std::f64::consts::TAU / im;
        let growth = libm::log(most(137..200) / most(137 - 63..200 - 63)) / (2.0 * turn);
        assert!((growth / re - 1.0).abs() < 0.05, "{late}: {growth} {re}");
    }
}

#[test]
fn a_switch_that_bounces_holds_the_room_where_it_switches() {
    for lag in [0.5, 0.1] {
        let printed = run("switch", &[20.0, 4.0, lag]);
        // Heated from 10° with 4, losing a fifth of the difference: 20° is reached at −5 log(1 − 10/20), and later felt.
        let warm = printed.rows.iter().find(|row| row[2] == 0.0).expect("off at last");
        assert!(warm[0] > 3.4 && warm[0] < 5.0, "{warm:?}");
        for row in printed.rows.iter().filter(|row| row[0] > 15.0) {
            assert!((row[1] - 20.0).abs() < 0.6 * lag && [0.0, 1.0].contains(&row[2]), "{row:?}");
        }
    }
}

#[test]
fn every_deck_runs_with_the_data_behind_it_and_keeps_to_its_columns() {
    for (name, text) in DECKS {
        assert_eq!(CardLayout::detect(text), CardLayout::Columns, "{name}");
        assert!(text.lines().all(|line| line.len() <= 80), "{name}: a card has eighty columns");
        for layout in [CardLayout::Columns, CardLayout::Free] {
            let deck = Deck::read(text, layout).unwrap_or_else(|faults| panic!("{name}: {faults}"));
            assert!(deck.notes().is_empty(), "{name}: {:?}", deck.notes());
            let program = Program::new(&deck).unwrap_or_else(|faults| panic!("{name}: {faults}"));
            let sets = deck.data_sets().unwrap_or_else(|faults| panic!("{name}: {faults}"));
            let runs = program.runs(&sets, &RunOptions::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert!(runs.iter().all(|run| run.rows.len() > 20 && run.work.forced == 0), "{name}");
        }
    }
}
