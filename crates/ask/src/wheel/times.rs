//! Which wheel has a wanted time of index and of dwell?
//!
//! The ratio of the two times is fixed by the kind of wheel and the numbers of stations and pins, and only the driver's
//! speed is free: so the nearest ratios are looked for, and the driver's speed is such that index and dwell together last
//! as long as is wanted.

use super::kind::{AnyWheel, WheelKind};
use crate::number_format::{as_typed, count, number};
use crate::{DataRow, Item, MechanismReport, ReportField};

/// Wanted times, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// Of one index.
    pub index: f64,
    /// Of one dwell.
    pub dwell: f64,
}

/// How many are proposed, by what heads them.
const PROPOSED: [&str; 5] = ["Nearest", "Second", "Third", "Fourth", "Fifth"];
/// Stations that are proposed: with more, a wheel's times hardly change, and its parts are small. What is said of all wheels
/// is said of these.
const STATIONS: std::ops::RangeInclusive<u32> = 3..=60;
/// A part of the cycle that is as wanted but for rounding.
pub(super) const SAME: f64 = 1e-9;

/// A kind, its numbers and the part of the cycle in which its wheel moves.
#[derive(Clone, Copy)]
struct Candidate {
    kind: WheelKind,
    /// None if any number will do.
    stations: Option<u32>,
    pins: u32,
    /// Index over index and dwell.
    motion: f64,
}

/// All that have a dwell; of spherical wheels one stands for all numbers of stations, which have one ratio.
fn candidates(kind: WheelKind) -> Vec<Candidate> {
    let stations = if kind == WheelKind::Spherical { 3..=3 } else { STATIONS };
    let of = |stations: u32, pins: u32| {
        let wheel = AnyWheel::new(kind, stations, pins).ok()?;
        let motion = wheel.indexing().motion_fraction();
        let stations = (kind != WheelKind::Spherical).then_some(stations);
        (wheel.indexing().dwell_fraction() > SAME).then_some(Candidate { kind, stations, pins, motion })
    };
    stations.flat_map(|stations| (1..=6).filter_map(move |pins| of(stations, pins))).collect()
}

impl Candidate {
    /// Turn of the driver in an index and in a dwell, in degrees.
    fn angles(&self) -> [f64; 2] {
        let cycle = 360.0 / f64::from(self.pins);
        [self.motion * cycle, (1.0 - self.motion) * cycle]
    }
}

/// The wheels of one kind, or of all, that come nearest to what is wanted in something.
///
/// The nearest comes first; of equals the one with fewer stations.
fn nearest(wanted: f64, kind: Option<WheelKind>, of: impl Fn(&Candidate) -> f64) -> Vec<Candidate> {
    let kinds = WheelKind::ALL.into_iter().filter(|of| kind.is_none_or(|kind| kind == *of));
    let mut all: Vec<_> = kinds.flat_map(candidates).collect();
    let error = |candidate: &Candidate| (of(candidate) - wanted).abs();
    all.sort_by(|a, b| error(a).total_cmp(&error(b)).then(a.stations.cmp(&b.stations)));
    all.truncate(PROPOSED.len());
    all
}

/// The times and the speed of a candidate whose cycle lasts so many seconds.
fn row(of: &Candidate, cycle: f64) -> DataRow {
    DataRow(vec![
        ("type", of.kind.name().into()),
        ("stations", of.stations.into()),
        ("pins", of.pins.into()),
        ("rpm", (60.0 / (cycle * f64::from(of.pins))).into()),
        ("index_time_s", (of.motion * cycle).into()),
        ("dwell_time_s", ((1.0 - of.motion) * cycle).into()),
        ("dwell_over_index", ((1.0 - of.motion) / of.motion).into()),
    ])
}

const INTRODUCTION: &str = "\
The ratio of dwell to index depends only on the kind of wheel and its numbers of stations and pins. The driver's speed \
only makes the whole cycle faster or slower. These wheels come nearest, each at the speed at which index and dwell together \
last as long as you want.";

/// Which wheels come nearest to wanted times: of one kind, or of all.
pub fn proposals(times: Times, kind: Option<WheelKind>) -> MechanismReport {
    let Times { index, dwell } = times;
    let (cycle, wanted) = (index + dwell, index / (index + dwell));
    let found = nearest(wanted, kind, |of| of.motion);
    let items = PROPOSED.into_iter().zip(&found);
    let items = items.map(|(heading, of)| Item { heading, fields: lines(of, cycle, wanted), row: row(of, cycle) });
    let is_exact = found.first().is_some_and(|of| (of.motion - wanted).abs() <= SAME);
    MechanismReport {
        title: format!("Wheels nearest to an index of {} s and a dwell of {} s", as_typed(index), as_typed(dwell)),
        introduction: INTRODUCTION,
        sections: vec![(
            "Wanted",
            vec![
                ReportField::in_unit("index_time_s", index, "s"),
                ReportField::in_unit("dwell_time_s", dwell, "s"),
                ReportField::in_unit("dwell_over_index", dwell / index, "× index").line("dwell", "the wanted ratio"),
            ],
        )],
        list: Some(("proposals", items.collect())),
        note: if is_exact { String::new() } else { bounds(wanted, kind) },
    }
}

