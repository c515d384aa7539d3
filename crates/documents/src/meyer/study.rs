//! Chapter II to Fig. 8, the abstract, and what the headings of Appendix E say beside their numbers.

use super::inertia::printed_inertia;
use super::runs::table::{UNIT, rows, units_in_one};
use super::*;
use crate::evidence::QUADRATURE;
use geneva_case1973::{Column, Hypothesis, Row};
use geneva_dynamics::steady::SteadyState;
use geneva_evidence::agreement::joined;
use geneva_kinematics::Mechanism;
use std::sync::OnceLock;

const LIST: Locator = at("Chapter II, list of parameters");
const TABLES: &str = "Appendix E, title and headings";

/// The claims of chapter II before Fig. 8.
pub(super) fn of_parameters() -> Vec<Claim> {
    vec![
        parameters::six(),
        LIST.statement(
            "meyer.parameter.entry-angle",
            "θ_0 : the angular position of the pin as it enters",
            "the angle θ_0 is where the pin enters",
        )
        .first_route(Evidence::EXACT_IDENTITY, |stated| {
            // The place in question is that with the sign of Appendix D; a pin that enters moves inwards there.
            let inwards: fn(&HandOver) -> bool = |at| at.entering.outward.approximate() < 0.0;
            let outwards: fn(&HandOver) -> bool = |at| at.entering.outward.approximate() > 0.0;
            exactly(stated.pick(inwards, outwards), "we found the sense of the pin's velocity in its slot at −π/m")
        })
        .second_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
            let printed = MEYER.printed_text("meyer.app-d.angles");
            let angles: Vec<f64> =
                printed.split('-').skip(1).filter_map(|angle| numeric_tokens(angle).first()?.parse().ok()).collect();
            let step = 1e-3;
            let nearer = |(at, angle): (Mechanism, &f64)| {
                let out = |angle: f64| PinKinematics::new(&at, angle).radius();
                (out(-angle.to_radians() + step) - out(-angle.to_radians())) * stated.pick(-1.0, 1.0) > 0.0
            };
            let holds = angles.len() == 3 && Mechanism::ALL.into_iter().zip(&angles).all(nearer);
            Finding::new(
                holds,
                format!(
                    "we checked how the pin's distance changes just past the angles of Appendix D, {} degrees before \
                     the line of centres",
                    joined(&angles)
                ),
            )
        })
        .but_not("it is where the pin leaves")
        .interpreted_as(
            "We take the angle with its sign, as Appendix D has it. Chapter I and Appendix A give its size.",
        ),
        spring::constant(
            "meyer.parameter.spring",
            LIST,
            "K is called a constant of the spring",
            "K: the torsional spring constant of the driving spring",
        ),
        at("Chapter II, sentence after the estimate of I")
            .statement(
                "meyer.inertias-vary",
                "did vary somewhat from this figure",
                "the inertias of the runs are near the estimate",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let (bounds, times) = (factors(stated), over_estimate());
                // The least and the greatest are what is stated, rounded; or all are within somewhat.
                let ends = range(times.iter().copied());
                let exactly = ends.map(f64::round) == [*bounds.start(), *bounds.end()];
                let holds = times.len() == 5 && stated.pick(exactly, ends.iter().all(|times| bounds.contains(times)));
                let each: Vec<String> = times.iter().map(|times| format!("{times:.0}")).collect();
                Finding::new(holds, format!("the inertias of the runs are {} times the estimate", joined(&each)))
            })
            .second_route(QUADRATURE, |stated| {
                let (bounds, times) = (factors(stated), over_estimate_by_periods());
                let holds = !times.is_empty()
                    && times.iter().all(|[least, most]| most >= bounds.start() && least <= bounds.end());
                let all = times.iter().fold([f64::INFINITY, 0.0], |all, of| [all[0].min(of[0]), all[1].max(of[1])]);
                Finding::new(
                    holds,
                    format!(
                        "the printed periods with four pins belong to inertias {:.1} to {:.0} times the estimate",
                        all[0], all[1]
                    ),
                )
            })
            .interpreted_as("We read “somewhat” as less than a factor of ten.")
            .corrected(
                "were 6 to 100 times this figure",
                Slip {
                    id: "",
                    reason: "The smallest inertia in the tables is several times the estimate, and the largest is a \
                             hundred times the estimate. We do not know how the estimate came to be printed beside \
                             such inertias.",
                    witness: "Only inertias of about the size given in the tables reproduce the printed periods of the \
                              four-pin table to within one unit of the last place.",
                    origin: Origin::Concept,
                    consequence: Consequence::Remark,
                    changes: "Parts with the inertias of the tables are not like the parts that the thesis describes. \
                              For the greatest inertia, a disc of the described thickness would have to be more than \
                              three times as wide as described.",
                },
            ),
    ]
}

/// The axis of Fig. 11.
pub(super) fn of_axis() -> Claim {
    spring::constant(
        "meyer.fig-11.abscissa",
        at("Fig. 11, abscissae"),
        "the driving quantity is called a spring constant, in inch-pounds per radian",
        "SPRING CONSTANT, IN LB/RAD",
    )
}

/// The claims in the headings of Appendix E, beside their numbers.
pub(super) fn of_headings() -> Vec<Claim> {
    vec![
        runs::headings::of_headings(),
        spring::torque_per_radian(
            "meyer.app-e.torque-unit",
            TABLES,
            "K, in inch-pounds per radian, is a torque, the work done per radian",
            "K in lb/rad",
        ),
    ]
}

/// The factors between which the inertias are: those of the correction, or a power of ten either way.
fn factors(stated: Stated) -> std::ops::RangeInclusive<f64> {
    let said = stated.numbers();
    let [least, most] = [said.first(), said.last()].map(|number| number.copied().unwrap_or(f64::NAN));
    stated.pick(least..=most, 0.1..=10.0)
}

/// The inertias of the runs over the estimate, by size.
fn over_estimate() -> Vec<f64> {
    let estimate = units_in_one(UNIT) * printed_inertia();
    let ids = ["meyer.app-e.4-pin.driver", "meyer.app-e.6-pin.follower", "meyer.app-e.6-pin.driver"];
    let more = ["meyer.app-e.3-pin.follower", "meyer.app-e.4-pin.follower"];
    ids.iter().chain(&more).map(|id| MEYER.printed_number(id) / estimate).collect()
}

/// The inertias of driver and follower over the estimate, least and most, that each period of the four-pin table
/// allows, if it may be off by a unit of its last place: with the quotient of the two kept, periods go as the root of
/// the inertia.
fn over_estimate_by_periods() -> Vec<[f64; 2]> {
    let own = steady().iter().filter(|(row, _)| row.mechanism == Mechanism::FOUR_PIN);
    let of = |(row, state): &(&Row, SteadyState)| {
        let inertias = Hypothesis::IDEAL.parameters(row)?.inertias();
        let part = [-1e-3, 1e-3].map(|off| (row.number(Column::Period) + off) / state.period);
        Some(
            [inertias.driver(), inertias.follower()]
                .map(|inertia| part.map(|part| part * part * inertia / printed_inertia())),
        )
    };
    own.filter_map(of).flatten().collect()
}

/// All rows, each with the steady motion of the mechanism as it is.
pub(super) fn steady() -> &'static [(&'static Row, SteadyState)] {
    static STEADY: OnceLock<Vec<(&Row, SteadyState)>> = OnceLock::new();
    let of = |row| Some((row, Hypothesis::IDEAL.engagement(row)?.steady_state().ok()?));
    STEADY.get_or_init(|| rows().iter().filter_map(of).collect())
}
