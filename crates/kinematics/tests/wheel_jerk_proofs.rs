//! Is it proven that no jerk exceeds the one on the line of centres?

use geneva_kinematics::prove;
use geneva_kinematics::wheel_jerk_proofs::JerkBound;

#[test]
fn the_jerk_never_exceeds_that_on_the_line_of_centres() {
    for plus in [true, false] {
        println!("{}", prove(&JerkBound { plus }).expect("an identity"));
    }
}
