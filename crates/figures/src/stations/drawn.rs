//! What must hold of the drawings of wheels as they are written, read back from the SVG.

use super::{advance, critical_geometry, extremes, mechanism, model, motion};
use crate::Figure;
use crate::checks::{corners, length, named, number, only_numbers, well_formed};
use geneva_kinematics::KinematicsError;
use geneva_kinematics::wheel::{Wheel, acceleration_peak, entry_acceleration, peak_velocity};
use roxmltree::Document;
use std::collections::BTreeSet;

/// Half a unit of the last written digit of a coordinate, in each of a length's four coordinates, with room to spare.
const PIXELS: f64 = 0.02;

fn wheels() -> Vec<Wheel> {
    let all = (3..=18).flat_map(|stations| (1..=6).filter_map(move |pins| Wheel::with_pins(stations, pins).ok()));
    all.collect()
}

fn all(wheel: &Wheel) -> Vec<Figure> {
    let half = wheel.engagement_half_angle();
    let mut figures = vec![mechanism(wheel), critical_geometry(wheel), advance(wheel), motion(wheel)];
    figures.extend([-1.0, -0.4, 0.0, 0.7, 1.0].map(|share| model(wheel, share * half).expect("engaged")));
    figures
}

#[test]
fn every_figure_is_well_formed_in_true_numbers_and_small() {
    let mut ids = BTreeSet::new();
    for wheel in wheels() {
        for (k, figure) in all(&wheel).iter().enumerate() {
            well_formed(figure);
            only_numbers(figure);
            let most = if figure.id.starts_with("wheel-motion") { 32_000 } else { 17_000 };
            assert!(figure.svg.len() < most, "{}: {} bytes", figure.id, figure.svg.len());
            assert!(ids.insert(figure.id.clone()) || k > 4, "{} twice", figure.id);
        }
    }
    for range in [3..=18, 3..=60, 5..=5, 0..=2] {
        well_formed(&extremes(range.clone()));
        only_numbers(&extremes(range));
    }
}

#[test]
fn drawing_twice_gives_the_same_bytes() {
    let wheel = Wheel::with_pins(6, 2).expect("possible");
    assert_eq!(all(&wheel), all(&wheel));
}

#[test]
fn an_angle_outside_the_engagement_has_no_triangle() {
    let wheel = Wheel::new(6).expect("possible");
    assert!(matches!(model(&wheel, 1.1), Err(KinematicsError::OutsideEngagement { .. })));
}

#[test]
fn the_triangles_are_to_scale() {
    for wheel in wheels() {
        let (l, rim) = (wheel.centre_distance_ratio(), wheel.wheel_radius_ratio());
        let figure = model(&wheel, 0.6 * wheel.engagement_half_angle()).expect("engaged");
        let document = Document::parse(&figure.svg).expect("well-formed");
        let side = |class: &str| length(&named(&document, class)[0]);
        let crank = number(&named(&document, "pin-circle")[0], "r");
        assert!((side("side-r") - crank).abs() < PIXELS);
        assert!((side("side-l") - l * crank).abs() < PIXELS + 0.01 * l);
        assert!((side("side-x") - figure.series.rows[0][2] * crank).abs() < PIXELS + 0.01 * l);

        let figure = critical_geometry(&wheel);
        let document = Document::parse(&figure.svg).expect("well-formed");
        let [a, b, c] = ["side-1", "side-rim", "side-l"].map(|class| length(&named(&document, class)[0]));
        assert!((a.hypot(b) - c).abs() < 2.0 * PIXELS, "a right angle at the pin");
        assert!((b / a - rim).abs() < PIXELS / a * (1.0 + rim) && (c / a - l).abs() < PIXELS / a * (1.0 + l));
        assert!((number(&named(&document, "rim")[0], "r") - b).abs() < PIXELS);
    }
}

