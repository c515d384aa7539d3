//! Running a program, once for each set of data.

use super::code::execute;
use super::data::DataSet;
use super::digits::eight_digits;
use super::machine::{Machine, RecordedDelay, Stop};
use super::program::{Delay, FIRST_STEP, PlotCode, Program};
use super::trouble::{RunError, Trouble};
use crate::{Cause, DelayLine, Extrapolation, IntegrationError, Interpolation, SolverParameters, SolverStats};
use core::cell::Cell;
use nalgebra::SVector;

/// Most printed rows of a run.
const MOST_ROWS: f64 = 1e6;
/// Most steps of a run, counted once for each integral and each delay.
const MOST_WORK: u64 = 100_000_000;
/// Most steps of all runs of a deck, counted in the same way.
const MOST_WORK_OF_ALL: u64 = 300_000_000;
/// Most numbers that all runs of a deck print: they are held in memory, and so is the text that they make, some sixty
/// megabytes.
const MOST_NUMBERS: u64 = 3_000_000;
/// How many rows the names of a run's columns count for: each run holds its own.
const NAMES_AS_ROWS: usize = 8;
/// Most values that all delays of a run have room for: eighty megabytes, and as much again for a moment when one grows.
const MOST_REMEMBERED: usize = 5_000_000;
/// Most integrals of a program, and most delays.
const MOST_STATES: usize = 1024;
const MOST_DELAYS: usize = 256;

/// Which values a delay keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RememberedPoints {
    /// The values of all kept points, whatever the third argument of `TDL` says.
    All,
    /// As many, equally far apart in the delay, as the third argument says.
    AsAsked,
}

/// Choices that the two decks and their texts leave open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunOptions {
    /// Parameters of the integrator. Its print interval is DT where no DT card is; its run length and its least, greatest and
    /// first step are not used, because FIN, DTMIN and DTMAX give them.
    ///
    /// Default: that of [`SolverParameters`], but a step that cannot be made smaller is kept, and counted: a deck may have
    /// switches, and to pass one within the tolerance may take a step shorter than any.
    pub integrator: SolverParameters,
    /// How a delay reads between the values that it keeps. Default: linearly.
    pub interpolation: Interpolation,
    /// How a delay reads behind its latest value, where a step is longer than the delay. Default: it holds the latest.
    pub extrapolation: Extrapolation,
    /// Which values a delay keeps. Default: all.
    pub remembered: RememberedPoints,
    /// How many runs are made at the same time and share the memory for printed rows and for delays. Default: 1. A run
    /// that has too little of it is refused, and may succeed by itself; the numbers of a run that succeeds do not depend
    /// on it.
    pub at_once: usize,
}

impl Default for RunOptions {
    fn default() -> Self {
        let at_smallest_step = crate::MinStepPolicy::Continue;
        Self {
            integrator: SolverParameters { at_smallest_step, ..SolverParameters::new(0.1, 0.1) },
            interpolation: Interpolation::Linear,
            extrapolation: Extrapolation::Hold,
            remembered: RememberedPoints::All,
            at_once: 1,
        }
    }
}

/// Plot of one run.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// What is plotted against what: X, then the others.
    pub names: Vec<String>,
    /// Of each, the change from line to line or from column to column, in its own unit; none to choose it.
    pub scale: Option<Vec<f64>>,
    /// Of each, the value on the first line or in the first column, in its own unit; none to choose it.
    pub zero: Option<Vec<f64>>,
}

/// Printed result of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct DeckRun {
    /// The names of CON and PAR with their numbers, each in its own unit.
    pub parameters: Vec<(String, f64)>,
    /// The words of each HDR card.
    pub headings: Vec<Vec<String>>,
    /// Number of columns of each OUT card.
    pub widths: Vec<usize>,
    /// The names of all OUT cards.
    pub columns: Vec<String>,
    /// Their values, a row for each printed point, each in its own unit.
    pub rows: Vec<Vec<f64>>,
    /// The plots, and the values of their names at each printed point, each in its own unit.
    pub plots: Vec<(Plot, Vec<Vec<f64>>)>,
    /// Steps and evaluations.
    pub work: SolverStats,
    /// Kept steps that were longer than the delay of a TDL: it then gave its latest value, less long ago than it says.
    pub longer_than_delay: u64,
}

/// The runs of a deck one after another, and what they come to together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DeckRuns {
    runs: Vec<DeckRun>,
    numbers: u64,
    work: u64,
}

