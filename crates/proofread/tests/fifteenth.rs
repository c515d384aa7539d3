//! What the judges of a fifteenth first contact named, as kinds: right chains of ours that must not be listed, beside wrong ones that must.

use crate::report;
use crate::unusual::{listed, unlisted};
use proofread::TextFormat::{Html, Latex, Markdown, Plain, Xml};

/// A book in PreTeXt around what is in a paragraph.
fn pretext(inner: &str) -> String {
    format!("<pretext><book><chapter><section><p>{inner}</p></section></chapter></book></pretext>")
}

#[test]
fn a_ring_may_have_a_macro_or_an_operation_for_its_name() {
    let ring =
        r"\newcommand{\Z}{\mathbb{Z}} Consider the ring $\Z_{15}$. Their product is $30 = 2 \times 15 = 0$ in it.";
    unlisted(
        Latex,
        &[
            ring,
            r"Over $k=\Zmod{5}$ we have $3^2 = 9 = 4$.",
            r"The field is $k=\Z{}/5\Z{}$. Here $2^{-1}=3$ and $3^2 = 9 = 4$.",
            r"In $\Z_{37}$ it is $8^{25} = (8^5)^5 = 23^5$.",
            r"We find $p(1) = 1 + 2 + 2 = 2$, so $p$ has no zeroes in $\Z_3$.",
            r"Let $k$ be the field of two elements. Then \[ q(1)=1^3+1+1=1+1+1=1, \] as it must.",
            r"Try $x=1$: \[ q(1)=1^3+1+1=1+1+1=1, \] since $1+1=0$.",
            r"The residues modulo 11 form a group. One of its generators is 2. There $2^4 = 5$ and $2^5 = 10$.",
        ],
    );
    listed(
        Latex,
        &[
            &ring.replace("= 0", "= 1"),
            r"Over $k=\Zmod{5}$ we have $3^2 = 9 = 3$.",
            r"The field is $k=\Z{}/5\Z{}$. Here $2^{-1}=4$.",
            r"We find $p(1) = 1 + 2 + 2 = 1$, so $p$ has no zeroes in $\Z_3$.",
            r"Let $k$ be the field of two elements. Then \[ q(1)=1^3+1+1=1+1+1=2, \] as it must.",
            r"The residues modulo 11 form a group. One of its generators is 2. There $2^4 = 6$.",
            r"Let $k$ be a field. Then $q(1)=1^3+1+1=1+1+1=1$.",
        ],
    );
    let group = r"The units <m>[\mathbb{U}_{13} ;\times_{13}]</m> are cyclic: <m>2^4 = 3</m>, <m>2^5 = 6</m>.";
    let vectors = r"In <m>\mathbb{Z}_2{}^3</m> it is <m>(1,0,1) + (1,0,1) = (0,0,0)</m>.";
    unlisted(Xml, &[&pretext(group), &pretext(vectors)]);
    listed(Xml, &[&pretext(&group.replace("= 6", "= 7")), &pretext(&vectors.replace("_2", "_3"))]);
}

#[test]
fn a_modulus_at_the_end_holds_for_the_whole_chain() {
    let chain = r"<m>88^{10}=(-5)^{10}=((-5)^4)^2 \cdot (-5)^2=67^2\cdot25=25\cdot 25=67  \mod{93} </m>";
    unlisted(Xml, &[&pretext(chain)]);
    listed(Xml, &[&pretext(&chain.replace(r"25\cdot 25=67", r"25\cdot 25=68"))]);
}

#[test]
fn the_order_of_an_element_is_no_absolute_value() {
    unlisted(
        Latex,
        &[
            r"In $\mathbb{Z}_{20}$ the order is $|4| = 5$.",
            r"Since $|3| = 4$, it generates a subgroup.",
            r"In the group, $|42| = \frac{210}{42} = 5$.",
        ],
    );
    listed(Latex, &[r"The distance is $|4| = 5$."]);
}

#[test]
fn digits_in_another_base_may_stand_in_groups() {
    let chain = "<m>75_{10} = 100 1011_2 = 2210_3 = 300_5</m>";
    let long = "<m>2012_{10} = 111 1101 1100_2 = 220 2112_3 = 3 1022_5 = 7D\\text{C}_{16}</m>";
    unlisted(Xml, &[&pretext(chain), &pretext(long), &pretext("<m>64_{10} = 100 0000_2 = 40_{16}</m>")]);
    listed(
        Xml,
        &[
            &pretext(&chain.replace("1011", "1010")),
            &pretext(&long.replace("2112", "2111")),
            &pretext("<m>64_{10} = 100 0000_2 = 41_{16}</m>"),
        ],
    );
}

