//! Do the packages that the project uses have licences that it allows, and do they come from where they should?
//!
//! `deny.toml` says what is allowed, in the words of `cargo deny`, which needs a database and the network for the rest.

use serde_json::Value as Json;
use std::collections::BTreeSet;
use std::process::Command;
use toml::{Table, Value};

/// A package that is built on this machine.
struct Package {
    name: String,
    licence: String,
    source: Option<String>,
}

/// All packages of the workspace on this machine, by Cargo itself and without the network.
fn packages() -> Vec<Package> {
    let told = |program: &str, arguments: &[&str]| {
        let output = Command::new(program).args(arguments).current_dir(crate::path(".")).output().expect("it runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).expect("UTF-8")
    };
    let version = told("rustc", &["-vV"]);
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).expect("a machine");
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    let options = ["metadata", "--offline", "--locked", "--format-version", "1", "--filter-platform", host];
    let metadata: Json = serde_json::from_str(&told(&cargo, &options)).expect("JSON");
    let text = |package: &Json, key: &str| package[key].as_str().map(str::to_owned);
    let package = |package: &Json| Package {
        name: text(package, "name").expect("a name"),
        licence: text(package, "license").unwrap_or_else(|| panic!("{} names no licence", package["name"])),
        source: text(package, "source"),
    };
    metadata["packages"].as_array().expect("a list").iter().map(package).collect()
}

fn deny() -> Table {
    std::fs::read_to_string(crate::path("deny.toml")).expect("the rules").parse().expect("TOML")
}

/// The words of a list.
fn words(list: &Value) -> Vec<String> {
    list.as_array().expect("a list").iter().map(|word| word.as_str().expect("text").to_owned()).collect()
}

/// Licences for any package, and those for one package each.
fn licences() -> (BTreeSet<String>, Vec<(String, BTreeSet<String>)>) {
    let rules = deny();
    let exception = |of: &Value| {
        (of["crate"].as_str().expect("a package").to_owned(), words(&of["allow"]).into_iter().collect::<BTreeSet<_>>())
    };
    let exceptions = rules["licenses"]["exceptions"].as_array().expect("a list").iter().map(exception).collect();
    (words(&rules["licenses"]["allow"]).into_iter().collect(), exceptions)
}

/// Whether an SPDX expression holds if these licences are allowed. A slash is the OR of old packages; WITH makes one licence
/// of two words.
fn holds(expression: &str, allowed: &BTreeSet<String>) -> bool {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ");
    let tokens: Vec<&str> = spaced.split_whitespace().collect();
    let mut at = 0;
    let held = either(&tokens, &mut at, allowed);
    assert_eq!(at, tokens.len(), "no licence expression: {expression}");
    held
}

fn either(tokens: &[&str], at: &mut usize, allowed: &BTreeSet<String>) -> bool {
    let mut held = both(tokens, at, allowed);
    while tokens.get(*at) == Some(&"OR") {
        *at += 1;
        held |= both(tokens, at, allowed);
    }
    held
}

fn both(tokens: &[&str], at: &mut usize, allowed: &BTreeSet<String>) -> bool {
    let mut held = one(tokens, at, allowed);
    while tokens.get(*at) == Some(&"AND") {
        *at += 1;
        held &= one(tokens, at, allowed);
    }
    held
}

fn one(tokens: &[&str], at: &mut usize, allowed: &BTreeSet<String>) -> bool {
    let first = *tokens.get(*at).expect("a licence");
    *at += 1;
    if first == "(" {
        let held = either(tokens, at, allowed);
        assert_eq!(tokens.get(*at), Some(&")"), "a closing parenthesis");
        *at += 1;
        return held;
    }
    if tokens.get(*at) == Some(&"WITH") {
        let exception = tokens.get(*at + 1).expect("an exception");
        *at += 2;
        return allowed.contains(&format!("{first} WITH {exception}"));
    }
    allowed.contains(first)
}

