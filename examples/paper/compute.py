"""Computes the values of the paper with the arithmetic-geometric mean, and writes values.json."""

import json
import math
import pathlib

GRAVITY = 9.80665  # m/s^2
LENGTH = 1.0  # m


def period(amplitude):
    """The period in seconds at an amplitude in radians: 2 pi sqrt(l/g) over the mean of 1 and cos(amplitude/2)."""
    above, below = 1.0, math.cos(amplitude / 2)
    while above - below > 1e-15:
        above, below = (above + below) / 2, math.sqrt(above * below)
    return 2 * math.pi * math.sqrt(LENGTH / GRAVITY) / above


def values():
    small = 2 * math.pi * math.sqrt(LENGTH / GRAVITY)
    found = {"small_period": {"value": small, "unit": "s"}}
    for degrees in (10, 30, 60, 90):
        of_amplitude = period(math.radians(degrees))
        found[f"period_{degrees}"] = {"value": of_amplitude, "unit": "s"}
        found[f"excess_{degrees}"] = {"value": 100 * (of_amplitude / small - 1), "unit": "%"}
    series = 1 + math.radians(60) ** 2 / 16 + 11 * math.radians(60) ** 4 / 3072
    found["series_error_60"] = {"value": 1000 * abs(series * small - period(math.radians(60))), "unit": "ms"}
    found["lost_per_day"] = {"value": 86400 * (1 - small / period(math.radians(10))), "unit": "s"}
    return found


if __name__ == "__main__":
    target = pathlib.Path(__file__).with_name("values.json")
    target.write_text(json.dumps(values(), indent=2) + "\n")
