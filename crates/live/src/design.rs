//! A wheel of the reader's own: sizes, times, loads, clearance, and the files to make it.

use crate::answer::{self, Answer, Number};
use crate::control::{Control, File, Kind, Live, Preset, Quantity, Settings};
use geneva_ask::Error;
use geneva_ask::wheel::{Design, Effort, Question};
use geneva_dynamics::line_contact::MATERIALS;
use geneva_dynamics::wheel_loads::WheelLoads;
use geneva_figures::stations;
use geneva_kinematics::wheel::{Contact, Sizes, Wheel};

pub const LIVE: Live = Live {
    name: "design",
    figure: "wheel-dimensions",
    hint: "Choose the number of stations and the size. Pin, play and shafts adjust themselves until you set them by \
           hand. Make the pin thicker until it no longer fits. Double the speed: without friction the force of the pin \
           grows fourfold. Move the axes apart by 0.02 mm, and the pin knocks less hard. At 0.06 mm it meets a corner \
           of its slot.",
    controls: &[
        Control::slider("stations", "stations N", "", [3.0, 24.0], 1.0, 6.0).typed([3.0, 100.0]),
        Control::slider("pins", "pins", "", [1.0, 4.0], 1.0, 1.0).typed([1.0, 50.0]),
        Control::slider("radius", "crank radius", "mm", [5.0, 100.0], 0.5, 25.0).typed([0.1, 10_000.0]),
        Control::following("pin", "diameter of a pin", "mm", [1.0, 40.0], 0.1).typed([0.001, 10_000.0]),
        Control::following("play", "play of slot and locking arc", "mm", [0.0, 0.5], 0.01).typed([0.0, 1000.0]),
        Control::slider("speed", "speed of the driver", "rpm", [1.0, 600.0], 1.0, 60.0).typed([0.001, 100_000.0]),
        Control::slider("inertia", "inertia of wheel and table", "kg m²", [0.0, 0.05], 0.0005, 0.002).typed([0.0, 1e6]),
        Control::slider("friction", "friction torque on the wheel", "N m", [0.0, 5.0], 0.05, 0.1).typed([0.0, 1e6]),
        Control::slider("error", "axes too far apart by", "mm", [-1.0, 1.0], 0.01, 0.0).typed([-10_000.0, 10_000.0]),
        Control::following("wheel-shaft", "diameter of the wheel's shaft", "mm", [1.0, 100.0], 0.5)
            .typed([0.001, 10_000.0]),
        Control::following("bore-play", "play of the bores", "mm", [0.0, 0.2], 0.001).typed([0.0, 1000.0]),
        Control::slider("thickness", "thickness of the wheel", "mm", [1.0, 50.0], 0.5, 10.0).typed([0.001, 10_000.0]),
        Control::choice("material", "the wheel is made of", &OF, 3),
    ],
    presets: &[
        Preset {
            name: "six stations",
            arguments: "stations=6&pins=1&radius=25&pin=&play=&speed=60&inertia=0.002&friction=0.1&error=0&wheel-shaft=&\
                        bore-play=&thickness=10&material=3",
        },
        Preset {
            name: "eight stations, two pins",
            arguments: "stations=8&pins=2&radius=20&pin=&play=&speed=60&inertia=0.002&friction=0.1&error=0&wheel-shaft=&\
                        bore-play=&thickness=10&material=3",
        },
        Preset {
            name: "a pin too thick",
            arguments: "stations=6&pins=1&radius=25&pin=20&play=&speed=60&inertia=0.002&friction=0.1&error=0&wheel-shaft=&\
                        bore-play=&thickness=10&material=3",
        },
    ],
    given: &[],
    quantities: &[
        Quantity { name: "centres", label: "centre distance" },
        Quantity { name: "clearance", label: "least clearance" },
        Quantity { name: "nearer", label: "axes may be too close together by" },
        Quantity { name: "farther", label: "axes may be too far apart by" },
        Quantity { name: "index", label: "indexing time" },
        Quantity { name: "dwell", label: "dwell time" },
        Quantity { name: "torque", label: "greatest torque on the wheel" },
        Quantity { name: "force", label: "greatest force of the pin" },
        Quantity { name: "crank", label: "greatest torque at the crank" },
        Quantity { name: "rms", label: "RMS torque at the crank" },
        Quantity { name: "power", label: "greatest power" },
        Quantity { name: "backlash", label: "backlash in mid-dwell" },
        Quantity { name: "greatest", label: "greatest backlash, to one side" },
        Quantity { name: "blow", label: "knock of the pin at entry" },
        Quantity { name: "hardest", label: "knock after the greatest backlash" },
    ],
    others: &[
        Quantity { name: "mean", label: "mean torque at the crank" },
        Quantity { name: "own", label: "the wheel's own part of the inertia" },
        Quantity { name: "pressure", label: "contact pressure of a steel pin" },
        Quantity { name: "where", label: "the least clearance is" },
        Quantity { name: "held", label: "mid-dwell backlash holds for" },
        Quantity { name: "before", label: "greatest backlash is before entry by" },
        Quantity { name: "wheel", label: "wheel radius, to the pin at entry" },
        Quantity { name: "slot", label: "slot, width × depth" },
        Quantity { name: "disc", label: "radius of the locking disc" },
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
            make: |settings| design(settings)?.dxf().map_err(words),
        },
        File {
            name: "svg",
            label: "Drawing with sizes (SVG)",
            make: |settings| {
                let design = design(settings)?;
                Ok(stations::dimensions(design.sizes.as_ref().ok_or(NO_SIZES)?).standalone())
            },
        },
        File { name: "csv", label: "These numbers (CSV)", make: numbers_file },
    ],
    draw,
};

