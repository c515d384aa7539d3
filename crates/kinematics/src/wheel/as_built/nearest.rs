//! The right wheel that is nearest to measured sizes, and the measurements that contradict it.
//!
//! A measurement is a culprit if the sum of squares falls by more than chance allows when it is left out. The one without which the
//! others agree best goes first, then the next, until the rest agrees. The nearest right wheel is the fit to that rest, so what it has
//! in the culprit's place is what the others ask for.

use super::errors::MeasuredError;
use super::measured::{MeasuredSize, MeasuredWheel, SizeMeasurement};
use super::parts::{AsBuiltWheel, BuiltArc, BuiltCrescent, BuiltPin, BuiltSlot};
use super::right_wheel::{Free, Right, design};
use crate::indexing::Indexing;
use crate::wheel::{SizesError, Wheel};

/// Culprits that are looked for at most: our choice.
const MOST_CULPRITS: usize = 6;

/// A measurement against the nearest right wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// What was measured.
    pub measured: SizeMeasurement,
    /// What the nearest right wheel has there, in millimetres or radians.
    pub right: f64,
    /// Measured less right, over the uncertainty, dimensionless.
    pub normalized: f64,
}

/// The measurement that contradicts the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Culprit {
    /// Which size.
    pub size: MeasuredSize,
    /// What was measured, in millimetres or radians.
    pub measured: f64,
    /// What the others ask for, in millimetres or radians: the size of the nearest right wheel.
    pub expected: f64,
    /// The standard uncertainty of that, in the same unit; none where the others leave the size open.
    pub expected_uncertainty: Option<f64>,
    /// By how many of its uncertainties it is off, dimensionless.
    pub uncertainties: f64,
    /// Whether without the culprits the rest agrees.
    pub rest_agrees: bool,
}

/// The right wheel that is nearest to the measurements without the culprits, and how well it fits.
#[derive(Clone, Debug, PartialEq)]
pub struct NearestWheel {
    /// Crank radius, in millimetres.
    pub crank_radius: f64,
    /// Centre distance, in millimetres.
    pub centre_distance: f64,
    /// Radius of the rim, in millimetres.
    pub tip_radius: f64,
    /// Diameter of the pins, in millimetres.
    pub pin_diameter: f64,
    /// Width of the slots, in millimetres.
    pub slot_width: f64,
    /// Distance of the slots' ends from the wheel's axis, in millimetres.
    pub slot_end: f64,
    /// Radius of the locking arcs, in millimetres.
    pub arc_radius: f64,
    /// Radius of the locking disc, in millimetres.
    pub disc_radius: f64,
    /// Distance of the crescents' centres from the driver's axis, in millimetres.
    pub crescent_centre: f64,
    /// Radius of the crescents, in millimetres.
    pub crescent_radius: f64,
    /// The least sum of the squares of normalised residuals and soft conditions of all measurements, culprits included, dimensionless.
    pub sum_of_squares: f64,
    /// The sum above which the measurements contradict each other, dimensionless.
    pub limit: f64,
    /// All measurements, in the order in which they were added.
    pub residuals: Vec<Residual>,
    /// The measurement that contradicts the others worst; none if all agree.
    pub culprit: Option<Culprit>,
    /// Others without which the rest agrees nearly as well: one of these may be wrong instead.
    pub suspects: Vec<MeasuredSize>,
    /// Further measurements that contradict the rest, the worst first, up to five.
    pub further_culprits: Vec<Culprit>,
    /// Why no wheel can be made of exactly these sizes; none if one can.
    pub refusal: Option<SizesError>,
}

