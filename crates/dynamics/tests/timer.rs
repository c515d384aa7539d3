//! Compares what we say of the timer with differences, energies and starts near the steady speed.

use approx::assert_relative_eq;
use geneva_dynamics::steady::Engagement;
use geneva_dynamics::timer::runaway::{Drag, Runaway, foliot_power};
use geneva_dynamics::timer::{Accelerations, Crossing, EntryBlow, Sensitivities, Settling};
use geneva_dynamics::{DynamicsError, Inertias, Parameters, existence};
use geneva_kinematics::Mechanism;

fn escapement(mechanism: Mechanism, driver: f64, follower: f64, torque: f64, friction: f64) -> Parameters {
    let inertias = Inertias::new(driver, follower).expect("inertias");
    Parameters::new(mechanism, inertias, torque, friction).expect("an escapement")
}

fn samples() -> Vec<Parameters> {
    let of = |mechanism| {
        [(0.08, 0.2), (0.7, 0.3)].map(|(driver, friction)| escapement(mechanism, driver, 1.3, 2.0, friction))
    };
    Mechanism::ALL.into_iter().flat_map(of).collect()
}

fn mean_speed(of: &Parameters) -> f64 {
    Engagement::new(of).and_then(|engagement| engagement.steady_state()).expect("steady").mean_speed
}

#[test]
fn the_lightest_driver_has_the_highest_peaks_and_a_heavier_one_the_highest_mean_speed() {
    // Ratio of the inertias with the highest mean speed, and the lightest driver with which the equation is well-posed.
    for (mechanism, fastest, lightest) in
        [(Mechanism::SIX_PIN, 3.0, 0.2), (Mechanism::FOUR_PIN, 4.0 / 3.0, 0.07), (Mechanism::THREE_PIN, 0.6, 0.07)]
    {
        let mut heaviest = 0.0;
        for friction in [0.2, 0.25, 0.3, 0.35] {
            let of = |ratio: f64| escapement(mechanism, ratio, 1.0, 1.0, friction);
            let mean = |ratio: f64| mean_speed(&of(ratio));
            // Within an eighth of what the chapter says.
            let best = (0..80).map(|step| fastest * libm::exp((f64::from(step) - 40.0) / 100.0));
            let best = best.max_by(|one, other| mean(*one).total_cmp(&mean(*other))).expect("one");
            assert!((7.0 / 8.0..8.0 / 7.0).contains(&(best / fastest)), "{mechanism:?}, {friction}: {best}");
            assert!(mean(lightest) < mean(fastest));
            assert!(best > heaviest, "{mechanism:?}, {friction}: {best} after {heaviest}");
            heaviest = best;

            let peak = |ratio: f64| {
                let engagement = Engagement::new(&of(ratio)).expect("an escapement");
                let steady = engagement.steady_state().expect("steady");
                engagement.passage(steady.entry_speed).expect("a passage").fastest().speed
            };
            let peaks: Vec<f64> = (0..6).map(|step| peak(lightest * libm::pow(2.0, f64::from(step)))).collect();
            assert!(peaks.is_sorted_by(|one, other| one > other), "{mechanism:?}, {friction}: {peaks:?}");
        }
    }
}

#[test]
fn a_small_change_of_each_quantity_changes_the_mean_speed_as_its_power_says() {
    for of in samples() {
        let found = Sensitivities::new(&of).expect("sensitivities");
        let inertias = of.inertias();
        let changed = |torque: f64, friction: f64, driver: f64, follower: f64| {
            mean_speed(&escapement(
                of.mechanism(),
                inertias.driver() * driver,
                inertias.follower() * follower,
                of.torque() * torque,
                of.friction() * friction,
            ))
        };
        let (more, less) = (1.0 + 1e-4, 1.0 - 1e-4);
        let both = [
            (found.torque, changed(more, 1.0, 1.0, 1.0) / changed(less, 1.0, 1.0, 1.0)),
            (found.friction, changed(1.0, more, 1.0, 1.0) / changed(1.0, less, 1.0, 1.0)),
            (found.driver_inertia, changed(1.0, 1.0, more, 1.0) / changed(1.0, 1.0, less, 1.0)),
            (found.follower_inertia, changed(1.0, 1.0, 1.0, more) / changed(1.0, 1.0, 1.0, less)),
        ];
        for (power, quotient) in both {
            assert_relative_eq!(power, libm::log(quotient) / libm::log(more / less), epsilon = 1e-6);
        }
        // Both inertias together count as less torque.
        assert_relative_eq!(found.driver_inertia + found.follower_inertia, -found.torque, epsilon = 1e-15);
        assert!(found.friction < 0.0, "friction brakes");
    }
    let free = escapement(Mechanism::FOUR_PIN, 1.0, 1.0, 1.0, 0.0);
    assert!(matches!(Sensitivities::new(&free), Err(DynamicsError::NoTerminalSpeed { .. })));
    let limit = existence::critical_friction(Mechanism::FOUR_PIN, 1.0).expect("a limit").friction;
    let near = escapement(Mechanism::FOUR_PIN, 1.0, 1.0, 1.0, limit * (1.0 - 1e-5));
    assert!(matches!(Sensitivities::new(&near), Err(DynamicsError::TooMuchFriction { .. })));
}

