//! The parameters of the study, and the estimate of the inertias: two steel discs.

use super::instants::statement;
use super::*;
use crate::Dimension as Exponents;
use geneva_kinematics::escapement::pins_needed;

const PARAMETERS: &str = "Chapter II, paragraph after the list of parameters";
const FORMULA: &str = "Chapter II, 1st display of I";
const NUMBERS: &str = "Chapter II, 2nd display of I";

/// The estimate with its numbers.
const AS_PRINTED: &str = r"I = \frac{1}{2} \pi \left(\frac{.283 \text{ lb/in}}{386 \text{ in/sec}^2} \right) \left(\frac{0.5 \text{ in}}{2} \right)^4 (0.1 \text{ in})";
/// The same with the unit put right.
const PUT_RIGHT: &str = r"I = \frac{1}{2} \pi \left(\frac{.283 \text{ lb/in}^3}{386 \text{ in/sec}^2} \right) \left(\frac{0.5 \text{ in}}{2} \right)^4 (0.1 \text{ in})";

/// The inch in metres, the pound in kilograms and the pound-force in newtons, by definition.
const INCH: f64 = 0.0254;
const POUND: f64 = 0.453_592_37;
const POUND_FORCE: f64 = 4.448_221_615_260_5;

pub fn claims() -> Vec<Claim> {
    [parameters(), estimate()].concat()
}

