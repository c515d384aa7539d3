//! How long the driver turns while the wheel turns, and while it rests.

use super::fit::ANY;
use super::*;
use geneva_evidence::Decimal;

const TWICE: &str = "The coordinates of the pin at entry confirm the corrected form for 3 to 60 slots.";

/// The page takes the wheel's turn for the driver's turn.
const TURNED: &str = "While a wheel with n slots turns by one slot, 360°/n, the driver turns by 180° − 360°/n, because \
                      the crank is at right angles to the slot at the start and at the end of the move. The page uses \
                      the wheel's angle in place of the driver's angle, but the two are equal for four slots only.";

/// How long a wheel moves, of the calculator.
const DWELL: Slip = Slip {
    id: "wild.firgelli-time.dwell",
    ..slip(
        TURNED,
        TWICE,
        "For more than four slots, the formula gives too long a rest and too short a move. For three slots, it gives \
         too short a rest and too long a move. With six slots the real move takes twice as long as planned, and with \
         eight it takes three times as long.",
    )
};

/// The mistake about how long a wheel moves, on another page.
const MORE_SLOTS: Slip = Slip {
    id: "wild.unseel.six",
    ..slip(TURNED, TWICE, "If you choose more slots to get a longer rest, you get a shorter rest.")
};

pub(super) fn claims() -> Vec<Claim> {
    [calculator(), unseel(), star(), oxiphysics(), fractions(), others(), twelve()].concat()
}

/// The letters of the calculator's rest.
pub(super) fn resting(fit: &Fit) -> Vec<(&'static str, f64)> {
    vec![(r"\theta_{dwell}", fit.resting), ("n", fit.slots)]
}

/// The letters of its move.
pub(super) fn index(fit: &Fit) -> Vec<(&'static str, f64)> {
    let rpm = 7.0 + fit.slots;
    let time = 60.0 / rpm * fit.moving / (2.0 * PI);
    vec![(r"t_{index}", time), (r"\theta_{index}", fit.step), (r"\mathrm{RPM}", rpm)]
}

fn calculator() -> Vec<Claim> {
    vec![
        formula(
            CALCULATOR,
            "wild.firgelli-time.dwell",
            r"\theta_{dwell} = 360^{\circ} \frac{n - 1}{n}",
            "how far the driver turns while the wheel rests",
            ANY,
            resting,
        )
        .corrected(r"\theta_{dwell} = 360^{\circ} \frac{n + 2}{2 n}", DWELL)
        .in_places(2),
        formula(
            CALCULATOR,
            "wild.firgelli-time.index",
            r"t_{index} = \frac{\theta_{index}}{360^{\circ}} \frac{60}{\mathrm{RPM}}",
            "time of one move, from an angle that the page takes as the wheel's step, 360°/n",
            ANY,
            index,
        )
        .interpreted_as(
            "We take the index angle as the wheel's step, as the page says. If it were the angle that the driver turns \
             through, the time would be right, but the page's own dwell angle would not fit.",
        )
        .corrected(r"t_{index} = \frac{180^{\circ} - \theta_{index}}{360^{\circ}} \frac{60}{\mathrm{RPM}}", DWELL),
    ]
}

fn unseel() -> Vec<Claim> {
    let dwell = |id, printed, slots: u32, meaning| {
        number(UNSEEL, id, printed, "%", meaning, slots, |fit| 100.0 * fit.resting / (2.0 * PI))
    };
    let wrong = |id, printed, slots: u32, rounded: &'static str, meaning| {
        // A half goes down, also one that arithmetic has made a little larger.
        let taken = |fit: &Fit| libm::ceil(100.0 * (1.0 - fit.step / (2.0 * PI)) - 0.5 - 1e-9);
        let right = |fit: &Fit| 100.0 * fit.resting / (2.0 * PI);
        number(UNSEEL, id, printed, "%", meaning, slots, taken)
            .right(
                Evidence::CLOSED_FORM,
                move || right(&Fit::by_wheel(slots)),
                Evidence::VECTORS,
                move || right(&Fit::by_vectors(slots)),
            )
            .interpreted_as("We read the number as rounded to a whole per cent, with a half rounded down.")
            .in_error_for(rounded, MORE_SLOTS)
    };
    vec![
        dwell("wild.unseel.four", "75", 4, "rest of a wheel with four slots, as a part of the cycle"),
        wrong("wild.unseel.six", "83", 6, "", "rest of a wheel with six slots, as a part of the cycle"),
        wrong("wild.unseel.eight", "87", 8, "62.5", "rest of a wheel with eight slots, as a part of the cycle"),
    ]
}

