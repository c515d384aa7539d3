//! Chapter II's paragraph on the curves of Fig. 8: where in an engagement driver and follower are fastest and slowest.

use super::by_steps::{Group, groups};
use super::runs::table::rows;
use super::study::steady;
use super::terms::is_there;
use super::*;
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use geneva_case1973::{Hypothesis, Row};
use geneva_dynamics::steady::{PrintedLine, SteadyState};
use geneva_kinematics::Mechanism;
use geneva_kinematics::escapement::pins_needed;
use geneva_kinematics::pin_slot::velocity_ratio;
use std::sync::OnceLock;

pub(super) const PEAKS: Locator = at("Chapter II, paragraph on the peaks in Fig. 8");

/// The driver's peaks are put where a pin enters and the next one leaves.
const PEAKS_AT_ENTRY: Slip = Slip {
    id: "meyer.peaks-at-entry",
    reason: "Where one pin enters and the other leaves, the follower stands still but is being accelerated, so the pin \
             presses and rubs. The driver's acceleration there is (K − μ I_f θ'²/(a² − 1))/I_D, with the torque K, the \
             friction μ, the inertias I_D of the driver and I_f of the follower, the driver's speed θ', and the centre \
             distance a in crank radii. This acceleration is zero at one speed only, and no run has that speed at \
             entry in its steady motion. How far the peak is from the entry depends on the ratio of the inertias. In \
             the runs with six pins the driver is heavy. The peak follows so soon after the entry that the peak speed \
             exceeds the speed at entry by at most 1 rad/s, the unit of the tables. In the runs with four and three \
             pins the driver is light. While the leaving pin still bears on the trailing flank, the torque of friction \
             already exceeds the spring's torque, so the peak comes before the pin leaves. If driver and follower are \
             equal discs, as in the thesis's own estimate of the inertias, the drivers of all three mechanisms are \
             fastest within three degrees past the entry. At the entry they already have 98 per cent of their greatest \
             speed or more, so for these drivers the sentence is nearly right.",
    witness: "For every mechanism at every friction value, we computed the motion in small steps of the driver's \
              angle.",
    origin: Origin::Concept,
    consequence: Consequence::Remark,
    changes: "In the runs with four and three pins the peaks of the driver's speed do not mark the entry of a pin, and \
              the follower is turning when the driver is fastest.",
};

pub(super) fn claims() -> Vec<Claim> {
    [at_entry(), centres::claims(), at_exit()].concat()
}

