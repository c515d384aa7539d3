//! The tolerances that are not printed digits. A kind of evidence may bring one of its own.

/// A relative tolerance with its reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// What it is for.
    pub name: &'static str,
    /// Largest relative difference.
    pub relative: f64,
    /// Why so large and no larger.
    pub reason: &'static str,
}

/// For deciding on which side of a rounding boundary a floating-point result lies.
pub static ARITHMETIC: Tolerance = Tolerance {
    name: "arithmetic",
    relative: 1e-14,
    reason: "a chain of a dozen correctly rounded operations and a few library functions is wrong by at most some ten \
             units in the last place. So if a value is closer than this to the edge of the printed interval, we count \
             it as on the edge",
};

/// For two independent routes to one number.
pub static ROUTES: Tolerance = Tolerance {
    name: "routes",
    relative: 1e-12,
    reason: "two routes round differently, and where one of them subtracts nearly equal numbers it may lose two to \
             three of the sixteen decimal digits, but a wrong formula differs in the first few digits",
};

/// For derivatives that are taken as differences of printed characters evaluated nearby.
pub static DIFFERENCES: Tolerance = Tolerance {
    name: "differences",
    relative: 1e-9,
    reason: "a difference over a step of a thousandth loses three of the sixteen digits, and some more where the \
             quantities change quickly, but a misprint differs in the first few digits",
};

/// For quantities that must vanish, in units of the quantities' own size: what is left of rounding.
pub static CLOSURE: Tolerance = Tolerance {
    name: "closure",
    relative: 1e-12,
    reason: "if two equal numbers of the order of 1 are each computed with an error of a few units in the last \
             place, their difference is not zero, but it is about a thousand times smaller than this tolerance. A \
             wrong formula, however, leaves a difference that is a considerable fraction of these numbers",
};

impl Tolerance {
    /// Whether two numbers agree, relative to the larger.
    pub fn agrees(&self, a: f64, b: f64) -> bool {
        (a - b).abs() <= self.relative * a.abs().max(b.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agreement_is_relative_and_refuses_what_is_not_a_number() {
        assert!(ROUTES.agrees(1e9, 1e9 + 1e-4));
        assert!(!ROUTES.agrees(1.0, 1.0 + 1e-11));
        assert!(!ROUTES.agrees(f64::NAN, f64::NAN));
    }
}
