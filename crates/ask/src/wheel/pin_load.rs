//! Strength of the pin, and what the wheel's bearings carry, as they are reported.

use super::design::WheelDesign;
use super::materials::PartMaterials;
use crate::number_format::number;
use crate::{Error, Needs, ReportField, Rounding};
use geneva_dynamics::line_contact::{contact_modulus, pressure_limit};
use geneva_dynamics::pin_strength::{Cantilever, PinLength, least_diameter_for_pressure, least_diameter_for_strength};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{PinEntry, Sizes};

const FORCE: Needs = Needs::SPEED.union(Needs::INERTIA).union(Needs::SIZE);
const ARM: Needs = Needs::ARM_TORQUE.union(Needs::SIZE);
const MILLI: f64 = 1000.0;
const MEGA: f64 = 1e6;
/// Places within the play at which a wheel that has drifted is struck.
const DRIFTS: u32 = 64;
/// An arm in crank radii below which a blow goes through the wheel's axis.
const LEAST_ARM: f64 = 1e-3;

/// What a force does to a pin: stresses in MPa, the factors of strength and pressure, and the least pin in mm.
#[derive(Clone, Copy, Default)]
struct PinCheck {
    force: Option<f64>,
    pressure: Option<f64>,
    pressure_factor: Option<f64>,
    bending: Option<f64>,
    shear: Option<f64>,
    factor: Option<f64>,
    least: Option<f64>,
}

/// The fields of the pin, of the blow on it and of the bearings.
pub(super) fn fields(design: &WheelDesign, wheel: &(impl Indexing + ?Sized)) -> Result<Vec<ReportField>, Error> {
    let loads = design.loads(wheel)?;
    let [running, arm] = checks(design, wheel)?;
    let friction = loads.as_ref().map(|loads| loads.friction());
    let bearing = running.force.zip(friction).map(|(force, friction)| force * libm::hypot(friction.pin, 1.0));
    let sizes = design.sizes.as_ref();
    let [sliding, rubbing] = match loads.as_ref().filter(|_| sizes.is_some()) {
        Some(loads) => loads.greatest_sliding().map(|peak| Some(peak.value)),
        None => [None; 2],
    };
    // A moment over the crank radius times a speed over it: the power itself, over the projected area in mm².
    let area = sizes.zip(design.thickness).map(|(sizes, thickness)| sizes.pin_diameter * thickness);
    let pv = rubbing.zip(area).map(|(power, area)| power / area);
    let sliding = sliding.zip(design.crank_radius).map(|(speed, radius)| speed * radius);
    let blows = blows(design);
    let limit = limit(design);
    let mpa = |key, value: Option<f64>| ReportField::in_unit(key, value, "MPa").rounded(Rounding::Significant(3));
    let [pressure_factor, pin_factor] = factors(&running);
    let newtons = |key, value| ReportField::in_unit(key, value, "N");
    let mm = |key, value| ReportField::in_unit(key, value, "mm");
    let limit_meaning = match design.question.allowed_pressure {
        Some(_) => "allowed pressure, as given",
        None => {
            "at which the weaker of pin and wheel begins to yield: with a Poisson's ratio of 0.3, below its surface, at 1.8 × its strength (Johnson)"
        }
    };
    let least_meaning = match design.question.thickness {
        Some(_) => "that bears this force with a factor of 1 in pressure, bending and shear, with this thickness",
        None => "that bears this force with a factor of 1 in pressure, bending and shear, as long as it is thick",
    };
    let bending_meaning = "F (gap + thickness/2) / (π d³/32), where the plate holds it: the gap is the axial play";
    Ok(vec![
        mpa("pressure_limit_mpa", limit).line("pressure limit", limit_meaning).needing(Needs::SIZE),
        pressure_factor,
        mpa("pin_bending_stress_mpa", running.bending)
            .line("bending of the pin", format!("at the greatest pin force, driving or braking: {bending_meaning}"))
            .needing(FORCE),
        mpa("pin_shear_stress_mpa", running.shear)
            .line("shear of the pin", "at the greatest pin force, driving or braking: 4/3 F / (π d²/4), in its middle")
            .needing(FORCE),
        pin_factor,
        mm("least_pin_diameter_mm", running.least).line("least pin", least_meaning).needing(FORCE),
        newtons("arm_pin_force_n", arm.force)
            .line("arm torque", "its force on the pin in mid-index: torque / crank radius")
            .needing(ARM),
        mpa("arm_contact_pressure_mpa", arm.pressure).line("", "its contact pressure (Hertz)").needing(ARM),
        factor("arm_pressure_factor", arm.pressure_factor).line("", "pressure limit over that").needing(ARM),
        mpa("arm_pin_bending_stress_mpa", arm.bending).line("", "its bending of the pin").needing(ARM),
        mpa("arm_pin_shear_stress_mpa", arm.shear).line("", "its shear of the pin").needing(ARM),
        factor("arm_pin_factor", arm.factor).line("", "strength factor of the pin").needing(ARM),
        mm("arm_least_pin_diameter_mm", arm.least).line("least pin", least_meaning).needing(ARM),
        ReportField::in_unit("peak_sliding_mm_s", sliding, "mm/s")
            .line("sliding of the pin", "greatest speed of its surface on the wall: dr/dθ ± its radius × its turning")
            .needing(FORCE)
            .rounded(Rounding::Significant(3)),
        ReportField::in_unit("peak_pv_mpa_m_s", pv, "MPa m/s")
            .line("pv", "force / (diameter × thickness) × sliding speed at the angle of the greatest product, as bearing materials are rated")
            .needing(FORCE)
            .rounded(Rounding::Significant(3)),
        newtons("peak_bearing_load_n", bearing)
            .line(
                "bearing load",
                "of wheel and of driver, in the plane of the wheel: F √(1 + μ²); no weight, no overhang",
            )
            .needing(FORCE),
        ReportField::in_unit("blow_energy_mj", blows[0], "mJ")
            .line(
                "energy of the blow",
                "as the pin enters, wheel in mid-play: J ω²/2, ω its speed after, and as much is lost; none on the rim",
            )
            .needing(FORCE)
            .rounded(Rounding::Significant(3)),
        ReportField::in_unit("drifted_blow_energy_mj", blows[1], "mJ")
            .line(
                "blow after drift",
                "its energy with the wheel anywhere in its greatest play; none if the pin can then hit the rim",
            )
            .needing(FORCE)
            .rounded(Rounding::Significant(3)),
    ])
}

