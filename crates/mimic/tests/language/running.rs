//! Running: when a run ends, what is printed, how steps are set, and what stops it.

use super::{deck, own, program, runs};
use geneva_mimic::language::{
    DataSet, DeckRun, Plot, Program, RememberedPoints, RunOptions, Trouble, line_plot, print_out,
};
use geneva_mimic::{MinStepPolicy, SolverParameters, StepSolution};

#[track_caller]
fn trouble(text: &str) -> String {
    trouble_by(&RunOptions::default(), text)
}

fn trouble_by(choices: &RunOptions, text: &str) -> String {
    let deck = deck(text);
    let sets = deck.data_sets().unwrap_or_else(|faults| panic!("{faults}"));
    Program::new(&deck)
        .unwrap_or_else(|faults| panic!("{faults}"))
        .runs(&sets, choices)
        .expect_err("trouble")
        .to_string()
}

fn times(run: &DeckRun) -> Vec<f64> {
    run.rows.iter().map(|row| row[0]).collect()
}

#[test]
fn a_run_ends_at_the_first_fin_and_prints_every_dt() {
    let run = &runs(" DT .25\n OUT(T)\n FIN(T,9.)\n FIN(T,1.1)\n END\n")[0];
    assert_eq!(times(run), [0.0, 0.25, 0.5, 0.75, 1.0, 1.1]);
    let run = &runs(" OUT(T)\n FIN(T,.3)\n END\n")[0];
    assert_eq!(times(run), [0.0, 0.1, 0.2, 0.300_000_000_000_000_04]);
}

#[test]
fn a_value_can_end_a_run_between_two_printed_points() {
    // A stone falls for √2 units of time.
    let text = " V INT(-1.,0.)\n FALLEN 1.-X\n X INT(V,1.)\n DT .5\n DTMAX .001\n OUT(T,X)\n FIN(FALLEN,1.)\n FIN(T,50.)\n END\n";
    let run = &runs(text)[0];
    assert_eq!(times(run)[..3], [0.0, 0.5, 1.0]);
    assert!(run.rows.len() == 4 && (run.rows[3][0] - 2_f64.sqrt()).abs() <= 1e-3, "{:?}", run.rows);
    // A limit that moves, and no time: T reaches half of what grows as fast.
    let text = " LIMIT INT(.5,1.)\n OUT(T,LIMIT)\n FIN(T,LIMIT)\n END\n";
    let last = runs(text)[0].rows.last().expect("a row").clone();
    assert!((last[0] - 2.0).abs() < 0.11 && last[0] >= last[1], "{last:?}");
}

#[test]
fn steps_are_no_longer_than_dtmax_and_no_shorter_than_dtmin() {
    let steps = |cards: &str| {
        let text = format!(" X INT(-X,1.)\n{cards} OUT(T,X)\n FIN(T,1.)\n END\n");
        runs(&text)[0].work
    };
    assert_eq!(steps(" DT .5\n").accepted, steps(" DT .5\n DTMAX DT\n").accepted);
    assert_eq!(steps(" DT .5\n DTMAX DT/50.\n").accepted, 100);
    let forced = steps(" DT .5\n DTMIN .25\n");
    assert!(forced.forced > 0 && forced.accepted <= 5, "{forced:?}");
}

#[test]
fn a_tolerance_costs_steps_and_gives_accuracy() {
    let (program, set) = own("oscillator", &[1.0, 0.0, 1.0, 0.0, 1.0]);
    let usual = RunOptions::default();
    let error = |relative_tolerance: f64, kept: StepSolution| {
        let integrator = SolverParameters { relative_tolerance, kept, ..usual.integrator };
        let run = program.run(&set, &RunOptions { integrator, ..usual }).unwrap_or_else(|trouble| panic!("{trouble}"));
        let error = run.rows.iter().map(|row| (row[1] - libm::cos(row[0])).abs()).fold(0.0, f64::max);
        (error, run.work.accepted)
    };
    let [rough, fine] = [1e-5, 1e-9].map(|tolerance| error(tolerance, StepSolution::TwoHalfSteps));
    assert!(rough.0 > 10.0 * fine.0 && rough.1 < fine.1, "{rough:?} {fine:?}");
    assert!(error(1e-5, StepSolution::Extrapolated).0 < rough.0 && error(1e-5, StepSolution::FullStep).0 > rough.0);
}

