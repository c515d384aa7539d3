//! Temporary.
use geneva_dynamics::*;
use geneva_figures::escapement as e;
use geneva_kinematics::escapement::Escapement;
fn main() {
    let dir = "/tmp/esc-figs";
    std::fs::create_dir_all(dir).unwrap();
    let mut all = vec![];
    for one in Escapement::all() {
        let h = one.driver_half_angle();
        all.push(("a", e::mechanism(&one, -0.35 * h).unwrap()));
        all.push(("a", e::hand_over(&one)));
        all.push(("a", e::angles(&one, 0.6 * h).unwrap()));
    }
    all.push(("b", e::angles(&Escapement::new(4).unwrap(), -0.6).unwrap()));
    all.push(("b", e::angles(&Escapement::new(3).unwrap(), 0.1).unwrap()));
    all.push(("b", e::mechanism(&Escapement::new(6).unwrap(), 0.0).unwrap()));
    let p = |n: u32, d: f64, f: f64, mu: f64| {
        Parameters::new(Slots::new(n).unwrap(), Inertias::new(d, f).unwrap(), 1.0, mu).unwrap()
    };
    for (n, th, s) in [
        (4, -0.45, 0.3),
        (4, 0.45, 0.3),
        (4, 0.45, 0.0),
        (3, -0.3, 0.2),
        (3, 0.4, 0.5),
        (6, -0.6, 0.5),
        (6, 0.8, 1.0),
        (4, 0.0, 0.2),
    ] {
        all.push(("c", e::forces(&p(n, 3.0, 40.0, 0.1), th, s).unwrap()));
    }
    all.push(("d", e::ratios(&Escapement::all())));
    let d = |name: &str, n, i, mu| e::Design {
        name: name.into(),
        slots: Slots::new(n).unwrap(),
        inertia_ratio: i,
        friction: mu,
    };
    all.push((
        "d",
        e::existence(&[
            d("A", 4, 0.05, 0.1),
            d("Fig. 9, three curves", 4, 0.06, 0.2),
            d("B", 3, 0.6, 0.3),
            d("C", 6, 0.06, 0.2),
        ]),
    ));
    all.push(("d", e::existence(&[])));
    for (n, s) in [(4, 0.0), (4, 0.4), (3, 0.3), (6, 0.5)] {
        all.push(("d", e::normal_force(&p(n, 3.0, 40.0, 0.1), s).unwrap()));
    }
    all.push(("d", e::normal_force(&p(4, 3.0, 40.0, 0.0), 0.8).unwrap()));
    all.push(("d", e::order()));
    for (k, (g, f)) in all.iter().enumerate() {
        println!("{k:02} {g} {} {} bytes", f.id, f.svg.len());
        std::fs::write(format!("{dir}/{g}-{k:02}.svg"), format!("{}\n<!--{}-->", f.svg, f.caption)).unwrap();
        std::fs::write(format!("{dir}/{g}-{k:02}.txt"), f.series.to_text() + &f.description).unwrap();
    }
}
