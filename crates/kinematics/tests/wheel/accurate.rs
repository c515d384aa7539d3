//! Do the sines of twice the working precision agree with 200 bits?

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

/// The numbers and the table, compiled here by themselves because the crate keeps them private.
#[allow(dead_code, unreachable_pub, reason = "a file of the library, of which the tests use a part")]
#[path = "../../src/wheel/accurate/double.rs"]
mod double;
#[allow(dead_code, unreachable_pub, reason = "a file of the library, of which the tests use a part")]
#[path = "../../src/wheel/accurate/table.rs"]
mod table;

use double::Double;
use table::{TableNode, series, sine_versine};

type Wide = FBig<HalfEven, 2>;

fn wide(x: Double) -> Wide {
    let part = |x: f64| Wide::try_from(x).unwrap().with_precision(200).value();
    part(x.hi) + part(x.lo)
}

fn size(x: Wide) -> f64 {
    x.to_f64().value().abs()
}

#[test]
fn every_node_has_its_angle() {
    const NODES: u32 = 512;
    const NODES_PER_RADIAN: f64 = 256.0;
    const TANGENTS_PER_ONE: f64 = 8192.0;
    let mut last = None;
    for k in 0..NODES {
        let (node, _) = TableNode::nearest(Double::from(f64::from(k) / NODES_PER_RADIAN));
        // Each angle has a node of its own.
        assert!(last.is_none_or(|last| node.angle.hi > last), "{k}");
        last = Some(node.angle.hi);
        let tangent = wide(Double::from(node.twice_tangent / 2.0));
        assert_eq!(node.twice_tangent * node.twice_tangent / 4.0, node.square);
        let error = size(tangent.atan() * Wide::from(2) - wide(node.angle));
        assert!(error < 1e-26, "{k}: {error:e}");
        assert!((node.angle.hi - f64::from(k) / NODES_PER_RADIAN).abs() <= 1.0 / TANGENTS_PER_ONE, "{k}");
    }
}

#[test]
fn sines_are_those_of_200_bits() {
    for step in -1570..=1570_i32 {
        let angle = Double::from(f64::from(step) * 0.001).plus(Double::from(f64::from(step) * 1e-20));
        let (sine, cosine) = wide(angle).sin_cos();
        let (most, versine) = (size(sine.clone()), Wide::ONE - cosine);
        let (s, v) = sine_versine(angle);
        assert!(size(wide(s) - sine.clone()) <= 5e-20 * most, "{step}");
        assert!(size(wide(v) - versine.clone()) <= 2e-19 * most, "{step}");
        if step > 0 {
            let (s, v) = series(angle);
            assert!(size(wide(s) - sine) < 1e-30 && size(wide(v) - versine) < 1e-30, "{step}");
        }
    }
}