/// Materials of the wheel, as they are called and in the order of [`MATERIALS`].
const OF: [&str; 5] = ["steel", "stainless steel", "cast iron", "phosphor bronze", "acetal"];

/// The wheel of these settings, whose clearances are looked for no longer than a tenth of a second.
fn design(settings: &Settings) -> Result<Design, String> {
    let wall = *MATERIALS.get(settings.choice("material")?).ok_or("no such material")?;
    let question = Question {
        stations: Some(settings.count("stations")?),
        pins: Some(settings.count("pins")?),
        crank_radius: Some(settings.value("radius")?),
        pin_diameter: settings.moved("pin")?,
        play: settings.moved("play")?,
        bore_play: settings.moved("bore-play")?,
        wheel_shaft: settings.moved("wheel-shaft")?,
        rpm: Some(settings.value("speed")?),
        inertia: Some(settings.value("inertia")?),
        friction_torque: Some(settings.value("friction")?),
        thickness: Some(settings.value("thickness")?),
        pin_material: Some(MATERIALS[0]),
        wheel_material: Some(wall),
        centre_error: settings.value("error")?,
        effort: Effort { clearance: 40_000, tolerance: 12_000 },
        ..Question::default()
    };
    Design::new(question).map_err(words)
}

/// A wheel without a crank radius, which the control always gives.
const NO_SIZES: &str = "a wheel without a size has no drawing; give a crank radius";

/// An error without the arguments that only the command line has.
fn words(error: Error) -> String {
    match error {
        Error::Sizes { error, .. } => error.to_string(),
        Error::Kinematics(error) => error.to_string(),
        Error::Dynamics(error) => error.to_string(),
        Error::Argument(message) => message,
        Error::Escapement(_) | Error::Figure(_) => "another mechanism; give a wheel".to_owned(),
    }
}

/// Decimals of a number that is known to a tolerance, four at most.
fn decimals(tolerance: f64) -> usize {
    [0.000_05, 0.0005, 0.005, 0.05].iter().position(|half| tolerance <= *half).map_or(0, |wider| 4 - wider)
}

fn millimetres(name: &'static str, value: f64) -> Number {
    Number::new(name, value, 3, "mm")
}

