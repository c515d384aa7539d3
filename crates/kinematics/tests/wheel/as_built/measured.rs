//! Of wheels with one wrong size, is the wrong one named, and are right wheels left in peace?

use super::super::assembly::sized;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{BuiltError, KnownMistake, MeasuredSize, MeasuredWheel, SplitMix64};
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
        let nearest = measured.nearest().unwrap();
        measured.known_mistakes(&nearest, measured.as_built(&nearest).turn().ok().as_ref())
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
    // The school project: four slots, wheel radius 12 mm, pin 3 mm, stop arc 6.80 mm, and a cut of the wheel's radius and 0.2 mm
    // about the wheel's axis. A disc of that size alone is right: its horns are only thick.
    let arc = [(CrankRadius, 12.0), (PinDiameter, 3.0), (DiscRadius, 6.80)];
    assert!(wheel(4, &arc).is_empty());
    let project = [&arc[..], &[(TipRadius, 12.1), (CrescentCentre, 16.97), (CrescentRadius, 12.2)]].concat();
    assert_eq!(wheel(4, &project), [KnownMistake::PinToThePower, KnownMistake::CrescentAboutWheelAxis]);
    assert!(wheel(4, &[(CrankRadius, 12.0), (PinDiameter, 3.0), (DiscRadius, 7.5)]).is_empty());
    let cut =
        [(CrankRadius, 25.0), (TipRadius, 25.2), (DiscRadius, 17.0), (CrescentCentre, 35.36), (CrescentRadius, 25.3)];
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

#[test]
fn every_size_beyond_the_limit_is_named_and_the_nearest_wheel_is_what_the_others_ask_for() {
    let mut measured = MeasuredWheel::new(Wheel::new(6).unwrap());
    let sizes = [
        (MeasuredSize::CentreDistance, 50.4, 0.05),
        (MeasuredSize::CrankRadius, 25.0, 0.05),
        (MeasuredSize::TipRadius, 43.55, 0.025),
        (MeasuredSize::PinDiameter, 6.0, 0.05),
        (MeasuredSize::DiscRadius, 15.2, 0.05),
        (MeasuredSize::ArcRadius(None), 15.4, 0.05),
    ];
    let slots = [6.1, 6.1, 6.1, 6.3, 6.1, 6.1].into_iter().enumerate();
    let slots = slots.map(|(k, width)| (MeasuredSize::SlotWidth(Some(k)), width, 0.05));
    for (size, value, uncertainty) in sizes.into_iter().chain(slots) {
        measured.add(size, value, uncertainty).unwrap();
    }
    let nearest = measured.nearest().unwrap();
    let (first, further) = (nearest.culprit.unwrap(), &nearest.further_culprits[..]);
    let [second] = further else { panic!("{further:?}") };
    assert_eq!([first.size, second.size], [MeasuredSize::CentreDistance, MeasuredSize::SlotWidth(Some(3))]);
    assert!(first.rest_agrees && first.uncertainties > second.uncertainties && second.uncertainties > 3.5);
    // The centre distance by crank radius, and by the rim with slots of 6.1 mm: their weighted mean.
    let (half, sine) = (3.05_f64, 0.5);
    let along = (43.55_f64 * 43.55 - half * half).sqrt();
    let by_crank = (25.0 / sine, 0.05 / sine);
    let by_rim = (along / 30_f64.to_radians().cos(), 0.025 * 43.55 / along / 30_f64.to_radians().cos());
    let weights = [by_crank, by_rim].map(|(_, uncertainty)| uncertainty.powi(-2));
    let mean = (by_crank.0 * weights[0] + by_rim.0 * weights[1]) / (weights[0] + weights[1]);
    assert!((first.expected - mean).abs() < 2e-3, "{} {mean}", first.expected);
    let uncertainty = (weights[0] + weights[1]).powf(-0.5);
    assert!((first.expected_uncertainty.unwrap() - uncertainty).abs() < 0.02 * uncertainty, "{first:?} {uncertainty}");
    assert!(
        (second.expected - 6.1).abs() < 2e-3
            && (second.expected_uncertainty.unwrap() - 0.05 / 5_f64.sqrt()).abs() < 1e-3
    );
    assert_eq!((nearest.centre_distance, nearest.slot_width), (first.expected, second.expected));
    for residual in &nearest.residuals {
        let normalized = (residual.measured.value - residual.right) / residual.measured.uncertainty;
        assert_eq!(residual.normalized, normalized);
    }
}

#[test]
fn of_two_wrong_sizes_both_are_named() {
    let mut random = SplitMix64::new(33);
    let (mut both, mut more) = (0, 0);
    for k in 0..60 {
        let sizes = design(k, &mut random);
        let stations = u64::from(sizes.wheel.stations());
        let right = measure(&sizes, &mut random, None);
        let number = (random.next_u64() % stations) as usize;
        let wrong = [
            [MeasuredSize::CentreDistance, MeasuredSize::CrankRadius, MeasuredSize::TipRadius][k as usize % 3],
            [MeasuredSize::SlotWidth(Some(number)), MeasuredSize::SlotEnd(Some(number))][k as usize % 2],
        ];
        let mut measured = MeasuredWheel::new(sizes.wheel);
        for of in right.sizes() {
            let off = if wrong.contains(&of.size) { 0.4 + 0.4 * random.next_unit() } else { 0.0 };
            measured.add(of.size, of.value + off, of.uncertainty).unwrap();
        }
        let nearest = measured.nearest().unwrap();
        let named: Vec<MeasuredSize> =
            nearest.culprit.iter().chain(&nearest.further_culprits).map(|of| of.size).collect();
        both += u32::from(wrong.iter().all(|size| named.contains(size)));
        more += u32::from(named.len() > 2);
    }
    assert!(both >= 57 && more <= 3, "{both} {more}");
}

#[test]
fn a_limit_has_four_digits_and_is_accepted_as_it_is_told() {
    for most in [50.0, 50.005_000_01, 49.999_999, 35.355_339_059_327_38, 1e-7 / 3.0, 1.000_499, 9.999_6e8] {
        let told = BuiltError::CrankTooLong { asked: 61.234_567_89, most }.to_string();
        let limit =
            told.strip_prefix("crank radius 61.23 mm: it must be at most ").and_then(|rest| rest.split(' ').next());
        let limit: f64 = limit.and_then(|limit| limit.parse().ok()).unwrap_or_else(|| panic!("{told}"));
        assert!(limit < most && limit > 0.998 * most, "{told}");
    }
}
