//! Lengths as they are written.

/// A length with at most three decimals.
pub(super) fn mm(x: f64) -> String {
    let text = format!("{x:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A deviation with its sign.
pub(super) fn deviation(x: f64) -> String {
    match mm(x.abs()) {
        zero if zero == "0" => zero,
        text if x < 0.0 => format!("−{text}"),
        text => format!("+{text}"),
    }
}
