//! Of the program: what it gives of the thesis's tables, and what its reset after a quarter of a turn does to six and to
//! three pins.

use super::kinds::{PRINTOUT, PROGRAM, QUADRATURE, VECTORS};
use super::second_routes::NEWTON;
use super::second_routes::contact::ContactModel;
use super::second_routes::printed_rows::{count_near, rows_with_listed_lag};
use crate::rows::NONE;
use anyhow::Context;
use geneva_case1973::deck::{deck, listed_settings, longer_than_delay, turned_when_backwards};
use geneva_case1973::{Column, Constants, Hypothesis, Reset, Row, Run};
use geneva_documents::meyer::runs::study::by_deck;
use geneva_documents::meyer::runs::table::{listing, rows};
use geneva_evidence::{Evidence, Form, Numbers, OwnNumber};
use geneva_kinematics::Mechanism;
use geneva_mimic::language::{CardLayout, Deck, Program, deck_named};
use geneva_press::book::MakeText;

/// The numbers of the chapter on the program.
pub(super) fn numbers() -> Vec<OwnNumber> {
    vec![
        OwnNumber::count("program.statements", || Ok(own_deck_program()?.execution_order().len())),
        OwnNumber::count("program.needless", || {
            Ok(own_deck_program()?.execution_order().iter().filter(|statement| statement.is_dead).count())
        }),
        OwnNumber::count("program.four-pin.runs", || Ok(rows_with(true).count())),
        count_with_own_reset("program.four-pin.minima", true, Column::Minimum),
        count_with_own_reset("program.four-pin.periods", true, Column::Period),
        count_with_own_reset("program.four-pin.peaks", true, Column::Peak),
        OwnNumber::count("program.other-pins.runs", || Ok(rows_with(false).count())),
        count_with_own_reset("program.other-pins.minima", false, Column::Minimum),
        count_with_own_reset("program.other-pins.periods", false, Column::Period),
        count_with_own_reset("program.other-pins.peaks", false, Column::Peak),
        count_without_delay("program.no-delay.minima", Column::Minimum),
        count_without_delay("program.no-delay.periods", Column::Period),
        count_without_delay("program.no-delay.peaks", Column::Peak),
        OwnNumber::new("program.long-steps", Form::Range("{.0}", "&nbsp;%"), PROGRAM, || {
            let parts = longer_than_delay(rows()).context("the escapement's deck does not run")?;
            Ok(parts.iter().map(|part| 100.0 * part).collect::<Vec<_>>())
        }),
        OwnNumber::new("program.backwards-after", "{.1}°", PRINTOUT, || {
            let row = rows().first().context("there is no run")?;
            let turned = turned_when_backwards(row, &listed_settings(&listing()));
            Ok(turned.context("the follower never runs backwards")?.to_degrees())
        })
        .with_second_route("the follower runs backwards", PRINTOUT, || {
            // By the program translated by hand, which knows nothing of decks.
            let row = rows().first().context("there is no run")?;
            let lines = Hypothesis::AS_RUN.printout(row).context(NONE)?.lines;
            let backwards = lines.iter().find(|line| line.follower_speed < 0.0);
            Ok(backwards.context("the follower never runs backwards")?.turned.to_degrees())
        }),
        ratio_at_the_reset("program.three-at-the-reset", Mechanism::THREE_PIN, "the follower is still turning", 1.0),
        ratio_at_the_reset("program.six-at-the-reset", Mechanism::SIX_PIN, "the follower runs backwards", -1.0),
    ]
}

/// The names of the loop.
pub(super) const WORDS: &[(&str, MakeText)] = &[("program.loop", || loop_without_delay(OLD_ACCELERATION))];

/// The old acceleration in the escapement's deck.
const OLD_ACCELERATION: &str = "TDL(ACCEL,DT/10.,100.)";

/// The escapement's deck as it stands.
fn own_deck_program() -> Numbers<Program> {
    Ok(Program::new(&deck(&[]).context("there is no such deck")?)?)
}

/// The names in the circle that the deck has without its delay.
fn loop_without_delay(delay: &str) -> anyhow::Result<String> {
    let cards = deck_named("escapement").context("there is no such deck")?.replace(delay, "ACCEL");
    let faults =
        Program::new(&Deck::read(&cards, CardLayout::detect(&cards))?).err().context("the deck can be sorted")?;
    let told = faults.to_string();
    let (_, from) = told.split_once("loop: ").context("the fault is no loop")?;
    let (names, _) = from.split_once(';').context("the fault tells no names")?;
    Ok(names.replace(' ', "&nbsp;").replace("&nbsp;→", " →"))
}

