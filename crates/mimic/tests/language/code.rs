//! What single instructions do: switches, limits, truths, and values that are not numbers.

use super::{last, program};
use geneva_mimic::language::{DataSet, FUNCTIONS, RunOptions};

/// A deck that prints one expression.
fn printing(expression: &str) -> String {
    format!(" X {expression}\n OUT(X)\n FIN(T,.1)\n END\n")
}

/// The value of an expression without a memory.
#[track_caller]
fn value(expression: &str) -> f64 {
    last(&printing(expression))[0]
}

/// What a run says that does not print an expression.
#[track_caller]
fn refused(expression: &str) -> String {
    let run = program(&printing(expression)).run(&DataSet::default(), &RunOptions::default());
    run.expect_err(expression).to_string()
}

/// An expression without a value.
const NONE: &str = "SQR(-1.)";

/// That a value that is not a number reaches the result, where the run names it.
#[track_caller]
fn hides_nothing(expression: &str) {
    let told = refused(expression);
    assert!(told.contains("the square root of -1"), "{expression}: {told}");
}

#[test]
fn switches_and_limits_choose_and_hide_nothing() {
    let pick = |number: &str| value(&format!("FSW({number},1.,2.,3.)"));
    assert_eq!(["-1.", "0.", "-0.", "1.E-300"].map(pick), [1.0, 2.0, 2.0, 3.0]);
    hides_nothing(&format!("FSW({NONE},1.,2.,3.)"));
    // What is not taken does not matter.
    assert_eq!(value(&format!("FSW(1.,{NONE},2.,3.)")), 3.0);
    assert_eq!(["TRUE", "FALSE"].map(|truth| value(&format!("LSW({truth},5.,6.)"))), [5.0, 6.0]);
    let limit = |number: &str| value(&format!("LIM({number},-1.,2.)"));
    assert_eq!(["-3.", ".5", "7."].map(limit), [-1.0, 0.5, 2.0]);
    hides_nothing(&format!("LIM({NONE},-1.,2.)"));
    let dead = |number: &str| value(&format!("DSP({number},-1.,2.)"));
    assert_eq!(["-3.", ".5", "7."].map(dead), [-2.0, 0.0, 5.0]);
    for limits in [format!("{NONE},2."), format!("-1.,{NONE}")] {
        hides_nothing(&format!("DSP(.5,{limits})"));
    }
    hides_nothing(&format!("LSW(FSW({NONE},TRUE,TRUE,FALSE),5.,6.)"));
    for function in ["MAX", "MIN"] {
        hides_nothing(&format!("{function}({NONE},1.)"));
        hides_nothing(&format!("{function}(1.,{NONE})"));
    }
    assert_eq!(value("MIN(1.,2.)"), 1.0);
}

#[test]
fn truths_are_one_and_zero() {
    let names = [("FALSE", false), ("TRUE", true)];
    let number = |truth: bool| f64::from(u8::from(truth));
    for (a, x) in names {
        for (b, y) in names {
            let all = ["AND", "IOR", "EOR"].map(|of| value(&format!("{of}({a},{b})")));
            assert_eq!(all, [x & y, x | y, x ^ y].map(number));
        }
        assert_eq!(value(&format!("NOT({a})")), number(!x));
    }
}

#[test]
fn the_limits_of_imp_are_those_of_its_words() {
    let told = refused("IMP(0.,1.-X)");
    let between = |before: &str, after: &str| {
        let (_, rest) = told.split_once(before).expect("what stands before");
        rest.split_once(after).expect("what stands behind").0.to_owned()
    };
    let words = [
        format!("{} times", between("after ", " repetitions")),
        format!("to {}", between("agree to ", " of").to_uppercase()),
    ];
    assert_eq!(words, ["1000 times", "to 1E-12"]);
    let imp = FUNCTIONS.iter().find(|function| function.name == "IMP").expect("IMP");
    assert!(words.iter().all(|words| imp.meaning.contains(words)), "{words:?}");
}

#[test]
fn a_remainder_has_the_sign_of_the_first() {
    assert_eq!(value("MOD(7.5,2.)"), 1.5);
    assert_eq!(value("MOD(-7.5,2.)"), -1.5);
}
