//! In which unit a source prints which quantity: what a claim says that it is decides its unit.

use crate::{Claim, Kind, Work};

/// Words for a quantity, and its unit, as the source prints it.
type Unit = (&'static str, &'static str);

/// For each source, the units of its quantities. The words that come first in a claim's meaning count, and the longer ones of two
/// that begin in the same place.
const UNITS: &[(Work, &[Unit])] = &[
    (
        Work::Pin,
        &[
            ("angular velocity of the driver", "rad/s"),
            ("angular speed of the wheel", "rad/s"),
            ("speed of the", "mm/s"),
            ("angle", "°"),
            ("square of OP, in squared crank radii", "R^{2}"),
            ("OP in crank radii", "R"),
            ("distance", "mm"),
            ("crank radius", "mm"),
        ],
    ),
    (
        Work::QuickReturn,
        &[
            ("speed of the crank", "r.p.m."),
            ("angular velocity", "rad/s"),
            ("speed of the", "m/s"),
            ("angular acceleration", "rad/s^2"),
            ("acceleration", "m/s^2"),
            ("angle", "°"),
            ("distance", ""),
            ("radius", ""),
        ],
    ),
    (
        Work::Jazar2003,
        &[
            ("speed of the driver", "rpm"),
            ("angular velocity", "rad/s"),
            ("angular acceleration", "rad/s²"),
            ("angle", "°"),
            ("half the angle", "°"),
            ("duration", "s"),
            ("advances per second", "per second"),
            ("number of stations", "stations"),
            ("dwelling part of the cycle", ""),
            ("crank angle at which the wheel is fastest", ""),
            ("sin α", ""),
            ("γ of the", ""),
            ("magnitude of the acceleration of the six-station wheel, divided by", ""),
        ],
    ),
    (
        Work::Meyer1973,
        &[
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
    ),
    (
        Work::Wild,
        &[
            ("angular speed of the wheel", "rad/s"),
            ("speed of the pin", "mm/s"),
            ("acceleration of the pin", "mm/s²"),
            ("angle", "°"),
            ("how far the driver turns", "°"),
            ("radius", "mm"),
            ("distance", "mm"),
            ("rest of a wheel", "%"),
            ("part of the cycle", "%"),
            ("part of the time", ""),
            ("rest over move", ""),
            ("time of a move over the time of a rest", ""),
            ("teeth", ""),
        ],
    ),
];

/// The unit of what a claim of a number is about; none if nothing is said of it.
fn expected(claim: &Claim) -> Option<Unit> {
    let (_, units) = UNITS.iter().find(|(work, _)| *work == claim.work)?;
    let found = units.iter().filter_map(|unit| Some((claim.meaning.find(unit.0)?, unit)));
    found.min_by_key(|(at, (words, _))| (*at, usize::MAX - words.len())).map(|(_, unit)| *unit)
}

/// What is wrong with the unit of a claim, if something is.
pub fn fault(claim: &Claim) -> Option<String> {
    let (words, unit) = expected(claim).filter(|_| claim.kind == Kind::Value)?;
    let named = |unit: &str| if unit.is_empty() { "no unit".to_owned() } else { format!("the unit {unit}") };
    (claim.unit != unit)
        .then(|| format!("it has {}, but the source prints \"{words}\" with {}", named(claim.unit), named(unit)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{claims, judge};
    use std::collections::HashSet;

    #[test]
    fn another_unit_of_a_number_is_noticed() {
        let mut used = HashSet::new();
        for claim in claims().iter().filter(|claim| claim.kind == Kind::Value) {
            let (words, unit) = expected(claim).unwrap_or_else(|| panic!("{}: what is its unit?", claim.id));
            used.insert((claim.work, words));
            for other in ["m", "mm", "rad", "rad/s", "1/s", "m/s", "%", ""].into_iter().filter(|other| *other != unit) {
                let other = judge(Box::leak(Box::new(Claim { unit: other, ..claim.clone() })));
                assert!(!other.holds(), "{}: {}", claim.id, other.claim.unit);
            }
        }
        for (work, units) in UNITS {
            for (words, _) in *units {
                assert!(used.contains(&(*work, *words)), "{work}: no number is \"{words}\"");
            }
        }
    }
}
