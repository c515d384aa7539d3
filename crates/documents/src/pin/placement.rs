//! How the lost drawing can have shown the mechanism, and which arrows belong to each case.
//!
//! The text says in which sense the driver turns. It says neither where the line OB points nor in which sense the angle of
//! the crank is counted from it. So there are eight placements of the drawing: OB points in one of four directions, and
//! the pin is on either side of it. A public page that continues the problem prints one of the lost arrows.

use super::continuation::SLIDING_ARROW;
use super::*;

/// A placement of the mechanism on the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Placement {
    /// How many quarter turns OB is turned counter-clockwise, from pointing to the right.
    pub quarters: u8,
    /// Whether the crank's angle is counted clockwise from OB, while the driver turns counter-clockwise.
    pub mirrored: bool,
}

/// OB points to the right, and the angle of the crank is counted counter-clockwise. A test shows that the page's arrow
/// leaves no other placement.
pub(crate) const BY_THE_PAGE: Placement = Placement { quarters: 0, mirrored: false };

/// How a claim is read whose truth depends on the placement.
pub(crate) const AS_ON_THE_PAGE: &str = "The copy has lost the drawing, and the text does not say how the line OB lies. We \
                                         take OB to be horizontal, with B to the right of O, and count the angle of the \
                                         crank counter-clockwise. Of the eight ways of drawing the mechanism that we \
                                         tried, only this one fits the arrow that a public page prints. That page \
                                         continues the problem.";

/// What the problem's drawing would settle.
pub(super) const LOST_DRAWING: &str = "The copy we had does not include the drawing. The crank radius stands in the \
                                       solution. But the text does not say where the line OB points, nor in which sense \
                                       the angle of the crank is counted from it. The printed angles fit eight ways of \
                                       drawing the mechanism, and we know which of them is meant only from a public page \
                                       that continues the problem";

impl Placement {
    /// All eight.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        (0..8).map(|k| Self { quarters: k % 4, mirrored: k >= 4 })
    }

    /// Where a direction points on the page that is counted from OB; in degrees, counter-clockwise from the right.
    pub(crate) fn heading(self, from_the_line: f64) -> f64 {
        (from_the_line + 90.0 * f64::from(self.quarters)).rem_euclid(360.0)
    }

    /// Where a velocity points on the page that points to this side of OB if the angle of the crank is counted
    /// counter-clockwise. In the mirror image the driver turns as before, so all velocities are mirrored and reversed.
    pub(crate) fn heading_of_velocity(self, from_the_line: f64) -> f64 {
        self.heading(if self.mirrored { 180.0 - from_the_line } else { from_the_line })
    }

    /// A quantity of the motion in this placement, by vectors with the first axis along OB; not a number if there is no
    /// such position.
    pub(crate) fn by_vectors(self, quantity: impl Fn(&PinProblem, &PinMotion<f64>) -> f64) -> f64 {
        let found = PinProblem::placed(self).ok().and_then(|at| Some(quantity(&at, &at.by_vectors()?)));
        found.unwrap_or(f64::NAN)
    }
}

/// The placement in which the directions of the problem are computed. Tests also try the others.
pub(super) fn drawn() -> Placement {
    #[cfg(test)]
    if let Some(tried) = TRIED.get() {
        return tried;
    }
    BY_THE_PAGE
}

#[cfg(test)]
thread_local! {
    /// The placement that a test tries on this thread.
    pub(super) static TRIED: std::cell::Cell<Option<Placement>> = const { std::cell::Cell::new(None) };
}

/// The direction of a vector in degrees, counter-clockwise from the first axis, from 0° to 360°.
pub(crate) fn heading(vector: &Vector2<f64>) -> f64 {
    Turn { cos: vector.x, sin: vector.y }.degrees().rem_euclid(360.0)
}

/// An arrow before an angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Arrow {
    pub up: bool,
    pub right: bool,
    pub from_the_horizontal: bool,
}

impl Arrow {
    /// Reads the arrow that the words describe; none if they describe none, as a letter does.
    pub(crate) fn read(words: &str) -> Option<Self> {
        let either = |one: &str, other: &str| match (words.contains(one), words.contains(other)) {
            (true, false) => Some(true),
            (false, true) => Some(false),
            _ => None,
        };
        Some(Self {
            up: either("up", "down")?,
            right: either("right", "left")?,
            from_the_horizontal: either("horizontal", "vertical")?,
        })
    }

