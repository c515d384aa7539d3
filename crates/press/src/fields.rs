//! Values under keys as JSON and CSV: in JSON a list of fields is an object, in CSV a row.

pub use geneva_fields::{DataRow, FieldValue};
use serde::Serialize;

/// A header, which is that of any such row, and the rows.
pub fn csv(any: Option<&DataRow>, rows: impl IntoIterator<Item = DataRow>) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    if let Some(any) = any {
        writer.write_record(columns(any))?;
    }
    for row in rows {
        writer.write_record(cells(&row))?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// Something in JSON, for reading and for programs.
pub fn json(said: &impl Serialize) -> anyhow::Result<String> {
    Ok(serde_json::to_string_pretty(said)? + "\n")
}

/// The names of the cells: the keys, those of an object behind its own.
fn columns(row: &DataRow) -> Vec<String> {
    let names = row.0.iter().flat_map(|(key, value)| match value {
        FieldValue::Object(inner) => columns(inner).iter().map(|column| format!("{key}_{column}")).collect(),
        _ => vec![(*key).to_owned()],
    });
    names.collect()
}

fn cells(row: &DataRow) -> Vec<String> {
    let cells = row.0.iter().flat_map(|(_, value)| match value {
        FieldValue::Object(inner) => cells(inner),
        other => vec![cell(other)],
    });
    cells.collect()
}

/// A value as it stands in a cell: a number as in JSON.
fn cell(value: &FieldValue) -> String {
    match value {
        FieldValue::Missing | FieldValue::Object(_) => String::new(),
        FieldValue::Flag(flag) => flag.to_string(),
        FieldValue::Count(count) => count.to_string(),
        FieldValue::Number(number) => serde_json::to_string(number).unwrap_or_default(),
        FieldValue::Text(text) | FieldValue::Worded(_, text) => text.clone(),
        FieldValue::List(values) => values.iter().map(cell).collect::<Vec<_>>().join("; "),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_and_csv_say_the_same_of_what_is_there_and_of_what_is_missing() {
        let finding = DataRow(vec![("form", "printed".into()), ("holds", false.into())]);
        let row = |inner: Option<f64>| {
            DataRow(vec![
                ("a", 6e-5.into()),
                ("b", FieldValue::Missing),
                ("c", vec![FieldValue::Worded(finding.clone(), "printed fails".to_owned()), 2_u32.into()].into()),
                ("d", FieldValue::Object(DataRow(vec![("x", inner.into()), ("y", inner.map(|_| "text").into())]))),
            ])
        };
        let (some, none) = (row(Some(1.0)), row(None));
        let text = serde_json::to_string(&[&some, &none]).expect("JSON");
        let list = r#"[{"form":"printed","holds":false},2]"#;
        let expected = format!(
            r#"[{{"a":0.00006,"b":null,"c":{list},"d":{{"x":1.0,"y":"text"}}}},{{"a":0.00006,"b":null,"c":{list},"d":null}}]"#
        );
        assert_eq!(text, expected);
        let text = csv(Some(&none), [some, none.clone()]).expect("CSV");
        assert_eq!(text, "a,b,c,d_x,d_y\n0.00006,,printed fails; 2,1.0,text\n0.00006,,printed fails; 2,,\n");
    }
}
