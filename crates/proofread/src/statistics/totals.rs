//! Totals and shares in a table beside the parts that they are made of.
//!
//! A row that is called *total* is often no sum: it may be a mean, or have parts that the table leaves out. So a total counts as wrong
//! only where other totals of its row or column are sums of their parts, or where one digit explains the difference.

use super::scanner::PrintedNumber;
use super::share::is_share;
use super::table::{TableCell, TextTable};
use super::{Outcome, StatisticDifference, statistic_finding};
use crate::judge::doubt::Doubt;
use crate::tell::finding::ChainFinding;
use crate::token::Span;

/// Compares the totals of a table with their parts; how many there are.
pub(super) fn check(table: &TextTable, findings: &mut Vec<ChainFinding>) -> usize {
    let width = table.width();
    if table.rows.len() < 3 || width < 2 {
        return 0;
    }
    let rows: Vec<usize> =
        (1..table.rows.len()).filter(|row| row_label(table, *row).is_some_and(|of| is_total(&of, true))).collect();
    let header = header_rows(table);
    let columns: Vec<usize> = (1..width).filter(|column| is_total(&heading(table, header, *column), false)).collect();
    if rows.is_empty() && columns.is_empty() || rows.len() > MOST_TOTALS || columns.len() > MOST_TOTALS {
        return 0;
    }
    let (mut checked, mut found) = (0, Vec::new());
    let out = &mut found;
    for row in &rows {
        checked += check_row(table, *row, &rows, header, out);
    }
    for column in &columns {
        checked += check_column(table, *column, &columns, header, out);
    }
    let totals = TableTotals { table, rows: &rows, columns: &columns, header };
    checked += totals.check_shares_in_cells(out) + totals.check_share_columns(out);
    // A wrong cell spoils each total of which it is a part, and has one finding itself.
    let spoiled = |of: &TableFinding| {
        found.iter().any(|other| other.finding.at != of.finding.at && of.parts.contains(&other.finding.at))
    };
    let mut kept: Vec<ChainFinding> = Vec::new();
    for of in &found {
        if !spoiled(of) && kept.iter().all(|kept| kept.at != of.finding.at) {
            kept.push(of.finding.clone());
        }
    }
    findings.extend(kept);
    checked
}

/// A finding with the cells of the parts.
struct TableFinding {
    finding: ChainFinding,
    parts: Vec<Span>,
}

/// Most rows or columns of a table that are called a total.
const MOST_TOTALS: usize = 60;

fn is_total(label: &str, in_row: bool) -> bool {
    let label = label.to_lowercase();
    let label = label.trim_matches(|c: char| !c.is_alphanumeric() && c != 'σ');
    let first = label.split(|c: char| !c.is_alphanumeric() && c != 'σ' && c != '-').next().unwrap_or_default();
    let alone = [
        "total",
        "totals",
        "sum",
        "all",
        "overall",
        "subtotal",
        "sub-total",
        "σ",
        "gesamt",
        "summe",
        "row total",
        "row totals",
        "column total",
        "column totals",
        "grand total",
        "total n",
        "total (n)",
    ];
    alone.contains(&label)
        || (in_row
            && ["total", "subtotal", "sub-total", "totals"].contains(&first)
            && label.split_whitespace().count() <= 4)
}

/// The label of a row: the text of its first cell that has any, before its numbers.
fn row_label(table: &TextTable, row: usize) -> Option<String> {
    let cell = table.rows.get(row)?.iter().take(2).find(|cell| !cell.text.trim().is_empty())?;
    cell.number.is_none().then(|| cell.text.clone())
}

/// How many rows at the top have no numbers behind their first cell; at least one.
fn header_rows(table: &TextTable) -> usize {
    let has_numbers = |row: &Vec<TableCell>| row.iter().skip(1).any(|cell| cell.number.is_some());
    table.rows.iter().take_while(|row| !has_numbers(row)).count().clamp(1, 4)
}

fn heading(table: &TextTable, header: usize, column: usize) -> String {
    let cells = (0..header).filter_map(|row| table.cell(row, column)).map(|cell| cell.text.trim());
    cells.filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" ")
}

/// Parts and their total.
struct Sum<'t> {
    parts: Vec<&'t TableCell>,
    total: &'t TableCell,
}