fn at_entry() -> Vec<Claim> {
    vec![
        PEAKS
            .value(
                "meyer.fig-8.quarter",
                "90",
                "°",
                "angle that the driver turns through between two peaks, with four slots",
            )
            .first_route(Evidence::CLOSED_FORM, || Mechanism::ALL[1].engagement_half_angle().to_degrees() * 2.0)
            .second_route(RUNGE_KUTTA, || {
                let four = groups().iter().filter(|group| group.rows.iter().all(|row| row.mechanism.slots() == 4));
                // The run in which the turn is farthest from the angle between two pins.
                let off =
                    |turn: &f64| (turn - 360.0 / pins_needed(4).map_or(f64::NAN, |pins| pins.approximate())).abs();
                four.filter_map(from_peak_to_peak).max_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(f64::NAN)
            }),
        beside_the_hand_over(
            "meyer.peaks-at-entry",
            "the driver is fastest when a pin enters",
            "the driver velocity is a maximum at pin entry",
            "in the runs with six pins (driver's inertia 0.6 of the follower's) the driver velocity is a maximum at \
             pin entry, to within one unit of the tables; in the runs with four and three pins (inertia 0.06 and 0.075 \
             of the follower's) it is a maximum 7.7 to 14° before pin entry",
        ),
        PEAKS
            .statement(
                "meyer.still-at-entry",
                "the follower must be instantaneously stationary",
                "the follower stands still when a pin enters or leaves",
            )
            .first_route(Evidence::VECTORS, |stated| {
                let ends: &[f64] = stated.pick(&[-1.0, 1.0], &[-0.99, 0.99]);
                let still = |at: &Mechanism| {
                    let turning = |part| PinKinematics::new(at, part * at.engagement_half_angle()).angular_velocity();
                    ends.iter().all(|part| vanishes(turning(part)))
                };
                Finding::for_all(&Mechanism::ALL, still, |count, all| {
                    format!("with {count} of {all} mechanisms the pin moves along its slot there")
                })
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                let ends: &[f64] = stated.pick(&[-1.0, 1.0], &[-0.99, 0.99]);
                let ratio = |at: &Mechanism, part: f64| {
                    let crank = Turn::from_radians(part * PI / f64::from(at.pins()));
                    velocity_ratio(&(1.0 / libm::sin(PI / f64::from(at.slots()))), &crank)
                };
                let still = |at: &Mechanism| ends.iter().all(|part| vanishes(ratio(at, *part)));
                Finding::for_all(&Mechanism::ALL, still, |count, all| {
                    format!("with {count} of {all} mechanisms φ'/θ' of Eq. (1-7) is zero there")
                })
            })
            .but_not("the follower stands still a hundredth of the way from there to the line of centres")
            .interpreted_as("We take the three mechanisms, in which a pin enters and leaves along its slot."),
        beside_the_hand_over(
            "meyer.peaks-at-rest",
            "the driver is fastest when the follower stands still",
            "the peaks in driver velocity coincide with the zero points",
            "in the runs with six pins (driver's inertia 0.6 of the follower's) the greatest peaks in driver velocity \
             coincide with the zero points, to within one unit of the tables; in the runs with four and three pins \
             (inertia 0.06 and 0.075 of the follower's) the peaks come 7.7 to 14° before the zero points",
        ),
        PEAKS
            .statement(
                "meyer.driver-slows",
                "the driver, transferring its energy to the follower, slows down",
                "after an entry the driver slows down while the follower picks up speed",
            )
            .first_route(QUADRATURE, |stated| {
                let found = cycles().iter().map(|Cycle { state, lines }| {
                    let until = stated.pick(state.minimum.angle, f64::INFINITY);
                    let [driver, follower] =
                        [|line: &PrintedLine| line.speed, |line: &PrintedLine| line.follower_speed]
                            .map(|of| lines.iter().filter(|line| line.angle <= until).map(of).collect::<Vec<_>>());
                    falls(&driver) && falls(&reversed(&follower))
                });
                all_of(found.collect(), rows().len(), "runs, to within one unit of the tables")
            })
            .second_route(RUNGE_KUTTA, |stated| {
                // The energies of the two members at the ends of the stretch: what the driver loses and the follower gains.
                let found = groups().iter().filter_map(|group| {
                    let (motion, steady) = (&group.motion, group.motion.steady()?);
                    let (at, inertias) = (motion.least(steady)?.angle, motion.parameters.inertias());
                    let energies = |inertia: f64, speeds: Vec<f64>| {
                        speeds.into_iter().map(move |speed| inertia * speed * speed).collect::<Vec<_>>()
                    };
                    let driver = energies(inertias.driver(), motion.values(steady, |_, speed| speed));
                    let follower = energies(inertias.follower(), motion.values(steady, motion.follower()));
                    let middle = motion.angles.iter().position(|angle| *angle >= at)?;
                    let to = stated.pick(middle, driver.len() - 1);
                    let [lost, gained] = [driver[0] - driver[to], follower[to] - follower[0]];
                    // In an engagement that repeats itself both are zero at the exit, but for rounding.
                    Some(
                        [lost, gained].iter().all(|part| *part > crate::evidence::STEPS_TOLERANCE.relative * driver[0]),
                    )
                });
                all_of(found.collect(), groups().len(), "groups of runs, by the energies at the ends")
            })
            .but_not("the driver slows down all the way from the entry to the exit")
            .interpreted_as(
                "We test the sentence against the motion from the entry until the driver is slowest, to within 1 \
                 rad/s, the unit of the tables. To within half a unit, the claim holds in 46 of 49 runs, and it holds \
                 exactly in 28. In the other runs, the driver goes on gaining speed past the entry, by up to 0.70 \
                 rad/s.",
            ),
    ]
}

