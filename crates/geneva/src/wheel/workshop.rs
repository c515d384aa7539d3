//! Files from which a wheel is made.

use super::kind::Kind;
use super::made::Made;
use crate::arguments::Format;
use anyhow::{bail, ensure};
use geneva_kinematics::wheel::Sizes;
use geneva_workshop::{Layout, Solid, dxf, scad, stl};

/// Chords leave their arcs by this part of the play at most; without play, by this part of the centre distance.
const OF_PLAY: f64 = 0.1;
const OF_CENTRE_DISTANCE: f64 = 1e-4;

/// Whether this format can be had of this kind of wheel: files for machines are of external ones.
pub fn makes(kind: Kind, format: Format) -> anyhow::Result<()> {
    ensure!(
        kind == Kind::External || !matches!(format, Format::Dxf | Format::Scad | Format::Stl),
        "--format {}: there are no parts of {} wheels to make; give --type external, or --format svg for a drawing",
        format.name(),
        kind.name()
    );
    Ok(())
}

/// The file of a sized external wheel, of parts so many millimetres thick where it needs that.
pub fn file(made: &Made, thickness: Option<f64>, format: Format) -> anyhow::Result<String> {
    let name = format.name();
    let Some(sizes) = &made.sizes else {
        bail!(
            "--format {name}: parts are made in mm; give a size with it: --crank-radius MM, --centre-distance MM or \
             --wheel-radius MM"
        );
    };
    if format == Format::Dxf {
        return Ok(dxf(sizes, Layout::Apart));
    }
    let Some(thickness) = thickness else {
        bail!("--format {name}: a solid has a thickness; give --thickness MM with it");
    };
    let solid = Solid { thickness, tolerance: tolerance(sizes) };
    Ok(if format == Format::Stl { stl(sizes, solid)? } else { scad(sizes, solid)? })
}

/// How far a chord may leave its arc, in millimetres.
fn tolerance(sizes: &Sizes) -> f64 {
    let play = sizes.play.slot;
    if play > 0.0 { OF_PLAY * play } else { OF_CENTRE_DISTANCE * sizes.centre_distance }
}