/// How a total compares with its parts.
#[derive(Clone, Copy, Debug, PartialEq)]
enum SumVerdict {
    Fits,
    /// It differs by this much, and is no mean of its parts.
    Differs(f64),
    /// It differs by this much, and may be a mean of its parts.
    MayBeMean(f64),
    /// It is no sum, or its parts are not all known.
    NoSum,
}

impl<'t> Sum<'t> {
    /// The sum of cells, if each of them is a number or empty and at least two are numbers.
    fn new(parts: impl Iterator<Item = &'t TableCell>, total: &'t TableCell) -> Option<Self> {
        let mut numbers = Vec::new();
        for cell in parts {
            match cell.number {
                Some(_) => numbers.push(cell),
                None if cell.is_empty() => {}
                None => return None,
            }
        }
        // Some parts may have no unit beside a total that has one, but none may have another one.
        let has_unit_of = |cell: &&TableCell| cell.unit.is_empty() || cell.unit == total.unit;
        let is_of_one_unit = numbers.iter().all(has_unit_of);
        (numbers.len() >= 2 && is_of_one_unit).then_some(Self { parts: numbers, total })
    }

    fn numbers(&self) -> impl Iterator<Item = PrintedNumber> {
        self.parts.iter().filter_map(|cell| cell.number)
    }

    fn computed(&self) -> f64 {
        self.numbers().map(|number| number.value).sum()
    }

    fn verdict(&self, in_percent: bool) -> SumVerdict {
        let Some(total) = self.total.number else { return SumVerdict::NoSum };
        let is_hundred = in_percent && (total.value - 100.0).abs() <= 1.0;
        if in_percent && !is_hundred {
            return SumVerdict::NoSum;
        }
        let computed = self.computed();
        // Counts are exact, and so are whole numbers unless they are rounded to something large.
        let largest = self.numbers().map(|number| number.value.abs()).fold(0.0, f64::max);
        let is_exact = |number: PrintedNumber| number.is_whole() && !in_percent && largest < ROUNDED_FROM;
        let open: f64 = self.numbers().filter(|number| !is_exact(*number)).map(|number| number.half).sum();
        let own = if is_exact(total) { 0.0 } else { total.half };
        let difference = total.value - computed;
        if difference.abs() <= (open + own) * (1.0 + 1e-9) + 1e-9 * largest {
            return SumVerdict::Fits;
        }
        // Of bits, the carry and the sum are no total.
        let is_bit = |number: PrintedNumber| matches!(number.value, 0.0 | 1.0);
        if is_bit(total) && self.numbers().all(is_bit) {
            return SumVerdict::NoSum;
        }
        // A mean is between its parts.
        if self.numbers().all(|number| number.value >= 0.0) && total.value <= largest {
            return SumVerdict::MayBeMean(difference);
        }
        SumVerdict::Differs(difference)
    }

    /// The total and its difference in units of the last printed digit.
    fn in_units(&self, difference: f64) -> [f64; 2] {
        let total = self.total.number.map_or(0.0, |total| total.value);
        let decimals = self.numbers().chain(self.total.number).map(|number| number.decimals).max().unwrap_or_default();
        let scale = libm::pow(10.0, decimals as f64);
        [total.abs() * scale, libm::round(difference.abs() * scale)]
    }

    /// Whether one digit of the total or of a part, or two that are swapped, explain the difference.
    fn is_one_digit(&self, difference: f64) -> bool {
        let [_, mut units] = self.in_units(difference);
        while units >= 10.0 && units % 10.0 == 0.0 {
            units /= 10.0;
        }
        units < 10.0 || (units < 100.0 && units % 9.0 == 0.0)
    }

    /// Whether one digit explains the difference, and the numbers are long enough for that to say something.
    fn is_slip(&self, difference: f64) -> bool {
        let [total, units] = self.in_units(difference);
        self.is_one_digit(difference) && total.max(units) >= 100.0
    }

    /// Whether the total leaves one of its parts or a run of them out, as where some are parts of others.
    fn is_hierarchical(&self, difference: f64) -> bool {
        /// Most parts of which all runs are looked at.
        const MOST: usize = 60;
        let values: Vec<f64> = self.numbers().map(|number| number.value).collect();
        if values.len() > MOST {
            return true;
        }
        let slack = 1e-6 * difference.abs();
        (0..values.len()).any(|from| {
            let mut run = 0.0;
            values[from..].iter().any(|value| {
                run += value;
                (run + difference).abs() <= slack
            })
        })
    }

