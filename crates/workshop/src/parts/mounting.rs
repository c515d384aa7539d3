//! How wheel and driver are fastened: what a designer chooses besides the sizes.

use super::standards::Thread;

/// How a shaft carries its part along.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ShaftFit {
    /// A round bore: pressed, glued or clamped.
    #[default]
    Round,
    /// A keyway by DIN 6885-1 for the shaft's diameter.
    Key,
    /// A bore with a flat, for a shaft of which a piece is milled off.
    Flat {
        /// From the flat to the opposite side of the shaft, in millimetres: 4.5 for many motors with a shaft of 5 mm.
        across: f64,
    },
}

/// A hole for a screw of a thread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScrewHole {
    /// The screw passes: ISO 273, medium.
    Clearance,
    /// A thread is cut into it.
    Tapped,
    /// The screw passes, and a pocket from below holds its nut: ISO 4032.
    NutTrap,
}

impl ScrewHole {
    /// All holes, with their names as they are typed.
    pub const ALL: [(&'static str, Self); 3] =
        [("clearance", Self::Clearance), ("tapped", Self::Tapped), ("nut-trap", Self::NutTrap)];
}

/// What goes through a hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fastener {
    /// A dowel of this diameter in millimetres, pressed in: the hole has its diameter.
    Dowel(f64),
    /// A screw.
    Screw(Thread, ScrewHole),
}

impl Fastener {
    /// Diameter of the hole, in millimetres.
    pub fn hole(self) -> f64 {
        match self {
            Self::Dowel(diameter) => diameter,
            Self::Screw(thread, ScrewHole::Tapped) => thread.tapping_hole(),
            Self::Screw(thread, ScrewHole::Clearance | ScrewHole::NutTrap) => thread.clearance_hole(),
        }
    }
}

/// Equal holes evenly on a circle about an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pattern {
    /// How many: from 2 to 12.
    pub count: u32,
    /// Diameter of the circle on which their centres are, in millimetres.
    pub circle: f64,
    /// What goes through them.
    pub fastener: Fastener,
}

/// Most holes of a pattern.
pub(super) const MOST_HOLES: u32 = 12;

/// How the pins are held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PinMount {
    /// In one piece with the plate where the driver is one piece, and else as dowels.
    #[default]
    Solid,
    /// Dowels as thick as the pins, pressed into the plate.
    Dowel,
    /// Screws through the plate; a bush on a screw that is thinner than the pin is as thick as that.
    Screw(Thread, ScrewHole),
}

/// The base plate, which carries both axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BasePlate {
    /// Its thickness, in millimetres; by default that of the other parts.
    pub thickness: Option<f64>,
    /// Wider holes from above into which a shoulder of each shaft goes, or a bush: their diameter and depth, in millimetres.
    pub shoulder: Option<[f64; 2]>,
    /// Screws at its corners, which hold it.
    pub screws: Option<Thread>,
}

/// How the parts are mounted; the default is bare parts with marks at the axes.
///
/// ```
/// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
/// use geneva_workshop::{Fastener, Mounting, Pattern, ScrewHole, Thread, parts};
///
/// // Three screws M4 on a circle of 16 mm hold the wheel on its hub.
/// let fastener = Fastener::Screw(Thread::M4, ScrewHole::Clearance);
/// let hub = Pattern { count: 3, circle: 16.0, fastener }; // mm
/// let mounting = Mounting { wheel_hub: Some(hub), ..Mounting::default() };
/// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(50.0), &Choices::default())?; // mm
/// let wheel = &parts(&sizes, 6.0, &mounting).expect("the holes fit").parts[0];
/// assert_eq!(wheel.holes.len(), 3);
/// # Ok::<(), geneva_kinematics::wheel::SizesError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mounting {
    /// How the wheel's shaft carries the wheel.
    pub wheel_fit: ShaftFit,
    /// How the driver's shaft carries plate and locking disc.
    pub driver_fit: ShaftFit,
    /// Screws or dowels through the wheel.
    pub wheel_hub: Option<Pattern>,
    /// Screws or dowels through locking disc and plate, or through the plate where there is no disc.
    pub driver_hub: Option<Pattern>,
    /// How the pins are held.
    pub pins: PinMount,
    /// Dowels that hold the locking disc on the plate.
    pub disc_dowels: Option<Pattern>,
    /// Whether locking disc and plate are two pieces also in files of solids. Dowels between them make them two.
    pub is_stacked: bool,
    /// A plate that carries both axes.
    pub base: Option<BasePlate>,
    /// Gap between wheel and plate along the axes, in millimetres; by default as the play of the slots.
    pub axial_play: Option<f64>,
}

impl Mounting {
    /// Whether locking disc and plate are two pieces.
    pub fn disc_is_apart(&self) -> bool {
        self.is_stacked || self.disc_dowels.is_some()
    }
}
