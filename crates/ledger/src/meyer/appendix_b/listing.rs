//! The program line by line: its constants, its factors, and the angle it folds.
//!
//! The text of the program is not printed here. What its lines compute is a fact, and [`Program`] computes it too.

use super::fold::fold;
use super::program::{Program, SPEED, as_letters, by_coefficients};
use super::*;
use crate::meyer::runs::{self, Mechanism};
use geneva_dynamics::{Sign, Slots};

const PROGRAM: &str = "Appendix B, program";

pub fn claims() -> Vec<Claim> {
    [constants(), factors(), motion()].concat()
}

fn constants() -> Vec<Claim> {
    vec![
        statement(
            "meyer.listing.parameters",
            PROGRAM,
            "six parameters are read, the angle at the start (in radians, negative) among them",
            "X0",
            (OtherPlaceInSource, || {
                // Beside the four of the study: N and X0.
                let four = claim("meyer.four-parameters").is_some_and(|claim| claim.printed.starts_with("four"));
                Finding::new(four, "the study has four, beside the number of slots and this angle")
            }),
            (ClosedForm, || {
                let holds = Slots::ALL.iter().all(|slots| {
                    let start = -slots.engagement_half_angle();
                    vanishes(Program::at(*slots, start).h)
                });
                Finding::new(holds, "H is zero at the start for an angle in radians")
            }),
        ),
        Claim::value(
            WORK,
            "meyer.listing.pi",
            PROGRAM,
            "half a turn, in the program's ratio of the centre distance",
            ("3.1416", ""),
            Check::number((ClosedForm, || PI), (LimitCase, machin)),
        ),
        Claim::value(
            WORK,
            "meyer.listing.print-interval",
            PROGRAM,
            "time between printed lines, a datum: of a half, once and twice as much it is the one whose largest printed \
             speeds are those of the tables",
            (".0005", "s"),
            Check::number(
                (Evidence::Integration, || runs::fitting_interval(Mechanism::SixPin)),
                (Evidence::Steps, || runs::fitting_interval(Mechanism::FourPin)),
            ),
        ),
        Claim::value(
            WORK,
            "meyer.listing.degrees",
            PROGRAM,
            "degrees in a radian, for the driver's angle and the angle in the slot",
            ("57.296", ""),
            Check::number((ClosedForm, || 1f64.to_degrees()), (LimitCase, || 180.0 / machin())),
        ),
        Claim::value(
            WORK,
            "meyer.listing.quarter-turn",
            PROGRAM,
            "a quarter of a turn in radians: an engagement of four pins",
            ("1.5708", ""),
            Check::number((ClosedForm, || 2.0 * Slots::Four.engagement_half_angle()), (LimitCase, || machin() / 2.0)),
        ),
        statement(
            "meyer.listing.run-length",
            PROGRAM,
            "time at which a run ends, in seconds",
            ".2",
            (OtherPlaceInSource, || {
                let said = claim("meyer.app-b.run-length").map_or("", |claim| claim.printed);
                let here = claim("meyer.listing.run-length").map_or("-", |claim| claim.printed);
                Finding::new(said.starts_with(&format!("0{here}")), "the text says so")
            }),
            (LimitCase, || {
                let end = claim("meyer.listing.run-length").and_then(|claim| claim.printed.parse::<f64>().ok());
                let points = end.map_or(f64::NAN, |end| end / runs::interval());
                Finding::new(agrees(points, points.round()), format!("{points:.0} print intervals"))
            }),
        ),
    ]
}

