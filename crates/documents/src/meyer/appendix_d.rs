//! Appendix D: the acceleration at the start.

use super::appendix_b::{holds_from_rest, start_formula, start_line, start_solves};
use super::hand_over::Drawn;
use super::instants::equal;
use super::letters::start;
use super::reading::Moment;
use super::slips::LOST_DOTS;
use super::*;
use geneva_dynamics::{Coefficients, Pose};
use geneva_evidence::agreement::joined;
use geneva_evidence::numbers_in;
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

const LETTERS: Locator = at("Appendix D, line after the 1st equation");
/// A speed at which the driver is slowed down somewhere.
const FAST: f64 = 3.0;

const SIGN: Locator = at("Appendix D, lines after the 2nd equation");

pub(super) fn claims() -> Vec<Claim> {
    [vec![needed()], given(), equations()].concat()
}

fn needed() -> Claim {
    at("Appendix D, 1st paragraph")
        .statement(
            "meyer.app-d.needed",
            "requires a value for the second derivative",
            "without a separate line for the start, the program would have no first acceleration",
        )
        .missing(
            "The thesis does not say what the delay returns while there is no earlier value. If the delay gives nothing, the term \
             F, from which the friction takes its sign, cannot be computed at the start, so a first acceleration must \
             be given. If the delay gives zero, no separate line is needed: the line that computes the acceleration \
             gives the same first value by itself. The sign makes no difference at the start: a pin enters along its \
             slot, so from rest it does not yet press on the slot, and there is no friction",
        )
}

fn given() -> Vec<Claim> {
    vec![
        at("Appendix D, 1st display")
            .statement("meyer.app-d.from-rest", r"\dot{\theta}_0 = 0", "the driver starts from rest")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let said = MEYER.printed_integers("meyer.app-b.from-rest");
                let own = stated.number() + stated.pick(0.0, 1.0);
                Finding::new(
                    said.first().is_some_and(|said| f64::from(*said) == own),
                    format!("after the program, Appendix B gives the speed {}", joined(said)),
                )
            })
            .second_route(Evidence::CLOSED_FORM, |stated| start_solves(stated.number() + stated.pick(0.0, 1.0)))
            .but_not("it starts at a speed of one"),
        at("Appendix D, 2nd display")
            .statement(
                "meyer.app-d.angles",
                r"\theta_0 = -30^\circ, -45^\circ, -60^\circ",
                "driver's angle at the start for six, four and three pins",
            )
            .first_route(Evidence::LIMIT_CASE, before_the_line)
            .second_route(Evidence::VECTORS, coming_in)
            .but_not(WITHOUT_THE_MINUS),
        at("Appendix D, line after the 2nd display")
            .statement(
                "meyer.app-d.order",
                "three, four, or six pins",
                "the angle at the start depends on which of the three mechanisms it is",
            )
            .first_route(Evidence::LIMIT_CASE, |stated| {
                let mut angles: Vec<f64> = said_pins(stated).iter().map(|pins| 180.0 / pins).collect();
                angles.sort_by(f64::total_cmp);
                let mut said: Vec<f64> = start_angles("meyer.app-d.angles").collect();
                said.sort_by(f64::total_cmp);
                Finding::new(angles == said, format!("180° over the number of pins is {}°", joined(&angles)))
            })
            .second_route(Evidence::VECTORS, |stated| {
                let angles: Vec<f64> = said_pins(stated).iter().map(|pins| PI / pins).collect();
                // Each number of pins has an escapement whose pin enters at its own angle along the slot.
                let holds = angles.iter().all(|angle| {
                    Mechanism::ALL
                        .iter()
                        .filter(|at| vanishes(PinKinematics::new(at, -angle).angular_velocity()))
                        .count()
                        == 1
                });
                Finding::new(holds, "at each angle, the pin moves along its slot in one of the three escapements")
            })
            .but_not("three, four, or five pins")
            .interpreted_as(
                "We take the angles in no particular order, because the sentence does not say which angle belongs to \
                 which number of pins.",
            ),
    ]
}

/// The numbers of pins that are said, or the last of them less one.
fn said_pins(stated: Stated) -> Vec<f64> {
    let mut said = stated.numbers();
    if let Some(last) = said.last_mut() {
        *last -= stated.pick(0.0, 1.0);
    }
    said
}

/// The neighbour of a place that gives the three angles.
pub(super) const OTHER_ANGLE: &str = "36°, the angle of five pins, for 45°";

