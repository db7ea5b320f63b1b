#!/usr/bin/python3
"""Makes the score of grasps a probability, and prints how far it is one.

    calibration.py CONTACTS ROWS.json…         how often grasps hold beside their score, in all and by kind of scenes
    calibration.py --fit CONTACTS ROWS.json…   prints score_calibration.hpp

CONTACTS is the folder of success_weights.hpp and score_calibration.hpp, grasping/src/contacts. The rows are those of
rows.py, of scenes on which neither was fitted; the grasps of a target come best first.

--fit finds the slope and the offset of Platt's scaling (J. Platt, "Probabilistic outputs for support vector machines",
1999) that make the outcomes most likely. The weights need it since a ridge draws them towards zero and some are given.
All kinds of scenes count alike, however many grasps they have. In each, the first grasps of all targets, which are
those that are executed, count as much as all grasps together, and there all targets count alike.
"""
import json
import re
import sys
from collections import Counter
from pathlib import Path

import numpy as np

BINS, FEWEST = 10, 5  # of fewer grasps in a bin no share is printed for a kind
HEADER = '''// Written by tools/lab/grasps/calibration.py.
#pragma once

namespace quadrille {{

/// The log odds of success of a grasp are this slope times those that the weights give, plus this
/// offset. Since the slope is positive, the order of grasps is that of the weights.
inline constexpr double kCalibrationSlope = {slope:.2f}, kCalibrationOffset = {offset:.2f};

}}  // namespace quadrille
'''


def sums(contacts, rows):
    """The log odds that the weights give for the rows' terms."""
    text = (Path(contacts) / 'success_weights.hpp').read_text()
    weights = {name: float(w) for w, name in re.findall(r'^ *(\S+),\s*// (\w+)$', text, re.M)}
    if any(set(row['terms']) != set(weights) for row in rows):
        sys.exit('calibration.py: %s has weights of other terms than the rows; make the rows anew' % contacts)
    terms = np.array([[row['terms'][name] for name in weights] for row in rows], float)
    bias = float(re.search(r'kSuccessBias = (\S+);', text)[1])
    return bias + np.clip(np.nan_to_num(terms), 0, 1) @ np.array(list(weights.values()))


def probabilities(contacts, rows):
    """What success_probability() gives for the rows' terms."""
    text = (Path(contacts) / 'score_calibration.hpp').read_text()
    slope, offset = (float(re.search(name + r' = ([^,;]+)', text)[1]) for name in ('kCalibrationSlope', 'kCalibrationOffset'))
    return 1 / (1 + np.exp(-offset - slope * sums(contacts, rows)))


def masses(rows):
    """How much each row counts in a fit."""
    kinds = [row['kind'] for row in rows]
    targets = ['%s %s %d' % (row['kind'], row['scene'], row['target']) for row in rows]
    number, seen = Counter(targets), set()
    first = np.array([not (t in seen or seen.add(t)) for t in targets], float)
    share = 1 / np.array([number[t] for t in targets])
    total = Counter()
    for kind, one in zip(kinds, share):
        total[kind] += one  # this is the number of targets, and so that of first grasps
    return (first + share) / np.array([total[kind] for kind in kinds])


def fitted(log_odds, good, mass):
    """Offset and slope that maximise the likelihood, by Newton's method."""
    x, b = np.stack([np.ones(len(log_odds)), log_odds], 1), np.array([0.0, 1.0])
    for _ in range(50):
        p = 1 / (1 + np.exp(-x @ b))
        step = np.linalg.solve((x.T * (mass * p * (1 - p))) @ x, x.T @ (mass * (p - good)))
        b -= step * min(1.0, 1.0 / np.abs(step).max())  # far from the maximum whole steps may diverge
    if not b[1] > 0.0:
        sys.exit('calibration.py: grasps with a higher score hold less often; the weights are wrong')
    return b


def gap(p, good):
    """The mean over all grasps of how far the probability in their bin is from the share that hold there."""
    bins = np.minimum((BINS * p).astype(int), BINS - 1)
    return sum(abs((p - good)[bins == n].sum()) for n in range(BINS)) / len(p)


def by_chance(p, times=200):
    """What gap() gives on average if grasps hold with exactly these probabilities: few grasps never show them exactly."""
    random = np.random.default_rng(1)
    return np.mean([gap(p, random.random(len(p)) < p) for _ in range(times)])


def wilson(good, n):
    z = 1.96
    middle, half = good / n + z * z / (2 * n), z * np.sqrt(good / n * (1 - good / n) / n + z * z / (4 * n * n))
    return max(0.0, middle - half) / (1 + z * z / n), (middle + half) / (1 + z * z / n)


def main():
    arguments = [one for one in sys.argv[1:] if one != '--fit']
    if len(arguments) < 2:
        sys.exit(__doc__)
    rows = [row for path in arguments[1:] for row in json.loads(Path(path).read_text())]
    if not rows:
        sys.exit('calibration.py: the rows have no grasps')
    good = np.array([row['good'] for row in rows])
    if '--fit' in sys.argv:
        offset, slope = fitted(sums(arguments[0], rows), good, masses(rows))
        print(HEADER.format(slope=slope, offset=offset), end='')
        return
    p = probabilities(arguments[0], rows)
    kind, bins = np.array([row['kind'] for row in rows]), np.minimum((BINS * p).astype(int), BINS - 1)
    print('probability   grasps  model   good   95 %')
    for n in range(BINS):
        m = bins == n
        if m.any():
            print('%.1f to %.1f  %8d  %.3f  %.3f   %.2f to %.2f'
                  % (n / BINS, (n + 1) / BINS, m.sum(), p[m].mean(), good[m].mean(), *wilson(good[m].sum(), m.sum())))
    loss = -np.log(np.where(good, p, 1 - p)).mean()
    print('mean gap %.3f (by chance %.3f), log loss %.3f of %d grasps\n' % (gap(p, good), by_chance(p), loss, len(rows)))
    heads = '  '.join('%3.1f-' % (n / BINS) for n in range(BINS))
    print('%-32s grasps  model  good   gap  by chance   good by probability, from\n%71s%s' % ('kind', '', heads))
    for k in sorted(set(kind)):
        m = kind == k
        cells = ['%.2f' % good[m & (bins == n)].mean() if (m & (bins == n)).sum() >= FEWEST else '   .' for n in range(BINS)]
        print('%-32s %6d   %.2f  %.2f  %.3f      %.3f   %s'
              % (k, m.sum(), p[m].mean(), good[m].mean(), gap(p[m], good[m]), by_chance(p[m]), '  '.join(cells)))


if __name__ == '__main__':
    main()