#[test]
fn the_wheel_of_the_mechanism_is_to_scale_and_faces_the_driver() {
    for wheel in wheels() {
        let figure = mechanism(&wheel);
        let document = Document::parse(&figure.svg).expect("well-formed");
        let circle = named(&document, "pin-circle")[0];
        let [x, y, crank] = ["cx", "cy", "r"].map(|name| number(&circle, name));
        let outline = corners(named(&document, "wheel")[0].attribute("d").expect("a path"), 0.1);
        let axis = x - wheel.centre_distance_ratio() * crank;
        let from = |cx: f64| outline.iter().map(move |at| (at.x - cx).hypot(at.y - y));
        let rounded = 2.0 * PIXELS + 0.01 * wheel.centre_distance_ratio();
        assert!((from(axis).fold(0.0, f64::max) - wheel.wheel_radius_ratio() * crank).abs() < rounded);
        // The nearest part of the wheel to the driver's axis is the locking arc that is centred there.
        let journal = figure.series.rows[0][5] * crank;
        assert!((from(x).fold(f64::INFINITY, f64::min) - journal).abs() < rounded);
        assert_eq!(named(&document, "pin").len() as u32, wheel.pins());
        assert_eq!(named(&document, "journal").len(), usize::from(wheel.dwell_fraction() > 1e-9));
    }
}

#[test]
fn the_series_of_an_advance_is_symmetric_with_both_ends() {
    for wheel in wheels() {
        let series = advance(&wheel).series;
        let (rows, last) = (&series.rows, series.rows.len() - 1);
        assert!(rows.len() >= 91);
        approx::assert_relative_eq!(rows[0][0], -wheel.engagement_half_angle().to_degrees(), max_relative = 1e-14);
        approx::assert_relative_eq!(rows[0][1], -wheel.half_station(), max_relative = 1e-13);
        approx::assert_relative_eq!(rows[0][3], entry_acceleration(&wheel), max_relative = 1e-11);
        for (k, row) in rows.iter().enumerate() {
            let mirror = &rows[last - k];
            assert_eq!([row[0], row[1], row[2], row[3]], [-mirror[0], -mirror[1], mirror[2], -mirror[3]]);
            assert!(row[2] <= peak_velocity(&wheel) * (1.0 + 1e-12));
            assert!(row[3].abs() <= acceleration_peak(&wheel).ratio * (1.0 + 1e-12));
        }
        assert_eq!([rows[0][2], rows[last][2]], [0.0, 0.0]);
    }
    assert_eq!(advance(&Wheel::new(4).expect("possible")).series.rows.len(), 91);
}

#[test]
fn the_jumps_are_drawn_where_there_is_a_dwell() {
    for wheel in wheels() {
        let figure = advance(&wheel);
        let document = Document::parse(&figure.svg).expect("well-formed");
        let dwells = 2 * usize::from(wheel.dwell_fraction() > 1e-9);
        assert_eq!(named(&document, "advance-end").len(), 2);
        assert_eq!([named(&document, "dwell-end").len(), named(&document, "jump").len()], [dwells; 2]);
    }
}

#[test]
fn the_extremes_have_a_row_for_each_wheel_of_the_range() {
    let rows = extremes(1..=18).series.rows;
    assert_eq!(rows.len(), 16);
    for row in &rows {
        approx::assert_relative_eq!(row[1] + row[2], 1.0, max_relative = 1e-15);
        approx::assert_relative_eq!(row[3], libm::hypot(1.0, row[4]), max_relative = 1e-14);
        // Peak velocity is sin α / (1 − sin α), entry acceleration tan α: one over k − 1, one over the rim's radius.
        approx::assert_relative_eq!(row[5], 1.0 / (row[3] - 1.0), max_relative = 1e-12);
        approx::assert_relative_eq!(row[6], 1.0 / row[4], max_relative = 1e-12);
        assert!(row[7] > row[6] && row[8] > 0.0 && row[8] < 90.0 - 180.0 / row[0]);
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
