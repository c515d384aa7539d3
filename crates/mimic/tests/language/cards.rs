//! Fields, comments, numbers and data: how a text becomes a deck.

use super::{deck, last, runs, told};
use geneva_mimic::language::{CardLayout, Deck, Program, listing_in};

#[test]
fn a_card_means_the_same_in_columns_and_without() {
    let in_columns = "\
* A COMMENT
/ AND ITS SECOND LINE
                  CON(A)
         B        2.*A
 L       C      = 3.
         L        FSW(T-.5,TRUE,TRUE,FALSE)
                  OUT(B,C)
                  FIN(T,1.)
                  END
<EOR>
 7.
<EOF>
";
    assert_eq!(CardLayout::detect(in_columns), CardLayout::Columns);
    let free: String = in_columns
        .lines()
        .map(|line| {
            let comment = line.starts_with(['*', '/']);
            format!("{}{}\n", if comment { "" } else { " " }, line.split_whitespace().collect::<Vec<_>>().join(" "))
        })
        .collect();
    assert_eq!(CardLayout::detect(&free), CardLayout::Free);
    let run = |text: &str| {
        let deck = Deck::read(text, CardLayout::detect(text)).unwrap_or_else(|faults| panic!("{faults}"));
        let sets = deck.data_sets().unwrap_or_else(|faults| panic!("{faults}"));
        let program = Program::new(&deck).unwrap_or_else(|faults| panic!("{faults}"));
        program.run(&sets[0], &Default::default()).unwrap_or_else(|trouble| panic!("{trouble}"))
    };
    assert_eq!(run(in_columns).rows, run(&free).rows);
    assert_eq!(run(&free).rows[10], [14.0, 3.0]);
}

#[test]
fn what_crosses_a_column_is_told() {
    let crossing =
        "         RESULT12345 = 2.\n                  OUT(T)\n                  FIN(T,1.)\n                  END\n";
    assert_eq!(CardLayout::detect(crossing), CardLayout::Free);
    let faults = Deck::read(crossing, CardLayout::Columns).expect_err("it crosses").to_string();
    assert!(faults.contains("in a deck with columns"), "{faults}");
    let early = "  X = 2.\n                  OUT(X)\n                  FIN(T,1.)\n                  END\n";
    let faults = Deck::read(early, CardLayout::Columns).expect_err("no result").to_string();
    assert!(faults.contains("expected"), "{faults}");
}

#[test]
fn fields_without_columns_are_told_by_what_stands_behind_them() {
    let frame = |card: &str| format!(" A 3.\n B 2.\n L FSW(T,TRUE,TRUE,FALSE)\n {card}\n OUT(X)\n FIN(T,1.)\n END\n");
    for (card, value) in [
        ("X A", 3.0),
        ("X A+B", 5.0),
        ("X A - B", 1.0),
        ("X A*B", 6.0),
        ("X -A", -3.0),
        ("X (A)", 3.0),
        ("X = A -B", 1.0),
        ("X=A-B", 1.0),
        ("X ABS (A)", 3.0),
        ("X .5", 0.5),
        ("X -A*B", -6.0),
        ("x = a", 3.0),
    ] {
        assert_eq!(last(&frame(card)), [value], "{card}");
    }
    for card in ["L X A", "L X = A", "L X (A)", "L X 3.", "L X ABS(A)-0."] {
        let run = &runs(&frame(card))[0];
        assert!(run.rows.iter().all(|row| row == &[3.0]), "{card}: kept from T = 0 on");
    }
}

#[test]
fn fortran_s_order_of_signs_holds() {
    for (expression, value) in [
        ("-2.**2", -4.0),
        ("2.**3.**2.", 512.0),
        ("8./2.*4.", 16.0),
        ("2.-3.-4.", -5.0),
        ("-2.*3.+1.", -5.0),
        ("2.*(3.+4.)", 14.0),
        ("1.E2+.5E-1", 100.05),
        ("+3.", 3.0),
        ("((((5.))))", 5.0),
        ("6/4", 1.5),
    ] {
        let text = format!(" X {expression}\n OUT(X)\n FIN(T,.1)\n END\n");
        assert_eq!(last(&text), [value], "{expression}");
    }
}

#[test]
fn names_of_six_signs_may_begin_with_a_digit() {
    assert_eq!(last(" 1DX 2.\n 2DX 3.*1DX\n OLDER 2DX-1DX\n OUT(OLDER)\n FIN(T,.1)\n END\n"), [4.0]);
}

#[test]
fn a_c_in_column_1_is_a_comment_only_before_a_blank() {
    let text = "C THIS IS A COMMENT\nCON(C)\nX=C*2.\nOUT(X)\nFIN(T,.1)\nEND\n4.\n";
    assert_eq!(last(text), [8.0]);
}

