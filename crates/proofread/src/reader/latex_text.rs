//! The running text of a document in LaTeX: its lines as they are printed, and where in the document each part of them is.

use super::definitions::{Macros, NamedMacros};
use super::latex::{LatexPart, group_text, parts};
use super::running::RunningText;
use super::shown;
use super::unread::UnreadKind;
use crate::token::Span;
use std::ops::Range;

/// Commands that change the looks of text and print nothing by themselves.
const LOOKS: &str = " textbf textit textsl textsc textrm textsf texttt textmd textup textnormal text emph underline uline bf it rm \
    sf tt sl sc em bfseries itshape rmfamily sffamily ttfamily upshape mdseries normalfont tiny scriptsize footnotesize small \
    normalsize large Large LARGE huge Huge centering raggedright raggedleft noindent indent mbox hbox boxed fbox phantom null \
    relax protect textcolor color ";
/// Commands behind which a line begins.
const BREAKS: &str = " item par newline linebreak newpage clearpage pagebreak section subsection subsubsection paragraph \
    subparagraph chapter part caption title footnote hline toprule midrule bottomrule begin end question choice ";
/// Environments whose words are no text.
const NO_TEXT: &str = " axis circuitikz pspicture picture forest algorithmic algorithm algorithm2e sagesilent sageblock pycode \
    pyblock pyconsole asy asydef luacode Schunk Sinput Soutput filecontents alltt lstcode dot2tex ";
/// Longest line that takes in the next one of its paragraph, in bytes.
const LONGEST_LINE: usize = 3000;
/// Longest argument in square brackets, in bytes.
const LONGEST_OPTION: usize = 300;

/// The lines of a document.
pub(super) fn running_text(text: &str, elsewhere: Option<&NamedMacros>) -> RunningText {
    const BEGIN: &str = "\\begin{document}";
    let mut out = LatexText { text, lines: RunningText::default(), line_start: 0 };
    let mut at = text.find(BEGIN).map_or(0, |at| at + BEGIN.len());
    let macros = Macros::from_text(text, text.len(), elsewhere);
    parts(text, &macros, &mut |part| {
        let (range, is_printed) = match part {
            LatexPart::Formula { whole, .. } => (whole, true),
            LatexPart::Hidden(range, kind) => {
                let code = |(kind, _)| matches!(kind, UnreadKind::Code | UnreadKind::Environment);
                (range, kind.is_some_and(code))
            }
        };
        if range.start >= at {
            at = out.prose(at..range.start).max(range.end);
            if is_printed {
                out.lines.edge(Span::new(range.start, range.end));
            }
        }
    });
    out.prose(at..text.len());
    out.lines
}

struct LatexText<'t> {
    text: &'t str,
    lines: RunningText,
    /// Where the last line begins.
    line_start: usize,
}

impl LatexText<'_> {
    fn end_line(&mut self, place: Span) {
        self.lines.push('\n', place);
        self.line_start = self.lines.text.len();
    }

    /// Takes the end of a line of the source, which is space unless a blank line follows.
    fn end_source_line(&mut self, at: usize) {
        let place = Span::new(at, at + 1);
        let behind = self.text[at + 1..].trim_start_matches([' ', '\t', '\r']);
        let is_long = self.lines.text.len() > self.line_start + LONGEST_LINE;
        match behind.starts_with('\n') {
            true => (0..2).for_each(|_| self.end_line(place)),
            false if is_long => self.end_line(place),
            false if self.lines.text.ends_with(['\n', ' ']) => {}
            false => self.lines.push(' ', place),
        }
    }

    /// Adds what is between two formulas; the byte up to which the text is done, which may be behind it.
    fn prose(&mut self, range: Range<usize>) -> usize {
        let mut at = range.start;
        while let Some(c) = self.text.get(at..range.end).and_then(|rest| rest.chars().next()) {
            let place = Span::new(at, at + c.len_utf8());
            let dash = || self.text[at..].bytes().take(3).take_while(|c| *c == b'-').count();
            match c {
                '\\' => {
                    at = self.command(at).max(at + 1);
                    continue;
                }
                '{' | '}' => {}
                '~' => self.lines.push(' ', place),
                '&' => self.end_line(place),
                '\n' => self.end_source_line(at),
                '$' | '^' | '_' => self.lines.edge(place),
                '-' if dash() > 1 => {
                    let end = at + dash();
                    self.lines.push(if end - at == 2 { '–' } else { '—' }, Span::new(at, end));
                    at = end;
                    continue;
                }
                c => self.lines.push(c, place),
            }
            at += c.len_utf8();
        }
        at
    }

    /// Takes a command with those of its arguments that no reader sees; the byte behind it.
    fn command(&mut self, at: usize) -> usize {
        let rest = &self.text[at + 1..];
        let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        let name = &rest[..length];
        let is_one_of = |of: &str| of.split_ascii_whitespace().any(|known| known == name);
        if length == 0 {
            let c = rest.chars().next().unwrap_or(' ');
            let end = at + 1 + rest.chars().next().map_or(0, char::len_utf8);
            let place = Span::new(at, end);
            match c {
                '%' | '$' | '&' | '#' | '{' | '}' => self.lines.push(c, place),
                ',' | ';' | ':' | ' ' | '!' | '/' => self.lines.push(' ', place),
                '\\' => self.end_line(place),
                _ => self.lines.edge(place),
            }
            return end;
        }
        if name == "begin"
            && let Some(environment) = group_text(self.text, at + 1 + length)
            && NO_TEXT.split_ascii_whitespace().any(|known| known == environment.trim_end_matches('*'))
        {
            let close = format!("\\end{{{environment}}}");
            let end = rest.find(&close).map_or(self.text.len(), |found| at + 1 + found + close.len());
            self.lines.edge(Span::new(at, end));
            return end;
        }
        let (mut end, left_out) = shown::command(self.text, at);
        if left_out.is_none() {
            let bytes = &self.text.as_bytes()[end..];
            end += usize::from(bytes.first() == Some(&b'*'));
            let bytes = &self.text.as_bytes()[end..];
            let option = bytes.iter().take(LONGEST_OPTION).position(|c| *c == b']');
            end += option.filter(|_| bytes.first() == Some(&b'[')).map_or(0, |close| close + 1);
        }
        let place = Span::new(at, end);
        if is_one_of(BREAKS) {
            self.end_line(place);
        } else if is_one_of(LOOKS) {
            self.lines.push(' ', place);
        } else {
            self.lines.edge(place);
        }
        end
    }
}
