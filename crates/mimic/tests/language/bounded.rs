//! Whatever is on the cards, reading and running end, and nothing panics.
//!
//! `GENEVA_FUZZ` says how many random decks are tried, and `GENEVA_FUZZ_SEED` which.

use fastrand::Rng;
use geneva_mimic::SolverParameters;
use geneva_mimic::language::{CardLayout, DECKS, DataSet, Deck, FUNCTIONS, Program, RunOptions, print_out};

/// One of several words.
fn pick<'a>(dice: &mut Rng, all: &[&'a str]) -> &'a str {
    all[dice.usize(..all.len())]
}

/// A number that the environment gives, or a usual one.
fn given(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).map_or(usual, |text| text.parse().unwrap_or_else(|_| panic!("{variable}={text}")))
}

/// How many decks are tried, and the dice for them.
fn rounds(seed: u64) -> (usize, Rng) {
    (given("GENEVA_FUZZ", 1500) as usize, Rng::with_seed(given("GENEVA_FUZZ_SEED", seed)))
}

/// Tells the deck that was tried, if it panics.
struct Tried<'a>(&'a str);

impl Drop for Tried<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("tried: {:?}", self.0);
        }
    }
}

/// Nothing is told that a terminal obeys or that is no number.
fn assert_is_plain(told: &str) {
    let obeyed = |sign: char| sign.is_control() && sign != '\n' || ('\u{202a}'..='\u{202e}').contains(&sign);
    assert!(!told.is_empty() && !told.contains(obeyed), "{told:?}");
}

/// A run that cannot take long.
fn short() -> RunOptions {
    let usual = RunOptions::default();
    RunOptions { integrator: SolverParameters { most_steps: 2000, ..usual.integrator }, ..usual }
}

/// Reads, compiles and runs a text in both layouts; how far it came.
fn go(text: &str) -> usize {
    let mut far = 0;
    let _tried = Tried(text);
    for layout in [CardLayout::Columns, CardLayout::Free, CardLayout::detect(text)] {
        let deck = match Deck::read(text, layout) {
            Ok(deck) => deck,
            Err(faults) => {
                assert!(!faults.0.is_empty());
                assert_is_plain(&faults.to_string());
                continue;
            }
        };
        far = far.max(1);
        let sets = deck.data_sets();
        let program = match Program::new(&deck) {
            Ok(program) => program,
            Err(faults) => {
                assert!(!faults.0.is_empty());
                assert_is_plain(&faults.to_string());
                continue;
            }
        };
        far = far.max(2);
        let set = sets.ok().and_then(|sets| sets.into_iter().next());
        let set =
            set.unwrap_or_else(|| DataSet(deck.parameters().iter().map(|name| ((*name).to_owned(), 1.0)).collect()));
        match program.run(&set, &short()) {
            Ok(run) => {
                far = 3;
                assert!(run.rows.iter().flatten().all(|value| value.is_finite()));
                let page = print_out(&run, "a title");
                assert_is_plain(&page);
                assert!(!page.split_whitespace().any(|word| ["NaN", "inf", "-inf"].contains(&word)), "{page}");
            }
            Err(trouble) => assert_is_plain(&trouble.to_string()),
        }
    }
    far
}

#[test]
fn fuzz_decks_with_changed_signs_are_read_or_refused() {
    let (rounds, mut dice) = rounds(0x5eed);
    let signs: Vec<char> = "ABCX019.+-*/(),= \n\t$°E\u{1b}\0\u{9b}\u{202e}".chars().collect();
    let mut far = [0; 4];
    for round in 0..rounds {
        let (_, text) = DECKS[round % DECKS.len()];
        let mut text: Vec<char> = text.chars().collect();
        for _ in 0..=dice.usize(..4) {
            let (at, sign) = (dice.usize(..text.len()), signs[dice.usize(..signs.len())]);
            match dice.usize(..3) {
                0 => text[at] = sign,
                1 => text.insert(at, sign),
                _ => drop(text.remove(at)),
            }
        }
        far[go(&text.into_iter().collect::<String>())] += 1;
    }
    println!("{rounds} decks with changed signs: refused on a card, as a whole, in the run, none: {far:?}");
    assert!(far.iter().all(|count| *count > rounds / 150), "all ends are reached: {far:?}");
}

#[test]
fn fuzz_decks_with_changed_cards_and_numbers_are_read_or_refused() {
    let (rounds, mut dice) = rounds(0xbeef);
    let numbers = ["0.", "1.", "-1.", "1.E300", "1.E-300", "1.E-9", "1.E9", "5.E-324", "T", "(1./0.)", ".5", "1.E308"];
    let mut far = [0; 4];
    for round in 0..rounds {
        let (_, text) = DECKS[round % DECKS.len()];
        let mut cards: Vec<String> = text.lines().map(str::to_owned).collect();
        for _ in 0..=dice.usize(..3) {
            let (one, other) = (dice.usize(..cards.len()), dice.usize(..cards.len()));
            match dice.usize(..5) {
                0 => cards.swap(one, other),
                1 => drop(cards.remove(one)),
                2 => cards.insert(one, cards[other].clone()),
                // Another number in place of one of a card.
                _ => {
                    let digits = |sign: char| sign.is_ascii_digit() || sign == '.';
                    let places: Vec<usize> = cards[one].match_indices(digits).map(|(at, _)| at).collect();
                    if let Some(at) = places.get(dice.usize(..places.len().max(1))) {
                        let rest = cards[one][*at..].trim_start_matches(digits).to_owned();
                        cards[one] =
                            cards[one][..*at].trim_end_matches(digits).to_owned() + pick(&mut dice, &numbers) + &rest;
                    }
                }
            }
        }
        far[go(&(cards.join("\n") + "\n"))] += 1;
    }
    println!("{rounds} decks with changed cards: refused on a card, as a whole, in the run, none: {far:?}");
    assert!(far.iter().all(|count| *count > rounds / 150), "all ends are reached: {far:?}");
}