#[test]
fn data_are_read_by_the_names_of_their_cards() {
    let text = " PAR(A,B)\n CON(K)\n PAR(C)\n X K+10.*A+100.*B+1000.*C\n OUT(X)\n FIN(T,.1)\n END\n";
    // A card of names begins a new data card; numbers may go on over several.
    let data = "<EOR>\n* the constant\n 1.\n 2., 3.\n 4.\n 5.\n6.\n 7\n<EOF>\n";
    let found: Vec<f64> = runs(&format!("{text}{data}")).iter().map(|run| run.rows[0][0]).collect();
    assert_eq!(found, [4321.0, 7651.0]);
    let refused = |data: &str| {
        let deck = deck(&format!("{text}{data}"));
        deck.data_sets().expect_err("data that do not fit").to_string()
    };
    assert!(refused("").contains("no number is left for K"), "{}", refused(""));
    assert!(refused("1.\n2. 3.\n4.\n5.\n").contains("no number is left for B"));
    assert!(refused("1. 2.\n").contains("card 8, column 4: one number more than card 2 has names"));
    assert!(refused("1.\n2. X\n").contains("card 9, column 4: not a number"));
    assert!(refused("1.\n2. X\n").contains("not a number, and everything after END is data"));
    assert!(refused("1.\n2.,,3.\n").contains("card 9, column 4: no number before this comma; write one"));
    assert!(refused("1.\n,2.,3.\n").contains("card 9, column 1: no number before this comma"));
    let twice = deck(" OUT(T)\n FIN(T,.1)\n END\n END\n").data_sets().expect_err("no data").to_string();
    assert!(twice.contains("card 4, column 2: not a number, and everything after END is data"), "{twice}");
    let one = deck(" PAR(A)\n OUT(A)\n FIN(T,.1)\n END\n").data_sets().expect_err("no data").to_string();
    assert!(one.contains("the card has 1 name, and"), "{one}");
    let none = deck(" CON(K)\n X K\n OUT(X)\n FIN(T,.1)\n END\n 1.\n 2.\n").data_sets().expect_err("left over");
    assert!(none.to_string().contains("no card asks for these numbers"), "{none}");
}

#[test]
fn a_number_can_be_given_to_a_name_in_place_of_its_card() {
    let text = " A 2.\n L FSW(T,TRUE,TRUE,FALSE)\n L B 3.\n PAR(C)\n OUT(A,B,C,DT)\n FIN(T,.1)\n END\n 1.\n";
    let mut deck = deck(text);
    assert!(deck.set("A", 5.0) && deck.set("DT", 0.05));
    assert!(!deck.set("B", 5.0) && !deck.set("C", 5.0) && !deck.set("NONE", 5.0));
    let program = Program::new(&deck).unwrap_or_else(|faults| panic!("{faults}"));
    let sets = deck.data_sets().unwrap_or_else(|faults| panic!("{faults}"));
    let run = program.run(&sets[0], &Default::default()).unwrap_or_else(|trouble| panic!("{trouble}"));
    assert_eq!(run.rows, vec![vec![5.0, 3.0, 1.0, 0.05]; 3]);
}

#[test]
fn a_listing_is_taken_out_of_a_longer_text() {
    let text = "Some text with PAR(1) in it.\n```\n  PAR(A)\n  X A\n  OUT(X)\n  FIN(T,.1)\n  END\n```\nMore text.\n";
    let listing = listing_in(text).expect("a listing");
    assert!(listing.starts_with("  PAR(A)") && listing.trim_end().ends_with("END"));
    assert!(deck(listing).parameters() == ["A"]);
    assert_eq!(listing_in("PAR(A)\nno end"), None);
    assert_eq!(listing_in("END\nPAR(A)\n"), None);
}

#[test]
fn a_card_that_is_too_long_or_too_deep_is_told() {
    let long = format!(" X {}1.\n OUT(X)\n FIN(T,1.)\n END\n", "1.+".repeat(400));
    assert!(told(&long).contains("at most 1000 are read"));
    let deep = format!(" X {}1.{}\n OUT(X)\n FIN(T,1.)\n END\n", "(".repeat(100), ")".repeat(100));
    assert!(told(&deep).contains("more than 64 deep"));
}

#[test]
fn faults_of_a_file_of_data_name_it_and_its_line() {
    let refused = |data: &str| {
        let deck = deck(" PAR(A,B,C)\n X A+B+C\n OUT(X)\n FIN(T,.1)\n END\n 1. 2. 3.\n").with_data("some.cards", data);
        deck.data_sets().expect_err("data that do not fit").to_string()
    };
    let told = refused("* three\n1. 2. 3.\n4. 5. 6. 7.\n");
    assert!(
        told.starts_with("some.cards, line 3, column 10: one number more than card 1 of the deck has names"),
        "{told}"
    );
    assert!(told.ends_with("\n    4. 5. 6. 7.\n             ^^"), "{told}");
    let told = refused("1. 2. 3.\n4. 5.\n");
    assert!(
        told.starts_with("some.cards, line 2, column 6: no number is left for C: card 1 of the deck has 3"),
        "{told}"
    );
    assert!(told.ends_with("\n    4. 5.\n         ^"), "{told}");
    assert!(refused("").starts_with("some.cards, line 1, column 1: no number is left for A"));
    assert!(refused("1. X 3.\n").starts_with("some.cards, line 1, column 4: not a number;"));
}
