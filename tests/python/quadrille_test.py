#!/usr/bin/env python3
"""The Python package against numpy's own numbers and against the programs' JSON.

    quadrille_test.py PROGRAM SCAN.pcd   with the package in PYTHONPATH
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import quadrille

PROGRAM, SCAN = sys.argv[1], sys.argv[2]


def ball(radius=0.05, centre=(0.02, -0.01, 0.6), count=4000):
    """What a sensor at the origin sees of a ball, without noise."""
    rng = np.random.default_rng(1)
    n = rng.normal(size=(count, 3))
    n /= np.linalg.norm(n, axis=1)[:, None]
    p = np.asarray(centre) + radius * n
    return p[(n * p).sum(1) < 0]


def organised_ball(width, height, radius=0.08):
    """A ball before a wall, noise of half a millimetre, (H, W, 3) of float32."""
    u, v = np.meshgrid(np.arange(width), np.arange(height))
    rays = np.stack([(u - width / 2) / width, (v - height / 2) / width, np.ones(u.shape)], -1)
    a, b, c = (rays * rays).sum(-1), 0.6 * rays[..., 2], 0.36 - radius**2
    with np.errstate(invalid="ignore"):
        z = np.fmin((b - np.sqrt(b * b - a * c)) / a, 0.9)
    z += np.random.default_rng(2).normal(scale=5e-4, size=z.shape)
    return (rays * z[..., None]).astype(np.float32)


def vessel(radii, height=0.09):
    """Upright walls around the z axis on a table, seen from above at a slant; noise of half a millimetre.

    The points are in the frame of the camera, whose x axis is that of the world.
    """
    width = 640
    u, v = np.meshgrid(np.arange(width), np.arange(480))
    rays = np.stack([(u - 320) / 600, (v - 240) / 600, np.ones(u.shape)], -1)
    eye = np.array((0.0, -0.45, 0.5))
    forward = -eye / np.linalg.norm(eye)
    R_WC = np.stack([(1.0, 0.0, 0.0), np.cross(forward, (1.0, 0.0, 0.0)), forward], -1)
    d = rays @ R_WC.T
    depth = -eye[2] / d[..., 2]  # where the table is
    a, b = d[..., 0]**2 + d[..., 1]**2, d[..., :2] @ eye[:2]
    for radius in radii:
        with np.errstate(invalid="ignore"):
            root = np.sqrt(b * b - a * (eye[:2] @ eye[:2] - radius**2))
        for z in ((-b - root) / a, (-b + root) / a):
            up = eye[2] + z * d[..., 2]
            depth = np.where((up >= 0) & (up <= height) & (z < depth), z, depth)
    depth += np.random.default_rng(3).normal(scale=5e-4, size=depth.shape)
    return (rays * depth[..., None]).astype(np.float32)


def peak_growth(work):
    """By how much the largest resident memory of this process exceeds that before the work [B]."""

    def resident(field):
        with open("/proc/self/status", encoding="ascii") as file:
            return 1024 * next(int(line.split()[1]) for line in file if line.startswith(field))

    with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
        file.write("5")  # the peak begins anew
    before = resident("VmRSS")
    work()
    return resident("VmHWM") - before


def run(*arguments, stdin=None):
    done = subprocess.run([PROGRAM, *arguments, "--json", "-"], stdin=stdin, stdout=subprocess.PIPE,
                          check=True)
    return json.loads(done.stdout)


class Detect(unittest.TestCase):
    def test_a_ball_has_its_true_centre_and_radius(self):
        found = quadrille.detect(ball())
        self.assertEqual([d.type for d in found], ["sphere"])
        sphere = found.detections[0]
        self.assertAlmostEqual(sphere.dimensions["radius"], 0.05, delta=4e-4)
        np.testing.assert_allclose(sphere.X_CQ[:3, 3], (0.02, -0.01, 0.6), atol=6e-4)
        self.assertEqual(sphere.Q.shape, (4, 4))
        np.testing.assert_allclose(sphere.Q, sphere.Q.T, atol=1e-12)
        p = np.append(ball()[0], 1.0)
        self.assertLess(abs(p @ sphere.Q @ p), 1e-4)
        # The covariance of a unit vector has none along it.
        self.assertEqual(sphere.covariance.shape, (10, 10))
        self.assertLess(abs(sphere.q @ sphere.covariance @ sphere.q), 1e-9)
        self.assertGreater(np.trace(sphere.covariance), 0)
        self.assertEqual(sphere.open_directions.shape, (10, 0))
        self.assertLess(np.abs(sphere.distance(ball())).max(), 8e-4)

    def test_a_vessel_tells_how_thick_its_wall_is(self):
        thickness = 0.008
        [mug] = [b for b in quadrille.detect(vessel([0.05, 0.05 - thickness])).bodies if b.kind == "revolution"]
        self.assertAlmostEqual(mug.wall, thickness, delta=2.5 * mug.wall_deviation)
        self.assertLess(mug.wall_deviation, 0.5 * thickness)
        [shell] = quadrille.detect(vessel([0.05])).bodies
        self.assertIsNone(shell.wall)
        self.assertIsNone(shell.wall_deviation)

    def test_layouts_and_types_of_arrays_give_the_same(self):
        p = ball().astype(np.float32)
        q = quadrille.detect(p).detections[0].Q
        wide = np.zeros((len(p), 5), np.float32)
        wide[:, 1:4] = p
        for same in (p.astype(np.float64), np.asfortranarray(p), wide[:, 1:4], p.tolist()):
            np.testing.assert_array_equal(quadrille.detect(same).detections[0].Q, q)

    def test_views_of_records_that_lie_askew_are_converted(self):
        p = ball().astype(np.float32)
        records = np.zeros(len(p), [("tag", "u1"), ("xyz", "<f4", 3)])
        records["xyz"] = p
        self.assertFalse(records["xyz"].flags.aligned)
        np.testing.assert_array_equal(quadrille.detect(records["xyz"]).detections[0].Q,
                                      quadrille.detect(p).detections[0].Q)

    def test_float32_is_not_copied(self):
        """240 MB of points that are missing, so that the detector needs nothing for itself."""
        points = np.full((20_000_000, 3), np.nan, np.float32)
        self.assertLess(peak_growth(lambda: quadrille.detect(points)), points.nbytes / 20)
        # What shows that a copy would be noticed.
        self.assertGreater(peak_growth(lambda: quadrille.detect(points[::-1])), points.nbytes / 2)

    def test_a_call_takes_as_long_as_it_does_in_cpp(self):
        points = organised_ball(640, 480)
        shares = []
        for _ in range(15):
            start = time.perf_counter()
            found = quadrille.detect(points)
            shares.append(1e3 * (time.perf_counter() - start) / found.total_ms - 1)
        self.assertEqual(sorted(d.type for d in found), ["plane", "sphere"])
        self.assertLess(np.median(shares), 0.03)

    def test_organised_clouds_may_have_gaps(self):
        u, v = np.meshgrid(np.arange(320), np.arange(240))
        rays = np.stack([(u - 160) / 300.0, (v - 120) / 300.0, np.ones(u.shape)], -1)
        d = rays / np.linalg.norm(rays, axis=2)[..., None]
        c, r = np.array([0.0, 0.0, 0.6]), 0.08
        b = d @ c
        with np.errstate(invalid="ignore"):
            t = b - np.sqrt(b * b - (c @ c - r * r))
        found = quadrille.detect(d * t[..., None])
        self.assertEqual(found.points_finite, int(np.isfinite(t).sum()))
        self.assertEqual([x.type for x in found], ["sphere"])
        self.assertAlmostEqual(found.detections[0].dimensions["radius"], r, delta=5e-4)

    def test_codes_for_missing_points_count_as_gaps(self):
        holed = organised_ball(320, 240)
        holed[40:44, 50:90] = np.nan
        truth = quadrille.detect(holed)
        self.assertEqual(truth.warnings, [])
        for code in (1e30, np.finfo(np.float32).max, 1e22, -1e23, np.inf):
            coded = holed.copy()
            coded[40:44, 50:90] = code
            found = quadrille.detect(coded)
            self.assertEqual(found.points_finite, truth.points_finite)
            self.assertEqual([d.score for d in found], [d.score for d in truth])
            for mine, other in zip(found, truth):
                np.testing.assert_array_equal(mine.X_CQ, other.X_CQ)
            told = [w for w in found.warnings if w.startswith("160 points farther than 1 km")]
            self.assertEqual(len(told), int(np.isfinite(code)))

    def test_the_program_finds_the_same_in_a_real_scan(self):
        points, viewpoint = quadrille.read_cloud(SCAN)
        found = quadrille.detect(points, viewpoint=viewpoint, config={"seed": 3, "threads": 2})
        theirs = run("detect", "--seed", "3", SCAN)
        self.assertGreater(len(found), 0)
        self.assertEqual([d.type for d in found], [d["type"] for d in theirs["detections"]])
        for mine, other in zip(found, theirs["detections"]):
            self.assertEqual(mine.score, other["score"])
            self.assertEqual(mine.inliers, other["inliers"])
            np.testing.assert_allclose(mine.X_CQ[:3, 3], other["pose"]["position"], rtol=1e-12)

    def test_other_threads_run_meanwhile(self):
        points, _ = quadrille.read_cloud(SCAN)
        done, counted = threading.Event(), []

        def count():
            n = 0
            while not done.wait(0.0005):
                n += 1
            counted.append(n)

        thread = threading.Thread(target=count)
        thread.start()
        total = sum(quadrille.detect(points).total_ms for _ in range(5))
        done.set()
        thread.join()
        self.assertGreater(counted[0], total / 50.0)

    def test_what_is_wrong_is_told_in_one_line(self):
        for wrong, part in ((lambda: quadrille.detect(np.zeros((3, 4))), "(3, 4)"),
                            (lambda: quadrille.detect(np.zeros(3)), "(3,)"),
                            (lambda: quadrille.detect(ball(), config={"sed": 1}), "sed"),
                            (lambda: quadrille.detect(ball(), config={"threads": 0}), "threads"),
                            (lambda: quadrille.plan(ball(), None, "franka"), "result"),
                            (lambda: quadrille.Gripper("franco"), "robotiq")):
            with self.assertRaises((ValueError, TypeError)) as caught:
                wrong()
            self.assertIn(part, str(caught.exception))
        self.assertEqual(len(quadrille.detect(np.zeros((0, 3)))), 0)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_what_numpy_saves_is_read(self):
        p = ball().astype(np.float32)
        p = p[: len(p) // 10 * 10]
        records = np.zeros(len(p), [("ring", "u1"), ("x", "f8"), ("y", "f8"), ("z", "f8")])
        for axis in range(3):
            records["xyz"[axis]] = p[:, axis]
        image = p.reshape(10, -1, 3)
        for n, (saved, expected) in enumerate((
                (p, p), (p.astype(np.float64), p), (p.astype(">f8"), p), (np.asfortranarray(p), p),
                (image, image), (np.asfortranarray(image), image), (records, p),
                (records.reshape(10, -1), image), (np.zeros((0, 3)), np.zeros((0, 3))))):
            np.save(self.folder / f"{n}.npy", saved)
            points, viewpoint = quadrille.read_cloud(self.folder / f"{n}.npy")
            np.testing.assert_array_equal(points, expected)
            np.testing.assert_array_equal(viewpoint, np.zeros(3))
        found = run("detect", str(self.folder / "3.npy"))["detections"]
        self.assertEqual([d["type"] for d in found], ["sphere"])
        with open(self.folder / "0.npy", "rb") as file:
            piped = run("detect", "-", stdin=file)
        self.assertEqual(piped["detections"], found)

    def test_millimetres_are_converted(self):
        p = ball()
        path = self.folder / "mm.npz"
        np.savez(path, points=1000 * p, viewpoint=np.array([100.0, 0.0, -200.0]))
        points, viewpoint = quadrille.read_cloud(path, unit="mm")
        np.testing.assert_array_equal(points, p.astype(np.float32))
        np.testing.assert_allclose(viewpoint, (0.1, 0.0, -0.2), rtol=1e-12)
        with self.assertRaisesRegex(ValueError, "'m' or 'mm'"):
            quadrille.read_cloud(path, unit="inch")
        told = quadrille.detect(quadrille.read_cloud(path)[0]).warnings
        self.assertIn("millimetres (--unit mm)", " ".join(told))

    def test_the_cloud_among_several_arrays_is_the_one_called_so(self):
        p, seen_from = ball().astype(np.float32), np.array([0.1, 0.0, -0.2])
        for save in (np.savez, np.savez_compressed):
            path = self.folder / "a.npz"
            save(path, points=p, colours=np.zeros(3), viewpoint=seen_from)
            points, viewpoint = quadrille.read_cloud(path)
            np.testing.assert_array_equal(points, p)
            np.testing.assert_array_equal(viewpoint, seen_from)
            save(path, p)
            np.testing.assert_array_equal(quadrille.read_cloud(path)[0], p)
        np.savez(path, a=p, b=p)
        with self.assertRaisesRegex(quadrille.FileError, "a.npy, b.npy; call the cloud's array 'points'"):
            quadrille.read_cloud(path)
        cut = path.read_bytes()[: 3000]
        path.write_bytes(cut)
        with self.assertRaisesRegex(ValueError, "damaged"):
            quadrille.read_cloud(path)


class Plan(unittest.TestCase):
    def test_grasps_are_those_of_the_program(self):
        points, viewpoint = quadrille.read_cloud(SCAN)
        found = quadrille.detect(points, viewpoint=viewpoint)
        plan = quadrille.plan(points, found, "franka", viewpoint=viewpoint)
        theirs = run("plan", "--gripper", "franka", SCAN)["grasps"]
        self.assertGreater(len(plan), 0)
        self.assertEqual([g.target for g in plan], [g["target"] for g in theirs])
        for mine, other in zip(plan, theirs):
            np.testing.assert_allclose(mine.X_CG[:3, 3], other["X_CG"]["position"], atol=1e-6)
            np.testing.assert_allclose(mine.contacts, other["contacts"], atol=1e-6)
            self.assertAlmostEqual(mine.width, np.linalg.norm(mine.contacts[0] - mine.contacts[1]),
                                   delta=0.01)
            back = mine.X_CG[:3, 3] - mine.approach * mine.X_CG[:3, 2]
            np.testing.assert_allclose(mine.pregrasp[:3, 3], back, atol=1e-12)

    def test_a_scene_answers_queries(self):
        points, viewpoint = quadrille.read_cloud(SCAN)
        found = quadrille.detect(points, viewpoint=viewpoint)
        scene = quadrille.GraspScene(points, found, quadrille.Gripper("franka"),
                                     viewpoint=viewpoint)
        target = scene.plan().grasps[0].target
        self.assertEqual({g.target for g in scene.plan(targets=[target])}, {target})
        self.assertEqual(len(scene.plan(best=1)), 1)
        around = [found.detections[i].X_CQ[:3, 3] + side for i in range(len(found)) for side in
                  (-0.01, 0.01) if found.detections[i].id == target]
        self.assertEqual({g.target for g in scene.plan(roi=around)}, {target})
        none = scene.plan(targets=[9999])
        self.assertEqual(len(none), 0)
        self.assertIn("9999", " ".join(none.warnings))

    def test_an_arm_says_what_it_reaches_and_accepts(self):
        points, viewpoint = quadrille.read_cloud(SCAN)
        found = quadrille.detect(points, viewpoint=viewpoint)
        scene = quadrille.GraspScene(points, found, "franka", viewpoint=viewpoint)
        plain = scene.plan(best=1000)
        first = plain.grasps[0]
        most = [sum(g.target == first.target for g in scene.plan(per_target=n, best=1000))
                for n in (1, 3, 1000)]
        self.assertEqual(most[:2], [1, 3])
        self.assertGreater(most[2], 3)
        base = first.X_CG[:3, 3]
        for grasp in scene.plan(reach=(base, 0.0, 0.06)):
            for pose in (grasp.X_CG, grasp.pregrasp):
                self.assertLessEqual(np.linalg.norm(pose[:3, 3] - base), 0.06 + 1e-9)
        self.assertGreater(scene.plan(reach=(base, 0.0, 0.01)).rejected["reach"], 0)
        for grasp in scene.plan(min_score=first.score):
            self.assertGreaterEqual(grasp.score, first.score)
        asked = []
        same = scene.plan(best=1000, accept=lambda grasp: asked.append(grasp.score) or True)
        # Of grasps that are alike on two parts of a body, only the better one is given.
        self.assertLessEqual({g.score for g in plain}, set(asked))
        self.assertEqual([g.score for g in same], [g.score for g in plain])
        none = scene.plan(accept=lambda grasp: False)

        def fail(grasp):
            raise TypeError("incompatible units of mine")

        # What the caller's own function raises stays as it is, and wrong types are one line.
        with self.assertRaisesRegex(TypeError, "^incompatible units of mine$"):
            scene.plan(accept=fail)
        with self.assertRaisesRegex(TypeError, r"plan\(\): .*[^:]$"):
            scene.plan(accept=3)
        self.assertEqual(len(none), 0)
        self.assertGreater(none.rejected["caller"], 0)
        for outcome in none.targets:
            self.assertEqual(outcome.grasps, 0)
            self.assertEqual(sum(outcome.rejected.values()) > 0, outcome.furthest is not None)
        self.assertIn(first.target, [t.target for t in none.targets if t.furthest == "caller"])
        self.assertIn((first.target, True), [(t.target, t.grasps > 0) for t in plain.targets])
        self.assertEqual(scene.plan(min_score=1.0).remedies, [])
        advised = scene.plan(min_score=1.0, advise=True)
        remedies = advised.remedies
        own = [r for r in remedies if r.target == first.target and r.change.startswith("--min-score")]
        self.assertEqual(len(own), 1)
        followed = scene.plan(targets=[first.target], min_score=float(own[0].change.split()[1]),
                              best=1000)
        self.assertEqual((len(followed), followed[0].score), (own[0].grasps, own[0].score))
        with self.assertRaisesRegex(ZeroDivisionError, "division"):
            scene.plan(accept=lambda grasp: 1 / 0 > 0)

    def test_a_plan_advises_views(self):
        points, viewpoint = quadrille.read_cloud(SCAN)
        found = quadrille.detect(points, viewpoint=viewpoint)
        cautious = {"planner.unknown": "obstacle", "planner.clear_above": False}
        scene = quadrille.GraspScene(points, found, "franka", viewpoint=viewpoint, config=cautious)
        self.assertEqual(scene.plan().looks, [])
        advised = scene.plan(advise=True)
        bodies = {body.id: body for body in found.bodies}
        self.assertGreater(len(advised.looks), 0)
        for look in advised.looks:
            # The view helps each of the bodies with a chance of a third at least, but that is never sure.
            self.assertGreaterEqual(look.gain, len(look.bodies) / 3)
            self.assertLess(look.gain, len(look.bodies))
            np.testing.assert_allclose(look.X_CK[:3, :3] @ look.X_CK[:3, :3].T, np.eye(3), atol=1e-9)
            # The camera sees the bodies that it helps.
            for p in [(np.linalg.inv(look.X_CK) @ bodies[id].X_CB[:, 3])[:3] for id in look.bodies]:
                self.assertGreater(p[2], 0.3)
                self.assertLess(np.linalg.norm(p[:2]), p[2])

    def test_hands_have_the_poses_of_other_software(self):
        points, viewpoint = quadrille.read_cloud(SCAN)
        found = quadrille.detect(points, viewpoint=viewpoint)
        hand = quadrille.Gripper("franka")
        grasp = quadrille.plan(points, found, hand, viewpoint=viewpoint).grasps[0]
        # MoveIt's hand link has the same axes, and its origin lies tcp behind the pads.
        self.assertEqual(quadrille.conventions(), ["drake", "moveit", "gpd", "graspnet"])
        moveit = grasp.hand_pose(hand, "moveit")
        np.testing.assert_allclose(moveit[:3, :3], grasp.X_CG[:3, :3], atol=1e-12)
        np.testing.assert_allclose(grasp.X_CG[:3, 3] - moveit[:3, 3], hand.tcp * moveit[:3, 2],
                                   atol=1e-12)


def shifted(x, y, z):
    """The pose of what is not turned."""
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


class Known(unittest.TestCase):
    """What is known of a scene besides one cloud."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.points, cls.viewpoint = quadrille.read_cloud(SCAN)
        cls.found = quadrille.detect(cls.points, viewpoint=cls.viewpoint)
        cls.plain = cls.plan()
        cls.at = cls.plain.grasps[0].X_CG[:3, 3]

    @classmethod
    def plan(cls, **known):
        return quadrille.plan(cls.points, cls.found, "franka", viewpoint=cls.viewpoint, **known)

    def write_shapes(self, name, shapes, **others):
        """As a file that the programs read; its path."""
        path = self.folder / name
        path.write_text(json.dumps({"shapes": [
            {"kind": s.kind, "dimensions": s.dimensions,
             "pose": {"position": s.pose[:3, 3].tolist(), "quaternion": [1, 0, 0, 0]}} for s in shapes], **others}))
        return str(path)

    def assert_same(self, plan, theirs):
        self.assertEqual([g.target for g in plan], [g["target"] for g in theirs["grasps"]])
        for mine, other in zip(plan, theirs["grasps"]):
            np.testing.assert_allclose(mine.X_CG[:3, 3], other["X_CG"]["position"], atol=1e-6)

    def test_shapes_are_checked(self):
        box = quadrille.Shape("box", (0.1, 0.2, 0.3), shifted(1, 2, 3))
        self.assertEqual((box.kind, box.dimensions, box.faces), ("box", [0.1, 0.2, 0.3], []))
        np.testing.assert_array_equal(box.pose, shifted(1, 2, 3))
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
        tetrahedron = quadrille.Shape("convex", vertices=corners, faces=sides)
        np.testing.assert_array_equal(tetrahedron.vertices, corners)
        self.assertEqual(tetrahedron.faces, sides)
        for wrong, part in ((lambda: quadrille.Shape("ball", [0.1]), "capsule"),
                            (lambda: quadrille.Shape("box", [0.1]), "3 sizes"),
                            (lambda: quadrille.Shape("sphere", [-0.1]), "more than 0"),
                            (lambda: quadrille.Shape("sphere", [0.1], 2 * np.eye(4)), "pose"),
                            (lambda: quadrille.Shape("convex", vertices=corners, faces=[[0, 1, 7]] * 4), "vertex"),
                            (lambda: quadrille.Robot([box], padding=-1), "padding"),
                            (lambda: self.plan(support=(0, 0, 0, 1)), "normal"),
                            (lambda: self.plan(octomap=b"no map"), "octomap"),
                            (lambda: quadrille.read_robot(SCAN), "shapes")):
            with self.assertRaises(ValueError) as caught:
                wrong()
            self.assertIn(part, str(caught.exception))

    def test_points_on_the_robot_are_dropped(self):
        sphere = quadrille.Shape("sphere", [0.05], shifted(0.02, -0.01, 0.6))
        self.assertEqual(len(quadrille.detect(ball(), robot=[sphere])), 0)
        wall = organised_ball(320, 240)
        robot = quadrille.Robot([quadrille.Shape("sphere", [0.08], shifted(0, 0, 0.6))], padding=0.01)
        left = robot.taken_from(wall)
        near = np.linalg.norm(wall - (0, 0, 0.6), axis=-1) <= 0.09
        np.testing.assert_array_equal(np.isnan(left).all(-1), near)
        np.testing.assert_array_equal(left[~near], wall[~near])
        self.assertEqual(sorted(d.type for d in quadrille.detect(wall)), ["plane", "sphere"])
        path = self.write_shapes("robot.json", robot.shapes, padding=robot.padding)
        read = quadrille.read_robot(path)
        self.assertEqual((read.padding, [s.kind for s in read.shapes]), (0.01, ["sphere"]))
        for same in (robot, robot.shapes, path, pathlib.Path(path)):
            self.assertEqual([d.type for d in quadrille.detect(wall, robot=same)], ["plane"])

    def test_plans_with_a_robot_are_those_of_the_program(self):
        shapes = [quadrille.Shape("box", (0.3, 0.3, 0.05), shifted(*(self.at + (0.0, 0.0, -0.1))))]
        path = self.write_shapes("arm.json", shapes)
        found = quadrille.detect(self.points, viewpoint=self.viewpoint, robot=shapes)
        plan = quadrille.plan(self.points, found, "franka", viewpoint=self.viewpoint, robot=path)
        self.assert_same(plan, run("plan", "--gripper", "franka", "--robot", path, SCAN))

    def test_the_hand_keeps_off_obstacles(self):
        shelf = [quadrille.Shape("sphere", [0.05], shifted(*self.at))]
        path = self.write_shapes("shelf.json", shelf)
        plan = self.plan(obstacles=shelf)
        for grasp in plan:
            self.assertGreater(np.linalg.norm(grasp.X_CG[:3, 3] - self.at), 0.05)
        self.assertNotEqual([g.score for g in plan], [g.score for g in self.plain])
        self.assertEqual([g.score for g in self.plan(obstacles=path)], [g.score for g in plan])
        self.assert_same(plan, run("plan", "--gripper", "franka", "--obstacles", path, SCAN))

    def test_what_is_fixed_to_the_hand_touches_nothing(self):
        bar = [quadrille.Shape("box", (0.02, 0.02, 0.3), shifted(0.1, 0.0, 0.05))]
        plan = self.plan(attached=bar)
        self.assertLess(len(plan), len(self.plain))
        path = self.write_shapes("bar.json", bar)
        theirs = run("plan", "--gripper", "franka", "--attached", path, SCAN)
        self.assertEqual(len(theirs["query"]["attached"]), 1)
        self.assert_same(plan, theirs)

    def test_maps_and_supports_are_kept_off(self):
        path = self.folder / "space.bt"
        theirs = run("plan", "--gripper", "franka", "--map", str(path), SCAN)
        self.assert_same(self.plain, theirs)
        plan = self.plan(octomap=path)
        self.assertGreater(len(plan), 0)
        for same in (str(path), path.read_bytes(), quadrille.read_octomap(path)):
            self.assertEqual([g.score for g in self.plan(octomap=same)], [g.score for g in plan])
        self.assert_same(plan, run("plan", "--gripper", "franka", "--octomap", str(path), SCAN))
        table = next(d for d in self.found if d.type == "plane")
        normal = table.X_CQ[:3, 2]
        height = normal @ table.X_CQ[:3, 3] + 0.075  # as if the mug had sunk into it
        plane = (*(2 * normal), 2 * height)
        plan = self.plan(support=plane)
        self.assertGreater(plan.rejected["support"], self.plain.rejected.get("support", 0))
        for grasp in plan:
            self.assertGreater((grasp.contacts @ normal).min(), height)
        support = "--support=" + ",".join(map(repr, map(float, plane)))
        self.assert_same(plan, run("plan", "--gripper", "franka", support, SCAN))

    def test_several_views_give_what_they_give_the_program(self):
        scans = []
        for n in range(2):
            path = str(self.folder / f"{n}.ply")
            subprocess.run([PROGRAM, "scene", path, "--family", "tabletop", "--seed", "7"],
                           stdout=subprocess.DEVNULL, check=True)
            scans.append(path)
        (points, viewpoint), *views = map(quadrille.read_cloud, scans)
        found = quadrille.detect(points, viewpoint=viewpoint, views=views)
        plan = quadrille.plan(points, found, "franka", viewpoint=viewpoint, views=views)
        theirs = run("plan", scans[0], "--gripper", "franka", "--view", scans[1])
        self.assertEqual([d.type for d in found], [d["type"] for d in theirs["detections"]])
        self.assertGreater(len(plan), 0)
        self.assert_same(plan, theirs)

    def test_views_are_remembered(self):
        turned = np.eye(4)
        c, s = np.cos(0.5), np.sin(0.5)
        turned[:3, :3] = [[c, 0, s], [0, 1, 0], [-s, 0, c]]
        turned[:3, 3] = (-0.6 * s, 0, 0.6 - 0.6 * c)
        scene = organised_ball(320, 240)
        memory = quadrille.ViewMemory({"views.remember": 10.0})
        np.testing.assert_array_equal(memory.add(1_000_000, scene, np.eye(4)), np.eye(4))
        self.assertEqual((len(memory), memory.others(1_000_000, np.eye(4))), (1, []))
        [(points, viewpoint)] = memory.others(2_000_000, turned)
        self.assertEqual(points.shape, scene.shape)
        np.testing.assert_allclose(viewpoint, np.linalg.inv(turned)[:3, 3], atol=1e-12)
        back = points.reshape(-1, 3) @ turned[:3, :3].T + turned[:3, 3]
        np.testing.assert_allclose(back, scene.reshape(-1, 3), atol=1e-6)
        memory.forget(shifted(0, 0, 0.6), (0.2, 0.2, 0.2))
        [(left, _)] = memory.others(2_000_000, np.eye(4))
        # All that was seen in the box or through it is forgotten. From the eye, the origin, rays
        # enter the box by its side at z = 0.5 alone.
        on_front = scene[..., :2] * (0.5 / scene[..., 2:])
        through = (np.abs(on_front) <= 0.1).all(-1) & (scene[..., 2] >= 0.5)
        clear = (np.abs(np.abs(on_front) - 0.1) > 1e-6).all(-1)  # of the box's edges
        np.testing.assert_array_equal(np.isnan(left).all(-1)[clear], through[clear])
        memory.add(12_000_001, scene, turned)
        self.assertEqual(len(memory), 1)
        with self.assertRaisesRegex(ValueError, "size"):
            memory.forget(np.eye(4))
        memory.forget()
        self.assertEqual(len(memory), 0)
        with self.assertRaisesRegex(ValueError, "views.most"):
            quadrille.ViewMemory({"views.most": 0})


    def test_views_may_have_the_poses_of_their_cameras(self):
        scene, beside = organised_ball(320, 240), shifted(0.1, 0.0, 0.0)
        moved = (scene.reshape(-1, 3) + beside[:3, 3]).reshape(scene.shape)
        by_pose = quadrille.detect(scene, views=[(scene, beside)])
        by_place = quadrille.detect(scene, views=[(moved.astype(np.float32), beside[:3, 3])])
        self.assertEqual([d.score for d in by_pose], [d.score for d in by_place])
        self.assertEqual(len(by_pose.corrections), 1)
        with self.assertRaisesRegex(ValueError, r"views\[0\].*\(4, 4\)"):
            quadrille.detect(scene, views=[(scene, np.eye(3))])
        with self.assertRaisesRegex(ValueError, r"the points of views\[1\] of shape \(240, 2\)"):
            quadrille.detect(scene, views=[(scene, beside), (scene[:, 0, :2], beside)])

    def test_a_camera_pose_gives_the_grasps_of_the_camera_elsewhere(self):
        pose = quadrille.pose((0.5, -0.2, 1.1), (0.0, 0.6, -0.8, 0.0))
        finite = np.isfinite(self.points).all(-1)
        there = np.full(self.points.shape, np.nan)
        there[finite] = self.points[finite].astype(float) @ pose[:3, :3].T + pose[:3, 3]
        found = quadrille.detect(there, camera_pose=pose)
        self.assertEqual([d.type for d in found], [d.type for d in self.found])
        for mine, other in zip(found, self.found):
            np.testing.assert_allclose(mine.X_CQ, pose @ other.X_CQ, atol=1e-4)
        plan = quadrille.plan(there, found, "franka", camera_pose=pose)
        self.assertEqual(len(plan), len(self.plain))
        at = (pose @ np.append(self.at, 1))[:3]
        self.assertLess(min(np.linalg.norm(g.X_CG[:3, 3] - at) for g in plan), 1e-3)
        self.assertEqual(plan.space.states.ndim, 3)
        for ask in (lambda: quadrille.detect(there, camera_pose=pose, viewpoint=(0, 0, 0)),
                    lambda: quadrille.plan(there, found, "franka", camera_pose=pose, viewpoint=pose[:3, 3])):
            with self.assertRaisesRegex(ValueError, "either viewpoint or camera_pose"):
                ask()

    def test_what_is_known_is_planned_on(self):
        grasped = self.found[[d.id for d in self.found].index(self.plain[0].target)]
        known = quadrille.Detection(grasped.type, grasped.X_CQ, grasped.dimensions, extent=grasped.extent,
                                    inside=grasped.inside)
        self.assertEqual((known.id, known.score, known.seen), (0, 1.0, 1.0))
        tables = [d for d in self.found if d.type == "plane"]
        result = quadrille.Result([*tables, known])
        ids = [d.id for d in result]
        self.assertEqual(ids[:-1], [d.id for d in tables])
        self.assertNotIn(ids[-1], ids[:-1])
        plan = quadrille.plan(self.points, result, "franka", viewpoint=self.viewpoint)
        self.assertEqual({g.target for g in plan}, {ids[-1]})
        both = self.found.with_known([known])
        self.assertEqual([d.id for d in both][:-1], [d.id for d in self.found])
        self.assertGreater(both[-1].id, max(d.id for d in [*self.found, *self.found.boxes, *self.found.bodies]))
        self.assertEqual([b.id for b in both.boxes], [b.id for b in self.found.boxes])
        self.assertEqual([b.id for b in both.bodies], [b.id for b in self.found.bodies])
        np.testing.assert_array_equal(both[-1].X_CQ, known.X_CQ)
        box = quadrille.Box(shifted(0, 0, 0.8), (0.08, 0.05, 0.04))
        far = np.full((50, 3), 3.0) + np.arange(50)[:, None] * (0.0, 0.01, 0.0)
        plan = quadrille.plan(far, quadrille.Result(boxes=[box]), "franka", config={"planner.unknown": "free"})
        self.assertEqual({g.target for g in plan}, {1})
        self.assertEqual([(s.kind, s.target) for s in plan.shapes], [("box", 1)])
        np.testing.assert_allclose(plan.shapes[0].pose, box.X_CB)
        def numbered(id):
            return quadrille.Detection("sphere", np.eye(4), {"radius": 1}, id=id)

        for wrong, part in ((lambda: quadrille.Detection("ball", np.eye(4), {}), "sphere"),
                            (lambda: quadrille.Detection("cylinder", np.eye(4), {"radius": 1}), "radius, length"),
                            (lambda: quadrille.Result([grasped, grasped]), r"detections\[1\]: .* twice"),
                            (lambda: quadrille.Result([numbered(-7)]), r"detections\[0\]: .*-7"),
                            (lambda: quadrille.Result([numbered(2**31 - 1)]), "between 1 and")):
            with self.assertRaisesRegex(ValueError, part):
                wrong()

    def test_shapes_space_and_terms_of_a_plan_can_be_read(self):
        plan = self.plain
        self.assertGreater(len(plan.shapes), 0)
        self.assertIsInstance(plan.shapes[0], quadrille.Shape)
        for grasp in self.plan(obstacles=[s for s in plan.shapes if s.target != plan[0].target]):
            self.assertTrue(all(0 <= term <= 1 for term in grasp.terms.values()))
        space = plan.space
        cell = np.floor((plan[0].X_CG[:3, 3] - space.corner) / space.resolution).astype(int)
        self.assertTrue((cell >= 0).all() and (cell < space.states.shape).all())
        self.assertEqual([g.score for g in self.plan(octomap=space.octomap())],
                         [g.score for g in self.plan(octomap=space.octomap().content)])
        self.assertFalse(plan.cut)
        self.assertEqual(repr(plan), f"<Plan: {len(plan.targets)} targets, {len(plan)} grasps, "
                                     f"{sum(plan.rejected.values())} refused>")

    def test_a_map_is_made_of_points(self):
        wall = self.at + 0.002 * np.stack(np.meshgrid(*[np.arange(-15, 16)] * 3), -1).reshape(-1, 3)
        octomap = quadrille.OctoMap.from_voxels(wall, np.zeros((0, 3)), 0.005)
        self.assertEqual(octomap.resolution, 0.005)
        for grasp in self.plan(octomap=octomap):
            self.assertGreater(np.linalg.norm(grasp.X_CG[:3, 3] - self.at), 0.02)
        moved = quadrille.OctoMap.from_voxels(wall + (0, 0, 1), np.zeros((0, 3)), 0.005)
        self.assertEqual(len(self.plan(octomap=moved, X_CM=shifted(0, 0, -1))), len(self.plan(octomap=octomap)))
        with self.assertRaisesRegex(ValueError, "resolution"):
            quadrille.OctoMap.from_voxels(wall, wall, 0.0)
        with self.assertRaisesRegex(ValueError, r"^occupied\[1\] does not lie"):
            quadrille.OctoMap.from_voxels([(0, 0, 0), (np.nan, 0, 0)], wall, 0.01)
        with self.assertRaisesRegex(ValueError, "^X_CM is the pose of a map, and no octomap"):
            self.plan(X_CM=np.eye(4))

    def test_a_region_may_be_turned(self):
        region = (shifted(*self.at), (0.2, 0.2, 0.2))
        self.assertEqual([g.score for g in self.plan(region=region)],
                         [g.score for g in self.plan(roi=(self.at - 0.1, self.at + 0.1))])
        with self.assertRaisesRegex(ValueError, "roi or region"):
            self.plan(region=region, roi=(self.at, self.at))

    def test_what_lasts_is_detected_from_all_views(self):
        scene = organised_ball(320, 240)
        detector = quadrille.LastingDetector({"views.remember": 10.0})
        first = detector.detect(1_000_000, scene, np.eye(4))
        alone = quadrille.detect(scene)
        self.assertEqual([d.score for d in first], [d.score for d in alone])
        np.testing.assert_array_equal(first[0].X_CQ, alone[0].X_CQ)
        self.assertEqual(len(detector), 1)
        ball_alone = [quadrille.Shape("sphere", [0.1], shifted(0, 0, 0.6))]
        self.assertEqual([d.type for d in detector.detect(30_000_000, scene, np.eye(4), robot=ball_alone)], ["plane"])
        detector.forget()
        self.assertEqual(len(detector), 0)

    def test_poses_are_those_of_messages(self):
        for d in self.found:
            q = quadrille.quaternion(d.X_CQ)
            self.assertGreaterEqual(q[0], 0.0)
            np.testing.assert_array_equal(quadrille.pose(d.X_CQ[:3, 3], q), d.X_CQ)
        hand = quadrille.Gripper("franka")
        grasp = self.plain[0]
        back = quadrille.grasp_of_hand(grasp.hand_pose(hand, "gpd"), hand, "gpd", grasp.width)
        np.testing.assert_allclose(back, grasp.X_CG, atol=1e-9)


