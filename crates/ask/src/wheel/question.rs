//! A question about a wheel: what was said of it, however it was said.

use super::kind::WheelKind;
use super::mounting::MountingQuestion;
use crate::worked::DriverSpeed;
use geneva_dynamics::line_contact::Material;
use geneva_kinematics::wheel::Scale;
use geneva_kinematics::wheel::as_built::Process;

/// What is asked of a wheel: the arguments have the names of the fields, `--crank-radius 25`. Lengths are in millimetres.
#[derive(Clone, Debug, Default)]
pub struct WheelQuestion {
    /// Whether it is only tried, so that a refusal need not say what would help.
    pub is_trial: bool,
    /// Kind of wheel (`--type`); external unless it is given.
    pub kind: Option<WheelKind>,
    /// Number of slots.
    pub stations: Option<u32>,
    /// Number of pins on the driver; 1 unless it is given.
    pub pins: Option<u32>,
    /// Speed of the driver in turns per minute: this or one of the next three.
    pub rpm: Option<f64>,
    /// Speed of the driver in radians per second.
    pub rad_s: Option<f64>,
    /// Time of an index in seconds.
    pub index_time: Option<f64>,
    /// Time of a dwell in seconds.
    pub dwell_time: Option<f64>,
    /// Turn of the driver in a dwell in degrees, for the wheels that come nearest.
    pub dwell_angle: Option<f64>,
    /// Distance from the driver's axis to a pin's centre: this or one of the next three gives sizes.
    pub crank_radius: Option<f64>,
    /// Distance between the two axes.
    pub centre_distance: Option<f64>,
    /// Distance from the wheel's axis to a pin's centre as the pin enters.
    pub wheel_radius: Option<f64>,
    /// Diameter of the wheel over the corners of its slots.
    pub outside_diameter: Option<f64>,
    /// Thickness of the wheel.
    pub thickness: Option<f64>,
    /// How the parts are made.
    pub process: Option<Process>,
    /// Least play with which the pin ran on the test piece of the process.
    pub measured_play: Option<f64>,
    /// Diameter of the pins.
    pub pin_diameter: Option<f64>,
    /// How much wider slots and locking arcs are than the parts that run in them.
    pub play: Option<f64>,
    /// Width of the slots, which gives their play.
    pub slot_width: Option<f64>,
    /// How much wider the locking arcs are than the locking disc, as a difference of diameters; as the play of the slots unless
    /// it is given.
    pub locking_play: Option<f64>,
    /// How much wider the bores are than the shafts.
    pub bore_play: Option<f64>,
    /// Gap between wheel and plate along the axes; as the play of the slots unless it is given.
    pub axial_play: Option<f64>,
    /// Least thickness of the wheel between a slot and a locking arc.
    pub horn: Option<f64>,
    /// Radius of the locking arcs, which gives the horn.
    pub locking_arc_radius: Option<f64>,
    /// How much deeper the slots are than the pins need.
    pub bottom_clearance: Option<f64>,
    /// How much of each wall of a slot a chamfer takes at its mouth: this or one of the next but one.
    pub mouth_chamfer: Option<f64>,
    /// Angle of the chamfer to the wall in degrees.
    pub mouth_angle: Option<f64>,
    /// Radius of rounded mouths of the slots.
    pub mouth_radius: Option<f64>,
    /// How much of each wall of a slot a lead-in takes at its mouth.
    pub lead_in: Option<f64>,
    /// How far the lead-in has left the wall at the wheel radius.
    pub lead_in_flare: Option<f64>,
    /// Diameter of the wheel's shaft.
    pub wheel_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plane of the wheel.
    pub driver_shaft: Option<f64>,
    /// Diameter of the driver's shaft in the plate, if it ends there; that in the plane of the wheel unless it is given.
    pub plate_shaft: Option<f64>,
    /// Holes for mounting, and what the files have besides wheel and driver.
    pub mounting: MountingQuestion,
    /// By how much the axes are too far apart, for clearance and knock.
    pub centre_error: Option<f64>,
    /// Mass in kg of a round table that turns with the wheel.
    pub table_mass: Option<f64>,
    /// Diameter of that table.
    pub table_diameter: Option<f64>,
    /// Moment of inertia, in kg m², of everything that turns with the wheel, without the wheel itself.
    pub inertia: Option<f64>,
    /// Moment of inertia, in kg m², of the wheel and everything that turns with it.
    pub total_inertia: Option<f64>,
    /// Density of the wheel in kg/m³; that of its material unless it is given.
    pub density: Option<f64>,
    /// Density of the driver in kg/m³; that of its material unless it is given.
    pub driver_density: Option<f64>,
    /// Density of the pins in kg/m³; that of their material unless it is given.
    pub pin_density: Option<f64>,
    /// Torque of the friction that brakes the wheel, in N m.
    pub friction_torque: Option<f64>,
    /// Coefficient of friction of a pin in its slot.
    pub pin_friction: Option<f64>,
    /// Coefficient of friction of the locking disc in its arc.
    pub disc_friction: Option<f64>,
    /// Coefficient of friction of the bearings of wheel and driver.
    pub bearing_friction: Option<f64>,
    /// Diameter at which the wheel's bearing rubs; that of the wheel's shaft unless it is given.
    pub wheel_bearing: Option<f64>,
    /// Diameter at which the driver's bearing rubs; that of the driver's shaft unless it is given.
    pub driver_bearing: Option<f64>,
    /// Constant torque of friction on the driver, in N m.
    pub driver_friction: Option<f64>,
    /// Torque in N m that turns the wheel while it should stand, as of a table out of balance.
    pub held_torque: Option<f64>,
    /// Overload torque on the driver's arm, in N m, for the strength of the pin.
    pub arm_torque: Option<f64>,
    /// Moment of inertia, in kg m², of the driver and all that turns with it.
    pub driver_inertia: Option<f64>,
    /// Torque in N m with which the driver is started.
    pub drive_torque: Option<f64>,
    /// Turns of the motor in a turn of the driver.
    pub gear_ratio: Option<f64>,
    /// Modulus of the pins in GPa, instead of that of their material.
    pub pin_modulus: Option<f64>,
    /// Poisson's ratio of the pins, instead of that of their material.
    pub pin_poisson: Option<f64>,
    /// Strength of the pins in MPa, instead of that of their material.
    pub pin_strength: Option<f64>,
    /// Modulus of the wheel in GPa, instead of that of its material.
    pub wheel_modulus: Option<f64>,
    /// Poisson's ratio of the wheel, instead of that of its material.
    pub wheel_poisson: Option<f64>,
    /// Strength of the wheel in MPa, instead of that of its material.
    pub wheel_strength: Option<f64>,
    /// Strength of the driver in MPa, instead of that of its material.
    pub driver_strength: Option<f64>,
    /// Allowed pressure between pin and slot in MPa, instead of that at which one of them begins to yield.
    pub allowed_pressure: Option<f64>,
    /// Material of the pins.
    pub pin_material: Option<Material>,
    /// Material of the wheel.
    pub wheel_material: Option<Material>,
    /// Material of locking disc and plate; as the wheel unless it is given.
    pub driver_material: Option<Material>,
    /// Crank angles, in degrees, at which to report the motion.
    pub at: Vec<f64>,
    /// Wheel angles, in degrees from the middle of an index, at which to report the motion.
    pub at_wheel: Vec<f64>,
    /// Degrees of the crank before a pin enters, for the backlash there; it has no name at the command line.
    pub before_entry: Option<f64>,
    /// Whether an external wheel without a size gets the one that suits its load.
    pub recommends_size: bool,
    /// How long clearances are looked for.
    pub effort: SearchEffort,
}

