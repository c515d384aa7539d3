//! Reads the printed characters of a formula and evaluates them.
//!
//! The identities of the formula crates stand for the printed displays, but nothing ties them to the characters.
//! This does: what is printed, or what the erratum puts in its place, is read character by character and evaluated.
//! It knows sums, products, fractions, powers, sines, cosines, bars, letters with dots and subscripts, and the
//! derivatives of Lagrange's equation. Brackets may be of any kind; those left open at the end of a line are closed
//! there, and those closed too often are passed over, because a display may be cut into its lines.

mod number;
mod tokens;
mod tree;

pub use number::Number;
pub use tree::By;

use crate::tolerance::{DIFFERENCES, ROUTES};
use std::collections::{BTreeMap, BTreeSet};
use tree::{Function, Joint, Node};

/// What each letter stands for at one instant. A dot over a letter is written behind it: `theta'`, `theta''_0`.
pub type Letters<N = f64> = BTreeMap<String, N>;

/// The value of a formula without an equals sign; not a number if it cannot be read or a letter has no value.
pub fn value(formula: &str, letters: &Letters) -> f64 {
    tree::read(formula).and_then(|node| Moment::of(letters.clone()).value(&node)).unwrap_or(f64::NAN)
}

/// The letters that a formula needs; none if it cannot be read.
pub fn letters_in(formula: &str) -> BTreeSet<String> {
    let mut letters = BTreeSet::new();
    if let Some(node) = tree::read(formula) {
        node.collect(&mut letters);
    }
    letters
}

/// What the letters stand for at one instant, and a little beside it.
pub struct Moment<N = f64> {
    letters: Letters<N>,
    /// The letters at steps to either side: later and earlier, at other angles, at other speeds.
    beside: [Vec<Letters<N>>; 3],
    /// The slope f(x; y).
    slope: Option<fn(N, N) -> N>,
}

/// Steps to either side, in units of the difference's own step, that a derivative is made of.
const STEPS: [f64; 8] = [1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0];
/// Their weights: a difference that is right to the eighth order.
const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
const STEP: f64 = 1.0 / 1024.0;

impl<N: Number> Moment<N> {
    /// The letters alone.
    pub fn of(letters: Letters<N>) -> Self {
        Self { letters, beside: [const { Vec::new() }; 3], slope: None }
    }

    /// The same with what they stand for at some distance by time, angle or speed.
    #[must_use]
    pub fn moving(mut self, there: impl Fn(By, f64) -> Letters<N>) -> Self {
        self.beside = [By::Time, By::Angle, By::Speed].map(|by| STEPS.map(|step| there(by, step * STEP)).to_vec());
        self
    }

    /// The same with a slope that the letter f stands for.
    #[must_use]
    pub fn sloping(self, slope: fn(N, N) -> N) -> Self {
        Self { slope: Some(slope), ..self }
    }

    /// The letters.
    pub fn letters(&self) -> &Letters<N> {
        &self.letters
    }

    fn value(&self, node: &Node) -> Option<N> {
        evaluate(node, &self.letters, Some(self))
    }

    /// How far the sides of an equation are apart, over the largest or one; none if a letter stands for nothing.
    fn misfit(&self, sides: &[Node]) -> Option<f64> {
        let values = sides.iter().map(|side| self.value(side)).collect::<Option<Vec<N>>>()?;
        let misfits = values.windows(2).map(|pair| {
            let size = pair[0].size().max(pair[1].size()).max(1.0);
            let misfit = (pair[0] - pair[1]).size() / size;
            // What has no value agrees with nothing.
            if misfit.is_nan() { f64::INFINITY } else { misfit }
        });
        misfits.reduce(f64::max)
    }
}

/// An equation: its sides.
pub struct Equation {
    sides: Vec<Node>,
    /// Whether it has derivatives, which are differences here.
    differs: bool,
}

impl Equation {
    /// Reads one; none if it cannot be read or equates nothing.
    pub fn read(tex: &str) -> Option<Self> {
        let sides = tex.split('=').map(tree::read).collect::<Option<Vec<_>>>().filter(|sides| sides.len() > 1)?;
        let differs = sides.iter().any(Node::differs);
        Some(Self { sides, differs })
    }

