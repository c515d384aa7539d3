//! The wheel as it was made, against the drawn one and against points on the outlines.

mod drawn;
mod locking_play;
mod measured;
mod others;
mod points;
mod process;
mod some_sizes;
mod sweep;
mod worn;
mod yields;
