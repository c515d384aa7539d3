//! What the line printer wrote: tables and plots in characters.

use super::run::{DeckRun, Plot};
use core::fmt::Write;

/// Characters of a column of numbers, unless its heading is longer.
const COLUMN: usize = 15;
/// Columns and lines of a plot whose scale is chosen, and the most that one has.
const ACROSS: usize = 100;
const DOWN: usize = 50;
const MOST_DOWN: f64 = 1000.0;
/// The marks of what is plotted.
const MARKS: [char; 6] = ['*', '+', 'O', 'X', '.', '='];

/// A number as the printer wrote it: one digit, a point, five digits and an exponent of two.
fn number(value: f64) -> String {
    let text = format!("{:.5E}", value + 0.0);
    let Some((digits, exponent)) = text.split_once('E') else { return text };
    let (sign, exponent) = exponent.strip_prefix('-').map_or(('+', exponent), |rest| ('-', rest));
    format!("{digits}E{sign}{exponent:0>2}")
}

/// The print-out of a run: parameters, a table for each OUT card, and the plots.
///
/// ```
/// use geneva_mimic::language::{CardLayout, Deck, Program, RunOptions, deck_named, print_out};
///
/// let deck = Deck::read(deck_named("decay").expect("a deck of this project"), CardLayout::Free)?;
/// let runs = Program::new(&deck)?.runs(&deck.data_sets()?, &RunOptions::default())?;
/// let page = print_out(&runs[0], "DECAY");
/// assert!(page.starts_with("DECAY\n") && page.contains(&runs[0].columns[0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn print_out(run: &DeckRun, title: &str) -> String {
    let mut page = String::new();
    let _ = writeln!(page, "{title}");
    for (name, value) in &run.parameters {
        let _ = writeln!(page, "  {name} = {value}");
    }
    let mut from = 0;
    for (number_of_card, width) in run.widths.iter().enumerate() {
        let place = from..from + width;
        from = place.end;
        let names = || run.columns[place.clone()].iter().map(String::as_str);
        let heads: Vec<&str> = match run.headings.get(number_of_card) {
            Some(words) => words.iter().map(String::as_str).collect(),
            None => names().collect(),
        };
        let wide = |column: usize| heads.get(column).map_or(COLUMN, |head| COLUMN.max(head.chars().count() + 1));
        page.push('\n');
        line(&mut page, heads.iter().take(*width).enumerate().map(|(at, head)| format!("{head:>0$}", wide(at))));
        page.push('\n');
        for row in &run.rows {
            let values = row[place.clone()].iter().enumerate();
            line(&mut page, values.map(|(at, value)| format!("{:>1$}", number(*value), wide(at))));
        }
    }
    for (plot, points) in &run.plots {
        page.push('\n');
        page += &line_plot(plot, points);
    }
    if run.work.forced > 0 {
        let _ = writeln!(
            page,
            "\n{} of {} steps were as short as allowed and still missed the tolerance.",
            run.work.forced, run.work.accepted
        );
    }
    if run.longer_than_delay > 0 {
        let _ = writeln!(
            page,
            "\n{} of {} steps were longer than the delay of a TDL, which gave its latest value; DTMAX makes steps shorter.",
            run.longer_than_delay, run.work.accepted
        );
    }
    page
}

fn line(page: &mut String, cells: impl Iterator<Item = String>) {
    let text: String = cells.collect();
    page.push_str(text.trim_end());
    page.push('\n');
}

/// A plot in characters: X down the page, the others across, each with a mark of its own.
///
/// Where two of them meet, the later one is seen. A point beyond the paper is drawn at its edge.
///
/// ```
/// use geneva_mimic::language::{Plot, line_plot};
///
/// // The line Y = X, from the top left to the bottom right.
/// let plot = Plot { names: vec!["X".to_owned(), "Y".to_owned()], zero: None, scale: None };
/// let page = line_plot(&plot, &[vec![0.0, 0.0], vec![1.0, 1.0]]);
/// let stars: Vec<_> = page.lines().skip(2).filter_map(|line| line.find('*')).collect();
/// assert_eq!(stars[1] - stars[0], 100); // columns across
/// ```
pub fn line_plot(plot: &Plot, points: &[Vec<f64>]) -> String {
    let count = plot.names.len();
    let range = |k: usize| {
        let values = points.iter().filter_map(|point| point.get(k).copied());
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
    };
    // Without scales, all that is plotted across has one.
    let across =
        (1..count).map(range).fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (l, h)| (low.min(l), high.max(h)));
    let fitting = |k: usize| if k == 0 { (range(0), DOWN) } else { (across, ACROSS) };
    let choose = |k: usize| {
        let ((low, high), places) = fitting(k);
        let zero = plot.zero.as_ref().and_then(|zero| zero.get(k).copied()).unwrap_or(low);
        let span = (high - zero) / places as f64;
        let usual = if span > 0.0 && span.is_finite() { span } else { 1.0 };
        let scale = plot.scale.as_ref().and_then(|scale| scale.get(k).copied()).filter(|scale| *scale != 0.0);
        (if zero.is_finite() { zero } else { 0.0 }, scale.unwrap_or(usual))
    };
    // Once for all points: to find a range, every point is looked at.
    let scales: Vec<(f64, f64)> = (0..count).map(choose).collect();
    let chosen = |k: usize| scales[k];
    let place = |k: usize, value: f64, most: f64| {
        let (zero, scale) = chosen(k);
        libm::floor((value - zero) / scale + 0.5).clamp(0.0, most) as usize
    };
    let last = points.iter().map(|point| place(0, point[0], MOST_DOWN)).max().unwrap_or(0);
    let mut paper = vec![vec![' '; ACROSS + 1]; last + 1];
    for point in points {
        let down = place(0, point[0], MOST_DOWN);
        for k in 1..count {
            paper[down][place(k, point[k], ACROSS as f64)] = MARKS[(k - 1) % MARKS.len()];
        }
    }
    let mut page = String::new();
    for k in 1..count {
        let (zero, scale) = chosen(k);
        let _ = writeln!(
            page,
            "{} {} against {}, from {} to {}",
            MARKS[(k - 1) % MARKS.len()],
            plot.names[k],
            plot.names[0],
            number(zero),
            number(zero + scale * ACROSS as f64)
        );
    }
    let (zero, scale) = chosen(0);
    let rule = format!("{:COLUMN$} |{}|\n", "", "-".repeat(ACROSS + 1));
    page += &rule;
    for (down, cells) in paper.iter().enumerate() {
        let head = if down % 5 == 0 { number(zero + scale * down as f64) } else { String::new() };
        let cells: String = cells.iter().collect();
        let _ = writeln!(page, "{head:>COLUMN$} |{cells}|");
    }
    page + &rule
}
