//! JSON as a page reads it: texts, numbers, lists and objects, written without a library that reads it, too.

/// A text in quotes.
pub(crate) fn text(of: &str) -> String {
    let mut out = String::with_capacity(of.len() + 2);
    out.push('"');
    for c in of.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            c if c < ' ' => out.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A list of what is already JSON.
pub(crate) fn list(of: impl Iterator<Item = String>) -> String {
    between("[", of, "]")
}

/// An object of names and what is already JSON.
pub(crate) fn object<const N: usize>(of: [(&str, String); N]) -> String {
    between("{", of.into_iter().map(|(name, value)| text(name) + ":" + &value), "}")
}

fn between(open: &str, of: impl Iterator<Item = String>, close: &str) -> String {
    let mut out = open.to_owned();
    for (at, value) in of.enumerate() {
        out.push_str(if at == 0 { "" } else { "," });
        out.push_str(&value);
    }
    out + close
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, from_str, json};

    #[test]
    fn every_character_is_read_again() {
        let all: String = (0..0x3000).chain(0x1f300..0x1f400).filter_map(char::from_u32).collect();
        assert_eq!(from_str::<String>(&text(&all)).expect("JSON"), all);
    }

    #[test]
    fn lists_and_objects_are_json() {
        let read = |text: &str| from_str::<Value>(text).expect("JSON");
        let one = object([
            ("a\"b", text("x")),
            ("n", 7.to_string()),
            ("l", list(["1", "[]"].map(str::to_owned).into_iter())),
        ]);
        assert_eq!(read(&one), json!({ "a\"b": "x", "n": 7, "l": [1, []] }));
        assert_eq!(read(&list(std::iter::empty())), json!([]));
    }
}
