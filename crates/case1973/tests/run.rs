//! Does a ruler read off a run what the solver computes?

use geneva_case1973::Run;
use geneva_case1973::program::{Printout, Program1973};
use geneva_dynamics::steady::{Engagement, PrintedLine};
use geneva_dynamics::{Inertias, Parameters};
use geneva_kinematics::Mechanism;

fn parameters(mechanism: Mechanism) -> Parameters {
    let inertias = Inertias::new(0.2, 1.0).expect("two inertias");
    Parameters::new(mechanism, inertias, 1.0, 0.3).expect("an escapement")
}

#[test]
fn what_is_read_off_is_what_the_solver_has() {
    for mechanism in Mechanism::ALL {
        let parameters = parameters(mechanism);
        let steady = Engagement::new(&parameters).and_then(|of| of.steady_state()).expect("a steady state");
        let program = Program1973::ideal(&parameters);
        let integrator = geneva_mimic::SolverParameters::new(steady.period / 200.0, 30.0 * steady.period);
        let read = Run::read_off(&program.run(&integrator).expect("a run"), program.reset).expect("readings");
        assert!((read.peak / steady.peak.speed - 1.0).abs() < 1e-3, "{read:?} {steady:?}");
        assert!((read.period / steady.period - 1.0).abs() < 1e-3, "{read:?} {steady:?}");
        assert!((read.minimum / steady.minimum.speed - 1.0).abs() < 1e-3, "{read:?} {steady:?}");
    }
}

#[test]
fn the_time_of_a_hand_over_is_exact_where_the_angle_is_a_cubic() {
    // Slowest at the time `least`.
    let line = |least: f64, time: f64| {
        let past = time - least;
        PrintedLine {
            time,
            turned: past * past * past + past + least * least * least + least,
            angle: 0.0,
            speed: 3.0 * past * past + 1.0,
            acceleration: 6.0 * past,
            follower_speed: 0.0,
            engagement: 0,
        }
    };
    // From the first of these times on, so far apart, until the driver would be handed over for the third time.
    let read = |least: f64, first: i32, apart: f64, reset: f64| {
        let all = (first..).map(|k| line(least, f64::from(k) * apart));
        let lines = all.take_while(|line| line.turned < 3.0 * reset).collect();
        Run::read_off(&Printout { lines, work: geneva_mimic::SolverStats::default() }, reset)
    };
    // The driver is handed over at this time, and again when it has turned twice as far.
    for (least, apart, time) in [(0.05, 0.06, 0.1), (1.0, 0.5, 0.7), (1.0, 0.35, 1.2), (1.0, 0.4, 1.9)] {
        let reset = line(least, time).turned;
        let (mut low, mut high) = (time, 10.0);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            *(if line(least, middle).turned < 2.0 * reset { &mut low } else { &mut high }) = middle;
        }
        let found = read(least, 0, apart, reset).expect("two hand-overs");
        assert!((found.period - (low - time)).abs() < 1e-12, "{found:?} for {time} and {low}");
        assert!((found.first_minimum - least).abs() < 1e-12, "{found:?}");
    }
    // A run whose first line is behind the hand-over does not show when it was.
    let reset = line(1.0, 1.2).turned;
    assert!(read(1.0, 0, 0.35, reset).is_some() && read(1.0, 4, 0.35, reset).is_none());
}

#[test]
fn a_run_without_two_hand_overs_has_no_period() {
    let program = Program1973::ideal(&parameters(Mechanism::FOUR_PIN));
    let integrator = geneva_mimic::SolverParameters::new(0.01, 0.4);
    let short = program.run(&integrator).expect("a run");
    assert!(Run::read_off(&short, program.reset).is_none());
}
