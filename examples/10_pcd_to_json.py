#!/usr/bin/env python3
"""Writes the quadrics of a cloud file as JSON, to adapt where `quadrille detect --json` is too long.

    PYTHONPATH=build/python python3 examples/10_pcd_to_json.py CLOUD.pcd > quadrics.json
"""
import json
import sys

import quadrille

if len(sys.argv) != 2:
    sys.exit("usage: 10_pcd_to_json.py CLOUD.pcd")
points, viewpoint = quadrille.read_cloud(sys.argv[1])
found = [
    {"type": detection.type, "pose": detection.X_CQ.tolist(), "dimensions": dict(detection.dimensions)}
    for detection in quadrille.detect(points, viewpoint=viewpoint)
]
json.dump(found, sys.stdout, indent=2)
print()
