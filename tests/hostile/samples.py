"""Small files of all kinds that the programs read, each with the command lines that read it."""

import gzip
import io
import struct
import subprocess

import numpy


def view():
    """A ball before a wall as a camera of 64 x 48 pixels sees them, (48, 64, 3) in metres."""
    v, u = numpy.mgrid[0:48, 0:64]
    ray = numpy.dstack([(u - 31.5) / 60, (v - 23.5) / 60, numpy.ones_like(u, float)])
    a, b = (ray**2).sum(2), 0.5 * ray[..., 2]
    inside = b * b - a * (0.25 - 0.08**2)
    depth = numpy.where(inside > 0, (b - numpy.sqrt(numpy.maximum(inside, 0))) / a, 0.8)
    return (ray * depth[..., None]).astype(numpy.float32)


def pcd(points, data, body):
    return (f"# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {len(points)}\nHEIGHT 1\n"
            f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(points)}\nDATA {data}\n").encode() + body


def ply(points, form, body, more=""):
    return (f"ply\nformat {form} 1.0\ncomment viewpoint 0 0 0\nelement vertex {len(points)}\nproperty float x\n"
            f"property float y\nproperty float z\n{more}end_header\n").encode() + body


def saved(save, *arrays, **named):
    out = io.BytesIO()
    save(out, *arrays, **named)
    return out.getvalue()


def clouds(tests):
    grid = view()
    points = grid.reshape(-1, 3)
    text = "".join("%g %g %g\n" % tuple(p) for p in points).encode()
    records = numpy.zeros(len(points), [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("rgb", "<u4")])
    for axis, name in enumerate("xyz"):
        records[name] = points[:, axis]
    faces = struct.pack("<Biii", 3, 0, 1, 2) * 5
    colour = "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    coloured = b"".join(p.tobytes() + b"\x10\x80\xff" for p in points)
    made = {
        "ascii.pcd": pcd(points, "ascii", text),
        "binary.pcd": pcd(points, "binary", points.tobytes()),
        "ascii.ply": ply(points, "ascii", text),
        "little.ply": ply(points, "binary_little_endian", points.tobytes()),
        "big.ply": ply(points, "binary_big_endian", points.astype(">f4").tobytes()),
        "faces.ply": ply(points, "binary_little_endian", points.tobytes() + faces,
                         "element face 5\nproperty list uchar int vertex_indices\n"),
        "coloured.ply": ply(points, "binary_little_endian", coloured, colour),
        "points.xyz": text,
        "columns.npy": saved(numpy.save, points),
        "doubles.npy": saved(numpy.save, points.astype(float)),
        "organised.npy": saved(numpy.save, grid),
        "records.npy": saved(numpy.save, records),
        "one.npz": saved(numpy.savez, points),
        "viewpoint.npz": saved(numpy.savez_compressed, points=points, viewpoint=numpy.zeros(3)),
        "packed.ply.gz": gzip.compress(ply(points, "ascii", text), mtime=0),
        "packed.pcd.gz": gzip.compress(pcd(points, "binary", points.tobytes()), mtime=0),
    }
    for name in ("mug.pcd", "boxes.pcd"):
        made[name] = (tests / "data" / name).read_bytes()
    for kind in ("ply", "pcd", "np"):
        for path in sorted((tests / "corpus" / kind).iterdir())[:12]:
            suffix = kind if kind != "np" else "npz" if path.read_bytes()[:2] == b"PK" else "npy"
            made[f"corpus_{path.name[:6]}.{suffix}"] = path.read_bytes()
    return made


def logs(bin_folder, folder, cloud):
    """Logs of clouds of each type, and one of what both processes answer."""
    made = {}

    def run(*line):
        subprocess.run([str(word) for word in line], check=True, capture_output=True)

    for form in ("drake", "pointcloud2", "pointcloud"):
        path = folder / f"{form}.lcm"
        run(bin_folder / "quadrille", "log", path, cloud, cloud, "--as", form)
        made[path.name] = path.read_bytes()
    found, planned = folder / "found.lcm", folder / "planned.lcm"
    run(bin_folder / "quadrille-detector", "--in-log", folder / "drake.lcm", "--out-log", found, "--copy-input")
    run(bin_folder / "quadrille-grasp-planner", "--gripper", "franka", "--in-log", found, "--out-log", planned, "--copy-input")
    made[found.name], made[planned.name] = found.read_bytes(), planned.read_bytes()
    return made


def settings(bin_folder):
    made = {"all.toml": subprocess.run([bin_folder / "quadrille", "config"], check=True, capture_output=True).stdout,
            "few.toml": b"only = [\"sphere\", \"cylinder\"]\n[planes]\nsigmas = 4.0\n[planner]\nmax_grasps = 5\n"}
    return made


def lines_of(name, bin_folder, folder, cloud):
    """The command lines that read a file of that name, which stands in the folder."""
    quadrille, path, out = bin_folder / "quadrille", folder / name, folder / "out"
    if name.endswith(".lcm"):
        return [[quadrille, "detect", path], [quadrille, "show", path],
                [bin_folder / "quadrille-detector", "--in-log", path, "--out-log", out],
                [bin_folder / "quadrille-grasp-planner", "--gripper", "franka", "--in-log", path, "--out-log", out]]
    if name.startswith("gripper_"):
        return [[quadrille, "plan", cloud, "--gripper", path]]
    if name.endswith(".toml"):
        return [[quadrille, "config", "--config", path], [quadrille, "detect", cloud, "--config", path]]
    return [[quadrille, "detect", path], [quadrille, "detect", path, "--json", "-"],
            [quadrille, "plan", path, "--gripper", "franka"]]


def all_samples(bin_folder, tests, folder):
    """Name and content of each sample, and a cloud to use grippers and settings on."""
    made = clouds(tests)
    cloud = folder / "cloud.ply"
    cloud.write_bytes(made["little.ply"])
    made.update(logs(bin_folder, folder, cloud))
    made.update(settings(bin_folder))
    for path in sorted((tests.parent / "tools" / "grippers").glob("*.toml")):
        made[f"gripper_{path.name}"] = path.read_bytes()
    return made, cloud
