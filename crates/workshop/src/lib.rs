//! Files from which a wheel and its driver are made, from the sizes and outlines of `geneva-kinematics`.
//!
//! [`dxf`] has lines and true arcs, for laser, router and mill; [`scad`] is a model for OpenSCAD whose numbers can be
//! changed; [`stl`] is a mesh for printing. All lengths are millimetres. The same arguments give the same text; nothing
//! is read or written here.

#![warn(clippy::missing_errors_doc)]

mod drawing;
mod drawn_wheel;
mod dxf;
mod dxf_reader;
mod mesh;
mod scad;
mod stl;

pub use drawing::{Layer, PartLayout};
pub use drawn_wheel::LayerNames;
pub use dxf::dxf;
pub use dxf_reader::{Drawing, DrawingError, DrawnEdge};
pub use mesh::{Mesh, Solid, driver_mesh, wheel_mesh};
pub use scad::scad;
pub use stl::stl;