/// Names, values and texts of all numbers, a line for each.
fn numbers_file(settings: &Settings) -> Result<String, String> {
    let Answer { numbers, followers, further, .. } = draw(settings)?;
    let label = |name: &str| {
        let all = LIVE.quantities.iter().chain(LIVE.others).chain(&further);
        all.into_iter().find(|of| of.name == name).map_or("", |of| of.label)
    };
    let mut lines = vec!["quantity,value,text".to_owned()];
    for control in LIVE.controls {
        let value = match followers.iter().find(|(name, _)| *name == control.name) {
            Some((_, value)) => answer::shown(*value),
            None => settings.value(control.name)?,
        };
        let text = match control.kind {
            Kind::Choice(choices) => choices.get(value as usize).copied().unwrap_or_default().to_owned(),
            _ => format!("{value} {}", control.unit),
        };
        lines.push(format!("\"{}\",{value:?},\"{}\"", control.label, text.trim_end()));
    }
    lines.extend(numbers.iter().map(|of| format!("\"{}\",{:?},\"{}\"", label(of.name), of.value, of.text)));
    Ok(lines.join("\n") + "\n")
}

fn draw(settings: &Settings) -> Result<Answer, String> {
    let design = design(settings)?;
    let (sizes, error) = (design.sizes.as_ref().ok_or(NO_SIZES)?, design.question.centre_error);
    let mut numbers = parts(sizes);
    let clearance = design.clearance().map_err(words)?;
    let tolerance = design.centre_tolerance().map_err(words)?;
    if let Some((nearest, tolerance)) = clearance {
        numbers.push(Number::new("clearance", nearest.distance, decimals(tolerance), "mm"));
        let angle = nearest.crank_angle.to_degrees().abs();
        let at = Number::new("where", angle, 1, "°");
        let is_at_rest = nearest.contact == Contact::LockingDisc;
        let text = if is_at_rest { "in the dwell".to_owned() } else { format!("at {} of the crank", at.text) };
        numbers.push(Number { text, ..at });
    }
    if let Some(tolerance) = tolerance {
        numbers.push(Number::significant("nearer", tolerance.nearer, 4, "mm"));
        numbers.push(Number::significant("farther", tolerance.farther, 4, "mm"));
    }
    numbers.extend(loads(&design, &sizes.wheel).map_err(words)?);
    let is_met = play(&design, sizes, &mut numbers);
    let figure = stations::dimensions_on_a_page(sizes);
    numbers.extend(LIVE.others.iter().filter_map(|of| Some(millimetres(of.name, figure.series.value(of.name)?))));
    let more = design.on_pages(&sizes.wheel).map_err(words)?;
    numbers.extend(more.iter().filter_map(|field| Number::of(field.key, field)));
    let further = more.iter().filter_map(|of| Some(Quantity { name: of.key, label: of.line.as_ref()?.name })).collect();
    let followers = vec![
        ("pin", sizes.pin_diameter),
        ("play", sizes.play.slot),
        ("wheel-shaft", sizes.wheel_shaft),
        ("bore-play", sizes.play.bore),
    ];
    let depth = clearance.map(|(nearest, _)| nearest.distance);
    let message = message(sizes, error, is_met, depth, clearance.is_none() || tolerance.is_none());
    Ok(Answer { further, followers, message, ..Answer::new(figure, numbers) })
}

fn parts(sizes: &Sizes) -> Vec<Number> {
    let mut numbers = vec![
        millimetres("centres", sizes.centre_distance),
        millimetres("wheel", sizes.wheel_radius),
        Number {
            text: format!("{:.3} × {:.3} mm", sizes.slot_width, sizes.slot_depth),
            ..millimetres("slot", sizes.slot_width)
        },
    ];
    numbers.extend(sizes.locking_disc.map(|disc| millimetres("disc", disc.radius)));
    numbers
}

