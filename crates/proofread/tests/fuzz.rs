//! Whatever is read, there is no panic, no hang, and every place is inside the text.

use proofread::{CheckOptions, Definitions, NamePolicy, TextFormat, proofread};

fn given(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

const SEEDS: [(TextFormat, &str); 8] = [
    (
        TextFormat::Markdown,
        "# A\n\nIt is $v = \\frac{3.0\\,\\mathrm{m}}{2.0\\ \\text{s}} = 1.5\\,\\mathrm{m/s}$ and `code`.\n\n$$x_1^2 = [\\sin^{-1} \
         0.5]_0^{2} \\approx \\sqrt[3]{8.0} = 2$$\n\n```math\n1+1=3\n```\nR = 1 sin 30°/sin 60° = 0.557, 2^(3) = 8 <math><mn>1</mn></math>\n",
    ),
    (
        TextFormat::Latex,
        "\\newcommand{\\v}[2][3]{#1 \\cdot #2}\\def\\be{\\begin{equation}}\\def\\ee{\\end{equation}}\\be \\v[2]{4.5} &= \
         9.0\\,\\mathrm{N\\,m^{-1}} \\\\ \\ee \\begin{align*} a &= \\qty{3e8}{\\metre\\per\\second\\squared} & b &= 5! = 120 \\end{align*} % x\n$|x|_0^1 = 3$",
    ),
    (
        TextFormat::Xml,
        "<para><m:math><m:mtable><m:mtr><m:mtd><m:mi>x</m:mi><m:mo>=</m:mo><m:mfrac><m:mn>6.0</m:mn><m:mn>2</m:mn></m:mfrac>\
         <m:mo>=</m:mo><m:msup><m:mn>3.1</m:mn><m:mn>2</m:mn></m:msup></m:mtd></m:mtr></m:mtable></m:math>&nbsp;&#x3b1;</para>",
    ),
    (
        TextFormat::Html,
        "<p class=x>U<sub>1</sub> = 2&nbsp;&times; 10<sup>3</sup> V <!-- x --> = 5<br/>30<sup>o</sup> = <u>1</u><br>\\(2+2=5\\) <math><mover><mi>i</mi><mo>^</mo></mover><mo>=</mo><mn>4</mn><script>a<b</script></math></p>",
    ),
    (
        TextFormat::Notebook,
        "{\"cells\":[{\"cell_type\":\"markdown\",\"source\":[\"\\u00e9 $2+2=5$\\n\",\"x = 3*4 = 13\"]}]}",
    ),
    (
        TextFormat::Plain,
        "F = (2.0 kg)(3.0 m/s²) = 7.0 N\nv = 500 sin 17.6°\nv = 151.2\n1.5e-3 * 2 = 3.1e-3; 10 % or 0.1\n",
    ),
    (
        TextFormat::Markdown,
        "$\\sum_{k=1}^{4} k^2 + \\binom{7}{4} = {7 \\choose 3} \\pm 2 = (3, 7)$, $17 \\bmod 5 = \\lfloor 7/2 \\rfloor = 0.1\\overline{6}$ and \
         $\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}^2 = \\det\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix} = \\max(2, 5)! = 7^{\\underline{3}} = 1.43\\ldots$",
    ),
    (TextFormat::Plain, "2 3/4 = 2.75 ± 3 °C = 276 K, 5 rev = 31.4 rad, 1,234.5 J/kg·K"),
];

const PIECES: [&str; 69] = [
    "\\frac",
    "{",
    "}",
    "$",
    "$$",
    "\\(",
    "\\[",
    "^",
    "_",
    "=",
    "≈",
    "(",
    ")",
    "[",
    "]",
    "|",
    "\\begin{align}",
    "\\end{align}",
    "\\\\",
    "&",
    "<math>",
    "</math>",
    "<mrow>",
    "<msup>",
    "&#x1F600;",
    "&pi;",
    "<sup>",
    "</sup><sub>",
    "<a>/",
    "<!-- -->",
    "</u>&nbsp;",
    "<s>",
    "<span aria-hidden=true>",
    "<p><br>&nbsp;",
    "°C",
    "10^{",
    "e",
    "1e999",
    "99999999999999999999",
    "0",
    "-",
    "\\sqrt",
    "\\text{",
    "\u{0}",
    "\u{202e}",
    "é",
    "\n\n",
    "!",
    "±",
    "%",
    "\\SI{1}{",
    "\"",
    "\\x",
    "\\DeclareSIUnit\\metre{\\x",
    "\\NewDocumentCommand{\\v}{O{",
    "\\binom",
    "\\sum_{k=1}^{9}",
    "\\begin{pmatrix}",
    "\\end{pmatrix}",
    "\\begin{vmatrix}1&2\\\\",
    "\\lfloor",
    "⌋",
    "\\bmod",
    "…",
    "\\overline{3}",
    "^{\\underline{3}}",
    "\\gcd(",
    "7C2",
    ",",
];

fn mutated(text: &str, dice: &mut fastrand::Rng) -> String {
    let mut letters: Vec<char> = text.chars().collect();
    for _ in 0..dice.usize(1..8) {
        let at = dice.usize(0..=letters.len());
        match dice.u8(0..5) {
            0 if at < letters.len() => drop(letters.remove(at)),
            1 => {
                let end = (at + dice.usize(0..20)).min(letters.len());
                let copied = letters[at..end].to_vec();
                letters.splice(at..at, copied);
            }
            2 => {
                let end = (at + dice.usize(0..30)).min(letters.len());
                letters.drain(at..end);
            }
            _ => {
                let piece = PIECES[dice.usize(0..PIECES.len())];
                let often = if dice.u8(0..20) == 0 { dice.usize(1..200) } else { 1 };
                letters.splice(at..at, piece.repeat(often).chars());
            }
        }
    }
    letters.into_iter().collect()
}

fn check(text: &str, format: TextFormat, elsewhere: &str) {
    let definitions = Definitions::from_latex(elsewhere);
    let options = CheckOptions {
        name_policy: NamePolicy::Always,
        agreeing: true,
        definitions: Some(&definitions),
        ..CheckOptions::default()
    };
    let Ok(report) = proofread(text, format, options) else {
        assert!(format == TextFormat::Notebook || text.len() > proofread::reader::LONGEST);
        return;
    };
    for finding in report.findings {
        for span in [finding.at, finding.span, finding.left_span, finding.right_span] {
            assert!(text.get(span.range()).is_some(), "{span:?} is no place in {text:?}");
        }
    }
}

/// Tells the text that was tried, if it panics.
struct Tried<'t>(&'t str, TextFormat);

