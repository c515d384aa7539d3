//! The mechanism above its two vector diagrams.

use super::instant::{LeverState, a, cleared, coriolis, format_with_unit, v};
use super::linkage::{LinkagePose, bodies};
use crate::number::{degrees, format_trimmed};
use crate::parts::{WIDTH, arrow, scale_bar};
use crate::svg::{
    Canvas, DASHED, DrawingKind, Label, Pixels, Placing, Shape, View, positions_around, positions_beside_line,
};
use crate::theme::{CORIOLIS, Colour, DRIVER, FOLLOWER, INK, RELATIVE};
use crate::{Figure, Series, Words};
use geneva_kinematics::quick_return::{Drive, Position, QuickReturn};
use nalgebra::Vector2;

/// Size of a diagram's part of the page, in pixels, and the room of its vectors about its middle.
const PART: Pixels = Vector2::new(WIDTH / 2.0, 300.0);
const ROOM: Pixels = Vector2::new(256.0, 206.0);
const MARGIN: f64 = 8.0;
/// Room for a scale bar at the top of a diagram.
const BAR: f64 = 36.0;
/// Scales that a diagram may have between one and its double.
const PER_OCTAVE: f64 = 4.0;
/// A vector of fewer pixels is not drawn.
const SHORTEST: f64 = 1.0;
/// How far labels may stand from their vectors, in pixels.
const NEAR: [f64; 5] = [8.0, 14.0, 22.0, 34.0, 50.0];

/// One vector: its class, its symbol, its colour.
struct Arrow {
    name: &'static str,
    symbol: Label,
    colour: Colour,
    tail: Vector2<f64>,
    vector: Vector2<f64>,
}

/// Mechanism, velocity diagram and acceleration diagram at a position, with the Coriolis acceleration counted
/// `factor` times φ′ × v_rel.
///
/// The lever's and the sliding acceleration are those of the motion. So the polygon closes with a factor of 2 alone; with
/// another its gap is drawn. The terms follow one another as in the steps of the [acceleration
/// diagram](super::acceleration_diagram) at the printed position, at every angle alike. Series, a row for each vector in
/// the order that the first column's name gives: components along O4 → O2 and across it, and magnitude.
pub fn polygons(linkage: &QuickReturn, position: &Position, drive: &Drive<f64>, factor: f64, unit: &str) -> Figure {
    let here = diagrams(&LeverState::new(linkage, position, drive), factor);
    let instant = LeverState::new(linkage, position, drive);
    let layout = LinkagePose::of_the_turn(linkage, &instant, WIDTH);
    let height = layout.height;
    let mut canvas = Canvas::new(WIDTH, height + PART.y);
    let mut placing = Placing::new(Vector2::zeros(), Vector2::new(WIDTH, height));
    bodies(&mut canvas, &mut placing, &layout, linkage, &instant);
    let pin = Label::words("P").sub("2").and(", P").sub("4");
    placing.put(&mut canvas, &pin, positions_around(&layout.pin, 1.0, &[12.0, 18.0, 26.0, 36.0]));

    for (k, (arrows, unit)) in here.iter().zip([format!("{unit}/s"), format!("{unit}/s²")]).enumerate() {
        let corner = Vector2::new(PART.x * k as f64, height);
        let view = fitting(arrows, corner + Vector2::new(PART.x / 2.0, (BAR + PART.y) / 2.0));
        let margin = Vector2::new(MARGIN, MARGIN);
        scale_bar(&mut canvas, &(corner + Vector2::new(2.0 * MARGIN, BAR / 2.0)), view.scale, false, &unit);
        draw(&mut canvas, [corner + Vector2::new(MARGIN, BAR), corner + PART - margin], &view, arrows);
    }

    let [velocities, accelerations] = &here;
    let gap = accelerations.last().map_or(0.0, |arrow| arrow.vector.norm());
    let closes = if gap == 0.0 {
        "closes".to_owned()
    } else {
        format!("misses by {}", format_with_unit(gap, &format!("{unit}/s²")))
    };
    let theta = degrees(instant.theta());
    let times = format_trimmed(factor, 3);
    let words = Words::new(
        "live-polygon",
        format!("Quick-return mechanism at a crank angle of {theta}, and its vector diagrams"),
        format!(
            "Above, the mechanism to scale. Below it at the left, the velocity of the pin is the sum of the lever's velocity and \
             the sliding velocity. At the right, the acceleration of the pin, and end to end the Coriolis acceleration, counted \
             {times} times the lever's angular velocity times the sliding velocity, the lever's normal and tangential \
             accelerations, and the sliding acceleration. The polygon {closes}."
        ),
        format!(
            "The mechanism at θ = {theta}, with its velocities and accelerations. The Coriolis acceleration is counted as \
             {times} times φ̇ vᵣₑₗ. The polygon {closes}."
        ),
    );
    let columns = [
        ("1 v_2; 2 v_4; 3 v_rel; 4 a_2; 5 Coriolis; 6 an_4; 7 at_4; 8 at_rel; 9 gap", "1"),
        ("x", unit),
        ("y", unit),
        ("magnitude", unit),
    ];
    let rows =
        velocities.iter().chain(accelerations).zip(1..).map(|(arrow, k)| {
            [f64::from(k), arrow.vector.x, arrow.vector.y, libm::hypot(arrow.vector.x, arrow.vector.y)]
        });
    words.figure(canvas, DrawingKind::Diagram, Series::new(columns, rows))
}