#[test]
fn the_cycle_starts_and_ends_at_the_speed_of_the_steady_state() {
    for of in samples() {
        let engagement = Engagement::new(&of).expect("an engagement");
        let steady = engagement.steady_state().expect("steady");
        let lines = engagement.steady_cycle(500).expect("a cycle");
        assert_eq!(lines.len(), 501);
        let (first, last) = (lines[0], lines[500]);
        for line in [first, last] {
            assert_relative_eq!(line.speed, steady.entry_speed, max_relative = 1e-9);
        }
        assert_relative_eq!(last.turned, engagement.reset(), max_relative = 1e-9);
        assert_relative_eq!(last.time, steady.period, max_relative = 1e-12);
        let speeds = lines.iter().map(|line| line.speed);
        let (low, high) = speeds.fold((f64::INFINITY, 0.0_f64), |(low, high), s| (low.min(s), high.max(s)));
        assert!(low >= steady.minimum.speed * (1.0 - 1e-9) && low < steady.minimum.speed * 1.001);
        assert!(high <= steady.peak.speed * (1.0 + 1e-9) && high > steady.peak.speed * 0.99);
        // The angle by Simpson's rule over the speed.
        let step = steady.period / 500.0;
        let sum: f64 = lines.windows(3).step_by(2).map(|w| w[0].speed + 4.0 * w[1].speed + w[2].speed).sum();
        assert_relative_eq!(sum * step / 3.0, engagement.reset(), max_relative = 1e-5);
    }
}

#[test]
fn accelerations_are_the_slopes_of_the_speeds() {
    for of in samples() {
        let found = Accelerations::new(&of).expect("accelerations");
        let lines = Engagement::new(&of).and_then(|of| of.steady_cycle(40_000)).expect("a cycle");
        let strongest = |speed: fn(&geneva_dynamics::steady::PrintedLine) -> f64| {
            let slopes = lines.windows(2).map(|w| (speed(&w[1]) - speed(&w[0])) / (w[1].time - w[0].time));
            slopes.fold(0.0_f64, |most, slope| if slope.abs() > most.abs() { slope } else { most })
        };
        assert_relative_eq!(found.driver.value, strongest(|line| line.speed), max_relative = 2e-3);
        assert_relative_eq!(found.follower.value, strongest(|line| line.follower_speed), max_relative = 2e-3);
        // N R = I_f φ'', and R is between the centre distance less the crank and its value at entry.
        let least = of.inertias().follower() * found.follower.value.abs();
        assert!(found.normal_moment.value.abs() * (of.mechanism().centre_distance_ratio() + 1.0) > least);
        assert!(found.jump > 0.0, "the pin leaves braking the follower and enters driving it");
    }
}

#[test]
fn an_energy_balance_gives_the_same_greatest_normal_force() {
    // N R = I_f φ'', with φ'' from the differences of the follower's kinetic energy over its angle.
    let of = escapement(Mechanism::FOUR_PIN, 0.06, 1.0, 1.0, 0.25);
    let found = Accelerations::new(&of).expect("accelerations").normal_moment;
    let lines = Engagement::new(&of).and_then(|of| of.steady_cycle(40_000)).expect("a cycle");
    let by_energy = lines.windows(2).map(|w| {
        let middle = (w[0].angle + w[1].angle) / 2.0;
        let energy = (w[1].follower_speed * w[1].follower_speed - w[0].follower_speed * w[0].follower_speed) / 2.0;
        let (pose, turned) = (of.pose(middle), w[1].angle - w[0].angle);
        energy / (pose.velocity_ratio() * turned) / pose.radius_squared.sqrt()
    });
    let strongest = by_energy.fold(0.0_f64, |most, n| if n.abs() > most.abs() { n } else { most });
    assert_relative_eq!(found.value, strongest, max_relative = 3e-3);
}

