//! What readers search for that this book calls otherwise.

use geneva_press::synonyms::Synonym;

const fn synonym(typed: &'static str, meant: &'static [&'static str]) -> Synonym {
    Synonym { typed, meant }
}

/// Words that may be typed, and the words of the pages to which they lead.
pub(crate) const SYNONYMS: &[Synonym] = &[
    // The mechanisms.
    synonym("maltese cross", &["Geneva wheel"]),
    synonym("star wheel", &["Geneva wheel"]),
    synonym("geneva drive", &["Geneva wheel"]),
    synonym("geneva mechanism", &["Geneva wheel"]),
    synonym("geneva cross", &["Geneva wheel"]),
    synonym("whitworth", &["quick-return"]),
    synonym("shaper", &["quick-return"]),
    synonym("crank slider", &["quick-return"]),
    synonym("slotted lever", &["quick-return"]),
    synonym("slots", &["stations"]),
    synonym("center", &["centre"]),
    // What the book can do.
    synonym("calculator", &["live figure", "live figure wheel driver scale"]),
    synonym("simulator", &["live figure"]),
    synonym("simulation", &["live figure"]),
    synonym("animation", &["live figure"]),
    synonym("interactive", &["live figure"]),
    synonym("download", &["drawing for the machine", "files", "data"]),
    synonym("cad", &["DXF"]),
    synonym("drawing", &["DXF"]),
    synonym("laser cutter", &["DXF"]),
    synonym("3d print", &["STL", "OpenSCAD"]),
    synonym("3d printer", &["STL", "OpenSCAD"]),
    // The book itself.
    synonym("how to use this book", &["where to start"]),
    synonym("how to read this book", &["where to start"]),
    synonym("re-run", &["check it yourself"]),
    synonym("rerun", &["check it yourself"]),
    synonym("reproduce", &["check it yourself"]),
    synonym("homework", &["your numbers"]),
    synonym("check my homework", &["your numbers"]),
    synonym("citation", &["cite"]),
    synonym("reference", &["cite"]),
    synonym("pdf", &["on paper"]),
    synonym("typo", &["errata"]),
];
