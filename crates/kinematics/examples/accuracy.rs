//! The greatest error of every quantity of the wheel, in units in the last place, over 3 to 60 stations and 10 001
//! angles of each engagement. Takes some minutes: run it with `--release`.

#[path = "../tests/oracle/mod.rs"]
mod oracle;

use geneva_kinematics::indexing::Indexing;
use geneva_kinematics::wheel::{STATIONS, Wheel};
use oracle::{MOTION, Oracle};
use std::collections::BTreeMap;
use std::error::Error;

/// The greatest number of stations looked at.
const STATIONS_MOST: u32 = 60;
/// Steps from one end of the engagement to the other.
const STEPS: i32 = 10_000;

/// The greatest error of one quantity, and where it is.
#[derive(Clone, Copy, Default)]
struct Worst {
    error: f64,
    stations: u32,
    crank: Option<f64>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut table: BTreeMap<&str, Worst> = BTreeMap::new();
    let mut note = |name: &'static str, found: Worst| {
        let worst = table.entry(name).or_default();
        if found.error >= worst.error {
            *worst = found;
        }
    };
    for stations in *STATIONS.start()..=STATIONS_MOST {
        let (wheel, oracle) = (Wheel::new(stations)?, Oracle::new(stations));
        for (name, error) in oracle.size_errors(&wheel) {
            note(name, Worst { error, stations, crank: None });
        }
        let most = wheel.engagement_half_angle();
        for step in 0..=STEPS {
            // At the ends the factor is one, and the angle the nearest to the end that there is.
            let crank = most * (f64::from(2 * step - STEPS) / f64::from(STEPS));
            let motion = wheel.engaged(crank)?;
            for (name, error) in MOTION.into_iter().zip(oracle.motion_errors(&motion, crank, (0, 1))) {
                note(name, Worst { error, stations, crank: Some(crank) });
            }
        }
    }
    println!("{:<24}{:>10}{:>10}{:>25}", "quantity", "ulp", "stations", "crank angle");
    for (name, Worst { error, stations, crank }) in table {
        let crank = crank.map_or_else(String::new, |crank| crank.to_string());
        println!("{name:<24}{error:>10.4}{stations:>10}{crank:>25}");
    }
    Ok(())
}
