//! How loosely parts are held on their shafts and by their screws, and what that does to wheel and table.

use super::design::WheelDesign;
use crate::number_format::rounded_down;
use crate::{Needs, ReportField};
use geneva_kinematics::bisection::bisect_times;
use geneva_kinematics::wheel::Sizes;
use geneva_workshop::{Keyway, Mounting, ShaftFit};

/// A wheel or a driver that turns on its shaft by more than this to either side, in degrees, gets a warning: our choice.
const MUCH: f64 = 1.0;
/// Halvings of the play with which it turns by just as much.
const HALVINGS: u32 = 40;

/// How loosely the parts of a design are held.
struct Looseness {
    /// The angle by which wheel and driver turn on the flats of their shafts to either side, in radians; none without a flat.
    on_flat: [Option<f64>; 2],
    /// The angle by which the locking disc may be turned against its plate to either side, in radians.
    disc: f64,
}

impl Looseness {
    fn new(sizes: &Sizes, mounting: &Mounting) -> Self {
        let on = |fit: ShaftFit, shaft: f64| fit.turning_play(shaft, sizes.play.bore);
        Self {
            on_flat: [on(mounting.wheel_fit, sizes.wheel_shaft), on(mounting.driver_fit, sizes.plate_shaft)],
            disc: mounting.disc_turn(sizes),
        }
    }
}

impl WheelDesign {
    /// Sizes and how loosely their parts are held; none without a size, and of what can't be mounted.
    fn looseness(&self) -> Option<(&Sizes, Looseness)> {
        let sizes = self.sizes.as_ref()?;
        Some((sizes, Looseness::new(sizes, &self.mounting().ok()?)))
    }

    /// By what angle the locking disc may be turned against its plate to either side, in radians; zero without a size.
    pub(super) fn disc_turn(&self) -> f64 {
        self.looseness().map_or(0.0, |(_, loose)| loose.disc)
    }

    /// What a maker should know about parts that are loose.
    pub(super) fn loose_parts(&self) -> Vec<String> {
        let Some((sizes, loose)) = self.looseness() else { return Vec::new() };
        let shafts = [("wheel", sizes.wheel_shaft), ("driver", sizes.plate_shaft)].into_iter().zip(loose.on_flat);
        let much = shafts.filter_map(|(of, angle)| Some((of, angle?.to_degrees()))).filter(|(_, angle)| *angle > MUCH);
        let fits = self.mounting().map(|mounting| [mounting.wheel_fit, mounting.driver_fit]).unwrap_or_default();
        let turns = much.map(|((part, shaft), angle)| {
            let fit = fits[usize::from(part == "driver")];
            let is_little = |play: f64| fit.turning_play(shaft, play).is_some_and(|angle| angle.to_degrees() <= MUCH);
            let [play, _] = bisect_times(HALVINGS, [0.0, sizes.play.bore], is_little);
            let key = Keyway::of_shaft(shaft).map_or_else(String::new, |_| {
                format!(", or choose --{part}-bore-shape key instead of --{part}-flat")
            });
            format!(
                "the {part} turns by {angle:.1}° to either side on the flat of its shaft: give --bore-play up to {} mm and fit the \
                 bore by hand, or clamp the {part} with a screw{key}",
                rounded_down(play)
            )
        });
        let rim = sizes.locking_disc.map(|disc| disc.radius * libm::sin(loose.disc.min(std::f64::consts::FRAC_PI_2)));
        let apart = rim.zip(sizes.locking_gap()).filter(|(rim, gap)| rim > gap).map(|_| {
            format!(
                "the locking disc may be turned by {:.1}° to either side against its plate, so its crescent is not at the pin: add \
                 --disc-dowel MM and --disc-dowel-circle MM",
                loose.disc.to_degrees()
            )
        });
        turns.chain(apart).collect()
    }
}

/// The name of the rows of the play on a flat: the first of them has it.
pub(super) const PLAY_ON_FLAT: &str = "play on the flat";

