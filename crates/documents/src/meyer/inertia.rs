//! The estimate of the inertias: two steel discs.

use super::disc_data::{Data, data_of_the_sentences, mass, volume};
use super::disc_letters::{DISC, ESTIMATE};
use super::parameters::AFTER_THE_LIST;
use super::runs::table::{UNIT, units_in_one};
use super::*;
use geneva_evidence::{Dimension as Exponents, Verdict};

const FORMULA: Locator = at("Chapter II, 1st display of I");
const NUMBERS: Locator = at("Chapter II, 2nd display of I");

/// The estimate with its numbers.
const AS_PRINTED: &str = concat!(
    r"I = \frac{1}{2} \pi \left(\frac{.283 \text{ lb/in}}{386 \text{ in/sec}^2} \right) ",
    r"\left(\frac{0.5 \text{ in}}{2} \right)^4 (0.1 \text{ in})"
);
/// The estimate with its numbers and the unit put right.
const PUT_RIGHT: &str = concat!(
    r"I = \frac{1}{2} \pi \left(\frac{.283 \text{ lb/in}^3}{386 \text{ in/sec}^2} ",
    r"\right) \left(\frac{0.5 \text{ in}}{2} \right)^4 (0.1 \text{ in})"
);

/// The inch in metres and the pound in kilograms, by definition.
const INCH: f64 = 0.0254;
const POUND: f64 = 0.453_592_37;

pub(super) fn claims() -> Vec<Claim> {
    [material(), estimate()].concat()
}

fn material() -> Vec<Claim> {
    vec![
        AFTER_THE_LIST
            .statement("meyer.steel", ".283 lb/in", "weight of a cubic inch of steel in pounds")
            .first_route(Evidence::LIMIT_CASE, |stated| {
                let density = metric_density(stated.number() - stated.pick(0.0, LIGHTER));
                Finding::new(
                    STEELS.contains(&density),
                    format!(
                        "the number is {density:.0} kg/m³, and handbooks give {:.0} to {:.0} for steels",
                        STEELS.start(),
                        STEELS.end()
                    ),
                )
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                let part = metric_density(stated.number() - stated.pick(0.0, LIGHTER)) / IRON.density();
                Finding::new(
                    (part - 1.0).abs() < 0.015,
                    format!(
                        "the metal's crystal has {:.0} kg/m³, and the number is {part:.3} times this",
                        IRON.density()
                    ),
                )
            })
            .but_not("a number that is smaller by five thousandths of a pound")
            .interpreted_as(
                "Steel is iron with little else in it, and steels differ by more than the last digit of the number.",
            ),
        AFTER_THE_LIST
            .statement(
                "meyer.like-discs",
                "both taken to be approximately 0.5 inch in diameter and 0.1 inch in thickness",
                "for the estimate, driver and follower are discs of the same size",
            )
            .first_route(Evidence::OTHER_PLACE_IN_SOURCE, |stated| {
                let [diameter, thickness] = sizes(stated);
                let [radius, said] = data().map_or([f64::NAN; 2], |data| [data.diameter / 2.0, data.thickness]);
                let holds = agrees(diameter / 2.0, radius) && agrees(thickness, said);
                Finding::new(
                    holds,
                    format!("the estimate has a radius of {radius} inch and a thickness of {said} inch"),
                )
            })
            .second_route(Evidence::CLOSED_FORM, |stated| {
                let [diameter, thickness] = sizes(stated);
                let result = printed_inertia();
                let [least, most] = [-0.05, 0.05].map(|rounded| {
                    let size = diameter + rounded;
                    disc(size, thickness)
                });
                Finding::new(
                    least < result && result < most,
                    format!(
                        "discs of this size have inertias of {least:.2e} to {most:.2e} in lb sec²; the printed value \
                         is {result:.1e}"
                    ),
                )
            })
            .but_not("a tenth of an inch more in diameter")
            .interpreted_as(
                "The sentence makes an assumption for the estimate of the inertias alone. A follower and a driver that \
                 end where the pins are have the same size only if there are four slots.",
            ),
    ]
}

