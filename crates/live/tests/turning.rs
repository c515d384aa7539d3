//! Does the wheel of the designer turn as its numbers say, and does it jam where a limit is passed?

use geneva_live::{Live, LiveArguments, LiveReply, ToleranceState, TurnedParts};

const SIX: &str = "stations=6&crank-radius=25";
/// Settings that have little in common.
const WHEELS: [&str; 5] = [
    SIX,
    "stations=4&crank-radius=40&play=0.3",
    "stations=3&crank-radius=30",
    "stations=8&pins=2&crank-radius=20",
    "stations=12&crank-radius=60&play=0.1&locking-play=0.2",
];

fn live() -> &'static Live {
    geneva_live::by_name("design").expect("a figure")
}

fn arguments(settings: &str) -> LiveArguments {
    LiveArguments::parse(settings).expect("arguments")
}

fn parts(settings: &str) -> TurnedParts {
    live().turned_parts(&arguments(settings)).expect(settings).expect("parts that turn")
}

fn answer(settings: &str) -> LiveReply {
    live().answer(&arguments(settings)).expect(settings)
}

fn number(settings: &str, name: &str) -> f64 {
    answer(settings).numbers.into_iter().find(|number| number.name == name).expect(name).value
}

#[test]
fn in_mid_index_and_mid_dwell_the_wheel_is_as_free_as_its_sizes_say() {
    for wheel in WHEELS {
        // On the line of centres the pin is c − a from the wheel's axis and has half the play on each side.
        let [centres, crank, play] = ["centres", "crank-radius", "slot-play"].map(|name| number(wheel, name));
        let index = (play / 2.0 / (centres - crank)).asin().to_degrees();
        approx(parts(&format!("{wheel}&crank=0")).half_free, index, 1e-9);
        let pins = if wheel.contains("pins=2") { 2.0 } else { 1.0 };
        let dwell = parts(&format!("{wheel}&crank={}", 180.0 / pins)).half_free;
        approx(dwell, number(wheel, "backlash"), 1e-9);
        // As many times as large as it is asked for.
        approx(parts(&format!("{wheel}&crank=0&larger=7")).half_free, 7.0 * index, 1e-9);
    }
}

fn approx(found: f64, right: f64, within: f64) {
    assert!((found - right).abs() <= within * right.abs().max(1.0), "{found}, {right}");
}

#[test]
fn a_turn_of_the_driver_brings_the_wheel_on_by_a_pitch_for_each_pin() {
    for (wheel, pitch) in [(SIX, 60.0), ("stations=8&pins=2&crank-radius=20", 90.0)] {
        let at = |crank: f64| parts(&format!("{wheel}&crank={crank}")).wheel;
        approx(at(180.0) - at(-180.0), pitch, 1e-9);
        // It goes back no farther than the middle of its play does at the ends of a dwell, and never jumps.
        for half in -360..360 {
            let (before, after) = (at(f64::from(half) / 2.0), at(f64::from(half + 1) / 2.0));
            assert!(after > before - 0.4 && after - before < 2.0, "{wheel}, {half}: {before}, {after}");
        }
    }
}

#[test]
fn a_hand_goes_to_both_ends_of_the_play_and_the_contact_is_on_the_pin() {
    for crank in [-40.0, -10.0, 0.0, 25.0_f64] {
        let at = |turned: i32| parts(&format!("{SIX}&larger=10&crank={crank}&turned={turned}"));
        let [back, middle, forward] = [-100, 0, 100].map(at);
        approx(forward.wheel - middle.wheel, middle.half_free, 1e-9);
        approx(middle.wheel - back.wheel, middle.half_free, 1e-9);
        assert!(middle.contacts.is_empty() && middle.words.contains("free from −"), "{}", middle.words);
        for (parts, side) in [(&forward, "stopped forwards"), (&back, "stopped backwards")] {
            let words = &parts.words;
            assert!(words.contains(side) && words.contains("the pin on the wall"), "{words}");
            let [x, y] = parts.contacts[0];
            // From the drawn pin's centre it is the drawn pin's radius away.
            let (sine, cosine) = crank.to_radians().sin_cos();
            let [pin_x, pin_y] = [parts.centre_distance - 25.0 * cosine, 25.0 * sine];
            let radius = parts.pin_scale * 7.5 / 2.0;
            approx((x - pin_x).hypot(y - pin_y), radius, 1e-9);
            // And on the wall of the drawn slot, whose width is not changed: so far beside the slot's middle.
            let (sine, cosine) = parts.wheel.to_radians().sin_cos();
            approx((y * cosine - x * sine).abs(), number(SIX, "slot") / 2.0, 2e-3);
        }
    }
}

