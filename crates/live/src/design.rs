//! A wheel of the reader's own: sizes, times, loads, clearance, and the files to make it.

use crate::answer::{LiveNumber, LiveQuantity, LiveReply, Progress};
use crate::arguments::LiveArguments;
use crate::assemblies::{Counts, counted};
use crate::control::{Control, Live, LiveFile, Preset, Settings, ToleranceTable};
use crate::given::given;
use crate::page_words::{label, with_labels, words};
use crate::turned::{ToleranceRow, ToleranceState, TurnedParts};
use crate::watch::{ERRORS, TURNING, WatchedWheel, WrongSizes};
use geneva_ask::wheel::{
    ASSEMBLIES, Argument, ArgumentSlot, GROUPS, Knob, SHAPE_FILES, SearchEffort, WRONG_SIZES, WheelDesign,
    WheelQuestion, arguments, yield_fields,
};
use geneva_ask::{ReportField, Rounding};
use geneva_dynamics::line_contact::{MATERIALS, Material};
use geneva_figures::stations;
use geneva_kinematics::wheel::as_built::Process;
use geneva_kinematics::wheel::{ClosestApproach, ContactPair, Sizes};

/// The designer of wheels.
pub const LIVE: Live = Live {
    name: "design",
    module: "live-design",
    figure: "wheel-dimensions",
    hint: "Choose the number of stations and the size. Pin, play and shafts adjust themselves until you set them by \
           hand. Make the pin thicker until it no longer fits. Double the speed: without friction the force of the pin \
           grows fourfold. With the wheel of this chapter (button six stations), move the axes apart by 0.02 mm, and the \
           pin knocks less hard. At 0.06 mm it meets a corner of its slot.",
    controls: &CONTROLS,
    presets: &[
        Preset::whole("six stations", "stations=6&crank-radius=25"),
        Preset::whole("eight stations, two pins", "stations=8&pins=2&crank-radius=20"),
        // The first two tasks of the chapter.
        Preset::whole(
            "a table of 2 kg, in 0.4 s",
            "stations=6&index-time=0.4&crank-radius=45&table-mass=2&table-diameter=300&friction-torque=0&process=2&wheel-material=13\
             &pin-material=13&thickness=12",
        ),
        Preset::whole(
            "from a printer, four stations",
            "stations=4&crank-radius=25&process=6&pin-screw=1&wheel-hub-circle=20&hub-holes=4&hub-screw=1&wheel-material=13\
             &pin-material=13&thickness=6",
        ),
        Preset::whole("a pin too thick", "stations=6&crank-radius=25&pin-diameter=20"),
        Preset::whole(
            "slots out of place, 20 times as large",
            "stations=6&crank-radius=25&slot-direction-error=0.05&larger=20&crank=-50",
        ),
    ],
    given: &[],
    // The three for which most readers move something; they stay in sight.
    quantities: &[
        LiveQuantity::new("clearance", "least clearance"),
        LiveQuantity::field("force", "greatest force of the pin", "peak_pin_force_n"),
        LiveQuantity::field("crank", "greatest torque at the crank", "peak_crank_torque_nm"),
    ],
    others: &[
        LiveQuantity::field("yield", "simulated assemblies that turn", "yield"),
        LiveQuantity::field("yield-low", "of all assemblies at least", "yield_low"),
        LiveQuantity::field("yield-high", "of all assemblies at most", "yield_high"),
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
        LiveQuantity::field("pressure", "contact pressure of pin and slot", "peak_contact_pressure_mpa"),
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
    files: &FILES,
    turned: Some(turned),
    tolerances: Some(ToleranceTable { fold: WRONG_SIZES, rows: tolerances }),
    beat: None,
    draw,
};

/// Ways to make the parts as they are called, in the order of [`Process::ALL`] behind none of them.
const PROCESSES: [&str; 7] =
    ["any process", "grinding", "milling", "a router", "a laser", "printing in resin", "printing with filament"];

/// Materials as they are called, in the order of [`MATERIALS`], and last what the way of making the parts has.
const NAMES: [&str; MATERIALS.len() + 1] = {
    let mut names = ["as usual for how they are made"; MATERIALS.len() + 1];
    let mut k = 0;
    while k < MATERIALS.len() {
        names[k] = MATERIALS[k].name;
        k += 1;
    }
    names
};

/// Materials as they are called of the driver, which is of the wheel's unless another is chosen.
const NAMES_OF_DRIVER: [&str; MATERIALS.len() + 1] = {
    let mut names = NAMES;
    names[MATERIALS.len()] = "the same as the wheel";
    names
};

/// How many arguments have a control, and how many controls there are.
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
const ALL: usize = MOVED + ERRORS.len() + TURNING.len();

/// A control for each argument that has one, in the fold of its group; those for sizes that are wrong come last, with the errors
/// that the command doesn't have.
const CONTROLS: [Control; ALL] = {
    let mut controls = [Control::number("", "", "", [0.0, 0.0], 0.0); ALL];
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
    let mut error = 0;
    while error < ERRORS.len() {
        controls[at] = ERRORS[error].in_fold(WRONG_SIZES);
        (at, error) = (at + 1, error + 1);
    }
    let mut turning = 0;
    while turning < TURNING.len() {
        controls[at] = TURNING[turning];
        (at, turning) = (at + 1, turning + 1);
    }
    controls
};

/// The files from which a wheel is made, its sheet and its numbers.
const FILES: [LiveFile; SHAPE_FILES.len() + 2] = {
    let numbers = LiveFile { name: NUMBERS_FILE, label: "All numbers (CSV)" };
    let mut files = [numbers; SHAPE_FILES.len() + 2];
    files[SHAPE_FILES.len()] = LiveFile { name: SHEET_FILE, label: "Sheet with all numbers (text)" };
    let mut at = 0;
    while at < SHAPE_FILES.len() {
        files[at] = LiveFile { name: SHAPE_FILES[at].name, label: SHAPE_FILES[at].label };
        at += 1;
    }
    files
};

/// The file with all numbers of the answer, a row for each.
pub const NUMBERS_FILE: &str = "numbers.csv";

/// The file with the answer for reading.
pub const SHEET_FILE: &str = "sheet.txt";

const fn control(argument: &Argument, knob: Knob) -> Control {
    let Knob { label, unit, slider, step, typed, first, side, .. } = knob;
    let control = match (argument.place, first) {
        (ArgumentSlot::Choice(choice), _) => {
            Control::choice(argument.name, label, choice.on_page(), choice.usual_entry())
        }
        (ArgumentSlot::Process(_), _) => Control::choice(argument.name, label, &PROCESSES, 0),
        (ArgumentSlot::Material(_), Some(first)) => {
            // The driver's is the one that nothing is said of at first.
            let names = if first as usize == MATERIALS.len() { &NAMES_OF_DRIVER } else { &NAMES };
            Control::choice(argument.name, label, names, first as usize)
        }
        (_, Some(first)) => Control::slider(argument.name, label, unit, slider, step, first).with_typed_range(typed),
        (_, None) => Control::following(argument.name, label, unit, slider, step).with_typed_range(typed),
    };
    match side {
        Some((group, number)) => control.on_side(group, number),
        None => control,
    }
}

/// A material by its number; behind the last is none, which leaves it to how the parts are made.
fn material(number: f64) -> Option<Material> {
    MATERIALS.get(number as usize).copied()
}

/// A process by its number; the first is none.
fn process(number: f64) -> Option<Process> {
    (number as usize).checked_sub(1).and_then(|at| Process::ALL.get(at)).copied()
}

/// The question of these settings.
fn question(settings: &Settings, effort: SearchEffort) -> Result<WheelQuestion, String> {
    let mut question = WheelQuestion { effort, ..WheelQuestion::default() };
    for (argument, value) in given(settings)? {
        match argument.place {
            ArgumentSlot::Stations(at) | ArgumentSlot::Pins(at) => *at(&mut question) = Some(value as u32),
            ArgumentSlot::Count(at) => *at(&mut question) = Some(value as u32),
            ArgumentSlot::Choice(choice) if value as usize == choice.usual_entry() => {}
            ArgumentSlot::Choice(choice) => (choice.set)(&mut question, value as usize),
            ArgumentSlot::Material(at) => *at(&mut question) = material(value),
            ArgumentSlot::Process(at) => *at(&mut question) = process(value),
            ArgumentSlot::Length(at)
            | ArgumentSlot::LengthOrZero(at)
            | ArgumentSlot::SignedLength(at)
            | ArgumentSlot::AboveZero(at)
            | ArgumentSlot::ZeroOrMore(at) => *at(&mut question) = Some(value),
            ArgumentSlot::Kind(_) | ArgumentSlot::Degrees(_) => {}
        }
    }
    Ok(question)
}

/// The command that asks the same. Axes in their place need no word.
fn command(settings: &Settings) -> Result<String, String> {
    let mut command = "geneva wheel".to_owned();
    for (argument, value) in given(settings)? {
        let text = match argument.place {
            ArgumentSlot::SignedLength(_) if value == 0.0 => continue,
            ArgumentSlot::Material(_) => match material(value) {
                Some(material) => material.name.to_owned(),
                None => continue,
            },
            ArgumentSlot::Choice(choice) if value as usize == choice.usual_entry() => continue,
            ArgumentSlot::Choice(choice) => choice.names.get(value as usize).copied().unwrap_or_default().to_owned(),
            ArgumentSlot::Process(_) => match process(value) {
                Some(process) => process.name().to_owned(),
                None => continue,
            },
            _ => value.to_string(),
        };
        command += &format!(" --{} {text}", argument.name);
    }
    Ok(command)
}

/// How long clearances are looked for while a reader waits for each picture: no longer than a tenth of a second.
const SOON: SearchEffort = SearchEffort { clearance: 40_000, tolerance: 12_000 };

/// The wheel of these settings.
fn design(settings: &Settings) -> Result<WheelDesign, String> {
    // With axes out of their place, a warning tells how far they may be.
    let waits = settings.is_in_motion() && settings.value("centre-error")? == 0.0;
    let effort = if waits { SearchEffort { tolerance: 0, ..SOON } } else { SOON };
    WheelDesign::new(question(settings, effort)?).map_err(words)
}

/// The wheel of the designer's arguments, for a file, which may take as long as the command's.
///
/// # Errors
///
/// What is wrong with the arguments, and what to give.
pub fn wheel_for_a_file(arguments: &LiveArguments) -> Result<WheelDesign, String> {
    let settings = Settings::new(&CONTROLS, &[], arguments)?;
    WheelDesign::new(question(&settings, SearchEffort::default())?).map_err(words)
}

/// A wheel without a size, which the controls always give.
const NO_SIZES: &str = "a wheel without a size has no drawing; give a crank radius or a centre distance";

/// Decimals of a number that is known to a tolerance, four at most.
fn decimals(tolerance: f64) -> usize {
    [0.000_05, 0.0005, 0.005, 0.05].iter().position(|half| tolerance <= *half).map_or(0, |wider| 4 - wider)
}

/// How the parts stand at the crank angle.
fn turned(settings: &Settings) -> Result<TurnedParts, String> {
    let design = design(settings)?;
    WatchedWheel::new(settings, design.sizes.as_ref().ok_or(NO_SIZES)?)?.parts()
}

fn draw(settings: &Settings) -> Result<LiveReply, String> {
    let design = design(settings)?;
    let sizes = design.sizes.as_ref().ok_or(NO_SIZES)?;
    let mut fields = design.live_fields(&sizes.wheel).map_err(words)?;
    let Counts { turning, cause, progress } = counted(settings, &design)?;
    let progress = if settings.is_in_motion() { Some(Progress::UNCOUNTED) } else { progress };
    fields.extend(yield_fields(turning.filter(|turning| turning.tried == ASSEMBLIES), design.wheel.kind()));
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
    let warnings = design.warnings_with_cause(cause).map_err(words)?;
    let is_late =
        !settings.is_in_motion() && (clearance.is_none() || design.centre_tolerance().map_err(words)?.is_none());
    let watched = WatchedWheel::new(settings, sizes)?;
    let message = message(&warnings, design.centre_error(), is_late, watched.verdict()?, metal_from_a_printer(&design));
    let followers = followers(&design, &fields);
    let (made, slots_turned) = watched.drawn();
    let figure = if made == *sizes && slots_turned == 0.0 {
        stations::dimensions_on_a_page(sizes)
    } else {
        stations::dimensions_of_a_wrong_wheel(sizes, &made, slots_turned)
    };
    Ok(LiveReply {
        further,
        followers,
        message,
        progress,
        turned: Some(watched.parts()?),
        command: Some(command(settings)?),
        ..LiveReply::new(figure, numbers)
    })
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
            // A shaft that there is not has no diameter.
            _ => f64::NAN,
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
        "slot_width_mm" => {
            let depth = LiveNumber::significant("", sizes.slot_depth, 3, "mm").text;
            format!("{} × {depth}", number.text.trim_end_matches(" mm"))
        }
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

/// What is to be said of the setting: what errors do, the warnings of the command, and which numbers are for other axes or are missing.
fn message(
    warnings: &[String],
    error: f64,
    is_late: bool,
    verdict: Option<String>,
    material: Option<String>,
) -> Option<String> {
    let warnings = warnings.iter().map(|warning| {
        let warning = with_labels(warning);
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
    let own = [moved, late].into_iter().flatten().map(str::to_owned);
    let all: Vec<String> = verdict.into_iter().chain(warnings).chain(material).chain(own).collect();
    Some(all.join(" ")).filter(|text| !text.is_empty())
}

/// That a printer makes no wheel of the metal for which loads are told: the choice of a material is another one than that of a process.
fn metal_from_a_printer(design: &WheelDesign) -> Option<String> {
    let wheel = design.materials.wheel;
    let is_printed = matches!(design.question.process, Some(Process::Fdm | Process::Resin));
    (is_printed && wheel.density > LEAST_OF_METAL).then(|| {
        format!(
            "Inertia, loads and pressure are for a wheel of {}. Choose “{}” in “{}” for one from the printer.",
            wheel.name,
            NAMES[MATERIALS.len()],
            arguments().find(|argument| argument.name == "wheel-material").and_then(label).unwrap_or_default()
        )
    })
}

/// The density in kg/m³ from which on a material counts as a metal, which is none of what printers print.
const LEAST_OF_METAL: f64 = 2000.0;

/// By how much each size may be wrong, alone and with all others, and by how much it is.
fn tolerances(settings: &Settings) -> Result<Vec<ToleranceRow>, String> {
    let design = design(settings)?;
    let sizes = design.sizes.as_ref().ok_or(NO_SIZES)?;
    let errors = WrongSizes::read(settings)?;
    let fields = design.tolerance_fields().map_err(words)?;
    let play = ReportField::in_unit("play_mm", sizes.play.slot, "mm").rounded(Rounding::Limit(3));
    let limit = |key: &str| -> Option<(f64, String)> {
        let field = fields.iter().chain([&play]).find(|field| field.key == key)?;
        let number = LiveNumber::from_field("", &field.clone().rounded(at_most_three(field.rounding)))?;
        Some((number.value, number.text))
    };
    let (out, degrees) = (errors.slot_direction.abs(), errors.slot_direction.to_degrees().abs());
    // What is set, as it counts for its limit alone and for that of all together.
    let rows = [
        ("axes nearer", "centres_nearer_mm", -errors.centre_distance, "all_nearer_mm", -errors.centre_distance),
        ("axes farther", "centres_farther_mm", errors.centre_distance, "all_farther_mm", errors.centre_distance),
        (
            "longer crank",
            "crank_radius_tolerance_mm",
            errors.crank_radius,
            "all_crank_radius_mm",
            errors.crank_radius.abs(),
        ),
        (
            "thicker pin, narrower slot",
            "play_mm",
            errors.pin_diameter - errors.slot_width,
            "all_width_mm",
            errors.pin_diameter.max(-errors.slot_width),
        ),
        (
            "slot out of direction",
            "slot_direction_tolerance_deg",
            degrees,
            "all_slot_direction_at_rim_mm",
            out * sizes.wheel_radius,
        ),
        ("slot end farther out", "bottom_gap_mm", errors.slot_end, "all_slot_end_mm", errors.slot_end),
        (
            "larger disc, smaller arc",
            "locking_gap_mm",
            errors.locking_disc - errors.locking_arc - errors.centre_distance,
            "all_locking_mm",
            errors.locking_disc.max(-errors.locking_arc),
        ),
    ];
    let row = |(name, alone, set, together, set_together): (&'static str, &str, f64, &str, f64)| {
        let (alone, together) = (limit(alone), limit(together));
        let is_passed = |limit: &Option<(f64, String)>, set: f64| limit.as_ref().is_some_and(|(most, _)| set > *most);
        let state = if is_passed(&alone, set) {
            ToleranceState::Beyond
        } else if is_passed(&together, set_together) {
            ToleranceState::BeyondTogether
        } else {
            ToleranceState::Within
        };
        let unit = if name == "slot out of direction" { "°" } else { "mm" };
        let set = if set > 0.0 { LiveNumber::significant("", set, 3, unit).text } else { "–".to_owned() };
        let text = |limit: Option<(f64, String)>| limit.map_or_else(|| "–".to_owned(), |(_, text)| text);
        ToleranceRow { name, set, alone: text(alone), together: text(together), state }
    };
    Ok(rows.into_iter().map(row).collect())
}
