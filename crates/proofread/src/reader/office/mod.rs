//! Documents of office programs and e-books: archives, each of which becomes one page in HTML or several.

mod archive;
mod blocks;
mod epub;
mod formula;
mod nodes;
mod odt;
mod omml;
mod page;
mod presentation;
mod word;
mod word_styles;

use super::unread::UnreadParts;
use archive::Archive;
pub(crate) use page::MadePage;

/// What a file that is an archive is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ArchiveFormat {
    /// A document of Word: Office Open XML, ECMA-376.
    Docx,
    /// A text of LibreOffice: OpenDocument, ISO/IEC 26300.
    Odt,
    /// An e-book: EPUB 2 or 3.
    Epub,
}

impl ArchiveFormat {
    /// Every format with its name.
    pub(crate) const ALL: [(&'static str, Self); 3] = [("docx", Self::Docx), ("odt", Self::Odt), ("epub", Self::Epub)];

    /// The format of this name.
    pub(crate) fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, format)| *format)
    }

    /// Its name.
    pub(crate) fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, format)| *format == self).map_or("", |(name, _)| name)
    }

    /// The format of files whose names end so, without the dot, in any case.
    pub(crate) fn from_extension(extension: &str) -> Option<Self> {
        match extension.to_ascii_lowercase().as_str() {
            "docm" => Some(Self::Docx),
            other => Self::from_name(other),
        }
    }
}

/// A text in an archive.
pub(crate) enum ArchivedText {
    /// A page that was made out of the whole document, and what of it was not read.
    Made(MadePage, UnreadParts),
    /// A page that is in the archive as it is, with its name there.
    Page { name: String, page: String },
}

/// The texts of an archive in their order.
///
/// # Errors
///
/// If it is no such archive, is encrypted or broken, or would be too long when unpacked, in words that say what to do.
pub(crate) fn read_archive(bytes: &[u8], format: ArchiveFormat) -> Result<Vec<ArchivedText>, String> {
    let made = |(page, unread)| vec![ArchivedText::Made(page, unread)];
    match format {
        ArchiveFormat::Docx => word::read(Archive::open(bytes, ".docx")?).map(made),
        ArchiveFormat::Odt => odt::read(Archive::open(bytes, ".odt")?).map(made),
        ArchiveFormat::Epub => epub::read(Archive::open(bytes, ".epub")?),
    }
}