/// Crank angles at which clearances are looked for at most. Where the play is so small against the parts that more are needed,
/// the numbers are missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SearchEffort {
    /// For the least clearance.
    pub clearance: u32,
    /// For each of the clearances that give the tolerance of the axes.
    pub tolerance: u32,
}

impl Default for SearchEffort {
    /// A few seconds at most.
    fn default() -> Self {
        Self { clearance: 4_000_000, tolerance: 400_000 }
    }
}

impl WheelQuestion {
    /// The speed of the driver, if it is given as such and not as a time.
    pub fn speed(&self) -> Option<DriverSpeed> {
        self.rpm.map(DriverSpeed::Rpm).or(self.rad_s.map(DriverSpeed::RadiansPerSecond))
    }

    /// Whether the speed of the driver is given, as such or as the time of an index or of a dwell.
    pub fn has_speed(&self) -> bool {
        self.speed().is_some() || self.index_time.is_some() || self.dwell_time.is_some()
    }

    /// The length in millimetres that scales the wheel, if one is given.
    pub fn scale(&self) -> Option<Scale> {
        let crank = self.crank_radius.map(Scale::CrankRadius);
        let centres = self.centre_distance.map(Scale::CentreDistance);
        let radius = self.wheel_radius.map(Scale::WheelRadius);
        crank.or(centres).or(radius).or(self.outside_diameter.map(Scale::OutsideDiameter))
    }
}

/// A shaft that was given; one of no diameter is none.
pub(super) fn given(shaft: Option<f64>) -> Option<f64> {
    shaft.filter(|diameter| *diameter != 0.0)
}
