//! A wheel of the reader's own: sizes, times, loads, clearance, and the files to make it.

use crate::answer::{Answer, Number};
use crate::control::{Control, File, Live, Preset, Quantity, Settings};
use geneva_dynamics::wheel_loads::WheelLoads;
use geneva_figures::stations;
use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
use geneva_workshop::{Layout, dxf};
use std::f64::consts::TAU;

pub const LIVE: Live = Live {
    name: "design",
    figure: "wheel-dimensions",
    hint: "Choose your stations and your size: pin and play follow, until you move them. Make the pin thicker until it no \
           longer fits. Double the speed: without friction the force of the pin grows fourfold. Move the axes a little apart \
           and see how hard the pin knocks.",
    controls: &[
        Control::slider("stations", "stations N", "", [3.0, 24.0], 1.0, 6.0).typed([3.0, 100.0]),
        Control::slider("pins", "pins", "", [1.0, 4.0], 1.0, 1.0).typed([1.0, 50.0]),
        Control::slider("radius", "crank radius", "mm", [5.0, 100.0], 0.5, 25.0).typed([0.1, 10_000.0]),
        Control::following("pin", "diameter of a pin", "mm", [1.0, 40.0], 0.1).typed([0.001, 10_000.0]),
        Control::following("play", "play", "mm", [0.0, 0.5], 0.01).typed([0.0, 1000.0]),
        Control::slider("speed", "speed of the driver", "rpm", [1.0, 600.0], 1.0, 60.0)
            .typed([0.001, 100_000.0])
            .playing(60.0),
        Control::slider("inertia", "inertia of wheel and table", "kg m²", [0.0, 0.05], 0.0005, 0.002).typed([0.0, 1e6]),
        Control::slider("friction", "friction torque on the wheel", "N m", [0.0, 5.0], 0.05, 0.1).typed([0.0, 1e6]),
        Control::slider("error", "axes too far apart by", "mm", [-1.0, 1.0], 0.01, 0.0).typed([-10_000.0, 10_000.0]),
    ],
    presets: &[
        Preset { name: "six stations", arguments: "stations=6&pins=1&radius=25&pin=&play=&error=0" },
        Preset { name: "eight stations, two pins", arguments: "stations=8&pins=2&radius=20&pin=&play=&error=0" },
        Preset { name: "a pin too thick", arguments: "stations=6&radius=25&pin=20" },
    ],
    given: &[],
    quantities: &[
        Quantity { name: "centres", label: "centre distance" },
        Quantity { name: "wheel", label: "wheel radius, to the pin at entry" },
        Quantity { name: "slot", label: "slot, width × depth" },
        Quantity { name: "disc", label: "radius of the locking disc" },
        Quantity { name: "clearance", label: "least clearance" },
        Quantity { name: "nearer", label: "axes may be too near by" },
        Quantity { name: "farther", label: "axes may be too far apart by" },
        Quantity { name: "index", label: "indexing time" },
        Quantity { name: "dwell", label: "dwell time" },
        Quantity { name: "torque", label: "greatest torque on the wheel" },
        Quantity { name: "force", label: "greatest force of the pin" },
        Quantity { name: "crank", label: "greatest torque at the crank" },
        Quantity { name: "backlash", label: "backlash in mid-dwell" },
        Quantity { name: "greatest", label: "greatest backlash" },
        Quantity { name: "blow", label: "the pin knocks with" },
        Quantity { name: "hardest", label: "with a drifted wheel up to" },
    ],
    others: &[
        Quantity { name: "locking-play", label: "locking play" },
        Quantity { name: "bore-play", label: "bore play" },
        Quantity { name: "slot-bottom-clearance", label: "slot bottom clearance" },
        Quantity { name: "locking-arc-radius", label: "locking arc radius" },
        Quantity { name: "horn-thickness", label: "horn thickness" },
        Quantity { name: "web-between-slots", label: "web between slots" },
        Quantity { name: "crescent-radius", label: "crescent radius" },
        Quantity { name: "crescent-centre-from-driver", label: "crescent centre from the driver's axis" },
        Quantity { name: "wheel-bore-diameter", label: "diameter of the wheel's bore" },
        Quantity { name: "driver-bore-diameter", label: "diameter of the driver's bore" },
    ],
    drag: None,
    files: &[
        File {
            name: "dxf",
            label: "Drawing for the machine (DXF)",
            make: |settings| Ok(dxf(&sizes(settings)?, Layout::Apart)),
        },
        File {
            name: "svg",
            label: "Drawing with sizes (SVG)",
            make: |settings| Ok(stations::dimensions(&sizes(settings)?).standalone()),
        },
    ],
    draw,
};

fn sizes(settings: &Settings) -> Result<Sizes, String> {
    let wheel =
        Wheel::with_pins(settings.count("stations")?, settings.count("pins")?).map_err(|error| error.to_string())?;
    let choices = Choices {
        pin_diameter: settings.moved("pin")?,
        play: settings.moved("play")?.map(Play::of),
        ..Choices::default()
    };
    Sizes::new(wheel, Scale::CrankRadius(settings.value("radius")?), &choices).map_err(|error| error.to_string())
}

/// Crank angles at which the least clearance is looked for, and clearances with the axes apart, each: a tenth of a second.
const ANGLES: u32 = 40_000;
const ANGLES_EACH: u32 = 2_500;

