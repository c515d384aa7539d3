//! A part: a plate with holes, and where it is in the assembly.

use super::holes::{Hole, HolePurpose};
use crate::geometry::{Point, area, gap};
use crate::offset::widened;
use geneva_kinematics::wheel::{Edge, Face, Loop};

/// What a file of solids says of holes that are drawn wider or narrower than they should become; none if none is.
pub(crate) fn allowance_words(parts: &[Part]) -> Option<String> {
    let by = parts.iter().map(|part| part.hole_allowance).find(|by| *by != 0.0)?;
    let drawn = if by > 0.0 { "wider" } else { "narrower" };
    Some(format!(
        "Holes are drawn {:.3} mm {drawn} than they should become, for the machine makes them so much {}; slots are not",
        by.abs(),
        if by > 0.0 { "narrower" } else { "wider" }
    ))
}

/// A layer of the drawing; the pieces of one layer are cut from one sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// The wheel.
    Wheel,
    /// The driver's locking disc, in the wheel's plane.
    LockingDisc,
    /// The locking segment of an internal wheel's driver.
    LockingSegment,
    /// The driver's plate, behind the wheel.
    Plate,
    /// The pins, or the holes for them in the plate; where screws hold the pins, their holes are in the plate's layer.
    Pins,
    /// The plate that closes the ring of an internal wheel and carries its shaft.
    RingPlate,
    /// The plate that carries both axes.
    BasePlate,
    /// Crosses at axes and pins.
    Centres,
    /// Pockets and shoulders that don't go through a part.
    Pockets,
    /// The ladder of slots that measures the play of a machine.
    TestPiece,
}

impl Layer {
    /// All layers.
    pub const ALL: [Self; 10] = [
        Self::Wheel,
        Self::LockingDisc,
        Self::Plate,
        Self::Pins,
        Self::BasePlate,
        Self::Centres,
        Self::Pockets,
        Self::LockingSegment,
        Self::RingPlate,
        Self::TestPiece,
    ];

    /// The layer's name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wheel => "WHEEL",
            Self::LockingDisc => "LOCKING_DISC",
            Self::LockingSegment => "LOCKING_SEGMENT",
            Self::RingPlate => "RING_PLATE",
            Self::Plate => "DRIVER_PLATE",
            Self::Pins => "PINS",
            Self::BasePlate => "BASE_PLATE",
            Self::Centres => "CENTRES",
            Self::Pockets => "POCKETS",
            Self::TestPiece => "TEST_PIECE",
        }
    }

    /// What its part is called in a sentence.
    pub fn words(self) -> &'static str {
        match self {
            Self::Wheel => "wheel",
            Self::LockingDisc => "locking disc",
            Self::LockingSegment => "locking segment",
            Self::RingPlate => "ring plate",
            Self::Plate => "driver plate",
            Self::Pins => "pin",
            Self::BasePlate => "base plate",
            Self::Centres => "centre marks",
            Self::Pockets => "pockets",
            Self::TestPiece => "test piece",
        }
    }
}

/// Where a part is in the assembly, in the middle of a dwell: the wheel's axis is the origin, the driver's is at (c, 0).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Angle by which the part is turned about its own axis, in radians.
    pub turn: f64,
    /// Where its axis is, in millimetres.
    pub at: Point,
    /// Height of its lower face, in millimetres; that of the wheel is at 0.
    pub bottom: f64,
}

/// A part: a plate with holes.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// What it is.
    pub layer: Layer,
    /// Its outer line, counter-clockwise, about its own axis, in millimetres.
    pub outer: Loop,
    /// Its holes.
    pub holes: Vec<Hole>,
    /// Where its axis and the middles of its pins are marked, in millimetres.
    pub marks: Vec<Point>,
    /// What is engraved on it besides.
    pub engraved: Vec<Edge>,
    /// Its thickness, or a pin's length, in millimetres.
    pub thickness: f64,
    /// Its places in the assembly: more than one if there are several of it.
    pub places: Vec<Place>,
    /// Whether it is in one piece with the plate, where a file has solids.
    pub is_joined: bool,
    /// How much wider its holes are drawn than they should become, in millimetres; below zero narrower.
    pub hole_allowance: f64,
}

impl Part {
    /// How many of it there are.
    pub fn quantity(&self) -> usize {
        self.places.len()
    }

