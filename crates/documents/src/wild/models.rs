//! Wheels that are shipped as examples, with sizes that can be measured, and what their drawings say.
//!
//! No page says of an example that it is right. But the example is built, so we can tell what it does. A wheel fits its
//! driver if the pin's centre comes to the rim where the slot is, half a pitch from the line of centres, and the wheel
//! is at rest then. Examples are counted apart from what is stated.

use super::fit::{ANY, counted};
use super::*;
use geneva_evidence::agreement::vanishes;
use geneva_evidence::tex::{Letters, by_name, value};
use geneva_kinematics::Turn;
use geneva_kinematics::pin_slot::{pin_from_pivot, velocity_ratio};
use nalgebra::Vector2;

const TWICE: &str = "We used coordinates to compare the pin's velocity with the slot's direction.";
const EXAMPLE: &str = "We take the sizes as an example of a wheel whose pin meets its slot and enters along it, although \
                       the page does not say that it does.";

/// A wheel as it is drawn, lengths in one unit.
#[derive(Clone, Copy)]
struct Drawn {
    slots: u32,
    crank: f64,
    centres: f64,
    rim: f64,
}

pub(super) fn claims() -> Vec<Claim> {
    vec![
        freecad(),
        freecad_count(),
        model3d(),
        cadbuildr(),
        sdfx(),
        counter(),
        pitter(),
        pitter_crank(),
        pitter_arcs(),
        pitter_cam(),
    ]
}

impl Drawn {
    /// The model's driver with the wheel that fits it.
    fn fitting(self) -> Self {
        let centres = self.crank / libm::sin(PI / f64::from(self.slots));
        Self { centres, rim: (centres * centres - self.crank * self.crank).sqrt(), ..self }
    }

    /// The model's axes with the wheel's radius that fits them.
    fn with_fitting_rim(self) -> Self {
        Self { rim: self.centres * libm::cos(PI / f64::from(self.slots)), ..self }
    }

    /// The crank's angle at which the pin's centre comes to the rim, if it does.
    fn at_the_rim(&self) -> Option<f64> {
        let (a, c, r) = (self.crank, self.centres, self.rim);
        let cosine = (a * a + c * c - r * r) / (2.0 * a * c);
        (cosine.abs() < 1.0).then(|| libm::acos(cosine))
    }

    /// By the formula crate: where the pin comes to the rim, in half pitches from the line of centres, and how fast the
    /// wheel must turn then, for a driver of speed one.
    fn entry(&self) -> Option<[f64; 2]> {
        let (ratio, turn) = (self.centres / self.crank, Turn::from_radians(self.at_the_rim()?));
        let pin = pin_from_pivot(&ratio, &turn);
        Some([libm::atan2(pin.y, pin.x) * f64::from(self.slots) / PI, velocity_ratio(&ratio, &turn)])
    }

    /// Where the pin comes to the rim and how fast the wheel must turn then, by coordinates: the pin from the driver's axis,
    /// and the part of its velocity across the slot.
    fn entry_by_coordinates(&self) -> Option<[f64; 2]> {
        // Where the circles of the pin and of the rim meet, by the distances of that place from the line of centres.
        let [a, c, r] = [self.crank, self.centres, self.rim];
        let along = (c * c + r * r - a * a) / (2.0 * c);
        let aside = (r * r - along * along).sqrt();
        // Circles that only touch let the pin not into the wheel.
        (aside > 0.0).then(|| {
            let (pin, arm) = (Vector2::new(along, aside), Vector2::new(along - c, aside));
            let velocity = Vector2::new(arm.y, -arm.x);
            let across = Vector2::new(-pin.y, pin.x) / r;
            [libm::acos(along / r) * f64::from(self.slots) / PI, velocity.dot(&across) / r]
        })
    }

    /// Whether the pin comes to the rim at the slot, with the wheel at rest.
    fn fits(&self, entry: Option<[f64; 2]>) -> Finding {
        let Some([place, speed]) = entry else {
            return Finding::new(false, "the pin's centre never comes inside the rim");
        };
        let how = if vanishes(place - 1.0) && vanishes(speed) {
            "the pin comes to the rim at the slot, and the wheel starts from rest".to_owned()
        } else {
            format!(
                "when the pin reaches the rim, the wheel's speed should be zero, and it is {speed:.3} times the \
                 driver's speed. As seen from the wheel's axis, the pin should be at the slot's angle from the line of \
                 centres, and it is at {place:.3} times this angle"
            )
        };
        Finding::new(vanishes(place - 1.0) && vanishes(speed), how)
    }
}

