//! LaTeX files of one document: which definitions a file is read with when the command finds the others.

use crate::command::{git, run};
use std::fs;
use std::path::Path;

/// A folder with files, each a name and a text.
fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    // What is above it is none of it.
    fs::create_dir(folder.path().join(".git")).expect("a folder");
    for (name, text) in files {
        write(folder.path(), name, text);
    }
    folder
}

fn write(folder: &Path, name: &str, text: &str) {
    let file = folder.join(name);
    fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
    fs::write(file, text).expect("written");
}

/// The places of what is found, when the command is given some of the files.
fn found(folder: &Path, given: &[&str]) -> Vec<String> {
    let given: Vec<String> = given.iter().map(|name| folder.join(name).to_string_lossy().into_owned()).collect();
    let (code, out, told) = run(&given.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!(told, "");
    let start = format!(" --> {}/", folder.to_string_lossy());
    let places: Vec<String> = out.lines().filter_map(|line| line.strip_prefix(&start)).map(str::to_owned).collect();
    assert_eq!(code, u8::from(!places.is_empty()));
    places
}

/// A false equation for who knows the macro, and a hint that is not printed.
const CHAPTER: &str = "It is $3\\half = 1.6$. \\hint{$1 + 1 = 3$}\n";
const MACROS: &str = "\\newcommand{\\half}{\\frac{1}{2}}\n\\newcommand{\\hint}[1]{}\n";
const HALF: &str = "ch/one.tex:1:17";
const HINT: &str = "ch/one.tex:1:38";

#[track_caller]
fn known(files: &[(&str, &str)]) {
    let folder = folder(&[files, &[("ch/one.tex", CHAPTER)]].concat());
    for given in [&["."][..], &["ch"], &["ch/one.tex"]] {
        let found: Vec<String> =
            found(folder.path(), given).into_iter().map(|place| place.trim_start_matches("./").to_owned()).collect();
        assert_eq!(found, [HALF], "{given:?}");
    }
}

#[track_caller]
fn unknown(files: &[(&str, &str)]) {
    let folder = folder(&[files, &[("ch/one.tex", CHAPTER)]].concat());
    assert_eq!(found(folder.path(), &["ch"]), [HINT]);
}

#[test]
fn the_main_file_defines_for_its_chapters() {
    known(&[("main.tex", &format!("{MACROS}\\begin{{document}}\\include{{ch/one}}\\end{{document}}"))]);
    known(&[("main.tex", &format!("{MACROS}\\begin{{document}}\\input ch/one.tex\n\\end{{document}}"))]);
    known(&[("main.tex", &format!("{MACROS}\\begin{{document}}\\subimport{{ch/}}{{one}}\\end{{document}}"))]);
    unknown(&[("main.tex", &format!("{MACROS}\\begin{{document}}%\\include{{ch/one}}\n\\end{{document}}"))]);
    unknown(&[("main.tex", &format!("{MACROS}\\begin{{document}}\\include{{ch/two}}\\end{{document}}"))]);
    unknown(&[("main.tex", &format!("%{}\\begin{{document}}\\input{{ch/one}}", MACROS.replace('\n', "\n%")))]);
}

#[test]
fn so_do_the_files_classes_and_packages_that_it_includes() {
    let main = |way: &str| format!("{way}\n\\begin{{document}}\\input{{ch/one}}\\end{{document}}");
    for (way, file) in [
        ("\\documentclass[12pt]{course}", "course.cls"),
        ("\\usepackage{amsmath, mine}", "mine.sty"),
        ("\\RequirePackage[a]{style/mine}", "style/mine.sty"),
        ("\\input{macros}", "macros.tex"),
        ("\\input{style/macros.tex}", "style/macros.tex"),
    ] {
        known(&[("main.tex", &main(way)), (file, MACROS)]);
    }
    // One by way of another.
    known(&[("main.tex", &main("\\input{style/all}")), ("style/all.tex", "\\input{more}"), ("style/more.tex", MACROS)]);
    // The reader knows siunitx better than a copy of it.
    unknown(&[("main.tex", &main("\\usepackage{siunitx}")), ("siunitx.sty", MACROS)]);
    unknown(&[("main.tex", &main("\\usepackage{missing}\\input{missing}"))]);
}

#[test]
fn a_chapter_names_its_main_file() {
    let start = |line: &str| format!("{line}\n{CHAPTER}");
    let of = |line: &str, name: &str| {
        let folder = folder(&[("ch/one.tex", &start(line)), (name, MACROS)]);
        found(folder.path(), &["ch/one.tex"])
    };
    assert_eq!(of("% !TEX root = ../book/main.tex", "book/main.tex"), ["ch/one.tex:2:17"]);
    assert_eq!(of("%!TeX root=../book/main", "book/main.tex"), ["ch/one.tex:2:17"]);
    assert_eq!(of("\\documentclass[../book/main]{subfiles}", "book/main.tex"), ["ch/one.tex:2:17"]);
    assert_eq!(of("\\input{../book/main}", "book/main.tex"), ["ch/one.tex:2:17"]);
    // What it includes itself counts, too.
    let own = format!("% !TEX root = ../main.tex\n\\input{{macros}}{CHAPTER}");
    let folder = folder(&[("ch/one.tex", &own), ("ch/macros.tex", MACROS), ("main.tex", "Alone.")]);
    assert_eq!(found(folder.path(), &["ch/one.tex"]), ["ch/one.tex:2:31"]);
    assert_eq!(of("% !TEX program = ../book/main.tex", "book/main.tex"), ["ch/one.tex:2:38"]);
}

#[test]
fn what_is_outside_huge_circular_or_no_file_is_left_out() {
    let outside = tempfile::tempdir().expect("a folder");
    write(outside.path(), "macros.tex", MACROS);
    let name = outside.path().file_name().and_then(|name| name.to_str()).expect("UTF-8");
    let main = |inputs: &str| format!("{inputs}\\begin{{document}}\\input{{ch/one}}\\end{{document}}");
    unknown(&[("main.tex", &main(&format!("\\input{{../{name}/macros}}")))]);
    unknown(&[("main.tex", &main(&format!("\\input{{{}}}", outside.path().join("macros.tex").display())))]);
    unknown(&[("main.tex", &main("\\input{}\\input{.}\\input{ch}\\usepackage{}\\input"))]);
    let huge = format!("{MACROS}{}", " ".repeat(9 << 20));
    unknown(&[("main.tex", &main("\\input{macros}")), ("macros.tex", &huge)]);
    known(&[
        ("main.tex", &main("\\input{a}")),
        ("a.tex", "\\input{b}\\input{a}"),
        ("b.tex", &format!("\\input{{a}}\\input{{main}}{MACROS}")),
    ]);
}

#[test]
fn whatever_stands_in_the_other_files_the_document_is_read() {
    for text in [
        "\\input",
        "\\input ",
        "\\input é%",
        "\\é\\input{é",
        "%",
        "\\",
        "\\usepackage[é{x}",
        "\\usepackage{é,,é}",
        "\\import{}{}",
        "% !TEX root =",
        "% !é",
        "\\documentclass[é]{subfiles}",
        "\\end{document}\\begin{document}",
        "\\newcommand{\\é}{\\é",
        "\\DeclareSIUnit",
        "\\def\\a#é{}",
        "\0\0\0",
        "\\endinput\\begin{document}",
    ] {
        let main = format!("\\input{{odd}}\\begin{{document}}\\input{{ch/one}}{text}");
        let folder = folder(&[
            ("ch/one.tex", &format!("{CHAPTER}{}", text.trim_matches('\0'))),
            ("main.tex", &main),
            ("odd.tex", text),
        ]);
        assert!(found(folder.path(), &["ch/one.tex"]).contains(&HINT.to_owned()), "{text}");
    }
}

#[test]
fn a_name_with_two_meanings_in_two_documents_has_none() {
    let main = |hint: &str| {
        format!("\\newcommand{{\\half}}{{\\frac12}}{hint}\\begin{{document}}\\input{{ch/one}}\\end{{document}}")
    };
    let (shown, hidden) = ("\\newcommand{\\hint}[1]{#1}", "\\newcommand{\\hint}[1]{}");
    let folder = folder(&[("ch/one.tex", CHAPTER), ("a.tex", &main(hidden)), ("b.tex", &main(shown))]);
    assert_eq!(found(folder.path(), &["ch/one.tex"]), [HALF, HINT]);
    write(folder.path(), "b.tex", &main(hidden));
    assert_eq!(found(folder.path(), &["ch/one.tex"]), [HALF]);
}

#[test]
fn the_last_definition_of_the_preamble_counts_and_one_in_another_chapter_does_not_change_it_silently() {
    let main =
        "\\input{macros}\\renewcommand{\\half}{0.5}\\begin{document}\\input{ch/one}\\input{ch/two}\\end{document}";
    let macros = format!("{MACROS}\\renewcommand{{\\half}}{{7}}");
    let folder = folder(&[("ch/one.tex", "$3 + \\half = 3.6$"), ("main.tex", main), ("macros.tex", &macros)]);
    assert_eq!(found(folder.path(), &["ch"]), ["ch/one.tex:1:14"]);
    write(folder.path(), "ch/two.tex", "\\renewcommand{\\half}{0.6}\n$3 + \\half = 3.5$");
    assert_eq!(found(folder.path(), &["ch"]), ["ch/two.tex:2:14"]);
}

#[test]
fn each_finding_is_listed_once_and_files_of_style_are_no_documents() {
    let wrong = "$1 + 1 = 3$";
    let main = format!("\\usepackage{{mine}}\\begin{{document}}\\input{{ch/one}}\n{wrong}\n\\end{{document}}");
    let folder = folder(&[("ch/one.tex", CHAPTER), ("main.tex", &main), ("mine.sty", &format!("{MACROS}{wrong}"))]);
    let places = found(folder.path(), &["main.tex", "ch/one.tex"]);
    assert_eq!(places, ["main.tex:2:10", HALF]);
    assert_eq!(found(folder.path(), &["ch/one.tex", "main.tex"]).len(), 2);
}

#[test]
fn changes_and_accepted_cases_are_told_with_the_definitions_of_other_files() {
    let main = format!("{MACROS}\\begin{{document}}\\input{{ch/one}}\\end{{document}}");
    let folder = folder(&[("ch/one.tex", CHAPTER), ("main.tex", &main)]);
    let name = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let (chapters, cases) = (name("ch"), name("cases.jsonl"));
    assert_eq!(run(&["--accept", &cases, &chapters]).0, 0);
    assert_eq!(run(&["--baseline", &cases, &chapters]).0, 0);
    let new = format!("{CHAPTER}\nNew: $5\\half = 2.6$.\n");
    if git(folder.path(), &["init", "-q"]) {
        assert!(git(folder.path(), &["add", "."]) && git(folder.path(), &["commit", "-q", "-m", "first"]));
        assert_eq!(run(&["--since", "HEAD", &chapters]).0, 0);
        write(folder.path(), "ch/one.tex", &new);
        let (code, out, _) = run(&["--since", "HEAD", &chapters]);
        assert!(code == 1 && out.contains("1 finding:") && out.contains("recomputed 2.5"), "{out}");
    }
    write(folder.path(), "ch/one.tex", &new);
    let (code, out, _) = run(&["--baseline", &cases, &chapters]);
    assert!(code == 1 && out.contains("1 finding:") && out.contains("1 case left out"), "{out}");
}

#[test]
fn lines_of_json_share_nothing() {
    let line = |id: &str, text: &str| serde_json::json!({ "id": id, "format": "latex", "text": text }).to_string();
    let lines = [line("macros.tex", MACROS), line("one.tex", &format!("\\input{{macros}}{CHAPTER}"))].join("\n");
    let folder = folder(&[("all.jsonl", &lines), ("macros.tex", MACROS)]);
    let file = folder.path().join("all.jsonl");
    let (_, out, _) = run(&["--format", "jsonl", file.to_str().expect("UTF-8")]);
    assert!(out.contains(r#""left":"1 + 1""#) && !out.contains("1.6"), "{out}");
}

#[test]
fn many_chapters_with_one_file_of_macros_are_read_in_a_moment() {
    let macros: String = (0..2000u32)
        .map(|n| {
            let name: String = n.to_string().bytes().map(|digit| char::from(digit - b'0' + b'a')).collect();
            format!("\\newcommand{{\\half{name}}}{{\\frac12}}\n")
        })
        .collect();
    let folder = folder(&[("macros.tex", &macros)]);
    for n in 0..300 {
        write(folder.path(), &format!("ch{n}.tex"), "\\input{macros} $3\\halfbcd = 1.5$");
    }
    // Minutes if each chapter reads the macros anew.
    let (code, out, _) = run(&[folder.path().to_str().expect("UTF-8")]);
    assert!(code == 0 && out.contains("Checked 300 chains"), "{out}");
}

#[test]
fn the_macros_of_a_book_in_pretext_hold_in_its_files() {
    const CHAPTER: &str = "<chapter><p><m>2 + 3 = \\val{6}</m>, <m>3\\half = 1.5</m></p></chapter>\n";
    const MACROS: &str =
        "<docinfo><macros>\\newcommand{\\val}[1]{#1}\n\\newcommand{\\half}{\\frac{1}{2}}</macros></docinfo>";
    const CHAPTER_INCLUDED: &str = "<xi:include href=\"ch/one.ptx\"/>";
    let main = format!("<pretext>{MACROS}<book>{CHAPTER_INCLUDED}</book></pretext>");
    let apart = format!("<pretext><xi:include href='docinfo.ptx' /><book>{CHAPTER_INCLUDED}</book></pretext>");
    let deep = format!("<pretext>{MACROS}<book><xi:include href=\"ch/all.ptx\"/></book></pretext>");
    for files in [
        &[("main.ptx", main.as_str())][..],
        &[("main.ptx", apart.as_str()), ("docinfo.ptx", MACROS)],
        &[("main.xml", deep.as_str()), ("ch/all.ptx", "<part><xi:include href=\"one.ptx\"/></part>")],
    ] {
        let folder = folder(&[files, &[("ch/one.ptx", CHAPTER)]].concat());
        for given in [&["."][..], &["ch"], &["ch/one.ptx"]] {
            let found = found(folder.path(), given);
            let [place] = found.as_slice() else { panic!("{files:?}, {given:?}: {found:?}") };
            assert!(place.ends_with("ch/one.ptx:1:29"), "{place}");
        }
    }
    // A book that doesn't include the file says nothing of it.
    let folder = folder(&[("main.ptx", &main.replace("one", "two")), ("ch/one.ptx", CHAPTER)]);
    assert_eq!(found(folder.path(), &["ch"]), [""; 0]);
}

#[test]
fn files_that_are_read_for_their_macros_alone_are_told() {
    let body = "\\input{macros}\n\\begin{document}\n\\include{ch/one}\n\\input{ch/two}\n\\end{document}\n";
    let two = "So $1 + 1 = 2$. \\input{ch/none} \\input{ch/words}\n";
    let folder = folder(&[
        ("main.tex", body),
        ("macros.tex", &format!("{MACROS} % = 1\n")),
        ("ch/one.tex", CHAPTER),
        ("ch/two.tex", two),
        ("ch/words.tex", "Words alone.\n"),
    ]);
    let at = |name: &str| folder.path().join(name).to_string_lossy().into_owned();
    let summary = |names: &[&str]| {
        let files: Vec<String> = names.iter().map(|name| at(name)).collect();
        run(&files.iter().map(String::as_str).collect::<Vec<_>>()).1
    };
    let main = at("main.tex");
    let told =
        format!("{main} includes 2 files that were only read for their macros; give them, or the folder, to check");
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words(&summary(&["main.tex"])).contains(&told), "{}", summary(&["main.tex"]));
    let one = summary(&["main.tex", "ch/one.tex"]);
    assert!(
        words(&one).contains("includes 1 file that was only read for its macros; give it, or the folder, to"),
        "{one}"
    );
    for given in [&["main.tex", "ch/one.tex", "ch/two.tex"][..], &["."], &["ch/one.tex"]] {
        assert!(!summary(given).contains("only read for"), "{given:?}");
    }
    let sum: serde_json::Value = serde_json::from_str(&run(&["--format", "json", &main]).1).expect("JSON");
    assert_eq!(sum["sum"]["only_macros"], serde_json::json!([{ "file": main, "count": 2 }]));
}

#[test]
fn styles_of_a_folder_above_define_for_what_no_document_includes() {
    known(&[("book.sty", MACROS)]);
    known(&[("book.cls", MACROS), ("main.tex", "\\begin{document}Nothing.\\end{document}")]);
    // Two styles that say different things say nothing.
    unknown(&[("book.sty", "\\newcommand{\\half}{\\frac{1}{2}}"), ("other.sty", "\\newcommand{\\half}{\\frac{1}{3}}")]);
    // What a document includes has that document's macros alone.
    unknown(&[("book.sty", MACROS), ("main.tex", "\\begin{document}\\include{ch/one}\\end{document}")]);
}
