//! Recorded measurements: how long what took on a named machine.

use crate::lookup::unknown;
use anyhow::Context;

/// Made by the bench `integrators`; see the README beside it.
const INTEGRATORS: &str = include_str!("../../../book/records/integrators.csv");

/// A contestant at one tolerance, or a map.
#[derive(Clone, Debug, PartialEq, serde::Deserialize)]
pub(crate) struct Measurement {
    /// Who it is; see the README of the records.
    pub contestant: String,
    /// What was asked for, as written.
    pub tolerance: String,
    /// Escapements that were finished.
    pub runs: Option<u32>,
    /// Evaluations of the right-hand side, of all runs together.
    pub evaluations: Option<u64>,
    /// Best time for all runs together.
    pub milliseconds: f64,
    /// Largest relative error of all numbers that were asked for.
    pub true_error: Option<f64>,
    /// Points of a map.
    pub points: Option<u64>,
    /// Threads of a map.
    pub threads: Option<u32>,
}

/// All measurements, in the order of the record.
pub(crate) fn integrators() -> anyhow::Result<Vec<Measurement>> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(INTEGRATORS.as_bytes());
    reader.deserialize().map(|line| line.context("the record of the integrators")).collect()
}

/// What the record says of its making: processor, cores, compiler, date and so on.
pub(crate) fn condition(name: &str) -> anyhow::Result<&'static str> {
    let lines = INTEGRATORS.lines().filter_map(|line| line.strip_prefix("# ")?.split_once(": "));
    lines
        .clone()
        .find_map(|(known, value)| (known == name).then_some(value))
        .ok_or_else(|| unknown("condition of the record", name, lines.map(|(known, _)| known)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_record_is_whole() {
        let all = integrators().expect("read");
        for contestant in ["angle-steady", "angle-run", "dopri5", "dop853", "mimic"] {
            let own: Vec<_> = all.iter().filter(|one| one.contestant == contestant).collect();
            assert!(own.len() > 3 && own.iter().all(|one| one.runs == Some(49)), "{contestant}");
            assert!(own.iter().all(|one| one.milliseconds > 0.0 && one.true_error.is_some_and(|error| error > 0.0)));
        }
        assert!(all.iter().any(|one| one.contestant == "map" && one.points > Some(500_000)));
        for name in ["processor", "cores", "compiler", "date"] {
            assert!(!condition(name).expect("a condition").is_empty());
        }
        assert!(condition("weather").is_err());
    }
}