impl DeckRuns {
    /// Adds the next run of a program, whether it was made or not.
    ///
    /// # Errors
    ///
    /// Its [`Trouble`], or [`Trouble::TooMuch`] if with it all runs print more numbers or take more steps than can be;
    /// with its number, counted from 1. A single run has its own bounds.
    pub fn add(&mut self, program: &Program, run: Result<DeckRun, Trouble>) -> Result<(), RunError> {
        let number = self.runs.len() + 1;
        let refused = |trouble| RunError { number, trouble };
        let run = run.map_err(refused)?;
        self.numbers += ((run.rows.len() + NAMES_AS_ROWS) * program.numbers_in_a_row()) as u64;
        self.work += (run.work.accepted + run.work.rejected) * program.parts_of_a_step();
        for (asked, most, what, way_out) in [
            (
                self.numbers,
                MOST_NUMBERS,
                "numbers to print, with the headings counted as 8 rows",
                "a longer DT, fewer names on OUT and PLO cards",
            ),
            (self.work, MOST_WORK_OF_ALL, "steps of integrals and delays", "a larger tolerance"),
        ] {
            if number > 1 && asked > most {
                return Err(refused(Trouble::TooMuch { runs: number, what, asked, most, way_out }));
            }
        }
        self.runs.push(run);
        Ok(())
    }

    /// All runs that were added.
    pub fn into_inner(self) -> Vec<DeckRun> {
        self.runs
    }
}

impl Program {
    /// Runs the program once for each set.
    ///
    /// # Errors
    ///
    /// The first [`Trouble`], with the number of its set.
    pub fn runs(&self, sets: &[DataSet], choices: &RunOptions) -> Result<Vec<DeckRun>, RunError> {
        let mut runs = DeckRuns::default();
        for set in sets {
            runs.add(self, self.run(set, choices))?;
        }
        Ok(runs.into_inner())
    }

    /// How many numbers a printed point has, and the parameters, which a table of all runs has beside them.
    fn numbers_in_a_row(&self) -> usize {
        let plotted: usize = self.plots.iter().map(|plot| plot.names.len()).sum();
        self.outputs.iter().map(Vec::len).sum::<usize>() + plotted + self.parameters.len()
    }

    /// Most printed rows of a run that is one of so many at a time.
    fn most_rows(&self, at_once: usize) -> f64 {
        let each = (self.numbers_in_a_row() * at_once).max(1) as u64;
        ((MOST_NUMBERS / each).max(1) as f64).min(MOST_ROWS)
    }

    /// How much a step costs: its integrals and its delays.
    fn parts_of_a_step(&self) -> u64 {
        (self.states.len() + self.delays.len()).max(1) as u64
    }

    /// Runs the program with one set of numbers.
    ///
    /// # Errors
    ///
    /// [`Trouble`] for numbers that are missing or out of their range, and for whatever stops the run.
    pub fn run(&self, set: &DataSet, choices: &RunOptions) -> Result<DeckRun, Trouble> {
        if self.delays.len() > MOST_DELAYS {
            return Err(Trouble::TooMany { what: "delays", asked: self.delays.len(), most: MOST_DELAYS });
        }
        // The states are filled up with zeros that stand still, to one of three sizes: they change no number. Each size is
        // compiled by itself, which takes seconds.
        match self.states.len() {
            0..=4 => self.run_in::<4>(set, choices),
            5..=64 => self.run_in::<64>(set, choices),
            65..=MOST_STATES => self.run_in::<MOST_STATES>(set, choices),
            asked => Err(Trouble::TooMany { what: "integrals", asked, most: MOST_STATES }),
        }
    }

