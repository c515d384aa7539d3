//! A number of our own: how it is shown, a route to it, and a second one where a conclusion leans on it.
//!
//! No source prints such a number, so nothing says what it should be and no verdict is passed on it. What is concluded from
//! it must not hang on one program, though: [`OwnNumber::check`] holds the two routes against each other.

use crate::agreement::range;
use crate::number_format::{fixed, signed, significant};
use crate::{Agreement, Evidence, Tolerance};
use std::error::Error;

/// What a route gives: numbers in the order in which the form shows them, or why there are none.
pub type Numbers<N = Vec<f64>> = Result<N, Box<dyn Error + Send + Sync>>;

/// Nothing may differ: what is counted or put in is the same or it is not.
static EXACTLY: Tolerance =
    Tolerance { name: "exactly", relative: 0.0, reason: "what is counted, or put in, is the same or it is not" };

/// A tally of records, such as the verdicts or the printed rows: nothing but the records says what it is.
pub const RECORD: &Evidence = &Evidence {
    slug: "record",
    name: "a record",
    meaning: "taken from records: of verdicts, printed rows and measured times",
    agreement: Agreement::Within(&EXACTLY),
};

/// A number that is put in and not found: cited beside it, or chosen.
pub const GIVEN: &Evidence = &Evidence {
    slug: "given",
    name: "given",
    meaning: "cited, or chosen by us",
    agreement: Agreement::Within(&EXACTLY),
};

/// A number that no source prints, with how it is shown and the routes to it.
pub struct OwnNumber {
    /// Stable id: words joined by hyphens and points.
    pub id: &'static str,
    /// The conclusion that leans on it, in a few words; empty if none does.
    pub conclusion: &'static str,
    form: Form,
    first: OwnRoute,
    second: Option<OwnRoute>,
    /// Difference that is allowed besides that of the kinds, in the number's own unit.
    pub allowance: f64,
}

/// A way to the numbers that a form shows.
struct OwnRoute {
    kind: &'static Evidence,
    run: Box<dyn Fn() -> Numbers + Send + Sync>,
}

/// How numbers become characters.
///
/// ```
/// use geneva_evidence::{Evidence, Form, OwnNumber};
///
/// let height = OwnNumber::new("drop.height", "{.1}&nbsp;m", Evidence::CLOSED_FORM, || Ok(9.81 / 2.0));
/// assert_eq!(height.show().expect("a number"), "4.9&nbsp;m");
/// let range = OwnNumber::new("drop.range", Form::Range("{.1}", " m"), Evidence::CLOSED_FORM, || Ok([3.0, 1.0]));
/// assert_eq!(range.show().expect("numbers"), "1.0 to 3.0 m");
/// ```
#[derive(Clone, Copy)]
pub enum Form {
    /// Text with a hole for each number: `{.2}` rounds to two decimals, `{+.2}` gives the sign too, `{2}` rounds to two digits
    /// that count, and `{,}` to an integer with a comma between thousands.
    Text(&'static str),
    /// The least and the greatest of any count of numbers, each in this hole, with *to* between them and this unit behind; once
    /// if they look alike.
    Range(&'static str, &'static str),
    /// Characters that a function makes.
    Written(fn(&[f64]) -> String),
}

/// How well a number of our own is backed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backing {
    /// It is put in: see [`GIVEN`].
    Given,
    /// It is a count of records: see [`RECORD`].
    Count,
    /// It has one route.
    OneRoute,
    /// It has two routes.
    TwoRoutes,
}

impl Backing {
    /// All kinds, the best backed first.
    pub const ALL: [Self; 4] = [Self::TwoRoutes, Self::OneRoute, Self::Count, Self::Given];

    /// What it means, for readers.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::TwoRoutes => "computed by two routes, which agree",
            Self::OneRoute => "computed by one route only",
            Self::Count => "counted in our own records",
            Self::Given => GIVEN.meaning,
        }
    }
}

