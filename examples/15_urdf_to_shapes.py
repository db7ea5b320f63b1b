#!/usr/bin/env python3
"""Writes the collision shapes of a robot's URDF as JSON for --robot and --obstacles, with all joints at zero.

    python3 examples/15_urdf_to_shapes.py ROBOT.urdf [FRAME] > robot.json

The shapes are in the frame of the link FRAME, by default of the root link; name the camera's link if the processes have
no poses of the camera. Boxes, cylinders and spheres are written; meshes are left out and named on standard error.
"""
import json
import math
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np


def numbers(text: str) -> np.ndarray:
    return np.array([float(word) for word in text.split()])


def pose_of(element: ElementTree.Element) -> np.ndarray:
    """The pose that the <origin> of a joint or a shape says: roll, pitch and yaw about fixed axes."""
    pose = np.eye(4)
    origin = element.find("origin")
    if origin is None:
        return pose
    (cr, cp, cy), (sr, sp, sy) = ([f(angle) for angle in numbers(origin.get("rpy", "0 0 0"))] for f in (math.cos, math.sin))
    pose[:3, :3] = [[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                    [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
                    [-sp, cp * sr, cp * cr]]
    pose[:3, 3] = numbers(origin.get("xyz", "0 0 0"))
    return pose


def quaternion_of(rotation: np.ndarray) -> list:
    """w, x, y, z: the eigenvector of the largest eigenvalue of a symmetric matrix (Bar-Itzhack 2000)."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation
    matrix = np.array([[xx + yy + zz, zy - yz, xz - zx, yx - xy],
                       [zy - yz, xx - yy - zz, xy + yx, xz + zx],
                       [xz - zx, xy + yx, yy - xx - zz, yz + zy],
                       [yx - xy, xz + zx, yz + zy, zz - xx - yy]])
    quaternion = np.linalg.eigh(matrix)[1][:, -1]
    return (quaternion if quaternion[0] >= 0 else -quaternion).tolist()


def link_poses(robot: ElementTree.Element, frame: str) -> dict:
    """The pose of each link in the frame of one of them."""
    joints = {joint.find("child").get("link"): joint for joint in robot.findall("joint")}

    def in_root(link: str) -> np.ndarray:
        if link not in joints:
            return np.eye(4)
        return in_root(joints[link].find("parent").get("link")) @ pose_of(joints[link])

    links = [link.get("name") for link in robot.findall("link")]
    if frame and frame not in links:
        raise SystemExit(f"there is no link '{frame}'; there are: {', '.join(links)}")
    to_frame = np.linalg.inv(in_root(frame)) if frame else np.eye(4)
    return {link: to_frame @ in_root(link) for link in links}


def shape_of(geometry: ElementTree.Element, pose: np.ndarray) -> dict:
    """The shape of a <geometry>; None for a mesh."""
    kind = geometry[0].tag
    if kind == "box":
        dimensions = numbers(geometry[0].get("size")).tolist()
    elif kind == "cylinder":
        dimensions = [float(geometry[0].get("radius")), float(geometry[0].get("length"))]
    elif kind == "sphere":
        dimensions = [float(geometry[0].get("radius"))]
    else:
        return None
    return {"kind": kind, "dimensions": dimensions,
            "pose": {"position": pose[:3, 3].tolist(), "quaternion": quaternion_of(pose[:3, :3])}}


def shapes_of(robot: ElementTree.Element, frame: str) -> list:
    poses = link_poses(robot, frame)
    shapes = []
    for link in robot.findall("link"):
        for collision in link.findall("collision"):
            geometry = collision.find("geometry")
            shape = shape_of(geometry, poses[link.get("name")] @ pose_of(collision))
            if shape:
                shapes.append(shape)
            else:
                print(f"left out: the {geometry[0].tag} of link '{link.get('name')}'", file=sys.stderr)
    return shapes


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: 15_urdf_to_shapes.py ROBOT.urdf [FRAME]")
    root = ElementTree.parse(sys.argv[1]).getroot()
    json.dump({"padding": 0.01, "shapes": shapes_of(root, sys.argv[2] if len(sys.argv) == 3 else "")}, sys.stdout, indent=1)
    print()
