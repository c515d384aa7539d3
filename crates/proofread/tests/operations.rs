//! Operations with names and signs of their own: each in a chain of ours that must not be listed, beside one that must.

use crate::report;
use proofread::{ReportSection, TextFormat};

/// Each of these holds, and it is compared.
#[track_caller]
fn holds(texts: &[&str]) {
    for text in texts {
        let found = report(text, TextFormat::Markdown).findings;
        assert!(!found.is_empty(), "nothing is compared in {text}");
        assert!(found.iter().all(|of| of.section == ReportSection::Agreeing), "{text}: {found:#?}");
    }
}

/// Each of these is listed.
#[track_caller]
fn fails(texts: &[&str]) {
    for text in texts {
        let found = report(text, TextFormat::Markdown).findings;
        assert!(found.iter().any(|of| of.section == ReportSection::Numbers), "{text}: {found:#?}");
    }
}

/// Nothing is compared in these.
#[track_caller]
fn silent(texts: &[&str]) {
    for text in texts {
        let found = report(text, TextFormat::Markdown).findings;
        assert!(found.iter().all(|of| of.section != ReportSection::Numbers), "{text}: {found:#?}");
    }
}

#[test]
fn choices_are_counted() {
    holds(&[
        r"$\binom{8}{3} = 56$ and $\dbinom83 = \frac{8!}{3!\,5!}$",
        r"${9 \choose 2} = 36$",
        r"${}_8C_3 = 56$ and $_8P_2 = 56$ and ${}^8C_3 = 56$",
        r"$C(9,2) = 36$ and $9C2 = 36$",
        "9P2 = 9 × 8 = 72",
        r"$\binom{9}{2,3,4} = 1260$",
        r"$\binom{60}{30} \approx 1.18\times10^{17}$",
    ]);
    fails(&[
        r"$\binom{8}{3} = 65$",
        r"${9 \choose 2} = 63$",
        r"${}_8C_3 = 65$",
        r"$C(9,2) = 63$",
        "9C2 = 63",
        r"$\binom{9}{2,3,4} = 1620$",
    ]);
    silent(&[r"$\binom{n}{3} = 56$", r"$P(9,2) = 0.5$", r"$\binom{1000000}{500000} = 3$"]);
}

#[test]
fn factorials_may_fall_and_rise() {
    holds(&[
        r"$8^{\underline{3}} = 8\cdot7\cdot6 = 336$",
        r"$5^{\overline{3}} = 210$",
        r"$x^{\underline2}$ and $6^{\underline2}=30$",
    ]);
    fails(&[r"$8^{\underline{3}} = 363$", r"$5^{\overline{3}} = 201$"]);
}

#[test]
fn lists_have_a_largest_number_and_a_divisor() {
    holds(&[
        r"$\max(3, 8) = 8$ and $\min\{9, 2+5\} = 7$",
        r"$\gcd(18,24) = 6$ and $\operatorname{lcm}(6, 8) = 24$",
        r"$\gcd(462,198) = 66$",
        r"$\max(0.25, 0.31) = 0.31$",
    ]);
    fails(&[
        r"$\max(3, 8) = 3$",
        r"$\min\{9, 2+5\} = 9$",
        r"$\gcd(18,24) = 8$",
        r"$\operatorname{lcm}(6, 8) = 48$",
        r"$\gcd(462,198) = 62$",
    ]);
    silent(&[r"$\max f = 3$", r"$\gcd(a,b) = 3$", r"in 5 min = 300 s"]);
}

#[test]
fn remainders_are_computed() {
    holds(&[
        r"$23 \bmod 7 = 2$ and $-3 \bmod 8 = 5$",
        r"$4 + 23 \bmod 7 = 6$",
        "Then 41 mod 6 = 5.",
        r"$(7\cdot8) \bmod 9 = 56 \bmod 9 = 2$",
    ]);
    fails(&[
        r"$23 \bmod 7 = 3$",
        r"$123 = 5 \bmod 7$",
        "Then 41 mod 6 = 4.",
        r"Modulo $11$ it holds since $9\cdot5 = 46 = 4\cdot11+1$.",
    ]);
    silent(&[
        r"In $\mathbb{Z}_7$, $5+4=2$.",
        r"Modulo $11$, $9\cdot5 = 1$ and $9^{-1} = 5$.",
        "On a clock 10 + 4 = 2.",
        r"$23 = 2 \bmod 7$",
        r"$20 \% -4 = 0$",
    ]);
}

