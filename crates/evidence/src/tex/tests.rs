//! Formulas are read as they are meant, their rates are those of calculus, and what has no meaning is named.

use super::*;
use nalgebra::{Complex, Vector2};

/// Letters of all spellings, at one instant.
fn moment() -> Moment {
    Moment::default()
        .with([("a", 3.0), ("x", 2.0), (r"\dot{x}", 5.0), (r"\ddot{x}_0", 7.0), ("I_f", 11.0), ("y_{n+1}", 13.0)])
        .with([(r"\theta", 0.5), (r"\dot\theta", 4.0), (r"\ddot\theta", -7.0), (r"\delta W", 17.0)])
        .with([("v_{P2/P4}", 4.0), (r"I_\mathrm{n}^\mathrm{t}", 6.0), ("x'", -8.0), (r"\text{disc radius}", 9.0)])
        .with([(r"\text{in}", 2.0), (r"\text{1DX}", 19.0), (r"\frac{\partial T}{\partial \dot{\theta}}", 23.0)])
        .with_instant("entry", [("x", 29.0)])
        .with([(r"\vec{r}", Vector2::new(3.0, 4.0))])
        .with([(r"\omega", Value::turning(2.0))])
        .sloping(|x, y| x - y)
}

#[test]
fn formulas_are_read_as_they_are_meant() {
    let meant = [
        // Numbers, products without a sign, strokes, fractions.
        r"2ax = 12 = \frac12 24 = \tfrac{48}{4}",
        r"2x/a x = 2 \cdot 2 / 3 \cdot 2",
        r"\frac{a + 1}{x} x^3 = 16, \qquad 0.5 = 1/2.",
        r"(a - x)/x a = 1.5",
        // Signs.
        r"-a^2 + x = -7",
        r"1 - 2 - 3 = -4",
        // Powers, of letters, numbers and functions.
        r"y_{n+1}^{1/2} = \sqrt{13}",
        r"\sin^2 \theta + \cos^{2}\theta a - 2\cos \theta \cos\theta = 1",
        r"\sin\theta\,(1 - a) = -2\sin(\theta)",
        r"\cos\theta^2 = \cos (1/4)",
        r"2\sin(\pi/6) = 1 = \tan 45^\circ",
        r"\sec\theta \cos\theta = 1",
        r"\cos^{-1}\left(\frac{1}{x}\right) = \pi/3",
        r"\tan^{-1} \left(\tan\frac{\pi}{a}\right) = 60^\circ",
        r"\cos\text{acos}\theta = \theta",
        // Brackets of any kind, and bars.
        r"\left\{ a \left[ x - 1 \right] \right\} = 3",
        r"I_f \left| x - a \right| x = 22",
        r"a|x - \dot{x}| = 9 = |a| \, |a|",
        r"|(a |x'|)| = 24",
        r"|x|_\mathrm{entry} = 29",
        // Accents, indices, words, steps, derivatives that are names.
        r"\dot{x}^2 - \ddot{x}_0 = 18 = \dot x^2 - \ddot x_{0}",
        r"v_{P2/P4}^2 - I_{n}^{t} = 2 \left( 10 - 5 \right) = 10, \tag{1-1}",
        r"\text{disc radius} = 9",
        r"\text{1DX} = 19",
        r"4 \text{ in/in}^2 = .2 10 = 2 I_f / 11",
        r"\delta W = 17",
        r"\frac{\partial T}{\partial\dot\theta} = 23",
        r"f\left(x + 1; a x\right) x = -6 = f(3, 6) x",
        // Layout.
        r"\begin{aligned} a &+ x \\ &\quad + 1 \end{aligned} = 6",
        // Vectors.
        r"\omega \times \omega \times \vec{r} = -4 \vec{r}",
        r"\left| \vec{r} \right| = 5, \quad \begin{pmatrix} a \\ 4 \end{pmatrix} = \vec{r}",
    ];
    for tex in meant {
        assert_eq!(Display::read(tex).and_then(|display| display.holds([&moment()])), Ok(true), "{tex}");
    }
    for tex in [r"1 - 2 - 3 = 2", r"a = \vec{r}", r"\begin{pmatrix} a \\ 1 \end{pmatrix} \times \vec{r} = 0"] {
        assert_eq!(Display::read(tex).and_then(|display| display.holds([&moment()])), Ok(false), "{tex}");
    }
}