#[test]
fn the_count_of_engagements_is_that_of_a_start_near_the_steady_speed() {
    let of = escapement(Mechanism::THREE_PIN, 0.1, 1.0, 1.0, 0.2);
    let (engagement, settling) = (Engagement::new(&of).expect("one"), Settling::new(&of).expect("settles"));
    let steady = engagement.steady_state().expect("steady").entry_speed;
    let mut speed = steady * (1.0 + 1e-4);
    let mut count = 0;
    while (speed / steady - 1.0).abs() > 1e-6 {
        speed = engagement.return_map(speed).expect("handed over");
        count += 1;
    }
    assert_eq!(f64::from(count), settling.engagements(0.01).ceil());
}

/// A wheel of unit inertia that turns by half a radian from blow to blow.
fn runaway(pallet: f64, drag: Drag) -> Runaway {
    Runaway::new(1.0, pallet, 0.5, drag).expect("a runaway escapement")
}

#[test]
fn blows_alone_or_with_a_fly_make_the_rate_go_as_the_root_of_the_torque() {
    for (pallet, square) in [(0.01, 0.0), (0.3, 0.0), (0.9, 0.0), (0.3, 0.2), (0.0, 0.2), (0.05, 7.0)] {
        let of = runaway(pallet, Drag { square, ..Drag::default() });
        let speed = |torque: f64| of.steady(torque).expect("steady").mean_speed;
        for torque in [0.01, 1.0, 700.0] {
            assert_relative_eq!(speed(2.0 * torque) / speed(torque), 2.0_f64.sqrt(), max_relative = 1e-12);
            assert_relative_eq!(of.power(torque).expect("steady"), 0.5, epsilon = 1e-9);
        }
    }
}

#[test]
fn a_blow_takes_what_the_torque_has_given_and_the_closed_form_agrees() {
    let (pallet, torque, beat) = (0.3, 2.0, 0.5);
    let of = runaway(pallet, Drag::default());
    let steady = of.steady(torque).expect("steady");
    let energy = |speed: f64| (1.0 + pallet) / 2.0 * speed * speed;
    assert_relative_eq!(energy(steady.before_blow) - energy(steady.after_blow), torque * beat, max_relative = 1e-12);
    // The impulse on the wheel is that on the pallet, which turns round.
    let (before, after) = (steady.before_blow, steady.after_blow);
    assert_relative_eq!(before - after, pallet * (before + after), max_relative = 1e-12);
    // Under a constant torque the time is twice the angle over the sum of the speeds.
    assert_relative_eq!(steady.period, 2.0 * beat / (before + after), max_relative = 1e-9);
    let path = of.between_blows(torque, after);
    assert_relative_eq!(path[path.len() - 1].1, before, max_relative = 1e-12);
    assert_relative_eq!(steady.mean_speed, beat / steady.period, max_relative = 1e-15);
}

#[test]
fn a_constant_drag_makes_the_rate_follow_the_torque_more_and_oil_up_to_its_first_power() {
    let power = |drag: Drag| runaway(0.3, drag).power(1.0).expect("steady");
    let constant = power(Drag { constant: 0.5, ..Drag::default() });
    // The root of what is left of the torque: 1/2 × K / (K − C).
    assert_relative_eq!(constant, 1.0, epsilon = 1e-6);
    let oiled = [0.1, 1.0, 10.0, 30.0].map(|linear| power(Drag { linear, ..Drag::default() }));
    assert!(oiled.is_sorted() && oiled[0] > 0.5 && oiled[3] < 1.0 && oiled[3] > 0.95, "{oiled:?}");
}

#[test]
fn what_has_no_steady_motion_is_refused() {
    let drag = |constant| Drag { constant, ..Drag::default() };
    assert!(matches!(runaway(0.3, drag(1.0)).steady(1.0), Err(DynamicsError::DragTorque { .. })));
    assert!(matches!(runaway(0.0, drag(0.0)).steady(1.0), Err(DynamicsError::NoTerminalSpeed { .. })));
    assert!(matches!(runaway(0.3, drag(0.0)).steady(f64::NAN), Err(DynamicsError::NotPositive { .. })));
    for pallet in [-0.1, 1.0, f64::NAN] {
        assert!(matches!(Runaway::new(1.0, pallet, 0.5, Drag::default()), Err(DynamicsError::OutOfRange { .. })));
    }
    assert!(Runaway::new(0.0, 0.0, 0.5, Drag::default()).is_err() && Runaway::new(1.0, 0.1, -1.0, drag(0.0)).is_err());
    assert!(Runaway::new(1.0, 0.1, 0.5, drag(-1.0)).is_err());
}

