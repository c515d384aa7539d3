//! Sizes of screws, nuts and keys as the standards have them, in millimetres.

/// A metric screw with a coarse thread.
///
/// ```
/// use geneva_workshop::Thread;
///
/// assert_eq!(Thread::M3.clearance_hole(), 3.4); // mm
/// assert_eq!(Thread::from_name("M8"), Some(Thread::M8));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Thread {
    /// M3, of coarse pitch.
    M3,
    /// M4, of coarse pitch.
    M4,
    /// M5, of coarse pitch.
    M5,
    /// M6, of coarse pitch.
    M6,
    /// M8, of coarse pitch.
    M8,
}

impl Thread {
    /// All threads that there are here, the thinnest first.
    pub const ALL: [Self; 5] = [Self::M3, Self::M4, Self::M5, Self::M6, Self::M8];

    /// Its name, as it is typed and printed: `M3`.
    pub fn name(self) -> &'static str {
        match self {
            Self::M3 => "M3",
            Self::M4 => "M4",
            Self::M5 => "M5",
            Self::M6 => "M6",
            Self::M8 => "M8",
        }
    }

    /// The thread of this name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|thread| thread.name() == name)
    }

    /// Diameter of the screw, in millimetres.
    pub fn diameter(self) -> f64 {
        self.row()[0]
    }

    /// Diameter of a hole through which the screw passes, in millimetres. ISO 273, medium series.
    pub fn clearance_hole(self) -> f64 {
        self.row()[1]
    }

    /// Diameter of the drill for a hole that is tapped, in millimetres: diameter less pitch, as drills are sold. ISO 2306.
    pub fn tapping_hole(self) -> f64 {
        self.row()[2]
    }

    /// Greatest width of the nut across its flats, in millimetres. ISO 4032; DIN 934 has the same.
    pub fn nut_width(self) -> f64 {
        self.row()[3]
    }

    /// Greatest height of the nut, in millimetres. ISO 4032.
    pub fn nut_height(self) -> f64 {
        self.row()[4]
    }

    fn row(self) -> [f64; 5] {
        match self {
            Self::M3 => [3.0, 3.4, 2.5, 5.5, 2.4],
            Self::M4 => [4.0, 4.5, 3.3, 7.0, 3.2],
            Self::M5 => [5.0, 5.5, 4.2, 8.0, 4.7],
            Self::M6 => [6.0, 6.6, 5.0, 10.0, 5.2],
            Self::M8 => [8.0, 9.0, 6.8, 13.0, 6.8],
        }
    }
}

/// A keyway in a hub.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Keyway {
    /// Its width, that of the key, in millimetres.
    pub width: f64,
    /// How deep it is from the shaft's surface, measured in its middle, in millimetres.
    pub depth: f64,
}

/// Shaft diameters above the first and up to the second have a key so wide, and a hub's keyway so deep: DIN 6885-1, b and t2.
const KEYS: [[f64; 4]; 20] = [
    [6.0, 8.0, 2.0, 1.0],
    [8.0, 10.0, 3.0, 1.4],
    [10.0, 12.0, 4.0, 1.8],
    [12.0, 17.0, 5.0, 2.3],
    [17.0, 22.0, 6.0, 2.8],
    [22.0, 30.0, 8.0, 3.3],
    [30.0, 38.0, 10.0, 3.3],
    [38.0, 44.0, 12.0, 3.3],
    [44.0, 50.0, 14.0, 3.8],
    [50.0, 58.0, 16.0, 4.3],
    [58.0, 65.0, 18.0, 4.4],
    [65.0, 75.0, 20.0, 4.9],
    [75.0, 85.0, 22.0, 5.4],
    [85.0, 95.0, 25.0, 5.4],
    [95.0, 110.0, 28.0, 6.4],
    [110.0, 130.0, 32.0, 7.4],
    [130.0, 150.0, 36.0, 8.4],
    [150.0, 170.0, 40.0, 9.4],
    [170.0, 200.0, 45.0, 10.4],
    [200.0, 230.0, 50.0, 11.4],
];

/// Shaft diameters for which [`Keyway::of_shaft`] knows keys, in millimetres.
pub const KEYED_SHAFTS: [f64; 2] = [6.0, 230.0];

impl Keyway {
    /// The hub's keyway for a shaft of this diameter in millimetres, from 6 to 230: DIN 6885-1, form A.
    ///
    /// ```
    /// use geneva_workshop::Keyway;
    ///
    /// let keyway = Keyway::of_shaft(25.0).expect("a shaft between 6 and 230 mm");
    /// assert_eq!((keyway.width, keyway.depth), (8.0, 3.3)); // mm: a key of 8 × 7
    /// assert_eq!(Keyway::of_shaft(5.0), None);
    /// ```
    pub fn of_shaft(diameter: f64) -> Option<Self> {
        let [least, most] = KEYED_SHAFTS;
        let is_known = (least..=most).contains(&diameter);
        let row = KEYS.iter().find(|[_, to, ..]| diameter <= *to).filter(|_| is_known)?;
        let [_, _, width, depth] = *row;
        Some(Self { width, depth })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rows_follow_each_other_without_a_gap() {
        assert_eq!([KEYS[0][0], KEYS[KEYS.len() - 1][1]], KEYED_SHAFTS);
        for pair in KEYS.windows(2) {
            assert_eq!(pair[0][1], pair[1][0]);
            assert!(pair[0][2] < pair[1][2] && pair[0][3] <= pair[1][3]);
        }
    }

    #[test]
    fn a_shaft_on_the_border_of_two_rows_has_the_smaller_key() {
        for [_, to, width, depth] in KEYS {
            assert_eq!(Keyway::of_shaft(to), Some(Keyway { width, depth }));
            assert!(Keyway::of_shaft(1.001 * to).is_none_or(|key| key.width > width));
        }
        assert_eq!(Keyway::of_shaft(6.0), Some(Keyway { width: 2.0, depth: 1.0 }));
        for wrong in [5.9, 230.1, f64::NAN] {
            assert_eq!(Keyway::of_shaft(wrong), None);
        }
    }

    #[test]
    fn a_tapped_hole_is_the_diameter_less_the_pitch() {
        // Pitches of ISO 261, coarse; drills have a decimal.
        for (thread, pitch) in
            Thread::ALL.into_iter().zip([50, 70, 80, 100, 125].map(|hundredths| f64::from(hundredths) / 100.0))
        {
            let drill: f64 = thread.diameter() - pitch;
            assert!((thread.tapping_hole() - drill).abs() <= 0.05 + 1e-12, "{thread:?}");
            assert!(thread.clearance_hole() > thread.diameter());
            assert_eq!(Thread::from_name(thread.name()), Some(thread));
        }
    }
}
