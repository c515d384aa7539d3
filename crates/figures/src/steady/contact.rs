//! A pin of finite radius in its slot: where it touches, what it rubs with, and how fast its surface slides.

use crate::number::{degrees, format_fixed, with_minus_sign};
use crate::parts::{WIDTH, arc_arrow, arrow, draw_number, part};
use crate::svg::{Canvas, DASHED, DrawingKind, Label, Path, Pixels, Shape};
use crate::theme::{CORIOLIS, DRIVER, FILL, FOLLOWER, INK, PAPER, RELATIVE};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::joints::{Escapement, Joints, Reach};
use geneva_dynamics::{Parameters, Sign};
use nalgebra::Vector2;

/// Radius of the pin and thickness of the slot's walls, in pixels.
const PIN: f64 = 52.0;
const WALL: f64 = 36.0;
/// Lengths of the arrows of the forces, and of a velocity of one crank radius times the driver's speed, in pixels.
const NORMAL: f64 = 82.0;
const FRICTION: f64 = 92.0;
const SPEED: f64 = 170.0;
/// How far beside the flank the sliding of the surface is drawn.
const BESIDE: f64 = 13.0;
/// From the top of a panel to what is drawn, and the height of a panel.
const HEAD: f64 = 52.0;
const HEIGHT: f64 = 318.0;
/// How far the pin is drawn from the middle of the page, against the sense of its sliding.
const ASIDE: f64 = 50.0;
/// The ends of the slot on the page.
const ENDS: [f64; 2] = [14.0, WIDTH - 14.0];

/// What is drawn of one instant.
struct Instant {
    theta: f64,
    /// +1 on the leading flank, −1 on the trailing one.
    side: f64,
    /// dR/dθ, what the turning of the pin adds, and their sum, outward.
    slide: f64,
    turning: f64,
    sliding: f64,
}

/// The first instant, as a part of the way from the line of centres back to the entry.
const DRIVING: f64 = 0.6;
/// Relative tolerance of the steady motion.
pub(super) const TOLERANCE: f64 = 1e-10;

/// A pin of this radius, in crank radii, in the slots of an escapement, in its steady motion: while it drives the follower, and
/// where the driver is fastest.
///
/// # Errors
///
/// [`FigureError::Dynamics`] for a radius that is not from 0 to below 1, and if there is no steady motion.
pub fn contact(parameters: &Parameters, pin_radius: f64) -> Result<Figure, FigureError> {
    contact_within(TOLERANCE, parameters, pin_radius)
}

fn contact_within(tolerance: f64, parameters: &Parameters, pin_radius: f64) -> Result<Figure, FigureError> {
    let escapement = Escapement::new(parameters, Joints { pin_radius, ..Joints::IDEAL })?;
    let state = escapement.steady_state(tolerance)?.state;
    let driving = -DRIVING * parameters.mechanism().engagement_half_angle();
    at_instants(&escapement, [(driving, state.entry_speed), (state.peak.angle, state.peak.speed)])
}

/// The pin in its slot at two instants, enlarged: each a crank angle in radians from the line of centres, and a speed of
/// the driver.
///
/// The follower's axis lies to the left and the follower turns counter-clockwise, so that the leading flank is above. Seen
/// from the follower the pin turns clockwise. Forces are those on the follower, and show directions only; velocities are
/// to one scale. Series, a row for each: θ, side, dR/dθ, s ρ (1 + q), w/θ'.
///
/// # Errors
///
/// [`FigureError::Dynamics`] if an angle is outside the engagement, or the speed negative.
pub(super) fn at_instants(escapement: &Escapement, instants: [(f64, f64); 2]) -> Result<Figure, FigureError> {
    let [first, second] = instants.map(|(angle, speed)| Instant::new(escapement, angle, speed));
    let instants = [first?, second?];
    let mut canvas = Canvas::new(WIDTH, HEIGHT * instants.len() as f64);
    for (k, instant) in instants.iter().enumerate() {
        panel(&mut canvas, instant, k + 1, HEIGHT * k as f64);
    }
    let (parameters, joints) = (escapement.parameters(), escapement.joints());
    let series = Series::new(
        [("theta", "deg"), ("side", "1"), ("dr/dtheta", "1"), ("s rho (1+q)", "1"), ("w/theta'", "1")],
        instants.iter().map(|at| [at.theta.to_degrees(), at.side, at.slide, at.turning, at.sliding]),
    );
    let said = instants.iter().map(|at| {
        format!(
            "At θ = {} the pin touches the {} flank; its centre moves along the slot with {} θ̇ times the crank radius, \
             its surface slides with {} θ̇.",
            degrees(at.theta),
            at.flank(),
            number(at.slide),
            number(at.sliding)
        )
    });
    let words = Words::new(
        "joints-contact",
        "A pin of finite radius in its slot",
        format!(
            "Two panels, each with a round pin between the two straight flanks of a slot. {} The friction on the flank \
             points the way the surface slides.",
            said.collect::<Vec<_>>().join(" ")
        ),
        format!(
            "The pin in its slot, enlarged, seen from the follower, whose axis O is far to the left. In panel 1 the \
             pin drives the follower, and in panel 2 it holds the follower back. Seen from the follower, the pin spins clockwise about its own centre, so its surface slides \
             more slowly at the flank than its centre moves. F and μ|F| act on the \
             follower; these two arrows show directions only. Lengths are in crank radii. Shown: {} pins, ρ = {}, μ = \
             {}, steady state.",
            parameters.mechanism().pins(),
            joints.pin_radius,
            parameters.friction()
        ),
    );
    Ok(words.figure(canvas, DrawingKind::Diagram, series))
}

