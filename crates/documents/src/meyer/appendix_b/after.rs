//! What the text after the program says of its start, its angle and the way from pin to pin.

use super::contact::{SMALL_TIME, in_force, listed};
use super::example::first_derivative;
use super::print_out::last_line;
use super::program;
use super::reset::reset;
use super::*;
use crate::meyer::appendix_d::{
    OTHER_ANGLE, WITHOUT_THE_MINUS, along_the_slots, before_the_line, coming_in, of_the_pins,
};
use crate::meyer::runs::table::{listing, rows};
use geneva_case1973::program::Program1973;
use geneva_case1973::witness::steps::Course;
use geneva_case1973::{Hypothesis, Row};
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{Inertias, Parameters};
use geneva_evidence::agreement::joined;
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

/// How the sentences on engagements that follow one another are read.
const BETWEEN_PINS: &str = "For the reset we take the angle between two pins, because the printed 90° is a claim of its \
                            own. At that reset one pin leaves its slot as the next one enters, as the text says.";

const AFTER: Locator = at("Appendix B, paragraphs after the program");

pub(super) fn claims() -> Vec<Claim> {
    [start(), lines(), angle(), end()].concat()
}

fn start() -> Vec<Claim> {
    vec![
        AFTER
            .statement(
                "meyer.app-b.initial-angles",
                r"-30° , -45° , or -60°",
                "driver's angle at the start for six, four and three pins",
            )
            .first_route(Evidence::LIMIT_CASE, before_the_line)
            .second_route(Evidence::VECTORS, coming_in)
            .but_not(WITHOUT_THE_MINUS),
        AFTER
            .statement("meyer.app-b.from-rest", "0 rad/sec", "the driver starts from rest")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let said = MEYER.printed_integers("meyer.app-d.from-rest");
                let own = stated.number() + stated.pick(0.0, 1.0);
                Finding::new(
                    said.last().is_some_and(|said| f64::from(*said) == own),
                    format!("Appendix D gives the speed {}", joined(said.last())),
                )
            })
            .second_route(Evidence::CLOSED_FORM, |stated| start_solves(stated.number() + stated.pick(0.0, 1.0)))
            .but_not("it starts at 1 rad/s"),
    ]
}

fn lines() -> Vec<Claim> {
    vec![
        AFTER
            .statement(
                "meyer.app-b.large-time",
                "\"large time\"",
                "LGT shuts off the equation of motion at the start, where the acceleration has its own line",
            )
            .first_route(crate::evidence::PROGRAM, |stated| {
                let lines = in_force(SMALL_TIME, stated.pick("NOT(REST)", "TRUE")).unwrap_or_default();
                let single = !lines.is_empty() && lines.iter().all(|[_, rest, moving]| rest + moving == 1.0);
                Finding::new(
                    single,
                    "at each line of a run, one of the deck's two lines for the acceleration is in force",
                )
            })
            .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                // The listing has LGT as the opposite of SMT; before the start and after it they are so either way.
                let said = stated.pick([false, false, true], [false, true, true]);
                let opposite = listed().any(|truths| truths.map(|small| !small) == said);
                Finding::new(opposite, "we compared it with the opposite of SMT before, at and after the start")
            })
            .but_not("LGT leaves it on at the start"),
        AFTER
            .statement(
                "meyer.app-b.primary",
                "identical to the equation derived",
                "the program's line for the acceleration is the derived equation",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let derived = MEYER.right_side("meyer.app-b.solved").replace('S', stated.pick("S", "1"));
                let line = program::named(program::ACCELERATION).1;
                // Any numbers at all: the two must be the same formula.
                let holds = (1..=20_u32).all(|k| {
                    let number = |factor: f64| libm::sin(factor * f64::from(k)) + 3.0;
                    let letters = [("A", number(1.0)), ("B", number(2.0)), ("C", number(3.0)), ("D", number(5.0))];
                    let motion = [("E", number(7.0)), ("S", if k % 2 == 0 { 1.0 } else { -1.0 })];
                    let speed = ["theta'", "1DX"].map(|name| (name, number(11.0)));
                    let letters = letters.into_iter().chain(motion).chain(speed);
                    let letters = reading::by_name(letters);
                    agrees(reading::value(line, &letters), reading::value(&derived, &letters))
                });
                Finding::new(holds, "we read both formulas and evaluated them for 20 sets of numbers")
            })
            .second_route(Evidence::VECTORS, |stated| {
                let line = program::ACCELERATION.replace('S', stated.pick("S", "1"));
                let holds = program_letters::holds(&line);
                Finding::new(
                    holds == Some(true),
                    "we read and evaluated the equation and compared it with the mechanism computed in coordinates",
                )
            })
            .but_not("it is the derived equation without S"),
        first_derivative(("meyer.app-b.speed-name", AFTER), "name of the driver's speed", ["LDX", "1DX"]),
        first_derivative(
            ("meyer.app-b.angle-name", AFTER),
            "name of the driver's speed, in the paragraph on the driver's angle",
            ["LDX", "1DX"],
        ),
    ]
}

