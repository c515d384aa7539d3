//! A right wheel by its free sizes, and the one that is nearest to measurements.
//!
//! A right wheel has one scale, the crank radius a; its axes are a / sin α apart, where the arcs have their centres, and its rim
//! follows. Pin, slot, slot end, arc, disc and the centre of the crescent are free, but a slot is a little wider than the pin, an arc
//! than the disc, a slot deep enough, a horn thick enough, and the cut in the disc about where the horns need it. These come as soft
//! conditions: their uncertainties are our choice. The sizes are found by weighted least squares (Gauss and Newton).

use super::errors::MeasuredError;
use super::measured::{MeasuredSize, MeasuredWheel, SizeMeasurement};
use super::process::{Process, ProcessNumbers};
use crate::indexing::Indexing;
use crate::wheel::{Choices, Play, Scale, Sizes, SizesError, Wheel};
use nalgebra::{SMatrix, SVector};

/// Free sizes of a right wheel: crank radius, pin, slot, slot end, arc, disc, and centre of the crescent.
pub(super) const FREE: usize = 7;
pub(super) type Free = SVector<f64, FREE>;

/// Steps of Gauss and Newton.
const STEPS: usize = 30;
/// A size whose uncertainty is as large as this part of the pin's diameter is left open by the measurements: our choice.
const OPEN: f64 = 0.5;
/// The greatest play of slot and arc that is ordinary, over the pin's diameter, and how far from ordinary a size counts as one
/// uncertainty: both our choice.
const ORDINARY_PLAY: f64 = 0.15;
const PLAY_UNCERTAINTY: f64 = 0.01;
const TIGHT_UNCERTAINTY: f64 = 0.001;
const ORDINARY_DEPTH: f64 = 0.5;
/// The greatest part of a width or a diameter that counts as worn off where its partner was not measured: our choice.
const MOST_WEAR: f64 = 0.3;
/// The least thickness of a horn over the pin's diameter, and how far sizes that are hardly tied count as one uncertainty: our choice.
pub(super) const LEAST_HORN: f64 = 0.2;
const WIDE_UNCERTAINTY: f64 = 0.05;
const CRESCENT_UNCERTAINTY: f64 = 0.5;

/// A right wheel by its free sizes.
pub(super) struct Right<'a> {
    pub wheel: &'a Wheel,
    pub free: Free,
}

