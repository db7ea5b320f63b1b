#!/usr/bin/python3
"""Learns the weights of success_probability() and prints contacts/success_weights.hpp; calibration.py comes after it.

    train_success.py ROWS.json… >grasping/src/contacts/success_weights.hpp

Each file holds a list of grasps, {"scene": str, "kind": str, "target": int, "terms": {…}, "good": bool, "tried":
bool}: the terms as in the JSON of `quadrille plan --min-score 0`, whether the grasp held, and whether it was tried in the
physics engine rather than judged. All targets of a scene count alike, however many grasps they have, since one grasp of each
is executed; so do kinds of scenes, such as those of one sensor and family. What was tried counts twice: there are few of
these grasps, and the judge is stricter than physics about things that turn in the hand. A ridge draws each weight towards
zero. No term but the range may make a grasp less likely to hold: where the grasps say so, they are too few. The weights of
the clearance and of the room between pads and body are not learned but given: robots err, which simulated hands do not. So
is that of what was seen, since these scenes have few grasps in unseen space. On the standard error the script prints what
the model gives for scenes that it was not trained on.
"""
import json
import sys
from collections import Counter

import numpy as np

RIDGE, FOLDS, MASS, LEAST, TRIED = 1.0, 6, 150, 0.05, 2.0
GIVEN = {'clearance': 0.5, 'room': 0.5, 'seen': 3.5}
HEADER = '''// Written by tools/lab/grasps/train_success.py.
#pragma once

#include <array>

namespace quadrille {{

/// The log odds of success of a grasp whose terms are all zero, before they are calibrated.
inline constexpr double kSuccessBias = {bias:.4g};

/// The weights of the GraspTerms in these log odds, in the order of GraspTerms::visit().
inline constexpr std::array kSuccessWeights = {{
{weights}
}};

}}  // namespace quadrille
'''


def fit(x, good, mass, given, signs):
    """Weights that maximise the likelihood less the ridge, bias first, each with its sign.
    given: the weights that are given; NaN for those to be learned
    signs: of the weights; 0 if it may be either"""
    given = given.copy()
    while True:
        b = fit_free(x, good, mass, given)
        excess = np.where(np.isnan(given) & (signs != 0), signs * b - LEAST, 0.0)
        worst = excess.argmin()
        if excess[worst] >= 0.0:
            return b
        given[worst] = signs[worst] * LEAST


def fit_free(x, good, mass, given):
    """Weights of either sign, by Newton's method."""
    free = np.isnan(given)
    b = np.where(free, 0.0, given)
    ridge = np.r_[1e-6, np.full(len(b) - 1, RIDGE)][free]
    for _ in range(50):
        p = 1 / (1 + np.exp(-x @ b))
        slope = x[:, free].T @ (mass * (p - good)) + ridge * b[free]
        curve = (x[:, free] * (mass * p * (1 - p))[:, None]).T @ x[:, free] + np.diag(ridge)
        step = np.linalg.solve(curve, slope)
        b[free] -= step * min(1.0, 2.0 / np.abs(step).max())  # far from the maximum whole steps may diverge
    return b


def main():
    rows = [row for path in sys.argv[1:] for row in json.load(open(path))]
    if not rows:
        sys.exit(__doc__)
    names = list(rows[0]['terms'])
    x = np.array([[1.0] + [row['terms'][name] for name in names] for row in rows])
    good = np.array([row['good'] for row in rows], float)
    kind = np.array(['%s, %s' % (row['kind'], 'shape' if row['terms']['shape'] else 'points') for row in rows])
    scene = np.unique([row['scene'] for row in rows], return_inverse=True)[1]
    target = ['%s %s %d' % (row['kind'], row['scene'], row['target']) for row in rows]
    number = Counter(target)
    share = 1.0 / np.array([number[t] for t in target])
    total = {k: share[kind == k].sum() for k in set(kind)}
    mass = share * np.array([min(1.0, MASS / total[k]) for k in kind])
    mass *= np.where([row['tried'] for row in rows], TRIED, 1.0)
    given = np.array([np.nan] + [GIVEN.get(name, np.nan) for name in names])
    signs = np.array([0] + [-1 if name == 'range' else 1 for name in names])
    p = np.zeros(len(good))
    for fold in range(FOLDS):
        test = scene % FOLDS == fold
        p[test] = 1 / (1 + np.exp(-x[test] @ fit(x[~test], good[~test], mass[~test], given, signs)))
    for k in sorted(set(kind)):
        m = kind == k
        print('%-40s %5d grasps, good %.2f, model %.2f' % (k, m.sum(), good[m].mean(), p[m].mean()), file=sys.stderr)
    bins = np.minimum((10 * p).astype(int), 9)
    gaps = [abs(p[bins == n].mean() - good[bins == n].mean()) for n in range(10) if (bins == n).sum() > 20]
    print('mean gap of %d bins %.3f' % (len(gaps), np.mean(gaps)), file=sys.stderr)
    b = fit(x, good, mass, given, signs)
    weights = '\n'.join('    %#.4g,  // %s' % (w, name) for w, name in zip(b[1:], names))
    print(HEADER.format(bias=b[0], weights=weights), end='')


if __name__ == '__main__':
    main()
