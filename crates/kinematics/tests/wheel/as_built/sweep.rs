//! Do points on the outlines say the same of wheels with errors: free between the same angles, and jammed or not?

use super::super::assembly::sized;
use super::points::Outlines;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::as_built::{AsBuiltWheel, Assemblies, BuiltContact, ErrorShape, SizeErrors};
use geneva_kinematics::wheel::{Choices, Mouth, Play};

/// Wheels of several numbers of stations and pins, with play and errors of different sizes, so that about half of them jam.
fn perturbed(count: u64) -> Vec<AsBuiltWheel> {
    let counts = [(4, 1), (6, 1), (3, 1), (5, 1), (8, 1), (6, 2), (4, 2), (12, 1), (4, 3), (7, 1)];
    let one = |k: u64| {
        let (stations, pins) = counts[k as usize % counts.len()];
        let play = [0.2, 0.35, 0.1, 0.5][(k / 10) as usize % 4];
        let error = play * [0.25, 0.5, 0.8, 1.2][(k / 3) as usize % 4];
        let sizes = sized(stations, pins, &Choices { play: Some(Play::from_slot(play)), ..Choices::default() });
        Assemblies::new(&sizes, SizeErrors::from_greatest(error), ErrorShape::Uniform, 17).assembly(k)
    };
    (0..count).map(one).collect()
}

/// How deep the parts are in each other at least, wherever the wheel is, at a crank angle: in millimetres.
fn least_depth(outlines: &Outlines<'_>, event: i32, theta: f64, around: f64, half: f64) -> f64 {
    const PLACES: i32 = 10;
    let at = |angle: f64| outlines.depth(event, theta, angle);
    let place = |k: i32| around + half * f64::from(k) / f64::from(PLACES);
    // What is free somewhere is not jammed; the right place is the likeliest.
    let beside = (0..=PLACES).flat_map(|k| [k, -k]).find(|k| at(place(*k)) <= 0.0);
    if beside.is_some() {
        return 0.0;
    }
    let depths: Vec<f64> = (-PLACES..=PLACES).map(|k| at(place(k))).collect();
    let k = (0..=2 * PLACES).min_by(|k, l| depths[*k as usize].total_cmp(&depths[*l as usize])).unwrap() - PLACES;
    let (mut from, mut to) = (place(k - 1), place(k + 1));
    let mut least = at(place(k));
    // Deep on both sides, and in between one valley.
    for _ in 0..18 {
        let (left, right) = (from + (to - from) * 0.382, from + (to - from) * 0.618);
        let (deep_left, deep_right) = (at(left), at(right));
        least = least.min(deep_left).min(deep_right);
        if least <= 0.0 {
            return least;
        }
        if deep_left < deep_right { to = right } else { from = left }
    }
    least
}

#[test]
fn the_wheel_is_free_between_the_told_angles_and_nowhere_beside_them() {
    const NEAR: f64 = 4e-5;
    let mut looked_at = 0;
    for (number, built) in perturbed(60).iter().enumerate() {
        let outlines = Outlines::new(built);
        let half = std::f64::consts::PI / built.pins().len() as f64;
        for k in 0..24 {
            let event = (k + number) as i32 % built.events() as i32;
            let theta = half * ((k as f64 + 0.37) / 12.0 - 1.0);
            let free = built.free_angles(i64::from(event), theta).unwrap();
            if free.width() < 4.0 * NEAR {
                continue;
            }
            looked_at += 1;
            let depth = |angle: f64| outlines.depth(event, theta, angle);
            let name = format!("wheel {number}, event {event}, crank angle {theta}: {free:?}");
            for inside in [free.backward.angle + NEAR, free.middle(), free.forward.angle - NEAR] {
                assert!(depth(inside) <= 0.0, "{name}: {} deep at {inside}", depth(inside));
            }
            for outside in [free.backward.angle - NEAR, free.forward.angle + NEAR] {
                assert!(depth(outside) > 0.0, "{name}: free at {outside}");
            }
        }
    }
    assert!(looked_at > 1000, "{looked_at}");
}

