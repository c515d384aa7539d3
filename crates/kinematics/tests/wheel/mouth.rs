//! Do the mouths of the outline let the pin in as the closed forms of play and blow say?
//!
//! Points on the wheel's outline and the pin's path in short steps: nothing here uses a formula of mouth, play or blow. Only
//! the outline is common, and it is compared with areas and distances of its own.

use super::assembly::{Point, check, from_edge, is_inside, points, sized};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{
    Choices, Edge, EntryContact, Loop, Mouth, MouthSize, Play, Scale, Sizes, SizesError, Warning, Wheel,
};
use std::f64::consts::PI;

fn chamfer(width: f64, degrees: f64) -> Mouth {
    Mouth::Chamfer { width, angle: degrees.to_radians() }
}

fn with(stations: u32, pins: u32, play: f64, mouth: Mouth) -> Sizes {
    let play = Some(Play::from_slot(play));
    sized(stations, pins, &Choices { mouth, play, ..Choices::default() })
}

/// For a centre distance of 100 mm.
fn mouths() -> [Mouth; 11] {
    [
        Mouth::Sharp,
        chamfer(1.0, 45.0),
        chamfer(3.0, 20.0),
        chamfer(4.0, 8.0),
        chamfer(1.0, 70.0),
        Mouth::Round { radius: 0.8 },
        Mouth::Round { radius: 2.5 },
        Mouth::LeadIn { length: 4.0, flare: 0.3 },
        Mouth::LeadIn { length: 6.0, flare: 0.8 },
        Mouth::LeadIn { length: 3.0, flare: 1.5 },
        Mouth::LeadIn { length: 10.0, flare: 3.0 },
    ]
}

/// Wheels with each mouth, and little and much play.
fn wheels() -> Vec<Sizes> {
    let counts = [(3, 1), (4, 1), (6, 2), (9, 1)];
    let all = counts.into_iter().flat_map(|(stations, pins)| {
        mouths().into_iter().flat_map(move |mouth| [0.05, 0.6].map(|play| with(stations, pins, play, mouth)))
    });
    all.collect()
}

fn name(sizes: &Sizes) -> String {
    format!(
        "{} stations, {} pins, play {}, {:?}",
        sizes.wheel.stations(),
        sizes.wheel.pins(),
        sizes.play.slot,
        sizes.mouth
    )
}

/// Points of the outline about one slot, so near each other that a pin between two of them is known to 10⁻⁷ mm.
struct Sampled {
    points: Vec<Point>,
    /// The slot's middle is in this direction.
    slot: f64,
}

impl Sampled {
    /// The slot that the next pin comes to, with the wheel at rest.
    fn at_entry(sizes: &Sizes) -> Self {
        let half_pitch = sizes.wheel.half_pitch_angle();
        let near = |edge: &Edge| {
            let middle = (edge.start_point() + edge.end_point()) / 2.0;
            middle.y.atan2(middle.x).abs() < 0.9 * half_pitch
        };
        let outline = sizes.outline().wheel.outer;
        let rho = sizes.pin_radius();
        let mouth = Point::new(sizes.wheel_radius, 0.0);
        let spacing = 2e-3;
        let along = |edge: &Edge| -> Vec<Point> {
            let (length, at): (f64, Box<dyn Fn(f64) -> Point>) = match *edge {
                Edge::Line { from, to } => ((to - from).norm(), Box::new(move |share| from.lerp(&to, share))),
                Edge::Arc { centre, radius, start, sweep } => (
                    radius * sweep.abs(),
                    Box::new(move |share: f64| {
                        let angle = start + sweep * share;
                        centre + Point::new(angle.cos(), angle.sin()) * radius
                    }),
                ),
            };
            let count = (length / spacing).ceil();
            (0..=count as u32)
                .map(|k| at(f64::from(k) / count))
                .filter(|p| (p - mouth).norm() < 4.0 * rho + 8.0)
                .collect()
        };
        let points = outline.edges.iter().filter(|edge| near(edge)).flat_map(along).collect();
        Self { points, slot: -half_pitch }
    }

    /// Distance of the pin from the wheel that is turned forwards by an angle, at a crank angle.
    fn gap(&self, sizes: &Sizes, theta: f64, drift: f64) -> f64 {
        let pin =
            Point::new(sizes.centre_distance - sizes.crank_radius * theta.cos(), sizes.crank_radius * theta.sin());
        let (sin, cos) = (self.slot + drift).sin_cos();
        let pin = Point::new(cos * pin.x + sin * pin.y, cos * pin.y - sin * pin.x);
        self.points.iter().map(|p| (p - pin).norm_squared()).fold(f64::INFINITY, f64::min).sqrt() - sizes.pin_radius()
    }