    fn run_in<const D: usize>(&self, set: &DataSet, choices: &RunOptions) -> Result<DeckRun, Trouble> {
        let mut registers = self.initial_registers(set, choices)?;
        let (parameters, has_end) = self.integrator(&registers, choices)?;
        let watched: Vec<u32> = self
            .outputs
            .iter()
            .flatten()
            .chain(self.plots.iter().flat_map(|plot| &plot.names))
            .map(|(_, register)| *register)
            .collect();
        let latest: Vec<Cell<f64>> = watched.iter().map(|_| Cell::new(0.0)).collect();
        let latest_time = Cell::new(0.0);
        let start: SVector<f64, D> =
            SVector::from_fn(|at, _| self.states.get(at).map_or(0.0, |state| registers[state.register as usize]));
        for slope in &self.slopes {
            for (before, now) in slope.before.iter().zip(slope.now) {
                registers[*before as usize] = registers[now as usize];
            }
        }
        let held = self.held.iter().map(|register| registers[*register as usize]).collect();
        let mut machine = Machine {
            program: self,
            lines: self.lines(&registers, choices)?,
            room: MOST_REMEMBERED / choices.at_once.max(1),
            registers,
            held,
            kept: (0.0, Vec::new()),
            nearest: parameters.switch_step(),
            closed: Vec::new(),
            changes: 0,
            changed: None,
            longer_than_delay: 0,
            watched,
            latest: &latest,
            latest_time: &latest_time,
            has_end,
            odd: None,
        };
        let values = || -> Vec<f64> { latest.iter().map(Cell::get).collect() };
        let (mut rows, mut last_time) = (Vec::new(), 0.0);
        let outcome = crate::integrate(&mut machine, start, &parameters, |point| {
            rows.push(values());
            last_time = point.time;
        });
        let work = match outcome {
            Ok(_) if has_end => Ok(outcome.map_or(SolverStats::default(), |outcome| outcome.work)),
            Ok(outcome) => Err(Trouble::TooManyRows { time: outcome.last.time, rows: outcome.last.index }),
            Err(IntegrationError::Parameter(error)) => Err(Trouble::Integrator(error)),
            Err(IntegrationError::EarlyStop(stopped)) => match stopped.cause {
                Cause::System(Stop::Finished) => {
                    // The end is printed, though it is no multiple of DT.
                    if rows.is_empty() || latest_time.get() > last_time {
                        rows.push(values());
                    }
                    Ok(stopped.work)
                }
                cause => {
                    let trouble = machine.trouble(stopped.time, &stopped.state, cause, &parameters);
                    Err(trouble.with_forced_steps(stopped.work.forced))
                }
            },
        }?;
        Ok(DeckRun { longer_than_delay: machine.longer_than_delay, ..self.result(rows, &machine.registers, work) })
    }

    /// The registers at the beginning of a run: data, what is known before, and what the integrals begin with.
    fn initial_registers(&self, set: &DataSet, choices: &RunOptions) -> Result<Vec<f64>, Trouble> {
        let mut registers = self.registers.clone();
        for (name, register) in &self.parameters {
            let value = set.0.iter().rev().find(|(of, _)| of == name).map(|(_, value)| *value);
            registers[*register as usize] = value.ok_or_else(|| Trouble::Missing(name.clone()))?;
        }
        if let Some((name, _)) = set.0.iter().find(|(name, _)| !self.parameters.iter().any(|(known, _)| known == name))
        {
            return Err(Trouble::Unknown(name.clone()));
        }
        registers[FIRST_STEP as usize] = choices.integrator.print_interval;
        // Twice, for DTMIN and DTMAX go by DT where no card defines them, and may be computed with.
        for _ in 0..2 {
            let interval = registers[self.steps[0].0 as usize];
            for (register, by_default) in [(self.steps[1], interval / 1_073_741_824.0), (self.steps[2], interval)] {
                if !register.1 {
                    registers[register.0 as usize] = by_default;
                }
            }
            execute(&self.initial.instructions, &mut registers);
        }
        if let Some(state) = self.states.iter().find(|state| !registers[state.register as usize].is_finite()) {
            return Err(Trouble::NonFinite { time: 0.0, origin: self.origin(&registers, state.register), forced: 0 });
        }
        Ok(registers)
    }

