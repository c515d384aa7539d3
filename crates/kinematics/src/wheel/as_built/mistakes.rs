//! Wrong formulas that wheels are often made by, recognised by the sizes that they give.
//!
//! Notation: a crank radius, c centre distance, b wheel radius to the pin's centre at entry, p pin diameter, z radius of the disc,
//! α half the angle between slots. In a right wheel the triangle of both axes and the pin at entry has its right angle at the pin.

use super::contact::BuiltContact;
use super::measured::{MeasuredSize, MeasuredWheel};
use super::nearest::NearestWheel;
use super::turn::{BuiltTurn, Jam};
use crate::indexing::Indexing;

/// A wrong formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnownMistake {
    /// c is not a / sin α, and no formula that we know gives it.
    NoRightAngle,
    /// c = a + b: the pin's circle only touches the rim.
    TouchingCircles,
    /// c = b / sin α: the sine is taken for the cosine.
    SineForCosine,
    /// c = a / cos α: the cosine is taken for the sine.
    CosineForSine,
    /// c² = b² − a² or a² − b²: the right angle is put at an axis instead of the pin.
    RightAngleAtAxis,
    /// The rim is nearer to the wheel's axis than where the pin moves along the slot.
    ShortRim,
    /// z = a − p^1.5 for a − 1.5 p: a factor is taken for an exponent.
    PinToThePower,
    /// The crescent is an arc of the wheel's radius about the wheel's axis.
    CrescentAboutWheelAxis,
}

impl KnownMistake {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::NoRightAngle => "no right angle at the pin",
            Self::TouchingCircles => "touching circles",
            Self::SineForCosine => "sine for cosine",
            Self::CosineForSine => "cosine for sine",
            Self::RightAngleAtAxis => "right angle at an axis",
            Self::ShortRim => "short rim",
            Self::PinToThePower => "pin to the power 1.5",
            Self::CrescentAboutWheelAxis => "crescent about the wheel's axis",
        }
    }

    /// What is wrong, and what to do instead.
    pub fn explanation(self) -> &'static str {
        match self {
            Self::NoRightAngle => {
                "the centre distance is not the crank radius over the sine of 180°/N, so the pin does not enter along the slot"
            }
            Self::TouchingCircles => {
                "the centre distance is crank plus wheel radius, so the pin's circle only touches the rim; it must be the crank \
                 radius over the sine of 180°/N"
            }
            Self::SineForCosine => {
                "the centre distance is the wheel radius over the sine of 180°/N; it must be over the cosine. Both are equal for \
                 four slots only"
            }
            Self::CosineForSine => {
                "the centre distance is the crank radius over the cosine of 180°/N; it must be over the sine. Both are equal for \
                 four slots only"
            }
            Self::RightAngleAtAxis => {
                "the centre distance is a short side of the triangle of axes and pin; it is the longest, because the right angle \
                 is at the pin"
            }
            Self::ShortRim => {
                "the slots' corners are too near the wheel's axis, so the pin meets its wall late and with a blow; the rim belongs \
                 where the pin moves along the slot"
            }
            Self::PinToThePower => {
                "the locking disc or its arc has the crank radius less the pin's diameter to the power 1.5; 1.5 times the diameter was \
                 meant. Both are equal for a pin of 2.25 mm only"
            }
            Self::CrescentAboutWheelAxis => {
                "the crescent is drawn about the wheel's axis with the wheel's radius; the disc then bites into the horns before and \
                 after mid-index"
            }
        }
    }
}

/// Uncertainties within which a size is that of a wrong formula.
const WITHIN: f64 = 3.0;
/// Part of the centre distance by which a size is wrong for certain, dimensionless: our choice.
const WRONG: f64 = 0.01;

/// Whether a crescent contradicts the other sizes, or meets the horns.
fn is_crescent_wrong(nearest: &NearestWheel, jam: Option<&Jam>) -> bool {
    let is_crescent = |size| matches!(size, MeasuredSize::CrescentCentre | MeasuredSize::CrescentRadius);
    let mut culprits = nearest.culprit.iter().chain(&nearest.further_culprits);
    let is_met =
        |jam: &Jam| [jam.free.backward, jam.free.forward].iter().any(|of| of.contact == BuiltContact::Crescent);
    culprits.any(|culprit| is_crescent(culprit.size)) || jam.is_some_and(is_met)
}

