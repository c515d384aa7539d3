//! The curves of Fig. 5.30, and how many stations and pins there can be.

use super::*;
use geneva_evidence::Dimension as Exponents;
use geneva_evidence::agreement::joined_numbers;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::rational;

const PLOT: Locator = at("Paragraph on Fig. 5.30");
pub(super) const STATIONS: Locator = at("2nd paragraph on Fig. 5.30");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        plotted(),
        PLOT.value("jazar.phi-range", "-45", "°", "wheel angle at entry and exit")
            .first_route(Evidence::CLOSED_FORM, || -of(4, Wheel::half_pitch_angle).to_degrees())
            .second_route(Evidence::VECTORS, || {
                of(4, |wheel| by_series(wheel, -wheel.engagement_half_angle())[0]).to_degrees()
            }),
        velocity_normalisation(),
        acceleration_normalisation(),
        smooth_inside(),
        infinite_jerk(),
        least_stations(),
        locking::most_stations(),
        more_pins(),
    ]
}

fn plotted() -> Claim {
    PLOT.figure("jazar.fig-5.30", "plotted", "Fig. 5.30 shows the curves of Eqs. (5.27), (5.28) and (5.29)").missing(
        "The copy we had does not include the drawing, so we cannot see whether the third curve was drawn from the \
         equation as printed in the copy, without its minus sign",
    )
}

fn velocity_normalisation() -> Claim {
    PLOT.statement(
        "jazar.velocity-normalisation",
        r"\dot{\phi}/\dot{\theta}",
        "the velocity curve is a pure number, the same for each speed of the driver",
    )
    .first_route(Evidence::DIMENSION, |stated| pure_number(Exponents::ANGULAR_SPEED, stated.pick(1, 2)))
    .second_route(Evidence::JET, |stated| same_at_each_speed(1, stated.pick(1, 2)))
    .but_not("the velocity over the square of the driver's speed is a pure number")
}

fn acceleration_normalisation() -> Claim {
    PLOT.statement(
        "jazar.acceleration-normalisation",
        r"\ddot{\phi}/\dot{\theta}",
        "the acceleration curve is a pure number, the same for each speed of the driver",
    )
    .first_route(Evidence::DIMENSION, |stated| pure_number(Exponents::ANGULAR_ACCELERATION, power(stated)))
    .second_route(Evidence::JET, |stated| same_at_each_speed(2, power(stated)))
    .corrected(
        r"\ddot{\phi}/\dot{\theta}^2",
        Slip {
            id: "",
            reason: "The square is lost. The quotient as printed still has the unit of an angular speed, so it could \
                     not be drawn on one axis with the velocity curve. The caption of the same figure has the square, \
                     so we put the loss down to the copy. We cannot tell whether the handout has the square here, \
                     too.",
            witness: "The caption of Fig. 5.30 says that the square is meant, and the curve is the same for each speed \
                      of the driver only with the square.",
            origin: Origin::Copy,
            consequence: Consequence::Copy,
            changes: "",
        },
    )
}

/// The power of the driver's speed in the characters, one if there is no exponent.
fn power(stated: Stated) -> u32 {
    if stated.numbers().is_empty() { 1 } else { stated.count() }
}

fn smooth_inside() -> Claim {
    STATIONS
        .statement(
            "jazar.smooth-inside",
            "smooth",
            "the velocity and the acceleration of the four-station wheel are smooth curves",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            about_four(|wheel| {
                let end = wheel.engagement_half_angle();
                let inside =
                    (-SUBINTERVALS..SUBINTERVALS).map(|at| end * (f64::from(at) + 0.5) / f64::from(SUBINTERVALS));
                let ends = stated.pick(vec![], vec![-end, end]);
                let left = |middle: f64| steps_without_a_slope(wheel, middle, end / f64::from(SUBINTERVALS));
                let most = greatest(inside.chain(ends).map(left));
                Finding::new(
                    most < 1e-5,
                    format!("the steps of φ̇ and φ̈, less the part due to the slope, are at most {most:.6}"),
                )
            })
        })
        .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
            about_four(|wheel| {
                let end = wheel.engagement_half_angle();
                let ends = stated.pick(vec![], vec![-end, end]);
                let most = greatest(instants(wheel).chain(ends).map(|t| jump_by_duals(wheel, t)));
                Finding::new(most < 1e-5, format!("the limits of φ̇ and φ̈ from both sides differ by at most {most:.6}"))
            })
        })
        .but_not("they are smooth over the whole turn, the ends of the advance included")
        .interpreted_as(
            "We take this to be about the four-station wheel, whose curves the figure shows. Between the two ends of \
             the advance, the curves have no jump and no kink. At the ends, as the source itself says, the jerk is \
             infinite.",
        )
}

