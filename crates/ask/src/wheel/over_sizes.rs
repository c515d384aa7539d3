//! The loads of a wheel in other sizes.

use super::design::WheelDesign;
use super::question::WheelQuestion;
use super::recommended::preferred_numbers;
use geneva_figures::Figure;
use geneva_figures::stations::{LoadsAtSize, over_sizes};

/// How much smaller and larger the sizes are between which loads are compared.
const COMPARED: f64 = 2.0;

impl WheelDesign {
    /// The loads of the same wheel in other sizes: at the preferred numbers (ISO 3, R20) from half of the crank radius to twice
    /// as much, and at its own. What is given in millimetres besides the size stays. Empty without a size, a speed or an inertia;
    /// sizes that don't fit are left out.
    pub fn loads_over_sizes(&self) -> Vec<LoadsAtSize> {
        let Some(own) = self.sizes.map(|sizes| sizes.crank_radius) else { return Vec::new() };
        let range = own / COMPARED..=own * COMPARED;
        let mut radii: Vec<f64> =
            preferred_numbers().filter(|radius| range.contains(radius) && *radius != own).collect();
        radii.push(own);
        radii.sort_by(f64::total_cmp);
        radii.into_iter().filter_map(|radius| self.loads_at(radius)).collect()
    }

    fn loads_at(&self, crank_radius: f64) -> Option<LoadsAtSize> {
        let question = WheelQuestion {
            crank_radius: Some(crank_radius),
            centre_distance: None,
            wheel_radius: None,
            outside_diameter: None,
            ..self.question.clone()
        };
        let design = Self::new(question).ok()?;
        let loads = design.loads(design.wheel.indexing()).ok()??;
        Some(LoadsAtSize {
            crank_radius,
            pin_force: design.force(loads.pin_moment().driving.value)?,
            crank_torque: loads.crank_torque().driving.value,
            wheel_inertia: design.wheel_inertia?,
            inertia: design.inertia?,
        })
    }

    /// The loads over the size as a figure, if there are some.
    pub fn sizes_figure(&self) -> Option<Figure> {
        over_sizes(&self.loads_over_sizes(), self.sizes?.crank_radius)
    }
}
