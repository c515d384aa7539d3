//! A pin in the slot of a wheel, with the reader's own numbers and every step of the solution.

use crate::answer::{LiveNumber, LiveQuantity, LiveReply, round_for_box};
use crate::control::{Control, Live, PointerDrag, Preset, Settings, TURNS};
use geneva_ask::pin::{AxisDistance, PinDesign, PinQuestion};
use geneva_ask::worked::{AngleOrigin, DriverSpeed, LengthUnit};
use geneva_figures::pin::velocities_at_the_pin;
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::PinSlot;
use std::f64::consts::PI;

/// Lengths that can be typed, in any unit.
pub(crate) const LENGTHS: [f64; 2] = [1e-4, 1e5];
/// Symbols of the units of length, to choose from.
pub(crate) const UNITS: [&str; 5] = {
    let [a, b, c, d, e] = LengthUnit::ALL;
    [a.name(), b.name(), c.name(), d.name(), e.name()]
};

/// Options of the command, and the controls that are the same.
const WORDS: [(&str, &str); 3] = [
    ("--centre-distance ", "centre distance l "),
    ("--crank-radius ", "crank radius R, "),
    ("--stations ", "slots N: "),
];

pub const LIVE: Live = Live {
    name: "pin",
    module: "live",
    figure: "live-pin",
    hint: "Type the numbers of your own problem: crank radius, centre distance or number of slots, crank angle and speed. \
           Each pair of boxes says the same in two ways, and you fill in one of them.",
    controls: &[
        Control::slider("theta", "crank angle θ from the line of centres", "°", [-180.0, 180.0], 0.5, -30.0)
            .with_typed_range(TURNS)
            .playing(40.0)
            .on_side("angle", 0),
        Control::number("extension", "or from the extension of OB", "°", TURNS, 0.0).on_side("angle", 1),
        Control::number("radius", "crank radius R", "", LENGTHS, 50.0),
        Control::number("stations", "slots N", "", [3.0, 100.0], 4.0).on_side("axes", 0),
        Control::number("centres", "or centre distance l", "", LENGTHS, 0.0).on_side("axes", 1),
        Control::choice("unit", "unit of length", &UNITS, 0),
        Control::number("speed", "speed of the driver", "rad/s", [1e-6, 1e6], 10.0).on_side("speed", 0),
        Control::number("rpm", "or in turns a minute", "rpm", [1e-6, 1e7], 0.0).on_side("speed", 1),
    ],
    presets: &[Preset::new("six slots", "stations=6"), Preset::new("pin on the line of centres", "theta=0")],
    given: &[],
    quantities: &[
        LiveQuantity::field("wheel-speed", "wheel’s velocity φ̇", "wheel_speed_rad_s"),
        LiveQuantity::field("sliding", "sliding velocity, inwards", "sliding_speed"),
        LiveQuantity::field("acceleration", "wheel’s acceleration φ̈", "wheel_acceleration_rad_s2"),
        LiveQuantity::field("distance", "distance r of pin and O", "pin_distance"),
    ],
    others: &[],
    drag: Some(PointerDrag { control: "theta", at_right: 180.0, sense: 1.0 }),
    files: &[],
    turned: None,
    tolerances: None,
    beat: None,
    draw,
};

/// The question of these settings: of each pair the one that the reader filled in last.
fn question(settings: &Settings) -> Result<PinQuestion, String> {
    let moved = |name| settings.value_if_moved(name);
    let (origin, angle) = match moved("extension")? {
        Some(angle) => (AngleOrigin::Extension, angle),
        None => (AngleOrigin::LineOfCentres, settings.value("theta")?),
    };
    let axes = match moved("centres")? {
        Some(length) => AxisDistance::Length(length),
        None => AxisDistance::Stations(settings.count("stations")?),
    };
    let speed = match moved("rpm")? {
        Some(rpm) => DriverSpeed::Rpm(rpm),
        None => DriverSpeed::RadiansPerSecond(settings.value("speed")?),
    };
    Ok(PinQuestion { crank_radius: settings.value("radius")?, axes, angle, origin, speed, unit: unit(settings)? })
}

/// The unit of length of these settings.
pub(crate) fn unit(settings: &Settings) -> Result<LengthUnit, String> {
    Ok(LengthUnit::ALL.get(settings.choice("unit")?).copied().unwrap_or(LengthUnit::Millimetre))
}

/// Crank radii between the axes up to which the wheel has so few slots that they can be drawn.
const FARTHEST: f64 = 32.0;

fn draw(settings: &Settings) -> Result<LiveReply, String> {
    let question = question(settings)?;
    if let AxisDistance::Length(length) = question.axes
        && length > FARTHEST * question.crank_radius
    {
        return Err(format!(
            "centre distance l {}: give at most {FARTHEST} crank radii, {}; the slots of a larger wheel cannot be drawn",
            round_for_box(length),
            round_for_box(FARTHEST * question.crank_radius)
        ));
    }
    let theta = question.origin.from_line_of_centres(question.angle);
    let reply = match PinDesign::new(&question) {
        Ok(design) => solved(&design, &question),
        Err(error) => at_rest(&question, theta).ok_or_else(|| in_words(error.to_string()))?,
    };
    let centres = reply.1.centre_distance();
    let stations = 180.0 / libm::asin(question.crank_radius / centres).to_degrees();
    let followers = vec![
        ("theta", theta),
        ("extension", theta + 180.0),
        ("stations", stations),
        ("centres", centres),
        ("speed", question.speed.radians_per_second()),
        ("rpm", question.speed.rpm()),
    ];
    Ok(LiveReply { followers, ..reply.0 })
}