/// The vectors as large as there is room about a place of the page, in one of a few scales, so that it seldom changes from
/// instant to instant.
fn fitting(arrows: &[Arrow], middle: Pixels) -> View {
    let ends: Vec<_> = arrows.iter().flat_map(|arrow| [arrow.tail, arrow.tail + arrow.vector]).collect();
    let fitted = View::fitting(ends.iter().copied(), ROOM, Pixels::zeros());
    let scale = libm::exp2(libm::floor(PER_OCTAVE * libm::log2(fitted.scale)) / PER_OCTAVE);
    View { origin: middle + fitted.origin * (scale / fitted.scale), scale }
}

/// The vectors of both diagrams from the pole; the last one is the gap of the accelerations.
fn diagrams(instant: &LeverState, factor: f64) -> [Vec<Arrow>; 2] {
    let arrow = |name, symbol, colour, tail, vector| Arrow { name, symbol, colour, tail, vector };
    let (zero, motion) = (Vector2::zeros(), &instant.motion);
    let of = &motion.velocities;
    let velocities = vec![
        arrow("v-pin", v("2"), DRIVER, zero, of.pin_velocity),
        arrow("v-lever", v("4"), FOLLOWER, zero, of.slot_point_velocity),
        arrow("v-sliding", v("rel"), RELATIVE, of.slot_point_velocity, of.sliding_velocity),
    ];
    let terms = &motion.accelerations;
    let pin = motion.pin_normal + motion.pin_tangential;
    let counted = terms.coriolis * (factor / 2.0);
    let mut tail = zero;
    let part = if motion.pin_tangential == zero { "n" } else { "" };
    let mut accelerations = vec![arrow("a-pin", a(part, "2"), DRIVER, zero, pin)];
    for (name, symbol, colour, vector) in [
        ("a-coriolis", coriolis(), CORIOLIS, counted),
        ("a-lever-normal", a("n", "4"), FOLLOWER, terms.follower_normal),
        ("a-lever-tangential", a("t", "4"), FOLLOWER, terms.follower_tangential),
        ("a-sliding", a("t", "rel"), RELATIVE, terms.sliding_tangential),
    ] {
        accelerations.push(arrow(name, symbol, colour, tail, vector));
        tail += vector;
    }
    let greatest = accelerations.iter().map(|arrow| arrow.vector.norm()).fold(0.0, f64::max);
    let gap = if cleared((pin - tail).norm(), greatest) == 0.0 { zero } else { pin - tail };
    accelerations.push(arrow("gap", Label::words("gap"), INK, tail, gap));
    [velocities, accelerations]
}