impl MeasuredWheel {
    /// The nearest right wheel, with the measurements that contradict it.
    ///
    /// # Errors
    ///
    /// [`MeasuredError::NoScale`] where nothing tells how large the wheel is.
    pub fn nearest(&self) -> Result<NearestWheel, MeasuredError> {
        let fitted = self.nearest_fit()?;
        let (found, kept, (free, left)) = self.contradictions(fitted);
        let rest = self.only(&kept);
        let free = self.as_new(&free);
        let right = Right { wheel: self.wheel(), free };
        let drawn = rest.drawn_slots();
        let residuals: Vec<Residual> = self
            .sizes()
            .iter()
            .map(|of| {
                let right = right.fitting(of, drawn);
                Residual { measured: *of, right, normalized: (of.value - right) / of.uncertainty }
            })
            .collect();
        let rest_agrees = found.len() < MOST_CULPRITS || left <= limit(kept.len());
        let mut culprits: Vec<(usize, Culprit)> = found
            .iter()
            .map(|index| {
                let Residual { measured, right, normalized } = residuals[*index];
                let culprit = Culprit {
                    size: measured.size,
                    measured: measured.value,
                    expected: right,
                    expected_uncertainty: rest.fitted_uncertainty(&free, measured.size),
                    uncertainties: normalized,
                    rest_agrees,
                };
                (*index, culprit)
            })
            .collect();
        culprits.sort_by(|(_, one), (_, other)| other.uncertainties.abs().total_cmp(&one.uncertainties.abs()));
        let suspects = culprits.first().map_or_else(Vec::new, |(index, _)| self.suspects(*index, &kept, (free, left)));
        let mut culprits = culprits.into_iter().map(|(_, culprit)| culprit);
        let refusal = design(self.wheel(), &free).err();
        let free = self.filled_in(&free);
        let right = Right { wheel: self.wheel(), free };
        let rim = residuals.iter().find(|of| of.measured.size == MeasuredSize::TipRadius).copied();
        Ok(NearestWheel {
            crank_radius: free[0],
            centre_distance: right.centre_distance(),
            tip_radius: rim.map_or(right.tip_radius(), |of| of.right),
            pin_diameter: free[1],
            slot_width: free[2],
            slot_end: free[3],
            arc_radius: free[4],
            disc_radius: free[5],
            crescent_centre: free[6],
            crescent_radius: right.crescent_radius(),
            sum_of_squares: fitted.1,
            limit: limit(self.sizes().len()),
            residuals,
            culprit: culprits.next(),
            suspects,
            further_culprits: culprits.collect(),
            refusal,
        })
    }

    /// The fit to all measurements: the design that is nearest, if that does, and otherwise any right wheel.
    pub(super) fn nearest_fit(&self) -> Result<(Free, f64), MeasuredError> {
        let start = self.start()?;
        let designed = self.designed(start[0]).map(|free| (free, self.sum_of_squares(&free)));
        match designed.filter(|(_, sum)| self.is_agreeing(*sum)) {
            Some(designed) => Ok(designed),
            None => {
                let fitted = self.fit(start);
                let again = designed.map(|(free, _)| self.fit(free)).filter(|again| again.1 < fitted.1);
                Ok(again.unwrap_or(fitted))
            }
        }
    }

    /// Whether a sum of squares is so small that nothing contradicts: no measurement can take more away than there is.
    fn is_agreeing(&self, sum: f64) -> bool {
        let count = self.sizes().len();
        sum <= single_limit(count).min(limit(count))
    }

    /// The numbers of the culprits and of the other measurements, and the fit to these.
    fn contradictions(&self, fitted: (Free, f64)) -> (Vec<usize>, Vec<usize>, (Free, f64)) {
        let mut kept: Vec<usize> = (0..self.sizes().len()).collect();
        let (mut found, mut best) = (Vec::new(), fitted);
        // What a part was when it was new contradicts each slot and each arc by itself.
        let is_new_known = self.has(MeasuredSize::is_when_new);
        let most = MOST_CULPRITS + if is_new_known { 2 * self.wheel().stations() as usize } else { 0 };
        while found.len() < most {
            let rest = self.only(&kept);
            let Some((place, without)) = rest.worst(best) else { break };
            found.push(kept.remove(place));
            best = without;
        }
        // What seemed wrong beside a culprit that was found only later may be right after all.
        for index in found.clone() {
            let with: Vec<usize> = (0..self.sizes().len()).filter(|of| kept.contains(of) || *of == index).collect();
            let all = self.only(&with);
            let again = all.fit(best.0);
            if found.len() > 1 && again.1 <= limit(with.len()) && again.1 - best.1 <= single_limit(with.len()) {
                found.retain(|of| *of != index);
                (kept, best) = (with, again);
            }
        }
        // What the rest leaves open is as a design has it.
        if !found.is_empty() {
            let rest = self.only(&kept);
            best = rest.nearest_fit().ok().filter(|again| rest.is_agreeing(again.1)).unwrap_or(best);
        }
        (found, kept, best)
    }

