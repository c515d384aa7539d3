//! The figures that a reader moves, on a page: the still figure, and its controls hidden until a script finds them.

use crate::lookup;
use anyhow::{Context, anyhow};
use geneva_ask::worked::{WorkedStep, set_symbols};
use geneva_case1973::{Column, Hypothesis, Listing, Row, SixPin, rows_of};
use geneva_documents::LEDGER;
use geneva_documents::meyer::runs::table::{listing, rows};
use geneva_documents::pin::PinProblem;
use geneva_documents::quick_return::LeverProblem;
use geneva_figures::Figure;
use geneva_kinematics::Mechanism;
use geneva_live::{
    Control, ControlKind, ControlSide, LIVE, Live, LiveArguments, LiveFile, LiveQuantity, LiveReply, ToleranceRow,
    round_for_box,
};
use geneva_press::Book;
use geneva_press::book::{InteractiveFigure, PageFigure};
use geneva_press::html::escape;

/// What stands in the book beside a figure's own: the data of a source that it is asked with, and the claims to which its
/// numbers lead.
struct Beside {
    name: &'static str,
    given: fn() -> anyhow::Result<LiveArguments>,
    /// Quantities, and the claim that says the same of one setting.
    claims: &'static [(&'static str, &'static str)],
}

const BESIDE: &[Beside] = &[
    Beside {
        name: "pin",
        given: pin,
        claims: &[("wheel-speed", "pin.follower-speed"), ("sliding", "pin.sliding-speed")],
    },
    Beside {
        name: "wheel",
        given: || Ok(LiveArguments::default()),
        claims: &[
            ("blow", "jazar.tangent-entry"),
            ("velocity", "jazar.eq-5.31"),
            ("acceleration", "jazar.eq-5.32"),
            ("jerk", "jazar.infinite-jerk"),
            ("angle", "jazar.eq-5.30"),
            ("index", "jazar.ex-b.formula"),
        ],
    },
    Beside {
        name: "design",
        given: || Ok(LiveArguments::default()),
        claims: &[("centres", "jazar.centre-distance-ratio"), ("index", "jazar.duration")],
    },
    Beside {
        name: "polygon",
        given: lever,
        claims: &[
            ("gap", "quick-return.acceleration-equation"),
            ("lever-speed", "quick-return.lever-speed-equation"),
            ("sliding", "quick-return.sliding-speed-equation"),
            ("lever-acceleration", "quick-return.lever-acceleration-equation"),
            ("coriolis", "quick-return.coriolis-equation"),
        ],
    },
    Beside { name: "mistake", given: runs, claims: &[("agree", "meyer.listing.quarter-turn")] },
    Beside {
        name: "escapement",
        given: example,
        claims: &[
            ("rate", "meyer.conclusion.timing"),
            ("entry", "meyer.abstract.terminal"),
            ("engagements", "meyer.no-friction"),
            ("critical", "meyer.singularity.conclusion"),
        ],
    },
];

/// The figure of this name as it stands at first: what its still form shows.
pub fn figure(name: &str) -> anyhow::Result<Figure> {
    Ok(at_first(named(name)?)?.figure)
}

/// The name of the drawing of a figure that a reader moves, by which a chapter refers to it.
pub fn figure_name(name: &str) -> Option<&'static str> {
    geneva_live::by_name(name).map(|live| live.figure)
}

/// The figure of this name with its controls.
pub fn interactive(book: &Book, name: &str) -> anyhow::Result<InteractiveFigure> {
    let live = named(name)?;
    let answer = at_first(live)?;
    let drawing = html(book, live, &answer)?;
    let Figure { caption, series, source, .. } = answer.figure;
    let figure = PageFigure { drawing, caption, csv: series.to_csv(), source };
    Ok(InteractiveFigure { figure, attributes: attributes(live)? })
}

