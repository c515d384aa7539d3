//! Of the chapter on making a wheel: what no answer has.

use super::kinds::{OUTLINES, PROPORTION, SEARCH, STANDARD};
use super::least;
use super::second_routes::outline::Cut;
use crate::questions::design;
use anyhow::Context;
use geneva_evidence::{Evidence, Numbers, OwnNumber};
use geneva_figures::stations;
use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel, play_of_h8_e8};

/// The numbers of the chapter that are of no answer.
pub fn numbers() -> Vec<OwnNumber> {
    vec![
        OwnNumber::new("making.bite", "{2}&nbsp;mm", OUTLINES, || Ok(-least_gap(1)?)).with_second_route(
            "an arc about the wheel's axis bites",
            OUTLINES,
            || Ok(-least_gap_by_places(true)?),
        ),
        OwnNumber::new("making.passes", "{2}&nbsp;mm", OUTLINES, || Ok(least_gap(2)?)).with_second_route(
            "the crescent lets the horn pass",
            OUTLINES,
            || Ok(least_gap_by_places(false)?),
        ),
        fit("making.fit-6", 1),
        in_fit("making.fit-radius-6", 6),
    ]
}

fn sizes_of(question: &str) -> anyhow::Result<Sizes> {
    design(question)?.sizes.context("a size")
}

/// The sizes of the worked design: all that is not given has its default.
pub fn sizes() -> anyhow::Result<Sizes> {
    sizes_of("worked")
}

/// The least number in a column of the figure of the crescent, in mm.
fn least_gap(column: usize) -> anyhow::Result<f64> {
    let figure = stations::crescent(&sizes()?)?;
    Ok(least(&figure.series.rows.iter().map(|row| row[column]).collect::<Vec<_>>()))
}

/// The least gap in mm between a horn's tip and the locking disc, place by place: with the cut of the drawing, or with an
/// arc about the wheel's axis in mid-index.
fn least_gap_by_places(about_axis: bool) -> anyhow::Result<f64> {
    let sizes = sizes()?;
    let disc = sizes.locking_disc.context("a disc")?;
    let (centre, radius) = if about_axis {
        (sizes.centre_distance, sizes.tip_radius + sizes.play.locking / 2.0)
    } else {
        (disc.crescent.centre, disc.crescent.radius)
    };
    let cut = Cut {
        slots: f64::from(sizes.wheel.stations()),
        centre_distance: sizes.centre_distance,
        crank_radius: sizes.crank_radius,
        rim: sizes.tip_radius,
        arc: sizes.locking_arc_radius,
        disc: disc.radius,
        centre,
        radius,
    };
    Ok(cut.least_gap())
}

/// Ranges of diameters in millimetres, each over one and up to another number, with the least play of the fit H8/e8 and the
/// tolerance of hole and of shaft in micrometres, as the tables of ISO 286 have them.
const FITS: [([f64; 2], u32, u32); 4] =
    [([3.0, 6.0], 20, 18), ([6.0, 10.0], 25, 22), ([10.0, 18.0], 32, 27), ([18.0, 30.0], 40, 33)];

/// Least and greatest play of a fit in millimetres, by the standard's table.
fn tabulated((_, play, tolerance): ([f64; 2], u32, u32)) -> [f64; 2] {
    [play, play + 2 * tolerance].map(|micrometres| f64::from(micrometres) / 1000.0)
}

/// Least and greatest play of a fit for a range of diameters.
fn fit(id: &'static str, range: usize) -> OwnNumber {
    let [over, up_to] = FITS[range].0;
    OwnNumber::new(id, "{.3} to {.3}&nbsp;mm", Evidence::CLOSED_FORM, move || Ok(play_of_h8_e8(over, up_to)))
        .with_second_route("so much play is usual", STANDARD, move || Ok(tabulated(FITS[range])))
}

