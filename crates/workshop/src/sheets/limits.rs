//! By how much a size may be off: the letters of ISO 286, the chains of all sizes, and general tolerances.

use super::drawn_sizes::DrawnSizes;
use super::length::{deviation, mm};
use geneva_kinematics::wheel::ToleranceLetter::{LowerH, LowerM, UpperH, UpperJs, UpperP};
use geneva_kinematics::wheel::{SharedTolerance, ToleranceClass};

/// Classes of slots, shafts and holes: our choice among those that shops use.
pub(super) const SLOT: ToleranceClass = ToleranceClass { letter: UpperH, grade: 8 };
pub(super) const BORE: ToleranceClass = ToleranceClass { letter: UpperH, grade: 7 };
/// A shaft for such a bore: the pair H7/h6 slides, and no shaft is thicker than its bore even without play.
pub(super) const SHAFT: ToleranceClass = ToleranceClass { letter: LowerH, grade: 6 };
pub(super) const DISC: ToleranceClass = ToleranceClass { letter: LowerH, grade: 8 };
pub(super) const RIM: ToleranceClass = ToleranceClass { letter: LowerH, grade: 9 };
pub(super) const KEYWAY: ToleranceClass = ToleranceClass { letter: UpperJs, grade: 9 };
/// A dowel as it is sold (ISO 8734) and its reamed hole, or a thinner pin in a narrower hole.
const DOWEL: [ToleranceClass; 2] =
    [ToleranceClass { letter: LowerM, grade: 6 }, ToleranceClass { letter: UpperH, grade: 7 }];
const PRESSED: [ToleranceClass; 2] =
    [ToleranceClass { letter: LowerH, grade: 6 }, ToleranceClass { letter: UpperP, grade: 7 }];
/// The grade of what has a limit by no chain.
const PLACE: ToleranceClass = ToleranceClass { letter: UpperJs, grade: 7 };

/// Where the limits of a size come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitOrigin {
    /// A class of ISO 286, or general tolerances.
    Standard,
    /// A tolerance chain, which leaves less than these.
    Chain,
    /// The greatest error of the process, which holds no less.
    Process,
    /// The greatest error of the process, though a tolerance chain leaves less.
    ProcessBeyondChain,
}

impl LimitOrigin {
    /// What marks such limits on a sheet.
    pub(super) fn mark(self) -> &'static str {
        match self {
            Self::Standard | Self::Process => "",
            Self::Chain => "†",
            Self::ProcessBeyondChain => "‡",
        }
    }
}

/// Limits of a size with their sign, in millimetres, and where they come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Limits {
    pub lower: f64,
    pub upper: f64,
    /// The class with just these limits.
    pub class: Option<ToleranceClass>,
    pub origin: LimitOrigin,
}

impl Limits {
    pub(super) fn new([lower, upper]: [f64; 2]) -> Self {
        Self { lower, upper, class: None, origin: LimitOrigin::Standard }
    }

    /// Limits of a class, or one-sided general ones for sizes that the standard's classes don't have.
    pub(super) fn class(class: ToleranceClass, nominal: f64) -> Self {
        match class.limits(nominal) {
            Some(limits) => Self { class: Some(class), ..Self::new(limits) },
            None => {
                let general = general_tolerance(nominal);
                Self::new(match class.letter {
                    UpperH => [0.0, general],
                    LowerH => [-general, 0.0],
                    _ => [-general, general],
                })
            }
        }
    }

    /// Limits of a radius, which are half of those of the diameter.
    pub(super) fn of_radius(class: ToleranceClass, radius: f64) -> Self {
        let limits = Self::class(class, 2.0 * radius);
        Self::new([to_micrometres(limits.lower / 2.0), to_micrometres(limits.upper / 2.0)])
    }

    /// The limits, and no farther than these ones of a chain, in whole micrometres.
    pub(super) fn within(self, [below, above]: [f64; 2]) -> Self {
        let lower = self.lower.max(-to_micrometres(below));
        let upper = self.upper.min(to_micrometres(above));
        if lower == self.lower && upper == self.upper {
            return self;
        }
        Self { lower: lower.min(upper), upper, class: None, origin: LimitOrigin::Chain }
    }

    /// The limits, or the greatest error of a process to either side if it holds no less; in whole micrometres. `chain` is what a
    /// tolerance chain leaves below and above.
    pub(super) fn held(self, error: Option<f64>, chain: [f64; 2]) -> Self {
        let narrowed = self.within(chain);
        let Some(error) = error.map(whole_micrometres) else { return narrowed };
        if narrowed.upper - narrowed.lower >= 2.0 * error - 1e-9 {
            return narrowed;
        }
        let is_beyond = chain.into_iter().any(|left| left < error - 1e-9);
        let origin = if is_beyond { LimitOrigin::ProcessBeyondChain } else { LimitOrigin::Process };
        Self { lower: -error, upper: error, class: None, origin }
    }

    /// How the limits are written behind a size: one text, or an upper and a lower one.
    pub(super) fn words(&self) -> Result<String, [String; 2]> {
        if self.upper == -self.lower {
            Ok(format!("±{}", mm(self.upper)))
        } else {
            Err([self.upper, self.lower].map(deviation))
        }
    }
}