impl Right<'_> {
    pub(super) fn centre_distance(&self) -> f64 {
        self.free[0] / libm::sin(self.wheel.half_pitch_angle())
    }

    pub(super) fn tip_radius(&self) -> f64 {
        libm::hypot(self.free[0] / libm::tan(self.wheel.half_pitch_angle()), self.free[2] / 2.0)
    }

    /// The radius of the cut through both edges of the opening, which are where the pin enters.
    pub(super) fn crescent_radius(&self) -> f64 {
        let (q, z, sine) = (self.free[6], self.free[5], libm::sin(self.wheel.half_pitch_angle()));
        (q * q + z * z - 2.0 * q * z * sine).max(0.0).sqrt()
    }

    pub(super) fn size(&self, size: MeasuredSize) -> f64 {
        match size {
            MeasuredSize::CentreDistance | MeasuredSize::ArcCentre(_) => self.centre_distance(),
            MeasuredSize::CrankRadius => self.free[0],
            MeasuredSize::PinDiameter | MeasuredSize::NewPinDiameter => self.free[1],
            MeasuredSize::TipRadius => self.tip_radius(),
            MeasuredSize::SlotWidth(_) | MeasuredSize::NewSlotWidth => self.free[2],
            MeasuredSize::SlotEnd(_) => self.free[3],
            MeasuredSize::SlotDirection(_) => 0.0,
            MeasuredSize::ArcRadius(_) | MeasuredSize::NewArcRadius => self.free[4],
            MeasuredSize::DiscRadius | MeasuredSize::NewDiscRadius => self.free[5],
            MeasuredSize::CrescentCentre => self.free[6],
            MeasuredSize::CrescentRadius => self.crescent_radius(),
        }
    }

    /// What the wheel has in a measurement's place, in millimetres or radians. The rim, which is at the slots' corners, is that for a slot of a
    /// width `drawn` from the least to the greatest in millimetres, whichever comes nearest.
    pub(super) fn fitting(&self, of: &SizeMeasurement, drawn: Option<[f64; 2]>) -> f64 {
        match drawn.filter(|_| of.size == MeasuredSize::TipRadius) {
            Some(widths) => {
                let along = self.free[0] / libm::tan(self.wheel.half_pitch_angle());
                let [least, most] = widths.map(|width| libm::hypot(along, width / 2.0));
                of.value.max(least).min(most)
            }
            None => self.size(of.size),
        }
    }

    /// The greatest play of slot and arc that is ordinary, in millimetres.
    pub(super) fn greatest_play(&self) -> f64 {
        (ORDINARY_PLAY * self.free[1]).max(coarsest_play(self.centre_distance()))
    }

    /// The soft conditions, each over its uncertainty: zero where it holds. Slot and arc may be `loose` where both partners of a play
    /// are measured: what is only loose contradicts nothing.
    fn conditions(&self, shallowest: f64, loose: [bool; 2]) -> [f64; 5] {
        let [a, pin, slot, end, arc, disc, cut]: [f64; FREE] = self.free.into();
        let outside = |value: f64, least: f64, most: f64| value - value.max(least).min(most);
        let greatest = self.greatest_play();
        // Wear makes horns thinner than they were drawn.
        let [made_slot, made_arc] = [
            if loose[0] { slot.min(pin + greatest) } else { slot },
            if loose[1] { arc.min(disc + greatest / 2.0) } else { arc },
        ];
        let ordinary = |play: f64, is_loose: bool| {
            let off = outside(play, 0.0, if is_loose { f64::INFINITY } else { greatest });
            off / (pin * if off < 0.0 { TIGHT_UNCERTAINTY } else { PLAY_UNCERTAINTY })
        };
        let deepest = self.centre_distance() - a;
        [
            ordinary(slot - pin, loose[0]),
            ordinary(2.0 * (arc - disc), loose[1]),
            outside(deepest - end, 0.0, ORDINARY_DEPTH * pin) / (WIDE_UNCERTAINTY * pin),
            outside(a - made_slot / 2.0 - made_arc, LEAST_HORN * pin, f64::INFINITY) / (WIDE_UNCERTAINTY * pin),
            (cut - shallowest) / (CRESCENT_UNCERTAINTY * pin),
        ]
    }
}

/// The play in millimetres that the coarsest process takes for axes at this distance, in millimetres; zero for what is no distance.
fn coarsest_play(centre_distance: f64) -> f64 {
    let of = |process| ProcessNumbers::new(process, centre_distance).map_or(0.0, |numbers| numbers.slot_play.value);
    Process::ALL.into_iter().map(of).fold(0.0, f64::max)
}

impl MeasuredWheel {
    /// Sizes from which the fit begins: each as measured, or as a design has it by default.
    pub(super) fn start(&self) -> Result<Free, MeasuredError> {
        let sine = libm::sin(self.wheel().half_pitch_angle());
        let tangent = libm::tan(self.wheel().half_pitch_angle());
        let of = |is_it: fn(MeasuredSize) -> bool| self.mean(is_it);
        let slot =
            of(|size| size == MeasuredSize::NewSlotWidth).or(of(|size| matches!(size, MeasuredSize::SlotWidth(_))));
        let rim = of(|size| size == MeasuredSize::TipRadius);
        let pin = of(|size| size == MeasuredSize::NewPinDiameter).or(of(|size| size == MeasuredSize::PinDiameter));
        let half = slot.or(pin).unwrap_or(0.0) / 2.0;
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
        let pin = pin.or(slot.map(|width| 0.98 * width));
        let design =
            by_default(&Choices { pin_diameter: pin, ..Choices::default() }).or(by_default(&Choices::default()));
        let ratio = |share: f64| share * a;
        let design_or = |size: fn(&Sizes) -> f64, other: f64| design.as_ref().map_or(other, size);
        let pin = pin.unwrap_or(design_or(|sizes| sizes.pin_diameter, ratio(0.3)));
        let slot = slot.unwrap_or(pin * 1.02);
        let arc =
            of(|size| size == MeasuredSize::NewArcRadius).or(of(|size| matches!(size, MeasuredSize::ArcRadius(_))));
        let disc = of(|size| size == MeasuredSize::NewDiscRadius).or(of(|size| size == MeasuredSize::DiscRadius));
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
        free[6] = of(|size| size == MeasuredSize::CrescentCentre).unwrap_or(usual_cut(self.wheel(), &free));
        Ok(free)
    }