fn angle() -> Vec<Claim> {
    vec![
        AFTER
            .statement(
                "meyer.app-b.increases",
                "increase for as long as the program runs",
                "the driver's angle grows as long as the program runs",
            )
            .first_route(crate::evidence::RUNGE_KUTTA, |stated| {
                static GROWING: OnceLock<[usize; 2]> = OnceLock::new();
                grows(stated, &GROWING, |hypothesis, row| {
                    let program = Program1973 {
                        reset: hypothesis.angle(row),
                        ..Program1973::ideal(&hypothesis.parameters(row)?)
                    };
                    let integrator = geneva_mimic::SolverParameters::new(listing().interval, listing().duration);
                    let lines = program.run(&integrator).ok()?.lines;
                    Some(lines.iter().map(|line| [line.turned, line.speed]).collect())
                })
            })
            .second_route(crate::evidence::QUADRATURE, |stated| {
                static GROWING: OnceLock<[usize; 2]> = OnceLock::new();
                grows(stated, &GROWING, |hypothesis, row| {
                    let lines = hypothesis.engagement(row)?.run(listing().interval, listing().duration).ok()?;
                    Some(lines.iter().map(|line| [line.turned, line.speed]).collect())
                })
            })
            .but_not("the driver's speed grows all that time too"),
        AFTER
            .statement(
                "meyer.app-b.engaged",
                "±30°, ±45°, or ±60°",
                "a pin is in its slot within these angles, for six, four and three pins",
            )
            .first_route(Evidence::LIMIT_CASE, of_the_pins)
            .second_route(Evidence::VECTORS, along_the_slots)
            .but_not(OTHER_ANGLE),
        reset(
            "meyer.app-b.fold",
            AFTER,
            "for the angle within an engagement, the program takes the driver's angle modulo 90°, minus 30°, 45° or \
             60°",
            r"90° , minus either 30° , 45° , or 60°",
            "60°, 90° or 120°, minus 30°, 45° or 60°",
        ),
        AFTER
            .statement(
                "meyer.app-b.series",
                "a series of problems of changing initial conditions",
                "a run may be put together from single engagements, each of which begins in the state in which the \
                 previous one ended",
            )
            .first_route(crate::evidence::RUNGE_KUTTA, |stated| {
                // The whole run at once, with the pin that is in a slot at each angle.
                in_series(0.25, stated, |parameters, engagements| {
                    let pitch = parameters.mechanism().driver_pitch_angle();
                    let steps = 4096 * engagements;
                    let turned = pitch * f64::from(engagements);
                    square_after(parameters, turned, steps).map_or(f64::NAN, f64::sqrt)
                })
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                // Without friction, at a hand-over only the driver moves, and has all the work of the torque.
                in_series(0.0, stated, |parameters, engagements| {
                    let turned = parameters.mechanism().driver_pitch_angle() * f64::from(engagements);
                    (2.0 * parameters.torque() * turned / parameters.inertias().driver()).sqrt()
                })
            })
            .but_not("all engagements have the same initial conditions, because each begins from rest")
            .interpreted_as(BETWEEN_PINS),
        AFTER
            .statement(
                "meyer.app-b.hand-over",
                "initial values of velocity and acceleration",
                "each engagement starts with the driver's speed and acceleration from the end of the one before",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| {
                let holds = Mechanism::ALL.iter().all(|mechanism| {
                    let sound = Inertias::new(1.0, 2.0).and_then(|both| Parameters::new(*mechanism, both, 1.0, 0.25));
                    sound.is_ok_and(|sound| {
                        let end = mechanism.engagement_half_angle();
                        let [last, first] = [end, -end].map(|at| {
                            let driver = sound.acceleration(at, 1.5).map_or(f64::NAN, |found| found.value);
                            stated.pick(driver, sound.pose(at).follower_acceleration(&1.5, &driver))
                        });
                        agrees(last, first)
                    })
                });
                Finding::new(holds, "we used the equation of motion as a pin leaves and as the next pin enters")
            })
            .second_route(Evidence::VECTORS, |stated| {
                for_each(
                    |at| {
                        let end = at.engagement_half_angle();
                        let [leaving, entering] = [end, -end].map(|angle| {
                            // The torque that this motion of the driver asks for at the hand-over, by both members.
                            let seen = PinKinematics::new(at, angle);
                            let normal = seen.angular_acceleration() / seen.radius();
                            let sliding = seen.place.normalize().dot(&seen.velocity) / DRIVER.0;
                            let arm = seen.radius() * seen.angular_velocity() / DRIVER.0;
                            let torque = DRIVER.1 + normal * arm + 0.25 * (normal * sliding).abs();
                            stated.pick(torque, seen.angular_acceleration())
                        });
                        agrees(leaving, entering)
                    },
                    "we used the same speed and acceleration of the driver for both pins, in coordinates",
                )
            })
            .but_not("it also starts with the follower's acceleration from the end of the one before")
            .interpreted_as(BETWEEN_PINS),
        AFTER
            .statement(
                "meyer.app-b.one-pin-at-a-time",
                "discrete, single pin engagements",
                "the motion is a sequence of engagements of one pin each",
            )
            .first_route(Evidence::VECTORS, |stated| {
                let engaged = stated.pick(stated.count() as usize, 2);
                for_each(
                    |at| {
                        (-9..=9).all(|k| {
                            let layout = at.layout(at.engagement_half_angle() * f64::from(k) / 10.0);
                            layout.is_ok_and(|layout| layout.engaged.len() == engaged)
                        })
                    },
                    "we counted the pins in slots between two hand-overs",
                )
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                let engaged = stated.pick(stated.count() as usize, 2);
                for_each(
                    |at| {
                        // Within the follower's rim are the pins that are in slots.
                        (-9..=9).all(|k| {
                            let first = at.engagement_half_angle() * f64::from(k) / 10.0;
                            let within = (0..at.pins()).filter(|pin| {
                                let crank = Turn::from_radians(first + at.driver_pitch_angle() * f64::from(*pin));
                                at.pin_distance(&crank) < at.rim_radius()
                            });
                            within.count() == engaged
                        })
                    },
                    "we counted the pins within the follower's rim",
                )
            })
            .but_not("a sequence of engagements of two pins each")
            .interpreted_as(BETWEEN_PINS),
    ]
}

