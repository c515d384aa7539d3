//! What a printed number may be tied to: values that round to its digits.

use crate::comparison::{Comparison, Conversion, compare, conversion};
use crate::numbered_text::PrintedNumber;
use crate::record_file::Tie;
use crate::role::Role;
use crate::values::{ComputedValue, Values};
use geneva_exact::{Field, Rational, rational};
use std::collections::HashMap;

/// Most candidates that are listed for a number.
const MOST_CANDIDATES: usize = 8;
/// Most values that are compared exactly for a number.
const MOST_COMPARED: usize = 64;
/// The factor between a value without a unit and a number in per cent.
const PER_CENT: &str = "100";

/// The values that have one unit, in the order of size: each with its place among all.
struct UnitGroup<'v> {
    unit: Option<&'v str>,
    sorted: Vec<(f64, usize)>,
}

/// Values by their units.
pub(crate) struct ValueIndex<'v> {
    values: &'v Values,
    groups: Vec<UnitGroup<'v>>,
    /// For each printed unit the groups that go with it, with the factor from their unit.
    fitting: HashMap<String, Vec<(usize, f64)>>,
    /// Pairs of a number and a value that were compared so far.
    pub compared: usize,
}

/// A proposal for a number.
pub(crate) struct Proposal {
    pub tie: Tie,
    /// The factor of the tie, as it is written.
    pub factor: Option<&'static str>,
    /// How likely it is that a number has such a value by chance: the share of the numbers nearby that would be tied to a value.
    pub chance: f64,
}

impl<'v> ValueIndex<'v> {
    pub(crate) fn new(values: &'v Values) -> Self {
        let mut by_unit: HashMap<Option<&str>, usize> = HashMap::new();
        let mut groups: Vec<UnitGroup<'_>> = Vec::new();
        for (at, value) in values.computed().iter().enumerate() {
            let unit = value.unit.as_deref();
            let group = *by_unit.entry(unit).or_insert_with(|| {
                groups.push(UnitGroup { unit, sorted: Vec::new() });
                groups.len() - 1
            });
            groups[group].sorted.push((value.nearest, at));
        }
        for group in &mut groups {
            group.sorted.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        }
        Self { values, groups, fitting: HashMap::new(), compared: 0 }
    }

    /// What the number is tied to, as far as its digits and its form tell.
    pub(crate) fn propose(&mut self, number: &PrintedNumber) -> Proposal {
        let plain = |tie| Proposal { tie, factor: None, chance: 0.0 };
        if let Some(role) = number.role {
            // A year by its look alone may be a count.
            let counted = (role == Role::Date && number.digits.len() == 4).then(|| self.candidates(number));
            return match counted.as_deref() {
                Some([(value, None)]) if value.exact == number.decimal.exact() => {
                    plain(Tie::Value { key: value.key.clone(), factor: None })
                }
                _ => plain(Tie::None(role.name().to_owned())),
            };
        }
        let mut found = self.candidates(number);
        // A digit or two fits something by chance. Where values have units, one without counts something, or is a share.
        let significant = number.digits.bytes().filter(u8::is_ascii_digit).skip_while(|byte| *byte == b'0').count();
        if significant < 3 && number.exponent == 0 && number.decimal.places() == 0 {
            let has_units = self.groups.iter().any(|group| group.unit.is_some());
            found.retain(|(value, _)| match &*number.unit {
                "" => value.exact == number.decimal.exact(),
                unit => value.unit.is_some() || unit == "%" || !has_units,
            });
        }
        match &*found {
            [] => Proposal { chance: self.chance(number), ..plain(Tie::Open) },
            [(value, factor)] => {
                let exact = factor.map(|_| rational(100, 1));
                let tie = Tie::Value { key: value.key.clone(), factor: exact };
                Proposal { tie, factor: *factor, chance: self.chance(number) }
            }
            many => {
                let keys = many.iter().map(|(value, _)| value.key.clone()).collect();
                Proposal { chance: self.chance(number), ..plain(Tie::Candidates(keys)) }
            }
        }
    }

