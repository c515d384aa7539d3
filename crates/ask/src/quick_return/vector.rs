//! A vector in the plane as data, with a direction if it has one.

use crate::{DataRow, FieldValue};
use geneva_kinematics::Turn;

/// Units in the last place, relative to what a difference was taken of, that cannot be told from zero.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Length, direction and components. The direction is missing if the vector is zero, as near as can be told.
#[derive(Clone, Debug, PartialEq)]
pub struct Vector {
    pub magnitude: f64,
    pub direction_deg: Option<f64>,
    pub x: f64,
    pub y: f64,
}

impl Vector {
    /// The vector with these components.
    pub fn new(x: f64, y: f64) -> Self {
        // A zero has no sign, or a half turn would be sometimes 180° and sometimes −180°.
        let (x, y) = (x + 0.0, y + 0.0);
        let magnitude = (x * x + y * y).sqrt();
        let direction_deg = (magnitude > 0.0).then(|| Turn { cos: x, sin: y }.degrees());
        Self { magnitude, direction_deg, x, y }
    }

    /// Drops the direction if the vector is known to be zero but for rounding.
    pub fn zero_if(self, known: bool) -> Self {
        Self { direction_deg: self.direction_deg.filter(|_| !known), ..self }
    }

    /// Drops the direction if the vector is a difference of vectors of this size and no more than their rounding.
    pub fn zero_below(self, size: f64) -> Self {
        let lost = self.magnitude <= ROUNDING * size;
        self.zero_if(lost)
    }
}

impl From<&Vector> for FieldValue {
    fn from(vector: &Vector) -> Self {
        Self::Object(DataRow(vec![
            ("magnitude", vector.magnitude.into()),
            ("direction_deg", vector.direction_deg.into()),
            ("x", vector.x.into()),
            ("y", vector.y.into()),
        ]))
    }
}

#[cfg(test)]
mod tests {
    use super::Vector;

    #[test]
    fn a_direction_is_there_if_the_vector_is() {
        let vector = Vector::new(-3.0, 4.0);
        assert_eq!(vector.magnitude, 5.0);
        assert!(vector.direction_deg.is_some_and(|direction| direction > 90.0 && direction < 180.0));
        assert_eq!(Vector::new(-2.0, -0.0).direction_deg, Some(180.0));
        assert_eq!(Vector::new(0.0, -0.0).direction_deg, None);
        assert_eq!(vector.clone().zero_below(1e9), vector);
        assert_eq!(vector.clone().zero_below(1e17), Vector { direction_deg: None, ..vector });
    }
}
