//! One wheel: its sizes, its times, its motion and loads, or its drawing; or which wheel has wanted times.
//!
//! Its options are the rows of the table of arguments in `ask`. None is ignored in silence: one that would have no effect is refused,
//! with what would give it one.

use crate::fields::{self, SheetUnit, SheetUnitArgument};
use crate::output::TextLayout;
use crate::printable::escape_and_shorten;
use crate::typed::{self, CommandFormat, Output, formats};
use crate::wheel_check::CheckArguments;
use anyhow::{Context, Error, bail};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, Subcommand};
use geneva_ask::MechanismReport;
use geneva_ask::length_units::TypedLengths;
use geneva_ask::wheel::{
    ActsOn, Argument, ArgumentSlot, GROUPS, NamedChoice, SHAPE_FILES, Times, WheelDesign, WheelKind, WheelQuestion,
    arguments, proposals, proposals_for_angle, speeds,
};
use geneva_dynamics::line_contact::{MATERIALS, Material};
use geneva_host::files::{NewFile, OutputOption};
use geneva_kinematics::wheel::as_built::Process;
use std::fs;
use std::path::{Path, PathBuf};

/// Options of `geneva wheel`.
#[derive(Args, Debug)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(crate) struct WheelArguments {
    /// What is done instead with a wheel that exists.
    #[command(subcommand)]
    pub action: Option<WheelAction>,
    /// What is asked of the wheel.
    #[command(flatten)]
    pub asked: WheelOptions,
    /// Output format
    #[arg(long, default_value = "text", value_parser = formats(&[
        (CommandFormat::Text, "A readable sheet, which says where everything is measured from"),
        (CommandFormat::Json, "An object with all digits; null for values that need an option you didn't give"),
        (CommandFormat::Csv, "The cycle, one row per degree of a turn of the driver, or one per --at"),
        (CommandFormat::Fields, "The numbers as CSV: a row with key, name, value, unit and meaning for each"),
        (CommandFormat::Svg, "A drawing as a standalone file; with dimensions if you give a size"),
        (CommandFormat::Dxf, "The outlines of all parts side by side, in mm, with true arcs; needs a size"),
        (CommandFormat::Scad, "A moving model for OpenSCAD, in mm; needs a size"),
        (CommandFormat::Parts, "The parts to be cut from sheets, true to scale, as SVG; needs a size"),
        (CommandFormat::Step, "Solids of the parts in place, for CAD programs; needs a size"),
        (CommandFormat::Stl, "Meshes of the parts side by side, in mm; needs a size"),
    ]))]
    pub format: CommandFormat,
    /// Write the sheet, the numbers, the drawing and all files for making to this folder, which is made if it isn't there;
    /// without a size, an external wheel gets the one that suits its load. An internal wheel needs a size and --thickness for its
    /// files, and a spherical one has none but the sheet, the numbers and the drawing
    #[arg(long, value_name = "DIR", conflicts_with_all = ["format", "output"])]
    pub out: Option<PathBuf>,
    /// The unit of the lengths on the sheet.
    #[command(flatten)]
    pub unit: SheetUnitArgument,
    /// Where the output goes.
    #[command(flatten)]
    pub to: Output,
}

/// What else is done with wheels.
#[derive(Debug, Subcommand)]
pub(crate) enum WheelAction {
    /// Check a wheel that exists by its measured sizes: does it turn, and which size is wrong?
    #[command(after_help = "\
Examples:
  geneva wheel check --stations 6 --centre-distance 50.4 --crank-radius 25 --outside-diameter 87.1
  geneva wheel check --stations 4 --crank-radius 25+-0.02 --centre-distance 35.4 --slot-width 1:6.1,2:6.0 --pin-diameter 6
  geneva wheel check --stations 6 --centre-distance 2in --crank-radius 1in --pin-diameter 1/4in --uncertainty 0.002in
  geneva wheel check --dxf wheel.dxf --layer wheel=STAR --rpm 60

Give what you have measured. What is missing is filled in from the nearest right wheel, and what rests on it is not told: the answer \
says what to measure. Lengths are in millimetres, or with a unit: 0.5in, 1/8in, 1-1/2in, 2cm. Decimals have a point; commas are \
between slots or arcs.")]
    Check(Box<CheckArguments>),
}

