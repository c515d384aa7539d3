//! Findings on a page for people: one file without a script, which loads nothing.

use super::documents::Document;
use super::output::{capitalised, printable};
use super::text::{findings_sentence, summary_sentences};
use super::{CheckedDocument, ReportWriter, RunTotals};
use crate::judge::section::ReportSection;
use crate::tell::finding_group::FindingGroup;
use crate::tell::line_index::LineIndex;
use crate::tell::summary::describe_count;
use crate::tell::unchecked_chain::UncheckedChain;
use crate::token::Span;
use geneva_host::printable::escaped;
use std::fmt::Write;
use std::ops::Range;

const STYLE: &str = include_str!("html.css");

/// Lines of the text that are shown before the marked place, and as many behind it.
const AROUND: usize = 2;

/// Longest part of a marked line that is shown, in characters.
const LONGEST: usize = 240;

/// Longest part of a line around it that is shown, in characters.
const LONGEST_AROUND: usize = 120;

/// Most lines of a marked place that are shown: one may be as long as a table.
const MOST_LINES: usize = 12;

/// Hides the findings that are less certain, by the style alone.
const LESS_CERTAIN_SWITCH: &str =
    "<p><label><input type=\"checkbox\" id=\"certain-only\"> Hide what is less certain</label></p>\n";

/// A page, of which the parts are kept until the sum is known.
#[derive(Default)]
pub(crate) struct HtmlWriter {
    documents: Vec<DocumentPart>,
}

/// What the page says of a document.
struct DocumentPart {
    name: String,
    count: String,
    body: String,
}

/// Text of which nothing is taken for mark-up, and nothing changes the direction or the place of what follows.
fn plain(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in printable(text).chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            '\'' => out += "&#39;",
            c => out.push(c),
        }
    }
    out
}

/// The exponent at the start of what is behind `^`, and how many bytes it and its brackets take; none if nothing there is one.
fn exponent(behind: &str) -> Option<(&str, usize)> {
    if let Some(inside) = behind.strip_prefix('(') {
        let mut open = 1usize;
        let close = inside.char_indices().find(|(_, c)| {
            open = open + usize::from(*c == '(') - usize::from(*c == ')');
            open == 0
        })?;
        return Some((&inside[..close.0], close.0 + 2));
    }
    let sign = behind.chars().next().filter(|c| "+-−".contains(*c)).map_or(0, char::len_utf8);
    let rest = &behind[sign..];
    let digits = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
    // A full stop behind a number ends the sentence.
    let digits = rest[..digits].trim_end_matches('.').len();
    let letter = rest.chars().next().filter(|c| c.is_alphabetic()).map_or(0, char::len_utf8);
    let length = sign + digits.max(letter);
    (length > sign).then(|| (&behind[..length], length))
}

/// [`plain`] text of a formula on one line, with its exponents raised.
fn raised(text: &str) -> String {
    let (mut out, mut rest) = (String::new(), text);
    while let Some((before, behind)) = rest.split_once('^') {
        out += &plain(before);
        match exponent(behind) {
            Some((exponent, length)) => {
                // What is raised in an exponent stays as it is written.
                out += &format!("<sup>{}</sup>", plain(exponent));
                rest = &behind[length..];
            }
            None => {
                out.push('^');
                rest = behind;
            }
        }
    }
    out + &plain(rest)
}

/// Words in which formulas stand between backticks, and how text is shown.
fn with_code(words: &str, shown: fn(&str) -> String) -> String {
    let pieces = words.split('`').enumerate();
    pieces.fold(String::new(), |text, (at, piece)| {
        text + ["", "<code>", "</code>"][if at == 0 { 0 } else { 2 - at % 2 }] + &shown(piece)
    })
}

/// A document as its places are shown.
struct ShownDocument<'d> {
    document: &'d Document,
    lines: LineIndex<'d>,
    /// The last line with text.
    last: usize,
}

impl ShownDocument<'_> {
    /// Whether its lines are those of a page that was made, with formulas on one line.
    fn is_made(&self) -> bool {
        self.document.label(1).is_some()
    }

    /// How formulas are shown that are not in the notation of the text.
    fn formula(&self) -> fn(&str) -> String {
        // In the source of a text an exponent may be written in other ways than `^`.
        if self.is_made() || self.document.is_markup() { raised } else { plain }
    }

    /// What a place is called.
    fn place(&self, span: Span) -> String {
        let [from, _] = self.lines.line_columns(span);
        let named = self.document.label(from.line);
        named.unwrap_or_else(|| format!("line {}, column {}", from.line, from.column))
    }
}

/// A part of a line of at most [`LONGEST`] characters around a place in it, or the start of a line without one.
fn cut(text: &str, place: &Range<usize>) -> Range<usize> {
    let longest = if place.is_empty() { LONGEST_AROUND } else { LONGEST };
    if text.chars().nth(longest).is_none() {
        return 0..text.len();
    }
    let before = if place.is_empty() { "" } else { text.get(..place.start).unwrap_or_default() };
    let from = before.char_indices().rev().nth(longest / 2).map_or(0, |(at, _)| at);
    let to = text[from..].char_indices().nth(longest).map_or(text.len(), |(at, _)| from + at);
    from..to
}

