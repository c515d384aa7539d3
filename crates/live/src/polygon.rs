//! The vector diagrams of the quick-return mechanism.

use crate::answer::{LiveNumber, LiveQuantity, LiveReply, round_for_box};
use crate::control::{Control, Live, PointerDrag, Preset, Settings, TURNS};
use crate::pin::{LENGTHS, UNITS, unit};
use geneva_ask::Error;
use geneva_ask::quick_return::{LinkageAngle, QuickReturnDesign, QuickReturnQuestion, lever_motion};
use geneva_ask::worked::{AngleOrigin, DriverSpeed};
use geneva_figures::{quick_return, with_minus_sign};
use geneva_kinematics::quick_return::{Branch, LeverMotion};

/// Options of the command, and the controls that are the same.
const WORDS: [(&str, &str); 6] = [
    ("--lever-angle", "lever angle"),
    ("--crank-angle", "crank angle"),
    ("--branch near", "near point"),
    ("--branch far", "the far point"),
    ("--ground", "axes apart by"),
    ("--crank", "a crank of"),
];

pub const LIVE: Live = Live {
    name: "polygon",
    module: "live",
    figure: "live-polygon",
    hint: "Type the numbers of your own problem: two lengths, a speed, and one of the angles. Or set the factor of φ̇ vᵣₑₗ to \
           1 or 3: the polygon stays open, except where the Coriolis acceleration is zero.",
    controls: &[
        Control::slider("crank", "crank angle θ from the line of centres", "°", [-180.0, 180.0], 0.1, -120.0)
            .with_typed_range(TURNS)
            .playing(30.0)
            .on_side("angle", 0),
        Control::number("direction", "or from the direction O₄O₂, 180° + θ", "°", TURNS, 0.0).on_side("angle", 1),
        Control::number("lever", "or lever angle φ", "°", TURNS, 0.0).on_side("angle", 2),
        Control::choice("branch", "with the pin", &["at the far point of the lever’s ray", "at the near point"], 0)
            .on_side("angle", 2),
        Control::number("ground", "distance l of the axes", "", LENGTHS, 0.3),
        Control::number("radius", "crank radius R", "", LENGTHS, 0.1),
        Control::choice("unit", "unit of length", &UNITS, 2),
        Control::number("rpm", "speed of the crank", "rpm", [-1e6, 1e6], 60.0).on_side("speed", 0),
        Control::number("speed", "or in radians a second", "rad/s", [-1e5, 1e5], 0.0).on_side("speed", 1),
        Control::number("factor", "factor of φ̇ vᵣₑₗ in the Coriolis term", "", [-10.0, 10.0], 2.0),
    ],
    presets: &[
        Preset::new("forgotten: 0", "factor=0"),
        Preset::new("half of it: 1", "factor=1"),
        Preset::new("right: 2", "factor=2"),
        Preset::new("too much: 3", "factor=3"),
    ],
    given: &[],
    quantities: &[
        LiveQuantity::field("lever-acceleration", "lever's angular acceleration φ̈", "lever_acceleration_rad_s2"),
        LiveQuantity::field("lever-speed", "lever's angular velocity φ̇", "lever_speed_rad_s"),
        LiveQuantity::new("coriolis", "Coriolis acceleration |2 φ̇ vᵣₑₗ|"),
        LiveQuantity::new("sliding", "sliding velocity vᵣₑₗ, outwards"),
        LiveQuantity::new("gap", "gap of the acceleration polygon"),
        LiveQuantity::new("closed", "φ̈ if you close it with this factor"),
    ],
    others: &[],
    drag: Some(PointerDrag { control: "crank", at_right: -180.0, sense: 1.0 }),
    files: &[],
    turned: None,
    tolerances: None,
    beat: None,
    draw,
};

/// The mechanism of these settings: by the lever's angle where the reader has moved that, and by the crank's elsewhere.
fn design(settings: &Settings) -> Result<QuickReturnDesign, String> {
    let (ground, crank, speed) = (settings.value("ground")?, settings.value("radius")?, speed(settings)?);
    if speed.value() == 0.0 {
        return Err("the crank must turn, or nothing moves: give a speed that is not 0".to_owned());
    }
    let branch = if settings.value_if_moved("branch")? == Some(1.0) { Branch::Near } else { Branch::Far };
    let lever = settings.value_if_moved("lever")?;
    let degrees = match settings.value_if_moved("direction")? {
        Some(direction) => direction,
        None => settings.value_if_moved("crank")?.unwrap_or(LIVE.controls[0].preset) + 180.0,
    };
    let place = lever.map_or(LinkageAngle::Crank(degrees), |lever| LinkageAngle::Lever(lever, branch));
    QuickReturnDesign::new(&QuickReturnQuestion { ground, crank, place, speed }).map_err(|error| match (error, place) {
        (_, LinkageAngle::Crank(degrees)) => {
            let theta = with_minus_sign(&round_for_box(degrees - 180.0).to_string());
            format!("crank angle {theta}°: the pin is on the lever's pivot, or too near it; give another angle")
        }
        (Error::Argument(message), _) => {
            WORDS.iter().fold(message, |message, (option, words)| message.replace(option, words))
        }
        (other, _) => other.to_string(),
    })
}

