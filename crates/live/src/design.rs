//! A wheel of the reader's own: sizes, times, loads, clearance, and the files to make it.

use crate::answer::{self, LiveNumber, LiveQuantity, LiveReply};
use crate::control::{Control, ControlKind, Live, LiveFile, Preset, Settings};
use geneva_ask::wheel::{SearchEffort, WheelDesign, WheelQuestion};
use geneva_ask::{Error, Rounding};
use geneva_dynamics::line_contact::MATERIALS;
use geneva_figures::stations;
use geneva_kinematics::wheel::{ClosestApproach, ContactPair, Sizes, Warning};

pub const LIVE: Live = Live {
    name: "design",
    figure: "wheel-dimensions",
    hint: "Choose the number of stations and the size. Pin, play and shafts adjust themselves until you set them by \
           hand. Make the pin thicker until it no longer fits. Double the speed: without friction the force of the pin \
           grows fourfold. With the wheel of this chapter (button six stations), move the axes apart by 0.02 mm, and the \
           pin knocks less hard. At 0.06 mm it meets a corner of its slot.",
    controls: &[
        Control::slider("stations", "stations N", "", [3.0, 24.0], 1.0, 6.0)
            .with_typed_range([3.0, 100.0])
            .in_fold(NEED),
        Control::slider("pins", "pins", "", [1.0, 4.0], 1.0, 1.0).with_typed_range([1.0, 50.0]).in_fold(NEED),
        Control::slider("speed", "speed of the driver", "rpm", [1.0, 600.0], 1.0, 60.0)
            .with_typed_range([0.001, 100_000.0])
            .in_fold(NEED),
        Control::slider("radius", "size", "mm", [5.0, 100.0], 0.5, 25.0)
            .with_typed_range([0.1, 10_000.0])
            .in_fold(SIZE),
        Control::choice("size", "this size is the", &["crank radius", "centre distance"], 0).in_fold(SIZE),
        Control::slider("thickness", "thickness of the wheel", "mm", [1.0, 50.0], 0.5, 10.0)
            .with_typed_range([0.001, 10_000.0])
            .in_fold(SIZE),
        Control::choice("material", "the wheel is made of", &OF, 3).in_fold(SIZE),
        Control::following("pin", "diameter of a pin", "mm", [1.0, 40.0], 0.1)
            .with_typed_range([0.001, 10_000.0])
            .in_fold(FIT),
        Control::following("play", "play of slot and locking arc", "mm", [0.0, 0.5], 0.01)
            .with_typed_range([0.0, 1000.0])
            .in_fold(FIT),
        Control::slider("error", "axes too far apart by", "mm", [-1.0, 1.0], 0.01, 0.0)
            .with_typed_range([-10_000.0, 10_000.0])
            .in_fold(FIT),
        Control::following("wheel-shaft", "diameter of the wheel's shaft, 0 for none", "mm", [0.0, 100.0], 0.5)
            .with_typed_range([0.0, 10_000.0])
            .in_fold(FIT),
        Control::following("bore-play", "play of the bores", "mm", [0.0, 0.2], 0.001)
            .with_typed_range([0.0, 1000.0])
            .in_fold(FIT),
        Control::slider("inertia", "inertia of the table", "kg m²", [0.0, 0.05], 0.0005, 0.002)
            .with_typed_range([0.0, 1e6])
            .in_fold(LOAD),
        Control::slider("friction", "friction torque on the wheel", "N m", [0.0, 5.0], 0.05, 0.1)
            .with_typed_range([0.0, 1e6])
            .in_fold(LOAD),
    ],
    presets: &[
        Preset {
            name: "six stations",
            arguments: "stations=6&pins=1&radius=25&size=0&pin=&play=&speed=60&inertia=0.002&friction=0.1&error=0&wheel-shaft=&\
                        bore-play=&thickness=10&material=3",
        },
        Preset {
            name: "eight stations, two pins",
            arguments: "stations=8&pins=2&radius=20&size=0&pin=&play=&speed=60&inertia=0.002&friction=0.1&error=0&wheel-shaft=&\
                        bore-play=&thickness=10&material=3",
        },
        Preset {
            name: "a pin too thick",
            arguments: "stations=6&pins=1&radius=25&size=0&pin=20&play=&speed=60&inertia=0.002&friction=0.1&error=0&wheel-shaft=&\
                        bore-play=&thickness=10&material=3",
        },
    ],
    given: &[],
    // The three for which most readers move something; they stay in sight.
    quantities: &[
        LiveQuantity::new("clearance", "least clearance"),
        LiveQuantity::field("force", "greatest force of the pin", "peak_pin_force_n"),
        LiveQuantity::field("crank", "greatest torque at the crank", "peak_crank_torque_nm"),
    ],
    others: &[
        LiveQuantity::field("centres", "centre distance", "centre_distance_mm"),
        LiveQuantity::field("nearer", "axes may be too close together by", "centres_nearer_mm"),
        LiveQuantity::field("farther", "axes may be too far apart by", "centres_farther_mm"),
        LiveQuantity::field("index", "indexing time", "indexing_time_s"),
        LiveQuantity::field("dwell", "dwell time", "dwell_time_s"),
        LiveQuantity::field("torque", "greatest torque on the wheel", "peak_wheel_torque_nm"),
        LiveQuantity::field("rms", "RMS torque at the crank", "rms_crank_torque_nm"),
        LiveQuantity::field("power", "greatest power", "peak_power_w"),
        LiveQuantity::field("backlash", "backlash in mid-dwell", "dwell_backlash_deg"),
        LiveQuantity::field("greatest", "greatest backlash, to one side", "greatest_dwell_backlash_deg"),
        LiveQuantity::field("blow", "knock of the pin at entry", "entry_knock_mm_s"),
        LiveQuantity::field("hardest", "knock after the greatest backlash", "greatest_knock_mm_s"),
        LiveQuantity::new("crank-radius", "crank radius"),
        LiveQuantity::field("mean", "mean torque at the crank", "mean_crank_torque_nm"),
        LiveQuantity::field("own", "inertia of the wheel itself", "wheel_inertia_kgm2"),
        LiveQuantity::field("together", "inertia of table and wheel together", "inertia_kgm2"),
        LiveQuantity::field("pressure", "contact pressure of a steel pin", "peak_contact_pressure_mpa"),
        LiveQuantity::new("where", "the least clearance is"),
        LiveQuantity::field("held", "mid-dwell backlash holds for", "dwell_backlash_held_fraction"),
        LiveQuantity::field(
            "before",
            "greatest backlash is before entry by",
            "greatest_dwell_backlash_until_entry_deg",
        ),
        LiveQuantity::field("wheel", "wheel radius, to the pin at entry", "wheel_radius_mm"),
        LiveQuantity::field("slot", "slot, width × depth", "slot_width_mm"),
        LiveQuantity::field("disc", "radius of the locking disc", "locking_radius_mm"),
        LiveQuantity::field("locking-play", "locking play", "play_mm"),
        LiveQuantity::field("bore-play", "bore play", "bore_play_mm"),
        LiveQuantity::field("slot-bottom-clearance", "slot bottom clearance", "bottom_clearance_mm"),
        LiveQuantity::field("locking-arc-radius", "locking arc radius", "locking_arc_radius_mm"),
        LiveQuantity::field("horn-thickness", "horn thickness", "horn_thickness_mm"),
        LiveQuantity::field("web-between-slots", "web between slots", "slot_web_mm"),
        LiveQuantity::field("crescent-radius", "crescent radius", "crescent_radius_mm"),
        LiveQuantity::field(
            "crescent-centre-from-driver",
            "crescent centre from the driver's axis",
            "crescent_centre_mm",
        ),
        LiveQuantity::field("wheel-bore-diameter", "diameter of the wheel's bore", "wheel_bore_mm"),
        LiveQuantity::field("driver-bore-diameter", "diameter of the driver's bore", "driver_bore_mm"),
    ],
    drag: None,
    files: &[
        LiveFile {
            name: "dxf",
            label: "Drawing for the machine (DXF)",
            make: |settings| design(settings)?.dxf().map_err(words),
        },
        LiveFile {
            name: "svg",
            label: "Drawing with sizes (SVG)",
            make: |settings| {
                let design = design(settings)?;
                Ok(stations::dimensions(design.sizes.as_ref().ok_or(NO_SIZES)?).standalone())
            },
        },
        LiveFile { name: "csv", label: "These numbers (CSV)", make: numbers_file },
    ],
    beat: None,
    draw,
};

