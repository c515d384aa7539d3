//! The tables of a text in each of the formats.

use super::table::{TableCell, TextTable};
use crate::reader::{TextFormat, next_tag, shown_text};
use crate::token::Span;
use std::ops::Range;

/// Most rows of a table that is read.
const MOST_ROWS: usize = 5000;
/// Most columns of a table that is read.
const MOST_COLUMNS: usize = 64;

/// The tables of a text; `place` finds a stretch of the shown text in the file.
pub(super) fn tables(text: &str, shown: &str, format: TextFormat, place: &dyn Fn(Span) -> Span) -> Vec<TextTable> {
    match format {
        TextFormat::Markdown | TextFormat::Notebook | TextFormat::Plain => piped(shown, format, place),
        TextFormat::Latex => tabular(text),
        TextFormat::Html | TextFormat::Xml => marked_up(text, format),
        TextFormat::Csv => vec![separated(text)],
    }
}

/// Lines with strokes between the cells, the second of which is a rule.
fn piped(text: &str, format: TextFormat, place: &dyn Fn(Span) -> Span) -> Vec<TextTable> {
    let mut out = Vec::new();
    let mut lines: Vec<Range<usize>> = Vec::new();
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let range = start..start + line.trim_end().len();
        start += line.len();
        if line.contains('|') || is_grid_rule(line) {
            lines.push(range);
            continue;
        }
        out.extend(piped_table(text, &std::mem::take(&mut lines), format, place));
    }
    out.extend(piped_table(text, &lines, format, place));
    out
}

/// Whether a line parts the rows of a grid table of Pandoc: `+-----+-----+`, or `+=====+=====+` below the head.
fn is_grid_rule(line: &str) -> bool {
    let line = line.trim();
    line.len() > 2 && line.starts_with('+') && line.ends_with('+') && line.chars().all(|c| "+-=:".contains(c))
}

fn piped_table(
    text: &str,
    lines: &[Range<usize>],
    format: TextFormat,
    place: &dyn Fn(Span) -> Span,
) -> Option<TextTable> {
    let is_rule = |line: &Range<usize>| {
        let line = &text[line.clone()];
        is_grid_rule(line) || line.contains('-') && line.chars().all(|c| "|:-+–— \t>".contains(c))
    };
    let is_grid = lines.first().is_some_and(|line| is_grid_rule(&text[line.clone()]));
    if lines.len() < 3 || lines.len() > MOST_ROWS || !(is_grid || is_rule(&lines[1])) {
        return None;
    }
    let rows = lines.iter().filter(|line| !is_rule(line)).map(|line| {
        let mut range = line.clone();
        let row = text[range.clone()].trim_start_matches([' ', '\t', '>']);
        range.start = range.end - row.len();
        range.start += usize::from(row.starts_with('|'));
        if text[range.clone()].ends_with('|') && !text[range.clone()].ends_with("\\|") {
            range.end -= 1;
        }
        let (mut cells, mut from) = (Vec::new(), range.start);
        let strokes = text[range.clone()].match_indices('|').map(|(at, _)| range.start + at);
        let strokes = strokes.filter(|at| !text[..*at].ends_with('\\'));
        for end in strokes.chain([range.end]).take(MOST_COLUMNS) {
            cells.push(TableCell::new(&text[from..end], from, format, place));
            from = end + 1;
        }
        cells
    });
    Some(TextTable { rows: rows.collect() })
}

/// Environments of LaTeX that are tables.
const ENVIRONMENTS: [&str; 8] =
    ["tabular", "tabular*", "tabularx", "tabulary", "longtable", "longtabu", "tabu", "tblr"];

fn tabular(text: &str) -> Vec<TextTable> {
    const BEGIN: &str = "\\begin{";
    let mut out = Vec::new();
    for (at, _) in text.match_indices(BEGIN) {
        let rest = &text[at + BEGIN.len()..];
        let Some(name) =
            ENVIRONMENTS.iter().find(|name| rest.strip_prefix(**name).is_some_and(|rest| rest.starts_with('}')))
        else {
            continue;
        };
        let line = text[..at].rfind('\n').map_or(0, |end| end + 1);
        if is_commented(&text[line..at]) {
            continue;
        }
        let mut start = at + BEGIN.len() + name.len() + 1;
        while let Some(end) = group_end(text, start) {
            start = end;
        }
        let Some(length) = text[start..].find(&format!("\\end{{{name}}}")) else { return out };
        let inside = &text[start..start + length];
        if !inside.contains("\\begin{tab") {
            out.extend(tabular_rows(text, start..start + length));
        }
    }
    out
}

