//! What a process does to a wheel: plays and errors with their sources, and the share of assemblies that turn.

use super::design::{WheelDesign, once};
use super::kind::WheelKind;
use crate::number_format::{as_typed, number, rounded};
use crate::{Error, Needs, ReportField, Rounding};
use geneva_kinematics::internal_assemblies::InternalAssemblies;
use geneva_kinematics::wheel::as_built::{
    Assemblies, BuiltError, ErrorShape, ProcessNumbers, SourcedNumber, TestPiece, Yield,
};

/// How many assemblies are drawn.
pub const ASSEMBLIES: u64 = 1000;
/// The share of assemblies below which more play is advised: our choice.
pub(super) const ENOUGH: f64 = 0.9;
/// The seed under which they are drawn: any will do, and the same gives the same assemblies.
pub(super) const SEED: u64 = 1;

impl WheelDesign {
    /// Counts further assemblies that turn, made by the process that is named, with wheel, driver and screwed pins as loose as their holes
    /// let them be: these and so many more, but no more than [`ASSEMBLIES`] in all; those that are asked for first are counted first.
    /// None without a process, and of a wheel that is not external.
    ///
    /// ```
    /// use geneva_ask::wheel::{ASSEMBLIES, WheelDesign, WheelQuestion};
    /// use geneva_kinematics::wheel::as_built::Yield;
    ///
    /// let design = |more| WheelDesign::new(WheelQuestion::parse(&format!("--stations 4 --crank-radius 25 {more}"))?);
    /// let printed = design("--process fdm")?;
    /// let some = printed.count_assemblies(Yield::default(), 20)?.expect("a process");
    /// let more = printed.count_assemblies(some, 30)?.expect("a process");
    /// assert_eq!((some.tried, more), (20, printed.count_assemblies(Yield::default(), 50)?.expect("a process")));
    /// assert!(more.tried < ASSEMBLIES);
    /// let tight = design("--process fdm --play 0.05")?.count_assemblies(Yield::default(), 50)?.expect("a process");
    /// assert!(tight.share() < 0.2); // far too little play for a printer
    /// # Ok::<(), geneva_ask::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Parts so small that an error of the process leaves nothing of a size.
    pub fn count_assemblies(&self, counted: Yield, more: u64) -> Result<Option<Yield>, Error> {
        let Some((sizes, numbers)) = self.sizes.as_ref().zip(self.process_numbers()?) else { return Ok(None) };
        let too_small = |error: BuiltError| {
            refused!("{error}. The errors of process {} are too large for so small parts", numbers.process.name())
        };
        let assemblies = Assemblies::new(sizes, numbers.errors(), ErrorShape::Normal, SEED)
            .with_bore_play(sizes.play.bore)
            .with_pin_shift(sizes.play.pin)
            .with_disc_turn(self.disc_turn());
        let most = ASSEMBLIES.min(counted.tried.saturating_add(more));
        assemblies.count(counted.tried..most).map(|found| Some(counted.plus(found))).map_err(too_small)
    }

    /// How many assemblies turn if the parts are made by the process that is named; of an internal wheel, how many do for certain. They
    /// are drawn once.
    ///
    /// # Errors
    ///
    /// As for [`count_assemblies`](Self::count_assemblies).
    pub(super) fn assemblies_that_turn(&self) -> Result<Option<Yield>, Error> {
        once(&self.turning, || {
            let internal = self.reported_internal_sizes()?.zip(self.process_numbers()?);
            let of_internal = internal.map(|(sizes, numbers)| {
                InternalAssemblies::new(&sizes, numbers.errors(), ErrorShape::Normal, SEED).count(0..ASSEMBLIES)
            });
            of_internal.map_or_else(|| self.count_assemblies(Yield::default(), ASSEMBLIES), |found| Ok(Some(found)))
        })
    }
}

/// The numbers of the process for a wheel, each with its source, and the share of assemblies that turn; without numbers where none
/// is named, or the wheel has no size.
///
/// # Errors
///
/// A measured play that is not above zero, and the errors of [`WheelDesign::count_assemblies`].
pub(super) fn fields(design: &WheelDesign) -> Result<Vec<ReportField>, Error> {
    let of_external = design.sizes.map(|sizes| sizes.slot_width);
    let slot_width = of_external.or(design.reported_internal_sizes()?.map(|sizes| sizes.slot_width));
    let numbers = design.process_numbers()?.filter(|_| slot_width.is_some());
    let found = design.assemblies_that_turn()?;
    let mm = |key, name, of: fn(&ProcessNumbers) -> SourcedNumber| {
        let number = numbers.as_ref().map(of);
        let field = ReportField::in_unit(key, number.map(|number| number.value), "mm");
        field.line(name, number.map_or("", |number| number.source))
    };
    let corner = slot_width.zip(numbers).and_then(|(width, numbers)| numbers.corner_too_large(width));
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
        hole_growth(numbers.as_ref()),
        kerf(design, numbers.as_ref()),
    ];
    fields.push(test_piece(design, numbers.is_some())?);
    fields.extend(yield_fields(found, design.wheel.kind()));
    fields.push(tight);
    Ok(ReportField::all_needing(fields, Needs::SIZE.union(Needs::PROCESS)))
}

