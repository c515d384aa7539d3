//! The same chains in many ways of writing: none that is right may be listed as wrong, and one with a wrong digit is.

use proofread::{ChainFinding, CheckOptions, NamePolicy, ReportSection, TextFormat, proofread};

/// Chains of ours. `<digits exponent unit>` is a number or a quantity; what is between braces is one factor.
const CHAINS: [&str; 10] = [
    "F = <12.5 kg> * <3.20 m/s^2> = <40.0 N>",
    "I = {<12.0 V>} / {<48.0 Ω>} = <0.250 A>",
    "E = {<6.63 -34 J> * <3.00 8>} / {<4.00 -7>} = <4.97 -19 J>",
    "F_x = <150 N> * cos <60.0 °> = <75.0 N>",
    "x = <12345> + <1255> = <13600>",
    "T = <2> * π * √ {<1.00 m> / <9.81 m/s^2>} = <2.01 s>",
    "\\eta = {<45.0 J>} / {<60.0 J>} * <100 %> = <75.0 %>",
    "s = <½> * <3.00 m/s^2> * <4.00 s> ² = <24.0 m>",
    "y = - lg <2.0 -4> = <3.70>",
    "T_1 = <25.0> + <273.15> = <298.15>",
];

const TIMES: [&str; 8] = [r"\cdot ", r"\times ", "*", r"\ast ", "×", r"{\cdot}", r"\,\cdot\,", r"\bullet "];
const TENS: [&str; 8] = [
    r"\times 10^{#}",
    r"\cdot10^{#}",
    r"\times{10}^{#}",
    "E#",
    r"\text{e}#",
    r"\mathrm{E}{#}",
    r"(10^{#})",
    r"\cdot(10)^{#}",
];
const UNITS: [&str; 11] = [
    r"\,\mathrm{#}",
    r"\ \text{#}",
    r"~{\rm #}",
    r"\;\mathsf{#}",
    r"\,\left[\mathrm{#}\right]",
    r"\,\textcolor{gray}{\mathrm{#}}",
    r"\hspace{0.5mm}\operatorname{#}",
    r"\mbox{ #}",
    r"{\color{blue}\,\mathrm{#}}",
    r"\thinspace\textup{#}",
    r"\u{#}",
];
const DEGREES: [&str; 8] =
    [r"^\circ", "°", r"^{o}", r"^0", r"\,^{\circ}", r"^{\text{o}}", r"\degree", r"\text{ degrees}"];
const BRACKETS: [[&str; 2]; 6] = [
    ["(", ")"],
    [r"\left(", r"\right)"],
    ["[", "]"],
    [r"\bigl(", r"\bigr)"],
    [r"\lparen ", r"\rparen "],
    [r"\mleft(", r"\mright)"],
];
const THOUSANDS: [&str; 8] = ["", ",", r"\,", "{,}", r"\ ", "~", r"\:", "'"];
const RELATIONS: [&str; 7] = [
    "=",
    "&=",
    r"\;=\;",
    r"\mathrel{=}",
    r"\overset{(2)}{=}",
    r"\stackrel{\text{ab}}{=}",
    r"\hspace{1em}=\hspace{1em}",
];
const RESULTS: [&str; 14] = [
    "#",
    r"\boxed{#}",
    r"\underline{\underline{#}}",
    r"\color{red}{#}",
    r"\textcolor[rgb]{1,0,0}{#}",
    r"\fbox{$#$}",
    r"\colorbox{yellow}{$#$}",
    r"\underbrace{#}_{\text{so}}",
    r"\mathbf{#}",
    r"\Aboxed{#}",
    r"\bbox[yellow]{#}",
    r"\class{hl}{#}",
    r"\underset{\text{ans}}{#}",
    r"\framebox{$#$}",
];
const TAILS: [&str; 14] = [
    "",
    ".",
    r"\quad(3)",
    r"~~(3)",
    r"\hfill(3)",
    r"\hspace{2cm}(3)",
    r"\text{ (3 s.f.)}",
    r"\checkmark",
    r"\tag{3}",
    r"\quad\because 2<3",
    r"\footnotemark[2]",
    r"\eqno(5)",
    r"\qquad\text{for } n=3",
    r"\ \text{each}",
];
const FRAMES: [[&str; 2]; 7] = [
    ["So $", "$."],
    ["$$", "$$\n"],
    [r"\[", "\\]\n"],
    ["\\begin{align*}\n", "\n\\end{align*}"],
    ["$$\\begin{aligned}", "\\end{aligned}$$"],
    ["\\begin{equation}", "\\end{equation}"],
    ["Text\\footnote{It is $", "$.}"],
];

