//! Arithmetic of other things than numbers: residues, permutations, classes, points and arrays. Right chains must not be listed, and wrong
//! ones beside them must.

use crate::unusual::{listed, unlisted};
use crate::{assert_told_apart, on_numbers, pretext};
use proofread::TextFormat;

#[test]
fn digits_in_brackets_side_by_side_are_cycles() {
    unlisted(TextFormat::Markdown, &["The product is $[(124)(13)](14) = (13)(24) = (123)(142)$."]);
    listed(TextFormat::Markdown, &["The product is $(124)(13) = 1712$."]);
}

#[test]
fn square_brackets_may_be_places_or_classes() {
    unlisted(
        TextFormat::Markdown,
        &[
            "I write place values in square brackets, so [6][3] = 63, and [4][12] = [5][2] = 52.",
            "e.g. 13 × 17 = [1 × 2][3 × 7] = [2][21] = 221",
            "$$+4 + -1 = [(5,1)] + [(1,2)] = [(5+1, 1+2)] = [(6,3)] = [(4,1)]$$",
            "For example, what if $3^5 = 6^3$; then wouldn't we need both?",
            "Since $31 = 14 + 17$, we have $31^3 = (14^3 + 17^3)$. This fallacy is known.",
        ],
    );
    listed(TextFormat::Markdown, &["$[6][3] + 45 = 64$", "We have $31^3 = (14^3 + 17^3)$. This is known."]);
}

