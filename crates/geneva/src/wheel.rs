//! One wheel: its sizes, its times, its motion and loads, or its drawing; or which wheel has wanted times.
//!
//! Its options are the rows of the table of arguments in `ask`. None is ignored in silence: one that would have no effect is refused,
//! with what would give it one.

use crate::fields;
use crate::output::TextLayout;
use crate::typed::{self, CommandFormat, Output, as_typed, formats};
use anyhow::bail;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
use geneva_ask::wheel::{
    ARGUMENTS, ActsOn, Argument, ArgumentSlot, Times, WheelDesign, WheelKind, WheelQuestion, proposals, speeds,
};
use geneva_dynamics::line_contact::{MATERIALS, Material};

/// Options of `geneva wheel`.
#[derive(Args, Debug)]
pub(crate) struct WheelArguments {
    /// What is asked of the wheel.
    #[command(flatten)]
    pub asked: WheelOptions,
    /// Time that one index should take, in seconds; give it with --dwell-time, and instead of --rpm, to get the wheels that
    /// come nearest. With --stations it is the longest that you allow, and you get the pins and speeds that fulfil both
    #[arg(long, value_name = "S", value_parser = typed::positive, allow_hyphen_values = true, requires = "dwell_time")]
    pub index_time: Option<f64>,
    /// Time that one dwell should take, in seconds; with --stations, the shortest that you allow
    #[arg(long, value_name = "S", value_parser = typed::positive, allow_hyphen_values = true, requires = "index_time")]
    pub dwell_time: Option<f64>,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (CommandFormat::Text, "A readable sheet, which says where everything is measured from"),
        (CommandFormat::Json, "An object with all digits; null for values that need an option you didn't give"),
        (CommandFormat::Csv, "The cycle, one row per degree of a turn of the driver, or one per --at"),
        (CommandFormat::Fields, "The numbers as CSV: a row with key, name, value, unit and meaning for each"),
        (CommandFormat::Svg, "A drawing as a standalone file; with dimensions if you give a size"),
        (CommandFormat::Dxf, "The outlines of all parts side by side, in mm, with true arcs; needs a size"),
        (CommandFormat::Scad, "A moving model for OpenSCAD, in mm; needs a size and --thickness"),
        (CommandFormat::Stl, "Meshes of the parts side by side, in mm; needs a size and --thickness"),
    ]))]
    pub format: CommandFormat,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// The arguments of a question about a wheel as options: one for each row of the table of arguments.
#[derive(Clone, Debug)]
pub(crate) struct WheelOptions(WheelQuestion);

impl Args for WheelOptions {
    fn augment_args(command: Command) -> Command {
        command.args(ARGUMENTS.iter().map(option))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for WheelOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut asked = Self(WheelQuestion::default());
        asked.update_from_arg_matches(matches)?;
        Ok(asked)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        fn typed<T: Clone + Send + Sync + 'static>(matches: &ArgMatches, name: &str) -> Option<T> {
            matches.get_one(name).cloned()
        }
        let Self(question) = self;
        for Argument { name, place, .. } in &ARGUMENTS {
            match place {
                ArgumentSlot::Stations(at) | ArgumentSlot::Pins(at) => *at(question) = typed(matches, name),
                ArgumentSlot::Kind(at) => *at(question) = typed(matches, name),
                ArgumentSlot::Material(at) => *at(question) = typed(matches, name),
                ArgumentSlot::Length(at) | ArgumentSlot::AboveZero(at) | ArgumentSlot::ZeroOrMore(at) => {
                    *at(question) = typed(matches, name)
                }
                ArgumentSlot::Degrees(at) => {
                    *at(question) = matches.get_many(name).into_iter().flatten().copied().collect()
                }
            }
        }
        Ok(())
    }
}

