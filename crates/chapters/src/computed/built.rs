//! Of the sections on play and on what one would have to build: blows, margins against jamming, forces.

use super::kinds::QUADRATURE;
use super::most;
use super::second_routes::blow::Impact;
use super::second_routes::contact::ContactModel;
use super::second_routes::{NEWTON, NEWTON_DIFFERENCE, friction_power, steady};
use super::timer::CLEAN_AND_DRY;
use crate::questions::escapement_value;
use crate::rows::{number, number_with, numbers as of_rows, weakest as weakest_of};
use geneva_ask::escapement::{EscapementQuestion, Further};
use geneva_case1973::{Row, rows_with_least_friction, strongest, weakest};
use geneva_documents::meyer::runs::table::rows;
use geneva_evidence::{Evidence, Form, GIVEN, IntoNumbers, Numbers, OwnNumber};
use geneva_kinematics::Mechanism;

/// The numbers of these sections.
pub(super) fn numbers() -> Vec<OwnNumber> {
    vec![
        OwnNumber::new("built.radius", "{.2}&nbsp;mm", GIVEN, || Ok(RADIUS)),
        share("built.blow.share.six", Mechanism::SIX_PIN, CROSSING),
        share("built.blow.share.four", Mechanism::FOUR_PIN, CROSSING),
        share("built.blow.share.three", Mechanism::THREE_PIN, CROSSING),
        OwnNumber::new("built.blow.most", "{.0}&nbsp;%", QUADRATURE, || {
            let both = |row| Ok(100.0 * (with_play(row, PLAY, CROSSING.key)? + with_play(row, PLAY, ENTRY.key)?));
            Ok(most(&collect_numbers(weakest(rows()), both)?))
        })
        .with_second_route("wear changes the rate", NEWTON, || {
            let both =
                |row| Ok(100.0 * ((CROSSING.by_impulse)(row, PLAY)?.share + (ENTRY.by_impulse)(row, PLAY)?.share));
            Ok(most(&collect_numbers(weakest(rows()), both)?))
        }),
        OwnNumber::new("built.blow.half", Form::Range("{.1}", ""), QUADRATURE, || {
            let energy = |row, play| with_play(row, play, "crossing_energy");
            collect_numbers(weakest(rows()), |row| Ok(energy(row, PLAY)? / energy(row, PLAY / 2.0)?))
        })
        .with_second_route("less play makes a softer blow", NEWTON, || {
            collect_numbers(weakest(rows()), |row| Ok(crossing(row, PLAY)?.energy / crossing(row, PLAY / 2.0)?.energy))
        }),
        share("built.entry.six", Mechanism::SIX_PIN, ENTRY),
        share("built.entry.four", Mechanism::FOUR_PIN, ENTRY),
        share("built.entry.three", Mechanism::THREE_PIN, ENTRY),
        speed("built.blow.speed.six", Mechanism::SIX_PIN),
        speed("built.blow.speed.four", Mechanism::FOUR_PIN),
        speed("built.blow.speed.three", Mechanism::THREE_PIN),
        jam("built.jam.six", Mechanism::SIX_PIN),
        jam("built.jam.four", Mechanism::FOUR_PIN),
        jam("built.jam.three", Mechanism::THREE_PIN),
        OwnNumber::new("built.jam.exceeded", Form::Written(exceeded_words), Evidence::CLOSED_FORM, || {
            below_dry(|of| run_number(of, "critical_friction"))
        })
        .with_second_route("dry brass can jam a run", NEWTON, || below_dry(critical_friction)),
        ratio("built.ratio.six", Mechanism::SIX_PIN),
        ratio("built.ratio.four", Mechanism::FOUR_PIN),
        ratio("built.ratio.three", Mechanism::THREE_PIN),
        OwnNumber::new("built.friction", Form::Range("{.1}", "&nbsp;%"), QUADRATURE, || {
            Ok(of_rows(weakest(rows()), "friction_power")?.iter().map(|power| -1.0 / power).collect::<Vec<_>>())
        })
        .with_second_route("the friction must stay so constant", NEWTON_DIFFERENCE, || {
            collect_numbers(weakest(rows()), |row| Ok(-1.0 / friction_power(ContactModel::of_row(row))?))
        }),
        OwnNumber::new("built.force", "{.0}", QUADRATURE, || {
            Ok(most(&collect_numbers(strongest(rows()), |row| with_play(row, PLAY, "pin_force_n"))?))
        })
        .with_second_route("the pin must bear it", NEWTON, || {
            let newtons = |row| {
                Ok(IN_LB * steady(ContactModel::of_row(row), |own| Some(own.greatest_force()))? / (RADIUS / 1000.0))
            };
            Ok(most(&collect_numbers(strongest(rows()), newtons)?))
        }),
    ]
}

