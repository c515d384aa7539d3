//! Lines of equal value on a grid whose columns may have different heights.

use std::collections::BTreeMap;

/// Values on a grid: columns at rising x, each with as many nodes at rising y. A value may be missing: not a number.
#[derive(Clone, Debug)]
pub(super) struct ContourGrid {
    /// x of each column.
    pub columns: Vec<f64>,
    /// y of each node, column by column.
    pub heights: Vec<Vec<f64>>,
    /// The value at each node, column by column.
    pub values: Vec<Vec<f64>>,
}

/// An edge of the grid: column and row of its lower left end, and whether it goes upwards.
type Edge = (usize, usize, bool);

impl ContourGrid {
    fn node(&self, column: usize, row: usize) -> Option<[f64; 3]> {
        let value = *self.values.get(column)?.get(row)?;
        let node = [*self.columns.get(column)?, *self.heights.get(column)?.get(row)?, value];
        value.is_finite().then_some(node)
    }

    /// Where the value is this on an edge, if it is between its ends: by a straight line between them.
    fn crossing(&self, (column, row, up): Edge, level: f64) -> Option<(f64, f64)> {
        let from = self.node(column, row)?;
        let to = if up { self.node(column, row + 1)? } else { self.node(column + 1, row)? };
        if (from[2] < level) == (to[2] < level) {
            return None;
        }
        let share = (level - from[2]) / (to[2] - from[2]);
        Some((from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])))
    }

    /// Where in each column the value is greatest, if that is not at an end: by a parabola through three nodes.
    pub(super) fn ridge(&self) -> Vec<(f64, f64)> {
        let greatest = |((x, heights), values): ((&f64, &Vec<f64>), &Vec<f64>)| {
            let row = (0..values.len()).reduce(|best, row| if values[row] > values[best] { row } else { best })?;
            let (below, above) = (row.checked_sub(1)?, row + 1);
            let [a, b, c] = [*values.get(below)?, *values.get(row)?, *values.get(above)?];
            let shift = 0.5 * (a - c) / (a - 2.0 * b + c);
            let height = heights.get(row)? + shift * (heights.get(above)? - heights.get(row)?);
            shift.is_finite().then_some((*x, height))
        };
        self.columns.iter().zip(&self.heights).zip(&self.values).filter_map(greatest).collect()
    }

    /// The lines on which the value is this, each from one end to the other or round to its start.
    pub(super) fn lines(&self, level: f64) -> Vec<Vec<(f64, f64)>> {
        let mut next: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
        for column in 0..self.columns.len().saturating_sub(1) {
            for row in 0..self.heights.get(column).map_or(0, |column| column.len().saturating_sub(1)) {
                let edges =
                    [(column, row, false), (column + 1, row, true), (column, row + 1, false), (column, row, true)];
                let crossed: Vec<Edge> =
                    edges.into_iter().filter(|edge| self.crossing(*edge, level).is_some()).collect();
                // With four crossings two lines pass; either pairing is as good on a fine grid.
                for pair in crossed.chunks_exact(2) {
                    next.entry(pair[0]).or_default().push(pair[1]);
                    next.entry(pair[1]).or_default().push(pair[0]);
                }
            }
        }
        let ends: Vec<Edge> = next.iter().filter(|(_, to)| to.len() == 1).map(|(edge, _)| *edge).collect();
        let all: Vec<Edge> = next.keys().copied().collect();
        let mut lines = Vec::new();
        for start in ends.into_iter().chain(all) {
            let mut line = Vec::new();
            let mut at = Some(start);
            while let Some(edge) = at {
                let Some(neighbours) = next.remove(&edge) else { break };
                line.extend(self.crossing(edge, level));
                at = neighbours.into_iter().find(|to| next.contains_key(to));
            }
            if line.len() > 1 {
                lines.push(line);
            }
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(value: fn(f64, f64) -> f64) -> ContourGrid {
        let columns: Vec<f64> = (-20..=20).map(|k| f64::from(k) / 10.0).collect();
        // Columns of different heights.
        let height = |x: f64, k: u32| -2.0 - 0.1 * x + (4.0 + 0.3 * x) * f64::from(k) / 40.0;
        let heights: Vec<Vec<f64>> = columns.iter().map(|x| (0..=40).map(|k| height(*x, k)).collect()).collect();
        let values = columns.iter().zip(&heights).map(|(x, ys)| ys.iter().map(|y| value(*x, *y)).collect());
        ContourGrid { columns: columns.clone(), heights: heights.clone(), values: values.collect() }
    }

    #[test]
    fn a_circle_is_one_closed_line() {
        let lines = grid(|x, y| x * x + y * y).lines(1.0);
        assert_eq!(lines.len(), 1);
        assert!(lines[0].len() > 60);
        assert!(lines[0].iter().all(|(x, y)| (x * x + y * y - 1.0).abs() < 0.01));
        let turn: f64 = lines[0].windows(2).map(|pair| pair[0].0 * pair[1].1 - pair[0].1 * pair[1].0).sum();
        assert!((turn.abs() - std::f64::consts::TAU).abs() < 0.2, "{turn}");
    }

    #[test]
    fn the_ridge_is_where_columns_are_highest() {
        let ridge = grid(|x, y| 1.0 - (y - 0.3 * x) * (y - 0.3 * x)).ridge();
        assert_eq!(ridge.len(), 41);
        assert!(ridge.iter().all(|(x, y)| (y - 0.3 * x).abs() < 1e-9));
        assert!(grid(|_, y| y).ridge().is_empty());
    }

    #[test]
    fn lines_end_where_values_are_missing() {
        let lines = grid(|x, y| if x * x < 1.0 { f64::NAN } else { y }).lines(0.05);
        assert_eq!(lines.len(), 2);
        assert!(lines.iter().flatten().all(|(x, y)| x.abs() >= 1.0 && (y - 0.05).abs() < 1e-12));
        assert!(grid(|x, _| x).lines(9.0).is_empty());
    }
}
