//! What wrong formulas make of wheels, by the number of slots.

use crate::chart::{Chart, ChartAxis, LineStyle, Panel, kind};
use crate::number::{extent, format_trimmed, short};
use crate::svg::Label;
use crate::{Figure, Series, Words};
use std::f64::consts::FRAC_PI_2;

/// A wrong formula, compared with the right one.
#[derive(Clone, Debug, PartialEq)]
pub struct WrongFormula {
    /// What it is for, in a few words.
    pub name: String,
    /// What it gives over what is right, for each number of slots: dimensionless, positive.
    pub ratios: Vec<(u32, f64)>,
}

/// How near to one a ratio is right.
const RIGHT: f64 = 1e-9;

impl WrongFormula {
    /// Whether it is right for some number of slots.
    fn is_right_somewhere(&self) -> bool {
        self.ratios.iter().any(|(_, ratio)| (ratio - 1.0).abs() < RIGHT)
    }

    fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.ratios.iter().map(|(slots, ratio)| (f64::from(*slots), *ratio))
    }
}

/// What wrong formulas give over what is right, all for the same numbers of slots in a row, on a logarithmic axis: those that
/// are right for some number of slots above, the others below.
///
/// Series: the number of slots, then a column for each formula.
///
/// # Panics
///
/// Without a formula.
pub fn wrong_formulas(formulas: &[WrongFormula]) -> Figure {
    let slots = || formulas[0].points().map(|(slots, _)| slots);
    let [first, last] = extent(slots());
    let x = ChartAxis::whole(first - 0.5..last + 0.5, slots());
    let [least, most] = extent(formulas.iter().flat_map(WrongFormula::points).map(|(_, ratio)| ratio).chain([1.0]));
    let y = ChartAxis::logarithmic_about(least..most);
    let panel = |somewhere: bool| {
        let at = if somewhere { right_at(formulas) } else { "no number of".to_owned() };
        let words = format!("given over right; right at {at} slots");
        let x = if somewhere { x.clone() } else { x.clone().titled(Label::words("number of slots ").and_symbol("N")) };
        let mut panel = Panel::new(300.0, &x, &y.clone().titled(Label::words(&words)));
        panel = panel.horizontal(1.0, LineStyle::thin("right"));
        for (number, formula) in formulas.iter().enumerate().filter(|(_, of)| of.is_right_somewhere() == somewhere) {
            let (stroke, marker) = kind(number);
            panel = panel.curve(formula.points(), stroke.wide(1.6)).marks(formula.points(), marker.class("point"));
            // Where they are farthest apart.
            let last_third = formula.points().filter(|(slots, _)| 3.0 * (slots - first) >= 2.0 * (last - first));
            panel = panel.name_near(last_third, FRAC_PI_2, Label::words(&formula.name).in_colour(marker.colour));
        }
        panel
    };
    Chart::new([panel(true), panel(false)]).figure(words(formulas, [first, last]), series(formulas))
}

/// For which numbers of slots a formula is right.
fn right_at(formulas: &[WrongFormula]) -> String {
    let right = formulas.iter().flat_map(|formula| &formula.ratios);
    let mut right: Vec<u32> = right.filter(|(_, ratio)| (ratio - 1.0).abs() < RIGHT).map(|(slots, _)| *slots).collect();
    right.sort_unstable();
    right.dedup();
    right.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}

fn series(formulas: &[WrongFormula]) -> Series {
    let columns = formulas.iter().map(|formula| (formula.name.replace(",", ""), "1"));
    let ratios = |row: usize| formulas.iter().map(move |formula| formula.ratios[row].1);
    let rows =
        formulas[0].points().enumerate().map(|(row, (slots, _))| [slots].into_iter().chain(ratios(row)).collect());
    Series::of_columns([("N".to_owned(), "1")].into_iter().chain(columns), rows.collect())
}

fn words(formulas: &[WrongFormula], [first, last]: [f64; 2]) -> Words {
    let said = |somewhere: bool| {
        let of_panel = formulas.iter().filter(|formula| formula.is_right_somewhere() == somewhere);
        let each = of_panel.map(|formula| {
            let [(from, least), (to, most)] = [formula.ratios[0], formula.ratios[formula.ratios.len() - 1]];
            format!("{}: {} at {from} to {} at {to}", formula.name, short(least, 2), short(most, 2))
        });
        each.collect::<Vec<_>>().join("; ")
    };
    let right = right_at(formulas);
    Words::new(
        "wrong-formulas",
        format!(
            "What wrong formulas give over what is right, {} to {} slots",
            format_trimmed(first, 0),
            format_trimmed(last, 0)
        ),
        format!(
            "Two panels with the same axes; the vertical axis is logarithmic. Above, formulas whose rows of points cross the \
             line of one at {right} slots. {}. Below, formulas whose rows do not meet this line at any number of slots. {}.",
            said(true),
            said(false)
        ),
        format!(
            "The value that each formula gives, divided by the right value. A formula is right where its curve meets \
             the thin line. The formulas in the upper panel are right for {right} slots and wrong for more or fewer. \
             The formulas in the lower panel are not right for any number of slots."
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_drawn, assert_sound};

    fn compared(name: &str, ratio: fn(f64) -> f64) -> WrongFormula {
        let ratios = (3..=12).map(|slots| (slots, ratio(f64::from(slots)))).collect();
        WrongFormula { name: name.to_owned(), ratios }
    }

    #[test]
    fn what_is_right_somewhere_stands_above_and_crosses_the_line() {
        let all = [compared("a move", |n| 2.0 / (n - 2.0)), compared("a size", |n| 1.5 + 0.1 * n)];
        let figure = wrong_formulas(&all);
        assert_sound(&figure);
        assert_eq!(figure.series.rows.len(), 10);
        assert_eq!(figure.series.rows[1], [4.0, 1.0, 1.9]);
        let drawing = ParsedDrawing::parse(&figure);
        let line = drawing.elements("right");
        assert_eq!((line.len(), drawing.elements("curve").len()), (2, 2));
        let (above, upper, lower) = (drawing.path("right", 0)[0].y, drawing.path("curve", 0), drawing.path("curve", 1));
        // Three slots above the line, four on it, five below.
        assert!(upper[0].y < above - 5.0 && upper[2].y > above + 5.0, "{upper:?}");
        assert!((upper[1].y - above).abs() < 0.1, "{upper:?}");
        let below = drawing.path("right", 1)[0].y;
        assert!(below > above && lower.iter().all(|point| point.y < below && point.y > above), "{lower:?}");
    }

    #[test]
    fn formulas_that_are_far_off_are_drawn() {
        for formula in [compared("far", |n| 1e6 * n), compared("near", |_| 1.0)] {
            assert_drawn(&wrong_formulas(&[formula]));
        }
    }
}