/// What the loads of running do to the pin, and what the torque on the arm does.
fn checks(design: &WheelDesign, wheel: &(impl Indexing + ?Sized)) -> Result<[PinCheck; 2], Error> {
    let moment = design.loads(wheel)?.map(|loads| loads.pin_moment().greatest());
    let running = check(design, moment.and_then(|moment| design.force(moment)))?;
    let arm = check(design, design.question.arm_torque.and_then(|torque| design.force(torque)))?;
    Ok([running, arm])
}

/// A warning for each load that pin or wheel can't bear.
pub(super) fn weaknesses(design: &WheelDesign, wheel: &(impl Indexing + ?Sized)) -> Result<Vec<String>, Error> {
    let checks = checks(design, wheel)?;
    let loads = ["the peak pin force", "the force of the arm's torque"];
    let weak = |(load, check): (&str, &PinCheck)| {
        let said = |part: &str, factor: Option<f64>| {
            let factor = factor.filter(|factor| *factor < 1.0)?;
            let least = check.least.map_or_else(String::new, |least| format!(" of {} mm at least", number(least)));
            Some(format!(
                "{part} bears only {} of {load}: choose a thicker pin{least}, or a larger wheel",
                number(factor)
            ))
        };
        [said("the pin", check.factor), said("the contact of pin and slot", check.pressure_factor)]
    };
    Ok(loads.into_iter().zip(&checks).flat_map(weak).flatten().collect())
}

fn factor(key: &'static str, value: Option<f64>) -> ReportField {
    ReportField::new(key, value).rounded(Rounding::Significant(3))
}

/// The factors of the pin under the greatest force in N: all that a page shows of its strength.
pub(super) fn live_fields(design: &WheelDesign, force: Option<f64>) -> Result<[ReportField; 2], Error> {
    Ok(factors(&check(design, force)?))
}

