//! Right wheels of which only some sizes are measured: are they left in peace, and do they turn with what is filled in?

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{MeasuredSize, MeasuredWheel, Process, ProcessNumbers, SplitMix64};
use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};

/// A design of three to 24 stations with plays, horns and pins by default, by choice and by a process.
fn design(random: &mut SplitMix64) -> Sizes {
    loop {
        let stations = [3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 20, 24][(random.next_u64() % 12) as usize];
        let wheel = Wheel::new(stations).unwrap();
        let crank = 10.0 + 70.0 * random.next_unit();
        let mut choices = Choices::default();
        match random.next_u64() % 4 {
            0 => choices.play = Some(Play::from_slot(crank * (0.001 + 0.003 * random.next_unit()))),
            1 => {
                let process = Process::ALL[(random.next_u64() % 6) as usize];
                let numbers = ProcessNumbers::new(process, crank * wheel.centre_distance_ratio()).unwrap();
                choices.play = Some(numbers.play());
            }
            _ => {}
        }
        if random.next_u64().is_multiple_of(3) {
            choices.horn_thickness = Some(0.1 * crank);
        }
        if random.next_u64().is_multiple_of(4) {
            choices.pin_diameter = Some(crank * (0.15 + 0.1 * random.next_unit()));
        }
        if let Ok(sizes) = Sizes::new(wheel, Scale::CrankRadius(crank), &choices) {
            return sizes;
        }
    }
}

/// The sizes of a design with the numbers as they are typed, to four decimals.
fn typed(sizes: &Sizes) -> Vec<(MeasuredSize, f64)> {
    let disc = sizes.locking_disc.unwrap();
    let all = [
        (MeasuredSize::CentreDistance, sizes.centre_distance),
        (MeasuredSize::CrankRadius, sizes.crank_radius),
        (MeasuredSize::TipRadius, sizes.tip_radius),
        (MeasuredSize::PinDiameter, sizes.pin_diameter),
        (MeasuredSize::SlotWidth(None), sizes.slot_width),
        (MeasuredSize::SlotEnd(None), sizes.slot_end),
        (MeasuredSize::ArcRadius(None), sizes.locking_arc_radius),
        (MeasuredSize::ArcCentre(None), sizes.centre_distance),
        (MeasuredSize::DiscRadius, disc.radius),
        (MeasuredSize::CrescentCentre, disc.crescent.centre),
        (MeasuredSize::CrescentRadius, disc.crescent.radius),
    ];
    all.into_iter().map(|(size, value)| (size, (value * 1e4).round() / 1e4)).collect()
}

#[test]
fn a_right_wheel_of_which_some_sizes_are_typed_turns_and_is_not_accused() {
    let mut random = SplitMix64::new(77);
    let mut wrong = Vec::new();
    for k in 0..300 {
        let sizes = design(&mut random);
        let mut all = typed(&sizes);
        let kept = 2 + (random.next_u64() % 10) as usize;
        while all.len() > kept {
            let scales = all.iter().filter(|(size, _)| is_scale(*size)).count();
            let place = (random.next_u64() % all.len() as u64) as usize;
            if scales > 1 || !is_scale(all[place].0) {
                all.remove(place);
            }
        }
        let mut measured = MeasuredWheel::new(sizes.wheel);
        for (size, value) in &all {
            measured.add(*size, *value, 0.05).unwrap();
        }
        let nearest = measured.nearest().unwrap();
        let turn = measured.as_built(&nearest).turn().unwrap();
        let formulas = measured.known_mistakes(&nearest, Some(&turn));
        let missing = turn.jam.map(|jam| jam.free.room());
        if nearest.culprit.is_some() || missing.is_some() || !formulas.is_empty() {
            wrong.push((
                k,
                sizes.wheel.stations(),
                nearest.culprit.map(|of| of.size),
                missing,
                formulas,
                all,
                sizes.play,
            ));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of 300: {:#?}",
        wrong.len(),
        wrong.iter().map(|of| format!("{of:?}")).collect::<Vec<_>>()
    );
}

/// Whether a size tells how large a wheel is.
fn is_scale(size: MeasuredSize) -> bool {
    matches!(size, MeasuredSize::CentreDistance | MeasuredSize::CrankRadius | MeasuredSize::TipRadius)
}

#[test]
fn of_every_size_of_a_right_wheel_none_is_accused_however_loose_it_is() {
    let mut random = SplitMix64::new(78);
    let mut accused = Vec::new();
    for k in 0..200 {
        let mut sizes = design(&mut random);
        // A play of up to a half of the pin: three stations and a thin pin cut by a coarse process.
        let play = Play::from_slot(sizes.pin_diameter * 0.5 * random.next_unit());
        let choices = Choices { play: Some(play), ..Choices::default() };
        sizes = Sizes::new(sizes.wheel, Scale::CrankRadius(sizes.crank_radius), &choices).unwrap_or(sizes);
        let mut measured = MeasuredWheel::new(sizes.wheel);
        for (size, value) in typed(&sizes) {
            measured.add(size, value, 0.01).unwrap();
        }
        let nearest = measured.nearest().unwrap();
        let turn = measured.as_built(&nearest).turn().unwrap();
        let formulas = measured.known_mistakes(&nearest, Some(&turn));
        if nearest.culprit.is_some() || turn.jam.is_some() || !formulas.is_empty() {
            accused.push(format!("{k}: {} {:?} {formulas:?}", sizes.wheel.stations(), nearest.culprit));
        }
    }
    assert!(accused.is_empty(), "{} of 200: {accused:#?}", accused.len());
}
