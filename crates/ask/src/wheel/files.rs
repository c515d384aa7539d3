//! Files from which a wheel is made.

use super::design::Design;
use super::kind::Kind;
use crate::Error;
use crate::written::as_typed;
use geneva_kinematics::wheel::{Edge, Face, Sizes};
use geneva_workshop::{Layout, Solid, dxf, scad, stl};

/// Chords leave their arcs by this part of the play at most; without play, by this part of the centre distance.
const OF_PLAY: f64 = 0.1;
const OF_CENTRE_DISTANCE: f64 = 1e-4;

/// Most corners of all outlines of a mesh, which has four triangles for each: more take more memory and time than a printer
/// has use for.
const MOST_CORNERS: f64 = 200_000.0;

/// The kinds of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum File {
    /// Outlines of all parts side by side, with true arcs.
    Dxf,
    /// A moving model for OpenSCAD.
    Scad,
    /// Meshes of the parts.
    Stl,
}

impl File {
    /// Its name, which is also the ending.
    pub fn name(self) -> &'static str {
        match self {
            Self::Dxf => "dxf",
            Self::Scad => "scad",
            Self::Stl => "stl",
        }
    }
}

impl Design {
    /// Refuses a file of a wheel that isn't external.
    ///
    /// # Errors
    ///
    /// What to choose instead.
    pub fn has_parts_for(&self, file: File) -> Result<(), Error> {
        let name = file.name();
        if self.wheel.kind() != Kind::External {
            return Err(refused!(
                "--format {name} is not available for {} wheels, whose parts are not worked out; choose --type external, or \
                 --format svg for a drawing",
                self.wheel.kind().name()
            ));
        }
        Ok(())
    }

    /// A file from which the wheel is made, in millimetres, if it is an external wheel with a size, and has a thickness where
    /// the file needs one.
    ///
    /// # Errors
    ///
    /// What is missing.
    pub fn file(&self, file: File) -> Result<String, Error> {
        self.has_parts_for(file)?;
        let name = file.name();
        let Some(sizes) = &self.sizes else {
            return Err(refused!(
                "--format {name} needs a size in mm; add --crank-radius MM, --centre-distance MM or --wheel-radius MM"
            ));
        };
        if file == File::Dxf {
            return Ok(dxf(sizes, Layout::Apart));
        }
        let Some(thickness) = self.question.thickness else {
            return Err(refused!("--format {name} needs a thickness; add --thickness MM"));
        };
        let solid = Solid { thickness, tolerance: tolerance(sizes) };
        let corners = if file == File::Stl { corners(sizes, solid.tolerance) } else { 0.0 };
        if corners > MOST_CORNERS {
            return Err(refused!(
                "--format stl, --play {}: with chords of a tenth of the play the outlines would have {corners:.0} corners, but \
                 at most {MOST_CORNERS} are written; give a larger --play or fewer --stations, or choose --format scad",
                as_typed(sizes.play.slot)
            ));
        }
        Ok(if file == File::Stl { stl(sizes, solid)? } else { scad(sizes, solid)? })
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
