//! The numerator of an expression's value, in integers.
//!
//! Where the variables are integers, an expression is an integer over powers of those that it divides by. The
//! denominator is known from the steps, so it need not be computed: only numerators are, with no fraction to reduce. As
//! no divisor is zero, the expression is zero exactly if its numerator is.

use super::expression::Built;
use dashu_int::IBig;
use std::collections::{BTreeMap, HashMap};

/// What was divided by: the number of each divisor's numerator, with its power.
type Divisors = BTreeMap<usize, u32>;

/// How an integer is made of others that stand before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Made {
    Variable(usize),
    Integer(i64),
    Negated(usize),
    Sum(usize, usize),
    Product(usize, usize),
}

/// The integers that an expression's numerator is made of, for one point of a grid after another.
pub(super) struct Numerator {
    /// For each variable the numbers that change if it and those before it do.
    changing: Vec<Vec<(usize, Made)>>,
    values: Vec<IBig>,
    /// The numerators of all that is divided by.
    divisors: Vec<usize>,
    whole: usize,
}

/// The numbers that are needed so far, each once.
#[derive(Default)]
struct Needed {
    made: Vec<Made>,
    places: HashMap<Made, usize>,
}

impl Needed {
    fn place(&mut self, made: Made) -> usize {
        *self.places.entry(made).or_insert_with(|| {
            self.made.push(made);
            self.made.len() - 1
        })
    }

    fn product(&mut self, a: Option<usize>, b: Option<usize>) -> Option<usize> {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.place(Made::Product(a.min(b), a.max(b)))),
            (one, None) | (None, one) => one,
        }
    }

    /// A number times those powers of divisors that it has less than `common`.
    fn raised(&mut self, number: usize, own: &Divisors, common: &Divisors) -> usize {
        let mut factor = None;
        for (divisor, power) in common {
            for _ in own.get(divisor).copied().unwrap_or(0)..*power {
                factor = self.product(factor, Some(*divisor));
            }
        }
        self.product(factor, Some(number)).unwrap_or(number)
    }
}

impl Numerator {
    /// Of the last of these steps, in which no root stands.
    pub(super) fn of(steps: &[Built<usize>], variables: usize) -> Self {
        let mut needed = Needed::default();
        let mut all_divisors = Vec::new();
        // For each step the place of its numerator, and what that is over.
        let mut fractions: Vec<(usize, Divisors)> = Vec::with_capacity(steps.len());
        for step in steps {
            let next = match *step {
                Built::Variable(index) => (needed.place(Made::Variable(index)), Divisors::new()),
                Built::Integer(n) => (needed.place(Made::Integer(n)), Divisors::new()),
                Built::Root => (needed.place(Made::Integer(0)), Divisors::new()),
                Built::Negated(a) => {
                    let (number, divisors) = &fractions[a];
                    (needed.place(Made::Negated(*number)), divisors.clone())
                }
                Built::Sum(a, b) => {
                    let ((a, over_a), (b, over_b)) = (&fractions[a], &fractions[b]);
                    let mut common = over_a.clone();
                    for (divisor, power) in over_b {
                        let most = common.entry(*divisor).or_insert(0);
                        *most = (*most).max(*power);
                    }
                    let (a, b) = (needed.raised(*a, over_a, &common), needed.raised(*b, over_b, &common));
                    (needed.place(Made::Sum(a, b)), common)
                }
                Built::Product(a, b) => {
                    let ((a, over_a), (b, over_b)) = (&fractions[a], &fractions[b]);
                    let mut divisors = over_a.clone();
                    for (divisor, power) in over_b {
                        *divisors.entry(*divisor).or_insert(0) += power;
                    }
                    // A factor that was divided by cancels.
                    let left = [*a, *b].map(|factor| match divisors.get_mut(&factor) {
                        Some(power) if *power > 0 => {
                            *power -= 1;
                            None
                        }
                        _ => Some(factor),
                    });
                    divisors.retain(|_, power| *power > 0);
                    let product = needed.product(left[0], left[1]);
                    (product.unwrap_or_else(|| needed.place(Made::Integer(1))), divisors)
                }
                Built::Quotient(a, b) => {
                    let ((a, over_a), (b, over_b)) = (&fractions[a], &fractions[b]);
                    let number = needed.raised(*a, over_a, over_b);
                    let mut divisors = over_a.clone();
                    for (divisor, power) in over_b {
                        if let Some(own) = divisors.get_mut(divisor) {
                            *own = own.saturating_sub(*power);
                        }
                    }
                    divisors.retain(|_, power| *power > 0);
                    *divisors.entry(*b).or_insert(0) += 1;
                    all_divisors.push(*b);
                    (number, divisors)
                }
            };
            fractions.push(next);
        }
        let whole = fractions.pop().map_or_else(|| needed.place(Made::Integer(0)), |(number, _)| number);
        all_divisors.sort_unstable();
        all_divisors.dedup();
        Self::made_of(&needed.made, variables, all_divisors, whole)
    }

    fn made_of(made: &[Made], variables: usize, divisors: Vec<usize>, whole: usize) -> Self {
        let mut changing = vec![Vec::new(); variables];
        let mut values = Vec::with_capacity(made.len());
        // The first variable that a number depends on: it changes the most often.
        let mut first: Vec<usize> = Vec::with_capacity(made.len());
        for (place, made) in made.iter().enumerate() {
            let own = match *made {
                Made::Variable(index) => index,
                Made::Integer(_) => variables,
                Made::Negated(a) => first[a],
                Made::Sum(a, b) | Made::Product(a, b) => first[a].min(first[b]),
            };
            first.push(own);
            changing[own.min(variables)..].iter_mut().for_each(|numbers| numbers.push((place, *made)));
            let constant = if own < variables { IBig::ZERO } else { value(made, &values, &[]) };
            values.push(constant);
        }
        Self { changing, values, divisors, whole }
    }

    /// Goes to another point, of which `changed` is the last variable that has another value than before. Whether the
    /// numerator is zero there; none if something that is divided by is.
    pub(super) fn is_zero_at(&mut self, at: &[usize], changed: usize) -> Option<bool> {
        if let Some(numbers) = self.changing.get(changed) {
            for (place, made) in numbers {
                self.values[*place] = value(made, &self.values, at);
            }
        }
        let is_zero = |place: &usize| self.values[*place] == IBig::ZERO;
        (!self.divisors.iter().any(is_zero)).then(|| is_zero(&self.whole))
    }
}

fn value(made: &Made, values: &[IBig], at: &[usize]) -> IBig {
    match *made {
        Made::Variable(index) => IBig::from(at[index]),
        Made::Integer(n) => IBig::from(n),
        Made::Negated(a) => -&values[a],
        Made::Sum(a, b) => &values[a] + &values[b],
        Made::Product(a, b) => &values[a] * &values[b],
    }
}