#[test]
fn integer_parts_are_computed() {
    holds(&[
        r"$\lfloor 9/2 \rfloor = 4$ and $\left\lceil\frac{20}{3}\right\rceil = 7$",
        r"$\lfloor\log_2 500\rfloor+1 = 9$",
        r"$[\![4.6]\!] = 4$",
        "The middle is ⌊(3 + 8)/2⌋ = 5.",
        r"$\lfloor\pi\rfloor = 3$",
        r"$\lfloor -2.5\rfloor = -3$",
    ]);
    fails(&[
        r"$\lfloor 9/2 \rfloor = 5$",
        r"$\lceil 6.1 \rceil = 6$",
        r"$[\![4.6]\!] = 5$",
        "The middle is ⌊(3 + 8)/2⌋ = 6.",
    ]);
    silent(&[r"$\{-2.3\} = -2.3+3 = 0.7$", r"$\lfloor x\rfloor = 3$"]);
}

#[test]
fn decimals_may_go_on() {
    holds(&[
        r"$0.\overline{6} = \frac23$ and $0.58\overline{3} = \frac{7}{12}$",
        r"$\frac{3}{7} = 0.4285\ldots$",
        "5/6 = 0.8333… ≈ 0.83",
        r"$1 - \frac13 = 66.66...\%$",
    ]);
    fails(&[
        r"$0.\overline{6} = \frac35$",
        r"$\frac{3}{7} = 0.4385\ldots$",
        "5/6 = 0.8333… ≈ 0.93",
        r"$1 - \frac13 = 67.66...\%$",
        r"$2+4+6+\cdots+100 = 50\cdot51 = 2505$",
    ]);
    silent(&[r"$0.5, 0.25, \ldots = 1$"]);
}

#[test]
fn tuples_are_compared_by_their_components() {
    holds(&[
        r"$(4-0.5, 4+0.5) = (3.5, 4.5)$",
        r"$7 \pm 3 = (4, 10)$",
        r"$0.50 \pm 0.03 = [0.47, 0.53]$",
        r"$(1,2,3)\times(4,5,6) = (-3,6,-3)$",
        r"$(1,4)+(2,5) = (3,9)$ and $3(1,4) = (3,12)$ and $(1,4)\cdot(2,5) = 22$",
        r"$\begin{pmatrix}1\\4\end{pmatrix}+\begin{pmatrix}2\\5\end{pmatrix}=\begin{pmatrix}3\\9\end{pmatrix}$",
        r"$\frac{5\pm\sqrt{9}}{2} = \frac{5\pm3}{2}$",
    ]);
    fails(&[
        r"$(4-0.5, 4+0.5) = (3.5, 4.6)$",
        r"$7 \pm 3 = (4, 11)$",
        r"$0.50 \pm 0.03 = [0.47, 0.54]$",
        r"$(1,2,3)\times(4,5,6) = (-3,6,-5)$",
        r"$(1,4)+(2,5) = (3,8)$",
        r"$(1,4)\cdot(2,5) = 24$",
        r"$\begin{bmatrix}1\\4\end{bmatrix}+\begin{bmatrix}2\\5\end{bmatrix}=\begin{bmatrix}3\\8\end{bmatrix}$",
        r"$12.5\pm2.0\cdot0.6 = 12.5\pm1.8$",
    ]);
    silent(&[
        r"$\frac{5\pm3}{2} = 4$",
        r"$(12,18) = 6$",
        r"$2 \pm 3 = \{5, -1\}$ and $\{1,2\} = \{2,1\}$",
        r"$(1\,2)(2\,3) = 4$",
        r"$5.0\pm0.2\,\text{cm} = 5\,\text{cm}$",
        r"$(2.0\pm0.3)+(3.0\pm0.4) = 5.0\pm0.5$",
    ]);
}

#[test]
fn sums_over_an_index_are_computed() {
    holds(&[
        r"$\sum_{k=1}^{5} k^2 = 55$ and $\prod_{i=1}^{5} i = 120$",
        r"$\sum_{k=1}^{6}(2k-1) = 36$",
        r"$\sum_{n=0}^{3} 2n+1 = 16$",
        r"$\sum_{j=1}^{4}\frac{1}{2^j} = \frac{15}{16}$",
    ]);
    fails(&[
        r"$\sum_{k=1}^{5} k^2 = 56$",
        r"$\prod_{i=1}^{5} i = 102$",
        r"$\sum_{j=1}^{4}\frac{1}{2^j} = \frac{17}{16}$",
    ]);
    silent(&[
        r"$\sum_{k=1}^{n} k = 3$",
        r"$\sum_{k=1}^{1000000} k = 3$",
        r"$\sum_{k=1}^{3}\sum_{j=1}^{30} kj = 3$",
        r"$\sum x_i = 12$",
    ]);
}

