//! JSON Schemas of the data files: which fields a row has, of what types, and which words a field takes.

use crate::book::Book;
use crate::field_list::{self, FieldMeaning};
use geneva_evidence::{Consequence, Kind, Origin, Truth, Verdict};
use serde_json::{Map, Value, json};

/// The version of the format of the JSON files. It changes when a field goes away or changes what it means, and not when one
/// is added.
pub const FORMAT: &str = "1";

/// The dialect in which the schemas are written.
const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";
/// The JSON files: name, the key of their rows, and under which name their fields are described.
pub const FILES: [(&str, &str, &str); 4] = [
    ("claims", "claims", "claims"),
    ("errata", "errata", "errata"),
    ("copies", "copies", "errata"),
    ("coverage", "entries", "coverage"),
];

/// The name of the schema of a JSON file, which stands beside it.
pub fn name(file: &str) -> String {
    format!("{file}.schema.json")
}

/// The schemas of a book's JSON files: names and texts.
///
/// # Errors
///
/// If a file is not described.
pub fn files(book: &Book) -> anyhow::Result<Vec<(String, String)>> {
    FILES.iter().map(|(file, key, described)| Ok((name(file), schema(book, file, key, described)?))).collect()
}

/// The schema of a JSON file, whose rows are under a key.
fn schema(book: &Book, file: &str, key: &str, described: &str) -> anyhow::Result<String> {
    let fields = field_list::meanings(book, described)?;
    let mut properties = Map::new();
    for (path, meaning) in field_list::around(book) {
        properties.insert(path.to_owned(), with_meaning(around(path), meaning));
    }
    let rows = json!({ "type": "array", "items": object(&fields, "") });
    properties.insert(key.to_owned(), rows);
    let schema = json!({
        "$schema": DIALECT,
        "title": format!("{}: {file}.json, format {FORMAT}", book.imprint.title),
        "type": "object",
        "required": properties.keys().collect::<Vec<_>>(),
        "properties": properties,
    });
    Ok(format!("{schema:#}\n"))
}

/// The fields right below a path, as an object that has them all and may have others.
fn object(fields: &[FieldMeaning], below: &str) -> Value {
    let mut properties = Map::new();
    for (path, meaning) in fields {
        let Some(own) = path.strip_prefix(below).filter(|own| !own.contains('.')) else { continue };
        let inner = || object(fields, &format!("{path}."));
        let of = match type_of(path) {
            Type::Text => json!({ "type": "string" }),
            Type::Name => json!({ "type": "string", "minLength": 1 }),
            Type::TextOrNull => json!({ "type": ["string", "null"] }),
            Type::NumberOrNull => json!({ "type": ["number", "null"] }),
            Type::Count => json!({ "type": "integer", "minimum": 0 }),
            Type::Flag => json!({ "type": "boolean" }),
            Type::Texts => json!({ "type": "array", "items": { "type": "string" } }),
            Type::OneOf(words) => json!({ "enum": words }),
            Type::OneOfOrNull(words) => {
                let words: Vec<_> = words.into_iter().map(Value::from).chain([Value::Null]).collect();
                json!({ "enum": words })
            }
            Type::Objects => json!({ "type": "array", "items": inner() }),
            Type::ObjectOrNull => {
                let mut inner = inner();
                inner["type"] = json!(["object", "null"]);
                inner
            }
        };
        properties.insert(own.to_owned(), with_meaning(of, meaning));
    }
    let required: Vec<_> = properties.keys().cloned().collect();
    json!({ "type": "object", "required": required, "properties": properties })
}

/// What a value is, with what it says.
fn with_meaning(mut of: Value, meaning: &str) -> Value {
    of["description"] = meaning.into();
    of
}

/// What a field around the rows is.
fn around(path: &str) -> Value {
    match path {
        "format" => json!({ "const": FORMAT }),
        "commit" | "address" => json!({ "type": ["string", "null"] }),
        "changed" => json!({ "type": ["boolean", "null"] }),
        _ => json!({ "type": "string" }),
    }
}

