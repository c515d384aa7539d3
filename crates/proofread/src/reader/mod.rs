//! Readers: a text in one of the formats to formulas, each a list of tokens with their places.

mod adjoining;
mod commas;
mod comments;
mod continued;
mod definitions;
mod delimited;
mod digits;
mod expansion;
mod fences;
mod formatting;
mod formatting_arguments;
mod json;
mod latex;
mod latex_text;
mod markdown;
mod markup;
mod mathml;
mod matrix;
mod notebook;
#[cfg(feature = "cli")]
mod office;
mod plain;
mod pretext;
mod recognised;
mod running;
mod shortcodes;
mod shown;
mod shown_lines;
mod siunitx;
mod symbols;
mod tags;
mod tex;
#[cfg(feature = "cli")]
mod typst;
mod unread;
mod upright;
mod words;

use crate::order::sort_by_place;
use crate::token::{Span, Token};

/// What a text is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TextFormat {
    /// Markdown with TeX between dollar signs, `\(` or `\[`, and lines with an equals sign.
    Markdown,
    /// A document in LaTeX, or a part of one.
    Latex,
    /// XML with MathML, such as CNXML or a DocBook, or with TeX as in PreTeXt, and its running text.
    Xml,
    /// HTML: its running text, with exponents and indices as they are raised and lowered, MathML, and TeX for MathJax or KaTeX.
    Html,
    /// A Jupyter notebook.
    Notebook,
    /// Plain lines; TeX between marks is read, too.
    Plain,
    /// A table with commas, semicolons or tabs between its values; it has no formulas.
    Csv,
}

impl TextFormat {
    /// Every format with its name.
    pub const ALL: [(&'static str, Self); 7] = [
        ("markdown", Self::Markdown),
        ("latex", Self::Latex),
        ("xml", Self::Xml),
        ("html", Self::Html),
        ("notebook", Self::Notebook),
        ("plain", Self::Plain),
        ("csv", Self::Csv),
    ];

    /// The format of this name.
    ///
    /// ```
    /// use proofread::TextFormat;
    ///
    /// assert_eq!(TextFormat::from_name("notebook"), Some(TextFormat::Notebook));
    /// assert!(TextFormat::ALL.iter().all(|(name, format)| format.name() == *name));
    /// ```
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, format)| *format)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, format)| *format == self).map_or("", |(name, _)| name)
    }

    /// The format of files whose names end so, without the dot, in any case.
    ///
    /// ```
    /// use proofread::TextFormat;
    ///
    /// assert_eq!(TextFormat::from_extension("TeX"), Some(TextFormat::Latex));
    /// assert_eq!(TextFormat::from_extension("pdf"), None);
    /// ```
    pub fn from_extension(extension: &str) -> Option<Self> {
        Some(match extension.to_ascii_lowercase().as_str() {
            "md" | "markdown" | "mdown" | "mdx" | "mkd" | "qmd" | "rmd" => Self::Markdown,
            "tex" | "latex" | "ltx" => Self::Latex,
            "xml" | "cnxml" | "ptx" | "mbx" | "mml" | "docbook" | "dbk" => Self::Xml,
            "html" | "htm" | "xhtml" => Self::Html,
            "ipynb" => Self::Notebook,
            "txt" | "text" => Self::Plain,
            "csv" | "tsv" => Self::Csv,
            _ => return None,
        })
    }
}

/// Why a text could not be read.
///
/// ```
/// use proofread::{CheckOptions, TextFormat, UnreadableText, proofread};
///
/// let why = proofread("no notebook", TextFormat::Notebook, CheckOptions::default()).expect_err("no notebook");
/// assert!(matches!(why, UnreadableText::Notebook(_)));
/// assert_eq!(why.to_string(), "this is not a Jupyter notebook: an object is expected at line 1, column 1");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum UnreadableText {
    /// It is no notebook, with the reason.
    Notebook(String),
    /// It is longer than a document may be.
    TooLong,
    /// Its file has several of its lines in one, and was to be read by the lines of the file.
    LinesInOne,
}

impl std::fmt::Display for UnreadableText {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Notebook(why) => write!(f, "this is not a Jupyter notebook: {why}"),
            Self::TooLong => write!(f, "the text has more than {} MiB; split it", LONGEST >> 20),
            Self::LinesInOne => f.write_str(
                "lines of the notebook's text share a line of its file; give what `jupyter nbconvert --to markdown` makes of it",
            ),
        }
    }
}

