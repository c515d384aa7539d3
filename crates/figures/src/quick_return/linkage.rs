//! The linkage on the page: where its parts lie, and how they are drawn.

use super::instant::LeverState;
use crate::number::format_trimmed;
use crate::parts::{axis, construction, fixed_pivot, link, pin, pin_circle};
use crate::svg::{Canvas, Path, Pixels, Placing, Shape, View, heading};
use crate::theme::{DRIVER, FILL, FOLLOWER, INK, PAPER};
use geneva_kinematics::Turn;
use geneva_kinematics::quick_return::{Branch, QuickReturn};
use nalgebra::Vector2;
use std::f64::consts::{FRAC_PI_2, PI};

/// The other branch's pin is shown if it is so many pixels away.
const APART: f64 = 14.0;
/// Width of the drawing, in pixels: narrow enough for its letters to be read on a phone.
pub(super) const WIDTH: f64 = 460.0;
/// The largest that the mechanism may be, in pixels.
const ROOM: Pixels = Vector2::new(388.0, 380.0);
/// Free space above and below the mechanism, in pixels: for the senses and the names.
const MARGIN: f64 = 56.0;
/// How far the line of an end of the swing goes beyond the pin's place there, over that distance.
const SWING_END: f64 = 1.1;
/// How far the lever reaches beyond the pin's farthest point, over that distance.
const REACH: f64 = 1.05;
/// Half the widths of the lever, of its slot and of the crank, in pixels.
pub(super) const LEVER: f64 = 13.0;
const SLOT: f64 = 7.0;
const CRANK: f64 = 8.0;

/// Where the parts of a linkage lie on the page.
#[derive(Clone, Debug)]
pub(super) struct LinkagePose {
    /// The mechanism's plane about O4.
    pub view: View,
    /// O4, O2 and the pin.
    pub pivot: Pixels,
    pub axis: Pixels,
    pub pin: Pixels,
    /// Crank radius, in pixels.
    pub crank: f64,
    /// Length of the lever from O4, in pixels.
    pub lever: f64,
    /// Length of the lines that mark the ends of the swing, in pixels.
    pub swing: f64,
    /// Nearest and farthest place of the pin from O4, in pixels.
    pub pin_range: (f64, f64),
    /// +1 if the pin is above the line of centres or on it, −1 below.
    pub side: f64,
    /// Height of the mechanism with its margins.
    pub height: f64,
}

impl LinkagePose {
    /// The mechanism with its circle, its lever and the ends of the swing, as large as there is room, so far below the
    /// upper edge of the page.
    pub(super) fn new(linkage: &QuickReturn, instant: &LeverState, top: f64) -> Self {
        Self::fitted(linkage, instant, top, false)
    }

    /// The mechanism with room for the lever at all angles, in the middle of the head of a page of this width.
    pub(super) fn of_the_turn(linkage: &QuickReturn, instant: &LeverState, width: f64) -> Self {
        let own = Self::fitted(linkage, instant, 0.0, true);
        let by = Pixels::new((width - WIDTH) / 2.0, 0.0);
        let view = View { origin: own.view.origin + by, ..own.view };
        Self { view, pivot: own.pivot + by, axis: own.axis + by, pin: own.pin + by, ..own }
    }

    fn fitted(linkage: &QuickReturn, instant: &LeverState, top: f64, whole_turn: bool) -> Self {
        let (l, r) = (linkage.ground(), linkage.crank());
        let reach = REACH * (l + r);
        let at = |angle: f64, distance: f64| {
            let towards = heading(angle);
            Vector2::new(towards.x, -towards.y) * distance
        };
        // There the crank is at right angles to the lever.
        let swing = SWING_END * ((l - r) * (l + r)).max(0.0).sqrt();
        let mut ends = vec![Vector2::zeros(), Vector2::new(l + r, r), Vector2::new(l - r, -r)];
        let limit = linkage.strokes().swing_limit;
        match (whole_turn, limit) {
            (false, _) => ends.push(at(instant.lever_angle, reach)),
            (true, Some(limit)) => ends.extend([0.0, limit, -limit].map(|angle| at(angle, reach))),
            (true, None) => ends.extend([Vector2::new(-reach, -reach), Vector2::new(reach, reach)]),
        }
        if let Some(limit) = limit {
            ends.extend([at(limit, swing), at(-limit, swing)]);
        }
        let fitted = View::fitting(ends.iter().copied(), ROOM, Pixels::zeros());
        let y = |end: &Vector2<f64>| end.y * fitted.scale;
        let size = ends.iter().map(y).fold(0.0, f64::max) - ends.iter().map(y).fold(0.0, f64::min);
        let height = size + 2.0 * MARGIN;
        let view = View { origin: fitted.origin + Vector2::new(WIDTH / 2.0, top + height / 2.0), ..fitted };
        let pin = view.place(&(instant.along * instant.pin_distance));
        Self {
            view,
            pivot: view.origin,
            axis: view.place(&Vector2::new(l, 0.0)),
            pin,
            crank: r * view.scale,
            lever: reach * view.scale,
            swing: swing * view.scale,
            pin_range: ((l - r).abs() * view.scale, (l + r) * view.scale),
            side: if instant.along.y < -1e-9 { -1.0 } else { 1.0 },
            height,
        }
    }

