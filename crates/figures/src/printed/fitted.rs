//! An axis for numbers of any size: with labels that have room beside it.

use crate::chart::ChartAxis;
use crate::number::{exponent, power, power_of_ten, whole};

/// Sizes whose numbers may be written as they are.
const USUAL: std::ops::Range<f64> = 1e-5..1e6;
/// What is smaller is drawn as zero: its steps might be no numbers.
const NOTHING: f64 = 1e-290;
/// What changes by less than this part of its size stands still.
const STILL: f64 = 1e-9;
/// Parts of its size that a range has at least, if it is to be read without an offset.
const WIDE: f64 = 1e-3;
/// Least numbers of steps that are tried.
const STEPS: [f64; 4] = [5.0, 4.0, 3.0, 2.0];

/// An axis of values less an offset over a power of ten.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    /// The axis, without a title.
    pub axis: ChartAxis,
    offset: f64,
    exponent: i32,
}

impl Fitted {
    /// An axis for these values, all finite; `room` is how wide its numbers may be, in pixels, if it has so many marks.
    ///
    /// If they are narrow enough the values are shown as they are. Else they are over a power of ten; where they are
    /// nearly equal, less a round number too.
    pub(super) fn new(values: impl Iterator<Item = f64>, room: impl Fn(usize) -> f64) -> Self {
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let size = low.abs().max(high.abs());
        let (low, high, size) = if size < NOTHING { (0.0, 0.0, 0.0) } else { (low, high, size) };
        let readable = |fitted: &Self| fitted.axis.is_readable(room(fitted.axis.ticks.len()));
        // Over its own power of ten no sum is too large.
        let own = exponent(size);
        let [from, to] = [low, high].map(|value| value / power(own));
        let span = to - from;
        // What does not change is drawn in the middle.
        let is_still = span <= STILL * size / power(own);
        let margin = match is_still {
            true if size > 0.0 => size / power(own),
            true => 1.0,
            false => 0.0,
        };
        let over = |exponent: i32, steps: f64| {
            let [from, to] = [from - margin, to + margin].map(|value| value * power(own - exponent));
            Self { axis: ChartAxis::spanning(from, to, steps), offset: 0.0, exponent }
        };
        let wide = is_still || span > WIDE * size / power(own);
        let plain = || {
            let margin = margin * power(own);
            let axis = ChartAxis::spanning(low - margin, high + margin, STEPS[0]);
            Self { axis, offset: 0.0, exponent: 0 }
        };
        let plain = (size == 0.0 || USUAL.contains(&size) && span > 1e-6).then(plain);
        let scaled = STEPS.into_iter().flat_map(|steps| [own, own - 1].map(|exponent| over(exponent, steps)));
        let mut scaled = scaled.filter(|fitted| wide && readable(fitted));
        plain.filter(readable).or_else(|| scaled.next()).unwrap_or_else(|| {
            // A span that rounding made a little shorter than a power of ten counts as one.
            let exponent = own + exponent(1.001 * span);
            let offset = round_below(low, exponent);
            let [from, to] = [low, high].map(|value| (value - offset) / power(exponent));
            Self { axis: ChartAxis::spanning(from, to, STEPS[0]), offset, exponent }
        })
    }

    /// Whether the values are shown as they are.
    pub(super) fn is_plain(&self) -> bool {
        self.offset == 0.0 && self.exponent == 0
    }

    /// A value as the axis shows it.
    pub(super) fn rescale(&self, value: f64) -> f64 {
        if value.abs() < NOTHING && self.offset == 0.0 { 0.0 } else { (value - self.offset) / power(self.exponent) }
    }

    /// What the axis shows of what has this name.
    pub(super) fn tick_meaning(&self, name: &str) -> String {
        let sign = if self.offset < 0.0 { '+' } else { '−' };
        let less = format!("{name} {sign} {}", whole(self.offset.abs()));
        match (self.offset != 0.0, self.exponent) {
            (false, 0) => name.to_owned(),
            (true, 0) => less,
            (false, exponent) => format!("{name} / {}", power_of_ten(power(exponent))),
            (true, exponent) => format!("({less}) / {}", power_of_ten(power(exponent))),
        }
    }
}

/// The greatest multiple of a power of ten that is not above a value.
fn round_below(value: f64, to: i32) -> f64 {
    let digits = usize::try_from(exponent(value) - to).unwrap_or(0);
    let rounded = |value: f64| format!("{value:.digits$e}").parse().unwrap_or(value);
    let near: f64 = rounded(value);
    if near > value { rounded(near - power(to)) } else { near }
}