fn star() -> Vec<Claim> {
    let resting = |fit: &Fit| fit.resting / (2.0 * PI);
    vec![
        number(
            STAR,
            "wild.geneva-star.turns",
            "270",
            "°",
            "how far the driver turns while a four-slot wheel rests",
            4,
            |fit| fit.resting.to_degrees(),
        ),
        number(
            STAR,
            "wild.geneva-star.four",
            "3/4",
            "",
            "part of the time during which a wheel with four slots rests",
            4,
            resting,
        ),
        number(
            STAR,
            "wild.geneva-star.three",
            "2/3",
            "",
            "part of the time during which a wheel with slots 120° apart rests",
            3,
            |fit| 1.0 - fit.step / (2.0 * PI),
        )
        .right(
            Evidence::CLOSED_FORM,
            move || resting(&Fit::by_wheel(3)),
            Evidence::VECTORS,
            move || resting(&Fit::by_vectors(3)),
        )
        .in_error(slip(
            TURNED,
            TWICE,
            "The dwell is longer than the page says, and the move takes only half the time that the page gives. So a \
             wheel with three slots is quick and rough.",
        )),
    ]
}

fn oxiphysics() -> Vec<Claim> {
    vec![
        formula(
            RIGID,
            "wild.oxiphysics.half-angle",
            r"\alpha = \sin^{-1} \frac{r}{d}",
            "how far the driver turns from the entry of the pin to the line of centres, for crank radius r and centre \
             distance d",
            ANY,
            |fit| vec![(r"\alpha", fit.moving / 2.0), ("r", fit.crank), ("d", fit.centres)],
        )
        .corrected(
            r"\alpha = \cos^{-1} \frac{r}{d}",
            slip(
                "The crank radius r over the centre distance d is the sine of the angle at the wheel's axis, not of \
                 the angle at the driver's axis. In the right-angled triangle of the two axes and the pin, the \
                 driver's angle is a right angle less the wheel's angle.",
                TWICE,
                "By the printed formula a wheel with n slots moves during 1/n of the cycle, which is right for four \
                 slots only. Another module of the same library has the right formula.",
            ),
        ),
        formula(
            CONSTRAINTS,
            "wild.oxiphysics.right-half-angle",
            r"\alpha = \pi/2 - \pi/n",
            "how far the driver turns from the entry of the pin to the line of centres, in another module of the \
             library",
            ANY,
            |fit| vec![(r"\alpha", fit.moving / 2.0), ("n", fit.slots)],
        ),
    ]
}

/// The letters of times and angles, for a driver of speed 3; ω is the time of a move over the angle of a move.
fn times(fit: &Fit) -> Vec<(&'static str, f64)> {
    let speed = 3.0;
    let times = [(r"t_{on}", fit.moving / speed), (r"t_{off}", fit.resting / speed), ("t", 2.0 * PI / speed)];
    [&times[..], &[(r"\theta_{off}", fit.resting), (r"\omega", times[0].1 / fit.moving), ("N", fit.slots)]].concat()
}

/// Whether numbers of slots, each with a part of the cycle behind it, are those of wheels that move for that part; or rest.
fn parts(stated: Stated, by: fn(u32) -> Fit) -> Finding {
    let numbers = stated.decimals();
    let fits = |pair: &[Decimal]| {
        let [slots, part] = pair else { return false };
        let fit = by(slots.to_f64() as u32);
        part.is_rounding_of(stated.pick(fit.moving, fit.resting) / (2.0 * PI))
    };
    let all = numbers.chunks(2).filter(|pair| fits(pair)).count();
    Finding::new(
        all == 3 && numbers.len() == 6,
        format!(
            "for {all} of the {} wheels, the number is the part of the cycle in which the wheel moves",
            numbers.len() / 2
        ),
    )
}