fn factors(running: &PinCheck) -> [ReportField; 2] {
    [
        factor("pressure_factor", running.pressure_factor)
            .line("pressure factor", "pressure limit over peak contact pressure; the force may grow by its square"),
        factor("pin_factor", running.factor)
            .line("strength factor", "of the pin: its strength over that bending, or over √3 × that shear (von Mises)"),
    ]
    .map(|field| field.needing(FORCE).visible_in_live_figure())
}

/// The greatest pressure in MPa that pin and wheel should have.
fn limit(design: &WheelDesign) -> Option<f64> {
    let PartMaterials { pin, wheel, .. } = &design.materials;
    design.sizes.map(|_| design.question.allowed_pressure.unwrap_or_else(|| pressure_limit(pin, wheel) / MEGA))
}

/// What a force in N does to the pin; nothing without sizes.
fn check(design: &WheelDesign, force: Option<f64>) -> Result<PinCheck, Error> {
    let Some(newtons) = force else { return Ok(PinCheck::default()) };
    let (Some(sizes), Some(thickness), Some(gap), Some(limit)) =
        (design.sizes, design.thickness, design.axial_play(), limit(design))
    else {
        return Ok(PinCheck { force, ..PinCheck::default() });
    };
    let PartMaterials { pin, wheel, .. } = &design.materials;
    let pressure = design.pressure(newtons)?;
    let beam = Cantilever::new(sizes.pin_diameter / MILLI, thickness / MILLI, gap / MILLI)?;
    let length = design.question.thickness.map_or(PinLength::Diameter, |given| PinLength::Given(given / MILLI));
    let for_pressure = least_diameter_for_pressure(newtons, length, contact_modulus(pin, wheel), limit * MEGA)?;
    let for_strength = least_diameter_for_strength(newtons, length, gap / MILLI, pin.strength)?;
    // Without a force no factor is finite.
    let finite = |factor: f64| Some(factor).filter(|factor| factor.is_finite());
    Ok(PinCheck {
        force,
        pressure,
        pressure_factor: pressure.and_then(|pressure| finite(limit / pressure)),
        bending: Some(beam.bending(newtons)? / MEGA),
        shear: Some(beam.shear(newtons)? / MEGA),
        factor: finite(beam.factor(pin.strength, newtons)?),
        least: Some(for_pressure.max(for_strength) * MILLI),
    })
}

/// Energies in mJ that wheel and table must take on at once as the pin enters: with the wheel in the middle of its play, and the
/// greatest with the wheel anywhere in it. The driver is taken to be heavy, and what is lost in the blow is as much.
fn blows(design: &WheelDesign) -> [Option<f64>; 2] {
    let (Some(sizes), Some(speed), Some(inertia)) = (&design.sizes, design.speed(), design.inertia) else {
        return [None; 2];
    };
    let energy = |jump: f64| inertia * jump * jump * speed * speed / 2.0 * MILLI;
    let error = design.centre_error();
    let centred = sizes.entry(error).and_then(|entry| jump(&entry));
    [centred.map(energy), greatest_drifted(sizes, error).map(energy)]
}

/// The jump of the wheel's speed over the driver's, without its sign; none where the pin hits the rim, on which its force has no arm
/// about the wheel's axis.
fn jump(entry: &PinEntry) -> Option<f64> {
    let jump = entry.velocity_jump.abs();
    // The jump is the closing speed over the arm, in crank radii. On the rim the arm is zero but for rounding.
    (jump * LEAST_ARM <= entry.closing_speed).then_some(jump)
}

/// The greatest jump of the wheel's speed over the driver's, wherever the wheel is in its play, with the axes so far in millimetres from
/// their place; none if the pin can then hit the rim.
fn greatest_drifted(sizes: &Sizes, centre_error: f64) -> Option<f64> {
    let play = sizes.dwell_play()?;
    // With the axes in their place the blow forwards is the greater one.
    let senses: &[f64] = if centre_error == 0.0 { &[1.0] } else { &[1.0, -1.0] };
    let drifts = senses.iter().flat_map(|sense| (0..=DRIFTS).map(move |k| sense * f64::from(k) / f64::from(DRIFTS)));
    let entries = drifts.filter_map(|share| sizes.drifted_entry(centre_error, share * play.greatest));
    entries.map(|entry| jump(&entry)).try_fold(0.0, |greatest: f64, jump| Some(greatest.max(jump?)))
}

