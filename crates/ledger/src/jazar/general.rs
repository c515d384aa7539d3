//! The wheel of any number of stations: its geometry and the equations (5.30) to (5.32).

use super::four::{printed_5_28, printed_5_29, printed_5_32};
use super::*;
use crate::{Consequence, Erratum, Origin, Slip, Verdict};
use geneva_kinematics::prove;
use geneva_kinematics::wheel::{acceleration_peak, entry_acceleration, peak_velocity};
use geneva_kinematics::wheel_proofs::{Printed, Quantity};

const GEOMETRY: &str = "Paragraph on Fig. 5.31";
const DURATION: &str = "2nd paragraph on Fig. 5.31";
const RATIOS: &str = "Paragraph before Eq. (5.30)";

pub fn claims() -> Vec<Claim> {
    [geometry(), sizes(), equations()].concat()
}

fn geometry() -> Vec<Claim> {
    vec![
        Claim::statement(
            WORK,
            "jazar.alpha",
            GEOMETRY,
            "α is the angle between slot and line of centres as the pin enters or leaves",
            "moment of engagement",
            Check::equation(
                (Vectors, || {
                    for_all_stations(
                        |wheel| agrees(-entry_angle(wheel), wheel.half_station()),
                        "the slot is at α as the pin enters",
                    )
                }),
                (LimitCase, || {
                    for_all_stations(
                        |wheel| agrees(by_series(wheel, wheel.engagement_half_angle())[0], wheel.half_station()),
                        "and as it leaves",
                    )
                }),
            ),
        ),
        Claim::figure(
            WORK,
            "jazar.fig-5.31",
            "Fig. 5.31, caption",
            "neighbouring slots are 2α apart",
            "half the angle",
            Check::equation(
                (ClosedForm, || {
                    for_all_stations(
                        |wheel| agrees(2.0 * wheel.half_station() * f64::from(wheel.stations()), 2.0 * PI),
                        "N times 2α is a turn",
                    )
                }),
                (Vectors, || {
                    for_all_stations(
                        |wheel| {
                            agrees(
                                by_series(wheel, wheel.engagement_half_angle())[0] - entry_angle(wheel),
                                2.0 * PI / f64::from(wheel.stations()),
                            )
                        },
                        "an advance is one station",
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.alpha-degrees",
            DURATION,
            "α in degrees",
            r"360^{\circ}/(2N)",
            Check::equation(
                (ClosedForm, || {
                    for_all_stations(
                        |wheel| agrees(wheel.half_station().to_degrees(), 360.0 / (2.0 * f64::from(wheel.stations()))),
                        "α is 360°/(2N)",
                    )
                }),
                (Vectors, || {
                    for_all_stations(
                        |wheel| agrees(-entry_angle(wheel).to_degrees(), 360.0 / (2.0 * f64::from(wheel.stations()))),
                        "the slot's angle at entry is 360°/(2N)",
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.duration",
            DURATION,
            "crank angle of an advance",
            r"\pi - 2\alpha",
            Check::equation(
                (Series, || {
                    for_all_stations(
                        |wheel| vanishes(by_series(wheel, PI / 2.0 - wheel.half_station())[1]),
                        "the wheel is at rest at ±(π/2 − α)",
                    )
                }),
                (Vectors, || {
                    for_all_stations(
                        |wheel| {
                            let end = Turn::from_radians(PI / 2.0 - wheel.half_station());
                            let pin = pin_from_pivot(&wheel.centre_distance_ratio(), &end);
                            vanishes(pin.dot(&end.reversed().direction()))
                        },
                        "slot and crank are at right angles there",
                    )
                }),
            ),
        ),
        Claim::value(
            WORK,
            "jazar.duration-limit",
            DURATION,
            "limit of the crank angle of an advance for very many stations",
            ("180", "°"),
            Check::number(
                (LimitCase, || limit(|n| of(n, |wheel| 2.0 * wheel.engagement_half_angle()).to_degrees())),
                (ClosedForm, || PI.to_degrees()),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.duration-grows",
            DURATION,
            "with more stations the advance takes more of the driver's turn",
            "increases",
            Check::equation(
                (ClosedForm, || {
                    compare_neighbours(|a, b| a.motion_fraction() < b.motion_fraction(), "the moving part grows")
                }),
                (LimitCase, || {
                    compare_neighbours(
                        |a, b| a.engagement_half_angle() < b.engagement_half_angle(),
                        "the engagement grows",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.gentler",
            DURATION,
            "with more stations the peaks of velocity and acceleration fall",
            "more gentle",
            Check::equation(
                (ClosedForm, || {
                    compare_neighbours(
                        |a, b| {
                            peak_velocity(a) > peak_velocity(b)
                                && entry_acceleration(a) > entry_acceleration(b)
                                && acceleration_peak(a).ratio > acceleration_peak(b).ratio
                        },
                        "peak velocity, jump and peak of the acceleration all fall",
                    )
                }),
                (Series, || {
                    compare_neighbours(
                        |a, b| peak_by_series(a).1 > peak_by_series(b).1,
                        "the peak acceleration of the power series falls",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.dwell-shrinks",
            DURATION,
            "with more stations the wheel stands still for less of the turn",
            "decreasing",
            Check::equation(
                (ClosedForm, || {
                    compare_neighbours(|a, b| a.dwell_fraction() > b.dwell_fraction(), "the dwell shrinks")
                }),
                (LimitCase, || same(limit(|n| of(n, Wheel::dwell_fraction)), 0.5)),
            ),
        ),
    ]
}

fn sizes() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "jazar.centre-distance-ratio",
            RATIOS,
            "centre distance over crank radius",
            r"1/\sin \alpha",
            Check::equation(
                (ClosedForm, || {
                    for_all_stations(
                        |wheel| agrees(wheel.centre_distance_ratio(), 1.0 / libm::sin(wheel.half_station())),
                        "1/sin α",
                    )
                }),
                (Vectors, || {
                    for_all_stations(
                        |wheel| at_rest_on_entry(wheel, wheel.centre_distance_ratio()),
                        "with it the pin enters along the slot",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.wheel-radius-ratio",
            RATIOS,
            "1/tan α is the outside diameter of the wheel over the pin's radius",
            "outside diameter: 1/tan α",
            Check::corrected_equation(
                (Vectors, || {
                    for_all_stations(
                        |wheel| agrees(2.0 * entry_radius(wheel), 1.0 / libm::tan(wheel.half_station())),
                        "the diameter is 1/tan α",
                    )
                }),
                || {
                    for_all_stations(
                        |wheel| agrees(entry_radius(wheel), 1.0 / libm::tan(wheel.half_station())),
                        "the radius is 1/tan α",
                    )
                },
                // The paragraph on Fig. 5.28: four stations have the outer radius r, and 1/tan 45° = 1.
                (OtherPlaceInSource, || same(1.0 / libm::tan(PI / 4.0), 1.0)),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "outside radius: 1/tan α",
            slip: Slip {
                id: "",
                reason: "The ratio is that of the wheel's outer radius to the radius of the pin's circle; the \
                    diameter is twice as large. Read as centre distance over diameter it fails too: that is 1/(2 \
                    cos α).",
                witness: "The source's own wheel of four has the outer radius r.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
        Claim::equation(
            WORK,
            "jazar.alpha-radians",
            "Sentence before Eq. (5.30)",
            "α in radians",
            r"\alpha = \pi/N",
            Check::equation(
                (ClosedForm, || {
                    for_all_stations(|wheel| agrees(wheel.half_station(), PI / f64::from(wheel.stations())), "α is π/N")
                }),
                (Vectors, || {
                    for_all_stations(
                        |wheel| agrees(-entry_angle(wheel), PI / f64::from(wheel.stations())),
                        "the slot's angle at entry is π/N",
                    )
                }),
            ),
        ),
        Claim::statement(
            WORK,
            "jazar.generalises",
            "Sentence before Eq. (5.30)",
            "Eqs. (5.27) to (5.29) are the case of four stations of Eqs. (5.30) to (5.32)",
            "become",
            Check::corrected_equation(
                (ClosedForm, || four_from_general(1.0)),
                || four_from_general(-1.0),
                (ExactIdentity, || prove(&Printed(Quantity::Acceleration)).into()),
            ),
        )
        .expecting(Verdict::Corrected)
        .with_erratum(Erratum {
            corrected: "become, once Eq. (5.29) has its minus sign",
            slip: Slip {
                id: "",
                reason: "For four stations Eq. (5.32) has the opposite sign of Eq. (5.29) as printed.",
                witness: "Eq. (5.32) is proven against power series for every α.",
                origin: Origin::Misprint,
                consequence: Consequence::Wording,
                changes: "",
            },
        }),
    ]
}

fn equations() -> Vec<Claim> {
    vec![
        Claim::equation(
            WORK,
            "jazar.eq-5.30",
            "Eq. (5.30)",
            "wheel angle, N stations",
            r"\phi = \tan^{-1} \left(\frac{\sin \alpha \sin \theta}{1 - \sin \alpha \cos \theta} \right)",
            Check::equation(
                (ExactIdentity, || prove(&Printed(Quantity::Tangent)).into()),
                (Vectors, || {
                    for_all_stations(
                        |wheel| thirds(wheel).all(|t| agrees(printed_angle(wheel, t), by_series(wheel, t)[0])),
                        "the formula is the direction of the pin",
                    )
                }),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.eq-5.31",
            "Eq. (5.31)",
            "angular velocity of the wheel, N stations",
            r"\dot{\phi} = \dot{\theta} \sin \alpha \left(\frac{\cos \theta - \sin \alpha}{1 + \sin^2 \alpha - 2 \sin \alpha \cos \theta} \right)",
            Check::equation(
                (ExactIdentity, || prove(&Printed(Quantity::Velocity)).into()),
                (AutomaticDerivative, || as_by_duals(1, printed_5_31)),
            ),
        ),
        Claim::equation(
            WORK,
            "jazar.eq-5.32",
            "Eq. (5.32)",
            "angular acceleration of the wheel, N stations",
            r"\ddot{\phi} = -\dot{\theta}^2 \frac{\sin \alpha \cos^2 \alpha \sin \theta}{(1 + \sin^2 \alpha - 2 \sin \alpha \cos \theta)^2}",
            Check::equation(
                (ExactIdentity, || prove(&Printed(Quantity::Acceleration)).into()),
                (AutomaticDerivative, || as_by_duals(2, printed_5_32)),
            ),
        ),
    ]
}

/// Whether Eqs. (5.30) to (5.32) with α = 45° are Eqs. (5.27) to (5.29), the last with this sign.
fn four_from_general(sign: f64) -> Finding {
    let Ok(wheel) = four_stations() else { return Finding::new(false, "no wheel of four") };
    let root = 2f64.sqrt();
    let agree = |general: fn(&Wheel, f64) -> f64, four: &dyn Fn(f64) -> f64| {
        thirds(&wheel).all(|t| vanishes(general(&wheel, t) - four(t)))
    };
    let pairs = [
        ("(5.30)", agree(printed_angle, &|t| libm::atan(libm::sin(t) / (root - libm::cos(t))))),
        ("(5.31)", agree(printed_5_31, &printed_5_28)),
        ("(5.32)", agree(printed_5_32, &|t| sign * printed_5_29(t))),
    ];
    let differing: Vec<_> = pairs.iter().filter(|(_, agree)| !agree).map(|(name, _)| *name).collect();
    let how =
        if differing.is_empty() { "all three agree".to_owned() } else { format!("{} differs", differing.join(", ")) };
    Finding::new(differing.is_empty(), how)
}

/// Wheel angle as the pin enters.
fn entry_angle(wheel: &Wheel) -> f64 {
    by_series(wheel, -wheel.engagement_half_angle())[0]
}

/// Distance of the pin from the wheel's axis as it enters, in crank radii: the least outer radius.
fn entry_radius(wheel: &Wheel) -> f64 {
    pin_from_pivot(&wheel.centre_distance_ratio(), &Turn::from_radians(wheel.engagement_half_angle())).norm()
}

/// Whether crank and slot are at right angles where the slot is at α, for this centre distance.
fn at_rest_on_entry(wheel: &Wheel, ratio: f64) -> bool {
    let crank = Turn::from_radians(PI / 2.0 - wheel.half_station());
    let pin = pin_from_pivot(&ratio, &crank);
    agrees(libm::atan2(pin.y, pin.x), wheel.half_station()) && vanishes(pin.dot(&crank.reversed().direction()))
}

/// Some crank angles of the engagement, none of them zero.
fn thirds(wheel: &Wheel) -> impl Iterator<Item = f64> {
    let end = wheel.engagement_half_angle();
    [-1.0, -2.0 / 3.0, -1.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].into_iter().map(move |part| part * end)
}

/// Eq. (5.31) as it is printed, for a driver of speed one.
fn printed_5_31(wheel: &Wheel, theta: f64) -> f64 {
    let (sine, cosine) = (libm::sin(wheel.half_station()), libm::cos(theta));
    sine * (cosine - sine) / (1.0 + sine * sine - 2.0 * sine * cosine)
}

/// Eq. (5.30) as it is printed.
fn printed_angle(wheel: &Wheel, theta: f64) -> f64 {
    let sine = libm::sin(wheel.half_station());
    libm::atan(sine * libm::sin(theta) / (1.0 - sine * libm::cos(theta)))
}

/// Whether something holds between each wheel and the one with a station more.
fn compare_neighbours(holds: fn(&Wheel, &Wheel) -> bool, how: &str) -> Finding {
    let failing: Vec<_> =
        (3..60).filter(|n| !Wheel::new(*n).and_then(|a| Ok(holds(&a, &Wheel::new(n + 1)?))).unwrap_or(false)).collect();
    Finding::new(
        failing.is_empty(),
        if failing.is_empty() { how.to_owned() } else { format!("fails from {failing:?}") },
    )
}

/// Limit for N to infinity of a quantity that goes with 1/N: twice the value at 2 N less that at N.
fn limit(quantity: fn(u32) -> f64) -> f64 {
    2.0 * quantity(1000) - quantity(500)
}