#[test]
fn the_wheel_is_free_between_the_told_angles_while_a_pin_is_in_a_chamfered_mouth() {
    const NEAR: f64 = 4e-5;
    let (mut looked_at, mut on_faces) = (0, 0);
    for (number, mut built) in perturbed(40).into_iter().enumerate() {
        let (pin, slot) = (built.pins()[0], built.slots()[0]);
        // Of several pins another one can be in the way.
        let is_sharp = number % 4 == 0;
        let chamfer = Mouth::Chamfer { width: 0.4 * pin.diameter, angle: [0.3, 0.8, 1.2][number % 3] };
        built.mouth = if is_sharp { Mouth::Sharp } else { chamfer };
        let outlines = Outlines::new(&built);
        let (a, c) = (pin.crank_radius, built.centre_distance);
        for k in 1..12 {
            // From deep in the mouth to outside of the rim.
            let distance = slot.tip_radius - 0.6 * pin.diameter + 1.2 * pin.diameter * f64::from(k) / 12.0;
            let theta = -((a * a + c * c - distance * distance) / (2.0 * a * c)).acos() + pin.direction_error;
            let free = built.free_angles(0, theta).unwrap();
            if free.width() < 4.0 * NEAR {
                continue;
            }
            looked_at += 1;
            let contacts = [free.backward.contact, free.forward.contact];
            on_faces += u32::from(contacts.contains(&BuiltContact::PinOnFace));
            let depth = |angle: f64| outlines.depth(0, theta, angle);
            let name = format!("wheel {number}, crank angle {theta}: {free:?}");
            for inside in [free.backward.angle + NEAR, free.middle(), free.forward.angle - NEAR] {
                assert!(depth(inside) <= 0.0, "{name}: {} deep at {inside}", depth(inside));
            }
            for outside in [free.backward.angle - NEAR, free.forward.angle + NEAR] {
                assert!(depth(outside) > 0.0, "{name}: free at {outside}");
            }
        }
    }
    assert!(looked_at > 250 && on_faces > 40, "{looked_at} {on_faces}");
}

#[test]
fn a_wheel_jams_if_points_of_its_outlines_cannot_pass() {
    /// A wheel that passes or jams by less, in millimetres, is not judged by points.
    const BAND: f64 = 0.002;
    let (mut jammed, mut judged) = (0, 0);
    let wheels = perturbed(110);
    for (number, built) in wheels.iter().enumerate() {
        let (turn, outlines) = (built.turn().unwrap(), Outlines::new(built));
        assert_eq!(turn.jam.is_none(), built.turns().unwrap(), "wheel {number}");
        if turn.tightest.free.room().abs() < BAND {
            continue;
        }
        judged += 1;
        let half = std::f64::consts::PI / built.pins().len() as f64;
        let half_pitch = built.wheel().half_pitch_angle();
        let places = (0..built.events() as i32).flat_map(|event| (0..=32).map(move |k| (event, k)));
        let depths = places.map(|(event, k)| {
            let theta = half * (f64::from(k) / 16.0 - 1.0);
            let right = built.wheel().motion(0, theta).unwrap();
            let angle = right.angle + 2.0 * half_pitch * right.stations as f64;
            least_depth(&outlines, event, theta, angle, 0.12 * half_pitch)
        });
        // The first overlap will do.
        let worst = depths.into_iter().find(|depth| *depth > 0.0).unwrap_or(0.0);
        let is_jammed = worst > 0.0;
        // The points are at some crank angles only: a jam that they miss must be between these.
        if turn.jam.is_some() != is_jammed {
            let tightest = turn.tightest;
            let event = (0..built.events() as i64)
                .find(|event| {
                    event.rem_euclid(built.pins().len() as i64) as usize == tightest.pin
                        && (-event).rem_euclid(built.slots().len() as i64) as usize == tightest.slot
                })
                .unwrap() as i32;
            let around = tightest.free.middle();
            let depth = least_depth(&outlines, event, tightest.crank_angle, around, 0.12 * half_pitch);
            assert_eq!(turn.jam.is_some(), depth > 0.0, "wheel {number}: {tightest:?}, {worst} and {depth} mm deep");
            assert!(turn.jam.is_some(), "wheel {number} turns, but its points are {worst} mm deep: {tightest:?}");
        }
        jammed += usize::from(turn.jam.is_some());
    }
    assert!(judged >= 100 && jammed >= 30 && judged - jammed >= 30, "{judged} judged, {jammed} jam");
}

