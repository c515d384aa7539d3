//! Does the book print what the programs compute? Its displays are read, evaluated and compared.

mod book;
mod claims;
mod escapement;
mod factors;
mod joints;
mod letters;
mod mechanisms;
mod state;
mod tex;
mod tree;
mod value;

/// A number between zero and one, one of many that are spread evenly, the same on every machine.
fn spread(number: usize, which: usize) -> f64 {
    const PRIMES: [f64; 14] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0, 31.0, 37.0, 41.0, 43.0];
    ((number + 1) as f64 * PRIMES[which].sqrt()).fract()
}

#[test]
fn formulas_are_read_as_they_are_meant() {
    let state = state::State::default()
        .with([("a", 3.0), (r"\theta", 2.0), (r"\dot\theta", 5.0), (r"\ddot\theta", -7.0), ("v_{P2/P4}", 4.0)])
        .with([(r"I_\mathrm{n}^\mathrm{t}", 6.0), ("x'", -8.0)]);
    let meant = [
        (r"\frac12 a\,\tfrac13 = \frac{1}{2}", true),
        (r"\sin\theta\,(1 - a) = -2\sin(\theta)", true),
        (r"\sin^2\theta + \cos^{2} \theta = 1, \qquad a^2\theta = 18.", true),
        (r"2\theta/a\theta = 2 \cdot 2 / 3 \cdot 2", true),
        (r"v_{P2/P4}^2 - I_{n}^{t} = 2 \left( 10 - 5 \right) = 10, \tag{1-1}", true),
        (r"\left| -a \right| + |x'| \, |a| = 3 + 24", true),
        (r"\sqrt{a^2 + 4^2} = 5, \quad 180^\circ = \pi", true),
        (r"\ddot{\theta} + \dot{\theta}\theta = 3", true),
        (r"\tan^{-1} \left(\tan\frac{\pi}{a}\right) = 60^\circ", true),
        (r"\frac{d}{dt}(\theta^2) = 20, \quad \frac{d\dot\theta}{dt} = -7", true),
        (r"1 - 2 - 3 = 2", false),
        (r"a = \theta \pm 1 = 3", true),
        (r"\begin{pmatrix} a \\ 1 \end{pmatrix} \times \begin{pmatrix} 0 \\ 1 \end{pmatrix} = 0", false),
    ];
    for (tex, holds) in meant {
        let found = tex::read(tex).and_then(|display| value::holds(&display, std::slice::from_ref(&state)));
        assert_eq!(found, Ok(holds), "{tex}");
    }
    let unknown = [
        (r"a = \oint a", r"\oint"),
        ("a = b", "name b"),
        ("a = (a]", "`)`"),
        ("a = f(a, a)", "function f"),
        (r"\begin{pmatrix} a \\ 1 \end{pmatrix} = a", "equal"),
        ("a < 4", "<"),
        ("a", "equates nothing"),
    ];
    for (tex, what) in unknown {
        let found = tex::read(tex).and_then(|display| value::holds(&display, std::slice::from_ref(&state)));
        println!("{tex}: {found:?}");
        assert!(found == Ok(false) || found.is_err_and(|error| error.contains(what)), "{tex}");
    }
}
