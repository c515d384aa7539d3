//! Which drivers move a wheel of so many stations within a time, and let it stand for another time at least?
//!
//! A slower driver makes index and dwell longer. So the greatest index gives the least speed and the least dwell the greatest
//! speed, and a driver fits if the least speed is not above the greatest.

use super::kind::{AnyWheel, WheelKind};
use super::times::{SAME, Times};
use crate::number_format::{as_typed, count, number};
use crate::{DataRow, Error, Item, MechanismReport, ReportField};

/// How many pins a driver has, by what heads it. No wheel has a dwell with more.
const PINS: [&str; 6] = ["One pin", "Two pins", "Three pins", "Four pins", "Five pins", "Six pins"];

/// A driver, and the two speeds that the wanted times ask of it.
struct Driver {
    kind: WheelKind,
    pins: u32,
    /// Part of the cycle of index and dwell that the index takes.
    motion: f64,
    /// Time of a turn in seconds at which the index is as long as it may be.
    longest: f64,
    /// Time of a turn in seconds at which the dwell is as short as it may be.
    shortest: f64,
}

impl Driver {
    /// The driver of a wheel with a dwell; none if the wheel has none.
    fn new(wheel: &AnyWheel, times: Times) -> Option<Self> {
        let (motion, pins) = (wheel.indexing().motion_fraction(), wheel.indexing().pins());
        let cycles = f64::from(pins);
        let [longest, shortest] = [cycles * times.index / motion, cycles * times.dwell / (1.0 - motion)];
        let has_dwell = wheel.indexing().dwell_fraction() > SAME;
        has_dwell.then_some(Self { kind: wheel.kind(), pins, motion, longest, shortest })
    }

    fn fits(&self) -> bool {
        self.shortest <= self.longest * (1.0 + SAME)
    }

    /// Index and dwell in seconds if a turn lasts so many.
    fn times(&self, turn: f64) -> Times {
        let cycle = turn / f64::from(self.pins);
        Times { index: self.motion * cycle, dwell: (1.0 - self.motion) * cycle }
    }

    fn item(&self, stations: u32, wanted: Times) -> Item {
        let (slow, fast) = (self.times(self.longest), self.times(self.shortest));
        let name = format!(
            "{}, {}, {}",
            self.kind.name(),
            count(stations as usize, "station"),
            count(self.pins as usize, "pin")
        );
        // What is left over, or lacking.
        let compared = |time: f64, of: f64| match 100.0 * (time / of - 1.0) {
            more if more.abs() <= 100.0 * SAME => "as wanted".to_owned(),
            more if more > 0.0 => format!("{} % longer than wanted", number(more)),
            less => format!("{} % shorter than wanted", number(-less)),
        };
        let (dwell, index) = (compared(slow.dwell, wanted.dwell), compared(fast.index, wanted.index));
        let [for_index, for_dwell] =
            if self.fits() { ["least speed", "greatest speed"] } else { ["for the index", "for the dwell"] };
        let [slow_rpm, fast_rpm] = [self.longest, self.shortest].map(|turn| 60.0 / turn);
        Item {
            heading: PINS.get(self.pins as usize - 1).copied().unwrap_or_default(),
            fields: vec![
                ReportField::in_unit("least_rpm", slow_rpm, "rpm").line(for_index, name),
                ReportField::in_unit("greatest_turn_s", self.longest, "s").line("", "a turn"),
                ReportField::in_unit("greatest_index_time_s", slow.index, "s").line("", "index, the longest you allow"),
                ReportField::in_unit("greatest_dwell_time_s", slow.dwell, "s").line("", format!("dwell, {dwell}")),
                ReportField::in_unit("greatest_rpm", fast_rpm, "rpm").line(for_dwell, ""),
                ReportField::in_unit("least_turn_s", self.shortest, "s").line("", "a turn"),
                ReportField::in_unit("least_index_time_s", fast.index, "s").line("", format!("index, {index}")),
                ReportField::in_unit("least_dwell_time_s", fast.dwell, "s").line("", "dwell, the shortest you allow"),
            ],
            row: DataRow(vec![
                ("type", self.kind.name().into()),
                ("stations", stations.into()),
                ("pins", self.pins.into()),
                ("fits", self.fits().into()),
                ("least_rpm", slow_rpm.into()),
                ("greatest_rpm", fast_rpm.into()),
                ("least_turn_s", self.shortest.into()),
                ("greatest_turn_s", self.longest.into()),
                ("least_index_time_s", fast.index.into()),
                ("greatest_index_time_s", slow.index.into()),
                ("least_dwell_time_s", fast.dwell.into()),
                ("greatest_dwell_time_s", slow.dwell.into()),
            ]),
        }
    }
}

const FITTING: &str = "\
From the least speed on the index is short enough, and up to the greatest speed the dwell is long enough. So these drivers fulfil \
both at every speed between the two.";
const NONE: &str = "\
No driver at constant speed fulfils both: the index is short enough only from one speed on, but the dwell is long enough only up to \
another, which is slower. This driver comes nearest.";

/// The drivers with which a wheel of so many stations moves within the time of an index and stands for that of a dwell at least,
/// of one kind or of all; or the one that comes nearest.
///
/// # Errors
///
/// A number of stations that no wheel has.
pub fn speeds(times: Times, stations: u32, kind: Option<WheelKind>) -> Result<MechanismReport, Error> {
    let kinds = WheelKind::ALL.into_iter().filter(|of| kind.is_none_or(|kind| kind == *of));
    let mut drivers = Vec::new();
    for kind in kinds {
        AnyWheel::new(kind, stations, 1)?;
        let pins = (1..).zip(PINS).map(|(pins, _)| pins);
        let wheels = pins.filter_map(|pins| AnyWheel::new(kind, stations, pins).ok());
        drivers.extend(wheels.filter_map(|wheel| Driver::new(&wheel, times)));
    }
    let is_found = drivers.iter().any(Driver::fits);
    if is_found {
        drivers.retain(Driver::fits);
    } else {
        // By the ratio of the two speeds, which is what is lacking.
        drivers.sort_by(|a, b| (a.shortest / a.longest).total_cmp(&(b.shortest / b.longest)));
        drivers.truncate(1);
    }
    let Times { index, dwell } = times;
    let [most, least] = [index, dwell].map(as_typed);
    let note = if is_found {
        String::new()
    } else {
        format!(
            "For wheels with other numbers of stations, leave out --stations. With {}, a driver that stops in the dwell, or \
             whose speed varies, can fulfil both.",
            count(stations as usize, "station")
        )
    };
    Ok(MechanismReport {
        title: format!(
            "Drivers for {}, an index of at most {most} s and a dwell of at least {least} s",
            count(stations as usize, "station")
        ),
        introduction: if is_found { FITTING } else { NONE },
        sections: vec![(
            "Wanted",
            vec![
                ReportField::in_unit("index_time_s", index, "s").line("index", "at most"),
                ReportField::in_unit("dwell_time_s", dwell, "s").line("dwell", "at least"),
            ],
        )],
        list: Some(("drivers", drivers.iter().map(|driver| driver.item(stations, times)).collect())),
        note,
    })
}