/// The arguments of a question about a wheel as options: one for each row of the table of arguments.
#[derive(Clone, Debug, Default)]
pub(crate) struct WheelOptions {
    question: WheelQuestion,
    /// What was typed for each option that was given; of repeated ones the first.
    given: Vec<GivenOption>,
}

/// An option with what was typed for it.
type GivenOption = (Argument, String);

impl Args for WheelOptions {
    fn augment_args(command: Command) -> Command {
        let options =
            GROUPS.iter().flat_map(|group| group.rows.iter().map(|row| option(row).help_heading(group.heading)));
        command.args(options)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for WheelOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut asked = Self::default();
        asked.update_from_arg_matches(matches)?;
        Ok(asked)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        fn typed<T: Clone + Send + Sync + 'static>(matches: &ArgMatches, name: &str) -> Option<T> {
            matches.get_one(name).cloned()
        }
        let Self { question, given } = self;
        for argument @ Argument { name, place, .. } in arguments() {
            let mut texts = matches.get_raw(name).into_iter().flatten();
            given.extend(texts.next().map(|text| (*argument, text.to_string_lossy().into_owned())));
            match place {
                ArgumentSlot::Stations(at) | ArgumentSlot::Pins(at) => *at(question) = typed(matches, name),
                ArgumentSlot::Kind(at) => *at(question) = typed(matches, name),
                ArgumentSlot::Count(at) => *at(question) = typed(matches, name),
                ArgumentSlot::Choice(NamedChoice { names, set, .. }) => {
                    let named: Option<String> = typed(matches, name);
                    if let Some(number) = named.and_then(|named| names.iter().position(|name| **name == named)) {
                        set(question, number);
                    }
                }
                ArgumentSlot::Process(at) => *at(question) = typed(matches, name),
                ArgumentSlot::Material(at) => *at(question) = typed(matches, name),
                ArgumentSlot::Length(at)
                | ArgumentSlot::LengthOrZero(at)
                | ArgumentSlot::SignedLength(at)
                | ArgumentSlot::AboveZero(at)
                | ArgumentSlot::ZeroOrMore(at) => *at(question) = typed(matches, name),
                ArgumentSlot::Degrees(at) => {
                    *at(question) = matches.get_many(name).into_iter().flatten().copied().collect()
                }
            }
        }
        Ok(())
    }
}

/// An argument as an option.
fn option(argument: &Argument) -> Arg {
    let Argument { name, unit, place, help, .. } = *argument;
    let option = Arg::new(name).long(name).value_name(unit).help(help);
    match place {
        ArgumentSlot::Stations(_) => option
            .value_parser(typed::stations)
            .allow_negative_numbers(true)
            .required_unless_present_any(["index-time", "dwell-time", "dwell-angle"]),
        ArgumentSlot::Pins(_) => option.value_parser(typed::pins).allow_negative_numbers(true),
        ArgumentSlot::Kind(_) => {
            option.value_parser(typed::value_named(&WheelKind::ALL, WheelKind::name, WheelKind::meaning))
        }
        ArgumentSlot::Length(_) => option.value_parser(typed::millimetres).allow_hyphen_values(true),
        ArgumentSlot::LengthOrZero(_) => option.value_parser(typed::millimetres_or_zero).allow_hyphen_values(true),
        ArgumentSlot::SignedLength(_) => option.value_parser(typed::signed_millimetres).allow_hyphen_values(true),
        ArgumentSlot::AboveZero(_) => option.value_parser(typed::positive).allow_hyphen_values(true),
        ArgumentSlot::ZeroOrMore(_) => option.value_parser(typed::zero_or_more).allow_hyphen_values(true),
        ArgumentSlot::Count(_) => option.value_parser(typed::holes).allow_negative_numbers(true),
        ArgumentSlot::Choice(NamedChoice { names, .. }) => option.value_parser(PossibleValuesParser::new(names)),
        ArgumentSlot::Process(_) => {
            option.value_parser(typed::value_named(&Process::ALL, Process::name, Process::meaning))
        }
        ArgumentSlot::Material(_) => option.value_parser(materials()),
        ArgumentSlot::Degrees(_) => {
            option.value_parser(typed::finite_degrees).allow_hyphen_values(true).action(ArgAction::Append)
        }
    }
}