fn infinite_jerk() -> Claim {
    STATIONS
        .statement("jazar.infinite-jerk", "infinite", "the jerk is infinite where the advance begins and ends")
        .first_route(Evidence::CLOSED_FORM, |stated| {
            for_all_stations(
                |wheel| {
                    jerks(wheel, stated).iter().all(|t| {
                        // The mean jerk over a thousandth of the way is a thousand times as great.
                        let jerk = |way: f64| {
                            let at = |t| wheel.motion(0, t).map_or(f64::NAN, |motion| motion.acceleration);
                            ((at(t + way) - at(t - way)) / (2.0 * way)).abs()
                        };
                        jerk(1e-9) > 900.0 * jerk(1e-6)
                    })
                },
                "the shorter the time, the greater the mean jerk",
            )
        })
        .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
            for_all_stations(
                |wheel| {
                    jerks(wheel, stated).iter().all(|t| {
                        let [before, after] = [-1e-12, 1e-12].map(|way| acceleration_by_duals(wheel, t + way));
                        let jump = (after - before).abs();
                        (jump - libm::tan(wheel.half_pitch_angle())).abs() < 1e-6
                    })
                },
                "the acceleration jumps by tan α",
            )
        })
        .but_not("the jerk is infinite on the line of centres, too")
}

/// What a number of stations below two says, or words without a number.
const NO_WHEEL: &str = "fewer than two stations make no wheel";

fn least_stations() -> Claim {
    STATIONS
        .statement(
            "jazar.least-stations",
            "three",
            "any number of stations from three upwards is possible, and no smaller number",
        )
        .first_route(Evidence::EXACT_IDENTITY, |stated| {
            // The engagement to either side, π/2 − π/N, as a part of π.
            let engagement = |stations: i64| rational(1, 2) - rational(1, stations);
            let least = stated.pick(i64::from(stated.count()), 2);
            if least < 2 {
                return Finding::new(false, NO_WHEEL);
            }
            let possible = (least..=1000).all(|stations| engagement(stations) > rational(0, 1));
            let part = engagement(least);
            Finding::new(
                possible && engagement(least - 1) <= rational(0, 1),
                format!("with {least} stations the engagement is {part} of half a turn on either side"),
            )
        })
        .second_route(Evidence::VECTORS, |stated| {
            // The pin must pass the wheel's axis at a distance, and a slot must reach from there to the rim.
            let sizes = |stations: u32| {
                let alpha = PI / f64::from(stations);
                let (distance, rim) = (1.0 / libm::sin(alpha), libm::cos(alpha) / libm::sin(alpha));
                [distance - 1.0, rim, rim - (distance - 1.0)]
            };
            let positive = |stations| sizes(stations).iter().all(|size| *size > geneva_evidence::CLOSURE.relative);
            let least = stated.pick(stated.count(), 2);
            if least < 2 {
                return Finding::new(false, NO_WHEEL);
            }
            Finding::new(
                (least..=1000).all(positive) && !positive(least - 1),
                format!(
                    "with {least} stations the pin's distance as it passes the axis, the rim's radius and the slot's \
                     length are {} crank radii",
                    joined_numbers(&sizes(least))
                ),
            )
        })
        .but_not("two is the minimum")
}

fn more_pins() -> Claim {
    STATIONS
        .statement("jazar.more-pins", "two or more", "drivers with two or more pins are possible")
        .first_route(Evidence::CLOSED_FORM, |stated| {
            two_or_more(stated, "leave a dwell", |wheel, pins| {
                Wheel::with_pins(wheel.stations(), pins).is_ok_and(|more| more.dwell_fraction() > 0.0)
            })
        })
        .second_route(Evidence::JET, |stated| {
            two_or_more(stated, "leave a slot before the next pin enters", |wheel, pins| {
                // By more than rounding: pins that follow each other at once leave no dwell.
                entry_crank(wheel) < (1.0 - 1e-9) * 2.0 * PI / f64::from(pins)
            })
        })
        .but_not("seven pins are possible")
        .interpreted_as("Two pins are possible with any number of stations, and three or more are possible with some.")
}

/// Whether two pins are possible with all wheels, and three or more with some; or seven.
fn two_or_more(stated: Stated, what: &str, possible: impl Fn(&Wheel, u32) -> bool) -> Finding {
    let (said, pins) = (stated.count(), stated.pick(stated.count(), 7));
    let all = for_all_stations(|wheel| possible(wheel, pins), &format!("{pins} pins {what}"));
    let most =
        |stations: u32| (1..=6).rev().find(|pins| Wheel::new(stations).is_ok_and(|wheel| possible(&wheel, *pins)));
    let more: Vec<_> =
        (3..=6).filter_map(|stations| Some((stations, most(stations).filter(|most| *most > said)?))).collect();
    let some =
        more.iter().map(|(stations, most)| format!("{most} with {stations} stations")).collect::<Vec<_>>().join(", ");
    let some = if some.is_empty() { "more with none".into() } else { some };
    Finding::new(
        all.holds && !more.is_empty(),
        format!("{}; on this condition there is room for up to {some}", all.how),
    )
}

