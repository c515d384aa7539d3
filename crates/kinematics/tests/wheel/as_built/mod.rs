//! The wheel as it was made, against the drawn one and against points on the outlines.

mod drawn;
mod points;
mod sweep;
mod yields;
