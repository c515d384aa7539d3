//! What is said of sizes of which one is wrong, or worn, while the measurements don't say which one.

use super::check_needs::UnmeasuredSize;
use super::check_words::named;
use crate::number_format::number;
use geneva_kinematics::wheel::as_built::{DoubtReason, MeasuredSize, NearestWheel, UndecidedCulprit};

/// Measurements that are named at most, each of which would tell.
const MOST_NAMED: usize = 3;

/// The doubt in words: what is wrong, and that these sizes don't tell which part.
pub(super) fn doubt_words(doubt: &UndecidedCulprit, nearest: &NearestWheel) -> String {
    let either = either(&doubt.sizes);
    let what = match doubt.doubt {
        DoubtReason::Contradiction => format!("the {either} is wrong"),
        DoubtReason::Play { play, most } => {
            let pair =
                if doubt.sizes.contains(&MeasuredSize::PinDiameter) { "pin in its slot" } else { "disc in its arc" };
            format!(
                "the {pair} has {} mm of play, and a new one at most {} mm: the {either} is worn",
                number(play),
                number(most)
            )
        }
        DoubtReason::NoDesign => {
            let reason = nearest.refusal.as_ref().map_or_else(String::new, |error| format!(": {}", error.reason()));
            let which = match &doubt.sizes[..] {
                [] => "more than one of them is wrong".to_owned(),
                [one] => format!("the {} goes with none of the others", named(*one)),
                _ => format!("the {either} is wrong"),
            };
            format!("no wheel has exactly these sizes{reason}. So {which}")
        }
    };
    if doubt.sizes.len() == 1 {
        return what;
    }
    format!("{what}. Which one cannot be told from these sizes; {}", measuring_words(doubt))
}

/// What to measure so that it is told which size is wrong.
pub(super) fn measuring_words(doubt: &UndecidedCulprit) -> String {
    let telling = doubt.telling.iter().take(MOST_NAMED);
    let named: Vec<String> = telling.map(|size| format!("the {}", UnmeasuredSize::of_all(*size).words())).collect();
    if named.is_empty() {
        "measure them again, and more finely".to_owned()
    } else {
        format!("measure {}", named.join(" or "))
    }
}

/// Sizes with "or" between them.
fn either(sizes: &[MeasuredSize]) -> String {
    sizes.iter().map(|size| named(*size)).collect::<Vec<_>>().join(" or the ")
}

/// The numbers of stations that fit all sizes, in words; none if there are none.
pub(super) fn stations_words(fitting: &[u32], given: u32) -> Option<String> {
    let [first, ..] = fitting else { return None };
    let all: Vec<String> = fitting.iter().map(u32::to_string).collect();
    Some(format!(
        "all sizes fit a wheel of {} stations, so count the slots again and try --stations {first}. With {given}",
        all.join(" or ")
    ))
}
