//! What the sheets of a design say in words.

/// What a sheet says besides sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetText<'a> {
    /// What is made, in the title block of each sheet.
    pub project: &'a str,
    /// Material of wheel, disc, plate and base plate.
    pub wheel_material: &'a str,
    /// Material of the pins.
    pub pin_material: &'a str,
    /// Hardness that is asked for, if any.
    pub hardness: Option<&'a str>,
}
