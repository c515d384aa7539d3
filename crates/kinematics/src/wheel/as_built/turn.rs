//! A wheel as it was made, followed through every station: does it turn, how loose is it, where does it jam?
//!
//! At every crank angle the free wheel angles are one interval, whose ends are in closed form ([`free_angles`](super::free_angles)). The wheel
//! turns if that interval is nowhere empty. It is looked at where a part comes within reach or leaves it and at places between;
//! each of its local minima is then narrowed down by golden section. What that leaves open is below [`WIDTH_TOLERANCE`].

use super::blow::BuiltBlow;
use super::contact::BuiltContact;
use super::errors::BuiltError;
use super::free_angles::{Assembled, FreeAngles};
use super::parts::AsBuiltWheel;
use crate::indexing::Indexing;

/// What the search leaves open of the least free angle, in radians; tests compare it with 10,000 places of each station.
pub const WIDTH_TOLERANCE: f64 = 1e-7;

/// Intervals between two changes at least and at most, and how long one is between them, in radians; twice as many where the whole
/// turn is wanted. Steps of the golden section.
const FEWEST: u32 = 2;
const MOST: u32 = 6;
const LENGTH: f64 = 0.05;
const STEPS: u32 = 36;
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Places in half a dwell at which the greatest free angle is looked for.
const DWELL_PLACES: u32 = 48;
/// How far beside a change its two sides are looked at, in radians.
const BESIDE: f64 = 1e-9;

/// The place at which a turn leaves the wheel the least free angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jam {
    /// The number of the pin that was last or next on the line of centres.
    pub pin: usize,
    /// The number of the slot of that pin.
    pub slot: usize,
    /// Crank angle from there, in radians.
    pub crank_angle: f64,
    /// The free angles; their width is below zero where the wheel jams.
    pub free: FreeAngles,
}

/// One station: an index, and the dwell after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StationTurn {
    /// The number of the pin.
    pub pin: usize,
    /// The number of the slot.
    pub slot: usize,
    /// The number of the arc in which the disc dwells after the index.
    pub arc: usize,
    /// How far the wheel is free on the line of centres in the middle of the index, in radians from end to end.
    pub index_backlash: f64,
    /// How far it is free in the middle of the dwell, in radians from end to end.
    pub dwell_backlash: f64,
    /// The greatest free angle in the dwell, in radians from end to end.
    pub greatest_dwell_backlash: f64,
    /// How far the middle of the free angles in the middle of the dwell is from where the wheel should rest, in radians, positive
    /// forwards: the error of this station.
    pub station_error: f64,
    /// Whether the wheel can stand so in the dwell that the next pin meets its rim beside the slot: it then jams or loses an index.
    pub can_miss: bool,
    /// Whether something holds the wheel in the middle of the dwell, to less than a pitch.
    pub is_held: bool,
    /// The blow with which the pin comes in; none where it meets nothing.
    pub entry: Option<BuiltBlow>,
}

/// A whole turn of every station.
#[derive(Clone, Debug, PartialEq)]
pub struct BuiltTurn {
    /// Where the wheel jams worst; none where it turns.
    pub jam: Option<Jam>,
    /// Where the wheel is free the least.
    pub tightest: Jam,
    /// All combinations of a pin and a slot, in the order in which they come.
    pub stations: Vec<StationTurn>,
}

impl BuiltTurn {
    /// The greatest free angle in any dwell, in radians from end to end.
    pub fn greatest_dwell_backlash(&self) -> f64 {
        self.stations.iter().map(|station| station.greatest_dwell_backlash).fold(0.0, f64::max)
    }

    /// The greatest of all blows, over the pin's speed, dimensionless; zero without any.
    pub fn greatest_blow(&self) -> f64 {
        self.stations.iter().filter_map(|station| station.entry).map(|entry| entry.greatest).fold(0.0, f64::max)
    }

    /// Whether a pin meets no part of the wheel.
    pub fn misses(&self) -> bool {
        self.stations.iter().any(|station| station.entry.is_none())
    }

    /// Whether the driver turns the wheel: nothing jams, each pin meets its slot, and between two pins something holds the wheel.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::AsBuiltWheel;
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &Choices::default())?;
    /// let mut built = AsBuiltWheel::from(&sizes);
    /// assert!(built.turn()?.is_driven());
    /// built.centre_distance = 80.0; // mm instead of 50 mm: nothing jams, but the pin passes outside the rim
    /// let turn = built.turn()?;
    /// assert!(turn.jam.is_none() && turn.misses() && !turn.is_driven());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn is_driven(&self) -> bool {
        self.jam.is_none() && !self.misses() && self.is_held()
    }

    /// Whether something holds the wheel between two pins, at every station.
    pub fn is_held(&self) -> bool {
        self.stations.iter().all(|station| station.is_held)
    }

    /// Whether the wheel can miss a pin.
    pub fn can_miss(&self) -> bool {
        self.stations.iter().any(|station| station.can_miss)
    }
}