#[test]
fn what_stops_a_run_is_told_with_card_and_time() {
    for (text, words) in [
        // From the start on, at a point, on the way, in a chain of cards, and only where it is taken.
        (" A 0.\n X INT(1./A,0.)\n OUT(X)\n FIN(T,1.)\n END\n", "at T = 0: card 2 (X INT(1./A,0.)): 1 divided by zero"),
        (" Y SIN(T)/T\n OUT(Y)\n FIN(T,1.)\n END\n", "at T = 0: card 1 (Y SIN(T)/T): 0 divided by zero"),
        (" Y 1./(T-.5)\n Z Y+1.\n OUT(Z)\n FIN(T,1.)\n END\n", "at T = 0.5: card 1 (Y 1./(T-.5)): 1 divided by zero"),
        (" Y SQR(.55-T)\n OUT(T,Y)\n FIN(T,1.)\n END\n", "card 1 (Y SQR(.55-T)): the square root of -0.0"),
        (" Y LOG(-1.-T)\n OUT(Y)\n FIN(T,1.)\n END\n", "the logarithm of -1; give other numbers"),
        (" Y FSW(T-1.,0.,0.,1.)/T\n OUT(Y)\n FIN(T,1.)\n END\n", "at T = 0: card 1"),
        (" X INT(X**2,1.)\n OUT(X)\n FIN(T,2.)\n END\n", "card 1 (X INT(X**2,1.))"),
        (" X INT(1.,1./B)\n B 0.\n OUT(X)\n FIN(T,1.)\n END\n", "at T = 0: card 1 (X INT(1.,1./B)): 1 divided by zero"),
        (" X FTR(1.,B)\n B 0.\n OUT(X)\n FIN(T,1.)\n END\n", "card 1 (X FTR(1.,B))"),
    ] {
        let told = trouble(text);
        assert!(told.contains(words), "{text}\n{told}");
    }
    // Of two definitions it is the one that counts at the time.
    let text = " L FSW(T-.3,TRUE,TRUE,FALSE)\n M NOT(L)\n L Y 1./(T-.2)\n M Y 2.\n OUT(Y)\n FIN(T,1.)\n END\n";
    assert!(trouble(text).contains("at T = 0.2: card 3 (L Y 1./(T-.2)): 1 divided by zero"), "{}", trouble(text));
    // A branch that is not taken may be what it likes.
    let text = " Y FSW(T,0.,0.,SIN(T)/T)\n OUT(Y)\n FIN(T,1.)\n END\n";
    assert!(runs(text)[0].rows.iter().all(|row| row[0].is_finite()));
}

#[test]
fn a_step_below_dtmin_stops_a_run_that_is_to_be_stopped() {
    let text = " SIGN FSW(T-.512345,-1.,1.,1.)\n SLOW INT(1.,0.)\n X INT(1000.*SIGN,0.)\n OUT(T,X)\n FIN(T,1.)\n END\n";
    let program = program(text);
    let usual = RunOptions::default();
    let kept = program.run(&DataSet::default(), &usual).unwrap_or_else(|trouble| panic!("{trouble}"));
    assert_eq!(kept.work.forced, 0, "it can be passed");
    let text = text.replace(" OUT", " DTMIN .01\n OUT");
    let program = super::program(&text);
    let kept = program.run(&DataSet::default(), &usual).unwrap_or_else(|trouble| panic!("{trouble}"));
    assert!(kept.work.forced > 0 && print_out(&kept, "").contains("missed the tolerance"));
    let integrator = SolverParameters { at_smallest_step: MinStepPolicy::Stop, ..usual.integrator };
    let told = program.run(&DataSet::default(), &RunOptions { integrator, ..usual }).expect_err("it stops");
    let Trouble::StepTooSmall { time, card, name, .. } = &told else { panic!("{told}") };
    assert!((0.5..0.512_345).contains(time) && *card == 3 && name == "X", "{told}");
}

