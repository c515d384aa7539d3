//! What comments and text say of single cards: letters, data, times, the angle.

use super::contact::times;
use super::program::{self, by_coefficients, named as parts};
use super::reset::nearest_pin;
use super::*;
use crate::Evidence::Program as ByProgram;
use crate::meyer::runs::{Column, Hypothesis, Row, delay, duration, fitting_interval, interval, rows, usual};
use geneva_dynamics::Pose;
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

const BEFORE: Place = at("Appendix B, paragraphs before the program");
const AFTER: Place = at("Appendix B, paragraphs after the program");

pub fn claims() -> Vec<Claim> {
    [letters(), runs(), vec![angle()]].concat()
}

/// The four comments that are right. In a wrong one a letter would stand for something else in the lines that have it.
fn letters() -> Vec<Claim> {
    vec![
        letter(
            ("meyer.listing.comment-n", at("Appendix B, program, comment on N")),
            ("NUMBER OF SLOTS", "what N is", "the number of pins"),
            [program::G],
            // m pins with N slots: 1/m is 1/2 less 1/N.
            |formula| formula.replace(r"\pi/N", r"\frac{\pi}{2} - \frac{\pi}{N}"),
        ),
        letter(
            ("meyer.listing.comment-u", at("Appendix B, program, comment on U")),
            ("COEFFICIENT OF FRICTION", "what U is", "the angle whose tangent is the coefficient"),
            [program::C, program::D],
            |formula| formula.replace('U', r"\tan(U)"),
        ),
        letter(
            ("meyer.listing.comment-iw", at("Appendix B, program, comment on IW")),
            ("MOMENT OF INERTIA OF FOLLOWER", "what IW is", "that of the driver"),
            [program::A, program::E],
            exchanged,
        ),
        letter(
            ("meyer.listing.comment-ic", at("Appendix B, program, comment on IC")),
            ("MOMENT OF INERTIA OF DRIVER", "what IC is", "that of the follower"),
            [program::A],
            exchanged,
        ),
    ]
}

/// A formula with the two inertias the other way round.
fn exchanged(formula: &str) -> String {
    formula.replace("IC", "I").replace("IW", "IC").replace(r"\text{I}", r"\text{IW}")
}