/// The play between pin and slot, in crank radii.
const PLAY: f64 = 0.01;
/// The crank radius in millimetres: the radius of the discs from which the thesis estimates the inertias, a quarter of an inch.
const RADIUS: f64 = 0.25 * 25.4;
/// An inch times the weight of a pound, in newton metres.
const IN_LB: f64 = 0.0254 * 4.448_221_615_260_5;

/// A blow of a pin with play: the key of the part of a beat's work that it takes, and the blow by its impulse.
#[derive(Clone, Copy)]
struct Blow {
    key: &'static str,
    by_impulse: fn(&Row, f64) -> Numbers<Impact>,
}

/// The blow where the contact changes, and the one at entry.
const CROSSING: Blow = Blow { key: "crossing_share", by_impulse: crossing };
const ENTRY: Blow = Blow { key: "entry_share", by_impulse: entry };

/// A number of a row's mechanism with this play in crank radii.
fn with_play(row: &Row, play: f64, key: &str) -> Numbers<f64> {
    let further = Further { crank_radius: Some(RADIUS), play: Some(play), ..Further::default() };
    Ok(number_with(row, |question| question.further = further, key)?)
}

/// The blow where the contact changes, from its impulse.
fn crossing(row: &Row, play: f64) -> Numbers<Impact> {
    let model = ContactModel::of_row(row);
    steady(model, |own| own.reversal().and_then(|from| model.crossing(from.angle, from.speed, play)))
}

/// The blow at entry, from its impulse.
fn entry(row: &Row, play: f64) -> Numbers<Impact> {
    let model = ContactModel::of_row(row);
    steady(model, |own| model.entry(own.squares[0].sqrt(), play))
}

/// A number of each row.
fn collect_numbers<'a, T: IntoNumbers>(
    rows: impl Iterator<Item = &'a Row>,
    of: impl Fn(&'a Row) -> Numbers<T>,
) -> Numbers<Vec<T>> {
    rows.map(of).collect()
}

/// The rows with the weakest, or with the strongest springs, of a mechanism.
fn rows_of_mechanism(
    mechanism: Mechanism,
    rows: impl Iterator<Item = &'static Row>,
) -> impl Iterator<Item = &'static Row> {
    rows.filter(move |row| row.mechanism == mechanism)
}

/// Part of a beat's work that a blow takes, in per cent, over the frictions of a mechanism.
fn share(id: &'static str, mechanism: Mechanism, blow: Blow) -> OwnNumber {
    OwnNumber::new(id, Form::Range("{.1}", "&nbsp;%"), QUADRATURE, move || {
        collect_numbers(
            rows_of_mechanism(mechanism, weakest(rows())),
            |row| Ok(100.0 * with_play(row, PLAY, blow.key)?),
        )
    })
    .with_second_route("a blow takes a part of the work", NEWTON, move || {
        collect_numbers(rows_of_mechanism(mechanism, weakest(rows())), |row| {
            Ok(100.0 * (blow.by_impulse)(row, PLAY)?.share)
        })
    })
}

