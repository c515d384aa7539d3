//! The Rust sources of the crates as the rules of the repository read them: code alone, without comments, texts and unit tests.

use std::ops::Range;
use std::path::Path;
use std::sync::OnceLock;

/// A file of a crate's folder `src`.
pub(super) struct Source {
    /// The folder of the crate, such as `kinematics`.
    pub package: String,
    /// The path below `src`, such as `wheel/mod.rs`.
    pub file: String,
    /// The names of the module, outermost first; none for the root of the crate.
    pub module: Vec<String>,
    /// The code: as many lines as the file, blank where comments, texts and unit tests are.
    pub code: String,
}

/// The sources of all crates, by crate and path. Programs' `main.rs` and modules that are compiled for tests alone are left out.
pub(super) fn sources() -> &'static [Source] {
    static SOURCES: OnceLock<Vec<Source>> = OnceLock::new();
    SOURCES.get_or_init(|| {
        let mut sources = Vec::new();
        for entry in std::fs::read_dir(crate::path("crates")).expect("the crates") {
            let package = entry.expect("readable").file_name().to_string_lossy().into_owned();
            let folder = format!("crates/{package}/src");
            let texts = crate::files(&folder, &[".rs"]).into_iter().map(|(path, text)| {
                let file = path.strip_prefix(crate::path(&folder)).expect("inside");
                (file.to_string_lossy().replace('\\', "/"), text)
            });
            sources.extend(sources_of(&package, texts));
        }
        sources.sort_by(|a, b| (&a.package, &a.file).cmp(&(&b.package, &b.file)));
        sources
    })
}

/// The sources of a crate from the texts of its files, each with its path below `src`.
pub(super) fn sources_of(package: &str, texts: impl IntoIterator<Item = (String, String)>) -> Vec<Source> {
    let mut of_tests: Vec<Vec<String>> = Vec::new();
    let mut sources = Vec::new();
    for (file, text) in texts.into_iter().filter(|(file, _)| file != "main.rs") {
        let module = module_of(&file);
        let (code, test_modules) = without_tests(&masked(&text));
        of_tests.extend(test_modules.into_iter().map(|name| [module.as_slice(), &[name]].concat()));
        sources.push(Source { package: package.to_owned(), file, module, code });
    }
    sources.retain(|source| !of_tests.iter().any(|module| source.module.starts_with(module)));
    sources
}

/// The module of a file, from its path below `src`.
fn module_of(file: &str) -> Vec<String> {
    let path = Path::new(file).with_extension("");
    let names = path.iter().map(|name| name.to_string_lossy().into_owned());
    names.filter(|name| !["mod", "lib"].contains(&name.as_str())).collect()
}

/// Whether a character can be part of a name.
pub(super) fn is_of_a_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// A text of Rust with spaces for comments, for what stands in texts and for characters in quotes. Lines stay lines.
pub(super) fn masked(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    let mut before = ' ';
    while let Some(c) = rest.chars().next() {
        let length = match c {
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            '/' if rest.starts_with("/*") => length_of_comment(rest),
            '"' => length_of_text(rest),
            'r' | 'b' | 'c' if !is_of_a_name(before) => length_of_raw_text(rest),
            '\'' => length_of_character(rest),
            _ => 0,
        };
        if length == 0 {
            out.push(c);
            rest = &rest[c.len_utf8()..];
        } else {
            let is_comment = c == '/';
            let blank = |c: char| if c == '\n' { '\n' } else { ' ' };
            // A text keeps a mark, so that something stands where a value is.
            out.push(if is_comment { ' ' } else { '"' });
            out.extend(rest[..length].chars().skip(1).map(blank));
            rest = &rest[length..];
        }
        before = c;
    }
    out
}

/// The length of the comment in `/*` and `*/`, which may hold others, that begins a text.
fn length_of_comment(text: &str) -> usize {
    let mut depth = 0_usize;
    let mut at = 0;
    while at < text.len() {
        if text[at..].starts_with("/*") {
            depth += 1;
            at += 2;
        } else if text[at..].starts_with("*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                return at;
            }
        } else {
            at += text[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    text.len()
}

/// The length of the text in quotation marks that begins `text`.
fn length_of_text(text: &str) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            '"' if !escaped => return at + 1,
            _ => escaped = c == '\\' && !escaped,
        }
    }
    text.len()
}

/// The length of the raw text (`r"…"`, `br#"…"#`) that begins `text`, or zero.
fn length_of_raw_text(text: &str) -> usize {
    let marks = text.trim_start_matches(['b', 'c']);
    let Some(marks) = marks.strip_prefix('r').filter(|_| text.len() - marks.len() < 2) else { return 0 };
    let inside = marks.trim_start_matches('#');
    let Some(inside) = inside.strip_prefix('"') else { return 0 };
    let start = text.len() - inside.len();
    let end = format!("\"{}", "#".repeat(marks.len() - inside.len() - 1));
    inside.find(&end).map_or(text.len(), |at| start + at + end.len())
}

/// The length of the character in quotes that begins `text`, or zero if it is a lifetime.
fn length_of_character(text: &str) -> usize {
    let mut signs = text.char_indices().skip(1);
    match (signs.next(), signs.next()) {
        (Some((_, '\\')), Some((at, sign))) => {
            let past = at + sign.len_utf8();
            text[past..].find('\'').map_or(0, |end| past + end + 1)
        }
        (Some(_), Some((at, '\''))) => at + 1,
        _ => 0,
    }
}