/// A comment on a letter: the lines that have it are right with it, and wrong with what the neighbour says it is.
fn letter<const N: usize>(
    (id, place): (&'static str, Place),
    (said, meaning, neighbour): (&'static str, &'static str, &'static str),
    lines: [&'static str; N],
    otherwise: fn(&str) -> String,
) -> Claim {
    let read = move |line: &str, stated: Stated| {
        let (name, formula) = parts(line);
        (name, stated.pick(formula.to_owned(), otherwise(formula)))
    };
    place
        .statement(id, said, meaning)
        .by(ClosedForm, move |stated| {
            by_coefficients(|letters, at| {
                lines.map(|line| {
                    let (name, formula) = read(line, stated);
                    let right = match name.as_str() {
                        "G" => at.ratio,
                        "A" => at.coefficients.a,
                        "C" => at.coefficients.c,
                        "D" => at.coefficients.d,
                        _ => at.coefficients.e,
                    };
                    (reading::value(&formula, letters), right)
                })
            })
        })
        .by(Vectors, move |stated| {
            let holds = lines.iter().all(|line| {
                let (name, formula) = read(line, stated);
                program::holds(&format!("{name} = {formula}")) == Some(true)
            });
            Finding::new(holds, "the lines that have it, read and evaluated, against the mechanism by coordinates")
        })
        .but_not(neighbour)
}

fn runs() -> Vec<Claim> {
    vec![
        BEFORE
            .statement(
                "meyer.app-b.sets",
                "separately for each individual set",
                "each set of data has a run of its own, from rest and from the time zero",
            )
            .by(OtherPlaceInSource, |stated| {
                let begun = |at: usize| stated.pick(0.0, duration() * at as f64);
                let within = |(at, row): &(usize, &Row)| {
                    row.number(Column::Rise) > begun(*at) && row.number(Column::Rise) < begun(*at) + duration()
                };
                let found = rows().iter().enumerate().filter(within).count();
                Finding::new(
                    found == rows().len(),
                    format!("{found} of {} rise times of Appendix E lie within the run of their set", rows().len()),
                )
            })
            .by(ByProgram, |stated| {
                // Where a rise time is known to be that of the first minimum, which a run from rest has late.
                let known = || {
                    let known = |row: &Row| {
                        row.expected(Column::Rise)
                            .is_some_and(|of| matches!(of, Verdict::Reproduced | Verdict::ReadOff))
                    };
                    rows().iter().enumerate().filter(move |(_, row)| known(row))
                };
                let near = |at: usize, row: &Row| {
                    let first = Hypothesis::as_run().run(row).map_or(f64::NAN, |run| run.first_minimum);
                    let time = first + stated.pick(0.0, duration() * at as f64);
                    (time - row.number(Column::Rise)).abs() <= Column::Rise.unit() + interval()
                };
                let found = known().filter(|(at, row)| near(*at, row)).count();
                Finding::new(
                    found == known().count() && found > 0,
                    format!(
                        "{found} of {} rise times that are read off a run are counted from its start",
                        known().count()
                    ),
                )
            })
            .but_not("one run goes through all the sets, and its time goes on"),
        BEFORE
            .statement(
                "meyer.app-b.print-interval",
                "time increment between printout data points",
                "DT is the time from one printed line to the next",
            )
            .by(Evidence::Quadrature, |stated| between_lines(Mechanism::SIX_PIN, stated))
            .by(Evidence::RungeKutta, |stated| between_lines(Mechanism::FOUR_PIN, stated))
            .but_not("half of that time: every second point is printed")
            .read_as(
                "That DT sets it simply does not say that it sets nothing else: a tenth of it is the delay of the old \
                 acceleration.",
            ),
        BEFORE
            .statement("meyer.app-b.never-negative", "never negative", "the time of a run is never negative")
            .by(ByProgram, |stated| {
                static LEAST: OnceLock<f64> = OnceLock::new();
                let least = *LEAST.get_or_init(|| {
                    let first = |row| {
                        let printed = Hypothesis::as_run().program(row)?.run(&usual()).ok()?;
                        printed.lines.iter().map(|line| line.time).min_by(f64::total_cmp)
                    };
                    rows()
                        .iter()
                        .map(|row| first(row).unwrap_or(f64::NAN))
                        .fold(f64::INFINITY, |least, time| if time < least || time.is_nan() { time } else { least })
                });
                let least = least - stated.pick(0.0, delay());
                Finding::new(least >= 0.0, format!("the least in the runs of all sets is {least} s"))
            })
            .by(LimitCase, |stated| {
                let negative = times().filter(|time| f64::from(*time) * interval() < stated.pick(0.0, delay())).count();
                Finding::new(negative == 0, format!("of the multiples of DT in a run, {negative} give a negative one"))
            })
            .but_not("nor is the time at which the old acceleration is taken, T − DT/10"),
    ]
}

/// Whether the interval with which a table's peaks come out best is the listing's DT, or twice that.
fn between_lines(mechanism: Mechanism, stated: Stated) -> Finding {
    static FITTING: [OnceLock<f64>; 3] = [const { OnceLock::new() }; 3];
    let fitting = *FITTING[mechanism.index()].get_or_init(|| fitting_interval(mechanism));
    Finding::new(
        fitting == interval() * stated.pick(1.0, 2.0),
        format!("the peaks of {} pins come out best if a line is printed every {fitting} s", mechanism.pins()),
    )
}

/// Which angle the lines have: that of the engagement.
fn angle() -> Claim {
    // Through how much the driver has turned, and the pin's angle in the slot or the one meant instead.
    let turns = |stated: Stated| {
        let of = move |mechanism: Mechanism| {
            (0..100).map(move |k| {
                let turned = (f64::from(k) + 0.5) * 0.0625;
                let engaged = turned % mechanism.driver_pitch_angle() - mechanism.engagement_half_angle();
                (mechanism, turned, engaged, stated.pick(engaged, turned))
            })
        };
        Mechanism::ALL.into_iter().flat_map(of)
    };
    let value = |line: &str, mechanism: Mechanism, angle: f64| {
        let letters = [("G", mechanism.centre_distance_ratio()), ("X", angle)];
        reading::value(parts(line).1, &letters.map(|(name, value)| (name.to_owned(), value)).into())
    };
    AFTER
        .statement(
            "meyer.app-b.angle-in-lines",
            "must be used in the equations H through L",
            "in the lines of H to L the angle is that of the pin in its slot",
        )
        .by(ClosedForm, move |stated| {
            let holds = turns(stated).all(|(mechanism, _, engaged, angle)| {
                let pose = Pose::new(&mechanism.centre_distance_ratio(), &Turn::from_radians(engaged));
                let lines = [program::H, program::I, program::J, program::L];
                let right = [pose.numerator, pose.cross, pose.shape, pose.square];
                lines.iter().zip(right).all(|(line, right)| vanishes(value(line, mechanism, angle) - right))
            });
            Finding::new(holds, "the four lines, over a turn of the driver with the angle reset from pin to pin")
        })
        .by(Vectors, move |stated| {
            let holds = turns(stated).all(|(mechanism, turned, _, angle)| {
                let distance = nearest_pin(&mechanism, turned);
                vanishes(value(program::L, mechanism, angle) - distance * distance)
            });
            Finding::new(holds, "L against the pin next to the follower's axis, of all pins by coordinates")
        })
        .but_not("it is THETA, through which the driver has turned")
        .read_as("Used wherever these equations have an angle: H, I and L do, J has none.")
}
