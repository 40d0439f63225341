"""Expected results of measuring rotary axes whose positioning and whose probe scatter.

Nothing here is of the engine: the contacts of the ball with the sphere are calculated as ray and sphere, the sphere
through them and the places of the axes are the least squares of SciPy. The scatter comes from a generator with a seed.

    python3 tests/laws/kinematics_scatter.py > tests/laws/kinematics_scatter.json

needs NumPy and SciPy; it was run with NumPy 2 and SciPy 1. The test reads what it has printed.
"""
import json

import numpy
from scipy.optimize import least_squares

SPHERE, BALL, SET_UP = 12.5, 2.0, 5.0
PRECISE = dict(xtol=1e-15, ftol=1e-15, gtol=1e-15)


def rotation(letter, degrees):
    """What a rotary table of that letter does to the workpiece: it turns the other way."""
    a = numpy.radians(-degrees)
    c, s = numpy.cos(a), numpy.sin(a)
    return numpy.array(
        {"A": [[1, 0, 0], [0, c, -s], [0, s, c]], "B": [[c, 0, s], [0, 1, 0], [-s, 0, c]], "C": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[letter]
    )


def carried(axes, centres, angles, point):
    """Where a point of the table at 0 is: the last axis of the list carries it."""
    for letter in reversed(axes):
        point = centres[letter] + rotation(letter, angles[letter]) @ (point - centres[letter])
    return point


def contact(start, way, sphere, late):
    """The centre of the ball where the probe triggers."""
    from_sphere = start - sphere
    b = from_sphere @ way
    c = from_sphere @ from_sphere - (SPHERE + BALL) ** 2
    return start + way * (-b - numpy.sqrt(b * b - c) + late)


def measured(case, triggers, sphere, expected):
    """Where the control finds the sphere that it expects somewhere."""
    away = SPHERE + BALL + SET_UP
    up = numpy.array([0.0, 0.0, 1.0])
    late = lambda: case["probe_scatter"][next(triggers) % len(case["probe_scatter"])]
    touched = [contact(expected + up * away, -up, sphere, late())]
    centre = expected + up * ((touched[0] - expected) @ up - SPHERE - BALL)
    for point in range(case["points"]):
        angle = numpy.radians(360.0 / case["points"] * point)
        out = numpy.array([numpy.cos(angle), numpy.sin(angle), 0.0])
        touched.append(contact(centre + out * away, -out, sphere, late()))
    touched = numpy.array(touched)
    gaps = lambda v: numpy.linalg.norm(touched - v[:3], axis=1) - v[3]
    return least_squares(gaps, [*centre, SPHERE + BALL], **PRECISE).x[:3]


def results(case):
    """Q141 to Q149: scatter before, scatter after, corrections."""
    axes = [axis["letter"] for axis in case["axes"]]
    model = {axis["letter"]: numpy.array(axis["centre"]) for axis in case["axes"]}
    truth = {axis["letter"]: numpy.array(axis["centre"]) + axis["error"] for axis in case["axes"]}
    preset = numpy.array(case["sphere"])
    triggers, turned = iter(range(10**9)), dict.fromkeys(axes, 0)
    now, stations, sphere = dict.fromkeys(axes, 0.0), [], preset
    for axis in case["axes"]:
        angles = [axis["start"] + (axis["end"] - axis["start"]) / (axis["count"] - 1) * k for k in range(axis["count"])]
        for number, angle in enumerate([0.0, *angles]):
            wanted = {**dict.fromkeys(axes, 0.0), axis["letter"]: angle}
            for letter in axes:
                turned[letter] += wanted[letter] != now[letter]
            now = wanted
            scatter = {a["letter"]: a["scatter"] for a in case["axes"]}
            astray = {l: scatter[l][(turned[l] - 1) % len(scatter[l])] if turned[l] else 0.0 for l in axes}
            real = carried(axes, truth, {l: now[l] + astray[l] for l in axes}, preset)
            seen = measured(case, triggers, real, carried(axes, model, now, sphere))
            stations.append((axis["letter"], number == 0, now, seen))
            if number == 0:
                back = seen
                for letter in axes:
                    back = model[letter] + rotation(letter, now[letter]).T @ (back - model[letter])
                sphere = back

    across = {"A": [1, 2], "B": [0, 2], "C": [0, 1]}
    unknown = [(letter, k) for letter in axes for k in across[letter]]

    def kinematics(v):
        centres = {letter: centre.copy() for letter, centre in model.items()}
        for (letter, k), by in zip(unknown, v[3:]):
            centres[letter][k] += by
        return centres

    def gaps(v):
        centres = kinematics(v)
        return numpy.concatenate([seen - carried(axes, centres, at, v[:3]) for _, _, at, seen in stations])

    found = least_squares(gaps, [*preset, *[0.0] * len(unknown)], **PRECISE).x

    def scatter(letter, centres):
        own = [station for station in stations if station[0] == letter]
        if not own:
            return -1.0
        back = own[0][3]
        for axis in axes:
            back = centres[axis] + rotation(axis, own[0][2][axis]).T @ (back - centres[axis])
        errors = [seen - carried(axes, centres, at, back) for _, _, at, seen in own[1:]]
        return float(numpy.sqrt(numpy.mean([e @ e for e in errors])))

    after = kinematics(found)
    correction = sum((after[letter] - model[letter] for letter in axes), numpy.zeros(3))
    known = lambda letter, centres: scatter(letter, centres) if letter in axes else -1.0
    return [*(known(l, model) for l in "ABC"), *(known(l, after) for l in "ABC"), *correction.tolist()]


def cases():
    for seed in range(6):
        random = numpy.random.default_rng(seed)
        rounded = lambda values: [round(float(value), 6) for value in values]
        lateness = rounded(numpy.abs(random.normal(0.0, 0.002, 17)))
        axes = []
        for letter in ["C"] if seed % 2 == 0 else ["A", "C"]:
            error = rounded(random.uniform(-0.1, 0.1, 3))
            error["ABC".index(letter)] = 0.0
            reach = 170.0 if letter == "C" else 80.0
            count = int(random.integers(2, 5)) * 2
            axes.append(
                dict(
                    letter=letter, centre=rounded(random.uniform(-40, 40, 3)), error=error, start=-reach, end=reach - 10.0 * (letter == "A"),
                    count=count, scatter=rounded(random.normal(0.0, 0.003, 11)),
                )
            )
        case = dict(
            axes=axes, sphere=rounded(random.uniform([60, -150, -120], [180, 150, -20])), points=int(random.integers(3, 9)), probe_scatter=lateness
        )
        yield dict(**case, results=results(case))


print(json.dumps(list(cases()), indent=1))
