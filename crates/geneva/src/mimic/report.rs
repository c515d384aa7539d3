//! Reports on a deck and its runs.

use crate::output::{TextLayout, count, heading};
use anyhow::ensure;
use geneva_mimic::language::{Deck, DeckRun, Program, Schedule, print_out};
use serde::ser::{Serialize, Serializer};
use std::io::Write;

/// Most bytes of a print-out: plots have more of them than the numbers that they show.
const MOST_PRINTED: usize = 64_000_000;

/// The report on a deck without mistakes: its size and its notes.
pub(super) fn check_report(name: &str, deck: &Deck, program: &Program, layout: TextLayout) -> String {
    let (integrals, instructions) = program.size();
    let dead = program.execution_order().iter().filter(|of| of.is_dead).count();
    let mut page = layout.wrapped(
        "",
        &format!(
            "{name}: no mistakes found. {}, {}, {} per evaluation; {} without an effect on what is printed.",
            count(program.execution_order().len(), "statement"),
            count(integrals, "integral"),
            count(instructions, "instruction"),
            count(dead, "statement")
        ),
    );
    for note in deck.notes() {
        page += &layout.wrapped("note: ", note);
    }
    page
}

/// The statements in their order.
pub(super) fn statements_in_order(deck: &Deck, program: &Program, layout: TextLayout) -> String {
    let bold = heading();
    let (control, result) = (width(program, |of| of.control.as_deref().unwrap_or("")), width(program, |of| &of.result));
    let mut page = String::new();
    for (when, title) in
        [(Schedule::Once, "Once in a run"), (Schedule::Always, "At every evaluation of the integrands")]
    {
        page += &format!("{bold}{title}{bold:#}\n");
        for of in program.execution_order().iter().filter(|of| of.when == when) {
            let dead = if of.is_dead { " (nothing that is printed needs it)" } else { "" };
            let lead = format!(
                "  card {:>4}  {:<control$}  {:<result$}  ",
                of.card,
                of.control.as_deref().unwrap_or(""),
                of.result,
            );
            page += &layout.wrapped(&lead, &format!("{}{dead}", deck.expression_of(of)));
        }
    }
    page
}

fn width<'a>(program: &'a Program, part: fn(&'a geneva_mimic::language::SortedStatement) -> &'a str) -> usize {
    program.execution_order().iter().map(|of| part(of).len()).max().unwrap_or(0)
}

/// The print-outs of all runs.
pub(super) fn print_outs(name: &str, runs: &[DeckRun]) -> anyhow::Result<String> {
    let title =
        |at: usize| if runs.len() > 1 { format!("{name}, run {} of {}", at + 1, runs.len()) } else { name.to_owned() };
    let mut pages = String::new();
    for (at, run) in runs.iter().enumerate() {
        pages += if at > 0 { "\n\n" } else { "" };
        pages += &print_out(run, &title(at));
        ensure!(
            pages.len() <= MOST_PRINTED,
            "{name}: the print-outs of the first {} are larger than {} MB, the most that is written; give fewer data sets, \
             or --format csv",
            count(at + 1, "run"),
            MOST_PRINTED / 1_000_000
        );
    }
    Ok(pages)
}

/// A number whose zero has no sign.
fn unsigned_zero(value: f64) -> f64 {
    value + 0.0
}

/// A list of names and numbers as a JSON object.
struct Named<'a>(&'a [(String, f64)]);

impl Serialize for Named<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, unsigned_zero(*value))))
    }
}

/// An array of objects, with a row to a line.
pub(super) fn json(runs: &[DeckRun]) -> anyhow::Result<String> {
    // Written in one go: many rows as texts of their own would take several times the memory.
    let mut page = b"[\n".to_vec();
    for (at, run) in runs.iter().enumerate() {
        write!(
            page,
            "{}  {{\n    \"parameters\": {},\n    \"columns\": {},\n    \"steps\": {},\n    \"forced_steps\": {},\n    \
             \"steps_longer_than_delay\": {},\n    \"rows\": [\n      ",
            if at > 0 { ",\n" } else { "" },
            serde_json::to_string(&Named(&run.parameters))?,
            serde_json::to_string(&run.columns)?,
            run.work.accepted,
            run.work.forced,
            run.longer_than_delay,
        )?;
        for (at, row) in run.rows.iter().enumerate() {
            page.extend_from_slice(if at > 0 { b",\n      " } else { b"" });
            serde_json::to_writer(&mut page, &row.iter().map(|value| unsigned_zero(*value)).collect::<Vec<_>>())?;
        }
        page.extend_from_slice(b"\n    ]\n  }");
    }
    page.extend_from_slice(b"\n]\n");
    Ok(String::from_utf8(page)?)
}

/// One row per printed point: the run's number and parameters, and the columns.
pub(super) fn csv(runs: &[DeckRun]) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let Some(first) = runs.first() else { return Ok(String::new()) };
    let parameters = first.parameters.iter().map(|(name, _)| name.as_str());
    writer.write_record(["run"].into_iter().chain(parameters).chain(first.columns.iter().map(String::as_str)))?;
    for (at, run) in runs.iter().enumerate() {
        for row in &run.rows {
            let numbers = run.parameters.iter().map(|(_, value)| value).chain(row);
            let cells: Result<Vec<_>, _> = numbers.map(|value| serde_json::to_string(&unsigned_zero(*value))).collect();
            writer.write_record([(at + 1).to_string()].into_iter().chain(cells?))?;
        }
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// The first plot of the first run; the columns against the first if nothing is plotted.
pub(super) fn svg(name: &str, runs: &[DeckRun]) -> anyhow::Result<String> {
    let Some(run) = runs.first() else { anyhow::bail!("{name}: no run") };
    let (names, points) = match run.plots.first() {
        Some((plot, points)) => (&plot.names, points),
        None => (&run.columns, &run.rows),
    };
    anyhow::ensure!(
        names.len() > 1,
        "{name}: only {} is printed; give the OUT card a second name, which a curve needs",
        names.join(", ")
    );
    anyhow::ensure!(
        points.len() > 1,
        "{name}: only one point is printed, because FIN is true from the start; a curve needs two, so change the FIN card"
    );
    let parameters: Vec<_> =
        run.parameters.iter().map(|(name, value)| format!("{name} = {}", unsigned_zero(*value))).collect();
    let title = if parameters.is_empty() { name.to_owned() } else { format!("{name}: {}", parameters.join(", ")) };
    Ok(geneva_figures::printed::plot(&title, names, points)?.standalone())
}
