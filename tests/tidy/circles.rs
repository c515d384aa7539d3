//! Do the files of each crate import one way? Then they can be read in an order, each after those that it names.
//!
//! A file imports what its `use` declarations and its paths name that begin with `crate`, `self` or `super`. A name that a module
//! only passes on is imported from where it is declared. The root of a crate is in no circle, because it lists the others, and what
//! another module names of the modules right below it (`below::name`) is no import either. Comments and unit tests are free, and so
//! are methods: an `impl` may be in another file than its type.

use super::known::{Comparison, assert_known, lines};
use super::sources::{Source, end_of_brackets, is_of_a_name, places_of, sources, sources_of};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The circles that are known, one a line: the crate, and the files in the order of the alphabet. Lines are only taken away.
const KNOWN: &str = "tests/tidy/circles.txt";

/// How many lines of that kind there may be: lower it when a circle is gone.
const MOST_KNOWN: usize = 3;

/// What the files of a crate import from each other: the names, by the places of the two files in the list.
pub(super) type Imports = BTreeMap<(usize, usize), BTreeSet<String>>;

/// A path in code that leads somewhere in the crate.
struct CratePath {
    /// From the root of the crate: modules and a name.
    names: Vec<String>,
    /// The name that a `use` declaration gives it; empty for a path elsewhere.
    declared: String,
    /// Whether it begins with `crate`, `self` or `super`, and not with a module right below its own.
    is_import: bool,
}

/// The paths of a tree of imports with the names that they get: `a::b` as `b` and `a::c` as `d` of `a::{b, c as d}`.
fn paths_of_tree(tree: &str) -> Vec<(String, String)> {
    let Some((stem, branches)) = tree.split_once('{') else {
        let (path, alias) = tree.split_once(" as ").unwrap_or((tree, ""));
        let last = path.trim().rsplit("::").next().unwrap_or_default();
        let name = if alias.is_empty() { last } else { alias };
        return vec![(path.trim().to_owned(), name.trim().to_owned())];
    };
    let branches = branches.trim_end().strip_suffix('}').unwrap_or(branches);
    let mut depth = 0;
    let is_comma = |c: char| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    };
    let branches = branches.split(is_comma).filter(|branch| !branch.trim().is_empty());
    branches.flat_map(paths_of_tree).map(|(path, name)| (format!("{}{path}", stem.trim()), name)).collect()
}

/// The modules inside a file that have no file of their own: what is between their brackets, and their names.
fn modules_inside(code: &str) -> Vec<(Range<usize>, String)> {
    let module = |place: Range<usize>| {
        let (name, _) = code[place.end..].split_once('{')?;
        let is_name = name.starts_with(' ') && name.trim().chars().all(is_of_a_name);
        is_name.then(|| (place.start..end_of_brackets(code, place.end + name.len()), name.trim().to_owned()))
    };
    places_of(code, "mod").filter_map(module).collect()
}

/// A path from the root of the crate, and whether it begins with `crate`, `self` or `super`. Else it must begin with a module
/// right below its own.
fn from_the_root(path: &str, module: &[String], modules: &BTreeSet<&[String]>) -> Option<(Vec<String>, bool)> {
    let mut names = path.split("::").map(str::trim).peekable();
    let is_start = |name: &&str| ["crate", "self", "super"].contains(name);
    let is_import = names.peek().is_some_and(is_start);
    let mut from_root = module.to_vec();
    while let Some(start) = names.next_if(is_start) {
        match start {
            "crate" => from_root.clear(),
            "super" => drop(from_root.pop()),
            _ => {}
        }
    }
    from_root.extend(names.filter(|name| *name != "self").map(str::to_owned));
    (is_import || modules.contains(&from_root[..module.len() + 1])).then_some((from_root, is_import))
}

