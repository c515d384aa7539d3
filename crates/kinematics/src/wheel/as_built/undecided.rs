//! Measured sizes of which one is wrong while the measurements don't say which one, and what to measure so that they do.
//!
//! Each size in doubt is left out in turn. The fit to the others says what a size that was not measured would then be. If it would
//! be something else for each of them, its measurement tells which one is wrong.

use super::measured::{MeasuredSize, MeasuredWheel};
use super::nearest::NearestWheel;
use super::right_wheel::{Free, Right, design};
use crate::indexing::Indexing;
use crate::wheel::Wheel;

/// Why one of some measured sizes is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DoubtReason {
    /// They contradict each other: without any single one of them the others agree.
    Contradiction,
    /// A pin has more play in its slot, or the disc in its arc, than an ordinary one, so one of the two is worn.
    Play {
        /// The play as a difference of widths or diameters, in millimetres.
        play: f64,
        /// The greatest ordinary play, in millimetres.
        most: f64,
    },
    /// No wheel can be drawn with all of them.
    NoDesign,
}

/// Measured sizes of which one is wrong, though the measurements don't say which one.
#[derive(Clone, Debug, PartialEq)]
pub struct UndecidedCulprit {
    /// Why one of them is wrong.
    pub doubt: DoubtReason,
    /// The sizes. A single one contradicts all others.
    pub sizes: Vec<MeasuredSize>,
    /// Sizes that were not measured, each of which tells which one is wrong: the easiest to measure first. None if nothing would.
    pub telling: Vec<MeasuredSize>,
}

/// Wear that can't be told from an ordinary play.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UntoldWear {
    /// What may be worn: the wide part, and the thin one.
    pub sizes: [MeasuredSize; 2],
    /// The wear is less than this, in millimetres, as a difference of widths or diameters: the play when new was not below zero.
    pub below: f64,
    /// The play, in millimetres.
    pub play: f64,
}

/// The play of two measured parts that may be worn, in millimetres.
#[derive(Clone, Copy, Debug)]
struct OpenPlay {
    play: f64,
    /// The greatest ordinary one.
    most: f64,
    /// By how much it may be more or less, as it was measured.
    within: f64,
    sizes: [MeasuredSize; 2],
}

impl OpenPlay {
    fn is_loose(&self) -> bool {
        self.play > self.most + self.within
    }
}

/// What can be measured besides, the easiest first.
const MEASURABLE: [MeasuredSize; 9] = [
    MeasuredSize::CentreDistance,
    MeasuredSize::CrankRadius,
    MeasuredSize::TipRadius,
    MeasuredSize::PinDiameter,
    MeasuredSize::SlotWidth(None),
    MeasuredSize::DiscRadius,
    MeasuredSize::ArcRadius(None),
    MeasuredSize::ArcCentre(None),
    MeasuredSize::SlotEnd(None),
];

/// Uncertainties by which a size must differ for two culprits, so that its measurement tells which one it is: our choice.
const TELLING: f64 = 4.0;
/// Uncertainties by which a play must be more than an ordinary one: our choice.
const BEYOND: f64 = 3.0;
/// Numbers of stations that are tried where those that were counted don't fit.
const STATIONS: std::ops::RangeInclusive<u32> = 3..=24;

