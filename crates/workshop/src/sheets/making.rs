//! All that the views are made from, and what limits and words a process asks for.

use super::callout::Row;
use super::dimension::{Measured, PrintedDimension};
use super::drawn_sizes::DrawnSizes;
use super::length::mm;
use super::limits::{BORE, Chain, LimitOrigin, Limits, SHAFT, general_tolerance, to_micrometres, whole_micrometres};
use crate::parts::{Layer, Mounting, Part, Pattern, PinMount, axial_play};
use geneva_kinematics::wheel::SharedTolerance;
use geneva_kinematics::wheel::as_built::{Process, ProcessNumbers};

/// What the limits on the sheets come from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SheetLimits {
    /// What the tolerance chains leave to all sizes at their worst; without it, limits are what is usual.
    pub shared: Option<SharedTolerance>,
    /// What the process holds; without it, that of a good workshop for metal.
    pub process: Option<ProcessNumbers>,
    /// The share of assemblies that turn with the errors of the process, from 0 to 1; of an internal wheel a lower bound.
    pub yield_share: Option<f64>,
}

/// All that the views are made from.
pub(super) struct Making<'a> {
    pub sizes: DrawnSizes<'a>,
    pub mounting: &'a Mounting,
    pub chain: Chain,
    pub limits: SheetLimits,
    /// Whether the pins are of metal, also beside parts that are not.
    pub has_metal_pins: bool,
}

/// A size in millimetres as it is printed, in whole micrometres.
fn printed(size: f64) -> f64 {
    libm::round(size * 1000.0) / 1000.0
}

/// The least number of whole micrometres that is no less than a length of either sign, in millimetres.
fn signed_micrometres_up(length: f64) -> f64 {
    if length < 0.0 { -to_micrometres(-length) } else { whole_micrometres(length) }
}

/// The greatest error, in millimetres, with which a process holds class m of the general tolerances of small lengths.
const MEDIUM: f64 = 0.1;