fn parameters() -> Vec<Claim> {
    vec![
        statement(
            "meyer.one-geometric-parameter",
            PARAMETERS,
            "the number of slots and the angle of entry depend on each other: one \
                    parameter, the only one of the geometry",
            "n and θ_0, are not independent",
            (LimitCase, || {
                for_each(
                    |at| {
                        let (slots, pins) = (f64::from(at.slots()), pins_needed(at.slots()));
                        let found = pins.map_or(f64::NAN, |pins| pins.approximate());
                        agrees(at.driver_half_angle(), PI / found)
                            && agrees(at.driver_half_angle(), PI / 2.0 - PI / slots)
                    },
                    "Eq. (1-3) gives the angle from the number of slots",
                )
            }),
            (Vectors, || {
                exactly(|at| is_zero(&at.leaving.across), "at that angle the leaving pin moves along its slot")
            }),
        ),
        statement(
            "meyer.four-parameters",
            PARAMETERS,
            "for each of the three mechanisms four parameters are left: friction, torque and two inertias",
            "four parameters",
            (Dimension, || {
                // Letters of Eq. (1-18): a follows from n, θ and its rates are the motion.
                let left = ["I_D", "I_f", "mu", "K"];
                let [first, second] = ["first", "second"].map(|line| {
                    claim(&format!("meyer.eq-1-18.{line}-line")).map_or("", |claim| claim.printed).to_owned()
                });
                let all = format!("{first} {second}");
                Finding::new(
                    left.iter().all(|letter| all.contains(letter)),
                    "Eq. (1-18) has four letters beside a and θ",
                )
            }),
            (OtherPlaceInSource, || {
                let others = numbers("meyer.listing.parameters");
                Finding::new(
                    !others.is_empty(),
                    "the program reads six parameters, two of them the number of slots and \
                        the angle",
                )
            }),
        ),
        statement(
            "meyer.steel",
            PARAMETERS,
            "weight of a cubic inch of steel in pounds",
            ".283 lb/in",
            (ClosedForm, || {
                let density = steel() * POUND / (INCH * INCH * INCH);
                let steels = 7700.0..8100.0;
                Finding::new(steels.contains(&density), format!("{density:.0} kg/m³; steels have 7700 to 8100"))
            }),
            (OtherPlaceInSource, || {
                let used = data().map(|data| data.density);
                Finding::new(used == Some(steel()), "the numbers of the estimate have it again")
            }),
        ),
        Claim::statement(
            WORK,
            "meyer.like-discs",
            PARAMETERS,
            "driver and follower of each mechanism are discs of about one size",
            "both taken to be approximately 0.5 inch in diameter and 0.1 inch in thickness",
            Check::corrected_equation(
                (Vectors, || {
                    let sizes: Vec<f64> = Escapement::all().iter().map(rim_at_entry).collect();
                    let holds = sizes.iter().all(|size| (size - 1.0).abs() < 0.1);
                    Finding::new(
                        holds,
                        format!("follower over driver: {:.2}, {:.2}, {:.2}", sizes[0], sizes[1], sizes[2]),
                    )
                }),
                || {
                    let holds = Escapement::all().iter().all(|at| agrees(rim_at_entry(at), at.rim_radius()));
                    let like = Escapement::all().iter().filter(|at| agrees(at.rim_radius(), 1.0)).count();
                    Finding::new(holds && like == 1, "of the radii cot(π/n) one is that of the driver, for four slots")
                },
                (OtherPlaceInSource, || {
                    let ids = ["three", "four", "six"].map(|n| format!("meyer.app-a.{n}-slots.radius"));
                    let radii = ids.each_ref().map(|id| printed(id));
                    Finding::new(
                        radii[1] == 1.0 && radii[0] < 0.6 && radii[2] > 1.7,
                        format!("Appendix A has {}, {} and {} for the follower's radius", radii[0], radii[1], radii[2]),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "the driver approximately 0.5 inch in diameter and the follower cot(π/n) \
                    times as large: 0.29, 0.5 and 0.87 inch for three, four and six slots, \
                    and both 0.1 inch in thickness",
            slip: Slip {
                id: "",
                reason: "The sizes of driver and follower are bound by the geometry. They are \
                    alike for four slots only. As the moment of inertia grows with the \
                    fourth power of the radius, that of the follower is 1/9 of the driver's \
                    for three slots and 9 times the driver's for six.",
                witness: "Appendix A computes the radii of the followers.",
                origin: Origin::Concept,
                consequence: Consequence::Conclusion,
                changes: "",
            },
        }),
    ]
}

fn estimate() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "meyer.disc",
            FORMULA,
            "moment of inertia of a disc about its axis, by density, radius and thickness",
            r"I = \frac{1}{2} \pi m r^4 t",
            Check::equation(
                (ClosedForm, || {
                    // Rings of a disc: their mass times the square of their radius, by Simpson's rule, exact for cubes.
                    let (density, radius, thickness) = (1.5, 0.75, 0.25);
                    let ring = |at: f64| density * thickness * 2.0 * PI * at * at * at;
                    let sum = radius / 6.0 * (ring(0.0) + 4.0 * ring(radius / 2.0) + ring(radius));
                    let letters =
                        [("m", density), ("r", radius), ("t", thickness)].map(|(n, v)| (n.to_owned(), v)).into();
                    same(reading::value(right_side("meyer.disc"), &letters), sum)
                }),
                (Dimension, || {
                    let density = mass() / volume(3);
                    let found = density * volume(4) * Exponents::LENGTH;
                    Finding::new(found == mass() * volume(2), format!("density times length to the fifth is {found}"))
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "meyer.letter-m",
            FORMULA,
            "the letter of the mass density",
            "m is the mass density",
            Check::corrected_equation(
                (OtherPlaceInSource, || {
                    let pins = claim("meyer.eq-1-3").is_some_and(|claim| claim.printed.contains('m'));
                    Finding::new(!pins, "m is the number of pins in Eq. (1-3)")
                }),
                || {
                    let ours: Vec<_> = SYMBOLS.iter().filter(|symbol| symbol.printed == "m").map(|s| s.ours).collect();
                    Finding::new(
                        ours.len() == 3,
                        "pins, density and, in Appendix B, mass have three letters in this book",
                    )
                },
                (Dimension, || {
                    let density = mass() / volume(3);
                    Finding::new(
                        density != Exponents::NONE,
                        format!("a number of pins has no unit, a density is {density}"),
                    )
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "ρ is the mass density",
            slip: Slip {
                id: "",
                reason: "The letter m is the number of pins in chapter I, and a mass in Appendix B.",
                witness: "A number of pins has no unit.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        Claim::equation(
            WORK,
            "meyer.disc.numbers",
            NUMBERS,
            "the same with the numbers; a weight per volume over the acceleration of \
                    gravity is a mass density",
            AS_PRINTED,
            Check::corrected_equation(
                (Dimension, || unit_of_the_estimate(1)),
                || unit_of_the_estimate(3),
                (OtherPlaceInSource, || {
                    let same = data().is_some_and(|data| data.density == steel());
                    Finding::new(same, "the paragraph before has the number, in pounds per cubic inch")
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: PUT_RIGHT,
            slip: Slip {
                id: "",
                reason: "The weight is that of a cubic inch. Only so the unit of the result is \
                    that which is printed with it.",
                witness: "The paragraph before the display has the same number in pounds per cubic inch.",
                origin: Origin::Copy,
                consequence: Consequence::Copy,
                changes: "",
            },
        }),
        Claim::statement(
            WORK,
            "meyer.gravity",
            NUMBERS,
            "acceleration of gravity in inches per second squared",
            "386 in/sec",
            Check::equation(
                (ClosedForm, || {
                    let gravity = POUND_FORCE / POUND / INCH;
                    let said = data().map_or(f64::NAN, |data| data.gravity);
                    Finding::new((said - gravity).abs() <= 0.5, format!("the standard value is {gravity:.2}"))
                }),
                (LimitCase, || {
                    // A pound falls so: 9.80665 m/s² by definition.
                    let gravity = 9.806_65 / INCH;
                    let said = data().map_or(f64::NAN, |data| data.gravity);
                    Finding::new(
                        gravity > said - 0.5 && gravity < said + 0.5,
                        format!("{gravity:.2} by its definition"),
                    )
                }),
            ),
        ),
        Claim::value(
            WORK,
            "meyer.disc.inertia",
            "Chapter II, 3rd display of I",
            "moment of inertia of either disc",
            ("0.5", r"\times 10^{-6} \text{ in lb sec}^{2}"),
            Check::number(
                (ClosedForm, || {
                    data().map_or(f64::NAN, |data| {
                        let radius = data.diameter / 2.0;
                        1e6 * PI / 2.0 * data.density / data.gravity
                            * radius
                            * radius
                            * radius
                            * radius
                            * data.thickness
                    })
                }),
                (LimitCase, || {
                    // A disc is a ring without a hole: half its mass times the square of its radius.
                    data().map_or(f64::NAN, |data| {
                        let weight = data.density * data.thickness * PI * data.diameter * data.diameter / 4.0;
                        1e6 * weight / data.gravity * data.diameter * data.diameter / 8.0
                    })
                }),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "0.45",
            slip: Slip {
                id: "",
                reason: "The numbers give 0.450, a tenth less than printed: it was rounded to \
                    0.45 and then once more.",
                witness: "The mass of the disc times the square of its radius, halved, gives the same.",
                origin: Origin::Arithmetic,
                consequence: Consequence::Result,
                changes: "",
            },
        }),
    ]
}

/// The numbers of the estimate, from the display that has them all.
struct Data {
    density: f64,
    gravity: f64,
    diameter: f64,
    thickness: f64,
}

fn data() -> Option<Data> {
    let tokens = numeric_tokens(claim("meyer.disc.numbers")?.printed);
    let number = |at: usize| tokens.get(at)?.parse::<f64>().ok();
    // The first number stands behind a bare point: three digits of it.
    Some(Data { density: number(2)? / 1000.0, gravity: number(3)?, diameter: number(5)?, thickness: number(8)? })
}

/// The number of the paragraph before the estimate; it begins with its point.
fn steel() -> f64 {
    let text = claim("meyer.steel").map_or("", |claim| claim.printed);
    text.split(' ').next().and_then(|number| number.parse().ok()).unwrap_or(f64::NAN)
}

fn right_side(id: &str) -> &'static str {
    claim(id).and_then(|claim| claim.printed.split_once('=')).map_or("", |(_, right)| right)
}

/// Radius of the follower's rim over that of the pins' circle: where the pin is as it enters.
fn rim_at_entry(escapement: &Escapement) -> f64 {
    Seen::new(escapement, -escapement.driver_half_angle()).radius()
}

fn volume(power: u32) -> Exponents {
    (0..power).fold(Exponents::NONE, |product, _| product * Exponents::LENGTH)
}

/// A force over an acceleration.
fn mass() -> Exponents {
    Exponents::FORCE * Exponents::TIME * Exponents::TIME / Exponents::LENGTH
}

/// Whether the estimate has the unit of its result if the weight is per so many inches multiplied.
fn unit_of_the_estimate(inches: u32) -> Finding {
    let density = Exponents::FORCE / volume(inches) / (Exponents::LENGTH / Exponents::TIME / Exponents::TIME);
    let found = density * volume(4) * Exponents::LENGTH;
    let wanted = Exponents::FORCE * Exponents::LENGTH * Exponents::TIME * Exponents::TIME;
    Finding::new(found == wanted, format!("the unit is {found}; printed with the result is {wanted}"))
}