/// One of the materials whose moduli are known, by its name.
fn materials() -> impl TypedValueParser<Value = Material> {
    PossibleValuesParser::new(MATERIALS.map(|material| material.name))
        .try_map(|name| MATERIALS.into_iter().find(|material| material.name == name).ok_or("not a known material"))
}

/// The wheel that is wanted, in the format that is wanted, or in all of them. What is refused is told in the units that were typed.
pub(crate) fn page(wanted: &WheelArguments, layout: TextLayout) -> anyhow::Result<String> {
    let is_length = |argument: &Argument| {
        matches!(
            argument.place,
            ArgumentSlot::Length(_) | ArgumentSlot::LengthOrZero(_) | ArgumentSlot::SignedLength(_)
        )
    };
    let mut typed = TypedLengths::new(wanted.unit.unit == SheetUnit::In);
    for (argument, text) in wanted.asked.given.iter().filter(|(argument, _)| is_length(argument)) {
        typed.add(argument.name, text);
    }
    let lengths = arguments().filter(|argument| is_length(argument)).map(|argument| argument.name).collect::<Vec<_>>();
    answer(wanted, layout).map_err(|refused| fields::in_typed_units(refused, &typed, &lengths))
}

fn answer(wanted: &WheelArguments, layout: TextLayout) -> anyhow::Result<String> {
    let (format, question, given) = (wanted.format, wanted.asked.question.clone(), &wanted.asked.given);
    wanted.unit.reject_without_sheet(format)?;
    if let Some(proposed) = proposed(&question)? {
        reject_with_proposals(&question, wanted)?;
        return match format {
            CommandFormat::Csv => fields::csv(proposed.rows().next(), proposed.rows().cloned()),
            CommandFormat::Json => fields::json(&proposed),
            _ => Ok(fields::sheet(&proposed, layout)),
        };
    }
    if let Some(folder) = &wanted.out {
        let design = WheelDesign::new(WheelQuestion { recommends_size: true, ..question })?;
        reject_without_effect(&design.question, given, CommandFormat::Text)?;
        return write_all(&design, folder, wanted.unit.unit, layout);
    }
    let recommends_size = question.process.is_some();
    let design = WheelDesign::new(WheelQuestion { recommends_size, ..question })?;
    if format == CommandFormat::Scad {
        design.require_parts(format.name())?;
    }
    reject_without_effect(&design.question, given, format)?;
    Ok(match format {
        CommandFormat::Svg => design.drawing().standalone(),
        CommandFormat::Dxf => design.dxf()?,
        CommandFormat::Scad => design.scad()?,
        CommandFormat::Stl => design.stl()?,
        CommandFormat::Step => design.step()?,
        CommandFormat::Parts => design.svg_parts()?,
        CommandFormat::Csv => cycle(&design)?,
        CommandFormat::Json => fields::json(&design.answer()?)?,
        CommandFormat::Fields => design.answer()?.table(),
        _ => fields::sheet(&fields::with_lengths_in(wanted.unit.unit, design.answer()?), layout),
    })
}

/// The cycle as rows.
fn cycle(design: &WheelDesign) -> anyhow::Result<String> {
    let rows = design.cycle()?;
    fields::csv(rows.first(), rows.iter().cloned())
}