#[test]
fn a_ring_may_have_a_macro_or_an_operation_for_its_name() {
    let ring =
        r"\newcommand{\Z}{\mathbb{Z}} Consider the ring $\Z_{15}$. Their product is $30 = 2 \times 15 = 0$ in it.";
    unlisted(
        TextFormat::Latex,
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
        TextFormat::Latex,
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
    unlisted(TextFormat::Xml, &[&pretext(group), &pretext(vectors)]);
    listed(TextFormat::Xml, &[&pretext(&group.replace("= 6", "= 7")), &pretext(&vectors.replace("_2", "_3"))]);
}

#[test]
fn a_modulus_at_the_end_holds_for_the_whole_chain() {
    let chain = r"<m>88^{10}=(-5)^{10}=((-5)^4)^2 \cdot (-5)^2=67^2\cdot25=25\cdot 25=67  \mod{93} </m>";
    unlisted(TextFormat::Xml, &[&pretext(chain)]);
    listed(TextFormat::Xml, &[&pretext(&chain.replace(r"25\cdot 25=67", r"25\cdot 25=68"))]);
}

#[test]
fn the_order_of_an_element_is_no_absolute_value() {
    unlisted(
        TextFormat::Latex,
        &[
            r"In $\mathbb{Z}_{20}$ the order is $|4| = 5$.",
            r"Since $|3| = 4$, it generates a subgroup.",
            r"In the group, $|42| = \frac{210}{42} = 5$.",
        ],
    );
    listed(TextFormat::Latex, &[r"The distance is $|4| = 5$."]);
}

#[test]
fn permutations_are_composed() {
    unlisted(
        TextFormat::Latex,
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
    listed(TextFormat::Latex, &["$(124)2 = 1$", "$(142)^2=142$"]);
}

#[test]
fn points_may_have_several_coordinates() {
    unlisted(
        TextFormat::Latex,
        &[
            r"$(-3,\pi/6)=(3,7\pi/6)$",
            r"$(2, 45^\circ) = (-2, 225^\circ)$",
            "In homogeneous coordinates, $[2,1,3]=[4,2,6]$.",
            "A point of the projective plane is $[2,1,3]=[-2,-1,-3]$.",
        ],
    );
    listed(
        TextFormat::Latex,
        &[
            r"$(-3,\pi/6)=(3,5\pi/6)$",
            "In homogeneous coordinates, $[2,1,3]=[4,2,5]$.",
            "The velocity is $[2,1,3]=[4,2,6]$.",
        ],
    );
}

#[test]
fn arrays_may_be_multiplied_entry_by_entry() {
    let product = r"$\begin{bmatrix}1&2\\3&5\end{bmatrix}\times\begin{bmatrix}3&3\\3&3\end{bmatrix}=\begin{bmatrix}3&6\\9&15\end{bmatrix}$";
    unlisted(TextFormat::Markdown, &[product]);
    listed(TextFormat::Markdown, &[&product.replace("15", "16")]);
}

#[test]
fn a_modulus_in_words_holds_for_its_item_alone() {
    listed(
        TextFormat::Latex,
        &["\\item The last two digits are those modulo 100.\n\\item We know that $50a = 5 \\times 50 = 750$."],
    );
}

#[test]
fn a_set_is_no_decimal() {
    let text = r"A label is in $\{0,1\}^m \times \{0,1\}$. In all $30 \times 64 = 1{,}920$ steps.";
    unlisted(TextFormat::Latex, &[text, r"$\{0,1\}^n$ and $\{0,1\}^*$, then $0+1=\{0,1\}$"]);
    listed(TextFormat::Latex, &[&text.replace("920", "930")]);
}

#[test]
fn ones_may_be_added_to_one() {
    let product = r"$\begin{bmatrix}1&1\\0&1\end{bmatrix}\begin{bmatrix}1&1\\0&1\end{bmatrix}=\begin{bmatrix}1&1\\0&1\end{bmatrix}$";
    unlisted(TextFormat::Markdown, &[product]);
    listed(TextFormat::Markdown, &[&product.replace("=\\begin{bmatrix}1&1", "=\\begin{bmatrix}1&3")]);
}

#[test]
fn a_letter_may_stand_for_the_modulus() {
    let text = |sum: &str| format!("Let $p = 13$ and reckon modulo $p$.\n\n\\[ 5 + 11 = {sum} \\]");
    assert_told_apart(&text("3"), &text("4"), TextFormat::Latex);
    assert_ne!(on_numbers("Let $q = 13$ and reckon modulo $p$.\n\n\\[ 5 + 11 = 4 \\]", TextFormat::Latex), 0);
}

#[test]
fn a_negative_remainder_is_one_below_the_modulus() {
    let text = |remainder: &str| format!("Let $N = 221$. Reduce everything modulo $N$.\n\n- $162^1 = {remainder}$");
    assert_told_apart(&text("-59"), &text("-58"), TextFormat::Markdown);
}

#[test]
fn points_of_a_curve_are_added_by_another_law() {
    for sum in ["(0,2)+(1,0) = (3,4)", "2(4,6) = (7,9)"] {
        let text = |curve: &str| format!("On {curve}, we have ${sum}$.");
        assert_told_apart(&text("this elliptic curve"), &text("this plane"), TextFormat::Latex);
    }
    assert_ne!(on_numbers("On this elliptic curve, $3 + 4 = 8$.", TextFormat::Latex), 0);
}

#[test]
fn symbols_of_residues_look_like_fractions() {
    let define = |name: &str| format!("\\newcommand{{\\{name}}}[2]{{\\left(\\frac{{#1}}{{#2}}\\right)}}\n");
    let text = |name: &str| {
        define(name) + &format!("$\\{name}{{3 \\cdot 23}}{{389}} = \\{name}{{3}}{{389}} \\cdot \\{name}{{23}}{{389}}$")
    };
    assert_told_apart(&text("legendre"), &text("quot"), TextFormat::Latex);
    let words = |of: &str| format!("The {of} is $(-1) \\cdot \\left(\\frac{{1}}{{3}}\\right) = -1$.");
    assert_told_apart(&words("Jacobi symbol"), &words("product"), TextFormat::Latex);
}

#[test]
fn an_inverse_is_one_for_the_modulus_of_its_section() {
    let list = |last: &str| {
        format!(
            "What about inverses $\\mod9$?\n\\begin{{itemize}}\n\\item $1^{{-1}}$? $=1$\n\\item $2^{{-1}}=5$\n\\item $4^{{-1}}={last}$\n\\end{{itemize}}"
        )
    };
    assert_told_apart(&list("7"), &list("8"), TextFormat::Latex);
    let power = |power: &str| {
        format!("We do $34*50^{{-1}}\\mod61$.\n\nSo how do we find it? We use Fermat. So $50^{{-1}} = 50^{{{power}}}$.")
    };
    assert_told_apart(&power("59"), &power("58"), TextFormat::Markdown);
    let letters = |sum: &str| format!("In the sense of the alphabet, $25 + 1 = {sum}$.");
    assert_told_apart(&letters("0"), &letters("1"), TextFormat::Markdown);
}
