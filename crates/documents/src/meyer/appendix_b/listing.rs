//! The program line by line: its constants, its factors, and the angle it resets.
//!
//! The text of the program is not printed here. What single cards compute is a fact: the name and the formula of each, as
//! its card has them, and [`program`] computes it too.

use super::cards::{begins_at_the_rim, begins_in_line};
use super::contact::{is_late_by, parts_of_the_interval};
use super::print_out::last_line;
use super::program::{self, as_equation, by_coefficients};
use super::program_letters::{FACTORS, PLACES, RATIO, SOLVED};
use super::reset::reset;
use super::*;
use crate::meyer::listed;
use crate::meyer::runs::study::fitting_interval;
use crate::meyer::runs::table::listing;
use crate::meyer::spring::no_rate;
use geneva_evidence::Vocabulary;
use geneva_evidence::agreement::joined;
use geneva_kinematics::Mechanism;
use std::cmp::Ordering;

const PROGRAM: Locator = at("Appendix B, program");

pub(crate) fn claims() -> Vec<Claim> {
    [constants(), factors(), motion()].concat()
}

fn constants() -> Vec<Claim> {
    vec![
        no_rate(
            "meyer.listing.comment-k",
            at("Appendix B, program, comment on K"),
            "what K is called",
            "SPRING RATE",
            "TORQUE OF THE SPRING",
        ),
        PROGRAM
            .statement(
                "meyer.listing.parameters",
                "X0",
                "the angle at the start is read as a parameter beside the number of slots; it is in radians and \
                 negative",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let holds = Mechanism::ALL.iter().all(|mechanism| {
                    let start = start_angle(*mechanism, stated);
                    vanishes(program::at(*mechanism, start)["H"]) && program::at(*mechanism, start + 0.01)["H"] > 0.0
                });
                Finding::new(
                    holds,
                    "the line of H, read and evaluated, is zero there and positive after it, because a pin enters \
                     along its slot",
                )
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                // The reset angle starts at X0 and ends as far on the other side.
                let holds = Mechanism::ALL.iter().all(|mechanism| {
                    let start = start_angle(*mechanism, stated);
                    agrees(start + 2.0 * PI / f64::from(mechanism.pins()), -start)
                });
                Finding::new(holds, "the angle from one pin to the next takes the pin equally far to the other side")
            })
            .but_not("it is positive"),
        PROGRAM
            .value("meyer.listing.pi", listed::PI, "", "half a turn, in the program's ratio of the centre distance")
            .first_route(Evidence::CLOSED_FORM, || PI)
            .second_route(Evidence::LIMIT_CASE, machin),
        PROGRAM
            .value(
                "meyer.listing.print-interval",
                listed::PRINT_INTERVAL,
                "s",
                "time between printed lines, a given value. With half or twice this time, the peaks of the tables as a \
                 whole would be reproduced less well",
            )
            .first_route(crate::evidence::QUADRATURE, || fitting_interval(false))
            .second_route(crate::evidence::RUNGE_KUTTA, || fitting_interval(true)),
        PROGRAM
            .statement(
                "meyer.listing.delay",
                listed::DELAY,
                "the card asks for the acceleration as it was a tenth of the print interval earlier",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let told = parts_of_the_interval("meyer.app-b.delay");
                Finding::new(
                    told == Some(stated.number() * stated.pick(1.0, 2.0)),
                    format!("the text divides the interval by {}", told.unwrap_or(f64::NAN)),
                )
            })
            .second_route(crate::evidence::PROGRAM, |stated| {
                let told = parts_of_the_interval("meyer.app-b.delay").unwrap_or(f64::NAN);
                is_late_by(stated.number() * stated.pick(1.0, 2.0), told)
            })
            .but_not("it asks for the acceleration a twentieth of the interval earlier")
            .interpreted_as(
                "In a run whose steps are shorter than the delay, we check what the card asks for. Where a step is \
                 longer, the runs of our deck take the latest value. We do not know which value the library of 1973 \
                 took there.",
            ),
        PROGRAM.statement("meyer.listing.delay-third", "100.", "the third number of the delay").missing(
            "The thesis does not say anywhere what the third number of TDL is for. The tables do not depend on this \
             number: they are the same whether the delay keeps a hundred values or all of them",
        ),
        PROGRAM
            .value(
                "meyer.listing.degrees",
                "57.296",
                "",
                "degrees in a radian, for the driver's angle and the angle in the slot",
            )
            .first_route(Evidence::CLOSED_FORM, || 1f64.to_degrees())
            .second_route(Evidence::LIMIT_CASE, || 180.0 / machin()),
        PROGRAM
            .value(
                "meyer.listing.quarter-turn",
                listed::QUARTER_TURN,
                "",
                "a quarter of a turn in radians, which is an engagement of four pins",
            )
            .first_route(Evidence::CLOSED_FORM, || 2.0 * Mechanism::FOUR_PIN.engagement_half_angle())
            .second_route(Evidence::LIMIT_CASE, || machin() / 2.0),
        PROGRAM
            .statement("meyer.listing.run-length", listed::RUN_LENGTH, "time at which a run ends, in seconds")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let told = told_length();
                let said = stated.number() + stated.pick(0.0, listing().interval);
                Finding::new(agrees(told, said), format!("the text says {told} s"))
            })
            .second_route(crate::evidence::PROGRAM, |stated| {
                let end = last_line(stated.number() + stated.pick(0.0, listing().interval)).unwrap_or(f64::NAN);
                Finding::new(
                    (end - told_length()).abs() < 1e-9,
                    format!("with it, the last line of the program's first run is at {end:.4} s"),
                )
            })
            .but_not("it ends one printed line later"),
    ]
}

