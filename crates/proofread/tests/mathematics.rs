//! What texts of mathematics write: each kind of notation in right chains of ours that must not be listed, beside wrong ones that must.

use crate::report;
use crate::unusual::{listed, unlisted};
use proofread::TextFormat::{Html, Latex, Markdown, Plain};

#[test]
fn a_factorial_may_end_a_formula() {
    unlisted(Markdown, &[r"$5! = 5\cdot 4!$", r"$3\cdot 2\cdot 1 = 3!$", r"So $\binom{5}{2}\cdot 2! = 5!/3!$."]);
    listed(Markdown, &[r"$5! = 6\cdot 4!$", r"$3\cdot 2\cdot 2 = 3!$", r"So $\binom{5}{2}\cdot 3! = 5!/3!$."]);
}

#[test]
fn a_factorial_of_several_steps_is_not_checked() {
    unlisted(Markdown, &[r"$6!^{(2)} = 6\cdot 4\cdot 2$", r"$7!^{(3)} = 28$"]);
    listed(Markdown, &[r"$6!^2 = 518401$", r"$6! = 6\cdot 4\cdot 2$"]);
}

#[test]
fn a_relation_with_a_doubt_above_it_is_no_equation() {
    for above in
        ["?", r"\text{?}", r"\textbf{?}", r"\mathrm{?}", "??", "no", r"\text{no}", r"\mbox{no}", "✗", r"\text{✗}"]
    {
        for command in ["stackrel", "overset"] {
            unlisted(Latex, &[&format!(r"Check $5+2\{command}{{{above}}}{{=}}3$.")]);
        }
        let by_macro = format!(r"\newcommand{{\wonder}}[1]{{\overset{{{above}}}{{#1}}}} $5+2\wonder{{=}}3$");
        unlisted(Latex, &[&by_macro]);
        // In a text in the formula, too.
        unlisted(Latex, &[&format!(r"$x = 4 \text{{ and $5+2 \overset{{{above}}}{{=}} 3$}}$")]);
    }
    listed(
        Latex,
        &[
            r"$5+2\stackrel{\text{(2)}}{=}3$",
            r"$5+2\overset{\textbf{yes}}{=}3$",
            r"\newcommand{\sure}[1]{\overset{*}{#1}} $5+2\sure{=}3$",
            r"$x = 4 \text{ and $5+2 = 3$}$",
        ],
    );
}

#[test]
fn equal_roots_of_negative_numbers_are_equal() {
    unlisted(
        Markdown,
        &[r"$\sqrt{-12} = \sqrt{-1\cdot 4\cdot 3}$", r"$\frac{2\pm\sqrt{4-8}}{2} = \frac{2\pm\sqrt{-4}}{2}$"],
    );
    listed(Markdown, &[r"$\sqrt{-12} = 3.46$", r"$\sqrt{12} = \sqrt{4\cdot 4}$"]);
}

#[test]
fn two_values_may_come_in_either_order() {
    unlisted(
        Markdown,
        &[r"$\frac{-6 \pm\sqrt{36 - 4\cdot 2}}{-2} = 3\pm\sqrt 7$", r"$5\pm 2 = 5\pm\sqrt 4$", r"$5 \mp 2 = 5 \pm 2$"],
    );
    listed(Markdown, &[r"$\frac{-6 \pm\sqrt{36 - 4\cdot 2}}{-2} = 3\pm\sqrt 6$", r"$5 \mp 2 = 5 \pm 3$"]);
}

#[test]
fn pi_may_be_a_name() {
    unlisted(
        Markdown,
        &[
            r"The prior is $\pi(0.2) = 0.3$ and $\pi(0.5) = 0.7$.",
            r"There are $\pi(10^3) = 168$ primes.",
            r"So $\frac{1}{\pi} = \frac{1}{1-\pi}$.",
            r"Let $(-1)^\pi = 1$ if $\pi$ is even.",
        ],
    );
    listed(
        Markdown,
        &[
            r"$\pi(0.2)^2 = 0.226$",
            r"$\pi \cdot 10^3 = 3412$",
            r"$1/\pi = 0.381$",
            r"$2(1-\pi) = -4.823$",
            r"$(2+1)^\pi = 31.45$",
        ],
    );
}

#[test]
fn a_product_of_pairs_is_what_the_text_defines() {
    unlisted(
        Markdown,
        &[
            r"Define $(a,b)\times(c,d)=(ac-bd,ad+bc)$. Then $(0,1)\times(0,1)=(-1,0)$.",
            r"$(1,2)\times(3,4)=(3,8)$",
            r"$(1,2,3)\times(0,1,1)=(-1,-1,1)$",
        ],
    );
    listed(Markdown, &["$(0,1)+(0,1)=(0,3)$", r"$(1,2,3)\times(0,1,1)=(-1,-1,2)$"]);
}

