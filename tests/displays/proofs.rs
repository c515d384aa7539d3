//! Is each slip in a display noticed by itself, where the printed characters themselves are proven?
//!
//! The verdicts say that a display put right is proven and that the printed one, with all its slips, is refuted.

use geneva_documents::LEDGER;
use geneva_evidence::Check;

/// Whether characters are proven in the place of a claim's own.
#[track_caller]
fn is_proven(id: &str, tex: &str) -> bool {
    match LEDGER.claim(id).map(|claim| &claim.check) {
        Some(Check::Equation { first, .. }) => (first.run)(tex).holds,
        _ => panic!("{id}: its characters are not what is proven"),
    }
}

/// The corrected characters of a claim.
#[track_caller]
fn corrected(id: &str) -> &'static str {
    LEDGER.claim(id).expect("a claim").right_characters()
}

#[test]
fn of_all_half_powers_up_to_eight_one_pair_is_right() {
    let (id, right) = ("meyer.eq-1-13", corrected("meyer.eq-1-13"));
    for speed in 0..=8 {
        for gain in 0..=8 {
            let tex = right.replace("{5/2}", &format!("{{{speed}/2}}")).replace("{3/2}", "{x}");
            let tex = tex.replace("{x}", &format!("{{{gain}/2}}"));
            assert_eq!(is_proven(id, &tex), [speed, gain] == [5, 3], "{tex}");
        }
    }
}

#[test]
fn each_wrong_exponent_is_wrong_by_itself() {
    let (id, right) = ("meyer.friction-torque.substituted", corrected("meyer.friction-torque.substituted"));
    assert!(is_proven(id, right));
    for put_back in ["{1/2}", "{5/2}"] {
        assert_eq!(right.matches(put_back).count(), 1);
        assert!(!is_proven(id, &right.replace(put_back, "{3/2}")), "{put_back}");
    }
}

#[test]
fn each_slip_of_a_line_is_wrong_by_itself() {
    let slips = [
        ("meyer.app-b.eq-1-19", r"C\dot{\theta}^2", r"C\theta^2"),
        ("meyer.app-b.eq-1-19", r"D\ddot{\theta}", r"D\dot{\theta}"),
        ("meyer.momentum-rate.quotient.third-line", r"\left. \left. -", r"\left. \left. +"),
        ("meyer.momentum-rate.quotient.third-line", r"{(a \cos", r"{(-a \cos"),
        ("meyer.eq-1-17", "1)^2 I_f", "1) I_f"),
    ];
    for (id, put_right, slipped) in slips {
        assert_eq!(corrected(id).matches(put_right).count(), 1, "{id}: {put_right}");
        assert!(!is_proven(id, &corrected(id).replace(put_right, slipped)), "{id}: {slipped}");
    }
}

#[test]
fn brackets_for_bars_are_wrong() {
    let lost = |bars: &str| bars.replace(r"\left|", r"\left[").replace(r"\right|", r"\right]").replace('|', "");
    for id in ["meyer.eq-1-14", "meyer.eq-1-18.second-line", "meyer.parts-put-in.second-line", "meyer.eq-1-19"] {
        assert!(is_proven(id, corrected(id)), "{id}");
        assert!(!is_proven(id, &lost(corrected(id))), "{id}");
    }
}
