"""Writes circle_fits.txt: least-squares circles with 50 digits, independent of the program.

A line: the coordinates x y of the points | centre x, centre y, radius. The minimum of the sum of squared
distances is found by Newton's method on the exact gradient, started from the algebraic fit.
"""
import random

from mpmath import mp, matrix, mpf, lu_solve, sqrt, cos, sin, pi

mp.dps = 50


def algebraic(points):
    rows = matrix([[x, y, 1] for x, y in points])
    right = matrix([x * x + y * y for x, y in points])
    a, b, c = lu_solve(rows.T * rows, rows.T * right)
    return [a / 2, b / 2, sqrt(c + a * a / 4 + b * b / 4)]


def gradient(points, circle):
    cx, cy, r = circle
    gx = gy = gr = mpf(0)
    for x, y in points:
        d = sqrt((x - cx) ** 2 + (y - cy) ** 2)
        gx += (d - r) * (cx - x) / d
        gy += (d - r) * (cy - y) / d
        gr += r - d
    return matrix([gx, gy, gr])


def hessian(points, circle):
    h = matrix(3, 3)
    cx, cy, r = circle
    for x, y in points:
        dx, dy = cx - x, cy - y
        d = sqrt(dx * dx + dy * dy)
        h[0, 0] += 1 - r * dy * dy / d**3
        h[1, 1] += 1 - r * dx * dx / d**3
        h[0, 1] += r * dx * dy / d**3
        h[0, 2] -= dx / d
        h[1, 2] -= dy / d
        h[2, 2] += 1
    h[1, 0], h[2, 0], h[2, 1] = h[0, 1], h[0, 2], h[1, 2]
    return h


def fit(points):
    circle = algebraic(points)
    for _ in range(100):
        step = lu_solve(hessian(points, circle), -gradient(points, circle))
        circle = [c + s for c, s in zip(circle, step)]
        if max(abs(s) for s in step) < mpf(10) ** -40:
            return circle
    raise ArithmeticError("no minimum")


def main():
    random.seed(421)
    lines = []
    for noise in (0, 0.001, 0.05, 0.5):
        for count in (3, 4, 5, 8, 36):
            for start, sweep in ((0, 360), (30, 120), (200, 45)):
                centre = [random.uniform(-500, 500), random.uniform(-500, 500)]
                radius = random.uniform(2, 80)
                points = []
                for k in range(count):
                    a = (start + sweep * mpf(k) / count) * pi / 180
                    r = radius + random.uniform(-noise, noise)
                    # The numbers as the program reads them: doubles.
                    points.append((mpf(float(centre[0] + r * cos(a))), mpf(float(centre[1] + r * sin(a)))))
                found = fit(points)
                numbers = " ".join(repr(float(c)) for point in points for c in point)
                lines.append(numbers + " | " + " ".join(repr(float(c)) for c in found))
    with open(__file__.replace(".py", ".txt"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")


main()