impl MeasuredWheel {
    /// All doubts that the nearest right wheel leaves: none if a single size is wrong, or no size is.
    ///
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    /// use geneva_kinematics::wheel::as_built::{MeasuredSize, MeasuredWheel};
    ///
    /// let mut measured = MeasuredWheel::new(Wheel::new(6)?);
    /// measured.add(MeasuredSize::CentreDistance, 51.0, 0.05)?; // mm
    /// measured.add(MeasuredSize::CrankRadius, 25.0, 0.05)?; // mm, right for 50 mm
    /// let doubts = measured.undecided_culprits(&measured.nearest()?);
    /// assert_eq!(doubts[0].sizes, [MeasuredSize::CentreDistance, MeasuredSize::CrankRadius]);
    /// assert_eq!(doubts[0].telling[0], MeasuredSize::TipRadius);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn undecided_culprits(&self, nearest: &NearestWheel) -> Vec<UndecidedCulprit> {
        let mut found: Vec<UndecidedCulprit> = self.contradiction(nearest).into_iter().collect();
        found.extend(self.plays(nearest));
        if found.is_empty() && nearest.culprit.is_none() && nearest.refusal.is_some() {
            found.push(self.no_design());
        }
        found
    }

    /// The sizes any of which may be the culprit.
    fn contradiction(&self, nearest: &NearestWheel) -> Option<UndecidedCulprit> {
        let culprit = nearest.culprit.filter(|_| !nearest.suspects.is_empty())?;
        let is_further = |size: MeasuredSize, value: f64| {
            nearest.further_culprits.iter().any(|of| of.size == size && of.measured == value)
        };
        let places = (0..self.sizes().len()).filter(|place| {
            let of = self.sizes()[*place];
            !is_further(of.size, of.value)
        });
        let all = self.only(&places.collect::<Vec<_>>());
        let mut sizes: Vec<MeasuredSize> = [culprit.size].into_iter().chain(nearest.suspects.iter().copied()).collect();
        let mut telling = all.telling(&sizes);
        telling.retain(|size| !self.has(|of| of.name() == size.name()));
        // What contradicts besides rests on which one it is, but for a single slot or arc, which has its like.
        sizes.extend(nearest.further_culprits.iter().map(|of| of.size).filter(|size| size.number().is_none()));
        Some(UndecidedCulprit { doubt: DoubtReason::Contradiction, sizes: distinct(sizes), telling })
    }

    /// The plays of pin and slot and of disc and arc where both are measured, and neither's size when it was new.
    fn open_plays(&self, nearest: &NearestWheel) -> impl Iterator<Item = OpenPlay> {
        use MeasuredSize as Size;
        let right = Right { wheel: self.wheel(), free: free_sizes(nearest) };
        let most = right.greatest_play();
        let uncertainty = |is_it: fn(Size) -> bool| {
            self.sizes().iter().filter(|of| is_it(of.size)).map(|of| of.uncertainty).fold(0.0, f64::max)
        };
        let slot_uncertainty = libm::hypot(
            uncertainty(|size| matches!(size, Size::SlotWidth(_))),
            uncertainty(|size| size == Size::PinDiameter),
        );
        let arc_uncertainty = 2.0
            * libm::hypot(
                uncertainty(|size| matches!(size, Size::ArcRadius(_))),
                uncertainty(|size| size == Size::DiscRadius),
            );
        let slots = OpenPlay {
            play: nearest.slot_width - nearest.pin_diameter,
            most,
            within: BEYOND * slot_uncertainty,
            sizes: [Size::SlotWidth(None), Size::PinDiameter],
        };
        let arcs = OpenPlay {
            play: 2.0 * (nearest.arc_radius - nearest.disc_radius),
            within: BEYOND * arc_uncertainty,
            sizes: [Size::ArcRadius(None), Size::DiscRadius],
            ..slots
        };
        [slots, arcs].into_iter().zip(self.may_be_loose()).filter(|(_, is_open)| *is_open).map(|(of, _)| of)
    }

    /// Plays that are more than ordinary, of pin and slot and of disc and arc.
    fn plays(&self, nearest: &NearestWheel) -> impl Iterator<Item = UndecidedCulprit> {
        self.open_plays(nearest).filter(OpenPlay::is_loose).map(|of| UndecidedCulprit {
            doubt: DoubtReason::Play { play: of.play, most: of.most },
            sizes: of.sizes.into(),
            telling: of.sizes.into_iter().filter_map(MeasuredSize::size_when_new).collect(),
        })
    }

    /// The wear that the measurements can't tell from an ordinary play, because no size when new is known: of pin and slots, and of disc
    /// and arcs, as far as both of the two were measured. None where the play is more than an ordinary one, which is a
    /// [doubt](Self::undecided_culprits).
    ///
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    /// use geneva_kinematics::wheel::as_built::{MeasuredSize, MeasuredWheel};
    ///
    /// let mut measured = MeasuredWheel::new(Wheel::new(6)?);
    /// measured.add(MeasuredSize::CrankRadius, 50.0, 0.01)?; // mm
    /// measured.add(MeasuredSize::PinDiameter, 10.0, 0.01)?;
    /// measured.add(MeasuredSize::SlotWidth(None), 10.1, 0.01)?;
    /// let untold = measured.untold_wear(&measured.nearest()?);
    /// assert!((untold[0].below - 0.1).abs() < 0.05); // mm: all of the play may be wear
    /// measured.add(MeasuredSize::NewSlotWidth, 10.05, 0.01)?;
    /// assert!(measured.untold_wear(&measured.nearest()?).is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn untold_wear(&self, nearest: &NearestWheel) -> Vec<UntoldWear> {
        let ordinary = self.open_plays(nearest).filter(|of| !of.is_loose());
        ordinary.map(|of| UntoldWear { sizes: of.sizes, below: of.play.max(0.0) + of.within, play: of.play }).collect()
    }

    /// The sizes without any single one of which a wheel can be drawn.
    fn no_design(&self) -> UndecidedCulprit {
        let can_be_drawn = |place: &usize| {
            let others = self.without(*place);
            others.nearest_fit().is_ok_and(|(free, _)| design(self.wheel(), &free).is_ok())
        };
        let can_be_wrong = (0..self.sizes().len()).filter(|place| !self.sizes()[*place].size.is_when_new());
        let sizes: Vec<MeasuredSize> =
            can_be_wrong.filter(can_be_drawn).map(|place| self.sizes()[place].size).collect();
        let telling = if sizes.len() > 1 { self.telling(&sizes) } else { Vec::new() };
        UndecidedCulprit { doubt: DoubtReason::NoDesign, sizes: distinct(sizes), telling }
    }

    /// What is not measured and would be another size for each of these culprits.
    fn telling(&self, culprits: &[MeasuredSize]) -> Vec<MeasuredSize> {
        let places = (0..self.sizes().len()).filter(|place| culprits.contains(&self.sizes()[*place].size));
        let fits: Vec<(Self, Free)> = places
            .filter_map(|place| {
                let others = self.without(place);
                let (free, _) = others.nearest_fit().ok()?;
                Some((others, free))
            })
            .collect();
        let usual = self.sizes().iter().filter(|of| !matches!(of.size, MeasuredSize::SlotDirection(_)));
        let usual = usual.map(|of| of.uncertainty).fold(0.0, f64::max);
        let is_telling = |size: &MeasuredSize| {
            let expected: Option<Vec<(f64, f64)>> = fits
                .iter()
                .map(|(others, free)| {
                    let value = Right { wheel: self.wheel(), free: *free }.size(*size);
                    Some((value, others.expected_uncertainty(free, *size)?))
                })
                .collect();
            let Some(expected) = expected else { return false };
            let pairs =
                expected.iter().enumerate().flat_map(|(k, one)| expected[..k].iter().map(move |other| (one, other)));
            pairs
                .into_iter()
                .all(|(one, other)| (one.0 - other.0).abs() > TELLING * libm::hypot(one.1.max(other.1), usual))
        };
        let is_open = |size: &MeasuredSize| !self.has(|of| of.name() == size.name());
        let when_new = culprits.iter().filter_map(|size| size.size_when_new()).collect();
        let measurable = MEASURABLE.into_iter().filter(is_open).filter(is_telling);
        let worn: Vec<MeasuredSize> = distinct(when_new).into_iter().filter(is_open).collect();
        measurable.chain(worn).collect()
    }

    /// The uncertainty in millimetres with which a size is expected by a fit; none where the fit leaves it open. The rim depends little on
    /// the slot's width, so it isn't open where that is.
    fn expected_uncertainty(&self, free: &Free, size: MeasuredSize) -> Option<f64> {
        if size != MeasuredSize::TipRadius {
            return self.fitted_uncertainty(free, size);
        }
        let tangent = libm::tan(self.wheel().half_pitch_angle());
        let (along, rim) = (free[0] / tangent, Right { wheel: self.wheel(), free: *free }.tip_radius());
        let by_crank = self.fitted_uncertainty(free, MeasuredSize::CrankRadius)? / tangent;
        Some(libm::hypot(by_crank, (rim - along) / 2.0))
    }

    /// The numbers of stations with which all sizes fit a right wheel, where they don't with those that were counted: of the fewest first.
    /// None unless two sizes say how large the wheel is, because a single one fits any number.
    ///
    /// ```
    /// use geneva_kinematics::wheel::Wheel;
    /// use geneva_kinematics::wheel::as_built::{MeasuredSize, MeasuredWheel};
    ///
    /// let mut measured = MeasuredWheel::new(Wheel::new(5)?); // counted wrongly
    /// measured.add(MeasuredSize::CentreDistance, 50.0, 0.05)?; // mm
    /// measured.add(MeasuredSize::CrankRadius, 25.0, 0.05)?;
    /// assert_eq!(measured.fitting_stations(&measured.nearest()?), [6]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn fitting_stations(&self, nearest: &NearestWheel) -> Vec<u32> {
        use MeasuredSize as Size;
        let scales: [fn(Size) -> bool; 4] = [
            |size| size == Size::CentreDistance,
            |size| size == Size::CrankRadius,
            |size| size == Size::TipRadius,
            |size| matches!(size, Size::ArcCentre(_)),
        ];
        let has_scales = scales.iter().filter(|is_it| self.has(*is_it)).count() > 1;
        if nearest.culprit.is_none() || !has_scales {
            return Vec::new();
        }
        let fits = |stations: &u32| {
            let wheel = Wheel::with_pins(*stations, self.wheel().pins()).ok();
            let other = wheel.and_then(|wheel| self.with_wheel(wheel));
            let nearest = other.and_then(|other| other.nearest().ok());
            nearest.is_some_and(|nearest| nearest.culprit.is_none() && nearest.refusal.is_none())
        };
        STATIONS.filter(|stations| *stations != self.wheel().stations()).filter(fits).collect()
    }
}

/// The sizes without those that came before.
fn distinct(sizes: Vec<MeasuredSize>) -> Vec<MeasuredSize> {
    let mut found: Vec<MeasuredSize> = Vec::new();
    for size in sizes {
        if !found.contains(&size) {
            found.push(size);
        }
    }
    found
}

/// The free sizes of the nearest right wheel.
fn free_sizes(nearest: &NearestWheel) -> Free {
    Free::from([
        nearest.crank_radius,
        nearest.pin_diameter,
        nearest.slot_width,
        nearest.slot_end,
        nearest.arc_radius,
        nearest.disc_radius,
        nearest.crescent_centre,
    ])
}