/// An example, the wheel of its characters, and how it would fit.
fn example(
    place: Locator,
    id: &'static str,
    printed: &'static str,
    meaning: &'static str,
    wheel: fn(Stated) -> Drawn,
    (corrected, slip): (&'static str, Slip),
) -> Claim {
    place
        .example(id, printed, meaning)
        .first_route(Evidence::CLOSED_FORM, move |stated| wheel(stated).fits(wheel(stated).entry()))
        .second_route(Evidence::VECTORS, move |stated| wheel(stated).fits(wheel(stated).entry_by_coordinates()))
        .interpreted_as(EXAMPLE)
        .corrected(corrected, slip)
}

/// A formula of a program in TeX; its functions take degrees.
fn in_tex(formula: &str) -> String {
    let signs = [("√", r"\sqrt "), ("·", r"\cdot"), ("*", r"\cdot"), ("tan(", r"\tan(1^{\circ} ")];
    signs.iter().fold(formula.to_owned(), |formula, (sign, tex)| formula.replace(sign, tex))
}

/// The size behind this name in characters that name several, parted by commas; not a number if none has it.
pub(super) fn size(characters: &str, name: &str) -> f64 {
    let formula = characters.split([':', ',']).find_map(|part| part.trim().strip_prefix(name));
    formula.map_or(f64::NAN, |formula| value(&in_tex(formula), &Letters::new()))
}

/// The sizes a, b and n in the characters of the macro's example: crank radius, wheel radius and number of slots.
pub(super) fn macro_sizes(characters: &str) -> (f64, f64, u32) {
    (size(characters, "a ="), size(characters, "b ="), whole(size(characters, "n =")))
}

/// A number as a count; zero if it is not an integer.
pub(super) fn whole(number: f64) -> u32 {
    if number.fract() == 0.0 { number as u32 } else { 0 }
}

fn freecad() -> Claim {
    example(
        MACRO,
        "wild.freecad.example",
        "a = 25.0, b = 60.0, n = 6",
        "crank radius a, wheel radius b and number n of slots of the macro as it is shipped, version 1.0",
        |stated| {
            let (crank, rim, slots) = macro_sizes(stated.characters());
            Drawn { slots, crank, centres: libm::hypot(crank, rim), rim }
        },
        (
            r"a = 25.0, b = 25 \sqrt{3}, n = 6",
            slip(
                "For any two radii, the program makes the triangle of the two axes and the pin right-angled. But for \
                 the pin to meet a slot, the angle at the wheel's axis must also be half the angle between two slots, \
                 and with two given radii this is so for at most one number of slots. A comment in the program gives \
                 formulas in which you can choose only one radius.",
                TWICE,
                "The centre line of the waiting slot misses the pin's circle by more than the pin's radius. So the pin \
                 strikes a wall beside the slot, and the example cannot turn.",
            ),
        ),
    )
}

/// The macro's p and tolerance t, as shipped.
pub(super) const SHIPPED: [f64; 2] = [4.0, 0.01];

fn freecad_count() -> Claim {
    // How many slots are cut, and what is between two of them in degrees.
    let cut = |stated: Stated, slots: u32| {
        let (count, pitch) = stated.characters().split_once(", ").unwrap_or_default();
        let count = count.strip_prefix("range(").and_then(|count| count.strip_suffix(')')).unwrap_or_default();
        let letters = by_name([("n", f64::from(slots))]);
        (whole(value(count, &letters)), value(pitch, &letters))
    };
    MACRO
        .example(
            "wild.freecad.count",
            "range(6), 60",
            "how many slots are cut if you ask for n, and how many degrees apart they are",
        )
        .first_route(Evidence::CLOSED_FORM, move |stated| {
            counted(ANY, |slots| {
                let (count, pitch) = cut(stated, slots);
                Some(count == slots && vanishes(pitch.to_radians() - Fit::by_wheel(slots).step))
            })
        })
        .second_route(Evidence::VECTORS, move |stated| {
            counted(ANY, |slots| {
                // Every direction of a slot must be cut, and nothing else.
                let (count, pitch) = cut(stated, slots);
                let direction = |angle: f64| Vector2::new(libm::cos(angle), libm::sin(angle));
                let cuts: Vec<_> = (0..count).map(|at| direction(f64::from(at) * pitch.to_radians())).collect();
                let wanted = |at: u32| direction(f64::from(at) * 2.0 * PI / f64::from(slots));
                let is_cut = |at: u32| cuts.iter().any(|cut| vanishes((cut - wanted(at)).norm()));
                Some(cuts.len() == slots as usize && (0..slots).all(is_cut))
            })
        })
        .interpreted_as("The macro asks for the number of slots, so we tried it for 3 to 60.")
        .corrected(
            "range(n), 360/n",
            slip(
                "The loops that cut slots and arcs always use six slots and the angle for six, whatever number you ask for.",
                "We went through the directions of all slots, one by one.",
                "If you ask for more or fewer slots than six, the wheel still gets six. The version of the macro that \
                 opens a window cuts as many slots as you ask for.",
            ),
        )
}

fn model3d() -> Claim {
    example(
        MODEL3D,
        "wild.model3d.example",
        "4 slots: driven radius 1.0, centres 1.8",
        "radius of the driven wheel, in a program whose pin circle has the right radius (the centre distance over √2); \
         we leave out the slack of 0.015 and the rounding of the wheel's tips",
        |stated| {
            let [rim, centres] = ["driven radius", "centres"].map(|name| size(stated.characters(), name));
            Drawn { slots: stated.count(), crank: centres / 2f64.sqrt(), centres, rim }
        },
        (
            "4 slots: driven radius 0.9 √2, centres 1.8",
            slip(
                "The rim is cut short. So by the time the pin comes to the rim, the pin has passed the place where it \
                 would slide in along the slot.",
                TWICE,
                "An ideal pin, without thickness or play, starts the wheel with a jump in speed. The page says, \
                 however, that a 3D-printed mechanism works.",
            ),
        ),
    )
}

fn cadbuildr() -> Claim {
    example(
        CADBUILDR,
        "wild.cadbuildr.example",
        "4 slots: cross 0.8 (2 · 50/√2 + 4), centres 50",
        "diameter of the driven cross, in a program whose pin circle has the right radius",
        |stated| {
            let [across, centres] = ["cross", "centres"].map(|name| size(stated.characters(), name));
            Drawn { slots: stated.count(), crank: centres / 2f64.sqrt(), centres, rim: across / 2.0 }
        },
        (
            "4 slots: cross 2 · 50/√2, centres 50",
            slip(
                "The rim is cut short. So by the time the pin comes to the rim, the pin has passed the place where it \
                 would slide in along the slot.",
                TWICE,
                "An ideal pin, without thickness or play, starts the wheel with a jump in speed.",
            ),
        ),
    )
}

fn sdfx() -> Claim {
    example(
        SDFX_EXAMPLE,
        "wild.sdfx.example",
        "6 slots: centres 50.0, driven radius 40.0",
        "centre distance and wheel radius of a program's first example, where the pin is placed so that it meets the \
         mouth of the slot",
        |stated| {
            let [centres, rim] = ["centres", "driven radius"].map(|name| size(stated.characters(), name));
            let (slots, twice) = (stated.count(), 2.0 * centres * rim);
            let square = centres * centres + rim * rim - twice * libm::cos(PI / f64::from(slots));
            Drawn { slots, crank: square.sqrt(), centres, rim }
        },
        (
            "6 slots: centres 50.0, driven radius 25 √3",
            slip(
                "The program computes the crank radius from the wheel radius, so for any wheel radius the pin \
                 meets the mouth of the slot. But the pin moves along the slot there only with the right wheel radius.",
                TWICE,
                "An ideal pin, without thickness or play, starts the wheel with a jump in speed. In the second example \
                 of the program, with ten slots, the pin first pushes the wheel back.",
            ),
        ),
    )
}

fn counter() -> Claim {
    example(
        COUNTER,
        "wild.counter.example",
        "5 slots: r/tan(180/5) - 5 - 0.35",
        "radius of the wheel as it is drawn, for crank radius r (the program subtracts the pin's radius and a \
         clearance)",
        |stated| {
            let (slots, crank) = (stated.count(), 25.0);
            let (_, rim) = stated.characters().split_once(": ").unwrap_or_default();
            let rim = value(&in_tex(rim), &by_name([("r", crank)]));
            Drawn { rim, ..Drawn { slots, crank, centres: crank, rim }.fitting() }
        },
        (
            "5 slots: r/tan(180/5)",
            slip(
                "Because the wheel is drawn too small, the pin's centre comes to the rim late, when it has passed the \
                 centre line of the slot.",
                TWICE,
                "An ideal pin, without thickness or play, starts the wheel with a jump in speed.",
            ),
        ),
    )
}

fn pitter() -> Claim {
    let drawn = Drawn { slots: 6, crank: 30.0, centres: 60.0, rim: f64::NAN };
    PITTER_WHEEL
        .value("wild.cherry-pitter.rim", "52", "mm", "radius of a wheel with six slots, for a centre distance of 60 mm")
        .first_route(Evidence::CLOSED_FORM, move || drawn.with_fitting_rim().rim)
        .second_route(Evidence::VECTORS, move || drawn.fitting().rim)
}

fn pitter_crank() -> Claim {
    PITTER_DRIVER
        .value(
            "wild.cherry-pitter.crank",
            "30",
            "mm",
            "distance of the pin from the driver's axis, for six slots and axes 60 mm apart",
        )
        .first_route(Evidence::CLOSED_FORM, || 60.0 * libm::sin(PI / 6.0))
        .second_route(Evidence::VECTORS, || {
            let fit = Fit::by_vectors(6);
            60.0 * fit.crank / fit.centres
        })
}

fn pitter_cam() -> Claim {
    let sizes = |stated: Stated| ["cam radius", "cut width"].map(|name| size(stated.characters(), name));
    let found = |edge: f64| {
        let entry = Fit::by_wheel(6).moving / 2.0;
        let (arc, past) = (360.0 - 2.0 * edge.to_degrees(), (entry - edge).to_degrees());
        Finding::new(
            (edge - entry).abs() < 1e-3,
            format!(
                "as the pin enters, the cam's arc of {arc:.1}° should end on the line of centres, and it ends \
                 {past:.0}° past this line"
            ),
        )
    };
    PITTER_DRIVER
        .example(
            "wild.cherry-pitter.cam",
            "cam radius 22.0, cut width 30.0",
            "width of the cut in the locking cam, which keeps an arc of 240° according to the drawing",
        )
        .first_route(Evidence::CLOSED_FORM, move |stated| {
            let [radius, width] = sizes(stated);
            found(libm::asin(width / 2.0 / radius))
        })
        .second_route(Evidence::VECTORS, move |stated| {
            // Places on the cam's rim, from the pin's direction on, until one is no longer inside the box.
            let [radius, width] = sizes(stated);
            let steps = (0..=18_000_u32).map(|step| f64::from(step) * PI / 18_000.0);
            found(steps.take_while(|angle| radius * libm::sin(*angle) < width / 2.0).last().unwrap_or(f64::NAN))
        })
        .corrected(
            "cam radius 22.0, cut width 22 √3",
            slip(
                "The cut must reach 60° to either side of the pin, because the pin enters 60° before the line of \
                 centres. But the box that makes the cut is too narrow for that.",
                "We used coordinates to check points all along the cam's rim.",
                "The cam keeps an arc of 274° instead of 240°. So as the pin enters, the cam still reaches 17° past \
                 the line of centres and holds the wheel.",
            ),
        )
}

fn pitter_arcs() -> Claim {
    PITTER_WHEEL
        .example(
            "wild.cherry-pitter.arcs",
            "i * 60 for slots and arcs",
            "directions of the wheel's slots and locking arcs in degrees, where i counts them",
        )
        .first_route(Evidence::CLOSED_FORM, |stated| {
            let fit = Fit::by_wheel(6);
            found_a_slot(stated, libm::asin(fit.crank / fit.centres))
        })
        .second_route(Evidence::VECTORS, |stated| {
            let fit = Fit::by_vectors(6);
            let leaves = Vector2::new(fit.centres - fit.crank * libm::cos(fit.moving / 2.0), {
                fit.crank * libm::sin(fit.moving / 2.0)
            });
            found_a_slot(stated, libm::atan2(leaves.y, leaves.x))
        })
        .corrected(
            "i * 60 for slots, i * 60 + 30 for arcs",
            slip(
                "While the wheel rests, one of its arcs lies on the driver's disc, on the line of centres. So the \
                 slot that the pin has left and the slot that it enters next are half a pitch away from the arc, one \
                 on either side.",
                "We used coordinates to find where the pin leaves.",
                "The arcs cut away the mouths of the slots, and while the wheel rests, no slot is where the pin \
                 arrives.",
            ),
        )
}

/// The six directions of slots or arcs in characters that have a formula in i for each, in radians.
fn directions(characters: &str, of: &str) -> [f64; 6] {
    let parts = || characters.split(", ").filter_map(|part| part.split_once(" for "));
    let formula = parts().find(|(_, names)| names.contains(of)).map_or(String::new(), |(formula, _)| in_tex(formula));
    [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(|i| value(&formula, &by_name([("i", i)])).to_radians())
}

/// Whether at rest one of the slots has the direction in which the pin leaves the wheel, whichever arc then points to the
/// driver.
fn found_a_slot(stated: Stated, leaves: f64) -> Finding {
    let [slots, arcs] = ["slots", "arcs"].map(|of| directions(stated.characters(), of));
    let gap = |slot: f64, arc: f64| {
        let off = slot - arc - leaves;
        (off - 2.0 * PI * libm::round(off / (2.0 * PI))).abs()
    };
    let nearest = |arc: &f64| slots.iter().map(|slot| gap(*slot, *arc)).fold(f64::INFINITY, f64::min);
    let nearest = arcs.iter().map(nearest).fold(0.0, f64::max);
    Finding::new(
        vanishes(nearest),
        format!(
            "the pin leaves at {:.0} degrees from the line of centres, where a slot should be, and the nearest slot is \
             {:.0} degrees from there",
            leaves.to_degrees(),
            nearest.to_degrees()
        ),
    )
}
