//! The right wheel that is nearest to measured sizes, and the measurement that contradicts it.
//!
//! A right wheel has one scale, the crank radius a; its axes are a / sin α apart, where the arcs have their centres, and its rim follows. Pin, slot, slot end, arc, disc and the
//! centre of the crescent are free, but a slot is a little wider than the pin, an arc than the disc, a slot deep enough, a horn thick
//! enough, and the cut in the disc about where the horns need it. These come as soft conditions: their uncertainties are our choice.
//! The sizes are found by weighted least squares (Gauss and Newton). A measurement is the culprit if without it, the rest agrees best.

use super::errors::MeasuredError;
use super::measured::{MeasuredSize, MeasuredWheel, SizeMeasurement};
use super::parts::{AsBuiltWheel, BuiltArc, BuiltCrescent, BuiltPin, BuiltSlot};
use crate::indexing::Indexing;
use crate::wheel::{Choices, Play, Scale, Sizes, SizesError, Wheel};
use nalgebra::{SMatrix, SVector};

/// Free sizes of a right wheel: crank radius, pin, slot, slot end, arc, disc, and centre of the crescent.
const FREE: usize = 7;
type Free = SVector<f64, FREE>;

/// Culprits besides the first that are looked for at most.
const MOST_FURTHER: u32 = 2;
/// Steps of Gauss and Newton.
const STEPS: usize = 30;
/// The greatest play of slot and arc that is ordinary, over the pin's diameter, and how far from ordinary a size counts as one
/// uncertainty: both our choice.
const ORDINARY_PLAY: f64 = 0.15;
const PLAY_UNCERTAINTY: f64 = 0.01;
const TIGHT_UNCERTAINTY: f64 = 0.001;
const ORDINARY_DEPTH: f64 = 0.5;
const LEAST_HORN: f64 = 0.2;
const WIDE_UNCERTAINTY: f64 = 0.05;
const CRESCENT_UNCERTAINTY: f64 = 0.5;

/// A measurement against the nearest right wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// What was measured.
    pub measured: SizeMeasurement,
    /// What the nearest right wheel has there, in millimetres or radians.
    pub right: f64,
    /// Measured less right, over the uncertainty, dimensionless.
    pub normalized: f64,
    /// The sum of squares that is left of all others if this one is left out, dimensionless.
    pub without: f64,
}

/// The measurement that contradicts the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Culprit {
    /// Which size.
    pub size: MeasuredSize,
    /// What was measured, in millimetres or radians.
    pub measured: f64,
    /// What the others ask for, in millimetres or radians.
    pub expected: f64,
    /// By how many of its uncertainties it is off, dimensionless.
    pub uncertainties: f64,
    /// Whether without it the rest agrees.
    pub rest_agrees: bool,
}

/// The nearest right wheel and how well it fits.
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
    /// Sum of the squares of all normalised residuals and soft conditions, dimensionless.
    pub sum_of_squares: f64,
    /// The sum above which the measurements contradict each other, dimensionless.
    pub limit: f64,
    /// All measurements, in the order in which they were added.
    pub residuals: Vec<Residual>,
    /// The measurement that contradicts the others; none if all agree.
    pub culprit: Option<Culprit>,
    /// Others without which the rest agrees nearly as well: one of these may be wrong instead.
    pub suspects: Vec<MeasuredSize>,
    /// Further measurements that contradict what is left without the culprit, up to two.
    pub further_culprits: Vec<Culprit>,
    /// Why no wheel can be made of exactly these sizes; none if one can.
    pub refusal: Option<SizesError>,
}

/// A right wheel by its free sizes.
struct Right<'a> {
    wheel: &'a Wheel,
    free: Free,
}

