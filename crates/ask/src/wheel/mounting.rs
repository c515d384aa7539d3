//! How wheel and driver are to be mounted, as it is typed: each field has the name of an argument.

use crate::Error;
use crate::number_format::as_typed;
use geneva_workshop::{BasePlate, Fastener, Mounting, Pattern, PinMount, ScrewHole, ShaftFit, Thread};

/// The shape of a bore.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoreShape {
    /// Round.
    #[default]
    Round,
    /// With a keyway by DIN 6885-1.
    Key,
}

impl BoreShape {
    /// All shapes, with their names.
    pub const ALL: [(&'static str, Self); 2] = [("round", Self::Round), ("key", Self::Key)];
}

/// How pins without a screw are held.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PinKind {
    /// In one piece with the plate, where it is not cut from a sheet.
    #[default]
    Solid,
    /// Dowels.
    Dowel,
}

impl PinKind {
    /// Both kinds, with their names.
    pub const ALL: [(&'static str, Self); 2] = [("solid", Self::Solid), ("dowel", Self::Dowel)];
}

/// What is asked of the mounting; lengths are in millimetres. Nothing given is bare parts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MountingQuestion {
    /// Shape of the wheel's bore (`--wheel-bore-shape`).
    pub wheel_bore_shape: Option<BoreShape>,
    /// From the flat of the wheel's shaft to its opposite side (`--wheel-flat`).
    pub wheel_flat: Option<f64>,
    /// Shape of the driver's bores (`--driver-bore-shape`).
    pub driver_bore_shape: Option<BoreShape>,
    /// From the flat of the driver's shaft to its opposite side (`--driver-flat`).
    pub driver_flat: Option<f64>,
    /// Diameter of the circle of holes through the wheel (`--wheel-hub-circle`).
    pub wheel_hub_circle: Option<f64>,
    /// Diameter of the circle of holes through disc and plate (`--driver-hub-circle`).
    pub driver_hub_circle: Option<f64>,
    /// Holes of each of these circles (`--hub-holes`); 3 unless it is given.
    pub hub_holes: Option<u32>,
    /// Thread of the screws through them (`--hub-screw`).
    pub hub_screw: Option<Thread>,
    /// Holes for these screws (`--hub-screw-hole`).
    pub hub_screw_hole: Option<ScrewHole>,
    /// Diameter of dowels through them, instead of screws (`--hub-dowel`).
    pub hub_dowel: Option<f64>,
    /// How the pins are held (`--pin-mount`).
    pub pin_mount: Option<PinKind>,
    /// Thread of screws that hold the pins, or are the pins (`--pin-screw`).
    pub pin_screw: Option<Thread>,
    /// Holes for these screws in the plate (`--pin-screw-hole`).
    pub pin_screw_hole: Option<ScrewHole>,
    /// Diameter of dowels between locking disc and plate (`--disc-dowel`).
    pub disc_dowel: Option<f64>,
    /// Diameter of the circle on which these are (`--disc-dowel-circle`).
    pub disc_dowel_circle: Option<f64>,
    /// How many of them (`--disc-dowels`); 2 unless it is given.
    pub disc_dowels: Option<u32>,
    /// Whether locking disc and plate are two pieces (`--driver-pieces`); if it isn't given, they are with a process that cuts sheet.
    pub stacked: Option<bool>,
    /// Thickness of a base plate (`--base-thickness`).
    pub base_thickness: Option<f64>,
    /// Thread of the screws at its corners (`--base-screw`).
    pub base_screw: Option<Thread>,
    /// Diameter of its shoulder holes (`--shoulder-diameter`).
    pub shoulder_diameter: Option<f64>,
    /// Depth of its shoulder holes (`--shoulder-depth`).
    pub shoulder_depth: Option<f64>,
    /// Width in millimetres that a laser takes away (`--kerf`), for the file of parts to cut.
    pub kerf: Option<f64>,
}

/// Holes of a hub and dowels of a disc where their number is not given.
const HUB_HOLES: u32 = 3;
const DISC_DOWELS: u32 = 2;

impl MountingQuestion {
    /// The mounting that is asked for.
    ///
    /// # Errors
    ///
    /// Arguments that need another one, or exclude one another.
    pub fn mounting(&self) -> Result<Mounting, Error> {
        Ok(Mounting {
            wheel_fit: fit("wheel", self.wheel_bore_shape, self.wheel_flat)?,
            driver_fit: fit("driver", self.driver_bore_shape, self.driver_flat)?,
            wheel_hub: self.hub(self.wheel_hub_circle)?,
            driver_hub: self.hub(self.driver_hub_circle)?,
            pins: self.pins()?,
            disc_dowels: self.dowels()?,
            is_stacked: self.stacked.unwrap_or(false),
            base: self.base()?,
            axial_play: None,
        })
    }

