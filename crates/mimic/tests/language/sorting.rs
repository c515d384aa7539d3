//! The order of the statements, whatever the order of the cards, and how long it takes to find.

use super::{last, program, runs, told};
use geneva_mimic::language::{DataSet, RunOptions, Schedule};
use source::{circle, components};

/// The order, compiled here by itself: no deck may be so long.
#[allow(dead_code, unreachable_pub, reason = "a file of the library, of which the tests use a part")]
#[path = "../../src/language/sorting.rs"]
mod source;

#[test]
fn each_group_stands_behind_what_it_needs() {
    let needs = [vec![1, 2], vec![2], vec![], vec![0, 4], vec![5], vec![3], vec![6]];
    let found = components(&needs);
    assert_eq!(found, [vec![2], vec![1], vec![0], vec![3, 4, 5], vec![6]]);
    assert_eq!(circle(&found[3], &needs), [3, 4, 5]);
    assert_eq!(circle(&found[4], &needs), [6]);
}

#[test]
fn a_long_chain_is_no_deep_stack() {
    let many = 200_000;
    let needs: Vec<_> = (0..many).map(|node| if node + 1 < many { vec![node + 1] } else { vec![] }).collect();
    let found = components(&needs);
    assert!(found.len() == many && found[0] == [many - 1] && found[many - 1] == [0]);
}

#[test]
fn the_order_of_the_cards_does_not_matter() {
    let cards = [" A B+C", " B 2.*C", " C T+1.", " X INT(A,B)", " OUT(T,A,B,C,X)", " FIN(T,1.)"];
    let run = |order: &[usize]| {
        let cards: String = order.iter().map(|at| format!("{}\n", cards[*at])).collect();
        runs(&format!("{cards} END\n"))[0].rows.clone()
    };
    let usual = run(&[0, 1, 2, 3, 4, 5]);
    for order in [[5, 4, 3, 2, 1, 0], [2, 0, 4, 1, 5, 3], [3, 1, 0, 5, 2, 4]] {
        assert_eq!(run(&order), usual);
    }
    assert_eq!(usual[0], [0.0, 3.0, 2.0, 1.0, 2.0]);
}

#[test]
fn what_is_known_before_a_run_is_computed_once() {
    let program = program(" PAR(P)\n A 2.*P\n B A+T\n C SIN(A)\n X INT(A,0.)\n OUT(B,C)\n FIN(T,1.)\n END\n");
    let when: Vec<_> = program.execution_order().iter().map(|of| (of.result.as_str(), of.when, of.is_dead)).collect();
    let expected = [
        ("A", Schedule::Once, false),
        ("B", Schedule::Always, false),
        ("C", Schedule::Once, false),
        ("X", Schedule::Always, true),
    ];
    assert_eq!(when, expected);
    assert_eq!(program.size(), (1, 1));
}

#[test]
fn a_statement_whose_control_is_false_keeps_its_last_value() {
    let text = " EARLY FSW(T-.45,TRUE,FALSE,FALSE)\n LATE NOT(EARLY)\n EARLY X T\n LATE Y T\n Z X+Y\n OUT(T,X,Y,Z)\n \
                FIN(T,1.)\n END\n";
    for row in &runs(text)[0].rows {
        let early = row[0] < 0.45;
        // Kept is what was at the last point that was kept, not what was tried; and that is just before Y begins.
        let expected = if early { row[0] } else { 0.45 };
        assert!((expected - 1e-8..=expected).contains(&row[1]), "{row:?}");
        assert_eq!(row[2], if early { 0.0 } else { row[0] }, "{row:?}");
        assert_eq!(row[3], row[1] + row[2]);
    }
}

#[test]
fn refused_steps_leave_no_trace_in_what_is_kept() {
    // The integrand jumps: steps over the jump are refused, and some of them reach beyond it.
    let text = " LATE FSW(T-.55,FALSE,TRUE,TRUE)\n EARLY NOT(LATE)\n LATE SEEN 1.\n EARLY V 1.\n LATE V 100.\n \
                X INT(V,0.)\n OUT(T,X,SEEN)\n FIN(T,1.)\n END\n";
    let run = &runs(text)[0];
    assert!(run.work.rejected > 0);
    assert_eq!(run.rows[5][2], 0.0);
    assert_eq!(run.rows[6][2], 1.0);
    assert!((run.rows[10][1] - (0.55 + 45.0)).abs() < 1e-3, "{:?}", run.rows[10]);
}

