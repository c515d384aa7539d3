//! Files from which a wheel and its driver are made, from the sizes and outlines of `geneva-kinematics`.
//!
//! [`parts()`] lists the parts with all their holes, as they are to be mounted, and every file has them from there: [`dxf`] lines
//! and true arcs, for laser, router and mill; [`svg_parts`] the same for programs that cut from SVG; [`stl`] and [`three_mf`]
//! meshes for printing; [`step`] solids with true cylinders. [`scad`] is a model for OpenSCAD whose numbers can be changed. All
//! lengths are millimetres. The same arguments give the same file; nothing is read or written here.

#![warn(clippy::missing_errors_doc)]

mod body;
mod chords;
mod crossings;
mod drawing;
mod drawn_wheel;
mod dxf;
mod dxf_reader;
mod geometry;
mod mesh;
mod offset;
mod parts;
mod scad;
mod sheets;
mod step;
mod stl;
mod svg;
mod three_mf;

pub use body::{validate_joined, validate_solids};
pub use drawing::PartLayout;
pub use drawn_wheel::{DrawnWheel, LayerNames};
pub use dxf::dxf;
pub use dxf_reader::{Drawing, DrawingError, DrawnEdge};
pub use mesh::{Mesh, meshes};
pub use parts::{
    BasePlate, Fastener, Hole, HolePurpose, KEYED_SHAFTS, Keyway, Layer, Mounting, MountingError, Part, PartList,
    Pattern, PinMount, Place, ScrewHole, ShaftFit, ThinWall, Thread, Widening, internal_parts, parts, test_piece,
};
pub use scad::{internal_scad, scad};
pub use sheets::{
    DrawingScale, LimitOrigin, Measured, Paper, PrintedDimension, Sheet, SheetLimits, SheetMaterial, SheetText,
    internal_sheets, sheets, sheets_html, sheets_svg,
};
pub use step::step;
pub use stl::stl;
pub use svg::svg_parts;
pub use three_mf::three_mf;
