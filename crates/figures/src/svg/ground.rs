//! The ground of a label: the faces below it, whose colours its halo has.

use super::view::Pixels;
use crate::number::format_trimmed;
use crate::theme::{Colour, FACE, FACE_SHARE, FILL, PAPER};

/// Shares of a label's width and height at which it is asked what is below.
const ACROSS: [f64; 5] = [0.5, 0.1, 0.3, 0.7, 0.9];
const DOWN: [f64; 3] = [0.5, 0.15, 0.85];

/// The inside of a closed outline.
#[derive(Clone, Debug)]
pub(crate) enum Area {
    /// A disc, by its centre and its radius.
    Disc(Pixels, f64),
    /// What is within an odd number of outlines.
    Loops(Vec<Vec<Pixels>>),
}

impl Area {
    fn contains(&self, at: &Pixels) -> bool {
        match self {
            Self::Disc(centre, radius) => (at - centre).norm() < *radius,
            Self::Loops(loops) => loops.iter().filter(|outline| is_within(at, outline)).count() % 2 == 1,
        }
    }
}

fn is_within(at: &Pixels, outline: &[Pixels]) -> bool {
    let nexts = outline.iter().cycle().skip(1);
    let crossed = outline
        .iter()
        .zip(nexts)
        .filter(|(a, b)| (a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y));
    crossed.count() % 2 == 1
}

/// A filled shape.
#[derive(Clone, Debug)]
pub(crate) struct FilledShape {
    pub area: Area,
    pub colour: Colour,
    /// How much it covers of what is below, between 0 and 1.
    pub share: f64,
}

/// The colour of what is below a label between two corners: of the faces that are under most of it.
///
/// The fully covering colours of arrow heads and dots are no ground: a label covers them.
pub(super) fn ground_colour(faces: &[FilledShape], corners: &[Pixels; 2]) -> String {
    let under = |place: Pixels| faces.iter().filter(move |face| face.area.contains(&place));
    let grounds = counted(corners, |place| under(place).fold(PAPER.0.to_owned(), over));
    let most = grounds.iter().map(|(_, count)| *count).max();
    grounds.into_iter().find(|(_, count)| Some(*count) == most).map_or(PAPER.0.to_owned(), |(ground, _)| ground)
}

/// How much of a label between two corners is beyond the ground under most of it, between 0 and 1.
pub(super) fn overhang(faces: &[FilledShape], corners: &[Pixels; 2]) -> f64 {
    let grounds = counted(corners, |place| {
        let under = faces.iter().enumerate().filter(|(_, face)| face.area.contains(&place));
        under.fold(Vec::new(), |mut under, (k, face)| {
            match face.colour {
                PAPER => under.clear(),
                FILL => under.push(k),
                _ if face.share < 1.0 => under.push(k),
                _ => {}
            }
            under
        })
    });
    let most = grounds.iter().map(|(_, count)| *count).max().unwrap_or_default();
    1.0 - most as f64 / grounds.iter().map(|(_, count)| *count).sum::<usize>() as f64
}

/// What is found at places all over a label between two corners, and at how many of them.
fn counted<T: PartialEq>([least, greatest]: &[Pixels; 2], at: impl Fn(Pixels) -> T) -> Vec<(T, usize)> {
    let size = greatest - least;
    let places =
        DOWN.iter().flat_map(|down| ACROSS.map(|across| least + size.component_mul(&Pixels::new(across, *down))));
    let mut found: Vec<(T, usize)> = Vec::new();
    for what in places.map(at) {
        match found.iter_mut().find(|(known, _)| *known == what) {
            Some((_, count)) => *count += 1,
            None => found.push((what, 1)),
        }
    }
    found
}

/// The colour of a ground with a face over it.
fn over(ground: String, FilledShape { colour, share, .. }: &FilledShape) -> String {
    let mixed = |colour: &str, share: f64| {
        let percent = format_trimmed(100.0 * share, 1);
        if share < 1.0 { format!("color-mix(in srgb, {colour} {percent}%, {ground})") } else { colour.to_owned() }
    };
    match *colour {
        PAPER => PAPER.0.to_owned(),
        FILL => mixed(&format!("color-mix(in srgb, {} {FACE_SHARE}, {ground})", FACE.0), *share),
        Colour(name) if *share < 1.0 => mixed(name, *share),
        _ => ground,
    }
}

