//! Many escapements at once: ranges of friction, inertia ratio and torque, a row for each.
//!
//! Blocks of rows are computed in parallel and written in order, so that the bytes do not depend on the threads.

mod arguments;
mod bar;
mod destination;
mod grid;
mod range;
mod row;

pub use arguments::SweepArguments;

use crate::output::{count, print};
use anyhow::Context;
use bar::Bar;
use destination::Destination;
use grid::Grid;
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use row::{Row, Status};
use std::io::IsTerminal;
use std::num::NonZeroUsize;
use std::ops::Range;

/// Rows that one thread computes at a time.
const BLOCK: usize = 16;
/// Blocks that are held before they are written.
const HELD: usize = 128;

/// Computes and writes the rows that are wanted.
pub fn run(wanted: &SweepArguments) -> anyhow::Result<()> {
    let grid = Grid::new(wanted)?;
    let threads = wanted.threads.map_or(0, NonZeroUsize::get);
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.context("cannot start the threads; give fewer --threads")?;
    let mut destination = Destination::new(&wanted.output)?;
    let Some(tally) = pool.install(|| write(&grid, &mut destination))? else { return Ok(()) };
    if let Some(file) = destination.finish()? {
        let rows = count(grid.rows(), "row");
        print(&format!("{}: {rows}, {}\n", file.display(), tally.words()))?;
    }
    Ok(())
}

/// All rows, in order; how many of which status, unless the reader has seen enough.
fn write(grid: &Grid, destination: &mut Destination) -> anyhow::Result<Option<Tally>> {
    let rows = grid.rows();
    // Rows that scroll over a terminal show by themselves how far they have come.
    let bar = Bar::new(rows, matches!(destination, Destination::Output) && std::io::stdout().is_terminal());
    let mut tally = Tally::default();
    if !destination.add(format!("{}\n", Row::COLUMNS.join(",")).as_bytes())? {
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
            let (bytes, part) = written?;
            tally.add(&part);
            if !destination.add(&bytes)? {
                return Ok(None);
            }
        }
    }
    Ok(Some(tally))
}

/// The bytes of some rows.
fn block(grid: &Grid, rows: Range<usize>) -> anyhow::Result<(Vec<u8>, Tally)> {
    let mut tally = Tally::default();
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    for cell in rows.filter_map(|row| grid.cell(row)) {
        let row = Row::new(&cell);
        tally.count(row.status);
        writer.serialize(&row)?;
    }
    Ok((writer.into_inner()?, tally))
}

/// How many rows have which status, in the order of [`Status::ALL`].
#[derive(Clone, Copy, Debug, Default)]
struct Tally([usize; Status::ALL.len()]);

impl Tally {
    fn count(&mut self, status: Status) {
        for (number, counted) in self.0.iter_mut().zip(Status::ALL) {
            *number += usize::from(counted == status);
        }
    }

    fn add(&mut self, other: &Self) {
        for (number, more) in self.0.iter_mut().zip(other.0) {
            *number += more;
        }
    }

    /// "10 ok, 2 jams".
    fn words(&self) -> String {
        let some = self.0.iter().zip(Status::ALL).filter(|(number, _)| **number > 0);
        some.map(|(number, status)| format!("{number} {}", status.name())).collect::<Vec<_>>().join(", ")
    }
}
