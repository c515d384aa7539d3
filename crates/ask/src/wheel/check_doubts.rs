//! What is said of sizes of which one is wrong, or worn, while the measurements don't say which one.

use super::check_needs::UnmeasuredSize;
use super::check_words::named;
use crate::number_format::{number, rounded_down, rounded_up};
use geneva_kinematics::wheel::as_built::{
    DoubtReason, MeasuredSize, NearestWheel, UncertainWear, UndecidedCulprit, UntoldWear,
};

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

/// Wear that can't be told from play or from chance, in words, and what to give so that it is told.
pub(super) fn untold_words(untold: &[UntoldWear], uncertain: &[UncertainWear]) -> String {
    let of_pair = |wear: &UntoldWear| {
        let [wide, thin] = wear.sizes;
        let names = if thin == MeasuredSize::PinDiameter { "slots or pins" } else { "arcs or disc" };
        let sizes = [wide, thin].into_iter().filter_map(MeasuredSize::size_when_new).map(UnmeasuredSize::of_all);
        let options: Vec<String> = sizes.map(|size| format!("--{}", size.option())).collect();
        format!(
            "{names} worn by less than {} mm cannot be told from play without a size when new, because a new wheel may have had anything \
             from no play to all of the {} mm that are measured, and these are uncertain, too; give {}",
            rounded_up(wear.below),
            number(wear.play.max(0.0)),
            options.join(" or ")
        )
    };
    let of_one = |wear: &UncertainWear| {
        let when_new = wear.size.size_when_new().map_or_else(String::new, |size| UnmeasuredSize::of_all(size).words());
        format!(
            "{}: {} mm off the {when_new}, but with these uncertainties it is certain only from {} mm on; measure both with an \
             uncertainty of {} mm or less",
            wear.size.name(),
            number(wear.wear),
            rounded_up(wear.certain_from),
            rounded_down(wear.needed_uncertainty)
        )
    };
    untold.iter().map(of_pair).chain(uncertain.iter().map(of_one)).collect::<Vec<_>>().join("; ")
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

#[cfg(test)]
mod tests {
    use crate::MechanismReport;
    use crate::wheel::CheckQuestion;

    #[test]
    fn wear_that_cannot_be_told_from_play_is_bounded_until_a_size_when_new_is_given() {
        let asked = |more: &str| {
            let sizes = "--stations 6 --crank-radius 50+-0.01 --centre-distance 100+-0.01 --pin-diameter 10+-0.01 --slot-width 10.2+-0.01";
            CheckQuestion::parse(&format!("{sizes} {more}")).expect(more).answer().expect(more)
        };
        let bound = |report: &MechanismReport| report.field("untold_wear_mm").and_then(|field| field.number());
        let open = asked("");
        assert!(bound(&open).is_some_and(|bound| bound > 0.2 && bound < 0.26), "{:?}", bound(&open));
        let sheet = open.plain_sheet();
        assert!(sheet.contains("cannot be told from play") && sheet.contains("--new-slot-width"), "{sheet}");
        assert_eq!(bound(&asked("--new-slot-width 10.1+-0.01")), None);
        // What is more than an ordinary play is told as wear, and not bounded.
        let worn =
            CheckQuestion::parse("--stations 6 --crank-radius 50 --pin-diameter 10 --slot-width 13").expect("sizes");
        assert_eq!(bound(&worn.answer().expect("a wheel")), None);
        let both = asked("--locking-disc-radius 34.5 --locking-arc-radius 34.7").plain_sheet();
        assert!(both.contains("arcs or disc worn by less than"), "{both}");
    }
}