fn factors() -> Vec<Claim> {
    vec![
        line(
            "meyer.listing.g",
            "the ratio a, Eq. (1-2); with the printed 3.1416 it is off by less than five millionths",
            "G",
            || {
                let rounded = |slots: &Slots| 1.0 / libm::sin(printed("meyer.listing.pi") / f64::from(slots.count()));
                let near = Slots::ALL.iter().all(|slots| (rounded(slots) / slots.ratio() - 1.0).abs() < 5e-6);
                let found = by_coefficients(|lines, at| (lines.g, at.ratio));
                Finding::new(near && found.holds, found.how)
            },
            || as_letters(|lines| lines.g, "a"),
        ),
        line(
            "meyer.listing.h",
            "a cos θ − 1",
            "H",
            || by_coefficients(|lines, at| (lines.h, at.pose.lead)),
            || equal(|letter| (Program::of(letter).h, letter("phi'") / letter("theta'") * letter("square")), "H"),
        ),
        line(
            "meyer.listing.i",
            "a sin θ",
            "I",
            || by_coefficients(|lines, at| (lines.i, at.pose.cross)),
            || equal(|letter| (Program::of(letter).i, letter("h") * letter("R") / (letter("r") * letter("r"))), "I"),
        ),
        line(
            "meyer.listing.j",
            "1 − a²",
            "J",
            || by_coefficients(|lines, at| (lines.j, at.pose.shape)),
            || equal(|letter| (Program::of(letter).j, -(letter("square") + 2.0 * Program::of(letter).h)), "J"),
        ),
        line(
            "meyer.listing.l",
            "1 + a² − 2 a cos θ",
            "L",
            || by_coefficients(|lines, at| (lines.l, at.pose.square)),
            || as_letters(|lines| lines.l, "square"),
        ),
        line(
            "meyer.listing.a",
            "A, with the driver's inertia above the line and with the square",
            "A",
            || by_coefficients(|lines, at| (lines.a, at.coefficients.a)),
            || as_letters(|lines| lines.a, "A"),
        ),
        line(
            "meyer.listing.b",
            "B",
            "B",
            || by_coefficients(|lines, at| (lines.b, at.coefficients.b)),
            || as_letters(|lines| lines.b, "B"),
        ),
        line(
            "meyer.listing.c",
            "C",
            "C",
            || by_coefficients(|lines, at| (lines.c, at.coefficients.c)),
            || as_letters(|lines| lines.c, "C"),
        ),
        line(
            "meyer.listing.d",
            "D",
            "D",
            || by_coefficients(|lines, at| (lines.d, at.coefficients.d)),
            || as_letters(|lines| lines.d, "D"),
        ),
        line(
            "meyer.listing.e",
            "E",
            "E",
            || by_coefficients(|lines, at| (lines.e, at.coefficients.e)),
            || as_letters(|lines| lines.e, "E"),
        ),
        line(
            "meyer.listing.f",
            "F, with the acceleration of a moment before",
            "F",
            || by_coefficients(|lines, at| (lines.f, at.coefficients.between_the_bars(&SPEED, &at.acceleration))),
            || as_letters(|lines| lines.f, "F"),
        ),
        line(
            "meyer.listing.s",
            "S, by the sign of F; plus one where F is zero",
            "S",
            || by_coefficients(|lines, at| (lines.s, Sign::of(at.sign, 1.0))),
            || as_letters(|lines| lines.s, "S"),
        ),
    ]
}

fn motion() -> Vec<Claim> {
    vec![
        line(
            "meyer.listing.acceleration",
            "the driver's acceleration, as derived in this appendix",
            "2DX",
            || by_coefficients(|lines, at| (lines.acceleration, at.acceleration)),
            || as_letters(|lines| lines.acceleration, "theta''"),
        ),
        statement(
            "meyer.listing.speed",
            PROGRAM,
            "the driver's speed, integrated from zero",
            "1DX",
            (OtherPlaceInSource, || {
                let zero = numbers("meyer.app-b.from-rest") == [0];
                Finding::new(zero, "the text has the driver start from rest")
            }),
            (ClosedForm, || listing_start::start_solves(0.0)),
        ),
        fold(
            "meyer.listing.fold",
            PROGRAM,
            "the angle in the slot: the driver's angle modulo a quarter of a turn, \
                    plus the angle at the start",
            "MOD",
            "the modulus 2π/m: 1.5708 for four pins only, 1.0472 for six and 2.0944 for three",
        ),
        line(
            "meyer.listing.phidot",
            "the follower's speed, Eq. (1-7)",
            "PHIDOT",
            || by_coefficients(|lines, at| (lines.follower_speed, at.pose.velocity_ratio() * SPEED)),
            || as_letters(|lines| lines.follower_speed, "phi'"),
        ),
    ]
}

/// A line of the program that computes a quantity of chapter I.
fn line(
    id: &'static str,
    meaning: &'static str,
    printed: &'static str,
    first: fn() -> Finding,
    second: fn() -> Finding,
) -> Claim {
    Claim::equation(WORK, id, PROGRAM, meaning, printed, Check::equation((ClosedForm, first), (Vectors, second)))
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
