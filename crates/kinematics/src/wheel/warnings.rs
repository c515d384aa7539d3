//! What is wrong with sizes that fit: parts that can be drawn, and had better not be made.
//!
//! That a wheel can miss its pin follows from the play. The least thickness of a wall is a rule of thumb of ours: it asks for
//! a look at the strength, and proves nothing.

use super::mouth::Mouth;
use super::sizes::Sizes;
use super::standard_fit::play_of_h8_e8_at;
use std::fmt;

/// A reason to choose other sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Warning {
    /// Slot or locking arc has no play: parts that touch all around do not turn.
    NoPlay,
    /// A wheel that has turned as far as its play lets it is out of the way of the pin, which then meets the rim.
    CanMiss {
        /// How far it turns, in radians.
        turns: f64,
    },
    /// The play of a slot is more than a tenth of the pin: only a print or a rough cut needs as much.
    LargePlay {
        /// Play of the slot, in millimetres.
        play: f64,
        /// Diameter of the pin, in millimetres.
        pin: f64,
    },
    /// In the dwell the wheel turns so far that its rim moves by more than a quarter of the pin.
    LargeBacklash {
        /// How far the rim moves to one side, in millimetres.
        at_rim: f64,
        /// Diameter of the pin, in millimetres.
        pin: f64,
    },
    /// The pin lands on the mouth of its slot harder than it would on a sharp corner, with the wheel anywhere in its play.
    HarderMouth {
        /// How many times as hard, dimensionless: the ratio of the closing speeds.
        times: f64,
    },
    /// A wall of wheel, locking disc or plate is thinner than a fifth of the pin.
    ThinWall {
        /// Which wall.
        wall: &'static str,
        /// Its thickness, in millimetres.
        thickness: f64,
    },
    /// The locking arcs reach into the wheel by less than a fifth of the pin, so they hardly hold it.
    ShallowArc {
        /// How far they reach, in millimetres.
        reach: f64,
    },
    /// The locking disc is thinner than the pin.
    SmallDisc {
        /// Diameter of the disc, in millimetres.
        disc: f64,
        /// Diameter of the pin, in millimetres.
        pin: f64,
    },
    /// The play is more than that of the fit H8/e8 for the pin. It is for a play that the program chose.
    LooserThanFit {
        /// Play of the slot, in millimetres.
        play: f64,
        /// Least and greatest play of the fit, in millimetres.
        fit: [f64; 2],
    },
}

/// A play that is more than this part of the pin's diameter gets a warning, and so does a rim that moves by more than the other
/// part. Both are our choice.
const LARGE_PLAY: f64 = 0.1;
const LARGE_BACKLASH: f64 = 0.25;

/// A wall that is thinner than this part of the pin's diameter gets a warning.
pub(crate) const THIN: f64 = 0.2;

/// Blows that are this much harder get a warning, dimensionless: less is not felt.
const HARDER: f64 = 1.02;

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoPlay => f.write_str("without play, parts made exactly as drawn will jam"),
            Self::CanMiss { turns } => write!(
                f,
                "during the dwell the wheel can turn by {:.2}°, and the pin then hits its rim beside the slot: choose less play \
                 or a thicker pin",
                turns.to_degrees()
            ),
            Self::LargePlay { play, pin } => write!(
                f,
                "the play of {play:.3} mm is more than a tenth of the pin's {pin:.3} mm, which only a print or a rough cut needs: \
                 choose less play or a thicker pin"
            ),
            Self::LargeBacklash { at_rim, pin } => write!(
                f,
                "near the ends of the dwell the wheel's rim can move by {at_rim:.3} mm, more than a quarter of the pin's {pin:.3} \
                 mm: choose less play"
            ),
            Self::HarderMouth { times } => write!(
                f,
                "the hardest blow at entry is {times:.2} times that on a sharp corner: choose a flatter chamfer, or a longer \
                 lead-in with less flare"
            ),
            Self::ThinWall { wall, thickness } => {
                write!(f, "{wall} is only {thickness:.3} mm thick, less than a fifth of the pin: check its strength")
            }
            Self::ShallowArc { reach } => write!(
                f,
                "the locking arcs reach only {reach:.3} mm into the wheel, less than a fifth of the pin, and hardly hold it: choose a thinner \
                 pin or horn"
            ),
            Self::SmallDisc { disc, pin } => write!(
                f,
                "the locking disc is {disc:.3} mm wide, less than the pin's {pin:.3} mm: choose a thinner pin or horn"
            ),
            Self::LooserThanFit { play, fit: [least, most] } => write!(
                f,
                "the program's play of {play:.3} mm is more than a fit H8/e8 has for this pin, {least:.3} to {most:.3} mm: set \
                 the play yourself"
            ),
        }
    }
}