    fn finding(&self, outcome: Outcome, heading: &str, row: &str) -> TableFinding {
        const MOST_SHOWN: usize = 12;
        let shown = |cell: &TableCell| cell.text.clone();
        let mut parts: Vec<String> = self.parts.iter().take(MOST_SHOWN).map(|cell| shown(cell)).collect();
        if self.parts.len() > MOST_SHOWN {
            parts.push("…".to_owned());
        }
        // The note of a part may say that it is not all of this sum.
        let is_noted = self.parts.iter().any(|cell| cell.text.contains(['*', '†', '‡', '§']));
        let outcome = if is_noted { Outcome::Doubt(Doubt::OtherParts) } else { outcome };
        let left = parts.join(" + ");
        let right = self.total.text.clone();
        let decimals = self.numbers().map(|number| number.decimals).max().unwrap_or_default();
        let chain = format!("{left} = {right}");
        let marked = chain.len() - right.len()..chain.len();
        let spans = self.parts.iter().map(|cell| cell.at).reduce(|a, b| a.join(b)).unwrap_or(self.total.at);
        let place =
            [row.trim(), heading.trim()].into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(", ");
        let finding = statistic_finding(StatisticDifference {
            chain,
            marked,
            left,
            right,
            spans: [spans, self.total.at, spans.join(self.total.at)],
            recomputed: format!("{:.decimals$}", self.computed()).replace('-', "−"),
            why: Some(format!("the parts do not add up to the total ({place})")),
            outcome,
        });
        TableFinding { finding, parts: self.parts.iter().map(|cell| cell.at).collect() }
    }
}

/// Whole numbers from here on may be rounded, as in a table in thousands.
const ROUNDED_FROM: f64 = 10_000.0;

fn check_row(table: &TextTable, row: usize, totals: &[usize], header: usize, out: &mut Vec<TableFinding>) -> usize {
    let before: Vec<usize> = totals.iter().copied().filter(|total| *total < row).collect();
    let last = before.last().copied();
    let heads = |at: &usize| !table.rows[*at].iter().skip(1).any(|cell| cell.number.is_some());
    let segment_start =
        (header..row).rev().find(|at| heads(at)).map_or(header, |at| at + 1).max(last.map_or(header, |at| at + 1));
    let next = totals.iter().copied().find(|total| *total > row).unwrap_or(table.rows.len());
    let plain = |range: std::ops::Range<usize>| range.filter(|at| !totals.contains(at)).collect::<Vec<_>>();
    let mut with_subtotals = before.clone();
    with_subtotals.extend(last.map_or(header, |at| at + 1)..row);
    let since_subtotal: Vec<usize> = last.into_iter().chain(last.map_or(header, |at| at + 1)..row).collect();
    let candidates = [
        plain(segment_start..row),
        plain(header..row),
        with_subtotals,
        since_subtotal,
        plain(row + 1..next),
        plain(row + 1..table.rows.len()),
        plain(0..row),
    ];
    let label = row_label(table, row).unwrap_or_default();
    let (mut fits, mut differing) = (0, Vec::new());
    for column in 1..table.rows[row].len() {
        let Some(total) = table.cell(row, column).filter(|cell| cell.number.is_some()) else { continue };
        let heading = heading(table, header, column);
        let lower = heading.to_lowercase();
        if MEANS.iter().any(|word| lower.split(|c: char| !c.is_alphanumeric()).any(|of| of == *word)) {
            continue;
        }
        let in_percent =
            total.is_percent || heading.contains('%') && total.share.is_none() || lower.contains("percent");
        let sums =
            candidates.iter().filter_map(|rows| Sum::new(rows.iter().filter_map(|at| table.cell(*at, column)), total));
        let judged: Vec<(Sum<'_>, SumVerdict)> =
            sums.map(|sum| (sum.verdict(in_percent), sum)).map(|(a, b)| (b, a)).collect();
        if judged.iter().any(|(_, verdict)| *verdict == SumVerdict::Fits) {
            fits += 1;
            continue;
        }
        let nearest = judged.into_iter().filter_map(|(sum, verdict)| match verdict {
            SumVerdict::Differs(by) => Some((sum, by, false)),
            SumVerdict::MayBeMean(by) => Some((sum, by, true)),
            _ => None,
        });
        let nearest = nearest.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        differing.extend(nearest.map(|(sum, by, is_mean)| (sum, by, is_mean, heading)));
    }
    // Where two others are sums and one digit explains it, it is no mean.
    differing.retain(|(sum, by, is_mean, _)| !is_mean || (fits > 1 && sum.is_slip(*by)));
    let count = fits + differing.len();
    let several = differing.len();
    for (sum, by, _, heading) in differing {
        let is_near = by.abs() <= NEAR * sum.computed().abs();
        let is_sum_row = fits >= several && fits > 0;
        let is_slip_in_sum = is_sum_row && (fits > 1 && sum.is_one_digit(by) || is_near && sum.is_slip(by));
        let is_lone_slip = fits == 0 && several == 1 && sum.parts.len() > 2 && is_near && sum.is_slip(by);
        let outcome = match is_near && !sum.is_hierarchical(by) {
            _ if is_slip_in_sum => Outcome::Difference,
            true if is_lone_slip => Outcome::Difference,
            true => Outcome::Doubt(Doubt::OtherParts),
            false => continue,
        };
        out.push(sum.finding(outcome, &heading, &label));
    }
    count
}

/// How far a total may be from its sum to be meant as one.
const NEAR: f64 = 0.5;

/// Headings of columns whose totals are no sums.
const MEANS: [&str; 24] = [
    "mean",
    "means",
    "average",
    "avg",
    "median",
    "sd",
    "se",
    "sem",
    "std",
    "rate",
    "ratio",
    "p",
    "f",
    "ms",
    "index",
    "probability",
    "per",
    "score",
    "odds",
    "risk",
    "variance",
    "min",
    "max",
    "correlation",
];

/// How many totals of a column fit, and those that differ, with how much and the label of their row.
type JudgedColumn<'t> = (usize, Vec<(Sum<'t>, f64, String)>);