/// The crank radius in whole millimetres up to which the program's play is no more than that of the fit.
fn in_fit(id: &'static str, stations: u32) -> OwnNumber {
    OwnNumber::new(id, "{.0}&nbsp;mm", SEARCH, move || Ok(last_in_fit(stations)?)).with_second_route(
        "up to there the program's play is usual",
        PROPORTION,
        move || last_in_fit_by_proportion(stations),
    )
}

/// The last radius, tenth by tenth of a millimetre.
fn last_in_fit(stations: u32) -> anyhow::Result<f64> {
    let wheel = Wheel::new(stations)?;
    let of = |radius: f64| Sizes::new(wheel, Scale::CrankRadius(radius), &Choices::default());
    let mut tenths = 10;
    while of(f64::from(tenths + 1) / 10.0)?.looser_than_fit().is_none() {
        tenths += 1;
    }
    Ok(f64::from(tenths / 10))
}

/// The last radius: pin and play are in proportion to the crank radius, so in each range of the standard there is
/// one radius from which on the play is too great.
fn last_in_fit_by_proportion(stations: u32) -> Numbers<f64> {
    const SIZE: f64 = 1000.0;
    let sizes = Sizes::new(Wheel::new(stations)?, Scale::CrankRadius(SIZE), &Choices::default())?;
    let (pin, play) = (sizes.pin_diameter / SIZE, sizes.play.slot / SIZE);
    let too_loose = FITS.into_iter().filter_map(|fit| {
        let ([over, up_to], [_, most]) = (fit.0, tabulated(fit));
        let from = (over / pin).max(most / play);
        (from < up_to / pin).then_some(from)
    });
    // Up to there it is no more than the fit's; a little is left to rounding.
    Ok((too_loose.fold(f64::INFINITY, f64::min) + 1e-9).floor())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::questions::{question, value};
    use geneva_ask::ReportField;
    use geneva_ask::wheel::{WheelDesign, WheelQuestion};
    use geneva_kinematics::wheel::as_built::TestPiece;
    use geneva_kinematics::wheel::{EntryContact, Play, Warning};
    use geneva_live::LiveArguments;

    #[track_caller]
    fn asked(name: &str, key: &str) -> f64 {
        question(name).and_then(|question| value(&question, key)).expect(key)
    }

    #[test]
    fn the_worked_design_is_the_figure_as_it_stands_at_first() {
        let live = geneva_live::by_name("design").expect("a figure");
        let answer = live.answer(&LiveArguments::default()).expect("an answer");
        assert!(answer.figure.svg == stations::dimensions_on_a_page(&sizes().expect("fits")).svg, "another drawing");
        let shown = |name: &str| answer.numbers.iter().find(|number| number.name == name).expect("shown").value;
        for of in live.quantities {
            let Some(key) = of.key else { continue };
            let (asked, shown) = (asked("worked", key), shown(of.name));
            assert!((asked / shown - 1.0).abs() < 1e-12, "{key}: {asked} {shown}");
        }
        // The hint: a little apart the pin knocks less, and farther apart it meets a corner. Another wheel may be another case.
        let of_the_chapter = "With the wheel of this chapter (button six stations), move the axes apart by 0.02 mm";
        assert!(live.hint.contains(of_the_chapter) && live.hint.contains("At 0.06 mm"), "another hint");
        assert!(live.presets.first().is_some_and(|preset| preset.name == "six stations"));
        let other = sizes_of("printed").expect("fits");
        assert_ne!(other.entry(0.06).expect("met").contact, EntryContact::Mouth);
        let sizes = sizes().expect("fits");
        assert_eq!(asked("worked-little-apart", "centre_error_mm"), 0.02);
        assert!(asked("worked-little-apart", "entry_knock_mm_s") < 0.8 * shown("blow"));
        assert_eq!(sizes.entry(0.06).expect("met").contact, EntryContact::Mouth);
    }

    #[test]
    fn the_chapters_words_about_the_play_hold() {
        let (sizes, error) = (sizes().expect("fits"), asked("worked-apart", "centre_error_mm"));
        let play = sizes.dwell_play().expect("a dwell");
        // The chapter says that the axes may be wrong by this much and the wheel runs, and that nearer by as much jams.
        let apart = sizes.entry(error).expect("met");
        assert_eq!(apart.contact, EntryContact::Mouth);
        assert!(sizes.locking_gap().expect("a disc") < error);
        // With two pins the opening is in the arc all the time.
        assert_eq!(sizes_of("worked-two-pins").expect("fits").dwell_play().expect("a dwell").held, 0.0);
        assert!(play.greatest > 10.0 * play.middle && !play.can_miss);
    }

    #[test]
    fn the_chapters_words_about_the_fit_hold() {
        let (sizes, [least, most]) = (sizes().expect("fits"), play_of_h8_e8(6.0, 10.0));
        assert!((6.0..10.0).contains(&sizes.pin_diameter) && (least..most).contains(&sizes.play.slot));
        // Up to the chapter's radius no play is more than the fit's, and a millimetre farther one is.
        let wheel = Wheel::new(6).expect("possible");
        let is_loose = |radius: f64| {
            let sizes = Sizes::new(wheel, Scale::CrankRadius(radius), &Choices::default()).expect("fits");
            sizes.looser_than_fit().is_some()
        };
        let last = last_in_fit(6).expect("fits");
        assert!((10..=10 * last as u32).all(|tenths| !is_loose(f64::from(tenths) / 10.0)), "{last}");
        assert!((0..=10).any(|tenths| is_loose(last + f64::from(tenths) / 10.0)), "{last}");
    }

    #[test]
    fn a_cam_in_the_same_time_has_less_acceleration_with_few_stations_and_more_with_many() {
        let cam = |name| asked(name, "cam_acceleration_share");
        assert!(cam("free-four") < 0.7 && cam("free-six") < 1.0 && cam("free-eight") > 1.1);
    }

    #[test]
    fn the_chapters_words_about_tolerances_hold() {
        let sizes = sizes().expect("fits");
        let limit = sizes.shared_tolerance().expect("one");
        let gap = sizes.locking_gap().expect("a disc");
        // A third of the gap for each of three sizes and the bores' play would be more than the gap.
        assert!(3.0 * limit.locking + sizes.play.bore < gap && 3.0 * gap / 3.0 + sizes.play.bore > gap);
        // All limits grow with the play.
        let choices = Choices { play: Some(Play::from_slot(2.0 * sizes.play.slot)), ..Choices::default() };
        let twice = Sizes::new(sizes.wheel, Scale::CrankRadius(sizes.crank_radius), &choices).expect("fits");
        let twice = twice.shared_tolerance().expect("one");
        for (one, two) in [(limit.locking, twice.locking), (limit.crank, twice.crank), (limit.width, twice.width)] {
            assert!((two / one - 2.0).abs() < 0.1, "{one} {two}");
        }
        // A disc that is only smaller and an arc that is only larger leave the gap to axes and bores.
        let nearer = sizes.centre_tolerance().nearer - sizes.play.bore;
        assert!(nearer > 2.0 * limit.nearer, "{nearer}");
    }

    #[test]
    fn with_the_best_crank_radius_the_force_is_least() {
        let question = design("worked-best").expect("fits").question;
        let force = |crank_radius| {
            let question = WheelQuestion { crank_radius: Some(crank_radius), ..question.clone() };
            let answer = WheelDesign::new(question).and_then(|design| design.answer()).expect("loaded");
            answer.field("peak_pin_force_n").and_then(ReportField::number).expect("a force")
        };
        let best = question.crank_radius.expect("a size");
        for radius in 10..=100 {
            assert!(force(f64::from(radius)) >= force(best), "{radius} mm");
        }
        assert!(force(design("worked-large").expect("fits").crank_radius.expect("a size")) > 2.0 * force(best));
    }

    #[test]
    fn the_blow_is_that_of_the_chapters_formula() {
        let sizes = sizes().expect("fits");
        let sine = (2.0 * sizes.slot_gap() / sizes.crank_radius).sqrt();
        let blow = sizes.entry(0.0).expect("met").closing_speed;
        // sin τ = √(2g/a − (g/a)²).
        assert!((blow / sine - 1.0).abs() < 1e-3, "{blow} {sine}");
    }

    #[test]
    fn the_size_that_the_program_takes_is_the_smallest_preferred_one_with_a_tenth_of_the_tables_inertia() {
        let share = |crank_radius: Option<f64>| {
            let question = design("table").expect("fits").question;
            let recommends_size = crank_radius.is_none();
            // The time of the index is a speed by now.
            let question = WheelQuestion { crank_radius, recommends_size, index_time: None, ..question };
            let design = WheelDesign::new(question).expect("fits");
            let own = design.wheel_inertia.expect("a size");
            (design.crank_radius.expect("a size"), own / design.table_inertia.expect("a table"))
        };
        let (taken, of_table) = share(None);
        // The number before it in the series.
        let before = share(Some(40.0)).1;
        assert!(taken == 45.0 && of_table >= 0.1 && before < 0.1, "{taken} mm: {of_table} {before}");
    }

    #[test]
    fn the_chapters_words_about_the_printed_wheel_hold() {
        let sizes = sizes_of("printed").expect("fits");
        let (share, error) = (asked("printed", "yield"), asked("printed", "process_error_mm"));
        // Its errors are beyond the limits for all sizes at once, if there are any, and yet most assemblies turn.
        let keeps =
            sizes.shared_tolerance().is_some_and(|limit| limit.locking > error / 2.0 && limit.crank > error / 2.0);
        assert!(share > 0.9 && !keeps, "{share}");
        // Its test piece goes up by a twentieth of a millimetre.
        let plays = TestPiece::new(sizes.pin_diameter).expect("a pin").plays;
        assert!(plays.iter().zip(1..).all(|(play, number)| (play - 0.05 * f64::from(number)).abs() < 1e-9));
        assert!(asked("printed", "dwell_backlash_deg") > 10.0 * asked("worked", "dwell_backlash_deg"));
    }

    #[test]
    fn the_worn_wheel_is_that_of_the_example() {
        for (key, within) in [("crank_radius_mm", 0.05), ("centre_distance_mm", 0.1), ("locking_arc_radius_mm", 0.05)] {
            assert!((asked("replaced", key) - asked("worked", key)).abs() < within, "{key}");
        }
    }

    #[test]
    fn no_mouth_of_the_table_is_softer_in_both_cases() {
        let blows = |name| ["knock_mm_s", "greatest_knock_mm_s"].map(|key| asked(name, key));
        let [sharp, worst] = blows("worked");
        for name in ["worked-flat-chamfer", "worked-lead-in"] {
            let [usual, greatest] = blows(name);
            assert!(usual > 3.0 * sharp && greatest < 0.7 * worst, "{name}: {usual} {greatest}");
        }
        for name in ["worked-rounded", "worked-chamfer"] {
            let [usual, greatest] = blows(name);
            assert!(usual > 3.0 * sharp && greatest > worst, "{name}: {usual} {greatest}");
            let warnings = design(name).expect("fits").sizes.expect("a size").warnings();
            assert!(warnings.iter().any(|warning| matches!(warning, Warning::HarderMouth { .. })), "{name}");
        }
    }

    #[test]
    fn with_inertia_alone_the_force_is_least_where_the_wheel_has_a_third_of_the_tables() {
        let table = 0.002; // kg m²
        let design = |radius: f64| {
            let words = format!(
                "--stations 6 --crank-radius {radius} --rpm 60 --inertia {table} --thickness 10 --density 7850"
            );
            WheelDesign::new(WheelQuestion::parse(&words).expect("a question")).expect("fits")
        };
        let own = |radius: f64| design(radius).wheel_inertia.expect("a size");
        let force = |radius: f64| {
            let design = design(radius);
            let loads = design.loads(design.wheel.indexing()).expect("possible").expect("loaded");
            loads.pin_moment().driving.value / radius
        };
        let torque = |radius: f64| {
            let design = design(radius);
            let loads = design.loads(design.wheel.indexing()).expect("possible").expect("loaded");
            loads.crank_torque().driving.value
        };
        let radii: Vec<f64> = (100..600).map(|tenth| f64::from(tenth) / 10.0).collect();
        let best = radii.iter().min_by(|a, b| force(**a).total_cmp(&force(**b))).expect("one of them");
        assert!((own(*best) / table - 1.0 / 3.0).abs() < 0.01);
        // The torque at the crank only grows.
        assert!(radii.windows(2).all(|pair| torque(pair[0]) < torque(pair[1])));
        assert!(asked("worked-three", "peak_crank_torque_nm") > 2.0 * asked("worked", "peak_crank_torque_nm"));
    }

    #[test]
    fn with_up_to_seven_stations_the_crescent_is_about_the_wheels_axis() {
        for stations in 3..=18 {
            let wheel = Wheel::new(stations).expect("possible");
            let sizes = Sizes::new(wheel, Scale::CrankRadius(25.0), &Choices::default()).expect("fits");
            let crescent = sizes.locking_disc.expect("a dwell").crescent;
            assert!(crescent.radius > sizes.tip_radius || stations > 7);
            assert_eq!(crescent.centre == sizes.centre_distance, stations <= 7);
        }
    }

    #[test]
    fn the_backlash_stays_in_the_middle_of_the_dwell_and_is_more_than_ten_times_as_great_at_its_ends() {
        for stations in [3, 4, 6, 8, 12] {
            let wheel = Wheel::new(stations).expect("possible");
            let sizes = Sizes::new(wheel, Scale::CrankRadius(25.0), &Choices::default()).expect("fits");
            let play = sizes.dwell_play().expect("a dwell");
            assert!(play.held > 0.3 && play.greatest > 10.0 * play.middle);
            // The edge holds the wheel with the lever l sin τ.
            let until = 10_f64.to_radians();
            let [forwards, backwards] = sizes.dwell_play_at(until).expect("in the dwell");
            let lever = sizes.centre_distance * until.sin();
            assert!((forwards * lever / sizes.locking_gap().expect("a disc") - 1.0).abs() < 0.15);
            assert_eq!(backwards, play.middle);
        }
    }

    #[test]
    fn the_blow_grows_as_the_square_root_of_the_play() {
        let blow = |play: f64| {
            let choices = Choices { play: Some(Play::from_slot(play)), ..Choices::default() };
            let sizes = Sizes::new(Wheel::new(6).expect("possible"), Scale::CrankRadius(25.0), &choices).expect("fits");
            sizes.entry(0.0).expect("meets the slot").closing_speed
        };
        assert!((blow(0.04) / blow(0.01) - 2.0).abs() < 2e-3);
        assert_eq!(blow(0.0), 0.0);
    }

    #[test]
    fn the_pin_meets_a_corner_where_the_axes_are_too_far_apart() {
        for stations in [3, 4, 6, 12] {
            let wheel = Wheel::new(stations).expect("possible");
            let sizes = Sizes::new(wheel, Scale::CrankRadius(25.0), &Choices::default()).expect("fits");
            let tolerance = sizes.centre_tolerance();
            let beside = tolerance.farther * wheel.half_pitch_angle().sin();
            assert!((beside / sizes.slot_gap() - 1.0).abs() < 0.02);
            assert!(sizes.play.bore < tolerance.nearer && tolerance.nearer < sizes.locking_gap().expect("a disc"));
        }
    }
}