impl Sizes {
    /// Warnings to someone who makes these parts: no play, a wheel that can miss its pin, thin walls. Most sizes have none.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Warning, Wheel};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.0)), ..Choices::default() };
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?; // mm
    /// assert!(sizes.warnings().contains(&Warning::NoPlay));
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn warnings(&self) -> Vec<Warning> {
        let is_tight = self.play.slot == 0.0 || self.locking_gap() == Some(0.0);
        let turns = self.dwell_play().filter(|play| play.can_miss).map(|play| play.greatest);
        let thin = self.walls().filter(|(_, thickness)| *thickness < THIN * self.pin_diameter);
        let tight = is_tight.then_some(Warning::NoPlay).into_iter();
        let (play, pin) = (self.play.slot, self.pin_diameter);
        let large = (turns.is_none() && play > LARGE_PLAY * pin).then_some(Warning::LargePlay { play, pin });
        let at_rim = self.dwell_play().map(|play| play.greatest * self.tip_radius);
        let far = at_rim.filter(|at_rim| turns.is_none() && *at_rim > LARGE_BACKLASH * pin);
        tight
            .chain(large)
            .chain(far.map(|at_rim| Warning::LargeBacklash { at_rim, pin }))
            .chain(turns.map(|turns| Warning::CanMiss { turns }))
            .chain(self.harder_mouth())
            .chain(thin.map(|(wall, thickness)| Warning::ThinWall { wall, thickness }))
            .chain(self.weak_lock())
            .collect()
    }

    /// The warning that disc and arcs hardly hold the wheel in the dwell, where they do.
    fn weak_lock(&self) -> Option<Warning> {
        let (disc, pin, reach) = (2.0 * self.locking_disc?.radius, self.pin_diameter, self.arc_reach());
        // But for rounding.
        let least = (1.0 - 1e-9) * pin;
        let shallow = (reach < THIN * least).then_some(Warning::ShallowArc { reach });
        shallow.or((disc < least).then_some(Warning::SmallDisc { disc, pin }))
    }

    /// The warning that a mouth makes the hardest blow at entry harder, where it does.
    fn harder_mouth(&self) -> Option<Warning> {
        if self.mouth == Mouth::Sharp {
            return None;
        }
        let sharp = Self { mouth: Mouth::Sharp, ..*self }.knock()?.drifted;
        let times = self.knock()?.drifted / sharp;
        (times > HARDER).then_some(Warning::HarderMouth { times })
    }

    /// The warning to someone who let the program choose the play, if it is more than that of the fit H8/e8.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// // For a pin of 7.5 mm the fit has a play of up to 0.069 mm, and for one of 15 mm up to 0.086 mm.
    /// let of = |crank_radius| Sizes::new(Wheel::new(6)?, Scale::CrankRadius(crank_radius), &Choices::default());
    /// assert!(of(25.0)?.looser_than_fit().is_none()); // a play of 0.05 mm
    /// assert!(of(50.0)?.looser_than_fit().is_some()); // a play of 0.1 mm
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn looser_than_fit(&self) -> Option<Warning> {
        let (play, fit) = (self.play.slot, play_of_h8_e8_at(self.pin_diameter)?);
        (play > fit[1]).then_some(Warning::LooserThanFit { play, fit })
    }
}
