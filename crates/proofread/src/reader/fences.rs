//! Fences of Markdown, line by line: code, and the directives of MyST whose content is text.

use std::ops::Range;

/// Chunks of code and directives whose content is no text, by the name in braces; other names in braces are directives.
const CODE: &str = " code code-block code-cell sourcecode literalinclude include raw mermaid graphviz digraph eval-rst toctree \
    bibliography parsed-literal doctest testcode testsetup testoutput plot autoclass autofunction automodule image figure-md \
    video iframe embed r R python python3 py julia sql bash sh zsh shell ojs observable stan js javascript node css scss sass \
    cpp c Rcpp rcpp fortran fortran95 awk perl ruby octave matlab haskell scala groovy go rust sas stata d3 dot tikz asy cat \
    coffee comment gawk lein mysql psql rscript sed targets verbatim yaml json toml html xml latex tex eqn powershell csharp \
    fsharp java kotlin swift typescript ts webr pyodide pyodide-python webr-r glue jupyter-execute thebe-button marimo ";

/// Chunks of R Markdown and bookdown whose content is text.
const TEXT: &str = "asis block block2 theorem lemma corollary proposition conjecture definition example exercise hypothesis remark \
    solution proof ";

/// How a fence is to be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FenceKind {
    /// As text: only its first and its last line are no text.
    Text,
    /// Not at all, or as whoever reads code thinks.
    Code,
}

/// What a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FenceLine {
    /// Text.
    No,
    /// The first or the last line of a directive whose content is text.
    Directive,
    /// The first line of code that no other program would take for one, since there are backticks in its options.
    QuotedOptions,
    /// A line of code, its first and last one among them.
    Code,
}

/// Most fences inside each other.
const DEEPEST: usize = 100;

/// The fences that are open at a line.
#[derive(Default)]
pub(super) struct Fences {
    open: Vec<(char, usize, FenceKind)>,
}

impl Fences {
    /// Whether no fence is open.
    pub(super) fn are_closed(&self) -> bool {
        self.open.is_empty()
    }

    /// Whether the innermost open fence is one of code.
    fn are_in_code(&self) -> bool {
        self.open.last().is_some_and(|(_, _, kind)| *kind == FenceKind::Code)
    }

    /// Takes the next line.
    pub(super) fn take(&mut self, line: &str) -> FenceLine {
        let inner = line.trim_start_matches([' ', '\t', '>']);
        let mark = inner.chars().next().filter(|c| "`~".contains(*c)).unwrap_or(' ');
        let length = if mark == ' ' { 0 } else { inner.chars().take_while(|c| *c == mark).count() };
        let info = inner[length..].trim();
        let in_code = self.are_in_code();
        if length >= 3 && info.is_empty() {
            // A directive whose end was forgotten ends with the one around it.
            let closed = self.open.iter().rposition(|(open, least, _)| *open == mark && *least <= length);
            let closed = closed.filter(|at| !in_code || at + 1 == self.open.len());
            if let Some(at) = closed {
                self.open.truncate(at);
                return if in_code { FenceLine::Code } else { FenceLine::Directive };
            }
        }
        if in_code {
            return FenceLine::Code;
        }
        if length < 3 || self.open.len() >= DEEPEST {
            return FenceLine::No;
        }
        let quoted = mark == '`' && info.contains('`');
        let kind = match directive(info) {
            Some(true) if !quoted => FenceKind::Text,
            // The options of a chunk of code end its line.
            _ if !quoted || (info.starts_with('{') && info.ends_with('}')) => FenceKind::Code,
            _ => return FenceLine::No,
        };
        self.open.push((mark, length, kind));
        match kind {
            FenceKind::Text => FenceLine::Directive,
            FenceKind::Code if quoted => FenceLine::QuotedOptions,
            FenceKind::Code => FenceLine::Code,
        }
    }
}

/// Whether the words behind the mark of a fence name a directive with text in it; none if they name no directive or chunk.
fn directive(info: &str) -> Option<bool> {
    let (inside, _) = info.strip_prefix('{')?.split_once('}')?;
    let name = inside.trim();
    // Chunks of R Markdown whose content is text, whatever their options are.
    if TEXT.split_whitespace().any(|known| known == name.split([',', ' ']).next().unwrap_or_default()) {
        return Some(true);
    }
    let plain = !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || "-_:.+".contains(c));
    let is_code = CODE.split_ascii_whitespace().any(|known| known == name);
    // A formula is read as one.
    Some(plain && !is_code && !name.starts_with('.') && name != "math")
}

