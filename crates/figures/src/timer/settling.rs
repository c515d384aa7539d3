//! How long an escapement takes to settle, over the inertia of its follower.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::number::{extent, format_trimmed, significant};
use crate::svg::Label;
use crate::theme::{DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, FigureError, Series, Words};
use geneva_dynamics::timer::Settling;
use geneva_dynamics::{Inertias, Parameters};

/// A motion counts as settled when a small difference is down to this part of itself.
const SETTLED: f64 = 0.01;
const MILLISECONDS: f64 = 1000.0;

/// Engagements to one per cent, the time of each, and their product, over the follower's inertia, on logarithmic axes.
///
/// The follower has its own inertia over each of `parts`; the unit of time is the second. `run` says which run is changed.
/// Series: part of the inertia, engagements, period and time in milliseconds.
///
/// # Errors
///
/// [`FigureError::Nothing`] if there is no follower, and [`FigureError::Dynamics`] if one has no steady motion.
pub fn settling(own: &Parameters, parts: &[f64], run: &str) -> Result<Figure, FigureError> {
    if parts.is_empty() {
        return Err(FigureError::Nothing);
    }
    let row = |part: &f64| {
        let inertias = Inertias::new(own.inertias().driver(), own.inertias().follower() / part)?;
        let found = Settling::new(&Parameters::new(own.mechanism(), inertias, own.torque(), own.friction())?)?;
        let time = found.time(SETTLED);
        Ok([1.0 / part, found.engagements(SETTLED), MILLISECONDS * found.period, MILLISECONDS * time])
    };
    let rows: Vec<[f64; 4]> = parts.iter().map(row).collect::<Result<_, FigureError>>()?;
    let least = rows.iter().map(|row| row[0]).fold(1.0, f64::min);
    let marks: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    let names = rows
        .iter()
        .map(|row| if row[0] < 1.0 { format!("1/{}", format_trimmed(1.0 / row[0], 0)) } else { "1".to_owned() });
    let x = ChartAxis {
        names: names.collect(),
        ..ChartAxis::new(crate::chart::AxisScale::Logarithmic, 0.85 * least..1.18, marks, 3)
    };
    let looks = [
        (1, "engagements to 1 %", Marker::new(FOLLOWER, MarkShape::Square)),
        (2, "time of an engagement, ms", Marker::new(RELATIVE, MarkShape::Diamond)),
        (3, "time to 1 %, ms", Marker::new(DRIVER, MarkShape::Disc)),
    ];
    let panels = looks.map(|(column, title, marker)| {
        let points = || rows.iter().map(move |row| (row[0], row[column]));
        let most = points().map(|point| point.1).fold(0.0, f64::max);
        let y = ChartAxis::from_zero(0.0, most, 3.0).titled(Label::words(title).in_colour(marker.colour));
        let x = if column == 3 {
            x.clone().titled(Label::words("follower's inertia over the run's inertia"))
        } else {
            x.clone().unnumbered()
        };
        Panel::new(165.0, &x, &y).curve(points(), LineStyle::new(marker.colour).wide(2.0)).marks(points(), marker)
    });
    let times = || rows.iter().map(|row| row[3]);
    let [quickest, slowest] = extent(times());
    let words = Words::new(
        "timer-settling",
        "How long a small difference from the steady motion lasts with a lighter follower",
        format!(
            "Three panels over the follower's inertia. From the lightest follower to the run's follower the number of \
             engagements falls, the time of each engagement rises, and their product stays between {} and {} ms.",
            significant(quickest, 3),
            significant(slowest, 3)
        ),
        format!(
            "With a lighter follower each engagement is shorter, but a small difference from the steady motion needs \
             more of them to die away. So in this example the time in which a small difference in the square of the \
             speed falls to one per cent stays between {} and {} ms. Shown: {run}, with only the follower's inertia \
             changed.",
            significant(quickest, 3),
            significant(slowest, 3)
        ),
    );
    let columns = [("part of I_f", "1"), ("engagements", "1"), ("period", "ms"), ("time to 1 %", "ms")];
    Ok(Chart::new(panels).figure(words, Series::new(columns, rows)))
}