impl Right<'_> {
    fn centre_distance(&self) -> f64 {
        self.free[0] / libm::sin(self.wheel.half_pitch_angle())
    }

    fn tip_radius(&self) -> f64 {
        libm::hypot(self.free[0] / libm::tan(self.wheel.half_pitch_angle()), self.free[2] / 2.0)
    }

    /// The radius of the cut through both edges of the opening, which are where the pin enters.
    fn crescent_radius(&self) -> f64 {
        let (q, z, sine) = (self.free[6], self.free[5], libm::sin(self.wheel.half_pitch_angle()));
        (q * q + z * z - 2.0 * q * z * sine).max(0.0).sqrt()
    }

    fn size(&self, size: MeasuredSize) -> f64 {
        match size {
            MeasuredSize::CentreDistance | MeasuredSize::ArcCentre(_) => self.centre_distance(),
            MeasuredSize::CrankRadius => self.free[0],
            MeasuredSize::PinDiameter => self.free[1],
            MeasuredSize::TipRadius => self.tip_radius(),
            MeasuredSize::SlotWidth(_) => self.free[2],
            MeasuredSize::SlotEnd(_) => self.free[3],
            MeasuredSize::SlotDirection(_) => 0.0,
            MeasuredSize::ArcRadius(_) => self.free[4],
            MeasuredSize::DiscRadius => self.free[5],
            MeasuredSize::CrescentCentre => self.free[6],
            MeasuredSize::CrescentRadius => self.crescent_radius(),
        }
    }

    /// The soft conditions, each over its uncertainty: zero where it holds.
    fn conditions(&self, shallowest: f64) -> [f64; 5] {
        let [a, pin, slot, end, arc, disc, cut]: [f64; FREE] = self.free.into();
        let outside = |value: f64, least: f64, most: f64| value - value.max(least).min(most);
        let ordinary = |play: f64| {
            let off = outside(play, 0.0, ORDINARY_PLAY * pin);
            off / (pin * if off < 0.0 { TIGHT_UNCERTAINTY } else { PLAY_UNCERTAINTY })
        };
        let deepest = self.centre_distance() - a;
        [
            ordinary(slot - pin),
            ordinary(2.0 * (arc - disc)),
            outside(deepest - end, 0.0, ORDINARY_DEPTH * pin) / (WIDE_UNCERTAINTY * pin),
            outside(a - slot / 2.0 - arc, LEAST_HORN * pin, f64::INFINITY) / (WIDE_UNCERTAINTY * pin),
            (cut - shallowest) / (CRESCENT_UNCERTAINTY * pin),
        ]
    }
}

impl MeasuredWheel {
    /// The nearest right wheel, with the measurement that contradicts it.
    ///
    /// # Errors
    ///
    /// [`MeasuredError::NoScale`] where nothing tells how large the wheel is.
    pub fn nearest(&self) -> Result<NearestWheel, MeasuredError> {
        self.nearest_within(MOST_FURTHER)
    }

    fn nearest_within(&self, depth: u32) -> Result<NearestWheel, MeasuredError> {
        let start = self.start()?;
        let (free, sum) = self.fit(start);
        let right = Right { wheel: self.wheel(), free };
        let limit = limit(self.sizes().len());
        let refusal = design(self.wheel(), &free).err();
        let leave = |index: usize| {
            let others = self.without(index);
            others.start().map_or((free, f64::INFINITY), |own| {
                // From both beginnings: one may be spoiled by the wrong size.
                let (one, other) = (others.fit(free), others.fit(own));
                if other.1 < one.1 { other } else { one }
            })
        };
        let left_out: Vec<(Free, f64)> =
            if sum > limit { (0..self.sizes().len()).map(leave).collect() } else { Vec::new() };
        let residuals: Vec<Residual> = self
            .sizes()
            .iter()
            .enumerate()
            .map(|(index, of)| Residual {
                measured: *of,
                right: right.size(of.size),
                normalized: (of.value - right.size(of.size)) / of.uncertainty,
                without: left_out.get(index).map_or(sum, |(_, without)| *without),
            })
            .collect();
        let best = (0..left_out.len()).min_by(|one, other| left_out[*one].1.total_cmp(&left_out[*other].1));
        let culprit = best.map(|index| {
            let (of, (free, without)) = (self.sizes()[index], left_out[index]);
            let expected = Right { wheel: self.wheel(), free }.size(of.size);
            Culprit {
                size: of.size,
                measured: of.value,
                expected,
                uncertainties: (of.value - expected) / of.uncertainty,
                rest_agrees: without <= limit,
            }
        });
        let least = best.map_or(0.0, |index| left_out[index].1);
        let suspects = left_out
            .iter()
            .enumerate()
            .filter(|(index, (_, without))| Some(*index) != best && *without - least < SUSPECT * (sum - least))
            .map(|(index, _)| self.sizes()[index].size)
            .collect();
        // What is left may contradict itself, too.
        let further = match (best, culprit) {
            (Some(index), Some(Culprit { rest_agrees: false, .. })) if depth > 0 => {
                self.without(index).nearest_within(depth - 1).ok()
            }
            _ => None,
        };
        let further_culprits =
            further.map_or_else(Vec::new, |of| of.culprit.into_iter().chain(of.further_culprits).collect());
        Ok(NearestWheel {
            crank_radius: free[0],
            centre_distance: right.centre_distance(),
            tip_radius: right.tip_radius(),
            pin_diameter: free[1],
            slot_width: free[2],
            slot_end: free[3],
            arc_radius: free[4],
            disc_radius: free[5],
            crescent_centre: free[6],
            crescent_radius: right.crescent_radius(),
            sum_of_squares: sum,
            limit,
            residuals,
            culprit,
            suspects,
            further_culprits,
            refusal,
        })
    }

