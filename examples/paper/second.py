"""Computes the values of the paper a second time, from the motion itself, and writes second.json.

The equation of motion is integrated by the Runge-Kutta method of order four until the pendulum passes its lowest point, which
takes a quarter of the period. Nothing is shared with compute.py.
"""

import json
import math
import pathlib

GRAVITY = 9.80665  # m/s^2
LENGTH = 1.0  # m
STEP = 1e-4  # s


def step(angle, speed, time):
    """The angle and the angular velocity after a time."""

    def slope(angle, speed):
        return speed, -GRAVITY / LENGTH * math.sin(angle)

    a1, s1 = slope(angle, speed)
    a2, s2 = slope(angle + time / 2 * a1, speed + time / 2 * s1)
    a3, s3 = slope(angle + time / 2 * a2, speed + time / 2 * s2)
    a4, s4 = slope(angle + time * a3, speed + time * s3)
    return angle + time / 6 * (a1 + 2 * a2 + 2 * a3 + a4), speed + time / 6 * (s1 + 2 * s2 + 2 * s3 + s4)


def period(amplitude):
    """Four times the time from rest to the lowest point, in seconds."""
    angle, speed, steps = amplitude, 0.0, 0
    while angle > 0:
        angle, speed = step(angle, speed, STEP)
        steps += 1
    # Back to the lowest point, by Newton's method.
    time = STEP * steps
    for _ in range(3):
        back = -angle / speed
        angle, speed = step(angle, speed, back)
        time += back
    return 4 * time


def values():
    # The period tends to its limit with the square of the amplitude: two small amplitudes give the limit.
    near, far = period(1e-3), period(2e-3)
    small = near - (far - near) / 3
    found = {"small_period": {"value": small, "unit": "s"}}
    periods = {degrees: period(degrees * math.pi / 180) for degrees in (10, 30, 60, 90)}
    for degrees, of_amplitude in periods.items():
        found[f"period_{degrees}"] = {"value": of_amplitude, "unit": "s"}
        found[f"excess_{degrees}"] = {"value": 100 * (of_amplitude - small) / small, "unit": "%"}
    angle = math.pi / 3
    series = small + small * angle * angle * (1 / 16 + angle * angle * 11 / 3072)
    found["series_error_60"] = {"value": 1000 * (periods[60] - series), "unit": "ms"}
    found["lost_per_day"] = {"value": 86400 - 86400 * small / periods[10], "unit": "s"}
    return found


if __name__ == "__main__":
    target = pathlib.Path(__file__).with_name("second.json")
    target.write_text(json.dumps(values(), indent=2) + "\n")
