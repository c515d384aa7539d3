//! The pages and programs that were read, each with its address and the day on which a stored copy of it was read.

use super::{Place, at, page};

// Calculators, encyclopedias, lessons and lists of mechanisms.
pub const KMODDL: Place = at(page!("http://kmoddl.library.cornell.edu/tutorials/06/"));
pub const COMPASS: Place = at(page!("http://mingyu.co.uk/blog/compass-and-straightedge-geneva-drive/"));
pub const SPECTRA: Place = at(page!("http://spectraquest.com/simulators/details/kad-gm/"));
pub const STATEMASTER: Place = at(page!("http://www.statemaster.com/encyclopedia/Geneva-drive"));
pub const STAR: Place = at(page!("https://everything2.com/title/Geneva+star", "2026-11-23"));
pub const SOURCEBOOK: Place =
    at(page!("https://fliphtml5.com/zroi/ibdn/Mechanisms_And_Mechanical_Devices_Sourcebook_-_3rd_ed/484"));
pub const HOLOOLY: Place = at(page!("https://holooly.com/?p=937608", "2026-11-23"));
pub const MECHA_EXTERNAL: Place =
    at(page!("https://mechamechanisms.com/external-geneva-and-epicyclic-gear-mechanism-1", "2026-11-23"));
pub const MECHA_INTERNAL: Place =
    at(page!("https://mechamechanisms.com/internal-geneva-and-epicyclic-gear-mechanism-1", "2026-11-23"));
pub const SIMULATOR: Place = at(page!("https://mechsimulator.com/tools/geneva-mechanism"));
pub const PROBSEE: Place = at(page!("https://probsee.com/p/Geneva_drive"));
pub const UNSEEL: Place = at(page!("https://unseel.com/engineering/geneva-drive"));
pub const WIKISUM: Place = at(page!("https://wikisum.wiki/wiki/Geneva_drive"));
pub const ARTOBOLEVSKY: Place = at(page!("https://www.dmg-lib.org/dmglib/main/portal.jsp?id=19274023"));
pub const EDGE: Place =
    at(page!("https://www.engineersedge.com/mechanics_machines/geneva_mechanism_design_equations__14919.htm"));
pub const CALCULATOR: Place = at(page!(
    "https://www.firgelliauto.com/blogs/engineering-calculators/geneva-mechanism-calculator-indexing-time-and-geometry",
    "2026-11-23"
));
pub const DRIVE: Place = at(page!("https://www.firgelliauto.com/blogs/mechanisms/geneva-drive"));
pub const INDEXING: Place = at(page!(
    "https://www.firgelliauto.com/en-nz/blogs/engineering-calculators/geneva-mechanism-calculator-indexing",
    "2026-11-23"
));
pub const MISCELLANEOUS: Place = at(page!("https://www.firgelliauto.com/en-pt/blogs/mechanisms/miscellaneous-form"));
pub const FIRGELLI_EXTERNAL: Place =
    at(page!("https://www.firgelliauto.com/es/blogs/mechanisms/geneva-drive-external"));

// Programs and their pages.
pub const MECHANICS: Place = at(page!(
    "https://github.com/DannyHsuC10/Mechanics/blob/HEAD/Mechanical_Principle/Other_components/Periodic_motion_mechanism/Periodic_motion_mechanism.md",
    "2026-11-23"
));
pub const COUNTER: Place = at(page!("https://github.com/FidelioScorpio/SCAD_auto_counter/blob/HEAD/geneva.scad"));
pub const MACRO: Place =
    at(page!("https://github.com/FreeCAD/FreeCAD-documentation/blob/HEAD/wiki/Macro_Geneva_Wheel.md", "2026-11-23"));
pub const WINDOW: Place = at(page!(
    "https://github.com/FreeCAD/FreeCAD-documentation/blob/HEAD/wiki/Macro_Geneva_Wheel_GUI.md",
    "2026-11-23"
));
pub const LINKAGE: Place = at(page!("https://github.com/MHSGhali/Linkage-Design/blob/HEAD/src/joints.c"));
pub const STYLE_SHEET_MEASURED: Place = at(page!("https://github.com/SAPTARSHI-coder/EaseMotion-css/pull/48586"));
pub const STYLE_SHEET: Place = at(page!("https://github.com/SAPTARSHI-coder/EaseMotion-css/pull/49683"));
pub const GENERATOR: Place =
    at(page!("https://github.com/SindiSekkas/geneva-drive-generator/blob/HEAD/src/geneva/params.ts", "2026-11-23"));
pub const COSMO: Place = at(page!("https://github.com/ascii-dresden/ascii-cosmo/blob/HEAD/openscad/geneva_drive.scad"));
pub const GENEVA_GEN: Place = at(page!("https://github.com/benbrandt22/genevaGen/blob/HEAD/genevaController.js"));
pub const CADBUILDR: Place = at(page!("https://github.com/cadbuildr/geneva-drive/blob/HEAD/src/geneva_drive/main.py"));
pub const TINKERCAD: Place = at(page!("https://github.com/champierre/geneva-drive-en/blob/HEAD/slides.md"));
pub const ANVILATE: Place =
    at(page!("https://github.com/clay-good/anvilate/blob/HEAD/src/anvilate/analysis/geneva.py", "2026-11-23"));
pub const CONSTRAINTS: Place = at(page!(
    "https://github.com/cool-japan/oxiphysics/blob/HEAD/crates/oxiphysics-constraints/src/mechanism/types.rs"
));
pub const RIGID: Place =
    at(page!("https://github.com/cool-japan/oxiphysics/blob/HEAD/crates/oxiphysics-rigid/src/mechanism_rigid.rs"));
pub const SDFX_EXAMPLE: Place =
    at(page!("https://github.com/deadsy/sdfx/blob/HEAD/examples/geneva/main.go", "2026-11-23"));
pub const SDFX: Place = at(page!("https://github.com/deadsy/sdfx/blob/HEAD/obj/geneva.go", "2026-11-23"));
pub const PITTER_DRIVER: Place =
    at(page!("https://github.com/edtechd/cherry-pitter/blob/HEAD/part_geneva_driver.py", "2026-11-23"));
pub const PITTER_WHEEL: Place =
    at(page!("https://github.com/edtechd/cherry-pitter/blob/HEAD/part_geneva_wheel.py", "2026-11-23"));
pub const WORKBENCH: Place =
    at(page!("https://github.com/iplayfast/GearWorkBench/blob/HEAD/genevaWheel.py", "2026-11-23"));
pub const OPENSCAD: Place =
    at(page!("https://github.com/tllilleh/openscad-geneva-drive/blob/HEAD/geneva-drive.scad", "2026-11-23"));
pub const MODEL3D: Place =
    at(page!("https://github.com/unixpickle/model3d/tree/HEAD/examples/experiments/geneva_drive"));

/// Where every formula was taken, and every number and sentence that says how many slots or steps there are, how long the
/// wheel moves and rests, or how large its parts are. Of all other pages single statements were taken. What an author is
/// free to choose is no statement, and of a calculator its formulas are meant, not the text around them.
pub const TAKEN_WHOLE: &[Place] = &[
    CALCULATOR,
    INDEXING,
    MECHA_EXTERNAL,
    MECHA_INTERNAL,
    MECHANICS,
    ANVILATE,
    MACRO,
    WINDOW,
    WORKBENCH,
    GENERATOR,
    OPENSCAD,
    SDFX,
    SDFX_EXAMPLE,
    PITTER_WHEEL,
    PITTER_DRIVER,
];
