//! Sizes of sheets and scales of drawings.

/// A sheet of paper, with its longer side across: ISO 5457.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paper {
    /// 297 mm by 210 mm.
    A4,
    /// 420 mm by 297 mm.
    A3,
}

impl Paper {
    /// Its width and height, in millimetres.
    pub fn size(self) -> [f64; 2] {
        match self {
            Self::A4 => [297.0, 210.0],
            Self::A3 => [420.0, 297.0],
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::A4 => "A4",
            Self::A3 => "A3",
        }
    }
}

/// The scale of a drawing: so many millimetres on paper for so many of the part.
///
/// ```
/// use geneva_workshop::DrawingScale;
///
/// let half = DrawingScale::largest(60.0, 100.0).expect("one of the standard");
/// assert_eq!((half.to_string(), half.factor()), ("1:2".to_owned(), 0.5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DrawingScale {
    /// Millimetres on paper.
    pub drawn: u32,
    /// Millimetres of the part.
    pub real: u32,
}

/// The scales of ISO 5455 in falling order, without those beyond 50 : 1, and further ones of its series for very large parts.
const SCALES: [[u32; 2]; 18] = [
    [50, 1],
    [20, 1],
    [10, 1],
    [5, 1],
    [2, 1],
    [1, 1],
    [1, 2],
    [1, 5],
    [1, 10],
    [1, 20],
    [1, 50],
    [1, 100],
    [1, 200],
    [1, 500],
    [1, 1000],
    [1, 2000],
    [1, 5000],
    [1, 10000],
];

impl DrawingScale {
    /// The largest scale of ISO 5455 in which a length of a part fits into a length on paper, both in millimetres; none for a
    /// part longer than 10 000 times that, or without a length.
    pub fn largest(paper: f64, part: f64) -> Option<Self> {
        let of = SCALES.into_iter().map(|[drawn, real]| Self { drawn, real });
        of.into_iter().find(|scale| scale.factor() * part <= paper)
    }

    /// Length on paper over length of the part, dimensionless.
    pub fn factor(self) -> f64 {
        f64::from(self.drawn) / f64::from(self.real)
    }
}

impl std::fmt::Display for DrawingScale {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}:{}", self.drawn, self.real)
    }
}
