//! A small SVG of our own: shapes with true arcs, labels with halos, and labels that find room by themselves.
//!
//! Positions are pixels of the view box, y downwards. Angles are radians, counter-clockwise as seen.

mod canvas;
mod ground;
mod label;
mod path;
mod placing;
mod shape;
mod view;

pub use canvas::{Canvas, DrawingKind, PIXELS_PER_MILLIMETRE};
pub use label::{HALO, Label, LabelPosition, TEXT_SIZE, escape};
pub use path::{Path, Sense};
pub use placing::{Placing, leader, positions_around, positions_beside_line};
pub use shape::{DASHED, Shape};
pub use view::{Pixels, View, angle_of, heading, part_within};
