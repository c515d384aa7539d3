//! What the names of a formula stand for, in one state of affairs.

use super::tex::name;
use super::value::{Value, What};
use nalgebra::{Vector2, Vector3};
use std::collections::BTreeMap;

/// One state of affairs: what each name stands for.
#[derive(Clone, Debug, Default)]
pub struct State {
    values: BTreeMap<String, Value>,
    functions: BTreeMap<String, fn(f64, f64) -> f64>,
}

impl State {
    /// Gives numbers to names written in TeX.
    #[must_use]
    pub fn with<'a>(mut self, values: impl IntoIterator<Item = (&'a str, f64)>) -> Self {
        for (tex, number) in values {
            self.set(&name(tex), What::Number(number));
        }
        self
    }

    /// Gives vectors of the plane to names written in TeX.
    #[must_use]
    pub fn with_vectors<'a>(mut self, values: impl IntoIterator<Item = (&'a str, Vector2<f64>)>) -> Self {
        for (tex, vector) in values {
            self.set(&name(tex), What::Vector(Vector3::new(vector.x, vector.y, 0.0)));
        }
        self
    }

    /// Gives angular velocities and accelerations, out of the plane, to names written in TeX.
    #[must_use]
    pub fn with_turning<'a>(mut self, values: impl IntoIterator<Item = (&'a str, f64)>) -> Self {
        for (tex, rate) in values {
            self.set(&name(tex), What::Vector(Vector3::new(0.0, 0.0, rate)));
        }
        self
    }

    /// Gives numbers that names written in TeX have at an instant that a formula names.
    #[must_use]
    pub fn with_instant<'a>(mut self, instant: &str, values: impl IntoIterator<Item = (&'a str, f64)>) -> Self {
        for (tex, number) in values {
            self.set(&format!("{} at {instant}", name(tex)), What::Number(number));
        }
        self
    }

    /// The same state with other names for the same things, in TeX: theirs, then ours.
    #[must_use]
    pub fn called<'a>(mut self, names: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let mut others = Vec::new();
        for (theirs, ours) in names {
            let (theirs, ours) = (name(theirs), name(ours));
            let value = self.values.get(&ours).unwrap_or_else(|| panic!("no {ours}"));
            others.push((theirs.clone(), *value));
            others.extend(self.values.get(&rate_of(&ours)).map(|rate| (rate_of(&theirs), *rate)));
        }
        self.values.extend(others);
        self
    }

    /// Gives a number to what is no name in TeX: the rate of change of a name.
    #[must_use]
    pub fn with_rate(mut self, tex: &str, number: f64) -> Self {
        self.set(&rate_of(&name(tex)), What::Number(number));
        self
    }

    /// Lets a letter stand for a function of two numbers.
    #[must_use]
    pub fn with_function(mut self, letter: &str, function: fn(f64, f64) -> f64) -> Self {
        self.functions.insert(letter.to_owned(), function);
        self
    }

    /// What a name stands for.
    pub fn value(&self, name: &str) -> Option<Value> {
        self.values.get(name).copied()
    }

    /// The function that a letter stands for.
    pub fn function(&self, letter: &str) -> Option<fn(f64, f64) -> f64> {
        self.functions.get(letter).copied()
    }

    fn set(&mut self, name: &str, what: What) {
        self.values.insert(name.to_owned(), Value::new(what));
    }

    /// The state a short time later, as far as the rates of its names go.
    pub fn later(&self, time: f64) -> Self {
        let moved = |(name, value): (&String, &Value)| {
            let what = match (value.what, self.values.get(&rate_of(name)).map(|rate| rate.what)) {
                (What::Number(number), Some(What::Number(rate))) => What::Number(number + time * rate),
                (what, _) => what,
            };
            (name.clone(), Value::new(what))
        };
        Self { values: self.values.iter().map(moved).collect(), functions: self.functions.clone() }
    }
}

/// The name of the rate of change of what has this name.
fn rate_of(name: &str) -> String {
    match name.strip_prefix(r"\dot{") {
        Some(rest) => format!(r"\ddot{{{rest}"),
        None => format!(r"\dot{{{name}}}"),
    }
}