#[test]
fn a_part_of_a_display_may_lack_brackets() {
    for (tex, expected) in [
        (r"\left. \left[ a \right. \\ & \left. + x", 5.0),
        (r"x[a + 2 ( a", 18.0),
        (r"a + x \right] \right]", 5.0),
        (r"\left| -a", 3.0),
        (r"\left[ a + x \right\}", 5.0),
    ] {
        let part = Display::read_part(tex).expect(tex);
        assert_eq!(moment().number(part.alone().expect(tex)), Ok(expected), "{tex}");
        assert!(Display::read(tex).is_err(), "{tex}");
        assert!(value(tex, moment().letters()).is_nan(), "{tex}");
    }
    for tex in [r"\left[ a = x + 1 \right]", "(a = x + 1", "a = x + 1)", "a = (x + 1]"] {
        assert_eq!(holds(tex, [&moment()]), None, "{tex}");
    }
    assert_eq!(joined_holds("a = (x + 1]", [&moment()]), Some(true));
    assert_eq!(joined_holds("a = (x + 1", [&moment()]), None);
}

#[test]
fn a_double_sign_stands_for_both() {
    // Once a number more and once a number less than another.
    let [more, less] = [3.0, 1.0].map(|a| moment().with([("a", a)]));
    let both = |tex: &str| holds(tex, [&more, &less]);
    assert_eq!(both(r"a = x \pm 1"), Some(true));
    assert_eq!(both(r"x = a \pm 1"), Some(true));
    assert_eq!(both(r"x^2 \pm 0 = 4"), Some(false));
    assert_eq!(both(r"a = x \pm 2"), Some(false));
    // One sign is enough, so the double one says too much.
    assert_eq!(holds(r"a = x \pm 1", [&more]), Some(false));
    assert_eq!(holds(r"a = x + 1", [&more]), Some(true));
}

#[test]
fn what_says_nothing_is_no_equation() {
    for tex in ["a = a", "x + 1 = a = (a)", r"a = x + 1, \quad x = x", r"\frac{a}{x} = \frac{(a)}{x}"] {
        let found = Display::read(tex).and_then(|display| display.holds([&moment()]));
        assert!(found.is_err_and(|error| error.to_string().contains("with itself")), "{tex}");
    }
    // The number of an equation is said by its locator.
    assert_eq!(holds(r"a = x + 1 \tag{1-2}", [&moment()]), None);
}

#[test]
fn an_upright_letter_is_another_letter() {
    let moment = moment().with([(r"\mathrm{a}_P", 31.0), ("a_P", 37.0)]);
    assert_eq!(holds(r"\text{a}_P = 31 = a_P - 6", [&moment]), Some(true));
    assert_eq!(holds(r"\mathrm{x} = 2", [&moment]), None);
}

#[test]
fn what_has_no_meaning_is_named() {
    for (tex, what) in [
        (r"a = \oint a", r"\oint"),
        ("a = b", "name b"),
        ("a = (a]", "`]`"),
        ("a = g(a, a)", "`,`"),
        ("f(a) = a", "`)`"),
        ("a < 4", "`<`"),
        ("a", "equates nothing"),
        ("a +", "the end"),
        (r"\frac{a} = 1", "`=`"),
        ("a) x = 1", "`)`"),
        ("1.2.3 = 1", "1.2.3"),
        ("a! = 1", "`!`"),
        (r"\vec{r} + 1 = a", "added to a vector"),
        (r"\sin \vec{r} = a", "a vector"),
        (r"\frac{d}{dt} I_f = 0", "rate"),
        (r"a^{x/2} = 9", "name x"),
    ] {
        let found = Display::read(tex).and_then(|display| display.holds([&moment()]));
        let error = found.expect_err(tex).to_string();
        assert!(error.contains(what), "{tex}: {error}");
    }
    assert!(value("a = x", moment().letters()).is_nan());
}

