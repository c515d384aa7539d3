//! Where everything is: both axes, all pins, all slots, and the hand-over from one pin to the next without rounding.
//!
//! Frame: the driver's axis is the origin, the follower's axis lies at (a, 0), lengths are in radii of the pins' circle.
//! The driver turns counter-clockwise, the follower clockwise; for the other senses, mirror all at the line of centres
//! and reverse the velocities. Pin k stands at the driver angle θ + 2πk/m. Slot k leaves the follower's axis in the
//! direction (−cos, sin) of φ + 2πk/n, so that pin k meets slot k, both counted round and round. Meyer 1973, figures 3,
//! 4 and 12 to 14.

use super::{EscapementError, Mechanism};
use crate::indexing::Indexing;
use crate::pin_slot::velocity_ratio;
use crate::pin_vectors::quarter_turn;
use crate::{Field, Rational, Surd, Turn};
use nalgebra::Vector2;
use num_traits::One;

/// Rationals with √2 and √3: the cosines and sines of all angles at the hand-over are among them.
pub type Roots = Surd<Surd<Rational, 2>, 3>;

/// The mechanism at one driver angle.
///
/// ```
/// use geneva_kinematics::Mechanism;
///
/// let layout = Mechanism::THREE_PIN.layout(0.0)?; // first pin on the line of centres, axes 2 crank radii apart
/// assert_eq!((layout.pins.len(), layout.slots.len(), &layout.engaged[..]), (3, 6, &[(0, 0)][..]));
/// let meeting = layout.meeting(0, 0).expect("there are such a pin and slot");
/// assert_eq!((meeting.out, meeting.beside), (1.0, 0.0)); // in crank radii: a − 1, on the slot's centre line
/// # Ok::<(), geneva_kinematics::EscapementError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration<S> {
    /// The follower's axis, in crank radii from the driver's axis.
    pub follower_axis: Vector2<S>,
    /// Centres of all m pins, counter-clockwise.
    pub pins: Vec<Vector2<S>>,
    /// Centre lines of all n slots, clockwise.
    pub slots: Vec<Slot<S>>,
    /// Pins in slots, as (pin, slot), the first pin first: one pair, or two at the hand-over.
    ///
    /// Never none: the pins stand 2π/m apart, and each is engaged over 2π/m.
    pub engaged: Vec<(usize, usize)>,
}

/// The centre line of a slot.
#[derive(Clone, Debug, PartialEq)]
pub struct Slot<S> {
    /// Unit vector from the follower's axis outwards.
    pub direction: Vector2<S>,
    /// Point at which the pin's centre enters, on the follower's rim.
    pub mouth: Vector2<S>,
    /// The place of the pin's centre nearest to the follower's axis.
    pub bottom: Vector2<S>,
}

/// A pin seen from a slot; the velocity is for a driver of angular velocity one, and not relative to the slot.
#[derive(Clone, Debug, PartialEq)]
pub struct RelativePosition<S> {
    /// How far out the pin is along the slot's centre line, from the follower's axis, in crank radii.
    pub out: S,
    /// How far beside the slot's centre line the pin is, in crank radii; positive is counter-clockwise from it.
    pub beside: S,
    /// Velocity of the pin along the slot, outwards, in crank radii per radian of the driver.
    pub outward: S,
    /// Velocity of the pin across the slot, counter-clockwise, in crank radii per radian of the driver.
    pub across: S,
}

impl<S: Field> Configuration<S> {
    /// A pin, by its index, seen from a slot, by its index; `None` if there is no such pin or slot.
    pub fn meeting(&self, pin: usize, slot: usize) -> Option<RelativePosition<S>> {
        Some(RelativePosition::new(&self.follower_axis, self.pins.get(pin)?, self.slots.get(slot)?))
    }
}

impl<S: Field> RelativePosition<S> {
    fn new(follower_axis: &Vector2<S>, pin: &Vector2<S>, slot: &Slot<S>) -> Self {
        let (along, from_follower, velocity) = (&slot.direction, pin - follower_axis, quarter_turn(pin));
        Self {
            out: from_follower.dot(along),
            beside: along.perp(&from_follower),
            outward: velocity.dot(along),
            across: along.perp(&velocity),
        }
    }
}

/// The instant at which one pin leaves and the next enters, exactly. Meyer 1973, figure 4.
///
/// ```
/// use geneva_kinematics::{Field, Mechanism};
/// use num_traits::Zero;
///
/// let hand_over = Mechanism::FOUR_PIN.hand_over();
/// assert!(hand_over.follower_speeds.iter().all(Zero::is_zero)); // exactly at rest
/// assert_eq!(hand_over.leaving.outward.approximate(), 1.0); // the pin goes straight out,
/// assert_eq!(hand_over.entering.outward.approximate(), -1.0); // and the next one straight in
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct HandOver {
    /// Where everything is; pin 0 leaves slot 0.
    pub layout: Configuration<Roots>,
    /// The leaving pin in its slot: on the centre line, at the rim, moving straight out.
    pub leaving: RelativePosition<Roots>,
    /// The entering pin in its slot: on the centre line, at the rim, moving straight in.
    pub entering: RelativePosition<Roots>,
    /// The follower's angular velocity over the driver's by the leaving pin and by the entering one: both zero.
    pub follower_speeds: [Roots; 2],
    /// What is missing for the follower's angle by the leaving pin to agree, one slot on, with the angle by the
    /// entering pin: the pins' places from the follower's axis, one turned by 2π/n, less the other. Zero.
    pub gap: Vector2<Roots>,
}