/// Wheels for wanted times or for a wanted dwell, if these are asked for.
fn proposed(question: &WheelQuestion) -> anyhow::Result<Option<MechanismReport>> {
    let WheelQuestion { stations, kind, .. } = *question;
    Ok(match (question.index_time, question.dwell_time, question.dwell_angle) {
        (_, _, Some(dwell)) => Some(proposals_for_angle(dwell, kind)),
        (Some(index), Some(dwell), None) => {
            let times = Times { index, dwell };
            Some(stations.map_or_else(|| Ok(proposals(times, kind)), |stations| speeds(times, stations, kind))?)
        }
        _ => None,
    })
}

/// Writes all that is said of a wheel to a folder: each file is complete or not there. Tells what is where.
fn write_all(design: &WheelDesign, folder: &Path, unit: SheetUnit, layout: TextLayout) -> anyhow::Result<String> {
    // All of them before the first is written: what can't be made leaves nothing.
    let answer = design.answer()?;
    let on_sheet = fields::with_lengths_in(unit, answer.clone());
    let mut files = vec![
        ("sheet.txt", on_sheet.plain_sheet().into_bytes()),
        ("numbers.csv", answer.table().into_bytes()),
        ("cycle.csv", cycle(design)?.into_bytes()),
    ];
    if let Some(figure) = design.sizes_figure() {
        files.push(("sizes.csv", figure.series.to_csv().into_bytes()));
        files.push(("sizes.svg", figure.standalone().into_bytes()));
    }
    for file in SHAPE_FILES {
        if design.can_make(file) {
            files.push((file.name, (file.make)(design)?));
        }
    }
    fs::create_dir_all(folder).with_context(|| {
        format!("--out {}: the folder cannot be made; give one where you may write", folder.display())
    })?;
    let mut written = String::new();
    for (name, bytes) in &files {
        let path = folder.join(name);
        let mut file = NewFile::new(&path, OUT).map_err(Error::msg)?;
        file.add(bytes).map_err(Error::msg)?;
        file.finish().map_err(Error::msg)?;
        written += &format!("  {name}\n");
    }
    let missing: Vec<&str> = SHAPE_FILES.iter().filter(|file| !design.can_make(file)).map(|file| file.name).collect();
    if !missing.is_empty() {
        let why = match design.wheel.kind() {
            WheelKind::Spherical => "because the parts of a spherical wheel are not worked out",
            WheelKind::Internal if design.crank_radius.is_some() && design.question.thickness.is_none() => {
                "because they need the thickness of the wheel: add --thickness MM"
            }
            WheelKind::Internal if design.crank_radius.is_none() => {
                "because they need a size and a thickness: add --crank-radius MM and --thickness MM"
            }
            _ if design.crank_radius.is_some() => {
                "because with so little play, meshes would have more corners than a printer has use for: give a larger --play"
            }
            WheelKind::External | WheelKind::Internal => "because they need a size: add --crank-radius MM",
        };
        written += &format!("Not written, {why}:\n");
        missing.iter().for_each(|name| written += &format!("  {name}\n"));
    }
    let sheet = fields::sheet(&on_sheet, layout);
    Ok(format!("{sheet}\nWritten to {}\n{written}", folder.display()))
}

const OUT: OutputOption = OutputOption { name: "--out", instead: "" };

/// Refuses the first of these options that was given; `why` ends the sentence "… has no effect".
fn reject_any(given: &[GivenOption], refused: impl Fn(&Argument) -> bool, why: &str) -> anyhow::Result<()> {
    match given.iter().find(|(argument, _)| refused(argument)) {
        Some((Argument { name, .. }, text)) => {
            bail!("--{name} {} has no effect {why}", escape_and_shorten(text.trim()))
        }
        None => Ok(()),
    }
}

/// The materials, which count where there are loads.
const MATERIAL_OPTIONS: &[&str] = &["wheel-material", "driver-material", "pin-material"];

