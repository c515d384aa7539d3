//! Each function, tested by what its line in the table says.

use super::{last, runs};
use geneva_mimic::language::{CARDS, DataSet, FUNCTIONS, RunOptions};

/// The value of an expression without a memory.
#[track_caller]
fn value(expression: &str) -> f64 {
    last(&format!(" X {expression}\n OUT(X)\n FIN(T,.1)\n END\n"))[0]
}

/// The value of one that gives a truth.
#[track_caller]
fn truth(expression: &str) -> bool {
    value(expression) == 1.0
}

#[test]
fn plain_functions_are_those_of_mathematics() {
    for (expression, expected) in [
        ("SIN(.5)", libm::sin(0.5)),
        ("COS(.5)", libm::cos(0.5)),
        ("TAN(.5)", libm::tan(0.5)),
        ("ATN(.5)", libm::atan(0.5)),
        ("ATN(-1.,-1.)", libm::atan2(-1.0, -1.0)),
        ("SQR(2.)", 2_f64.sqrt()),
        ("EXP(-2.)", libm::exp(-2.0)),
        ("LOG(5.)", libm::log(5.0)),
        ("ABS(-3.)", 3.0),
        ("MOD(7.5,2.)", 1.5),
        ("MOD(-7.5,2.)", -1.5),
        ("MAX(1.,3.,2.)", 3.0),
        ("MIN(4.,3.,5.,3.5)", 3.0),
        ("LIM(5.,-1.,2.)", 2.0),
        ("LIM(-5.,-1.,2.)", -1.0),
        ("DSP(5.,-1.,2.)", 3.0),
        ("DSP(.5,-1.,2.)", 0.0),
        ("DSP(-5.,-1.,2.)", -4.0),
        ("FSW(-1.,10.,20.,30.)", 10.0),
        ("FSW(0.,10.,20.,30.)", 20.0),
        ("FSW(1.,10.,20.,30.)", 30.0),
        ("LSW(TRUE,1.,2.)", 1.0),
        ("LSW(FALSE,1.,2.)", 2.0),
        ("2.**.5", libm::pow(2.0, 0.5)),
    ] {
        assert_eq!(value(expression), expected, "{expression}");
    }
}

#[test]
fn logic_is_that_of_truths() {
    let names = [("FALSE", false), ("TRUE", true)];
    for (a, x) in names {
        assert_eq!(truth(&format!("NOT({a})")), !x);
        for (b, y) in names {
            assert_eq!(truth(&format!("AND({a},{b},TRUE)")), x && y);
            assert_eq!(truth(&format!("IOR({a},{b},FALSE)")), x || y);
            assert_eq!(truth(&format!("EOR({a},{b})")), x != y);
            assert_eq!(truth(&format!("EOR({a},{b},TRUE)")), x == y);
        }
    }
}

#[test]
fn an_integral_starts_where_it_is_told_also_by_another() {
    let text = " A INT(1.,B0+1.)\n B0 2.*C\n C INT(0.,5.)\n OUT(A,B0)\n FIN(T,2.)\n END\n";
    let last = last(text);
    assert!((last[0] - 13.0).abs() < 1e-12 && last[1] == 10.0, "{last:?}");
    // Several in one expression, and one in another.
    let last = super::last(" X INT(1.,0.)+INT(2.,0.)*INT(INT(6.,0.),0.)\n OUT(X)\n FIN(T,2.)\n END\n");
    assert!((last[0] - (2.0 + 4.0 * 12.0)).abs() < 1e-9, "{last:?}");
}

#[test]
fn an_integral_under_a_control_variable_stands_still_while_it_is_false() {
    let text = " RUNS FSW(T-1.,TRUE,TRUE,FALSE)\n RUNS X INT(3.,2.)\n DTMAX .001\n OUT(T,X)\n FIN(T,2.)\n END\n";
    let run = &runs(text)[0];
    assert!((run.rows[5][1] - 3.5).abs() < 1e-9);
    // The switch lies between two steps.
    assert!(run.rows.iter().skip(11).all(|row| (row[1] - 5.0).abs() < 3e-3), "{:?}", run.rows);
    assert_eq!(run.rows[12][1], run.rows[20][1]);
}

#[test]
fn an_integral_goes_on_from_where_it_stood_still() {
    let text =
        " RUNS FSW((T-1.)*(T-1.5),FALSE,TRUE,TRUE)\n RUNS X INT(3.,2.)\n DTMAX .001\n OUT(T,X)\n FIN(T,2.)\n END\n";
    let run = &runs(text)[0];
    for (time, expected) in [(0.5, 3.5), (1.2, 5.0), (1.4, 5.0), (1.7, 5.6), (2.0, 6.5)] {
        let row = &run.rows[(time * 10.0_f64 + 0.5) as usize];
        assert!((row[1] - expected).abs() < 1e-2, "{row:?}");
    }
}

#[test]
fn limited_integrals_stop_at_their_limits_and_leave_them() {
    let text = " X LIN(COS(T),0.,-.5,.5)\n DTMAX .001\n OUT(T,X)\n FIN(T,6.)\n END\n";
    let run = &runs(text)[0];
    let at = |time: f64| run.rows[(time * 10.0) as usize][1];
    assert!((at(0.4) - libm::sin(0.4)).abs() < 1e-9);
    // From sin T = ½ on it rests, and leaves where the cosine changes its sign.
    assert!((at(1.0) - 0.5).abs() < 2e-3 && (at(1.5) - 0.5).abs() < 2e-3);
    assert!((at(2.5) - (0.5 + libm::sin(2.5) - 1.0)).abs() < 3e-3);
    assert!((at(4.5) + 0.5).abs() < 2e-3);
}

