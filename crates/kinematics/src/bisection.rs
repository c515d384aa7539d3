//! Where a condition ceases to hold, by halving an interval.
//!
//! For limits and for extremes whose rate changes its sign once. A second route that must share no code with the first has a
//! halving of its own.

use std::convert::Infallible;

/// The ends of the interval in which `holds` turns from true, as at the first end, to false, as at the second: halved until no
/// number lies between them, in the unit of the given ends. The first may be the greater one. Each midpoint is asked once, the ends
/// never.
///
/// ```
/// use geneva_kinematics::bisection::bisect;
///
/// let [below, above] = bisect([1.0, 2.0], |x| x * x < 2.0);
/// assert_eq!((below, above), (2.0_f64.sqrt().next_down(), 2.0_f64.sqrt()));
/// ```
pub fn bisect(ends: [f64; 2], holds: impl FnMut(f64) -> bool) -> [f64; 2] {
    bisect_times(u32::MAX, ends, holds)
}

/// The ends as by [`bisect`], in the unit of the given ends, from so many halvings at most: for a condition that costs much, or that need not be
/// known so finely.
///
/// ```
/// use geneva_kinematics::bisection::bisect_times;
///
/// assert_eq!(bisect_times(3, [0.0, 8.0], |x| x < 2.5), [2.0, 3.0]);
/// ```
pub fn bisect_times(halvings: u32, ends: [f64; 2], mut holds: impl FnMut(f64) -> bool) -> [f64; 2] {
    let Ok(ends) = try_bisect_times(halvings, ends, |middle| Ok::<_, Infallible>(holds(middle)));
    ends
}

/// The ends as by [`bisect_times`], in the unit of the given ends, of a condition that may fail.
///
/// ```
/// use geneva_kinematics::bisection::try_bisect_times;
///
/// let below = |x: f64| if x > 0.0 { Ok(x.ln() < 0.0) } else { Err("no logarithm") };
/// assert_eq!(try_bisect_times(60, [0.5, 2.0], below), Ok([1.0_f64.next_down(), 1.0]));
/// assert_eq!(try_bisect_times(60, [-4.0, 2.0], below), Err("no logarithm"));
/// ```
///
/// # Errors
///
/// The first error of the condition.
pub fn try_bisect_times<E>(
    halvings: u32,
    [mut first, mut last]: [f64; 2],
    mut holds: impl FnMut(f64) -> Result<bool, E>,
) -> Result<[f64; 2], E> {
    for _ in 0..halvings {
        let middle = f64::midpoint(first, last);
        if middle == first || middle == last {
            break;
        }
        *(if holds(middle)? { &mut first } else { &mut last }) = middle;
    }
    Ok([first, last])
}