/// A chain of statements, last first, with an integral at its end.
fn chain(statements: usize) -> String {
    let mut text = String::new();
    for number in (1..statements).rev() {
        text += &format!(" S{number} S{}*.999+SIN(S{})\n", number - 1, number - 1);
    }
    text + " S0 INT(1.,0.)\n OUT(T,S1)\n DT 1.\n FIN(T,2.)\n END\n"
}

#[test]
fn many_statements_take_no_more_than_their_share() {
    // Some seconds if each is looked at a few times; an hour if each is compared with each.
    let (text, many) = (chain(100_000), 100_000);
    assert_eq!(program(&text).execution_order().len(), many + 1);
    assert_eq!(last(&chain(2000)).len(), 2);
}

#[test]
fn there_are_bounds_to_integrals_and_delays() {
    let run = |card: &str, many: usize| {
        let cards: String = (0..many).map(|k| format!(" X{k} {card}\n")).collect();
        let program = program(&format!("{cards} OUT(T,X0)\n FIN(T,.2)\n END\n"));
        program.run(&DataSet::default(), &RunOptions::default()).map(|run| run.rows[2][1])
    };
    for (card, most) in [("INT(1.,0.)", 1024), ("TDL(T,.1)", 256)] {
        assert!((run(card, most).expect("as many as there may be") - 0.2).abs() < 0.11, "{card}");
        let told = run(card, most + 1).expect_err("one more").to_string();
        assert!(told.contains(&format!("at most {most} can be run together")), "{told}");
    }
}

#[test]
fn many_integrals_run_together() {
    // Heat in a rod of 200 pieces, warm at one end.
    let mut text = " C 50.\n Q0 1.\n".to_owned();
    for k in 1..=200 {
        let next = if k == 200 { "0.".to_owned() } else { format!("Q{}", k + 1) };
        text += &format!(" Q{k} INT(C*(Q{}-2.*Q{k}+{next}),0.)\n", k - 1);
    }
    let run = &runs(&format!("{text} OUT(T,Q1,Q100)\n DT 1.\n DTMAX .005\n FIN(T,3.)\n END\n"))[0];
    let [warm, cool] = [run.rows[3][1], run.rows[3][2]];
    assert!((0.9..1.0).contains(&warm) && (0.0..0.01).contains(&cool), "{warm} {cool}");
}

#[test]
fn an_integral_rests_while_its_control_is_false_and_may_switch_itself_off() {
    // A tank is filled until it is full; a lag follows while it may.
    for fill in [" MORE FULL INT(1.,.05)\n", " FULL INT(LSW(MORE,1.,0.),.05)\n"] {
        let text = format!(
            " MORE FSW(FULL-.25,TRUE,FALSE,FALSE)\n{fill} EARLY FSW(T-.45,TRUE,FALSE,FALSE)\n EARLY Y FTR(T,.5,0.)\n \
             OUT(T,FULL,Y)\n FIN(T,1.)\n END\n"
        );
        let rows = &runs(&text)[0].rows;
        let lag = |time: f64| time - 0.5 + 0.5 * libm::exp(-2.0 * time);
        for row in rows {
            assert!((row[1] - (row[0] + 0.05).min(0.25)).abs() < 1e-4, "{fill} {row:?}");
            assert!((row[2] - lag(row[0].min(0.45))).abs() < 1e-4, "{fill} {row:?}");
        }
    }
}

#[test]
fn a_loop_is_told_once_and_leaves_no_other_fault() {
    let told = told(" UP FSW(X-.25,TRUE,FALSE,FALSE)\n UP X 2.*T\n Y NOT(UP)\n OUT(T,X,Y)\n FIN(T,1.)\n END\n");
    assert!(told.contains("an algebraic loop: UP → X → UP") && told.matches("card ").count() == 1, "{told}");
}
