//! The three conclusions of the thesis.

use super::runs::table::rows;
use super::summary::from_speed;
use super::*;
use crate::evidence::{QUADRATURE, RUNGE_KUTTA};
use geneva_case1973::series;

pub(super) fn claims() -> Vec<Claim> {
    let mut claims = vec![timing(), small_variations()];
    claims.extend(hand_over::conclusion());
    claims
}

/// Speeds at the start, over that of the steady motion at entry: from rest, slow and fast.
const STARTS: [f64; 3] = [0.0, 0.1, 10.0];

/// By how much the neighbour has more friction.
const MORE: f64 = 1.2;

fn timing() -> Claim {
    at("Conclusion 1")
        .statement(
            "meyer.conclusion.timing",
            "can be used as a timing device",
            "the mechanism comes to a steady motion",
        )
        .first_route(QUADRATURE, |stated| {
            let settled = series(rows()).filter_map(|own| {
                let row = own.first()?;
                let steady = general_statements::with(row, 1.0, 1.0)?.steady_state().ok()?;
                let of = general_statements::with(row, 1.0, stated.pick(1.0, MORE));
                let last = STARTS.map(|start| {
                    let (of, mut speed) = (of.as_ref()?, start * steady.entry_speed);
                    for _ in 0..ENGAGEMENTS {
                        speed = of.return_map(speed).ok()?;
                    }
                    Some(of.passage(speed).ok()?.duration() / steady.period)
                });
                Some(settles(&last.map(|duration| duration.unwrap_or(f64::NAN))))
            });
            of_groups(settled.collect(), stated)
        })
        .second_route(RUNGE_KUTTA, |stated| {
            let settled = series(rows()).filter_map(|own| {
                let (row, friction) = (own.first()?, stated.pick(1.0, MORE));
                // The motion from rest with the friction of the run: its last engagement but one is compared with the last.
                let rest = from_speed(row, 1.0, 0.0);
                let ((duration, speed), before) = (*rest.last()?, rest.iter().rev().nth(1)?.0);
                let last = STARTS.map(|start| {
                    let all = from_speed(row, friction, start * speed);
                    all.last().map_or(f64::NAN, |(last, _)| last / duration)
                });
                Some(settles(&[&last[..], &[before / duration]].concat()))
            });
            of_groups(settled.collect(), stated)
        })
        .but_not("it comes to the same motion with a fifth more friction")
        .interpreted_as(
            "We ask for a timing device of no stated accuracy, as in the abstract. Whether it starts from rest or with \
             a slow or fast forward motion, every run comes to one terminal velocity. All its engagements then take \
             the same time, as long as nothing changes.",
        )
}

/// Engagements after which a start is over.
const ENGAGEMENTS: usize = 40;

/// Whether motions have come to one and the same period, from their last ones over it.
fn settles(periods: &[f64]) -> bool {
    periods.iter().all(|period| crate::evidence::STEPS_TOLERANCE.agrees(*period, 1.0))
}

fn of_groups(settled: Vec<bool>, stated: Stated) -> Finding {
    let count = settled.iter().filter(|settled| **settled).count();
    Finding::new(
        count == series(rows()).count(),
        format!(
            "in {count} of {} groups of runs, the motion {}comes to the steady period of the run, whether it starts \
             from rest or with a tenth to ten times the steady speed",
            series(rows()).count(),
            stated.pick("", "with a fifth more friction ")
        ),
    )
}

fn small_variations() -> Claim {
    at("Conclusion 2")
        .statement(
            "meyer.small-variations",
            "will not seriously affect the motion",
            "small changes of the parameters have no serious effect on the motion",
        )
        .missing(
            "The thesis does not say which effects it would call serious, and the three obvious measures disagree. By \
             the first measure, the effect is small: in all runs, a change of one per cent in the torque, the friction \
             or one of the inertias changes peak, minimum and period of the steady motion by less than one per cent. \
             The second measure is the rise time. If we count the rise as over only when the velocity is steady at \
             each angle, such a change alters the rise time by more than one per cent in some runs. If we count it as \
             over when the average of peak and minimum is steady, such a change alters the rise time by less than one \
             per cent in all runs. But with this count, a change of a few per cent can shorten the rise by a whole \
             engagement, which can be about half of the rise time. By the third measure, the effect is serious: a \
             clock controlled by the mechanism gains or loses minutes a day",
        )
}

#[cfg(test)]
mod tests {
    use super::super::general_statements::{Responses, each_alone, responses};
    use super::super::terms::Start;
    use super::*;
    use geneva_dynamics::steady::Engagement;

    #[test]
    fn one_per_cent_changes_the_steady_motion_by_less_and_the_rise_time_of_some_runs_by_more() {
        let sets = [1.01, 0.99].map(each_alone).concat();
        let found: Responses<5> = responses(&sets, |at| {
            let of = Engagement::new(at).ok()?;
            let state = of.steady_state().ok()?;
            let [profile, average] = Start::by_integrals(&of)?.rise_times;
            Some([state.peak.speed, state.minimum.speed, state.period, profile, average])
        });
        let changes: Vec<[f64; 5]> = found.concat();
        assert_eq!(changes.len(), sets.len() * series(rows()).count());
        assert!(changes.iter().all(|change| change[..3].iter().all(|part| *part < 0.01)));
        let more = changes.iter().filter(|change| change[3] > 0.01).count();
        assert!(more > 0 && more < changes.len(), "{more}");
        assert!(changes.iter().all(|change| change[4] < 0.01), "{changes:?}");
        // A minute of a day.
        for friction in [&found[1], &found[5]] {
            assert!(friction.iter().all(|change| change[2] > 60.0 / 86_400.0));
        }
    }

    #[test]
    fn five_per_cent_more_friction_can_take_off_an_engagement_and_nearly_half_of_the_time_by_the_average() {
        let found: Responses<1> = responses(&[[1.0, 1.05, 1.0, 1.0]], |at| {
            Some([Start::by_integrals(&Engagement::new(at).ok()?)?.rise_times[1]])
        });
        let most = found.concat().iter().map(|change| change[0]).fold(0.0, f64::max);
        assert!((0.4..0.6).contains(&most), "{most}");
    }
}
