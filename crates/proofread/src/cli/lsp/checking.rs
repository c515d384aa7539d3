//! The check of a document that an editor has open.

use super::super::baseline::Baseline;
use super::super::documents::is_xml;
use super::super::project::Project;
use super::settings::Settings;
use crate::check::{CheckOptions, proofread};
use crate::reader::TextFormat;
use crate::statistics::find_statistics;
use crate::tell::finding::ChainFinding;
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::Arc;

/// A text that is to be checked.
#[derive(Clone, Debug)]
pub(super) struct CheckJob {
    /// The address of the document.
    pub address: String,
    /// What the document was like when it was asked for; another number if the text or what is asked has changed.
    pub revision: u64,
    pub text: Arc<str>,
    pub format: TextFormat,
    pub file: Option<PathBuf>,
    /// The folder of the editor in which the file is.
    pub folder: Option<PathBuf>,
    /// The first folder of the editor, from which the file of accepted cases is named where the document is in none.
    pub top: Option<PathBuf>,
    /// All texts in LaTeX and XML that are open, with their files.
    pub open: Vec<(PathBuf, Arc<str>)>,
    pub settings: Settings,
}

/// A text with what was found in it.
#[derive(Clone, Debug)]
pub(super) struct CheckedText {
    pub text: Arc<str>,
    /// In the order of the text.
    pub findings: Vec<ChainFinding>,
}

/// What became of a job.
#[derive(Clone, Debug)]
pub(super) struct CheckOutcome {
    pub address: String,
    pub revision: u64,
    /// What was found, or why the text could not be checked.
    pub checked: Result<CheckedText, String>,
    /// Whether what open texts define for others has changed.
    pub definitions_changed: bool,
    /// Why the accepted cases cannot be read, if they cannot.
    pub baseline_error: Option<String>,
}

/// Whether other files may define something for a document, and it for them.
pub(super) fn is_in_project(format: TextFormat, file: &std::path::Path) -> bool {
    format == TextFormat::Latex || (format == TextFormat::Xml && is_xml(file))
}

/// The accepted cases that the settings name, if they name any.
fn accepted_cases(job: &CheckJob) -> Result<Option<Baseline>, String> {
    let Some(named) = &job.settings.baseline else { return Ok(None) };
    let folder = job.folder.as_ref().or(job.top.as_ref());
    let file = folder.map_or_else(|| named.clone(), |folder| folder.join(named));
    Baseline::read(&file).map(Some)
}

/// Checks documents one after the other, and remembers what their files define.
#[derive(Default)]
pub(super) struct Checker {
    project: Project,
}

impl Checker {
    /// Checks a document.
    pub(super) fn check(&mut self, job: &CheckJob) -> CheckOutcome {
        let mut definitions = None;
        let mut definitions_changed = false;
        if let Some(file) = job.file.as_deref().filter(|file| is_in_project(job.format, file)) {
            let real = |(file, text): &(PathBuf, Arc<str>)| Some((file.canonicalize().ok()?, text.clone()));
            let open: HashMap<PathBuf, Arc<str>> = job.open.iter().filter_map(real).collect();
            definitions_changed = self.project.renew(open);
            self.project.add(file, job.folder.as_deref());
            definitions = self.project.definitions(file);
        }
        let (mut baseline, baseline_error) = match accepted_cases(job) {
            Ok(baseline) => (baseline, None),
            Err(why) => (None, Some(why)),
        };
        let options = CheckOptions {
            name_policy: job.settings.name_policy,
            definitions: definitions.as_deref(),
            ..CheckOptions::default()
        };
        let mut found = || {
            let mut report = proofread(&job.text, job.format, options)?;
            if job.settings.statistics {
                find_statistics(&job.text, job.format)?.add_to(&mut report);
            }
            report.findings.retain(|finding| job.settings.lists(finding.section));
            if let (Some(baseline), Some(file)) = (&mut baseline, &job.file) {
                let name = file.display().to_string();
                report.findings.retain(|finding| !baseline.is_accepted(&name, Some(file), finding));
            }
            Ok(CheckedText { text: job.text.clone(), findings: report.findings })
        };
        let checked = found().map_err(|why: crate::reader::UnreadableText| why.to_string());
        CheckOutcome {
            address: job.address.clone(),
            revision: job.revision,
            checked,
            definitions_changed,
            baseline_error,
        }
    }
}
