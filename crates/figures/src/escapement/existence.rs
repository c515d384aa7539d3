//! How much friction an escapement can bear before its equation of motion has no single solution.

use crate::chart::{Chart, ChartAxis, LegendEntry, Panel, Spot, of_mechanism};
use crate::number::format_trimmed;
use crate::svg::Label;
use crate::{Figure, Series, Words};
use geneva_dynamics::Parameters;
use geneva_dynamics::existence::{critical_friction, critical_inertia_ratio};
use geneva_kinematics::Mechanism;
use std::ops::Range;

/// Points of a curve.
const STEPS: u32 = 80;
/// The range of I_D / I_f and the greatest μ that are shown.
const INERTIAS: Range<f64> = 0.005..5.0;
const FRICTION: f64 = 0.8;

/// An escapement to be marked on the map.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkedEscapement {
    /// Pins, slots and centre distance.
    pub mechanism: Mechanism,
    /// I_D / I_f.
    pub inertia_ratio: f64,
    /// Coefficient of friction between pin and slot.
    pub friction: f64,
}

impl MarkedEscapement {
    /// The point of an escapement.
    pub fn from_parameters(parameters: &Parameters) -> Self {
        let inertia_ratio = parameters.inertias().ratio();
        Self { mechanism: parameters.mechanism(), inertia_ratio, friction: parameters.friction() }
    }

    /// Whether the equation of motion has one solution wherever a pin is in its slot.
    pub fn is_sound(&self) -> bool {
        critical_friction(self.mechanism, self.inertia_ratio).is_ok_and(|critical| self.friction < critical.friction)
    }
}

/// The critical friction μ* over I_D / I_f for the three mechanisms, with designs marked on it.
///
/// Below its curve a mechanism has one acceleration at every angle; on it and above there are angles with none or more
/// than one. The designs lie within the ranges shown. Series: I_D / I_f, then μ* for 3, 4 and 6 slots; the designs' inertias
/// are among the rows.
pub fn existence(designs: &[MarkedEscapement]) -> Figure {
    let [inertias, frictions] = axes();
    let mut panel = Panel::new(426.0, &inertias, &frictions);
    for mechanism in Mechanism::ALL {
        panel = panel.curve(curve(mechanism, &inertias.range, frictions.range.end), of_mechanism(mechanism.slots()).0);
    }
    for design in designs {
        let marker = of_mechanism(design.mechanism.slots()).1.sized(11.0).class("point");
        panel = panel.marks([(design.inertia_ratio, design.friction)], marker);
    }
    let key = Mechanism::ALL.map(|mechanism| {
        let (pins, slots) = (mechanism.pins(), mechanism.slots());
        let look = of_mechanism(slots);
        LegendEntry::curve_with_marks(
            look,
            Label::words(&format!("{pins} pins, {slots} slots")).in_colour(look.0.colour),
        )
    });
    let above = [0.06, 0.1, 0.16, 0.22].into_iter().flat_map(|y| [0.18, 0.2, 0.24].map(|x| [x, 1.0 - y]));
    let below = [0.84, 0.78, 0.9, 0.7, 0.66, 0.6].into_iter().flat_map(|y| [0.78, 0.72].map(|x| [x, 1.0 - y]));
    let panel = panel
        .name(Label::words("above its curve:\nnone or two"), Spot::Free(above.collect()))
        .name(Label::words("below its curve:\none acceleration"), Spot::Free(below.collect()));

    let columns = [("I_D/I_f", "1"), ("mu* n=3", "1"), ("mu* n=4", "1"), ("mu* n=6", "1")];
    let marks: Vec<String> = designs.iter().map(mark_words).collect();
    let words = Words::new(
        "escapement-existence",
        "Friction that the equation of motion can bear, over the ratio of the inertias",
        format!(
            "Three rising curves of the critical friction μ* over I_D / I_f on a logarithmic axis, for 3, 4 and 6 slots, \
             from right to left: fewer slots bear less friction. Below its curve a mechanism has exactly one \
             acceleration at every angle. Marked: {}.",
            marks.join("; ")
        ),
        "The curves show the critical friction of the three mechanisms as a function of the ratio of their inertias. \
         The marks are the thesis's runs, in the colour of their mechanism's curve. Below its curve, a mechanism has \
         exactly one acceleration at every angle of the engagement. Above its curve, it has none or two at some \
         angles. The lighter the driver, the less friction the mechanism can bear.",
    );
    Chart::new([panel]).key(key).figure(words, Series::new(columns, rows(&inertias.range, designs)))
}