fn html(book: &Book, live: &Live, answer: &LiveReply) -> anyhow::Result<String> {
    let given = given(live.name)?;
    let plays = live.controls.iter().any(|control| matches!(control.kind, ControlKind::Player(_)));
    let is_folded = live.controls.iter().any(|control| control.fold.is_some());
    let play = if plays { PLAY } else { "" };
    let rows = live.controls.chunk_by(|one, next| one.fold == next.fold).enumerate().map(|(number, together)| {
        let rows: String = together.iter().map(|control| row(live, control, &given, answer)).collect();
        let rows = format!("<div class=\"rows\">{rows}</div>");
        let Some(title) = together.first().and_then(|control| control.fold) else { return Ok(rows) };
        let is_here = together.iter().any(|control| matches!(control.kind, ControlKind::Player(_)));
        let play = if is_here { format!("<p class=\"buttons\">{PLAY}</p>") } else { String::new() };
        let table = match &live.tolerances {
            Some(table) if table.fold == title => tolerances(live, &given)?,
            _ => String::new(),
        };
        // The first is open.
        Ok(fold(title, "", number == 0, &format!("{play}{table}{rows}")))
    });
    let rows: Vec<String> = rows.collect::<anyhow::Result<_>>()?;
    let presets = live.presets.iter().map(|preset| {
        let whole = if preset.is_whole { " data-whole" } else { "" };
        format!(
            "<button type=\"button\" data-set=\"{}\"{whole}>{}</button>",
            escape(preset.arguments),
            escape(preset.name)
        )
    });
    let others = numbers(book, live, live.others.iter().chain(&answer.further), answer)?;
    let others = if others.is_empty() { String::new() } else { format!("\n<dl class=\"others\">{others}</dl>") };
    let steps = if answer.steps.is_empty() { String::new() } else { format!("\n{}", steps(&answer.steps)) };
    let no_file = if live.files.is_empty() { "" } else { " and no files" };
    let hear = live.beat.map_or_else(String::new, |number| {
        format!("<button type=\"button\" data-do=\"hear\" data-beat=\"{number}\">Hear its beat</button>")
    });
    let play = if is_folded { "" } else { play };
    let folded = if is_folded { " folded" } else { "" };
    let turned = if live.turned.is_some() { "\n<p class=\"turned\" aria-live=\"polite\"></p>" } else { "" };
    Ok(format!(
        "<div class=\"moving{folded}\">\n<div class=\"place\"><div class=\"shown\">\n<div class=\"drawing\">\n{}\n</div>{turned}\n<dl \
         class=\"results\">{}</dl>\n<div role=\"status\"><p class=\"ignored\"></p>\n<p class=\"message\"></p>\n<p class=\"stale\" \
         hidden>There are no numbers{no_file} for this setting. The drawing still shows the last setting that was \
         possible.</p></div>\n</div></div>\n<form hidden>\n<p class=\"hint\"><strong>Try this.</strong> {}</p>\n<div \
         class=\"moved\">{}{}</div>\n<p class=\"buttons\">{play}{hear}<button type=\"button\" data-do=\"reset\">Reset</button>{} <a \
         data-do=\"link\" href=\"#fig-{}\">Link to this setting</a></p>\n</form>{others}{steps}\n</div>",
        answer.figure.svg.trim_end(),
        numbers(book, live, live.quantities.iter(), answer)?,
        escape(live.hint),
        rows.concat(),
        files(live, answer),
        presets.collect::<String>(),
        live.figure,
    ))
}

/// What plays, and goes step by step.
const PLAY: &str = "<button type=\"button\" data-do=\"play\">Play</button><button type=\"button\" data-do=\"back\" aria-label=\"One \
                    step back\">◂</button><button type=\"button\" data-do=\"forth\" aria-label=\"One step forward\">▸</button>";

/// A fold of the controls.
fn fold(title: &str, class: &str, is_open: bool, inside: &str) -> String {
    let open = if is_open { " open" } else { "" };
    format!("<details{class}{open}><summary>{}</summary><div class=\"inside\">{inside}</div></details>", escape(title))
}

