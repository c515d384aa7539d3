//! The design whose sizes are nearest to measured ones: what was not measured is as the designer would take it.
//!
//! A [right wheel](super::right_wheel) leaves its plays and its crescent open. A design has fewer free sizes: the crescent follows
//! from all others, and what nobody measured is near its default. So of a crescent whose radius alone is known, this finds the plays
//! and the horn that it was drawn for. The sizes are found by least squares in their logarithms (Levenberg and Marquardt).

use super::measured::{MeasuredSize, MeasuredWheel};
use super::right_wheel::{Free, Right};
use crate::indexing::Indexing;
use crate::wheel::{Choices, Play, Scale, Sizes};
use nalgebra::{SMatrix, SVector};

/// Free sizes of a design: crank radius, pin, play of slot and of arc, horn, and clearance at the bottom, as logarithms of millimetres.
const FREE: usize = 6;
type Logarithms = SVector<f64, FREE>;

/// How much the wish to be like the default counts against the measurements: one over the standard deviation of a logarithm. So
/// small that it decides only what the measurements leave open.
const BY_DEFAULT: [f64; FREE] = [0.0, 0.02, 0.01, 0.01, 0.02, 0.02];
/// Steps of Levenberg and Marquardt, and the difference of two logarithms from which a slope is taken.
const STEPS: usize = 40;
/// The greatest step of a logarithm.
const MOST_STEP: f64 = 0.7;
const DIFFERENCE: f64 = 1e-5;
/// Plays and pins from which the search begins, over their defaults.
const BEGINNINGS: [[f64; 2]; 9] =
    [[1.0, 1.0], [0.3, 1.0], [4.0, 1.0], [12.0, 1.0], [30.0, 1.0], [1.0, 0.6], [4.0, 0.6], [1.0, 1.5], [0.05, 1.0]];
/// A sum of squares that is good enough to look no further, per measurement: our choice.
const GOOD: f64 = 1e-4;

/// The design with these logarithms; none where it can't be made.
fn design(measured: &MeasuredWheel, of: &Logarithms) -> Option<Sizes> {
    let [a, pin, slot_play, locking_play, horn, bottom] = of.map(libm::exp).into();
    let choices = Choices {
        pin_diameter: Some(pin),
        play: Some(Play { slot: slot_play, locking: locking_play, bore: 0.0, pin: 0.0 }),
        bottom_clearance: Some(bottom),
        horn_thickness: Some(horn),
        ..Choices::default()
    };
    Sizes::new(*measured.wheel(), Scale::CrankRadius(a), &choices).ok()
}

/// The free sizes of the right wheel that a design is.
pub(super) fn right_wheel(sizes: &Sizes) -> Free {
    let disc = sizes.locking_disc;
    Free::from([
        sizes.crank_radius,
        sizes.pin_diameter,
        sizes.slot_width,
        sizes.slot_end,
        sizes.locking_arc_radius,
        disc.map_or(sizes.locking_arc_radius - sizes.play.locking / 2.0, |disc| disc.radius),
        disc.map_or(0.6 * sizes.crank_radius, |disc| disc.crescent.centre),
    ])
}

impl MeasuredWheel {
    /// The right wheel that is a design and nearest to the measurements, from a crank radius in millimetres to begin with; none
    /// where no design is near.
    pub(super) fn designed(&self, crank_radius: f64) -> Option<Free> {
        let default = Sizes::new(*self.wheel(), Scale::CrankRadius(crank_radius), &Choices::default()).ok()?;
        let mean = |is_it: fn(MeasuredSize) -> bool| self.mean(is_it);
        use MeasuredSize as Size;
        let slot = mean(|size| size == Size::NewSlotWidth).or(mean(|size| matches!(size, Size::SlotWidth(_))));
        let pin = mean(|size| size == Size::NewPinDiameter).or(mean(|size| size == Size::PinDiameter));
        let typed_arc = mean(|size| size == Size::NewArcRadius).or(mean(|size| matches!(size, Size::ArcRadius(_))));
        let disc = mean(|size| size == Size::NewDiscRadius).or(mean(|size| size == Size::DiscRadius));
        let arc = typed_arc.or(disc);
        // A play of two measured sizes is known, but zero has no logarithm.
        let known = |wide: Option<f64>, thin: Option<f64>| {
            wide.zip(thin).map(|(wide, thin)| (wide - thin).max(0.01 * default.play.slot))
        };
        let (known_slot, known_locking) = (known(slot, pin), known(typed_arc, disc).map(|gap| 2.0 * gap));
        let end = mean(|size| matches!(size, MeasuredSize::SlotEnd(_)));
        let deepest = crank_radius / libm::sin(self.wheel().half_pitch_angle()) - crank_radius;
        let mut best: Option<(Logarithms, f64)> = None;
        for [play, thickness] in BEGINNINGS {
            let slot_play = known_slot.unwrap_or(play * default.play.slot);
            let pin = pin.or(slot.map(|width| (width - slot_play).max(0.5 * width)));
            let pin = pin.unwrap_or(thickness * default.pin_diameter);
            let horn = arc.map_or(thickness * default.horn_thickness, |arc| crank_radius - pin / 2.0 - arc);
            let bottom = end.map_or(default.bottom_clearance, |end| deepest - end);
            let start = [
                crank_radius,
                pin,
                slot_play,
                known_locking.unwrap_or(play * default.play.locking),
                horn.max(0.05 * pin),
                bottom.max(0.001 * pin),
            ];
            let Some(found) = self.fit_design(&Logarithms::from(start).map(libm::log)) else { continue };
            if best.is_none_or(|(_, sum)| found.1 < sum) {
                best = Some(found);
            }
            if best.is_some_and(|(_, sum)| sum < GOOD * (1.0 + self.sizes().len() as f64)) {
                break;
            }
        }
        Some(right_wheel(&design(self, &best?.0)?))
    }

