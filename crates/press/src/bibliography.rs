//! The works of others on which a sentence of the book leans. The four documents that the book checks are no part of it.
//!
//! A work is cited where a sentence needs it and listed once, on the page of sources. We give only what we have read of a
//! work's details, and say where and when.

use crate::fields::DataRow;
use crate::html::escape;
use crate::lookup;
use anyhow::{Context, ensure};

/// The page that lists the works.
const PAGE: &str = "about";
/// The day on which we read the details of all works.
const READ_ON: &str = "2026-11-26";

/// A work of others.
struct Work {
    /// By which a chapter cites it.
    key: &'static str,
    /// As a citation names the authors.
    short: &'static str,
    /// All authors, or the body that published it.
    authors: &'static str,
    title: &'static str,
    /// Publisher, journal with volume and pages, or what kind of page it is.
    published: &'static str,
    /// The year, empty where the work has none.
    year: &'static str,
    /// Its address, empty where we know none.
    address: &'static str,
    /// Where we read these details.
    read: &'static str,
}

/// All works, by the names of their authors.
const WORKS: &[Work] = &[
    Work {
        key: "alon",
        short: "Alon",
        authors: "N. Alon",
        title: "Combinatorial Nullstellensatz",
        published: "Combinatorics, Probability and Computing",
        year: "1999",
        address: "",
        read: "Documentation of Lean's library mathlib, Mathlib.Combinatorics.Nullstellensatz",
    },
    Work {
        key: "bickford",
        short: "Bickford",
        authors: "J. H. Bickford",
        title: "Mechanisms for Intermittent Motion",
        published: "Industrial Press, New York",
        year: "1972",
        address: "",
        read: "Reference list of a public repository, which also names the chapter on Geneva mechanisms",
    },
    Work {
        key: "blumenthal",
        short: "Blumenthal and Nosonovsky",
        authors: "A. S. Blumenthal and M. Nosonovsky",
        title: "Friction and Dynamics of Verge and Foliot: How the Invention of the Pendulum Made Clocks Much More Accurate",
        published: "Applied Mechanics 1, no. 2, pages 111–122",
        year: "2020",
        address: "https://doi.org/10.3390/applmech1020008",
        read: "Abstract at https://www.mdpi.com/2673-3161/1/2/8",
    },
    Work {
        key: "britannica",
        short: "Britannica",
        authors: "Encyclopædia Britannica",
        title: "Clocks",
        published: "ninth edition, volume 6",
        year: "",
        address: "https://en.wikisource.org/wiki/Page:Encyclop%C3%A6dia_Britannica,_Ninth_Edition,_v._6.djvu/38",
        read: "https://en.m.wikisource.org/wiki/Page:Encyclop%C3%A6dia_Britannica,_Ninth_Edition,_v._6.djvu/38",
    },
    Work {
        key: "shigley",
        short: "Budynas and Nisbett",
        authors: "R. G. Budynas and J. K. Nisbett",
        title: "Shigley's Mechanical Engineering Design",
        published: "tenth edition, McGraw-Hill Education",
        year: "2015",
        address: "",
        read: "Title page of the tenth edition in a copy at slideshare.net; the publisher's slides for it",
    },
    Work {
        key: "canter",
        short: "Canter",
        authors: "A. Canter",
        title: "The Greatest Horological Inventions of All Time: the Pendulum Clock and Improving the Accuracy of Timekeeping",
        published: "Worn & Wound, a magazine",
        year: "",
        address: "https://wornandwound.com/the-greatest-horological-inventions-of-all-time-the-pendulum-clock-and-improving-the-accuracy-of-timekeeping",
        read: "The beginning of the page at its address",
    },
    Work {
        key: "champneys",
        short: "Champneys and Várkonyi",
        authors: "A. R. Champneys and P. L. Várkonyi",
        title: "The Painlevé paradox in contact mechanics",
        published: "arXiv:1601.03545",
        year: "2016",
        address: "https://arxiv.org/abs/1601.03545",
        read: "https://ar5iv.labs.arxiv.org/html/1601.03545; the year by the number at arXiv",
    },
    Work {
        key: "concast",
        short: "Concast",
        authors: "Concast Metal Products",
        title: "C51000: phosphor bronze 5 % A",
        published: "Data sheet",
        year: "",
        address: "https://www.concast.com/c51000.php",
        read: "https://www.concast.com/c51000.php",
    },
    Work {
        key: "kmoddl",
        short: "Cornell",
        authors: "Cornell University Library",
        title: "Model 052, Geneva Movement",
        published: "Kinematic Models for Design Digital Library (KMODDL)",
        year: "2005",
        address: "http://kmoddl.library.cornell.edu/model.php?m=481",
        read: "http://kmoddl.library.cornell.edu/model.php?m=481",
    },
    Work {
        key: "dooner",
        short: "Dooner, Palermo and Mundo",
        authors: "D. B. Dooner, A. Palermo and D. Mundo",
        title: "An intermittent motion mechanism incorporating a Geneva wheel and a gear train",
        published: "Transactions of the Canadian Society for Mechanical Engineering 38, no. 3",
        year: "2014",
        address: "",
        read: "First page in copies at scribd.com and fdocuments.in",
    },
    Work {
        key: "dormand",
        short: "Dormand and Prince",
        authors: "J. R. Dormand and P. J. Prince",
        title: "A family of embedded Runge-Kutta formulae",
        published: "Journal of Computational and Applied Mathematics 6, no. 1, pages 19–26",
        year: "1980",
        address: "https://doi.org/10.1016/0771-050X(80)90013-3",
        read: "Reference lists of several public repositories, which agree",
    },
    Work {
        key: "everything2",
        short: "Everything2",
        authors: "Everything2",
        title: "Centrifugal friction device",
        published: "a page of the encyclopedia",
        year: "",
        address: "https://everything2.com/title/centrifugal+friction+device",
        read: "https://everything2.com/title/centrifugal+friction+device",
    },
    Work {
        key: "grossmann",
        short: "Grossmann",
        authors: "M. Grossmann",
        title: "Prize Essay on the Construction of a Simple but Mechanically Perfect Watch",
        published: "translated by R. Watkins, Kingston, Tasmania",
        year: "2002",
        address: "http://watkinsr.id.au/grossman.html",
        read: "Title page and contents in a copy at scribd.com, document 35165668; the translator's page at the address",
    },
    Work {
        key: "hahn",
        short: "Hahn",
        authors: "E. Hahn",
        title: "Coefficients of Friction for Various Horological Materials",
        published: "TimeZone, a forum; he quotes the CRC Handbook",
        year: "2000",
        address: "http://people.timezone.com/library/tmachine/tmachine631687701628067249",
        read: "http://people.timezone.com/library/tmachine/tmachine631687701628067249",
    },
    Work {
        key: "hasty",
        short: "Hasty and Potts",
        authors: "C. E. Hasty and J. F. Potts",
        title: "Analysis and Synthesis Procedures for Geneva Mechanism Design",
        published: "a paper, of which we know neither journal nor year",
        year: "",
        address: "",
        read: "First page in a copy at cupdf.com",
    },
    Work {
        key: "hoyng",
        short: "Hoyng and Nieuwenhuizen",
        authors: "P. Hoyng and A. C. T. Nieuwenhuizen",
        title: "Dynamics of the verge and foliot clock escapement",
        published: "arXiv:1604.06681",
        year: "2016",
        address: "https://arxiv.org/abs/1604.06681",
        read: "Abstract at https://www.emergentmind.com/papers/1604.06681; the year by the number at arXiv",
    },
    Work {
        key: "iso-2768",
        short: "ISO 2768-1",
        authors: "International Organization for Standardization",
        title: "ISO 2768-1: General tolerances – Part 1: Tolerances for linear and angular dimensions without individual \
                tolerance indications",
        published: "first edition",
        year: "1989",
        address: "",
        read: "https://pacificcert.com/iso-2768/; its table 1 in a copy of DIN ISO 2768-1 at scribd.com",
    },
    Work {
        key: "iso-286",
        short: "ISO 286-1",
        authors: "International Organization for Standardization",
        title: "ISO 286-1: Geometrical product specifications (GPS) – ISO code system for tolerances on linear sizes – \
                Part 1: Basis of tolerances, deviations and fits",
        published: "second edition",
        year: "2010",
        address: "",
        read: "http://to-pdf.com/iso-286-1 and https://standards.globalspec.com/std/1257201/en-iso-286-1",
    },
    Work {
        key: "iso-3159",
        short: "ISO 3159",
        authors: "International Organization for Standardization",
        title: "ISO 3159: Timekeeping instruments – Wrist-chronometers with spring balance oscillator",
        published: "second edition",
        year: "2009",
        address: "",
        read: "Title page in a copy at 123doc.top; criteria at https://www.observatoirechronometrique.ch/en/chronometre.html",
    },
    Work {
        key: "johnson",
        short: "Johnson",
        authors: "K. L. Johnson",
        title: "Contact Mechanics",
        published: "Cambridge University Press, Cambridge",
        year: "1985",
        address: "",
        read: "Reference list at globalauthorid.com; contents at https://www.twirpx.club/file/760701",
    },
    Work {
        key: "mechanisms-club",
        short: "Mechanisms.club",
        authors: "Mechanisms.club",
        title: "Speed control of spring motor",
        published: "a page with a moving drawing",
        year: "",
        address: "https://mechanisms.club/video/speed_control_of_spring_motor/",
        read: "https://mechanisms.club/video/speed_control_of_spring_motor/",
    },
    Work {
        key: "menezes",
        short: "Menezes, Kishore and Kailas",
        authors: "P. L. Menezes, Kishore and S. V. Kailas",
        title: "Influence of roughness parameters on coefficient of friction under lubricated conditions",
        published: "Sādhanā 33, part 3, pages 181–190",
        year: "2008",
        address: "https://www.ias.ac.in/describe/article/sadh/033/03/0181-0190",
        read: "Abstract at the address, and in a copy at https://studylib.net/doc/13482417",
    },
    Work {
        key: "nuijten",
        short: "Nuijten et al.",
        authors: "M. B. Nuijten, C. H. J. Hartgerink, M. A. L. M. van Assen, S. Epskamp and J. M. Wicherts",
        title: "The prevalence of statistical reporting errors in psychology (1985–2013)",
        published: "Behavior Research Methods 48, no. 4, pages 1205–1226",
        year: "2016",
        address: "https://doi.org/10.3758/s13428-015-0664-2",
        read: "https://link.springer.com/article/10.3758/s13428-015-0664-2; pages by several reference lists, which agree",
    },
    Work {
        key: "physics-fundamentals",
        short: "Physics Fundamentals",
        authors: "eCampusOntario",
        title: "Physics Fundamentals, Appendix A: Friction Coefficients for some Common Materials and Materials Combinations",
        published: "Pressbooks",
        year: "",
        address: "https://ecampusontario.pressbooks.pub/physicsfundamentals/back-matter/appendix",
        read: "https://ecampusontario.pressbooks.pub/physicsfundamentals/back-matter/appendix",
    },
    Work {
        key: "sansom",
        short: "Sansom",
        authors: "F. J. Sansom",
        title: "MIMIC Programming Manual",
        published: "184 pages",
        year: "1967",
        address: "https://books.google.com/books?id=cO4RAQAAMAAJ",
        read: "Record cO4RAQAAMAAJ of Google Books, as stored in a public repository",
    },
    Work {
        key: "strogatz",
        short: "Strogatz",
        authors: "S. H. Strogatz",
        title: "Nonlinear Dynamics and Chaos",
        published: "second edition, Westview Press, Boulder",
        year: "2015",
        address: "",
        read: "Reference lists of several public repositories, which agree",
    },
    Work {
        key: "trefethen",
        short: "Trefethen",
        authors: "L. N. Trefethen",
        title: "Is Gauss quadrature better than Clenshaw–Curtis?",
        published: "SIAM Review 50, no. 1, pages 67–87",
        year: "2008",
        address: "",
        read: "First page at https://esdocs.com/doc/510819; volume and pages by several reference lists, which agree",
    },
    Work {
        key: "sjx",
        short: "Watches by SJX",
        authors: "Watches by SJX",
        title: "Monday Lessons: Explaining the Ups and Downs of Constant Force Mechanisms in Mechanical Movements",
        published: "a page of the magazine",
        year: "2015",
        address: "https://watchesbysjx.com/2015/08/10",
        read: "The beginning of the page at its address, which also gives the year",
    },
    Work {
        key: "wikipedia-geneva",
        short: "Wikipedia, Geneva drive",
        authors: "Wikipedia",
        title: "Geneva drive",
        published: "a page of the encyclopedia",
        year: "",
        address: "https://en.wikipedia.org/wiki/Geneva_drive",
        read: "An earlier version of the page at http://www.statemaster.com/encyclopedia/Geneva-drive",
    },
    Work {
        key: "wikipedia-mimic",
        short: "Wikipedia, MIMIC",
        authors: "Wikipedia",
        title: "MIMIC",
        published: "a page of the encyclopedia",
        year: "",
        address: "https://en.wikipedia.org/wiki/MIMIC",
        read: "Copies of the page, among them http://theinfolist.com/html/ALL/s/M/MIMIC.html",
    },
    Work {
        key: "wikipedia-verge",
        short: "Wikipedia, Verge escapement",
        authors: "Wikipedia",
        title: "Verge escapement",
        published: "a page of the encyclopedia",
        year: "",
        address: "https://en.wikipedia.org/wiki/Verge_escapement",
        read: "Copies of the page at https://wikimili.com/wiki/Verge_escapement and, on the accuracy of early clocks, \
               https://wikisum.wiki/wiki/Verge_and_foliot; on the fusee, https://liquisearch.com/verge_escapement/decline",
    },
];