/// Crank angles between two changes, near which free angles can change as a square root: places of equal distance are dense there.
struct Between {
    from: f64,
    to: f64,
}

impl Between {
    /// The crank angle at a place from 0 to 1.
    fn angle(&self, u: f64) -> f64 {
        let half = libm::sin(std::f64::consts::FRAC_PI_2 * u);
        self.from + (self.to - self.from) * half * half
    }
}

fn greatest_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_divisor(b, a % b) }
}

impl AsBuiltWheel {
    /// How many events there are until the same pin comes into the same slot again.
    pub fn events(&self) -> usize {
        let (slots, pins) = (self.slots().len(), self.pins().len());
        slots / greatest_divisor(slots, pins).max(1) * pins
    }

    /// The wheel followed through every combination of a pin and a slot.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::AsBuiltWheel;
    /// use geneva_kinematics::wheel::{Choices, Play, Scale, Sizes, Wheel};
    ///
    /// let choices = Choices { play: Some(Play::from_slot(0.2)), ..Choices::default() }; // mm
    /// let sizes = Sizes::new(Wheel::new(4)?, Scale::CrankRadius(25.0), &choices)?;
    /// let mut built = AsBuiltWheel::from(&sizes);
    /// let drawn = sizes.dwell_play().expect("a dwell").middle; // rad to either side
    /// assert!((built.turn()?.stations[0].dwell_backlash - 2.0 * drawn).abs() < 1e-12);
    /// built.centre_distance -= 0.3; // mm: the disc is then in the bottom of its arcs
    /// assert!(built.turn()?.jam.is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`check`](Self::check).
    pub fn turn(&self) -> Result<BuiltTurn, BuiltError> {
        self.check()?;
        let assembled = Assembled::new(self);
        let mut tightest = assembled.place(0, 0.0);
        for event in 0..self.events() as i64 {
            let found = assembled.tightest(event, f64::INFINITY);
            if found.free.width() < tightest.free.width() {
                tightest = found;
            }
        }
        let stations = (0..self.events() as i64).map(|event| assembled.station(event)).collect();
        let jam = Some(tightest).filter(|place| place.free.width() < 0.0);
        Ok(BuiltTurn { jam, tightest, stations })
    }

    /// The tightest place of one event, and whether the wheel can miss its pin: all that there is to know of whether a wheel turns
    /// whose slots, arcs and pins are alike.
    ///
    /// ```
    /// use geneva_kinematics::wheel::as_built::AsBuiltWheel;
    /// use geneva_kinematics::wheel::{Choices, Scale, Sizes, Wheel};
    ///
    /// let sizes = Sizes::new(Wheel::new(6)?, Scale::CrankRadius(25.0), &Choices::default())?; // mm
    /// let mut built = AsBuiltWheel::from(&sizes);
    /// built.centre_distance -= 0.01; // mm
    /// let (tightest, can_miss) = built.tightest_place(0)?;
    /// assert_eq!(tightest.free.width(), built.turn()?.tightest.free.width());
    /// assert!(!can_miss);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`check`](Self::check).
    pub fn tightest_place(&self, event: i64) -> Result<(Jam, bool), BuiltError> {
        self.check()?;
        let assembled = Assembled::new(self);
        Ok((assembled.tightest(event, f64::INFINITY), assembled.can_miss(event)))
    }

    /// Whether the wheel turns through every combination of a pin and a slot: as [`turn`](Self::turn) finds, and sooner.
    ///
    /// # Errors
    ///
    /// The errors of [`check`](Self::check).
    pub fn turns(&self) -> Result<bool, BuiltError> {
        self.check()?;
        let assembled = Assembled::new(self);
        Ok((0..self.events() as i64).all(|event| assembled.tightest(event, 0.0).free.width() >= 0.0))
    }
}

