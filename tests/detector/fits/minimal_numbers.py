#!/usr/bin/env python3
"""Writes minimal_numbers.hpp: five oriented points of a quadric of each type, and the null vector of
the full system of all five (paper, eq. 4) by numpy's SVD, with the side of the normals.

usage: minimal_numbers.py > minimal_numbers.hpp
"""
import numpy as np

FORMS = {  # diagonal of x², y², z², then the coefficient of 2z and the constant
    "sphere": (1, 1, 1, 0, -0.8),
    "ellipsoid": (1, 1.8, 3, 0, -1),
    "cylinder": (1, 1, 0, 0, -0.5),
    "elliptic_cylinder": (1, 3, 0, 0, -0.8),
    "cone": (1, 1, -0.4, 0, 0),
    "elliptic_cone": (1, 2, -0.4, 0, 0),
    "elliptic_paraboloid": (1, 2, 0, -0.4, 0),
    "hyperbolic_paraboloid": (1, -2, 0, -0.4, 0),
    "hyperboloid_one_sheet": (1, 1.5, -0.6, 0, -0.3),
    "hyperboloid_two_sheets": (1, 1.5, -2, 0, 0.3),
    "hyperbolic_cylinder": (1, -2, 0, 0, -0.3),
    "parabolic_cylinder": (1, 0, 0, -0.4, 0),
    "parallel_planes": (0, 0, 1, 0, -0.3),
    "intersecting_planes": (1, 0, -2, 0, 0),
}


def matrix(form):
    a, b, c, i, j = form
    Q = np.diag([a, b, c, j]).astype(float)
    Q[2, 3] = Q[3, 2] = i
    return Q


def points_on(Q, random, count):
    points = []
    while len(points) < count:
        x, d = random.uniform(-1, 1, 3), random.normal(size=3)
        X, D = np.append(x, 1), np.append(d, 0)
        roots = np.roots([D @ Q @ D, 2 * X @ Q @ D, X @ Q @ X])
        for t in roots[np.isreal(roots)].real[:1]:
            y = x + t * d
            g = 2 * (Q @ np.append(y, 1))[:3]
            if np.linalg.norm(y) < 1.5 and np.linalg.norm(g) > 0.1:
                points.append((y, g / np.linalg.norm(g)))
    return points


def full_system(points):
    n = len(points)
    A = np.zeros((4 * n, 10 + n))
    for k, ((x, y, z), normal) in enumerate(points):
        A[4 * k, :10] = [x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z, 2 * x, 2 * y, 2 * z, 1]
        A[4 * k + 1, :10] = [2 * x, 0, 0, 2 * y, 2 * z, 0, 2, 0, 0, 0]
        A[4 * k + 2, :10] = [0, 2 * y, 0, 2 * x, 0, 2 * z, 0, 2, 0, 0]
        A[4 * k + 3, :10] = [0, 0, 2 * z, 0, 2 * x, 2 * y, 0, 0, 2, 0]
        A[4 * k + 1:4 * k + 4, 10 + k] = -normal
    return A


def height(plane_points, x):
    a, b, c = plane_points
    m = np.cross(b - a, c - a)
    return abs(m @ (x - a)) / np.linalg.norm(m)


def well_placed(points):
    """Bases that are far from degenerate for both solvers."""
    (p, n) = zip(*points)
    b = lambda i, j: abs(n[i] @ (p[j] - p[i]))
    pairs = sorted(min(b(i, j), b(j, i)) for i, j in ((0, 1), (1, 2), (2, 0)))
    planes = [height((p[0], p[1], p[j]), p[k]) for j in (2, 3, 4) for k in (2, 3, 4) if j != k]
    return pairs[1] > 0.1 and b(0, 1) > 0.1 and b(1, 0) > 0.1 and min(planes) > 0.1


def rotation(random):
    R, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return R * np.sign(np.linalg.det(R))


def example(form, random):
    while True:
        points = points_on(matrix(form), random, 5)
        if not well_placed(points):
            continue
        R, t, side = rotation(random), random.uniform(-1, 1, 3), random.choice([-1.0, 1.0])
        points = [(R @ x + t, side * (R @ n)) for x, n in points]
        _, s, V = np.linalg.svd(full_system(points))
        if s[13] < 1e-3 or s[14] > 1e-12:
            continue
        q = V[-1] * np.sign(V[-1][10:].sum())
        if (q[10:] < 0).any():
            continue
        return points, q[:10] / np.linalg.norm(q[:10])


def row(values):
    return "{" + ", ".join(repr(float(v)) for v in values) + "}"


def main():
    random = np.random.default_rng(19)
    print("""#pragma once

// Written by minimal_numbers.py beside this file.
#include <array>
#include <string_view>

#include "fit/oriented_points.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::test {

/// Five oriented points of a quadric, x y z of each and of its unit normal, and the paper's q.
struct MinimalNumbers {
  std::string_view type;
  std::array<double, 15> points, normals;
  std::array<double, 10> q;
};

inline OrientedPointsd points_of(const MinimalNumbers& numbers) {
  OrientedPointsd result(5);
  result.points = Eigen::Matrix<double, 3, 5>::Map(numbers.points.data());
  result.normals = Eigen::Matrix<double, 3, 5>::Map(numbers.normals.data());
  return result;
}

inline Vector10d q_of(const MinimalNumbers& numbers) { return Vector10d::Map(numbers.q.data()); }

// clang-format off""")
    print("inline constexpr std::array<MinimalNumbers, %d> kMinimalNumbers = {{" % (3 * len(FORMS)))
    for name, form in FORMS.items():
        for _ in range(3):
            points, q = example(form, random)
            print('    {"%s",\n     %s,\n     %s,\n     %s},' % (
                name, row(np.concatenate([x for x, _ in points])),
                row(np.concatenate([n for _, n in points])), row(q)))
    print("""}};
// clang-format on

}  // namespace quadrille::test""")


if __name__ == "__main__":
    main()
