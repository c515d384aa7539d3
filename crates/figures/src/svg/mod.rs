//! A small SVG of our own: shapes with true arcs, labels with halos, the marks of a technical drawing.
//!
//! Positions are pixels of the view box, y downwards. Angles are radians, counter-clockwise as seen.

pub mod canvas;
pub mod label;
pub mod marks;
pub mod path;
pub mod placing;
pub mod shape;
pub mod view;