/// Whether the driver's speed at the end of one to three engagements from rest, put together one by one, is its speed
/// in the whole run.
fn in_series(friction: f64, stated: Stated, whole: impl Fn(&Parameters, u32) -> f64) -> Finding {
    let holds = Mechanism::ALL.iter().all(|mechanism| {
        let both = Inertias::new(1.0, 2.0).and_then(|both| Parameters::new(*mechanism, both, 1.5, friction));
        both.is_ok_and(|parameters| {
            let Ok(engagement) = Engagement::new(&parameters) else { return false };
            let mut speed = 0.0;
            (1..=3).all(|number| {
                speed = engagement.return_map(stated.pick(speed, 0.0)).unwrap_or(f64::NAN);
                (speed / whole(&parameters, number) - 1.0).abs() < 1e-6
            })
        })
    });
    Finding::new(
        holds,
        "we compared the driver's speed at three hand-overs with the speed in the whole run, for each mechanism",
    )
}

/// The square of the driver's speed when it has turned so far from rest, by Runge-Kutta steps of equal angle.
///
/// Of all pins, the pin in a slot is the nearest to the follower's axis.
fn square_after(parameters: &Parameters, turned: f64, steps: u32) -> Option<f64> {
    let at = parameters.mechanism();
    let first = at.engagement_half_angle();
    let engaged = |turned: f64| {
        let pins = (0..at.pins()).map(|pin| turned - first - at.driver_pitch_angle() * f64::from(pin));
        let angles = pins.map(|angle| libm::remainder(angle, 2.0 * PI));
        angles.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(f64::NAN)
    };
    let all: Vec<f64> = (0..=steps).map(|k| turned * f64::from(k) / f64::from(steps)).collect();
    Course::from_angles(parameters, all, engaged).squares(0.0).last().copied()
}

/// Whether what is printed at each interval of a run grows from line to line: the angle, or the speed. In all runs,
/// each made once for both.
fn grows(
    stated: Stated,
    growing: &OnceLock<[usize; 2]>,
    run: impl Fn(&Hypothesis, &Row) -> Option<Vec<[f64; 2]>>,
) -> Finding {
    let growing = growing.get_or_init(|| {
        let runs: Vec<_> = rows().iter().filter_map(|row| run(&Hypothesis::WITHOUT_LAG, row)).collect();
        [0, 1].map(|of| runs.iter().filter(|lines| lines.windows(2).all(|pair| pair[0][of] < pair[1][of])).count())
    });
    let [angle, speed] = *growing;
    let growing = stated.pick(angle, speed);
    Finding::new(growing == rows().len(), format!("it grows from line to line in {growing} of {} runs", rows().len()))
}

fn end() -> Vec<Claim> {
    vec![
        AFTER
            .statement("meyer.app-b.run-length", "0.2 seconds", "time at which a run ends")
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let listed = MEYER.printed_number("meyer.listing.run-length");
                Finding::new(
                    agrees(stated.number() + stated.pick(0.0, listing().interval), listed),
                    format!("the program ends at {listed} s"),
                )
            })
            .second_route(crate::evidence::PROGRAM, |stated| {
                let end = last_line(listing().duration).unwrap_or(f64::NAN);
                let said = stated.number() + stated.pick(0.0, listing().interval);
                Finding::new(
                    (end - said).abs() < 1e-9,
                    format!("the last line of the program's first run is at {end:.4} s"),
                )
            })
            .but_not("it ends one printed line later"),
    ]
}
