//! Of the chapter on making a wheel: what no answer has.

use super::{Number, least};
use crate::asked::design;
use crate::numbers::{fixed, significant};
use anyhow::Context;
use geneva_figures::stations;
use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel, play_of_h8_e8};

/// The numbers of the chapter that are of no answer.
pub const NUMBERS: &[(&str, Number)] = &[
    ("making.bite", || Ok(with_unit(-least_gap(1)?))),
    ("making.passes", || Ok(with_unit(least_gap(2)?))),
    ("making.fit-3", || Ok(fit(3.0, 6.0))),
    ("making.fit-6", || Ok(fit(6.0, 10.0))),
    ("making.fit-10", || Ok(fit(10.0, 18.0))),
    ("making.fit-18", || Ok(fit(18.0, 30.0))),
    ("making.fit-radius-4", || Ok(in_fit(4)?.0)),
    ("making.fit-pin-4", || Ok(in_fit(4)?.1)),
    ("making.fit-radius-5", || Ok(in_fit(5)?.0)),
    ("making.fit-pin-5", || Ok(in_fit(5)?.1)),
    ("making.fit-radius-6", || Ok(in_fit(6)?.0)),
    ("making.fit-pin-6", || Ok(in_fit(6)?.1)),
    ("making.fit-radius-8", || Ok(in_fit(8)?.0)),
    ("making.fit-pin-8", || Ok(in_fit(8)?.1)),
    ("making.fit-radius-10", || Ok(in_fit(10)?.0)),
    ("making.fit-pin-10", || Ok(in_fit(10)?.1)),
    ("making.fit-radius-12", || Ok(in_fit(12)?.0)),
    ("making.fit-pin-12", || Ok(in_fit(12)?.1)),
];

fn sizes_of(question: &str) -> anyhow::Result<Sizes> {
    design(question)?.sizes.context("a size")
}

/// The sizes of the worked design: all that is not given has its default.
pub fn sizes() -> anyhow::Result<Sizes> {
    sizes_of("worked")
}

/// The least number in a column of the figure of the crescent, in mm.
fn least_gap(column: usize) -> anyhow::Result<f64> {
    let figure = stations::crescent(&sizes()?)?;
    Ok(least(&figure.series.rows.iter().map(|row| row[column]).collect::<Vec<_>>()))
}

fn with_unit(length: f64) -> String {
    format!("{}&nbsp;mm", significant(length, 2))
}

/// Least and greatest play of a fit for diameters over one and up to another number of millimetres.
fn fit(over: f64, up_to: f64) -> String {
    let [least, most] = play_of_h8_e8(over, up_to).map(|play| fixed(play, 3));
    format!("{least} to {most}&nbsp;mm")
}

/// The crank radius in whole millimetres up to which the program's play is no more than that of the fit, and the pin's diameter there.
fn in_fit(stations: u32) -> anyhow::Result<(String, String)> {
    let [radius, pin] = last_in_fit(stations)?;
    Ok((format!("{}&nbsp;mm", fixed(radius, 0)), format!("{}&nbsp;mm", fixed(pin, 1))))
}

