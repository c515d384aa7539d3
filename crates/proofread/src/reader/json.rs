//! JSON as stretches of its text: the members of an object and the items of a list.
//!
//! What a value holds is looked at no closer than its brackets and texts, since nothing else is read of it. So a page's module needs no
//! library for JSON, and lists within lists cost no depth of calls.

/// A text that is no JSON, by the place in bytes where that shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NoJson {
    /// What should be there.
    pub expected: &'static str,
    /// Where.
    pub at: usize,
}

/// The members of an object: their names as they are written between the quotes, and their values.
pub(crate) fn members(object: &str) -> Result<Vec<(&str, &str)>, NoJson> {
    let mut reader = JsonReader { text: object, at: 0 };
    let mut out = Vec::new();
    reader.list('{', '}', "an object", &mut |reader| {
        let name = reader.string()?;
        reader.sign(':', "a colon behind a name")?;
        out.push((&name[1..name.len() - 1], reader.value()?));
        Ok(())
    })?;
    Ok(out)
}

/// The items of a list.
pub(crate) fn items(list: &str) -> Result<Vec<&str>, NoJson> {
    let mut reader = JsonReader { text: list, at: 0 };
    let mut out = Vec::new();
    reader.list('[', ']', "a list", &mut |reader| {
        out.push(reader.value()?);
        Ok(())
    })?;
    Ok(out)
}

/// A place in a text, from which one thing after the other is taken.
struct JsonReader<'t> {
    text: &'t str,
    at: usize,
}

impl<'t> JsonReader<'t> {
    /// The byte ahead, behind space.
    fn ahead(&mut self) -> Option<u8> {
        let rest = &self.text.as_bytes()[self.at..];
        self.at += rest.iter().position(|byte| !matches!(byte, b' ' | b'\n' | b'\r' | b'\t')).unwrap_or(rest.len());
        self.text.as_bytes().get(self.at).copied()
    }

    fn refused<T>(&self, expected: &'static str) -> Result<T, NoJson> {
        Err(NoJson { expected, at: self.at })
    }

    fn is_next(&mut self, sign: char) -> bool {
        let is_next = self.ahead() == Some(sign as u8);
        self.at += usize::from(is_next);
        is_next
    }

    fn sign(&mut self, sign: char, expected: &'static str) -> Result<(), NoJson> {
        if self.is_next(sign) { Ok(()) } else { self.refused(expected) }
    }

    /// Everything in a text, from one bracket to the other, with commas between.
    fn list(
        &mut self,
        open: char,
        close: char,
        expected: &'static str,
        each: &mut dyn FnMut(&mut Self) -> Result<(), NoJson>,
    ) -> Result<(), NoJson> {
        self.sign(open, expected)?;
        if !self.is_next(close) {
            loop {
                each(self)?;
                if self.is_next(close) {
                    break;
                }
                self.sign(',', "a comma or a closing bracket")?;
            }
        }
        if self.ahead().is_some() { self.refused("the end") } else { Ok(()) }
    }

    /// A string with its quotes.
    fn string(&mut self) -> Result<&'t str, NoJson> {
        if self.ahead() != Some(b'"') {
            return self.refused("a string in quotes");
        }
        let start = self.at;
        let mut escaped = true;
        for (length, byte) in self.text.as_bytes()[start..].iter().enumerate() {
            match byte {
                _ if escaped => escaped = false,
                b'\\' => escaped = true,
                b'"' => {
                    self.at = start + length + 1;
                    return Ok(&self.text[start..self.at]);
                }
                0..b' ' => {
                    self.at = start + length;
                    return self.refused("an escape for a control character");
                }
                _ => {}
            }
        }
        self.at = self.text.len();
        self.refused("the end of a string")
    }

    /// Any value.
    fn value(&mut self) -> Result<&'t str, NoJson> {
        let mut open = Vec::new();
        let first = self.ahead();
        let start = self.at;
        let mut ahead = first;
        loop {
            match ahead {
                Some(b'"') => {
                    self.string()?;
                }
                Some(bracket @ (b'{' | b'[')) => {
                    open.push(bracket);
                    self.at += 1;
                }
                // Two places on in the table of characters.
                Some(bracket @ (b'}' | b']')) if open.last() == Some(&(bracket - 2)) => {
                    open.pop();
                    self.at += 1;
                }
                Some(b',' | b':') if !open.is_empty() => self.at += 1,
                Some(byte) if byte.is_ascii_alphanumeric() || byte == b'-' => {
                    let rest = &self.text.as_bytes()[self.at..];
                    let is_plain = |byte: &u8| byte.is_ascii_alphanumeric() || b"+-.".contains(byte);
                    self.at += rest.iter().position(|byte| !is_plain(byte)).unwrap_or(rest.len());
                }
                Some(_) => return self.refused("a value"),
                None => return self.refused("the rest of a value"),
            }
            if open.is_empty() {
                return Ok(&self.text[start..self.at]);
            }
            ahead = self.ahead();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_and_items_are_cut_out_as_they_are_written() {
        let object = " {\"a\" : [1, {\"b\":\"]}\"}], \"c\\\"\": \"x\\\\\" ,\n\"d\":-1.5e+3, \"e\":null} ";
        let expected = [("a", "[1, {\"b\":\"]}\"}]"), ("c\\\"", "\"x\\\\\""), ("d", "-1.5e+3"), ("e", "null")];
        assert_eq!(members(object).as_deref(), Ok(&expected[..]));
        assert_eq!(items("[\"a\",[],{} , true]"), Ok(vec!["\"a\"", "[]", "{}", "true"]));
        assert_eq!((members("{}"), items(" [ ] ")), (Ok(vec![]), Ok(vec![])));
    }

    #[test]
    fn what_is_no_json_is_told_by_its_place() {
        for (text, expected, at) in [
            ("[1]", "an object", 0),
            ("{", "a string in quotes", 1),
            ("{a:1}", "a string in quotes", 1),
            ("{\"a\" 1}", "a colon behind a name", 5),
            ("{\"a\":}", "a value", 5),
            ("{\"a\":1,}", "a string in quotes", 7),
            ("{\"a\":1 \"b\":2}", "a comma or a closing bracket", 7),
            ("{\"a\":[1}", "a value", 7),
            ("{\"a\":[1", "the rest of a value", 7),
            ("{\"a\":\"b", "the end of a string", 7),
            ("{\"a\":\"b\n\"}", "an escape for a control character", 7),
            ("{\"a\":1} x", "the end", 8),
        ] {
            assert_eq!(members(text), Err(NoJson { expected, at }), "{text}");
        }
        assert_eq!(items("[1"), Err(NoJson { expected: "a comma or a closing bracket", at: 2 }));
        let deep = "[".repeat(1_000_000);
        assert_eq!(items(&deep), Err(NoJson { expected: "the rest of a value", at: 1_000_000 }));
    }
}
