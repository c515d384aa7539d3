//! The sections of a report.

use crate::judge::chain_verdict::ChainVerdict;

/// The section of a report in which a finding stands. JSON calls it `list`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ReportSection {
    /// Printed numbers that do not follow from what is printed beside them.
    Numbers,
    /// Numbers that agree although their units do not.
    Units,
    /// Differences that show only with values given elsewhere in the text.
    Bindings,
    /// Pairs in which nothing is wrong, kept only on request.
    Agreeing,
    /// Differences that are set aside: the program may have misread the text, or the result is truncated.
    Doubts,
    /// p-values, confidence intervals, shares and totals that do not follow from the numbers beside them.
    Statistics,
    /// Printed numbers that do not follow from what is printed beside them, where that is less often a fault of the text.
    LessCertain,
}

impl ReportSection {
    /// The section of a verdict; `bound` says that values from elsewhere in the text were used.
    pub(crate) fn for_verdict(verdict: ChainVerdict, bound: bool) -> Self {
        match verdict {
            ChainVerdict::Truncated
            | ChainVerdict::LastDigit
            | ChainVerdict::Inconsistent
            | ChainVerdict::Dimensions => {
                if bound {
                    Self::Bindings
                } else {
                    Self::Numbers
                }
            }
            ChainVerdict::Units if !bound => Self::Units,
            _ => Self::Agreeing,
        }
    }

    /// A name for programs.
    pub fn name(self) -> &'static str {
        match self {
            Self::Numbers => "numbers",
            Self::Units => "units",
            Self::Bindings => "bindings",
            Self::Agreeing => "agreeing",
            Self::Doubts => "doubts",
            Self::Statistics => "statistics",
            Self::LessCertain => "less-certain",
        }
    }
}