#[test]
fn relations_may_have_columns_of_their_own() {
    let rows = r"$$\begin{array}{cccccc} (0.9)^{2} &=& 0.81 &(1.1)^{2} &=& 1.21\\ (0.9)^{3} &=& 0.729 &(1.1)^{3} &=& 1.331 \end{array}$$";
    unlisted(Markdown, &[rows]);
    listed(Markdown, &[&rows.replace("1.331", "1.332"), &rows.replace("0.81", "0.91")]);
    unlisted(Markdown, &[r"\begin{eqnarray*} x &=& 3\cdot4\\ &=& 12 \end{eqnarray*}"]);
    listed(Markdown, &[r"$$\begin{array}{rcl} x &=& 3\cdot4\\ &=& 13 \end{array}$$"]);
}

#[test]
fn lines_with_empty_right_sides_are_to_be_filled_in() {
    let sheet = r"<me>\begin{aligned} 12 + 31 \amp = \\ 45 - 18 \amp = \\ -7 + 22 \amp = \end{aligned}</me>";
    unlisted(Xml, &[&pretext(sheet)]);
    let chain = r"$$\begin{aligned} 3(4+5) = \\ 3\cdot9 = \\ 27 \end{aligned}$$";
    unlisted(Markdown, &[chain]);
    listed(Markdown, &[&chain.replace("27", "28"), &chain.replace("9", "8")]);
}

#[test]
fn permutations_are_composed() {
    unlisted(
        Latex,
        &[
            "$(124)2 = 4$",
            "$(142)^2=(124)$",
            r"$(1,2,3)\circ(2,3) = (1,2)(3) = (1,2)$",
            "$(123)(132)=()$",
            "$(123)(234)(543)=21543$",
            r"$\begin{pmatrix}4 & 3 & 5 & 1\end{pmatrix} = \begin{pmatrix}1 & 4 & 3 & 5\end{pmatrix}$",
            r"$g^{-1} = \left(\begin{array}{ccc} 2&3&1\\1&2&3\end{array}\right) = \left(\begin{array}{ccc}1&2&3\\3&1&2\end{array}\right)$",
        ],
    );
    listed(Latex, &["$(124)2 = 1$", "$(142)^2=142$"]);
}

#[test]
fn braces_may_hold_a_fractional_part() {
    unlisted(
        Latex,
        &[
            r"$|\{9\pi\} - \{2\pi\}| = |9\pi - 28 - (2\pi - 6)|$",
            r"$\{783\log_3(2)\} - \{298\log_3(2)\} \approx 0.00093$",
        ],
    );
    listed(Latex, &[r"$|\{9\pi\} - \{2\pi\}| = |9\pi - 27 - (2\pi - 6)|$"]);
}

#[test]
fn full_stops_between_functions_are_signs_of_a_product() {
    let product = r"$\tan 10^\circ.\tan 45^\circ.\tan 80^\circ = 1$";
    unlisted(
        Latex,
        &[
            product,
            r"$\sin 30^\circ.\cos 60^\circ = \frac14$",
            r"${\rm cosec}^245^\circ.\sec^230^\circ.\cos 60^\circ = 1\frac{1}{3}$",
        ],
    );
    listed(Latex, &[&product.replace("= 1", "= 3"), r"$\sin 30^\circ.\cos 60^\circ = \frac13$"]);
}

#[test]
fn a_comma_with_space_before_a_further_equation_parts_a_list() {
    let list = r"$390 = 6^2 + 354, 52 = 7^2 + 3, 124=11^2 + 3$";
    unlisted(Latex, &[list]);
    listed(Latex, &[&list.replace("390", "391")]);
}

#[test]
fn an_upright_letter_may_be_a_side() {
    let area =
        r"<m>\text{Area} = \frac{\sqrt{3}}{4} \times \text{s}^2 = \frac{\sqrt{3}}{4} \times 8^2 = 16\sqrt{3}</m>";
    unlisted(Xml, &[&pretext(area)]);
    listed(Xml, &[&pretext(&area.replace(r"16\sqrt", r"15\sqrt"))]);
}

