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
        ("--rpm", wanted.rpm),
        ("--inertia", wanted.inertia),
        ("--thickness", wanted.thickness),
        ("--density", wanted.density),
        ("--friction-torque", wanted.friction_torque),
        ("--at", wanted.at.first().copied()),
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
    if !matches!(wanted.format, Format::Text | Format::Json | Format::Csv) {
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
    let kind = wanted.kind.unwrap_or(Kind::External);
    let name = wanted.format.name();
    let (has_size, is_external) =
        (numbers(wanted).iter().any(|(name, _)| SIZES.contains(name)), kind == Kind::External);
    let parts = ["--pin-diameter", "--play", "--thickness", "--density"];
    if !is_external {
        let why =
            format!("only an external wheel has parts in mm; leave it out, or give --type {}", Kind::External.name());
        none_of(wanted, &parts, &why)?;
    }
    if wanted.format == Format::Svg {
        let of_motion = ["--rpm", "--inertia", "--density", "--friction-torque", "--at"];
        let why = "a drawing shows no speed and no load; leave it out, or give --format text, json or csv";
        none_of(wanted, &of_motion, why)?;
        if !is_external {
            none_of(wanted, &SIZES, "this drawing has no scale; leave it out, or give --format text, json or csv")?;
        }
    }
    if !has_size {
        let why = "without a size no part has mm; add --crank-radius MM, --centre-distance MM or --wheel-radius MM";
        none_of(wanted, &parts, why)?;
    }
    if wanted.thickness.is_none() {
        none_of(wanted, &["--density"], "without a thickness there is no mass; add --thickness MM")?;
    }
    if wanted.density.is_none() && is_flat(wanted.format) {
        let why = format!("without a density there is no mass, and {name} has no third dimension; add --density KGM3");
        none_of(wanted, &["--thickness"], &why)?;
    }
    if wanted.rpm.is_none() {
        none_of(wanted, &["--inertia", "--friction-torque"], "at no speed there is no load; add --rpm R")?;
    }
    if wanted.inertia.is_none() && wanted.density.is_none() {
        let why = "without the wheel's inertia no load is known; add --inertia KGM2, 0 if it is negligible";
        none_of(wanted, &["--friction-torque"], why)?;
    }
    Ok(())
}

/// The three that give a size.
const SIZES: [&str; 3] = ["--crank-radius", "--centre-distance", "--wheel-radius"];

/// Whether a format has no use for a thickness.
fn is_flat(format: Format) -> bool {
    matches!(format, Format::Text | Format::Json | Format::Csv | Format::Svg | Format::Markdown)
}
