//! What comments and text say of single cards: letters, data, times, the angle.

use super::program::{self, by_coefficients, named as parts};
use super::reset::{nearest_pin, reset};
use super::*;
use crate::meyer::runs::study::fitting_interval;
use crate::meyer::runs::table::{listing, rows};
use geneva_case1973::{Column, Hypothesis, Row};
use geneva_dynamics::Pose;
use geneva_kinematics::Mechanism;

const BEFORE: Locator = at("Appendix B, paragraphs before the program");
const AFTER: Locator = at("Appendix B, paragraphs after the program");

pub(super) fn claims() -> Vec<Claim> {
    [letters(), runs(), vec![angle(), varies(), from_zero()]].concat()
}

/// The four comments that are right. In a wrong one a letter would stand for something else in the lines that have it.
fn letters() -> Vec<Claim> {
    vec![
        letter(
            ("meyer.listing.comment-n", at("Appendix B, program, comment on N")),
            ("NUMBER OF SLOTS", "the meaning of N", "N is the number of pins"),
            [program::G],
            // m pins with N slots: 1/m is 1/2 less 1/N.
            |formula| formula.replace(r"\pi/N", r"\frac{\pi}{2} - \frac{\pi}{N}"),
        ),
        letter(
            ("meyer.listing.comment-u", at("Appendix B, program, comment on U")),
            ("COEFFICIENT OF FRICTION", "the meaning of U", "U is the angle whose tangent is the coefficient"),
            [program::C, program::D, program::V],
            |formula| formula.replace('U', r"\tan(U)"),
        ),
        letter(
            ("meyer.listing.comment-iw", at("Appendix B, program, comment on IW")),
            ("MOMENT OF INERTIA OF FOLLOWER", "the meaning of IW", "IW is the moment of inertia of the driver"),
            [program::A, program::E, program::R],
            exchanged,
        ),
        letter(
            ("meyer.listing.comment-ic", at("Appendix B, program, comment on IC")),
            ("MOMENT OF INERTIA OF DRIVER", "the meaning of IC", "IC is the moment of inertia of the follower"),
            [program::A, program::R],
            exchanged,
        ),
    ]
}

/// A formula with the two inertias swapped.
fn exchanged(formula: &str) -> String {
    formula.replace("IC", "I").replace("IW", "IC").replace(r"\text{I}", r"\text{IW}")
}

