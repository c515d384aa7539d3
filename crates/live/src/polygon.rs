//! The vector diagrams of the quick-return mechanism.

use crate::answer::{Answer, Number};
use crate::control::{Control, Drag, Live, Preset, Quantity, Settings, TURNS};
use geneva_ask::quick_return::lever_motion;
use geneva_figures::quick_return;
use geneva_kinematics::quick_return::{Drive, Motion, QuickReturn};

/// Units of length of the linkage.
const UNITS: &[&str] = &["m", "mm", "in"];

pub const LIVE: Live = Live {
    name: "polygon",
    figure: "live-polygon",
    hint: "Set the factor of φ̇ vᵣₑₗ to 1 or 3: the polygon stays open, except where the Coriolis acceleration is \
           zero. With the factor 2 it closes at every angle.",
    controls: &[
        Control::slider("crank", "crank angle θ", "°", [-180.0, 180.0], 0.1, -120.0).typed(TURNS).playing(30.0),
        Control::slider("factor", "times φ̇ vᵣₑₗ", "", [0.0, 3.0], 1.0, 2.0).typed([-10.0, 10.0]),
    ],
    presets: &[
        Preset { name: "forgotten: 0", arguments: "factor=0" },
        Preset { name: "half of it: 1", arguments: "factor=1" },
        Preset { name: "right: 2", arguments: "factor=2" },
        Preset { name: "too much: 3", arguments: "factor=3" },
    ],
    given: &["ground", "radius", "speed", "unit"],
    quantities: &[
        Quantity::new("gap", "gap of the acceleration polygon"),
        Quantity::field("lever-speed", "lever's angular velocity φ̇", "lever_speed_rad_s"),
        Quantity::field("lever-acceleration", "lever's angular acceleration φ̈", "lever_acceleration_rad_s2"),
        Quantity::new("sliding", "sliding velocity vᵣₑₗ, outwards"),
        Quantity::new("coriolis", "Coriolis acceleration |2 φ̇ vᵣₑₗ|"),
    ],
    others: &[],
    drag: Some(Drag { control: "crank", at_right: -180.0, sense: 1.0 }),
    files: &[],
    draw,
};

fn draw(settings: &Settings) -> Result<Answer, String> {
    let given = settings.arguments();
    let [ground, radius, speed] = ["ground", "radius", "speed"].map(|name| given.given_number(name));
    let (ground, radius, drive, unit) = (ground?, radius?, Drive::steady(speed?), given.given_word("unit", UNITS)?);
    let linkage = QuickReturn::new(ground, radius).map_err(|error| error.to_string())?;
    let (crank, factor) = (settings.value("crank")?, settings.value("factor")?);
    let position = linkage.at_crank_degrees(crank + 180.0).map_err(|error| error.to_string())?;
    let motion = Motion::at(&ground, &radius, &position.crank, &drive)
        .ok_or_else(|| format!("crank {crank}: the pin is on the lever's pivot; give another angle"))?;
    let figure = quick_return::polygons(&linkage, &position, &drive, factor, unit);
    // The last row of the series is the gap, its last column the size of it.
    let gap = figure.series.rows.last().and_then(|row| row.last()).copied().unwrap_or(f64::NAN);
    let coriolis = motion.accelerations.coriolis.norm();
    let sliding = motion.velocities.sliding_velocity.dot(&position.lever.direction());
    let (speed, acceleration) = (format!("{unit}/s"), format!("{unit}/s²"));
    let of_lever = ["lever-speed", "lever-acceleration"].into_iter().zip(lever_motion(&motion));
    let numbers = [Number::significant("gap", gap, 4, &acceleration)]
        .into_iter()
        .chain(of_lever.filter_map(|(name, field)| Number::of(name, &field)))
        .chain([
            Number::significant("sliding", sliding, 4, &speed),
            Number::significant("coriolis", coriolis, 4, &acceleration),
        ]);
    Ok(Answer::new(figure, numbers))
}

#[cfg(test)]
mod tests {
    use super::LIVE;

    #[test]
    fn indices_are_set_as_indices() {
        let labels = LIVE.controls.iter().map(|control| control.label).chain(LIVE.quantities.iter().map(|of| of.label));
        let with_index: Vec<&str> = labels.filter(|label| label.contains("rel") || label.contains("ᵣₑₗ")).collect();
        assert_eq!(with_index, ["times φ̇ vᵣₑₗ", "sliding velocity vᵣₑₗ, outwards", "Coriolis acceleration |2 φ̇ vᵣₑₗ|"]);
    }
}
