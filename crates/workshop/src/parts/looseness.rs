//! How loosely parts are held where they are mounted: on a shaft with a flat, by screws in clearance holes.
//!
//! A thread centres its screw, a key its part, and dowels leave no play: our choice, since all three leave less than the holes that
//! are counted here.

use super::mounting::{Fastener, Mounting, Pattern, PinMount, ScrewHole, ShaftFit};
use super::standards::Thread;
use geneva_kinematics::wheel::{FlattedShaft, Sizes};

/// A pin and a screw as thick as each other to within this length in millimetres are one.
pub(super) const SAME: f64 = 1e-9;

/// Least thickness of the wall of a bush, in millimetres: two lines of a printer, or what a lathe turns without a mandrel; our choice.
const BUSH_WALL: f64 = 1.0;

impl Thread {
    /// The least diameter of a bush on the screw, in millimetres.
    ///
    /// ```
    /// use geneva_workshop::Thread;
    ///
    /// assert_eq!(Thread::M4.least_bush(), 6.5); // mm: a wall of 1 mm around the hole of 4.5 mm
    /// ```
    pub fn least_bush(self) -> f64 {
        self.clearance_hole() + 2.0 * BUSH_WALL
    }

    /// Whether a pin of this diameter in millimetres can be the screw itself, or a bush on it.
    pub fn holds_pin(self, diameter: f64) -> bool {
        (diameter - self.diameter()).abs() < SAME || diameter >= self.least_bush()
    }

    /// How far the screw may be off the middle of its clearance hole, in millimetres.
    fn room(self) -> f64 {
        (self.clearance_hole() - self.diameter()) / 2.0
    }

    /// How far the screw may be off the middle of such a hole, in millimetres.
    fn room_in(self, hole: ScrewHole) -> f64 {
        match hole {
            ScrewHole::Tapped => 0.0,
            ScrewHole::Clearance | ScrewHole::NutTrap => self.room(),
        }
    }
}

impl PinMount {
    /// How far a pin of this diameter may be off its place in any direction, in millimetres, as it is mounted: a screw in its hole in
    /// the plate, and a bush on its screw.
    ///
    /// ```
    /// use geneva_workshop::{PinMount, ScrewHole, Thread};
    ///
    /// // A hole of 3.4 mm for M3 in the plate, and another in the bush.
    /// let bush = PinMount::Screw(Thread::M3, ScrewHole::Clearance).shift(6.0);
    /// assert!((bush - 0.4).abs() < 1e-12); // mm
    /// assert!((PinMount::Screw(Thread::M3, ScrewHole::Tapped).shift(6.0) - 0.2).abs() < 1e-12);
    /// assert_eq!(PinMount::Dowel.shift(6.0), 0.0);
    /// ```
    pub fn shift(self, pin_diameter: f64) -> f64 {
        let Self::Screw(thread, hole) = self else { return 0.0 };
        let on_screw = if (pin_diameter - thread.diameter()).abs() < SAME { 0.0 } else { thread.room() };
        thread.room_in(hole) + on_screw
    }
}

impl ShaftFit {
    /// How far a part turns loosely on its shaft to either side, in radians, with a shaft of this diameter and such a play of the bore,
    /// in millimetres. None without a flat, without a shaft, and where the flat does not hold.
    pub fn turning_play(self, diameter: f64, play: f64) -> Option<f64> {
        let Self::Flat { across } = self else { return None };
        FlattedShaft { diameter, across, play }.turning_play()
    }
}

impl Mounting {
    /// By what angle the locking disc of these sizes may be turned against its plate to either side, in radians. Zero where it is in one
    /// piece with the plate, where key or dowels hold both, and where neither flat nor screws say how it is turned: then it must be
    /// placed by other means.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
    /// use geneva_workshop::{Mounting, ShaftFit};
    ///
    /// let play = Play { bore: 0.05, ..Play::from_slot(0.2) }; // mm
    /// let choices = Choices { driver_shaft: Some(5.0), play: Some(play), ..Choices::default() };
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
    /// let stacked = Mounting { driver_fit: ShaftFit::Flat { across: 4.5 }, is_stacked: true, ..Mounting::default() };
    /// assert!(stacked.disc_turn(&sizes) > 0.05); // rad: disc and plate are both loose on the flat
    /// assert_eq!(Mounting { is_stacked: false, ..stacked }.disc_turn(&sizes), 0.0);
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn disc_turn(&self, sizes: &Sizes) -> f64 {
        let of_hub = match self.driver_hub {
            Some(Pattern { circle, fastener: Fastener::Screw(thread, hole), .. }) => {
                Some((thread.room() + thread.room_in(hole)) / (circle / 2.0))
            }
            Some(Pattern { fastener: Fastener::Dowel(_), .. }) => Some(0.0),
            None => None,
        };
        let on = |shaft| self.driver_fit.turning_play(shaft, sizes.play.bore);
        let of_shaft = match self.driver_fit {
            ShaftFit::Key => Some(0.0),
            ShaftFit::Flat { .. } => {
                on(sizes.driver_shaft).zip(on(sizes.plate_shaft)).map(|(disc, plate)| disc + plate)
            }
            ShaftFit::Round => None,
        };
        if !self.is_stacked || self.disc_dowels.is_some() {
            return 0.0;
        }
        of_hub.into_iter().chain(of_shaft).reduce(f64::min).unwrap_or(0.0)
    }
}
