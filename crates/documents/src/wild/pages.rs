//! The pages and programs that were read, each with its address and the day on which a stored copy of it was read. The
//! address of a file in a repository names a commit in which the file has the statements.

use super::{Locator, at, page};

// Calculators, encyclopedias, lessons and lists of mechanisms.
pub(super) const KMODDL: Locator = at(page!("http://kmoddl.library.cornell.edu/tutorials/06/"));
pub(super) const COMPASS: Locator = at(page!("http://mingyu.co.uk/blog/compass-and-straightedge-geneva-drive/"));
pub(super) const SPECTRA: Locator = at(page!("http://spectraquest.com/simulators/details/kad-gm/"));
pub(super) const STATEMASTER: Locator = at(page!("http://www.statemaster.com/encyclopedia/Geneva-drive"));
pub(super) const STAR: Locator = at(page!("https://everything2.com/title/Geneva+star", "2026-11-23"));
pub(super) const SOURCEBOOK: Locator =
    at(page!("https://fliphtml5.com/zroi/ibdn/Mechanisms_And_Mechanical_Devices_Sourcebook_-_3rd_ed/484"));
pub(super) const HOLOOLY: Locator = at(page!("https://holooly.com/?p=937608", "2026-11-23"));
pub(super) const MECHA_EXTERNAL: Locator =
    at(page!("https://mechamechanisms.com/external-geneva-and-epicyclic-gear-mechanism-1", "2026-11-23"));
pub(super) const MECHA_INTERNAL: Locator =
    at(page!("https://mechamechanisms.com/internal-geneva-and-epicyclic-gear-mechanism-1", "2026-11-23"));
pub(super) const SIMULATOR: Locator = at(page!("https://mechsimulator.com/tools/geneva-mechanism"));
pub(super) const PROBSEE: Locator = at(page!("https://probsee.com/p/Geneva_drive"));
pub(super) const UNSEEL: Locator = at(page!("https://unseel.com/engineering/geneva-drive"));
pub(super) const WIKISUM: Locator = at(page!("https://wikisum.wiki/wiki/Geneva_drive"));
pub(super) const ARTOBOLEVSKY: Locator = at(page!("https://www.dmg-lib.org/dmglib/main/portal.jsp?id=19274023"));
pub(super) const EDGE: Locator =
    at(page!("https://www.engineersedge.com/mechanics_machines/geneva_mechanism_design_equations__14919.htm"));
pub(super) const CALCULATOR: Locator = at(page!(
    "https://www.firgelliauto.com/blogs/engineering-calculators/geneva-mechanism-calculator-indexing-time-and-geometry",
    "2026-11-23"
));
pub(super) const DRIVE: Locator = at(page!("https://www.firgelliauto.com/blogs/mechanisms/geneva-drive"));
pub(super) const INDEXING: Locator = at(page!(
    "https://www.firgelliauto.com/en-nz/blogs/engineering-calculators/geneva-mechanism-calculator-indexing",
    "2026-11-23"
));
pub(super) const MISCELLANEOUS: Locator =
    at(page!("https://www.firgelliauto.com/en-pt/blogs/mechanisms/miscellaneous-form"));
pub(super) const FIRGELLI_EXTERNAL: Locator =
    at(page!("https://www.firgelliauto.com/es/blogs/mechanisms/geneva-drive-external"));

// Programs and their pages.
pub(super) const MECHANICS: Locator = at(page!(
    "https://github.com/DannyHsuC10/Mechanics/blob/d83de61a37cf5d2c4c17e8eadabaeb132e27400b/Mechanical_Principle/Other_components/Periodic_motion_mechanism/Periodic_motion_mechanism.md",
    "2026-11-23"
));
pub(super) const COUNTER: Locator = at(page!(
    "https://github.com/FidelioScorpio/SCAD_auto_counter/blob/4a26660c442179a6a48f1424775ad25a1943b4fd/geneva.scad"
));
pub(super) const MACRO: Locator = at(page!(
    "https://github.com/FreeCAD/FreeCAD-documentation/blob/1ce7aa9e6881a88162ba55b22683ddd08c363325/wiki/Macro_Geneva_Wheel.md",
    "2026-11-23"
));
pub(super) const WINDOW: Locator = at(page!(
    "https://github.com/FreeCAD/FreeCAD-documentation/blob/1b0bbc679083e2c9883c7a69c13de9d84021787c/wiki/Macro_Geneva_Wheel_GUI.md",
    "2026-11-23"
));
pub(super) const LINKAGE: Locator =
    at(page!("https://github.com/MHSGhali/Linkage-Design/blob/56d497985f76503a557ec040e3414b660e85d528/src/joints.c"));
pub(super) const STYLE_SHEET_MEASURED: Locator =
    at(page!("https://github.com/SAPTARSHI-coder/EaseMotion-css/pull/48586"));