#[test]
fn a_verge_with_oil_goes_between_the_cube_root_and_the_first_power_of_the_torque() {
    let power = |half_period: f64| foliot_power(half_period).expect("a power");
    assert_relative_eq!(power(1e-3), 1.0 / 3.0, epsilon = 1e-6);
    assert_relative_eq!(power(0.02 - 1e-12), power(0.02), epsilon = 1e-6);
    assert_relative_eq!(power(1e4), 1.0, epsilon = 1e-3);
    let all = [0.01, 0.1, 1.0, 3.0, 10.0, 100.0].map(power);
    assert!(all.is_sorted() && all[0] > 1.0 / 3.0 && all[5] < 1.0, "{all:?}");
    assert!(foliot_power(0.0).is_err());
    // By steps in time, from one change of the torque's sign to the next: half the swing is one radian, and the drag one.
    let half_period = |torque: f64| {
        let (step, mut entry) = (5e-4, 0.0);
        loop {
            let (mut angle, mut speed, mut time): (f64, f64, f64) = (1.0, entry, 0.0);
            while angle > -1.0 {
                // The middle of the step, with the drag in it.
                let next = (speed * (1.0 - step / 2.0) - torque * step) / (1.0 + step / 2.0);
                (angle, speed, time) = (angle + step * (speed + next) / 2.0, next, time + step);
            }
            if (-speed - entry).abs() < 1e-4 {
                return time;
            }
            entry = -speed;
        }
    };
    for torque in [0.1, 1.0, 10.0] {
        let by_steps = -libm::log(half_period(1.1 * torque) / half_period(torque / 1.1)) / (2.0 * libm::log(1.1));
        let time = half_period(torque);
        assert_relative_eq!(torque * (time - 2.0 * libm::tanh(time / 2.0)), 2.0, max_relative = 2e-3);
        assert_relative_eq!(by_steps, power(time), max_relative = 5e-3);
    }
}

/// The flight and the blow by steps of time, with the pin and the slot by coordinates and no formula of the mechanism: time,
/// closing speed and lost energy. The blow keeps the moments of momentum that an impulse across the slot leaves.
fn crossed_in_steps(of: &Parameters, crossing: &Crossing, play: f64, step: f64) -> [f64; 3] {
    let ratio = of.mechanism().centre_distance_ratio();
    let (inertia, other) = (of.inertias().driver(), of.inertias().follower());
    // The follower's axis is the origin, the driver's is at (ratio, 0); the pin's circle has the radius one.
    let pin = |theta: f64| [ratio - libm::cos(theta), libm::sin(theta)];
    let mut slot = {
        let [x, y] = pin(crossing.from);
        libm::atan2(y, x)
    };
    let (mut theta, mut speed, mut time) = (crossing.from, crossing.driver_speed, 0.0);
    let gap = |theta: f64, slot: f64| {
        let [x, y] = pin(theta);
        x * libm::sin(slot) - y * libm::cos(slot)
    };
    while gap(theta, slot) < play {
        speed += of.torque() / inertia * step / 2.0;
        theta += speed * step;
        speed += of.torque() / inertia * step / 2.0;
        slot += crossing.follower_speed * step;
        time += step;
    }
    // Velocities across the slot of a flank's point where the pin is, and of the pin, each per unit of its speed.
    let ([x, y], across) = (pin(theta), [-libm::sin(slot), libm::cos(slot)]);
    let flank = -y * across[0] + x * across[1];
    let own = libm::sin(theta) * across[0] + libm::cos(theta) * across[1];
    let closing = crossing.follower_speed * flank - speed * own;
    let impulse = closing / (flank * flank / other + own * own / inertia);
    let energy = |driver: f64, follower: f64| 0.5 * (inertia * driver * driver + other * follower * follower);
    let after = energy(speed + impulse * own / inertia, crossing.follower_speed - impulse * flank / other);
    [time, closing, energy(speed, crossing.follower_speed) - after]
}

