//! The lever's angle, angular velocity and angular acceleration over a turn of the crank.

use super::instant::{LeverState, format_with_unit, lever_acceleration, rate_of};
use crate::chart::{Chart, ChartAxis, LegendEntry, LineStyle, MarkShape, Marker, Panel};
use crate::number::{degrees, extent, short, significant};
use crate::svg::Label;
use crate::theme::{FILL, FOLLOWER};
use crate::{Figure, Series, Words};
use geneva_kinematics::Turn;
use geneva_kinematics::quick_return::{Drive, Position, QuickReturn, Strokes};
use std::f64::consts::PI;

/// Degrees of crank angle between two marks.
const MARKS: usize = 60;
/// At least so many steps of a y axis.
const STEPS: f64 = 4.0;

/// φ, φ′ and φ″ over a whole turn of the crank at constant speed, one under another, with the instant in all three.
///
/// Of `drive` only the speed counts, in radians per second. The fast stroke is on a tinted ground, the slow one on a
/// plain one. A lever that turns round and round has half turns instead of strokes. Series, each degree: θ, φ, φ′, φ″.
pub fn over_a_turn(linkage: &QuickReturn, position: &Position, drive: &Drive<f64>) -> Figure {
    let drive = Drive::steady(drive.speed);
    let instant = LeverState::new(linkage, position, &drive);
    let (strokes, rows) = (linkage.strokes(), rows(linkage, &drive));
    let panels = [1, 2, 3].map(|column| panel(&rows, column, &instant, &drive, &strokes));
    let (theta, phi) = (degrees(instant.theta()), degrees(instant.lever_angle));
    let columns = [("theta", "deg"), ("phi", "deg"), ("phi'", "rad/s"), ("phi''", "rad/s^2")];
    let (stroke, there) = match strokes.swing_limit {
        Some(limit) => ("stroke", format!("swings between −{0} and {0}", degrees(limit))),
        None => ("half turn", "turns round and round, fast while it points away from the crank's axis".to_owned()),
    };
    let words = Words::new(
        "quick-return-turn",
        "Motion of the lever over a turn of the crank",
        format!(
            "Three curves over the crank angle from −180° to 180°: the lever's angle, its angular velocity and its angular \
             acceleration, at a constant crank speed of {}. The lever {there}. The slow {stroke} takes {} of the crank's \
             turn, the fast one {}{}. At a crank angle of {theta} the lever is at {phi}; its \
             angular velocity is {}, its angular acceleration {}.",
            format_with_unit(drive.speed, "rad/s"),
            degrees(strokes.slow),
            degrees(strokes.fast),
            ratio(&strokes).map_or(String::new(), |ratio| format!("; their ratio is {ratio}")),
            format_with_unit(instant.lever_speed(&drive), "rad/s"),
            format_with_unit(instant.lever_acceleration(&drive), "rad/s²"),
        ),
        format!(
            "A whole turn of the crank at {}. The fast {stroke} is tinted. The dashed line marks the instant θ = {theta}, φ = \
             {phi}. Counter-clockwise is positive.",
            format_with_unit(drive.speed, "rad/s")
        ),
    );
    Chart::new(panels).key(header(&strokes)).figure(words, Series::new(columns, rows))
}

/// θ and φ in degrees, φ′, φ″, at each degree of a turn at constant crank speed.
///
/// φ goes on without a jump: a lever that turns ends a turn farther on. Where the pin is on the lever's pivot there is
/// no row.
fn rows(linkage: &QuickReturn, drive: &Drive<f64>) -> Vec<[f64; 4]> {
    let turns = linkage.strokes().swing_limit.is_none();
    let row = |degrees: u32| {
        let crank = f64::from(degrees);
        let position = linkage.position_at_crank(&Turn::from_degrees(crank)).ok()?;
        let instant = LeverState::new(linkage, &position, drive);
        let phi = match position.lever.degrees() {
            _ if degrees == 0 || (degrees == 360 && !turns) => 0.0,
            _ if degrees == 360 => 360.0,
            phi if turns && degrees > 180 && phi < 0.0 => phi + 360.0,
            phi => phi,
        };
        Some([crank - 180.0, phi, instant.lever_speed(drive), instant.lever_acceleration(drive)])
    };
    (0..=360).filter_map(row).collect()
}

/// Time of the slow stroke over that of the fast one, if there is a fast one.
fn ratio(strokes: &Strokes) -> Option<String> {
    (strokes.fast > 1e-9).then(|| significant(strokes.time_ratio(), 4))
}

/// The two strokes with their crank angles, and the time ratio.
fn header(strokes: &Strokes) -> [LegendEntry; 2] {
    let stroke = if strokes.swing_limit.is_some() { "stroke" } else { "half turn" };
    let ratio = ratio(strokes).map_or(String::new(), |ratio| format!("; time ratio {ratio}"));
    let fast = format!("fast {stroke} {}", degrees(strokes.fast));
    let slow = format!("slow {stroke} {}{ratio}", degrees(strokes.slow));
    [LegendEntry::curve(LineStyle::new(FILL).wide(18.0), Label::words(&fast)), LegendEntry::words(Label::words(&slow))]
}

/// The panel of a column of the rows: φ, φ′ or φ″, with the fast stroke and the instant.
fn panel(rows: &[[f64; 4]], column: usize, instant: &LeverState, drive: &Drive<f64>, strokes: &Strokes) -> Panel {
    let turns = strokes.swing_limit.is_none();
    let phi = instant.lever_angle.to_degrees();
    let phi = if turns && instant.crank_angle > PI && phi < 0.0 { phi + 360.0 } else { phi };
    let (speed, rate) = (instant.lever_speed(drive), instant.lever_acceleration(drive));
    // Beside the mark the value alone: a longer label would stand on the line of the instant.
    let (symbol, unit, value, text) = match column {
        1 => (Label::symbol("φ"), "degrees", phi, degrees(phi.to_radians())),
        2 => (rate_of("φ").of_part(""), "rad/s", speed, short(speed, 4)),
        _ => (lever_acceleration(), "rad/s²", rate, short(rate, 4)),
    };
    let values = || rows.iter().map(|row| row[column]);
    let [least, greatest] = extent(values().chain([0.0]));
    // Angles end on the frame: their ends are known.
    let axis = if column == 1 { ChartAxis::of_angles } else { ChartAxis::from_zero };
    let y = axis(least, greatest, STEPS).titled(symbol.and(&format!(" in {unit}")).in_colour(FOLLOWER));
    let x = ChartAxis::whole(-180.0..180.0, (-180..=180).step_by(MARKS).map(f64::from));
    let angle = Label::words("crank angle ").and_symbol("θ").and(" in degrees");
    let x = if column == 3 { x.titled(angle) } else { x.unnumbered() };
    let half = strokes.fast.to_degrees() / 2.0;
    let [begin, end] = [-half, half];
    let now = instant.theta().to_degrees();
    let reversal = LineStyle::thin("reversal").wide(1.0).dashed("1 4");
    Panel::new(150.0, &x, &y)
        .band(begin..end, FILL, "fast")
        .vertical(begin, reversal)
        .vertical(end, reversal)
        .curve(rows.iter().map(|row| (row[0], row[column])), LineStyle::new(FOLLOWER))
        .vertical(now, LineStyle::thin("instant").dashed("5 4"))
        .marks([(now, value)], Marker::new(FOLLOWER, MarkShape::Disc).sized(11.0).class("now"))
        .name_near([(now, value)], 0.4, Label::words(&text).in_colour(FOLLOWER))
}