/// Whether the rim contradicts the other sizes, or may be what does.
fn is_rim_in_question(nearest: &NearestWheel) -> bool {
    let culprits = nearest.culprit.iter().chain(&nearest.further_culprits).map(|culprit| culprit.size);
    culprits.chain(nearest.suspects.iter().copied()).any(|size| size == MeasuredSize::TipRadius)
}

impl MeasuredWheel {
    /// The wrong formulas that give the measured sizes, the most telling first: none unless the sizes contradict the nearest right wheel,
    /// or jam as they were measured. A right wheel may have a size of a wrong formula by chance.
    ///
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    /// use geneva_kinematics::wheel::as_built::{KnownMistake, MeasuredSize, MeasuredWheel};
    ///
    /// let mut measured = MeasuredWheel::new(Wheel::new(6)?);
    /// measured.add(MeasuredSize::CrankRadius, 25.0, 0.02)?; // mm
    /// measured.add(MeasuredSize::CentreDistance, 28.87, 0.02)?; // 25 mm over the cosine of 30°
    /// let nearest = measured.nearest()?;
    /// let turn = measured.as_built(&nearest).turn()?;
    /// assert_eq!(measured.known_mistakes(&nearest, Some(&turn)), [KnownMistake::CosineForSine]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn known_mistakes(&self, nearest: &NearestWheel, turn: Option<&BuiltTurn>) -> Vec<KnownMistake> {
        let jam = turn.and_then(|turn| turn.jam.as_ref());
        let contradicts = nearest.culprit.is_some() || jam.is_some();
        self.fitting_mistakes()
            .into_iter()
            .filter(|mistake| {
                // Where the rim goes with the others, no formula for it is wrong.
                let is_of_rim = *mistake == KnownMistake::ShortRim;
                contradicts
                    && (!is_of_rim || is_rim_in_question(nearest))
                    && (*mistake != KnownMistake::CrescentAboutWheelAxis || is_crescent_wrong(nearest, jam))
            })
            .collect()
    }

    /// The mean of what is measured of a size, with the greatest of its uncertainties; none if nothing is.
    fn mean_within(&self, is_it: fn(MeasuredSize) -> bool) -> Option<Uncertain> {
        let value = self.mean(is_it)?;
        let uncertainties = self.sizes().iter().filter(|of| is_it(of.size)).map(|of| of.uncertainty);
        Some(Uncertain { value, uncertainty: uncertainties.fold(0.0, f64::max) })
    }

    /// The wrong formulas that give the measured sizes, whether these contradict each other or not. A formula counts only the uncertainties
    /// of the sizes that it has.
    fn fitting_mistakes(&self) -> Vec<KnownMistake> {
        let mean = |is_it: fn(MeasuredSize) -> bool| self.mean_within(is_it);
        let (sine, cosine) = libm::sincos(self.wheel().half_pitch_angle());
        let crank = mean(|size| size == MeasuredSize::CrankRadius);
        let axes = mean(|size| size == MeasuredSize::CentreDistance);
        let pin = mean(|size| size == MeasuredSize::PinDiameter);
        let rim = mean(|size| size == MeasuredSize::TipRadius);
        let slot = mean(|size| matches!(size, MeasuredSize::SlotWidth(_))).or(pin);
        let slot = slot.unwrap_or(Uncertain { value: 0.0, uncertainty: 0.0 });
        let disc = mean(|size| size == MeasuredSize::DiscRadius);
        let arc = mean(|size| matches!(size, MeasuredSize::ArcRadius(_)));
        let cut = mean(|size| size == MeasuredSize::CrescentCentre);
        let cut_radius = mean(|size| size == MeasuredSize::CrescentRadius);
        // Where the slot's corners are along it, or where the blank of some makers ends.
        let along = rim.map(|rim| {
            following(&|[rim, slot]: [f64; 2]| (rim * rim - slot * slot / 4.0).max(0.0).sqrt(), [rim, slot])
        });
        let scale = axes.or(crank.map(|a| following(&|[a]: [f64; 1]| a / sine, [a])));
        let mut found = Vec::new();
        if let (Some(a), Some(c)) = (crank, axes)
            && is_beyond(&|[c, a]: [f64; 2]| (c - a / sine).abs(), [c, a], WRONG * c.value)
        {
            let radii: Vec<Uncertain> = [along, rim].into_iter().flatten().collect();
            let by_radius = |formula: &dyn Fn(f64, f64) -> f64| {
                radii.iter().any(|b| is_near(&|[c, a, b]: [f64; 3]| c - formula(a, b), [c, a, *b]))
            };
            let known = [
                (KnownMistake::TouchingCircles, by_radius(&|a, b| a + b)),
                // With four slots both are one.
                (KnownMistake::SineForCosine, by_radius(&|_, b| b / sine) && !by_radius(&|_, b| b / cosine)),
                (KnownMistake::CosineForSine, is_near(&|[c, a]: [f64; 2]| c - a / cosine, [c, a])),
                (KnownMistake::RightAngleAtAxis, by_radius(&|a, b| (b * b - a * a).abs().sqrt())),
            ];
            let before = found.len();
            found.extend(known.into_iter().filter(|(_, is_it)| *is_it).map(|(mistake, _)| mistake));
            if found.len() == before {
                found.push(KnownMistake::NoRightAngle);
            }
        } else if let (Some(along), Some(rim), Some(scale)) = (along, rim, scale) {
            let reach = if along.value > rim.value { along } else { rim };
            let short = |[scale, reach]: [f64; 2]| scale * cosine - reach;
            if is_beyond(&short, [scale, reach], WRONG * scale.value) {
                found.push(KnownMistake::ShortRim);
            }
        }
        if let (Some(a), Some(p)) = (crank, pin) {
            let is_it = |z: Uncertain| {
                is_near(&|[z, a, p]: [f64; 3]| z - a + libm::pow(p, 1.5), [z, a, p])
                    && !is_near(&|[z, a, p]: [f64; 3]| z - a + 1.5 * p, [z, a, p])
            };
            if disc.into_iter().chain(arc).any(is_it) {
                found.push(KnownMistake::PinToThePower);
            }
        }
        if let (Some(q), Some(radius), Some(c)) = (cut, cut_radius, scale) {
            let wheel = rim.unwrap_or(following(&|[c]: [f64; 1]| c * cosine, [c]));
            let is_about_axis = !is_beyond(&|[q, c]: [f64; 2]| (q - c).abs(), [q, c], WRONG * c.value);
            // With three slots a right cut can have its centre there too; its edges are then where the pin enters.
            let off_edges = |[radius, q, z]: [f64; 3]| radius - (q * q + z * z - 2.0 * q * z * sine).max(0.0).sqrt();
            let is_right = disc.map_or(self.wheel().stations() == 3, |z| is_near(&off_edges, [radius, q, z]));
            let short = |[radius, wheel]: [f64; 2]| wheel - radius;
            let is_as_wheel = !is_beyond(&short, [radius, wheel], 0.0) && radius.value <= wheel.value + WRONG * c.value;
            if is_about_axis && !is_right && is_as_wheel {
                found.push(KnownMistake::CrescentAboutWheelAxis);
            }
        }
        found
    }
}