    /// Crank angle of the first contact and the rate at which the gap closes there, over the pin's speed.
    fn first_contact(&self, sizes: &Sizes, drift: f64) -> Option<(f64, f64)> {
        let entry = sizes.wheel.engagement_half_angle();
        let mut theta = -entry - 0.4;
        // The pin is no faster than its own speed, so it cannot touch before it has gone the gap.
        while theta < 0.0 {
            let gap = self.gap(sizes, theta, drift);
            if gap < 2e-6 {
                let back = 2e-4 / sizes.crank_radius;
                return Some((theta, (self.gap(sizes, theta - back, drift) - gap) / 2e-4));
            }
            theta += gap / sizes.crank_radius;
        }
        None
    }
}

#[test]
fn the_pin_lands_where_its_path_meets_points_of_the_outline() {
    let mut met = Vec::new();
    for sizes in wheels() {
        let sampled = Sampled::at_entry(&sizes);
        let (play, knock) = (sizes.dwell_play().unwrap(), sizes.knock().unwrap());
        let mut hardest = 0.0_f64;
        for drift in [-play.middle, 0.0, 0.3 * play.greatest, 0.6 * play.greatest, 0.85 * play.greatest, play.greatest]
        {
            let name = format!("{}, drift {drift}", name(&sizes));
            let said = sizes.drifted_entry(0.0, drift).unwrap();
            let (theta, rate) = sampled.first_contact(&sizes, drift).unwrap();
            // At a glancing contact a gap of 2 nm is a longer way.
            let glance = 2e-6 / sizes.crank_radius / said.closing_speed.max(1e-3);
            assert!((theta - said.crank_angle).abs() < 1e-6 + 3.0 * glance, "{name}: {theta} {said:?}");
            assert!((rate - said.closing_speed).abs() < 3e-3, "{name}: {rate} {said:?}");
            hardest = hardest.max(rate);
            met.push((said.contact, said.is_driving_side));
        }
        assert!(hardest < knock.drifted + 3e-3, "{}: {hardest} {knock:?}", name(&sizes));
        assert_eq!(knock.hardest_entry.closing_speed, knock.drifted);
        assert_eq!(knock.centred_entry, sizes.entry(0.0).unwrap());
    }
    for contact in [
        (EntryContact::DrivingWall, true),
        (EntryContact::MouthFace, true),
        (EntryContact::MouthFace, false),
        (EntryContact::Mouth, false),
        (EntryContact::Mouth, true),
    ] {
        assert!(met.contains(&contact), "{contact:?} is never met");
    }
}

/// All states of crank and wheel that can be reached in the dwell and in the mouth, with the wheel pushed forwards as far as disc
/// and pins allow, at many crank angles.
#[test]
fn no_state_has_the_wheel_farther_forwards_than_is_said() {
    let mut past_entry = 0;
    for sizes in wheels() {
        let (entry, play) = (sizes.wheel.engagement_half_angle(), sizes.dwell_play().unwrap());
        let name = format!("{}, {play:?}", name(&sizes));
        let free = |until: f64, by: f64| {
            // The wheel waits where the dwell leaves it, also while the pin is already in its mouth.
            let outline = sizes.outline();
            let axis = Point::new(sizes.centre_distance, 0.0);
            let on_driver = |part: &Loop| part.transform(PI + entry + until, axis);
            let (disc, pins) = (outline.disc.map(|disc| on_driver(&disc.outer)), outline.pins.iter().map(on_driver));
            let pins: Vec<Loop> = pins.collect();
            let rest = by - sizes.wheel.half_pitch_angle();
            let wheel = outline.wheel.outer.transform(rest, Point::zeros()).corners(5e-4).unwrap();
            let parts = disc.iter().chain(&pins);
            !parts.into_iter().any(|part| {
                let polygon = part.corners(5e-4).unwrap();
                let middle = polygon.iter().sum::<Point>() / polygon.len() as f64;
                let reach = polygon.iter().map(|p| (p - middle).norm()).fold(0.0, f64::max);
                let near = |p: &&Point| (**p - middle).norm() < reach;
                wheel.iter().filter(near).any(|p| is_inside(&polygon, p))
                    || polygon.iter().any(|p| is_inside(&wheel, p))
            })
        };
        let at = play.until_entry;
        past_entry += u32::from(at < 0.0);
        assert!(free(at, 0.97 * play.greatest), "{name} is too much");
        assert!(!free(at, 1.03 * play.greatest), "{name} is too little");
        // Before that and after it, the wheel is stopped earlier: by the disc or by the pin.
        let (first, last) = (at.min(0.0), sizes.dwell_angle().unwrap());
        for step in 0..=12 {
            let until = first + (last - first) * f64::from(step) / 12.0;
            assert!(!free(until, 1.03 * play.greatest), "{name}, {until} before entry");
        }
    }
    assert!(past_entry > 0, "the play is never greatest past the entry");
}