#[test]
fn derivatives_are_taken_by_what_stands_under_the_line() {
    // x = t³ + θ² θ'⁴ at t = 2, θ = 3, θ' = 1.5, all three of them free.
    let letters = |[t, angle, speed]: [f64; 3]| -> Letters {
        let x = t * t * t + angle * angle * (speed * speed) * (speed * speed);
        [("x", x), ("theta", angle), ("theta'", speed), ("dT/dtheta", 5.0)].map(|(n, v)| (n.to_owned(), v)).into()
    };
    let here = [2.0, 3.0, 1.5];
    let moment = Moment::of(letters(here)).moving(|by, step| {
        let mut there = here;
        there[by as usize] += step;
        letters(there)
    });
    for (tex, expected) in [
        (r"\frac{d}{dt} x^2 \frac{\partial T}{\partial \theta} = 120 (8 + 9 \dot\theta^4)", Some(true)),
        (r"\frac{d}{dt} x^2 \frac{\partial T}{\partial \theta} = 1 + 120 (8 + 9 \dot\theta^4)", Some(false)),
        (r"\frac{d}{dt} (x) = 12 = \dot x = \frac{dx}{dt}", Some(true)),
        (r"\frac{\partial}{\partial \theta} (x + \theta) = 2\theta\dot{\theta}^4 + 1", Some(true)),
        (r"\frac{\partial}{\partial \dot{\theta}} [x] = 4 \theta^2 \dot{\theta}^3", Some(true)),
        (r"\frac{\partial T}{\partial \theta} = 5", Some(true)),
        (r"\frac{\partial T}{\partial \dot\theta} = 5", None),
        (r"\frac{d}{dt} \frac{d}{dt} x = 12", None),
    ] {
        assert_eq!(holds(tex, [&moment]), expected, "{tex}");
    }
}

#[test]
fn every_rule_of_differentiation_is_that_of_a_difference() {
    // Both letters grow with the time, and no letter has a dot of its own.
    let letters = |t: f64| -> Letters { [("x".to_owned(), 0.5 + t * t), ("y".to_owned(), 0.75 + t)].into() };
    for tex in [
        "x - 2y/x",
        "(x + y) x",
        r"\frac{x + 1}{y x^2}",
        r"y^{3/2}\sqrt{x}",
        r"\sin x \cos^2 y",
        r"\tan x - \sec y",
        r"|x - y|",
        r"30^\circ x",
    ] {
        let moment = Moment::of(letters(0.25)).moving(|_, step| letters(0.25 + step));
        let whole = |step: f64| [("z".to_owned(), value(tex, &letters(0.25 + step)))].into();
        let rate = Moment::of(whole(0.0)).moving(|_, step| whole(step));
        let of = |tex: &str, moment: &Moment| moment.number(Display::read(tex).unwrap().alone().unwrap()).unwrap();
        let [by_rules, by_difference] = [of(&format!(r"\frac{{d}}{{dt}} ({tex})"), &moment), of(r"\dot z", &rate)];
        assert!((by_rules - by_difference).abs() < 1e-10, "{tex}: {by_rules}, not {by_difference}");
    }
}

#[test]
fn an_angle_may_be_imaginary() {
    let angle = Complex::new(0.0, libm::log(2.0));
    let letters = [("a", Complex::new(2.0, 0.0)), ("theta", angle)].map(|(name, value)| (name.to_owned(), value));
    let moment = Moment::of(Letters::from(letters));
    assert_eq!(holds(r"1 + a^2 - 2a \cos\theta = 0", [&moment]), Some(true));
    assert_eq!(holds(r"\theta = \cos^{-1} \left(\frac{1 + a^2}{2a} \right)", [&moment]), Some(true));
    assert_eq!(holds(r"\theta = \cos^{-1} \left(\frac{1 + a}{2a} \right)", [&moment]), Some(false));
}
