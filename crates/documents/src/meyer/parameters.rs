//! How many parameters has the motion?

use super::disc_data::{mass, volume};
use super::geometry::every;
use super::hand_over::Drawn;
use super::newton::Newton;
use super::*;
use crate::evidence::RUNGE_KUTTA;
use geneva_evidence::Dimension as Exponents;
use geneva_evidence::agreement::joined;
use geneva_kinematics::escapement::pins_needed;

pub(super) const AFTER_THE_LIST: Locator = at("Chapter II, paragraph after the list of parameters");

/// The claim of the sentence before the list.
pub(super) fn six() -> Claim {
    at("Chapter II, sentence before the list of parameters")
        .statement(
            "meyer.six-parameters",
            "six parameters",
            "the equation of motion with its geometry has six parameters",
        )
        .first_route(RUNGE_KUTTA, |stated| count_that_matter(stated, &Quantity::ALL))
        .second_route(Evidence::DIMENSION, |stated| count_that_may_enter(stated, &Quantity::ALL))
        .but_not("there are six, and no two of them can be combined into one")
        .interpreted_as(PARAMETER)
}

/// The claims of the paragraph after the list.
pub(super) fn after_the_list() -> Vec<Claim> {
    vec![
        AFTER_THE_LIST
            .statement(
                "meyer.one-geometric-parameter",
                "n and θ_0, are not independent",
                "the number of slots and the angle of entry depend on each other, so they are one parameter",
            )
            .first_route(Evidence::LIMIT_CASE, |stated| {
                let off = Mechanism::ALL.into_iter().map(|at| {
                    let pins = pins_needed(at.slots()).map_or(f64::NAN, |pins| pins.approximate());
                    let slot = PI / f64::from(at.slots());
                    stated.pick(1.0, 2.0) * (PI / 2.0 - slot) - PI / pins
                });
                every(off, vanishes, "with m by Eq. (1-3), the differences between that angle and π/m are")
            })
            .second_route(Evidence::VECTORS, |stated| {
                let across = Mechanism::ALL.into_iter().map(|at| {
                    let slot = PI / f64::from(at.slots());
                    let drawn = Drawn::new(at.pins(), at.slots());
                    let angle = stated.pick(1.0, 2.0) * (PI / 2.0 - slot);
                    drawn.place(angle).perp(&Drawn::velocity(angle))
                });
                every(across, vanishes, "at that angle, the velocities of a pin across its slot are")
            })
            .but_not("θ_0 is the angle from one pin to the next, 2π/m"),
        AFTER_THE_LIST
            .statement(
                "meyer.four-parameters",
                "four parameters",
                "for each of the three mechanisms four parameters are left: friction, torque and two inertias",
            )
            .first_route(RUNGE_KUTTA, |stated| count_that_matter(stated, &Quantity::OF_A_MECHANISM))
            .second_route(Evidence::DIMENSION, |stated| count_that_may_enter(stated, &Quantity::OF_A_MECHANISM))
            .but_not("there are four, and no two of them can be combined into one")
            .interpreted_as(PARAMETER),
    ]
}

/// What a parameter is.
const PARAMETER: &str = "A parameter is a quantity that the program is given and that changes the motion if it alone \
                         is changed. (The torque and the inertias matter only through their ratios, so two numbers \
                         would do for these three.)";

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
    /// The quantities of the list of parameters, and the size of the mechanism.
    const ALL: [Self; 7] =
        [Self::Slots, Self::EntryAngle, Self::Friction, Self::Torque, Self::Follower, Self::Driver, Self::Radius];

    /// The quantities that are left if the numbers of pins and slots are chosen, and the size.
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

/// Whether so many of the quantities change the motion if each alone is changed, or change it each in a way of its own: the
/// speeds at the end of engagements that begin with five speeds, and how long they take, by Newton's laws, in steps; for
/// each of the three mechanisms.
fn count_that_matter(stated: Stated, quantities: &[Quantity]) -> Finding {
    const STEP: f64 = 1e-3;
    let motion = |at: &Mechanism, changed: Quantity, by: f64| {
        let times = |quantity| if changed == quantity { 1.0 + by } else { 1.0 };
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
        let engagements = pair.engagements(half, 100);
        let passages = [0.0, 0.25, 0.5, 1.0, 2.0].map(|entry| engagements.passage(entry, &|_| torque));
        passages
            .into_iter()
            .flat_map(|of| of.map_or([f64::NAN; 2], |passage| [passage.end, passage.duration]))
            .collect()
    };
    let counted = |at: &Mechanism| {
        let changes = |quantity: &Quantity| -> Vec<f64> {
            let [more, less]: [Vec<f64>; 2] = [STEP, -STEP].map(|by| motion(at, *quantity, by));
            more.iter().zip(&less).map(|(more, less)| libm::log(more / less) / (2.0 * STEP)).collect()
        };
        let columns: Vec<Vec<f64>> = quantities.iter().map(changes).collect();
        let alone = columns.iter().filter(|column| column.iter().any(|change| change.abs() > 1e-6)).count();
        let matrix = nalgebra::DMatrix::from_fn(columns[0].len(), columns.len(), |row, column| columns[column][row]);
        stated.pick(alone, matrix.rank(1e-4))
    };
    let found = Mechanism::ALL.map(|at| counted(&at));
    Finding::new(
        found.iter().all(|count| *count == stated.count() as usize),
        format!(
            "we counted how many of these quantities change an engagement: {}. The counts for the three mechanisms are \
             {}",
            named(quantities),
            joined(found)
        ),
    )
}

/// The quantities in words.
fn named(quantities: &[Quantity]) -> String {
    joined(quantities.iter().map(|quantity| match quantity {
        Quantity::Slots => "slots",
        Quantity::EntryAngle => "angle at entry",
        Quantity::Friction => "friction",
        Quantity::Torque => "torque",
        Quantity::Follower => "follower's inertia",
        Quantity::Driver => "driver's inertia",
        Quantity::Radius => "radius",
    }))
}

/// Whether so many of the quantities may enter a relation with speeds and accelerations of angles, by their dimensions:
/// those without which the matrix of exponents has the same rank. Or whether so many products of them may, whose unit is a
/// power of the time.
fn count_that_may_enter(stated: Stated, quantities: &[Quantity]) -> Finding {
    let motion = [Exponents::ANGULAR_SPEED, Exponents::ANGULAR_ACCELERATION];
    let rank_without = |left_out: Option<Quantity>| {
        let kept =
            quantities.iter().filter(|quantity| Some(**quantity) != left_out).map(|quantity| quantity.dimension());
        rank(&kept.chain(motion).collect::<Vec<_>>())
    };
    let full = rank_without(None);
    let entering: Vec<_> =
        quantities.iter().copied().filter(|quantity| rank_without(Some(*quantity)) == full).collect();
    let timeless = |quantity: &Quantity| Exponents { time: 0, ..quantity.dimension() };
    let products = entering.len() - rank(&entering.iter().map(timeless).collect::<Vec<_>>());
    Finding::new(
        stated.pick(entering.len(), products) == stated.count() as usize,
        format!(
            "the matrix of dimensions has rank {full}, so among {} the following can enter, in {products} products: {}",
            named(quantities),
            named(&entering)
        ),
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