#[test]
fn determinants_are_computed() {
    holds(&[
        r"$\begin{vmatrix}4&2\\1&3\end{vmatrix} = 12-2 = 10$",
        r"$\det\begin{pmatrix}2&0&1\\1&3&2\\0&1&1\end{pmatrix} = 3$",
    ]);
    fails(&[r"$\begin{vmatrix}4&2\\1&3\end{vmatrix} = 14$", r"$\begin{vmatrix}4&2\\1&3\end{vmatrix} = 12-2 = 11$"]);
    silent(&[
        r"$\begin{vmatrix}a&2\\1&3\end{vmatrix} = 14$",
        r"$\begin{pmatrix}4&2\\1&3\end{pmatrix} = 14$",
        r"$\begin{pmatrix}4&2\\1&3 = 14$",
    ]);
}

#[test]
fn matrices_are_compared_by_their_entries() {
    let m = |cells: &str| format!(r"\begin{{pmatrix}}{cells}\end{{pmatrix}}");
    let [a, b] = [m(r"2&1\\0&3"), m(r"1&4\\2&1")];
    let squared = r"\left[\begin{array}{cc}2&1\\0&3\end{array}\right]^2".to_owned();
    let cases = [
        (format!("{a}+{b}"), m(r"3&5\\2&4"), m(r"3&5\\2&5")),
        (format!("{a}{b}"), m(r"4&9\\6&3"), m(r"4&9\\6&7")),
        (format!(r"\frac12{a}-{b}"), m(r"0&-3.5\\-2&0.5"), m(r"0&-3.5\\-2&0.8")),
        (squared, m(r"4&5\\0&9"), m(r"4&5\\0&8")),
        (format!("{a}{}", m(r"3\\4")), m(r"10\\12"), m(r"10\\14")),
        (m(r"2\cdot3&1+1\\4&0"), m(r"6&2\\4&0"), m(r"6&3\\4&0")),
    ];
    for (side, right, wrong) in &cases {
        holds(&[&format!("${side} = {right}$")]);
        fails(&[&format!("${side} = {wrong}$")]);
    }
    silent(&[
        &format!("$({b})^{{-1}} = {a}$ and ${a}^T = {b}$ and ${a} = 5$"),
        &format!("$k{a} = {b}$ and ${a}{} = {b}$", m(r"1\\2\\3")),
        r"$\frac12\binom{4}{6} = \binom{2}{3}$",
        r"$\left[\begin{array}{l}2+3=5\\4+5=9\end{array}\right.$",
    ]);
}

#[test]
fn a_mixed_number_may_be_improper() {
    holds(&[r"$2\tfrac75 = 3\tfrac25$"]);
    fails(&[r"$2\tfrac75 = 3\tfrac35$"]);
}

#[test]
fn a_binomial_coefficient_may_be_one_of_a_series() {
    holds(&[
        r"$\binom{-3/2}{2} = \frac{(-3/2)(-5/2)}{2!} = \frac{15}{8}$",
        r"$\binom{-2}{3} = -4$",
        r"$\binom{1/2}{2} = -1/8 = -0.125$",
        r"$\binom{0.5}{0} = 1$ and $\binom{2}{5} = 0$",
    ]);
    fails(&[r"$\binom{-3/2}{2} = \frac{(-3/2)(-5/2)}{3!}$", r"$\binom{-2}{3} = 4$", r"$\binom{1/2}{2} = -1/4$"]);
    silent(&[r"$\binom{-2}{-1} = 4$", r"$\binom{-2}{1/2} = 4$", r"$\binom{-2}{100000} = 4$"]);
}

#[test]
fn a_double_factorial_takes_every_second_factor() {
    holds(&[r"$7!! = 7\cdot5\cdot3\cdot1 = 105$", "$8!! = 384$", r"$0!! = 1$ and $5!!\cdot 2 = 30$"]);
    fails(&[r"$7!! = 106$", "$8!! = 348$", r"$5!!\cdot 2 = 240$"]);
    silent(&["$7!!! = 29$", "$(-3)!! = 4$", "$1.5!! = 4$", "$9999!! = 4$"]);
}

