//! Drawings for a workshop: a sheet for each part, with limits, true to scale in print.

mod assembly;
#[cfg(test)]
mod bore_tests;
mod callout;
mod dimension;
mod drawn_sizes;
mod ink;
mod length;
mod limits;
mod making;
mod page;
mod paper;
mod part_views;
#[cfg(test)]
mod process_tests;
#[cfg(test)]
mod ring_tests;
mod ring_views;
mod sheet;
#[cfg(test)]
mod tests;
mod text;
mod title;
mod view;

pub use dimension::{Measured, PrintedDimension};
pub use limits::LimitOrigin;
pub use making::SheetLimits;
pub use page::{sheets_html, sheets_svg};
pub use paper::{DrawingScale, Paper};
pub use sheet::{Sheet, internal_sheets, sheets};
pub use text::{SheetMaterial, SheetText};
