//! Axes: what they cover, how their values are spaced, where the ticks are and how they are numbered.

use crate::number::{format_fixed, format_trimmed, power, power_of_ten, round_step, with_minus_sign};
use crate::svg::Label;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// How far beyond the greatest value an axis from zero goes at least.
const HEADROOM: f64 = 1.04;
/// Round steps from zero to either end of a symmetric axis, and how far beyond the greatest value it goes at least.
const SYMMETRIC: i32 = 3;
const SYMMETRIC_HEADROOM: f64 = 1.05;
/// How far beyond an axis a value can lie, in lengths of the axis: enough for any line to leave the frame.
const FAR: f64 = 50.0;

/// Steps of an axis that have a tick each.
const MOST_TICKS: usize = 100;

/// How the values of an axis are spaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AxisScale {
    /// Equal differences, equal lengths.
    Linear,
    /// Equal ratios, equal lengths; only for values above zero.
    Logarithmic,
    /// Logarithmic, with ticks at powers of ten that are written as such.
    Decades,
    /// Linear from −1 to 1, logarithmic beyond on either side; a decade is as long as a unit.
    SymmetricLog,
}

/// How far from zero a value lies on a symmetric logarithmic scale, in decades.
fn signed_decades(value: f64) -> f64 {
    let size = value.abs();
    if size <= 1.0 { value } else { (1.0 + libm::log10(size)).copysign(value) }
}

/// One axis: what it covers, the ticks on it, and its title.
#[derive(Clone, Debug)]
pub(crate) struct ChartAxis {
    /// From the least to the greatest value.
    pub range: Range<f64>,
    /// Where the ticks are.
    pub ticks: Vec<f64>,
    /// Digits after the point of the ticks' numbers; at most so many where the scale is logarithmic.
    pub decimals: usize,
    /// How its values are spaced.
    pub scale: AxisScale,
    /// What it shows, with the unit.
    pub title: Option<Label>,
    /// What is written at the ticks instead of their numbers.
    pub names: Vec<String>,
    /// Whether the ticks have numbers, and lines across the frame.
    pub numbered: bool,
    pub grid: bool,
}

impl ChartAxis {
    /// An axis with these ticks, numbered with so many digits after the point.
    pub(crate) fn new(scale: AxisScale, range: Range<f64>, ticks: Vec<f64>, decimals: usize) -> Self {
        Self { range, ticks, decimals, scale, title: None, names: Vec::new(), numbered: true, grid: true }
    }

    /// A linear axis with ticks at whole numbers.
    pub(crate) fn whole(range: Range<f64>, ticks: impl IntoIterator<Item = f64>) -> Self {
        Self::new(AxisScale::Linear, range, ticks.into_iter().collect(), 0)
    }

    /// An axis with a strip for each of several kinds, the first at the top: around 1, around 2, and so on.
    pub(crate) fn of_kinds(names: impl IntoIterator<Item = String>) -> Self {
        let names: Vec<String> = names.into_iter().collect();
        let count = names.len().max(1);
        let ticks = (1..=names.len()).map(|number| number as f64);
        Self { names, ..Self::whole(count as f64 + 0.5..0.5, ticks) }.without_grid()
    }

    /// A symmetric logarithmic axis, with ticks at zero and at powers of ten to either side.
    pub(crate) fn symmetric_log(limit: f64) -> Self {
        let powers: Vec<f64> = (0..20).map(power).take_while(|tick| *tick <= limit).collect();
        let below = powers.iter().rev().map(|tick| -tick);
        let ticks = below.chain(std::iter::once(0.0)).chain(powers.iter().copied()).collect();
        Self::new(AxisScale::SymmetricLog, -limit..limit, ticks, 0)
    }

    /// An axis in at least so many round steps that holds zero and both values, with some room beyond them.
    pub(crate) fn from_zero(least: f64, greatest: f64, steps: f64) -> Self {
        Self::in_steps(round_step(HEADROOM * (greatest - least) / steps), HEADROOM * least, HEADROOM * greatest)
    }

