//! Tables of computed numbers, beside those of the ledger: by name, or for a range of wheels.

mod escapement;
pub mod joints;
mod quick_return;
mod rise_times;
mod runs;
pub mod solver;
mod timer;
pub mod wheels;

use anyhow::anyhow;

/// A table as HTML.
type Draw = fn() -> anyhow::Result<String>;

/// All tables, in the order of the book.
const TABLES: &[(&str, Draw)] = &[
    ("quick-return-terms", quick_return::terms),
    ("quick-return-branches", quick_return::branches),
    ("runs-hypotheses", runs::hypotheses),
    ("runs-delays", runs::delays),
    ("runs-integrator", runs::integrator),
    ("runs-rise-definitions", rise_times::definitions),
    ("runs-rise-groups", rise_times::groups),
    ("runs-six-pin", escapement::six_pin),
    ("runs-six-pin-as-headed", escapement::six_pin_as_headed),
    ("runs-four-pin", escapement::four_pin),
    ("runs-three-pin", escapement::three_pin),
    ("joints", joints::effects),
    ("solver-speeds", solver::speeds),
    ("solver-maps", solver::maps),
    ("timer-settling", timer::settling),
    ("timer-sensitivity", timer::sensitivity),
    ("timer-accelerations", timer::accelerations),
    ("timer-mean-speed", timer::mean_speed),
];

/// The table of this name.
pub fn by_name(name: &str) -> anyhow::Result<String> {
    let names = || TABLES.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
    let (_, draw) = TABLES
        .iter()
        .find(|(known, _)| *known == name)
        .ok_or_else(|| anyhow!("no table `{name}`; there are: {}", names()))?;
    draw()
}

/// A number with its sign, and a true minus.
fn signed(number: f64, decimals: usize) -> String {
    // A zero has no sign.
    let text = format!("{number:+.decimals$}");
    let is_zero = !text.contains(|c: char| c.is_ascii_digit() && c != '0');
    if is_zero { text[1..].to_owned() } else { text.replace('-', "−") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_is_drawn_and_others_are_refused() {
        for (name, _) in TABLES {
            let html = by_name(name).expect("drawn");
            assert!(html.contains("<table>") && !html.contains("NaN"), "{name}");
        }
        assert!(by_name("terms").expect_err("unknown").to_string().contains("quick-return-terms"));
    }
}
