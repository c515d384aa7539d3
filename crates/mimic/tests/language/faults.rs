//! Everything that is wrong with a deck is reported at once: the card, the column, what is allowed, the nearest known name.

use super::{deck, told as faults_of};
use geneva_mimic::language::{CardLayout, Deck, Problem, Program};

/// A deck around some cards.
fn around(cards: &str) -> String {
    format!(" X INT(-X,1.)\n{cards} OUT(T,X)\n FIN(T,1.)\n END\n")
}

/// That some cards have one fault, on the second card, at this column, with these words.
#[track_caller]
fn fault(cards: &str, column: usize, words: &str) {
    let told = faults_of(&around(cards));
    let place = format!("card 2, column {column}: ");
    assert!(told.contains(&place) && told.contains(words), "{cards}\n{told}");
    assert_eq!(told.matches("column").count(), 1, "more than one fault\n{told}");
    let caret = told.lines().last().expect("a line").find('^').expect("a mark");
    assert_eq!(caret, 4 + column - 1, "{told}");
}

#[test]
fn each_fault_has_its_card_its_column_and_a_way_out() {
    for (cards, column, words) in [
        (" Y COSS(X)\n", 4, "the nearest is COS"),
        (" Y COS(XX)\n", 8, "no card defines XX; the nearest is X"),
        (" Y 2T\n", 4, "no card defines 2T; if it is a product, write 2.*T"),
        (" Y TIME\n", 4, "no card defines TIME; the nearest is T"),
        (" Y LN(X)\n", 4, "LN is not a function; the nearest is LOG"),
        (" Y SQRT(X)\n", 4, "SQRT is not a function; the nearest is SQR"),
        (" Y ATAN(X)\n", 4, "ATAN is not a function; the nearest is ATN"),
        (" A FIN(X,.1)\n", 4, "FIN is a control card, not a function; write it by itself, without a result or"),
        (" A OUT(X)\n", 4, "OUT is a control card, not a function"),
        (" HDR(T,A,B)\n", 2, "HDR has 3, but takes 2, one for each name of the OUT card of the same number"),
        (" Y SIN(X,X)\n", 4, "SIN has 2 arguments, but takes 1 argument: SIN(A)"),
        (" Y MAX(X)\n", 4, "takes 2 or more arguments: MAX(A, B, ...)"),
        (" Y 2.*(X+1.\n", 12, "expected a closing parenthesis"),
        (" Y 2.*\n", 7, "expected a name, a number or a parenthesis"),
        (" Y X*-2.\n", 6, "two signs in a row"),
        (" Y X $ 2.\n", 6, "the character '$' has no meaning"),
        (" Y 1.2.3\n", 4, "1.2.3 is not a number"),
        (" Y X 2.\n", 4, ""),
        (" COS(X)\n", 2, "expected the name of a result before the function"),
        (" PRA(X)\n", 2, "the nearest is PAR"),
        (" OUT X\n", 6, "expected an opening parenthesis"),
        (" FIN(T)\n", 2, "takes two"),
        (" SCA(1.,2.)\n", 2, "SCA belongs after a PLO card"),
        (" PLO(T)\n", 2, "takes two names or more"),
        (" OUT(2.*X)\n", 6, "expected a name"),
        (" T 2.\n", 2, "T is time"),
        (" SIN 2.\n", 2, "SIN is a function"),
        (" PAR(X0,TRUE)\n", 9, "TRUE is a truth"),
        (" X 2.\n", 2, "X is already defined on card 1"),
        (" Y NOT(X)\n", 8, "A of NOT(A) must be a truth"),
        (" Y FSW(X,TRUE,TRUE,2.)\n", 20, "D of FSW(A, B, C, D) must be a truth"),
        (" Y 2.*TRUE\n", 7, "what is computed with must be a number"),
        (" X Y 2.\n", 4, ""),
        (" Y TDL(X,X,100.)\n", 4, "the delay of a TDL must be known before the run, but X changes with it"),
        (" DT X/10.\n", 5, "DT must be known before the run, but X changes with it"),
        (" Y 2.*IMP(1.,X)\n", 7, "IMP must be alone"),
        (" A B -2.\n", 6, "may be a result under A, or the result A"),
        (" Y\n", 3, "expected an expression"),
        (" 2. X\n", 2, "expected the name of a result"),
    ] {
        if words.is_empty() {
            // A blank makes another field, or a control variable of what is none.
            assert!(!faults_of(&around(cards)).is_empty(), "{cards}");
        } else {
            fault(cards, column, words);
        }
    }
}