    /// An axis of angles in degrees, in at least so many steps that divide a turn, which holds zero and both values.
    pub(crate) fn of_angles(least: f64, greatest: f64, steps: f64) -> Self {
        let wanted = (greatest - least) / steps;
        let step = [1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 90.0].into_iter().find(|step| *step >= wanted);
        Self::in_steps(step.unwrap_or(120.0), least, greatest)
    }

    /// An axis in at least so many round steps that holds both values, and zero only if it must. The values differ by a
    /// millionth of their size or more.
    pub(crate) fn spanning(least: f64, greatest: f64, steps: f64) -> Self {
        let step = round_step((greatest - least) / steps);
        let low = libm::floor(least / step + 1e-9) as i32;
        let high = (libm::ceil(greatest / step - 1e-9) as i32).max(low.saturating_add(1));
        Self::stepped(step, low, high)
    }

    /// An axis from −3 to 3 round steps that holds a value of this size: zero is at one height on any two of them.
    pub(crate) fn symmetric(greatest: f64) -> Self {
        Self::stepped(round_step(SYMMETRIC_HEADROOM * greatest / f64::from(SYMMETRIC)), -SYMMETRIC, SYMMETRIC)
    }

    /// Driver angles in degrees over an engagement of this half angle, with ticks in so many parts of it.
    pub(crate) fn of_engagement(half: f64, parts: i32) -> Self {
        Self::whole(-half..half, (-parts..=parts).map(|k| half * f64::from(k) / f64::from(parts)))
    }

    /// Whole powers of ten that hold all values of the range, with a tick at each so many.
    pub(crate) fn decades(least: f64, greatest: f64, each: usize) -> Self {
        let low = (-20..20).rev().find(|k| power(*k) <= least).unwrap_or(-20);
        let high = (low + 1..21).find(|k| power(*k) >= greatest).unwrap_or(20);
        let ticks = (low..=high).rev().step_by(each).map(power).collect();
        Self::new(AxisScale::Decades, power(low)..power(high), ticks, 0)
    }

    /// A logarithmic axis over a range, with ticks at 1, 2 and 5 times powers of ten; at powers of ten alone if those
    /// are too many.
    pub(crate) fn logarithmic(range: Range<f64>) -> Self {
        let within = |tick: &f64| (range.start..=range.end).contains(tick);
        let ticks: Vec<f64> = one_two_five().filter(within).collect();
        let wide = ticks.len() > 9;
        let ticks = if wide { (-20..20).map(power).filter(within).collect() } else { ticks };
        Self::new(AxisScale::Logarithmic, range, ticks, 9)
    }

    /// A logarithmic axis over whole steps of 1, 2 and 5 times powers of ten that holds all values of the range.
    pub(crate) fn logarithmic_about(values: Range<f64>) -> Self {
        let low = one_two_five().filter(|step| *step <= values.start).fold(1e-9, f64::max);
        let high = one_two_five().find(|step| *step >= values.end && *step > low).unwrap_or(10.0 * low);
        Self::logarithmic(low..high)
    }

    /// Gives the axis a title.
    pub(crate) fn titled(self, title: Label) -> Self {
        Self { title: Some(title), ..self }
    }

    /// Leaves out the axis's numbers.
    pub(crate) fn unnumbered(self) -> Self {
        Self { numbered: false, ..self }
    }

    /// Leaves out the axis's lines across the frame.
    pub(crate) fn without_grid(self) -> Self {
        Self { grid: false, ..self }
    }

    /// An axis of these values without ticks and title: for a side of the frame that is not read.
    pub(crate) fn blank(&self) -> Self {
        Self { ticks: Vec::new(), title: None, ..self.clone() }
    }

