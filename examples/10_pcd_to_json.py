#!/usr/bin/env python3
"""The quadrics of a cloud in a file, as JSON: what to start from where `quadrille detect --json` says too much.

    PYTHONPATH=build/python python3 examples/10_pcd_to_json.py CLOUD.pcd > quadrics.json
"""
import json
import sys

import quadrille

points, viewpoint = quadrille.read_cloud(sys.argv[1])
found = [
    {"type": detection.type, "pose": detection.X_CQ.tolist(), "dimensions": dict(detection.dimensions)}
    for detection in quadrille.detect(points, viewpoint=viewpoint)
]
json.dump(found, sys.stdout, indent=2)
print()
