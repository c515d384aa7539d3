//! Walls of the driver's parts, and the list of all walls that can be too thin to be made or to last.
//!
//! Notation: `q` distance of a crescent's centre from the driver's axis, ρ its radius, `P` pins, β = π/P half the angle between
//! two pins.
//!
//! Two walls of wheel and driver are thicker than others wherever they are: between a locking arc and the wheel's bore is
//! more than between a slot's end and the bore, and between the disc's rim and its bore more than between crescent and bore.

use super::sizes::Sizes;
use super::warnings::THIN;
use crate::indexing::Indexing;
use std::f64::consts::PI;

impl Sizes {
    /// Least thickness of the locking disc between a crescent and the driver's bore, in millimetres. None without a disc, and
    /// where the driver's shaft ends in the plate.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let of = |driver_shaft| {
    ///     let choices = Choices { driver_shaft: Some(driver_shaft), ..Choices::default() };
    ///     Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)
    /// };
    /// // A shaft that is thicker by 1 mm leaves half as much less.
    /// let [thin, thick] = [of(5.0)?, of(6.0)?].map(|sizes| sizes.disc_web().expect("a disc with a bore"));
    /// assert!((thin - thick - 0.5).abs() < 1e-12); // mm
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn disc_web(&self) -> Option<f64> {
        let cut = self.locking_disc?.crescent;
        (self.driver_bore() > 0.0).then(|| cut.centre - cut.radius - self.driver_bore() / 2.0)
    }

    /// Least thickness of the locking disc between two neighbouring crescents, in millimetres. None without a disc, and with one
    /// pin.
    ///
    /// It is twice the distance of a crescent from the line midway between the two pins: q sin β − ρ, or that of an edge of
    /// the opening where the crescent comes no nearer within the disc.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let sizes = Sizes::new(Wheel::with_pins(6, 2)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
    /// let cut = sizes.locking_disc.expect("a dwell").crescent;
    /// // Two crescents opposite each other leave a waist across the driver's axis.
    /// let waist = 2.0 * (cut.centre - cut.radius);
    /// assert!(sizes.crescent_web().is_some_and(|web| (web - waist).abs() < 1e-12));
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn crescent_web(&self) -> Option<f64> {
        let (disc, pins) = (self.locking_disc?, self.wheel.pins());
        let (cut, half) = (disc.crescent, PI / f64::from(pins));
        let edge = disc.radius * libm::sin(half - cut.half_angle);
        // How far from the driver's axis, along the line midway, the crescent or its continuation is nearest to it.
        let (nearest, end) = (cut.centre * libm::cos(half), disc.radius * libm::cos(half - cut.half_angle));
        let arc = if nearest < end { cut.centre * libm::sin(half) - cut.radius } else { edge };
        (pins > 1).then_some(2.0 * arc.min(edge))
    }

    /// Thickness of the driver's plate between a pin and the plate's rim, in millimetres.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
    /// // Where the wheel's shaft leaves it room it is half the pin's diameter.
    /// assert!((sizes.plate_rim() - sizes.pin_radius()).abs() < 1e-12);
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn plate_rim(&self) -> f64 {
        self.plate_radius - self.crank_radius - self.pin_radius()
    }

    /// Least thickness of the driver's plate between a pin and the bore, in millimetres. None without a bore.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
    ///
    /// let play = Play { bore: 0.1, ..Play::from_slot(0.2) }; // mm
    /// let choices = Choices { pin_diameter: Some(10.0), plate_shaft: Some(40.0), play: Some(play), ..Choices::default() };
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
    /// // From the middle of the pin half of it and half of the bore are away.
    /// assert!(sizes.plate_web().is_some_and(|web| (web - (50.0 - 5.0 - 20.05)).abs() < 1e-12)); // mm
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn plate_web(&self) -> Option<f64> {
        (self.plate_bore() > 0.0).then(|| self.crank_radius - self.pin_radius() - self.plate_bore() / 2.0)
    }

    /// Whether all that is left of the parts can be made: no wall is so thin that it gets a warning, the locking disc has at least the
    /// radius of a pin, and the locking arcs reach into the wheel by at least a fifth of its diameter. Both are our choice.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let of = |horn_thickness| {
    ///     Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices { horn_thickness, ..Choices::default() }) // mm
    /// };
    /// assert!(of(None)?.has_sound_walls());
    /// assert!(!of(Some(0.1))?.has_sound_walls());
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn has_sound_walls(&self) -> bool {
        // But for rounding.
        let least = (1.0 - 1e-9) * THIN * self.pin_diameter;
        let reach = self.arc_reach();
        let has_disc = self.locking_disc.is_none_or(|disc| disc.radius >= (1.0 - 1e-9) * self.pin_radius());
        has_disc && reach >= least && self.walls().all(|(_, thickness)| thickness >= least)
    }

    /// How far the locking arcs reach into the wheel from its rim, in millimetres.
    pub(super) fn arc_reach(&self) -> f64 {
        self.locking_arc_radius + self.tip_radius - self.centre_distance
    }

    /// All walls that may be too thin, with their thickness in millimetres: of the wheel, of the disc, of the plate.
    pub(super) fn walls(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let walls = [
            ("the horn", Some(self.horn_thickness)),
            ("the horn at the mouth", self.mouth_horn()),
            ("the web between two slots", Some(self.web)),
            ("the web at the bore", Some(self.bore_web()).filter(|_| self.wheel_bore() > 0.0)),
            ("the locking disc between crescent and bore", self.disc_web()),
            ("the locking disc between two crescents", self.crescent_web()),
            ("the plate outside the pin", Some(self.plate_rim())),
            ("the plate between pin and bore", self.plate_web()),
        ];
        walls.into_iter().filter_map(|(wall, thickness)| Some((wall, thickness?)))
    }
}
