#!/usr/bin/env python3
"""Holds lath's curves against SciPy on random data: uniform and interpolating B-splines, given derivatives, local rules.

Not part of the test command. Run it in the root of the repository, after `cargo build --release`:

    python3 testdata/compare_scipy.py [path of lath]

Every row: how many curves, and the greatest difference of values, first and second derivatives, beside the size of the data (the
derivatives also divided by 2p/h per order, h the shortest span).

Last run, 2026-11-26, numpy 2.4.6, scipy 1.17.1:

    uniform, ends repeated, degree 0-8            27 curves  5.3e-16  1.0e-16  2.8e-17
    uniform, closed, degree 0-8                   27 curves  5.9e-16  7.0e-17  3.1e-17
    uniform, phantom ends, degree 1-7             12 curves  3.7e-16  6.7e-17  1.8e-17
    tension 0, 1/4, 1                             18 curves  8.2e-16  2.3e-16  1.0e-16
    through points, not-a-knot, degree 1-7        21 curves  5.7e-15  2.6e-16  5.9e-17
    derivatives at both ends, degree 3, 5, 7       9 curves  4.0e-15  2.1e-16  1.6e-17
    derivatives at any point, degree 2-7          24 curves  1.0e-13  2.5e-15  8.5e-17
    Catmull-Rom, alpha 0 to 3/2                   18 curves  1.2e-15  2.0e-16  5.6e-17
    pchip, akima, makima                          18 curves  7.9e-16  2.3e-16  1.0e-16
"""

import json
import subprocess
import sys
import tempfile

import numpy as np
from scipy import interpolate

LATH = sys.argv[1] if len(sys.argv) > 1 else "target/release/lath"
RANDOM = np.random.default_rng(20261126)
WORST = {}


def lath(points, *arguments):
    text = "\n".join(",".join(repr(float(x)) for x in row) for row in points) + "\n"
    return subprocess.run([LATH, *arguments], input=text, capture_output=True, text=True, check=True).stdout


def evaluated(curve, at, derivatives=2):
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
        file.write("".join(f"{float(t)!r}\n" for t in at))
        file.flush()
        arguments = [LATH, "eval", "-", "--at-file", file.name, "--derivatives", str(derivatives)]
        out = subprocess.run(arguments, input=curve, capture_output=True, text=True, check=True).stdout
    rows = np.array([[float(x) for x in line.split(",")] for line in out.splitlines()[1:]])
    dimension = (rows.shape[1] - 1) // (derivatives + 1)
    return [rows[:, 1 + k * dimension : 1 + (k + 1) * dimension] for k in range(derivatives + 1)]


def compare(name, curve, reference, breaks, degree):
    """Inside the pieces, where no break makes a derivative ambiguous."""
    breaks = np.unique(breaks)
    at = np.concatenate([a + (b - a) * RANDOM.random(5) for a, b in zip(breaks, breaks[1:])])
    found = evaluated(curve, at)
    size = max(1.0, np.abs(reference(at)).max())
    shortest = np.diff(breaks).min()
    count, worst = WORST.setdefault(name, (0, [0.0, 0.0, 0.0]))
    for k in range(3):
        wanted = reference(at, k) if k <= degree else np.zeros_like(found[k])
        off = np.abs(found[k] - wanted).max() / size / (2 * max(degree, 1) / shortest) ** k
        worst[k] = max(worst[k], float(off))
    WORST[name] = (count + 1, worst)


def data(n, dimension=2):
    """Uneven increasing parameters and points."""
    t = np.cumsum(RANDOM.uniform(0.2, 2.0, n))
    return t, RANDOM.normal(size=(n, dimension)) * 10


def through(t, points, *arguments):
    return lath(np.column_stack([t, points]), "through", "-", "--params", "column:0", *arguments)


def collocated(t, points, degree, knots, given):
    """The B-spline over these knots with values and derivatives, by a dense system."""
    n = len(knots) - degree - 1
    basis = interpolate.BSpline(knots, np.eye(n), degree)
    rows = [basis(x) for x in t] + [basis(t[i], k) for i, k, _ in given]
    sides = [*points] + [value for _, _, value in given]
    return interpolate.BSpline(knots, np.linalg.solve(np.array(rows), np.array(sides)), degree)