#[test]
fn a_ring_or_a_group_may_be_named_before() {
    let after =
        |named: &str, chain: &str| format!("{named} We come to the sums. Here is one more sentence. So ${chain}$.");
    for (named, modulus) in
        [(r"Look at $\mathbb{Z}_6$.", 6), (r"Take $\mathbb Z/7\mathbb Z$.", 7), ("Work in $U(9)$.", 9)]
    {
        let sum = |by: i32| format!(r"4\cdot 5 = {}", 20 - by);
        unlisted(Markdown, &[&after(named, &sum(modulus)), &after(named, &sum(2 * modulus))]);
        listed(Markdown, &[&after(named, &sum(modulus + 1))]);
    }
    // Neither is a modulus.
    for named in ["The group is $SU(2)$.", "The energy is $U(2) = 5$.", r"Let $a\in\mathbb{Z}$, 2 of them.", "In R(2)."]
    {
        listed(Markdown, &[&after(named, r"4\cdot 5 = 18")]);
    }
}

#[test]
fn sums_that_are_false_on_purpose_are_known() {
    unlisted(
        Markdown,
        &[
            r"The code adds: $$\begin{aligned}1+1&=0\\0+1&=1\end{aligned}$$",
            r#"either "$2+2=4$ or $2+2=5$" is true"#,
            "One believes that $1+1=3$.",
            "True or false: $3+4=8$.",
            "$3+4=8$ (true or false)",
            "So $1^2+5^2=2^2$???",
            r"This gives $8 \equiv 13 \pmod{15}$, which is no longer true.",
        ],
    );
    listed(
        Markdown,
        &[
            "We get $2+2=5$ here.",
            "We get $1+1=3$ here.",
            "$1^2+5^2=2^2$. What now?",
            r"This gives $8 \equiv 13 \pmod{15}$.",
        ],
    );
}

#[test]
fn answers_to_choose_from_are_not_asserted() {
    unlisted(
        Markdown,
        &[
            r"Which is it? (A) $\ln(1.1)\approx 2.1$ (B) $\ln(1.1)\approx -0.1$ (C) $\ln(1.1)\approx 0.1$",
            "(A) $3+4=8$\n\n(B) $3+4=9$",
        ],
    );
    listed(Markdown, &[r"By (A) $\ln(1.1)\approx 2.1$, and so on.", "(A) The sum is $3+4=8$. (B) It is large."]);
}

#[test]
fn lists_make_no_decimal_commas() {
    for list in [r"1,0,\ldots,0", "1,-1,0", "(-1,-1,2)", "-1,-2,-3"] {
        let text =
            |result: &str| format!(r"The values are ${list}$. The distance is $\frac12\sqrt{{48}}\approx {result}$.");
        unlisted(Latex, &[&text("3.464")]);
        listed(Latex, &[&text("3.664")]);
    }
    unlisted(Latex, &["$(-1,-1,2)+(1,1,1)=(0,0,3)$", "$1,5+2,5=4,0$"]);
    listed(Latex, &["$(-1,-1,2)+(1,1,1)=(0,0,2)$", "$1,5+2,5=4,5$"]);
}

#[test]
fn aligned_equations_are_parted() {
    let rows = |inner: &str| format!("\\begin{{align*}}{inner}\\end{{align*}}");
    for (right, wrong) in [
        ("x&=9&(1+2)^2&=9", "x&=9&(1+2)^2&=8"),
        (r"(-5)^2+13(-5)+40&=0&(-8)^2+13(-8)+40&=0", r"(-5)^2+13(-5)+40&=0&(-8)^2+13(-8)+40&=1"),
        (r"2\cdot 3 &= 6 \\ 2\cdot 4 &= 8 \\ 2\cdot 5 &= 10", r"2\cdot 3 &= 6 \\ 2\cdot 4 &= 9 \\ 2\cdot 5 &= 10"),
        (r"2\cdot 3 &= 6 \\[6pt] \frac14 &= 0.25", r"2\cdot 3 &= 6 \\[6pt] \frac14 &= 0.35"),
        (r"2\cdot 3 &= 6. \\ (1+3)^2 &= 16.", r"2\cdot 3 &= 6. \\ (1+3)^2 &= 17."),
        (
            r"x &= 2\cdot 3 \\ &= 6 & &\text{(1)} \\ 2\cdot 4 &= 8",
            r"x &= 2\cdot 3 \\ &= 6 & &\text{(1)} \\ 2\cdot 4 &= 9",
        ),
        (r"x &= 1 + 2 \\ &\quad {}+ 3 = 6", r"x &= 1 + 2 \\ &\quad {}+ 3 = 7"),
        // What begins with a sign goes on from the row before.
        (r"x &= 2\cdot 3 \\ + 4 &= 10", r"x &= 2\cdot 3 \\ &= 7 \\ + 4 &= 10"),
        (r"2+1 &\stackrel{?}{=} 6 & (1+1)^2 &\stackrel{?}{=} 5", r"2+1 &= 6 & (1+1)^2 &\stackrel{?}{=} 5"),
    ] {
        unlisted(Latex, &[&rows(right)]);
        listed(Latex, &[&rows(wrong)]);
    }
    // Each of them is compared.
    assert_eq!(report(&rows(r"2\cdot 3 &= 6 \\ 2\cdot 4 &= 8 \\ 2\cdot 5 &= 10"), Latex).tally.checked, 3);
}