/// A line with its number, and the part of it that is marked.
fn row(of: &ShownDocument<'_>, number: usize, span: Span, out: &mut String) {
    let lines = &of.lines;
    let (text, start) = (lines.line(number), lines.line_start(number));
    let inside = |at: u32| {
        let at = (at as usize).saturating_sub(start).min(text.len());
        (0..=at).rfind(|at| text.is_char_boundary(*at)).unwrap_or(0)
    };
    let mut marked = inside(span.start)..inside(span.end);
    // The brace that closes what was opened in the place belongs to it.
    let opened = text[marked.clone()].matches('{').count().saturating_sub(text[marked.clone()].matches('}').count());
    marked.end += text[marked.end..].bytes().take(opened).take_while(|byte| *byte == b'}').count();
    let shown = cut(text, &marked);
    let within = |at: usize| at.clamp(shown.start, shown.end);
    let pieces =
        [shown.start..within(marked.start), within(marked.start)..within(marked.end), within(marked.end)..shown.end];
    let [before, place, behind] = pieces.map(|piece| {
        let piece = text.get(piece).unwrap_or_default();
        if of.is_made() { raised(piece) } else { plain(piece) }
    });
    // A paragraph has no number that a person could look up.
    let number = if of.is_made() { String::new() } else { number.to_string() };
    let place = if place.is_empty() { place } else { format!("<mark>{place}</mark>") };
    let dots = [shown.start > 0, shown.end < text.len()].map(|is_cut| if is_cut { "…" } else { "" });
    let _ = write!(
        out,
        "<span class=\"row\"><span class=\"number\" aria-hidden=\"true\">{number}</span><span class=\"source\">{}{before}{place}{behind}{}</span></span>",
        dots[0], dots[1]
    );
}

/// The lines around a place.
fn excerpt(of: &ShownDocument<'_>, span: Span) -> String {
    let ShownDocument { lines, last, .. } = of;
    let [from, to] = lines.line_columns(span);
    let to = to.line.min(from.line + MOST_LINES);
    let mut out = "<pre>".to_owned();
    let is_blank = |number: &usize| lines.line(*number).trim().is_empty();
    let before = (from.line.saturating_sub(AROUND).max(1)..from.line).skip_while(is_blank);
    let behind = (to + 1..=(to + AROUND).min(*last)).rev().skip_while(is_blank).collect::<Vec<_>>();
    for number in before.chain(from.line..=to).chain(behind.into_iter().rev()) {
        row(of, number, span, &mut out);
    }
    out + "</pre>\n"
}

fn article(group: &FindingGroup, id: &str, of: &ShownDocument<'_>) -> String {
    let finding = &group.finding;
    let (kind, colour) = match finding.section {
        ReportSection::Numbers | ReportSection::Statistics => ("", "wrong"),
        ReportSection::LessCertain => (" class=\"other-list less-certain\"", "other"),
        _ => (" class=\"other-list\"", "other"),
    };
    let mut out = format!(
        "<article id=\"{id}\"{kind} aria-labelledby=\"{id}-title\">\n<h3 id=\"{id}-title\"><span class=\"{colour}\">{}</span> \
         <span class=\"place\">{}</span></h3>\n",
        plain(&capitalised(finding.verdict.description())),
        plain(&of.place(finding.at))
    );
    out += &excerpt(of, finding.at);
    out += "<dl>\n";
    let piece = |range: Range<usize>| raised(finding.chain.get(range).unwrap_or_default());
    let marked = &finding.marked;
    let place = match piece(marked.clone()) {
        place if place.is_empty() => place,
        place => format!("<mark>{place}</mark>"),
    };
    let chain = format!("{}{place}{}", piece(0..marked.start), piece(marked.end..finding.chain.len()));
    let _ = writeln!(out, "<dt>Read as</dt><dd class=\"chain\">{chain}</dd>");
    let mut fact = |label: &str, words: Option<String>| {
        if let Some(words) = words {
            let _ = writeln!(out, "<dt>{label}</dt><dd>{words}</dd>");
        }
    };
    fact("Printed", Some(raised(&finding.printed)));
    fact("Recomputed", finding.recomputed_in_words().or_else(|| finding.difference.clone()).as_deref().map(raised));
    fact("Hint", finding.hint.as_ref().map(|hint| with_code(&hint.words, of.formula()) + " would agree"));
    let is_apart = finding.section == ReportSection::LessCertain;
    fact(if is_apart { "Less certain" } else { "Note" }, finding.caveat.map(|caveat| plain(&caveat.reason())));
    fact("Set aside", finding.doubt.map(|doubt| plain(doubt.reason())));
    fact("Why", finding.why.as_deref().map(|why| with_code(why, plain)));
    let listed = |words: String| (!words.is_empty()).then(|| plain(&words));
    fact("Nearest reading", listed(finding.reading.join(", ")));
    fact("With values from elsewhere", listed(finding.names.join(", ")));
    let others = group.others.iter().map(|other| {
        let place = plain(&capitalised(&of.place(other.at)));
        format!("<li>{place}: <span class=\"chain\">{}</span></li>\n", raised(&other.chain))
    });
    let others: String = others.collect();
    if !others.is_empty() {
        let places = describe_count(group.others.len(), "more place");
        let _ = writeln!(
            out,
            "<dt>Also</dt><dd><details><summary>At {places} of the same shape</summary>\n<ul>\n{others}</ul>\n</details></dd>"
        );
    }
    out + "</dl>\n</article>\n"
}