/// The angles that a claim gives, in degrees.
fn said_angles(stated: Stated) -> Vec<f64> {
    let said = stated.numbers().into_iter().filter(|angle| *angle > 0.0);
    said.map(|angle| if angle == 45.0 { stated.pick(45.0, 36.0) } else { angle }).collect()
}

/// Whether the angles of a claim are half the angle between two pins, for six, four and three of them.
pub(super) fn of_the_pins(stated: Stated) -> Finding {
    let said = said_angles(stated);
    let angles: Vec<f64> = Mechanism::ALL.iter().map(|at| 180.0 / f64::from(at.pins())).collect();
    Finding::new(said == angles, format!("180° over the number of pins is {}°", joined(&angles)))
}

/// The neighbour of a place that gives the three angles of the start.
pub(super) const WITHOUT_THE_MINUS: &str = "the same angles without the minus";

/// The angles of the start that a claim gives, in degrees, with their signs, or with the others.
fn said_starts(stated: Stated) -> Vec<f64> {
    let text = stated.characters();
    let signed = |(at, angle): (std::ops::Range<usize>, f64)| {
        let is_negative = text[..at.start].ends_with('-');
        stated.pick(angle, -angle) * if is_negative { -1.0 } else { 1.0 }
    };
    numbers_in(text).into_iter().filter(|(_, angle)| *angle > 0.0).map(signed).collect()
}

/// Whether the angles of a claim are half the angle between two pins, before the line of centres, for six, four and three
/// of them.
pub(super) fn before_the_line(stated: Stated) -> Finding {
    let said = said_starts(stated);
    let angles: Vec<f64> = Mechanism::ALL.iter().map(|at| -180.0 / f64::from(at.pins())).collect();
    Finding::new(
        said == angles,
        format!(
            "180° over the number of pins, counted negative before the line of centres, gives {}°",
            joined(&angles)
        ),
    )
}

/// Whether at these angles a pin moves along its slot towards the follower's axis, at each in another of the escapements.
pub(super) fn coming_in(stated: Stated) -> Finding {
    let said = said_starts(stated);
    let comes_in = |(at, angle): (&Mechanism, &f64)| {
        let drawn = Drawn::new(at.pins(), at.slots());
        let [place, velocity] = [drawn.place(angle.to_radians()), Drawn::velocity(angle.to_radians())];
        vanishes(place.perp(&velocity)) && place.dot(&velocity) < 0.0
    };
    let count = Mechanism::ALL.iter().zip(&said).filter(|pair| comes_in(*pair)).count();
    Finding::new(
        count == 3 && said.len() == 3,
        format!("at {} degrees the pin enters along its slot in {count} of 3 escapements", joined(&said)),
    )
}

/// Whether a pin moves along its slot at these angles, at each in another of the escapements.
pub(super) fn along_the_slots(stated: Stated) -> Finding {
    let said = said_angles(stated);
    let still = Mechanism::ALL.iter().zip(&said).all(|(at, angle)| {
        [1.0, -1.0].iter().all(|side| vanishes(PinKinematics::new(at, side * angle.to_radians()).angular_velocity()))
    });
    Finding::new(
        still && said.len() == 3,
        format!("we asked whether the pin moves along its slot at {} degrees", joined(&said)),
    )
}