#[test]
fn items_of_a_list_are_no_rows_of_a_chain() {
    unlisted(Latex, &["\\item $b=\\frac{1}{4}$\n\\item $b=5$"]);
    listed(Latex, &["$b=\\frac{1}{4}$\n$b=5$"]);
}

#[test]
fn a_value_with_its_sign_may_be_in_a_group() {
    unlisted(
        Latex,
        &[
            r"$2+{\color{blue}{{-3}}} = -1$",
            r"$2\cdot{-3} = -6$ and $6/{-3} = -2$",
            r"$2\cdot{-}3 = -6$",
            r"\newcommand{\put}[1]{{\color{red}{#1}}} $5-2\put{(-2)}+\put{-4} = 5$",
        ],
    );
    listed(Latex, &[r"$2+{\color{blue}{{-3}}} = 0$", r"$2\cdot{-3} = 6$", r"$2\cdot{-}3 = -5$"]);
    assert_eq!(report(r"$2\cdot{-}3 = -6$ and $2+{-3} = -1$", Latex).tally.checked, 2);
}

#[test]
fn p_of_two_integers_counts_permutations() {
    unlisted(
        Markdown,
        &[
            "$P(9,2) = 72$",
            "With $P(n,k)$: $P(9,2) = 72$.",
            "Let $P(x,y) = x^2+y$. Then $P(3,2)=11$.",
            "The cost is $C(x, y)=2x+y$, so $C(5,3)=13$.",
            "Its probability is $P(1,0) = 0.5$.",
            "The point $P(3,2)$ lies on it.",
        ],
    );
    listed(Markdown, &["$P(9,2) = 73$", "With $P(n,k)$: $P(9,2) = 73$.", "$C(5,3)=13$"]);
}

#[test]
fn an_equation_in_a_text_in_a_formula_is_one_of_its_own() {
    unlisted(
        Latex,
        &[
            r"\[4x=8 \qquad \text{$y(0)=3$}.\]",
            r"\[4\cdot 2=8 \qquad \text{and $2+2=4$ with $m(1)=3$}.\]",
            r"\[2\cdot 3 = 6 \text{ \$ if $n=3$}\]",
        ],
    );
    listed(Latex, &[r"\[4\cdot 2=8 \quad \text{with $2+2=5$}.\]", r"\[4\cdot 2=9 \quad \text{with $2+2=4$}.\]"]);
}

#[test]
fn siunitx_may_have_another_base() {
    unlisted(Latex, &[r"$\SI[exponent-base=e]{e0.11}{\percent}\approx\SI{1.1163}{\percent}$"]);
    listed(Latex, &[r"$\SI[scientific-notation=true]{2e1}{m}=\SI{30}{m}$"]);
}

#[test]
fn a_size_is_no_product() {
    unlisted(Markdown, &[r"Output: $(7-3)/1+1 = 5\times 5$", r"$28/4 = 7 × 7$"]);
    listed(Markdown, &[r"Output: $(7-3)/1+1 = 5\times 6$", r"$(7-3)/1+1 = 5\cdot 5$", r"$28/4 = 8 × 8$"]);
}

#[test]
fn an_argument_ends_the_name_of_a_command_before_it() {
    let text = |last: &str| {
        format!(r"\newcommand{{\av}}[1]{{\lvert#1\rvert}} $\av{{x}}=2$ and $\av{{\pi-\pi}}+\av{{-3}}={last}$")
    };
    unlisted(Latex, &[&text("3")]);
    listed(Latex, &[&text("4")]);
}

#[test]
fn arctan2_is_a_function_of_two_numbers() {
    unlisted(Markdown, &[r"$\beta = \arctan2(200, 450) = 23.96°$", r"$\arctan 2 = 63.4^\circ$"]);
    listed(Markdown, &[r"$\arctan 2 = 64.4^\circ$"]);
}

