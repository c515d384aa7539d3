//! Of the chapter on making a wheel: the worked design, from its need to its drawing, and the exercises.

mod advice;

use super::{Number, degrees, with_unit};
use crate::numbers::fixed;
use anyhow::Context;
use geneva_dynamics::line_contact::{LineContact, MATERIALS, Material, pressure_at_yield};
use geneva_dynamics::wheel_loads::{Peak, WheelLoads};
use geneva_figures::stations;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::wheel::{
    Choices, DwellPlay, Entry, Knock, LockingDisc, Motion, Scale, Sizes, Wheel, entry_acceleration,
};
use std::f64::consts::PI;

/// The worked design: stations, crank radius in mm, driver's turns a minute, inertia in kg m², friction in N m.
const STATIONS: u32 = 6;
const CRANK_RADIUS: f64 = 25.0;
const RPM: f64 = 60.0;
const INERTIA: f64 = 0.002;
const FRICTION: f64 = 0.1;
/// Thickness of the wheel in mm, materials of pin and wheel, and an error of the centre distance in mm.
const THICKNESS: f64 = 10.0;
const PIN: &str = "steel";
const WALL: &str = "phosphor-bronze";
const CENTRE_ERROR: f64 = 0.1;
/// An error of the centre distance with which the pin knocks less, in mm.
const LITTLE_APART: f64 = 0.02;
/// Coefficient of friction of a pin in its slot, and a large crank radius in mm.
const RUBBING: f64 = 0.15;
const LARGE: f64 = 100.0;
/// Poisson's ratio for which the pressure at yielding is said.
const POISSON: f64 = 0.3;

/// The exercise of an instant: crank angle in degrees, turns a minute; six stations.
const INSTANT: f64 = -20.0;
const INSTANT_RPM: f64 = 200.0;
/// The exercise of sizes: stations, centre distance in mm, turns a minute.
const SIZED: u32 = 8;
const SIZED_CENTRES: f64 = 120.0;
const SIZED_RPM: f64 = 30.0;
/// The exercise of loads: stations, centre distance in mm, inertia in kg m², turns a minute.
const LOADED: u32 = 4;
const LOADED_CENTRES: f64 = 150.0;
const LOADED_INERTIA: f64 = 0.01;
const LOADED_RPM: f64 = 120.0;

/// The exercise of a second design: stations, centre distance in mm, seconds of a turn, inertia in kg m².
const SECOND: u32 = 4;
const SECOND_CENTRES: f64 = 80.0;
const SECOND_TURN: f64 = 2.0;
const SECOND_INERTIA: f64 = 0.02;

pub use advice::NUMBERS as ADVICE;