/// What a fence is called: the first word behind its mark, without braces and options.
pub(super) fn name_of_fence(info: &str) -> &str {
    info.trim_start_matches(['{', '.', ' ']).split([' ', ',', '}', '\t']).next().unwrap_or_default()
}

/// Markdown as programs read it that know nothing of its extensions.
pub(super) struct PlainFences {
    /// The text with other signs, as many as there are bytes, for what would keep such a program from reading it: the marks of
    /// directives and admonitions, options with backticks, and the chunks below.
    pub text: String,
    /// Where the marks of directives are.
    pub marks: Vec<Range<usize>>,
    /// Chunks of R Markdown where Markdown has no fences, or ends them elsewhere: in a block of HTML, or indented as code is. Whoever
    /// runs chunks looks for their lines alone.
    pub chunks: Vec<Range<usize>>,
}

/// The text without what extensions of Markdown add; none if there is nothing of the kind.
pub(super) fn with_plain_fences(text: &str) -> Option<PlainFences> {
    let has_admonition = || text.lines().any(|line| is_admonition(line.trim_start_matches(' ')));
    if !text.contains("```") && !text.contains("~~~") && !has_admonition() {
        return None;
    }
    let (mut out, mut marks, mut chunks) = (String::with_capacity(text.len()), Vec::new(), Vec::new());
    let mut fences = Fences::default();
    let (mut in_html, mut chunk) = (false, None);
    // How far what is in an admonition is indented at most; none outside of them.
    let mut inside = 0;
    // How far what is in the open items of lists is indented.
    let mut items: Vec<usize> = Vec::new();
    for line in text.split_inclusive('\n') {
        let start = out.len();
        let content = line.trim_end();
        let indent = content.len() - content.trim_start_matches(' ').len();
        if !content.is_empty() {
            inside = inside.min(indent / 4 * 4);
        }
        let mark = content.find(['`', '~']).unwrap_or(content.len());
        let was_in_code = fences.are_in_code();
        let taken = fences.take(line);
        if taken == FenceLine::No && !content.is_empty() {
            while items.pop_if(|item| indent < *item).is_some() {}
            let base = items.last().copied().unwrap_or(0);
            items
                .extend(marker_of_item(&content[indent..]).filter(|_| indent < base + 4).map(|length| indent + length));
        }
        in_html = !content.is_empty() && (in_html || begins_html(content));
        if !was_in_code && fences.are_in_code() && (in_html || indent >= 4) && is_chunk(&content[mark..]) {
            chunk = Some(start);
        }
        if let Some(from) = chunk {
            out.extend(std::iter::repeat_n(' ', content.len()));
            out.push_str(&line[content.len()..]);
            if !fences.are_in_code() {
                chunks.push(from..out.len());
                (chunk, in_html) = (None, false);
            }
            continue;
        }
        let (kept, hidden) = match taken {
            // What a directive is about is text, too, and must not become code by the space before it.
            FenceLine::Directive => {
                let close = content.find('}').map_or(content.len(), |close| close + 1);
                marks.push(start + mark..start + close);
                (0, if content[close..].trim().is_empty() { ' ' } else { '.' })
            }
            FenceLine::QuotedOptions => (mark + content[mark..].bytes().take_while(|c| *c == b'`').count(), ' '),
            FenceLine::No
                if (indent == inside || items.last().is_some_and(|item| indent < item + 4))
                    && is_admonition(&content[indent..]) =>
            {
                // The text of an admonition is indented as that of an item in a list.
                inside = indent + 4;
                if !items.is_empty() {
                    items.push(indent + 4);
                }
                out.push_str(&line[..indent]);
                out.push_str("*   ");
                // More space would indent that text further.
                let (shut, rest) =
                    line[indent + 4..].strip_prefix(' ').map_or(("", &line[indent + 4..]), |rest| (".", rest));
                out.push_str(shut);
                out.push_str(rest);
                continue;
            }
            FenceLine::No | FenceLine::Code => (content.len(), ' '),
        };
        let behind = if hidden == '.' { content.find('}').map_or(kept, |close| close + 1) } else { content.len() };
        out.push_str(&content[..kept]);
        out.extend(std::iter::repeat_n(hidden, behind - kept));
        out.push_str(&content[behind..]);
        out.push_str(&line[content.len()..]);
    }
    chunks.extend(chunk.map(|from| from..out.len()));
    Some(PlainFences { text: out, marks, chunks })
}

