//! The figures that a reader moves.
//!
//! A page puts a question, `wheel?stations=6&crank=-20`, and gets a drawing and numbers: of the same functions that drew and
//! tested the figures that stand still. There is no formula and no drawing here: this crate reads the arguments, calls
//! `geneva-kinematics`, `geneva-dynamics` and `geneva-figures`, and writes down what they give. It holds no number that a
//! source prints; where a figure needs one, it comes with the question.
//!
//! Compiled for WebAssembly it is what a page loads ([`exports`](self) is the interface there); compiled for the machine at
//! hand it is what the book's still figures and the tests call. Both give the same characters.

mod answer;
mod arguments;
mod control;
mod design;
mod escapement;
#[cfg(target_family = "wasm")]
mod exports;
mod mistake;
mod polygon;
mod wheel;

pub use answer::{Answer, Number, Progress, shown};
pub use arguments::Arguments;
pub use control::{Control, Drag, File, Kind, Live, Preset, Quantity};

/// All figures that a reader moves, in the order of the book.
pub const LIVE: [&Live; 5] = [&wheel::LIVE, &design::LIVE, &polygon::LIVE, &mistake::LIVE, &escapement::LIVE];

/// The figure of this name.
pub fn by_name(name: &str) -> Option<&'static Live> {
    LIVE.into_iter().find(|live| live.name == name)
}

/// What stands for a question, `name?arguments`, as text: see [`Answer::to_text`]; of `name.dxf?arguments`, the file with that
/// ending. A question that cannot be answered gets one line, `error` and what to do, with a tab between them.
pub fn answer(question: &str) -> String {
    let (name, arguments) = question.split_once('?').unwrap_or((question, ""));
    let arguments = Arguments::parse(arguments);
    let (name, ending) = name.split_once('.').map_or((name, None), |(name, ending)| (name, Some(ending)));
    let live = by_name(name).ok_or_else(|| {
        let names: Vec<_> = LIVE.iter().map(|live| live.name).collect();
        format!("no figure `{name}`: there are {}", names.join(", "))
    });
    let text = live.and_then(|live| match ending {
        Some(ending) => live.file(ending, &arguments),
        None => live.answer(&arguments).map(|answer| answer.to_text()),
    });
    text.unwrap_or_else(|message| format!("error\t{message}\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_figure_or_argument_is_named_with_those_there_are() {
        assert!(answer("weel?stations=4").starts_with("error\tno figure `weel`: there are wheel, design"));
        let text = answer("wheel?stashuns=4");
        assert!(text.starts_with("error\tno argument `stashuns`: there are crank, stations"), "{text}");
    }

    #[test]
    fn every_preset_and_every_end_of_a_control_is_answered_or_refused_with_a_reason() {
        for live in LIVE.into_iter().filter(|live| live.given.is_empty()) {
            let ends = |control: &Control| {
                [control.least, control.most, control.preset].map(|value| format!("{}={value}", control.name))
            };
            let settings = live.controls.iter().flat_map(ends);
            for setting in settings.chain(live.presets.iter().map(|preset| preset.arguments.to_owned())) {
                let text = answer(&format!("{}?{setting}", live.name));
                let reason = text.strip_prefix("error\t");
                assert!(text.contains("<svg") || reason.is_some_and(|why| why.len() > 20), "{}: {text}", live.name);
            }
        }
    }

    #[test]
    fn no_question_makes_it_panic() {
        for live in LIVE {
            for control in live.controls {
                for value in
                    ["", "x", "nan", "inf", "-inf", "1e300", "-1e300", "1e-300", "0", "-1", "2.5", "99999999999"]
                {
                    eprintln!("{}?{}={value}", live.name, control.name);
                    let text = answer(&format!("{}?{}={value}", live.name, control.name));
                    assert!(text.starts_with("error\t") || text.contains("<svg"), "{text}");
                }
            }
        }
        for odd in ["", "?", "wheel", "wheel?", "wheel?&&==&", "wheel?stations", "mistake?rows=;;;", "\u{0}"] {
            answer(odd);
        }
    }
}
