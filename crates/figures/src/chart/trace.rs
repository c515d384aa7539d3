//! A curve on the page: with no more points than can be seen.

use crate::svg::Pixels;

/// A curve's point is left out if it is no farther from the rest, in pixels.
const THIN: f64 = 0.1;

/// The points without those that lie on the line between their neighbours, but for a part of a pixel.
pub(super) fn thin_out(points: &[Pixels]) -> Vec<Pixels> {
    let mut kept: Vec<Pixels> = points.first().copied().into_iter().collect();
    let mut parts = vec![(0, points.len().saturating_sub(1))];
    while let Some((from, to)) = parts.pop() {
        let (Some(start), Some(end)) = (points.get(from), points.get(to)) else { break };
        let along = end - start;
        let off = |point: &Pixels| match along.try_normalize(1e-9) {
            Some(along) => along.perp(&(point - start)).abs(),
            None => (point - start).norm(),
        };
        let inner = points.iter().enumerate().take(to).skip(from + 1);
        let far = inner.fold((0, THIN), |far, (k, point)| if off(point) > far.1 { (k, off(point)) } else { far });
        if far.0 > 0 {
            parts.extend([(far.0, to), (from, far.0)]);
        } else if to > from {
            kept.push(*end);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_of_a_curve_is_the_curve() {
        let circle = |k: u32| crate::svg::heading(f64::from(k) / 100.0) * 200.0;
        let points: Vec<Pixels> = (0..=600).map(circle).collect();
        let kept = thin_out(&points);
        assert!(kept.len() < 150, "{}", kept.len());
        assert_eq!((kept.first(), kept.last()), (points.first(), points.last()));
        for point in &points {
            let off = |pair: &[Pixels]| {
                let along = pair[1] - pair[0];
                let share = ((point - pair[0]).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
                (pair[0] + along * share - point).norm()
            };
            assert!(kept.windows(2).map(off).fold(f64::INFINITY, f64::min) <= THIN * 1.000_001);
        }
        assert_eq!(thin_out(&points[..1]).len(), 1);
        assert!(thin_out(&[]).is_empty());
    }
}
