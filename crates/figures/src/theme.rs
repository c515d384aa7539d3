//! Colours: custom properties for the page, and what stands for them where only a fixed colour can be written.

use plotters::style::RGBColor;

/// A colour of the figures.
///
/// plotters writes only `#RRGGBB`. So it is given a stand-in that no figure uses as a colour, and the stand-in is
/// replaced by the custom property afterwards.
#[derive(Clone, Copy, Debug)]
pub struct Shade {
    /// The value written into the SVG.
    pub css: &'static str,
    /// The colour that plotters is given instead.
    pub stand_in: RGBColor,
}

/// Lines and text: the colour of the page's text.
pub const INK: Shade = Shade { css: "currentColor", stand_in: RGBColor(1, 1, 1) };
/// Construction lines, extension lines, grids.
pub const GRID: Shade = Shade { css: "var(--fig-grid, #8a8f98)", stand_in: RGBColor(1, 1, 2) };
/// The follower and what belongs to it.
pub const FOLLOWER: Shade = Shade { css: "var(--fig-1, #0b62a4)", stand_in: RGBColor(1, 1, 3) };
/// The driver and what belongs to it.
pub const DRIVER: Shade = Shade { css: "var(--fig-2, #b3400e)", stand_in: RGBColor(1, 1, 4) };
/// Motion of one relative to the other.
pub const RELATIVE: Shade = Shade { css: "var(--fig-3, #2a7a3b)", stand_in: RGBColor(1, 1, 5) };
/// What comes of both motions together: the Coriolis acceleration.
pub const CORIOLIS: Shade = Shade { css: "var(--fig-4, #8f3b7a)", stand_in: RGBColor(1, 1, 8) };
/// Faces of bodies.
pub const FILL: Shade = Shade { css: "var(--fig-fill, #e9eff6)", stand_in: RGBColor(1, 1, 6) };
/// The ground the figure stands on; halos of labels.
pub const PAPER: Shade = Shade { css: "var(--fig-paper, #ffffff)", stand_in: RGBColor(1, 1, 7) };

impl Shade {
    /// The stand-in as plotters writes it.
    pub fn stand_in_hex(&self) -> String {
        let RGBColor(r, g, b) = self.stand_in;
        format!("#{r:02X}{g:02X}{b:02X}")
    }
}

/// Replaces every stand-in in plotters' output by its custom property.
pub fn resolve(svg: &str) -> String {
    let all = [INK, GRID, FOLLOWER, DRIVER, RELATIVE, CORIOLIS, FILL, PAPER];
    all.iter().fold(svg.to_owned(), |text, shade| text.replace(&shade.stand_in_hex(), shade.css))
}
