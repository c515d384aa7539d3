//! What proofreading costs as a text grows: eight times the text should cost eight times the time.

use divan::{Bencher, black_box};
use proofread::{Format, Options, proofread};

fn main() {
    divan::main();
}

/// Paragraphs in the formats that people write most, each with a wrong chain among right ones.
const PARAGRAPHS: [(Format, &str); 3] = [
    (
        Format::Markdown,
        "It is $v = \\frac{3.0\\,\\mathrm{m}}{2.0\\ \\text{s}} = 1.5\\,\\mathrm{m/s}$, $2 + 2 = 5$ and `code`.\n\n",
    ),
    (Format::Latex, "\\begin{align*} a &= 4.5 \\cdot 2 = 9.0 & b &= 5! = 121 \\end{align*} % x\n$1+1=2$\n\n"),
    (Format::Plain, "F = (2.0 kg)(3.0 m/s²) = 7.0 N\nv = 500 sin 17.6°\nv = 151.2\n\n"),
];

#[divan::bench(args = [30, 240, 1920])]
fn paragraphs(bencher: Bencher, count: usize) {
    let texts = PARAGRAPHS.map(|(format, paragraph)| (format, paragraph.repeat(count)));
    bencher.bench_local(|| {
        let chains = |(format, text): &(Format, String)| {
            proofread(black_box(text), *format, Options::default()).map(|report| report.findings.len())
        };
        texts.iter().map(chains).collect::<Vec<_>>()
    });
}