class Wrong(unittest.TestCase):
    def test_wrong_arguments_are_answered_in_one_line(self):
        p, none, here = ball(), quadrille.Result(), np.eye(4)
        known = quadrille.Detection("sphere", here, {"radius": 0.05})
        for wrong, answer in (
                (lambda: quadrille.detect(p, viewpiont=1), "detect() has no 'viewpiont'; did you mean 'viewpoint'?"),
                (lambda: quadrille.detect(p, viewpoint=(0, 1)),
                 "detect(): viewpoint is of type tuple, and must be an array of shape (3,)"),
                (lambda: quadrille.detect(), "detect() needs 'points'; it takes: points, viewpoint"),
                (lambda: quadrille.detect(object()), "detect(): incompatible points of type object"),
                (lambda: quadrille.plan(p, None, "franka"), "plan(): result is of type NoneType, and must be Result"),
                (lambda: quadrille.plan(p, none, "franka", aproach=(0, 0, 1)), "did you mean 'approach'?"),
                (lambda: quadrille.plan(p, none, "franka", targets=3),
                 "plan(): targets is of type int, and must be List[int]"),
                (lambda: quadrille.plan(p, none, "franka", targets=[1, "two"]),
                 "plan(): targets[1] is of type str, and must be int"),
                (lambda: quadrille.plan(p, none, "franka", octomap=[1]), "plan(): incompatible octomap of type list"),
                (lambda: quadrille.detect(p, views=[(p, here), p]),
                 f"detect(): views[1] is an array of shape {p.shape}, and must be Tuple[array, array]"),
                (lambda: quadrille.detect(p, views=[(p, here, 1)]),
                 "detect(): views[0] is a tuple of 3, and must be Tuple[array, array]"),
                (lambda: quadrille.detect(p, views=[(p, "here")]),
                 "detect(): views[0][1] is of type str, and must be array"),
                (lambda: quadrille.Result([known, known, 3]),
                 "Result(): detections[2] is of type int, and must be Detection"),
                (lambda: quadrille.detect(p, robot=[3]), "Robot(): shapes[0] is of type int, and must be Shape"),
                (lambda: quadrille.Shape("box", 3), "Shape(): dimensions is of type int, and must be List[float]"),
                (lambda: quadrille.Shape(size=3), "Shape() has no 'size'; it takes: kind, dimensions"),
                (lambda: quadrille.OctoMap.from_voxels(1, 2, 3), "from_voxels(): occupied is of type int"),
                (lambda: quadrille.read_cloud(3), "read_cloud(): path is of type int"),
                (lambda: quadrille.Tracker().update(none, "now"), "update(): utime is of type str, and must be int")):
            with self.assertRaises(TypeError) as caught:
                wrong()
            self.assertIn(answer, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))


