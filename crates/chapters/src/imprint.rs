//! What this book says of itself.

use geneva_press::imprint::Imprint;

/// Title, authors, version and licences.
pub(crate) const IMPRINT: Imprint = Imprint {
    title: "Geneva, verified",
    subtitle: "Four texts on Geneva-type mechanisms, computed again",
    authors: "The authors of Geneva, verified",
    key: "geneva-verified",
    summary: &[
        "A book about Geneva mechanisms in which every number, equation, figure and statement of its sources that can be",
        "checked has a verdict, which a test derives.",
    ],
    request: &[
        "If you use a verdict or a number of this book, please cite it. Its text,",
        "figures and data are under CC BY 4.0, its programs under MIT or Apache 2.0.",
    ],
    keywords: &["Geneva mechanism", "intermittent motion", "kinematics", "reproducibility"],
    version: env!("CARGO_PKG_VERSION"),
    licence: "CC-BY-4.0",
    licence_words: "CC BY 4.0",
    licence_address: "https://creativecommons.org/licenses/by/4.0/",
    program_licences: &["MIT", "Apache-2.0"],
    homepage: env!("CARGO_PKG_HOMEPAGE"),
    repository: env!("CARGO_PKG_REPOSITORY"),
    program: "geneva",
    compiled_from: option_env!("GENEVA_COMMIT"),
};
