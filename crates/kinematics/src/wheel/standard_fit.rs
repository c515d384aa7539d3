//! The play of a standard's fit.

/// Least and greatest play in millimetres of the fit H8/e8, for diameters over one and up to another number of millimetres.
///
/// By the formulas of ISO 286-1 (first edition, 1988, annex A) for the geometric mean D of the range: the grade 8 has the
/// tolerance 25 i with i = 0.45 ∛D + 0.001 D, and a shaft e is thinner by 11 D^0.41 at least, in micrometres and both rounded.
/// Hole and shaft have one such tolerance each.
///
/// ```
/// use geneva_kinematics::wheel::play_of_h8_e8;
///
/// // The standard's table has a hole of +0 to +22 µm and a shaft of −25 to −47 µm for 6 to 10 mm.
/// assert_eq!(play_of_h8_e8(6.0, 10.0), [0.025, 0.047 + 0.022]);
/// ```
pub fn play_of_h8_e8(over: f64, up_to: f64) -> [f64; 2] {
    const MICROMETRES: f64 = 1000.0;
    let mean = (over * up_to).sqrt();
    let grade = libm::round(25.0 * (0.45 * libm::cbrt(mean) + 0.001 * mean));
    let least = libm::round(11.0 * libm::pow(mean, 0.41));
    [least / MICROMETRES, (least + 2.0 * grade) / MICROMETRES]
}

/// Ranges of diameters of ISO 286, each over one and up to another number of millimetres. The first range is that up to 3 mm, whose
/// mean the standard takes from 1 mm on.
const RANGES: [[f64; 2]; 8] =
    [[1.0, 3.0], [3.0, 6.0], [6.0, 10.0], [10.0, 18.0], [18.0, 30.0], [30.0, 50.0], [50.0, 80.0], [80.0, 120.0]];

/// Least and greatest play in millimetres of the fit H8/e8 for a diameter in millimetres, above zero and up to 120; none for others.
///
/// For 30 to 50 mm the standard rounds the shaft's least play up to 0.050 mm, so its table has 1 µm more of either.
///
/// ```
/// use geneva_kinematics::wheel::{play_of_h8_e8, play_of_h8_e8_at};
///
/// assert_eq!(play_of_h8_e8_at(7.5), Some(play_of_h8_e8(6.0, 10.0)));
/// assert_eq!(play_of_h8_e8_at(10.0), Some(play_of_h8_e8(6.0, 10.0)));
/// assert_eq!(play_of_h8_e8_at(121.0), None);
/// ```
pub fn play_of_h8_e8_at(diameter: f64) -> Option<[f64; 2]> {
    let range = RANGES.into_iter().find(|[_, up_to]| diameter <= *up_to)?;
    (diameter > 0.0).then(|| play_of_h8_e8(range[0], range[1]))
}