#[test]
fn what_cannot_be_run_is_refused() {
    for (text, words) in [
        (" DT -1.\n OUT(T)\n FIN(T,1.)\n END\n", "DT is -1: it must be above zero"),
        (
            " DTMIN 1.\n DTMAX .5\n OUT(T)\n FIN(T,1.)\n END\n",
            "DTMIN is 1: it must not be above DTMAX, which is 0.5; give a smaller DTMIN or a longer DTMAX",
        ),
        (
            " DTMAX 1.E-12\n OUT(T)\n FIN(T,1.)\n END\n",
            "must not be above DTMAX, which is 1e-12; without a card DTMIN is DT over 2 to the power 30: add a DTMIN card",
        ),
        (
            " X INT(1.,0.)\n DTMAX 1.E-9\n OUT(T)\n FIN(T,1.)\n END\n",
            "DTMAX is 1e-9: to the end at T = 1 there would be more than 10000000 steps, which is the most; give a \
             longer DTMAX or an earlier FIN",
        ),
        (
            " X INT(-1.E12*(X-COS(T)),1.)\n OUT(T,X)\n FIN(T,1.)\n END\n",
            "missed the tolerance and could not be shorter than DTMIN: give a smaller DTMIN",
        ),
        (
            " DTMIN 5.4\n OUT(T)\n FIN(T,1.)\n END\n",
            "DTMIN is 5.4: it must not be above DTMAX, which is 0.1, the value of DT, without a card; give a smaller DTMIN or",
        ),
        (
            " X 1.E300*(T+1.E10)\n OUT(X)\n FIN(T,1.)\n END\n",
            "1e300 times 10000000000 is too large; give other numbers on the cards or as data",
        ),
        (" OUT(T)\n FIN(T,-1.E-300)\n END\n", "the run would end at T = -1e-300; it must be above zero"),
        (" OUT(T)\n FIN(T,0.)\n END\n", "card 2 (FIN(T,0.)): the run would end at T = 0"),
        (" OUT(T)\n FIN(T,1.E9)\n END\n", "at most 1000000 DT away (numbers in a row: 1); give a longer DT"),
        (" X TDL(T,-1.)\n OUT(X)\n FIN(T,1.)\n END\n", "card 1 (X TDL(T,-1.)): delay -1.0"),
        (" X INT(1.,0.)\n OUT(X)\n FIN(-X,1.)\n END\n", "at T = 100000: FIN is not reached after 1000000 printed rows"),
    ] {
        let told = trouble(text);
        assert!(told.contains(words), "{text}\n{told}");
    }
    // The usual number of steps is in a case above; a small one is reached sooner.
    let usual = RunOptions::default();
    let few = RunOptions { integrator: SolverParameters { most_steps: 50_000, ..usual.integrator }, ..usual };
    let told = trouble_by(&few, " X INT(-X,1.)\n DTMAX 1.E-9\n OUT(T,X)\n FIN(-X,1.)\n END\n");
    let words = "FIN is not reached after 50000 steps; most are as long as DTMAX, 1e-9, allows; give a larger";
    assert!(told.contains(words), "{told}");
    let program = program(" PAR(A)\n OUT(A)\n FIN(T,1.)\n END\n");
    let run = |set: &[(&str, f64)]| {
        let set = DataSet(set.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect());
        program.run(&set, &RunOptions::default()).map(|run| run.rows[0][0])
    };
    assert_eq!(run(&[("A", 2.0)]), Ok(2.0));
    // The later number counts.
    assert_eq!(run(&[("A", 2.0), ("A", 3.0)]), Ok(3.0));
    assert_eq!(run(&[]), Err(Trouble::Missing("A".to_owned())));
    assert_eq!(run(&[("A", 2.0), ("B", 3.0)]), Err(Trouble::Unknown("B".to_owned())));
}

