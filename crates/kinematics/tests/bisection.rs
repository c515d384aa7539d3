//! Is an interval halved to neighbouring numbers, in either order, and no more often than asked?

use geneva_kinematics::bisection::{bisect, bisect_times, try_bisect_times};

#[test]
fn neighbouring_numbers_are_left_in_either_order() {
    for place in [0.1, 1.0 / 3.0, 0.5, 0.9] {
        let [low, high] = bisect([0.0, 1.0], |x| x < place);
        assert!(low < place && place <= high && low.next_up() == high, "{low} {place} {high}");
        assert_eq!(bisect([1.0, 0.0], |x| x >= place), [high, low]);
    }
    assert_eq!(bisect([2.0, 2.0], |_| unreachable!("nothing lies between")), [2.0, 2.0]);
}

#[test]
fn halvings_are_counted_and_an_error_ends_them() {
    assert_eq!(bisect_times(3, [0.0, 8.0], |x| x < 2.5), [2.0, 3.0]);
    let mut asked = Vec::new();
    let ends = try_bisect_times(9, [0.0, 8.0], |x| {
        asked.push(x);
        if x < 2.0 { Err("too small") } else { Ok(false) }
    });
    assert_eq!((ends, asked), (Err("too small"), vec![4.0, 2.0, 1.0]));
}