    fn in_steps(step: f64, least: f64, greatest: f64) -> Self {
        let low = libm::floor(least / step + 1e-9).min(0.0) as i32;
        let high = (libm::ceil(greatest / step - 1e-9) as i32).max(low.saturating_add(1));
        Self::stepped(step, low, high)
    }

    /// An axis from one multiple of a step to another, with a tick at each, or at each so many if there are too many.
    fn stepped(step: f64, low: i32, high: i32) -> Self {
        let digits = format_trimmed(step, 6);
        let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
        let each = usize::try_from(i64::from(high) - i64::from(low)).map_or(1, |steps| steps / MOST_TICKS + 1);
        let ticks = (low..=high).step_by(each).map(|k| step * f64::from(k)).collect();
        Self::new(AxisScale::Linear, step * f64::from(low)..step * f64::from(high), ticks, decimals)
    }

    /// How far along the axis a value lies: 0 at its start, 1 at its end.
    pub(crate) fn share(&self, value: f64) -> f64 {
        let Range { start, end } = self.range;
        let share = match self.scale {
            AxisScale::Linear => (value - start) / (end - start),
            AxisScale::Logarithmic | AxisScale::Decades => libm::log(value / start) / libm::log(end / start),
            AxisScale::SymmetricLog => {
                let [value, start, end] = [value, start, end].map(signed_decades);
                (value - start) / (end - start)
            }
        };
        share.clamp(-FAR, FAR)
    }

    /// The value so far along the axis.
    pub(crate) fn value_at(&self, share: f64) -> f64 {
        let Range { start, end } = self.range;
        match self.scale {
            AxisScale::Linear => start + share * (end - start),
            AxisScale::Logarithmic | AxisScale::Decades => start * libm::exp(share * libm::log(end / start)),
            AxisScale::SymmetricLog => {
                let [start, end] = [start, end].map(signed_decades);
                let decades = start + share * (end - start);
                let size = decades.abs();
                if size <= 1.0 { decades } else { libm::exp10(size - 1.0).copysign(decades) }
            }
        }
    }

    /// A tick's number as it is written.
    pub(crate) fn tick_label(&self, value: f64) -> String {
        let named = self.ticks.iter().position(|tick| *tick == value).and_then(|number| self.names.get(number));
        match self.scale {
            _ if !self.numbered => String::new(),
            _ if named.is_some() => named.cloned().unwrap_or_default(),
            AxisScale::Linear | AxisScale::SymmetricLog => with_minus_sign(&format_fixed(value, self.decimals)),
            AxisScale::Logarithmic => with_minus_sign(&format_trimmed(value, self.decimals)),
            AxisScale::Decades => power_of_ten(value),
        }
    }

    /// Whether the ticks of a linear axis can be read: no number is wider than `room`, in pixels, or off its tick by
    /// more than a thousandth of a step.
    pub(crate) fn is_readable(&self, room: f64) -> bool {
        let step = self.ticks.get(1).zip(self.ticks.first()).map_or(0.0, |(second, first)| second - first);
        self.ticks.iter().all(|tick| {
            let read = format_fixed(*tick, self.decimals).parse().unwrap_or(f64::INFINITY);
            (read - tick).abs() <= 1e-3 * step && Label::words(&self.tick_label(*tick)).width() <= room
        })
    }
}

fn one_two_five() -> impl Iterator<Item = f64> {
    (-9..9).flat_map(|k| [1.0, 2.0, 5.0].map(|m| m * power(k)))
}

