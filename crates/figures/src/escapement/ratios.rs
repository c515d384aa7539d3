//! The follower's speed over the driver's through one engagement.

use crate::chart::{Chart, ChartAxis, LegendEntry, MarkShape, Marker, Panel, of_mechanism};
use crate::number::{format_trimmed, significant};
use crate::svg::Label;
use crate::{Figure, Series, Words};
use geneva_kinematics::Mechanism;
use geneva_kinematics::indexing::Indexing;
use std::f64::consts::FRAC_PI_2;

/// Steps from entry to exit; an even number.
const STEPS: u32 = 160;

/// φ'/θ' of each escapement over θ / (π/m), from entry to exit.
///
/// The mean of each curve is m/n turns of the follower per turn of the driver. The square of the ratio is the weight of
/// the follower's inertia in the kinetic energy: I_D + (φ'/θ')² I_f. Series: θ/(π/m), then for each escapement φ'/θ'
/// and its square.
pub fn ratios(escapements: &[Mechanism]) -> Figure {
    let rows: Vec<Vec<f64>> = (0..=STEPS).map(|k| row(escapements, k)).collect();
    let peak = |one: &Mechanism| one.wheel().peak_velocity();
    let greatest = escapements.iter().map(peak).fold(1e-3, f64::max);
    let angle = Label::words("driver angle ").and_symbol("θ").and(" / (π/").and_symbol("m").and("): entry −1, exit 1");
    let x = ChartAxis { decimals: 1, ..ChartAxis::whole(-1.0..1.0, [-1.0, -0.5, 0.0, 0.5, 1.0]) };
    let ratio = Label::words("speed of the follower over the driver's, ").and_rate("φ", 1).and(" / ").and_rate("θ", 1);
    let y = ChartAxis::from_zero(0.0, greatest, 4.0).titled(ratio);
    let mut panel = Panel::new(366.0, &x.titled(angle), &y);
    let mut key = Vec::new();
    for (k, one) in escapements.iter().enumerate() {
        let (stroke, _) = of_mechanism(one.slots());
        panel = panel.curve(rows.iter().map(|row| (row[0], row[1 + 2 * k])), stroke);
        let name = format!("{} pins, {} slots: mean {}", one.pins(), one.slots(), mean(one));
        key.push(LegendEntry::curve(stroke, Label::words(&name).in_colour(stroke.colour)));
    }
    for one in escapements {
        let colour = of_mechanism(one.slots()).0.colour;
        panel = panel.marks([(0.0, peak(one))], Marker::new(colour, MarkShape::Disc).class("peak"));
        let label = Label::words(&significant(peak(one), 3)).in_colour(colour);
        panel = panel.name_near([(0.0, peak(one))], FRAC_PI_2, label);
    }

    let columns = escapements.iter().flat_map(|one| {
        let n = one.slots();
        [(format!("phi'/theta' n={n}"), "1"), (format!("squared n={n}"), "1")]
    });
    let columns = std::iter::once(("theta/(pi/m)".to_owned(), "1")).chain(columns);
    let series = Series::of_columns(columns, rows.clone());
    let ratios: Vec<String> = escapements.iter().map(peak_and_mean).collect();
    let words = Words::new(
        "escapement-ratios",
        "The follower's speed over the driver's through one engagement",
        format!(
            "Curves over the driver angle in parts of its half angle, from −1, entry, to 1, exit. Each is symmetric, \
             zero at both ends and greatest on the line of centres. {}.",
            ratios.join("; ")
        ),
        "The follower's speed divided by the driver's. This ratio depends on the geometry alone. It is zero at every \
         hand-over and greatest on the line of centres. A follower with few slots moves in short bursts, while a \
         follower with more slots moves gently. The ratio never changes sign, so the follower slows down but never \
         reverses. The mean of the ratio is m/N, the number of pins divided by the number of slots.",
    );
    Chart::new([panel]).key(key).figure(words, series)
}

/// θ/(π/m), and for each escapement the ratio and its square.
fn row(escapements: &[Mechanism], k: u32) -> Vec<f64> {
    // Both halves have the same angles.
    let share = (2.0 * f64::from(k) - f64::from(STEPS)) / f64::from(STEPS);
    let ratio = |one: &Mechanism| one.wheel().velocity_ratio(share * one.engagement_half_angle()).unwrap_or_default();
    let both = |ratio: f64| [ratio, ratio * ratio];
    std::iter::once(share).chain(escapements.iter().flat_map(|one| both(ratio(one)))).collect()
}

fn mean(one: &Mechanism) -> String {
    format_trimmed(f64::from(one.pins()) / f64::from(one.slots()), 3)
}

fn peak_and_mean(one: &Mechanism) -> String {
    let peak = significant(one.wheel().peak_velocity(), 4);
    format!("{} slots, {} pins: greatest {peak}, mean {}", one.slots(), one.pins(), mean(one))
}