/// How long the mark of an item in a list is at the start of a line, with the space behind it.
fn marker_of_item(line: &str) -> Option<usize> {
    const LONGEST: usize = 9;
    let digits = line.bytes().take_while(u8::is_ascii_digit).count();
    let mark = if digits == 0 { "-*+" } else { ".)" };
    let rest = line.get(digits..)?.strip_prefix(|c: char| mark.contains(c)).filter(|_| digits <= LONGEST)?;
    let spaces = rest.len() - rest.trim_start_matches(' ').len();
    let length = digits + 1 + if spaces > 4 { 1 } else { spaces };
    (spaces > 0).then_some(length)
}

/// Whether a line begins a block of HTML, which lasts to the next blank one.
fn begins_html(line: &str) -> bool {
    line.trim_start()
        .strip_prefix('<')
        .is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_alphabetic() || c == '/'))
}

/// Whether a fence begins a chunk of code that is run: its language stands first in braces.
fn is_chunk(fence: &str) -> bool {
    let info = fence.trim_start_matches(['`', '~']).trim_start();
    info.strip_prefix('{').is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_alphabetic()))
}

/// Whether a line begins an admonition of Python-Markdown or a tab of its extensions: `!!! note`, `??? example`, `???+ tip`, `=== "Tab"`.
fn is_admonition(line: &str) -> bool {
    (["!!! ", "??? ", "???+ "].iter().any(|mark| line.starts_with(mark)) && line.len() > 4)
        || line.starts_with("=== \"")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Vec<FenceLine> {
        let mut fences = Fences::default();
        text.lines().map(|line| fences.take(line)).collect()
    }

    #[test]
    fn directives_nest_and_code_does_not() {
        use FenceLine::{Code, Directive, No, QuotedOptions};
        assert_eq!(
            lines("````{note}\na\n```{tip} b\nc\n```\n````\nd"),
            [Directive, No, Directive, No, Directive, Directive, No]
        );
        assert_eq!(lines("````md\n```{note}\n```\n````\na"), [Code, Code, Code, Code, No]);
        assert_eq!(lines("```{r, fig.cap=\"`x`\"}\n1\n```\na"), [QuotedOptions, Code, Code, No]);
        assert_eq!(lines("```{math}\n:label: a\n```\n```{python}\n```"), [Code; 5]);
        assert_eq!(lines("``` `a` ```\nb"), [No, No]);
    }

    #[test]
    fn what_is_changed_is_as_long_as_it_was() {
        let text = "```{note} Über\nä $1 + 1 = 3$\n```\n";
        let plain = with_plain_fences(text).expect("a fence");
        assert_eq!((plain.text.len(), plain.marks.len()), (text.len(), 2));
        assert_eq!(plain.text.trim_end(), format!("{} Über\nä $1 + 1 = 3$", ".".repeat(9)));
        assert_eq!(name_of_fence("{r, echo=FALSE}"), "r");
    }

    #[test]
    fn chunks_are_hidden_where_markdown_has_no_fence_of_theirs() {
        for (text, chunk) in [
            ("<p>\n```{r}\n\nx\n```\n</p>\n\na\n", Some(4..18)),
            ("1. a\n\n    ```{r}\nx\n```\nb\n", Some(6..23)),
            ("<p>\n\n```{r}\nx\n```\nb\n", None),
            ("    ```\nx\n", None),
            ("<p>\n```{r}\nx", Some(4..12)),
        ] {
            let plain = with_plain_fences(text).expect(text);
            assert_eq!((plain.text.len(), plain.chunks.first()), (text.len(), chunk.as_ref()), "{text}");
            assert!(chunk.is_none_or(|chunk| plain.text[chunk].trim().is_empty()), "{text}");
        }
    }
}
