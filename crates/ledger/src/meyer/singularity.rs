//! Why a denominator is never zero, and what that does not say: the text between Eqs. (1-18) and (1-19).

use super::instants::moments;
use super::reading::{Letters, Moment};
use super::slips::NO_SINGULARITY;
use super::*;
use geneva_dynamics::existence::critical_friction;
use geneva_dynamics::singularity::{AtOne, BoundAsSquare, SingularAngle};
use geneva_dynamics::{Coefficients, Pose};
use geneva_kinematics::Mechanism;
use geneva_kinematics::escapement::pins_needed;
use nalgebra::Complex;
use std::sync::{LazyLock, OnceLock};

const FLAW: &str = "Line after Eq. (1-18)";
const END: Place = at("Paragraph before the substitutions of Eq. (1-19)");
/// Driver's inertia over the follower's, for the question how much friction there can be: a light driver, and like
/// discs.
const INERTIA_RATIOS: [f64; 2] = [0.1, 1.0];

pub fn claims() -> Vec<Claim> {
    [quantity(), bounds(), slots()].concat()
}

fn quantity() -> Vec<Claim> {
    vec![
        no_other_flaw(
            "meyer.possible-flaw",
            FLAW,
            "the equation of motion has one possible flaw, the denominator that is looked at",
            "one possible flaw",
            "two possible flaws, of which the other is A ≤ |D|",
        ),
        at("Display after Eq. (1-18)")
            .statement(
                "meyer.singularity.quantity",
                r"(1 + a^2 - 2a \cos \theta)",
                "the quantity whose powers Eq. (1-18) divides by: the square of the pin's distance from the follower's \
                 axis, over r²",
            )
            .by(Vectors, |stated| {
                let holds = moments().iter().all(|moment| {
                    agrees(
                        reading::value(quantity_with(stated), moment.letters()),
                        instants::letters_of(moment)("square"),
                    )
                });
                Finding::new(holds, "read and evaluated, against the pin's distance by coordinates")
            })
            .by(ClosedForm, |stated| {
                // A less the ratio of the inertias is the square of a cos θ − 1 over that of the quantity.
                let holds = Mechanism::ALL.iter().all(|mechanism| {
                    (-9..=9).all(|k| {
                        let angle = mechanism.engagement_half_angle() * f64::from(k) / 10.0;
                        let factors = factors(*mechanism, 1.0, angle, 0.0);
                        let letters = [("a", mechanism.centre_distance_ratio()), ("theta", angle)].map(named).into();
                        let divisor = reading::value(quantity_with(stated), &letters);
                        let above = reading::value(r"a \cos \theta - 1", &letters);
                        vanishes((factors.a - 1.0) * divisor * divisor - above * above)
                    })
                });
                Finding::new(holds, "the factor A of the equation of motion has its square below the line")
            })
            .but_not("the same with a plus before its last term"),
        at("1st display of θ_∞")
            .equation(
                "meyer.singularity.assumed",
                r"1 + a^2 - 2a \cos \theta_\infty = 0",
                "condition for an angle at which it would be zero",
            )
            .proven(SingularAngle)
            .read(ClosedForm, with_imaginary_angles),
        at("2nd display of θ_∞")
            .equation(
                "meyer.singularity.angle",
                r"\theta_\infty = \cos^{-1} \left(\frac{1 + a^2}{2a} \right)",
                "that angle",
            )
            .proven(SingularAngle)
            .read(ClosedForm, with_imaginary_angles),
    ]
}

/// The printed quantity, or its neighbour.
fn quantity_with(stated: Stated) -> &'static str {
    stated.pick(stated.characters(), r"(1 + a^2 + 2a \cos \theta)")
}

