//! The formulas in the lines of the chapters that relate nothing: a factor, an arm, an angle. Each is put into an equation in
//! which the chapter's text uses it, or is listed with the reason why not, so that another one in its place is noticed.

use super::book::states_of;
use super::inline::{formulas, relates};
use super::{Harmless, Misprints};
use geneva_evidence::tex::{Display, Moment, changed_part, name};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::spherical_wheel::SphericalWheel;
use geneva_kinematics::wheel::Wheel;

/// A formula, and an equation that holds with the formula in the place of the dot, wherever the mechanism of its chapter is.
type Use = (&'static str, &'static str);

/// By chapter.
const USED: &[(&str, &[Use])] = &[
    (
        "escapement",
        &[
            (r"2\pi/m", r"• = 2\theta_0"),
            (r"2\pi/N", r"• = 2\varphi_0"),
            (r"\pi/m", r"• = \theta_0"),
            (r"\pi/N", r"• = \varphi_0"),
            (r"-\pi/m", r"\theta_0 + • = 0"),
            (r"1\cdot4", r"• = (m-2)(N-2)"),
            (r"2\cdot2", r"• = (m-2)(N-2)"),
            (r"4\cdot1", r"• = (m-2)(N-2)"),
            (r"r^2/R^2", r"• = 1 + k^2 - 2k\cos\theta"),
            (r"\mu F", r"\left|• l\sin\varphi\right| = -\tau_2"),
            (r"l\sin\varphi", r"\mu \left|F\right| \left|•\right| = -\tau_2"),
            (r"\mu|F|", r"• \left|l\sin\varphi\right| = -\tau_2"),
            (r"\dot\varphi/\dot\theta", r"F r • = I_f\ddot\varphi \dot\varphi / \dot\theta"),
            (r"K + \tau_2", r"• = I_f(A\ddot\theta + B\dot\theta^2)"),
            (r"A\,C\,\dot\theta^2 + D\,(E - B\,\dot\theta^2)", r"• = (C\dot\theta^2 + D\ddot\theta)(A + S D)"),
            (r"A - S\,D", r"• (A + S D) = A^2 - D^2"),
            (r"A + S\,D", r"•\ddot\theta = E - (B + S C)\dot\theta^2"),
            (r"I_D/I_f", r"A = • + \dot\varphi^2/\dot\theta^2"),
            (r"\tan\varphi", r"• = \sin\theta/(k - \cos\theta)"),
        ],
    ),
    (
        "jazar",
        &[
            (r"2\pi", r"\frac{\text{moving time}}{T} = (\pi - 2\alpha)/•"),
            (r"\pi - 2\alpha", r"\frac{\text{moving time}}{T} = •/(2\pi)"),
            (r"\pi/2 - \alpha", r"• = \theta_{\text{exit}}"),
            (r"\dot\theta^2\tan\alpha", r"• = |\ddot\varphi|_{\text{entry}}"),
            (r"\tan\alpha", r"\dot\theta^2 • = |\ddot\varphi|_{\text{entry}}"),
            (r"r\cos\varphi", r"• = l - R\cos\theta"),
            (r"\sin\alpha", r"k • = 1"),
        ],
    ),
    (
        "joints",
        &[
            (r"\dot\theta + \dot\varphi", r"w - \dot r = s\rho •"),
            (r"s\,\rho\,(\dot\theta + \dot\varphi)", r"w = \dot r + •"),
            ("q r", r"•\dot\theta = r\dot\varphi"),
            (r"\kappa_f F", "• = M"),
            (r"I_D + \kappa\,q\,I_f", r"•\ddot\theta = K - G - \kappa(I_f p\dot\theta^2 + H)"),
        ],
    ),
    (
        "making",
        &[
            ("1/2 - 1/N", r"• = \text{index of one pin}"),
            ("1/2 + 1/N", r"• = \text{internal index}"),
            ("1/2", r"• = \text{spherical index}"),
            ("2N/(N-2)", r"• (\text{index of one pin}) = 1"),
            (r"1/\sin\alpha", r"• = l/R"),
            (r"1/\tan\alpha", r"• = \text{wheel radius}/R"),
            (r"R/\tan\alpha", r"• = \text{wheel radius}"),
            ("l/R", r"• \sin\alpha = 1"),
            (r"\sin\alpha/(1-\sin\alpha)", r"• = \text{peak speed}"),
            (r"\sin\alpha/(1+\sin\alpha)", r"• = \text{internal peak speed}"),
            (r"\tan\alpha", r"• = \text{jump at entry} = \text{internal jump at entry} = \text{spherical peak speed}"),
            (r"\sin\alpha\cos\alpha", r"• = \text{spherical jump at entry}"),
            (r"J\ddot\varphi + M", "• = F r"),
        ],
    ),
    ("pin", &[(r"90^\circ - |\theta|", r"\gamma = • - |\varphi|")]),
    (
        "quick-return",
        &[
            (r"\varphi + \beta", r"\theta + 180^\circ = •"),
            (r"a_2^\mathrm{n}\sin\beta", r"a_4^\mathrm{t} = • - a_\mathrm{Cor}"),
            (r"\dot\varphi\,v_\mathrm{rel}", r"2• = a_\mathrm{Cor}"),
            (r"\dot r\,\dot\varphi", r"|2•| = a_\mathrm{Cor}"),
            (r"r\dot\varphi", r"• = v_4"),
            // A small time has one letter here.
            (r"\omega v", r"2• = a_\mathrm{Cor}"),
            (r"2\omega v", r"• = a_\mathrm{Cor}"),
            (r"\omega\,h", r"2v• = a_\mathrm{Cor} h"),
            (r"v\,\omega\,h", r"2• = a_\mathrm{Cor} h"),
            (r"\omega v\,h", r"2• = a_\mathrm{Cor} h"),
            (r"r + v\,h", r"2\omega• - 2\omega r = a_\mathrm{Cor} h"),
            (r"\omega\,(r + v\,h)", r"2• - 2\omega r = a_\mathrm{Cor} h"),
            (r"v\,h \cdot \omega\,h", r"2• = a_\mathrm{Cor} h^2"),
            (r"a\,h^2", r"• = 2v\omega h^2"),
        ],
    ),
    ("solver", &[("A + S D", r"•\ddot\theta = E - (B + S C)\dot\theta^2")]),
    (
        "terminal-speed",
        &[
            (r"-2 (B + S C)/(A + S D)", r"u' = 2 E/(A + S D) + • u"),
            (r"4 (AC - BD)/(A^2 - D^2)", r"• = 2(B + C)/(A + D) - 2(B - C)/(A - D)"),
            (r"I_D/I_f", r"A = • + q^2"),
        ],
    ),
    (
        "wild",
        &[
            (r"\pi/N", r"• = \alpha"),
            (r"360^\circ/N", r"• = 2\alpha"),
            (r"180^\circ - 360^\circ/N", r"• = 2\theta_{\text{exit}}"),
            (r"\sin(\pi/N)", "l • = R"),
            (r"\cos(\pi/N)", r"l • = \text{wheel radius}"),
            ("R/l", r"• = \cos\theta_{\text{exit}} = \sin\alpha"),
        ],
    ),
];

