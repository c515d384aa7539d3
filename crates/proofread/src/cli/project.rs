//! Files in LaTeX or PreTeXt that belong together: what the files that a document includes, and those that include it, define for it.
//!
//! Definitions are all that is taken from them. Each file is read once, however many documents include it.

use super::documents::{decode_text, is_xml};
use super::tree::FileTree;
use crate::reader::{Definitions, macros_text};
use geneva_host::files::whole_path;
use std::collections::{BTreeSet, HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::SystemTime;

/// Longest file that is searched for definitions, in bytes.
const LONGEST: u64 = 8 << 20;
/// Deepest inclusion that is followed.
const DEEPEST: usize = 32;
/// Most files that one document takes definitions from.
const MOST_FILES: usize = 5000;
/// Most inclusions that are followed for all documents.
const MOST_FOLLOWED: usize = 200_000;
/// Most documents that may include a file and are heard.
const MOST_MAINS: usize = 8;
/// How far above a file the repository may begin.
const HIGHEST: usize = 10;
/// In how many folders above a file a document that includes it is looked for, and where the files that are read must be if
/// there is no repository.
const ABOVE: usize = 2;
/// Most files of a folder above that are looked at.
const MOST_ABOVE: usize = 200;
/// In how many folders above a file that no document includes styles are looked for.
const STYLES_ABOVE: usize = 4;
/// Most packages and classes of such a folder that are read.
const MOST_STYLES: usize = 30;
/// Packages whose commands the reader knows better than their definitions tell.
const KNOWN: [&str; 9] =
    ["siunitx", "physics", "units", "nicefrac", "amsmath", "mathtools", "gensymb", "cancel", "mhchem"];

/// Another file that a file names.
#[derive(Debug, PartialEq)]
struct Inclusion {
    /// The path as it is written, with an extension if it is a package or a class.
    name: String,
    /// Whether it is named before the document begins.
    early: bool,
}

/// What a file says.
#[derive(Debug, Default, PartialEq)]
struct Contents {
    preamble: Definitions,
    body: Definitions,
    inclusions: Vec<Inclusion>,
    /// The document that it says to be part of.
    main: Option<String>,
    /// Whether it is a document by itself.
    is_main: bool,
    /// Whether a chain may be in it, since it has an equals sign and a digit.
    may_have_chains: bool,
}

/// A file that is proofread, and files that it includes which are not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct UncheckedParts {
    /// The file, as it was given.
    pub file: PathBuf,
    /// How many files it includes that are read for their definitions alone although a chain may be in them.
    pub count: usize,
}

/// A file that is read before the document begins, or in it.
type InclusionRoot = (PathBuf, bool);

/// When a file was changed last, and its bytes.
type FileState = (SystemTime, u64);

/// A file that was read.
struct ReadFile {
    contents: Option<Arc<Contents>>,
    /// As the file was before it was read; none for a text that an editor has open, and where the system does not tell.
    state: Option<FileState>,
}

/// The files that were read, and which of them belong together.
#[derive(Default)]
pub(crate) struct Project {
    /// Where the files are.
    tree: FileTree,
    files: HashMap<PathBuf, ReadFile>,
    /// Texts that an editor has open: they count before the files on disk.
    open: HashMap<PathBuf, Arc<str>>,
    /// Where the files of a document may be.
    tops: HashMap<PathBuf, PathBuf>,
    /// The documents that include a file.
    mains: HashMap<PathBuf, BTreeSet<PathBuf>>,
    /// The folders that were searched for documents, in PreTeXt or in LaTeX.
    searched: HashSet<(PathBuf, bool)>,
    /// What was gathered from some files below a folder.
    merged: HashMap<(PathBuf, Vec<InclusionRoot>), Arc<Definitions>>,
    /// The packages and classes of a folder.
    styles: HashMap<PathBuf, Vec<PathBuf>>,
    /// How many inclusions were followed.
    followed: usize,
}

/// Definitions in the order in which LaTeX reads them.
#[derive(Default)]
struct Gathered {
    definitions: Definitions,
    /// Names that mean one thing here and another there.
    unclear: HashSet<Arc<str>>,
    seen: HashSet<PathBuf>,
}

