//! Colours: custom properties for the page, each with a fallback.

/// A colour of the figures: the value that is written into the SVG.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Colour(pub &'static str);

/// Lines and text: the colour of the page's text.
pub(crate) const INK: Colour = Colour("currentColor");
/// Construction lines, extension lines, grids.
pub(crate) const GRID: Colour = Colour("var(--fig-grid, #8a8f98)");
/// The follower and what belongs to it.
pub(crate) const FOLLOWER: Colour = Colour("var(--fig-1, #0b62a4)");
/// The driver and what belongs to it.
pub(crate) const DRIVER: Colour = Colour("var(--fig-2, #b3400e)");
/// Motion of one relative to the other.
pub(crate) const RELATIVE: Colour = Colour("var(--fig-3, #2a7a3b)");
/// What comes of both motions together: the Coriolis acceleration.
pub(crate) const CORIOLIS: Colour = Colour("var(--fig-4, #8f3b7a)");
/// Faces of bodies.
pub(crate) const FILL: Colour = Colour("var(--fig-fill, #e9eff6)");
/// The colour of faces of bodies where it covers all, and how much of the ground it covers as [`FILL`].
pub(crate) const FACE: Colour = Colour("var(--fig-face, #e9eff6)");
pub(crate) const FACE_SHARE: &str = "var(--fig-share, 100%)";
/// The ground the figure stands on; halos of labels.
pub(crate) const PAPER: Colour = Colour("var(--fig-paper, #ffffff)");
