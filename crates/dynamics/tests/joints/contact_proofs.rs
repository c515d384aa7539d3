//! Do vectors give the arms and the sliding of a pin of finite radius?

use crate::proving::holds;
use geneva_dynamics::Sign;
use geneva_dynamics::joints::contact_proofs::{ContactMoment, JointAxis, PowerLost, Sliding};

#[test]
fn the_arms_and_the_sliding_are_those_of_the_vectors() {
    for flank in Sign::BOTH {
        holds("sliding", &Sliding::Along(flank));
        holds("no parting", &Sliding::Across(flank));
        for sliding in Sign::BOTH {
            holds("follower", &ContactMoment { axis: JointAxis::Follower, flank, sliding });
            holds("driver", &ContactMoment { axis: JointAxis::Driver, flank, sliding });
            holds("power", &PowerLost { flank, sliding });
        }
    }
}
