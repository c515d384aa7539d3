//! Of the program: what it gives of the thesis's tables, and what its reset after a quarter of a turn does to six and to
//! three pins.

use super::Number;
use anyhow::Context;
use geneva_case1973::deck::{deck, listed_settings, longer_than_delay, turned_when_backwards};
use geneva_case1973::{Column, Constants, Hypothesis, Reset, Row, Run};
use geneva_documents::meyer::runs::study::by_deck;
use geneva_documents::meyer::runs::table::{listing, rows};
use geneva_kinematics::Mechanism;
use geneva_mimic::language::{CardLayout, Deck, Program, deck_named};

/// The numbers of the chapter on the program.
pub const NUMBERS: &[(&str, Number)] = &[
    ("program.statements", || Ok(own()?.execution_order().len().to_string())),
    ("program.needless", || {
        Ok(own()?.execution_order().iter().filter(|statement| statement.is_dead).count().to_string())
    }),
    ("program.loop", || loop_without_delay(OLD_ACCELERATION)),
    ("program.four-pin.runs", || Ok(rows_with(true).count().to_string())),
    ("program.four-pin.minima", || of_own_reset(true, Column::Minimum)),
    ("program.four-pin.periods", || of_own_reset(true, Column::Period)),
    ("program.four-pin.peaks", || of_own_reset(true, Column::Peak)),
    ("program.other-pins.runs", || Ok(rows_with(false).count().to_string())),
    ("program.other-pins.minima", || of_own_reset(false, Column::Minimum)),
    ("program.other-pins.periods", || of_own_reset(false, Column::Period)),
    ("program.other-pins.peaks", || of_own_reset(false, Column::Peak)),
    ("program.no-delay.minima", || without_delay(Column::Minimum)),
    ("program.no-delay.periods", || without_delay(Column::Period)),
    ("program.no-delay.peaks", || without_delay(Column::Peak)),
    ("program.long-steps", long_steps),
    ("program.backwards-after", || {
        let row = rows().first().context("there is no run")?;
        let turned =
            turned_when_backwards(row, &listed_settings(&listing())).context("the follower never runs backwards")?;
        Ok(super::degrees(turned))
    }),
    ("program.three-at-the-reset", || Ok(format!("{:.2}", listing().velocity_ratio_at_reset(Mechanism::THREE_PIN)))),
    ("program.six-at-the-reset", || Ok(format!("{:.2}", -listing().velocity_ratio_at_reset(Mechanism::SIX_PIN)))),
];

/// The old acceleration in the escapement's deck.
const OLD_ACCELERATION: &str = "TDL(ACCEL,DT/10.,100.)";

/// The escapement's deck as it stands.
fn own() -> anyhow::Result<Program> {
    Ok(Program::new(&deck(&[]).context("there is no such deck")?)?)
}

/// What part of the steps is longer than the delay, from the least to the greatest of all runs of the deck with the
/// thesis's numbers, in per cent.
fn long_steps() -> anyhow::Result<String> {
    let parts = longer_than_delay(rows()).context("the escapement's deck does not run")?;
    Ok(format!("{:.0} to {:.0}&nbsp;%", 100.0 * super::least(&parts), 100.0 * super::most(&parts)))
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
fn within_one<'a>(column: Column, runs: impl Iterator<Item = (&'a Row, Option<Run>)>) -> String {
    let is_near = |row: &Row, run: &Run| column.is_within_one(row.number(column), run.number(column));
    runs.filter(|(row, run)| run.as_ref().is_some_and(|run| is_near(row, run))).count().to_string()
}

/// By the deck as it stands: each mechanism's own angle from pin to pin.
fn of_own_reset(four_pins: bool, column: Column) -> anyhow::Result<String> {
    let runs = by_deck(Reset::OfTheMechanism).context("the escapement's deck does not run")?;
    let of_these = |(row, _): &(&Row, Option<Run>)| (row.mechanism == Mechanism::FOUR_PIN) == four_pins;
    Ok(within_one(column, rows().iter().zip(runs.iter().copied().map(Some)).filter(of_these)))
}

/// By the program translated by hand, with the sign of the acceleration itself.
fn without_delay(column: Column) -> anyhow::Result<String> {
    let hypothesis = Hypothesis { constants: Constants::AsListed, ..Hypothesis::WITHOUT_LAG };
    Ok(within_one(column, rows().iter().map(|row| (row, hypothesis.run(row)))))
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