impl std::error::Error for UnreadableText {}

/// Longest document, in bytes.
pub const LONGEST: usize = 64 << 20;

/// How a formula is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FormulaStyle {
    /// As a formula.
    #[default]
    Formula,
    /// In running text.
    Plain,
}

/// A formula of a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// Its tokens.
    pub tokens: Vec<Token>,
    /// Where it is in the text.
    pub span: Span,
    /// Which example, exercise or section it belongs to; 0 for none.
    pub scope: u32,
    /// Whether it continues what stands before it, so that its first side is not all of one.
    pub continues: bool,
    /// Whether the text behind it continues it.
    pub goes_on: bool,
    /// How it is written.
    pub style: FormulaStyle,
}

impl Formula {
    fn new(tokens: Vec<Token>, span: Span) -> Self {
        Self { tokens, span, scope: 0, continues: false, goes_on: false, style: FormulaStyle::Formula }
    }

    fn map_spans(&mut self, to: &dyn Fn(Span) -> Span) {
        self.span = to(self.span);
        self.tokens.iter_mut().for_each(|token| token.map_spans(to));
    }
}

/// Takes the formulas as they are found.
pub(crate) type FormulaSink<'f> = dyn FnMut(Formula) + 'f;

/// Reads a text and hands over its formulas, in their order; those in the running text of a page follow the others.
///
/// # Errors
///
/// If the text is too long, or is no notebook where it should be one.
///
/// ```
/// use proofread::{TextFormat, reader};
///
/// let text = "It is $2 + 2 = 5$ and $x$.";
/// let mut formulas = Vec::new();
/// reader::read(text, TextFormat::Markdown, &mut |formula| formulas.push(&text[formula.span.range()]))?;
/// assert_eq!(formulas, ["$2 + 2 = 5$", "$x$"]);
/// # Ok::<(), proofread::UnreadableText>(())
/// ```
pub fn read(text: &str, format: TextFormat, each: &mut dyn FnMut(Formula)) -> Result<(), UnreadableText> {
    let lines = running_text(text, format, None);
    read_with(text, format, None, &lines, &mut |mut formula, from| {
        if from == SpanSource::Lines {
            formula.map_spans(&|span| lines.span_in_page(span));
        }
        each(formula);
    })
    .map(drop)
}

/// What a place of a formula is counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SpanSource {
    /// The text that was given.
    Text,
    /// The lines of running text in it.
    Lines,
}

/// Reads a text with definitions from elsewhere, and the lines of running text in it, whose formulas follow the others; what is
/// not read.
pub(crate) fn read_with(
    text: &str,
    format: TextFormat,
    elsewhere: Option<&Definitions>,
    lines: &RunningText,
    each: &mut dyn FnMut(Formula, SpanSource),
) -> Result<UnreadParts, UnreadableText> {
    if text.len() > LONGEST {
        return Err(UnreadableText::TooLong);
    }
    let meaning = commas::comma_meaning(text, format, elsewhere, lines);
    let mut understood = |mut formula: Formula, from| {
        let source = if from == SpanSource::Lines { &lines.text } else { text };
        match meaning {
            commas::CommaMeaning::Decimal(points) => commas::apply_decimal_sign(&mut formula.tokens, source, points),
            commas::CommaMeaning::Undecided => commas::mark_undecided(&mut formula.tokens, source),
            commas::CommaMeaning::Separator => {}
        }
        each(formula, from);
    };
    let mut continued = continued::ContinuedFormulas::new(text);
    let mut understood_in_text = |formula| understood(formula, SpanSource::Text);
    let unread = formulas(text, format, elsewhere, &mut |formula| continued.take(formula, &mut understood_in_text))?;
    continued.finish(&mut understood_in_text);
    lines.read(&mut |formula| understood(formula, SpanSource::Lines));
    Ok(unread)
}

/// Most bytes that are struck out at once.
const FARTHEST_STRUCK: usize = 1000;

