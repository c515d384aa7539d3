//! Does a delay line give the value of a moment before, or say why not?

use geneva_mimic::{Ahead, Between, DelayError, DelayLine};

/// Times at uneven distances, all representable.
const TIMES: [f64; 8] = [0.0, 0.125, 0.1875, 0.5, 0.53125, 1.0, 1.75, 2.0];

fn filled<const CAPACITY: usize>(
    mut line: DelayLine<CAPACITY>,
    value: impl Fn(f64) -> f64,
) -> Result<DelayLine<CAPACITY>, DelayError> {
    for time in TIMES {
        line.record(time, value(time))?;
    }
    Ok(line)
}

#[test]
fn a_straight_signal_is_given_exactly_at_uneven_steps() {
    for delay in [0.25, 0.0625, 1.0, 3.0] {
        let line = DelayLine::<8>::new(delay, 1.5, Between::Linear, Ahead::Line).unwrap();
        let mut line = line;
        for time in TIMES {
            line.record(time, 1.5 - 2.0 * time).unwrap();
            for later in [0.0, 0.03125, 0.0625] {
                let then = (time + later - delay).max(0.0);
                // One entry alone says nothing of a slope.
                let then = if time == 0.0 { 0.0 } else { then };
                assert_eq!(line.value(time + later), Ok(1.5 - 2.0 * then), "{delay} before {time} + {later}");
            }
        }
    }
}

#[test]
fn held_signals_go_in_stairs() {
    let line = DelayLine::<8>::new(0.5, -1.0, Between::Hold, Ahead::Hold).unwrap();
    let mut line = line;
    line.record(0.0, 10.0).unwrap();
    line.record(1.0, 11.0).unwrap();
    for (time, value) in [(1.0, 10.0), (5.0 / 4.0, 10.0), (1.5, 11.0), (2.0, 11.0), (9.0, 11.0)] {
        assert_eq!(line.value(time), Ok(value), "at {time}");
    }
}

#[test]
fn ahead_of_the_latest_entry_it_holds_or_goes_straight_on_as_told() {
    for between in [Between::Linear, Between::Hold] {
        for (ahead, expected) in [(Ahead::Hold, 3.0), (Ahead::Line, 5.0)] {
            let mut line = DelayLine::<4>::new(0.25, 0.0, between, ahead).unwrap();
            line.record(0.0, 1.0).unwrap();
            line.record(1.0, 3.0).unwrap();
            assert_eq!(line.value(5.0 / 4.0), Ok(3.0), "at the entry itself");
            assert_eq!(line.value(2.25), Ok(expected));
        }
    }
}

#[test]
fn before_the_first_entry_it_has_the_initial_value() {
    let mut line = DelayLine::<2>::new(2.0, 7.0, Between::Linear, Ahead::Hold).unwrap();
    assert_eq!(line.value(100.0), Ok(7.0), "no entry at all");
    line.record(1.0, -3.0).unwrap();
    line.record(2.0, -4.0).unwrap();
    for (time, value) in [(2.0, 7.0), (2.96875, 7.0), (3.0, -3.0), (3.5, -3.5), (4.0, -4.0)] {
        assert_eq!(line.value(time), Ok(value), "at {time}");
    }
}

#[test]
fn more_entries_than_room_are_an_error_and_change_nothing() {
    let line = DelayLine::<7>::new(2.5, 0.0, Between::Linear, Ahead::Hold).unwrap();
    let full = filled(line, |time| time).expect_err("eight entries within the delay");
    assert_eq!(full, DelayError::Full { time: 2.0, oldest: 0.0, delay: 2.5, capacity: 7 });
    let message = full.to_string();
    assert!(message.contains("all 7 entries") && message.contains("larger capacity"), "{message}");

    let mut line = DelayLine::<2>::new(1.0, 0.0, Between::Linear, Ahead::Hold).unwrap();
    line.record(0.0, 1.0).unwrap();
    line.record(0.5, 2.0).unwrap();
    for _ in 0..3 {
        assert!(matches!(line.record(0.75, 9.0), Err(DelayError::Full { .. })));
        assert_eq!(line.value(5.0 / 4.0), Ok(1.5));
    }
    // Half a unit later the first entry is not needed any more.
    assert_eq!(line.record(1.5, 3.0), Ok(()));
    assert_eq!(line.value(1.5), Ok(2.0));
}

#[test]
fn what_has_made_room_is_not_taken_for_what_never_was() {
    let line = filled(DelayLine::<8>::new(0.25, 0.0, Between::Linear, Ahead::Hold).unwrap(), |time| time).unwrap();
    assert_eq!(line.value(2.0), Ok(1.75));
    assert_eq!(line.value(1.5), Err(DelayError::Forgotten { asked: 5.0 / 4.0, oldest: 1.75 }));
}

#[test]
fn a_long_uneven_past_is_that_of_a_list_without_end() {
    for (between, ahead) in [(Between::Linear, Ahead::Hold), (Between::Hold, Ahead::Line)] {
        let delay = 0.375;
        let mut line = DelayLine::<16>::new(delay, 0.0, between, ahead).unwrap();
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
                    (next, Between::Linear, _) if next < list.len() => on_line(list[next - 1], list[next]),
                    (next, _, Ahead::Line) if next == list.len() && next > 1 => on_line(list[next - 2], list[next - 1]),
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
    let new = |delay, initial| DelayLine::<4>::new(delay, initial, Between::Hold, Ahead::Hold).map(|_| ());
    for delay in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(new(delay, 0.0), Err(DelayError::Delay(delay)));
    }
    assert!(matches!(new(f64::NAN, 0.0), Err(DelayError::Delay(_))));
    assert_eq!(new(1.0, f64::INFINITY), Err(DelayError::Value { asked: f64::INFINITY, time: None }));
    let one = DelayLine::<1>::new(1.0, 0.0, Between::Hold, Ahead::Hold);
    assert_eq!(one.map(|_| ()), Err(DelayError::Capacity(1)));
    let none = DelayLine::<0>::new(1.0, 0.0, Between::Hold, Ahead::Hold);
    assert!(none.expect_err("no room").to_string().contains("at least 2"));

    let mut line = DelayLine::<4>::new(1.0, 0.0, Between::Hold, Ahead::Hold).unwrap();
    assert_eq!(line.record(f64::NEG_INFINITY, 1.0), Err(DelayError::Time { asked: f64::NEG_INFINITY, latest: None }));
    line.record(2.0, 1.0).unwrap();
    for time in [2.0, 1.0] {
        assert_eq!(line.record(time, 1.0), Err(DelayError::Time { asked: time, latest: Some(2.0) }));
    }
    assert!(matches!(line.record(f64::NAN, 1.0), Err(DelayError::Time { .. })));
    assert!(matches!(line.record(3.0, f64::NAN), Err(DelayError::Value { time: Some(3.0), .. })));
    assert!(matches!(line.value(f64::NAN), Err(DelayError::Time { .. })));
    assert_eq!(line.value(3.0), Ok(1.0), "none of these was entered");
}