fn by_key(key: &str) -> anyhow::Result<&'static Work> {
    let found = WORKS.iter().find(|work| work.key == key);
    found.ok_or_else(|| lookup::unknown("work", key, WORKS.iter().map(|work| work.key)))
}

/// A citation that leads to the list, for example `[Johnson, 1985, chapter 6]`. What comes after a semicolon says where in
/// the work.
pub fn cite(argument: &str) -> anyhow::Result<String> {
    let (key, place) = argument.split_once(';').map_or((argument, ""), |(key, place)| (key, place));
    let work = by_key(key.trim())?;
    let parts = [work.short, work.year, place.trim()].into_iter().filter(|part| !part.is_empty());
    let said = escape(&parts.collect::<Vec<_>>().join(", "));
    Ok(format!("<a class=\"cite\" href=\"{PAGE}.html#work-{}\">&#91;{said}&#93;</a>", work.key))
}

/// The list of all works.
pub fn list() -> anyhow::Result<String> {
    let items = WORKS.iter().map(|work| {
        let title = escape(work.title);
        let title =
            if work.address.is_empty() { title } else { format!("<a href=\"{}\">{title}</a>", escape(work.address)) };
        let year = if work.year.is_empty() { String::new() } else { format!(", {}", work.year) };
        let (authors, published) = (escape(work.authors), escape(work.published));
        format!("<li id=\"work-{}\">{authors}: <em>{title}</em>, {published}{year}</li>", work.key)
    });
    Ok(format!("<ul class=\"works\">\n{}\n</ul>", items.collect::<Vec<_>>().join("\n")))
}

