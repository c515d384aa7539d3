//! Formulas for the sizes.

use super::fit::ANY;
use super::*;

const TWICE: &str = "The foot of the perpendicular from the driver's axis to the slot's line confirms the corrected \
                     form for 3 to 60 slots.";

pub(super) fn claims() -> Vec<Claim> {
    [wrong(), oxiphysics(), right(), generators(), both_ways(), slots(), of_four()].concat()
}

/// Centre distance, crank and wheel radius in the programs that take both ways, from the crank or from the wheel.
fn both_ways() -> Vec<Claim> {
    let centres =
        |place, id, printed, letters: fit::Letters| formula(place, id, printed, "centre distance", ANY, letters);
    let by_crank = |fit: &Fit| vec![("c", fit.centres), ("a", fit.crank), ("n", fit.slots)];
    let by_rim = |fit: &Fit| vec![("c", fit.centres), ("b", fit.rim), ("n", fit.slots)];
    let both = |fit: &Fit| vec![("a", fit.crank), ("b", fit.rim), ("c", fit.centres)];
    let crank = |place, id| {
        formula(place, id, r"a = \sqrt{c^2 - b^2}", "crank radius, if the wheel's radius is given", ANY, both)
    };
    let rim = |place, id| {
        formula(place, id, r"b = \sqrt{c^2 - a^2}", "wheel radius, if the crank radius is given", ANY, both)
    };
    vec![
        formula(MACRO, "wild.freecad.centres", r"c = \sqrt{a^2 + b^2}", "centre distance", ANY, both)
            .interpreted_as("We take the two radii of a wheel that fits. For other radii, see the example."),
        rim(MACRO, "wild.freecad.keep-crank-rim"),
        crank(MACRO, "wild.freecad.keep-rim-crank"),
        centres(WINDOW, "wild.freecad-window.keep-rim", r"c = b/\cos(\pi/n)", by_rim),
        crank(WINDOW, "wild.freecad-window.keep-rim-crank"),
        centres(WORKBENCH, "wild.gear-workbench.centres", r"c = a/\sin(\pi/n)", by_crank),
        centres(GENERATOR, "wild.generator.centres", r"c = a/\sin(\pi/n)", by_crank),
        rim(GENERATOR, "wild.generator.rim"),
        centres(GENERATOR, "wild.generator.keep-rim", r"c = b/\cos(\pi/n)", by_rim),
        crank(GENERATOR, "wild.generator.keep-rim-crank"),
    ]
}

/// How long the slots are, from the wheel's rim to the deepest place of the pin's centre.
fn slots() -> Vec<Claim> {
    let slot = |place, id| {
        let meaning = "length of a slot, from the wheel's rim to the deepest place of the pin's centre";
        formula(place, id, r"s = a + b - c", meaning, ANY, |fit| {
            vec![("s", fit.rim - fit.deepest), ("a", fit.crank), ("b", fit.rim), ("c", fit.centres)]
        })
    };
    vec![
        slot(MACRO, "wild.freecad.slot"),
        slot(WINDOW, "wild.freecad-window.slot"),
        slot(WORKBENCH, "wild.gear-workbench.slot"),
        slot(GENERATOR, "wild.generator.slot"),
        slot(OPENSCAD, "wild.openscad.slot"),
        slot(SDFX, "wild.sdfx.slot"),
    ]
}

/// The letters of the calculator's centre distance.
pub(super) fn centres(fit: &Fit) -> Vec<(&'static str, f64)> {
    vec![("C", fit.centres), (r"R_{geneva}", fit.rim), ("n", fit.slots)]
}

/// The letters of the calculator's driver radius.
pub(super) fn driver(fit: &Fit) -> Vec<(&'static str, f64)> {
    vec![(r"R_{driver}", fit.crank), ("C", fit.centres), (r"R_{geneva}", fit.rim), ("n", fit.slots)]
}

/// The letters of the centre distance with a root.
pub(super) fn centres_by_the_root(fit: &Fit) -> Vec<(&'static str, f64)> {
    vec![("C", fit.centres), (r"R_{pin}", fit.crank), ("n", fit.slots)]
}

