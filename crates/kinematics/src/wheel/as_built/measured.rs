//! Measured sizes of a wheel and its driver, any of them, each with its uncertainty.

use super::errors::MeasuredError;
use crate::indexing::Indexing;
use crate::wheel::Wheel;

/// A size that can be measured. A number tells which slot or arc, counter-clockwise from 0; without one, all are meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredSize {
    /// Distance between the axes, in millimetres.
    CentreDistance,
    /// Distance of a pin's centre from the driver's axis, in millimetres.
    CrankRadius,
    /// Diameter of the pins, in millimetres.
    PinDiameter,
    /// Radius of the wheel's rim, in millimetres: half the outside diameter.
    TipRadius,
    /// Width of a slot, in millimetres.
    SlotWidth(Option<usize>),
    /// Distance of the centre of a slot's round end from the wheel's axis, in millimetres.
    SlotEnd(Option<usize>),
    /// Direction of a slot's middle, in radians counter-clockwise of its right direction between the locking arcs.
    SlotDirection(usize),
    /// Radius of a locking arc, in millimetres.
    ArcRadius(Option<usize>),
    /// Distance of a locking arc's centre from the wheel's axis, in millimetres.
    ArcCentre(Option<usize>),
    /// Radius of the locking disc, in millimetres.
    DiscRadius,
    /// Distance of the crescent's centre from the driver's axis, in millimetres.
    CrescentCentre,
    /// Radius of the crescent, in millimetres.
    CrescentRadius,
    /// Diameter of the pins when they were new, in millimetres.
    NewPinDiameter,
    /// Width of the slots when they were new, in millimetres.
    NewSlotWidth,
    /// Radius of the locking arcs when they were new, in millimetres.
    NewArcRadius,
    /// Radius of the locking disc when it was new, in millimetres.
    NewDiscRadius,
}

impl MeasuredSize {
    /// What it is, in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::CentreDistance => "centre distance",
            Self::CrankRadius => "crank radius",
            Self::PinDiameter => "pin diameter",
            Self::TipRadius => "radius of the rim",
            Self::SlotWidth(_) => "slot width",
            Self::SlotEnd(_) => "slot end",
            Self::SlotDirection(_) => "slot direction",
            Self::ArcRadius(_) => "locking arc's radius",
            Self::ArcCentre(_) => "locking arc's centre",
            Self::DiscRadius => "locking disc's radius",
            Self::CrescentCentre => "crescent's centre",
            Self::CrescentRadius => "crescent's radius",
            Self::NewPinDiameter => "pin diameter when new",
            Self::NewSlotWidth => "slot width when new",
            Self::NewArcRadius => "locking arc's radius when new",
            Self::NewDiscRadius => "locking disc's radius when new",
        }
    }

    /// Which slot or arc it is of, from 0; none if of all, or of neither.
    pub fn number(self) -> Option<usize> {
        match self {
            Self::SlotWidth(number) | Self::SlotEnd(number) | Self::ArcRadius(number) | Self::ArcCentre(number) => {
                number
            }
            Self::SlotDirection(number) => Some(number),
            _ => None,
        }
    }

    /// This width of a slot or radius of an arc, of all of them; none for other sizes.
    pub fn size_of_all(self) -> Option<Self> {
        match self {
            Self::SlotWidth(_) => Some(Self::SlotWidth(None)),
            Self::ArcRadius(_) => Some(Self::ArcRadius(None)),
            _ => None,
        }
    }

    /// The size that this one was when it was new, for those that wear; none for the others.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::MeasuredSize;
    ///
    /// assert_eq!(MeasuredSize::SlotWidth(Some(2)).size_when_new(), Some(MeasuredSize::NewSlotWidth));
    /// assert_eq!(MeasuredSize::CentreDistance.size_when_new(), None);
    /// ```
    pub fn size_when_new(self) -> Option<Self> {
        match self {
            Self::PinDiameter => Some(Self::NewPinDiameter),
            Self::SlotWidth(_) => Some(Self::NewSlotWidth),
            Self::ArcRadius(_) => Some(Self::NewArcRadius),
            Self::DiscRadius => Some(Self::NewDiscRadius),
            _ => None,
        }
    }

    /// Whether it says how large a part was when it was new. The part is no longer so, so the size itself is never wrong.
    pub fn is_when_new(self) -> bool {
        matches!(self, Self::NewPinDiameter | Self::NewSlotWidth | Self::NewArcRadius | Self::NewDiscRadius)
    }
}

/// A measured size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeMeasurement {
    /// What was measured.
    pub size: MeasuredSize,
    /// Its value, in millimetres, or radians for a direction.
    pub value: f64,
    /// Its standard uncertainty, in the same unit.
    pub uncertainty: f64,
}

