//! A map of terminal speeds over friction and inertia ratio, for each mechanism, each point solved for itself.

use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters, existence};
use geneva_kinematics::Mechanism;
use std::fs;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

/// What a map took.
#[derive(Clone, Copy)]
pub(crate) struct Taken {
    /// Points with a terminal speed.
    pub points: usize,
    pub time: Duration,
    /// Time of the processors, of all threads together, without what other programs had; none if the system does not tell.
    pub processor: Option<Duration>,
}

/// A map of `side` times `side` points for each mechanism, on threads of its own, each of which takes line after line.
pub(crate) fn map(side: u32, tolerance: f64, threads: u32) -> Taken {
    let (start, next) = (Instant::now(), AtomicU32::new(0));
    let work = || {
        let before = on_processor();
        let (mut points, lines) = (0, 3 * side);
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            let Some(mechanism) = Mechanism::ALL.get((number / side) as usize).filter(|_| number < lines) else {
                break;
            };
            points += line(*mechanism, number % side, side, tolerance).iter().filter(|speed| **speed > 0.0).count();
        }
        (points, before.and_then(|before| on_processor()?.checked_sub(before)))
    };
    let parts: Vec<_> = std::thread::scope(|scope| {
        let all: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        all.into_iter().filter_map(|thread| thread.join().ok()).collect()
    });
    let processor = parts.iter().map(|part| part.1).sum();
    Taken { points: parts.iter().map(|part| part.0).sum(), time: start.elapsed(), processor }
}

/// Mean speeds along a line of one inertia ratio between 1/32 and 2: friction from a twentieth of the critical one up.
fn line(mechanism: Mechanism, number: u32, side: u32, tolerance: f64) -> Vec<f64> {
    let inertia = libm::exp2(-5.0 + 6.0 * f64::from(number) / f64::from(side));
    let Ok(critical) = existence::critical_friction(mechanism, inertia) else { return Vec::new() };
    let speed = |column: u32| {
        let friction = critical.friction * (0.05 + 0.9 * f64::from(column) / f64::from(side));
        let inertias = Inertias::new(inertia, 1.0).ok()?;
        let escapement = Parameters::new(mechanism, inertias, 1.0, friction).ok()?;
        let engagement = Engagement::with_tolerance(&escapement, tolerance).ok()?;
        Some(engagement.reset() / engagement.entry_speed_and_period().ok()?.1)
    };
    (0..side).filter_map(speed).collect()
}

/// How long this thread has been running on a processor, by Linux.
fn on_processor() -> Option<Duration> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(Duration::from_nanos(text.split(' ').next()?.parse().ok()?))
}
