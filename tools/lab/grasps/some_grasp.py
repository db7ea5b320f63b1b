#!/usr/bin/python3
"""Plans for the Franka Hand; in a share of the rounds of the declutter benchmark a random grasp comes first.

    some_grasp.py SHARE QUADRILLE [OPTION…] CLOUD OUT

The benchmark tries the first grasp of OUT, which it names KIND_SEED_ATTEMPT_plan.json: KIND_SEED decides whether all
plans of that round are shuffled, the whole name decides the order.
"""
import json
import random
import subprocess
import sys
from pathlib import Path


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    share, quadrille, *options, cloud, out = sys.argv[1:]
    subprocess.run([quadrille, 'plan', cloud, '--gripper', 'franka', '--threads', '1', *options, '--json', out],
                   stdout=subprocess.DEVNULL, check=True)
    name = Path(out).name
    if random.Random('_'.join(name.split('_')[:2])).random() < float(share):
        plan = json.loads(Path(out).read_text())
        random.Random(name).shuffle(plan['grasps'])
        Path(out).write_text(json.dumps(plan))


if __name__ == '__main__':
    main()
