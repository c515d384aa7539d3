//! How many steps a run may take, and how many all runs of a deck may take together.

use super::program;
use geneva_mimic::language::{DataSet, DeckRun, DeckRuns, Program, RunOptions};
use geneva_mimic::{SolverParameters, SolverStats};

/// Most steps of all runs, counted once for each integral and each delay.
const MOST_OF_ALL: u64 = 300_000_000;

#[test]
fn all_runs_have_so_many_steps_together() {
    // Two integrals and two delays: a step counts four times.
    let program = program(" X INT(1.,0.)\n Y INT(X,0.)\n A TDL(X,.1)\n B TDL(X,.2)\n OUT(T)\n FIN(T,.1)\n END\n");
    let made = program.run(&DataSet::default(), &RunOptions::default()).expect("it runs");
    let half = SolverStats { accepted: MOST_OF_ALL / 16, rejected: MOST_OF_ALL / 16, ..made.work };
    let mut runs = DeckRuns::default();
    for _ in 0..2 {
        runs.add(&program, Ok(DeckRun { work: half, ..made.clone() })).expect("as many as can be");
    }
    let told = runs.add(&program, Ok(made)).expect_err("more than can be").to_string();
    assert!(
        told.contains("the first 3 data sets need 30000000") && told.contains("steps of integrals and delays,"),
        "{told}"
    );
    assert_eq!(runs.into_inner().len(), 2);
}

#[test]
fn many_integrals_have_fewer_steps() {
    let with = |integrals: i32, cards: &str| -> Program {
        let all: String = (0..integrals).map(|number| format!(" X{number} INT(1.,0.)\n")).collect();
        program(&format!("{all}{cards} OUT(T)\n END\n"))
    };
    let usual = RunOptions::default();
    let few = RunOptions { integrator: SolverParameters { most_steps: 7, ..usual.integrator }, ..usual };
    let refused = |program: &Program, choices: &RunOptions| {
        program.run(&DataSet::default(), choices).expect_err("too many steps").to_string()
    };
    for (integrals, most) in [(2, 10_000_000), (10, 10_000_000), (100, 1_000_000), (1000, 100_000)] {
        // A hundred million steps to an end that is known before, and an end that never comes.
        let (known, unknown) =
            (with(integrals, " DT 1.\n DTMAX 1.E-8\n FIN(T,1.)\n"), with(integrals, " FIN(-T,1.)\n"));
        let told = refused(&known, &usual);
        assert!(told.contains(&format!("more than {most} steps, which is the most")), "{told}");
        // As many as any may have, or why not.
        assert_eq!(told.contains(&format!("the most with {integrals} integrals")), most < 10_000_000, "{told}");
        let told = refused(&known, &few);
        assert!(told.contains("more than 7 steps, which is the most;"), "{told}");
        // A run whose end is not known begins, and stops at the bound.
        let told = refused(&unknown, &few);
        assert!(told.contains("FIN is not reached after 7 printed rows"), "{told}");
    }
}
