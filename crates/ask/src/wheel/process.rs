//! What a process does to a wheel: plays and errors with their sources, and the share of assemblies that turn.

use crate::{Error, ReportField, Rounding};
use geneva_kinematics::wheel::Sizes;
use geneva_kinematics::wheel::as_built::{
    Assemblies, BuiltError, ErrorShape, Process, ProcessNumbers, SourcedNumber, Yield,
};

/// How many assemblies are drawn.
pub(super) const ASSEMBLIES: u64 = 1000;
/// The seed under which they are drawn: any will do, and the same gives the same assemblies.
const SEED: u64 = 1;

/// How many of 1000 assemblies turn whose sizes are made by a process.
///
/// ```
/// use geneva_ask::wheel::{WheelDesign, WheelQuestion, assemblies_that_turn};
/// use geneva_kinematics::wheel::as_built::{Process, ProcessNumbers};
///
/// let design = WheelDesign::new(WheelQuestion::parse("--stations 4 --crank-radius 25 --play 0.05")?)?;
/// let share = |process| {
///     let numbers = ProcessNumbers::new(process, 35.0)?; // mm
///     Ok::<_, geneva_ask::Error>(assemblies_that_turn(design.sizes.as_ref().expect("sizes"), &numbers)?.share())
/// };
/// assert!(share(Process::Ground)? > 0.9 && share(Process::Fdm)? < 0.2); // far too little play for a printer
/// # Ok::<(), geneva_ask::Error>(())
/// ```
///
/// # Errors
///
/// Parts so small that an error of the process leaves nothing of a size.
pub fn assemblies_that_turn(sizes: &Sizes, numbers: &ProcessNumbers) -> Result<Yield, Error> {
    let too_small = |error: BuiltError| {
        refused!("{error}. The errors of process {} are too large for so small parts", numbers.process.name())
    };
    let assemblies = Assemblies::new(sizes, numbers.errors(), ErrorShape::Normal, SEED);
    assemblies.count(0..ASSEMBLIES).map_err(too_small)
}

/// The numbers of a process for a wheel, each with its source, and the share of assemblies that turn.
///
/// With the least play in millimetres with which a pin ran on the test piece, its plays and its error are from there.
///
/// ```
/// use geneva_ask::wheel::{WheelDesign, WheelQuestion, process_fields};
/// use geneva_kinematics::wheel::as_built::Process;
///
/// let design = WheelDesign::new(WheelQuestion::parse("--stations 4 --crank-radius 25 --play 0.8")?)?;
/// let fields = process_fields(design.sizes.as_ref().expect("sizes"), Process::Fdm, None)?;
/// let share = fields.iter().find(|field| field.key == "yield").and_then(|field| field.number());
/// assert!(share.is_some_and(|share| share > 0.95));
/// # Ok::<(), geneva_ask::Error>(())
/// ```
///
/// # Errors
///
/// A measured play that is not above zero, and the errors of [`assemblies_that_turn`].
pub fn process_fields(sizes: &Sizes, process: Process, measured_play: Option<f64>) -> Result<Vec<ReportField>, Error> {
    let numbers = ProcessNumbers::new(process, sizes.centre_distance)?;
    let numbers = measured_play.map_or(Ok(numbers), |play| numbers.with_measured_play(play))?;
    let found = assemblies_that_turn(sizes, &numbers)?;
    let [low, high] = found.interval();
    let mm = |key, name, number: SourcedNumber| ReportField::in_unit(key, number.value, "mm").line(name, number.source);
    let share = |key, value: f64| ReportField::in_unit(key, value, "").rounded(Rounding::Percent(1));
    let mut fields = vec![
        ReportField::new("process", process.name()),
        mm("process_error_mm", "error of a size", numbers.error),
        mm("process_slot_play_mm", "slot play", numbers.slot_play),
        mm("process_locking_play_mm", "locking play", numbers.locking_play),
        mm("process_bore_play_mm", "bore play", numbers.bore_play),
        mm("process_axial_play_mm", "axial play", numbers.axial_play),
        mm("process_corner_radius_mm", "inner corners", numbers.corner_radius),
        mm("process_hole_growth_mm", "growth of holes", numbers.hole_growth),
        mm("process_kerf_mm", "kerf", numbers.kerf),
        share("yield", found.share()).line(
            "yield",
            format!("share of {} simulated assemblies that turn, with the play of this wheel", found.tried),
        ),
        share("yield_low", low).line("", "at least, with a probability of 97.5 %"),
        share("yield_high", high).line("", "at most, with a probability of 97.5 %"),
    ];
    let corner = numbers.corner_too_large(sizes);
    fields.push(match corner {
        Some(least) => ReportField::in_unit("tightest_corner_mm", least, "mm")
            .line("tightest corner", "too tight for this process: choose a thicker pin or a thinner cutter"),
        None => ReportField::in_unit("tightest_corner_mm", corner, "mm"),
    });
    Ok(fields)
}
