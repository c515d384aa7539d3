//! The Gauss-Legendre rule: integrals over an interval, up to each of its nodes, and what lies between them.

use std::sync::LazyLock;

/// Nodes of one subinterval of the motion.
pub(crate) const NODES: usize = 16;

/// Nodal values: one number for each node.
pub(crate) type NodalValues = [f64; NODES];

/// The rule for the interval from −1 to 1.
#[derive(Debug)]
pub(crate) struct GaussLegendre {
    /// Where, rising: the roots of Legendre's polynomial.
    pub nodes: NodalValues,
    /// What a value counts in the integral over the whole interval.
    pub weights: NodalValues,
    /// What a value counts in the barycentric formula, before division by the distance.
    barycentric: NodalValues,
    /// By value, then by point of the lower half: what a pair of equal values counts in the integral up to the point,
    /// less half of the whole.
    of_equal: [[f64; HALF]; HALF],
    /// By value, then by point: what a pair of opposite values counts, whose whole is zero.
    of_opposite: [[f64; HALF]; HALF],
}

/// Nodes below the middle.
const HALF: usize = NODES / 2;

static RULE: LazyLock<GaussLegendre> = LazyLock::new(GaussLegendre::new);

/// The Gauss-Legendre rule, made at the first call.
pub(crate) fn rule() -> &'static GaussLegendre {
    &RULE
}

/// Legendre's polynomials up to order [`NODES`] at x.
fn legendre(x: f64) -> [f64; NODES + 1] {
    let mut values = [1.0; NODES + 1];
    values[1] = x;
    for order in 2..=NODES {
        let n = order as f64;
        values[order] = ((2.0 * n - 1.0) * x * values[order - 1] - (n - 1.0) * values[order - 2]) / n;
    }
    values
}

impl GaussLegendre {
    fn new() -> Self {
        let n = NODES as f64;
        let (mut nodes, mut weights, mut barycentric) = ([0.0; NODES], [0.0; NODES], [0.0; NODES]);
        for index in 0..NODES / 2 {
            let mut x = -libm::cos(std::f64::consts::PI * (index as f64 + 0.75) / (n + 0.5));
            let mut slope = 1.0;
            // Newton's method from the usual guess: five steps reach the last place, one more does no harm.
            for _ in 0..6 {
                let values = legendre(x);
                slope = n * (values[NODES - 1] - x * values[NODES]) / (1.0 - x * x);
                x -= values[NODES] / slope;
            }
            let weight = 2.0 / ((1.0 - x * x) * slope * slope);
            let sign = if index % 2 == 0 { 1.0 } else { -1.0 };
            let other = NODES - 1 - index;
            (nodes[index], nodes[other]) = (x, -x);
            (weights[index], weights[other]) = (weight, weight);
            let count = ((1.0 - x * x) * weight).sqrt();
            (barycentric[index], barycentric[other]) = (sign * count, -sign * count);
        }
        let values = nodes.map(legendre);
        let integral = |value: usize, point: usize| {
            // A value's polynomial is a sum of Legendre's; each of these has its integral among its neighbours.
            let mut sum = nodes[point] + 1.0;
            for order in 1..NODES {
                sum += values[value][order] * (values[point][order + 1] - values[point][order - 1]);
            }
            weights[value] / 2.0 * sum
        };
        let (mut of_equal, mut of_opposite) = ([[0.0; HALF]; HALF], [[0.0; HALF]; HALF]);
        for value in 0..HALF {
            for point in 0..HALF {
                let pair = (integral(value, point), integral(NODES - 1 - value, point));
                of_equal[value][point] = pair.0 + pair.1 - weights[value];
                of_opposite[value][point] = pair.0 - pair.1;
            }
        }
        Self { nodes, weights, barycentric, of_equal, of_opposite }
    }

    /// The integrals from −1 up to each point, and from −1 to 1, in the unit of the values.
    ///
    /// As the sum of an even and an odd function, each with half as many values and half as many integrals.
    pub(crate) fn cumulative(&self, values: &NodalValues) -> (NodalValues, f64) {
        let (mut of_even, mut of_odd, mut whole) = ([0.0; HALF], [0.0; HALF], 0.0);
        for index in 0..HALF {
            let (low, high) = (values[index] / 2.0, values[NODES - 1 - index] / 2.0);
            let (even, odd) = (low + high, low - high);
            whole += even * self.weights[index];
            for point in 0..HALF {
                of_even[point] += even * self.of_equal[index][point];
                of_odd[point] += odd * self.of_opposite[index][point];
            }
        }
        let mut sums = [0.0; NODES];
        for point in 0..HALF {
            sums[point] = whole + (of_odd[point] + of_even[point]);
            sums[NODES - 1 - point] = whole + (of_odd[point] - of_even[point]);
        }
        (sums, 2.0 * whole)
    }

    /// The integral from −1 to 1, in the unit of the values.
    pub(crate) fn integral(&self, values: &NodalValues) -> f64 {
        dot(&self.weights, values)
    }

    /// What each value counts at x in the polynomial through them all.
    pub(crate) fn shares(&self, x: f64) -> NodalValues {
        let mut shares = [0.0; NODES];
        let mut sum = 0.0;
        for ((share, point), weight) in shares.iter_mut().zip(&self.nodes).zip(&self.barycentric) {
            *share = weight / (x - point);
            sum += *share;
        }
        if sum.is_finite() {
            let scale = 1.0 / sum;
            return shares.map(|share| share * scale);
        }
        // At a point, or within rounding of it.
        let at = |point: &f64| if (x - point).abs() < 1e-300 { 1.0 } else { 0.0 };
        self.nodes.each_ref().map(at)
    }
}

/// Sum of products.
pub(super) fn dot(one: &NodalValues, other: &NodalValues) -> f64 {
    // Four sums, so that they need not wait for one another.
    let mut sums = [0.0; 4];
    for (a, b) in one.chunks_exact(4).zip(other.chunks_exact(4)) {
        for k in 0..4 {
            sums[k] += a[k] * b[k];
        }
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3])
}