fn equations() -> Vec<Claim> {
    vec![
        starting(
            ("meyer.app-d.at-rest", "Appendix D, 1st equation"),
            "Eq. (1-19) at rest",
            r"A\ddot{\theta} + |D\dot{\theta}| = E",
            r"A\ddot{\theta} + |D\ddot{\theta}| = E",
        ),
        LETTERS
            .statement(
                "meyer.app-d.letters",
                "V be the value of D",
                "at the start R is A and V is D (in the program, the size of D); D is zero there, because a pin \
                 enters where a cos θ = 1",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // At every angle, as D vanishes at the start itself.
                let holds = poses().all(|(at, c)| {
                    let [r, v] = ["R", "V"].map(|name| start_line(name, &at));
                    agrees(r, c.a) && vanishes(v - stated.pick(c.d, c.c).abs())
                });
                Finding::new(
                    holds,
                    "we compared the program's lines of R and V with the factors of the equation of motion",
                )
            })
            .second_route(Evidence::VECTORS, |stated| {
                at_instants(|seen| {
                    // What friction takes of the torque with the acceleration, and with the square of the speed.
                    const FRICTION: f64 = 0.25;
                    let (speed, angular_acceleration) = DRIVER;
                    let times_acceleration = seen.angular_velocity() / speed;
                    let with_the_square =
                        (seen.angular_acceleration() - times_acceleration * angular_acceleration) / (speed * speed);
                    let sliding = seen.place.normalize().dot(&seen.velocity) / speed;
                    let said = FRICTION * stated.pick(times_acceleration, with_the_square) / seen.radius() * sliding;
                    let angle = libm::atan2(seen.crank.sin, seen.crank.cos);
                    let cards = [("G", seen.ratio), ("X0", angle), ("U", FRICTION), ("IC", 1.0), ("IW", 1.0)];
                    let letters = reading::by_name(cards);
                    (start_line("V", &letters), said.abs())
                })
            })
            .but_not("V is the value of C there"),
        LETTERS
            .statement("meyer.app-d.constant", "constant of the motion", "E is the same at all angles")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let holds = Mechanism::ALL.iter().all(|mechanism| {
                    let own: Vec<f64> = of_slots(*mechanism).map(|(_, c)| stated.pick(c.e, c.a)).collect();
                    own.iter().all(|factor| agrees(*factor, own[0]))
                });
                Finding::new(holds, "we evaluated the factor over the whole engagement of each mechanism")
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let line = stated.pick("meyer.factor-e", "meyer.factor-a");
                let right = MEYER.lookup(line).right_characters().split_once('=').map_or("", |(_, right)| right);
                let at = |angle: f64| {
                    let letters = [("a", 2.0), ("theta", angle), ("I_D", 1.0), ("I_f", 2.0), ("K", 1.5)];
                    reading::value(right, &reading::by_name(letters))
                };
                let holds = (0..=9).all(|k| agrees(at(f64::from(k) / 9.0), at(0.0)));
                Finding::new(holds, "we read and evaluated the substitution before Eq. (1-19) at ten angles")
            })
            .but_not("A is the same at all angles too"),
        starting(
            ("meyer.app-d.with-letters", "Appendix D, 2nd equation"),
            "Eq. (1-19) at rest, with the letters of the start",
            r"R\ddot{\theta} + |V\dot{\theta}| = E",
            r"R\ddot{\theta} + |V\ddot{\theta}| = E",
        ),
        SIGN.statement(
            "meyer.app-d.forwards",
            "must always be positive",
            "the driver starts in the direction of the torque",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            let speed = stated.pick(0.0, FAST);
            let holds = poses().all(|(_, c)| c.acceleration(speed).is_ok_and(|found| found.value > 0.0));
            Finding::new(holds, format!("we computed the acceleration at the speed {speed} in 63 positions"))
        })
        .second_route(Evidence::LIMIT_CASE, |stated| {
            // The left side, along positive accelerations: does it come from below E to E?
            let square = stated.pick(0.0, FAST * FAST);
            let reaches = |c: &Coefficients<f64>| {
                let left = |angular_acceleration: f64| {
                    c.a * angular_acceleration + c.b * square + (c.c * square + c.d * angular_acceleration).abs()
                };
                let powers = (0..=600).map(|k| libm::pow(10.0, f64::from(k) / 100.0 - 3.0));
                left(0.0) < c.e && powers.into_iter().any(|angular_acceleration| left(angular_acceleration) >= c.e)
            };
            Finding::new(
                poses().all(|(_, c)| reaches(&c)),
                "we followed the left side of the equation over positive accelerations",
            )
        })
        .but_not("the driver always keeps accelerating in that direction, however fast it turns")
        .interpreted_as(
            "We take the start with less friction than the critical value, so that A > |D|, or with any friction, \
             because D is zero there.",
        ),
        starting(
            ("meyer.app-d.outside", "Appendix D, 3rd equation"),
            "the equation at rest, with the letters of the start and the acceleration outside the bars",
            r"R\ddot{\theta} + |V|\dot{\theta} = E",
            r"R\ddot{\theta} + |V|\ddot{\theta} = E",
        ),
        at("Appendix D, 4th equation")
            .equation(
                "meyer.app-d.acceleration",
                r"\ddot{\theta}_0 = \frac{E}{R + |V|}",
                "the acceleration at the start, which with V = 0 is K over the driver's inertia",
            )
            .proven_by(start)
            .read(Evidence::CLOSED_FORM, from_rest),
        at("Appendix D, line after the 4th equation")
            .statement(
                "meyer.app-d.program-form",
                "of the form to be used in the computer program",
                "the program's line for the first acceleration is this equation, with the bars already in V",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // Any numbers at all: the two must be the same formula.
                let holds = (1..=20_u32).all(|k| {
                    let number = |factor: f64| libm::sin(factor * f64::from(k)) * 3.0;
                    let (size, letters) = (number(3.0).abs(), [("E", number(1.0)), ("R", number(2.0) + 4.0)]);
                    let with = |v: f64| reading::by_name(letters.into_iter().chain([("V", v)]));
                    let line = reading::value(start_formula(), &with(stated.pick(size, 0.0)));
                    agrees(line, reading::value(MEYER.right_side("meyer.app-d.acceleration"), &with(number(3.0))))
                });
                Finding::new(holds, "we read both formulas and evaluated them for 20 sets of numbers")
            })
            .second_route(Evidence::VECTORS, |stated| {
                let line = start_formula().replace('V', stated.pick("V", "0"));
                let holds = holds_from_rest(&format!(r"\text{{2DX}} = {line}"));
                Finding::new(
                    holds == Some(true),
                    "we compared the program's line with the torque that both members require from rest",
                )
            })
            .but_not("the program's line is this equation without V"),
        at("Appendix D, last sentence")
            .statement(
                "meyer.app-d.always-positive",
                "in the direction of the torque K",
                "R is positive, so the first acceleration is in the direction of the torque",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let holds = poses().all(|(_, c)| stated.pick(c.a, c.d) > 0.0);
                Finding::new(holds, "we computed the factor in 63 positions")
            })
            .second_route(Evidence::VECTORS, |stated| {
                equal(
                    |letter| {
                        let factor = letter(stated.pick("A", "D"));
                        (factor.abs(), factor)
                    },
                    "the size of the factor by Newton's laws and the factor itself",
                )
            })
            .but_not("V, without bars, is always positive too"),
    ]
}

