//! The least change of a single size with which a wheel that jams turns.

use super::errors::BuiltError;
use super::measured::MeasuredSize;
use super::parts::AsBuiltWheel;
use crate::bisection::bisect_times;

/// A change of one size, of all slots, arcs or pins alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeChange {
    /// Which size.
    pub size: MeasuredSize,
    /// By how much, in millimetres; below zero it becomes smaller.
    pub by: f64,
}

/// What can still be changed of a made wheel, and in which sense: the axes, the pin, the slots, the disc with its cuts.
const CHANGES: [(MeasuredSize, f64); 9] = [
    (MeasuredSize::CentreDistance, 1.0),
    (MeasuredSize::CentreDistance, -1.0),
    (MeasuredSize::PinDiameter, -1.0),
    (MeasuredSize::SlotWidth(None), 1.0),
    (MeasuredSize::SlotEnd(None), -1.0),
    (MeasuredSize::ArcRadius(None), 1.0),
    (MeasuredSize::DiscRadius, -1.0),
    (MeasuredSize::CrescentRadius, 1.0),
    (MeasuredSize::TipRadius, -1.0),
];

/// The greatest change that is tried, over the pin's diameter, in how many steps, and halvings of the first with which it turns.
const MOST: f64 = 0.4;
const STEPS: u32 = 16;
const HALVINGS: u32 = 16;

/// By how much more of a change the wheel must turn, too, over the change: our choice.
const MORE: f64 = 0.05;

impl AsBuiltWheel {
    /// The single changes with which a wheel that jams turns, the least first; none for one that turns. Changes of up to 0.4 of the
    /// pin's diameter are tried.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::{AsBuiltWheel, MeasuredSize};
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
    /// let mut built = AsBuiltWheel::from(&sizes);
    /// built.disc_radius = built.disc_radius.map(|disc| disc + 0.3); // mm: 0.2 mm more than its gap
    /// let changes = built.least_changes()?;
    /// let disc = changes.iter().find(|change| change.size == MeasuredSize::DiscRadius).ok_or("a smaller disc will do")?;
    /// assert!((disc.by + 0.2).abs() < 0.01 && changes[0].by.abs() <= disc.by.abs());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`check`](Self::check).
    pub fn least_changes(&self) -> Result<Vec<SizeChange>, BuiltError> {
        if self.turns()? {
            return Ok(Vec::new());
        }
        let most = MOST * self.pins().iter().map(|pin| pin.diameter).fold(0.0, f64::max);
        let mut found: Vec<SizeChange> = CHANGES
            .iter()
            .filter_map(|(size, sign)| {
                // A change that makes a size impossible is none.
                let jams = |by: f64| !self.changed(SizeChange { size: *size, by: sign * by }).turns().unwrap_or(false);
                let at = |k: u32| most * f64::from(k) / f64::from(STEPS);
                let first = (1..=STEPS).find(|k| !jams(at(*k)))?;
                let [_, by] = bisect_times(HALVINGS, [at(first - 1), at(first)], jams);
                // A maker takes a little more, for play.
                (!jams(by * (1.0 + MORE))).then_some(SizeChange { size: *size, by: sign * by })
            })
            .collect();
        found.sort_by(|one, other| one.by.abs().total_cmp(&other.by.abs()));
        Ok(found)
    }

    /// The wheel with all sizes of a kind changed by as much.
    #[must_use]
    pub fn changed(&self, SizeChange { size, by }: SizeChange) -> Self {
        let mut other = self.clone();
        match size {
            MeasuredSize::CentreDistance => other.centre_distance += by,
            MeasuredSize::PinDiameter => other.pins_mut().iter_mut().for_each(|pin| pin.diameter += by),
            MeasuredSize::SlotWidth(_) => other.slots_mut().iter_mut().for_each(|slot| slot.width += by),
            MeasuredSize::SlotEnd(_) => other.slots_mut().iter_mut().for_each(|slot| slot.end += by),
            MeasuredSize::TipRadius => other.slots_mut().iter_mut().for_each(|slot| slot.tip_radius += by),
            MeasuredSize::ArcRadius(_) => other.arcs_mut().iter_mut().for_each(|arc| arc.radius += by),
            MeasuredSize::DiscRadius => other.disc_radius = other.disc_radius.map(|disc| disc + by),
            MeasuredSize::CrescentRadius => other.pins_mut().iter_mut().for_each(|pin| pin.crescent.radius += by),
            _ => {}
        }
        other
    }
}
