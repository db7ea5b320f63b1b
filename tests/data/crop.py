#!/usr/bin/env python3
"""Made the scans of this folder: crops whole scans to a table with its objects, compresses them.

usage: crop.py FOLDER    FOLDER holds the whole scans (.ply), their labels (.labels.u8, a byte a
                         point) and manifest.json. Needs liblzf, as quadrille does.

A window of directions and a largest depth say what stays; the points keep their order, row by row,
and their bits. Colours are dropped.
"""
import array
import ctypes
import json
import pathlib
import struct
import sys

# Whole scan: name here, min and max of x/z, min and max of y/z, max depth z [m].
WINDOWS = {
    "d08_mug_stereo": ("mug", (-0.06, 0.22), (-0.03, 0.22), 1.1),
    "d09_bleach_bottle": ("bottle", (-0.24, 0.45), (-0.35, 0.16), 1.0),
    "d10_negative_boxes": ("boxes", (-0.38, 0.42), (-0.12, 0.33), 1.0),
}
# What a whole scan's own files say and a crop does not have.
DROPPED = ("labels", "has_rgb", "bbox_min", "bbox_max")

HEADER = """# .PCD v0.7 - Point Cloud Data file format
VERSION 0.7
FIELDS x y z
SIZE 4 4 4
TYPE F F F
COUNT 1 1 1
WIDTH {0}
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS {0}
DATA binary_compressed
"""


def read_points(path):
    """The points (x, y, z) of a little-endian .ply with float x y z and uchar colours."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    return [point[:3] for point in struct.iter_unpack("<fffBBB", data[end:])]


def compressed(points):
    """The points as a .pcd: all x, then all y, then all z, packed by LZF."""
    raw = b"".join(array.array("f", column).tobytes() for column in zip(*points))
    out = ctypes.create_string_buffer(len(raw))
    lzf = ctypes.CDLL("liblzf.so.1")
    size = lzf.lzf_compress(raw, len(raw), out, len(out))
    if size == 0:
        sys.exit("crop.py: the points do not become smaller by LZF")
    sizes = struct.pack("<II", size, len(raw))
    return HEADER.format(len(points)).encode() + sizes + out.raw[:size]


def crop(folder, scene, target):
    """Writes the crop of a scene; gives its entry of the manifest."""
    name, (min_u, max_u), (min_v, max_v), max_z = WINDOWS[scene["name"]]
    points = read_points(folder / scene["file"])
    labels = (folder / scene["labels"]).read_bytes()
    kept = [
        i
        for i, (x, y, z) in enumerate(points)
        if min_u <= x / z <= max_u and min_v <= y / z <= max_v and z <= max_z
    ]
    (target / f"{name}.pcd").write_bytes(compressed([points[i] for i in kept]))
    entry = {key: value for key, value in scene.items() if key not in DROPPED}
    entry.update(name=name, file=f"{name}.pcd", n_points=len(kept))
    kept_labels = [labels[i] for i in kept]
    for annotated in entry["objects"]:
        for key in ("bbox_min", "bbox_max", "n_crop"):
            annotated.pop(key, None)
        annotated["n_labelled"] = kept_labels.count(annotated["label"])
        annotated["n_inliers"] = min(annotated["n_inliers"], annotated["n_labelled"])
    return entry


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder, target = pathlib.Path(sys.argv[1]), pathlib.Path(__file__).parent
    scenes = json.loads((folder / "manifest.json").read_text())["scenes"]
    entries = [crop(folder, scene, target) for scene in scenes if scene["name"] in WINDOWS]
    (target / "manifest.json").write_text(json.dumps({"scenes": entries}, indent=1) + "\n")


if __name__ == "__main__":
    main()