/// Loose axes are put where they are on the page, and the parts there are swept by points; the program has only their distance.
#[test]
fn a_wheel_whose_axes_are_loose_in_their_bores_jams_if_its_points_cannot_pass() {
    const BAND: f64 = 0.002;
    let counts = [(4, 1), (6, 1), (3, 1), (8, 1), (6, 2)];
    let (mut jammed, mut judged, mut by_bores) = (0, 0, 0);
    for k in 0.. {
        if judged == 50 {
            break;
        }
        let (stations, pins) = counts[k as usize % counts.len()];
        let sizes = sized(stations, pins, &Choices { play: Some(Play::from_slot(0.3)), ..Choices::default() });
        let tight = Assemblies::new(&sizes, SizeErrors::from_greatest(0.1), ErrorShape::Uniform, 23);
        let loose = tight.clone().with_bore_play(0.4);
        let (parts, axes) = loose.loose_assembly(k);
        let tightest = loose.assembly(k).turn().unwrap().tightest;
        if tightest.free.room().abs() < BAND {
            continue;
        }
        judged += 1;
        let (half, half_pitch) = (std::f64::consts::PI / f64::from(pins), parts.wheel().half_pitch_angle());
        let outlines = Outlines::new(&parts).placed(axes);
        let line = axes[1] - axes[0];
        let askew = line.y.atan2(line.x);
        // From the line of centres to the page, on which crank angles are counted backwards.
        let depth = |event: i32, theta: f64, around: f64| {
            least_depth(&outlines, event, theta - askew, around + askew, 0.12 * half_pitch)
        };
        let mut worst: f64 = 0.0;
        for (event, place) in (0..parts.events() as i32).flat_map(|event| (0..=32).map(move |place| (event, place))) {
            let theta = half * (f64::from(place) / 16.0 - 1.0);
            let right = parts.wheel().motion(0, theta).unwrap();
            worst = worst.max(depth(event, theta, right.angle + 2.0 * half_pitch * right.stations as f64));
            if worst > 0.0 {
                break;
            }
        }
        let jams = tightest.free.width() < 0.0;
        if jams && worst <= 0.0 {
            // The points were at some crank angles only: where the program says that it is, the jam must be.
            let event = (0..parts.events() as i32).find(|event| {
                event.rem_euclid(pins as i32) as usize == tightest.pin
                    && (-event).rem_euclid(stations as i32) as usize == tightest.slot
            });
            worst = depth(event.unwrap(), tightest.crank_angle, tightest.free.middle());
        }
        assert_eq!(jams, worst > 0.0, "assembly {k}, {axes:?}: {tightest:?}, {worst} mm deep");
        jammed += usize::from(jams);
        by_bores += usize::from(jams && tight.assembly(k).turns().unwrap());
    }
    assert!(
        jammed >= 15 && judged - jammed >= 15 && by_bores >= 5,
        "{jammed} of {judged} jam, {by_bores} by their bores"
    );
}

#[test]
fn nothing_is_tighter_than_the_tightest_place() {
    use geneva_kinematics::wheel::as_built::WIDTH_TOLERANCE;
    for (number, built) in perturbed(20).iter().enumerate() {
        let tightest = built.turn().unwrap().tightest;
        let half = std::f64::consts::PI / built.pins().len() as f64;
        for event in 0..built.events() as i64 {
            for k in 0..10_000 {
                let theta = half * (f64::from(k) / 5000.0 - 1.0);
                let free = built.free_angles(event, theta).unwrap();
                let less = tightest.free.width() - free.width();
                assert!(less < WIDTH_TOLERANCE, "wheel {number}, event {event}, {theta}: {less} {free:?} {tightest:?}");
            }
        }
    }
}

#[test]
fn whatever_the_sizes_are_the_answer_is_a_number() {
    use geneva_kinematics::wheel::as_built::SplitMix64;
    let mut random = SplitMix64::new(99);
    let mut answered = 0;
    for k in 0..600 {
        let (stations, pins) = [(3, 1), (4, 1), (4, 4), (6, 2), (7, 1), (11, 1)][k % 6];
        let mut built = AsBuiltWheel::from(&sized(stations, pins, &Choices::default()));
        // Factors from a hundredth to a hundred, or nothing at all.
        let mut factor = || match random.next_u64() % 12 {
            0 => 10_f64.powf(2.0 * random.next_signed()),
            1 => 1.0 + random.next_signed(),
            2 => 0.0,
            3 => f64::NAN,
            _ => 1.0 + 0.02 * random.next_signed(),
        };
        built.centre_distance *= factor();
        built.disc_radius = built.disc_radius.map(|disc| disc * factor());
        let one = &mut built.slots_mut()[0];
        (one.width, one.end, one.tip_radius) = (one.width * factor(), one.end * factor(), one.tip_radius * factor());
        one.direction_error = 0.1 * (factor() - 1.0);
        let one = &mut built.arcs_mut()[0];
        (one.radius, one.centre) = (one.radius * factor(), one.centre * factor());
        let one = &mut built.pins_mut()[0];
        (one.diameter, one.crank_radius) = (one.diameter * factor(), one.crank_radius * factor());
        (one.crescent.centre, one.crescent.radius) = (one.crescent.centre * factor(), one.crescent.radius * factor());
        let Ok(turn) = built.turn() else { continue };
        answered += 1;
        let numbers = turn.stations.iter().flat_map(|station| {
            let entry = station.entry.map_or([0.0; 3], |entry| [entry.centred, entry.greatest, entry.lost_motion]);
            let own = [station.index_backlash, station.dwell_backlash, station.greatest_dwell_backlash];
            own.into_iter().chain(entry).chain([station.station_error])
        });
        assert!(numbers.chain([turn.tightest.free.room()]).all(f64::is_finite), "{built:?}: {turn:?}");
        let outline = built.outline();
        assert!(outline.wheel.area().is_finite() && built.least_changes().is_ok());
    }
    assert!(answered > 50, "{answered}");
}