#[test]
fn outlines_with_mouths_are_as_near_as_the_sweep_says() {
    for mouth in [chamfer(3.0, 30.0), Mouth::Round { radius: 2.5 }, Mouth::LeadIn { length: 6.0, flare: 1.5 }] {
        for (stations, pins) in [(3, 1), (4, 3), (6, 2), (12, 1)] {
            check(&sized(stations, pins, &Choices { mouth, ..Choices::default() }), 60);
        }
    }
}

#[test]
fn a_mouth_takes_material_away_and_closes_the_outline() {
    for sizes in wheels() {
        let sharp = sized(
            sizes.wheel.stations(),
            sizes.wheel.pins(),
            &Choices { play: Some(sizes.play), ..Choices::default() },
        );
        let (with, without) = (sizes.outline().wheel, sharp.outline().wheel);
        let edges = &with.outer.edges;
        for (edge, next) in edges.iter().zip(edges.iter().cycle().skip(1)) {
            assert!((edge.end_point() - next.start_point()).norm() < 1e-10, "{}: {edge:?} {next:?}", name(&sizes));
        }
        // No point of the outline is outside the sharp wheel, within the chords of its polygon.
        let polygon = without.outer.corners(1e-4).unwrap();
        for p in points(edges) {
            let is_on_edge = || without.outer.edges.iter().any(|edge| from_edge(edge, &p) < 2e-4);
            assert!(is_inside(&polygon, &p) || is_on_edge(), "{}: {p:?}", name(&sizes));
        }
        // The area by a fine polygon.
        let corners = with.outer.corners(1e-6).unwrap();
        let area: f64 = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| a.perp(b)).sum::<f64>() / 2.0;
        approx::assert_relative_eq!(area, with.area() + PI * sizes.wheel_bore().powi(2) / 4.0, max_relative = 1e-6);
        let taken = without.area() - with.area();
        assert_eq!(taken > 1e-3, sizes.mouth != Mouth::Sharp, "{}: {taken} mm²", name(&sizes));
        if let Mouth::Chamfer { width, .. } = sizes.mouth {
            // A triangle of wall, face and the rim's chord, and the segment between chord and rim.
            let corner = Point::new(sizes.wheel_radius, sizes.slot_width / 2.0);
            let chord = edges[4].end_point() - corner;
            let half = (chord.norm() / 2.0 / sizes.tip_radius).asin();
            let segment = sizes.tip_radius.powi(2) * (half - half.sin() * half.cos());
            let each = taken / (2.0 * f64::from(sizes.wheel.stations()));
            approx::assert_relative_eq!(each, width * chord.y / 2.0 + segment, max_relative = 1e-9);
        }
    }
}

#[test]
fn the_horn_at_the_mouth_is_as_thin_as_points_of_both_edges_are_near() {
    for sizes in wheels().into_iter().filter(|sizes| sizes.mouth != Mouth::Sharp) {
        let edges = sizes.outline().wheel.outer.edges;
        // Of the first sector: a face before the slot, the slot, and the face above it, then rim and locking arc.
        let Edge::Arc { centre, radius, .. } = edges[6] else { panic!("{:?}", edges[6]) };
        // The arc's whole circle, as for a sharp corner.
        let whole = [Edge::Arc { centre, radius, start: 0.0, sweep: 2.0 * PI }];
        let (face, locking) = (points(&edges[4..5]), points(&whole));
        let seen = face.iter().flat_map(|p| locking.iter().map(move |q| (p - q).norm())).fold(f64::INFINITY, f64::min);
        let said = sizes.mouth_horn().unwrap();
        assert!(said <= seen + 1e-9 && seen < said + 2e-2, "{}: {said} {seen}", name(&sizes));
    }
}