impl Gathered {
    /// Takes the definitions of a preamble, of which the last one counts.
    fn take(&mut self, of: &Definitions) {
        self.definitions.add(of);
        self.unclear.retain(|name| !of.0.contains_key(name));
    }

    /// Takes definitions that hold in a part of the document. A name that has several meanings has none for the other parts.
    fn take_part(&mut self, of: &Definitions) {
        for (name, meaning) in &of.0 {
            let known = self.definitions.0.get(name);
            if known.is_some_and(|known| known != meaning) {
                self.definitions.0.remove(name);
                self.unclear.insert(name.clone());
            } else if known.is_none() && !self.unclear.contains(name) {
                self.definitions.0.insert(name.clone(), meaning.clone());
            }
        }
    }
}

impl Project {
    /// A project whose files are there.
    pub(super) fn new(tree: FileTree) -> Self {
        Self { tree, ..Self::default() }
    }

    /// Begins anew with the texts that an editor has open, by their real paths, and keeps what was read of files and texts that
    /// have not changed since. The answer is whether the definitions or inclusions of an open text have changed.
    pub(super) fn renew(&mut self, open: HashMap<PathBuf, Arc<str>>) -> bool {
        let before = std::mem::take(self);
        let (mut files, mut edited) = (HashMap::new(), Vec::new());
        for (file, read) in before.files {
            let is_same = match (before.open.get(&file), open.get(&file)) {
                (Some(old), Some(new)) => Arc::ptr_eq(old, new),
                (None, None) => read.state.is_some_and(|state| file_state(&file) == Some(state)),
                _ => {
                    edited.push((file, read.contents));
                    continue;
                }
            };
            if is_same {
                files.insert(file, read);
            } else if open.contains_key(&file) {
                edited.push((file, read.contents));
            }
        }
        *self = Self { tree: before.tree, files, open, ..Self::default() };
        edited.into_iter().fold(false, |changed, (file, contents)| (self.read(&file) != contents) || changed)
    }

    /// Adds a file that is proofread, with the folder in which it was found.
    pub(super) fn add(&mut self, file: &Path, folder: Option<&Path>) {
        let Some(file) = self.tree.file(file) else { return };
        let folder = folder.map(whole_path);
        let top = top(&file, folder.as_deref());
        self.tops.insert(file.clone(), top.clone());
        self.main(&file, &top);
        // Folders above those that are searched anyway.
        let above: Vec<PathBuf> = file.ancestors().skip(1).take(ABOVE + 1).map(Path::to_owned).collect();
        for place in above.into_iter().filter(|place| place.starts_with(&top)) {
            if !self.searched.insert((place.clone(), is_xml(&file))) {
                continue;
            }
            let is_alike = |of: &PathBuf| if is_xml(&file) { is_xml(of) } else { has_extension(of, "tex") };
            let named = self.tree.entries(&place).into_iter().filter(is_alike);
            let real = named.filter_map(|of| self.tree.file(&of)).filter(|of| of.starts_with(&top));
            let files: BTreeSet<PathBuf> = real.collect();
            files.iter().take(MOST_ABOVE).for_each(|file| self.main(file, &top));
        }
    }

    /// What other files define for a file.
    pub(super) fn definitions(&mut self, file: &Path) -> Option<Arc<Definitions>> {
        let file = self.tree.file(file)?;
        let top = self.tops.get(&file)?.clone();
        let contents = self.read(&file)?;
        let said = contents.main.as_deref().and_then(|main| self.tree.find(main, [file.parent(), None], &top));
        let said = said.filter(|main| *main != file);
        let mains = self.mains.get(&file).into_iter().flatten().filter(|main| **main != file).take(MOST_MAINS).cloned();
        let folder = file.parent();
        let included = said.is_none();
        let mut roots: Vec<InclusionRoot> = match said {
            Some(main) => vec![(main, true)],
            None => mains.map(|main| (main, true)).collect(),
        };
        // A document that includes the file includes its files, too.
        if roots.is_empty() || !included {
            let own = contents.inclusions.iter();
            roots.extend(own.filter_map(|of| Some((self.tree.find(&of.name, [folder, None], &top)?, of.early))));
        }
        // What no document includes may still be written with the styles of its folder, or of one above it.
        if roots.is_empty() && !contents.is_main && !is_xml(&file) {
            roots = self.styles_near(&file, &top).into_iter().map(|style| (style, false)).collect();
        }
        if roots.is_empty() {
            return None;
        }
        let key = (top.clone(), roots.clone());
        if let Some(known) = self.merged.get(&key) {
            return Some(known.clone());
        }
        let mut out = Gathered::default();
        for (at, (root, early)) in roots.iter().enumerate() {
            let is_main = self.read(root).is_some_and(|contents| contents.is_main);
            let mut one = Gathered::default();
            // What one of several documents reads has no bearing on the other ones.
            let into = if is_main && at > 0 { &mut one } else { &mut out };
            let main = if is_main { root.parent() } else { folder };
            self.gather(root, (main, &top), *early, into);
            if is_main && at > 0 {
                out.take_part(&one.definitions);
            }
        }
        let out = Arc::new(out.definitions);
        self.merged.insert(key, out.clone());
        Some(out)
    }

