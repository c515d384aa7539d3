//! Units that are written as products and quotients of others.

use crate::unit::{MeasurementUnit, UnitDimension, unit};

/// The unit that a product or quotient of units names, such as `m/s^2`, `kg m² s⁻²` or `%`; none if a part of it is unknown.
///
/// A stroke divides by the one unit behind it.
///
/// ```
/// use proofread::unit_named;
///
/// let speed = unit_named("km/h").expect("a unit");
/// assert!((speed.factor - 1.0 / 3.6).abs() < 1e-15);
/// assert_eq!(speed.dimension, unit_named("m s^-1").expect("a unit").dimension);
/// assert_eq!(unit_named("m/xyz"), None);
/// ```
pub fn unit_named(text: &str) -> Option<MeasurementUnit> {
    /// Most units in a product.
    const MOST: usize = 12;
    let mut product = MeasurementUnit { factor: 1.0, dimension: UnitDimension::NONE };
    let (mut rest, mut divides, mut count) = (text.trim(), false, 0);
    while !rest.is_empty() {
        let (name, power, behind) = factor(rest)?;
        let one = unit(name)?;
        let power = if divides { -power } else { power };
        product.factor *= libm::pow(one.factor, f64::from(power));
        product.dimension = product.dimension.with_factor(one.dimension, f64::from(power));
        let trimmed = behind.trim_start_matches([' ', '·', '⋅', '*']);
        divides = trimmed.starts_with('/');
        rest = trimmed.trim_start_matches('/').trim_start();
        count += 1;
        if (divides && rest.is_empty()) || count > MOST {
            return None;
        }
    }
    (count > 0).then_some(product)
}

/// The name of the first unit, its power, and what is behind it.
fn factor(text: &str) -> Option<(&str, i32, &str)> {
    let is_of_name = |c: char| c.is_alphabetic() || matches!(c, '°' | '%' | '$' | '⊙' | 'ℓ');
    let end = text.find(|c| !is_of_name(c)).unwrap_or(text.len());
    let (name, behind) = text.split_at(end);
    if name.is_empty() {
        return None;
    }
    if let Some(raised) = behind.strip_prefix('^') {
        let closes = |open: char| match open {
            '{' => Some('}'),
            '(' => Some(')'),
            _ => None,
        };
        if let Some(close) = raised.chars().next().and_then(closes) {
            let (power, behind) = raised[1..].split_once(close)?;
            return Some((name, small_power(power)?, behind));
        }
        let end = raised.find(|c: char| !c.is_ascii_digit() && !matches!(c, '-' | '−')).unwrap_or(raised.len());
        return Some((name, small_power(&raised[..end])?, &raised[end..]));
    }
    let end = behind.find(|c| !"⁻¹²³⁴".contains(c)).unwrap_or(behind.len());
    if end == 0 {
        return Some((name, 1, behind));
    }
    let plain = |c| match c {
        '⁻' => '-',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        _ => '4',
    };
    let power: String = behind[..end].chars().map(plain).collect();
    Some((name, small_power(&power)?, &behind[end..]))
}

/// A power within what units have.
fn small_power(text: &str) -> Option<i32> {
    text.trim().replace('−', "-").parse().ok().filter(|power: &i32| (-12..=12).contains(power) && *power != 0)
}
