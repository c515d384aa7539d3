//! The mouths of the slots and the blow of a pin in them, as they are reported.

use super::design::WheelDesign;
use super::mouth::ANGLE;
use crate::{Needs, ReportField, Rounding};
use geneva_kinematics::wheel::{EntryContact, Knock, Mouth, Sizes};

/// The fields of the mouths: zero for shapes that they do not have, and lines only of those that they have.
pub(super) fn mouth(design: &WheelDesign) -> Vec<ReportField> {
    let sizes = design.sizes.as_ref();
    let is_sharp = sizes.is_none_or(|sizes| sizes.mouth == Mouth::Sharp);
    let [chamfer, angle, radius, lead_in, flare] = match sizes.map(|sizes| sizes.mouth) {
        Some(Mouth::Chamfer { width, angle }) => [width, angle.to_degrees(), 0.0, 0.0, 0.0],
        Some(Mouth::Round { radius }) => [0.0, ANGLE, radius, 0.0, 0.0],
        Some(Mouth::LeadIn { length, flare }) => [0.0, ANGLE, 0.0, length, flare],
        Some(Mouth::Sharp) | None => [0.0, ANGLE, 0.0, 0.0, 0.0],
    };
    let field = |key, value: f64, unit, is_there: bool, name, meaning| {
        let field = ReportField::in_unit(key, sizes.map(|_| value), unit).needing(Needs::SIZE);
        if is_there { field.line(name, meaning) } else { field }
    };
    let of = |length: fn(&Sizes) -> f64| sizes.map_or(0.0, length);
    let horn = of(|sizes| sizes.mouth_horn().unwrap_or(sizes.horn_thickness));
    vec![
        field("mouth_chamfer_mm", chamfer, "mm", chamfer > 0.0, "chamfer", "of the slots' mouths, along each wall"),
        field("mouth_angle_deg", angle, "°", chamfer > 0.0, "", "to the wall"),
        field("mouth_radius_mm", radius, "mm", radius > 0.0, "mouth radius", "of the slots, tangent to wall and rim"),
        field("lead_in_mm", lead_in, "mm", lead_in > 0.0, "lead-in", "of the slots, on an arc tangent to each wall"),
        field("lead_in_flare_mm", flare, "mm", lead_in > 0.0, "", "how far it has left the wall at the wheel radius"),
        field("mouth_length_mm", of(Sizes::mouth_length), "mm", radius > 0.0, "", "of each wall is taken by the mouth"),
        field(
            "mouth_crank_deg",
            of(Sizes::mouth_angle).to_degrees(),
            "°",
            !is_sharp,
            "",
            "of crank angle after entry and before leaving: the pin is between faces of the mouth and not between walls",
        ),
        field("mouth_horn_mm", horn, "mm", !is_sharp, "horn at the mouth", "least thickness to the locking arc there"),
    ]
}

/// On what the pin lands in an entry, in words.
fn landing(sizes: &Sizes, contact: EntryContact) -> &'static str {
    match contact {
        EntryContact::DrivingWall => "on the wall",
        EntryContact::OtherWall => "on the other wall",
        EntryContact::MouthFace => match sizes.mouth {
            Mouth::Chamfer { .. } => "on the chamfer",
            Mouth::Round { .. } => "on the rounded mouth",
            Mouth::LeadIn { .. } | Mouth::Sharp => "on the lead-in",
        },
        EntryContact::Mouth if sizes.mouth == Mouth::Sharp => "on a horn's corner",
        EntryContact::Mouth => "on a corner of the mouth",
    }
}

/// The fields of the knock at entry, from the knock and the pin's speed in mm/s; of sharp corners besides, where there are none.
pub(super) fn knock(design: &WheelDesign, sizes: Option<&Sizes>) -> Vec<ReportField> {
    let found = sizes.and_then(|sizes| Some((sizes, sizes.knock()?)));
    let speed = |key, of: fn(&Knock) -> f64| {
        let speed = found.as_ref().zip(design.pin_speed()).map(|((_, knock), pin)| of(knock) * pin);
        ReportField::in_unit(key, speed, "mm/s")
            .needing(Needs::SIZE.union(Needs::SPEED))
            .rounded(Rounding::Significant(3))
    };
    let on = |of: fn(&Knock) -> EntryContact| found.as_ref().map_or("", |(sizes, knock)| landing(sizes, of(knock)));
    let slant = found.as_ref().map(|(_, knock)| knock.hardest_entry.slant.to_degrees());
    let slant = ReportField::in_unit("greatest_knock_slant_deg", slant, "°")
        .needing(Needs::SIZE)
        .rounded(Rounding::Decimals(1));
    let sharp = found.as_ref().and_then(|(sizes, knock)| {
        if sizes.mouth == Mouth::Sharp {
            return Some(knock.drifted * design.pin_speed()?);
        }
        let mut sharp = **sizes;
        sharp.mouth = Mouth::Sharp;
        Some(sharp.knock()?.drifted * design.pin_speed()?)
    });
    let sharp = ReportField::in_unit("sharp_knock_mm_s", sharp, "mm/s")
        .needing(Needs::SIZE.union(Needs::SPEED))
        .rounded(Rounding::Significant(3));
    let is_sharp = sizes.is_none_or(|sizes| sizes.mouth == Mouth::Sharp);
    // With the axes apart too, the pin meets the wheel in the middle of its backlash.
    let centred =
        design.sizes.as_ref().and_then(|sizes| Some(landing(sizes, sizes.entry(design.centre_error())?.contact)));
    let centred = centred.unwrap_or_default();
    let hardest = on(|knock| knock.hardest_entry.contact);
    vec![
        ReportField { key: "knock_mm_s", ..design.blow_at_entry() }
            .line("knock at entry", format!("of the pin {centred}, if the wheel is in the middle of its backlash")),
        speed("knock_within_backlash_mm_s", |knock| knock.within)
            .line("", "at most, if the wheel is within the backlash of mid-dwell"),
        speed("greatest_knock_mm_s", |knock| knock.drifted)
            .line("", format!("at most, {hardest}, if the wheel is within the greatest backlash")),
        if is_sharp { slant } else { slant.line("", "from across the slot to across the faces that meet there") },
        if is_sharp { sharp } else { sharp.line("", "at most, if the corners of the slots were sharp") },
    ]
}

