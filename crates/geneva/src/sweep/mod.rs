//! Many escapements at once: ranges of friction, inertia ratio and torque, a row for each.
//!
//! Blocks of rows are computed in parallel and written in order, so that the bytes do not depend on the threads.

mod grid;
mod range;
mod row;

use crate::destination::Destination;
use crate::fields;
use crate::output::count;
use crate::printable::shown_path;
use crate::progress;
use crate::threads::Threads;
use crate::typed::{self, Output};
use clap::Args;
use grid::SweepGrid;
use range::{Range, Spacing};
use rayon::prelude::*;
use row::Status;
use std::io::IsTerminal;
use std::num::NonZeroUsize;

/// Options of `geneva sweep`.
#[derive(Args, Debug)]
pub(crate) struct SweepArguments {
    /// Numbers of slots of the follower, each 3, 4 or 6, separated by commas
    #[arg(long, value_name = "N[,N...]", value_parser = typed::slots, value_delimiter = ',', required = true,
          allow_negative_numbers = true)]
    pub slots: Vec<u32>,
    /// Coefficient of friction between pin and slot, zero or more: FROM:TO:COUNT, FROM:TO:COUNT:log, or a single number
    #[arg(long, value_name = "RANGE", value_parser = Range::zero_or_more, allow_hyphen_values = true)]
    pub friction: Range,
    /// Moment of inertia of the driver over that of the follower, above zero
    #[arg(long, value_name = "RANGE", value_parser = Range::positive, allow_hyphen_values = true)]
    pub inertia_ratio: Range,
    /// Torque of the spring on the driver, above zero; speeds grow with its square root
    #[arg(long, value_name = "RANGE", value_parser = Range::positive, default_value = "1", allow_hyphen_values = true)]
    pub torque: Range,
    /// Moment of inertia of the follower about its axis, above zero
    #[arg(long, value_name = "I", value_parser = typed::positive, default_value = "1", allow_hyphen_values = true)]
    pub follower_inertia: f64,
    /// Turn of the driver, in degrees, after which its angle is reset to where a pin enters; one value for all slots
    /// [default: 360 over the number of pins, as in a mechanism]
    #[arg(long, alias = "modulus-deg", value_name = "D", value_parser = typed::degrees, allow_hyphen_values = true)]
    pub reset_deg: Option<f64>,
    /// Spacing of the ranges that don't give their own
    #[arg(long, value_enum, default_value_t)]
    pub spacing: Spacing,
    /// Number of threads; the rows don't depend on it
    /// [default: RAYON_NUM_THREADS, or as many as the machine has]
    #[arg(long, value_name = "N", value_parser = typed::threads, allow_negative_numbers = true)]
    pub threads: Option<NonZeroUsize>,
    /// Where the rows go.
    #[command(flatten)]
    pub to: Output,
}

/// Rows that one thread computes at a time.
const BLOCK: usize = 16;
/// Blocks that are held before they are written.
const HELD: usize = 128;

/// Computes and writes the rows; returns a summary if they are in a file.
pub(crate) fn write_sweep(wanted: &SweepArguments) -> anyhow::Result<Option<String>> {
    let grid = SweepGrid::new(wanted)?;
    let pool = Threads::new(wanted.threads)?.pool()?;
    let mut destination = Destination::new(&wanted.to.output)?;
    let Some(tally) = pool.install(|| write_blocks(&grid, &mut destination))? else { return Ok(None) };
    let file = destination.finish()?;
    let rows = count(grid.rows(), "row");
    Ok(file.map(|file| format!("{}: {rows}, {}\n", shown_path(&file), tally.words())))
}

/// All rows, in order; how many of which status, unless the reader has seen enough.
fn write_blocks(grid: &SweepGrid, destination: &mut Destination) -> anyhow::Result<Option<Tally>> {
    let rows = grid.rows();
    // Rows that scroll over a terminal show by themselves how far they have come.
    let bar =
        progress::bar(rows, "rows", matches!(destination, Destination::Output) && std::io::stdout().is_terminal());
    let mut tally = Tally::default();
    let header = fields::csv(grid.cell(0).map(|first| row::row(&first).0).as_ref(), [])?;
    if !destination.add(header.as_bytes())? {
        return Ok(None);
    }
    for start in (0..rows).step_by(BLOCK * HELD) {
        let end = rows.min(start + BLOCK * HELD);
        let blocks: Vec<_> = (start..end).step_by(BLOCK).collect();
        let blocks: Vec<_> = blocks
            .into_par_iter()
            .map(|first| {
                let block = block(grid, first..end.min(first + BLOCK));
                bar.add(end.min(first + BLOCK) - first);
                block
            })
            .collect();
        for written in blocks {
            let (text, part) = written?;
            tally.add(&part);
            if !destination.add(text.as_bytes())? {
                return Ok(None);
            }
        }
    }
    Ok(Some(tally))
}

/// The bytes of some rows.
fn block(grid: &SweepGrid, rows: std::ops::Range<usize>) -> anyhow::Result<(String, Tally)> {
    let mut tally = Tally::default();
    let rows = rows.filter_map(|row| grid.cell(row)).map(|cell| {
        let (row, status) = row::row(&cell);
        tally.0[status as usize] += 1;
        row
    });
    let text = fields::csv(None, rows)?;
    Ok((text, tally))
}

/// How many rows have which status, in the order of [`Status::ALL`].
#[derive(Clone, Copy, Debug, Default)]
struct Tally([usize; Status::ALL.len()]);

impl Tally {
    fn add(&mut self, other: &Self) {
        for (number, more) in self.0.iter_mut().zip(other.0) {
            *number += more;
        }
    }

    /// "10 ok, 2 may-jam".
    fn words(&self) -> String {
        let some = self.0.iter().zip(Status::ALL).filter(|(number, _)| **number > 0);
        some.map(|(number, status)| format!("{number} {}", status.name())).collect::<Vec<_>>().join(", ")
    }
}
