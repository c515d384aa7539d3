//! What the size of the joints costs: mean speed and multiplier against it.

use crate::chart::{Chart, ChartAxis, Panel, kind};
use crate::number::{extent, significant, with_hyphens};
use crate::svg::Label;
use crate::{Figure, FigureError, ItemValue, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::joints::{Effect, Joints, Varied, series};
use std::f64::consts::FRAC_PI_2;

/// The largest radius, in crank radii, and how many there are besides zero.
const LARGEST: f64 = 0.2;
const RADII: u32 = 8;
/// What the x axis shows.
const SIZE: &str = "radius of pin or journal in crank radii";
/// The two panels: the title of each, and what it shows.
const PANELS: [(&str, ItemValue<Effect>); 2] =
    [("mean speed over ideal mean speed", |effect| effect.mean_speed), ("multiplier", |effect| effect.multiplier)];

/// Mean speed over that of the ideal mechanism, and multiplier, over the radius of the pin, of the driver's journal, and of the
/// follower's: in bearings with this friction, each alone. `shown` says which escapement it is.
///
/// Series: number of the panel, number of the joint, radius, value.
///
/// # Errors
///
/// [`FigureError::Dynamics`] if there is no steady motion to compare with.
pub fn losses(parameters: &Parameters, bearing_friction: f64, shown: &str) -> Result<Figure, FigureError> {
    let journals = Joints { bearing_friction, ..Joints::IDEAL };
    let radii = || (0..=RADII).map(|k| LARGEST * f64::from(k) / f64::from(RADII));
    let lines = [
        ("pin", series(parameters, &Joints::IDEAL, Varied::PinRadius, radii())?),
        ("driver's journal", series(parameters, &journals, Varied::DriverJournal, radii())?),
        ("follower's journal", series(parameters, &journals, Varied::FollowerJournal, radii())?),
    ];
    let x = ChartAxis::spanning(0.0, LARGEST, 5.0);
    let panels = [0, 1].map(|k| {
        let (title, value) = PANELS[k];
        let [low, high] = extent(lines.iter().flat_map(|(_, line)| line).map(value));
        let y = ChartAxis::spanning(low, high, 4.0).titled(Label::words(title));
        let x = if k == 1 { x.clone().titled(Label::words(SIZE)) } else { x.clone() };
        lines.iter().enumerate().fold(Panel::new(260.0, &x, &y), |panel, (number, (name, line))| {
            let (points, (stroke, marker)) = (points(line, value), kind(number));
            let last_half = points[points.len() / 2..].to_vec();
            let side = if points[points.len() - 1].1 < points[0].1 { -FRAC_PI_2 } else { FRAC_PI_2 };
            let panel = panel.curve(points.clone(), stroke.wide(2.2).class("loss")).marks(points, marker.sized(8.0));
            // Named once, where the lines are farthest apart: the looks are the same in both panels.
            let name = Label::words(&with_hyphens(name)).in_colour(stroke.colour);
            if k == 0 { panel.name_near(last_half, side, name) } else { panel }
        })
    });
    let said = PANELS.iter().flat_map(|(title, value)| {
        lines.iter().map(move |(name, line)| {
            let [from, to] = [&line[0], &line[line.len() - 1]].map(|effect| significant(value(effect), 3));
            format!("{title}, {name}: from {from} to {to}")
        })
    });
    let words = Words::new(
        "joints-losses",
        "What the size of the joints costs",
        format!(
            "Two panels over the {SIZE}: the mean speed over the mean speed of the ideal mechanism, and the \
             multiplier. {}.",
            said.collect::<Vec<_>>().join("; ")
        ),
        format!(
            "How the mean speed and the multiplier depend on the {SIZE}. The mean speed is divided by the mean speed \
             of the ideal mechanism. Shown: {shown}."
        ),
    );
    let rows = (1..).map(f64::from).zip(PANELS).flat_map(|(panel, (_, value))| {
        (1..).map(f64::from).zip(&lines).flat_map(move |(number, (_, line))| {
            points(line, value).into_iter().map(move |(x, y)| [panel, number, x, y])
        })
    });
    let series = Series::new([("panel", "1"), ("line", "1"), ("size", "1"), ("value", "1")], rows);
    Ok(Chart::new(panels).figure(words, series))
}

/// The radii of a joint, and the value at each.
fn points(line: &[Effect], value: ItemValue<Effect>) -> Vec<(f64, f64)> {
    line.iter().map(|effect| (effect.value, value(effect))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound, columns};
    use geneva_dynamics::Inertias;
    use geneva_kinematics::Mechanism;

    #[test]
    fn every_line_is_drawn_where_its_points_are() {
        let inertias = Inertias::new(0.1, 1.0).expect("inertias");
        let parameters = Parameters::new(Mechanism::FOUR_PIN, inertias, 1.0, 0.2).expect("an escapement");
        let figure = losses(&parameters, 0.2, "an example").expect("a steady motion");
        assert_sound(&figure);
        let drawing = ParsedDrawing::parse(&figure);
        assert_eq!((drawing.count("loss"), drawing.count("marks")), (2 * 3, 2 * 3));
        let rows = columns(&figure.series, ["panel", "line", "size", "value"]);
        assert_eq!(rows.len(), 2 * 3 * (RADII as usize + 1));
        for (k, line) in rows.chunks(RADII as usize + 1).enumerate() {
            let ([panel, number, first, ideal], [_, _, last, value]) = (line[0], line[line.len() - 1]);
            assert_eq!([panel, number, first, last], [(k / 3 + 1) as f64, (k % 3 + 1) as f64, 0.0, LARGEST]);
            // What falls in the series falls on the page, too.
            let ends = drawing.path("loss", k);
            let (start, end) = (ends[0], ends[ends.len() - 1]);
            assert!(end.x > start.x && (end.y > start.y) == (value < ideal), "line {k}: {ideal} to {value}");
            assert!(panel > 1.0 || (ideal - 1.0).abs() < 1e-6, "line {k}: {ideal}");
        }
    }
}
