//! Of a right wheel with one worn part, is another size ever named, whichever others are measured? And does what is named to be
//! measured tell?

use super::super::assembly::sized;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{DoubtReason, MeasuredSize, MeasuredWheel, SplitMix64, UndecidedCulprit};
use geneva_kinematics::wheel::{Choices, Play, Sizes, Wheel};

/// The sizes that can be measured of a wheel besides the worn one, each with its right value.
fn right_sizes(sizes: &Sizes) -> Vec<(MeasuredSize, f64)> {
    let disc = sizes.locking_disc.expect("a disc");
    vec![
        (MeasuredSize::CentreDistance, sizes.centre_distance),
        (MeasuredSize::CrankRadius, sizes.crank_radius),
        (MeasuredSize::PinDiameter, sizes.pin_diameter),
        (MeasuredSize::TipRadius, sizes.tip_radius),
        (MeasuredSize::SlotWidth(None), sizes.slot_width),
        (MeasuredSize::DiscRadius, disc.radius),
        (MeasuredSize::ArcRadius(None), sizes.locking_arc_radius),
        (MeasuredSize::SlotEnd(None), sizes.slot_end),
    ]
}

/// A worn part.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Worn {
    Slots,
    OneSlot,
    Pin,
    Arcs,
    Disc,
}

impl Worn {
    const ALL: [Self; 5] = [Self::Slots, Self::OneSlot, Self::Pin, Self::Arcs, Self::Disc];

    fn size(self) -> MeasuredSize {
        match self {
            Self::Slots | Self::OneSlot => MeasuredSize::SlotWidth(None),
            Self::Pin => MeasuredSize::PinDiameter,
            Self::Arcs => MeasuredSize::ArcRadius(None),
            Self::Disc => MeasuredSize::DiscRadius,
        }
    }

    /// The measurements of the worn part.
    fn measurements(self, sizes: &Sizes, wear: f64) -> Vec<(MeasuredSize, f64)> {
        let right = right_sizes(sizes).into_iter().find(|(size, _)| *size == self.size()).expect("a size").1;
        let stations = 0..sizes.wheel.stations() as usize;
        match self {
            Self::OneSlot => {
                stations.map(|k| (MeasuredSize::SlotWidth(Some(k)), right + if k == 1 { wear } else { 0.0 })).collect()
            }
            Self::Slots => vec![(self.size(), right + wear)],
            Self::Arcs => vec![(self.size(), right + wear / 2.0)],
            Self::Pin => vec![(self.size(), right - wear)],
            Self::Disc => vec![(self.size(), right - wear / 2.0)],
        }
    }
}

/// A measured wheel with errors of up to its uncertainty.
fn measure(sizes: &Sizes, all: &[(MeasuredSize, f64)], uncertainty: f64, random: &mut SplitMix64) -> MeasuredWheel {
    let mut measured = MeasuredWheel::new(sizes.wheel);
    for (size, value) in all {
        let error = uncertainty * (2.0 * random.next_unit() - 1.0);
        measured.add(*size, value + error, uncertainty).expect("a size");
    }
    measured
}

/// The only culprit of a wheel, as far as the measurements tell one.
fn told(measured: &MeasuredWheel) -> Option<MeasuredSize> {
    let nearest = measured.nearest().expect("a wheel");
    let is_told = nearest.suspects.is_empty() && nearest.further_culprits.is_empty();
    nearest.culprit.filter(|_| is_told).map(|culprit| culprit.size)
}

/// A design of six stations for axes 100 mm apart with an ordinary play.
fn design() -> Sizes {
    sized(6, 1, &Choices { play: Some(Play::from_slot(0.15)), ..Choices::default() })
}

#[test]
fn a_worn_part_accuses_no_other_whichever_sizes_are_measured() {
    // A micrometer's uncertainty: with that of a calliper, little can contradict.
    let (uncertainty, sizes) = (0.01, design());
    let mut random = SplitMix64::new(5);
    let wear = 0.3 * sizes.pin_diameter;
    let (mut found, mut doubted) = (0, 0);
    for worn in Worn::ALL {
        let is_other = |size: MeasuredSize| size != worn.size() && size != MeasuredSize::SlotEnd(None);
        let others: Vec<_> = right_sizes(&sizes).into_iter().filter(|(size, _)| is_other(*size)).collect();
        for kept in 0..1_u32 << others.len() {
            let mut all = worn.measurements(&sizes, wear);
            all.extend(others.iter().enumerate().filter(|(k, _)| kept >> k & 1 == 1).map(|(_, of)| *of));
            let measured = measure(&sizes, &all, uncertainty, &mut random);
            // Of pins, slots, disc or arcs alone nobody knows how large the wheel is.
            let Ok(nearest) = measured.nearest() else { continue };
            let is_worn = |size: MeasuredSize| size.name() == worn.size().name();
            let culprits = nearest.culprit.iter().chain(&nearest.further_culprits);
            assert!(culprits.clone().all(|culprit| is_worn(culprit.size)), "{worn:?} {all:?} {nearest:?}");
            assert!(nearest.suspects.is_empty(), "{worn:?} {all:?} {nearest:?}");
            found += culprits.count();
            for doubt in measured.undecided_culprits(&nearest) {
                assert!(doubt.sizes.iter().any(|size| is_worn(*size)), "{worn:?} {all:?} {doubt:?}");
                doubted += 1;
            }
        }
    }
    assert!(found >= 50 && doubted >= 100, "{found} {doubted}");
}