/// Each row of the tolerances: its name, and the error that passes it when it grows.
const LIMITS: [(&str, &str, f64); 6] = [
    ("axes nearer", "centre-error", -1.0),
    ("longer crank", "crank-radius-error", 1.0),
    ("thicker pin, narrower slot", "pin-diameter-error", 1.0),
    ("slot out of direction", "slot-direction-error", 1.0),
    ("slot end farther out", "slot-end-error", 1.0),
    ("larger disc, smaller arc", "locking-disc-error", 1.0),
];

#[test]
fn just_beyond_its_limit_a_size_jams_the_wheel_and_lights_its_row_up_and_just_within_it_turns() {
    for wheel in &WHEELS[..2] {
        let rows = live().tolerance_rows(&arguments(wheel)).expect("rows");
        assert!(rows.iter().all(|row| row.state == ToleranceState::Within && row.set == "–"), "{rows:?}");
        for (name, control, sign) in LIMITS {
            let row = rows.iter().find(|row| row.name == name).expect(name);
            let text: String = row.alone.chars().filter(|sign| sign.is_ascii_digit() || *sign == '.').collect();
            let limit: f64 = text.parse().expect("a number");
            // The text is rounded down, what is sought over a turn to two digits.
            for (times, passed) in [(0.97, false), (1.12, true)] {
                let settings = format!("{wheel}&{control}={}", sign * times * limit);
                let rows = live().tolerance_rows(&arguments(&settings)).expect("rows");
                let row = rows.iter().find(|row| row.name == name).expect(name);
                assert_eq!(row.state == ToleranceState::Beyond, passed, "{settings}: {row:?}");
                let message = answer(&settings).message.expect("a verdict");
                // Axes that are too near touch first where the wheel could still give way.
                let jams = passed && name != "axes nearer";
                assert_eq!(message.contains("the wheel jams"), jams, "{settings}: {message}");
                assert_eq!(message.contains("the wheel still turns"), !jams, "{settings}: {message}");
            }
        }
    }
}

#[test]
fn where_it_jams_parts_overlap_in_the_drawing_and_the_drawing_says_so() {
    let wheel = format!("{SIX}&slot-direction-error=0.2&larger=10");
    let jammed: Vec<f64> = (-360..360)
        .map(|half| f64::from(half) / 2.0)
        .filter(|crank| parts(&format!("{wheel}&crank={crank}")).jams)
        .collect();
    assert!(!jammed.is_empty(), "it turns");
    let parts = parts(&format!("{wheel}&crank={}", jammed[0]));
    assert!(parts.words.contains("It jams here") && parts.words.contains("overlap by"), "{}", parts.words);
    assert_eq!(parts.contacts.len(), 2);
    // Its slots are drawn out of place, so their drawing is another one where they are drawn larger.
    assert_eq!(parts.moved_by, ["crank", "turned"]);
    let drawn = |more: &str| answer(&format!("{SIX}{more}")).figure.svg;
    assert!(drawn("&slot-direction-error=0.2") != drawn("") && drawn("&crank=30&turned=50&larger=9") == drawn(""));
}

#[test]
fn the_command_of_a_setting_leaves_out_what_follows_and_what_is_right() {
    let command = |settings: &str| answer(settings).command.expect("a command");
    let first = command("");
    assert!(first.starts_with("geneva wheel --stations 6 --pins 1 --rpm 60 --crank-radius 25 "), "{first}");
    assert!(
        !first.contains("pin-diameter") && !first.contains("centre-error") && !first.contains("crank-radius-error")
    );
    let other = command("centre-distance=80&pin-diameter=6&centre-error=-0.01&wheel-material=0&larger=5");
    assert!(other.contains(" --centre-distance 80 --") && !other.contains("--crank-radius"), "{other}");
    for given in ["--pin-diameter 6", "--centre-error -0.01", "--wheel-material steel"] {
        assert!(other.contains(given), "{other}");
    }
}

#[test]
fn what_there_is_not_has_an_empty_box() {
    let told = answer("").to_json();
    assert!(told.contains("{\"name\":\"wheel-flat\",\"value\":null}"), "{told}");
    assert!(told.contains("{\"name\":\"pin-diameter\",\"value\":7.5}"), "{told}");
}