/// How the chains of a text are written, the same for all of them.
struct Style(u64);

impl Style {
    /// One of the ways in a list.
    fn of<T: Copy>(&self, list: &[T]) -> T {
        let mut dice = fastrand::Rng::with_seed(self.0 ^ ((list.len() as u64) << 32));
        list[dice.usize(0..list.len())]
    }

    fn digits(&self, digits: &str) -> String {
        match digits.split_at_checked(2).filter(|_| digits.len() == 5 && !digits.contains('.')) {
            Some((thousands, rest)) => format!("{thousands}{}{rest}", self.of(&THOUSANDS)),
            None => digits.to_owned(),
        }
    }

    /// A number or a quantity from its digits, its exponent and its unit.
    fn quantity(&self, inner: &str) -> String {
        if inner == "½" {
            return (self.of(&[r"\frac12", r"\tfrac{1}{2}", "½", "0.5"])).to_owned();
        }
        let mut parts = inner.split(' ').peekable();
        let mut out = self.digits(parts.next().unwrap_or_default());
        if let Some(power) = parts.next_if(|part| part.parse::<i32>().is_ok()) {
            out += &self.of(&TENS).replace('#', power);
        }
        match parts.next() {
            Some("°") => out += self.of(&DEGREES),
            Some("%") => out += r"\,\%",
            Some(unit) => {
                let unit =
                    unit.replace('Ω', r"\Omega").replace("m/s^2", self.of(&["m/s^2", r"m\,s^{-2}", r"\frac{m}{s^2}"]));
                let unit = self.of(&UNITS).replace('#', &unit);
                // Text has no exponents.
                let textual = ["\\text{", "\\mbox{", "\\textup{"].into_iter().find(|name| unit.contains(name));
                let signs = inner.contains('^') || inner.contains('Ω');
                out += &textual.filter(|_| signs).map_or(unit.clone(), |name| unit.replace(name, r"\,\mathrm{"));
            }
            None => {}
        }
        out
    }

    /// A side of a chain.
    fn side(&self, side: &str) -> String {
        let [open, close] = self.of(&BRACKETS);
        let stacked = self.of(&[true, true, true, false, false]);
        let over = self.of(&[r"\frac", r"\dfrac", r"\tfrac", r"\cfrac", r"\genfrac{}{}{}{}", "over"]);
        if let Some((above, below)) = side.split_once("} / {") {
            let (before, above) = above.split_once('{').unwrap_or(("", above));
            let (below, behind) = below.split_once('}').unwrap_or((below, ""));
            let [above, below] = [above, below].map(|part| self.side(part));
            let quotient = match (stacked, over) {
                (true, "over") => format!("{{{above} \\over {below}}}"),
                (true, over) => format!("{over}{{{above}}}{{{below}}}"),
                (false, _) => format!("{open}{above}{close}/{open}{below}{close}"),
            };
            return self.side(before) + &quotient + &self.side(behind);
        }
        if let Some((before, root)) = side.split_once("√ {") {
            let (of, _) = root.split_once('}').unwrap_or((root, ""));
            let inner = self.side(&format!("{{{}}}", of.replace(" / ", "} / {")));
            let root = [r"\sqrt{#}", r"\sqrt[2]{#}", r"\left(#\right)^{1/2}", r"\sqrt{\,#\,}"];
            return self.side(before) + &self.of(&root).replace('#', &inner);
        }
        let mut out = String::new();
        let mut rest = side;
        while let Some(c) = rest.chars().next() {
            if c == '<' {
                let end = rest.find('>').unwrap_or(rest.len() - 1);
                let of_power = rest[end + 1..].trim_start().starts_with('²');
                let quantity = self.quantity(&rest[1..end]);
                out += &if of_power { format!("{open}{quantity}{close}") } else { quantity };
                rest = &rest[end + 1..];
                continue;
            }
            rest = &rest[c.len_utf8()..];
            match c {
                '*' => out += self.of(&TIMES),
                '²' => out += "^2",
                'π' => out += self.of(&[r"\pi ", "π", r"\uppi ", r"\mathrm{\pi}"]),
                ' ' => {}
                c => out.push(c),
            }
        }
        let cosine = self.of(&[r"\cos ", r"\mathrm{cos}\,", r"\operatorname{cos}", r"{\rm cos}\;"]);
        let log = self.of(&[r"\log_{10}", r"\lg ", r"\log ", r"\text{log}"]);
        let argument = |name: &str, known: &str, out: String| match out.split_once(name) {
            Some((before, of)) => format!("{before}{known}{open}{of}{close}"),
            None => out,
        };
        argument("lg", log, argument("cos", cosine, out))
    }

