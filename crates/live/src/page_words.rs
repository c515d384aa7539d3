//! What the command says of a wheel, in the words of the page: each argument goes by what its control is called.

use geneva_ask::Error;
use geneva_ask::wheel::{Argument, FittingValues, arguments};
use geneva_kinematics::wheel::SizesError;

/// An error of a wheel in words, with the controls of the page in place of the command's arguments.
pub fn words(error: Error) -> String {
    with_labels(&match error {
        Error::Sizes { error, remedies } => sizes_words(&error, &remedies),
        Error::Kinematics(error) => error.to_string(),
        Error::Dynamics(error) => error.to_string(),
        Error::Argument(message) => message,
        Error::Escapement(_) | Error::Figure(_) => "another mechanism; give a wheel".to_owned(),
    })
}

/// A text of the command in which an argument such as `--play` goes by what its control on the page is called. An argument without a
/// control stays.
pub(crate) fn with_labels(text: &str) -> String {
    let (mut told, mut rest) = (String::new(), text);
    let mut follows_label = false;
    while let Some((before, behind)) = rest.split_once("--") {
        let end = behind.find(|letter: char| !letter.is_ascii_lowercase() && letter != '-').unwrap_or(behind.len());
        let (name, after) = behind.split_at(end);
        told += before;
        // As typed, one argument follows the value of another; of controls each is named.
        if follows_label
            && before.starts_with(' ')
            && before.trim().split(' ').count() == 1
            && !before.contains([',', ';'])
        {
            told += "and ";
        }
        match arguments().find(|argument| argument.name == name).and_then(label) {
            Some(label) => {
                told += &format!("“{label}”");
                follows_label = true;
                // The command's word for a length: a control has its unit beside it.
                rest = after.strip_prefix(" MM").unwrap_or(after);
            }
            None => {
                told += &format!("--{name}");
                follows_label = false;
                rest = after;
            }
        }
    }
    told + rest
}

/// What the control of an argument is called, whether it is the first way to say something or another.
pub(crate) fn label(argument: &Argument) -> Option<&'static str> {
    let label = argument.knob?.label;
    Some(label.strip_prefix("or ").unwrap_or(label))
}

/// An error about parts that don't fit in words, with the controls that make them fit.
fn sizes_words(error: &SizesError, remedies: &[FittingValues]) -> String {
    let control = |of: &FittingValues| {
        let argument = arguments().find(|argument| argument.name == of.name)?;
        let range = format!("“{}” {} {}", label(argument)?, of.range(), argument.knob?.unit);
        Some(range.trim_end().to_owned() + of.purpose())
    };
    let controls: Vec<String> = remedies.iter().filter_map(control).collect();
    let reason = capitalised(&error.reason());
    if controls.is_empty() {
        capitalised(&error.to_string())
    } else {
        format!("{reason}. Give {}", controls.join(", or "))
    }
}

/// A sentence with a capital letter at its beginning.
fn capitalised(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::{with_labels, words};
    use geneva_ask::wheel::{WheelDesign, WheelQuestion};

    #[test]
    fn a_refusal_of_sizes_is_a_sentence_with_the_labels_of_the_controls() {
        let question = WheelQuestion::parse("--stations 6 --crank-radius 62 --play 0.1 --pin-diameter 40");
        let refused = question.and_then(WheelDesign::new).map(|_| ()).map_err(words).expect_err("too thick");
        assert!(refused.starts_with("The ") && refused.contains(". Give “diameter of a pin” up to "), "{refused}");
    }

    #[test]
    fn an_argument_goes_by_the_label_of_its_control_and_what_has_none_stays() {
        let told = with_labels("--index-time 3: too long; give --play 0.3 --bore-play MM, --no-such-thing or none");
        let labels = "“time of an index” 3: too long; give “play of the slots” 0.3 and “play of the bores”, --no-such-thing or none";
        assert_eq!(told, labels);
    }
}