    /// The wheel as it was measured; what was not measured is as in the nearest right wheel.
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
        for of in self.sizes() {
            built.set(of.size, of.value);
        }
        built
    }

    /// Sizes from which the fit begins: each as measured, or as a design has it by default.
    fn start(&self) -> Result<Free, MeasuredError> {
        let sine = libm::sin(self.wheel().half_pitch_angle());
        let tangent = libm::tan(self.wheel().half_pitch_angle());
        let of = |is_it: fn(MeasuredSize) -> bool| self.mean(is_it);
        let slot = of(|size| matches!(size, MeasuredSize::SlotWidth(_)));
        let rim = of(|size| size == MeasuredSize::TipRadius);
        let half = slot.or(of(|size| size == MeasuredSize::PinDiameter)).unwrap_or(0.0) / 2.0;
        let scales = [
            of(|size| size == MeasuredSize::CentreDistance).map(|c| c * sine),
            of(|size| matches!(size, MeasuredSize::ArcCentre(_))).map(|c| c * sine),
            of(|size| size == MeasuredSize::CrankRadius),
            rim.filter(|rim| *rim > half).map(|rim| (rim * rim - half * half).sqrt() * tangent),
        ];
        let mut scales: Vec<f64> = scales.into_iter().flatten().collect();
        scales.sort_by(f64::total_cmp);
        let a = *scales.get(scales.len() / 2).ok_or(MeasuredError::NoScale)?;
        let by_default = |choices: &Choices| Sizes::new(*self.wheel(), Scale::CrankRadius(a), choices).ok();
        let pin = of(|size| size == MeasuredSize::PinDiameter).or(slot.map(|width| 0.98 * width));
        let design =
            by_default(&Choices { pin_diameter: pin, ..Choices::default() }).or(by_default(&Choices::default()));
        let ratio = |share: f64| share * a;
        let design_or = |size: fn(&Sizes) -> f64, other: f64| design.as_ref().map_or(other, size);
        let pin = pin.unwrap_or(design_or(|sizes| sizes.pin_diameter, ratio(0.3)));
        let slot = slot.unwrap_or(pin * 1.02);
        let arc = of(|size| matches!(size, MeasuredSize::ArcRadius(_)));
        let disc = of(|size| size == MeasuredSize::DiscRadius);
        let default_arc = design_or(|sizes| sizes.locking_arc_radius, ratio(0.5));
        let arc_radius = arc.or(disc.map(|disc| disc + 0.01 * pin)).unwrap_or(default_arc);
        let default_end = a / sine - a - 0.05 * pin;
        let mut free = Free::from([
            a,
            pin,
            slot,
            of(|size| matches!(size, MeasuredSize::SlotEnd(_))).unwrap_or(default_end),
            arc_radius,
            disc.unwrap_or(arc_radius - 0.01 * pin),
            0.0,
        ]);
        free[6] = of(|size| size == MeasuredSize::CrescentCentre).unwrap_or(shallowest(self.wheel(), &free));
        Ok(free)
    }

    /// The residuals of the measurements and of the soft conditions.
    fn rows(&self, free: &Free, shallowest: f64) -> Vec<f64> {
        let right = Right { wheel: self.wheel(), free: *free };
        let measured = self.sizes().iter().map(|of| (right.size(of.size) - of.value) / of.uncertainty);
        measured.chain(right.conditions(shallowest)).collect()
    }

    /// The least sum of squares from a beginning.
    fn fit(&self, start: Free) -> (Free, f64) {
        let mut free = start;
        let mut cut = shallowest(self.wheel(), &free);
        let total = |rows: &[f64]| rows.iter().map(|row| row * row).sum::<f64>();
        let mut sum = total(&self.rows(&free, cut));
        let mut damping = 1e-9;
        for _ in 0..STEPS {
            let rows = self.rows(&free, cut);
            let mut normal = SMatrix::<f64, FREE, FREE>::zeros();
            let mut gradient = Free::zeros();
            let columns: Vec<Vec<f64>> = (0..FREE)
                .map(|k| {
                    let step = 1e-6 * free[0];
                    let [mut above, mut below] = [free, free];
                    above[k] += step;
                    below[k] -= step;
                    let (above, below) = (self.rows(&above, cut), self.rows(&below, cut));
                    above.iter().zip(&below).map(|(above, below)| (above - below) / (2.0 * step)).collect()
                })
                .collect();
            for (k, column) in columns.iter().enumerate() {
                gradient[k] = column.iter().zip(&rows).map(|(slope, row)| slope * row).sum();
                for (l, other) in columns.iter().enumerate() {
                    normal[(k, l)] = column.iter().zip(other).map(|(one, other)| one * other).sum();
                }
            }
            for k in 0..FREE {
                normal[(k, k)] = normal[(k, k)] * (1.0 + damping) + 1e-12;
            }
            let Some(step) = normal.cholesky().map(|decomposed| decomposed.solve(&gradient)) else { break };
            let next = free - step;
            let next_sum = total(&self.rows(&next, cut));
            if next[0] > 0.0 && next[1] > 0.0 && next_sum <= sum {
                let is_done = sum - next_sum < 1e-9 * (1.0 + sum);
                (free, damping) = (next, (damping / 10.0).max(1e-12));
                cut = shallowest(self.wheel(), &free);
                sum = total(&self.rows(&free, cut));
                if is_done {
                    break;
                }
            } else {
                damping = (damping * 100.0).max(1e-6);
                if damping > 1e12 {
                    break;
                }
            }
        }
        (free, sum)
    }
}