    /// The least sum of squares from a beginning; none where the beginning can't be made.
    fn fit_design(&self, start: &Logarithms) -> Option<(Logarithms, f64)> {
        let rows = |of: &Logarithms| -> Option<Vec<f64>> {
            let free = right_wheel(&design(self, of)?);
            let right = Right { wheel: self.wheel(), free };
            let drawn = self.drawn_slots();
            let measured = self.sizes().iter().map(|of| (right.fitting(of, drawn) - of.value) / of.uncertainty);
            let wishes = (0..FREE).map(|k| BY_DEFAULT[k] * (of[k] - start[k]));
            Some(measured.chain(wishes).collect())
        };
        let total = |rows: &[f64]| rows.iter().map(|row| row * row).sum::<f64>();
        let (mut best, mut values) = (*start, rows(start)?);
        let mut damping = 1e-6;
        for _ in 0..STEPS {
            let columns: [Vec<f64>; FREE] = std::array::from_fn(|k| slopes(&best, k, &values, rows));
            let dot = |one: &[f64], other: &[f64]| one.iter().zip(other).map(|(one, other)| one * other).sum::<f64>();
            let mut normal: SMatrix<f64, FREE, FREE> = SMatrix::from_fn(|k, l| dot(&columns[k], &columns[l]));
            let gradient = Logarithms::from_fn(|k, _| dot(&columns[k], &values));
            for k in 0..FREE {
                normal[(k, k)] += damping * normal[(k, k)].max(1e-6);
            }
            // No size becomes more than twice as large in a step, or less than half.
            let step = normal.cholesky()?.solve(&gradient);
            let step = step * (MOST_STEP / step.amax().max(MOST_STEP));
            let next = best - step;
            let (before, after) = (total(&values), rows(&next));
            match after {
                Some(after) if total(&after) <= before => {
                    let is_done = before - total(&after) < 1e-10 * (1e-6 + before);
                    (best, values, damping) = (next, after, (damping / 10.0_f64).max(1e-12));
                    if is_done {
                        break;
                    }
                }
                _ if damping > 1e6 => break,
                _ => damping *= 20.0,
            }
        }
        // What the wishes add is no contradiction.
        Some((best, total(&values[..self.sizes().len()])))
    }
}

/// Slopes of values along one logarithm; to one side only where the other can't be made, and zero where neither can.
fn slopes(of: &Logarithms, k: usize, values: &[f64], rows: impl Fn(&Logarithms) -> Option<Vec<f64>>) -> Vec<f64> {
    let moved = |by: f64| {
        let mut other = *of;
        other[k] += by;
        rows(&other)
    };
    let between = |from: &[f64], to: &[f64], by: f64| from.iter().zip(to).map(|(from, to)| (to - from) / by).collect();
    match (moved(-DIFFERENCE), moved(DIFFERENCE)) {
        (Some(below), Some(above)) => between(&below, &above, 2.0 * DIFFERENCE),
        (None, Some(above)) => between(values, &above, DIFFERENCE),
        (Some(below), None) => between(&below, values, DIFFERENCE),
        (None, None) => vec![0.0; values.len()],
    }
}
