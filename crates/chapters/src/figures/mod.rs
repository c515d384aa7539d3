//! The figures of the book: the ledger says for which mechanism, `geneva_figures` draws it.

mod runs;
mod timer;
mod wild;

use crate::computed::making;
use crate::rows::{NONE, example, question};
use crate::{live, lookup};
use anyhow::Context;
use geneva_ask::escapement::{EscapementDesign, EscapementDrawing};
use geneva_case1973::{Hypothesis, weakest};
use geneva_documents::meyer::runs::table::rows;
use geneva_documents::{jazar, pin::PinProblem, quick_return::LeverProblem};
use geneva_figures::{Figure, escapement, pin, quick_return, stations};
use geneva_kinematics::Mechanism;
use geneva_kinematics::internal_wheel::InternalWheel;
use geneva_kinematics::quick_return::{Drive, Position, QuickReturn};
use geneva_kinematics::spherical_wheel::SphericalWheel;
use geneva_kinematics::wheel::Wheel;
use geneva_press::book::PageFigure;

/// Draws a figure for the printed data of its source.
type Draw = fn() -> anyhow::Result<Figure>;

/// All figures by name, in the order of the book.
pub const FIGURES: &[(&str, Draw)] = &[
    ("wheel-turning", || Ok(stations::turning(&four_stations()?))),
    ("live-wheel", || live::figure("wheel")),
    ("wheel-dimensions", || live::figure("design")),
    ("wheel-crescent", || Ok(stations::crescent(&making::sizes()?)?)),
    ("wheel-dwell-play", || Ok(stations::dwell_play(&making::sizes()?))),
    ("wheel-kinds", || Ok(stations::kinds(3..=18)?)),
    ("internal-mechanism", || Ok(stations::internal_mechanism(&InternalWheel::new(KIND_SLOTS)?))),
    ("spherical-mechanism", || Ok(stations::spherical_mechanism(&SphericalWheel::new(KIND_SLOTS)?))),
    ("pin-position", || of_pin(|at| pin::position_triangle(&at.mechanism, &at.crank))),
    ("pin-velocity", || of_pin(|at| pin::velocity_triangle(&at.mechanism, &at.crank, at.driver_speed, "mm/s"))),
    ("pin-engagement", || of_pin(|at| pin::over_the_engagement(&at.mechanism, &at.crank, at.driver_speed, "mm"))),
    ("quick-return-mechanism", || of_lever(quick_return::mechanism)),
    ("quick-return-velocity", || of_lever(quick_return::velocity_diagram)),
    ("quick-return-acceleration", || of_lever(quick_return::acceleration_diagram)),
    ("quick-return-bead", || Ok(quick_return::bead_on_a_lever())),
    ("live-pin", || live::figure("pin")),
    ("live-polygon", || live::figure("polygon")),
    ("quick-return-turn", || of_lever(|linkage, at, drive, _| quick_return::over_a_turn(linkage, at, drive))),
    ("wheel-choice", || Ok(stations::choice(3..=18)?)),
    ("wheel-mechanism", || Ok(stations::mechanism(&four_stations()?))),
    ("wheel-model", || Ok(stations::model(&four_stations()?, MODEL_ANGLE)?)),
    ("wheel-critical", || Ok(stations::critical_geometry(&jazar::example().context(NO_WHEEL)?))),
    ("wheel-indexing", || Ok(stations::indexing(&four_stations()?))),
    ("wheel-motion", || Ok(stations::motion(&four_stations()?))),
    ("wheel-extremes", || Ok(stations::extremes(3..=18))),
    ("escapement-mechanism-4", || mechanism(4)),
    ("escapement-hand-over-4", || Ok(escapement::hand_over(&with_slots(4)?))),
    ("escapement-mechanism-3", || mechanism(3)),
    ("escapement-mechanism-6", || mechanism(6)),
    ("escapement-angles-4", || {
        let four = with_slots(4)?;
        Ok(escapement::angles(&four, GENERAL * four.engagement_half_angle())?)
    }),
    ("escapement-ratios", || Ok(escapement::ratios(&Mechanism::ALL))),
    ("escapement-forces", || {
        let own = Hypothesis::IDEAL.parameters(example()?).context(NONE)?;
        Ok(escapement::steady_forces(&own, TRAILING)?)
    }),
    ("escapement-normal-force", || {
        Ok(EscapementDesign::new(question(example()?))?.drawing(EscapementDrawing::NormalForce)?)
    }),
    ("escapement-existence", || Ok(escapement::existence(&designs()?))),
    ("integrator-order", || Ok(escapement::order())),
    ("runs-agreement", runs::agreement),
    ("agreement-own-angles", runs::own_angles),
    ("agreement-quarter-turn", runs::quarter_turn),
    ("runs-reset-angle", runs::reset_angle),
    ("runs-aliasing", runs::printed_too_seldom),
    ("runs-hypotheses", runs::hypotheses),
    ("runs-columns", runs::columns),
    ("runs-lags", runs::lags),
    ("runs-speeds", runs::of_fig_8),
    ("runs-four-pin", || runs::over_torque(Mechanism::FOUR_PIN)),
    ("runs-six-pin", || runs::over_torque(Mechanism::SIX_PIN)),
    ("runs-three-pin", || runs::over_torque(Mechanism::THREE_PIN)),
    ("live-mistake", || live::figure("mistake")),
    ("steady-collapse", runs::collapse),
    ("live-escapement", || live::figure("escapement")),
    ("steady-return-map", runs::return_map),
    ("steady-phase", runs::phase),
    ("steady-map-four-pin", || runs::map(Mechanism::FOUR_PIN)),
    ("steady-map-six-pin", || runs::map(Mechanism::SIX_PIN)),
    ("steady-map-three-pin", || runs::map(Mechanism::THREE_PIN)),
    ("timer-torque", || Ok(geneva_figures::timer::torque())),
    ("timer-runaway", || Ok(geneva_figures::timer::runaway()?)),
    ("timer-verge", || Ok(geneva_figures::timer::verge())),
    ("timer-friction", timer::friction),
    ("timer-sensitivity", timer::sensitivity),
    ("timer-settling", timer::settling),
    ("timer-accelerations", runs::accelerations),
    ("timer-strongest", timer::strongest),
    ("joints-contact", runs::contact),
    ("joints-losses", runs::losses),
    ("wrong-formulas", wild::formulas),
    ("locking-cuts", wild::locking_cuts),
];