fn at_exit() -> Vec<Claim> {
    vec![
        driver_increases(),
        beside_the_hand_over(
            "meyer.peaks-at-exit",
            "past the line of centres the driver is fastest again as the pin leaves",
            "until it again reaches a maximum as the pin leaves the slot",
            "until it is fastest again: in the runs with six pins (driver's inertia 0.6 of the follower's) as the pin \
             leaves the slot, to within one unit of the tables and after a dip of up to 1.8 rad/s, and in the runs \
             with four and three pins (inertia 0.06 and 0.075 of the follower's) 7.7 to 14° before the pin leaves",
        ),
    ]
}

/// How far the driver turns from its greatest speed in the last engagement but one of a start from rest to that in the last,
/// in degrees.
fn from_peak_to_peak(group: &Group) -> Option<f64> {
    let motion = &group.motion;
    let [.., before, last] = &motion.engagements[..] else { return None };
    let [before, last] = [before, last].map(|of| motion.greatest(of, |_, speed| speed).angle);
    let engagement = motion.angles.last()? - motion.angles.first()?;
    Some((engagement + last - before).to_degrees())
}

/// Instants of a cycle.
const INSTANTS: usize = 1000;

fn driver_increases() -> Claim {
    PEAKS
        .statement(
            "meyer.driver-increases",
            "the driver velocity increases",
            "the driver's speed rises from the line of centres to the exit",
        )
        .first_route(QUADRATURE, |stated| increases(stated, all_peaks()))
        .second_route(RUNGE_KUTTA, |stated| increases(stated, all_peaks_in_steps()))
        .interpreted_as(
            "We test the sentence against the steady motion of every run, all the way to the exit and to within 1 \
             rad/s, the unit of the tables.",
        )
        .corrected(
            "the driver velocity increases: in the runs with six pins (driver's inertia 0.6 of the follower's) except \
             for a dip of up to 1.8 rad/s, and in the runs with four and three pins (inertia 0.06 and 0.075 of the \
             follower's) until 7.7 to 14° before the pin leaves",
            PEAKS_AT_ENTRY,
        )
}

/// Whether the speed rises from the line of centres to the exit; or as far as is stated.
fn increases(stated: Stated, found: Vec<Peak>) -> Finding {
    let said = numbers_of(&found, true);
    let rising = found.iter().filter(|peak| is_there(peak.fall)).count();
    Finding::new(
        !found.is_empty() && stated.pick(stated.is_rounding_of(&said), rising == found.len()),
        format!(
            "in {rising} of {} motions the speed rises all the way, to within 1 rad/s. With six pins it falls back by \
             up to {:.2} rad/s on the way. With four and three pins it begins to fall {:.2} to {:.2}° before the exit",
            found.len(),
            said[1],
            said[4],
            said[5]
        ),
    )
}

/// A place that has the peak of the driver at a hand-over.
fn beside_the_hand_over(
    id: &'static str,
    meaning: &'static str,
    printed: &'static str,
    corrected: &'static str,
) -> Claim {
    let with_dip = id == "meyer.peaks-at-exit";
    PEAKS
        .statement(id, printed, meaning)
        .first_route(QUADRATURE, move |stated| peaks(stated, all_peaks(), with_dip, "runs"))
        .second_route(RUNGE_KUTTA, move |stated| {
            peaks(stated, all_peaks_in_steps(), with_dip, "runs with the strongest spring at each friction value")
        })
        .interpreted_as(
            "We test the sentence against the steady motion of every run. A peak counts as being at entry or exit if \
             the driver's speed there is within 1 rad/s (the unit of the tables) of the peak speed.",
        )
        .corrected(corrected, PEAKS_AT_ENTRY)
}

/// Where the driver is fastest, and by how much it is slower at the hand-over, in rad/s.
struct Peak {
    mechanism: Mechanism,
    /// I_D/I_f.
    inertias: f64,
    angle: f64,
    lost: f64,
    /// By how much the speed falls back most on the way from the line of centres to the exit, in rad/s.
    fall: f64,
}

