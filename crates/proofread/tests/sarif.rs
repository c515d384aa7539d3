//! `--format sarif`: rules, levels, fingerprints, and edits that a reviewer can take over.

use crate::command::run;
use proofread::ChainVerdict;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// What is logged of a text in a file of this name.
fn logged(name: &str, text: &str, options: &[&str]) -> Value {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join(name);
    fs::write(&file, text).expect("written");
    logged_of(&file, options)
}

fn logged_of(file: &Path, options: &[&str]) -> Value {
    let (_, out, told) = run(&[&["--format", "sarif"], options, &[file.to_str().expect("UTF-8")]].concat());
    let whole: Value = serde_json::from_str(&out).unwrap_or_else(|why| panic!("{why}: {out}{told}"));
    assert_eq!(whole["version"], "2.1.0");
    whole["runs"][0].clone()
}

fn results(run: &Value) -> &[Value] {
    run["results"].as_array().expect("results")
}

/// The text with the edits of a result, whose regions count lines and characters from 1.
fn edited(text: &str, result: &Value) -> Option<String> {
    let [change] = result["fixes"][0]["artifactChanges"].as_array()?.as_slice() else { panic!("{result}") };
    assert_eq!(change["artifactLocation"], result["locations"][0]["physicalLocation"]["artifactLocation"]);
    let [edit] = change["replacements"].as_array()?.as_slice() else { panic!("{result}") };
    let at = |line: &str, column: &str| {
        let number = |name: &str| edit["deletedRegion"][name].as_u64().expect("a number") as usize;
        let start: usize = text.split_inclusive('\n').take(number(line) - 1).map(str::len).sum();
        let before = text[start..].char_indices().nth(number(column) - 1);
        start + before.map_or(text.len() - start, |(byte, _)| byte)
    };
    let (start, end) = (at("startLine", "startColumn"), at("endLine", "endColumn"));
    Some(format!("{}{}{}", &text[..start], edit["insertedContent"]["text"].as_str()?, &text[end..]))
}

#[test]
fn every_result_has_a_rule_with_help() {
    let text = "$43.4 - 29.8 = 13.8$, $2 + 2 = 5$, $2 + 2 = 4$, and t(28) = 2.20, p = .36. $2\\ \\mathrm{m} + 1\\ \\mathrm{m} = \
                3\\ \\mathrm{s}$\n";
    let run = logged("a.md", text, &["--agreeing", "--doubts", "--units", "--less-certain"]);
    let rules = run["tool"]["driver"]["rules"].as_array().expect("rules");
    assert_eq!(rules.len(), ChainVerdict::ALL.len());
    for rule in rules {
        let help = ["text", "markdown"].map(|form| rule["help"][form].as_str().expect("help"));
        assert!(help.iter().all(|help| help.contains("--baseline FILE leaves") || help.contains("`--baseline FILE`")));
        assert!(
            !help[0].contains('`') && help[0].starts_with(rule["fullDescription"]["text"].as_str().expect("words"))
        );
        // The package has no address yet.
        assert_eq!(rule.get("helpUri").is_some(), !env!("CARGO_PKG_REPOSITORY").is_empty());
    }
    assert!(results(&run).len() >= 5, "{run}");
    for result in results(&run) {
        assert!(rules.iter().any(|rule| rule["id"] == result["ruleId"]), "{result}");
        assert!(result["locations"][0]["physicalLocation"]["region"]["startLine"].is_number());
    }
}

#[test]
fn what_a_finding_weighs_is_told_by_its_list() {
    let level = |text: &str, options: &[&str]| {
        let run = logged("a.md", text, options);
        let of = |result: &Value| [&result["kind"], &result["level"]].map(|of| of.as_str().expect("a word").to_owned());
        results(&run).iter().map(of).collect::<Vec<_>>()
    };
    let fails = |level: &str| vec![["fail".to_owned(), level.to_owned()]];
    assert_eq!(level(r"$2.35 \cdot 4.12 - 1.5^2 = 8.53$", &[]), fails("error"));
    assert_eq!(level("$2 + 2 = 5$", &[]), fails("error"));
    assert_eq!(level("$2 + 2 = 5$, $43.25/2 = 38.17$", &[]), fails("warning"));
    assert_eq!(level("$|3| = 4$", &[]), [[""; 2]; 0]);
    assert_eq!(level("$|3| = 4$", &["--less-certain"]), fails("note"));
    assert_eq!(level("t(28) = 2.20, p = .36", &[]), fails("error"));
    assert_eq!(level("$43.4 - 29.8 = 13.8$", &[]), fails("warning"));
    assert_eq!(level("Let $a = 5.0$. Then $2a = 12.0$.", &["--bindings=always"]), fails("warning"));
    assert_eq!(level("5 times $3 = 16$", &["--doubts"]), fails("note"));
    assert_eq!(level("$2\\ \\mathrm{m} \\cdot 3\\ \\mathrm{m} = 6\\ \\mathrm{s}$", &["--units"]), fails("note"));
    assert_eq!(level("$2 + 2 = 4$", &["--agreeing"]), [["pass", "none"]]);
}