/// The plate of the test piece: how large it is, and what the numbers on it mean.
fn test_piece(design: &WheelDesign, has_process: bool) -> Result<ReportField, Error> {
    let pin = design
        .sizes
        .map(|sizes| sizes.pin_diameter)
        .or(design.reported_internal_sizes()?.map(|sizes| sizes.pin_diameter));
    let made = pin.zip(design.made_thickness()).filter(|_| has_process);
    let piece = made.map(|(pin, thickness)| Ok::<_, Error>((TestPiece::new(pin)?, pin, thickness))).transpose()?;
    // Its plate is a rectangle from the origin on.
    let size = |piece: &TestPiece, axis: usize| {
        piece.plate.outer.edges.iter().map(|edge| edge.start_point()[axis]).fold(0.0, f64::max)
    };
    let width = piece.as_ref().map(|(piece, ..)| size(piece, 0));
    let field = ReportField::in_unit("test_piece_width_mm", width, "mm");
    Ok(match &piece {
        Some((piece, pin, thickness)) => {
            let [first, last] = [piece.plays.first(), piece.plays.last()].map(|play| play.copied().unwrap_or_default());
            field.line(
                "test piece",
                format!(
                    "width of its plate, which is {} mm high and {} mm thick. Each of its {} slots is wider than the pins of {} mm by the \
                     number below it, in hundredths of a millimetre: {} to {}. Give the least one in which all {} pins run from end to end \
                     as --measured-play {} to {}",
                    number(size(piece, 1)),
                    as_typed(*thickness),
                    piece.plays.len(),
                    number(*pin),
                    libm::round(100.0 * first),
                    libm::round(100.0 * last),
                    piece.pins.len(),
                    as_typed(rounded(first)),
                    as_typed(rounded(last)),
                ),
            )
        }
        None => field,
    })
}

/// How much wider holes become than drawn, and which files have them drawn otherwise for that.
fn hole_growth(numbers: Option<&ProcessNumbers>) -> ReportField {
    let growth = numbers.map(|numbers| numbers.hole_growth);
    let files = match growth {
        Some(growth) if growth.value != 0.0 => {
            "; STL, 3MF, STEP and OpenSCAD have all holes but the slots drawn so much the other way; drawings, DXF and parts.svg have the \
             sizes that the holes should become"
        }
        _ => "",
    };
    let field = ReportField::in_unit("process_hole_growth_mm", growth.map(|growth| growth.value), "mm");
    field.line("growth of holes", growth.map_or_else(String::new, |growth| format!("{}{files}", growth.source)))
}

/// The width of the cut: what is given, or that of the process, and which files allow for it.
fn kerf(design: &WheelDesign, numbers: Option<&ProcessNumbers>) -> ReportField {
    let given = design.question.mounting.kerf;
    let width = numbers.map(|numbers| given.unwrap_or(numbers.kerf.value));
    let source = numbers.map_or("", |numbers| if given.is_some() { "as given" } else { numbers.kerf.source });
    let files = match width {
        Some(width) if width != 0.0 => {
            "; parts.svg has its lines moved by half of it, DXF and drawings have the true sizes: set it at the machine"
        }
        _ => "",
    };
    ReportField::in_unit("process_kerf_mm", width, "mm").line("kerf", format!("{source}{files}"))
}

