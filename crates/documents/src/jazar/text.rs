//! What the text says of Geneva wheels before the first equation.

use super::letters::SIZES_OF_FOUR;
use super::*;
use geneva_evidence::CLOSURE;
use geneva_evidence::equal_to;
use geneva_kinematics::indexing::{Indexing, Phase};
use geneva_kinematics::pin_slot::velocity_ratio;

const INDEXING: Locator = at("1st paragraph");
pub(super) const VARIETIES: Locator = at("2nd paragraph");
pub(super) const SIMPLE: Locator = at("Paragraph on Fig. 5.28");
pub(super) const CAPTION: Locator = at("Fig. 5.28, caption");
const MODEL: Locator = at("Paragraph below Fig. 5.28");

pub(super) fn claims() -> Vec<Claim> {
    vec![
        one_direction(),
        slider_crank(),
        locking::journal_bearing(),
        quarter_turn(),
        locking::locking(),
        tangent_entry(),
        infinite_deceleration(),
        centre_distance(),
        wheel_radius(),
        locking::journal_radius(),
        locking::cutout_centres(),
        sense_of_the_wheel(),
        CAPTION.lost_drawing("jazar.fig-5.28-drawing", "Figure 5.28", "the drawing of the four-station mechanism"),
        parts_of_the_cycle(),
        speeds_up_then_slows_down(),
    ]
}

fn one_direction() -> Claim {
    INDEXING
        .statement("jazar.one-direction", "same direction", "the wheel never turns back")
        .first_route(Evidence::JET, |stated| {
            for_all_stations(
                |wheel| {
                    let end = wheel.engagement_half_angle();
                    let advances = |t: f64| by_series(wheel, t)[1] > stated.pick(-1.0, 1.0) * CLOSURE.relative;
                    within(end).chain([-end, end]).all(advances)
                },
                "φ̇ ≥ 0 while the pin is in the slot",
            )
        })
        .second_route(Evidence::VECTORS, |stated| {
            for_all_stations(
                |wheel| never_goes_back(wheel, stated.pick(-1.0, 1.0) * CLOSURE.relative),
                "the angle never falls over two turns",
            )
        })
        .but_not("the wheel never turns back and never stands still")
        .interpreted_as(
            "The handout says this of indexing mechanisms in general. We tried it on Geneva wheels of any number of \
             stations, with a driver that does not turn back.",
        )
}

fn slider_crank() -> Claim {
    VARIETIES
        .statement(
            "jazar.slider-crank",
            "inverted slider crank",
            "while the wheel advances, the mechanism is an inverted slider crank, because the pin is on a crank and in \
             a slot through the wheel's axis",
        )
        .first_route(Evidence::VECTORS, |stated| {
            // The pin's place in the wheel, which turns as the formulas say.
            let kept = |wheel: &Wheel, t: f64| {
                let pin = pin_from_pivot(&wheel.centre_distance_ratio(), &Turn::from_radians(t));
                let slot = wheel.engaged(t).map_or(f64::NAN, |motion| motion.angle);
                let slot = Turn::from_radians(slot).direction();
                stated.pick(slot.perp(&pin), slot.dot(&pin))
            };
            for_all_stations(
                |wheel| {
                    let first = kept(wheel, 0.0);
                    within(wheel.engagement_half_angle()).all(|t| vanishes(kept(wheel, t) - first))
                },
                "in the wheel, one coordinate of the pin keeps its value",
            )
        })
        .second_route(Evidence::AUTOMATIC_DERIVATIVE, |stated| {
            // The pin's velocity in the wheel: its own, less that of the wheel's point under it.
            let moves = |wheel: &Wheel, t: f64| {
                let (x, y) = (wheel.centre_distance_ratio() - libm::cos(t), libm::sin(t));
                let turning = by_duals(wheel, t)[1];
                let velocity = [libm::sin(t) + turning * y, libm::cos(t) - turning * x];
                let across = velocity[1] * x - velocity[0] * y;
                let along = velocity[0] * x + velocity[1] * y;
                stated.pick(across, along)
            };
            for_all_stations(
                |wheel| within(wheel.engagement_half_angle()).all(|t| vanishes(moves(wheel, t))),
                "in the wheel, the pin's velocity has one component only",
            )
        })
        .but_not("it is a four-bar linkage: the pin keeps its distance from the wheel's axis")
}

