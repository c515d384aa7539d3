//! What earlier builds of the same program have made, kept in `book-cache` below the target directory, so that an author who
//! changes a word waits for his page and not for the solvers.
//!
//! A build may take a text from here only if this very program made it from these very inputs. An entry's key is a digest of
//! everything that it was made from, and the folder is named by a digest of the running program. Nothing here is trusted: a
//! file that is damaged, cut short or of another program is passed over, and what cannot be written is made again next time.
//!
//! Verdicts that a command reports never come from here. They are derived by whoever reports them.

use crate::book::Book;
use sha2::{Digest, Sha256};
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, SystemTime};
use tempfile::NamedTempFile;

/// The folder below the target directory.
pub(crate) const FOLDER: &str = "book-cache";
/// How many programs have a folder at most: those of both profiles, and two that an author goes back to.
const PROGRAMS: usize = 4;
/// The first bytes of a file, which change with its form.
const FORM: &[u8] = b"book cache 1\n";
/// Bytes of a digest.
const DIGEST: usize = 32;
/// After this time, a file on its way belongs to no build that is still running.
const LONG: Duration = Duration::from_secs(3600);

type Key = [u8; DIGEST];

/// Texts that were made from something, by a digest of what they were made from.
pub(crate) struct Shelf {
    /// Where it is kept between builds, if it is, and by which program.
    place: Option<(PathBuf, Key)>,
    known: Arc<BTreeMap<Key, Entry>>,
    made: RefCell<BTreeMap<Key, Entry>>,
    used: RefCell<BTreeSet<Key>>,
    /// The entries that are being made, each with those that it has asked for.
    under_way: RefCell<Vec<Vec<Key>>>,
    is_complete: Cell<bool>,
    /// Whether another shelf takes in what is made here, and keeps it.
    is_branch: bool,
}

/// What was made, and the entries of the same shelf that were asked for on the way: they are kept with it.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Entry {
    texts: Vec<String>,
    inner: Vec<Key>,
}

impl Shelf {
    /// A shelf that remembers nothing from before and keeps nothing.
    pub(crate) fn empty() -> Self {
        Self::at(None)
    }

    /// The shelf of this name of the running program for one of its books, below a target directory. Where there is no such
    /// directory, nothing is kept.
    pub(crate) fn open(target: &Path, book: &Book, name: &str) -> Self {
        let program = if target.is_dir() { program() } else { None };
        let book: String = book.imprint.key.chars().filter(char::is_ascii_alphanumeric).collect();
        Self::at(program.map(|program| (folder(target, &program).join(format!("{book}-{name}")), program)))
    }

    fn at(place: Option<(PathBuf, Key)>) -> Self {
        let known = place.as_ref().and_then(|(path, program)| read(path, program)).unwrap_or_default();
        Self::knowing(Arc::new(known), place, false)
    }

    fn knowing(known: Arc<BTreeMap<Key, Entry>>, place: Option<(PathBuf, Key)>, is_branch: bool) -> Self {
        Self {
            place,
            known,
            made: RefCell::default(),
            used: RefCell::default(),
            under_way: RefCell::default(),
            is_complete: Cell::new(false),
            is_branch,
        }
    }

    /// A shelf for another thread, with what earlier builds have made; see [`Shelf::take_in`].
    pub(crate) fn branch(&self) -> Self {
        Self::knowing(Arc::clone(&self.known), self.place.clone(), true)
    }

    /// Takes in what a branch has made and asked for. What none takes in is made again next time.
    pub(crate) fn take_in(&self, branch: Self) {
        self.made.borrow_mut().append(&mut branch.made.borrow_mut());
        self.used.borrow_mut().append(&mut branch.used.borrow_mut());
    }