/// The share of assemblies of such a wheel that turn, with the interval in which it is: of all of them, as
/// [`WheelDesign::count_assemblies`] counts them.
pub fn yield_fields(found: Option<Yield>, kind: WheelKind) -> [ReportField; 3] {
    let share = |key, value: Option<f64>| ReportField::in_unit(key, value, "").rounded(Rounding::Percent(1));
    let is_internal = kind == WheelKind::Internal;
    let few = match found {
        // Of a lower bound it is not known whether it is too low.
        Some(found) if found.share() < ENOUGH && is_internal => ": with more play, more do",
        Some(found) if found.share() < ENOUGH => ": too few turn, choose more play or tighter bores",
        _ => "",
    };
    let interval = found.map(|found| found.interval());
    let for_certain = if is_internal { "for certain " } else { "" };
    let [low, high] = if is_internal {
        [
            "at least, with a probability of about 97.5 % (Wilson's interval); those count for which a clear way to turn is found, so no upper \
             limit is known. Width and end of a slot, pin, crank radius and axes vary by the error of a size; radii and places by half of it",
            "",
        ]
    } else {
        [
            "at least, with a probability of about 97.5 % (Wilson's interval)",
            "at most, likewise. Every slot, arc, pin and crescent varies by itself: width and end of a slot, pin, crank radius and axes by the \
             error of a size; radii and places by half of it. A wheel whose pin pushes the corner of a mouth aside counts as one that turns",
        ]
    };
    [
        share("yield", found.map(Yield::share)).line(
            "yield",
            format!(
                "share of {ASSEMBLIES} simulated assemblies that turn {for_certain}with the play of this wheel; each size is normally \
                 distributed, with a third of its error as standard deviation, and both axes are anywhere within their bore play{few}"
            ),
        ),
        share("yield_low", interval.map(|[low, _]| low)).line("", low),
        // What is counted of an internal wheel is a lower bound, and the upper limit of that is none of the share.
        share("yield_high", interval.map(|[_, high]| high).filter(|_| !is_internal)).line("", high),
    ]
}

#[cfg(test)]
mod tests {
    use crate::{ReportField, answer};

    #[test]
    fn the_sheet_says_how_large_the_test_piece_is_and_what_its_numbers_mean() {
        let asked = "wheel --stations 6 --crank-radius 40 --pin-diameter 6 --thickness 5 --process fdm";
        let report = answer(asked).expect(asked);
        let field = report.field("test_piece_width_mm").expect("a field");
        // Twelve slots of 6 mm with walls of half a pin, and their play.
        assert_eq!(field.number(), Some(12.0 * 9.6 + 6.0));
        let said = field.line.as_ref().map_or("", |line| &line.meaning);
        for words in
            ["30.6", "5 mm thick", "12 slots", "hundredths of a millimetre: 5 to 60", "--measured-play 0.05 to 0.6"]
        {
            assert!(said.contains(words), "{words}: {said}");
        }
        let without = answer("wheel --stations 6 --crank-radius 40").expect("an answer");
        assert_eq!(without.field("test_piece_width_mm").and_then(ReportField::number), None);
    }

    #[test]
    fn an_internal_wheel_has_a_lower_limit_of_its_yield_and_says_why_no_upper_one() {
        let of = |kind: &str| {
            answer(&format!("wheel --stations 6 --type {kind} --crank-radius 40 --process fdm")).expect(kind)
        };
        let number = |kind: &str, key: &str| of(kind).field(key).and_then(ReportField::number);
        let [share, low] = ["yield", "yield_low"].map(|key| number("internal", key).expect(key));
        assert!(low < share && number("internal", "yield_high").is_none());
        let ring = of("internal");
        let said = ring.field("yield_low").and_then(|field| field.line.as_ref()).map_or("", |line| &line.meaning);
        assert!(said.contains("no upper limit is known"), "{said}");
        let [share, low, high] = ["yield", "yield_low", "yield_high"].map(|key| number("external", key).expect(key));
        assert!(low < share && share < high && high <= 1.0, "{low} {share} {high}");
    }

    #[test]
    fn a_play_measured_on_the_test_piece_is_that_of_bores_that_have_none_of_their_own() {
        for (kind, process, bore) in [
            // A rung of the ladder is added, and a quarter is the bores'.
            ("external", "mill", 0.0375),
            ("external", "laser", 0.0375),
            ("internal", "router", 0.0375),
            ("external", "resin", 0.25),
            ("external", "fdm", 0.4),
            ("internal", "fdm", 0.4),
        ] {
            let asked = format!(
                "wheel --stations 6 --type {kind} --crank-radius 40 --process {process} --measured-play 0.1 --wheel-shaft 8"
            );
            let report = answer(&asked).expect(&asked);
            let number = |key: &str| report.field(key).and_then(ReportField::number).expect(key);
            assert!((number("process_slot_play_mm") - 0.15).abs() < 1e-12, "{asked}");
            for key in ["process_bore_play_mm", "bore_play_mm"] {
                assert!((number(key) - bore).abs() < 1e-12, "{asked}: {key} {}", number(key));
            }
            assert!((number("wheel_bore_mm") - 8.0 - bore).abs() < 1e-12, "{asked}");
        }
    }
}