impl Drop for Tried<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("tried: {:?} {:?}", self.1, self.0);
        }
    }
}

#[test]
fn fuzz_mutated_documents_are_read() {
    let cases = given("GENEVA_FUZZ", 3000);
    let mut dice = fastrand::Rng::with_seed(given("GENEVA_FUZZ_SEED", 0x5eed).max(1));
    for _ in 0..cases {
        let (format, seed) = SEEDS[dice.usize(0..SEEDS.len())];
        let text = mutated(seed, &mut dice);
        // Now and then as another format than it is.
        let format = if dice.u8(0..5) == 0 { TextFormat::ALL[dice.usize(0..TextFormat::ALL.len())].1 } else { format };
        let tried = Tried(&text, format);
        check(tried.0, tried.1, &mutated(SEEDS[1].1, &mut dice));
    }
}

/// Commands, signs and elements that take what is behind them, or may.
const TAKING: [(TextFormat, &str, &str); 6] = [
    (
        TextFormat::Markdown,
        "$",
        "\\frac \\dfrac \\sqrt \\sqrt[ \\sqrt[2] \\text \\mathrm \\operatorname \\mathrm\\text \\underbrace \\overbrace \\rm \\hspace \\genfrac \
         \\overline \\bar \\vec \\dot \\hat \\hat_ \\mathring \\cancelto \\cancel \\num \\SI \\SI{2} \\qty \\qty( \\si \\unit \\unit[ \\ang \\unitfrac \\unitfrac[ \
         \\SIrange \\numlist \\begin{aligned} \\begin{matrix} \\begin{array} \\end{aligned} \\mathbf \\boxed \\framebox \\textcolor \\class \\href \
         \\underset \\fcolorbox \\tag \\color \\rule \\left \\left( \\right) \\left. \\Big| \\lvert \\xlongequal \\xrightarrow \\mathop \\smash \\vcenter \
         \\sin \\sin^ \\sin( \\arcsin \\ln \\lg \\log_ \\log^ \\exp \\intertext \\eqno \\pmod \\sum \\int \\int_ \\surd \\neg \\times \\circ \\kilo \\per \\square \
         \\tothe{ \\of{ \\over 1\\over ^ _ ^_ ^{ _{ x^ x_ x^x_ 2^ |_ |^ |_0^1 ( [ | { \\{ - -( + \\pm ! ' \\prime 1/ / √ √( = 1= ≈ & \\\\ % ~ \\, . 1. , 1,",
    ),
    (
        TextFormat::Latex,
        "$\\newcommand{\\x}[1]{#1}",
        "\\x \\x^ \\x{ \\frac\\x \\sqrt\\x \\begin{align} \\( \\[ \\textbf{ \\footnote{$",
    ),
    (
        TextFormat::Plain,
        "2 = ",
        "√ √( ² ^ 2^ ^( ^{ ** 2** 2**( - + ( [ | sqrt sqrt( sin sin( sin² log2( 1/ e 1e 10- ! ± ½ → -> x of % _ · = 5= 1, 1. 0x > 1.)",
    ),
    (
        TextFormat::Html,
        "<p>2 = ",
        "<sup> 2<sup> <sub> <sup><sub> <sup>( </sup> <u> <br> <b> <a> <i> &sup2; <p> <div> <table><tr><td> <span> <script> <code>",
    ),
    (
        TextFormat::Xml,
        "<math><mn>2</mn><mo>=</mo>",
        "<mrow> <msup> <msub> <msubsup> <mfrac> <msqrt> <mroot> <mover> <munder> <mtable> <mtr> <mtd> <mfenced> <mstyle> <mn> <mi> <mo> \
         <mtext> <math> <menclose> <mpadded> <mmultiscripts> <mfrac><mn>1</mn> <msup><mn>2</mn> <mover><mi>x</mi> <msqrt/> <mo>√</mo> <mo>(</mo>",
    ),
    (TextFormat::Notebook, "{\"cells\":[{\"cell_type\":\"markdown\",\"source\":\"$", "2^ \\\\sqrt √ ( [ {"),
];

