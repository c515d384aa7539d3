//! The master's project: the Geneva mechanism with a pin always engaged, as a timing device.
//!
//! The claims follow the order of the source: tables of contents and figures, the geometry of the escapement, the
//! rates of the follower, the sizes of appendix A, the spring of appendix C. `PinKinematics` gives the pin by
//! coordinates.

mod angles;
mod appendix_a;
mod appendix_b;
mod appendix_c;
mod appendix_d;
mod by_steps;
mod centres;
mod combinations;
mod concluded;
mod conclusions;
mod counts;
mod disc_data;
mod disc_letters;
mod energy;
mod friction;
mod front;
mod general_statements;
mod geometry;
mod hand_over;
mod hand_over_letters;
mod inertia;
mod instants;
mod lagrange;
mod less_friction;
mod letters;
mod listed;
mod motion;
mod named_mechanisms;
mod newton;
mod parameters;
mod peaks;
mod profile;
mod rates;
mod recommendations;
pub mod runs;
mod singularity;
mod singularity_letters;
mod slips;
mod spring;
mod study;
mod summary;
mod symbols;
pub mod terms;

pub use concluded::CONCLUSIONS;
pub use symbols::SYMBOLS;

use geneva_evidence::agreement::{agrees, joined, range, same, vanishes};
use geneva_evidence::tex as reading;
use geneva_evidence::{
    Cache, Claim, Consequence, Document, Evidence, Finding, InventoryFile, Locator, Origin, Slip, Stated,
    numeric_tokens,
};
use geneva_kinematics::escapement::{HandOver, Mechanism, Roots};
use geneva_kinematics::pin_vectors::quarter_turn;
use geneva_kinematics::wheel::Wheel;
use geneva_kinematics::{Field, Identity, Turn, prove};
use nalgebra::Vector2;
use std::f64::consts::PI;

/// A master's project of 1973: the Geneva mechanism as a timing device.
pub static MEYER: Document = Document {
    slug: "meyer",
    title: "thesis",
    citation: "H. W. Meyer Jr., An Analysis of the Geneva Mechanism as a Timing Device, master's project, Newark College \
        of Engineering, May 1973. Equations (1-1) to (1-19), program and tables; figures 1 to 15 as captions only.",
    inventory: Some(InventoryFile {
        path: "crates/documents/sources/meyer.inventory",
        text: include_str!("../../sources/meyer.inventory"),
    }),
    claims,
    answers: &[],
    given: || runs::data::inputs().collect(),
    conclusions: CONCLUSIONS,
    symbols: SYMBOLS,
    units: &[
        ("speed of the driver", "rad/sec"),
        ("rise time of the run that is drawn", "seconds"),
        ("rise time of the run, from rest", "sec"),
        ("time between two peaks", "sec"),
        ("time between printed lines", "s"),
        ("torque of the spring", "in lb/rad"),
        ("moment of inertia", "× 10^-6 in lb sec²"),
        ("angle", "°"),
        ("coefficient of friction", ""),
        ("slots of", ""),
        ("pins of", ""),
        ("centre distance", ""),
        ("distance of the pin from the follower's axis", ""),
        ("half a turn", ""),
        ("a quarter of a turn in radians", ""),
        ("degrees in a radian", ""),
    ],
    test: "cargo test -p geneva-documents --test verdicts meyer_stands",
    cache: Cache::new(),
};

/// A place in this source.
const fn at(locator: &'static str) -> Locator {
    Locator::new(&MEYER, locator)
}

/// A figure of which the copy has only the number.
fn lost_curves(id: &'static str, locator: &'static str, meaning: &'static str, printed: &'static str) -> Claim {
    at(locator).figure(id, printed, meaning).missing("The copy we had does not contain the curves")
}

/// All claims of the project, in the order of the source.
pub fn claims() -> Vec<Claim> {
    [
        summary::claims(),
        front::claims(),
        named_mechanisms::claims(),
        geometry::claims(),
        counts::of_the_derivation(),
        combinations::claims(),
        angles::claims(),
        rates::claims(),
        lagrange::claims(),
        friction::claims(),
        energy::claims(),
        motion::claims(),
        singularity::claims(),
        study::of_parameters(),
        parameters::after_the_list(),
        inertia::claims(),
        profile::claims(),
        peaks::claims(),
        counts::of_the_study(),
        general_statements::claims(),
        conclusions::claims(),
        recommendations::claims(),
        runs::headings::of_figures(),
        appendix_a::claims(),
        appendix_b::claims(),
        appendix_c::claims(),
        appendix_d::claims(),
        study::of_headings(),
        runs::cells::claims(),
    ]
    .concat()
}