fn bounds() -> Vec<Claim> {
    vec![
        bound(
            "meyer.singularity.bound",
            "1st inequality",
            "a cosine is at most one",
            r"\left(\frac{1 + a^2}{2a} \right) \leq 1",
        ),
        bound("meyer.singularity.cleared", "2nd inequality", "the same times 2a", r"1 + a^2 \leq 2a"),
        bound("meyer.singularity.collected", "3rd inequality", "the same on one side", r"a^2 - 2a + 1 \leq 0"),
        bound("meyer.singularity.square", "4th inequality", "the same as a square", r"(a - 1)^2 \leq 0"),
        at("Line after the inequalities")
            .statement("meyer.singularity.only-one", "a = 1", "only the ratio one allows it")
            .by(ClosedForm, |stated| {
                let square = characters("meyer.singularity.square");
                let found: Vec<f64> = ratios().filter(|ratio| allows(square, *ratio) == Some(true)).collect();
                Finding::new(
                    found == [stated.pick(stated.number(), 2.0)],
                    format!("the last inequality holds for {found:?}"),
                )
            })
            .by(Vectors, |stated| {
                // How near the follower's axis a pin comes.
                let nearest = |ratio: &f64| {
                    let place = |k: u32| Turn::from_radians(2.0 * PI * f64::from(k) / 720.0).direction();
                    (0..720).map(|k| (place(k) - Vector2::new(*ratio, 0.0)).norm()).fold(f64::INFINITY, f64::min)
                };
                let found: Vec<f64> = ratios().filter(|ratio| vanishes(nearest(ratio))).collect();
                Finding::new(
                    found == [stated.pick(stated.number(), 2.0)],
                    format!("of 80 distances of the axes the pin comes onto the follower's axis at {found:?}"),
                )
            })
            .but_not("only the ratio two"),
    ]
}

fn slots() -> Vec<Claim> {
    vec![
        at("1st display before the substitutions of Eq. (1-19)")
            .equation("meyer.singularity.ratio", r"a = \frac{1}{\sin(\pi/n)} = 1", "the ratio one by Eq. (1-2)")
            .proven(AtOne)
            .read(ClosedForm, only_for_two),
        at("2nd display before the substitutions of Eq. (1-19)")
            .equation("meyer.singularity.sine", r"\sin\left(\frac{\pi}{n}\right) = 1", "the same for the sine")
            .proven(AtOne)
            .read(ClosedForm, only_for_two),
        END.statement("meyer.singularity.two-slots", "n=2", "only two slots would give it")
            .by(ClosedForm, |stated| {
                let found = slots_that_satisfy(characters("meyer.singularity.sine"));
                Finding::new(
                    found.as_deref() == Some(&[stated.pick(stated.count(), 3)]),
                    format!("read and evaluated for 1 to 100 slots, the sine is one for {found:?}"),
                )
            })
            .by(Vectors, |stated| {
                // A pin that enters along its slot, half the angle between two slots from the line of centres: how far
                // the follower's axis then is from the driver's.
                let distance = |slots: u32| {
                    let (sin, cos) = libm::sincos(PI / f64::from(slots));
                    // The right angle at the pin: R = r cot φ.
                    let pin = Vector2::new(cos, sin) * (cos / sin);
                    let to_driver = quarter_turn(&pin.normalize()) * -cos.signum();
                    (pin + to_driver).norm()
                };
                let found: Vec<u32> = (2..=100).filter(|slots| agrees(distance(*slots), 1.0)).collect();
                Finding::new(
                    found == [stated.pick(stated.count(), 3)],
                    format!("the axes are r apart for {found:?} slots"),
                )
            })
            .but_not("only three slots"),
        END.statement("meyer.singularity.ruled-out", "previously ruled out", "two slots are ruled out by Eq. (1-3)")
            .by(ClosedForm, |stated| {
                let right = right_side("meyer.eq-1-3");
                let letters = [named(("n", stated.pick(2.0, 4.0)))].into();
                let pins = reading::value(right, &letters);
                let ruled_out = !(pins.is_finite() && pins >= 1.0 && agrees(pins, pins.round()));
                Finding::new(ruled_out, format!("Eq. (1-3), read and evaluated, gives {pins} pins"))
            })
            .by(LimitCase, |stated| {
                let slots = stated.pick(2, 4);
                let fits = |pins: &u32| vanishes(PI / f64::from(*pins) + PI / f64::from(slots) - PI / 2.0);
                let found = (1..=1000).find(fits);
                Finding::new(
                    found.is_none() && pins_needed(slots).is_none(),
                    format!("of 1 to 1000 pins the angles at the hand-over make a right angle for {found:?}"),
                )
            })
            .but_not("four slots are"),
        END.statement(
            "meyer.singularity.conclusion",
            "contains no singularities",
            "the quantity that Eq. (1-18) divides by is zero nowhere",
        )
        .by(ClosedForm, |stated| {
            let of = |ratio: f64, angle: f64| 1.0 + ratio * ratio - 2.0 * ratio * libm::cos(angle);
            let least = Mechanism::ALL.map(|mechanism| {
                let ratio = stated.pick(mechanism.centre_distance_ratio(), 1.0);
                (-180..=180).map(|k| of(ratio, f64::from(k) * PI / 180.0)).fold(f64::INFINITY, f64::min)
            });
            Finding::new(
                least.iter().all(|least| !vanishes(*least)),
                format!("its least values for three, four and six slots are {least:.3?}"),
            )
        })
        .by(Vectors, |stated| {
            let nearest = Mechanism::ALL.map(|mechanism| {
                let axis = Vector2::new(stated.pick(mechanism.centre_distance_ratio(), 1.0), 0.0);
                let place = |k: u32| Turn::from_radians(2.0 * PI * f64::from(k) / 720.0).direction();
                (0..720).map(|k| (place(k) - axis).norm()).fold(f64::INFINITY, f64::min)
            });
            Finding::new(
                nearest.iter().all(|distance| !vanishes(*distance)),
                format!("a pin comes as near to the follower's axis as {nearest:.3?} radii"),
            )
        })
        .but_not("it is zero nowhere with the axes one radius of the pins apart, either")
        .read_as("A singularity as the paragraph has it: a zero of what is divided by."),
    ]
}

