//! What the routes of a claim rest on.

use super::{Guarded, Report};
use crate::{Check, Claim, Evidence, Kind, Stated, looked_up_by};
use std::collections::{BTreeSet, HashSet};

/// What a route rests on: its kind of evidence and the claims that it looks up.
pub type Reliance<'a> = (&'static Evidence, BTreeSet<&'a str>);

/// What the two routes of a claim rest on; of the routes to the right number, if the others follow a slip. None if there are no
/// routes.
pub fn reliance(claim: &Claim) -> Option<[Reliance<'static>; 2]> {
    let stated = Stated::right(claim.right_characters());
    Some(match &claim.check {
        Check::Number { right: Some(routes), .. } => {
            routes.each_ref().map(|route| (route.evidence, looked_up_by(|| (route.run)()).1))
        }
        Check::Number { computed, witness, .. } => {
            [computed, witness].map(|route| (route.evidence, looked_up_by(|| (route.run)()).1))
        }
        Check::Equation { first, .. } => {
            let kinds = claim.check.evidence();
            [
                (kinds[0], looked_up_by(|| (first.run)(claim.printed)).1),
                (kinds[1], looked_up_by(|| claim.witnessed()).1),
            ]
        }
        Check::Statement { first, witness, .. } => {
            [first, witness].map(|route| (route.evidence, looked_up_by(|| (route.run)(stated)).1))
        }
        Check::Missing { .. } => return None,
    })
}

/// The claims that rest on nothing but each other. What is computed is a ground to rest on. A route that only compares with other
/// places of the source is one if a claim of one of these places has a ground.
fn in_circles<'a>(routes: &[(&'a str, [Reliance<'a>; 2])]) -> Vec<&'a str> {
    let mut grounded: HashSet<&str> = HashSet::new();
    loop {
        let before = grounded.len();
        for (id, routes) in routes {
            let ground = |(evidence, ids): &Reliance<'_>| {
                *evidence != Evidence::OTHER_PLACE_IN_SOURCE
                    || ids.is_empty()
                    || ids.iter().any(|other| other != id && grounded.contains(other))
            };
            if routes.iter().any(ground) {
                grounded.insert(id);
            }
        }
        if grounded.len() == before {
            return routes.iter().map(|(id, _)| *id).filter(|id| !grounded.contains(id)).collect();
        }
    }
}

/// The claims that rest on nothing but each other.
pub fn circular_claims(guarded: Guarded) -> Report {
    let claims = guarded.ledger.claims().iter();
    let routes: Vec<_> = claims.filter_map(|claim| Some((claim.id, reliance(claim)?))).collect();
    Report::new(routes.len(), in_circles(&routes).into_iter().map(str::to_owned).collect())
}

/// The numbers of which a route looks at its own printed digits: what is computed would be rounded or cut to the printed places.
pub fn own_digits_read(guarded: Guarded) -> Report {
    let (mut tried, mut faults) = (0, Vec::new());
    for claim in guarded.ledger.claims() {
        let Check::Number { computed, witness, right, .. } = &claim.check else { continue };
        for route in [computed, witness].into_iter().chain(right.iter().flatten()) {
            tried += 1;
            if looked_up_by(|| (route.run)()).1.contains(claim.id) {
                faults.push(claim.id.to_owned());
            }
        }
    }
    Report::new(tried, faults)
}

/// The numbers of which both routes use one printed result, and that result.
pub fn shared_results(guarded: Guarded) -> Report {
    let claims = guarded.ledger.claims();
    let confirmed = |claim: &&&Claim| claim.check.evidence() == [Evidence::OTHER_PLACE_IN_SOURCE; 2];
    let mut given: HashSet<String> = claims.iter().filter(confirmed).map(|claim| claim.id.to_owned()).collect();
    given.extend(guarded.ledger.documents().iter().flat_map(|document| (document.given)()));
    let (mut tried, mut faults) = (0, Vec::new());
    for claim in claims.iter().filter(|claim| claim.kind == Kind::Value && !given.contains(claim.id)) {
        let Some([(_, one), (_, other)]) = reliance(claim) else { continue };
        tried += 1;
        let shared = one.intersection(&other).filter(|id| !given.contains(**id));
        faults.extend(shared.map(|id| format!("{}: {id}", claim.id)));
    }
    Report::new(tried, faults)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn claims_that_only_compare_are_grounded_by_one_that_is_computed() {
        let (compares, on) = (Evidence::OTHER_PLACE_IN_SOURCE, |id| BTreeSet::from([id]));
        let computed = ("computed", [(Evidence::VECTORS, on("first")), (compares, on("first"))]);
        let two = |first| {
            vec![
                ("first", [(compares, on(first)), (compares, on("second"))]),
                ("second", [(compares, on("first")), (compares, on("second"))]),
            ]
        };
        assert_eq!(in_circles(&two("second")), ["first", "second"]);
        let mut three = two("computed");
        three.push(computed);
        assert!(in_circles(&three).is_empty());
    }
}
