//! Two files of values: both must round to what is printed.

use crate::Project;
use geneva_values::FindingKind;

fn project(second: &str) -> Project {
    let project = Project::new("a.md", "The period is 2.006 s.", r#"{"period": 2.0064}"#);
    project.write("second.json", second);
    project.record();
    project
}

#[test]
fn two_values_that_agree_are_right() {
    assert_eq!(project(r#"{"period": 2.00639}"#).right(), 1);
}

#[test]
fn two_values_that_disagree_are_open() {
    for second in [r#"{"period": 2.0066}"#, r#"{"other": 1}"#] {
        assert_eq!(project(second).differing(), ["open 2.006"]);
    }
}

#[test]
fn two_values_that_agree_on_another_number_make_the_printed_one_wrong() {
    let project = project(r#"{"period": 2.1006}"#);
    project.change("values.json", "2.0064", "2.1009");
    // One rounds to 2.101 as the other does.
    let report = project.check();
    assert_eq!(report.findings[0].kind, FindingKind::Stale);
    assert!(report.findings[0].message.ends_with("write 2.101 s; the second value 2.1006 agrees"));
    project.change("values.json", "2.1009", "2.2");
    assert_eq!(project.differing(), ["open 2.006"]);
}