/// Refuses options that have no effect where wheels are proposed.
fn reject_with_proposals(wanted: &WheelQuestion, options: &WheelArguments) -> anyhow::Result<()> {
    let (by, counts): (_, &[&str]) = if wanted.dwell_angle.is_some() {
        ("--dwell-angle", &["type", "dwell-angle"])
    } else {
        ("--index-time and --dwell-time", &["type", "stations", "index-time", "dwell-time"])
    };
    let given = &options.asked.given;
    reject_any(
        given,
        |argument| ![counts, MATERIAL_OPTIONS].concat().contains(&argument.name),
        &format!(
            "with {by}, which propose wheels; leave it out now, and give it with the --stations and --rpm of the wheel you \
             choose"
        ),
    )?;
    let why = format!("with {by}, which propose wheels without loads; leave it out");
    reject_any(given, is_named(MATERIAL_OPTIONS), &why)?;
    if options.unit.unit == SheetUnit::In {
        bail!("--unit in has no effect with {by}, which propose wheels without a size; leave it out");
    }
    if options.format == CommandFormat::Fields {
        bail!(
            "--format fields is for one wheel, but {by} propose several; choose --format csv, which has a row for each"
        );
    }
    if is_shape(options.format) {
        bail!(
            "--format {}: {by} propose several wheels; to draw one of them, give its --stations without them",
            options.format.name()
        );
    }
    if let Some(folder) = &options.out {
        bail!(
            "--out {}: {by} propose several wheels; to make one of them, give its --stations and --rpm, or --stations and one \
             of the times",
            folder.display()
        );
    }
    Ok(())
}

/// Refuses options that have no effect for this one wheel. What only numbers need is no fault beside a file of shapes.
fn reject_without_effect(wanted: &WheelQuestion, given: &[GivenOption], format: CommandFormat) -> anyhow::Result<()> {
    let is_external = wanted.kind.is_none_or(|kind| kind == WheelKind::External);
    let is_internal = wanted.kind == Some(WheelKind::Internal);
    let has_parts = is_external || (is_internal && (is_of_parts(format) || wanted.scale().is_some()));
    if is_internal && has_parts && !is_of_parts(format) {
        let why = "on the numbers of an internal wheel, of whose pin and axes no more is worked out; leave it out, or choose --type external";
        reject_any(given, is_named(NOT_OF_INTERNAL), why)?;
        if wanted.thickness.is_none() {
            let why = "on the numbers of an internal wheel without a thickness; add --thickness MM for its inertia";
            reject_any(
                given,
                is_named(&["density", "driver-density", "pin-density", "wheel-strength", "driver-strength"]),
                why,
            )?;
            reject_any(given, is_named(MATERIAL_OPTIONS), why)?;
        }
    }
    if !has_parts {
        let why = if is_internal {
            "on an internal wheel without a size in mm; add --crank-radius MM, or another of the sizes"
        } else {
            "because the parts of a spherical wheel are not worked out; leave it out, or choose --type external"
        };
        reject_any(given, acts_on(ActsOn::Parts), why)?;
    }
    if format == CommandFormat::Svg && !is_external {
        let why = "on --format svg, whose drawing of this kind is not to scale; leave it out, or choose --format text, json or csv";
        reject_any(given, acts_on(ActsOn::Size), why)?;
    }
    if format == CommandFormat::Csv {
        let why = "on --format csv, which has the cycle only; add --out DIR for all files, or choose --format text";
        let is_of_files = |argument: &Argument| acts_on(ActsOn::Files)(argument) && !acts_on(ActsOn::Play)(argument);
        reject_any(given, is_of_files, why)?;
    }
    let is_given = |name: &str| given.iter().any(|(argument, _)| argument.name == name);
    for (argument, _) in given {
        if let Some(without) = argument.missing_dependency(is_given) {
            reject_any(given, is_named(&[argument.name]), &without)?;
        }
    }
    if is_shape(format) && format != CommandFormat::Parts {
        let why = format!(
            "on --format {}, whose lines are the outlines; leave it out, or choose --format parts",
            format.name()
        );
        reject_any(given, is_named(&["kerf"]), &why)?;
    }
    if format == CommandFormat::Fields {
        let why =
            "on --format fields, which has no instants; leave it out, or choose --format csv, which has a row for each";
        reject_any(given, is_named(&["at", "at-wheel"]), why)?;
    }
    let is_given = wanted.numbers().iter().any(|(argument, _)| argument.acts_on.contains(&ActsOn::Size));
    let is_sized = is_given || (wanted.recommends_size && is_external);
    if !is_sized {
        let why = "without a size in mm; add --crank-radius MM, or another of the sizes";
        reject_any(given, acts_on(ActsOn::Parts), why)?;
    }
    if !wanted.has_speed() {
        let why = "without a speed; add --rpm R or --index-time S";
        reject_any(
            given,
            |argument| argument.acts_on.contains(&ActsOn::Inertia) || argument.acts_on.contains(&ActsOn::Load),
            why,
        )?;
    }
    let has_inertia = wanted.numbers().iter().any(|(argument, _)| argument.acts_on.contains(&ActsOn::Inertia));
    if !(has_inertia || is_sized && is_external) {
        let why = "without the wheel's inertia; add --inertia KGM2, with 0 if it is negligible";
        reject_any(given, acts_on(ActsOn::Load), why)?;
    }
    Ok(())
}