#[test]
fn all_runs_together_have_a_bound_too() {
    let text = " PAR(A)\n X A\n DT 1.E-6\n OUT(T,X,X,X)\n PLO(T,X)\n FIN(T,.25)\n END\n1.\n2.\n3.\n";
    let told = trouble(text);
    for words in [
        "data set 2: the first 2 data sets need 3500126 numbers to print, with the headings counted as 8 rows, but all together can have at most 3000000",
        "give fewer data sets, a longer DT, fewer names",
    ] {
        assert!(told.contains(words), "{told}");
    }
    // A run by itself has fewer rows the more it prints.
    let wide = text.replace("OUT(T,X,X,X)", &format!("OUT(T{})", ",X".repeat(96)));
    assert!(trouble(&wide).contains("at most 30000 DT away (numbers in a row: 100)"), "{}", trouble(&wide));
    let open = wide.replace("FIN(T", "FIN(X-X+T");
    assert!(trouble(&open).contains("FIN is not reached after 30000 printed rows"), "{}", trouble(&open));
}

#[test]
fn the_print_out_has_headings_numbers_and_plots() {
    let text = " PAR(A)\n X INT(A,0.)\n Y -X\n DT 1.\n HDR(TIME,PLACE)\n OUT(T,X)\n OUT(Y)\n PLO(T,X,Y)\n SCA(1.,.1,.1)\n \
                ZER(0.,-5.,-5.)\n FIN(T,3.)\n END\n 2.\n";
    let run = &runs(text)[0];
    let page = print_out(run, "a title");
    let lines: Vec<&str> = page.lines().collect();
    assert_eq!(lines[..2], ["a title", "  A = 2"]);
    assert_eq!(lines[3].split_whitespace().collect::<Vec<_>>(), ["TIME", "PLACE"]);
    assert_eq!(lines[8].split_whitespace().collect::<Vec<_>>(), ["3.00000E+00", "6.00000E+00"]);
    assert_eq!(lines[10].trim(), "Y");
    // One line for each step of T; X and Y cross in the middle of −5 to 5, and X leaves the paper at its edge.
    let plot: Vec<&str> = lines.iter().copied().filter(|line| line.ends_with('|') && !line.contains("--")).collect();
    assert_eq!(plot.len(), 4);
    let inside = |line: &str| line.split('|').nth(1).expect("a frame").to_owned();
    assert_eq!(inside(plot[0]).find('+'), Some(50));
    assert_eq!((inside(plot[1]).find('*'), inside(plot[1]).find('+')), (Some(70), Some(30)));
    assert_eq!((inside(plot[3]).find('*'), inside(plot[3]).find('+')), (Some(100), Some(0)));
    // Without scales the curve fills the paper.
    let text = text.replace(" SCA(1.,.1,.1)\n", "").replace(" ZER(0.,-5.,-5.)\n", "");
    let page = print_out(&runs(&text)[0], "");
    let plot: Vec<&str> = page.lines().filter(|line| line.ends_with('|') && !line.contains("--")).collect();
    assert_eq!((plot.len(), inside(plot[50]).find('*'), inside(plot[50]).find('+')), (51, Some(100), Some(0)));
}

#[test]
fn equal_decks_give_equal_bits_and_runs_do_not_touch_each_other() {
    let (program, _) = own("escapement", &[4.0, -0.75, 0.25, 0.125, 6e-5, 2e-5]);
    let names = ["SLOTS", "START", "MU", "TORQUE", "IFOL", "IDRV"];
    let set = |mu: f64| {
        DataSet(names.iter().map(|name| (*name).to_owned()).zip([4.0, -0.75, mu, 0.125, 6e-5, 2e-5]).collect())
    };
    let together = program.runs(&[set(0.25), set(0.125), set(0.25)], &RunOptions::default()).expect("three runs");
    assert_eq!(together[0], together[2]);
    assert_ne!(together[0].rows, together[1].rows);
    assert_eq!(Ok(&together[1]), program.run(&set(0.125), &RunOptions::default()).as_ref());
    let error = program.runs(&[set(0.25), set(f64::NAN)], &RunOptions::default()).expect_err("no number");
    assert!(error.to_string().starts_with("data set 2: at T = 0: "), "{error}");
}

