//! Does a delay line give the value of a moment before, or say why not, and do systems that look back see what was kept
//! and nothing else?

use geneva_mimic::{
    Cause, DelayError, DelayLine, Extrapolation, IntegrationError, Interpolation, SolverParameters, System, integrate,
};
use nalgebra::{SVector, Vector1, Vector2};
use std::f64::consts::FRAC_PI_2;

/// A line with these entries, time and value.
#[track_caller]
fn line<const CAPACITY: usize>(
    (delay, initial): (f64, f64),
    (between, ahead): (Interpolation, Extrapolation),
    entries: &[(f64, f64)],
) -> DelayLine<CAPACITY> {
    let mut line = DelayLine::new(delay, initial, between, ahead).expect("a delay line");
    for &(time, value) in entries {
        line.record(time, value).expect("room");
    }
    line
}

const HOW: [(Interpolation, Extrapolation); 4] = [
    (Interpolation::Linear, Extrapolation::Hold),
    (Interpolation::Linear, Extrapolation::Linear),
    (Interpolation::Hold, Extrapolation::Hold),
    (Interpolation::Hold, Extrapolation::Linear),
];

#[test]
fn between_before_and_after_its_entries_it_reads_as_told() {
    // Entries 10 at time 0 and 12 at time 1, read half a unit late; 7 before the first.
    let times = [0.0, 0.25, 0.5, 0.75, 5.0 / 4.0, 1.5, 2.0];
    let values = [
        [7.0, 7.0, 10.0, 10.5, 11.5, 12.0, 12.0],
        [7.0, 7.0, 10.0, 10.5, 11.5, 12.0, 13.0],
        [7.0, 7.0, 10.0, 10.0, 10.0, 12.0, 12.0],
        [7.0, 7.0, 10.0, 10.0, 10.0, 12.0, 13.0],
    ];
    for (how, values) in HOW.into_iter().zip(values) {
        let line = line::<2>((0.5, 7.0), how, &[(0.0, 10.0), (1.0, 12.0)]);
        for (time, value) in times.into_iter().zip(values) {
            assert_eq!(line.value(time), Ok(value), "at {time}, {how:?}");
        }
    }
    // One entry alone says nothing of a slope, none of anything.
    let one = line::<2>((0.5, 7.0), (Interpolation::Linear, Extrapolation::Linear), &[(0.0, 10.0)]);
    assert_eq!([one.value(0.25), one.value(9.0)], [Ok(7.0), Ok(10.0)]);
    assert_eq!(line::<2>((0.5, 7.0), HOW[0], &[]).value(100.0), Ok(7.0));
}

#[test]
fn a_straight_signal_is_given_exactly_at_uneven_steps() {
    for delay in [0.25, 0.0625, 1.0, 3.0] {
        let mut line = line::<8>((delay, 1.5), (Interpolation::Linear, Extrapolation::Linear), &[(0.0, 1.5)]);
        for time in [0.125, 0.1875, 0.5, 0.53125, 1.0, 1.75, 2.0] {
            line.record(time, 1.5 - 2.0 * time).unwrap();
            for later in [0.0, 0.03125, 0.0625] {
                let then = (time + later - delay).max(0.0);
                assert_eq!(line.value(time + later), Ok(1.5 - 2.0 * then), "{delay} before {time} + {later}");
            }
        }
    }
}

#[test]
fn more_entries_than_room_are_an_error_and_change_nothing() {
    let mut line = line::<2>((1.0, 0.0), HOW[0], &[(0.0, 1.0), (0.5, 2.0)]);
    for _ in 0..3 {
        let full = line.record(0.75, 9.0).expect_err("three entries within the delay");
        assert_eq!(full, DelayError::Full { time: 0.75, oldest: 0.0, delay: 1.0, capacity: 2 });
        let message = full.to_string();
        assert!(message.contains("all 2 entries") && message.contains("larger capacity"), "{message}");
        assert_eq!(line.value(5.0 / 4.0), Ok(1.5));
    }
    // Half a unit later the first entry is not needed any more, and then it is forgotten.
    assert_eq!(line.record(1.5, 3.0), Ok(()));
    assert_eq!(line.value(1.5), Ok(2.0));
    assert_eq!(line.value(5.0 / 4.0), Err(DelayError::Forgotten { asked: 0.25, oldest: 0.5 }));
}