    /// The measurement without which the others agree best, with the fit to these; none if all agree.
    fn worst(&self, fitted: (Free, f64)) -> Option<(usize, (Free, f64))> {
        let count = self.sizes().len();
        let most = single_limit(count);
        if self.is_agreeing(fitted.1) {
            return None;
        }
        let drawn = self.drawn_slots();
        let can_be_wrong = (0..count).filter(|index| !self.sizes()[*index].size.is_when_new());
        let without = can_be_wrong.map(|index| (index, self.fit_without(index, fitted.0)));
        // A measurement takes no more away than the square by which it is off; a fit that falls by more was not the best one.
        let is_cause = |(index, (free, sum)): &(usize, (Free, f64))| {
            let of = self.sizes()[*index];
            let off = (of.value - Right { wheel: self.wheel(), free: *free }.fitting(&of, drawn)) / of.uncertainty;
            off * off >= SHARE * (fitted.1 - sum)
        };
        let causes: Vec<(usize, (Free, f64))> = without.filter(is_cause).collect();
        let best = *causes.iter().min_by(|one, other| one.1.1.total_cmp(&other.1.1))?;
        // Of two that do equally well, the place of the axes is the easier one to mend.
        let is_as_good = |cause: &(usize, (Free, f64))| cause.1.1 - best.1.1 < TIE * (fitted.1 - best.1.1);
        let of_axes = causes.iter().filter(|cause| self.sizes()[cause.0].size == MeasuredSize::CentreDistance);
        let best = of_axes.copied().find(is_as_good).unwrap_or(best);
        (fitted.1 > limit(count) || fitted.1 - best.1.1 > most).then_some(best)
    }

    /// The fit to all measurements but one.
    fn fit_without(&self, index: usize, free: Free) -> (Free, f64) {
        let others = self.without(index);
        others.start().map_or((free, f64::INFINITY), |own| {
            // From both beginnings: one may be spoiled by the wrong size.
            let (one, other) = (others.fit(free), others.fit(own));
            if other.1 < one.1 { other } else { one }
        })
    }

    /// Which of the kept measurements there are that may be wrong instead of the culprit of this number.
    fn suspects(&self, culprit: usize, kept: &[usize], (free, least): (Free, f64)) -> Vec<MeasuredSize> {
        let all = self.only(&[&[culprit], kept].concat());
        let (_, sum) = all.fit(free);
        let most = (SUSPECT * (sum - least)).clamp(LEAST_SUSPECT, single_limit(kept.len()));
        let is_suspect = |place: &usize| all.fit_without(*place, free).1 - least < most;
        let can_be_wrong = (1..all.sizes().len()).filter(|place| !all.sizes()[*place].size.is_when_new());
        can_be_wrong.filter(is_suspect).map(|place| all.sizes()[place].size).collect()
    }

    /// The wheel as it was measured; what was not measured is as in the nearest right wheel. Of the centre distance and the distance of the
    /// arcs' centres from the wheel's axis, which are equal in a right wheel, one that was measured and agrees stands for the other, so that no
    /// play in the dwell comes from what the fit leaves between them.
    ///
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    /// use geneva_kinematics::wheel::as_built::{MeasuredSize, MeasuredWheel};
    ///
    /// let mut measured = MeasuredWheel::new(Wheel::new(6)?);
    /// measured.add(MeasuredSize::CrankRadius, 25.0, 0.05)?; // mm
    /// measured.add(MeasuredSize::CentreDistance, 49.5, 0.05)?; // 50 mm would be right
    /// assert!(measured.as_built(&measured.nearest()?).turn()?.jam.is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn as_built(&self, nearest: &NearestWheel) -> AsBuiltWheel {
        let mut built = nearest_parts(self.wheel(), nearest);
        let is_wrong = |size: MeasuredSize| {
            let mut culprits = nearest.culprit.iter().chain(&nearest.further_culprits);
            culprits.any(|culprit| culprit.size.name() == size.name())
        };
        let axes = self.mean(|size| size == MeasuredSize::CentreDistance);
        let arcs = self.mean(|size| matches!(size, MeasuredSize::ArcCentre(_)));
        match (axes, arcs) {
            (Some(axes), None) if !is_wrong(MeasuredSize::CentreDistance) => {
                built.set(MeasuredSize::ArcCentre(None), axes);
            }
            (None, Some(arcs)) if !is_wrong(MeasuredSize::ArcCentre(None)) => {
                built.set(MeasuredSize::CentreDistance, arcs);
            }
            _ => {}
        }
        for of in self.sizes() {
            built.set(of.size, of.value);
        }
        built
    }
}

/// A culprit is off by at least this part of what the sum of squares falls without it, as a square: our choice, one in a linear fit.
const SHARE: f64 = 0.5;

/// Of what the culprit takes away, the part by which a second one may take less and still do equally well: our choice.
const TIE: f64 = 1e-3;