impl Assembled<'_> {
    fn place(&self, event: i64, theta: f64) -> Jam {
        Jam { pin: self.pin_of(event), slot: self.slot_of(event), crank_angle: theta, free: self.free(event, theta) }
    }

    /// The tightest place of an event; a minimum that is not likely to be below `enough` radians need not be narrowed down, and the
    /// first place below zero will do if that is zero.
    fn tightest(&self, event: i64, enough: f64) -> Jam {
        let changes = self.changes(event);
        let mut least = self.place(event, 0.0);
        let is_jammed = |least: &Jam| enough == 0.0 && least.free.width() < 0.0;
        let mut widths = Vec::with_capacity(2 * MOST as usize + 1);
        let times = if enough == 0.0 { 1 } else { 2 };
        for ends in changes.windows(2) {
            let (from, to) = (ends[0], ends[1]);
            if to - from <= 4.0 * BESIDE {
                continue;
            }
            let between = Between { from: from + BESIDE, to: to - BESIDE };
            let count = times * (((to - from) / LENGTH) as u32).clamp(FEWEST, MOST);
            widths.clear();
            for k in 0..=count {
                let place = self.place(event, between.angle(f64::from(k) / f64::from(count)));
                widths.push(place.free.width());
                if place.free.width() < least.free.width() {
                    least = place;
                }
            }
            if is_jammed(&least) {
                return least;
            }
            for k in 0..widths.len() {
                let (before, after) = (k.saturating_sub(1), (k + 1).min(widths.len() - 1));
                let (width, beside) = (widths[k], widths[before].max(widths[after]));
                let is_least = width <= widths[before] && width <= widths[after];
                // A parabola or a bend falls no further below the middle than the higher neighbour is above it; twice that for
                // the steeper falls near the ends.
                if is_least && 3.0 * width - 2.0 * beside < enough.min(least.free.width()) {
                    let place =
                        self.narrow(event, &between, [before, after].map(|k| k as f64 / f64::from(count)), enough);
                    if place.free.width() < least.free.width() {
                        least = place;
                    }
                }
            }
            if is_jammed(&least) {
                return least;
            }
        }
        least
    }

    /// The tightest place between two places of an interval, by golden section, until it can't be below `enough` radians or, if that
    /// is zero, is.
    fn narrow(&self, event: i64, between: &Between, [mut from, mut to]: [f64; 2], enough: f64) -> Jam {
        let at = |u: f64| (u, self.place(event, between.angle(u)));
        let width = |place: &(f64, Jam)| place.1.free.width();
        let mut left = at(to - GOLDEN * (to - from));
        let mut right = at(from + GOLDEN * (to - from));
        for _ in 0..STEPS {
            let (least, most) = (width(&left).min(width(&right)), width(&left).max(width(&right)));
            if 3.0 * least - 2.0 * most > enough || (enough == 0.0 && least < 0.0) {
                break;
            }
            if width(&left) < width(&right) {
                (to, right) = (right.0, left);
                left = at(to - GOLDEN * (to - from));
            } else {
                (from, left) = (left.0, right);
                right = at(from + GOLDEN * (to - from));
            }
        }
        if width(&left) < width(&right) { left.1 } else { right.1 }
    }

    /// The greatest free angle between two crank angles of an event, in radians.
    fn greatest_width(&self, event: i64, from: f64, to: f64) -> f64 {
        let between = Between { from, to };
        let at = |k: u32| f64::from(k.min(DWELL_PLACES)) / f64::from(DWELL_PLACES);
        let width = |u: f64| self.free(event, between.angle(u)).width();
        let widest = (0..=DWELL_PLACES).max_by(|one, other| width(at(*one)).total_cmp(&width(at(*other)))).unwrap_or(0);
        let (mut from, mut to) = (at(widest.saturating_sub(1)), at(widest + 1));
        let mut greatest = width(at(widest));
        for _ in 0..STEPS {
            let inner = [to - GOLDEN * (to - from), from + GOLDEN * (to - from)];
            let widths = inner.map(width);
            greatest = greatest.max(widths[0]).max(widths[1]);
            if widths[0] > widths[1] { to = inner[1] } else { from = inner[0] }
        }
        greatest
    }

    fn station(&self, event: i64) -> StationTurn {
        let half = self.pin_pitch / 2.0;
        let rest = self.free(event, half);
        let engaged = self.built.wheel().engagement_half_angle();
        // From this pin's leaving to the next one's entry.
        let greatest = self.greatest_width(event, engaged, half).max(self.greatest_width(event + 1, -half, -engaged));
        StationTurn {
            pin: self.pin_of(event),
            slot: self.slot_of(event),
            arc: self.arc_of(event),
            index_backlash: self.free(event, 0.0).width(),
            dwell_backlash: rest.width(),
            greatest_dwell_backlash: greatest.max(rest.width()),
            station_error: rest.middle() - self.half_pitch,
            can_miss: self.can_miss(event),
            is_held: rest.width() < 2.0 * self.half_pitch,
            entry: self.entry_blow(event),
        }
    }

    /// Whether the wheel can stand so that the pin of an event meets the rim beside its slot.
    fn can_miss(&self, event: i64) -> bool {
        let pin = self.built.pins()[self.pin_of(event)];
        let (a, c) = (pin.crank_radius, self.built.centre_distance);
        let reaches = self.mouth(self.slot_of(event)).reach(pin.diameter / 2.0);
        reaches.into_iter().enumerate().any(|(side, reach)| {
            let cosine = (a * a + c * c - reach * reach) / (2.0 * a * c);
            if cosine.abs() >= 1.0 {
                return cosine < 0.0;
            }
            let theta = pin.direction_error - libm::acos(cosine) + BESIDE;
            let place = self.pin_place(event, theta);
            let Some((room, BuiltContact::PinAtMouth | BuiltContact::PinOnFace)) = place.rooms[side] else {
                return false;
            };
            let mut others = self.unstopped(event);
            self.stop_by_disc(event, theta, &mut others);
            if side == 0 {
                others.forward.angle > place.beside + room
            } else {
                others.backward.angle < place.beside - room
            }
        })
    }
}