fn quarter_turn() -> Claim {
    SIMPLE
        .statement(
            "jazar.quarter-turn",
            "one-quarter turn",
            "the four-station wheel advances a quarter turn for every turn of the driver",
        )
        .first_route(Evidence::VECTORS, |stated| {
            let advance = |wheel: &Wheel| 2.0 * by_series(wheel, wheel.engagement_half_angle())[0];
            same(of(4, advance), 2.0 * PI * stated.pick(quarters(stated), 0.5))
        })
        .second_route(Evidence::LIMIT_CASE, |stated| {
            // After so many turns of the driver the wheel is back. How far a slot is turned on in one of them, the law of
            // cosines says at entry and at exit.
            let turns = libm::round(1.0 / stated.pick(quarters(stated), 0.5)) as i64;
            let turned = |wheel: &Wheel| {
                let slot = |crank: f64| by_cosines(wheel.centre_distance_ratio(), crank).1;
                let pitch = slot(wheel.engagement_half_angle()) - slot(-wheel.engagement_half_angle());
                wheel.motion(turns, 0.0).map_or(f64::NAN, |motion| motion.stations as f64 * pitch + motion.angle)
            };
            same(of(4, turned), 2.0 * PI)
        })
        .but_not("the wheel advances half a turn")
}

/// The part of a whole that a number of quarters is; not a number if the words are not of quarters.
pub(super) fn quarters(stated: Stated) -> f64 {
    if stated.characters().contains("quarter") { stated.number() / 4.0 } else { f64::NAN }
}

fn tangent_entry() -> Claim {
    SIMPLE
        .statement(
            "jazar.tangent-entry",
            "tangent",
            "if the slot is not tangent to the pin's circle at entry and exit, the acceleration there is infinite",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            for_all_stations(
                |wheel| {
                    crossings(wheel, stated.pick(&[0.25, 0.5, 0.75], &[0.0]))
                        .all(|(ratio, crank)| !vanishes(velocity_ratio(&ratio, &Turn::from_radians(crank))))
                },
                "the wheel's speed is not zero as the pin meets such a slot, so it jumps",
            )
        })
        .second_route(Evidence::VECTORS, |stated| {
            for_all_stations(
                |wheel| {
                    crossings(wheel, stated.pick(&[0.25, 0.5, 0.75], &[0.0])).all(|(ratio, crank)| {
                        // The slot is at α on the pin's side; the pin moves in the direction (sin θ, cos θ).
                        let slot = Turn::from_radians(wheel.half_pitch_angle().copysign(crank)).direction();
                        let pin = pin_from_pivot(&ratio, &Turn::from_radians(crank));
                        let velocity = nalgebra::Vector2::new(libm::sin(crank), libm::cos(crank));
                        vanishes(slot.perp(&pin)) && !vanishes(slot.perp(&velocity))
                    })
                },
                "the pin is in the slot's line, and its velocity has a component across it",
            )
        })
        .but_not("the acceleration is infinite with a tangent slot, too")
}

fn infinite_deceleration() -> Claim {
    SIMPLE
        .statement(
            "jazar.infinite-deceleration",
            "infinite deceleration at the end",
            "if the slot is not tangent, the wheel has an infinite acceleration at the beginning and an infinite \
             deceleration at the end",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            jumps(stated, |_, ratio, crank| velocity_ratio(&ratio, &Turn::from_radians(crank)))
        })
        .second_route(Evidence::VECTORS, |stated| {
            jumps(stated, |_, ratio, crank| {
                // The part of the pin's velocity across the slot, in the sense in which the wheel advances.
                let pin = pin_from_pivot(&ratio, &Turn::from_radians(crank));
                pin.perp(&nalgebra::Vector2::new(libm::sin(crank), libm::cos(crank)))
            })
        })
        .but_not("the wheel is decelerated at the beginning and accelerated at the end")
        .interpreted_as(
            "We go by the size of the wheel's speed: it jumps up from rest as the pin enters, and down to rest as the \
             pin leaves.",
        )
}

