//! What mathematics of many texts writes in its own way: each kind in right chains of ours that must not be listed, beside wrong ones that must.

use crate::unusual::{listed, unlisted};
use proofread::TextFormat::{Latex, Markdown, Xml};

#[test]
fn pi_with_square_brackets_is_a_name() {
    unlisted(Markdown, &[r"Angles are in a table, and $\pi[3]=1$ holds."]);
    listed(Markdown, &[r"Then $\pi[3]^2=89.83$ holds."]);
}

#[test]
fn text_without_braces_takes_all_digits() {
    unlisted(Markdown, &[r"Write $\text 237_{10} = 22210_3$ here."]);
    listed(Markdown, &[r"Write $\text 247_{10} = 22210_3$ here."]);
}

#[test]
fn plus_minus_and_minus_plus_go_together() {
    unlisted(Markdown, &[r"So $2a_0=(\pm 1)+(\mp 1)=0$."]);
    listed(Markdown, &[r"So $2a_0=(\pm 1)+(\mp 1)=3$."]);
}

#[test]
fn what_floating_point_leaves_is_zero() {
    unlisted(Latex, &[r"It is $(\sqrt2+\sqrt3)^4 - 10(\sqrt2+\sqrt3)^2+1 = (49+20\sqrt6) - 10(5+2\sqrt6) + 1 = 0$."]);
    listed(Latex, &[r"It is $(\sqrt2+\sqrt3)^4 - 10(\sqrt2+\sqrt3)^2+2 = (49+20\sqrt6) - 10(5+2\sqrt6) + 1 = 0$."]);
    unlisted(Latex, &["$1 - 1 + e^{-144} = e^{-144}$"]);
    listed(Latex, &["$1 - 1 + e^{-144} = e^{-142}$"]);
}

#[test]
fn roots_of_a_negative_number_may_be_complex() {
    unlisted(Latex, &[r"Note that \[ (1+\sqrt{-5})(1-\sqrt{-5}) = 6. \]"]);
    listed(Latex, &[r"Note that \[ (1+\sqrt{-5})(1-\sqrt{5}) = 6. \]"]);
}

#[test]
fn a_modulus_may_be_named_in_the_section_or_be_a_key() {
    unlisted(
        Latex,
        &[
            "Reducing modulo 7 gives a polynomial. It has no root:\n\\begin{itemize}\n\\item $f(1)=1^3+2=3$\n\\item $f(2) = 2^3+2=10=3 \\neq 0$ as well\n\\end{itemize}",
            "The public key is $(221, 11)$. Then\n\\begin{itemize}\n\\item $219^{2} = 4$\n\\item $219^{5} = -32$\n\\end{itemize}",
        ],
    );
    listed(
        Latex,
        &[
            "Reducing modulo 7 gives a polynomial. It has no root:\n\\begin{itemize}\n\\item $f(1)=1^3+2=3$\n\\item $f(2) = 2^3+2=10=4 \\neq 0$ as well\n\\end{itemize}",
            "The public key is $(221, 11)$. Then\n\\begin{itemize}\n\\item $219^{2} = 5$\n\\item $219^{5} = -31$\n\\end{itemize}",
        ],
    );
}

#[test]
fn a_factor_may_change_to_degrees() {
    unlisted(Latex, &[r"So \[\frac{\pi}{9} ~~\text{rad} ~=~ \frac{180}{\pi} \;\cdot\; \frac{\pi}{9} ~=~ 20^\circ\]"]);
    listed(Latex, &[r"So \[\frac{\pi}{9} ~~\text{rad} ~=~ \frac{180}{\pi} \;\cdot\; \frac{\pi}{6} ~=~ 20^\circ\]"]);
}

#[test]
fn a_cross_denies_a_row() {
    unlisted(
        Latex,
        &[
            r"A check:\begin{align*}\frac{6+7}{9} &= \frac{\cos 2.5^\circ}{\sin 32.5^\circ}\\ 1.44 &= 1.86 \quad\text{\ding{55}}\end{align*}",
        ],
    );
    listed(
        Latex,
        &[
            r"A check:\begin{align*}\frac{6+7}{9} &= \frac{\cos 2.5^\circ}{\sin 32.5^\circ}\\ 1.44 &= 1.86 \quad\text{\ding{51}}\end{align*}",
        ],
    );
}

