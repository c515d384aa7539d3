//! What a process does to the parts: its errors, the play that they ask for, corners, holes and kerf, each with its source.

use super::errors::SizeErrors;
use crate::KinematicsError;
use crate::error::{length, size};
use crate::wheel::Play;

/// A way to make the parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Process {
    /// Ground or wire-cut metal.
    Ground,
    /// Metal milled on a machining centre.
    Mill,
    /// Sheet routed with a spinning cutter.
    Router,
    /// Sheet cut by a laser.
    Laser,
    /// Resin cured layer by layer (SLA, DLP).
    Resin,
    /// Filament laid layer by layer (FDM, FFF).
    Fdm,
}

/// A number and where it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SourcedNumber {
    /// The number, in millimetres.
    pub value: f64,
    /// Its source, or that it is our choice.
    pub source: &'static str,
}

/// What a process does to parts of a size.
///
/// ```
/// use geneva_kinematics::wheel::as_built::{Process, ProcessNumbers};
///
/// let printed = ProcessNumbers::new(Process::Fdm, 50.0)?; // mm
/// let ground = ProcessNumbers::new(Process::Ground, 50.0)?;
/// assert!(printed.error.value > 10.0 * ground.error.value);
/// assert!(printed.slot_play.value > 2.0 * printed.error.value); // the errors of slot and pin leave some play
/// # Ok::<(), geneva_kinematics::KinematicsError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProcessNumbers {
    /// The process.
    pub process: Process,
    /// The greatest error of a size to either side, in millimetres.
    pub error: SourcedNumber,
    /// Width of a slot less the pin's diameter, in millimetres.
    pub slot_play: SourcedNumber,
    /// Diameter of the locking arcs less that of the disc, in millimetres.
    pub locking_play: SourcedNumber,
    /// Diameter of a bore less that of its shaft, in millimetres.
    pub bore_play: SourcedNumber,
    /// Play of the wheel along its axis, in millimetres.
    pub axial_play: SourcedNumber,
    /// Least radius of an inner corner, in millimetres.
    pub corner_radius: SourcedNumber,
    /// How much wider holes become than drawn, in millimetres; below zero narrower.
    pub hole_growth: SourcedNumber,
    /// Width of the cut that is lost if it is not allowed for, in millimetres.
    pub kerf: SourcedNumber,
}

const CHOICE: &str = "our choice";
const NONE: SourcedNumber = SourcedNumber { value: 0.0, source: CHOICE };
const TOLERANCE_UNIT: &str =
    "ISO 286-1:1988, annex A: a tolerance is a multiple of i = 0.45 ∛D + 0.001 D; the grade is our choice";
const BIG_BLUE_SAW: &str = "Big Blue Saw, quality of laser-cut parts: tolerance 0.005 in";
const SNIJLAB: &str = "Snijlab, kerf width: about 0.2 mm in most materials";
const ROUTED: &str =
    "cxcnwood.com, tolerances in wood milling: ±0.1 to ±0.3 mm for jigs of engineered wood; the middle is our choice";
const RESIN: &str = "Layer X, 3D printing tolerances (2026): SLA ±0.1 mm standard";
const FDM: &str = "printparams.com, designing for real-world fit: ±0.2 mm on a well-tuned printer";
const FDM_HOLES: &str =
    "Layer X, 3D printing tolerances (2026): holes 0.1 to 0.3 mm undersize; the middle is our choice";
const FDM_BORE: &str = "Makelab, clearance of two fitting parts: 0.4 mm for FDM";
const RESIN_BORE: &str = "Makelab, clearance of two fitting parts: 0.25 mm for SLA";
const FOUR_ERRORS: &str = "our choice: four times the error of a size";

const QUARTER: &str = "our choice: a quarter of the play of the slots";

/// The play of bores that is a quarter of that of the slots.
fn quarter_of(slot_play: SourcedNumber) -> SourcedNumber {
    SourcedNumber { value: slot_play.value / 4.0, source: QUARTER }
}

/// Play of slot and locking arc over the error of a size, dimensionless: our choice.
const PLAY_OF_ERROR: f64 = 4.0;

impl Process {
    /// All processes, the finest first.
    pub const ALL: [Self; 6] = [Self::Ground, Self::Mill, Self::Router, Self::Laser, Self::Resin, Self::Fdm];