    /// The packages and classes in the nearest folder that has any, from that of a file up.
    fn styles_near(&mut self, file: &Path, top: &Path) -> Vec<PathBuf> {
        let is_style = |of: &PathBuf| has_extension(of, "sty") || has_extension(of, "cls");
        for place in file.ancestors().skip(1).take(STYLES_ABOVE + 1).take_while(|place| place.starts_with(top)) {
            let tree = &self.tree;
            let styles = self.styles.entry(place.to_owned()).or_insert_with(|| {
                let found: BTreeSet<PathBuf> =
                    tree.entries(place).into_iter().filter(is_style).filter_map(|of| tree.file(&of)).collect();
                found.into_iter().filter(|of| of.starts_with(top)).take(MOST_STYLES).collect()
            });
            if !styles.is_empty() {
                return styles.clone();
            }
        }
        Vec::new()
    }

    /// Notes which files a document includes, if the file is one.
    fn main(&mut self, file: &Path, top: &Path) {
        if self.mains.get(file).is_some_and(|mains| mains.contains(file))
            || !self.read(file).is_some_and(|contents| contents.is_main)
        {
            return;
        }
        let mut out = Gathered::default();
        self.visit(file, (file.parent(), top), true, DEEPEST, &mut out, &mut |_, _, _| {});
        for part in out.seen {
            self.mains.entry(part).or_default().insert(file.to_owned());
        }
    }

    /// The files that others include in their text and that are not among those that are proofread. Each counts for one file.
    pub(super) fn unchecked_parts(&mut self, files: &[PathBuf]) -> Vec<UncheckedParts> {
        let mut known: HashSet<PathBuf> = files.iter().filter_map(|file| self.tree.file(file)).collect();
        let mut out = Vec::new();
        for given in files {
            let Some(file) = self.tree.file(given) else { continue };
            let Some(top) = self.tops.get(&file).cloned() else { continue };
            let main = file.parent().map(Path::to_owned);
            let (mut open, mut count) = (vec![file], 0);
            while let Some(file) = open.pop() {
                let Some(contents) = self.read(&file) else { continue };
                // What a document reads before it begins has definitions.
                for of in contents.inclusions.iter().filter(|of| is_xml(&file) || !(contents.is_main && of.early)) {
                    let beside = if is_xml(&file) { [file.parent(), None] } else { [main.as_deref(), file.parent()] };
                    let part = self.tree.find(&of.name, beside, &top).filter(|part| is_xml(part) || is_text(part));
                    let Some(part) = part.filter(|part| known.len() < MOST_FILES && !known.contains(part)) else {
                        continue;
                    };
                    count += usize::from(self.read(&part).is_some_and(|contents| contents.may_have_chains));
                    known.insert(part.clone());
                    open.push(part);
                }
            }
            if count > 0 {
                out.push(UncheckedParts { file: given.clone(), count });
            }
        }
        out
    }

    fn gather(&mut self, file: &Path, at: (Option<&Path>, &Path), early: bool, out: &mut Gathered) {
        self.visit(file, at, early, DEEPEST, out, &mut |out, of, early| {
            if early { out.take(of) } else { out.take_part(of) }
        });
    }