/// Whether the size of the wheel's speed jumps from zero up as the pin enters and down to zero as it leaves; or the
/// reverse.
fn jumps(stated: Stated, speed: impl Fn(&Wheel, f64, f64) -> f64) -> Finding {
    let sign = stated.pick(1.0, -1.0);
    for_all_stations(
        |wheel| {
            crossings(wheel, &[0.25, 0.5, 0.75]).all(|(ratio, crank)| {
                let size = speed(wheel, ratio, crank).abs();
                let jump = if crank < 0.0 { size } else { -size };
                !vanishes(size) && jump * crank * sign < 0.0
            })
        },
        "the wheel's speed jumps this way as the pin enters such a slot and as it leaves it",
    )
}

fn centre_distance() -> Claim {
    SIMPLE
        .equation("jazar.centre-distance", r"\sqrt{2}r", "centre distance of the four-station wheel")
        .rewritten_and_proven(SIZES_OF_FOUR, equal_to("l"))
}

fn wheel_radius() -> Claim {
    SIMPLE
        .statement(
            "jazar.wheel-radius",
            "outer radius",
            "the outer radius of the four-station wheel is the crank radius",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            same(of(4, Wheel::wheel_radius_ratio), stated.pick(1.0, 2f64.sqrt()))
        })
        .second_route(Evidence::VECTORS, |stated| {
            same(of(4, |wheel| entry(wheel).norm()), stated.pick(1.0, 2f64.sqrt()))
        })
        .but_not("the outer radius is the centre distance")
}

fn sense_of_the_wheel() -> Claim {
    CAPTION
        .figure("jazar.fig-5.28-sense", "counterclockwise", "the star wheel is advanced counterclockwise")
        .first_route(Evidence::JET, |stated| {
            // φ grows while the wheel advances, and the note of part (d) says in which sense it is counted.
            let (said, [phi, _]) = (sense(stated.characters()) * stated.pick(1.0, -1.0), senses_of_the_note());
            for_all_stations(
                |wheel| within(wheel.engagement_half_angle()).all(|t| by_series(wheel, t)[1] * phi * said > 0.0),
                "φ grows in the advance, counted as the note on Fig. 5.29 says",
            )
        })
        .second_route(Evidence::VECTORS, |stated| {
            // The driver turns in the sense in which the note counts θ.
            let (said, [_, theta]) = (sense(stated.characters()) * stated.pick(1.0, -1.0), senses_of_the_note());
            for_all_stations(
                |wheel| {
                    let place = |t: f64| turned_clockwise(wheel, -theta * t);
                    within(wheel.engagement_half_angle()).all(|t| place(t).perp(&place(t + 1e-6)) * said > 0.0)
                },
                "the pin goes round the wheel's axis in this sense while the driver turns as the note on Fig. 5.29 says",
            )
        })
        .but_not("the star wheel is advanced clockwise")
        .interpreted_as(
            "The copy has lost the drawing. By its caption, Fig. 5.29 is the model of this mechanism, and a note in part (d) \
             says in which senses Fig. 5.29 counts its angles. We take the wheel to advance in the sense in which φ \
             grows, because φ is said to vary from −45° to 45° during the advance.",
        )
}

/// Whether a word names the counterclockwise sense, with a plus, or the clockwise one, with a minus; not a number if
/// it names none.
pub(super) fn sense(words: &str) -> f64 {
    match (
        words.contains("CCW") || words.contains("counterclockwise"),
        words.contains("CW") || words.contains("clockwise"),
    ) {
        (true, _) => 1.0,
        (false, true) => -1.0,
        (false, false) => f64::NAN,
    }
}

/// The senses in which φ and θ are positive by these words, as the note of part (d) has them.
pub(super) fn senses_in(words: &str) -> [f64; 2] {
    words.split_once("while").map_or([f64::NAN; 2], |(phi, theta)| [sense(phi), sense(theta)])
}

/// The senses that the note of part (d) prints.
fn senses_of_the_note() -> [f64; 2] {
    senses_in(JAZAR.printed_text("jazar.ex-d.absolute-senses"))
}

