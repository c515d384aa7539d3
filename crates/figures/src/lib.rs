//! Drawings of pin-in-slot mechanisms, to scale, and the numbers behind them.
//!
//! A [`Figure`] is an SVG with its text alternative, its caption and the [`Series`] it was drawn from. Everything
//! drawn is computed by `geneva-kinematics` from the arguments: this crate holds no number that a source prints,
//! knows nothing of claims or books, and does no input or output. The same arguments give the same bytes.
//!
//! Colours are `currentColor` and the custom properties `--fig-1` to `--fig-4`, `--fig-grid`, `--fig-fill`
//! (of which `--fig-face` is the colour and `--fig-share` how much of it covers) and `--fig-paper`, each with a fallback, so
//! that a page may restyle a figure for a dark background.

#[cfg(test)]
mod checks;

mod error;
mod figure;
mod series;

mod chart;
mod moving;
mod number;
mod parts;
mod star;
mod svg;
mod theme;

pub mod escapement;
pub mod notation;
pub mod pin;
pub mod printed;
pub mod quick_return;
pub mod runs;
pub mod stations;
pub mod steady;
pub mod timer;

pub use error::FigureError;
pub use figure::Figure;
pub(crate) use figure::Words;
pub use number::with_minus_sign;
pub use series::{ItemValue, Series, SeriesColumn};