fn estimate() -> Vec<Claim> {
    vec![
        FORMULA
            .equation(
                "meyer.disc",
                r"I = \frac{1}{2} \pi m r^4 t",
                "moment of inertia of a disc about its axis, by density, radius and thickness",
            )
            .in_letters(DISC)
            .with_second_witness(Evidence::DIMENSION, || {
                // In other units, 2, 3 and 5 times as small for length, time and force, the numbers grow so.
                let grown = |of: Exponents| {
                    [(2.0, of.length), (3.0, of.time), (5.0, of.force)]
                        .map(|(unit, exponent): (f64, i32)| libm::pow(unit, f64::from(exponent)))
                        .iter()
                        .product::<f64>()
                };
                let quantities = [("m", 1.5, mass() / volume(3)), ("r", 0.75, volume(1)), ("t", 0.25, volume(1))];
                let by = |larger: bool| {
                    let number = |(name, value, of): (&str, f64, Exponents)| {
                        (name.to_owned(), if larger { value * grown(of) } else { value })
                    };
                    reading::value(MEYER.right_side("meyer.disc"), &quantities.map(number).into())
                };
                same(by(true) / by(false), grown(mass() * volume(2)))
            }),
        FORMULA
            .statement(
                "meyer.letter-m",
                "m is the mass density",
                "the letter m, which counts pins in chapter I, is here the mass density",
            )
            .first_route(Evidence::DIMENSION, |stated| {
                let letter = stated.pick(mass(), Exponents::FORCE) / volume(3);
                let (found, wanted) = (letter * volume(4) * Exponents::LENGTH, mass() * volume(2));
                Finding::new(
                    found == wanted,
                    format!("the formula then has the dimension {found}; a moment of inertia has {wanted}"),
                )
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                let (density, radius, thickness) = (1.5, 0.75, 0.25);
                let whole = density * thickness * PI * radius * radius;
                // The acceleration of gravity in the units of the source.
                let letter = density * stated.pick(1.0, 386.0);
                let letters = [("m", letter), ("r", radius), ("t", thickness)];
                let letters = reading::by_name(letters);
                same(reading::value(MEYER.right_side("meyer.disc"), &letters), whole * radius * radius / 2.0)
            })
            .but_not("m is the weight of a unit of volume"),
        NUMBERS
            .equation(
                "meyer.disc.numbers",
                AS_PRINTED,
                "moment of inertia with the numbers put in, where a weight per volume over the acceleration of \
                 gravity is a mass density",
            )
            .in_letters(ESTIMATE)
            .with_second_witness(Evidence::CLOSED_FORM, || {
                // The same disc in kilograms and metres, with the weight of a cubic inch for a mass.
                let torque = POUND * 9.806_65 * INCH;
                let of = |data: Data<f64>| {
                    let [radius, thickness] = [data.diameter / 2.0, data.thickness].map(|inches| inches * INCH);
                    PI / 2.0 * metric_density(steel()) * radius * radius * radius * radius * thickness / torque
                };
                let [metric, inches] = [data().map(of), data().map(|data| disc(data.diameter, data.thickness))];
                let [metric, inches] = [metric, inches].map(|inertia| inertia.unwrap_or(f64::NAN));
                // The acceleration of gravity is printed to three digits.
                let rounding = data().map_or(f64::NAN, |data| 0.5 / data.gravity);
                Finding::new(
                    (metric / inches - 1.0).abs() < rounding,
                    format!("{metric:.4e} in lb sec² by way of metres and kilograms, {inches:.4e} as corrected"),
                )
            })
            .corrected(
                PUT_RIGHT,
                Slip {
                    id: "",
                    reason: "The weight is the weight of a cubic inch. Only then does the result have the unit that \
                             is printed with it. We count this as a mistake of the copy, because the paragraph before \
                             the display has the cube.",
                    witness: "The paragraph before the display has the same number in pounds per cubic inch.",
                    origin: Origin::Copy,
                    consequence: Consequence::Copy,
                    changes: "",
                },
            ),
        NUMBERS
            .statement("meyer.gravity", "386 in/sec", "acceleration of gravity in inches per second squared")
            .first_route(Evidence::CLOSED_FORM, |stated| {
                // 9.80665 m/s² by definition.
                gravity_is(9.806_65 / INCH, stated, "the standard value")
            })
            .second_route(Evidence::LIMIT_CASE, |stated| {
                // The normal gravity of the Earth's ellipsoid at 45° of latitude, by Somigliana's formula.
                let (equator, growth, flatness) = (9.780_325_335_9, 0.001_931_852_652_41, 0.006_694_379_990_13);
                let square = 0.5;
                let normal = equator * (1.0 + growth * square) / f64::sqrt(1.0 - flatness * square);
                gravity_is(normal / INCH, stated, "the gravity of the Earth's ellipsoid at 45°")
            })
            .but_not("387"),
        at("Chapter II, 3rd display of I")
            .value("meyer.disc.inertia", "0.5", UNIT, "approximate moment of inertia of either disc")
            .first_route(Evidence::CLOSED_FORM, || {
                data().map_or(f64::NAN, |data| units_in_one(UNIT) * disc(data.diameter, data.thickness))
            })
            .second_route(Evidence::LIMIT_CASE, || {
                // A disc is a ring without a hole: half of its mass times the square of its radius.
                let Some(Data { density, gravity, diameter, thickness }) = data_of_the_sentences() else {
                    return f64::NAN;
                };
                let weight = density * thickness * PI * diameter * diameter / 4.0;
                units_in_one(UNIT) * weight / gravity / 2.0 * diameter * diameter / 4.0
            })
            .with_resolution(|| 0.1)
            .expecting(Verdict::ReadOff)
            .interpreted_as(
                "The thesis announces the value as approximate twice, by the sign in this display and in the next \
                 sentence, so we ask for it to one unit of its only digit. The numbers of the display before give \
                 0.44986. A weight of .2831 would be printed as .283 too, and with it the value rounds to the printed \
                 digit.",
            ),
    ]
}