fn parts_of_the_cycle() -> Claim {
    CAPTION
        .figure(
            "jazar.fig-5.28",
            "three-quarters of the cycle",
            "a four-station wheel advances for a quarter of the cycle and is locked for three quarters",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            let locked = quarters(stated);
            same(of(4, Wheel::motion_fraction), stated.pick(1.0 - locked, locked))
        })
        .second_route(Evidence::LIMIT_CASE, |stated| {
            let locked = quarters(stated);
            same(of(4, locked_part), stated.pick(locked, 1.0 - locked))
        })
        .but_not("the wheel is locked for a quarter and advances for three quarters")
}

fn speeds_up_then_slows_down() -> Claim {
    MODEL
        .statement(
            "jazar.speeds-up-then-slows-down",
            "smoothly accelerates and then decelerates",
            "the wheel accelerates and then decelerates, smoothly",
        )
        .first_route(Evidence::JET, |stated| {
            let sign = stated.pick(-1.0, 1.0);
            for_all_stations(
                |wheel| {
                    let accelerates = |t: f64| t == 0.0 || by_series(wheel, t)[2] * t * sign > 0.0;
                    let end = wheel.engagement_half_angle();
                    let rests = [-end, end].iter().all(|t| vanishes(by_series(wheel, *t)[1]));
                    rests && within(end).all(accelerates)
                },
                "from rest to rest, φ̈ changes its sign once, at θ = 0",
            )
        })
        .second_route(Evidence::CLOSED_FORM, |stated| {
            for_all_stations(
                |wheel| {
                    let speed = |step: i32| {
                        let crank = wheel.engagement_half_angle() * f64::from(step) / 10.0;
                        wheel.velocity_ratio(crank).unwrap_or(f64::NAN)
                    };
                    let gains = |step: i32| stated.pick(speed(step) > speed(step - 1), speed(step) < speed(step - 1));
                    let loses = |step: i32| stated.pick(speed(step) < speed(step - 1), speed(step) > speed(step - 1));
                    let rests = [-10, 10].iter().all(|step| vanishes(speed(*step)));
                    rests && (-9..=0).all(gains) && (1..=10).all(loses)
                },
                "the speed rises from zero up to θ = 0 and falls to zero from there",
            )
        })
        .but_not("the wheel decelerates and then accelerates")
        .interpreted_as(
            "Smoothly means here that the speed does not jump. The source itself says that the acceleration jumps at \
             both ends.",
        )
}

/// Whether the wheel's angle rises by more than this from each of a hundred places of two turns to the next.
fn never_goes_back(wheel: &Wheel, least: f64) -> bool {
    let reach = wheel.engagement_half_angle();
    let at = |crank: f64| libm::atan2(libm::sin(crank), wheel.centre_distance_ratio() - libm::cos(crank));
    let angle = |step: i32| {
        let (turns, crank) = (step.div_euclid(50), PI * (f64::from(step.rem_euclid(50)) - 25.0) / 25.0);
        f64::from(turns) * (at(reach) - at(-reach)) + at(crank.clamp(-reach, reach))
    };
    (1..100).all(|step| angle(step) - angle(step - 1) > least)
}

/// Centre distances over crank radius, and crank angles at which the pin meets a slot at ±α under an angle: these parts
/// of the greatest that is possible.
fn crossings<'a>(wheel: &Wheel, parts: &'a [f64]) -> impl Iterator<Item = (f64, f64)> + 'a {
    let (alpha, tangent) = (wheel.half_pitch_angle(), wheel.engagement_half_angle());
    parts.iter().flat_map(move |part| {
        // The slot's line passes the driver's axis at the distance k sin α, the cosine of the angle.
        let angle = part * tangent;
        let ratio = libm::cos(angle) / libm::sin(alpha);
        [tangent - angle, tangent + angle, angle - tangent, -tangent - angle].map(|crank| (ratio, crank))
    })
}

/// Part of a turn of the driver in which the wheel is locked, by counting.
pub(super) fn locked_part(wheel: &Wheel) -> f64 {
    let steps = 4000;
    let middles = (0..steps).map(|k| PI * (2.0 * (f64::from(k) + 0.5) / f64::from(steps) - 1.0));
    let locked = middles.filter(|t| wheel.motion(0, *t).is_ok_and(|m| m.phase == Phase::Dwell)).count();
    locked as f64 / f64::from(steps)
}
