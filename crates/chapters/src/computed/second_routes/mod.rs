//! Second routes to our own numbers, which share no code with the first ones.
//!
//! The first routes ask `ask` and the study of the runs, and through them the solutions of `geneva-dynamics`. Here forces are
//! vectors and steps are equal; only the printed rows take their runs from the witnesses of `geneva-case1973`, or from the program
//! where the first route is no program. What both start from are the sizes of an escapement and the printed rows. The results are
//! compared and never shown.

pub(super) mod blow;
pub(super) mod contact;
pub(super) mod definitions;
pub(super) mod interval;
pub(super) mod motion;
pub(super) mod outline;
pub(super) mod printed_rows;
pub(super) mod rise;
pub(super) mod spread;

use crate::rows::NONE;
use contact::ContactModel;
use geneva_evidence::{Agreement, Evidence, Numbers, Tolerance};
use motion::{SteppedEngagement, SteppedPassage};
use std::convert::Infallible;

/// Steps over which the friction changes its sign lose some digits.
pub(super) const NEWTON: &Evidence = &Evidence {
    slug: "newton",
    name: "newton",
    meaning: "Newton's laws in vectors, in equal steps of the crank",
    agreement: Agreement::Within(&Tolerance {
        name: "newton",
        relative: 1e-4,
        reason: "steps over which the friction changes its sign lose some digits",
    }),
};

/// The difference of two motions that are nearly alike keeps fewer digits than each of them.
pub(super) const NEWTON_DIFFERENCE: &Evidence = &Evidence {
    slug: "newton-difference",
    name: "newton difference",
    meaning: "the difference of two motions by Newton's laws, in equal steps of the crank",
    agreement: Agreement::Within(&Tolerance {
        name: "newton-difference",
        relative: 2e-3,
        reason: "the difference of two motions that are nearly alike keeps fewer digits than each of them",
    }),
};

/// The ends of an interval after so many halvings, between which a condition that holds at the first end ceases to hold. The second
/// routes halve by themselves: the solvers behind the first ones use `geneva_kinematics::bisection`.
pub(super) fn halve(times: u32, ends: [f64; 2], mut holds: impl FnMut(f64) -> bool) -> [f64; 2] {
    let Ok(ends) = try_halve(times, ends, |middle| Ok::<_, Infallible>(holds(middle)));
    ends
}

/// The ends as by [`halve`], of a condition that may fail.
pub(super) fn try_halve<E>(
    times: u32,
    [mut first, mut last]: [f64; 2],
    mut holds: impl FnMut(f64) -> Result<bool, E>,
) -> Result<[f64; 2], E> {
    for _ in 0..times {
        let middle = f64::midpoint(first, last);
        *(if holds(middle)? { &mut first } else { &mut last }) = middle;
    }
    Ok([first, last])
}

/// A measure of the motion of an escapement that repeats itself.
pub(super) fn steady<T>(model: ContactModel, measure: impl FnOnce(&SteppedPassage<'_>) -> Option<T>) -> Numbers<T> {
    let engagement = SteppedEngagement::new(model);
    Ok(engagement.steady_passage().as_ref().and_then(measure).ok_or(NONE)?)
}

/// Mean speed of the motion that repeats itself, in radians per unit of time.
pub(super) fn mean_speed(model: ContactModel) -> Numbers<f64> {
    Ok(SteppedEngagement::new(model).mean_speed().ok_or(NONE)?)
}

/// The power of the friction to which the mean speed is proportional: from a little more and a little less of it.
pub(super) fn friction_power(model: ContactModel) -> Numbers<f64> {
    const LITTLE: f64 = 0.005;
    let with = |times: f64| mean_speed(ContactModel { friction: times * model.friction, ..model });
    Ok((with(1.0 + LITTLE)? / with(1.0 - LITTLE)?).ln() / ((1.0 + LITTLE) / (1.0 - LITTLE)).ln())
}
