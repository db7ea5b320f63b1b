#!/usr/bin/env python3
"""What quadrille view shows of a log whose camera moves: each cloud with what those before it showed, as
`quadrille plan --scene` finds it.

usage: memory_test.py BIN_FOLDER
"""

import json
import os
import struct
import subprocess
import sys
import tempfile
import urllib.request

from running_view import View

CLOUDS = 4
POSES = ("--pose-channel", "CAMERA_POSE")
UNKNOWN = ("--unknown", "obstacle")


def frame_of(view, number):
    with urllib.request.urlopen(f"{view.address}api/frames/{number}") as answer:
        pack = answer.read()
    assert pack[:4] == b"QVW1"
    return json.loads(pack[8:8 + struct.unpack("<I", pack[4:8])[0]])


def shown(frame):
    """What must be the same however a frame was reached."""
    return {key: frame[key] for key in ("objects", "camera", "grasps", "voxels", "notes", "rejected")}


def path_of(frame):
    """Number of positions of the camera's path."""
    return frame["camera"]["path"]["count"] // 3


def check(bin_folder, log):
    program = os.path.join(bin_folder, "quadrille")
    planned = subprocess.run([program, "plan", log, "--scene", *POSES, "--gripper", "franka", *UNKNOWN,
                              "--json", "-"], check=True, capture_output=True, text=True).stdout
    expected = [json.loads(line) for line in planned.splitlines()]
    with View(bin_folder, log, *POSES, *UNKNOWN) as view:
        forward = [frame_of(view, number) for number in range(CLOUDS)]
    with View(bin_folder, log, *POSES, *UNKNOWN) as view:
        backward = [frame_of(view, number) for number in reversed(range(CLOUDS))][::-1]
    with View(bin_folder, log, *UNKNOWN) as view:
        alone = frame_of(view, CLOUDS - 1)
    for number, (frame, plan) in enumerate(zip(forward, expected)):
        assert shown(frame) == shown(backward[number]), "a frame does not depend on how it was reached"
        assert frame["frame"] == "world", frame["frame"]
        assert frame["camera"]["pose"] is not None
        assert path_of(frame) == number + 1, "the path has one position for each cloud so far"
        quadrics = [o for o in frame["objects"] if o["kind"] == "quadric"]
        assert [o["pose"] for o in quadrics] == [d["pose"] for d in plan["detections"]], "the surfaces of a plan --scene"
        assert [g["X_CG"] for g in frame["grasps"][:5]] == [g["X_CG"] for g in plan["grasps"][:5]], "and its grasps"
    last = forward[-1]
    assert not forward[0]["notes"] and "earlier clouds showed" in last["notes"][0], last["notes"]
    assert any(o.get("views", 1) > 1 for o in last["objects"]), "several views show a body"
    assert last["rejected"] != alone["rejected"] and alone["camera"]["pose"] is None
    unknown = lambda frame: sum(r["count"] for r in frame["rejected"] if r["reason"] == "unknown")
    assert unknown(last) < unknown(alone), "less space is unknown than one cloud leaves unknown"


def main():
    program = os.path.join(sys.argv[1], "quadrille")
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, "path.lcm")
        subprocess.run([program, "scene", log, "--family", "tabletop", "--seed", "4", "--rate", "1", "--path", str(CLOUDS)],
                       check=True, stdout=subprocess.DEVNULL)
        check(sys.argv[1], log)
    print("memory_test: all is well")


if __name__ == "__main__":
    main()