/// A driver's speed and acceleration for the checks of rates: any will do, if neither is zero.
const DRIVER: (f64, f64) = (1.75, -2.5);

/// The pin of an escapement by coordinates; the follower's angle grows with the second coordinate.
///
/// Lengths in radii of the pins' circle. Nothing here is a formula of the source.
struct PinKinematics {
    /// Centre distance over the radius of the pins' circle.
    ratio: f64,
    /// The driver's angle from the line of centres.
    crank: Turn<f64>,
    /// The pin from the follower's axis, first coordinate towards the driver.
    place: Vector2<f64>,
    /// Velocity of the pin at the driver's speed.
    velocity: Vector2<f64>,
    /// Acceleration of the pin.
    acceleration: Vector2<f64>,
}

impl PinKinematics {
    /// An escapement at an angle of its driver.
    fn new(escapement: &Mechanism, angle: f64) -> Self {
        Self::driven(escapement.centre_distance_ratio(), angle, DRIVER)
    }

    /// The pin for a ratio of lengths, an angle, and a speed and an acceleration of the driver.
    fn driven(ratio: f64, angle: f64, (speed, angular_acceleration): (f64, f64)) -> Self {
        let crank = Turn::from_radians(angle);
        let from_driver = crank.direction();
        let across = quarter_turn(&from_driver);
        let mirrored = |vector: Vector2<f64>| Vector2::new(-vector.x, vector.y);
        Self {
            ratio,
            place: mirrored(from_driver - Vector2::new(ratio, 0.0)),
            velocity: mirrored(across * speed),
            acceleration: mirrored(across * angular_acceleration - from_driver * (speed * speed)),
            crank,
        }
    }

    /// Distance of the pin from the follower's axis.
    fn radius(&self) -> f64 {
        self.place.norm()
    }

    /// The follower's angle.
    fn angle(&self) -> f64 {
        libm::atan2(self.place.y, self.place.x)
    }

    /// The follower's angular velocity, which carries the pin across the slot.
    fn angular_velocity(&self) -> f64 {
        self.place.perp(&self.velocity) / self.place.norm_squared()
    }

    /// The follower's angular acceleration, from the acceleration across the slot without Coriolis's part.
    fn angular_acceleration(&self) -> f64 {
        let along = self.place.normalize();
        let sliding = along.dot(&self.velocity);
        (along.perp(&self.acceleration) - 2.0 * sliding * self.angular_velocity()) / self.radius()
    }
}

/// Whether two numbers agree for the three escapements at twenty instants each, none of them on the line of centres.
fn at_instants(both: impl Fn(&PinKinematics) -> (f64, f64)) -> Finding {
    let worst = Mechanism::ALL
        .iter()
        .flat_map(|escapement| (-10..10).map(|k| PinKinematics::new(escapement, instant(escapement, k))))
        .map(|seen| {
            let (a, b) = both(&seen);
            (a - b).abs() / a.abs().max(b.abs()).max(1.0)
        })
        .fold(0.0, f64::max);
    let holds = worst <= geneva_evidence::ROUTES.relative;
    let how = if holds { "are equal at each" } else { "differ at some" };
    Finding::new(holds, format!("the two quantities compared {how} of 20 instants, in all three escapements"))
}

/// The k-th of the instants between −10 and 9.
fn instant(escapement: &Mechanism, k: i32) -> f64 {
    escapement.engagement_half_angle() * f64::from(2 * k + 1) / 20.0
}

/// Whether a property holds for each of the three escapements; or for which it fails.
fn for_each(holds: impl Fn(&Mechanism) -> bool, how: &str) -> Finding {
    let failing: Vec<u32> = Mechanism::ALL.iter().filter(|at| !holds(at)).map(|at| at.slots()).collect();
    match failing[..] {
        [] => Finding::new(true, format!("{how}, for each of the three mechanisms")),
        _ => Finding::new(false, format!("{how}: this fails with {} slots", joined(failing))),
    }
}

/// Whether a property of the hand-over without rounding holds for each of the three escapements.
fn exactly(holds: impl Fn(&HandOver) -> bool, how: &str) -> Finding {
    for_each(|escapement| holds(&escapement.hand_over()), &format!("{how}, with the roots exact"))
}

/// Whether a number is zero, with its roots exact.
fn is_zero(number: &Roots) -> bool {
    *number == Roots::integer(0)
}