/// The numbers of this chapter, but for those of its advice.
pub const NUMBERS: &[(&str, Number)] = &[
    ("making.inertia", || Ok(with_unit(INERTIA, 1, "kg&nbsp;m²"))),
    ("making.friction", || Ok(with_unit(FRICTION, 1, "N&nbsp;m"))),
    ("making.index", || Ok(with_unit(sizes()?.wheel.indexing_time(speed(RPM))?, 3, "s"))),
    ("making.dwell", || Ok(with_unit(sizes()?.wheel.dwell_time(speed(RPM))?, 3, "s"))),
    ("making.wheel-radius", || millimetres(|of| of.wheel_radius)),
    ("making.tip-radius", || millimetres(|of| of.tip_radius)),
    ("making.pin", || millimetres(|of| of.pin_diameter)),
    ("making.play", || millimetres(|of| of.play.slot)),
    ("making.slot-width", || millimetres(|of| of.slot_width)),
    ("making.slot-depth", || millimetres(|of| of.slot_depth)),
    ("making.bottom-clearance", || millimetres(|of| of.bottom_clearance)),
    ("making.bottom-gap", || millimetres(|of| rounded_down(of.bottom_gap()))),
    ("making.longer-crank", || millimetres(|of| rounded_down(of.crank_radius_tolerance().unwrap_or(f64::NAN)))),
    ("making.locking-gap", || millimetres(|of| rounded_down(of.locking_gap().unwrap_or(f64::NAN)))),
    ("making.shorter-crank", || millimetres(|of| rounded_down(of.slot_gap()))),
    ("making.own-factor", || {
        let own = own_inertia(&sizes()?)?;
        Ok(with_unit(own / (CRANK_RADIUS / 1000.0).powi(4), 2, "kg/m²"))
    }),
    ("making.own", || Ok(with_unit(own_inertia(&sizes()?)?, 2, "kg&nbsp;m²"))),
    ("making.little-apart", || Ok(told(LITTLE_APART))),
    ("making.blow-little-apart", || Ok(with_unit(blow(LITTLE_APART)?, 2, "mm/s"))),
    ("making.slot-direction", || Ok(fixed(slot_direction()?.to_degrees(), 3) + "°")),
    ("making.slot-direction-rim", || Ok(told(rounded_down(slot_direction()? * sizes()?.wheel_radius)))),
    ("making.thickness", || Ok(told(THICKNESS))),
    ("making.best-radius", || Ok(with_unit(best_radius()?, 2, "mm"))),
    ("making.best-force", || Ok(with_unit(with_wheel(best_radius()?)?.0, 2, "N"))),
    ("making.best-crank", || Ok(with_unit(with_wheel(best_radius()?)?.1, 2, "N&nbsp;m"))),
    ("making.large-radius", || Ok(told(LARGE))),
    ("making.large-force", || Ok(with_unit(with_wheel(LARGE)?.0, 2, "N"))),
    ("making.large-crank", || Ok(with_unit(with_wheel(LARGE)?.1, 2, "N&nbsp;m"))),
    ("making.rubbing", || Ok(fixed(RUBBING, 2))),
    ("making.rubbing-peak", || Ok(with_unit(rubbing()?.0, 3, "N&nbsp;m"))),
    ("making.rubbing-mean", || Ok(with_unit(rubbing()?.1, 2, "N&nbsp;m"))),
    ("making.three-crank", || {
        let loads = WheelLoads::new(&Wheel::new(3)?, INERTIA, FRICTION, speed(RPM))?.crank_torque().driving.value;
        Ok(with_unit(loads, 2, "N&nbsp;m"))
    }),
    ("making.yield", || Ok(fixed(pressure_at_yield(POISSON), 2))),
    ("making.backlash-held", || Ok(fixed(100.0 * dwell_play()?.held, 0) + "&nbsp;%")),
    ("making.backlash-window", || {
        let window = dwell_play()?.held * sizes()?.dwell_angle().context("a dwell")?;
        Ok(fixed(window.to_degrees(), 0) + "°")
    }),
    ("making.backlash-thirty", || play_before_entry(30.0)),
    ("making.backlash-ten", || play_before_entry(10.0)),
    ("making.backlash-greatest", || Ok(fixed(dwell_play()?.greatest.to_degrees(), 2) + "°")),
    ("making.backlash-greatest-at", || Ok(degrees(dwell_play()?.until_entry))),
    ("making.backlash-rim", || Ok(with_unit(dwell_play()?.greatest * sizes()?.wheel_radius, 2, "mm"))),
    ("making.backlash-factor", || Ok(fixed(dwell_play()?.greatest / dwell_play()?.middle, 0))),
    ("making.backlash-two-pins", || in_mid_dwell(STATIONS, 2)),
    ("making.backlash-twelve", || in_mid_dwell(12, 2)),
    ("making.backlash-twelve-one", || in_mid_dwell(12, 1)),
    ("making.blow-within", || knock(|of| of.within)),
    ("making.blow-drifted", || knock(|of| of.drifted)),
    ("making.near-depth", || Ok(told(CENTRE_ERROR - sizes()?.locking_gap().context("a locking disc")?))),
    ("making.slot-end", || millimetres(|of| of.slot_end)),
    ("making.web", || millimetres(|of| of.web)),
    ("making.bore-web", || millimetres(Sizes::bore_web)),
    ("making.bore-play", || millimetres(|of| of.play.bore)),
    ("making.nearer", || millimetres(|of| rounded_down(of.centre_tolerance().nearer))),
    ("making.farther", || millimetres(|of| rounded_down(of.centre_tolerance().farther))),
    ("making.horn", || millimetres(|of| of.horn_thickness)),
    ("making.arc", || millimetres(|of| of.locking_arc_radius)),
    ("making.plate", || millimetres(|of| of.plate_radius)),
    ("making.wheel-shaft", || millimetres(|of| of.wheel_shaft_limit)),
    ("making.wheel-bore", || millimetres(|of| of.wheel_bore())),
    ("making.driver-shaft", || millimetres(|of| of.driver_shaft_limit)),
    ("making.driver-bore", || millimetres(|of| of.driver_bore())),
    ("making.disc", || disc(|of| of.radius)),
    ("making.crescent", || disc(|of| of.crescent.radius)),
    ("making.crescent-centre", || disc(|of| of.crescent.centre)),
    ("making.bite", || Ok(with_unit(-least_gap(1)?, 2, "mm"))),
    ("making.passes", || Ok(with_unit(least_gap(2)?, 2, "mm"))),
    ("making.peak-acceleration", || {
        Ok(with_unit(sizes()?.wheel.acceleration_peak().ratio * speed(RPM) * speed(RPM), 3, "rad/s²"))
    }),
    ("making.torque", || loaded(|loads| with_unit(loads.wheel_torque().driving.value, 3, "N&nbsp;m"))),
    ("making.torque-at", || loaded(|loads| before(loads.wheel_torque().driving))),
    ("making.force", || Ok(with_unit(force()?, 2, "N"))),
    ("making.force-at", || loaded(|loads| before(loads.pin_moment().driving))),
    ("making.crank", || loaded(|loads| with_unit(loads.crank_torque().driving.value, 3, "N&nbsp;m"))),
    ("making.crank-at", || loaded(|loads| before(loads.crank_torque().driving))),
    ("making.rms", || loaded(|loads| with_unit(loads.rms_crank_torque(), 2, "N&nbsp;m"))),
    ("making.mean", || loaded(|loads| with_unit(loads.mean_crank_torque(), 2, "N&nbsp;m"))),
    ("making.power", || loaded(|loads| with_unit(loads.peak_power(), 2, "W"))),
    ("making.braking-from", || Ok(degrees(braking()?.0))),
    ("making.braking-until", || Ok(degrees(braking()?.1))),
    ("making.modulus", || {
        let contact = geneva_dynamics::line_contact::contact_modulus(&material(PIN)?, &material(WALL)?);
        Ok(with_unit(contact / 1e9, 3, "GPa"))
    }),
    ("making.pressure", || Ok(with_unit(contact()?.pressure(force()?)? / 1e6, 2, "MPa"))),
    ("making.contact-width", || Ok(with_unit(contact()?.width(force()?)? * 1e6, 2, "µm"))),
    ("making.clearance", || millimetres(|of| of.clearance().least().distance)),
    ("making.tolerance", || Ok(with_unit(sizes()?.clearance().tolerance, 1, "mm"))),
    ("making.backlash-at-rest", || Ok(fixed(dwell_play()?.middle.to_degrees(), 3) + "°")),
    ("making.backlash", || Ok(fixed(sizes()?.index_backlash(0.0)?.to_degrees(), 3) + "°")),
    ("making.late", || {
        let sizes = sizes()?;
        Ok(degrees(entry(&sizes, 0.0)?.crank_angle + sizes.wheel.engagement_half_angle()))
    }),
    ("making.pin-speed", || Ok(with_unit(CRANK_RADIUS * speed(RPM), 3, "mm/s"))),
    ("making.blow", || Ok(with_unit(blow(0.0)?, 2, "mm/s"))),
    ("making.centre-error", || Ok(with_unit(CENTRE_ERROR, 1, "mm"))),
    ("making.blow-apart", || Ok(with_unit(blow(CENTRE_ERROR)?, 2, "mm/s"))),
    ("making.instant.angle", || Ok(degrees(instant()?.angle.abs()))),
    ("making.instant.velocity", || Ok(fixed(instant()?.velocity, 3))),
    ("making.instant.acceleration", || Ok(fixed(instant()?.acceleration, 3))),
    ("making.instant.driver", || Ok(with_unit(speed(INSTANT_RPM), 4, "rad/s"))),
    ("making.instant.speed", || Ok(with_unit(instant()?.velocity * speed(INSTANT_RPM), 3, "rad/s"))),
    ("making.instant.rate", || {
        Ok(with_unit(instant()?.acceleration * speed(INSTANT_RPM) * speed(INSTANT_RPM), 3, "rad/s²"))
    }),
    ("making.sized.crank", || sized(|of| of.crank_radius)),
    ("making.sized.wheel", || sized(|of| of.wheel_radius)),
    ("making.sized.slot", || sized(|of| of.wheel_radius - of.deepest())),
    ("making.sized.pin", || sized(|of| of.pin_diameter)),
    ("making.sized.turn", || Ok(with_unit(60.0 / SIZED_RPM, 1, "s"))),
    ("making.sized.index", || Ok(with_unit(Wheel::new(SIZED)?.indexing_time(speed(SIZED_RPM))?, 2, "s"))),
    ("making.sized.dwell", || Ok(with_unit(Wheel::new(SIZED)?.dwell_time(speed(SIZED_RPM))?, 3, "s"))),
    ("making.loaded.inertia", || Ok(with_unit(LOADED_INERTIA, 1, "kg&nbsp;m²"))),
    ("making.loaded.speed", || Ok(with_unit(speed(LOADED_RPM), 4, "rad/s"))),
    ("making.loaded.ratio", || Ok(fixed(Wheel::new(LOADED)?.acceleration_peak().ratio, 3))),
    ("making.loaded.entry", || {
        let square = speed(LOADED_RPM) * speed(LOADED_RPM);
        Ok(with_unit(entry_acceleration(&Wheel::new(LOADED)?) * square * LOADED_INERTIA, 3, "N&nbsp;m"))
    }),
    ("making.loaded.torque", || four(|loads| with_unit(loads.wheel_torque().driving.value, 3, "N&nbsp;m"))),
    ("making.loaded.crank-radius", || {
        Ok(with_unit(LOADED_CENTRES / Wheel::new(LOADED)?.centre_distance_ratio(), 4, "mm"))
    }),
    ("making.loaded.force", || {
        let radius = LOADED_CENTRES / Wheel::new(LOADED)?.centre_distance_ratio() / 1000.0;
        four(|loads| with_unit(loads.pin_moment().driving.value / radius, 3, "N"))
    }),
    ("making.loaded.force-at", || four(|loads| before(loads.pin_moment().driving))),
    ("making.twice.force", || {
        let wheel = Wheel::new(STATIONS)?;
        let force = WheelLoads::new(&wheel, INERTIA, FRICTION, 2.0 * speed(RPM))?.pin_moment().driving.value;
        Ok(with_unit(force / (CRANK_RADIUS / 1000.0), 2, "N"))
    }),
    ("making.second.inertia", || Ok(with_unit(SECOND_INERTIA, 1, "kg&nbsp;m²"))),
    ("making.second.rpm", || Ok(fixed(60.0 / SECOND_TURN, 0))),
    ("making.second.crank", || second(|of| of.crank_radius)),
    ("making.second.thick-pin", || second(|of| 0.3 * of.crank_radius)),
    ("making.second.deepest", || second(Sizes::deepest)),
    ("making.second.pin", || second(|of| of.pin_diameter)),
    ("making.second.play", || second(|of| of.play.slot)),
    ("making.second.slot-width", || second(|of| of.slot_width)),
    ("making.second.slot-depth", || second(|of| of.slot_depth)),
    ("making.second.disc", || second(|of| of.locking_disc.map_or(f64::NAN, |disc| disc.radius))),
    ("making.second.crescent", || second(|of| of.locking_disc.map_or(f64::NAN, |disc| disc.crescent.radius))),
    ("making.second.bore-web", || second(Sizes::bore_web)),
    ("making.second.wheel-shaft", || second(|of| of.wheel_shaft)),
    ("making.second.bore-play", || second(|of| of.play.bore)),
    ("making.second.nearer", || second(|of| rounded_down(of.centre_tolerance().nearer))),
    ("making.second.farther", || second(|of| rounded_down(of.centre_tolerance().farther))),
    ("making.second.force", || {
        let sizes = second_sizes()?;
        let loads = WheelLoads::new(&sizes.wheel, SECOND_INERTIA, 0.0, speed(60.0 / SECOND_TURN))?;
        Ok(with_unit(loads.pin_moment().driving.value / (sizes.crank_radius / 1000.0), 2, "N"))
    }),
    ("making.internal.acceleration", || Ok(fixed(InternalWheel::new(STATIONS)?.acceleration_peak().ratio, 3))),
    ("making.external.acceleration", || Ok(fixed(Wheel::new(STATIONS)?.acceleration_peak().ratio, 3))),
];

