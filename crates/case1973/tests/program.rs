//! Compares the program with itself and with the mechanism.

use geneva_case1973::program::{Program1973, ProgramError, SignRule};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

fn parameters(mechanism: Mechanism, ratio: f64, friction: f64) -> Parameters {
    Parameters::new(mechanism, Inertias::new(ratio, 1.0).unwrap(), 1.0, friction).unwrap()
}

fn tight(run_length: f64) -> geneva_mimic::SolverParameters {
    geneva_mimic::SolverParameters {
        relative_tolerance: 1e-11,
        absolute_floor: 1.0,
        growth_below: 1.0 / 64.0,
        at_smallest_step: geneva_mimic::MinStepPolicy::Continue,
        ..geneva_mimic::SolverParameters::new(run_length / 400.0, run_length)
    }
}

#[test]
fn a_driver_without_friction_gains_what_the_torque_gives() {
    for mechanism in Mechanism::ALL {
        let parameters = parameters(mechanism, 0.3, 0.0);
        let printout = Program1973::ideal(&parameters).run(&tight(6.0)).unwrap();
        for line in &printout.lines {
            let inertia = 0.3 + (line.follower_speed / line.speed.max(1e-300)).powi(2);
            let energy = 0.5 * inertia * line.speed * line.speed;
            approx::assert_relative_eq!(energy, line.turned, max_relative = 1e-8, epsilon = 1e-9);
        }
    }
}

#[test]
fn a_short_delay_changes_little_and_a_long_one_more() {
    let exact = Program1973::ideal(&parameters(Mechanism::FOUR_PIN, 0.06, 0.3));
    let integrator = geneva_mimic::SolverParameters { largest_step: 1e-3, initial_step: 1e-3, ..tight(8.0) };
    let at = |sign_rule| Program1973 { sign_rule, ..exact }.run(&integrator).unwrap().largest();
    let apart = |delay: f64| (at(SignRule::Delayed(delay)) - at(SignRule::Exact)).abs();
    let (short, long) = (apart(2e-3), apart(4e-2));
    assert!(short < long && short > 0.0, "{short} {long}");
}

#[test]
fn a_fold_that_is_none_and_a_friction_that_is_too_much_are_refused() {
    let program = Program1973::ideal(&parameters(Mechanism::THREE_PIN, 0.1, 0.2));
    for reset in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Program1973 { reset, ..program }.run(&tight(1.0));
        assert!(
            matches!(refused, Err(ProgramError::Escapement(geneva_dynamics::DynamicsError::NotPositive { .. }))),
            "{reset}"
        );
    }
    let refused = Program1973 { friction: 5.0, ..program }.run(&tight(1.0)).unwrap_err();
    assert!(
        matches!(refused, ProgramError::Escapement(geneva_dynamics::DynamicsError::TooMuchFriction { .. })),
        "{refused}"
    );
    let refused = Program1973 { start: f64::NAN, ..program }.run(&tight(1.0)).unwrap_err();
    assert!(refused.to_string().contains("give a number"), "{refused}");
    assert!(Program1973 { sign_rule: SignRule::Delayed(-1.0), ..program }.run(&tight(1.0)).is_err());
}