/// The place that has the equation of motion without a flaw but for one denominator.
fn no_other_flaw(
    id: &'static str,
    locator: &'static str,
    meaning: &'static str,
    printed: &'static str,
    corrected: &'static str,
) -> Claim {
    at(locator)
        .statement(id, printed, meaning)
        .by(ClosedForm, |stated| {
            // From rest, each sign of the friction tried out: which frictions leave one acceleration at all angles.
            static SINGLE: OnceLock<Vec<Vec<bool>>> = OnceLock::new();
            let limit = |mechanism: Mechanism, inertia: f64| {
                let quotients =
                    angles(mechanism).map(|at| factors(mechanism, inertia, at, 1.0)).map(|c| c.a / c.d.abs());
                quotients.fold(f64::INFINITY, f64::min)
            };
            let holds = below(SINGLE.get_or_init(|| single(consistent_signs)), |mechanism, inertia| {
                stated.pick(limit(mechanism, inertia), f64::INFINITY)
            });
            let bound = stated.pick("those below the least A/|D| of a friction of one", "all");
            Finding::new(
                holds,
                format!("of 40 frictions {bound} leave one acceleration from rest at each of 100 angles"),
            )
        })
        .by(LimitCase, |stated| {
            // The left side of Eq. (1-19) over the acceleration: how often it passes E.
            static SINGLE: OnceLock<Vec<Vec<bool>>> = OnceLock::new();
            let critical = |mechanism: Mechanism, inertia: f64| {
                critical_friction(mechanism, inertia).map_or(f64::NAN, |critical| critical.friction)
            };
            let holds = below(SINGLE.get_or_init(|| single(passages)), |mechanism, inertia| {
                stated.pick(critical(mechanism, inertia), f64::INFINITY)
            });
            Finding::new(holds, "how often the left side passes E was counted along 800 accelerations at 100 angles")
        })
        .corrected(corrected, NO_SINGULARITY)
}

/// One of the four inequalities; all are one statement.
fn bound(id: &'static str, locator: &'static str, meaning: &'static str, printed: &'static str) -> Claim {
    at(locator).equation(id, printed, meaning).proven(BoundAsSquare).read(ClosedForm, only_for_one)
}

fn named((name, value): (&str, f64)) -> (String, f64) {
    (name.to_owned(), value)
}

/// Ratios of the axes' distance to the pins' radius, from 1/16 to 5.
fn ratios() -> impl Iterator<Item = f64> {
    (1..=80).map(|k| f64::from(k) / 16.0)
}

/// Whether an inequality allows a ratio; none if it cannot be read.
fn allows(inequality: &str, ratio: f64) -> Option<bool> {
    let letters: Letters = [named(("a", ratio))].into();
    let sides = |relation: &str| {
        let (left, right) = inequality.split_once(relation)?;
        let values = [left, right].map(|side| reading::value(side, &letters));
        values.iter().all(|value| value.is_finite()).then_some(values)
    };
    match (sides(r"\leq"), sides(r"\geq")) {
        (Some([left, right]), _) => Some(left <= right),
        (_, Some([left, right])) => Some(left >= right),
        _ => None,
    }
}

/// Whether an inequality allows the ratio one and no other.
fn only_for_one(inequality: &str) -> Option<bool> {
    let allowed: Vec<bool> = ratios().map(|ratio| allows(inequality, ratio)).collect::<Option<_>>()?;
    Some(ratios().zip(allowed).all(|(ratio, allowed)| allowed == (ratio == 1.0)))
}