impl Instant {
    fn new(escapement: &Escapement, theta: f64, speed: f64) -> Result<Self, FigureError> {
        let motion = escapement.motion(theta, speed)?;
        let slide = Reach::from_pose(&escapement.parameters().pose(theta)).slide;
        let side = if motion.flank == Sign::Plus { 1.0 } else { -1.0 };
        Ok(Self { theta, side, slide, turning: motion.sliding - slide, sliding: motion.sliding })
    }

    fn flank(&self) -> &'static str {
        if self.side > 0.0 { "leading" } else { "trailing" }
    }
}

fn number(value: f64) -> String {
    with_minus_sign(&format_fixed(value, 2))
}

fn panel(canvas: &mut Canvas, at: &Instant, count: usize, top: f64) {
    let (right, up) = (Vector2::new(1.0, 0.0), Vector2::new(0.0, -1.0));
    let corner = Vector2::new(20.0, top + 24.0);
    draw_number(canvas, &corner, count);
    let title = if at.side > 0.0 { "Pin drives: leading flank, " } else { "Pin holds back: trailing flank, " };
    let title = Label::words(title).and_symbol("F").and(if at.side > 0.0 { " > 0, " } else { " < 0, " });
    let title = title.and_symbol("θ").and(&format!(" = {}", degrees(at.theta)));
    canvas.label(&(corner + right * 22.0), &right, 0.0, &title.bare());

    // Room above for the arrow of F where the leading flank bears, else for the wall alone.
    let above = if at.side > 0.0 { NORMAL } else { WALL };
    let outward = at.sliding.signum();
    let centre = Vector2::new(WIDTH / 2.0 - outward * ASIDE, top + HEAD + above + PIN);
    let place = |along: f64, ahead: f64| centre + right * along + up * ahead;
    let across = |x: f64, ahead: f64| Vector2::new(x, centre.y - ahead);
    for side in [1.0, -1.0] {
        let [near, far] = [side * PIN, side * (PIN + WALL)];
        let wall = Path::start(&across(ENDS[0], near)).line_to(&across(ENDS[1], near));
        let wall = wall.line_to(&across(ENDS[1], far)).line_to(&across(ENDS[0], far)).close();
        canvas.draw(Shape::path(wall).fill(FILL).class("wall"));
        let bears = side == at.side;
        let flank = Shape::line(&across(ENDS[0], near), &across(ENDS[1], near));
        canvas.draw(flank.stroke(FOLLOWER, if bears { 4.0 } else { 1.8 }).class(if bears {
            "bearing-flank"
        } else {
            "flank"
        }));
        let words = Label::words(if side > 0.0 { "leading flank" } else { "trailing flank" }).in_colour(FOLLOWER);
        canvas.label(&place(-outward * 92.0, side * (PIN + WALL / 2.0)), &(right * -outward), 0.0, &words);
    }
    let line = [ENDS[0] + 8.0, ENDS[1]].map(|x| Vector2::new(x, centre.y));
    canvas.draw(Shape::line(&line[0], &line[1]).stroke(FOLLOWER, 1.2).dashed(DASHED).class("centre-line"));
    canvas.label(&across(ENDS[0] + 4.0, -30.0), &right, 0.0, &Label::words("to ").and_symbol("O").in_colour(FOLLOWER));
    canvas.draw(Shape::circle(&centre, PIN).fill(PAPER).stroke(INK, 2.2).class("enlarged-pin"));

    let touch = place(0.0, at.side * PIN);
    canvas.draw(Shape::line(&centre, &touch).stroke(DRIVER, 2.2).class("radius").attribute("data-letter", "ρ"));
    canvas.label(&place(0.0, at.side * 0.5 * PIN), &(right * -outward), 9.0, &Label::part("ρ").in_colour(DRIVER));
    turning(canvas, at, &centre);
    canvas.draw(Shape::circle(&centre, 3.5).fill(INK));
    // Velocities: of the centre, and of the surface where it touches.
    let tip = place(at.slide * SPEED, 0.0);
    part(canvas, "r'", |canvas| arrow(canvas, &centre, &tip, RELATIVE, 4.0, "sliding-of-centre"));
    // Beside the arrow's tip, on the side that does not rub.
    let beside = tip - right * (outward * 20.0);
    let label = Label::rate("r", 1).and(" of the centre").in_colour(RELATIVE).of_part("r'");
    canvas.label(&beside, &(up * -at.side), 18.0, &label);
    let inside = at.side * (PIN - BESIDE);
    let tip = place(at.sliding * SPEED, inside);
    part(canvas, "w", |canvas| arrow(canvas, &place(0.0, inside), &tip, DRIVER, 4.0, "sliding-of-surface"));
    canvas.label(&tip, &(right * outward), 8.0, &Label::part("w").and(" of the surface").in_colour(DRIVER));
    // Forces on the follower.
    let end = touch + up * (at.side * NORMAL);
    part(canvas, "F", |canvas| arrow(canvas, &touch, &end, INK, 4.0, "normal-force"));
    canvas.label(&end.lerp(&touch, 0.15), &(right * -outward), 10.0, &Label::part("F"));
    let from = touch + up * (at.side * WALL / 2.0);
    let end = from + right * (outward * FRICTION);
    arrow(canvas, &from, &end, CORIOLIS, 4.0, "friction");
    let label = Label::symbol("μ").and("\u{2009}|").and_symbol("F").and("|").in_colour(CORIOLIS);
    canvas.label(&end, &(right * outward), 8.0, &label);

    let values = [
        Label::rate("r", 1).and("/").and_rate("θ", 1).and(" = ").and(&number(at.slide)).in_colour(RELATIVE),
        Label::symbol("s").and_symbol("ρ").and("(1 + ").and_symbol("q").and(") = ").and(&number(at.turning)),
        Label::symbol("w").and("/").and_rate("θ", 1).and(" = ").and(&number(at.sliding)).in_colour(DRIVER),
    ];
    for (k, label) in values.into_iter().enumerate() {
        let corner = Vector2::new(28.0 + 210.0 * k as f64, top + HEIGHT - 24.0);
        canvas.label(&corner, &right, 0.0, &label.bare());
    }
}

