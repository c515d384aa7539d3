//! What lies on which layer of a drawing, and where.

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Loop, Sizes};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// Arrangement of the parts on the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartLayout {
    /// In place, as they run: the wheel's axis at the origin, the driver's at (c, 0), in the middle of a dwell.
    Assembled,
    /// Side by side, to be cut out: wheel, locking disc, plate with the holes of its pins.
    Apart,
}

/// A layer of the drawing; the pieces of one layer are cut from one sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// The wheel.
    Wheel,
    /// The driver's locking disc, as thick as the wheel and in its plane.
    LockingDisc,
    /// The driver's plate, behind the wheel.
    Plate,
    /// The pins, or the holes for them in the plate.
    Pins,
}

impl Layer {
    /// All layers.
    pub const ALL: [Self; 4] = [Self::Wheel, Self::LockingDisc, Self::Plate, Self::Pins];

    /// The layer's name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wheel => "WHEEL",
            Self::LockingDisc => "LOCKING_DISC",
            Self::Plate => "DRIVER_PLATE",
            Self::Pins => "PINS",
        }
    }
}

/// Space between parts that lie side by side, over the pin's diameter.
const SPACE: f64 = 1.0;

/// All loops of the drawing in place, each with its layer.
pub(crate) fn loops(sizes: &Sizes, layout: PartLayout) -> Vec<(Layer, Loop)> {
    let outline = sizes.outline();
    let (wheel_turn, driver_turn) = match layout {
        PartLayout::Assembled => (sizes.wheel.half_pitch_angle(), PI - PI / f64::from(sizes.wheel.pins())),
        PartLayout::Apart => (0.0, 0.0),
    };
    let space = SPACE * sizes.pin_diameter;
    let disc_radius = sizes.locking_disc.map_or(0.0, |disc| disc.radius);
    let (disc_at, plate_at) = match layout {
        PartLayout::Assembled => (sizes.centre_distance, sizes.centre_distance),
        PartLayout::Apart => {
            let disc = sizes.tip_radius + space + disc_radius;
            (disc, disc + disc_radius + space + sizes.plate_radius)
        }
    };
    let mut loops = Vec::new();
    let mut add = |layer, of: &Loop, turn, x| loops.push((layer, of.transform(turn, Vector2::new(x, 0.0))));
    outline.wheel.loops().for_each(|of| add(Layer::Wheel, of, wheel_turn, 0.0));
    if let Some(disc) = &outline.disc {
        disc.loops().for_each(|of| add(Layer::LockingDisc, of, driver_turn, disc_at));
    }
    outline.plate.loops().for_each(|of| add(Layer::Plate, of, driver_turn, plate_at));
    outline.pins.iter().for_each(|of| add(Layer::Pins, of, driver_turn, plate_at));
    loops
}