#[test]
fn an_asterisk_may_be_an_operation_of_its_own() {
    unlisted(Latex, &["Define $*$ on the integers by $a * b = 2^{ab}$. Then $(1*2)*3 = 4 * 3 = 2^{12}$."]);
    listed(
        Latex,
        &[
            "With $L * B = A$, it is $4 * 3 = 2^{12}$.",
            "Define $f$ on the integers by $f(a, b) = 2^{ab}$. Then $4 * 3 = 2^{12}$.",
        ],
    );
}

#[test]
fn a_low_point_behind_an_exponent_multiplies() {
    unlisted(
        Markdown,
        &[r"The result is $\frac{1}{2^2.3^2} = \frac{1}{4 \times 9} = \frac{1}{36}$.", "So $2^3.5^2 = 200$."],
    );
    listed(
        Markdown,
        &[r"The result is $\frac{1}{2^2.3^2} = \frac{1}{4 \times 9} = \frac{1}{38}$.", "So $2^3.5^2 = 400$."],
    );
}

#[test]
fn codes_are_no_quantities() {
    unlisted(
        Markdown,
        &["- 777 = Don't know\n- 101-107 = days per week (101 = 1 day per week, 107 = 7 days per week)"],
    );
}

#[test]
fn items_with_capital_letters_are_answers_to_choose_from() {
    unlisted(
        Xml,
        &[
            r#"<pretext><book><chapter><section><exercise><statement><p><m>5^{2}=25</m> <ol marker= "A." cols="2"><li><p><m>\log_{5} (2)=25</m></p></li><li><p> <m>\log_{25} (5)=2</m></p></li></ol></p></statement></exercise></section></chapter></book></pretext>"#,
        ],
    );
    listed(
        Xml,
        &[
            r#"<pretext><book><chapter><section><exercise><statement><p><m>5^{2}=25</m> <ol marker= "1." cols="2"><li><p><m>\log_{5} (2)=25</m></p></li><li><p> <m>\log_{25} (5)=2</m></p></li></ol></p></statement></exercise></section></chapter></book></pretext>"#,
        ],
    );
}

#[test]
fn items_may_be_true_or_false() {
    unlisted(
        Markdown,
        &[
            "True or false:\n- [ ] $8 \\times \\left(\\frac{1}{4}\\right) = \\left(\\frac{1}{4}\\right)\\times 8$\n- [ ] $8/4 = 4/8$ \n- [ ] $2 + (-5) = (-5) + 2$ and so on and so forth, in a line that is rather long\n- [ ] $2 - 5 = 5-2$",
        ],
    );
    listed(Markdown, &["These hold:\n- [ ] $2 - 5 = 5-2$"]);
}

#[test]
fn a_text_may_call_a_statement_false() {
    unlisted(
        Markdown,
        &[
            "(c) \"$15 - 6 = 0$\"\n\nThis is a statement because it makes a clear assertion about numbers. However, the statement is false because the difference is 9.",
            r#"[4, false, "\\(2 + 4 = 8\\)"],"#,
        ],
    );
    listed(
        Markdown,
        &[
            "(c) \"$15 - 6 = 0$\"\n\nThis is a statement because it makes a clear assertion about numbers. The statement is true.",
            r#"[4, true, "\\(2 + 4 = 8\\)"],"#,
        ],
    );
}

#[test]
fn a_denial_may_stand_beside() {
    unlisted(Markdown, &["$p$: $8-5=2$\n$\\neg p$: $8-5\\neq2$"]);
    listed(Markdown, &["$p$: $8-5=2$\n$\\neg p$: $8-5\\neq 3$"]);
}

#[test]
fn an_angle_may_stand_for_its_sine() {
    unlisted(Markdown, &[r"It is $\sin(33)\approx 33$, which is silly."]);
    listed(Markdown, &[r"It is $\sin(33)\approx 34$, which is silly."]);
}

