"""scipy's part of the benchmark: one request a line on standard input, one answer a line on standard output.

    load FILE          lists of doubles, each its length and its values: abscissae, points (three a row), parameters
    answer FILE OUT    lists: degree and number of orders, knots, points, parameters; writes values and derivatives of the
                       B-spline to OUT, as doubles, order by order
    sample TASK FILE   writes the points at the parameters to FILE, as doubles
    run TASK           does the work once and answers the seconds it took

Answers begin with "ok "; anything else is the reason why not. The first line is an answer too: the versions.
"""

import sys
from time import perf_counter

try:
    import numpy
    import scipy
    from scipy.interpolate import BSpline, CubicSpline, make_interp_spline
except ImportError as error:
    print(error)
    sys.exit()

abscissae = points = parameters = None


def lists_of(path):
    numbers = numpy.fromfile(path, "<f8")
    lists = []
    while numbers.size:
        length = int(numbers[0])
        lists.append(numbers[1 : 1 + length].copy())
        numbers = numbers[1 + length :]
    return lists


def load(path):
    first, flat, last = lists_of(path)
    return first, flat.reshape(-1, 3), last


def answer_all(path, out):
    (degree, orders), knots, points, parameters = lists_of(path)
    curve = BSpline(knots, points, int(degree))
    numpy.concatenate([curve(parameters, nu=k) for k in range(int(orders))]).tofile(out)


def interpolate(task):
    if task == "CubicSpline":
        return CubicSpline(abscissae, points, bc_type="natural")
    return make_interp_spline(abscissae, points, k=3, bc_type="natural")


def sample(task):
    curve = BSpline(abscissae, points, 3) if task == "BSpline" else interpolate(task)
    return curve(parameters)


def run(task):
    """Building a curve is timed for the interpolations, evaluating one that was built before for the B-spline."""
    if task == "BSpline":
        curve = BSpline(abscissae, points, 3)
        start = perf_counter()
        result = curve(parameters)
    else:
        start = perf_counter()
        result = interpolate(task)
    taken = perf_counter() - start
    del result
    return taken


print(f"ok scipy {scipy.__version__}, numpy {numpy.__version__}", flush=True)
for line in sys.stdin:
    verb, *words = line.rstrip("\n").split(maxsplit=2)
    answer = ""
    try:
        if verb == "load":
            abscissae, points, parameters = load(line.split(maxsplit=1)[1].rstrip("\n"))
        elif verb == "answer":
            answer_all(*words)
        elif verb == "sample":
            sample(words[0]).tofile(words[1].rstrip("\n"))
        else:
            answer = repr(run(words[0]))
        print("ok", answer, flush=True)
    except Exception as error:
        print(type(error).__name__, str(error).replace("\n", " "), flush=True)