#[test]
fn a_long_uneven_past_is_that_of_a_list_without_end() {
    for (between, ahead) in HOW {
        let delay = 0.375;
        let mut line = line::<16>((delay, 0.0), (between, ahead), &[]);
        let mut list: Vec<(f64, f64)> = Vec::new();
        let (mut time, mut seed) = (0.0, 1_u32);
        for _ in 0..5000 {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let value = f64::from(seed >> 16);
            line.record(time, value).unwrap();
            list.push((time, value));
            for later in [0.0, 0.0625, 0.5] {
                let asked = time + later - delay;
                let next = list.iter().position(|entry| entry.0 > asked).unwrap_or(list.len());
                let on_line = |a: (f64, f64), b: (f64, f64)| a.1 + (b.1 - a.1) * (asked - a.0) / (b.0 - a.0);
                let expected = match (next, between, ahead) {
                    (0, _, _) => 0.0,
                    (next, Interpolation::Linear, _) if next < list.len() => on_line(list[next - 1], list[next]),
                    (next, _, Extrapolation::Linear) if next == list.len() && next > 1 => {
                        on_line(list[next - 2], list[next - 1])
                    }
                    (next, _, _) => list[next - 1].1,
                };
                let given = line.value(time + later).unwrap();
                assert!((given - expected).abs() <= 1e-9 * expected.abs().max(1.0), "at {time} + {later}");
            }
            time += f64::from(1 + seed % 7) / 32.0;
        }
    }
}

#[test]
fn what_cannot_be_a_delay_line_is_named() {
    let new =
        |delay, initial| DelayLine::<4>::new(delay, initial, Interpolation::Hold, Extrapolation::Hold).map(|_| ());
    for delay in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(new(delay, 0.0), Err(DelayError::Delay(delay)));
    }
    assert!(matches!(new(f64::NAN, 0.0), Err(DelayError::Delay(_))));
    assert_eq!(new(1.0, f64::INFINITY), Err(DelayError::Initial(f64::INFINITY)));
    let one = DelayLine::<1>::new(1.0, 0.0, Interpolation::Hold, Extrapolation::Hold);
    assert_eq!(one.map(|_| ()), Err(DelayError::Capacity(1)));
    let none = DelayLine::<0>::new(1.0, 0.0, Interpolation::Hold, Extrapolation::Hold);
    assert!(none.expect_err("no room").to_string().contains("at least 2"));

    let mut line = line::<4>((1.0, 0.0), (Interpolation::Hold, Extrapolation::Hold), &[]);
    assert_eq!(line.record(f64::NEG_INFINITY, 1.0), Err(DelayError::Time(f64::NEG_INFINITY)));
    line.record(2.0, 1.0).unwrap();
    for time in [2.0, 1.0] {
        assert_eq!(line.record(time, 1.0), Err(DelayError::Order { asked: time, latest: 2.0 }));
    }
    assert!(matches!(line.record(f64::NAN, 1.0), Err(DelayError::Time(_))));
    assert!(matches!(line.record(3.0, f64::NAN), Err(DelayError::Value { time: 3.0, .. })));
    assert!(matches!(line.value(f64::NAN), Err(DelayError::Time(_))));
    assert_eq!(line.value(3.0), Ok(1.0), "none of these was entered");
}

/// x'(t) = −x(t − 1), with x = 1 until time 0.
struct Memory<const CAPACITY: usize>(DelayLine<CAPACITY>);

impl<const CAPACITY: usize> Memory<CAPACITY> {
    fn new(interpolation: Interpolation) -> Self {
        Self(line((1.0, 1.0), (interpolation, Extrapolation::Hold), &[]))
    }
}

impl<const CAPACITY: usize> System<1> for Memory<CAPACITY> {
    type Fault = DelayError;

    fn derivative(&mut self, time: f64, _: &Vector1<f64>) -> Result<Vector1<f64>, DelayError> {
        Ok(Vector1::new(-self.0.value(time)?))
    }

