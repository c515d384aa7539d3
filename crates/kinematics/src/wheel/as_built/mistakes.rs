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

    /// The wrong formulas that give the measured sizes, whether these contradict each other or not.
    fn fitting_mistakes(&self) -> Vec<KnownMistake> {
        let mean = |is_it: fn(MeasuredSize) -> bool| self.mean(is_it);
        let spread = self.sizes().iter().filter(|of| !matches!(of.size, MeasuredSize::SlotDirection(_)));
        let uncertainty = spread.map(|of| of.uncertainty).fold(0.0, f64::max);
        let (sine, cosine) = libm::sincos(self.wheel().half_pitch_angle());
        let crank = mean(|size| size == MeasuredSize::CrankRadius);
        let axes = mean(|size| size == MeasuredSize::CentreDistance);
        let pin = mean(|size| size == MeasuredSize::PinDiameter);
        let rim = mean(|size| size == MeasuredSize::TipRadius);
        let slot = mean(|size| matches!(size, MeasuredSize::SlotWidth(_))).or(pin).unwrap_or_default();
        let disc = mean(|size| size == MeasuredSize::DiscRadius);
        let arc = mean(|size| matches!(size, MeasuredSize::ArcRadius(_)));
        let cut = mean(|size| size == MeasuredSize::CrescentCentre);
        let cut_radius = mean(|size| size == MeasuredSize::CrescentRadius);
        // Where the slot's corners are along it, or where the blank of some makers ends.
        let along = rim.map(|rim| (rim * rim - slot * slot / 4.0).max(0.0).sqrt());
        let near = |one: f64, other: f64| (one - other).abs() <= WITHIN * uncertainty;
        let mut found = Vec::new();
        if let (Some(a), Some(c)) = (crank, axes)
            && (c - a / sine).abs() > (WITHIN * uncertainty / sine).max(WRONG * c)
        {
            let radii: Vec<f64> = [along, rim].into_iter().flatten().collect();
            let by_radius = |formula: &dyn Fn(f64) -> f64| radii.iter().any(|b| near(c, formula(*b)));
            let square = |b: f64| (b * b - a * a).abs().sqrt();
            let known = [
                (KnownMistake::TouchingCircles, by_radius(&|b| a + b)),
                // With four slots both are one.
                (KnownMistake::SineForCosine, by_radius(&|b| b / sine) && !by_radius(&|b| b / cosine)),
                (KnownMistake::CosineForSine, near(c, a / cosine)),
                (KnownMistake::RightAngleAtAxis, by_radius(&square)),
            ];
            let before = found.len();
            found.extend(known.into_iter().filter(|(_, is_it)| *is_it).map(|(mistake, _)| mistake));
            if found.len() == before {
                found.push(KnownMistake::NoRightAngle);
            }
        } else if let (Some(along), Some(scale)) = (along, axes.or(crank.map(|a| a / sine)))
            && scale * cosine - along.max(rim.unwrap_or_default()) > (WITHIN * uncertainty).max(WRONG * scale)
        {
            found.push(KnownMistake::ShortRim);
        }
        if let (Some(a), Some(p)) = (crank, pin) {
            let (wrong, right) = (a - libm::pow(p, 1.5), a - 1.5 * p);
            let is_it = |z: f64| near(z, wrong) && !near(z, right);
            if disc.into_iter().chain(arc).any(is_it) {
                found.push(KnownMistake::PinToThePower);
            }
        }
        if let (Some(q), Some(radius), Some(c)) = (cut, cut_radius, axes.or(crank.map(|a| a / sine))) {
            let wheel = rim.unwrap_or(c * cosine);
            let is_about_axis = (q - c).abs() <= (WITHIN * uncertainty).max(WRONG * c);
            // With three slots a right cut can have its centre there too; its edges are then where the pin enters.
            let through_edges = |z: f64| (q * q + z * z - 2.0 * q * z * sine).max(0.0).sqrt();
            let is_right = disc.map_or(self.wheel().stations() == 3, |z| near(radius, through_edges(z)));
            if is_about_axis && !is_right && radius >= wheel - WITHIN * uncertainty && radius <= wheel + WRONG * c {
                found.push(KnownMistake::CrescentAboutWheelAxis);
            }
        }
        found
    }
}
