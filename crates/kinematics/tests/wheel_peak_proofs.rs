//! Is it proven where the root of the quadratic for the peak is?

use geneva_kinematics::prove;
use geneva_kinematics::wheel_peak_proofs::{BelowOne, InsideTheEngagement};

#[test]
fn the_root_lies_inside_the_engagement() {
    for proof in [prove(&BelowOne), prove(&InsideTheEngagement)] {
        println!("{}", proof.expect("an identity"));
    }
}