impl Making<'_> {
    /// The greatest error of a size by the process, in millimetres.
    fn error(&self) -> Option<f64> {
        self.limits.process.map(|numbers| numbers.error.value)
    }

    fn process(&self) -> Option<Process> {
        self.limits.process.map(|numbers| numbers.process)
    }

    /// Limits of a width or a diameter that the process holds; `chain` is what a tolerance chain leaves below and above.
    pub(super) fn held(&self, usual: Limits, chain: [f64; 2]) -> Limits {
        self.of_known_chain(usual.held(self.error(), chain))
    }

    /// Limits of a bore of this diameter in millimetres, with which no shaft of at most its nominal size is too thick.
    pub(super) fn held_bore(&self, diameter: f64) -> Limits {
        let usual = Limits::class(BORE, diameter);
        self.over_shaft(self.held(usual, [f64::INFINITY, self.chain.bore]), diameter)
    }

    /// The limits of a bore's size in millimetres, moved up as far as the size would be below that of its shaft, which is less by the
    /// play.
    pub(super) fn over_shaft(&self, limits: Limits, size: f64) -> Limits {
        let shaft = size - self.sizes.bore_play();
        let least = signed_micrometres_up(shaft - printed(size));
        let rise = least - limits.lower;
        if rise <= 1e-9 {
            return limits;
        }
        Limits { lower: least, upper: whole_micrometres(limits.upper + rise), class: None, ..limits }
    }

    /// What is said of the shaft in a bore of this diameter in millimetres.
    pub(super) fn shaft_row(&self, diameter: f64) -> Row {
        let shaft = diameter - self.sizes.bore_play();
        let class = SHAFT.limits(shaft).filter(|_| self.is_machined()).map(|_| SHAFT.name());
        Row::Words(match class {
            Some(class) => format!("for a shaft Ø{} {class}", mm(shaft)),
            None => format!("for a shaft Ø{}, not thicker", mm(shaft)),
        })
    }

    /// The limits, which come from no chain where none is known.
    fn of_known_chain(&self, limits: Limits) -> Limits {
        let is_marked = limits.origin == LimitOrigin::Chain && !self.chain.is_known;
        if is_marked { Limits { origin: LimitOrigin::Standard, ..limits } } else { limits }
    }

    /// Limits of a radius that the process holds: half of its error.
    pub(super) fn held_radius(&self, usual: Limits, chain: [f64; 2]) -> Limits {
        self.of_known_chain(usual.held(self.error().map(|error| error / 2.0), chain))
    }

    /// Limits of a place that only a chain has.
    pub(super) fn held_place(&self, chain: [f64; 2]) -> Limits {
        let origin = if self.chain.is_known { LimitOrigin::Chain } else { LimitOrigin::Standard };
        self.held(Limits { origin, ..Limits::new([-chain[0], chain[1]]) }, chain)
    }

    /// The frame of a place: its zone is as wide as the chain leaves it, or as the process' error.
    pub(super) fn position(&self, sign: &str, chain: f64, datums: &'static [&'static str]) -> Row {
        let known = if self.chain.is_known { LimitOrigin::Chain } else { LimitOrigin::Standard };
        let (width, origin) = match self.error().map(whole_micrometres) {
            Some(error) if error > chain => (error, LimitOrigin::ProcessBeyondChain),
            _ => (chain, known),
        };
        Row::Position { zone: format!("{sign}{}", mm(width)), datums, origin }
    }

    /// The frame of a crescent's place, which no chain has.
    pub(super) fn position_of_crescent(&self, usual: f64) -> Row {
        let width = self.error().map_or(usual, |error| usual.max(whole_micrometres(error)));
        Row::Position { zone: format!("Ø{}", mm(width)), datums: &["A"], origin: LimitOrigin::Standard }
    }

    /// The gap between wheel and plate along the axes, in millimetres.
    pub(super) fn axial_play(&self) -> f64 {
        axial_play(self.sizes.slot_play(), self.mounting)
    }

    /// Class of the general tolerances: ISO 2768-1.
    pub(super) fn general_class(&self) -> &'static str {
        if self.error().is_some_and(|error| error > MEDIUM) { "ISO 2768-c" } else { "ISO 2768-m" }
    }

    /// Whether parts are cut out of a sheet, whose thickness is as it is bought.
    fn is_of_sheet(&self) -> bool {
        matches!(self.process(), Some(Process::Laser | Process::Router))
    }

    /// The thickness as a row: that of the sheet, or with general tolerances.
    pub(super) fn thickness(&self, part: &Part) -> Row {
        let of = |before, behind| PrintedDimension::new(Measured::Thickness, before, part.thickness, behind);
        let size = |behind| of("t = ", behind);
        Row::Size(match part.layer {
            Layer::LockingDisc | Layer::LockingSegment if part.is_joined => {
                of("above the plate t = ", "").limited(self.height(part.thickness))
            }
            _ if self.is_of_sheet() => size(", that of the sheet"),
            _ => size("").limited(self.general(part.thickness)),
        })
    }

    /// General tolerances to either side, as far as the process holds them.
    pub(super) fn general(&self, nominal: f64) -> Limits {
        let by = general_tolerance(nominal);
        self.held(Limits::new([-by, by]), [f64::INFINITY; 2])
    }

    /// General tolerances of what stands on the plate. The plate that closes an internal wheel's ring leaves no room above that.
    pub(super) fn height(&self, nominal: f64) -> Limits {
        let general = self.general(nominal);
        if self.sizes.is_internal() {
            return Limits { lower: general.lower - general.upper, upper: 0.0, ..general };
        }
        general
    }

    /// How far pins in one piece with a plate of this thickness stand above it, in millimetres.
    pub(super) fn pin_height(&self, thickness: f64) -> f64 {
        if self.sizes.is_internal() { thickness } else { thickness + self.axial_play() }
    }

    /// What surfaces are to be like: how rough those of metal may be, in micrometres, and what is done to others.
    pub(super) fn surface(&self, which: &str, roughness: f64) -> String {
        match self.process() {
            None | Some(Process::Ground | Process::Mill) => format!("{which}: Ra {roughness}."),
            Some(Process::Laser) => format!("{which}: as cut, square to the face."),
            Some(Process::Router) => format!("{which}: as routed, without fibres and burrs."),
            Some(Process::Resin | Process::Fdm) => format!("{which}: as printed, without strings and supports."),
        }
    }

    /// What the surface of a pin is to be like.
    pub(super) fn pin_surface(&self, which: &str) -> String {
        if self.has_metal_pins { format!("{which}: Ra 0.8.") } else { self.surface(which, 0.8) }
    }

    /// Whether the parts are cut of metal.
    pub(super) fn is_machined(&self) -> bool {
        matches!(self.process(), None | Some(Process::Ground | Process::Mill))
    }

    /// Whether locking disc or segment and plate are one piece. Dowels are between the two plates of an internal wheel.
    pub(super) fn is_one_piece(&self) -> bool {
        if self.sizes.is_internal() { !self.mounting.is_stacked } else { !self.mounting.disc_is_apart() }
    }

    /// Whether the pins are one piece with the plate.
    pub(super) fn has_solid_pins(&self) -> bool {
        self.is_one_piece() && self.mounting.pins == PinMount::Solid
    }

    /// The pattern of holes that holds a part on its hub.
    pub(super) fn hub(&self, layer: Layer) -> Option<Pattern> {
        let is_of_wheel = matches!(layer, Layer::Wheel | Layer::RingPlate);
        if is_of_wheel { self.mounting.wheel_hub } else { self.mounting.driver_hub }
    }

    /// What the sheet of a part is called.
    pub(super) fn name(&self, part: &Part) -> &'static str {
        match part.layer {
            Layer::Wheel if self.sizes.is_internal() => "Ring",
            Layer::Wheel => "Wheel",
            Layer::LockingSegment if part.is_joined => "Locking segment, in one piece with the driver plate",
            Layer::LockingDisc if part.is_joined => "Locking disc, in one piece with the driver plate",
            Layer::LockingDisc => "Locking disc",
            Layer::Pins if part.is_bush() => "Bush of a pin",
            Layer::Pins => "Pin",
            Layer::BasePlate => "Base plate",
            Layer::LockingSegment => "Locking segment",
            Layer::RingPlate => "Ring plate",
            Layer::TestPiece => "Test piece",
            Layer::Plate | Layer::Centres | Layer::Pockets if !self.is_one_piece() => "Driver plate",
            _ => self.driver_name(),
        }
    }

    /// What the plate is called that has the locking disc or segment in one piece with it.
    fn driver_name(&self) -> &'static str {
        let has_disc = match self.sizes {
            DrawnSizes::External(sizes) => sizes.locking_disc.is_some(),
            DrawnSizes::Internal(_) => {
                return if self.has_solid_pins() {
                    "Driver plate, in one piece with locking segment and pin"
                } else {
                    "Driver plate, in one piece with the locking segment"
                };
            }
        };
        match (has_disc, self.has_solid_pins(), self.sizes.pins()) {
            (true, true, 1) => "Driver plate, in one piece with locking disc and pin",
            (true, true, _) => "Driver plate, in one piece with locking disc and pins",
            (true, false, _) => "Driver plate, in one piece with the locking disc",
            (false, true, 1) => "Driver plate, in one piece with the pin",
            (false, true, _) => "Driver plate, in one piece with the pins",
            (false, false, _) => "Driver plate",
        }
    }
}
