//! What the names of a formula stand for at one instant, and what the formula then comes to.

use super::number::Number;
use super::tree::{By, Function, Joint, Node};
use super::value::Value;
use super::{Display, Illegible, name, name_at};
use std::collections::BTreeMap;

/// What each letter stands for at one instant, by its [`name`].
pub type Letters<N = f64> = BTreeMap<String, N>;

/// What letters stand for, from their names and values.
pub fn by_name<'a, N>(values: impl IntoIterator<Item = (&'a str, N)>) -> Letters<N> {
    values.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

/// What the names of a formula stand for at one instant, and how fast it changes.
#[derive(Clone, Debug)]
pub struct Moment<N = f64> {
    pub(super) letters: Letters<N>,
    vectors: BTreeMap<String, [N; 3]>,
    /// The rates of the letters by time, angle and speed.
    rates: [Letters<N>; 3],
    /// The slope f(x; y).
    slope: Option<fn(N, N) -> N>,
    /// Formulas that have a value of their own, so that they need not be evaluated.
    given: Vec<(Node, N)>,
    /// Formulas that another value replaces, with no condition on it.
    replaced: Vec<(Node, N)>,
    /// The cosine and the sine of each name that stands for an angle.
    pub(super) angles: BTreeMap<String, [N; 2]>,
    /// What else must be zero for the names to stand for what they do.
    required: Vec<N>,
    /// The integer under the root that exact numbers contain.
    under_root: Option<u32>,
    /// The sign of what stands between bars, if it is given.
    bars: Option<N>,
}

/// Steps to either side, in units of the difference's own step, and the weights of a difference that is right to the
/// eighth order.
const WEIGHTS: [(f64, f64); 4] = [(1.0, 4.0 / 5.0), (2.0, -1.0 / 5.0), (3.0, 4.0 / 105.0), (4.0, -1.0 / 280.0)];
const STEP: f64 = 1.0 / 1024.0;

impl<N: Number> Default for Moment<N> {
    fn default() -> Self {
        Self::of(Letters::new())
    }
}

impl Moment {
    /// Adds rates of the letters as differences of what they stand for at some distance by time, angle or speed.
    #[must_use]
    pub fn moving(mut self, there: impl Fn(By, f64) -> Letters) -> Self {
        for by in [By::Time, By::Angle, By::Speed] {
            for (steps, weight) in WEIGHTS {
                let [later, earlier] = [steps, -steps].map(|steps| there(by, steps * STEP));
                for (name, value) in later {
                    let change = earlier.get(&name).map_or(f64::NAN, |before| value - before);
                    *self.rates[by as usize].entry(name).or_default() += weight / STEP * change;
                }
            }
        }
        self
    }

    /// Adds numbers that names have at an instant that a formula names.
    #[must_use]
    pub fn with_instant<'a>(mut self, instant: &str, values: impl IntoIterator<Item = (&'a str, f64)>) -> Self {
        let named = values.into_iter().filter_map(|(tex, number)| Some((name_at(&name(tex).ok()?, instant), number)));
        self.letters.extend(named);
        self
    }

    /// Adds other names for the letters and for their rates: theirs, then ours. Not a number, if ours stands for nothing.
    #[must_use]
    pub fn called<'a>(mut self, names: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let named = names.into_iter().filter_map(|(theirs, ours)| Some((name(theirs).ok()?, name(ours).ok()?)));
        let before = self.clone();
        for (theirs, ours) in named {
            self.set(theirs.clone(), before.named(&ours).unwrap_or(Value::Number(f64::NAN)));
            if let Some(rate) = before.rates[By::Time as usize].get(&ours) {
                self.rates[By::Time as usize].insert(theirs.clone(), *rate);
            }
            if let Some(rate) = before.named(&dotted(&ours)) {
                self.set(dotted(&theirs), rate);
            }
        }
        self
    }
}