fn is_commented(line: &str) -> bool {
    line.match_indices('%').any(|(at, _)| !line[..at].ends_with('\\'))
}

/// Behind a group in brackets or braces that begins at `at`.
fn group_end(text: &str, at: usize) -> Option<usize> {
    /// Longest group, in bytes.
    const LONGEST: usize = 1000;
    let bytes = text.as_bytes();
    let open = *bytes.get(at)?;
    let close = match open {
        b'{' => b'}',
        b'[' => b']',
        b'(' => b')',
        _ => return None,
    };
    let mut depth = 0usize;
    for (by, byte) in bytes[at..].iter().take(LONGEST).enumerate() {
        depth += usize::from(*byte == open);
        depth -= usize::from(*byte == close);
        if depth == 0 {
            return Some(at + by + 1);
        }
    }
    None
}

fn tabular_rows(text: &str, inside: Range<usize>) -> Option<TextTable> {
    let bytes = text.as_bytes();
    let (mut rows, mut cells) = (Vec::new(), Vec::new());
    let (mut at, mut from, mut depth) = (inside.start, inside.start, 0usize);
    while at <= inside.end {
        let ends = at == inside.end;
        let is_row_end =
            !ends && depth == 0 && (text[at..].starts_with("\\\\") || text[at..].starts_with("\\tabularnewline"));
        let is_cell_end = !ends && depth == 0 && bytes[at] == b'&';
        if ends || is_row_end || is_cell_end {
            push_cells(text, from..at, &mut cells);
            if cells.len() > MOST_COLUMNS || rows.len() > MOST_ROWS {
                return None;
            }
            if !is_cell_end {
                rows.push(std::mem::take(&mut cells));
            }
            at += if is_cell_end || ends {
                1
            } else if text[at..].starts_with("\\\\") {
                2
            } else {
                15
            };
            if is_row_end
                && let Some(end) = bytes.get(at).filter(|byte| **byte == b'[').and_then(|_| group_end(text, at))
            {
                at = end;
            }
            from = at;
            continue;
        }
        match bytes[at] {
            b'\\' => at += 1,
            b'{' => depth += 1,
            b'}' => depth = depth.saturating_sub(1),
            b'%' => {
                at = text[at..inside.end].find('\n').map_or(inside.end, |end| at + end);
                // What is commented out before a cell is no part of it.
                if text[from..at].trim_start().starts_with('%') {
                    from = at;
                }
                continue;
            }
            _ => {}
        }
        at = (at + 1..=inside.end).find(|at| text.is_char_boundary(*at)).unwrap_or(inside.end).max(at + 1);
    }
    rows.retain(|row: &Vec<TableCell>| row.iter().any(|cell| !cell.text.is_empty()));
    Some(TextTable { rows })
}

/// Rules and settings that may stand before the first cell of a row.
const RULES: [&str; 13] = [
    "hline",
    "toprule",
    "midrule",
    "bottomrule",
    "cmidrule",
    "cline",
    "addlinespace",
    "rowcolor",
    "endhead",
    "endfirsthead",
    "endfoot",
    "endlastfoot",
    "specialrule",
];

/// Adds a cell, and the empty ones that it covers.
fn push_cells(text: &str, mut range: Range<usize>, cells: &mut Vec<TableCell>) {
    loop {
        let trimmed = text[range.clone()].trim_start();
        range.start = range.end - trimmed.len();
        let Some(rest) = trimmed.strip_prefix('\\') else { break };
        let name: String = rest.chars().take_while(char::is_ascii_alphabetic).collect();
        if !RULES.contains(&name.as_str()) {
            break;
        }
        range.start += 1 + name.len();
        while range.start < range.end
            && let Some(end) = group_end(text, range.start)
        {
            range.start = end.min(range.end);
        }
    }
    let mut columns = 1;
    for command in ["\\multicolumn", "\\multirow"] {
        if text[range.clone()].starts_with(command) {
            let at = range.start + command.len();
            let ends = group_end(text, at).and_then(|first| Some((first, group_end(text, first)?)));
            if let Some((first, second)) = ends
                && second < range.end
                && let Some(last) = group_end(text, second)
            {
                if command == "\\multicolumn" {
                    columns = text[at + 1..first - 1].trim().parse().unwrap_or(1).clamp(1, MOST_COLUMNS);
                }
                range = second + 1..(last - 1).min(range.end);
            }
        }
    }
    cells.push(TableCell::new(&text[range.clone()], range.start, TextFormat::Latex, &|span| span));
    cells.resize(cells.len() + columns - 1, TableCell::default());
}