/// The files of a setting and the command that asks the same, in a fold; nothing if there are none.
fn files(live: &Live, answer: &LiveReply) -> String {
    if live.files.is_empty() {
        return String::new();
    }
    let button = |file: &LiveFile| {
        format!("<button type=\"button\" data-file=\"{}\">{}</button>", file.name, escape(file.label))
    };
    let files: String = live.files.iter().map(button).collect();
    let command = answer.command.as_deref().map_or_else(String::new, |command| {
        format!(
            "<p>The same at the command line:</p><p><code class=\"command\">{}</code> <button type=\"button\" \
             data-do=\"copy\">Copy</button></p>",
            escape(command)
        )
    });
    fold("Files", " class=\"files\"", false, &format!("<p class=\"buttons\">{files}</p>{command}"))
}

/// How wrong sizes may be, as a table whose rows light up.
fn tolerances(live: &Live, given: &LiveArguments) -> anyhow::Result<String> {
    let rows = live.tolerance_rows(given).map_err(|message| anyhow!("{}: {message}", live.name))?;
    let row = |row: &ToleranceRow| {
        format!(
            "<tr class=\"{}\"><th scope=\"row\">{}<span class=\"state\">{}</span></th><td>{}</td><td>{}</td><td>{}</td></tr>",
            row.state.name(),
            escape(row.name),
            escape(row.state.words()),
            escape(&row.set),
            escape(&row.alone),
            escape(&row.together)
        )
    };
    let rows: String = rows.iter().map(row).collect();
    Ok(format!(
        "<table class=\"tolerances\"><thead><tr><th scope=\"col\">wrong by</th><th scope=\"col\">set</th><th scope=\"col\">limit \
         alone</th><th scope=\"col\">if all are wrong</th></tr></thead><tbody>{rows}</tbody></table>"
    ))
}

/// The solution step by step, in a fold.
fn steps(steps: &[WorkedStep]) -> String {
    let line = |line: &String| format!("<p>{}</p>", marked_up(line));
    let step = |step: &WorkedStep| {
        let lines: String = step.lines.iter().map(line).collect();
        format!("<li><strong>{}</strong>{lines}</li>", escape(step.heading))
    };
    let steps: String = steps.iter().map(step).collect();
    format!(
        "<details class=\"worked\">\n<summary>The solution step by step, with these numbers</summary>\n<ol class=\"steps\">{steps}</ol>\n</details>"
    )
}

/// A line of a step: its symbols in italics, with their indices.
fn marked_up(line: &str) -> String {
    let symbol = |symbol: &str, indices: &[&str]| {
        // Who copies the steps gets v_P, and not vP.
        let index = |(index, (element, mark)): (&&str, (&str, &str))| {
            format!("<span class=\"unseen\" aria-hidden=\"true\">{mark}</span><{element}>{}</{element}>", escape(index))
        };
        let dotted = if symbol.contains(['\u{307}', '\u{308}']) { " class=\"dotted\"" } else { "" };
        format!(
            "<i{dotted}>{}</i>{}",
            escape(symbol),
            indices.iter().zip([("sub", "_"), ("sup", "^")]).map(index).collect::<String>()
        )
    };
    set_symbols(line, escape, symbol)
}

/// Quantities with their numbers; a label leads to the claim that says the same of one setting, if there is one.
fn numbers<'a>(
    book: &Book,
    live: &Live,
    quantities: impl Iterator<Item = &'a LiveQuantity>,
    answer: &LiveReply,
) -> anyhow::Result<String> {
    let claims = beside(live.name)?.claims;
    let entry = |quantity: &LiveQuantity| {
        let claim = claims.iter().find(|(of, _)| *of == quantity.name);
        let label = escape(quantity.label);
        let label = match claim {
            Some((_, id)) => {
                format!("<a href=\"{}\">{label}</a>", book.address_of_claim(lookup::judged(id)?.claim.id))
            }
            None => label,
        };
        let text = answer.numbers.iter().find(|number| number.name == quantity.name);
        let text = text.map_or("–", |number| number.text.as_str());
        // Of all that changes, a reader who listens hears the first number.
        let is_first = live.quantities.first().is_some_and(|first| first.name == quantity.name);
        let spoken = if is_first { "polite" } else { "off" };
        let output = format!("<output name=\"{}\" aria-live=\"{spoken}\">{}</output>", quantity.name, escape(text));
        Ok(format!("<div><dt>{label}</dt> <dd>{output}</dd></div>"))
    };
    Ok(quantities.map(entry).collect::<anyhow::Result<Vec<String>>>()?.concat())
}