/// The ids of the numbers that are backed so, in their order: with [`Backing::OneRoute`] those that one route alone gives.
pub fn ids_with_backing(numbers: &[OwnNumber], backing: Backing) -> Vec<&'static str> {
    numbers.iter().filter(|number| number.backing() == backing).map(|number| number.id).collect()
}

/// What a route may return: a number, or several in an array or a vector.
pub trait IntoNumbers {
    /// The numbers in their order.
    fn into_numbers(self) -> Vec<f64>;
}

impl OwnNumber {
    /// A number with one route.
    pub fn new<N: IntoNumbers>(
        id: &'static str,
        form: impl Into<Form>,
        kind: &'static Evidence,
        run: impl Fn() -> Numbers<N> + Send + Sync + 'static,
    ) -> Self {
        let first = OwnRoute::new(kind, run);
        Self { id, conclusion: "", form: form.into(), first, second: None, allowance: 0.0 }
    }

    /// A count of records.
    pub fn count<N: IntoNumbers>(id: &'static str, run: impl Fn() -> Numbers<N> + Send + Sync + 'static) -> Self {
        Self::new(id, "{.0}", RECORD, run)
    }

    /// Adds a route that shares no code with the first, and the conclusion that leans on the number.
    #[must_use]
    pub fn with_second_route<N: IntoNumbers>(
        self,
        conclusion: &'static str,
        kind: &'static Evidence,
        run: impl Fn() -> Numbers<N> + Send + Sync + 'static,
    ) -> Self {
        Self { conclusion, second: Some(OwnRoute::new(kind, run)), ..self }
    }

    /// Lets the routes differ by so much in the number's own unit, besides what their kinds allow.
    #[must_use]
    pub fn with_allowance(self, allowance: f64) -> Self {
        Self { allowance, ..self }
    }

    /// The characters that the first route gives.
    ///
    /// # Errors
    ///
    /// Why the route gives no numbers, and a form that does not suit them.
    pub fn show(&self) -> Numbers<String> {
        self.form.write(&(self.first.run)()?)
    }

    /// How well the number is backed, without running a route.
    pub fn backing(&self) -> Backing {
        match (&self.second, self.first.kind.slug) {
            (Some(_), _) => Backing::TwoRoutes,
            (None, slug) if slug == RECORD.slug => Backing::Count,
            (None, slug) if slug == GIVEN.slug => Backing::Given,
            (None, _) => Backing::OneRoute,
        }
    }

    /// The kinds of its routes, the first route's first.
    pub fn kinds(&self) -> impl Iterator<Item = &'static Evidence> {
        [Some(&self.first), self.second.as_ref()].into_iter().flatten().map(|route| route.kind)
    }

    /// Runs the routes. Two must give the same characters, and numbers no farther apart than their kinds allow.
    ///
    /// # Errors
    ///
    /// What the routes disagree on, and why one gives nothing; each with the id.
    pub fn check(&self) -> Numbers<Backing> {
        let [first, second] = self.run_routes()?;
        self.compare(&first, &second)?;
        Ok(self.backing())
    }

    /// The numbers of both routes; those of the first twice if there is no other.
    ///
    /// # Errors
    ///
    /// Why one gives nothing, with the id.
    pub fn run_routes(&self) -> Numbers<[Vec<f64>; 2]> {
        let run = |route: &OwnRoute| (route.run)().map_err(|error| format!("{}: {error}", self.id));
        let first = run(&self.first)?;
        let second = self.second.as_ref().map(run).transpose()?;
        Ok([first.clone(), second.unwrap_or(first)])
    }

    /// Compares the numbers of two routes, as [`OwnNumber::check`] says.
    ///
    /// # Errors
    ///
    /// What they disagree on, with the id.
    pub fn compare(&self, first: &[f64], second: &[f64]) -> Numbers<()> {
        let tolerance = self.kinds().filter_map(Evidence::tolerance).map(|kind| kind.relative).fold(0.0, f64::max);
        let agree = |(a, b): (&f64, &f64)| (a - b).abs() <= self.allowance + tolerance * a.abs().max(b.abs());
        if first.len() != second.len() || !first.iter().zip(second).all(agree) {
            return Err(format!("{}: {first:?} by one route and {second:?} by the other", self.id).into());
        }
        let write = |numbers| self.form.write(numbers).map_err(|error| format!("{}: {error}", self.id));
        let (shown, other) = (write(first)?, write(second)?);
        if shown != other {
            return Err(format!("{}: shown as {shown} by one route and as {other} by the other", self.id).into());
        }
        Ok(())
    }
}