/// Folds of the controls.
const NEED: &str = "What the wheel is to do";
const SIZE: &str = "How large it is";
const FIT: &str = "How it fits";
const LOAD: &str = "What it carries";

/// Materials of the wheel, as they are called and in the order of [`MATERIALS`].
const OF: [&str; 5] = ["steel", "stainless steel", "cast iron", "phosphor bronze", "acetal"];

/// The wheel of these settings, whose clearances are looked for no longer than a tenth of a second.
fn design(settings: &Settings) -> Result<WheelDesign, String> {
    let wall = *MATERIALS.get(settings.choice("material")?).ok_or("no such material")?;
    let (size, is_crank) = (settings.value("radius")?, settings.choice("size")? == 0);
    let question = WheelQuestion {
        stations: Some(settings.count("stations")?),
        pins: Some(settings.count("pins")?),
        crank_radius: Some(size).filter(|_| is_crank),
        centre_distance: Some(size).filter(|_| !is_crank),
        pin_diameter: settings.value_if_moved("pin")?,
        play: settings.value_if_moved("play")?,
        bore_play: settings.value_if_moved("bore-play")?,
        wheel_shaft: settings.value_if_moved("wheel-shaft")?.filter(|diameter| *diameter > 0.0),
        rpm: Some(settings.value("speed")?),
        inertia: Some(settings.value("inertia")?),
        friction_torque: Some(settings.value("friction")?),
        thickness: Some(settings.value("thickness")?),
        density: Some(wall.density),
        pin_material: Some(MATERIALS[0]),
        wheel_material: Some(wall),
        centre_error: settings.value("error")?,
        effort: SearchEffort { clearance: 40_000, tolerance: 12_000 },
        ..WheelQuestion::default()
    };
    WheelDesign::new(question).map_err(words)
}

