//! No option is ignored in silence: one that would have no effect is refused, with what would give it one.

use crate::format::Format;
use crate::typed::as_typed;
use anyhow::bail;
use geneva_ask::wheel::{Kind, Question};

/// Refuses the first of these options that was given; `why` ends the sentence "… has no effect".
fn none_of(wanted: &Question, names: &[&str], why: &str) -> anyhow::Result<()> {
    match wanted.numbers().into_iter().find(|(name, _)| names.contains(name)) {
        Some((name, value)) => bail!("--{name} {} has no effect {why}", as_typed(value)),
        None => Ok(()),
    }
}

/// Refuses options that have no effect beside the wanted times.
pub fn beside_times(wanted: &Question, format: Format) -> anyhow::Result<()> {
    let names: Vec<_> = wanted.numbers().iter().map(|(name, _)| *name).collect();
    none_of(
        wanted,
        &names,
        "with --index-time and --dwell-time, which propose wheels and their speeds; leave it out now, and give it with the \
         --stations and --rpm of the wheel you choose",
    )?;
    if let Some(material) = wanted.pin_material {
        bail!(
            "--pin-material {} has no effect with --index-time and --dwell-time, which propose wheels without loads; leave it \
             out",
            material.name
        );
    }
    if format == Format::Fields {
        bail!(
            "--format fields is for one wheel, but --index-time and --dwell-time propose several; choose --format csv, which has \
             a row for each"
        );
    }
    if !gives_numbers(format) {
        bail!(
            "--format {}: --index-time and --dwell-time propose several wheels; to draw one of them, give its --stations \
             instead",
            format.name()
        );
    }
    Ok(())
}

/// Refuses options that have no effect for this one wheel.
pub fn refused(wanted: &Question, format: Format) -> anyhow::Result<()> {
    let is_external = wanted.kind.is_none_or(|kind| kind == Kind::External);
    if !is_external {
        let why = "because only external wheels have parts in mm; leave it out, or choose --type external";
        none_of(wanted, &PARTS, why)?;
    }
    if !gives_numbers(format) {
        let name = format.name();
        let why = format!(
            "on --format {name}, a file of shapes without motion or loads; leave it out, or choose --format text, json or csv"
        );
        none_of(wanted, &MOTION, &why)?;
        if !is_external {
            let why = format!(
                "on --format {name}, whose drawing is not to scale; leave it out, or choose --format text, json or csv"
            );
            none_of(wanted, &SIZES, &why)?;
        }
    }
    if format == Format::Fields {
        let why =
            "on --format fields, which has no instants; leave it out, or choose --format csv, which has a row for each";
        none_of(wanted, &["at", "at-wheel"], why)?;
    }
    let is_sized = wanted.numbers().iter().any(|(name, _)| SIZES.contains(name));
    if !is_sized {
        let why = "without a size in mm; add --crank-radius MM, --centre-distance MM or --wheel-radius MM";
        none_of(wanted, &PARTS, why)?;
    }
    if wanted.thickness.is_none() {
        none_of(wanted, &["density"], "without a thickness; add --thickness MM")?;
    }
    if gives_numbers(format) && wanted.density.is_none() && wanted.pin_material.is_none() {
        let why = "without a density or materials; add --density KGM3 for the mass, or --pin-material and --wheel-material \
                   for the pressure";
        none_of(wanted, &["thickness"], why)?;
    }
    if matches!(format, Format::Svg | Format::Dxf) {
        let why = format!(
            "on --format {}, whose drawing is flat; leave it out, or choose --format scad or stl",
            format.name()
        );
        none_of(wanted, &["thickness"], &why)?;
    }
    if wanted.rpm.is_none() {
        none_of(wanted, &["inertia", "friction-torque"], "without a speed; add --rpm R")?;
    }
    if wanted.inertia.is_none() && wanted.density.is_none() {
        let why = "without the wheel's inertia; add --inertia KGM2, with 0 if it is negligible";
        none_of(wanted, &["friction-torque"], why)?;
    }
    let Some(material) = wanted.pin_material else { return Ok(()) };
    let has_load = wanted.rpm.is_some() && (wanted.inertia.is_some() || wanted.density.is_some());
    let why = if !is_external {
        "because only external wheels have parts in mm; leave it out, or choose --type external"
    } else if !gives_numbers(format) {
        "on a file of shapes, which has no loads; leave it out, or choose --format text or json"
    } else if format == Format::Csv {
        "on --format csv, which has no pressures; leave it out, or choose --format text or json"
    } else if !has_load || !is_sized {
        "without a load; add --crank-radius MM, --rpm R and --inertia KGM2"
    } else if wanted.thickness.is_none() {
        "without a thickness, which is the length of the contact; add --thickness MM"
    } else {
        return Ok(());
    };
    bail!("--pin-material {} has no effect {why}", material.name)
}

/// The three options that give a size.
const SIZES: [&str; 3] = ["crank-radius", "centre-distance", "wheel-radius"];
/// The options of the parts in millimetres.
const PARTS: [&str; 8] =
    ["pin-diameter", "play", "horn", "bottom-clearance", "wheel-shaft", "driver-shaft", "thickness", "density"];
/// The options of motion and loads.
const MOTION: [&str; 6] = ["rpm", "inertia", "density", "friction-torque", "at", "at-wheel"];

/// Whether a format gives numbers, and not shapes.
fn gives_numbers(format: Format) -> bool {
    matches!(format, Format::Text | Format::Json | Format::Csv | Format::Fields)
}
