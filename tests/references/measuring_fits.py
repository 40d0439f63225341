"""Writes measuring_fits.json: what cycles that fit circles must report of workpieces whose touch points scatter.

Independent of the program: the touch points are calculated here from the scenes, the least-squares circles with SciPy
and sharpened by Newton's method with NumPy. `python3 measuring_fits.py > measuring_fits.json`.
"""
import json
import math
import random

import numpy as np
from scipy.optimize import least_squares

BALL = 2.0
SET_UP = 2.0


def fit(points):
    """Centre and radius of the circle with the least sum of squared distances."""
    points = np.array(points)

    def gaps(circle):
        return np.hypot(*(points - circle[:2]).T) - circle[2]

    start = [*points.mean(axis=0), np.hypot(*(points - points.mean(axis=0)).T).mean()]
    circle = least_squares(gaps, start, method="lm", xtol=1e-15, ftol=1e-15, gtol=1e-15).x
    for _ in range(6):
        away = points - circle[:2]
        distance = np.hypot(*away.T)
        n = away / distance[:, None]
        gap = distance - circle[2]
        rows = np.column_stack([n, np.ones(len(points))])
        sides = np.column_stack([-n[:, 1], n[:, 0], np.zeros(len(points))])
        hessian = rows.T @ rows + (sides * (gap / distance)[:, None]).T @ sides
        circle = circle + np.linalg.solve(hessian, rows.T @ gap)
    return circle


def number(value):
    """A number as programs and scenes write it, with all its digits."""
    return repr(value) if isinstance(value, int) else repr(float(value))


def direction(angle):
    return np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])


class Probe:
    """A ball that touches round walls; each trigger comes too late by the next value of the list."""

    def __init__(self, scatter, offset=(0.0, 0.0), believed=(0.0, 0.0)):
        self.scatter, self.used = scatter, 0
        self.offset, self.believed, self.turn = np.array(offset), np.array(believed), 1.0

    def touch(self, spindle, way, centre, radius, inside):
        """From where the spindle stands in a direction: the ball centre as the control knows it."""
        ball = np.array(spindle) + self.turn * self.offset
        reach = radius - BALL if inside else radius + BALL
        away = ball - np.array(centre)
        along = away @ way
        root = math.sqrt(along * along - away @ away + reach * reach)
        travel = -along + (root if inside else -root) + self.scatter[self.used % len(self.scatter)]
        self.used += 1
        return np.array(spindle) + travel * way + self.turn * self.believed


def scene(probe, solid, start, radius=BALL):
    lists = ", ".join(number(value) for value in probe.scatter)
    return (
        f"scene: 1\ntools: [{{T: 1, L: 100, R: {number(radius)}, TP_NO: 1}}]\n"
        f"probe: {{NO: 1, ball_radius: {BALL}, DIST: 20, SET_UP: {SET_UP}, "
        f"offset: [{number(probe.offset[0])}, {number(probe.offset[1])}], CAL_OF1: {number(probe.believed[0])}, CAL_OF2: {number(probe.believed[1])}, "
        f"scatter: [{lists}]}}\nstart: {start}\nparts:\n  - solid: {solid}\n"
    )


def block_without(holes):
    holes = ", ".join(f"{{cylinder: {{centre: [{number(x)}, {number(y)}], diameter: {number(d)}, from: -40, to: 1}}}}" for x, y, d in holes)
    return f"{{difference: [{{box: {{min: [-150, -150, -30], max: [150, 150, 0]}}}}, {holes}]}}"


def definition(cycle, values):
    return f"TOOL CALL 1 Z\nTCH PROBE {cycle}\n" + "".join(f"{name}={number(value)}\n" for name, value in values.items())


def scatter():
    size = random.choice([1e-4, 1e-3, 1e-2])
    return [round(random.uniform(-size, size), 9) for _ in range(random.randint(5, 17))]


