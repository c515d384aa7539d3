//! Colours: custom properties for the page, each with a fallback.

/// A colour of the figures: the value that is written into the SVG.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shade(pub &'static str);

/// Lines and text: the colour of the page's text.
pub const INK: Shade = Shade("currentColor");
/// Construction lines, extension lines, grids.
pub const GRID: Shade = Shade("var(--fig-grid, #8a8f98)");
/// The follower and what belongs to it.
pub const FOLLOWER: Shade = Shade("var(--fig-1, #0b62a4)");
/// The driver and what belongs to it.
pub const DRIVER: Shade = Shade("var(--fig-2, #b3400e)");
/// Motion of one relative to the other.
pub const RELATIVE: Shade = Shade("var(--fig-3, #2a7a3b)");
/// What comes of both motions together: the Coriolis acceleration.
pub const CORIOLIS: Shade = Shade("var(--fig-4, #8f3b7a)");
/// Faces of bodies.
pub const FILL: Shade = Shade("var(--fig-fill, #e9eff6)");
/// The ground the figure stands on; halos of labels.
pub const PAPER: Shade = Shade("var(--fig-paper, #ffffff)");
