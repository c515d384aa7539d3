//! The server for editors, with an editor that others wrote: Neovim, where it is installed.

use serde_json::{Value, json};
use std::fs;
use std::process::{Command, Stdio};

/// Runs the script in Neovim; what came of it, or none if there is no Neovim.
fn in_neovim(text: &str) -> Option<Value> {
    if Command::new("nvim").arg("--version").stdout(Stdio::null()).status().is_err() {
        assert!(std::env::var_os("NEOVIM_REQUIRED").is_none(), "NEOVIM_REQUIRED is set, but there is no nvim");
        eprintln!("skipped: nvim is not installed");
        return None;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let [file, result] = ["text.md", "result.json"].map(|name| folder.path().join(name));
    fs::write(&file, text).expect("written");
    let mut neovim = Command::new("nvim");
    neovim.args(["--headless", "--clean", "-n", "-S", concat!(env!("CARGO_MANIFEST_DIR"), "/tests/neovim.lua")]);
    for name in ["HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"] {
        neovim.env(name, folder.path());
    }
    neovim.env("PROOFREAD", env!("CARGO_BIN_EXE_proofread")).env("TEXT", &file).env("RESULT", &result);
    let out = neovim.current_dir(folder.path()).stdin(Stdio::null()).output().expect("it runs");
    let told = String::from_utf8_lossy(&out.stderr).into_owned();
    let result = fs::read_to_string(&result).unwrap_or_else(|why| panic!("no result: {why}\n{told}"));
    Some(serde_json::from_str(&result).expect("JSON"))
}

#[test]
fn neovim_shows_a_finding_explains_it_and_mends_it() {
    // Neovim counts columns in bytes, and 𝟙 has four.
    let Some(result) = in_neovim("# Angles\n\n𝟙 It is $\\tan 31.0^\\circ = 0.609$.\n") else { return };
    assert_eq!(result["failed"], Value::Null);
    let found = &result["found"];
    assert_eq!([&found["line"], &found["from"], &found["to"]], [&json!(2), &json!(30), &json!(35)], "{found}");
    assert_eq!((&found["source"], &found["severity"]), (&json!("proofread"), &json!(2)), "{found}");
    assert!(found["message"].as_str().is_some_and(|said| said.contains("printed 0.609, recomputed 0.601")), "{found}");
    let hover = result["hover"].as_array().expect("lines");
    assert!(hover.contains(&json!("hint: `0.601` for `0.609` would agree")), "{hover:?}");
    assert_eq!(result["mended"], json!(["# Angles", "", "𝟙 It is $\\tan 31.0^\\circ = 0.601$."]));
    assert_eq!(result["other"], json!({ "line": 3, "from": 18, "to": 19 }));
}