/// What is wrong with some packages under some rules.
fn faults(packages: &[Package], allow: &BTreeSet<String>, exceptions: &[(String, BTreeSet<String>)]) -> Vec<String> {
    let for_package = |name: &str, without: Option<&str>| -> BTreeSet<String> {
        let own = exceptions.iter().filter(|(of, _)| of == name).flat_map(|(_, licences)| licences.clone());
        allow.iter().cloned().chain(own).filter(|licence| Some(licence.as_str()) != without).collect()
    };
    let is_allowed =
        |package: &Package, without: Option<&str>| holds(&package.licence, &for_package(&package.name, without));
    let mut found = Vec::new();
    for package in packages.iter().filter(|package| !is_allowed(package, None)) {
        found.push(format!("{} is under {}, which deny.toml does not allow", package.name, package.licence));
    }
    // A rule that nothing needs allows what nobody has looked at.
    for licence in
        allow.iter().filter(|licence| packages.iter().all(|package| is_allowed(package, Some(licence.as_str()))))
    {
        found.push(format!("nothing needs {licence}: take it out of deny.toml"));
    }
    for (name, licences) in exceptions {
        let own: Vec<_> = packages.iter().filter(|package| package.name == *name).collect();
        let is_needed = |licence: &String| own.iter().any(|package| !is_allowed(package, Some(licence.as_str())));
        for licence in licences.iter().filter(|licence| !is_needed(licence)) {
            found.push(format!("{name} does not need {licence}: take it out of deny.toml"));
        }
    }
    found
}

#[test]
fn every_licence_is_allowed_and_every_rule_is_needed() {
    let (allow, exceptions) = licences();
    let found = faults(&packages(), &allow, &exceptions);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn a_licence_that_is_not_listed_and_a_rule_that_is_not_needed_are_seen() {
    let package =
        |name: &str, licence: &str| Package { name: name.to_owned(), licence: licence.to_owned(), source: None };
    let set = |all: &[&str]| all.iter().map(|licence| (*licence).to_owned()).collect::<BTreeSet<_>>();
    let usual = [package("a", "MIT OR Apache-2.0"), package("b", "MIT"), package("c", "ISC")];
    let isc = [("c".to_owned(), set(&["ISC"]))];
    assert_eq!(faults(&usual, &set(&["MIT"]), &isc), [""; 0]);
    for (packages, allow, exceptions, words) in [
        (&usual[..], &["MIT"][..], &[][..], "c is under ISC"),
        (&usual[..2], &["MIT"], &isc[..], "c does not need ISC"),
        (&usual, &["MIT", "Apache-2.0"], &isc, "nothing needs Apache-2.0"),
        (&[package("a", "MIT"), package("d", "GPL-3.0-only")], &["MIT"], &[], "d is under GPL-3.0-only"),
    ] {
        let found = faults(packages, &set(allow), exceptions);
        assert!(found.len() == 1 && found[0].starts_with(words), "{found:?}");
    }
}

#[test]
fn licence_expressions_are_read_as_they_are_meant() {
    let allowed = BTreeSet::from(["MIT".to_owned(), "Apache-2.0 WITH LLVM-exception".to_owned()]);
    for (expression, expected) in [
        ("MIT", true),
        ("Apache-2.0", false),
        ("Apache-2.0/MIT", true),
        ("Unlicense OR MIT", true),
        ("MIT AND ISC", false),
        ("(MIT OR Apache-2.0) AND MIT", true),
        ("(ISC OR Apache-2.0) AND MIT", false),
        ("ISC AND MIT OR MIT", true),
        ("Apache-2.0 WITH LLVM-exception", true),
        ("Apache-2.0 WITH LLVM-exception AND ISC", false),
    ] {
        assert_eq!(holds(expression, &allowed), expected, "{expression}");
    }
}

#[test]
fn packages_are_from_one_registry() {
    let rules = deny();
    let sources = &rules["sources"];
    assert_eq!(words(&sources["allow-git"]), [""; 0]);
    let allowed: Vec<_> =
        words(&sources["allow-registry"]).into_iter().map(|registry| format!("registry+{registry}")).collect();
    // Also those of other machines.
    let lock: Table = std::fs::read_to_string(crate::path("Cargo.lock")).expect("it is there").parse().expect("TOML");
    let mut locked = BTreeSet::new();
    for package in lock["package"].as_array().expect("a list") {
        let name = package["name"].as_str().expect("a name");
        locked.insert(name);
        match package.get("source").and_then(Value::as_str) {
            None => assert!(name == "geneva" || name.starts_with("geneva-"), "{name} is from nowhere"),
            Some(source) => {
                assert!(allowed.iter().any(|registry| registry == source), "{name} is from {source}");
                assert!(package.get("checksum").is_some(), "{name} has no checksum");
            }
        }
    }
    for package in packages().iter().filter_map(|package| package.source.as_ref()) {
        assert!(allowed.contains(package), "{package}");
    }
    // An advisory is ignored as long as the package that it is about is here.
    let ignored = rules["advisories"]["ignore"].as_array().expect("a list");
    for advisory in ignored {
        let about = advisory["reason"].as_str().and_then(|reason| reason.split_whitespace().next()).expect("a reason");
        assert!(locked.contains(about), "{}: there is no {about} any more", advisory["id"]);
    }
}
