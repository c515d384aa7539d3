//! Totals and subtotals of tables in each format, and what only looks like one.

use proofread::{ReportSection, TextFormat, find_statistics};

#[track_caller]
fn listed(text: &str, format: TextFormat) -> Vec<String> {
    let report = find_statistics(text, format).expect("a text");
    let shown = |finding: proofread::ChainFinding| {
        let at = &text[finding.at.range()];
        format!("{at}{}", if finding.section == ReportSection::Doubts { "?" } else { "" })
    };
    report.findings.into_iter().map(shown).collect()
}

/// A table in each format from rows with strokes between the cells.
fn in_each_format(rows: &str) -> [(String, TextFormat); 5] {
    let rows: Vec<Vec<&str>> = rows.lines().map(|row| row.split('|').map(str::trim).collect()).collect();
    let lines = |begin: &str, between: &str, end: &str| -> Vec<String> {
        rows.iter().map(|row| format!("{begin}{}{end}", row.join(between))).collect()
    };
    let mut markdown = lines("| ", " | ", " |");
    markdown.insert(1, format!("|{}", "---|".repeat(rows[0].len())));
    let latex = lines("", " & ", " \\\\\n\\hline").join("\n").replace('%', "\\%");
    let html = lines("<tr><td>", "</td><td>", "</td></tr>").concat();
    let xml = lines("<row><entry>", "</entry><entry>", "</entry></row>").concat();
    [
        (markdown.join("\n"), TextFormat::Markdown),
        (format!("\\begin{{tabular}}{{lrr}}\n\\toprule\n{latex}\n\\end{{tabular}}"), TextFormat::Latex),
        (format!("<table><tbody>{html}</tbody></table>"), TextFormat::Html),
        (format!("<table><tgroup><tbody>{xml}</tbody></tgroup></table>"), TextFormat::Xml),
        (lines("\"", "\",\"", "\"").join("\n"), TextFormat::Csv),
    ]
}

#[track_caller]
fn check(rows: &str, wanted: &[&str]) {
    for (text, format) in in_each_format(rows) {
        let text = format!("{text}\n");
        // A cell with a share is pointed at as a whole.
        let found: Vec<String> = listed(&text, format).iter().map(|of| of.replace('\\', "")).collect();
        assert_eq!(found, wanted, "{format:?}\n{text}");
    }
}

#[test]
fn rows_and_columns_add_up_to_their_totals() {
    let right = "Group | Yes | No | Total\nA | 312 | 163 | 475\nB | 141 | 51 | 192\nTotal | 453 | 214 | 667";
    check(right, &[]);
    check(&right.replace("453", "463"), &["463"]);
    check(&right.replace("475", "457"), &["457"]);
    check(&right.replace("667", "767"), &["767"]);
    // A wrong part spoils two totals.
    check(&right.replace("51", "81"), &["192", "214"]);
    check("Item | Cost\nPens | 12.50\nPaper | 30.25\nInk | 47.00\nTotal | 89.75", &[]);
    check("Item | Cost\nPens | 12.50\nPaper | 30.25\nInk | 47.00\nTotal | 98.75", &["98.75"]);
}

#[test]
fn shares_in_a_table_are_of_one_whole() {
    let cells = "Arm | Better | Worse | Total\nDrug | 45 (75.0%) | 15 (25.0%) | 60\nPlacebo | 28 (46.7%) | 32 (53.3%) | 60\n\
                 All | 73 (60.8%) | 47 (39.2%) | 120";
    check(cells, &[]);
    check(&cells.replace("46.7", "47.6"), &["28 (47.6%)"]);
    let columns =
        "Age | n | %\n18–29 | 48 | 24.0\n30–44 | 62 | 31.0\n45–59 | 54 | 27.0\n60+ | 36 | 18.0\nTotal | 200 | 100.0";
    check(columns, &[]);
    check(&columns.replace("31.0", "13.0"), &["13.0"]);
    check(&columns.replace("| 200", "| 210"), &["210"]);
    // Rounding alone.
    check("Answer | n | %\nyes | 12 | 33.3\nno | 12 | 33.3\nnone | 12 | 33.3\nTotal | 36 | 100.0", &[]);
}