#[test]
fn an_end_that_is_reached_at_the_start_leaves_the_first_row() {
    let run = &runs(" A 1.\n OUT(T,A)\n FIN(A,-1.)\n END\n")[0];
    assert_eq!((&run.rows, run.work.accepted), (&vec![vec![0.0, 1.0]], 0));
}

#[test]
fn steps_longer_than_a_delay_are_counted_and_told() {
    let text =
        |delay: &str, more: &str| format!(" A TDL(T,{delay})\n B TDL(T,.3)\n{more} OUT(T,A)\n FIN(T,.4)\n END\n");
    let run = &runs(&text(".05", ""))[0];
    let delayed: Vec<f64> = run.rows.iter().map(|row| row[1]).collect();
    assert_eq!((delayed, run.longer_than_delay), (vec![0.0, 0.0, 0.1, 0.2, 0.300_000_000_000_000_04], 4));
    assert!(print_out(run, "").contains("4 of 4 steps were longer than the delay of a TDL"));
    for text in [text(".05", " DTMAX .05\n"), text(".1", ""), text(".15", "")] {
        let run = &runs(&text)[0];
        assert_eq!(run.longer_than_delay, 0, "{text}");
        assert!(!print_out(run, "").contains("TDL"));
    }
}

#[test]
fn a_delay_holds_as_many_steps_as_there_are() {
    let run = &runs(" A TDL(T*T,1.)\n DT 1.\n DTMAX .00002\n OUT(T,A)\n FIN(T,2.)\n END\n")[0];
    assert!(run.work.accepted >= 100_000 && (run.rows[2][1] - 1.0).abs() < 1e-9, "{:?}", run.rows);
}

#[test]
fn headings_do_not_run_together() {
    let text = " HDR(AVERYLONGHEADING,ANOTHERLONGHEADING)\n OUT(T,T)\n FIN(T,.1)\n END\n";
    let page = print_out(&runs(text)[0], "");
    let lines: Vec<&str> = page.lines().collect();
    assert_eq!(lines[2], " AVERYLONGHEADING ANOTHERLONGHEADING");
    assert!(lines[2..].iter().all(|line| line.is_empty() || line.len() == lines[2].len()), "{page}");
}

#[test]
fn small_integrals_are_followed_as_large_ones() {
    for size in ["1.", "1.E-9", "1.E-30"] {
        let text = format!(" V INT(-X,0.)\n X INT(V,{size})\n DT 5.\n OUT(T,X)\n FIN(T,50.)\n END\n");
        for row in &runs(&text)[0].rows {
            let exact =
                libm::cos(row[0]) * size.replace("1.E", "1e").trim_end_matches('.').parse::<f64>().expect("a size");
            assert!((row[1] - exact).abs() < 1e-3 * runs(&text)[0].rows[0][1], "{row:?} {exact}");
        }
    }
    // Beside a large one a small one is followed to the floor that is asked for.
    let program = program(" V INT(-X,0.)\n X INT(V,1.E-9)\n Y INT(1.,1.)\n DT 5.\n OUT(T,X)\n FIN(T,50.)\n END\n");
    let error = |absolute_floor: f64| {
        let usual = RunOptions::default();
        let integrator = SolverParameters { absolute_floor, ..usual.integrator };
        let run = program.run(&DataSet::default(), &RunOptions { integrator, ..usual }).expect("it runs");
        run.rows.iter().map(|row| (row[1] - 1e-9 * libm::cos(row[0])).abs()).fold(0.0, f64::max)
    };
    assert!(error(1e-3) > 1e-10 && error(1e-9) < 1e-12, "{} {}", error(1e-3), error(1e-9));
}