pub(super) const STYLE_SHEET: Locator = at(page!("https://github.com/SAPTARSHI-coder/EaseMotion-css/pull/49683"));
pub(super) const GENERATOR: Locator = at(page!(
    "https://github.com/SindiSekkas/geneva-drive-generator/blob/77c5c2075b2e14322c45efbccb34f64bf2d638ff/src/geneva/params.ts",
    "2026-11-23"
));
pub(super) const COSMO: Locator = at(page!(
    "https://github.com/ascii-dresden/ascii-cosmo/blob/a3c0474f8f752f6587bfead8267c819de29b6821/openscad/geneva_drive.scad"
));
pub(super) const GENEVA_GEN: Locator = at(page!(
    "https://github.com/benbrandt22/genevaGen/blob/64356d565724b94113c0ec6923a92a5478f34ed9/genevaController.js"
));
pub(super) const CADBUILDR: Locator = at(page!(
    "https://github.com/cadbuildr/geneva-drive/blob/4296428cf75b22f95557a0bd3d7741767790e8be/src/geneva_drive/main.py"
));
pub(super) const TINKERCAD: Locator =
    at(page!("https://github.com/champierre/geneva-drive-en/blob/4b9522dc1db80834210b17ab3ccc9c2d8d8137e0/slides.md"));
pub(super) const ANVILATE: Locator = at(page!(
    "https://github.com/clay-good/anvilate/blob/05a33cd3b5776f2365d9608fb6bb134e23545e1a/src/anvilate/analysis/geneva.py",
    "2026-11-23"
));
pub(super) const CONSTRAINTS: Locator = at(page!(
    "https://github.com/cool-japan/oxiphysics/blob/503075b79824187d6566590f5b57b2ce279b6efc/crates/oxiphysics-constraints/src/mechanism/types.rs"
));
pub(super) const RIGID: Locator = at(page!(
    "https://github.com/cool-japan/oxiphysics/blob/503075b79824187d6566590f5b57b2ce279b6efc/crates/oxiphysics-rigid/src/mechanism_rigid.rs"
));
pub(super) const SDFX_EXAMPLE: Locator = at(page!(
    "https://github.com/deadsy/sdfx/blob/56ab4e6fd349485805386cffbfc22ae35f847aca/examples/geneva/main.go",
    "2026-11-23"
));
pub(super) const SDFX: Locator = at(page!(
    "https://github.com/deadsy/sdfx/blob/56ab4e6fd349485805386cffbfc22ae35f847aca/obj/geneva.go",
    "2026-11-23"
));
pub(super) const PITTER_DRIVER: Locator = at(page!(
    "https://github.com/edtechd/cherry-pitter/blob/350d4d349dbd3ff7208e0b42e39648ecefe1a4ef/part_geneva_driver.py",
    "2026-11-23"
));
pub(super) const PITTER_WHEEL: Locator = at(page!(
    "https://github.com/edtechd/cherry-pitter/blob/48f748021a8c753ddba01da2a21d7f42686136ca/part_geneva_wheel.py",
    "2026-11-23"
));
pub(super) const WORKBENCH: Locator = at(page!(
    "https://github.com/iplayfast/GearWorkBench/blob/ff7c6851f8471eb6a1b1e419b8f90c901969ca82/genevaWheel.py",
    "2026-11-23"
));
pub(super) const OPENSCAD: Locator = at(page!(
    "https://github.com/tllilleh/openscad-geneva-drive/blob/73abfa533a0fb5c765925ecd049629a32e6a1507/geneva-drive.scad",
    "2026-11-23"
));
pub(super) const MODEL3D: Locator = at(page!(
    "https://github.com/unixpickle/model3d/tree/72c6b62231c41972124f48190ee82bcd0ac0bfda/examples/experiments/geneva_drive"
));

/// Where every formula was taken, and every number and sentence that says how many slots or steps there are, how long the
/// wheel moves and rests, or how large its parts are. Of all other pages single statements were taken. What an author is
/// free to choose is no statement, nor is a limit on it, and of a calculator its formulas are meant, not the text around them.
pub const TAKEN_WHOLE: &[Locator] = &[
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

/// What was read of a repository, file or folder, by the identifier of its content: that of the Software Heritage archive, which
/// git computes too. Files that were read without their repository have none.
pub const CONTENTS: &[(Locator, &str)] = &[
    (MECHANICS, "swh:1:cnt:6bc9ee70a24401576439889e8fdf1ce5438c0f45"),
    (COUNTER, "swh:1:cnt:0fe922011a59bd3689eb7e118ba1c7f346a80022"),
    (GENERATOR, "swh:1:cnt:53c13553ddfebcf6c9674549a317ed52b2b32d75"),
    (COSMO, "swh:1:cnt:f38b730a2ab2e5ff6ed0caee11a13fa14c675d95"),
    (GENEVA_GEN, "swh:1:cnt:fb526ac866ed68aa502ccc7e00e36f78d8867eee"),
    (CADBUILDR, "swh:1:cnt:1fb332275b21d20971f32991dc4a7c56ccdf643f"),
    (TINKERCAD, "swh:1:cnt:9a869f092e33949acf18429ae68031a1be1aa764"),
    (ANVILATE, "swh:1:cnt:8b30acb650d42402c762ba6f17fb884514e8782a"),
    (SDFX_EXAMPLE, "swh:1:cnt:e5a40f44fdc7e6348d9c37aed5de2ec467842a2e"),
    (SDFX, "swh:1:cnt:c89d14c3c2ad36f69d22c1985d923d5aff99b61b"),
    (WORKBENCH, "swh:1:cnt:40a96755bd4eaa49bd76ff23d492254b16883870"),
    (OPENSCAD, "swh:1:cnt:4ee18b86d8ed0f4e6d090c4817b802f7fa8eb6fa"),
    (MODEL3D, "swh:1:dir:9b5ea79e5db23c1b90a5f5c7b393d0fe82438193"),
];
