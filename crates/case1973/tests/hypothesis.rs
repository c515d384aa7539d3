//! Tables that the program made are explained by the program, and by no other hypothesis equally well.

use crate::tables::{LISTING, given, printed, tables};
use geneva_case1973::likelihood::Law;
use geneva_case1973::rise_times::parts;
use geneva_case1973::weighing::{Others, margins, margins_by_one_row_of_each};
use geneva_case1973::witness::densities;
use geneva_case1973::{
    Column, Constants, EXPLAINED, Hypothesis, Lag, Listing, PeakReading, Reset, Row, Score, SixPin, Weighing,
    compared_hypotheses, delays, fitting_interval,
};
use geneva_dynamics::steady::Engagement;
use geneva_kinematics::Mechanism;

fn scores() -> Vec<Score<'static>> {
    compared_hypotheses().into_iter().map(|hypothesis| Score::new(hypothesis, tables())).collect()
}

#[test]
fn what_made_the_tables_explains_every_cell_and_the_mechanisms_do_not() {
    let scores = scores();
    let of = |wanted: Hypothesis| scores.iter().find(|score| score.hypothesis == wanted).expect("compared");
    let all = EXPLAINED.len() * tables().len();
    let as_run = of(Hypothesis::AS_RUN);
    assert_eq!(as_run.fits.iter().map(|fit| fit.exact).sum::<usize>(), all);
    assert_eq!([as_run.within_one(), as_run.within_one_of(&Mechanism::ALL), as_run.cells().count()], [all; 3]);
    let ideal = of(Hypothesis::IDEAL);
    assert!(2 * ideal.within_one() < all, "{}", ideal.within_one());
    for score in &scores {
        assert_eq!(score.within_one(), score.within_one_of(&Mechanism::ALL));
        assert_eq!(score.within_one(), score.cells().filter(|cell| cell.is_within_one()).count());
        assert!(score.likelihoods().iter().zip(as_run.likelihoods()).all(|(own, best)| *own <= best));
    }
    // With four pins the reset is nearly right.
    assert!(ideal.within_one_of(&[Mechanism::FOUR_PIN]) > ideal.within_one_of(&[Mechanism::THREE_PIN]));
}

#[test]
fn every_weighing_prefers_the_reset_that_was_run() {
    let scores = scores();
    for others in [Others::AnotherReset, Others::AnotherResetOrInertias] {
        let all = margins(&scores, others).expect("compared");
        assert_eq!(all.len(), 3 * Law::ALL.len());
        assert!(all.iter().all(|margin| *margin > 10.0), "{all:?}");
        let one_row = margins_by_one_row_of_each(&scores, others).expect("compared");
        assert_eq!(one_row.len(), 4 * Law::ALL.len());
        assert!(one_row.iter().zip(&all).all(|(one_row, all)| one_row < all), "{one_row:?} {all:?}");
    }
    assert_eq!(margins(&scores[..1], Others::AnotherReset), None);
}

#[test]
fn with_one_spread_for_a_column_a_weighing_is_the_likelihood_of_the_score() {
    for score in &scores() {
        let own = Law::ALL.map(|law| Weighing::BY_COLUMN.log_likelihood(score, law));
        assert!(own.iter().zip(score.likelihoods()).all(|(own, of_score)| (own - of_score).abs() < 1e-9));
    }
}

#[test]
fn the_likelihoods_are_those_of_the_densities_summed_directly() {
    let by_table = Weighing { least_spread: 0.1, ..Weighing::BY_TABLE };
    for score in scores().iter().step_by(3) {
        for weighing in
            [Weighing { by_table: false, ..by_table }, by_table, Weighing { only: Some(7), ..Weighing::COARSE }]
        {
            for law in Law::ALL {
                let summed = densities::log_likelihood(&weighing, score, law).expect("runs");
                let found = weighing.log_likelihood(score, law);
                assert!((found - summed).abs() < 0.02, "{weighing:?} {law:?}: {found} {summed}");
            }
        }
    }
}

#[test]
fn a_run_without_end_makes_the_tables_impossible_unless_its_row_does_not_count() {
    let whole = Score::new(Hypothesis::WITHOUT_LAG, tables());
    let mut results = whole.results.clone();
    results[1] = None;
    let score = Score::from_results(whole.hypothesis, tables(), results);
    assert_eq!(score.likelihoods(), [f64::NEG_INFINITY; 2]);
    assert_eq!(score.within_one() + tables()[1].explained_by(&whole.results[1].expect("a run")), whole.within_one());
    assert!(score.fits.iter().all(|fit| fit.mean.is_finite()) && score.cells().any(|cell| cell.computed.is_nan()));
    let only = |only| Weighing { only: Some(only), ..Weighing::COARSE };
    assert_eq!(only(1).log_likelihood(&score, Law::Normal), f64::NEG_INFINITY);
    assert!(only(0).log_likelihood(&score, Law::Normal).is_finite());
}