#[cfg(test)]
mod tests {
    use crate::{Error, MechanismReport, ReportField, answer};

    const SIX: &str = "wheel --stations 6 --crank-radius 25 --rpm 60";

    fn told(question: &str) -> MechanismReport {
        answer(&format!("{SIX} {question}")).expect(question)
    }

    fn number(answer: &MechanismReport, key: &str) -> f64 {
        answer.field(key).and_then(ReportField::number).expect(key)
    }

    fn words<'a>(answer: &'a MechanismReport, key: &str) -> &'a str {
        answer.field(key).and_then(|field| field.line.as_ref()).map_or("", |line| &line.meaning)
    }

    fn refused(question: &str) -> String {
        match answer(&format!("{SIX} {question}")) {
            Err(Error::Argument(words)) => words,
            Err(error) => error.to_string(),
            Ok(_) => panic!("{question}"),
        }
    }

    #[test]
    fn the_sheet_says_where_the_pin_lands_and_how_hard() {
        let sharp = told("");
        assert_eq!(number(&sharp, "sharp_knock_mm_s"), number(&sharp, "greatest_knock_mm_s"));
        assert!(words(&sharp, "greatest_knock_mm_s").contains("on a horn's corner"));
        assert_eq!(words(&sharp, "mouth_horn_mm"), "");
        let soft = told("--lead-in 5");
        assert_eq!(number(&soft, "lead_in_flare_mm"), 0.5);
        assert!(
            words(&soft, "greatest_knock_mm_s").contains("on the lead-in"),
            "{}",
            words(&soft, "greatest_knock_mm_s")
        );
        assert_eq!(number(&soft, "sharp_knock_mm_s"), number(&sharp, "greatest_knock_mm_s"));
        assert!(number(&soft, "greatest_knock_mm_s") < 0.5 * number(&sharp, "greatest_knock_mm_s"));
        // The crank turns by the angle whose sine is the mouth's length over the crank radius.
        approx::assert_relative_eq!(number(&soft, "mouth_crank_deg").to_radians().sin(), 0.2, max_relative = 1e-12);
        let chamfered = told("--mouth-chamfer 2 --mouth-angle 20");
        assert_eq!(number(&chamfered, "mouth_angle_deg").round(), 20.0);
        assert!(words(&chamfered, "greatest_knock_mm_s").contains("on the chamfer"));
        assert!(words(&told("--mouth-radius 1"), "greatest_knock_mm_s").contains("on the rounded mouth"));
        // Zero is sharp.
        assert_eq!(number(&told("--mouth-chamfer 0"), "greatest_knock_mm_s"), number(&sharp, "greatest_knock_mm_s"));
    }

    #[test]
    fn no_other_flare_of_a_length_is_much_softer_than_the_one_that_is_chosen() {
        for (stations, length) in [(4, 3.0), (4, 5.0), (6, 5.0), (8, 5.0), (12, 5.0), (12, 8.0)] {
            let of = |flare: &str| {
                let question =
                    format!("wheel --stations {stations} --crank-radius 25 --rpm 60 --lead-in {length} {flare}");
                number(&answer(&question).expect(&question), "greatest_knock_mm_s")
            };
            let chosen = of("");
            let others = (1..=20).map(|k| of(&format!("--lead-in-flare {}", 0.015 * length * f64::from(k))));
            let best = others.fold(f64::INFINITY, f64::min);
            assert!(chosen < 1.35 * best, "{stations} stations, {length} mm: {chosen}, best {best} mm/s");
        }
    }

    #[test]
    fn what_cannot_be_is_refused_with_the_argument_to_change() {
        let two = refused("--mouth-chamfer 1 --lead-in 3");
        assert!(two.contains("--mouth-chamfer 1 and --lead-in 3") && two.contains("give one"), "{two}");
        let alone = refused("--mouth-angle 20");
        assert!(alone.contains("--mouth-angle 20 has no effect without --mouth-chamfer"), "{alone}");
        for (question, argument) in [
            ("--mouth-chamfer 9", "mouth-chamfer"),
            ("--mouth-radius 9", "mouth-radius"),
            ("--lead-in 15", "lead-in"),
            ("--lead-in 4 --lead-in-flare 8", "lead-in-flare"),
            ("--mouth-chamfer 1 --mouth-angle 95", "mouth-angle"),
        ] {
            let Err(Error::Sizes { remedies, .. }) = answer(&format!("{SIX} {question}")) else { panic!("{question}") };
            assert!(remedies.iter().any(|of| of.name == argument && of.given.is_some()), "{question}: {remedies:?}");
        }
    }
}
