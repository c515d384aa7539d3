//! The diagram of work and precision, from the record.

use crate::records::integrators;
use crate::tables::solver::CONTESTANTS;
use geneva_figures::Figure;
use geneva_figures::steady::{Measurement, work_precision as diagram};

/// Those of the record that run over the same times.
pub fn work_precision() -> anyhow::Result<Figure> {
    let all = integrators()?;
    let runs = CONTESTANTS.iter().filter_map(|(contestant, words)| Some((*contestant, words.strip_suffix(": run")?)));
    let drawn = runs.flat_map(|(contestant, words)| {
        all.iter().filter(move |one| one.contestant == contestant).filter_map(move |one| {
            Some(Measurement {
                contestant: words.to_owned(),
                tolerance: one.tolerance.parse().ok()?,
                evaluations: one.evaluations,
                milliseconds: one.milliseconds,
                true_error: one.true_error?,
            })
        })
    });
    Ok(diagram(&drawn.collect::<Vec<_>>()))
}
