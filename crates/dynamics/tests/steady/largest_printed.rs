//! Is the largest speed that a run prints the greatest of all its lines?

use super::samples;

#[test]
fn it_is_the_greatest_of_all_lines() {
    for engagement in samples() {
        let period = engagement.steady_state().expect("steady").period;
        for (share, engagements) in [(0.013, 12.3), (0.11, 40.0), (0.37, 7.7), (0.9, 60.0), (2.3, 80.0)] {
            let (interval, duration) = (share * period, engagements * period);
            let lines = engagement.run(interval, duration).expect("a run");
            let of_all = lines.iter().map(|line| line.speed).fold(0.0, f64::max);
            let found = engagement.largest_printed(interval, 0.0, duration).expect("a number");
            approx::assert_relative_eq!(found, of_all, max_relative = 1e-11);
            // A finer run has the shifted lines among its own.
            let fine = engagement.run(interval / 4.0, duration).expect("a run");
            let shifted = fine.iter().skip(1).step_by(4).map(|line| line.speed).fold(0.0, f64::max);
            let found = engagement.largest_printed(interval, interval / 4.0, duration).expect("a number");
            approx::assert_relative_eq!(found, shifted, max_relative = 1e-11);
        }
    }
}

#[test]
fn bad_grids_are_refused() {
    let engagement = &samples()[0];
    for (interval, first, duration) in
        [(0.0, 0.0, 1.0), (-1.0, 0.0, 1.0), (0.1, -0.1, 1.0), (0.1, 0.0, f64::NAN), (1e-9, 0.0, 1.0)]
    {
        assert!(engagement.largest_printed(interval, first, duration).is_err(), "{interval} {first} {duration}");
    }
}
