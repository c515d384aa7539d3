//! Driver and follower in one position, and where they lie on the page.

use crate::FigureError;
use crate::parts::{WIDTH, axis, construction, pin, pin_circle, sense};
use crate::star::Star;
use crate::svg::{Canvas, Label, Path, Pixels, Placing, Shape, View, heading};
use crate::theme::{Colour, DRIVER, FOLLOWER};
use geneva_kinematics::escapement::{Configuration, Mechanism};
use geneva_kinematics::indexing::Indexing;
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Radius of the driver's disc, in crank radii: it lies behind the follower and carries the pins.
const DISC: f64 = 1.1;
/// Radius of a pin over half the width of its slot: some play, so that both can be seen.
const PIN_IN_SLOT: f64 = 0.86;
/// Digits to which the sides of a triangle are written: enough to check the triangle from the file.
const SIDE_DECIMALS: usize = 10;
/// From a body to the arrow of its sense, in pixels.
const TO_ARROW: f64 = 14.0;

/// Free space around the mechanism, in pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct EscapementMargins {
    pub side: f64,
    pub above: f64,
    pub below: f64,
}

/// Driver and follower in one position, and where they lie on the page.
#[derive(Clone, Debug)]
pub(super) struct EscapementPose {
    /// The follower; lengths in crank radii.
    pub star: Star,
    /// Places of pins and slots.
    pub layout: Configuration<f64>,
    /// θ and φ of the first pin and its slot, in radians.
    pub theta: f64,
    pub phi: f64,
    /// The plane about the driver's axis, in crank radii.
    pub view: View,
    /// The driver's axis B and the follower's axis O on the page.
    pub axis: Pixels,
    pub pivot: Pixels,
    /// Height that the mechanism and its margins take, in pixels.
    pub height: f64,
}

impl EscapementPose {
    /// The mechanism at a driver angle within ±π/m, as large as it can be.
    pub(super) fn at_driver_angle(
        escapement: &Mechanism,
        theta: f64,
        margins: EscapementMargins,
    ) -> Result<Self, FigureError> {
        let layout = escapement.layout(theta)?;
        let phi = escapement.wheel().engaged(theta)?.angle;
        Ok(Self::new(escapement, layout, [theta, phi], margins))
    }

    /// The mechanism at a driver angle within ±π/m in the middle of the page, of this height with its margins.
    pub(super) fn of_height(
        escapement: &Mechanism,
        theta: f64,
        height: f64,
        margins: EscapementMargins,
    ) -> Result<Self, FigureError> {
        let large = Self::at_driver_angle(escapement, theta, margins)?;
        let above = margins.above + margins.below;
        let scale = large.view.scale * (height - above) / (large.height - above);
        let breadth = (WIDTH - 2.0 * margins.side) * scale / large.view.scale;
        let left = (WIDTH - breadth) / 2.0 + DISC * scale;
        let view = View { origin: Vector2::new(left, margins.above + (height - above) / 2.0), scale };
        let layout = escapement.layout(theta)?;
        Ok(Self { view, axis: view.origin, pivot: view.place(&layout.follower_axis), height, ..large })
    }

    /// The mechanism with its parts in these places.
    pub(super) fn new(
        escapement: &Mechanism,
        layout: Configuration<f64>,
        angles: [f64; 2],
        margins: EscapementMargins,
    ) -> Self {
        let [theta, phi] = angles;
        let star = Star::of_wheel(&escapement.wheel());
        let scale = (WIDTH - 2.0 * margins.side) / (DISC + star.centre + star.rim);
        let half = DISC.max(star.rim) * scale;
        let view = View { origin: Vector2::new(margins.side + DISC * scale, margins.above + half), scale };
        let pivot = view.place(&layout.follower_axis);
        let height = margins.above + margins.below + 2.0 * half;
        Self { star, layout, theta, phi, view, axis: view.origin, pivot, height }
    }

    /// Where the first pin lies on the page.
    pub(super) fn pin(&self) -> Pixels {
        self.on_driver(1.0, self.theta)
    }

    /// A place so many crank radii from the driver's axis, at an angle as θ is counted.
    pub(super) fn on_driver(&self, radius: f64, theta: f64) -> Pixels {
        self.axis + heading(theta) * (radius * self.view.scale)
    }

    /// A place so many crank radii from the follower's axis, at an angle as φ is counted.
    pub(super) fn on_follower(&self, radius: f64, phi: f64) -> Pixels {
        self.pivot + heading(PI - phi) * (radius * self.view.scale)
    }

    /// Radius of a pin in pixels.
    pub(super) fn pin_radius(&self) -> f64 {
        PIN_IN_SLOT * self.star.half_width * self.view.scale
    }

    /// How far a label may stand from the middle of a pin, in pixels.
    pub(super) fn near_pin(&self) -> [f64; 5] {
        [5.0, 8.0, 13.0, 20.0, 30.0].map(|beyond| self.pin_radius() + beyond)
    }

