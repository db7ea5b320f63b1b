#!/usr/bin/env python3
"""Trains the models of the detector's confidence anew and prints confidence_weights.hpp.

  cmake --build build --target quadrille_confidence
  build/bin/quadrille_confidence --accept-none SCENE.ply... > all.csv
  build/bin/quadrille_confidence SCENE.ply... > used.csv
  tools/lab/confidence/train_confidence.py all.csv used.csv > confidence_weights.hpp

Reads the evidence for surfaces that the detector considered, and whether each surface is right.
Fits two logistic models, for curved and for flat surfaces, whose log odds are quadratic in the
terms. The first run weighs each candidate as if nothing else had been found, the second as the
detector meets it with the current weights. Train on both, build, and repeat the second run until
the models no longer improve. On stderr, the script tells how well the new models distinguish right
from wrong in scenes on which they were not trained. It needs only numpy, and some gigabytes of
memory for a hundred thousand surfaces.
"""

import argparse
import csv
import sys

import numpy

FOLDS = 4
# Terms are clamped to the range that holds all but this share of the surfaces.
TAIL = 0.003
KINDS = ("curved", "flat")


def read_evidence(paths):
    """Returns scenes, labels and terms by kind, one row per surface; and the terms' names."""
    rows = {kind: ([], [], []) for kind in KINDS}
    names = None
    for path in paths:
        with open(path, newline="") as file:
            reader = csv.reader(file)
            header = next(reader)
            if names not in (None, header[3:]):
                sys.exit(f"train_confidence.py: {path} has other terms than the files before it")
            names = header[3:]
            for scene, kind, right, *terms in reader:
                values = [float(term) for term in terms]
                if not numpy.isfinite(values).all():
                    continue
                scenes, labels, features = rows[kind]
                scenes.append(scene)
                labels.append(float(right))
                features.append(values)
    return {kind: tuple(map(numpy.array, row)) for kind, row in rows.items()}, names


def products(z):
    """Returns all products of two of 1, z_1, z_2, ..., in the order of the upper triangle."""
    z = numpy.hstack([numpy.ones((len(z), 1)), z])
    i, j = numpy.triu_indices(z.shape[1])
    return z[:, i] * z[:, j]


def probability(log_odds):
    return 1.0 / (1.0 + numpy.exp(-numpy.clip(log_odds, -30, 30)))


class Model:
    """A model whose log odds are a quadratic form of scaled terms."""

    def __init__(self, x, y, ridge):
        self.low, self.high = numpy.quantile(x, [TAIL, 1 - TAIL], axis=0)
        clamped = numpy.clip(x, self.low, self.high)
        self.mean = clamped.mean(axis=0)
        deviation = clamped.std(axis=0)
        self.deviation = numpy.where(deviation > 1e-6, deviation, 1.0)
        self.form = fit(products(self.scaled(x)), y, ridge)

    def scaled(self, x):
        return (numpy.clip(x, self.low, self.high) - self.mean) / self.deviation

    def log_odds(self, x):
        return products(self.scaled(x)) @ self.form


def fit(x, y, ridge):
    """Maximises the log likelihood by Newton's method; the ridge keeps the weights finite."""
    scale = numpy.maximum(x.std(axis=0), 1e-6)
    scale[0] = 1.0  # the constant term is not scaled
    x = x / scale
    penalty = ridge * numpy.eye(x.shape[1])
    penalty[0, 0] = 1e-9
    w = numpy.zeros(x.shape[1])
    for _ in range(30):
        p = probability(x @ w)
        hessian = x.T @ (x * (p * (1 - p))[:, None]) + penalty
        step = numpy.linalg.solve(hessian, x.T @ (y - p) - penalty @ w)
        w += step
        if abs(step).max() < 1e-4:
            break
    return w / scale


def report(name, log_odds, y):
    """Prints the log loss, and the share of right-wrong pairs of surfaces in the correct order."""
    p = numpy.clip(probability(log_odds), 1e-9, 1 - 1e-9)
    loss = -(y * numpy.log(p) + (1 - y) * numpy.log(1 - p)).mean()
    rank = numpy.empty(len(y))
    rank[numpy.argsort(log_odds)] = numpy.arange(1, len(y) + 1)
    n = y.sum()
    pairs = (rank[y == 1].sum() - n * (n + 1) / 2) / (n * (len(y) - n))
    print(f"{name:24} log loss {loss:.3f}, pairs told apart {100 * pairs:.1f} %", file=sys.stderr)


def train(kind, scenes, y, x, ridge, folds):
    if len(set(y)) < 2:
        sys.exit(f"train_confidence.py: needs right and wrong {kind} surfaces; take more scenes")
    print(f"{kind}: {len(y)} surfaces of {len(set(scenes))} scenes, {int(y.sum())} right",
          file=sys.stderr)
    model = Model(x, y, ridge)
    report("its own scenes", model.log_odds(x), y)
    if folds:
        held_out = numpy.zeros(len(y))
        fold = numpy.unique(scenes, return_inverse=True)[1] % FOLDS
        for k in range(FOLDS):
            rest = fold != k
            held_out[~rest] = Model(x[rest], y[rest], ridge).log_odds(x[~rest])
        report("other scenes", held_out, y)
    return model


def print_model(name, model):
    print(f"inline constexpr ConfidenceModel {name} = {{\n    {{{{")
    for row in zip(model.low, model.high, model.mean, model.deviation):
        print("        {" + ", ".join(f"{value:.6g}" for value in row) + "},")
    print("    }},\n    {{")
    values = [f"{value:.4g}" for value in model.form]
    for first in range(0, len(values), 8):
        print("        " + ", ".join(values[first:first + 8]) + ",")
    print("    }}};\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("csv", nargs="+", help="what quadrille_confidence prints")
    parser.add_argument("--ridge", type=float, default=3.0,
                        help="penalty on squared weights in standard units (default: %(default)s)")
    parser.add_argument("--no-folds", action="store_true", help="do not try other scenes")
    arguments = parser.parse_args()
    evidence, _ = read_evidence(arguments.csv)
    models = {kind: train(kind, *evidence[kind], arguments.ridge, not arguments.no_folds)
              for kind in KINDS}
    print("#pragma once\n\n#include \"surfaces/evidence/confidence_model.hpp\"\n\n"
          "namespace quadrille {\n\n"
          "// Printed by tools/lab/confidence/train_confidence.py, which says how it was trained.\n")
    print_model("kCurvedModel", models["curved"])
    print_model("kFlatModel", models["flat"])
    print("}  // namespace quadrille")


if __name__ == "__main__":
    main()
