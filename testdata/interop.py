#!/usr/bin/env python3
"""Holds lath's files against NumPy and SciPy: what they write, lath reads; what lath writes, they read.

Not part of the test command. Run it in the root of the repository:

    python3 testdata/interop.py            compares
    python3 testdata/interop.py --record   writes the recorded files of npy/ and scipy/ anew

Last run: numpy 2.4.6, scipy 1.17.1.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from numpy.lib import format as npy
from scipy import interpolate

HERE = pathlib.Path(__file__).resolve().parent
GRID = np.array([[0.1, -0.0, 1e300], [5e-324, 1 / 3, -2.5]])


def arrays():
    """Name, array and version of every recorded .npy file."""
    yield "c-order", GRID, (1, 0)
    yield "fortran-order", np.asfortranarray(GRID), (1, 0)
    yield "big-endian", GRID.astype(">f8"), (1, 0)
    yield "version-2", GRID, (2, 0)
    yield "version-3", GRID, (3, 0)
    yield "one-dimension", GRID[:, 1].copy(), (1, 0)
    yield "float32", GRID[:, 1:2].astype("<f4"), (1, 0)
    yield "int64", np.array([[1, -2], [2**53, -(2**53)]]), (1, 0)
    yield "uint8", np.array([[0, 255]], dtype=np.uint8), (1, 0)
    yield "complex", np.array([[1 + 2j]]), (1, 0)
    yield "records", np.array([(1.0, 2.0)], dtype=[("x", "<f8"), ("y", "<f8")]), (1, 0)
    yield "text", np.array(["a"]), (1, 0)
    yield "nan", np.array([[1.0, np.nan]]), (1, 0)
    yield "empty", np.zeros((0, 2)), (1, 0)
    yield "cube", np.zeros((1, 1, 1)), (1, 0)


def splines():
    """Name, t, c, k and values at some parameters, of curves that SciPy made."""
    x = np.array([0.0, 1.0, 2.5, 3.0, 4.5, 6.0])
    y = np.array([1.0, -0.5, 0.25, 2.0, 0.0, 1.5])
    t, c, k = interpolate.splrep(x, y, k=3, s=0)
    yield "splrep", t, c, k, interpolate.BSpline(t, c, k)
    curve = interpolate.make_interp_spline(x, np.column_stack([y, x * y, -x]), k=4)
    yield "space", curve.t, curve.c, curve.k, curve


def record():
    for name, array, version in arrays():
        with open(HERE / "npy" / f"{name}.npy", "wb") as file:
            npy.write_array(file, array, version=version)
    for name, t, c, k, curve in splines():
        at = np.linspace(t[k], t[-k - 1], 9)
        spline = {"t": t.tolist(), "c": c.tolist(), "k": int(k)}
        values = np.atleast_2d(curve(at).T).T
        (HERE / "scipy" / f"{name}.json").write_text(json.dumps(spline) + "\n")
        answers = {"at": at.tolist(), "values": values.tolist()}
        (HERE / "scipy" / f"{name}.values.json").write_text(json.dumps(answers) + "\n")


def compare():
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["cargo", "run", "-q", "-p", "lath-io", "--example", "interop", "--", folder], check=True)
        folder = pathlib.Path(folder)
        for name in ["streamed", "kept"]:
            found = np.load(folder / f"{name}.npy")
            assert found.dtype == np.float64 and found.flags.c_contiguous, name
            assert found.tobytes() == GRID.tobytes(), name
        assert np.load(folder / "none.npy").shape == (0, 3)
        for name in ["splrep", "space"]:
            spline = json.loads((folder / f"{name}.json").read_text())
            answers = json.loads((HERE / "scipy" / f"{name}.values.json").read_text())
            curve = interpolate.BSpline(np.array(spline["t"]), np.array(spline["c"]), spline["k"])
            values = np.atleast_2d(curve(np.array(answers["at"])).T).T
            assert values.tolist() == answers["values"], name
    print(f"numpy {np.__version__} and scipy {sys.modules['scipy'].__version__} read what lath writes")


if __name__ == "__main__":
    record() if "--record" in sys.argv else compare()