def uniform():
    for degree in range(0, 9):
        for _ in range(3):
            points = RANDOM.normal(size=(degree + 5, 2)) * 10
            knots = np.arange(-degree, len(points) + 1.0)
            curve = lath(points, "curve", "-", "--kind", "bspline", "--degree", str(degree), "--at-polygon", "repeat")
            repeated = np.vstack([np.repeat(points[:1], max(degree - 1, 0), 0), points, np.repeat(points[-1:], max(degree - 1, 0), 0)])
            wide = np.arange(-degree, len(repeated) + 1.0)
            compare("uniform, ends repeated, degree 0-8", curve, interpolate.BSpline(wide, repeated, degree), wide[degree : len(repeated) + 1], degree)
            if degree % 2 == 1:
                m = degree // 2
                phantom = np.vstack([2 * points[0] - points[m:0:-1], points, 2 * points[-1] - points[-2 : -2 - m : -1]])
                wide = np.arange(-degree, len(phantom) + 1.0)
                curve = lath(points, "curve", "-", "--kind", "bspline", "--degree", str(degree), "--at-polygon", "phantom")
                compare("uniform, phantom ends, degree 1-7", curve, interpolate.BSpline(wide, phantom, degree), wide[degree : len(phantom) + 1], degree)
            around = np.vstack([points, points[:degree]])
            wide = np.arange(-degree, len(around) + 1.0)
            curve = lath(points, "curve", "-", "--kind", "bspline", "--degree", str(degree), "--closed")
            compare("uniform, closed, degree 0-8", curve, interpolate.BSpline(wide, around, degree), wide[degree : len(around) + 1], degree)


def tension():
    for _ in range(6):
        points = RANDOM.normal(size=(9, 2)) * 10
        joints = (points[:-2] + 4 * points[1:-1] + points[2:]) / 6
        slopes = (points[2:] - points[:-2]) / 2
        t = np.arange(len(joints) * 1.0)
        for s in [0.0, 0.25, 1.0]:
            curve = lath(points, "curve", "-", "--kind", "bspline", "--tension", str(s))
            compare("tension 0, 1/4, 1", curve, interpolate.CubicHermiteSpline(t, joints, (1 - s) * slopes), t, 3)


def interpolating():
    for degree in range(1, 8):
        for _ in range(3):
            t, points = data(degree + 6)
            reference = interpolate.make_interp_spline(t, points, degree)
            curve = through(t, points, "--kind", "bspline", "--degree", str(degree))
            compare("through points, not-a-knot, degree 1-7", curve, reference, t, degree)
    for degree in [3, 5, 7]:
        for _ in range(3):
            t, points = data(degree + 6)
            share = degree // 2
            given = [(k, RANDOM.normal(size=2)) for k in range(1, share + 1)]
            reference = interpolate.make_interp_spline(t, points, degree, bc_type=(given, given))
            options = []
            for index in [0, len(t) - 1]:
                for k, value in given:
                    options += ["--derivative", f"{index}:{k}:{float(value[0])!r},{float(value[1])!r}"]
            curve = through(t, points, "--kind", "bspline", "--degree", str(degree), *options)
            compare("derivatives at both ends, degree 3, 5, 7", curve, reference, t, degree)
    for degree in range(2, 8):
        for _ in range(4):
            t, points = data(degree + 6)
            places = RANDOM.choice(len(t), 3, replace=False)
            given = [(int(i), k, RANDOM.normal(size=2)) for i in places for k in range(1, int(RANDOM.integers(1, degree)) + 1) if k < degree]
            options = []
            for i, k, value in given:
                options += ["--derivative", f"{i}:{k}:{float(value[0])!r},{float(value[1])!r}"]
            curve = through(t, points, "--kind", "bspline", "--degree", str(degree), *options)
            knots = np.array(json.loads(curve)["shapes"][0]["knots"])
            reference = collocated(t, points, degree, knots, given)
            compare("derivatives at any point, degree 2-7", curve, reference, np.concatenate([t, knots]), degree)


def local():
    for alpha in [0.0, 0.25, 0.5, 0.75, 1.0, 1.5]:
        for _ in range(3):
            _, points = data(9)
            steps = np.linalg.norm(np.diff(points, axis=0), axis=1) ** alpha
            t = np.concatenate([[0.0], np.cumsum(steps)])
            curve = lath(points, "through", "-", "--kind", "catmull-rom", "--params", f"alpha:{alpha}")
            slopes = [interpolate.KroghInterpolator(t[i : i + 3], points[i : i + 3]) for i in range(len(t) - 2)]
            tangents = [slopes[0].derivative(t[0])] + [slopes[i].derivative(t[i + 1]) for i in range(len(slopes))] + [slopes[-1].derivative(t[-1])]
            compare("Catmull-Rom, alpha 0 to 3/2", curve, interpolate.CubicHermiteSpline(t, points, tangents), t, 3)
    rules = {
        "pchip": interpolate.PchipInterpolator,
        "akima": interpolate.Akima1DInterpolator,
        "makima": lambda t, y: interpolate.Akima1DInterpolator(t, y, method="makima"),
    }
    for name, rule in rules.items():
        for _ in range(6):
            t, points = data(10)
            compare("pchip, akima, makima", through(t, points, "--kind", name), rule(t, points), t, 3)


if __name__ == "__main__":
    for part in [uniform, tension, interpolating, local]:
        part()
    for name, (count, worst) in WORST.items():
        print(f"{name:44} {count:3} curves  " + "  ".join(f"{off:.1e}" for off in worst))
    assert all(worst[0] < 1e-12 and worst[1] < 1e-11 and worst[2] < 1e-10 for _, worst in WORST.values())