/// A wheel without a size, which the controls always give.
const NO_SIZES: &str = "a wheel without a size has no drawing; give a crank radius or a centre distance";

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

/// Names, values and texts of all numbers, a line for each.
fn numbers_file(settings: &Settings) -> Result<String, String> {
    let LiveReply { numbers, followers, further, .. } = draw(settings)?;
    let label = |name: &str| {
        let all = LIVE.quantities.iter().chain(LIVE.others).chain(&further);
        all.into_iter().find(|of| of.name == name).map_or("", |of| of.label)
    };
    let mut lines = vec!["quantity,value,text".to_owned()];
    for control in LIVE.controls {
        let value = match followers.iter().find(|(name, _)| *name == control.name) {
            Some((_, value)) => answer::round_for_box(*value),
            None => settings.value(control.name)?,
        };
        let text = match control.kind {
            ControlKind::Choice(choices) => choices.get(value as usize).copied().unwrap_or_default().to_owned(),
            _ => format!("{value} {}", control.unit),
        };
        lines.push(format!("\"{}\",{value:?},\"{}\"", control.label, text.trim_end()));
    }
    lines.extend(numbers.iter().map(|of| format!("\"{}\",{:?},\"{}\"", label(of.name), of.value, of.text)));
    Ok(lines.join("\n") + "\n")
}

