//! Files from which a wheel is made.

use super::design::WheelDesign;
use super::kind::WheelKind;
use crate::Error;
use crate::number_format::as_typed;
use geneva_kinematics::wheel::{Edge, Face, Sizes};
use geneva_workshop::{PartLayout, Solid, dxf, scad, stl};

/// Chords leave their arcs by this part of the play at most; without play, by this part of the centre distance.
const OF_PLAY: f64 = 0.1;
const OF_CENTRE_DISTANCE: f64 = 1e-4;

/// Most corners of all outlines of a mesh, which has four triangles for each: more take more memory and time than a printer
/// has use for.
const MOST_CORNERS: f64 = 200_000.0;

/// A file from which a wheel is made.
#[derive(Clone, Copy, Debug)]
pub struct ShapeFile {
    /// Its name with its ending.
    pub name: &'static str,
    /// What it is.
    pub label: &'static str,
    /// Whether it needs the parts of an external wheel with a size.
    pub needs_parts: bool,
    /// Makes it.
    pub make: fn(&WheelDesign) -> Result<Vec<u8>, Error>,
}

/// All files from which a wheel is made: what the command writes to a folder and the page offers.
pub const SHAPE_FILES: &[ShapeFile] = &[
    ShapeFile {
        name: "drawing.svg",
        label: "Drawing with sizes (SVG)",
        needs_parts: false,
        make: |design| Ok(design.drawing().standalone().into_bytes()),
    },
    ShapeFile {
        name: "wheel.dxf",
        label: "Outlines for the machine (DXF)",
        needs_parts: true,
        make: |design| design.dxf().map(String::into_bytes),
    },
    ShapeFile {
        name: "wheel.stl",
        label: "Meshes for a printer (STL)",
        needs_parts: true,
        make: |design| design.stl().map(String::into_bytes),
    },
    ShapeFile {
        name: "wheel.scad",
        label: "Moving model (OpenSCAD)",
        needs_parts: true,
        make: |design| design.scad().map(String::into_bytes),
    },
];

impl WheelDesign {
    /// Whether there is what a file needs.
    pub fn can_make(&self, file: &ShapeFile) -> bool {
        !file.needs_parts || self.sizes.is_some()
    }

    /// Outlines of all parts side by side, in millimetres, with true arcs.
    ///
    /// # Errors
    ///
    /// A wheel that isn't external, or has no size.
    pub fn dxf(&self) -> Result<String, Error> {
        Ok(dxf(self.parts("dxf")?, PartLayout::Apart))
    }

    /// A moving model for OpenSCAD, in millimetres.
    ///
    /// # Errors
    ///
    /// A wheel that isn't external, or has no size or no thickness.
    pub fn scad(&self) -> Result<String, Error> {
        let sizes = self.parts("scad")?;
        Ok(scad(sizes, self.solid("scad", sizes)?)?)
    }

    /// Meshes of the parts, in millimetres.
    ///
    /// # Errors
    ///
    /// A wheel that isn't external, has no size or no thickness, or takes more corners than a printer has use for.
    pub fn stl(&self) -> Result<String, Error> {
        let sizes = self.parts("stl")?;
        let solid = self.solid("stl", sizes)?;
        let corners = corners(sizes, solid.tolerance);
        if corners > MOST_CORNERS {
            return Err(refused!(
                "--format stl, --play {}: with chords of a tenth of the play the outlines would have {corners:.0} corners, but \
                 at most {MOST_CORNERS} are written; give a larger --play or fewer --stations, or choose --format scad",
                as_typed(sizes.play.slot)
            ));
        }
        Ok(stl(sizes, solid)?)
    }

    /// Refuses a file with this ending of a wheel that isn't external.
    ///
    /// # Errors
    ///
    /// What to choose instead.
    pub fn require_external(&self, ending: &str) -> Result<(), Error> {
        if self.wheel.kind() == WheelKind::External {
            return Ok(());
        }
        Err(refused!(
            "--format {ending} is not available for {} wheels, whose parts are not worked out; choose --type external, or \
             --format svg for a drawing",
            self.wheel.kind().name()
        ))
    }

    fn parts(&self, ending: &str) -> Result<&Sizes, Error> {
        self.require_external(ending)?;
        self.sizes.as_ref().ok_or_else(|| {
            refused!(
                "--format {ending} needs a size in mm; add --crank-radius MM, --centre-distance MM or --wheel-radius MM"
            )
        })
    }

    fn solid(&self, ending: &str, sizes: &Sizes) -> Result<Solid, Error> {
        let thickness =
            self.thickness.ok_or_else(|| refused!("--format {ending} needs a thickness; add --thickness MM"))?;
        Ok(Solid { thickness, tolerance: tolerance(sizes) })
    }
}

/// How many corners the outlines of both parts have as polygons: counted before any is made.
fn corners(sizes: &Sizes, tolerance: f64) -> f64 {
    let outline = sizes.outline();
    let faces = [Some(&outline.wheel), Some(&outline.plate), outline.disc.as_ref()];
    let loops = faces.into_iter().flatten().flat_map(Face::loops).chain(&outline.pins);
    let of = |edge: &Edge| match edge {
        Edge::Line { .. } => 1.0,
        // A chord of the angle x leaves its arc by r (1 − cos(x/2)).
        Edge::Arc { radius, sweep, .. } => (sweep.abs() / (8.0 * tolerance / radius).sqrt()).max(1.0),
    };
    loops.flat_map(|of| &of.edges).map(of).sum()
}

/// How far a chord may leave its arc, in millimetres.
fn tolerance(sizes: &Sizes) -> f64 {
    let play = sizes.play.slot;
    if play > 0.0 { OF_PLAY * play } else { OF_CENTRE_DISTANCE * sizes.centre_distance }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wheel::WheelQuestion;

    #[test]
    fn corners_are_as_many_as_a_mesh_has() {
        for (stations, thickness) in [(4, 6.0), (6, 10.0), (11, 3.0)] {
            let question = WheelQuestion {
                stations: Some(stations),
                crank_radius: Some(40.0),
                thickness: Some(thickness),
                ..WheelQuestion::default()
            };
            let design = WheelDesign::new(question).expect("a wheel");
            let sizes = design.sizes.expect("sizes");
            let triangles = design.stl().expect("meshes").matches("facet normal").count();
            // Four for each corner of a face: two on its wall, one on either side.
            let counted = 4.0 * corners(&sizes, tolerance(&sizes));
            assert!((counted / triangles as f64 - 1.0).abs() < 0.1, "{stations}: {counted} and {triangles}");
        }
    }
}
