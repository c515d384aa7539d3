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

pub(crate) use canvas::{Canvas, DrawingKind, PIXELS_PER_MILLIMETRE};
pub(crate) use label::{HALO, Label, LabelPosition, TEXT_SIZE, escape};
pub(crate) use path::{Path, Sense};
pub(crate) use placing::{Placing, leader, positions_around, positions_beside_line};
pub(crate) use shape::{DASHED, Shape};
pub(crate) use view::{Pixels, View, angle_of, heading, part_within};