    /// Hands over the definitions of a file and of what it includes, in their order.
    fn visit(
        &mut self,
        file: &Path,
        (main, top): (Option<&Path>, &Path),
        early: bool,
        depth: usize,
        out: &mut Gathered,
        take: &mut dyn FnMut(&mut Gathered, &Definitions, bool),
    ) {
        let stops = depth == 0 || out.seen.len() >= MOST_FILES || self.followed >= MOST_FOLLOWED;
        if stops || !out.seen.insert(file.to_owned()) {
            return;
        }
        self.followed += 1;
        let Some(contents) = self.read(file) else { return };
        for (is_early, definitions) in [(true, &contents.preamble), (false, &contents.body)] {
            for of in contents.inclusions.iter().filter(|of| of.early == is_early) {
                // LaTeX looks beside the main document; some packages look beside the file, as XML does.
                let beside = if is_xml(file) { [file.parent(), None] } else { [main, file.parent()] };
                if let Some(other) = self.tree.find(&of.name, beside, top) {
                    self.visit(&other, (main, top), early && is_early, depth - 1, out, take);
                }
            }
            take(out, definitions, early && is_early);
        }
    }

    /// The contents of a file, which is read once.
    fn read(&mut self, file: &Path) -> Option<Arc<Contents>> {
        if let Some(known) = self.files.get(file) {
            return known.contents.clone();
        }
        let read = if is_xml(file) { contents_of_xml } else { contents };
        let (contents, state) = if let Some(text) = self.open.get(file) {
            (Some(Arc::new(read(text))), None)
        } else {
            let state = file_state(file);
            let text = self.tree.read(file, LONGEST, "a LaTeX file").and_then(decode_text);
            (text.ok().map(|text| Arc::new(read(&text))), state)
        };
        self.files.insert(file.to_owned(), ReadFile { contents: contents.clone(), state });
        contents
    }
}

fn file_state(file: &Path) -> Option<FileState> {
    let of = std::fs::metadata(file).ok()?;
    Some((of.modified().ok()?, of.len()))
}

fn has_extension(file: &Path, extension: &str) -> bool {
    file.extension().is_some_and(|of| of.eq_ignore_ascii_case(extension))
}

/// Whether a file is a text in LaTeX, and no package or class.
fn is_text(file: &Path) -> bool {
    ["tex", "ltx", "latex"].iter().any(|extension| has_extension(file, extension))
}

fn may_have_chains(text: &str) -> bool {
    text.contains(['=', '≈']) && text.bytes().any(|byte| byte.is_ascii_digit())
}

/// The folder in which everything must be that is read for a file: its repository, or else the folder that was asked for, or a
/// few above the file.
fn top(file: &Path, folder: Option<&Path>) -> PathBuf {
    let above = || file.ancestors().skip(1);
    let repository = above().take(HIGHEST).find(|place| place.join(".git").exists());
    let near = above().take(ABOVE + 1).last();
    let shorter = |one: &Path, other: &Path| one.components().count() <= other.components().count();
    let without = match (folder, near) {
        (Some(folder), Some(near)) if shorter(folder, near) => Some(folder),
        (_, near) => near,
    };
    repository.or(without).unwrap_or(file).to_owned()
}

impl FileTree {
    /// The file of a name in the first of some folders that has it.
    fn find(&self, name: &str, folders: [Option<&Path>; 2], top: &Path) -> Option<PathBuf> {
        let written = Path::new(name);
        if name.is_empty() || written.is_absolute() {
            return None;
        }
        let whole = ["tex", "ltx", "latex", "sty", "cls"].iter().any(|extension| has_extension(written, extension))
            || is_xml(written);
        let name = if whole { name.to_owned() } else { format!("{name}.tex") };
        let mut files = folders.iter().flatten().map(|folder| folder.join(&name));
        files.find_map(|file| self.file(&file)).filter(|file| file.starts_with(top))
    }
}

/// What a part of a book in PreTeXt says about itself and other files.
fn contents_of_xml(text: &str) -> Contents {
    let mut out = Contents {
        preamble: Definitions::from_latex(&macros_text(text)),
        is_main: ["<pretext", "<mathbook"].iter().any(|root| text.contains(root)),
        may_have_chains: may_have_chains(text),
        ..Contents::default()
    };
    for (at, _) in text.match_indices("include") {
        let is_element = text[..at].ends_with(['<', ':']);
        let tag = text[at..].split('>').next().unwrap_or_default();
        let value = |name: &str| {
            let (_, rest) = tag.split_once(name)?;
            let rest = rest.trim_start().strip_prefix('=')?.trim_start();
            rest.get(1..)?.split(&rest[..1]).next().filter(|_| rest.starts_with(['"', '\'']))
        };
        if is_element && value("parse") != Some("text") {
            out.inclusions.extend(value("href").map(|name| Inclusion { name: name.to_owned(), early: true }));
        }
    }
    out
}