    /// All eight.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        (0..8).map(|k| Self { up: k & 1 == 1, right: k & 2 == 2, from_the_horizontal: k & 4 == 4 })
    }

    /// The angle that is printed behind the arrow for a direction in degrees, counter-clockwise from the right; outside of
    /// 0° to 90° if the arrow points elsewhere.
    fn angle(self, heading: f64) -> f64 {
        // Turned over so that the arrow points up and to the right.
        let heading = if self.right { heading } else { 180.0 - heading };
        let heading = if self.up { heading } else { -heading }.rem_euclid(360.0);
        if self.from_the_horizontal { heading } else { 90.0 - heading }
    }

    /// The only arrow that makes all these printed angles right, for these directions; none if there is none or another.
    pub(crate) fn fitting<const N: usize>(angles: [&Decimal; N], headings: [f64; N]) -> Option<Self> {
        let fits = |arrow: &Self| {
            let mut pairs = angles.iter().zip(&headings);
            pairs.all(|(printed, heading)| printed.is_rounding_of(arrow.angle(*heading)))
        };
        let mut fitting = Self::all().filter(fits);
        fitting.next().filter(|_| fitting.next().is_none())
    }
}

/// The arrows of a placement: the one before the angles of the pin's velocity and of its sliding velocity, and the one
/// before the angle of the slot point's velocity.
type Arrows = [Arrow; 2];

/// The placements in which arrows fit the printed angles, with these arrows, for the directions of the three velocities.
pub(super) fn fitting(headings: impl Fn(Placement) -> [f64; 3]) -> Vec<(Placement, Arrows)> {
    let ids = ["pin.pin-velocity-direction", "pin.sliding-velocity-direction", "pin.slot-point-velocity-direction"];
    let [pin, sliding, point] = ids.map(|id| PIN.printed_decimal(id));
    let arrows = |placement| {
        let [of_pin, of_sliding, of_point] = headings(placement);
        Some([Arrow::fitting([&pin, &sliding], [of_pin, of_sliding])?, Arrow::fitting([&point], [of_point])?])
    };
    Placement::all().filter_map(|placement| Some((placement, arrows(placement)?))).collect()
}

/// Whether the arrow in the statement is the one of these that the page's arrow leaves.
pub(super) fn left_by_the_page(all: &[(Placement, Arrows)], which: fn(Arrows) -> Arrow, stated: Stated) -> Finding {
    let page = Arrow::read(SLIDING_ARROW);
    let Some(said) = Arrow::read(stated.characters()) else {
        return Finding::new(false, "a letter is printed, which points nowhere");
    };
    let left: Vec<_> = all.iter().filter(|(_, [first, _])| Some(*first) == page).collect();
    let found = match left[..] {
        [(_, arrows)] => which(*arrows) == said,
        _ => false,
    };
    let (all, left) = (all.len(), left.len());
    Finding::new(
        found,
        format!(
            "{all} of eight placements of the drawing fit the printed angles, each with its own arrows; the page's arrow \
             leaves {left}, which decides on this arrow"
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_evidence::{Check, judge};

    #[test]
    fn eight_placements_fit_the_printed_angles_and_the_arrow_of_the_page_leaves_one() {
        let fitting = fitting(signs::by_vectors);
        assert_eq!(fitting.len(), 8);
        for (at, (_, arrows)) in fitting.iter().enumerate() {
            assert!(fitting[..at].iter().all(|(_, others)| others != arrows), "{arrows:?}");
        }
        let page = Arrow::read(SLIDING_ARROW);
        let left: Vec<_> = fitting.iter().filter(|(_, [first, _])| Some(*first) == page).collect();
        assert!(matches!(left[..], [(BY_THE_PAGE, _)]), "{left:?}");
        // In each of them the wheel turns against the driver.
        for placement in Placement::all() {
            assert!(placement.by_vectors(|at, motion| motion.follower_speed * at.driver_speed) < 0.0);
        }
    }

    #[test]
    fn what_the_placement_changes_is_open_or_says_which_one_is_taken() {
        let complaints = |claim: &'static Claim, placement| {
            TRIED.set(Some(placement));
            let judged = judge(claim);
            TRIED.set(None);
            judged.complaints()
        };
        let (mut changing, mut wrong) = (Vec::new(), Vec::new());
        for claim in PIN.claims().iter() {
            if matches!(claim.check, Check::Missing { .. }) {
                continue;
            }
            let found: Vec<_> = Placement::all().flat_map(|placement| complaints(claim, placement)).collect();
            let said = claim.reading.is_some_and(|reading| reading.starts_with(AS_ON_THE_PAGE));
            // The marks go through all placements by themselves.
            let goes_through_all = ["pin.mark-d", "pin.mark-f"].contains(&claim.id);
            if said == found.is_empty() && !goes_through_all {
                wrong.push(format!("{}: {said}, {}", claim.id, found.join("; ")));
            }
            changing.extend((!found.is_empty()).then_some(claim.id));
        }
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
        assert_eq!(changing.len(), 3, "{changing:?}");
    }
}