impl OwnRoute {
    fn new<N: IntoNumbers>(kind: &'static Evidence, run: impl Fn() -> Numbers<N> + Send + Sync + 'static) -> Self {
        Self { kind, run: Box::new(move || Ok(run()?.into_numbers())) }
    }
}

impl Form {
    /// The characters for these numbers.
    fn write(&self, numbers: &[f64]) -> Numbers<String> {
        match self {
            Self::Text(text) => fill(text, numbers),
            Self::Range(hole, unit) => {
                if numbers.is_empty() {
                    return Err("there are no numbers".into());
                }
                let [least, greatest] = range(numbers.iter().copied()).map(|end| fill(hole, &[end]));
                let (least, greatest) = (least?, greatest?);
                Ok(if least == greatest { least + unit } else { format!("{least} to {greatest}{unit}") })
            }
            Self::Written(write) => Ok(write(numbers)),
        }
    }
}

/// A text with its holes filled, one for each number.
fn fill(text: &str, numbers: &[f64]) -> Numbers<String> {
    let (mut filled, mut rest, mut numbers) = (String::new(), text, numbers.iter());
    while let Some((before, after)) = rest.split_once('{') {
        let (hole, behind) = after.split_once('}').ok_or_else(|| format!("`{text}`: a hole has no end"))?;
        let number = numbers.next().ok_or_else(|| format!("`{text}`: more holes than numbers"))?;
        let number = round(hole, *number).ok_or_else(|| format!("`{text}`: `{hole}` is no rounding"))?;
        filled.extend([before, &number]);
        rest = behind;
    }
    match numbers.next() {
        Some(_) => Err(format!("`{text}`: more numbers than holes").into()),
        None => Ok(filled + rest),
    }
}

/// A number as a hole rounds it; none if the hole says nothing that is known.
fn round(hole: &str, number: f64) -> Option<String> {
    if hole == "," {
        let digits = fixed(number, 0);
        let at = digits.len().checked_sub(3).filter(|at| *at > 0);
        return Some(at.map_or_else(|| digits.clone(), |at| format!("{},{}", &digits[..at], &digits[at..])));
    }
    let decimals = |text: &str| text.parse::<usize>().ok();
    match (hole.strip_prefix("+."), hole.strip_prefix('.')) {
        (Some(digits), _) => Some(signed(number, decimals(digits)?)),
        (None, Some(digits)) => Some(fixed(number, decimals(digits)?)),
        (None, None) => Some(significant(number, decimals(hole)?)),
    }
}

impl From<&'static str> for Form {
    fn from(text: &'static str) -> Self {
        Self::Text(text)
    }
}

impl IntoNumbers for f64 {
    fn into_numbers(self) -> Vec<f64> {
        vec![self]
    }
}

impl IntoNumbers for usize {
    fn into_numbers(self) -> Vec<f64> {
        vec![self as f64]
    }
}

impl IntoNumbers for u32 {
    fn into_numbers(self) -> Vec<f64> {
        vec![f64::from(self)]
    }
}

impl<T: IntoNumbers> IntoNumbers for Vec<T> {
    fn into_numbers(self) -> Vec<f64> {
        self.into_iter().flat_map(IntoNumbers::into_numbers).collect()
    }
}

