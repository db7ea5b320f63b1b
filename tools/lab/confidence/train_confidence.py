#!/usr/bin/env python3
"""Trains the weights of the detector's confidence anew and prints their table as C++.

  cmake --build build --target quadrille_confidence
  build/bin/quadrille_confidence 200 1 > evidence.csv
  tools/lab/confidence/train_confidence.py evidence.csv

Takes the evidence of surfaces with whether they are right, fits a logistic model whose offset is
the prior of each surface's type, and prints the rows of confidence_weights.hpp with the new
weights. On stderr it says how well the weights in use and the new ones tell right from wrong, the
new ones also for scenes that they were not trained on. Needs numpy alone.

Each candidate of the search is weighed as if nothing else had been found. Where the detector is at
work fewer are wrong, and other surfaces explain what one leaves over: trained like this, "one" and
"log_remainder" are not those that the detector wants, and a table has to be tried before it is used.
"""

import argparse
import csv
import pathlib
import re
import sys

import numpy

TABLE = (pathlib.Path(__file__).resolve().parents[3]
         / "detector/src/surfaces/evidence/confidence_weights.hpp")
ROW = re.compile(r'(\{"(\w+)", )(-?[0-9.]+)(,.*)')
FOLDS = 5


def read_table():
    """Lines of the table's rows, and the weights in use by term."""
    rows = [line for line in TABLE.read_text().splitlines() if ROW.search(line)]
    return rows, {m[2]: float(m[3]) for m in map(ROW.search, rows)}


def read_evidence(path, terms):
    """Scenes, labels, priors and the terms, one row a surface."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    column = lambda name: numpy.array([float(row[name]) for row in rows])
    scenes = numpy.array([row["scene"] for row in rows])
    return (scenes, column("right"), column("log_prior"),
            numpy.stack([column(term) for term in terms], axis=1))


def probability(log_odds):
    return 1.0 / (1.0 + numpy.exp(-numpy.clip(log_odds, -30, 30)))


def train(x, y, prior, ridge):
    """Newton's method on the log likelihood; the ridge, in standard units, keeps it finite."""
    scale = numpy.maximum(x.std(axis=0), 1e-9)
    scale[0] = 1.0  # the constant
    z = x / scale
    penalty = ridge * numpy.eye(x.shape[1])
    penalty[0, 0] = 1e-9
    w = numpy.zeros(x.shape[1])
    for _ in range(100):
        p = probability(prior + z @ w)
        hessian = z.T @ (z * (p * (1 - p))[:, None]) + penalty
        step = numpy.linalg.solve(hessian, z.T @ (y - p) - penalty @ w)
        w += step
        if abs(step).max() < 1e-10:
            break
    return w / scale


def report(name, log_odds, y):
    """Log loss, and the share of pairs of a right and a wrong surface that are told apart."""
    p = numpy.clip(probability(log_odds), 1e-9, 1 - 1e-9)
    loss = -(y * numpy.log(p) + (1 - y) * numpy.log(1 - p)).mean()
    right, wrong = log_odds[y == 1], log_odds[y == 0]
    pairs = (right[:, None] > wrong[None, :]).mean() if len(right) and len(wrong) else float("nan")
    print(f"{name:28} log loss {loss:.3f}, pairs told apart {100 * pairs:.1f} %", file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("csv", help="what quadrille_confidence prints")
    parser.add_argument("--ridge", type=float, default=1.0,
                        help="penalty on squared weights in standard units (default: %(default)s)")
    arguments = parser.parse_args()

    rows, used = read_table()
    terms = list(used)
    scenes, y, prior, x = read_evidence(arguments.csv, terms)
    if len(set(y)) < 2:
        sys.exit("train_confidence.py: needs right and wrong surfaces; take more scenes")
    print(f"{len(y)} surfaces of {len(set(scenes))} scenes, {int(y.sum())} right", file=sys.stderr)

    new = train(x, y, prior, arguments.ridge)
    held_out = numpy.zeros(len(y))
    fold = numpy.unique(scenes, return_inverse=True)[1] % FOLDS
    for k in set(fold):
        rest = fold != k
        w = train(x[rest], y[rest], prior[rest], arguments.ridge)
        held_out[~rest] = prior[~rest] + x[~rest] @ w
    report("weights in use", prior + x @ numpy.array(list(used.values())), y)
    report("new weights", prior + x @ new, y)
    report("new weights, other scenes", held_out, y)

    weights = dict(zip(terms, new))
    for row in rows:
        print(ROW.sub(lambda m: f"{m[1]}{weights[m[2]]:.3g}{m[4]}", row))


if __name__ == "__main__":
    main()
