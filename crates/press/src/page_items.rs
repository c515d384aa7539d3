//! Figures, tables and errata, each where it stands in the book.

/// A figure, a table or an erratum on its page.
pub struct PageItem {
    /// By which a chapter refers to it: of an erratum, the id of its claim.
    pub(crate) name: String,
    /// What it is.
    pub(crate) kind: ItemKind,
    /// As it is printed: that of the chapter, and its own. Empty for an erratum.
    pub(crate) number: String,
    /// The page.
    pub(crate) page: String,
    /// Where the placeholder stands in the chapter.
    pub(crate) at: usize,
}

/// What stands on a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ItemKind {
    Figure,
    Table,
    Erratum,
}

impl ItemKind {
    /// What a caption calls it.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Figure => "Figure",
            Self::Table => "Table",
            Self::Erratum => "Erratum",
        }
    }
}

impl PageItem {
    /// The anchor on its page.
    pub(crate) fn anchor(&self) -> String {
        match self.kind {
            ItemKind::Figure => format!("fig-{}", self.name),
            ItemKind::Table => format!("table-{}", self.name),
            ItemKind::Erratum => anchor_of_erratum(&self.name),
        }
    }

    /// The name of its data: a figure and a table may bear the same.
    pub(crate) fn file(&self) -> String {
        if self.kind == ItemKind::Figure { self.name.clone() } else { format!("table-{}", self.name) }
    }
}

/// The anchor of the fold with the erratum of a claim.
pub(crate) fn anchor_of_erratum(id: &str) -> String {
    format!("erratum-{id}")
}

/// All that other chapters say of them, in words for a key. Where in its chapter one stands, that chapter alone needs to know.
pub(crate) fn listed(all: &[PageItem]) -> String {
    let words =
        all.iter().map(|PageItem { name, kind, number, page, at: _ }| format!("{:?}", (name, kind, number, page)));
    words.collect::<Vec<_>>().join(" ")
}

/// Those that have a number.
pub(crate) fn numbered_items(all: &[PageItem]) -> impl Iterator<Item = &PageItem> {
    all.iter().filter(|item| item.kind != ItemKind::Erratum)
}

/// The address of the fold in which a chapter tells the erratum of a claim, if one does.
pub(crate) fn address_of_erratum(all: &[PageItem], id: &str) -> Option<String> {
    let fold = all.iter().find(|item| item.kind == ItemKind::Erratum && item.name == id)?;
    Some(format!("{}.html#{}", fold.page, fold.anchor()))
}