fn fractions() -> Vec<Claim> {
    vec![
        formula(
            ANVILATE,
            "wild.anvilate.advance",
            r"f = (n - 2)/(2 n)",
            "part of the cycle in which the wheel moves",
            ANY,
            |fit| vec![("f", fit.moving / (2.0 * PI)), ("n", fit.slots)],
        ),
        formula(
            ANVILATE,
            "wild.anvilate.dwell",
            r"f = (n + 2)/(2 n)",
            "part of the cycle in which the wheel rests",
            ANY,
            |fit| vec![("f", fit.resting / (2.0 * PI)), ("n", fit.slots)],
        ),
        ANVILATE
            .statement(
                "wild.anvilate.moving",
                "a 4-slot at 0.25, a 6-slot at 0.333, an 8-slot at 0.375",
                "part of the cycle in which wheels of four, six and eight slots move",
            )
            .first_route(Evidence::CLOSED_FORM, |stated| parts(stated, Fit::by_wheel))
            .second_route(Evidence::VECTORS, |stated| parts(stated, Fit::by_vectors))
            .but_not("the wheels rest in these parts"),
        number(ANVILATE, "wild.anvilate.four", "75", "%", "rest of a wheel with four slots", 4, |fit| {
            100.0 * fit.resting / (2.0 * PI)
        }),
        number(ANVILATE, "wild.anvilate.six", "66.7", "%", "rest of a wheel with six slots", 6, |fit| {
            100.0 * fit.resting / (2.0 * PI)
        }),
        number(ANVILATE, "wild.anvilate.eight", "62.5", "%", "rest of a wheel with eight slots", 8, |fit| {
            100.0 * fit.resting / (2.0 * PI)
        }),
        formula(
            MECHANICS,
            "wild.mechanics.half-pitch",
            r"\frac{2 \pi}{2 N} = \theta",
            "half of the angle from slot to slot",
            ANY,
            |fit| vec![(r"\theta", fit.step / 2.0), ("N", fit.slots)],
        ),
        formula(
            MECHANICS,
            "wild.mechanics.on",
            r"\theta_{on} = 2 (\frac{\pi}{2} - \theta) = \pi - \frac{2 \pi}{N} = \pi (1 - \frac{2}{N})",
            "how far the driver turns while the wheel turns",
            ANY,
            |fit| vec![(r"\theta_{on}", fit.moving), (r"\theta", fit.step / 2.0), ("N", fit.slots)],
        ),
        formula(
            MECHANICS,
            "wild.mechanics.off",
            r"\theta_{off} = 2 \pi - \pi (1 - \frac{2}{N}) = \pi (2 - (1 - \frac{2}{N})) = \pi (1 + \frac{2}{N})",
            "how far the driver turns while the wheel rests",
            ANY,
            |fit| vec![(r"\theta_{off}", fit.resting), ("N", fit.slots)],
        ),
        formula(
            MECHANICS,
            "wild.mechanics.ratio",
            r"\frac{t_{on}}{\theta_{off}} = \frac{\pi (1 - \frac{2}{N})}{\pi (1 + \frac{2}{N})}",
            "time of a move over the time of a rest",
            ANY,
            times,
        )
        .corrected(
            r"\frac{t_{on}}{t_{off}} = \frac{\pi (1 - \frac{2}{N})}{\pi (1 + \frac{2}{N})}",
            Slip {
                consequence: Consequence::Derivation,
                origin: Origin::Misprint,
                ..slip(
                    "The page divides the time of a move by the angle through which the driver turns during a rest. \
                     The page must mean the time of the rest, because the right side is the ratio of the driver's \
                     angles in move and rest, and the times of move and rest have the same ratio.",
                    TWICE,
                    "Nothing changes, because the formulas for the two times, which follow on the page, are right.",
                )
            },
        ),
        formula(
            MECHANICS,
            "wild.mechanics.speed",
            r"\omega = \frac{t}{2 \pi}",
            "factor that turns an angle of the driver into a time, where t is the time of a turn",
            ANY,
            times,
        )
        .interpreted_as(
            "The page doesn't say what ω is. The next two lines multiply angles of the driver by t/2π and get times, \
             so we read ω as that factor. If we read it as the driver's angular velocity, for which the letter is \
             common, the line would be upside down.",
        ),
        formula(
            MECHANICS,
            "wild.mechanics.on-time",
            r"t_{on} = \frac{t}{2 \pi} (\pi (1 - \frac{2}{N})) = \frac{t}{2} - \frac{t}{N}",
            "time for which the wheel turns, from the time of a turn of the driver",
            ANY,
            times,
        ),
        formula(
            MECHANICS,
            "wild.mechanics.off-time",
            r"t_{off} = \frac{t}{2 \pi} (\pi (1 + \frac{2}{N})) = \frac{t}{2} + \frac{t}{N}",
            "time for which the wheel rests, from the time of a turn of the driver",
            ANY,
            times,
        ),
    ]
}

