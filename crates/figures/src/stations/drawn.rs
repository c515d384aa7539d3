//! What must hold of the drawings of wheels as they are written, read back from the SVG.

use super::{critical_geometry, extremes, indexing, mechanism, model, motion};
use crate::FigureError;
use crate::checks::{PIXELS, ParsedDrawing, assert_drawn, columns};
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::Wheel;

fn wheels() -> Vec<Wheel> {
    let all = (3..=18).flat_map(|stations| (1..=6).filter_map(move |pins| Wheel::with_pins(stations, pins).ok()));
    all.collect()
}

#[test]
fn every_wheel_is_drawn_light_and_in_true_numbers() {
    for wheel in wheels() {
        [mechanism(&wheel), critical_geometry(&wheel), indexing(&wheel), motion(&wheel)].iter().for_each(assert_drawn);
        for share in [-1.0, -0.4, 0.0, 0.7, 1.0] {
            assert_drawn(&model(&wheel, share * wheel.engagement_half_angle()).expect("engaged"));
        }
    }
    [3..=18, 3..=60, 5..=5, 0..=2].into_iter().for_each(|range| assert_drawn(&extremes(range)));
}

#[test]
fn an_angle_outside_the_engagement_has_no_triangle() {
    let wheel = Wheel::new(6).expect("possible");
    assert!(matches!(model(&wheel, 1.1), Err(FigureError::Wheel(_))));
}

#[test]
fn the_triangles_are_to_scale() {
    for wheel in wheels() {
        let (l, rim) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
        let figure = model(&wheel, 0.6 * wheel.engagement_half_angle()).expect("engaged");
        let drawing = ParsedDrawing::parse(&figure);
        let crank = drawing.number("pin-circle", "r");
        assert!((drawing.length("side-R") - crank).abs() < PIXELS);
        assert!((drawing.length("side-l") - l * crank).abs() < PIXELS + 0.01 * l);
        assert!(
            (drawing.length("side-r") - figure.series.value("r/R").expect("a side") * crank).abs() < PIXELS + 0.01 * l
        );

        let figure = critical_geometry(&wheel);
        let drawing = ParsedDrawing::parse(&figure);
        let [a, b, c] = ["side-R", "side-r", "side-l"].map(|side| drawing.length(side));
        assert!((a.hypot(b) - c).abs() < 2.0 * PIXELS, "a right angle at the pin");
        assert!((b / a - rim).abs() < PIXELS / a * (1.0 + rim) && (c / a - l).abs() < PIXELS / a * (1.0 + l));
        assert!((drawing.number("rim", "r") - b).abs() < PIXELS);
    }
}

#[test]
fn the_wheel_of_the_mechanism_is_to_scale_and_faces_the_driver() {
    for wheel in wheels() {
        let figure = mechanism(&wheel);
        let drawing = ParsedDrawing::parse(&figure);
        let (driver, crank) = (drawing.centre("pin-circle"), drawing.number("pin-circle", "r"));
        let outline = drawing.path("wheel", 0);
        let axis = driver.x - wheel.centre_distance_ratio() * crank;
        let from = |cx: f64| outline.iter().map(move |at| (at.x - cx).hypot(at.y - driver.y));
        let rounded = 2.0 * PIXELS + 0.01 * wheel.centre_distance_ratio();
        assert!((from(axis).fold(0.0, f64::max) - wheel.wheel_radius_ratio() * crank).abs() < rounded);
        // The nearest part of the wheel to the driver's axis is the locking arc that is centred there.
        let locking_disc = figure.series.value("locking disc/r").expect("a radius") * crank;
        assert!((from(driver.x).fold(f64::INFINITY, f64::min) - locking_disc).abs() < rounded);
        assert_eq!(drawing.count("pin") as u32, wheel.pins());
        assert_eq!(drawing.count("locking-disc"), usize::from(wheel.dwell_fraction() > 1e-9));
    }
}

