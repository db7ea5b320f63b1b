#!/usr/bin/python3
"""Prints grasps with their terms and outcomes, to train on with train_success.py.

    rows.py tried KIND RESULT.json DUMP >rows.json
    rows.py judged KIND SCENES PLANS >rows.json

tried: the first grasp of each plan of a run of the declutter benchmark, as it held in the physics engine: RESULT.json
is what the run wrote with --out, DUMP the folder of its --dump. judged: all grasps of PLANS/NAME.json on the scenes
SCENES/NAME.ply of make_sensor_scenes.py, as score_grasps.py judges them on the true shapes. Both programs are in the
folder bench of $QUADRILLE_DATA, or of ../shared beside the source tree. KIND names what the scenes have in common, such
as "stereo-kitchen".
"""
import json
import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]


def row(scene, kind, grasp, good, tried):
    return {'scene': scene, 'kind': kind, 'target': grasp['target'], 'terms': grasp['terms'], 'good': good, 'tried': tried}


def tried(kind, result, dump):
    result = json.loads(Path(result).read_text())
    if result['planner_without_file']:
        sys.exit('rows.py: %d plans are missing in %s; run its planner by hand' % (result['planner_without_file'], dump))
    for one in result['log']:
        for step in one['steps']:
            if 'attempt' not in step:
                continue
            name = '%s_%d' % (result['kind'], one['seed'])
            plan = json.loads((Path(dump) / ('%s_%d_plan.json' % (name, step['attempt']))).read_text())
            if plan['grasps']:
                # Numbers of targets begin anew with each attempt.
                yield row('%s_%d' % (name, step['attempt']), kind, plan['grasps'][0], step['success'], True)


def judged(kind, scenes, plans):
    data = Path(os.environ.get('QUADRILLE_DATA', ROOT.parent / 'shared'))
    if not (data / 'bench/grasps').is_dir():
        sys.exit('rows.py: %s has no bench/grasps; set QUADRILLE_DATA' % data)
    sys.path.insert(0, str(data / 'bench/grasps'))
    from score_grasps import Truth
    for path in sorted(Path(plans).glob('*.json')):
        truth = Truth(str(Path(scenes) / path.stem))
        for grasp in json.loads(path.read_text())['grasps']:
            yield row(path.stem, kind, grasp, truth.judge(grasp)[0] == 'good', False)


def main():
    ways = {'tried': tried, 'judged': judged}
    if len(sys.argv) != 5 or sys.argv[1] not in ways:
        sys.exit(__doc__)
    json.dump(list(ways[sys.argv[1]](*sys.argv[2:])), sys.stdout)


if __name__ == '__main__':
    main()