    /// The name as it is typed.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ground => "ground",
            Self::Mill => "mill",
            Self::Router => "router",
            Self::Laser => "laser",
            Self::Resin => "resin",
            Self::Fdm => "fdm",
        }
    }

    /// What it is, in words.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Ground => "Ground or wire-cut metal",
            Self::Mill => "Metal milled on a machining centre",
            Self::Router => "Sheet routed with a spinning cutter",
            Self::Laser => "Sheet cut by a laser",
            Self::Resin => "Resin cured layer by layer (SLA, DLP)",
            Self::Fdm => "Filament laid layer by layer (FDM, FFF)",
        }
    }

    /// The greatest error of a size, and its source. The length is in millimetres.
    fn error(self, length: f64) -> SourcedNumber {
        // In millimetres.
        let unit = (0.45 * libm::cbrt(length) + 0.001 * length) / 1000.0;
        let (value, source) = match self {
            // Half of IT6, which is 10 i; half of IT8, which is 25 i.
            Self::Ground => (5.0 * unit, TOLERANCE_UNIT),
            Self::Mill => (12.5 * unit, TOLERANCE_UNIT),
            Self::Router => (0.2, ROUTED),
            Self::Laser => (0.127, BIG_BLUE_SAW),
            Self::Resin => (0.1, RESIN),
            Self::Fdm => (0.2, FDM),
        };
        SourcedNumber { value, source }
    }
}

impl ProcessNumbers {
    /// The numbers of a process for parts whose largest size that counts, the centre distance, is this length in millimetres.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Length`] for a length that is not positive and finite.
    pub fn new(process: Process, centre_distance: f64) -> Result<Self, KinematicsError> {
        let error = process.error(length("centre distance", centre_distance)?);
        let play = SourcedNumber { value: PLAY_OF_ERROR * error.value, source: FOUR_ERRORS };
        let chosen = |value| SourcedNumber { value, source: CHOICE };
        let of = |value, source| SourcedNumber { value, source };
        let quarter = quarter_of(play);
        let [bore_play, axial_play, corner_radius, hole_growth, kerf] = match process {
            Process::Ground => [quarter, chosen(0.05), chosen(0.15), NONE, NONE],
            Process::Mill => [quarter, chosen(0.1), chosen(1.5), NONE, NONE],
            Process::Router => [quarter, chosen(0.5), chosen(1.5875), NONE, NONE],
            Process::Laser => [quarter, chosen(0.5), of(0.1, SNIJLAB), NONE, of(0.2, SNIJLAB)],
            Process::Resin => [of(0.25, RESIN_BORE), chosen(0.2), chosen(0.05), chosen(-0.05), NONE],
            Process::Fdm => [of(0.4, FDM_BORE), chosen(0.4), chosen(0.2), of(-0.2, FDM_HOLES), NONE],
        };
        Ok(Self {
            process,
            error,
            slot_play: play,
            locking_play: play,
            bore_play,
            axial_play,
            corner_radius,
            hole_growth,
            kerf,
        })
    }

    /// The numbers with a play measured on a test piece: the least one in millimetres with which the pin ran. Slot and locking arc get
    /// that and a rung of the ladder, and the error is a quarter of it. So is the play of the bores, unless the process has one of its own.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::{Process, ProcessNumbers};
    ///
    /// let measured = ProcessNumbers::new(Process::Fdm, 50.0)?.with_measured_play(0.3)?; // mm
    /// assert!((measured.slot_play.value - 0.35).abs() < 1e-12 && measured.error.value < 0.1);
    /// # Ok::<(), geneva_kinematics::KinematicsError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`KinematicsError::Size`] for a play that is not positive and finite.
    pub fn with_measured_play(self, play: f64) -> Result<Self, KinematicsError> {
        const MEASURED: &str = "measured on the test piece, and a rung of its ladder";
        let play = size("measured play in mm", play)? + super::test_piece::RUNG;
        let slot_play = SourcedNumber { value: play, source: MEASURED };
        let error =
            SourcedNumber { value: play / PLAY_OF_ERROR, source: "a quarter of the play measured on the test piece" };
        // Bores whose play follows that of the slots follow it here, too.
        let is_quarter = self.bore_play.source == QUARTER;
        let bore_play = if is_quarter { quarter_of(slot_play) } else { self.bore_play };
        Ok(Self { error, slot_play, locking_play: slot_play, bore_play, ..self })
    }

    /// The plays, in millimetres, of pins in their place.
    pub fn play(&self) -> Play {
        Play { slot: self.slot_play.value, locking: self.locking_play.value, bore: self.bore_play.value, pin: 0.0 }
    }

    /// The greatest error of each size, in millimetres. Diameters and widths have the whole error, radii half of it.
    pub fn errors(&self) -> SizeErrors {
        let half = self.error.value / 2.0;
        SizeErrors {
            tip_radius: half,
            arc_radius: half,
            disc_radius: half,
            crescent_radius: half,
            place: half,
            ..SizeErrors::from_greatest(self.error.value)
        }
    }

    /// The least inner corner that a wheel with slots of this width in millimetres needs, in millimetres, if the process can't make it;
    /// none if it can. The slots' round ends are the tightest inner corners.
    pub fn corner_too_large(&self, slot_width: f64) -> Option<f64> {
        let least = slot_width / 2.0;
        (self.corner_radius.value > least).then_some(least)
    }
}