/// Commands of LaTeX outside formulas.
const COMMANDS: &str = "\\verb|x| \\verb*+y+ \\lstinline!z! \\iffalse w \\fi \\begin{example}\\begin{verbatim}\\end{verbatim}\\end{example} \
     \\newcommand*{\\a}[2][1]{#1#2}\\def\\b#1{#1}\\NewDocumentCommand{\\c}{O{2} m}{#2}\\DeclareMathOperator{\\d}{d} \
     \\DeclareSIUnit[x=1]{\\e}{\\kilo\\gram}\\input{f}\\import{g}{h}\\usepackage[i]{j}\\documentclass[k.tex]{subfiles} % !TEX root = l.tex \
     \n\\(1=1\\) \\[2=2\\] $$3=3$$ \\begin{align*}4=4\\end{align*} é\\end{document}";

#[test]
fn every_beginning_of_a_text_is_read() {
    for (format, text) in SEEDS.into_iter().chain([(TextFormat::Latex, COMMANDS)]) {
        for (end, _) in text.char_indices() {
            let tried = Tried(&text[..end], format);
            check(tried.0, tried.1, tried.0);
        }
    }
}

/// On a page, a module has a stack of this many bytes.
const STACK: usize = 1 << 20;

#[test]
fn whatever_takes_what_is_behind_it_may_stand_behind_itself() {
    let nested = || {
        for (format, before, all) in TAKING {
            for taking in all.split_whitespace() {
                for times in [100, 1000, 25_000] {
                    let text = format!("{before}{}2 = 5 $", taking.repeat(times));
                    let start: String = text.chars().take(100).collect();
                    let _tried = Tried(&start, format);
                    check(&text, format, "");
                }
            }
        }
    };
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(nested).expect("a thread");
    thread.join().expect("all are read");
}