impl<T: IntoNumbers, const N: usize> IntoNumbers for [T; N] {
    fn into_numbers(self) -> Vec<f64> {
        self.into_iter().flat_map(IntoNumbers::into_numbers).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    static NEAR: Tolerance = Tolerance { name: "near", relative: 1e-6, reason: "made up" };
    static ROUGH: Tolerance = Tolerance { name: "rough", relative: 0.02, reason: "made up" };
    const CLOSE: &Evidence =
        &Evidence { slug: "close", name: "close", meaning: "a close route", agreement: Agreement::Within(&NEAR) };
    const FAR: &Evidence =
        &Evidence { slug: "far", name: "far", meaning: "a rough route", agreement: Agreement::Within(&ROUGH) };

    fn number(kind: &'static Evidence, second: f64) -> OwnNumber {
        OwnNumber::new("length", "{.1}&nbsp;mm", CLOSE, || Ok(2.04))
            .with_second_route("it fits", kind, move || Ok(second))
    }

    #[test]
    fn two_routes_agree_as_numbers_and_as_characters() {
        assert_eq!(number(CLOSE, 2.04 * (1.0 + 0.9e-6)).check().expect("agreed"), Backing::TwoRoutes);
        for (kind, second, words) in [
            (CLOSE, 2.04 * (1.0 + 1.1e-6), "by one route and"),
            (CLOSE, f64::NAN, "by one route and"),
            // Near enough for a rough route, but on the other side of an edge of the rounding.
            (FAR, 2.06, "shown as 2.0&nbsp;mm by one route and as 2.1&nbsp;mm"),
        ] {
            let error = number(kind, second).check().expect_err("another number").to_string();
            assert!(error.contains(words), "{error}");
        }
        assert!(number(CLOSE, 2.03).with_allowance(0.011).check().is_ok());
        assert!(number(CLOSE, 2.03).with_allowance(0.009).check().is_err());
    }

    #[test]
    fn what_has_one_route_says_so() {
        let of = |kind| OwnNumber::new("count", "{.0}", kind, || Ok(3_usize)).check().expect("a number");
        assert_eq!([CLOSE, RECORD, GIVEN].map(of), [Backing::OneRoute, Backing::Count, Backing::Given]);
        let fails = OwnNumber::new("none", "{.0}", CLOSE, || Err::<f64, _>("no run".into()));
        assert_eq!(fails.check().expect_err("no number").to_string(), "none: no run");
    }

    #[test]
    fn a_form_has_a_hole_for_each_number() {
        let write = |form: Form, numbers: &[f64]| form.write(numbers).map_err(|error| error.to_string());
        let text = |text, numbers: &[f64]| write(Form::Text(text), numbers);
        assert_eq!(
            text("{,} of {,} ({.1}&nbsp;%)", &[999.0, 12_345.0, 8.09]).expect("filled"),
            "999 of 12,345 (8.1&nbsp;%)"
        );
        assert_eq!(text("{+.0} to {3}", &[-2.0, 0.123_45]).expect("filled"), "−2 to 0.123");
        for (form, numbers, words) in [
            ("{.0}", &[1.0, 2.0][..], "more numbers than holes"),
            ("{.0} {.0}", &[1.0], "more holes than numbers"),
            ("{x}", &[1.0], "`x` is no rounding"),
            ("{.1", &[1.0], "a hole has no end"),
        ] {
            assert!(text(form, numbers).expect_err("a wrong form").contains(words), "{form}");
        }
        let range = Form::Range("{.1}", "°");
        assert_eq!(write(range, &[3.0, 1.0, 2.0]).expect("a range"), "1.0 to 3.0°");
        assert_eq!(write(range, &[1.0, 1.04]).expect("a range"), "1.0°");
        assert!(write(range, &[]).is_err());
    }
}