    fn hub(&self, circle: Option<f64>) -> Result<Option<Pattern>, Error> {
        let asked = self.hub_screw.is_some() || self.hub_dowel.is_some() || self.hub_holes.is_some();
        if asked && self.wheel_hub_circle.is_none() && self.driver_hub_circle.is_none() {
            return Err(refused!(
                "the holes of a hub need a circle; add --wheel-hub-circle MM, --driver-hub-circle MM or both"
            ));
        }
        if self.hub_screw.is_none() && self.hub_screw_hole.is_some() {
            return Err(refused!("--hub-screw-hole needs a screw; add --hub-screw M3 to M8"));
        }
        let Some(circle) = circle else { return Ok(None) };
        let fastener = match (self.hub_screw, self.hub_dowel) {
            (Some(screw), None) => Fastener::Screw(screw, self.hub_screw_hole.unwrap_or(ScrewHole::Clearance)),
            (None, Some(dowel)) => Fastener::Dowel(dowel),
            (None, None) => {
                return Err(refused!("a hub needs screws or dowels; add --hub-screw M3 to M8, or --hub-dowel MM"));
            }
            (Some(_), Some(dowel)) => {
                return Err(refused!("--hub-dowel {} and --hub-screw exclude each other; give one", as_typed(dowel)));
            }
        };
        Ok(Some(Pattern { count: self.hub_holes.unwrap_or(HUB_HOLES), circle, fastener }))
    }

    /// How the pins are held.
    ///
    /// # Errors
    ///
    /// Arguments that need another one, or exclude one another.
    pub(super) fn pins(&self) -> Result<PinMount, Error> {
        match (self.pin_screw, self.pin_mount) {
            (Some(_), Some(_)) => Err(refused!("--pin-mount and --pin-screw exclude each other; give one")),
            (Some(screw), None) => Ok(PinMount::Screw(screw, self.pin_screw_hole.unwrap_or(ScrewHole::Clearance))),
            (None, _) if self.pin_screw_hole.is_some() => {
                Err(refused!("--pin-screw-hole needs a screw; add --pin-screw M3 to M8"))
            }
            (None, Some(PinKind::Dowel)) => Ok(PinMount::Dowel),
            (None, _) => Ok(PinMount::Solid),
        }
    }

    fn dowels(&self) -> Result<Option<Pattern>, Error> {
        match (self.disc_dowel, self.disc_dowel_circle) {
            (Some(diameter), Some(circle)) => {
                let count = self.disc_dowels.unwrap_or(DISC_DOWELS);
                Ok(Some(Pattern { count, circle, fastener: Fastener::Dowel(diameter) }))
            }
            (None, None) if self.disc_dowels.is_none() => Ok(None),
            _ => Err(refused!(
                "dowels between disc and plate need a diameter and a circle; give --disc-dowel MM and --disc-dowel-circle MM"
            )),
        }
    }