/// Measured sizes of a wheel of known stations and pins.
///
/// ```
/// use geneva_kinematics::wheel::Wheel;
/// use geneva_kinematics::wheel::as_built::{MeasuredSize, MeasuredWheel};
///
/// let mut measured = MeasuredWheel::new(Wheel::new(6)?);
/// measured.add(MeasuredSize::CentreDistance, 100.0, 0.05)?; // mm
/// measured.add(MeasuredSize::CrankRadius, 50.0, 0.05)?;
/// measured.add(MeasuredSize::TipRadius, 88.0, 0.05)?; // with a slot of 10.2 mm it should be 86.75 mm
/// measured.add(MeasuredSize::SlotWidth(None), 10.2, 0.05)?;
/// measured.add(MeasuredSize::PinDiameter, 10.0, 0.05)?;
/// let nearest = measured.nearest()?;
/// assert_eq!(nearest.culprit.map(|culprit| culprit.size), Some(MeasuredSize::TipRadius));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredWheel {
    wheel: Wheel,
    sizes: Vec<SizeMeasurement>,
}

impl MeasuredWheel {
    /// A wheel of which nothing is measured yet.
    pub fn new(wheel: Wheel) -> Self {
        Self { wheel, sizes: Vec::new() }
    }

    /// The numbers of stations and pins.
    pub fn wheel(&self) -> &Wheel {
        &self.wheel
    }

    /// All that is measured, in the order in which it was added.
    pub fn sizes(&self) -> &[SizeMeasurement] {
        &self.sizes
    }

    /// Adds a measured size with its standard uncertainty, in millimetres, or radians for a direction.
    ///
    /// # Errors
    ///
    /// [`MeasuredError`] for a length or an uncertainty that is not positive and finite, and for a slot or an arc that there is not.
    pub fn add(&mut self, size: MeasuredSize, value: f64, uncertainty: f64) -> Result<(), MeasuredError> {
        let is_length = !matches!(size, MeasuredSize::SlotDirection(_));
        if !value.is_finite() || (is_length && value <= 0.0) {
            return Err(MeasuredError::Value { name: size.name(), asked: value });
        }
        if !(uncertainty > 0.0 && uncertainty.is_finite()) {
            return Err(MeasuredError::Uncertainty { name: size.name(), asked: uncertainty });
        }
        let stations = self.wheel.stations() as usize;
        if let Some(number) = size.number().filter(|number| *number >= stations) {
            return Err(MeasuredError::Number { name: size.name(), asked: number + 1, most: stations });
        }
        self.sizes.push(SizeMeasurement { size, value, uncertainty });
        Ok(())
    }

    /// The wheel without one of its measurements.
    pub(super) fn without(&self, index: usize) -> Self {
        let mut others = self.clone();
        if index < others.sizes.len() {
            others.sizes.remove(index);
        }
        others
    }

    /// The wheel with these of its measurements only, by their places.
    pub(super) fn only(&self, places: &[usize]) -> Self {
        let sizes = places.iter().filter_map(|place| self.sizes.get(*place)).copied().collect();
        Self { wheel: self.wheel, sizes }
    }

    /// The least and the greatest of what is measured of a size or of one like it, of whatever number; none if nothing is.
    pub(super) fn extremes(&self, is_it: impl Fn(MeasuredSize) -> bool) -> Option<[f64; 2]> {
        let values = self.sizes().iter().filter(|of| is_it(of.size)).map(|of| of.value);
        values.fold(None, |found: Option<[f64; 2]>, value| {
            Some(found.map_or([value, value], |[least, most]| [least.min(value), most.max(value)]))
        })
    }

    /// Whether a size was measured, of whatever number.
    pub(super) fn has(&self, is_it: impl Fn(MeasuredSize) -> bool) -> bool {
        self.sizes.iter().any(|of| is_it(of.size))
    }

    /// These sizes for a wheel with another number of stations; none if a size is of a slot or an arc that it doesn't have.
    pub(super) fn with_wheel(&self, wheel: Wheel) -> Option<Self> {
        let stations = wheel.stations() as usize;
        let fits = self.sizes.iter().all(|of| of.size.number().is_none_or(|number| number < stations));
        fits.then(|| Self { wheel, sizes: self.sizes.clone() })
    }

    /// The mean of what is measured of a size or of one like it, of whatever number; none if nothing is.
    pub(super) fn mean(&self, is_it: impl Fn(MeasuredSize) -> bool) -> Option<f64> {
        let values: Vec<f64> = self.sizes.iter().filter(|of| is_it(of.size)).map(|of| of.value).collect();
        (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
    }
}
