//! Of the chapter on the escapement: what came of it, in a few numbers, over all rows of the thesis as the mechanisms are.

use super::kinds::QUADRATURE;
use super::second_routes::contact::ContactModel;
use super::second_routes::motion::SteppedEngagement;
use super::second_routes::rise::SteppedRise;
use super::second_routes::{NEWTON, NEWTON_DIFFERENCE, friction_power, steady};
use crate::rows::{NONE, numbers as of_rows};
use geneva_documents::meyer::runs::table::rows;
use geneva_evidence::{Evidence, Form, OwnNumber};

/// The numbers of the chapter.
pub(super) fn numbers() -> Vec<OwnNumber> {
    vec![
        OwnNumber::new("escapement.engagements", Form::Range("{.0}", ""), QUADRATURE, || {
            Ok(of_rows(rows().iter(), "entry_speed_rise_engagements")?)
        })
        .with_second_route("it settles in a few engagements", NEWTON, || {
            let until = |row| {
                let engagement = SteppedEngagement::new(ContactModel::of_row(row));
                SteppedRise::new(&engagement).and_then(|rise| rise.engagements_until_entry(0.99))
            };
            Ok(rows().iter().map(until).collect::<Option<Vec<_>>>().ok_or(NONE)?)
        }),
        OwnNumber::new("escapement.hand-overs", Form::Range("{.0}", ""), QUADRATURE, || {
            Ok(of_rows(rows().iter(), "hand_over_rate")?)
        })
        .with_second_route("the motion repeats so often", NEWTON, || {
            let rate = |row| steady(ContactModel::of_row(row), |own| Some(1.0 / own.times().last()?));
            rows().iter().map(rate).collect::<Result<Vec<_>, _>>()
        }),
        minutes("escapement.friction-a-day", "friction_rate_s_a_day").with_second_route(
            "it is no clock",
            NEWTON_DIFFERENCE,
            || {
                let minutes = |row| Ok(-DAY * friction_power(ContactModel::of_row(row))?);
                rows().iter().map(minutes).collect::<Result<Vec<f64>, Box<_>>>()
            },
        ),
        // Speeds go as the root of the torque, because u, its slope and the torque share one unit.
        minutes("escapement.torque-a-day", "torque_rate_s_a_day").with_second_route(
            "it is no clock",
            Evidence::CLOSED_FORM,
            || Ok(vec![DAY / 2.0; rows().len()]),
        ),
    ]
}

/// One per cent of the minutes of a day.
const DAY: f64 = 0.01 * 24.0 * 60.0;

/// Minutes a day that one per cent of a quantity makes, over all rows.
fn minutes(id: &'static str, rate: &'static str) -> OwnNumber {
    OwnNumber::new(id, Form::Range("{.1}", " minutes"), QUADRATURE, move || {
        Ok(of_rows(rows().iter(), rate)?.iter().map(|rate| rate.abs() / 60.0).collect::<Vec<_>>())
    })
}