/// Formulas that are put into no equation, by the reason why.
const NOT_EVALUATED: &[(&str, &[(&str, &str)])] = &[
    (
        "it says of what something is a function, or what it is multiplied by or proportional to",
        &[
            ("escapement", r"\cos\theta"),
            ("escapement", r"2mN/\pi"),
            ("jazar", r"\cos\theta"),
            ("glossary", r"\sqrt{K/I_f}"),
            ("glossary", r"\sqrt{I_f/K}"),
            ("joints", r"\sqrt{K/I_f}"),
            ("making", r"N/\pi"),
            ("making", "b R^4"),
            ("making", "(J_t + b R^4)/R"),
            ("runs", r"\sqrt K"),
            ("runs", r"1/\sqrt K"),
            ("terminal-speed", r"\sqrt{K/I_f}"),
            ("terminal-speed", r"\sqrt{I_f/K}"),
            ("terminal-speed", "K/I_f"),
            ("timer", r"\sqrt{K/I_f}"),
            ("timer", r"\sqrt{I_f/K}"),
            ("timer", r"\sqrt K"),
            ("timer", r"\sqrt 2"),
            ("timer", "I_D/I_f"),
            ("making", r"\dot\theta^2"),
            ("pin", "r^2"),
            ("pin", r"\sin\theta\cos\theta"),
            ("pin", r"\dot\theta^2"),
            ("program", "h^5"),
            ("program", "h^4"),
            ("runs", r"\ln L"),
            ("escapement", r"K\dot\theta"),
            ("escapement", "A - |D|"),
            ("jazar", "2N/(N-2)"),
            ("jazar", "(N-2) : (N+2)"),
            ("jazar", r"\dot\varphi/\dot\theta"),
            ("jazar", r"\ddot\varphi/\dot\theta^2"),
        ],
    ),
    (
        "it is of one instant, or of one wheel",
        &[
            ("jazar", r"-\tfrac{3}{2}\cos^2\alpha"),
            ("jazar", r"\tfrac{1}{2} + \tfrac{1}{8}"),
            ("joints", "k - 1"),
            ("joints", r"(1-\rho)\,\dot\theta"),
            ("pin", r"k\,(k^2 - 1)"),
            ("pin", r"\dot\theta/\sqrt{6}"),
            ("pin", r"\sqrt{2}"),
            ("pin", r"180^\circ/N"),
        ],
    ),
    (
        "it is an example of a number, or says how small an error is",
        &[
            ("glossary", "1/e"),
            ("joints", "10^{-12}"),
            ("joints", "10^{-9}"),
            ("method", r"\sqrt{2}"),
            ("method", "d+1"),
            ("solver", "10^{-11}"),
        ],
    ),
    (
        "it is nearly so, or in a limit",
        &[
            ("making", r"l\sin\tau"),
            ("making", r"\sin\tau"),
            ("making", r"\sqrt{2g/R}"),
            ("making", r"e\sin\alpha"),
            ("making", r"g/\sin\alpha"),
        ],
    ),
    (
        "a derivative on one line, a small step, an integral or a cotangent is not read",
        &[
            ("escapement", r"\cot(\pi/N)"),
            ("escapement", r"|dr/d\theta|"),
            ("escapement", r"|dr/d\theta|\,\delta\theta"),
            ("joints", r"dr/d\theta + s\rho"),
            ("solver", r"\int d\theta / \dot\theta"),
            ("timer", r"\varepsilon"),
            ("quick-return", "O_4 O_2"),
            ("quick-return", "O_2 O_4"),
        ],
    ),
    (
        "the states of the chapter have no value for one of its letters",
        &[
            ("glossary", r"2\pi/m"),
            ("glossary", "A - |D|"),
            ("jazar", r"R - \rho - t"),
            ("jazar", r"J\ddot\varphi"),
            ("jazar", r"J\ddot\varphi\,\dot\varphi/\dot\theta"),
            ("jazar", r"\sqrt{(\text{wheel radius})^2 + \rho^2}"),
            ("program", r"1/\sin(\pi/N)"),
            ("program", r"(k\cos\theta - 1)/(1 + k^2 - 2k\cos\theta)"),
            ("terminal-speed", r"\lambda u + u_0"),
            ("timer", r"K\varepsilon"),
            ("wild", "bz/R"),
            ("wild", "lz/R"),
            ("joints", r"2\rho"),
            ("joints", r"s\rho"),
            ("joints", r"\sigma\mu|F|"),
            ("joints", r"|F|\sqrt{1+\mu^2}"),
            ("joints", r"\mu_b r_b"),
            ("quick-return", r"\vec{\omega} \times (\vec{\omega} \times \vec{p})"),
            ("quick-return", r"\dot{\vec{\omega}} \times \vec{p}"),
            ("quick-return", r"2\,\vec{\omega} \times \dot{\vec{p}}"),
            ("quick-return", r"(\vec{\omega} \times \vec{\omega}) \times \vec{p}"),
        ],
    ),
];

