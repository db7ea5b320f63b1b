#!/usr/bin/env python3
"""Detects the quadrics of a cloud made in numpy, and prints their dimensions and the best grasp.

    PYTHONPATH=build/python python3 examples/07_detect.py [CLOUD.ply|CLOUD.pcd]
"""
import sys

import numpy as np

import quadrille

if len(sys.argv) > 1:
    points, viewpoint = quadrille.read_cloud(sys.argv[1])
else:
    # A ball of 30 mm radius on a table 60 cm below the camera, as a depth image of 320 by 240 pixels.
    u, v = np.meshgrid(np.arange(320), np.arange(240))
    rays = np.stack([(u - 160) / 300, (v - 120) / 300, np.ones(u.shape)], axis=-1)
    table, centre, radius = 0.6, np.array([0.05, 0.02, 0.57]), 0.03
    a, b = (rays * rays).sum(-1), rays @ centre
    with np.errstate(invalid="ignore"):  # NaN where a ray misses the ball
        ball = (b - np.sqrt(b * b - a * (centre @ centre - radius**2))) / a
    points = rays * np.fmin(ball, table)[..., None]
    viewpoint = np.zeros(3)

found = quadrille.detect(points, viewpoint=viewpoint)
for detection in found:
    sizes = ", ".join(f"{name} {value:.4f} ± {detection.deviations[name]:.4f}"
                      for name, value in detection.dimensions.items())
    print(f"{detection.id}: {detection.type}, score {detection.score:.2f}, {sizes}")

plan = quadrille.plan(points, found, "franka", viewpoint=viewpoint, best=1)
for grasp in plan:
    print(f"grasp {grasp.target} at {grasp.X_CG[:3, 3].round(3)} from {grasp.X_CG[:3, 2].round(2)}, "
          f"opened to {grasp.preshape:.3f}")
if not plan.grasps:
    print("no grasp; refused:", plan.rejected)
