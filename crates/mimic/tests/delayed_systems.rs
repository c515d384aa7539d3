//! Systems that look back: do they see what was kept, and nothing else?

use geneva_mimic::{Ahead, Between, Cause, DelayError, DelayLine, IntegrationError, Parameters, System, integrate};
use nalgebra::{SVector, Vector1, Vector2};
use std::f64::consts::FRAC_PI_2;

/// x'(t) = −x(t − 1), with x = 1 until time 0.
struct Memory<const CAPACITY: usize> {
    past: DelayLine<CAPACITY>,
}

impl<const CAPACITY: usize> Memory<CAPACITY> {
    fn new(between: Between) -> Self {
        Self { past: DelayLine::new(1.0, 1.0, between, Ahead::Hold).expect("a delay line") }
    }
}

impl<const CAPACITY: usize> System<1> for Memory<CAPACITY> {
    type Fault = DelayError;

    fn derivative(&mut self, time: f64, _: &Vector1<f64>) -> Result<Vector1<f64>, DelayError> {
        Ok(Vector1::new(-self.past.value(time)?))
    }

    fn accepted(&mut self, time: f64, state: &Vector1<f64>, _: &Vector1<f64>) -> Result<(), DelayError> {
        self.past.record(time, state[0])
    }
}

/// By steps of one delay: the sum over k of (−1)ᵏ (t − k + 1)ᵏ / k!, as far as the bracket is positive.
fn memory_exact(time: f64) -> f64 {
    let (mut sum, mut k, mut factorial) = (1.0, 1, 1.0);
    while time - f64::from(k) + 1.0 > 0.0 {
        factorial *= -f64::from(k);
        sum += (time - f64::from(k) + 1.0).powi(k) / factorial;
        k += 1;
    }
    sum
}

#[test]
fn an_equation_with_delay_is_solved_to_the_order_of_its_interpolation() {
    for (between, order) in [(Between::Linear, 2.0), (Between::Hold, 1.0)] {
        let error = |steps: f64| {
            let fixed = Parameters::with_fixed_step(1.0 / steps, 0.5, 5.0);
            let mut worst: f64 = 0.0;
            let end = integrate(&mut Memory::<200>::new(between), Vector1::new(1.0), &fixed, |point| {
                worst = worst.max((point.state[0] - memory_exact(point.time)).abs());
            });
            end.unwrap();
            worst
        };
        let observed = libm::log2(error(32.0) / error(64.0));
        println!("{between:?}: order {observed:.3}, error {:.1e}", error(64.0));
        assert!((observed - order).abs() < 0.1, "{between:?}: {observed}");
    }
}

#[test]
fn the_error_test_does_not_see_how_the_past_is_read() {
    // Straight lines between entries half a unit apart: integrated without a difference, and far from the solution.
    let run = |largest_step| {
        let parameters = Parameters { largest_step, initial_step: largest_step, ..Parameters::new(0.5, 5.0) };
        let end = integrate(&mut Memory::<200>::new(Between::Linear), Vector1::new(1.0), &parameters, |_| ()).unwrap();
        (end.work, (end.last.state[0] - memory_exact(5.0)).abs())
    };
    let ((work, blind), (_, close)) = (run(0.5), run(1.0 / 128.0));
    println!("{work:?}: off by {blind:.1e}; with short steps {close:.1e}");
    assert_eq!((work.accepted, work.rejected), (10, 0));
    assert!(blind > 1e-3 && close < 1e-5, "{blind} and {close}");
}

#[test]
fn a_line_without_room_stops_the_run_where_it_is_full() {
    let parameters = Parameters::with_fixed_step(1.0 / 128.0, 1.0, 2.0);
    let error = integrate(&mut Memory::<100>::new(Between::Linear), Vector1::new(1.0), &parameters, |_| ());
    let Err(IntegrationError::Stopped(stopped)) = error else { panic!("{error:?}") };
    assert_eq!(stopped.time, 100.0 / 128.0);
    let Cause::System(DelayError::Full { time, capacity: 100, .. }) = stopped.cause else { panic!("{stopped}") };
    assert_eq!(time, stopped.time);
    assert!(stopped.to_string().contains("stopped at time 0.78125"), "{stopped}");
}