/// The printed rows of four pins, which the thesis's reset suits, or those of the others.
fn rows_with(four_pins: bool) -> impl Iterator<Item = &'static Row> {
    rows().iter().filter(move |row| (row.mechanism == Mechanism::FOUR_PIN) == four_pins)
}

/// In how many rows a column comes within one unit of the last printed place.
fn within_one<'a>(column: Column, runs: impl Iterator<Item = (&'a Row, Option<Run>)>) -> usize {
    let is_near = |row: &Row, run: &Run| column.is_within_one(row.number(column), run.number(column));
    runs.filter(|(row, run)| run.as_ref().is_some_and(|run| is_near(row, run))).count()
}

/// Reproduced rows by the deck as it stands: each mechanism's own angle from pin to pin.
fn count_with_own_reset(id: &'static str, four_pins: bool, column: Column) -> OwnNumber {
    const OWN_RESET: Hypothesis =
        Hypothesis { reset: Reset::OfTheMechanism, constants: Constants::Exact, ..Hypothesis::AS_RUN };
    OwnNumber::new(id, "{.0}", PROGRAM, move || {
        let runs = by_deck(Reset::OfTheMechanism).context("the escapement's deck does not run")?;
        let all = rows().iter().zip(runs.iter().copied().map(Some));
        Ok(within_one(column, all.filter(|(row, _)| (row.mechanism == Mechanism::FOUR_PIN) == four_pins)))
    })
    .with_second_route("the right card explains four pins only", NEWTON, move || {
        let all = rows_with_listed_lag(OWN_RESET);
        Ok(count_near(all.filter(|(row, _)| (row.mechanism == Mechanism::FOUR_PIN) == four_pins), &[column]))
    })
}

/// Reproduced rows by the program translated by hand, with the sign of the acceleration itself.
fn count_without_delay(id: &'static str, column: Column) -> OwnNumber {
    let hypothesis = Hypothesis { constants: Constants::AsListed, ..Hypothesis::WITHOUT_LAG };
    OwnNumber::new(id, "{.0}", PROGRAM, move || {
        Ok(within_one(column, rows().iter().map(|row| (row, hypothesis.run(row)))))
    })
    // The listed π changes no such count.
    .with_second_route("the delay was not necessary", QUADRATURE, move || {
        Ok(count_near(rows().iter().map(|row| (row, Hypothesis::WITHOUT_LAG.results(row))), &[column]))
    })
}

/// The follower's speed over the driver's where the program lets go of the pin, times a sign.
fn ratio_at_the_reset(id: &'static str, mechanism: Mechanism, conclusion: &'static str, sign: f64) -> OwnNumber {
    OwnNumber::new(id, "{.2}", Evidence::CLOSED_FORM, move || Ok(sign * listing().velocity_ratio_at_reset(mechanism)))
        .with_second_route(conclusion, VECTORS, move || {
            let row = rows().iter().find(|row| row.mechanism == mechanism).context(NONE)?;
            let model = ContactModel::of_row(row);
            Ok(sign * model.stance(listing().reset - model.half).ratio)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_pins_are_dropped_while_the_follower_turns_and_six_are_followed_until_it_runs_backwards() {
        let ratio = |mechanism| listing().velocity_ratio_at_reset(mechanism);
        assert!(ratio(Mechanism::THREE_PIN) > 0.1);
        assert!(ratio(Mechanism::SIX_PIN) < -0.1);
        // To the five digits of the reset angle.
        assert!(ratio(Mechanism::FOUR_PIN).abs() < 1e-5);
    }

    #[test]
    fn the_follower_of_six_pins_runs_backwards_only_with_the_reset_as_listed_and_only_past_60_degrees() {
        let row = rows().first().expect("a run");
        let turned = turned_when_backwards(row, &listed_settings(&listing())).expect("it runs backwards").to_degrees();
        assert!((60.0..63.0).contains(&turned), "{turned}");
        assert!(turned_when_backwards(row, &[]).is_none());
    }

    #[test]
    fn the_delay_alone_keeps_the_deck_from_being_a_loop() {
        let told = loop_without_delay(OLD_ACCELERATION).expect("a loop");
        assert!(told.starts_with("BEFORE →") && told.ends_with("BEFORE") && told.contains("SIGN"), "{told}");
        assert!(loop_without_delay("no such card").is_err());
    }
}