/// Times, torques and forces, with the axes at the right distance.
fn loads(design: &Design, wheel: &Wheel) -> Result<Vec<Number>, Error> {
    let loads = design.loads(wheel)?;
    let load = |of: fn(&WheelLoads<Wheel>) -> f64| loads.as_ref().map(of);
    let times = design.times(wheel)?;
    let force = load(|loads| loads.pin_moment().driving.value).and_then(|moment| design.force(moment));
    let pressure = force.map(|force| design.pressure(force)).transpose()?.flatten();
    let own = design.question.wheel_material.map(|of| design.own_inertia(of.density)).transpose()?.flatten();
    let all = [
        ("index", times.map(|[index, _]| index), 4, "s"),
        ("dwell", times.map(|[_, dwell]| dwell), 4, "s"),
        ("torque", load(|loads| loads.wheel_torque().driving.value), 4, "N m"),
        ("force", force, 4, "N"),
        ("crank", load(|loads| loads.crank_torque().driving.value), 4, "N m"),
        ("rms", load(|loads| loads.rms_crank_torque()), 4, "N m"),
        ("power", load(|loads| loads.peak_power()), 3, "W"),
        ("mean", load(|loads| loads.mean_crank_torque()), 3, "N m"),
        ("own", own, 3, "kg m²"),
        ("pressure", pressure, 3, "MPa"),
    ];
    let number =
        |(name, value, digits, unit): (_, Option<f64>, _, _)| Some(Number::significant(name, value?, digits, unit));
    Ok(all.into_iter().filter_map(number).collect())
}

/// Backlash and blows; whether the pin meets the slot at all.
fn play(design: &Design, sizes: &Sizes, numbers: &mut Vec<Number>) -> bool {
    let (error, pin_speed) = (design.question.centre_error, design.pin_speed().unwrap_or(f64::NAN));
    // With the axes apart the play is another.
    if let Some(play) = sizes.dwell_play().filter(|_| error == 0.0) {
        let middle = Number::new("backlash", play.middle.to_degrees(), 3, "°");
        numbers.push(Number { text: format!("±{}", middle.text), ..middle });
        numbers.push(Number::new("greatest", play.greatest.to_degrees(), 3, "°"));
        let held = Number::new("held", 100.0 * play.held, 0, "%");
        numbers.push(Number { text: format!("{} of the dwell", held.text), ..held });
        let before = Number::new("before", play.until_entry.to_degrees(), 1, "°");
        numbers.push(Number { text: format!("{} of the crank", before.text), ..before });
    }
    let Some(blow) = Number::of("blow", &design.blow(sizes)) else { return false };
    numbers.push(blow);
    if let Some(knock) = sizes.knock().filter(|_| error == 0.0) {
        numbers.push(Number::significant("hardest", knock.drifted * pin_speed, 3, "mm/s"));
    }
    true
}

/// What is to be said of the setting; `depth` is the least clearance in millimetres, if it was found.
fn message(sizes: &Sizes, error: f64, is_met: bool, depth: Option<f64>, is_late: bool) -> Option<String> {
    if depth.is_some_and(|depth| depth < 0.0) {
        return Some(
            "With the axes at this distance, driver and wheel overlap. A clearance below zero says by how much."
                .to_owned(),
        );
    }
    if !is_met {
        return Some("With the axes at this distance the pin does not meet the slot.".to_owned());
    }
    let warnings = sizes.warnings().into_iter().map(|warning| format!("Before you make it: {warning}."));
    let moved = (error != 0.0).then(|| {
        "Clearance and knock are for the axes as you moved them. Sizes, times and loads are for the right distance, \
         and we know the backlash only there."
            .to_owned()
    });
    let late = is_late.then(|| {
        "With so little play, some of the clearances take too long to compute in a page. The command geneva wheel \
         computes them."
            .to_owned()
    });
    let all: Vec<String> = warnings.chain(moved).chain(late).collect();
    Some(all.join(" ")).filter(|text| !text.is_empty())
}
