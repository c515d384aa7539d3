//! A wheel of the reader's own: sizes, times, loads, clearance, and the files to make it.

use crate::answer::{self, LiveNumber, LiveQuantity, LiveReply};
use crate::control::{Control, ControlKind, Live, LiveFile, Preset, Settings};
use geneva_ask::wheel::{Argument, ArgumentSlot, GROUPS, Knob, SearchEffort, WheelDesign, WheelQuestion, arguments};
use geneva_ask::{Error, ReportField, Rounding};
use geneva_dynamics::line_contact::MATERIALS;
use geneva_figures::stations;
use geneva_kinematics::wheel::as_built::Process;
use geneva_kinematics::wheel::{ClosestApproach, ContactPair, Sizes};

pub const LIVE: Live = Live {
    name: "design",
    figure: "wheel-dimensions",
    hint: "Choose the number of stations and the size. Pin, play and shafts adjust themselves until you set them by \
           hand. Make the pin thicker until it no longer fits. Double the speed: without friction the force of the pin \
           grows fourfold. With the wheel of this chapter (button six stations), move the axes apart by 0.02 mm, and the \
           pin knocks less hard. At 0.06 mm it meets a corner of its slot.",
    controls: &CONTROLS,
    presets: &[
        Preset::whole("six stations", "stations=6&crank-radius=25"),
        Preset::whole("eight stations, two pins", "stations=8&pins=2&crank-radius=20"),
        Preset::whole("a pin too thick", "stations=6&crank-radius=25&pin-diameter=20"),
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
        LiveQuantity::field("blow", "knock of the pin at entry", "knock_mm_s"),
        LiveQuantity::field("hardest", "knock after the greatest backlash", "greatest_knock_mm_s"),
        LiveQuantity::field("crank-radius", "crank radius", "crank_radius_mm"),
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
        LiveQuantity::field("slot-play", "slot play", "play_mm"),
        LiveQuantity::field("locking-play", "locking play", "locking_play_mm"),
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

/// Ways to make the parts as they are called, in the order of [`Process::ALL`] behind none of them.
const PROCESSES: [&str; 7] =
    ["any process", "grinding", "milling", "a router", "a laser", "printing in resin", "printing with filament"];

/// Materials as they are called, in the order of [`MATERIALS`].
const NAMES: [&str; MATERIALS.len()] = {
    let mut names = [""; MATERIALS.len()];
    let mut k = 0;
    while k < names.len() {
        names[k] = MATERIALS[k].name;
        k += 1;
    }
    names
};

/// How many arguments have a control.
const MOVED: usize = {
    let (mut moved, mut group) = (0, 0);
    while group < GROUPS.len() {
        let mut row = 0;
        while row < GROUPS[group].rows.len() {
            moved += GROUPS[group].rows[row].knob.is_some() as usize;
            row += 1;
        }
        group += 1;
    }
    moved
};

/// A control for each argument that has one, in the fold of its group.
const CONTROLS: [Control; MOVED] = {
    let mut controls = [Control::number("", "", "", [0.0, 0.0], 0.0); MOVED];
    let (mut at, mut group) = (0, 0);
    while group < GROUPS.len() {
        let mut row = 0;
        while row < GROUPS[group].rows.len() {
            let argument = &GROUPS[group].rows[row];
            if let Some(knob) = argument.knob {
                controls[at] = control(argument, knob).in_fold(GROUPS[group].fold);
                at += 1;
            }
            row += 1;
        }
        group += 1;
    }
    controls
};

const fn control(argument: &Argument, knob: Knob) -> Control {
    let Knob { label, unit, slider, step, typed, first, side, .. } = knob;
    let control = match (argument.place, first) {
        (ArgumentSlot::Process(_), _) => Control::choice(argument.name, label, &PROCESSES, 0),
        (ArgumentSlot::Material(_), Some(first)) => Control::choice(argument.name, label, &NAMES, first as usize),
        (_, Some(first)) => Control::slider(argument.name, label, unit, slider, step, first).with_typed_range(typed),
        (_, None) => Control::following(argument.name, label, unit, slider, step).with_typed_range(typed),
    };
    match side {
        Some((group, number)) => control.on_side(group, number),
        None => control,
    }
}

/// The side of a group that the reader gave last: the first unless another was moved.
fn given_side(settings: &Settings, group: &str) -> Result<usize, String> {
    for argument in arguments() {
        if let Some(Knob { side: Some((of, number)), .. }) = argument.knob
            && of == group
            && number > 0
            && settings.value_if_moved(argument.name)?.is_some()
        {
            return Ok(number);
        }
    }
    Ok(0)
}

/// The question of these settings; clearances are looked for no longer than a tenth of a second.
fn question(settings: &Settings) -> Result<WheelQuestion, String> {
    let effort = SearchEffort { clearance: 40_000, tolerance: 12_000 };
    let mut question = WheelQuestion { effort, ..WheelQuestion::default() };
    for argument in arguments() {
        let Some(knob) = argument.knob else { continue };
        let is_given = match knob.side {
            Some((group, number)) => number == given_side(settings, group)?,
            None => true,
        };
        if !is_given {
            continue;
        }
        let name = argument.name;
        match argument.place {
            ArgumentSlot::Stations(at) | ArgumentSlot::Pins(at) => *at(&mut question) = Some(settings.count(name)?),
            // The first is none.
            ArgumentSlot::Process(at) => {
                let chosen = settings.choice(name)?;
                *at(&mut question) = chosen.checked_sub(1).and_then(|at| Process::ALL.get(at)).copied();
            }
            ArgumentSlot::Material(at) => {
                *at(&mut question) = Some(*MATERIALS.get(settings.choice(name)?).ok_or("no such material")?);
            }
            ArgumentSlot::Length(at)
            | ArgumentSlot::LengthOrZero(at)
            | ArgumentSlot::SignedLength(at)
            | ArgumentSlot::AboveZero(at)
            | ArgumentSlot::ZeroOrMore(at) => {
                *at(&mut question) = match knob.first {
                    Some(_) => Some(settings.value(name)?),
                    None => settings.value_if_moved(name)?,
                };
            }
            ArgumentSlot::Kind(_) | ArgumentSlot::Degrees(_) => {}
        }
    }
    Ok(question)
}

/// The wheel of these settings.
fn design(settings: &Settings) -> Result<WheelDesign, String> {
    WheelDesign::new(question(settings)?).map_err(words)
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
    let sizes = design.sizes.as_ref().ok_or(NO_SIZES)?;
    let fields = design.live_fields(&sizes.wheel).map_err(words)?;
    let clearance = design.clearance().map_err(words)?;
    let number = |of: &LiveQuantity| match of.key {
        Some(key) => {
            let field = fields.iter().find(|field| field.key == key)?;
            let rounded = field.clone().rounded(at_most_three(field.rounding));
            LiveNumber::from_field(of.name, &rounded).map(|number| worded(number, key, sizes))
        }
        None => match of.name {
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
    let warnings = design.warnings().map_err(words)?;
    let is_late = clearance.is_none() || design.centre_tolerance().map_err(words)?.is_none();
    let message = message(&warnings, design.centre_error(), is_late);
    let followers = followers(&design, &fields);
    Ok(LiveReply { further, followers, message, ..LiveReply::new(stations::dimensions_on_a_page(sizes), numbers) })
}

/// Where the controls stand that follow the others.
fn followers(design: &WheelDesign, fields: &[ReportField]) -> Vec<(&'static str, f64)> {
    let of = |argument: &Argument| {
        let knob = argument.knob.filter(|knob| !knob.key.is_empty())?;
        let told = fields.iter().find(|field| field.key == knob.key).and_then(ReportField::number);
        let table = design.table_inertia.unwrap_or(0.0);
        let value = told.unwrap_or(match knob.key {
            // A round table of this size would have the same inertia.
            "table_diameter_mm" => TABLE,
            "table_mass_kg" => 2.0 * table / (TABLE / 2000.0 * (TABLE / 2000.0)),
            _ => 0.0,
        });
        Some((argument.name, value))
    };
    arguments().filter_map(of).collect()
}

/// Diameter in millimetres of the round table that is shown while its inertia is given.
const TABLE: f64 = 300.0;

/// A rounding to three digits that count where it is to more: a fourth says nothing of a wheel that is still to be made.
fn at_most_three(rounding: Rounding) -> Rounding {
    match rounding {
        Rounding::Significant(digits) => Rounding::Significant(digits.min(3)),
        Rounding::Limit(digits) => Rounding::Limit(digits.min(3)),
        other => other,
    }
}

/// A field's number with the words that the figure puts beside it.
fn worded(number: LiveNumber, key: &str, sizes: &Sizes) -> LiveNumber {
    let text = match key {
        "dwell_backlash_deg" => format!("±{}", number.text),
        "dwell_backlash_held_fraction" => format!("{} of the dwell", number.text),
        "greatest_dwell_backlash_until_entry_deg" => format!("{} of the crank", number.text),
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

/// What is to be said of the setting: the warnings of the command, and which numbers are for other axes or are missing.
fn message(warnings: &[String], error: f64, is_late: bool) -> Option<String> {
    let warnings = warnings.iter().map(|warning| {
        let mut letters = warning.chars();
        let first = letters.next().map(|letter| letter.to_ascii_uppercase());
        format!("{}{}.", first.unwrap_or_default(), letters.as_str())
    });
    let moved = (error != 0.0).then_some(
        "Clearance and knock are for the axes as you moved them. Sizes, times and loads are for the right distance, \
         and we know the backlash only there.",
    );
    let late = is_late.then_some(
        "With so little play, some of the clearances take too long to compute in a page. The command geneva wheel \
         computes them.",
    );
    let all: Vec<String> = warnings.chain([moved, late].into_iter().flatten().map(str::to_owned)).collect();
    Some(all.join(" ")).filter(|text| !text.is_empty())
}