    /// The texts that are made from these parts, which must be all that they are made from besides the program. `what` says
    /// what is made of them.
    pub(crate) fn recall(
        &self,
        what: &str,
        parts: &[&str],
        make: impl FnOnce() -> anyhow::Result<Vec<String>>,
    ) -> anyhow::Result<Vec<String>> {
        if self.place.is_none() {
            return make();
        }
        let key = key(what, parts);
        if let Some(asking) = self.under_way.borrow_mut().last_mut() {
            asking.push(key);
        }
        let known = self.known.get(&key).cloned().or_else(|| self.made.borrow().get(&key).cloned());
        if let Some(entry) = known {
            self.use_with_inner(key);
            return Ok(entry.texts);
        }
        self.under_way.borrow_mut().push(Vec::new());
        let texts = make();
        let inner = self.under_way.borrow_mut().pop().unwrap_or_default();
        let texts = texts?;
        self.made.borrow_mut().insert(key, Entry { texts: texts.clone(), inner });
        self.use_with_inner(key);
        Ok(texts)
    }

    /// The one text that is made from these parts; see [`Shelf::recall`].
    pub(crate) fn text(
        &self,
        what: &str,
        parts: &[&str],
        make: impl FnOnce() -> anyhow::Result<String>,
    ) -> anyhow::Result<String> {
        Ok(self.recall(what, parts, || Ok(vec![make()?]))?.pop().unwrap_or_default())
    }

    fn use_with_inner(&self, key: Key) {
        let mut waiting = vec![key];
        while let Some(key) = waiting.pop() {
            if self.used.borrow_mut().insert(key) {
                let inner = self.known.get(&key).map(|entry| entry.inner.clone());
                let inner = inner.or_else(|| self.made.borrow().get(&key).map(|entry| entry.inner.clone()));
                waiting.extend(inner.unwrap_or_default());
            }
        }
    }

    /// Says that a build has asked for all that it needs: what it has not asked for is needed no more.
    pub(crate) fn complete(&self) {
        self.is_complete.set(true);
    }
}

impl Drop for Shelf {
    fn drop(&mut self) {
        let made = std::mem::take(&mut *self.made.borrow_mut());
        let Some((path, program)) = self.place.as_ref().filter(|_| !made.is_empty() && !self.is_branch) else { return };
        let mut kept = Arc::unwrap_or_clone(std::mem::take(&mut self.known));
        kept.extend(made);
        if self.is_complete.get() {
            kept.retain(|key, _| self.used.borrow().contains(key));
        }
        // Without the file, the next build makes all of it again.
        let _ = write(path, program, &kept);
    }
}

