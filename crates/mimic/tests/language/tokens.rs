//! What is on a card: names, numbers and signs, each with its columns.

use super::runs;
use geneva_mimic::language::{CardLayout, Deck, Problem};

/// The columns of a deck and their values at the start.
#[track_caller]
fn printed(cards: &str, names: &str) -> (Vec<String>, Vec<f64>) {
    let run = runs(&format!("{cards} OUT({names})\n FIN(T,.1)\n END\n")).swap_remove(0);
    (run.columns, run.rows[0].clone())
}

#[test]
fn names_may_begin_with_a_digit_and_numbers_may_end_with_a_point() {
    let (names, _) = printed(" 2DX 1.\n 1dx 2.\n older 3.\n", "2DX,1dx,older");
    assert_eq!(names, ["2DX", "1DX", "OLDER"]);
    let cards = " A 1.\n B .0005\n C 5E3\n D 2.5E-3\n F 7\n H 4.e+2\n";
    assert_eq!(printed(cards, "A,B,C,D,F,H").1, [1.0, 0.0005, 5e3, 2.5e-3, 7.0, 4e2]);
    assert_eq!(printed(" G 4.\n X 1./G\n", "X").1, [0.25]);
    // The name E, for an exponent has no multiplication sign before it.
    assert_eq!(printed(" E 5.\n X 2.*E-3\n", "X").1, [7.0]);
    assert_eq!(printed(" A 3.\n X A**2\n", "X").1, [9.0]);
    let (names, values) = printed(" 2E 5.\n X 2E*2.\n", "2E,X");
    assert_eq!((names, values), (vec!["2E".to_owned(), "X".to_owned()], vec![5.0, 10.0]));
}

#[test]
fn what_cannot_be_read_is_told_with_its_columns() {
    let text = " A 1.\n X A+1.2.3 $ 1E999\n OUT(X)\n FIN(T,.1)\n END\n";
    let faults = Deck::read(text, CardLayout::Free).expect_err("three faults").0;
    // The expression begins in the fourth column.
    let problems: Vec<_> = faults.into_iter().map(|fault| (fault.card, fault.columns, fault.problem)).collect();
    let expected = [
        (2, 3 + 2..3 + 7, Problem::Number("1.2.3".to_owned())),
        (2, 3 + 8..3 + 9, Problem::Sign('$')),
        (2, 3 + 10..3 + 15, Problem::Number("1E999".to_owned())),
    ];
    assert_eq!(problems, expected);
}
