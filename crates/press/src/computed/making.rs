//! Of the chapter on making a wheel: what the answer about the worked design doesn't have.

mod advice;

use super::{Number, degrees, with_unit};
use crate::asked::design;
use crate::numbers::fixed;
use anyhow::Context;
use geneva_ask::wheel::Design;
use geneva_dynamics::line_contact::{contact_modulus, pressure_at_yield};
use geneva_figures::stations;
use geneva_kinematics::wheel::{DwellPlay, Entry, Sizes};
use std::f64::consts::PI;

/// An error of the centre distance with which the pin meets a corner, and one with which it knocks less, in mm.
const CENTRE_ERROR: f64 = 0.1;
const LITTLE_APART: f64 = 0.02;
/// Coefficient of friction of a pin in its slot.
const RUBBING: f64 = 0.15;
/// Poisson's ratio for which the pressure at yielding is said.
const POISSON: f64 = 0.3;

pub use advice::NUMBERS as ADVICE;

/// The numbers of this chapter, but for those of its advice.
pub const NUMBERS: &[(&str, Number)] = &[
    ("making.shorter-crank", || Ok(told(rounded_down(sizes()?.slot_gap())))),
    ("making.own-factor", || {
        let design = design("worked-in-steel")?;
        let (own, radius) = design.wheel_inertia.zip(design.crank_radius).context("an inertia and a size")?;
        Ok(with_unit(own / (radius / 1000.0).powi(4), 2, "kg/m²"))
    }),
    ("making.little-apart", || Ok(told(LITTLE_APART))),
    ("making.blow-little-apart", || Ok(with_unit(blow(LITTLE_APART)?, 2, "mm/s"))),
    ("making.slot-direction-rim", || {
        let tolerance = sizes()?.slot_direction_tolerance().context("a locking disc")?;
        Ok(told(rounded_down(tolerance * sizes()?.wheel_radius)))
    }),
    ("making.thickness", || Ok(told(worked()?.question.thickness.context("a thickness")?))),
    ("making.rubbing", || Ok(fixed(RUBBING, 2))),
    ("making.rubbing-peak", || Ok(with_unit(rubbing()?.0, 3, "N&nbsp;m"))),
    ("making.rubbing-mean", || Ok(with_unit(rubbing()?.1, 2, "N&nbsp;m"))),
    ("making.yield", || Ok(fixed(pressure_at_yield(POISSON), 2))),
    ("making.backlash-window", || {
        let window = dwell_play()?.held * sizes()?.dwell_angle().context("a dwell")?;
        Ok(fixed(window.to_degrees(), 0) + "°")
    }),
    ("making.backlash-thirty", || play_before_entry(30.0)),
    ("making.backlash-ten", || play_before_entry(10.0)),
    ("making.backlash-rim", || Ok(with_unit(dwell_play()?.greatest * sizes()?.wheel_radius, 2, "mm"))),
    ("making.backlash-factor", || Ok(fixed(dwell_play()?.greatest / dwell_play()?.middle, 0))),
    ("making.near-depth", || Ok(told(CENTRE_ERROR - sizes()?.locking_gap().context("a locking disc")?))),
    ("making.bite", || Ok(with_unit(-least_gap(1)?, 2, "mm"))),
    ("making.passes", || Ok(with_unit(least_gap(2)?, 2, "mm"))),
    ("making.modulus", || {
        let question = worked()?.question;
        let (pin, wall) = question.pin_material.zip(question.wheel_material).context("materials")?;
        Ok(with_unit(contact_modulus(&pin, &wall) / 1e9, 3, "GPa"))
    }),
    ("making.contact-width", || {
        let design = worked()?;
        let moment = design.loads(design.wheel.indexing())?.context("loads")?.pin_moment().driving.value;
        let (contact, force) = design.contact.zip(design.force(moment)).context("a contact and a force")?;
        Ok(with_unit(contact.width(force)? * 1e6, 2, "µm"))
    }),
    ("making.tolerance", || Ok(with_unit(worked()?.clearance()?.context("a clearance")?.1, 1, "mm"))),
    ("making.backlash", || Ok(fixed(sizes()?.index_backlash(0.0)?.to_degrees(), 3) + "°")),
    ("making.late", || {
        let sizes = sizes()?;
        Ok(degrees(entry(&sizes, 0.0)?.crank_angle + sizes.wheel.engagement_half_angle()))
    }),
    ("making.pin-speed", || Ok(with_unit(worked()?.pin_speed().context("a speed")?, 3, "mm/s"))),
    ("making.centre-error", || Ok(with_unit(CENTRE_ERROR, 1, "mm"))),
    ("making.blow-apart", || Ok(with_unit(blow(CENTRE_ERROR)?, 2, "mm/s"))),
    ("making.instant.driver", || Ok(with_unit(design("instant")?.speed().context("a speed")?, 4, "rad/s"))),
    ("making.sized.turn", || Ok(with_unit(60.0 / design("sized")?.question.rpm.context("a speed")?, 1, "s"))),
    ("making.loaded.speed", || Ok(with_unit(design("loaded")?.speed().context("a speed")?, 4, "rad/s"))),
    ("making.second.thick-pin", || Ok(told(0.3 * sizes_of("second")?.crank_radius))),
    ("making.second.deepest", || Ok(told(sizes_of("second")?.deepest()))),
];

fn worked() -> anyhow::Result<Design> {
    design("worked")
}

fn sizes_of(question: &str) -> anyhow::Result<Sizes> {
    design(question)?.sizes.context("a size")
}

/// The sizes of the worked design: all that is not given has its default.
pub fn sizes() -> anyhow::Result<Sizes> {
    sizes_of("worked")
}