#[test]
fn congruences_have_a_printed_modulus() {
    holds(&[
        r"$7+9 \equiv 4 \pmod{12}$",
        r"$17 \equiv 2 \pmod 5$, $-1 \equiv 4 \pmod 5$ and $-1 \equiv -6 \pmod 5$",
        r"$5\cdot 3\equiv 1\ (\mathrm{mod}\ 7)$ and $22 \equiv 1 \mod 7$",
        r"$2^{10} \equiv 1 \pmod{11}$ since $1024 \equiv 1 \pmod{11}$",
    ]);
    fails(&[
        r"$7+9 \equiv 3 \pmod{12}$",
        r"$17 \equiv 3 \pmod 5$",
        r"$-1 \equiv 3 \pmod 5$",
        r"$5\cdot 3\equiv 2\ (\mathrm{mod}\ 7)$",
        r"$22 \equiv 2 \mod 7$",
        r"so $2^{10} \equiv 2 \pmod{11}$.",
    ]);
    silent(&[
        r"$7+9 \equiv 3$",
        r"$x \equiv 3 \pmod{12}$ and $7 \equiv 3 \pmod n$",
        r"$2 \equiv 3 \pmod 0$",
        r"$2^{100} \equiv 3 \pmod{11}$",
        r"$5+2\stackrel{?}{\equiv}3 \pmod 5$ and $5+2\stackrel{?}{=}3 \pmod 5$",
        r"$7+9 \not\equiv 3 \pmod{12}$",
    ]);
}

#[test]
fn a_hint_for_a_congruence_names_what_is_printed() {
    for text in [r"$7+9 \equiv 3 \pmod{12}$", r"$123 \equiv 44 \pmod{89}$", r"$1024 \equiv 56 \pmod{121}$"] {
        let found = report(text, TextFormat::Markdown).findings;
        assert_eq!(found.len(), 1, "{text}");
        for hint in found.iter().filter_map(|of| of.hint.as_ref()) {
            let printed = hint.words.rsplit('`').nth(1).expect("what is printed");
            assert_eq!(&text[hint.at.range()], printed, "{text}: {hint:?}");
        }
    }
}

#[test]
fn an_inverse_has_a_modulus() {
    holds(&[r"$3^{-1} \bmod 7 = 5$", r"$3^{-1} \bmod 7 = 3^5 \bmod 7 = 5$", r"$3^{-1} \equiv 5 \pmod 7$"]);
    fails(&[r"$3^{-1} \bmod 7 = 6$", r"$3^{-1} \equiv 6 \pmod 7$"]);
    silent(&[r"$2^{-1} \bmod 4 = 2$", r"$0.5 \bmod 7 = 3$", r"$3^{-1} \bmod 0 = 5$", r"$3^{-1} \bmod 1 = 5$"]);
}

#[test]
fn the_first_of_four_sizes_is_shown() {
    let text = |last: &str| {
        format!(r"\newcommand{{\hl}}[1]{{\mathchoice{{\displaystyle #1}}{{#1}}{{#1}}{{#1}}}} $2+3 = \hl{{{last}}}$")
    };
    let of = |last: &str| crate::wrong(&text(last), TextFormat::Latex).len();
    assert_eq!((of("5"), of("6")), (0, 1));
}

#[test]
fn dots_stand_for_the_terms_of_an_arithmetic_progression() {
    holds(&[
        r"$1+2+3+\cdots+10 = 55$",
        r"$1+3+\dots+99 = \frac{50\cdot 100}{2} = 2500$",
        r"$2(10+9+\ldots+1) = 110$",
        "1 + 2 + ... + 100 = 5050",
    ]);
    fails(&[
        r"$1+2+3+\cdots+10 = 65$",
        r"$1+3+\dots+99 = \frac{50\cdot 100}{2} = 2501$",
        r"$2(10+9+\ldots+1) = 120$",
        "1 + 2 + ... + 100 = 5150",
    ]);
    silent(&[
        r"$2+4+\cdots+64 = 126$",
        r"$1+4+9+\cdots+100 = 386$",
        r"$1+\cdots+10 = 65$",
        r"$1+2+\cdots+n = 65$",
        r"$1+2+\cdots+10^2 = 65$",
    ]);
}

#[test]
fn a_modulus_behind_the_last_row_may_hold_for_those_before() {
    let rows = |rows: &str| format!(r"$$\begin{{aligned}} 7 \cdot 8 {rows} \end{{aligned}}$$");
    holds(&[
        &rows(r"&= 56 \\ &= 4 \pmod{13}"),
        &rows(r"&= 56 \pmod{13} \\ &= 17 \pmod{13} \\ &= 4 \pmod{13}"),
        &rows(r"= 4 \pmod{13}"),
    ]);
    fails(&[
        &rows(r"&= 56 \\ &= 5 \pmod{13}"),
        &rows(r"&= 56 \pmod{13} \\ &= 17 \pmod{13} \\ &= 5 \pmod{13}"),
        &rows(r"= 5 \pmod{13}"),
    ]);
    silent(&[&rows(r"&= 56 \\ &= 17 \\ &= 4 \pmod{13}"), &rows(r"&= x \\ &= 5 \pmod{13}"), &rows(r"&= 5 \pmod{p}")]);
}
