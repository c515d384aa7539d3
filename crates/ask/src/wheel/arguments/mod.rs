//! The one table of what can be said of a wheel: an option at the command line and a control on the page for each row.
//!
//! The rows stand by what they are about, in the order of a designer's questions: what the wheel must do, how large it is, how
//! its parts fit, how they are mounted, what they carry, and what is not as drawn.

mod fit;
mod friction;
mod instants;
mod load;
mod mounting;
mod need;
mod range;
mod size;
mod strength;
mod wrong;

use super::WheelQuestion;
use super::kind::WheelKind;
use geneva_dynamics::line_contact::Material;
use geneva_kinematics::wheel::as_built::Process;

/// An argument of a question about a wheel.
#[derive(Clone, Copy, Debug)]
pub struct Argument {
    /// Its name, which stands behind two hyphens at the command line and is that of the control on the page.
    pub name: &'static str,
    /// A word for its value, which says the unit: `MM`.
    pub unit: &'static str,
    /// Where it is in the question, and so what it may be.
    pub place: ArgumentSlot,
    /// What it acts on: without that, it has no effect. Some act on all that is said of a wheel.
    pub acts_on: &'static [ActsOn],
    /// Names of arguments of which one must be given for it to have an effect; nothing for one that depends on no other.
    pub depends_on: &'static [&'static str],
    /// What it means, with its range and what it is by default. Nothing in WebAssembly, for no page shows it.
    pub help: &'static str,
    /// How a page moves it; none if no page has it.
    pub knob: Option<Knob>,
}

/// How an argument is moved on a page.
#[derive(Clone, Copy, Debug)]
pub struct Knob {
    /// What it is called there.
    pub label: &'static str,
    /// Its unit there; nothing for a pure number.
    pub unit: &'static str,
    /// The least and the greatest value of its slider, in its unit.
    pub slider: [f64; 2],
    /// The step of the slider, in its unit.
    pub step: f64,
    /// The least and the greatest value that can be typed, in its unit.
    pub typed: [f64; 2],
    /// Where it stands at first, in its unit; none if it follows the others until it is moved.
    pub first: Option<f64>,
    /// The key of the field of the answer that says where it stands while it follows the others; empty if it never does.
    pub key: &'static str,
    /// The group of arguments that say the same, and its number among them, of which the reader gives one.
    pub side: Option<(&'static str, usize)>,
}

/// The place of an argument in a question, by what it may be.
#[derive(Clone, Copy, Debug)]
pub enum ArgumentSlot {
    /// A number of stations.
    Stations(fn(&mut WheelQuestion) -> &mut Option<u32>),
    /// A number of pins.
    Pins(fn(&mut WheelQuestion) -> &mut Option<u32>),
    /// A kind of wheel, by its name.
    Kind(fn(&mut WheelQuestion) -> &mut Option<WheelKind>),
    /// A length in millimetres, above zero.
    Length(fn(&mut WheelQuestion) -> &mut Option<f64>),
    /// A length in millimetres that is zero or more.
    LengthOrZero(fn(&mut WheelQuestion) -> &mut Option<f64>),
    /// A length in millimetres of either sign.
    SignedLength(fn(&mut WheelQuestion) -> &mut Option<f64>),
    /// A number above zero.
    AboveZero(fn(&mut WheelQuestion) -> &mut Option<f64>),
    /// A number that is zero or more.
    ZeroOrMore(fn(&mut WheelQuestion) -> &mut Option<f64>),
    /// A number of things.
    Count(fn(&mut WheelQuestion) -> &mut Option<u32>),
    /// One of a few names.
    Choice(NamedChoice),
    /// A process, by its name.
    Process(fn(&mut WheelQuestion) -> &mut Option<Process>),
    /// A material, by its name.
    Material(fn(&mut WheelQuestion) -> &mut Option<Material>),
    /// Angles in degrees; the argument can be repeated.
    Degrees(fn(&mut WheelQuestion) -> &mut Vec<f64>),
}

/// A choice among a few names; the first is what holds if nothing is said, unless that depends on other arguments.
#[derive(Clone, Copy, Debug)]
pub struct NamedChoice {
    /// The names as they are typed.
    pub names: &'static [&'static str],
    /// Where what holds if nothing is said depends on other arguments, the names on a page: those above, and a last one for that.
    pub with_usual: Option<&'static [&'static str]>,
    /// Takes the choice with a number, from 0.
    pub set: fn(&mut WheelQuestion, usize),
}

