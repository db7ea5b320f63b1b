#!/usr/bin/python3
"""Learns the weights of success_probability() and prints contacts/success_weights.hpp.

    train_success.py ROWS.json… >grasping/src/contacts/success_weights.hpp

Each file holds a list of grasps, {"scene": str, "kind": str, "terms": {…}, "good": bool}: the terms as in the JSON of
`quadrille plan --min-score 0`, and whether the grasp held. Scenes of one kind, such as those of one sensor and family,
count alike, however many grasps they have. A ridge draws each weight towards zero. The weights of the clearance and of the
room between pads and body are not learned but given: robots err, which simulated hands do not. On the standard error the script prints what the model
gives for scenes that it was not trained on.
"""
import json
import sys

import numpy as np

RIDGE, FOLDS, MASS = 1.0, 6, 150
GIVEN = {'clearance': 0.5, 'room': 0.5}
HEADER = '''// Written by tools/lab/grasps/train_success.py.
#pragma once

#include <array>

namespace quadrille {{

/// The log odds of success of a grasp whose terms are all zero.
inline constexpr double kSuccessBias = {bias:.4g};

/// The weights of the GraspTerms in the log odds of success, in the order of GraspTerms::visit().
inline constexpr std::array kSuccessWeights = {{
{weights}
}};

}}  // namespace quadrille
'''


def fit(x, good, mass, given):
    """Weights that maximise the likelihood less the ridge, by Newton's method, bias first.
    given: the weights that are given; NaN for those to be learned"""
    free = np.isnan(given)
    b = np.where(free, 0.0, given)
    ridge = np.r_[1e-6, np.full(len(b) - 1, RIDGE)][free]
    for _ in range(50):
        p = 1 / (1 + np.exp(-x @ b))
        slope = x[:, free].T @ (mass * (p - good)) + ridge * b[free]
        curve = (x[:, free] * (mass * p * (1 - p))[:, None]).T @ x[:, free] + np.diag(ridge)
        b[free] -= np.linalg.solve(curve, slope)
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
    mass = np.array([min(1.0, MASS / (kind == k).sum()) for k in kind])
    given = np.array([np.nan] + [GIVEN.get(name, np.nan) for name in names])
    p = np.zeros(len(good))
    for fold in range(FOLDS):
        test = scene % FOLDS == fold
        p[test] = 1 / (1 + np.exp(-x[test] @ fit(x[~test], good[~test], mass[~test], given)))
    for k in sorted(set(kind)):
        m = kind == k
        print('%-40s %5d grasps, good %.2f, model %.2f' % (k, m.sum(), good[m].mean(), p[m].mean()), file=sys.stderr)
    bins = np.minimum((10 * p).astype(int), 9)
    gaps = [abs(p[bins == n].mean() - good[bins == n].mean()) for n in range(10) if (bins == n).sum() > 20]
    print('mean gap of %d bins %.3f' % (len(gaps), np.mean(gaps)), file=sys.stderr)
    b = fit(x, good, mass, given)
    weights = '\n'.join('    %#.4g,  // %s' % (w, name) for w, name in zip(b[1:], names))
    print(HEADER.format(bias=b[0], weights=weights), end='')


if __name__ == '__main__':
    main()
