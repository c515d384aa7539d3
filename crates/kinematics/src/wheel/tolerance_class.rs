//! Limits of sizes by the letters and grades of ISO 286.
//!
//! The values are those of the standard's tables, which decide; its formulas give most of them, and the tests say where the
//! tables differ from the formulas.

/// Greatest diameters of the standard's ranges, in millimetres: the first begins above zero, each other where the one before ends.
const UP_TO: [f64; 13] = [3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0];

/// The first of the grades below.
const FIRST_GRADE: u32 = 5;

/// Widths of the grades IT5 to IT11 in micrometres, for each range: ISO 286-1, table 1.
const WIDTHS: [[f64; 13]; 7] = [
    [4.0, 5.0, 6.0, 8.0, 9.0, 11.0, 13.0, 15.0, 18.0, 20.0, 23.0, 25.0, 27.0],
    [6.0, 8.0, 9.0, 11.0, 13.0, 16.0, 19.0, 22.0, 25.0, 29.0, 32.0, 36.0, 40.0],
    [10.0, 12.0, 15.0, 18.0, 21.0, 25.0, 30.0, 35.0, 40.0, 46.0, 52.0, 57.0, 63.0],
    [14.0, 18.0, 22.0, 27.0, 33.0, 39.0, 46.0, 54.0, 63.0, 72.0, 81.0, 89.0, 97.0],
    [25.0, 30.0, 36.0, 43.0, 52.0, 62.0, 74.0, 87.0, 100.0, 115.0, 130.0, 140.0, 155.0],
    [40.0, 48.0, 58.0, 70.0, 84.0, 100.0, 120.0, 140.0, 160.0, 185.0, 210.0, 230.0, 250.0],
    [60.0, 75.0, 90.0, 110.0, 130.0, 160.0, 190.0, 220.0, 250.0, 290.0, 320.0, 360.0, 400.0],
];

/// How much thinner than its nominal size a shaft of a letter is at least, in micrometres: ISO 286-1, table 4.
const E: [f64; 13] = [14.0, 20.0, 25.0, 32.0, 40.0, 50.0, 60.0, 72.0, 85.0, 100.0, 110.0, 125.0, 135.0];
const F: [f64; 13] = [6.0, 10.0, 13.0, 16.0, 20.0, 25.0, 30.0, 36.0, 43.0, 50.0, 56.0, 62.0, 68.0];
const G: [f64; 13] = [2.0, 4.0, 5.0, 6.0, 7.0, 9.0, 10.0, 12.0, 14.0, 15.0, 17.0, 18.0, 20.0];
/// How much thicker than its nominal size a shaft of a letter is at least, in micrometres: ISO 286-1, table 5.
const M: [f64; 13] = [2.0, 4.0, 6.0, 7.0, 8.0, 9.0, 11.0, 13.0, 15.0, 17.0, 20.0, 21.0, 23.0];
const P: [f64; 13] = [6.0, 12.0, 15.0, 18.0, 22.0, 26.0, 32.0, 37.0, 43.0, 50.0, 56.0, 62.0, 68.0];

const MICROMETRES: f64 = 1000.0;
const ROUNDING: f64 = 1e-9;

/// A letter of ISO 286: where the limits of a size are; capitals are for holes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ToleranceLetter {
    /// A shaft that runs with much play.
    LowerE,
    /// A shaft that runs with play.
    LowerF,
    /// A shaft that slides.
    LowerG,
    /// A shaft up to its nominal size.
    LowerH,
    /// A shaft that is a little thicker, as a dowel.
    LowerM,
    /// A hole from its nominal size on.
    UpperH,
    /// A hole as much narrower as wider.
    UpperJs,
    /// A hole that is narrower, for a press fit.
    UpperP,
}

/// A tolerance class of ISO 286: a letter and a grade, such as H8.
///
/// ```
/// use geneva_kinematics::wheel::{ToleranceClass, ToleranceLetter};
///
/// let class = ToleranceClass { letter: ToleranceLetter::LowerE, grade: 8 };
/// assert_eq!(class.name(), "e8");
/// assert_eq!(class.limits(8.0), Some([-0.047, -0.025])); // mm
/// assert_eq!(class.limits(501.0), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ToleranceClass {
    /// Where its limits are.
    pub letter: ToleranceLetter,
    /// Its grade, from 5 to 11: how far they are apart.
    pub grade: u32,
}

impl ToleranceClass {
    /// Its name as it is written behind a size.
    pub fn name(self) -> String {
        let letter = match self.letter {
            ToleranceLetter::LowerE => "e",
            ToleranceLetter::LowerF => "f",
            ToleranceLetter::LowerG => "g",
            ToleranceLetter::LowerH => "h",
            ToleranceLetter::LowerM => "m",
            ToleranceLetter::UpperH => "H",
            ToleranceLetter::UpperJs => "JS",
            ToleranceLetter::UpperP => "P",
        };
        format!("{letter}{}", self.grade)
    }

    /// By how much a size may be below and above a nominal size in millimetres, each in millimetres with its sign.
    ///
    /// The nominal size is above zero and at most 500 mm, and the grade is from 5 to 11; none for others. ISO 286-1 and -2.
    pub fn limits(self, nominal: f64) -> Option<[f64; 2]> {
        let range = range(nominal)?;
        let width = width(self.grade, range)?;
        let at = |row: &[f64; 13]| row.get(range).copied();
        let [lower, upper] = match self.letter {
            ToleranceLetter::LowerE => below(at(&E)?, width),
            ToleranceLetter::LowerF => below(at(&F)?, width),
            ToleranceLetter::LowerG => below(at(&G)?, width),
            ToleranceLetter::LowerH => below(0.0, width),
            ToleranceLetter::LowerM => [at(&M)?, at(&M)? + width],
            ToleranceLetter::UpperH => [0.0, width],
            ToleranceLetter::UpperJs => {
                // From grade 7 on, an odd number of micrometres is replaced by the even one below it.
                let half = if self.grade >= 7 { libm::floor(width / 2.0) } else { width / 2.0 };
                [-half, half]
            }
            ToleranceLetter::UpperP => {
                // Holes of fine grades are moved so that they fit a shaft of the next finer grade as shafts of the letter fit H.
                let moved =
                    if self.grade <= 7 && range > 0 { width - self::width(self.grade - 1, range)? } else { 0.0 };
                below(at(&P)? - moved, width)
            }
        };
        Some([lower / MICROMETRES, upper / MICROMETRES])
    }
}

fn below(by: f64, width: f64) -> [f64; 2] {
    [-by - width, 0.0 - by]
}

/// Which of the standard's ranges a size in millimetres is in.
fn range(size: f64) -> Option<usize> {
    // A size that misses the end of a range by rounding is in it.
    UP_TO.iter().position(|up_to| size <= *up_to + ROUNDING).filter(|_| size > 0.0)
}

fn width(grade: u32, range: usize) -> Option<f64> {
    let row = WIDTHS.get(grade.checked_sub(FIRST_GRADE)? as usize)?;
    row.get(range).copied()
}
