//! The programs that answer this book's pages, compiled for WebAssembly: the figures that move, and the proofreader.

use geneva_press::book::PageModule;

/// All modules.
pub(crate) const MODULES: &[PageModule] = &[
    PageModule {
        attributes: &["data-live", "data-given"],
        name: "live",
        package: "geneva-live",
        folder: "live",
        script: include_str!("../../../book/theme/live.js"),
        style: include_str!("../../../book/theme/live.css"),
    },
    PageModule {
        attributes: &["data-proofread"],
        name: "proofread",
        package: "geneva-proofread-page",
        folder: "proofread-page",
        script: include_str!("../../../book/theme/proofread.js"),
        style: include_str!("../../../book/theme/proofread.css"),
    },
];