/// What acts on numbers that only external wheels have.
const NOT_OF_INTERNAL: &[&str] = &[
    "arm-torque",
    "pin-modulus",
    "pin-poisson",
    "pin-strength",
    "wheel-modulus",
    "wheel-poisson",
    "allowed-pressure",
    "disc-friction",
    "centre-error",
];

/// Whether an argument acts on this.
fn acts_on(what: ActsOn) -> impl Fn(&Argument) -> bool {
    move |argument| argument.acts_on.contains(&what)
}

/// Whether an argument has one of these names.
fn is_named(names: &[&str]) -> impl Fn(&Argument) -> bool {
    move |argument| names.contains(&argument.name)
}

/// Whether a format gives shapes, and not numbers.
fn is_shape(format: CommandFormat) -> bool {
    format == CommandFormat::Svg || is_of_parts(format)
}

/// Whether a format gives the parts that external and internal wheels have.
fn is_of_parts(format: CommandFormat) -> bool {
    use CommandFormat::{Dxf, Parts, Scad, Step, Stl};
    matches!(format, Dxf | Parts | Scad | Step | Stl)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_the_program_asks_what_the_same_words_ask() {
        let value = |argument: &Argument| match argument.place {
            ArgumentSlot::Kind(_) => "internal",
            ArgumentSlot::Choice(NamedChoice { names, .. }) => names[1],
            ArgumentSlot::Process(_) => "fdm",
            ArgumentSlot::Material(_) => "acetal",
            ArgumentSlot::Length(_) => "2in",
            ArgumentSlot::SignedLength(_) | ArgumentSlot::Degrees(_) => "-3",
            _ => "4",
        };
        let words: String = arguments().map(|argument| format!("--{} {} ", argument.name, value(argument))).collect();
        let command = WheelArguments::augment_args(Command::new("wheel"));
        let line = ["wheel"].into_iter().chain(words.split_whitespace());
        let WheelOptions { question: asked, .. } =
            WheelOptions::from_arg_matches(&command.get_matches_from(line)).expect("options");
        assert_eq!(format!("{asked:?}"), format!("{:?}", WheelQuestion::parse(&words).expect("arguments")));
    }

    /// What the command says to these words, with and without a folder for all files, if it refuses.
    fn refusals(words: &str, folder: &Path) -> [Option<String>; 2] {
        let command = WheelArguments::augment_args(Command::new("wheel"));
        let line = ["wheel"].into_iter().chain(words.split_whitespace());
        let mut asked = WheelArguments::from_arg_matches(&command.get_matches_from(line)).expect("options");
        let sheet = page(&asked, TextLayout::default()).err().map(|error| error.to_string());
        asked.out = Some(folder.to_owned());
        [sheet, page(&asked, TextLayout::default()).err().map(|error| error.to_string())]
    }

    #[test]
    fn an_option_is_refused_without_what_it_depends_on_and_taken_beside_it() {
        let folder = tempfile::tempdir().expect("a folder");
        for argument in arguments().filter(|argument| !argument.depends_on.is_empty()) {
            let value = if argument.unit == "GPA" { "200" } else { "0.3" };
            let asked = format!("--stations 6 --crank-radius 25 --{} {value}", argument.name);
            let rest =
                if argument.acts_on.contains(&ActsOn::Load) { "--rpm 60 --wheel-shaft 5 --driver-shaft 5" } else { "" };
            let [sheet, files] = refusals(&format!("{asked} {rest}"), folder.path());
            let refused = format!("--{} {value} has no effect without --", argument.name);
            assert!(sheet.as_ref().is_some_and(|sheet| sheet.starts_with(&refused)), "{asked}: {sheet:?}");
            assert_eq!(sheet, files, "{asked}");
            let on = match argument.depends_on[0] {
                "process" => "--process fdm --thickness 5",
                "arm-torque" => "--arm-torque 1 --thickness 5",
                "mouth-chamfer" => "--mouth-chamfer 0.5 --thickness 5",
                "lead-in" => "--lead-in 3 --thickness 5",
                "bearing-friction" => "--bearing-friction 0.1",
                "driver-inertia" => "--driver-inertia 0.001",
                other => panic!("no value for --{other}"),
            };
            assert_eq!(refusals(&format!("{asked} {rest} {on}"), folder.path()), [None, None], "{asked} {on}");
        }
    }

    #[test]
    fn the_sheet_refuses_just_what_all_files_refuse_in_the_same_words() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut random = fastrand::Rng::with_seed(7);
        const KINDS: &[&str] =
            &["--type external", "--type external", "--type internal --thickness 6", "--type spherical"];
        const CHOICES: &[&str] = &[
            "--wheel-shaft 5",
            "--driver-shaft 5",
            "--plate-shaft 6",
            "--wheel-flat 4.5",
            "--wheel-flat 6",
            "--driver-flat 5.5",
            "--wheel-bore-shape key",
            "--driver-bore-shape key",
            "--pin-diameter 3",
            "--pin-screw M4",
            "--pin-screw-hole nut-trap",
            "--pin-mount dowel",
            "--hub-screw M3",
            "--hub-screw-hole nut-trap",
            "--hub-dowel 2",
            "--hub-holes 5",
            "--wheel-hub-circle 16",
            "--driver-hub-circle 24",
            "--disc-dowel 2",
            "--disc-dowel-circle 20",
            "--disc-dowels 3",
            "--base-thickness 5",
            "--base-screw M4",
            "--shoulder-diameter 9",
            "--shoulder-depth 5",
            "--kerf 0.2",
            "--kerf 9",
            "--thickness 2",
            "--mouth-chamfer 2",
            "--measured-play 0.3",
            "--driver-pieces one-piece",
            "--drive-torque 1",
            "--disc-friction 0.1",
            "--density 1000",
        ];
        let (mut refused, mut accepted) = (0, 0);
        for case in 0..30 {
            let stations = random.u32(3..9);
            let mut words = format!("{} --stations {stations} --crank-radius 25", KINDS[random.usize(..KINDS.len())]);
            let mut left: Vec<&str> = CHOICES.to_vec();
            for _ in 0..random.usize(0..6) {
                let chosen = left.swap_remove(random.usize(..left.len()));
                let name = chosen.split(' ').next().expect("a name");
                if !words.contains(name) {
                    words += &format!(" {chosen}");
                }
            }
            // Few with a process, whose assemblies take long.
            if case % 15 == 0 {
                words += [" --process laser", " --process fdm"][random.usize(..2)];
            }
            let [sheet, files] = refusals(&words, folder.path());
            assert_eq!(sheet, files, "{words}");
            *(if sheet.is_some() { &mut refused } else { &mut accepted }) += 1;
        }
        assert!(refused > 15 && accepted > 3, "{refused} {accepted}");
    }
}