#[test]
fn what_is_nested_too_deeply_is_counted_and_the_rest_is_read() {
    let unread = |text: &str| {
        let report = proofread(text, TextFormat::Markdown, CheckOptions::default()).expect("it can be read");
        (report.tally.unread, report.findings.len())
    };
    for taking in ["\\sqrt", "2^", "x_", "\\frac1", "\\sin^", "\\hat", "\\sqrt[", "{", "\\mathbf"] {
        let deep = format!("${}2 = 5$", taking.repeat(1000));
        assert_eq!(unread(&format!("{deep}\n\nIt is $2 + 2 = 5$.")), (1, 1), "{taking}");
        let shallow = format!("${}2 = 5$", taking.repeat(10));
        assert_eq!(unread(&shallow).0, 0, "{taking}");
    }
    let long = format!("${}2 = 5$", "1 + ".repeat(10_000));
    assert_eq!(unread(&format!("{long}\n\nIt is $2 + 2 = 5$.")), (1, 1));
    assert_eq!(unread(&format!("{}1 + 1 = 3\n\n2 + 2 = 5\n", "word ".repeat(1000))), (1, 1));
    let endless = r"\def\a{\b\b}\def\b{\a\a}$\a = 1$ $2 + 2 = 5$ $\b = 1$ $\a = 3$";
    let report = proofread(endless, TextFormat::Latex, CheckOptions::default()).expect("it can be read");
    assert_eq!((report.tally.unread, report.findings.len()), (3, 1));
}

#[test]
fn nesting_and_length_are_bounded() {
    for (open, close) in [
        ("{", "}"),
        ("(", ")"),
        ("\\sqrt{", "}"),
        ("\\frac{1}{", "}"),
        ("2^{", "}"),
        ("|", "|"),
        ("\\sin(", ")"),
        ("-(", ")"),
        ("x_{", "}"),
        ("\\text{", "}"),
        ("\\left[", "\\right]"),
    ] {
        let n = 3000;
        let text = format!("${}1{} = 2$", open.repeat(n), close.repeat(n));
        for format in [TextFormat::Markdown, TextFormat::Latex, TextFormat::Plain] {
            check(&text, format, "");
        }
    }
    for tag in ["mrow", "msup", "mfrac", "msqrt", "mtable", "p", "math"] {
        let n = 20_000;
        let text = format!("<math>{}<mn>1</mn>{}</math>", format!("<{tag}>").repeat(n), format!("</{tag}>").repeat(n));
        check(&text, TextFormat::Html, "");
    }
    check("\\def\\a{\\b\\b}\\def\\b{\\c\\c}\\def\\c{\\a\\a}$\\a = 1$", TextFormat::Latex, "");
    check(&format!("$1 = {}$", "1 + ".repeat(4000)), TextFormat::Markdown, "");
    for piece in PIECES {
        for format in TextFormat::ALL.map(|(_, format)| format) {
            check(&piece.repeat(5000), format, "");
        }
    }
}