/// The folder of a program.
fn folder(target: &Path, program: &Key) -> PathBuf {
    target.join(FOLDER).join(hexadecimal(&program[..DIGEST / 2]))
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// A digest of bytes, as text.
pub(crate) fn digest(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

/// The digest of the running program, which is the same as long as its every byte is.
fn program() -> Option<Key> {
    static PROGRAM: OnceLock<Option<Key>> = OnceLock::new();
    *PROGRAM.get_or_init(|| {
        // On Linux, this is the program that runs even if another one has taken its name since.
        let own = Path::new("/proc/self/exe");
        let path = if cfg!(target_os = "linux") { own.to_owned() } else { std::env::current_exe().ok()? };
        let mut file = File::open(path).ok()?;
        let (mut digest, mut buffer) = (Sha256::new(), vec![0; 1 << 20]);
        loop {
            match file.read(&mut buffer) {
                Ok(0) => break Some(digest.finalize().into()),
                Ok(length) => digest.update(&buffer[..length]),
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(_) => break None,
            }
        }
    })
}

/// A digest in which no two lists of parts are the same.
fn key(what: &str, parts: &[&str]) -> Key {
    let mut digest = Sha256::new();
    for part in [what].iter().chain(parts) {
        digest.update((part.len() as u64).to_le_bytes());
        digest.update(part);
    }
    digest.finalize().into()
}

/// The entries of a file, if it is whole and of this program.
fn read(path: &Path, program: &Key) -> Option<BTreeMap<Key, Entry>> {
    let bytes = fs::read(path).ok()?;
    let rest = bytes.strip_prefix(FORM)?.strip_prefix(program)?;
    let (digest, body) = rest.split_at_checked(DIGEST)?;
    if *Sha256::digest(body) != *digest {
        return None;
    }
    let (mut entries, mut rest) = (BTreeMap::new(), body);
    while !rest.is_empty() {
        let key = take_key(&mut rest)?;
        let inner = (0..take_number(&mut rest)?).map(|_| take_key(&mut rest)).collect::<Option<_>>()?;
        let texts = (0..take_number(&mut rest)?).map(|_| take_text(&mut rest)).collect::<Option<_>>()?;
        entries.insert(key, Entry { texts, inner });
    }
    Some(entries)
}

fn take_number(rest: &mut &[u8]) -> Option<usize> {
    let (number, behind) = rest.split_first_chunk::<8>()?;
    *rest = behind;
    usize::try_from(u64::from_le_bytes(*number)).ok()
}

fn take_key(rest: &mut &[u8]) -> Option<Key> {
    let (key, behind) = rest.split_first_chunk::<DIGEST>()?;
    *rest = behind;
    Some(*key)
}

fn take_text(rest: &mut &[u8]) -> Option<String> {
    let length = take_number(rest)?;
    let (text, behind) = rest.split_at_checked(length)?;
    *rest = behind;
    String::from_utf8(text.to_vec()).ok()
}

/// Writes the file of a shelf, whole or not at all, and clears away what other programs have left.
fn write(path: &Path, program: &Key, entries: &BTreeMap<Key, Entry>) -> io::Result<()> {
    let mut body = Vec::new();
    let number = |number: usize| (number as u64).to_le_bytes();
    for (key, Entry { texts, inner }) in entries {
        body.extend(key);
        body.extend(number(inner.len()));
        inner.iter().for_each(|key| body.extend(key));
        body.extend(number(texts.len()));
        for text in texts {
            body.extend(number(text.len()));
            body.extend_from_slice(text.as_bytes());
        }
    }
    let Some(own) = path.parent() else { return Ok(()) };
    fs::create_dir_all(own)?;
    // Another build may read the file now, and this one may be interrupted.
    let mut file = NamedTempFile::new_in(own)?;
    for part in [FORM, program, &*Sha256::digest(&body), &body] {
        file.write_all(part)?;
    }
    file.persist(path)?;
    clear(own);
    Ok(())
}

/// Removes the folders of programs that were not used for longest, and what an interrupted build has left in this one.
fn clear(own: &Path) {
    let entries = |folder: &Path| fs::read_dir(folder).into_iter().flatten().flatten().collect::<Vec<_>>();
    let changed =
        |path: &Path| fs::symlink_metadata(path).and_then(|of| of.modified()).unwrap_or(SystemTime::UNIX_EPOCH);
    for entry in entries(own) {
        let is_on_its_way = entry.file_name().to_string_lossy().starts_with(".tmp");
        if is_on_its_way && changed(&entry.path()).elapsed().is_ok_and(|age| age > LONG) {
            let _ = fs::remove_file(entry.path());
        }
    }
    let Some(all) = own.parent() else { return };
    let is_of_a_program = |entry: &fs::DirEntry| {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        name.len() == DIGEST
            && name.bytes().all(|of| of.is_ascii_hexdigit())
            && entry.file_type().is_ok_and(|of| of.is_dir())
    };
    let others = entries(all).into_iter().filter(is_of_a_program).map(|entry| entry.path()).filter(|path| path != own);
    let mut others: Vec<_> = others.map(|path| (changed(&path), path)).collect();
    others.sort();
    let surplus = (others.len() + 1).saturating_sub(PROGRAMS);
    for (_, path) in &others[..surplus] {
        let _ = fs::remove_dir_all(path);
    }
}

#[cfg(test)]
mod tests;
