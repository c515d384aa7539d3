//! How likely a table is, over a lag in the program that made it.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::number::{format_trimmed, with_minus_sign};
use crate::svg::Label;
use crate::theme::{CORIOLIS, DRIVER, FOLLOWER};
use crate::{Figure, Series, Words};

/// How likely one lag makes the printed tables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LagLikelihood {
    /// The lag, in milliseconds.
    pub lag: f64,
    /// ln L with the normal and with the exponential law, dimensionless.
    pub likelihoods: [f64; 2],
    /// How many of the peaks are within one unit.
    pub peaks: usize,
}

/// An axis cut off at both ends.
fn within(axis: ChartAxis, least: f64, most: f64) -> ChartAxis {
    let ticks = axis.ticks.iter().copied().filter(|mark| (least..=most).contains(mark)).collect();
    ChartAxis { range: least..most, ticks, ..axis }
}

/// ln L below its greatest value, with both laws, and the peaks within one unit, over the lag of the sign of the friction.
///
/// `listed` is the lag of the program as listed, `of` how many peaks there are. Series: lag, both ln L, peaks.
pub fn lags(all: &[LagLikelihood], listed: f64, of: usize) -> Figure {
    let most = all.iter().map(|one| one.lag).fold(0.0, f64::max);
    let room = 0.03 * most;
    let x = within(ChartAxis::from_zero(0.0, most, 5.0), -room, most + room);
    let laws = [(0, "normal law", FOLLOWER, MarkShape::Disc), (1, "exponential law", DRIVER, MarkShape::Square)];
    let best = |law: usize| all.iter().map(|one| one.likelihoods[law]).fold(f64::NEG_INFINITY, f64::max);
    let below = |law: usize| all.iter().map(move |one| (one.lag, one.likelihoods[law] - best(law)));
    let least = laws.iter().flat_map(|(law, ..)| below(*law)).map(|point| point.1).fold(0.0, f64::min);
    let bottom = 1.05 * least;
    let y = within(ChartAxis::from_zero(bottom, 0.0, 4.0), bottom, -0.06 * bottom)
        .titled(Label::words("ln ").and_symbol("L").and(" below its greatest value"));
    let marked = |panel: Panel| panel.vertical(listed, LineStyle::thin("listed").dashed("5 4"));
    let likelihoods = laws.iter().fold(marked(Panel::new(280.0, &x, &y)), |panel, (law, name, colour, mark)| {
        let side = if *law == 0 { -2.4 } else { 0.7 };
        panel
            .curve(below(*law), LineStyle::new(*colour).wide(2.0))
            .marks(below(*law), Marker::new(*colour, *mark))
            .name_near(below(*law).skip(all.len() / 2), side, Label::words(name).in_colour(*colour))
    });
    let counts = || all.iter().map(|one| (one.lag, one.peaks as f64));
    let fewest = counts().map(|point| point.1).fold(of as f64, f64::min);
    let y =
        ChartAxis::spanning(fewest, of as f64, 4.0).titled(Label::words(&format!("peaks within one unit, of {of}")));
    let peaks = marked(Panel::new(190.0, &x.titled(Label::words("lag of the sign, ms")), &y))
        .curve(counts(), LineStyle::new(CORIOLIS).wide(2.0))
        .marks(counts(), Marker::new(CORIOLIS, MarkShape::Diamond))
        .name_near([(listed, (fewest + of as f64) / 2.0)], 0.0, Label::words("as listed"));
    let said = all.iter().map(|one| {
        let [normal, exponential] =
            [0, 1].map(|law| with_minus_sign(&format_trimmed(one.likelihoods[law] - best(law), 0)));
        format!("{} ms: {normal} and {exponential}, {} peaks", format_trimmed(one.lag, 3), one.peaks)
    });
    let words = Words::new(
        "runs-lags",
        "How likely the printed tables are, over the lag of the friction's sign",
        format!(
            "Two panels over the lag. Above, the logarithm of the likelihood below its greatest value, with the normal and the \
             exponential law; below, the peaks within one unit. {}.",
            said.collect::<Vec<_>>().join("; ")
        ),
        "Both laws of the errors prefer small lags: the normal law prefers none, and the exponential law prefers the \
         lag that the thesis lists (dashed line). At twice this lag or more, the tables are far less likely, and fewer \
         peaks agree. The runs of all three mechanisms are computed by the program as listed, except for the lag.",
    );
    let columns = [("lag", "ms"), ("ln L normal", "1"), ("ln L exponential", "1"), ("peaks", "1")];
    let rows = all.iter().map(|one| [one.lag, one.likelihoods[0], one.likelihoods[1], one.peaks as f64]);
    Chart::new([likelihoods, peaks]).figure(words, Series::new(columns, rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound};

    #[test]
    fn the_likeliest_lag_of_each_law_is_drawn_at_zero() {
        let all: Vec<LagLikelihood> = (0..6)
            .map(|k| {
                let lag = f64::from(k) / 10.0;
                LagLikelihood {
                    lag,
                    likelihoods: [-300.0 - 90.0 * lag, -280.0 - 100.0 * (lag - 0.1).abs()],
                    peaks: 45 - k as usize,
                }
            })
            .collect();
        let figure = lags(&all, 0.1, 49);
        assert_sound(&figure);
        let drawing = ParsedDrawing::parse(&figure);
        assert_eq!(["curve", "marks", "listed"].map(|class| drawing.count(class)), [3, 3, 2]);
        let tops =
            [0, 1].map(|law| drawing.path("curve", law).iter().map(|point| point.y).fold(f64::INFINITY, f64::min));
        assert!((tops[0] - tops[1]).abs() < 0.2, "{tops:?}");
    }
}