fn check_column(
    table: &TextTable,
    column: usize,
    totals: &[usize],
    header: usize,
    out: &mut Vec<TableFinding>,
) -> usize {
    let last = totals.iter().copied().filter(|total| *total < column).max();
    let next = totals.iter().copied().find(|total| *total > column).unwrap_or(table.width());
    let plain = |range: std::ops::Range<usize>| range.filter(|at| !totals.contains(at)).collect::<Vec<_>>();
    let candidates = [
        plain(last.map_or(1, |at| at + 1)..column),
        plain(1..column),
        plain(column + 1..next),
        plain(column + 1..table.width()),
    ];
    let mut best: Option<JudgedColumn<'_>> = None;
    for columns in candidates {
        let (mut fits, mut differing, mut means) = (0, Vec::new(), Vec::new());
        for row in header..table.rows.len() {
            let Some(total) = table.cell(row, column).filter(|cell| cell.number.is_some()) else { continue };
            let Some(sum) = Sum::new(columns.iter().filter_map(|at| table.cell(row, *at)), total) else { continue };
            match sum.verdict(total.is_percent) {
                SumVerdict::Fits => fits += 1,
                SumVerdict::Differs(by) => differing.push((sum, by, row_label(table, row).unwrap_or_default())),
                SumVerdict::MayBeMean(by) if sum.is_slip(by) => {
                    means.push((sum, by, row_label(table, row).unwrap_or_default()));
                }
                SumVerdict::MayBeMean(_) | SumVerdict::NoSum => {}
            }
        }
        if fits > 1 {
            differing.append(&mut means);
        }
        if best.as_ref().is_none_or(|(most, _)| fits > *most) {
            best = Some((fits, differing));
        }
    }
    let Some((fits, differing)) = best else { return 0 };
    let count = fits + differing.len();
    let several = differing.len();
    for (sum, by, label) in differing {
        let is_near = by.abs() <= NEAR * sum.computed().abs();
        let is_slip = fits > 1 && fits >= 2 * several && sum.is_one_digit(by);
        let outcome = if is_slip || is_near && fits >= several && fits > 0 && sum.is_slip(by) {
            Outcome::Difference
        } else if is_near && fits > 0 && fits >= several {
            Outcome::Doubt(Doubt::OtherParts)
        } else {
            continue;
        };
        out.push(sum.finding(outcome, &heading(table, header, column), &label));
    }
    if fits == 0 { 0 } else { count }
}

