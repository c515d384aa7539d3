//! Messages on a stream: a header with the length of what follows, an empty line, and JSON.

use serde_json::Value;
use std::io::{self, BufRead, Read, Write};

/// Longest line of a header, in bytes.
const LONGEST_LINE: u64 = 8 << 10;
/// Longest message, in bytes: the longest document with all its characters as escapes.
const LONGEST_MESSAGE: u64 = 512 << 20;

/// What stands next on a stream.
#[derive(Debug, PartialEq)]
pub(super) enum Incoming {
    /// A message, which is JSON.
    Message(Value),
    /// Something that is no message, with the reason. What follows may be one.
    Malformed(String),
}

/// Reads what stands next on a stream; none at its end.
pub(super) fn read_message(stream: &mut impl BufRead) -> io::Result<Option<Incoming>> {
    let mut length = None;
    let mut is_empty = true;
    loop {
        let mut line = Vec::new();
        stream.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut line)?;
        if line.is_empty() {
            return Ok(None);
        }
        let line = line.trim_ascii();
        if line.is_empty() {
            if is_empty {
                continue;
            }
            break;
        }
        is_empty = false;
        let Some(colon) = line.iter().position(|byte| *byte == b':') else { continue };
        let (name, value) = (line[..colon].trim_ascii(), line[colon + 1..].trim_ascii());
        if name.eq_ignore_ascii_case(b"content-length") {
            length = std::str::from_utf8(value).ok().and_then(|digits| digits.parse::<u64>().ok());
        }
    }
    let Some(length) = length else {
        let why = "a header has no `Content-Length: N`, where N is the number of bytes behind it; what it announces is left out";
        return Ok(Some(Incoming::Malformed(why.to_owned())));
    };
    if length > LONGEST_MESSAGE {
        io::copy(&mut stream.by_ref().take(length), &mut io::sink())?;
        let why = format!("a message has {length} bytes; at most {LONGEST_MESSAGE} are read");
        return Ok(Some(Incoming::Malformed(why)));
    }
    let mut body = Vec::new();
    stream.by_ref().take(length).read_to_end(&mut body)?;
    if (body.len() as u64) < length {
        return Ok(None);
    }
    Ok(Some(match serde_json::from_slice(&body) {
        Ok(message) => Incoming::Message(message),
        Err(why) => Incoming::Malformed(format!("a message is no JSON: {why}")),
    }))
}

/// Writes a message with its header.
pub(super) fn write_message(stream: &mut dyn Write, message: &Value) -> io::Result<()> {
    let body = message.to_string();
    write!(stream, "Content-Length: {}\r\n\r\n{body}", body.len())?;
    stream.flush()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn all(mut bytes: &[u8]) -> Vec<Incoming> {
        std::iter::from_fn(|| read_message(&mut bytes).expect("bytes in memory")).collect()
    }

    #[test]
    fn what_is_written_is_read() {
        let (one, other) = (json!({ "text": "Δ = 𝟙\r\n" }), json!([1, 2]));
        let mut bytes = Vec::new();
        write_message(&mut bytes, &one).expect("written");
        write_message(&mut bytes, &other).expect("written");
        assert_eq!(all(&bytes), [Incoming::Message(one), Incoming::Message(other)]);
    }

    #[test]
    fn headers_may_have_other_fields_and_letters() {
        let bytes = b"Content-Type: application/vscode-jsonrpc; charset=utf-8\r\ncontent-length:4\n\ntrue";
        assert_eq!(all(bytes), [Incoming::Message(json!(true))]);
    }

    #[test]
    fn behind_what_is_malformed_the_next_message_is_read() {
        let good = "Content-Length: 4\r\n\r\ntrue";
        for (bad, why) in [
            ("Content-Length: 3\r\n\r\n{a}", "no JSON"),
            ("Content-Length: 2\r\n\r\n\u{fc}", "no JSON"),
            ("Content-Length: -1\r\n\r\n", "no `Content-Length: N`"),
            ("Content-Length: 99999999999999999999999\r\n\r\n", "no `Content-Length: N`"),
            ("hello: you\r\n\r\n", "no `Content-Length: N`"),
            ("Content-Length: 0\r\n\r\n", "no JSON"),
        ] {
            // Half a character of two bytes.
            let mut bytes = bad.as_bytes().to_vec();
            if bad.ends_with('\u{fc}') {
                bytes.pop();
                bytes.push(b'x');
            }
            bytes.extend_from_slice(good.as_bytes());
            let found = all(&bytes);
            assert!(matches!(&found[0], Incoming::Malformed(told) if told.contains(why)), "{bad:?}: {found:?}");
            assert_eq!(found[1..], [Incoming::Message(json!(true))], "{bad:?}");
        }
    }

    #[test]
    fn a_message_that_is_cut_off_is_none() {
        assert_eq!(all(b"Content-Length: 5\r\n\r\ntrue"), []);
        assert_eq!(all(b"Content-Length: 18446744073709551615\r\n\r\ntrue").len(), 1);
        assert_eq!(all(&b"x".repeat(100_000)), []);
    }
}
