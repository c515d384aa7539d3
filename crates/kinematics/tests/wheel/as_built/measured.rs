//! Of wheels with one wrong size, is the wrong one named, and are right wheels left in peace?

use super::super::assembly::sized;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{KnownMistake, MeasuredSize, MeasuredWheel, SplitMix64};
use geneva_kinematics::wheel::{Choices, Play, Sizes, Wheel};

/// Uncertainty of all lengths, in millimetres, for a centre distance of 100 mm.
const UNCERTAINTY: f64 = 0.02;

/// All sizes of a wheel, with errors of measurement and one size wrong by this much.
fn measure(sizes: &Sizes, random: &mut SplitMix64, wrong: Option<(MeasuredSize, f64)>) -> MeasuredWheel {
    let mut measured = MeasuredWheel::new(sizes.wheel);
    let stations = sizes.wheel.stations() as usize;
    let disc = sizes.locking_disc.unwrap();
    let mut all = vec![
        (MeasuredSize::CentreDistance, sizes.centre_distance),
        (MeasuredSize::CrankRadius, sizes.crank_radius),
        (MeasuredSize::PinDiameter, sizes.pin_diameter),
        (MeasuredSize::TipRadius, sizes.tip_radius),
        (MeasuredSize::DiscRadius, disc.radius),
        (MeasuredSize::CrescentCentre, disc.crescent.centre),
        (MeasuredSize::CrescentRadius, disc.crescent.radius),
    ];
    for k in 0..stations {
        all.push((MeasuredSize::SlotWidth(Some(k)), sizes.slot_width));
        all.push((MeasuredSize::SlotEnd(Some(k)), sizes.slot_end));
        all.push((MeasuredSize::SlotDirection(k), 0.0));
        all.push((MeasuredSize::ArcRadius(Some(k)), sizes.locking_arc_radius));
    }
    for (size, value) in all {
        let off = wrong.filter(|(of, _)| *of == size).map_or(0.0, |(_, off)| off);
        let is_direction = matches!(size, MeasuredSize::SlotDirection(_));
        let uncertainty = if is_direction { UNCERTAINTY / sizes.wheel_radius } else { UNCERTAINTY };
        let off = if is_direction { off / sizes.wheel_radius } else { off };
        measured.add(size, value + off + uncertainty * random.next_normal(), uncertainty).unwrap();
    }
    measured
}

fn design(k: u64, random: &mut SplitMix64) -> Sizes {
    let counts = [(4, 1), (6, 1), (3, 1), (5, 1), (8, 1), (6, 2), (12, 1), (7, 1)];
    let (stations, pins) = counts[k as usize % counts.len()];
    let play = Some(Play::from_slot(0.15 + 0.35 * random.next_unit()));
    let default = sized(stations, pins, &Choices { play, ..Choices::default() });
    // Half of them with a thinner pin than by default.
    let pin = if k.is_multiple_of(2) { default.pin_diameter } else { 0.8 * default.pin_diameter };
    sized(stations, pins, &Choices { play, pin_diameter: Some(pin), ..Choices::default() })
}

#[test]
fn the_wrong_one_of_all_sizes_is_named() {
    let mut random = SplitMix64::new(31);
    let (mut named, mut missed) = (0, Vec::new());
    for k in 0..100 {
        let sizes = design(k, &mut random);
        let number = (random.next_u64() % u64::from(sizes.wheel.stations())) as usize;
        let size = match k % 11 {
            0 => MeasuredSize::CentreDistance,
            1 => MeasuredSize::CrankRadius,
            2 => MeasuredSize::PinDiameter,
            3 => MeasuredSize::TipRadius,
            4 => MeasuredSize::DiscRadius,
            5 => MeasuredSize::CrescentCentre,
            6 => MeasuredSize::CrescentRadius,
            7 => MeasuredSize::SlotWidth(Some(number)),
            8 => MeasuredSize::SlotEnd(Some(number)),
            9 => MeasuredSize::SlotDirection(number),
            _ => MeasuredSize::ArcRadius(Some(number)),
        };
        // A pin that is too thin and a disc that is too small are only loose; too large, they jam.
        let is_one_sided = matches!(size, MeasuredSize::PinDiameter | MeasuredSize::DiscRadius);
        let sign = if is_one_sided || random.next_unit() < 0.5 { 1.0 } else { -1.0 };
        let least = if is_one_sided { sizes.play.slot } else { 0.0 };
        let off = sign * (least + 0.3 + 0.5 * random.next_unit());
        let nearest = measure(&sizes, &mut random, Some((size, off))).nearest().unwrap();
        match nearest.culprit {
            Some(culprit) if culprit.size == size && culprit.rest_agrees => named += 1,
            other => missed.push((k, sizes.wheel.stations(), size, off, other, nearest.suspects)),
        }
    }
    assert!(named >= 95, "{named} named; {missed:#?}");
}

