//! Of many wheels that are made with errors, how many turn?
//!
//! Every size of every assembly is drawn by itself. Assembly i of a seed has numbers of its own, so the share does not depend on
//! which is drawn first, or by which thread.
//!
//! A part that is loose on its shaft has its axis somewhere within the play of its bore, in any direction. Wheel and driver see of
//! both shifts only the distance between their axes: turning the line of centres turns the angles of both alike. A pin on a screw is
//! likewise somewhere within the clearance of its holes, and a locking disc that is a piece of its own somewhere within the angle by
//! which it turns loosely against its plate. That all these places are equally likely is our choice.

use super::errors::{BuiltError, ErrorShape, SizeErrors};
use super::parts::{AsBuiltWheel, BuiltArc, BuiltCrescent, BuiltPin, BuiltSlot};
use super::random::SplitMix64;
use crate::indexing::Indexing;
use nalgebra::Vector2;

/// Assemblies of one design, each made with errors of its own.
///
/// ```
/// use geneva_kinematics::wheel::as_built::{Assemblies, ErrorShape, SizeErrors};
/// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
///
/// let choices = Choices { play: Some(Play::from_slot(0.5)), pin_diameter: Some(6.0), ..Choices::default() }; // mm
/// let sizes = Sizes::new(Wheel::new(4)?, Scale::CrankRadius(25.0), &choices)?;
/// let assemblies = Assemblies::new(&sizes, SizeErrors::from_greatest(0.05), ErrorShape::Uniform, 1);
/// let found = assemblies.count(0..50)?;
/// assert_eq!(found.turning, found.tried); // with so much play all of them turn
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Assemblies {
    drawn: AsBuiltWheel,
    errors: SizeErrors,
    shape: ErrorShape,
    seed: u64,
    is_alike: bool,
    bore_play: f64,
    pin_shift: f64,
    disc_turn: f64,
}

/// How many assemblies were tried, and how many of them turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Yield {
    /// How many were tried.
    pub tried: u64,
    /// How many of them turn.
    pub turning: u64,
}

/// The greatest angle by which a disc is turned, over half a pitch.
const MOST_TURN: f64 = 0.9;

impl Yield {
    /// The share that turns, from 0 to 1, dimensionless; of none tried, 0.
    pub fn share(self) -> f64 {
        if self.tried == 0 { 0.0 } else { self.turning as f64 / self.tried as f64 }
    }

    /// Both counts of two groups of assemblies together.
    pub fn plus(self, other: Self) -> Self {
        Self { tried: self.tried + other.tried, turning: self.turning + other.turning }
    }

    /// The interval that has the true share with a probability of 95 %, by Wilson's score; both ends dimensionless.
    ///
    /// E. B. Wilson, J. Am. Stat. Assoc. 22 (1927) 209.
    pub fn interval(self) -> [f64; 2] {
        if self.tried == 0 {
            return [0.0, 1.0];
        }
        const Z: f64 = 1.959_963_984_540_054;
        let (n, p) = (self.tried as f64, self.share());
        let middle = (p + Z * Z / (2.0 * n)) / (1.0 + Z * Z / n);
        let half = Z * (p * (1.0 - p) / n + Z * Z / (4.0 * n * n)).sqrt() / (1.0 + Z * Z / n);
        [(middle - half).max(0.0), if self.turning == self.tried { 1.0 } else { (middle + half).min(1.0) }]
    }
}

impl Assemblies {
    /// Assemblies of a design with these greatest errors, so spread, under a seed.
    pub fn new(drawn: impl Into<AsBuiltWheel>, errors: SizeErrors, shape: ErrorShape, seed: u64) -> Self {
        Self {
            drawn: drawn.into(),
            errors,
            shape,
            seed,
            is_alike: false,
            bore_play: 0.0,
            pin_shift: 0.0,
            disc_turn: 0.0,
        }
    }

    /// The assemblies whose slots have the same errors of width, end and rim, and whose arcs the same of their radius, as if all were
    /// cut with one tool; likewise pins and crescents. Only their directions have errors of their own.
    pub fn alike(self) -> Self {
        Self { is_alike: true, ..self }
    }