    /// The tip of the lever at an angle.
    pub(super) fn tip(&self, angle: f64) -> Pixels {
        self.pivot + heading(angle) * self.lever
    }

    /// The end of the line that marks an end of the swing.
    pub(super) fn swing_end(&self, angle: f64) -> Pixels {
        self.pivot + heading(angle) * self.swing
    }

    /// The slot: its ends are the pin's nearest and farthest place, as far as the pivot leaves room.
    pub(super) fn slot(&self, angle: f64) -> Path {
        let towards = heading(angle);
        let (near, far) = self.pin_range;
        let near = near.max((LEVER + SLOT + 2.0).min(far));
        link(&(self.pivot + towards * near), &(self.pivot + towards * far), SLOT)
    }
}

/// An angle in radians, brought into (−π, π].
pub(super) fn wrapped(angle: f64) -> f64 {
    let turn = Turn::from_radians(angle).radians();
    if turn <= -PI { PI } else { turn }
}

/// A length that was given, as text.
pub(super) fn length(value: f64, unit: &str) -> String {
    format!("{} {unit}", format_trimmed(value, 6))
}

/// Circle, ends of the swing, other branch, lever, crank, pivots.
pub(super) fn bodies(
    canvas: &mut Canvas,
    placing: &mut Placing,
    at: &LinkagePose,
    linkage: &QuickReturn,
    instant: &LeverState,
) {
    let beyond = at.axis + Vector2::new(at.crank + 22.0, 0.0);
    construction(canvas, &at.pivot, &beyond, "line-of-centres");
    pin_circle(canvas, &at.axis, at.crank);
    placing.avoid(&at.pivot, &beyond, 0.7);
    placing.avoid_arc(&at.axis, at.crank, 0.0, 2.0 * PI, 0.25);
    if let Some(limit) = linkage.strokes().swing_limit {
        for angle in [limit, -limit] {
            let end = at.swing_end(angle);
            let line = Shape::line(&at.pivot, &end).stroke(FOLLOWER, 1.2).attribute("stroke-opacity", "0.7");
            canvas.draw(line.dashed("10 4").class("swing-end"));
            placing.avoid(&at.pivot, &end, 0.5);
        }
    }
    if let Some(ghost) = other_branch(at, linkage, instant) {
        canvas.faint(0.5, "class=\"other-branch\"", |canvas| {
            canvas.draw(Shape::line(&at.axis, &ghost).stroke(DRIVER, 2.0).dashed("5 4"));
            canvas.draw(Shape::circle(&ghost, 6.0).stroke(DRIVER, 2.0).fill(PAPER));
        });
        placing.avoid(&at.axis, &ghost, 0.8);
    }
    let tip = at.tip(instant.lever_angle);
    let lever = Shape::path(link(&at.pivot, &tip, LEVER)).fill(PAPER);
    canvas.draw(lever.class("lever-paper"));
    let lever = Shape::path(link(&at.pivot, &tip, LEVER)).stroke(FOLLOWER, 2.0).fill(FILL);
    canvas.draw(lever.class("lever"));
    canvas.draw(Shape::path(at.slot(instant.lever_angle)).stroke(FOLLOWER, 1.3).fill(PAPER).class("slot"));
    for offset in [-0.7, 0.0, 0.7] {
        let aside = heading(instant.lever_angle + FRAC_PI_2) * (offset * LEVER);
        placing.avoid(&(at.pivot + aside), &(tip + aside), 2.0);
    }
    for pivot in [&at.pivot, &at.axis] {
        fixed_pivot(canvas, pivot, at.side);
        let (top, foot) = if at.side > 0.0 { (-6.0, 33.0) } else { (-33.0, 6.0) };
        placing.take([pivot + Vector2::new(-24.0, top), pivot + Vector2::new(24.0, foot)]);
    }
    let crank = Shape::path(link(&at.axis, &at.pin, CRANK)).tint(DRIVER, 0.22);
    canvas.draw(crank.stroke(DRIVER, 2.0).class("crank").attribute("data-letter", "R"));
    canvas.draw(Shape::line(&at.pivot, &at.pin).stroke(FOLLOWER, 1.0).attribute("data-letter", "r"));
    canvas.draw(Shape::line(&at.pivot, &at.axis).stroke(INK, 1.0).attribute("data-letter", "l"));
    placing.avoid(&at.axis, &at.pin, 2.0);
    axis(canvas, &at.axis, INK);
    pin(canvas, &at.pin, 6.0);
    placing.take([at.pin - Vector2::new(7.0, 7.0), at.pin + Vector2::new(7.0, 7.0)]);
}

/// Where the pin would be on the other branch at this lever angle, if that is another place.
pub(super) fn other_branch(at: &LinkagePose, linkage: &QuickReturn, instant: &LeverState) -> Option<Pixels> {
    let far = instant.angle_at_pin <= FRAC_PI_2;
    let other = if far { Branch::Near } else { Branch::Far };
    // The lever's pivot inside the circle: one place only.
    if linkage.ratio() <= 1.0 {
        return None;
    }
    let position = linkage.position_at_lever_degrees(instant.lever_angle.to_degrees(), other).ok()?;
    let pin = at.view.place(&(instant.along * position.pin_distance));
    ((pin - at.pin).norm() > APART).then_some(pin)
}