/// Misprints that make no difference where the text speaks of a size.
const HARMLESS: &Harmless = &[
    (r"escapement: \mu F", "it is between bars in the torque", &[MINUS]),
    (r"escapement: l\sin\varphi", "it is between bars in the torque", &[MINUS]),
    (r"quick-return: \dot r\,\dot\varphi", "the text tells its sense in words", &[MINUS]),
];

const MINUS: &str = "piece 0: a minus is put before it";

/// The states of a chapter, with what its formulas need besides.
fn states(chapter: &str) -> Vec<Moment> {
    let states = states_of(if chapter == "wild" { "jazar" } else { chapter }).unwrap_or_default();
    match chapter {
        "making" => states.into_iter().map(of_all_kinds).collect(),
        "quick-return" => states.into_iter().map(sliding_for_a_moment).collect(),
        _ => states,
    }
}

/// The lever with a bead that slides along it for a moment, in the letters with which the chapter explains the factor two.
fn sliding_for_a_moment(state: Moment) -> Moment {
    let [turning, sliding, coriolis] =
        ["varphi'", "v_rel", "a_Cor"].map(|name| state.letters().get(name).copied().unwrap_or(f64::NAN));
    state.with([(r"\omega", turning.abs()), ("v", sliding), ("a", coriolis), ("h", 0.125)])
}

