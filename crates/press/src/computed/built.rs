//! Of the sections on play and on what one would have to build: blows, margins against jamming, forces.

use super::escapement::over;
use super::timer::CLEAN_AND_DRY;
use super::{Number, most};
use crate::numbers::fixed;
use crate::rows::{parameters, weakest as weakest_of};
use anyhow::Context;
use geneva_dynamics::existence::critical_friction;
use geneva_dynamics::timer::{Accelerations, Crossing, EntryBlow, Sensitivities};
use geneva_kinematics::Mechanism;
use geneva_ledger::meyer::runs::choice::{least_braked, strongest, weakest};

/// The numbers of these sections.
pub const NUMBERS: &[(&str, Number)] = &[
    ("built.radius", || Ok(format!("{}&nbsp;mm", fixed(1000.0 * RADIUS, 2)))),
    ("built.blow.share.six", || shares(Mechanism::SIX_PIN)),
    ("built.blow.share.four", || shares(Mechanism::FOUR_PIN)),
    ("built.blow.share.three", || shares(Mechanism::THREE_PIN)),
    ("built.blow.most", || {
        let all = weakest().map(|row| {
            let of = parameters(row)?;
            Ok(100.0 * (crossing(&of, PLAY)?.share + EntryBlow::new(&of, PLAY)?.share))
        });
        Ok(format!("{}&nbsp;%", fixed(most(&all.collect::<anyhow::Result<Vec<_>>>()?), 0)))
    }),
    ("built.blow.half", || {
        let quotient = |row| {
            let of = parameters(row)?;
            Ok(crossing(&of, PLAY)?.energy / crossing(&of, PLAY / 2.0)?.energy)
        };
        over(weakest().map(quotient), 1)
    }),
    ("built.entry.six", || entries(Mechanism::SIX_PIN)),
    ("built.entry.four", || entries(Mechanism::FOUR_PIN)),
    ("built.entry.three", || entries(Mechanism::THREE_PIN)),
    ("built.blow.speed.six", || speed(Mechanism::SIX_PIN)),
    ("built.blow.speed.four", || speed(Mechanism::FOUR_PIN)),
    ("built.blow.speed.three", || speed(Mechanism::THREE_PIN)),
    ("built.jam.six", || jam(Mechanism::SIX_PIN)),
    ("built.jam.four", || jam(Mechanism::FOUR_PIN)),
    ("built.jam.three", || jam(Mechanism::THREE_PIN)),
    ("built.jam.exceeded", exceeded),
    ("built.ratio.six", || ratio(Mechanism::SIX_PIN)),
    ("built.ratio.four", || ratio(Mechanism::FOUR_PIN)),
    ("built.ratio.three", || ratio(Mechanism::THREE_PIN)),
    ("built.ratio-run.six", || Ok(fixed(run_ratio(Mechanism::SIX_PIN)?, 3))),
    ("built.ratio-run.four", || Ok(fixed(run_ratio(Mechanism::FOUR_PIN)?, 3))),
    ("built.ratio-run.three", || Ok(fixed(run_ratio(Mechanism::THREE_PIN)?, 3))),
    ("built.friction", || {
        let all = weakest().map(|row| Ok(-1.0 / Sensitivities::new(&parameters(row)?)?.friction));
        Ok(over(all, 1)? + "&nbsp;%")
    }),
    ("built.force", || {
        // The moment over the crank radius; the torques of the thesis are in in lb.
        let newtons = strongest().map(|row| {
            let moment = Accelerations::new(&parameters(row)?)?.normal_moment.value.abs();
            Ok(moment * INCH * POUND_FORCE / RADIUS)
        });
        Ok(fixed(most(&newtons.collect::<anyhow::Result<Vec<_>>>()?), 0))
    }),
];

/// The play between pin and slot, in crank radii.
const PLAY: f64 = 0.01;
/// The inch in metres and the pound-force in newtons, by definition.
const INCH: f64 = 0.0254;
const POUND_FORCE: f64 = 4.448_221_615_260_5;
/// The crank radius in metres: the radius of the discs from which the thesis estimates the inertias, a quarter of an inch.
const RADIUS: f64 = 0.25 * INCH;

fn crossing(of: &geneva_dynamics::Parameters, play: f64) -> anyhow::Result<Crossing> {
    Crossing::new(of, play)?.context("the pin does not cross its play")
}