/// The angle at the start of a run.
fn start_angle(mechanism: Mechanism, stated: Stated) -> f64 {
    mechanism.engagement_half_angle() * stated.pick(-1.0, 1.0)
}

/// The length of a run that the text tells, in s.
fn told_length() -> f64 {
    MEYER
        .printed_text("meyer.app-b.run-length")
        .split(' ')
        .next()
        .and_then(|number| number.parse().ok())
        .unwrap_or(f64::NAN)
}

fn factors() -> Vec<Claim> {
    vec![
        line(
            PROGRAM,
            "meyer.listing.g",
            "the ratio a of Eq. (1-2), which the printed 3.1416 changes by less than five millionths",
            "G 1./SIN(3.1416/N)",
            program::G,
            RATIO,
        )
        .with_second_witness(Evidence::CLOSED_FORM, || {
            let rounded = |mechanism: &Mechanism| {
                1.0 / libm::sin(MEYER.printed_number("meyer.listing.pi") / f64::from(mechanism.slots()))
            };
            let holds = Mechanism::ALL
                .iter()
                .all(|mechanism| (rounded(mechanism) / mechanism.centre_distance_ratio() - 1.0).abs() < 5e-6);
            Finding::new(holds, "with the printed digits, the ratio is near enough to that of each mechanism")
        }),
        line(PROGRAM, "meyer.listing.h", "a cos θ − 1", "H (G*COS(X))-1.", program::H, PLACES),
        line(PROGRAM, "meyer.listing.i", "a sin θ", "I G*SIN(X)", program::I, PLACES),
        line(PROGRAM, "meyer.listing.j", "1 − a²", "J 1.-(G*G)", program::J, PLACES),
        line(PROGRAM, "meyer.listing.l", "1 + a² − 2 a cos θ", "L 1.+(G*G)-(2.*G*COS(X))", program::L, PLACES),
        line(
            PROGRAM,
            "meyer.listing.a",
            "A, with the driver's inertia above the line and with the square",
            "A IC/IW+((H*H)/(L*L))",
            program::A,
            FACTORS,
        ),
        line(PROGRAM, "meyer.listing.b", "B", "B (I*J*H)/(L*L*L)", program::B, FACTORS),
        line(PROGRAM, "meyer.listing.c", "C", "C (I*I*U*J)/(L*L*L)", program::C, FACTORS),
        line(PROGRAM, "meyer.listing.d", "D", "D (I*U*H)/(L*L)", program::D, FACTORS),
        line(PROGRAM, "meyer.listing.e", "E", "E K/IW", program::E, FACTORS),
        line(
            PROGRAM,
            "meyer.listing.f",
            "F, with the acceleration from a moment earlier",
            "F (C*1DX*1DX)+(D*OLD2DX)",
            program::F,
            FACTORS,
        ),
        PROGRAM
            .equation("meyer.listing.s", "S FSW(F,-1.,1.,1.)", "S, by the sign of F, and plus one where F is zero")
            .evaluated(Evidence::CLOSED_FORM, |tex| match switch_of(tex) {
                Some(card) => by_coefficients(|lines, at| {
                    [(card.picked(|letter| lines.get(letter).copied()), at.sign.apply(1.0))]
                }),
                None => Finding::of_reading(None),
            })
            .read(Evidence::VECTORS, |tex| {
                let card = switch_of(tex)?;
                let found = equal(
                    |letter| (card.picked(|name| Some(letter(name))) * letter("F"), letter("F").abs()),
                    "S F and the size of F",
                );
                Some(found.holds && card.picked(|_| Some(0.0)) == 1.0)
            }),
    ]
}