    /// How the integrator is to go, and whether the end of the run is known before it.
    fn integrator(&self, registers: &[f64], choices: &RunOptions) -> Result<(SolverParameters, bool), Trouble> {
        let [interval, smallest, largest] = self.steps.map(|(register, _)| registers[register as usize]);
        let refused = |name, value, allowed| Err(Trouble::Step { name, value, allowed });
        for (name, value) in [("DT", interval), ("DTMIN", smallest), ("DTMAX", largest)] {
            if !(value > 0.0 && value.is_finite()) {
                return refused(name, value, "it must be above zero and finite".to_owned());
            }
        }
        if smallest > largest {
            let [_, (_, has_least), (_, has_most)] = self.steps;
            let way_out = match (has_least, has_most) {
                (false, _) => {
                    "; without a card DTMIN is DT over 2 to the power 30: add a DTMIN card, or give a longer DTMAX"
                }
                (_, true) => "; give a smaller DTMIN or a longer DTMAX",
                (_, false) => ", the value of DT, without a card; give a smaller DTMIN or a longer DT",
            };
            return refused(
                "DTMIN",
                smallest,
                format!("it must not be above DTMAX, which is {}{way_out}", eight_digits(largest)),
            );
        }
        let mut end: Option<f64> = None;
        for finish in self.finishes.iter().filter(|finish| finish.is_run_length) {
            let value = registers[finish.limit as usize];
            let most_rows = self.most_rows(choices.at_once);
            if !(value > 0.0 && value / interval <= most_rows) {
                let (card, text) = (finish.card, self.card_text(finish.card));
                let (most, numbers) = (most_rows as u64, self.numbers_in_a_row());
                return Err(Trouble::RunLength { card, text, value, most, numbers });
            }
            end = Some(end.map_or(value, |end| end.min(value)));
        }
        // A step with many integrals or delays takes longer.
        let most_steps = (MOST_WORK / self.parts_of_a_step()).min(choices.integrator.most_steps);
        // Another FIN may end the run before so many steps are made.
        let (longest, name) = if largest < interval { (largest, "DTMAX") } else { (interval, "DT") };
        if let Some(end) = end.filter(|end| end / longest > most_steps as f64)
            && self.finishes.iter().all(|finish| finish.is_run_length)
        {
            let allowed = format!(
                "to the end at T = {} there would be more than {most_steps} steps, which is the most{}; give a \
                 longer {name} or an earlier FIN",
                eight_digits(end),
                self.load_of_a_step(choices)
            );
            return refused(name, longest, allowed);
        }
        // A run whose end is not known before goes on until a value stops it, or rows without end do.
        let run_length = end.unwrap_or(interval * (most_steps as f64).min(self.most_rows(choices.at_once)));
        let parameters = SolverParameters {
            most_steps,
            print_interval: interval,
            run_length,
            smallest_step: smallest,
            largest_step: largest,
            initial_step: largest,
            ..choices.integrator
        };
        Ok((parameters, end.is_some()))
    }

    /// Why a run has fewer steps than any may have, in words; empty if it has as many.
    fn load_of_a_step(&self, choices: &RunOptions) -> String {
        if MOST_WORK / self.parts_of_a_step() >= choices.integrator.most_steps {
            return String::new();
        }
        format!(
            " with {} and {}",
            count_with_noun(self.states.len(), "integral"),
            count_with_noun(self.delays.len(), "TDL")
        )
    }

    fn lines(&self, registers: &[f64], choices: &RunOptions) -> Result<Vec<RecordedDelay>, Trouble> {
        let line = |delay: &Delay| {
            let length = registers[delay.delay as usize];
            let line = DelayLine::new(length, 0.0, choices.interpolation, choices.extrapolation);
            let (card, text) = (delay.card, self.card_text(delay.card));
            let line = line.map_err(|error| Trouble::Delay { time: 0.0, card, text, error })?;
            let points = delay.points.map_or(f64::INFINITY, |points| registers[points as usize]);
            let apart = match choices.remembered {
                RememberedPoints::AsAsked if points >= 1.0 => length / points,
                _ => 0.0,
            };
            Ok(RecordedDelay { line, apart, last: f64::NEG_INFINITY })
        };
        self.delays.iter().map(line).collect()
    }

    fn result(&self, rows: Vec<Vec<f64>>, registers: &[f64], work: SolverStats) -> DeckRun {
        let columns = self.columns();
        let mut from = columns.len();
        let plots = self.plots.iter().map(|plot| {
            let place = from..from + plot.names.len();
            from = place.end;
            (plot_of(plot, registers), rows.iter().map(|row| row[place.clone()].to_vec()).collect())
        });
        let plots = plots.collect();
        let parameters = self.parameters.iter().map(|(name, register)| (name.clone(), registers[*register as usize]));
        DeckRun {
            parameters: parameters.collect(),
            headings: self.headings.clone(),
            widths: self.outputs.iter().map(Vec::len).collect(),
            rows: rows
                .into_iter()
                .map(|mut row| {
                    row.truncate(columns.len());
                    row
                })
                .collect(),
            columns,
            plots,
            work,
            longer_than_delay: 0,
        }
    }
}

/// "1 integral", "2 integrals".
fn count_with_noun(number: usize, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 || thing == "TDL" { "" } else { "s" })
}

fn plot_of(plot: &PlotCode, registers: &[f64]) -> Plot {
    let values = |of: &Option<Vec<u32>>| of.as_ref().map(|of| of.iter().map(|at| registers[*at as usize]).collect());
    Plot {
        names: plot.names.iter().map(|(name, _)| name.clone()).collect(),
        scale: values(&plot.scale),
        zero: values(&plot.zero),
    }
}
