//! Units as texts write them: each is known, so that a wrong number beside it is noticed.

use crate::{report, verdicts, wrong};
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