/// The card of S: by the sign of which letter it picks one of three values, for less than zero, zero and more.
struct Switch<'a> {
    letter: &'a str,
    values: [f64; 3],
}

/// Reads the card; none if it is not one that gives S by the function that switches, and not by S itself.
fn switch_of(card: &str) -> Option<Switch<'_>> {
    let (letter, values) = card.strip_prefix("S FSW(")?.strip_suffix(')')?.split_once(',')?;
    let values: Option<Vec<f64>> = values.split(',').map(|value| value.trim().parse().ok()).collect();
    (letter != "S").then_some(Switch { letter, values: values?.try_into().ok()? })
}

impl Switch<'_> {
    /// What is picked, with a number for the letter; not a number if the letter has none.
    fn picked(&self, number: impl Fn(&str) -> Option<f64>) -> f64 {
        let [less, zero, more] = self.values;
        match number(self.letter).and_then(|number| number.partial_cmp(&0.0)) {
            Some(Ordering::Less) => less,
            Some(Ordering::Equal) => zero,
            Some(Ordering::Greater) => more,
            None => f64::NAN,
        }
    }
}

fn motion() -> Vec<Claim> {
    vec![
        line(
            PROGRAM,
            "meyer.listing.acceleration",
            "the driver's acceleration, as derived in this appendix",
            "2DX (E-(B+(S*C))*(1DX*1DX))/(A+(S*D))",
            program::ACCELERATION,
            SOLVED,
        ),
        PROGRAM
            .statement(
                "meyer.listing.speed",
                "INT(2DX,0.)",
                "the driver's speed is its acceleration, integrated from zero",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let from = stated.number() + stated.pick(0.0, 1.0);
                let said: Vec<f64> =
                    MEYER.printed_integers("meyer.app-b.from-rest").into_iter().map(f64::from).collect();
                Finding::new(said == [from], format!("in the text the driver starts at the speed {}", joined(&said)))
            })
            .second_route(Evidence::CLOSED_FORM, |stated| start_solves(stated.number() + stated.pick(0.0, 1.0)))
            .but_not("it is integrated from one"),
        PROGRAM
            .statement("meyer.listing.angle", "INT(1DX,0.)", "the driver's angle is its speed, integrated from zero")
            .first_route(Evidence::CLOSED_FORM, |stated| begins_in_line(turned_at_first(stated)))
            .second_route(Evidence::VECTORS, |stated| begins_at_the_rim(turned_at_first(stated)))
            .but_not("it is integrated from one"),
        reset(
            "meyer.listing.fold",
            PROGRAM,
            "the angle in the slot is the driver's angle modulo a quarter of a turn, plus the angle at the start",
            "X (MOD(THETA,1.5708))+X0",
            "the modulus 2π/m: 1.5708 for four pins only, 1.0472 for six and 2.0944 for three",
        ),
        line(
            PROGRAM,
            "meyer.listing.phidot",
            "the follower's speed, Eq. (1-7)",
            "PHIDOT (H*1DX)/L",
            program::FOLLOWER_SPEED,
            PLACES,
        ),
    ]
}

/// From what the driver's angle is integrated, in rad.
fn turned_at_first(stated: Stated) -> impl Fn(Mechanism) -> f64 {
    move |_| stated.number() + stated.pick(0.0, 1.0)
}

/// A line of the program that computes a quantity of chapter I. Both routes read the card, and what it says in the letters of
/// mathematics.
pub(crate) fn line(
    place: Locator,
    id: &'static str,
    meaning: &'static str,
    printed: &'static str,
    said: &'static str,
    letters: Vocabulary,
) -> Claim {
    place.equation(id, printed, meaning).rewritten_and_proven(letters, as_equation).in_other_letters(said)
}

/// π by Machin's series.
fn machin() -> f64 {
    let arctangent = |x: f64| -> f64 {
        let mut power = x;
        let mut sum = 0.0;
        for k in 0..30 {
            sum += power / f64::from(2 * k + 1);
            power *= -x * x;
        }
        sum
    };
    16.0 * arctangent(1.0 / 5.0) - 4.0 * arctangent(1.0 / 239.0)
}