/// What was found, if it was found in time.
fn in_time<T>(found: Result<T, KinematicsError>) -> Result<Option<T>, String> {
    match found {
        Err(KinematicsError::TooManyAngles { .. }) => Ok(None),
        found => found.map(Some).map_err(|error| error.to_string()),
    }
}

/// Decimals of a number that is known to a tolerance, three at most.
fn decimals(tolerance: f64) -> usize {
    [0.0005, 0.005, 0.05].iter().position(|half| tolerance <= *half).map_or(0, |wider| 3 - wider)
}

fn draw(settings: &Settings) -> Result<Answer, String> {
    let sizes = sizes(settings)?;
    let speed = settings.value("speed")? * TAU / 60.0;
    let loads = WheelLoads::new(&sizes.wheel, settings.value("inertia")?, settings.value("friction")?, speed)
        .map_err(|error| error.to_string())?;
    let error = settings.value("error")?;
    let clearance = in_time(sizes.clearance_within(sizes.centre_distance + error, ANGLES))?;
    let nearest = clearance.map(|all| all.least());
    let tolerance = in_time(sizes.centre_tolerance_within(ANGLES_EACH))?;
    let time = |time: Result<f64, KinematicsError>| time.map_err(|error| error.to_string());
    let (index, dwell) = (time(sizes.wheel.indexing_time(speed))?, time(sizes.wheel.dwell_time(speed))?);
    let millimetres = |name, value| Number::new(name, value, 3, "mm");
    let mut numbers = vec![
        millimetres("centres", sizes.centre_distance),
        millimetres("wheel", sizes.wheel_radius),
        Number {
            text: format!("{:.3} × {:.3} mm", sizes.slot_width, sizes.slot_depth),
            ..millimetres("slot", sizes.slot_width)
        },
    ];
    if let Some(disc) = sizes.locking_disc {
        numbers.push(millimetres("disc", disc.radius));
    }
    if let Some((clearance, nearest)) = clearance.zip(nearest) {
        let least = Number::new("clearance", nearest.distance, decimals(clearance.tolerance), "mm");
        let at = nearest.crank_angle.to_degrees().abs();
        numbers.push(Number { text: format!("{} at {at:.1}°", least.text), ..least });
    }
    if let Some(tolerance) = tolerance {
        numbers.push(Number::significant("nearer", tolerance.nearer, 4, "mm"));
        numbers.push(Number::significant("farther", tolerance.farther, 4, "mm"));
    }
    numbers.push(Number::significant("index", index, 4, "s"));
    numbers.push(Number::significant("dwell", dwell, 4, "s"));
    // A moment at the crank radius, which is in millimetres.
    let force = 1000.0 * loads.pin_moment().driving.value / sizes.crank_radius;
    for (name, value, unit) in [
        ("torque", loads.wheel_torque().driving.value, "N m"),
        ("force", force, "N"),
        ("crank", loads.crank_torque().driving.value, "N m"),
    ] {
        numbers.push(Number::significant(name, value, 4, unit));
    }
    // With the axes apart the play is another.
    if let Some(play) = sizes.dwell_play().filter(|_| error == 0.0) {
        let held = match play.held {
            0.0 => "(only there)".to_owned(),
            held => format!("({:.0} % of it)", 100.0 * held),
        };
        let middle = Number::new("backlash", play.middle.to_degrees(), 3, "°");
        numbers.push(Number { text: format!("{} {held}", middle.text), ..middle });
        let greatest = Number::new("greatest", play.greatest.to_degrees(), 3, "°");
        let until = play.until_entry.to_degrees();
        numbers.push(Number { text: format!("{} ({until:.1}° to entry)", greatest.text), ..greatest });
    }
    let message = match sizes.entry(error) {
        Some(entry) => {
            let knock = entry.closing_speed * speed * sizes.crank_radius;
            numbers.push(Number::significant("blow", knock, 3, "mm/s"));
            if let Some(knock) = sizes.knock().filter(|_| error == 0.0) {
                let hardest = knock.drifted * speed * sizes.crank_radius;
                numbers.push(Number::significant("hardest", hardest, 3, "mm/s"));
            }
            let warnings = sizes.warnings().into_iter().map(|warning| format!("Before you make it: {warning}."));
            Some(warnings.collect::<Vec<_>>().join(" ")).filter(|text| !text.is_empty())
        }
        None => Some("With this distance of the axes the pin does not meet the slot.".to_owned()),
    };
    let bites = "With these axes driver and wheel are in each other: a clearance below zero is how deep.";
    let takes_long = "With so little play, some of the clearances take too long to find in a page. The command `geneva wheel` \
                      finds them.";
    let message = match nearest {
        Some(nearest) if nearest.distance < 0.0 => Some(bites.to_owned()),
        _ if clearance.is_none() || tolerance.is_none() => Some(message.unwrap_or_else(|| takes_long.to_owned())),
        _ => message,
    };
    let followers = vec![("pin", sizes.pin_diameter), ("play", sizes.play.slot)];
    let figure = stations::dimensions_on_a_page(&sizes);
    numbers.extend(LIVE.others.iter().filter_map(|of| Some(millimetres(of.name, figure.series.value(of.name)?))));
    Ok(Answer { followers, message, ..Answer::new(figure, numbers) })
}