/// The turning of the pin, seen from the follower: clockwise, on the side that no other arrow takes.
fn turning(canvas: &mut Canvas, at: &Instant, centre: &Pixels) {
    let outward = at.sliding.signum();
    // The quarter opposite to the touching point and to the sliding.
    let (from, to) = match (at.side > 0.0, outward > 0.0) {
        (true, false) => (-0.1, -1.6),
        (false, true) => (-3.2, -4.7),
        (true, true) => (-1.6, -3.1),
        (false, false) => (1.6, 0.1),
    };
    arc_arrow(canvas, centre, 0.62 * PIN, from, to, INK, 2.0);
    let label = Label::rate("θ", 1).and(" + ").and_rate("φ", 1);
    let beside = centre + Vector2::new(-outward * (PIN + 2.0), at.side * 0.55 * PIN);
    canvas.label(&beside, &Vector2::new(-outward, 0.0), 6.0, &label);
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_dynamics::Inertias;
    use geneva_kinematics::Mechanism;

    #[test]
    fn a_tolerance_ten_times_finer_gives_the_same_digits() {
        for mechanism in Mechanism::ALL {
            let inertias = Inertias::new(2.0, 1.0).expect("inertias");
            let parameters = Parameters::new(mechanism, inertias, 1.0, 0.2).expect("parameters");
            let [usual, finer] = [TOLERANCE, TOLERANCE / 10.0]
                .map(|tolerance| contact_within(tolerance, &parameters, 0.1).expect("drawn").series.rows);
            for (usual, finer) in usual.iter().flatten().zip(finer.iter().flatten()) {
                // A peak is flat: its place is known less well than its height.
                assert!((usual - finer).abs() <= 1e-8 * usual.abs(), "{mechanism:?}: {usual} and {finer}");
            }
        }
    }
}