#[test]
fn an_edit_that_is_taken_over_mends_the_text() {
    let wrong = "Größe 😀: $\\tan 31.0^\\circ = 0.609$ and\r\nthen $1/4.000 = 0.750$.\n";
    let run = logged("a.md", wrong, &[]);
    let [first, second] = results(&run) else { panic!("{run}") };
    let mended = edited(wrong, second).expect("an edit");
    assert_eq!(mended, wrong.replace("0.750", "0.250"));
    let mended = edited(&mended, first).expect("an edit");
    assert_eq!(results(&logged("a.md", &mended, &[])), [] as [Value; 0]);
    // In a notebook the edit is of the file, not of the cell.
    let cell = json!({ "cells": [{ "cell_type": "markdown", "source": ["Ä\n", "$\\tan 31.0^\\circ = 0.609$"] }] });
    let notebook = cell.to_string();
    let run = logged("a.ipynb", &notebook, &[]);
    let mended = edited(&notebook, &results(&run)[0]).expect("an edit");
    assert_eq!(mended, notebook.replace("0.609", "0.601"));
}

#[test]
fn a_power_is_mended_as_it_is_written() {
    let text =
        "$\\frac{1000\\ \\mathrm{MeV}}{8.62\\times10^{11}\\ \\mathrm{MeV/K}} = 1.16\\times10^{13}\\ \\mathrm{K}$";
    let run = logged("a.md", text, &[]);
    let mended = edited(text, &results(&run)[0]).expect("an edit");
    assert_eq!(mended, text.replace("^{11}", "^{-11}"));
}

#[test]
fn an_edit_that_is_not_known_to_the_character_is_left_out() {
    for text in [
        // The hint is in words.
        "$3.0\\cdot 20 = -60.0$",
        "$2.40\\ \\mathrm{m/s^2}\\,(12.0\\ \\mathrm{s})^2 = 172.80\\ \\mathrm{m}$",
        // There is none.
        "$43.4 - 29.8 = 13.8$",
    ] {
        let run = logged("a.md", text, &[]);
        let [result] = results(&run) else { panic!("{run}") };
        assert!(result.get("fixes").is_none(), "{result}");
    }
}

#[test]
fn a_fingerprint_stays_when_lines_move_and_no_two_are_alike() {
    let prints = |text: &str| -> Vec<String> {
        let run = logged("a.md", text, &["--less-certain"]);
        let print = |result: &Value| result["partialFingerprints"]["chain/v1"].as_str().expect("a print").to_owned();
        results(&run).iter().map(print).collect()
    };
    let text = "$2 + 2 = 5$\n\n$x = 2 + 2 = 5$\n\n$3/3 + 3 = 7$\n";
    let first = prints(text);
    assert_eq!(first, prints(&format!("More.\n\n$1 + 1 = 2$\n\n{}", text.replace("3/3 + 3", " 3/3+3 "))));
    let mut apart = first.clone();
    apart.dedup();
    assert_eq!((first.len(), apart.len()), (3, 3), "{first:?}");
    assert_ne!(first[2], prints("$3/3 + 3 = 8$")[0]);
}

#[test]
fn places_of_one_shape_are_one_result_with_related_places() {
    let run = logged("a.md", "$2 + 2 = 5$\n\n$3 + 3 = 7$, $44 + 13 = 58$\n", &[]);
    let [result] = results(&run) else { panic!("{run}") };
    let related = result["relatedLocations"].as_array().expect("related places");
    let told: Vec<_> = related
        .iter()
        .map(|of| (&of["message"]["text"], &of["physicalLocation"]["region"]["startLine"]))
        .map(|(words, line)| (words.as_str().unwrap_or_default(), line.as_u64().unwrap_or_default()))
        .collect();
    assert_eq!(told, [("3 + 3 = 7. Printed 7, recomputed 6.", 3), ("44 + 13 = 58. Printed 58, recomputed 57.", 3)]);
}

#[test]
fn a_staged_file_that_is_gone_from_the_disk_keeps_its_address() {
    let folder = tempfile::tempdir().expect("a folder");
    let git = |arguments: &[&str]| crate::command::git(folder.path(), arguments);
    if !git(&["init", "-q"]) {
        println!("skipped: there is no git here");
        return;
    }
    fs::create_dir(folder.path().join("parts")).expect("made");
    let file = folder.path().join("parts/a.md");
    fs::write(&file, "$2 + 2 = 5$").expect("written");
    assert!(git(&["add", "--all"]));
    fs::remove_dir_all(folder.path().join("parts")).expect("removed");
    let run = logged_of(&file, &["--staged"]);
    assert_eq!(results(&run)[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], "parts/a.md");
}
