//! Pieces that the sheets and drawings of the commands share.

/// Digits of a number on a sheet.
pub const DIGITS: usize = 4;

/// `value` with [`DIGITS`] significant digits: trailing zeros kept, and no more zeros than a reader counts.
pub fn number(value: f64) -> String {
    let scientific = format!("{value:.*e}", DIGITS - 1);
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()).unwrap_or(0);
    match usize::try_from(DIGITS as i32 - 1 - exponent) {
        _ if value == 0.0 => "0".to_owned(),
        Ok(decimals) if decimals < 2 * DIGITS => format!("{value:.decimals$}"),
        Err(_) if exponent < 2 * DIGITS as i32 => format!("{value:.0}"),
        _ => scientific,
    }
}

/// What stands before the point, and the rest with it.
pub fn split(number: &str) -> (&str, &str) {
    number.split_at(number.find('.').unwrap_or(number.len()))
}

/// Characters of the longest.
pub fn longest<'a>(texts: impl Iterator<Item = &'a str>) -> usize {
    texts.map(|text| text.chars().count()).max().unwrap_or(0)
}

/// The drawing with fixed colours: each custom property, which only a page can set and only a browser understands,
/// gives way to what stands behind it.
pub fn standalone(svg: &str) -> String {
    let mut parts = svg.split("var(--");
    let mut fixed = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once(')').and_then(|(property, rest)| Some((property.split_once(", ")?.1, rest))) {
            Some((colour, rest)) => fixed.extend([colour, rest]),
            None => fixed.extend(["var(--", part]),
        }
    }
    fixed
}

#[cfg(test)]
mod tests {
    use super::{number, standalone};

    #[test]
    fn numbers_have_a_few_digits_and_no_long_rows_of_zeros() {
        let written = [0.0, 2.0, 1.0 / 3.0, 99.999, 12_345.6, 1e9, 1e-9].map(number);
        assert_eq!(written, ["0", "2.000", "0.3333", "100.0", "12346", "1.000e9", "1.000e-9"]);
    }

    #[test]
    fn colours_of_the_page_give_way_to_their_fallbacks() {
        let svg = "<g fill=\"var(--a, #111)\" stroke=\"var(--b)\"><path stroke=\"var(--c, #222)\"/></g>";
        assert_eq!(standalone(svg), "<g fill=\"#111\" stroke=\"var(--b)\"><path stroke=\"#222\"/></g>");
        assert_eq!(standalone("<g/>"), "<g/>");
    }
}