/// The figure of this name.
pub fn by_name(name: &str) -> anyhow::Result<Figure> {
    lookup::find_named("figure", name, FIGURES)?()
}

/// The figure of this name as a page shows it.
pub fn on_a_page(name: &str) -> anyhow::Result<PageFigure> {
    let figure = by_name(name)?;
    Ok(PageFigure {
        drawing: figure.on_a_page(),
        csv: figure.series.to_csv(),
        caption: figure.caption,
        source: figure.source,
    })
}

/// A drawing of the pin in the slot at the printed instant.
fn of_pin(draw: fn(&PinProblem) -> Figure) -> anyhow::Result<Figure> {
    Ok(draw(&PinProblem::printed().context("the printed data make no mechanism")?))
}

/// A drawing of the quick-return mechanism at the printed instant, in metres.
fn of_lever(draw: fn(&QuickReturn, &Position, &Drive<f64>, &str) -> Figure) -> anyhow::Result<Figure> {
    let at = LeverProblem::printed().context("the printed data make no quick-return mechanism")?;
    Ok(draw(&at.linkage, &at.position, &at.drive, "m"))
}

const NO_WHEEL: &str = "the source's wheel cannot be built";

fn four_stations() -> anyhow::Result<Wheel> {
    jazar::four_stations().context(NO_WHEEL)
}

/// Crank angle at which the model of a wheel is drawn: wide enough apart from the line of centres to see the angles.
const MODEL_ANGLE: f64 = 0.5;

/// Slots of the drawings of an internal and of a spherical wheel.
const KIND_SLOTS: u32 = 6;

/// Driver angle of the drawings of a general position, as a part of the half angle of the engagement.
const GENERAL: f64 = -0.5;
/// Driver angle of the drawing of the forces, as a part of the half angle of the engagement: past the line of centres, where
/// the follower drives the pin.
const TRAILING: f64 = 2.0 / 3.0;