#[test]
fn an_angle_with_pi_is_never_in_degrees() {
    unlisted(Markdown, &[r"$\sin(\pi/6) = 0.5$ and $\sin(30)=0.5$", r"$\cos(30\cdot\pi/180) = 0.866$"]);
    // The sine of as many degrees.
    listed(Markdown, &[r"$2\sin(\pi/4) = 0.0274$"]);
    let text = r"$2\cdot\frac{\pi}{2} - 2\sin(\frac{\pi}{2}) = \pi - 1$";
    let found = report(text, Markdown).findings;
    assert!(found.iter().any(|of| of.recomputed.as_deref().is_some_and(|told| told.starts_with("1.142"))), "{found:?}");
}

#[test]
fn a_whole_formula_may_begin_with_its_result() {
    unlisted(Markdown, &["$8 = 2^3$", r"$15 = 3\cdot 5$", "So 8 = 2^4", "- 149 = +88", "- 61 = +5", "$0 = 1-1+1$"]);
    listed(Markdown, &["$8 = 2^4$", r"$15 = 3\cdot 4$", r"$26 = 5^2$"]);
}

#[test]
fn a_scale_of_lengths_is_a_convention() {
    for said in ["Choose and mark a length scale, say", "On the drawing,", "The scale is"] {
        unlisted(
            Markdown,
            &[&format!("{said} 1 cm = 20 mm. Draw it."), &format!(r"{said} $1\text{{ cm}} = 40\text{{ mm}}$.")],
        );
    }
    listed(
        Markdown,
        &[
            "Here 1 cm = 20 mm. Draw it.",
            r"On the drawing, $3.5\text{ cm} = 41\text{ mm}$.",
            r"On that scale, $2.00\text{ cm} = 25.0\text{ mm}$.",
        ],
    );
    unlisted(Plain, &["2 moles = 44.8 L"]);
}

#[test]
fn a_sum_in_html_is_exact_too() {
    let sum = |result: &str| format!("<p><math><mn>4</mn><mo>+</mo><mn>5</mn><mo>=</mo><mn>{result}</mn></math></p>");
    unlisted(Html, &[&sum("9")]);
    listed(Html, &[&sum("10")]);
}

#[test]
fn a_bar_is_about_the_terms_with_a_variable() {
    unlisted(
        Markdown,
        &[
            r"$\frac{1}{3}+\frac{x^2}{2}\Big|_0^1=\frac{5}{6}$",
            r"$4 - 2.5 - \frac{x^2}{2}\Big|_0^1 = 1$",
            r"$x^2 + 5\Big|_0^1 = 1$",
            r"$(3 + x)\Big|_0^1 = 1$",
        ],
    );
    listed(
        Markdown,
        &[
            r"$\frac{1}{3}+\frac{x^2}{2}\Big|_0^1=\frac{1}{2}$",
            r"$4 - 2.5 - \frac{x^2}{2}\Big|_0^1 = 2$",
            r"$x^2 + 5\Big|_0^1 = 6$",
            r"$(3 + x)\Big|_0^1 = 4$",
        ],
    );
}

#[test]
fn a_sign_behind_a_dot_is_that_of_a_factor_of_matrices() {
    let of = |result: &str| {
        format!(
            r"$$\begin{{pmatrix}}1&0\\0&3\end{{pmatrix}}\cdot -\frac{{1}}{{2}}\begin{{pmatrix}}2&0\\0&2\end{{pmatrix}} = {result}$$"
        )
    };
    unlisted(Markdown, &[&of(r"\begin{pmatrix}-1&0\\0&-3\end{pmatrix}")]);
}

#[test]
fn thousands_may_be_parted_by_a_comma_and_a_blank() {
    unlisted(Markdown, &["There are n! = 8! = 40, 320 ways.", "It is $8! = 40, 320$."]);
    listed(Markdown, &["It is $8! = 40321$.", "It is $8! = 41, 32$."]);
}

#[test]
fn a_letter_with_an_argument_or_an_index_is_a_value_of_its_own() {
    unlisted(
        Markdown,
        &[r"$\mathrm{T}(4) = 0.1088$", r"$\hat y(-2) = 3 - 0.5(-2) = 4.$", r"We have $n = 400$ and $\pi^0 = 0.4$."],
    );
    let estimate =
        |letter: &str| format!("<math><mrow><mtext>{letter}(6)</mtext><mo>=</mo><mn>0.2137</mn></mrow></math>");
    unlisted(Html, &[&estimate("M"), &estimate("T")]);
    listed(Markdown, &[r"$\hat y(-2) = 3 - 0.5(-2) = 5$", r"$2\pi^0 = 3$", r"$4\,\mathrm{V}(2) = 12\,\mathrm{V}$"]);
}

#[test]
fn base_ten_is_the_usual_one() {
    unlisted(Markdown, &["So $16 + 112 = 240$ in base 5 here.", "So $16 + 112 = 130$ (base 8)."]);
    listed(
        Markdown,
        &["So $16 + 112 = 125$ in base 10.", "So $16 + 112 = 125$ in base ten.", "With base 8 it is $16 + 112 = 125$."],
    );
}
