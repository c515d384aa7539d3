//! Wear that may be chance: a size is no longer what it was when it was new, but by less than its uncertainty tells.

use super::measured::{MeasuredSize, MeasuredWheel, SizeMeasurement};
use super::nearest::{NearestWheel, single_limit};

/// A size that seems worn by less than its uncertainty and that of the size when new can tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UncertainWear {
    /// What seems worn.
    pub size: MeasuredSize,
    /// The wear that there seems to be, in millimetres: that of the worst slot or arc.
    pub wear: f64,
    /// The wear from which it would be told, in millimetres.
    pub certain_from: f64,
    /// The standard uncertainty of both sizes, in millimetres, with which this wear would be told.
    pub needed_uncertainty: f64,
}

/// Differences in millimetres that are rounding.
const ROUNDING: f64 = 1e-9;

impl MeasuredWheel {
    /// The sizes that seem worn against what they were when they were new, but not for certain.
    ///
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    /// use geneva_kinematics::wheel::as_built::{MeasuredSize, MeasuredWheel};
    ///
    /// let mut measured = MeasuredWheel::new(Wheel::new(6)?);
    /// measured.add(MeasuredSize::CrankRadius, 25.0, 0.05)?; // mm
    /// measured.add(MeasuredSize::SlotWidth(None), 8.1, 0.05)?;
    /// measured.add(MeasuredSize::NewSlotWidth, 8.0, 0.05)?;
    /// let wear = measured.uncertain_wear(&measured.nearest()?);
    /// assert!((wear[0].wear - 0.1).abs() < 1e-9 && wear[0].needed_uncertainty < 0.03);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn uncertain_wear(&self, nearest: &NearestWheel) -> Vec<UncertainWear> {
        use MeasuredSize as Size;
        let worn = [Size::SlotWidth(None), Size::PinDiameter, Size::ArcRadius(None), Size::DiscRadius];
        worn.into_iter().filter_map(|size| self.uncertain_wear_of(size, nearest)).collect()
    }

    fn uncertain_wear_of(&self, size: MeasuredSize, nearest: &NearestWheel) -> Option<UncertainWear> {
        let mut culprits = nearest.culprit.iter().chain(&nearest.further_culprits);
        if culprits.any(|culprit| culprit.size.name() == size.name()) {
            return None;
        }
        let new = self.sizes().iter().find(|of| Some(of.size) == size.size_when_new())?;
        // Hollows become wider, what runs in them thinner.
        let sense = if size.size_of_all().is_some() { 1.0 } else { -1.0 };
        let wear = |of: &SizeMeasurement| sense * (of.value - new.value);
        let all = self.sizes().iter().filter(|of| of.size.name() == size.name());
        let worst = all.max_by(|one, other| wear(one).total_cmp(&wear(other)))?;
        let (wear, factor) = (wear(worst), single_limit(self.sizes().len()).sqrt());
        (wear > ROUNDING).then(|| UncertainWear {
            size,
            wear,
            certain_from: factor * libm::hypot(worst.uncertainty, new.uncertainty),
            needed_uncertainty: wear / (factor * std::f64::consts::SQRT_2),
        })
    }
}