#[test]
fn right_wheels_have_no_culprit() {
    let mut random = SplitMix64::new(32);
    for k in 0..100 {
        let sizes = design(k, &mut random);
        let nearest = measure(&sizes, &mut random, None).nearest().unwrap();
        assert_eq!(nearest.culprit, None, "{k}: {} above {}", nearest.sum_of_squares, nearest.limit);
        assert!((nearest.crank_radius - sizes.crank_radius).abs() < 5.0 * UNCERTAINTY);
        assert!((nearest.slot_width - sizes.slot_width).abs() < 5.0 * UNCERTAINTY);
    }
}

#[test]
fn a_few_sizes_will_do_and_the_rest_is_as_a_design_has_it() {
    let mut measured = MeasuredWheel::new(Wheel::new(9).unwrap());
    measured.add(MeasuredSize::TipRadius, 27.5, 0.05).unwrap();
    measured.add(MeasuredSize::SlotWidth(None), 3.1, 0.05).unwrap();
    let nearest = measured.nearest().unwrap();
    let b = (27.5_f64 * 27.5 - 1.55 * 1.55).sqrt();
    let a = b * 20_f64.to_radians().tan();
    assert!((nearest.crank_radius - a).abs() < 1e-3, "{nearest:?}");
    assert!(nearest.culprit.is_none() && measured.as_built(&nearest).turn().unwrap().jam.is_none(), "{nearest:?}");
    assert!(MeasuredWheel::new(Wheel::new(9).unwrap()).nearest().is_err());
}

#[test]
fn wheels_by_wrong_formulas_are_recognised_and_right_ones_are_not() {
    let wheel = |stations: u32, sizes: &[(MeasuredSize, f64)]| {
        let mut measured = MeasuredWheel::new(Wheel::new(stations).unwrap());
        for (size, value) in sizes {
            measured.add(*size, *value, 0.02).unwrap();
        }
        measured.known_mistakes()
    };
    use MeasuredSize::{
        CentreDistance, CrankRadius, CrescentCentre, CrescentRadius, DiscRadius, PinDiameter, TipRadius,
    };
    for stations in [3_u32, 5, 6, 8, 12] {
        let half = std::f64::consts::PI / f64::from(stations);
        let (a, b) = (25.0, 25.0 / half.tan());
        let of = |c: f64| wheel(stations, &[(CrankRadius, a), (CentreDistance, c), (TipRadius, b)]);
        assert_eq!(of(a + b), [KnownMistake::TouchingCircles], "{stations}");
        assert_eq!(of(b / half.sin()), [KnownMistake::SineForCosine], "{stations}");
        assert_eq!(of(a / half.cos()), [KnownMistake::CosineForSine], "{stations}");
        assert_eq!(of(1.03 * a / half.sin()), [KnownMistake::NoRightAngle], "{stations}");
        assert!(of(a / half.sin()).is_empty());
        let c = a / half.sin();
        assert_eq!(wheel(stations, &[(CentreDistance, c), (TipRadius, b - 3.0)]), [KnownMistake::ShortRim]);
    }
    // The school project: four slots, wheel radius 12 mm, pin 3 mm; and a crescent of the wheel's radius about its axis.
    assert_eq!(wheel(4, &[(CrankRadius, 12.0), (PinDiameter, 3.0), (DiscRadius, 6.80)]), [KnownMistake::PinToThePower]);
    assert!(wheel(4, &[(CrankRadius, 12.0), (PinDiameter, 3.0), (DiscRadius, 7.5)]).is_empty());
    let cut = [(CrankRadius, 25.0), (TipRadius, 25.2), (CrescentCentre, 35.36), (CrescentRadius, 25.3)];
    assert_eq!(wheel(4, &cut), [KnownMistake::CrescentAboutWheelAxis]);
    for stations in [3, 4, 6, 9] {
        let sizes = sized(stations, 1, &Choices::default());
        let disc = sizes.locking_disc.unwrap();
        let right = [
            (CentreDistance, sizes.centre_distance),
            (CrankRadius, sizes.crank_radius),
            (PinDiameter, sizes.pin_diameter),
            (TipRadius, sizes.tip_radius),
            (DiscRadius, disc.radius),
            (CrescentCentre, disc.crescent.centre),
            (CrescentRadius, disc.crescent.radius),
        ];
        assert!(wheel(stations, &right).is_empty(), "{stations}");
    }
}

#[test]
fn sizes_of_which_no_wheel_can_be_made_are_told_to_be_so() {
    // A worn wheel of nine stations: outside diameter 55 mm, slots of 3.1 mm, hollows of 4.3 mm. Nothing contradicts, but the
    // disc would run into the horns.
    let mut measured = MeasuredWheel::new(Wheel::new(9).unwrap());
    measured.add(MeasuredSize::TipRadius, 27.5, 0.05).unwrap();
    measured.add(MeasuredSize::SlotWidth(None), 3.1, 0.05).unwrap();
    measured.add(MeasuredSize::ArcRadius(None), 4.3, 0.05).unwrap();
    let nearest = measured.nearest().unwrap();
    assert!(nearest.culprit.is_none());
    assert!(nearest.refusal.is_some_and(|error| error.to_string().contains("horns")), "{:?}", nearest.refusal);
}
