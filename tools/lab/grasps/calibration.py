#!/usr/bin/python3
"""Prints how often grasps hold beside the probability that the weights give them, in all and by kind of scenes.

    calibration.py success_weights.hpp ROWS.json…

The rows are those of rows.py, of scenes on which the weights were not trained.
"""
import json
import re
import sys
from pathlib import Path

import numpy as np

BINS, FEWEST = 10, 5  # with fewer grasps, a bin counts for no gap and a kind has no share in it


def probabilities(header, rows):
    """What success_probability() gives for the rows' terms."""
    text = Path(header).read_text()
    weights = {name: float(w) for w, name in re.findall(r'^ *(\S+),\s*// (\w+)$', text, re.M)}
    if any(set(row['terms']) != set(weights) for row in rows):
        sys.exit('calibration.py: %s has weights of other terms than the rows; make the rows anew' % header)
    terms = np.array([[row['terms'][name] for name in weights] for row in rows], float)
    bias = float(re.search(r'kSuccessBias = (\S+);', text)[1])
    return 1 / (1 + np.exp(-bias - np.clip(np.nan_to_num(terms), 0, 1) @ np.array(list(weights.values()))))


def wilson(good, n):
    z = 1.96
    middle, half = good / n + z * z / (2 * n), z * np.sqrt(good / n * (1 - good / n) / n + z * z / (4 * n * n))
    return max(0.0, middle - half) / (1 + z * z / n), (middle + half) / (1 + z * z / n)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    rows = [row for path in sys.argv[2:] for row in json.loads(Path(path).read_text())]
    if not rows:
        sys.exit('calibration.py: the rows have no grasps')
    p, good = probabilities(sys.argv[1], rows), np.array([row['good'] for row in rows])
    kind, bins = np.array([row['kind'] for row in rows]), np.minimum((BINS * p).astype(int), BINS - 1)
    print('probability   grasps  model   good   95 %')
    gaps = []
    for n in range(BINS):
        m = bins == n
        if m.any():
            print('%.1f to %.1f  %8d  %.3f  %.3f   %.2f to %.2f'
                  % (n / BINS, (n + 1) / BINS, m.sum(), p[m].mean(), good[m].mean(), *wilson(good[m].sum(), m.sum())))
        if m.sum() >= FEWEST:
            gaps.append(abs(p[m].mean() - good[m].mean()))
    loss = -np.log(np.where(good, p, 1 - p)).mean()
    print('mean gap of %d bins %.3f, log loss %.3f of %d grasps\n' % (len(gaps), np.mean(gaps or [np.nan]), loss, len(rows)))
    heads = '  '.join('%3.1f-' % (n / BINS) for n in range(BINS))
    print('%-32s grasps  model  good   good by probability, from\n%54s%s' % ('kind', '', heads))
    for k in sorted(set(kind)):
        m = kind == k
        cells = ['%.2f' % good[m & (bins == n)].mean() if (m & (bins == n)).sum() >= FEWEST else '   .' for n in range(BINS)]
        print('%-32s %6d   %.2f  %.2f   %s' % (k, m.sum(), p[m].mean(), good[m].mean(), '  '.join(cells)))


if __name__ == '__main__':
    main()