#[test]
fn a_sum_may_go_on_over_several_formulas() {
    let sum = "<m>12+15+18</m></p><p><m>+20+25</m></p><p><m>+30+10 = 130</m>";
    unlisted(Xml, &[&pretext(sum)]);
    listed(Xml, &[&pretext("The sum is <m>+30+10 = 130</m>.")]);
}

#[test]
fn pi_may_be_taken_as_a_fraction_or_as_few_decimals() {
    unlisted(
        Latex,
        &[
            r"The volume is $\frac{4}{3}\pi \times 64 = 268.19$.",
            r"The volume is $\frac{4}{3}\pi \times 64 = 267.95$.",
            r"$\pi \times 7^2 = 154\,\mathrm{cm}$",
        ],
    );
    listed(Latex, &[r"The volume is $\frac{4}{3}\pi \times 64 = 268.91$.", r"$\pi \times 7^2 = 156$"]);
}

#[test]
fn points_may_have_several_coordinates() {
    unlisted(
        Latex,
        &[
            r"$(-3,\pi/6)=(3,7\pi/6)$",
            r"$(2, 45^\circ) = (-2, 225^\circ)$",
            "In homogeneous coordinates, $[2,1,3]=[4,2,6]$.",
            "A point of the projective plane is $[2,1,3]=[-2,-1,-3]$.",
        ],
    );
    listed(
        Latex,
        &[
            r"$(-3,\pi/6)=(3,5\pi/6)$",
            "In homogeneous coordinates, $[2,1,3]=[4,2,5]$.",
            "The velocity is $[2,1,3]=[4,2,6]$.",
        ],
    );
}