def circle_case(inside):
    """421 and 422."""
    probe = Probe(scatter())
    centre = [random.uniform(-30, 30), random.uniform(-30, 30)]
    diameter = random.uniform(20, 60)
    nominal = [centre[0] + random.uniform(-0.5, 0.5), centre[1] + random.uniform(-0.5, 0.5)]
    size = diameter + random.uniform(-0.5, 0.5)
    start, step, count = random.uniform(-180, 180), random.choice([-1, 1]) * random.uniform(30, 90), random.choice([3, 4])
    ring = size / 2 - BALL - SET_UP if inside else size / 2 + BALL + SET_UP
    contacts = []
    for i in range(count):
        out = direction(start + i * step)
        way = out if inside else -out
        contacts.append(probe.touch(np.array(nominal) + max(ring, 0) * out, way, centre, diameter / 2, inside))
    x, y, radius = fit(contacts)
    found = 2 * (radius + BALL) if inside else 2 * (radius - BALL)
    limits = {"Q275": 0, "Q276": 0} if inside else {"Q277": 0, "Q278": 0}
    values = {"Q273": nominal[0], "Q274": nominal[1], "Q262": size, "Q325": start, "Q247": step, "Q261": -5, "Q320": 0, "Q260": 20,
              "Q301": 0, **limits, "Q279": 0, "Q280": 0, "Q281": 0, "Q309": 0, "Q330": 0, "Q423": count, "Q365": 1}
    solid = block_without([(*centre, diameter)]) if inside else (
        f"{{cylinder: {{centre: [{number(centre[0])}, {number(centre[1])}], diameter: {number(diameter)}, from: -30, to: 0}}}}")
    return {
        "program": definition(421 if inside else 422, values),
        "scene": scene(probe, solid, [0, 0, 60]),
        "q": {"151": x, "152": y, "153": found, "161": x - nominal[0], "162": y - nominal[1], "163": found - size},
    }


def bolt_circle_case():
    """430: a circle through the centres of three holes, each the centre of the circle that fits four points."""
    probe = Probe(scatter())
    centre, radius = np.array([random.uniform(-20, 20), random.uniform(-20, 20)]), random.uniform(30, 60)
    angles = [random.uniform(-180, -60), random.uniform(-30, 60), random.uniform(90, 170)]
    holes = [(*(centre + radius * direction(a) + np.random.uniform(-0.2, 0.2, 2)), random.uniform(12, 18)) for a in angles]
    centres = []
    for angle, (x, y, diameter) in zip(angles, holes):
        tip = centre + radius * direction(angle)
        centres.append(fit([probe.touch(tip, np.array(way), (x, y), diameter / 2, True) for way in ((1, 0), (0, 1), (-1, 0), (0, -1))])[:2])
    x, y, found = fit(centres)
    values = {"Q273": centre[0], "Q274": centre[1], "Q262": 2 * radius, "Q291": angles[0], "Q292": angles[1], "Q293": angles[2],
              "Q261": -5, "Q260": 20, "Q288": 0, "Q289": 0, "Q279": 0, "Q280": 0, "Q281": 0, "Q309": 0, "Q330": 0}
    return {
        "program": definition(430, values),
        "scene": scene(probe, block_without(holes), [0, 0, 60]),
        "q": {"151": x, "152": y, "153": 2 * found},
    }


def calibration_case(inside):
    """462 and 463: rough centre from the middles of two chords, the radius from the circle that fits the fine points, the
    offset from the middles of two chords with the probe turned by half a turn."""
    offset = [random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)]
    believed = [random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)]
    probe = Probe(scatter(), offset, believed)
    size, radius = random.uniform(8, 20), BALL + random.uniform(-0.02, 0.02)
    start, count, angle = [random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)], random.randint(3, 8), random.uniform(0, 360)
    ring = size - radius - SET_UP if inside else size + radius + SET_UP
    sign = 1 if inside else -1

    def chords(tip):
        u, v = direction(angle), np.array([-direction(angle)[1], direction(angle)[0]])
        a, b, c, d = (probe.touch(tip + ring * way, sign * way, (0, 0), size, inside) for way in (u, v, -u, -v))
        return u * (u @ (a + c) / 2) + v * (v @ (b + d) / 2)

    tip = chords(np.array(start)) - np.array(believed)
    outs = [direction(angle + i * 360 / count) for i in range(count)]
    fine = fit([probe.touch(tip + ring * out, sign * out, (0, 0), size, inside) for out in outs])
    probe.turn = -1.0
    turned = chords(tip)
    found = np.array(believed) + (turned - fine[:2]) / 2
    values = {"Q407": size, "Q320": 0, **({} if inside else {"Q301": 0}), "Q423": count, "Q380": angle}
    solid = block_without([(0, 0, 2 * size)]) if inside else f"{{cylinder: {{radius: {number(size)}, from: -60, to: 0}}}}"
    return {
        "program": definition(462 if inside else 463, values),
        "scene": scene(probe, solid, [start[0], start[1], -6 if inside else 2], radius),
        "cells": {"R": size - fine[2] if inside else fine[2] - size, "CAL_OF1": found[0], "CAL_OF2": found[1]},
    }


def plain(value):
    if isinstance(value, dict):
        return {name: plain(item) for name, item in value.items()}
    return float(value) if isinstance(value, np.floating) else value


def main():
    random.seed(462)
    np.random.seed(462)
    cases = [circle_case(True) for _ in range(60)] + [circle_case(False) for _ in range(60)]
    cases += [bolt_circle_case() for _ in range(30)]
    cases += [calibration_case(True) for _ in range(30)] + [calibration_case(False) for _ in range(30)]
    print(json.dumps([plain(case) for case in cases], indent=1))


main()