fn marked_up(text: &str, format: TextFormat) -> Vec<TextTable> {
    let mut out = Vec::new();
    let mut table: Option<TextTable> = None;
    // Rows that a cell of each column still covers.
    let mut covered: Vec<usize> = Vec::new();
    // Where the open cell began, with its columns and rows.
    let mut open: Option<(usize, usize, usize)> = None;
    let mut at = 0;
    while let Some(tag) = next_tag(text, at) {
        at = tag.end;
        let name = tag.name.as_str();
        let is_cell = matches!(name, "td" | "th" | "entry");
        let is_row = matches!(name, "tr" | "row");
        if !(is_cell || is_row || matches!(name, "table" | "tbody" | "thead" | "tfoot" | "tgroup")) {
            continue;
        }
        if let (Some((start, columns, rows)), Some(row)) =
            (open.take(), table.as_mut().and_then(|table| table.rows.last_mut()))
        {
            close_cell(text, start..tag.start, [columns, rows], format, row, &mut covered);
        }
        match (name, tag.closes) {
            ("table", false) => {
                // A table in a table is not read, and neither is the outer one.
                table = Some(TextTable::default());
                covered.clear();
            }
            ("table", true) => out.extend(table.take()),
            (_, false) if is_row => {
                if let Some(table) = table.as_mut().filter(|table| table.rows.len() < MOST_ROWS) {
                    table.rows.push(Vec::new());
                }
            }
            (_, false) if is_cell => {
                let count = |name: &str| tag.attribute(name).and_then(|count| count.parse::<usize>().ok()).unwrap_or(1);
                open = Some((tag.end, count("colspan").clamp(1, MOST_COLUMNS), count("rowspan").clamp(1, MOST_ROWS)));
            }
            _ => {}
        }
    }
    out
}

fn close_cell(
    text: &str,
    range: Range<usize>,
    [columns, rows]: [usize; 2],
    format: TextFormat,
    row: &mut Vec<TableCell>,
    covered: &mut Vec<usize>,
) {
    while covered.get(row.len()).is_some_and(|rows| *rows > 0) {
        covered[row.len()] -= 1;
        row.push(TableCell::default());
    }
    if row.len() >= MOST_COLUMNS {
        return;
    }
    let Ok(shown) = shown_text(&text[range.clone()], format) else { return };
    let place = |span: Span| {
        let inside = shown.span_in_file(span);
        Span::new(range.start + inside.start as usize, range.start + inside.end as usize)
    };
    let first = row.len();
    row.push(TableCell::new(shown.text(), 0, format, &place));
    row.resize(first + columns, TableCell::default());
    if rows > 1 {
        covered.resize(covered.len().max(first + columns), 0);
        covered[first..first + columns].fill(rows - 1);
    }
}

/// Values with commas, semicolons or tabs between them.
fn separated(text: &str) -> TextTable {
    let line = text.lines().next().unwrap_or_default();
    let separator = [b',', b';', b'\t'].into_iter().max_by_key(|mark| line.bytes().filter(|byte| byte == mark).count());
    let separator = separator.unwrap_or(b',');
    let bytes = text.as_bytes();
    let mut rows: Vec<Vec<TableCell>> = vec![Vec::new()];
    let (mut at, mut from, mut quoted) = (0, 0, false);
    while at <= bytes.len() && rows.len() <= MOST_ROWS {
        let byte = bytes.get(at).copied().unwrap_or(b'\n');
        quoted ^= byte == b'"';
        if (!quoted && (byte == separator || byte == b'\n')) || at >= bytes.len() {
            let inside = text[from..at].trim_end_matches('\r').trim_matches('"');
            let start = from + text[from..at].find(inside).unwrap_or_default();
            if let Some(row) = rows.last_mut().filter(|row| row.len() < MOST_COLUMNS) {
                row.push(TableCell::new(inside, start, TextFormat::Plain, &|span| span));
            }
            if byte != separator {
                rows.push(Vec::new());
            }
            from = at + 1;
        }
        at += 1;
    }
    rows.retain(|row| row.iter().any(|cell| !cell.text.is_empty()));
    TextTable { rows }
}
