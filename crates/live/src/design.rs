//! A wheel of the reader's own: sizes, times, loads, clearance, and the files to make it.

use crate::answer::{self, Answer, Number};
use crate::control::{Control, File, Kind, Live, Preset, Quantity, Settings};
use geneva_ask::wheel::{Design, Effort, Question};
use geneva_ask::{Error, Field};
use geneva_dynamics::line_contact::MATERIALS;
use geneva_figures::stations;
use geneva_kinematics::wheel::{Contact, Sizes};

pub const LIVE: Live = Live {
    name: "design",
    figure: "wheel-dimensions",
    hint: "Choose the number of stations and the size. Pin, play and shafts adjust themselves until you set them by hand. Make the pin thicker until it \
           no longer fits. Double the speed: without friction the force of the pin grows fourfold. Move the axes apart by 0.02 \
           mm, and the pin knocks less. At 0.06 mm it meets a corner of its slot.",
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
        Control::choice("material", "the wheel is of", &OF, 3),
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
        Quantity { name: "nearer", label: "axes may be too near by" },
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
        Quantity { name: "own", label: "of the inertia, the wheel's own" },
        Quantity { name: "pressure", label: "contact pressure of a steel pin" },
        Quantity { name: "where", label: "the least clearance is" },
        Quantity { name: "held", label: "in mid-dwell for" },
        Quantity { name: "before", label: "greatest backlash, before entry" },
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
        other => other.to_string(),
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

/// Numbers as the wheel's question answers them: the name here, the key there, and the text about the number.
type Shown = (&'static str, &'static str, &'static str);
const TIMES_AND_LOADS: [Shown; 8] = [
    ("index", "indexing_time_s", "{}"),
    ("dwell", "dwell_time_s", "{}"),
    ("torque", "peak_wheel_torque_nm", "{}"),
    ("force", "peak_pin_force_n", "{}"),
    ("crank", "peak_crank_torque_nm", "{}"),
    ("rms", "rms_crank_torque_nm", "{}"),
    ("power", "peak_power_w", "{}"),
    ("mean", "mean_crank_torque_nm", "{}"),
];
const BACKLASH: [Shown; 4] = [
    ("backlash", "dwell_backlash_deg", "±{}"),
    ("greatest", "greatest_dwell_backlash_deg", "{}"),
    ("held", "dwell_backlash_held_fraction", "{} of the dwell"),
    ("before", "greatest_dwell_backlash_until_entry_deg", "{} of the crank"),
];

fn shown<'a>(asked: &'a [Field], list: &'a [Shown]) -> impl Iterator<Item = Number> + 'a {
    list.iter().filter_map(|(name, key, about)| {
        let number = Number::of(name, asked.iter().find(|field| field.key == *key)?)?;
        Some(Number { text: about.replace("{}", &number.text), ..number })
    })
}

fn draw(settings: &Settings) -> Result<Answer, String> {
    let design = design(settings)?;
    let asked: Vec<Field> = design.sections().map_err(words)?.into_iter().flat_map(|(_, fields)| fields).collect();
    let (sizes, error) = (design.sizes.as_ref().ok_or(NO_SIZES)?, design.question.centre_error);
    let mut numbers: Vec<Number> =
        shown(&asked, &[("centres", "centre_distance_mm", "{}"), ("wheel", "wheel_radius_mm", "{}")]).collect();
    numbers.push(Number {
        text: format!("{:.3} × {:.3} mm", sizes.slot_width, sizes.slot_depth),
        ..millimetres("slot", sizes.slot_width)
    });
    numbers.extend(shown(&asked, &[("disc", "locking_radius_mm", "{}")]));
    let clearance = design.clearance().map_err(words)?;
    if let Some((nearest, tolerance)) = clearance {
        numbers.push(Number::new("clearance", nearest.distance, decimals(tolerance), "mm"));
        let angle = nearest.crank_angle.to_degrees().abs();
        let at = Number::new("where", angle, 1, "°");
        let is_at_rest = nearest.contact == Contact::LockingDisc;
        let text = if is_at_rest { "in the dwell".to_owned() } else { format!("at {} of the crank", at.text) };
        numbers.push(Number { text, ..at });
    }
    numbers.extend(shown(&asked, &[("nearer", "centres_nearer_mm", "{}"), ("farther", "centres_farther_mm", "{}")]));
    numbers.extend(shown(&asked, &TIMES_AND_LOADS));
    let own =
        design.question.wheel_material.map(|of| design.own_inertia(of.density)).transpose().map_err(words)?.flatten();
    numbers.extend(own.map(|own| Number::significant("own", own, 3, "kg m²")));
    numbers.extend(shown(&asked, &[("pressure", "peak_contact_pressure_mpa", "{}")]));
    // With the axes apart the play is another.
    if error == 0.0 {
        numbers.extend(shown(&asked, &BACKLASH));
    }
    let entry = sizes.entry(error).zip(design.pin_speed());
    numbers.extend(entry.map(|(entry, pin)| Number::significant("blow", entry.closing_speed * pin, 3, "mm/s")));
    if error == 0.0 {
        numbers.extend(shown(&asked, &[("hardest", "greatest_knock_mm_s", "{}")]));
    }
    let figure = stations::dimensions_on_a_page(sizes);
    numbers.extend(LIVE.others.iter().filter_map(|of| Some(millimetres(of.name, figure.series.value(of.name)?))));
    let on_pages = || asked.iter().filter(|field| field.is_on_pages);
    numbers.extend(on_pages().filter_map(|field| Number::of(field.key, field)));
    let further = on_pages().filter_map(|field| Some(Quantity { name: field.key, label: field.line.as_ref()?.name }));
    let further = further.collect();
    let followers = vec![
        ("pin", sizes.pin_diameter),
        ("play", sizes.play.slot),
        ("wheel-shaft", sizes.wheel_shaft),
        ("bore-play", sizes.play.bore),
    ];
    let depth = clearance.map(|(nearest, _)| nearest.distance);
    let is_late = clearance.is_none() || numbers.iter().all(|number| number.name != "nearer");
    let message = message(sizes, error, entry.is_some(), depth, is_late);
    Ok(Answer { further, followers, message, ..Answer::new(figure, numbers) })
}

/// What is to be said of the setting; `depth` is the least clearance in millimetres, if it was found.
fn message(sizes: &Sizes, error: f64, is_met: bool, depth: Option<f64>, is_late: bool) -> Option<String> {
    if depth.is_some_and(|depth| depth < 0.0) {
        return Some(
            "With these axes driver and wheel are in each other: a clearance below zero is how deep.".to_owned(),
        );
    }
    if !is_met {
        return Some("With this distance of the axes the pin does not meet the slot.".to_owned());
    }
    let warnings = sizes.warnings().into_iter().map(|warning| format!("Before you make it: {warning}."));
    let moved = (error != 0.0).then(|| {
        "Clearance and knock are for the axes as moved. Sizes, times and loads are for the right distance, and the \
         backlash is known only there."
            .to_owned()
    });
    let late = is_late.then(|| {
        "With so little play, some of the clearances take too long to find in a page. The command geneva wheel finds them."
            .to_owned()
    });
    let all: Vec<String> = warnings.chain(moved).chain(late).collect();
    Some(all.join(" ")).filter(|text| !text.is_empty())
}
