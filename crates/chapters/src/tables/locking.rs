//! How long the arcs are that lock a wheel, by three measures, planar and spherical.

use geneva_documents::jazar::LockingArcs;
use geneva_kinematics::wheel::Wheel;
use geneva_press::numbers::fixed;
use geneva_press::table::{Cells, Columns, Table};

/// The locking disc's radius, in crank radii.
pub const LOCKING_DISC: f64 = 0.8;

/// The arcs of wheels with few stations and with many.
pub(super) fn arcs() -> anyhow::Result<Table> {
    let arcs = [4, 8, 12, 30, 100, 1000].map(|stations| {
        let wheel = Wheel::new(stations)?;
        let both = [LockingArcs::planar, LockingArcs::spherical].map(|arcs| arcs(&wheel, LOCKING_DISC));
        Ok((stations, both))
    });
    let arcs = arcs.into_iter().collect::<anyhow::Result<Vec<_>>>()?;
    let kinds = |table: Columns<(u32, [LockingArcs; 2])>, (at, kind): (usize, &str)| {
        table
            .column(format!("{kind}, in wheel radii"), |(_, arcs)| fixed(arcs[at].in_wheel_radii, 3))
            .column(format!("{kind}, in crank radii"), |(_, arcs)| fixed(arcs[at].in_crank_radii, 3))
            .column(format!("{kind}, angle"), |(_, arcs)| format!("{}°", fixed(arcs[at].angle.to_degrees(), 0)))
    };
    let stations = Table::with_rows(Cells::Numbers, arcs).column("Stations", |(stations, _)| *stations);
    ["p", "s"].into_iter().enumerate().fold(stations, kinds).finish()
}