/// Whether all of the identities hold, with the finding for each.
fn all_proven<const V: usize>(identities: &[impl Identity<V>]) -> Finding {
    let findings: Vec<Finding> = identities.iter().map(|identity| prove(identity).into()).collect();
    Finding::of_cases(findings.iter().all(|finding| finding.holds), &findings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LEDGER;
    use geneva_evidence::{Check, Kind, Verdict};

    #[test]
    fn claims_on_the_reset_take_the_angle_between_pins_in_so_many_words_or_are_wrong_with_it() {
        let mut kept = Vec::new();
        for claim in claims().iter().filter(|claim| claim.id.starts_with("meyer.app-b.")) {
            let words =
                ["each engagement", "single engagements", "engagements of one pin", "angle of the pin in its slot"];
            let of_the_reset = ["reset", "modulo", "X varies"].iter().any(|word| claim.meaning.contains(word));
            if !of_the_reset && !words.iter().any(|word| claim.meaning.contains(word)) {
                continue;
            }
            let wrong = claim.erratum.is_some_and(|erratum| erratum.slip.id == slips::RESET_ANGLE.id);
            let reading = claim.reading.unwrap_or_default();
            let read = reading.contains("is a claim of its own");
            // The sentence that the printed program is the one that ran is about its reset as it is printed.
            let as_printed = claim.meaning.contains("the printed program, with its reset");
            assert!(wrong != read || as_printed, "{}: {reading}", claim.id);
            kept.push(claim.id);
        }
        assert_eq!(
            kept,
            [
                "meyer.app-b.actual-program",
                "meyer.app-b.fold",
                "meyer.app-b.series",
                "meyer.app-b.hand-over",
                "meyer.app-b.one-pin-at-a-time",
                "meyer.app-b.angle-in-lines",
                "meyer.app-b.varies-only",
            ]
        );
    }

    #[test]
    fn a_near_miss_is_false_in_all_cases_that_its_finding_counts() {
        let stated = |claim: &Claim| claim.document == &MEYER && matches!(claim.kind, Kind::Statement | Kind::Figure);
        let mut counted = 0;
        for judged in LEDGER.verdicts_where(stated) {
            for (form, finding) in judged.findings.iter().filter(|(form, _)| form.starts_with("neighbour")) {
                let words: Vec<&str> = finding.how.split_whitespace().collect();
                for pair in words.windows(3).filter(|pair| pair[1] == "of" && pair[2].parse::<u32>().is_ok()) {
                    if let Ok(count) = pair[0].parse::<u32>() {
                        counted += 1;
                        assert_eq!(count, 0, "{}, {form}: {}", judged.claim.id, finding.how);
                    }
                }
                let mechanisms = finding.how.split("this fails with ").nth(1).filter(|of| !of.contains("slots and"));
                let three = !finding.how.contains("three to eighteen");
                if let Some(failing) = mechanisms.filter(|_| three) {
                    counted += 1;
                    assert_eq!(failing, "3, 4 and 6 slots", "{}, {form}", judged.claim.id);
                }
            }
        }
        assert!(counted > 20, "{counted}");
    }

    #[test]
    fn a_near_miss_says_nothing_that_another_claim_says() {
        let all = claims();
        let near = |claim: &Claim| match claim.check {
            Check::Statement { neighbour, .. } => neighbour,
            _ => None,
        };
        for claim in &all {
            let Some(said) = near(claim) else { continue };
            let other = all.iter().find(|other| other.id != claim.id && other.meaning == said);
            assert!(other.is_none(), "{}: {said}", claim.id);
        }
    }

    #[test]
    fn a_reading_that_cites_a_claim_as_open_or_as_another_s_agrees_with_its_verdict() {
        let verdict = |id: &str| geneva_evidence::judge(MEYER.lookup(id)).verdict;
        let reading = |id: &str| MEYER.lookup(id).reading.expect("a reading");
        let demand = "it is open whether as a need or as a choice";
        for id in ["meyer.conclusion.three", "meyer.conclusion.the-three"] {
            assert!(reading(id).contains(demand), "{id}");
        }
        assert_eq!(verdict("meyer.always-engaged"), Verdict::NotReproducible);
        assert!(reading("meyer.first-minimum").contains("it would be open"));
        assert_eq!(verdict("meyer.fig-8.rise"), Verdict::NotReproducible);
        assert!(reading("meyer.app-b.cannot-be-solved").contains("whose verdict is open"));
        for id in ["meyer.app-b.must-be-solved", "meyer.app-b.simultaneous"] {
            assert_eq!(verdict(id), Verdict::NotReproducible);
        }
        for id in ["meyer.app-b.series", "meyer.app-b.hand-over", "meyer.app-b.one-pin-at-a-time"] {
            assert!(reading(id).contains("the printed 90° is a claim of its own"), "{id}");
        }
        assert_eq!(verdict("meyer.app-b.fold"), Verdict::Corrected);
    }
}