/// The greatest speed with which pin and flank meet, with the strongest springs of a mechanism, in m/s.
fn speed(id: &'static str, mechanism: Mechanism) -> OwnNumber {
    OwnNumber::new(id, "{.2}&nbsp;m/s", QUADRATURE, move || {
        Ok(most(&collect_numbers(rows_of_mechanism(mechanism, strongest(rows())), |row| {
            with_play(row, PLAY, "crossing_speed_m_s")
        })?))
    })
    .with_second_route("pin and flank meet so hard", NEWTON, move || {
        let speed = |row| Ok(crossing(row, PLAY)?.closing_speed * RADIUS / 1000.0);
        Ok(most(&collect_numbers(rows_of_mechanism(mechanism, strongest(rows())), speed)?))
    })
}

/// A row of the mechanism, whatever the friction and the spring.
fn row_of(mechanism: Mechanism) -> anyhow::Result<&'static Row> {
    weakest_of(rows_with_least_friction(rows(), mechanism))
}

/// A number of the runs of a mechanism, whatever the friction and the spring.
fn run_number(mechanism: Mechanism, key: &str) -> Numbers<f64> {
    Ok(number(row_of(mechanism)?, key)?)
}

/// The friction from which the runs of a mechanism may jam, by the inertia that the driver feels.
fn critical_friction(mechanism: Mechanism) -> Numbers<f64> {
    Ok(ContactModel::of_row(row_of(mechanism)?).critical_friction())
}

/// The friction from which the runs of a mechanism may jam.
fn jam(id: &'static str, mechanism: Mechanism) -> OwnNumber {
    OwnNumber::new(id, "{.2}", Evidence::CLOSED_FORM, move || run_number(mechanism, "critical_friction"))
        .with_second_route("with more friction a run may jam", NEWTON, move || critical_friction(mechanism))
}

/// How many of the three critical frictions are below the sliding friction of clean and dry brass.
fn below_dry(critical: impl Fn(Mechanism) -> Numbers<f64>) -> Numbers<usize> {
    let all = Mechanism::ALL.into_iter().map(critical).collect::<Numbers>()?;
    Ok(all.iter().filter(|critical| **critical < CLEAN_AND_DRY[1]).count())
}

/// Of how many critical frictions a friction is above, in words.
fn exceeded_words(counts: &[f64]) -> String {
    let words = ["none of these values", "the lowest of these values", "two of these values", "all of these values"];
    counts.iter().map(|count| words[*count as usize]).collect()
}

/// The least inertia ratio with which clean and dry brass does not jam.
fn ratio(id: &'static str, mechanism: Mechanism) -> OwnNumber {
    // Asked of a driver so heavy that it runs with this friction.
    let question = EscapementQuestion {
        slots: mechanism.slots(),
        friction: CLEAN_AND_DRY[1],
        torque: 1.0,
        driver_inertia: 10.0,
        follower_inertia: 1.0,
        units: None,
        reset_deg: None,
        further: Further::default(),
    };
    OwnNumber::new(id, "{.3}", Evidence::CLOSED_FORM, move || {
        Ok(escapement_value(&question, "critical_inertia_ratio")?)
    })
    .with_second_route("a driver so heavy does not jam", NEWTON, move || {
        let model = ContactModel { friction: CLEAN_AND_DRY[1], ..ContactModel::of_row(row_of(mechanism)?) };
        Ok(model.critical_inertia_ratio())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_the_runs_only_those_with_four_pins_have_a_driver_that_is_too_light_for_dry_brass() {
        for mechanism in Mechanism::ALL {
            let least: f64 = ratio("", mechanism).show().expect("a ratio").parse().expect("a number");
            let own = run_number(mechanism, "inertia_ratio").expect("a run");
            assert_eq!(own < least, mechanism == Mechanism::FOUR_PIN);
            assert_eq!(run_number(mechanism, "critical_friction").expect("a run") < CLEAN_AND_DRY[1], own < least);
        }
    }

    #[test]
    fn a_pin_with_so_much_play_that_it_leaves_its_slot_first_has_no_blow() {
        let row = strongest(rows()).next().expect("a run");
        assert!(with_play(row, PLAY, CROSSING.key).expect("it crosses") > 0.0);
        assert!(with_play(row, 0.9, CROSSING.key).is_err());
        assert!(crossing(row, PLAY).is_ok() && crossing(row, 0.9).is_err());
    }
}
