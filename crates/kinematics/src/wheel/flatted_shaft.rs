//! How far a part turns loosely on a shaft with a flat.
//!
//! Notation: r radius of the shaft, f distance of its flat from its axis, p play of the bore, which is p/2 away from shaft and flat
//! all around. A torque between both lays the shaft against the back of its bore, opposite to the flat. The flat of the bore is then
//! f + p from the shaft's axis. The corner of the shaft's flat, at the angle arccos(f/r) from its middle, meets it when the shaft
//! has turned to arccos((f + p)/r).

/// A shaft with a flat, in a bore of the same shape that is wider all around; lengths in millimetres.
///
/// ```
/// use geneva_kinematics::wheel::FlattedShaft;
///
/// let motor = |play| FlattedShaft { diameter: 5.0, across: 4.5, play }.turning_play();
/// assert_eq!(motor(0.0), Some(0.0)); // rad
/// assert!(motor(0.1).expect("the flat holds").to_degrees() > 3.0); // a tenth of a millimetre is much at so small a flat
/// assert_eq!(motor(0.5), None); // as much play as the flat is deep: the shaft turns in its bore
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlattedShaft {
    /// Diameter of the shaft, in millimetres.
    pub diameter: f64,
    /// From its flat to its opposite side, in millimetres: more than half of the diameter, and less than all of it.
    pub across: f64,
    /// Diameter of the bore less that of the shaft, in millimetres, zero or more.
    pub play: f64,
}

impl FlattedShaft {
    /// How far the part turns loosely on the shaft to either side, in radians; none where the flat does not hold it at all, and for
    /// lengths that no such shaft has.
    pub fn turning_play(&self) -> Option<f64> {
        let radius = self.diameter / 2.0;
        let (flat, met) = (self.across - radius, self.across - radius + self.play);
        let is_held = flat > 0.0 && self.play >= 0.0 && met < radius;
        is_held.then(|| libm::acos(flat / radius) - libm::acos(met / radius))
    }
}