#[cfg(test)]
mod tests {
    use super::super::path::Path;
    use super::super::shape::Shape;
    use super::*;
    use crate::theme::{DRIVER, INK};

    fn square(from: f64, to: f64) -> Shape {
        let corners = [[from, from], [to, from], [to, to], [from, to]].map(Pixels::from);
        Shape::path(Path::through(&corners, 2))
    }

    fn under(shapes: &[Shape], least: [f64; 2], greatest: [f64; 2]) -> String {
        let faces: Vec<FilledShape> = shapes.iter().filter_map(Shape::face).collect();
        ground_colour(&faces, &[least.into(), greatest.into()])
    }

    #[test]
    fn a_label_stands_on_the_faces_under_most_of_it() {
        let wheel = square(0.0, 100.0).fill(FILL);
        let face = "color-mix(in srgb, var(--fig-face, #e9eff6) var(--fig-share, 100%), var(--fig-paper, #ffffff))";
        assert_eq!(under(std::slice::from_ref(&wheel), [10.0, 10.0], [40.0, 30.0]), face);
        assert_eq!(under(std::slice::from_ref(&wheel), [90.0, 10.0], [190.0, 30.0]), PAPER.0);
        let driver = square(0.0, 50.0).tint(DRIVER, 0.12);
        let both = under(&[wheel.clone(), driver], [10.0, 10.0], [40.0, 30.0]);
        assert_eq!(both, format!("color-mix(in srgb, {} 12%, {face})", DRIVER.0));
        // A pin of the paper's colour hides what is below it; an arrow head is below the label.
        assert_eq!(under(&[wheel.clone(), square(5.0, 45.0).fill(PAPER)], [10.0, 10.0], [40.0, 30.0]), PAPER.0);
        assert_eq!(under(&[wheel, square(5.0, 45.0).fill(INK)], [10.0, 10.0], [40.0, 30.0]), face);
        assert_eq!(under(&[square(0.0, 50.0)], [10.0, 10.0], [40.0, 30.0]), PAPER.0);
    }

    #[test]
    fn a_label_across_an_edge_is_partly_astray() {
        let faces: Vec<FilledShape> = [square(0.0, 100.0).fill(FILL)].iter().filter_map(Shape::face).collect();
        let overhang = |least: f64| overhang(&faces, &[[least, 10.0].into(), [least + 100.0, 30.0].into()]);
        assert_eq!([0.0, 100.0].map(overhang), [0.0, 0.0]);
        approx::assert_relative_eq!(overhang(40.0), 0.4, max_relative = 1e-12);
        approx::assert_relative_eq!(overhang(80.0), 0.2, max_relative = 1e-12);
    }

    #[test]
    fn the_inside_of_a_disc_and_the_hole_of_a_ring_are_told_apart() {
        let disc = Shape::circle(&Pixels::new(50.0, 50.0), 20.0).tint(DRIVER, 0.5);
        let tinted = format!("color-mix(in srgb, {} 50%, {})", DRIVER.0, PAPER.0);
        assert_eq!(under(&[disc], [45.0, 45.0], [55.0, 55.0]), tinted);
        let at = |x: f64, y: f64| Pixels::new(x, y);
        let ring = [(0.0, 100.0), (20.0, 80.0)].into_iter().fold(Path::empty(2), |path, (a, b)| {
            path.again_at(&at(a, a)).line_to(&at(b, a)).line_to(&at(b, b)).line_to(&at(a, b)).close()
        });
        assert_eq!(under(&[Shape::path(ring.clone()).tint(DRIVER, 0.5)], [2.0, 2.0], [12.0, 12.0]), tinted);
        assert_eq!(under(&[Shape::path(ring).tint(DRIVER, 0.5)], [40.0, 40.0], [60.0, 60.0]), PAPER.0);
    }
}
