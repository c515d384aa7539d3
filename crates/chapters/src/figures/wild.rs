//! The figure of what is said of Geneva wheels elsewhere.

use anyhow::Context;
use geneva_documents::wild::ratio;
use geneva_figures::Figure;
use geneva_figures::stations::{self, WrongFormula, wrong_formulas};

/// Wrong formulas, and what each is for.
const FORMULAS: [(&str, &str); 7] = [
    ("wild.firgelli-time.dwell", "rest"),
    ("wild.firgelli-time.index", "move"),
    ("wild.firgelli-time.centres", "axes, with the sine"),
    ("wild.firgelli-indexing.centres", "axes, with a root"),
    ("wild.firgelli-time.driver", "crank, as a difference"),
    ("wild.oxiphysics.rim", "rim, with a sum"),
    ("wild.firgelli-form.speed", "speed, less a factor"),
];

/// Radius of the locking disc in crank radii: about that of the programs, which leave three pin radii beside it.
const DISC: f64 = 0.7;

/// How near the horns come to the locking disc, for wheels that are built.
pub(super) fn locking_cuts() -> anyhow::Result<Figure> {
    Ok(stations::locking_cuts(3..=12, DISC)?)
}

/// What the wrong formulas give over what is right, for wheels that are built.
pub(super) fn formulas() -> anyhow::Result<Figure> {
    let compared = FORMULAS.map(|(id, name)| {
        let of = |slots| Ok((slots, ratio(id, slots).with_context(|| format!("`{id}` gives no ratio"))?));
        Ok(WrongFormula { name: name.to_owned(), ratios: (3..=12).map(of).collect::<anyhow::Result<_>>()? })
    });
    Ok(wrong_formulas(&compared.into_iter().collect::<anyhow::Result<Vec<_>>>()?))
}
