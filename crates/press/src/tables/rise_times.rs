//! The printed rise times against definitions, and against the law of similarity.

use crate::html::{Cells, Table, escape, table};
use geneva_ledger::meyer::runs::rise_times::{Misread, explained, groups as all_groups};

/// How many rows each definition explains.
pub fn definitions() -> anyhow::Result<Table> {
    let explained = explained();
    let rows = explained.iter().map(|(definition, [as_run, ideal])| {
        let all = |counts: &[usize; 3]| counts.iter().sum::<usize>().to_string();
        let mut row = vec![escape(definition.name), all(&as_run.within_one)];
        row.extend(as_run.within_one.map(|count| count.to_string()));
        row.push(format!("{:.2} to {:.2}", as_run.range[0], as_run.range[1]));
        row.push(all(&ideal.within_one));
        Ok(row)
    });
    let head = [
        "Time from rest until",
        "As run, <br>of 49",
        "six <br>pins",
        "four <br>pins",
        "three <br>pins",
        "printed <br>over computed",
        "The mechanism, <br>of 49",
    ];
    table("Rise times explained to one unit of the last place, by definition", Cells::NamedNumbers, &head, rows)
}

/// Printed rise times times √K: equal within a group, were they defined by the motion alone.
pub fn groups() -> anyhow::Result<Table> {
    let all = all_groups();
    let rows = all.iter().map(|group| {
        let scaled: Vec<String> = group.scaled.iter().map(|time| format!("{:.1}", 1e3 * time)).collect();
        let possible = if group.possible { "yes" } else { "no" };
        let misread: Vec<String> = group.misread.iter().map(misread).collect();
        let misread = match (group.possible, misread.is_empty()) {
            (true, _) => "–".to_owned(),
            (false, true) => "no".to_owned(),
            (false, false) => misread.join("; or "),
        };
        let name = format!("{} pins, μ = {}", group.mechanism.pins(), group.friction);
        Ok(vec![name, scaled.join(", "), possible.to_owned(), misread])
    });
    let head = ["Rows", "1000 t √K, by rising K", "One number <br>for all?", "Or if one row is misread?"];
    table(
        "Printed rise times t, in s, times the root of K, in in·lb: one number in each group by the law of similarity",
        Cells::Words,
        &head,
        rows,
    )
}

/// A row that may be misread, and what it should have been.
fn misread(row: &Misread) -> String {
    let [low, high] = row.between.map(|time| format!("{time:.4}"));
    format!("K = {} ({low} to {high} s)", row.torque)
}