fn attributes(live: &Live) -> anyhow::Result<String> {
    let drag = live
        .drag
        .map_or_else(String::new, |drag| format!(" data-drag=\"{} {} {}\"", drag.control, drag.at_right, drag.sense));
    let given = given(live.name)?;
    let fixed = given.only(|name| live.given.contains(&name)).to_query();
    let hand = if live.turned.is_some() { " data-hand=\"turned\"" } else { "" };
    Ok(format!(
        " data-live=\"{}\" data-live-module=\"{}\" data-given=\"{}\"{drag}{hand}",
        live.name,
        live.module,
        escape(&fixed)
    ))
}

/// One control with its label, its number and its unit.
fn row(live: &Live, control: &Control, given: &LiveArguments, answer: &LiveReply) -> String {
    let Control { name, label, unit, least, most, step, range: [lowest, highest], .. } = control;
    let id = format!("live-{}-{name}", live.name);
    let follower = answer.followers.iter().find(|(of, _)| of == name).map(|(_, value)| round_for_box(*value));
    // What there is not has an empty box, and its slider stands anywhere.
    let at_first = follower.unwrap_or(control.preset);
    let at_first = if at_first.is_finite() { at_first.to_string() } else { String::new() };
    let value = given.text(name).map_or(at_first, str::to_owned);
    let slid = if value.is_empty() { least.to_string() } else { value.clone() };
    let side = control
        .side
        .map_or_else(String::new, |ControlSide { group, number }| format!(" data-side=\"{group} {number}\""));
    let (label, spoken) = (escape(label), escape(format!("{label} {unit}").trim_end()));
    match control.kind {
        ControlKind::Choice(choices) => {
            let option = |(number, words): (usize, &&str)| {
                let chosen = if number.to_string() == value { " selected" } else { "" };
                format!("<option value=\"{number}\"{chosen}>{}</option>", escape(words))
            };
            let options: String = choices.iter().enumerate().map(option).collect();
            format!("<label for=\"{id}\">{label}</label><select id=\"{id}\" name=\"{name}\"{side}>{options}</select>")
        }
        ControlKind::Number => format!(
            "<label class=\"inline\" for=\"{id}\">{label}</label><span><input type=\"number\" id=\"{id}\" name=\"{name}\" aria-label=\"{}\" \
             min=\"{lowest}\" max=\"{highest}\" step=\"any\" value=\"{value}\"{side}> {}</span>",
            spoken,
            escape(unit)
        ),
        ControlKind::Slider | ControlKind::Player(_) | ControlKind::Follower => {
            let play = match control.kind {
                ControlKind::Player(rate) => format!(" data-play=\"{rate}\""),
                ControlKind::Follower => " data-follows".to_owned(),
                _ => String::new(),
            };
            let range = format!("min=\"{least}\" max=\"{most}\" step=\"{step}\" value=\"{slid}\"");
            format!(
                "<label for=\"{id}\">{label}</label><input type=\"range\" id=\"{id}\" name=\"{name}\" aria-label=\"{spoken}\" {range}{play}{side}><span><input \
                 type=\"number\" data-box=\"{name}\" aria-label=\"{spoken}\" min=\"{lowest}\" max=\"{highest}\" step=\"any\" value=\"{value}\"> {}</span>",
                escape(unit)
            )
        }
    }
}

fn named(name: &str) -> anyhow::Result<&'static Live> {
    let all: Vec<(&str, &'static Live)> = LIVE.into_iter().map(|live| (live.name, live)).collect();
    lookup::find_named("figure that a reader moves", name, &all)
}

