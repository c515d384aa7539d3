//! The options that an editor passes on.

use super::super::arguments::{COMPARED, FOLLOWED};
use crate::evaluate::binding::NamePolicy;
use crate::judge::section::ReportSection;
use geneva_host::printable::escape_and_shorten;
use serde_json::Value;
use std::path::PathBuf;

/// What is listed. The names and values are those of the command's options.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Settings {
    pub units: bool,
    pub doubts: bool,
    pub name_policy: NamePolicy,
    pub statistics: bool,
    /// The file with accepted cases, from the folder of the editor.
    pub baseline: Option<PathBuf>,
}

impl Default for Settings {
    fn default() -> Self {
        Self { units: false, doubts: false, name_policy: NamePolicy::default(), statistics: true, baseline: None }
    }
}

impl Settings {
    /// These settings, changed by the options that an editor gives, alone or as `proofread`, and what is wrong with these.
    pub(super) fn changed_by(&self, given: &Value) -> (Self, Vec<String>) {
        let mut settings = self.clone();
        let mut wrong = Vec::new();
        let given = given.get("proofread").unwrap_or(given);
        let Some(options) = given.as_object() else {
            if !given.is_null() {
                wrong.push(format!("the options are {}; give an object, such as {{\"units\": true}}", shown(given)));
            }
            return (settings, wrong);
        };
        for (name, value) in options {
            let allowed = match name.as_str() {
                "units" => set(&mut settings.units, value, &[]),
                "doubts" => set(&mut settings.doubts, value, &[]),
                "bindings" => set(&mut settings.name_policy, value, &FOLLOWED),
                "statistics" => set(&mut settings.statistics, value, &COMPARED),
                "baseline" => match value {
                    Value::Null => {
                        settings.baseline = None;
                        Ok(())
                    }
                    Value::String(file) if !file.is_empty() => {
                        settings.baseline = Some(PathBuf::from(file));
                        Ok(())
                    }
                    _ => Err("the path of a file that --accept wrote, or null".to_owned()),
                },
                _ => {
                    let name = escape_and_shorten(name);
                    wrong.push(format!(
                        "the option `{name}` is not known; the options are units, doubts, bindings, statistics and baseline"
                    ));
                    continue;
                }
            };
            if let Err(allowed) = allowed {
                wrong.push(format!("the option `{name}` is {}; give {allowed}", shown(value)));
            }
        }
        (settings, wrong)
    }

    /// Whether the findings of a section are listed.
    pub(super) fn lists(&self, section: ReportSection) -> bool {
        match section {
            ReportSection::Units => self.units,
            ReportSection::Doubts => self.doubts,
            ReportSection::Agreeing => false,
            // Whoever writes the text looks at the mark beside it, so that one which is less certain costs little.
            ReportSection::LessCertain => true,
            ReportSection::Numbers | ReportSection::Bindings | ReportSection::Statistics => true,
        }
    }
}

/// A value that an option may have, by itself in JSON.
trait FromSwitch {
    /// The value of a switch, if it is one.
    const SWITCH: Option<fn(bool) -> Self>;
}

impl FromSwitch for bool {
    const SWITCH: Option<fn(bool) -> Self> = Some(|is_on| is_on);
}

impl FromSwitch for NamePolicy {
    const SWITCH: Option<fn(bool) -> Self> = None;
}

/// Sets an option to a value, or says what is allowed.
fn set<T: Copy + FromSwitch>(option: &mut T, value: &Value, names: &[(&'static str, T)]) -> Result<(), String> {
    let switched = T::SWITCH.and_then(|of| value.as_bool().map(of));
    let named = || names.iter().find(|(name, _)| value == name).map(|(_, of)| *of);
    match switched.or_else(named) {
        Some(new) => {
            *option = new;
            Ok(())
        }
        None => {
            let switches = T::SWITCH.map(|_| ["true", "false"]).into_iter().flatten().map(str::to_owned);
            let names = names.iter().map(|(name, _)| format!("\"{name}\""));
            let allowed: Vec<String> = switches.chain(names).collect();
            Err(allowed.join(" or "))
        }
    }
}

/// A value as it was given, in short.
fn shown(value: &Value) -> String {
    format!("`{}`", escape_and_shorten(&value.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn options_may_stand_alone_or_under_the_name_of_the_program() {
        let given =
            json!({ "units": true, "doubts": true, "bindings": "once", "statistics": false, "baseline": "a.jsonl" });
        let wanted = Settings {
            units: true,
            doubts: true,
            name_policy: NamePolicy::Once,
            statistics: false,
            baseline: Some(PathBuf::from("a.jsonl")),
        };
        assert_eq!(Settings::default().changed_by(&given), (wanted.clone(), vec![]));
        assert_eq!(Settings::default().changed_by(&json!({ "proofread": given })), (wanted.clone(), vec![]));
        // What is not given stays.
        let (settings, wrong) = wanted.changed_by(&json!({ "statistics": "always" }));
        assert_eq!((settings, wrong.len()), (Settings { statistics: true, ..wanted.clone() }, 0));
        assert_eq!(wanted.changed_by(&Value::Null), (wanted.clone(), vec![]));
        assert_eq!(wanted.changed_by(&json!({ "baseline": null })).0.baseline, None);
    }

    #[test]
    fn a_wrong_option_is_told_with_what_is_allowed() {
        for (given, told) in [
            (
                json!({ "unit": true }),
                "the option `unit` is not known; the options are units, doubts, bindings, statistics and baseline",
            ),
            (json!({ "units": "yes" }), "the option `units` is `\"yes\"`; give true or false"),
            (json!({ "bindings": true }), "the option `bindings` is `true`; give \"never\" or \"once\" or \"always\""),
            (
                json!({ "statistics": 1 }),
                "the option `statistics` is `1`; give true or false or \"never\" or \"always\"",
            ),
            (
                json!({ "baseline": true }),
                "the option `baseline` is `true`; give the path of a file that --accept wrote, or null",
            ),
            (json!([1]), "the options are `[1]`; give an object, such as {\"units\": true}"),
            (json!({ "proofread": "x" }), "the options are `\"x\"`; give an object, such as {\"units\": true}"),
        ] {
            assert_eq!(Settings::default().changed_by(&given), (Settings::default(), vec![told.to_owned()]));
        }
        // The others count all the same.
        let (settings, wrong) = Settings::default().changed_by(&json!({ "a": 1, "doubts": true }));
        assert!(settings.doubts && wrong.len() == 1);
    }
}
