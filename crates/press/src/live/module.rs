//! The module that answers the pages: compiled for WebAssembly, packed as text in a script.

use crate::base64::base64;
use crate::data::{FOLDER, File};
use miniz_oxide::deflate::compress_to_vec;
use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// It asks the system for nothing; for the target without a system, plotters would bring much that is never called.
const TARGET: &str = "wasm32-wasip1";
const PROFILE: &str = "live";
/// The controls, and how they look.
const SHELL: &str = include_str!("../../../../book/theme/live.js");
const STYLE: &str = include_str!("../../../../book/theme/live.css");
const SHELL_NAME: &str = "live.js";
const STYLE_NAME: &str = "live.css";
/// Of ten levels, the one that packs best.
const LEVEL: u8 = 10;

/// The scripts of the figures that a reader moves, made from the workspace `root`: the controls, and the module as text.
///
/// None where they cannot be made, with the reason on standard error: the book is whole without them.
pub fn scripts(root: &Path) -> Vec<File> {
    match module(root) {
        Ok(code) => {
            let text = format!("genevaModule('{}');\n", base64(&compress_to_vec(&code, LEVEL)));
            vec![
                File::script(SHELL_NAME, SHELL.to_owned()),
                File::script(STYLE_NAME, STYLE.to_owned()),
                File::script("live-module.js", text),
            ]
        }
        Err(why) => {
            eprintln!("The figures that a reader moves stand still in this book: {why}");
            Vec::new()
        }
    }
}

/// A page with what it must load to move its figures; the module comes later, when a figure is near.
pub fn on_a_page(content: &str) -> String {
    format!(
        "<link rel=\"stylesheet\" href=\"{FOLDER}/{STYLE_NAME}\">\n\n{content}\n<script src=\"{FOLDER}/{SHELL_NAME}\" \
         defer></script>\n"
    )
}

/// The compiled module.
fn module(root: &Path) -> Result<Vec<u8>, String> {
    if !root.join("crates/live/Cargo.toml").is_file() {
        return Err(format!("{} does not hold their program", root.display()));
    }
    let compiled = compile(root).or_else(|first| {
        add_target(root)?;
        compile(root).map_err(|_| first)
    });
    let target = compiled?;
    let path = target.join(TARGET).join(PROFILE).join("geneva_live.wasm");
    fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))
}

/// Lets Cargo compile it; the target directory, or Cargo's reason.
fn compile(root: &Path) -> Result<std::path::PathBuf, String> {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), |own| root.join(own));
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.current_dir(root).args(["rustc", "--quiet", "--package", "geneva-live", "--lib", "--crate-type", "cdylib"]);
    command.args(["--target", TARGET, "--profile", PROFILE]).stdin(Stdio::null());
    // What is set for tests or documentation of the machine at hand is not for this.
    command.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    let output = command
        .output()
        .map_err(|error| format!("cargo does not run ({error}): install Rust from https://rustup.rs"))?;
    if output.status.success() {
        return Ok(target);
    }
    let said = String::from_utf8_lossy(&output.stderr);
    let line = said.lines().find(|line| line.contains("error")).unwrap_or("cargo gives no reason").trim();
    Err(format!("{line}; `rustup target add {TARGET}` may mend it"))
}

fn add_target(root: &Path) -> Result<(), String> {
    let rustup: OsString = "rustup".into();
    let output = Command::new(rustup).current_dir(root).args(["target", "add", TARGET]).stdin(Stdio::null()).output();
    match output {
        Ok(output) if output.status.success() => Ok(()),
        _ => Err(format!("the target {TARGET} is not installed; `rustup target add {TARGET}` adds it")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_without_the_program_gets_still_figures_and_a_reason() {
        let folder = tempfile::TempDir::new().expect("a folder");
        assert!(module(folder.path()).expect_err("nothing to compile").contains("does not hold their program"));
        assert!(scripts(folder.path()).is_empty());
    }
}
