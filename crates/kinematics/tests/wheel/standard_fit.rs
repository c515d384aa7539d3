//! Are the fits those of the standard's table?

use geneva_kinematics::wheel::play_of_h8_e8;

#[test]
fn the_fits_are_those_of_the_standards_table() {
    let ranges = [(3.0, 6.0), (6.0, 10.0), (10.0, 18.0), (18.0, 30.0)].map(|(over, up_to)| play_of_h8_e8(over, up_to));
    assert_eq!(ranges, [[0.02, 0.056], [0.025, 0.069], [0.032, 0.086], [0.04, 0.106]]);
}
