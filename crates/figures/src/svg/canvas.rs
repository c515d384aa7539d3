//! The page: shapes first, labels on top, then the frame that makes it an image with words.

use super::ground::{FilledShape, ground_colour, overhang};
use super::label::{Label, LabelPosition, TEXT_SIZE, escape};
use super::shape::Shape;
use super::view::Pixels;
use crate::number::format_trimmed;

/// The kind of a drawing: its class, for the page's style sheet.
#[derive(Clone, Copy, Debug)]
pub(crate) enum DrawingKind {
    /// Bodies and joints, to scale.
    Mechanism,
    /// Vectors and angles, to scale.
    Diagram,
    /// Curves over axes.
    Plot,
    /// Bodies in their true size on paper: [`PIXELS_PER_MILLIMETRE`].
    TrueSize,
}

/// Pixels of the view box to a millimetre of a drawing in true size: its type is 3.7 mm high.
pub(crate) const PIXELS_PER_MILLIMETRE: f64 = 6.0;

/// Width of a drawing on the screen over that of its view box: its letters are then as large as the body's. A narrower
/// screen shows the same drawing smaller, as wide as the screen.
const ON_SCREEN: f64 = 0.75;

/// A drawing in the making.
#[derive(Clone, Debug)]
pub(crate) struct Canvas {
    width: f64,
    height: f64,
    shapes: Vec<String>,
    faces: Vec<FilledShape>,
    opacity: f64,
    labels: Vec<(Label, LabelPosition)>,
}

impl Canvas {
    /// An empty page, in pixels of the view box.
    pub(crate) fn new(width: f64, height: f64) -> Self {
        Self { width, height, shapes: Vec::new(), faces: Vec::new(), opacity: 1.0, labels: Vec::new() }
    }

    /// Draws a shape over the earlier ones.
    pub(crate) fn draw(&mut self, shape: Shape) {
        self.shapes.push(shape.markup());
        let shown = |face: FilledShape| FilledShape { share: self.opacity * face.share, ..face };
        self.faces.extend(shape.face().map(shown));
    }

    /// Draws finished markup, one element to a line, over the earlier shapes.
    pub(crate) fn draw_markup(&mut self, markup: String) {
        self.shapes.push(markup);
    }

    /// Draws a group with these attributes over the earlier shapes; labels within it stay on top of all shapes.
    pub(crate) fn group(&mut self, attributes: &str, draw: impl FnOnce(&mut Self)) {
        self.shapes.push(format!("<g {attributes}>"));
        draw(self);
        self.shapes.push("</g>".to_owned());
    }

    /// Draws a group that is so faint, between 0 and 1, and has these further attributes.
    pub(crate) fn faint(&mut self, opacity: f64, attributes: &str, draw: impl FnOnce(&mut Self)) {
        let around = self.opacity;
        self.opacity *= opacity;
        self.group(format!("{attributes} opacity=\"{}\"", format_trimmed(opacity, 2)).trim_start(), draw);
        self.opacity = around;
    }

    /// Writes a label over all shapes, so far from `point` in the direction of `towards`. Its halo has the colour of the
    /// faces below it.
    pub(crate) fn label(&mut self, point: &Pixels, towards: &Pixels, distance: f64, label: &Label) {
        self.labels.push((label.clone(), LabelPosition { point: *point, towards: *towards, distance }));
    }

    /// How much of a label between two corners is beyond the ground under most of it, between 0 and 1.
    pub(crate) fn overhang(&self, corners: &[Pixels; 2]) -> f64 {
        overhang(&self.faces, corners)
    }

    /// The drawing as one `svg` element, named and described for those who cannot see it.
    pub(crate) fn finish(self, kind: DrawingKind, id: &str, title: &str, description: &str) -> String {
        let class = match kind {
            DrawingKind::Mechanism | DrawingKind::TrueSize => "mechanism",
            DrawingKind::Diagram => "diagram",
            DrawingKind::Plot => "plot",
        };
        let size = if matches!(kind, DrawingKind::TrueSize) {
            let [width, height] = [self.width, self.height].map(|size| format_trimmed(size / PIXELS_PER_MILLIMETRE, 3));
            format!(" width=\"{width}mm\" height=\"{height}mm\"")
        } else {
            format!(" width=\"{}\"", format_trimmed(ON_SCREEN * self.width, 0))
        };
        let opening = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\"{size} class=\"{class}\" role=\"img\" \
             aria-labelledby=\"{id}-title {id}-desc\" font-family=\"sans-serif\" font-size=\"{}\">",
            format_trimmed(self.width, 2),
            format_trimmed(self.height, 2),
            format_trimmed(TEXT_SIZE, 2),
        );
        let title = format!("<title id=\"{id}-title\">{}</title>", escape(title));
        let description = format!("<desc id=\"{id}-desc\">{}</desc>", escape(description));
        let mut lines = vec![opening, title, description];
        lines.extend(self.shapes);
        let written = |(label, LabelPosition { point, towards, distance }): &(Label, LabelPosition)| {
            let ground = ground_colour(&self.faces, &label.extent(label.width(), point, towards, *distance));
            label.markup_beside(point, towards, *distance, &ground)
        };
        lines.extend(self.labels.iter().map(written));
        lines.push("</svg>".to_owned());
        lines.join("\n")
    }
}
