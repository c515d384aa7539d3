//! How many parameters has the motion?

use super::geometry::every;
use super::hand_over::Drawn;
use super::inertia::{mass, volume};
use super::newton::Newton;
use super::*;
use crate::Dimension as Exponents;
use crate::Evidence::RungeKutta;
use geneva_kinematics::escapement::pins_needed;

pub const AFTER_THE_LIST: Place = at("Chapter II, paragraph after the list of parameters");

/// The claim of the sentence before the list.
pub fn six() -> Claim {
    at("Chapter II, sentence before the list of parameters")
        .statement(
            "meyer.six-parameters",
            "six parameters",
            "the equation of motion with its geometry has six parameters",
        )
        .by(RungeKutta, |stated| count_that_matter(stated.pick(stated.count() as usize, 7), &Quantity::ALL))
        .by(Dimension, |stated| count_that_may_enter(stated.pick(stated.count() as usize, 7), &Quantity::ALL))
        .but_not("seven parameters, the radius of the pins' circle one of them")
        .read_as(
            "A parameter: a quantity that stands on the program's card and changes the motion if it alone is changed.",
        )
}

/// The claims of the paragraph after the list.
pub fn after_the_list() -> Vec<Claim> {
    vec![
        AFTER_THE_LIST
            .statement(
                "meyer.one-geometric-parameter",
                "n and θ_0, are not independent",
                "the number of slots and the angle of entry depend on each other: one parameter, the only one of the \
                 geometry",
            )
            .by(LimitCase, |stated| {
                let off = Mechanism::ALL.into_iter().map(|at| {
                    let pins = pins_needed(at.slots()).map_or(f64::NAN, |pins| pins.approximate());
                    let slot = PI / f64::from(at.slots());
                    stated.pick(PI / 2.0 - slot, slot) - PI / pins
                });
                every(off, vanishes, "that angle less π/m, with m by Eq. (1-3)")
            })
            .by(Vectors, |stated| {
                let across = Mechanism::ALL.into_iter().map(|at| {
                    let slot = PI / f64::from(at.slots());
                    let drawn = Drawn::new(at.pins(), at.slots());
                    let angle = stated.pick(PI / 2.0 - slot, slot);
                    drawn.place(angle).perp(&Drawn::velocity(angle))
                });
                every(across, vanishes, "velocity across the slot of a pin at that angle")
            })
            .but_not("θ_0 is the follower's angle π/n"),
        AFTER_THE_LIST
            .statement(
                "meyer.four-parameters",
                "four parameters",
                "for each of the three mechanisms four parameters are left: friction, torque and two inertias",
            )
            .by(RungeKutta, |stated| {
                count_that_matter(stated.pick(stated.count() as usize, 5), &Quantity::OF_A_MECHANISM)
            })
            .by(Dimension, |stated| {
                count_that_may_enter(stated.pick(stated.count() as usize, 5), &Quantity::OF_A_MECHANISM)
            })
            .but_not("five parameters, the radius of the pins' circle one of them")
            .read_as(PARAMETER),
    ]
}

/// What a parameter is.
const PARAMETER: &str = "A parameter: a quantity that changes the motion if it alone is changed.";

/// A quantity that the motion might depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Quantity {
    Slots,
    EntryAngle,
    Friction,
    Torque,
    Follower,
    Driver,
    Radius,
}

impl Quantity {
    /// Those of the list of parameters, and the size of the mechanism.
    const ALL: [Self; 7] =
        [Self::Slots, Self::EntryAngle, Self::Friction, Self::Torque, Self::Follower, Self::Driver, Self::Radius];

    /// Those that are left if the numbers of pins and slots are chosen, and the size.
    const OF_A_MECHANISM: [Self; 5] = [Self::Friction, Self::Torque, Self::Follower, Self::Driver, Self::Radius];

    fn dimension(self) -> Exponents {
        match self {
            Self::Slots | Self::EntryAngle | Self::Friction => Exponents::NONE,
            Self::Torque => Exponents::FORCE * Exponents::LENGTH,
            Self::Follower | Self::Driver => mass() * volume(2),
            Self::Radius => Exponents::LENGTH,
        }
    }
}

/// Whether so many of the quantities change the motion if each alone is changed: the speed at the end of an engagement
/// from rest, by Newton's laws, in steps; for each of the three mechanisms.
fn count_that_matter(said: usize, quantities: &[Quantity]) -> Finding {
    let changing = |at: &Mechanism| {
        let speed = |changed: Option<Quantity>| {
            let times = |quantity| if changed == Some(quantity) { 1.02 } else { 1.0 };
            let slots = f64::from(at.slots()) * times(Quantity::Slots);
            let radius = 1.5 * times(Quantity::Radius);
            let pair = Newton {
                radius,
                distance: radius / libm::sin(PI / slots),
                friction: 0.25 * times(Quantity::Friction),
                driver: 0.75 * times(Quantity::Driver),
                follower: 1.25 * times(Quantity::Follower),
            };
            let half = at.engagement_half_angle() * times(Quantity::EntryAngle);
            let torque = 0.5 * times(Quantity::Torque);
            pair.engagement(half, 0.0, &|_| torque, 200).map_or(f64::NAN, |passage| passage.end)
        };
        let changes = |quantity: &&Quantity| !(speed(Some(**quantity)) / speed(None) - 1.0).abs().le(&1e-9);
        quantities.iter().filter(changes).copied().collect::<Vec<_>>()
    };
    let found: Vec<_> = Mechanism::ALL.iter().map(changing).collect();
    let holds = found.len() == 3 && found.iter().all(|changing| changing.len() == said);
    Finding::new(holds, format!("of {quantities:?} these change an engagement: {:?}", found[0]))
}

/// Whether so many of the quantities may enter a relation with speeds and accelerations of angles, by their dimensions:
/// those without which the matrix of exponents has the same rank.
fn count_that_may_enter(said: usize, quantities: &[Quantity]) -> Finding {
    let motion = [Exponents::ANGULAR_SPEED, Exponents::ANGULAR_ACCELERATION];
    let rank_without = |left_out: Option<Quantity>| {
        let kept =
            quantities.iter().filter(|quantity| Some(**quantity) != left_out).map(|quantity| quantity.dimension());
        rank(&kept.chain(motion).collect::<Vec<_>>())
    };
    let full = rank_without(None);
    let entering: Vec<_> = quantities.iter().filter(|quantity| rank_without(Some(**quantity)) == full).collect();
    Finding::new(
        entering.len() == said,
        format!("rank {full}; in a product without unit, of {quantities:?} there may be {entering:?}"),
    )
}

/// The rank of the matrix of exponents.
fn rank(dimensions: &[Exponents]) -> usize {
    let rows = dimensions.len();
    let at = |row: usize, column: usize| {
        let Exponents { length, time, force } = dimensions[row];
        f64::from([length, time, force][column])
    };
    nalgebra::DMatrix::from_fn(rows, 3, at).rank(1e-9)
}