/// The sizes of the worked design: all that is not given has its default.
pub fn sizes() -> anyhow::Result<Sizes> {
    Ok(Sizes::new(Wheel::new(STATIONS)?, Scale::CrankRadius(CRANK_RADIUS), &Choices::default())?)
}

/// A driver's speed in rad/s.
fn speed(rpm: f64) -> f64 {
    rpm * PI / 30.0
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

fn millimetres(of: fn(&Sizes) -> f64) -> anyhow::Result<String> {
    Ok(told(of(&sizes()?)))
}

fn disc(of: fn(&LockingDisc) -> f64) -> anyhow::Result<String> {
    Ok(told(of(&sizes()?.locking_disc.context("a wheel with one pin has a locking disc")?)))
}

/// The least number in a column of the figure of the crescent, in mm.
fn least_gap(column: usize) -> anyhow::Result<f64> {
    let figure = stations::crescent(&sizes()?)?;
    let gaps: Vec<f64> = figure.series.rows.iter().map(|row| row[column]).collect();
    Ok(super::least(&gaps))
}

fn loaded<T>(of: impl Fn(&WheelLoads<'_, Wheel>) -> T) -> anyhow::Result<T> {
    Ok(of(&WheelLoads::new(&Wheel::new(STATIONS)?, INERTIA, FRICTION, speed(RPM))?))
}

fn four<T>(of: impl Fn(&WheelLoads<'_, Wheel>) -> T) -> anyhow::Result<T> {
    Ok(of(&WheelLoads::new(&Wheel::new(LOADED)?, LOADED_INERTIA, 0.0, speed(LOADED_RPM))?))
}

/// How far before the line of centres something is greatest.
fn before(peak: Peak) -> String {
    degrees(-peak.angle)
}

/// The pin's greatest force in N.
fn force() -> anyhow::Result<f64> {
    loaded(|loads| loads.pin_moment().driving.value / (CRANK_RADIUS / 1000.0))
}

fn braking() -> anyhow::Result<(f64, f64)> {
    loaded(|loads| loads.reversal())?.context("the pin holds the wheel back")
}

fn material(name: &str) -> anyhow::Result<Material> {
    MATERIALS.into_iter().find(|material| material.name == name).with_context(|| format!("no material `{name}`"))
}

fn contact() -> anyhow::Result<LineContact> {
    let radius = sizes()?.pin_radius() / 1000.0;
    Ok(LineContact::new(radius, THICKNESS / 1000.0, &material(PIN)?, &material(WALL)?)?)
}

fn entry(sizes: &Sizes, centre_error: f64) -> anyhow::Result<Entry> {
    sizes.entry(centre_error).context("the pin meets the slot")
}

/// Speed in mm/s with which the pin meets the wheel.
fn blow(centre_error: f64) -> anyhow::Result<f64> {
    Ok(entry(&sizes()?, centre_error)?.closing_speed * CRANK_RADIUS * speed(RPM))
}

fn dwell_play() -> anyhow::Result<DwellPlay> {
    sizes()?.dwell_play().context("a wheel with one pin has a dwell")
}

/// How far the wheel can turn forwards so many degrees of the crank before a pin enters.
fn play_before_entry(until: f64) -> anyhow::Result<String> {
    let [forwards, _] = sizes()?.dwell_play_at(until.to_radians()).context("within the dwell")?;
    Ok(fixed(forwards.to_degrees(), 3) + "°")
}

/// The backlash in the middle of the dwell of other numbers of stations and pins, with the same crank radius.
fn in_mid_dwell(stations: u32, pins: u32) -> anyhow::Result<String> {
    let wheel = Wheel::with_pins(stations, pins)?;
    let sizes = Sizes::new(wheel, Scale::CrankRadius(CRANK_RADIUS), &Choices::default())?;
    Ok(fixed(sizes.dwell_play().context("a dwell")?.middle.to_degrees(), 3) + "°")
}

fn slot_direction() -> anyhow::Result<f64> {
    sizes()?.slot_direction_tolerance().context("a locking disc")
}

/// A speed with which the pin meets the wheel, in mm/s.
fn knock(of: fn(&Knock) -> f64) -> anyhow::Result<String> {
    let knock = sizes()?.knock().context("the pin meets the slot")?;
    Ok(with_unit(of(&knock) * CRANK_RADIUS * speed(RPM), 2, "mm/s"))
}

/// The moment of inertia of a steel wheel, in kg m².
fn own_inertia(sizes: &Sizes) -> anyhow::Result<f64> {
    Ok(sizes.outline().wheel.moment_of_inertia(THICKNESS, material("steel")?.density)?)
}

/// The pin's greatest force in N and the greatest torque at the crank in N m, with this crank radius in mm, where a steel wheel
/// adds its own inertia to that of the problem.
fn with_wheel(radius: f64) -> anyhow::Result<(f64, f64)> {
    let sizes = Sizes::new(Wheel::new(STATIONS)?, Scale::CrankRadius(radius), &Choices::default())?;
    let loads = WheelLoads::new(&sizes.wheel, INERTIA + own_inertia(&sizes)?, FRICTION, speed(RPM))?;
    Ok((loads.pin_moment().driving.value / (radius / 1000.0), loads.crank_torque().driving.value))
}

/// The crank radius in whole mm with which that force is least.
fn best_radius() -> anyhow::Result<f64> {
    let mut best = (f64::INFINITY, f64::NAN);
    for radius in 10..=100 {
        let radius = f64::from(radius);
        let force = with_wheel(radius)?.0;
        best = if force < best.0 { (force, radius) } else { best };
    }
    Ok(best.1)
}

/// The greatest torque at the crank and its mean over a turn, in N m, with a pin that rubs in its slot: the power of the friction,
/// the force of the pin times its speed along the slot, comes on top.
fn rubbing() -> anyhow::Result<(f64, f64)> {
    const STEPS: u32 = 2000;
    let wheel = Wheel::new(STATIONS)?;
    let loads = WheelLoads::new(&wheel, INERTIA, FRICTION, speed(RPM))?;
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

fn instant() -> anyhow::Result<Motion> {
    Ok(Wheel::new(STATIONS)?.engaged(INSTANT.to_radians())?)
}

fn sized(of: fn(&Sizes) -> f64) -> anyhow::Result<String> {
    let sizes = Sizes::new(Wheel::new(SIZED)?, Scale::CentreDistance(SIZED_CENTRES), &Choices::default())?;
    Ok(with_unit(of(&sizes), 4, "mm"))
}

fn second_sizes() -> anyhow::Result<Sizes> {
    Ok(Sizes::new(Wheel::new(SECOND)?, Scale::CentreDistance(SECOND_CENTRES), &Choices::default())?)
}

fn second(of: fn(&Sizes) -> f64) -> anyhow::Result<String> {
    Ok(told(of(&second_sizes()?)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_kinematics::wheel::EntryContact;
    use geneva_live::Arguments;

    #[test]
    fn the_worked_design_is_the_figure_as_it_stands_at_first() {
        let live = geneva_live::by_name("design").expect("a figure");
        let answer = live.answer(&Arguments::default()).expect("an answer");
        assert!(answer.figure.svg == stations::dimensions_on_a_page(&sizes().expect("fits")).svg, "another drawing");
        let shown = |name: &str| answer.numbers.iter().find(|number| number.name == name).expect("shown").value;
        let near = |value: f64, shown: f64| assert!((value / shown - 1.0).abs() < 1e-12, "{value} {shown}");
        near(force().expect("loaded"), shown("force"));
        near(loaded(|loads| loads.crank_torque().driving.value).expect("loaded"), shown("crank"));
        near(blow(0.0).expect("met"), shown("blow"));
        near(loaded(|loads| loads.rms_crank_torque()).expect("loaded"), shown("rms"));
        near(loaded(|loads| loads.mean_crank_torque()).expect("loaded"), shown("mean"));
        near(loaded(|loads| loads.peak_power()).expect("loaded"), shown("power"));
        near(contact().expect("one").pressure(force().expect("loaded")).expect("one") / 1e6, shown("pressure"));
        // The hint: a little apart the pin knocks less, and farther apart it meets a corner.
        assert!(live.hint.contains("apart by 0.02 mm") && live.hint.contains("At 0.06 mm"), "another hint");
        let sizes = sizes().expect("fits");
        assert!(blow(LITTLE_APART).expect("met") < 0.8 * blow(0.0).expect("met"));
        assert_eq!(sizes.entry(0.06).expect("met").contact, EntryContact::Mouth);
    }

    #[test]
    fn the_second_design_is_what_its_exercise_says() {
        let sizes = second_sizes().expect("fits");
        let (index, dwell) = (sizes.wheel.motion_fraction(), sizes.wheel.dwell_fraction());
        assert!((SECOND_TURN * index - 0.5).abs() < 1e-12 && (SECOND_TURN * dwell - 1.5).abs() < 1e-12);
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
        for stations in [STATIONS, 12] {
            let wheel = Wheel::with_pins(stations, 2).expect("possible");
            let two = Sizes::new(wheel, Scale::CrankRadius(CRANK_RADIUS), &Choices::default()).expect("fits");
            assert_eq!(two.dwell_play().expect("a dwell").held, 0.0);
        }
        assert!(play.greatest > 10.0 * play.middle && !play.can_miss);
        let own = with_wheel(best_radius().expect("one")).expect("loaded").0;
        assert!(with_wheel(LARGE).expect("loaded").0 > 2.0 * own);
    }

    #[test]
    fn the_blow_is_that_of_the_chapters_formula() {
        let sizes = sizes().expect("fits");
        let sine = (2.0 * sizes.slot_gap() / CRANK_RADIUS).sqrt();
        let blow = entry(&sizes, 0.0).expect("met").closing_speed;
        // sin τ = √(2g/a − (g/a)²).
        assert!((blow / sine - 1.0).abs() < 1e-3, "{blow} {sine}");
    }
}
