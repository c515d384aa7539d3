//! Units as texts write them: each is known, so that a wrong number beside it is noticed.

use crate::unusual::{listed, unlisted};
use crate::{assert_told_apart, pretext, report, verdicts, wrong};
use proofread::{ReportSection, TextFormat};

/// Ways to write a quantity in TeX.
const WRITTEN: &[&str] = &[
    r"6\,\Omega",
    r"6\,k\Omega",
    r"6\,\text{k}\Omega",
    r"6\,\text{k$\Omega$}",
    r"6\,\mathrm{k\Omega}",
    r"6\,\mathrm{V}/\Omega",
    r"6\,\mu\text{F}",
    r"6\,\text{\textmu m}",
    r"6\:\rm m",
    r"6\,{\rm kg\,m/s^2}",
    r"6\,\text{N$\cdot$m}",
    r"6\,\text{m.s}^{-1}",
    r"6\,\text{kgms}^{-2}",
    r"6\,\text{Jkg}^{-1}\text{K}^{-1}",
    r"6\,[m]",
    r"6\,[\text{m/s}]",
    r"6\,[kg\,m/s^2]",
    r"6\,\AA",
    r"6\,\text{\AA}",
    r"6\,\mathring{A}",
    r"6\,\text{\ell}",
    r"6\text{E}3\,\text{Pa}",
    r"6.0\mathrm{e}{-3}\,\text{Pa}",
    r"6.0e-3\,\text{Pa}",
    r"6\,\text{lb}_f",
    r"6\,\text{kip}",
    r"6\,\text{ksi}",
    r"6\,M_\odot",
    r"6\,\text{L}_\odot",
    r"6\,\text{lm}",
    r"6\,\text{mAh}",
    r"6\,\text{M}",
    r"\SI{6}{\meter\per\second}",
    r"\SI{6}{\kilogram\metre\per\second\squared}",
    r"\SI{6.0(1)e3}{\uF}",
    r"\qty{6}{\kohm}",
    r"\num{6e3}\,\text{m}",
    r"6\,\si{\metre\tothe{4}}",
    r"\unit[6]{m/s}",
    r"6\,\cancel{\text{m}}",
];

#[test]
fn every_way_to_write_a_unit_is_known() {
    for written in WRITTEN {
        let text = format!("${written} = 7({written})$");
        for format in [TextFormat::Markdown, TextFormat::Latex] {
            let findings = report(&text, format).findings;
            let verdicts: Vec<&str> = findings.iter().map(|of| of.verdict.name()).collect();
            assert_eq!(verdicts, ["inconsistent"], "{text} as {}", format.name());
        }
        let text = format!("${written} + 2({written}) = 3({written})$");
        assert_eq!(wrong(&text, TextFormat::Markdown), [""; 0], "{text}");
        assert!(
            report(&text, TextFormat::Markdown).findings.iter().any(|of| of.section == ReportSection::Agreeing),
            "{text}"
        );
    }
}

#[test]
fn units_have_their_size_however_they_are_written() {
    for tex in [
        r"6\,k\Omega = 6000\,\Omega",
        r"2\,\text{A} \times 3\,\text{k$\Omega$} = 6\,\text{kV}",
        r"60\,\text{m.s}^{-1} / 2\,\text{s} = 30\,\text{m.s}^{-2}",
        r"2\,\text{kg} \times 3\,\text{ms}^{-2} = 6\,\text{kgms}^{-2} = 6\,\text{N}",
        r"1.2\,\text{m.s}^{-1} = 120\,{\rm cm/s}",
        r"25\,\AA = 2.5\,\text{nm}",
        r"2\text{E}3\,\text{Pa} = 2\,\text{kPa}",
        r"3\,\text{kip} = 3000\,\text{lb}_f",
        r"2.5\,[m] = 250\,[cm]",
        r"\SI{36}{\km\per\hour} = \SI{10}{\metre\per\second}",
        r"\SI{2.5(1)}{\uF} = \SI{2500}{\nano\farad}",
        r"\SI{3}{\metre\tothe{2}} = \SI{30000}{\centi\metre\squared}",
        r"0.50\,\text{M} \times 2.0\,\text{L} = 1.0\,\text{mol}",
        r"2000\,\text{mAh} = 7200\,\text{C}",
        r"\qty(2.0 + 3.0) = 5.0",
    ] {
        let found = verdicts(tex);
        assert!(!found.is_empty() && found.iter().all(|of| *of == "consistent"), "{tex}: {found:?}");
    }
}