/// Its kind and its numbers in words.
fn name(of: &Candidate) -> String {
    let numbers = match of.stations {
        Some(stations) => count(stations as usize, "station"),
        None => "any number of stations".to_owned(),
    };
    format!("{}, {numbers}, {}", of.kind.name(), count(of.pins as usize, "pin"))
}

const OF_ANGLES: &str = "\
While the wheel stands still, the driver turns through an angle that depends only on the kind of wheel and its numbers of \
stations and pins. Of these wheels it comes nearest to the one you want.";

/// Which wheels come nearest to a wanted turn of the driver in each dwell, in degrees: of one kind, or of all.
pub fn proposals_for_angle(dwell: f64, kind: Option<WheelKind>) -> MechanismReport {
    let found = nearest(dwell, kind, |of| of.angles()[1]);
    let item = |(heading, of): (&'static str, &Candidate)| {
        let [moving, standing] = of.angles();
        let row = DataRow(vec![
            ("type", of.kind.name().into()),
            ("stations", of.stations.into()),
            ("pins", of.pins.into()),
            ("index_angle_deg", moving.into()),
            ("dwell_angle_deg", standing.into()),
            ("dwell_over_index", (standing / moving).into()),
        ]);
        let fields = vec![
            ReportField::in_unit("dwell_angle_deg", standing, "°").line("dwell", name(of)),
            ReportField::in_unit("index_angle_deg", moving, "°").line("index", "turn of the driver"),
            ReportField::in_unit("dwell_over_index", standing / moving, "× index").line("", "dwell"),
        ];
        Item { heading, fields, row }
    };
    let is_exact = found.first().is_some_and(|of| (of.angles()[1] / dwell - 1.0).abs() <= SAME);
    let note = if is_exact {
        String::new()
    } else {
        format!("No such wheel with up to {} stations has the dwell you want.", STATIONS.end())
    };
    MechanismReport {
        title: format!("Wheels nearest to a dwell of {}° of the driver's turn", as_typed(dwell)),
        introduction: OF_ANGLES,
        sections: vec![(
            "Wanted",
            vec![ReportField::in_unit("dwell_angle_deg", dwell, "°").line("dwell", "turn of the driver")],
        )],
        list: Some(("proposals", PROPOSED.into_iter().zip(&found).map(item).collect())),
        note,
    }
}

fn lines(of: &Candidate, cycle: f64, wanted: f64) -> Vec<ReportField> {
    let name = name(of);
    let change = 100.0 * (of.motion / wanted - 1.0);
    let index = match change {
        _ if (of.motion - wanted).abs() <= SAME => "index, as wanted".to_owned(),
        more if more > 0.0 => format!("index, {} % longer than wanted", number(more)),
        less => format!("index, {} % shorter than wanted", number(-less)),
    };
    vec![
        ReportField::in_unit("rpm", 60.0 / (cycle * f64::from(of.pins)), "rpm").line("driver", name),
        ReportField::in_unit("index_time_s", of.motion * cycle, "s").line("", index),
        ReportField::in_unit("dwell_time_s", (1.0 - of.motion) * cycle, "s").line("", "dwell"),
        ReportField::in_unit("dwell_over_index", (1.0 - of.motion) / of.motion, "× index").line("", "dwell"),
    ]
}

/// The bounds of these kinds of wheel, and a way round them.
fn bounds(wanted: f64, kind: Option<WheelKind>) -> String {
    let kinds = WheelKind::ALL.into_iter().filter(|of| kind.is_none_or(|kind| kind == *of));
    let all: Vec<f64> = kinds.flat_map(candidates).map(|of| of.motion).collect();
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    let most = all.iter().copied().fold(0.0, f64::max);
    let [longest, shortest] = [least, most].map(|motion| number((1.0 - motion) / motion));
    let stations = STATIONS.end();
    if wanted < least {
        format!(
            "No such wheel with up to {stations} stations dwells longer than {longest} times its index. For a longer dwell, \
             stop the driver during the dwell, or let another wheel turn the driver."
        )
    } else if wanted > most {
        format!("No such wheel with up to {stations} stations dwells for less than {shortest} times its index.")
    } else {
        format!(
            "No such wheel with up to {stations} stations has the ratio you want, but a driver whose speed varies can give \
             it."
        )
    }
}