#[test]
fn statements_with_their_answer_behind_are_not_asserted() {
    let item = r"(c) $540^\circ = 2\pi\textsf{ rad}$  Answer: `r torf(FALSE)`.";
    unlisted(
        Markdown,
        &[item, r#"(d) $6-2=3$. Answer: `r mcq(c(answer ="proposition", "none"))`."#, "(e) $6-2=3$. Answer: false."],
    );
    listed(Markdown, &[&item.replace("FALSE", "TRUE"), "(e) $6-2=3$. The answer follows."]);
    let implication = "If <m>1+4=9</m>, then <m>1+6=11</m>.";
    unlisted(Xml, &[&pretext(implication), &pretext("Check the presentation for errors. <me>1+4=9</me>")]);
    listed(Xml, &[&pretext("If we add, then <m>1+6=11</m>."), &pretext("Check: <me>1+4=9</me>")]);
}

#[test]
fn a_contradiction_is_of_what_stands_beside_it() {
    unlisted(Latex, &["Hence $5 + 1 = 7$, a contradiction.", "We get $5 + 1 = 7$, which is a contradiction."]);
    listed(
        Latex,
        &[
            "Hence the group has at least $1210 + 1344 = 2544$ elements, a contradiction.",
            r"But $1210 + 1344 = 2544 > 2000$, a contradiction.",
        ],
    );
}

#[test]
fn arrays_may_be_multiplied_entry_by_entry() {
    let product = r"$\begin{bmatrix}1&2\\3&5\end{bmatrix}\times\begin{bmatrix}3&3\\3&3\end{bmatrix}=\begin{bmatrix}3&6\\9&15\end{bmatrix}$";
    unlisted(Markdown, &[product]);
    listed(Markdown, &[&product.replace("15", "16")]);
}

#[test]
fn the_first_part_of_a_line_may_be_outside_the_formula() {
    unlisted(Latex, &[r"slope is tan $45^\circ = 1$"]);
    listed(Latex, &[r"slope is $\tan 45^\circ = 2$"]);
    unlisted(Plain, &["About 80% of the rated current (2.00 A) = 1.6 A"]);
}

#[test]
fn half_a_power_may_be_typed_with_a_stroke() {
    let speed = "v = (2*30 J / 2 kg)^1/2 = 5.48 m/s";
    unlisted(Markdown, &[speed]);
    listed(Markdown, &[&speed.replace("5.48", "5.58"), "(9 + 7)^1/2 = 9"]);
}

#[test]
fn a_degree_beside_kelvins_is_one_of_temperature() {
    unlisted(Markdown, &["It melts at 900 K = 627°", "At 1000 K = 727° it boils."]);
    listed(Markdown, &["It melts at 900 K = 637°"]);
}

#[test]
fn a_modulus_in_words_holds_for_its_item_alone() {
    listed(
        Latex,
        &["\\item The last two digits are those modulo 100.\n\\item We know that $50a = 5 \\times 50 = 750$."],
    );
}

#[test]
fn numbers_of_computing_are_powers_of_two() {
    unlisted(
        Markdown,
        &[
            "In binary we write 0.10 + 0.10 = 1.00 for two halves.",
            "$1.0110*2^0=1.375$",
            "For the 5-bit twos complement numbers $x = -7 = 11001_2$ we have",
            "$1011_2=(10)(11)=(2)(3)=23_4$",
            "So 2^14 = 16K and 2^44 = 16T.",
            "There are 2^16 - 1 = 64K - 1 of them.",
        ],
    );
    listed(Markdown, &["$1.0110*2^0=1.475$", "So 2^14 = 17K.", "0.10 + 0.10 = 1.10"]);
}

#[test]
fn a_set_is_no_decimal() {
    let text = r"A label is in $\{0,1\}^m \times \{0,1\}$. In all $30 \times 64 = 1{,}920$ steps.";
    unlisted(Latex, &[text, r"$\{0,1\}^n$ and $\{0,1\}^*$, then $0+1=\{0,1\}$"]);
    listed(Latex, &[&text.replace("920", "930")]);
}

#[test]
fn dots_behind_decimals_leave_the_next_digit_open() {
    unlisted(
        Latex,
        &[
            r"$1/17 \approx 0.0588\dots$",
            r"$\frac{5}{7}\approx 0.7143\dots$",
            r"$7\text{ cm}-(2.3411\dots\text{ cm})\approx 4.6588\dots\text{ cm}$",
            r"$2.282\times(0.55\dots)\approx 1.25\dots$",
            r"$1/3 = 0.333\dots$",
            r"$2/3 = 0.66\dots$",
        ],
    );
    listed(Latex, &[r"$1/17 \approx 0.0598\dots$", r"$1/3 = 0.353\dots$", r"$2/3 = 0.77\dots$"]);
}

#[test]
fn what_stands_before_a_line_shows_that_it_is_torn_off() {
    unlisted(
        Markdown,
        &[
            "| Execute | valE <- 40 + 8 = 48 |",
            "The index (1990–92 = 100) was 87.3 in May.",
            "The index (1982-84 = 100) was 87.3 in May.",
            "Ex: A = -0.0305 (column 2) Exp(-0.0305) = 0.970",
            "The value (P(Chi-squared) > 1.25 = 0.535) is large.",
            "if REGA.6=1",
        ],
    );
    unlisted(Html, &[r#"<div data-type="equation">(1/3) \times (1/3) = 1/9</div>"#]);
    listed(Markdown, &["It is 40 + 8 = 49.", "1990 - 92 = 1998"]);
}

#[test]
fn ones_may_be_added_to_one() {
    let product = r"$\begin{bmatrix}1&1\\0&1\end{bmatrix}\begin{bmatrix}1&1\\0&1\end{bmatrix}=\begin{bmatrix}1&1\\0&1\end{bmatrix}$";
    unlisted(Markdown, &[product]);
    listed(Markdown, &[&product.replace("=\\begin{bmatrix}1&1", "=\\begin{bmatrix}1&3")]);
}

#[test]
fn estimates_have_more_digits_than_are_printed() {
    unlisted(
        Markdown,
        &[
            "The odds ratio is $e^{-0.41} = 0.661$.",
            r"$Z = \frac{-0.0241}{0.0063} = -3.81$",
            r"$F = \frac{4.21\times10^{10}}{5.33\times10^8} = 78.91$",
        ],
    );
    listed(
        Markdown,
        &["The odds ratio is $e^{-0.41} = 0.681$.", r"$Z = \frac{-0.0241}{0.0063} = -3.61$", "$e^{-0.41} = 0.661$"],
    );
}

#[test]
fn what_was_not_read_is_shown_as_dots_and_commands_keep_their_names() {
    let shown = |text: &str| report(text, Latex).findings.into_iter().map(|of| of.chain).collect::<Vec<_>>();
    assert_eq!(shown(r"$3 \times 1.2\times 10^12 = 4$"), ["3 × 1.2 × 10^1 2 = 4"]);
    assert_eq!(shown(r"$\log_3(2) = 0.7$"), ["log_3 (2) = 0.7"]);
    assert_eq!(shown(r"$\quux x = 2 \cdot 3 = 7$"), [r"\quux x = 2·3 = 7"]);
}
