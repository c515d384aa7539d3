//! How much friction an escapement can bear before its equation of motion has no single solution.

use super::axes::{blank, style, upright};
use super::map_labels::names;
use crate::figure::{Figure, Words};
use crate::number::trimmed;
use crate::plot::{Axis, Curve, Plot, Scale, Side};
use crate::series::Series;
use crate::svg::canvas::Kind;
use geneva_dynamics::existence::{critical_friction, critical_inertia_ratio};
use geneva_kinematics::Mechanism;
use std::ops::Range;

const SIZE: (u32, u32) = (640, 540);
/// Points of a curve.
pub const STEPS: u32 = 80;
/// The least range of I_D / I_f and of μ that is shown.
const INERTIAS: Range<f64> = 0.005..5.0;
const FRICTION: f64 = 0.8;
/// What can be shown of both: beyond, a point is not marked.
const LIMITS: Range<f64> = 1e-6..1e6;

/// An escapement to be marked on the map.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// What it is called, in a few letters.
    pub name: String,
    /// Pins, slots and centre distance.
    pub mechanism: Mechanism,
    /// I_D / I_f.
    pub inertia_ratio: f64,
    /// Coefficient of friction between pin and slot.
    pub friction: f64,
}

impl Design {
    /// Whether the equation of motion has one solution wherever a pin is in its slot.
    pub fn is_sound(&self) -> bool {
        critical_friction(self.mechanism, self.inertia_ratio).is_ok_and(|critical| self.friction < critical.friction)
    }

    fn can_be_shown(&self) -> bool {
        LIMITS.contains(&self.inertia_ratio) && (0.0..LIMITS.end).contains(&self.friction)
    }
}

/// The critical friction μ* over I_D / I_f for the three mechanisms, with designs marked on it.
///
/// Below its curve a mechanism has one acceleration at every angle; on it and above there are angles with none or more
/// than one. The ranges grow with the designs. Series: I_D / I_f, then μ* for 3, 4 and 6 slots; the designs' inertias
/// are among the rows.
pub fn existence(designs: &[Design]) -> Figure {
    let designs: Vec<&Design> = designs.iter().filter(|design| design.can_be_shown()).collect();
    let frame = Frame::new(&designs);
    let plot = frame.plot();
    let mut canvas = plot.canvas();
    names(&mut canvas, &plot, &designs);

    let columns = [("I_D/I_f", "1"), ("mu* n=3", "1"), ("mu* n=4", "1"), ("mu* n=6", "1")];
    let said: Vec<String> = designs.iter().map(|design| said(design)).collect();
    let words = Words {
        id: "escapement-existence".to_owned(),
        title: "Friction that the equation of motion can bear, over the ratio of the inertias".to_owned(),
        description: format!(
            "Three rising curves of the critical friction μ* over I_D / I_f on a logarithmic axis, for 3, 4 and 6 slots, \
             from right to left: fewer slots bear less friction. Below its curve a mechanism has exactly one \
             acceleration at every angle. {}",
            if said.is_empty() { String::new() } else { format!("Marked: {}.", said.join("; ")) }
        )
        .trim_end()
        .to_owned(),
        caption: "Critical friction: below its curve a mechanism has exactly one acceleration at every angle of the \
                  engagement; above it there are angles with none, or with two. A light driver bears little friction."
            .to_owned(),
    };
    words.figure(canvas, Kind::Plot, Series::new(columns, frame.rows(&designs)))
}

fn said(design: &Design) -> String {
    let side = if design.is_sound() { "below" } else { "above" };
    format!(
        "{}, {} slots, at I_D / I_f = {}, μ = {}: {side} its curve",
        design.name,
        design.mechanism.slots(),
        trimmed(design.inertia_ratio, 4),
        trimmed(design.friction, 4)
    )
}

/// What is shown.
struct Frame {
    inertias: Range<f64>,
    upright: Axis,
}

impl Frame {
    fn new(designs: &[&Design]) -> Self {
        let inertias = || designs.iter().map(|design| design.inertia_ratio);
        let start = inertias().fold(INERTIAS.start, |least, one| least.min(one / 1.6));
        let end = inertias().fold(INERTIAS.end, |most, one| most.max(one * 1.6));
        let top = designs.iter().map(|design| design.friction).fold(FRICTION, f64::max);
        Self { inertias: start..end, upright: upright(0.0, top, 4.0) }
    }