/// What an author has struck out or commented out of a text in Markdown, and the addresses in it.
fn withdrawn_ranges(text: &str) -> Vec<std::ops::Range<usize>> {
    const MARKS: [(&str, &str); 5] =
        [("~~", "~~"), ("<del>", "</del>"), ("<s>", "</s>"), ("<strike>", "</strike>"), ("<!--", "-->")];
    let mut out = Vec::new();
    for (open, close) in MARKS {
        let mut from = 0;
        while let Some(at) = text[from..].find(open).map(|at| from + at) {
            let inside = at + open.len();
            // Nobody strikes out more than a paragraph.
            let limit = if open == "<!--" { text.len() } else { (inside + FARTHEST_STRUCK).min(text.len()) };
            let limit = (inside..=limit).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(inside);
            let end = text[inside..limit].find(close).map(|end| inside + end);
            from = end.map_or(inside, |end| end + close.len());
            // In a formula these are spaces.
            let opens =
                open != close || text[..at].ends_with(|c: char| c.is_whitespace() || "([*".contains(c)) || at == 0;
            let spaces = |end: usize| {
                open == close
                    && (!opens || text[inside..end].contains("$$") || text[inside..end].matches('$').count() % 2 == 1)
            };
            match end {
                Some(end) if spaces(end) => from = inside,
                Some(end) if open == "<!--" || !text[inside..end].contains("\n\n") => out.push(at..from),
                None if open == "<!--" => break,
                _ => {}
            }
        }
    }
    for (at, _) in text.match_indices("://") {
        let length = text[at..].find(|c: char| c.is_whitespace() || ")>\"".contains(c)).unwrap_or(text.len() - at);
        out.push(at..at + length);
    }
    sort_by_place(&mut out, |range| range.start);
    out
}

pub use definitions::Definitions;
#[cfg(feature = "cli")]
pub(crate) use markdown::unread_fences;
#[cfg(feature = "cli")]
pub(crate) use office::{ArchiveFormat, ArchivedText, MadePage, read_archive};
pub(crate) use plain::is_noun;
#[cfg(feature = "cli")]
pub(crate) use pretext::macros_text;
pub(crate) use running::RunningText;
pub(crate) use shortcodes::without_shortcodes;
pub use shown::{LeftOut, ROW_END, ShownText, shown_text};
pub use shown_lines::shown_lines;
pub(crate) use symbols::unit_sign;
#[cfg(feature = "statistics")]
pub(crate) use tags::next_tag;
#[cfg(feature = "cli")]
pub(crate) use typst::read as read_typst;
pub use unread::{UnreadKind, UnreadParts};

/// The lines of a text whose mark-up has to be taken away first, with the definitions of other texts; none in other formats.
pub(crate) fn running_text(text: &str, format: TextFormat, elsewhere: Option<&Definitions>) -> RunningText {
    match format {
        _ if text.len() > LONGEST => RunningText::default(),
        TextFormat::Html => RunningText::from_page(text),
        TextFormat::Xml if text.contains('=') => RunningText::from_xml(text),
        TextFormat::Latex if text.contains('=') => latex_text::running_text(text, elsewhere.map(|of| &of.0)),
        _ => RunningText::default(),
    }
}

/// The tokens of running text that starts `base` bytes into the document.
pub(crate) fn tokenise_text(text: &str, base: usize) -> Vec<Token> {
    let mut out = Vec::new();
    words::tokenise_words(&crate::token::signs(text, base), &mut out);
    out
}

/// The formulas with their numbers as in English, but none in running text of a page; what is not read.
fn formulas(
    text: &str,
    format: TextFormat,
    elsewhere: Option<&Definitions>,
    each: &mut dyn FnMut(Formula),
) -> Result<UnreadParts, UnreadableText> {
    Ok(match format {
        TextFormat::Markdown => markdown::read(text, delimited::Dollars::Single, elsewhere.map(|of| &of.0), each),
        TextFormat::Latex => latex::read(text, elsewhere.map(|of| &of.0), each),
        TextFormat::Xml | TextFormat::Html => markup::read(text, elsewhere.map(|of| &of.0), each),
        TextFormat::Notebook => notebook::read(text, elsewhere.map(|of| &of.0), each)?,
        TextFormat::Csv => UnreadParts::default(),
        TextFormat::Plain => {
            let marked = delimited::formulas(text, &[], delimited::Dollars::Single);
            let mut found = Vec::new();
            let mut taken = Vec::new();
            for of in marked {
                let signs = crate::token::signs(&text[of.inside.clone()], of.inside.start);
                let tokens = tex::formula(&signs, &definitions::Macros::default());
                found.push(Formula::new(tokens, Span::new(of.whole.start, of.whole.end)));
                taken.push(of.whole);
            }
            plain::read(text, &taken, &mut |formula| found.push(formula));
            sort_by_place(&mut found, |formula| formula.span);
            found.into_iter().for_each(each);
            UnreadParts::default()
        }
    })
}
