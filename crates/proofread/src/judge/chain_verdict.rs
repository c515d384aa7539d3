//! How two sides compare, in words for programs and for readers.

/// How two neighbouring sides compare, from the best to the worst. The best over all readings counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ChainVerdict {
    /// The printed digits of one side give the other one to its printed digits.
    Consistent,
    /// The sides agree if the printed numbers had more digits than they show.
    Rounded,
    /// The result was cut off where it should have been rounded.
    Truncated,
    /// Behind `≈`, and within five per cent.
    Approximate,
    /// The sides agree only if integers were rounded to tens.
    Doubtful,
    /// The numbers agree, their units do not.
    Units,
    /// The last printed digit differs by one.
    LastDigit,
    /// The sides differ.
    Inconsistent,
    /// Both the numbers and the dimensions differ.
    Dimensions,
    /// One of the sides could not be evaluated.
    CannotEvaluate,
}

impl ChainVerdict {
    /// Every verdict, the best first.
    pub const ALL: [Self; 10] = [
        Self::Consistent,
        Self::Rounded,
        Self::Truncated,
        Self::Approximate,
        Self::Doubtful,
        Self::Units,
        Self::LastDigit,
        Self::Inconsistent,
        Self::Dimensions,
        Self::CannotEvaluate,
    ];

    /// A name for programs.
    pub fn name(self) -> &'static str {
        match self {
            Self::Consistent => "consistent",
            Self::Rounded => "rounded",
            Self::Truncated => "truncated",
            Self::Approximate => "approximate",
            Self::Doubtful => "doubtful",
            Self::Units => "units",
            Self::LastDigit => "last-digit",
            Self::Inconsistent => "inconsistent",
            Self::Dimensions => "dimensions",
            Self::CannotEvaluate => "cannot-evaluate",
        }
    }

    /// The verdict of this name.
    ///
    /// ```
    /// use proofread::ChainVerdict;
    ///
    /// assert_eq!(ChainVerdict::from_name("last-digit"), Some(ChainVerdict::LastDigit));
    /// assert!(ChainVerdict::ALL.iter().all(|verdict| ChainVerdict::from_name(verdict.name()) == Some(*verdict)));
    /// ```
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|verdict| verdict.name() == name)
    }

    /// The verdict in words for a reader.
    ///
    /// ```
    /// assert_eq!(proofread::ChainVerdict::LastDigit.description(), "the last digit differs");
    /// ```
    pub fn description(self) -> &'static str {
        match self {
            Self::Consistent => "the two sides agree",
            Self::Rounded => "the two sides agree if the steps were rounded",
            Self::Truncated => "the result is truncated, not rounded",
            Self::Approximate => "the two sides agree approximately",
            Self::Doubtful => "the two sides may agree",
            Self::Units => "the numbers agree, but the units do not",
            Self::LastDigit => "the last digit differs",
            Self::Inconsistent => "the two sides differ",
            Self::Dimensions => "the two sides differ in their numbers and in their dimensions",
            Self::CannotEvaluate => "one of the two sides cannot be evaluated",
        }
    }
}
