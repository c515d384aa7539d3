//! What a program prints, drawn: one quantity against another, or several.

mod fitted;

use crate::chart::{Chart, LegendEntry, NUMBER_ROOM, Panel, kind};
use crate::svg::Label;
use crate::{Figure, FigureError, Series, Words};
use fitted::Fitted;

/// Most points of a curve: more are closer together than a pixel.
const MOST: usize = 4000;
/// Height of the frame, and nearly its width, in pixels; room between two numbers under it.
const HEIGHT: f64 = 366.0;
const ACROSS: f64 = 500.0;
const GAP: f64 = 12.0;

/// The second and the later columns of `points` as curves over the first; `names` has a name for each.
///
/// Of many points every so-manieth is drawn. Where its numbers would be too wide, an axis shows its values over a power
/// of ten, perhaps less a number, as its title says. Series: what is drawn.
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
    let values =
        |columns: std::ops::Range<usize>| rows.iter().flat_map(move |row| row[columns.clone()].iter().copied());
    let x = Fitted::new(values(0..1), |marks| ACROSS / marks as f64 - GAP);
    let y = Fitted::new(values(1..names.len()), |_| NUMBER_ROOM);
    let y_title = if let [name] = others {
        y.tick_meaning(name)
    } else if y.is_plain() {
        "see the key".to_owned()
    } else {
        format!("see the key: {}", y.tick_meaning("each"))
    };
    let (x_axis, y_axis) =
        (x.axis.clone().titled(Label::words(&x.tick_meaning(first))), y.axis.clone().titled(Label::words(&y_title)));
    let mut panel = Panel::new(HEIGHT, &x_axis, &y_axis);
    for k in 1..names.len() {
        panel = panel.curve(rows.iter().map(|row| (x.rescale(row[0]), y.rescale(row[k]))), kind(k - 1).0);
    }
    let key = others.iter().enumerate().filter(|_| others.len() > 1);
    let key = key.map(|(k, name)| LegendEntry::curve(kind(k).0, Label::words(name)));
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
    use crate::checks::{ParsedDrawing, assert_drawn};

    fn names(all: &[&str]) -> Vec<String> {
        all.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn each_column_is_a_curve_over_the_first() {
        let points: Vec<Vec<f64>> = (0..50).map(f64::from).map(|t| vec![t, t * t, -t]).collect();
        let figure = plot("two", &names(&["T", "A", "B"]), &points).expect("a figure");
        assert_drawn(&figure);
        assert_eq!(ParsedDrawing::parse(&figure).count("curve"), 2);
        let texts = ParsedDrawing::parse(&figure).texts();
        assert!(["T", "A", "B"].iter().all(|name| texts.iter().any(|text| text == name)), "{texts:?}");
    }

    /// The texts of a drawing of X from one number to another.
    #[track_caller]
    fn texts(from: f64, to: f64) -> Vec<String> {
        let points: Vec<_> =
            (0..=10).map(f64::from).map(|k| vec![k, from * (1.0 - k / 10.0) + to * (k / 10.0)]).collect();
        let figure = plot("large", &names(&["T", "X"]), &points).expect("a figure");
        assert_drawn(&figure);
        ParsedDrawing::parse(&figure).texts()
    }

    #[test]
    fn numbers_of_any_size_have_short_labels_and_a_title_that_says_what_they_are() {
        for (from, to, title, labels) in [
            (0.0, 5.0, "X", &["0", "1", "5"][..]),
            (0.0, 1000.0, "X", &["0", "1000"]),
            (0.0, 50_000.0, "X / 10⁴", &["0", "5"]),
            (-1e7, 1e7, "X / 10⁷", &["−1.0", "1.0"]),
            (0.0, 1e-6, "X / 10⁻⁶", &["0.0", "0.2", "1.0"]),
            (1.0, 1.0 + 1e-6, "(X − 1) / 10⁻⁶", &["0.0", "0.2", "1.0"]),
            (-3.0, -3.0 + 1e-4, "(X + 3) / 10⁻⁴", &["0.0", "1.0"]),
            (1_234_567.0, 1_234_568.0, "X − 1.234567·10⁶", &["0.0", "1.0"]),
            (-1.7e308, 1.7e308, "X / 10³⁰⁸", &["−2", "2"]),
            (1.7e308, 1.7e308, "X / 10³⁰⁸", &["2"]),
            (0.0, 1e-320, "X", &["−1.0", "0.0", "1.0"]),
            (0.0, 2e-280, "X / 10⁻²⁸⁰", &["0.0", "2.0"]),
        ] {
            let texts = texts(from, to);
            for text in std::iter::once(&title).chain(labels) {
                assert!(texts.iter().any(|found| found == text), "{from:e} to {to:e}: no {text} in {texts:?}");
            }
        }
        // Whatever the numbers, all differ, and none is wider than its margin.
        for exponent in -280..300 {
            for (low, high) in [(-1.0, 1.2), (0.0, 9.9), (3.0, 3.001), (-1.2, 0.0), (-7.77, -7.76), (1.0, 1.0 + 1e-8)] {
                let size = crate::number::power(exponent);
                let y = Fitted::new([low * size, high * size].into_iter(), |_| NUMBER_ROOM);
                assert!(
                    y.axis.is_readable(NUMBER_ROOM) && y.axis.ticks.len() < 12,
                    "{low} to {high} times {size}: {y:?}"
                );
                let shares = [low, high].map(|end| y.axis.share(y.rescale(end * size)));
                assert!(shares[0] > -0.01 && shares[1] < 1.01 && shares[1] - shares[0] > 0.3, "{shares:?} {y:?}");
            }
        }
    }

    #[test]
    fn the_key_says_what_several_curves_are_over() {
        let points: Vec<Vec<f64>> = (0..5).map(f64::from).map(|t| vec![1e6 * t, 1e6 * t, -1e6 * t]).collect();
        let texts = ParsedDrawing::parse(&plot("two", &names(&["T", "A", "B"]), &points).expect("a figure")).texts();
        assert!(["T / 10⁶", "see the key: each / 10⁶", "A"].iter().all(|text| texts.iter().any(|of| of == text)));
    }

    #[test]
    fn what_stands_still_is_drawn_and_what_is_nothing_is_refused() {
        let still = vec![vec![0.0, 7.0], vec![1.0, 7.0]];
        assert_drawn(&plot("still", &names(&["T", "A"]), &still).expect("a figure"));
        for (columns, points) in [(vec!["T", "A"], vec![]), (vec!["T"], vec![vec![1.0]]), (vec![], vec![vec![]])] {
            assert!(plot("nothing", &names(&columns), &points).is_err());
        }
    }
}
