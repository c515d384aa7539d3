//! Files that are archives: their entries are unpacked in memory, within bounds, and by the names that other entries give them.

use std::io::{Cursor, Read};
use zip::ZipArchive;
use zip::result::ZipError;

/// Most bytes that are unpacked of one archive.
const MOST_UNPACKED: u64 = 64 << 20;
/// Most entries of an archive.
const MOST_ENTRIES: usize = 10_000;
/// How many times as long as it was packed an entry may be, if it is longer than a mebibyte: text is packed to a tenth.
const HIGHEST_RATIO: u64 = 200;

/// An archive that is open.
pub(super) struct Archive<'b> {
    entries: ZipArchive<Cursor<&'b [u8]>>,
    left: u64,
}

impl<'b> Archive<'b> {
    /// Opens an archive; `called` says what it should be, for errors.
    pub(super) fn open(bytes: &'b [u8], called: &str) -> Result<Self, String> {
        // What Word packs a document in that has a password, and what it wrote before 2007.
        if bytes.starts_with(&[0xd0, 0xcf, 0x11, 0xe0]) {
            return Err(format!(
                "the file is encrypted or has the old binary format; save it without a password, as {called}"
            ));
        }
        // Each entry of the directory costs memory before it can be counted.
        let entries = bytes.windows(4).filter(|window| window == b"PK\x01\x02").count();
        if entries > MOST_ENTRIES {
            return Err(format!("the archive has {entries} entries, and up to {MOST_ENTRIES} are read; save it anew"));
        }
        let entries = ZipArchive::new(Cursor::new(bytes))
            .map_err(|why| format!("this is no whole {called}: {why}; open it in its program, and save it anew"))?;
        Ok(Self { entries, left: MOST_UNPACKED })
    }

    /// The names of the entries, in the order of the archive.
    pub(super) fn names(&self) -> Vec<String> {
        self.entries.file_names().map(str::to_owned).collect()
    }

    /// The text of an entry; none if there is no such entry.
    pub(super) fn text(&mut self, name: &str) -> Result<Option<String>, String> {
        let mut entry = match self.entries.by_name(name) {
            Ok(entry) => entry,
            Err(ZipError::FileNotFound) => return Ok(None),
            Err(why) => {
                return Err(format!(
                    "`{name}` in the archive cannot be read: {why}; save the file anew, without a password"
                ));
            }
        };
        let most = self.left.min((entry.compressed_size().saturating_mul(HIGHEST_RATIO)).max(1 << 20));
        let mut bytes = Vec::new();
        let read = entry.by_ref().take(most + 1).read_to_end(&mut bytes);
        read.map_err(|why| {
            format!("`{name}` in the archive is broken: {why}; open the file in its program, and save it anew")
        })?;
        let length = bytes.len() as u64;
        if length > most {
            return Err(format!(
                "`{name}` is longer than what is unpacked of an archive, {} MiB in all and {HIGHEST_RATIO} times its packed length; \
                 give a shorter text",
                MOST_UNPACKED >> 20
            ));
        }
        self.left -= length;
        match String::from_utf8(bytes) {
            Ok(text) => Ok(Some(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))),
            Err(_) => {
                Err(format!("`{name}` in the archive is not in UTF-8; open the file in its program, and save it anew"))
            }
        }
    }

    /// The text of an entry that has to be there.
    pub(super) fn needed(&mut self, name: &str, called: &str) -> Result<String, String> {
        self.text(name)?.ok_or_else(|| {
            format!("this is no {called}: the archive has no `{name}`; open the file in its program, and save it anew")
        })
    }
}