/// The letters of the library's wheel radius.
pub(super) fn rim(fit: &Fit) -> Vec<(&'static str, f64)> {
    vec![("R", fit.rim), ("d", fit.centres), ("r", fit.crank)]
}

fn wrong() -> Vec<Claim> {
    vec![
        formula(
            CALCULATOR,
            "wild.firgelli-time.centres",
            r"C = \frac{R_{geneva}}{\sin(\pi/n)}",
            "centre distance from the wheel's radius",
            ANY,
            centres,
        )
        .corrected(
            r"C = \frac{R_{geneva}}{\cos(\pi/n)}",
            slip(
                "In the right-angled triangle of the two axes and the pin at entry, π/n is the angle at the wheel's \
                 axis. The side next to this angle is the wheel's radius, and the side opposite is the crank, so the \
                 sine gives the crank. For four slots the two sides are the same.",
                TWICE,
                "The formula puts the axes too far apart for more than four slots, and too close together for three. \
                 With six slots the distance is 1.7 times what it should be.",
            ),
        ),
        formula(
            CALCULATOR,
            "wild.firgelli-time.driver",
            r"R_{driver} = C - R_{geneva}",
            "distance of the pin from the driver's axis",
            ANY,
            driver,
        )
        .interpreted_as(
            "The page says that the pin sits at the driver's radius. We check this with the right centre distance. \
             With the page's own formula for the centre distance, the pin's distance from the driver's axis is \
             right for six slots only, and even then the wheel's radius does not fit.",
        )
        .corrected(
            r"R_{driver} = C \sin(\pi/n)",
            slip(
                "By the printed formula, the radii of the wheel and of the pin's circle add up to the centre distance. \
                 Two such circles touch in one point, on the line of centres. But on this line the pin must be inside \
                 the wheel, in a slot, so the pin's circle must cut the wheel's rim.",
                TWICE,
                "The pin's circle touches the wheel's rim from outside. So the pin never enters a slot, and the wheel \
                 does not move.",
            ),
        )
        .in_places(2),
        formula(
            INDEXING,
            "wild.firgelli-indexing.centres",
            r"C = R_{pin} \sqrt{2 + 2 \cos(180^{\circ}/n)}",
            "centre distance from the radius of the pin's circle",
            ANY,
            centres_by_the_root,
        )
        .interpreted_as(
            "We take the pin radius as the radius of the pin's circle. If we take it as the radius of the pin itself \
             or of the wheel, the formula still does not hold for any number of slots.",
        )
        .corrected(
            r"C = \frac{R_{pin}}{\sin(180^{\circ}/n)}",
            slip(
                "The printed formula gives the length of the vector sum of two arms that are each as long as this \
                 radius and make an angle of 180°/n. But in a Geneva mechanism the two arms, crank and wheel radius, \
                 are at right angles, and they are equal only for four slots.",
                TWICE,
                "The formula puts the axes too far apart for three, four and five slots, and too close together for \
                 more. With four slots the distance should be 1.41 crank radii, but the formula gives 1.85, so the pin \
                 does not reach the slot.",
            ),
        )
        .in_places(3),
    ]
}

fn oxiphysics() -> Vec<Claim> {
    vec![
        formula(RIGID, "wild.oxiphysics.crank", r"r = d \sin(\pi/n)", "radius of the pin's circle", ANY, |fit| {
            vec![("r", fit.crank), ("d", fit.centres), ("n", fit.slots)]
        }),
        formula(
            RIGID,
            "wild.oxiphysics.rim",
            r"R = \sqrt{d^2 + r^2}",
            "outer radius of the wheel, for centre distance d and crank radius r",
            ANY,
            rim,
        )
        .interpreted_as(
            "The page explains the outer radius as the distance from the centre to the bottom of a slot. But the \
             bottom is d − r from the wheel's axis, so the formula is wrong for that distance as well.",
        )
        .corrected(
            r"R = \sqrt{d^2 - r^2}",
            slip(
                "In the triangle of the two axes and the pin, the right angle is at the pin, not at the driver's \
                 axis. So the centre distance is the longest side.",
                TWICE,
                "The formula makes the wheel's radius longer than the centre distance, so the wheel would cover the \
                 driver's axis. As a result, the depth of the slots that the same module computes is too large.",
            ),
        ),
        formula(
            CONSTRAINTS,
            "wild.oxiphysics.centres",
            r"a = \frac{r}{\sin(\pi/n)}",
            "centre distance, in another module of the library",
            ANY,
            |fit| vec![("a", fit.centres), ("r", fit.crank), ("n", fit.slots)],
        ),
    ]
}