/// A comment on a letter: the lines that have it are right with it, and wrong with what the neighbour says it is.
fn letter<const N: usize>(
    (id, place): (&'static str, Locator),
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
        .first_route(Evidence::CLOSED_FORM, move |stated| {
            by_coefficients(|letters, at| {
                lines.map(|line| {
                    let (name, formula) = read(line, stated);
                    let right = match name.as_str() {
                        "G" => at.ratio,
                        "A" | "R" => at.coefficients.a,
                        "C" => at.coefficients.c,
                        "D" => at.coefficients.d,
                        "V" => at.coefficients.d.abs(),
                        _ => at.coefficients.e,
                    };
                    // What the lines of the start call by other names.
                    let start =
                        [("X0", "X"), ("P", "L"), ("Q", "H")].map(|(name, same)| (name.to_owned(), letters[same]));
                    let letters = letters.clone().into_iter().chain(start).collect();
                    (reading::value(&formula, &letters), right)
                })
            })
        })
        .second_route(Evidence::VECTORS, move |stated| {
            let holds = lines.iter().all(|line| {
                let (name, formula) = read(line, stated);
                program_letters::holds(&format!("{name} = {formula}")) == Some(true)
            });
            Finding::new(
                holds,
                "we read and evaluated the lines that contain it, and compared them with the mechanism computed in \
                 coordinates",
            )
        })
        .but_not(neighbour)
}

fn runs() -> Vec<Claim> {
    vec![
        BEFORE
            .statement(
                "meyer.app-b.sets",
                "separately for each individual set",
                "each set of data has a run of its own, which starts from rest at time zero",
            )
            .first_route(crate::evidence::QUADRATURE, |stated| {
                // Behind the strongest spring of a series comes the weakest of the next, which may be fast at once.
                let told_apart = rows().windows(2).filter_map(|pair| {
                    let [from_rest, taken_over] = peaks_after(&pair[0], &pair[1])?;
                    let printed = pair[1].number(Column::Peak);
                    let is_apart = (taken_over - from_rest).abs() > Column::Peak.unit();
                    is_apart.then_some((from_rest - printed).abs() < (taken_over - printed).abs())
                });
                Finding::for_all(
                    told_apart,
                    |is_nearer_from_rest| is_nearer_from_rest == stated.pick(true, false),
                    |found, all| {
                        format!(
                            "taking over the speed of the run before changes the peaks of {all} rows by more than 1 rad/s. \
                             Of these, {found} are printed nearer to the peaks of a run {}",
                            stated.pick(
                                "from rest than to the peaks of one that takes over the speed",
                                "that takes over the speed than to the peaks of one from rest"
                            )
                        )
                    },
                )
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let begun = |at: usize| stated.pick(0.0, listing().duration * at as f64);
                // The first set has none before it, so it begins at zero either way.
                let within = |(at, row): (usize, &Row)| {
                    row.number(Column::Rise) > begun(at) && row.number(Column::Rise) < begun(at) + listing().duration
                };
                Finding::for_all(rows().iter().enumerate().skip(1), within, |found, all| {
                    format!("{found} of {all} rise times of later sets in Appendix E fall within the run of their set")
                })
            })
            .but_not("one run goes through all the sets, so each set takes over speed and time from the previous one")
            .interpreted_as(
                "We take the rows in the order of the tables, because the order of the data cards is not printed. A run \
                 that takes over a speed would begin at an entry, with the speed that the run before has at its end. That \
                 would show in few rows, so only these count.",
            ),
        BEFORE
            .statement(
                "meyer.app-b.print-interval",
                "time increment between printout data points",
                "DT is the time from one printed line to the next",
            )
            .first_route(crate::evidence::QUADRATURE, |stated| between_lines(false, stated))
            .second_route(crate::evidence::RUNGE_KUTTA, |stated| between_lines(true, stated))
            .but_not("DT is half of that time, so every second point is printed")
            .interpreted_as(
                "The claim says only that DT sets this time. DT may set other times as well, and a tenth of DT is \
                 indeed the delay of the old acceleration.",
            ),
    ]
}

/// The largest printed speed of a row's run from rest, and of one that begins at entry with the speed that the run of the row before
/// has at its end: its first engagement may be faster than any later one.
fn peaks_after(before: &Row, row: &Row) -> Option<[f64; 2]> {
    let engagement = Hypothesis::WITHOUT_LAG.engagement(row)?;
    let listing = listing();
    let from_rest = engagement.largest_printed(listing.interval, 0.0, listing.duration).ok()?;
    let run = Hypothesis::WITHOUT_LAG.engagement(before)?.run(listing.interval, listing.duration).ok()?;
    let first = engagement.passage(run.last()?.speed).ok()?.fastest().speed;
    Some([from_rest, first.max(from_rest)])
}

/// Whether the interval that reproduces the peaks of the tables best is the listing's DT, or twice DT.
fn between_lines(by_steps: bool, stated: Stated) -> Finding {
    let fitting = fitting_interval(by_steps);
    Finding::new(
        fitting == listing().interval * stated.pick(1.0, 2.0),
        format!("the peaks of the tables are reproduced best if a line is printed every {fitting} s"),
    )
}

/// Which angle the lines contain: the angle of the engagement.
fn angle() -> Claim {
    // Through how much the driver has turned, and the pin's angle in the slot or the one meant instead.
    fn turns(stated: Stated<'_>) -> impl Iterator<Item = (Mechanism, f64, f64, f64)> {
        let of = move |mechanism: Mechanism| {
            (0..100).map(move |k| {
                let turned = (f64::from(k) + 0.5) * 0.0625;
                let engaged = turned % mechanism.driver_pitch_angle() - mechanism.engagement_half_angle();
                (mechanism, turned, engaged, stated.pick(engaged, turned))
            })
        };
        Mechanism::ALL.into_iter().flat_map(of)
    }
    let value = |line: &str, mechanism: Mechanism, angle: f64| {
        let letters = [("G", mechanism.centre_distance_ratio()), ("X", angle)];
        reading::value(parts(line).1, &reading::by_name(letters))
    };
    AFTER
        .statement(
            "meyer.app-b.angle-in-lines",
            "must be used in the equations H through L",
            "in the lines of H to L, the angle is the angle of the pin in its slot",
        )
        .first_route(Evidence::CLOSED_FORM, move |stated| {
            let holds = turns(stated).all(|(mechanism, _, engaged, angle)| {
                let pose = Pose::new(&mechanism.centre_distance_ratio(), &Turn::from_radians(engaged));
                let lines = [program::H, program::I, program::J, program::L];
                let right = [pose.numerator, pose.k_sin_theta, pose.one_minus_k_squared, pose.radius_squared];
                lines.iter().zip(right).all(|(line, right)| vanishes(value(line, mechanism, angle) - right))
            });
            Finding::new(
                holds,
                "we evaluated the four lines over a turn of the driver, with the angle reset from pin to pin",
            )
        })
        .second_route(Evidence::VECTORS, move |stated| {
            let holds = turns(stated).all(|(mechanism, turned, _, angle)| {
                let distance = nearest_pin(&mechanism, turned);
                vanishes(value(program::L, mechanism, angle) - distance * distance)
            });
            Finding::new(
                holds,
                "by the coordinates of all pins, we compared L with the distance of the pin nearest to the follower's \
                 axis",
            )
        })
        .but_not("it is THETA, the angle through which the driver has turned")
        .interpreted_as(
            "X is used wherever these equations have an angle. H, I and L have one, but J has none. We take X as it is \
             meant to be, because the printed reset, which gives that X for four pins only, is a claim of its own.",
        )
}

/// The reason that the text gives for X.
fn varies() -> Claim {
    reset(
        "meyer.app-b.varies-only",
        AFTER,
        "X varies only between the angles at which a pin enters and leaves its slot",
        "vary only between those points where the pin engages the slot",
        "vary only between those points, if it is reset after 60°, 90° or 120°",
    )
}

/// Where the driver's angle begins.
fn from_zero() -> Claim {
    fn begins(stated: Stated<'_>) -> impl Fn(Mechanism) -> f64 {
        move |at| stated.pick(stated.number(), -at.engagement_half_angle())
    }
    AFTER
        .statement(
            "meyer.app-b.from-zero",
            "start from zero",
            "THETA, the angle through which the driver has turned, begins at zero",
        )
        .first_route(Evidence::CLOSED_FORM, move |stated| begins_in_line(begins(stated)))
        .second_route(Evidence::VECTORS, move |stated| begins_at_the_rim(begins(stated)))
        .but_not("it begins at X0")
}

/// Whether a run that begins with the driver turned so far begins as a pin enters along its slot, by the line of H.
pub(super) fn begins_in_line(turned: impl Fn(Mechanism) -> f64) -> Finding {
    let holds =
        Mechanism::ALL.iter().all(|at| vanishes(program::at(*at, turned(*at) - at.engagement_half_angle())["H"]));
    Finding::new(holds, "for the X with which a run begins, the line of H is zero, because a pin enters along its slot")
}

/// Whether a run that begins with the driver turned so far begins as a pin enters, by the place of the pin.
pub(super) fn begins_at_the_rim(turned: impl Fn(Mechanism) -> f64) -> Finding {
    let holds = Mechanism::ALL.iter().all(|at| {
        let first = Turn::from_radians(turned(*at) - at.engagement_half_angle());
        agrees(at.pin_distance(&first), at.rim_radius())
    });
    Finding::new(holds, "for the X with which a run begins, the first pin is at the follower's rim")
}
