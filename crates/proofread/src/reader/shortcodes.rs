//! Shortcodes of Hugo, such as `{{< math >}}` around a formula, are marks that nobody sees.

/// Longest shortcode, in bytes.
const LONGEST: usize = 300;
/// Space of three bytes, which does not set a line of Markdown in as spaces would. What stands in place of a shortcode ends with it.
pub(crate) const WIDE: &str = "\u{2003}";

/// The text with space of as many bytes in place of its shortcodes; none if there are none.
pub(crate) fn without_shortcodes(text: &str) -> Option<String> {
    let mut out: Option<String> = None;
    let (mut from, mut searched) = (0, 0);
    while let Some(at) = text[searched..].find("{{").map(|at| searched + at) {
        searched = at + 2;
        let end = match text.as_bytes().get(at + 2) {
            Some(b'<') => ">}}",
            Some(b'%') => "%}}",
            _ => continue,
        };
        let Some(length) = text[at..].find(end).map(|found| found + end.len()) else { continue };
        let code = &text[at..at + length];
        if length > LONGEST || code.contains(['\n', '$']) {
            continue;
        }
        let out = out.get_or_insert_with(|| String::with_capacity(text.len()));
        out.push_str(&text[from..at]);
        (0..length % WIDE.len()).for_each(|_| out.push(' '));
        (0..length / WIDE.len()).for_each(|_| out.push_str(WIDE));
        (from, searched) = (at + length, at + length);
    }
    out.map(|out| out + &text[from..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_stay_where_they_are() {
        for text in ["a {{< math >}}$x${{< /math >}} b", "{{% é %}}c", "{{<é>}}", "x{{< a >}}{{< b >}}y"] {
            let shown = without_shortcodes(text).expect("it has shortcodes");
            assert_eq!(shown.len(), text.len());
            assert!(!shown.contains("{{"), "{shown}");
            let rest: Vec<_> = shown.match_indices(|c: char| c.is_ascii_alphabetic() || c == '$').collect();
            assert!(rest.iter().all(|(at, sign)| text[*at..].starts_with(sign)), "{text}");
        }
        for text in ["{{x}}", "{{< a", "{{< $1 >}}", "{{< a\nb >}}", ""] {
            assert_eq!(without_shortcodes(text), None, "{text}");
        }
    }
}