/// By how much speeds fall back most below the greatest one before.
fn fall(speeds: impl Iterator<Item = f64>) -> f64 {
    let back = |[most, fall]: [f64; 2], speed: f64| [most.max(speed), fall.max(most - speed)];
    speeds.fold([f64::NEG_INFINITY, 0.0], back)[1]
}

/// Of every row, by the solution over the angle.
fn all_peaks() -> Vec<Peak> {
    let of = |((row, state), cycle): (&(&Row, SteadyState), &Cycle)| {
        let inertias = Hypothesis::IDEAL.parameters(row)?.inertias().ratio();
        let lost = state.peak.speed - state.entry_speed;
        let fall = fall(cycle.lines.iter().filter(|line| line.angle >= 0.0).map(|line| line.speed));
        Some(Peak { mechanism: row.mechanism, inertias, angle: state.peak.angle, lost, fall })
    };
    steady().iter().zip(cycles()).filter_map(of).collect()
}

/// Of the strongest row of every group, by steps of the angle.
fn all_peaks_in_steps() -> Vec<Peak> {
    let of = |group: &Group| {
        let (motion, steady) = (&group.motion, group.motion.steady()?);
        let peak = motion.greatest(steady, |_, speed| speed);
        let lost = (peak.value - steady.ends()[0]) * group.greatest_scale();
        let inertias = motion.parameters.inertias().ratio();
        let past = motion.angles.iter().position(|angle| *angle >= 0.0)?;
        let fall = fall(motion.values(steady, |_, speed| speed).into_iter().skip(past)) * group.greatest_scale();
        Some(Peak { mechanism: group.rows.first()?.mechanism, inertias, angle: peak.angle, lost, fall })
    };
    groups().iter().filter_map(of).collect()
}

/// What the corrections say: the ratio of inertias with six pins, with the dip behind it or without, those with four and
/// three pins, and how far before the exit the peak is with these, least and most. Not a number for a ratio that differs
/// within a mechanism.
fn numbers_of(found: &[Peak], with_dip: bool) -> Vec<f64> {
    let own = |mechanism: Mechanism| found.iter().filter(move |peak| peak.mechanism == mechanism);
    let [six, four, three] = [Mechanism::SIX_PIN, Mechanism::FOUR_PIN, Mechanism::THREE_PIN].map(|mechanism| {
        let [low, high] = range(own(mechanism).map(|peak| peak.inertias));
        if agrees(low, high) { low } else { f64::NAN }
    });
    let dip = with_dip.then(|| own(Mechanism::SIX_PIN).map(|peak| peak.fall).fold(0.0, f64::max));
    let others = found.iter().filter(|peak| peak.mechanism != Mechanism::SIX_PIN);
    let before = range(others.map(|peak| 180.0 / f64::from(peak.mechanism.pins()) - peak.angle.to_degrees()));
    [six].into_iter().chain(dip).chain([four, three]).chain(before).collect()
}

/// Whether the peaks are at the hand-over; or, with the ratios of inertias that are stated, at it with six pins and as far
/// before it as is stated with four and three.
fn peaks(stated: Stated, found: Vec<Peak>, with_dip: bool, runs: &str) -> Finding {
    let lost = |six: bool| {
        let own = found.iter().filter(|peak| (peak.mechanism == Mechanism::SIX_PIN) == six);
        range(own.map(|peak| peak.lost))
    };
    let ([_, six_most], [least, most]) = (lost(true), lost(false));
    let said = numbers_of(&found, with_dip);
    let before = &said[said.len() - 2..];
    let holds = stated.pick(
        is_there(six_most) && !is_there(least) && stated.is_rounding_of(&said),
        found.iter().all(|peak| is_there(peak.lost)),
    );
    Finding::new(
        holds,
        format!(
            "in the {runs}, the driver's speed at entry is below its peak by at most {six_most:.2} rad/s with six pins, \
             and by {least:.0} to {most:.0} rad/s with four and three pins, where the peak is {:.2} to {:.2}° before the \
             hand-over",
            before[0], before[1]
        ),
    )
}

/// A row's steady motion at instants of its cycle.
pub(super) struct Cycle {
    pub state: SteadyState,
    pub lines: Vec<PrintedLine>,
}