#[test]
fn the_pin_crosses_its_play_as_steps_of_time_say() {
    for of in samples() {
        for play in [0.002, 0.01] {
            let found = Crossing::new(&of, play).expect("a steady state").expect("it crosses");
            let [time, closing, energy] = crossed_in_steps(&of, &found, play, found.duration / 50_000.0);
            assert_relative_eq!(found.duration, time, max_relative = 1e-4);
            assert_relative_eq!(found.closing_speed, closing, max_relative = 2e-4);
            assert_relative_eq!(found.energy, energy, max_relative = 4e-4);
            assert!(found.from < found.to && found.share > 0.0 && found.share < 0.5, "{found:?}");
            assert_relative_eq!(
                found.share,
                found.energy / (of.torque() * 2.0 * of.mechanism().engagement_half_angle()),
                max_relative = 1e-12
            );
        }
    }
}

#[test]
fn a_pin_enters_with_the_blow_that_steps_of_time_say() {
    for of in samples() {
        for play in [0.002, 0.01] {
            let found = EntryBlow::new(&of, play).expect("a steady state");
            let entry = Engagement::new(&of).and_then(|of| of.steady_state()).expect("steady").entry_speed;
            let (half, ratio) = (of.mechanism().engagement_half_angle(), of.mechanism().centre_distance_ratio());
            let (driver, follower) = (of.inertias().driver(), of.inertias().follower());
            // The follower's axis is the origin; the slot keeps the direction in which the pin comes in.
            let pin = |theta: f64| [ratio - libm::cos(theta), libm::sin(theta)];
            let [x, y] = pin(-half);
            let along = [x / libm::hypot(x, y), y / libm::hypot(x, y)];
            let (mut theta, mut speed) = (-half, entry);
            let step = found.late / entry / 50_000.0;
            let off = |theta: f64| (along[0] * pin(theta)[1] - along[1] * pin(theta)[0]).abs();
            while off(theta) < play / 2.0 {
                speed += of.torque() / driver * step / 2.0;
                theta += speed * step;
                speed += of.torque() / driver * step / 2.0;
            }
            let own = (along[0] * libm::cos(theta) - along[1] * libm::sin(theta)).abs();
            let arm = along[0] * pin(theta)[0] + along[1] * pin(theta)[1];
            let impulse = own * speed / (arm * arm / follower + own * own / driver);
            let [after, carried] = [speed - impulse * own / driver, impulse * arm / follower];
            let lost = 0.5 * (driver * (speed * speed - after * after) - follower * carried * carried);
            assert_relative_eq!(theta + half, found.late, max_relative = 1e-4);
            assert_relative_eq!(found.closing_speed, own * speed, max_relative = 2e-4);
            assert_relative_eq!(found.energy, lost, max_relative = 4e-4);
            // After the blow they go on together.
            assert_relative_eq!(after * own, carried * arm, max_relative = 1e-9);
        }
        assert!([0.0, 1.0, -0.1, f64::NAN].iter().all(|play| EntryBlow::new(&of, *play).is_err()));
    }
}

#[test]
fn the_flight_begins_where_the_force_is_zero_and_the_share_of_the_blow_is_the_same_for_every_torque() {
    for of in samples() {
        let found = Crossing::new(&of, 0.01).expect("steady").expect("it crosses");
        let forces = of.contact_forces(found.from, found.driver_speed).expect("forces");
        let strongest = Accelerations::new(&of).expect("steady").normal_moment.value;
        assert!(forces.normal_moment.abs() < 1e-6 * strongest.abs(), "{forces:?}");
        let inertias = of.inertias();
        let stronger =
            escapement(of.mechanism(), inertias.driver(), inertias.follower(), 4.0 * of.torque(), of.friction());
        let other = Crossing::new(&stronger, 0.01).expect("steady").expect("it crosses");
        assert_relative_eq!(other.share, found.share, max_relative = 1e-9);
        assert_relative_eq!(other.closing_speed, 2.0 * found.closing_speed, max_relative = 1e-9);
        // From no force the gap grows as the cube of the time, so an eighth of a small play takes half the time.
        let [small, eighth] = [8e-6, 1e-6].map(|play| Crossing::new(&of, play).expect("steady").expect("it crosses"));
        assert_relative_eq!(small.duration, 2.0 * eighth.duration, max_relative = 0.02);
        assert!(Crossing::new(&of, 0.0).is_err() && Crossing::new(&of, 5.0).expect("steady").is_none());
    }
    let free = escapement(Mechanism::FOUR_PIN, 1.0, 1.0, 1.0, 0.0);
    assert!(matches!(Crossing::new(&free, 0.01), Err(DynamicsError::NoTerminalSpeed { .. })));
}
