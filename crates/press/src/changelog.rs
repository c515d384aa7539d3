//! A changelog as [Keep a Changelog](https://keepachangelog.com/en/1.1.0/) has it: releases with their days and sections.

/// A version and what changed with it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Release<'a> {
    /// The version.
    pub version: &'a str,
    /// Its day, as in 2026-11-28.
    pub date: &'a str,
    /// The sections: heading, and text in Markdown.
    pub sections: Vec<(&'a str, &'a str)>,
}

/// The releases of a changelog, in its order, which begins with the latest. What is unreleased has no day and isn't among them.
pub fn releases(changelog: &str) -> Vec<Release<'_>> {
    let texts = changelog.split("\n## [").skip(1);
    let release = |text| {
        let (head, text): (&str, &str) = str::split_once(text, '\n').unwrap_or((text, ""));
        let (version, date) = head.split_once("] - ")?;
        let section = |text| {
            let (heading, text) = str::split_once(text, '\n').unwrap_or((text, ""));
            (heading.trim(), text.trim())
        };
        let sections = text.split("\n### ").skip(1).map(section);
        Some(Release { version, date: date.trim(), sections: sections.collect() })
    };
    texts.filter_map(release).collect()
}

/// The day on which a version was released, if it has been.
pub fn release_date<'a>(changelog: &'a str, version: &str) -> Option<&'a str> {
    releases(changelog).into_iter().find(|release| release.version == version).map(|release| release.date)
}

/// The instant at which a day begins, as in 2026-11-28T00:00:00Z.
pub(crate) fn midnight(date: &str) -> String {
    format!("{date}T00:00:00Z")
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHANGELOG: &str = "# Changelog\n\n## [Unreleased]\n\n### Added\n\n- A.\n\n## [0.2.0] - 2026-11-28\n\nWords.\n\n### Verdicts\n\n- B.\n- C.\n\n\
                             ### Errata\n\n## [0.1.0] - 2026-11-25\n\nFirst.\n";

    #[test]
    fn releases_have_their_days_and_sections_and_what_is_unreleased_is_none() {
        let expected = [
            Release {
                version: "0.2.0",
                date: "2026-11-28",
                sections: vec![("Verdicts", "- B.\n- C."), ("Errata", "")],
            },
            Release { version: "0.1.0", date: "2026-11-25", sections: Vec::new() },
        ];
        assert_eq!(releases(CHANGELOG), expected);
        assert_eq!(release_date(CHANGELOG, "0.1.0"), Some("2026-11-25"));
        assert_eq!((release_date(CHANGELOG, "0.3.0"), releases("").len()), (None, 0));
    }
}