#[test]
fn what_is_no_sum_is_no_error() {
    for rows in [
        // Means, rates and other summaries.
        "Group | Mean | SD\nA | 14.0 | 2.0\nB | 11.5 | 2.5\nOverall | 13.0 | 2.4",
        "Group | Rate\nA | 0.90\nB | 0.40\nAll | 0.85",
        "Source | SS | df | MS | F\nBetween | 84.0 | 2 | 42.0 | 7.00\nWithin | 162.0 | 27 | 6.0 |\nTotal | 246.0 | 29 | |",
        // Subtotals, totals that come first, and sections.
        "Item | n\nMen | 10\nWomen | 15\nSubtotal | 25\nBoys | 7\nGirls | 6\nSubtotal | 13\nTotal | 38",
        "Item | n | m\nTotal | 25 | 31\nMen | 10 | 11\nWomen | 15 | 20",
        "Item | n\nNorth | \nMen | 10\nWomen | 15\nTotal | 25\nSouth | \nMen | 11\nWomen | 4\nTotal | 15",
        // Some are parts of others.
        "Item | n\nAdults | 250\nof these women | 150\nof these men | 100\nChildren | 120\nTotal | 370",
        // Rounded to thousands.
        "Year | Income\n2019 | 12346\n2020 | 23457\n2021 | 34568\nTotal | 70372",
        // Not all parts are there.
        "Item | n\nA | 250\nB | withheld\nC | 120\nTotal | 500",
    ] {
        check(rows, &[]);
    }
}

#[test]
fn an_unlikely_total_is_a_doubt() {
    check("Item | n\nA | 250\nB | 130\nC | 120\nTotal | 633", &["633?"]);
    check(
        "Kind | here | there | Total\nsingle | 120 | 131 | 251\nspecies | 15 | 14 | 18\nshells | 230 | 340 | 570",
        &["18?"],
    );
}

#[test]
fn tables_in_latex_and_html_may_have_cells_over_several_columns() {
    let latex = "\\begin{tabular}{@{}lcc@{}}\\toprule\n & \\multicolumn{2}{c}{Group}\\\\\\cmidrule(lr){2-3}\n & A & B\\\\\\midrule\n\
                 yes & 1{,}041 & 52\\\\ % 9\nno & 17 & \\textbf{31}\\\\\n$\\Sigma$ & 1{,}058 & 93\\\\\\bottomrule\n\\end{tabular}";
    assert_eq!(listed(latex, TextFormat::Latex), ["93?"]);
    assert_eq!(listed(&latex.replace("93", "83"), TextFormat::Latex), [""; 0]);
    let html = "<table><tr><th rowspan=2>Sex</th><th colspan=2>Answer</th><th>Total</th></tr><tr><th>yes</th><th>no</th><th></th></tr>\
                <tr><td>m</td><td>17</td><td>23</td><td>40</td></tr><tr><td>f</td><td>31</td><td>29</td><td>60</td></tr>\
                <tr><td>Total</td><td>48</td><td>52</td><td>101</td></tr></table>";
    assert_eq!(listed(html, TextFormat::Html), ["101"]);
    assert_eq!(listed(&html.replace("101", "100"), TextFormat::Html), [""; 0]);
}

#[test]
fn a_unit_a_currency_or_a_decimal_comma_in_the_cells_is_no_obstacle() {
    check("Part | Mass\nA | 120 kg\nB | 200 kg\nC | 152 kg\nTotal | 472 kg", &[]);
    check("Part | Mass\nA | 120 kg\nB | 200 kg\nC | 152 kg\nTotal | 482 kg", &["482"]);
    check("Part | Price\nA | 120 €\nB | 200 €\nC | 152 €\nTotal | 482 €", &["482"]);
    check("Part | Price\nA | EUR 120\nB | EUR 200\nC | EUR 152\nTotal | EUR 482", &["482"]);
    check("Teil | Preis\nA | 1.120,50\nB | 2.350,00\nC | 1.012,50\nSumme | 4.483,00", &[]);
    check("Teil | Preis\nA | 1.120,50\nB | 2.350,00\nC | 1.012,50\nSumme | 4.493,00", &["4.493,00"]);
    check("Teil | Preis\nA | 1.120,50 €\nB | 850,00 €\nC | 1.012,50 €\nSumme | 2.993,00 €", &["2.993,00"]);
    // Kilograms and tonnes, and two currencies, are not added.
    check("Part | Mass\nA | 120 kg\nB | 200 kg\nC | 152 kg\nTotal | 482 lb", &[]);
    check("Part | Price\nA | 120 €\nB | £200\nC | 152 €\nTotal | 482 €", &[]);
}
