//! A map of terminal speeds over friction and inertia ratio, for each mechanism, each point solved for itself.

use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters, Slots, existence};
use std::time::{Duration, Instant};

/// How long a map of `side` times `side` points for each mechanism takes on threads of its own, and how many points it
/// has: those without a terminal speed do not count.
pub fn map(side: u32, tolerance: f64, threads: u32) -> (usize, Duration) {
    let start = Instant::now();
    let points = std::thread::scope(|scope| {
        let part = |first: u32| move || Slots::ALL.map(|slots| lines(slots, side, tolerance, first, threads));
        let all: Vec<_> = (0..threads).map(|first| scope.spawn(part(first))).collect();
        all.into_iter().filter_map(|thread| thread.join().ok()).flatten().flatten().filter(|speed| *speed > 0.0).count()
    });
    (points, start.elapsed())
}

/// Mean speeds of every so many lines: friction from a twentieth of the critical one up, inertia ratio from 1/32 to 2.
fn lines(slots: Slots, side: u32, tolerance: f64, first: u32, every: u32) -> Vec<f64> {
    let mut speeds = Vec::new();
    for line in (first..side).step_by(every as usize) {
        let inertia = libm::exp2(-5.0 + 6.0 * f64::from(line) / f64::from(side));
        let Ok(critical) = existence::critical_friction(slots, inertia) else { continue };
        speeds.extend((0..side).filter_map(|column| {
            let friction = critical.friction * (0.05 + 0.9 * f64::from(column) / f64::from(side));
            let inertias = Inertias::new(inertia, 1.0).ok()?;
            let escapement = Parameters::new(slots, inertias, 1.0, friction).ok()?;
            let terminal = Engagement::with_tolerance(&escapement, tolerance).ok()?.terminal().ok()?;
            Some(terminal.mean_speed)
        }));
    }
    speeds
}