/// The list as data, with where and when we read each work's details.
pub fn rows() -> impl Iterator<Item = DataRow> {
    WORKS.iter().map(|work| {
        DataRow(vec![
            ("key", work.key.into()),
            ("authors", work.authors.into()),
            ("title", work.title.into()),
            ("published", work.published.into()),
            ("year", work.year.into()),
            ("address", work.address.into()),
            ("read_at", work.read.into()),
            ("read_on", READ_ON.into()),
        ])
    })
}

/// Holds the citations of all chapters against the list: each is in it, and each work is cited.
pub fn check<'a>(chapters: impl IntoIterator<Item = &'a str>) -> anyhow::Result<()> {
    let mut cited = Vec::new();
    for chapter in chapters {
        for rest in chapter.split("{{cite:").skip(1) {
            let (argument, _) = rest.split_once("}}").context("a citation has no end")?;
            cited.push(by_key(argument.split(';').next().unwrap_or_default().trim())?.key);
        }
    }
    let idle: Vec<_> = WORKS.iter().map(|work| work.key).filter(|key| !cited.contains(key)).collect();
    ensure!(
        idle.is_empty(),
        "no chapter cites {}: cite it where a sentence leans on it, or take it off the list",
        idle.join(", ")
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn works_are_in_the_order_of_their_names_and_say_where_they_were_read() {
        let mut shorts: Vec<_> = WORKS.iter().map(|work| work.short).collect();
        assert!(shorts.is_sorted(), "{shorts:?}");
        shorts.dedup();
        assert_eq!(shorts.len(), WORKS.len(), "two works are cited alike");
        for work in WORKS {
            assert!(!work.read.is_empty() && !work.title.is_empty() && !work.published.is_empty(), "{}", work.key);
            assert!(work.year.is_empty() || work.year.parse::<u16>().is_ok_and(|year| year > 1500), "{}", work.key);
            assert!(work.address.is_empty() || work.address.starts_with("http"), "{}", work.key);
        }
    }

    #[test]
    fn a_citation_leads_to_the_list_and_an_unknown_one_is_refused() {
        let cited = cite("johnson; chapter 6").expect("a work");
        assert_eq!(cited, "<a class=\"cite\" href=\"about.html#work-johnson\">&#91;Johnson, 1985, chapter 6&#93;</a>");
        assert!(list().expect("a list").contains("<li id=\"work-johnson\">"));
        assert!(cite("jonson").expect_err("unknown").to_string().contains("`johnson`"));
    }

    #[test]
    fn a_work_that_no_chapter_cites_is_refused() {
        let all: String = WORKS.iter().map(|work| format!("{{{{cite:{}; page 1}}}}", work.key)).collect();
        check([all.as_str()]).expect("each is cited");
        let without = all.replacen("{{cite:alon; page 1}}", "", 1);
        assert!(check([without.as_str()]).expect_err("one is not").to_string().contains("no chapter cites alon"));
        assert!(check([all.as_str(), "{{cite:nobody}}"]).is_err());
    }
}