/// What a field of a row may be.
enum Type {
    Text,
    /// A text that is not empty.
    Name,
    TextOrNull,
    NumberOrNull,
    Count,
    Flag,
    Texts,
    OneOf(Vec<&'static str>),
    OneOfOrNull(Vec<&'static str>),
    Objects,
    ObjectOrNull,
}

/// What the field of this path is, whichever file has it.
fn type_of(path: &str) -> Type {
    match path {
        "id" | "source" | "findings.form" => Type::Name,
        "computed" | "witnessed" | "from_rounded" | "right_value" | "greatest_change" => Type::NumberOrNull,
        "line" | "wrong_numbers" => Type::Count,
        "holds" | "findings.holds" => Type::Flag,
        "complaints" | "evidence" | "places" | "numbers" | "erratum.inherited_by" => Type::Texts,
        "slip" | "neighbour" | "missing" => Type::TextOrNull,
        "kind" => Type::OneOf(Kind::ALL.iter().map(|of| of.slug()).collect()),
        "verdict" | "expected" => Type::OneOf(Verdict::ALL.iter().map(|of| of.slug()).collect()),
        "truth" => Type::OneOf(Truth::ALL.iter().map(|of| of.slug()).collect()),
        "consequence" => Type::OneOfOrNull(Consequence::ALL.iter().map(|of| of.slug()).collect()),
        "origin" | "erratum.origin" => Type::OneOf(Origin::ALL.iter().map(|of| of.slug()).collect()),
        "entry" => Type::OneOf(vec!["claim", "rest", "again", "reading", "label", "exception"]),
        "findings" => Type::Objects,
        "erratum" => Type::ObjectOrNull,
        // The reason of an exception, and how a sentence is read; of a mistake the reason is never missing.
        "reason" | "reading" => Type::TextOrNull,
        _ => Type::Text,
    }
}

/// What is wrong with a value by one of these schemas, each fault with its path. A key of a schema that these don't have is a
/// fault, too, so that nothing passes unread.
///
/// ```
/// use geneva_press::schema::faults;
/// use serde_json::json;
///
/// let schema = json!({ "type": "object", "properties": { "line": { "type": "integer" } } });
/// assert!(faults(&json!({ "line": 3 }), &schema).is_empty());
/// assert_eq!(faults(&json!({ "line": "3" }), &schema), ["line: \"integer\" is wanted, not \"3\""]);
/// ```
pub fn faults(value: &Value, schema: &Value) -> Vec<String> {
    let mut found = Vec::new();
    collect(value, schema, "", &mut found);
    found
}

fn collect(value: &Value, schema: &Value, at: &str, found: &mut Vec<String>) {
    let below = |name: &str| if at.is_empty() { name.to_owned() } else { format!("{at}.{name}") };
    for (key, expected) in schema.as_object().into_iter().flatten() {
        let list = || expected.as_array().map(Vec::as_slice).unwrap_or_default();
        let holds = match key.as_str() {
            "$schema" | "title" | "description" => true,
            "const" => value == expected,
            "enum" => list().contains(value),
            "minLength" => value.as_str().is_none_or(|text| Some(text.chars().count() as u64) >= expected.as_u64()),
            "minimum" => value.as_f64().is_none_or(|number| Some(number) >= expected.as_f64()),
            "type" => expected.as_str().map_or_else(
                || list().iter().filter_map(Value::as_str).any(|name| is_of_type(value, name)),
                |name| is_of_type(value, name),
            ),
            "required" => {
                let missing = list().iter().filter_map(Value::as_str).find(|name| value.get(name).is_none());
                if let Some(name) = missing.filter(|_| value.is_object()) {
                    found.push(format!("{}: it is missing", below(name)));
                }
                true
            }
            "properties" => {
                for (name, schema) in expected.as_object().into_iter().flatten() {
                    if let Some(value) = value.get(name) {
                        collect(value, schema, &below(name), found);
                    }
                }
                true
            }
            "items" => {
                let items = value.as_array().into_iter().flatten().enumerate();
                items.for_each(|(k, item)| collect(item, expected, &format!("{at}[{k}]"), found));
                true
            }
            unknown => {
                found.push(format!("{}: the schema's key {unknown} is not understood", below("")));
                true
            }
        };
        if !holds {
            found.push(format!("{at}: {expected} is wanted, not {value}"));
        }
    }
}

/// Whether a value is of a type, by its name in a schema.
fn is_of_type(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_u64() || value.is_i64(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edition::Edition;
    use crate::record_files;
    use crate::samples::BOOK;

    #[test]
    fn the_files_are_as_their_schemas_say_and_a_spoilt_one_is_not() {
        let made = record_files::files(&BOOK, &Edition::without_commit(BOOK.imprint.version)).expect("files");
        let mut tried = 0;
        for (file, key, _) in FILES {
            let text = |wanted: &str| made.iter().find(|(name, _)| *name == wanted).map(|(_, text)| text);
            let schema = text(&name(file)).unwrap_or_else(|| panic!("no schema of {file}"));
            let schema: Value = serde_json::from_str(schema).expect("JSON");
            let data: Value = serde_json::from_str(text(&format!("{file}.json")).expect("data")).expect("JSON");
            assert_eq!(faults(&data, &schema), Vec::<String>::new());
            assert_eq!(data["$schema"], name(file));
            // Every field that may be spoilt is noticed: one that is missing, one of another type.
            let row = &schema["properties"][key]["items"];
            if data[key].as_array().is_none_or(Vec::is_empty) {
                continue;
            }
            for field in row["properties"].as_object().expect("fields").keys() {
                let mut without = data.clone();
                without[key][0].as_object_mut().expect("a row").remove(field);
                assert_ne!(faults(&without, &schema), Vec::<String>::new(), "{file}: without {field}");
                let mut other = data.clone();
                other[key][0][field] = json!({ "no": "such" });
                assert_ne!(faults(&other, &schema), Vec::<String>::new(), "{file}: another {field}");
                tried += 1;
            }
        }
        assert!(tried > 30, "{tried} fields");
    }
}
