//! The open claims, by what they lack.

use geneva_press::book::OpenGroup;

/// All groups. The page of open questions says of each what we tried and what would settle it.
pub(crate) const OPEN_GROUPS: &[OpenGroup] = &[
    OpenGroup {
        name: "rise-times",
        title: "What is a rise time?",
        ids: &[
            "meyer.app-e.*.rise",
            "meyer.fig-8.rise",
            "meyer.fig-10.rise-axis",
            "meyer.more-torque",
            "meyer.less-friction",
        ],
    },
    OpenGroup {
        name: "drawings",
        title: "Drawings that are not in our copies",
        ids: &[
            "pin.problem-figure",
            "pin.triangle-drawings",
            "quick-return.figure",
            "quick-return.sense-of-sliding",
            "quick-return.lever-acceleration-sense",
            "jazar.fig-5.28-drawing",
            "jazar.fig-5.29-drawing",
            "jazar.fig-5.30",
            "jazar.fig-5.31-drawing",
            "meyer.fig-1",
            "meyer.fig-2",
            "meyer.fig-3",
            "meyer.fig-4",
            "meyer.fig-5",
            "meyer.triangle-drawing",
            "meyer.fig-6",
            "meyer.fig-7",
            "meyer.fig-8",
            "meyer.fig-9",
            "meyer.fig-10",
            "meyer.fig-11",
            "meyer.fig-12",
            "meyer.fig-13",
            "meyer.fig-14",
            "meyer.fig-15",
        ],
    },
    OpenGroup {
        name: "mimic-of-1973",
        title: "What the MIMIC of 1973 could do",
        ids: &[
            "meyer.app-b.must-be-solved",
            "meyer.app-b.simultaneous",
            "meyer.app-b.first-seven-cards",
            "meyer.app-b.delay",
            "meyer.listing.delay-third",
            "meyer.app-d.needed",
        ],
    },
    OpenGroup {
        name: "words",
        title: "Words without a measure",
        ids: &["jazar.most-stations", "jazar.spherical-locking", "meyer.always-engaged", "meyer.small-variations"],
    },
    OpenGroup {
        name: "pages-and-sizes",
        title: "Page numbers and sizes that are not given",
        ids: &["meyer.contents", "meyer.list-of-figures", "meyer.page-of-definition", "meyer.app-c.turns"],
    },
];