#[test]
fn letters_stay_letters() {
    for tex in [r"3\ell = 6", r"2m = 6.0\,\text{kg}", r"2[x] = 6", r"5e - 3 = 2", r"\Omega = 2\pi f = 6.28", r"4M = 12"]
    {
        assert_eq!(verdicts(tex), [""; 0], "{tex}");
    }
}

#[test]
fn a_unit_behind_the_result_alone_hides_no_wrong_number() {
    for [left, right, wrong_one] in
        [["3.2 \\cdot 2.2", "7.04", "7.24"], ["10.0/2.5", "4.00", "4.30"], ["12 \\cdot 5", "60", "61"]]
    {
        for unit in ["", r"\,\mathrm{W}", r"\,\text{kg}", r"\,\mathrm{m/s}", r"\,\mathrm{km}"] {
            let of = |result: &str| verdicts(&format!("{left} = {result}{unit}"));
            assert_eq!(of(right), ["consistent"], "{left} = {right}{unit}");
            assert_eq!(of(wrong_one), ["inconsistent"], "{left} = {wrong_one}{unit}");
        }
        for behind in [" W.", " watts.", " kilograms.", r"\,kg."] {
            assert_eq!(wrong(&format!("It is ${left} = {right}${behind}"), TextFormat::Latex), [""; 0]);
            let lists: Vec<_> = report(&format!("It is ${left} = {wrong_one}${behind}"), TextFormat::Latex).findings;
            assert_eq!(lists.len(), 1, "{left} = {wrong_one}{behind}");
            assert_eq!(lists[0].section, ReportSection::Numbers, "{left} = {wrong_one}{behind}");
        }
    }
}

#[test]
fn a_result_may_be_in_another_multiple_of_the_unit_that_was_left_out() {
    // The left side is in metres.
    let of = |text: &str| report(text, TextFormat::Latex).findings.iter().map(|of| of.section).collect::<Vec<_>>();
    assert_eq!(of(r"$125 \cdot 16.0 = 2.00\,\mathrm{km}$"), [ReportSection::Units]);
    assert_eq!(of(r"$125 \cdot 16.0 = 2.30\,\mathrm{km}$"), [ReportSection::Numbers]);
}