#[test]
fn a_listed_number_and_the_same_number_given_make_the_same_run() {
    let row = &tables()[3];
    let given = Hypothesis { reset: Reset::After(LISTING.reset), lag: Lag::Of(LISTING.delay), ..Hypothesis::AS_RUN };
    assert_eq!(Hypothesis::AS_RUN.run(row), given.run(row));
    let printout = Hypothesis::AS_RUN.printout(row).expect("a run");
    assert_eq!(Hypothesis::AS_RUN.run(row), geneva_case1973::Run::read_off(&printout, LISTING.reset));
    let as_long = delays(tables()).into_iter().find(|(delay, _)| (delay / LISTING.delay - 1.0).abs() < 1e-9);
    assert_eq!(as_long.expect("a tenth").1.within_one(), EXPLAINED.len() * tables().len());
}

#[test]
fn each_choice_of_a_hypothesis_changes_the_run_of_six_pins() {
    let row = &tables()[0];
    let run = |hypothesis: Hypothesis| hypothesis.run(row).expect("a run");
    let usual = run(Hypothesis::WITHOUT_LAG);
    for changed in [
        Hypothesis { reset: Reset::OfTheMechanism, ..Hypothesis::WITHOUT_LAG },
        Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::WITHOUT_LAG },
        Hypothesis { reading: PeakReading::True, ..Hypothesis::WITHOUT_LAG },
        Hypothesis { constants: Constants::AsListed, ..Hypothesis::WITHOUT_LAG },
        Hypothesis { lag: Lag::AsListed, ..Hypothesis::WITHOUT_LAG },
    ] {
        assert_ne!(run(changed), usual, "{}", changed.brief_words());
        assert_ne!(changed.brief_words(), Hypothesis::WITHOUT_LAG.brief_words());
    }
    assert!(run(Hypothesis { reading: PeakReading::True, ..Hypothesis::WITHOUT_LAG }).peak > usual.peak);
}

#[test]
fn where_the_lines_begin_changes_the_printed_peak_and_nothing_else() {
    let row = &tables()[9];
    let run = |first_line| {
        let listing = Listing { first_line, ..LISTING };
        let given = geneva_case1973::Given { listing, ..given(row.mechanism) };
        let text = Column::ALL.map(|column| row.printed(column)).join(",");
        Hypothesis::WITHOUT_LAG.run(&Row::read(row.mechanism, &text, given).expect("a row")).expect("a run")
    };
    let (at_once, later) = (run(0.0), run(0.5 * LISTING.interval));
    assert_ne!(at_once.peak, later.peak);
    assert_eq!([at_once.minimum, at_once.period], [later.minimum, later.period]);
}

#[test]
fn what_makes_no_escapement_has_no_run() {
    // The friction is too great for a solution.
    let row = printed(Mechanism::SIX_PIN, "5", ".04", [80.0, 10.0, 0.1, 0.05]);
    for hypothesis in [Hypothesis::IDEAL, Hypothesis::AS_RUN] {
        assert_eq!((hypothesis.parameters(&row), hypothesis.run(&row)), (None, None));
    }
}

#[test]
fn the_interval_that_fits_is_the_interval_with_which_the_tables_were_made() {
    let rows: Vec<Row> = tables()
        .iter()
        .step_by(2)
        .map(|row| {
            let run = Hypothesis::WITHOUT_LAG.run(row).expect("a run");
            let [friction, torque] = [Column::Friction, Column::Torque].map(|column| row.printed(column));
            let text = format!("{friction} {torque} {} {} 0 {}", run.peak, run.minimum, run.period);
            Row::read(row.mechanism, &text, row.given).expect("a row")
        })
        .collect();
    for by_steps in [false, true] {
        assert_eq!(fitting_interval(&rows, by_steps), LISTING.interval);
    }
}

#[test]
fn a_tolerance_ten_times_finer_gives_the_same_digits() {
    let hypothesis = Hypothesis::WITHOUT_LAG;
    for row in tables() {
        let solved = |tolerance| {
            let parameters = hypothesis.parameters(row).expect("an escapement");
            Engagement::reset_after(&parameters, hypothesis.angle(row), tolerance).expect("an engagement")
        };
        let (usual, finer) = (solved(Hypothesis::TOLERANCE), solved(Hypothesis::TOLERANCE / 10.0));
        let numbers = |of: &Engagement| {
            let (steady, first) =
                (of.steady_state().expect("steady"), of.first_minimum().expect("a run").expect("a minimum"));
            [steady.peak.speed, steady.minimum.speed, steady.period, first.time].map(|number| format!("{number:.8e}"))
        };
        assert_eq!(numbers(&usual), numbers(&finer));
        let times = |tolerance: f64| {
            let rise = usual.rise(tolerance).expect("a rise");
            let until = |part| {
                [
                    rise.until_entry_speed(part),
                    rise.until_peak(part),
                    rise.until_minimum(part),
                    rise.until_mean_speed(part),
                ]
            };
            parts(0.01).map(until)
        };
        assert_eq!(times(Hypothesis::RISE_TOLERANCE), times(Hypothesis::RISE_TOLERANCE / 10.0));
    }
    // A rise is followed a thousand times as far as any definition of its time looks.
    let least = parts(0.01).into_iter().fold(f64::INFINITY, f64::min);
    assert!(Hypothesis::RISE_TOLERANCE <= least / 1000.0, "{} for {least}", Hypothesis::RISE_TOLERANCE);
}