/// The speed of these settings, in the unit in which the reader gave it.
fn speed(settings: &Settings) -> Result<DriverSpeed, String> {
    Ok(match settings.value_if_moved("speed")? {
        Some(speed) => DriverSpeed::RadiansPerSecond(speed),
        None => DriverSpeed::Rpm(settings.value("rpm")?),
    })
}

fn draw(settings: &Settings) -> Result<LiveReply, String> {
    let (design, unit, speed) = (design(settings)?, unit(settings)?, speed(settings)?);
    let QuickReturnDesign { linkage, position, drive, .. } = &design;
    let origin = if settings.value_if_moved("direction")?.is_some() {
        AngleOrigin::Extension
    } else {
        AngleOrigin::LineOfCentres
    };
    let steps = design.steps(unit, origin).map_err(|error| error.to_string())?;
    let factor = settings.value("factor")?;
    let motion = LeverMotion::new(&linkage.ground(), &linkage.crank(), &position.crank, drive)
        .ok_or("these numbers are too large or too small to compute with: give others")?;
    let mut figure = quick_return::polygons(linkage, position, drive, factor, unit.name());
    // The last row of the series is the gap, its last column the size of it.
    let gap = figure.series.rows.last().and_then(|row| row.last()).copied().unwrap_or(f64::NAN);
    let coriolis = motion.accelerations.coriolis.norm();
    let sliding = motion.velocities.sliding_velocity.dot(&position.lever.direction());
    let (turning, right) = (motion.velocities.follower_speed, motion.accelerations.follower_acceleration);
    // What is missing of the Coriolis term across the lever, the lever's tangential acceleration gets.
    let closed = right + (2.0 - factor) * turning * sliding / position.pin_distance;
    let closed = LiveNumber::significant("closed", closed, 4, "rad/s²");
    // A lever that turns round and round has only one point on its ray.
    let is_near = linkage.ratio() > 1.0 && position.branch() == Branch::Near;
    let (far, branch) = if is_near { ("near", 1.0) } else { ("far", 0.0) };
    let length = unit.name();
    let (lever, theta) = (position.lever.degrees(), position.crank.degrees());
    if factor != 2.0 {
        figure.caption += &format!(" If you close it with this factor, you get φ̈ = {}.", closed.text);
    }
    figure.caption += &format!(
        " Shown: axes {}\u{a0}{length} apart, a crank of {}\u{a0}{length} at {}\u{a0}{}, and the lever at φ = {}, with the pin at the \
         {far} point.",
        round_for_box(linkage.ground()),
        round_for_box(linkage.crank()),
        with_minus_sign(&round_for_box(speed.value()).to_string()),
        speed.unit(),
        LiveNumber::new("lever", lever, 1, "°").text,
    );
    let of_lever = ["lever-speed", "lever-acceleration"].into_iter().zip(lever_motion(&motion));
    let numbers = [LiveNumber::significant("gap", gap, 4, unit.acceleration())]
        .into_iter()
        .chain(of_lever.filter_map(|(name, field)| LiveNumber::from_field(name, &field)))
        .chain([
            closed,
            LiveNumber::significant("sliding", sliding, 4, unit.speed()),
            LiveNumber::significant("coriolis", coriolis, 4, unit.acceleration()),
        ]);
    let theta = if theta > 0.0 { theta - 180.0 } else { theta + 180.0 };
    let followers = vec![
        ("crank", theta),
        ("direction", theta + 180.0),
        ("lever", lever),
        ("branch", branch),
        ("rpm", speed.rpm()),
        ("speed", speed.radians_per_second()),
    ];
    Ok(LiveReply { followers, steps, ..LiveReply::new(figure, numbers) })
}

#[cfg(test)]
mod tests {
    use super::LIVE;
    use crate::{LiveArguments, LiveReply};

    fn answer(query: &str) -> Result<LiveReply, String> {
        LIVE.answer(&LiveArguments::parse(query).expect("a query"))
    }

