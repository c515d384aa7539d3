//! What a process does to a wheel: plays and errors with their sources, and the share of assemblies that turn.

use super::design::{WheelDesign, once};
use crate::{Error, Needs, ReportField, Rounding};
use geneva_kinematics::wheel::Sizes;
use geneva_kinematics::wheel::as_built::{Assemblies, BuiltError, ErrorShape, ProcessNumbers, SourcedNumber, Yield};

/// How many assemblies are drawn.
pub const ASSEMBLIES: u64 = 1000;
/// The share of assemblies below which more play is advised: our choice.
const ENOUGH: f64 = 0.9;
/// The seed under which they are drawn: any will do, and the same gives the same assemblies.
const SEED: u64 = 1;

/// How many of 1000 assemblies turn whose sizes are made by a process, with wheel and driver loose on their shafts by the bore play.
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
    count_assemblies(sizes, numbers, Yield::default(), ASSEMBLIES)
}

/// These assemblies and so many more, but no more than [`ASSEMBLIES`] in all; those that are asked for first are counted first.
fn count_assemblies(sizes: &Sizes, numbers: &ProcessNumbers, counted: Yield, more: u64) -> Result<Yield, Error> {
    let too_small = |error: BuiltError| {
        refused!("{error}. The errors of process {} are too large for so small parts", numbers.process.name())
    };
    let assemblies = Assemblies::new(sizes, numbers.errors(), ErrorShape::Normal, SEED).with_bore_play(sizes.play.bore);
    let most = ASSEMBLIES.min(counted.tried.saturating_add(more));
    assemblies.count(counted.tried..most).map(|found| counted.plus(found)).map_err(too_small)
}

impl WheelDesign {
    /// Counts further assemblies that are made by the process that is named: these and so many more, but no more than
    /// [`ASSEMBLIES`] in all. None without a process.
    ///
    /// ```
    /// use geneva_ask::wheel::{ASSEMBLIES, WheelDesign, WheelQuestion};
    /// use geneva_kinematics::wheel::as_built::Yield;
    ///
    /// let design = WheelDesign::new(WheelQuestion::parse("--stations 4 --crank-radius 25 --process fdm")?)?;
    /// let some = design.count_assemblies(Yield::default(), 20)?.expect("a process");
    /// let more = design.count_assemblies(some, 30)?.expect("a process");
    /// assert_eq!((some.tried, more), (20, design.count_assemblies(Yield::default(), 50)?.expect("a process")));
    /// assert!(more.tried < ASSEMBLIES);
    /// # Ok::<(), geneva_ask::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`assemblies_that_turn`].
    pub fn count_assemblies(&self, counted: Yield, more: u64) -> Result<Option<Yield>, Error> {
        let named = self.sizes.as_ref().zip(self.process_numbers()?);
        named.map(|(sizes, numbers)| count_assemblies(sizes, &numbers, counted, more)).transpose()
    }

    /// How many assemblies turn if the parts are made by the process that is named; they are drawn once.
    ///
    /// # Errors
    ///
    /// As for [`assemblies_that_turn`].
    pub(super) fn assemblies_that_turn(&self) -> Result<Option<Yield>, Error> {
        once(&self.turning, || {
            let named = self.sizes.as_ref().zip(self.process_numbers()?);
            named.map(|(sizes, numbers)| assemblies_that_turn(sizes, &numbers)).transpose()
        })
    }
}

/// The numbers of the process for a wheel, each with its source, and the share of assemblies that turn; without numbers where none
/// is named, or the wheel has no size.
///
/// # Errors
///
/// A measured play that is not above zero, and the errors of [`assemblies_that_turn`].
pub(super) fn fields(design: &WheelDesign) -> Result<Vec<ReportField>, Error> {
    let sized = design.sizes.as_ref();
    let numbers = design.process_numbers()?.filter(|_| sized.is_some());
    let found = design.assemblies_that_turn()?;
    let mm = |key, name, of: fn(&ProcessNumbers) -> SourcedNumber| {
        let number = numbers.as_ref().map(of);
        let field = ReportField::in_unit(key, number.map(|number| number.value), "mm");
        field.line(name, number.map_or("", |number| number.source))
    };
    let corner = sized.zip(numbers).and_then(|(sizes, numbers)| numbers.corner_too_large(sizes));
    let tight = ReportField::new("corner_is_too_tight", numbers.map(|_| f64::from(u8::from(corner.is_some()))));
    let tight = match corner {
        Some(_) => {
            tight.words("tightest corner", "too tight for this process: choose a thicker pin or a thinner cutter")
        }
        None => tight,
    };
    let mut fields = vec![
        ReportField::new("process", design.question.process.map(|process| process.name())).needing(Needs::PROCESS),
        mm("process_error_mm", "error of a size", |numbers| numbers.error),
        mm("process_slot_play_mm", "slot play", |numbers| numbers.slot_play),
        mm("process_locking_play_mm", "locking play", |numbers| numbers.locking_play),
        mm("process_bore_play_mm", "bore play", |numbers| numbers.bore_play),
        mm("process_axial_play_mm", "axial play", |numbers| numbers.axial_play),
        mm("process_corner_radius_mm", "inner corners", |numbers| numbers.corner_radius),
        mm("process_hole_growth_mm", "growth of holes", |numbers| numbers.hole_growth),
        mm("process_kerf_mm", "kerf", |numbers| numbers.kerf),
    ];
    fields.extend(yield_fields(found));
    fields.push(tight);
    Ok(ReportField::all_needing(fields, Needs::SIZE.union(Needs::PROCESS)))
}

/// The share of assemblies that turn, with the interval in which it is: of all of them, as [`assemblies_that_turn`] counts them.
pub fn yield_fields(found: Option<Yield>) -> [ReportField; 3] {
    let share = |key, value: Option<f64>| ReportField::in_unit(key, value, "").rounded(Rounding::Percent(1));
    let few = match found {
        Some(found) if found.share() < ENOUGH => ": too few turn, choose more play",
        _ => "",
    };
    let interval = found.map(|found| found.interval());
    [
        share("yield", found.map(Yield::share)).line(
            "yield",
            format!(
                "share of {ASSEMBLIES} simulated assemblies that turn with the play of this wheel; each size is normally distributed, \
                 with a third of its error as standard deviation, and both axes are anywhere within their bore play{few}"
            ),
        ),
        share("yield_low", interval.map(|[low, _]| low)).line("", "at least, with a probability of 97.5 %"),
        share("yield_high", interval.map(|[_, high]| high)).line("", "at most, with a probability of 97.5 %"),
    ]
}
