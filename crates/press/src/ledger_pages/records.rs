//! What the pages of the records list: all claims, all slips, how the sources are covered; and the fields of the data.

use super::{coverage, errata, ledger};
use crate::html::{Cells, Table, escape, table};
use crate::pages::{PAGES, Records};
use crate::records::{described, types};
use anyhow::{Context, bail};

/// What the list of pages puts on the page of this name.
pub fn page(name: &str) -> anyhow::Result<String> {
    let page = PAGES.iter().find(|page| page.name == name).with_context(|| format!("no page `{name}` in the list"))?;
    match &page.records {
        Records::None => bail!("the list of pages puts no records on `{name}`"),
        Records::Claims => ledger::page(),
        Records::Slips(consequences) => consequences.iter().map(errata::all).collect(),
        Records::Coverage => coverage::page(),
    }
}

/// The fields of a file of the records, with what each says.
pub fn fields(file: &str) -> anyhow::Result<Table> {
    let (fields, rows) = described(file)?;
    let rows = fields.iter().map(|(path, meaning)| {
        // Between grave accents stand words of the data.
        let parts = meaning.split('`').enumerate().map(|(at, part)| match at % 2 {
            1 => format!("<code>{}</code>", escape(part)),
            _ => in_italics(part),
        });
        Ok(vec![format!("<span><code>{}</code></span>", escape(path)), types(&rows, path), parts.collect()])
    });
    table(&format!("Fields of {file}.json"), Cells::Words, &["Field", "Type", "What it says"], rows)
}

/// Text with the titles between asterisks in italics.
fn in_italics(text: &str) -> String {
    let parts = text.split('*').enumerate().map(|(at, part)| match at % 2 {
        1 => format!("<em>{}</em>", escape(part)),
        _ => escape(part),
    });
    parts.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_the_data_are_set_as_code_and_titles_in_italics() {
        assert_eq!(in_italics("see *Errata* <b>"), "see <em>Errata</em> &lt;b&gt;");
        let table = fields("claims").expect("a table");
        assert!(table.holds("<code>right</code>, <code>wrong</code> or <code>open</code>"));
        assert!(table.holds("<em>How it is checked</em>") && table.holds("<code>erratum.reason</code>"));
        assert!(fields("claim").is_err());
    }
}
