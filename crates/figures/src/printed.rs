//! What a program prints, drawn: one quantity against another, or several.

use crate::chart::{Axis, Chart, Entry, Panel, kind};
use crate::svg::Label;
use crate::{Figure, FigureError, Series, Words};

/// Most points of a curve: more are closer together than a pixel.
const MOST: usize = 4000;
/// Height of the frame, in pixels.
const HEIGHT: f64 = 366.0;

/// The second and the later columns of `points` as curves over the first; `names` has a name for each.
///
/// Of many points every so-manieth is drawn. Series: what is drawn.
///
/// # Errors
///
/// [`FigureError::Nothing`] without a second column, or without a point whose numbers are all finite.
pub fn plot(title: &str, names: &[String], points: &[Vec<f64>]) -> Result<Figure, FigureError> {
    let whole = |point: &&Vec<f64>| point.len() >= names.len() && point.iter().all(|value| value.is_finite());
    let each = points.len().div_ceil(MOST).max(1);
    let rows: Vec<Vec<f64>> =
        points.iter().step_by(each).filter(whole).map(|point| point[..names.len()].to_vec()).collect();
    let (Some((first, others)), false) = (names.split_first(), rows.is_empty()) else {
        return Err(FigureError::Nothing);
    };
    if others.is_empty() {
        return Err(FigureError::Nothing);
    }
    let axis = |columns: std::ops::Range<usize>| {
        let values = || rows.iter().flat_map(|row| row[columns.clone()].iter().copied());
        let [low, high] = [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)];
        // What does not change is drawn in the middle.
        let room = if high - low > 1e-9 * low.abs().max(high.abs()) { 0.0 } else { low.abs().max(1e-3) };
        Axis::spanning(low - room, high + room, 5.0)
    };
    let y_title = if others.len() == 1 { Label::words(&others[0]) } else { Label::words("see the key") };
    let x = axis(0..1).titled(Label::words(first));
    let y = axis(1..names.len()).titled(y_title);
    let mut panel = Panel::new(HEIGHT, &x, &y);
    for k in 1..names.len() {
        panel = panel.curve(rows.iter().map(|row| (row[0], row[k])), kind(k - 1).0);
    }
    let key = others.iter().enumerate().filter(|_| others.len() > 1);
    let key = key.map(|(k, name)| Entry::curve(kind(k).0, Label::words(name)));
    let words = Words::new(
        "printed-plot",
        title,
        format!("{} against {first}, {} points.", others.join(", "), rows.len()),
        format!("{} against {first}, as the program prints them.", others.join(", ")),
    );
    let columns = names.iter().map(|name| (name.clone(), "1"));
    Ok(Chart::new([panel]).key(key).figure(words, Series::of_columns(columns, rows)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{Drawing, drawn};

    fn names(all: &[&str]) -> Vec<String> {
        all.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn each_column_is_a_curve_over_the_first() {
        let points: Vec<Vec<f64>> = (0..50).map(f64::from).map(|t| vec![t, t * t, -t]).collect();
        let figure = plot("two", &names(&["T", "A", "B"]), &points).expect("a figure");
        drawn(&figure);
        assert_eq!(Drawing::of(&figure).count("curve"), 2);
        let texts = Drawing::of(&figure).texts();
        assert!(["T", "A", "B"].iter().all(|name| texts.iter().any(|text| text == name)), "{texts:?}");
    }

    #[test]
    fn what_stands_still_is_drawn_and_what_is_nothing_is_refused() {
        let still = vec![vec![0.0, 7.0], vec![1.0, 7.0]];
        drawn(&plot("still", &names(&["T", "A"]), &still).expect("a figure"));
        for (columns, points) in [(vec!["T", "A"], vec![]), (vec!["T"], vec![vec![1.0]]), (vec![], vec![vec![]])] {
            assert!(plot("nothing", &names(&columns), &points).is_err());
        }
    }
}
