//! What the listing of the program prints of the numbers that all runs share.

/// Its π.
pub(super) const PI: &str = "3.1416";
/// The time between printed lines, in s.
pub(super) const PRINT_INTERVAL: &str = ".0005";
/// How late the old acceleration is.
pub(super) const DELAY: &str = "DT/10.";
/// The angle after which it resets the driver's angle, in radians.
pub(super) const QUARTER_TURN: &str = "1.5708";
/// The time at which a run ends, in s.
pub(super) const RUN_LENGTH: &str = ".2";

/// The number by which these characters divide the print interval.
pub(super) fn parts_of(printed: &str) -> Option<f64> {
    printed.split_once("DT/")?.1.trim_end_matches('.').parse().ok()
}