#[cfg(test)]
mod tests {
    use crate::{MechanismReport, ReportField, answer};
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    fn number(report: &MechanismReport, key: &str) -> f64 {
        report.field(key).and_then(ReportField::number).expect(key)
    }

    /// Juvinall and Marshek, problem 9.29, by the book's formula: the tests of `pin_strength` have its source. The arm's length is ours.
    #[test]
    fn the_problem_of_juvinall_and_marshek_is_asked_and_answered() {
        let own = "--pin-material hardened-steel --pin-poisson 0.3 --wheel-modulus 140 --wheel-poisson 0.25 --allowed-pressure 700";
        let report = answer(&format!("wheel --stations 4 --crank-radius 50 --arm-torque 60 {own}")).unwrap();
        assert_relative_eq!(number(&report, "arm_pin_force_n"), 1200.0, max_relative = 1e-12);
        let diameter = number(&report, "arm_least_pin_diameter_mm");
        assert_relative_eq!(diameter, 11.9, max_relative = 5e-3);
        // With that pin, as long as it is thick, the pressure is the allowed one.
        let report = answer(&format!(
            "wheel --stations 4 --crank-radius 50 --arm-torque 60 {own} --pin-diameter {diameter} --thickness {diameter}"
        ))
        .unwrap();
        assert_relative_eq!(number(&report, "arm_contact_pressure_mpa"), 700.0, max_relative = 1e-9);
        assert_relative_eq!(number(&report, "arm_pressure_factor"), 1.0, max_relative = 1e-9);
    }

    /// From the numbers of the same sheet, by hand.
    #[test]
    fn a_blow_with_the_axes_in_another_place_has_an_energy_unless_the_pin_hits_the_rim() {
        // The corner of a horn is hit at up to 10 mm, and beyond that the rim, where the blow goes through the wheel's axis.
        let mut missing = 0;
        for error in [0.0, 0.5, 2.0, 4.0, 8.0, 10.0, 11.0, 12.0, 15.0] {
            let report =
                answer(&format!("wheel --stations 6 --crank-radius 25 --rpm 60 --inertia .001 --centre-error {error}"))
                    .unwrap();
            let energy = |key: &str| report.field(key).and_then(ReportField::number);
            let (centred, drifted) = (energy("blow_energy_mj"), energy("drifted_blow_energy_mj"));
            assert!(centred.is_none_or(|energy| energy < 1e3), "{error}: {centred:?}");
            // Anywhere in the play is in its middle, too.
            assert!(
                drifted.is_none_or(|most| centred.is_some_and(|energy| energy <= most)),
                "{error}: {centred:?} {drifted:?}"
            );
            missing += u32::from(centred.is_none());
        }
        assert!((1..=5).contains(&missing), "{missing}");
    }

    #[test]
    fn a_friction_that_leaves_no_lever_but_rounding_is_refused_with_a_value_that_works() {
        // Three stations with 25 mm: the pin's friction of 3 takes the whole lever.
        let asked = |friction: &str| {
            answer(&format!("wheel --stations 3 --crank-radius 25 --rpm 60 --inertia 0.001 --pin-friction {friction}"))
        };
        for friction in ["3", "3.0000001"] {
            let refused = asked(friction).unwrap_err().to_string();
            assert!(refused.contains(&format!("--pin-friction {friction}")), "{refused}");
        }
        assert!(number(&asked("2.9").unwrap(), "peak_pin_force_n").is_finite());
    }