#[test]
fn a_mouth_that_is_too_large_is_refused_with_the_greatest_that_is_not() {
    let of =
        |mouth| Sizes::new(Wheel::new(6).unwrap(), Scale::CrankRadius(25.0), &Choices { mouth, ..Choices::default() });
    let mut reasons = Vec::new();
    for (mouth, size, with) in [
        (chamfer(9.0, 45.0), MouthSize::Chamfer, (|x| chamfer(x, 45.0)) as fn(f64) -> Mouth),
        (chamfer(30.0, 3.0), MouthSize::Chamfer, |x| chamfer(x, 3.0)),
        (Mouth::Round { radius: 8.0 }, MouthSize::Radius, |radius| Mouth::Round { radius }),
        (Mouth::LeadIn { length: 12.0, flare: 0.5 }, MouthSize::LeadIn, |length| Mouth::LeadIn { length, flare: 0.5 }),
        (Mouth::LeadIn { length: 4.0, flare: 9.0 }, MouthSize::Flare, |flare| Mouth::LeadIn { length: 4.0, flare }),
    ] {
        let refused = of(mouth).unwrap_err();
        let SizesError::Mouth { name, most, asked, reason, .. } = refused else { panic!("{refused:?}") };
        assert_eq!(name, size);
        let said = refused.to_string();
        assert!(said.contains(&asked.to_string()) && said.contains("give more than 0 and less than"), "{said}");
        assert!(of(with(0.999 * most)).is_ok() && of(with(1.001 * most)).is_err(), "{said}");
        reasons.push(reason);
    }
    reasons.sort_unstable();
    reasons.dedup();
    assert!(reasons.len() >= 2, "{reasons:?}");
    for degrees in [0.0, 90.0, -5.0, f64::NAN] {
        assert!(matches!(of(chamfer(1.0, degrees)), Err(SizesError::ChamferAngle { .. })));
    }
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = [
            chamfer(wrong, 45.0),
            Mouth::Round { radius: wrong },
            Mouth::LeadIn { length: wrong, flare: 0.3 },
            Mouth::LeadIn { length: 3.0, flare: wrong },
        ];
        assert!(refused.into_iter().all(|mouth| matches!(of(mouth), Err(SizesError::Kinematics(_)))), "{wrong}");
    }
}

#[test]
fn what_a_mouth_does_to_the_blow_of_a_wheel_of_six() {
    // Pin speed of a crank of 25 mm at 60 rpm.
    let pin = 25.0 * 2.0 * PI;
    let of = |mouth| {
        let choices = Choices { mouth, ..Choices::default() };
        let sizes = Sizes::new(Wheel::new(6).unwrap(), Scale::CrankRadius(25.0), &choices).unwrap();
        let knock = sizes.knock().unwrap();
        ([knock.centred, knock.within, knock.drifted].map(|share| share * pin), knock.hardest_entry.contact, sizes)
    };
    for (mouth, said, on) in [
        (Mouth::Sharp, [7.02, 9.93, 65.87], EntryContact::Mouth),
        (chamfer(1.0, 45.0), [7.02, 16.51, 77.10], EntryContact::Mouth),
        (chamfer(2.0, 20.0), [27.70, 32.30, 53.67], EntryContact::MouthFace),
        (Mouth::Round { radius: 1.0 }, [7.02, 16.12, 68.05], EntryContact::MouthFace),
        (Mouth::LeadIn { length: 5.0, flare: 0.5 }, [29.16, 29.37, 31.38], EntryContact::MouthFace),
    ] {
        let (found, contact, sizes) = of(mouth);
        for (found, said) in found.into_iter().zip(said) {
            approx::assert_relative_eq!(found, said, epsilon = 0.006);
        }
        assert_eq!(contact, on, "{mouth:?}");
        let is_harder = sizes.warnings().iter().any(|warning| matches!(warning, Warning::HarderMouth { .. }));
        assert_eq!(is_harder, found[2] > 65.88, "{mouth:?}");
    }
}

/// A wheel that turns out of the way of its pin with sharp corners, and not with a mouth that reaches farther.
#[test]
fn a_mouth_catches_a_pin_that_a_sharp_corner_misses() {
    let of = |mouth| {
        let choices =
            Choices { mouth, pin_diameter: Some(4.0), play: Some(Play::from_slot(0.8)), ..Choices::default() };
        sized(6, 1, &choices)
    };
    let misses = |mouth| of(mouth).warnings().iter().any(|warning| matches!(warning, Warning::CanMiss { .. }));
    assert!(misses(Mouth::Sharp));
    assert!(
        !misses(Mouth::LeadIn { length: 6.0, flare: 2.5 }),
        "{:?}",
        of(Mouth::LeadIn { length: 6.0, flare: 2.5 }).dwell_play()
    );
}