/// A display that has one dot for two.
fn starting(
    (id, locator): (&'static str, &'static str),
    meaning: &'static str,
    printed: &'static str,
    corrected: &'static str,
) -> Claim {
    at(locator)
        .equation(id, printed, meaning)
        .proven_by(start)
        .read(Evidence::CLOSED_FORM, from_rest)
        .corrected(corrected, LOST_DOTS)
}

/// Coefficients all over the engagements, for some friction, with the letters of the program's start.
fn poses() -> impl Iterator<Item = (reading::Letters, Coefficients<f64>)> {
    Mechanism::ALL.into_iter().flat_map(of_slots)
}

fn of_slots(mechanism: Mechanism) -> impl Iterator<Item = (reading::Letters, Coefficients<f64>)> {
    (-10..=10).map(move |k| {
        let [driver, follower, friction, torque] = [1.5, 2.0, 0.25, 3.0];
        let angle = mechanism.engagement_half_angle() * f64::from(k) / 10.0;
        let pose = Pose::new(&mechanism.centre_distance_ratio(), &Turn::from_radians(angle));
        let cards = [
            ("G", mechanism.centre_distance_ratio()),
            ("X0", angle),
            ("U", friction),
            ("IC", driver),
            ("IW", follower),
        ];
        let letters = reading::by_name(cards);
        (letters, Coefficients::from_pose(&pose, &(driver / follower), &friction, &(torque / follower)))
    })
}

/// Whether a display of the appendix holds from rest, at all angles. The start itself has D = 0, which would hide every
/// slip.
fn from_rest(tex: &str) -> Option<bool> {
    static RESTS: OnceLock<Vec<Moment>> = OnceLock::new();
    let rests = RESTS.get_or_init(|| {
        let rest = |(_, c): (_, Coefficients<f64>)| {
            let angular_acceleration = c.acceleration(0.0).map_or(f64::NAN, |found| found.value);
            let letters = [("A", c.a), ("R", c.a), ("D", c.d), ("V", c.d), ("E", c.e), ("theta'", 0.0)];
            let gains = [("theta''", angular_acceleration), ("theta''_0", angular_acceleration)];
            Moment::of(reading::by_name(letters.into_iter().chain(gains)))
        };
        poses().map(rest).collect()
    });
    reading::holds(tex, rests)
}

/// The angles at the start, in degrees, without their sign.
fn start_angles(id: &str) -> impl Iterator<Item = f64> {
    MEYER.printed_integers(id).into_iter().filter(|angle| *angle > 0).map(f64::from)
}