/// The sizes that the places follow from.
struct Frame<S> {
    /// a.
    ratio: S,
    /// Greatest and least distance of a pin in a slot from the follower's axis.
    rim: S,
    deepest: S,
}

impl<S: Field> Frame<S> {
    fn axis(&self) -> Vector2<S> {
        Vector2::new(self.ratio.clone(), S::zero())
    }

    /// The slot at the follower angle φ.
    fn slot(&self, angle: &Turn<S>) -> Slot<S> {
        let direction = angle.supplement().direction();
        let at = |radius: &S| self.axis() + &direction * radius.clone();
        Slot { mouth: at(&self.rim), bottom: at(&self.deepest), direction }
    }

    /// All pins and slots for θ, φ and the two pitches.
    fn layout(&self, escapement: &Mechanism, angles: [Turn<S>; 2], pitches: [Turn<S>; 2]) -> Configuration<S> {
        let ([crank, slot], [pin_pitch, slot_pitch]) = (angles, pitches);
        Configuration {
            follower_axis: self.axis(),
            pins: turned(crank, &pin_pitch, escapement.pins()).iter().map(Turn::direction).collect(),
            slots: turned(slot, &slot_pitch, escapement.slots()).iter().map(|angle| self.slot(angle)).collect(),
            engaged: vec![(0, 0)],
        }
    }
}

impl Mechanism {
    /// The mechanism while its first pin is at this driver angle, in radians from the line of centres.
    ///
    /// # Errors
    ///
    /// [`EscapementError::Wheel`] if the angle is beyond ±π/m, where another pin has taken over, or not finite.
    pub fn layout(&self, crank: f64) -> Result<Configuration<f64>, EscapementError> {
        let slot = self.wheel().engaged(crank)?.angle;
        let ratio = self.centre_distance_ratio();
        let frame = Frame { ratio, rim: self.rim_radius(), deepest: ratio - 1.0 };
        let pitches = [self.driver_pitch_angle(), self.follower_pitch_angle()].map(Turn::from_radians);
        let mut layout = frame.layout(self, [crank, slot].map(Turn::from_radians), pitches);
        let end = self.engagement_half_angle();
        if crank == end {
            layout.engaged.push(self.behind());
        } else if crank == -end {
            layout.engaged.push((1, 1));
        }
        Ok(layout)
    }

    /// The hand-over, without rounding.
    pub fn hand_over(&self) -> HandOver {
        let (crank, slot) = (exact_part_of_half_turn(self.pins()), exact_part_of_half_turn(self.slots()));
        let ratio = Roots::one() / slot.sin.clone();
        let rim = slot.cos.clone() / slot.sin.clone();
        let frame = Frame { deepest: ratio.clone() - Roots::one(), ratio, rim };
        let pitches = [crank.plus(&crank), slot.plus(&slot)];
        let mut layout = frame.layout(self, [crank.clone(), slot.clone()], pitches.clone());
        layout.engaged.push(self.behind());
        // The entering pin and its slot are the mirror images of the leaving ones.
        let (before, slot_before) = (crank.reversed(), slot.reversed());
        let (leaving, entering) = (crank.direction() - frame.axis(), before.direction() - frame.axis());
        let one_slot_on = &leaving * pitches[1].cos.clone() + quarter_turn(&leaving) * pitches[1].sin.clone();
        HandOver {
            layout,
            leaving: RelativePosition::new(&frame.axis(), &crank.direction(), &frame.slot(&slot)),
            entering: RelativePosition::new(&frame.axis(), &before.direction(), &frame.slot(&slot_before)),
            follower_speeds: [&crank, &before].map(|angle| velocity_ratio(&frame.ratio, angle)),
            gap: one_slot_on - entering,
        }
    }

    /// Pin and slot that come after the first: the last ones, counted round.
    pub(super) fn behind(&self) -> (usize, usize) {
        (self.pins() as usize - 1, self.slots() as usize - 1)
    }
}

/// So many angles, each one pitch further than the one before.
fn turned<S: Field>(first: Turn<S>, pitch: &Turn<S>, count: u32) -> Vec<Turn<S>> {
    std::iter::successors(Some(first), |angle| Some(angle.plus(pitch))).take(count as usize).collect()
}

/// π over 3, 4 or 6, the only numbers of slots and of pins there are.
fn exact_part_of_half_turn(count: u32) -> Turn<Roots> {
    let half = Roots::one() / Roots::integer(2);
    let half_root_of_three = half.clone() * Roots::root();
    match count {
        3 => Turn { cos: half, sin: half_root_of_three },
        4 => {
            let half_root_of_two = half * Roots::from_plain(Surd::root());
            Turn { cos: half_root_of_two.clone(), sin: half_root_of_two }
        }
        _ => Turn { cos: half_root_of_three, sin: half },
    }
}