/// One diagram between two corners of the page.
fn draw(canvas: &mut Canvas, corners: [Pixels; 2], at: &View, arrows: &[Arrow]) {
    let mut placing = Placing::new(corners[0], corners[1]);
    let pole = at.place(&Vector2::zeros());
    let long: Vec<&Arrow> = arrows.iter().filter(|arrow| arrow.vector.norm() * at.scale >= SHORTEST).collect();
    let ends = |arrow: &Arrow| [at.place(&arrow.tail), at.place(&(arrow.tail + arrow.vector))];
    for drawn in &long {
        let [from, to] = ends(drawn);
        if drawn.name == "gap" {
            canvas.draw(Shape::line(&from, &to).stroke(INK, 2.0).dashed(DASHED).class("gap"));
        } else {
            arrow(canvas, &from, &to, drawn.colour, if drawn.tail == Vector2::zeros() { 3.6 } else { 2.8 }, drawn.name);
        }
        placing.avoid(&from, &to, 1.5);
    }
    canvas.draw(Shape::circle(&pole, 4.0).fill(INK).class("pole"));
    for drawn in &long {
        let [from, to] = ends(drawn);
        let label = drawn.symbol.clone().in_colour(drawn.colour);
        placing.put(
            canvas,
            &label,
            positions_beside_line(&from, &to, &NEAR).into_iter().chain(positions_around(&to, 0.0, &NEAR)),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound};
    use crate::quick_return::acceleration_diagram;

    fn linkage() -> QuickReturn {
        QuickReturn::new(0.45, 0.2).expect("sound")
    }

    /// Where the vectors of the accelerations begin, in pixels from the pole over the length of the pin's.
    fn tails(figure: &Figure, pin: &str) -> Vec<Vector2<f64>> {
        let drawing = ParsedDrawing::parse(figure);
        let [pole, tip] = drawing.arrow(pin).expect("drawn");
        let tail = |name| (drawing.arrow(name).expect("drawn")[0] - pole) / (tip - pole).norm();
        ["a-coriolis", "a-lever-normal", "a-lever-tangential", "a-sliding"].map(tail).to_vec()
    }

    #[test]
    fn terms_follow_one_another_as_in_the_steps() {
        let position =
            linkage().position_at_lever_degrees(20.0, geneva_kinematics::quick_return::Branch::Far).expect("there");
        let drive = Drive::steady(5.235_987_755_982_988);
        let live = tails(&polygons(&linkage(), &position, &drive, 2.0, "m"), "a-pin");
        let steps = acceleration_diagram(&linkage(), &position, &drive, "m");
        // The last step is drawn last: its arrows are the last two paths of each class.
        let drawing = ParsedDrawing::parse(&steps);
        let last = |name: &str, path: usize| {
            let count = drawing.count(name);
            drawing.path(name, count - 2 + path)[0]
        };
        let (pole, length) = (last("a-pin-normal", 0), (last("a-pin-normal", 1) - last("a-pin-normal", 0)).norm());
        for (name, tail) in ["a-coriolis", "a-lever-normal", "a-lever-tangential", "a-sliding"].into_iter().zip(live) {
            let expected = (last(name, 0) - pole) / length;
            assert!((tail - expected).norm() < 0.01, "{name} begins at {tail:?}, in the steps at {expected:?}");
        }
    }

    #[test]
    fn the_diagrams_fill_their_parts_and_every_label_is_clear_of_its_line() {
        for crank in (0..360).step_by(15) {
            let position = linkage().position_at_crank_degrees(f64::from(crank)).expect("there");
            let figure = polygons(&linkage(), &position, &Drive::steady(5.0), 2.0, "m");
            assert_sound(&figure);
            let drawing = ParsedDrawing::parse(&figure);
            let view = [
                "v-pin",
                "v-lever",
                "v-sliding",
                "a-pin",
                "a-lever-normal",
                "a-lever-tangential",
                "a-sliding",
                "a-coriolis",
            ];
            let ends = |names: &[&str]| -> Vec<Vector2<f64>> {
                names.iter().filter_map(|name| drawing.arrow(name)).flatten().collect()
            };
            for names in [&view[..3], &view[3..]] {
                let ends = ends(names);
                let least = ends.iter().fold(ends[0], |a, b| a.inf(b));
                let greatest = ends.iter().fold(ends[0], |a, b| a.sup(b));
                let size = (greatest - least).component_div(&ROOM);
                assert!(size.max() > 0.8 && size.max() < 1.01, "{crank}°: {size:?}");
            }
        }
    }

    #[test]
    fn the_label_of_an_acceleration_without_a_part_has_its_index_on_the_line() {
        assert!(!a("", "2").markup_beside(&Vector2::zeros(), &Vector2::zeros(), 0.0, "none").contains("></tspan>"));
    }
}