    /// A chain as a document.
    fn document(&self, chain: &str) -> String {
        let mut sides: Vec<String> = chain.split(" = ").map(|side| self.side(side)).collect();
        if let Some(last) = sides.last_mut() {
            *last = self.of(&RESULTS).replace('#', last);
        }
        let [begin, end] = self.of(&FRAMES);
        let aligned = begin.contains("align");
        let relation = self.of(&RELATIONS);
        let relation = if aligned { relation } else { relation.trim_start_matches('&') };
        let row = if aligned && self.0.is_multiple_of(2) && relation == "&=" { " \\\\\n&= " } else { relation };
        let [label, first, rest @ ..] = sides.as_slice() else { return String::new() };
        let chain = [&[format!("{label} {relation} {first}")], rest].concat().join(row);
        format!("\\newcommand{{\\u}}[1]{{\\,\\mathrm{{#1}}}}\n{begin}{chain}{}{end}\n", self.of(&TAILS))
    }
}

/// A chain with the second digit of its result changed.
fn wrong(chain: &str) -> String {
    let at = chain.rfind("= <").map_or(0, |at| at + 3);
    let at = at + chain[at..].find(|c: char| c.is_ascii_digit() && c != '0').unwrap_or(0);
    let next = ((chain.as_bytes()[at] - b'0') % 9 + 1).to_string();
    format!("{}{next}{}", &chain[..at], &chain[at + 1..])
}

fn found(text: &str) -> Vec<ChainFinding> {
    let options = CheckOptions { name_policy: NamePolicy::Never, agreeing: true, hints: 0, ..CheckOptions::default() };
    proofread(text, TextFormat::Latex, options).expect("a text").findings
}

#[test]
fn a_right_chain_is_never_listed_however_it_is_written() {
    let (mut read, mut all) = (0, 0);
    for seed in 0..100 {
        let style = Style(seed);
        let text: String = CHAINS.iter().map(|chain| style.document(chain) + "\n").collect();
        let findings = found(&text);
        let listed = findings
            .iter()
            .filter(|of| matches!(of.section, ReportSection::Numbers | ReportSection::LessCertain))
            .map(|of| format!("{} | {}", of.left, of.right));
        assert_eq!(listed.collect::<Vec<_>>(), [""; 0], "seed {seed}:\n{text}");
        read += findings.iter().filter(|of| of.section == ReportSection::Agreeing).count().min(CHAINS.len());
        all += CHAINS.len();
    }
    // A reader that reads nothing would list nothing.
    assert!(100 * read > 80 * all, "only {read} of {all} are read");
}

#[test]
fn a_wrong_digit_is_listed_however_the_chain_is_written() {
    let (mut listed, mut all) = (0, 0);
    for seed in 0..20 {
        for chain in CHAINS {
            let findings = found(&Style(seed).document(&wrong(chain)));
            listed += usize::from(
                findings.iter().any(|of| matches!(of.section, ReportSection::Numbers | ReportSection::LessCertain)),
            );
            all += 1;
        }
    }
    assert!(100 * listed > 75 * all, "only {listed} of {all} are listed");
}

#[test]
fn upright_letters_of_mathml_are_a_unit_and_a_sign_is_no_letter() {
    let speed = |last: &str| {
        format!(
            "<math><mn>36</mn><mspace width=\"0.167em\"/><mstyle mathvariant=\"normal\"><mi>k</mi><mi>m</mi><mi>/</mi><mi>h</mi></mstyle>\
             <mo>=</mo><mn>{last}</mn><mstyle mathvariant=\"normal\"><mi>m</mi><mi>/</mi><mi>s</mi></mstyle></math>"
        )
    };
    let force = |last: &str| {
        format!(
            "<math><mn>2.0</mn><mstyle mathvariant=\"normal\"><mi>k</mi><mi>g</mi></mstyle><mo>·</mo><mn>9.81</mn>\
             <mstyle mathvariant=\"normal\"><mi>m</mi><mi>/</mi><msup><mi>s</mi><mn>2</mn></msup></mstyle><mo>=</mo><mn>{last}</mn>\
             <mi mathvariant=\"normal\">N</mi></math>"
        )
    };
    for (chain, right, wrong) in [(&speed as &dyn Fn(&str) -> String, "10", "12"), (&force, "19.6", "16.9")] {
        assert_eq!(crate::report(&chain(right), TextFormat::Html).tally.checked, 1, "{}", chain(right));
        assert_eq!(crate::wrong(&chain(right), TextFormat::Html), [""; 0]);
        assert_eq!(crate::wrong(&chain(wrong), TextFormat::Html).len(), 1);
    }
}