/// Suspects leave no more than this part of what the culprit takes away, and at least two uncertainties as a square: our choice.
const SUSPECT: f64 = 0.02;
const LEAST_SUSPECT: f64 = 4.0;

/// The sum of squares that so many measurements may have: four standard deviations above its mean, as for a distribution of χ².
fn limit(measurements: usize) -> f64 {
    let degrees = (measurements as f64 - 6.0).max(1.0);
    degrees + 4.0 * (2.0 * degrees).sqrt() + 3.0
}

/// The sum of squares that may go with a single one of so many measurements: for normal errors, the chance that one of any goes
/// beyond it is about a half per cent, however many there are. Our choice.
pub(super) fn single_limit(measurements: usize) -> f64 {
    2.0 * libm::log(measurements.max(1) as f64) + 7.5
}

/// The parts of the nearest right wheel.
fn nearest_parts(wheel: &Wheel, nearest: &NearestWheel) -> AsBuiltWheel {
    let slot = BuiltSlot {
        width: nearest.slot_width,
        end: nearest.slot_end,
        direction_error: 0.0,
        tip_radius: nearest.tip_radius,
    };
    let arc = BuiltArc { radius: nearest.arc_radius, centre: nearest.centre_distance, direction_error: 0.0 };
    let crescent =
        BuiltCrescent { centre: nearest.crescent_centre, radius: nearest.crescent_radius, direction_error: 0.0 };
    let pin =
        BuiltPin { crank_radius: nearest.crank_radius, diameter: nearest.pin_diameter, direction_error: 0.0, crescent };
    let disc = (wheel.dwell_fraction() > SHORTEST_DWELL).then_some(nearest.disc_radius);
    AsBuiltWheel::alike(*wheel, nearest.centre_distance, disc, (slot, arc, pin))
}

/// A dwell shorter than this part of a turn is none: it is rounding.
const SHORTEST_DWELL: f64 = 1e-9;

impl AsBuiltWheel {
    /// Sets a size, in millimetres, or radians for a direction; of all slots or arcs if none is named.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::{AsBuiltWheel, MeasuredSize};
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &Choices::default())?;
    /// let mut built = AsBuiltWheel::from(&sizes);
    /// built.set(MeasuredSize::SlotWidth(Some(2)), 8.0); // mm
    /// assert_eq!(built.slots()[2].width, 8.0);
    /// assert_eq!(built.slots()[1].width, sizes.slot_width);
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn set(&mut self, size: MeasuredSize, value: f64) {
        let is_meant = |k: usize| size.number().is_none_or(|number| number == k);
        match size {
            MeasuredSize::CentreDistance => self.centre_distance = value,
            MeasuredSize::DiscRadius => self.disc_radius = self.disc_radius.map(|_| value),
            MeasuredSize::CrankRadius => self.pins_mut().iter_mut().for_each(|pin| pin.crank_radius = value),
            MeasuredSize::PinDiameter => self.pins_mut().iter_mut().for_each(|pin| pin.diameter = value),
            MeasuredSize::CrescentCentre => self.pins_mut().iter_mut().for_each(|pin| pin.crescent.centre = value),
            MeasuredSize::CrescentRadius => self.pins_mut().iter_mut().for_each(|pin| pin.crescent.radius = value),
            MeasuredSize::TipRadius => self.slots_mut().iter_mut().for_each(|slot| slot.tip_radius = value),
            MeasuredSize::SlotWidth(_) | MeasuredSize::SlotEnd(_) | MeasuredSize::SlotDirection(_) => {
                for (_, slot) in self.slots_mut().iter_mut().enumerate().filter(|(k, _)| is_meant(*k)) {
                    match size {
                        MeasuredSize::SlotWidth(_) => slot.width = value,
                        MeasuredSize::SlotEnd(_) => slot.end = value,
                        _ => slot.direction_error = value,
                    }
                }
            }
            MeasuredSize::ArcRadius(_) | MeasuredSize::ArcCentre(_) => {
                for (_, arc) in self.arcs_mut().iter_mut().enumerate().filter(|(k, _)| is_meant(*k)) {
                    match size {
                        MeasuredSize::ArcRadius(_) => arc.radius = value,
                        _ => arc.centre = value,
                    }
                }
            }
            // What a part was when it was new, it is no longer.
            MeasuredSize::NewPinDiameter
            | MeasuredSize::NewSlotWidth
            | MeasuredSize::NewArcRadius
            | MeasuredSize::NewDiscRadius => {}
        }
    }
}