impl<N: Number> Moment<N> {
    /// The letters alone.
    pub fn of(letters: Letters<N>) -> Self {
        let rates = [const { Letters::new() }; 3];
        Self {
            letters,
            vectors: BTreeMap::new(),
            rates,
            slope: None,
            given: Vec::new(),
            replaced: Vec::new(),
            angles: BTreeMap::new(),
            required: Vec::new(),
            under_root: None,
            bars: None,
        }
    }

    /// Adds values for names, as TeX writes them; what is no name has no value.
    #[must_use]
    pub fn with<'a, V: Into<Value<N>>>(mut self, values: impl IntoIterator<Item = (&'a str, V)>) -> Self {
        for (name, value) in values.into_iter().filter_map(|(tex, value)| Some((name(tex).ok()?, value))) {
            self.set(name, value.into());
        }
        self
    }

    fn set(&mut self, name: String, value: Value<N>) {
        self.letters.remove(&name);
        match value {
            Value::Number(number) => drop(self.letters.insert(name, number)),
            Value::Vector(vector) => drop(self.vectors.insert(name, vector)),
        }
    }

    /// Adds angles by their cosines and sines: a sum of angles is then proven as a sequence of turns. The sine, the cosine
    /// and the tangent of each are given too.
    #[must_use]
    pub fn with_angles<'a>(mut self, angles: impl IntoIterator<Item = (&'a str, [N; 2])>) -> Self {
        for (tex, [cos, sin]) in angles {
            for (function, value) in [
                (Function::Cosine, cos.clone()),
                (Function::Sine, sin.clone()),
                (Function::Tangent, sin.clone() / cos.clone()),
            ] {
                self.replaced.extend(name(tex).ok().map(|name| (Node::Name(name).of(function), value)));
            }
            self.required.push(cos.clone() * cos.clone() + sin.clone() * sin.clone() - N::integer(1));
            self.angles.extend(name(tex).ok().map(|name| (name, [cos, sin])));
        }
        self
    }

    /// Adds what must be zero for the names to stand for what they do.
    #[must_use]
    pub fn requiring(mut self, zeros: impl IntoIterator<Item = N>) -> Self {
        self.required.extend(zeros);
        self
    }

    /// Says which integer stands under the root of these numbers.
    #[must_use]
    pub fn with_root_of(self, integer: u32) -> Self {
        Self { under_root: Some(integer), ..self }
    }

    /// The integer under the root of these numbers, if they have one.
    pub(super) fn under_root(&self) -> Option<u32> {
        self.under_root
    }

    /// Puts a value in the place of a formula wherever it stands. An equation that holds for every such value holds for the
    /// right one. A formula that cannot be read stands nowhere.
    #[must_use]
    pub fn replacing(mut self, tex: &str, value: N) -> Self {
        self.replaced.extend(Display::read(tex).ok().and_then(|display| Some((display.alone()?.clone(), value))));
        self
    }

    /// Adds rates of letters, by their [`name`]s. What has no rate among others is constant.
    #[must_use]
    pub fn changing<'a>(mut self, by: By, rates: impl IntoIterator<Item = (&'a str, N)>) -> Self {
        self.rates[by as usize].extend(rates.into_iter().map(|(name, rate)| (name.to_owned(), rate)));
        self
    }

    /// Adds a slope that the letter f stands for.
    #[must_use]
    pub fn sloping(self, slope: fn(N, N) -> N) -> Self {
        Self { slope: Some(slope), ..self }
    }

    /// Adds the value of a formula wherever it stands, and for half a power of something also of the other half powers. A
    /// formula that cannot be read stands nowhere.
    #[must_use]
    pub fn giving(mut self, tex: &str, value: N) -> Self {
        self.given.extend(Display::read(tex).ok().and_then(|display| Some((display.alone()?.clone(), value))));
        self
    }

    /// Adds the sign of what stands between bars.
    #[must_use]
    pub fn opening_bars(self, sign: N) -> Self {
        Self { bars: Some(sign), ..self }
    }

    /// The letters.
    pub fn letters(&self) -> &Letters<N> {
        &self.letters
    }

    fn named(&self, name: &str) -> Option<Value<N>> {
        let number = self.letters.get(name).cloned().map(Value::Number);
        number.or_else(|| self.vectors.get(name).cloned().map(Value::Vector))
    }

    /// How far the sides of a chain are apart at most, over the larger or one. Infinite for what has no value.
    pub(super) fn misfit(&self, chain: &[Node], sign: i64) -> Result<f64, Illegible> {
        let sides = chain.iter().map(|side| self.value(side, sign)).collect::<Result<Vec<_>, _>>()?;
        let misfits = sides.windows(2).map(|pair| {
            let [one, other] = [pair[0].size(), pair[1].size()];
            let apart = pair[0].clone().plus(pair[1].clone().times(N::integer(-1))).map_or(f64::NAN, |gap| gap.size());
            let misfit = apart / one.max(other).max(1.0);
            if misfit.is_nan() { f64::INFINITY } else { misfit }
        });
        Ok(misfits.fold(0.0, f64::max))
    }

    /// The number that a formula comes to.
    pub(super) fn number(&self, node: &Node) -> Result<N, Illegible> {
        self.value(node, 1)?.number()
    }

    /// What a formula comes to, with this sign for those that stand for both.
    pub(super) fn value(&self, node: &Node, sign: i64) -> Result<Value<N>, Illegible> {
        if let Some(value) = self.given(node) {
            return Ok(Value::Number(value));
        }
        match node {
            Node::Number(digits, places) => {
                let unit =
                    10_i64.checked_pow(*places).ok_or_else(|| Illegible(format!("{places} places of a number")))?;
                let number = N::integer(*digits);
                Ok(Value::Number(if *places == 0 { number } else { number / N::integer(unit) }))
            }
            Node::Name(name) => self.of_name(name),
            Node::Of(Function::Rate(by), of) => match &**of {
                Node::Name(name) => self.rate(name, *by),
                of => self.value(&of.rate(*by).ok_or_else(|| no_rate(of))?, sign),
            },
            Node::Of(function, of) => {
                let apply = |function: Function, number: N| {
                    number.apply(function).map(Value::Number).ok_or_else(|| Illegible(format!("{function:?}")))
                };
                match (function, self.value(of, sign)?, &self.bars) {
                    (Function::Minus, of, _) => Ok(of.times(N::integer(-1))),
                    (Function::PlusMinus, of, _) => Ok(of.times(N::integer(sign))),
                    (Function::Size, of, Some(sign)) => Ok(of.times(sign.clone())),
                    (Function::Size, Value::Vector(vector), None) => {
                        let [x, y, z] = vector.map(|part| part.clone() * part);
                        apply(Function::Root, x + y + z)
                    }
                    // Where π is one of the letters, degrees are parts of it.
                    (Function::Degrees, of, _) if self.letters.contains_key("pi") => {
                        let degree = self.of_name("pi")?.number()? / N::integer(180);
                        Ok(of.times(degree))
                    }
                    (function, of, _) => apply(*function, of.number()?),
                }
            }
            Node::Two(Joint::Power, base, exponent) => {
                // The exponents of all sources are constant.
                let exponent = Moment::<f64>::of(Letters::new()).number(exponent)?;
                let (base, exponent) = match self.given_root(base) {
                    Some(root) => (root, 2.0 * exponent),
                    None => (self.value(base, sign)?.number()?, exponent),
                };
                base.power(exponent).map(Value::Number).ok_or_else(|| Illegible(format!("the power {exponent}")))
            }
            Node::Two(joint, left, right) => self.joined(*joint, self.value(left, sign)?, self.value(right, sign)?),
        }
    }

    fn given(&self, node: &Node) -> Option<N> {
        let mut all = self.given.iter().chain(&self.replaced);
        all.find(|(given, _)| given == node).map(|(_, value)| value.clone())
    }

    /// What is given for the power 1/2 of this base.
    fn given_root(&self, base: &Node) -> Option<N> {
        self.given.iter().find(|(given, _)| under_root(given) == Some(base)).map(|(_, value)| value.clone())
    }

    /// What must be zero for the given values to be those of their formulas; half a power is squared. A function that
    /// this kind of number does not have may have any value.
    pub(super) fn conditions(&self) -> Vec<N> {
        let condition = |(at, (node, value)): (usize, &(Node, N))| {
            let mut others = self.clone();
            others.given.remove(at);
            match under_root(node) {
                Some(base) => Some(others.number(base).ok()? - value.clone() * value.clone()),
                None => Some(others.number(node).ok()? - value.clone()),
            }
        };
        self.given.iter().enumerate().filter_map(condition).chain(self.required.iter().cloned()).collect()
    }

    fn joined(&self, joint: Joint, left: Value<N>, right: Value<N>) -> Result<Value<N>, Illegible> {
        match (joint, left, right) {
            (Joint::Plus, left, right) => left.plus(right),
            (Joint::Cross, Value::Vector([a, b, c]), Value::Vector([x, y, z])) => {
                let part = |a: &N, y: &N, b: &N, x: &N| a.clone() * y.clone() - b.clone() * x.clone();
                Ok(Value::Vector([part(&b, &z, &c, &y), part(&c, &x, &a, &z), part(&a, &y, &b, &x)]))
            }
            (Joint::Times | Joint::Cross, Value::Number(factor), of) => Ok(of.times(factor)),
            (Joint::Times | Joint::Cross, of, Value::Number(factor)) => Ok(of.times(factor)),
            (Joint::Over, of, Value::Number(divisor)) => Ok(match of {
                Value::Number(number) => Value::Number(number / divisor),
                vector => vector.times(N::integer(1) / divisor),
            }),
            (Joint::Column, first, second) => Ok(Value::Vector([first.number()?, second.number()?, N::integer(0)])),
            (Joint::Slope, first, second) => {
                let slope = self.slope.ok_or_else(|| Illegible("the function f".to_owned()))?;
                Ok(Value::Number(slope(first.number()?, second.number()?)))
            }
            (joint, ..) => Err(Illegible(format!("{joint:?} with a vector"))),
        }
    }

    fn of_name(&self, name: &str) -> Result<Value<N>, Illegible> {
        let pi = || N::pi().filter(|_| name == "pi").map(Value::Number);
        // A dot over a letter that has no value of its own with it.
        let undotted = || (!name.contains('/')).then(|| name.replacen('\'', "", 1)).filter(|of| of != name);
        match self.named(name).or_else(pi) {
            Some(value) => Ok(value),
            None => match undotted() {
                Some(of) if self.letters.contains_key(&of) => self.rate(&of, By::Time),
                _ => Err(Illegible(format!("the name {name} stands for nothing"))),
            },
        }
    }

    /// How fast what a name stands for changes.
    fn rate(&self, name: &str, by: By) -> Result<Value<N>, Illegible> {
        let rates = &self.rates[by as usize];
        let found = rates.get(name).cloned().map(Value::Number);
        let dotted = || self.named(&dotted(name)).filter(|_| by == By::Time);
        // Where others have rates, it is constant.
        let constant = || self.named(name).filter(|_| !rates.is_empty()).map(|of| of.times(N::integer(0)));
        found.or_else(dotted).or_else(constant).ok_or_else(|| no_rate(&Node::Name(name.to_owned())))
    }
}

/// What stands under the root, if this is half a power.
fn under_root(node: &Node) -> Option<&Node> {
    let half = Node::integer(1).join(Joint::Over, Node::integer(2));
    match node {
        Node::Of(Function::Root, base) => Some(base),
        Node::Two(Joint::Power, base, exponent) if **exponent == half => Some(base),
        _ => None,
    }
}

fn no_rate(of: &Node) -> Illegible {
    Illegible(format!("the rate of {of:?}"))
}

/// The name of the rate of change of what has this name.
fn dotted(name: &str) -> String {
    let end = name.find(['_', '^', '′']).unwrap_or(name.len());
    format!("{}'{}", &name[..end], &name[end..])
}