/// The steady cycles of all rows.
pub(super) fn cycles() -> &'static [Cycle] {
    static CYCLES: OnceLock<Vec<Cycle>> = OnceLock::new();
    let of = |(row, state): &(&Row, SteadyState)| {
        Some(Cycle { state: *state, lines: Hypothesis::IDEAL.engagement(row)?.steady_cycle(INSTANTS).ok()? })
    };
    CYCLES.get_or_init(|| steady().iter().filter_map(of).collect())
}

/// Whether something was found for so many and is so for all of them.
pub(super) fn all_of(found: Vec<bool>, count: usize, of: &str) -> Finding {
    let right = found.iter().filter(|right| **right).count();
    Finding::new(right == count && found.len() == count, format!("this holds in {right} of {count} {of}"))
}

/// Whether a speed falls all the way: it is nowhere more than a unit above its least before.
pub(super) fn falls(speeds: &[f64]) -> bool {
    let mut least = f64::INFINITY;
    speeds.len() > 1
        && speeds.first() > speeds.last()
        && speeds.iter().all(|speed| {
            least = least.min(*speed);
            is_there((*speed - least).max(0.0))
        })
}

/// Speeds in the reverse order.
fn reversed(speeds: &[f64]) -> Vec<f64> {
    speeds.iter().rev().copied().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_acceleration_at_entry_is_that_of_the_reason_and_never_zero() {
        let mut signs = [0; 2];
        for (row, state) in steady() {
            let of = Hypothesis::IDEAL.parameters(row).expect("an escapement");
            let at =
                of.acceleration(-of.mechanism().engagement_half_angle(), state.entry_speed).expect("one acceleration");
            let square = state.entry_speed * state.entry_speed / (of.mechanism().centre_distance_ratio_squared() - 1.0);
            let angular_acceleration =
                (of.torque() - of.friction() * of.inertias().follower() * square) / of.inertias().driver();
            assert!(
                (at.value / angular_acceleration - 1.0).abs() < 1e-9,
                "{}: {} {angular_acceleration}",
                row.slug(),
                at.value
            );
            signs[usize::from(angular_acceleration > 0.0)] += 1;
        }
        // With six pins and with much friction the speed still rises there, else it falls.
        assert!(signs[0] > signs[1] && signs[0] + signs[1] == rows().len(), "{signs:?}");
    }

    #[test]
    fn with_like_discs_all_three_are_fastest_just_past_the_entry_and_nearly_as_fast_at_it() {
        for row in rows() {
            let at = Hypothesis::IDEAL.parameters(row).expect("an escapement");
            let inertias = geneva_dynamics::Inertias::new(1.0, 1.0).expect("two inertias");
            let alike = geneva_dynamics::Parameters::new(at.mechanism(), inertias, 1.0, at.friction());
            let engagement = geneva_dynamics::steady::Engagement::new(&alike.expect("an escapement"));
            let state = engagement.and_then(|of| of.steady_state()).expect("a steady state");
            let past = state.peak.angle.to_degrees() + 180.0 / f64::from(row.mechanism.pins());
            assert!((0.0..3.0).contains(&past), "{}: {past}", row.slug());
            assert!(state.entry_speed > 0.98 * state.peak.speed, "{}", row.slug());
        }
    }

    #[test]
    fn after_an_entry_the_driver_gains_at_most_seven_tenths_of_a_unit_before_it_slows_down() {
        let gains: Vec<f64> = cycles()
            .iter()
            .map(|Cycle { state, lines }| {
                let until = |line: &&PrintedLine| line.angle <= state.minimum.angle;
                let speeds: Vec<f64> = lines.iter().filter(until).map(|line| line.speed).collect();
                fall(reversed(&speeds).into_iter())
            })
            .collect();
        let within = |unit: f64| gains.iter().filter(|gain| **gain <= unit).count();
        assert_eq!([within(1.0), within(0.5), within(1e-4)], [49, 46, 28], "{gains:?}");
        let most = gains.iter().copied().fold(0.0, f64::max);
        assert!((0.695..0.705).contains(&most), "{most}");
    }
}