/// The answers and the steps while the pin is in its slot.
fn solved(design: &PinDesign, question: &PinQuestion) -> (LiveReply, PinSlot) {
    let answer = design.answer();
    let mut figure = drawing(&design.mechanism, design.theta, question);
    let [turning, sliding, acceleration] =
        [design.turning_in_words(), design.sliding_in_words(), design.acceleration_in_words()];
    figure.caption +=
        &format!(" The wheel’s speed: {turning}. Its acceleration: {acceleration}. The sliding: {sliding}.");
    let numbers = LIVE.quantities.iter().filter_map(|of| {
        let field = of.key.and_then(|key| answer.field(key))?;
        // Signed, where a sheet has the size and the direction in words.
        LiveNumber::from_field(of.name, field)
    });
    let reply = LiveReply { steps: design.steps(), ..LiveReply::new(figure, numbers) };
    (reply, design.mechanism)
}

/// The wheel at rest while the pin is outside of its slots, if the rest of the question is possible.
fn at_rest(question: &PinQuestion, theta: f64) -> Option<(LiveReply, PinSlot)> {
    let on_the_line = PinQuestion { angle: 0.0, origin: AngleOrigin::LineOfCentres, ..*question };
    let mechanism = PinDesign::new(&on_the_line).ok()?.mechanism;
    let half = mechanism.engagement_half_angle().to_degrees();
    let figure = drawing(&mechanism, theta, question);
    let ends = round_for_box(half);
    let message = format!(
        "The wheel stands still: the pin is in a slot from θ = −{ends}° to {ends}° only, so there are no steps to show for this angle."
    );
    let numbers = [LiveNumber::new("wheel-speed", 0.0, 0, "rad/s"), LiveNumber::new("acceleration", 0.0, 0, "rad/s²")];
    Some((LiveReply { message: Some(message), ..LiveReply::new(figure, numbers) }, mechanism))
}

fn drawing(mechanism: &PinSlot, theta: f64, question: &PinQuestion) -> geneva_figures::Figure {
    let crank = Turn::from_radians(theta.to_radians() + PI);
    velocities_at_the_pin(mechanism, &crank, question.speed.radians_per_second(), question.unit.speed())
}

/// A refusal in the words of the controls.
fn in_words(message: String) -> String {
    WORDS.iter().fold(message, |message, (option, words)| message.replace(option, words))
}

#[cfg(test)]
mod tests {
    use super::LIVE;
    use crate::{LiveArguments, LiveReply};

    fn answer(query: &str) -> Result<LiveReply, String> {
        LIVE.answer(&LiveArguments::parse(query).expect("a query"))
    }

    #[test]
    fn each_pair_of_boxes_says_the_same() {
        let one = answer("theta=-20&radius=40&stations=6&rpm=60").expect("an answer");
        let of = |name: &str| one.followers.iter().find(|(known, _)| *known == name).expect("a follower").1;
        assert_eq!((of("extension"), of("rpm")), (160.0, 60.0));
        let query = format!("extension=160&radius=40&centres={}&speed={}", of("centres"), of("speed"));
        let other = answer(&query).expect("an answer");
        for (name, value) in &one.followers {
            let theirs = other.followers.iter().find(|(known, _)| known == name).expect("a follower").1;
            assert!((theirs - value).abs() < 1e-9, "{name}: {value} {theirs}");
        }
        assert_eq!(one.numbers[0].text, other.numbers[0].text);
    }

    #[test]
    fn outside_of_the_slots_the_wheel_rests_and_there_are_no_steps() {
        let inside = answer("theta=-44").expect("an answer");
        let outside = answer("theta=-46").expect("an answer");
        assert!(inside.steps.len() == 7 && inside.message.is_none());
        assert!(outside.steps.is_empty() && outside.message.is_some_and(|words| words.contains("−45° to 45° only")));
        assert_eq!(outside.numbers[0].text, "0 rad/s");
    }

    #[test]
    fn what_is_impossible_is_told_in_the_words_of_the_controls() {
        for (query, words) in [
            ("radius=40&centres=40", "give more than crank radius R, 40"),
            ("stations=2", "slots N 2: give 3 to 100"),
            ("stations=4.5", "4.5"),
            ("speed=0", "speed of the driver 0 rad/s: give"),
            ("radius=2&centres=100000", "give at most 32 crank radii, 64"),
        ] {
            let why = answer(query).expect_err("impossible");
            assert!(why.contains(words) && !why.contains("--"), "{query}: {why}");
        }
    }

    #[test]
    fn numbers_all_over_their_ranges_are_answered_or_refused() {
        for radius in ["0.0001", "37.5", "1e5"] {
            for axes in ["stations=3", "stations=100", "centres=0.00011", "centres=1e5"] {
                for angle in ["theta=-90", "theta=0.001", "extension=179", "theta=1e6"] {
                    for speed in ["speed=0.000001", "rpm=1e7"] {
                        let query = format!("radius={radius}&{axes}&{angle}&{speed}&unit=4");
                        if let Ok(answer) = answer(&query) {
                            assert!(!answer.figure.svg.contains("NaN"), "{query}");
                        }
                    }
                }
            }
        }
    }
}