    fn accepted(&mut self, time: f64, state: &Vector1<f64>, _: &Vector1<f64>) -> Result<(), DelayError> {
        self.0.record(time, state[0])
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
    for (between, order) in [(Interpolation::Linear, 2.0), (Interpolation::Hold, 1.0)] {
        let error = |steps: f64| {
            let fixed = SolverParameters::with_fixed_step(1.0 / steps, 0.5, 5.0);
            let mut worst: f64 = 0.0;
            let end = integrate(&mut Memory::<200>::new(between), Vector1::new(1.0), &fixed, |point| {
                worst = worst.max((point.state[0] - memory_exact(point.time)).abs());
            });
            end.unwrap();
            worst
        };
        let observed = libm::log2(error(32.0) / error(64.0));
        assert!((observed - order).abs() < 0.1, "{between:?}: {observed}");
    }
}

#[test]
fn the_error_test_does_not_see_how_the_past_is_read() {
    // Straight lines between entries half a unit apart: integrated without a difference, and far from the solution.
    let run = |largest_step| {
        let parameters =
            SolverParameters { largest_step, initial_step: largest_step, ..SolverParameters::new(0.5, 5.0) };
        let end =
            integrate(&mut Memory::<200>::new(Interpolation::Linear), Vector1::new(1.0), &parameters, |_| ()).unwrap();
        (end.work, (end.last.state[0] - memory_exact(5.0)).abs())
    };
    let ((work, blind), (_, close)) = (run(0.5), run(1.0 / 128.0));
    assert_eq!((work.accepted, work.rejected), (10, 0));
    assert!(blind > 1e-3 && close < 1e-5, "{blind} and {close}");
}

#[test]
fn a_line_without_room_stops_the_run_where_it_is_full() {
    let parameters = SolverParameters::with_fixed_step(1.0 / 128.0, 1.0, 2.0);
    let error = integrate(&mut Memory::<100>::new(Interpolation::Linear), Vector1::new(1.0), &parameters, |_| ());
    let Err(IntegrationError::EarlyStop(stopped)) = error else { panic!("{error:?}") };
    assert_eq!(stopped.time, 100.0 / 128.0);
    let Cause::System(DelayError::Full { time, capacity: 100, .. }) = stopped.cause else { panic!("{stopped}") };
    assert_eq!(time, stopped.time);
    assert!(stopped.to_string().contains("stopped at time 0.78125"), "{stopped}");
}

/// (1 + s/2) x'' = cos t, with s the sign that x'' had a moment before: a load that drags one way and helps the other.
struct LaggedSign {
    old_acceleration: DelayLine<100>,
    kept: Vec<f64>,
}

impl LaggedSign {
    fn new(delay: f64) -> Self {
        Self {
            old_acceleration: line((delay, 1.0), (Interpolation::Linear, Extrapolation::Hold), &[]),
            kept: Vec::new(),
        }
    }
}

impl System<2> for LaggedSign {
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

#[test]
fn a_sign_read_late_changes_late_by_the_delay() {
    // Speed at time 2.5 if the sign changes at this time: gains count two thirds, losses twice.
    let speed_with_change_at = |change: f64| libm::sin(change) / 1.5 + (libm::sin(2.5) - libm::sin(change)) / 0.5;
    let speed = |delay, parameters: &SolverParameters| {
        integrate(&mut LaggedSign::new(delay), SVector::zeros(), parameters, |_| ()).unwrap().last.state[1]
    };
    for delay in [0.05, 0.1, 0.2] {
        let (late, at_once) = (speed_with_change_at(FRAC_PI_2 + delay), speed_with_change_at(FRAC_PI_2));
        let step = 1.0 / 256.0;
        let fixed = speed(delay, &SolverParameters::with_fixed_step(step, 0.5, 2.5));
        // A step too early or late, the acceleration jumps there by 4/3 sin of the delay.
        assert!((fixed - late).abs() < step * 4.0 / 3.0 * libm::sin(delay), "delay {delay}: {fixed} for {late}");
        assert!((fixed - at_once).abs() > 0.9 * (late - at_once).abs(), "delay {delay}: {fixed} for {at_once}");
        let tolerant = speed(delay, &tolerant());
        assert!((tolerant - late).abs() < 1e-5, "delay {delay}: {tolerant} for {late}");
    }
}

/// No step longer than the shortest delay: the sign is not read ahead of what was kept, and the entries are close.
fn tolerant() -> SolverParameters {
    SolverParameters { largest_step: 0.05, initial_step: 0.05, ..SolverParameters::new(0.5, 2.5) }
}

#[test]
fn refused_steps_leave_no_trace_in_the_past() {
    let mut system = LaggedSign::new(0.05);
    let work = integrate(&mut system, SVector::zeros(), &tolerant(), |_| ()).unwrap().work;
    assert!(work.rejected > 5, "{work:?}");
    assert_eq!(system.kept.len() as u64, work.accepted + 1);
    assert!(system.kept.windows(2).all(|pair| pair[0] < pair[1]), "{:?}", system.kept);
    assert_eq!((system.kept[0], system.kept.last()), (0.0, Some(&2.5)));
}