    /// The values that round to a number, in the order of their files, each with the factor that it needs.
    fn candidates(&mut self, number: &PrintedNumber) -> Vec<(&'v ComputedValue, Option<&'static str>)> {
        let values = self.values;
        let fitting = self.fitting(&number.unit);
        let per_cent = (number.unit == "%").then(|| rational(100, 1));
        let mut found: Vec<(usize, Option<&'static str>)> = Vec::new();
        let mut compared = 0;
        for (group, by) in fitting {
            let UnitGroup { unit, sorted } = &self.groups[group];
            let mut search = |by: f64, factor: Option<&Rational>| {
                for at in near(sorted, number, by) {
                    compared += 1;
                    if compare(number, &values.computed()[at], factor) == Comparison::Right {
                        found.push((at, factor.map(|_| PER_CENT)));
                    }
                }
            };
            search(by, None);
            if unit.is_none()
                && let Some(factor) = &per_cent
            {
                search(100.0, Some(factor));
            }
        }
        self.compared += compared;
        found.sort_by_key(|(at, _)| *at);
        found.dedup_by_key(|(at, _)| *at);
        found.truncate(MOST_CANDIDATES);
        found.into_iter().map(|(at, factor)| (&values.computed()[at], factor)).collect()
    }

    /// The share of the numbers nearby, to the same digits, that have a value, too.
    fn chance(&mut self, number: &PrintedNumber) -> f64 {
        /// How many numbers nearby count, to either side.
        const NEARBY: f64 = 50.0;
        let mut others = 0;
        for (group, by) in self.fitting(&number.unit) {
            let sorted = &self.groups[group].sorted;
            let within = |units: f64| {
                let [low, high] = reach(number, by, units);
                sorted.partition_point(|(value, _)| *value <= high) - sorted.partition_point(|(value, _)| *value < low)
            };
            others += within(NEARBY + 0.5) - within(0.5);
        }
        (others as f64 / (2.0 * NEARBY)).min(1.0)
    }

    /// The groups whose unit goes with a printed one, each with the factor to it.
    fn fitting(&mut self, unit: &str) -> Vec<(usize, f64)> {
        if let Some(known) = self.fitting.get(unit) {
            return known.clone();
        }
        let fits = |(at, group): (usize, &UnitGroup<'_>)| match (group.unit, unit) {
            (None, _) => Some((at, 1.0)),
            (Some(_), "") => None,
            (Some(of), unit) => match conversion(Some(of), unit) {
                Conversion::None => Some((at, 1.0)),
                Conversion::Factor(factor) => Some((at, factor.approximate())),
                Conversion::Impossible => None,
            },
        };
        let found: Vec<(usize, f64)> = self.groups.iter().enumerate().filter_map(fits).collect();
        self.fitting.insert(unit.to_owned(), found.clone());
        found
    }
}

/// The values of a group that are about as large as a number, if they count `by` in its unit.
fn near(sorted: &[(f64, usize)], number: &PrintedNumber, by: f64) -> Vec<usize> {
    let [low, high] = reach(number, by, 0.5);
    let start = sorted.partition_point(|(value, _)| *value < low);
    let end = sorted[start..].iter().take(MOST_COMPARED).take_while(|(value, _)| *value <= high);
    end.map(|(_, at)| *at).collect()
}

/// The values that differ from a number by at most so many units of its last place, if they count `by` in its unit.
fn reach(number: &PrintedNumber, by: f64, units: f64) -> [f64; 2] {
    let scale = ten_to(number.exponent) / by;
    let centre = number.decimal.to_f64() * scale;
    let far = (number.decimal.unit_in_last_place().approximate() * units * scale).abs() + centre.abs() * 1e-12;
    [centre - far, centre + far]
}

/// Ten to a power, to all digits of a float.
fn ten_to(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::INFINITY)
}