struct TableTotals<'t> {
    table: &'t TextTable,
    rows: &'t [usize],
    columns: &'t [usize],
    header: usize,
}

impl TableTotals<'_> {
    fn total(&self, row: Option<usize>, column: Option<usize>) -> Option<f64> {
        self.table.cell(row?, column?)?.number.map(|number| number.value).filter(|value| *value > 0.0)
    }

    /// Cells such as `45 (75.0%)`: shares of the total of their row, of their column, or of all.
    fn check_shares_in_cells(&self, out: &mut Vec<TableFinding>) -> usize {
        let (row_total, column_total) = (self.rows.last().copied(), self.columns.last().copied());
        let mut cells = Vec::new();
        for (row, of) in self.table.rows.iter().enumerate().skip(self.header) {
            for (column, cell) in of.iter().enumerate().skip(1) {
                if let (Some(number), Some(share)) = (cell.number, cell.share) {
                    cells.push((row, column, cell, number, share));
                }
            }
        }
        let wholes = [
            |of: &Self, row: usize, _: usize, _: Option<usize>, column_total| of.total(Some(row), column_total),
            |of: &Self, _: usize, column: usize, row_total, _: Option<usize>| of.total(row_total, Some(column)),
            |of: &Self, _: usize, _: usize, row_total, column_total| of.total(row_total, column_total),
        ];
        let judge = wholes.map(|whole| {
            let judged = cells.iter().filter_map(|(row, column, cell, number, share)| {
                let whole = whole(self, *row, *column, row_total, column_total)?;
                Some((*cell, number.value, whole, *share, is_share(number.value, whole, *share)))
            });
            judged.collect::<Vec<_>>()
        });
        let best = judge.into_iter().max_by_key(|judged| judged.iter().filter(|of| of.4).count()).unwrap_or_default();
        report_shares(&best, out)
    }

    /// A column of counts, and one of their shares beside it.
    fn check_share_columns(&self, out: &mut Vec<TableFinding>) -> usize {
        let Some(total_row) = self.rows.last().copied() else { return 0 };
        let mut checked = 0;
        for column in 1..self.table.width().saturating_sub(1) {
            let heading = heading(self.table, self.header, column + 1).to_lowercase();
            let in_percent = heading.contains('%') || heading.contains("percent") || heading.contains("per cent");
            let Some(whole) = self.total(Some(total_row), Some(column)) else { continue };
            let pairs = (self.header..self.table.rows.len()).filter(|row| *row != total_row).filter_map(|row| {
                let (count, share) = (self.table.cell(row, column)?, self.table.cell(row, column + 1)?);
                let (number, percent) = (count.number?, share.number.filter(|_| in_percent || share.is_percent)?);
                let is_count = number.is_whole() && !count.is_percent && share.share.is_none();
                is_count.then(|| (share, number.value, whole, percent, is_share(number.value, whole, percent)))
            });
            checked += report_shares(&pairs.collect::<Vec<_>>(), out);
        }
        checked
    }
}

/// Lists the shares that differ where nearly all others agree; how many agree or differ.
fn report_shares(judged: &[(&TableCell, f64, f64, PrintedNumber, bool)], out: &mut Vec<TableFinding>) -> usize {
    let agreeing = judged.iter().filter(|of| of.4).count();
    let differing = judged.len() - agreeing;
    if agreeing < 2 || agreeing < 3 * differing {
        return 0;
    }
    for (cell, part, whole, share, _) in judged.iter().filter(|of| !of.4) {
        let decimals = share.decimals;
        let left = format!("{part} of {whole}");
        let right = cell.text.clone();
        let chain = format!("{left}: {right}");
        let marked = chain.len() - right.len()..chain.len();
        let finding = statistic_finding(StatisticDifference {
            chain,
            marked,
            left,
            right,
            spans: [cell.at; 3],
            recomputed: format!("{:.decimals$}%", 100.0 * part / whole),
            why: Some("the other shares of the table are of this whole".to_owned()),
            outcome: match share.is_cut_or_rounded_twice(100.0 * part / whole) {
                true => Outcome::Doubt(Doubt::Truncated),
                false => Outcome::Difference,
            },
        });
        out.push(TableFinding { finding, parts: Vec::new() });
    }
    judged.len()
}