#[test]
fn the_series_of_an_advance_is_symmetric_with_both_ends() {
    for wheel in wheels() {
        let rows = columns(&indexing(&wheel).series, ["theta", "phi", "phi'/theta'", "phi''/theta'^2"]);
        assert!(rows.len() >= 91);
        let [theta, phi, velocity, acceleration] = rows[0];
        approx::assert_relative_eq!(theta, -wheel.engagement_half_angle().to_degrees(), max_relative = 1e-14);
        approx::assert_relative_eq!(phi, -wheel.half_pitch_angle(), max_relative = 1e-13);
        assert_eq!(velocity, 0.0);
        approx::assert_relative_eq!(acceleration, wheel.entry_acceleration(), max_relative = 1e-11);
        for ([theta, phi, velocity, acceleration], mirror) in rows.iter().copied().zip(rows.iter().rev()) {
            assert_eq!([-theta, -phi, velocity, -acceleration], *mirror);
            assert!(velocity <= wheel.peak_velocity() * (1.0 + 1e-12));
            assert!(acceleration.abs() <= wheel.acceleration_peak().ratio * (1.0 + 1e-12));
        }
    }
    assert_eq!(indexing(&Wheel::new(4).expect("possible")).series.rows.len(), 91);
}

#[test]
fn the_jumps_are_drawn_where_there_is_a_dwell() {
    for wheel in wheels() {
        let figure = indexing(&wheel);
        let drawing = ParsedDrawing::parse(&figure);
        let dwells = 2 * usize::from(wheel.dwell_fraction() > 1e-9);
        assert_eq!(["indexing-end", "dwell-end", "jump"].map(|class| drawing.count(class)), [2, dwells, dwells]);
    }
}

#[test]
fn the_extremes_have_a_row_for_each_wheel_of_the_range() {
    let series = extremes(1..=18).series;
    assert_eq!(series.rows.len(), 16);
    for [motion, dwell, distance, radius] in columns(&series, ["motion", "dwell", "l/r", "wheel/r"]) {
        approx::assert_relative_eq!(motion + dwell, 1.0, max_relative = 1e-15);
        approx::assert_relative_eq!(distance, libm::hypot(1.0, radius), max_relative = 1e-14);
    }
    let names =
        ["N", "l/r", "wheel/r", "peak phi'/theta'", "entry phi''/theta'^2", "peak phi''/theta'^2", "theta of peak"];
    for [stations, distance, radius, velocity, entry, peak, angle] in columns(&series, names) {
        // Peak velocity is sin α / (1 − sin α), entry acceleration tan α: one over k − 1, one over the rim's radius.
        approx::assert_relative_eq!(velocity, 1.0 / (distance - 1.0), max_relative = 1e-12);
        approx::assert_relative_eq!(entry, 1.0 / radius, max_relative = 1e-12);
        assert!(peak > entry && angle > 0.0 && angle < 90.0 - 180.0 / stations);
    }
}

#[test]
fn the_moving_drawing_moves_only_where_motion_is_welcome_and_by_its_own_names() {
    for wheel in wheels() {
        let figure = motion(&wheel);
        let (before, welcome) =
            figure.svg.split_once("@media screen and (prefers-reduced-motion:no-preference)").expect("");
        assert!(!before.contains("animation:") && !before.contains("{{"));
        let rules = welcome.split_once("</style>").expect("one style").0;
        for part in ["wheel", "round", "driver"] {
            let name = format!("{}-{part}", figure.id);
            assert!(before.contains(&format!("@keyframes {name}{{")), "{name}");
            assert!(rules.contains(&format!(".{name}{{animation:{name} ")), "{name}");
            assert!(figure.svg.contains(&format!("class=\"{name}\"")), "{name}");
        }
        let keys = before.matches("%{transform:rotate(").count();
        assert_eq!(keys, figure.series.rows.len());
    }
}