/// The caption of Fig. 5.30, which comes among the paragraphs on Fig. 5.31.
pub(super) fn caption() -> Claim {
    at("Fig. 5.30, caption")
        .figure(
            "jazar.fig-5.30-caption",
            "driver angular velocity squared",
            "the curves are normalised by the driver's speed and by its square",
        )
        .first_route(Evidence::DIMENSION, |stated| {
            let velocity = pure_number(Exponents::ANGULAR_SPEED, 1);
            let acceleration = pure_number(Exponents::ANGULAR_ACCELERATION, stated.pick(2, 1));
            let how = format!("for the velocity {}, and for the acceleration {}", velocity.how, acceleration.how);
            Finding::new(velocity.holds && acceleration.holds, how)
        })
        .second_route(Evidence::JET, |stated| {
            let (velocity, acceleration) = (same_at_each_speed(1, 1), same_at_each_speed(2, stated.pick(2, 1)));
            Finding::new(velocity.holds && acceleration.holds, acceleration.how)
        })
        .but_not("both are normalised by the driver's speed")
}

/// Whether a rate of the wheel over a power of the driver's speed is a pure number.
pub(super) fn pure_number(rate: Exponents, power: u32) -> Finding {
    let exponents = (0..power).fold(rate, |rest, _| rest / Exponents::ANGULAR_SPEED);
    let is_pure = exponents == Exponents::NONE;
    Finding::new(is_pure, format!("the quotient {} {exponents}", if is_pure { "is" } else { "has the dimension" }))
}

/// Whether a derivative of the wheel's angle over a power of the driver's speed is the same for each speed.
pub(super) fn same_at_each_speed(order: usize, power: u32) -> Finding {
    for_all_stations(
        |wheel| {
            let curve =
                |crank: f64, speed: f64| (0..power).fold(at_speed(wheel, crank, speed)[order], |rest, _| rest / speed);
            let end = wheel.engagement_half_angle();
            [-0.9, -0.4, 0.7].iter().all(|part| {
                let once = curve(part * end, 1.0);
                [0.5, 3.0, 40.0].iter().all(|speed| agrees(curve(part * end, *speed), once))
            })
        },
        "the quotient is the same for drivers of four speeds",
    )
}

/// Into how many parts each half of the advance is divided.
const SUBINTERVALS: i32 = 2000;

/// What the steps of velocity and acceleration from one end of a subinterval to the other are, beside the width times the
/// slope in its middle: a jump or a kink in it is left over, whatever its width.
fn steps_without_a_slope(wheel: &Wheel, middle: f64, width: f64) -> f64 {
    let at =
        |t: f64| wheel.motion(0, t).map_or([f64::NAN; 3], |motion| [motion.velocity, motion.acceleration, motion.jerk]);
    let [before, slopes, after] = [at(middle - width / 2.0), at(middle), at(middle + width / 2.0)];
    let rest = |order: usize| (after[order] - before[order] - width * slopes[order + 1]).abs();
    rest(0).max(rest(1))
}

/// How far the limits of velocity and acceleration from both sides are apart, by dual numbers: each limit from two places
/// near by on its side.
fn jump_by_duals(wheel: &Wheel, crank: f64) -> f64 {
    const WAY: f64 = 1e-6;
    let at = |t: f64| if t.abs() > wheel.engagement_half_angle() { [0.0; 4] } else { by_duals(wheel, t) };
    let limit = |order: usize, way: f64| 2.0 * at(crank + way)[order] - at(crank + 2.0 * way)[order];
    [1, 2].map(|order| (limit(order, WAY) - limit(order, -WAY)).abs()).into_iter().fold(0.0, f64::max)
}

/// The acceleration by dual numbers while the pin is in the slot; zero before and after.
fn acceleration_by_duals(wheel: &Wheel, crank: f64) -> f64 {
    if crank.abs() > wheel.engagement_half_angle() { 0.0 } else { by_duals(wheel, crank)[2] }
}

/// Where the jerk is said to be infinite: the ends of the advance, or these and its middle.
fn jerks(wheel: &Wheel, stated: Stated) -> Vec<f64> {
    let end = wheel.engagement_half_angle();
    stated.pick(vec![-end, end], vec![-end, 0.0, end])
}
