//! Readings: the ways in which the same characters may be meant.

use crate::order::sort_by_place;

/// A set of choices. Without any, a formula is read in the commonest way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) struct ReadingChoices(u32);

impl ReadingChoices {
    /// The commonest way.
    pub(crate) const USUAL: Self = Self(0);
    /// A bare argument of a trigonometric function is in degrees.
    pub(crate) const DEGREES: Self = Self(1);
    /// A revolution counts as one, not as 2π.
    pub(crate) const TURNS: Self = Self(1 << 1);
    /// Degrees Celsius and Fahrenheit are points of the scale, not differences.
    pub(crate) const POINTS: Self = Self(1 << 2);
    /// A number before a fraction is a mixed number, not a product.
    pub(crate) const MIXED: Self = Self(1 << 3);
    /// Of ± the minus is meant.
    pub(crate) const MINUS: Self = Self(1 << 4);
    /// A unit behind `a/b` belongs to the quotient, not to `b`.
    pub(crate) const QUOTIENT: Self = Self(1 << 5);
    /// `rad` is the unit of a dose.
    pub(crate) const DOSE: Self = Self(1 << 6);
    /// A number in brackets at the end is the number of the equation.
    pub(crate) const TAG: Self = Self(1 << 7);
    /// Of the units behind a stroke, only the first is below it.
    pub(crate) const ONE_BELOW: Self = Self(1 << 8);
    /// A unit counts as one, so that only numbers are compared.
    pub(crate) const NUMBERS: Self = Self(1 << 9);
    /// Everything that follows a stroke without a sign between is below it: `1/2π` is 1 over 2π.
    pub(crate) const ALL_BELOW: Self = Self(1 << 10);
    /// Electrons, protons and ions count as their charge.
    pub(crate) const CHARGES: Self = Self(1 << 11);
    /// Pounds and ounces are a mass, not a force.
    pub(crate) const POUNDS: Self = Self(1 << 12);
    /// A logarithm without a base is the natural one.
    pub(crate) const NATURAL: Self = Self(1 << 13);
    /// A percentage that is added is one of what stands before it.
    pub(crate) const PERCENT: Self = Self(1 << 14);
    /// A hertz is a turn in a second, 2π in angular measure.
    pub(crate) const CYCLES: Self = Self(1 << 15);
    /// A stroke ends the argument of a logarithm: `ln 2/5` is one fifth of ln 2.
    pub(crate) const LOGARITHM_ABOVE: Self = Self(1 << 16);
    /// A percentage is a factor: also where it stands in brackets behind a number, and where no other unit counts.
    pub(crate) const SHARE: Self = Self(1 << 17);

    /// An exponent of zero is a degree sign: `26^0`.
    pub(crate) const ZERO_DEGREES: Self = Self(1 << 18);

    /// An exponent behind the brackets of a function's argument belongs to the function: `ln(2)^2` is the square of ln 2.
    pub(crate) const POWER_OUTSIDE: Self = Self(1 << 19);

    /// The remainder is one of the factor before it alone, and has its sign: `2 + 17 mod 5` is 4.
    pub(crate) const REMAINDER_OF_FACTOR: Self = Self(1 << 20);

    /// A sum over an index goes on behind the next plus or minus sign.
    pub(crate) const SUM_OF_ALL: Self = Self(1 << 21);

    /// Whether all choices of another set are in this one.
    pub(crate) fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// Adds the choices of another set.
    pub(crate) fn insert(&mut self, other: Self) {
        self.0 |= other.0;
    }

    /// Both sets together.
    #[must_use]
    pub(crate) fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The sets of at most `most` of the choices in this one, the smallest first.
    pub(crate) fn subsets(self, most: u32) -> Vec<Self> {
        let mut out = Vec::new();
        let mut subset = self.0;
        loop {
            if subset.count_ones() <= most {
                out.push(Self(subset));
            }
            if subset == 0 {
                break;
            }
            subset = (subset - 1) & self.0;
        }
        sort_by_place(&mut out, |of| (of.0.count_ones() as usize, of.0 as usize));
        out
    }

    /// The choices in words.
    pub(crate) fn descriptions(self) -> Vec<&'static str> {
        const WORDS: [(ReadingChoices, &str); 21] = [
            (ReadingChoices::DEGREES, "angles in degrees"),
            (ReadingChoices::TURNS, "a revolution counted as 1"),
            (ReadingChoices::POINTS, "temperatures on the scale"),
            (ReadingChoices::MIXED, "a mixed number"),
            (ReadingChoices::MINUS, "the minus of ±"),
            (ReadingChoices::QUOTIENT, "the unit of the whole quotient"),
            (ReadingChoices::DOSE, "rad as the unit of a dose"),
            (ReadingChoices::TAG, "the number of an equation at the end"),
            (ReadingChoices::ONE_BELOW, "one unit below the stroke"),
            (ReadingChoices::ALL_BELOW, "all factors behind the stroke below it"),
            (ReadingChoices::CHARGES, "particles counted as their charge"),
            (ReadingChoices::POUNDS, "pounds as a mass"),
            (ReadingChoices::NATURAL, "natural logarithms"),
            (ReadingChoices::CYCLES, "a hertz as a turn in a second"),
            (ReadingChoices::LOGARITHM_ABOVE, "the logarithm above the stroke"),
            (ReadingChoices::PERCENT, "a percentage of what stands before it"),
            (ReadingChoices::ZERO_DEGREES, "an exponent of zero as a degree sign"),
            (ReadingChoices::SHARE, "a percentage as a factor"),
            (ReadingChoices::POWER_OUTSIDE, "a power of the function"),
            (ReadingChoices::REMAINDER_OF_FACTOR, "the remainder of one factor"),
            (ReadingChoices::SUM_OF_ALL, "all that follows under the sign of the sum"),
        ];
        WORDS.iter().filter(|(choice, _)| self.contains(*choice)).map(|(_, words)| *words).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subsets_begin_with_the_usual_reading() {
        let of = ReadingChoices::DEGREES.union(ReadingChoices::MIXED).union(ReadingChoices::TAG);
        let subsets = of.subsets(2);
        assert_eq!((subsets.len(), subsets[0]), (7, ReadingChoices::USUAL));
        assert!(subsets.iter().all(|subset| of.contains(*subset)));
        assert_eq!(of.descriptions().len(), 3);
    }
}