/// The chains that were not checked, as a list.
fn unchecked_list(chains: &[UncheckedChain], of: &ShownDocument<'_>) -> String {
    if chains.is_empty() {
        return String::new();
    }
    let item = |chain: &UncheckedChain| {
        let [from, _] = of.lines.line_columns(chain.span);
        let place = of.document.label(from.line).unwrap_or_else(|| format!("line {}", from.line));
        let what = if chain.partly { "checked in part" } else { "not checked" };
        format!(
            "<li>{}, {what}, {}: <code>{}</code></li>\n",
            plain(&capitalised(&place)),
            with_code(&chain.reason(), plain),
            of.formula()(&chain.chain)
        )
    };
    format!("<h3>Chains that were not checked</h3>\n<ul>\n{}</ul>\n", chains.iter().map(item).collect::<String>())
}

impl ReportWriter for HtmlWriter {
    fn document(&mut self, checked: &CheckedDocument<'_>) -> String {
        let unchecked = checked.unchecked.as_deref().unwrap_or_default();
        if checked.findings.is_empty() && unchecked.is_empty() {
            return String::new();
        }
        let text = &checked.document.text;
        let lines = LineIndex::new(text);
        let last = lines.line_column(text.trim_end().len()).line;
        let of = ShownDocument { document: checked.document, lines, last };
        let number = self.documents.len() + 1;
        let articles = checked.findings.iter().enumerate();
        let articles = articles.map(|(at, group)| article(group, &format!("f{number}-{}", at + 1), &of));
        let body = articles.collect::<String>() + &unchecked_list(unchecked, &of);
        let count = describe_count(checked.findings.len(), "finding");
        self.documents.push(DocumentPart { name: plain(&escaped(&checked.document.name)), count, body });
        String::new()
    }

    fn end(&mut self, sum: &RunTotals) -> String {
        let found = findings_sentence(sum);
        let colour = if found.is_some() { "wrong" } else { "right" };
        let found = found.unwrap_or_else(|| "Nothing found.".to_owned());
        let sentences: String =
            summary_sentences(sum).iter().map(|said| format!("<li>{}</li>\n", with_code(said, plain))).collect();
        let mut page = format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Proofreading report: {found}</title>\n\
             <style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n<h1>Proofreading report</h1>\n<p class=\"result {colour}\">{found}</p>\n\
             </header>\n<main>\n<section aria-labelledby=\"summary\">\n<h2 id=\"summary\">What was checked</h2>\n<ul>\n{sentences}</ul>\n"
        );
        if sum.found.on(ReportSection::LessCertain) > 0 {
            page += LESS_CERTAIN_SWITCH;
        }
        if self.documents.len() > 1 {
            page += "<nav aria-label=\"Files\">\n<ol>\n";
            for (at, part) in self.documents.iter().enumerate() {
                let _ = writeln!(page, "<li><a href=\"#f{}\">{}</a>: {}</li>", at + 1, part.name, part.count);
            }
            page += "</ol>\n</nav>\n";
        }
        page += "</section>\n";
        for (at, part) in std::mem::take(&mut self.documents).into_iter().enumerate() {
            let id = at + 1;
            let _ = write!(
                page,
                "<section aria-labelledby=\"f{id}\">\n<h2 id=\"f{id}\">{}</h2>\n{}</section>\n",
                part.name, part.body
            );
        }
        page + &format!(
            "</main>\n<footer>Written by proofread {}.</footer>\n</body>\n</html>\n",
            env!("CARGO_PKG_VERSION")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::raised;

    #[test]
    fn exponents_are_raised_and_nothing_else_is() {
        for (text, page) in [
            ("6.2 × 10^−3 m", "6.2 × 10<sup>−3</sup> m"),
            ("4^(1/2) + x^2", "4<sup>1/2</sup> + x<sup>2</sup>"),
            ("2^(3·(1 + 1)) = 64", "2<sup>3·(1 + 1)</sup> = 64"),
            ("e^x, and 2^3.", "e<sup>x</sup>, and 2<sup>3</sup>."),
            ("1.5^2.5", "1.5<sup>2.5</sup>"),
            ("2^(3 < 4", "2^(3 &lt; 4"),
            ("2^ 3 ^ ^^−", "2^ 3 ^ ^^−"),
            ("x^(<b>)", "x<sup>&lt;b&gt;</sup>"),
            ("", ""),
        ] {
            assert_eq!(raised(text), page, "{text}");
        }
    }
}