/// The paths in a file that lead somewhere in its crate.
fn crate_paths(file: &Source, modules: &BTreeSet<&[String]>) -> Vec<CratePath> {
    let code = &file.code;
    let inside = modules_inside(code);
    let mut found = Vec::new();
    let mut add = |place: usize, path: &str, declared: String| {
        let mut module = file.module.clone();
        module.extend(inside.iter().filter(|(range, _)| range.contains(&place)).map(|(_, name)| name.clone()));
        let from_root = from_the_root(path, &module, modules);
        found.extend(from_root.map(|(names, is_import)| CratePath { names, declared, is_import }));
    };
    let mut declarations: Vec<Range<usize>> = Vec::new();
    for place in places_of(code, "use").filter(|place| code[place.end..].starts_with(char::is_whitespace)) {
        let end = code[place.end..].find(';').map_or(code.len(), |end| place.end + end);
        let tree = code[place.end..end].split_whitespace().collect::<Vec<_>>().join(" ");
        for (path, name) in paths_of_tree(&tree) {
            add(place.start, &path, name);
        }
        declarations.push(place.start..end);
    }
    for start in ["crate", "self", "super"] {
        for place in places_of(code, start) {
            let path = code[place.start..].split(|c| !is_of_a_name(c) && c != ':').next().unwrap_or_default();
            let before = code[..place.start].trim_end();
            let is_other = before.ends_with("::") || before.ends_with("(in");
            if !is_other && path.contains("::") && !declarations.iter().any(|other| other.contains(&place.start)) {
                add(place.start, path.trim_end_matches(':'), String::new());
            }
        }
    }
    found
}

/// What the files of a crate import from each other.
pub(super) fn imports(files: &[&Source]) -> Imports {
    let places: BTreeMap<&[String], usize> =
        files.iter().enumerate().map(|(place, file)| (file.module.as_slice(), place)).collect();
    let modules = places.keys().copied().filter(|module| !module.is_empty()).collect();
    let paths: Vec<Vec<CratePath>> = files.iter().map(|file| crate_paths(file, &modules)).collect();
    // The file in which a path ends, and the rest of the path.
    let target = |names: &[String]| {
        let length = (0..=names.len()).rev().find(|length| places.contains_key(&names[..*length]))?;
        Some((*places.get(&names[..length])?, names[length..].to_vec()))
    };
    let mut imports = Imports::new();
    for (place, of_file) in paths.iter().enumerate() {
        for path in of_file.iter().filter(|path| path.is_import) {
            let mut end = target(&path.names);
            // Through what passes the name on, as often as it is passed on.
            for _ in 0..files.len() {
                let Some((through, rest)) = end.as_ref().filter(|(through, _)| *through != place) else { break };
                let Some((name, rest)) = rest.split_first() else { break };
                let Some(onward) = paths[*through].iter().find(|path| path.declared == *name) else { break };
                end = target(&[onward.names.as_slice(), rest].concat());
            }
            let Some((other, rest)) = end.filter(|(other, _)| *other != place && !files[*other].module.is_empty())
            else {
                continue;
            };
            let name = rest.first().map_or_else(|| "the module".to_owned(), String::clone);
            imports.entry((place, other)).or_default().insert(name);
        }
    }
    imports
}

/// The circles among so many files: those of which each reaches each other one, in their order.
fn circles(count: usize, imports: &Imports) -> Vec<Vec<usize>> {
    let reached = |from: usize| {
        let mut reached = BTreeSet::new();
        let mut waiting = vec![from];
        while let Some(place) = waiting.pop() {
            let next = imports.keys().filter(|(importer, _)| *importer == place).map(|(_, imported)| *imported);
            waiting.extend(next.filter(|imported| reached.insert(*imported)));
        }
        reached
    };
    let reached: Vec<BTreeSet<usize>> = (0..count).map(reached).collect();
    let circle = |place: usize| -> Vec<usize> {
        (0..count).filter(|other| reached[place].contains(other) && reached[*other].contains(&place)).collect()
    };
    (0..count)
        .map(circle)
        .enumerate()
        .filter(|(place, circle)| circle.first() == Some(place))
        .map(|(_, circle)| circle)
        .collect()
}

/// The circles of crates, each as a line of the list with the imports that make it.
fn lines_of_circles(sources: &[Source]) -> BTreeMap<String, String> {
    let mut lines = BTreeMap::new();
    for files in sources.chunk_by(|a, b| a.package == b.package) {
        let files: Vec<&Source> = files.iter().collect();
        let imports = imports(&files);
        for circle in circles(files.len(), &imports) {
            let names: Vec<&str> = circle.iter().map(|place| files[*place].file.as_str()).collect();
            let inner = imports.iter().filter(|((from, to), _)| circle.contains(from) && circle.contains(to));
            let arrows = inner.map(|((from, to), names)| {
                let names = names.iter().map(String::as_str).collect::<Vec<_>>().join(", ");
                format!("\n    {} imports from {}: {names}", files[*from].file, files[*to].file)
            });
            lines.insert(format!("{}: {}", files[0].package, names.join(" ")), arrows.collect());
        }
    }
    lines
}

