//! The modules that answer the pages: compiled for WebAssembly, packed as text in a script.

use crate::book::{Book, PageModule};
use crate::cache::{Shelf, digest};
use crate::data::{FOLDER, PageFile};
use crate::seven_bits::seven_bits;
use std::fs;
use std::num::NonZeroU64;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use zopfli::{Format, Options};

/// It asks the system for nothing; for the target without a system, plotters would bring much that is never called.
const TARGET: &str = "wasm32-wasip1";
pub(crate) const PROFILE: &str = "live";
/// The settings of that profile, as a workspace must have them: on a page, size counts.
pub(crate) const PROFILE_SETTINGS: &str = "[profile.live]\ninherits = \"release\"\nopt-level = \"z\"\nlto = true\ncodegen-units = 1\npanic = \"abort\"\nstrip = true\n";
/// What asks a module, in a thread of its own: the first part of every script that has one.
pub(crate) const THREAD: &str = include_str!("../theme/thread.js");
/// How often it is looked for a smaller packing: further times save less than a thousandth.
const TRIES: NonZeroU64 = NonZeroU64::MIN;

/// The style sheets of all modules of a book, from a page.
pub(crate) fn styles(book: &Book) -> impl Iterator<Item = String> {
    book.modules.iter().map(style_path)
}

/// Whether an attribute is one by which a module of a book finds and asks its element.
pub(crate) fn is_own_attribute(book: &Book, name: &str) -> bool {
    book.modules.iter().flat_map(|module| module.attributes).any(|own| name.starts_with(own))
}

/// A module and those that its controls load later, as text, or why they cannot be made.
pub(crate) type PackedModules = Result<Vec<String>, String>;

/// The modules of a book, made from the workspace `root`.
pub(crate) fn packed_modules(book: &Book, root: &Path, shelf: &Shelf) -> Vec<PackedModules> {
    let of_one = |module: &PageModule| {
        let own = (module.package, module.folder);
        let all = std::iter::once(own).chain(module.later.iter().map(|later| (later.package, later.folder)));
        all.map(|(package, folder)| packed(&compiled(package, folder, root)?, shelf)).collect()
    };
    book.modules.iter().map(of_one).collect()
}

/// Puts into each page what loads the module that it asks for, and gives the scripts: the controls, and the module as text.
///
/// A module that cannot be made is left out, with the reason on standard error: the book is whole without it.
pub(crate) fn load_into_pages(
    book: &Book,
    pages: &mut dyn Iterator<Item = &mut String>,
    packed: Vec<PackedModules>,
) -> Vec<PageFile> {
    let mut pages: Vec<&mut String> = pages.collect();
    let mut files = Vec::new();
    for (module, packed) in book.modules.iter().zip(packed) {
        let attribute = format!(" {}=\"", module.asking());
        let mut asking = pages.iter_mut().filter(|page| page.contains(&attribute)).peekable();
        if asking.peek().is_none() {
            continue;
        }
        match packed {
            Ok(with_later) => {
                asking.for_each(|page| **page = with_scripts(module, page));
                files.extend(scripts(module));
                let names = std::iter::once(module.name).chain(module.later.iter().map(|later| later.name));
                files.extend(names.zip(with_later).map(|(name, packed)| module_file(name, &packed)));
            }
            Err(why) => eprintln!("What `{}` makes live stands still in this book: {why}", module.package),
        }
    }
    files
}

fn style_path(module: &PageModule) -> String {
    format!("{FOLDER}/{}.css", module.name)
}

fn scripts(module: &PageModule) -> [PageFile; 2] {
    [
        PageFile::text_file(&format!("{}.js", module.name), format!("{THREAD}{}", module.script)),
        PageFile::text_file(&format!("{}.css", module.name), module.style.to_owned()),
    ]
}

/// The script that holds a packed module as text.
fn module_file(name: &str, packed: &str) -> PageFile {
    PageFile::text_file(&format!("{name}-module.js"), format!("genevaModule('{packed}');\n"))
}

/// A page with what it must load; the module comes later, when it is needed.
fn with_scripts(module: &PageModule, content: &str) -> String {
    format!(
        "<link rel=\"stylesheet\" href=\"{}\">\n\n{content}\n<script src=\"{FOLDER}/{}.js\" defer></script>\n",
        style_path(module),
        module.name
    )
}

/// A module as text.
pub(crate) fn packed(module: &[u8], shelf: &Shelf) -> Result<String, String> {
    let pack = || {
        let (mut packed, options) = (Vec::new(), Options { iteration_count: TRIES, ..Options::default() });
        zopfli::compress(options, Format::Deflate, module, &mut packed)?;
        Ok(seven_bits(&packed))
    };
    shelf.text("module", &[&digest(module)], pack).map_err(|error| format!("{error:#}"))
}