    /// The residuals of the measurements and of the soft conditions.
    fn rows(&self, free: &Free, shallowest: f64) -> Vec<f64> {
        let right = Right { wheel: self.wheel(), free: *free };
        let drawn = self.drawn_slots();
        let measured = self.sizes().iter().map(|of| (right.fitting(of, drawn) - of.value) / of.uncertainty);
        measured.chain(right.conditions(shallowest, self.may_be_loose())).collect()
    }

    /// Whether the play of slot and of arc may be more than an ordinary one: both partners are measured, and of neither is it known how large
    /// it was when it was new.
    pub(super) fn may_be_loose(&self) -> [bool; 2] {
        use MeasuredSize as Size;
        let is_worn_pair = |are: [fn(Size) -> bool; 2], new: [Size; 2]| {
            are.iter().all(|is_it| self.has(is_it)) && !self.has(|size| new.contains(&size))
        };
        [
            is_worn_pair(
                [|size| size == Size::PinDiameter, |size| matches!(size, Size::SlotWidth(_))],
                [Size::NewPinDiameter, Size::NewSlotWidth],
            ),
            is_worn_pair(
                [|size| size == Size::DiscRadius, |size| matches!(size, Size::ArcRadius(_))],
                [Size::NewDiscRadius, Size::NewArcRadius],
            ),
        ]
    }

    /// The least and the greatest width of slot in millimetres for which the rim can have been drawn. A worn slot is wider than it was
    /// drawn, and a worn pin thinner, so it is between both. None where neither was measured.
    pub(super) fn drawn_slots(&self) -> Option<[f64; 2]> {
        use MeasuredSize as Size;
        let new = self.extremes(|size| size == Size::NewSlotWidth);
        let slots = self.extremes(|size| matches!(size, Size::SlotWidth(_)));
        let pins = self.extremes(|size| matches!(size, Size::PinDiameter | Size::NewPinDiameter));
        new.or(match (slots, pins) {
            (Some([least, most]), Some([_, pin])) => Some([least.min(pin), most.max(pin)]),
            (Some([least, most]), None) => Some([(1.0 - MOST_WEAR) * least, most]),
            (None, Some([pin, _])) => Some([pin, pin / (1.0 - MOST_WEAR)]),
            (None, None) => None,
        })
    }

    /// The normal matrix and the gradient of half the sum of squares.
    fn normal_equations(&self, free: &Free, cut: f64) -> (SMatrix<f64, FREE, FREE>, Free) {
        let rows = self.rows(free, cut);
        let columns: [Vec<f64>; FREE] = std::array::from_fn(|k| slopes(free, k, |free| self.rows(free, cut)));
        let dot = |one: &[f64], other: &[f64]| one.iter().zip(other).map(|(one, other)| one * other).sum::<f64>();
        let normal = SMatrix::from_fn(|k, l| dot(&columns[k], &columns[l]));
        (normal, Free::from_fn(|k, _| dot(&columns[k], &rows)))
    }