fn last_in_fit(stations: u32) -> anyhow::Result<[f64; 2]> {
    let wheel = Wheel::new(stations)?;
    let of = |radius: f64| Sizes::new(wheel, Scale::CrankRadius(radius), &Choices::default());
    let mut tenths = 10;
    while of(f64::from(tenths + 1) / 10.0)?.looser_than_fit().is_none() {
        tenths += 1;
    }
    let radius = f64::from(tenths / 10);
    Ok([radius, of(radius)?.pin_diameter])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asked::{question, value};
    use geneva_ask::ReportField;
    use geneva_ask::wheel::{WheelDesign, WheelQuestion};
    use geneva_kinematics::indexing::Indexing;
    use geneva_kinematics::wheel::{EntryContact, Play};
    use geneva_live::LiveArguments;

    #[track_caller]
    fn asked(name: &str, key: &str) -> f64 {
        question(name).and_then(|question| value(&question, key)).expect(key)
    }

    #[test]
    fn the_worked_design_is_the_figure_as_it_stands_at_first() {
        let live = geneva_live::by_name("design").expect("a figure");
        let answer = live.answer(&LiveArguments::default()).expect("an answer");
        assert!(answer.figure.svg == stations::dimensions_on_a_page(&sizes().expect("fits")).svg, "another drawing");
        let shown = |name: &str| answer.numbers.iter().find(|number| number.name == name).expect("shown").value;
        for of in live.quantities {
            let Some(key) = of.key else { continue };
            let (asked, shown) = (asked("worked", key), shown(of.name));
            assert!((asked / shown - 1.0).abs() < 1e-12, "{key}: {asked} {shown}");
        }
        // The hint: a little apart the pin knocks less, and farther apart it meets a corner. Another wheel may be another case.
        let of_the_chapter = "With the wheel of this chapter (button six stations), move the axes apart by 0.02 mm";
        assert!(live.hint.contains(of_the_chapter) && live.hint.contains("At 0.06 mm"), "another hint");
        assert!(live.presets.first().is_some_and(|preset| preset.name == "six stations"));
        let other = design("sized").expect("fits").sizes.expect("a size");
        assert_ne!(other.entry(0.06).expect("met").contact, EntryContact::Mouth);
        let sizes = sizes().expect("fits");
        assert_eq!(asked("worked-little-apart", "centre_error_mm"), 0.02);
        assert!(asked("worked-little-apart", "entry_knock_mm_s") < 0.8 * shown("blow"));
        assert_eq!(sizes.entry(0.06).expect("met").contact, EntryContact::Mouth);
    }

    #[test]
    fn the_second_design_is_what_its_exercise_says() {
        let sizes = sizes_of("second").expect("fits");
        let (index, dwell) = (sizes.wheel.motion_fraction(), sizes.wheel.dwell_fraction());
        let turn = 60.0 / design("second").expect("fits").question.rpm.expect("a speed");
        assert!((turn * index - 0.5).abs() < 1e-12 && (turn * dwell - 1.5).abs() < 1e-12);
        assert!((sizes.crank_radius / sizes.wheel_radius - 1.0).abs() < 1e-12);
        assert!((sizes.pin_diameter / sizes.deepest() - 2.0 / 3.0).abs() < 1e-12);
        let crescent = sizes.locking_disc.expect("a disc").crescent;
        assert_eq!(crescent.centre, sizes.centre_distance);
    }

    #[test]
    fn the_chapters_words_about_the_play_hold() {
        let (sizes, error) = (sizes().expect("fits"), asked("worked-apart", "centre_error_mm"));
        let play = sizes.dwell_play().expect("a dwell");
        // The chapter says that the axes may be wrong by this much and the wheel runs, and that nearer by as much jams.
        let apart = sizes.entry(error).expect("met");
        assert_eq!(apart.contact, EntryContact::Mouth);
        assert!(sizes.locking_gap().expect("a disc") < error);
        // With two pins the opening is in the arc all the time.
        for question in ["worked-two-pins", "twelve-two-pins"] {
            assert_eq!(sizes_of(question).expect("fits").dwell_play().expect("a dwell").held, 0.0);
        }
        assert!(play.greatest > 10.0 * play.middle && !play.can_miss);
    }

    #[test]
    fn the_chapters_words_about_the_fit_hold() {
        let (sizes, [least, most]) = (sizes().expect("fits"), play_of_h8_e8(6.0, 10.0));
        assert!((6.0..10.0).contains(&sizes.pin_diameter) && (least..most).contains(&sizes.play.slot));
        // Up to the radius of the table no play is more than the fit's, and a millimetre farther one is.
        for stations in [4, 5, 6, 8, 10, 12] {
            let wheel = Wheel::new(stations).expect("possible");
            let is_loose = |radius: f64| {
                let sizes = Sizes::new(wheel, Scale::CrankRadius(radius), &Choices::default()).expect("fits");
                sizes.looser_than_fit().is_some()
            };
            let [last, pin] = last_in_fit(stations).expect("fits");
            assert!((10..=10 * last as u32).all(|tenths| !is_loose(f64::from(tenths) / 10.0)), "{stations}: {last}");
            assert!((0..=10).any(|tenths| is_loose(last + f64::from(tenths) / 10.0)), "{stations}: {last}");
            assert!((3.0..=30.0).contains(&pin), "{stations}: a pin of no column");
        }
    }

    #[test]
    fn a_cam_in_the_same_time_has_less_acceleration_with_few_stations_and_more_with_many() {
        let cam = |name| asked(name, "cam_acceleration_share");
        assert!(cam("free-four") < 0.7 && cam("free-six") < 1.0 && cam("free-eight") > 1.1);
    }

    #[test]
    fn the_chapters_words_about_tolerances_hold() {
        let sizes = sizes().expect("fits");
        let limit = sizes.shared_tolerance().expect("one");
        let gap = sizes.locking_gap().expect("a disc");
        // A third of the gap for each of three sizes and the bores' play would be more than the gap.
        assert!(3.0 * limit.locking + sizes.play.bore < gap && 3.0 * gap / 3.0 + sizes.play.bore > gap);
        // All limits grow with the play.
        let choices = Choices { play: Some(Play::from_slot(2.0 * sizes.play.slot)), ..Choices::default() };
        let twice = Sizes::new(sizes.wheel, Scale::CrankRadius(sizes.crank_radius), &choices).expect("fits");
        let twice = twice.shared_tolerance().expect("one");
        for (one, two) in [(limit.locking, twice.locking), (limit.crank, twice.crank), (limit.width, twice.width)] {
            assert!((two / one - 2.0).abs() < 0.1, "{one} {two}");
        }
        // A disc that is only smaller and an arc that is only larger leave the gap to axes and bores.
        let nearer = sizes.centre_tolerance().nearer - sizes.play.bore;
        assert!(nearer > 2.0 * limit.nearer, "{nearer}");
    }

    #[test]
    fn with_the_best_crank_radius_the_force_is_least() {
        let question = design("worked-best").expect("fits").question;
        let force = |crank_radius| {
            let question = WheelQuestion { crank_radius: Some(crank_radius), ..question.clone() };
            let answer = WheelDesign::new(question).and_then(|design| design.answer()).expect("loaded");
            answer.field("peak_pin_force_n").and_then(ReportField::number).expect("a force")
        };
        let best = question.crank_radius.expect("a size");
        for radius in 10..=100 {
            assert!(force(f64::from(radius)) >= force(best), "{radius} mm");
        }
        assert!(force(design("worked-large").expect("fits").crank_radius.expect("a size")) > 2.0 * force(best));
    }

    #[test]
    fn the_blow_is_that_of_the_chapters_formula() {
        let sizes = sizes().expect("fits");
        let sine = (2.0 * sizes.slot_gap() / sizes.crank_radius).sqrt();
        let blow = sizes.entry(0.0).expect("met").closing_speed;
        // sin τ = √(2g/a − (g/a)²).
        assert!((blow / sine - 1.0).abs() < 1e-3, "{blow} {sine}");
    }
}
