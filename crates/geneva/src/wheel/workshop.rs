//! Files from which a wheel is made.

use super::kind::Kind;
use super::made::Made;
use crate::arguments::Format;
use crate::typed::as_typed;
use anyhow::{bail, ensure};
use geneva_kinematics::wheel::{Edge, Face, Sizes};
use geneva_workshop::{Layout, Solid, dxf, scad, stl};

/// Chords leave their arcs by this part of the play at most; without play, by this part of the centre distance.
const OF_PLAY: f64 = 0.1;
const OF_CENTRE_DISTANCE: f64 = 1e-4;

/// Most corners of all outlines of a mesh, which has four triangles for each: more take more memory and time than a printer
/// has use for.
const MOST_CORNERS: f64 = 200_000.0;

/// Whether this format is available for this kind of wheel; files for machines are for external wheels only.
pub fn makes(kind: Kind, format: Format) -> anyhow::Result<()> {
    ensure!(
        kind == Kind::External || !matches!(format, Format::Dxf | Format::Scad | Format::Stl),
        "--format {} is not available for {} wheels, whose parts are not worked out; choose --type external, or --format svg \
         for a drawing",
        format.name(),
        kind.name()
    );
    Ok(())
}

/// The file of a sized external wheel, of parts so many millimetres thick where it needs that.
pub fn file(made: &Made, thickness: Option<f64>, format: Format) -> anyhow::Result<String> {
    let name = format.name();
    let Some(sizes) = &made.sizes else {
        bail!("--format {name} needs a size in mm; add --crank-radius MM, --centre-distance MM or --wheel-radius MM");
    };
    if format == Format::Dxf {
        return Ok(dxf(sizes, Layout::Apart));
    }
    let Some(thickness) = thickness else {
        bail!("--format {name} needs a thickness; add --thickness MM");
    };
    let solid = Solid { thickness, tolerance: tolerance(sizes) };
    let corners = if format == Format::Stl { corners(sizes, solid.tolerance) } else { 0.0 };
    ensure!(
        corners <= MOST_CORNERS,
        "--format stl, --play {}: with chords of a tenth of the play the outlines would have {corners:.0} corners, but at \
         most {MOST_CORNERS} are written; give a larger --play or fewer --stations, or choose --format scad",
        as_typed(sizes.play.slot)
    );
    Ok(if format == Format::Stl { stl(sizes, solid)? } else { scad(sizes, solid)? })
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
