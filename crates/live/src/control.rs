//! What a reader may move in a figure, and what is told.

use crate::answer::{LiveQuantity, LiveReply};
use crate::arguments::{LiveArguments, computable, quoted};
use crate::turned::{ToleranceRow, TurnedParts};

/// Angles in degrees that can be typed: beyond, too little is left of a fraction of one.
pub(crate) const TURNS: [f64; 2] = [-1e6, 1e6];

/// How the parts of a figure stand with its settings.
pub(crate) type TurnParts = fn(&Settings) -> Result<TurnedParts, String>;

/// A figure that a reader moves.
#[derive(Debug)]
pub struct Live {
    /// Its one name, in lower-case letters.
    pub name: &'static str,
    /// The module that answers it in a page, by the name of its file.
    pub module: &'static str,
    /// The name of the drawing with which it stands still.
    pub figure: &'static str,
    /// What to try, and what to see.
    pub hint: &'static str,
    /// What may be moved.
    pub controls: &'static [Control],
    /// Settings worth a look.
    pub presets: &'static [Preset],
    /// Arguments that come with the page: data of a source.
    pub given: &'static [&'static str],
    /// What is told beside the drawing, in its order.
    pub quantities: &'static [LiveQuantity],
    /// What is told apart from it, in its order: what has no room in the drawing.
    pub others: &'static [LiveQuantity],
    /// What the pointer moves in the drawing.
    pub drag: Option<PointerDrag>,
    /// Files that can be taken away.
    pub files: &'static [LiveFile],
    /// How its parts stand, if they turn without a new drawing.
    pub turned: Option<TurnParts>,
    /// By how much sizes may be wrong, if it tells.
    pub tolerances: Option<ToleranceTable>,
    /// The number that is the time from beat to beat in milliseconds, if the figure can be heard.
    pub beat: Option<&'static str>,
    /// Draws it.
    pub draw: fn(&Settings) -> Result<LiveReply, String>,
}

/// One thing that may be moved.
#[derive(Clone, Copy, Debug)]
pub struct Control {
    /// Its name among the arguments.
    pub name: &'static str,
    /// What it is called.
    pub label: &'static str,
    /// Its unit; nothing for a pure number.
    pub unit: &'static str,
    /// The least value of its slider, in its unit.
    pub least: f64,
    /// The greatest value of its slider, in its unit.
    pub most: f64,
    /// The least and the greatest value that can be typed or can come from an address, in its unit; it holds the slider's.
    pub range: [f64; 2],
    /// The step of its slider, in its unit.
    pub step: f64,
    /// Where it stands at first, unless the page gives another value or it follows the others.
    pub preset: f64,
    /// How it is moved.
    pub kind: ControlKind,
    /// On which side it is, if those of the other sides of its group follow from it.
    pub side: Option<ControlSide>,
    /// The fold in which it is, by its title, if the figure has many controls. Those of a fold follow one another.
    pub fold: Option<&'static str>,
}

impl Control {
    /// A slider from the least value to the greatest, and a box for the number.
    pub const fn slider(
        name: &'static str,
        label: &'static str,
        unit: &'static str,
        [least, most]: [f64; 2],
        step: f64,
        preset: f64,
    ) -> Self {
        Self {
            name,
            label,
            unit,
            least,
            most,
            range: [least, most],
            step,
            preset,
            kind: ControlKind::Slider,
            side: None,
            fold: None,
        }
    }

    /// The control with a wider range for numbers that are typed, in its unit.
    pub const fn with_typed_range(self, range: [f64; 2]) -> Self {
        Self { range, ..self }
    }

    /// A slider and a box whose value follows from the other controls until the reader moves it: the answer has the value.
    pub const fn following(
        name: &'static str,
        label: &'static str,
        unit: &'static str,
        ends: [f64; 2],
        step: f64,
    ) -> Self {
        Self { kind: ControlKind::Follower, ..Self::slider(name, label, unit, ends, step, ends[0]) }
    }

    /// The control with a button that moves it by itself: by so much in a second, over and over.
    pub const fn playing(self, rate: f64) -> Self {
        Self { kind: ControlKind::Player(rate), ..self }
    }

    /// A box for a number, without a slider.
    pub const fn number(
        name: &'static str,
        label: &'static str,
        unit: &'static str,
        range: [f64; 2],
        preset: f64,
    ) -> Self {
        Self { kind: ControlKind::Number, ..Self::slider(name, label, unit, range, range[1] - range[0], preset) }
    }

