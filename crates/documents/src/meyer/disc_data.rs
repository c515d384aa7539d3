//! The numbers from which the thesis estimates the inertias, and the dimensions of what it estimates.

use crate::MEYER;
use geneva_evidence::{Dimension as Exponents, numeric_tokens};

/// The numbers of the estimate.
pub(super) struct Data<T> {
    pub density: T,
    pub gravity: T,
    pub diameter: T,
    pub thickness: T,
}

impl Data<String> {
    /// As the sentences around the estimate print them.
    pub(super) fn in_sentences() -> Option<Self> {
        let first = |id: &str| MEYER.printed_text(id).split(' ').next().map(str::to_owned);
        let [diameter, thickness] = numeric_tokens(MEYER.printed_text("meyer.like-discs")).try_into().ok()?;
        Some(Self { density: first("meyer.steel")?, gravity: first("meyer.gravity")?, diameter, thickness })
    }

    pub(super) fn map<T>(self, read: impl Fn(&str) -> Option<T>) -> Option<Data<T>> {
        Some(Data {
            density: read(&self.density)?,
            gravity: read(&self.gravity)?,
            diameter: read(&self.diameter)?,
            thickness: read(&self.thickness)?,
        })
    }
}

/// The data as the sentences around the estimate state them.
pub(super) fn data_of_the_sentences() -> Option<Data<f64>> {
    Data::in_sentences()?.map(|number| number.parse().ok())
}

/// A length to this power.
pub(super) fn volume(power: u32) -> Exponents {
    (0..power).fold(Exponents::NONE, |product, _| product * Exponents::LENGTH)
}

/// A force over an acceleration.
pub(super) fn mass() -> Exponents {
    Exponents::FORCE * Exponents::TIME * Exponents::TIME / Exponents::LENGTH
}