/// An argument as an option. Of the sizes and of the speeds one is given, and both materials or none.
fn option(argument: &Argument) -> Arg {
    let Argument { name, unit, place, acts_on, help } = *argument;
    let option = Arg::new(name).long(name).value_name(unit).help(help);
    let others = |are_like_it: &dyn Fn(&Argument) -> bool| {
        let others = ARGUMENTS.iter().filter(|other| other.name != name && are_like_it(other));
        others.map(|other| other.name).collect::<Vec<_>>()
    };
    let option = match place {
        ArgumentSlot::Stations(_) => option
            .value_parser(typed::stations)
            .allow_negative_numbers(true)
            .required_unless_present_any(["index_time", "dwell_time"]),
        ArgumentSlot::Pins(_) => option.value_parser(typed::pins).allow_negative_numbers(true),
        ArgumentSlot::Kind(_) => {
            option.value_parser(typed::value_named(&WheelKind::ALL, WheelKind::name, WheelKind::meaning))
        }
        ArgumentSlot::Length(_) => option.value_parser(typed::millimetres).allow_hyphen_values(true),
        ArgumentSlot::AboveZero(_) => option.value_parser(typed::positive).allow_hyphen_values(true),
        ArgumentSlot::ZeroOrMore(_) => option.value_parser(typed::zero_or_more).allow_hyphen_values(true),
        ArgumentSlot::Material(_) => option
            .value_parser(materials())
            .requires_all(others(&|argument| matches!(argument.place, ArgumentSlot::Material(_)))),
        ArgumentSlot::Degrees(_) => {
            option.value_parser(typed::finite_degrees).allow_hyphen_values(true).action(ArgAction::Append)
        }
    };
    // Of each of these, one is enough.
    let one_of = [ActsOn::Size, ActsOn::Speed].into_iter().filter(|of| acts_on.contains(of));
    one_of.fold(option, |option, of| option.conflicts_with_all(others(&|argument| argument.acts_on.contains(&of))))
}

/// One of the materials whose moduli are known, by its name.
fn materials() -> impl TypedValueParser<Value = Material> {
    PossibleValuesParser::new(MATERIALS.map(|material| material.name))
        .try_map(|name| MATERIALS.into_iter().find(|material| material.name == name).ok_or("not a known material"))
}

/// The wheel that is wanted, in the format that is wanted.
pub(crate) fn page(wanted: &WheelArguments, layout: TextLayout) -> anyhow::Result<String> {
    let (format, question) = (wanted.format, wanted.asked.0.clone());
    if let (Some(index), Some(dwell)) = (wanted.index_time, wanted.dwell_time) {
        reject_with_times(&question, format)?;
        let times = Times { index, dwell };
        let answer = match question.stations {
            Some(stations) => speeds(times, stations, question.kind)?,
            None => proposals(times, question.kind),
        };
        return match format {
            CommandFormat::Csv => fields::csv(answer.rows().next(), answer.rows().cloned()),
            CommandFormat::Json => fields::json(&answer),
            _ => Ok(fields::sheet(&answer, layout)),
        };
    }
    let design = WheelDesign::new(question)?;
    if matches!(format, CommandFormat::Dxf | CommandFormat::Scad | CommandFormat::Stl) {
        design.require_external(format.name())?;
    }
    reject_without_effect(&design.question, format)?;
    Ok(match format {
        CommandFormat::Svg => design.drawing().standalone(),
        CommandFormat::Dxf => design.dxf()?,
        CommandFormat::Scad => design.scad()?,
        CommandFormat::Stl => design.stl()?,
        CommandFormat::Csv => {
            let rows = design.cycle()?;
            fields::csv(rows.first(), rows.iter().cloned())?
        }
        CommandFormat::Json => fields::json(&design.answer()?)?,
        CommandFormat::Fields => fields::table(&design.answer()?)?,
        _ => fields::sheet(&design.answer()?, layout),
    })
}

/// Refuses the first of these options that was given; `why` ends the sentence "… has no effect".
fn reject_any(wanted: &WheelQuestion, refused: impl Fn(&Argument) -> bool, why: &str) -> anyhow::Result<()> {
    match wanted.numbers().into_iter().find(|(argument, _)| refused(argument)) {
        Some((Argument { name, .. }, value)) => bail!("--{name} {} has no effect {why}", as_typed(value)),
        None => Ok(()),
    }
}

