use geneva_kinematics::wheel::{Choices, Mouth, Scale, Sizes, Wheel};

#[test]
fn table() {
    let pin = 25.0 * 2.0 * std::f64::consts::PI;
    for (n, play) in [(6, None), (4, None), (6, Some(0.2)), (12, None)] {
        let of = |mouth| {
            let play = play.map(geneva_kinematics::wheel::Play::from_slot);
            Sizes::new(Wheel::new(n).unwrap(), Scale::CrankRadius(25.0), &Choices { mouth, play, ..Choices::default() })
        };
        let deg = |a: f64| a.to_radians();
        for mouth in [
            Mouth::Sharp,
            Mouth::Chamfer { width: 1.0, angle: deg(45.0) },
            Mouth::Chamfer { width: 2.0, angle: deg(45.0) },
            Mouth::Chamfer { width: 2.0, angle: deg(20.0) },
            Mouth::Chamfer { width: 3.0, angle: deg(10.0) },
            Mouth::Chamfer { width: 5.0, angle: deg(5.0) },
            Mouth::Round { radius: 0.5 },
            Mouth::Round { radius: 1.0 },
            Mouth::Round { radius: 2.0 },
            Mouth::LeadIn { length: 2.0, flare: 0.2 },
            Mouth::LeadIn { length: 3.0, flare: 0.3 },
            Mouth::LeadIn { length: 5.0, flare: 0.3 },
            Mouth::LeadIn { length: 5.0, flare: 0.5 },
            Mouth::LeadIn { length: 5.0, flare: 1.0 },
            Mouth::LeadIn { length: 8.0, flare: 0.8 },
        ] {
            match of(mouth) {
                Err(e) => println!("{n} {mouth:?}: {e}"),
                Ok(s) => {
                    let (p, k) = (s.dwell_play().unwrap(), s.knock().unwrap());
                    println!("{n} {mouth:?} len {:.3} horn {:?} play {:.4} great {:.4} at {:.4} miss {} knock {:.2} {:?} {:.1}  within {:.2} drifted {:.2} {:?} {:.1}",
                        s.mouth_length(), s.mouth_horn(), p.middle.to_degrees(), p.greatest.to_degrees(), p.until_entry.to_degrees(), p.can_miss,
                        k.centred*pin, k.centred_entry.contact, k.centred_entry.slant.to_degrees(), k.within*pin, k.drifted*pin, k.hardest_entry.contact, k.hardest_entry.slant.to_degrees());
                }
            }
        }
    }
}