fn right() -> Vec<Claim> {
    vec![
        formula(ANVILATE, "wild.anvilate.crank", r"r_{crank} = c \sin(\pi/n)", "crank radius", ANY, |fit| {
            vec![(r"r_{crank}", fit.crank), ("c", fit.centres), ("n", fit.slots)]
        }),
        formula(
            ANVILATE,
            "wild.anvilate.rim",
            r"r_{driven} = c \cos(\pi/n)",
            "radius at which the pin enters the slot",
            ANY,
            |fit| vec![(r"r_{driven}", fit.rim), ("c", fit.centres), ("n", fit.slots)],
        ),
        ANVILATE
            .statement(
                "wild.anvilate.equal",
                "at n = 4 equal, then the driven radius is larger",
                "how the wheel's radius compares with the crank radius",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| compared(stated, Fit::by_wheel))
            .second_route(Evidence::VECTORS, |stated| compared(stated, Fit::by_vectors))
            .but_not("then the driven radius is smaller"),
        formula(
            EDGE,
            "wild.engineers-edge.ratio",
            r"m = \frac{1}{\sin(180^{\circ}/n)}",
            "centre distance over crank radius",
            ANY,
            |fit| vec![("m", fit.centres / fit.crank), ("n", fit.slots)],
        ),
        formula(
            SIMULATOR,
            "wild.mechsimulator.rim",
            r"R = \frac{a}{\tan(\pi/n)}",
            "wheel radius from the crank radius",
            ANY,
            |fit| vec![("R", fit.rim), ("a", fit.crank), ("n", fit.slots)],
        ),
        formula(
            STYLE_SHEET,
            "wild.style-sheet.crank",
            r"r = C \sin(\pi/n)",
            "crank radius at which the pin enters along the slot",
            ANY,
            |fit| vec![("r", fit.crank), ("C", fit.centres), ("n", fit.slots)],
        ),
        formula(
            SDFX,
            "wild.sdfx.pin",
            r"p = \sqrt{d^2 + r^2 - 2 d r \cos\theta}",
            "distance of the pin from the driver's axis, for a wheel of any radius",
            ANY,
            |fit| vec![("p", fit.crank), ("d", fit.centres), ("r", fit.rim), (r"\theta", fit.step / 2.0)],
        )
        .interpreted_as("We take the radius that fits the centre distance. For other radii, see the example."),
    ]
}

/// Whether the two radii are equal for the number of slots that is said, and the wheel's is larger for more; or smaller.
fn compared(stated: Stated, by: fn(u32) -> Fit) -> Finding {
    let equal = stated.count();
    let difference = |slots: u32| (by(slots).rim - by(slots).crank) / by(slots).crank;
    let then = |slots: u32| stated.pick(1.0, -1.0) * difference(slots) > 1e-3;
    Finding::new(
        geneva_evidence::agreement::vanishes(difference(equal)) && ANY.filter(|slots| *slots > equal).all(then),
        format!(
            "with four slots they differ by {:.3} crank radii, with five by {:.3}",
            difference(4).abs(),
            difference(5)
        ),
    )
}