    /// The control on one of the sides of a group, of which the reader moves one and the answer tells the others.
    pub const fn on_side(self, group: &'static str, number: usize) -> Self {
        Self { side: Some(ControlSide { group, number }), ..self }
    }

    /// The control in the fold with this title.
    pub const fn in_fold(self, title: &'static str) -> Self {
        Self { fold: Some(title), ..self }
    }

    /// One of several, by its number from 0.
    pub const fn choice(
        name: &'static str,
        label: &'static str,
        choices: &'static [&'static str],
        preset: usize,
    ) -> Self {
        let most = (choices.len() - 1) as f64;
        let kind = ControlKind::Choice(choices);
        Self {
            name,
            label,
            unit: "",
            least: 0.0,
            most,
            range: [0.0, most],
            step: 1.0,
            preset: preset as f64,
            kind,
            side: None,
            fold: None,
        }
    }

    /// A number within the range.
    ///
    /// # Errors
    ///
    /// Names the control, the text, and the range.
    pub fn read(&self, text: &str) -> Result<f64, String> {
        let [least, most] = self.range;
        let value = computable(text).filter(|value| (least..=most).contains(value));
        value.ok_or_else(|| self.refusal(text))
    }

    /// What is wrong with a text that is no value of the control: the text, and what the control may be.
    fn refusal(&self, text: &str) -> String {
        if let ControlKind::Choice(choices) = self.kind {
            let choices = choices.iter().enumerate().map(|(number, choice)| format!("{number} ({choice})"));
            let choices = choices.collect::<Vec<_>>().join(", ");
            return format!("{} `{}`: none of the choices; give one of {choices}", self.name, quoted(text.trim()));
        }
        let [least, most] = self.range;
        let gap = if self.unit.is_empty() || self.unit == "°" { "" } else { " " };
        let typed = quoted(text.trim());
        if text.trim().replace('−', "-").parse().is_ok_and(f64::is_finite) {
            format!("{} {typed}{gap}{}: give {least} to {most}", self.label, self.unit)
        } else {
            format!("{} `{typed}`: not a number; give {least} to {most}, with a point before decimals", self.label)
        }
    }
}

/// How the value of a control is moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ControlKind {
    /// By a slider and a box for the number.
    Slider,
    /// By a box for the number alone.
    Number,
    /// By a slider and a box, and by itself: by so much in a second, over and over.
    Player(f64),
    /// By a slider and a box, and by the figure until the reader moves it.
    Follower,
    /// One of several, by its number from 0.
    Choice(&'static [&'static str]),
}

/// One of several ways to say the same, such as by the crank's angle or by the lever's: what is moved last counts, and the rest
/// of its group follows. At first the side with the number 0 counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ControlSide {
    /// What the sides say.
    pub group: &'static str,
    /// Its number; several controls may be on one side.
    pub number: usize,
}

/// A setting worth a look.
#[derive(Debug)]
pub struct Preset {
    /// What it is called.
    pub name: &'static str,
    /// Its arguments; those left out keep their values, and `*2` makes a value twice what it is.
    pub arguments: &'static str,
    /// Whether those left out are as at first instead.
    pub is_whole: bool,
}

impl Preset {
    /// A setting of some controls; the others keep their values.
    pub const fn new(name: &'static str, arguments: &'static str) -> Self {
        Self { name, arguments, is_whole: false }
    }

    /// A setting of all controls; those that are not named are as at first.
    pub const fn whole(name: &'static str, arguments: &'static str) -> Self {
        Self { name, arguments, is_whole: true }
    }
}

/// An angle of the drawing that the pointer sets: that of the pointer about the circle of the pins.
#[derive(Clone, Copy, Debug)]
pub struct PointerDrag {
    /// Which control.
    pub control: &'static str,
    /// Its value in degrees where the pointer is at the right of the circle's centre.
    pub at_right: f64,
    /// 1 if it grows counter-clockwise, −1 if clockwise.
    pub sense: f64,
}

/// A file that is made of a setting. `geneva-live-files` makes it, in a module that a page loads for the first one.
#[derive(Clone, Copy, Debug)]
pub struct LiveFile {
    /// Its name with its ending.
    pub name: &'static str,
    /// What it is.
    pub label: &'static str,
}

/// A table of how wrong sizes may be, among the controls by which a reader makes them wrong.
#[derive(Debug)]
pub struct ToleranceTable {
    /// The fold in which it is, by its title.
    pub fold: &'static str,
    /// Its rows.
    pub rows: fn(&Settings) -> Result<Vec<ToleranceRow>, String>,
}

