//! The characters of a formula cut up.

/// What has a meaning of its own.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    Number(f64),
    Letter(char),
    /// A command without its backslash, or a word.
    Command(String),
    Sign(char),
    Open,
    Close,
    Bar,
}

/// The characters cut up; `None` if one of them has no meaning here.
pub fn tokens(formula: &str) -> Option<Vec<Token>> {
    let characters: Vec<char> = formula.chars().collect();
    let (mut tokens, mut at) = (Vec::new(), 0);
    let run = |from: usize, of: fn(char) -> bool| -> String {
        characters[from..].iter().copied().take_while(|c| of(*c)).collect()
    };
    while let Some(&c) = characters.get(at) {
        at += 1;
        match c {
            ' ' | '&' => {}
            '0'..='9' | '.' => {
                let digits = run(at - 1, |c| c.is_ascii_digit() || c == '.');
                at += digits.len() - 1;
                tokens.push(Token::Number(digits.parse().ok()?));
            }
            '(' | '[' | '{' => tokens.push(Token::Open),
            ')' | ']' | '}' => tokens.push(Token::Close),
            '|' => tokens.push(Token::Bar),
            '+' | '-' | '/' | '^' | '_' | ';' | ',' => tokens.push(Token::Sign(c)),
            '\\' => {
                let name = run(at, |c| c.is_ascii_alphabetic());
                at += name.len();
                match name.as_str() {
                    "" => {
                        match characters.get(at)? {
                            '{' => tokens.push(Token::Open),
                            '}' => tokens.push(Token::Close),
                            '\\' => {}
                            _ => return None,
                        }
                        at += 1;
                    }
                    "left" | "right" => {
                        // A full stop is the bracket that is not there.
                        at += usize::from(characters.get(at) == Some(&'.'));
                    }
                    "quad" => {}
                    "begin" | "end" => at += run(at, |c| c != '}').chars().count() + 1,
                    "text" => {
                        let inside = run(at + 1, |c| c != '}');
                        at += inside.chars().count() + 2;
                        words(&inside, &mut tokens);
                    }
                    _ => tokens.push(Token::Command(name)),
                }
            }
            c if c.is_alphabetic() => tokens.push(Token::Letter(c)),
            _ => return None,
        }
    }
    Some(tokens)
}

/// A word, or two with a stroke between: one over the other, as units are.
fn words(inside: &str, tokens: &mut Vec<Token>) {
    for (number, word) in inside.split('/').enumerate() {
        if number > 0 {
            tokens.push(Token::Sign('/'));
        }
        tokens.push(Token::Command(word.trim().to_owned()));
    }
}