/// Programs that draw the parts.
fn generators() -> Vec<Claim> {
    vec![
        formula(
            MACRO,
            "wild.freecad.keep-crank",
            r"c = a/\sin(\pi/n)",
            "centre distance from the crank radius, in a comment of the program",
            ANY,
            |fit| vec![("c", fit.centres), ("a", fit.crank), ("n", fit.slots)],
        ),
        formula(
            MACRO,
            "wild.freecad.keep-rim",
            r"c = b/\cos(\pi/n)",
            "centre distance from the wheel's radius, in a comment of the program",
            ANY,
            |fit| vec![("c", fit.centres), ("b", fit.rim), ("n", fit.slots)],
        ),
        formula(
            WINDOW,
            "wild.freecad-window.centres",
            r"c = a/\sin(\pi/n)",
            "centre distance from the crank radius, in the version with a window",
            ANY,
            |fit| vec![("c", fit.centres), ("a", fit.crank), ("n", fit.slots)],
        ),
        formula(
            WINDOW,
            "wild.freecad-window.rim",
            r"b = \sqrt{c^2 - a^2}",
            "wheel radius, in the version with a window",
            ANY,
            |fit| vec![("b", fit.rim), ("c", fit.centres), ("a", fit.crank)],
        ),
        formula(
            OPENSCAD,
            "wild.openscad.centres",
            r"c = b/\cos(180^{\circ}/n)",
            "centre distance from the wheel's radius",
            ANY,
            |fit| vec![("c", fit.centres), ("b", fit.rim), ("n", fit.slots)],
        ),
        formula(OPENSCAD, "wild.openscad.crank", r"a = \sqrt{c^2 - b^2}", "crank radius", ANY, |fit| {
            vec![("a", fit.crank), ("c", fit.centres), ("b", fit.rim)]
        }),
        formula(WORKBENCH, "wild.gear-workbench.rim", r"b = \sqrt{c^2 - a^2}", "wheel radius", ANY, |fit| {
            vec![("b", fit.rim), ("c", fit.centres), ("a", fit.crank)]
        }),
        formula(
            GENEVA_GEN,
            "wild.geneva-gen.rim",
            r"b^2 = c^2 - a^2",
            "wheel radius from the crank radius, in the newest version that is stored, whereas an older version took \
             both radii as given",
            ANY,
            |fit| vec![("b", fit.rim), ("c", fit.centres), ("a", fit.crank)],
        ),
        formula(
            COSMO,
            "wild.cosmo.crank",
            r"a = c \sin(180^{\circ}/n)",
            "crank radius from the centre distance",
            ANY,
            |fit| vec![("a", fit.crank), ("c", fit.centres), ("n", fit.slots)],
        ),
        formula(
            COUNTER,
            "wild.counter.rim",
            r"R = \frac{r}{\tan(360^{\circ}/n/2)}",
            "wheel radius from the radius of the pin's circle",
            ANY,
            |fit| vec![("R", fit.rim), ("r", fit.crank), ("n", fit.slots)],
        ),
    ]
}

/// What is said of four slots only.
fn of_four() -> Vec<Claim> {
    vec![
        formula(
            DRIVE,
            "wild.firgelli-drive.centres",
            r"C = R \sqrt{2}",
            "centre distance of a wheel with four slots",
            4..=4,
            |fit| vec![("C", fit.centres), ("R", fit.crank)],
        ),
        formula(
            TINKERCAD,
            "wild.tinkercad.crank",
            r"r = c/\sqrt{2}",
            "radius at which the pin sits, four slots",
            4..=4,
            |fit| vec![("r", fit.crank), ("c", fit.centres)],
        ),
        formula(TINKERCAD, "wild.tinkercad.rim", r"R = c/\sqrt{2}", "wheel radius, four slots", 4..=4, |fit| {
            vec![("R", fit.rim), ("c", fit.centres)]
        }),
        COMPASS
            .statement(
                "wild.compass.bottom",
                "tangent to circle",
                "the slots of a four-slot wheel end on the circle about the wheel's axis that touches the pin's circle",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| bottom(&Fit::by_wheel(4), stated))
            .second_route(Evidence::VECTORS, |stated| bottom(&Fit::by_vectors(4), stated))
            .but_not("the slots end on the circle through the middle of the line of centres")
            .interpreted_as(
                "We take the end of a slot as the end of its centre line, which is the deepest place of the pin's \
                 centre.",
            ),
    ]
}

/// Whether the pin's deepest place is on the circle about the wheel's axis that touches the pin's circle; or on that
/// through the middle of the line of centres.
fn bottom(fit: &Fit, stated: Stated) -> Finding {
    let circle = stated.pick(fit.centres - fit.crank, fit.centres / 2.0);
    let how = format!(
        "the circle has a radius of {:.4} crank radii, and the end of the slot is at {:.4}",
        circle / fit.crank,
        fit.deepest / fit.crank
    );
    Finding::new(geneva_evidence::agreement::agrees(circle, fit.deepest), how)
}
