//! Whether the tolerance that is asked for is met, from one end of the parameters to the other.

use super::escapement;
use geneva_dynamics::existence;
use geneva_dynamics::steady::Engagement;
use geneva_kinematics::Mechanism;

/// The finest, for comparison: ten times finer than what is tested against it.
const REFERENCE: f64 = 1e-13;

#[test]
fn the_tolerance_is_met() {
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        let (mut worst, mut subintervals, mut count) = (0.0_f64, 0, 0);
        for mechanism in Mechanism::ALL {
            for quarter in -12..=12 {
                let inertia = libm::exp10(f64::from(quarter) / 4.0);
                let limit = existence::critical_friction(mechanism, inertia).expect("sound").friction.min(3.0);
                for part in [1e-6, 0.03, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 0.997] {
                    let escapement = escapement(mechanism, inertia, limit * part);
                    let [one, finest] = [tolerance, REFERENCE].map(|tolerance| {
                        let engagement = Engagement::with_tolerance(&escapement, tolerance).expect("an engagement");
                        (engagement.subintervals(), engagement.steady_state().expect("a terminal speed"))
                    });
                    (subintervals, count) = (subintervals + one.0, count + 1);
                    let (one, finest) = (one.1, finest.1);
                    let [reversal, same] = [one, finest].map(|steady| steady.reversal_angle.expect("a switch"));
                    for (name, a, b) in [
                        ("entry", one.entry_speed, finest.entry_speed),
                        ("peak", one.peak.speed, finest.peak.speed),
                        ("minimum", one.minimum.speed, finest.minimum.speed),
                        ("period", one.period, finest.period),
                        ("switch", reversal, same),
                        ("multiplier", libm::log(one.multiplier), libm::log(finest.multiplier)),
                    ] {
                        let error = (a / b - 1.0).abs();
                        worst = worst.max(error);
                        assert!(
                            error <= tolerance,
                            "{mechanism:?} {inertia} {part} {name}: {error:e} of {tolerance:e}"
                        );
                    }
                }
            }
        }
        println!("{tolerance:e}: {worst:e} with {:.1} subintervals", f64::from(subintervals as u32) / f64::from(count));
    }
}

#[test]
fn the_tolerance_is_met_from_rest() {
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        let (mut worst, mut between) = (0.0_f64, 0.0_f64);
        for mechanism in Mechanism::ALL {
            for half in -6..=6 {
                let inertia = libm::exp10(f64::from(half) / 2.0);
                let limit = existence::critical_friction(mechanism, inertia).expect("sound").friction.min(3.0);
                for part in [1e-6, 0.1, 0.3, 0.5, 0.7, 0.9, 0.97] {
                    let escapement = escapement(mechanism, inertia, limit * part);
                    let [one, finest] = [tolerance, REFERENCE].map(|tolerance| {
                        let engagement = Engagement::with_tolerance(&escapement, tolerance).expect("an engagement");
                        let passage = engagement.passage(0.0).expect("a speed");
                        let numbers = [passage.duration(), passage.end_speed(), passage.fastest().speed];
                        (numbers, engagement)
                    });
                    let case = format!("{mechanism:?} {inertia} {part} to {tolerance:e}");
                    for (a, b) in one.0.iter().zip(finest.0) {
                        worst = worst.max((a / b - 1.0).abs());
                        assert!((a / b - 1.0).abs() <= tolerance, "{case}: {:e}", a / b - 1.0);
                    }
                    let duration = 2.0 * finest.0[0];
                    let [one, finest] = [one.1, finest.1].map(|of| of.run(duration / 50.0, duration).expect("a run"));
                    for (a, b) in one.iter().zip(&finest).skip(1) {
                        between = between.max((a.speed / b.speed - 1.0).abs());
                    }
                }
            }
        }
        // The lines are interpolated, which is good to some of what was asked for.
        assert!(between <= 10.0 * tolerance, "{tolerance:e}: {between:e}");
        println!("{tolerance:e} from rest: {worst:e}, at print times {between:e}");
    }
}