/// The fields of what is loose; without numbers where nothing is, and with the axes in another place.
pub(super) fn fields(design: &WheelDesign, in_place: Option<&Sizes>) -> Vec<ReportField> {
    let found = design.looseness();
    let [wheel, driver] = found.as_ref().map_or([None; 2], |(_, loose)| loose.on_flat);
    let degrees = |key, radians: Option<f64>| ReportField::in_unit(key, radians.map(f64::to_degrees), "°");
    let dwell = in_place.and_then(Sizes::dwell_play);
    let (of_wheel, of_driver) =
        (Needs::WHEEL_SHAFT.union(Needs::WHEEL_FLAT), Needs::DRIVER_SHAFT.union(Needs::DRIVER_FLAT));
    let is_screwed = design.question.mounting.pin_screw.is_some();
    let shift = design.sizes.as_ref().filter(|_| is_screwed).map(|sizes| sizes.play.pin);
    let off = design.sizes.as_ref().zip(shift);
    let off = off.map(|(sizes, shift)| libm::asin((shift / (sizes.centre_distance - sizes.crank_radius)).min(1.0)));
    let turn = degrees("disc_turn_deg", found.as_ref().map(|(_, loose)| loose.disc)).needing(Needs::SIZE);
    let turn = if found.is_some_and(|(_, loose)| loose.disc > 0.0) {
        turn.line(
            "disc on its plate",
            "may be turned by so much to either side, as flat or screws let it; it counts in the yield",
        )
    } else {
        turn
    };
    vec![
        degrees("wheel_flat_play_deg", wheel)
            .line(PLAY_ON_FLAT, "of the wheel on its shaft, to either side, in a bore with that play")
            .needing(Needs::SIZE.union(of_wheel)),
        degrees("table_backlash_deg", dwell.zip(wheel).map(|(dwell, wheel)| dwell.middle + wheel))
            .line("", "of what the wheel's shaft turns, with the backlash in the middle of the dwell")
            .needing(Needs::SIZE.union(of_wheel)),
        degrees("driver_flat_play_deg", driver)
            .line(if wheel.is_some() { "" } else { PLAY_ON_FLAT }, "of the driver on its shaft, to either side")
            .needing(Needs::SIZE.union(of_driver)),
        turn,
        ReportField::in_unit("pin_shift_mm", shift, "mm")
            .line(
                "place of a pin",
                "off by so much in any direction, as the holes of its screw let it; limits and yield count it, all places within being \
                 equally likely: our choice",
            )
            .needing(Needs::SIZE.union(Needs::PIN_SCREW)),
        degrees("pin_shift_at_wheel_deg", off)
            .line("", "the wheel is then off by so much at mid-index, to either side")
            .needing(Needs::SIZE.union(Needs::PIN_SCREW)),
    ]
}

#[cfg(test)]
mod tests {
    use crate::wheel::{WheelDesign, WheelQuestion};
    use crate::{ReportField, answer};
    use geneva_kinematics::wheel::as_built::Yield;

    const PRINTED: &str = "wheel --stations 4 --crank-radius 25 --process fdm --wheel-shaft 5 --driver-shaft 5";

    fn number(question: &str, key: &str) -> Option<f64> {
        answer(question).expect(question).field(key).and_then(ReportField::number)
    }

    fn design(question: &str) -> WheelDesign {
        let question = question.strip_prefix("wheel ").unwrap_or(question);
        WheelDesign::new(WheelQuestion::parse(question).expect(question)).expect(question)
    }

