//! No option is passed over in silence: one that would change nothing is refused, with what would make it count.

use super::WheelArguments;
use super::kind::Kind;
use crate::arguments::Format;
use crate::typed::as_typed;
use anyhow::bail;

/// The options with a number, as they are typed.
fn numbers(wanted: &WheelArguments) -> Vec<(&'static str, f64)> {
    let options = [
        ("--stations", wanted.stations.map(f64::from)),
        ("--pins", wanted.pins.map(f64::from)),
        ("--crank-radius", wanted.crank_radius),
        ("--centre-distance", wanted.centre_distance),
        ("--wheel-radius", wanted.wheel_radius),
        ("--pin-diameter", wanted.pin_diameter),
        ("--play", wanted.play),
        ("--horn", wanted.horn),
        ("--bottom-clearance", wanted.bottom_clearance),
        ("--wheel-shaft", wanted.wheel_shaft),
        ("--driver-shaft", wanted.driver_shaft),
        ("--rpm", wanted.rpm),
        ("--inertia", wanted.inertia),
        ("--thickness", wanted.thickness),
        ("--density", wanted.density),
        ("--friction-torque", wanted.friction_torque),
        ("--at", wanted.at.first().copied()),
        ("--at-wheel", wanted.at_wheel.first().copied()),
    ];
    options.into_iter().filter_map(|(name, value)| Some((name, value?))).collect()
}

/// Refuses the first of these options that was given.
fn none_of(wanted: &WheelArguments, names: &[&str], why: &str) -> anyhow::Result<()> {
    match numbers(wanted).into_iter().find(|(name, _)| names.contains(name)) {
        Some((name, value)) => bail!("{name} {} changes nothing: {why}", as_typed(value)),
        None => Ok(()),
    }
}

/// Whether all that was given beside the wanted times counts.
pub fn beside_times(wanted: &WheelArguments) -> anyhow::Result<()> {
    let given = numbers(wanted);
    let names: Vec<_> = given.iter().map(|(name, _)| *name).collect();
    none_of(
        wanted,
        &names,
        "--index-time and --dwell-time propose wheels and their speeds; leave it out, and give it with the --stations and \
         --rpm of one of them",
    )?;
    if let Some(material) = wanted.pin_material {
        bail!(
            "--pin-material {} changes nothing: --index-time and --dwell-time propose wheels, and load none; leave it out",
            material.name
        );
    }
    if !is_told(wanted.format) {
        bail!(
            "--format {}: --index-time and --dwell-time propose several wheels; give the --stations of one of them to \
             have it drawn",
            wanted.format.name()
        );
    }
    Ok(())
}

/// Whether all that was given for one wheel counts.
pub fn refused(wanted: &WheelArguments) -> anyhow::Result<()> {
    let is_external = wanted.kind.is_none_or(|kind| kind == Kind::External);
    if !is_external {
        none_of(wanted, &PARTS, "only an external wheel has parts in mm; leave it out, or give --type external")?;
    }
    if !is_told(wanted.format) {
        none_of(
            wanted,
            &MOTION,
            "a file of shapes has no speed and no load; leave it out, or give --format text, json or csv",
        )?;
        if !is_external {
            none_of(wanted, &SIZES, "this drawing has no scale; leave it out, or give --format text, json or csv")?;
        }
    }
    let is_sized = numbers(wanted).iter().any(|(name, _)| SIZES.contains(name));
    if !is_sized {
        let why = "without a size no part has mm; add --crank-radius MM, --centre-distance MM or --wheel-radius MM";
        none_of(wanted, &PARTS, why)?;
    }
    if wanted.thickness.is_none() {
        none_of(wanted, &["--density"], "without a thickness there is no mass; add --thickness MM")?;
    }
    if is_told(wanted.format) && wanted.density.is_none() && wanted.pin_material.is_none() {
        let why = "without a density there is no mass, and without materials no pressure; add --density KGM3, or \
                   --pin-material and --wheel-material";
        none_of(wanted, &["--thickness"], why)?;
    }
    if matches!(wanted.format, Format::Svg | Format::Dxf) {
        none_of(wanted, &["--thickness"], "this drawing is flat; leave it out, or give --format scad or stl")?;
    }
    if wanted.rpm.is_none() {
        none_of(wanted, &["--inertia", "--friction-torque"], "at no speed there is no load; add --rpm R")?;
    }
    if wanted.inertia.is_none() && wanted.density.is_none() {
        let why = "without the wheel's inertia no load is known; add --inertia KGM2, 0 if it is negligible";
        none_of(wanted, &["--friction-torque"], why)?;
    }
    let Some(material) = wanted.pin_material else { return Ok(()) };
    let has_load = wanted.rpm.is_some() && (wanted.inertia.is_some() || wanted.density.is_some());
    let why = if !is_external {
        "only an external wheel has parts in mm; leave it out, or give --type external"
    } else if !is_told(wanted.format) {
        "a file of shapes has no load; leave it out, or give --format text or json"
    } else if wanted.format == Format::Csv {
        "the cycle has no pressures; leave it out, or give --format text or json"
    } else if !has_load || !is_sized {
        "without a load there is no pressure; add --crank-radius MM, --rpm R and --inertia KGM2"
    } else if wanted.thickness.is_none() {
        "without the length of the contact there is no pressure; add --thickness MM"
    } else {
        return Ok(());
    };
    bail!("--pin-material {} changes nothing: {why}", material.name)
}

/// The three that give a size.
const SIZES: [&str; 3] = ["--crank-radius", "--centre-distance", "--wheel-radius"];
/// Those of the parts in millimetres.
const PARTS: [&str; 8] = [
    "--pin-diameter",
    "--play",
    "--horn",
    "--bottom-clearance",
    "--wheel-shaft",
    "--driver-shaft",
    "--thickness",
    "--density",
];
/// Those of motion and loads.
const MOTION: [&str; 6] = ["--rpm", "--inertia", "--density", "--friction-torque", "--at", "--at-wheel"];

/// Whether a format tells numbers, and does not show shapes.
fn is_told(format: Format) -> bool {
    matches!(format, Format::Text | Format::Json | Format::Csv)
}
