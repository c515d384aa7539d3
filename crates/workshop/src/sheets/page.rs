//! Files of all sheets.

use super::paper::Paper;
use super::sheet::Sheet;
use std::fmt::Write;

/// Sheets one below the other as one SVG file, true to scale.
pub fn sheets_svg(sheets: &[Sheet]) -> String {
    let sizes: Vec<[f64; 2]> = sheets.iter().map(|sheet| sheet.paper.size()).collect();
    let width = sizes.iter().map(|[width, _]| *width).fold(0.0, f64::max);
    let height: f64 = sizes.iter().map(|[_, height]| *height).sum();
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\">\n"
    );
    let mut top = 0.0;
    for (sheet, [_, height]) in sheets.iter().zip(sizes) {
        let _ = writeln!(text, "<g transform=\"translate(0 {top})\">\n{}</g>", sheet.markup());
        top += height;
    }
    text + "</svg>\n"
}

/// Sheets as a page that prints one on each page of paper, true to scale; a browser makes a PDF of it.
pub fn sheets_html(sheets: &[Sheet], project: &str) -> String {
    let paper = sheets.first().map_or(Paper::A4, |sheet| sheet.paper);
    let [width, height] = paper.size();
    let project = project.replace('&', "&amp;").replace('<', "&lt;");
    let drawn: String = sheets.iter().map(Sheet::svg).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{project}: drawings</title>\n<style>\n\
         @page {{ size: {width}mm {height}mm; margin: 0 }}\n\
         body {{ margin: 0; background: #ddd }}\n\
         svg {{ display: block; margin: 0 auto 5mm; break-after: page; break-inside: avoid }}\n\
         p {{ font: 1rem sans-serif; max-width: 40rem; margin: 1rem auto }}\n\
         @media print {{ body {{ background: none }} p {{ display: none }} svg {{ margin: 0 }} svg:last-of-type {{ break-after: auto }} }}\n\
         </style>\n</head>\n<body>\n<p>Print this page on {} across, at 100 % and without margins, or save it as PDF. Then measure the \
         bar of 50 mm on each sheet.</p>\n{drawn}</body>\n</html>\n",
        paper.name()
    )
}