impl Ranged for ChartAxis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        limit.0 + libm::round(self.share(*value) * f64::from(limit.1 - limit.0)) as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for ChartAxis {
    fn format_ext(&self, value: &f64) -> String {
        self.tick_label(*value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_axis_holds_its_values_between_its_ends() {
        for (least, greatest) in [(-0.3, 7.1), (0.0, 1e-4), (-250.0, 3.0), (2.0, 2.5)] {
            for axis in [ChartAxis::from_zero(least, greatest, 4.0), ChartAxis::spanning(least, greatest, 5.0)] {
                assert!([least, greatest].iter().all(|value| (-1e-9..=1.0 + 1e-9).contains(&axis.share(*value))));
                assert!(axis.ticks.len() >= 4, "{axis:?}");
            }
            assert!(ChartAxis::from_zero(least, greatest, 4.0).ticks.contains(&0.0));
        }
        for axis in [ChartAxis::decades(0.03, 40.0, 1), ChartAxis::logarithmic_about(0.03..40.0)] {
            assert!(axis.share(0.03) >= 0.0 && axis.share(40.0) <= 1.0, "{axis:?}");
            assert!((axis.share(4.0) - axis.share(0.4) - axis.share(0.4) + axis.share(0.04)).abs() < 1e-12);
        }
        assert_eq!(ChartAxis::symmetric(2.9).ticks, [-6.0, -4.0, -2.0, 0.0, 2.0, 4.0, 6.0]);
        assert_eq!(ChartAxis::of_angles(-27.0, 27.0, 4.0).range, -30.0..30.0);
    }

    #[test]
    fn no_axis_has_more_marks_than_a_page_can_show() {
        for (least, greatest) in [(1e300, 2e300), (-1e154, 1e154), (0.0, f64::INFINITY), (1.0, 1.0 + 1e-12), (0.0, 1e9)]
        {
            let spanning = ChartAxis::spanning(least, greatest, 5.0);
            for axis in
                [ChartAxis::from_zero(least, greatest, 4.0), ChartAxis::of_angles(least, greatest, 4.0), spanning]
            {
                assert!(axis.ticks.len() <= MOST_TICKS + 1, "{least} {greatest}: {} ticks", axis.ticks.len());
            }
        }
    }

    #[test]
    fn the_value_at_a_share_has_that_share() {
        for scale in [AxisScale::Linear, AxisScale::Logarithmic, AxisScale::Decades, AxisScale::SymmetricLog] {
            let axis = ChartAxis::new(scale, 0.1..30.0, vec![], 1);
            assert!([0.0, 0.3, 1.0].iter().all(|share| (axis.share(axis.value_at(*share)) - share).abs() < 1e-12));
        }
    }

    #[test]
    fn a_symmetric_log_axis_is_linear_within_one_and_a_decade_is_as_long_as_a_unit() {
        let axis = ChartAxis::symmetric_log(100.0);
        assert_eq!(axis.ticks, [-100.0, -10.0, -1.0, 0.0, 1.0, 10.0, 100.0]);
        let shares = [0.0, 0.5, 1.0, 10.0, 100.0].map(|value| axis.share(value));
        for (share, expected) in shares.into_iter().zip([3.0, 3.5, 4.0, 5.0, 6.0]) {
            assert!((share - expected / 6.0).abs() < 1e-12, "{shares:?}");
        }
        assert!([0.25, 3.0, 70.0].iter().all(|value| (axis.share(*value) + axis.share(-value) - 1.0).abs() < 1e-12));
    }

    #[test]
    fn kinds_are_written_by_name_and_the_first_is_at_the_top() {
        let axis = ChartAxis::of_kinds(["six", "four"].map(str::to_owned));
        assert_eq!([1.0, 2.0].map(|tick| axis.tick_label(tick)), ["six", "four"]);
        assert_eq!([axis.share(1.0), axis.share(2.0)], [0.75, 0.25]);
    }

    #[test]
    fn marks_are_written_as_their_scale_wants() {
        let axis = |scale| ChartAxis::new(scale, 0.1..100.0, vec![], 1);
        let written =
            [AxisScale::Linear, AxisScale::Logarithmic, AxisScale::Decades].map(|scale| axis(scale).tick_label(10.0));
        assert_eq!(written, ["10.0", "10", "10¹"]);
        assert_eq!(axis(AxisScale::Linear).tick_label(-10.0), "−10.0");
        assert_eq!(axis(AxisScale::Linear).unnumbered().tick_label(10.0), "");
    }
}
