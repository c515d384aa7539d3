//! Of the sections on play and on what one would have to build: blows, margins against jamming, forces.

use super::timer::CLEAN_AND_DRY;
use super::{Number, most, over};
use crate::asked::value;
use crate::numbers::fixed;
use crate::rows::{number, number_with, numbers, weakest as weakest_of};
use geneva_case1973::{Row, rows_with_least_friction, strongest, weakest};
use geneva_documents::meyer::runs::table::rows;
use geneva_kinematics::Mechanism;

/// The numbers of these sections.
pub const NUMBERS: &[(&str, Number)] = &[
    ("built.radius", || Ok(format!("{}&nbsp;mm", fixed(RADIUS, 2)))),
    ("built.blow.share.six", || shares(Mechanism::SIX_PIN, CROSSING)),
    ("built.blow.share.four", || shares(Mechanism::FOUR_PIN, CROSSING)),
    ("built.blow.share.three", || shares(Mechanism::THREE_PIN, CROSSING)),
    ("built.blow.most", || {
        let both = |row| Ok(100.0 * (with_play(row, PLAY, CROSSING)? + with_play(row, PLAY, ENTRY)?));
        Ok(format!("{}&nbsp;%", fixed(most(&all(weakest(rows()), both)?), 0)))
    }),
    ("built.blow.half", || {
        let energy = |row, play| with_play(row, play, "crossing_energy");
        over(&all(weakest(rows()), |row| Ok(energy(row, PLAY)? / energy(row, PLAY / 2.0)?))?, 1)
    }),
    ("built.entry.six", || shares(Mechanism::SIX_PIN, ENTRY)),
    ("built.entry.four", || shares(Mechanism::FOUR_PIN, ENTRY)),
    ("built.entry.three", || shares(Mechanism::THREE_PIN, ENTRY)),
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
    ("built.friction", || {
        let powers: Vec<f64> = numbers(weakest(rows()), "friction_power")?.iter().map(|power| -1.0 / power).collect();
        Ok(over(&powers, 1)? + "&nbsp;%")
    }),
    ("built.force", || Ok(fixed(most(&all(strongest(rows()), |row| with_play(row, PLAY, "pin_force_n"))?), 0))),
];

/// The play between pin and slot, in crank radii.
const PLAY: f64 = 0.01;
/// The crank radius in millimetres: the radius of the discs from which the thesis estimates the inertias, a quarter of an inch.
const RADIUS: f64 = 0.25 * 25.4;
/// Parts of a beat's work that the blows take where the contact changes and at entry.
const CROSSING: &str = "crossing_share";
const ENTRY: &str = "entry_share";

/// A number of a row's mechanism with this play in crank radii.
fn with_play(row: &Row, play: f64, key: &str) -> anyhow::Result<f64> {
    number_with(row, &format!("--crank-radius {RADIUS} --play {play}"), key)
}

/// A number of each row.
fn all<'a>(
    rows: impl Iterator<Item = &'a Row>,
    of: impl Fn(&'a Row) -> anyhow::Result<f64>,
) -> anyhow::Result<Vec<f64>> {
    rows.map(of).collect()
}

/// Part of a beat's work that a blow takes, in per cent, over the frictions of a mechanism.
fn shares(mechanism: Mechanism, blow: &str) -> anyhow::Result<String> {
    let own = weakest(rows()).filter(|row| row.mechanism == mechanism);
    Ok(over(&all(own, |row| Ok(100.0 * with_play(row, PLAY, blow)?))?, 1)? + "&nbsp;%")
}

/// The greatest speed with which pin and flank meet, with the strongest springs of a mechanism, in m/s.
fn speed(mechanism: Mechanism) -> anyhow::Result<String> {
    let own = strongest(rows()).filter(|row| row.mechanism == mechanism);
    let speeds = all(own, |row| with_play(row, PLAY, "crossing_speed_m_s"))?;
    Ok(format!("{}&nbsp;m/s", fixed(most(&speeds), 2)))
}

/// A number of the runs of a mechanism, whatever the friction and the spring.
fn run(mechanism: Mechanism, key: &str) -> anyhow::Result<f64> {
    number(weakest_of(rows_with_least_friction(rows(), mechanism))?, key)
}

/// The friction from which the runs of a mechanism may jam.
fn jam(mechanism: Mechanism) -> anyhow::Result<String> {
    Ok(fixed(run(mechanism, "critical_friction")?, 2))
}

/// How many of the three critical frictions are below the sliding friction of clean and dry brass, in words.
fn exceeded() -> anyhow::Result<String> {
    let all = Mechanism::ALL.map(|of| run(of, "critical_friction")).into_iter().collect::<anyhow::Result<Vec<_>>>()?;
    let count = all.iter().filter(|critical| **critical < CLEAN_AND_DRY[1]).count();
    let words = ["none of these values", "the lowest of these values", "two of these values", "all of these values"];
    Ok(words[count].to_owned())
}

/// The least inertia ratio with which clean and dry brass does not jam.
fn ratio(mechanism: Mechanism) -> anyhow::Result<String> {
    // Asked of a driver so heavy that it runs with this friction.
    let question = format!(
        "escapement --slots {} --friction {} --torque 1 --driver-inertia 10 --follower-inertia 1",
        mechanism.slots(),
        CLEAN_AND_DRY[1]
    );
    Ok(fixed(value(&question, "critical_inertia_ratio")?, 3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_the_runs_only_those_with_four_pins_have_a_driver_that_is_too_light_for_dry_brass() {
        for mechanism in Mechanism::ALL {
            let least: f64 = ratio(mechanism).expect("a ratio").parse().expect("a number");
            let own = run(mechanism, "inertia_ratio").expect("a run");
            assert_eq!(own < least, mechanism == Mechanism::FOUR_PIN);
            assert_eq!(run(mechanism, "critical_friction").expect("a run") < CLEAN_AND_DRY[1], own < least);
        }
    }

    #[test]
    fn a_pin_with_so_much_play_that_it_leaves_its_slot_first_has_no_blow() {
        let row = strongest(rows()).next().expect("a run");
        assert!(with_play(row, PLAY, CROSSING).expect("it crosses") > 0.0);
        assert!(with_play(row, 0.9, CROSSING).is_err());
    }
}