    /// The standard uncertainty that a size has by the fit, in millimetres or radians; none where the measurements leave it open.
    pub(super) fn fitted_uncertainty(&self, free: &Free, size: MeasuredSize) -> Option<f64> {
        let (mut normal, _) = self.normal_equations(free, usual_cut(self.wheel(), free));
        for k in 0..FREE {
            normal[(k, k)] += 1e-12;
        }
        let of = |free: &Free| vec![Right { wheel: self.wheel(), free: *free }.size(size)];
        let gradient = Free::from_fn(|k, _| slopes(free, k, of).first().copied().unwrap_or_default());
        let variance = gradient.dot(&normal.cholesky()?.solve(&gradient));
        let uncertainty = variance.max(0.0).sqrt();
        (uncertainty < OPEN * free[1]).then_some(uncertainty)
    }

    /// The sum of the squares of the residuals and the soft conditions.
    pub(super) fn sum_of_squares(&self, free: &Free) -> f64 {
        self.rows(free, usual_cut(self.wheel(), free)).iter().map(|row| row * row).sum()
    }

    /// The least sum of squares from a beginning.
    pub(super) fn fit(&self, start: Free) -> (Free, f64) {
        let mut free = start;
        let mut cut = usual_cut(self.wheel(), &free);
        let total = |rows: &[f64]| rows.iter().map(|row| row * row).sum::<f64>();
        let mut sum = total(&self.rows(&free, cut));
        let mut damping = 1e-9;
        for _ in 0..STEPS {
            let (mut normal, gradient) = self.normal_equations(&free, cut);
            for k in 0..FREE {
                normal[(k, k)] = normal[(k, k)] * (1.0 + damping) + 1e-12;
            }
            let Some(step) = normal.cholesky().map(|decomposed| decomposed.solve(&gradient)) else { break };
            let next = free - step;
            let next_sum = total(&self.rows(&next, cut));
            if next[0] > 0.0 && next[1] > 0.0 && next_sum <= sum {
                let is_done = sum - next_sum < 1e-9 * (1.0 + sum);
                (free, damping) = (next, (damping / 10.0).max(1e-12));
                cut = shallowest(self.wheel(), &free).unwrap_or(cut);
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

/// Slopes of values along one free size, as central differences.
fn slopes(free: &Free, k: usize, values: impl Fn(&Free) -> Vec<f64>) -> Vec<f64> {
    let step = 1e-6 * free[0];
    let [mut above, mut below] = [*free, *free];
    above[k] += step;
    below[k] -= step;
    values(&above).iter().zip(&values(&below)).map(|(above, below)| (above - below) / (2.0 * step)).collect()
}

/// The design that has these sizes.
pub(super) fn design(wheel: &Wheel, free: &Free) -> Result<Sizes, SizesError> {
    let [a, pin, slot, end, arc, disc, ..]: [f64; FREE] = (*free).into();
    let sine = libm::sin(wheel.half_pitch_angle());
    let choices = Choices {
        pin_diameter: Some(pin),
        play: Some(Play { slot: (slot - pin).max(0.0), locking: (2.0 * (arc - disc)).max(0.0), bore: 0.0, pin: 0.0 }),
        bottom_clearance: Some((a / sine - a - end).max(0.0)),
        horn_thickness: Some((a - slot.max(pin) / 2.0 - arc).max(0.01 * pin)),
        ..Choices::default()
    };
    Sizes::new(*wheel, Scale::CrankRadius(a), &choices)
}

/// The centre of the shallowest cut with which the horns pass, in millimetres; none where no design has these sizes.
fn shallowest(wheel: &Wheel, free: &Free) -> Option<f64> {
    Some(design(wheel, free).ok()?.locking_disc?.crescent.centre)
}

/// Where the cut of a design by default is if none has these sizes, in millimetres; a part of the crank radius where there is none.
fn usual_cut(wheel: &Wheel, free: &Free) -> f64 {
    let usual = || Sizes::new(*wheel, Scale::CrankRadius(free[0]), &Choices::default()).ok()?.locking_disc;
    let cut = shallowest(wheel, free).or_else(|| usual().map(|disc| disc.crescent.centre));
    cut.unwrap_or(0.6 * free[0])
}