/// A length with as many decimals as a drawing has, without zeros at the end.
fn told(length: f64) -> String {
    let text = fixed(length, 3);
    format!("{}&nbsp;mm", text.trim_end_matches('0').trim_end_matches('.'))
}

/// What must not be exceeded, to as many decimals.
fn rounded_down(length: f64) -> f64 {
    (length * 1000.0).floor() / 1000.0
}

/// The least number in a column of the figure of the crescent, in mm.
fn least_gap(column: usize) -> anyhow::Result<f64> {
    let figure = stations::crescent(&sizes()?)?;
    let gaps: Vec<f64> = figure.series.rows.iter().map(|row| row[column]).collect();
    Ok(super::least(&gaps))
}

fn entry(sizes: &Sizes, centre_error: f64) -> anyhow::Result<Entry> {
    sizes.entry(centre_error).context("the pin meets the slot")
}

/// Speed in mm/s with which the pin meets the wheel, with such an error of the centre distance in mm.
fn blow(centre_error: f64) -> anyhow::Result<f64> {
    Ok(entry(&sizes()?, centre_error)?.closing_speed * worked()?.pin_speed().context("a speed")?)
}

fn dwell_play() -> anyhow::Result<DwellPlay> {
    sizes()?.dwell_play().context("a wheel with one pin has a dwell")
}

/// How far the wheel can turn forwards so many degrees of the crank before a pin enters.
fn play_before_entry(until: f64) -> anyhow::Result<String> {
    let [forwards, _] = sizes()?.dwell_play_at(until.to_radians()).context("within the dwell")?;
    Ok(fixed(forwards.to_degrees(), 3) + "°")
}

/// The greatest torque at the crank and its mean over a turn, in N m, with a pin that rubs in its slot: the power of the friction,
/// the force of the pin times its speed along the slot, comes on top.
fn rubbing() -> anyhow::Result<(f64, f64)> {
    const STEPS: u32 = 2000;
    let design = worked()?;
    let wheel = design.wheel.indexing();
    let loads = design.loads(wheel)?.context("loads")?;
    let end = wheel.engagement_half_angle();
    let (mut peak, mut sum) = (0.0_f64, 0.0);
    for step in 0..STEPS {
        let crank = end * (2.0 * (f64::from(step) + 0.5) / f64::from(STEPS) - 1.0);
        let (load, pin) = (loads.at(crank)?, wheel.pin_in_slot(crank)?);
        let torque = load.crank_torque + RUBBING * (load.pin_moment * pin.radius_rate).abs();
        peak = peak.max(torque);
        sum += torque * 2.0 * end / f64::from(STEPS);
    }
    Ok((peak, sum / (2.0 * PI)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asked;
    use geneva_ask::Field;
    use geneva_ask::wheel::Question;
    use geneva_kinematics::wheel::EntryContact;
    use geneva_live::Arguments;

    #[test]
    fn the_worked_design_is_the_figure_as_it_stands_at_first() {
        let live = geneva_live::by_name("design").expect("a figure");
        let answer = live.answer(&Arguments::default()).expect("an answer");
        assert!(answer.figure.svg == stations::dimensions_on_a_page(&sizes().expect("fits")).svg, "another drawing");
        let shown = |name: &str| answer.numbers.iter().find(|number| number.name == name).expect("shown").value;
        let near = |value: f64, shown: f64| assert!((value / shown - 1.0).abs() < 1e-12, "{value} {shown}");
        let asked = asked::answer("worked").expect("an answer");
        for (key, name) in [
            ("peak_pin_force_n", "force"),
            ("peak_crank_torque_nm", "crank"),
            ("rms_crank_torque_nm", "rms"),
            ("mean_crank_torque_nm", "mean"),
            ("peak_power_w", "power"),
            ("peak_contact_pressure_mpa", "pressure"),
        ] {
            near(asked.field(key).and_then(Field::number).expect(key), shown(name));
        }
        near(blow(0.0).expect("met"), shown("blow"));
        // The hint: a little apart the pin knocks less, and farther apart it meets a corner.
        assert!(live.hint.contains("apart by 0.02 mm") && live.hint.contains("At 0.06 mm"), "another hint");
        let sizes = sizes().expect("fits");
        assert!(blow(LITTLE_APART).expect("met") < 0.8 * blow(0.0).expect("met"));
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
        let (sizes, play) = (sizes().expect("fits"), dwell_play().expect("a dwell"));
        // The chapter says that the axes may be wrong by this much and the wheel runs, and that nearer by as much jams.
        let apart = sizes.entry(CENTRE_ERROR).expect("met");
        assert_eq!(apart.contact, EntryContact::Mouth);
        assert!(sizes.locking_gap().expect("a disc") < CENTRE_ERROR);
        // With two pins the opening is in the arc all the time.
        for question in ["worked-two-pins", "twelve-two-pins"] {
            assert_eq!(sizes_of(question).expect("fits").dwell_play().expect("a dwell").held, 0.0);
        }
        assert!(play.greatest > 10.0 * play.middle && !play.can_miss);
    }

    #[test]
    fn with_the_best_crank_radius_the_force_is_least() {
        let question = design("worked-best").expect("fits").question;
        let force = |crank_radius| {
            let question = Question { crank_radius: Some(crank_radius), ..question.clone() };
            let answer = Design::new(question).and_then(|design| design.answer()).expect("loaded");
            answer.field("peak_pin_force_n").and_then(Field::number).expect("a force")
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
        let blow = entry(&sizes, 0.0).expect("met").closing_speed;
        // sin τ = √(2g/a − (g/a)²).
        assert!((blow / sine - 1.0).abs() < 1e-3, "{blow} {sine}");
    }
}