/// What the list of known circles becomes, by the circles in the code.
fn comparison(known: &[String], found: &BTreeMap<String, String>) -> Comparison {
    let names = |line: &str| line.split(' ').map(str::to_owned).collect::<BTreeSet<_>>();
    let is_known = |line: &str| known.iter().any(|other| names(other).is_superset(&names(line)));
    let (left, new): (Vec<_>, Vec<_>) = found.iter().partition(|(line, _)| is_known(line));
    let complaint = |(line, arrows): (&String, &String)| {
        format!(
            "a new circle; move what both sides need into a file that imports neither:{arrows}\n\
             (If only a file or the crate has another name, its line is\n  {line})"
        )
    };
    let left = left.into_iter().map(|(line, _)| line.clone()).collect();
    Comparison { left, complaints: new.into_iter().map(complaint).collect() }
}

#[test]
fn the_files_of_a_crate_import_one_way() {
    let known = lines(KNOWN);
    assert!(known.len() <= MOST_KNOWN, "{KNOWN} only gets shorter");
    assert_known(KNOWN, &known, comparison(&known, &lines_of_circles(sources())));
}

/// The circles of a made-up crate with these files.
#[cfg(test)]
fn made_up(files: &[(&str, &str)]) -> Vec<String> {
    let texts = files.iter().map(|(file, text)| ((*file).to_owned(), (*text).to_owned()));
    lines_of_circles(&sources_of("made_up", texts)).into_keys().collect()
}

#[test]
fn a_circle_is_found_however_a_file_is_named() {
    let root = ("lib.rs", "mod a; mod b; pub use b::{Bar as Renamed, inner};");
    let found = |a: &str, b: &str| made_up(&[("a.rs", a), ("b/inner.rs", ""), ("b/mod.rs", b), root]);
    let circle = ["made_up: a.rs b/mod.rs"];
    for a in [
        "use crate::b::Bar;",
        "use crate::{b::{self, Baz}};",
        "use super::b::*;",
        "fn f() -> crate::b::Bar {}",
        "use crate::Renamed as Bar;",
        "mod within { use super::super::b::Bar; }",
    ] {
        assert_eq!(found(a, "use crate::a::Foo;"), circle, "{a}");
    }
    for a in [
        "use std::fmt;",
        "// use crate::b::Bar;",
        "const B: &str = \"crate::b::Bar\";",
        "#[cfg(test)]\nmod tests {\n    use crate::b::Bar;\n}",
        "use crate::inner::Bar;",
        "use crate::c::Bar;",
        "pub(in crate::b) fn f() {}",
        "mod within { use super::b::Bar; }",
    ] {
        assert!(found(a, "use crate::a::Foo;").is_empty(), "{a}");
    }
    let three = [
        ("a.rs", "use crate::b::B;"),
        ("b.rs", "use crate::c::C;"),
        ("c.rs", "use crate::a::A;"),
        ("d.rs", "use crate::a::A;"),
    ];
    assert_eq!(made_up(&three), ["made_up: a.rs b.rs c.rs"]);
}

#[test]
fn the_list_of_circles_only_shrinks() {
    let compared = |known: &str, found: &str| {
        let found = found.lines().map(|line| (line.to_owned(), String::new())).collect();
        let known: Vec<String> = known.lines().map(str::to_owned).collect();
        let Comparison { left, complaints } = comparison(&known, &found);
        (left.join("\n"), complaints.len())
    };
    let left = |lines: &str| (lines.to_owned(), 0);
    assert_eq!(compared("x: a.rs b.rs", "x: a.rs b.rs"), left("x: a.rs b.rs"));
    assert_eq!(compared("x: a.rs b.rs\ny: a.rs b.rs", "y: a.rs b.rs"), left("y: a.rs b.rs"));
    assert_eq!(compared("x: a.rs b.rs c.rs d.rs", "x: a.rs b.rs\nx: c.rs d.rs"), left("x: a.rs b.rs\nx: c.rs d.rs"));
    assert_eq!(compared("", "x: a.rs b.rs"), (String::new(), 1));
    assert_eq!(compared("y: a.rs b.rs", "x: a.rs b.rs"), (String::new(), 1));
    assert_eq!(compared("x: a.rs b.rs", "x: a.rs b.rs c.rs"), (String::new(), 1));
}
