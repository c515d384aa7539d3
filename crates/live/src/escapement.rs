//! The escapement from rest to its steady motion.

use crate::answer::{LiveNumber, LiveQuantity, LiveReply, round_for_box};
use crate::control::{Control, Live, Preset, Settings};
use geneva_ask::escapement::rates;
use geneva_dynamics::existence::critical_friction;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::{DynamicsError, Inertias, Parameters};
use geneva_figures::{Figure, escapement};
use geneva_kinematics::Mechanism;

/// The speed has been reached where an engagement begins so near it.
const REACHED: f64 = 0.01;

/// Engagements that are counted at most: a tenth of a second.
const MOST_ENGAGEMENTS: usize = 5_000;

pub const LIVE: Live = Live {
    name: "escapement",
    module: "live",
    figure: "live-escapement",
    hint: "Reduce the friction bit by bit: the start takes more and more engagements, and without friction there is no \
           steady speed. Add friction until the mechanism may jam. Press “twice the torque”: the mechanism runs √2 times \
           as fast, and in the figure only the speeds and times change.",
    controls: &[
        Control::slider("share", "share of the time shown", "%", [0.0, 100.0], 0.25, 40.0).playing(8.0),
        Control::choice("mechanism", "mechanism", &["6 pins, 3 slots", "4 pins, 4 slots", "3 pins, 6 slots"], 1),
        Control::slider("friction", "friction μ", "", [0.0, 1.0], 0.01, 0.2).with_typed_range([0.0, 10.0]),
        Control::slider("ratio", "inertia of the driver over the follower's", "", [0.02, 1.0], 0.01, 0.1)
            .with_typed_range([0.001, 1000.0]),
        Control::slider("torque", "torque K", "in lb", [0.05, 1.0], 0.01, 0.3).with_typed_range([0.001, 1e6]),
    ],
    presets: &[
        Preset::new("hardly any friction", "friction=0.02"),
        Preset::new("twice the torque", "torque=*2"),
        Preset::new("four pins, may jam", "mechanism=1&ratio=0.1&friction=0.9"),
    ],
    given: &["follower"],
    quantities: &[
        LiveQuantity::field("rate", "change of rate with one per cent more friction", "friction_rate_s_a_day"),
        LiveQuantity::new("entry", "terminal speed, at entry"),
        LiveQuantity::new("least", "least speed"),
        LiveQuantity::new("greatest", "greatest speed"),
        LiveQuantity::new("period", "from pin to pin"),
        LiveQuantity::new("engagements", "engagements until within 1 % of the terminal speed"),
        LiveQuantity::new("critical", "may jam from μ ="),
    ],
    others: &[],
    drag: None,
    files: &[],
    turned: None,
    tolerances: None,
    beat: Some("period"),
    draw,
};

/// The mechanisms in the order of the choice.
const MECHANISMS: [Mechanism; 3] = [Mechanism::SIX_PIN, Mechanism::FOUR_PIN, Mechanism::THREE_PIN];

fn draw(settings: &Settings) -> Result<LiveReply, String> {
    let mechanism = MECHANISMS[settings.choice("mechanism")?];
    let follower = settings.arguments().required_number("follower")?;
    let inertias = Inertias::new(settings.value("ratio")? * follower, follower).map_err(|error| error.to_string())?;
    let (torque, friction, share) =
        (settings.value("torque")?, settings.value("friction")?, settings.value("share")? / 100.0);
    let words = |error: DynamicsError| error.to_string();
    let limit = critical_friction(mechanism, inertias.ratio()).map_err(words)?;
    let critical = LiveNumber::new("critical", limit.friction, 3, "");
    let parameters = match Parameters::new(mechanism, inertias, torque, friction) {
        Err(DynamicsError::TooMuchFriction { asked, limit, angle }) => {
            // Where it jams, and why.
            let figure = escapement::mechanism(&mechanism, -angle).map_err(|error| error.to_string())?;
            let message = Some(format!(
                "friction μ {}: from {limit:.4} on, the equation of motion has no single solution {:.1}° from the line of \
                 centres, where the drawing shows it. A real one may jam there, so nothing plays. Give less friction, or a \
                 driver with more inertia.",
                round_for_box(asked),
                angle.to_degrees()
            ));
            let caption =
                "The escapement with its driver at the angle where it may jam: with so much friction, its equation of \
                           motion has no single solution there."
                    .to_owned();
            return Ok(LiveReply { message, jams: true, ..LiveReply::new(Figure { caption, ..figure }, [critical]) });
        }
        other => other.map_err(words)?,
    };
    let engagement = Engagement::new(&parameters).map_err(words)?;
    let steady = engagement.steady_state().map_err(words)?;
    let mut figure = escapement::running(&engagement, share).map_err(|error| error.to_string())?;
    // The speeds depend on these two as well.
    figure.caption += &format!(
        " The torque is {}\u{a0}in\u{a0}lb, and the follower's moment of inertia is always {}\u{a0}·\u{a0}10⁻⁶\u{a0}in\u{a0}lb\u{a0}s².",
        round_for_box(torque),
        round_for_box(1e6 * follower)
    );
    let engagements = match engagement.engagements_to_settle_within(REACHED, MOST_ENGAGEMENTS) {
        Err(DynamicsError::TooMany { .. }) => LiveNumber {
            text: format!("more than {MOST_ENGAGEMENTS}"),
            ..LiveNumber::new("engagements", MOST_ENGAGEMENTS as f64, 0, "")
        },
        settled => LiveNumber::new("engagements", settled.map_err(words)?.0 as f64, 0, ""),
    };
    let rates = rates(&parameters).map_err(words)?;
    let rate = rates.iter().find(|field| field.key == "friction_rate_s_a_day");
    let rate = rate.and_then(|field| LiveNumber::from_field("rate", field)).ok_or("the friction has no rate")?;
    let speed = |name, speed| LiveNumber::significant(name, speed, 4, "rad/s");
    let numbers = [
        rate,
        speed("entry", steady.entry_speed),
        speed("least", steady.minimum.speed),
        speed("greatest", steady.peak.speed),
        LiveNumber::significant("period", 1000.0 * steady.period, 4, "ms"),
        engagements,
        critical,
    ];
    Ok(LiveReply::new(figure, numbers))
}