#[test]
fn bits_may_be_known_by_their_digits() {
    unlisted(
        Markdown,
        &[
            "In base two, a byte is long.\n* the largest number ($1111 = 8 + 4 + 2 + 1$).",
            "- 0111 = 7h\n- 1000 = 8h\n- 1001 = 9h",
        ],
    );
    listed(
        Markdown,
        &[
            "In base two, a byte is long.\n* the largest number ($1111 = 8 + 4 + 2 + 2$).",
            "The number is $1001 = 10 + 9$.",
        ],
    );
}

#[test]
fn many_hard_spaces_part_equations() {
    unlisted(
        Latex,
        &[
            r"So \[\left(x+\frac72\right)^2=\frac{69}{4}~~~~~~~~~~{5+\frac{49}{4}=\frac{20}{4}+\frac{49}{4}=\frac{69}{4}}\]",
        ],
    );
    listed(
        Latex,
        &[
            r"So \[\left(x+\frac72\right)^2=\frac{69}{4}~~~~~~~~~~{5+\frac{49}{4}=\frac{20}{4}+\frac{49}{4}=\frac{67}{4}}\]",
        ],
    );
}

#[test]
fn columns_of_equations_are_read_down() {
    unlisted(
        Latex,
        &[
            r"Property:\begin{alignat*}{6}\log_2 64 &=\log_2 4^3 &&=3\log_2 4 &\quad\text{ because }(2^2)^3 &= 2^6\\ 6 &&&= 3\cdot 2 & (4)^3 &= 64\end{alignat*}",
            r"Solve:\begin{align*}y &= x^2-4x+3 & y &= x^2-4x+4\\ \small{x} & \small{=\frac{4+\sqrt{16-12}}{2}}\quad & \small{x} & \small{=\frac{4+\sqrt{16-16}}{2}}\\ &=\frac{4+\sqrt{4}}{2} & &= \frac{4+\sqrt{0}}{2}\end{align*}",
        ],
    );
    listed(
        Latex,
        &[
            r"Property:\begin{alignat*}{6}\log_2 64 &=\log_2 4^3 &&=3\log_2 4 &\quad\text{ because }(2^2)^3 &= 2^6\\ 6 &&&= 3\cdot 2 & (4)^3 &= 68\end{alignat*}",
            r"Solve:\begin{align*}y &= x^2-4x+3 & y &= x^2-4x+4\\ \small{x} & \small{=\frac{4+\sqrt{16-12}}{2}}\quad & \small{x} & \small{=\frac{4+\sqrt{16-16}}{2}}\\ &=\frac{4+\sqrt{4}}{2} & &= \frac{4+\sqrt{1}}{2}\end{align*}",
        ],
    );
}

#[test]
fn a_function_takes_a_product_with_signs() {
    unlisted(
        Latex,
        &[
            r"Then $P(\frac12) = (\cos \pi \cdot \frac{1}{4}, \sin \pi \cdot \frac{1}{4}) = (\frac{\sqrt 2}{2}, \frac{\sqrt 2}{2})$.",
        ],
    );
    listed(
        Latex,
        &[
            r"Then $P(\frac12) = (\cos \pi \cdot \frac{1}{4}, \sin \pi \cdot \frac{1}{4}) = (\frac{\sqrt 2}{2}, \frac{\sqrt 3}{2})$.",
        ],
    );
}

#[test]
fn an_absolute_value_may_be_meant() {
    unlisted(Markdown, &["$$\\frac{-20\\%}{20\\%} = 1$$\n\n*Note that we take the absolute value for elasticity.*"]);
    listed(Markdown, &["$$\\frac{-20\\%}{20\\%} = 1$$\n\n*Note that we take the value for it.*"]);
}

#[test]
fn braces_may_hold_an_argument() {
    unlisted(Latex, &[r"We have $\sum_{k=1}^{5} \frac1k = 137/60$ and $\ln{1+\frac12} = \ln{\frac32}$."]);
    listed(Latex, &[r"We have $\ln{1+\frac12} = \ln{\frac54}$."]);
}

