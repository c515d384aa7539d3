//! The programs that answer this book's pages, compiled for WebAssembly: the figures that move, and the proofreader.

use geneva_press::book::{LaterModule, PageModule};

/// All modules.
pub(crate) const MODULES: &[PageModule] = &[
    PageModule {
        attributes: &["data-live", "data-given"],
        name: "live",
        package: "geneva-live",
        folder: "live",
        script: include_str!("../../../book/theme/live.js"),
        style: include_str!("../../../book/theme/live.css"),
        later: &[
            LaterModule { name: "live-design", package: "geneva-live-design", folder: "live-design" },
            LaterModule { name: "live-files", package: "geneva-live-files", folder: "live-files" },
        ],
    },
    PageModule {
        attributes: &["data-proofread"],
        name: "proofread",
        package: "geneva-proofread-page",
        folder: "proofread-page",
        script: include_str!("../../../book/theme/proofread.js"),
        style: include_str!("../../../book/theme/proofread.css"),
        later: &[],
    },
];