fn mark_words(design: &MarkedEscapement) -> String {
    let side = if design.is_sound() { "below" } else { "above" };
    format!(
        "{} slots at I_D / I_f = {}, μ = {}: {side} its curve",
        design.mechanism.slots(),
        format_trimmed(design.inertia_ratio, 4),
        format_trimmed(design.friction, 4)
    )
}

/// Axes of I_D / I_f and of μ.
fn axes() -> [ChartAxis; 2] {
    let ratio = Label::words("inertia of the driver over the follower's, ").and_symbol("I").sub("D");
    let ratio = ratio.and(" / ").and_symbol("I").sub("f");
    let friction = Label::words("coefficient of friction ").and_symbol("μ");
    [ChartAxis::logarithmic(INERTIAS).titled(ratio), ChartAxis::from_zero(0.0, FRICTION, 4.0).titled(friction)]
}

/// A curve, by steps of μ: from the left side of the frame to its top or its right side.
fn curve(mechanism: Mechanism, inertias: &Range<f64>, top: f64) -> Vec<(f64, f64)> {
    let friction = |inertia: f64| critical_friction(mechanism, inertia).map_or(0.0, |critical| critical.friction);
    let (low, high) = (friction(inertias.start), friction(inertias.end).min(top));
    let at = |k: u32| {
        let mu = low + (high - low) * f64::from(k) / f64::from(STEPS);
        (critical_inertia_ratio(mechanism, mu).unwrap_or_default().max(inertias.start), mu)
    };
    (0..=STEPS).map(at).collect()
}

/// μ* of the three at equal ratios of the inertias, and at those of the designs.
fn rows(inertias: &Range<f64>, designs: &[MarkedEscapement]) -> Vec<[f64; 4]> {
    let step =
        |k: u32| inertias.start * libm::exp(libm::log(inertias.end / inertias.start) * f64::from(k) / f64::from(STEPS));
    let mut ratios: Vec<f64> = (0..=STEPS).map(step).collect();
    ratios.extend(designs.iter().map(|design| design.inertia_ratio));
    ratios.sort_by(f64::total_cmp);
    ratios.dedup();
    let row = |inertia: f64| {
        let [a, b, c] =
            Mechanism::ALL.map(|mechanism| critical_friction(mechanism, inertia).map_or(0.0, |at| at.friction));
        [inertia, a, b, c]
    };
    ratios.into_iter().map(row).collect()
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound};

    fn design(mechanism: Mechanism, inertia_ratio: f64, friction: f64) -> MarkedEscapement {
        MarkedEscapement { mechanism, inertia_ratio, friction }
    }

    /// Some designs, two of them close together.
    pub(crate) fn designs() -> Vec<MarkedEscapement> {
        vec![
            design(Mechanism::FOUR_PIN, 0.03, 0.125),
            design(Mechanism::FOUR_PIN, 0.04, 0.2),
            design(Mechanism::SIX_PIN, 0.7, 0.375),
            design(Mechanism::THREE_PIN, 0.04, 0.25),
        ]
    }

    #[test]
    fn the_curves_rise_and_part_the_sound_from_the_rest() {
        let figure = existence(&designs());
        let rows = &figure.series.rows;
        assert!(rows.windows(2).all(|pair| (0..4).all(|k| pair[0][k] < pair[1][k])));
        assert!(rows.iter().all(|row| row[1] < row[2] && row[2] < row[3]));
        for design in designs() {
            let row = rows.iter().find(|row| row[0] == design.inertia_ratio).expect("a row");
            let column = 1 + design.mechanism.index();
            assert!(design.is_sound() && design.friction < row[column]);
            assert!(!MarkedEscapement { friction: row[column] * 1.001, ..design }.is_sound());
        }
        // A curve's points are where μ is critical.
        for mechanism in Mechanism::ALL {
            for (inertia, friction) in curve(mechanism, &INERTIAS, FRICTION) {
                let critical = critical_friction(mechanism, inertia).expect("sound").friction;
                approx::assert_relative_eq!(critical, friction, max_relative = 1e-9);
            }
        }
    }

    #[test]
    fn each_design_is_marked() {
        let figure = existence(&designs());
        assert_sound(&figure);
        assert_eq!(ParsedDrawing::parse(&figure).count("point"), designs().len());
        assert_eq!(figure.description.matches("its curve").count(), designs().len() + 1);
    }
}