/// The largest number of whole micrometres in a tolerance that is zero or more, in millimetres.
pub(super) fn to_micrometres(x: f64) -> f64 {
    let whole = |x: f64| libm::floor(x * 1000.0 + 1e-6) / 1000.0;
    if x.is_infinite() {
        x
    } else if x < 0.0 {
        -whole(-x)
    } else {
        whole(x)
    }
}

/// A tolerance rounded up to micrometres, in millimetres.
pub(super) fn whole_micrometres(x: f64) -> f64 {
    libm::ceil(x * 1000.0 - 1e-6) / 1000.0
}

/// Greatest sizes and tolerances of lengths: ISO 2768-1, class m, in millimetres.
const GENERAL: [[f64; 2]; 7] =
    [[6.0, 0.1], [30.0, 0.2], [120.0, 0.3], [400.0, 0.5], [1000.0, 0.8], [2000.0, 1.2], [f64::INFINITY, 2.0]];

/// How much a length without limits may be off, in millimetres: ISO 2768-1, class m. For less than 0.5 mm the standard asks for
/// limits, and a fifth of the length is our choice.
pub(super) fn general_tolerance(nominal: f64) -> f64 {
    if nominal < 0.5 {
        return to_micrometres(nominal / 5.0);
    }
    GENERAL.iter().find(|[up_to, _]| nominal <= *up_to).map_or(2.0, |[_, by]| *by)
}

/// What the tolerance chains leave to the sizes of each part, in millimetres.
///
/// Some errors of the chains are made by two or three sizes on paper, and these share it:
/// axes that are off are half by their own place and half by bores and shafts, a quarter each; a slot that is off its place between
/// the arcs is half by the slots' places and half by the arcs'.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chain {
    /// How much nearer and farther the axes may be.
    pub axes: [f64; 2],
    /// How much wider a bore may be, and how much thinner its shaft.
    pub bore: f64,
    /// How much longer or shorter the crank radius may be.
    pub crank: f64,
    /// How much thicker the pin may be and narrower the slot.
    pub width: f64,
    /// How much farther out the slot's end may be.
    pub slot_end: f64,
    /// How much longer the disc's radius may be and shorter the arc's.
    pub locking: f64,
    /// Width of the zone for the middle of a slot at its mouth.
    pub slot_zone: f64,
    /// Diameter of the zone for the middle of a locking arc.
    pub arc_zone: f64,
    /// Whether these are the limits of the chains, and not only a choice.
    pub is_known: bool,
}

impl Chain {
    /// The limits of the chains; where they leave nothing, what is usual, or nothing if a process says what is held.
    pub(super) fn new(sizes: DrawnSizes<'_>, shared: Option<SharedTolerance>, has_process: bool) -> Self {
        let otherwise = || if has_process { Self::NOTHING } else { Self::chosen(sizes) };
        Self::of_chains(sizes, shared).filter(|chain| chain.least() > 0.0).unwrap_or_else(otherwise)
    }

    const NOTHING: Self = Self {
        axes: [0.0; 2],
        bore: 0.0,
        crank: 0.0,
        width: 0.0,
        slot_end: 0.0,
        locking: 0.0,
        slot_zone: 0.0,
        arc_zone: 0.0,
        is_known: false,
    };

    /// What is usual where the chains leave nothing that can be written in micrometres.
    fn chosen(sizes: DrawnSizes<'_>) -> Self {
        let place = |nominal| Limits::class(PLACE, nominal).upper;
        Self {
            axes: [place(sizes.centre_distance()); 2],
            bore: f64::INFINITY,
            crank: place(sizes.crank_radius()),
            width: f64::INFINITY,
            slot_end: general_tolerance(sizes.slot_end()),
            locking: f64::INFINITY,
            slot_zone: to_micrometres(place(sizes.wheel_radius())),
            arc_zone: to_micrometres(2.0 * place(sizes.wheel_radius())),
            is_known: false,
        }
    }

    fn of_chains(sizes: DrawnSizes<'_>, shared: Option<SharedTolerance>) -> Option<Self> {
        let shared = shared?;
        let least = shared.nearer.min(shared.farther);
        Some(Self {
            axes: [to_micrometres(shared.nearer / 2.0), to_micrometres(shared.farther / 2.0)],
            bore: least / 4.0,
            crank: to_micrometres(shared.crank),
            width: shared.width,
            slot_end: shared.slot_end,
            locking: shared.locking,
            // Half of the direction's limit to either side, so the zone is as wide as the limit at the mouth.
            slot_zone: to_micrometres(sizes.wheel_radius() * libm::sin(shared.direction)),
            // The arc's middle may be off towards the wheel by the disc's limit, and sideways by half of the direction's.
            arc_zone: to_micrometres((2.0 * shared.locking).min(sizes.centre_distance() * shared.direction)),
            is_known: true,
        })
    }

    /// The least of what it leaves to a place or a length, in millimetres.
    pub(super) fn least(&self) -> f64 {
        [self.axes[0], self.axes[1], self.crank, self.slot_zone, self.arc_zone]
            .into_iter()
            .fold(f64::INFINITY, f64::min)
    }

    /// Classes of a pin and of its hole in the plate.
    pub(super) fn pin_classes(&self, diameter: f64) -> [ToleranceClass; 2] {
        let is_within = DOWEL[0].limits(diameter).is_some_and(|[_, upper]| upper <= self.width);
        if is_within { DOWEL } else { PRESSED }
    }
}
