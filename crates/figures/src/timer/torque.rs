//! Hours and minutes that a timekeeper gains or loses in a day as its torque changes.

use super::{HOURS, MINUTES};
use crate::chart::{Chart, ChartAxis, LineStyle, Panel, Spot};
use crate::svg::Label;
use crate::theme::{DRIVER, FILL, FOLLOWER, INK};
use crate::{Figure, Series, Words};
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

/// From what part of the torque to what part the curves go, in per cent; the same of the panel of small changes.
const WIDE: [f64; 2] = [50.0, 110.0];
const NARROW: [f64; 2] = [95.0, 105.0];
const STEPS: u32 = 60;
/// The powers between which a verge with a drag lies, and the power of the law of similarity.
const VERGE: [f64; 2] = [1.0 / 3.0, 1.0];
const ROOT: f64 = 0.5;
/// Where the verge has its name: between these torques in per cent and at this gain in hours, which is inside its area.
pub(super) const NAMED: (Range<f64>, f64) = (52.0..62.0, -7.9);

/// What a timekeeper whose rate goes with this power of the torque gains in a day, in days: torque in per cent.
fn gained(torque: f64, power: f64) -> f64 {
    libm::pow(torque / 100.0, power) - 1.0
}

/// The gain in a day over the torque, in two panels: hours as a spring runs down, and minutes for small changes.
///
/// The curve is that of the law of similarity; the shaded area is that of a verge with a foliot and a drag in proportion to
/// its speed, whatever the drag. An oscillator with a period of its own stays on the axis. Series: torque in per cent, and
/// the gain in hours with the powers 1/2, 1/3 and 1.
pub fn torque() -> Figure {
    let torques = |[from, to]: [f64; 2]| (0..=STEPS).map(move |k| from + (to - from) * f64::from(k) / f64::from(STEPS));
    let panel = |range: [f64; 2], step: f64, unit: f64, height: f64, title: &str, last: bool| {
        let marks = (0..).map(|k| range[0] + step * f64::from(k)).take_while(|mark| *mark <= range[1]);
        let x = ChartAxis::whole(range[0]..range[1], marks);
        let x = if last { x.titled(Label::words("torque, % of the torque at which it was set")) } else { x };
        let ends = range.map(|torque| unit * gained(torque, VERGE[1]));
        let y = ChartAxis::from_zero(ends[0], ends[1], 4.0).titled(Label::words(title));
        let points = |power: f64| torques(range).map(move |torque| (torque, unit * gained(torque, power)));
        let mut back: Vec<_> = points(VERGE[1]).collect();
        back.reverse();
        Panel::new(height, &x, &y)
            .area(points(VERGE[0]).chain(back), FILL, "verge")
            .horizontal(0.0, LineStyle::new(FOLLOWER).class("own-period"))
            .curve(points(ROOT), LineStyle::new(DRIVER).class("root"))
    };
    let wide = panel(WIDE, 10.0, HOURS, 330.0, "gain, hours a day", false);
    let [from, to] = [66.0, 100.0];
    let wide = wide
        .name_near([(84.0, 0.0)], FRAC_PI_2, Label::words("with a period of its own").in_colour(FOLLOWER))
        .name_near([(from, HOURS * gained(from, ROOT))], FRAC_PI_2, Label::words("Geneva, runaway").in_colour(DRIVER))
        .name(Label::words("verge").in_colour(INK), Spot::Within(NAMED.0, NAMED.1));
    let narrow = panel(NARROW, 1.0, MINUTES, 270.0, "gain, minutes a day", true);
    let lost = -HOURS * gained(from, ROOT);
    let words = Words::new(
        "timer-torque",
        "What a timekeeper gains or loses in a day as the torque changes",
        format!(
            "Two panels over the torque. In both, a curve through the point where the timekeeper was set: with {from} per \
             cent of the torque it loses {} hours a day, and with one per cent less {} minutes. A shaded area about the \
             curve opens from the same point to either side. A level line at zero is for a clock whose pendulum, or balance \
             with a spring, is hardly disturbed by its escapement.",
            crate::number::significant(lost, 2),
            crate::number::significant(-MINUTES * gained(to - 1.0, ROOT), 2)
        ),
        "As the spring runs down, the Geneva escapement loses time, because its rate goes as the square root of the \
         torque, whatever its pins and inertias. (We assume a constant coefficient of friction and no constant or \
         viscous drag.) The same law holds for a runaway escapement in which blows take all the work. If a drag \
         proportional to the speed brakes a verge and foliot, the rate is somewhere in the shaded area, between the \
         cube root and the first power of the torque. A pendulum with a dead-beat escapement, or a balance and spring \
         with a detached one, nearly keeps its period, and its error is too small to be seen on this scale. The lower \
         panel shows small changes.",
    );
    let columns = [("torque", "%"), ("gain^1/2", "h"), ("gain^1/3", "h"), ("gain^1", "h")];
    let row = |torque: f64| {
        let of = |power: f64| HOURS * gained(torque, power);
        [torque, of(ROOT), of(VERGE[0]), of(VERGE[1])]
    };
    Chart::new([wide, narrow]).figure(words, Series::new(columns, torques(WIDE).map(row)))
}
