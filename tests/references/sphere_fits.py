"""Writes sphere_fits.txt: least-squares spheres with 50 digits, independent of the program.

A line: the coordinates x y z of the points | centre x, centre y, centre z, radius. The minimum of the sum of squared
distances is found by Newton's method on the exact gradient, started from the algebraic fit. The points are those of a
calibration (a ring of them and the pole), with form error, and scattered ones.
"""
import random

from mpmath import mp, matrix, mpf, lu_solve, sqrt, cos, sin, pi

mp.dps = 50


def algebraic(points):
    rows = matrix([[*p, 1] for p in points])
    right = matrix([sum(c * c for c in p) for p in points])
    a, b, c, d = lu_solve(rows.T * rows, rows.T * right)
    return [a / 2, b / 2, c / 2, sqrt(d + (a * a + b * b + c * c) / 4)]


def newton_step(points, sphere):
    gradient, hessian = matrix(4, 1), matrix(4, 4)
    for p in points:
        away = [p[k] - sphere[k] for k in range(3)]
        d = sqrt(sum(c * c for c in away))
        row = [-c / d for c in away] + [mpf(-1)]
        gap = d - sphere[3]
        for i in range(4):
            gradient[i] += gap * row[i]
            for k in range(4):
                hessian[i, k] += row[i] * row[k]
                if i < 3 and k < 3:
                    hessian[i, k] += gap / d * ((1 if i == k else 0) - row[i] * row[k])
    return lu_solve(hessian, -gradient)


def fit(points):
    sphere = algebraic(points)
    for _ in range(100):
        step = newton_step(points, sphere)
        sphere = [c + s for c, s in zip(sphere, step)]
        if max(abs(s) for s in step) < mpf(10) ** -40:
            return sphere
    raise ArithmeticError("no minimum")


def main():
    random.seed(460)
    lines = []
    for noise in (0, 0.001, 0.02, 0.3):
        for count in (3, 4, 5, 8, 8):
            for _ in range(3):
                centre = [random.uniform(-300, 300) for _ in range(3)]
                radius, start = random.uniform(8, 30), random.uniform(0, 360)
                height = random.uniform(-0.1, 0.1) * radius
                points = []
                for k in range(count):
                    angle = (mpf(start) + mpf(360) * k / count) * pi / 180
                    far = sqrt(mpf(radius) ** 2 - mpf(height) ** 2) + random.gauss(0, noise)
                    points.append([centre[0] + far * cos(angle), centre[1] + far * sin(angle), centre[2] + mpf(height)])
                points.append([mpf(centre[0]), mpf(centre[1]), mpf(centre[2]) + radius + random.gauss(0, noise)])
                lines.append(points)
        for _ in range(4):
            points = []
            for _ in range(12):
                way = [random.gauss(0, 1) for _ in range(3)]
                long = sum(c * c for c in way) ** 0.5
                points.append([mpf(10 + 20 * c / long + random.gauss(0, noise)) for c in way])
            lines.append(points)
    print("# x y z of the points | centre x, y, z, radius")
    for points in lines:
        points = [[mpf(float(c)) for c in p] for p in points]
        print(" ".join(repr(float(c)) for p in points for c in p), "|", " ".join(mp.nstr(c, 20) for c in fit(points)))


main()