    /// Whether it holds at all of these instants; none if a letter stands for nothing.
    pub fn holds<'a, N: Number>(&self, moments: impl IntoIterator<Item = &'a Moment<N>>) -> Option<bool> {
        let allowed = if self.differs { DIFFERENCES } else { ROUTES };
        for moment in moments {
            if self.misfit(moment)? > allowed.relative {
                return Some(false);
            }
        }
        Some(true)
    }

    fn misfit<N: Number>(&self, moment: &Moment<N>) -> Option<f64> {
        moment.misfit(&self.sides)
    }
}

/// Whether an equation holds at all of these instants; none if it cannot be read.
pub fn holds<'a, N: Number>(tex: &str, moments: impl IntoIterator<Item = &'a Moment<N>>) -> Option<bool> {
    Equation::read(tex)?.holds(moments)
}

impl Node {
    fn collect(&self, letters: &mut BTreeSet<String>) {
        match self {
            Self::Number(_) => {}
            Self::Letter(name) => {
                letters.insert(name.clone());
            }
            Self::Minus(of) | Self::Of(_, of) | Self::Rate(_, of) => of.collect(letters),
            Self::Two(_, left, right) | Self::Slope(left, right) => {
                left.collect(letters);
                right.collect(letters);
            }
        }
    }

    fn differs(&self) -> bool {
        match self {
            Self::Number(_) | Self::Letter(_) => false,
            Self::Minus(of) | Self::Of(_, of) => of.differs(),
            Self::Two(_, left, right) | Self::Slope(left, right) => left.differs() || right.differs(),
            Self::Rate(..) => true,
        }
    }
}