    fn plot(&self) -> Plot {
        let decades = (-7..7).flat_map(|k| {
            let decade = format!("1e{k}").parse::<f64>().unwrap_or(1.0);
            [1.0, 2.0, 5.0].map(|m| m * decade)
        });
        let marks: Vec<f64> =
            decades.filter(|mark| self.inertias.contains(mark) || *mark == self.inertias.end).collect();
        // Over a wide range powers of ten are enough.
        let wide = marks.len() > 9;
        let is_power = |mark: &f64| format!("{mark:e}").starts_with("1e");
        let marks = marks.into_iter().filter(|mark| !wide || is_power(mark)).collect();
        let level = Axis { range: self.inertias.clone(), marks, decimals: 9, scale: Scale::Logarithmic };
        let curves = Mechanism::ALL.map(|mechanism| self.curve(mechanism)).to_vec();
        let right = blank(&self.upright);
        Plot { size: SIZE, level, left: self.upright.clone(), right, curves }
    }

    /// A curve, by steps of μ: from the left side of the frame to its top or its right side.
    fn curve(&self, mechanism: Mechanism) -> Curve {
        let friction = |inertia: f64| critical_friction(mechanism, inertia).map_or(0.0, |critical| critical.friction);
        let (low, high) = (friction(self.inertias.start), friction(self.inertias.end).min(self.upright.range.end));
        let at = |k: u32| {
            let mu = low + (high - low).max(0.0) * f64::from(k) / f64::from(STEPS);
            (critical_inertia_ratio(mechanism, mu).unwrap_or_default().max(self.inertias.start), mu)
        };
        let points = if low < high { (0..=STEPS).map(at).collect() } else { Vec::new() };
        let (shade, dashes) = style(mechanism.slots());
        Curve { points, side: Side::Left, shade, dashes }
    }

    /// μ* of the three at equal ratios of the inertias, and at those of the designs.
    fn rows(&self, designs: &[&Design]) -> Vec<[f64; 4]> {
        let Range { start, end } = self.inertias;
        let step = |k: u32| start * libm::exp(libm::log(end / start) * f64::from(k) / f64::from(STEPS));
        let mut inertias: Vec<f64> = (0..=STEPS).map(step).collect();
        inertias.extend(designs.iter().map(|design| design.inertia_ratio));
        inertias.sort_by(f64::total_cmp);
        inertias.dedup();
        let row = |inertia: f64| {
            let [a, b, c] =
                Mechanism::ALL.map(|mechanism| critical_friction(mechanism, inertia).map_or(0.0, |at| at.friction));
            [inertia, a, b, c]
        };
        inertias.into_iter().map(row).collect()
    }
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use crate::checks::{labels_inside, named, only_numbers, well_formed};
    use roxmltree::Document;

    fn design(name: &str, mechanism: Mechanism, inertia_ratio: f64, friction: f64) -> Design {
        Design { name: name.to_owned(), mechanism, inertia_ratio, friction }
    }

    /// Some designs, two of them close together.
    pub fn designs() -> Vec<Design> {
        vec![
            design("one", Mechanism::FOUR_PIN, 0.03, 0.125),
            design("another, close by", Mechanism::FOUR_PIN, 0.04, 0.2),
            design("six pins", Mechanism::SIX_PIN, 0.7, 0.375),
            design("three pins", Mechanism::THREE_PIN, 0.04, 0.25),
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
            assert!(!Design { friction: row[column] * 1.001, ..design }.is_sound());
        }
        // A curve's points are where μ is critical.
        let frame = Frame::new(&[]);
        for mechanism in Mechanism::ALL {
            for (inertia, friction) in &frame.curve(mechanism).points {
                let critical = critical_friction(mechanism, *inertia).expect("sound").friction;
                approx::assert_relative_eq!(critical, *friction, max_relative = 1e-9);
            }
        }
    }

    #[test]
    fn designs_far_off_widen_the_map_or_are_left_out() {
        let far = |inertia, friction| vec![design("far", Mechanism::THREE_PIN, inertia, friction)];
        for (marked, designs) in [
            (4, designs()),
            (0, vec![]),
            (1, far(3e-5, 0.0)),
            (1, far(900.0, 40.0)),
            (0, far(f64::NAN, 0.125)),
            (0, far(0.0, 0.125)),
            (0, far(1.0, f64::INFINITY)),
            (0, far(1.0, -0.125)),
        ] {
            let figure = existence(&designs);
            well_formed(&figure);
            only_numbers(&figure);
            labels_inside(&figure);
            let document = Document::parse(&figure.svg).expect("well-formed");
            assert_eq!(named(&document, "point").len(), marked, "{designs:?}");
        }
    }
}
