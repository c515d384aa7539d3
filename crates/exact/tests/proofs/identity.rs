//! Is a true identity proven and a false one refuted?

use dashu_ratio::RBig;
use geneva_exact::{Expression, Identity, IdentityWithRoot, Proof, prove, prove_with_root};

struct Binomial {
    wrong: i64,
}

impl Identity<2> for Binomial {
    /// (x + y)² − (x² + (2 + wrong) x y + y²)
    fn difference(&self, [x, y]: [Expression; 2]) -> Expression {
        (x + y).squared() - x * x - (2 + self.wrong) * x * y - y * y
    }
}

#[test]
fn a_true_identity_is_proven_on_a_full_grid() {
    let proof = prove(&Binomial { wrong: 0 }).expect("the binomial formula holds");
    assert_eq!(proof, Proof { degrees: vec![2, 2], points: 9 });
}

#[test]
fn a_false_identity_is_refuted_with_a_point() {
    let refutation = prove(&Binomial { wrong: 1 }).expect_err("three is not two");
    assert_eq!(refutation.difference, Some(RBig::from(-4)));
}

/// Two fractions that would be one if the root were a whole number.
struct RootForOne;

impl IdentityWithRoot<1> for RootForOne {
    fn difference(&self, root: Expression, [x]: [Expression; 1]) -> Expression {
        (2 + root) / 3 / (x + root) - 1 / (x + 1)
    }
}

#[test]
fn a_root_is_not_taken_for_a_whole_number() {
    assert!(prove_with_root::<2, 1>(&RootForOne).is_err());
}

/// Fractions over each other's denominators, and what cancels among them.
struct Fractions {
    wrong: i64,
}

impl Identity<3> for Fractions {
    /// 1/x + y/(x z) = (z + y) z / (x z²), and x/(y/z) (y/z) = x.
    fn difference(&self, [x, y, z]: [Expression; 3]) -> Expression {
        let sides = 1 / x + y / (x * z) - (z + y) * z / (x * z * (z + self.wrong));
        sides * sides + x / (y / z) * (y / z) - x
    }
}

#[test]
fn numerators_in_whole_numbers_are_zero_where_the_fractions_are() {
    assert!(prove(&Fractions { wrong: 0 }).is_ok());
    let refutation = prove(&Fractions { wrong: 1 }).expect_err("another denominator");
    assert_eq!(refutation.at, [2, 2, 2].map(RBig::from));
    // At each of many points by themselves: what is zero there, and what is not, is told apart as fractions tell it.
    for wrong in [0, 1, -3] {
        let fractions = Fractions { wrong }.difference([0, 1, 2].map(Expression::variable));
        for k in 0..64 {
            let point = [k % 4 + 2, k / 4 % 4 + 2, k / 16 + 2];
            let found = std::panic::catch_unwind(|| prove(&FirstAt { wrong, point }));
            // A divisor of zero is told, not divided by.
            if wrong == -3 && point[2] >= 3 {
                assert!(!matches!(found, Ok(Ok(_))), "{point:?}");
                continue;
            }
            let at = point.map(RBig::from);
            let expected = fractions.at(&at);
            match found.expect("no divisor of zero") {
                Ok(_) => assert_eq!(expected, RBig::from(0), "{wrong} {point:?}"),
                Err(refutation) => assert_eq!(refutation.at == at, expected != RBig::from(0), "{wrong} {point:?}"),
            }
        }
    }
}

/// The fractions, but zero at all points of the grid that come before this one.
struct FirstAt {
    wrong: i64,
    point: [i64; 3],
}

impl Identity<3> for FirstAt {
    fn difference(&self, variables: [Expression; 3]) -> Expression {
        let before = variables.into_iter().zip(self.point).flat_map(|(x, end)| (2..end).map(move |zero| x - zero));
        before.fold(Fractions { wrong: self.wrong }.difference(variables), |product, factor| product * factor)
    }
}

/// Nothing, with a pole on the grid.
struct WithPole;

impl Identity<1> for WithPole {
    fn difference(&self, [x]: [Expression; 1]) -> Expression {
        x / (x - 3) - 1 / (x - 3) * x
    }
}

#[test]
fn a_pole_on_the_grid_is_told() {
    let refutation = prove(&WithPole).expect_err("a pole at three");
    assert_eq!((&refutation.at[..], &refutation.difference), (&[RBig::from(3)][..], &None));
    assert_eq!(refutation.to_string(), "with the variable set to 3, something is divided by zero");
}