#[test]
fn all_faults_are_told_at_once_in_the_order_of_the_cards() {
    let told = faults_of(" Y COSS(Z)\n Y = 2.\n OUT(Q)\n B C\n C B\n");
    let told: Vec<&str> =
        told.lines().filter(|line| line.starts_with("card ") || line.starts_with("the deck")).collect();
    assert_eq!(told.len(), 5, "no END, no FIN, COSS, Y twice, Q, and nothing of the loop yet: {told:#?}");
    let told = faults_of(" Y COS(Z)\n Y = 2.\n OUT(Q)\n B C\n C B\n FIN(T,W)\n END\n");
    let cards: Vec<&str> = told.lines().filter_map(|line| line.strip_prefix("card ")).map(|line| &line[..1]).collect();
    assert_eq!(cards, ["1", "2", "3", "4", "6"], "{told}");
}

#[test]
fn loops_are_told_by_the_names_around_them() {
    let told = faults_of(" A B+1.\n B 2.*C\n C A-D\n D 1.\n E E+1.\n OUT(A,E)\n FIN(T,1.)\n END\n");
    assert!(told.contains("A → B → C → A;"), "{told}");
    assert!(told.contains("E → E;"), "{told}");
    assert!(!told.contains("D →"), "{told}");
    let told = faults_of(" X INT(Y,X0)\n Y 2.\n X0 X+1.\n OUT(X)\n FIN(T,1.)\n END\n");
    assert!(told.contains("an initial value that depends on itself: X → X0 → X"), "{told}");
    // What a memory gives closes no loop.
    for memory in ["INT(A,0.)", "TDL(A,.1)", "FTR(A,.1)", "LIN(A,0.,0.,1.)"] {
        let text = format!(" A B+1.\n B {memory}\n OUT(A)\n FIN(T,1.)\n END\n");
        assert!(Program::new(&deck(&text)).is_ok(), "{memory}");
    }
    // What a hold and a difference quotient give does.
    for none in ["ZOH(A,.1)", "DER(A,T,0.)"] {
        assert!(faults_of(&format!(" A B+1.\n B {none}\n OUT(A)\n FIN(T,1.)\n END\n")).contains("A → B → A"));
    }
}

#[test]
fn two_definitions_need_two_control_variables() {
    let text = |first: &str, second: &str| {
        format!(" L FSW(T-1.,TRUE,TRUE,FALSE)\n M NOT(L)\n {first} X 1.\n {second} X 2.\n OUT(X)\n FIN(T,2.)\n END\n")
    };
    assert!(Program::new(&deck(&text("L", "M"))).is_ok());
    for (first, second) in [("L", "L"), ("", "L"), ("L", ""), ("", "")] {
        assert!(faults_of(&text(first, second)).contains("X is already defined on card 3"), "{first} {second}");
    }
}

#[test]
fn a_deck_without_an_end_is_told_what_is_missing() {
    let missing = |text: &str| match Deck::read(text, CardLayout::Free) {
        Ok(_) => Vec::new(),
        Err(faults) => faults
            .0
            .into_iter()
            .filter_map(|fault| match fault.problem {
                Problem::Missing { card, .. } => Some(card),
                _ => None,
            })
            .collect(),
    };
    assert_eq!(missing(""), ["END", "FIN", "OUT"]);
    assert_eq!(missing(" X 2.\n OUT(X)\n FIN(T,1.)\n"), ["END"]);
    assert!(missing(" X 2.\n PLO(T,X)\n FIN(T,1.)\n END\n").is_empty());
}

#[test]
fn a_comment_that_could_be_a_card_of_a_deck_in_columns_is_noted() {
    let card = |control: &str, result: &str, expression: &str| format!("{control:9}{result:7}= {expression}\n");
    let rest = ["OUT(HOT)", "FIN(T,1.)", "END"].map(|words| card("", "", words).replace('=', " ")).concat();
    for (comment, words) in [
        (card("COLD", "HOT", "1."), "if it is to count under COLD, begin it in column 2"),
        (format!("{:18}\n", "CON(A)"), "if it is a CON card"),
    ] {
        let text = format!("{comment}{}{rest}", card("", "HOT", "2."));
        let deck = Deck::read(&text, CardLayout::Columns).unwrap_or_else(|faults| panic!("{faults}"));
        assert!(deck.notes()[0].contains(words), "{:?}", deck.notes());
    }
    // Words, and cards that were taken out, are none.
    for comment in ["COLD AND WARM ROOMS\n".to_owned(), card("C", "HOT", "1.")] {
        let text = format!("{comment}{}{rest}", card("", "HOT", "2."));
        assert_eq!(CardLayout::detect(&text.to_lowercase()), CardLayout::Columns);
        let deck = Deck::read(&text, CardLayout::Columns).unwrap_or_else(|faults| panic!("{faults}"));
        assert!(deck.notes().is_empty(), "{:?}", deck.notes());
    }
}

