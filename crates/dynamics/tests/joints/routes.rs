//! The same motion by other routes: the ideal escapement, and steps of time.

use super::*;
use approx::assert_relative_eq;
use geneva_dynamics::steady::Engagement;
use nalgebra::Vector2;
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, System};

#[test]
fn without_sizes_it_is_the_ideal_escapement() {
    let mut spread = Spread(0.0);
    for mechanism in Mechanism::ALL {
        for _ in 0..300 {
            let parameters = parameters(mechanism, spread.between(0.05, 2.0), spread.between(0.0, 0.35));
            let escapement = escapement(&parameters, Joints::default());
            assert_eq!(escapement.reversal_angle(), 0.0);
            let angle = mechanism.engagement_half_angle() * spread.between(-1.0, 1.0);
            let speed = spread.between(0.0, 4.0);
            let ideal = parameters.acceleration(angle, speed).expect("one acceleration");
            let motion = escapement.motion(angle, speed).expect("one acceleration");
            let scale = 1.0 + ideal.value.abs() + speed * speed;
            assert!((motion.angular_acceleration - ideal.value).abs() < 1e-13 * scale, "{mechanism:?} {angle} {speed}");
            let forces = parameters.contact_forces(angle, speed).expect("one acceleration");
            assert!(
                (motion.normal_moment - forces.normal_moment).abs() < 1e-12 * scale,
                "{mechanism:?} {angle} {speed}"
            );
        }
    }
}

#[test]
fn without_sizes_the_steady_motion_is_the_ideal_one() {
    for mechanism in Mechanism::ALL {
        for friction in [0.1, 0.25] {
            let inertia = like_the_thesis(mechanism).inertias().ratio();
            let parameters = parameters(mechanism, inertia, friction);
            let ideal = Engagement::new(&parameters).expect("sound").steady_state().expect("a steady state");
            let ours = escapement(&parameters, Joints::IDEAL).steady_state(1e-9).expect("a steady state");
            println!("{mechanism:?} {friction}: {} steps, change {:e}", ours.steps, ours.change);
            let state = ours.state;
            let off = [state.duration / ideal.period, state.peak.speed / ideal.peak.speed].map(|ratio| ratio - 1.0);
            println!("period and peak off by {off:?}; multiplier by {:e}", state.multiplier / ideal.multiplier - 1.0);
            assert_relative_eq!(state.entry_speed, ideal.entry_speed, max_relative = 1e-9);
            assert_relative_eq!(state.peak.speed, ideal.peak.speed, max_relative = 1e-9);
            assert_relative_eq!(state.minimum.speed, ideal.minimum.speed, max_relative = 1e-9);
            assert_relative_eq!(state.duration, ideal.period, max_relative = 1e-9);
            assert_relative_eq!(state.mean_speed, ideal.mean_speed, max_relative = 1e-9);
            assert_relative_eq!(state.multiplier, ideal.multiplier, max_relative = 1e-9);
            assert_relative_eq!(state.minimum.angle, ideal.minimum.angle, epsilon = 1e-6);
            assert_relative_eq!(state.minimum.time, ideal.minimum.time, max_relative = 1e-6);
            let reversal = ideal.reversal_angle.expect("a switch");
            assert_eq!(state.changes.len(), 1);
            assert_relative_eq!(state.changes[0], reversal, epsilon = 1e-9);
        }
    }
}

/// The motion in time, with the acceleration from vectors.
struct InTime(Escapement);

impl System<f64, Vector2<f64>> for InTime {
    fn system(&self, _: f64, state: &Vector2<f64>, rate: &mut Vector2<f64>) {
        *rate = Vector2::new(state[1], vectors::angular_acceleration(&self.0, state[0], state[1]));
    }
}

#[test]
fn steps_of_time_lead_to_the_same_exit() {
    let joints =
        Joints { pin_radius: 0.1, follower_drag_torque: 0.02, driver_drag_torque: 0.05, ..Joints::journals(0.1, 0.15) };
    for mechanism in Mechanism::ALL {
        let escapement = escapement(&like_the_thesis(mechanism), joints);
        let half = mechanism.engagement_half_angle();
        for entry in [0.5, 1.0, 2.0] {
            let passage = escapement.passage(entry, 4096).expect("it runs");
            let (end, start) = (passage.duration, Vector2::new(-half, entry));
            let mut solver = Dop853::new(InTime(escapement), 0.0, end, end, start, 1e-12, 1e-12);
            solver.set_output(OutputType::Sparse);
            solver.integrate().expect("integrated");
            let last = solver.y_out().last().expect("a state");
            let errors = [last[0] - half, last[1] / passage.exit_speed - 1.0];
            assert!(errors.iter().all(|error| error.abs() < 1e-9), "{mechanism:?} {entry} {errors:?}");
        }
    }
}