/// The value of a formula with these letters. Only at the instant itself are there others beside it.
fn evaluate<N: Number>(node: &Node, letters: &Letters<N>, at: Option<&Moment<N>>) -> Option<N> {
    let of = |node: &Node| evaluate(node, letters, at);
    Some(match node {
        Node::Number(number) => N::real(*number),
        Node::Letter(name) => match letters.get(name) {
            Some(value) => *value,
            // A dot over a letter that has no value of its own with it.
            None if name.contains('\'') && !name.contains('/') => {
                of(&Node::Rate(By::Time, Box::new(Node::Letter(name.replacen('\'', "", 1)))))?
            }
            None => return None,
        },
        Node::Minus(node) => -of(node)?,
        Node::Two(joint, left, right) => {
            let (left, right) = (of(left)?, of(right)?);
            match joint {
                Joint::Plus => left + right,
                Joint::Times => left * right,
                Joint::Over => left / right,
                Joint::Power => left.power(right),
            }
        }
        Node::Of(function, node) => {
            let number = of(node)?;
            match function {
                Function::Size => N::real(number.size()),
                Function::Sine => number.sine(),
                Function::Cosine => number.cosine(),
                Function::Tangent => number.sine() / number.cosine(),
                Function::ArcSine => number.arc_sine(),
                Function::ArcCosine => number.arc_cosine(),
            }
        }
        Node::Rate(by, node) => {
            let beside = at.map(|at| &at.beside[*by as usize]).filter(|beside| !beside.is_empty())?;
            let mut sum = N::real(0.0);
            for (place, there) in beside.iter().enumerate() {
                let weight = WEIGHTS[place / 2] * STEPS[place].signum() / STEP;
                sum = sum + N::real(weight) * evaluate(node, there, None)?;
            }
            sum
        }
        Node::Slope(first, second) => (at?.slope?)(of(first)?, of(second)?),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn read(formula: &str) -> f64 {
        let letters =
            [("a", 3.0), ("x", 2.0), ("x'", 5.0), ("x''_0", 7.0), ("I_f", 11.0), ("y_n+1", 13.0), ("theta", 0.5)];
        value(formula, &letters.map(|(name, value)| (name.to_owned(), value)).into())
    }

    #[test]
    fn formulas_are_read_as_they_are_meant() {
        for (formula, expected) in [
            ("2ax", 12.0),
            (r"-a^2 + x", -7.0),
            (r"\frac{a + 1}{x} x^3", 16.0),
            (r"(a-x)/x a", 1.5),
            (r"\dot{x}^2 - \ddot{x}_0", 18.0),
            (r"I_f \left| x - a \right| x", 22.0),
            (r"a|x - \dot{x}|", 9.0),
            (r"\left\{ a \left[ x - 1 \right] \right\}", 3.0),
            (r"\left. \left[ a \right. \\ & \left. + x \right]", 5.0),
            (r"y_{n+1}^{1/2}", 13f64.sqrt()),
            (r"x[a + 2 ( a", 18.0),
            (r"a + x \right] \right]", 5.0),
            (r"\sin^2 \theta + \cos^2\theta a - 2\cos \theta \cos\theta", 1.0),
            (r"\cos^{-1}\left(\frac{1}{x}\right)", PI / 3.0),
            (r"\begin{aligned} a &+ x \\ &+ 1 \end{aligned}", 6.0),
            (r"2\sin(\pi/6)", 1.0),
            (r"\text{acos}\theta", libm::acos(0.5)),
        ] {
            approx(read(formula), expected, formula);
        }
    }

    #[track_caller]
    fn approx(found: f64, expected: f64, formula: &str) {
        assert!((found - expected).abs() < 1e-14 * expected.abs().max(1.0), "{formula}: {found}, not {expected}");
    }

    #[test]
    fn what_cannot_be_read_has_no_value() {
        for formula in ["", "a +", "b", r"\frac{a}", "a = x", "a) x", r"\unknown", "1.2.3", "a!", "f(a; x)"] {
            assert!(read(formula).is_nan(), "{formula}: {}", read(formula));
        }
        assert!(holds("a", &[Moment::of(Letters::from([("a".to_owned(), 1.0)]))]).is_none(), "it equates nothing");
    }

    #[test]
    fn derivatives_are_taken_by_what_stands_under_the_line() {
        // x = t³ + θ² θ'⁴ at t = 2, θ = 3, θ' = 1.5, all three of them free.
        let letters = |[t, angle, speed]: [f64; 3]| -> Letters {
            let x = t.powi(3) + angle.powi(2) * speed.powi(4);
            [("x", x), ("theta", angle), ("theta'", speed), ("dT/dtheta", 5.0)].map(|(n, v)| (n.to_owned(), v)).into()
        };
        let here = [2.0, 3.0, 1.5];
        let moment = Moment::of(letters(here)).moving(|by, step| {
            let mut there = here;
            there[by as usize] += step;
            letters(there)
        });
        for (tex, expected) in [
            (r"\frac{d}{dt} x^2 \frac{\partial T}{\partial \theta} = 1 + 60 (8 + 9 \dot\theta^4) ", Some(false)),
            (r"\frac{d}{dt} (x) = 12", Some(true)),
            (r"\frac{\partial}{\partial \theta} (x + \theta) = 2\theta\dot{\theta}^4 + 1", Some(true)),
            (r"\frac{\partial}{\partial \dot{\theta}} [x] = 4 \theta^2 \dot{\theta}^3", Some(true)),
            (r"\frac{\partial T}{\partial \theta} = 5", Some(true)),
            (r"\frac{\partial T}{\partial \dot\theta} = 5", None),
            (r"\frac{d}{dt} \frac{d}{dt} x = 12", None),
        ] {
            assert_eq!(holds(tex, [&moment]), expected, "{tex}");
        }
    }

    #[test]
    fn a_slope_is_a_function_of_two_numbers() {
        let letters: Letters = [("h", 2.0), ("y_n", 3.0)].map(|(name, value)| (name.to_owned(), value)).into();
        let moment = Moment::of(letters).sloping(|x, y| x - y);
        assert_eq!(holds(r"f\left(h + 1; y_n h\right) h = -6", [&moment]), Some(true));
        assert_eq!(holds(r"f(h) = 1", [&moment]), None);
    }
}
