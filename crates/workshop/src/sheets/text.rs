//! What the sheets of a design say in words.

/// What a sheet says besides sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetText<'a> {
    /// What is made, in the title block of each sheet.
    pub project: &'a str,
    /// Material of wheel, disc, plate and base plate.
    pub wheel_material: SheetMaterial<'a>,
    /// Material of the pins.
    pub pin_material: SheetMaterial<'a>,
}

/// A material in a title block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetMaterial<'a> {
    /// Its name.
    pub name: &'a str,
    /// Hardness that is asked for; none of what is no metal.
    pub hardness: Option<&'a str>,
}
