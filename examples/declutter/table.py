#!/usr/bin/python3
"""Prints the results that run has written: table.py --text|--json|--csv RESULTS"""
import csv
import json
import math
import re
import sys
from pathlib import Path


def wilson(good, n):
    """The share of the good among n, and its interval with 95 %."""
    if not n:
        return None, [0, 1]
    z, p = 1.96, good / n
    middle, half = p + z * z / (2 * n), z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return p, [max(0, (middle - half) / (1 + z * z / n)), min(1, (middle + half) / (1 + z * z / n))]


def cpu_seconds(path):
    """The mean time of a plan. After each plan, sh has written its own times and those of its children."""
    lines = path.read_text().splitlines()[1::2]
    minutes = [re.findall(r'(\d+)m([\d.]+)s', line) for line in lines]
    return sum(60 * int(m) + float(s) for line in minutes for m, s in line) / max(1, len(lines))


def row(path):
    r = json.loads(path.read_text())
    scenes, planner = path.stem.split('_', 1)
    if 'gsr' in r:
        attempts, objects, good, cleared = r['attempts'], r['objects'], r['successes'], r['successes']
        ms, missing = r['own_ms'] or r['wall_ms'], r['planner_without_file']
    else:  # the first grasp of each target, judged
        attempts, objects, ms, missing = r['first'], r['graspable'], r['total_ms'], 0
        good, cleared = round((r['best']['good'] if attempts else 0) * attempts), round(r['reached'] * objects)
    (success, success_interval), (share, share_interval) = wilson(good, attempts), wilson(cleared, objects)
    return dict(set=scenes, planner=planner, attempts=attempts, objects=objects, success=success,
                success_interval=success_interval, cleared=share, cleared_interval=share_interval, plan_ms=ms,
                plan_cpu_s=cpu_seconds(path.with_suffix('.cpu')), plans_missing=missing)


def percent(share, interval):
    return '     -         ' if share is None else '%4.0f  %3.0f to %3.0f' % (100 * share, *(100 * x for x in interval))


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ('--text', '--json', '--csv'):
        sys.exit(__doc__)
    rows = [row(path) for path in sorted(Path(sys.argv[2]).glob('*_*.json'))]
    if sys.argv[1] == '--json':
        print(json.dumps(rows, indent=1))
    elif sys.argv[1] == '--csv':
        flat = [{k: ' '.join('%.4f' % x for x in v) if isinstance(v, list) else v for k, v in r.items()} for r in rows]
        out = csv.DictWriter(sys.stdout, list(flat[0]))
        out.writeheader()
        out.writerows(flat)
    else:
        wide = max(len(r['planner']) for r in rows)
        print('%-18s %-*s attempts  success %%, 95 %%   cleared %%, 95 %%  plan ms  CPU s' % ('set', wide, 'planner'))
        for r in rows:
            print('%-18s %-*s %8d  %s   %s  %7.0f  %5.2f' % (
                r['set'], wide, r['planner'], r['attempts'], percent(r['success'], r['success_interval']),
                percent(r['cleared'], r['cleared_interval']), r['plan_ms'] or 0, r['plan_cpu_s']))
        for r in rows:
            if r['plans_missing']:
                print('%s: %s wrote no plan %d times' % (r['set'], r['planner'], r['plans_missing']))


if __name__ == '__main__':
    main()
