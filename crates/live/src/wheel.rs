//! The wheel, at the right distance of its axes or another.

use crate::answer::{LiveNumber, LiveQuantity, LiveReply, round_for_box};
use crate::control::{Control, Live, PointerDrag, Preset, Settings};
use geneva_figures::stations;
use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::{MisplacedWheel, Wheel};

pub const LIVE: Live = Live {
    name: "wheel",
    module: "live",
    figure: "live-wheel",
    hint: "Move the axes apart by one per cent: the wheel's velocity no longer begins at zero, and the pin enters with \
           a blow. At the right distance the blow is gone.",
    controls: &[
        Control::slider("crank", "crank angle θ", "°", [-180.0, 180.0], 0.5, -30.0).playing(45.0),
        Control::slider("stations", "stations N", "", [3.0, 24.0], 1.0, 4.0).with_typed_range([3.0, 100.0]),
        Control::slider("pins", "pins", "", [1.0, 6.0], 1.0, 1.0).with_typed_range([1.0, 50.0]),
        Control::slider("error", "centre distance wrong by", "%", [-5.0, 5.0], 0.1, 0.0)
            .with_typed_range([-50.0, 50.0]),
    ],
    presets: &[
        Preset::new("four slots", "stations=4&pins=1&error=0&crank=-30"),
        Preset::new("eight slots, two pins", "stations=8&pins=2&error=0&crank=-40"),
        Preset::new("axes 1 % too far apart", "error=1"),
        Preset::new("axes 1 % too near", "error=-1"),
    ],
    given: &[],
    quantities: &[
        LiveQuantity::new("blow", "blow: jump of the velocity ratio at entry"),
        LiveQuantity::new("velocity", "velocity ratio"),
        LiveQuantity::new("acceleration", "acceleration ratio"),
        LiveQuantity::new("jerk", "jerk ratio"),
        LiveQuantity::new("sliding", "sliding over pin speed, inwards"),
        LiveQuantity::new("angle", "wheel angle φ"),
        LiveQuantity::new("index", "turn of the wheel for each pin"),
    ],
    others: &[],
    drag: Some(PointerDrag { control: "crank", at_right: 180.0, sense: -1.0 }),
    files: &[],
    turned: None,
    tolerances: None,
    beat: None,
    draw,
};

fn draw(settings: &Settings) -> Result<LiveReply, String> {
    let wheel =
        Wheel::with_pins(settings.count("stations")?, settings.count("pins")?).map_err(|error| error.to_string())?;
    let (error, crank) = (settings.value("error")? / 100.0, settings.value("crank")?.to_radians());
    let misplaced = MisplacedWheel::new(&wheel, error).map_err(|error| match error {
        KinematicsError::Misplaced { asked, least, most } => format!(
            "centre distance wrong by {} %: the pin meets its slot from {:.2} % to {:.2} %; give a number between them",
            round_for_box(100.0 * asked),
            100.0 * least,
            100.0 * most
        ),
        other => other.to_string(),
    })?;
    let figure = stations::running(&misplaced, crank).map_err(|error| error.to_string())?;
    let motion = misplaced.motion(crank).map_err(|error| error.to_string())?;
    // As in the chapter on the pin, towards the wheel's axis.
    let sliding = misplaced.sliding_ratio(crank).map_err(|error| error.to_string())?;
    let numbers = [
        LiveNumber::new("blow", misplaced.entry_velocity_ratio(), 4, ""),
        LiveNumber::new("velocity", motion.velocity, 4, ""),
        LiveNumber::new("acceleration", motion.acceleration, 4, ""),
        LiveNumber::new("jerk", motion.jerk, 3, ""),
        LiveNumber::new("angle", motion.angle.to_degrees(), 2, "°"),
        LiveNumber::new("index", misplaced.index_angle().to_degrees(), 2, "°"),
    ];
    let sliding = sliding.map(|outwards| LiveNumber::new("sliding", -outwards, 4, ""));
    Ok(LiveReply::new(figure, numbers.into_iter().chain(sliding)))
}

#[cfg(test)]
mod tests {
    use super::LIVE;
    use crate::LiveArguments;

    fn sliding(crank: &str) -> Option<f64> {
        let arguments = LiveArguments::from_pairs([("crank", crank.to_owned())]);
        let answer = LIVE.answer(&arguments).expect("an answer");
        answer.numbers.iter().find(|number| number.name == "sliding").map(|number| number.value)
    }

    #[test]
    fn the_pin_slides_in_before_the_line_of_centres_and_out_after_it() {
        // √2 sin 20° / √(3 − 2 √2 cos 20°) by hand.
        let at_twenty = sliding("-20").expect("a pin");
        assert!((at_twenty - 0.826_912).abs() < 1e-6, "{at_twenty}");
        assert_eq!(sliding("20"), Some(-at_twenty));
        assert_eq!((sliding("0"), sliding("-60")), (Some(0.0), None));
    }
}
