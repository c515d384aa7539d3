//! Which format a text is written in, told by what is in it.

use super::TextFormat;

/// Commands that a document in LaTeX has and a formula does not.
const LATEX: [&str; 9] = [
    "\\documentclass",
    "\\usepackage",
    "\\begin{document}",
    "\\chapter{",
    "\\section{",
    "\\section*{",
    "\\subsection{",
    "\\newcommand",
    "\\item",
];

/// Environments of LaTeX with a formula in them, which stand in Markdown between dollar signs only.
const DISPLAYS: [&str; 4] = ["\\begin{equation", "\\begin{align", "\\begin{eqnarray", "\\begin{gather"];

/// Elements of HTML that other formats of XML seldom have.
const HTML: [&str; 5] = ["<!doctype html", "<html", "<body", "<p>", "<div"];

impl TextFormat {
    /// The format in which a text is most probably written, by what is in it.
    ///
    /// Every text has one: what shows no marks of another format is read as plain lines.
    ///
    /// ```
    /// use proofread::TextFormat;
    ///
    /// assert_eq!(TextFormat::recognise(r"\section{Speed} It is $2 + 2 = 5$."), TextFormat::Latex);
    /// assert_eq!(TextFormat::recognise("2 + 2 = 5"), TextFormat::Plain);
    /// ```
    pub fn recognise(text: &str) -> Self {
        let start = text.trim_start_matches(['\u{feff}', ' ', '\t', '\r', '\n']);
        if start.starts_with('{') && text.contains("\"cells\"") {
            return Self::Notebook;
        }
        let has = |marks: &[&str]| marks.iter().any(|mark| text.contains(mark));
        if start.starts_with('<') || has(&["<math", "<m:math", "<mml:math"]) {
            let lower = text.to_ascii_lowercase();
            let is_xml = start.starts_with("<?xml") && !lower.contains("<html") || has(&["<m:math", "<m>", "<me>"]);
            let is_html = !is_xml && HTML.iter().any(|mark| lower.contains(mark));
            return if is_html { Self::Html } else { Self::Xml };
        }
        if has(&LATEX) || has(&DISPLAYS) && !text.contains("$$") {
            return Self::Latex;
        }
        let has_heading = text.lines().any(|line| line.starts_with("# ") || line.starts_with("## "));
        if has_heading || has(&["$", "\\(", "\\[", "```", "]("]) { Self::Markdown } else { Self::Plain }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_format_is_told_by_its_marks() {
        for (text, format) in [
            ("\u{feff}{\n \"cells\": []}", TextFormat::Notebook),
            ("<?xml version=\"1.0\"?><document><m:math/></document>", TextFormat::Xml),
            ("<chapter><p>It is <m>1 + 1 = 2</m>.</p></chapter>", TextFormat::Xml),
            ("<para><math><mn>1</mn></math></para>", TextFormat::Xml),
            ("<!DOCTYPE html>\n<p>\\(1+1=2\\)</p>", TextFormat::Html),
            ("\\documentclass{article}\n$1+1=2$", TextFormat::Latex),
            ("\\begin{align*} 1+1 &= 2 \\end{align*}", TextFormat::Latex),
            ("$$\\begin{aligned} 1+1 &= 2 \\end{aligned}$$", TextFormat::Markdown),
            ("# Heading\n\n1 + 1 = 2", TextFormat::Markdown),
            ("It is $1+1=2$.", TextFormat::Markdown),
            ("F = 2 kg × 3 m/s² = 6 N", TextFormat::Plain),
            ("a < b, 1 + 1 = 2", TextFormat::Plain),
            ("", TextFormat::Plain),
        ] {
            assert_eq!(TextFormat::recognise(text), format, "{text}");
        }
    }
}