/// Whether the printed acceleration of gravity, or the next number, is this one rounded.
fn gravity_is(gravity: f64, stated: Stated, what: &str) -> Finding {
    let said = stated.number() + stated.pick(0.0, 1.0);
    Finding::new((said - gravity).abs() <= 0.5, format!("{what} is {gravity:.2}; the printed value is {said}"))
}

/// Moment of inertia of a disc of the printed density and gravity, in in lb sec².
fn disc(diameter: f64, thickness: f64) -> f64 {
    let square = diameter * diameter / 4.0;
    data().map_or(f64::NAN, |data| PI / 2.0 * data.density / data.gravity * square * square * thickness)
}

/// The printed moment of inertia, in in lb sec².
pub(super) fn printed_inertia() -> f64 {
    MEYER.printed_number("meyer.disc.inertia") / units_in_one(UNIT)
}

/// The diameter and the thickness that are stated, in inches, for two discs; the neighbour has a tenth of an inch more in
/// diameter.
fn sizes(stated: Stated) -> [f64; 2] {
    let [diameter, thickness] = match stated.numbers()[..] {
        [2.0, diameter, thickness] => [diameter, thickness],
        _ => [f64::NAN; 2],
    };
    [diameter + stated.pick(0.0, 0.1), thickness]
}

/// Densities of steels in kg/m³, as handbooks have them.
const STEELS: std::ops::RangeInclusive<f64> = 7750.0..=8050.0;

/// By how much less a cubic inch weighs than that of any steel, from the printed number, in pounds.
const LIGHTER: f64 = 0.005;

/// A cubic crystal of one metal.
#[derive(Clone, Copy)]
struct Crystal {
    /// Atoms in a cell.
    atoms: f64,
    /// Mass of an atom in atomic units.
    mass: f64,
    /// Edge of the cell in 10⁻¹⁰ m.
    edge: f64,
}

const IRON: Crystal = Crystal { atoms: 2.0, mass: 55.845, edge: 2.8665 };

impl Crystal {
    /// In kg/m³.
    fn density(self) -> f64 {
        const ATOMIC_UNIT: f64 = 1.660_539_07e-27;
        self.atoms * self.mass * ATOMIC_UNIT / (self.edge * self.edge * self.edge * 1e-30)
    }
}

/// The weight of a cubic inch in pounds as a density in kg/m³.
fn metric_density(weight: f64) -> f64 {
    weight * POUND / (INCH * INCH * INCH)
}

/// The numbers of the estimate, from the display that has them all.
fn data() -> Option<Data<f64>> {
    let tokens = numeric_tokens(MEYER.printed_text("meyer.disc.numbers"));
    let number = |at: usize| tokens.get(at)?.parse::<f64>().ok();
    // The first number stands behind a bare point: three digits of it.
    Some(Data { density: number(2)? / 1000.0, gravity: number(3)?, diameter: number(5)?, thickness: number(8)? })
}

/// The number of the paragraph before the estimate; it begins with its point.
fn steel() -> f64 {
    let text = MEYER.printed_text("meyer.steel");
    text.split(' ').next().and_then(|number| number.parse().ok()).unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use geneva_evidence::Decimal;

    #[test]
    fn a_weight_that_rounds_to_the_printed_one_gives_the_printed_digit_of_the_inertia() {
        let data = data().expect("numbers");
        let printed: Decimal = MEYER.printed_text("meyer.disc.inertia").parse().expect("a number");
        let weight: Decimal = ".283".parse().expect("a number");
        let inertia = |weight: f64| units_in_one(UNIT) * disc(data.diameter, data.thickness) * weight / data.density;
        assert!(weight.is_rounding_of(data.density) && !printed.is_rounding_of(inertia(data.density)));
        assert!(weight.is_rounding_of(0.2831) && printed.is_rounding_of(inertia(0.2831)));
        assert_eq!(format!("{:.5}", inertia(data.density)), "0.44986");
    }
}