    /// What it is called in a sentence: a pin with a hole for its screw is a bush.
    pub fn words(&self) -> &'static str {
        if self.is_bush() { "bush" } else { self.layer.words() }
    }

    /// Whether it is the bush on a pin's screw.
    pub fn is_bush(&self) -> bool {
        self.layer == Layer::Pins && !self.holes.is_empty()
    }

    /// Its outline with the holes that go through it.
    pub fn face(&self) -> Face {
        Face { outer: self.outer.clone(), holes: self.holes.iter().map(|hole| hole.outline.clone()).collect() }
    }

    /// The part with its holes and their pockets wider by a length in millimetres, or narrower below zero: for a machine that makes them
    /// too narrow or too wide by as much. Bores with a keyway or a flat are wider on all sides, too, and their corners rounded by half
    /// of it. Slots stay as they are, since their play is chosen for the machine, and so does a hole that would have no width.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    /// use geneva_workshop::{Mounting, parts};
    ///
    /// let choices = Choices { wheel_shaft: Some(6.0), ..Choices::default() }; // mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
    /// let wheel = parts(&sizes, 5.0, &Mounting::default()).expect("bare parts").parts.remove(0);
    /// let bore = wheel.holes[0].diameter().expect("round");
    /// let wider = wheel.with_wider_holes(0.2).holes[0].diameter().expect("round");
    /// assert!((wider - bore - 0.2).abs() < 1e-12); // mm
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn with_wider_holes(mut self, by: f64) -> Self {
        self.hole_allowance += by;
        let is_hole = |hole: &&mut Hole| !matches!(hole.purpose, HolePurpose::Inside | HolePurpose::TestSlot);
        for hole in self.holes.iter_mut().filter(is_hole) {
            let pocket = hole.widening.as_mut().map(|wide| &mut wide.outline);
            for line in [&mut hole.outline].into_iter().chain(pocket) {
                if let Some(wider) = widened(line, by / 2.0) {
                    *line = wider;
                }
            }
        }
        self
    }

    /// Its volume in cubic millimetres, less the pockets.
    pub fn volume(&self) -> f64 {
        let pocket = |hole: &Hole| {
            let wide = hole.widening.as_ref()?;
            Some((area(&wide.outline) - area(&hole.outline)).abs() * wide.depth)
        };
        self.face().area() * self.thickness - self.holes.iter().filter_map(pocket).sum::<f64>()
    }

    /// Its moment of inertia about its own axis in kg m², with all holes and pockets, of a density in kg/m³.
    ///
    /// ```
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    /// use geneva_workshop::{Mounting, ShaftFit, parts};
    ///
    /// let choices = Choices { wheel_shaft: Some(12.0), ..Choices::default() }; // mm
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &choices)?;
    /// let of = |wheel_fit| {
    ///     let list = parts(&sizes, 5.0, &Mounting { wheel_fit, ..Mounting::default() }).expect("they fit");
    ///     list.parts[0].moment_of_inertia(7800.0)
    /// };
    /// assert!(of(ShaftFit::Key) < of(ShaftFit::Round) && of(ShaftFit::Round) < of(ShaftFit::Flat { across: 10.0 }));
    /// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
    /// ```
    pub fn moment_of_inertia(&self, density: f64) -> f64 {
        let second_moment = |outer: &Loop| Face { outer: outer.clone(), holes: Vec::new() }.second_moment();
        let pocket = |hole: &Hole| {
            let wide = hole.widening.as_ref()?;
            Some((second_moment(&wide.outline) - second_moment(&hole.outline)).abs() * wide.depth)
        };
        let pockets = self.holes.iter().filter_map(pocket).sum::<f64>();
        // From mm⁵ to m⁵.
        (self.face().second_moment() * self.thickness - pockets) * density * 1e-15
    }

    /// The least distance between its bore, with a keyway or a flat, and its outer line in millimetres; none without a bore.
    pub fn bore_web(&self) -> Option<f64> {
        let bore = self.holes.iter().find(|hole| hole.purpose == HolePurpose::Bore)?;
        let pairs = bore.outline.edges.iter().flat_map(|one| self.outer.edges.iter().map(move |other| gap(one, other)));
        Some(pairs.fold(f64::INFINITY, f64::min))
    }

    /// Whether it is cut out of a sheet.
    pub fn is_cut(&self) -> bool {
        self.layer != Layer::Pins
    }
}