/// A wheel of the chapter with its sizes, and the internal and the spherical one of as many stations.
fn of_all_kinds(state: Moment) -> Moment {
    let [stations, radius] = ["N", "R"].map(|name| state.letters()[name]);
    let wheel = Wheel::new(stations as u32).expect("a wheel");
    let internal = InternalWheel::new(wheel.stations()).expect("a wheel");
    let spherical = SphericalWheel::new(wheel.stations()).expect("a wheel");
    state
        .with([(r"\alpha", wheel.half_pitch_angle()), ("l", wheel.centre_distance_ratio() * radius)])
        .with([(r"\text{wheel radius}", wheel.wheel_radius_ratio() * radius)])
        .with([(r"\text{index of one pin}", wheel.motion_fraction())])
        .with([(r"\text{internal index}", internal.motion_fraction())])
        .with([(r"\text{spherical index}", spherical.motion_fraction())])
        .with([(r"\text{peak speed}", wheel.peak_velocity())])
        .with([(r"\text{internal peak speed}", internal.peak_velocity().abs())])
        .with([(r"\text{spherical peak speed}", spherical.peak_velocity().abs())])
        .with([(r"\text{jump at entry}", wheel.entry_acceleration().abs())])
        .with([(r"\text{internal jump at entry}", internal.entry_acceleration().abs())])
        .with([(r"\text{spherical jump at entry}", spherical.entry_acceleration().abs())])
}

/// Whether a formula is more than a name or a number, with its sign, its bars and its unit: points named one after the other are
/// a length.
fn is_composed(tex: &str) -> bool {
    let bare = tex.trim_start_matches(['-', '+']).trim_matches('|').trim_end_matches(r"^\circ");
    let points = bare.chars().all(|c| c.is_ascii_uppercase()) && bare.len() > 1;
    name(bare).is_err() && !points && !bare.chars().all(|c| c.is_ascii_digit())
}

#[test]
fn every_formula_in_a_line_that_relates_nothing_is_what_its_text_takes_it_for() {
    let used = || USED.iter().flat_map(|(chapter, all)| all.iter().map(|(tex, equation)| (*chapter, *tex, *equation)));
    let not_evaluated = || NOT_EVALUATED.iter().flat_map(|(_, all)| all.iter().copied());
    let mut left_over: Vec<(&str, &str)> =
        used().map(|(chapter, tex, _)| (chapter, tex)).chain(not_evaluated()).collect();
    let (mut wrong, mut evaluated, mut misprints) = (Vec::new(), 0, Misprints::default());
    for (path, text) in crate::texts() {
        let chapter = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let states = states(&chapter);
        let formulas = formulas(&text).into_iter().map(|tex| tex.replace(r"\Delta t", "h"));
        for tex in formulas.filter(|tex| !relates(tex) && is_composed(tex)) {
            let is = |(of, formula): (&str, &str)| of == chapter && formula == tex;
            left_over.retain(|known| !is(*known));
            if not_evaluated().any(is) {
                continue;
            }
            let Some((_, _, equation)) = used().find(|(of, formula, _)| is((of, formula))) else {
                wrong.push(format!("{chapter}: `{tex}`: say here in which equation its text uses it"));
                continue;
            };
            let holds = |equation: &str| Display::read(equation).and_then(|display| display.holds(&states));
            let with = |tex: &str| holds(&equation.replace('•', &format!("({tex})")));
            match with(&tex) {
                Ok(true) if !states.is_empty() => evaluated += 1,
                other => wrong.push(format!("{chapter}: `{tex}`: {equation}: {other:?}")),
            }
            misprints.make(&format!("{chapter}: {tex}"), &tex, |tex| with(tex).ok());
            // The changed part has the value that it had.
            misprints.survivors.retain(|(whose, misprint)| {
                let part = changed_part(&tex, &misprint.tex).filter(|_| *whose == format!("{chapter}: {tex}"));
                !part.is_some_and(|part| holds(&part) == Ok(true))
            });
        }
    }
    println!("{evaluated} formulas are evaluated, {} are not", not_evaluated().count());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(left_over.is_empty(), "in no chapter: {left_over:?}");
    misprints.are_noticed_but_for(HARMLESS);
}
