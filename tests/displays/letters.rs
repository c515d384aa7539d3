//! The letters of the sources, in the states in which their equations must hold.

use super::escapement::{self, Wanted};
use super::mechanisms::{When, frame, pin, quick_return, wheel};
use geneva_kinematics::Mechanism;
use geneva_kinematics::wheel::Wheel;
use geneva_ledger::tex::Moment;
use geneva_ledger::{Claim, Entry, Work};
use std::f64::consts::PI;

/// What stands in place of the dots of a claim's printed characters: the name of each claim whose number the line has
/// there. A name is for the exact value, so that no rounding is in the way.
const DOTS: &[(&str, &str)] = &[
    ("pin.angle-at-driver", r"\theta"),
    ("pin.angle-at-pivot", "b"),
    ("quick-return.ground", "l"),
    ("quick-return.lever-angle", r"\varphi"),
    ("quick-return.crank", "l_2"),
    ("quick-return.crank-angle", r"\psi"),
    ("quick-return.angle-at-pin", r"\beta"),
];

/// The claims whose numbers stand at the dots of a claim, by the inventory of its source.
fn at_the_dots(of: &Claim) -> Vec<&'static str> {
    let lines = of.work.inventory().expect("an inventory");
    let is_made = |entry: &&Entry| entry.claimed() == Some(of.id);
    let line = lines.iter().find(|line| line.entries.iter().any(|entry| is_made(&entry))).expect("a line");
    let behind: Vec<&Entry> = line.entries.iter().skip_while(|entry| !is_made(entry)).collect();
    let filling = |pair: &[&Entry]| match pair {
        [Entry::Claim(id) | Entry::Again(id), Entry::Rest(own, _)] if *own == of.id => Some(*id),
        _ => None,
    };
    behind.windows(2).filter_map(filling).collect()
}

/// What a claim is about that prints one side of an equation alone.
const MEANT: &[(&str, &str)] = &[
    ("quick-return.rate-conversion", r"\frac{\text{rev}}{\text{min}}"),
    ("quick-return.supplement", r"\psi"),
    ("quick-return.coriolis-equation", r"a_\mathrm{Cor}"),
    ("jazar.centre-distance", "l"),
    ("jazar.cutout-centres", r"\text{arcs}"),
    ("jazar.alpha-degrees", r"\alpha"),
    ("jazar.duration", r"\theta_{\text{exit}} - \theta_{\text{entry}}"),
    ("jazar.centre-distance-ratio", "l/r"),
];

/// Printed characters of a claim as an equation in names: dots filled, the missing side supplied.
pub fn equation(claim: &Claim, tex: &str) -> String {
    let mut tex = tex.to_owned();
    let filling = if tex.contains(r"\ldots") { at_the_dots(claim) } else { Vec::new() };
    if filling.is_empty() {
        // A break between two lines.
        tex = tex.replace(r"\ldots", " ");
    }
    for id in filling {
        let name = DOTS.iter().find(|(of, _)| *of == id).unwrap_or_else(|| panic!("no name for {id}")).1;
        // A name for an angle has its unit in it.
        let next = |dots: &&str| tex.find(dots).is_some() && tex.find(dots) == tex.find(r"\ldots");
        let dots = [r"\ldots^\circ", r"\ldots^{\circ}"].into_iter().find(next).unwrap_or(r"\ldots");
        tex = tex.replacen(dots, &format!("{name} "), 1);
    }
    match MEANT.iter().find(|(id, _)| *id == claim.id) {
        Some((_, side)) => format!("{side} = {tex}"),
        None => tex,
    }
}

/// States in which a claim's equation must hold, with the letters of its source.
pub fn states(claim: &Claim) -> Vec<Moment> {
    let many = |state: &dyn Fn(usize) -> Moment| (0..40).map(state).collect();
    match claim.work {
        Work::Pin => many(&|number| of_pin(claim.id, number)),
        Work::QuickReturn => many(&|number| of_quick_return(claim.id, number)),
        Work::Jazar2003 => many(&|number| of_jazar(claim, number)),
        Work::Meyer1973 => many(&|number| of_meyer(claim.id, number)),
        // The ledger reads them all itself.
        Work::Wild => Vec::new(),
    }
}

fn of_pin(id: &str, number: usize) -> Moment {
    let four = id == "pin.centre-distance";
    let angle = (id == "pin.law-of-sines").then_some(30f64.to_radians());
    let state = pin(number, four.then_some(2f64.sqrt()), angle).called([("g", r"\gamma")]);
    // The angles of the triangle, which have no sign.
    let state = [("b", "varphi"), (r"\theta", "theta")].iter().fold(state, |state, (theirs, ours)| {
        let angle = state.letters()[*ours].abs();
        state.with([(*theirs, angle)])
    });
    if id == "pin.velocity-equation" {
        return state.called([("v_P", r"\vec{v}_P"), ("v_{P'}", r"\vec{v}_{P'}"), ("v_{P/S}", r"\vec{v}_{P/S}")]);
    }
    // With the index of a disk the letter is an angular velocity.
    state.called([(r"\mathrm{v}_{D}", r"\dot\theta"), (r"\mathrm{v}_{S}", r"\dot\varphi")])
}

