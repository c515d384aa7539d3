//! Parts of a text that are not read.

use crate::named_counts::NamedCounts;

/// What a part of a text or a folder is that is not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum UnreadKind {
    /// A fence of code, with its language.
    Fence,
    /// Code that is set in from the text.
    Indented,
    /// Code in a line of text.
    Code,
    /// A cell of a notebook, with its type.
    Cell,
    /// An environment, with its name.
    Environment,
    /// An element of HTML or XML, with its name.
    Element,
    /// A comment, or what the author has struck out.
    Comment,
    /// A file in a folder, whose format is not read, with the ending of its name.
    File,
    /// A file in a folder that is no text in spite of its name, since it has zero bytes.
    Binary,
    /// A folder of what a program has made out of the author's texts, such as `_site`, with its name.
    Folder,
    /// A symbolic link in a folder.
    Link,
    /// An object of another program in a document, such as a formula of Equation Editor, with the name of the program.
    Object,
}

impl UnreadKind {
    /// Whether all such parts are counted, whatever is in them.
    pub(crate) fn is_whole(self) -> bool {
        matches!(self, Self::Cell | Self::File | Self::Binary | Self::Folder | Self::Link | Self::Object)
    }

    /// A name for programs.
    ///
    /// ```
    /// assert_eq!(proofread::UnreadKind::Fence.name(), "fence");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::Fence => "fence",
            Self::Indented => "indented",
            Self::Code => "code",
            Self::Cell => "cell",
            Self::Environment => "environment",
            Self::Element => "element",
            Self::Comment => "comment",
            Self::File => "file",
            Self::Binary => "binary",
            Self::Folder => "folder",
            Self::Link => "link",
            Self::Object => "object",
        }
    }
}

/// How many parts of a text are not read in which a chain may be, since they have an equals sign and a digit.
pub type UnreadParts = NamedCounts<UnreadKind>;

/// Counts a part that is not read, if a chain may be in it.
pub(crate) fn note(parts: &mut UnreadParts, kind: UnreadKind, name: &str, content: &str) {
    if content.contains(['=', '≈']) && content.bytes().any(|byte| byte.is_ascii_digit()) {
        parts.count(kind, name, 1);
    }
}