/// Code without what is compiled for tests alone, and the names of the modules that are so and have files of their own.
pub(super) fn without_tests(code: &str) -> (String, Vec<String>) {
    const MARK: &str = "#[cfg(test)]";
    let mut out = code.to_owned();
    let mut modules = Vec::new();
    let mut from = 0;
    while let Some(at) = out[from..].find(MARK).map(|at| from + at) {
        let end = end_of_item(&out, at);
        let item = &out[at..end];
        if let Some(declared) = item.strip_suffix(';')
            && let Some((_, name)) = declared.rsplit_once("mod ")
        {
            modules.push(name.trim().to_owned());
        }
        let blank: String = item.chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect();
        from = at + blank.len();
        out.replace_range(at..end, &blank);
    }
    (out, modules)
}

/// The end of the item, with its attributes, that begins at a place of masked code.
fn end_of_item(code: &str, start: usize) -> usize {
    let mut at = start;
    while code[at..].trim_start().starts_with('#') {
        at = end_of_brackets(code, at + code[at..].find('[').unwrap_or(0));
    }
    let words: Vec<&str> =
        code[at..].split(|c: char| !is_of_a_name(c)).filter(|word| !word.is_empty()).take(4).collect();
    let is_value = words.iter().any(|word| ["use", "static"].contains(word))
        || words.windows(2).any(|pair| pair[0] == "const" && pair[1] != "fn");
    while let Some(next) = code[at..].find([';', '{', '(', '[']).map(|next| at + next) {
        if code[next..].starts_with(';') {
            return next + 1;
        }
        at = end_of_brackets(code, next);
        if code[next..].starts_with('{') && !is_value {
            return at;
        }
    }
    code.len()
}

/// The place behind the bracket that closes the one at a place of masked code.
pub(super) fn end_of_brackets(code: &str, start: usize) -> usize {
    let mut depth = 0_usize;
    for (at, c) in code[start..].char_indices() {
        match c {
            '{' | '(' | '[' => depth += 1,
            '}' | ')' | ']' => depth = depth.saturating_sub(1),
            _ => continue,
        }
        if depth == 0 {
            return start + at + 1;
        }
    }
    code.len()
}

/// The places in code at which a word stands as a whole.
pub(super) fn places_of<'a>(code: &'a str, word: &'a str) -> impl Iterator<Item = Range<usize>> + 'a {
    code.match_indices(word)
        .map(|(at, _)| at..at + word.len())
        .filter(|place| !code[..place.start].ends_with(is_of_a_name) && !code[place.end..].starts_with(is_of_a_name))
}

/// What is declared public in code, by any of these keywords: the keyword, the name and the number of the line.
pub(super) fn public_items<'a>(code: &'a str, keywords: &'a [&str]) -> impl Iterator<Item = (&'a str, &'a str, usize)> {
    code.lines().enumerate().filter_map(|(number, line)| {
        let mut words = line.trim().strip_prefix("pub ")?.split_whitespace();
        let is_before = |word: &&str| ["const", "async", "unsafe", "extern", "\""].contains(word);
        let keyword = words.find(|word| !is_before(word)).filter(|word| keywords.contains(word))?;
        let name = words.next()?.split(|c: char| !is_of_a_name(c)).next()?;
        Some((keyword, name, number + 1))
    })
}

#[test]
fn code_is_told_from_comments_texts_and_tests() {
    let text =
        "use a; // use b;\n/* use c; /* d */ use e; */ fn f<'a>() { \"use \\\" g\"; '\"'; '\\''; r#\"use \" h\"# }\n";
    let code = masked(text);
    assert_eq!(code.lines().count(), 2);
    let words: Vec<&str> = code.split(|c| !is_of_a_name(c)).filter(|word| !word.is_empty()).collect();
    assert_eq!(words, ["use", "a", "fn", "f", "a"]);

    let tested = "fn a() {}\n#[cfg(test)]\n#[allow(x)]\nmod tests {\n    fn b() { c(); }\n}\nfn d() {}\n#[cfg(test)]\nmod drawn;\n\
                  #[cfg(test)]\nuse e::{f, g};\n#[cfg(test)]\npub(super) fn h(i: [u8; 2]) -> u8 { i[0] }\nfn j() {}\n";
    let (code, modules) = without_tests(tested);
    assert_eq!((code.lines().count(), modules), (tested.lines().count(), vec!["drawn".to_owned()]));
    assert_eq!(code.split_whitespace().collect::<Vec<_>>().join(" "), "fn a() {} fn d() {} fn j() {}");

    let files = [
        ("lib.rs", "mod wheel;"),
        ("wheel/mod.rs", "#[cfg(test)]\nmod checks;"),
        ("wheel/checks.rs", ""),
        ("main.rs", ""),
    ];
    let of_crate = sources_of("made_up", files.map(|(file, text)| (file.to_owned(), text.to_owned())));
    let modules: Vec<String> = of_crate.iter().map(|source| source.module.join("::")).collect();
    assert_eq!(modules, ["", "wheel"]);
}

#[test]
fn a_public_item_is_told_from_others() {
    let code = "pub struct Wheel<S> {\n    pub radius: S,\n}\npub(crate) enum Sense {}\nimpl Wheel {\n    pub const fn speed(&self) {}\n}\n\
                pub const fn turn() {}\npub const SPEED: f64 = 1.0;\npub type Pair = [f64; 2];\n";
    let items = |keywords| public_items(code, keywords).collect::<Vec<_>>();
    assert_eq!(items(&["struct", "enum", "type"]), [("struct", "Wheel", 1), ("type", "Pair", 10)]);
    assert_eq!(items(&["fn"]), [("fn", "speed", 6), ("fn", "turn", 8)]);
}