    /// Radius of the driver's disc in pixels.
    pub(super) fn disc(&self) -> f64 {
        DISC * self.view.scale
    }

    /// The follower about its axis.
    pub(super) fn draw_follower(&self, canvas: &mut Canvas, width: f64) {
        let view = View { origin: self.pivot, ..self.view };
        canvas.draw(self.star.body(PI - self.phi, &view, width).class("follower"));
    }

    /// The driver's disc and the pins' circle.
    pub(super) fn draw_driver(&self, canvas: &mut Canvas, width: f64) {
        let disc = Shape::circle(&self.axis, self.disc()).stroke(DRIVER, width).tint(DRIVER, 0.12);
        canvas.draw(disc.class("driver"));
        pin_circle(canvas, &self.axis, self.view.scale);
    }

    /// All pins.
    pub(super) fn draw_pins(&self, canvas: &mut Canvas) {
        self.layout.pins.iter().for_each(|at| pin(canvas, &self.view.place(at), self.pin_radius()));
    }

    /// The flank of the first pin's slot ahead of it in the follower's sense (1) or behind it (−1): its ends.
    pub(super) fn flank(&self, side: f64) -> [Pixels; 2] {
        let across = heading(PI - self.phi - FRAC_PI_2) * (side * self.star.half_width * self.view.scale);
        [self.star.bottom, self.star.rim].map(|radius| self.on_follower(radius, self.phi) + across)
    }

    /// The marks of both axes.
    pub(super) fn draw_axes(&self, canvas: &mut Canvas) {
        for (at, colour) in [(&self.axis, DRIVER), (&self.pivot, FOLLOWER)] {
            axis(canvas, at, colour);
            canvas.draw(Shape::circle(at, 1.5).fill(colour));
        }
    }

    /// The line of centres, somewhat longer than it is.
    pub(super) fn draw_line_of_centres(&self, canvas: &mut Canvas) {
        let beyond = Vector2::new(26.0, 0.0);
        construction(canvas, &(self.axis - beyond), &(self.pivot + beyond), "line-of-centres");
    }

    /// The sense of each body, as an arrow outside it with the symbol of its angle.
    pub(super) fn draw_senses(&self, canvas: &mut Canvas) {
        let [theta, phi] =
            [("θ", DRIVER), ("φ", FOLLOWER)].map(|(letter, colour)| Label::symbol(letter).in_colour(colour));
        sense(canvas, &self.axis, self.disc() + TO_ARROW, PI, 1.0, &theta);
        sense(canvas, &self.pivot, self.star.rim * self.view.scale + TO_ARROW, 0.0, -1.0, &phi);
    }

    /// What labels on the mechanism keep clear of: lines of it, pins and axes.
    pub(super) fn placing(&self) -> Placing {
        let mut placing = Placing::new(Vector2::new(6.0, 6.0), Vector2::new(WIDTH - 6.0, self.height - 6.0));
        placing.avoid(&self.axis, &self.pivot, 0.7);
        for pin in &self.layout.pins {
            let (at, room) = (self.view.place(pin), Vector2::new(1.0, 1.0) * (self.pin_radius() + 1.0));
            placing.take([at - room, at + room]);
        }
        for axis in [self.axis, self.pivot] {
            placing.take([axis - Vector2::new(6.0, 6.0), axis + Vector2::new(6.0, 6.0)]);
        }
        for slot in &self.layout.slots {
            let [mouth, bottom] = [slot.mouth, slot.bottom].map(|at| self.view.place(&at));
            placing.avoid(&mouth, &bottom, 0.8);
            let along = (mouth - bottom).normalize();
            let across = Vector2::new(-along.y, along.x) * (self.star.half_width * self.view.scale);
            for flank in [across, -across] {
                placing.avoid(&(mouth + flank), &(bottom + flank), 0.8);
            }
        }
        placing.avoid_arc(&self.axis, self.view.scale, 0.0, 2.0 * PI, 0.3);
        placing.avoid_arc(&self.axis, self.disc(), 0.0, 2.0 * PI, 0.6);
        placing
    }
}

/// A side of a triangle by the letter of its length, written to more digits than the rest so that the triangle can be checked from the file.
pub(super) fn side(
    canvas: &mut Canvas,
    placing: &mut Placing,
    from: &Pixels,
    to: &Pixels,
    colour: Colour,
    letter: &str,
) {
    let path = Path::start_rounded(from, SIDE_DECIMALS).line_to(to);
    let side = Shape::path(path).stroke(colour, 3.0).attribute("stroke-linecap", "round");
    canvas.draw(side.class(&format!("side-{letter}")).attribute("data-letter", letter));
    placing.avoid(from, to, 2.0);
}

/// The id of a figure of this escapement: the name and the slots.
pub(super) fn id(name: &str, escapement: &Mechanism) -> String {
    format!("escapement-{name}-{}", escapement.slots())
}

/// π over a whole number, as text.
pub(super) fn half_angle(count: u32) -> String {
    format!("π/{count}")
}