    /// The assemblies with wheel and driver loose on their shafts by this play, the bore's diameter less the shaft's, in millimetres.
    /// Each axis is then anywhere within half of it from where it should be, all places being equally likely, and stays there.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::{Assemblies, ErrorShape, SizeErrors};
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.2)), pin_diameter: Some(6.0), ..Choices::default() }; // mm
    /// let sizes = Sizes::new(Wheel::new(4)?, Scale::CrankRadius(25.0), &choices)?;
    /// let tight = Assemblies::new(&sizes, SizeErrors::from_greatest(0.05), ErrorShape::Uniform, 1);
    /// let loose = tight.clone().with_bore_play(0.3); // mm
    /// assert!(loose.count(0..50)?.turning < tight.count(0..50)?.turning);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_bore_play(self, bore_play: f64) -> Self {
        Self { bore_play, ..self }
    }

    /// The assemblies whose pins are off their places by up to this, in millimetres, in any direction, as screws hold them in
    /// clearance holes. All places within are equally likely, and each pin stays where it is.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::{Assemblies, ErrorShape, SizeErrors};
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.2)), pin_diameter: Some(6.0), ..Choices::default() }; // mm
    /// let sizes = Sizes::new(Wheel::new(4)?, Scale::CrankRadius(25.0), &choices)?;
    /// let pressed = Assemblies::new(&sizes, SizeErrors::from_greatest(0.05), ErrorShape::Uniform, 1);
    /// let screwed = pressed.clone().with_pin_shift(0.3); // mm
    /// assert!(screwed.count(0..50)?.turning < pressed.count(0..50)?.turning);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_pin_shift(self, pin_shift: f64) -> Self {
        Self { pin_shift, ..self }
    }

    /// The assemblies whose locking disc is turned against its plate by up to this angle to either side, in radians, and stays so;
    /// all angles within are equally likely. More than nine tenths of half a pitch count as that, with which no wheel turns.
    pub fn with_disc_turn(self, disc_turn: f64) -> Self {
        Self { disc_turn: disc_turn.min(MOST_TURN * self.drawn.wheel().half_pitch_angle()), ..self }
    }

    /// The assembly with a number.
    pub fn assembly(&self, number: u64) -> AsBuiltWheel {
        let (mut built, [wheel, driver]) = self.loose_assembly(number);
        if self.bore_play != 0.0 {
            built.centre_distance = (driver - wheel).norm();
        }
        built
    }

    /// The assembly with a number, its centre distance being that of the shafts, and the places of the wheel's and of the driver's
    /// axis in millimetres: the wheel's shaft is at the origin, the driver's on the first axis.
    pub fn loose_assembly(&self, number: u64) -> (AsBuiltWheel, [Vector2<f64>; 2]) {
        let mut random = SplitMix64::of_index(self.seed, number);
        let mut built = self.of_random(&mut random);
        // After all sizes, which are then the same with every play.
        let [wheel, driver] = [0; 2].map(|_| random.next_within(self.bore_play / 2.0));
        if self.pin_shift != 0.0 {
            for pin in built.pins_mut() {
                let shift = random.next_within(self.pin_shift);
                let (along, across) = (pin.crank_radius + shift.x, shift.y);
                pin.direction_error += libm::atan2(across, along);
                pin.crank_radius = libm::hypot(along, across);
            }
        }
        if self.disc_turn != 0.0 {
            let turn = self.disc_turn * random.next_signed();
            built.pins_mut().iter_mut().for_each(|pin| pin.crescent.direction_error += turn);
        }
        let shaft = Vector2::new(built.centre_distance, 0.0);
        (built, [wheel, shaft + driver])
    }

    /// An assembly whose sizes are drawn with these numbers.
    fn of_random(&self, random: &mut SplitMix64) -> AsBuiltWheel {
        let mut error = |greatest: f64| greatest * self.shape.draw(random);
        let (mut built, errors) = (self.drawn.clone(), self.errors);
        built.centre_distance += error(errors.centre_distance);
        if let Some(disc) = &mut built.disc_radius {
            *disc += error(errors.disc_radius);
        }
        for slot in built.slots_mut() {
            slot.direction_error += error(errors.place) / slot.tip_radius;
            slot.width += error(errors.slot_width);
            slot.end += error(errors.slot_end);
            slot.tip_radius += error(errors.tip_radius);
        }
        for arc in built.arcs_mut() {
            arc.direction_error += error(errors.place) / arc.centre;
            arc.radius += error(errors.arc_radius);
            arc.centre += error(errors.place);
        }
        for pin in built.pins_mut() {
            pin.direction_error += error(errors.place) / pin.crank_radius;
            pin.crank_radius += error(errors.crank_radius);
            pin.diameter += error(errors.pin_diameter);
            pin.crescent.direction_error += error(errors.place) / pin.crescent.centre;
            pin.crescent.centre += error(errors.place);
            pin.crescent.radius += error(errors.crescent_radius);
        }
        if self.is_alike {
            make_alike(&mut built);
        }
        built
    }

    /// How many of the assemblies with these numbers turn.
    ///
    /// # Errors
    ///
    /// [`BuiltError`] where errors are so great that a size is none.
    pub fn count(&self, numbers: std::ops::Range<u64>) -> Result<Yield, BuiltError> {
        let mut found = Yield::default();
        for number in numbers {
            let turns = self.assembly(number).turns()?;
            found = found.plus(Yield { tried: 1, turning: u64::from(turns) });
        }
        Ok(found)
    }
}

/// Gives all slots, arcs and pins the sizes of the first, but for their directions.
fn make_alike(built: &mut AsBuiltWheel) {
    let (slot, arc, pin) = (built.slots()[0], built.arcs()[0], built.pins()[0]);
    for other in built.slots_mut() {
        *other = BuiltSlot { direction_error: other.direction_error, ..slot };
    }
    for other in built.arcs_mut() {
        *other = BuiltArc { direction_error: other.direction_error, ..arc };
    }
    for other in built.pins_mut() {
        let direction_error = other.crescent.direction_error;
        let crescent = BuiltCrescent { direction_error, ..pin.crescent };
        *other = BuiltPin { direction_error: other.direction_error, crescent, ..pin };
    }
}