#[test]
fn fuzz_random_cards_are_read_or_refused() {
    let (rounds, mut dice) = rounds(0xcafe);
    let names = ["A", "B", "C", "1DX", "T", "DT", "TRUE", "FALSE", "2.", ".5", "1.E-3", "0."];
    let mut far = [0; 4];
    for _ in 0..rounds {
        let mut text = String::from(" L FSW(T-.3,TRUE,FALSE,FALSE)\n");
        for name in ["A", "B", "C", "1DX"] {
            let control = if dice.usize(..6) == 0 { " L" } else { "" };
            text += &format!("{control} {name} = {}\n", expression(&mut dice, &names, 3));
        }
        text += " OUT(T,A,B,C)\n PLO(A,B,C)\n FIN(T,.5)\n END\n";
        far[go(&text)] += 1;
    }
    println!("{rounds} decks of random cards: refused on a card, as a whole, in the run, none: {far:?}");
    assert!(far[1] > rounds / 15 && far[2] > rounds / 150 && far[3] > rounds / 60, "{far:?}");
}

/// An expression of some depth, mostly well formed.
fn expression(dice: &mut Rng, names: &[&str], depth: usize) -> String {
    if depth == 0 || dice.usize(..4) == 0 {
        return pick(dice, names).to_owned();
    }
    let mut part = || expression(dice, names, depth - 1);
    let (first, second, third, fourth) = (part(), part(), part(), part());
    match dice.usize(..8) {
        0..=2 => {
            let sign = pick(dice, &["+", "-", "*", "/", "**"]);
            format!("({first}{sign}{second})")
        }
        3 => format!("-({first})"),
        4 => format!("INT({first},{second})"),
        5 => format!("TDL({first},.1)"),
        _ => {
            let function = FUNCTIONS[dice.usize(..FUNCTIONS.len())];
            let arguments = [first, second, third, fourth];
            let count = function.arguments.split(", ").filter(|letter| *letter != "...").count().min(4);
            format!("{}({})", function.name, arguments[..count].join(","))
        }
    }
}

#[test]
fn long_and_deep_texts_end() {
    let many = |card: &str| format!("{} OUT(T)\n FIN(T,1.)\n END\n", format!("{card}\n").repeat(20_000));
    for text in [
        many(" A B"),
        many("C"),
        many(" A ((((((((((((((("),
        many(" OUT(T)"),
        " A 1.\n".repeat(3),
        format!(" A {}\n END", "(".repeat(900)),
        format!(" A {}1.\n END", "-".repeat(900)),
        format!(" A {}1.\n END", "2.**".repeat(240)),
        "\u{feff}*".to_owned(),
        "\0\0\0".to_owned(),
        " PAR(A)\n OUT(A)\n FIN(T,.1)\n END\n".to_owned() + &"1.\n".repeat(200_000),
    ] {
        go(&text);
    }
}

#[test]
fn texts_that_would_fill_the_memory_are_refused() {
    let sets = |text: &str| {
        let deck = Deck::read(text, CardLayout::Free).unwrap_or_else(|faults| panic!("{faults}"));
        deck.data_sets().expect_err("too much").to_string()
    };
    let names = |from: usize| (from..from + 200).map(|number| format!("A{number}")).collect::<Vec<_>>().join(",");
    let deck = |more: &str| format!(" CON({})\n{more} OUT(T)\n FIN(T,1.)\n END\n", names(0));
    // Numbers on one card, on many cards, and in all sets together.
    let numbers = "1. ".repeat(200);
    let long = sets(&(deck("") + &"1. ".repeat(1_000_000)));
    assert!(long.contains("one number more than card 1 has names"), "{long}");
    let many = sets(&(deck(" PAR(X)\n") + &format!("{numbers}\n").repeat(3000)));
    assert!(many.contains("the data have more than 500000 numbers up to here"), "{many}");
    let repeated = sets(&(deck(" PAR(X)\n") + &numbers + "\n" + &"1.\n".repeat(5000)));
    assert!(
        repeated.contains("card 2494") && repeated.contains("the sets have more than 500000 numbers"),
        "{repeated}"
    );
    // Lines, and faults.
    let lines = Deck::read(&" A 1.\n".repeat(300_000), CardLayout::Free).expect_err("too many");
    assert!(lines.to_string().ends_with("    ^") && lines.to_string().contains("at most 110000 lines"), "{lines}");
    let words =
        Deck::read(&format!(" A 1.{}\n", "+1.*T".repeat(100)).repeat(3000), CardLayout::Free).expect_err("too many");
    assert!(words.to_string().contains("more than 910000 names, numbers and signs"), "{words}");
    let unknown =
        Deck::read(&format!(" OUT({})\n", ["B"; 400].join(",")).repeat(500), CardLayout::Free).expect_err("no B");
    assert!(unknown.0.len() < 60_000, "{}", unknown.0.len());
    let faults = Deck::read(&format!(" {}\n", "$".repeat(900)).repeat(1000), CardLayout::Free).expect_err("too many");
    assert!((50_000..51_000).contains(&faults.0.len()), "{}", faults.0.len());
}