    /// The texts of some numbers, and the caption.
    fn told(query: &str, names: &[&str]) -> (Vec<String>, String) {
        let answer = answer(query).expect("an answer");
        let text = |name: &&str| answer.numbers.iter().find(|number| number.name == *name).expect("told").text.clone();
        (names.iter().map(text).collect(), answer.figure.caption)
    }

    #[test]
    fn a_problem_of_ones_own_has_the_numbers_that_were_found_without_this_program() {
        let names = ["lever-speed", "sliding", "coriolis", "lever-acceleration", "closed"];
        let own = "ground=0.28&radius=0.12&rpm=60&lever=18";
        let (far, caption) = told(own, &names);
        assert_eq!(far[..3], ["1.495 rad/s", "−0.5437 m/s", "1.626 m/s²"]);
        assert_eq!(far[3..], ["−5.123 rad/s²", "−5.123 rad/s²"]);
        assert!(caption.contains("0.28\u{a0}m apart, a crank of 0.12\u{a0}m at 60\u{a0}rpm"), "{caption}");
        assert!(caption.contains("φ = 18.0°, with the pin at the far point"), "{caption}");
        let (near, caption) = told(&format!("{own}&branch=1"), &names);
        assert_eq!([&near[0], &near[3]], ["−2.852 rad/s", "−35.59 rad/s²"]);
        assert!(caption.contains("at the near point"), "{caption}");
        let (wrong, caption) = told(&format!("{own}&factor=1"), &names);
        assert_eq!(wrong[3..], ["−5.123 rad/s²", "−7.449 rad/s²"]);
        assert!(caption.contains("you get φ̈ = −7.449 rad/s²"), "{caption}");
    }

    #[test]
    fn either_angle_gives_the_other_and_the_point_of_the_pin() {
        for query in ["lever=18", "lever=18&branch=1", "lever=-7&rpm=-20", "lever=140&radius=0.5"] {
            let LiveReply { figure, followers, .. } = answer(query).expect("an answer");
            let crank = followers.iter().find(|(name, _)| *name == "crank").expect("told").1;
            let rpm = query.split('&').find(|pair| pair.starts_with("rpm")).unwrap_or("rpm=60");
            let radius = query.split('&').find(|pair| pair.starts_with("radius")).unwrap_or("radius=0.1");
            let again = answer(&format!("crank={crank}&{rpm}&{radius}")).expect("an answer");
            for ((name, one), (_, other)) in followers.iter().zip(&again.followers) {
                assert!((one - other).abs() < 1e-9, "{query}: {name} {one} {other}");
            }
            assert_eq!(figure.caption, again.figure.caption);
        }
    }

    #[test]
    fn what_is_impossible_is_told_in_the_words_of_the_controls() {
        for (query, words) in [
            ("lever=40", "lever angle 40 is out of reach: with axes apart by 0.3 and a crank of 0.1 the lever swings"),
            ("lever=4&branch=1&radius=0.4", "near point: with a crank of 0.4, which is at least as long"),
            ("rpm=0", "the crank must turn"),
            ("ground=0.3&radius=0.3&crank=0", "crank angle 0°: the pin is on the lever's pivot, or too near it"),
            ("ground=0", "distance l of the axes 0: give 0.0001 to 100000"),
        ] {
            let why = answer(query).expect_err("impossible");
            assert!(why.contains(words) && !why.contains("--"), "{query}: {why}");
        }
    }

    #[test]
    fn lengths_and_speeds_all_over_their_ranges_are_drawn_or_refused() {
        for ground in ["0.0001", "0.28", "1e4"] {
            for radius in ["0.0001", "0.28", "1e4"] {
                for rpm in ["-1e6", "1e-30", "1e6"] {
                    for angle in ["crank=-63.3", "crank=0", "crank=180", "lever=0.001", "lever=90", "lever=179"] {
                        let query = format!("ground={ground}&radius={radius}&rpm={rpm}&{angle}");
                        if let Ok(answer) = answer(&query) {
                            assert!(
                                !answer.figure.svg.contains("NaN") && !answer.figure.svg.contains("inf"),
                                "{query}"
                            );
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn indices_are_set_as_indices() {
        let labels = LIVE.controls.iter().map(|control| control.label).chain(LIVE.quantities.iter().map(|of| of.label));
        let with_index: Vec<&str> = labels.filter(|label| label.contains("rel") || label.contains("ᵣₑₗ")).collect();
        assert_eq!(
            with_index,
            [
                "factor of φ̇ vᵣₑₗ in the Coriolis term",
                "Coriolis acceleration |2 φ̇ vᵣₑₗ|",
                "sliding velocity vᵣₑₗ, outwards"
            ]
        );
    }
}
