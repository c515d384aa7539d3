//! What a page asks a module.

use crate::arguments::LiveArguments;

/// Bytes of a question that are read at most.
const MOST_BYTES: usize = 1 << 16;

/// A question to a figure: `name?arguments`, or `name.part?arguments` for a part of its answer or for one of its files.
///
/// ```
/// let question = geneva_live::LiveQuestion::parse("design.wheel.dxf?stations=6")?;
/// assert_eq!((question.name, question.part), ("design", Some("wheel.dxf")));
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LiveQuestion<'q> {
    /// The figure by its name.
    pub name: &'q str,
    /// What is asked for, if not the whole answer.
    pub part: Option<&'q str>,
    /// What the figure is set to.
    pub arguments: LiveArguments,
}

impl<'q> LiveQuestion<'q> {
    /// Reads a question of 65,536 bytes at most.
    ///
    /// # Errors
    ///
    /// A longer question, and what [`LiveArguments::parse`] refuses.
    pub fn parse(question: &'q str) -> Result<Self, String> {
        if question.len() > MOST_BYTES {
            return Err(format!("the question has {} bytes: give {MOST_BYTES} at most", question.len()));
        }
        let (name, arguments) = question.split_once('?').unwrap_or((question, ""));
        let arguments = LiveArguments::parse(arguments)?;
        let (name, part) = name.split_once('.').map_or((name, None), |(name, part)| (name, Some(part)));
        Ok(Self { name, part, arguments })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_has_so_many_bytes_at_most() {
        let longer = "x".repeat(MOST_BYTES + 1);
        assert_eq!(LiveQuestion::parse(&longer[1..]).map(|of| of.part), Ok(None));
        assert!(LiveQuestion::parse(&longer).is_err_and(|why| why.contains("65537 bytes: give 65536")));
    }
}