/// Suspects leave no more than this part of what the culprit takes away: our choice.
const SUSPECT: f64 = 0.02;

/// The sum of squares that so many measurements may have: four standard deviations above its mean, as for a distribution of χ².
fn limit(measurements: usize) -> f64 {
    let degrees = (measurements as f64 - 6.0).max(1.0);
    degrees + 4.0 * (2.0 * degrees).sqrt() + 3.0
}

/// The design that has these sizes.
fn design(wheel: &Wheel, free: &Free) -> Result<Sizes, SizesError> {
    let [a, pin, slot, end, arc, disc, ..]: [f64; FREE] = (*free).into();
    let sine = libm::sin(wheel.half_pitch_angle());
    let choices = Choices {
        pin_diameter: Some(pin),
        play: Some(Play { slot: (slot - pin).max(0.0), locking: (2.0 * (arc - disc)).max(0.0), bore: 0.0 }),
        bottom_clearance: Some((a / sine - a - end).max(0.0)),
        horn_thickness: Some((a - slot.max(pin) / 2.0 - arc).max(0.01 * pin)),
        ..Choices::default()
    };
    Sizes::new(*wheel, Scale::CrankRadius(a), &choices)
}

/// The centre of the shallowest cut with which the horns pass, in millimetres; a part of the crank radius where no design has
/// these sizes.
fn shallowest(wheel: &Wheel, free: &Free) -> f64 {
    let disc = design(wheel, free).ok().and_then(|sizes| sizes.locking_disc);
    disc.map_or(0.6 * free[0], |disc| disc.crescent.centre)
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
    fn set(&mut self, size: MeasuredSize, value: f64) {
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
        }
    }
}