impl NamedChoice {
    /// The names on a page, in the order of its entries.
    pub const fn on_page(&self) -> &'static [&'static str] {
        match self.with_usual {
            Some(names) => names,
            None => self.names,
        }
    }

    /// The number of the entry on a page that says nothing, from 0.
    pub const fn usual_entry(&self) -> usize {
        match self.with_usual {
            Some(names) => names.len() - 1,
            None => 0,
        }
    }
}

/// What an argument acts on besides the wheel as such.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ActsOn {
    /// The size of the wheel: one such argument gives it.
    Size,
    /// The parts in millimetres, which external wheels with a size have, and internal ones in their files.
    Parts,
    /// The files from which parts are made, and nothing else but what is named besides.
    Files,
    /// How loosely parts are held, which counts in backlash and yield.
    Play,
    /// Motion and loads.
    Motion,
    /// The speed of the driver: one such argument gives it.
    Speed,
    /// The moment of inertia of what the wheel carries: one way to say it.
    Inertia,
    /// The loads, which need a speed and an inertia.
    Load,
}

/// What the arguments of a group are about.
#[derive(Clone, Copy, Debug)]
pub struct ArgumentGroup {
    /// What they are about, as a heading of the command's help.
    pub heading: &'static str,
    /// What they are about, as the title of a fold of controls.
    pub fold: &'static str,
    /// The rows.
    pub rows: &'static [Argument],
}

/// The fold of controls for sizes that are wrong: a page has more of them than the command.
pub const WRONG_SIZES: &str = "What if a size is wrong";

/// All arguments, by what they are about, in the order of command and page.
pub const GROUPS: &[ArgumentGroup] = &[
    ArgumentGroup { heading: "What the wheel must do", fold: "What the wheel is to do", rows: need::ROWS },
    ArgumentGroup { heading: "How large it is", fold: "How large it is", rows: size::ROWS },
    ArgumentGroup { heading: "How its parts fit", fold: "How it fits", rows: fit::ROWS },
    ArgumentGroup { heading: "How it is mounted", fold: "How it is mounted", rows: mounting::ROWS },
    ArgumentGroup { heading: "What it carries", fold: "What it carries", rows: load::ROWS },
    ArgumentGroup { heading: "What rubs", fold: "What rubs", rows: friction::ROWS },
    ArgumentGroup { heading: "Pin and motor", fold: "Pin and motor", rows: strength::ROWS },
    ArgumentGroup { heading: "What is not as drawn", fold: WRONG_SIZES, rows: wrong::ROWS },
    ArgumentGroup { heading: "Instants", fold: "Instants", rows: instants::ROWS },
];

/// The arguments that say how the parts fit.
pub(super) const FIT: &[Argument] = fit::ROWS;
/// The arguments that say how large the wheel is.
pub(super) const SIZE: &[Argument] = size::ROWS;
/// The arguments that say how the parts are mounted.
pub(super) const MOUNTING: &[Argument] = mounting::ROWS;
/// The arguments that say what rubs.
pub(super) const FRICTION: &[Argument] = friction::ROWS;

/// All arguments in their order.
pub fn arguments() -> impl Iterator<Item = &'static Argument> {
    GROUPS.iter().flat_map(|group| group.rows)
}

