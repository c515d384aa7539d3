//! Drawings that move: key frames in the drawing's own style, without a script.
//!
//! A drawing moves only on a screen and only for readers who don't ask for less motion. It rests while the pointer is on it. On
//! paper, and wherever the style is not heeded, the attributes of its parts show one instant. All names begin with the
//! figure's id, so that several such drawings can be on one page.

use crate::number::format_trimmed;
use crate::svg::{Canvas, Path, Pixels, Shape};
use crate::theme::{FOLLOWER, PAPER};

/// The style of a drawing: its key frames, and the rules that apply them where motion is welcome.
pub(crate) fn style(name: &str, key_frames: &str, rules: &str) -> String {
    format!(
        "<style>{key_frames}@media screen and (prefers-reduced-motion:no-preference){{{rules}.{name}:hover \
         *{{animation-play-state:paused}}}}</style>"
    )
}

/// Draws what moves, before a field as large as `size` (pixels) on which the pointer rests to stop it.
pub(crate) fn on_field(canvas: &mut Canvas, name: &str, size: &Pixels, draw: impl FnOnce(&mut Canvas)) {
    canvas.group(&format!("class=\"{name}\" pointer-events=\"all\""), |canvas| {
        let corner = |x: f64, y: f64| Pixels::new(x, y);
        let field = Path::start(&corner(0.0, 0.0)).line_to(&corner(size.x, 0.0)).line_to(&corner(size.x, size.y));
        canvas.draw(Shape::path(field.line_to(&corner(0.0, size.y)).close()));
        draw(canvas);
    });
}

/// The attributes of a body that turns about a point of the page: its class, and the angle (radians, clockwise as seen) at which it
/// rests.
pub(crate) fn turned(class: &str, centre: &Pixels, angle: f64) -> String {
    let [angle, x, y] = [angle.to_degrees(), centre.x, centre.y].map(|value| format_trimmed(value, 2));
    format!("class=\"{class}\" transform=\"rotate({angle} {x} {y})\"")
}

/// The rule that moves a body of a class by the key frames of the same name, about a point of the page.
pub(crate) fn turning_rule(class: &str, centre: &Pixels, timing: &str) -> String {
    let [x, y] = [centre.x, centre.y].map(|value| format_trimmed(value, 2));
    format!(".{class}{{transform-origin:{x}px {y}px;animation:{class} {timing} infinite}}")
}

/// One key frame that turns a body: a share of the cycle, and the angle (radians, clockwise as seen).
pub(crate) fn turning_key(share: f64, angle: f64) -> String {
    let [share, angle] = [100.0 * share, angle.to_degrees()].map(|value| format_trimmed(value, 2));
    format!("{share}%{{transform:rotate({angle}deg)}}")
}

/// The key frames of what is shown only between two shares of the cycle, of which the first is below the second.
pub(crate) fn shown_while(class: &str, [from, to]: [f64; 2]) -> String {
    let [start, end] = [from, to].map(|share| format_trimmed(100.0 * share, 2));
    let before = if from > 0.0 { "0%{opacity:0}" } else { "" };
    format!("@keyframes {class}{{{before}{start}%{{opacity:1}}{end}%,to{{opacity:0}}}}")
}

/// The rule that shows and hides what [`shown_while`] is about, in a cycle of so many seconds.
pub(crate) fn step_rule(class: &str, cycle: f64) -> String {
    format!(".{class}{{animation:{class} {}s step-end infinite}}", format_trimmed(cycle, 2))
}

/// Draws a body of the follower that is filled while it is pushed: its outline, and over it what fills it, of a class of its own and, where
/// the drawing rests, shown or not.
pub(crate) fn draw_pushed(canvas: &mut Canvas, outline: &Path, class: &str, pushed: &str, is_pushed: bool) {
    let shape = Shape::path(outline.clone()).stroke(FOLLOWER, 2.5).attribute("stroke-linejoin", "round");
    canvas.draw(shape.clone().fill(PAPER).class(class));
    canvas.draw(shape.fill(FOLLOWER).class(pushed).attribute("opacity", if is_pushed { "1" } else { "0" }));
}
