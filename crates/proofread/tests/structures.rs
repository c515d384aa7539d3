//! Texts of any length, each of one structure that a reader may take too long over.

use proofread::TextFormat;

/// A text of at least so many bytes.
pub(crate) type Grown = Box<dyn Fn(usize) -> String>;

/// A structure: its name, its format, and its texts.
pub(crate) type Structure = (&'static str, TextFormat, Grown);

/// `unit` again and again, between what stands before and behind it.
fn repeated(before: &'static str, unit: &'static str, behind: &'static str) -> Grown {
    Box::new(move |n| format!("{before}{}{behind}", unit.repeat(n / unit.len() + 1)))
}

/// Pieces that are numbered from zero.
fn numbered(before: &'static str, piece: fn(usize) -> String, behind: &'static str) -> Grown {
    Box::new(move |n| {
        let mut text = before.to_owned();
        let mut number = 0;
        while text.len() < n + before.len() {
            text += &piece(number);
            number += 1;
        }
        text + behind
    })
}

/// `open` as often as `close`, with `inside` between them.
fn nested(
    before: &'static str,
    open: &'static str,
    inside: &'static str,
    close: &'static str,
    behind: &'static str,
) -> Grown {
    Box::new(move |n| {
        let times = n / (open.len() + close.len()) + 1;
        format!("{before}{}{inside}{}{behind}", open.repeat(times), close.repeat(times))
    })
}

/// A number in letters.
fn letters(number: usize) -> String {
    number.to_string().bytes().map(|digit| char::from(digit - b'0' + b'a')).collect()
}

/// Macros each of which stands for ten times the next, and a formula with the first.
fn laughs(n: usize) -> String {
    let macros = (b'a'..b'u').map(|letter| {
        let next = format!("\\{}", char::from(letter + 1));
        format!("\\def\\{}{{{}}}", char::from(letter), next.repeat(10))
    });
    format!("{}\\def\\u{{1+}}{}", macros.collect::<String>(), "$\\a 1=1$ ".repeat(n / 9 + 1))
}

/// A notebook with its cells or lines.
fn notebook(before: &'static str, piece: fn(usize) -> String, behind: &'static str) -> Grown {
    let grown = numbered("", piece, "");
    Box::new(move |n| {
        format!("{{\"cells\":[{before}{}{behind}],\"metadata\":{{}},\"nbformat\":4,\"nbformat_minor\":5}}", grown(n))
    })
}

/// A formula that is wrong.
fn wrong(number: usize) -> String {
    format!("2.5+{number}.5={}.7", number + 4)
}

/// Every structure.
pub(crate) fn all() -> Vec<Structure> {
    let mut all = markdown();
    all.extend(formulas());
    all.extend(latex());
    all.extend(pages());
    all.extend(xml());
    all.extend(plain());
    all
}

fn markdown() -> Vec<Structure> {
    let in_markdown: [(&str, Grown); 37] = [
        ("right formulas on one line", repeated("", "$2+2=4$ ", "")),
        ("code beside MathML", repeated("", "`x` <math></math> ", "")),
        ("right lines", repeated("", "It is $2+2=4$ and 3.0*2.0=6.0 here.\n", "")),
        ("wrong lines", numbered("", |i| format!("It is ${}$ here.\n", wrong(i)), "")),
        ("wrong formulas on one line", numbered("", |i| format!("is ${}$ ", wrong(i)), "")),
        ("empty formulas", repeated("", "$", "")),
        ("formulas without an end", repeated("", "$ x\n\n", "")),
        ("brackets of TeX without an end", repeated("", "\\( 1=2 ", "")),
        ("displays without an end", repeated("", "\\[ 1=2 ", "")),
        ("backticks", numbered("", |i| format!("{} a ", "`".repeat(i % 300 + 1)), "")),
        ("square brackets", repeated("", "[", "")),
        ("quotations", repeated("", ">", " $1+1=3$")),
        ("lists", repeated("", "* ", "$1+1=3$")),
        ("emphasis", repeated("", "*a **b ", "")),
        ("tags without an end", repeated("", "<a ", "")),
        ("comments without an end", repeated("", "<!-- ", "")),
        ("a row of a table", repeated("|a|\n|-|\n", "|$1+1=3$|", "")),
        ("empty lines", repeated("", "\n", "")),
        ("blanks", repeated("", " ", "$1+1=3$")),
        ("equals signs", repeated("", "=", "")),
        ("equals signs and digits", repeated("", "1=", "1")),
        ("plain equations", numbered("", |i| format!("x{i} = {i} + 2.5 = {}\n", i + 3), "")),
        (
            "many names",
            numbered("", |i| format!("$a_{{{i}}} = {i}.5$ and $b_{{{i}}} = a_{{{i}}} + 1 = {}.5$\n", i + 2), ""),
        ),
        ("one name", numbered("", |i| format!("$a = {i}.5$ and $b = a + 1 = {}.5$\n", i + 2), "")),
        ("decimal commas", numbered("", |i| format!("$1,{} + 2,5 = 7,{}$\n", i % 900 + 100, i % 900), "")),
        (
            "mixed units",
            numbered(
                "",
                |i| format!("$2.5\\,\\mathrm{{J/kg\\cdot K}} \\cdot {i} = {}.7\\,\\mathrm{{kJ}}$ text\n", i + 4),
                "",
            ),
        ),
        ("the same factor", numbered("", |i| format!("$ {}.0\\cdot 2={}$\n", i + 2, (i + 2) * 20), "")),
        ("turned directions", repeated("", "\u{202e}$1+1=3$\u{202c} ", "")),
        ("zero bytes", repeated("", "\0$1+1=3$", "")),
        ("fences", repeated("", "```math\n1+1=3\n```\n", "")),
        ("a long fence", repeated("```math\n", "1+1=3\n", "```\n")),
        ("struck out", repeated("", "~~ $1+1=3$ ", "")),
        ("directives in each other", repeated("", "```{note} 1+1=3\n", "")),
        ("directives", repeated("", "````{note} $1+1=3$\n```{tip}\n1+1=3\n```\n````\n", "")),
        ("chunks with backticks in their options", repeated("", "```{r a=\"`1=2`\"}\n1=2\n```\n", "")),
        ("dollar signs with space", repeated("", "$ 1+1=3 ", "$")),
        ("functions that are not known", repeated("$", "\\foo{1}=", "2$")),
    ];
    in_markdown.into_iter().map(|(name, grown)| (name, TextFormat::Markdown, grown)).collect()
}

/// One formula each.
fn formulas() -> Vec<Structure> {
    let units = "\\kilo\\metre\\per\\second";
    let formulas: [(&str, Grown); 58] = [
        ("a chain", repeated("$", "1+1=2=", "2$")),
        ("a wrong chain", numbered("$", |i| format!("{i}.5+1={}.5=", i + 3), "2$")),
        ("a sum", repeated("$", "1.1+", "1=3$")),
        ("digits", repeated("$1+", "7", "=3$")),
        ("superscripts", repeated("$", "2^", "2=5$")),
        ("subscripts", repeated("$", "x_", "2=5$")),
        ("carets", repeated("$", "^", "2=5$")),
        ("carets and strokes", repeated("$", "^_", "2=5$")),
        ("superscripts in braces", nested("$", "2^{", "2", "}", "=5$")),
        ("fractions", nested("$", "\\frac{1}{", "2", "}", "=5$")),
        ("fractions without braces", repeated("$", "\\frac1", "2=5$")),
        ("brackets", nested("$", "(", "2", ")", "=5$")),
        ("braces", repeated("$", "{", "$")),
        ("left brackets", repeated("$", "\\left(", "1=2$")),
        ("roots", repeated("$", "\\sqrt", " 2=5$")),
        ("roots with an index", repeated("$", "\\sqrt[", "2=5$")),
        ("roots with an index that ends", nested("$", "\\sqrt[", "3", "]2", "=5$")),
        ("accents", repeated("$", "\\hat", " 2=5$")),
        ("commands that only dress", repeated("$", "\\mathbf", " 2=5$")),
        ("minus signs", repeated("$", "-", "2=5$")),
        ("factorials", repeated("$2", "!", "=5$")),
        ("primes", repeated("$2", "'", "=5$")),
        ("units", repeated("$2\\,", "\\mathrm{m}", "=5\\,\\mathrm{s}$")),
        ("a unit of many letters", repeated("$2\\,\\mathrm{", "m", "}=5\\,\\mathrm{s}$")),
        ("words", repeated("$2\\text{", "kg m ", "}=5$")),
        ("plus or minus", repeated("$", "2\\pm1+", "1=5$")),
        ("strokes", repeated("$", "1/2\\pi ", "=5$")),
        ("commas", repeated("$", "1,5+", "1=2,5$")),
        ("sines", repeated("$", "\\sin 30 +", "1=2$")),
        ("powers of sines", repeated("$", "\\sin^", "2=5$")),
        ("a matrix", repeated("$$\\begin{matrix}", "1&2=3\\\\", "\\end{matrix}$$")),
        ("rows", repeated("$$\\begin{aligned}", "1+1&=3\\\\", "\\end{aligned}$$")),
        ("rows without an end", repeated("$$", "\\begin{aligned}1=2", "$$")),
        ("accents of Unicode", repeated("$1", "\u{301}", "=3$")),
        ("text in formulas", repeated("$", "\\text{$1=2$}", "$")),
        ("strokes of fractions", repeated("$", "1 \\over ", "2=3$")),
        ("upright letters", repeated("$", "\\rm ", "2=3$")),
        ("unknown commands", repeated("$", "\\foo{1=2}", "$")),
        ("bars", repeated("$", "|", "2=5$")),
        ("bars with limits", repeated("$", "|^", "2=5$")),
        ("roots of signs", repeated("$", "\\surd", " 2=5$")),
        ("a long number of siunitx", repeated("$\\qty{2e", "9", "}{m}=\\num{3e-9}$")),
        ("cells", repeated("$$", "1&", "=2$$")),
        ("matrices", repeated("$$", "\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}", "=2$$")),
        ("matrices without an end", repeated("$$", "\\begin{pmatrix}1&2", "=2$$")),
        ("matrices in each other", nested("$$", "\\begin{vmatrix}", "1", "\\end{vmatrix}", "=2$$")),
        (
            "sums of matrices",
            repeated(
                "$$",
                "\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}+",
                "\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}=\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}$$",
            ),
        ),
        (
            "formulas with matrices",
            repeated("", "$\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}^2=\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}$ ", ""),
        ),
        ("sums over an index", repeated("$", "\\sum_{k=1}^{99}", "k=2$")),
        ("formulas with sums", repeated("", "$\\sum_{k=1}^{99}k=4951$ and ", "")),
        ("choices", repeated("$", "\\binom{400}{200}+", "1=2$")),
        ("choices in each other", nested("$", "\\binom{", "4", "}{2}", "=2$")),
        ("integer parts", nested("$", "\\lfloor ", "4.5", "\\rfloor", "=2$")),
        ("remainders", repeated("$", "17 \\bmod ", "5=2$")),
        ("tuples in each other", nested("$", "(1,", "2", ")", "=2$")),
        ("repeating decimals", repeated("$", "0.\\overline{3}+", "1=2$")),
        ("lists of numbers", repeated("$\\max(", "1,", "2)=3$")),
        ("dots", repeated("$", "1.", "=2$")),
    ];
    let long = Box::new(move |n: usize| format!("$\\SI{{2}}{{{}}}=5$", units.repeat(n / units.len() + 1)));
    let mut all: Vec<Structure> =
        formulas.into_iter().map(|(name, grown)| (name, TextFormat::Markdown, grown)).collect();
    all.push(("units of siunitx", TextFormat::Markdown, long));
    all
}

fn latex() -> Vec<Structure> {
    let in_latex: [(&str, Grown); 35] = [
        ("running text", repeated("", "Here \\emph{1+1=3} and \\foo[a]{1+1=2}. ", "")),
        ("lines of running text", repeated("", "1.5+1=3~\\\\\n", "")),
        ("options without an end", repeated("1=2", "\\foo[", "")),
        ("drawings without an end", repeated("1=2", "\\begin{axis} ", "")),
        ("dashes", repeated("1=2", "-", "")),
        ("lines", numbered("", |i| format!("It is ${}$ here.\n\n", wrong(i)), "")),
        ("a macro of itself", repeated("\\def\\a{\\a\\a}", "$\\a=1$ ", "")),
        ("macros of each other", repeated("\\def\\a{\\b\\b}\\def\\b{\\a\\a}", "$\\a=1$ ", "")),
        ("macros of ten times the next", Box::new(laughs)),
        (
            "arguments twice",
            Box::new(|n| {
                let formula = format!("${}1{}=1$ ", "\\d{".repeat(30), "}".repeat(30));
                format!("\\newcommand{{\\d}}[1]{{#1#1}}{}", formula.repeat(n / formula.len() + 1))
            }),
        ),
        ("a long argument", repeated("\\newcommand{\\d}[1]{#1#1#1}$\\d{", "1+", "1}=3$")),
        ("many macros", numbered("", |i| format!("\\def\\q{}{{1+1}}", letters(i)), "$\\qa=3$")),
        (
            "many macros that are used",
            numbered("", |i| format!("\\def\\q{0}{{{1}}}$\\q{0}+1=1$\n", letters(i), i % 99), ""),
        ),
        ("a chain of macros", numbered("", |i| format!("\\def\\q{}{{\\q{}}}", letters(i), letters(i + 1)), "$\\qa=3$")),
        ("a long name", Box::new(|n| format!("\\def\\{0}{{1}}$\\{0}=2$", "a".repeat(n / 2 + 1)))),
        ("definitions without an end", repeated("", "\\def\\a{", "")),
        ("a comment", repeated("", "%", "\n$1+1=3$")),
        ("comments", repeated("", "%\n", "\n$1+1=3$")),
        ("environments in each other", nested("", "\\begin{itemize}", "$1+1=3$", "\\end{itemize}", "")),
        ("displays without an end", repeated("", "\\begin{equation}1+1=3", "")),
        ("code without an end", repeated("", "\\begin{verbatim}", "")),
        ("drawings without an end", repeated("", "\\begin{tikzpicture}\\begin{axis}", "")),
        ("verbs", repeated("", "\\verb|", "")),
        (
            "huge powers of units",
            repeated("", "$\\SI{2}{\\metre\\tothe{1000000000}}\\cdot\\SI{3}{m^{999999999}}=5$ ", ""),
        ),
        ("inclusions", repeated("", "\\input{f}\n", "$1+1=3$")),
        ("braces", nested("", "{", "$1+1=3$", "}", "")),
        ("formulas without an end", repeated("", "$1=", "")),
        (
            "displays by macros without an end",
            repeated("\\def\\be{\\begin{equation}}\\def\\ee{\\end{equation}}", "\\be 1=2 ", ""),
        ),
        (
            "displays by macros",
            repeated("\\def\\be{\\begin{equation}}\\def\\ee{\\end{equation}}", "\\be 1+1=3 \\ee ", ""),
        ),
        (
            "units of units",
            Box::new(|n| {
                let (many, long) = ("\\y".repeat(600), "z".repeat(1500));
                let macros = format!("\\DeclareSIUnit\\x{{{many}}}\\DeclareSIUnit\\y{{\\{long}}}");
                format!("{macros}{}", "$\\SI{2}{\\x}=5$ ".repeat(n / 15 + 1))
            }),
        ),
        ("commands", repeated("", "\\foo ", "$1+1=3$")),
        ("problems in each other", repeated("", "\\begin{problem}", "$1+1=3$")),
        ("what is printed for nobody", repeated("\\newcommand{\\x}[1]{}", "\\x{", "$1+1=3$")),
        ("false conditions", repeated("", "\\iffalse ", "$1+1=3$")),
        ("short formulas with a macro", repeated("\\def\\a{1+1}", "$\\a=3$ ", "")),
    ];
    in_latex.into_iter().map(|(name, grown)| (name, TextFormat::Latex, grown)).collect()
}

fn pages() -> Vec<Structure> {
    let in_html: [(&str, Grown); 20] = [
        ("lines", numbered("<html><body>", |i| format!("<p>{} here</p>\n", wrong(i)), "")),
        ("elements in each other", nested("", "<div>", "1+1=3", "</div>", "")),
        ("elements without an end", repeated("", "<b>", "1+1=3")),
        ("exponents in each other", nested("<p>2", "<sup>2", "", "</sup>", " = 5")),
        ("exponents", repeated("<p>2", "<sup>2</sup>", " = 5")),
        ("attributes", numbered("<p ", |i| format!("a{i}=\"b\" "), ">1+1=3</p>")),
        ("attributes without an end", repeated("", "<a b=\"", "")),
        ("entities", repeated("<p>", "&amp;&lt;&#x1D7D9;&bogus;&", "1+1=3</p>")),
        ("entities without an end", repeated("<p>", "&", "1+1=3</p>")),
        ("scripts without an end", repeated("", "<script>", "1+1=3")),
        ("comments without an end", repeated("", "<!--", "1+1=3")),
        ("ends without a start", repeated("", "</p>", "1+1=3")),
        ("other ends", Box::new(|n| format!("{}{}1+1=3", "<b>".repeat(1000), "</i>".repeat(n / 4 + 1)))),
        ("a table", repeated("<table>", "<tr><td>1+1=3</td></tr>", "")),
        ("one paragraph", numbered("<p>", |i| format!("{} and ", wrong(i)), "</p>")),
        ("formulas without an end", repeated("<p>", "$1=2 \\(", "")),
        ("hidden elements in each other", repeated("", "<span aria-hidden=true>", "1+1=3")),
        ("breaks", repeated("<p>", "<u>1</u><br>2<br>", "1+1=3")),
        ("one formula of MathML", repeated("<math>", "<mn>1</mn><mo>+</mo>", "<mo>=</mo><mn>3</mn></math>")),
        ("formulas of TeX in scripts", repeated("", "<script type=\"math/tex\">1+1=3</script>", "")),
    ];
    in_html.into_iter().map(|(name, grown)| (name, TextFormat::Html, grown)).collect()
}

fn xml() -> Vec<Structure> {
    let end = "<mn>1</mn><mo>=</mo><mn>3</mn>";
    let entities: Grown = Box::new(|n| {
        let entity = |letter: u8| {
            let before = format!("&{};", char::from(letter - 1));
            format!("<!ENTITY {} \"{}\">", char::from(letter), before.repeat(10))
        };
        let entities: String = (b'b'..b'v').map(entity).collect();
        format!("<!DOCTYPE l [<!ENTITY a \"1+\">{entities}]><math><mn>{}1</mn></math>", "&t;".repeat(n / 3 + 1))
    });
    let equation = |i: usize| format!("<math><mn>{i}.5</mn><mo>+</mo><mn>1</mn><mo>=</mo><mn>{}</mn></math>\n", i + 3);
    let in_xml: [(&str, Grown); 14] = [
        ("entities of entities", entities),
        ("formulas", numbered("<d>", equation, "</d>")),
        ("one formula", repeated("<math>", "<mn>1</mn><mo>+</mo>", "<mn>1</mn><mo>=</mo><mn>3</mn></math>")),
        ("rows in each other", nested("<math>", "<mrow>", end, "</mrow>", "</math>")),
        ("fractions in each other", nested("<math>", "<mfrac><mn>1</mn>", end, "</mfrac>", "</math>")),
        ("powers in each other", nested("<math>", "<msup><mn>2</mn>", end, "</msup>", "</math>")),
        ("roots without an end", repeated("<math>", "<msqrt>", end)),
        ("formulas without an end", repeated("", "<math><mn>1</mn>", "")),
        ("sections of characters without an end", repeated("", "<![CDATA[", "")),
        ("instructions without an end", repeated("", "<?", "")),
        (
            "a table",
            repeated("<math><mtable>", "<mtr><mtd><mn>1</mn><mo>=</mo><mn>3</mn></mtd></mtr>", "</mtable></math>"),
        ),
        ("accents in each other", nested("<math>", "<mover><mi>x</mi>", end, "</mover>", "</math>")),
        ("examples in each other", repeated("", "<example>", "<m>1+1=3</m>")),
        ("PreTeXt", numbered("<pretext>", |i| format!("<p><m>{}</m></p>\n", wrong(i)), "</pretext>")),
    ];
    let mut all: Vec<Structure> = in_xml.into_iter().map(|(name, grown)| (name, TextFormat::Xml, grown)).collect();
    let cell = |i: usize| format!("{{\"cell_type\":\"markdown\",\"source\":[\"${}$\"]}},\n", wrong(i));
    let line = |i: usize| format!("\"${}$\\n\",", wrong(i));
    let last = "{\"cell_type\":\"markdown\",\"source\":\"\"}";
    all.push(("cells", TextFormat::Notebook, notebook("", cell, last)));
    all.push(("one cell", TextFormat::Notebook, notebook("{\"cell_type\":\"markdown\",\"source\":[", line, "\"\"]}")));
    all.push(("lists in each other", TextFormat::Notebook, repeated("{\"cells\":", "[", "")));
    all.push((
        "escapes",
        TextFormat::Notebook,
        notebook("{\"cell_type\":\"markdown\",\"source\":\"", |_| "\\u0024 1+1=3 \\u0024 ".to_owned(), "\"}"),
    ));
    all
}

fn plain() -> Vec<Structure> {
    let in_plain: [(&str, Grown); 18] = [
        ("lines", numbered("", |i| format!("{} here\n", wrong(i)), "")),
        ("one line", numbered("", |i| format!("{} and ", wrong(i)), "")),
        ("words", repeated("", "lorem ipsum dolor ", "")),
        ("words and an equation", repeated("", "lorem ipsum dolor ", "= 5")),
        ("digits and blanks", repeated("", "1 ", "= 5")),
        ("brackets", nested("", "(", "1+1=3", ")", "")),
        ("columns", repeated("", "  12.5    13.6   = 25.1   \n", "")),
        ("roots", repeated("", "√", "2=3")),
        ("exponents", repeated("2", "²", "=3")),
        ("carets", repeated("2", "^", "2=3")),
        ("powers as in a program", repeated("2", "**2", "=3")),
        ("old ends of lines", repeated("", "1+1=3\r", "")),
        ("other ends of lines", repeated("", "1+1=3\u{2028}", "")),
        (
            "lines of roots",
            repeated("", "√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√√2=3\n", ""),
        ),
        (
            "lines of minus signs",
            repeated("", "5=--------------------------------------------------------------------3\n", ""),
        ),
        ("functions", repeated("5 = ", "sin ", "2\n")),
        ("exponents of ten", repeated("5 = ", "1e", "2\n")),
        ("arrows", repeated("5 = ", "-", "> 2\n")),
    ];
    in_plain.into_iter().map(|(name, grown)| (name, TextFormat::Plain, grown)).collect()
}