impl Argument {
    const fn new(
        name: &'static str,
        unit: &'static str,
        place: ArgumentSlot,
        acts_on: &'static [ActsOn],
        help: &'static str,
    ) -> Self {
        let help = if cfg!(target_family = "wasm") { "" } else { help };
        Self { name, unit, place, acts_on, depends_on: &[], help, knob: None }
    }

    /// The argument that has an effect only beside one of these.
    const fn depending_on(self, depends_on: &'static [&'static str]) -> Self {
        Self { depends_on, ..self }
    }

    /// What is missing for it to have an effect, as the end of a sentence; none where it depends on no other argument, or where one of
    /// those is given. `is_given` says of a name whether that is.
    ///
    /// ```
    /// use geneva_ask::wheel::arguments;
    ///
    /// let of = |name| arguments().find(|argument| argument.name == name).expect("an argument");
    /// let missing = of("measured-play").missing_dependency(|_| false);
    /// assert_eq!(missing.as_deref(), Some("without --process; add that"));
    /// assert_eq!(of("measured-play").missing_dependency(|name| name == "process"), None);
    /// assert_eq!(of("play").missing_dependency(|_| false), None);
    /// ```
    pub fn missing_dependency(&self, is_given: impl Fn(&str) -> bool) -> Option<String> {
        if self.has_dependency(is_given) {
            return None;
        }
        let add = if self.depends_on.len() > 1 { "one of them" } else { "that" };
        Some(format!("without --{}; add {add}", self.depends_on.join(" or --")))
    }

    /// Whether it depends on no other argument, or one of those is given; `is_given` says of a name whether that is.
    pub fn has_dependency(&self, is_given: impl Fn(&str) -> bool) -> bool {
        self.depends_on.is_empty() || self.depends_on.iter().any(|name| is_given(name))
    }

    /// The argument with a control on the page.
    const fn with_knob(self, knob: Knob) -> Self {
        Self { knob: Some(knob), ..self }
    }
}

impl Knob {
    /// A slider between two values in steps, which begins at a value.
    const fn at(label: &'static str, unit: &'static str, slider: [f64; 2], step: f64, first: f64) -> Self {
        Self { label, unit, slider, step, typed: slider, first: Some(first), key: "", side: None }
    }

    /// A slider between two values in steps, which follows the others until it is moved.
    const fn follows(label: &'static str, unit: &'static str, slider: [f64; 2], step: f64, key: &'static str) -> Self {
        Self { label, unit, slider, step, typed: slider, first: None, key, side: None }
    }

    /// The control with a wider range for what is typed.
    const fn typed(self, typed: [f64; 2]) -> Self {
        Self { typed, ..self }
    }

    /// The control as one of several ways to say the same, of which the answer tells the others.
    const fn on_side(self, group: &'static str, number: usize) -> Self {
        Self { side: Some((group, number)), ..self }
    }

    /// The control with the field that says where it stands while another of its group is given.
    const fn told_by(self, key: &'static str) -> Self {
        Self { key, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::arguments;

    #[test]
    fn each_argument_on_which_one_depends_is_another_that_is_there() {
        let mut depending = 0;
        for argument in arguments() {
            for on in argument.depends_on {
                assert!(*on != argument.name && arguments().any(|other| other.name == *on), "{}: {on}", argument.name);
            }
            depending += usize::from(!argument.depends_on.is_empty());
        }
        assert!(depending >= 10, "{depending}");
    }

    #[test]
    fn what_is_missing_is_one_argument_or_one_of_several() {
        let of = |name| arguments().find(|argument| argument.name == name).expect("an argument");
        let pressure = of("pin-modulus").missing_dependency(|_| false);
        let any = "without --arm-torque or --rpm or --rad-s or --index-time or --dwell-time; add one of them";
        assert_eq!(pressure.as_deref(), Some(any));
        assert_eq!(of("pin-modulus").missing_dependency(|name| name == "index-time"), None);
    }
}