/// (1 + s/2) x'' = cos t, with s the sign that x'' had a moment before: a load that drags one way and helps the other.
struct StaleSign {
    old_acceleration: DelayLine<100>,
    kept: Vec<f64>,
}

impl StaleSign {
    fn new(delay: f64) -> Self {
        let old_acceleration = DelayLine::new(delay, 1.0, Between::Linear, Ahead::Hold).expect("a delay line");
        Self { old_acceleration, kept: Vec::new() }
    }
}

impl System<2> for StaleSign {
    type Fault = DelayError;

    fn derivative(&mut self, time: f64, state: &Vector2<f64>) -> Result<Vector2<f64>, DelayError> {
        let sign = if self.old_acceleration.value(time)? < 0.0 { -1.0 } else { 1.0 };
        Ok(Vector2::new(state[1], libm::cos(time) / (1.0 + 0.5 * sign)))
    }

    fn accepted(&mut self, time: f64, _: &Vector2<f64>, rate: &Vector2<f64>) -> Result<(), DelayError> {
        self.kept.push(time);
        self.old_acceleration.record(time, rate[1])
    }
}

/// Speed at time 2.5 if the sign changes at this time: gains count two thirds, losses twice.
fn speed_with_change_at(change: f64) -> f64 {
    libm::sin(change) / 1.5 + (libm::sin(2.5) - libm::sin(change)) / 0.5
}

#[test]
fn a_sign_read_late_changes_late_by_the_delay() {
    for delay in [0.05, 0.1, 0.2] {
        let step = 1.0 / 256.0;
        let fixed = Parameters::with_fixed_step(step, 0.5, 2.5);
        let end = integrate(&mut StaleSign::new(delay), SVector::zeros(), &fixed, |_| ()).unwrap();
        let (late, at_once) = (speed_with_change_at(FRAC_PI_2 + delay), speed_with_change_at(FRAC_PI_2));
        let speed = end.last.state[1];
        println!("delay {delay}: off the late change {:.1e}, off the prompt one {:.1e}", speed - late, speed - at_once);
        // A step too early or late, the acceleration jumps there by 4/3 sin of the delay.
        assert!((speed - late).abs() < step * 4.0 / 3.0 * libm::sin(delay), "delay {delay}: {speed} for {late}");
        assert!((speed - at_once).abs() > 0.9 * (late - at_once).abs(), "delay {delay}: {speed} for {at_once}");
    }
}

/// No step longer than the shortest delay: the sign is not read ahead of what was kept, and the entries are close.
fn tolerant() -> Parameters {
    Parameters { largest_step: 0.05, initial_step: 0.05, ..Parameters::new(0.5, 2.5) }
}

#[test]
fn with_the_tolerance_the_late_change_is_met_within_it() {
    for delay in [0.05, 0.1, 0.2] {
        let end = integrate(&mut StaleSign::new(delay), SVector::zeros(), &tolerant(), |_| ()).unwrap();
        let off = end.last.state[1] - speed_with_change_at(FRAC_PI_2 + delay);
        println!("delay {delay}: off by {off:.1e}, {:?}", end.work);
        assert!(off.abs() < 1e-5, "delay {delay}: {off}");
    }
}

#[test]
fn refused_steps_leave_no_trace_in_the_past() {
    let mut system = StaleSign::new(0.05);
    let work = integrate(&mut system, SVector::zeros(), &tolerant(), |_| ()).unwrap().work;
    assert!(work.rejected > 5, "{work:?}");
    assert_eq!(system.kept.len() as u64, work.accepted + 1);
    assert!(system.kept.windows(2).all(|pair| pair[0] < pair[1]), "{:?}", system.kept);
    assert_eq!((system.kept[0], system.kept.last()), (0.0, Some(&2.5)));
}