fn beside(name: &str) -> anyhow::Result<&'static Beside> {
    BESIDE.iter().find(|beside| beside.name == name).with_context(|| format!("what is told of `{name}`"))
}

/// What the page gives a figure: data of a source, and where controls stand at first.
fn given(name: &str) -> anyhow::Result<LiveArguments> {
    (beside(name)?.given)()
}

/// The answer where all controls stand as at first.
fn at_first(live: &'static Live) -> anyhow::Result<LiveReply> {
    let given = given(live.name)?;
    loop {
        let answer = live.answer(&given).map_err(|message| anyhow!("{}: {message}", live.name))?;
        if answer.progress.is_none() {
            return Ok(answer);
        }
    }
}

/// The data of the source's problem.
fn pin() -> anyhow::Result<LiveArguments> {
    let at = PinProblem::printed().context("the printed data make no pin in a slot")?;
    let angle = LEDGER.printed_value("pin.crank-angle").context("an angle without a number")?;
    let numbers = [("theta", angle - 180.0), ("radius", at.mechanism.crank_radius()), ("speed", at.driver_speed)];
    Ok(LiveArguments::from_pairs(numbers.map(|(name, number)| (name, number.to_string()))))
}

/// The linkage of the source's problem; its angle so fine that the numbers are those of the chapter to all their digits.
fn lever() -> anyhow::Result<LiveArguments> {
    let at = LeverProblem::printed().context("the printed data make no quick-return mechanism")?;
    let crank = at.position.crank.radians().to_degrees().rem_euclid(360.0) - 180.0;
    let rpm = LEDGER.printed_value("quick-return.driver-speed").context("a speed without a number")?;
    let numbers = [("ground", at.linkage.ground()), ("radius", at.linkage.crank()), ("rpm", rpm)];
    let numbers = numbers.map(|(name, number)| (name, number.to_string()));
    Ok(LiveArguments::from_pairs(numbers.into_iter().chain([("crank", format!("{crank:.3}"))])))
}

/// The run that stands for all, its ratio of inertias to three digits.
fn example() -> anyhow::Result<LiveArguments> {
    let row = crate::rows::example()?;
    let of = |key| crate::rows::number(row, key);
    Ok(LiveArguments::from_pairs([
        ("follower", of("follower_inertia")?.to_string()),
        ("ratio", format!("{:.3}", of("inertia_ratio")?)),
        ("friction", of("friction")?.to_string()),
        ("torque", of("torque")?.to_string()),
    ]))
}

/// The tables of Appendix E, the inertias of the runs, and the cards of the program.
fn runs() -> anyhow::Result<LiveArguments> {
    let row =
        |row: &Row| format!("{},{}", row.mechanism.slots(), Column::ALL.map(|column| row.printed(column)).join(","));
    let of = |hypothesis: &Hypothesis, mechanism: Mechanism| {
        let [driver, follower] = hypothesis.inertias(rows_of(rows(), mechanism).first()?);
        Some(format!("{},{driver:e},{follower:e}", mechanism.slots()))
    };
    let headed = Hypothesis { six_pin: SixPin::AsHeaded, ..Hypothesis::IDEAL };
    let drawn =
        Mechanism::ALL.into_iter().map(|mechanism| of(&Hypothesis::IDEAL, mechanism)).collect::<Option<Vec<_>>>();
    let none = "a table without rows";
    let Listing { pi, interval, duration, delay, .. } = listing();
    Ok(LiveArguments::from_pairs([
        ("rows", rows().iter().map(row).collect::<Vec<_>>().join(";")),
        ("inertias", drawn.context(none)?.join(";")),
        ("headed", of(&headed, Mechanism::SIX_PIN).context(none)?),
        ("duration", duration.to_string()),
        ("delay", delay.to_string()),
        ("pi", pi.to_string()),
        ("interval", ((1e6 * interval).round() / 1e3).to_string()),
    ]))
}