fn of_quick_return(id: &str, number: usize) -> Moment {
    // The lever's acceleration is a length, and the crank's angle ψ is from the direction to the crank's axis.
    let state = quick_return(number, 0.0).called([(r"\omega_2", r"\dot\theta"), (r"\omega_4", r"\dot\varphi")]);
    let [acceleration, crank] = ["varphi''", "theta"].map(|name| state.letters()[name]);
    let state = state.with([(r"\alpha_4", acceleration.abs()), (r"\psi", PI + crank)]);
    match id {
        "quick-return.sum-of-places" | "quick-return.velocity-in-a-frame" | "quick-return.acceleration-in-a-frame" => {
            frame(number, 1.0)
        }
        "quick-return.sum-of-places-by-points" => {
            frame(number, 1.0).called([("r_{P2}", "r"), ("r_{P4}", "R"), ("r_{P2/P4}", "p")])
        }
        "quick-return.velocity-by-points" => {
            frame(number, 0.0).called([("v_{P2}", r"\dot{r}"), ("v_{P4}", r"\dot{R}"), ("v_{P2/P4}", r"\dot{p}")])
        }
        // Units of any size.
        "quick-return.rate-conversion" => Moment::default().with([
            (r"\text{rev}", 2.0 * PI * 3.0),
            (r"\text{rad}", 3.0),
            (r"\text{min}", 60.0 * 5.0),
            (r"\text{s}", 5.0),
        ]),
        // The problem's letters and the solution's.
        "quick-return.seven-terms" => components(number, ["P_2", "P_4", "P_2P_4"]),
        "quick-return.seven-terms-by-points" => components(number, ["P2", "P4", "P2/P4"]),
        _ => state
            .called([(r"\gamma", r"\gamma_2"), ("l_2", "R"), ("l_4", "r"), ("v_{P2}", "v_2"), ("v_{P4}", "v_4")])
            .called([
                ("v_{P2/P4}", r"v_\mathrm{rel}"),
                ("A_{P2}^n", r"a_2^\mathrm{n}"),
                ("A_{P4}^n", r"a_4^\mathrm{n}"),
            ])
            .called([("A_{P4}^t", r"a_4^\mathrm{t}"), ("A_{P2/P4}^t", r"a_\mathrm{rel}^\mathrm{t}")])
            .called([("v_{P_2}", r"\vec{v}_2"), ("v_{P_4}", r"\vec{v}_4"), ("v_{P_2P_4}", r"\vec{v}_\mathrm{rel}")])
            .called([("a_{P_2}", r"\vec{a}_2"), ("a_{P_4}", r"\vec{a}_4"), ("a_{P_2P_4}", r"\vec{a}_{2/4}")])
            .called([("a_{P2}", r"\vec{a}_2"), ("a_{P4}", r"\vec{a}_4"), ("a_{P2/P4}", r"\vec{a}_{2/4}")]),
    }
}

/// Normal and tangential components of the pin, the lever's point and between them, by these indices, of a crank that
/// speeds up.
fn components(number: usize, [pin, lever, between]: [&str; 3]) -> Moment {
    let parts = [(pin, "2"), (lever, "4"), (between, r"\mathrm{rel}")];
    let names = parts.iter().flat_map(|(index, of)| {
        ["n", "t"].map(|way| (format!("a_{{{index}}}^{way}"), format!(r"\vec{{a}}_{of}^\mathrm{{{way}}}")))
    });
    let moment = names.fold(quick_return(number, 1.5), |moment, (name, own)| moment.called([(&*name, &*own)]));
    moment.called([(r"\omega_4", r"\vec{\omega}_4"), (&*format!("v_{{{between}}}"), r"\vec{v}_\mathrm{rel}")])
}

fn of_jazar(claim: &Claim, number: usize) -> Moment {
    let when = match claim.id {
        "jazar.ex-e.condition" | "jazar.ex-e.quadratic" | "jazar.ex-e.roots" | "jazar.eq-5.34" => When::AtPeak,
        "jazar.unsteady-acceleration" => When::Unsteady,
        _ => When::Steady,
    };
    let stations = match claim.id {
        "jazar.ex-d.peak-equation" => Some(6),
        _ if claim.printed.contains(r"\sqrt{2}") => Some(4),
        _ => None,
    };
    let state = wheel(number, stations, when)
        .called([("r", "R"), ("x", "r"), (r"\phi", r"\varphi")])
        .called([(r"\dot\phi", r"\dot\varphi"), (r"\ddot\phi", r"\ddot\varphi")]);
    match claim.id {
        "jazar.ex-d.peak-equation" => state.called([(r"\dot{\phi}_{\rm max}", r"\dot\varphi_{\max}")]),
        // Angles count in degrees.
        "jazar.ex-c.formula" => {
            let wheel = Wheel::new(3 + number as u32 % 16).expect("a wheel");
            state.with([(r"\alpha", wheel.half_pitch_angle().to_degrees())])
        }
        _ => state,
    }
}

fn of_meyer(id: &str, number: usize) -> Moment {
    let handing_over = ["meyer.phi-0", "meyer.theta-0"].contains(&id) || id.ends_with(".radius-equation");
    let mechanism =
        [("three-slots", Mechanism::SIX_PIN), ("four-slots", Mechanism::FOUR_PIN), ("six-slots", Mechanism::THREE_PIN)];
    let mechanism = mechanism.iter().find(|(part, _)| id.contains(part)).map(|(_, mechanism)| *mechanism);
    let crank_radius = id.starts_with("meyer.app-a.").then_some(1.0);
    escapement::state(number, &Wanted { mechanism, crank_radius, handing_over })
        .called([("r", "R"), ("R", "r"), ("c", "l"), ("a", "k"), ("n", "N"), ("N", "F")])
        .called([(r"\phi", r"\varphi"), (r"\dot\phi", r"\dot\varphi"), (r"\ddot\phi", r"\ddot\varphi")])
        .called([(r"\phi_0", r"\varphi_0"), (r"\phi_o", r"\varphi_0"), (r"\theta_o", r"\theta_0")])
}
