//! Timekeepers with which the escapement is compared, and what changes their rate: a runaway escapement and a governed train.

use crate::{Error, MechanismReport, ReportField, Rounding, number, pairs};
use geneva_dynamics::timer::runaway::{friction_power, governed_power};

/// Minutes of a day.
const MINUTES: f64 = 1440.0;

/// A runaway escapement, of which friction takes a part of the torque and blows take the rest of the work: `--friction-share 0.2`.
pub(crate) fn runaway(arguments: &str) -> Result<MechanismReport, Error> {
    let share = only(arguments, "friction-share")?;
    let lost = ReportField::in_unit("friction_rate_min_a_day", 0.01 * MINUTES * friction_power(share)?, "min a day");
    let lost = lost.line("friction", "what the timer gains with one per cent more of it, to first order");
    Ok(answer("Runaway escapement", lost.rounded(Rounding::Decimals(1))))
}

/// A train with a centrifugal brake, at so many times the speed at which the brake begins to touch: `--beyond 1.1`.
pub(crate) fn governor(arguments: &str) -> Result<MechanismReport, Error> {
    let power = ReportField::new("torque_power", governed_power(only(arguments, "beyond")?)?);
    let power = power.line("power of the torque", "the speed is proportional to this power of the torque");
    Ok(answer("Governed train", power.rounded(Rounding::Decimals(2))))
}

/// The number of the one argument that there is.
fn only(arguments: &str, name: &str) -> Result<f64, Error> {
    let mut value = None;
    for pair in pairs(arguments) {
        match pair? {
            (known, text) if known == name => value = Some(number(name, text)?),
            (other, _) => return Err(refused!("no argument --{other}; there is --{name}")),
        }
    }
    value.ok_or_else(|| refused!("--{name} is missing; give it"))
}

fn answer(title: &str, field: ReportField) -> MechanismReport {
    MechanismReport {
        title: title.to_owned(),
        introduction: "",
        sections: vec![("Rate", vec![field])],
        list: None,
        note: String::new(),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_runaway_escapement_loses_less_than_a_friction_would_alone_and_a_governor_resists_the_torque() {
        let value = |question: &str, key: &str| crate::answer(question).expect("known").field(key)?.number();
        // A fifth of the torque: the power of the friction is an eighth.
        let lost = value("runaway --friction-share 0.2", "friction_rate_min_a_day").expect("a number");
        assert!((lost + 1.8).abs() < 1e-12, "{lost}");
        assert_eq!(value("governor --beyond 1", "torque_power"), Some(0.0));
        for (question, words) in [
            ("runaway --friction 0.2", "there is --friction-share"),
            ("runaway --friction-share 1", "friction over torque"),
            ("governor", "--beyond is missing"),
        ] {
            let error = crate::answer(question).expect_err(question).to_string();
            assert!(error.contains(words), "{error}");
        }
    }
}