/// Refuses options that have no effect beside the wanted times.
fn reject_with_times(wanted: &WheelQuestion, format: CommandFormat) -> anyhow::Result<()> {
    reject_any(
        wanted,
        |argument| argument.name != "stations",
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
    if format == CommandFormat::Fields {
        bail!(
            "--format fields is for one wheel, but --index-time and --dwell-time propose several; choose --format csv, which has \
             a row for each"
        );
    }
    if !gives_numbers(format) {
        bail!(
            "--format {}: --index-time and --dwell-time propose several wheels; to draw one of them, give its --stations \
             without the times",
            format.name()
        );
    }
    Ok(())
}

/// Refuses options that have no effect for this one wheel.
fn reject_without_effect(wanted: &WheelQuestion, format: CommandFormat) -> anyhow::Result<()> {
    let is_external = wanted.kind.is_none_or(|kind| kind == WheelKind::External);
    if !is_external {
        let why = "because only external wheels have parts in mm; leave it out, or choose --type external";
        reject_any(wanted, acts_on(ActsOn::Parts), why)?;
    }
    if !gives_numbers(format) {
        let name = format.name();
        let why = format!(
            "on --format {name}, a file of shapes without motion or loads; leave it out, or choose --format text, json or csv"
        );
        reject_any(wanted, acts_on(ActsOn::Motion), &why)?;
        if !is_external {
            let why = format!(
                "on --format {name}, whose drawing is not to scale; leave it out, or choose --format text, json or csv"
            );
            reject_any(wanted, acts_on(ActsOn::Size), &why)?;
        }
    }
    if format == CommandFormat::Fields {
        let why =
            "on --format fields, which has no instants; leave it out, or choose --format csv, which has a row for each";
        reject_any(wanted, is_named(&["at", "at-wheel"]), why)?;
    }
    let is_sized = wanted.numbers().iter().any(|(argument, _)| argument.acts_on.contains(&ActsOn::Size));
    if !is_sized {
        let why = "without a size in mm; add --crank-radius MM, --centre-distance MM or --wheel-radius MM";
        reject_any(wanted, acts_on(ActsOn::Parts), why)?;
    }
    if wanted.thickness.is_none() {
        reject_any(wanted, is_named(&["density"]), "without a thickness; add --thickness MM")?;
    }
    if gives_numbers(format) && wanted.density.is_none() && wanted.pin_material.is_none() {
        let why = "without a density or materials; add --density KGM3 for the mass, or --pin-material and --wheel-material \
                   for the pressure";
        reject_any(wanted, is_named(&["thickness"]), why)?;
    }
    if matches!(format, CommandFormat::Svg | CommandFormat::Dxf) {
        let why = format!(
            "on --format {}, whose drawing is flat; leave it out, or choose --format scad or stl",
            format.name()
        );
        reject_any(wanted, is_named(&["thickness"]), &why)?;
    }
    if wanted.speed().is_none() {
        reject_any(wanted, is_named(&["inertia", "friction-torque"]), "without a speed; add --rpm R or --rad-s W")?;
    }
    if wanted.inertia.is_none() && wanted.density.is_none() {
        let why = "without the wheel's inertia; add --inertia KGM2, with 0 if it is negligible";
        reject_any(wanted, is_named(&["friction-torque"]), why)?;
    }
    let Some(material) = wanted.pin_material else { return Ok(()) };
    let has_load = wanted.speed().is_some() && (wanted.inertia.is_some() || wanted.density.is_some());
    let why = if !is_external {
        "because only external wheels have parts in mm; leave it out, or choose --type external"
    } else if !gives_numbers(format) {
        "on a file of shapes, which has no loads; leave it out, or choose --format text or json"
    } else if format == CommandFormat::Csv {
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

/// Whether an argument acts on this.
fn acts_on(what: ActsOn) -> impl Fn(&Argument) -> bool {
    move |argument| argument.acts_on.contains(&what)
}

/// Whether an argument has one of these names.
fn is_named(names: &[&str]) -> impl Fn(&Argument) -> bool {
    move |argument| names.contains(&argument.name)
}

/// Whether a format gives numbers, and not shapes.
fn gives_numbers(format: CommandFormat) -> bool {
    matches!(format, CommandFormat::Text | CommandFormat::Json | CommandFormat::Csv | CommandFormat::Fields)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_the_program_asks_what_the_same_words_ask() {
        let words = "--stations 6 --pins 2 --type internal --crank-radius 50 --pin-diameter 8 --play 0.1 --horn 9 --bottom-clearance 1 \
                     --wheel-shaft 20 --driver-shaft 10 --rpm 60 --inertia 0.002 --thickness 8 --density 7800 --friction-torque 0.1 \
                     --pin-material steel --wheel-material acetal --at -20 --at 5 --at-wheel 3";
        let given = |argument: &Argument| words.contains(&format!("--{} ", argument.name));
        assert_eq!(
            ARGUMENTS.iter().filter(|argument| given(argument)).count() + 3,
            ARGUMENTS.len(),
            "one size of three, one speed of two"
        );
        let command = WheelArguments::augment_args(Command::new("wheel"));
        let line = ["wheel"].into_iter().chain(words.split_whitespace());
        let WheelOptions(asked) = WheelOptions::from_arg_matches(&command.get_matches_from(line)).expect("options");
        assert_eq!(format!("{asked:?}"), format!("{:?}", WheelQuestion::parse(words).expect("arguments")));
    }
}