#[test]
fn a_lag_follows_exponentially() {
    let text = " X FTR(1.,.5)\n Y FTR(1.,.5,3.)\n OUT(T,X,Y)\n FIN(T,2.)\n END\n";
    for row in &runs(text)[0].rows {
        let left = libm::exp(-row[0] / 0.5);
        assert!((row[1] - (1.0 - left)).abs() < 1e-4 && (row[2] - (1.0 + 2.0 * left)).abs() < 1e-4, "{row:?}");
    }
}

#[test]
fn a_delay_gives_what_was_and_nothing_before() {
    let text = " X TDL(T+1.,.35)\n DTMAX .01\n OUT(T,X)\n FIN(T,1.)\n END\n";
    for row in &runs(text)[0].rows {
        let expected = if row[0] < 0.35 { 0.0 } else { row[0] - 0.35 + 1.0 };
        assert!((row[1] - expected).abs() < 1e-9, "{row:?}");
    }
}

#[test]
fn a_hold_takes_samples_and_a_difference_quotient_the_last_two_points() {
    let text = " X ZOH(T,.5)\n DTMAX .05\n Y DER(T*T,T,7.)\n OUT(T,X,Y)\n FIN(T,2.)\n END\n";
    let run = &runs(text)[0];
    for row in &run.rows {
        let sample = libm::floor(row[0] / 0.5 + 1e-9) * 0.5;
        assert!((row[1] - sample).abs() < 1e-12, "{row:?}");
        // (t² − (t − h)²) / h = 2 t − h.
        let slope = if row[0] == 0.0 { 7.0 } else { 2.0 * row[0] - 0.05 };
        assert!((row[2] - slope).abs() < 1e-9, "{row:?}");
    }
}

#[test]
fn an_implicit_value_is_the_one_that_its_loop_gives_back() {
    let last = last(" X IMP(1.,COS(X))\n OUT(X)\n FIN(T,.1)\n END\n");
    assert!((last[0] - libm::cos(last[0])).abs() < 1e-11 && (last[0] - 0.739_085_133_215_160_6).abs() < 1e-11);
    // Kepler's equation, through another card, along the time.
    let text = " M T\n E IMP(M,NEXT)\n NEXT M+.3*S\n S SIN(E)\n OUT(M,E)\n FIN(T,3.)\n END\n";
    for row in &runs(text)[0].rows {
        assert!((row[1] - 0.3 * libm::sin(row[1]) - row[0]).abs() < 1e-11, "{row:?}");
    }
    // Nothing is found too, and what is small beside the beginning keeps its digits.
    for (half, value) in [("0.", 0.0), ("1.E-9", 2e-9)] {
        let found = super::last(&format!(" X IMP(1.,.5*X+{half})\n OUT(X)\n FIN(T,.1)\n END\n"))[0];
        assert!((found - value).abs() <= 1e-12 * value + 1e-17, "{found}");
    }
    // What comes nearer slowly is found; what does not is told with the limits.
    for (text, value) in [("IMP(0.,1.-.95*X)", 1.0 / 1.95), ("IMP(1.,1.-.97*X)", 1.0 / 1.97)] {
        let found = super::last(&format!(" X {text}\n OUT(X)\n FIN(T,.1)\n END\n"))[0];
        assert!((found - value).abs() <= 1e-12, "{found}");
    }
    let found = super::last(" X IMP(1.,COS(X+.7))\n OUT(X)\n FIN(T,.1)\n END\n")[0];
    assert!((found - libm::cos(found + 0.7)).abs() <= 1e-12, "{found}");
    let program = super::program(" X IMP(0.,1.-X)\n OUT(X)\n FIN(T,.1)\n END\n");
    let told = program.run(&DataSet::default(), &RunOptions::default()).expect_err("no value").to_string();
    let words = "after 1000 repetitions it gives back 0, and what goes in and what comes back must agree to 1e-12";
    assert!(told.contains(words) && told.contains("begin nearer"), "{told}");
    let told = super::told(" X IMP(X,COS(X))\n OUT(X)\n FIN(T,.1)\n END\n");
    assert!(told.contains("begins with a number, or a name that its loop does not change"), "{told}");
    let told = super::told(" X IMP(1.,Y)\n Y IMP(1.,X)\n OUT(X)\n FIN(T,.1)\n END\n");
    assert!(told.contains("two in one loop"), "{told}");
}

#[test]
fn no_word_stands_twice_and_each_is_told_with_its_arguments() {
    let mut names: Vec<&str> =
        FUNCTIONS.iter().map(|function| function.name).chain(CARDS.iter().map(|card| card.name)).collect();
    let all = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), all);
    for function in &FUNCTIONS {
        let letters = function.arguments.split(", ").filter(|letter| *letter != "...");
        assert!(letters.clone().count() >= 1 && !function.meaning.is_empty());
        for letter in letters.filter(|_| !function.arguments.contains("...")) {
            assert!(function.meaning.contains(letter), "{} does not say what {letter} is", function.name);
        }
    }
}
