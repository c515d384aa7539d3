//! What the sheets of a design say in words.

use crate::parts::Layer;

/// What a sheet says besides sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetText<'a> {
    /// What is made, in the title block of each sheet.
    pub project: &'a str,
    /// Material of the wheel, of the plate that closes an internal one, and of the base plate.
    pub wheel_material: SheetMaterial<'a>,
    /// Material of locking disc, or segment, and plate.
    pub driver_material: SheetMaterial<'a>,
    /// Material of the pins.
    pub pin_material: SheetMaterial<'a>,
}

impl<'a> SheetText<'a> {
    /// The material of a part.
    pub(super) fn material(&self, layer: Layer) -> SheetMaterial<'a> {
        match layer {
            Layer::Pins => self.pin_material,
            Layer::LockingDisc | Layer::LockingSegment | Layer::Plate => self.driver_material,
            _ => self.wheel_material,
        }
    }
}

/// A material in a title block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetMaterial<'a> {
    /// Its name.
    pub name: &'a str,
    /// Hardness that is asked for; none of what is no metal.
    pub hardness: Option<&'a str>,
}