    fn base(&self) -> Result<Option<BasePlate>, Error> {
        let shoulder = match (self.shoulder_diameter, self.shoulder_depth) {
            (Some(diameter), Some(depth)) => Some([diameter, depth]),
            (None, None) => None,
            _ => {
                return Err(refused!(
                    "shoulders need both numbers; give --shoulder-diameter MM and --shoulder-depth MM"
                ));
            }
        };
        match self.base_thickness {
            Some(_) => Ok(Some(BasePlate { thickness: self.base_thickness, shoulder, screws: self.base_screw })),
            None if shoulder.is_some() || self.base_screw.is_some() => {
                Err(refused!("screws and shoulders of a base plate need one; add --base-thickness MM"))
            }
            None => Ok(None),
        }
    }
}

fn fit(part: &str, shape: Option<BoreShape>, flat: Option<f64>) -> Result<ShaftFit, Error> {
    match (shape, flat) {
        (Some(BoreShape::Key), Some(across)) => {
            Err(refused!("--{part}-flat {} and --{part}-bore-shape key exclude each other; give one", as_typed(across)))
        }
        (Some(BoreShape::Key), None) => Ok(ShaftFit::Key),
        (_, Some(across)) => Ok(ShaftFit::Flat { across }),
        (_, None) => Ok(ShaftFit::Round),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wheel::{WheelDesign, WheelQuestion};
    use geneva_workshop::Part;

    fn wheel(mounting: MountingQuestion) -> WheelQuestion {
        WheelQuestion {
            stations: Some(6),
            crank_radius: Some(60.0),
            thickness: Some(8.0),
            wheel_shaft: Some(16.0),
            driver_shaft: Some(8.0),
            mounting,
            ..WheelQuestion::default()
        }
    }

    #[test]
    fn what_is_asked_for_is_in_the_parts() {
        let asked = MountingQuestion {
            wheel_bore_shape: Some(BoreShape::Key),
            driver_flat: Some(7.0),
            wheel_hub_circle: Some(36.0),
            hub_holes: Some(4),
            hub_screw: Some(Thread::M4),
            pin_screw: Some(Thread::M5),
            pin_screw_hole: Some(ScrewHole::NutTrap),
            base_thickness: Some(10.0),
            ..MountingQuestion::default()
        };
        let design = WheelDesign::new(wheel(asked)).expect("a wheel");
        let list = design.part_list().expect("parts").expect("an external wheel with a size").parts;
        let names: Vec<&str> = list.iter().map(Part::words).collect();
        assert_eq!(names, ["wheel", "locking disc", "driver plate", "bush", "base plate"]);
        assert_eq!(list[0].holes.len(), 1 + 4);
        for file in [design.step(), design.svg_parts(), design.stl(), design.scad(), design.dxf()] {
            assert!(file.expect("a file").len() > 1000);
        }
        assert!(design.three_mf().expect("a file").len() > 1000);
    }

    #[test]
    fn what_does_not_go_together_is_refused_with_what_to_add() {
        let none = MountingQuestion::default();
        for (asked, said) in [
            (MountingQuestion { hub_screw: Some(Thread::M3), ..none }, "--wheel-hub-circle MM"),
            (MountingQuestion { wheel_hub_circle: Some(30.0), ..none }, "--hub-screw M3"),
            (MountingQuestion { pin_screw_hole: Some(ScrewHole::Tapped), ..none }, "--pin-screw M3"),
            (MountingQuestion { hub_screw_hole: Some(ScrewHole::Tapped), ..none }, "--hub-screw M3"),
            (MountingQuestion { disc_dowel: Some(3.0), ..none }, "--disc-dowel-circle MM"),
            (MountingQuestion { base_screw: Some(Thread::M5), ..none }, "--base-thickness MM"),
            (MountingQuestion { shoulder_depth: Some(3.0), ..none }, "--shoulder-diameter MM"),
            (
                MountingQuestion { wheel_flat: Some(7.0), wheel_bore_shape: Some(BoreShape::Key), ..none },
                "--wheel-flat 7",
            ),
            (
                MountingQuestion { wheel_hub_circle: Some(206.0), hub_dowel: Some(4.0), ..none },
                "give --wheel-hub-circle from ",
            ),
        ] {
            let refused = WheelDesign::new(wheel(asked)).expect("a wheel").step().expect_err(said).to_string();
            assert!(refused.contains(said), "{refused}");
        }
    }
}