#[test]
fn a_comment_that_could_define_c_is_noted() {
    let text = "C      (A+1.)*2.\n A 2.\n OUT(A)\n FIN(T,1.)\n END\n";
    assert!(deck(text).notes()[0].contains("card 1 is a comment"), "{:?}", deck(text).notes());
    let text = text.replace("(A+1.)*2.", "A = NUMBER OF PINS");
    assert!(deck(&text).notes().is_empty());
    // Where the name is missed the note is told with the fault.
    for card in ["C INT(B,0.)", "C      = 2."] {
        let told = faults_of(&format!("{card}\n B C\n OUT(B)\n FIN(T,1.)\n END\n"));
        assert!(told.contains("no card defines C; card 1 is a comment, because it has a C in column 1; if"), "{told}");
    }
}

#[test]
fn a_control_card_behind_a_name_is_told_once() {
    let told = faults_of(" A FIN(T,.1)\n A OUT(T)\n END\n");
    assert!(told.matches("is a control card").count() == 2 && !told.contains("the deck has no"), "{told}");
}

#[test]
fn a_heading_has_an_out_card_and_a_word_for_each_of_its_names() {
    let cards = |heading: &str| format!(" {heading}\n OUT(T)\n HDR(ONE)\n FIN(T,1.)\n END\n");
    let told = faults_of(&cards("HDR(T)"));
    assert!(
        told.contains("card 3, column 2: HDR has 1, but takes none, because there is no OUT card with its number, 2")
    );
    // Of an OUT card that cannot be read nothing is known.
    assert_eq!(faults_of(&cards("OUT(2.*T)")).matches("card ").count(), 1, "{}", faults_of(&cards("OUT(2.*T)")));
    let text = " HDR(TIME,DISPL)\n OUT(T,T)\n HDR(ONE)\n OUT(T)\n FIN(T,1.)\n END\n";
    assert!(Program::new(&deck(text)).is_ok());
}

#[test]
fn very_many_faults_are_found_quickly_and_told_in_few_words() {
    let many = 20_000;
    let cards =
        |card: &dyn Fn(usize) -> String| (0..many).map(card).collect::<String>() + " OUT(T)\n FIN(T,1.)\n END\n";
    // An hour if each is compared with each. Unknown names, one name again and again, and again under control variables, signs, and a circle of all cards.
    for (text, faults) in [
        (cards(&|at| format!(" A{at} UNKNOWN{at}+1.\n")), many),
        (cards(&|_| " A 1.\n".to_owned()), many - 1),
        (cards(&|_| " L A 1.\n".to_owned()) + " L TRUE\n", 2 * many - 1),
        (cards(&|at| format!(" A{at} 1.$\n")), many),
        (cards(&|at| format!(" A{at} A{}\n", (at + 1) % many)), 1),
    ] {
        let told = match Deck::read(&text, CardLayout::Free).and_then(|deck| Program::new(&deck)) {
            Ok(_) => panic!("nothing is wrong"),
            Err(faults) => faults,
        };
        assert_eq!(told.0.len(), faults);
        let words = told.to_string();
        assert!(words.len() < 12_000, "{}", words.len());
        assert_eq!(words.ends_with(&format!("and {} more; {faults} in all", faults.saturating_sub(50))), faults > 50);
    }
}

#[test]
fn a_card_that_cannot_be_read_is_not_missing() {
    for (text, cards) in
        [(" OUT(T,Ä)\n FIN(T,1.)\n END\n", 1), (" OUT(T,1.)\n FIN(T)\n END\n", 2), (" PLO(T)\n FIN(T,,1.)\n END\n", 2)]
    {
        let told = faults_of(text);
        assert!(!told.contains("the deck has no") && told.matches("card ").count() == cards, "{told}");
    }
    assert!(faults_of(" X 1.\n").matches("the deck has no").count() == 3);
}

#[test]
fn signs_that_a_terminal_obeys_are_refused_on_every_card() {
    let cards = |card: &str| format!(" A 1.\n{card}\n OUT(T)\n FIN(T,1.)\n END\n");
    for sign in ['\u{1b}', '\u{7}', '\0', '\u{7f}', '\u{9b}', '\u{b}', '\u{85}', '\u{202e}', '\u{2066}', '\u{2028}'] {
        for card in [format!(" HDR({sign}[31mBAD)"), format!(" B{sign} 2."), format!(" OUT({sign}A)")] {
            let told = faults_of(&cards(&card));
            assert!(told.contains(&format!("the character {sign:?} has no meaning on a card")), "{card:?}: {told:?}");
            // The quoted card keeps its columns, and nothing reaches a terminal.
            assert!(!told.contains(sign) && told.contains('\u{fffd}'), "{told:?}");
        }
        // What cannot be read as a number is told in the same way.
        let data = deck(&format!(" PAR(A)\n OUT(A)\n FIN(T,1.)\n END\n1{sign}2\n")).data_sets();
        assert!(data.is_err_and(|faults| !faults.to_string().contains(sign)) || sign.is_whitespace(), "{sign:?}");
    }
    // Other letters are words of a heading, and a page break of a longer text is a blank.
    assert!(Deck::read(" HDR(Zeit °)\n OUT(T)\n\u{c} FIN(T,1.)\n END\n", CardLayout::Free).is_ok());
}
