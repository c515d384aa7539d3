//! What must hold of the drawings of single runs.

use super::{aliasing, first_minimum, speeds};
use crate::FigureError;
use crate::checks::{ParsedDrawing, assert_sound, columns};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

fn engagement(mechanism: Mechanism, friction: f64) -> Engagement {
    let inertias = Inertias::new(3.0, 40.0).expect("sound");
    Engagement::new(&Parameters::new(mechanism, inertias, 40.0, friction).expect("sound")).expect("sound")
}

#[test]
fn printed_peaks_are_below_the_true_ones_and_swing() {
    for mechanism in Mechanism::ALL {
        let one = engagement(mechanism, 0.25);
        let steady = one.steady_state().expect("steady");
        let (interval, duration) = (steady.period / 61.7, 9.3 * steady.period);
        let figure = aliasing(&one, interval, duration).expect("drawn");
        assert_sound(&figure);
        let rows = columns(&figure.series, ["peak true", "t printed", "peak printed"]);
        assert!(rows.len() >= 7, "{} engagements", rows.len());
        for [peak, time, printed] in &rows {
            assert!(*printed <= peak * (1.0 + 1e-9), "{peak} {printed}");
            assert!((time / interval - (time / interval).round()).abs() < 1e-6, "a multiple of the interval");
        }
        let [last, ..] = rows[rows.len() - 1];
        approx::assert_relative_eq!(last, steady.peak.speed, max_relative = 1e-6);
        let printed =
            |pick: fn(f64, f64) -> f64| rows.iter().skip(2).map(|[_, _, printed]| *printed).reduce(pick).expect("some");
        assert!(printed(f64::max) > printed(f64::min) * (1.0 + 1e-6));
    }
}

#[test]
fn a_run_of_a_few_engagements_does_not_tell() {
    let one = engagement(Mechanism::FOUR_PIN, 0.25);
    let period = one.steady_state().expect("steady").period;
    assert_eq!(aliasing(&one, period / 50.0, 2.0 * period), Err(FigureError::Nothing));
    assert!(matches!(aliasing(&one, 0.0, 1.0), Err(FigureError::Dynamics(_))));
    assert!(matches!(speeds(&engagement(Mechanism::FOUR_PIN, 0.0), ""), Err(FigureError::Dynamics(_))));
}

#[test]
fn the_first_minimum_is_marked_and_the_follower_keeps_its_sense() {
    for mechanism in Mechanism::ALL {
        let one = engagement(mechanism, 0.25);
        let figure = speeds(&one, "Made up.");
        let figure = figure.expect("drawn");
        assert_sound(&figure);
        assert!(figure.caption.ends_with("Made up."));
        let rise = one.rise(1e-9).expect("steady");
        // φ' is never negative: the pins keep the sense.
        let rows = columns(&figure.series, ["t", "theta'", "phi'"]);
        assert!(rows.iter().all(|[_, driver, follower]| *follower > -1e-9 * driver.max(1.0)));
        let found = first_minimum(&one).expect("a minimum");
        let (first, speed) = (found.time, found.speed);
        assert!(first < rise.cycles[0].end && speed < rise.cycles[0].peak.speed, "in the first engagement");
        let around = |from: f64, to: f64| {
            let within = rows.iter().filter(|[time, ..]| (from..=to).contains(time));
            within.map(|[_, driver, _]| *driver).fold(f64::INFINITY, f64::min)
        };
        let period = rise.steady.period;
        assert!(around(first - 0.1 * period, first + 0.1 * period) >= speed * (1.0 - 1e-6));
        let drawing = ParsedDrawing::parse(&figure);
        let duration = rise.cycles[0].end + 4.0 * period;
        let frame = drawing.path("zero", 0);
        let share = (drawing.centre("first-minimum").x - frame[0].x) / (frame[1].x - frame[0].x);
        assert!((share - first / duration).abs() < 1e-3, "{share}");
    }
}

#[test]
fn the_follower_has_the_speed_that_the_run_gives_it() {
    // The drawing takes it from the pose; the run has it from its own variable.
    let one = engagement(Mechanism::THREE_PIN, 0.25);
    let figure = speeds(&one, "").expect("drawn");
    let rows = columns(&figure.series, ["t", "phi'"]);
    let lines = one.run(rows[1][0], rows[rows.len() - 1][0] * (1.0 + 1e-9)).expect("a run");
    for ([_, follower], line) in rows.iter().zip(&lines) {
        assert!((follower - line.follower_speed).abs() < 1e-9 * (1.0 + line.speed), "{follower} {line:?}");
    }
}