/// A size with its standard uncertainty, in millimetres.
#[derive(Clone, Copy, Debug)]
struct Uncertain {
    value: f64,
    uncertainty: f64,
}

/// What follows from some sizes, with the uncertainty that theirs give it: by differences over one uncertainty, added as squares.
fn following<const N: usize>(formula: &dyn Fn([f64; N]) -> f64, of: [Uncertain; N]) -> Uncertain {
    let values = of.map(|size| size.value);
    let value = formula(values);
    let squares = (0..N).map(|k| {
        let mut other = values;
        other[k] += of[k].uncertainty;
        let by = formula(other) - value;
        by * by
    });
    Uncertain { value, uncertainty: squares.sum::<f64>().sqrt() }
}

/// Whether a difference of sizes is none within their uncertainties.
fn is_near<const N: usize>(difference: &dyn Fn([f64; N]) -> f64, of: [Uncertain; N]) -> bool {
    let found = following(difference, of);
    found.value.abs() <= WITHIN * found.uncertainty
}

/// Whether a difference of sizes is more than their uncertainties and this length, in millimetres, let it be.
fn is_beyond<const N: usize>(difference: &dyn Fn([f64; N]) -> f64, of: [Uncertain; N], least: f64) -> bool {
    let found = following(difference, of);
    found.value > (WITHIN * found.uncertainty).max(least)
}
