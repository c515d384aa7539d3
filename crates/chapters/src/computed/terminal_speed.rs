//! Of the chapter on the steady state: multipliers, over the rows of the thesis as the mechanisms are.

use super::kinds::{PRINTED, QUADRATURE};
use super::most;
use super::second_routes::contact::ContactModel;
use super::second_routes::motion::{SteppedEngagement, SteppedPassage};
use super::second_routes::printed_rows::groups_obeying;
use super::second_routes::rise::SteppedRise;
use super::second_routes::{NEWTON, NEWTON_DIFFERENCE, steady};
use crate::rows::{NONE, numbers as of_rows};
use anyhow::Context;
use geneva_case1973::rise_times::is_steady_from_the_first_minimum;
use geneva_case1973::{Column, obeys, rows_of, series};
use geneva_documents::meyer::runs::table::rows;
use geneva_evidence::{Form, Numbers, OwnNumber};
use geneva_kinematics::Mechanism;

/// The numbers of the chapter.
pub(super) fn numbers() -> Vec<OwnNumber> {
    vec![
        multiplier("terminal-speed.multiplier.three-pin", Mechanism::THREE_PIN),
        multiplier("terminal-speed.multiplier.four-pin", Mechanism::FOUR_PIN),
        multiplier("terminal-speed.multiplier.six-pin", Mechanism::SIX_PIN),
        angle(
            "terminal-speed.minimum",
            "minimum_angle_deg",
            "the driver is slowest before the line of centres",
            |own| Some(own.least_speed().angle),
        ),
        angle(
            "terminal-speed.reversal",
            "reversal_angle_deg",
            "the contact is reversed past the line of centres",
            |own| Some(own.reversal()?.angle),
        ),
        OwnNumber::count("terminal-speed.law.groups", || Ok(series(rows()).count())),
        obeying("terminal-speed.law.minima", Column::Minimum, 0.5),
        obeying("terminal-speed.law.periods", Column::Period, -0.5),
        obeying("terminal-speed.law.peaks", Column::Peak, 0.5),
        obeying("terminal-speed.law.rises", Column::Rise, -0.5),
        OwnNumber::new("terminal-speed.first-minimum.within", "{.0}", QUADRATURE, || {
            let near = rows().iter().map(|row| is_steady_from_the_first_minimum(row).context(NONE));
            Ok(near.collect::<Result<Vec<_>, _>>()?.into_iter().filter(|near| *near).count())
        })
        .with_second_route("the tables can hardly show a rise after the first minimum", NEWTON, || {
            let near = rows().iter().map(|row| {
                let engagement = SteppedEngagement::new(ContactModel::of_row(row));
                SteppedRise::new(&engagement)?.is_steady_from_the_first_least(Column::Minimum.unit())
            });
            Ok(near.collect::<Option<Vec<_>>>().ok_or(NONE)?.into_iter().filter(|near| *near).count())
        }),
    ]
}

/// In how many groups of runs the printed numbers of a column go as this power of the torque, each to one unit.
fn obeying(id: &'static str, column: Column, power: f64) -> OwnNumber {
    OwnNumber::new(id, "{.0}", PRINTED, move || Ok(series(rows()).filter(|own| obeys(own, column, power)).count()))
        .with_second_route("the tables obey the law of similarity but for the rises", PRINTED, move || {
            Ok(groups_obeying(column, power))
        })
}

/// What an engagement leaves of a small difference at most, over the rows of a mechanism.
fn multiplier(id: &'static str, mechanism: Mechanism) -> OwnNumber {
    OwnNumber::new(id, "{.3}", QUADRATURE, move || Ok(most(&of_rows(rows_of(rows(), mechanism).iter(), "multiplier")?)))
        .with_second_route("a difference dies away so fast", NEWTON_DIFFERENCE, move || {
            let of = |row| Ok(SteppedEngagement::new(ContactModel::of_row(row)).multiplier().ok_or(NONE)?);
            Ok(most(&rows_of(rows(), mechanism).iter().map(of).collect::<Numbers>()?))
        })
}

/// The size of an angle of the steady state in degrees, over all rows.
fn angle(
    id: &'static str,
    key: &'static str,
    conclusion: &'static str,
    again: fn(&SteppedPassage<'_>) -> Option<f64>,
) -> OwnNumber {
    OwnNumber::new(id, Form::Range("{.1}", "°"), QUADRATURE, move || {
        Ok(of_rows(rows().iter(), key)?.into_iter().map(f64::abs).collect::<Vec<_>>())
    })
    .with_second_route(conclusion, NEWTON, move || {
        let angle = |row| Ok(steady(ContactModel::of_row(row), again)?.to_degrees().abs());
        rows().iter().map(angle).collect::<Numbers>()
    })
    // Degrees: a small part of a step.
    .with_allowance(0.002)
}