/// The compiled module of a package in this folder among the crates.
fn compiled(package: &str, folder: &str, root: &Path) -> Result<Vec<u8>, String> {
    if !root.join("crates").join(folder).join("Cargo.toml").is_file() {
        return Err(format!("{} does not hold their program", root.display()));
    }
    let target = target_directory(root, root);
    let of = Compilation { workspace: root, folder: root, package: Some(package), target: &target, profile: PROFILE };
    of.module(package)
}

/// The target directory of a workspace, for Cargo called from the folder `from`.
pub(crate) fn target_directory(workspace: &Path, from: &Path) -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| workspace.join("target"), |own| from.join(own))
}

/// A library to be compiled for WebAssembly.
pub(crate) struct Compilation<'a> {
    /// The workspace of the sources, from which files are named in messages.
    pub(crate) workspace: &'a Path,
    /// The folder in which Cargo is called.
    pub(crate) folder: &'a Path,
    /// The package, if there are several in the folder's workspace.
    pub(crate) package: Option<&'a str>,
    /// The target directory.
    pub(crate) target: &'a Path,
    /// The profile.
    pub(crate) profile: &'static str,
}

impl Compilation<'_> {
    /// Lets Cargo compile it; the module of the library of this name, or Cargo's reason.
    pub(crate) fn module(&self, name: &str) -> Result<Vec<u8>, String> {
        // Where the target cannot be added, Cargo's own reason is the one that counts: there may be no Cargo at all.
        compile(self).or_else(|first| if is_target_added(self.folder) { compile(self) } else { Err(first) })?;
        let file = format!("{}.wasm", name.replace('-', "_"));
        let path = self.target.join(TARGET).join(self.profile).join(file);
        fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))
    }
}

/// Flags by which no file is named from where it is on this machine, so that the module is the same on every one.
fn flags(workspace: &Path) -> String {
    let home = std::env::home_dir().unwrap_or_default();
    let cargo = std::env::var_os("CARGO_HOME").map_or_else(|| home.join(".cargo"), Into::into);
    let rustup = std::env::var_os("RUSTUP_HOME").map_or_else(|| home.join(".rustup"), Into::into);
    let shortened = [
        (format!("{}/", workspace.display()), ""),
        (cargo.display().to_string(), "cargo"),
        (rustup.display().to_string(), "rustup"),
    ];
    shortened.map(|(path, short)| format!("--remap-path-prefix={path}={short}")).join("\x1f")
}

/// Lets Cargo compile it, or gives Cargo's reason.
fn compile(of: &Compilation<'_>) -> Result<(), String> {
    let Compilation { workspace, folder, package, target, profile } = of;
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.current_dir(folder).args(["rustc", "--quiet", "--lib", "--crate-type", "cdylib"]);
    command.args(package.iter().flat_map(|package| ["--package", *package]));
    command.args(["--target", TARGET, "--profile", *profile]).stdin(Stdio::null());
    // Addresses in as many bytes as they need, not in five each: the module is a twentieth smaller.
    command.args(["--", "-C", "link-arg=--compress-relocations"]);
    // What is set for tests or documentation of the machine at hand is not for this.
    command.env_remove("RUSTFLAGS").env("CARGO_ENCODED_RUSTFLAGS", flags(workspace)).env("CARGO_TARGET_DIR", target);
    let output = command
        .output()
        .map_err(|error| format!("cargo does not run ({error}): install Rust from https://rustup.rs"))?;
    if output.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&output.stderr);
    let line = said.lines().find(|line| line.contains("error")).unwrap_or("cargo gives no reason").trim();
    Err(format!("{line}; `rustup target add {TARGET}` may mend it"))
}

/// Lets rustup add the target; whether it could. Modules that are compiled side by side ask one after the other.
fn is_target_added(root: &Path) -> bool {
    static ASKING: Mutex<()> = Mutex::new(());
    let _asking = ASKING.lock();
    let mut rustup = Command::new("rustup");
    rustup.current_dir(root).args(["target", "add", TARGET]).stdin(Stdio::null());
    rustup.output().is_ok_and(|output| output.status.success())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::BOOK;

    #[test]
    fn a_crate_that_is_made_has_the_profile_of_this_workspace() {
        assert!(include_str!("../../../Cargo.toml").contains(PROFILE_SETTINGS));
    }

    #[test]
    fn a_folder_without_the_program_gets_still_figures_and_a_reason() {
        let folder = tempfile::TempDir::new().expect("a folder");
        let modules = packed_modules(&BOOK, folder.path(), &Shelf::empty());
        assert_eq!(modules.len(), BOOK.modules.len());
        for module in &modules {
            let why = module.as_ref().expect_err("nothing to compile");
            assert!(why.contains("does not hold their program"), "{why}");
        }
        for module in BOOK.modules {
            let mut page = format!("<p {}=\"\"></p>", module.asking());
            let still = page.clone();
            assert!(load_into_pages(&BOOK, &mut std::iter::once(&mut page), modules.clone()).is_empty());
            assert_eq!(page, still);
        }
    }
}
