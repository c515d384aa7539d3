//! What the size of a wheel decides: the force of its pin, the torque at the crank and the wheel's own inertia.

use crate::chart::{Chart, ChartAxis, LineStyle, MarkShape, Marker, Panel};
use crate::svg::Label;
use crate::theme::{Colour, DRIVER, FOLLOWER, RELATIVE};
use crate::{Figure, ItemValue, Series, Words};

/// The loads of a wheel of one size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadsAtSize {
    /// Crank radius, in millimetres.
    pub crank_radius: f64,
    /// Greatest force of the pin, in N.
    pub pin_force: f64,
    /// Greatest torque at the crank, in N m.
    pub crank_torque: f64,
    /// Moment of inertia of the wheel itself, in kg m².
    pub wheel_inertia: f64,
    /// Moment of inertia of the wheel and everything that turns with it, in kg m².
    pub inertia: f64,
}

type Curve = (ItemValue<LoadsAtSize>, Colour, &'static str, &'static str);

const CURVES: [Curve; 3] = [
    (|at| at.pin_force, RELATIVE, "pin force", "N"),
    (|at| at.crank_torque, DRIVER, "crank torque", "N m"),
    (|at| 100.0 * at.wheel_inertia / at.inertia, FOLLOWER, "own share of the inertia", "%"),
];

/// Force, torque and own inertia over the crank radius, with the size that was chosen. None where fewer than two sizes have loads.
///
/// Series: crank radius in mm, force in N, torque in N m, own inertia and all inertia in kg mm².
pub fn over_sizes(sizes: &[LoadsAtSize], chosen: f64) -> Option<Figure> {
    let (first, last) = (sizes.first()?.crank_radius, sizes.last()?.crank_radius);
    if first >= last {
        return None;
    }
    let x = ChartAxis::from_zero(0.0, last, 5.0);
    let nearest =
        sizes.iter().min_by(|a, b| (a.crank_radius - chosen).abs().total_cmp(&(b.crank_radius - chosen).abs()))?;
    let panel = |at: usize, (value, colour, name, unit): Curve| {
        let points = || sizes.iter().map(|size| (size.crank_radius, value(size)));
        let y = ChartAxis::from_zero(0.0, points().map(|(_, y)| y).fold(0.0, f64::max), 4.0)
            .titled(Label::words(name).and(&format!(", {unit}")));
        let x = if at + 1 == CURVES.len() {
            x.clone().titled(Label::words("crank radius, mm"))
        } else {
            x.clone().unnumbered()
        };
        Panel::new(150.0, &x, &y)
            .curve(points(), LineStyle::new(colour).wide(2.0))
            .marks([(nearest.crank_radius, value(nearest))], Marker::new(colour, MarkShape::Disc).class("chosen"))
    };
    let panels: Vec<Panel> = CURVES.into_iter().enumerate().map(|(at, curve)| panel(at, curve)).collect();
    let words = Words::new(
        "wheel-over-sizes",
        "Loads of a wheel over its size".to_owned(),
        "Three panels against the crank radius. The force of the pin falls steeply at small sizes, and rises again where the \
         wheel's own inertia is large. The torque at the crank and the wheel's own share of the inertia only rise. A mark stands at the chosen \
         size.",
        "Loads over the size of the wheel; a mark stands at the chosen size.",
    );
    let series = Series::of_items(
        sizes,
        [
            ("R", "mm", |at: &LoadsAtSize| at.crank_radius),
            ("force", "N", |at| at.pin_force),
            ("torque", "N m", |at| at.crank_torque),
            ("own inertia", "kg mm²", |at| 1e6 * at.wheel_inertia),
            ("inertia", "kg mm²", |at| 1e6 * at.inertia),
        ],
    );
    Some(Chart::new(panels).figure(words, series))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::{ParsedDrawing, assert_sound};

    #[test]
    fn each_panel_has_a_mark_at_the_chosen_size_and_one_size_is_no_curve() {
        let at = |crank_radius: f64| LoadsAtSize {
            crank_radius,
            pin_force: 300.0 / crank_radius + 0.01 * crank_radius * crank_radius,
            crank_torque: 1.0 + crank_radius / 50.0,
            wheel_inertia: 1e-9 * crank_radius.powi(5),
            inertia: 1e-9 * crank_radius.powi(5) + 1.0,
        };
        let sizes: Vec<_> = (1..=10).map(|k| at(10.0 * f64::from(k))).collect();
        let figure = over_sizes(&sizes, 42.0).expect("a figure");
        assert_sound(&figure);
        assert_eq!(ParsedDrawing::parse(&figure).count("chosen"), 3);
        assert!(over_sizes(&sizes[..1], 10.0).is_none());
    }
}