/// Whether a display of θ_∞ holds. The cosine of that angle is greater than one unless a = 1, so it is imaginary.
fn with_imaginary_angles(tex: &str) -> Option<bool> {
    let moments = [1.0, 1.25, 1.5, 2.0, 3.5].map(|ratio: f64| {
        // cosh(ln a) = (a + 1/a)/2.
        let letters = [("a", Complex::new(ratio, 0.0)), ("theta_infty", Complex::new(0.0, libm::log(ratio)))];
        Moment::of(letters.map(|(name, value)| (name.to_owned(), value)).into())
    });
    reading::holds(tex, &moments)
}

/// For which numbers of slots, of 1 to 100, a display holds if the ratio is one; none if it cannot be read.
fn slots_that_satisfy(display: &str) -> Option<Vec<u32>> {
    let holds = |slots: u32| {
        let letters = [("a", 1.0), ("n", f64::from(slots))].map(named).into();
        reading::holds(display, &[Moment::of(letters)])
    };
    let found: Vec<(u32, bool)> = (1..=100).map(|slots| Some((slots, holds(slots)?))).collect::<Option<_>>()?;
    Some(found.into_iter().filter(|(_, holds)| *holds).map(|(slots, _)| slots).collect())
}

/// Whether a display holds for two slots and for no other number, if the ratio is one.
fn only_for_two(display: &str) -> Option<bool> {
    slots_that_satisfy(display).map(|found| found == [2])
}

/// The factors of the equation of motion for a torque of one.
fn factors(mechanism: Mechanism, inertia: f64, angle: f64, friction: f64) -> Coefficients<f64> {
    let pose = Pose::new(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle));
    Coefficients::of_pose(&pose, &inertia, &friction, &1.0)
}

fn angles(mechanism: Mechanism) -> impl Iterator<Item = f64> {
    (0..100).map(move |k| mechanism.engagement_half_angle() * f64::from(k) / 100.0)
}

/// Frictions from below any limit to above it.
fn frictions() -> impl Iterator<Item = f64> {
    (1..=40).map(|k| f64::from(k) * 0.153)
}

/// Each mechanism with each ratio of the inertias.
fn mechanisms() -> impl Iterator<Item = (Mechanism, f64)> {
    Mechanism::ALL.into_iter().flat_map(|mechanism| INERTIA_RATIOS.map(|inertia| (mechanism, inertia)))
}

/// For each of them and each friction, whether a way of counting the accelerations from rest finds one at all angles.
fn single(count: fn(&Coefficients<f64>) -> usize) -> Vec<Vec<bool>> {
    let of = |(mechanism, inertia): (Mechanism, f64)| {
        let one = |friction: f64| angles(mechanism).all(|at| count(&factors(mechanism, inertia, at, friction)) == 1);
        frictions().map(one).collect()
    };
    mechanisms().map(of).collect()
}

/// Whether there is a single acceleration below this friction of a mechanism and not above it.
fn below(single: &[Vec<bool>], bound: impl Fn(Mechanism, f64) -> f64) -> bool {
    mechanisms().zip(single).all(|((mechanism, inertia), single)| {
        let bound = bound(mechanism, inertia);
        frictions().zip(single).all(|(friction, single)| *single == (friction < bound))
    })
}

/// How many accelerations from rest obey the equation with the sign that their own friction has.
fn consistent_signs(c: &Coefficients<f64>) -> usize {
    let obeys = |sign: f64| {
        let angular_acceleration = c.e / (c.a + sign * c.d);
        sign * c.d * angular_acceleration > 0.0
    };
    if c.d == 0.0 { 1 } else { [1.0, -1.0].iter().filter(|sign| obeys(**sign)).count() }
}

/// How often the left side of the equation from rest passes E, along accelerations of either sign from 10⁻⁸ to 10⁸.
fn passages(c: &Coefficients<f64>) -> usize {
    let excess = |angular_acceleration: f64| c.a * angular_acceleration + (c.d * angular_acceleration).abs() > c.e;
    static FORWARDS: LazyLock<Vec<f64>> =
        LazyLock::new(|| (-200..=200).map(|k| libm::pow(10.0, f64::from(k) / 25.0)).collect());
    let one_way = |way: f64| {
        let mut above = FORWARDS.iter().map(|angular_acceleration| excess(way * angular_acceleration));
        let mut before = above.next();
        above.filter(|now| before.replace(*now) != Some(*now)).count()
    };
    one_way(1.0) + one_way(-1.0)
}