fn others() -> Vec<Claim> {
    vec![
        formula(
            MISCELLANEOUS,
            "wild.firgelli-form.dwell",
            r"\theta_{dwell} = 360^{\circ} - (180^{\circ} - 360^{\circ}/N)",
            "how far the driver turns while the wheel rests",
            ANY,
            |fit| vec![(r"\theta_{dwell}", fit.resting), ("N", fit.slots)],
        ),
        formula(
            FIRGELLI_EXTERNAL,
            "wild.firgelli-external.sweep",
            r"\theta_{sweep} = 180^{\circ} - 360^{\circ}/n",
            "how far the driver turns while the wheel turns",
            ANY,
            |fit| vec![(r"\theta_{sweep}", fit.moving), ("n", fit.slots)],
        ),
        formula(
            FIRGELLI_EXTERNAL,
            "wild.firgelli-external.ratio",
            r"x = \frac{180 + 360/n}{180 - 360/n}",
            "time of a rest over the time of a move",
            ANY,
            |fit| vec![("x", fit.resting / fit.moving), ("n", fit.slots)],
        ),
        number(DRIVE, "wild.firgelli-drive.ratio", "3", "", "rest over move of a wheel with four slots", 4, |fit| {
            fit.resting / fit.moving
        }),
        formula(
            LINKAGE,
            "wild.linkage.half-angle",
            r"\alpha = \pi/2 - \pi/n",
            "how far the driver turns from the entry of the pin to the line of centres",
            ANY,
            |fit| vec![(r"\alpha", fit.moving / 2.0), ("n", fit.slots)],
        ),
        number(
            STYLE_SHEET_MEASURED,
            "wild.style-sheet.moving",
            "24.9",
            "%",
            "part of the cycle in which a wheel with four slots moves, measured on its animation at 800 instants",
            4,
            |fit| 100.0 * fit.moving / (2.0 * PI),
        )
        .with_resolution(|| 100.0 / 800.0)
        .interpreted_as("We allow one instant of 800 more or less.")
        .expecting(geneva_evidence::Verdict::ReadOff),
        number(
            PITTER_DRIVER,
            "wild.cherry-pitter.dwell",
            "240",
            "°",
            "arc of the locking cam, which is how far the driver turns while a wheel with six slots rests",
            6,
            |fit| fit.resting.to_degrees(),
        )
        .interpreted_as("We read it as the arc that the mechanism needs. For the cam as it is built, see the example."),
    ]
}

fn twelve() -> Vec<Claim> {
    let of = |id, printed, unit, meaning, quantity| number(ARTOBOLEVSKY, id, printed, unit, meaning, 12, quantity);
    vec![
        of("wild.dmg-lib.idle", "210", "°", "how far the driver turns while a wheel with twelve slots rests", |fit| {
            fit.resting.to_degrees()
        }),
        of("wild.dmg-lib.moving", "150", "°", "how far the driver turns while the wheel turns", |fit| {
            fit.moving.to_degrees()
        }),
        of("wild.dmg-lib.part", "0.4167", "", "part of the time in which the wheel moves", |fit| {
            fit.moving / (2.0 * PI)
        }),
        of("wild.dmg-lib.idle-part", "0.5833", "", "part of the time in which the wheel rests", |fit| {
            fit.resting / (2.0 * PI)
        }),
        of("wild.dmg-lib.coefficient", "0.71", "", "time of a move over the time of a rest", |fit| {
            fit.moving / fit.resting
        }),
    ]
}