#[test]
fn prefixes_of_units_may_be_written_out() {
    for (right, wrong) in [
        ("So $20/10^4 = 2$ millivolts remain.", "So $20/10^4 = 3$ millivolts remain."),
        ("So $I = 3.5/100 = 35$ microamps.", "So $I = 3.5/100 = 25$ microamps."),
        ("So $I_B = 2.118/100 = 21.2$ microamps, and it is.", "So $I_B = 2.118/100 = 22.2$ microamps, and it is."),
        (r"So $3.5/100 = 35$ μA.", r"So $3.5/100 = 25$ μA."),
        (
            r"$2\text{ kilowatts} \cdot 3\text{ s} = 6000\text{ J}$",
            r"$2\text{ kilowatts} \cdot 3\text{ s} = 7000\text{ J}$",
        ),
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
    // Without a prefix, no power of ten is left out.
    assert_told_apart("So $3.5/100 = 0.035$ amps.", "So $3.5/100 = 35$ amps.", TextFormat::Markdown);
}

#[test]
fn hyphens_may_join_units_with_a_space_behind_one() {
    let gas = |bar: &str| {
        format!(
            r"$\frac{{0.0831\text{{ L-bar- mol}}^{{-1}}\text{{K}}^{{-1}} \cdot 400\text{{ K}}}}{{200\text{{ L/mol}}}} = {bar}\text{{ bar}}$"
        )
    };
    assert_told_apart(&gas("0.166"), &gas("0.176"), TextFormat::Latex);
}

#[test]
fn a_sign_of_degrees_on_one_term_is_for_all() {
    unlisted(TextFormat::Latex, &[r"$90-21.5^\circ = 68.5$"]);
    unlisted(TextFormat::Markdown, &["130.05° − 80.25 − 30 = 19.80°"]);
    listed(TextFormat::Latex, &[r"$90-21.5^\circ = 78.5$"]);
    listed(TextFormat::Markdown, &["130.05° − 80.25 − 30 = 29.80°"]);
}

#[test]
fn upright_sec_without_an_argument_is_the_second() {
    unlisted(
        TextFormat::Markdown,
        &[
            r"$$112000\,\text{sec} \times \frac{1\,\text{hour}}{3600\,\text{sec}} = 31.11\,\text{hours}$$",
            r"$\text{sec}(60^\circ) = 2$",
        ],
    );
    listed(
        TextFormat::Markdown,
        &[
            r"$$112000\,\text{sec} \times \frac{1\,\text{hour}}{3600\,\text{sec}} = 41.11\,\text{hours}$$",
            r"$\text{sec}(60^\circ) = 3$",
        ],
    );
}

#[test]
fn letters_behind_numbers_are_units_where_the_chain_makes_sense() {
    listed(
        TextFormat::Latex,
        &[
            r"$R = \frac{12.40mm+12.44mm+12.45mm}{3} = 12.83mm$",
            r"$Q=0.5\cdot 4186\cdot(100-30)=166510J$",
            r"$17 - 273 = -246K$",
            r"$V = \frac{2.5 \times 1.5}{1.7} = 2.31m^3$",
            r"$15\% \times 110g = 15g$",
            r"$u = 132.4 \times 0.05 = 0.00662V$",
            r"$E_k=\frac12\times0.2\times54.6^2=309.136\ J$",
            r"$\Delta H = \Delta H_{(1)} - \Delta H_{(2)} = (-383.5kJ) - (-253.5kJ) = -120kJ$",
        ],
    );
    unlisted(
        TextFormat::Latex,
        &[
            r"$R = \frac{12.40mm+12.44mm+12.45mm}{3} = 12.43mm$",
            r"$123.4mm = 0.1234m$",
            r"$10 + 4 = 2V$",
            r"$5m = 20$",
            r"$2m \cdot 3m = 6m$",
            r"$6 + 2m = 10m$",
            r"$12 - 2s = 4s$",
        ],
    );
}

#[test]
fn an_upright_letter_may_be_a_side() {
    let area =
        r"<m>\text{Area} = \frac{\sqrt{3}}{4} \times \text{s}^2 = \frac{\sqrt{3}}{4} \times 8^2 = 16\sqrt{3}</m>";
    unlisted(TextFormat::Xml, &[&pretext(area)]);
    listed(TextFormat::Xml, &[&pretext(&area.replace(r"16\sqrt", r"15\sqrt"))]);
}

#[test]
fn a_degree_beside_kelvins_is_one_of_temperature() {
    unlisted(TextFormat::Markdown, &["It melts at 900 K = 627°", "At 1000 K = 727° it boils."]);
    listed(TextFormat::Markdown, &["It melts at 900 K = 637°"]);
}

#[test]
fn a_temperature_is_converted_with_its_uncertainty() {
    let celsius = |kelvin: &str| format!(r"$(20 \pm 0.5)\,^\circ\mathrm{{C}} = ({kelvin} \pm 0.5)\,\mathrm{{K}}$");
    assert_told_apart(&celsius("293.15"), &celsius("283.15"), TextFormat::Latex);
    let fahrenheit =
        |celsius: &str| format!(r"$(68 \pm 1)\,^\circ\mathrm{{F}} = ({celsius} \pm 0.6)\,^\circ\mathrm{{C}}$");
    assert_told_apart(&fahrenheit("20"), &fahrenheit("30"), TextFormat::Latex);
}

#[test]
fn a_rate_may_have_a_prefix_alone() {
    for [right, wrong] in [
        [r"$8/(25\,\text{M}) = 320\,\text{ns}$", r"$8/(25\,\text{M}) = 330\,\text{ns}$"],
        ["It takes 8/(25 M) = 320 ns.", "It takes 8/(25 M) = 330 ns."],
    ] {
        assert_told_apart(right, wrong, TextFormat::Markdown);
    }
}

#[test]
fn units_and_dots_have_more_spellings() {
    for [right, wrong] in [
        [
            r"$(\SI{2}{\ampere})^2 \cdot \SI{50}{\milli\Omega} = \SI{0.2}{\watt}$",
            r"$(\SI{2}{\ampere})^2 \cdot \SI{50}{\milli\Omega} = \SI{0.3}{\watt}$",
        ],
        [
            r"$2\,\mathrm{A} \cdot 3\,\mathrm{V}\,\mathrm{mi} = 360\,\mathrm{J}$",
            r"$2\,\mathrm{A} \cdot 3\,\mathrm{V}\,\mathrm{min} = 380\,\mathrm{J}$",
        ],
        [r"$\mathrm{60\,(m)m = 60\left(\frac{1}{1000}\right)m}$", r"$\mathrm{60\,m = 60\left(\frac{1}{1000}\right)m}$"],
        [
            r"$\sin^{-1}\left(\frac{8}{15}\right) \approx 32.2309...^\circ$",
            r"$\sin^{-1}\left(\frac{8}{15}\right) \approx 33.2309...^\circ$",
        ],
    ] {
        assert_told_apart(right, wrong, TextFormat::Latex);
    }
}

#[test]
fn letters_with_coefficients_are_no_units() {
    assert_told_apart("The budget is 100 = 5J + 10N.", "The energy is 60 J = 40 J + 30 J.", TextFormat::Markdown);
}

#[test]
fn letters_of_quantities_stand_behind_signs_of_products() {
    assert_told_apart("So h = 150 m = 0.5·g·3^2 here.", "So h = 150 m = 0.5·3 m·3 here.", TextFormat::Markdown);
    assert_told_apart("It is 8/(5.43A°)^3 = 5 × 10^22.", "It is 8/(5.43 m)^3 = 5 × 10^22 m^-3.", TextFormat::Markdown);
}

#[test]
fn letters_of_physics_and_chemistry_are_no_units() {
    unlisted(
        TextFormat::Markdown,
        &[
            "Ballistic conductance is G₀ = 2e²/h = 77.5 µS per mode.",
            "It is 81.10 g H * (1 mol / 1.01 g) = 80.297 mol H",
        ],
    );
    listed(
        TextFormat::Markdown,
        &["It lasts 2 m²/h = 77.5 µS per mode.", "It is 81.10 g * (1 mol / 1.01 g) = 90.297 mol"],
    );
}

#[test]
fn ounces_may_be_those_of_fluids() {
    let table = |result: &str| {
        pretext(&format!(
            "<md><mrow>8\\,\\text{{oz}} \\amp= \\frac{{8\\,\\text{{oz}}}}{{1}}\\cdot\\frac{{29.57\\,\\text{{mL}}}}{{1\\,\\text{{oz}}}}</mrow><mrow> \\amp = {result}\\, \\text{{mL}}</mrow></md>"
        ))
    };
    assert_told_apart(&table("236.56"), &table("246.56"), TextFormat::Xml);
}

#[test]
fn a_scale_is_named_somewhere_in_its_section() {
    let scale = |words: &str| {
        format!(
            "{words} of the room. Choose well. Measure each wall with care and write down its length in metres, with one decimal, before you begin, and note which of them have a window or a door. Then $1 \\text{{ cm}} = 0.5 \\text{{ m}}$ it is."
        )
    };
    assert_told_apart(&scale("Make a scale drawing"), &scale("Make a model"), TextFormat::Markdown);
}

#[test]
fn a_rate_behind_a_result_is_its_unit() {
    let calls = |unit: &str| format!("(VoIP: 1e6 * 0.5 hr * 64 kbps = 32,000{unit}. Video comes next.)");
    assert_told_apart(&calls(" GB/day"), &calls(""), TextFormat::Markdown);
}

#[test]
fn kilonewtons_are_joined_to_metres() {
    unlisted(TextFormat::Markdown, &[r"$6 \text{ kN} \cdot 2 \text{ m} = 12 \text{ kNm}$"]);
    listed(TextFormat::Markdown, &[r"$6 \text{ kN} \cdot 2 \text{ m} = 13 \text{ kNm}$"]);
}