/// What a text in LaTeX says about itself and other files.
fn contents(text: &str) -> Contents {
    let mut out = Contents { may_have_chains: may_have_chains(text), ..Contents::default() };
    let (mut begins, mut ends) = (text.len(), text.len());
    let mut at = 0;
    while let Some(found) = text.as_bytes()[at..].iter().position(|byte| b"\\%".contains(byte)).map(|found| at + found)
    {
        let rest = &text[found + 1..];
        if text.as_bytes()[found] == b'%' {
            let line = rest.lines().next().unwrap_or_default();
            out.main = out.main.take().or_else(|| root_said(line));
            at = found + 1 + line.len();
            continue;
        }
        let length = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        at = found + 1 + length.max(rest.chars().next().map_or(0, char::len_utf8));
        let behind = &rest[length..];
        let early = begins == text.len();
        match &rest[..length] {
            "begin" if early && behind.trim_start().starts_with("{document}") => {
                (begins, out.is_main) = (found, true);
            }
            "endinput" => {
                ends = found;
                break;
            }
            "end" if behind.trim_start().starts_with("{document}") => {
                ends = found;
                break;
            }
            command => include(command, behind, early, &mut out),
        }
    }
    out.preamble = Definitions::from_latex(&text[..begins.min(ends)]);
    out.body = Definitions::from_latex(&text[begins.min(ends)..ends]);
    out
}

/// The document that a comment such as `% !TEX root = ../main.tex` names.
fn root_said(comment: &str) -> Option<String> {
    let rest = comment.trim_start_matches('%').trim().strip_prefix('!')?.trim_start();
    let (program, rest) = (rest.get(..3)?, rest.get(3..)?);
    let (key, value) = rest.split_once('=')?;
    (program.eq_ignore_ascii_case("tex") && key.trim() == "root").then(|| value.trim().to_owned())
}

/// Notes the files that a command includes whose arguments follow.
fn include(command: &str, behind: &str, early: bool, out: &mut Contents) {
    let mut rest = behind;
    let mut add = |name: String| out.inclusions.push(Inclusion { name, early });
    match command {
        "input" | "include" | "subfile" | "InputIfFileExists" => {
            let named = argument(&mut rest, '{', '}');
            let bare = || behind.split(['\\', '%', '\n', ' ', '}']).find(|word| !word.is_empty()).unwrap_or_default();
            let name = named.unwrap_or_else(|| if behind.starts_with(' ') { bare() } else { "" });
            add(name.trim().trim_matches('"').to_owned());
        }
        "import" | "subimport" | "inputfrom" | "includefrom" | "subinputfrom" | "subincludefrom" => {
            if let (Some(folder), Some(name)) = (argument(&mut rest, '{', '}'), argument(&mut rest, '{', '}')) {
                add(format!("{}/{}", folder.trim().trim_end_matches('/'), name.trim()));
            }
        }
        "usepackage" | "RequirePackage" => {
            argument(&mut rest, '[', ']');
            let names = argument(&mut rest, '{', '}').unwrap_or_default().split(',').map(str::trim);
            names.filter(|name| !KNOWN.contains(name)).for_each(|name| add(format!("{name}.sty")));
        }
        "documentclass" | "LoadClass" => {
            let options = argument(&mut rest, '[', ']').unwrap_or_default();
            match argument(&mut rest, '{', '}').unwrap_or_default().trim() {
                "subfiles" => out.main = Some(options.trim().to_owned()),
                name => add(format!("{name}.cls")),
            }
        }
        _ => {}
    }
}

/// Takes the argument between two signs at the start of a text.
fn argument<'t>(rest: &mut &'t str, open: char, close: char) -> Option<&'t str> {
    let inner = rest.trim_start().strip_prefix(open)?;
    let end = inner.bytes().take(1000).position(|c| c == close as u8)?;
    *rest = &inner[end + 1..];
    inner.get(..end)
}