#[test]
fn a_truth_or_a_limit_that_is_no_number_stops_the_run() {
    for (cards, card) in [
        (" FLAG FSW(SQR(T-5.),TRUE,FALSE,FALSE)\n Y LSW(FLAG,1.,2.)\n X INT(Y,0.)\n", 1),
        (" FLAG FSW(SQR(T-5.),TRUE,FALSE,FALSE)\n FLAG X INT(1.,0.)\n", 1),
        (" FLAG FSW(SQR(T-5.),TRUE,FALSE,FALSE)\n FLAG X 1.\n", 1),
        (" X LIN(1.,0.,-1.,SQR(T-5.))\n", 1),
        (" X DSP(3.,0.,SQR(T-5.))\n", 1),
        (" X T\n FIN(T,SQR(X-5.))\n", 2),
    ] {
        let told = trouble(&format!("{cards} OUT(T,X)\n FIN(T,9.)\n END\n"));
        assert!(told.contains(&format!("card {card} ")) && told.contains("the square root of -5"), "{cards}{told}");
    }
}

#[test]
fn what_grows_without_bound_is_named() {
    let told = trouble(" X INT(X*X,1.)\n OUT(T,X)\n FIN(T,2.)\n END\n");
    assert!(told.contains("card 1 (X INT(X*X,1.)): ") && !told.contains("1.0 and 1.0"), "{told}");
    assert!(told.contains("is too large") || told.contains("X has grown without bound"), "{told}");
    let told = trouble(" X FTR(T,0.)\n OUT(T,X)\n FIN(T,2.)\n END\n");
    assert!(told.contains("X has a time constant of zero"), "{told}");
}

#[test]
fn a_deck_with_many_delays_is_held_to_a_number_of_steps_and_of_values() {
    let deck = |delays: usize, dtmax: &str, more: &str| {
        let cards: String = (0..delays).map(|number| format!(" Q{number} TDL(X,1000.{more})\n")).collect();
        format!(" DT 1.\n DTMAX {dtmax}\n X INT(1.,0.)\n{cards} OUT(T,X)\n FIN(T,10.)\n END\n")
    };
    // More steps than so many delays may have are refused before the run.
    let told = trouble(&deck(256, "1.E-5", ""));
    for words in ["DTMAX is 1e-5", "more than 389105 steps", "with 1 integral and 256 TDL; give a longer DTMAX or an"] {
        assert!(told.contains(words), "{told}");
    }
    // As many as are allowed need more room than there is.
    let told = trouble(&deck(256, "5.E-5", ""));
    for words in ["256 TDL, the longest of which goes back by 1000, need room for more than 5000000 values", "fewer or"]
    {
        assert!(told.contains(words), "{told}");
    }
    let program = program(&deck(20, "5.E-5", ",100."));
    let few = RunOptions { remembered: RememberedPoints::AsAsked, ..RunOptions::default() };
    assert!(program.run(&DataSet::default(), &few).is_ok_and(|run| run.work.accepted >= 200_000));
}

#[test]
fn runs_at_the_same_time_share_the_memory() {
    let usual = RunOptions::default();
    let shared = RunOptions { at_once: 1000, ..usual };
    let set = DataSet::default();
    let small = program(" A TDL(T*T,1.)\n OUT(T,A)\n FIN(T,2.)\n END\n");
    assert_eq!(small.run(&set, &shared), small.run(&set, &usual));
    let long = program(" A TDL(T*T,1.)\n DT 1.\n DTMAX .00002\n OUT(T,A)\n FIN(T,2.)\n END\n");
    let told = long.run(&set, &shared).expect_err("no room").to_string();
    assert!(told.contains("need room for more than 5000 values"), "{told}");
    let rows = program(" A 1.\n DT 1.E-3\n OUT(T,A)\n FIN(T,10.)\n END\n");
    assert!(rows.run(&set, &shared).is_err_and(|trouble| trouble.to_string().contains("at most 1500 DT away")));
    assert!(rows.run(&set, &usual).is_ok());
}

#[test]
fn a_plot_of_many_points_is_drawn_at_once() {
    let points: Vec<Vec<f64>> = (0..200_000).map(|number| vec![f64::from(number), 1.0]).collect();
    let plot = Plot { names: vec!["T".to_owned(), "X".to_owned()], scale: None, zero: None };
    // Each point used to look at all others: who waits for minutes here has that fault again.
    assert!(line_plot(&plot, &points).lines().count() > 50);
}