/// Part of a beat's work that the blow takes, in per cent, over the frictions of a mechanism.
fn shares(mechanism: Mechanism) -> anyhow::Result<String> {
    let own = weakest().filter(|row| row.mechanism == mechanism);
    Ok(over(own.map(|row| Ok(100.0 * crossing(&parameters(row)?, PLAY)?.share)), 1)? + "&nbsp;%")
}

/// Part of a beat's work that the blow at entry takes, in per cent, over the frictions of a mechanism.
fn entries(mechanism: Mechanism) -> anyhow::Result<String> {
    let own = weakest().filter(|row| row.mechanism == mechanism);
    Ok(over(own.map(|row| Ok(100.0 * EntryBlow::new(&parameters(row)?, PLAY)?.share)), 1)? + "&nbsp;%")
}

/// The greatest speed with which pin and flank meet, with the strongest springs of a mechanism, in m/s.
fn speed(mechanism: Mechanism) -> anyhow::Result<String> {
    let own = strongest().filter(|row| row.mechanism == mechanism);
    let speeds = own.map(|row| Ok(RADIUS * crossing(&parameters(row)?, PLAY)?.closing_speed));
    Ok(format!("{}&nbsp;m/s", fixed(most(&speeds.collect::<anyhow::Result<Vec<_>>>()?), 2)))
}

/// Driver's moment of inertia over the follower's in the runs of a mechanism.
fn run_ratio(mechanism: Mechanism) -> anyhow::Result<f64> {
    Ok(parameters(weakest_of(least_braked(mechanism))?)?.inertias().ratio())
}

fn critical(mechanism: Mechanism) -> anyhow::Result<f64> {
    Ok(critical_friction(mechanism, run_ratio(mechanism)?)?.friction)
}

/// The friction from which the runs of a mechanism may jam.
fn jam(mechanism: Mechanism) -> anyhow::Result<String> {
    Ok(fixed(critical(mechanism)?, 2))
}

/// How many of the three critical frictions are below the sliding friction of clean and dry brass, in words.
fn exceeded() -> anyhow::Result<String> {
    let all = Mechanism::ALL.map(critical).into_iter().collect::<anyhow::Result<Vec<_>>>()?;
    let count = all.iter().filter(|critical| **critical < CLEAN_AND_DRY[1]).count();
    let words = ["none of these values", "the lowest of these values", "two of these values", "all of these values"];
    Ok(words[count].to_owned())
}

/// The least inertia ratio with which clean and dry brass does not jam.
fn ratio(mechanism: Mechanism) -> anyhow::Result<String> {
    // The critical friction grows with the driver's inertia.
    let (mut low, mut high) = (1e-6, 10.0);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if critical_friction(mechanism, middle)?.friction < CLEAN_AND_DRY[1] { low = middle } else { high = middle }
    }
    Ok(fixed(high, 3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_ratio_is_where_dry_brass_becomes_critical_and_jams_grow_rarer_with_it() {
        for mechanism in Mechanism::ALL {
            let least: f64 = ratio(mechanism).expect("a ratio").parse().expect("a number");
            let at = |ratio: f64| critical_friction(mechanism, ratio).expect("a limit").friction;
            assert!(at(0.9 * least) < CLEAN_AND_DRY[1] && at(1.1 * least) > CLEAN_AND_DRY[1], "{mechanism:?}");
            // Of the runs only those with four pins have a driver that is too light for dry brass.
            assert_eq!(run_ratio(mechanism).expect("a run") < least, mechanism == Mechanism::FOUR_PIN);
            assert!([0.01, 0.03, 0.1, 0.3, 1.0].map(at).is_sorted());
        }
    }

    #[test]
    fn a_blow_at_a_given_radius_is_that_of_the_crossing() {
        let row = strongest().next().expect("a run");
        let of = parameters(row).expect("an escapement");
        let found = crossing(&of, PLAY).expect("it crosses");
        let inertias = of.inertias();
        // The blow cannot take more than the whole kinetic energy before it.
        let energy =
            inertias.driver() * found.driver_speed.powi(2) + inertias.follower() * found.follower_speed.powi(2);
        assert!(found.energy > 0.0 && found.energy < energy / 2.0);
        assert!(found.closing_speed > 0.0 && crossing(&of, 5.0).is_err());
    }
}