fn draw(settings: &Settings) -> Result<LiveReply, String> {
    let design = design(settings)?;
    let (sizes, error) = (design.sizes.as_ref().ok_or(NO_SIZES)?, design.question.centre_error);
    let mut fields = design.live_fields(&sizes.wheel).map_err(words)?;
    let blow = design.blow(sizes);
    let is_met = blow.number().is_some();
    // With the axes apart the backlash is another.
    let is_known = |key: &str| match key {
        BACKLASH | HELD | GREATEST | BEFORE => error == 0.0,
        "greatest_knock_mm_s" => error == 0.0 && is_met,
        _ => true,
    };
    fields.retain(|field| is_known(field.key));
    fields.push(blow);
    let clearance = design.clearance().map_err(words)?;
    let number = |of: &LiveQuantity| match of.key {
        Some(key) => {
            let field = fields.iter().find(|field| field.key == key)?;
            let rounded = field.clone().rounded(at_most_three(field.rounding));
            LiveNumber::from_field(of.name, &rounded).map(|number| worded(number, key, sizes))
        }
        None => match of.name {
            "crank-radius" => Some(LiveNumber::new("crank-radius", sizes.crank_radius, 3, "mm")),
            "clearance" => clearance
                .map(|(nearest, tolerance)| LiveNumber::new("clearance", nearest.distance, decimals(tolerance), "mm")),
            "where" => clearance.map(|(nearest, _)| place(&nearest)),
            _ => None,
        },
    };
    let further: Vec<LiveQuantity> = fields
        .iter()
        .filter(|field| field.is_visible_in_live_figure && field.number().is_some())
        .filter_map(|field| Some(LiveQuantity::field(field.key, field.line.as_ref()?.name, field.key)))
        .collect();
    let numbers: Vec<LiveNumber> =
        LIVE.quantities.iter().chain(LIVE.others).chain(&further).filter_map(number).collect();
    let followers = vec![
        ("pin", sizes.pin_diameter),
        ("play", sizes.play.slot),
        ("wheel-shaft", sizes.wheel_shaft),
        ("bore-play", sizes.play.bore),
    ];
    // What is less than the tolerance is no overlap: without play the parts touch.
    let overlaps = clearance.is_some_and(|(nearest, tolerance)| nearest.distance < -tolerance);
    let is_late = clearance.is_none() || design.centre_tolerance().map_err(words)?.is_none();
    let message = message(&design.warnings(), error, is_met, overlaps, is_late);
    Ok(LiveReply { further, followers, message, ..LiveReply::new(stations::dimensions_on_a_page(sizes), numbers) })
}

/// A rounding to three digits that count where it is to more: a fourth says nothing of a wheel that is still to be made.
fn at_most_three(rounding: Rounding) -> Rounding {
    match rounding {
        Rounding::Significant(digits) => Rounding::Significant(digits.min(3)),
        Rounding::Limit(digits) => Rounding::Limit(digits.min(3)),
        other => other,
    }
}

const BACKLASH: &str = "dwell_backlash_deg";
const HELD: &str = "dwell_backlash_held_fraction";
const GREATEST: &str = "greatest_dwell_backlash_deg";
const BEFORE: &str = "greatest_dwell_backlash_until_entry_deg";

/// A field's number with the words that the figure puts beside it.
fn worded(number: LiveNumber, key: &str, sizes: &Sizes) -> LiveNumber {
    let text = match key {
        BACKLASH => format!("±{}", number.text),
        HELD => format!("{} of the dwell", number.text),
        BEFORE => format!("{} of the crank", number.text),
        "slot_width_mm" => format!("{:.3} × {:.3} mm", sizes.slot_width, sizes.slot_depth),
        _ => return number,
    };
    LiveNumber { text, ..number }
}

/// Where the least clearance is.
fn place(nearest: &ClosestApproach) -> LiveNumber {
    let at = LiveNumber::new("where", nearest.crank_angle.to_degrees().abs(), 1, "°");
    let is_at_rest = nearest.contact == ContactPair::LockingDisc;
    let text = if is_at_rest { "in the dwell".to_owned() } else { format!("at {} of the crank", at.text) };
    LiveNumber { text, ..at }
}

/// What is to be said of the setting: first what is wrong with it, then the warnings of the command.
fn message(warnings: &[Warning], error: f64, is_met: bool, overlaps: bool, is_late: bool) -> Option<String> {
    let wrong = if overlaps {
        Some("With the axes at this distance, driver and wheel overlap. A clearance below zero says by how much.")
    } else if !is_met {
        Some("With the axes at this distance the pin does not meet the slot.")
    } else {
        None
    };
    let warnings = warnings.iter().map(|warning| format!("Before you make it: {warning}."));
    let moved = (error != 0.0 && wrong.is_none()).then_some(
        "Clearance and knock are for the axes as you moved them. Sizes, times and loads are for the right distance, \
         and we know the backlash only there.",
    );
    let late = (is_late && wrong.is_none()).then_some(
        "With so little play, some of the clearances take too long to compute in a page. The command geneva wheel \
         computes them.",
    );
    let all: Vec<String> = wrong
        .map(str::to_owned)
        .into_iter()
        .chain(warnings)
        .chain([moved, late].into_iter().flatten().map(str::to_owned))
        .collect();
    Some(all.join(" ")).filter(|text| !text.is_empty())
}