fn with_slots(slots: u32) -> anyhow::Result<Mechanism> {
    Mechanism::new(slots).context("the thesis's mechanism cannot be built")
}

/// The escapement in a general position.
fn mechanism(slots: u32) -> anyhow::Result<Figure> {
    let escapement = with_slots(slots)?;
    Ok(escapement::mechanism(&escapement, GENERAL * escapement.engagement_half_angle())?)
}

/// The runs of the thesis as points of the map: one for each mechanism and friction, whatever the torque.
fn designs() -> anyhow::Result<Vec<escapement::MarkedEscapement>> {
    let design =
        |row| Ok(escapement::MarkedEscapement::from_parameters(&Hypothesis::IDEAL.parameters(row).context(NONE)?));
    weakest(rows()).map(design).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::OnceLock;

    /// All figures with their names, drawn once for all tests.
    fn drawn() -> &'static [(&'static str, Figure)] {
        static DRAWN: OnceLock<Vec<(&str, Figure)>> = OnceLock::new();
        DRAWN.get_or_init(|| FIGURES.iter().map(|(name, draw)| (*name, draw().expect("drawn"))).collect())
    }

    /// The value of an attribute in an opening tag.
    fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
        let (_, rest) = tag.split_once(&format!(" {name}=\""))?;
        Some(rest.split_once('"')?.0)
    }

    /// Width of a drawing on a phone of 390 px, from edge to edge, and the least height of letters there, in pixels.
    const PHONE: f64 = 382.0;
    const SMALLEST: f64 = 11.0;
    /// Of the body's letters, in pixels: on a wide screen those of drawings are neither much larger nor much smaller.
    const BODY: f64 = 16.0;

    #[test]
    fn on_a_page_every_halo_is_left_to_the_style_sheet() {
        for (name, figure) in drawn() {
            let (drawing, page) = (&figure.svg, figure.on_a_page());
            assert!(!page.contains("paint-order"), "{name}: a label of the page has a halo of its own");
            let of_paper = |text: &&str| text.contains("stroke=\"var(--fig-paper, #ffffff)\"");
            let halos =
                drawing.split("<text").skip(1).filter_map(|text| text.split('>').next()).filter(of_paper).count();
            assert_eq!(page.matches(" class=\"halo\"").count(), halos, "{name}: halos lost or invented");
        }
    }

    #[test]
    fn the_letters_of_every_figure_can_be_read_on_a_phone_and_are_as_large_as_the_text_on_a_wide_screen() {
        for (name, Figure { svg, .. }) in drawn() {
            let opening = svg.lines().next().expect("an opening tag");
            let number = |text: &str| text.parse::<f64>().expect("a number");
            let units = attribute(opening, "viewBox").and_then(|of| of.split(' ').nth(2)).map(number).expect("a width");
            let width = attribute(opening, "width").expect("a width on the screen");
            // A drawing in true size says its width in millimetres.
            let on_screen = width.strip_suffix("mm").map_or_else(|| number(width), |mm| number(mm) * 96.0 / 25.4);
            let sizes = svg.split('<').filter_map(|tag| attribute(tag, "font-size")).map(number);
            let smallest = sizes.fold(f64::INFINITY, f64::min) * on_screen.min(PHONE) / units;
            assert!(smallest >= SMALLEST, "{name}: letters of {smallest} px on a phone");
            let usual = attribute(opening, "font-size").map(number).expect("a size") * on_screen / units;
            assert!((usual / BODY - 1.0).abs() < 0.15, "{name}: letters of {usual} px beside text of {BODY} px");
        }
    }

    #[test]
    fn no_caption_writes_an_index_with_an_underscore() {
        for (name, Figure { caption, .. }) in drawn() {
            assert!(!caption.contains('_'), "{name}: {caption}");
        }
    }

    #[test]
    fn the_id_of_a_figure_is_its_name() {
        for (name, Figure { id, .. }) in drawn() {
            assert_eq!(id, name, "the figure `{name}` calls itself `{id}`");
        }
        let (name, figure) = &drawn()[0];
        assert_eq!(by_name(name).expect("drawn").svg, figure.svg);
    }
}
