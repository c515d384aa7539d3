//! What the record says of one contestant at one tolerance, or of one map.

/// The columns. See `book/records/README.md`.
pub(crate) const COLUMNS: &str =
    "contestant,tolerance,runs,evaluations,milliseconds,true_error,points,threads,processor_milliseconds";

/// One line of the record; what a contestant does not have is left empty.
#[derive(Default)]
pub(crate) struct RecordLine {
    pub contestant: String,
    pub tolerance: f64,
    pub runs: Option<usize>,
    pub evaluations: Option<u64>,
    pub milliseconds: f64,
    pub true_error: Option<f64>,
    pub points: Option<usize>,
    pub threads: Option<u32>,
    pub processor_milliseconds: Option<f64>,
}

impl RecordLine {
    /// The fields, in the order of the columns.
    pub(crate) fn fields(&self) -> [String; 9] {
        fn some<T: ToString>(value: Option<T>) -> String {
            value.map_or_else(String::new, |value| value.to_string())
        }
        [
            self.contestant.clone(),
            format!("{:e}", self.tolerance),
            some(self.runs),
            some(self.evaluations),
            format!("{:.4}", self.milliseconds),
            self.true_error.map_or_else(String::new, |error| format!("{error:.3e}")),
            some(self.points),
            some(self.threads),
            self.processor_milliseconds.map_or_else(String::new, |time| format!("{time:.4}")),
        ]
    }
}