#[test]
fn a_number_may_stand_before_the_formula() {
    unlisted(
        Markdown,
        &[
            "So, 7 shillings and 85 cents = 785 cents.",
            r"$\displaystyle \text{psi} - 5759 \text{ psi} = 2468 \text{ psi}$",
        ],
    );
    listed(
        Markdown,
        &[
            "So, the price of 85 cents + 1 cent = 785 cents.",
            r"$8000 \text{ psi} - 5759 \text{ psi} = 2468 \text{ psi}$",
        ],
    );
}

#[test]
fn the_base_of_a_logarithm_may_touch_its_number() {
    unlisted(Markdown, &["10 x 10 x 10 = 1,000 ⇔ log101,000 = 3"]);
    listed(Markdown, &["10 x 10 x 10 = 1,000 ⇔ log101,000 = 4"]);
}

#[test]
fn marked_entries_may_leave_a_minor() {
    unlisted(
        Latex,
        &[
            r"The minor is \[M = \begin{vmatrix} \cancel{1} & \cancel{2} \\ \cancel{3} & 4\end{vmatrix} = 4\]",
            r"The minor is \[M = \begin{vmatrix} {\color{#ccc}1} & 2 \\ {\color{#ccc}3} & {\color{#ccc}4}\end{vmatrix} = 2\]",
        ],
    );
    listed(Latex, &[r"The minor is \[M = \begin{vmatrix} 1 & 2 \\ 3 & 4\end{vmatrix} = 4\]"]);
}

#[test]
fn augmented_matrices_may_be_changed_by_row_operations() {
    let rows = r"\[\begin{bmatrix}1 & 2 & \bigm| & 8\\ 2 & 5 & \bigm| & 26\end{bmatrix}
        = \begin{bmatrix}1 & 2 & \bigm| & 8\\ 0 & 1 & \bigm| & 10\end{bmatrix}\]";
    unlisted(Latex, &[rows]);
    listed(
        Latex,
        &[
            r"\[2\begin{bmatrix}1 & 2 & 8\\ 2 & 5 & 13\end{bmatrix} = \begin{bmatrix}2 & 4 & 16\\ 4 & 10 & 36\end{bmatrix}\]",
        ],
    );
}

#[test]
fn a_root_without_braces_takes_all_digits() {
    unlisted(Latex, &[r"So $\sqrt 10 = 3.16$.", r"So $2\sqrt 10 = 6.32$, and $\sqrt 121 = 11$."]);
    listed(Latex, &[r"So $\sqrt 10 = 3.26$.", r"So $\sqrt {1} 0 = 3.16$."]);
}

#[test]
fn given_values_may_stand_side_by_side() {
    unlisted(Latex, &[r"Given \[ \cos 23^\circ = 0.9205 \; \sin 46^\circ = 0.7193 \]"]);
    listed(Latex, &[r"Given \[ \cos 23^\circ = 0.9305 \; \sin 46^\circ = 0.7193 \]"]);
}

#[test]
fn what_is_impossible_is_said_behind() {
    unlisted(
        Markdown,
        &[
            r"Decide whether $3 + 4 = 8$ holds.",
            r"Then $3 \cdot 2 = 5$. This is impossible.",
            r"Hence $2 + 2 = 5$, absurd.",
            r"If it were so, we'd get $2 \cdot 3 = 7$, a clear contradiction.",
            r"We put in $x = 2$: $\sqrt{2+2} = 2 - 4$. So it is extraneous.",
        ],
    );
    listed(
        Markdown,
        &[
            r"Tell whether it is odd: $3 + 4 = 8$ holds.",
            r"Then $3 \cdot 2 = 5$. This is possible.",
            r"Hence $2 + 2 = 5$ numbers, of which none is absurd.",
            r"We put in $x = 2$: $\sqrt{2+2} = 2 - 4$. So it is one.",
        ],
    );
}

#[test]
fn what_is_false_may_be_derived_from_what_is_false() {
    let rows =
        r"\begin{align*} & & -4 + 3 &= 1 \\ &\Rightarrow & 5 - 6 &= 7 - 6 \\ &\Rightarrow & 4 + 1 &= 7 \end{align*}";
    unlisted(Latex, &[rows]);
    listed(Latex, &[&rows.replace("= 1 ", "= -1 ").replace("7 - 6", "5 - 6")]);
}