/// The arguments of a figure, each known to it.
#[derive(Clone, Debug)]
pub struct Settings<'a> {
    controls: &'a [Control],
    arguments: &'a LiveArguments,
    is_in_motion: bool,
}

impl Live {
    /// The figure with these arguments; those left out are as at first.
    ///
    /// # Errors
    ///
    /// What is wrong with the arguments, and what to give.
    pub fn answer(&self, arguments: &LiveArguments) -> Result<LiveReply, String> {
        self.answer_to(&self.settings(arguments)?)
    }

    /// The figure while a reader moves it: what takes long and has no part in the drawing is missing, and the answer has `progress`.
    ///
    /// # Errors
    ///
    /// As for [`answer`](Self::answer).
    pub fn answer_in_motion(&self, arguments: &LiveArguments) -> Result<LiveReply, String> {
        self.answer_to(&Settings { is_in_motion: true, ..self.settings(arguments)? })
    }

    fn answer_to(&self, settings: &Settings) -> Result<LiveReply, String> {
        let answer = (self.draw)(settings)?;
        let is_shown = |text: &str| !text.contains("NaN") && !text.contains("inf");
        if answer.numbers.iter().all(|number| is_shown(&number.text)) && !answer.figure.svg.contains("NaN") {
            Ok(answer)
        } else {
            Err("these numbers are too large or too small to compute with: give others".to_owned())
        }
    }

    /// How the parts of the figure stand with these arguments; none if none of them turns without a new drawing.
    ///
    /// # Errors
    ///
    /// As for [`answer`](Self::answer).
    pub fn turned_parts(&self, arguments: &LiveArguments) -> Result<Option<TurnedParts>, String> {
        self.turned.map(|turned| turned(&self.settings(arguments)?)).transpose()
    }

    /// By how much sizes may be wrong with these arguments; nothing if the figure doesn't tell.
    ///
    /// # Errors
    ///
    /// As for [`answer`](Self::answer).
    pub fn tolerance_rows(&self, arguments: &LiveArguments) -> Result<Vec<ToleranceRow>, String> {
        self.tolerances.as_ref().map_or(Ok(Vec::new()), |table| (table.rows)(&self.settings(arguments)?))
    }

    fn settings<'a>(&'a self, arguments: &'a LiveArguments) -> Result<Settings<'a>, String> {
        Settings::new(self.controls, self.given, arguments)
    }
}

impl<'a> Settings<'a> {
    /// The arguments of a figure with these controls, to which its page gives what has these names.
    pub fn new(controls: &'a [Control], given: &[&str], arguments: &'a LiveArguments) -> Result<Self, String> {
        let names = || controls.iter().map(|control| control.name).chain(given.iter().copied());
        if let Some(unknown) = arguments.names().find(|name| names().all(|known| known != *name)) {
            let names = names().collect::<Vec<_>>().join(", ");
            return Err(format!("no argument `{}`: there are {names}", quoted(unknown)));
        }
        Ok(Self { controls, arguments, is_in_motion: false })
    }

    /// Whether the next setting is expected at once: what takes long can wait until one stays.
    pub fn is_in_motion(&self) -> bool {
        self.is_in_motion
    }

    /// The value of a control, in its unit.
    pub fn value(&self, name: &str) -> Result<f64, String> {
        let control = self.control(name)?;
        self.arguments.text(name).map_or(Ok(control.preset), |text| control.read(text))
    }

    /// The value of a control that may follow others, in its unit; none until it is moved, or with an empty value.
    pub fn value_if_moved(&self, name: &str) -> Result<Option<f64>, String> {
        let control = self.control(name)?;
        self.arguments.text(name).filter(|text| !text.is_empty()).map(|text| control.read(text)).transpose()
    }

    /// A count.
    pub fn count(&self, name: &str) -> Result<u32, String> {
        let value = self.value(name)?;
        if value == f64::from(value as u32) {
            Ok(value as u32)
        } else {
            let control = self.control(name)?;
            if matches!(control.kind, ControlKind::Choice(_)) {
                return Err(control.refusal(&value.to_string()));
            }
            let [least, most] = control.range;
            Err(format!("{} {value}: not an integer; give an integer from {least} to {most}", control.label))
        }
    }

    /// The number of a choice.
    pub fn choice(&self, name: &str) -> Result<usize, String> {
        Ok(self.count(name)? as usize)
    }

    /// What came with the page.
    pub fn arguments(&self) -> &LiveArguments {
        self.arguments
    }

    fn control(&self, name: &str) -> Result<&Control, String> {
        self.controls.iter().find(|control| control.name == name).ok_or_else(|| format!("no control `{name}`"))
    }
}