#[test]
fn what_is_named_to_be_measured_tells_which_part_is_worn() {
    let (uncertainty, sizes) = (0.05, design());
    let mut random = SplitMix64::new(6);
    for worn in [Worn::Slots, Worn::Pin, Worn::Arcs, Worn::Disc] {
        let mut all = right_sizes(&sizes);
        all.retain(|(size, _)| *size != worn.size());
        all.extend(worn.measurements(&sizes, 0.3 * sizes.pin_diameter));
        let measured = measure(&sizes, &all, uncertainty, &mut random);
        assert_eq!(told(&measured), None, "{worn:?}");
        let doubts = measured.undecided_culprits(&measured.nearest().expect("a wheel"));
        let [UndecidedCulprit { doubt: DoubtReason::Play { play, most }, telling, .. }] = &doubts[..] else {
            panic!("{worn:?} {doubts:?}")
        };
        assert!(play > most && telling.len() == 2, "{worn:?} {doubts:?}");
        for size in telling {
            let right =
                right_sizes(&sizes).into_iter().find(|(of, _)| of.size_when_new() == Some(*size)).expect("a size").1;
            let mut with_it = measured.clone();
            with_it.add(*size, right, uncertainty).expect("a size");
            assert_eq!(told(&with_it), Some(worn.size()), "{worn:?} {size:?}");
            assert!(with_it.undecided_culprits(&with_it.nearest().expect("a wheel")).is_empty(), "{worn:?} {size:?}");
        }
    }
    // Less wear than an ordinary play is found, too, where the size is known that the part had when it was new.
    let mut all = right_sizes(&sizes);
    all.retain(|(size, _)| *size != Worn::Slots.size());
    all.extend((0..6).map(|k| (MeasuredSize::SlotWidth(Some(k)), sizes.slot_width + 0.5)));
    all.push((MeasuredSize::NewSlotWidth, sizes.slot_width));
    let nearest = measure(&sizes, &all, uncertainty, &mut random).nearest().expect("a wheel");
    let culprits: Vec<_> = nearest.culprit.iter().chain(&nearest.further_culprits).map(|of| of.size).collect();
    assert_eq!(culprits.len(), 6, "{nearest:?}");
    assert!(culprits.iter().all(|size| matches!(size, MeasuredSize::SlotWidth(Some(_)))), "{nearest:?}");
}

#[test]
fn what_is_named_to_be_measured_tells_which_of_two_sizes_is_wrong() {
    let (uncertainty, sizes) = (0.05, design());
    let scales = [MeasuredSize::CentreDistance, MeasuredSize::CrankRadius, MeasuredSize::TipRadius];
    for wrong in scales {
        for other in scales.into_iter().filter(|other| *other != wrong) {
            for off in [-2.5, 1.5] {
                let mut measured = MeasuredWheel::new(sizes.wheel);
                for (size, value) in right_sizes(&sizes) {
                    if size == wrong || size == other || !scales.contains(&size) {
                        let off = if size == wrong { off } else { 0.0 };
                        measured.add(size, value + off, uncertainty).expect("a size");
                    }
                }
                let doubts = measured.undecided_culprits(&measured.nearest().expect("a wheel"));
                let [UndecidedCulprit { doubt: DoubtReason::Contradiction, sizes: either, telling }] = &doubts[..]
                else {
                    panic!("{wrong:?} {other:?} {off} {doubts:?}")
                };
                assert!(either.contains(&wrong) && !telling.is_empty(), "{wrong:?} {other:?} {off} {doubts:?}");
                let right = right_sizes(&sizes).into_iter().find(|(size, _)| *size == telling[0]).expect("a size").1;
                measured.add(telling[0], right, uncertainty).expect("a size");
                assert_eq!(told(&measured), Some(wrong), "{wrong:?} {other:?} {off} {telling:?}");
            }
        }
    }
}

#[test]
fn a_number_of_stations_that_was_miscounted_is_found() {
    for (stations, counted) in [(6, 5), (5, 6), (8, 7), (4, 3), (12, 13)] {
        let sizes = sized(stations, 1, &Choices::default());
        let mut measured = MeasuredWheel::new(Wheel::new(counted).expect("a wheel"));
        for (size, value) in right_sizes(&sizes) {
            measured.add(size, value, 0.05).expect("a size");
        }
        let nearest = measured.nearest().expect("a wheel");
        assert_eq!(measured.fitting_stations(&nearest), [stations], "{stations} {counted}");
        let right = MeasuredWheel::new(sizes.wheel);
        let right = measured.sizes().iter().fold(right, |mut right, of| {
            right.add(of.size, of.value, of.uncertainty).expect("a size");
            right
        });
        assert_eq!(right.fitting_stations(&right.nearest().expect("a wheel")), [0_u32; 0], "{stations}");
    }
    // A single size of the axes and the rim fits any number.
    let mut one = MeasuredWheel::new(Wheel::new(5).expect("a wheel"));
    one.add(MeasuredSize::CrankRadius, 25.0, 0.05).expect("a size");
    assert!(one.fitting_stations(&one.nearest().expect("a wheel")).is_empty());
}