    #[test]
    fn the_rows_follow_from_each_other() {
        let asked = "wheel --stations 6 --crank-radius 40 --rpm 50 --inertia 0.0225 --thickness 12 --pin-friction 0.15 --friction-torque 0.1";
        let report = answer(asked).unwrap();
        let (force, pin) = (number(&report, "peak_pin_force_n"), number(&report, "pin_diameter_mm"));
        let gap = number(&report, "play_mm");
        let bending = 32.0 * force * (gap + 6.0) / (PI * pin * pin * pin);
        assert_relative_eq!(number(&report, "pin_bending_stress_mpa"), bending, max_relative = 1e-12);
        let shear = 4.0 / 3.0 * force / (PI / 4.0 * pin * pin);
        assert_relative_eq!(number(&report, "pin_shear_stress_mpa"), shear, max_relative = 1e-12);
        // Steel of 210 MPa.
        let factor = (210.0 / bending).min(210.0 / (3.0_f64.sqrt() * shear));
        assert_relative_eq!(number(&report, "pin_factor"), factor, max_relative = 1e-12);
        assert_relative_eq!(number(&report, "peak_bearing_load_n"), force * 1.0225_f64.sqrt(), max_relative = 1e-12);
        let limit = number(&report, "pressure_factor") * number(&report, "peak_contact_pressure_mpa");
        assert_relative_eq!(limit, number(&report, "pressure_limit_mpa"), max_relative = 1e-12);
        // The heavy pin takes along a mass J/x², x where it meets the wall: by then it has come in from the wheel radius.
        let knock = number(&report, "knock_mm_s");
        let met = number(&report, "wheel_radius_mm") - 40.0 * knock / (40.0 * 50.0 * PI / 30.0);
        let energy = 0.5 * number(&report, "inertia_kgm2") * (knock / met).powi(2) * 1e3;
        assert_relative_eq!(number(&report, "blow_energy_mj"), energy, max_relative = 1e-9);
        assert!(number(&report, "drifted_blow_energy_mj") > energy);
        // pv is no more than the greatest force at the greatest speed.
        let most = force / (pin * 12.0) * number(&report, "peak_sliding_mm_s") / 1e3;
        let pv = number(&report, "peak_pv_mpa_m_s");
        assert!(pv < most && pv > 0.3 * most, "{pv} of {most}");
    }

    #[test]
    fn a_blow_on_the_rim_has_no_energy_of_turning() {
        let (mut told, mut rim) = (0, 0);
        for (stations, play) in
            [3, 4, 5, 6, 8, 12].into_iter().flat_map(|stations| [0.1, 0.4, 1.0, 2.0].map(|play| (stations, play)))
        {
            let asked = format!("wheel --stations {stations} --crank-radius 25 --rpm 60 --play {play}");
            let Ok(report) = answer(&asked) else { continue };
            match report.field("drifted_blow_energy_mj").and_then(ReportField::number) {
                // No more than the wheel has at fifty times the driver's speed.
                Some(energy) => {
                    let driver = 0.5 * number(&report, "inertia_kgm2") * (2.0 * PI).powi(2) * 1e3;
                    assert!(energy > 0.0 && energy < 2500.0 * driver, "{stations}, {play}: {energy} of {driver}");
                    told += 1;
                }
                None => rim += 1,
            }
        }
        assert!(told > 3 && rim > 0, "{told} told, {rim} on the rim");
    }

    #[test]
    fn own_materials_replace_numbers_of_the_list() {
        let with = |more: &str| answer(&format!("wheel --stations 6 --crank-radius 40 --rpm 50 {more}"));
        let (steel, soft) = (with("").unwrap(), with("--pin-modulus 50 --wheel-modulus 50").unwrap());
        let softer = (50.0_f64 / 207.0).sqrt();
        let [of_steel, of_soft] = [&steel, &soft].map(|report| number(report, "peak_contact_pressure_mpa"));
        assert_relative_eq!(of_soft, softer * of_steel, max_relative = 1e-12);
        let strong = with("--pin-strength 420").unwrap();
        assert_relative_eq!(number(&strong, "pin_factor"), 2.0 * number(&steel, "pin_factor"), max_relative = 1e-12);
        // The wheel still yields first.
        assert_eq!(number(&strong, "pressure_limit_mpa"), number(&steel, "pressure_limit_mpa"));
        let error = with("--wheel-poisson 0.6").unwrap_err().to_string();
        assert!(error.contains("--wheel-poisson 0.6: ") && error.contains("give --wheel-poisson up to 0.5"), "{error}");
    }
}