class SameBits(unittest.TestCase):
    """The command, this library and messages have the same bits."""

    def assert_pose(self, X, theirs):
        np.testing.assert_array_equal(X[:3, 3], theirs["position"])
        np.testing.assert_array_equal(quadrille.quaternion(X), theirs["quaternion"])

    def messages(self):
        """The messages of both processes about the scan, by channel."""
        from quadrille import lcm
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        clouds, found, planned = (str(pathlib.Path(folder.name) / f"{n}.lcm") for n in range(3))
        programs = pathlib.Path(PROGRAM).parent
        for command in ([PROGRAM, "log", clouds, SCAN],
                        [programs / "quadrille-detector", "--in-log", clouds, "--out-log", found, "--copy-input"],
                        [programs / "quadrille-grasp-planner", "--gripper", "franka", "--in-log", found, "--out-log",
                         planned, "--copy-input"]):
            subprocess.run([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                           check=True)
        with lcm.EventLog(planned) as log:
            return {event.channel: event.data for event in log}

    def test_detections_and_grasps(self):
        points, viewpoint = quadrille.read_cloud(SCAN)
        found = quadrille.detect(points, viewpoint=viewpoint)
        plan = quadrille.plan(points, found, "franka", viewpoint=viewpoint)
        theirs = run("plan", "--gripper", "franka", SCAN)
        messages = self.messages()
        sent = quadrille.quadrics_t.decode(messages["QUADRICS"])
        self.assertEqual(len(found), len(theirs["detections"]))
        self.assertEqual(len(found), sent.num_detections)
        for mine, other, message in zip(found, theirs["detections"], sent.detections):
            for field in ("score", "rms", "seen", "inliers"):
                self.assertEqual(getattr(mine, field), other[field])
                self.assertEqual(getattr(mine, field), getattr(message, field))
            self.assertEqual(list(mine.q), other["q"])
            self.assertEqual(list(mine.q), list(message.q))
            self.assertEqual(mine.dimensions, other["dimensions"])
            self.assertEqual(mine.dimensions, {d.name: d.value for d in message.dimensions})
            self.assert_pose(mine.X_CQ, other["pose"])
            np.testing.assert_array_equal(mine.X_CQ, quadrille.pose(message.pose.position, message.pose.quaternion))
        grasps = quadrille.grasps_t.decode(messages["GRASPS"]).grasps
        self.assertGreater(len(plan), 0)
        self.assertEqual(len(plan), len(theirs["grasps"]))
        self.assertEqual(len(plan), len(grasps))
        for mine, other, message in zip(plan, theirs["grasps"], grasps):
            for field in ("target", "score", "width", "preshape", "clearance", "friction_needed", "epsilon"):
                self.assertEqual(getattr(mine, field), other[field])
                self.assertEqual(getattr(mine, field), getattr(message, field))
            self.assertEqual(mine.contacts.tolist(), other["contacts"])
            self.assertEqual(mine.contacts.tolist(), [list(c) for c in message.contacts])
            self.assert_pose(mine.X_CG, other["X_CG"])
            np.testing.assert_array_equal(mine.X_CG, quadrille.pose(message.pose.position, message.pose.quaternion))


class Track(unittest.TestCase):
    def test_a_moving_ball_keeps_its_track(self):
        tracker = quadrille.Tracker()
        tracks = []
        for n in range(4):
            found = quadrille.detect(ball(centre=(0.01 * n, 0.0, 0.6)))
            tracker.update(found, 100000 * n)
            tracks.append(found.detections[0].track)
        self.assertEqual(tracks, [1, 1, 1, 1])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
