//! How long the arcs are that lock a wheel, by three measures, planar and spherical.

use geneva_documents::jazar::LockingArcs;
use geneva_kinematics::wheel::Wheel;
use geneva_press::html::{Cells, Table, table};
use geneva_press::numbers::fixed;

/// The journal's radius in crank radii.
const JOURNAL: f64 = 0.8;

/// The arcs of wheels with few stations and with many.
pub(super) fn arcs() -> anyhow::Result<Table> {
    let rows = [4, 8, 12, 30, 100, 1000].map(|stations| {
        let wheel = Wheel::new(stations)?;
        let mut row = vec![stations.to_string()];
        for arcs in [LockingArcs::planar(&wheel, JOURNAL), LockingArcs::spherical(&wheel, JOURNAL)] {
            row.extend([fixed(arcs.in_wheel_radii, 3), fixed(arcs.in_crank_radii, 3)]);
            row.push(format!("{}°", fixed(arcs.angle.to_degrees(), 0)));
        }
        Ok(row)
    });
    let caption = format!(
        "Length of the locking arcs of planar wheels (p) and of spherical wheels with axes at right angles (s), for a locking \
         disc with a radius of {JOURNAL} crank radii"
    );
    let head = [
        "Stations",
        "p, in wheel radii",
        "p, in crank radii",
        "p, angle",
        "s, in wheel radii",
        "s, in crank radii",
        "s, angle",
    ];
    table(&caption, Cells::Numbers, &head, rows)
}