    #[test]
    fn a_flat_adds_its_play_to_the_backlash_of_the_table_and_is_warned_of() {
        let flat = format!("{PRINTED} --wheel-flat 4.5 --driver-flat 4.5");
        // The corner of the flat is at arccos(2/2.5) from its middle, and meets that of the bore at arccos(2.4/2.5).
        let turn = ((2.0_f64 / 2.5).acos() - (2.4_f64 / 2.5).acos()).to_degrees();
        for key in ["wheel_flat_play_deg", "driver_flat_play_deg"] {
            assert!((number(&flat, key).expect("a flat") - turn).abs() < 1e-9, "{key}");
            assert_eq!(number(PRINTED, key), None);
        }
        let [table, dwell] =
            ["table_backlash_deg", "dwell_backlash_deg"].map(|key| number(&flat, key).expect("a number"));
        assert!((table - dwell - turn).abs() < 1e-9);
        let warnings = design(&flat).warnings().expect("warnings").join("\n");
        assert!(warnings.contains("the wheel turns by 20.6° to either side on the flat of its shaft"), "{warnings}");
        // The value that the warning names is one with which there is none.
        let (_, play) = warnings.split_once("--bore-play up to ").expect(&warnings);
        let (play, _) = play.split_once(' ').expect("a unit");
        let tight = design(&format!("{flat} --bore-play {play}")).warnings().expect("warnings").join("\n");
        assert!(!tight.contains("flat"), "{tight}");
        let much: f64 = play.parse().expect("a number");
        let loose = design(&format!("{flat} --bore-play {}", 1.01 * much)).warnings().expect("warnings").join("\n");
        assert!(
            loose.contains("flat") && !warnings.contains("bore-shape"),
            "no key is made for a shaft of 5 mm: {warnings}"
        );
    }

    #[test]
    fn a_flat_that_does_not_hold_is_refused_with_values_with_which_it_does() {
        let flat = |more: &str| design(&format!("{PRINTED} --wheel-flat 4.7 {more}")).dxf();
        let said = flat("").expect_err("0.4 mm of play on 0.3 mm of flat").to_string();
        assert!(said.starts_with("--wheel-flat 4.7: wheel: a shaft of 5 mm"), "{said}");
        let [across, play] = ["give --wheel-flat from ", "or --bore-play up to "].map(|words| {
            let (_, number) = said.split_once(words).expect(&said);
            number.split([' ', ',']).next().expect("a number").to_owned()
        });
        assert!(flat(&format!("--bore-play {play}")).is_ok(), "{said}");
        assert!(design(&format!("{PRINTED} --wheel-flat {across}")).dxf().is_ok(), "{said}");
    }

    #[test]
    fn a_screwed_pin_and_a_disc_on_a_flat_count_in_yield_and_limits() {
        let turning = |more: &str| {
            let found = design(&format!("{PRINTED} {more}")).count_assemblies(Yield::default(), 1000);
            found.expect("assemblies").expect("a process").turning
        };
        let screw = "--play 0.5 --pin-diameter 6 --pin-screw M3";
        assert!(turning(screw) + 30 < turning("--play 0.5 --pin-diameter 6 --pin-mount dowel"));
        assert!((number(&format!("{PRINTED} {screw}"), "pin_shift_mm").expect("a screw") - 0.4).abs() < 1e-12);
        let apart = "--driver-flat 4.5 --driver-pieces two-pieces";
        assert!(turning(apart) + 200 < turning("--driver-flat 4.5 --driver-pieces one-piece"));
        assert_eq!(turning(&format!("{apart} --disc-dowel 2 --disc-dowel-circle 12")), turning("--driver-flat 4.5"));
        let warnings = |more: &str| design(&format!("{PRINTED} {more}")).warnings().expect("warnings").join("\n");
        assert!(warnings(apart).contains("--disc-dowel-circle MM") && !warnings("").contains("--disc-dowel-circle MM"));
        // In the worst case, what a pin is off its place leaves less to all sizes.
        let wheel = "wheel --stations 6 --crank-radius 50 --play 0.8 --pin-diameter 8";
        let [screwed, pressed] =
            ["--pin-screw M3", ""].map(|more| number(&format!("{wheel} {more}"), "all_crank_radius_mm").unwrap_or(0.0));
        assert!(screwed < pressed && pressed > 0.0, "{screwed} {pressed}");
    }
}
